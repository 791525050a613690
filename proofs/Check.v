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

(** A tree that [Tree::new] may have made: of no leaves, or by [build]. *)
Definition is_tree (given : list (leaf id)) (t : tree id) :=
  (given = [] /\ leaves id t = [] /\ nodes id t = []) \/ build id given (leaves id t) (nodes id t).

Variable tree_of : kind -> bool -> tree id.
Hypothesis tree_of_primitives : forall k side, is_tree (map (leaf_for k) (primitives k side)) (tree_of k side).
Hypothesis tree_of_one_set : forall k, is_one_set k = true -> tree_of k false = tree_of k true.

Definition counts (k : kind) (ids : id * id) : bool := match pair_of k ids with Some _ => true | None => false end.

Definition in_order (k : kind) (ids : id * id) : id * id :=
  if is_one_set k then (Nat.min (fst ids) (snd ids), Nat.max (fst ids) (snd ids)) else ids.

(** [pairs]. The code ends early when there are more pairs than rows, and then refuses, as [check_table]
    below does. *)
Definition pairs (k : kind) : list (id * id) :=
  let p := tree_of k false in
  let q := tree_of k true in
  let found :=
    if is_one_set k then within_tree id (length (leaves id p)) (prune_distance k) p (root id p)
    else between id (length (leaves id p) + length (leaves id q)) (prune_distance k) p q (root id p) (root id q) in
  filter (counts k) (map (fun both => in_order k (fst (fst both), fst (snd both))) found).

Lemma leaf_found k side i corners : In (i, corners) (primitives k side) ->
  exists l place, nth_error (leaves id (tree_of k side)) place = Some l /\ l = leaf_for k (i, corners)
    /\ is_node id (tree_of k side) (root id (tree_of k side)) /\ (place < length (leaves id (tree_of k side)))%nat.
Proof.
  intros here; apply (in_map (leaf_for k)) in here.
  destruct (tree_of_primitives k side) as [(none & _)|built]; [rewrite none in here; destruct here|].
  pose proof (Permutation_in _ (build_leaves _ _ _ _ built) here) as member.
  apply In_nth_error in member as (place & found).
  exists (leaf_for k (i, corners)), place; split; [exact found|split; [reflexivity|split]].
  - pose proof (root_is_node id _ _ _ built) as node; destruct (tree_of k side); exact node.
  - apply nth_error_Some; rewrite found; discriminate.
Qed.

(** No pair is left out, unless its boxes are separate. *)
Theorem pairs_complete k a b p a_corners b_corners : pair_of k (a, b) = Some p ->
  (is_one_set k = true -> (a < b)%nat) ->
  In (a, a_corners) (primitives k false) -> In (b, b_corners) (primitives k true) ->
  In (a, b) (pairs k)
  \/ is_separate (prune_distance k) (snd (leaf_for k (a, a_corners))) (snd (leaf_for k (b, b_corners))) = true.
Proof.
  intros counted ordered a_here b_here.
  destruct (leaf_found k false a a_corners a_here) as (x & i & x_found & x_is & p_node & i_less).
  destruct (leaf_found k true b b_corners b_here) as (y & j & y_found & y_is & q_node & j_less).
  assert (fst x = a /\ fst y = b) as (x_id & y_id)
    by (subst x y; destruct a_corners as ((?, ?), ?), b_corners as ((?, ?), ?); auto).
  rewrite <- x_is, <- y_is; unfold pairs.
  assert (forall found u v, In (u, v) found -> in_order k (fst u, fst v) = (a, b) ->
    In (a, b) (filter (counts k) (map (fun both : leaf id * leaf id => in_order k (fst (fst both), fst (snd both))) found))) as listed.
  { intros found u v here order; apply filter_In; split; [|unfold counts; rewrite counted; reflexivity].
    rewrite <- order; apply (in_map (fun both : leaf id * leaf id => in_order k (fst (fst both), fst (snd both))) _ _ here). }
  destruct (is_one_set k) eqn:one.
  - specialize (ordered eq_refl); pose proof (tree_of_one_set k one) as same; rewrite <- same in *.
    assert (i <> j) as other by (intros <-; rewrite x_found in y_found; injection y_found as <-; lia).
    destruct (Nat.lt_ge_cases i j) as [less|more].
    + destruct (within_tree_complete id (length (leaves id (tree_of k false))) (prune_distance k) _ _ p_node
        ltac:(unfold count; simpl; lia) i j x y ltac:(simpl; lia) ltac:(simpl; lia) x_found y_found) as [apart|here]; [tauto|].
      left; apply (listed _ x y here); unfold in_order; rewrite one; simpl; f_equal; lia.
    + destruct (within_tree_complete id (length (leaves id (tree_of k false))) (prune_distance k) _ _ p_node
        ltac:(unfold count; simpl; lia) j i y x ltac:(simpl; lia) ltac:(simpl; lia) y_found x_found) as [apart|here];
        [right; apply is_separate_symmetric; exact apart|].
      left; apply (listed _ y x here); unfold in_order; rewrite one; simpl; f_equal; lia.
  - destruct (between_complete id (length (leaves id (tree_of k false)) + length (leaves id (tree_of k true))) (prune_distance k)
      _ _ _ _ p_node q_node ltac:(unfold count; simpl; lia) x y) as [apart|here]; [| |tauto|].
    + exists i; split; [simpl; lia|exact x_found].
    + exists j; split; [simpl; lia|exact y_found].
    + left; apply (listed _ x y here); unfold in_order; rewrite one, x_id, y_id; reflexivity.
