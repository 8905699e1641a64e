(* SPDX-License-Identifier: Apache-2.0 *)
(* States and proves the theorem about certificates at the term level. *)
From Coq Require Import List Bool Lia Uint63.
From Certify Require Import Claims Terms Processes Packing Following Determinism Program Splitting.

(* Check how a term is split, and the system that the split gives. The split may be any data. *)
Definition certify_script (Z : script) (X : split) (check : system -> bool) : bool :=
  split_ok (defines Z) X (main Z) && check (split_system (defines Z) X).
(* Does the same for the terms of both sides. *)
Definition certify_scripts (spec : script) (Xs : split) (impl : script) (Xi : split) (check : system -> system -> bool) : bool :=
  certify_script spec Xs (fun s => certify_script impl Xi (check s)).

(* If a claim about systems follows from a check, and is also true for lts that are alike, it is true for the terms. *)
Lemma script_claim : forall (C : forall S, lts S -> Prop) (check : system -> bool),
  (forall Y, check Y = true -> C _ (system_lts Y)) ->
  (forall Y S (P : lts S), alike (system_lts Y) P -> C _ (system_lts Y) -> C _ P) ->
  forall Z X, certify_script Z X check = true -> eventually (fun bound => C _ (term_lts bound Z)).
Proof.
  unfold certify_script. intros C check sound keeps Z X H. apply andb_true_iff in H. destruct H as [ok H].
  destruct (split_alike Z X ok) as (enough & A). exists enough. intros bound L.
  exact (keeps _ _ _ (A bound L) (sound _ H)).
