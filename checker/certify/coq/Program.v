(* SPDX-License-Identifier: Apache-2.0 *)
(* States and proves the theorems about the program that is extracted. *)
From Coq Require Import List Bool Uint63.
From Certify Require Import Claims Processes Certificate Packing Merging.

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

(* Both theorems in one statement. *)
Theorem program_sound :
  (forall m hs spec hi impl N E P,
    certify_refinement m hs spec hi impl N E P = true -> refines m (system_lts spec) (system_lts impl)) /\
  (forall p hi impl P, certify_property p hi impl P = true -> satisfies p (system_lts impl)).
Proof. split; [ exact refinement_sound | exact property_sound ]. Qed.
