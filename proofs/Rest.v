(** An edge and a face at rest: the rows of edges and faces in [separation.rs]. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
Require Import Vectors Motion Lists Separation Contact.
Import ListNotations.
Open Scope R_scope.

(** A vector orthogonal to three vectors that are not in one plane is 0. *)
Lemma orthogonal_zero g a b d : dot g a = 0 -> dot g b = 0 -> dot g d = 0 -> dot a (cross b d) <> 0 -> forall k, g k = 0.
Proof.
  intros a_zero b_zero d_zero volume k; apply Rmult_eq_reg_l with (dot a (cross b d)); [|exact volume].
  replace (dot a (cross b d) * g k)
    with (dot g a * cross b d k + dot g b * cross d a k + dot g d * cross a b k)
    by (unfold dot, cross; destruct k; simpl; ring).
  rewrite a_zero, b_zero, d_zero; ring.
Qed.

(** Terms that are not negative, with positive weights and the sum 0, are 0. *)
Lemma product_sum_zero w x rest : 0 < w -> 0 <= x -> 0 <= rest -> w * x + rest = 0 -> x = 0 /\ rest = 0.
Proof. intros; assert (0 <= w * x) by (apply Rmult_le_pos; lra); split; [|lra]. apply Rmult_eq_reg_l with w; lra. Qed.

Section Rest.
Variable V : Type.
Variable m : motion V.

(** A point inside of the edge is a point inside of the face, in whose plane the edge is not. *)
Definition pierces (p : pair V) (t : R) := exists e0 e1 f0 f1 f2 v w0 w1 w2,
  first V p = [e0; e1] /\ second V p = [f0; f1; f2]
  /\ 0 < v < 1 /\ 0 < w0 /\ 0 < w1 /\ 0 < w2 /\ w0 + w1 + w2 = 1
  /\ (forall k, (1 - v) * position V m e0 t k + v * position V m e1 t k
      = w0 * position V m f0 t k + w1 * position V m f1 t k + w2 * position V m f2 t k)
  /\ dot (minus (position V m e1 t) (position V m e0 t))
       (cross (minus (position V m f1 t) (position V m f0 t)) (minus (position V m f2 t) (position V m f0 t))) <> 0.

Lemma pierces_within p t : pierces p t -> within V m p t.
Proof.
  intros (e0 & e1 & f0 & f1 & f2 & v & w0 & w1 & w2 & first & second & inner & least0 & least1 & least2 & total & same & _).
  exists (mean [1 - v; v] (place V m [e0; e1] t)), (mean [w0; w1; w2] (place V m [f0; f1; f2] t)).
  rewrite first, second; split; [|split].
  - exists [1 - v; v]; split; [reflexivity|split; [each lra|split; [simpl; lra|reflexivity]]].
  - exists [w0; w1; w2]; split; [reflexivity|split; [each lra|split; [simpl; lra|reflexivity]]].
  - match goal with |- dot ?u ?u <= _ => replace (dot u u) with 0 end; [apply Rle_0_sqr|].
    unfold dot, minus; simpl; pose proof (same X); pose proof (same Y); pose proof (same Z3); symmetry.
    rewrite !Rplus_0_r, <- !Rplus_assoc, !same; ring.
Qed.

(** A linear function has one value at the point of the edge and of the face. *)
Lemma common_height g e0 e1 f0 f1 f2 v w0 w1 w2 t : (forall k, (1 - v) * position V m e0 t k + v * position V m e1 t k
    = w0 * position V m f0 t k + w1 * position V m f1 t k + w2 * position V m f2 t k) ->
  let height x := dot g (position V m x t) in
  (1 - v) * height e0 + v * height e1 = w0 * height f0 + w1 * height f1 + w2 * height f2.
Proof.
  intros same height; unfold height, dot; pose proof (same X) as x; pose proof (same Y) as y; pose proof (same Z3) as z.
  replace ((1 - v) * (g X * position V m e0 t X + g Y * position V m e0 t Y + g Z3 * position V m e0 t Z3)
    + v * (g X * position V m e1 t X + g Y * position V m e1 t Y + g Z3 * position V m e1 t Z3))
    with (g X * ((1 - v) * position V m e0 t X + v * position V m e1 t X)
      + g Y * ((1 - v) * position V m e0 t Y + v * position V m e1 t Y)
      + g Z3 * ((1 - v) * position V m e0 t Z3 + v * position V m e1 t Z3)) by ring.
  rewrite x, y, z; ring.
Qed.

(** An edge and a face with a common vertex need no proof. *)
Theorem common_vertex p x t : In x (first V p) -> In x (second V p) -> ~ pierces p t.
Proof.
  intros in_edge in_face
    (e0 & e1 & f0 & f1 & f2 & v & w0 & w1 & w2 & first & second & inner & least0 & least1 & least2 & total & same & volume).
  rewrite first in in_edge; rewrite second in in_face; apply volume.
  set (normal := cross (minus (position V m f1 t) (position V m f0 t)) (minus (position V m f2 t) (position V m f0 t))).
  pose proof (common_height normal e0 e1 f0 f1 f2 v w0 w1 w2 t same) as common; cbv zeta in common.
  set (height := fun y => dot normal (position V m y t)) in *.
  assert (height f1 = height f0) as level1 by (unfold height, normal, dot, cross, minus; simpl; ring).
  assert (height f2 = height f0) as level2 by (unfold height, normal, dot, cross, minus; simpl; ring).
  assert (height x = height f0) as level by (simpl in in_face; destruct in_face as [<-|[<-|[<-|[]]]]; congruence).
  fold (height e0) (height e1) (height f0) (height f1) (height f2) in common.
  rewrite level1, level2 in common.
  replace (w0 * height f0 + w1 * height f0 + w2 * height f0) with (height f0) in common
    by (transitivity ((w0 + w1 + w2) * height f0); [rewrite total|]; ring).
  assert (height e0 = height e1) as flat.
  { simpl in in_edge; destruct in_edge as [<-|[<-|[]]].
    - apply Rmult_eq_reg_l with v; lra.
    - apply Rmult_eq_reg_l with (1 - v); lra. }
  transitivity (height e1 - height e0); [unfold height, dot, minus; simpl; ring|lra].
Qed.

(** A direction that is not 0, in which no vertex of the face is beyond one of the edge, excludes piercing. *)
Lemma supported g p t :
  (exists k, g k <> 0) ->
  (forall x y, In x (first V p) -> In y (second V p) -> 0 <= dot g (minus (position V m x t) (position V m y t))) ->
  ~ pierces p t.
Proof.
  intros (k & other) all
    (e0 & e1 & f0 & f1 & f2 & v & w0 & w1 & w2 & first & second & inner & least0 & least1 & least2 & total & same & volume).
  rewrite first, second in all; apply other.
  set (height := fun x => dot g (position V m x t)).
  assert (forall x y, In x [e0; e1] -> In y [f0; f1; f2] -> 0 <= height x - height y) as order
    by (intros x y x_here y_here; specialize (all x y x_here y_here); unfold height, dot, minus in *; lra).
  assert ((1 - v) * height e0 + v * height e1 = w0 * height f0 + w1 * height f1 + w2 * height f2) as common
    by (apply common_height; exact same).
  assert (forall y, In y [f0; f1; f2] -> 0 <= (1 - v) * (height e0 - height y) + v * (height e1 - height y)) as mixed
    by (intros y here; assert (0 <= (1 - v) * (height e0 - height y) /\ 0 <= v * (height e1 - height y));
        [split; apply Rmult_le_pos; try lra; apply order; simpl; tauto|lra]).
  pose proof (mixed f0 ltac:(simpl; tauto)) as m0; pose proof (mixed f1 ltac:(simpl; tauto)) as m1;
    pose proof (mixed f2 ltac:(simpl; tauto)) as m2.
  set (h := (1 - v) * height e0 + v * height e1) in *.
  replace ((1 - v) * (height e0 - height f0) + v * (height e1 - height f0)) with (h - height f0) in m0 by (unfold h; ring).
  replace ((1 - v) * (height e0 - height f1) + v * (height e1 - height f1)) with (h - height f1) in m1 by (unfold h; ring).
  replace ((1 - v) * (height e0 - height f2) + v * (height e1 - height f2)) with (h - height f2) in m2 by (unfold h; ring).
  assert (w0 * (h - height f0) + (w1 * (h - height f1) + w2 * (h - height f2)) = 0) as balance
    by (transitivity ((w0 + w1 + w2) * h - (w0 * height f0 + w1 * height f1 + w2 * height f2));
        [ring|rewrite total, <- common; unfold h; ring]).
  assert (0 <= w1 * (h - height f1)) as rest1 by (apply Rmult_le_pos; lra).
  assert (0 <= w2 * (h - height f2)) as rest2 by (apply Rmult_le_pos; lra).
  destruct (product_sum_zero _ _ _ least0 m0 (Rplus_le_le_0_compat _ _ rest1 rest2) balance) as (zero0 & balance1).
  destruct (product_sum_zero _ _ _ least1 m1 rest2 balance1) as (zero1 & balance2).
  assert (h - height f2 = 0) as zero2 by (apply Rmult_eq_reg_l with w2; [rewrite Rmult_0_r; exact balance2|apply Rgt_not_eq, least2]).
  assert ((1 - v) * (height e0 - height f0) + v * (height e1 - height f0) = 0) as edge_balance by (unfold h in zero0; lra).
  assert (0 <= v * (height e1 - height f0)) by (apply Rmult_le_pos; [lra|apply order; simpl; tauto]).
  destruct (product_sum_zero (1 - v) (height e0 - height f0) (v * (height e1 - height f0))) as (end0 & rest);
    [lra|apply order; simpl; tauto|assumption|assumption|].
  assert (height e1 - height f0 = 0) as end1 by (apply Rmult_eq_reg_l with v; [rewrite Rmult_0_r; exact rest|lra]).
  apply (orthogonal_zero g _ _ _) with (4 := volume); unfold height, dot, minus in *; lra.
Qed.

Lemma not_zero_component (g : integer_point) : integer_dot g g <> 0%Z -> exists k, real g k <> 0.
Proof.
  intros other; destruct (Z.eq_dec (g X) 0) as [x|x]; [|exists X; apply not_0_IZR; exact x].
  destruct (Z.eq_dec (g Y) 0) as [y|y]; [|exists Y; apply not_0_IZR; exact y].
  destruct (Z.eq_dec (g Z3) 0) as [z|z]; [|exists Z3; apply not_0_IZR; exact z].
  exfalso; apply other; unfold integer_dot; rewrite x, y, z; reflexivity.
Qed.

Lemma gap_not_negative g p t : (0 <= gap V p (fun v => integer_dot g (at_time V m v t)))%Z ->
  forall x y, In x (first V p) -> In y (second V p) ->
  0 <= dot (real g) (minus (position V m x (moment t)) (position V m y (moment t))).
Proof.
  intros least x y x_here y_here.
  pose proof (gap_below V p (fun v => integer_dot g (at_time V m v t)) x y x_here y_here) as below; cbv beta in below.
  assert (0 <= integer_dot g (at_time V m x t) - integer_dot g (at_time V m y t))%Z as order by lia.
  apply IZR_le in order; rewrite minus_IZR, !product_real in order.
  apply Rmult_le_reg_l with (2 ^ power t); [apply power_positive|unfold dot, minus in *; lra].
Qed.

(** The rows of edges and faces: the direction at the beginning of the first stretch, which is not 0, proves that
    the edge does not pierce the face. *)
Theorem is_apart_rest p start stretches : stretches <> [] -> is_apart V m EdgeFace p start stretches = true ->
  ~ pierces p (moment start).
Proof.
  destruct stretches as [|s rest]; [congruence|]; intros _ all.
  simpl in all; apply andb_prop in all as (all & _); unfold holds in all.
  apply andb_prop in all as (all & _); apply andb_prop in all as (at_start & _).
  simpl in at_start; apply andb_prop in at_start as (least & some); apply Z.leb_le in least; apply Z.ltb_lt in some.
  pose proof (gap_not_negative _ _ _ least) as order; rewrite moment_over in order.
  apply (supported (real (from s))); [apply not_zero_component; lia|exact order].
Qed.

End Rest.
