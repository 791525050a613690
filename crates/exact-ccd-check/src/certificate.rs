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
    /// For flags that are none, and times that are not in [0, 1] or not adjacent.
    pub fn read(bytes: &mut Bytes<'_>) -> Result<Self, Failure> {
        let flags = bytes.byte()?;
        if flags == 0 || flags > REST | FREE | CONTACT {
            return unreadable("a step has no statements, or other flags than 1, 2 and 4");
        }
        let free = if flags & FREE == 0 { None } else { Some(bytes.time()?) };
        let contact = if flags & CONTACT == 0 { None } else { Some(bytes.time()?) };
        let are_adjacent = match (free, contact) {
            (_, None) => true,
            (None, Some(time)) => time == 0.0,
            (Some(free), Some(contact)) => contact.to_bits() == free.to_bits() + 1,
        };
        if !are_adjacent {
            return unreadable("the times before and after a contact are not adjacent f64");
        }
        Ok(Self { rest: flags & REST != 0, free, contact })
    }
}

/// The indices of the next pair of a table, after those of the one before.
///
/// # Errors
/// If the pair is not after the one before, or at the end.
pub fn next_ids(bytes: &mut Bytes<'_>, last: Option<[u32; 2]>) -> Result<[u32; 2], Failure> {
    let (step, second) = (bytes.number()?, bytes.number()?);
    let [a, b] = last.unwrap_or_default();
    let ids = match (step, last) {
        (0, Some(_)) => b.checked_add(1).and_then(|next| next.checked_add(second)).map(|second| [a, second]),
        _ => a.checked_add(step).map(|first| [first, second]),
    };
    ids.map_or_else(|| unreadable("an index exceeds 32 bits"), Ok)
}

/// The stretches of a pair, of which the last ends at T.
///
/// # Errors
/// For other tags than those of the format, and at the end.
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
        let to = if turns { Some(direction(bytes, size)?) } else { None };
        stretches.push(Stretch { end, from, to });
        if is_last {
            return Ok(stretches);
        }
    }
}

/// The direction of a single stretch to T that does not turn, of at most four bytes a component, if the next
/// stretch is such a one, as most are; and the number of its bytes.
#[must_use]
pub fn single(bytes: &Bytes<'_>) -> Option<([i64; 3], usize)> {
    let (&tag, rest) = bytes.0.split_first()?;
    let size = match tag {
        0 => 1,
        4 => 2,
        8 => 4,
        _ => return None,
    };
    let component = |axis: usize| {
        let bytes = rest.get(axis * size..(axis + 1) * size)?;
        let sign = if bytes[size - 1] < 128 { 0 } else { -1 };
        Some(bytes.iter().rev().fold(sign, |value, &byte| value << 8 | i64::from(byte)))
    };
    Some(([component(0)?, component(1)?, component(2)?], 1 + 3 * size))
}

fn direction(bytes: &mut Bytes<'_>, size: usize) -> Result<Point, Failure> {
    Ok([bytes.integer(size)?, bytes.integer(size)?, bytes.integer(size)?])
}

/// The kind, the indices and the proof of a contact.
///
/// # Errors
/// For numbers that are none of the format, and at the end.
pub fn contact(bytes: &mut Bytes<'_>) -> Result<(Kind, [u32; 2], Proof), Failure> {
    // The last kind is not one of contact.
    let kind = Kind::ALL[..4].get(usize::from(bytes.byte()?)).copied();
    let Some(kind) = kind else {
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
