//! Families of queries that are as costly as possible for exact arithmetic, drawn with fixed seeds.
//!
//! Also a module of the benchmark `worst_cases` of `exact-ccd-bench`.

use exact_ccd::{EdgeEdge, Kind, Point, VertexFace};

/// The four points of a query at t = 0 and at t = 1.
pub(crate) type Points = [[Point; 4]; 2];

/// A kind of query, as the linear combination of its four points that vanishes in contact.
pub(crate) trait Primitives: Kind<Points = [Point; 4]> + 'static {
    /// The ends of e₁ and e₂, by index: their cross product is the normal.
    const SPANNING: [[usize; 2]; 2];
    /// The factors of the four points in F(·, u, v).
    fn weights(u: f64, v: f64) -> [f64; 4];
}

impl Primitives for VertexFace {
    const SPANNING: [[usize; 2]; 2] = [[1, 2], [1, 3]];

    fn weights(u: f64, v: f64) -> [f64; 4] {
        [1.0, u + v - 1.0, -u, -v]
    }
}

impl Primitives for EdgeEdge {
    const SPANNING: [[usize; 2]; 2] = [[0, 1], [2, 3]];

    fn weights(u: f64, v: f64) -> [f64; 4] {
        [1.0 - u, u, v - 1.0, -v]
    }
}

/// A generator of queries of one family.
pub(crate) type Family = fn(&mut Random) -> Points;

/// The families of a kind of query, by name.
pub(crate) fn families<K: Primitives>() -> [(&'static str, Family); 19] {
    [
        ("an exponent for each coordinate", any_exponent),
        ("an exponent for each point and end", exponent_per_point),
        (
            "an exponent for each axis, near-double root",
            stretched_graze::<K>,
        ),
        ("the least and the largest numbers", ends_of_the_range),
        ("small integers, two extreme coordinates", two_extremes),
        ("a few special values", few_values),
        ("any exponents, shared vertex", shared_vertex::<K>),
        ("any exponents, resting primitive", resting_primitive::<K>),
        ("any exponents, contact at t = 1", touching_at_end::<K>),
        ("double root, split by the least number", split_graze::<K>),
        ("near-double root", near_graze::<K>),
        ("nearly parallel", nearly_parallel::<K>),
        ("nearly parallel, any exponents", nearly_parallel_any::<K>),
        ("coplanar across an axis, any exponents", flat_any),
        ("coplanar at a slant, any exponents", slanted_any),
        ("collinear, any exponents", collinear_any),
        ("all points equal", all_equal),
        ("all points equal at each end", equal_at_each_end),
        ("subnormal", subnormal),
    ]
}

/// Vigna's SplitMix64.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.bits() % bound as u64) as usize
    }

    /// A number in [−1, 1].
    fn fraction(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / 2f64.powi(52) - 1.0
    }

    /// An integer of magnitude at most `radius`.
    pub(crate) fn integer(&mut self, radius: usize) -> f64 {
        self.below(2 * radius + 1) as f64 - radius as f64
    }

    /// A finite number with any sign, exponent and fraction.
    fn any(&mut self) -> f64 {
        loop {
            let x = f64::from_bits(self.bits());
            if x.is_finite() {
                return x;
            }
        }
    }

    /// One of the least and the largest numbers.
    fn extreme(&mut self) -> f64 {
        let magnitudes = [
            5e-324,
            1.5e-323,
            f64::MIN_POSITIVE,
            f64::MAX / 4.0,
            1e308,
            f64::MAX,
        ];
        let magnitude = magnitudes[self.below(magnitudes.len())];
        if self.below(2) == 0 { magnitude } else { -magnitude }
    }

    pub(crate) fn points(&mut self, mut coordinate: impl FnMut(&mut Self) -> f64) -> Points {
        let mut points = Points::default();
        for x in points.as_flattened_mut().as_flattened_mut() {
            *x = coordinate(self);
        }
        points
    }

    fn fractions(&mut self) -> Points {
        self.points(Self::fraction)
    }

    fn small_integers(&mut self) -> Points {
        self.points(|random| random.integer(4))
    }

    /// (t, u, v), in quarters.
    fn place(&mut self) -> [f64; 3] {
        let t = self.below(5) as f64 / 4.0;
        let u = self.below(5);
        [t, u as f64 / 4.0, self.below(5 - u) as f64 / 4.0]
    }
}

/// x 2ᵏ, rounded if it is subnormal.
fn scaled(x: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    x * 2f64.powi(half) * 2f64.powi(exponent - half)
}

/// Σ wᵢ xᵢ.
fn combine<const N: usize>(weights: [f64; N], points: [Point; N]) -> Point {
    [0, 1, 2].map(|axis: usize| (0..N).map(|i| weights[i] * points[i][axis]).sum())
}

/// The points at time t.
fn at(points: &Points, t: f64) -> [Point; 4] {
    [0, 1, 2, 3].map(|i: usize| combine([1.0 - t, t], [points[0][i], points[1][i]]))
}

/// Points moved into contact at (t, u, v), to within rounding.
fn touching<K: Primitives>(mut points: Points, [t, u, v]: [f64; 3]) -> Points {
    let gap = combine(K::weights(u, v), at(&points, t));
    for point in points.iter_mut().flat_map(|now| &mut now[..K::FIRST]) {
        *point = combine([1.0, -1.0], [*point, gap]);
    }
    points
}

