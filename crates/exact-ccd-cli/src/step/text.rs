//! The output of `exact-ccd step` as text on a terminal.

use std::fmt;

use super::report::{Answer, Counted, Counts, Output, Report, Start};
use crate::half_spaces::HalfSpaceCounts;
use crate::shortest::shortest;

impl Output {
    /// The line of the text that has the answer: the intersection at the start, or else the contact.
    pub(super) fn verdict(&self) -> String {
        let start = self.start.as_ref().map(ToString::to_string).unwrap_or_default();
        let line = match &self.answer {
            _ if !start.is_empty() => start,
            Answer::Report(report) if report.contact.is_some() => report.to_string(),
            answer if answer.is_free() => "free of contact".to_owned(),
            _ => "contact".to_owned(),
        };
        line.lines().next().unwrap_or_default().to_owned()
    }
}

impl fmt::Display for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.summary.fmt(f)?;
        if !self.distances.are_zero() {
            writeln!(f, "{}", self.distances)?;
        }
        let intersects = self.start.as_ref().is_some_and(|start| start.intersections > 0);
        if let Some(start) = &self.start {
            start.fmt(f)?;
        }
        let free = if intersects {
            "no contact of a vertex and a face, or of two edges, in the step"
        } else {
            "free of contact"
        };
        match &self.answer {
            Answer::Free { is_free } => writeln!(f, "{}", if *is_free { free } else { "contact" })?,
            Answer::Report(report) => {
                if report.contact.is_none() {
                    writeln!(f, "{free}")?;
                }
                report.fmt(f)?;
            }
        }
        if let Some(counts) = &self.half_spaces {
            let HalfSpaceCounts {
                colliding,
                touching_at_start,
            } = counts;
            writeln!(
                f,
                "half spaces: {colliding} vertices in contact, {touching_at_start} touching at t = 0"
            )?;
        }
        self.seconds.fmt(f)
    }
}

/// The first intersection and its place, if there is one.
impl fmt::Display for Start {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(first) = &self.first else { return Ok(()) };
        write!(f, "the mesh passes through itself at t = 0: {first}")?;
        match self.intersections {
            1 => writeln!(f)?,
            count => writeln!(f, ", the first of {count} pairs")?,
        }
        f.write_str(&first.place())
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(contact) = &self.contact {
            let toi = shortest(contact.toi());
            writeln!(f, "contact at t = {toi}: {contact}")?;
            f.write_str(&contact.place())?;
        }
        if let Some(Counted {
            candidates,
            touching_at_start,
            ..
        }) = &self.counts
        {
            writeln!(f, "candidates: {candidates}")?;
            writeln!(f, "touching at t = 0: {touching_at_start} pairs")?;
        }
        Ok(())
    }
}

impl fmt::Display for Counts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} vertex-face pairs, {} edge-edge pairs", self.vf, self.ee)?;
        // A mesh of faces alone has none of these.
        if self.ve + self.vv > 0 {
            write!(
                f,
                ", {} vertex-edge pairs, {} vertex-vertex pairs",
                self.ve, self.vv
            )?;
        }
        Ok(())
    }
}
