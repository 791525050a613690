(** The numbers of files as integers times powers of two, and adjacent f64: [dyadic] and [Time::together] of
    [motion.rs], [Head::read] of [certificate.rs].

    Flocq has the meaning of the bits of an f64: [B2R (b64_of_bits b)]. *)

From Coq Require Import Reals ZArith List Bool Lra Lia.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.Binary IEEE754.Bits.
Require Import Motion.
Open Scope R_scope.

(** The real value of the bits of a finite f64. *)
Definition real_of_bits (b : Z) : R := Binary.B2R 53 1024 (b64_of_bits b).

Definition exponent_field (b : Z) : Z := (Z.shiftr b 52 mod 2048)%Z.
Definition fraction (b : Z) : Z := (b mod 2 ^ 52)%Z.
Definition is_negative (b : Z) : bool := (2 ^ 63 <=? b)%Z.

(** The integer and the exponent before zeros are removed. *)
Definition raw (b : Z) : Z * Z :=
  if (exponent_field b =? 0)%Z then (fraction b, -1074)%Z else (2 ^ 52 + fraction b, exponent_field b - 1075)%Z.

(** The number of zeros at the end of a positive integer. *)
Fixpoint trailing_zeros (p : positive) : nat := match p with xO p => S (trailing_zeros p) | _ => 0%nat end.

(** [dyadic]. *)
Definition dyadic (b : Z) : option (Z * Z) :=
  if (exponent_field b =? 2047)%Z then None
  else match raw b with
  | (Zpos p, e) =>
      let zeros := Z.of_nat (trailing_zeros p) in
      let mantissa := Z.shiftr (Zpos p) zeros in
      Some (if is_negative b then - mantissa else mantissa, e + zeros)%Z
  | _ => Some (0, 971)%Z
  end.

Lemma odd_part p : (Z.pos p = Z.shiftr (Z.pos p) (Z.of_nat (trailing_zeros p)) * 2 ^ Z.of_nat (trailing_zeros p))%Z.
Proof.
  induction p as [p _|p IH|]; try (simpl trailing_zeros; rewrite Z.shiftr_0_r; simpl; lia).
  simpl trailing_zeros; rewrite Nat2Z.inj_succ.
  replace (Z.shiftr (Z.pos p~0) (Z.succ (Z.of_nat (trailing_zeros p))))
    with (Z.shiftr (Z.pos p) (Z.of_nat (trailing_zeros p))).
  - rewrite Z.pow_succ_r by lia.
    rewrite (Pos2Z.inj_xO p); rewrite IH at 1; ring.
  - rewrite !Z.shiftr_div_pow2, Z.pow_succ_r by lia; change (Z.pos p~0) with (2 * Z.pos p)%Z.
    symmetry; apply Z.div_mul_cancel_l; [apply Z.pow_nonzero; lia|lia].
Qed.

(** The value in terms of the fields. *)
Lemma real_of_bits_raw b : exponent_field b <> 2047%Z ->
  real_of_bits b = (if is_negative b then -1 else 1) * (IZR (fst (raw b)) * bpow radix2 (snd (raw b))).
