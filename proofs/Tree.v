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

(** [Tree]: a primitive, or two trees, and the box around all that is below. *)
Inductive tree := Leaf (p : P) (b : extent) | Two (first second : tree) (b : extent).

Definition box (t : tree) : extent := match t with Leaf _ b | Two _ _ b => b end.

(** [Tree::parts]. *)
Definition parts (t : tree) : list tree := match t with Leaf _ _ => [t] | Two first second _ => [first; second] end.

Fixpoint leaves (t : tree) : list leaf :=
  match t with Leaf p b => [(p, b)] | Two first second _ => leaves first ++ leaves second end.

Fixpoint height (t : tree) : nat :=
  match t with Leaf _ _ => 0 | Two first second _ => S (Nat.max (height first) (height second)) end.

(** [Tree::new], with the box of all leaves, the tree of their first half, in an order that it chooses, and the
    tree of the others. The order is any permutation: [select_nth_unstable] only exchanges leaves. *)
Inductive build : list leaf -> tree -> Prop :=
  | build_one p b : build [(p, b)] (Leaf p b)
  | build_more first rest order left right left_tree right_tree :
      Permutation (first :: rest) order -> order = left ++ right ->
      build left left_tree -> build right right_tree ->
      build (first :: rest) (Two left_tree right_tree (all_of first rest)).

Lemma build_leaves given t : build given t -> Permutation given (leaves t).
Proof.
  induction 1 as [|first rest order left right left_tree right_tree permuted split _ IHl _ IHr]; [reflexivity|].
  rewrite permuted, split; simpl; apply Permutation_app; assumption.
Qed.

Lemma box_contains given t l : build given t -> In l (leaves t) -> contains (box t) (snd l).
Proof.
  intros built here; pose proof (build_leaves _ _ built) as permuted.
  apply (Permutation_in _ (Permutation_sym permuted)) in here; destruct built; simpl.
  - destruct here as [<-|[]]; intros e k side; simpl; lia.
  - apply all_of_contains, here.
Qed.

(** A leaf of a tree is one of its parts, which are lower if there are two. *)
Lemma leaf_of_part given t l : build given t -> In l (leaves t) -> exists given' t',
  In t' (parts t) /\ build given' t' /\ In l (leaves t')
  /\ match t with Leaf _ _ => t' = t | Two _ _ _ => (height t' < height t)%nat end.
Proof.
  intros built here; destruct built as [p b|first rest order left right left_tree right_tree permuted split built_left built_right].
  - exists [(p, b)], (Leaf p b); simpl; repeat split; auto; constructor.
  - simpl in here; apply in_app_or in here as [here|here].
    + exists left, left_tree; simpl; repeat split; auto; lia.
    + exists right, right_tree; simpl; repeat split; auto; lia.
Qed.

(** ** The search *)

(** [between]: all pairs that it emits. A recursion of at most [fuel] levels. *)
Fixpoint between (fuel : nat) (d : Z) (p q : tree) : list (leaf * leaf) :=
  match fuel with
  | O => []
  | S fuel =>
      if is_separate d (box p) (box q) then []
      else match p, q with
      | Leaf x a, Leaf y b => [((x, a), (y, b))]
      | _, _ => flat_map (fun p => flat_map (fun q => between fuel d p q) (parts q)) (parts p)
      end
  end.

Theorem between_complete d fuel : forall p q p_given q_given, build p_given p -> build q_given q ->
  (height p + height q < fuel)%nat -> forall x y, In x (leaves p) -> In y (leaves q) ->
  is_separate d (snd x) (snd y) = true \/ In (x, y) (between fuel d p q).
Proof.
  induction fuel as [|fuel IH]; intros p q p_given q_given p_built q_built enough x y x_here y_here; [lia|].
  simpl; destruct (is_separate d (box p) (box q)) eqn:separate.
  { left; apply (is_separate_inside d (box p) (box q)); [| |exact separate].
    - apply (box_contains p_given); assumption.
    - apply (box_contains q_given); assumption. }
  destruct (leaf_of_part _ _ _ p_built x_here) as (p_given' & p' & p_part & p_built' & x_here' & p_lower).
  destruct (leaf_of_part _ _ _ q_built y_here) as (q_given' & q' & q_part & q_built' & y_here' & q_lower).
  assert ((height p' + height q' < fuel)%nat ->
    is_separate d (snd x) (snd y) = true
    \/ In (x, y) (flat_map (fun p => flat_map (fun q => between fuel d p q) (parts q)) (parts p))) as lower.
  { intros less; destruct (IH p' q' p_given' q_given' p_built' q_built' less x y x_here' y_here') as [apart|found]; [tauto|].
    right; apply in_flat_map; exists p'; split; [exact p_part|].
    apply in_flat_map; exists q'; split; [exact q_part|exact found]. }
  destruct p as [a a_box|? ? ?], q as [c c_box|? ? ?]; try (apply lower; subst; simpl in *; lia).
  simpl in x_here, y_here; destruct x_here as [<-|[]], y_here as [<-|[]]; simpl; auto.
Qed.

End Tree.
