//! Exact curved motion of all kinds: filters and integers agree bit for bit, bodies may be exchanged, and no
//! input makes a panic.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd::motion::{Bezier, BodyPair, Chain, CurvedQuery, RigidMotion};
use exact_ccd::{AnyKind, CONTACT, EdgeEdge, Kind, Options, Point, Separation, with_kind};
use exact_ccd_fuzz::coordinate;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes are no motion.
    let _ = check(&mut Unstructured::new(bytes));
});

fn check(bytes: &mut Unstructured) -> Result<()> {
    let kind = *bytes.choose(AnyKind::ALL)?;
    let d = Separation::new(coordinate(bytes)?.abs()).unwrap_or(Separation::ZERO);
    let until = f64::from(bytes.int_in_range(0..=8_u8)?) / 8.0;
    let options = [CONTACT, CONTACT.until(until), Options::within(d)];
    with_kind!(kind, K => check_kind::<K>(bytes, &options))
}

fn check_kind<K: Kind>(bytes: &mut Unstructured, options: &[Options]) -> Result<()> {
    if bytes.arbitrary()? {
        let degree = bytes.int_in_range(1..=3_u8)?;
        let control: Vec<K::Points> = (0..=degree).map(|_| points::<K>(bytes)).collect::<Result<_>>()?;
        if let Ok(motion) = Bezier::<K>::new(&control) {
            check_query(&motion.into(), options);
        }
        return Ok(());
    }
    let [first, second] = [chain(bytes)?, chain(bytes)?];
    let points = points::<K>(bytes)?;
    let pair = BodyPair::new(first.clone(), second.clone());
    let Ok(query) = pair.query::<K>(points) else {
        return Ok(());
    };
    check_query(&query, options);
    for &point in points.as_ref() {
        let [lower, upper] = pair.bounds(point);
        assert!(
            (0..3).all(|axis| lower[axis] <= upper[axis]),
            "{pair:?} {point:?}"
        );
    }
    if let ([a, b, c, d], AnyKind::EdgeEdge) = (points.as_ref(), K::KIND) {
        let exchanged = CurvedQuery::<EdgeEdge>::of_bodies([*c, *d, *a, *b], second, first);
        let exchanged = exchanged.expect("finite points");
        assert_eq!(
            exchanged.intervals(CONTACT),
            query.intervals(CONTACT),
            "{query:?}"
        );
    }
    Ok(())
}

/// The answers with filters are those in integers.
fn check_query<K: Kind>(query: &CurvedQuery<K>, options: &[Options]) {
    for &options in options {
        let exactly = query.exactly();
        let time = exactly.time_of_impact(options);
        assert_eq!(query.collides(options), time.is_some(), "{options:?} {query:?}");
        assert_eq!(query.time_of_impact(options), time, "{options:?} {query:?}");
        let intervals = query.intervals(options);
        let first = intervals.first_time().map(exact_ccd::ContactTime::lower);
        assert_eq!(first, time, "{options:?} {query:?}");
        if let (Some([start, end]), Some(time)) = (query.bracket(options), time) {
            assert!((start..=end).contains(&time), "{options:?} {query:?}");
        }
    }
}

fn point(bytes: &mut Unstructured) -> Result<Point> {
    Ok([coordinate(bytes)?, coordinate(bytes)?, coordinate(bytes)?])
}

fn points<K: Kind>(bytes: &mut Unstructured) -> Result<K::Points> {
    let mut points = K::Points::default();
    for place in points.as_mut() {
        *place = point(bytes)?;
    }
    Ok(points)
}

/// Up to two motions; those that are none are left out.
fn chain(bytes: &mut Unstructured) -> Result<Chain> {
    let mut motions = Vec::new();
    for _ in 0..bytes.int_in_range(0..=2_u8)? {
        let mut quaternions = [[0.0; 4]; 2];
        for x in quaternions.as_flattened_mut() {
            *x = coordinate(bytes)?;
        }
        let places = [point(bytes)?, point(bytes)?];
        motions.extend(RigidMotion::new(quaternions, &places).ok());
    }
    Ok(Chain::new(motions).expect("a short chain"))
}