Qed.

(** ** The rows of a table *)

(** A row: a direction for the grid, or stretches, of which the last ends at [last]. *)
Inductive row := OnGrid (g : integer_point) | Exact (inner : list stretch) (from : integer_point) (to : option integer_point).

Definition stretches (last : time) (inner : list stretch) (from : integer_point) (to : option integer_point) : list stretch :=
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

Definition is_less (a b : id * id) : bool := (fst a <? fst b)%nat || (fst a =? fst b)%nat && (snd a <? snd b)%nat.
Definition is_equal (a b : id * id) : bool := (fst a =? fst b)%nat && (snd a =? snd b)%nat.

(** The loop over the rows: a row of a pair that needs none must be proved too. *)
Fixpoint match_rows (k : kind) (needed : list (id * id)) (rows : list ((id * id) * row)) : bool :=
  match rows, needed with
  | [], [] => true
  | [], _ :: _ => false
  | (ids, w) :: rows, [] => is_proved k ids w && match_rows k [] rows
  | (ids, w) :: rows, next :: rest =>
      if is_less next ids then false
      else is_proved k ids w && match_rows k (if is_equal next ids then rest else needed) rows
  end.

Variable sort : list (id * id) -> list (id * id).
Hypothesis sort_permutes : forall l, Permutation l (sort l).

(** [check_table]. *)
Definition check_table (k : kind) (rows : list ((id * id) * row)) : bool :=
  (length (pairs k) <=? length rows)%nat && match_rows k (sort (pairs k)) rows.

Lemma match_rows_all k rows : forall needed ids, match_rows k needed rows = true -> In ids needed ->
  exists w, is_proved k ids w = true.
Proof.
  induction rows as [|(named, w) rows IH]; intros [|next rest] ids holds here; try destruct here; try discriminate; simpl in holds;
    (destruct (is_less next named); [discriminate|]); apply andb_prop in holds as (proved & holds).
  - subst ids; destruct (is_equal next named) eqn:same; [|apply (IH (next :: rest)); [exact holds|left; reflexivity]].
    exists w; replace next with named; [exact proved|].
    unfold is_equal in same; apply andb_prop in same as (one & two); apply Nat.eqb_eq in one, two.
    destruct named, next; simpl in *; congruence.
  - destruct (is_equal next named); [apply (IH rest)|apply (IH (next :: rest))]; auto; right; assumption.
Qed.

Lemma table_proof k rows a b p : check_table k rows = true -> pair_of k (a, b) = Some p ->
  (exists w, is_proved k (a, b) w = true)
  \/ exists a_corners b_corners, (forall v, In v (first V p) -> is_vertex_of a_corners v)
    /\ (forall v, In v (second V p) -> is_vertex_of b_corners v)
    /\ is_separate (prune_distance k) (snd (leaf_for k (a, a_corners))) (snd (leaf_for k (b, b_corners))) = true.
Proof.
  unfold check_table; intros holds counted; apply andb_prop in holds as (_ & holds).
  destruct (pair_of_primitives mesh made k a b p counted) as (fit & listed & contact & ordered & a_corners & b_corners & a_here & b_here & first_in & second_in).
  destruct (pairs_complete k a b p a_corners b_corners counted) as [here|apart]; try assumption; [intros one; apply ordered, one| |].
  - left; apply (match_rows_all k rows (sort (pairs k))); [exact holds|].
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
      apply (is_apart_apart V m distance_not_negative k p zero _ t moving (stretches_some _ _ _ _) proved).
      rewrite stretches_end, zero_moment; exact range.
  - destruct a_corners as ((a0, a1), a2), b_corners as ((b0, b1), b2); unfold leaf_for in separate; simpl in separate.
    apply (separate_apart V m distance_not_negative all until p a0 a1 a2 b0 b1 b2 t listed first_in second_in); [|exact range].
    destruct k; try contradiction; exact separate.
Qed.

(** Rest: no edge pierces a face at t = 0. *)
Theorem table_rest rows ids p : check_table EdgeFace rows = true -> pair_of EdgeFace ids = Some p -> ~ pierces V m p 0.
Proof.
  destruct ids as (a, b); intros holds counted.
  destruct (pair_of_primitives mesh made EdgeFace a b p counted) as (fit & listed & contact & _); specialize (contact eq_refl).
  destruct (table_proof EdgeFace rows a b p holds counted) as [(w & proved)|(a_corners & b_corners & first_in & second_in & separate)].
  - unfold is_proved in proved; rewrite counted in proved; destruct w as [g|inner from to].
    + intros piercing; apply (separates_rest V m distance_not_negative all until p g listed proved), pierces_within, piercing.
    + rewrite <- zero_moment.
      apply (is_apart_rest V m p zero _ (stretches_some _ _ _ _) proved); rewrite stretches_end; reflexivity.
  - destruct a_corners as ((a0, a1), a2), b_corners as ((b0, b1), b2).
    intros piercing.
    apply (separate_rest V m distance_not_negative all until p a0 a1 a2 b0 b1 b2 contact listed first_in second_in separate),
      pierces_within, piercing.
Qed.

(** Contact: with the tables of all kinds, the named pair is the first within the distance, after T and not
    after T⁺. *)
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
