(** Directions that prove a pair to be apart: the file [separation.rs]. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
Require Import Vectors Motion Lists.
Import ListNotations.
Open Scope R_scope.

Inductive kind := VertexFace | EdgeEdge | VertexEdge | VertexVertex | EdgeFace.

(** [dot] of the code. *)
Definition integer_dot (a b : integer_point) : Z := (a X * b X + a Y * b Y + a Z3 * b Z3)%Z.

Definition real (a : integer_point) : vector := fun k => IZR (a k).

Lemma integer_dot_real a b : IZR (integer_dot a b) = dot (real a) (real b).
Proof. unfold integer_dot, dot, real; now rewrite !plus_IZR, !mult_IZR. Qed.

Lemma integer_square_not_negative a : (0 <= integer_dot a a)%Z.
Proof. unfold integer_dot; nia. Qed.

Section Separation.
Variable V : Type.
Variable m : motion V.
Hypothesis distance_not_negative : (0 <= distance V m)%Z.

(** [Stretch] of the code, whose start is the end of the one before. *)
Record stretch := { stretch_end : time; from : integer_point; to : integer_point }.

(** [gap] of the code. *)
Definition gap (p : pair V) (along : V -> Z) : Z :=
  (least (map along (first V p)) - most (map along (second V p)))%Z.

Lemma gap_below p along x y : In x (first V p) -> In y (second V p) -> (gap p along <= along x - along y)%Z.
Proof.
  intros x_here y_here; unfold gap.
  pose proof (least_below _ _ (in_map along _ _ x_here)).
  pose proof (most_above _ _ (in_map along _ _ y_here)); lia.
Qed.

(** [is_beyond] of the code; [d] is the distance in the unit of the positions. *)
Definition is_beyond (k : kind) (d gap square : Z) : bool :=
  match k with
  | EdgeFace => ((0 <=? gap) && (0 <? square))%Z
  | _ => ((0 <? gap) && (d * d * square <? gap * gap))%Z
  end.

(** [Stretch::holds]. *)
Definition holds (k : kind) (p : pair V) (start : time) (s : stretch) : bool :=
  let power := Nat.max (power start) (power (stretch_end s)) in
  let start := over start power in
  let finish := over (stretch_end s) power in
  let first_square := integer_dot (from s) (from s) in
  let last_square := integer_dot (to s) (to s) in
  let d := if has_distance V p then shift_left (distance V m) power else 0%Z in
  let product g t v := integer_dot g (at_time V m v t) in
  is_beyond k d (gap p (product (from s) start)) first_square
  && is_beyond k d (gap p (product (to s) finish)) last_square
  && is_beyond k d (gap p (fun v => product (from s) finish v + product (to s) start v)%Z)
       (shift_left (first_square + last_square) 1).

(** [is_apart], which begins at t = 0: each stretch begins where the one before it ends. *)
Fixpoint is_apart (k : kind) (p : pair V) (start : time) (stretches : list stretch) : bool :=
  match stretches with
  | [] => true
  | s :: rest => holds k p start s && is_apart k p (stretch_end s) rest
  end.

Lemma is_beyond_real k d l s : (0 <= d)%Z -> (0 <= s)%Z -> k <> EdgeFace ->
  is_beyond k d l s = true -> IZR d * sqrt (IZR s) < IZR l.
Proof.
  intros d_least s_least other beyond.
  assert ((0 < l)%Z /\ (d * d * s < l * l)%Z) as (positive & far)
    by (destruct k; simpl in beyond; try contradiction; apply andb_prop in beyond; lia).
  apply IZR_lt in positive, far; apply IZR_le in d_least, s_least.
  rewrite !mult_IZR in far.
  apply Rsqr_incrst_0; try lra.
  - unfold Rsqr. replace (IZR d * sqrt (IZR s) * (IZR d * sqrt (IZR s)))
      with (IZR d * IZR d * (sqrt (IZR s) * sqrt (IZR s))) by ring.
    rewrite sqrt_sqrt; lra.
  - apply Rmult_le_pos; [lra|apply sqrt_pos].
Qed.

(** The coefficient in the middle: |g_s| + |g_e| is at most the root of 2 (|g_s|² + |g_e|²). *)
Lemma root_of_sum a b : 0 <= a -> 0 <= b -> sqrt a + sqrt b <= sqrt ((a + b) * 2).
Proof.
  intros a_least b_least; apply Rsqr_incr_0; try apply sqrt_pos.
  - rewrite Rsqr_sqrt by lra; unfold Rsqr.
    pose proof (sqrt_sqrt a a_least); pose proof (sqrt_sqrt b b_least).
    pose proof (Rle_0_sqr (sqrt a - sqrt b)); unfold Rsqr in *; lra.
  - pose proof (sqrt_pos a); pose proof (sqrt_pos b); lra.
Qed.

Definition turned (g h : vector) (l : R) : vector := fun k => (1 - l) * g k + l * h k.

Lemma length_square v : sqrt (dot v v) * sqrt (dot v v) = dot v v.
Proof. apply sqrt_sqrt, square_not_negative. Qed.

(** Length is convex. *)
Lemma length_turned g h l : 0 <= l <= 1 ->
  sqrt (dot (turned g h l) (turned g h l)) <= (1 - l) * sqrt (dot g g) + l * sqrt (dot h h).
Proof.
  intros range; pose proof (sqrt_pos (dot g g)); pose proof (sqrt_pos (dot h h)).
  assert (0 <= (1 - l) * sqrt (dot g g)) by (apply Rmult_le_pos; lra).
  assert (0 <= l * sqrt (dot h h)) by (apply Rmult_le_pos; lra).
  apply Rsqr_incr_0; [|apply sqrt_pos|lra].
  rewrite Rsqr_sqrt by apply square_not_negative.
  assert (dot g h <= sqrt (dot g g) * sqrt (dot h h)).
  { pose proof (cauchy_schwarz g h) as bound.
    destruct (Rle_lt_dec (dot g h) 0); [apply Rle_trans with 0; [lra|apply Rmult_le_pos; lra]|].
    apply Rsqr_incr_0; try lra; [|apply Rmult_le_pos; lra].
    unfold Rsqr; replace (sqrt (dot g g) * sqrt (dot h h) * (sqrt (dot g g) * sqrt (dot h h)))
      with (sqrt (dot g g) * sqrt (dot g g) * (sqrt (dot h h) * sqrt (dot h h))) by ring.
    rewrite !length_square; exact bound. }
  replace (dot (turned g h l) (turned g h l))
    with ((1 - l) * (1 - l) * dot g g + 2 * ((1 - l) * l * dot g h) + l * l * dot h h)
    by (unfold dot, turned; ring).
  assert ((1 - l) * l * dot g h <= (1 - l) * l * (sqrt (dot g g) * sqrt (dot h h)))
    by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|lra]).
  pose proof (length_square g) as g_square; pose proof (length_square h) as h_square.
  set (a := sqrt (dot g g)) in *; set (b := sqrt (dot h h)) in *; unfold Rsqr.
  rewrite <- g_square, <- h_square; lra.
