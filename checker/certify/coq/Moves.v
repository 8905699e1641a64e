(* SPDX-License-Identifier: Apache-2.0 *)
(* Computes the moves of a compiled process faster, from packed states, and proves that they are the same. Rules are
   listed under the event of their first participant. Tables contain the ways in which a component performs an event.
   The least level is computed only once. *)
From Coq Require Import List Bool ZArith Lia Uint63 PArray.
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

Fixpoint no_repetition (l : list nat) : bool :=
  match l with [] => true | x :: l => negb (existsb (Nat.eqb x) l) && no_repetition l end.
Lemma no_repetition_ok : forall l, no_repetition l = true -> NoDup l.
Proof.
  induction l as [| x l IH]; intros H; [ constructor |]. cbn in H. apply andb_true_iff in H. destruct H as [N H].
  constructor; [| exact (IH H) ]. intros K. apply negb_true_iff in N. apply not_true_iff_false in N. apply N.
  apply existsb_exists. exists x. split; [ exact K | apply Nat.eqb_refl ].
Qed.
Lemma fold_in : forall A B (f : B -> list A -> list A) (R : B -> A -> Prop),
  (forall y acc x, In x (f y acc) <-> In x acc \/ R y x) ->
  forall l acc x, In x (fold_left (fun acc y => f y acc) l acc) <-> In x acc \/ exists y, In y l /\ R y x.
Proof.
  intros A B f R H. induction l as [| y l IH]; intros acc x; cbn [fold_left].
  - split; [ auto |]. intros [K | (y & [] & _)]. exact K.
  - rewrite IH, H. split.
    + intros [[K | K] | (z & Hz & K)]; [ auto | |]; right; [ exists y | exists z ]; split; auto; [ left | right ]; auto.
    + intros [K | (z & [E | Hz] & K)]; [ auto | subst; auto |]. right. exists z. auto.
Qed.

