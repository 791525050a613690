(** Boxes that an axis separates have primitives that are apart: [Extent::of] and [is_separate] of
    [tree.rs]. *)

From Coq Require Import Reals ZArith List Bool Lra Lia.
Require Import Vectors Motion Lists Separation Grid Tree.
Import ListNotations.
Open Scope R_scope.

(** The direction of an axis. *)
Definition unit_vector (k : axis) (side : bool) : vector := fun j =>
  match k, j with X, X | Y, Y | Z3, Z3 => if side then -1 else 1 | _, _ => 0 end.

Lemma unit_length k side : sqrt (dot (unit_vector k side) (unit_vector k side)) = 1.
Proof.
  replace (dot (unit_vector k side) (unit_vector k side)) with 1; [apply sqrt_1|].
  unfold dot, unit_vector; destruct k, side; lra.
Qed.

Lemma dot_unit k side v : dot (unit_vector k side) v = if side then - v k else v k.
Proof. unfold dot, unit_vector; destruct k, side; lra. Qed.

Section Boxes.
Variable V : Type.
Variable m : motion V.
Hypothesis distance_not_negative : (0 <= distance V m)%Z.
Variable all : list V.
Variable until : time.

(** [Extent::of]: [at_end] says at which times, which are t = 0 twice for an edge and a face. *)
Definition vertex_extent (at_end : bool -> bool) (v : V) : extent := fun e k side =>
  if side then (- point V m all until (at_end e) v k)%Z else point V m all until (at_end e) v k.

Definition extent_of (at_end : bool -> bool) (a b c : V) : extent :=
  union (union (vertex_extent at_end a) (vertex_extent at_end b)) (vertex_extent at_end c).

Lemma extent_below at_end a b c v e k side : In v [a; b; c] ->
  (extent_of at_end a b c e k side <= vertex_extent at_end v e k side)%Z.
Proof. intros [<-|[<-|[<-|[]]]]; unfold extent_of, union; lia. Qed.

(** The numbers of boxes, so also the sums and differences of two, fit into 64 bits. *)
Theorem extent_fits at_end a b c e k side : In a all -> In b all -> In c all ->
  (Z.abs (extent_of at_end a b c e k side) <= 2 ^ 60)%Z.
Proof.
  intros a_here b_here c_here; unfold extent_of, union, vertex_extent.
  pose proof (point_bound V m all until (at_end e) a k a_here).
  pose proof (point_bound V m all until (at_end e) b k b_here).
  pose proof (point_bound V m all until (at_end e) c k c_here).
  destruct side; lia.
Qed.

