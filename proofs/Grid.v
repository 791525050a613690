(** Coordinates rounded down to a grid: the file [grid.rs]. *)

From Coq Require Import Reals ZArith List Bool Lra Lia Psatz.
Require Import Vectors Motion Lists Separation.
Import ListNotations.
Open Scope R_scope.

(** The number of bits of an integer: as many shifts to the right leave nothing. *)
Definition bit_length (x : Z) : Z := if (x <=? 0)%Z then 0%Z else (Z.log2 x + 1)%Z.

Lemma bit_length_bound x : (0 <= bit_length x /\ x < 2 ^ bit_length x)%Z.
Proof.
  unfold bit_length; destruct (Z.leb_spec x 0); [simpl; lia|].
  pose proof (Z.log2_nonneg x); destruct (Z.log2_spec x); rewrite <- ?Z.add_1_r in *; lia.
Qed.

Section Grid.
Variable V : Type.
Variable m : motion V.
Hypothesis distance_not_negative : (0 <= distance V m)%Z.
Variable all : list V.
Variable until : time.

Definition start : time := over {| numerator := 0; power := 0 |} (power until).

Definition end_time (e : bool) : time := if e then until else start.

(** All coordinates at both times. *)
Definition coordinates : list Z :=
  flat_map (fun e => flat_map (fun v => [at_time V m v (end_time e) X; at_time V m v (end_time e) Y; at_time V m v (end_time e) Z3]) all)
    [false; true].

Definition largest : Z := Z.max (most coordinates) (- least coordinates).

Definition bits : Z := bit_length largest.

(** [rounded]: both shifts, the one to the right rounding down. *)
Definition rounded (x : Z) : Z := if (60 <? bits)%Z then Z.shiftr x (bits - 60) else Z.shiftl x (60 - bits).

(** A point and the distance in [Grid::new]. *)
Definition point (e : bool) (v : V) : integer_point := fun k => rounded (at_time V m v (end_time e) k).
Definition grid_distance : Z := Z.min (- rounded (- shift_left (distance V m) (power until))) (2 ^ 62).

(** Rounded down, in units of the grid. *)
Lemma rounded_down : exists u, 0 < u /\ forall x, IZR (rounded x) <= u * IZR x < IZR (rounded x) + 1.
Proof.
  unfold rounded; destruct (Z.ltb_spec 60 bits) as [long|short].
  - exists (/ IZR (2 ^ (bits - 60))).
    assert (0 < 2 ^ (bits - 60))%Z as positive by (apply Z.pow_pos_nonneg; lia).
    pose proof (IZR_lt _ _ positive) as real_positive.
    split; [apply Rinv_0_lt_compat; exact real_positive|]; intros x.
    rewrite Z.shiftr_div_pow2 by lia; set (n := (2 ^ (bits - 60))%Z) in *.
    pose proof (Z.div_mod x n ltac:(lia)) as split_x; pose proof (Z.mod_pos_bound x n positive) as rest.
    assert ((x / n) * n <= x < (x / n + 1) * n)%Z as (low & high) by nia.
    apply IZR_le in low; apply IZR_lt in high; rewrite mult_IZR in low, high; rewrite plus_IZR in high.
    split; [apply Rmult_le_reg_l with (IZR n)|apply Rmult_lt_reg_l with (IZR n)]; try exact real_positive;
      rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra; lra.
  - exists (IZR (2 ^ (60 - bits))).
    assert (0 < 2 ^ (60 - bits))%Z as positive by (apply Z.pow_pos_nonneg; pose proof (bit_length_bound largest); unfold bits in *; lia).
    split; [apply IZR_lt; exact positive|]; intros x.
    rewrite Z.shiftl_mul_pow2, mult_IZR by lia; lra.
Qed.

Lemma coordinate_in e v k : In v all -> In (at_time V m v (end_time e) k) coordinates.
Proof.
  intros here; unfold coordinates; apply in_flat_map; exists e; split; [destruct e; simpl; tauto|].
  apply in_flat_map; exists v; split; [exact here|destruct k; simpl; tauto].
Qed.

