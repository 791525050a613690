(** Proofs of contact: the file [contact.rs]. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
Require Import Vectors Motion Separation Polynomial.
Import ListNotations.
Open Scope R_scope.

Ltac each tactic := repeat (apply Forall_cons; [tactic|]); apply Forall_nil.

(** ** Points and primitives in space *)

Lemma cramer a b d k j :
  cross b d k * a j + cross d a k * b j + cross a b k * d j
    = (if match k, j with X, X | Y, Y | Z3, Z3 => true | _, _ => false end then dot a (cross b d) else 0).
Proof. unfold cross, dot; destruct k, j; simpl; ring. Qed.

Lemma same_sign_quotient a n : n <> 0 -> 0 <= a * n -> 0 <= a / n.
Proof.
  intros other same; replace (a / n) with (a * n * (/ n * / n)) by (field; exact other).
  apply Rmult_le_pos; [exact same|].
  assert (0 < / n * / n); [|lra].
  assert (/ n <> 0) by (apply Rinv_neq_0_compat; exact other); nra.
Qed.

(** A point in the plane of a triangle whose sides have the sign of a component of the normal is in the
    triangle. *)
Lemma point_in_face p a b d k :
  let n := cross (minus b a) (minus d a) in
  dot n (minus p a) = 0 -> n k <> 0 ->
  0 <= cross (minus a p) (minus b p) k * n k -> 0 <= cross (minus b p) (minus d p) k * n k ->
  0 <= cross (minus d p) (minus a p) k * n k -> hull [a; b; d] p.
Proof.
  intros n flat other side_d side_a side_b.
  assert (cross (minus b p) (minus d p) k + cross (minus d p) (minus a p) k + cross (minus a p) (minus b p) k = n k)
    as total by (unfold n, cross, minus; destruct k; simpl; ring).
  exists [cross (minus b p) (minus d p) k / n k; cross (minus d p) (minus a p) k / n k;
    cross (minus a p) (minus b p) k / n k].
  split; [reflexivity|split; [each ltac:(apply same_sign_quotient; assumption)|split]].
  - simpl; apply Rmult_eq_reg_l with (n k); [|exact other].
    rewrite Rmult_1_r, <- total at 1; rewrite <- total in other |- *; field; exact other.
  - intros j; simpl.
    assert (dot (minus a p) (cross (minus b p) (minus d p)) = 0) as volume
      by (replace 0 with (- dot n (minus p a)) by lra; unfold n, dot, cross, minus; simpl; ring).
    pose proof (cramer (minus a p) (minus b p) (minus d p) k j) as identity.
    rewrite volume in identity.
    assert (cross (minus b p) (minus d p) k * a j + cross (minus d p) (minus a p) k * b j
      + cross (minus a p) (minus b p) k * d j = n k * p j) as moved
      by (rewrite <- total; assert (forall z, minus z p j = z j - p j) as parts by reflexivity;
          rewrite !parts in identity; destruct k, j; simpl in identity; lra).
    apply Rmult_eq_reg_l with (n k); [|exact other].
    rewrite <- moved; field; exact other.
Qed.

(** The crossing of the lines of two edges is in both edges. *)
Lemma edges_cross a0 a1 b0 b1 k :
  let e := minus a1 a0 in let f := minus b1 b0 in let w := minus b0 a0 in
  let n := cross e f in let u := cross w f in let v := cross w e in
  dot n w = 0 -> n k <> 0 ->
  0 <= (n k - u k) * n k -> 0 <= (n k - v k) * n k -> 0 <= u k * n k -> 0 <= v k * n k ->
  exists p, hull [a0; a1] p /\ hull [b0; b1] p.
Proof.
  intros e f w n u v flat other rest_u rest_v side_u side_v.
  exists (fun j => a0 j + u k / n k * e j); split.
  - exists [(n k - u k) / n k; u k / n k]; split; [reflexivity|].
    split; [each ltac:(apply same_sign_quotient; assumption)|split].
    + simpl; field; exact other.
    + intros j; simpl; unfold e, minus; field; exact other.
  - exists [(n k - v k) / n k; v k / n k]; split; [reflexivity|].
    split; [each ltac:(apply same_sign_quotient; assumption)|split].
    + simpl; field; exact other.
    + intros j; simpl.
      pose proof (cramer e f w k j) as identity.
      replace (dot e (cross f w)) with 0 in identity by (rewrite <- flat; unfold n, dot, cross; simpl; ring).
      assert (cross f w k = - u k) as back by (unfold u, cross; ring).
      rewrite back in identity; fold v n in identity.
      apply Rmult_eq_reg_l with (n k); [|exact other].
      replace (n k * (a0 j + u k / n k * e j)) with (n k * a0 j + u k * e j) by (field; exact other).
      replace (n k * ((n k - v k) / n k * b0 j + (v k / n k * b1 j + 0)))
        with (n k * b0 j + v k * f j) by (unfold f, minus; field; exact other).
      assert (w j = b0 j - a0 j) as w_is by reflexivity; rewrite w_is in identity.
      destruct k, j; simpl in identity; lra.
Qed.

(** A point on the line of an edge, not beyond its ends, is on the edge; the ends may be one point. *)
Lemma point_on_edge q x y :
  (forall k, cross (minus x q) (minus y q) k = 0) -> dot (minus x q) (minus y q) <= 0 -> hull [x; y] q.
Proof.
  intros on_line between; set (a := minus x q) in *; set (b := minus y q) in *.
  set (e := minus a b).
  assert (dot e e = dot a a - 2 * dot a b + dot b b) as e_square by (unfold e, dot, minus; ring).
  pose proof (square_not_negative a); pose proof (square_not_negative b).
  destruct (Req_dec (dot e e) 0) as [zero|other].
  - assert (dot a a = 0) as a_zero by lra.
    assert (forall k, a k = 0) as at_end by (unfold dot in a_zero; intros k; destruct k; nra).
    exists [1; 0]; split; [reflexivity|split; [each lra|split]]; [simpl; lra|].
    intros k; specialize (at_end k); unfold a, minus in at_end; simpl; lra.
  - assert (0 < dot e e) as positive by lra.
    exists [(dot b b - dot a b) / dot e e; (dot a a - dot a b) / dot e e].
    split; [reflexivity|split; [|split]].
    + each ltac:(apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat, positive]).
    + simpl; rewrite e_square; field; rewrite <- e_square; exact other.
    + intros k; simpl.
      assert ((dot b b - dot a b) * a k + (dot a a - dot a b) * b k = 0) as balanced.
      { pose proof (on_line X); pose proof (on_line Y); pose proof (on_line Z3).
        replace ((dot b b - dot a b) * a k + (dot a a - dot a b) * b k)
          with (match k with
                | X => e Z3 * cross a b Y - e Y * cross a b Z3
                | Y => e X * cross a b Z3 - e Z3 * cross a b X
                | Z3 => e Y * cross a b X - e X * cross a b Y
                end) by (unfold e, minus, dot, cross; destruct k; simpl; ring).
        rewrite !on_line; destruct k; ring. }
      apply Rmult_eq_reg_l with (dot e e); [|exact other].
      replace (dot e e * ((dot b b - dot a b) / dot e e * x k + ((dot a a - dot a b) / dot e e * y k + 0)))
        with ((dot b b - dot a b) * x k + (dot a a - dot a b) * y k) by (field; exact other).
      assert (a k = x k - q k /\ b k = y k - q k) as (a_is & b_is) by (split; reflexivity).
      rewrite a_is, b_is in balanced; rewrite e_square; lra.
Qed.
