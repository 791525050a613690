//! Every format and encoding gives the same frame, bit for bit.

use super::encodings;
use exact_ccd_files::{Format, parse_frame, write_ply};
use exact_ccd_mesh::{Frame, Point};
use proptest::prelude::*;

/// Frames are equal if their meshes are and their coordinates are bit for bit: −0.0 is not 0.0.
#[track_caller]
fn assert_same(name: &str, read: &Frame, frame: &Frame) {
    let bits = |frame: &Frame| -> Vec<u64> {
        frame
            .positions
            .as_flattened()
            .iter()
            .map(|x| x.to_bits())
            .collect()
    };
    assert_eq!(bits(read), bits(frame), "{name}");
    assert_eq!(read.mesh, frame.mesh, "{name}");
}

#[track_caller]
fn parse(text: impl AsRef<[u8]>, format: Format) -> Frame {
    parse_frame(text.as_ref(), format).unwrap()
}

#[test]
fn a_byte_order_mark_is_skipped() {
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
    let off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let stl = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    for (text, format) in [(obj, Format::Obj), (off, Format::Off), (stl, Format::Stl)] {
        let marked = parse(format!("\u{feff}{text}"), format);
        assert_same(text, &marked, &parse(text, format));
    }
}

/// Three faces and a vertex in none of them, with extreme coordinates.
fn sample() -> Frame {
    let positions = vec![
        [-0.0, 0.1, 1e300],
        [f64::MIN_POSITIVE / 3.0, f64::from_bits(1), -1.0 / 3.0],
        [9.0, 9.0, 9.0],
        [f64::MAX, f64::MIN, 1e-308],
        [1.0, 2.0, 0.30000000000000004],
    ];
    Frame::new(positions, vec![[4, 1, 0], [0, 3, 4], [1, 1, 3]]).unwrap()
}

fn soup(corners: impl IntoIterator<Item = Point>) -> Frame {
    let positions: Vec<Point> = corners.into_iter().collect();
    let faces = (0..positions.len() as u32 / 3).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]);
    let faces = faces.collect();
    Frame::new(positions, faces).unwrap()
}

#[test]
fn all_formats_give_the_same_frame() {
    for (name, format, bytes) in encodings::indexed(&sample()) {
        assert_same(name, &parse(bytes, format), &sample());
    }
}

#[test]
fn all_formats_give_the_same_soup() {
    let frame =
        soup([[-0.0, 0.5, 1e30], [1e-45, 0.0, 3.0], [7.0, 8.0, 9.0]].map(|p| p.map(|x: f32| f64::from(x))));
    for (name, format, bytes) in encodings::soup(&frame)
        .into_iter()
        .chain(encodings::indexed(&frame))
    {
        assert_same(name, &parse(bytes, format), &frame);
    }
}

#[test]
fn single_precision_is_widened_exactly() {
    let frame = Frame::new(
        vec![[0.1_f32.into(), (-0.0_f32).into(), 1e-45_f32.into()]],
        vec![],
    )
    .unwrap();
    let mut bytes = Vec::new();
    write_ply(&mut bytes, &frame).unwrap();
    assert!(String::from_utf8_lossy(&bytes).contains("property float x"));
    assert_same("float ply", &parse(bytes, Format::Ply), &frame);
}

#[test]
fn text_is_read_to_the_nearest_double_for_every_declared_type() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float32 y\n\
               property uchar z\n\
               element face 0\nproperty list uchar int vertex_indices\nend_header\n 0.1 -.5 3. \n";
    assert_eq!(parse(ply, Format::Ply).positions, [[0.1, -0.5, 3.0]]);
}

#[test]
fn ply_skips_other_elements_and_properties() {
    let ply = "ply\nformat ascii 1.0\nobj_info anything\nelement nothing 1000000000000000000\n\
               element camera 1\nproperty list int double lens\nproperty char on\n\
               element face 1\nproperty uchar red\nproperty list uint8 uint16 vertex_indices\n\
               property list uchar float texture.coordinates\n\
               element vertex 3\nproperty float nx\nproperty double z\nproperty double y\nproperty double x\n\
               element edge 1\nproperty int vertex1\nend_header\n\
               2 0.5 0.25 1\n255 3 2 1 0 1 0.5\n\n9 3 2 1\n9 6 5 4\n9 9 8 7\n0\n";
    let frame = parse(ply, Format::Ply);
    assert_eq!(
        frame.positions,
        [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]
    );
    assert_eq!(frame.mesh.faces(), [[2, 1, 0]]);
}