(** Coordinates on the grid are at most 2^60 in magnitude: they fit into 64 bits. *)
Theorem point_bound e v k : In v all -> (- 2 ^ 60 <= point e v k <= 2 ^ 60)%Z.
Proof.
  intros here; unfold point; set (x := at_time V m v (end_time e) k).
  pose proof (coordinate_in e v k here) as member; fold x in member.
  pose proof (most_above _ _ member); pose proof (least_below _ _ member).
  destruct (bit_length_bound largest) as (bits_least & bound); fold bits in bits_least, bound.
  assert (- 2 ^ bits <= x <= 2 ^ bits)%Z by (unfold largest in bound; lia).
  unfold rounded; destruct (Z.ltb_spec 60 bits) as [long|short].
  - rewrite Z.shiftr_div_pow2 by lia.
    assert (2 ^ bits = 2 ^ 60 * 2 ^ (bits - 60))%Z as parts by (rewrite <- Z.pow_add_r; f_equal; lia).
    assert (0 < 2 ^ (bits - 60))%Z as positive by (apply Z.pow_pos_nonneg; lia).
    split; [apply Z.div_le_lower_bound|apply Z.div_le_upper_bound]; lia.
  - rewrite Z.shiftl_mul_pow2 by lia.
    assert (2 ^ 60 = 2 ^ bits * 2 ^ (60 - bits))%Z as parts by (rewrite <- Z.pow_add_r; f_equal; lia).
    assert (0 < 2 ^ (60 - bits))%Z as positive by (apply Z.pow_pos_nonneg; lia).
    rewrite parts; nia.
Qed.

Lemma start_moment : moment start = 0.
Proof. unfold start; rewrite moment_over; unfold moment; simpl; lra. Qed.

Lemma end_power e : power (end_time e) = power until.
Proof. destruct e; [reflexivity|]; unfold start; simpl; lia. Qed.

(** The distance of the grid is rounded up, unless it is more than the differences of any coordinates. *)
Lemma grid_distance_up u : 0 < u -> (forall x, IZR (rounded x) <= u * IZR x < IZR (rounded x) + 1) ->
  (grid_distance < 2 ^ 62)%Z -> u * (2 ^ power until * IZR (distance V m)) <= IZR grid_distance.
Proof.
  intros positive scale short; unfold grid_distance in *; rewrite Z.min_l in * by lia.
  destruct (scale (- shift_left (distance V m) (power until))%Z) as (down & _).
  rewrite !opp_IZR, shift_left_real in *; lra.
Qed.

Lemma grid_distance_least : (0 <= grid_distance)%Z.
Proof.
  destruct rounded_down as (u & positive & scale); unfold grid_distance; apply Z.min_glb; [|lia].
  apply le_IZR; rewrite opp_IZR.
  destruct (scale (- shift_left (distance V m) (power until))%Z) as (down & _).
  rewrite opp_IZR, shift_left_real in down.
  apply IZR_le in distance_not_negative; pose proof (power_positive (power until)).
  assert (0 <= u * (IZR (distance V m) * 2 ^ power until)) by (repeat apply Rmult_le_pos; lra).
  lra.
Qed.

(** [Grid::separates]; [at_ends] are the ends that it examines. *)
Definition separates (p : pair V) (g : integer_point) (at_ends : list bool) : bool :=
  let total := (Z.abs (g X) + Z.abs (g Y) + Z.abs (g Z3))%Z in
  let needed :=
    if has_distance V p && (0 <? grid_distance)%Z
    then (total + grid_distance * (Z.sqrt (integer_dot g g) + 1))%Z else total in
  negb ((g X =? 0) && (g Y =? 0) && (g Z3 =? 0))%Z
  && (Z.abs (g X) <? 2 ^ 48)%Z && (Z.abs (g Y) <? 2 ^ 48)%Z && (Z.abs (g Z3) <? 2 ^ 48)%Z
  && forallb (fun e => (needed <=? gap V p (fun v => integer_dot g (point e v)))%Z) at_ends.

