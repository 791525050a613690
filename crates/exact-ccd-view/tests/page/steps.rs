//! Pages of steps and of sequences of frames.

use exact_ccd::CONTACT;
use exact_ccd_mesh::{Aabb, Bvh, Candidates, Contact, Intersection, Pair, Step, TriangleMesh};
use exact_ccd_view::{Body, Chart, Curve, History, MOST_CONTACTS, Page, PageError};
use proptest::prelude::*;
use serde_json::Value;

use crate::html::Html;

const MESH: [[u32; 3]; 2] = [[0, 1, 2], [5, 4, 3]];
const START: [[f64; 3]; 6] = [
    [0.0, 0.0, 0.0],
    [8.0, 0.0, 0.0],
    [0.0, 8.0, 0.0],
    [1.0, 1.0, 1.0],
    [1.0, 2.0, 5.0],
    [2.0, 1.0, 5.0],
];

fn mesh() -> TriangleMesh {
    TriangleMesh::new(6, MESH.to_vec()).unwrap()
}

/// The upper triangle, moved up.
fn moved(height: f64) -> [[f64; 3]; 6] {
    let mut positions = START;
    positions[3..].iter_mut().for_each(|[_, _, z]| *z += height);
    positions
}

fn contacts(end: &[[f64; 3]; 6]) -> Vec<Contact> {
    let mesh = mesh();
    let step = Step::new(&mesh, &START, end).unwrap();
    Candidates::new(step, &Bvh).collisions(step, CONTACT)
}

fn page(title: &str, end: &[[f64; 3]; 6]) -> Page {
    let mesh = mesh();
    let step = Step::new(&mesh, &START, end).unwrap();
    Page::of_step(title, step, &[], &contacts(end)).unwrap()
}

#[test]
fn the_blocks_of_a_page_are_the_elements_of_the_file() {
    let page = page("Falling <b>", &moved(-2.0));
    let (html, blocks) = (Html::of(&page), page.blocks());
    let ids: Vec<&str> = blocks.keys().map(String::as_str).collect();
    assert_eq!(ids, ["edges", "faces", "frame-0", "frame-1", "page", "radii"]);
    for (id, text) in &blocks {
        assert_eq!(html.element(id), text);
    }
}

#[test]
fn faces_and_positions_are_read_back() {
    let html = Html::of(&page("a step", &moved(-2.0)));
    let mut faces = html.words("faces");
    for i in 3..faces.len() {
        faces[i] = faces[i].wrapping_add(faces[i - 3]);
    }
    assert_eq!(faces, MESH.as_flattened());
    for (frame, expected) in [START, moved(-2.0)].iter().enumerate() {
        let positions = html.positions(frame);
        for (&x, &y) in positions.as_flattened().iter().zip(expected.as_flattened()) {
            assert!((x - y).abs() <= 1e-5, "{x} for {y} in frame {frame}");
        }
    }
}

#[test]
fn contacts_are_those_of_the_step_with_all_bits() {
    let end = moved(-2.0);
    let html = Html::of(&page("a step", &end));
    let (json, contacts) = (html.json(), contacts(&end));
    assert_eq!(json["contacts"].as_array().unwrap().len(), contacts.len());
    assert_eq!(json["contactCount"], contacts.len());
    let first = &json["contacts"][0];
    assert_eq!(contacts[0].pair, Pair::VertexFace { vertex: 3, face: 0 });
    assert_eq!(first["time"].as_f64(), Some(0.5));
    assert_eq!(
        first["primitives"][0],
        serde_json::json!({"kind": "vertex", "id": 3, "vertices": [3], "labels": [3]})
    );
    assert_eq!(
        first["primitives"][1],
        serde_json::json!({"kind": "face", "id": 0, "vertices": [0, 1, 2], "labels": [0, 1, 2]})
    );
    assert_eq!(first["closest"][0], serde_json::json!([1.0, 1.0, 0.0]));
    assert_eq!(first["normal"], serde_json::json!([0.0, 0.0, 1.0]));
}

#[test]
fn text_of_the_user_stays_inside_of_its_element() {
    let title = "</script><script>alert(1)</script><!-- data -->";
    let html = Html::of(&page(title, &moved(-2.0)));
    assert_eq!(html.json()["title"], title);
    assert!(!html.0.contains("<script>alert"));
}

#[test]
fn the_page_loads_nothing() {
    let html = Html::of(&page("a step", &moved(1.0)));
    assert!(html.0.contains("default-src 'none'"));
    for attribute in [" src=", " href="] {
        assert!(
            !html.0.contains(&format!("<script{attribute}"))
                && !html.0.contains(&format!("<link{attribute}"))
        );
    }
    assert!(
        html.0.contains("Permission is hereby granted"),
        "the licence of three.js"
    );
}

