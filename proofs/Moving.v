(** Contact between two times: [Moving] and [is_contact] of the file [contact.rs]. *)

From Coq Require Import Reals ZArith List Bool Lra Lia FunctionalExtensionality.
Require Import Vectors Motion Separation Polynomial Contact.
Import ListNotations.
Open Scope R_scope.

(** The pairs have as many vertices as their kind says. *)
Definition fits {V} (k : kind) (p : pair V) : Prop :=
  match k, first V p, second V p with
  | VertexFace, [_], [_; _; _] | EdgeEdge, [_; _], [_; _] | VertexEdge, [_], [_; _]
  | VertexVertex, [_], [_] | EdgeFace, [_; _], [_; _; _] => True
  | _, _, _ => False
  end.

Lemma difference_vector n a b s : has_degree n a -> has_degree n b ->
  values (polynomial_difference a b) s = minus (values a s) (values b s).
Proof. intros; apply functional_extensionality; apply (difference_values n); assumption. Qed.

Lemma cross_vector n o a b s : has_degree n a -> has_degree o b ->
  values (polynomial_cross a b) s = cross (values a s) (values b s).
Proof. intros; apply functional_extensionality; apply (cross_values n o); assumption. Qed.

(** ** The polynomials of four vertices *)

Definition normal_of (a b d : polynomials) := polynomial_cross (polynomial_difference b a) (polynomial_difference d a).
Definition side_of (i j p : polynomials) := polynomial_cross (polynomial_difference i p) (polynomial_difference j p).

(** [coplanarity]: the normal n, the polynomial c, and the sides. *)
Definition coplanarity (k : kind) (x : list polynomials) : option (polynomials * polynomial * list polynomials) :=
  match k, x with
  | VertexFace, [x0; x1; x2; x3] =>
      let n := normal_of x1 x2 x3 in
      Some (n, polynomial_dot n (polynomial_difference x0 x1), [side_of x1 x2 x0; side_of x2 x3 x0; side_of x3 x1 x0])
  | EdgeEdge, [x0; x1; x2; x3] =>
      let e := polynomial_difference x1 x0 in
      let f := polynomial_difference x3 x2 in
      let w := polynomial_difference x2 x0 in
      let n := polynomial_cross e f in
      let u := polynomial_cross w f in
      let v := polynomial_cross w e in
      Some (n, polynomial_dot n w, [polynomial_difference n u; polynomial_difference n v; u; v])
  | _, _ => None
  end.

(** [is_inside]; the certificate gives the factor f, or none for c itself. *)
Definition is_inside (k : kind) (x : list polynomials) (component : axis) (factor : option polynomial) : bool :=
  match coplanarity k x with
  | None => false
  | Some (n, c, sides) =>
      let f := match factor with Some f => f | None => c end in
      let sign := has_sign true (n component) in
      let is_inner side := has_sign sign (side component) || is_multiple_of (side component) f in
      changes_sign f && is_multiple_of c f && has_sign sign (n component) && forallb is_inner sides
  end.

(** [vertex_on_edge]. *)
Definition vertex_on_edge (k : kind) : list (nat * nat * nat) :=
  match k with
  | VertexFace => [(0, 1, 2); (0, 2, 3); (0, 3, 1)]
  | EdgeEdge => [(0, 2, 3); (1, 2, 3); (2, 0, 1); (3, 0, 1)]
  | VertexEdge => [(0, 1, 2)]
  | VertexVertex => [(0, 1, 1)]
  | EdgeFace => []
  end%nat.

(** [is_on_edge]. *)
Definition is_on_edge (k : kind) (x : list polynomials) (row : nat) (f : polynomial) : bool :=
  match nth_error (vertex_on_edge k) row with
  | None => false
  | Some (q, a, b) =>
      match nth_error x q, nth_error x a, nth_error x b with
      | Some q, Some a, Some b =>
          let a := polynomial_difference a q in
          let b := polynomial_difference b q in
          let line := polynomial_cross a b in
          changes_sign f
          && forallb (fun k => is_multiple_of (line k) f) [X; Y; Z3]
          && (has_sign false (polynomial_dot a b) || is_multiple_of (polynomial_dot a b) f)
      | _, _, _ => false
      end
  end.

(** A side that is inner has the sign of the normal at the root, or vanishes there. *)
Lemma inner_side n side f s : 0 < s < 1 -> value f s = 0 ->
  has_sign (has_sign true n) n = true ->
  has_sign (has_sign true n) side || is_multiple_of side f = true ->
  0 <= value side s * value n s.
