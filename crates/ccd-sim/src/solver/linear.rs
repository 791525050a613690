//! The sparse linear system of a Newton iteration.

use faer::linalg::solvers::Solve;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{Col, Side};

use super::pattern::Pattern;

/// Factorises symmetric positive definite matrices, and keeps the analysis of a pattern for as long as it stays the same.
///
/// What it keeps is a function of the pattern: results do not depend on what was solved before.
#[derive(Clone, Default)]
pub(crate) struct LinearSolver {
    analysis: Option<Analysis>,
}

#[derive(Clone)]
struct Analysis {
    pattern: Pattern,
    scalars: SymbolicSparseColMat<usize>,
    symbolic: SymbolicLlt<usize>,
}

/// How often the diagonal is raised when rounding has spoilt positive definiteness.
const ATTEMPTS: i32 = 8;

impl LinearSolver {
    /// The solution of a system, or `None` if there is none within reach of a small shift of the diagonal.
    pub(crate) fn solve(
        &mut self,
        pattern: Pattern,
        mut values: Vec<f64>,
        right: &[f64],
    ) -> Option<Vec<f64>> {
        if self
            .analysis
            .as_ref()
            .is_none_or(|analysis| analysis.pattern != pattern)
        {
            let scalars = pattern.scalars();
            let symbolic = SymbolicLlt::try_new(scalars.as_ref(), Side::Lower).ok()?;
            self.analysis = Some(Analysis {
                pattern,
                scalars,
                symbolic,
            });
        }
        let analysis = self.analysis.as_ref()?;
        if values.iter().chain(right).any(|value| !value.is_finite()) {
            return None;
        }
        let diagonals = &analysis.scalars.col_ptr()[..right.len()];
        let largest = diagonals
            .iter()
            .fold(0.0_f64, |largest, &place| largest.max(values[place]));
        for attempt in 0..ATTEMPTS {
            let matrix = SparseColMatRef::new(analysis.scalars.as_ref(), values.as_slice());
            if let Ok(factors) = Llt::try_new_with_symbolic(analysis.symbolic.clone(), matrix, Side::Lower) {
                let solution = factors.solve(Col::from_fn(right.len(), |row| right[row]));
                return Some(solution.iter().copied().collect());
            }
            let shift = largest * f64::EPSILON * 10_f64.powi(attempt);
            for &place in diagonals {
                values[place] += shift;
            }
        }
        None
    }
}
