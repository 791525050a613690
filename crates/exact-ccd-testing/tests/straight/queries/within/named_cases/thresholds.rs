//! Numbers that are not valid distances.

use exact_ccd::{NonFinite, Query, Separation, VertexEdge, VertexVertex};

#[test]
fn a_separation_is_finite_and_at_least_zero() {
    for d in [-5e-324, -1.0, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(Separation::new(d).unwrap_err().value, d);
    }
    assert!(Separation::new(f64::NAN).unwrap_err().value.is_nan());
    assert!(Separation::new(-0.0).unwrap().get().is_sign_positive());
    assert_eq!(Separation::new(f64::MAX).unwrap().get(), f64::MAX);
}

#[test]
fn an_error_names_the_point_that_was_given() {
    let (good, bad) = ([0.0; 3], [0.0, f64::NAN, 0.0]);
    let place = |error: NonFinite| (error.time, error.point, error.value.is_nan());
    let error = Query::<VertexEdge>::new([good, good, bad], [good; 3]).unwrap_err();
    assert_eq!(place(error), (Some(0), 2, true));
    let error = Query::<VertexEdge>::new([good; 3], [bad, good, good]).unwrap_err();
    assert_eq!(place(error), (Some(1), 0, true));
    let error = Query::<VertexVertex>::new([good; 2], [good, bad]).unwrap_err();
    assert_eq!(place(error), (Some(1), 1, true));
}
