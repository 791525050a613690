//! Random queries of points that are flat, parallel or in one place, with few bits or turned.

use exact_ccd::Point;

use exact_ccd_testing::meshes::flat::turn;

pub(crate) type Points = [[Point; 4]; 2];

/// A generator of pseudo-random bits (SplitMix64).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// An integer from 0 to n − 1.
    fn below(&mut self, n: u64) -> usize {
        (self.bits() % n) as usize
    }

    fn points(&mut self, n: u64) -> Points {
        let mut coordinate = || self.below(n) as f64;
        [(); 2].map(|()| [(); 4].map(|()| [(); 3].map(|()| coordinate())))
    }
}

pub(crate) type Family = fn(&mut Random) -> Points;

/// The families, by name.
pub(crate) fn families() -> [(&'static str, Family); 8] {
    [
        ("small integers", small_integers),
        ("flat at the start", flat_at_start),
        ("in one plane", in_one_plane),
        ("in a plane that moves", in_a_moving_plane),
        ("parallel", parallel),
        ("with a common point", with_a_common_point),
        ("sliding by tenths", sliding),
        ("sliding by tenths, turned", |random| {
            sliding(random).map(|now| now.map(|point| turn(&point)))
        }),
    ]
}

fn small_integers(random: &mut Random) -> Points {
    random.points(4)
}

fn flat_at_start(random: &mut Random) -> Points {
    let [mut start, end] = random.points(5);
    start.iter_mut().for_each(|point| point[2] = 0.0);
    [start, end]
}

/// The points of the plane x + y + z = 0.
fn in_one_plane(random: &mut Random) -> Points {
    random.points(5).map(|now| now.map(|[x, y, _]| [x, y, -x - y]))
}

/// A plane across an axis, at another height at the end.
fn in_a_moving_plane(random: &mut Random) -> Points {
    let [start, end] = random.points(4);
    [(start, 0.0), (end, 1.0)].map(|(now, z)| now.map(|[x, y, _]| [x, y, z]))
}

/// x₁ − x₀ and x₃ − x₂ have one direction, at both ends of the step.
fn parallel(random: &mut Random) -> Points {
    let points = random.points(4);
    let lengths = [1 + random.below(3), 1 + random.below(3)].map(|length| length as f64);
    points.map(|[a, direction, b, _]| {
        let ahead = |from: Point, length: f64| [0, 1, 2].map(|k: usize| from[k] + length * direction[k]);
        [a, ahead(a, lengths[0]), b, ahead(b, lengths[1])]
    })
}

fn with_a_common_point(random: &mut Random) -> Points {
    let mut points = random.points(4);
    let (end, other) = (random.below(2), 2 + random.below(2));
    points[end][other] = points[end][0];
    points
}

/// Points of a plane. The first one or two slide by tenths, in the plane or through it.
fn sliding(random: &mut Random) -> Points {
    let [mut start, mut end] = random.points(6);
    for point in &mut start {
        point[2] = 0.0;
    }
    let (to, rise) = (end[0], 0.01 * (random.below(3) as f64 - 1.0));
    let moving = 1 + random.below(2);
    end = start;
    for i in 0..moving {
        start[i][2] += rise;
        end[i] = [end[i][0] + 0.1 * to[0], end[i][1] + 0.1 * to[1], -rise];
    }
    [start, end]
}
