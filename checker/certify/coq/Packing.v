(* SPDX-License-Identifier: Apache-2.0 *)
(* States as words: the states of a group of components are one number in mixed radix, and a state has as many words
   as there are groups, so states of any width fit. A functional bisimulation keeps all that is claimed. *)
From Coq Require Import List Bool ZArith Lia Uint63.
From Certify Require Import Claims Processes Loops Moves.
Import ListNotations.
Open Scope uint63_scope.

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

  (* The other way, for the specification. *)
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
End Morphism.

(** Numbers in mixed radix. *)
Fixpoint decode (bs : list int) (c : int) : list int :=
  match bs with [] => [] | b :: bs' => (c mod b) :: decode bs' (c / b) end.
Fixpoint encode (bs s : list int) : int :=
  match bs, s with b :: bs', v :: s' => v + b * encode bs' s' | _, _ => 0 end.
Fixpoint fits (bs s : list int) : bool :=
  match bs, s with [], [] => true | b :: bs', v :: s' => (v <? b) && fits bs' s' | _, _ => false end.
Fixpoint volume (bs : list int) : Z := match bs with [] => 1%Z | b :: bs' => (to_Z b * volume bs')%Z end.

Lemma encode_value : forall bs s, fits bs s = true -> (volume bs < wB)%Z -> (0 < volume bs)%Z ->
  (to_Z (encode bs s) < volume bs)%Z /\
  match bs, s with b :: bs', v :: s' => to_Z (encode bs s) = (to_Z v + to_Z b * to_Z (encode bs' s'))%Z | _, _ => True end.
Proof.
  induction bs as [| b bs IH]; intros [| v s] H Hv Hp; cbn [fits] in H; try discriminate.
  - cbn. change (to_Z 0) with 0%Z. split; [ lia | exact I ].
  - apply andb_true_iff in H. destruct H as [Hvb H]. apply ltb_spec in Hvb. cbn [volume] in *.
    pose proof (to_Z_bounded b). pose proof (to_Z_bounded v).
    assert (0 < volume bs)%Z by nia. assert (volume bs < wB)%Z by nia.
    destruct (IH s H ltac:(assumption) ltac:(assumption)) as [Hb _].
    pose proof (to_Z_bounded (encode bs s)). cbn [encode].
    assert (E : to_Z (v + b * encode bs s) = (to_Z v + to_Z b * to_Z (encode bs s))%Z).
    { rewrite add_spec, mul_spec, Z.add_mod_idemp_r by (unfold wB; discriminate). apply Z.mod_small. nia. }
    rewrite E. split; [ nia | reflexivity ].
Qed.

Lemma decode_encode : forall bs s, fits bs s = true -> (volume bs < wB)%Z -> (0 < volume bs)%Z ->
  decode bs (encode bs s) = s.
Proof.
  induction bs as [| b bs IH]; intros [| v s] H Hv Hp; cbn [fits] in H; try discriminate; [ reflexivity |].
  destruct (encode_value (b :: bs) (v :: s) H Hv Hp) as [_ E].
  apply andb_true_iff in H. destruct H as [Hvb H]. apply ltb_spec in Hvb. cbn [volume] in *.
  pose proof (to_Z_bounded b). pose proof (to_Z_bounded v).
  assert (0 < volume bs)%Z by nia. assert (volume bs < wB)%Z by nia.
  change (decode (b :: bs) (encode (b :: bs) (v :: s))) with
    ((encode (b :: bs) (v :: s) mod b) :: decode bs (encode (b :: bs) (v :: s) / b)). f_equal.
  - apply to_Z_inj. rewrite mod_spec, E, Z.mul_comm, Z_mod_plus_full. apply Z.mod_small. lia.
  - rewrite <- (IH s) at 2 by assumption. f_equal. apply to_Z_inj. rewrite div_spec, E, Z.mul_comm, Z_div_plus_full by lia.
    rewrite Z.div_small by lia. lia.
Qed.