Proof.
  intros inside root normal inner; apply orb_prop in inner as [same|zero].
  - apply has_sign_value with (s := s) in normal, same; try lra.
    destruct (has_sign true n); nra.
  - rewrite (is_multiple_of_root _ _ _ zero inside root); lra.
Qed.

Lemma normal_not_zero n s : 0 < s < 1 -> has_sign (has_sign true n) n = true -> value n s <> 0.
Proof.
  intros inside normal; apply has_sign_value with (s := s) in normal; try lra.
  destruct (has_sign true n); lra.
Qed.

(** ** Primitives that move *)

Section Moving.
Variable V : Type.
Variable m : motion V.

Definition touches (p : pair V) (t : R) :=
  exists a, hull (place V m (first V p) t) a /\ hull (place V m (second V p) t) a.

Lemma touches_within p t : touches p t -> within V m p t.
Proof.
  intros (a & first & second); exists a, a; split; [exact first|split; [exact second|]].
  replace (dot (minus a a) (minus a a)) with 0 by (unfold dot, minus; ring).
  apply Rle_0_sqr.
Qed.

Variables before after : time.

Definition common := Nat.max (power before) (power after).

(** [Moving::new]: a vertex from T to T⁺, with one denominator. *)
Definition moving (v : V) : polynomials := fun k =>
  [at_time V m v (over before common) k; at_time V m v (over after common) k].

(** The time at the parameter s. *)
Definition time_at (s : R) := (1 - s) * moment before + s * moment after.

Lemma moving_degree v : has_degree 1 (moving v).
Proof. intros k; reflexivity. Qed.

Lemma moving_value v s k : values (moving v) s k = 2 ^ common * position V m v (time_at s) k.
Proof.
  unfold values, value, moving; simpl; rewrite !at_time_exact, !moment_over.
  unfold time_at; rewrite position_linear.
  replace (power (over before common)) with common by (simpl; unfold common; lia).
  replace (power (over after common)) with common by (simpl; unfold common; lia).
  ring.
Qed.

Lemma mean_scaled weights vertices s k :
  mean weights (map (fun v => values (moving v) s) vertices) k
    = 2 ^ common * mean weights (place V m vertices (time_at s)) k.
Proof.
  revert vertices; induction weights as [|w weights IH]; intros [|v vertices]; simpl; try ring.
  rewrite moving_value; fold (place V m vertices (time_at s)); rewrite IH; ring.
Qed.

Lemma hull_scaled vertices a s : hull (map (fun v => values (moving v) s) vertices) a ->
  hull (place V m vertices (time_at s)) (fun k => a k / 2 ^ common).
Proof.
  intros (weights & same & positive & total & at_mean); exists weights.
  unfold place in *; rewrite map_length in *; repeat split; try assumption.
  intros k; rewrite at_mean, mean_scaled; unfold place; pose proof (power_positive common); field; lra.
Qed.

Lemma touches_scaled p a s :
  hull (map (fun v => values (moving v) s) (first V p)) a ->
  hull (map (fun v => values (moving v) s) (second V p)) a -> touches p (time_at s).
Proof. intros first second; exists (fun k => a k / 2 ^ common); split; apply hull_scaled; assumption. Qed.

Definition vertices (p : pair V) := (first V p ++ second V p).

(** The proof by a root of coplanarity. *)
Theorem is_inside_touches k p component factor : fits k p ->
  is_inside k (map moving (vertices p)) component factor = true ->
  exists s, 0 < s < 1 /\ touches p (time_at s).
