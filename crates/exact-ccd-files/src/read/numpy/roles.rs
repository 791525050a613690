//! The roles of the arrays in an archive: positions, faces, edges and tetrahedra, by their names.

use super::archive::{Archive, Entry, list};
use super::header::Header;
use crate::error::{Fault, ParseError, Place, quoted};

/// The names of arrays that the options have.
#[derive(Clone, Copy, Default)]
pub(in super::super) struct Names<'a> {
    pub(in super::super) positions: Option<&'a str>,
    /// The array of faces in the archive.
    pub(in super::super) faces: Option<&'a str>,
    /// The faces are in a file of their own.
    pub(in super::super) has_faces_file: bool,
}

/// Numbers in the archive of the arrays of each role.
pub(super) struct Roles {
    pub(super) positions: usize,
    pub(super) faces: Option<(usize, Form)>,
    pub(super) edges: Option<(usize, Form)>,
    pub(super) tetrahedra: Option<(usize, Form)>,
}

/// The form in which an array has the vertices of elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// A row for each element, or a list of all vertices, so many for each element.
    Rows(usize),
    /// The number of corners before the corners of each element, as in `faces` and `lines` of pyvista.
    Counts,
}

/// A role: the names of its arrays, and their form by type and shape.
struct Role<F> {
    names: &'static [&'static str],
    expected: &'static str,
    form: fn(&Header) -> Option<F>,
}

const POSITIONS: Role<()> = Role {
    names: &[
        "positions",
        "position",
        "pos",
        "vertices",
        "verts",
        "points",
        "particle_q",
    ],
    expected: "numbers of shape (T, N, 3) or (N, 3)",
    form: |header| is_positions(header).then_some(()),
};

const POLYGONS: Role<Form> = Role {
    names: &["faces", "f"],
    expected: "integers of shape (F, k) with three or more corners",
    form: |header| match header.shape[..] {
        [_, size] if size >= 3 => integers(header, Form::Rows(size)),
        [_] => integers(header, Form::Counts),
        _ => None,
    },
};

const TRIANGLES: Role<Form> = Role {
    names: &["triangles", "tris", "tri_indices", "indices"],
    expected: "integers of shape (F, 3) or (3 F)",
    form: |header| rows_or_list(header, 3),
};

const EDGES: Role<Form> = Role {
    names: &["edges", "lines", "rods"],
    expected: "integers of shape (E, 2)",
    form: |header| match header.shape[..] {
        [_, 2] => integers(header, Form::Rows(2)),
        [_] => integers(header, Form::Counts),
        _ => None,
    },
};

const TETRAHEDRA: Role<Form> = Role {
    names: &["tets", "tetrahedra", "tet_indices"],
    expected: "integers of shape (K, 4) or (4 K)",
    form: |header| rows_or_list(header, 4),
};

fn is_positions(header: &Header) -> bool {
    matches!(header.shape[..], [_, 3] | [_, _, 3])
}

fn integers(header: &Header, form: Form) -> Option<Form> {
    header.scalar.is_integer().then_some(form)
}

fn rows_or_list(header: &Header, size: usize) -> Option<Form> {
    let fits = match header.shape[..] {
        [_, columns] => columns == size,
        [_] => true,
        _ => false,
    };
    if fits {
        integers(header, Form::Rows(size))
    } else {
        None
    }
}

impl Roles {
    /// The roles of the arrays that the options name, or else of those with a known name. Without one for the
    /// positions, they are the only array of floats of their shape, in an archive with faces, edges or
    /// tetrahedra.
    ///
    /// # Errors
    /// If two arrays have names of one role; if the type or the shape of one does not fit its role; if
    /// arrays without a known name may be the positions, or else may be faces or edges that are missing; if
    /// the options name an array that is missing.
    pub(super) fn of(archive: &Archive, names: &Names) -> Result<Self, ParseError> {
        let faces = match names.faces {
            Some(name) => Some(chosen(archive, name, &POLYGONS)?),
            None => named(archive, &[&POLYGONS, &TRIANGLES])?,
        };
        let edges = named(archive, &[&EDGES])?;
        let tetrahedra = named(archive, &[&TETRAHEDRA])?;
        let has_elements = faces.is_some() || edges.is_some() || tetrahedra.is_some() || names.has_faces_file;
        let positions = match (names.positions, named(archive, &[&POSITIONS])) {
            (Some(name), _) => chosen(archive, name, &POSITIONS)?.0,
            (None, Ok(None)) if has_elements => only_positions(archive)?,
            (None, Ok(None)) => return Err(no_mesh(archive)),
            (None, found) => found?.map_or(0, |(number, ())| number),
        };
        let roles = Self {
            positions,
            faces,
            edges,
            tetrahedra,
        };
        if roles.faces.is_none() && roles.tetrahedra.is_none() && !names.has_faces_file {
            roles.check_unnamed(archive)?;
        }
        Ok(roles)
    }

