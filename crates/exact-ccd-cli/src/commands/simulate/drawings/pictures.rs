//! Pictures of the time steps, written as these are simulated, and of the whole motion as animations.

use std::io;

use exact_ccd_files::read_frame;
use exact_ccd_mesh::Frame;
use exact_ccd_render::{Animation, Gif, Picture};
use exact_ccd_scene::Rendering;
use exact_ccd_sim::Simulation;

use super::painter::Painter;
use crate::commands::simulate::folder::OutputFolder;
use crate::commands::simulate::folder::layout::{ANIMATION, GIF, PICTURES};
use crate::commands::simulate::folder::steps;
use crate::files::outputs::{make_folder, replace_file, write_file, write_file_soon};
use crate::messages::failure::Failure;
use crate::messages::progress::{self, during};

/// The pictures of a run.
pub(crate) struct Pictures {
    painter: Painter,
    rendering: Rendering,
    /// The time of one time step in the animations, in s.
    time_step: f64,
    /// The time steps up to this one are in the painter's motion.
    last: Option<u64>,
}

impl Pictures {
    /// The pictures in a folder. The picture of its last frame is added.
    pub(crate) fn begin(
        folder: &OutputFolder,
        simulation: &Simulation,
        rendering: Rendering,
    ) -> Result<Self, Failure> {
        make_folder(&folder.file(PICTURES))?;
        let mut pictures = Self {
            painter: Painter::new(simulation, rendering),
            rendering,
            time_step: simulation.settings().time_step / rendering.speed,
            last: None,
        };
        pictures.add(folder)?;
        Ok(pictures)
    }

    /// Adds the frames that have been written to the folder, and draws the last one. All frames so far, or
    /// this one, fill its picture.
    pub(crate) fn add(&mut self, folder: &OutputFolder) -> Result<(), Failure> {
        let frames = folder.frames();
        let new = frames
            .iter()
            .filter(|&&step| self.last.is_none_or(|last| step > last));
        let new: Vec<u64> = new.copied().collect();
        for &step in &new {
            let frame = read_frame(folder.frame(step))?;
            self.painter.include(&frame);
            if frames.last() == Some(&step) {
                let picture = self.paint(folder, frame, step)?;
                let file = picture_file(folder, step);
                write_file_soon(&file, |writer| picture.write_png(writer))?;
            }
        }
        self.last = frames.last().copied();
        Ok(())
    }

    fn paint(&self, folder: &OutputFolder, frame: Frame, step: u64) -> Result<Picture, Failure> {
        let failed = |error| Failure::write(&picture_file(folder, step), io::Error::other(error));
        self.painter.paint(frame, step).map_err(failed)
    }

    /// Draws all frames again, because the whole motion is known only now, and makes the animations.
    pub(crate) fn finish(self, folder: &OutputFolder) -> Result<(), Failure> {
        let frames = folder.frames();
        let count = u32::try_from(frames.len()).unwrap_or(u32::MAX);
        let size = self.rendering.size;
        let [png, gif] = [ANIMATION, GIF].map(|name| folder.file(name));
        let of_png = |source| Failure::write(&png, source);
        let of_gif = |source| Failure::write(&gif, source);
        replace_file(&png, |png_writer| {
            replace_file(&gif, |gif_writer| {
                during(progress::bar(frames.len(), "frames"), |progress| {
                    let mut animation = Animation::new(png_writer, size, count).map_err(of_png)?;
                    let mut smaller = Gif::new(gif_writer, size).map_err(of_gif)?;
                    for (index, &step) in frames.iter().enumerate() {
                        let picture = self.paint(folder, read_frame(folder.frame(step))?, step)?;
                        write_file(&picture_file(folder, step), |writer| picture.write_png(writer))?;
                        let steps = frames
                            .get(index + 1)
                            .map_or_else(|| step - frames[index.saturating_sub(1)], |next| next - step);
                        let seconds = steps as f64 * self.time_step;
                        animation.add(&picture, seconds).map_err(of_png)?;
                        smaller.add(&picture, seconds).map_err(of_gif)?;
                        progress(1);
                    }
                    animation.finish().map_err(of_png)?;
                    smaller.finish().map_err(of_gif)
                })
            })
        })
    }
}

fn picture_file(folder: &OutputFolder, step: u64) -> std::path::PathBuf {
    folder.file(PICTURES).join(steps::name(step, "png"))
}