(** No sum of [separates] overflows: they all fit into 128 bits. *)
Theorem sums_fit g e v : (forall k, Z.abs (g k) < 2 ^ 48)%Z -> In v all ->
  ((forall k, Z.abs (g k * point e v k) <= 2 ^ 108)
  /\ Z.abs (integer_dot g (point e v)) <= 3 * 2 ^ 108
  /\ 0 <= integer_dot g g < 3 * 2 ^ 96
  /\ 0 <= Z.abs (g X) + Z.abs (g Y) + Z.abs (g Z3) + grid_distance * (Z.sqrt (integer_dot g g) + 1) < 2 ^ 113)%Z.
Proof.
  intros small here.
  assert (forall k, Z.abs (g k * point e v k) <= 2 ^ 108)%Z as products.
  { intros k; rewrite Z.abs_mul; pose proof (point_bound e v k here); specialize (small k).
    change (2 ^ 108)%Z with (2 ^ 48 * 2 ^ 60)%Z; apply Z.mul_le_mono_nonneg; lia. }
  split; [exact products|split].
  - pose proof (products X); pose proof (products Y); pose proof (products Z3); unfold integer_dot; lia.
  - assert (forall k, 0 <= g k * g k < 2 ^ 96)%Z as squares.
    { intros k; rewrite <- Z.abs_square; specialize (small k); split; [lia|].
      apply Z.le_lt_trans with ((2 ^ 48 - 1) * (2 ^ 48 - 1))%Z; [apply Z.mul_le_mono_nonneg; lia|lia]. }
    assert (0 <= integer_dot g g < 3 * 2 ^ 96)%Z as square
      by (pose proof (squares X); pose proof (squares Y); pose proof (squares Z3); unfold integer_dot; lia).
    split; [exact square|].
    assert (Z.sqrt (integer_dot g g) <= 2 ^ 49)%Z as root
      by (change (2 ^ 49)%Z with (Z.sqrt (2 ^ 98)); apply Z.sqrt_le_mono; lia).
    pose proof (Z.sqrt_nonneg (integer_dot g g)); pose proof grid_distance_least.
    assert (grid_distance <= 2 ^ 62)%Z by (unfold grid_distance; lia).
    assert (grid_distance * (Z.sqrt (integer_dot g g) + 1) <= 2 ^ 62 * (2 ^ 49 + 1))%Z by (apply Z.mul_le_mono_nonneg; lia).
    assert (0 <= grid_distance * (Z.sqrt (integer_dot g g) + 1))%Z by (apply Z.mul_nonneg_nonneg; lia).
    pose proof (small X); pose proof (small Y); pose proof (small Z3); lia.
Qed.

(** What rounding takes away from a difference along one axis. *)
Lemma component_rounded g a b (x y : Z) : b < 1 -> -1 < b -> a = IZR x - IZR y + b -> IZR g * (IZR x - IZR y) - IZR (Z.abs g) <= IZR g * a
  /\ (g <> 0%Z -> IZR g * (IZR x - IZR y) - IZR (Z.abs g) < IZR g * a).
Proof.
  intros less more ->; rewrite abs_IZR; unfold Rabs; destruct (Rcase_abs (IZR g)) as [negative|least].
  - split; [|intros _]; nra.
  - split; [nra|]; intros other; assert (IZR g <> 0) by (apply not_0_IZR; exact other); nra.
Qed.

Lemma separates_end p g ends e x y :
  (forall v, In v (first V p) \/ In v (second V p) -> In v all) ->
  separates p g ends = true -> In e ends -> In x (first V p) -> In y (second V p) ->
  IZR (reach V m p) * sqrt (dot (real g) (real g))
    < dot (real g) (minus (position V m x (moment (end_time e))) (position V m y (moment (end_time e)))).
