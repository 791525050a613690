(** Vectors, and the points of a primitive as means of its vertices. *)

From Coq Require Import Reals List Lra Lia Psatz.
Import ListNotations.
Open Scope R_scope.

Inductive axis := X | Y | Z3.

Definition next (k : axis) := match k with X => Y | Y => Z3 | Z3 => X end.

Definition vector := axis -> R.

Definition minus (a b : vector) : vector := fun k => a k - b k.
Definition dot (a b : vector) := a X * b X + a Y * b Y + a Z3 * b Z3.
Definition cross (a b : vector) : vector :=
  fun k => a (next k) * b (next (next k)) - a (next (next k)) * b (next k).

Lemma square_not_negative a : 0 <= dot a a.
Proof. unfold dot; nra. Qed.

Lemma cauchy_schwarz a b : dot a b * dot a b <= dot a a * dot b b.
Proof.
  pose proof (square_not_negative (cross a b)).
  assert (dot a a * dot b b - dot a b * dot a b = dot (cross a b) (cross a b)) by (unfold dot, cross; simpl; ring).
  lra.
Qed.

(** A difference v that is beyond D along g is longer than D. *)
Lemma beyond g v D : 0 <= D -> dot g v > D * sqrt (dot g g) -> dot v v > D * D.
Proof.
  intros not_negative far.
  pose proof (cauchy_schwarz g v).
  pose proof (sqrt_sqrt _ (square_not_negative g)) as root.
  pose proof (sqrt_pos (dot g g)).
  set (length := sqrt (dot g g)) in *.
  rewrite <- root in *.
  apply Rnot_le_gt; intros near.
  assert (D * length * (D * length) < dot g v * dot g v)
    by (apply Rmult_le_0_lt_compat; try lra; apply Rmult_le_pos; lra).
  assert (length * length * dot v v <= length * length * (D * D)) by (apply Rmult_le_compat_l; nra).
  lra.
Qed.

(** The sum of w x over weights w and points x. *)
Fixpoint mean (weights : list R) (points : list vector) (k : axis) : R :=
  match weights, points with
  | w :: weights, x :: points => w * x k + mean weights points k
  | _, _ => 0
  end.

Definition sum := fold_right Rplus 0.

(** The points of a primitive: the convex hull of its vertices. *)
Definition hull (points : list vector) (p : vector) :=
  exists weights, length weights = length points /\ Forall (Rle 0) weights /\ sum weights = 1
    /\ forall k, p k = mean weights points k.

Lemma mean_least g m weights points :
  length weights = length points -> Forall (Rle 0) weights -> (forall x, In x points -> m <= dot g x) ->
  m * sum weights <= dot g (mean weights points).
Proof.
  revert points; induction weights as [|w weights IH]; intros [|x points]; simpl; try discriminate; intros same positive all.
  - unfold dot; simpl; lra.
  - inversion_clear positive as [|? ? w_positive rest].
    specialize (IH points (eq_add_S _ _ same) rest (fun y here => all y (or_intror here))).
    specialize (all x (or_introl eq_refl)).
    assert (w * m <= w * dot g x) by (apply Rmult_le_compat_l; lra).
    unfold dot in *; simpl; lra.
Qed.

Lemma hull_least g m points p : hull points p -> (forall x, In x points -> m <= dot g x) -> m <= dot g p.
Proof.
  intros (weights & same & positive & total & at_mean) all.
  pose proof (mean_least g m weights points same positive all) as least.
  unfold dot in *; rewrite !at_mean; rewrite total in least; lra.
Qed.

Lemma hull_most g m points p : hull points p -> (forall x, In x points -> dot g x <= m) -> dot g p <= m.
Proof.
  intros inside all.
  assert (- m <= dot (fun k => - g k) p).
  { apply (hull_least _ _ points); auto.
    intros x here; specialize (all x here); unfold dot in *; lra. }
  unfold dot in *; lra.
Qed.

