//! The cost of a query: on every candidate of the broad phase in order, and on the colliding ones
//! with all contact times and the impact.
//!
//! `cargo bench -p exact-ccd-bench --bench kernel [-- SCENE...]`, on one thread, over the published
//! data sets.
//!
//! The scenes and kinds take turns for some rounds; a figure is the median over the rounds. A single
//! query is built from the positions of the mesh each time, as in a simulator; a batch has the same
//! queries by their vertices. The time of one colliding query is the least of some attempts, so that
//! the worst time is due to a query and not to the scheduler.

#![expect(clippy::print_stdout, reason = "this is its output")]

mod published;

use std::hint::black_box;

use exact_ccd::batch::Trajectories;
use exact_ccd::{AnyKind, CONTACT, EdgeEdge, Query, Stage, VertexFace};
use exact_ccd_bench::{mean, median, nanoseconds, nanoseconds_each, quantile};
use exact_ccd_data::{DataError, DataKind};
use exact_ccd_mesh::{BoxKind, Bvh, CandidateOptions, Candidates, Motion, Step};

const ROUNDS: usize = 7;
/// The number of colliding queries that the exact path answers.
const AUDITED: usize = 1000;

fn main() -> Result<(), DataError> {
    let motions = published::motions()?;
    let mut batches: Vec<Batch<'_>> = motions.iter().flat_map(batches).collect();
    for round in 1..=ROUNDS {
        eprintln!("round {round} of {ROUNDS}");
        batches.iter_mut().for_each(Batch::time_all);
    }
    print_candidates(&batches);
    print_stages(&batches);
    print_colliding(&batches);
    Ok(())
}

/// Candidates of one kind in one scene, and their measurements. All times are in nanoseconds.
#[derive(Clone)]
struct Batch<'a> {
    name: String,
    step: Step<'a>,
    pairs: Vec<[u32; 2]>,
    functions: Functions,
    trajectories: Trajectories,
    vertices: Vec<[u32; 4]>,
    /// The mean over all candidates, round by round.
    means: Vec<f64>,
    /// The mean over all candidates as a batch, round by round.
    batch_means: Vec<f64>,
    /// The mean as a batch, with the count and all contact times of the colliding candidates.
    batch_times_means: Vec<f64>,
    survey: Survey,
}

/// The results of each candidate.
#[derive(Clone, Default)]
struct Survey {
    /// The number of candidates that were settled at each stage.
    settled: [usize; Stage::ALL.len()],
    colliding: Colliding,
}

/// The times of the colliding queries.
#[derive(Clone, Default)]
struct Colliding {
    /// The search for all contact times, which also gives the count and the time of impact.
    times: Vec<f64>,
    /// The same without the queries that take the exact path.
    times_filtered: Vec<f64>,
    impacts: Vec<f64>,
    /// The exact path on some of them.
    exact: Vec<f64>,
}

