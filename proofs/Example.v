(** The example by hand of docs/certificates.md, computed with the restated functions: a vertex that falls
    on a slope. *)

From Coq Require Import Reals ZArith List Permutation Lra Lia.
Require Import Vectors Motion Floats Separation Near InContact Grid Moving Mesh Tree Check.
Import ListNotations.
Open Scope Z_scope.

Definition point_of (x y z : Z) : integer_point := fun k => match k with X => x | Y => y | Z3 => z end.

Definition slope : motion nat := {|
  ends := fun e v =>
    match v with
    | 0%nat => point_of 0 0 0
    | 1%nat => point_of 8 0 8
    | 2%nat => point_of 0 8 0
    | _ => point_of 1 1 (if e then 0 else 4)
    end;
  distance := 0
|}.

Definition slope_mesh : mesh := {|
  vertex_count := 4;
  faces := [(0, 1, 2)%nat];
  edges := [(0, 1)%nat; (0, 2)%nat; (1, 2)%nat];
  face_edges := 3;
  degrees := [2; 2; 2; 0]%nat
|}.

Definition vertex_and_face : pair nat := {| first := [3%nat]; second := [0; 1; 2]%nat; has_distance := true |}.

(** 3/4, and the f64 before it. *)
Definition after : time := time_of_bits 0x3fe8000000000000.
Definition before : time := time_of_bits 0x3fe7ffffffffffff.

Definition stretch_to (t : time) (g : integer_point) : list stretch := [{| stretch_end := t; from := g; to := g |}].
Definition start : time := {| numerator := 0; power := 0 |}.
Definition g : integer_point := point_of (-1) 0 1.

Example the_pair_counts : pair_of slope_mesh VertexFace (3, 0)%nat = Some vertex_and_face.
Proof. reflexivity. Qed.

Example the_exponents : (numerator after, power after, power before) = (3, 2%nat, 53%nat).
Proof. vm_compute; reflexivity. Qed.

Example apart_before : is_apart nat slope VertexFace vertex_and_face start (stretch_to before g) = true.
Proof. vm_compute; reflexivity. Qed.

Example apart_on_the_grid : separates nat slope [0; 1; 2; 3]%nat before vertex_and_face g [false; true] = true.
Proof. vm_compute; reflexivity. Qed.

Example not_apart_after : is_apart nat slope VertexFace vertex_and_face start (stretch_to after g) = false.
Proof. vm_compute; reflexivity. Qed.

Example in_contact_after : is_contact nat slope VertexFace vertex_and_face before after (Point [8; 6; 1; 1]) = true.
Proof. vm_compute; reflexivity. Qed.

Example not_in_contact_there : is_contact nat slope VertexFace vertex_and_face before after (Point [8; 5; 2; 1]) = false.
Proof. vm_compute; reflexivity. Qed.

(** From t = 1/2 to t = 1, the volume changes its sign, and the vertex is inside of the face. *)
Definition half : time := {| numerator := 1; power := 1 |}.
Definition one : time := {| numerator := 1; power := 0 |}.

Example in_contact_between : is_contact nat slope VertexFace vertex_and_face half one (Coplanar (Some Z3) None) = true.
Proof. vm_compute; reflexivity. Qed.

(** The component of the normal on the axis y is 0. *)
Example no_contact_by_another_axis : is_contact nat slope VertexFace vertex_and_face half one (Coplanar (Some Y) None) = false.
Proof. vm_compute; reflexivity. Qed.

(** ** The whole certificate *)

(** A tree of any leaves: each is split off from the rest. *)
Fixpoint comb (first : leaf id) (rest : list (leaf id)) : tree id :=
  let one := Leaf id (fst first) (snd first) in
  match rest with [] => one | second :: others => Two id one (comb second others) (all_of id first rest) end.

Lemma comb_built first rest : build id (first :: rest) (comb first rest).
Proof.
  revert first; induction rest as [|second rest IH]; intros (p, b); [constructor|].
  apply (build_more id (p, b) (second :: rest) ((p, b) :: second :: rest) [(p, b)] (second :: rest)); [reflexivity|reflexivity|constructor|apply IH].
Qed.

Definition trees (k : kind) (side : bool) : option (tree id) :=
  match map (leaf_for slope slope_mesh before k) (primitives slope_mesh k side) with
  | [] => None
  | first :: rest => Some (comb first rest)
  end.

Definition rows (k : kind) : list (id * id * row) := match k with VertexFace => [((3, 0)%nat, OnGrid g)] | _ => [] end.

Definition accepted (k : kind) (rows : list (id * id * row)) : bool :=
  check_table slope slope_mesh before trees (fun pairs => pairs) k rows.

Example all_tables : forallb (fun k => accepted k (rows k)) [VertexFace; EdgeEdge; VertexEdge; VertexVertex; EdgeFace] = true.
Proof. vm_compute; reflexivity. Qed.

Example a_pair_is_left_out : accepted VertexFace [] = false.
Proof. vm_compute; reflexivity. Qed.

(** The assumptions of the theorems hold here, so that none contradicts another. *)
Theorem example_statement :
  (exists t, moment before < t <= moment after /\ within nat slope vertex_and_face t)%R
  /\ forall k ids p t, k <> EdgeFace -> pair_of slope_mesh k ids = Some p -> (0 <= t <= moment before)%R -> ~ within nat slope p t.
Proof.
  apply (first_contact slope ltac:(simpl; lia) slope_mesh) with
    (tree_of := trees) (sort := fun pairs => pairs) (rows := rows) (k := VertexFace) (ids := (3, 0)%nat) (witness := Point [8; 6; 1; 1]).
  - split; [reflexivity|split].
    + intros a b c v [[= <- <- <-]|[]] here; simpl in *; lia.
    + intros a b v here there; simpl in *.
      repeat match goal with H : _ \/ _ |- _ => destruct H | H : False |- _ => destruct H | H : (_, _) = _ |- _ => injection H as <- <- end; lia.
  - intros k side; unfold trees.
    destruct (map (leaf_for slope slope_mesh before k) (primitives slope_mesh k side)); [reflexivity|apply comb_built].
  - intros l; reflexivity.
  - unfold before, after; rewrite !time_value by (unfold one_bits; lia); apply real_of_bits_less; unfold one_bits; lia.
  - intros k moving; destruct k; try (vm_compute; reflexivity); congruence.
  - discriminate.
  - reflexivity.
  - exact in_contact_after.
Qed.
