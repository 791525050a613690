//! Bernstein sign classification in exact arithmetic.

use std::cmp::Ordering::{Equal, Greater, Less};

use exact_ccd::{Decide, Query};

use super::configuration::{Configuration, Configured, Polynomials};
use super::curve::{Curve, Roots};
use super::inside::is_inside;
use super::number::{Signed, signs};
use crate::integers::to_integers;
use crate::interval::Enclosure;

/// Bernstein sign classification ("BSC") of M. Tang, R. Tong, Z. Wang and D. Manocha.
///
/// *Fast and Exact Continuous Collision Detection with Bernstein Sign Classification*, ACM
/// Transactions on Graphics 33(6), 2014; details that the paper leaves open follow the authors'
/// program bsc.cpp, as used for the comparison of B. Wang, Z. Ferguson, T. Schneider, X. Jiang, M.
/// Attene and D. Panozzo, *A Large-Scale Benchmark and an Inclusion-Based Algorithm for Continuous
/// Collision Detection*, ACM Transactions on Graphics 40(5), 2021.
///
/// The four points are coplanar at the roots of a cubic, and the primitives meet at a root unless one of
/// three quartics is negative there. The roots are counted from the signs of the Bernstein coefficients
/// and of the extremum. A quartic and its remainder of degree two, found by polynomial division, have the
/// same sign at a root. Signs come from intervals, and from integers where intervals leave them open. The
/// method has no times.
///
/// # When it fails
/// - It fails on a cubic with an inflection point within the step, unless the only Bernstein coefficient
///   of its sign is the first or the last. The paper cuts the cubic there, but the authors' program never
///   computes the place of the cut, and does not terminate: such a query counts as a contact here, as
///   every query on which a method fails does in the comparison. Among the 5,171 queries of a twisted rod,
///   190 are of this kind, and 6 of these 190 do not touch. Among vertices and faces that move at random,
///   40 % of the queries that do not touch are reported.
/// - Every contact of primitives that are coplanar for the whole step is a false negative, because
///   no sign changes: 3 of 192 and 8 of 145 of the handcrafted contacts, 13 of 107 edge-edge contacts of a
///   cloth that slides through a funnel.
/// - A quartic that is zero at a root, or has no known sign there, does not rule out contact: two
///   edges are reported if a vertex of one reaches the line of the other at the time at which they
///   are coplanar, at any distance (20 of 156 on that cloth, whose edges lie in the rows of a grid).
///   So are some primitives that are coplanar at t = 0.
/// - The bound of the culling stage is absolute: the rounding errors of the cubic exceed it from
///   lengths of about 10 on, so that false negatives are possible there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BernsteinSignClassification {
    /// A query is free of contact if all four coefficients of the cubic, in floating-point
    /// arithmetic, lie on one side of zero by more than this, in cubes of the units of the input.
    pub culling_bound: f64,
}

impl Default for BernsteinSignClassification {
    fn default() -> Self {
        Self {
            culling_bound: 100.0 * f64::EPSILON,
        }
    }
}

/// True for contact; `None` if the arithmetic leaves a sign open.
fn decide<N: Signed>(polynomials: &Polynomials<N>) -> Option<bool> {
    let curve = Curve::new(polynomials.coplanarity())?;
    if curve.is_one_sided() {
        return Some(false);
    }
    let roots = match curve.lone_root() {
        Some(root) => root,
        None => match signs(curve.bends().each_ref())? {
            [Less, Greater] | [Greater, Less] => return Some(true),
            [Equal, bend] | [bend, _] => curve.roots(bend)?,
        },
    };
    match roots {
        Roots::Anywhere => Some(false),
        _ => is_inside(&curve, roots, polynomials.insides()),
    }
}

impl BernsteinSignClassification {
    fn culls(&self, configuration: &Configuration) -> bool {
        let [k0, k1, k2, k3] = Polynomials::<f64>::from_coordinates(configuration).coplanarity();
        let k = [k0 / 3.0, k1, k2, k3 / 3.0];
        k.iter().all(|k| *k > self.culling_bound) || k.iter().all(|k| *k < -self.culling_bound)
    }
}

impl<K: Configured> Decide<K> for BernsteinSignClassification {
    fn collides(&self, query: &Query<K>) -> bool {
        let configuration = Configuration::new(query);
        if self.culls(&configuration) {
            return false;
        }
        let exactly = || Polynomials::new(to_integers(&configuration.points), &configuration);
        decide(&Polynomials::<Enclosure>::from_coordinates(&configuration))
            .or_else(|| decide(&exactly()))
            .unwrap_or(true)
    }
}

#[cfg(test)]
mod tests {
    use exact_ccd::{EdgeEdge, VertexFace};
    use proptest::array::{uniform3, uniform4};
    use proptest::prelude::*;

    use super::*;

    /// Returns true if the cubic has an inflection point that matters according to its control polygon.
    fn is_given_up(configuration: &Configuration) -> bool {
        let polynomials = Polynomials::new(to_integers(&configuration.points), configuration);
        let curve = Curve::new(polynomials.coplanarity()).unwrap();
        let [a, b] = signs(curve.bends().each_ref()).unwrap();
        !curve.is_one_sided() && curve.lone_root().is_none() && a == b.reverse() && a != Equal
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10_000))]

        /// No sign is zero for coordinates at random.
        #[test]
        fn all_is_right_but_inflection_points(
            start in uniform4(uniform3(-1.0..1.0)),
            end in uniform4(uniform3(-1.0..1.0)),
        ) {
            let method = BernsteinSignClassification::default();
            let query = Query::<VertexFace>::new(start, end).unwrap();
            prop_assert_eq!(
                method.collides(&query),
                is_given_up(&Configuration::new(&query)) || query.collides(exact_ccd::CONTACT)
            );
            let query = Query::<EdgeEdge>::new(start, end).unwrap();
            prop_assert_eq!(
                method.collides(&query),
                is_given_up(&Configuration::new(&query)) || query.collides(exact_ccd::CONTACT)
            );
        }

        /// The integers confirm each decision of the filter.
        #[test]
        fn intervals_agree_with_integers(
            start in uniform4(uniform3(-2..=2i8)),
            end in uniform4(uniform3(-2..=2i8)),
        ) {
            let [start, end] = [start, end].map(|points| points.map(|point| point.map(f64::from)));
            let configuration = Configuration::new(&Query::<EdgeEdge>::new(start, end).unwrap());
            let filtered = decide(&Polynomials::<Enclosure>::from_coordinates(&configuration));
            let exact = decide(&Polynomials::new(to_integers(&configuration.points), &configuration));
            prop_assert!(filtered.is_none() || filtered == exact);
        }
    }
}
