(* SPDX-License-Identifier: Apache-2.0 *)
(* A faster way to the moves of a compiled process: rules are listed under the event with which their first participant
   begins them, and the least level is found once. The moves are the same. *)
From Coq Require Import List Bool ZArith Lia Uint63.
From Certify Require Import Claims Processes Loops.
Import ListNotations.
Open Scope uint63_scope.

Lemma region_rect' : forall P : region -> Prop,
  (forall inside rules, (forall r, In (Inner r) inside -> P r) -> P (Region inside rules)) -> forall r, P r.
Proof.
  intros P H. fix self 1. intros [inside rules]. apply H.
  assert (K : Forall (fun p => match p with Inner r => P r | Slot _ => True end) inside).
  { induction inside as [| p inside IH]; constructor; [ destruct p as [k | r']; [ exact I | exact (self r') ] | exact IH ]. }
  intros r Hr. exact (proj1 (Forall_forall _ _) K (Inner r) Hr).
Qed.

Definition same {A} (l k : list A) : Prop := forall x, In x l <-> In x k.
Lemma same_refl : forall A (l : list A), same l l.
Proof. intros A l x. reflexivity. Qed.

Lemma combine_in : forall ms i e rest ch, In ch (combine ms ((i, e) :: rest)) <->
  exists m c, In m (nth i ms []) /\ fst m = e /\ In c (combine ms rest) /\ ch = snd m ++ c.
Proof.
  intros. cbn. rewrite in_flat_map. split.
  - intros (m & Hm & H). destruct (fst m =? e) eqn:E; [| destruct H ]. apply eqb_true in E.
    apply in_map_iff in H. destruct H as (c & Ec & Hc). exists m, c. auto.
  - intros (m & c & Hm & E & Hc & Ec). exists m. split; [ exact Hm |]. rewrite <- E, eqb_refl.
    apply in_map_iff. exists c. auto.
Qed.

Lemma nonempty_in : forall A (l : list A), nonempty l = true <-> exists x, In x l.
Proof.
  intros A [| x l]; cbn; split; intros H; try discriminate; try reflexivity.
  - destruct H as (y & []).
  - exists x. auto.
Qed.

Lemma bool_same : forall a b : bool, (a = true <-> b = true) -> a = b.
Proof. intros [|] [|] [H1 H2]; auto; symmetry; auto. Qed.

Lemma nth_by_error : forall A (l : list A) i d, nth i l d = match nth_error l i with Some x => x | None => d end.
Proof. induction l as [| x l IH]; intros [| i] d; cbn; auto. Qed.

