//! Methods of other programs, which answer through a pipe.
//!
//! A peer is a command. It writes a line of JSON, its methods:
//!
//! ```json
//! {"methods": [{"name": "TI", "false_negatives": false, "false_positives": true,
//!               "time": "conservative", "call_ns": 700.0}]}
//! ```
//!
//! in one line, where the first two flags are [`Guarantees`], `time` is `absent`, `approximate`,
//! `conservative` or `exact`, and `call_ns` is the time of an empty call in nanoseconds. Then, again and
//! again, it reads a line such as
//!
//! ```json
//! {"method": "TI", "kind": "vf", "queries": 128, "limit_ns": 1000000}
//! ```
//!
//! and 24 little-endian `f64` for each query: the points at t = 0 and then at t = 1. It answers the
//! queries in order, and stops after the one during which the limit is passed. It writes a line
//! with the number of queries that it answered and, for each, three little-endian `f64`: the
//! nanoseconds that it took, 1 for contact or 0, and the time of contact or NaN. It ends when its
//! input ends.

use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;
use std::time::Duration;

use exact_ccd::{Guarantees, Query, TimeGuarantee};
use exact_ccd_data::DataKind;
use serde::{Deserialize, Serialize};

use crate::process::Process;
use crate::timed::Timed;

/// A method of another program.
pub struct Peer {
    name: String,
    guarantees: Guarantees,
    call_nanoseconds: f64,
    program: Rc<RefCell<Program>>,
}

/// A program with its methods.
struct Program {
    command: String,
    process: Process,
    /// The time limit of an answer, in addition to the time limits of its queries.
    grace: Duration,
}

/// The failure of a program that should answer queries.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PeerError {
    /// The command cannot be split into words.
    #[error("{command}: cannot be split into words")]
    Command {
        /// The command.
        command: String,
    },
    /// The program cannot be started, has ended, or does not answer in time.
    #[error("{command}: {source}")]
    Io {
        /// The command.
        command: String,
        /// The error of the system.
        source: io::Error,
    },
    /// The answer does not have the expected form.
    #[error("{command}: expected {expected}, found {found:?}")]
    Answer {
        /// The command.
        command: String,
        /// The expected form.
        expected: &'static str,
        /// The beginning of the answer.
        found: String,
    },
}

/// The longest time of an answer that is accepted: one day.
const MAX_NANOSECONDS: f64 = 24.0 * 3600.0 * 1e9;

/// The length of an excerpt of a wrong answer, in characters.
const EXCERPT: usize = 80;

#[derive(Deserialize)]
struct Greeting {
    methods: Vec<Description>,
}

#[derive(Deserialize)]
struct Description {
    name: String,
    false_negatives: bool,
    false_positives: bool,
    #[serde(with = "TimeName")]
    time: TimeGuarantee,
    call_ns: f64,
}

#[derive(Deserialize)]
#[serde(remote = "TimeGuarantee", rename_all = "lowercase")]
enum TimeName {
    Absent,
    Approximate,
    Conservative,
    Exact,
}

#[derive(Serialize)]
struct Request<'a> {
    method: &'a str,
    kind: &'a str,
    queries: usize,
    limit_ns: u64,
}

impl Peer {
    /// Starts a program, and returns its methods.
    ///
    /// The program fails if it needs longer than `grace` for the line with its methods, or, beyond
    /// the time limit of the queries, for an answer.
    ///
    /// # Errors
    /// If the program cannot be started, or does not write the line with its methods.
    pub fn start(command: &str, grace: Duration) -> Result<Vec<Self>, PeerError> {
        let words = shell_words::split(command).ok().filter(|words| !words.is_empty());
        let Some([name, arguments @ ..]) = words.as_deref() else {
            let command = command.to_owned();
            return Err(PeerError::Command { command });
        };
        let process = Process::start(name, arguments).map_err(|source| PeerError::Io {
            command: command.to_owned(),
            source,
        })?;
        let mut program = Program {
            command: command.to_owned(),
            process,
            grace,
        };
        let methods = program.greeting()?;
        let program = Rc::new(RefCell::new(program));
        let peer = |description: Description| Self {
            name: description.name,
            guarantees: Guarantees {
                false_negatives: description.false_negatives,
                false_positives: description.false_positives,
                time: description.time,
            },
            call_nanoseconds: description.call_ns,
            program: Rc::clone(&program),
        };
        Ok(methods.into_iter().map(peer).collect())
    }

