(* SPDX-License-Identifier: Apache-2.0 *)
(* Proves that a process is deterministic if it refines a graph without choices (Roscoe, "Understanding Concurrent
   Systems", section 10.5: refinements of deterministic processes are deterministic). Any graph may be given: nothing is
   assumed about how it was found. *)
From Coq Require Import List Bool ZArith Lia Uint63.
From Certify Require Import Claims Processes Loops Certificate Moves.
Import ListNotations.
Open Scope uint63_scope.

(* A graph whose nodes are the numbers below `choiceless_size`. Its arcs have these events. *)
Record choiceless := {
  choiceless_size : int;
  choiceless_start : int;
  choiceless_arcs : int -> list (ev * int);
  choiceless_events : list ev }.

(* The graph as a process with one component. *)
Definition choiceless_system (G : choiceless) : system :=
  {| edges := fun _ v => if v <? choiceless_size G then choiceless_arcs G v else [];
     start := [choiceless_start G];
     whole := Region [Slot 0] (map (fun a => {| does := a; level := None; asks := [(0%nat, a)]; puts := [] |})
                                   (choiceless_events G)) |}.

(* The events of the arcs ascend, and are larger than `last`. Nothing follows tick. *)
Fixpoint ascending (last : ev) (l : list (ev * int)) : bool :=
  match l with
  | [] => true
  | e :: rest => if last =? tick then false else if last <? fst e then ascending (fst e) rest else false
  end.
Definition choiceless_ok (G : choiceless) : bool :=
  all_below (fun v => ascending tau (choiceless_arcs G v)) (choiceless_size G).

Lemma ascending_larger : forall l last, ascending last l = true -> forall a u, In (a, u) l ->
  (to_Z last < to_Z a)%Z /\ last <> tick.
Proof.
  induction l as [| [b w] l IH]; intros last H a u I; [ destruct I |]. cbn in H.
  destruct (last =? tick) eqn:T; [ discriminate |]. apply eqb_false_neq in T.
  destruct (last <? b) eqn:L; [| discriminate ]. apply ltb_spec in L. split; [| exact T ]. destruct I as [E | I].
  - inversion E. subst. exact L.
  - destruct (IH b H a u I). lia.
Qed.
Lemma ascending_one : forall l last, ascending last l = true ->
  forall a u w, In (a, u) l -> In (a, w) l -> u = w.
Proof.
  induction l as [| [b x] l IH]; intros last H a u w Hu Hw; [ destruct Hu |]. cbn in H.
  destruct (last =? tick); [ discriminate |]. destruct (last <? b); [| discriminate ].
  destruct Hu as [E | Hu], Hw as [K | Hw].
  - congruence.
  - inversion E. subst. destruct (ascending_larger _ _ H _ _ Hw). lia.
  - inversion K. subst. destruct (ascending_larger _ _ H _ _ Hu). lia.
  - exact (IH b H a u w Hu Hw).
Qed.
Lemma ascending_tick : forall l last, ascending last l = true ->
  forall u a w, In (tick, u) l -> In (a, w) l -> a = tick.
Proof.
  induction l as [| [b x] l IH]; intros last H u a w Hu Hw; [ destruct Hu |]. cbn in H.
  destruct (last =? tick); [ discriminate |]. destruct (last <? b) eqn:L; [| discriminate ]. apply ltb_spec in L.
  destruct Hu as [E | Hu], Hw as [K | Hw].
  - congruence.
  - inversion E. subst. destruct (ascending_larger _ _ H _ _ Hw). congruence.
  - exfalso. destruct (ascending_larger _ _ H _ _ Hu) as [M _]. change (to_Z tick) with 1%Z in M.
    pose proof (to_Z_bounded last). lia.
  - exact (IH b H u a w Hu Hw).
Qed.

(** 1. A process without taus whose transitions are determined by their events, where tick excludes other events, is
    deterministic. *)
Section Choiceless.
  Context {S : Type}.
  Variable A : lts S.
  Variable good : S -> Prop.
  Hypothesis good_init : good (init A).
  Hypothesis good_step : forall s a u, good s -> step A s a u -> good u.
  Hypothesis no_tau : forall s u, good s -> ~ step A s tau u.
  Hypothesis one : forall s a u w, good s -> step A s a u -> step A s a w -> u = w.
  Hypothesis tick_alone : forall s a, good s -> can A s tick -> can A s a -> a = tick.

  Lemma choiceless_reach_app : forall t t2 s w, good s -> reach A s (t ++ t2) w ->
    exists u, reach A s t u /\ reach A u t2 w.
  Proof.
    induction t as [| a t IH]; intros t2 s w G R; [ exists s; split; [ constructor | exact R ] |]. cbn in R.
    remember (a :: t ++ t2) as l eqn:E. destruct R as [s | s u l v St R | s b u l v Hb St R].
    - discriminate.
    - destruct (no_tau s u G St).
    - inversion E. subst. destruct (IH t2 u v (good_step _ _ _ G St) R) as (x & R1 & R2). exists x.
      split; [ exact (reach_vis A s a u t x Hb St R1) | exact R2 ].
  Qed.
  Lemma choiceless_reach_one : forall s t u, reach A s t u -> good s -> forall w, reach A s t w -> u = w /\ good u.
  Proof.
    induction 1 as [s | s u t v St R IH | s a u t v Ha St R IH]; intros G w K.
    - remember [] as l eqn:E. destruct K as [s | s x l y Sx K | s b x l y Hb Sx K].
      + auto.
      + destruct (no_tau s x G Sx).
      + discriminate.
    - destruct (no_tau s u G St).
    - remember (a :: t) as l eqn:E. destruct K as [s | s x l y Sx K | s b x l y Hb Sx K].
      + discriminate.
      + destruct (no_tau s x G Sx).
      + inversion E. subst. assert (u = x) by exact (one _ _ _ _ G St Sx). subst.
        exact (IH (good_step _ _ _ G St) y K).
  Qed.
  Theorem choiceless_deterministic : forall m, deterministic m A.
  Proof.
    intros m. split.
    - intros t a (w & R) (s & K & X). apply choiceless_reach_app in R; [| exact good_init ].
      destruct R as (u & R & Ra). destruct (choiceless_reach_one _ _ _ R good_init s K) as [E G]. subst s.
      assert (C : can A u a).
      { remember [a] as l eqn:E. destruct Ra as [s | s x l y Sx Ra | s b x l y Hb Sx Ra].
        - discriminate.
        - destruct (no_tau s x G Sx).
        - inversion E. subst. exists x. exact Sx. }
      destruct X as [[T N] | (_ & _ & N)].
      + apply N. symmetry. exact (tick_alone u a G T C).
      + exact (N a eq_refl C).
    - destruct m; auto. intros t s R D. destruct D as [s u St D].
      assert (G : good s).
      { destruct (choiceless_reach_one _ _ _ R good_init s R) as [_ G]. exact G. }
      exact (no_tau s u G St).
  Qed.
End Choiceless.

(** 2. The graph is such a process. *)
Section Graph.
  Variable G : choiceless.
  Hypothesis ok : choiceless_ok G = true.
  Let A := system_lts (choiceless_system G).
  Definition row (v : int) : list (ev * int) := edges (choiceless_system G) 0 v.

  Lemma row_ascending : forall v, ascending tau (row v) = true.
  Proof.
    intros v. unfold row. cbn [choiceless_system edges]. destruct (v <? choiceless_size G) eqn:L; [| reflexivity ].
    exact (all_below_spec _ _ ok v L).
  Qed.
  Lemma choiceless_step : forall v a w, step A [v] a w -> exists u, w = [u] /\ In (a, u) (row v).
  Proof.
    intros v a w H. unfold step, A in H. cbn [system_lts succ choiceless_system whole] in H. apply in_map_iff in H.
    destruct H as ([b ch] & E & H). cbn [fst snd] in E. inversion E. subst. clear E. cbn [moves] in H.
    unfold fire in H. apply in_flat_map in H. destruct H as (r & Hr & H). apply in_map_iff in Hr.
    destruct Hr as (c & Er & _). subst r. unfold prevented in H. cbn [level does asks puts] in H.
    apply in_map_iff in H. destruct H as (ch' & E & H). inversion E. subst. clear E. apply combine_in in H.
    destruct H as (m & c' & Hm & Em & Hc & Ec). cbn in Hc. destruct Hc as [Hc | []]. subst c' ch'.
    cbn [map nth] in Hm. unfold slot_moves in Hm. apply in_map_iff in Hm. destruct Hm as ([d u] & Edu & Hd). subst m.
    cbn [fst snd] in *. subst d. exists u. split; [ reflexivity | exact Hd ].
  Qed.
  Theorem choiceless_system_deterministic : forall m, deterministic m A.
  Proof.
    apply (choiceless_deterministic A (fun s => exists v, s = [v])).
    - exists (choiceless_start G). reflexivity.
    - intros s a u (v & E) St. subst. destruct (choiceless_step v a u St) as (w & E & _). eauto.
    - intros s u (v & E) St. subst. destruct (choiceless_step v _ u St) as (w & _ & I).
      destruct (ascending_larger _ _ (row_ascending v) _ _ I) as [L _]. change (to_Z tau) with 0%Z in L. lia.
    - intros s a u w (v & E) Su Sw. subst. destruct (choiceless_step v a u Su) as (x & Eu & Iu).
      destruct (choiceless_step v a w Sw) as (y & Ew & Iw). subst. f_equal.
      exact (ascending_one _ _ (row_ascending v) a x y Iu Iw).
    - intros s a (v & E) (u & Su) (w & Sw). subst. destruct (choiceless_step v _ u Su) as (x & _ & Iu).
      destruct (choiceless_step v a w Sw) as (y & _ & Iw).
      exact (ascending_tick _ _ (row_ascending v) x a y Iu Iw).
  Qed.
End Graph.

(** 3. Refinements of deterministic processes are deterministic. *)
Section Refined.
  Context {A B : Type}.
  Variable spec : lts A.
  Variable impl : lts B.

  (* A state that does not diverge leads to a state that refuses nothing but itself. Nobody says which. *)
  Lemma settles : forall t s, reach impl (init impl) t s -> ~ diverges impl s -> ~ ~ failures impl t (fun _ => False).
  Proof.
    intros t s R ND N. apply ND. revert s R ND. cofix self. intros s R ND.
    destruct (offers (succ impl s) tau) eqn:O.
    - apply offers_can in O. destruct O as (u & St). apply (diverges_step impl s u St).
      assert (Ru := reach_app_tau impl _ _ _ _ R St). apply (self u Ru). intros D. exact (ND (diverges_step impl s u St D)).
    - exfalso. apply N. exists s. split; [ exact R |]. destruct (offers (succ impl s) tick) eqn:T.
      + left. split; [ apply offers_can; exact T | auto ].
      + right. rewrite <- !offers_can, O, T. split; [ discriminate | split; [ discriminate | intros a [] ]].
  Qed.
  Theorem deterministic_refined : forall m, m <> T -> refines m spec impl -> deterministic m spec -> deterministic m impl.
  Proof.
    intros m Hm R [N D]. destruct m; [ congruence | |].
    - destruct R as [RT RF]. split; [| exact I ]. intros t a Ht Hf. exact (N t a (RT _ Ht) (RF _ _ Hf)).
    - destruct R as [RD RF]. assert (ND : forall t, ~ divergences spec t).
      { intros t (t1 & t2 & s & _ & K & V). exact (D t1 s K V). }
      assert (DI : divergence_free impl).
      { intros t s K V. apply (ND t), RD. exists t, [], s. rewrite app_nil_r. auto. }
      split; [| exact DI ]. intros t a (s & K) Hf.
      destruct (RF t _ (or_introl Hf)) as [F | V]; [| exact (ND t V) ].
      apply (settles _ _ K (DI _ _ K)). intros F2.
      destruct (RF _ _ (or_introl F2)) as [(u & Ru & _) | V]; [| exact (ND _ V) ].
      exact (N t a (ex_intro _ u Ru) F).
  Qed.
End Refined.
