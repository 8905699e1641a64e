(* SPDX-License-Identifier: Apache-2.0 *)
(* Combines the rules of nested regions to rules of the whole process (checker/machine/whole_rules.hpp), and proves that
   they make the same moves. *)
From Coq Require Import List Bool Arith ZArith Lia Uint63.
From Certify Require Import Claims Processes Loops Moves.
Import ListNotations.
Open Scope uint63_scope.

(* What a rule does to one component. *)
Inductive item := Performs (k : nat) (e : ev) | Sets (k : nat) (x : int).
Definition item_slot (it : item) : nat := match it with Performs k _ => k | Sets k _ => k end.
(* A region through which a rule passes: its place, its rule `own` that makes the move, and its components. If `prior` is
   true, a rule of the region with a smaller level may prevent the move. *)
Record passage := {
  place : list nat; inside : list participant; rivals : list rule; own : rule; around : list nat; prior : bool }.
Record whole_rule := { performed : ev; items : list item; passages : list passage }.
Definition way := (list item * list passage)%type.

Fixpoint slots_of (r : region) : list nat :=
  match r with Region inside _ => flat_map (fun p => match p with Slot k => [k] | Inner r' => slots_of r' end) inside end.
Definition can_be_prevented (rules : list rule) (q : rule) : bool :=
  match level q with Some l => existsb (fun o => before o l) rules | None => false end.

(* The ways in which participants perform events. *)
Inductive source := Of_slot (k : nat) | Of_region (whole : list whole_rule).
Definition ways (src : source) (e : ev) : list way :=
  match src with
  | Of_slot k => [([Performs k e], [])]
  | Of_region rules => flat_map (fun w => if performed w =? e then [(items w, passages w)] else []) rules
  end.
Fixpoint pick (sources : list source) (wanted : list (nat * ev)) : list way :=
  match wanted with
  | [] => [([], [])]
  | (i, e) :: rest =>
      let later := pick sources rest in
      flat_map (fun a : way => map (fun b : way => (fst a ++ fst b, snd a ++ snd b)) later)
               (ways (nth i sources (Of_region [])) e)
  end.
Definition put_items (l : list change) : list item := map (fun c => Sets (fst c) (snd c)) l.
Definition whole_of (at_ : list nat) (parts : list participant) (rules : list rule) (slots : list nat) (sources : list source)
    (q : rule) : list whole_rule :=
  let passed := {| place := at_; inside := parts; rivals := rules; own := q; around := slots;
                   prior := can_be_prevented rules q |} in
  let sets := put_items (puts q) in
  map (fun w : way => {| performed := does q; items := fst w ++ sets; passages := passed :: snd w |}) (pick sources (asks q)).
Fixpoint whole_rules (r : region) (at_ : list nat) : list whole_rule :=
  match r with
  | Region parts rules =>
      let sources := number (fun i g => g i) 0 (map (fun p =>
        match p with Slot k => fun _ => Of_slot k | Inner r' => fun i => Of_region (whole_rules r' (i :: at_)) end) parts) in
      let slots := slots_of r in
      flat_map (whole_of at_ parts rules slots sources) rules
  end.

