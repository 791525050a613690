//! Small pieces of source code, and their mutations.

use super::*;

fn rewritten(source: &str, dropped: &[u32]) -> (Vec<String>, String) {
    let rewritten =
        rewrite(source, "x.rs", 1, &dropped.iter().copied().collect()).expect("the source is Rust");
    let changes = rewritten
        .mutations
        .iter()
        .map(|mutation| mutation.place.replace('\t', " "))
        .collect();
    (
        changes,
        rewritten.source.split_whitespace().collect::<Vec<_>>().join(" "),
    )
}

#[test]
fn a_condition_selects_each_mutation() {
    let (changes, source) = rewritten("fn f(a: u8) -> u8 {\n    a - g()\n}", &[]);
    assert_eq!(
        changes,
        ["x.rs:2 f - -> + in a - g ()", "x.rs:2 f - -> / in a - g ()"]
    );
    assert_eq!(
        source,
        "fn f(a: u8) -> u8 { (match (a, g()) { (left, right) => { (if crate::mutated(2u32) { left / right } else { \
         (if crate::mutated(1u32) { left + right } else { left - right }) }) } }) }"
    );
}

#[test]
fn what_is_dropped_leaves_the_code_and_the_numbers_of_others() {
    let (changes, source) = rewritten("fn f(a: f64) -> bool { let b = !g(a); b }", &[1, 2, 3]);
    assert!(changes.is_empty());
    assert_eq!(source, "fn f(a: f64) -> bool { let b = !g(a); b }");
    let (changes, _) = rewritten("fn f(a: f64) -> bool { let b = !g(a); b }", &[1, 2]);
    assert_eq!(changes, ["x.rs:1 f delete the sign of ! g (a)"]);
}

#[test]
fn tests_messages_and_constants_are_as_they_were() {
    let source = "const N: u8 = 1 + 2; impl fmt::Display for A { fn fmt(&self) -> u8 { 3 } } const fn f() -> u8 { 4 } \
                  #[cfg(test)] mod tests { fn f() -> u8 { 5 } } #[test] fn g() { h(6); }";
    let (changes, same) = rewritten(source, &[]);
    assert!(changes.is_empty());
    assert_eq!(same, source);
    assert_eq!(
        test_modules("#[cfg(test)] mod a; mod b;").expect("the source is Rust"),
        ["a"]
    );
}

#[test]
fn statements_are_deleted_and_conditions_are_forced() {
    let (changes, _) = rewritten(
        "fn f(a: &mut u8) { if g() { *a += h(); } match a { A => B, C if d() => E, _ => F } }",
        &[],
    );
    let changes: Vec<_> = changes
        .iter()
        .map(|change| change.trim_start_matches("x.rs:1 f "))
        .collect();
    assert_eq!(
        changes,
        [
            "return",
            "g () -> false",
            "g () -> true",
            "-= in * a += h ()",
            "delete * a += h () ;",
            "delete A",
            "d () -> false",
            "d () -> true",
        ]
    );
}
