(** Positions as integers, times as ratios, and the pairs: the file [motion.rs].

    Vertices of a mesh are elements of a type V. A coordinate at the time k / 2^m is an integer over 2^m. *)

From Coq Require Import Reals ZArith List Lra Lia.
Require Import Vectors.
Import ListNotations.
Open Scope R_scope.

Definition shift_left (x : Z) (n : nat) : Z := (x * 2 ^ Z.of_nat n)%Z.

Lemma shift_left_real x n : IZR (shift_left x n) = IZR x * 2 ^ n.
Proof. unfold shift_left; rewrite mult_IZR, <- pow_IZR; reflexivity. Qed.

Lemma power_positive n : 0 < 2 ^ n.
Proof. apply pow_lt; lra. Qed.

(** [Time] of the code. *)
Record time := { numerator : Z; power : nat }.

Definition moment (t : time) : R := IZR (numerator t) / 2 ^ power t.

(** [Time::together] gives times one denominator, the largest. *)
Definition over (t : time) (n : nat) : time :=
  {| numerator := shift_left (numerator t) (n - power t); power := Nat.max n (power t) |}.

Theorem moment_over t n : moment (over t n) = moment t.
Proof.
  unfold moment, over; simpl; rewrite shift_left_real.
  pose proof (power_positive (power t)).
  destruct (Nat.le_ge_cases n (power t)) as [less|more].
  - replace (n - power t)%nat with 0%nat by lia; rewrite Nat.max_r by lia; simpl; lra.
  - rewrite Nat.max_l by lia.
    replace (2 ^ n) with (2 ^ (n - power t) * 2 ^ power t) by (rewrite <- pow_add; f_equal; lia).
    pose proof (power_positive (n - power t)); field; lra.
Qed.

(** What holds at both ends of a stretch for a linear function holds between. *)
Lemma mean_beyond l a b d : 0 <= l <= 1 -> d < a -> d < b -> d < (1 - l) * a + l * b.
Proof.
  intros (least & most) first second.
  assert (0 <= l * (b - d)) by (apply Rmult_le_pos; lra).
  assert (0 <= (1 - l) * (a - d)) by (apply Rmult_le_pos; lra).
  destruct (Req_dec l 0) as [->|inner]; [lra|].
  assert (0 < l * (b - d)) by (apply Rmult_lt_0_compat; lra).
  lra.
Qed.

(** A time between two others as a mean of them. *)
Lemma between_ends s e t : s <= t <= e -> exists l, 0 <= l <= 1 /\ t = (1 - l) * s + l * e.
Proof.
  intros (later & earlier); destruct (Rle_lt_or_eq_dec s e) as [less|same]; try lra.
  - exists ((t - s) / (e - s)); split; [split|field; lra].
    + apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra].
    + apply Rmult_le_reg_r with (e - s); [lra|].
      unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
  - exists 0; lra.
Qed.

Definition integer_point := axis -> Z.

Section Motion.
Variable V : Type.

(** [Motion] of the code: positions at both ends of the step, and the distance d. *)
Record motion := { ends : bool -> V -> integer_point; distance : Z }.

Variable m : motion.

(** [Motion::at]: the position, times the denominator of the time. *)
Definition at_time (v : V) (t : time) : integer_point := fun k =>
  ((shift_left 1 (power t) - numerator t) * ends m false v k + numerator t * ends m true v k)%Z.

(** The position of a vertex at a time: motion in a straight line. *)
Definition position (v : V) (t : R) : vector :=
  fun k => (1 - t) * IZR (ends m false v k) + t * IZR (ends m true v k).

Theorem at_time_exact v t k : IZR (at_time v t k) = 2 ^ power t * position v (moment t) k.
Proof.
  unfold at_time, position, moment; pose proof (power_positive (power t)).
  rewrite plus_IZR, !mult_IZR, minus_IZR, shift_left_real; field; lra.
Qed.

(** Positions are linear between any two times. *)
Lemma position_linear v s e l k :
  position v ((1 - l) * s + l * e) k = (1 - l) * position v s k + l * position v e k.