Lemma update_length : forall s k x, length (update s k x) = length s.
Proof. induction s as [| v s IH]; intros [| k] x; cbn; auto. Qed.
Lemma fits_length : forall bs s, fits bs s = true -> length s = length bs.
Proof.
  induction bs as [| b bs IH]; intros [| v s] H; cbn in *; try discriminate; auto.
  apply andb_true_iff in H. f_equal. apply IH, H.
Qed.
Lemma fits_nth : forall bs s k, fits bs s = true -> (k < length bs)%nat -> (nth k s 0 <? nth k bs 0) = true.
Proof.
  induction bs as [| b bs IH]; intros [| v s] [| k] H K; cbn in *; try discriminate; try lia;
    apply andb_true_iff in H; [ apply H | apply IH; [ apply H | lia ]].
Qed.
Lemma fits_update : forall bs s k x, fits bs s = true -> (x <? nth k bs 0) = true -> fits bs (update s k x) = true.
Proof.
  induction bs as [| b bs IH]; intros [| v s] [| k] x H K; cbn in *; try discriminate; auto;
    apply andb_true_iff in H; apply andb_true_iff; split; try apply H; [ exact K | apply IH; [ apply H | exact K ]].
Qed.

(** Words. *)
Fixpoint decode_before (bs : list int) (c : int) (rest : list int) : list int :=
  match bs with [] => rest | b :: bs' => (c mod b) :: decode_before bs' (c / b) rest end.
Fixpoint pack (gs : list (list int)) (s : list int) : list int :=
  match gs with [] => [] | g :: gs' => encode g s :: match gs' with [] => [] | _ => pack gs' (skipn (length g) s) end end.
Fixpoint unpack (gs : list (list int)) (c : list int) : list int :=
  match gs, c with g :: gs', w :: c' => decode_before g w (unpack gs' c') | _, _ => [] end.
Definition narrow (g : list int) : bool := (volume g <? wB)%Z && (0 <? volume g)%Z.