Section Fast.
  Variable Y : system.
  (* The lengths of tables: other lengths make the same functions slower. *)
  Variable events : int.
  Variable local_states : nat -> int.

  (* A rule, and the changes of its first participant. *)
  Definition lead := (rule * list change)%type.

  Definition led_by (i : nat) (r : rule) : bool := match asks r with (j, _) :: _ => Nat.eqb i j | [] => false end.
  Definition begins (e : ev) (r : rule) : bool := match asks r with (_, d) :: _ => e =? d | [] => false end.
  Definition rules_of (i : nat) (rules : list rule) : ev -> list rule :=
    let mine := filter (led_by i) rules in table events (fun e => filter (begins e) mine).
  Definition leads_of (find : ev -> list rule) (ms : list move) : list lead :=
    flat_map (fun m : move => map (fun r => (r, snd m)) (find (fst m))) ms.

  Inductive fregion := FRegion (inside : list fparticipant)
  with fparticipant :=
    FSlot (k : nat) (own : int -> list move) (leads : int -> list lead) | FInner (r : fregion) (find : ev -> list rule).

  Fixpoint number {A B} (g : nat -> A -> B) (n : nat) (l : list A) : list B :=
    match l with [] => [] | x :: l' => g n x :: number g (S n) l' end.

  Fixpoint prepare (r : region) : fregion :=
    match r with
    | Region inside rules =>
        FRegion (number (fun i g => g i) 0 (map (fun p i =>
          let find := rules_of i rules in
          match p with
          | Slot k => FSlot k (table (local_states k) (slot_moves Y k))
                              (table (local_states k) (fun v => leads_of find (slot_moves Y k v)))
          | Inner r' => FInner (prepare r') find
          end) inside))
    end.

  (* Of each participant its moves and the rules that these begin. *)
  Definition offer := (list move * list lead)%type.
  Definition candidate := (lead * list (list change))%type.
  Definition able (ms : list (list move)) (both : list offer) : list candidate :=
    flat_map (fun b : offer => flat_map (fun q : lead =>
      match combine ms (tl (asks (fst q))) with [] => [] | others => [(q, others)] end) (snd b)) both.
  Definition lesser (b : option int) (c : candidate) : option int :=
    match level (fst (fst c)) with
    | None => b
    | Some l => match b with None => Some l | Some k => if l <? k then Some l else b end
    end.
  Definition least (cs : list candidate) : option int := fold_left lesser cs None.
  Definition ready (b : option int) (r : rule) : bool :=
    match level r with None => true | Some l => match b with None => true | Some k => negb (k <? l) end end.
  Definition fast_fire (both : list offer) : list move :=
    let cs := able (map fst both) both in
    let b := least cs in
    flat_map (fun c : candidate =>
      let (q, others) := c in let (r, first) := q in
      if ready b r then map (fun ch => (does r, (first ++ ch) ++ puts r)) others else []) cs.
  Fixpoint fast_moves (s : list int) (r : fregion) : list move :=
    match r with
    | FRegion inside =>
        fast_fire (map (fun p =>
          match p with
          | FSlot k own leads => let v := nth k s 0 in (own v, leads v)
          | FInner r' find => let ms := fast_moves s r' in (ms, leads_of find ms)
          end) inside)
    end.

  Lemma number_error : forall (A B : Type) (g : nat -> A -> B) l n i,
    nth_error (number g n l) i = option_map (g (n + i)%nat) (nth_error l i).
  Proof.
    induction l as [| x l IH]; intros n [| i]; cbn; try reflexivity.
    - rewrite Nat.add_0_r. reflexivity.
    - rewrite IH. replace (S n + i)%nat with (n + S i)%nat by lia. reflexivity.
  Qed.
  Lemma number_length : forall (A B : Type) (g : nat -> A -> B) l n, length (number g n l) = length l.
  Proof. induction l as [| x l IH]; intros n; cbn; [ reflexivity | rewrite IH; reflexivity ]. Qed.

  Lemma leads_in : forall i rules ms r first, In (r, first) (leads_of (rules_of i rules) ms) <->
    exists m, In m ms /\ first = snd m /\ In r rules /\ exists rest, asks r = (i, fst m) :: rest.
  Proof.
    intros. unfold leads_of, rules_of. rewrite in_flat_map. split.
    - intros (m & Hm & H). apply in_map_iff in H. destruct H as (r' & E & H). inversion E. subst.
      cbn zeta in H. rewrite table_spec in H. apply filter_In in H. destruct H as [H Hb].
      apply filter_In in H. destruct H as [Hr Hl].
      exists m. split; [ exact Hm | split; [ reflexivity | split; [ exact Hr |]]].
      unfold led_by, begins in Hl, Hb. destruct (asks r) as [| [j d] rest]; [ discriminate |].
      apply Nat.eqb_eq in Hl. apply eqb_true in Hb. subst. eauto.
    - intros (m & Hm & E & Hr & rest & Hl). exists m. split; [ exact Hm |]. apply in_map_iff. exists r. subst.
      split; [ reflexivity |]. cbn zeta. rewrite table_spec. apply filter_In. split.
      + apply filter_In. split; [ exact Hr |]. unfold led_by. rewrite Hl. apply Nat.eqb_refl.
      + unfold begins. rewrite Hl. apply eqb_refl.
  Qed.

  Lemma combine_same : forall ms ns, (forall i, same (nth i ms []) (nth i ns [])) ->
    forall wanted, same (combine ms wanted) (combine ns wanted).
  Proof.
    intros ms ns H. induction wanted as [| [i e] rest IH]; intros ch; [ reflexivity |].
    rewrite !combine_in. split; intros (m & c & Hm & E & Hc & Ec); exists m, c;
      (split; [ apply H; exact Hm | split; [ exact E | split; [ apply IH; exact Hc | exact Ec ]]]).
  Qed.

  Lemma able_in : forall ms both q others, In (q, others) (able ms both) <->
    (exists b, In b both /\ In q (snd b)) /\ others = combine ms (tl (asks (fst q))) /\ others <> [].
  Proof.
    intros. unfold able. rewrite in_flat_map. split.
    - intros (b & Hb & H). apply in_flat_map in H. destruct H as (q' & Hq & H).
      destruct (combine ms (tl (asks (fst q')))) as [| c cs] eqn:E; [ destruct H |].
      destruct H as [H | []]. inversion H. subst. repeat split; [ eauto | auto | discriminate ].
    - intros ((b & Hb & Hq) & E & NE). exists b. split; [ exact Hb |]. apply in_flat_map. exists q. split; [ exact Hq |].
      rewrite <- E. destruct others; [ congruence | left; reflexivity ].
  Qed.

  Lemma least_from : forall cs b,
    (forall k, fold_left lesser cs b = Some k ->
       b = Some k \/ exists c, In c cs /\ level (fst (fst c)) = Some k) /\
    (forall l, (b = Some l \/ exists c, In c cs /\ level (fst (fst c)) = Some l) ->
       exists k, fold_left lesser cs b = Some k /\ (to_Z k <= to_Z l)%Z).
  Proof.
    induction cs as [| c cs IH]; intros b; cbn [fold_left].
    - split; [ auto |]. intros l [E | (c & [] & _)]. exists l. split; [ exact E | lia ].
    - destruct (IH (lesser b c)) as [I1 I2]. split.
      + intros k H. destruct (I1 k H) as [E | (d & Hd & E)]; [| right; exists d; split; [ right |]; assumption ].
        unfold lesser in E. destruct (level (fst (fst c))) as [l |] eqn:L; [| left; exact E ].
        destruct b as [k0 |].
        * destruct (l <? k0); [| left; exact E ]. inversion E. subst. right. exists c. split; [ left |]; auto.
        * inversion E. subst. right. exists c. split; [ left |]; auto.
      + intros l H. assert (D : exists k, lesser b c = Some k /\ (to_Z k <= to_Z l)%Z \/
                  exists d, In d cs /\ level (fst (fst d)) = Some l).
        { unfold lesser. destruct H as [E | (d & [E | Hd] & L)].
          - subst. destruct (level (fst (fst c))) as [l' |]; [| exists l; left; split; [ reflexivity | lia ]].
            destruct (l' <? l) eqn:K; [ apply ltb_spec in K; exists l' | exists l ]; left; split; try reflexivity; lia.
          - subst. rewrite L. destruct b as [k0 |]; [| exists l; left; split; [ reflexivity | lia ]].
            destruct (l <? k0) eqn:K; [ exists l; left; split; [ reflexivity | lia ] |].
            exists k0. left. split; [ reflexivity |]. apply not_true_iff_false in K. rewrite ltb_spec in K. lia.
          - exists 0. right. eauto. }
        destruct D as (k & [[E K] | Hd]).
        * destruct (I2 k (or_introl E)) as (k' & E' & K'). exists k'. split; [ exact E' | lia ].
        * exact (I2 l (or_intror Hd)).
  Qed.

  (* The lists of moves in `both`, each with its leads, fire what `fire` does for lists with the same members. *)
  Lemma fast_fire_same : forall rules both ns,
    (forall r, In r rules -> asks r <> []) ->
    (forall i, same (nth i (map fst both) []) (nth i ns [])) ->
    (forall i b, nth_error both i = Some b -> same (snd b) (leads_of (rules_of i rules) (fst b))) ->
    same (fast_fire both) (fire ns rules).
  Proof.
    intros rules both ns Hne Hms Hleads.
    assert (Hc := combine_same _ _ Hms).
    assert (LEAD : forall r first, (exists b, In b both /\ In (r, first) (snd b)) <->
              In r rules /\ exists i e rest m, asks r = (i, e) :: rest /\ In m (nth i ns []) /\ fst m = e /\ snd m = first).
    { intros r first. split.
      - intros (b & Hb & H). apply In_nth_error in Hb. destruct Hb as (i & Hi).
        apply (Hleads i b Hi) in H. apply leads_in in H. destruct H as (m & Hm & E & Hr & rest & Ha).
        split; [ exact Hr |]. exists i, (fst m), rest, m. split; [ exact Ha |]. split; [| auto ].
        apply Hms. rewrite (nth_error_nth (map fst both) i [] (x := fst b)); [ exact Hm |]. apply map_nth_error. exact Hi.
      - intros (Hr & i & e & rest & m & Ha & Hm & E & F0). apply Hms in Hm.
        destruct (nth_error both i) as [b |] eqn:Hi.
        + rewrite (nth_error_nth (map fst both) i [] (x := fst b)) in Hm by (apply map_nth_error; exact Hi).
          exists b. split; [ exact (nth_error_In _ _ Hi) |]. apply (Hleads i b Hi). apply leads_in.
          exists m. subst. eauto.
        + exfalso. rewrite nth_overflow in Hm; [ destruct Hm |]. rewrite map_length. apply nth_error_None. exact Hi. }
    set (cs := able (map fst both) both).
    assert (ABLE : forall r l, In r rules -> level r = Some l ->
              ((exists c, In c cs /\ fst (fst c) = r) <-> nonempty (combine ns (asks r)) = true)).
    { intros r l Hr _. rewrite nonempty_in. split.
      - intros ([[q first] others] & H & E). cbn in E. subst. apply able_in in H. destruct H as (HB & E & NE).
        apply LEAD in HB. destruct HB as (_ & i & e & rest & m & Ha & Hm & Em & Fm). cbn in E. rewrite Ha in *. cbn in E.
        destruct others as [| c0 others]; [ congruence |]. exists (snd m ++ c0). apply combine_in.
        exists m, c0. repeat split; auto. apply Hc. rewrite <- E. left. reflexivity.
      - intros (ch & H). destruct (asks r) as [| [i e] rest] eqn:Ea; [ exfalso; exact (Hne r Hr Ea) |].
        apply combine_in in H. destruct H as (m & c & Hm & E & Hcc & _).
        exists ((r, snd m), combine (map fst both) rest). split; [| reflexivity ]. apply able_in.
        split; [| split ].
        + apply LEAD. split; [ exact Hr |]. exists i, e, rest, m. auto.
        + cbn. rewrite Ea. reflexivity.
        + apply Hc in Hcc. intros K. rewrite K in Hcc. destruct Hcc. }
    assert (IN : forall c, In c cs -> In (fst (fst c)) rules).
    { intros [[q first] others] H. apply able_in in H. destruct H as (HB & _). apply LEAD in HB. apply HB. }
    assert (READY : forall r, In r rules -> ready (least cs) r = negb (prevented ns rules r)).
    { intros r Hr. unfold ready, prevented. destruct (level r) as [l |] eqn:L; [| reflexivity ].
      destruct (least_from cs None) as [L1 L2].
      assert (K : existsb (fun q => before q l && nonempty (combine ns (asks q))) rules = true <->
                  exists k, least cs = Some k /\ (k <? l) = true).
      { rewrite existsb_exists. split.
        - intros (q & Hq & K). apply andb_true_iff in K. destruct K as [K1 K2]. unfold before in K1.
          destruct (level q) as [k |] eqn:Lq; [| discriminate].
          apply (ABLE q k Hq Lq) in K2. destruct K2 as (c & Hcs & Ec).
          destruct (L2 k) as (k' & E & Hk); [ right; exists c; rewrite Ec; auto |].
          exists k'. split; [ exact E |]. apply ltb_spec in K1. apply ltb_spec. lia.
        - intros (k & E & K). destruct (L1 k E) as [X | (c & Hcs & Lc)]; [ discriminate |].
          exists (fst (fst c)). split; [ apply IN; exact Hcs |]. apply andb_true_iff. split.
          + unfold before. rewrite Lc. exact K.
          + apply (ABLE _ k (IN c Hcs) Lc). eauto. }
      destruct (existsb _ rules) eqn:X.
      - destruct (proj1 K eq_refl) as (k & E & Hk). rewrite E, Hk. reflexivity.
      - destruct (least cs) as [k |] eqn:E; [| reflexivity ]. destruct (k <? l) eqn:Hk; [| reflexivity ].
        exfalso. assert (false = true) by (apply K; eauto). discriminate. }
    intros [a ch]. unfold fast_fire, fire. fold cs. cbn zeta. rewrite !in_flat_map. split.
    - intros ([[r first] others] & H & Hx). pose proof (IN _ H) as Hr. cbn in Hr.
      rewrite (READY r Hr) in Hx. destruct (prevented ns rules r) eqn:PV; [ destruct Hx |]. cbn in Hx.
      apply in_map_iff in Hx. destruct Hx as (c & E & Hcc). apply able_in in H. destruct H as (HB & Eo & _).
      apply LEAD in HB. destruct HB as (_ & i & e & rest & m & Ha & Hm & Em & Fm). cbn in Eo. rewrite Ha in Eo. cbn in Eo.
      exists r. split; [ exact Hr |]. rewrite PV. apply in_map_iff. exists (first ++ c). split; [ exact E |].
      rewrite Ha. apply combine_in. exists m, c. subst. repeat split; auto. apply Hc. exact Hcc.
    - intros (r & Hr & H). pose proof (READY r Hr) as RD. destruct (prevented ns rules r) eqn:PV; [ destruct H |].
      apply in_map_iff in H. destruct H as (c & E & H).
      destruct (asks r) as [| [i e] rest] eqn:Ea; [ exfalso; exact (Hne r Hr Ea) |].
      apply combine_in in H. destruct H as (m & c' & Hm & Em & Hcc & Ec). apply Hc in Hcc.
      exists ((r, snd m), combine (map fst both) rest). split.
      + apply able_in. split; [| split ].
        * apply LEAD. split; [ exact Hr |]. exists i, e, rest, m. auto.
        * cbn. rewrite Ea. reflexivity.
        * intros K. rewrite K in Hcc. destruct Hcc.
      + rewrite RD. cbn. apply in_map_iff. exists c'. split; [ rewrite <- E, Ec; reflexivity | exact Hcc ].
  Qed.

  Fixpoint asking (r : region) : bool :=
    match r with
    | Region inside rules => forallb (fun r => nonempty (asks r)) rules &&
        forallb (fun p => match p with Slot _ => true | Inner r' => asking r' end) inside
    end.

  Lemma fast_moves_same : forall s r, asking r = true -> same (fast_moves s (prepare r)) (moves Y s r).
  Proof.
    intros s. induction r as [inside rules IH] using region_rect'. intros A. cbn in A.
    apply andb_true_iff in A. destruct A as [A1 A2]. rewrite forallb_forall in A1, A2. cbn [prepare fast_moves moves].
    apply fast_fire_same.
    - intros r Hr K. specialize (A1 r Hr). rewrite K in A1. discriminate.
    - intros i. rewrite !nth_by_error, !nth_error_map, number_error, nth_error_map.
      destruct (nth_error inside i) as [p |] eqn:Hp; cbn; [| apply same_refl ]. destruct p as [k | r]; cbn.
      + rewrite table_spec. apply same_refl.
      + apply IH; [ exact (nth_error_In _ _ Hp) | exact (A2 _ (nth_error_In _ _ Hp)) ].
    - intros i b Hb. rewrite nth_error_map, number_error, nth_error_map in Hb.
      destruct (nth_error inside i) as [p |]; [| discriminate ]. cbn in Hb. inversion Hb. subst. clear Hb.
      destruct p as [k | r]; cbn; [| apply same_refl ].
      rewrite !table_spec. apply same_refl.
  Qed.
End Fast.
