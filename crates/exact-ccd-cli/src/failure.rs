//! Errors of the program.

use std::io;
use std::path::{Path, PathBuf};

use exact_ccd_bench::comparison::PeerError;
use exact_ccd_data::DataError;
use exact_ccd_files::{ReadError, ReadMotionError};
use exact_ccd_mesh::{CandidateError, StepError, ThicknessCount};
use exact_ccd_methods::UnknownMethod;
use exact_ccd_methods::parity::RoundingError;
use exact_ccd_sim::SimulationError;
use exact_ccd_sim::scene::SceneError;
use exact_ccd_view::PageError;

use crate::inputs::InputError;
use crate::kind::Kind;

/// The reason why the program has no answer.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    #[error(transparent)]
    Input(#[from] InputError),
    #[error(transparent)]
    Data(#[from] DataError),
    #[error(transparent)]
    Mesh(#[from] ReadError),
    #[error(transparent)]
    Motion(#[from] ReadMotionError),
    #[error(transparent)]
    Step(#[from] StepError),
    #[error(transparent)]
    Candidates(#[from] CandidateError),
    #[error(transparent)]
    Thickness(#[from] ThicknessCount),
    #[error("{}, query {query}: {source}", file.display())]
    Query {
        file: PathBuf,
        /// The number of the query in the file, from 0.
        query: usize,
        source: RoundingError,
    },
    #[error(transparent)]
    Rounding(#[from] RoundingError),
    #[error(
        "{}: expected a .ply, .obj, .stl, .off, .msh or .vtu file, or --kind for a query file",
        .0.display()
    )]
    KindMissing(PathBuf),
    #[error(
        "{}: the kind of the queries is not certain from the file; --kind vf|ee|ve|vv names it",
        .0.display()
    )]
    KindUncertain(PathBuf),
    #[error("{}: queries of the kind {kind}, after others of the kind {other}", file.display())]
    KindsDiffer { file: PathBuf, kind: Kind, other: Kind },
    #[error("--json needs a file of --output: with -, standard output has the queries")]
    TwoAnswers,
    #[error("0 queries: the input is empty")]
    NoQueries,
    #[error("{}: a folder is a scene, which has queries of the kinds vf and ee, not {kind}", folder.display())]
    NoPairs { folder: PathBuf, kind: &'static str },
    #[error("two meshes would be written to {}", .0.display())]
    SameOutput(PathBuf),
    #[error(transparent)]
    Peer(#[from] PeerError),
    #[error("there are two methods called {0}")]
    SameMethod(String),
    #[error(transparent)]
    Method(#[from] UnknownMethod),
    #[error("--kind {kind} needs --method exact: the method {method} has the kinds vf and ee")]
    MethodKind { method: String, kind: Kind },
    #[error("--min-distance above 0 needs --method exact: the method {method} decides contact")]
    MethodDistance { method: String },
    #[error(
        "{}: expected folders `edge-edge` or `vertex-face` with .csv or .parquet files, \
         or `frames` with meshes",
        .0.display()
    )]
    NoDataSet(PathBuf),
    #[error("{}: expected meshes of one format, such as .ply, .obj, .stl or .vtu", .0.display())]
    NoFrames(PathBuf),
    #[error(
        "the order of {} and {} is not certain: the point in their numbers may be that of a decimal, or between \
         two numbers; give the files in order with --as-given, or give all numbers the same number of digits",
        .0[0].display(),
        .0[1].display()
    )]
    UncertainOrder([PathBuf; 2]),
    #[error("{}: --as-given needs files: those of a folder are not given in an order", .0.display())]
    FolderAsGiven(PathBuf),
    #[error("{}: {}", file.display(), frame_count(*count, *expected))]
    FrameCount {
        file: PathBuf,
        expected: usize,
        count: usize,
    },
    #[error("{}: there is no end to this start: expected pairs of files, START END", .0.display())]
    NoEnd(PathBuf),
    #[error(
        "{file}: {read}: without a face or an edge, there is nothing that can touch; \
         --min-distance D compares points"
    )]
    OnlyPoints { file: String, read: String },
    #[error("there is no part or group {name}; there are {}", listed(known))]
    UnknownPart { name: String, known: Vec<String> },
    #[error("several parts have a group {name}: its names are {}, {} and so on", long[0], long[1])]
    SameGroup { name: String, long: [String; 2] },
    #[error("{}: {count} frames, expected {expected} as of {first}, or 1 of a mesh at rest", file.display())]
    SeriesLength {
        file: PathBuf,
        count: usize,
        first: String,
        expected: usize,
    },
    #[error("--only {0}: both are obstacles, which are not compared with each other: name a part that moves")]
    OnlyObstacles(String),
    #[error("all parts together have more than 2^32 vertices")]
    TooManyVertices,
    #[error("the parts together: {0}")]
    Join(exact_ccd_mesh::MeshError),
    #[error("{}: expected a scene of IPC, whose name ends in .txt or .ipc, or of PolyFEM, in .json", .0.display())]
    NotForeign(PathBuf),
    #[error(transparent)]
    Scene(#[from] SceneError),
    #[error(transparent)]
    Simulation(#[from] SimulationError),
    #[error(transparent)]
    Page(#[from] PageError),
    #[error("there is no query {0} to show: expected a number from 0 below that of the queries")]
    NoQuery(usize),
    #[error("{}: {message}", file.display())]
    Checkpoint { file: PathBuf, message: String },
    #[error(
        "{}: the folder has the results of an earlier run: \
         continue it with --resume, or replace it with --overwrite",
        .0.display()
    )]
    Results(PathBuf),
    #[error(
        "time step {step} did not converge, expected convergence with --strict: set a smaller `time-step`, \
         a larger `max-iterations`, or `max-substeps`"
    )]
    NotConverged { step: u64 },
    #[error("{}: {source}", file.display())]
    Log { file: PathBuf, source: csv::Error },
    #[error("cannot start the threads: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    #[error("cannot write {}: {source}{}", file.display(), remedy(source))]
    Write { file: PathBuf, source: io::Error },
    #[error("cannot write the answer: {0}")]
    Output(#[from] io::Error),
}

