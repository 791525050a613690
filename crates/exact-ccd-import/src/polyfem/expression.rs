//! Functions of place and time.

use core::f64::consts::PI;

use exact_ccd_mesh::Point;

/// The deepest nesting of an expression.
const DEPTH: usize = 64;

/// The value of an expression of the time `t` and the place `x`, `y`, `z`: numbers, `pi`, `+ - * /`,
/// parentheses, and the functions `sin`, `cos`, `sqrt`, `abs`, `min`, `max` and `if`, whose second argument
/// counts where the first one is not negative, and otherwise the third one. `None` for any other text.
pub(super) fn value(text: &str, place: Point, t: f64) -> Option<f64> {
    let mut rest = Rest {
        text: text.trim_start(),
        place,
        t,
    };
    let value = rest.sum(DEPTH)?;
    (rest.text.is_empty() && value.is_finite()).then_some(value)
}

fn is_digit(c: char) -> bool {
    c.is_ascii_digit() || c == '.'
}

/// The text that is left.
struct Rest<'a> {
    text: &'a str,
    place: Point,
    t: f64,
}

impl Rest<'_> {
    /// Takes a character and the blanks after it.
    fn take(&mut self, character: char) -> bool {
        let rest = self.text.strip_prefix(character);
        if let Some(rest) = rest {
            self.text = rest.trim_start();
        }
        rest.is_some()
    }

    fn sum(&mut self, depth: usize) -> Option<f64> {
        let depth = depth.checked_sub(1)?;
        let mut sum = self.product(depth)?;
        loop {
            sum = if self.take('+') {
                sum + self.product(depth)?
            } else if self.take('-') {
                sum - self.product(depth)?
            } else {
                return Some(sum);
            }
        }
    }

    fn product(&mut self, depth: usize) -> Option<f64> {
        let mut product = self.signed(depth)?;
        loop {
            product = if self.take('*') {
                product * self.signed(depth)?
            } else if self.take('/') {
                product / self.signed(depth)?
            } else {
                return Some(product);
            }
        }
    }

    fn signed(&mut self, depth: usize) -> Option<f64> {
        let mut sign = 1.0;
        loop {
            if self.take('-') {
                sign = -sign;
            } else if !self.take('+') {
                return Some(sign * self.atom(depth)?);
            }
        }
    }

    fn atom(&mut self, depth: usize) -> Option<f64> {
        if self.take('(') {
            let value = self.sum(depth)?;
            return self.take(')').then_some(value);
        }
        if self.text.starts_with(is_digit) {
            return self.number();
        }
        let end = self.text.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        let (name, rest) = self.text.split_at(end.unwrap_or(self.text.len()));
        self.text = rest.trim_start();
        match name {
            "t" => return Some(self.t),
            "x" => return Some(self.place[0]),
            "y" => return Some(self.place[1]),
            "z" => return Some(self.place[2]),
            "pi" => return Some(PI),
            _ if !self.take('(') => return None,
            _ => {}
        }
        let mut arguments = vec![self.sum(depth)?];
        while self.take(',') {
            arguments.push(self.sum(depth)?);
        }
        if !self.take(')') {
            return None;
        }
        match (name, &arguments[..]) {
            ("sin", [a]) => Some(a.sin()),
            ("cos", [a]) => Some(a.cos()),
            ("sqrt", [a]) => Some(a.sqrt()),
            ("abs" | "fabs", [a]) => Some(a.abs()),
            ("min", [a, b]) => Some(a.min(*b)),
            ("max", [a, b]) => Some(a.max(*b)),
            ("if", [check, yes, no]) => Some(if *check >= 0.0 { *yes } else { *no }),
            _ => None,
        }
    }

    fn number(&mut self) -> Option<f64> {
        let mut end = self.text.find(|c| !is_digit(c)).unwrap_or(self.text.len());
        let exponent = self.text.get(end..)?.strip_prefix(['e', 'E']);
        if let Some(exponent) = exponent {
            let digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
            let length = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
            if length > 0 {
                end += 1 + (exponent.len() - digits.len()) + length;
            }
        }
        let (number, rest) = self.text.split_at(end);
        self.text = rest.trim_start();
        number.parse().ok()
    }
}
