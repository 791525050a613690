//! The search by hill climbing.

use fastrand::Rng;

/// The number of steps without a rise after which a climb begins anew.
const PATIENCE: usize = 150;

/// The result of a search.
pub(crate) struct Found<C> {
    /// The costliest candidate.
    pub(crate) worst: f64,
    pub(crate) at: C,
    /// The mean cost of the starts.
    pub(crate) mean: f64,
}

/// Climbs for a number of steps, each of which changes a candidate. The cost is none where a candidate is no
/// query.
pub(crate) fn climb<C: Clone>(
    random: &mut Rng,
    steps: u64,
    begin: impl Fn(&mut Rng) -> C,
    change: impl Fn(C, &mut Rng) -> C,
    cost: impl Fn(&C) -> Option<f64>,
) -> Found<C> {
    let mut found = Found {
        worst: 0.0,
        at: begin(random),
        mean: 0.0,
    };
    let (mut begun, mut total) = (0_u32, 0.0);
    let mut climber: Option<(f64, C, usize)> = None;
    for _ in 0..steps {
        let (least, candidate, rested) = match climber.take() {
            Some((least, candidate, rested)) if rested < PATIENCE => {
                let changed = change(candidate.clone(), random);
                match cost(&changed) {
                    Some(cost) if cost >= least => {
                        (cost, changed, if cost > 1.02 * least { 0 } else { rested + 1 })
                    }
                    _ => (least, candidate, rested + 1),
                }
            }
            _ => {
                let candidate = begin(random);
                let cost = cost(&candidate).unwrap_or_default();
                begun += 1;
                total += cost;
                (cost, candidate, 0)
            }
        };
        if least > found.worst {
            (found.worst, found.at) = (least, candidate.clone());
        }
        climber = Some((least, candidate, rested));
    }
    found.mean = total / f64::from(begun.max(1));
    found
}