Proof.
  unfold separates; set (total := (Z.abs (g X) + Z.abs (g Y) + Z.abs (g Z3))%Z).
  set (length := (Z.sqrt (integer_dot g g) + 1)%Z).
  intros listed holds e_here x_here y_here.
  apply andb_prop in holds as (holds & at_ends); repeat (apply andb_prop in holds; destruct holds as (holds & _)).
  rewrite forallb_forall in at_ends; specialize (at_ends e e_here); apply Z.leb_le in at_ends.
  pose proof (gap_below V p (fun v => integer_dot g (point e v)) x y x_here y_here) as below; cbv beta in below.
  destruct rounded_down as (u & positive & scale).
  assert (g X <> 0 \/ g Y <> 0 \/ g Z3 <> 0)%Z as other
    by (destruct (Z.eqb_spec (g X) 0), (Z.eqb_spec (g Y) 0), (Z.eqb_spec (g Z3) 0); simpl in holds; try discriminate; tauto).
  pose proof (power_positive (power until)) as unit.
  set (P := 2 ^ power until) in *.
  assert (forall v k, IZR (at_time V m v (end_time e) k) = P * position V m v (moment (end_time e)) k) as exact
    by (intros; rewrite at_time_exact, end_power; reflexivity).
  set (s := moment (end_time e)) in *.
  (* Along each axis, and so along g. *)
  assert (IZR (integer_dot g (point e x) - integer_dot g (point e y)) - IZR total
    < u * P * dot (real g) (minus (position V m x s) (position V m y s))) as along.
  { assert (forall k, IZR (g k) * (IZR (point e x k) - IZR (point e y k)) - IZR (Z.abs (g k))
        <= IZR (g k) * (u * P * minus (position V m x s) (position V m y s) k)
      /\ (g k <> 0%Z -> IZR (g k) * (IZR (point e x k) - IZR (point e y k)) - IZR (Z.abs (g k))
        < IZR (g k) * (u * P * minus (position V m x s) (position V m y s) k))) as axes.
    { intros k; destruct (scale (at_time V m x (end_time e) k)) as (x_low & x_high);
        destruct (scale (at_time V m y (end_time e) k)) as (y_low & y_high).
      fold (point e x k) in x_low, x_high; fold (point e y k) in y_low, y_high.
      change (rounded (at_time V m x (end_time e) k)) with (point e x k) in *.
      change (rounded (at_time V m y (end_time e) k)) with (point e y k) in *.
      apply (component_rounded (g k) _ (u * IZR (at_time V m x (end_time e) k) - IZR (point e x k)
        - (u * IZR (at_time V m y (end_time e) k) - IZR (point e y k)))); [lra|lra|].
      rewrite !exact; unfold minus; ring. }
    destruct (axes X) as (x_axis & x_strict), (axes Y) as (y_axis & y_strict), (axes Z3) as (z_axis & z_strict).
    replace (u * P * dot (real g) (minus (position V m x s) (position V m y s))) with
      (IZR (g X) * (u * P * minus (position V m x s) (position V m y s) X)
      + IZR (g Y) * (u * P * minus (position V m x s) (position V m y s) Y)
      + IZR (g Z3) * (u * P * minus (position V m x s) (position V m y s) Z3)) by (unfold dot, real; ring).
    unfold total, integer_dot; rewrite minus_IZR, !plus_IZR, !mult_IZR.
    destruct other as [o|[o|o]]; [specialize (x_strict o)|specialize (y_strict o)|specialize (z_strict o)]; lra. }
  assert (0 < u * P) as scale_positive by (apply Rmult_lt_0_compat; assumption).
  apply Rmult_lt_reg_l with (u * P); [exact scale_positive|].
  apply Rle_lt_trans with (2 := along); rewrite <- minus_IZR.
  pose proof grid_distance_least as d_least.
  assert (0 < length /\ integer_dot g g < length * length)%Z as (length_positive & longer).
  { pose proof (integer_square_not_negative g); destruct (Z.sqrt_spec (integer_dot g g)) as (_ & above); [assumption|].
    pose proof (Z.sqrt_nonneg (integer_dot g g)); unfold length; rewrite <- Z.add_1_r in above; lia. }
  unfold reach; destruct (has_distance V p); simpl in at_ends; [|simpl; rewrite Rmult_0_l, Rmult_0_r; apply IZR_le; lia].
  assert (grid_distance < 2 ^ 62)%Z as short.
  { destruct (Z.ltb_spec grid_distance (2 ^ 62)); [assumption|exfalso].
    destruct (Z.ltb_spec 0 grid_distance); [|lia].
    assert (forall k, - 2 ^ 61 <= point e x k - point e y k <= 2 ^ 61)%Z as differences
      by (intros k; pose proof (point_bound e x k (listed x (or_introl x_here)));
          pose proof (point_bound e y k (listed y (or_intror y_here))); lia).
    assert (integer_dot g (point e x) - integer_dot g (point e y) <= total * 2 ^ 61)%Z.
    { unfold integer_dot, total; pose proof (differences X); pose proof (differences Y); pose proof (differences Z3).
      assert (forall a d, - 2 ^ 61 <= d <= 2 ^ 61 -> a * d <= Z.abs a * 2 ^ 61)%Z as product
        by (intros a d d_range; destruct (Z.abs_spec a) as [(? & ->)|(? & ->)];
          [apply Z.mul_le_mono_nonneg_l; lia|replace (a * d)%Z with (- a * - d)%Z by ring; apply Z.mul_le_mono_nonneg_l; lia]).
      pose proof (product (g X) _ (differences X)); pose proof (product (g Y) _ (differences Y));
        pose proof (product (g Z3) _ (differences Z3)); lia. }
    assert (total * total <= 3 * integer_dot g g)%Z.
    { unfold total, integer_dot.
      rewrite <- (Z.abs_square (g X)), <- (Z.abs_square (g Y)), <- (Z.abs_square (g Z3)).
      set (a := Z.abs (g X)); set (b := Z.abs (g Y)); set (c := Z.abs (g Z3)).
      pose proof (Z.square_nonneg (a - b)); pose proof (Z.square_nonneg (b - c)); pose proof (Z.square_nonneg (c - a)); lia. }
    assert (0 <= total)%Z by (unfold total; lia).
    assert (total < 2 * length)%Z.
    { apply Z.nle_gt; intros more.
      assert (2 * length * (2 * length) <= total * total)%Z by (apply Z.mul_le_mono_nonneg; lia); lia. }
    assert (2 ^ 62 * length <= grid_distance * length)%Z by (apply Z.mul_le_mono_nonneg_r; lia).
    lia. }
  pose proof (grid_distance_up u positive scale short) as up; fold P in up.
  apply IZR_le in d_least; apply IZR_lt in length_positive.
  assert (sqrt (dot (real g) (real g)) <= IZR length) as root.
  { rewrite <- integer_dot_real; apply Rsqr_incr_0; [|apply sqrt_pos|lra].
    rewrite Rsqr_sqrt by (apply IZR_le, integer_square_not_negative).
    unfold Rsqr; rewrite <- mult_IZR; apply IZR_le; lia. }
  apply Rle_trans with (IZR grid_distance * IZR length).
  - pose proof (sqrt_pos (dot (real g) (real g))).
    replace (u * P * (IZR (distance V m) * sqrt (dot (real g) (real g))))
      with (u * (P * IZR (distance V m)) * sqrt (dot (real g) (real g))) by ring.
    apply IZR_le in distance_not_negative.
    apply Rmult_le_compat; try assumption; repeat apply Rmult_le_pos; lra.
  - rewrite <- mult_IZR; apply IZR_le.
    destruct (Z.ltb_spec 0 grid_distance); simpl in at_ends; [lia|].
    assert (grid_distance = 0)%Z as zero by (apply Z.le_antisymm; [assumption|apply le_IZR; exact d_least]).
    rewrite zero; lia.
Qed.

(** A direction that the grid accepts at both times proves that the pair is apart from t = 0 to t = T. *)
Theorem separates_apart p g t :
  (forall v, In v (first V p) \/ In v (second V p) -> In v all) ->
  separates p g [false; true] = true -> 0 <= t <= moment until -> apart V m p t.
Proof.
  intros listed holds range; apply (apart_between V m (real g) p 0 (moment until)); try assumption.
  intros x y x_here y_here; rewrite <- start_moment; split.
  - apply (separates_end p g [false; true] false); try assumption; simpl; tauto.
  - apply (separates_end p g [false; true] true); try assumption; simpl; tauto.
Qed.

(** For an edge and a face, t = 0 suffices. *)
Theorem separates_rest p g :
  (forall v, In v (first V p) \/ In v (second V p) -> In v all) ->
  separates p g [false] = true -> apart V m p 0.
Proof.
  intros listed holds; apply (apart_between V m (real g) p 0 0); try assumption; [lra|].
  intros x y x_here y_here; rewrite <- start_moment.
  split; apply (separates_end p g [false] false); try assumption; simpl; tauto.
Qed.

End Grid.
