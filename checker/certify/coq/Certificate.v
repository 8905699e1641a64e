(* SPDX-License-Identifier: Apache-2.0 *)
(* Defines the checks and proves their soundness. All data of a certificate are variables here: the theorems hold for
   all functions. So the files, the packing, the hash tables and the search need not be trusted. *)
From Coq Require Import List Bool ZArith Lia Uint63.
From Certify Require Import Claims Loops.
Import ListNotations.
Open Scope uint63_scope.

Definition memb (a : ev) (A : list ev) : bool := existsb (fun b => a =? b) A.
Lemma memb_in : forall a A, memb a A = true -> In a A.
Proof.
  intros a A H. apply existsb_exists in H. destruct H as (b & Hb & E). apply eqb_true in E. subst. exact Hb.
Qed.

Definition offers {S : Type} (moves : list (ev * S)) (a : ev) : bool := existsb (fun m => fst m =? a) moves.
Lemma offers_can : forall S (P : lts S) s a, offers (succ P s) a = true <-> can P s a.
Proof.
  intros S P s a. unfold offers, can, step. rewrite existsb_exists. split.
  - intros ([b u] & H & E). cbn in E. apply eqb_true in E. subst. exists u. exact H.
  - intros (u & H). exists (a, u). split; [ exact H | apply eqb_refl ].
Qed.

(* The normal form of the specification: after each trace, the specification is in a node. `where_is n a` is an index at
   which the arc of a may be found. *)
Record normal_form := {
  nodes : int;
  root : int;
  arc_count : int -> int;
  arc : int -> int -> ev * int;
  where_is : int -> ev -> int;
  acceptance_count : int -> int;
  acceptance : int -> int -> list ev;
  divergent : int -> bool }.

Definition after (N : normal_form) (n : int) (a : ev) : option int :=
  let i := where_is N n a in
  if i <? arc_count N n then let (b, k) := arc N n i in if b =? a then Some k else None else None.

Lemma after_arc : forall N n a m, after N n a = Some m -> exists i, (i <? arc_count N n) = true /\ arc N n i = (a, m).
Proof.
  unfold after. intros N n a m H. destruct (where_is N n a <? arc_count N n) eqn:L; [| discriminate].
  destruct (arc N n (where_is N n a)) as [b k] eqn:A. destruct (b =? a) eqn:E; [| discriminate].
  apply eqb_true in E. inversion H. subst. eauto.
Qed.

Inductive nrun (N : normal_form) : int -> list ev -> int -> Prop :=
| nrun_nil : forall n, nrun N n [] n
| nrun_step : forall n a m t k, a <> tau -> after N n a = Some m -> nrun N m t k -> nrun N n (a :: t) k.

(* Why a member of a node is reached. Either an event from a member of the previous node leads to it (or it is the
   initial state), or a tau leads to it from another member of the node with a smaller depth. *)
Record origin := { by_event : bool; from : int; depth : int }.