Proof. unfold position; ring. Qed.

(** [Pair] of the code. *)
Record pair := { first : list V; second : list V; has_distance : bool }.

(** The distance that counts for a pair. *)
Definition reach (p : pair) : Z := if has_distance p then distance m else 0%Z.

Definition place (vertices : list V) (t : R) : list vector := map (fun v => position v t) vertices.

(** Two points of the primitives are at most the distance from each other: contact if that is 0. *)
Definition within (p : pair) (t : R) :=
  exists a b, hull (place (first p) t) a /\ hull (place (second p) t) b
    /\ dot (minus a b) (minus a b) <= IZR (reach p) * IZR (reach p).

Definition apart (p : pair) (t : R) := ~ within p t.

(** The differences of vertices determine that a pair is apart: a lower bound along g suffices. *)
Lemma apart_along g l p t :
  (0 <= distance m)%Z -> IZR (reach p) * sqrt (dot g g) < l ->
  (forall x y, In x (first p) -> In y (second p) -> l <= dot g (minus (position x t) (position y t))) ->
  apart p t.
Proof.
  intros not_negative far all (a & b & a_inside & b_inside & near).
  assert (0 <= IZR (reach p)) by (apply IZR_le; unfold reach; destruct (has_distance p); lia).
  assert (l <= dot g (minus a b)) as gap.
  { apply (hull_gap _ _ _ _ _ _ a_inside b_inside).
    unfold place; intros x y x_here y_here; apply in_map_iff in x_here, y_here.
    destruct x_here as (v & <- & v_here), y_here as (w & <- & w_here); auto. }
  assert (dot (minus a b) (minus a b) > IZR (reach p) * IZR (reach p)); [|lra].
  apply (beyond g); lra.
Qed.

(** A direction that separates a pair by more than its distance at two times does so between them. *)
Theorem apart_between g p s e t :
  (0 <= distance m)%Z -> s <= t <= e ->
  (forall x y, In x (first p) -> In y (second p) ->
    IZR (reach p) * sqrt (dot g g) < dot g (minus (position x s) (position y s))
    /\ IZR (reach p) * sqrt (dot g g) < dot g (minus (position x e) (position y e))) ->
  apart p t.
Proof.
  intros not_negative in_stretch all (a & b & a_inside & b_inside & near).
  destruct (between_ends s e t in_stretch) as (l & l_range & t_is).
  (* A lower bound that is strict for every single pair of vertices is strict for the means. *)
  set (D := IZR (reach p) * sqrt (dot g g)) in *.
  set (values := flat_map (fun x => map (fun y => dot g (minus (position x t) (position y t))) (second p)) (first p)).
  assert (forall z, In z values -> D < z) as beyond_all.
  { unfold values; intros z here; apply in_flat_map in here; destruct here as (x & x_here & here).
    apply in_map_iff in here; destruct here as (y & <- & y_here).
    destruct (all x y x_here y_here) as (at_s & at_e).
    replace (dot g (minus (position x t) (position y t)))
      with ((1 - l) * dot g (minus (position x s) (position y s)) + l * dot g (minus (position x e) (position y e)))
      by (unfold dot, minus; rewrite t_is, !position_linear; ring).
    apply mean_beyond; assumption. }
  assert (exists least, D < least /\ forall z, In z values -> least <= z) as (least & least_far & least_all).
  { clearbody values; clear - beyond_all; induction values as [|z values IH].
    - exists (D + 1); split; [lra|intros z []].
    - destruct IH as (low & far & all). { intros y here; apply beyond_all; right; exact here. }
      exists (Rmin z low); split.
      + apply Rmin_glb_lt; [apply beyond_all; left; reflexivity|exact far].
      + intros y [<-|here]; [apply Rmin_l|apply Rle_trans with low; [apply Rmin_r|auto]]. }
  apply (apart_along g least p t not_negative least_far).
  - intros x y x_here y_here; apply least_all; apply in_flat_map; exists x; split; auto.
    apply in_map_iff; exists y; auto.
  - exists a, b; auto.
Qed.

End Motion.
