(* SPDX-License-Identifier: Apache-2.0 *)
(* Proves that a check may replace the target of a transition by another state, to which strongly confluent taus lead
   (docs/search.md, "Confluent taus"). *)
From Coq Require Import List Bool ZArith Lia Uint63.
From Certify Require Import Claims.
Import ListNotations.

(* The targets of all transitions are led to their representatives. *)
Definition led {S} (lead : S -> S) (P : lts S) : lts S :=
  {| init := lead (init P); succ := fun s => map (fun m : ev * S => (fst m, lead (snd m))) (succ P s) |}.

Section Led.
  Context {S : Type}.
  Variable P : lts S.
  Variable good : S -> Prop.
  Hypothesis good_init : good (init P).
  Hypothesis good_step : forall s a u, good s -> step P s a u -> good u.
  Variable followed : S -> S -> Prop.
  Hypothesis followed_tau : forall s t, good s -> followed s t -> step P s tau t.
  Hypothesis confluent : forall s t a u, good s -> followed s t -> step P s a u ->
    (a = tau /\ u = t) \/ exists v, step P t a v /\ followed u v.
  Variable lead : S -> S.

  (* k followed taus lead from s to t. *)
  Inductive row : nat -> S -> S -> Prop :=
  | row_none : forall s, row 0 s s
  | row_more : forall k s t u, followed s t -> row k t u -> row (Datatypes.S k) s u.
  Hypothesis lead_row : forall s, good s -> exists k, row k s (lead s).

  Lemma row_good : forall k s t, row k s t -> good s -> good t.
  Proof. induction 1 as [| k s t u F _ IH]; intros G; [ exact G |]. apply IH, (good_step s tau); auto. Qed.
  Lemma row_join : forall k s t, row k s t -> forall j u, row j t u -> row (k + j) s u.
  Proof. induction 1; intros j v R; cbn; [ exact R | apply (row_more _ _ t); auto ]. Qed.

  (* The last state of a row answers each transition of the first, or the transition is the first tau of the row. *)
  Lemma row_step : forall k s t, row k s t -> good s -> forall a u, step P s a u ->
    (exists v, step P t a v /\ row k u v) \/ (a = tau /\ exists j, k = Datatypes.S j /\ row j u t).
  Proof.
    induction 1 as [s | k s x t F R IH]; intros G a u St.
    - left. exists u. split; [ exact St | constructor ].
    - destruct (confluent _ _ _ _ G F St) as [[Ea Eu] | (y & Sy & Fy)].
      + right. subst. eauto.
      + destruct (IH (good_step _ _ _ G (followed_tau _ _ G F)) a y Sy) as [(v & Sv & Rv) | (Ea & j & Ek & Rj)].
        * left. exists v. split; [ exact Sv | exact (row_more _ _ _ _ Fy Rv) ].
        * right. split; [ exact Ea |]. exists k. subst. split; [ reflexivity | exact (row_more _ _ _ _ Fy Rj) ].
  Qed.
  Lemma led_step : forall s a u, step P s a u -> step (led lead P) s a (lead u).
  Proof. intros s a u H. apply in_map_iff. exists (a, u). auto. Qed.
  Lemma led_can : forall s a, can (led lead P) s a <-> can P s a.
  Proof.
    intros s a. split; intros (u & H).
    - apply in_map_iff in H. destruct H as ([b v] & E & H). cbn in E. inversion E. subst. exists v. exact H.
    - exists (lead u). apply led_step, H.
  Qed.

  Lemma led_reach : forall s t u, reach P s t u -> good s -> forall k r, row k s r ->
    exists r' k', reach (led lead P) r t r' /\ row k' u r' /\ good u.
  Proof.
    induction 1 as [s | s u t v St R IH | s a u t v Ha St R IH]; intros G k r W.
    - exists r, k. split; [ constructor | auto ].
    - pose proof (good_step _ _ _ G St) as Gu.
      destruct (row_step _ _ _ W G _ _ St) as [(y & Sy & Ry) | (E & j & Ek & Rj)]; [| exact (IH Gu _ _ Rj) ].
      destruct (lead_row y (row_good _ _ _ Ry Gu)) as (i & Ri).
      destruct (IH Gu _ _ (row_join _ _ _ Ry _ _ Ri)) as (r' & k' & Rr & Rk & Gv).
      exists r', k'. split; [| auto ]. apply (reach_tau _ r (lead y)); [ apply led_step, Sy | exact Rr ].
    - pose proof (good_step _ _ _ G St) as Gu.
      destruct (row_step _ _ _ W G _ _ St) as [(y & Sy & Ry) | (E & _)]; [| congruence ].
      destruct (lead_row y (row_good _ _ _ Ry Gu)) as (i & Ri).
      destruct (IH Gu _ _ (row_join _ _ _ Ry _ _ Ri)) as (r' & k' & Rr & Rk & Gv).
      exists r', k'. split; [| auto ]. apply (reach_vis _ r a (lead y)); [ exact Ha | apply led_step, Sy | exact Rr ].
  Qed.
  Lemma led_reach_init : forall t u, reach P (init P) t u ->
    exists r k, reach (led lead P) (init (led lead P)) t r /\ row k u r /\ good u.
  Proof.
    intros t u R. destruct (lead_row _ good_init) as (k & W). exact (led_reach _ _ _ R good_init k _ W).
  Qed.
  Lemma row_refuses : forall k s r X, row k s r -> good s -> refuses P s X -> refuses (led lead P) r X.
  Proof.
    intros k s r X W G [[(u & H1) H2] | (H1 & H2 & H3)].
    - left. split; [| exact H2 ]. destruct (row_step _ _ _ W G _ _ H1) as [(v & Sv & _) | (E & _)].
      + apply led_can. exists v. exact Sv.
      + exfalso. assert (N : (tick =? tau)%uint63 = false) by reflexivity. rewrite E, eqb_refl in N. discriminate.
    - right. destruct W as [s | k s t u F W]; [| exfalso; apply H1; exists t; auto ].
      split; [ rewrite led_can; exact H1 | split; [ rewrite led_can; exact H2 |]].
      intros a Xa. rewrite led_can. exact (H3 a Xa).
  Qed.
  Lemma row_diverges : forall k s r, row k s r -> good s -> diverges P s ->
    exists y, step P r tau y /\ exists j u, row j u (lead y) /\ good u /\ diverges P u.
  Proof.
    induction k as [k IH] using lt_wf_ind. intros s r W G D. destruct D as [s u St D].
    pose proof (good_step _ _ _ G St) as Gu. destruct (row_step _ _ _ W G _ _ St) as [(y & Sy & Ry) | (_ & j & Ek & Rj)].
    - exists y. split; [ exact Sy |]. destruct (lead_row y (row_good _ _ _ Ry Gu)) as (i & Ri).
      exists (k + i)%nat, u. split; [ exact (row_join _ _ _ Ry _ _ Ri) | auto ].
    - apply (IH j ltac:(lia) u r Rj Gu D).
  Qed.
  Lemma led_diverges : forall k s r, row k s r -> good s -> diverges P s -> diverges (led lead P) r.
  Proof.
    cofix self. intros k s r W G D. destruct (row_diverges k s r W G D) as (y & Sy & j & u & R & Gu & Du).
    apply (diverges_step _ r (lead y)); [ apply led_step, Sy | exact (self j u (lead y) R Gu Du) ].
  Qed.

  Theorem led_implementation : forall A m (spec : lts A), refines m spec (led lead P) -> refines m spec P.
  Proof.
    intros A m spec H.
    assert (HT : forall t, traces P t -> traces (led lead P) t).
    { intros t (u & R). destruct (led_reach_init _ _ R) as (r & k & Rr & _). exists r. exact Rr. }
    assert (HF : forall t X, failures P t X -> failures (led lead P) t X).
    { intros t X (u & R & Q). destruct (led_reach_init _ _ R) as (r & k & Rr & W & G). exists r.
      split; [ exact Rr | exact (row_refuses k u r X W G Q) ]. }
    assert (HD : forall t, divergences P t -> divergences (led lead P) t).
    { intros t (t1 & t2 & u & E & R & D). destruct (led_reach_init _ _ R) as (r & k & Rr & W & G). exists t1, t2, r.
      split; [ exact E | split; [ exact Rr | exact (led_diverges k u r W G D) ]]. }
    destruct m; cbn in *.
    - auto.
    - destruct H as [H1 H2]. split; auto.
    - destruct H as [H1 H2]. split; [ auto |]. intros t X [K | K]; apply H2; [ left | right ]; auto.
  Qed.
  Theorem led_property : forall p, satisfies p (led lead P) -> satisfies p P.
  Proof.
    assert (HL : deadlock_free (led lead P) -> deadlock_free P).
    { intros H t s R. destruct (led_reach_init _ _ R) as (r & k & Rr & W & G).
      destruct W as [s | k s u r F W]; [| exists tau, u; auto ].
      destruct (H t s Rr) as (a & K). exists a. apply led_can, K. }
    assert (HD : divergence_free (led lead P) -> divergence_free P).
    { intros H t s R D. destruct (led_reach_init _ _ R) as (r & k & Rr & W & G).
      exact (H t r Rr (led_diverges k s r W G D)). }
    intros []; cbn; tauto.
  Qed.
End Led.

(* Deadlock freedom does not depend on the names of events, so every event may be taken for a tau. *)
Definition hidden {S} (P : lts S) : lts S := {| init := init P; succ := fun s => map (fun m => (tau, snd m)) (succ P s) |}.
Lemma hidden_step : forall S (P : lts S) s b u, step (hidden P) s b u <-> b = tau /\ exists a, step P s a u.
Proof.
  intros S P s b u. unfold step. cbn. rewrite in_map_iff. split.
  - intros ([a v] & E & H). cbn in E. inversion E. subst. eauto.
  - intros (E & a & H). exists (a, u). subst. auto.
Qed.
Theorem hidden_deadlock_free : forall S (P : lts S), deadlock_free (hidden P) -> deadlock_free P.
Proof.
  intros S P H.
  assert (K : forall s t u, reach P s t u -> reach (hidden P) s [] u).
  { induction 1 as [s | s u t v St R IH | s a u t v _ St R IH]; [ constructor | |];
      apply (reach_tau _ s u); auto; apply hidden_step; eauto. }
  intros t s R. destruct (H [] s (K _ _ _ R)) as (b & u & St). apply hidden_step in St.
  destruct St as (_ & a & St). exists a, u. exact St.
Qed.
