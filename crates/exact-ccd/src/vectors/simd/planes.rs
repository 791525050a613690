//! The next filters, [`Stage::Normals`](crate::Stage::Normals) and
//! [`Stage::Coplanarity`](crate::Stage::Coplanarity): eight queries at a time.

use fearless_simd::f64x8;
use fearless_simd::prelude::*;

use crate::filter::{Gap, Screened, screen_planes};
use crate::numbers::cubic::Cubic;
use crate::tables::Points;
use crate::tables::Tables;
use crate::vectors::row::Row;

/// The number of queries in a vector.
pub(super) const LANES: usize = 8;

/// The results of these filters for eight queries.
pub(super) struct Rest {
    /// The queries that are settled, a bit for each.
    pub(super) settled: u64,
    /// The queries with coordinates out of the range of these filters.
    out_of_range: u64,
    /// Their coplanarity cubics.
    bernstein: [[f64; LANES]; 4],
    magnitude: [f64; LANES],
}

impl Rest {
    /// The cubic of a query in range.
    #[inline(always)]
    pub(super) fn cubic(&self, lane: usize) -> Option<Cubic<f64>> {
        (self.out_of_range >> lane & 1 == 0).then(|| Cubic {
            bernstein: self.bernstein.map(|lanes| lanes[lane]),
            magnitude: self.magnitude[lane],
        })
    }
}

/// Passes eight queries through the filters.
#[inline(always)]
pub(super) fn screen<S: Simd, K: Tables, G: Gap<f64x8<S>>>(
    simd: S,
    rows: &[[&Row; 4]; LANES],
    gaps: G,
) -> Rest {
    let Screened {
        settled,
        out_of_range,
        cubic,
    } = screen_planes::<K, _>(&transposed(simd, rows), gaps);
    Rest {
        settled: settled.to_bitmask(),
        out_of_range: out_of_range.to_bitmask(),
        bernstein: cubic.bernstein.map(Into::into),
        magnitude: cubic.magnitude.into(),
    }
}

/// The points of eight queries side by side.
#[inline(always)]
pub(super) fn transposed<S: Simd>(simd: S, rows: &[[&Row; 4]; LANES]) -> Points<f64x8<S>> {
    let mut transposed = [[[0.0; LANES]; 8]; 4];
    for (lane, rows) in rows.iter().enumerate() {
        for (point, row) in rows.iter().enumerate() {
            for (place, &x) in row.0.iter().enumerate() {
                transposed[point][place][lane] = x;
            }
        }
    }
    let zero = f64x8::splat(simd, 0.0);
    let mut points: Points<f64x8<S>> = [[[zero; 3]; 4]; 2];
    for time in 0..2 {
        for point in 0..4 {
            for axis in 0..3 {
                points[time][point][axis] = f64x8::from_slice(simd, &transposed[point][4 * time + axis]);
            }
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::filter::Touching;
    use crate::tables::VertexFace;
    use crate::vectors::simd::instructions::{Instructions, dispatch};

    #[test]
    fn cubics_are_those_of_the_lanes_in_range() {
        let rows = |unit: f64| [0.0, 1.0, 2.0, 3.0].map(|x| Row::new([x * unit; 3], [x * unit; 3]));
        let [near, far] = [rows(1.0), rows(libm::ldexp(1.0, 201))];
        let level = Instructions::best().level();
        for far_lanes in 0..1_u32 << LANES {
            let is_far = |lane: usize| far_lanes >> lane & 1 != 0;
            let of_lane = |lane| {
                if is_far(lane) {
                    far.each_ref()
                } else {
                    near.each_ref()
                }
            };
            let eight = core::array::from_fn(of_lane);
            let rest = dispatch!(level, simd => screen::<_, VertexFace, _>(simd, &eight, Touching));
            for lane in 0..LANES {
                assert_eq!(rest.cubic(lane).is_none(), is_far(lane), "{far_lanes:b} {lane}");
            }
        }
    }
}