(* The evidence that the normal form has no more behaviour than the specification. *)
Record evidence (S : Type) := {
  size : int -> int;                        (* by node: the number of members *)
  member : int -> int -> S;                 (* states of the specification *)
  origin_in_root : int -> origin;
  origin_after : int -> int -> int -> origin;  (* by node, arc, member of the arc's target *)
  witness : int -> int -> int;              (* by node, acceptance: a member that accepts no more *)
  loop_size : int;
  loop : int -> S;                          (* states, each with a tau to another of them *)
  loop_next : int -> int;
  diverging_member : int -> int;            (* by divergent node *)
  loop_entry : int -> int }.
Arguments size {S}. Arguments member {S}. Arguments origin_in_root {S}. Arguments origin_after {S}.
Arguments witness {S}. Arguments loop_size {S}. Arguments loop {S}. Arguments loop_next {S}.
Arguments diverging_member {S}. Arguments loop_entry {S}.

(** 1. The normal form has no more behaviour than the specification. *)
Section Specification.
  Context {S : Type}.
  Variable spec : lts S.
  Variable eqs : S -> S -> bool.
  Hypothesis eqs_ok : forall x y, eqs x y = true -> x = y.
  Variable N : normal_form.
  Variable E : evidence S.

  Definition steps_to (s : S) (a : ev) (u : S) : bool :=
    existsb (fun m : ev * S => if fst m =? a then eqs (snd m) u else false) (succ spec s).
  Lemma steps_to_step : forall s a u, steps_to s a u = true -> step spec s a u.
  Proof.
    unfold steps_to, step. intros s a u H. apply existsb_exists in H. destruct H as ([b v] & H & K). cbn in K.
    destruct (b =? a) eqn:B; [| discriminate]. apply eqb_true in B. apply eqs_ok in K. subst. exact H.
  Qed.

  Definition derived (seed : int -> S -> bool) (source : int -> origin) (k : int) : bool :=
    all_below (fun j =>
      let o := source j in
      if by_event o then seed (from o) (member E k j)
      else if from o <? size E k then
             if depth (source (from o)) <? depth o then steps_to (member E k (from o)) tau (member E k j) else false
           else false) (size E k).
  Lemma derived_sound : forall (Q : S -> Prop) seed source k,
    (forall s u, Q s -> step spec s tau u -> Q u) -> (forall f s, seed f s = true -> Q s) ->
    derived seed source k = true -> forall j, (j <? size E k) = true -> Q (member E k j).
  Proof.
    intros Q seed source k HQ Hs H.
    assert (G : forall z j, (to_Z (depth (source j)) < Z.of_nat z)%Z -> (j <? size E k) = true -> Q (member E k j)).
    { induction z as [| z IH]; intros j Hz Hj; [ pose proof (to_Z_bounded (depth (source j))); lia |].
      pose proof (all_below_spec _ _ H j Hj) as C. cbn beta zeta in C.
      destruct (by_event (source j)); [ exact (Hs _ _ C) |].
      destruct (from (source j) <? size E k) eqn:F; [| discriminate].
      destruct (depth (source (from (source j))) <? depth (source j)) eqn:D; [| discriminate].
      apply ltb_spec in D. apply (HQ (member E k (from (source j)))); [| apply steps_to_step; exact C ].
      apply IH; [ lia | exact F ]. }
    intros j Hj. pose proof (to_Z_bounded (depth (source j))).
    apply (G (Datatypes.S (Z.to_nat (to_Z (depth (source j)))))); [ lia | exact Hj ].
  Qed.

  (* The state accepts only events that are in A. *)
  Definition accepts (A : list ev) (s : S) : bool :=
    let moves := succ spec s in
    if offers moves tick then memb tick A
    else negb (offers moves tau) && forallb (fun m => memb (fst m) A) moves.
  Definition check_arc (n i : int) : bool :=
    let (a, k) := arc N n i in
    if a =? tau then false
    else if k <? nodes N then
           derived (fun f u => if f <? size E n then steps_to (member E n f) a u else false) (origin_after E n i) k
         else false.
  Definition check_acceptance (n i : int) : bool :=
    let j := witness E n i in
    if j <? size E n then accepts (acceptance N n i) (member E n j) else false.
  Definition check_divergence (n : int) : bool :=
    if divergent N n then
      if diverging_member E n <? size E n then
        if loop_entry E n <? loop_size E then eqs (member E n (diverging_member E n)) (loop E (loop_entry E n)) else false
      else false
    else true.
  Definition check_node (m : model) (n : int) : bool :=
    (0 <? size E n) && all_below (check_arc n) (arc_count N n) &&
    (match m with T => true | _ => all_below (check_acceptance n) (acceptance_count N n) end) &&
    (match m with FD => check_divergence n | _ => true end).
  Definition check_root : bool :=
    (root N <? nodes N) && derived (fun _ u => eqs (init spec) u) (origin_in_root E) (root N).
  Definition check_loop : bool :=
    all_below (fun j => if loop_next E j <? loop_size E then steps_to (loop E j) tau (loop E (loop_next E j)) else false)
      (loop_size E).
  Definition check_specification (m : model) : bool :=
    check_root && check_loop && all_below (check_node m) (nodes N).

  Lemma reach_app_tau : forall s t u v, reach spec s t u -> step spec u tau v -> reach spec s t v.
  Proof.
    induction 1; intros Hs.
    - apply (reach_tau spec s v []); [ exact Hs | constructor ].
    - apply (reach_tau spec s u); auto.
    - apply (reach_vis spec s a u); auto.
  Qed.
  Lemma reach_app : forall s t u, reach spec s t u -> forall t' v, reach spec u t' v -> reach spec s (t ++ t') v.
  Proof.
    induction 1; intros t' w Hw; cbn; [ exact Hw | apply (reach_tau spec s u); auto | apply (reach_vis spec s a u); auto ].
  Qed.

  Lemma loop_diverges : check_loop = true -> forall j, (j <? loop_size E) = true -> diverges spec (loop E j).
  Proof.
    intros H. cofix self. intros j Hj. pose proof (all_below_spec _ _ H j Hj) as C. cbn beta in C.
    destruct (loop_next E j <? loop_size E) eqn:K; [| discriminate].
    apply (diverges_step spec (loop E j) (loop E (loop_next E j))); [ apply steps_to_step; exact C | apply self; exact K ].
  Qed.

  Variable m : model.
  Hypothesis checked : check_specification m = true.

  Lemma node_checked : forall n, (n <? nodes N) = true -> check_node m n = true.
  Proof.
    unfold check_specification in checked. rewrite !andb_true_iff in checked. apply all_below_spec. apply checked.
  Qed.

  Definition all_members (n : int) (Q : S -> Prop) : Prop := forall j, (j <? size E n) = true -> Q (member E n j).

  Lemma node_reached : forall n t k, nrun N n t k -> (n <? nodes N) = true -> forall t0,
    all_members n (reach spec (init spec) t0) ->
    (k <? nodes N) = true /\ all_members k (reach spec (init spec) (t0 ++ t)).
  Proof.
    induction 1 as [n | n a k t k2 Ha Hk Hr IH]; intros Hn t0 Ht.
    - rewrite app_nil_r. auto.
    - apply after_arc in Hk. destruct Hk as (i & Hi & Hk). pose proof (node_checked n Hn) as C. unfold check_node in C.
      rewrite !andb_true_iff in C. destruct C as [[[_ C] _] _].
      pose proof (all_below_spec _ _ C i Hi) as C1. unfold check_arc in C1. rewrite Hk in C1.
      destruct (a =? tau) eqn:Ea; [ discriminate |]. destruct (k <? nodes N) eqn:Hkn; [| discriminate].
      replace (t0 ++ a :: t) with ((t0 ++ [a]) ++ t) by (rewrite <- app_assoc; reflexivity).
      apply IH; [ reflexivity |]. intros j Hj.
      apply (derived_sound (reach spec (init spec) (t0 ++ [a])) _ _ _) with (3 := C1); [| | exact Hj ].
      + intros x y Hx Hy. exact (reach_app_tau _ _ _ _ Hx Hy).
      + intros f s Hs. destruct (f <? size E n) eqn:F; [| discriminate]. apply steps_to_step in Hs.
        apply (reach_app _ t0 (member E n f)); [ apply Ht; exact F |].
        apply (reach_vis spec (member E n f) a s); [ exact Ha | exact Hs | constructor ].
  Qed.

  Lemma root_ok : (root N <? nodes N) = true /\ all_members (root N) (reach spec (init spec) []).
  Proof.
    unfold check_specification, check_root in checked. rewrite !andb_true_iff in checked.
    destruct checked as [[[Hr Hm] _] _]. split; [ exact Hr |]. intros j Hj.
    apply (derived_sound (reach spec (init spec) []) _ _ _) with (3 := Hm); [| | exact Hj ].
    - intros x y Hx Hy. exact (reach_app_tau _ _ _ _ Hx Hy).
    - intros _ s Hs. apply eqs_ok in Hs. subst. constructor.
  Qed.

  (* Arcs lead to nodes. *)
  Lemma arc_node : forall n a k, (n <? nodes N) = true -> after N n a = Some k -> (k <? nodes N) = true.
  Proof.
    intros n a k Hn H. apply after_arc in H. destruct H as (i & Hi & Ai). pose proof (node_checked n Hn) as C. unfold check_node in C.
    rewrite !andb_true_iff in C. destruct C as [[[_ C] _] _]. pose proof (all_below_spec _ _ C i Hi) as K. unfold check_arc in K.
    rewrite Ai in K. destruct (a =? tau); [ discriminate |]. destruct (k <? nodes N); [ reflexivity | discriminate ].
  Qed.

  Lemma run_ok : forall t n, nrun N (root N) t n ->
    (n <? nodes N) = true /\ all_members n (reach spec (init spec) t).
  Proof. intros t n H. destruct root_ok as [Hr Hm]. exact (node_reached _ _ _ H Hr [] Hm). Qed.

  Lemma run_trace : forall t n, nrun N (root N) t n -> traces spec t.
  Proof.
    intros t n H. destruct (run_ok t n H) as [Hn Hm]. pose proof (node_checked n Hn) as C.
    unfold check_node in C. rewrite !andb_true_iff in C. destruct C as [[[C _] _] _].
    exists (member E n 0). apply Hm. exact C.
  Qed.

  Lemma run_failure : forall t n i (X : ev -> Prop), m <> T -> nrun N (root N) t n ->
    (i <? acceptance_count N n) = true -> (forall a, In a (acceptance N n i) -> ~ X a) -> failures spec t X.
  Proof.
    intros t n i X Hm0 H Hi HX. destruct (run_ok t n H) as [Hn Hm]. pose proof (node_checked n Hn) as C.
    unfold check_node in C. rewrite !andb_true_iff in C. destruct C as [[_ C] _].
    assert (C' : all_below (check_acceptance n) (acceptance_count N n) = true)
      by (destruct m; [ congruence | exact C | exact C ]).
    pose proof (all_below_spec _ _ C' i Hi) as Ac. unfold check_acceptance in Ac.
    destruct (witness E n i <? size E n) eqn:W; [| discriminate].
    exists (member E n (witness E n i)). split; [ apply Hm; exact W |]. unfold accepts in Ac.
    destruct (offers (succ spec (member E n (witness E n i))) tick) eqn:Ot.
    - left. split; [ apply offers_can; exact Ot | apply HX, memb_in; exact Ac ].
    - right. apply andb_true_iff in Ac. destruct Ac as [Au Ac]. apply negb_true_iff in Au.
      rewrite forallb_forall in Ac. repeat split.
      + intros K. apply offers_can in K. congruence.
      + intros K. apply offers_can in K. congruence.
      + intros a Xa (u & Hu). specialize (Ac (a, u) Hu). apply memb_in in Ac. exact (HX a Ac Xa).
  Qed.

  Lemma run_divergence : forall t t2 n, m = FD -> nrun N (root N) t n -> divergent N n = true ->
    divergences spec (t ++ t2).
  Proof.
    intros t t2 n Em H Hd. destruct (run_ok t n H) as [Hn Hm]. pose proof (node_checked n Hn) as C.
    unfold check_node in C. rewrite !andb_true_iff in C. destruct C as [_ C]. rewrite Em in C.
    unfold check_divergence in C. rewrite Hd in C.
    destruct (diverging_member E n <? size E n) eqn:D; [| discriminate].
    destruct (loop_entry E n <? loop_size E) eqn:L; [| discriminate]. apply eqs_ok in C.
    exists t, t2, (member E n (diverging_member E n)). split; [ reflexivity |]. split; [ apply Hm; exact D |].
    rewrite C. unfold check_specification in checked. rewrite !andb_true_iff in checked.
    apply loop_diverges; [ apply checked | exact L ].
  Qed.
End Specification.

(* The pairs of a state of the implementation and a node. The check visits them one after the other: `place_of` is the
   time at which a pair is visited, and `pair_at` is the pair that is visited at a time. `locate` is the number at which
   a pair may be found, and `choose` is an acceptance of a node that may be offered. `deed` is the next action, given
   the time and the open pairs. *)
Inductive action := Open (j : int) | Visit | Stop.
Record pairs (S : Type) := {
  state_of : int -> S;
  node_of : int -> int;
  place_of : int -> int;
  pair_at : int -> int;
  locate : S -> int -> int;
  choose : int -> list (ev * S) -> int;
  deed : int -> list (int * list (ev * S)) -> action }.
Arguments state_of {S}. Arguments node_of {S}. Arguments place_of {S}. Arguments pair_at {S}.
Arguments locate {S}. Arguments choose {S}. Arguments deed {S}.

(* What an event of the implementation requires. It must not occur; or its target does not matter; or it must lead to a
   pair with this node, and this pair must have been visited earlier if `earlier` is true. *)
Inductive need := Forbidden | Irrelevant | Leads (node : int) (earlier : bool).

(** 2. A walk through the pairs. It computes the moves of each pair once: while the pair is open. *)
Section Walk.
  Context {S : Type}.
  Variable impl : lts S.
  Variable eqi : S -> S -> bool.
  Hypothesis eqi_ok : forall x y, eqi x y = true -> x = y.
  Variable P : pairs S.
  Variable needs : int -> ev -> need.
  Variable fine : int -> list (ev * S) -> bool.
  Variable first_node : int.

  (* Returns a bound that is larger than all pairs located so far; `high` is the previous bound. *)
  Definition cover (u : S) (k : int) (bound : option int) (high : int) : option int :=
    let j := locate P u k in
    if node_of P j =? k then
      if eqi (state_of P j) u then
        if (match bound with Some b => place_of P j <? b | None => true end) then
          if j <? high then Some high else if j <? j + 1 then Some (j + 1) else None
        else None
      else None
    else None.
  Fixpoint check_moves (n p : int) (moves : list (ev * S)) (high : int) : option int :=
    match moves with
    | [] => Some high
    | (a, u) :: rest =>
        match needs n a with
        | Forbidden => None
        | Irrelevant => check_moves n p rest high
        | Leads k earlier =>
            match cover u k (if earlier then Some p else None) high with
            | Some h => check_moves n p rest h
            | None => None
            end
        end
    end.
  Definition check_pair (j p : int) (moves : list (ev * S)) (high : int) : option int :=
    if place_of P j =? p then
      if pair_at P p =? j then
        if fine (node_of P j) moves then check_moves (node_of P j) p moves high else None
      else None
    else None.

  Record progress := { time : int; opened : list (int * list (ev * S)); visited : int; high : int }.
  Inductive outcome := More (x : progress) | Over (x : option progress).
  Definition proceed (x : progress) : outcome :=
    match deed P (time x) (opened x) with
    | Open j => More {| time := time x + 1; opened := (j, succ impl (state_of P j)) :: opened x;
                        visited := visited x; high := high x |}
    | Visit =>
        match opened x with
        | [] => Over None
        | (j, moves) :: rest =>
            match check_pair j (visited x) moves (high x) with
            | Some h =>
                if visited x <? visited x + 1 then
                  More {| time := time x + 1; opened := rest; visited := visited x + 1; high := h |}
                else Over None
            | None => Over None
            end
        end
    | Stop => Over (Some x)
    end.
  (* Performs 2 ^ (length fuel) actions. *)
  Fixpoint proceed_often (fuel : list int) (x : progress) : outcome :=
    match fuel with
    | [] => proceed x
    | _ :: rest => match proceed_often rest x with More y => proceed_often rest y | Over r => Over r end
    end.
  Definition all_visited (x : progress) : bool :=
    all_below (fun j => if place_of P j <? visited x then pair_at P (place_of P j) =? j else false) (high x).
  Definition walk : bool :=
    match cover (init impl) first_node None 0 with
    | None => false
    | Some h =>
        match proceed_often many_widths {| time := 0; opened := []; visited := 0; high := h |} with
        | Over (Some x) => all_visited x
        | _ => false
        end
    end.

  Definition below (i h : int) : Prop := (to_Z i < to_Z h)%Z.
  Definition is_pair (h : int) (u : S) (k r : int) : Prop :=
    exists j, below j h /\ state_of P j = u /\ node_of P j = k /\ place_of P j = r.
  Definition met (h n r : int) (mv : ev * S) : Prop :=
    match needs n (fst mv) with
    | Forbidden => False
    | Irrelevant => True
    | Leads k earlier => exists q, is_pair h (snd mv) k q /\ (earlier = true -> (q <? r) = true)
    end.
  Definition good_pair (h s_pair : int) : Prop :=
    fine (node_of P s_pair) (succ impl (state_of P s_pair)) = true /\
    forall mv, In mv (succ impl (state_of P s_pair)) -> met h (node_of P s_pair) (place_of P s_pair) mv.

  Lemma is_pair_more : forall h h' u k r, (to_Z h <= to_Z h')%Z -> is_pair h u k r -> is_pair h' u k r.
  Proof. intros h h' u k r H (j & B & E). exists j. unfold below in *. split; [ lia | exact E ]. Qed.
  Lemma met_more : forall h h' n r mv, (to_Z h <= to_Z h')%Z -> met h n r mv -> met h' n r mv.
  Proof.
    unfold met. intros h h' n r mv H M. destruct (needs n (fst mv)) as [| | k earlier]; auto.
    destruct M as (q & Q & L). exists q. split; [ exact (is_pair_more h h' _ _ _ H Q) | exact L ].
  Qed.
  Lemma good_pair_more : forall h h' j, (to_Z h <= to_Z h')%Z -> good_pair h j -> good_pair h' j.
  Proof. intros h h' j H [F M]. split; [ exact F |]. intros mv I. exact (met_more h h' _ _ _ H (M mv I)). Qed.

  Lemma cover_sound : forall u k b h h', cover u k b h = Some h' -> (to_Z h <= to_Z h')%Z /\
    exists r, is_pair h' u k r /\ match b with Some p => (r <? p) = true | None => True end.
  Proof.
    unfold cover. intros u k b h h' H. cbn zeta in H. remember (locate P u k) as j eqn:Ej. clear Ej.
    destruct (node_of P j =? k) eqn:Ek; [| discriminate]. apply eqb_true in Ek.
    destruct (eqi (state_of P j) u) eqn:Eu; [| discriminate]. apply eqi_ok in Eu.
    destruct (match b with Some b => _ | None => _ end) eqn:W; [| discriminate].
    assert (K : (to_Z h <= to_Z h')%Z /\ below j h').
    { unfold below. destruct (j <? h) eqn:L.
      - injection H as H. rewrite <- H. apply ltb_spec in L. lia.
      - destruct (j <? j + 1) eqn:O; [| discriminate]. injection H as H. rewrite <- H. apply ltb_spec in O.
        apply not_true_iff_false in L. rewrite ltb_spec in L. lia. }
    destruct K as [K B]. split; [ exact K |]. exists (place_of P j). split.
    - exists j. auto.
    - destruct b; [ exact W | exact I ].
  Qed.
  Lemma check_moves_sound : forall n p moves h h', check_moves n p moves h = Some h' ->
    (to_Z h <= to_Z h')%Z /\ forall mv, In mv moves -> met h' n p mv.
  Proof.
    induction moves as [| [a u] moves IH]; intros h h' H; cbn in H.
    - inversion H. subst. split; [ lia | intros mv [] ].
    - destruct (needs n a) as [| | k earlier] eqn:Ea; [ discriminate | |].
      + destruct (IH h h' H) as [L M]. split; [ exact L |]. intros mv [E | I']; [| exact (M mv I') ].
        subst. unfold met. cbn [fst]. rewrite Ea. exact I.
      + destruct (cover u k _ h) as [h1 |] eqn:C; [| discriminate]. apply cover_sound in C.
        destruct C as (L1 & r & Q & B). destruct (IH h1 h' H) as [L M]. split; [ lia |].
        intros mv [E | I']; [| exact (M mv I') ]. subst. unfold met. cbn [fst snd]. rewrite Ea.
        exists r. split; [ exact (is_pair_more h1 h' _ _ _ L Q) |]. intros E. rewrite E in B. exact B.
  Qed.

  Definition sound_progress (x : progress) : Prop :=
    (forall j moves, In (j, moves) (opened x) -> moves = succ impl (state_of P j)) /\
    forall q, below q (visited x) -> place_of P (pair_at P q) = q /\ good_pair (high x) (pair_at P q).
  Lemma proceed_sound : forall x, sound_progress x ->
    match proceed x with
    | More y => sound_progress y /\ (to_Z (high x) <= to_Z (high y))%Z
    | Over (Some y) => sound_progress y /\ (to_Z (high x) <= to_Z (high y))%Z
    | Over None => True
    end.
  Proof.
    intros x [HO HV]. unfold proceed. destruct (deed P (time x) (opened x)) as [j | |].
    - split; [| cbn; lia ]. split; [| exact HV ]. cbn [opened]. intros i moves [E | I']; [ inversion E; auto | auto ].
    - destruct (opened x) as [| [j moves] rest] eqn:EO; [ exact I |].
      destruct (check_pair j (visited x) moves (high x)) as [h |] eqn:C; [| exact I ].
      destruct (visited x <? visited x + 1) eqn:O; [| exact I ].
      assert (EM : moves = succ impl (state_of P j)) by (apply HO; left; reflexivity).
      unfold check_pair in C. destruct (place_of P j =? visited x) eqn:E1; [| discriminate]. apply eqb_true in E1.
      destruct (pair_at P (visited x) =? j) eqn:E2; [| discriminate]. apply eqb_true in E2.
      destruct (fine (node_of P j) moves) eqn:E3; [| discriminate].
      destruct (check_moves_sound _ _ _ _ _ C) as [L M].
      split; [| exact L ]. split; cbn [opened visited high].
      + intros i ms I'. apply HO. right. exact I'.
      + intros q Hq. unfold below in Hq. apply ltb_spec in O.
        assert (EV : to_Z (visited x + 1) = (to_Z (visited x) + 1)%Z).
        { rewrite add_spec in *. change (to_Z 1) with 1%Z in *. pose proof (to_Z_bounded (visited x)).
          destruct (Z_lt_dec (to_Z (visited x) + 1) wB); [ apply Z.mod_small; lia |].
          exfalso. replace (to_Z (visited x) + 1)%Z with wB in O by lia. rewrite Z_mod_same_full in O. lia. }
        destruct (Z.eq_dec (to_Z q) (to_Z (visited x))) as [E | NE].
        * apply to_Z_inj in E. subst q. rewrite E2. split; [ exact E1 |]. split.
          -- rewrite <- EM. exact E3.
          -- rewrite <- EM, E1. exact M.
        * destruct (HV q) as [V1 V2]; [ unfold below; lia |]. split; [ exact V1 |].
          exact (good_pair_more _ _ _ L V2).
    - split; [ split; assumption | lia ].
  Qed.
  Lemma proceed_often_sound : forall fuel x, sound_progress x ->
    match proceed_often fuel x with
    | More y => sound_progress y /\ (to_Z (high x) <= to_Z (high y))%Z
    | Over (Some y) => sound_progress y /\ (to_Z (high x) <= to_Z (high y))%Z
    | Over None => True
    end.
  Proof.
    induction fuel as [| w fuel IH]; intros x H; cbn [proceed_often]; [ exact (proceed_sound x H) |].
    pose proof (IH x H) as H1. destruct (proceed_often fuel x) as [y | [y |]]; auto. destruct H1 as [H1 L1].
    pose proof (IH y H1) as H2. destruct (proceed_often fuel y) as [z | [z |]]; auto; destruct H2; split; auto; lia.
  Qed.

  Theorem walk_sound : walk = true -> exists Q : S -> int -> int -> Prop,
    (exists r, Q (init impl) first_node r) /\
    forall s n r, Q s n r -> fine n (succ impl s) = true /\
      forall a u, step impl s a u ->
        match needs n a with
        | Forbidden => False
        | Irrelevant => True
        | Leads k earlier => exists q, Q u k q /\ (earlier = true -> (q <? r) = true)
        end.
  Proof.
    unfold walk. intros H. destruct (cover (init impl) first_node None 0) as [h |] eqn:C; [| discriminate].
    apply cover_sound in C. destruct C as (_ & r0 & Q0 & _).
    set (x0 := {| time := 0; opened := []; visited := 0; high := h |}) in H.
    assert (S0 : sound_progress x0).
    { split; cbn; [ intros j moves [] |]. intros q K. unfold below in K. change (to_Z 0) with 0%Z in K.
      pose proof (to_Z_bounded q). lia. }
    pose proof (proceed_often_sound many_widths x0 S0) as W.
    destruct (proceed_often many_widths x0) as [y | [x |]]; try discriminate. destruct W as [[_ HV] L].
    exists (is_pair (high x)). split; [ exists r0; exact (is_pair_more _ _ _ _ _ L Q0) |].
    intros s n r (j & B & Es & En & Er). unfold all_visited in H.
    assert (A := all_below_spec _ _ H j ltac:(apply ltb_spec; exact B)). cbn beta in A.
    destruct (place_of P j <? visited x) eqn:V; [| discriminate]. apply ltb_spec in V. apply eqb_true in A.
    destruct (HV (place_of P j) V) as [_ [F M]]. rewrite A in F, M. rewrite Es, En in F. split; [ exact F |].
    intros a u St. rewrite Es, En, Er in M. exact (M (a, u) St).
  Qed.
End Walk.

(* Whether the check ends in this node, because the specification diverges in it. *)
Definition stop (N : normal_form) (m : model) (n : int) : bool := match m with FD => divergent N n | _ => false end.

(* The state offers all events of an acceptance of the node. If it can terminate, an acceptance contains no other event. *)
Definition offers_acceptance {S} (N : normal_form) (P : lts S) (s : S) (n : int) : Prop :=
  (can P s tick -> exists i, (i <? acceptance_count N n) = true /\ forall a, In a (acceptance N n i) -> a = tick) /\
  (~ can P s tau -> ~ can P s tick ->
    exists i, (i <? acceptance_count N n) = true /\ forall a, In a (acceptance N n i) -> can P s a).

(* The process has no more behaviour than the normal form. *)
Definition within {S} (m : model) (N : normal_form) (P : lts S) : Prop :=
  forall t u, reach P (init P) t u ->
    (exists n, nrun N (root N) t n /\ (m <> T -> offers_acceptance N P u n) /\ (m = FD -> ~ diverges P u)) \/
    (exists t1 t2 n, t = t1 ++ t2 /\ nrun N (root N) t1 n /\ stop N m n = true).

(** 3. The implementation has no more behaviour than the normal form. *)
Section Implementation.
  Context {S : Type}.
  Variable impl : lts S.
  Variable eqi : S -> S -> bool.
  Hypothesis eqi_ok : forall x y, eqi x y = true -> x = y.
  Variable N : normal_form.
  Variable m : model.
  Variable P : pairs S.

  Definition ranked : bool := match m with FD => true | _ => false end.

  (* The moves offer some acceptance of the node. *)
  Definition refusals_ok (n : int) (moves : list (ev * S)) : bool :=
    let fits (offered : ev -> bool) :=
      let i := choose P n moves in
      if i <? acceptance_count N n then forallb offered (acceptance N n i) else false in
    if offers moves tick then fits (fun a => a =? tick)
    else if offers moves tau then true
    else fits (offers moves).
  Definition refusals (n : int) (moves : list (ev * S)) : bool :=
    match m with T => true | _ => refusals_ok n moves end.
  Definition event_needs (n : int) (a : ev) : need :=
    if a =? tau then Leads n ranked
    else match after N n a with
         | None => Forbidden
         | Some k => if stop N m k then Irrelevant else Leads k false
         end.
  Definition check_implementation : bool :=
    if stop N m (root N) then true else walk impl eqi P event_needs refusals (root N).

  Hypothesis checked : check_implementation = true.
  Hypothesis live : stop N m (root N) = false.

  Definition covering (Q : S -> int -> int -> Prop) : Prop :=
    (exists r, Q (init impl) (root N) r) /\
    forall s n r, Q s n r -> refusals n (succ impl s) = true /\
      forall a u, step impl s a u ->
        match event_needs n a with
        | Forbidden => False
        | Irrelevant => True
        | Leads k earlier => exists q, Q u k q /\ (earlier = true -> (q <? r) = true)
        end.
  Lemma covering_exists : exists Q, covering Q.
  Proof.
    unfold check_implementation in checked. rewrite live in checked. apply walk_sound in checked; [| exact eqi_ok ].
    exact checked.
  Qed.

  Variable Q : S -> int -> int -> Prop.
  Hypothesis covers : covering Q.

  Definition inv (s : S) (n : int) : Prop := stop N m n = false /\ exists r, Q s n r.

  Lemma inv_step : forall s n a u, inv s n -> step impl s a u ->
    (a = tau /\ inv u n) \/
    (a <> tau /\ exists k, after N n a = Some k /\ (stop N m k = true \/ inv u k)).
  Proof.
    intros s n a u (Hs & r & Hp) Hst. destruct covers as [_ C]. destruct (C s n r Hp) as [_ M].
    specialize (M a u Hst). unfold event_needs in M. destruct (a =? tau) eqn:Ea.
    - left. split; [ apply eqb_true; exact Ea |]. destruct M as (q & Hq & _). split; [ exact Hs | eauto ].
    - right. split; [ apply eqb_false_neq; exact Ea |].
      destruct (after N n a) as [k |]; [| destruct M ]. exists k. split; [ reflexivity |].
      destruct (stop N m k) eqn:Hk; [ left; reflexivity | right ].
      destruct M as (q & Hq & _). split; [ exact Hk | eauto ].
  Qed.

  Lemma inv_reach : forall s t u, reach impl s t u -> forall n, inv s n ->
    (exists k, nrun N n t k /\ inv u k) \/
    (exists t1 t2 k, t = t1 ++ t2 /\ nrun N n t1 k /\ stop N m k = true).
  Proof.
    induction 1 as [s | s u t v Hst Hr IH | s a u t v Ha Hst Hr IH]; intros n Hn.
    - left. exists n. split; [ constructor | exact Hn ].
    - destruct (inv_step _ _ _ _ Hn Hst) as [[_ Hu] | [K _]]; [| congruence]. exact (IH n Hu).
    - destruct (inv_step _ _ _ _ Hn Hst) as [[K _] | (_ & k & Hk & [Hs | Hu])]; [ congruence | |].
      + right. exists [a], t, k. split; [ reflexivity |]. split; [| exact Hs ].
        apply (nrun_step N n a k); [ exact Ha | exact Hk | constructor ].
      + destruct (IH k Hu) as [(k2 & R & I2) | (t1 & t2 & k2 & E & R & S2)].
        * left. exists k2. split; [| exact I2 ]. apply (nrun_step N n a k); assumption.
        * right. exists (a :: t1), t2, k2. subst. split; [ reflexivity |]. split; [| exact S2 ].
          apply (nrun_step N n a k); assumption.
  Qed.

  Lemma inv_offers : forall s n, m <> T -> inv s n -> offers_acceptance N impl s n.
  Proof.
    intros s n Hm (Hs & r & Hp). destruct covers as [_ K0]. destruct (K0 s n r Hp) as [C0 _].
    assert (C : refusals_ok n (succ impl s) = true) by (unfold refusals in C0; destruct m; [ congruence | exact C0 | exact C0 ]).
    unfold refusals_ok in C. cbn zeta in C. set (i := choose P n (succ impl s)) in C. split.
    - intros Ct. apply offers_can in Ct. rewrite Ct in C.
      destruct (i <? acceptance_count N n) eqn:Hi; [| discriminate]. rewrite forallb_forall in C.
      exists i. split; [ exact Hi |]. intros a Ha. apply eqb_true. exact (C a Ha).
    - intros Nu Nt. destruct (offers (succ impl s) tick) eqn:Ot; [ apply offers_can in Ot; contradiction |].
      destruct (offers (succ impl s) tau) eqn:Ou; [ apply offers_can in Ou; contradiction |].
      destruct (i <? acceptance_count N n) eqn:Hi; [| discriminate]. rewrite forallb_forall in C.
      exists i. split; [ exact Hi |]. intros a Ha. apply offers_can. exact (C a Ha).
  Qed.

  Lemma ranked_no_divergence : m = FD -> forall z s n r, (Z.to_nat (to_Z r) < z)%nat -> Q s n r -> ~ diverges impl s.
  Proof.
    intros Em. induction z as [| z IH]; intros s n r Hz Hp D; [ lia |].
    destruct D as [s u Hst D]. destruct covers as [_ C]. destruct (C s n r Hp) as [_ M].
    specialize (M tau u Hst). unfold event_needs, ranked in M. rewrite Em in M. cbn in M.
    destruct M as (r' & Hq & Hr). specialize (Hr eq_refl). apply ltb_spec in Hr.
    assert (0 <= to_Z r')%Z by (apply to_Z_bounded).
    apply (IH u n r'); auto. lia.
  Qed.

  Lemma inv_no_divergence : m = FD -> forall s n, inv s n -> ~ diverges impl s.
  Proof.
    intros Em s n (Hs & r & Hp).
    apply (ranked_no_divergence Em (Datatypes.S (Z.to_nat (to_Z r))) s n r); auto.
  Qed.

  Lemma inv_init : inv (init impl) (root N).
  Proof. split; [ exact live | apply covers ]. Qed.
End Implementation.

Theorem check_within : forall S (impl : lts S) eqi, (forall x y, eqi x y = true -> x = y) ->
  forall m N P, check_implementation impl eqi N m P = true -> within m N impl.
Proof.
  intros S impl eqi eqi_ok m N P H t u R. destruct (stop N m (root N)) eqn:L.
  - right. exists [], t, (root N). split; [ reflexivity | split; [ constructor | exact L ]].
  - destruct (covering_exists impl eqi eqi_ok N m P H L) as (Q & C).
    destruct (inv_reach impl N m P Q C _ _ _ R _ (inv_init impl N m P L Q C)) as [(n & K & I) | K]; [ left | right; exact K ].
    exists n. split; [ exact K | split ].
    + intros Hm. exact (inv_offers impl N m P L Q C u n Hm I).
    + intros Em. exact (inv_no_divergence impl N m P Q C Em u n I).
Qed.

(** 4. Both together. *)
Section Both.
  Context {A B : Type}.
  Variable spec : lts A.
  Variable impl : lts B.
  Variable eqs : A -> A -> bool.
  Hypothesis eqs_ok : forall x y, eqs x y = true -> x = y.
  Theorem within_refines : forall m N E, check_specification spec eqs N E m = true -> within m N impl -> refines m spec impl.
  Proof.
    intros m N E HS W.
    pose proof (run_trace spec eqs eqs_ok N E m HS) as RT.
    pose proof (run_failure spec eqs eqs_ok N E m HS) as RF.
    pose proof (run_divergence spec eqs eqs_ok N E m HS) as RD.
    assert (ACC : forall t u n (X : ev -> Prop), m <> T -> nrun N (root N) t n -> offers_acceptance N impl u n -> refuses impl u X ->
              failures spec t X).
    { intros t u n X Hm K [O1 O2] HX. destruct HX as [[Ct NX] | (Nu & Nt & HX)].
      - destruct (O1 Ct) as (i & Hi & Ac). apply (RF t n i X Hm K Hi). intros a Ha. rewrite (Ac a Ha). exact NX.
      - destruct (O2 Nu Nt) as (i & Hi & Ac). apply (RF t n i X Hm K Hi). intros a Ha Xa. exact (HX a Xa (Ac a Ha)). }
    assert (Plain : m <> FD -> forall t u, reach impl (init impl) t u ->
              exists n, nrun N (root N) t n /\ (m <> T -> offers_acceptance N impl u n)).
    { intros Hm t u R. destruct (W t u R) as [(n & K & O & _) | (t1 & t2 & n & _ & _ & D)]; [ eauto |].
      unfold stop in D. destruct m; congruence. }
    destruct m; cbn.
    - intros t (u & R). destruct (Plain ltac:(congruence) t u R) as (n & K & _). exact (RT t n K).
    - split.
      + intros t (u & R). destruct (Plain ltac:(congruence) t u R) as (n & K & _). exact (RT t n K).
      + intros t X (u & R & HX). destruct (Plain ltac:(congruence) t u R) as (n & K & O).
        exact (ACC t u n X ltac:(congruence) K (O ltac:(congruence)) HX).
    - assert (DV : forall t, divergences impl t -> divergences spec t).
      { intros t (t1 & t2 & u & Et & R & D). destruct (W t1 u R) as [(n & _ & _ & ND) | (x & y & n & E2 & K & D2)].
        - exfalso. exact (ND eq_refl D).
        - subst. rewrite <- app_assoc. exact (RD x (y ++ t2) n eq_refl K D2). }
      split; [ exact DV |]. intros t X [(u & R & HX) | D]; [| right; exact (DV t D) ].
      destruct (W t u R) as [(n & K & O & _) | (x & y & n & E2 & K & D2)].
      + left. exact (ACC t u n X ltac:(congruence) K (O ltac:(congruence)) HX).
      + right. subst. exact (RD x y n eq_refl K D2).
  Qed.
End Both.

(** 5. Properties of one process: all nodes are 0. *)
Section Property.
  Context {S : Type}.
  Variable impl : lts S.
  Variable eqi : S -> S -> bool.
  Hypothesis eqi_ok : forall x y, eqi x y = true -> x = y.
  Variable p : property.
  Variable P : pairs S.

  Definition no_deadlock : bool := match p with Divergence_free => false | _ => true end.
  Definition no_divergence : bool := match p with Deadlock_free => false | _ => true end.
  Definition enabled (_ : int) (moves : list (ev * S)) : bool :=
    if no_deadlock then match moves with [] => false | _ => true end else true.
  Definition any_event (_ : int) (a : ev) : need := Leads 0 (if no_divergence then a =? tau else false).
  Definition check_property : bool := walk impl eqi P any_event enabled 0.

  Hypothesis checked : check_property = true.

  Section Covering.
  Variable Q : S -> int -> int -> Prop.
  Hypothesis Q_step : forall s n r, Q s n r -> enabled n (succ impl s) = true /\
    forall a u, step impl s a u -> exists q, Q u 0 q /\ ((if no_divergence then a =? tau else false) = true -> (q <? r) = true).

  Lemma reached_is_pair : forall s t u, reach impl s t u -> forall r, Q s 0 r -> exists r', Q u 0 r'.
  Proof.
    induction 1 as [s | s u t v Hst Hr IH | s a u t v Ha Hst Hr IH]; intros r Hp; [ eauto | |];
      destruct (Q_step s _ r Hp) as [_ K]; destruct (K _ u Hst) as (r' & Hu & _); exact (IH r' Hu).
  Qed.
  Lemma pair_no_divergence : no_divergence = true -> forall z s r, (Z.to_nat (to_Z r) < z)%nat ->
    Q s 0 r -> ~ diverges impl s.
  Proof.
    intros D. induction z as [| z IH]; intros s r Hz Hp V; [ lia |].
    destruct V as [s u Hst V]. destruct (Q_step s _ r Hp) as [_ K]. destruct (K tau u Hst) as (r' & Hu & Hr).
    rewrite D in Hr. specialize (Hr eq_refl). apply ltb_spec in Hr. assert (0 <= to_Z r')%Z by (apply to_Z_bounded).
    apply (IH u r'); auto. lia.
  Qed.
  End Covering.
  Lemma property_deadlock : no_deadlock = true -> deadlock_free impl.
  Proof.
    intros D t s R. destruct (walk_sound impl eqi eqi_ok P any_event enabled 0 checked) as (Q & (r & H0) & K).
    destruct (reached_is_pair Q K _ _ _ R r H0) as (r' & Hs).
    destruct (K s _ r' Hs) as [C _]. unfold enabled in C. rewrite D in C. unfold can, step.
    destruct (succ impl s) as [| [a u] l]; [ discriminate |]. exists a, u. left. reflexivity.
  Qed.
  Lemma property_divergence : no_divergence = true -> divergence_free impl.
  Proof.
    intros D t s R. destruct (walk_sound impl eqi eqi_ok P any_event enabled 0 checked) as (Q & (r & H0) & K).
    destruct (reached_is_pair Q K _ _ _ R r H0) as (r' & Hs).
    exact (pair_no_divergence Q K D (Datatypes.S (Z.to_nat (to_Z r'))) s r' ltac:(lia) Hs).
  Qed.
  Theorem check_property_sound : satisfies p impl.
  Proof.
    assert (A := property_deadlock). assert (B := property_divergence). unfold no_deadlock, no_divergence in A, B.
    destruct p; cbn; auto.
  Qed.
End Property.
