//! Methods of other programs, which answer through a pipe.
//!
//! A peer is a command. It writes a line of JSON, its methods:
//!
//! ```json
//! {"methods": [{"name": "TI", "may_miss": false, "may_invent": true, "time": "conservative", "call_ns": 700.0}]}
//! ```
//!
//! where `time` is `absent`, `approximate`, `conservative` or `exact`, and `call_ns` is what a call takes that has nothing
//! to do. Then, again and again, it reads a line such as
//!
//! ```json
//! {"method": "TI", "kind": "vf", "queries": 128, "limit_ns": 1000000}
//! ```
//!
//! and 24 little-endian `f64` for each query, the points at t = 0 and then at t = 1. It answers the queries in order, and stops
//! after the one during which the limit is passed. It writes a line with the number of queries that it answered and, for
//! each, three little-endian `f64`: the nanoseconds that it took, 1 for contact or 0, and the time of contact or NaN. It ends when its
//! input does.

use std::cell::RefCell;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::rc::Rc;
use std::time::Duration;

use exact_ccd::Query;
use exact_ccd_methods::{Answer, Promise, Time};
use serde::{Deserialize, Serialize};

use super::contestant::Timed;
use crate::kind::DataKind;

/// A method of another program.
pub struct Peer {
    name: String,
    promise: Promise,
    call_nanoseconds: f64,
    process: Rc<RefCell<Process>>,
}

struct Process {
    command: String,
    child: Child,
    requests: BufWriter<ChildStdin>,
    answers: BufReader<ChildStdout>,
}

/// A program that should answer queries does not.
#[derive(Debug, thiserror::Error)]
pub enum PeerError {
    /// The command is not one.
    #[error("{command}: cannot be split into words")]
    Command {
        /// The command.
        command: String,
    },
    /// It cannot be started, or its pipes broke.
    #[error("{command}: {source}")]
    Io {
        /// The command.
        command: String,
        /// What went wrong.
        source: io::Error,
    },
    /// It answers something else.
    #[error("{command}: expected {expected}, found {found:?}")]
    Answer {
        /// The command.
        command: String,
        /// What should have come.
        expected: &'static str,
        /// What came.
        found: String,
    },
}

/// A day.
const MOST_NANOSECONDS: f64 = 24.0 * 3600.0 * 1e9;

#[derive(Deserialize)]
struct Greeting {
    methods: Vec<Description>,
}

#[derive(Deserialize)]
struct Description {
    name: String,
    may_miss: bool,
    may_invent: bool,
    time: TimeName,
    call_ns: f64,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
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
    /// # Errors
    /// If it cannot be started, or does not say what its methods are.
    pub fn start(command: &str) -> Result<Vec<Self>, PeerError> {
        let words = shell_words::split(command).ok().filter(|words| !words.is_empty());
        let Some([program, arguments @ ..]) = words.as_deref() else {
            let command = command.to_owned();
            return Err(PeerError::Command { command });
        };
        let io = |source| PeerError::Io {
            command: command.to_owned(),
            source,
        };
        let mut child = Command::new(program)
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(io)?;
        let (requests, answers) = child
            .stdin
            .take()
            .zip(child.stdout.take())
            .ok_or_else(|| io(io::ErrorKind::BrokenPipe.into()))?;
        let mut process = Process {
            command: command.to_owned(),
            child,
            requests: BufWriter::new(requests),
            answers: BufReader::new(answers),
        };
        let line = process.line()?;
        let greeting: Greeting =
            serde_json::from_str(&line).map_err(|_| process.unexpected("a line with its methods", &line))?;
        let process = Rc::new(RefCell::new(process));
        let peer = |description: Description| Self {
            name: description.name,
            promise: Promise {
                may_miss: description.may_miss,
                may_invent: description.may_invent,
                time: match description.time {
                    TimeName::Absent => Time::Absent,
                    TimeName::Approximate => Time::Approximate,
                    TimeName::Conservative => Time::Conservative,
                    TimeName::Exact => Time::Exact,
                },
            },
            call_nanoseconds: description.call_ns,
            process: Rc::clone(&process),
        };
        Ok(greeting.methods.into_iter().map(peer).collect())
    }

    /// The name in tables.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What its answers are worth.
    #[must_use]
    pub fn promise(&self) -> Promise {
        self.promise
    }

    /// What a call takes that does nothing, in nanoseconds: it is part of all times of this method.
    #[must_use]
    pub fn call_nanoseconds(&self) -> f64 {
        self.call_nanoseconds
    }

    pub(super) fn answer<K: DataKind>(
        &mut self,
        queries: &[Query<K>],
        limit: Duration,
    ) -> Result<Vec<Timed>, PeerError> {
        let mut process = self.process.borrow_mut();
        let request = Request {
            method: &self.name,
            kind: K::SHORT,
            queries: queries.len(),
            limit_ns: u64::try_from(limit.as_nanos()).unwrap_or(u64::MAX),
        };
        process
            .ask(&request, queries)
            .map_err(|source| process.io(source))?;
        let line = process.line()?;
        let answered = line
            .trim()
            .parse()
            .ok()
            .filter(|answered| (1..=queries.len()).contains(answered));
        let answered = answered.ok_or_else(|| process.unexpected("how many queries it answered", &line))?;
        (0..answered).map(|_| process.timed()).collect()
    }
}

impl Process {
    fn io(&self, source: io::Error) -> PeerError {
        let command = self.command.clone();
        PeerError::Io { command, source }
    }

    fn unexpected(&self, expected: &'static str, found: &str) -> PeerError {
        PeerError::Answer {
            command: self.command.clone(),
            expected,
            found: found.chars().take(80).collect(),
        }
    }

    fn line(&mut self) -> Result<String, PeerError> {
        let mut line = String::new();
        let read = self.answers.read_line(&mut line);
        match read.map_err(|source| self.io(source))? {
            0 => Err(self.io(io::Error::new(io::ErrorKind::UnexpectedEof, "it has ended"))),
            _ => Ok(line),
        }
    }

    fn ask<K: DataKind>(&mut self, request: &Request<'_>, queries: &[Query<K>]) -> io::Result<()> {
        serde_json::to_writer(&mut self.requests, request)?;
        self.requests.write_all(b"\n")?;
        for x in queries
            .iter()
            .flat_map(|query| query.points().as_flattened().as_flattened())
        {
            self.requests.write_all(&x.to_le_bytes())?;
        }
        self.requests.flush()
    }

    fn timed(&mut self) -> Result<Timed, PeerError> {
        let mut bytes = [[0; 8]; 3];
        self.answers
            .read_exact(bytes.as_flattened_mut())
            .map_err(|source| self.io(source))?;
        let [nanoseconds, contact, time] = bytes.map(f64::from_le_bytes);
        let answer = match (contact, time) {
            (0.0, _) => Some(Answer::Free),
            (1.0, time) if time.is_nan() => Some(Answer::Contact { time: None }),
            (1.0, 0.0..=1.0) => Some(Answer::Contact { time: Some(time) }),
            _ => None,
        };
        let answer = answer.filter(|_| (0.0..=MOST_NANOSECONDS).contains(&nanoseconds));
        let answer = answer.ok_or_else(|| {
            let expected = "nanoseconds from 0, contact 0 or 1, and a time from 0 to 1 or NaN";
            self.unexpected(expected, &format!("{nanoseconds} {contact} {time}"))
        })?;
        Ok(Timed { answer, nanoseconds })
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // It ends when its input does, or now.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
