//! The grammar of files in use, where it is wider than that of the formats, and notes about what is not read.

use exact_ccd_files::{Fact, Format, FrameSequence, MeshFile, Polygons};

use crate::loose::vtu;
use crate::npz::{archive, array, floats, integers};
use crate::temporary;

fn read(format: Format, file: &str) -> MeshFile {
    MeshFile::parse(file.as_bytes(), format, Polygons::default())
        .unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// The notes about a file, joined.
fn notes(format: Format, file: &str) -> String {
    let notes = read(format, file).notes;
    notes
        .iter()
        .map(ToString::to_string)
        .collect::<Vec<_>>()
        .join("\n")
}

const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[test]
fn numbers_may_be_missing_after_slashes_of_obj() {
    for face in [
        "f 1// 2// 3//",
        "f 1/ 2/ 3/",
        "f 1/2/ 2/2/ 3/2/",
        "f 1//1 2/1/1 3",
    ] {
        let file = read(Format::Obj, &format!("{OBJ}{face}\n"));
        assert_eq!(file.frame.mesh.faces(), [[0, 1, 2]], "{face}");
        assert_eq!(file.notes, []);
    }
}

#[test]
fn a_face_of_two_corners_is_a_line_with_its_group() {
    let file = read(
        Format::Obj,
        &format!("{OBJ}v 0 0 1\nf 1 2 3\ng rod\nf 3/1 4/1\nf -1 1 2\n"),
    );
    assert_eq!(file.frame.mesh.faces(), [[0, 1, 2], [3, 0, 1]]);
    assert_eq!(file.frame.mesh.loose_edges(), [[2, 3]]);
    assert_eq!(file.groups[0].vertices, [0, 1, 2, 3]);
    assert_eq!(file.ids.faces, [Some(0), Some(1)]);
}

#[test]
fn two_coordinates_are_a_plane_and_a_note() {
    let file = read(Format::Obj, "# plane\nv 0 0\nv 1 0 # right\nv 0 1\nf 1 2 3\n");
    assert_eq!(file.frame.positions, [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    let [note] = &file.notes[..] else {
        panic!("{:?}", file.notes)
    };
    assert_eq!(
        (&note.fact, note.fact.is_warning()),
        (&Fact::TwoCoordinates, false)
    );
    assert_eq!(note.place.to_string(), "line 2: ");
}

#[test]
fn free_form_surfaces_of_obj_are_named_once() {
    let file = format!("{OBJ}f 1 2 3\ncstype bspline\nsurf 0 1 0 1 1 2 3\nsurf 0 1 0 1 1 2 3\n");
    assert_eq!(
        notes(Format::Obj, &file),
        "line 6: not read: the statement `surf`; convert free-form curves and surfaces to a mesh before export"
    );
}

const PLY: &str =
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n";
const ROWS: &str = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n";

#[test]
fn strips_of_ply_begin_again_at_minus_one() {
    let file = format!(
        "{PLY}element tristrips 2\nproperty list int int vertex_indices\nend_header\n{ROWS}8 0 1 2 3 -1 0 2 4\n1 -1\n"
    );
    assert_eq!(
        read(Format::Ply, &file).frame.mesh.faces(),
        [[0, 1, 2], [1, 3, 2], [0, 2, 4]]
    );
    let mut binary = file
        .split_once("0 0 0\n")
        .unwrap()
        .0
        .replace("ascii", "binary_big_endian")
        .into_bytes();
    let positions = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 0.0, 1.0_f32],
    ];
    binary.extend(positions.as_flattened().iter().flat_map(|x| x.to_be_bytes()));
    binary.extend(
        [8, 0, 1, 2, 3, -1, 0, 2, 4, 1, -1]
            .iter()
            .flat_map(|index: &i32| index.to_be_bytes()),
    );
    let binary = MeshFile::parse(&binary, Format::Ply, Polygons::Refuse).unwrap();
    assert_eq!(binary.frame, read(Format::Ply, &file).frame);
    let outside = file.replace("0 2 4\n", "0 2 5\n");
    let error = MeshFile::parse(outside.as_bytes(), Format::Ply, Polygons::Refuse).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 15: strip 0 names vertex 5, but there are 5 vertices, counted from 0"
    );
}