Proof.
  intros finite.
  assert (0 <= fraction b)%Z as least by (apply Z.mod_pos_bound; lia).
  unfold real_of_bits, b64_of_bits, binary_float_of_bits; rewrite Binary.B2R_FF2B.
  unfold binary_float_of_bits_aux, split_bits; rewrite <- Z.shiftr_div_pow2 by lia.
  change (2 ^ 52 * 2 ^ 11)%Z with (2 ^ 63)%Z; change (2 ^ 11)%Z with 2048%Z.
  change (Z.leb (2 ^ 63) b) with (is_negative b).
  change (Z.shiftr b 52 mod 2048)%Z with (exponent_field b); change (b mod 2 ^ 52)%Z with (fraction b).
  unfold raw; rewrite (Z.add_comm (2 ^ 52)).
  change (Zeq_bool (exponent_field b) 0) with (Zeq_bool (exponent_field b) 0).
  pose proof (Zeq_bool_if (exponent_field b) 0) as zero.
  pose proof (Zeq_bool_if (exponent_field b) (2048 - 1)) as last.
  destruct (Zeq_bool (exponent_field b) 0); destruct (Z.eqb_spec (exponent_field b) 0); try contradiction.
  - destruct (fraction b) as [|p|p]; simpl; [ring| |lia].
    unfold Defs.F2R, cond_Zopp; simpl; destruct (is_negative b); simpl; [change (IZR (Z.neg p)) with (- IZR (Z.pos p))|]; ring.
  - destruct (Zeq_bool (exponent_field b) (2048 - 1)); [lia|].
    destruct (fraction b + 2 ^ 52)%Z as [|p|p] eqn:mantissa; try lia.
    unfold Binary.FF2R, Defs.F2R, cond_Zopp; cbn [Defs.Fnum Defs.Fexp fst snd].
    replace (exponent_field b + SpecFloat.emin (52 + 1) (2 ^ (11 - 1)) - 1)%Z with (exponent_field b - 1075)%Z
      by (change (SpecFloat.emin (52 + 1) (2 ^ (11 - 1))) with (-1074)%Z; lia).
    destruct (is_negative b); [rewrite opp_IZR|]; ring.
Qed.

(** [dyadic] has the value of every finite f64. *)
Theorem dyadic_value b mantissa exponent : dyadic b = Some (mantissa, exponent) ->
  real_of_bits b = IZR mantissa * bpow radix2 exponent.
Proof.
  unfold dyadic; destruct (Z.eqb_spec (exponent_field b) 2047) as [|finite]; [discriminate|].
  pose proof (real_of_bits_raw b finite) as value.
  assert (0 <= fst (raw b))%Z as least.
  { unfold raw; assert (0 <= fraction b)%Z by (apply Z.mod_pos_bound; lia).
    destruct (exponent_field b =? 0)%Z; cbn [fst]; lia. }
  destruct (raw b) as ([|p|p], e); cbn [fst snd] in *; [| |lia].
  - intros [= <- <-]; rewrite value; ring.
  - pose proof (odd_part p) as parts; set (zeros := Z.of_nat (trailing_zeros p)) in *.
    assert (0 <= zeros)%Z by (unfold zeros; lia).
    intros [= <- <-]; rewrite value, bpow_plus.
    replace (IZR (Z.pos p)) with (IZR (Z.shiftr (Z.pos p) zeros) * bpow radix2 zeros)
      by (rewrite parts at 2; rewrite mult_IZR, <- (IZR_Zpower radix2) by assumption; reflexivity).
    destruct (is_negative b); [rewrite opp_IZR|]; ring.
Qed.

(** ** Times *)

Definition one_bits : Z := 1023 * 2 ^ 52.

(** [Time::together], of one number. *)
Definition time_of_bits (b : Z) : time :=
  match dyadic b with
  | Some (mantissa, exponent) =>
      if (exponent <=? 0)%Z then {| numerator := mantissa; power := Z.to_nat (- exponent) |}
      else {| numerator := 0; power := 0 |}
  | None => {| numerator := 0; power := 0 |}
  end.

(** The value of a number from 0 to 1, from the fields of its bits. *)
Definition field_value (f e : Z) : R :=
  (if (e =? 0)%Z then IZR f * bpow radix2 (-1074) else IZR (2 ^ 52 + f) * bpow radix2 (e - 1075)).

Lemma fields b : (0 <= b <= one_bits)%Z ->
  (b = exponent_field b * 2 ^ 52 + fraction b /\ 0 <= fraction b < 2 ^ 52 /\ 0 <= exponent_field b <= 1023)%Z.