Proof.
  unfold is_inside, vertices; destruct p as [xs ys near]; unfold fits; simpl.
  destruct k; try (destruct xs as [|? [|]], ys as [|? [|? [|]]]; simpl; tauto || (intros; discriminate)).
  - destruct xs as [|p [|]]; simpl; try tauto; destruct ys as [|a [|b [|d [|]]]]; simpl; try tauto; intros _.
    set (n := normal_of (moving a) (moving b) (moving d)).
    set (c := polynomial_dot n (polynomial_difference (moving p) (moving a))).
    set (f := match factor with Some f => f | None => c end).
    intros all; apply andb_prop in all as (all & sides); apply andb_prop in all as (all & normal).
    apply andb_prop in all as (changes & divides).
    apply changes_sign_root in changes as (s & inside & root); exists s; split; [exact inside|].
    pose proof (is_multiple_of_root _ _ _ divides inside root) as flat.
    pose proof (normal_not_zero _ _ inside normal) as other.
    repeat (apply andb_prop in sides; destruct sides as (?inner & sides)).
    apply (inner_side _ _ f s inside root normal) in inner, inner0, inner1.
    assert (forall x y, has_degree 1 (polynomial_difference (moving x) (moving y))) as degree
      by (intros; apply difference_degree; apply moving_degree).
    assert (has_degree 2 n) as n_degree by (apply (cross_degree 1 1); apply degree).
    unfold c in flat; rewrite (dot_value 2 1) in flat by auto.
    assert (forall x y z, values (side_of (moving x) (moving y) (moving z)) s
      = cross (minus (values (moving x) s) (values (moving z) s)) (minus (values (moving y) s) (values (moving z) s))) as side
      by (intros; unfold side_of; rewrite (cross_vector 1 1) by auto;
          rewrite !(difference_vector 1) by apply moving_degree; reflexivity).
    assert (values n s = cross (minus (values (moving b) s) (values (moving a) s)) (minus (values (moving d) s) (values (moving a) s)))
      as normal_value by apply (side b d a).
    rewrite (difference_vector 1), normal_value in flat by apply moving_degree.
    change (value (n component) s) with (values n s component) in *.
    repeat match goal with H : context [value (side_of ?i ?j ?l component) s] |- _ =>
      change (value (side_of i j l component) s) with (values (side_of i j l) s component) in H end.
    rewrite ?side, ?normal_value in *.
    apply (touches_scaled _ (values (moving p) s)); simpl.
    + exists [1]; split; [reflexivity|split; [each lra|split; [simpl; lra|intros; simpl; lra]]].
    + apply (point_in_face _ _ _ _ component); assumption.
  - destruct xs as [|a0 [|a1 [|]]]; simpl; try tauto; destruct ys as [|b0 [|b1 [|]]]; simpl; try tauto; intros _.
    set (e := polynomial_difference (moving a1) (moving a0)).
    set (g := polynomial_difference (moving b1) (moving b0)).
    set (w := polynomial_difference (moving b0) (moving a0)).
    set (n := polynomial_cross e g); set (u := polynomial_cross w g); set (v := polynomial_cross w e).
    set (c := polynomial_dot n w).
    set (f := match factor with Some f => f | None => c end).
    intros all; apply andb_prop in all as (all & sides); apply andb_prop in all as (all & normal).
    apply andb_prop in all as (changes & divides).
    apply changes_sign_root in changes as (s & inside & root); exists s; split; [exact inside|].
    pose proof (is_multiple_of_root _ _ _ divides inside root) as flat.
    pose proof (normal_not_zero _ _ inside normal) as other.
    repeat (apply andb_prop in sides; destruct sides as (?inner & sides)).
    apply (inner_side _ _ f s inside root normal) in inner, inner0, inner1, inner2.
    assert (forall x y, has_degree 1 (polynomial_difference (moving x) (moving y))) as degree
      by (intros; apply difference_degree; apply moving_degree).
    assert (has_degree 2 n /\ has_degree 2 u /\ has_degree 2 v) as (n_degree & u_degree & v_degree)
      by (repeat split; apply (cross_degree 1 1); apply degree).
    unfold c in flat; rewrite (dot_value 2 1) in flat by (assumption || apply degree).
    change (value (n component) s) with (values n s component) in *.
    change (value (u component) s) with (values u s component) in *.
    change (value (v component) s) with (values v s component) in *.
    change (value (polynomial_difference n u component) s) with (values (polynomial_difference n u) s component) in *.
    change (value (polynomial_difference n v component) s) with (values (polynomial_difference n v) s component) in *.
    rewrite (difference_vector 2) in inner, inner0 by assumption; unfold minus in inner, inner0.
    assert (forall x y, values (polynomial_difference (moving x) (moving y)) s
      = minus (values (moving x) s) (values (moving y) s)) as differences
      by (intros; apply (difference_vector 1); apply moving_degree).
    unfold n, u, v in inner, inner0, inner1, inner2, other, flat.
    assert (forall a b d x, values (polynomial_cross (polynomial_difference (moving a) (moving b))
      (polynomial_difference (moving d) (moving x))) s
      = cross (minus (values (moving a) s) (values (moving b) s)) (minus (values (moving d) s) (values (moving x) s))) as crosses
      by (intros; rewrite (cross_vector 1 1), !differences by apply degree; reflexivity).
    unfold e, g, w in inner, inner0, inner1, inner2, other, flat.
    repeat rewrite crosses in *; rewrite differences in flat.
    destruct (edges_cross _ _ _ _ component flat other inner inner0 inner1 inner2) as (a & on_first & on_second).
    apply (touches_scaled _ a); assumption.
