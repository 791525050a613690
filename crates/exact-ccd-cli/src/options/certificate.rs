//! The certificates of `step` and `audit`: proofs that `exact-ccd-check` verifies.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use exact_ccd::Separation;
use exact_ccd_certify::Maker;
use exact_ccd_mesh::{Contact, Frame, Motion, Point, TriangleMesh, Violation};

use crate::files::outputs::{answer, write_file};
use crate::messages::failure::Failure;

/// The option `--certificate`.
#[derive(clap::Args)]
pub(crate) struct CertificateOption {
    /// Write a proof of the answer that the program exact-ccd-check verifies without trusting this one.
    /// For PLY files of one part, without other rules than the minimum distance. Exit status 3: some
    /// pairs have no proof, and no file is written. docs/certificates.md has the format.
    #[arg(
        long,
        value_name = "FILE",
        value_parser = answer(),
        conflicts_with_all = ["others", "ignore", "only", "weld", "faces_only"]
    )]
    certificate: Option<PathBuf>,
}

/// A certificate in the making, if one is asked for.
#[derive(Default)]
pub(crate) struct Certificate<'a> {
    making: Option<(&'a Path, Maker)>,
    /// True if an edge pierces a face at the start, or primitives touch in the first frame: there is
    /// nothing to prove.
    is_broken: bool,
}

impl CertificateOption {
    /// The file, if one is asked for.
    pub(crate) fn file(&self) -> Option<&Path> {
        self.certificate.as_deref()
    }

    /// The certificate about a distance and these files.
    ///
    /// # Errors
    /// For files that `exact-ccd-check` does not read.
    pub(crate) fn begin(
        &self,
        files: impl IntoIterator<Item = PathBuf>,
        distance: Separation,
    ) -> Result<Certificate<'_>, Failure> {
        let Some(place) = self.certificate.as_deref() else {
            return Ok(Certificate::default());
        };
        let is_read = |file: &Path| file.extension().is_some_and(|it| it.eq_ignore_ascii_case("ply"));
        if let Some(file) = files.into_iter().find(|file| !is_read(file)) {
            let reason = "a certificate is about uncompressed PLY files, which exact-ccd-check reads: convert the mesh to \
                 PLY, by meshio or trimesh";
            return Err(Failure::of(&file, reason));
        }
        Ok(Certificate {
            making: Some((place, Maker::new(distance))),
            ..Certificate::default()
        })
    }
}

impl Certificate<'_> {
    /// Returns true if one is asked for.
    pub(crate) fn is_wanted(&self) -> bool {
        self.making.is_some()
    }

    /// Adds a step: its earliest contact, and true if nothing crosses at its start, if that was examined.
    pub(crate) fn add_step(
        &mut self,
        motion: &Motion,
        earliest: Option<&Contact>,
        starts_apart: Option<bool>,
    ) -> Result<(), Failure> {
        self.is_broken |= starts_apart == Some(false);
        let ends: [&[Point]; 2] = [&motion.x0, &motion.x1];
        self.add(&motion.mesh, ends, starts_apart.is_some(), earliest)
    }

    /// Adds the step that leads to a frame of an audit, or the first frame.
    pub(crate) fn add_frame(
        &mut self,
        before: Option<&[Point]>,
        frame: &Frame,
        violations: &[Violation],
    ) -> Result<(), Failure> {
        let Some(before) = before else {
            self.is_broken = !violations.is_empty();
            return Ok(());
        };
        let contact = violations.iter().find_map(|violation| match violation {
            Violation::Contact { contact, .. } => Some(contact),
            Violation::Intersection { .. } => None,
        });
        let making = self.making.as_ref();
        let is_first = making.is_some_and(|(_, maker)| maker.steps() == 0);
        self.add(&frame.mesh, [before, &frame.positions], is_first, contact)
    }

    /// Adds the statement that a mesh at rest is free, as that of a step that ends where it starts.
    #[cfg(feature = "repair")]
    pub(crate) fn add_rest(&mut self, mesh: &TriangleMesh, positions: &[Point]) -> Result<(), Failure> {
        self.add(mesh, [positions; 2], true, None)
    }

    fn add(
        &mut self,
        mesh: &TriangleMesh,
        positions: [&[Point]; 2],
        rest: bool,
        contact: Option<&Contact>,
    ) -> Result<(), Failure> {
        match &mut self.making {
            Some((_, maker)) if !self.is_broken => maker
                .add_step(mesh, positions, rest, contact)
                .map_err(Failure::new),
            _ => Ok(()),
        }
    }

    /// Writes the file. If there is no proof, reports that on standard error and returns the exit status 3.
    pub(crate) fn finish(self) -> Result<Option<ExitCode>, Failure> {
        let Some((place, maker)) = self.making else {
            return Ok(None);
        };
        let failed = if !self.is_broken && maker.steps() == 0 {
            "no certificate: a single frame has no step; name the next one, or the same file twice".to_owned()
        } else if self.is_broken {
            "no certificate: the mesh passes through itself or touches itself in the first frame, so that nothing can \
             be proved; of a step, --no-start-check leaves the first statement out"
                .to_owned()
        } else {
            match maker.finish() {
                Ok(bytes) => {
                    write_file(place, |writer| writer.write_all(&bytes))?;
                    return Ok(None);
                }
                Err(uncertified) => format!("no certificate: {uncertified}"),
            }
        };
        // An error of standard error itself cannot be reported.
        let _ = writeln!(std::io::stderr(), "exact-ccd: {failed}");
        Ok(Some(ExitCode::from(3)))
    }
}
