//! The cubic Y: its shape, its roots, and the sign of a linear polynomial at them.

use std::cmp::Ordering;
use std::cmp::Ordering::Equal;

use super::number::{Number, Signed, signs};

/// A cubic over [0, 1] in Bernstein form.
pub(super) struct Curve<N> {
    coefficients: [N; 4],
    signs: [Ordering; 4],
}

/// The roots of a cubic without inflection point in (0, 1).
#[derive(Clone, Copy)]
pub(super) enum Roots {
    None,
    /// One root, and the sign before it; the sign behind it is the opposite.
    One {
        before: Ordering,
    },
    /// Two roots, which may coincide, and the sign outside of them, which the second derivative has.
    Two {
        outside: Ordering,
    },
    /// Unknown: the cubic is zero up to the error bounds.
    Anywhere,
}

impl<N: Signed> Curve<N> {
    pub(super) fn new(coefficients: [N; 4]) -> Option<Self> {
        let signs = signs(coefficients.each_ref())?;
        Some(Self { coefficients, signs })
    }

    pub(super) fn coefficients(&self) -> &[N; 4] {
        &self.coefficients
    }

    /// Returns true if all coefficients have the same strict sign, so that there is no root.
    pub(super) fn is_one_sided(&self) -> bool {
        let first = self.signs[0];
        first != Equal && self.signs == [first; 4]
    }

    /// The only root, if the first or the last coefficient alone has a sign of its own.
    pub(super) fn lone_root(&self) -> Option<Roots> {
        let [first, a, b, last] = self.signs;
        let is_lone = first != Equal && first == last.reverse() && a == b && a != Equal;
        is_lone.then_some(Roots::One { before: first })
    }

    /// The second derivative at both ends, up to a positive factor.
    pub(super) fn bends(&self) -> [N; 2] {
        let [k0, k1, k2, k3] = self.coefficients.clone();
        [k0 - k1.clone().times(2) + k2.clone(), k1 - k2.times(2) + k3]
    }

    /// A third of the derivative.
    fn slope(&self) -> [N; 3] {
        let [k0, k1, k2, k3] = &self.coefficients;
        [
            k1.clone() - k0.clone(),
            k2.clone() - k1.clone(),
            k3.clone() - k2.clone(),
        ]
    }

    /// The roots, if the second derivative has this sign in all of (0, 1).
    pub(super) fn roots(&self, bend: Ordering) -> Option<Roots> {
        let [start, _, _, end] = self.signs;
        let slope = self.slope();
        let [first, last] = signs([&slope[0], &slope[2]])?;
        let is_monotone = bend == Equal || (first == last && first != Equal);
        let side = match (start, end) {
            (Equal, Equal) if is_monotone => return Some(Roots::Anywhere),
            (Equal, Equal) => bend,
            (Equal, sign) | (sign, Equal) => sign,
            (start, end) if start != end => return Some(Roots::One { before: start }),
            (sign, _) => sign,
        };
        // A curve that bends away from the axis keeps the side of its ends.
        let turns_back = !is_monotone
            && side == bend
            && ((start, end) == (Equal, Equal) || self.extremum(&slope, bend)? != side);
        Some(match (start, end) {
            _ if turns_back => Roots::Two { outside: bend },
            (Equal, _) => Roots::One {
                before: side.reverse(),
            },
            (_, Equal) => Roots::One { before: side },
            _ => Roots::None,
        })
    }

    /// The sign at the root of the derivative, which changes its sign from −bend to bend.
    fn extremum(&self, slope: &[N; 3], bend: Ordering) -> Option<Ordering> {
        let [s0, _, s2] = slope;
        let Some([_, remainder]) = divide(&self.coefficients, slope) else {
            let sign = self.at([s0, s2])?;
            return Some(if bend == Ordering::Greater {
                sign.reverse()
            } else {
                sign
            });
        };
        let [at_start, at_end] = signs(remainder.each_ref())?;
        if at_start == at_end {
            return Some(at_start);
        }
        // The derivative has the sign of the bend behind its own root.
        let [r0, r1] = remainder;
        let sign = quadratic_at(slope, [&r0, &r1]).sign()?;
        Some(match sign {
            Equal => Equal,
            _ if sign == bend => at_start,
            _ => at_end,
        })
    }

