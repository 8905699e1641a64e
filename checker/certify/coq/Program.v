(* SPDX-License-Identifier: Apache-2.0 *)
(* States and proves the theorems about the program that is extracted. *)
From Coq Require Import List Bool Uint63.
From Certify Require Import Claims Processes Certificate Packing Merging Confluence.

(* How a process is represented: which states of its components are merged, and how its states are packed. *)
Record shape := { merges : merging; packs : layout }.
Definition compact (h : shape) (Y : system) : lts (list int) := packed (packs h) (merged (merges h) Y).
Definition shape_ok (h : shape) (Y : system) : bool :=
  merging_ok (merges h) Y && system_ok (packs h) (merged (merges h) Y).

(* The process that is searched: without a reduction, or with representatives of its states. If only deadlocks matter,
   steps with any event are followed. *)
Definition searched (any : bool) (h : shape) (R : option reduction) (Y : system) : lts (list int) :=
  match R with None => compact h Y | Some R => reduced (packs h) (merged (merges h) Y) R any end.
Definition reduction_ok (any : bool) (h : shape) (R : option reduction) (Y : system) : bool :=
  match R with None => true | Some R => let Z := merged (merges h) Y in confluent_ok Z R any (rows_by_event (packs h) Z) end.

(* Check a refinement and a property. The shapes, the reduction, the normal form, the evidence and the pairs may be any
   data. *)
Definition certify_refinement (m : model) (hs : shape) (spec : system) (hi : shape) (impl : system) (R : option reduction)
    (N : normal_form) (E : evidence (list int)) (P : pairs (list int)) : bool :=
  shape_ok hs spec && shape_ok hi impl && reduction_ok false hi R impl &&
  check (compact hs spec) (searched false hi R impl) eq_words eq_words m N E P.
Definition certify_property (p : property) (hi : shape) (impl : system) (R : option reduction) (P : pairs (list int)) : bool :=
  shape_ok hi impl && reduction_ok (only_deadlocks p) hi R impl &&
  check_property (searched (only_deadlocks p) hi R impl) eq_words p P.

Lemma searched_implementation : forall h R Y A m (spec : lts A), shape_ok h Y = true -> reduction_ok false h R Y = true ->
  refines m spec (searched false h R Y) -> refines m spec (system_lts Y).
Proof.
  unfold shape_ok. intros h R Y A m spec S K H. apply andb_true_iff in S. destruct S as [M L].
  apply (merged_implementation _ _ M), (packed_implementation _ _ _ _ _ L).
  destruct R as [R |]; [ exact (reduced_implementation _ _ _ _ _ _ L K H) | exact H ].
Qed.
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
  unfold certify_refinement. intros. rewrite !andb_true_iff in H. destruct H as [[[S1 S2] K] H].
  apply (searched_implementation _ _ _ _ _ _ S2 K). unfold shape_ok in S1. apply andb_true_iff in S1. destruct S1 as [M1 L1].
  apply (merged_specification _ _ M1), (packed_specification _ _ _ _ _ L1).
  exact (check_sound _ _ eq_words eq_words_ok eq_words eq_words_ok _ _ _ _ H).
Qed.
Theorem property_sound : forall p hi impl R P,
  certify_property p hi impl R P = true -> satisfies p (system_lts impl).
Proof.
  unfold certify_property. intros. rewrite !andb_true_iff in H. destruct H as [[S K] H].
  apply (searched_property _ _ _ _ S K). exact (check_property_sound _ eq_words eq_words_ok p P H).
Qed.

(* Both theorems in one statement. *)
Theorem program_sound :
  (forall m hs spec hi impl R N E P,
    certify_refinement m hs spec hi impl R N E P = true -> refines m (system_lts spec) (system_lts impl)) /\
  (forall p hi impl R P, certify_property p hi impl R P = true -> satisfies p (system_lts impl)).
Proof. split; [ exact refinement_sound | exact property_sound ]. Qed.
