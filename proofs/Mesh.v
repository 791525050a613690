(** The pairs that count are pairs of primitives of the search: the file [mesh.rs]. *)

From Coq Require Import ZArith List Bool Lia.
Require Import Motion Separation Moving.
Import ListNotations.

(** [Mesh] of the code. *)
Record mesh := {
  vertex_count : nat;
  faces : list (nat * nat * nat);
  edges : list (nat * nat);
  face_edges : nat;
  degrees : list nat
}.

(** Of [Mesh::new]: indices name vertices, and each vertex has a number of edges. *)
Definition is_mesh (m : mesh) :=
  length (degrees m) = vertex_count m
  /\ (forall a b c v, In (a, b, c) (faces m) -> In v [a; b; c] -> v < vertex_count m)
  /\ (forall a b v, In (a, b) (edges m) -> In v [a; b] -> v < vertex_count m).

Definition has_edge (m : mesh) (a b : nat) : bool :=
  existsb (fun e => (fst e =? Nat.min a b) && (snd e =? Nat.max a b)) (edges m).

Definition is_one_set (k : kind) : bool := match k with EdgeEdge | VertexVertex => true | _ => false end.

Definition edge (m : mesh) (i : nat) : option (list nat) := option_map (fun e => [fst e; snd e]) (nth_error (edges m) i).
Definition face (m : mesh) (i : nat) : option (list nat) :=
  option_map (fun f => let '(a, b, c) := f in [a; b; c]) (nth_error (faces m) i).

(** [Mesh::pair]. *)
Definition pair_of (m : mesh) (k : kind) (ids : nat * nat) : option (pair nat) :=
  let '(a, b) := ids in
  let first_vertices := match k with EdgeEdge | EdgeFace => edge m a | _ => Some [a] end in
  let second_vertices :=
    match k with
    | VertexFace | EdgeFace => face m b
    | EdgeEdge => edge m b
    | VertexEdge => if face_edges m <=? b then edge m b else None
    | VertexVertex => Some [b]
    end in
  match first_vertices, second_vertices with
  | Some xs, Some ys =>
      let are_apart := forallb (fun x => negb (existsb (Nat.eqb x) ys) && (x <? vertex_count m)) xs in
      let is_ordered := (a <? b) || negb (is_one_set k) in
      let has_degree v n := match nth_error (degrees m) v with Some d => d =? n | None => false end in
      let is_connected :=
        match k, ys with
        | VertexVertex, _ => has_degree a 0 && has_degree b 0
        | VertexEdge, [x; y] => has_degree a (Nat.b2n (has_edge m a x) + Nat.b2n (has_edge m a y))
        | _, _ => true
        end in
      let has_distance := match k with VertexEdge => has_degree a 0 | EdgeFace => false | _ => true end in
      if are_apart && is_ordered && is_connected then Some {| first := xs; second := ys; has_distance := has_distance |} else None
  | _, _ => None
  end.

(** A list with its indices. *)
Definition indexed {A} (l : list A) : list (nat * A) := combine (seq 0 (length l)) l.

(** [Mesh::primitives]: indices and vertices; the last vertex is repeated up to three. *)
Definition primitives (m : mesh) (k : kind) (is_second : bool) : list (nat * (nat * nat * nat)) :=
  let vertices most := map (fun v => (fst v, (fst v, fst v, fst v))) (filter (fun v => snd v <=? most) (indexed (degrees m))) in
  let edges_from from := map (fun e => (fst e, (fst (snd e), snd (snd e), snd (snd e)))) (skipn from (indexed (edges m))) in
  match k, is_second with
  | VertexFace, false => map (fun v => (fst v, (fst v, fst v, fst v))) (indexed (degrees m))
  | VertexFace, true | EdgeFace, true => indexed (faces m)
  | EdgeEdge, _ | EdgeFace, false => edges_from 0
  | VertexEdge, false => vertices 2
  | VertexEdge, true => edges_from (face_edges m)
  | VertexVertex, _ => vertices 0
  end.

Lemma indexed_nth A (l : list A) i x : nth_error l i = Some x -> nth_error (indexed l) i = Some (i, x).
Proof.
  unfold indexed; intros found.
  assert (forall start i, nth_error l i = Some x -> nth_error (combine (seq start (length l)) l) i = Some (start + i, x)) as all.
  { clear; induction l as [|y l IH]; intros start [|i]; simpl; try discriminate.
    - intros [= ->]; rewrite Nat.add_0_r; reflexivity.
    - intros found; rewrite (IH (S start) i found); do 2 f_equal; lia. }
  rewrite (all 0 i found); reflexivity.
Qed.

Lemma nth_skipn A (l : list A) from i x : nth_error l i = Some x -> from <= i -> In x (skipn from l).
Proof.
  revert l i; induction from as [|from IH]; intros l i found less; [apply (nth_error_In _ _ found)|].
  destruct l as [|y l], i as [|i]; try discriminate; [lia|]; simpl; apply (IH l i); [exact found|lia].
Qed.

Definition is_vertex_of (corners : nat * nat * nat) (v : nat) := let '(a, b, c) := corners in In v [a; b; c].

Lemma vertex_primitive m a most d : nth_error (degrees m) a = Some d -> d <= most ->
  In (a, (a, a, a)) (map (fun v => (fst v, (fst v, fst v, fst v))) (filter (fun v => snd v <=? most) (indexed (degrees m)))).
Proof.
  intros found less; apply in_map_iff; exists (a, d); split; [reflexivity|].
  apply filter_In; split; [apply (nth_error_In _ a), indexed_nth, found|apply Nat.leb_le, less].
Qed.

Lemma edge_primitive m i a b from : nth_error (edges m) i = Some (a, b) -> from <= i ->
  In (i, (a, b, b)) (map (fun e => (fst e, (fst (snd e), snd (snd e), snd (snd e)))) (skipn from (indexed (edges m)))).
Proof.
  intros found less; apply in_map_iff; exists (i, (a, b)); split; [reflexivity|].
  apply (nth_skipn _ _ _ i); [apply indexed_nth, found|exact less].
Qed.

Lemma face_primitive m i f : nth_error (faces m) i = Some f -> In (i, f) (indexed (faces m)).
Proof. intros found; apply (nth_error_In _ i), indexed_nth, found. Qed.

Ltac listed :=
  intros ? ?; apply in_seq; simpl in *;
  repeat match goal with H : _ \/ _ |- _ => destruct H | H : False |- _ => destruct H end; subst; lia.

(** Every pair that counts consists of primitives among which the search looks for pairs. *)
Theorem pair_of_primitives m : is_mesh m -> forall k a b p, pair_of m k (a, b) = Some p ->
  fits k p /\ (forall v, In v (first nat p) \/ In v (second nat p) -> In v (seq 0 (vertex_count m)))
  /\ (k = EdgeFace -> has_distance nat p = false)
  /\ (is_one_set k = true -> a < b /\ primitives m k false = primitives m k true)
  /\ exists a_corners b_corners, In (a, a_corners) (primitives m k false) /\ In (b, b_corners) (primitives m k true)
    /\ (forall v, In v (first nat p) -> is_vertex_of a_corners v)
    /\ (forall v, In v (second nat p) -> is_vertex_of b_corners v).
Proof.
  intros (degrees_length & faces_valid & edges_valid) k a b p counted.
  assert (forall v d, nth_error (degrees m) v = Some d -> v < vertex_count m) as counted_vertex
    by (intros v d found; rewrite <- degrees_length; apply nth_error_Some; rewrite found; discriminate).
  assert (forall v, v < vertex_count m -> exists d, nth_error (degrees m) v = Some d) as degree_of.
  { intros v less; destruct (nth_error (degrees m) v) as [d|] eqn:found; [exists d; reflexivity|].
    apply nth_error_None in found; lia. }
  assert (forall i x y, nth_error (edges m) i = Some (x, y) -> x < vertex_count m /\ y < vertex_count m) as edge_vertices
    by (intros i x y found; apply nth_error_In in found; split; apply (edges_valid x y); simpl; auto).
  assert (forall i x y z, nth_error (faces m) i = Some (x, y, z) -> x < vertex_count m /\ y < vertex_count m /\ z < vertex_count m)
    as face_vertices
    by (intros i x y z found; apply nth_error_In in found; split; [|split]; apply (faces_valid x y z); simpl; auto).
  unfold pair_of, edge, face in counted.
  destruct k; simpl in counted;
    repeat match type of counted with
    | context [face_edges m <=? b] => destruct (Nat.leb_spec (face_edges m) b); [|discriminate]
    | context [nth_error (faces m) ?i] => destruct (nth_error (faces m) i) as [((?, ?), ?)|] eqn:?; [|discriminate]
    | context [nth_error (edges m) ?i] => destruct (nth_error (edges m) i) as [(?, ?)|] eqn:?; [|discriminate]
    end; simpl in counted;
    match type of counted with (if ?c then _ else _) = _ => destruct c eqn:holds; [|discriminate] end;
    injection counted as <-; cbn [first second has_distance];
    rewrite ?andb_true_iff in holds; decompose [and] holds; clear holds;
    repeat match goal with H : (_ <? _) = true |- _ => apply Nat.ltb_lt in H end.
  - split; [exact I|split; [|split; [discriminate|split; [discriminate|]]]].
    + destruct (face_vertices b n n0 n1 Heqo) as (? & ? & ?); listed.
    + destruct (degree_of a ltac:(assumption)) as (d & found).
      exists (a, a, a), (n, n0, n1); split; [|split; [apply face_primitive, Heqo|split; simpl; tauto]].
      simpl; apply in_map_iff; exists (a, d); split; [reflexivity|apply (nth_error_In _ a), indexed_nth, found].
  - destruct (edge_vertices a n n0 ltac:(assumption)), (edge_vertices b n1 n2 ltac:(assumption)).
    split; [exact I|split; [listed|split; [discriminate|split]]].
    + intros _; split; [|reflexivity].
      match goal with H : (a <? b) || false = true |- _ => rewrite orb_false_r in H; apply Nat.ltb_lt, H end.
    + exists (n, n0, n0), (n1, n2, n2); split; [|split; [|split; simpl; tauto]];
        apply (edge_primitive m _ _ _ 0); assumption || lia.
  - destruct (edge_vertices b n n0 Heqo).
    split; [exact I|split; [listed|split; [discriminate|split; [discriminate|]]]].
    exists (a, a, a), (n, n0, n0); split; [|split; [apply edge_primitive; assumption|split; simpl; tauto]].
    destruct (nth_error (degrees m) a) as [d|] eqn:found; [|discriminate].
    apply (vertex_primitive m a 2 d found).
    match goal with H : (d =? _) = true |- _ => apply Nat.eqb_eq in H end.
    destruct (has_edge m a n), (has_edge m a n0); simpl in *; lia.
  - destruct (nth_error (degrees m) a) as [d|] eqn:a_found; [|discriminate].
    destruct (nth_error (degrees m) b) as [o|] eqn:b_found; [|discriminate].
    pose proof (counted_vertex b o b_found).
    repeat match goal with H : (_ =? 0) = true |- _ => apply Nat.eqb_eq in H end.
    split; [exact I|split; [listed|split; [discriminate|split]]].
    + intros _; split; [|reflexivity].
      match goal with H : (a <? b) || false = true |- _ => rewrite orb_false_r in H; apply Nat.ltb_lt, H end.
    + exists (a, a, a), (b, b, b); split; [|split; [|split; simpl; tauto]].
      * apply (vertex_primitive m a 0 d a_found); lia.
      * apply (vertex_primitive m b 0 o b_found); lia.
  - match goal with e : nth_error (edges m) a = Some (?x, ?y), f : nth_error (faces m) b = Some (?u, ?v, ?w) |- _ =>
      destruct (edge_vertices a x y e), (face_vertices b u v w f) as (? & ? & ?);
      split; [exact I|split; [listed|split; [reflexivity|split; [discriminate|]]]];
      exists (x, y, y), (u, v, w); split; [|split; [|split; simpl; tauto]];
      [apply (edge_primitive m _ _ _ 0); assumption || lia|apply face_primitive, f] end.
Qed.

(** An edge and a face are a pair that counts, or have a common vertex. *)
Theorem edge_and_face m : is_mesh m -> forall a b xs ys, edge m a = Some xs -> face m b = Some ys ->
  pair_of m EdgeFace (a, b) = Some {| first := xs; second := ys; has_distance := false |} \/ exists x, In x xs /\ In x ys.
Proof.
  intros (_ & _ & edges_valid) a b xs ys a_is b_is.
  destruct (existsb (fun x => existsb (Nat.eqb x) ys) xs) eqn:common.
  - right; apply existsb_exists in common as (x & in_edge & in_face).
    apply existsb_exists in in_face as (y & in_face & equal); apply Nat.eqb_eq in equal; subst y; exists x; auto.
  - left; unfold pair_of; rewrite a_is, b_is.
    replace (forallb _ xs) with true; [simpl; rewrite orb_true_r; reflexivity|symmetry].
    apply forallb_forall; intros x here; apply andb_true_intro; split.
    + apply negb_true_iff; destruct (existsb (Nat.eqb x) ys) eqn:in_face; [|reflexivity].
      rewrite <- common; symmetry; apply existsb_exists; exists x; auto.
    + apply Nat.ltb_lt; unfold edge in a_is; destruct (nth_error (edges m) a) as [(u, w)|] eqn:found; [|discriminate].
      injection a_is as <-; apply (edges_valid u w x (nth_error_In _ _ found)), here.
Qed.
