//! Query files: no bytes make the readers panic, and the queries of CSV survive a round trip.

#![no_main]

use std::fmt::Debug;

use arbitrary::{Result, Unstructured};
use dashu_ratio::RBig;
use exact_ccd::{AnyKind, Kind, with_kind};
use exact_ccd_data::{CurvedReader, QueryReader, Rounding, Sample};
use exact_ccd_fuzz::file;
use libfuzzer_sys::fuzz_target;

const WORDS: &[&str] = &[
    "\n",
    "\r\n",
    ",",
    ",1,",
    "1,2,",
    "0,1,",
    "-3,4,",
    "1",
    "1\n",
    "0\n",
    "-",
    "+",
    " ",
    "9007199254740993",
    "340282366920938463463374607431768211456,",
    "0,1,0,1,0,1\n",
    "{\"kind\": \"vv\", \"points\": [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], ",
    "{\"kind\": \"vv\", \"points\": [[0, 0, 0], [1, 0, 0]], \"second\": [], \"first\": [",
    "{\"q0\": [1, 0, 0, 0], \"q1\": [1, 0, 0, 1], \"o0\": [0, 0, 0], \"o1\": ",
    "[0, 2, 0]",
    "}",
    "]]]}\n",
    "]}\n",
    "1,1,2,4,3,8,1\n",
    "1,1,2,4,3,8,0\n",
    "1,3,1,3,1,3\n",
    "0,1,0,1,0,1,0\n0,1,0,1,0,1,0\n0,1,0,1,0,1,0\n0,1,0,1,0,1,0\n",
];

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes do not make a file.
    let _ = check(&mut Unstructured::new(bytes));
});

fn check(bytes: &mut Unstructured) -> Result<()> {
    let text = file(bytes, WORDS)?;
    for &kind in AnyKind::ALL {
        with_kind!(kind, K => check_kind::<K>(&text));
    }
    check_curved(&text);
    Ok(())
}

/// A record of curved motion has a query of its kind.
fn check_curved(text: &[u8]) {
    for record in CurvedReader::new("input", text) {
        match record {
            Ok(record) => with_kind!(record.kind(), K => assert!(record.query::<K>().is_some())),
            Err(error) => drop(error.to_string()),
        }
    }
}

fn check_kind<K: Kind + Debug + PartialEq>(text: &[u8]) {
    let exactly = read::<K>(text, Rounding::Refuse);
    let nearly = read::<K>(text, Rounding::ToNearest);
    assert_eq!(
        exactly,
        nearly[..exactly.len()],
        "exact coordinates are not rounded"
    );
    for samples in [exactly, nearly] {
        let written: String = samples.iter().map(rows).collect();
        assert_eq!(read::<K>(written.as_bytes(), Rounding::Refuse), samples);
    }
}

/// The queries before the first error.
fn read<K: Kind>(text: &[u8], rounding: Rounding) -> Vec<Sample<K>> {
    QueryReader::<K, _>::new("input", text, rounding)
        .inspect(|record| drop(record.as_ref().map_err(ToString::to_string)))
        .map_while(std::result::Result::ok)
        .map(|record| record.sample)
        .collect()
}

fn rows<K: Kind>(sample: &Sample<K>) -> String {
    let truth = sample
        .truth
        .map_or(String::new(), |truth| format!(",{}", u8::from(truth)));
    let row = |point: [f64; 3]| {
        let fields = point.map(|x| {
            let ratio = RBig::try_from(x).expect("coordinates are finite");
            format!("{},{}", ratio.numerator(), ratio.denominator())
        });
        fields.join(",") + &truth + "\n"
    };
    let points = sample.query.points().iter().flat_map(AsRef::as_ref);
    points.copied().map(row).collect()
}