/// The end of a message about a file that cannot be written: an instruction.
fn remedy(source: &io::Error) -> &'static str {
    match source.kind() {
        io::ErrorKind::NotFound => "; make its folder first",
        io::ErrorKind::IsADirectory => "; name a file, as there is a folder of this name",
        io::ErrorKind::AlreadyExists | io::ErrorKind::NotADirectory => {
            "; name another folder, as there is a file of this name"
        }
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            "; name a folder in which files may be written"
        }
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "; the disk is full",
        _ => "",
    }
}

/// The message for a number of frames that a step cannot have.
fn frame_count(count: usize, expected: usize) -> String {
    let remedy = if count < expected {
        "add the file of the end"
    } else {
        "`exact-ccd audit` examines longer motions"
    };
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} frame{plural}, expected {expected}; {remedy}")
}

/// The number of names that a message lists.
const LISTED: usize = 20;

/// The first names, as a list.
pub(crate) fn listed(names: &[String]) -> String {
    let more = if names.len() > LISTED { ", and others" } else { "" };
    names[..names.len().min(LISTED)].join(", ") + more
}

impl Failure {
    pub(crate) fn write(file: &Path, source: io::Error) -> Self {
        let file = file.to_owned();
        Self::Write { file, source }
    }

    pub(crate) fn query(file: &Path, query: usize, source: RoundingError) -> Self {
        let file = file.to_owned();
        Self::Query { file, query, source }
    }

    /// The message on one line. Control characters, which names of files may have, become spaces.
    pub(crate) fn on_one_line(&self) -> String {
        self.to_string().replace(char::is_control, " ")
    }

    /// A closed pipe, as in `exact-ccd queries FILE | head`, is not a failure.
    pub(crate) fn unless_closed_pipe(self) -> Result<(), Self> {
        match self {
            Self::Output(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            failure => Err(failure),
        }
    }
}
