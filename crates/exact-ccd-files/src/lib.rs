//! Mesh files: PLY, OBJ, STL, OFF, Gmsh, VTK, glTF and numpy, read exactly, and written.
//!
//! ```no_run
//! use exact_ccd_files::{read_motion, write_ply};
//! use exact_ccd_mesh::{Frame, step};
//!
//! let motion = read_motion("start.obj", "end.vtu")?;
//! let report = step(&motion.mesh, &motion.x0, &motion.x1)?;
//! println!("{:?}", report.time_of_impact());
//!
//! let triangle = Frame::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0, 1, 2]])?;
//! write_ply(std::fs::File::create("triangle.ply")?, &triangle)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | data | from a file | from bytes | to a writer |
//! |---|---|---|---|
//! | a mesh at one time, [`Frame`] | [`read_frame`] | [`parse_frame`] | [`write_ply`], `write_obj`, `write_vtu` |
//! | a mesh in motion, [`Motion`] | [`read_motion`] | | |
//! | tetrahedra, [`TetMesh`], and their [`Group`]s | [`read_tet_mesh`] | [`parse_tet_mesh`] | [`write_vtu`] |
//! | tetrahedra, triangles, lines and points, [`UnstructuredGrid`] | | | [`write_vtu`] |
//! | a frame, and its contents in numbers, [`MeshFile`] | [`MeshFile::read`] | [`MeshFile::parse`] | |
//! | points with data, [`PointArray`] | | | [`write_vtp`] |
//! | a sequence of frames, [`FrameSequence`] | [`FrameSequence::open`] | | |
//! | a sequence of files, one for each time | [`read_pvd`] | | [`write_pvd`] |
//!
//! [`FrameOrder`] has the files of a folder in the order of the numbers in their names.
//!
//! [`Frame`]: exact_ccd_mesh::Frame
//! [`Motion`]: exact_ccd_mesh::Motion
//! [`TetMesh`]: exact_ccd_mesh::TetMesh
//!
//! # Rods and points
//!
//! Loose edges are read from the statements `l` of OBJ, the element `edge` of PLY (properties
//! `vertex1` and `vertex2`), lines and polylines of VTK and lines of Gmsh. An edge of a face or of
//! a tetrahedron is not loose, so lines that mark the boundary of a surface have no effect. Every
//! other line becomes a rod, also where a program wrote it as a construction line. Every vertex of
//! a surface mesh that is in no face and no edge is a point, whether or not the file lists it as
//! one. Of tetrahedra, only listed points of VTK are kept; Gmsh lists points for its geometry.
//!
//! # Limits
//!
//! No bytes make a reader panic. The data of a file expand to at most 200 times its size and a mebibyte. A
//! reader keeps at most 32 bytes for each byte of the file and of these data; the mesh that is made of them
//! takes a small multiple. [`ReadOptions::with_max_size`] limits the size.
//! `docs/files.md` in the repository says what each format becomes.

mod contents;
mod error;
mod file_ids;
mod format;
mod frame_order;
mod named_part;
mod note;
mod read;
mod unsupported;
mod write;

pub use contents::Contents;
pub use error::{Fault, ParseError, Place, ReadError, excerpt};
pub use file_ids::FileIds;
pub use format::Format;
pub use frame_order::{FrameOrder, Missing};
pub use named_part::NamedPart;
pub use note::{Fact, Note};
pub use read::{
    Budget, FrameSequence, Group, MeshFile, PhysicalTag, Polygons, ReadMotionError, ReadOptions, parse_frame,
    parse_tet_mesh, read_frame, read_motion, read_pvd, read_tet_mesh,
};
pub use unsupported::Unsupported;
pub use write::{
    PointArray, UnstructuredGrid, write_obj, write_ply, write_ply_with_parts, write_pvd, write_vtp, write_vtu,
};

/// The examples in the README of the repository, as tests.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct RepositoryReadme;

/// The examples in the README of this crate, as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