#[test]
fn values_beyond_the_header_and_other_elements_are_named() {
    let faces = "element face 1\nproperty list uchar int vertex_indices\n";
    let grid = "element range_grid 1\nproperty list uchar int vertex_indices\n";
    let rows = ROWS.replace("1 0 0\n", "1 0 0 255 7\n");
    let file = format!("{PLY}{faces}{grid}end_header\n{rows}3 0 1 2 0\n1 0\n");
    assert_eq!(read(Format::Ply, &file).frame.mesh.faces(), [[0, 1, 2]]);
    assert_eq!(
        notes(Format::Ply, &file),
        "line 9: not read: the element `range_grid`; export the mesh with its vertices and faces\n\
         line 13: not read: values beyond those that the header declares, in rows of `vertex`; declare them as \
         properties\n\
         line 17: not read: values beyond those that the header declares, in rows of `face`; declare them as \
         properties"
    );
    let exact = format!("{PLY}{faces}end_header\n{ROWS}3 0 1 2\n");
    assert_eq!(notes(Format::Ply, &exact), "");
}

#[test]
fn faces_of_off_may_be_on_several_lines() {
    let one = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n4 0 1 2 3\n";
    let several = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3\n0 1\n# more\n2 255 0 0\n4 0\n1\n2 3\n";
    assert_eq!(read(Format::Off, one).frame, read(Format::Off, several).frame);
}

#[test]
fn blocks_of_stl_may_end_in_two_words() {
    let one = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n\
               endsolid a\n";
    let words = [
        ("endloop", "end loop"),
        ("endfacet", "END FACET"),
        ("endsolid", "end  solid"),
    ];
    let two = words
        .iter()
        .fold(one.to_owned(), |file, (from, to)| file.replace(from, to));
    assert_eq!(read(Format::Stl, one).frame, read(Format::Stl, &two).frame);
    assert_eq!(read(Format::Stl, &two.repeat(2)).frame.mesh.faces().len(), 2);
    let wrong = one.replace("endloop", "end facet");
    let error = MeshFile::parse(wrong.as_bytes(), Format::Stl, Polygons::Refuse).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 7: expected `vertex` or `endloop`, found `end`"
    );
}

const NODES: &str = "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n";

#[test]
fn all_versions_of_gmsh_are_read() {
    let section = |name: &str, end: &str, rows: &str| format!("${name}\n{rows}${end}\n");
    let format = |version: &str| section("MeshFormat", "EndMeshFormat", &format!("{version} 0 8\n"));
    let nodes = section("Nodes", "EndNodes", &format!("5\n{NODES}"));
    let elements = section(
        "Elements",
        "EndElements",
        "2\n1 4 2 7 1 1 2 3 4\n2 4 2 8 1 2 3 4 5\n",
    );
    let new = format("2.2") + &nodes + &elements;
    let first = section("NOD", "ENDNOD", &format!("5\n{NODES}"))
        + &section("ELM", "ENDELM", "2\n1 4 7 1 4 1 2 3 4\n2 4 8 1 4 2 3 4 5\n");
    let fourth = format("4")
        + &section(
            "Entities",
            "EndEntities",
            "0 0 0 2\n1 0 0 0 1 1 1 1 7 0\n2 0 0 0 1 1 1 1 8 0\n",
        )
        + &section("Nodes", "EndNodes", &format!("1 5\n1 3 0 5\n{NODES}"))
        + &section(
            "Elements",
            "EndElements",
            "2 2\n1 3 4 1\n1 1 2 3 4\n2 3 4 1\n2 2 3 4 5\n",
        );
    let (expected, groups) = exact_ccd_files::parse_tet_mesh(new.as_bytes()).unwrap();
    assert_eq!(groups.len(), 2);
    for file in [first, format("2") + &nodes + &elements, fourth] {
        let read = exact_ccd_files::parse_tet_mesh(file.as_bytes());
        assert_eq!(
            read.unwrap_or_else(|error| panic!("{file}: {error}")),
            (expected.clone(), groups.clone())
        );
    }
}

#[test]
fn the_data_of_nodes_are_named() {
    let file = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n{NODES}$EndNodes\n$Elements\n1\n1 2 0 1 2 3\n$EndElements\n\
         $NodeData\n0\n$EndNodeData\n"
    );
    assert!(
        notes(Format::Msh, &file).starts_with("line 16: not read: the section `$NodeData`; if it has displ")
    );
}

