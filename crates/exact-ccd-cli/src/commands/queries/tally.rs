//! Comparison of answers with the ground truth.

use std::io::Write;

/// The numbers of answers and of wrong ones.
#[derive(Default)]
pub(crate) struct Tally {
    queries: usize,
    contacts: usize,
    judged: usize,
    false_positives: usize,
    false_negatives: usize,
}

impl Tally {
    /// The number of answers.
    pub(crate) fn queries(&self) -> usize {
        self.queries
    }

    pub(crate) fn add(&mut self, contact: bool, truth: Option<bool>) {
        self.queries += 1;
        self.contacts += usize::from(contact);
        self.judged += usize::from(truth.is_some());
        self.false_positives += usize::from(contact && truth == Some(false));
        self.false_negatives += usize::from(!contact && truth == Some(true));
    }

    /// Prints the comparison with the ground truth on standard error, if there is any.
    pub(crate) fn report(&self) {
        let Self {
            queries,
            contacts,
            judged,
            false_positives,
            false_negatives,
        } = self;
        if *judged == 0 {
            return;
        }
        let of = if judged == queries {
            String::new()
        } else {
            format!(" of {judged} of them")
        };
        // The answers are complete, so an error of the summary is ignored.
        let _ = writeln!(
            std::io::stderr(),
            "{queries} queries, {contacts} in contact; against the ground truth{of}: \
             {false_positives} false positives, {false_negatives} false negatives",
        );
    }
}
