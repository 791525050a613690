//! Polynomials in both ends of an interval of time.
//!
//! With s from 0 to 1 over the interval, a polynomial of degree n is the sum of c_i s^i (1 − s)^(n − i).
//! Its coefficients are also the coefficients of an ordinary polynomial in s / (1 − s), which takes the
//! same values up to positive factors inside of the interval. So products, and sums of polynomials of
//! equal degree, are computed as for ordinary polynomials. Coefficients of one strict sign are a proof of
//! that sign for all s in [0, 1].

use dashu_int::IBig;

/// The coefficients c_0 to c_n.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polynomial(pub Vec<IBig>);

/// A vector of polynomials.
pub type Vector = [Polynomial; 3];

impl Polynomial {
    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        let mut product = vec![IBig::ZERO; (self.0.len() + other.0.len()).saturating_sub(1)];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        Self(product)
    }

    /// The difference of two polynomials of one degree.
    pub fn minus(&self, other: &Self) -> Self {
        Self(self.0.iter().zip(&other.0).map(|(a, b)| a - b).collect())
    }

    /// Returns true if all coefficients have this sign, which is 1 or −1, and none is 0.
    pub fn has_sign(&self, sign: i8) -> bool {
        !self.0.is_empty() && self.0.iter().all(|c| *c != IBig::ZERO && (*c < IBig::ZERO) == (sign < 0))
    }

    /// Returns true if the signs at the ends of the interval are different, so that there is a root inside.
    pub fn changes_sign(&self) -> bool {
        self.0.first().zip(self.0.last()).is_some_and(|(a, b)| a * b < IBig::ZERO)
    }

    /// Returns true if this polynomial vanishes at all roots of another one inside of the interval,
    /// because that divides it: the remainder of the division, in which the dividend is multiplied by
    /// the leading coefficient at each step so that all numbers are integers, is 0.
    ///
    /// A divisor whose last coefficient is 0 does not count.
    pub fn is_multiple_of(&self, divisor: &Self) -> bool {
        let Some(leading) = divisor.0.last().filter(|c| **c != IBig::ZERO) else {
            return false;
        };
        let mut rest = self.0.clone();
        while rest.len() >= divisor.0.len() {
            let Some(top) = rest.pop() else { return false };
            let shift = rest.len() + 1 - divisor.0.len();
            for c in &mut rest {
                *c *= leading;
            }
            for (c, factor) in rest[shift..].iter_mut().zip(&divisor.0) {
                *c -= &top * factor;
            }
        }
        rest.iter().all(|c| *c == IBig::ZERO)
    }
}

/// The scalar product.
pub fn dot(a: &Vector, b: &Vector) -> Polynomial {
    let [x, y, z] = [0, 1, 2].map(|axis: usize| a[axis].times(&b[axis]).0);
    Polynomial(x.into_iter().zip(y).zip(z).map(|((x, y), z)| x + y + z).collect())
}

/// The vector product.
pub fn cross(a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i].times(&b[j]).minus(&a[j].times(&b[i])))
}

/// The difference.
pub fn difference(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|axis: usize| a[axis].minus(&b[axis]))
}