/// Two tetrahedra on both sides of a face, each with its corners in either order, and one that is inverted.
#[test]
fn the_surface_of_tetrahedra_needs_no_order_of_corners() {
    let msh = |elements: [&str; 2], apex: &str| {
        let nodes = NODES.replace("1 1 1\n", apex);
        let [a, b] = elements;
        format!(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n{nodes}$EndNodes\n$Elements\n2\n1 4 0 {a}\n2 4 0 {b}\n\
             $EndElements\n"
        )
    };
    let sets = |file: &str| {
        let mut faces = read(Format::Msh, file).frame.mesh.faces().to_vec();
        faces.iter_mut().for_each(|face| face.sort_unstable());
        faces.sort_unstable();
        faces
    };
    let positive = msh(["1 2 3 4", "2 3 4 5"], "1 1 1\n");
    let mixed = msh(["1 2 3 4", "2 4 3 5"], "1 1 1\n");
    let inverted = msh(["1 2 3 4", "2 3 4 5"], "0.1 0.1 0.1\n");
    let flat = msh(["1 2 3 4", "2 3 4 5"], "0.5 0.5 0\n");
    assert_eq!(sets(&positive).len(), 6);
    for (file, fact) in [
        (&positive, None),
        (&mixed, Some(Fact::Inverted { count: 1, of: 2 })),
        (&inverted, Some(Fact::Inverted { count: 1, of: 2 })),
        (&flat, Some(Fact::Flat { count: 1, of: 2 })),
    ] {
        assert_eq!(sets(file), sets(&positive));
        let facts: Vec<_> = read(Format::Msh, file)
            .notes
            .into_iter()
            .map(|note| note.fact)
            .collect();
        assert_eq!(facts, Vec::from_iter(fact), "{file}");
    }
    // The frames of a recording have one mesh, also where elements are inverted.
    let meshes = [&positive, &inverted, &flat].map(|file| read(Format::Msh, file).frame.mesh);
    assert!(meshes.iter().all(|mesh| *mesh == meshes[0]));
}

#[test]
fn displacements_and_ghosts_of_vtk_are_named() {
    let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let data = "<PointData><DataArray type=\"Float64\" Name=\"Displacement\" NumberOfComponents=\"3\" \
                format=\"ascii\">0 0 0 0 0 0 0 0 0</DataArray></PointData><CellData><DataArray type=\"UInt8\" \
                Name=\"vtkGhostType\" format=\"ascii\">1</DataArray></CellData></Piece>";
    let file = vtu(&points, "0 1 2", "3", "5");
    assert_eq!(notes(Format::Vtu, &file), "");
    let found = notes(Format::Vtu, &file.replace("</Piece>", data));
    assert!(
        found.contains("the array `Displacement`; if the points") && found.contains("`vtkGhostType`; remove"),
        "{found}"
    );
    let legacy = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n\
                  3 0 1 2\nPOINT_DATA 3\nVECTORS disp float\n0 0 0 0 0 0 0 0 0\n";
    assert!(notes(Format::Vtk, legacy).contains("displacements among the data"));
    assert_eq!(notes(Format::Vtk, &legacy.replace("disp", "velocity")), "");
}

#[test]
fn arrays_that_are_no_mesh_are_refused_with_the_remedy() {
    let open = |name: &str, file: &[u8]| {
        let options = exact_ccd_files::ReadOptions::default();
        FrameSequence::open(temporary(&format!("in_use/{name}"), file), options)
    };
    let error = |name: &str, file: &[u8]| open(name, file).unwrap_err().to_string();
    let poses = archive(&[
        ("poses", floats("(2, 6)", &[0.0; 12])),
        ("trans", floats("(2, 3)", &[0.0; 6])),
    ]);
    let found = error("poses.npz", &poses);
    assert!(
        found.contains("not poses (compute the vertices") && found.contains("`trans` <f8 (2, 3)"),
        "{found}"
    );
    let found = error("posed.npz", &archive(&[("v_posed", floats("(2, 3)", &[0.0; 6]))]));
    assert!(found.contains("--positions NAME and --faces NAME"), "{found}");
    let faces = integers("(1, 3)", &[0, 1, 2]);
    let found = error("faces.npy", &faces);
    assert!(
        found.contains("--faces FILE.npy") && found.contains("integers of shape [1, 3]"),
        "{found}"
    );
    let alone = open("alone.npy", &floats("(2, 3)", &[0.0; 6]))
        .unwrap()
        .read(0)
        .unwrap();
    assert!(
        alone.notes[0]
            .to_string()
            .starts_with("not read: faces, which an array of positions")
    );
}