#[test]
fn vertices_at_rest_take_no_room() {
    let mesh = TriangleMesh::new(30_000, Vec::new()).unwrap();
    let points: Vec<_> = (0..30_000)
        .map(|i| [f64::from(i).sin(), f64::from(i).cos(), 0.1])
        .collect();
    let mut page = Page::new("points", mesh, &points.iter().copied().collect());
    page.add_frame("", &points).unwrap();
    page.add_frame("", &points).unwrap();
    let html = Html::of(&page);
    assert!(html.element("frame-0").len() > 100_000);
    assert!(html.element("frame-1").len() < 3_000);
}

#[test]
fn violations_belong_to_the_step_before_the_last_frame() {
    let mut page = Page::new("frames", mesh(), &START.iter().copied().collect());
    let contact = contacts(&moved(-2.0))[0];
    assert_eq!(page.add_contact(&contact), Err(PageError::NoFrame));
    page.add_frame("a", &moved(1.0)).unwrap();
    page.add_frame("b", &START).unwrap();
    page.add_frame("c", &moved(-2.0)).unwrap();
    page.add_contact(&contact).unwrap();
    // In the last frame, edges of the upper triangle pierce the lower one.
    let intersection = Intersection { edge: 4, face: 0 };
    page.add_intersection(intersection).unwrap();
    let json = Html::of(&page).json();
    assert_eq!(
        (&json["contacts"][0]["frame"], &json["contacts"][1]["frame"]),
        (&1.into(), &2.into())
    );
    assert_eq!(
        json["contacts"][0]["closest"][0],
        serde_json::json!([1.0, 1.0, 0.0])
    );
    assert_eq!(json["contacts"][1]["closest"][0][2].as_f64(), Some(0.0));
}

#[test]
fn primitives_of_another_mesh_are_refused() {
    let mut page = Page::new("frames", mesh(), &Aabb::EMPTY);
    page.add_frame("", &START).unwrap();
    let mut contact = contacts(&moved(-2.0))[0];
    contact.pair = Pair::VertexFace { vertex: 3, face: 2 };
    let error = page.add_contact(&contact).unwrap_err();
    assert_eq!(error, PageError::NoSuchPair { pair: contact.pair });
    let intersection = Intersection { edge: 6, face: 0 };
    assert_eq!(
        page.add_intersection(intersection),
        Err(PageError::NoSuchIntersection { intersection })
    );
    let error = page.add_frame("", &START[1..]).unwrap_err();
    assert!(error.to_string().starts_with("in frame 1, "), "{error}");
}

#[test]
fn a_vertex_in_a_half_space_is_a_contact_of_the_last_frame() {
    let mut page = Page::new("frames", mesh(), &START.iter().copied().collect())
        .with_ids((10..16).collect(), vec![None, None])
        .with_half_space("floor", [0.0, 0.0, 2.0], [0.0, 0.0, 4.0]);
    assert_eq!(page.add_half_space_contact(3, 0, None), Err(PageError::NoFrame));
    page.add_frame("a", &START).unwrap();
    page.add_frame("b", &START).unwrap();
    page.add_half_space_contact(3, 0, None).unwrap();
    for (vertex, half_space) in [(6, 0), (3, 1)] {
        let error = Err(PageError::NoSuchHalfSpace { vertex, half_space });
        assert_eq!(page.add_half_space_contact(vertex, half_space, None), error);
    }
    let json = Html::of(&page).json();
    let normal = serde_json::json!([0.0, 0.0, 1.0]);
    assert_eq!(json["halfSpaces"][0]["normal"], normal);
    let contact = &json["contacts"][0];
    assert_eq!((&contact["frame"], &contact["time"]), (&1.into(), &0.0.into()));
    assert_eq!(
        contact["primitives"],
        serde_json::json!([
            {"kind": "vertex", "id": 13, "vertices": [3], "labels": [13]},
            {"kind": "half-space", "id": 0, "vertices": [], "labels": []},
        ])
    );
    assert_eq!(
        contact["closest"],
        serde_json::json!([[1.0, 1.0, 1.0], [1.0, 1.0, 2.0]])
    );
    assert_eq!(contact["normal"], normal);

    // In a step, the vertex is where it is at the time.
    page.add_frame("c", &moved(4.0)).unwrap();
    page.add_half_space_contact(3, 0, Some(0.25)).unwrap();
    let contact = &Html::of(&page).json()["contacts"][1];
    assert_eq!((&contact["frame"], &contact["time"]), (&1.into(), &0.25.into()));
    assert_eq!(
        contact["closest"],
        serde_json::json!([[1.0, 1.0, 2.0], [1.0, 1.0, 2.0]])
    );
}