    /// The sign at the root of the linear polynomial with the values t and s at 0 and 1, times sign(t − s).
    fn at(&self, [t, s]: [&N; 2]) -> Option<Ordering> {
        let [k0, k1, k2, k3] = self.coefficients.clone();
        let [t, s] = [t.clone(), -s.clone()];
        let [tt, ss] = [t.clone() * t.clone(), s.clone() * s.clone()];
        let value = k0 * ss.clone() * s.clone()
            + k1.times(3) * ss * t.clone()
            + k2.times(3) * s * tt.clone()
            + k3 * tt * t;
        value.sign()
    }

    /// The signs of a linear polynomial at the roots, `Equal` also where they are open.
    ///
    /// The root of the linear polynomial lies before, between or behind the roots of the cubic: the signs
    /// of the cubic and of its derivative at this root tell which. If the sign at one end is open, the
    /// root may lie outside of [0, 1]: then the other end has the sign at all roots, and no other is
    /// returned.
    fn signs_at(&self, roots: Roots, linear: &[N; 2]) -> Option<[Ordering; 2]> {
        let [t0, t1] = linear;
        let [start, end] = signs([t0, t1])?;
        if start == end {
            return Some([start; 2]);
        }
        let sign = match (t0.clone() - t1.clone()).sign()? {
            Ordering::Greater => self.at([t0, t1])?,
            Ordering::Less => self.at([t0, t1])?.reverse(),
            Equal => return Some([Equal; 2]),
        };
        Some(match roots {
            Roots::One { before } => match sign {
                Equal => [Equal; 2],
                _ if sign == before => [end; 2],
                _ => [start; 2],
            },
            Roots::Two { outside } if sign == outside.reverse() => [start, end],
            Roots::Two { outside } => {
                let slope = quadratic_at(&self.slope(), [t0, t1]).sign()?;
                let touches = sign == Equal;
                match slope {
                    Equal => [Equal; 2],
                    _ if slope == outside => [start, if touches { Equal } else { start }],
                    _ => [if touches { Equal } else { end }, end],
                }
            }
            Roots::None | Roots::Anywhere => [Equal; 2],
        })
    }

    /// The signs of a quadratic polynomial at the roots, `Equal` also where they are open.
    ///
    /// With linear M and T, Y = M J + T: at a root, M J and T are opposite.
    pub(super) fn signs_of_quadratic(&self, roots: Roots, quadratic: &[N; 3]) -> Option<[Ordering; 2]> {
        let [start, middle, end] = signs(quadratic.each_ref())?;
        if start == middle && middle == end {
            return Some([start; 2]);
        }
        let Some([factor, remainder]) = divide(&self.coefficients, quadratic) else {
            let [j0, _, j2] = quadratic.clone();
            return self.signs_at(roots, &[j0, j2]);
        };
        let m = self.signs_at(roots, &factor)?;
        let t = self.signs_at(roots, &remainder)?;
        Some([0, 1].map(|i| match m[i] {
            Ordering::Greater => t[i].reverse(),
            Ordering::Less => t[i],
            Equal => Equal,
        }))
    }
}

/// Linear M and T with (j₀ − 2j₁ + j₂)² Y = M J + T, unless J is linear for certain.
fn divide<N: Signed>([k0, k1, k2, k3]: &[N; 4], [j0, j1, j2]: &[N; 3]) -> Option<[[N; 2]; 2]> {
    let bend = j0.clone() - j1.clone().times(2) + j2.clone();
    if bend == N::default() {
        return None;
    }
    // M J + T has the inner coefficients of Y if (rise, −drop; drop, fall) (m₀, m₁) = (c, d).
    let rise = (j1.clone() - j0.clone()).times(2);
    let fall = (j1.clone() - j2.clone()).times(2);
    let drop = j2.clone() - j0.clone();
    let c = k1.clone().times(3) - k0.clone().times(2) - k3.clone();
    let d = k2.clone().times(3) - k3.clone().times(2) - k0.clone();
    let m0 = fall * c.clone() + drop.clone() * d.clone();
    let m1 = rise * d - drop * c;
    let scale = bend.clone() * bend;
    let t0 = k0.clone() * scale.clone() - m0.clone() * j0.clone();
    let t1 = k3.clone() * scale - m1.clone() * j2.clone();
    Some([[m0, m1], [t0, t1]])
}

/// The value of a quadratic polynomial at the root of the linear one with the values t and s at 0
/// and 1, up to a positive factor.
fn quadratic_at<N: Number>([j0, j1, j2]: &[N; 3], [t, s]: [&N; 2]) -> N {
    let [t, s] = [t.clone(), -s.clone()];
    j0.clone() * (s.clone() * s.clone())
        + (j1.clone().times(2) * s) * t.clone()
        + j2.clone() * (t.clone() * t)
}
