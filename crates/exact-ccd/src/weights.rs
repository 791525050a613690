//! The closest points of an impact as weighted points of the query.

use crate::kind::Kind;
use crate::values::Impact;

impl Impact {
    /// The weights of the points of the query in the vector from the closest point of the second primitive to
    /// that of the first: as many as it has points, then zeros.
    #[must_use]
    pub fn weights<K: Kind>(&self) -> [f64; 4] {
        let [u, v] = self.parameters;
        let mut weights = [0.0; 4];
        let (first, second) = weights[..K::Points::default().as_ref().len()].split_at_mut(K::FIRST);
        for (primitive, place, sign) in [(first, u, 1.0), (second, v, -1.0)] {
            match primitive {
                [a] => *a = sign,
                [a, b] => (*a, *b) = (sign * (1.0 - place), sign * place),
                [a, b, c] => (*a, *b, *c) = (sign * (1.0 - u - v), sign * u, sign * v),
                _ => {}
            }
        }
        weights
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::{EdgeEdge, VertexEdge, VertexFace, VertexVertex};
    use crate::values::ContactTime;

    #[test]
    fn weights_are_those_of_the_difference_between_the_closest_points() {
        let impact = Impact {
            time: ContactTime::exactly(0.5),
            parameters: [0.25, 0.125],
            normal: None,
        };
        assert_eq!(impact.weights::<VertexFace>(), [1.0, -0.625, -0.25, -0.125]);
        assert_eq!(impact.weights::<EdgeEdge>(), [0.75, 0.25, -0.875, -0.125]);
        assert_eq!(impact.weights::<VertexEdge>(), [1.0, -0.875, -0.125, 0.0]);
        assert_eq!(impact.weights::<VertexVertex>(), [1.0, -1.0, 0.0, 0.0]);
    }
}