(** A lower bound for all differences of vertices is one for all differences of points. *)
Lemma hull_gap g m xs ys p q :
  hull xs p -> hull ys q -> (forall x y, In x xs -> In y ys -> m <= dot g (minus x y)) -> m <= dot g (minus p q).
Proof.
  intros p_inside q_inside all.
  assert (dot g q <= dot g p - m); [|unfold dot, minus in *; lra].
  apply (hull_most _ _ ys); auto; intros y y_here.
  assert (m + dot g y <= dot g p); [|lra].
  apply (hull_least _ _ xs); auto; intros x x_here.
  specialize (all x y x_here y_here); unfold dot, minus in *; lra.
Qed.

Lemma mean_zeros n points k : mean (repeat 0 n) points k = 0.
Proof. revert points; induction n; intros [|x points]; simpl; try lra. rewrite IHn; lra. Qed.

Lemma hull_vertex points x : In x points -> hull points x.
Proof.
  induction points as [|y points IH]; [intros []|].
  intros [->|here].
  - exists (1 :: repeat 0 (length points)); split; [simpl; now rewrite repeat_length|].
    split; [constructor; [lra|apply Forall_forall; intros z here; apply repeat_spec in here; lra]|].
    split; [simpl|intros k; simpl; rewrite mean_zeros; lra].
    assert (forall n, sum (repeat 0 n) = 0) as zeros by (induction n; simpl; lra).
    rewrite zeros; lra.
  - destruct (IH here) as (weights & same & positive & total & at_mean).
    exists (0 :: weights); split; [simpl; lia|split; [constructor; [lra|exact positive]|split; [simpl; lra|]]].
    intros k; simpl; rewrite at_mean; lra.
Qed.

Definition mix (t : R) := fun both : R * R => (1 - t) * fst both + t * snd both.

Lemma hull_mix points p q t r : hull points p -> hull points q -> 0 <= t <= 1 ->
  (forall k, r k = (1 - t) * p k + t * q k) -> hull points r.
Proof.
  intros (v & v_same & v_positive & v_total & v_mean) (w & w_same & w_positive & w_total & w_mean) range r_is.
  exists (map (mix t) (combine v w)).
  assert (length v = length w) as same by lia.
  split; [rewrite map_length, combine_length; lia|].
  split; [|split].
  - apply Forall_forall; intros z here; apply in_map_iff in here as ((a, b) & <- & here).
    rewrite Forall_forall in v_positive, w_positive.
    pose proof (v_positive _ (in_combine_l _ _ _ _ here)); pose proof (w_positive _ (in_combine_r _ _ _ _ here)).
    unfold mix; simpl; assert (0 <= (1 - t) * a) by (apply Rmult_le_pos; [lra|assumption]).
    assert (0 <= t * b) by (apply Rmult_le_pos; [lra|assumption]).
    lra.
  - enough (sum (map (mix t) (combine v w)) = (1 - t) * sum v + t * sum w) as both by (rewrite both, v_total, w_total; lra).
    clear - same; unfold sum; revert w same.
    induction v as [|a v IH]; intros [|b w] same; simpl in *; try discriminate; [lra|].
    rewrite IH by lia; unfold mix; simpl; lra.
  - intros k; rewrite r_is, v_mean, w_mean; clear - same v_same.
    revert w points same v_same; induction v as [|a v IH]; intros [|b w] [|x points] same v_same; simpl in *; try discriminate; [lra|].
    rewrite <- IH by lia; unfold mix; simpl; lra.
Qed.

(** A point between two vertices of a primitive belongs to the primitive. *)
Lemma hull_between points x y q : In x points -> In y points -> hull [x; y] q -> hull points q.
Proof.
  intros x_here y_here (weights & same & positive & total & at_mean).
  destruct weights as [|v [|w [|]]]; try discriminate.
  inversion_clear positive as [|? ? v_least rest]; inversion_clear rest as [|? ? w_least _]; simpl in total.
  apply (hull_mix points x y w); try (apply hull_vertex; assumption); [lra|].
  intros k; rewrite at_mean; simpl; replace v with (1 - w) by lra; ring.
Qed.