Qed.

Lemma bernstein_less l a0 a1 a2 b0 b1 b2 : 0 <= l <= 1 -> a0 < b0 -> a1 < b1 -> a2 < b2 ->
  (1 - l) * (1 - l) * a0 + (1 - l) * l * a1 + l * l * a2 < (1 - l) * (1 - l) * b0 + (1 - l) * l * b1 + l * l * b2.
Proof.
  intros range less0 less1 less2.
  assert (0 <= (1 - l) * (1 - l) * (b0 - a0)) by (repeat apply Rmult_le_pos; lra).
  assert (0 <= (1 - l) * l * (b1 - a1)) by (repeat apply Rmult_le_pos; lra).
  assert (0 <= l * l * (b2 - a2)) by (repeat apply Rmult_le_pos; lra).
  destruct (Req_dec l 0) as [->|inner]; [lra|].
  assert (0 < l * l * (b2 - a2)) by (repeat apply Rmult_lt_0_compat; lra).
  lra.
Qed.

Lemma last_default (A : Type) (l : list A) x y : l <> [] -> last l x = last l y.
Proof. induction l as [|z [|w l] IH]; [congruence|reflexivity|intros _; simpl in *; apply IH; discriminate]. Qed.

Lemma product_real g v t : IZR (integer_dot g (at_time V m v t)) = 2 ^ power t * dot (real g) (position V m v (moment t)).
Proof.
  rewrite integer_dot_real; unfold dot at 1, real at 2 4 6; rewrite !at_time_exact; unfold dot; ring.
