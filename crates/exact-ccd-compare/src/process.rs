//! A program that answers requests through its standard input and output.

use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

/// A child process. It is killed when this is dropped.
pub(super) struct Process {
    child: Child,
    requests: BufWriter<ChildStdin>,
    answers: Answers,
}

/// The standard output of a process, read by a thread, so that waiting for it can end.
struct Answers {
    chunks: Receiver<io::Result<Vec<u8>>>,
    chunk: Vec<u8>,
    /// The length of the part of the chunk that was consumed.
    consumed: usize,
    /// The longest wait for the next chunk.
    patience: Duration,
}

/// The largest length of a line, in bytes.
const LINE: u64 = 1 << 20;

impl Process {
    pub(super) fn start(program: &str, arguments: &[String]) -> io::Result<Self> {
        let mut child = Command::new(program)
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let pipes = child.stdin.take().zip(child.stdout.take());
        let (requests, answers) = pipes.ok_or(io::ErrorKind::BrokenPipe)?;
        Ok(Self {
            child,
            requests: BufWriter::new(requests),
            answers: Answers::new(answers)?,
        })
    }

    /// Sets the longest wait for bytes of the process.
    pub(super) fn set_patience(&mut self, patience: Duration) {
        self.answers.patience = patience;
    }

    /// The pipe for requests, to be flushed after each.
    pub(super) fn requests(&mut self) -> &mut impl Write {
        &mut self.requests
    }

    /// The next line of the output.
    pub(super) fn line(&mut self) -> io::Result<String> {
        let mut line = String::new();
        match self.answers.by_ref().take(LINE).read_line(&mut line)? {
            0 => Err(io::Error::new(io::ErrorKind::UnexpectedEof, "it has ended")),
            _ => Ok(line),
        }
    }

    /// Fills the buffer with the next bytes of the output.
    pub(super) fn read(&mut self, bytes: &mut [u8]) -> io::Result<()> {
        self.answers.read_exact(bytes)
    }

    /// Ends the process. Later requests fail.
    pub(super) fn kill(&mut self) {
        // An error means that it has ended before.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        self.kill();
    }
}

impl Answers {
    fn new(output: ChildStdout) -> io::Result<Self> {
        let (sender, chunks) = sync_channel(1);
        thread::Builder::new().spawn(move || {
            let mut output = BufReader::new(output);
            loop {
                let chunk = output.fill_buf().map(<[u8]>::to_vec);
                let length = chunk.as_ref().map_or(0, Vec::len);
                output.consume(length);
                let is_last = length == 0;
                if sender.send(chunk).is_err() || is_last {
                    return;
                }
            }
        })?;
        Ok(Self {
            chunks,
            chunk: Vec::new(),
            consumed: 0,
            patience: Duration::MAX,
        })
    }
}

impl BufRead for Answers {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.consumed == self.chunk.len() {
            self.chunk = match self.chunks.recv_timeout(self.patience) {
                Ok(chunk) => chunk?,
                Err(RecvTimeoutError::Disconnected) => Vec::new(),
                Err(RecvTimeoutError::Timeout) => {
                    let message = format!("no answer within {:.1} s", self.patience.as_secs_f64());
                    return Err(io::Error::new(io::ErrorKind::TimedOut, message));
                }
            };
            self.consumed = 0;
        }
        Ok(&self.chunk[self.consumed..])
    }

    fn consume(&mut self, length: usize) {
        self.consumed += length;
    }
}

impl Read for Answers {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let length = self.fill_buf()?.read(buffer)?;
        self.consume(length);
        Ok(length)
    }
}
