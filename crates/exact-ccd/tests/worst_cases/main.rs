//! The answers to queries that are as costly as possible are those of the definition.

mod coincident;
mod digest;
mod families;

use exact_ccd::{EdgeEdge, Query, Stage, VertexFace, exact};

use families::{Family, Primitives, families};

/// The number of queries of each family.
const COUNT: usize = 100;

/// The digests of the families, vertex-face and edge-edge, as computed by an independent implementation
/// with Sturm chains.
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
    [0x8929_0f58_593c_8ea5, 0x8929_0f58_593c_8ea5],
    [0xd449_2c32_1ffb_0e19, 0x4c61_3bfd_69f1_66df],
    [0x4672_c5bf_b8f7_d757, 0xa538_1214_1f54_a160],
    [0x6f80_6ce8_03d1_dc3e, 0x3561_8b5a_a9d7_b9be],
    [0x7765_47ed_8806_b46c, 0x5755_7319_6547_bdcc],
    [0xa0a5_df72_2beb_8e85, 0xa0a5_df72_2beb_8e85],
    [0xa0a5_df72_2beb_8e85, 0xa0a5_df72_2beb_8e85],
    [0x630b_7d21_afc6_f973, 0x0df6_5ea0_cb51_a18f],
];

fn recorded<K: Primitives>(kind: usize) {
    for ((name, family), recorded) in families::<K>().into_iter().zip(RECORDED) {
        assert_eq!(digest::digest::<K>(family, COUNT), recorded[kind], "{name}");
    }
}

#[test]
fn exact_answers_are_those_recorded() {
    recorded::<VertexFace>(0);
    recorded::<EdgeEdge>(1);
}

fn filters_agree<K: Primitives>() {
    for (_, family) in families::<K>() {
        for query in digest::queries::<K>(family, COUNT) {
            assert_eq!(query.collides(), exact::collides(&query), "{query:?}");
            assert_eq!(query.contact_times(), exact::contact_times(&query), "{query:?}");
        }
    }
}

#[test]
fn filters_agree_with_the_exact_path() {
    filters_agree::<VertexFace>();
    filters_agree::<EdgeEdge>();
}

/// Checks that comparisons settle coincident points, with the answers of the exact path.
fn coincidence<K: Primitives>(family: Family) {
    let mut settled = 0;
    for query in digest::queries::<K>(family, 1000) {
        let (collides, stage) = query.collides_with_stage();
        assert_eq!(collides, exact::collides(&query), "{query:?}");
        assert_ne!(stage, Stage::Exact, "{query:?}");
        settled += usize::from(stage == Stage::Coincident);
        assert_eq!(query.contact_times(), exact::contact_times(&query), "{query:?}");
        let [impact, exactly] = [query.impact(), exact::impact(&query)];
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
        assert_eq!(query.collides_with_stage(), (true, Stage::Coincident));
        assert_eq!(query.impact(), exact::impact(&query));
    }
}