Qed.

Lemma over_power t n : (power t <= n)%nat -> power (over t n) = n.
Proof. intros; simpl; lia. Qed.

Lemma reach_least p : 0 <= IZR (reach V m p).
Proof. apply IZR_le; unfold reach; destruct (has_distance V p); lia. Qed.

(** A stretch that holds proves that the pair is apart from its start to its end. *)
Theorem holds_apart k p start s t : k <> EdgeFace -> holds k p start s = true ->
  moment start <= t <= moment (stretch_end s) -> apart V m p t.
Proof.
  unfold holds; set (n := Nat.max (power start) (power (stretch_end s))).
  intros other all in_stretch; apply andb_prop in all as (all & at_middle).
  apply andb_prop in all as (at_start & at_end).
  set (d := if has_distance V p then shift_left (distance V m) n else 0%Z) in *.
  assert (IZR d = 2 ^ n * IZR (reach V m p)) as d_real
    by (unfold d, reach; destruct (has_distance V p); [rewrite shift_left_real; ring|ring]).
  pose proof (reach_least p) as D_least.
  pose proof (power_positive n) as unit.
  assert (0 <= d)%Z as d_least by (apply le_IZR; rewrite d_real; apply Rmult_le_pos; lra).
  assert (power (over start n) = n) as start_power by (apply over_power; unfold n; lia).
  assert (power (over (stretch_end s) n) = n) as end_power by (apply over_power; unfold n; lia).
  rewrite <- (moment_over start n), <- (moment_over (stretch_end s) n) in in_stretch.
  set (a := over start n) in *; set (b := over (stretch_end s) n) in *.
  assert (forall g time v, power time = n ->
    IZR (integer_dot g (at_time V m v time)) = 2 ^ n * dot (real g) (position V m v (moment time))) as product
    by (intros g time v <-; apply product_real).
  pose proof (integer_square_not_negative (from s)); pose proof (integer_square_not_negative (to s)).
  apply is_beyond_real in at_start, at_end, at_middle; try assumption; [|unfold shift_left; lia].
  rewrite d_real, integer_dot_real in at_start, at_end.
  rewrite d_real, shift_left_real, plus_IZR, !integer_dot_real, pow_1 in at_middle.
  set (g := real (from s)) in *; set (h := real (to s)) in *.
  set (along0 := fun v => integer_dot (from s) (at_time V m v a)) in *.
  set (along2 := fun v => integer_dot (to s) (at_time V m v b)) in *.
  set (along1 := fun v => (integer_dot (from s) (at_time V m v b) + integer_dot (to s) (at_time V m v a))%Z) in *.
  destruct (between_ends _ _ _ in_stretch) as (l & l_range & t_is).
  set (D := IZR (reach V m p)) in *; set (P := 2 ^ n) in *.
  set (G := (1 - l) * (1 - l) * IZR (gap p along0) + (1 - l) * l * IZR (gap p along1) + l * l * IZR (gap p along2)).
  apply (apart_along _ _ (turned g h l) (G / P)); [assumption| |].
  - apply Rmult_lt_reg_r with P; [exact unit|].
    replace (G / P * P) with G by (field; lra).
    apply Rle_lt_trans with (P * D * ((1 - l) * sqrt (dot g g) + l * sqrt (dot h h))).
    { pose proof (length_turned g h l l_range).
      fold D; replace (D * sqrt (dot (turned g h l) (turned g h l)) * P)
        with (P * D * sqrt (dot (turned g h l) (turned g h l))) by ring.
      apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|assumption]. }
    assert (P * D * (sqrt (dot g g) + sqrt (dot h h)) < IZR (gap p along1)) as at_middle'.
    { apply Rle_lt_trans with (2 := at_middle); apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|].
      apply root_of_sum; apply square_not_negative. }
    replace (P * D * ((1 - l) * sqrt (dot g g) + l * sqrt (dot h h)))
      with ((1 - l) * (1 - l) * (P * D * sqrt (dot g g))
        + (1 - l) * l * (P * D * (sqrt (dot g g) + sqrt (dot h h))) + l * l * (P * D * sqrt (dot h h))) by ring.
    apply bernstein_less; assumption.
  - intros x y x_here y_here.
    pose proof (gap_below p along0 x y x_here y_here) as below0.
    pose proof (gap_below p along1 x y x_here y_here) as below1.
    pose proof (gap_below p along2 x y x_here y_here) as below2.
    apply IZR_le in below0, below1, below2; rewrite minus_IZR in below0, below1, below2.
    unfold along0 in below0 at 2 3; unfold along1 in below1 at 2 3; unfold along2 in below2 at 2 3.
    rewrite !plus_IZR in below1.
    rewrite !product in below0, below1, below2 by assumption.
    fold g h P in below0, below1, below2; rewrite ?product in below1 by assumption; fold g h in below1.
    apply Rmult_le_reg_r with P; [exact unit|].
    replace (G / P * P) with G by (field; lra).
    replace (dot (turned g h l) (minus (position V m x t) (position V m y t)) * P) with
      ((1 - l) * (1 - l) * (P * dot g (position V m x (moment a)) - P * dot g (position V m y (moment a)))
      + (1 - l) * l * (P * dot g (position V m x (moment b)) + P * dot h (position V m x (moment a))
          - (P * dot g (position V m y (moment b)) + P * dot h (position V m y (moment a))))
      + l * l * (P * dot h (position V m x (moment b)) - P * dot h (position V m y (moment b))))
      by (unfold dot, turned, minus; rewrite t_is, !position_linear; ring).
    unfold G; repeat apply Rplus_le_compat; apply Rmult_le_compat_l;
      first [apply Rmult_le_pos; lra | rewrite <- ?product by assumption; assumption].
Qed.

(** The stretches of an accepted list follow each other without a gap, to the end of the last one. *)
Definition last_end (start : time) (stretches : list stretch) := last (map stretch_end stretches) start.

Theorem is_apart_apart k p stretches : k <> EdgeFace -> forall start t, stretches <> [] ->
  is_apart k p start stretches = true -> moment start <= t <= moment (last_end start stretches) -> apart V m p t.
Proof.
  intros other; induction stretches as [|s rest IH]; intros start t some all (later & earlier); [congruence|].
  simpl in all; apply andb_prop in all as (now & after).
  destruct (Rle_lt_dec t (moment (stretch_end s))) as [inside|beyond].
  - apply (holds_apart k p start s); auto.
  - destruct rest as [|next rest].
    + unfold last_end in earlier; simpl in earlier; lra.
    + apply (IH (stretch_end s)); [discriminate|exact after|].
      split; [lra|]. unfold last_end in *; simpl in *.
      destruct (map stretch_end rest); [exact earlier|].
      erewrite last_default; [exact earlier|discriminate].
Qed.

End Separation.
