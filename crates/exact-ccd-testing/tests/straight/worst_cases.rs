//! The answers to queries that are as costly as possible agree with the definition.

use exact_ccd::{CONTACT, EdgeEdge, Point, Query, Separation, Stage, VertexFace};

use exact_ccd_testing::definition::assert_defined;
use exact_ccd_testing::hard_cases::digest::Digest;
use exact_ccd_testing::hard_cases::extremes::families;
use exact_ccd_testing::hard_cases::hard::Hard;
use exact_ccd_testing::hard_cases::{Family, coincident, queries};

/// The number of queries of each family.
const COUNT: usize = 100;

/// The number of queries of each family that are compared with the definition, which is slow on them.
const DEFINED: usize = 5;

fn are_defined<K: Hard>() {
    for (_, family) in families::<K>() {
        for query in queries::<K>(family, DEFINED) {
            assert_defined(&query, Separation::ZERO);
        }
    }
}

#[test]
fn answers_to_a_vertex_and_a_face_are_those_of_the_definition() {
    are_defined::<VertexFace>();
}

#[test]
fn answers_to_two_edges_are_those_of_the_definition() {
    are_defined::<EdgeEdge>();
}

/// Some queries of every family collide, so that its digest is not the digest of an empty list.
fn some_collide<K: Hard>() {
    for (name, family) in families::<K>() {
        let mut queries = queries::<K>(family, COUNT);
        assert!(queries.any(|query| query.exactly().collides(CONTACT)), "{name}");
    }
}

#[test]
fn queries_of_every_family_collide() {
    some_collide::<VertexFace>();
    some_collide::<EdgeEdge>();
}

/// The sine of the angle between e₁ and e₂, at t = 0 and at t = 1.
fn sines<K: Hard>(query: &Query<K>) -> [f64; 2] {
    query.points().map(|now| {
        let now = now.as_ref();
        let [u, v] = K::SPANNING.map(|[i, j]| [0, 1, 2].map(|axis: usize| now[j][axis] - now[i][axis]));
        let minor = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        let length = |x: Point| x[0].hypot(x[1]).hypot(x[2]);
        length([minor(1, 2), minor(2, 0), minor(0, 1)]) / (length(u) * length(v))
    })
}

fn are_nearly_parallel<K: Hard>() {
    let all = families::<K>();
    let (_, family) = all.iter().find(|(name, _)| *name == "nearly parallel").unwrap();
    for query in queries::<K>(*family, COUNT) {
        let sines = sines(&query);
        assert!(sines.iter().all(|&sine| sine < 1e-13), "{sines:?} {query:?}");
    }
}

#[test]
fn nearly_parallel_queries_are() {
    are_nearly_parallel::<VertexFace>();
    are_nearly_parallel::<EdgeEdge>();
}

/// The digests of the answers of the exact path to the families, vertex-face and edge-edge. They detect
/// changes, of parameters and normals too; the truth is the definition.
const RECORDED: [[u64; 2]; 19] = [
    [0x171b_587b_d2b1_92a8, 0x7d71_c11c_65d3_e2c0],
    [0x67eb_458d_86a6_5825, 0xae15_8f9a_4485_a22b],
    [0x63dc_1a19_271e_5965, 0x4111_8e00_cc20_f8dd],
    [0x0ec1_dbf5_841a_bf81, 0xe4c1_a633_2d6a_71cd],
    [0x3613_0938_99e8_8b78, 0x18b6_fdf3_e8ab_eeec],
    [0x275a_077c_66be_2e5a, 0x431c_7a90_6c4a_5137],
    [0x6e95_fa34_672b_2255, 0x4e4f_b01b_c042_f1d5],
    [0xbb23_22f2_dbec_41ee, 0xc5f7_5a63_61a8_80a2],
    [0xb59d_b99b_8fd4_d9c7, 0xf8f3_0335_a623_f199],
    [0x9868_cb33_f499_03d4, 0x4a30_f1c0_fc97_d096],
    [0xd8c0_642c_83ef_11eb, 0x519e_6a58_029c_569f],
    [0x2980_861a_bb7f_14d4, 0x8561_aa56_c95e_095e],
    [0x2b7d_ee19_947e_7538, 0xb268_18ec_bb78_488c],
    [0x4672_c5bf_b8f7_d757, 0xa538_1214_1f54_a160],
    [0x6f80_6ce8_03d1_dc3e, 0x3561_8b5a_a9d7_b9be],
    [0x7765_47ed_8806_b46c, 0x5755_7319_6547_bdcc],
    [0xa0a5_df72_2beb_8e85, 0xa0a5_df72_2beb_8e85],
    [0xa0a5_df72_2beb_8e85, 0xa0a5_df72_2beb_8e85],
    [0x630b_7d21_afc6_f973, 0x0df6_5ea0_cb51_a18f],
];

