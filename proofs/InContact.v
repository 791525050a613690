(** A pair is in contact, or within the distance, after T and not after T⁺: [is_contact]. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
Require Import Vectors Motion Separation Polynomial Moving Near.
Import ListNotations.
Open Scope R_scope.

(** [Proof] of the code. An axis that is none is refused, as [normal.get] of the code does. *)
Inductive proof :=
  | Point (weights : list Z)
  | Coplanar (component : option axis) (factor : option polynomial)
  | OnEdge (row : nat) (factor : polynomial).

Section Contact.
Variable V : Type.
Variable m : motion V.

(** [is_contact]. *)
Definition is_contact (k : kind) (p : pair V) (before after : time) (witness : proof) : bool :=
  let x := map (moving V m before after) (vertices V p) in
  match witness with
  | Point weights => is_near V m p after weights
  | Coplanar (Some component) factor => is_inside k x component factor
  | Coplanar None _ => false
  | OnEdge row factor => is_on_edge k x row factor
  end.

Theorem is_contact_within k p before after witness : fits k p -> moment before <= moment after ->
  is_contact k p before after witness = true ->
  exists t, moment before <= t <= moment after /\ (moment before < moment after -> moment before < t)
    /\ within V m p t.
Proof.
  intros fit order holds.
  assert ((exists s, 0 < s < 1 /\ touches V m p (time_at before after s)) -> exists t, moment before <= t <= moment after
    /\ (moment before < moment after -> moment before < t) /\ within V m p t) as touching.
  { intros (s & inside & contact); exists (time_at before after s); split; [|split].
    - unfold time_at; split; nra.
    - unfold time_at; nra.
    - apply touches_within; assumption. }
  destruct witness as [weights|[component|] factor|row factor]; simpl in holds; [| |discriminate|].
  - exists (moment after); split; [lra|split; [trivial|apply (is_near_within _ _ _ _ _ holds)]].
  - apply touching, (is_inside_touches V m _ _ k p component factor fit holds).
  - apply touching, (is_on_edge_touches V m _ _ k p row factor fit holds).
Qed.

End Contact.