    /// The name of the method.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The guarantees of the method's answers, according to the program.
    #[must_use]
    pub fn guarantees(&self) -> Guarantees {
        self.guarantees
    }

    /// The time of an empty call in nanoseconds. It is part of all times of this method.
    #[must_use]
    pub fn call_nanoseconds(&self) -> f64 {
        self.call_nanoseconds
    }

    /// Answers queries in order until the time limit, but at least the first. After an error, the
    /// program is ended.
    pub(super) fn answer<K: DataKind>(
        &mut self,
        queries: &[Query<K>],
        limit: Duration,
    ) -> Result<Vec<Timed>, PeerError> {
        let mut program = self.program.borrow_mut();
        let request = Request {
            method: &self.name,
            kind: K::KIND.short(),
            queries: queries.len(),
            limit_ns: u64::try_from(limit.as_nanos()).unwrap_or(u64::MAX),
        };
        let answers = program.answer(&request, queries, limit);
        if answers.is_err() {
            // The rest of a wrong answer must not be read as the answer to the next request.
            program.process.kill();
        }
        answers
    }
}

impl Program {
    fn io(&self, source: io::Error) -> PeerError {
        let command = self.command.clone();
        PeerError::Io { command, source }
    }

    fn unexpected(&self, expected: &'static str, found: &str) -> PeerError {
        PeerError::Answer {
            command: self.command.clone(),
            expected,
            found: found.chars().take(EXCERPT).collect(),
        }
    }

    fn greeting(&mut self) -> Result<Vec<Description>, PeerError> {
        self.process.set_patience(self.grace);
        let line = self.process.line().map_err(|source| self.io(source))?;
        let greeting: Result<Greeting, _> = serde_json::from_str(&line);
        greeting
            .map(|greeting| greeting.methods)
            .map_err(|_| self.unexpected("a line with its methods", &line))
    }

    fn answer<K: DataKind>(
        &mut self,
        request: &Request<'_>,
        queries: &[Query<K>],
        limit: Duration,
    ) -> Result<Vec<Timed>, PeerError> {
        self.process.set_patience(self.grace.saturating_add(limit));
        write(self.process.requests(), request, queries).map_err(|source| self.io(source))?;
        let line = self.process.line().map_err(|source| self.io(source))?;
        let answered = line
            .trim()
            .parse()
            .ok()
            .filter(|answered| (1..=queries.len()).contains(answered));
        let answered = answered.ok_or_else(|| self.unexpected("how many queries it answered", &line))?;
        (0..answered).map(|_| self.timed()).collect()
    }

    fn timed(&mut self) -> Result<Timed, PeerError> {
        let mut bytes = [[0; 8]; 3];
        let read = self.process.read(bytes.as_flattened_mut());
        read.map_err(|source| self.io(source))?;
        let [nanoseconds, contact, time] = bytes.map(f64::from_le_bytes);
        let answer = match (contact, time) {
            (0.0, _) => Some((false, None)),
            (1.0, time) if time.is_nan() => Some((true, None)),
            (1.0, 0.0..=1.0) => Some((true, Some(time))),
            _ => None,
        };
        let (collides, time) = answer
            .filter(|_| (0.0..=MAX_NANOSECONDS).contains(&nanoseconds))
            .ok_or_else(|| {
                let expected = "nanoseconds from 0, contact 0 or 1, and a time from 0 to 1 or NaN";
                self.unexpected(expected, &format!("{nanoseconds} {contact} {time}"))
            })?;
        Ok(Timed {
            collides,
            time,
            nanoseconds,
        })
    }
}

fn write<K: DataKind>(pipe: &mut impl Write, request: &Request<'_>, queries: &[Query<K>]) -> io::Result<()> {
    serde_json::to_writer(&mut *pipe, request)?;
    pipe.write_all(b"\n")?;
    let points = queries.iter().flat_map(|query| query.points().as_flattened());
    for x in points.flatten() {
        pipe.write_all(&x.to_le_bytes())?;
    }
    pipe.flush()
}
