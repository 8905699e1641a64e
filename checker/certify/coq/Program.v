(* SPDX-License-Identifier: Apache-2.0 *)
(* States and proves the theorems about the program that is extracted. *)
From Coq Require Import List Bool Uint63.
From Certify Require Import Claims Processes Certificate Packing Merging Determinism Possible Runs.

(* How a process is represented: which states of its components are merged, and how its states are packed. *)
Record shape := { merges : merging; packs : layout }.
Definition compact (h : shape) (Y : system) : lts (list int) := packed (packs h) (merged (merges h) Y).
Definition shape_ok (h : shape) (Y : system) : bool :=
  merging_ok (merges h) Y && system_ok (packs h) (merged (merges h) Y).

(* Check a refinement and a property. The shapes, the normal form, the evidence and the pairs may be any data. *)
Definition certify_refinement (m : model) (hs : shape) (spec : system) (hi : shape) (impl : system)
    (N : normal_form) (E : evidence (list int)) (P : pairs (list int)) : bool :=
  shape_ok hs spec && shape_ok hi impl && check (compact hs spec) (compact hi impl) eq_words eq_words m N E P.
Definition certify_property (p : property) (hi : shape) (impl : system) (P : pairs (list int)) : bool :=
  shape_ok hi impl && check_property (compact hi impl) eq_words p P.

Theorem refinement_sound : forall m hs spec hi impl N E P,
  certify_refinement m hs spec hi impl N E P = true -> refines m (system_lts spec) (system_lts impl).
Proof.
  unfold certify_refinement, shape_ok. intros. rewrite !andb_true_iff in H. destruct H as [[[M1 S1] [M2 S2]] H].
  apply (merged_specification _ _ M1), (packed_specification _ _ _ _ _ S1).
  apply (merged_implementation _ _ M2), (packed_implementation _ _ _ _ _ S2).
  exact (check_sound _ _ eq_words eq_words_ok eq_words eq_words_ok _ _ _ _ H).
Qed.
Theorem property_sound : forall p hi impl P, certify_property p hi impl P = true -> satisfies p (system_lts impl).
Proof.
  unfold certify_property, shape_ok. intros. rewrite !andb_true_iff in H. destruct H as [[M S] H].
  apply (merged_property _ _ M), (packed_property _ _ _ S). exact (check_property_sound _ eq_words eq_words_ok p P H).
Qed.


(* Check determinism: the process refines some graph without choices. *)
Definition certify_determinism (m : model) (hg : shape) (G : choiceless) (hi : shape) (impl : system)
    (N : normal_form) (E : evidence (list int)) (P : pairs (list int)) : bool :=
  match m with T => false | _ => choiceless_ok G && certify_refinement m hg (choiceless_system G) hi impl N E P end.
Theorem determinism_sound : forall m hg G hi impl N E P,
  certify_determinism m hg G hi impl N E P = true -> deterministic m (system_lts impl).
