(* SPDX-License-Identifier: Apache-2.0 *)
(* Proves that a check may replace the target of a transition by another state: by a state to which strongly confluent taus
   lead, by its image under an automorphism, or by both in any order (docs/search.md, "Confluent taus" and "Symmetry"). *)
From Coq Require Import List Bool ZArith Lia Uint63.
From Certify Require Import Claims Certificate.
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
  (* `named` contains, for each automorphism, the function that returns, for the image of an event, the event. *)
  Variable named : (ev -> ev) -> Prop.
  Definition keeps (a b : ev) : Prop := (a = tau <-> b = tau) /\ (a = tick <-> b = tick).
  Inductive alike : ev -> ev -> Prop :=
  | alike_same : forall a, alike a a
  | alike_more : forall f b c, named f -> keeps (f b) b -> alike b c -> alike (f b) c.
  Lemma alike_keeps : forall a b, alike a b -> keeps a b.
  Proof. induction 1 as [a | f b c _ K _ IH]; [ unfold keeps; tauto |]. unfold keeps in *. tauto. Qed.
  Lemma alike_tau : forall a b, alike a b -> (a = tau <-> b = tau).
  Proof. intros a b H. exact (proj1 (alike_keeps a b H)). Qed.
  Lemma alike_trans : forall a b, alike a b -> forall c, alike b c -> alike a c.
  Proof. induction 1 as [a | f b c N K _ IH]; intros d H; [ exact H | apply alike_more; auto ]. Qed.
  Variable followed : S -> S -> Prop.
  Hypothesis followed_tau : forall s t, good s -> followed s t -> step P s tau t.
  Hypothesis confluent : forall s t a u, good s -> followed s t -> step P s a u ->
    (a = tau /\ u = t) \/ exists v, step P t a v /\ followed u v.
  Variable image : (ev -> ev) -> S -> S -> Prop.
  Hypothesis image_named : forall f s t, image f s t -> named f.
  Hypothesis image_good : forall f s t, good s -> image f s t -> good t.
  Hypothesis image_step : forall f s t a u, good s -> image f s t -> step P s a u ->
    exists b v, a = f b /\ keeps a b /\ step P t b v /\ image f u v.
  Hypothesis image_can : forall f s t b, good s -> image f s t -> can P t b -> keeps (f b) b /\ can P s (f b).
  Variable lead : S -> S.

  (* k followed taus and any number of automorphisms lead from s to t. *)
  Inductive row : nat -> S -> S -> Prop :=
  | row_none : forall s, row 0 s s
  | row_more : forall k s t u, followed s t -> row k t u -> row (Datatypes.S k) s u
  | row_image : forall f k s t u, image f s t -> row k t u -> row k s u.
  Hypothesis lead_row : forall s, good s -> exists k, row k s (lead s).

  Lemma row_good : forall k s t, row k s t -> good s -> good t.
  Proof.
    induction 1 as [| k s t u F _ IH | f k s t u I _ IH]; intros G; [ exact G | apply IH, (good_step s tau); auto |].
    exact (IH (image_good _ _ _ G I)).
  Qed.
  Lemma row_join : forall k s t, row k s t -> forall j u, row j t u -> row (k + j) s u.
  Proof.
    induction 1 as [| k s t u F _ IH | f k s t u I _ IH]; intros j v R; cbn; [ exact R | |].
    - exact (row_more _ _ t _ F (IH _ _ R)).
    - exact (row_image _ _ _ t _ I (IH _ _ R)).
  Qed.

  (* The last state of a row answers each transition of the first, or the transition is the first tau of the row. *)
  Lemma row_step : forall k s t, row k s t -> good s -> forall a u, step P s a u ->
    (exists b v, alike a b /\ step P t b v /\ row k u v) \/ (a = tau /\ exists j, k = Datatypes.S j /\ row j u t).
  Proof.
    induction 1 as [s | k s x t F R IH | f k s x t I R IH]; intros G a u St.
    - left. exists a, u. split; [ apply alike_same | split; [ exact St | constructor ]].
    - destruct (confluent _ _ _ _ G F St) as [[Ea Eu] | (y & Sy & Fy)].
      + right. subst. eauto.
      + destruct (IH (good_step _ _ _ G (followed_tau _ _ G F)) a y Sy) as [(b & v & A & Sv & Rv) | (Ea & j & Ek & Rj)].
        * left. exists b, v. split; [ exact A | split; [ exact Sv | exact (row_more _ _ _ _ Fy Rv) ]].
        * right. split; [ exact Ea |]. exists k. subst. split; [ reflexivity | exact (row_more _ _ _ _ Fy Rj) ].
    - destruct (image_step _ _ _ _ _ G I St) as (b & y & Ea & K & Sy & Iy). subst a.
      destruct (IH (image_good _ _ _ G I) b y Sy) as [(c & v & A & Sv & Rv) | (Eb & j & Ek & Rj)].
      + left. exists c, v. split; [ exact (alike_more f b c (image_named _ _ _ I) K A) |].
        split; [ exact Sv | exact (row_image _ _ _ _ _ Iy Rv) ].
      + right. split; [ apply K, Eb |]. exists j. split; [ exact Ek | exact (row_image _ _ _ _ _ Iy Rj) ].
  Qed.
  (* What the last state of a row can do, the first can do too, or it is not stable. *)
  Lemma row_can : forall k s r, row k s r -> good s -> can P s tau \/ forall b, can P r b -> exists a, alike a b /\ can P s a.
  Proof.
    induction 1 as [s | k s t u F R IH | f k s t u I R IH]; intros G.
    - right. intros b C. exists b. split; [ apply alike_same | exact C ].
    - left. exists t. auto.
    - destruct (IH (image_good _ _ _ G I)) as [C | C].
      + left. destruct (image_can _ _ _ _ G I C) as [K Ca]. rewrite (proj2 (proj1 K) eq_refl) in Ca. exact Ca.
      + right. intros b Cb. destruct (C b Cb) as (a & A & Ca). destruct (image_can _ _ _ _ G I Ca) as [K Cc].
        exists (f a). split; [ exact (alike_more f a b (image_named _ _ _ I) K A) | exact Cc ].
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
    exists t' r' k', reach (led lead P) r t' r' /\ Forall2 alike t t' /\ row k' u r' /\ good u.
  Proof.
    induction 1 as [s | s u t v St R IH | s a u t v Ha St R IH]; intros G k r W.
    - exists [], r, k. split; [ constructor | auto ].
    - pose proof (good_step _ _ _ G St) as Gu.
      destruct (row_step _ _ _ W G _ _ St) as [(b & y & A & Sy & Ry) | (E & j & Ek & Rj)]; [| exact (IH Gu _ _ Rj) ].
      destruct (lead_row y (row_good _ _ _ Ry Gu)) as (i & Ri).
      destruct (IH Gu _ _ (row_join _ _ _ Ry _ _ Ri)) as (t' & r' & k' & Rr & L & Rk & Gv).
      exists t', r', k'. split; [| auto ]. rewrite (proj1 (alike_tau _ _ A) eq_refl) in Sy.
      apply (reach_tau _ r (lead y)); [ apply led_step, Sy | exact Rr ].
    - pose proof (good_step _ _ _ G St) as Gu.
      destruct (row_step _ _ _ W G _ _ St) as [(b & y & A & Sy & Ry) | (E & _)]; [| congruence ].
      destruct (lead_row y (row_good _ _ _ Ry Gu)) as (i & Ri).
      destruct (IH Gu _ _ (row_join _ _ _ Ry _ _ Ri)) as (t' & r' & k' & Rr & L & Rk & Gv).
      exists (b :: t'), r', k'. split; [| auto ]. apply (reach_vis _ r b (lead y)); [| apply led_step, Sy | exact Rr ].
      intros E. apply Ha, (alike_tau _ _ A), E.
  Qed.
  Lemma led_reach_init : forall t u, reach P (init P) t u ->
    exists t' r k, reach (led lead P) (init (led lead P)) t' r /\ Forall2 alike t t' /\ row k u r /\ good u.
  Proof.
    intros t u R. destruct (lead_row _ good_init) as (k & W). exact (led_reach _ _ _ R good_init k _ W).
  Qed.
  Lemma row_diverges : forall k s r, row k s r -> good s -> diverges P s ->
    exists y, step P r tau y /\ exists j u, row j u (lead y) /\ good u /\ diverges P u.
  Proof.
    induction k as [k IH] using lt_wf_ind. intros s r W G D. destruct D as [s u St D].
    pose proof (good_step _ _ _ G St) as Gu.
    destruct (row_step _ _ _ W G _ _ St) as [(b & y & A & Sy & Ry) | (_ & j & Ek & Rj)].
    - rewrite (proj1 (alike_tau _ _ A) eq_refl) in Sy. exists y. split; [ exact Sy |].
      destruct (lead_row y (row_good _ _ _ Ry Gu)) as (i & Ri).
      exists (k + i)%nat, u. split; [ exact (row_join _ _ _ Ry _ _ Ri) | auto ].
    - apply (IH j ltac:(lia) u r Rj Gu D).
  Qed.
  Lemma led_diverges : forall k s r, row k s r -> good s -> diverges P s -> diverges (led lead P) r.
  Proof.
    cofix self. intros k s r W G D. destruct (row_diverges k s r W G D) as (y & Sy & j & u & R & Gu & Du).
    apply (diverges_step _ r (lead y)); [ apply led_step, Sy | exact (self j u (lead y) R Gu Du) ].
  Qed.

  Theorem led_property : forall p, satisfies p (led lead P) -> satisfies p P.
  Proof.
    assert (HL : deadlock_free (led lead P) -> deadlock_free P).
    { intros H t s R. destruct (led_reach_init _ _ R) as (t' & r & k & Rr & _ & W & G).
      destruct (row_can _ _ _ W G) as [C | C]; [ exists tau; exact C |].
      destruct (H t' r Rr) as (a & K). apply led_can in K. destruct (C a K) as (b & _ & Cb). exists b. exact Cb. }
    assert (HD : divergence_free (led lead P) -> divergence_free P).
    { intros H t s R D. destruct (led_reach_init _ _ R) as (t' & r & k & Rr & _ & W & G).
      exact (H t' r Rr (led_diverges k s r W G D)). }
    intros []; cbn; tauto.
  Qed.

  (* For refinement, the normal form must be indifferent to the automorphisms. *)
  Variable N : normal_form.
  Variable known : int -> Prop.
  Hypothesis known_root : known (root N).
  Hypothesis known_after : forall n a k, known n -> after N n a = Some k -> known k.
  Definition indifferent (f : ev -> ev) : Prop := forall n, known n ->
    (forall b k, after N n b = Some k -> after N n (f b) = Some k) /\
    forall i, (i <? acceptance_count N n)%uint63 = true ->
      exists j, (j <? acceptance_count N n)%uint63 = true /\
        forall a, In a (acceptance N n j) -> exists b, In b (acceptance N n i) /\ a = f b.
  Hypothesis all_indifferent : forall f, named f -> indifferent f.

  Lemma alike_after : forall a b, alike a b -> forall n k, known n -> after N n b = Some k -> after N n a = Some k.
  Proof.
    induction 1 as [a | f b c Nf _ _ IH]; intros n k Kn H; [ exact H |]. apply (all_indifferent f Nf n Kn). apply IH; assumption.
  Qed.
  Lemma alike_run : forall t t' n k, nrun N n t' k -> Forall2 alike t t' -> known n -> nrun N n t k.
  Proof.
    intros t t' n k R. revert t. induction R as [n | n b m t' k Hb A R IH]; intros t L Kn; inversion L as [| a ? s ? Aab Ls]; subst.
    - constructor.
    - apply (nrun_step N n a m); [| exact (alike_after _ _ Aab n m Kn A) | exact (IH s Ls (known_after _ _ _ Kn A)) ].
      intros E. apply Hb, (alike_tau _ _ Aab), E.
  Qed.
  Lemma row_accepts : forall k s r, row k s r -> good s -> ~ can P s tau -> forall n, known n ->
    (exists i, (i <? acceptance_count N n)%uint63 = true /\ forall a, In a (acceptance N n i) -> can P r a) ->
    exists i, (i <? acceptance_count N n)%uint63 = true /\ forall a, In a (acceptance N n i) -> can P s a.
  Proof.
    induction 1 as [s | k s t u F R IH | f k s t u I R IH]; intros G Nu n Kn H; [ exact H | |].
    - exfalso. apply Nu. exists t. auto.
    - assert (Nt : ~ can P t tau).
      { intros C. destruct (image_can _ _ _ _ G I C) as [K Ca]. rewrite (proj2 (proj1 K) eq_refl) in Ca. contradiction. }
      destruct (IH (image_good _ _ _ G I) Nt n Kn H) as (i & Hi & C).
      destruct (all_indifferent f (image_named _ _ _ I) n Kn) as [_ D]. destruct (D i Hi) as (j & Hj & E).
      exists j. split; [ exact Hj |]. intros a Ha. destruct (E a Ha) as (b & Hb & Ea). subst a.
      exact (proj2 (image_can _ _ _ _ G I (C b Hb))).
  Qed.
  Lemma row_offers : forall k s r n, row k s r -> good s -> known n -> offers_acceptance N (led lead P) r n ->
    offers_acceptance N P s n.
  Proof.
    intros k s r n W G Kn [O1 O2]. split.
    - intros (u & St). destruct (row_step _ _ _ W G _ _ St) as [(b & v & A & Sv & _) | (E & _)].
      + apply O1, led_can. exists v. rewrite (proj1 (proj2 (alike_keeps _ _ A)) eq_refl) in Sv. exact Sv.
      + exfalso. assert (K : (tick =? tau)%uint63 = false) by reflexivity. rewrite E, eqb_refl in K. discriminate.
    - intros Nu Nt. destruct (row_can _ _ _ W G) as [C | C]; [ contradiction |].
      assert (K : forall b, can P r b -> exists a, alike a b /\ can P s a) by exact C.
      destruct O2 as (i & Hi & A).
      + rewrite led_can. intros Cr. destruct (K _ Cr) as (a & A & Ca). rewrite (proj2 (alike_tau _ _ A) eq_refl) in Ca. contradiction.
      + rewrite led_can. intros Cr. destruct (K _ Cr) as (a & A & Ca).
        rewrite (proj2 (proj2 (alike_keeps _ _ A)) eq_refl) in Ca. contradiction.
      + apply (row_accepts k s r W G Nu n Kn). exists i. split; [ exact Hi |]. intros a Ha. apply led_can. exact (A a Ha).
  Qed.
  Lemma known_run : forall n t k, nrun N n t k -> known n -> known k.
  Proof. induction 1 as [n | n a k t m _ A _ IH]; intros Kn; [ exact Kn | exact (IH (known_after _ _ _ Kn A)) ]. Qed.

  Theorem led_within : forall m, within m N (led lead P) -> within m N P.
  Proof.
    intros m H t u R. destruct (led_reach_init _ _ R) as (t' & r & k & Rr & L & W & G).
    destruct (H t' r Rr) as [(n & Kr & O & D) | (t1 & t2 & n & E & Kr & D)].
    - left. exists n. pose proof (known_run _ _ _ Kr known_root) as Kn.
      split; [ exact (alike_run _ _ _ _ Kr L known_root) | split ].
      + intros Hm. exact (row_offers k u r n W G Kn (O Hm)).
      + intros Em Du. exact (D Em (led_diverges k u r W G Du)).
    - right. subst t'. apply Forall2_app_inv_r in L. destruct L as (s1 & s2 & L1 & _ & E). exists s1, s2, n.
      split; [ exact E | split; [ exact (alike_run _ _ _ _ Kr L1 known_root) | exact D ]].
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
