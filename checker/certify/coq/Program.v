(* SPDX-License-Identifier: Apache-2.0 *)
(* The theorems about the program that is extracted. *)
From Coq Require Import List Bool Uint63.
From Certify Require Import Claims Processes Certificate Packing.

(* The checks of a refinement and of a property. Layouts, normal form, evidence and pairs may be anything. *)
Definition certify_refinement (m : model) (ls : layout) (spec : system) (li : layout) (impl : system)
    (N : normal_form) (E : evidence (list int)) (P : pairs (list int)) : bool :=
  system_ok ls spec && system_ok li impl &&
  check (packed ls spec) (packed li impl) eq_words eq_words m N E P.
Definition certify_property (p : property) (li : layout) (impl : system) (P : pairs (list int)) : bool :=
  system_ok li impl && check_property (packed li impl) eq_words p P.

Theorem refinement_sound : forall m ls spec li impl N E P,
  certify_refinement m ls spec li impl N E P = true -> refines m (system_lts spec) (system_lts impl).
Proof.
  unfold certify_refinement. intros. rewrite !andb_true_iff in H. destruct H as [[H1 H2] H3].
  apply (packed_specification ls); [ exact H1 |]. apply (packed_implementation li); [ exact H2 |].
  exact (check_sound (packed ls spec) (packed li impl) eq_words eq_words_ok eq_words eq_words_ok _ _ _ _ H3).
Qed.
Theorem property_sound : forall p li impl P,
  certify_property p li impl P = true -> satisfies p (system_lts impl).
Proof.
  unfold certify_property. intros. apply andb_true_iff in H. destruct H as [H1 H2].
  apply (packed_property li); [ exact H1 |]. exact (check_property_sound _ eq_words eq_words_ok p P H2).
Qed.

(* Both, in one statement. *)
Theorem program_sound :
  (forall m ls spec li impl N E P,
    certify_refinement m ls spec li impl N E P = true -> refines m (system_lts spec) (system_lts impl)) /\
  (forall p li impl P, certify_property p li impl P = true -> satisfies p (system_lts impl)).
Proof. split; [ exact refinement_sound | exact property_sound ]. Qed.
