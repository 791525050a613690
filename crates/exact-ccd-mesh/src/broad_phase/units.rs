//! The units in which the coordinates of boxes fit into single precision.

use exact_ccd::Point;

/// Coordinates relative to an origin, one for each time, times a power of two. Both are the same for all
/// boxes that are compared.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units<const T: usize> {
    origins: [Point; T],
    scale: f64,
}

/// Sizes between 2⁻ᴺ and 2ᴺ have their units: single precision has room for far smaller and larger numbers.
const USUAL: i32 = 64;

/// The exponents of the least and of the greatest scale.
///
/// Where subnormal numbers are read as zero, or results are flushed, a coordinate relative to the origin is
/// off by less than 2⁻¹⁰²¹, hence by less than 2⁻¹²⁰ in these units, which `moving_box.rs` allows for. The
/// least one is a normal number.
const SCALES: [i32; 2] = [-1000, 900];

impl<const T: usize> Units<T> {
    /// Coordinates relative to the origins, at their own scale.
    pub(crate) fn relative_to(origins: [Point; T]) -> Self {
        Self { origins, scale: 1.0 }
    }

    /// The same units with a scale for coordinates of this size, which is usual for them: they become about
    /// 1, unless they are so without a scale.
    pub(crate) fn for_size(self, size: f64) -> Self {
        // The exponent of subnormal numbers is −1023 here, and the one of infinity 1024.
        let exponent = (size.to_bits() >> 52) as i32 - 1023;
        let is_usual = size.to_bits() == 0 || exponent.abs() <= USUAL;
        let [least, greatest] = SCALES;
        let power = if is_usual {
            0
        } else {
            (-exponent).clamp(least, greatest)
        };
        // The bits of 2 to this power, which is a normal number.
        let scale = f64::from_bits(((power + 1023) as u64) << 52);
        Self { scale, ..self }
    }

    /// A point in these units. Each coordinate is monotone: a product with a power of two is exact, or
    /// rounded where it is subnormal.
    #[inline(always)]
    pub(crate) fn of(&self, time: usize, [x, y, z]: Point) -> [f64; 4] {
        let ([x0, y0, z0], scale) = (self.origins[time], self.scale);
        [(x - x0) * scale, (y - y0) * scale, (z - z0) * scale, 0.0]
    }
}

#[cfg(test)]
mod tests {
    use super::Units;

    #[test]
    fn sizes_become_about_one_unless_they_are_usual() {
        let one = |size: f64| {
            Units::relative_to([[0.0; 3]])
                .for_size(size)
                .of(0, [size, -size, 0.0])
        };
        for size in [0.0, 1.0, 3e-19, 1e19] {
            assert_eq!(one(size), [size, -size, 0.0, 0.0], "{size}");
        }
        for size in [1e20, 1e38, 1e300, f64::MAX, 1e-20, 1e-38, 1e-270] {
            let [x, y, ..] = one(size);
            assert!((0.5..16_777_216.0).contains(&x) && y == -x, "{size}: {x}");
        }
        // The least scale is for flushed numbers.
        let [least, ..] = one(f64::from_bits(1));
        assert!(least > 0.0 && least < 1e-30, "{least}");
        assert_eq!(one(f64::INFINITY)[0], f64::INFINITY);
    }
}