Proof.
  unfold certify_determinism. intros m hg G hi impl N E P H.
  assert (Hm : m <> T) by (intros K; subst; discriminate).
  assert (H' : choiceless_ok G && certify_refinement m hg (choiceless_system G) hi impl N E P = true)
    by (destruct m; [ discriminate | exact H | exact H ]).
  apply andb_true_iff in H'. destruct H' as [C R]. apply refinement_sound in R.
  exact (deterministic_refined _ _ m Hm R (choiceless_system_deterministic G C m)).
Qed.

(* Check that an event stays possible. *)
Definition certify_possible (goal : list ev) (hi : shape) (impl : system) (H : numbering (list int)) : bool :=
  shape_ok hi impl && check_possible (compact hi impl) eq_words goal H.
Theorem possible_sound : forall goal hi impl H, certify_possible goal hi impl H = true ->
  stays_possible (fun a => In a goal) (system_lts impl).
Proof.
  unfold certify_possible, shape_ok. intros goal hi impl H K. rewrite !andb_true_iff in K. destruct K as [[M S] K].
  apply (merged_possible _ _ M), (packed_possible _ _ S). exact (check_possible_sound _ eq_words eq_words_ok goal H K).
Qed.

(* A process and its representation refine each other. So whatever one of them does, the other does, too. *)
Lemma refines_itself : forall A m (P : lts A), refines m P P.
Proof. intros A []; cbn; auto. Qed.
Lemma refines_through : forall A B C m (P : lts A) (Q : lts B) (R : lts C),
  refines m P Q -> refines m Q R -> refines m P R.
Proof.
  intros A B C m P Q R. destruct m; cbn; intros H K.
  - auto.
  - destruct H, K. split; auto.
  - destruct H, K. split; auto.
Qed.
Lemma compact_refines : forall h Y m, shape_ok h Y = true ->
  refines m (compact h Y) (system_lts Y) /\ refines m (system_lts Y) (compact h Y).
Proof.
  unfold shape_ok, compact. intros h Y m H. apply andb_true_iff in H. destruct H as [M S]. split.
  - apply (merged_implementation _ _ M), (packed_implementation _ _ _ _ _ S), refines_itself.
  - apply (merged_specification _ _ M), (packed_specification _ _ _ _ _ S), refines_itself.
Qed.

(* Check that a process has a trace. *)
Definition certify_trace (t : list ev) (hi : shape) (impl : system) (r : list (ev * list int)) : bool :=
  shape_ok hi impl && check_trace (compact hi impl) eq_words t r.
Theorem trace_sound : forall t hi impl r, certify_trace t hi impl r = true -> traces (system_lts impl) t.
Proof.
  unfold certify_trace. intros t hi impl r H. apply andb_true_iff in H. destruct H as [S H].
  apply (proj2 (compact_refines hi impl T S)). exact (check_trace_sound _ eq_words eq_words_ok t r H).
Qed.

(* Check that a refinement fails. *)
Definition certify_refutation (m : model) (hs : shape) (spec : system) (hi : shape) (impl : system)
    (v : refutation (list int)) (P : pairs (list int)) : bool :=
  shape_ok hs spec && shape_ok hi impl &&
  check_refutation (compact hs spec) (compact hi impl) eq_words eq_words m v P.
Theorem refutation_sound : forall m hs spec hi impl v P,
  certify_refutation m hs spec hi impl v P = true -> ~ refines m (system_lts spec) (system_lts impl).
Proof.
  unfold certify_refutation. intros m hs spec hi impl v P H K. rewrite !andb_true_iff in H. destruct H as [[S1 S2] H].
  apply (check_refutation_sound _ _ eq_words eq_words_ok eq_words eq_words_ok m v P H).
  apply (refines_through _ _ _ m _ (system_lts spec)); [ apply compact_refines; exact S1 |].
  apply (refines_through _ _ _ m _ (system_lts impl)); [ exact K | apply compact_refines; exact S2 ].
Qed.

(* Everything that the certifier accepts, in one statement. *)
Theorem program_sound :
  (forall m hs spec hi impl N E P,
    certify_refinement m hs spec hi impl N E P = true -> refines m (system_lts spec) (system_lts impl)) /\
  (forall p hi impl P, certify_property p hi impl P = true -> satisfies p (system_lts impl)) /\
  (forall m hg G hi impl N E P,
    certify_determinism m hg G hi impl N E P = true -> deterministic m (system_lts impl)) /\
  (forall goal hi impl H,
    certify_possible goal hi impl H = true -> stays_possible (fun a => In a goal) (system_lts impl)) /\
  (forall t hi impl r, certify_trace t hi impl r = true -> traces (system_lts impl) t) /\
  (forall m hs spec hi impl v P,
    certify_refutation m hs spec hi impl v P = true -> ~ refines m (system_lts spec) (system_lts impl)).
Proof.
  exact (conj refinement_sound (conj property_sound (conj determinism_sound (conj possible_sound
    (conj trace_sound refutation_sound))))).
Qed.