Proof.
  intros range; unfold exponent_field, fraction, one_bits in *; rewrite Z.shiftr_div_pow2 by lia.
  pose proof (Z.div_mod b (2 ^ 52) ltac:(lia)); pose proof (Z.mod_pos_bound b (2 ^ 52) ltac:(lia)).
  rewrite Z.mod_small by (split; [apply Z.div_pos; lia|apply Z.div_lt_upper_bound; lia]); lia.
Qed.

Lemma real_of_fields b : (0 <= b <= one_bits)%Z -> real_of_bits b = field_value (fraction b) (exponent_field b).
Proof.
  intros range; destruct (fields b range) as (_ & fraction_range & exponent_range).
  rewrite real_of_bits_raw by lia; unfold is_negative, raw, field_value.
  destruct (Z.leb_spec (2 ^ 63) b); [unfold one_bits in range; lia|].
  destruct (exponent_field b =? 0)%Z; cbn [fst snd]; ring.
Qed.

Lemma field_value_less f e f' e' : (0 <= f < 2 ^ 52)%Z -> (0 <= f' < 2 ^ 52)%Z -> (0 <= e)%Z ->
  (e * 2 ^ 52 + f < e' * 2 ^ 52 + f')%Z -> field_value f e < field_value f' e'.
Proof.
  intros f_range f'_range e_least less; unfold field_value.
  destruct (Z.eq_dec e e') as [<-|other].
  - destruct (e =? 0)%Z; apply Rmult_lt_compat_r; try apply bpow_gt_0; apply IZR_lt; lia.
  - assert (e < e')%Z by lia.
    destruct (Z.eqb_spec e' 0); [lia|].
    apply Rlt_le_trans with (IZR (2 ^ 52) * bpow radix2 (e' - 1075)).
    + destruct (Z.eqb_spec e 0).
      * apply Rlt_le_trans with (IZR (2 ^ 52) * bpow radix2 (-1074)).
        -- apply Rmult_lt_compat_r; [apply bpow_gt_0|apply IZR_lt; lia].
        -- apply Rmult_le_compat_l; [apply IZR_le; lia|apply bpow_le; lia].
      * apply Rlt_le_trans with (IZR (2 ^ 53) * bpow radix2 (e - 1075)).
        -- apply Rmult_lt_compat_r; [apply bpow_gt_0|apply IZR_lt; lia].
        -- replace (IZR (2 ^ 53)) with (IZR (2 ^ 52) * bpow radix2 1)
             by (change (bpow radix2 1) with (IZR 2); rewrite <- mult_IZR; reflexivity).
           rewrite Rmult_assoc, <- bpow_plus.
           apply Rmult_le_compat_l; [apply IZR_le; lia|apply bpow_le; lia].
    + apply Rmult_le_compat_r; [apply bpow_ge_0|apply IZR_le; lia].
Qed.

(** f64 from 0 to 1 are ordered like their bits. *)
Theorem real_of_bits_less b b' : (0 <= b)%Z -> (b < b')%Z -> (b' <= one_bits)%Z -> real_of_bits b < real_of_bits b'.
Proof.
  intros least less most; rewrite !real_of_fields by lia.
  destruct (fields b) as (b_is & b_fraction & b_exponent), (fields b') as (b'_is & b'_fraction & b'_exponent); try lia.
  apply field_value_less; lia.
Qed.

(** [T] and [T⁺] are adjacent if their bits differ by 1: no f64 from 0 to 1 is between them. *)
Theorem adjacent b x : (0 <= b)%Z -> (b + 1 <= one_bits)%Z -> (0 <= x <= one_bits)%Z ->
  ~ real_of_bits b < real_of_bits x < real_of_bits (b + 1).
Proof.
  intros least most range (above & below).
  destruct (Z.lt_trichotomy x b) as [less|[->|more]]; [|lra|].
  - apply real_of_bits_less in less; lia || lra.
  - destruct (Z.eq_dec x (b + 1)) as [->|other]; [lra|].
    assert (b + 1 < x)%Z as beyond by lia; apply real_of_bits_less in beyond; lia || lra.
Qed.

Lemma bpow_negative (n : nat) : bpow radix2 (- Z.of_nat n) = / 2 ^ n.
Proof.
  rewrite bpow_opp; f_equal; rewrite <- (IZR_Zpower radix2) by lia; rewrite pow_IZR; reflexivity.
Qed.

(** [Time::together] has the value of every f64 from 0 to 1. *)
Theorem time_value b : (0 <= b <= one_bits)%Z -> moment (time_of_bits b) = real_of_bits b.
Proof.
  intros range; unfold time_of_bits.
  destruct (dyadic b) as [(mantissa, exponent)|] eqn:is_dyadic.
  - pose proof (dyadic_value b mantissa exponent is_dyadic) as value; rewrite value; unfold moment.
    destruct (Z.leb_spec exponent 0) as [small|large]; cbn [numerator power].
    + replace exponent with (- Z.of_nat (Z.to_nat (- exponent)))%Z at 2 by lia; rewrite bpow_negative; reflexivity.
    + (* More than 1, if it is not 0. *)
      assert (real_of_bits b <= 1) as most.
      { replace 1 with (real_of_bits one_bits) at 1.
        - destruct (Z.eq_dec b one_bits) as [->|other]; [lra|apply Rlt_le, real_of_bits_less; lia].
        - rewrite real_of_fields by (unfold one_bits; lia); unfold field_value.
          change (exponent_field one_bits) with 1023%Z; change (fraction one_bits) with 0%Z.
          change (1023 =? 0)%Z with false; cbv iota.
          change (bpow radix2 (1023 - 1075)) with (/ IZR (2 ^ 52 + 0)); apply Rinv_r, not_0_IZR; discriminate. }
      assert (0 <= real_of_bits b) as least.
      { rewrite real_of_fields by exact range; destruct (fields b range) as (_ & fraction_range & _).
        unfold field_value; destruct (exponent_field b =? 0)%Z; apply Rmult_le_pos; try apply bpow_ge_0; apply IZR_le; lia. }
      destruct (Z.eq_dec mantissa 0) as [->|other]; [simpl; lra|exfalso].
      rewrite value in most, least.
      assert (2 <= bpow radix2 exponent) by (change 2 with (bpow radix2 1); apply bpow_le; lia).
      assert (0 <= IZR mantissa) as positive by (apply Rmult_le_reg_r with (bpow radix2 exponent); lra).
      apply le_IZR in positive; assert (1 <= IZR mantissa) by (apply IZR_le; lia).
      assert (1 * 2 <= IZR mantissa * bpow radix2 exponent) by (apply Rmult_le_compat; lra); lra.
  - exfalso; unfold dyadic in is_dyadic; destruct (Z.eqb_spec (exponent_field b) 2047).
    + destruct (fields b range); lia.
    + destruct (raw b) as ([|p|p], e); discriminate.
Qed.

(** ** Coordinates *)

(** The integer of a number, in [Motion::new]: [unit] is at most all exponents, so that no bit is lost. *)
Definition whole (unit b : Z) : Z :=
  match dyadic b with Some (mantissa, exponent) => Z.shiftl mantissa (Z.max (exponent - unit) 0) | None => 0 end.

Theorem whole_exact unit b mantissa exponent : dyadic b = Some (mantissa, exponent) -> (unit <= exponent)%Z ->
  real_of_bits b = IZR (whole unit b) * bpow radix2 unit.
Proof.
  intros is_dyadic small; rewrite (dyadic_value b mantissa exponent is_dyadic); unfold whole; rewrite is_dyadic.
  rewrite Z.max_l, Z.shiftl_mul_pow2, mult_IZR by lia.
  replace (IZR (2 ^ (exponent - unit))) with (bpow radix2 (exponent - unit)) by (rewrite <- (IZR_Zpower radix2) by lia; reflexivity).
  rewrite Rmult_assoc, <- bpow_plus; do 2 f_equal; lia.
Qed.
