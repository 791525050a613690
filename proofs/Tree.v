(** All pairs that boxes do not separate: the file [tree.rs]. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Permutation.
Require Import Vectors Motion Lists Separation Grid.
Import ListNotations.
Open Scope Z_scope.

(** ** Boxes *)

(** [Extent]: the least x and the least -x, at both times. The sides are [false] for x and [true] for -x. *)
Definition extent := bool -> axis -> bool -> Z.

Definition union (a b : extent) : extent := fun e k side => Z.min (a e k side) (b e k side).

(** [is_separate]. *)
Definition is_separate (d : Z) (a b : extent) : bool :=
  existsb (fun k => existsb (fun side => forallb (fun e => d <? a e k side + b e k (negb side)) [false; true]) [false; true])
    [X; Y; Z3].

(** A box contains another one if all its numbers are less. *)
Definition contains (a b : extent) := forall e k side, a e k side <= b e k side.

Lemma is_separate_witness d a b : is_separate d a b = true <->
  exists k side, forall e, d < a e k side + b e k (negb side).
Proof.
  unfold is_separate; rewrite existsb_exists; split.
  - intros (k & _ & found); apply existsb_exists in found as (side & _ & all); exists k, side.
    rewrite forallb_forall in all; intros e; apply Z.ltb_lt, all; destruct e; simpl; tauto.
  - intros (k & side & all); exists k; split; [destruct k; simpl; tauto|].
    apply existsb_exists; exists side; split; [destruct side; simpl; tauto|].
    apply forallb_forall; intros e _; apply Z.ltb_lt, all.
Qed.

(** What separates two boxes separates all boxes inside of them. *)
Lemma is_separate_inside d a b a' b' : contains a a' -> contains b b' -> is_separate d a b = true -> is_separate d a' b' = true.
Proof.
  intros a_more b_more; rewrite !is_separate_witness; intros (k & side & all); exists k, side; intros e.
  specialize (all e); specialize (a_more e k side); specialize (b_more e k (negb side)); lia.
Qed.

Lemma contains_union_left a b : contains (union a b) a.
Proof. intros e k side; unfold union; lia. Qed.

Lemma contains_union_right a b : contains (union a b) b.
Proof. intros e k side; unfold union; lia. Qed.

Lemma contains_trans a b c : contains a b -> contains b c -> contains a c.
Proof. intros first second e k side; eapply Z.le_trans; [apply first|apply second]. Qed.

(** ** The tree *)

Section Tree.
Variable P : Type. (* the primitives *)

Definition leaf := (P * extent)%type.

(** [reduce] with [union]: the box of all leaves. *)
Definition all_of (first : leaf) (rest : list leaf) : extent := fold_left (fun a b => union a (snd b)) rest (snd first).

Lemma all_of_contains first rest l : In l (first :: rest) -> contains (all_of first rest) (snd l).
Proof.
  set (join := fun (a : extent) (b : leaf) => union a (snd b)).
  assert (forall rest a, contains (fold_left join rest a) a
    /\ forall l : leaf, In l rest -> contains (fold_left join rest a) (snd l)) as fold.
  { clear; intros rest; induction rest as [|x rest IH]; intros a; simpl; [split; [intros e k side; lia|tauto]|].
    destruct (IH (join a x)) as (less & all); split.
    - apply (contains_trans _ _ _ less), contains_union_left.
    - intros l [->|here]; [apply (contains_trans _ _ _ less), contains_union_right|auto]. }
  unfold all_of; fold join; destruct (fold rest (snd first)) as (less & all); intros [->|here]; auto.
Qed.

(** [build] puts the box of all leaves first, then the nodes of the first half of them, in an order that it
    chooses, then those of the others. The order is any permutation: [select_nth_unstable] only exchanges
    leaves. *)
Inductive build : list leaf -> list leaf -> list extent -> Prop :=
  | build_one l : build [l] [l] [snd l]
  | build_more first rest order left right left_leaves right_leaves left_nodes right_nodes :
      Permutation (first :: rest) order -> (1 < length order)%nat ->
      order = left ++ right -> length left = (length order / 2)%nat ->
      build left left_leaves left_nodes -> build right right_leaves right_nodes ->
      build (first :: rest) (left_leaves ++ right_leaves) (all_of first rest :: left_nodes ++ right_nodes).

Lemma build_leaves given leaves nodes : build given leaves nodes -> Permutation given leaves.
Proof.
  induction 1 as [|first rest order left right left_leaves right_leaves left_nodes right_nodes permuted many split half _ IHl _ IHr]; [reflexivity|].
  rewrite permuted, split; apply Permutation_app; assumption.
Qed.

Lemma build_nodes given leaves nodes : build given leaves nodes -> length nodes = (2 * length given - 1)%nat /\ (1 <= length given)%nat.
Proof.
  induction 1 as [|first rest order left right left_leaves right_leaves left_nodes right_nodes permuted many split half _ IHl _ IHr]; [simpl; lia|].
  apply Permutation_length in permuted; rewrite permuted, split, app_length in *; simpl length; rewrite app_length; lia.
Qed.

(** [Node]: its place, and the range of its leaves. *)
Record node := { node_place : nat; node_begin : nat; node_end : nat }.

Definition count (n : node) : nat := node_end n - node_begin n.

(** [children]. *)
Definition first_child (n : node) : node :=
  {| node_place := node_place n + 1; node_begin := node_begin n; node_end := node_begin n + count n / 2 |}.
Definition second_child (n : node) : node :=
  {| node_place := node_place n + 2 * count (first_child n); node_begin := node_begin n + count n / 2; node_end := node_end n |}.

(** [Tree]. *)
Record tree := { nodes : list extent; leaves : list leaf }.

Definition box (t : tree) (n : node) : option extent := nth_error (nodes t) (node_place n).

(** The nodes and leaves of a node are those that [build] made for it. *)
Definition is_node (t : tree) (n : node) := exists given own_leaves own_nodes,
  build given own_leaves own_nodes
  /\ (exists before after, nodes t = before ++ own_nodes ++ after /\ length before = node_place n)
  /\ (exists before after, leaves t = before ++ own_leaves ++ after /\ length before = node_begin n)
  /\ length own_leaves = count n.

Definition leaf_of (t : tree) (n : node) (l : leaf) := exists i,
  (node_begin n <= i < node_end n)%nat /\ nth_error (leaves t) i = Some l.

Lemma slice A (l before own after : list A) i x : l = before ++ own ++ after ->
  (length before <= i < length before + length own)%nat -> nth_error l i = Some x -> In x own.
Proof.
  intros -> range here; rewrite nth_error_app2, nth_error_app1 in here by lia; apply (nth_error_In _ _ here).
Qed.

Lemma node_box t n : is_node t n -> exists b, box t n = Some b /\ forall l, leaf_of t n l -> contains b (snd l).
Proof.
  intros (given & own_leaves & own_nodes & built & (nodes_before & nodes_after & nodes_are & place) & (before & after & leaves_are & first) & size).
  assert (forall l, leaf_of t n l -> In l own_leaves) as inside.
  { intros l (i & range & here); apply (slice _ _ _ _ _ i l leaves_are); [|exact here].
    unfold count in size; lia. }
  pose proof (build_leaves _ _ _ built) as permuted.
  unfold box; rewrite nodes_are, nth_error_app2, <- place, Nat.sub_diag by lia.
  destruct built; simpl; eexists; (split; [reflexivity|]); intros x here.
  - destruct (inside x here) as [->|[]]; intros e k side; lia.
  - apply all_of_contains, (Permutation_in _ (Permutation_sym permuted)), inside, here.
Qed.

Lemma node_children t n : is_node t n -> (count n <> 1)%nat ->
  is_node t (first_child n) /\ is_node t (second_child n)
  /\ (1 <= count (first_child n) < count n)%nat /\ (1 <= count (second_child n) < count n)%nat.
Proof.
  intros (given & own_leaves & own_nodes & built & (nodes_before & nodes_after & nodes_are & place) & (before & after & leaves_are & first) & size) many.
  destruct built as [l|first_leaf rest order left right left_leaves right_leaves left_nodes right_nodes permuted more split half left_built right_built];
    [simpl in size; lia|].
  pose proof (Permutation_length (build_leaves _ _ _ left_built)) as left_length.
  pose proof (Permutation_length (build_leaves _ _ _ right_built)) as right_length.
  destruct (build_nodes _ _ _ left_built) as (left_count & left_least).
  destruct (build_nodes _ _ _ right_built) as (right_count & right_least).
  assert (length order = count n) as order_length by (rewrite split, app_length, <- size, app_length; lia).
  rewrite order_length in half.
  assert (count (first_child n) = length left) as first_count by (unfold count at 1, first_child; cbn [node_begin node_end]; lia).
  assert (count (second_child n) = length right) as second_count.
  { rewrite split, app_length in order_length; unfold second_child; unfold count at 1; cbn [node_begin node_end].
    set (half_count := (count n / 2)%nat) in *; unfold count in order_length; lia. }
  rewrite split, app_length in order_length.
  split; [|split; [|lia]].
  - exists left, left_leaves, left_nodes; split; [exact left_built|split; [|split; [|lia]]].
    + exists (nodes_before ++ [all_of first_leaf rest]), (right_nodes ++ nodes_after); split.
      * rewrite nodes_are, <- !app_assoc; simpl; rewrite <- !app_assoc; reflexivity.
      * rewrite app_length; simpl; lia.
    + exists before, (right_leaves ++ after); split; [rewrite leaves_are, <- !app_assoc; reflexivity|exact first].
  - exists right, right_leaves, right_nodes; split; [exact right_built|split; [|split; [|lia]]].
    + exists (nodes_before ++ [all_of first_leaf rest] ++ left_nodes), nodes_after; split.
      * rewrite nodes_are, <- !app_assoc; simpl; rewrite <- !app_assoc; reflexivity.
      * unfold second_child; cbn [node_place]; rewrite !app_length, first_count; simpl length; lia.
    + exists (before ++ left_leaves), after; split; [rewrite leaves_are, <- !app_assoc; reflexivity|].
      rewrite app_length; unfold second_child; cbn [node_begin]; lia.
Qed.

Lemma leaf_of_children t n l : is_node t n -> leaf_of t n l -> leaf_of t (first_child n) l \/ leaf_of t (second_child n) l.
Proof.
  intros _ (i & range & here); destruct (Nat.lt_ge_cases i (node_begin n + count n / 2)); [left|right];
    exists i; split; cbn [first_child second_child node_begin node_end]; try exact here; lia.
Qed.

(** ** The search *)

(** [Search::between]: all pairs that it emits. A recursion of at most [fuel] levels. *)
Fixpoint between (fuel : nat) (d : Z) (p q : tree) (a b : node) : list (leaf * leaf) :=
  match fuel, box p a, box q b with
  | S fuel, Some box_a, Some box_b =>
      if is_separate d box_a box_b then []
      else if (count a =? 1)%nat && (count b =? 1)%nat then
        match nth_error (leaves p) (node_begin a), nth_error (leaves q) (node_begin b) with
        | Some x, Some y => [(x, y)]
        | _, _ => []
        end
      else if (count b <=? count a)%nat then between fuel d p q (first_child a) b ++ between fuel d p q (second_child a) b
      else between fuel d p q a (first_child b) ++ between fuel d p q a (second_child b)
  | _, _, _ => []
  end.

(** [Search::within]. *)
Fixpoint within_tree (fuel : nat) (d : Z) (t : tree) (n : node) : list (leaf * leaf) :=
  match fuel with
  | O => []
  | S fuel =>
      if (count n =? 1)%nat then []
      else within_tree fuel d t (first_child n) ++ within_tree fuel d t (second_child n)
        ++ between (2 * count n) d t t (first_child n) (second_child n)
  end.

Theorem between_complete fuel d p q : forall a b, is_node p a -> is_node q b -> (count a + count b <= fuel)%nat ->
  forall x y, leaf_of p a x -> leaf_of q b y ->
  is_separate d (snd x) (snd y) = true \/ In (x, y) (between fuel d p q a b).
Proof.
  induction fuel as [|fuel IH]; intros a b a_node b_node enough x y x_here y_here.
  { destruct x_here as (i & range & _); unfold count in enough; lia. }
  destruct (node_box p a a_node) as (box_a & a_box & a_contains).
  destruct (node_box q b b_node) as (box_b & b_box & b_contains).
  simpl; rewrite a_box, b_box.
  destruct (is_separate d box_a box_b) eqn:separate.
  { left; apply (is_separate_inside d box_a box_b); auto. }
  destruct (Nat.eqb_spec (count a) 1) as [a_one|a_many]; [destruct (Nat.eqb_spec (count b) 1) as [b_one|b_many]|];
    cbn [andb].
  - right; destruct x_here as (i & i_range & i_here), y_here as (j & j_range & j_here).
    unfold count in a_one, b_one.
    replace (node_begin a) with i by lia; replace (node_begin b) with j by lia.
    rewrite i_here, j_here; left; reflexivity.
  - destruct (Nat.leb_spec (count b) (count a)) as [more|less]; [exfalso|].
    + destruct y_here as (j & j_range & _); unfold count in *; lia.
    + destruct (node_children q b b_node b_many) as (first_node & second_node & first_less & second_less).
      destruct (leaf_of_children q b y b_node y_here) as [here|here].
      * destruct (IH a (first_child b) a_node first_node ltac:(lia) x y x_here here); [tauto|right; apply in_or_app; tauto].
      * destruct (IH a (second_child b) a_node second_node ltac:(lia) x y x_here here); [tauto|right; apply in_or_app; tauto].
  - destruct (Nat.leb_spec (count b) (count a)) as [more|less].
    + destruct (node_children p a a_node a_many) as (first_node & second_node & first_less & second_less).
      destruct (leaf_of_children p a x a_node x_here) as [here|here].
      * destruct (IH (first_child a) b first_node b_node ltac:(lia) x y here y_here); [tauto|right; apply in_or_app; tauto].
      * destruct (IH (second_child a) b second_node b_node ltac:(lia) x y here y_here); [tauto|right; apply in_or_app; tauto].
    + assert (count b <> 1)%nat as b_many by (destruct x_here as (i & i_range & _); unfold count in *; lia).
      destruct (node_children q b b_node b_many) as (first_node & second_node & first_less & second_less).
      destruct (leaf_of_children q b y b_node y_here) as [here|here].
      * destruct (IH a (first_child b) a_node first_node ltac:(lia) x y x_here here); [tauto|right; apply in_or_app; tauto].
      * destruct (IH a (second_child b) a_node second_node ltac:(lia) x y x_here here); [tauto|right; apply in_or_app; tauto].
Qed.

(** Within one tree, each pair of different places is found in one of both orders. *)
Theorem within_tree_complete fuel d t : forall n, is_node t n -> (count n <= fuel)%nat ->
  forall i j x y, (node_begin n <= i < j)%nat -> (j < node_end n)%nat ->
  nth_error (leaves t) i = Some x -> nth_error (leaves t) j = Some y ->
  is_separate d (snd x) (snd y) = true \/ In (x, y) (within_tree fuel d t n).
Proof.
  induction fuel as [|fuel IH]; intros n n_node enough i j x y i_range j_range i_here j_here; [unfold count in enough; lia|].
  simpl; destruct (Nat.eqb_spec (count n) 1) as [one|many]; [unfold count in one; lia|].
  destruct (node_children t n n_node many) as (first_node & second_node & first_less & second_less).
  set (middle := (node_begin n + count n / 2)%nat).
  rewrite !in_app_iff.
  destruct (Nat.lt_ge_cases j middle) as [left|right]; [|destruct (Nat.lt_ge_cases i middle) as [left|right']].
  - destruct (IH (first_child n) first_node ltac:(lia) i j x y) as [apart|here];
      cbn [first_child second_child node_begin node_end]; fold middle; auto; lia.
  - destruct (between_complete (2 * count n) d t t (first_child n) (second_child n) first_node second_node ltac:(lia) x y)
      as [apart|here]; auto.
    + exists i; cbn [first_child node_begin node_end]; fold middle; split; [lia|exact i_here].
    + exists j; cbn [second_child node_begin node_end]; fold middle; split; [lia|exact j_here].
  - destruct (IH (second_child n) second_node ltac:(lia) i j x y) as [apart|here];
      cbn [first_child second_child node_begin node_end]; fold middle; auto; lia.
Qed.

(** [Tree::new] and [root]. *)
Definition root (t : tree) : node := {| node_place := 0; node_begin := 0; node_end := length (leaves t) |}.

Lemma root_is_node given own_leaves own_nodes : build given own_leaves own_nodes ->
  is_node {| nodes := own_nodes; leaves := own_leaves |} (root {| nodes := own_nodes; leaves := own_leaves |}).
Proof.
  intros built; exists given, own_leaves, own_nodes; split; [exact built|split; [|split]].
  - exists [], []; simpl; rewrite app_nil_r; auto.
  - exists [], []; simpl; rewrite app_nil_r; auto.
  - unfold count, root; simpl; lia.
Qed.

End Tree.
