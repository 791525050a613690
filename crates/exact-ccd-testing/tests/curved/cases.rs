//! Queries, with the places of their points.

use exact_ccd::motion::{Bezier, Chain, CurvedQuery};
use exact_ccd::{Kind, Point};

use crate::places::Place;

/// A query, and the places of its points by the definition.
pub(crate) struct Case<K: Kind> {
    pub(crate) query: CurvedQuery<K>,
    pub(crate) places: Vec<Place>,
}

impl<K: Kind> Case<K> {
    pub(crate) fn of_curves(control: &[K::Points]) -> Self {
        let count = K::Points::default().as_ref().len();
        let curve = |point: usize| -> Vec<Point> { control.iter().map(|set| set.as_ref()[point]).collect() };
        Self {
            query: Bezier::new(control).expect("finite points").into(),
            places: (0..count).map(|point| Place::on_curve(&curve(point))).collect(),
        }
    }

    pub(crate) fn of_bodies(points: K::Points, first: &Chain, second: &Chain) -> Self {
        let place =
            |(i, point): (usize, &Point)| Place::on_body(*point, if i < K::FIRST { first } else { second });
        Self {
            places: points.as_ref().iter().enumerate().map(place).collect(),
            query: CurvedQuery::of_bodies(points, first.clone(), second.clone()).expect("finite points"),
        }
    }
}