Qed.
Lemma scripts_claim : forall (C : forall S S', lts S -> lts S' -> Prop) (check : system -> system -> bool),
  (forall Y Y', check Y Y' = true -> C _ _ (system_lts Y) (system_lts Y')) ->
  (forall Y S (P : lts S) Y' S' (P' : lts S'), alike (system_lts Y) P -> alike (system_lts Y') P' ->
    C _ _ (system_lts Y) (system_lts Y') -> C _ _ P P') ->
  forall spec Xs impl Xi, certify_scripts spec Xs impl Xi check = true ->
    eventually (fun bound => C _ _ (term_lts bound spec) (term_lts bound impl)).
Proof.
  unfold certify_scripts, certify_script. intros C check sound keeps spec Xs impl Xi H. rewrite !andb_true_iff in H.
  destruct H as [S [I H]]. destruct (split_alike spec Xs S) as (n & A). destruct (split_alike impl Xi I) as (k & B).
  exists (Nat.max n k). intros bound L. exact (keeps _ _ _ _ _ _ (A bound ltac:(lia)) (B bound ltac:(lia)) (sound _ _ H)).
Qed.

Theorem script_refinement_sound : forall m spec Xs hs impl Xi hi R N E P,
  certify_scripts spec Xs impl Xi (fun s i => certify_refinement m hs s hi i R N E P) = true ->
  eventually (fun bound => refines m (term_lts bound spec) (term_lts bound impl)).
Proof.
  intros m spec Xs hs impl Xi hi R N E P. apply (scripts_claim (fun _ _ => refines m)).
  - intros Y Y'. apply refinement_sound.
  - intros Y S P' Y' S' Q (A & _) (B & _) H.
    exact (refines_trans _ _ _ m _ _ _ (proj2 (A m)) (refines_trans _ _ _ m _ _ _ H (proj1 (B m)))).
Qed.
Theorem script_property_sound : forall p impl Xi hi R P,
  certify_script impl Xi (fun i => certify_property p hi i R P) = true ->
  eventually (fun bound => satisfies p (term_lts bound impl)).
Proof.
  intros p impl Xi hi R P. apply (script_claim (fun _ => satisfies p)).
  - intros Y. apply property_sound.
  - intros Y S Q (_ & A & _). apply A.
Qed.
Theorem script_determinism_sound : forall m hg G impl Xi hi R N E P,
  certify_script impl Xi (fun i => certify_determinism m hg G hi i R N E P) = true ->
  eventually (fun bound => deterministic m (term_lts bound impl)).
Proof.
  intros m hg G impl Xi hi R N E P. apply (script_claim (fun _ => deterministic m)).
  - intros Y. apply determinism_sound.
  - intros Y S Q (A & _). destruct m.
    + exact (deterministic_refined _ _ F ltac:(discriminate) (proj1 (A F))).
    + exact (deterministic_refined _ _ F ltac:(discriminate) (proj1 (A F))).
    + exact (deterministic_refined _ _ FD ltac:(discriminate) (proj1 (A FD))).
Qed.
Theorem script_possible_sound : forall goal impl Xi hi H,
  certify_script impl Xi (fun i => certify_possible goal hi i H) = true ->
  eventually (fun bound => stays_possible (fun a => In a goal) (term_lts bound impl)).
Proof.
  intros goal impl Xi hi H. apply (script_claim (fun _ => stays_possible (fun a => In a goal))).
  - intros Y. apply possible_sound.
  - intros Y S Q (_ & _ & A). apply A.
Qed.
Theorem script_trace_sound : forall t impl Xi hi r,
  certify_script impl Xi (fun i => certify_trace t hi i r) = true ->
  eventually (fun bound => traces (term_lts bound impl) t).
Proof.
  intros t impl Xi hi r. apply (script_claim (fun _ P => traces P t)).
  - intros Y. apply trace_sound.
  - intros Y S Q (A & _). exact (proj2 (A T) t).
Qed.
Theorem script_refutation_sound : forall m spec Xs hs impl Xi hi v P,
  certify_scripts spec Xs impl Xi (fun s i => certify_refutation m hs s hi i v P) = true ->
  eventually (fun bound => ~ refines m (term_lts bound spec) (term_lts bound impl)).
Proof.
  intros m spec Xs hs impl Xi hi v P. apply (scripts_claim (fun _ _ A B => ~ refines m A B)).
  - intros Y Y'. apply refutation_sound.
  - intros Y S P' Y' S' Q (A & _) (B & _) N H. apply N.
    exact (refines_trans _ _ _ m _ _ _ (proj1 (A m)) (refines_trans _ _ _ m _ _ _ H (proj2 (B m)))).
Qed.

(* Everything that the certifier accepts at the term level, in one statement. *)
Theorem script_sound :
  (forall m spec Xs hs impl Xi hi R N E P,
    certify_scripts spec Xs impl Xi (fun s i => certify_refinement m hs s hi i R N E P) = true ->
    eventually (fun bound => refines m (term_lts bound spec) (term_lts bound impl))) /\
  (forall p impl Xi hi R P, certify_script impl Xi (fun i => certify_property p hi i R P) = true ->
    eventually (fun bound => satisfies p (term_lts bound impl))) /\
  (forall m hg G impl Xi hi R N E P, certify_script impl Xi (fun i => certify_determinism m hg G hi i R N E P) = true ->
    eventually (fun bound => deterministic m (term_lts bound impl))) /\
  (forall goal impl Xi hi H, certify_script impl Xi (fun i => certify_possible goal hi i H) = true ->
    eventually (fun bound => stays_possible (fun a => In a goal) (term_lts bound impl))) /\
  (forall t impl Xi hi r, certify_script impl Xi (fun i => certify_trace t hi i r) = true ->
    eventually (fun bound => traces (term_lts bound impl) t)) /\
  (forall m spec Xs hs impl Xi hi v P,
    certify_scripts spec Xs impl Xi (fun s i => certify_refutation m hs s hi i v P) = true ->
    eventually (fun bound => ~ refines m (term_lts bound spec) (term_lts bound impl))).
Proof.
  exact (conj script_refinement_sound (conj script_property_sound (conj script_determinism_sound (conj script_possible_sound
    (conj script_trace_sound script_refutation_sound))))).
Qed.
