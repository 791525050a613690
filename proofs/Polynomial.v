(** Polynomials in both ends of an interval: the file [polynomial.rs].

    A list c_0 to c_n is the sum of c_i s^i (1 - s)^(n - i). *)

From Coq Require Import Reals ZArith List Bool Lra Lia.
Require Import Vectors.
Import ListNotations.
Open Scope R_scope.

Definition polynomial := list Z.

(** The sum of c_i x^i y^(n - i). *)
Fixpoint form (c : polynomial) (x y : R) : R :=
  match c with
  | [] => 0
  | a :: rest => IZR a * y ^ length rest + x * form rest x y
  end.

Definition value (c : polynomial) (s : R) : R := form c s (1 - s).

(** ** Signs *)

(** [has_sign] of the code, for 1 and for -1. *)
Definition has_sign (positive : bool) (c : polynomial) : bool :=
  negb (length c =? 0)%nat
  && forallb (fun a => negb (a =? 0)%Z && Bool.eqb (a <? 0)%Z (negb positive)) c.

Lemma form_positive c x y : c <> [] -> (forall a, In a c -> (0 < a)%Z) -> 0 <= x -> 0 <= y -> x + y = 1 -> 0 < form c x y.
Proof.
  induction c as [|a [|b c] IH]; intros some all x_least y_least total; [congruence| |].
  - simpl; assert (0 < IZR a) by (apply IZR_lt, all; left; reflexivity); lra.
  - assert (0 < form (b :: c) x y) as rest
      by (apply IH; try assumption; [discriminate|intros z here; apply all; right; exact here]).
    change (0 < IZR a * y ^ length (b :: c) + x * form (b :: c) x y).
    assert (0 < IZR a) by (apply IZR_lt, all; left; reflexivity).
    assert (0 <= IZR a * y ^ length (b :: c)) by (apply Rmult_le_pos; [lra|apply pow_le, y_least]).
    destruct (Rle_lt_or_eq_dec 0 x x_least) as [x_positive|<-].
    + assert (0 < x * form (b :: c) x y) by (apply Rmult_lt_0_compat; lra); lra.
    + replace y with 1 by lra; rewrite pow1; lra.
Qed.

Lemma form_opposite c x y : form (map Z.opp c) x y = - form c x y.
Proof. induction c as [|a c IH]; simpl; [ring|]. rewrite map_length, IH, opp_IZR; ring. Qed.

(** Coefficients of one strict sign prove this sign everywhere in the closed interval, for every degree. *)
Theorem has_sign_value positive c s : has_sign positive c = true -> 0 <= s <= 1 ->
  if positive then 0 < value c s else value c s < 0.
Proof.
  unfold has_sign, value; intros all range; apply andb_prop in all as (some & all).
  rewrite forallb_forall in all.
  assert (c <> []) by (intros ->; discriminate).
  destruct positive.
  - apply form_positive; try lra; [assumption|].
    intros a here; specialize (all a here); apply andb_prop in all as (other & least).
    destruct (Z.eqb_spec a 0); [discriminate|]; destruct (Z.ltb_spec a 0); [discriminate|lia].
  - assert (0 < form (map Z.opp c) s (1 - s)); [|rewrite form_opposite in *; lra].
    apply form_positive; try lra; [destruct c; [congruence|discriminate]|].
    intros a here; apply in_map_iff in here as (b & <- & here); specialize (all b here).
    apply andb_prop in all as (other & least).
    destruct (Z.ltb_spec b 0); [lia|discriminate].
Qed.

(** ** Sums and products *)

(** [minus], and the sum of two in [dot]. *)
Definition zip_with (f : Z -> Z -> Z) (a b : polynomial) : polynomial :=
  map (fun both => f (fst both) (snd both)) (combine a b).

Definition subtract := zip_with Z.sub.
Definition add := zip_with Z.add.

Lemma zip_length f a b : length a = length b -> length (zip_with f a b) = length a.
Proof. intros same; unfold zip_with; rewrite map_length, combine_length; lia. Qed.


Lemma subtract_form a b x y : length a = length b -> form (subtract a b) x y = form a x y - form b x y.
Proof.
  revert b; induction a as [|u a IH]; intros [|v b] same; try discriminate; simpl; [ring|].
  injection same as same; fold (zip_with Z.sub a b); fold (subtract a b).
  rewrite IH by exact same; unfold subtract; rewrite zip_length, minus_IZR, same by exact same; ring.
