//! A page, read back.

use std::io::Read;

use base64::prelude::{BASE64_STANDARD, Engine};
use exact_ccd_view::Page;
use flate2::read::DeflateDecoder;
use serde_json::Value;

/// The HTML file of a page.
pub(crate) struct Html(pub(crate) String);

impl Html {
    pub(crate) fn of(page: &Page) -> Self {
        let mut file = Vec::new();
        page.write(&mut file).unwrap();
        Self(String::from_utf8(file).unwrap())
    }

    /// The text of the element with this id.
    pub(crate) fn element(&self, id: &str) -> &str {
        let start = self.0.split_once(&format!(" id=\"{id}\">")).unwrap().1;
        start.split_once("</script>").unwrap().0
    }

    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(self.element("page")).unwrap()
    }

    /// The words of a block.
    pub(crate) fn words(&self, id: &str) -> Vec<u32> {
        let deflated = BASE64_STANDARD.decode(self.element(id)).unwrap();
        let mut bytes = Vec::new();
        DeflateDecoder::new(deflated.as_slice())
            .read_to_end(&mut bytes)
            .unwrap();
        let count = bytes.len() / 4;
        let word = |i: usize| u32::from_le_bytes([0, 1, 2, 3].map(|plane| bytes[plane * count + i]));
        (0..count).map(word).collect()
    }

    /// The positions in a frame, in units of the world.
    pub(crate) fn positions(&self, frame: usize) -> Vec<[f64; 3]> {
        let floats = |frame: usize| {
            self.words(&format!("frame-{frame}"))
                .into_iter()
                .map(f32::from_bits)
        };
        let mut all: Vec<f32> = floats(0).collect();
        if frame > 0 {
            all.iter_mut()
                .zip(floats(frame))
                .for_each(|(x, moved)| *x += moved);
        }
        let json = self.json();
        let scale = json["scale"].as_f64().unwrap();
        let center = [0, 1, 2].map(|axis: usize| json["center"][axis].as_f64().unwrap());
        let place = |x: &[f32]| [0, 1, 2].map(|axis: usize| center[axis] + scale * f64::from(x[axis]));
        all.chunks(3).map(place).collect()
    }
}
