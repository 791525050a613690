//! The bytes of a certificate, as `exact_ccd_check::certificate` reads them.

use dashu_int::IBig;
use exact_ccd_check::Kind;
use exact_ccd_check::certificate::row;
use exact_ccd_check::contact::Proof;
use exact_ccd_check::separation::Stretch;

/// A number in groups of seven bits.
pub(crate) fn number(bytes: &mut Vec<u8>, mut number: u32) {
    while number >= 128 {
        bytes.push(number as u8 | 128);
        number >>= 7;
    }
    bytes.push(number as u8);
}

/// Writes the indices of a pair, relative to the indices of the pair before.
pub(crate) fn ids(bytes: &mut Vec<u8>, last: Option<[u32; 2]>, ids: [u32; 2]) {
    for part in row(last, ids) {
        number(bytes, part);
    }
}

/// The largest size of a component, as the format has four bits for its logarithm.
const LARGEST: usize = 1 << 15;

/// The stretches of a pair, if their directions have a size of the format.
pub(crate) fn stretches(stretches: &[Stretch]) -> Option<Box<[u8]>> {
    let mut bytes = Vec::new();
    for (number, stretch) in (1..).zip(stretches) {
        let turns = stretch.from != stretch.to;
        let directions = [&stretch.from, &stretch.to]
            .into_iter()
            .take(1 + usize::from(turns));
        let components: Vec<&IBig> = directions.flatten().collect();
        let needed = components
            .iter()
            .map(|component| signed(component).len())
            .max()
            .unwrap_or(1);
        let size = needed.next_power_of_two();
        if size > LARGEST {
            return None;
        }
        let is_last = number == stretches.len();
        bytes.push((size.trailing_zeros() as u8) << 2 | u8::from(turns) << 1 | u8::from(!is_last));
        if !is_last {
            bytes.extend(stretch.end.to_le_bytes());
        }
        for component in components {
            let mut signed = signed(component);
            let sign = if *component < IBig::ZERO { 255 } else { 0 };
            signed.resize(size, sign);
            bytes.extend(signed);
        }
    }
    Some(bytes.into())
}

/// The proof of a contact.
pub(crate) fn contact(bytes: &mut Vec<u8>, kind: Kind, ids: [u32; 2], proof: &Proof) {
    bytes.push(kind as u8);
    number(bytes, ids[0]);
    number(bytes, ids[1]);
    match proof {
        Proof::Point(weights) => {
            bytes.push(0);
            integers(bytes, weights);
        }
        Proof::Coplanar { axis, factor } => {
            bytes.extend([1, *axis as u8]);
            integers(bytes, factor.as_ref().map_or(&[], |factor| &factor.0[..]));
        }
        Proof::OnEdge { row, factor } => {
            bytes.extend([2, *row as u8]);
            integers(bytes, &factor.0);
        }
    }
}

fn integers(bytes: &mut Vec<u8>, integers: &[IBig]) {
    bytes.push(integers.len() as u8);
    for integer in integers {
        let signed = signed(integer);
        number(bytes, signed.len() as u32);
        bytes.extend(signed);
    }
}

/// The two's complement of an integer, with at least one byte.
fn signed(x: &IBig) -> Vec<u8> {
    let bytes = x.to_le_bytes();
    if bytes.is_empty() {
        vec![0]
    } else {
        bytes.into_vec()
    }
}