Qed.

Lemma add_form a b x y : length a = length b -> form (add a b) x y = form a x y + form b x y.
Proof.
  revert b; induction a as [|u a IH]; intros [|v b] same; try discriminate; simpl; [ring|].
  injection same as same; fold (zip_with Z.add a b); fold (add a b).
  rewrite IH by exact same; unfold add; rewrite zip_length, plus_IZR, same by exact same; ring.
Qed.

(** [times]: the sums of a_i b_j over i + j = k. *)
Fixpoint times (a b : polynomial) : polynomial :=
  match a with
  | [] => repeat 0%Z (length b - 1)
  | u :: rest => add (map (Z.mul u) b ++ repeat 0%Z (length rest)) (0%Z :: times rest b)
  end.

Lemma times_length a b : b <> [] -> length (times a b) = (length a + length b - 1)%nat.
Proof.
  intros some; assert (0 < length b)%nat by (destruct b; [congruence|simpl; lia]).
  induction a as [|u a IH]; [apply repeat_length|].
  simpl times; unfold add; rewrite zip_length; rewrite app_length, map_length, repeat_length; [simpl; lia|].
  simpl; rewrite IH; lia.
Qed.

Lemma form_zeros n x y : form (repeat 0%Z n) x y = 0.
Proof. induction n as [|n IH]; simpl; [reflexivity|]; rewrite IH; ring. Qed.

Lemma form_scaled u b x y : form (map (Z.mul u) b) x y = IZR u * form b x y.
Proof. induction b as [|v b IH]; simpl; [ring|]; rewrite map_length, mult_IZR, IH; ring. Qed.

Lemma form_elevated b n x y : form (b ++ repeat 0%Z n) x y = y ^ n * form b x y.
Proof.
  induction b as [|v b IH]; simpl; [rewrite form_zeros; ring|].
  rewrite IH, app_length, repeat_length, pow_add; ring.
Qed.

Lemma times_form a b x y : b <> [] -> form (times a b) x y = form a x y * form b x y.
Proof.
  intros some; assert (0 < length b)%nat by (destruct b; [congruence|simpl; lia]).
  induction a as [|u a IH]; [simpl; rewrite form_zeros; ring|].
  simpl times; rewrite add_form.
  - rewrite form_elevated, form_scaled; simpl; rewrite IH; ring.
  - rewrite app_length, map_length, repeat_length; simpl; rewrite times_length by exact some; lia.
Qed.

(** ** Division *)

(** One step: the dividend without its highest coefficient [top], times [leading], minus [top] times the
    divisor. The highest coefficients come first, and [divisor] is without [leading]. *)
Fixpoint reduce (leading top : Z) (rest divisor : polynomial) : polynomial :=
  match rest, divisor with
  | [], _ => []
  | _, [] => map (Z.mul leading) rest
  | c :: rest, f :: divisor => (leading * c - top * f)%Z :: reduce leading top rest divisor
  end.

Fixpoint remainder (steps : nat) (leading : Z) (divisor dividend : polynomial) : polynomial :=
  match steps, dividend with
  | S steps, top :: rest =>
      if (length divisor <=? length rest)%nat then remainder steps leading divisor (reduce leading top rest divisor)
      else dividend
  | _, _ => dividend
  end.

(** [is_multiple_of]. *)
Definition is_multiple_of (dividend divisor : polynomial) : bool :=
  match rev divisor with
  | [] => false
  | leading :: divisor =>
      if (leading =? 0)%Z then false
      else forallb (Z.eqb 0) (remainder (length dividend) leading divisor (rev dividend))
  end.

Lemma form_last l a x y : form (l ++ [a]) x y = y * form l x y + IZR a * x ^ length l.
Proof. induction l as [|b l IH]; simpl; [ring|]; rewrite IH, app_length, pow_add; simpl; ring. Qed.

Lemma form_reversed c x y : form (rev c) y x = form c x y.
Proof. induction c as [|a c IH]; simpl; [reflexivity|]; rewrite form_last, IH, rev_length; ring. Qed.

Lemma reduce_length leading top rest divisor : length (reduce leading top rest divisor) = length rest.
Proof.
  revert divisor; induction rest as [|c rest IH]; intros [|f divisor]; simpl; auto using map_length.
Qed.