Lemma decode_before_app : forall bs c rest, decode_before bs c rest = decode bs c ++ rest.
Proof. induction bs as [| b bs IH]; intros c rest; cbn; [ reflexivity | rewrite IH; reflexivity ]. Qed.
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
Lemma unpack_pack : forall gs s, forallb narrow gs = true -> fits (concat gs) s = true -> unpack gs (pack gs s) = s.
Proof.
  induction gs as [| g gs IH]; intros s HN H; cbn in H.
  - destruct s; [ reflexivity | discriminate ].
  - cbn in HN. apply andb_true_iff in HN. destruct HN as [HG HN]. unfold narrow in HG.
    apply andb_true_iff in HG. destruct HG as [V1 V2]. apply Z.ltb_lt in V1, V2.
    destruct (fits_split _ _ _ H) as (s1 & s2 & E & H1 & H2). subst. cbn [pack unpack].
    rewrite decode_before_app, encode_prefix, decode_encode, skipn_prefix by assumption. f_equal.
    destruct gs as [| g' gs]; [ destruct s2; [ reflexivity | discriminate ] |]. apply IH; assumption.
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

(* How the states of a system are packed: numbers of states of components, by group; and the number of events, for
   tables. *)
Record layout := { groups : list (list int); event_count : int }.

Section Packed.
  Variable L : layout.
  Variable Y : system.
  Let bases := concat (groups L).
  Definition inside_bounds (c : change) : bool := snd c <? nth (fst c) bases 0.

  Lemma apply_fits : forall ch s, fits bases s = true -> (forall c, In c ch -> inside_bounds c = true) ->
    fits bases (apply s ch) = true.
  Proof.
    induction ch as [| [k x] ch IH]; intros s H K; [ exact H |]. cbn. apply IH.
    - apply fits_update; [ exact H | exact (K (k, x) (or_introl eq_refl)) ].
    - intros c Hc. apply K. right. exact Hc.
  Qed.

  Fixpoint bounded (r : region) : bool :=
    match r with
    | Region inside rules => forallb (fun r => forallb inside_bounds (puts r)) rules &&
        forallb (fun p => match p with Slot k => Nat.ltb k (length bases) | Inner r' => bounded r' end) inside
    end.
  Definition edges_bounded : bool :=
    forallb (fun k => let b := nth k bases 0 in
      all_below (fun v => forallb (fun e : ev * int => snd e <? b) (edges Y k v)) b) (seq 0 (length bases)).
  Definition system_ok : bool :=
    forallb narrow (groups L) && fits bases (start Y) && asking (whole Y) && bounded (whole Y) && edges_bounded.

  Lemma combine_from : forall ms wanted ch c, In ch (combine ms wanted) -> In c ch ->
    exists i m, In m (nth i ms []) /\ In c (snd m).
  Proof.
    induction wanted as [| [i e] rest IH]; intros ch c H Hc; [ cbn in H; destruct H as [E | []]; subst; destruct Hc |].
    apply combine_in in H. destruct H as (m & c' & Hm & _ & Hcc & E). subst. apply in_app_or in Hc.
    destruct Hc as [Hc | Hc]; [ eauto | exact (IH c' c Hcc Hc) ].
  Qed.
  Lemma moves_bounded : edges_bounded = true -> forall s, fits bases s = true -> forall r, bounded r = true ->
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
          assert (HK : In k (seq 0 (length bases))) by (apply in_seq; lia).
          specialize (HE k HK). cbn zeta in HE.
          assert (V := all_below_spec _ _ HE (nth k s 0) (fits_nth _ _ _ Hs B2)). cbn beta in V.
          rewrite forallb_forall in V. exact (V e He).
        * exact (IH r' (nth_error_In _ _ Hp) B2 m c Hm Hcm).
      + destruct Hm.
    - specialize (B1 r Hr). rewrite forallb_forall in B1. exact (B1 c Hc).
  Qed.

  Definition packed : lts (list int) :=
    let prepared := prepare Y (event_count L) (fun k => nth k bases 0) (whole Y) in
    let gs := groups L in
    {| init := pack gs (start Y);
       succ := fun c => let s := unpack gs c in
                        map (fun m : move => (fst m, pack gs (apply s (snd m)))) (fast_moves s prepared) |}.

  Lemma packed_bisimulation : system_ok = true ->
    fits bases (start Y) = true /\
    (forall s a u, fits bases s = true -> step (system_lts Y) s a u -> fits bases u = true) /\
    (forall s, fits bases s = true -> forall a w,
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
    - intros s G a w. unfold step at 1. cbn. rewrite unpack_pack by assumption. rewrite in_map_iff.
      assert (S0 := fast_moves_same Y (event_count L) (fun k => nth k bases 0) s _ Hask).
      split.
      + intros ([b ch] & E & K). apply S0 in K. inversion E. subst. exists (apply s ch).
        split; [ reflexivity | apply STEP; eauto ].
      + intros (u & E & St). apply STEP in St. destruct St as (ch & K & Eu). subst. exists (a, ch).
        split; [ reflexivity | apply S0; exact K ].
  Qed.

  Theorem packed_implementation : forall A m (spec : lts A), system_ok = true ->
    refines m spec packed -> refines m spec (system_lts Y).
  Proof.
    intros A m spec H R. destruct (packed_bisimulation H) as (H1 & H2 & H3).
    exact (morphism_refines (system_lts Y) packed (pack (groups L)) (fun s => fits bases s = true) H1 H2 eq_refl H3 A m spec R).
  Qed.
  Theorem packed_specification : forall A m (impl : lts A), system_ok = true ->
    refines m packed impl -> refines m (system_lts Y) impl.
  Proof.
    intros A m impl H R. destruct (packed_bisimulation H) as (H1 & H2 & H3).
    exact (back_refines (system_lts Y) packed (pack (groups L)) (fun s => fits bases s = true) H1 H2 eq_refl H3 A m impl R).
  Qed.
  Theorem packed_property : forall p, system_ok = true -> satisfies p packed -> satisfies p (system_lts Y).
  Proof.
    intros p H R. destruct (packed_bisimulation H) as (H1 & H2 & H3).
    exact (morphism_satisfies (system_lts Y) packed (pack (groups L)) (fun s => fits bases s = true) H1 H2 eq_refl H3 p R).
  Qed.
End Packed.
