//! Methods of a peer: the test program starts itself as the other program.
//!
//! It has its own main function, because a peer must write nothing but its answers.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
#![expect(clippy::print_stdout, reason = "the output of the tests and of a peer")]

use std::io::{self, BufRead, Read, Write};
use std::time::Duration;

use exact_ccd::{CONTACT, Ccd, Decide, EdgeEdge, Exact, Kind, Point, Query, TimeGuarantee, VertexFace};
use exact_ccd_compare::{Comparison, Contestant, Peer, PeerError, Report, Subject, Subjects, Table};

fn main() {
    // Other arguments, such as libtest's, run the tests.
    match std::env::args().nth(1).as_deref() {
        Some("peer") => answer_all(None),
        Some("mute") => {}
        Some("babbling") => println!("no JSON at all"),
        Some("silent") => std::thread::sleep(Duration::from_secs(600)),
        Some(fault @ ("truncating" | "endless" | "undecided" | "late" | "stalling")) => {
            answer_all(Some(fault));
        }
        _ => test_all(),
    }
}

/// The peer: the exact method under two names; one of the two stops after the first query.
fn answer_all(fault: Option<&str>) {
    let (mut reader, mut writer) = (io::stdin().lock(), io::stdout().lock());
    let describe = |name: &str, time: &str| {
        format!(
            r#"{{"name": "{name}", "false_negatives": false, "false_positives": false, "time": "{time}", "call_ns": 250.0}}"#
        )
    };
    let methods = [describe("twin", "exact"), describe("lazy", "absent")].join(", ");
    writeln!(writer, r#"{{"methods": [{methods}]}}"#).unwrap();
    writer.flush().unwrap();
    let mut line = String::new();
    while reader.read_line(&mut line).unwrap() > 0 {
        let request: serde_json::Value = serde_json::from_str(&line).unwrap();
        let count = request["queries"].as_u64().unwrap() as usize;
        assert!(request["limit_ns"].is_u64());
        let mut bytes = vec![0; 24 * 8 * count];
        reader.read_exact(&mut bytes).unwrap();
        let answered = if request["method"] == "lazy" { 1 } else { count };
        writeln!(writer, "{answered}").unwrap();
        for query in bytes.chunks(24 * 8).take(answered) {
            let mut points = [[[0.0; 3]; 4]; 2];
            let coordinates: &mut [f64] = points.as_flattened_mut().as_flattened_mut();
            for (x, bytes) in coordinates.iter_mut().zip(query.chunks(8)) {
                *x = f64::from_le_bytes(bytes.try_into().unwrap());
            }
            let time = match request["kind"].as_str().unwrap() {
                "vf" => time_of_impact::<VertexFace>(points),
                _ => time_of_impact::<EdgeEdge>(points),
            };
            let reported = if request["method"] == "lazy" { None } else { time };
            let answer = [
                // Nanoseconds: no answer depends on a clock.
                1000.0,
                f64::from(u8::from(time.is_some())),
                reported.unwrap_or(f64::NAN),
            ];
            let answer = match fault {
                None => answer,
                Some("truncating") => return,
                Some("stalling") => {
                    std::thread::sleep(Duration::from_secs(600));
                    return;
                }
                Some("endless") => [f64::INFINITY, 1.0, 0.5],
                Some("undecided") => [1.0, f64::NAN, 0.5],
                Some(_) => [1.0, 1.0, 1.5],
            };
            writer
                .write_all(answer.map(f64::to_le_bytes).as_flattened())
                .unwrap();
        }
        writer.flush().unwrap();
        line.clear();
    }
}

fn time_of_impact<K: Kind<Points = [Point; 4]>>([start, end]: [[Point; 4]; 2]) -> Option<f64> {
    Query::<K>::new(start, end).unwrap().time_of_impact(CONTACT)
}

fn test_all() {
    let tests: [(&str, fn()); 6] = [
        (
            "answers_arrive_as_they_were_given",
            answers_arrive_as_they_were_given,
        ),
        ("both_kinds_are_asked", both_kinds_are_asked),
        (
            "the_cost_of_a_call_is_in_the_report",
            the_cost_of_a_call_is_in_the_report,
        ),
        (
            "what_a_program_does_wrong_is_an_error",
            what_a_program_does_wrong_is_an_error,
        ),
        ("a_silent_program_is_an_error", a_silent_program_is_an_error),
        (
            "a_comparison_goes_on_without_a_peer_that_has_failed",
            a_comparison_goes_on_without_a_peer_that_has_failed,
        ),
    ];
    for (name, test) in tests {
        test();
        println!("test {name} ... ok");
    }
}

fn start(role: &str) -> Result<Vec<Peer>, PeerError> {
    let program = std::env::current_exe().unwrap();
    Peer::start(&shell_words::join([program.to_str().unwrap(), role]), grace(role))
}

/// The limit is short for the roles that do not answer, and longer than any test for the others.
fn grace(role: &str) -> Duration {
    match role {
        "silent" => Duration::from_millis(10),
        "stalling" => Duration::from_secs(5),
        _ => Duration::from_secs(600),
    }
}

fn compare<K: exact_ccd_data::DataKind>(
    peers: Vec<Peer>,
    query: impl Fn(f64) -> Query<K>,
) -> Result<Table, PeerError>
where
    dyn Ccd: Decide<K>,
{
    compare_within(Duration::from_secs(100), peers, query)
}

fn compare_within<K: exact_ccd_data::DataKind>(
    budget: Duration,
    peers: Vec<Peer>,
    query: impl Fn(f64) -> Query<K>,
) -> Result<Table, PeerError>
where
    dyn Ccd: Decide<K>,
{
    let mut subjects = Subjects::new(1000);
    (0..300).for_each(|i| subjects.add(Subject::new(query(f64::from(i)), None)));
    let contestants = peers.into_iter().map(Contestant::Peer).collect();
    let mut comparison = Comparison::new(contestants, budget);
    let table = comparison.run("falling", &subjects, &|_| ());
    comparison.finish().map(|()| table)
}

/// A vertex falls from a height of 1 onto a face, or past it.
fn falling(place: f64) -> Query<VertexFace> {
    let face = [[0.0; 3], [100.0, 0.0, 0.0], [0.0, 100.0, 0.0]];
    let at = |z: f64| [[place, 1.0, z], face[0], face[1], face[2]];
    Query::<VertexFace>::new(at(1.0), at(-2.0)).unwrap()
}

fn answers_arrive_as_they_were_given() {
    let table = compare(start("peer").unwrap(), falling).unwrap();
    let [twin, lazy] = &table.rows[..] else {
        panic!("{table:?}")
    };
    assert_eq!([table.queries, table.colliding], [300, 100]);
    assert_eq!([&*twin.method, &*lazy.method], ["twin", "lazy"]);
    assert_eq!(twin.answered, table.sample);
    assert_eq!([twin.false_positives, twin.false_negatives], [0, 0]);
    let error = twin.time_error.unwrap();
    assert!(error.worst == 0.0 && error.late == 0, "{error:?}");
    assert_eq!(lazy.answered.colliding + lazy.answered.free, 1);
    assert_eq!(lazy.time_error, None);
}

fn both_kinds_are_asked() {
    // The second edge passes the first one, or its end.
    let table = compare(start("peer").unwrap(), |place| {
        let at = |z: f64| [[0.0; 3], [100.0, 0.0, 0.0], [place, -1.0, z], [place, 1.0, z]];
        Query::<EdgeEdge>::new(at(1.0), at(-2.0)).unwrap()
    });
    let table = table.unwrap();
    assert_eq!(table.colliding, 101);
    assert_eq!(
        [table.rows[0].false_positives, table.rows[0].false_negatives],
        [0, 0]
    );
}

fn the_cost_of_a_call_is_in_the_report() {
    let peers = start("peer").unwrap();
    assert!(peers.iter().all(|peer| peer.call_nanoseconds() == 250.0));
    assert_eq!(peers[0].guarantees().time, TimeGuarantee::Exact);
    let contestants: Vec<_> = peers.into_iter().map(Contestant::Peer).collect();
    let report = Report::new(&contestants);
    assert!(
        report.notes[0].contains("twin") && report.notes[0].contains("0.25 µs"),
        "{:?}",
        report.notes
    );
}

fn what_a_program_does_wrong_is_an_error() {
    let message = |result: Result<Vec<Peer>, PeerError>| result.err().map(|error| error.to_string()).unwrap();
    assert!(message(Peer::start("no-such-program", Duration::ZERO)).starts_with("no-such-program: "));
    assert!(message(Peer::start("an 'open quote", Duration::ZERO)).contains("cannot be split into words"));
    assert!(message(Peer::start("", Duration::ZERO)).contains("cannot be split into words"));
    assert!(message(start("mute")).ends_with("it has ended"));
    assert!(message(start("babbling")).contains(r#"expected a line with its methods, found "no JSON"#));
    let error = compare(start("truncating").unwrap(), falling).unwrap_err();
    assert!(matches!(error, PeerError::Io { .. }), "{error}");
    for (role, found) in [
        ("endless", "inf 1 0.5"),
        ("undecided", "1 NaN 0.5"),
        ("late", "1 1 1.5"),
    ] {
        let error = compare(start(role).unwrap(), falling).unwrap_err().to_string();
        assert!(
            error.contains("expected nanoseconds from 0") && error.contains(found),
            "{error}"
        );
    }
}

fn a_silent_program_is_an_error() {
    let error = start("silent").err().unwrap().to_string();
    assert!(error.ends_with("no answer within 0.0 s"), "{error}");
    let budget = Duration::from_millis(500);
    let error = compare_within(budget, start("stalling").unwrap(), falling).unwrap_err();
    assert!(error.to_string().ends_with("no answer within 5.5 s"), "{error}");
}

/// The exact method answers all queries of this data set and of the next one, and the table has the
/// peer's rows.
fn a_comparison_goes_on_without_a_peer_that_has_failed() {
    let mut subjects = Subjects::new(1000);
    (0..300).for_each(|i| subjects.add(Subject::new(falling(f64::from(i)), None)));
    let peers = start("truncating").unwrap().into_iter().map(Contestant::Peer);
    let exact = Contestant::Method(Box::new(Exact));
    let mut comparison = Comparison::new(peers.chain([exact]).collect(), Duration::from_secs(100));
    for data_set in ["first", "second"] {
        let table = comparison.run(data_set, &subjects, &|_| ());
        let answered: Vec<usize> = table
            .rows
            .iter()
            .map(|row| row.answered.colliding + row.answered.free)
            .collect();
        assert_eq!(answered, [0, 0, 300]);
        assert!(table.rows[0].mean.is_none() && table.rows[2].mean.is_some());
        assert!(table.markdown().contains("| twin | 0 + 0 | "));
    }
    let failed: Vec<&str> = comparison.failures().map(|(name, _)| name).collect();
    assert_eq!(failed, ["twin", "lazy"]);
    assert!(comparison.finish().is_err());
}