Section Whole.
  Variable Y : system.

  Definition part_moves (s : list int) (parts : list participant) : list (list move) :=
    map (fun p => match p with Slot k => slot_moves Y k (nth k s 0) | Inner r' => moves Y s r' end) parts.
  (* The item makes the change. *)
  Definition takes (s : list int) (it : item) (c : change) : Prop :=
    match it with
    | Performs k e => fst c = k /\ In (e, snd c) (edges Y k (nth k s 0))
    | Sets k x => c = (k, x)
    end.
  Definition free (s : list int) (g : passage) : Prop := prevented (part_moves s (inside g)) (rivals g) (own g) = false.
  Definition enabled_by (s : list int) (w : way) (ch : list change) : Prop :=
    Forall2 (takes s) (fst w) ch /\ Forall (free s) (snd w).

  Lemma number_nth : forall A B (g : nat -> A -> B) l n i d,
    nth i (number g n l) d = match nth_error l i with Some x => g (n + i)%nat x | None => d end.
  Proof.
    induction l as [| x l IH]; intros n [| i] d; cbn; auto.
    - rewrite Nat.add_0_r. reflexivity.
    - rewrite IH. destruct (nth_error l i); [| reflexivity ]. f_equal. lia.
  Qed.

  Definition good_source (s : list int) (ms : list move) (src : source) : Prop :=
    forall e ch, (exists m, In m ms /\ fst m = e /\ ch = snd m) <-> exists w, In w (ways src e) /\ enabled_by s w ch.
  Lemma pick_moves : forall s ms sources, (forall i, good_source s (nth i ms []) (nth i sources (Of_region []))) ->
    forall wanted ch, In ch (combine ms wanted) <-> exists w, In w (pick sources wanted) /\ enabled_by s w ch.
  Proof.
    intros s ms sources H. induction wanted as [| [i e] rest IH]; intros ch.
    - cbn. split.
      + intros [E | []]. subst. exists ([], []). split; [ auto | split; constructor ].
      + intros (w & [E | []] & [F _]). subst. inversion F. auto.
    - rewrite combine_in. cbn [pick]. cbn zeta. split.
      + intros (m & c & Hm & Em & Hc & Ec). apply IH in Hc. destruct Hc as (b & Hb & [B1 B2]).
        destruct (proj1 (H i e (snd m))) as (a & Ha & [A1 A2]); [ eauto |].
        exists (fst a ++ fst b, snd a ++ snd b). split.
        * apply in_flat_map. exists a. split; [ exact Ha |]. apply in_map_iff. eauto.
        * subst. split; cbn [fst snd]; [ apply Forall2_app; assumption | apply Forall_app; auto ].
      + intros (w & Hw & [W1 W2]). apply in_flat_map in Hw. destruct Hw as (a & Ha & Hw). apply in_map_iff in Hw.
        destruct Hw as (b & E & Hb). subst w. cbn [fst snd] in *. apply Forall_app in W2. destruct W2 as [A2 B2].
        apply Forall2_app_inv_l in W1. destruct W1 as (ca & cb & A1 & B1 & E).
        destruct (proj2 (H i e ca)) as (m & Hm & Em & Ec); [ exists a; split; [ exact Ha | split; assumption ] |].
        exists m, cb. split; [ exact Hm | split; [ exact Em | split; [| subst; reflexivity ]]]. apply IH. exists b.
        split; [ exact Hb | split; assumption ].
  Qed.
  Lemma takes_sets : forall s l ch, Forall2 (takes s) (put_items l) ch <-> ch = l.
  Proof.
    induction l as [| [k x] l IH]; intros ch; cbn.
    - split; [ intros F; inversion F; reflexivity | intros E; subst; constructor ].
    - split.
      + intros F. inversion F as [| it c its cs T R]. subst. cbn in T. subst. f_equal. apply IH, R.
      + intros E. subst. constructor; [ reflexivity | apply IH; reflexivity ].
  Qed.

  Definition sources_of (parts : list participant) (at_ : list nat) : list source :=
    number (fun i g => g i) 0 (map (fun p =>
        match p with Slot k => fun _ => Of_slot k | Inner r' => fun i => Of_region (whole_rules r' (i :: at_)) end) parts).
  Lemma sources_nth : forall parts at_ i, nth i (sources_of parts at_) (Of_region []) =
    match nth_error parts i with
    | Some (Slot k) => Of_slot k
    | Some (Inner r') => Of_region (whole_rules r' (i :: at_))
    | None => Of_region []
    end.
  Proof.
    intros. unfold sources_of. rewrite number_nth, nth_error_map. destruct (nth_error parts i) as [[k | r'] |]; reflexivity.
  Qed.
  Lemma whole_rules_in : forall parts rules at_ w, In w (whole_rules (Region parts rules) at_) <->
    exists q v, In q rules /\ In v (pick (sources_of parts at_) (asks q)) /\
      w = {| performed := does q; items := fst v ++ put_items (puts q);
             passages := {| place := at_; inside := parts; rivals := rules; own := q; around := slots_of (Region parts rules);
                            prior := can_be_prevented rules q |} :: snd v |}.
  Proof.
    intros. cbn [whole_rules]. cbn zeta. rewrite in_flat_map. split.
    - intros (q & Hq & H). apply in_map_iff in H. destruct H as (v & E & Hv). eauto 6.
    - intros (q & v & Hq & Hv & E). exists q. split; [ exact Hq |]. apply in_map_iff. exists v. auto.
  Qed.

  Lemma slot_source : forall s k, good_source s (slot_moves Y k (nth k s 0)) (Of_slot k).
  Proof.
    intros s k e ch. unfold slot_moves. split.
    - intros (m & Hm & Em & Ec). apply in_map_iff in Hm. destruct Hm as ([d x] & E & Hx). subst m. cbn in Em, Ec. subst.
      exists ([Performs k e], []). split; [ left; reflexivity |]. split; repeat constructor. exact Hx.
    - intros (w & [E | []] & [F _]). subst w. cbn in F. inversion F as [| it c its cs T R]. subst. inversion R. subst.
      destruct c as [j x]. cbn in T. destruct T as [Ej Hx]. subst j. exists (e, [(k, x)]).
      split; [| auto ]. apply in_map_iff. exists (e, x). auto.
  Qed.

  Lemma good_sources : forall s at_ parts,
    (forall r', In (Inner r') parts -> forall at_' a ch, In (a, ch) (moves Y s r') <->
      exists w, In w (whole_rules r' at_') /\ performed w = a /\ enabled_by s (items w, passages w) ch) ->
    forall i, good_source s (nth i (part_moves s parts) []) (nth i (sources_of parts at_) (Of_region [])).
  Proof.
    intros s at_ parts IH i. rewrite sources_nth, nth_by_error. unfold part_moves. rewrite nth_error_map.
    destruct (nth_error parts i) as [[k | r'] |] eqn:Hi; cbn [option_map].
    - apply slot_source.
    - intros e c. split.
      + intros ([b d] & Hm & Em & Ec). cbn in Em, Ec. subst. apply (IH r' (nth_error_In _ _ Hi) (i :: at_)) in Hm.
        destruct Hm as (w & Hw & Ew & En). exists (items w, passages w). split; [| exact En ].
        apply in_flat_map. exists w. split; [ exact Hw |]. rewrite Ew, eqb_refl. left. reflexivity.
      + intros (v & Hv & En). apply in_flat_map in Hv. destruct Hv as (w & Hw & Hv).
        destruct (performed w =? e) eqn:E; [| destruct Hv ]. apply eqb_true in E. destruct Hv as [Ev | []]. subst v.
        exists (e, c). split; [| auto ]. apply (IH r' (nth_error_In _ _ Hi) (i :: at_)). eauto.
    - intros e c. split; [ intros (m & [] & _) | intros (w & [] & _) ].
  Qed.
  Theorem whole_moves : forall s r at_ a ch, In (a, ch) (moves Y s r) <->
    exists w, In w (whole_rules r at_) /\ performed w = a /\ enabled_by s (items w, passages w) ch.
  Proof.
    intros s. induction r as [parts rules IH] using region_rect'. intros at_ a ch.
    pose proof (good_sources s at_ parts IH) as G.
    cbn [moves]. fold (part_moves s parts). unfold fire. rewrite in_flat_map. split.
    - intros (q & Hq & H). destruct (prevented (part_moves s parts) rules q) eqn:PV; [ destruct H |].
      apply in_map_iff in H. destruct H as (c & E & Hc). inversion E. subst.
      apply (pick_moves s _ _ G) in Hc. destruct Hc as (v & Hv & [V1 V2]).
      eexists. split; [ apply whole_rules_in; exists q, v; eauto |]. split; [ reflexivity |]. split; cbn [fst snd items passages].
      + apply Forall2_app; [ exact V1 | apply takes_sets; reflexivity ].
      + constructor; [ exact PV | exact V2 ].
    - intros (w & Hw & Ew & [W1 W2]). apply whole_rules_in in Hw. destruct Hw as (q & v & Hq & Hv & E). subst w.
      cbn [performed items passages fst snd] in *. exists q. split; [ exact Hq |]. inversion W2 as [| g gs PV V2]. subst.
      unfold free in PV. cbn [inside rivals own] in PV. rewrite PV. apply Forall2_app_inv_l in W1.
      destruct W1 as (c & d & V1 & D & E). apply takes_sets in D. subst. apply in_map_iff. exists c. split; [ reflexivity |].
      apply (pick_moves s _ _ G). exists v. split; [ exact Hv | split; assumption ].
  Qed.

  (** Passages. *)
  Lemma pick_all : forall (Q : way -> Prop) sources,
    Q ([], []) -> (forall a b, Q a -> Q b -> Q (fst a ++ fst b, snd a ++ snd b)) ->
    (forall i e a, In a (ways (nth i sources (Of_region [])) e) -> Q a) ->
    forall wanted w, In w (pick sources wanted) -> Q w.
  Proof.
    intros Q sources Q0 QA QW. induction wanted as [| [i e] rest IH]; intros w H; cbn in H.
    - destruct H as [E | []]. subst. exact Q0.
    - apply in_flat_map in H. destruct H as (a & Ha & H). apply in_map_iff in H. destruct H as (b & E & Hb). subst w.
      apply QA; [ exact (QW i e a Ha) | exact (IH b Hb) ].
  Qed.
  Lemma ways_in : forall parts at_ i e a, In a (ways (nth i (sources_of parts at_) (Of_region [])) e) ->
    snd a = [] \/ exists r' w, nth_error parts i = Some (Inner r') /\ In w (whole_rules r' (i :: at_)) /\ a = (items w, passages w).
  Proof.
    intros parts at_ i e a Ha. rewrite sources_nth in Ha. destruct (nth_error parts i) as [[k | r'] |].
    - left. destruct Ha as [E | []]. subst. reflexivity.
    - right. cbn in Ha. apply in_flat_map in Ha. destruct Ha as (w & Hw & Ha). destruct (performed w =? e); [| destruct Ha ].
      destruct Ha as [E | []]. exists r', w. auto.
    - destruct Ha.
  Qed.

  (* If the rule can fire, each region can perform the rule of its passage. *)
  Definition passable (s : list int) (g : passage) : Prop :=
    In (own g) (rivals g) /\ nonempty (combine (part_moves s (inside g)) (asks (own g))) = true.
  Lemma passages_passable : forall s r at_ w, In w (whole_rules r at_) -> forall ch,
    enabled_by s (items w, passages w) ch -> Forall (passable s) (passages w).
  Proof.
    intros s. induction r as [parts rules IH] using region_rect'. intros at_ w Hw ch [F1 F2].
    apply whole_rules_in in Hw. destruct Hw as (q & v & Hq & Hv & E). subst w. cbn [items passages fst snd] in *.
    inversion F2 as [| g gs G F3]. subst. apply Forall2_app_inv_l in F1. destruct F1 as (c & d & C & _ & _). constructor.
    - split; [ exact Hq |]. cbn [inside own]. apply nonempty_in. exists c.
      apply (pick_moves s _ _ (good_sources s at_ parts (fun r' _ => whole_moves s r'))).
      exists v. split; [ exact Hv | split; assumption ].
    - revert c C F3. change (forall c, Forall2 (takes s) (fst v) c -> Forall (free s) (snd v) -> Forall (passable s) (snd v)).
      revert Hv. generalize (asks q) as wanted. intros wanted Hv.
      apply (pick_all (fun v => forall c, Forall2 (takes s) (fst v) c -> Forall (free s) (snd v) -> Forall (passable s) (snd v))
               (sources_of parts at_)) with (wanted := wanted); [ constructor | | | exact Hv ].
      + intros a b HA HB e E1 E2. cbn [fst snd] in *. apply Forall2_app_inv_l in E1. destruct E1 as (x & y & X & Y0 & _).
        apply Forall_app in E2. destruct E2 as [E3 E4]. apply Forall_app. split; [ exact (HA x X E3) | exact (HB y Y0 E4) ].
      + intros i e a Ha x X1 X2. destruct (ways_in _ _ _ _ _ Ha) as [E | (r' & w & Hi & Hw & E)].
        * rewrite E. constructor.
        * subst a. exact (IH r' (nth_error_In _ _ Hi) _ w Hw x (conj X1 X2)).
  Qed.

  (* The region at a place: the indices of the path, from the whole process to the region. *)
  Fixpoint descend (r : region) (d : list nat) : option region :=
    match d with
    | [] => Some r
    | i :: d' => match r with
                 | Region parts _ => match nth_error parts i with Some (Inner r') => descend r' d' | _ => None end
                 end
    end.
  Definition well_placed (r : region) (at_ : list nat) (g : passage) : Prop :=
    around g = slots_of (Region (inside g) (rivals g)) /\ prior g = can_be_prevented (rivals g) (own g) /\
    exists d, place g = rev d ++ at_ /\ descend r d = Some (Region (inside g) (rivals g)).
  Lemma passages_placed : forall r at_ w, In w (whole_rules r at_) -> Forall (well_placed r at_) (passages w).
  Proof.
    induction r as [parts rules IH] using region_rect'. intros at_ w Hw.
    apply whole_rules_in in Hw. destruct Hw as (q & v & Hq & Hv & E). subst w. cbn [passages]. constructor.
    - split; [ reflexivity | split; [ reflexivity |]]. exists []. auto.
    - apply (pick_all (fun v => Forall (well_placed (Region parts rules) at_) (snd v)) (sources_of parts at_))
        with (wanted := asks q); [ constructor | | | exact Hv ].
      + intros a b HA HB. apply Forall_app. auto.
      + intros i e a Ha. destruct (ways_in _ _ _ _ _ Ha) as [E | (r' & w & Hi & Hw & E)]; [ rewrite E; constructor |].
        subst a. cbn [snd]. apply (Forall_impl (P := well_placed r' (i :: at_))); [| exact (IH r' (nth_error_In _ _ Hi) _ w Hw) ].
        intros g (G1 & G2 & d & G3 & G4). split; [ exact G1 | split; [ exact G2 |]]. exists (i :: d). split.
        * rewrite G3. cbn [rev]. rewrite <- app_assoc. reflexivity.
        * cbn [descend]. rewrite Hi. exact G4.
  Qed.
  Lemma same_place : forall r g h, well_placed r [] g -> well_placed r [] h -> place g = place h ->
    inside g = inside h /\ rivals g = rivals h.
  Proof.
    intros r g h (_ & _ & d & P1 & D1) (_ & _ & e & P2 & D2) E. rewrite P1, P2, !app_nil_r in E.
    assert (X : d = e) by (rewrite <- (rev_involutive d), E, rev_involutive; reflexivity).
    subst e. rewrite D1 in D2. inversion D2. auto.
  Qed.

  (* The moves of a region depend only on its components. *)
  Lemma moves_local : forall s t r, (forall k, In k (slots_of r) -> nth k s 0 = nth k t 0) -> moves Y s r = moves Y t r.
  Proof.
    intros s t. induction r as [parts rules IH] using region_rect'. intros H. cbn [moves]. f_equal. apply map_ext_in.
    intros p Hp. destruct p as [k | r'].
    - rewrite (H k); [ reflexivity |]. cbn. apply in_flat_map. exists (Slot k). split; [ exact Hp | left; reflexivity ].
    - apply (IH r' Hp). intros k Hk. apply H. cbn. apply in_flat_map. exists (Inner r'). auto.
  Qed.
  Lemma part_moves_local : forall s t parts rules, (forall k, In k (slots_of (Region parts rules)) -> nth k s 0 = nth k t 0) ->
    part_moves s parts = part_moves t parts.
  Proof.
    intros s t parts rules H. apply map_ext_in. intros p Hp. destruct p as [k | r'].
    - rewrite (H k); [ reflexivity |]. cbn. apply in_flat_map. exists (Slot k). split; [ exact Hp | left; reflexivity ].
    - apply moves_local. intros k Hk. apply H. cbn. apply in_flat_map. exists (Inner r'). auto.
  Qed.
  Lemma not_prior_free : forall s g, can_be_prevented (rivals g) (own g) = false -> free s g.
  Proof.
    intros s g H. unfold free, prevented. unfold can_be_prevented in H. destruct (level (own g)) as [l |]; [| reflexivity ].
    apply not_true_iff_false. intros K. apply existsb_exists in K. destruct K as (q & Hq & K). apply andb_true_iff in K.
    rewrite <- not_true_iff_false in H. apply H. apply existsb_exists. exists q. split; [ exact Hq | apply K ].
  Qed.
End Whole.
