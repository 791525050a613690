//! The lines and words of a text scene.

use std::collections::VecDeque;
use std::iter::Enumerate;
use std::str::Lines;

use crate::fault::{Fault, Place, Problem};
use crate::notes::Notes;

/// The lines of a file that have words. Words after one that begins with `#` are a comment.
pub(super) struct Text<'a> {
    lines: Enumerate<Lines<'a>>,
}

impl<'a> Text<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            lines: text.lines().enumerate(),
        }
    }

    /// The next line that has words, which begins with a keyword.
    pub(super) fn line(&mut self) -> Option<Line<'a>> {
        loop {
            let (index, text) = self.lines.next()?;
            let words: VecDeque<&str> = text
                .split_whitespace()
                .take_while(|word| !word.starts_with('#'))
                .collect();
            if let Some(first) = words.front() {
                let place = Place::Line {
                    line: index + 1,
                    keyword: (*first).to_owned(),
                };
                return Some(Line { place, words });
            }
        }
    }

    /// The next line with words, as a continuation of the line at `place`.
    pub(super) fn following(&mut self, place: &Place, expected: &str) -> Result<Line<'a>, Fault> {
        self.line()
            .ok_or_else(|| Problem::invalid("the end of the file", expected).at(place))
    }

    /// As many numbers as the next word of a line says, from the following lines.
    pub(super) fn numbers(&mut self, line: &mut Line<'_>) -> Result<Vec<f64>, Fault> {
        let count = line.count("the number of numbers that follow")?;
        let mut numbers = Vec::new();
        while numbers.len() < count {
            let expected = format!("{count} numbers in the lines that follow");
            let mut next = self.following(&line.place, &expected)?;
            while !next.is_empty() {
                numbers.push(next.number("a number")?);
            }
        }
        if numbers.len() > count {
            let found = format!("{} numbers", numbers.len());
            return Err(
                Problem::invalid(found, format!("{count} numbers in the lines that follow")).at(&line.place),
            );
        }
        Ok(numbers)
    }
}

/// The words of a line that were not read yet.
pub(super) struct Line<'a> {
    place: Place,
    words: VecDeque<&'a str>,
}

impl<'a> Line<'a> {
    /// The place of the last keyword.
    pub(super) fn place(&self) -> &Place {
        &self.place
    }

    pub(super) fn is_empty(&self) -> bool {
        self.words.is_empty()
    }

    /// The next word, as the keyword of the numbers that follow.
    pub(super) fn keyword(&mut self) -> Option<&'a str> {
        let word = self.words.pop_front()?;
        if let Place::Line { keyword, .. } = &mut self.place {
            word.clone_into(keyword);
        }
        Some(word)
    }

    /// The next word.
    pub(super) fn word(&mut self, expected: &str) -> Result<&'a str, Fault> {
        let word = self.words.pop_front();
        word.ok_or_else(|| Problem::invalid("nothing", expected).at(&self.place))
    }

    /// The next word, a finite number.
    pub(super) fn number(&mut self, expected: &str) -> Result<f64, Fault> {
        let word = self.word(expected)?;
        finite(word).ok_or_else(|| self.invalid(word, expected))
    }

    /// The next words, as many finite numbers.
    pub(super) fn numbers<const N: usize>(&mut self, expected: &str) -> Result<[f64; N], Fault> {
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            *number = self.number(expected)?;
        }
        Ok(numbers)
    }

    /// The next word, if it is a number.
    pub(super) fn optional(&mut self) -> Option<f64> {
        let number = self.words.front().and_then(|word| finite(word))?;
        self.words.pop_front();
        Some(number)
    }

    /// The next word, a whole number from 0.
    pub(super) fn count(&mut self, expected: &str) -> Result<usize, Fault> {
        let word = self.word(expected)?;
        word.parse().map_err(|_| self.invalid(word, expected))
    }

    /// The error of a word that was found.
    pub(super) fn invalid(&self, found: &str, expected: &str) -> Fault {
        Problem::invalid(format!("`{found}`"), expected).at(&self.place)
    }

    /// The error of a keyword without a counterpart.
    pub(super) fn unsupported(&self, what: &str, instead: &str) -> Fault {
        Problem::unsupported(what, instead).at(&self.place)
    }

    /// Drops the words that are left.
    pub(super) fn clear(&mut self) {
        self.words.clear();
    }

    /// Notes the words that are left, which IPC ignores.
    pub(super) fn note_rest(self, notes: &Notes) {
        if !self.words.is_empty() {
            let rest = Vec::from(self.words).join(" ");
            notes.add(self.place, format!("`{rest}` is ignored, as by IPC"));
        }
    }
}

fn finite(word: &str) -> Option<f64> {
    word.parse().ok().filter(|number: &f64| number.is_finite())
}
