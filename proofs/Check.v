(** The statements of one step: [check_table] and [check_step] of [check.rs], [pairs] of [tree.rs]. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Permutation.
Require Import Vectors Motion Separation Rest Grid Tree Boxes Polynomial Moving InContact Mesh.
Import ListNotations.
Open Scope R_scope.

Definition id := nat.

Section Check.
Local Notation V := nat.
Variable m : motion V.
Hypothesis distance_not_negative : (0 <= distance V m)%Z.
Variable mesh : Mesh.mesh.
Hypothesis made : is_mesh mesh.
Variable until : time.

Local Notation all := (seq 0 (vertex_count mesh)).
Local Notation pair_of := (Mesh.pair_of mesh).
Local Notation primitives := (Mesh.primitives mesh).

(** ** The pairs that need a proof *)

Definition at_end (k : kind) : bool -> bool := match k with EdgeFace => fun _ => false | _ => fun e => e end.
Definition prune_distance (k : kind) : Z := match k with EdgeFace => 0%Z | _ => grid_distance V m all until end.

Definition leaf_for (k : kind) (primitive : id * (V * V * V)) : leaf id :=
  let '(i, (a, b, c)) := primitive in (i, extent_of V m all until (at_end k) a b c).

(** The trees that [Tree::new] may have made: none without leaves. *)
Variable tree_of : kind -> bool -> option (tree id).
Hypothesis tree_of_primitives : forall k side,
  match tree_of k side with
  | None => map (leaf_for k) (primitives k side) = []
  | Some t => build id (map (leaf_for k) (primitives k side)) t
  end.

Definition counts (k : kind) (ids : id * id) : bool := match pair_of k ids with Some _ => true | None => false end.

(** [pairs]. The code ends early when there are more pairs than rows, and then refuses, as [check_table]
    below does. *)
Definition pairs (k : kind) : list (id * id) :=
  let found :=
    match tree_of k false, tree_of k true with
    | Some p, Some q => between id (S (height id p + height id q)) (prune_distance k) p q
    | _, _ => []
    end in
  filter (counts k) (map (fun both => (fst (fst both), fst (snd both))) found).

Lemma leaf_found k side i corners : In (i, corners) (primitives k side) ->
  exists t given, tree_of k side = Some t /\ build id given t /\ In (leaf_for k (i, corners)) (leaves id t).
Proof.
  intros here; apply (in_map (leaf_for k)) in here; pose proof (tree_of_primitives k side) as built.
  destruct (tree_of k side) as [t|]; [|rewrite built in here; destruct here].
  exists t, (map (leaf_for k) (primitives k side)); split; [reflexivity|split; [exact built|]].
  apply (Permutation_in _ (build_leaves id _ _ built)), here.
Qed.

(** No pair is left out, unless its boxes are separate. *)
Theorem pairs_complete k a b p a_corners b_corners : pair_of k (a, b) = Some p ->
  In (a, a_corners) (primitives k false) -> In (b, b_corners) (primitives k true) ->
  In (a, b) (pairs k)
  \/ is_separate (prune_distance k) (snd (leaf_for k (a, a_corners))) (snd (leaf_for k (b, b_corners))) = true.
Proof.
  intros counted a_here b_here.
  destruct (leaf_found k false a a_corners a_here) as (t & t_given & t_is & t_built & x_here).
  destruct (leaf_found k true b b_corners b_here) as (u & u_given & u_is & u_built & y_here).
  destruct (between_complete id (prune_distance k) (S (height id t + height id u)) t u t_given u_given t_built u_built
    ltac:(lia) _ _ x_here y_here) as [apart|found]; [tauto|left].
  unfold pairs; rewrite t_is, u_is; apply filter_In; split; [|unfold counts; rewrite counted; reflexivity].
  apply in_map_iff; eexists; split; [|exact found].
  destruct a_corners as ((?, ?), ?), b_corners as ((?, ?), ?); reflexivity.
Qed.

(** ** The rows of a table *)

(** A row: a single stretch that does not turn, for the grid, or stretches; the last one ends at [last]. *)
Inductive row := OnGrid (g : integer_point) | Exact (inner : list stretch) (from to : integer_point).

Definition stretches (last : time) (inner : list stretch) (from to : integer_point) : list stretch :=
  inner ++ [{| stretch_end := last; Separation.from := from; Separation.to := to |}].

Definition zero : time := {| numerator := 0; power := 0 |}.

Definition is_proved (k : kind) (ids : id * id) (w : row) : bool :=
  match pair_of k ids with
  | None => false
  | Some p =>
      match w with
      | OnGrid g => separates V m all until p g (match k with EdgeFace => [false] | _ => [false; true] end)
      | Exact inner from to =>
          is_apart V m k p zero (stretches (match k with EdgeFace => zero | _ => until end) inner from to)
      end
  end.

Definition is_equal (a b : id * id) : bool := (fst a =? fst b)%nat && (snd a =? snd b)%nat.

(** The loop over the pairs: each has its row, and there is no other. *)
Fixpoint match_rows (k : kind) (needed : list (id * id)) (rows : list ((id * id) * row)) : bool :=
  match needed, rows with
  | [], [] => true
  | next :: needed, (ids, w) :: rows => is_equal next ids && is_proved k next w && match_rows k needed rows
  | _, _ => false
  end.

Variable sort : list (id * id) -> list (id * id).
Hypothesis sort_permutes : forall l, Permutation l (sort l).

(** [check_table]. *)
Definition check_table (k : kind) (rows : list ((id * id) * row)) : bool :=
  match_rows k (sort (pairs k)) rows.

Lemma match_rows_all k needed : forall rows ids, match_rows k needed rows = true -> In ids needed ->
  exists w, is_proved k ids w = true.
Proof.
  induction needed as [|next needed IH]; intros [|(named, w) rows] ids holds here; try destruct here; try discriminate;
    simpl in holds; apply andb_prop in holds as (now & later); apply andb_prop in now as (_ & proved).
  - subst ids; exists w; exact proved.
  - apply (IH rows); assumption.
Qed.

Lemma table_proof k rows a b p : check_table k rows = true -> pair_of k (a, b) = Some p ->
  (exists w, is_proved k (a, b) w = true)
  \/ exists a_corners b_corners, (forall v, In v (first V p) -> is_vertex_of a_corners v)
    /\ (forall v, In v (second V p) -> is_vertex_of b_corners v)
    /\ is_separate (prune_distance k) (snd (leaf_for k (a, a_corners))) (snd (leaf_for k (b, b_corners))) = true.
Proof.
  unfold check_table; intros holds counted.
  destruct (pair_of_primitives mesh made k a b p counted) as (fit & listed & contact & ordered & a_corners & b_corners & a_here & b_here & first_in & second_in).
  destruct (pairs_complete k a b p a_corners b_corners counted) as [here|apart]; try assumption.
  - left; apply (match_rows_all k (sort (pairs k)) rows); [exact holds|].
    apply (Permutation_in _ (sort_permutes _) here).
  - right; exists a_corners, b_corners; auto.
Qed.

Lemma zero_moment : moment zero = 0.
Proof. unfold moment; simpl; lra. Qed.

Lemma stretches_end last inner from to : last_end zero (stretches last inner from to) = last.
Proof. unfold last_end, stretches; rewrite map_app; simpl; apply List.last_last. Qed.

Lemma stretches_some last inner from to : stretches last inner from to <> [].
Proof. unfold stretches; destruct inner; discriminate. Qed.

(** ** The statements *)

(** Free: no pair that counts is in contact, or within the distance, at any time of [0, T]. *)
Theorem table_free k rows ids p t : k <> EdgeFace -> check_table k rows = true -> pair_of k ids = Some p ->
  0 <= t <= moment until -> apart V m p t.
Proof.
  destruct ids as (a, b); intros moving holds counted range.
  destruct (pair_of_primitives mesh made k a b p counted) as (fit & listed & _).
  destruct (table_proof k rows a b p holds counted) as [(w & proved)|(a_corners & b_corners & first_in & second_in & separate)].
  - unfold is_proved in proved; rewrite counted in proved; destruct w as [g|inner from to].
    + apply (separates_apart V m distance_not_negative all until p g t listed); [destruct k; try contradiction; exact proved|exact range].
    + assert (match k with EdgeFace => zero | _ => until end = until) as last by (destruct k; congruence).
      rewrite last in proved.
      apply (is_apart_apart V m distance_not_negative k p _ moving zero t (stretches_some _ _ _ _) proved).
      rewrite stretches_end, zero_moment; exact range.
  - destruct a_corners as ((a0, a1), a2), b_corners as ((b0, b1), b2); unfold leaf_for in separate; simpl in separate.
    apply (separate_apart V m distance_not_negative all until p a0 a1 a2 b0 b1 b2 t listed first_in second_in); [|exact range].
    destruct k; try contradiction; exact separate.
Qed.

Lemma table_rest_counted rows ids p : check_table EdgeFace rows = true -> pair_of EdgeFace ids = Some p -> ~ pierces V m p 0.
Proof.
  destruct ids as (a, b); intros holds counted.
  destruct (pair_of_primitives mesh made EdgeFace a b p counted) as (fit & listed & contact & _); specialize (contact eq_refl).
  destruct (table_proof EdgeFace rows a b p holds counted) as [(w & proved)|(a_corners & b_corners & first_in & second_in & separate)].
  - unfold is_proved in proved; rewrite counted in proved; destruct w as [g|inner from to].
    + intros piercing; apply (separates_rest V m distance_not_negative all until p g listed proved), pierces_within, piercing.
    + rewrite <- zero_moment.
      apply (is_apart_rest V m p zero _ (stretches_some _ _ _ _) proved).
  - destruct a_corners as ((a0, a1), a2), b_corners as ((b0, b1), b2).
    intros piercing.
    apply (separate_rest V m distance_not_negative all until p a0 a1 a2 b0 b1 b2 contact listed first_in second_in separate),
      pierces_within, piercing.
Qed.

(** Rest: no edge pierces a face at t = 0. *)
Theorem table_rest rows a b xs ys : check_table EdgeFace rows = true -> edge mesh a = Some xs -> face mesh b = Some ys ->
  ~ pierces V m {| first := xs; second := ys; has_distance := false |} 0.
Proof.
  intros holds a_is b_is; destruct (edge_and_face mesh made a b xs ys a_is b_is) as [counted|(x & in_edge & in_face)].
  - exact (table_rest_counted rows (a, b) _ holds counted).
  - exact (common_vertex V m {| first := xs; second := ys; has_distance := false |} x 0 in_edge in_face).
Qed.

(** Contact: with the tables of all kinds, the named pair is within the distance after T and not after T⁺, and no
    pair that counts is within it at any time until T. *)
Theorem first_contact rows k ids p after witness : moment until < moment after ->
  (forall k, k <> EdgeFace -> check_table k (rows k) = true) ->
  k <> EdgeFace -> pair_of k ids = Some p -> is_contact V m k p until after witness = true ->
  (exists t, moment until < t <= moment after /\ within V m p t)
  /\ forall k ids p t, k <> EdgeFace -> pair_of k ids = Some p -> 0 <= t <= moment until -> ~ within V m p t.
Proof.
  intros later tables moving counted contact; split.
  - destruct ids as (a, b); destruct (pair_of_primitives mesh made k a b p counted) as (fit & _).
    destruct (is_contact_within V m k p until after witness fit ltac:(lra) contact) as (t & range & strict & near).
    exists t; split; [specialize (strict later); lra|exact near].
  - intros k' ids' p' t other counted' range; apply (table_free k' (rows k') ids' p' t other (tables k' other) counted' range).
Qed.

(** Contact at the start, without a statement about [0, T]: both times are 0. *)
Theorem contact_at_start k ids p witness : k <> EdgeFace -> pair_of k ids = Some p ->
  is_contact V m k p zero zero witness = true -> within V m p 0.
Proof.
  destruct ids as (a, b); intros moving counted contact; destruct (pair_of_primitives mesh made k a b p counted) as (fit & _).
  destruct (is_contact_within V m k p zero zero witness fit ltac:(lra) contact) as (t & range & _ & near).
  rewrite zero_moment in range; replace 0 with t by lra; exact near.
Qed.

End Check.
