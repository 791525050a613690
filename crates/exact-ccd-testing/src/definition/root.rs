//! Real roots in [0, 1], each as an interval that contains no other root of its polynomial.

use std::cell::OnceCell;
use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::rc::Rc;

use super::polynomial::Polynomial;
use super::sturm::Sturm;
use super::time::Time;

/// The time `low`, if both times are equal, otherwise the only root of a polynomial strictly between them.
#[derive(Clone, Debug)]
pub(crate) struct Root {
    sturm: Rc<Sturm>,
    low: Time,
    high: Time,
}

/// A function of t: a polynomial with Sturm's chain, computed once.
#[derive(Debug)]
pub(crate) struct Function {
    polynomial: Polynomial,
    sturm: OnceCell<Rc<Sturm>>,
}

impl Function {
    pub(crate) fn new(polynomial: Polynomial) -> Self {
        Self {
            polynomial,
            sturm: OnceCell::new(),
        }
    }

    fn sturm(&self) -> &Rc<Sturm> {
        self.sturm.get_or_init(|| Rc::new(Sturm::new(&self.polynomial)))
    }
}

/// The roots in [0, 1] of a function; none if it is zero.
pub(crate) fn isolate(function: &Function) -> Vec<Root> {
    if function.polynomial.is_zero() {
        return vec![];
    }
    let sturm = function.sturm();
    let mut roots = Vec::new();
    for end in [Time::zero(), Time::one()] {
        if sturm.is_root(&end) {
            roots.push(Root::at(end));
        }
    }
    isolate_between(sturm, [Time::zero(), Time::one()], &mut roots);
    roots
}

fn isolate_between(sturm: &Rc<Sturm>, [low, high]: [Time; 2], roots: &mut Vec<Root>) {
    let sturm = sturm.clone();
    match sturm.count_between(&low, &high) {
        0 => {}
        1 => roots.push(Root { sturm, low, high }),
        _ => {
            let middle = Time::between(&low, &high);
            if sturm.is_root(&middle) {
                roots.push(Root::at(middle.clone()));
            }
            isolate_between(&sturm, [low, middle.clone()], roots);
            isolate_between(&sturm, [middle, high], roots);
        }
    }
}

/// The number of halvings after which two roots that are not separated are compared by their common divisor.
/// Fewer halvings separate most roots, and cost less than the divisor.
const PATIENCE: usize = 8;

/// The common roots of two polynomials.
fn common(a: &Sturm, b: &Sturm) -> Sturm {
    Sturm::new(&a.simple().gcd(b.simple()))
}

/// A time strictly between the roots i and i + 1 of a sorted list.
pub(crate) fn between(roots: &mut [Root], i: usize) -> Time {
    loop {
        let (end, start) = (roots[i].high.clone(), roots[i + 1].low.clone());
        if end < start {
            return Time::between(&end, &start);
        }
        if end == start && !roots[i].is_point() && !roots[i + 1].is_point() {
            return end;
        }
        roots[i].halve();
        roots[i + 1].halve();
    }
}

impl Root {
    /// A time as a root.
    pub(crate) fn at(time: Time) -> Self {
        Self {
            sturm: Rc::new(Sturm::new(&Polynomial::new(vec![1.into()]))),
            low: time.clone(),
            high: time,
        }
    }

    fn is_point(&self) -> bool {
        self.low == self.high
    }

    fn halve(&mut self) {
        if !self.is_point() {
            self.compare_to_time(&Time::between(&self.low, &self.high));
        }
    }

    /// The order of the root and a time. The interval becomes that part of it in which the root is.
    fn compare_to_time(&mut self, t: &Time) -> Ordering {
        if self.is_point() || *t <= self.low || self.high <= *t {
            // A root between two times is not one of them.
            return if self.is_point() {
                self.low.cmp(t)
            } else if *t <= self.low {
                Greater
            } else {
                Less
            };
        }
        // The polynomial changes its sign at the root, and nowhere else in the interval. It may have other
        // roots at its ends only.
        let [sign, end] = [t, &self.high].map(|t| self.sturm.simple().sign_at(t));
        let is_less = || {
            if end == Equal {
                self.sturm.count(&self.low, t) == 1
            } else {
                sign == end
            }
        };
        if sign == Equal {
            (self.low, self.high) = (t.clone(), t.clone());
            Equal
        } else if is_less() {
            self.high = t.clone();
            Less
        } else {
            self.low = t.clone();
            Greater
        }
    }

    /// The order of two roots.
    pub(crate) fn compare(&mut self, other: &mut Self) -> Ordering {
        if other.is_point() {
            return self.compare_to_time(&other.low);
        }
        if self.is_point() {
            return other.compare_to_time(&self.low).reverse();
        }
        for halvings in 0.. {
            // Of two equal times, neither is before the other.
            if self.is_point() || other.is_point() {
                return self.compare(other);
            }
            if self.high <= other.low {
                return Less;
            }
            if other.high <= self.low {
                return Greater;
            }
            let low = self.low.clone().max(other.low.clone());
            let high = self.high.clone().min(other.high.clone());
            if halvings == PATIENCE && common(&self.sturm, &other.sturm).count_between(&low, &high) > 0 {
                return Equal;
            }
            self.halve();
            other.halve();
        }
        unreachable!("halvings have no end")
    }

    /// The sign of a function at the root.
    pub(crate) fn sign_of(&mut self, function: &Function) -> Ordering {
        let polynomial = &function.polynomial;
        if polynomial.is_zero() {
            return Equal;
        }
        let zeros = function.sturm();
        for halvings in 0.. {
            // At a time, or where it has no zero around the root.
            if self.is_point() || zeros.count_closed(&self.low, &self.high) == 0 {
                return polynomial.sign_at(&self.low);
            }
            if halvings == PATIENCE && common(&self.sturm, zeros).count_between(&self.low, &self.high) > 0 {
                return Equal;
            }
            // Longer and longer without a look at the other zeros.
            (0..=halvings).for_each(|_| self.halve());
        }
        unreachable!("halvings have no end")
    }

    /// The largest f64 that is not above the root, and true if it is the root.
    pub(crate) fn rounded_down(&mut self) -> (f64, bool) {
        // The numbers of at least 0 are in the order of their bits.
        let (mut below, mut above) = (0.0f64.to_bits(), 1.0f64.to_bits() + 1);
        while above - below > 1 {
            let middle = below.midpoint(above);
            match self.compare_to_time(&Time::from_f64(f64::from_bits(middle))) {
                Less => above = middle,
                Equal | Greater => below = middle,
            }
        }
        let t = f64::from_bits(below);
        (t, self.compare_to_time(&Time::from_f64(t)) == Equal)
    }
}
