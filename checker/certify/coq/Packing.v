(* SPDX-License-Identifier: Apache-2.0 *)
(* Represents states by words: the state of a component takes some bits of a word, and a process has as many words as it
   needs. So states of any width fit. Proves that this is a functional bisimulation, which preserves all claims. *)
From Coq Require Import List Bool ZArith Lia Uint63.
From Certify Require Import Claims Processes Loops Moves.
Import ListNotations.
Open Scope uint63_scope.

(* Refinement is a preorder. *)
Lemma refines_refl : forall S m (P : lts S), refines m P P.
Proof. intros S [] P; cbn; auto. Qed.
Lemma refines_trans : forall S1 S2 S3 m (P : lts S1) (Q : lts S2) (R : lts S3),
  refines m P Q -> refines m Q R -> refines m P R.
Proof. intros S1 S2 S3 [] P Q R H K; cbn in *; [ auto | |]; destruct H, K; auto. Qed.

(** Functional bisimulations: A's states are mapped to those of B. *)
Section Morphism.
  Context {SA SB : Type}.
  Variable A : lts SA.
  Variable B : lts SB.
  Variable f : SA -> SB.
  Variable good : SA -> Prop.
  Hypothesis good_init : good (init A).
  Hypothesis good_step : forall s a u, good s -> step A s a u -> good u.
  Hypothesis f_init : init B = f (init A).
  Hypothesis f_step : forall s, good s -> forall a w,
    step B (f s) a w <-> exists u, w = f u /\ step A s a u.

  Lemma morphism_reach : forall s t u, reach A s t u -> good s -> reach B (f s) t (f u) /\ good u.
  Proof.
    induction 1 as [s | s u t v St R IH | s a u t v Ha St R IH]; intros G.
    - split; [ constructor | exact G ].
    - destruct (IH (good_step _ _ _ G St)) as [R' G']. split; [| exact G' ].
      apply (reach_tau B _ (f u)); [ apply f_step; eauto | exact R' ].
    - destruct (IH (good_step _ _ _ G St)) as [R' G']. split; [| exact G' ].
      apply (reach_vis B _ a (f u)); [ exact Ha | apply f_step; eauto | exact R' ].
  Qed.
  Lemma morphism_can : forall s a, good s -> (can B (f s) a <-> can A s a).
  Proof.
    intros s a G. split.
    - intros (w & H). apply f_step in H; [| exact G ]. destruct H as (u & _ & H). exists u. exact H.
    - intros (u & H). exists (f u). apply f_step; eauto.
  Qed.
  Lemma morphism_refuses : forall s X, good s -> refuses A s X -> refuses B (f s) X.
  Proof.
    intros s X G [[H1 H2] | (H1 & H2 & H3)]; [ left | right ].
    - split; [ apply morphism_can; assumption | exact H2 ].
    - split; [| split ].
      + intros H. apply H1. apply morphism_can; assumption.
      + intros H. apply H2. apply morphism_can; assumption.
      + intros a Xa H. apply (H3 a Xa). apply morphism_can; assumption.
  Qed.
  Lemma morphism_diverges : forall s, diverges A s -> good s -> diverges B (f s).
  Proof.
    cofix self. intros s D. destruct D as [s u St D]. intros G. apply (diverges_step B (f s) (f u)).
    - apply f_step; eauto.
    - apply self; [ exact D | exact (good_step _ _ _ G St) ].
  Qed.
  Lemma morphism_refines : forall SC m (spec : lts SC), refines m spec B -> refines m spec A.
  Proof.
    intros SC m spec H.
    assert (HT : forall t, traces A t -> traces B t).
    { intros t (u & R). exists (f u). rewrite f_init. apply morphism_reach; assumption. }
    assert (HF : forall t X, failures A t X -> failures B t X).
    { intros t X (u & R & Q). destruct (morphism_reach _ _ _ R good_init) as [R' G].
      exists (f u). rewrite f_init. split; [ exact R' | apply morphism_refuses; assumption ]. }
    assert (HD : forall t, divergences A t -> divergences B t).
    { intros t (t1 & t2 & u & E & R & D). destruct (morphism_reach _ _ _ R good_init) as [R' G].
      exists t1, t2, (f u). rewrite f_init. split; [ exact E | split; [ exact R' | apply morphism_diverges; assumption ]]. }
    destruct m; cbn in *.
    - auto.
    - destruct H as [H1 H2]. split; auto.
    - destruct H as [H1 H2]. split; [ auto |]. intros t X [K | K]; apply H2; [ left | right ]; auto.
  Qed.
  Lemma morphism_satisfies : forall p, satisfies p B -> satisfies p A.
  Proof.
    assert (HL : deadlock_free B -> deadlock_free A).
    { intros H t s R. destruct (morphism_reach _ _ _ R good_init) as [R' G].
      destruct (H t (f s)) as (a & K); [ rewrite f_init; exact R' |]. exists a. apply morphism_can; assumption. }
    assert (HD : divergence_free B -> divergence_free A).
    { intros H t s R D. destruct (morphism_reach _ _ _ R good_init) as [R' G].
      apply (H t (f s)); [ rewrite f_init; exact R' | apply morphism_diverges; assumption ]. }
    intros []; cbn; tauto.
  Qed.

  (* The opposite direction, for the specification. *)
  Lemma back_reach : forall x t w, reach B x t w -> forall s, x = f s -> good s ->
    exists u, w = f u /\ good u /\ reach A s t u.
  Proof.
    induction 1 as [x | x y t w St R IH | x a y t w Ha St R IH]; intros s E G; subst.
    - exists s. repeat split; [ exact G | constructor ].
    - apply f_step in St; [| exact G ]. destruct St as (u & E & St).
      destruct (IH u E (good_step _ _ _ G St)) as (v & Ev & Gv & Rv). exists v. repeat split; auto.
      apply (reach_tau A s u); assumption.
    - apply f_step in St; [| exact G ]. destruct St as (u & E & St).
      destruct (IH u E (good_step _ _ _ G St)) as (v & Ev & Gv & Rv). exists v. repeat split; auto.
      apply (reach_vis A s a u); assumption.
  Qed.
  Lemma back_refuses : forall s X, good s -> refuses B (f s) X -> refuses A s X.
  Proof.
    intros s X G H. pose proof (fun a => morphism_can s a G) as C.
    destruct H as [[H1 H2] | (H1 & H2 & H3)]; [ left | right ].
    - split; [ apply C; exact H1 | exact H2 ].
    - split; [| split ]; [ intros K; apply H1, C, K | intros K; apply H2, C, K |].
      intros a Xa K. apply (H3 a Xa), C, K.
  Qed.
  Lemma back_diverges : forall s, good s -> diverges B (f s) -> diverges A s.
  Proof.
    cofix self. intros s G D. inversion D as [x w St D' E]. subst.
    apply f_step in St; [| exact G ]. destruct St as (u & E & St). subst.
    apply (diverges_step A s u St). apply self; [ exact (good_step _ _ _ G St) | exact D' ].
  Qed.
  Lemma back_refines : forall SC m (impl : lts SC), refines m B impl -> refines m A impl.
  Proof.
    intros SC m impl H.
    assert (HT : forall t, traces B t -> traces A t).
    { intros t (w & R). destruct (back_reach _ _ _ R (init A) f_init good_init) as (u & _ & _ & R'). exists u. exact R'. }
    assert (HF : forall t X, failures B t X -> failures A t X).
    { intros t X (w & R & Q). destruct (back_reach _ _ _ R (init A) f_init good_init) as (u & E & G & R').
      subst. exists u. split; [ exact R' | apply back_refuses; assumption ]. }
    assert (HD : forall t, divergences B t -> divergences A t).
    { intros t (t1 & t2 & w & E & R & D). destruct (back_reach _ _ _ R (init A) f_init good_init) as (u & Eu & G & R').
      subst. exists t1, t2, u. split; [ reflexivity | split; [ exact R' | apply back_diverges; assumption ]]. }
    destruct m; cbn in *.
    - auto.
    - destruct H as [H1 H2]. split; auto.
    - destruct H as [H1 H2]. split; [ auto |]. intros t X K. destruct (H2 t X K) as [K' | K']; [ left | right ]; auto.
  Qed.
  Lemma morphism_possible : forall G, stays_possible G B -> stays_possible G A.
  Proof.
    intros G K t s R. destruct (morphism_reach _ _ _ R good_init) as [R' Gs].
    destruct (K t (f s)) as (t2 & w & a & Rw & Ga & C); [ rewrite f_init; exact R' |].
    destruct (back_reach _ _ _ Rw s eq_refl Gs) as (u & E & Gu & Ru). subst w.
    exists t2, u, a. split; [ exact Ru | split; [ exact Ga |]]. apply morphism_can; assumption.
  Qed.
  Lemma back_possible : forall G, stays_possible G A -> stays_possible G B.
  Proof.
    intros G K t w R. destruct (back_reach _ _ _ R _ f_init good_init) as (s & E & Gs & Rs). subst w.
    destruct (K t s Rs) as (t2 & u & a & Ru & Ga & C). destruct (morphism_reach _ _ _ Ru Gs) as [R' Gu].
    exists t2, (f u), a. split; [ exact R' | split; [ exact Ga |]]. apply morphism_can; assumption.
  Qed.
End Morphism.

(** Bits of a word. *)
Fixpoint encode (bs s : list int) : int :=
  match bs, s with b :: bs', v :: s' => v + (encode bs' s' << b) | _, _ => 0 end.
Fixpoint fits (bs s : list int) : bool :=
  match bs, s with [], [] => true | b :: bs', v :: s' => (v <? 1 << b) && fits bs' s' | _, _ => false end.
Fixpoint total (bs : list int) : Z := match bs with [] => 0%Z | b :: bs' => (to_Z b + total bs')%Z end.
Definition narrow (g : list int) : bool := (total g <=? 62)%Z.

Lemma total_nonneg : forall bs, (0 <= total bs)%Z.
Proof. induction bs as [| b bs IH]; cbn [total]; [ lia |]. pose proof (to_Z_bounded b). lia. Qed.
Lemma power_value : forall b, (to_Z b <= 62)%Z -> to_Z (1 << b) = (2 ^ to_Z b)%Z.
Proof.
  intros b H. pose proof (to_Z_bounded b). rewrite lsl_spec. change (to_Z 1) with 1%Z. rewrite Z.mul_1_l.
  apply Z.mod_small. split; [ apply Z.pow_nonneg; lia |]. change wB with (2 ^ 63)%Z. apply Z.pow_lt_mono_r; lia.
Qed.
Lemma power_large : forall n, (0 <= n <= 62)%Z -> (2 ^ n < wB)%Z.
Proof. intros n H. change wB with (2 ^ 63)%Z. apply Z.pow_lt_mono_r; lia. Qed.

Lemma encode_value : forall bs s, fits bs s = true -> (total bs <= 62)%Z ->
  (to_Z (encode bs s) < 2 ^ total bs)%Z /\
  match bs, s with b :: bs', v :: s' => to_Z (encode bs s) = (to_Z v + 2 ^ to_Z b * to_Z (encode bs' s'))%Z | _, _ => True end.
Proof.
  induction bs as [| b bs IH]; intros [| v s] H Ht; cbn [fits] in H; try discriminate.
  - cbn. change (to_Z 0) with 0%Z. split; [ lia | exact I ].
  - apply andb_true_iff in H. destruct H as [Hv H]. apply ltb_spec in Hv. cbn [total] in *.
    pose proof (to_Z_bounded b). pose proof (to_Z_bounded v). pose proof (total_nonneg bs).
    destruct (IH s H ltac:(lia)) as [Hb _]. pose proof (to_Z_bounded (encode bs s)).
    rewrite power_value in Hv by lia. rewrite Z.pow_add_r by lia.
    pose proof (power_large (to_Z b + total bs) ltac:(lia)) as PL. rewrite Z.pow_add_r in PL by lia.
    assert (0 < 2 ^ to_Z b)%Z by (apply Z.pow_pos_nonneg; lia).
    assert (E : to_Z (encode (b :: bs) (v :: s)) = (to_Z v + 2 ^ to_Z b * to_Z (encode bs s))%Z).
    { cbn [encode]. rewrite add_spec, lsl_spec, Z.add_mod_idemp_r by (unfold wB; discriminate).
      rewrite (Z.mul_comm (to_Z (encode bs s))). apply Z.mod_small. nia. }
    rewrite E. split; [ nia | reflexivity ].
Qed.

(* Returns the first bit of component k. *)
Fixpoint offset (bs : list int) (k : nat) : Z :=
  match bs, k with b :: bs', S k' => (to_Z b + offset bs' k')%Z | _, _ => 0%Z end.
Lemma offset_bound : forall bs k b, nth_error bs k = Some b -> (0 <= offset bs k)%Z /\ (offset bs k + to_Z b <= total bs)%Z.
Proof.
  induction bs as [| c bs IH]; intros [| k] b H; cbn [nth_error] in H; try discriminate; cbn [offset total].
  - inversion H. subst. pose proof (total_nonneg bs). lia.
  - destruct (IH k b H). pose proof (to_Z_bounded c). lia.
Qed.
Lemma bits_of : forall bs s k b, fits bs s = true -> (total bs <= 62)%Z -> nth_error bs k = Some b ->
  ((to_Z (encode bs s) / 2 ^ offset bs k) mod 2 ^ to_Z b = to_Z (nth k s 0%uint63))%Z /\ (to_Z (nth k s 0%uint63) < 2 ^ to_Z b)%Z.
Proof.
  induction bs as [| c bs IH]; intros [| v s] k b H Ht Hk; cbn [fits] in H; try discriminate; [ destruct k; discriminate |].
  destruct (encode_value (c :: bs) (v :: s) H Ht) as [_ E]. apply andb_true_iff in H. destruct H as [Hv H].
  apply ltb_spec in Hv. cbn [total] in Ht. pose proof (to_Z_bounded c). pose proof (to_Z_bounded v).
  pose proof (total_nonneg bs). rewrite power_value in Hv by lia. rewrite E.
  assert (P : (0 < 2 ^ to_Z c)%Z) by (apply Z.pow_pos_nonneg; lia).
  destruct k as [| k]; cbn [nth_error] in Hk; cbn [offset nth].
  - inversion Hk. subst c. rewrite Z.pow_0_r, Z.div_1_r. split; [| exact Hv ].
    rewrite Z.mul_comm, Z_mod_plus_full. apply Z.mod_small. lia.
  - destruct (offset_bound bs k b Hk). rewrite Z.pow_add_r by lia. rewrite <- Z.div_div by lia.
    rewrite Z.mul_comm, Z_div_plus_full by lia. rewrite (Z.div_small (to_Z v)) by lia. rewrite Z.add_0_l.
    apply IH; [ exact H | lia | exact Hk ].
Qed.

Lemma update_length : forall s k x, length (update s k x) = length s.
Proof. induction s as [| v s IH]; intros [| k] x; cbn; auto. Qed.
Lemma fits_length : forall bs s, fits bs s = true -> length s = length bs.
Proof.
  induction bs as [| b bs IH]; intros [| v s] H; cbn in *; try discriminate; auto.
  apply andb_true_iff in H. f_equal. apply IH, H.
Qed.
Lemma fits_nth : forall bs s k b, fits bs s = true -> nth_error bs k = Some b -> (nth k s 0 <? 1 << b) = true.
Proof.
  induction bs as [| c bs IH]; intros [| v s] [| k] b H K; cbn [fits nth_error nth] in *; try discriminate;
    apply andb_true_iff in H; [ inversion K; subst; apply H | apply (IH s k b); [ apply H | exact K ]].
Qed.
Lemma fits_update : forall bs s k x b, fits bs s = true -> nth_error bs k = Some b -> (x <? 1 << b) = true ->
  fits bs (update s k x) = true.
Proof.
  induction bs as [| c bs IH]; intros [| v s] [| k] x b H K X; cbn [fits nth_error update] in *; try discriminate; auto;
    apply andb_true_iff in H; apply andb_true_iff; split; try apply H.
  - inversion K. subst. exact X.
  - apply (IH s k x b); [ apply H | exact K | exact X ].
Qed.
Lemma encode_update : forall bs s k b x, fits bs s = true -> (total bs <= 62)%Z -> nth_error bs k = Some b ->
  (x <? 1 << b) = true ->
  to_Z (encode bs (update s k x)) = (to_Z (encode bs s) + (to_Z x - to_Z (nth k s 0%uint63)) * 2 ^ offset bs k)%Z.
Proof.
  induction bs as [| c bs IH]; intros [| v s] k b x H Ht Hk Hx; cbn [fits] in H; try discriminate; [ destruct k; discriminate |].
  assert (HU : fits (c :: bs) (update (v :: s) k x) = true) by exact (fits_update (c :: bs) (v :: s) k x b H Hk Hx).
  destruct (encode_value (c :: bs) (v :: s) H Ht) as [_ E].
  destruct (encode_value (c :: bs) (update (v :: s) k x) HU Ht) as [_ U].
  apply andb_true_iff in H. destruct H as [_ H]. cbn [total] in Ht. pose proof (to_Z_bounded c).
  destruct k as [| k]; cbn [nth_error] in Hk; cbn [offset nth update] in *; rewrite E, U.
  - rewrite Z.pow_0_r. lia.
  - destruct (offset_bound bs k b Hk). pose proof (total_nonneg bs).
    rewrite (IH s k b x H ltac:(lia) Hk Hx), Z.pow_add_r by lia. ring.
Qed.

(** Words. *)
Fixpoint pack (gs : list (list int)) (s : list int) : list int :=
  match gs with [] => [] | g :: gs' => encode g s :: match gs' with [] => [] | _ => pack gs' (skipn (length g) s) end end.

(* The bits that contain the state of a component. *)
Record field := { word : nat; shift : int; mask : int }.
Fixpoint fields_of (w : nat) (from : int) (bs : list int) : list field :=
  match bs with
  | [] => []
  | b :: bs' => {| word := w; shift := from; mask := (1 << b) - 1 |} :: fields_of w (from + b) bs'
  end.
Fixpoint fields (w : nat) (gs : list (list int)) : list field :=
  match gs with [] => [] | g :: gs' => fields_of w 0 g ++ fields (S w) gs' end.

Definition cut (f : field) (w : int) : int := (w >> shift f) land mask f.
Definition changed (f : field) (x w : int) : int := w + ((x - cut f w) << shift f).
Fixpoint replace_word (c : list int) (n : nat) (g : int -> int) : list int :=
  match c with [] => [] | w :: c' => match n with O => g w :: c' | S n' => w :: replace_word c' n' g end end.
Definition read_field (f : field) : list int -> int :=
  match word f with
  | O => fun c => match c with w :: _ => cut f w | [] => cut f 0 end
  | n => fun c => cut f (nth n c 0)
  end.
Lemma read_field_plain : forall f c, read_field f c = cut f (nth (word f) c 0).
Proof. intros [[| n] sh mk] [| w c]; reflexivity. Qed.
Definition write_field (c : list int) (fx : field * int) : list int :=
  let (f, x) := fx in
  match word f, c with
  | O, w :: c' => changed f x w :: c'
  | n, _ => replace_word c n (changed f x)
  end.
Lemma write_field_plain : forall c f x, write_field c (f, x) = replace_word c (word f) (changed f x).
Proof. intros [| w c] [[| n] sh mk] x; reflexivity. Qed.

Lemma fits_split : forall g rest s, fits (g ++ rest) s = true ->
  exists s1 s2, s = s1 ++ s2 /\ fits g s1 = true /\ fits rest s2 = true.
Proof.
  induction g as [| b g IH]; intros rest s H; cbn in H.
  - exists [], s. auto.
  - destruct s as [| v s]; [ discriminate |]. apply andb_true_iff in H. destruct H as [Hv H].
    destruct (IH rest s H) as (s1 & s2 & E & H1 & H2). exists (v :: s1), s2. subst. cbn. rewrite Hv, H1. auto.
Qed.
Lemma encode_prefix : forall g s1 s2, fits g s1 = true -> encode g (s1 ++ s2) = encode g s1.
Proof.
  induction g as [| b g IH]; intros [| v s1] s2 H; cbn in H; try discriminate.
  - destruct s2; reflexivity.
  - apply andb_true_iff in H. cbn. rewrite IH; [ reflexivity | apply H ].
Qed.
Lemma skipn_prefix : forall g s1 s2, fits g s1 = true -> skipn (length g) (s1 ++ s2) = s2.
Proof.
  induction g as [| b g IH]; intros [| v s1] s2 H; cbn in H; try discriminate; [ reflexivity |].
  apply andb_true_iff in H. cbn. apply IH. apply H.
Qed.
Lemma pack_cons : forall g gs s1 s2, fits g s1 = true -> fits (concat gs) s2 = true ->
  pack (g :: gs) (s1 ++ s2) = encode g s1 :: pack gs s2.
Proof.
  intros g gs s1 s2 H1 H2. cbn [pack]. rewrite encode_prefix by exact H1. f_equal. destruct gs as [| g' gs]; [ reflexivity |].
  rewrite skipn_prefix by exact H1. reflexivity.
Qed.

Lemma fields_of_nth : forall bs w from k b, nth_error bs k = Some b -> (to_Z from + total bs <= 62)%Z ->
  exists f, nth_error (fields_of w from bs) k = Some f /\ word f = w /\
    to_Z (shift f) = (to_Z from + offset bs k)%Z /\ mask f = (1 << b) - 1.
Proof.
  induction bs as [| c bs IH]; intros w from [| k] b H Ht; cbn [nth_error] in H; try discriminate; cbn [fields_of nth_error offset].
  - inversion H. subst. eexists. split; [ reflexivity |]. cbn. rewrite Z.add_0_r. auto.
  - cbn [total] in Ht. pose proof (to_Z_bounded from). pose proof (to_Z_bounded c). pose proof (total_nonneg bs).
    assert (E : to_Z (from + c) = (to_Z from + to_Z c)%Z).
    { rewrite add_spec. apply Z.mod_small. change wB with (2 ^ 63)%Z. assert (62 < 2 ^ 63)%Z by reflexivity. lia. }
    destruct (IH w (from + c) k b H ltac:(rewrite E; lia)) as (f & F & W & SH & M). exists f.
    rewrite E in SH. repeat split; auto. lia.
Qed.
Lemma fields_of_length : forall bs w from, length (fields_of w from bs) = length bs.
Proof. induction bs as [| b bs IH]; intros; cbn; auto. Qed.

Lemma cut_spec : forall f w b o, to_Z (shift f) = o -> mask f = (1 << b) - 1 -> (to_Z b <= 62)%Z ->
  to_Z (cut f w) = ((to_Z w / 2 ^ o) mod 2 ^ to_Z b)%Z.
Proof.
  intros f w b o Hs Hm Hb. unfold cut. rewrite land_spec', lsr_spec, Hs, Hm.
  pose proof (to_Z_bounded b). assert (P : (0 < 2 ^ to_Z b)%Z) by (apply Z.pow_pos_nonneg; lia).
  pose proof (power_large (to_Z b) ltac:(lia)).
  assert (E : to_Z ((1 << b) - 1) = Z.ones (to_Z b)).
  { rewrite sub_spec, power_value by lia. change (to_Z 1) with 1%Z. rewrite Z.mod_small by lia.
    rewrite Z.ones_equiv. lia. }
  rewrite E. apply Z.land_ones. lia.
Qed.
Lemma changed_spec : forall bs s k b x f, fits bs s = true -> (total bs <= 62)%Z -> nth_error bs k = Some b ->
  (x <? 1 << b) = true -> to_Z (shift f) = offset bs k -> mask f = (1 << b) - 1 ->
  cut f (encode bs s) = nth k s 0 /\ changed f x (encode bs s) = encode bs (update s k x).
Proof.
  intros bs s k b x f H Ht Hk Hx Hs Hm. destruct (offset_bound bs k b Hk) as [O1 O2]. pose proof (to_Z_bounded b).
  assert (C : cut f (encode bs s) = nth k s 0).
  { apply to_Z_inj. rewrite (cut_spec f _ b _ Hs Hm) by lia. apply (bits_of bs s k b H Ht Hk). }
  split; [ exact C |]. apply to_Z_inj. rewrite (encode_update bs s k b x H Ht Hk Hx). unfold changed. rewrite C.
  rewrite add_spec, lsl_spec, sub_spec, Hs. rewrite Z.add_mod_idemp_r by (unfold wB; discriminate).
  rewrite <- Z.add_mod_idemp_r by (unfold wB; discriminate). rewrite Z.mul_mod_idemp_l by (unfold wB; discriminate).
  rewrite Z.add_mod_idemp_r by (unfold wB; discriminate).
  rewrite <- (encode_update bs s k b x H Ht Hk Hx). apply Z.mod_small. apply to_Z_bounded.
Qed.

Lemma nth_error_concat : forall (gs : list (list int)) g k, (k < length g)%nat -> nth_error (concat (g :: gs)) k = nth_error g k.
Proof. intros. cbn. apply nth_error_app1. exact H. Qed.
Lemma update_app : forall s1 s2 k x, update (s1 ++ s2) k x =
  if Nat.ltb k (length s1) then update s1 k x ++ s2 else s1 ++ update s2 (k - length s1) x.
Proof.
  induction s1 as [| v s1 IH]; intros s2 k x; [ cbn; rewrite Nat.sub_0_r; reflexivity |].
  destruct k as [| k]; [ reflexivity |]. cbn [app update length Nat.sub]. rewrite IH.
  replace (Nat.ltb (S k) (S (length s1))) with (Nat.ltb k (length s1)) by reflexivity.
  destruct (Nat.ltb k (length s1)); reflexivity.
Qed.
Lemma nth_app : forall (s1 s2 : list int) k, nth k (s1 ++ s2) 0 = if Nat.ltb k (length s1) then nth k s1 0 else nth (k - length s1) s2 0.
Proof.
  intros. destruct (Nat.ltb k (length s1)) eqn:L.
  - apply Nat.ltb_lt in L. apply app_nth1. exact L.
  - apply Nat.ltb_ge in L. apply app_nth2. exact L.
Qed.

(* A field reads and writes the state of its component. *)
Lemma field_spec : forall gs w s k b, forallb narrow gs = true -> fits (concat gs) s = true -> nth_error (concat gs) k = Some b ->
  exists f n, nth_error (fields w gs) k = Some f /\ word f = (w + n)%nat /\
    cut f (nth n (pack gs s) 0) = nth k s 0 /\
    forall x, (x <? 1 << b) = true -> replace_word (pack gs s) n (changed f x) = pack gs (update s k x).
Proof.
  induction gs as [| g gs IH]; intros w s k b HN H Hk; [ destruct k; discriminate |].
  cbn in HN. apply andb_true_iff in HN. destruct HN as [HG HN]. unfold narrow in HG. apply Z.leb_le in HG.
  destruct (fits_split _ _ _ H) as (s1 & s2 & E & H1 & H2). subst s. pose proof (fits_length _ _ H1) as L1.
  rewrite pack_cons by assumption. cbn [fields]. rewrite nth_app, L1. setoid_rewrite update_app. setoid_rewrite L1.
  cbn [concat] in Hk. destruct (Nat.ltb k (length g)) eqn:L.
  - apply Nat.ltb_lt in L. rewrite nth_error_app1 in Hk by exact L.
    destruct (fields_of_nth g w 0 k b Hk ltac:(change (to_Z 0) with 0%Z; lia)) as (f & F & W & SH & M).
    change (to_Z 0) with 0%Z in SH. rewrite Z.add_0_l in SH. exists f, 0%nat.
    rewrite nth_error_app1 by (rewrite fields_of_length; exact L). split; [ exact F |]. split; [ lia |]. cbn [nth replace_word].
    split.
    + apply to_Z_inj. destruct (offset_bound g k b Hk). rewrite (cut_spec f _ b _ SH M) by lia.
      apply (bits_of g s1 k b H1 HG Hk).
    + intros x Hx. rewrite pack_cons; [| exact (fits_update g s1 k x b H1 Hk Hx) | exact H2 ]. f_equal.
      apply (changed_spec g s1 k b x f); assumption.
  - apply Nat.ltb_ge in L. rewrite nth_error_app2 in Hk by exact L.
    destruct (IH (S w) s2 (k - length g)%nat b HN H2 Hk) as (f & n & F & W & C & U). exists f, (S n).
    rewrite nth_error_app2 by (rewrite fields_of_length; exact L). rewrite fields_of_length.
    split; [ exact F |]. split; [ lia |]. cbn [nth replace_word]. split; [ exact C |].
    intros x Hx. rewrite ?L1. rewrite (U x Hx). rewrite pack_cons; [ reflexivity | exact H1 |].
    exact (fits_update (concat gs) s2 _ x b H2 Hk Hx).
Qed.

Fixpoint eq_words (c d : list int) : bool :=
  match c, d with
  | [], [] => true
  | v :: c', w :: d' => if v =? w then eq_words c' d' else false
  | _, _ => false
  end.
Lemma eq_words_ok : forall c d, eq_words c d = true -> c = d.
Proof.
  induction c as [| v c IH]; intros [| w d] H; cbn in H; try discriminate; [ reflexivity |].
  destruct (v =? w) eqn:E; [| discriminate]. apply eqb_true in E. f_equal; auto.
Qed.

(* How the states of a system are packed: for each word, the numbers of bits of its components. The number of events
   determines the size of tables. *)
Record layout := { groups : list (list int); event_count : int }.

Section Packed.
  Variable L : layout.
  Variable Y : system.
  Let bits := concat (groups L).
  Let all_fields := fields 0 (groups L).
  Definition size_of (k : nat) : int := match nth_error bits k with Some b => 1 << b | None => 0 end.
  Definition inside_bounds (c : change) : bool := snd c <? size_of (fst c).

  Lemma inside_bits : forall k x, inside_bounds (k, x) = true -> exists b, nth_error bits k = Some b /\ (x <? 1 << b) = true.
  Proof.
    unfold inside_bounds, size_of. cbn. intros k x H. destruct (nth_error bits k) as [b |]; [ eauto |].
    apply ltb_spec in H. change (to_Z 0) with 0%Z in H. pose proof (to_Z_bounded x). lia.
  Qed.
  Lemma apply_fits : forall ch s, fits bits s = true -> (forall c, In c ch -> inside_bounds c = true) ->
    fits bits (apply s ch) = true.
  Proof.
    induction ch as [| [k x] ch IH]; intros s H K; [ exact H |]. cbn. apply IH.
    - destruct (inside_bits k x (K (k, x) (or_introl eq_refl))) as (b & Hb & Hx). exact (fits_update bits s k x b H Hb Hx).
    - intros c Hc. apply K. right. exact Hc.
  Qed.

  Fixpoint bounded (r : region) : bool :=
    match r with
    | Region inside rules => forallb (fun r => forallb inside_bounds (puts r)) rules &&
        forallb (fun p => match p with Slot k => Nat.ltb k (length bits) | Inner r' => bounded r' end) inside
    end.
  Definition edges_bounded : bool :=
    forallb (fun k => let b := size_of k in
      all_below (fun v => forallb (fun e : ev * int => snd e <? b) (edges Y k v)) b) (seq 0 (length bits)).
  Definition system_ok : bool :=
    forallb narrow (groups L) && fits bits (start Y) && asking (whole Y) && bounded (whole Y) && edges_bounded.

  Lemma combine_from : forall ms wanted ch c, In ch (combine ms wanted) -> In c ch ->
    exists i m, In m (nth i ms []) /\ In c (snd m).
  Proof.
    induction wanted as [| [i e] rest IH]; intros ch c H Hc; [ cbn in H; destruct H as [E | []]; subst; destruct Hc |].
    apply combine_in in H. destruct H as (m & c' & Hm & _ & Hcc & E). subst. apply in_app_or in Hc.
    destruct Hc as [Hc | Hc]; [ eauto | exact (IH c' c Hcc Hc) ].
  Qed.
  Lemma moves_bounded : edges_bounded = true -> forall s, fits bits s = true -> forall r, bounded r = true ->
    forall m c, In m (moves Y s r) -> In c (snd m) -> inside_bounds c = true.
  Proof.
    intros HE s Hs. induction r as [inside rules IH] using region_rect'. intros B m c Hm Hc. cbn in B.
    apply andb_true_iff in B. destruct B as [B1 B2]. rewrite forallb_forall in B1, B2. cbn [moves] in Hm.
    unfold fire in Hm. apply in_flat_map in Hm. destruct Hm as (r & Hr & Hm).
    destruct (prevented _ _ _); [ destruct Hm |]. apply in_map_iff in Hm. destruct Hm as (ch & E & Hch). subst. cbn in Hc.
    apply in_app_or in Hc. destruct Hc as [Hc | Hc].
    - destruct (combine_from _ _ _ _ Hch Hc) as (i & m & Hm & Hcm).
      rewrite nth_by_error, nth_error_map in Hm. destruct (nth_error inside i) as [p |] eqn:Hp; cbn in Hm.
      + specialize (B2 p (nth_error_In _ _ Hp)). destruct p as [k | r'].
        * unfold slot_moves in Hm. apply in_map_iff in Hm. destruct Hm as (e & E & He). subst. cbn in Hcm.
          destruct Hcm as [E | []]. subst. apply Nat.ltb_lt in B2.
          unfold edges_bounded in HE. rewrite forallb_forall in HE.
          assert (HK : In k (seq 0 (length bits))) by (apply in_seq; lia).
          specialize (HE k HK). cbn zeta in HE.
          assert (VK : (nth k s 0 <? size_of k) = true).
          { unfold size_of. destruct (nth_error bits k) as [b |] eqn:Hb; [ exact (fits_nth bits s k b Hs Hb) |].
            apply nth_error_None in Hb. lia. }
          assert (V := all_below_spec _ _ HE (nth k s 0) VK). cbn beta in V.
          rewrite forallb_forall in V. exact (V e He).
        * exact (IH r' (nth_error_In _ _ Hp) B2 m c Hm Hcm).
      + destruct Hm.
    - specialize (B1 r Hr). rewrite forallb_forall in B1. exact (B1 c Hc).
  Qed.

  Definition no_field : field := {| word := 0; shift := 0; mask := 0 |}.
  Definition read_local (k : nat) : list int -> int :=
    match nth_error all_fields k with Some f => read_field f | None => fun _ => 0 end.
  Definition write_local (k : nat) (x : int) : field * int :=
    (match nth_error all_fields k with Some f => f | None => no_field end, x).
  Definition prepared : fregion (list int) (field * int) :=
    prepare Y (event_count L) size_of (list int) (field * int) read_local write_local (whole Y).
  Definition packed : lts (list int) :=
    let region := prepared in
    {| init := pack (groups L) (start Y);
       succ := fun c => map (fun m : fmove (field * int) => (fst m, fold_left write_field (snd m) c))
                            (fast_moves (list int) (field * int) c region) |}.

  Lemma fields_length : forall gs w, length (fields w gs) = length (concat gs).
  Proof. induction gs as [| g gs IH]; intros w; cbn; [ reflexivity |]. rewrite !app_length, fields_of_length, IH. reflexivity. Qed.
  Lemma read_packed : forallb narrow (groups L) = true -> forall s, fits bits s = true ->
    forall k, read_local k (pack (groups L) s) = nth k s 0.
  Proof.
    intros HN s H k. unfold read_local. destruct (nth_error bits k) as [b |] eqn:Hk.
    - destruct (field_spec (groups L) 0 s k b HN H Hk) as (f & n & F & W & C & _). unfold all_fields. rewrite F.
      rewrite read_field_plain, W. exact C.
    - apply nth_error_None in Hk. replace (nth_error all_fields k) with (@None field).
      + symmetry. apply nth_overflow. rewrite (fits_length bits s H). exact Hk.
      + symmetry. apply nth_error_None. unfold all_fields. rewrite fields_length. exact Hk.
  Qed.
  Lemma write_packed : forallb narrow (groups L) = true -> forall ch s, fits bits s = true ->
    (forall c, In c ch -> inside_bounds c = true) ->
    fold_left write_field (set_all (field * int) write_local ch) (pack (groups L) s) = pack (groups L) (apply s ch).
  Proof.
    intros HN. induction ch as [| [k x] ch IH]; intros s H K; [ reflexivity |].
    destruct (inside_bits k x (K (k, x) (or_introl eq_refl))) as (b & Hb & Hx).
    destruct (field_spec (groups L) 0 s k b HN H Hb) as (f & n & F & W & _ & U).
    assert (WL : write_local k x = (f, x)) by (unfold write_local, all_fields; rewrite F; reflexivity).
    change (fold_left write_field (set_all (field * int) write_local ch) (write_field (pack (groups L) s) (write_local k x)) =
            pack (groups L) (apply (update s k x) ch)).
    rewrite WL, write_field_plain, W. cbn [Nat.add]. rewrite (U x Hx). apply (IH (update s k x)).
    - exact (fits_update bits s k x b H Hb Hx).
    - intros c Hc. apply K. right. exact Hc.
  Qed.

  Lemma packed_bisimulation : system_ok = true ->
    fits bits (start Y) = true /\
    (forall s a u, fits bits s = true -> step (system_lts Y) s a u -> fits bits u = true) /\
    (forall s, fits bits s = true -> forall a w,
      step packed (pack (groups L) s) a w <-> exists u, w = pack (groups L) u /\ step (system_lts Y) s a u).
  Proof.
    intros H. unfold system_ok in H. rewrite !andb_true_iff in H.
    destruct H as [[[[HN Hstart] Hask] Hb] He].
    assert (STEP : forall s a u, step (system_lts Y) s a u <-> exists ch, In (a, ch) (moves Y s (whole Y)) /\ u = apply s ch).
    { intros s a u. unfold step. cbn. rewrite in_map_iff. split.
      - intros ([b ch] & E & K). inversion E. subst. eauto.
      - intros (ch & K & E). subst. exists (a, ch). auto. }
    split; [ exact Hstart | split ].
    - intros s a u G St. apply STEP in St. destruct St as (ch & K & E). subst. apply apply_fits; [ exact G |].
      intros c Hc. exact (moves_bounded He s G _ Hb (a, ch) c K Hc).
    - intros s G a w. unfold step at 1. cbn. rewrite in_map_iff.
      assert (S0 := fast_moves_same Y (event_count L) size_of (list int) (field * int) read_local write_local s
                      (pack (groups L) s) (read_packed HN s G) (whole Y) Hask).
      assert (IB : forall b ch, In (b, ch) (moves Y s (whole Y)) -> forall c, In c ch -> inside_bounds c = true).
      { intros b ch K c Hc. exact (moves_bounded He s G _ Hb (b, ch) c K Hc). }
      split.
      + intros ([b x] & E & K). apply S0 in K. destruct K as (ch & K & Ex). cbn [fst snd] in E. inversion E. subst a w x.
        exists (apply s ch). rewrite (write_packed HN ch s G (IB b ch K)). split; [ reflexivity | apply STEP; eauto ].
      + intros (u & E & St). apply STEP in St. destruct St as (ch & K & Eu). subst.
        exists (a, set_all (field * int) write_local ch). cbn [fst snd]. rewrite (write_packed HN ch s G (IB a ch K)).
        split; [ reflexivity |]. apply S0. eauto.
  Qed.

  Theorem packed_implementation : forall A m (spec : lts A), system_ok = true ->
    refines m spec packed -> refines m spec (system_lts Y).
  Proof.
    intros A m spec H R. destruct (packed_bisimulation H) as (H1 & H2 & H3).
    exact (morphism_refines (system_lts Y) packed (pack (groups L)) (fun s => fits bits s = true) H1 H2 eq_refl H3 A m spec R).
  Qed.
  Theorem packed_specification : forall A m (impl : lts A), system_ok = true ->
    refines m packed impl -> refines m (system_lts Y) impl.
  Proof.
    intros A m impl H R. destruct (packed_bisimulation H) as (H1 & H2 & H3).
    exact (back_refines (system_lts Y) packed (pack (groups L)) (fun s => fits bits s = true) H1 H2 eq_refl H3 A m impl R).
  Qed.
  Theorem packed_property : forall p, system_ok = true -> satisfies p packed -> satisfies p (system_lts Y).
  Proof.
    intros p H R. destruct (packed_bisimulation H) as (H1 & H2 & H3).
    exact (morphism_satisfies (system_lts Y) packed (pack (groups L)) (fun s => fits bits s = true) H1 H2 eq_refl H3 p R).
  Qed.
End Packed.
