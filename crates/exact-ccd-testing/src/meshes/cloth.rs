//! Sheets of cloth that fall onto each other.

use exact_ccd::Point;

/// The number of sheets above each other.
pub const SHEETS: usize = 4;
/// The distance of neighbouring sheets at the start. All lengths are in units of an edge.
const GAP: f64 = 0.7;
/// The distance by which each sheet slides; every other sheet slides in the opposite direction.
const SLIDE: f64 = 0.4;
/// The distance from wave to wave.
const PERIOD: f64 = 16.0;
/// The largest distance of a vertex from its place in the grid, so that nothing is in special
/// position.
const UNEVEN: f64 = 0.1;

/// Square sheets of wavy cloth in motion.
///
/// It is computed by + − × ÷ alone, so that it is the same on every machine.
pub struct Cloth {
    /// The vertices of each face.
    pub faces: Vec<[u32; 3]>,
    /// The positions of the vertices at t = 0.
    pub x0: Vec<Point>,
    /// The positions of the vertices at t = 1.
    pub x1: Vec<Point>,
}

impl Cloth {
    /// Sheets of `side` × `side` vertices whose distance falls to `nearest`, apart from their
    /// unevenness.
    pub fn new(side: usize, nearest: f64) -> Self {
        let mut random = fastrand::Rng::with_seed(1);
        let vertex_count = SHEETS * side * side;
        let (mut x0, mut x1) = (Vec::with_capacity(vertex_count), Vec::with_capacity(vertex_count));
        let mut faces = Vec::with_capacity(2 * vertex_count);
        for sheet in 0..SHEETS {
            let slide = if sheet % 2 == 0 { SLIDE } else { -SLIDE };
            for row in 0..side {
                for column in 0..side {
                    let place = [row, column].map(|index| index as f64);
                    let mut uneven = || UNEVEN * (2.0 * random.f64() - 1.0);
                    let wave = wave(place[0] / PERIOD) * wave(place[1] / PERIOD);
                    let height = |gap: f64| gap * sheet as f64 + wave;
                    let start = [place[0], place[1], height(GAP)].map(|x| x + uneven());
                    let fall = height(nearest) - height(GAP);
                    let motion = [slide, 0.5 * slide, fall].map(|x| x + 0.25 * uneven());
                    x0.push(start);
                    x1.push([0, 1, 2].map(|axis| start[axis] + motion[axis]));
                    if row > 0 && column > 0 {
                        faces.extend(cell(x0.len() - 1, side));
                    }
                }
            }
        }
        Self { faces, x0, x1 }
    }
}

/// A smooth wave of period 1 and height 1.
fn wave(x: f64) -> f64 {
    let x = x - x.floor();
    16.0 * x * x * (1.0 - x) * (1.0 - x)
}

/// The two faces of the cell of the grid that ends at a vertex.
fn cell(last: usize, side: usize) -> [[u32; 3]; 2] {
    let [a, b, c, d] = [last - side - 1, last - side, last - 1, last]
        .map(|vertex| u32::try_from(vertex).expect("there are fewer than 2³² vertices"));
    [[a, b, d], [a, d, c]]
}