/// The common interface of the two kinds of query. The measured code is inlined for each.
#[derive(Clone, Copy)]
struct Functions {
    count_collisions: fn(&Step<'_>, &[[u32; 2]]) -> usize,
    count_batch: fn(&Trajectories, &[[u32; 4]]) -> usize,
    count_times_of_batch: fn(&Trajectories, &[[u32; 4]]) -> usize,
    survey: fn(&Step<'_>, &[[u32; 2]]) -> Survey,
}

fn batches((name, motion): &(String, Motion)) -> [Batch<'_>; 2] {
    let step = motion.step().expect("the frames of a scene are sound");
    let options = CandidateOptions::default().with_boxes(BoxKind::Swept);
    let candidates = Candidates::with_options(step, &Bvh, &options).expect("the default distances are 0");
    [
        Batch::new::<VertexFace>(name, step, candidates.of_kind(AnyKind::VertexFace)),
        Batch::new::<EdgeEdge>(name, step, candidates.of_kind(AnyKind::EdgeEdge)),
    ]
}

impl<'a> Batch<'a> {
    fn new<K: DataKind>(scene: &str, step: Step<'a>, pairs: &[[u32; 2]]) -> Self {
        let functions = Functions {
            count_collisions: count_collisions::<K>,
            count_batch: count_batch::<K>,
            count_times_of_batch: count_times_of_batch::<K>,
            survey: survey::<K>,
        };
        let [x0, x1] = step.positions();
        Self {
            name: format!("{scene} {}", K::KIND.short()),
            step,
            pairs: pairs.to_vec(),
            functions,
            trajectories: Trajectories::new(x0, x1).expect("the frames of a scene are sound"),
            vertices: pairs
                .iter()
                .filter_map(|&pair| K::vertices(step.mesh(), pair))
                .collect(),
            means: Vec::new(),
            batch_means: Vec::new(),
            batch_times_means: Vec::new(),
            survey: (functions.survey)(&step, pairs),
        }
    }

    fn time_all(&mut self) {
        let Functions {
            count_collisions,
            count_batch,
            count_times_of_batch,
            ..
        } = self.functions;
        let (step, pairs) = (&self.step, &self.pairs[..]);
        let (trajectories, vertices) = (&self.trajectories, &self.vertices[..]);
        let mean = |count: &dyn Fn() -> usize| nanoseconds_each(pairs.len(), count);
        self.means
            .push(mean(&|| count_collisions(step, black_box(pairs))));
        self.batch_means
            .push(mean(&|| count_batch(trajectories, black_box(vertices))));
        self.batch_times_means
            .push(mean(&|| count_times_of_batch(trajectories, black_box(vertices))));
    }
}

fn count_batch<K: DataKind>(trajectories: &Trajectories, vertices: &[[u32; 4]]) -> usize {
    let mut count = 0;
    trajectories
        .collisions::<K>(vertices, CONTACT, |_, _| count += 1)
        .expect("all vertices are there");
    count
}

fn count_times_of_batch<K: DataKind>(trajectories: &Trajectories, vertices: &[[u32; 4]]) -> usize {
    let mut count = 0;
    trajectories
        .collisions::<K>(vertices, CONTACT, |_, collision| {
            count += black_box(collision.intervals()).len();
        })
        .expect("all vertices are there");
    count
}

fn count_collisions<K: DataKind>(step: &Step<'_>, pairs: &[[u32; 2]]) -> usize {
    pairs
        .iter()
        .filter_map(|&pair| step.query::<K>(pair))
        .filter(|query| query.collides(CONTACT))
        .count()
}

fn survey<K: DataKind>(step: &Step<'_>, pairs: &[[u32; 2]]) -> Survey {
    let mut survey = Survey::default();
    for query in pairs.iter().filter_map(|&pair| step.query::<K>(pair)) {
        let (collision, stage) = query.decide(CONTACT);
        survey.settled[stage as usize] += 1;
        if collision.is_some() {
            survey.colliding.time(&query, stage);
        }
    }
    survey
}

impl Colliding {
    fn time<K: DataKind>(&mut self, query: &Query<K>, stage: Stage) {
        let times = nanoseconds(|| query.intervals(CONTACT));
        self.times.push(times);
        if stage != Stage::Exact {
            self.times_filtered.push(times);
        }
        self.impacts.push(nanoseconds(|| query.impact(CONTACT)));
        if self.exact.len() < AUDITED {
            self.exact
                .push(nanoseconds(|| query.exactly().intervals(CONTACT)));
        }
    }
}

fn print_candidates(batches: &[Batch<'_>]) {
    println!("All candidates in order, mean ns of the decision.\n");
    println!("| scene and kind | candidates | batch | batch with count and times | one by one |");
    println!("|---|---:|---:|---:|---:|");
    for batch in batches {
        println!(
            "| {} | {} | {:.1} | {:.1} | {:.0} |",
            batch.name,
            batch.pairs.len(),
            median(&batch.batch_means),
            median(&batch.batch_times_means),
            median(&batch.means)
        );
    }
}

fn print_stages(batches: &[Batch<'_>]) {
    // The stages of a distance query settle no query of contact.
    let of_contact = |stage: &&Stage| !matches!(stage, Stage::Start | Stage::Advancement | Stage::Crossing);
    let stages: Vec<Stage> = Stage::ALL.iter().filter(of_contact).copied().collect();
    println!(
        "\nSettled at each stage, in %; the last column is the exact path's share of those past the box.\n"
    );
    println!(
        "| scene and kind | {} | exact past box |",
        stages
            .iter()
            .map(Stage::to_string)
            .collect::<Vec<_>>()
            .join(" | ")
    );
    println!("|---|{}---:|", "---:|".repeat(stages.len()));
    for Batch { name, survey, .. } in batches {
        let count = |stage: Stage| survey.settled[stage as usize] as f64;
        let all: f64 = Stage::ALL.iter().map(|&stage| count(stage)).sum();
        let shares = stages
            .iter()
            .map(|&stage| format!("{:.3}", 100.0 * count(stage) / all))
            .collect::<Vec<_>>()
            .join(" | ");
        let past_box = 100.0 * count(Stage::Exact) / (all - count(Stage::BoundingBox));
        println!("| {name} | {shares} | {past_box:.3} |");
    }
}

fn print_colliding(batches: &[Batch<'_>]) {
    println!("\nColliding queries, one by one, in ns: count and all contact times, then the impact.\n");
    println!(
        "| scene and kind | colliding | mean | median | worst | exact | mean without | worst without | \
         impact mean | exact path median |"
    );
    println!("|---|{}", "---:|".repeat(9));
    for Batch { name, survey, .. } in batches {
        let Colliding {
            times,
            times_filtered,
            impacts,
            exact,
        } = &survey.colliding;
        println!(
            "| {name} | {} | {:.0} | {:.0} | {:.0} | {} | {:.0} | {:.0} | {:.0} | {:.0} |",
            times.len(),
            mean(times),
            median(times),
            quantile(times, 1.0),
            times.len() - times_filtered.len(),
            mean(times_filtered),
            quantile(times_filtered, 1.0),
            mean(impacts),
            median(exact),
        );
    }
}
