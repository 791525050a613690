//! The barrier that keeps things apart.

/// The smoothly clamped logarithmic barrier b(d) = −(d − d̂)² ln(d/d̂) for d < d̂, else 0, of squared distances: M. Li,
/// Z. Ferguson, T. Schneider, T. Langlois, D. Zorin, D. Panozzo, C. Jiang, D. Kaufman, *Incremental Potential Contact*, ACM
/// Transactions on Graphics 39(4), 2020, equation 6, with the squares of its supplement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Barrier {
    reach: f64,
}

impl Barrier {
    /// The barrier that begins at a distance, in m.
    #[must_use]
    pub fn new(distance: f64) -> Self {
        let reach = distance * distance;
        Self { reach }
    }

    /// The squared distance d̂ at which it begins, in m².
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// b, in m⁴; infinite for d ≤ 0.
    #[must_use]
    pub fn value(&self, squared: f64) -> f64 {
        if squared >= self.reach {
            0.0
        } else if squared <= 0.0 {
            f64::INFINITY
        } else {
            let gap = squared - self.reach;
            -gap * gap * (squared / self.reach).ln()
        }
    }

    /// b′, in m².
    #[must_use]
    pub fn slope(&self, squared: f64) -> f64 {
        if squared >= self.reach {
            return 0.0;
        }
        let gap = self.reach - squared;
        gap * (2.0 * (squared / self.reach).ln() - gap / squared)
    }

    /// b″.
    #[must_use]
    pub fn curvature(&self, squared: f64) -> f64 {
        if squared >= self.reach {
            return 0.0;
        }
        let ratio = self.reach / squared;
        (ratio + 2.0) * ratio - 2.0 * (squared / self.reach).ln() - 3.0
    }
}