#[test]
fn options_name_arrays_and_a_file_of_faces() {
    use exact_ccd_files::ReadOptions;
    let open = |path: &std::path::Path, positions: Option<&str>, faces: Option<&str>| {
        let [positions, faces] = [positions, faces].map(|name| name.map(str::to_owned));
        FrameSequence::open(path, ReadOptions::default().with_arrays(positions, faces))
    };
    let motion = floats(
        "(2, 3, 3)",
        &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].repeat(2),
    );
    let faces = integers("(1, 3)", &[0, 1, 2]);
    let other = array("<i4", "(1, 3)", &[0; 12]);
    let several = archive(&[
        ("x", motion.clone()),
        ("y", motion.clone()),
        ("tri", faces.clone()),
        ("more", other),
    ]);
    let npz = temporary("in_use/several.npz", several);
    let sequence = open(&npz, Some("x"), Some("tri")).unwrap();
    assert_eq!(sequence.len(), 2);
    assert_eq!(sequence.read(1).unwrap().frame.mesh.faces(), [[0, 1, 2]]);
    let error = open(&npz, Some("z"), Some("tri")).unwrap_err().to_string();
    assert!(
        error.contains("expected an array `z`, found `x` <f8 (2, 3, 3), `y`"),
        "{error}"
    );
    let (npy, file) = (
        temporary("in_use/motion.npy", &motion),
        temporary("in_use/faces-of.npy", &faces),
    );
    let sequence = open(&npy, None, file.to_str()).unwrap();
    let read = sequence.read(0).unwrap();
    assert_eq!(
        (read.frame.mesh.faces(), read.notes),
        (&[[0, 1, 2]][..], Vec::new())
    );
    let error = open(&npy, None, Some("tri")).unwrap_err().to_string();
    assert!(error.contains("this file has one array"), "{error}");
    let error = open(&npy, None, npy.to_str()).unwrap_err().to_string();
    assert!(
        error.contains("expected faces: integers of shape (F, k)"),
        "{error}"
    );
}

#[test]
fn each_part_of_a_collection_is_a_sequence() {
    for (name, z) in [("a0", 0), ("a1", 1), ("b0", 2), ("b1", 3)] {
        temporary(
            &format!("in_use/{name}.obj"),
            OBJ.replace(" 0\n", &format!(" {z}\n")) + "f 1 2 3\n",
        );
    }
    let entry = |time: u32, part: &str, file: &str| {
        format!("<DataSet timestep=\"{time}\" group=\"\" part=\"{part}\" file=\"{file}.obj\"/>")
    };
    let collection = |entries: &[String]| {
        let list = format!(
            "<VTKFile type=\"Collection\"><Collection>{}</Collection></VTKFile>",
            entries.concat()
        );
        temporary("in_use/parts.pvd", list)
    };
    let nothing = FrameSequence::open_parts(collection(&[]), Polygons::Refuse).unwrap();
    assert_eq!(nothing.iter().map(FrameSequence::len).collect::<Vec<_>>(), [0]);
    let all = [
        entry(0, "0", "a0"),
        entry(0, "1", "b0"),
        entry(1, "0", "a1"),
        entry(1, "1", "b1"),
    ];
    let path = collection(&all);
    let parts = FrameSequence::open_parts(&path, Polygons::Refuse).unwrap();
    let names: Vec<_> = parts
        .iter()
        .map(|part| (part.part(), part.len(), part.time(1)))
        .collect();
    assert_eq!(names, [(Some("0"), 2, Some(1.0)), (Some("1"), 2, Some(1.0))]);
    assert_eq!(parts[1].read(1).unwrap().frame.positions[0], [0.0, 0.0, 3.0]);
    let error = FrameSequence::open(&path, Polygons::Refuse)
        .unwrap_err()
        .to_string();
    assert!(error.contains("2 parts"), "{error}");
    let error = FrameSequence::open_parts(collection(&all[..3]), Polygons::Refuse)
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("a file of the part `1` at each time of the part `0`"),
        "{error}"
    );
}
