//! The end of a simulation by Ctrl-C.

use std::ffi::OsString;
use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::arguments::Arguments;

/// The exit status of a program that SIGINT ends, in shells: 128 plus the number of the signal.
pub(super) const STATUS: u8 = 130;

/// A flag that Ctrl-C sets from now on, unless the process ignores it, as background jobs of scripts do. The
/// second Ctrl-C ends the process at once.
pub(super) fn flag() -> Arc<AtomicBool> {
    let flag = Arc::new(AtomicBool::new(false));
    let set = Arc::clone(&flag);
    // Without a handler, Ctrl-C ends the process at once, which leaves the last checkpoint.
    let _ = ctrlc::try_set_handler(move || {
        if set.swap(true, Ordering::Relaxed) {
            process::exit(STATUS.into());
        }
    });
    flag
}

/// The message after an interruption, with the command that continues the run. `command` is the program with
/// its arguments.
pub(super) fn message(step: u64, arguments: &Arguments, command: &[OsString]) -> String {
    if arguments.output.is_none() {
        return format!("interrupted after time step {step}; without --output, the run cannot be continued");
    }
    let words = command.iter().map(|word| word.to_string_lossy());
    let kept = words.filter(|word| word != "--overwrite" && word != "--resume");
    let quoted: Vec<String> = kept.map(|word| shell_words::quote(&word).into_owned()).collect();
    format!(
        "interrupted after time step {step}, which is saved; this command continues the run:\n{} --resume",
        quoted.join(" ")
    )
}
