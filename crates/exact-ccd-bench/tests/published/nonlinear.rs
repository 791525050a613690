//! Curved motion against truth from rational arithmetic: the number of contact times, and the first.

// The benchmark `curved` reads them too; the library of this crate does not read files.
#[path = "../../benches/nonlinear/mod.rs"]
mod curved_queries;

use exact_ccd::{AnyKind, CONTACT, Kind, with_kind};
use exact_ccd_data::CurvedRecord;

use curved_queries::files;

/// Files of generic motion: the filters decide nearly all queries in them.
const GENERIC: [&str; 7] = [
    "quadratic-vf",
    "cubic-vf",
    "fall-vf",
    "rigid-vf",
    "rigid-against-fixed-vf",
    "rigid-lattice-vf",
    "chain-vf",
];

/// Compares the answers, with filters and in integers. Returns true if the filters decide.
fn check<K: Kind>(line: &CurvedRecord, place: &str) -> bool {
    let query = line.query::<K>().unwrap();
    let intervals = query.intervals(CONTACT);
    let expected = usize::try_from(line.count.unwrap()).ok();
    assert_eq!(intervals.count(), expected, "{place}");
    let first = intervals.first_time().map(|time| time.lower().to_bits());
    assert_eq!(first, line.toi.map(f64::to_bits), "{place}");
    assert_eq!(query.time_of_impact(CONTACT), line.toi, "{place}");
    assert_eq!(query.collides(CONTACT), line.toi.is_some(), "{place}");
    assert_eq!(query.exactly().collides(CONTACT), line.toi.is_some(), "{place}");
    let bracket = query.bracket(CONTACT);
    match (bracket, line.toi) {
        (None, _) => {}
        (Some([start, end]), Some(time)) => assert!((start..=end).contains(&time), "{place}"),
        (Some([start, _]), None) => assert_eq!(start, f64::INFINITY, "{place}"),
    }
    bracket.is_some()
}

/// The lines of all files about one kind.
fn check_files(kind: AnyKind, expected: usize) {
    let mut count = 0;
    for (name, lines) in files().unwrap() {
        let lines: Vec<_> = lines.iter().filter(|line| line.kind() == kind).collect();
        let decided = lines.iter().enumerate().filter(|(index, line)| {
            let place = format!("line {} of {name}", index + 1);
            with_kind!(kind, K => check::<K>(line, &place))
        });
        let integers = lines.len() - decided.count();
        if GENERIC.contains(&name.replace("-ee", "-vf").as_str()) {
            assert!(
                50 * integers <= lines.len(),
                "{integers} of {} in {name}",
                lines.len()
            );
        }
        count += lines.len();
    }
    assert_eq!(count, expected);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn vertices_and_faces_on_curves() {
    check_files(AnyKind::VertexFace, 2130);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn edges_on_curves() {
    check_files(AnyKind::EdgeEdge, 2130);
}
