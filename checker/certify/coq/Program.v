(* SPDX-License-Identifier: Apache-2.0 *)
(* States and proves the theorems about the program that is extracted. *)
From Coq Require Import List Bool Uint63.
From Certify Require Import Claims Processes Certificate Packing Merging Following Determinism Possible Runs.

(* How a process is represented: which states of its components are merged, and how its states are packed. *)
Record shape := { merges : merging; packs : layout }.
Definition compact (h : shape) (Y : system) : lts (list int) := packed (packs h) (merged (merges h) Y).
Definition shape_ok (h : shape) (Y : system) : bool :=
  merging_ok (merges h) Y && system_ok (packs h) (merged (merges h) Y).

(* The process that is searched: without a reduction, or with representatives of its states. If only deadlocks matter
   (`any`), steps with any event are followed. *)
Definition searched (any : bool) (h : shape) (R : option reduction) (Y : system) : lts (list int) :=
  match R with None => compact h Y | Some R => reduced (packs h) (merged (merges h) Y) R any end.
Definition reduction_ok (any : bool) (h : shape) (R : option reduction) (Y : system) : bool :=
  match R with None => true | Some R => reduction_holds (packs h) (merged (merges h) Y) R any end.

(* Check a refinement and a property. The shapes, the reduction, the normal form, the evidence and the pairs may be any
   data. *)
Definition certify_refinement (m : model) (hs : shape) (spec : system) (hi : shape) (impl : system) (R : option reduction)
    (N : normal_form) (E : evidence (list int)) (P : pairs (list int)) : bool :=
  shape_ok hs spec && shape_ok hi impl && reduction_ok false hi R impl &&
  match R with None => true | Some R => indifferent_ok R N end &&
  check_specification (compact hs spec) eq_words N E m && check_implementation (searched false hi R impl) eq_words N m P.
Definition certify_property (p : property) (hi : shape) (impl : system) (R : option reduction) (P : pairs (list int)) : bool :=
  shape_ok hi impl && reduction_ok (only_deadlocks p) hi R impl &&
  check_property (searched (only_deadlocks p) hi R impl) eq_words p P.

Lemma searched_property : forall h R Y p, shape_ok h Y = true -> reduction_ok (only_deadlocks p) h R Y = true ->
  satisfies p (searched (only_deadlocks p) h R Y) -> satisfies p (system_lts Y).
Proof.
  unfold shape_ok. intros h R Y p S K H. apply andb_true_iff in S. destruct S as [M L].
  apply (merged_property _ _ M), (packed_property _ _ _ L).
  destruct R as [R |]; [ exact (reduced_property _ _ _ _ L K H) | exact H ].
Qed.

Theorem refinement_sound : forall m hs spec hi impl R N E P,
  certify_refinement m hs spec hi impl R N E P = true -> refines m (system_lts spec) (system_lts impl).
Proof.
  unfold certify_refinement, shape_ok. intros m hs spec hi impl R N E P H. rewrite !andb_true_iff in H.
  destruct H as [[[[[[M1 L1] [M2 L2]] K] I] HS] HI].
  apply (merged_implementation _ _ M2), (packed_implementation _ _ _ _ _ L2).
  apply (merged_specification _ _ M1), (packed_specification _ _ _ _ _ L1).
  apply (within_refines _ _ eq_words eq_words_ok m N E HS). apply (check_within _ _ eq_words eq_words_ok) in HI.
  destruct R as [R |]; [| exact HI ].
  exact (reduced_within _ _ R N m L2 K I (proj1 (root_ok _ eq_words eq_words_ok N E m HS))
    (arc_node _ eq_words N E m HS) HI).
Qed.
Theorem property_sound : forall p hi impl R P,
  certify_property p hi impl R P = true -> satisfies p (system_lts impl).
Proof.
  unfold certify_property. intros. rewrite !andb_true_iff in H. destruct H as [[S K] H].
  apply (searched_property _ _ _ _ S K). exact (check_property_sound _ eq_words eq_words_ok p P H).
Qed.

(* Check determinism: the process refines some graph without choices. *)
Definition certify_determinism (m : model) (hg : shape) (G : choiceless) (hi : shape) (impl : system)
    (R : option reduction) (N : normal_form) (E : evidence (list int)) (P : pairs (list int)) : bool :=
  match m with T => false | _ => choiceless_ok G && certify_refinement m hg (choiceless_system G) hi impl R N E P end.
Theorem determinism_sound : forall m hg G hi impl R N E P,
  certify_determinism m hg G hi impl R N E P = true -> deterministic m (system_lts impl).
Proof.
  unfold certify_determinism. intros m hg G hi impl R N E P H.
  assert (Hm : m <> T) by (intros K; subst; discriminate).
  assert (H' : choiceless_ok G && certify_refinement m hg (choiceless_system G) hi impl R N E P = true)
    by (destruct m; [ discriminate | exact H | exact H ]).
  apply andb_true_iff in H'. destruct H' as [C K]. apply refinement_sound in K.
  exact (deterministic_refined _ _ m Hm K (choiceless_system_deterministic G C m)).
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

(* A process and its representation refine each other, so each of them can do what the other can do. *)
Lemma compact_refines : forall h Y m, shape_ok h Y = true ->
  refines m (compact h Y) (system_lts Y) /\ refines m (system_lts Y) (compact h Y).
Proof.
  unfold shape_ok, compact. intros h Y m H. apply andb_true_iff in H. destruct H as [M S]. split.
  - apply (merged_implementation _ _ M), (packed_implementation _ _ _ _ _ S), refines_refl.
  - apply (merged_specification _ _ M), (packed_specification _ _ _ _ _ S), refines_refl.
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
  apply (refines_trans _ _ _ m _ (system_lts spec)); [ apply compact_refines; exact S1 |].
  apply (refines_trans _ _ _ m _ (system_lts impl)); [ exact K | apply compact_refines; exact S2 ].
Qed.

(* Everything that the certifier accepts, in one statement. *)
Theorem program_sound :
  (forall m hs spec hi impl R N E P,
    certify_refinement m hs spec hi impl R N E P = true -> refines m (system_lts spec) (system_lts impl)) /\
  (forall p hi impl R P, certify_property p hi impl R P = true -> satisfies p (system_lts impl)) /\
  (forall m hg G hi impl R N E P,
    certify_determinism m hg G hi impl R N E P = true -> deterministic m (system_lts impl)) /\
  (forall goal hi impl H,
    certify_possible goal hi impl H = true -> stays_possible (fun a => In a goal) (system_lts impl)) /\
  (forall t hi impl r, certify_trace t hi impl r = true -> traces (system_lts impl) t) /\
  (forall m hs spec hi impl v P,
    certify_refutation m hs spec hi impl v P = true -> ~ refines m (system_lts spec) (system_lts impl)).
Proof.
  exact (conj refinement_sound (conj property_sound (conj determinism_sound (conj possible_sound
    (conj trace_sound refutation_sound))))).
Qed.
