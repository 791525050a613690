(** The least and the largest integer of a list, as [min], [max] and [unwrap_or] of the code compute them. *)

From Coq Require Import ZArith List Lia.
Import ListNotations.
Open Scope Z_scope.

Definition least (l : list Z) := match l with [] => 0 | x :: l => fold_left Z.min l x end.
Definition most (l : list Z) := match l with [] => 0 | x :: l => fold_left Z.max l x end.

Lemma fold_min l x : fold_left Z.min l x <= x /\ forall y, In y l -> fold_left Z.min l x <= y.
Proof.
  revert x; induction l as [|z l IH]; simpl; intros x; [split; [lia|tauto]|].
  destruct (IH (Z.min x z)) as (low & all); split; [lia|intros y [<-|here]; [lia|auto]].
Qed.

Lemma fold_max l x : x <= fold_left Z.max l x /\ forall y, In y l -> y <= fold_left Z.max l x.
Proof.
  revert x; induction l as [|z l IH]; simpl; intros x; [split; [lia|tauto]|].
  destruct (IH (Z.max x z)) as (high & all); split; [lia|intros y [<-|here]; [lia|auto]].
Qed.

Lemma least_below l x : In x l -> least l <= x.
Proof. destruct l as [|y l]; simpl; [tauto|]; destruct (fold_min l y); intros [<-|here]; auto. Qed.

Lemma most_above l x : In x l -> x <= most l.
Proof. destruct l as [|y l]; simpl; [tauto|]; destruct (fold_max l y); intros [<-|here]; auto. Qed.
