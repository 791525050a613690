//! The step of a mesh between two files.

use std::path::Path;

use exact_ccd::{Options, Point, Separation};
use exact_ccd_files::{Format, MeshFile, Polygons};
use exact_ccd_mesh::{
    Bvh, CandidateOptions, Candidates, IntersectionOptions, Meeting, MinDistance, Motion, StepError,
    intersections,
};
use exact_ccd_view::Page;

use crate::error::Error;
use crate::root_finder::{RootFinder, Verdict};

/// A mesh in motion, and the pairs that come near each other.
pub(crate) struct MeshStep {
    title: String,
    /// The contents of the files.
    contents: Vec<String>,
    motion: Motion,
    candidates: Candidates,
}

impl MeshStep {
    /// Reads the files at t = 0 and at t = 1, given by their names and contents.
    pub(crate) fn read(files: [(&str, &[u8]); 2]) -> Result<Self, Error> {
        let [start, end] = files.map(|(name, bytes)| parse(name, bytes));
        let ((start, start_format), (end, end_format)) = (start?, end?);
        let mut contents = [&start, &end].map(|file| file.contents.to_string()).to_vec();
        contents.dedup();
        let join = match (start_format, end_format) {
            (Format::Stl, Format::Stl) => Motion::weld,
            _ => Motion::new,
        };
        let [start_name, end_name] = files.map(|(name, _)| name.to_owned());
        let title = format!("{start_name} to {end_name}");
        let motion = join(start.frame, end.frame).map_err(|source| Error::Motion {
            start: start_name,
            end: end_name,
            source,
        })?;
        Ok(Self {
            title,
            contents,
            motion,
            candidates: Candidates::default(),
        })
    }

    /// The page of all contacts, as a JSON object of its texts.
    pub(crate) fn contacts(&mut self, distance: f64) -> Result<String, Error> {
        let separation = Separation::new(distance)?;
        let options = CandidateOptions::default().with_min_distance(MinDistance::uniform(separation));
        let step = self.motion.step()?;
        self.candidates = Candidates::with_options(step, &Bvh, &options)?;
        let contacts = self.candidates.collisions(step, Options::within(separation));
        let crossing = IntersectionOptions::default().with_meeting(Meeting::Crossing);
        let start = intersections(&self.motion.mesh, &self.motion.x0, &Bvh, &crossing);
        let start = start.map_err(StepError::from)?;
        let touching = if separation.is_zero() {
            "contact".to_owned()
        } else {
            format!("within {distance}")
        };
        let answer = match contacts.first() {
            Some(first) => format!("{touching} at t = {}", first.impact.time.lower()),
            None if separation.is_zero() && start.is_empty() => "free of contact".to_owned(),
            None if separation.is_zero() => {
                "no contact of a vertex and a face, or of two edges, in the step".to_owned()
            }
            None => format!("never {touching}"),
        };
        let at_start = contacts
            .iter()
            .filter(|contact| contact.impact.touching_at_start());
        let mut summary = Vec::new();
        if let count @ 1.. = start.len() {
            summary.push(format!(
                "the mesh passes through itself at t = 0: {count} pairs of an edge and a face"
            ));
        }
        summary.push(answer);
        match at_start.count() {
            0 => {}
            count => summary.push(format!("{count} of the contacts are at t = 0")),
        }
        let pairs = self.candidates.counts().total();
        summary.push(format!("{pairs} pairs were near each other, and decided"));
        summary.extend(self.contents.iter().cloned());
        let page = Page::of_step(&self.title, step, &start, &contacts)?.with_summary(summary);
        // Cannot panic: the keys are strings.
        Ok(serde_json::to_string(&page.blocks()).expect("the page has a text"))
    }

    /// The earliest contact according to a root finder, among the pairs of the last call of
    /// [`contacts`](Self::contacts), as a JSON object.
    pub(crate) fn root_finder(&self, finder: RootFinder) -> Result<String, Error> {
        let time = self
            .candidates
            .time_of_impact_by(self.motion.step()?, finder.method());
        // Cannot panic: the keys are strings.
        Ok(serde_json::to_string(&Verdict::new(time)).expect("the verdict has a text"))
    }

    /// The coordinates of these vertices at t = 0, then at t = 1.
    pub(crate) fn coordinates(&self, vertices: &[u32]) -> Result<Vec<f64>, Error> {
        let Motion { x0, x1, .. } = &self.motion;
        let at = |x: &[Point], vertex: u32| x.get(vertex as usize).copied().ok_or(Error::Vertex(vertex));
        let points = [x0, x1]
            .into_iter()
            .flat_map(|x| vertices.iter().map(move |&vertex| at(x, vertex)))
            .collect::<Result<Vec<Point>, Error>>()?;
        Ok(points.into_flattened())
    }
}

/// A mesh file by its name and contents.
fn parse(name: &str, bytes: &[u8]) -> Result<(MeshFile, Format), Error> {
    let format = Format::of_path(Path::new(name)).ok_or_else(|| Error::Extension(name.to_owned()))?;
    let file = MeshFile::parse(bytes, format, Polygons::Triangulate);
    let file = file.map_err(|source| Error::Parse {
        name: name.to_owned(),
        source,
    })?;
    Ok((file, format))
}

#[cfg(test)]
mod tests {
    use super::MeshStep;
    use crate::root_finder::RootFinder;

    const START: &[u8] = b"v 0 0 0\nv 8 0 0\nv 0 8 0\nv 1 1 1\nf 1 2 3\np 4\n";
    const END: &[u8] = b"v 0 0 0\nv 8 0 0\nv 0 8 0\nv 1 1 -1\nf 1 2 3\np 4\n";

    fn step() -> MeshStep {
        MeshStep::read([("start.obj", START), ("end.obj", END)]).expect("the files are valid")
    }

    #[test]
    fn a_point_falls_through_a_face() {
        let mut step = step();
        let page = step.contacts(0.0).expect("the distance is valid");
        assert!(page.contains("contact at t = 0.5"));
        assert!(page.contains("start.obj to end.obj"));
        let finder = step
            .root_finder(RootFinder::new(0.0).expect("valid"))
            .expect("valid");
        assert!(finder.contains("contact"));
        let page = step.contacts(0.25).expect("the distance is valid");
        assert!(page.contains("within 0.25 at t = 0.375"));
    }

    #[test]
    fn vertices_become_the_points_of_a_query() {
        let coordinates = step().coordinates(&[3, 0]).expect("the mesh has them");
        assert_eq!(
            coordinates,
            [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, -1.0, 0.0, 0.0, 0.0]
        );
        assert_eq!(
            step().coordinates(&[4]).expect_err("there are four").to_string(),
            "the mesh has no vertex 4"
        );
    }

    #[test]
    fn errors_name_the_file() {
        let message = |files| MeshStep::read(files).err().expect("they do not fit").to_string();
        assert!(message([("a.txt", START), ("b.obj", END)]).starts_with("a.txt: not the name"));
        assert!(message([("a.obj", START), ("b.obj", b"v 0 0\n")]).starts_with("b.obj: "));
        let other = b"v 0 0 0\nv 8 0 0\nv 0 8 0\nf 1 2 3\n";
        assert!(message([("a.obj", START), ("b.obj", other)]).starts_with("a.obj and b.obj: 4 vertices"));
    }
}