Qed.

(** The proof by a vertex on an edge. *)
Theorem is_on_edge_touches k p row f : fits k p ->
  is_on_edge k (map moving (vertices p)) row f = true -> exists s, 0 < s < 1 /\ touches p (time_at s).
Proof.
  intros fit holds.
  assert (forall q a b s, 0 < s < 1 -> value f s = 0 ->
    forallb (fun k => is_multiple_of (side_of (moving a) (moving b) (moving q) k) f) [X; Y; Z3]
      && (has_sign false (polynomial_dot (polynomial_difference (moving a) (moving q)) (polynomial_difference (moving b) (moving q)))
          || is_multiple_of (polynomial_dot (polynomial_difference (moving a) (moving q)) (polynomial_difference (moving b) (moving q))) f)
      = true ->
    hull [values (moving a) s; values (moving b) s] (values (moving q) s)) as on_edge.
  { clear; intros q a b s inside root all; apply andb_prop in all as (line & between).
    assert (forall x y, has_degree 1 (polynomial_difference (moving x) (moving y))) as degree
      by (intros; apply difference_degree; apply moving_degree).
    apply point_on_edge.
    - intros k; rewrite forallb_forall in line.
      rewrite <- !(difference_vector 1), <- (cross_vector 1 1) by (apply degree || apply moving_degree).
      apply (is_multiple_of_root _ f s); [apply line; destruct k; simpl; tauto|exact inside|exact root].
    - rewrite <- !(difference_vector 1), <- (dot_value 1 1) by (apply degree || apply moving_degree).
      apply orb_prop in between as [negative|zero].
      + apply has_sign_value with (s := s) in negative; lra.
      + rewrite (is_multiple_of_root _ _ _ zero inside root); lra. }
  unfold is_on_edge in holds.
  destruct (nth_error (vertex_on_edge k) row) as [[[q a] b]|] eqn:named; [|discriminate].
  destruct (nth_error (map moving (vertices p)) q) as [xq|] eqn:q_is; [|discriminate].
  destruct (nth_error (map moving (vertices p)) a) as [xa|] eqn:a_is; [|discriminate].
  destruct (nth_error (map moving (vertices p)) b) as [xb|] eqn:b_is; [|discriminate].
  rewrite <- andb_assoc in holds; apply andb_prop in holds as (changes & holds).
  apply changes_sign_root in changes as (s & inside & root); exists s; split; [exact inside|].
  assert (forall vq va vb, Some xq = Some (moving vq) -> Some xa = Some (moving va) -> Some xb = Some (moving vb) ->
    hull [values (moving va) s; values (moving vb) s] (values (moving vq) s)) as found
    by (intros ? ? ? [= ->] [= ->] [= ->]; apply on_edge; assumption).
  rewrite <- q_is, <- a_is, <- b_is in found; clear holds on_edge q_is a_is b_is.
  apply nth_error_In in named; destruct p as [xs ys near]; unfold vertices, fits in *; simpl in fit, found.
  assert (forall z, hull [values (moving z) s] (values (moving z) s)) as alone
    by (intros z; exists [1]; split; [reflexivity|split; [each lra|split; [simpl; lra|intros; simpl; lra]]]).
  destruct k; destruct xs as [|v0 [|v1 [|]]], ys as [|w0 [|w1 [|w2 [|]]]]; try contradiction fit; simpl in named, found;
    repeat (destruct named as [named|named]); try contradiction named; injection named as <- <- <-;
    specialize (found _ _ _ eq_refl eq_refl eq_refl);
    first
      [ apply (touches_scaled _ (values (moving v0) s)); simpl; [|eapply hull_between; [| |exact found]; simpl; tauto];
        apply hull_vertex; simpl; tauto
      | apply (touches_scaled _ (values (moving v1) s)); simpl; [|eapply hull_between; [| |exact found]; simpl; tauto];
        apply hull_vertex; simpl; tauto
      | apply (touches_scaled _ (values (moving w0) s)); simpl; [eapply hull_between; [| |exact found]; simpl; tauto|];
        apply hull_vertex; simpl; tauto
      | apply (touches_scaled _ (values (moving w1) s)); simpl; [eapply hull_between; [| |exact found]; simpl; tauto|];
        apply hull_vertex; simpl; tauto ].
Qed.
End Moving.