Lemma separate_between at_end d p (a b c a' b' c' : V) t :
  (0 <= d)%Z ->
  (forall u, 0 < u -> (forall x, IZR (rounded V m all until x) <= u * IZR x < IZR (rounded V m all until x) + 1) ->
    (d < 2 ^ 62)%Z -> u * (2 ^ power until * IZR (reach V m p)) <= IZR d) ->
  (forall v, In v (first V p) \/ In v (second V p) -> In v all) ->
  (forall v, In v (first V p) -> In v [a; b; c]) -> (forall v, In v (second V p) -> In v [a'; b'; c']) ->
  is_separate d (extent_of at_end a b c) (extent_of at_end a' b' c') = true ->
  moment (end_time until (at_end false)) <= t <= moment (end_time until (at_end true)) -> apart V m p t.
Proof.
  intros d_least d_reach listed first_in second_in separate range.
  apply is_separate_witness in separate as (k & side & gap).
  apply (apart_between V m (unit_vector k side) p _ _ t distance_not_negative range).
  assert (forall e x y, In x (first V p) -> In y (second V p) ->
    IZR (reach V m p) * sqrt (dot (unit_vector k side) (unit_vector k side))
      < dot (unit_vector k side) (minus (position V m x (moment (end_time until (at_end e)))) (position V m y (moment (end_time until (at_end e)))))) as beyond;
    [|intros; split; apply beyond; assumption].
  intros e x y x_here y_here; rewrite unit_length, dot_unit, Rmult_1_r.
  specialize (gap e).
  pose proof (extent_below at_end a b c x e k side (first_in x x_here)) as x_below.
  pose proof (extent_below at_end a' b' c' y e k (negb side) (second_in y y_here)) as y_below.
  pose proof (point_bound V m all until (at_end e) x k (listed x (or_introl x_here))) as x_bound.
  pose proof (point_bound V m all until (at_end e) y k (listed y (or_intror y_here))) as y_bound.
  unfold vertex_extent in x_below, y_below.
  destruct (rounded_down V m all until) as (u & positive & scale).
  destruct (scale (at_time V m x (end_time until (at_end e)) k)) as (x_low & x_high).
  destruct (scale (at_time V m y (end_time until (at_end e)) k)) as (y_low & y_high).
  change (rounded V m all until (at_time V m x (end_time until (at_end e)) k)) with (point V m all until (at_end e) x k) in *.
  change (rounded V m all until (at_time V m y (end_time until (at_end e)) k)) with (point V m all until (at_end e) y k) in *.
  rewrite at_time_exact, end_power in x_low, x_high, y_low, y_high.
  set (px := point V m all until (at_end e) x k) in *; set (py := point V m all until (at_end e) y k) in *.
  assert (d < 2 ^ 62)%Z as short by (destruct side; simpl in *; lia).
  pose proof (d_reach u positive scale short) as up.
  pose proof (power_positive (power until)) as unit; set (P := 2 ^ power until) in *.
  assert (0 < u * P) as scale_positive by (apply Rmult_lt_0_compat; assumption).
  assert (if side then (d + 1 <= py - px)%Z else (d + 1 <= px - py)%Z) as apart by (destruct side; simpl in *; lia).
  apply Rmult_lt_reg_l with (u * P); [exact scale_positive|].
  unfold minus; destruct side; apply IZR_le in apart; rewrite minus_IZR, plus_IZR in apart; lra.
Qed.

(** What the search leaves out is apart, by more than the distance, from t = 0 to t = T. *)
Theorem separate_apart p (a b c a' b' c' : V) t :
  (forall v, In v (first V p) \/ In v (second V p) -> In v all) ->
  (forall v, In v (first V p) -> In v [a; b; c]) -> (forall v, In v (second V p) -> In v [a'; b'; c']) ->
  is_separate (grid_distance V m all until) (extent_of (fun e => e) a b c) (extent_of (fun e => e) a' b' c') = true ->
  0 <= t <= moment until -> apart V m p t.
Proof.
  intros listed first_in second_in separate range.
  apply (separate_between (fun e => e) (grid_distance V m all until) p a b c a' b' c'); try assumption.
  - apply grid_distance_least, distance_not_negative.
  - intros u positive scale short.
    apply Rle_trans with (2 := grid_distance_up V m all until u positive scale short).
    apply Rmult_le_compat_l; [lra|apply Rmult_le_compat_l; [apply Rlt_le, power_positive|]].
    apply IZR_le; unfold reach; destruct (has_distance V p); lia.
  - simpl; rewrite start_moment; exact range.
Qed.

(** An edge and a face that the search leaves out are apart at t = 0. *)
Theorem separate_rest p (a b c a' b' c' : V) : has_distance V p = false ->
  (forall v, In v (first V p) \/ In v (second V p) -> In v all) ->
  (forall v, In v (first V p) -> In v [a; b; c]) -> (forall v, In v (second V p) -> In v [a'; b'; c']) ->
  is_separate 0 (extent_of (fun _ => false) a b c) (extent_of (fun _ => false) a' b' c') = true -> apart V m p 0.
Proof.
  intros contact listed first_in second_in separate.
  apply (separate_between (fun _ => false) 0 p a b c a' b' c'); try assumption; [lia| |].
  - intros; unfold reach; rewrite contact; lra.
  - simpl; rewrite start_moment; lra.
Qed.

End Boxes.
