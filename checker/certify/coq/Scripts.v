(* SPDX-License-Identifier: Apache-2.0 *)
(* States and proves the theorem about certificates at the term level. *)
From Coq Require Import List Bool Lia Uint63.
From Certify Require Import Claims Terms Processes Certificate Packing Merging Following Program Splitting.

(* Check a refinement between scripts and a property of a script. How the terms are split, and all that certify_refinement
   and certify_property need, may be any data. *)
Definition certify_scripts (m : model) (spec : script) (Xs : split) (hs : shape) (impl : script) (Xi : split) (hi : shape)
    (R : option reduction) (N : normal_form) (E : evidence (list int)) (P : pairs (list int)) : bool :=
  split_ok (defines spec) Xs (main spec) && split_ok (defines impl) Xi (main impl) &&
  certify_refinement m hs (split_system (defines spec) Xs) hi (split_system (defines impl) Xi) R N E P.
Definition certify_script (p : property) (impl : script) (Xi : split) (hi : shape) (R : option reduction)
    (P : pairs (list int)) : bool :=
  split_ok (defines impl) Xi (main impl) && certify_property p hi (split_system (defines impl) Xi) R P.

Theorem scripts_sound : forall m spec Xs hs impl Xi hi R N E P, certify_scripts m spec Xs hs impl Xi hi R N E P = true ->
  eventually (fun bound => refines m (term_lts bound spec) (term_lts bound impl)).
Proof.
  unfold certify_scripts. intros. rewrite !andb_true_iff in H. destruct H as [[S I] H]. apply refinement_sound in H.
  exists (Nat.max (enough Xs + height (whole_tree Xs)) (enough Xi + height (whole_tree Xi))). intros bound L.
  assert (LS : (enough Xs + height (whole_tree Xs) <= bound)%nat) by lia.
  assert (LI : (enough Xi + height (whole_tree Xi) <= bound)%nat) by lia.
  apply (refines_trans _ _ _ _ _ _ _ (proj2 (split_refines spec Xs S bound LS m))).
  exact (refines_trans _ _ _ _ _ _ _ H (proj1 (split_refines impl Xi I bound LI m))).
Qed.
Theorem script_property_sound : forall p impl Xi hi R P, certify_script p impl Xi hi R P = true ->
  eventually (fun bound => satisfies p (term_lts bound impl)).
Proof.
  unfold certify_script. intros. apply andb_true_iff in H. destruct H as [I H]. apply property_sound in H.
  exists (enough Xi + height (whole_tree Xi))%nat. intros bound L. exact (split_satisfies impl Xi I bound L p H).
Qed.

(* Both theorems in one statement. *)
Theorem script_sound :
  (forall m spec Xs hs impl Xi hi R N E P, certify_scripts m spec Xs hs impl Xi hi R N E P = true ->
    eventually (fun bound => refines m (term_lts bound spec) (term_lts bound impl))) /\
  (forall p impl Xi hi R P, certify_script p impl Xi hi R P = true ->
    eventually (fun bound => satisfies p (term_lts bound impl))).
Proof. split; [ exact scripts_sound | exact script_property_sound ]. Qed.
