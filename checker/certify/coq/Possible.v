(* SPDX-License-Identifier: Apache-2.0 *)
(* Checks that an event stays possible. Each reachable state has a number, and a distance: some move of the state is one
   of the events, or leads to a state with a smaller distance. *)
From Coq Require Import List Bool ZArith Lia Uint63.
From Certify Require Import Claims Processes Loops Certificate Moves Packing Merging.
Import ListNotations.
Open Scope uint63_scope.

(* The states, by number. `distance` may be any function: it is only compared. *)
Record numbering (S : Type) := {
  state_count : int;
  state_number : S -> int;
  numbered_state : int -> S;
  distance : int -> int }.
Arguments state_count {S}. Arguments state_number {S}. Arguments numbered_state {S}. Arguments distance {S}.

Section Check.
  Context {S : Type}.
  Variable P : lts S.
  Variable eqi : S -> S -> bool.
  Hypothesis eqi_ok : forall x y, eqi x y = true -> x = y.
  Variable goal : list ev.
  Variable H : numbering S.

  (* Returns the number of a state, if the state has one. *)
  Definition known_number (u : S) : option int :=
    let j := state_number H u in
    if j <? state_count H then if eqi (numbered_state H j) u then Some j else None else None.
  (* All targets have numbers. `found` states that a move before these moves leads nearer to the goal. *)
  Fixpoint nearer (d : int) (moves : list (ev * S)) (found : bool) : bool :=
    match moves with
    | [] => found
    | (a, u) :: rest =>
        match known_number u with
        | Some k => nearer d rest (if found then true else if memb a goal then true else distance H k <? d)
        | None => false
        end
    end.
  Definition check_state (j : int) : bool := nearer (distance H j) (succ P (numbered_state H j)) false.
  Definition check_possible : bool :=
    match known_number (init P) with Some _ => all_below check_state (state_count H) | None => false end.

  Definition has_number (j : int) (u : S) : Prop := (j <? state_count H) = true /\ numbered_state H j = u.
  Lemma known_number_sound : forall u j, known_number u = Some j -> has_number j u.
  Proof.
    unfold known_number. intros u j K. cbn zeta in K. destruct (state_number H u <? state_count H) eqn:L; [| discriminate].
    destruct (eqi (numbered_state H (state_number H u)) u) eqn:E; [| discriminate]. apply eqi_ok in E.
    inversion K. subst. split; assumption.
  Qed.
  Lemma nearer_sound : forall d steps found, nearer d steps found = true ->
    (forall a u, In (a, u) steps -> exists k, has_number k u) /\
    (found = true \/ exists a u k, In (a, u) steps /\ has_number k u /\ (In a goal \/ (distance H k <? d) = true)).
  Proof.
    intros d steps. induction steps as [| [b w] steps IH]; intros found K; cbn in K; [ split; [ intros a u [] | left; exact K ] |].
    destruct (known_number w) as [k |] eqn:N; [| discriminate]. apply known_number_sound in N. apply IH in K.
    destruct K as [K1 K2]. split.
    - intros a u [E | I']; [ inversion E; subst; eauto | exact (K1 a u I') ].
    - destruct K2 as [F | (a & u & k' & I' & K3 & K4)].
      + destruct found; [ left; reflexivity | right ]. exists b, w, k.
        split; [ left; reflexivity | split; [ exact N |]]. destruct (memb b goal) eqn:M; [ left; apply memb_in; exact M | auto ].
      + right. exists a, u, k'. split; [ right; exact I' | auto ].
  Qed.

  Hypothesis checked : check_possible = true.

  Lemma numbered_checked : forall j u, has_number j u -> nearer (distance H j) (succ P u) false = true.
  Proof.
    intros j u [L E]. unfold check_possible in checked. destruct (known_number (init P)); [| discriminate].
    subst u. exact (all_below_spec _ _ checked j L).
  Qed.
  Lemma reached_numbered : forall s t u, reach P s t u -> forall j, has_number j s -> exists k, has_number k u.
  Proof.
    induction 1 as [s | s u t v St R IH | s a u t v Ha St R IH]; intros j N; [ eauto | |];
      destruct (nearer_sound _ _ _ (numbered_checked j s N)) as [M _]; destruct (M _ u St) as (k & K); exact (IH k K).
  Qed.
  Lemma numbered_possible : forall z j s, (Z.to_nat (to_Z (distance H j)) < z)%nat -> has_number j s ->
    exists t u a, reach P s t u /\ In a goal /\ can P u a.
  Proof.
    induction z as [| z IH]; intros j s Hz N; [ lia |].
    destruct (nearer_sound _ _ _ (numbered_checked j s N)) as [_ [F | (a & u & k & St & K & M)]]; [ discriminate |].
    destruct M as [G | D].
    - exists [], s, a. split; [ constructor | split; [ exact G | exists u; exact St ]].
    - apply ltb_spec in D. pose proof (to_Z_bounded (distance H k)).
      destruct (IH k u ltac:(lia) K) as (t & v & b & R & G & C). destruct (a =? tau) eqn:E.
      + apply eqb_true in E. subst. exists t, v, b. split; [ exact (reach_tau P s u t v St R) | auto ].
      + apply eqb_false_neq in E. exists (a :: t), v, b. split; [ exact (reach_vis P s a u t v E St R) | auto ].
  Qed.
  Theorem check_possible_sound : stays_possible (fun a => In a goal) P.
  Proof.
    intros t s R. assert (N : exists j, has_number j (init P)).
    { unfold check_possible in checked. destruct (known_number (init P)) as [j |] eqn:N; [| discriminate].
      exists j. apply known_number_sound. exact N. }
    destruct N as (j & N). destruct (reached_numbered _ _ _ R j N) as (k & K).
    exact (numbered_possible (Datatypes.S (Z.to_nat (to_Z (distance H k)))) k s ltac:(lia) K).
  Qed.
End Check.

Theorem merged_possible : forall M Y, merging_ok M Y = true -> forall G,
  stays_possible G (system_lts (merged M Y)) -> stays_possible G (system_lts Y).
Proof.
  intros M Y ok. exact (morphism_possible (system_lts Y) (system_lts (merged M Y)) (merge_state M 0)
    (fun s => length s = length (start Y)) eq_refl (merged_length Y) eq_refl (merged_bisimulation M Y ok)).
Qed.
Theorem packed_possible : forall L Y, system_ok L Y = true -> forall G,
  stays_possible G (packed L Y) -> stays_possible G (system_lts Y).
Proof.
  intros L Y ok. destruct (packed_bisimulation L Y ok) as (H1 & H2 & H3).
  exact (morphism_possible (system_lts Y) (packed L Y) (pack (groups L)) (fun s => fits (concat (groups L)) s = true)
           H1 H2 eq_refl H3).
Qed.