/// Points moved into contact at (t, u, v), to within rounding, with a relative velocity in the common
/// plane: a double root of the coplanarity cubic.
fn graze<K: Primitives>(points: Points, [t, u, v]: [f64; 3], [a, b]: [f64; 2]) -> Points {
    let mut points = touching::<K>(points, [t, u, v]);
    let along = |start: [f64; 4], end: [f64; 4]| {
        combine([0, 1, 2, 3].map(|i: usize| end[i] - start[i]), at(&points, t))
    };
    let spans = [
        along(K::weights(0.0, v), K::weights(1.0, v)),
        along(K::weights(u, 0.0), K::weights(u, 1.0)),
    ];
    let [start, end] = points.map(|now| combine(K::weights(u, v), now));
    let change = combine([a, b, -1.0, 1.0], [spans[0], spans[1], end, start]);
    for (time, now) in points.iter_mut().enumerate() {
        for point in &mut now[..K::FIRST] {
            *point = combine([1.0, time as f64 - t], [*point, change]);
        }
    }
    points
}

fn any_exponent(random: &mut Random) -> Points {
    random.points(Random::any)
}

fn exponent_per_point(random: &mut Random) -> Points {
    let mut points = random.fractions();
    for point in points.as_flattened_mut() {
        let exponent = random.below(2000) as i32 - 1000;
        *point = point.map(|x| scaled(x, exponent));
    }
    points
}

fn stretched_graze<K: Primitives>(random: &mut Random) -> Points {
    let exponents = [0; 3].map(|_| random.below(2000) as i32 - 1000);
    let points = near_graze::<K>(random);
    points.map(|now| now.map(|point| [0, 1, 2].map(|axis: usize| scaled(point[axis], exponents[axis]))))
}

fn ends_of_the_range(random: &mut Random) -> Points {
    random.points(Random::extreme)
}

fn two_extremes(random: &mut Random) -> Points {
    let mut points = random.small_integers();
    for _ in 0..2 {
        points.as_flattened_mut().as_flattened_mut()[random.below(24)] = random.extreme();
    }
    points
}

fn few_values(random: &mut Random) -> Points {
    let special = [0.0, -0.0, 1.0, 3.0, 1.0 + f64::EPSILON, -0.7];
    let values = [0; 4].map(|_| match random.below(3) {
        0 => special[random.below(special.len())],
        1 => random.extreme(),
        _ => random.any(),
    });
    random.points(|random| values[random.below(values.len())])
}

fn shared_vertex<K: Primitives>(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    let [i, j] = [random.below(K::FIRST), K::FIRST + random.below(4 - K::FIRST)];
    points.iter_mut().for_each(|now| now[i] = now[j]);
    points
}

fn resting_primitive<K: Primitives>(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    let [start, end] = &mut points;
    end[K::FIRST..].copy_from_slice(&start[K::FIRST..]);
    points
}

fn touching_at_end<K: Primitives>(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    let [i, j] = [random.below(K::FIRST), K::FIRST + random.below(4 - K::FIRST)];
    points[1][i] = points[1][j];
    points
}

fn split_graze<K: Primitives>(random: &mut Random) -> Points {
    let (place, velocity) = (random.place(), [random.integer(2), random.integer(2)]);
    // Zeros, to which the least number can be added without rounding.
    let points = random.points(|random| {
        if random.below(2) == 0 {
            0.0
        } else {
            random.integer(4)
        }
    });
    let mut points = graze::<K>(points, place, velocity);
    for x in points.as_flattened_mut().as_flattened_mut() {
        if *x == 0.0 && random.below(3) == 0 {
            *x = [5e-324, -5e-324][random.below(2)];
        }
    }
    points
}

fn near_graze<K: Primitives>(random: &mut Random) -> Points {
    let (place, velocity) = (random.place(), [random.fraction(), random.fraction()]);
    let points = random.fractions();
    graze::<K>(points, place, velocity)
}

/// e₂ is a multiple of e₁ at both ends, to within a few units in the last place; then moved into contact.
fn nearly_parallel<K: Primitives>(random: &mut Random) -> Points {
    let points = random.fractions();
    let points = parallel::<K>(points, random);
    let place = random.place();
    touching::<K>(points, place)
}

/// The same with any exponents, where the least numbers vanish beside the largest, and without contact.
fn nearly_parallel_any<K: Primitives>(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    for x in points.as_flattened_mut().as_flattened_mut() {
        *x = scaled(*x, -60);
    }
    parallel::<K>(points, random)
}

/// The last point becomes that at which e₂ is a multiple of e₁, the same at both ends, but for a unit in the
/// last place.
fn parallel<K: Primitives>(mut points: Points, random: &mut Random) -> Points {
    let [[i, j], [k, last]] = K::SPANNING;
    let factor = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0][random.below(6)];
    for now in &mut points {
        now[last] = combine([factor, -factor, 1.0], [now[j], now[i], now[k]]);
        let axis = random.below(3);
        now[last][axis] = now[last][axis].next_up();
    }
    points
}

fn flat_any(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    let axis = random.below(3);
    let levels = [random.any(), random.any()];
    for (now, level) in points.iter_mut().zip(levels) {
        now.iter_mut().for_each(|point| point[axis] = level);
    }
    points
}

fn slanted_any(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    points
        .as_flattened_mut()
        .iter_mut()
        .for_each(|point| point[2] = point[0]);
    points
}

fn collinear_any(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    points
        .as_flattened_mut()
        .iter_mut()
        .for_each(|point| *point = [point[0], 0.0, -point[0]]);
    points
}

fn all_equal(random: &mut Random) -> Points {
    let point = [random.any(), random.any(), random.any()];
    [[point; 4]; 2]
}

fn equal_at_each_end(random: &mut Random) -> Points {
    [
        [[random.any(), random.any(), random.any()]; 4],
        [[random.any(), random.any(), random.any()]; 4],
    ]
}

fn subnormal(random: &mut Random) -> Points {
    random.points(|random| random.integer(8) * 5e-324)
}