#[test]
fn ply_reads_every_type_of_number() {
    let header = "ply\r\nformat binary_big_endian 1.0\r\nelement extra 1\r\n\
                  property list ushort short values\r\n\
                  element vertex 3\r\nproperty char x\r\nproperty ushort y\r\nproperty uint z\r\n\
                  property double weight\r\nelement face 1\r\nproperty list int ushort vertex_index\r\n\
                  end_header\r\n";
    let mut bytes = header.as_bytes().to_vec();
    bytes.extend([0, 2, 9, 9, 9, 9]);
    for _ in 0..3 {
        bytes.extend([0xff, 0x01, 0x02, 0xff, 0xff, 0xff, 0xff]);
        bytes.extend([7; 8]);
    }
    bytes.extend([0, 0, 0, 3, 0, 0, 0, 2, 0, 1]);
    let frame = parse(bytes, Format::Ply);
    assert_eq!(frame.positions, [[-1.0, 258.0, 4294967295.0]; 3]);
    assert_eq!(frame.mesh.faces(), [[0, 2, 1]]);
}

#[test]
fn obj_reads_every_kind_of_corner() {
    let obj = "# a comment \\\nmtllib x.mtl\nv 0 0 0 1.0\nv 1 0 \\\n  0\nvt 0 0\nvn 0 0 1\n\
               v 0 1 0 0.5 0.5 0.5 # red\n\
               f 1 2 3\nf 1/1 2/1 3/1\nf 1/1/1 2/1/1 3/1/1\nf 1//1 2//1 \\\r\n 3//1\nf -3 -2 -1\n\
               f 4 -1//-1 1\n\
               usemtl back\\slash\nv 5 5 5";
    let frame = parse(obj, Format::Obj);
    assert_eq!(
        frame.positions,
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [5.0, 5.0, 5.0]]
    );
    assert_eq!(frame.mesh.faces()[..5], [[0, 1, 2]; 5]);
    assert_eq!(frame.mesh.faces()[5], [3, 2, 0]);
}

#[test]
fn off_reads_comments_colours_and_missing_headers() {
    let plain = "OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let others = [
        "# comment\n\nOFF # here\n# and\n3 1\n0 0 0\n1 0 0 # there\n0 1 0\n3 0 1 2\n# end\n",
        "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
        "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 0 0 0 0\n3 0 1 2 0.5 0.5 0.5\n",
        "STCNOFF\n3 1 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n",
    ];
    for other in others {
        assert_same(other, &parse(other, Format::Off), &parse(plain, Format::Off));
    }
}

#[test]
fn stl_reads_words_on_any_lines_in_any_case_and_several_solids() {
    let stl = "  SOLID\nFACET NORMAL 0 0 1 OUTER LOOP VERTEX 0.1 0 0\nVERTEX 1\n0 0\n\n\
               vertex 0 1 0 endloop endfacet\n\
               ENDSOLID\nsolid second\nendsolid second\n";
    let frame = parse(stl, Format::Stl);
    assert_same(
        "stl",
        &frame,
        &soup([[0.1, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
    );
}

#[test]
fn the_extension_determines_the_format_in_any_case() {
    let format = |path: &str| Format::of_path(path.as_ref());
    assert_eq!(format("a/b.PLY"), Some(Format::Ply));
    assert_eq!(format("b.Obj"), Some(Format::Obj));
    assert_eq!(format("b.ply.stl"), Some(Format::Stl));
    assert_eq!(format("b.off"), Some(Format::Off));
    assert_eq!(format("ply"), None);
    assert_eq!(format("b.msh"), Some(Format::Msh));
    assert_eq!(format("b.vtu"), Some(Format::Vtu));
    assert_eq!(format("b.vtk.GZ"), Some(Format::Vtk));
    assert_eq!(format("b.abc"), None);
}

/// Finite numbers, most of them of common magnitude, some at the ends of the range.
fn coordinate() -> impl Strategy<Value = f64> {
    use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![
        POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO,
        prop::sample::select(vec![
            -0.0,
            0.0,
            f64::MAX,
            f64::MIN,
            f64::MIN_POSITIVE,
            f64::from_bits(1)
        ]),
        -1.0..1.0,
    ]
}

fn frame() -> impl Strategy<Value = Frame> {
    let positions = prop::collection::vec(prop::array::uniform3(coordinate()), 1..20);
    positions.prop_flat_map(|positions| {
        let face = prop::array::uniform3(0..positions.len() as u32);
        let faces = prop::collection::vec(face, 0..20);
        faces.prop_map(move |faces| Frame::new(positions.clone(), faces).unwrap())
    })
}

proptest! {
    #[test]
    fn any_frame_survives_every_format(frame in frame()) {
        for (name, format, bytes) in encodings::indexed(&frame) {
            assert_same(name, &parse(bytes, format), &frame);
        }
    }

    #[test]
    fn any_single_precision_soup_survives_every_format(
        corners in prop::collection::vec(prop::array::uniform9(prop::num::f32::ANY), 1..9)
    ) {
        let finite = |x: f32| if x.is_finite() { f64::from(x) } else { 0.0 };
        let points = corners.iter().flat_map(|corner| corner.as_chunks::<3>().0);
        let points = points.map(|point| point.map(finite));
        let frame = soup(points);
        for (name, format, bytes) in encodings::soup(&frame) {
            assert_same(name, &parse(bytes, format), &frame);
        }
    }
}
