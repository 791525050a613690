//! The statements of a certificate, proved or refused.
//!
//! A table has the proofs of one kind of pairs, sorted. The pairs that need a proof are found here, and
//! each must be in the table. If there are more than the certificate has bytes, it is unreadable. So the
//! sizes of the files bound the memory: up to some 400 bytes for a coordinate, because the unit of all
//! numbers is the least exponent of the coordinates and of d. The search also finds pairs of neighbours,
//! which need no proof. So the time is at most the time for all pairs of primitives.

use std::fmt;

use crate::bytes::Bytes;
use crate::certificate::{self, Head, MAGIC};
use crate::contact;
use crate::failure::{Failure, refused, unreadable};
use crate::grid::Grid;
use crate::mesh::{Kind, Mesh};
use crate::motion::Motion;
use crate::ply::Frame;
use crate::separation::{Stretch, is_apart};
use crate::tree;

/// The statements that have been proved, in the order of the steps.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Proved {
    /// The distance d.
    pub distance: f64,
    /// The statements of each step.
    pub steps: Vec<Step>,
}

/// The statements about one step that have been proved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The statements.
    pub head: Head,
    /// The kind and the indices of the contact.
    pub contact: Option<(Kind, [u32; 2])>,
    /// The number of pairs that boxes do not separate.
    pub pairs: usize,
}

/// Checks a certificate about frames of one mesh, in their order.
///
/// # Errors
/// The reason why it is not accepted.
pub fn check(
    certificate: &[u8],
    frames: impl IntoIterator<Item = Result<Frame, Failure>>,
) -> Result<Proved, Failure> {
    let Some(rest) = certificate.strip_prefix(MAGIC) else {
        return unreadable("the first line of the certificate is not `exact-ccd certificate 1`");
    };
    let mut bytes = Bytes(rest);
    let distance = f64::from_le_bytes(bytes.array()?);
    let mut frames = frames.into_iter();
    let mut last = frames.next().unwrap_or_else(|| unreadable("there are no frames"))?;
    let mut steps: Vec<Step> = Vec::new();
    for frame in frames {
        let next = frame?;
        if last.mesh != next.mesh || next.mesh.vertex_count as usize != next.positions.len() {
            return refused(format!("frames {} and {} are not of one mesh", steps.len(), steps.len() + 1));
        }
        if let ([], Some(Step { contact, .. })) = (bytes.0, steps.last()) {
            let (end, last) = (if contact.is_some() { "contact in" } else { "end of" }, steps.len());
            let end = format!("the certificate ends with the {end} step {}, before all frames", last - 1);
            return refused(format!("{end}: leave out those after frame {last}"));
        }
        let step = Motion::new(&last.positions, &next.positions, distance)
            .and_then(|motion| check_step(&mut bytes, &last.mesh, &motion));
        steps.push(step.map_err(|failure| failure.at(format_args!("step {}", steps.len())))?);
        last = next;
    }
    if !bytes.0.is_empty() || steps.is_empty() {
        return refused("the certificate has more steps than these frames, or none");
    }
    Ok(Proved { distance, steps })
}

fn check_step(bytes: &mut Bytes<'_>, mesh: &Mesh, motion: &Motion) -> Result<Step, Failure> {
    let head = Head::read(bytes)?;
    let until = head.free.unwrap_or(0.0);
    let grid = Grid::new(motion, until);
    let at_rest = head.rest.then_some(Kind::EdgeFace);
    let moving = Kind::ALL.into_iter().take(4).filter(|_| head.free.is_some());
    let mut pairs = 0;
    for kind in at_rest.into_iter().chain(moving) {
        pairs += check_table(bytes, (mesh, motion, &grid), kind, until)?;
    }
    let mut contact = None;
    if let Some(time) = head.contact {
        let (kind, ids, proof) = certificate::contact(bytes)?;
        let Some(pair) = mesh.pair(kind, &ids) else {
            return refused(format!("{} are no pair that counts", named(kind, ids)));
        };
        if !contact::is_contact(motion, kind, &pair, [until, time], &proof) {
            return refused(format!("the contact of {} is not proved", named(kind, ids)));
        }
        contact = Some((kind, ids));
    }
    Ok(Step { head, contact, pairs })
}

/// Checks the table of one kind, and returns the number of pairs that boxes do not separate.
fn check_table(
    bytes: &mut Bytes<'_>,
    (mesh, motion, grid): (&Mesh, &Motion, &Grid),
    kind: Kind,
    until: f64,
) -> Result<usize, Failure> {
    // The statement about edges and faces is about t = 0.
    let (until, ends): (_, &[usize]) = if kind == Kind::EdgeFace { (0.0, &[0]) } else { (until, &[0, 1]) };
    let count = bytes.number()? as usize;
    // Every row has at least six bytes.
    if count > bytes.0.len() {
        return unreadable("the certificate ends too early");
    }
    let mut needed = Vec::new();
    tree::pairs(mesh, grid, kind, |ids| {
        needed.push(ids);
        needed.len() <= count
    });
    if needed.len() != count {
        let ([a, b], more) = (kind.names(), if needed.len() > count { "more" } else { "fewer" });
        let numbers = format!("{more} pairs of {a} and {b} need a proof than the {count} of the certificate");
        return refused(format!("{numbers}: are these its meshes, in its order?"));
    }
    needed.sort_unstable();
    let mut last = None;
    for &ids in &needed {
        let has_row = [bytes.number()?, bytes.number()?] == certificate::row(last, ids);
        let Some(pair) = mesh.pair(kind, &ids).filter(|_| has_row) else {
            return refused(format!("there is no proof that {} are apart", named(kind, ids)));
        };
        let stretches = certificate::stretches(bytes, until)?;
        let on_grid =
            |g: &Stretch| stretches.len() == 1 && g.from == g.to && grid.separates(&pair, &g.from, ends);
        if !stretches.first().is_some_and(on_grid) && !is_apart(motion, kind, &pair, &stretches) {
            return refused(format!("{} are not proved to be apart until t = {until:?}", named(kind, ids)));
        }
        last = Some(ids);
    }
    Ok(needed.len())
}

/// The name of a pair.
fn named(kind: Kind, [i, j]: [u32; 2]) -> String {
    let [a, b] = kind.names();
    format!("{a} {i} and {b} {j}")
}

/// One sentence for each statement, each on a line.
impl fmt::Display for Proved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (near, but) = match self.distance {
            0.0 => ("in contact".to_owned(), ""),
            d => (
                format!("within {d:?} of each other"),
                " (a vertex and an edge that an edge connects: in contact)",
            ),
        };
        for (number, Step { head, contact, pairs }) in self.steps.iter().enumerate() {
            let next = number + 1;
            writeln!(f, "step from frame {number} to frame {next} (pairs next to each other: {pairs}):")?;
            if head.rest {
                writeln!(f, "  No edge pierces a face at t = 0.")?;
            }
            if let Some(until) = head.free {
                writeln!(f, "  No two primitives that count are {near}{but} at any time of [0, {until:?}].")?;
            }
            let pair = contact.map(|(kind, ids)| named(kind, ids)).unwrap_or_default();
            match (head.free, head.contact) {
                (_, None) => Ok(()),
                (None, Some(_)) => writeln!(f, "  At t = 0, {pair} are {near}."),
                (Some(t), Some(time)) => {
                    writeln!(f, "  Then {pair} are {near}, at a time after {t:?} and not after {time:?}.")
                }
            }?;
        }
        Ok(())
    }
}
