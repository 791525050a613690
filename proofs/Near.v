(** Points of the primitives at one time: [is_near] of the file [contact.rs]. *)

From Coq Require Import Reals ZArith List Bool Lra Lia.
Require Import Vectors Motion Separation.
Import ListNotations.
Open Scope R_scope.

Section Near.
Variable V : Type.
Variable m : motion V.

Definition integer_sum := fold_right Z.add 0%Z.

Fixpoint weighted (weights : list Z) (vertices : list V) (t : time) (k : axis) : Z :=
  match weights, vertices with
  | w :: weights, v :: vertices => (w * at_time V m v t k + weighted weights vertices t k)%Z
  | _, _ => 0%Z
  end.

(** [is_near]. *)
Definition is_near (p : pair V) (t : time) (weights : list Z) : bool :=
  let count := length (first V p) in
  let total := integer_sum (firstn count weights) in
  let other := integer_sum (skipn count weights) in
  let difference k :=
    (weighted (firstn count weights) (first V p) t k - weighted (skipn count weights) (second V p) t k)%Z in
  let reach := if has_distance V p then (shift_left (distance V m) (power t) * total)%Z else 0%Z in
  ((length weights =? length (first V p) + length (second V p))%nat
  && forallb (Z.leb 0) weights
  && (0 <? total) && (total =? other) && (integer_dot difference difference <=? reach * reach))%Z.

Lemma hull_weighted weights vertices t total : length weights = length vertices -> Forall (Z.le 0) weights ->
  integer_sum weights = total -> (0 < total)%Z ->
  hull (place V m vertices (moment t)) (fun k => IZR (weighted weights vertices t k) / (2 ^ power t * IZR total)).
Proof.
  intros same least total_is positive; apply IZR_lt in positive; pose proof (power_positive (power t)).
  exists (map (fun w => IZR w / IZR total) weights); unfold place; rewrite !map_length.
  split; [exact same|split; [|split]].
  - apply Forall_forall; intros z here; apply in_map_iff in here as (w & <- & here).
    rewrite Forall_forall in least; specialize (least w here); apply IZR_le in least.
    apply Rmult_le_pos; [exact least|apply Rlt_le, Rinv_0_lt_compat, positive].
  - assert (sum (map (fun w => IZR w / IZR total) weights) = IZR (integer_sum weights) / IZR total) as sums.
    { clear - positive; unfold integer_sum, sum; induction weights as [|w weights IH]; simpl; [field; lra|].
      rewrite IH, plus_IZR; field; lra. }
    rewrite sums, total_is; field; lra.
  - intros k; clear least total_is; revert vertices same.
    induction weights as [|w weights IH]; intros [|v vertices] same; simpl; try discriminate; [field; lra|].
    rewrite <- IH by (injection same; auto); rewrite plus_IZR, mult_IZR, at_time_exact; field; lra.
Qed.

(** Weights that pass name points of both primitives at most the distance from each other. *)
Theorem is_near_within p t weights : is_near p t weights = true -> within V m p (moment t).
Proof.
  unfold is_near; set (count := length (first V p)); set (total := integer_sum (firstn count weights)).
  intros all; repeat (apply andb_prop in all; destruct all as (all & ?part)).
  apply Nat.eqb_eq in all; apply Z.leb_le in part; apply Z.eqb_eq in part0; apply Z.ltb_lt in part1.
  rewrite forallb_forall in part2.
  assert (forall l, (forall w, In w l -> In w weights) -> Forall (Z.le 0) l) as least
    by (intros l inside; apply Forall_forall; intros w here; apply Z.leb_le, part2, inside, here).
  pose proof (firstn_skipn count weights) as parts.
  assert (Forall (Z.le 0) (firstn count weights)) as first_least
    by (apply least; intros w here; rewrite <- parts; apply in_or_app; auto).
  assert (Forall (Z.le 0) (skipn count weights)) as second_least
    by (apply least; intros w here; rewrite <- parts; apply in_or_app; auto).
  assert (length (firstn count weights) = length (first V p)) as first_count by (apply firstn_length_le; unfold count; lia).
  assert (length (skipn count weights) = length (second V p)) as second_count by (rewrite skipn_length; unfold count; lia).
  pose proof (hull_weighted _ _ t total first_count first_least eq_refl part1) as a_inside.
  pose proof (hull_weighted _ _ t total second_count second_least (eq_sym part0) part1) as b_inside.
  eexists; eexists; split; [exact a_inside|split; [exact b_inside|]].
  apply IZR_le in part; rewrite integer_dot_real, mult_IZR in part; apply IZR_lt in part1.
  pose proof (power_positive (power t)) as unit.
  set (scale := 2 ^ power t * IZR total).
  assert (0 < scale) as scale_positive by (apply Rmult_lt_0_compat; assumption).
  assert (0 < scale * scale) by (apply Rmult_lt_0_compat; assumption).
  apply Rmult_le_reg_l with (scale * scale); [assumption|].
  match type of part with dot ?u ?u <= _ => match goal with |- _ * dot ?w ?w <= _ =>
    replace (scale * scale * dot w w) with (dot u u)
      by (unfold dot, minus, real; rewrite !minus_IZR; fold scale; field; lra) end end.
  eapply Rle_trans; [exact part|]; apply Req_le.
  unfold reach, scale; destruct (has_distance V p); [rewrite mult_IZR, shift_left_real; ring|ring].
Qed.

End Near.
