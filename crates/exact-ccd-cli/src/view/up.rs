//! The direction upwards on a page, on the command line.

use std::str::FromStr;

use exact_ccd_mesh::Point;

use crate::shortest::numbers;

/// A direction: an axis, with or without a sign, or three numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Up(pub(super) Point);

impl FromStr for Up {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (sign, axis) = match text.strip_prefix('-') {
            Some(axis) => (-1.0, axis),
            None => (1.0, text),
        };
        match axis {
            "x" => return Ok(Self([sign, 0.0, 0.0])),
            "y" => return Ok(Self([0.0, sign, 0.0])),
            "z" => return Ok(Self([0.0, 0.0, sign])),
            _ => {}
        }
        let up = numbers(text).filter(|up: &Point| up.iter().all(|x| x.is_finite()) && *up != [0.0; 3]);
        up.map(Self).ok_or_else(|| {
            "expected x, y, z, -x, -y, -z, or three numbers, finite and not all zero".to_owned()
        })
    }
}
