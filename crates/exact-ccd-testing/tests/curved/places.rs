//! The places of points that move on curves, from the definition: quotients X / w of polynomials with
//! rational coefficients.
//!
//! Nothing is divided out, and all is in the coordinates of the world.

use dashu_int::IBig;
use dashu_int::ops::BitTest;
use dashu_ratio::RBig;
use exact_ccd::Point;
use exact_ccd::motion::{Chain, RigidMotion};

use exact_ccd_testing::definition::Vector;
use exact_ccd_testing::definition::polynomial::Polynomial;

/// Σ cᵢ tⁱ.
type Rational = Vec<RBig>;

/// The place X / w.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    x: [Rational; 3],
    w: Rational,
}

fn exactly(x: f64) -> RBig {
    RBig::try_from(x).expect("a finite number")
}

fn sum(a: &Rational, b: &Rational) -> Rational {
    let at = |p: &Rational, i: usize| p.get(i).cloned().unwrap_or(RBig::ZERO);
    (0..a.len().max(b.len())).map(|i| at(a, i) + at(b, i)).collect()
}

fn product(a: &Rational, b: &Rational) -> Rational {
    let mut product = vec![RBig::ZERO; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

fn scaled(a: &Rational, factor: i32) -> Rational {
    product(a, &vec![RBig::from(factor)])
}

/// A Bézier curve, by de Casteljau's scheme on polynomials: b ↦ (1 − t) b₀ + t b₁.
fn bezier(control: &[f64]) -> Rational {
    let mut row: Vec<Rational> = control.iter().map(|&x| vec![exactly(x)]).collect();
    let [left, t] = [[1, -1], [0, 1]].map(|c| c.map(RBig::from).to_vec());
    while row.len() > 1 {
        let pairs = row.windows(2);
        row = pairs
            .map(|pair| sum(&product(&left, &pair[0]), &product(&t, &pair[1])))
            .collect();
    }
    row.remove(0)
}

impl Place {
    /// The place on a Bézier curve.
    pub(crate) fn on_curve(control: &[Point]) -> Self {
        let coordinate = |axis: usize| bezier(&control.iter().map(|p| p[axis]).collect::<Vec<_>>());
        Self {
            x: [0, 1, 2].map(coordinate),
            w: vec![RBig::ONE],
        }
    }

    /// The place of a point of a body.
    pub(crate) fn on_body(point: Point, chain: &Chain) -> Self {
        let at_rest = Self::on_curve(&[point]);
        let motions = chain.motions().iter().rev();
        motions.fold(at_rest, |place, motion| place.moved(motion))
    }

    /// o + N X / (|q|² w), where N is |q|² times the matrix of the rotation.
    fn moved(&self, motion: &RigidMotion) -> Self {
        let [start, end] = motion.quaternions();
        let [a, b, c, d] = [0, 1, 2, 3].map(|i: usize| bezier(&[start[i], end[i]]));
        let squares = [&a, &b, &c, &d].map(|x| product(x, x));
        let signed = |signs: [i32; 4]| {
            let terms = squares.iter().zip(signs).map(|(x, sign)| scaled(x, sign));
            terms.fold(vec![], |all, term| sum(&all, &term))
        };
        let twice = |x: &Rational, y: &Rational, z: &Rational, u: &Rational, sign: i32| {
            scaled(&sum(&product(x, y), &scaled(&product(z, u), sign)), 2)
        };
        let matrix = [
            [
                signed([1, 1, -1, -1]),
                twice(&b, &c, &a, &d, -1),
                twice(&b, &d, &a, &c, 1),
            ],
            [
                twice(&b, &c, &a, &d, 1),
                signed([1, -1, 1, -1]),
                twice(&c, &d, &a, &b, -1),
            ],
            [
                twice(&b, &d, &a, &c, -1),
                twice(&c, &d, &a, &b, 1),
                signed([1, -1, -1, 1]),
            ],
        ];
        let w = product(&signed([1; 4]), &self.w);
        let x = [0, 1, 2].map(|axis: usize| {
            let places: Vec<_> = motion.places().iter().map(|place| place[axis]).collect();
            let moved = product(&bezier(&places), &w);
            let row = matrix[axis].iter().zip(&self.x);
            row.fold(moved, |all, (factor, x)| sum(&all, &product(factor, x)))
        });
        Self { x, w }
    }
}

/// The points as integer polynomials, all times one positive function, and the distance times the same
/// function. Each point is multiplied by the weight of one of the other primitive: the weights of the points
/// of a primitive are equal.
pub(crate) fn common(places: &[Place], first: usize, d: f64) -> (Vec<Vector>, Polynomial) {
    let [one, two] = [&places[0].w, &places[first].w];
    let mut all: Vec<Rational> = Vec::new();
    for (i, place) in places.iter().enumerate() {
        let factor = if i < first { two } else { one };
        all.extend(place.x.iter().map(|x| product(x, factor)));
    }
    all.push(scaled_by(&product(one, two), &exactly(d)));
    // All denominators are powers of two: the largest one is a common one.
    let denominators = all.iter().flatten().map(|c| c.denominator().bit_len() - 1);
    let shift = denominators.max().unwrap_or(0);
    let integer = |c: &RBig| c.numerator() << (shift + 1 - c.denominator().bit_len());
    let integers = |p: &Rational| Polynomial::new(p.iter().map(integer).collect::<Vec<IBig>>());
    let mut all: Vec<Polynomial> = all.iter().map(integers).collect();
    let distance = all.pop().expect("it was pushed");
    let points = all
        .chunks_exact(3)
        .map(|c| [c[0].clone(), c[1].clone(), c[2].clone()]);
    (points.collect(), distance)
}

fn scaled_by(a: &Rational, factor: &RBig) -> Rational {
    a.iter().map(|c| c * factor).collect()
}
