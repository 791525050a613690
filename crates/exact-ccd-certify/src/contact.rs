//! The proof of the earliest contact: this module makes candidates, and takes the first that the checker
//! accepts.

use dashu_int::IBig;
use exact_ccd_check::contact::{Moving, Proof, is_contact, vertex_on_edge};
use exact_ccd_check::motion::{Motion, Point, Time};
use exact_ccd_check::polynomial::Polynomial;
use exact_ccd_check::separation::dot;
use exact_ccd_check::{Kind, Pair};

use crate::factor::{coprime, derivative, gcd};

/// A proof of contact after the first time and not after the second, if one is found.
pub(crate) fn proof(motion: &Motion, kind: Kind, pair: &Pair<'_>, times: [f64; 2]) -> Option<Proof> {
    let proofs = points(motion, kind, pair, times[1]).into_iter().map(Proof::Point);
    let moving = Moving::new(motion, pair, times);
    let mut proofs = proofs.chain(roots(&moving, kind)).chain(on_edges(&moving, kind));
    proofs.find(|proof| is_contact(motion, kind, pair, times, proof))
}

/// The weights of the closest points of all pairs of features at a time.
fn points(motion: &Motion, kind: Kind, pair: &Pair<'_>, time: f64) -> Vec<Vec<IBig>> {
    let [time] = Time::together([time]);
    let points: Vec<Point> = pair.vertices().map(|vertex| motion.at(vertex, &time)).collect();
    let minus =
        |i: usize, j: usize| -> Point { [0, 1, 2].map(|axis: usize| &points[i][axis] - &points[j][axis]) };
    let mut all = Vec::new();
    let mut add = |weights: &[(usize, &IBig)]| {
        let mut row = vec![IBig::ZERO; points.len()];
        for &(place, weight) in weights {
            row[place] += weight;
        }
        all.push(coprime(row));
    };
    for i in 0..pair.first.len() {
        for j in pair.first.len()..points.len() {
            add(&[(i, &IBig::ONE), (j, &IBig::ONE)]);
        }
    }
    for &[q, x, y] in vertex_on_edge(kind) {
        let (edge, to) = (minus(y, x), minus(q, x));
        let (whole, part) = (dot(&edge, &edge), dot(&edge, &to));
        add(&[(q, &whole), (x, &(&whole - &part)), (y, &part)]);
    }
    // The least |u e − v f − w|, by the normal equations.
    let least = |e: &Point, f: &Point, w: &Point| {
        let [ee, ef, ff, we, wf] = [dot(e, e), dot(e, f), dot(f, f), dot(w, e), dot(w, f)];
        (
            &ee * &ff - &ef * &ef,
            &we * &ff - &wf * &ef,
            &we * &ef - &wf * &ee,
        )
    };
    match kind {
        Kind::VertexFace => {
            let (whole, u, v) = least(&minus(2, 1), &minus(3, 1), &minus(0, 1));
            add(&[(0, &whole), (1, &(&whole - &u + &v)), (2, &u), (3, &-v)]);
        }
        Kind::EdgeEdge => {
            let (whole, u, v) = least(&minus(1, 0), &minus(3, 2), &minus(2, 0));
            add(&[(0, &(&whole - &u)), (1, &u), (2, &(&whole - &v)), (3, &v)]);
        }
        _ => {}
    }
    all
}

/// Roots of coplanarity, simple or of a factor.
fn roots(moving: &Moving, kind: Kind) -> Vec<Proof> {
    let Some((_, c, sides)) = moving.coplanarity(kind) else {
        return Vec::new();
    };
    let mut factors = vec![gcd(&c, &derivative(&c))];
    factors.extend(sides.iter().flatten().map(|side| gcd(&c, side)));
    let factors = factors.into_iter().filter(Polynomial::changes_sign).map(Some);
    let factors: Vec<_> = std::iter::once(None).chain(factors).collect();
    let proof = |(axis, factor): (usize, &Option<Polynomial>)| Proof::Coplanar {
        axis,
        factor: factor.clone(),
    };
    factors
        .iter()
        .flat_map(|factor| [0, 1, 2].map(|axis| proof((axis, factor))))
        .collect()
}

/// Times at which a vertex is on an edge.
fn on_edges(moving: &Moving, kind: Kind) -> Vec<Proof> {
    let rows = 0..vertex_on_edge(kind).len();
    let proof = |row: usize| {
        let (cross, dot) = moving.on_edge(kind, row)?;
        let [x, y, z] = &cross;
        let line = gcd(&gcd(x, y), z);
        // Where the vertex is on the line at all times, it is at an end of the edge at a double root.
        let both = gcd(&line, &dot);
        let factors = [
            gcd(&both, &derivative(&both)),
            both,
            gcd(&line, &derivative(&line)),
            line,
        ];
        let proofs = factors.into_iter().filter(Polynomial::changes_sign);
        Some(proofs.map(move |factor| Proof::OnEdge { row, factor }))
    };
    rows.filter_map(proof).flatten().collect()
}