    /// Refuses an archive without faces, in which another array may be the faces or edges.
    fn check_unnamed(&self, archive: &Archive) -> Result<(), ParseError> {
        let least = if self.edges.is_some() { 3 } else { 2 };
        let may_be_elements = |entry: &&Entry| {
            let header = entry.header.as_ref().ok();
            header.is_some_and(|header| {
                header.scalar.is_integer()
                    && matches!(header.shape[..], [_, columns] if (least..=8).contains(&columns))
            })
        };
        let taken = [Some(self.positions), self.edges.map(|(number, _)| number)];
        let rest = archive.arrays.iter().enumerate();
        let rest = rest.filter(|(number, _)| !taken.contains(&Some(*number)));
        let mut unnamed = rest.map(|(_, entry)| entry).filter(may_be_elements).peekable();
        if unnamed.peek().is_none() {
            return Ok(());
        }
        let expected = "an array named `faces`, `edges` or `tets` (or name it with --faces; other arrays of \
                        integers can be left out)";
        Err(Fault::expected(expected, list(unnamed)).at(Place::File))
    }

    /// The names of the arrays that were read, and of those that were not.
    pub(super) fn describe(&self, archive: &Archive) -> String {
        let mut parts = Vec::new();
        let mut left_out: Vec<_> = archive.arrays.iter().map(Some).collect();
        for (role, number) in [
            ("positions", Some(self.positions)),
            ("faces", self.faces.map(|(number, _)| number)),
            ("edges", self.edges.map(|(number, _)| number)),
            ("tetrahedra", self.tetrahedra.map(|(number, _)| number)),
        ] {
            let Some(number) = number else { continue };
            left_out[number] = None;
            parts.push(format!("{role} from {}", name(&archive.arrays[number])));
        }
        let mut left_out = left_out.into_iter().flatten().map(name).peekable();
        if left_out.peek().is_some() {
            parts.push(format!("not read: {}", left_out.collect::<Vec<_>>().join(", ")));
        }
        parts.join(", ")
    }
}

fn name(entry: &Entry) -> String {
    quoted(entry.name.as_bytes())
}

/// The array with the name that the options have for a role, and its form.
fn chosen<F>(archive: &Archive, wanted: &str, role: &Role<F>) -> Result<(usize, F), ParseError> {
    let mut arrays = archive.arrays.iter().enumerate();
    let Some((number, entry)) = arrays.find(|(_, entry)| entry.name == wanted) else {
        let expected = format!("an array {}", quoted(wanted.as_bytes()));
        return Err(Fault::expected(expected, list(&archive.arrays)).at(Place::File));
    };
    Ok((number, form_of(entry, role)?))
}

/// The form of an array with a role.
fn form_of<F>(entry: &Entry, role: &Role<F>) -> Result<F, ParseError> {
    let header = entry.header.as_ref().map_err(Clone::clone)?;
    (role.form)(header).ok_or_else(|| {
        let expected = format!("{} as {}", role.expected, name(entry));
        Fault::expected(expected, header.to_string()).at(Place::File)
    })
}

/// The error of an archive without any array of a mesh.
fn no_mesh(archive: &Archive) -> ParseError {
    const POSES: [&str; 5] = ["poses", "pose_body", "body_pose", "root_orient", "global_orient"];
    let is_poses = |entry: &Entry| POSES.contains(&&*entry.name);
    let expected = if archive.arrays.iter().any(is_poses) {
        "arrays of a mesh, not poses (compute the vertices of each frame with the body model, and save them with \
         numpy.savez(\"motion.npz\", positions=vertices, faces=model.faces))"
    } else {
        "arrays `positions` of shape (T, N, 3) and `faces` (name others with the options of reading, in the \
         program --positions NAME and --faces NAME)"
    };
    Fault::expected(expected, list(&archive.arrays)).at(Place::File)
}

/// The array with a name of one of these roles, and its form.
fn named<F>(archive: &Archive, roles: &[&Role<F>]) -> Result<Option<(usize, F)>, ParseError> {
    let role_of = |name: &str| {
        let has_name = |role: &&&Role<F>| role.names.iter().any(|known| known.eq_ignore_ascii_case(name));
        roles.iter().find(has_name)
    };
    let arrays = archive.arrays.iter().enumerate();
    let found: Vec<_> = arrays
        .filter_map(|(number, entry)| Some((number, entry, role_of(&entry.name)?)))
        .collect();
    match found[..] {
        [] => Ok(None),
        [(number, entry, role)] => Ok(Some((number, form_of(entry, role)?))),
        _ => {
            let names = roles.iter().flat_map(|role| role.names);
            let names: Vec<_> = names.map(|name| format!("`{name}`")).collect();
            let expected = format!(
                "one array with one of the names {} (rename the others, or name it with --positions or --faces)",
                names.join(", ")
            );
            let found = list(found.into_iter().map(|(_, entry, _)| entry));
            Err(Fault::expected(expected, found).at(Place::File))
        }
    }
}

/// The only array of floats that can be positions.
fn only_positions(archive: &Archive) -> Result<usize, ParseError> {
    let may_be_positions = |entry: &Entry| {
        let header = entry.header.as_ref().ok();
        header.is_some_and(|header| !header.scalar.is_integer() && is_positions(header))
    };
    let arrays = || archive.arrays.iter().enumerate();
    let found: Vec<_> = arrays().filter(|(_, entry)| may_be_positions(entry)).collect();
    match found[..] {
        [(number, _)] => Ok(number),
        [] => {
            let expected = "an array `positions` of shape (T, N, 3) or (N, 3)";
            Err(Fault::expected(expected, list(&archive.arrays)).at(Place::File))
        }
        _ => {
            let expected = "an array named `positions`, as several arrays can be the positions (or name it with \
                            --positions)";
            let found = list(found.into_iter().map(|(_, entry)| entry));
            Err(Fault::expected(expected, found).at(Place::File))
        }
    }
}