/// Half spaces of any size: a normal without a direction is left out, and no point is infinite.
#[test]
fn extreme_half_spaces() {
    let page = Page::new("frames", mesh(), &START.iter().copied().collect())
        .with_half_space("", [0.0; 3], [0.0; 3])
        .with_half_space("", [f64::NAN; 3], [1.0, 0.0, 0.0])
        .with_half_space("", [f64::MAX; 3], [f64::MAX, 0.0, 0.0])
        .with_half_space("", [-f64::MAX; 3], [5e-324, 0.0, 0.0]);
    let mut page = page;
    page.add_frame("", &[[f64::MAX; 3]; 6]).unwrap();
    page.add_half_space_contact(0, 0, None).unwrap();
    page.add_half_space_contact(0, 1, None).unwrap();
    let json = Html::of(&page).json();
    assert_eq!(json["halfSpaces"].as_array().unwrap().len(), 2);
    for number in [0, 1] {
        assert_eq!(
            json["halfSpaces"][number]["normal"],
            serde_json::json!([1.0, 0.0, 0.0])
        );
        let foot = &json["contacts"][number]["closest"][1];
        assert!(foot.as_array().unwrap().iter().all(Value::is_f64), "{foot}");
    }
}

#[test]
fn bodies_radii_and_charts_are_those_of_the_caller() {
    let bodies = [Body::new("lower", "obstacle", 0..3), Body::new("upper", "", 3..6)];
    let curve = Curve {
        name: "kinetic".to_owned(),
        values: vec![None, Some(2.5), Some(f64::INFINITY)],
    };
    let chart = Chart {
        title: "Energies".to_owned(),
        unit: "J".to_owned(),
        logarithmic: true,
        curves: vec![curve],
    };
    let history = History {
        times: vec![0.0, 0.5, 1.0],
        charts: vec![chart],
    };
    let bounds: Aabb = START.iter().copied().collect();
    let mut page = Page::new("frames", mesh(), &bounds)
        .with_bodies(bodies)
        .with_radii(&[0.5; 6])
        .with_up([0.0, 3.0, 4.0])
        .with_up([0.0; 3])
        .with_history(history);
    page.add_frame("", &START).unwrap();
    let html = Html::of(&page);
    let json = html.json();
    assert_eq!(
        json["bodies"][1],
        serde_json::json!({"name": "upper", "kind": "", "vertices": {"start": 3, "end": 6}})
    );
    assert_eq!(json["up"], serde_json::json!([0.0, 0.6, 0.8]));
    let curve = &json["history"]["charts"][0]["curves"][0];
    assert_eq!(curve["values"], serde_json::json!([null, 2.5, null]));
    // The longest side of the box is 8: positions are in units of 4.
    let radii: Vec<f32> = html.words("radii").into_iter().map(f32::from_bits).collect();
    assert_eq!(radii, [0.125; 6]);
}

#[test]
fn contacts_beyond_the_most_are_counted() {
    let mut page = Page::new("frames", mesh(), &START.iter().copied().collect());
    page.add_frame("", &START).unwrap();
    let contact = contacts(&moved(-2.0))[0];
    for _ in 0..MOST_CONTACTS + 5 {
        page.add_contact(&contact).unwrap();
    }
    let json = Html::of(&page).json();
    assert_eq!(json["contacts"].as_array().unwrap().len(), MOST_CONTACTS);
    assert_eq!(json["contactCount"], MOST_CONTACTS + 5);
}

#[test]
fn frames_of_a_long_motion_are_left_out() {
    let mut page = Page::new("frames", mesh(), &START.iter().copied().collect()).with_most_text(1500);
    let contact = contacts(&moved(-2.0))[0];
    for i in 0..200 {
        page.add_frame("", &moved(f64::from(i).sin())).unwrap();
        if i == 71 {
            page.add_contact(&contact).unwrap();
        }
    }
    let html = Html::of(&page);
    let json = html.json();
    let frames = json["frames"].as_array().unwrap();
    let numbers: Vec<u64> = frames
        .iter()
        .map(|frame| frame["number"].as_u64().unwrap())
        .collect();
    assert!(numbers.len() < 60 && numbers.is_sorted(), "{numbers:?}");
    for kept in [0, 70, 71, 198, 199] {
        assert!(numbers.contains(&kept), "{kept} of {numbers:?}");
    }
    assert_eq!(json["contacts"][0]["frame"], 70);
    for (index, &number) in numbers.iter().enumerate() {
        let expected = moved((number as f64).sin())[3][2];
        assert!(
            (html.positions(index)[3][2] - expected).abs() < 1e-5,
            "frame {number}"
        );
    }
}

proptest! {
    /// Positions of any size: numbers that a graphics card accepts, and valid JSON.
    #[test]
    fn positions_are_finite(
        points in prop::collection::vec(prop::array::uniform3(prop::num::f64::NORMAL | prop::num::f64::ZERO), 1..6),
        other in prop::num::f64::NORMAL,
    ) {
        let mesh = TriangleMesh::new(points.len(), Vec::new()).unwrap();
        let mut page = Page::new("points", mesh, &points.iter().copied().collect());
        page.add_frame("", &points).unwrap();
        page.add_frame("", &vec![[other; 3]; points.len()]).unwrap();
        let html = Html::of(&page);
        prop_assert!(html.words("frame-0").into_iter().chain(html.words("frame-1")).map(f32::from_bits).all(f32::is_finite));
        prop_assert!(html.json()["scale"].as_f64().unwrap() > 0.0);
    }
}
