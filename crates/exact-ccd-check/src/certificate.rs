//! The bytes of a certificate.
//!
//! The first line, the distance, then the parts of each step: a byte of flags, the times, the tables
//! and the proof of contact that they announce. docs/certificates.md of the repository has all fields.

use dashu_int::IBig;

use crate::bytes::Bytes;
use crate::contact::Proof;
use crate::failure::{Failure, unreadable};
use crate::mesh::Kind;
use crate::motion::Point;
use crate::polynomial::Polynomial;
use crate::separation::Stretch;

/// The first line.
pub const MAGIC: &[u8] = b"exact-ccd certificate 1\n";

/// The flag of the statement that no edge pierces a face at t = 0.
pub const REST: u8 = 1;
/// The flag of the statement that there is no contact on [0, T].
pub const FREE: u8 = 2;
/// The flag of the statement that there is a contact after T and not after T⁺.
pub const CONTACT: u8 = 4;

/// The statements of one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Head {
    /// True if no edge pierces a face at t = 0.
    pub rest: bool,
    /// T, if there is no contact until then.
    pub free: Option<f64>,
    /// T⁺, if there is contact until then.
    pub contact: Option<f64>,
}

impl Head {
    /// Reads the flags and the times.
    ///
    /// # Errors
    /// If a flag is none of the format, or a time is not in [0, 1] or not adjacent to the other.
    pub fn read(bytes: &mut Bytes<'_>) -> Result<Self, Failure> {
        let flags = bytes.byte()?;
        if flags == 0 || flags > REST | FREE | CONTACT {
            return unreadable("a step has no statements, or other flags than 1, 2 and 4");
        }
        let free = if flags & FREE == 0 { None } else { Some(bytes.time()?) };
        let contact = if flags & CONTACT == 0 { None } else { Some(bytes.time()?) };
        // The first f64 that may be T⁺.
        let first = free.map_or(0, |time| time.to_bits() + 1);
        if contact.is_some_and(|time| time.to_bits() != first) {
            return unreadable("the times before and after a contact are not adjacent f64");
        }
        Ok(Self { rest: flags & REST != 0, free, contact })
    }
}

/// The two numbers at the beginning of a row, after the row before it. Pairs are in increasing order.
pub fn row(last: Option<[u32; 2]>, [a, b]: [u32; 2]) -> [u32; 2] {
    match last {
        Some([c, d]) if a == c => [0, b - d - 1],
        _ => [a - last.map_or(0, |[c, _]| c), b],
    }
}

/// Reads the stretches of a pair; the last one ends at T.
///
/// # Errors
/// If the tag of a stretch is none of the format, or the bytes end.
pub fn stretches(bytes: &mut Bytes<'_>, until: f64) -> Result<Vec<Stretch>, Failure> {
    let mut stretches = Vec::new();
    loop {
        let tag = bytes.byte()?;
        if tag >= 64 {
            return unreadable("the tag of a stretch exceeds 63");
        }
        let (is_last, turns, size) = (tag & 1 == 0, tag & 2 != 0, 1 << (tag >> 2));
        let end = if is_last { until } else { bytes.time()? };
        let from = direction(bytes, size)?;
        let to = if turns { direction(bytes, size)? } else { from.clone() };
        stretches.push(Stretch { end, from, to });
        if is_last {
            return Ok(stretches);
        }
    }
}

fn direction(bytes: &mut Bytes<'_>, size: usize) -> Result<Point, Failure> {
    Ok([bytes.integer(size)?, bytes.integer(size)?, bytes.integer(size)?])
}

/// The kind, the indices and the proof of a contact.
///
/// # Errors
/// If a number is none of the format, or the bytes end.
pub fn contact(bytes: &mut Bytes<'_>) -> Result<(Kind, [u32; 2], Proof), Failure> {
    // The last kind is not one of contact.
    let Some(&kind) = Kind::ALL[..4].get(usize::from(bytes.byte()?)) else {
        return unreadable("the kind of a contact is none of 0 to 3");
    };
    let ids = [bytes.number()?, bytes.number()?];
    let proof = match bytes.byte()? {
        0 => Proof::Point(integers(bytes)?),
        1 => {
            let axis = usize::from(bytes.byte()?);
            let factor = Some(integers(bytes)?).filter(|factor| !factor.is_empty());
            Proof::Coplanar { axis, factor: factor.map(Polynomial) }
        }
        2 => Proof::OnEdge { row: bytes.byte()?.into(), factor: Polynomial(integers(bytes)?) },
        _ => return unreadable("the proof of a contact is none of 0 to 2"),
    };
    Ok((kind, ids, proof))
}

/// A list of at most 255 integers, each after the number of its bytes.
fn integers(bytes: &mut Bytes<'_>) -> Result<Vec<IBig>, Failure> {
    let count = bytes.byte()?;
    (0..count)
        .map(|_| {
            let size = bytes.number()?;
            bytes.integer(size as usize)
        })
        .collect()
}