Section Fast.
  Variable Y : system.
  (* The lengths of tables. Other lengths only make the functions slower. *)
  Variable events : int.
  Variable local_states : nat -> int.
  (* Packed states: how to read the state of a component, and how to represent a change of it. *)
  Variable packed_state packed_change : Type.
  Variable local : nat -> packed_state -> int.
  Variable set_local : nat -> int -> packed_change.
  Definition set_all (ch : list change) : list packed_change := map (fun c => set_local (fst c) (snd c)) ch.
  Definition fmove := (ev * list packed_change)%type.

  (* What a rule requires of a component or of an inner region. *)
  Inductive ask :=
    AskSlot (get : packed_state -> int) (ways : int -> list (list packed_change)) | AskInner (i : nat) (e : ev).
  (* A rule without its first requirement. A lead also contains the changes of the first participant. *)
  Record frule := { f_does : ev; f_level : option int; f_asks : list ask; f_puts : list packed_change }.
  Definition lead := (frule * list packed_change)%type.
  Inductive fregion := FRegion (prioritised : bool) (inside : list fparticipant)
  with fparticipant :=
    FSlot (get : packed_state -> int) (leads : int -> list lead) | FInner (i : nat) (r : fregion) (find : ev -> list frule).

  (** Preparation. *)
  Definition led_by (i : nat) (r : rule) : bool := match asks r with (j, _) :: _ => Nat.eqb i j | [] => false end.
  Definition begins (e : ev) (r : rule) : bool := match asks r with (_, d) :: _ => e =? d | [] => false end.
  Definition slot_ways (k : nat) (e : ev) (v : int) : list (list packed_change) :=
    flat_map (fun x : ev * int => if fst x =? e then [[set_local k (snd x)]] else []) (edges Y k v).
  (* The events that rules require of participant i, except as first requirements. Only these events have tables. *)
  Definition asked (i : nat) (rules : list rule) : array bool :=
    fold_left (fun t r => fold_left (fun t (a : nat * ev) => if Nat.eqb (fst a) i then t.[snd a <- true] else t)
                                    (tl (asks r)) t) rules (make events false).
  Definition asker (rules : list rule) (i : nat) (p : participant) : ev -> ask :=
    match p with
    | Slot k =>
        let wanted := asked i rules in
        let ways := table events (fun e => if wanted.[e] then table (local_states k) (slot_ways k e) else slot_ways k e) in
        let get := local k in
        fun e => AskSlot get (ways e)
    | Inner _ => AskInner i
    end.
  Fixpoint number {A B} (g : nat -> A -> B) (n : nat) (l : list A) : list B :=
    match l with [] => [] | x :: l' => g n x :: number g (S n) l' end.
  Definition ask_of (askers : list (ev -> ask)) (a : nat * ev) : ask :=
    match nth_error askers (fst a) with Some f => f (snd a) | None => AskInner (fst a) (snd a) end.
  Definition frule_of (askers : list (ev -> ask)) (r : rule) : frule :=
    {| f_does := does r; f_level := level r; f_asks := map (ask_of askers) (tl (asks r)); f_puts := set_all (puts r) |}.
  Definition rules_of (i : nat) (rules : list (rule * frule)) : ev -> list frule :=
    let mine := filter (fun r => led_by i (fst r)) rules in
    table events (fun e => map snd (filter (fun r => begins e (fst r)) mine)).
  Definition slot_leads (find : ev -> list frule) (k : nat) (v : int) : list lead :=
    flat_map (fun x : ev * int => map (fun r => (r, [set_local k (snd x)])) (find (fst x))) (edges Y k v).
  Definition has_level (r : rule) : bool := match level r with Some _ => true | None => false end.
  Fixpoint prepare (r : region) : fregion :=
    match r with
    | Region inside rules =>
        let askers := number (asker rules) 0 inside in
        let both := map (fun r => (r, frule_of askers r)) rules in
        FRegion (existsb has_level rules) (number (fun i g => g i) 0 (map (fun p i =>
          let find := rules_of i both in
          match p with
          | Slot k => FSlot (local k) (table (local_states k) (slot_leads find k))
          | Inner r' => FInner i (prepare r') find
          end) inside))
    end.

  (** Moves. *)
  Definition inner_list := list (nat * list fmove).  (* by participant *)
  Fixpoint inner_moves (i : nat) (l : inner_list) : list fmove :=
    match l with [] => [] | (j, moves) :: rest => if Nat.eqb i j then moves else inner_moves i rest end.
  Definition fulfil (c : packed_state) (l : inner_list) (a : ask) : list (list packed_change) :=
    match a with
    | AskSlot get ways => ways (get c)
    | AskInner i e => flat_map (fun m : fmove => if fst m =? e then [snd m] else []) (inner_moves i l)
    end.
  Fixpoint others (c : packed_state) (l : inner_list) (wanted : list ask) : list (list packed_change) :=
    match wanted with
    | [] => [[]]
    | a :: rest =>
        match fulfil c l a with
        | [] => []
        | ways => match rest with [] => ways | _ => flat_map (fun x => map (app x) (others c l rest)) ways end
        end
    end.
  Definition leads_of (c : packed_state) (l : inner_list) (p : fparticipant) : list lead :=
    match p with
    | FSlot get leads => leads (get c)
    | FInner i _ find => flat_map (fun m : fmove => map (fun r => (r, snd m)) (find (fst m))) (inner_moves i l)
    end.
  (* Goes through the leads of a participant without a list of them. *)
  Definition fold_leads {A} (f : A -> lead -> A) (c : packed_state) (l : inner_list) (p : fparticipant) (acc : A) : A :=
    match p with
    | FSlot get leads => fold_left f (leads (get c)) acc
    | FInner i _ find =>
        fold_left (fun acc m => let (e, first) := m : fmove in fold_left (fun acc r => f acc (r, first)) (find e) acc)
                  (inner_moves i l) acc
    end.
  (* Most rules have one participant, whose lists are not copied. *)
  Definition extend (first way : list packed_change) : list packed_change :=
    match way with [] => first | _ => first ++ way end.
  Definition add_moves (q : lead) (ways : list (list packed_change)) (acc : list fmove) : list fmove :=
    let (r, first) := q in
    fold_left (fun acc way => (f_does r, match f_puts r with [] => extend first way | p => first ++ (way ++ p) end) :: acc)
              ways acc.
  Definition fire_all (c : packed_state) (l : inner_list) (inside : list fparticipant) : list fmove :=
    fold_left (fun acc p =>
      fold_leads (fun acc q => add_moves q (others c l (f_asks (fst q))) acc) c l p acc) inside [].

  Definition candidate := (lead * list (list packed_change))%type.
  Definition add_candidate (c : packed_state) (l : inner_list) (q : lead) (acc : list candidate) : list candidate :=
    match others c l (f_asks (fst q)) with [] => acc | ways => (q, ways) :: acc end.
  Definition candidates (c : packed_state) (l : inner_list) (inside : list fparticipant) : list candidate :=
    fold_left (fun acc p => fold_leads (fun acc q => add_candidate c l q acc) c l p acc) inside [].
  Definition lesser (b : option int) (c : candidate) : option int :=
    match f_level (fst (fst c)) with
    | None => b
    | Some l => match b with None => Some l | Some k => if l <? k then Some l else b end
    end.
  Definition least (cs : list candidate) : option int := fold_left lesser cs None.
  Definition ready (b : option int) (r : frule) : bool :=
    match f_level r with None => true | Some l => match b with None => true | Some k => negb (k <? l) end end.
  Definition fire_ready (cs : list candidate) : list fmove :=
    let b := least cs in
    fold_left (fun acc c => if ready b (fst (fst c)) then add_moves (fst c) (snd c) acc else acc) cs [].
  Fixpoint fast_moves (c : packed_state) (r : fregion) : list fmove :=
    match r with
    | FRegion prioritised inside =>
        let l := flat_map (fun p => match p with FSlot _ _ => [] | FInner i r' _ => [(i, fast_moves c r')] end) inside in
        if prioritised then fire_ready (candidates c l inside) else fire_all c l inside
    end.

  (** The moves are the same. *)
  Lemma number_error : forall (A B : Type) (g : nat -> A -> B) l n i,
    nth_error (number g n l) i = option_map (g (n + i)%nat) (nth_error l i).
  Proof.
    induction l as [| x l IH]; intros n [| i]; cbn; try reflexivity.
    - rewrite Nat.add_0_r. reflexivity.
    - rewrite IH. replace (S n + i)%nat with (n + S i)%nat by lia. reflexivity.
  Qed.
  Lemma set_all_app : forall x y, set_all (x ++ y) = set_all x ++ set_all y.
  Proof. intros. unfold set_all. apply map_app. Qed.

  Lemma fold_leads_list : forall A (f : A -> lead -> A) c l p acc,
    fold_leads f c l p acc = fold_left f (leads_of c l p) acc.
  Proof.
    intros A f c l [get leads | i r find] acc; [ reflexivity |]. cbn [fold_leads leads_of]. revert acc.
    induction (inner_moves i l) as [| [e first] ms IH]; intros acc; [ reflexivity |].
    cbn [fold_left flat_map fst snd]. rewrite fold_left_app, IH. f_equal. revert acc.
    induction (find e) as [| x rs IH']; intros acc; [ reflexivity |]. cbn. apply IH'.
  Qed.
  Lemma extend_app : forall first way, extend first way = first ++ way.
  Proof. intros first [| c way]; cbn; [ symmetry; apply app_nil_r | reflexivity ]. Qed.
  Lemma add_moves_in : forall q ways acc a x, In (a, x) (add_moves q ways acc) <->
    In (a, x) acc \/ exists way, In way ways /\ a = f_does (fst q) /\ x = snd q ++ (way ++ f_puts (fst q)).
  Proof.
    intros [r first] ways acc a x. unfold add_moves.
    rewrite (fold_in fmove (list packed_change)
               (fun way acc => (f_does r, match f_puts r with [] => extend first way | p => first ++ (way ++ p) end) :: acc)
               (fun way y => y = (f_does r, first ++ (way ++ f_puts r)))).
    - cbn [fst snd]. split; (intros [K | (way & Hw & K)]; [ auto | right; exists way; split; [ exact Hw |] ]).
      + inversion K. auto.
      + destruct K. subst. reflexivity.
    - intros way acc' y. rewrite extend_app. destruct (f_puts r); rewrite ?app_nil_r; cbn [In]; intuition auto.
  Qed.

  (* `ms` are the moves of the participants of a region, `rules` are its rules, and `f` prepares the rules. *)
  Section Fire.
    Variable c : packed_state.
    Variable l : inner_list.
    Variable ms : list (list move).
    Variable rules : list rule.
    Variable inside : list fparticipant.
    Variable askers : list (ev -> ask).
    Let f := frule_of askers.
    Hypothesis askings : forall a x, In x (fulfil c l (ask_of askers a)) <->
      exists m, In m (nth (fst a) ms []) /\ fst m = snd a /\ x = set_all (snd m).
    Hypothesis leadings : forall q, (exists p, In p inside /\ In q (leads_of c l p)) <->
      exists r i e rest m, In r rules /\ asks r = (i, e) :: rest /\ In m (nth i ms []) /\ fst m = e /\
        q = (f r, set_all (snd m)).
    Hypothesis nonvoid : forall r, In r rules -> asks r <> [].

    Lemma others_in : forall wanted x, In x (others c l (map (ask_of askers) wanted)) <->
      exists ch, In ch (combine ms wanted) /\ x = set_all ch.
    Proof.
      assert (PLAIN : forall a rest x,
        In x (flat_map (fun y => map (app y) (others c l rest)) (fulfil c l a)) <-> In x (others c l (a :: rest))).
      { intros a rest x. cbn [others]. destruct (fulfil c l a) as [| w ways]; [ reflexivity |].
        destruct rest as [| b rest]; [| reflexivity ]. cbn [others]. rewrite in_flat_map. split.
        - intros (y & Hy & H). destruct H as [H | []]. rewrite app_nil_r in H. subst. exact Hy.
        - intros H. exists x. split; [ exact H |]. left. apply app_nil_r. }
      induction wanted as [| [i e] rest IH]; intros x.
      - cbn. split.
        + intros [H | []]. subst. exists []. auto.
        + intros (ch & [H | []] & E). subst. auto.
      - cbn [map]. rewrite <- PLAIN, in_flat_map. split.
        + intros (y & Hy & H). apply askings in Hy. destruct Hy as (m & Hm & Em & Ey). apply in_map_iff in H.
          destruct H as (z & Ez & Hz). apply IH in Hz. destruct Hz as (ch & Hch & Ec). exists (snd m ++ ch).
          split; [ apply combine_in; eauto 6 |]. subst. symmetry. apply set_all_app.
        + intros (ch & H & E). apply combine_in in H. destruct H as (m & c' & Hm & Em & Hc & Ec).
          exists (set_all (snd m)). split; [ apply askings; eauto |]. apply in_map_iff. exists (set_all c'). subst.
          split; [ symmetry; apply set_all_app |]. apply IH. eauto.
    Qed.

    Lemma fire_all_in : existsb has_level rules = false -> forall a x, In (a, x) (fire_all c l inside) <->
      exists ch, In (a, ch) (fire ms rules) /\ x = set_all ch.
    Proof.
      intros NL a x. unfold fire_all.
      set (adds := fun (q : lead) (y : fmove) => exists way, In way (others c l (f_asks (fst q))) /\
        fst y = f_does (fst q) /\ snd y = snd q ++ (way ++ f_puts (fst q))).
      rewrite (fold_in _ _ (fun p acc => fold_leads (fun acc q => add_moves q (others c l (f_asks (fst q))) acc) c l p acc)
                 (fun p y => exists q, In q (leads_of c l p) /\ adds q y)).
      2: { intros p acc y. rewrite fold_leads_list. apply (fold_in _ _ (fun q acc => add_moves q (others c l (f_asks (fst q))) acc) adds).
           intros q acc' [a' x']. apply add_moves_in. }
      unfold adds. clear adds.
      assert (FREE : forall r, In r rules -> prevented ms rules r = false).
      { intros r Hr. unfold prevented. destruct (level r) as [k |] eqn:L; [| reflexivity ]. exfalso.
        assert (existsb has_level rules = true); [| congruence ]. apply existsb_exists. exists r. split; [ exact Hr |].
        unfold has_level. rewrite L. reflexivity. }
      unfold fire. cbn [fst snd]. split.
      - intros [[] | (p & Hp & q & Hq & way & Hw & Ea & Ex)].
        assert (LQ : exists p, In p inside /\ In q (leads_of c l p)) by eauto. apply leadings in LQ.
        destruct LQ as (r & i & e & rest & m & Hr & Ar & Hm & Em & Eq). subst q. cbn [fst snd] in *.
        unfold f, frule_of in Hw, Ea, Ex. cbn [f_asks f_does f_puts] in Hw, Ea, Ex. rewrite Ar in Hw. cbn [tl] in Hw.
        apply others_in in Hw. destruct Hw as (c' & Hc & Ec). exists ((snd m ++ c') ++ puts r). split.
        + apply in_flat_map. exists r. split; [ exact Hr |]. rewrite (FREE r Hr). apply in_map_iff.
          exists (snd m ++ c'). split; [ subst a; reflexivity |]. rewrite Ar. apply combine_in. eauto 6.
        + subst. rewrite !set_all_app, app_assoc. reflexivity.
      - intros (ch & H & Ex). right. apply in_flat_map in H. destruct H as (r & Hr & H). rewrite (FREE r Hr) in H.
        apply in_map_iff in H. destruct H as (ch' & E & H). inversion E. subst a ch. clear E.
        destruct (asks r) as [| [i e] rest] eqn:Ar; [ exfalso; exact (nonvoid r Hr Ar) |].
        apply combine_in in H. destruct H as (m & c' & Hm & Em & Hc & Ec).
        assert (LQ : exists p, In p inside /\ In (f r, set_all (snd m)) (leads_of c l p)).
        { apply leadings. exists r, i, e, rest, m. auto. }
        destruct LQ as (p & Hp & Hq). exists p. split; [ exact Hp |]. exists (f r, set_all (snd m)). split; [ exact Hq |].
        exists (set_all c'). cbn [fst snd]. unfold f, frule_of. cbn [f_asks f_does f_puts]. rewrite Ar. cbn [tl].
        split; [ apply others_in; eauto |]. split; [ reflexivity |]. subst. rewrite !set_all_app, app_assoc. reflexivity.
    Qed.

    Lemma candidates_in : forall q ways, In (q, ways) (candidates c l inside) <->
      (exists p, In p inside /\ In q (leads_of c l p)) /\ ways = others c l (f_asks (fst q)) /\ ways <> [].
    Proof.
      intros q ways. unfold candidates.
      set (adds := fun (q : lead) (y : candidate) => y = (q, others c l (f_asks (fst q))) /\ others c l (f_asks (fst q)) <> []).
      rewrite (fold_in _ _ (fun p acc => fold_leads (fun acc q => add_candidate c l q acc) c l p acc)
                 (fun p y => exists q, In q (leads_of c l p) /\ adds q y)).
      2: { intros p acc y. rewrite fold_leads_list. apply (fold_in _ _ (add_candidate c l) adds). intros q' acc' y'. unfold add_candidate, adds. destruct (others c l (f_asks (fst q'))) as [| w ws].
           - split; [ auto |]. intros [K | [_ K]]; [ exact K | congruence ].
           - cbn [In]. split; [ intros [K | K]; [ right | auto ] | intros [K | [K _]]; auto ].
             split; [ auto | discriminate ]. }
      unfold adds. split.
      - intros [[] | (p & Hp & q' & Hq & E & NE)]. inversion E. subst. eauto 6.
      - intros ((p & Hp & Hq) & E & NE). right. exists p. split; [ exact Hp |]. exists q. subst. auto.
    Qed.
    Lemma candidate_rule : forall q ways, In (q, ways) (candidates c l inside) <->
      exists r i e rest m, In r rules /\ asks r = (i, e) :: rest /\ In m (nth i ms []) /\ fst m = e /\
        q = (f r, set_all (snd m)) /\ ways = others c l (map (ask_of askers) rest) /\ ways <> [].
    Proof.
      intros q ways. rewrite candidates_in, leadings. split.
      - intros ((r & i & e & rest & m & Hr & Ar & Hm & Em & Eq) & Ew & NE). exists r, i, e, rest, m.
        repeat split; auto. subst q. unfold f, frule_of in Ew. cbn [fst f_asks] in Ew. rewrite Ar in Ew. exact Ew.
      - intros (r & i & e & rest & m & Hr & Ar & Hm & Em & Eq & Ew & NE). split; [ exists r, i, e, rest, m; auto |].
        split; [| exact NE ]. subst q. unfold f, frule_of. cbn [fst f_asks]. rewrite Ar. exact Ew.
    Qed.
    Lemma least_from : forall cs b,
      (forall k, fold_left lesser cs b = Some k ->
         b = Some k \/ exists d0, In d0 cs /\ f_level (fst (fst d0)) = Some k) /\
      (forall lv, (b = Some lv \/ exists d0, In d0 cs /\ f_level (fst (fst d0)) = Some lv) ->
         exists k, fold_left lesser cs b = Some k /\ (to_Z k <= to_Z lv)%Z).
    Proof.
      induction cs as [| d0 cs IH]; intros b; cbn [fold_left].
      - split; [ auto |]. intros lv [E | (d0 & [] & _)]. exists lv. split; [ exact E | lia ].
      - destruct (IH (lesser b d0)) as [I1 I2]. split.
        + intros k H. destruct (I1 k H) as [E | (d & Hd & E)]; [| right; exists d; split; [ right |]; assumption ].
          unfold lesser in E. destruct (f_level (fst (fst d0))) as [lv |] eqn:L; [| left; exact E ].
          destruct b as [k0 |].
          * destruct (lv <? k0); [| left; exact E ]. inversion E. subst. right. exists d0. split; [ left |]; auto.
          * inversion E. subst. right. exists d0. split; [ left |]; auto.
        + intros lv H. assert (D : exists k, lesser b d0 = Some k /\ (to_Z k <= to_Z lv)%Z \/
                    exists d, In d cs /\ f_level (fst (fst d)) = Some lv).
          { unfold lesser. destruct H as [E | (d & [E | Hd] & L)].
            - subst. destruct (f_level (fst (fst d0))) as [lv' |]; [| exists lv; left; split; [ reflexivity | lia ]].
              destruct (lv' <? lv) eqn:K; [ apply ltb_spec in K; exists lv' | exists lv ]; left; split; try reflexivity; lia.
            - subst. rewrite L. destruct b as [k0 |]; [| exists lv; left; split; [ reflexivity | lia ]].
              destruct (lv <? k0) eqn:K; [ exists lv; left; split; [ reflexivity | lia ] |].
              exists k0. left. split; [ reflexivity |]. apply not_true_iff_false in K. rewrite ltb_spec in K. lia.
            - exists 0. right. eauto. }
          destruct D as (k & [[E K] | Hd]).
          * destruct (I2 k (or_introl E)) as (k' & E' & K'). exists k'. split; [ exact E' | lia ].
          * exact (I2 lv (or_intror Hd)).
    Qed.


    Lemma ready_same : forall r, In r rules -> ready (least (candidates c l inside)) (f r) = negb (prevented ms rules r).
    Proof.
      intros r Hr. unfold ready, prevented. unfold f at 1, frule_of. cbn [f_level].
      destruct (level r) as [k |] eqn:L; [| reflexivity ].
      set (cs := candidates c l inside).
      assert (SAME : forall n, (exists d, In d cs /\ f_level (fst (fst d)) = Some n) <->
                exists q, In q rules /\ level q = Some n /\ nonempty (combine ms (asks q)) = true).
      { intros n. split.
        - intros ([q ways] & H & E). apply candidate_rule in H.
          destruct H as (r' & i & e & rest & m & Hr' & Ar & Hm & Em & Eq & Ew & NE). subst q. cbn in E.
          exists r'. split; [ exact Hr' |]. split; [ exact E |]. apply nonempty_in. rewrite Ar.
          destruct ways as [| w ways]; [ congruence |].
          assert (Hw : In w (others c l (map (ask_of askers) rest))) by (rewrite <- Ew; left; reflexivity).
          apply others_in in Hw. destruct Hw as (ch & Hch & _). exists (snd m ++ ch). apply combine_in. eauto 6.
        - intros (r' & Hr' & E & NE). apply nonempty_in in NE. destruct NE as (ch & H).
          destruct (asks r') as [| [i e] rest] eqn:Ar; [ exfalso; exact (nonvoid r' Hr' Ar) |].
          apply combine_in in H. destruct H as (m & c' & Hm & Em & Hc & _).
          assert (Hw : In (set_all c') (others c l (map (ask_of askers) rest))) by (apply others_in; eauto).
          exists ((f r', set_all (snd m)), others c l (map (ask_of askers) rest)). split; [| exact E ].
          apply candidate_rule. exists r', i, e, rest, m. repeat split; auto. intros K. rewrite K in Hw. destruct Hw. }
      destruct (least_from cs None) as [L1 L2].
      assert (K : existsb (fun q => before q k && nonempty (combine ms (asks q))) rules = true <->
                  exists n, least cs = Some n /\ (n <? k) = true).
      { rewrite existsb_exists. split.
        - intros (q & Hq & K). apply andb_true_iff in K. destruct K as [K1 K2]. unfold before in K1.
          destruct (level q) as [n |] eqn:Lq; [| discriminate].
          destruct (L2 n) as (n' & E & Hn); [ right; apply SAME; eauto |].
          exists n'. split; [ exact E |]. apply ltb_spec in K1. apply ltb_spec. lia.
        - intros (n & E & Hn). destruct (L1 n E) as [X | X]; [ discriminate |]. apply SAME in X.
          destruct X as (q & Hq & Lq & NE). exists q. split; [ exact Hq |]. unfold before. rewrite Lq, Hn. exact NE. }
      destruct (existsb _ rules) eqn:X.
      - destruct (proj1 K eq_refl) as (n & E & Hn). rewrite E, Hn. reflexivity.
      - destruct (least cs) as [n |] eqn:E; [| reflexivity ]. destruct (n <? k) eqn:Hn; [| reflexivity ].
        exfalso. assert (false = true) by (apply K; eauto). discriminate.
    Qed.

    Lemma fire_ready_in : forall a x, In (a, x) (fire_ready (candidates c l inside)) <->
      exists ch, In (a, ch) (fire ms rules) /\ x = set_all ch.
    Proof.
      intros a x. unfold fire_ready. cbn zeta. set (b := least (candidates c l inside)).
      rewrite (fold_in _ _ (fun (d : candidate) acc => if ready b (fst (fst d)) then add_moves (fst d) (snd d) acc else acc)
                 (fun (d : candidate) y => ready b (fst (fst d)) = true /\ exists way, In way (snd d) /\
        fst y = f_does (fst (fst d)) /\ snd y = snd (fst d) ++ (way ++ f_puts (fst (fst d))))).
      2: { intros d acc [a' x']. destruct (ready b (fst (fst d))).
           - rewrite add_moves_in. cbn [fst snd]. intuition auto.
           - split; [ auto |]. intros [K | [K _]]; [ exact K | discriminate ]. }
      unfold fire. cbn [fst snd]. split.
      - intros [[] | ([q ways] & Hd & RD & way & Hw & Ea & Ex)]. cbn [fst snd] in *. apply candidate_rule in Hd.
        destruct Hd as (r & i & e & rest & m & Hr & Ar & Hm & Em & Eq & Ew & _). subst q ways. cbn [fst snd] in *.
        apply others_in in Hw. destruct Hw as (c' & Hc & Ec). exists ((snd m ++ c') ++ puts r). split.
        + apply in_flat_map. exists r. split; [ exact Hr |]. unfold b in RD. rewrite (ready_same r Hr) in RD.
          apply negb_true_iff in RD. rewrite RD. apply in_map_iff. exists (snd m ++ c').
          split; [ subst a; reflexivity |]. rewrite Ar. apply combine_in. eauto 6.
        + subst. unfold f, frule_of. cbn [f_puts]. rewrite !set_all_app, app_assoc. reflexivity.
      - intros (ch & H & Ex). right. apply in_flat_map in H. destruct H as (r & Hr & H).
        destruct (prevented ms rules r) eqn:PV; [ destruct H |].
        apply in_map_iff in H. destruct H as (ch' & E & H). inversion E. subst a ch. clear E.
        destruct (asks r) as [| [i e] rest] eqn:Ar; [ exfalso; exact (nonvoid r Hr Ar) |].
        apply combine_in in H. destruct H as (m & c' & Hm & Em & Hc & Ec).
        assert (Hw : In (set_all c') (others c l (map (ask_of askers) rest))) by (apply others_in; eauto).
        exists ((f r, set_all (snd m)), others c l (map (ask_of askers) rest)). split.
        { apply candidate_rule. exists r, i, e, rest, m. repeat split; auto. intros K. rewrite K in Hw. destruct Hw. }
        cbn [fst snd]. split; [ unfold b; rewrite (ready_same r Hr), PV; reflexivity |].
        exists (set_all c'). split; [ exact Hw |]. split; [ reflexivity |]. subst. unfold f, frule_of. cbn [f_puts].
        rewrite !set_all_app, app_assoc. reflexivity.
    Qed.
  End Fire.

  Fixpoint asking (r : region) : bool :=
    match r with
    | Region inside rules => forallb (fun r => nonempty (asks r)) rules &&
        forallb (fun p => match p with Slot _ => true | Inner r' => asking r' end) inside
    end.

  Lemma inner_none : forall i l, (forall e, In e l -> fst e <> i) -> inner_moves i l = [].
  Proof.
    induction l as [| [j moves] l IH]; intros H; [ reflexivity |]. cbn.
    destruct (Nat.eqb i j) eqn:E; [| apply IH; intros e He; apply H; right; exact He ].
    apply Nat.eqb_eq in E. exfalso. apply (H (j, moves)); [ left; reflexivity | cbn; auto ].
  Qed.
  Definition inner_of (c : packed_state) (p : fparticipant) : inner_list :=
    match p with FSlot _ _ => [] | FInner i r _ => [(i, fast_moves c r)] end.
  Lemma inner_found : forall c fs n i,
    (forall k p, nth_error fs k = Some p -> match p with FInner j _ _ => j = (n + k)%nat | FSlot _ _ => True end) ->
    inner_moves (n + i) (flat_map (inner_of c) fs) =
      match nth_error fs i with Some (FInner _ r _) => fast_moves c r | _ => [] end.
  Proof.
    induction fs as [| p fs IH]; intros n i H; [ destruct i; reflexivity |].
    assert (H' : forall k q, nth_error fs k = Some q -> match q with FInner j _ _ => j = (S n + k)%nat | FSlot _ _ => True end).
    { intros k q K. specialize (H (S k) q K). destruct q; [ exact I | lia ]. }
    assert (LATER : forall e, In e (flat_map (inner_of c) fs) -> fst e <> n).
    { intros e He. apply in_flat_map in He. destruct He as (q & Hq & He). apply In_nth_error in Hq. destruct Hq as (k & Hk).
      specialize (H' k q Hk). destruct q; [ destruct He |]. destruct He as [E | []]. subst e. cbn. lia. }
    destruct i as [| i].
    - rewrite Nat.add_0_r. cbn [nth_error flat_map]. specialize (H 0%nat p eq_refl). destruct p as [get leads | j r find].
      + cbn [inner_of app]. apply inner_none. exact LATER.
      + cbn [inner_of app inner_moves]. replace (Nat.eqb n j) with true; [ reflexivity |]. symmetry. apply Nat.eqb_eq. lia.
    - cbn [nth_error flat_map]. specialize (IH (S n) i H'). specialize (H 0%nat p eq_refl).
      replace (n + S i)%nat with (S n + i)%nat by lia. destruct p as [get leads | j r find]; [ exact IH |].
      cbn [inner_of app inner_moves]. replace (Nat.eqb (S n + i) j) with false; [ exact IH |].
      symmetry. apply Nat.eqb_neq. lia.
  Qed.

  Lemma rules_of_in : forall i rules askers e fr,
    In fr (rules_of i (map (fun r => (r, frule_of askers r)) rules) e) <->
    exists r rest, In r rules /\ asks r = (i, e) :: rest /\ fr = frule_of askers r.
  Proof.
    intros. unfold rules_of. cbn zeta. rewrite table_spec, in_map_iff. split.
    - intros ([r fr'] & E & H). cbn in E. subst fr'. apply filter_In in H. destruct H as [H B]. apply filter_In in H.
      destruct H as [H L]. apply in_map_iff in H. destruct H as (r' & E & Hr). inversion E. subst. cbn [fst] in *.
      unfold led_by, begins in L, B. destruct (asks r) as [| [j d] rest] eqn:Ar; [ discriminate |].
      apply Nat.eqb_eq in L. apply eqb_true in B. subst. exists r, rest. auto.
    - intros (r & rest & Hr & Ar & E). exists (r, fr). split; [ reflexivity |]. apply filter_In. split; [ apply filter_In; split |].
      + apply in_map_iff. exists r. subst. auto.
      + cbn. unfold led_by. rewrite Ar. apply Nat.eqb_refl.
      + cbn. unfold begins. rewrite Ar. apply eqb_refl.
  Qed.

  Lemma fast_moves_same : forall s c, (forall k, local k c = nth k s 0) -> forall r, asking r = true ->
    forall a x, In (a, x) (fast_moves c (prepare r)) <-> exists ch, In (a, ch) (moves Y s r) /\ x = set_all ch.
  Proof.
    intros s c HL. induction r as [inside rules IH] using region_rect'. intros A. cbn in A.
    apply andb_true_iff in A. destruct A as [A1 A2]. rewrite forallb_forall in A1, A2.
    assert (NV : forall r, In r rules -> asks r <> []).
    { intros r Hr K. specialize (A1 r Hr). rewrite K in A1. discriminate. }
    cbn [prepare fast_moves moves]. cbn zeta.
    set (askers := number (asker rules) 0 inside).
    set (both := map (fun r => (r, frule_of askers r)) rules).
    set (fs := number (fun i g => g i) 0 (map _ inside)).
    change (flat_map _ fs) with (flat_map (inner_of c) fs).
    set (l := flat_map (inner_of c) fs).
    set (ms := map (fun p => match p with Slot k => slot_moves Y k (nth k s 0) | Inner r' => moves Y s r' end) inside).
    assert (FS : forall i, nth_error fs i = option_map (fun p =>
              match p with
              | Slot k => FSlot (local k) (table (local_states k) (slot_leads (rules_of i both) k))
              | Inner r' => FInner i (prepare r') (rules_of i both)
              end) (nth_error inside i)).
    { intros i. unfold fs. rewrite number_error, nth_error_map. destruct (nth_error inside i); reflexivity. }
    assert (INNER : forall i, inner_moves i l =
              match nth_error inside i with Some (Inner r') => fast_moves c (prepare r') | _ => [] end).
    { intros i. unfold l. pose proof (inner_found c fs 0 i) as F. cbn [Nat.add] in F. rewrite F.
      - rewrite FS. destruct (nth_error inside i) as [[k | r'] |]; reflexivity.
      - intros k p K. rewrite FS in K. destruct (nth_error inside k) as [[j | r'] |]; cbn in K; inversion K; auto. }
    assert (MS : forall i, nth i ms [] = match nth_error inside i with
              | Some (Slot k) => slot_moves Y k (nth k s 0) | Some (Inner r') => moves Y s r' | None => [] end).
    { intros i. unfold ms. rewrite nth_by_error, nth_error_map. destruct (nth_error inside i) as [[k | r'] |]; reflexivity. }
    assert (REGION : forall i e x, (exists m, In m (inner_moves i l) /\ fst m = e /\ x = snd m) <->
              match nth_error inside i with
              | Some (Inner _) => exists m, In m (nth i ms []) /\ fst m = e /\ x = set_all (snd m)
              | _ => False
              end).
    { intros i e x. rewrite INNER, MS. destruct (nth_error inside i) as [[k | r'] |] eqn:Hi;
        try (split; [ intros (m & [] & _) | intros [] ]).
      pose proof (IH r' (nth_error_In _ _ Hi) (A2 _ (nth_error_In _ _ Hi))) as H. split.
      - intros ([b y] & Hm & Eb & Ey). cbn in Eb, Ey. subst. apply H in Hm. destruct Hm as (ch & Hch & E). exists (e, ch). auto.
      - intros ([b ch] & Hm & Eb & Ey). cbn in Eb, Ey. subst. exists (e, set_all ch). split; [| auto ]. apply H. eauto. }
    assert (ASK : forall a x, In x (fulfil c l (ask_of askers a)) <->
              exists m, In m (nth (fst a) ms []) /\ fst m = snd a /\ x = set_all (snd m)).
    { intros [i e] x. cbn [fst snd]. unfold ask_of, askers. cbn [fst snd]. rewrite number_error. cbn [Nat.add].
      assert (IN : In x (fulfil c l (AskInner i e)) <-> exists m, In m (inner_moves i l) /\ fst m = e /\ x = snd m).
      { cbn [fulfil]. rewrite in_flat_map. split.
        - intros (m & Hm & H). destruct (fst m =? e) eqn:E; [| destruct H ]. apply eqb_true in E.
          destruct H as [H | []]. exists m. auto.
        - intros (m & Hm & E & Ex). exists m. split; [ exact Hm |]. rewrite <- E, eqb_refl. left. auto. }
      destruct (nth_error inside i) as [[k | r'] |] eqn:Hi; cbn [option_map asker].
      - cbn zeta. cbn [fulfil]. rewrite table_spec, HL, MS, Hi.
        replace ((if (asked i rules).[e] then table (local_states k) (slot_ways k e) else slot_ways k e) (nth k s 0))
          with (slot_ways k e (nth k s 0)) by (destruct (asked i rules).[e]; rewrite ?table_spec; reflexivity).
        unfold slot_ways, slot_moves. rewrite in_flat_map. split.
        + intros (y & Hy & H). destruct (fst y =? e) eqn:E; [| destruct H ]. apply eqb_true in E.
          destruct H as [H | []]. exists (fst y, [(k, snd y)]). split; [ apply in_map_iff; eauto |]. cbn. auto.
        + intros (m & Hm & E & Ex). apply in_map_iff in Hm. destruct Hm as (y & Ey & Hy). subst m. cbn in E, Ex.
          exists y. split; [ exact Hy |]. rewrite E, eqb_refl. left. auto.
      - rewrite IN, REGION, Hi. reflexivity.
      - rewrite IN, REGION, Hi, MS, Hi. split; [ intros [] | intros (m & [] & _) ]. }
    assert (LEAD : forall q, (exists p, In p fs /\ In q (leads_of c l p)) <->
              exists r i e rest m, In r rules /\ asks r = (i, e) :: rest /\ In m (nth i ms []) /\ fst m = e /\
                q = (frule_of askers r, set_all (snd m))).
    { intros q. split.
      - intros (p & Hp & Hq). apply In_nth_error in Hp. destruct Hp as (i & Hi). rewrite FS in Hi.
        destruct (nth_error inside i) as [[k | r'] |] eqn:Hn; cbn in Hi; inversion Hi; subst p; clear Hi; cbn [leads_of] in Hq.
        + rewrite table_spec, HL in Hq. unfold slot_leads in Hq. apply in_flat_map in Hq. destruct Hq as (y & Hy & Hq).
          apply in_map_iff in Hq. destruct Hq as (fr & Eq & Hf). apply rules_of_in in Hf.
          destruct Hf as (r & rest & Hr & Ar & Ef). exists r, i, (fst y), rest, (fst y, [(k, snd y)]).
          rewrite MS, Hn. subst. repeat split; auto. unfold slot_moves. apply in_map_iff. eauto.
        + apply in_flat_map in Hq. destruct Hq as (y & Hy & Hq). apply in_map_iff in Hq. destruct Hq as (fr & Eq & Hf).
          apply rules_of_in in Hf. destruct Hf as (r & rest & Hr & Ar & Ef).
          assert (K : exists m, In m (inner_moves i l) /\ fst m = fst y /\ snd y = snd m) by eauto.
          apply REGION in K. rewrite Hn in K. destruct K as (m & Hm & Em & Es).
          exists r, i, (fst y), rest, m. subst. rewrite Es. auto 6.
      - intros (r & i & e & rest & m & Hr & Ar & Hm & Em & Eq).
        destruct (nth_error inside i) as [[k | r'] |] eqn:Hn.
        + exists (FSlot (local k) (table (local_states k) (slot_leads (rules_of i both) k))). split.
          { apply (nth_error_In fs i). rewrite FS, Hn. reflexivity. }
          cbn [leads_of]. rewrite table_spec, HL. rewrite MS, Hn in Hm. unfold slot_moves in Hm. apply in_map_iff in Hm.
          destruct Hm as (y & Ey & Hy). subst m. cbn in Em, Eq. unfold slot_leads. apply in_flat_map. exists y.
          split; [ exact Hy |]. apply in_map_iff. exists (frule_of askers r). split; [ subst q; reflexivity |].
          apply rules_of_in. exists r, rest. subst e. auto.
        + exists (FInner i (prepare r') (rules_of i both)). split.
          { apply (nth_error_In fs i). rewrite FS, Hn. reflexivity. }
          cbn [leads_of]. assert (K : exists m', In m' (inner_moves i l) /\ fst m' = e /\ set_all (snd m) = snd m').
          { apply REGION. rewrite Hn. exists m. auto. }
          destruct K as (m' & Hm' & Em' & Es). apply in_flat_map. exists m'. split; [ exact Hm' |].
          apply in_map_iff. exists (frule_of askers r). split; [ subst q; rewrite Es; reflexivity |].
          apply rules_of_in. exists r, rest. rewrite Em'. auto.
        + rewrite MS, Hn in Hm. destruct Hm. }
    destruct (existsb has_level rules) eqn:PR; intros a x.
    - apply (fire_ready_in c l ms rules fs askers ASK LEAD NV).
    - exact (fire_all_in c l ms rules fs askers ASK LEAD NV PR a x).
  Qed.
End Fast.