Lemma reduce_form leading top rest divisor x y : (length divisor <= length rest)%nat ->
  form (reduce leading top rest divisor) y x
    = IZR leading * form rest y x - IZR top * (x ^ (length rest - length divisor) * form divisor y x).
Proof.
  revert divisor; induction rest as [|c rest IH]; intros [|f divisor] fits.
  - simpl; ring.
  - simpl in fits; lia.
  - change (reduce leading top (c :: rest) []) with (map (Z.mul leading) (c :: rest)).
    rewrite form_scaled; simpl; ring.
  - simpl in fits; simpl; rewrite IH, reduce_length, minus_IZR, !mult_IZR by lia.
    replace (x ^ length rest) with (x ^ (length rest - length divisor) * x ^ length divisor)
      by (rewrite <- pow_add; f_equal; lia).
    ring.
Qed.

Lemma remainder_root steps leading divisor dividend x y :
  leading <> 0%Z -> y <> 0 -> form (leading :: divisor) y x = 0 ->
  form (remainder steps leading divisor dividend) y x = 0 -> form dividend y x = 0.
Proof.
  intros leads inner root; revert dividend; induction steps as [|steps IH]; intros [|top rest]; simpl; auto.
  destruct (Nat.leb_spec (length divisor) (length rest)) as [fits|]; [|auto].
  intros zero; apply IH in zero; rewrite reduce_form in zero by exact fits; simpl in root.
  assert (IZR leading <> 0) by (apply not_0_IZR; exact leads).
  apply Rmult_eq_reg_l with (IZR leading); [|assumption].
  replace (x ^ length rest) with (x ^ (length rest - length divisor) * x ^ length divisor)
    by (rewrite <- pow_add; f_equal; lia).
  replace (IZR leading * (IZR top * (x ^ (length rest - length divisor) * x ^ length divisor) + y * form rest y x))
    with (IZR top * x ^ (length rest - length divisor) * (IZR leading * x ^ length divisor + y * form divisor y x)
      + y * (IZR leading * form rest y x - IZR top * (x ^ (length rest - length divisor) * form divisor y x))) by ring.
  rewrite root, zero; ring.
Qed.

Lemma form_all_zero c x y : forallb (Z.eqb 0) c = true -> form c x y = 0.
Proof.
  induction c as [|a c IH]; simpl; [reflexivity|].
  intros all; apply andb_prop in all as (zero & all); rewrite IH by exact all.
  destruct a; try discriminate; ring.
Qed.

(** A polynomial that passes the division vanishes at all roots of the divisor inside of the interval. *)
Theorem is_multiple_of_root dividend divisor s : is_multiple_of dividend divisor = true ->
  0 < s < 1 -> value divisor s = 0 -> value dividend s = 0.
Proof.
  unfold is_multiple_of, value; intros divides inner root.
  rewrite <- form_reversed in root; rewrite <- form_reversed.
  destruct (rev divisor) as [|leading rest]; [discriminate|].
  destruct (Z.eqb_spec leading 0) as [|leads]; [discriminate|].
  apply (remainder_root (length dividend) leading rest); [exact leads|lra|exact root|].
  apply form_all_zero, divides.
Qed.

(** ** Roots *)

(** [changes_sign]. *)
Definition changes_sign (c : polynomial) : bool :=
  match c with [] => false | a :: _ => (a * last c 0 <? 0)%Z end.

Lemma form_continuous c : continuity (fun s => form c s (1 - s)).
Proof.
  induction c as [|a c IH]; simpl; [apply continuity_const; intros x y; reflexivity|].
  apply continuity_plus; apply continuity_mult; try exact IH.
  - apply continuity_const; intros x y; reflexivity.
  - apply derivable_continuous; reg.
  - apply derivable_continuous, derivable_id.
Qed.

Lemma value_start a c : value (a :: c) 0 = IZR a.
Proof. unfold value; simpl; rewrite Rminus_0_r, pow1; ring. Qed.

Lemma form_end c : c <> [] -> form c 1 0 = IZR (last c 0%Z).
Proof.
  induction c as [|a [|b c] IH]; intros some; [congruence|simpl; ring|].
  change (IZR a * 0 ^ length (b :: c) + 1 * form (b :: c) 1 0 = IZR (last (b :: c) 0%Z)).
  rewrite IH by discriminate; simpl; ring.
Qed.

