//! The sparse linear system of a Newton iteration.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::PermRef;
use faer::sparse::linalg::amd;
use faer::sparse::linalg::cholesky::{SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{Conj, MatMut, Par, Side};

use super::pattern::Pattern;

/// A sparse Cholesky solver, which reuses the symbolic analysis while the pattern stays the same.
///
/// The analysis is a function of the pattern alone, so results do not depend on earlier systems.
#[derive(Default)]
pub(crate) struct LinearSolver {
    analysis: Option<Analysis>,
    /// The memory of the numeric factor.
    factor: Vec<f64>,
}

struct Analysis {
    pattern: Pattern,
    scalars: SymbolicSparseColMat<usize>,
    symbolic: SymbolicCholesky<usize>,
}

/// The maximal number of factorisations. Rounding can make one fail; the next has a larger diagonal.
const ATTEMPTS: i32 = 8;

impl LinearSolver {
    /// The pattern of the last system.
    pub(crate) fn pattern(&self) -> Option<&Pattern> {
        self.analysis.as_ref().map(|analysis| &analysis.pattern)
    }

    /// The solution of a system. `None` if a value is not finite, or if the matrix is not positive definite
    /// even with a slightly increased diagonal.
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
            self.analysis = Some(Analysis::new(pattern)?);
        }
        let Analysis {
            scalars, symbolic, ..
        } = self.analysis.as_ref()?;
        if values.iter().chain(right).any(|value| !value.is_finite()) {
            return None;
        }
        let diagonals = &scalars.col_ptr()[..right.len()];
        let largest = diagonals
            .iter()
            .fold(0.0_f64, |largest, &place| largest.max(values[place]));

        self.factor.resize(symbolic.len_val(), 0.0);
        // A single thread, because the order of sums must not depend on the number of threads.
        let par = Par::Seq;
        let scratch = symbolic
            .factorize_numeric_llt_scratch::<f64>(par, Default::default())
            .or(symbolic.solve_in_place_scratch::<f64>(1, par));
        let mut memory = MemBuffer::try_new(scratch).ok()?;
        for attempt in 0..ATTEMPTS {
            let matrix = SparseColMatRef::new(scalars.as_ref(), values.as_slice());
            let factorised = symbolic.factorize_numeric_llt(
                &mut self.factor,
                matrix,
                Side::Lower,
                Default::default(),
                par,
                MemStack::new(&mut memory),
                Default::default(),
            );
            if let Ok(factor) = factorised {
                let mut solution = right.to_vec();
                let column = MatMut::from_column_major_slice_mut(&mut solution, right.len(), 1);
                factor.solve_in_place_with_conj(Conj::No, column, par, MemStack::new(&mut memory));
                return Some(solution);
            }
            let shift = largest * f64::EPSILON * 10_f64.powi(attempt);
            for &place in diagonals {
                values[place] += shift;
            }
        }
        None
    }
}

impl Analysis {
    /// The analysis, with a fill-reducing order of the vertices. The three unknowns of a vertex stay
    /// together: they have the same neighbours, and a pattern of vertices has a ninth of the entries.
    fn new(pattern: Pattern) -> Option<Self> {
        let blocks = pattern.blocks();
        let count = blocks.ncols();
        let (mut order, mut place) = (vec![0; count], vec![0; count]);
        let scratch = amd::order_scratch::<usize>(count, blocks.compute_nnz());
        let mut memory = MemBuffer::try_new(scratch).ok()?;
        amd::order(
            &mut order,
            &mut place,
            blocks.as_ref(),
            amd::Control::default(),
            MemStack::new(&mut memory),
        )
        .ok()?;
        let [order, place] = [order, place].map(|blocks| {
            let scalars = blocks
                .into_iter()
                .flat_map(|block| [0, 1, 2].map(|axis: usize| 3 * block + axis));
            scalars.collect::<Vec<usize>>()
        });
        let scalars = pattern.scalars();
        let symbolic = factorize_symbolic_cholesky(
            scalars.as_ref(),
            Side::Lower,
            SymmetricOrdering::Custom(PermRef::new_checked(&order, &place, 3 * count)),
            Default::default(),
        )
        .ok()?;
        Some(Self {
            pattern,
            scalars,
            symbolic,
        })
    }
}