fn recorded<K: Hard>(kind: usize) {
    for ((name, family), recorded) in families::<K>().into_iter().zip(RECORDED) {
        let mut digest = Digest::default();
        queries::<K>(family, COUNT).for_each(|query| digest.add_exact_answers(&query, Separation::ZERO));
        let Digest(digest) = digest;
        assert_eq!(digest, recorded[kind], "{name}: {digest:#018x}");
    }
}

/// A digest that changes by intent is recorded anew, if the answers still agree with the definition.
#[test]
fn exact_answers_are_those_recorded() {
    recorded::<VertexFace>(0);
    recorded::<EdgeEdge>(1);
}

fn filters_agree<K: Hard>() {
    for (_, family) in families::<K>() {
        for query in queries::<K>(family, COUNT) {
            assert_eq!(
                query.collides(CONTACT),
                query.exactly().collides(CONTACT),
                "{query:?}"
            );
            assert_eq!(
                query.intervals(CONTACT),
                query.exactly().intervals(CONTACT),
                "{query:?}"
            );
        }
    }
}

#[test]
fn filters_agree_with_the_exact_path() {
    filters_agree::<VertexFace>();
    filters_agree::<EdgeEdge>();
}

/// Checks that comparisons settle coincident points, with the answers of the exact path.
fn coincidence<K: Hard>(family: Family) {
    let mut settled = 0;
    for query in queries::<K>(family, 1000) {
        let (collision, stage) = query.decide(CONTACT);
        assert_eq!(
            collision.is_some(),
            query.exactly().collides(CONTACT),
            "{query:?}"
        );
        assert_ne!(stage, Stage::Exact, "{query:?}");
        settled += usize::from(stage == Stage::Coincident);
        assert_eq!(
            query.intervals(CONTACT),
            query.exactly().intervals(CONTACT),
            "{query:?}"
        );
        let [impact, exactly] = [query.impact(CONTACT), query.exactly().impact(CONTACT)];
        assert_eq!(impact.map(|x| x.time), exactly.map(|x| x.time), "{query:?}");
        if stage == Stage::Coincident {
            assert_eq!(impact, exactly, "{query:?}");
        }
    }
    assert!(settled > 100, "{settled}");
}

#[test]
fn coincident_points_are_settled_by_comparisons() {
    for (_, family) in coincident::FAMILIES {
        coincidence::<VertexFace>(family);
        coincidence::<EdgeEdge>(family);
    }
}

/// At the end of the range, where the differences of other points overflow.
#[test]
fn one_place_at_the_end_of_the_range() {
    for x in [f64::MAX, 5e-324, -0.0, 1e300] {
        let points = [[x, -x, 0.0]; 4];
        let query = Query::<VertexFace>::new(points, points).unwrap();
        assert_eq!(query.decide(CONTACT).1, Stage::Coincident);
        assert!(query.collides(CONTACT));
        assert_eq!(query.impact(CONTACT), query.exactly().impact(CONTACT));
    }
}