(** Different signs at the ends prove a root strictly inside. *)
Theorem changes_sign_root c : changes_sign c = true -> exists s, 0 < s < 1 /\ value c s = 0.
Proof.
  destruct c as [|a c]; [discriminate|]; intros changes; unfold changes_sign in changes.
  assert (value (a :: c) 1 = IZR (last (a :: c) 0%Z)) as at_end
    by (unfold value; replace (1 - 1) with 0 by ring; apply form_end; discriminate).
  pose proof (value_start a c) as at_start.
  assert (IZR a * IZR (last (a :: c) 0%Z) < 0) by (rewrite <- mult_IZR; apply IZR_lt, Z.ltb_lt, changes).
  destruct (IVT_cor (value (a :: c)) 0 1) as (s & range & root); [apply form_continuous|lra| |].
  - rewrite at_start, at_end; lra.
  - exists s; split; [|exact root].
    assert (s <> 0) by (intros ->; rewrite root in at_start; rewrite <- at_start in *; lra).
    assert (s <> 1) by (intros ->; rewrite root in at_end; rewrite <- at_end in *; lra).
    lra.
Qed.

(** ** Vectors of polynomials *)

Definition polynomials := axis -> polynomial.

(** [dot], [cross] and [difference] of the code. *)
Definition polynomial_dot (a b : polynomials) : polynomial :=
  add (add (times (a X) (b X)) (times (a Y) (b Y))) (times (a Z3) (b Z3)).
Definition polynomial_cross (a b : polynomials) : polynomials := fun k =>
  subtract (times (a (next k)) (b (next (next k)))) (times (a (next (next k))) (b (next k))).
Definition polynomial_difference (a b : polynomials) : polynomials := fun k => subtract (a k) (b k).

(** All components have n + 1 coefficients. *)
Definition has_degree (n : nat) (a : polynomials) := forall k, length (a k) = S n.

Definition values (a : polynomials) (s : R) : vector := fun k => value (a k) s.

Lemma not_empty (a : polynomials) n k : has_degree n a -> a k <> [].
Proof. intros degree empty; specialize (degree k); rewrite empty in degree; discriminate. Qed.

Lemma difference_degree n a b : has_degree n a -> has_degree n b -> has_degree n (polynomial_difference a b).
Proof. intros a_degree b_degree k; unfold polynomial_difference, subtract; rewrite zip_length; rewrite ?a_degree, ?b_degree; auto. Qed.

Lemma difference_values n a b s : has_degree n a -> has_degree n b ->
  forall k, values (polynomial_difference a b) s k = minus (values a s) (values b s) k.
Proof. intros a_degree b_degree k; unfold values, value, minus; apply subtract_form; now rewrite a_degree, b_degree. Qed.

Lemma cross_degree n o a b : has_degree n a -> has_degree o b -> has_degree (n + o) (polynomial_cross a b).
Proof.
  intros a_degree b_degree k; unfold polynomial_cross, subtract.
  rewrite zip_length; rewrite !times_length, ?a_degree, ?b_degree by (eapply not_empty; eassumption); lia.
Qed.

Lemma cross_values n o a b s : has_degree n a -> has_degree o b ->
  forall k, values (polynomial_cross a b) s k = cross (values a s) (values b s) k.
Proof.
  intros a_degree b_degree k; unfold values, value, cross, polynomial_cross.
  rewrite subtract_form.
  - rewrite !times_form by (eapply not_empty; eassumption); ring.
  - rewrite !times_length, ?a_degree, ?b_degree by (eapply not_empty; eassumption); lia.
Qed.

Lemma dot_value n o a b s : has_degree n a -> has_degree o b ->
  value (polynomial_dot a b) s = dot (values a s) (values b s).
Proof.
  intros a_degree b_degree; unfold values, value, dot, polynomial_dot.
  assert (forall k, length (times (a k) (b k)) = (n + o + 1)%nat) as lengths
    by (intros k; rewrite times_length, a_degree, b_degree by (eapply not_empty; eassumption); lia).
  assert (length (add (times (a X) (b X)) (times (a Y) (b Y))) = (n + o + 1)%nat) as sum_length
    by (unfold add; rewrite zip_length; rewrite !lengths; reflexivity).
  rewrite !add_form by now rewrite ?sum_length, !lengths.
  rewrite !times_form by (eapply not_empty; eassumption); ring.
Qed.
