//! The barrier function.

/// The smoothly clamped logarithmic barrier b(d) = −(d − d̂)² ln(d/d̂) for d < d̂, else 0.
///
/// Source: M. Li, Z. Ferguson, T. Schneider, T. Langlois, D. Zorin, D. Panozzo, C. Jiang, D. Kaufman,
/// *Incremental Potential Contact*, ACM Transactions on Graphics 39(4), 2020, equation 6. As in the
/// supplement of the paper, d and d̂ are squared distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Barrier {
    activation_distance_squared: f64,
}

impl Barrier {
    /// The barrier with this activation distance, in m.
    #[must_use]
    pub fn new(activation_distance: f64) -> Self {
        Self {
            activation_distance_squared: activation_distance * activation_distance,
        }
    }

    /// d̂: the square of the activation distance, in m².
    #[must_use]
    pub fn activation_distance_squared(&self) -> f64 {
        self.activation_distance_squared
    }

    /// The value b of the barrier at a squared distance, in m⁴. Infinite for d ≤ 0.
    #[must_use]
    pub fn value(&self, squared: f64) -> f64 {
        let d_hat = self.activation_distance_squared;
        if squared >= d_hat {
            0.0
        } else if squared <= 0.0 {
            f64::INFINITY
        } else {
            let gap = squared - d_hat;
            -gap * gap * (squared / d_hat).ln()
        }
    }

    /// The first derivative b′ by the squared distance, in m².
    #[must_use]
    pub fn slope(&self, squared: f64) -> f64 {
        let d_hat = self.activation_distance_squared;
        if squared >= d_hat {
            return 0.0;
        }
        let gap = d_hat - squared;
        gap * (2.0 * (squared / d_hat).ln() - gap / squared)
    }

    /// The second derivative b″ by the squared distance.
    #[must_use]
    pub fn curvature(&self, squared: f64) -> f64 {
        let d_hat = self.activation_distance_squared;
        if squared >= d_hat {
            return 0.0;
        }
        let ratio = d_hat / squared;
        (ratio + 2.0) * ratio - 2.0 * (squared / d_hat).ln() - 3.0
    }
}
