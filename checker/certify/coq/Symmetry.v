(* SPDX-License-Identifier: Apache-2.0 *)
(* Checks that an exchange of components maps a compiled process to itself (docs/search.md, "Symmetry", conditions 1 to
   3), and proves that it is then a functional bisimulation. Any function may state which exchanges are used. *)
From Coq Require Import List Bool Arith ZArith Lia Uint63 Permutation.
From Certify Require Import Claims Processes Loops Moves Packing Merging WholeRules Reduction Confluence.
Import ListNotations.
Open Scope uint63_scope.

(* A component gets the state of another component. `send` maps the states of that component to states of this one, and
   `rename` maps its events; `restore` is the inverse of `rename`. *)
Record pull := { source : nat; send : int -> int; rename : ev -> ev; restore : ev -> ev }.
(* How a region is mapped to a region: the new numbers of participants, the new names of events, the numbers of the rules
   that correspond, and the mappings of the inner regions by participant. *)
Inductive mapping := Mapping {
  new_place : nat -> nat;
  new_name : ev -> ev;
  old_name : ev -> ev;
  rule_to : int -> int;
  rule_from : int -> int;
  deeper : nat -> mapping }.
(* An automorphism. A component that is not in the list keeps its state and its events. `instead` returns, by node of the
   specification and acceptance, an acceptance that contains only events whose images are in that acceptance. *)
Record automorphism := { pulls : list (nat * pull); tree : mapping; instead : int -> int -> int }.

Fixpoint all_numbered {A} (f : int -> A -> bool) (i : int) (l : list A) : bool :=
  match l with [] => true | x :: l' => if f i x then all_numbered f (i + 1) l' else false end.
Lemma all_numbered_in : forall A (f : int -> A -> bool) l i, all_numbered f i l = true -> forall x, In x l -> exists j, f j x = true.
Proof.
  induction l as [| y l IH]; intros i H x I; [ destruct I |]. cbn in H. destruct (f i y) eqn:E; [| discriminate ].
  destruct I as [I | I]; [ subst; eauto | eauto ].
Qed.
Definition all_true (l : list bool) : bool := forallb (fun b => b) l.

Definition stay (k : nat) : pull := {| source := k; send := fun v => v; rename := fun e => e; restore := fun e => e |}.
Fixpoint pull_in (l : list (nat * pull)) (j : nat) : pull :=
  match l with [] => stay j | (i, p) :: l' => if Nat.eqb i j then p else pull_in l' j end.

(* No rule sets states, and no component occurs twice. *)
Definition sets_nothing (q : rule) : bool := match puts q with [] => true | _ => false end.
Fixpoint silent (r : region) : bool :=
  match r with
  | Region parts rules => forallb sets_nothing rules &&
      forallb (fun p => match p with Slot _ => true | Inner r' => silent r' end) parts
  end.
Definition plain (Y : system) : bool := silent (whole Y) && no_repetition (slots_of (whole Y)).

Section Automorphism.
  Variable Y : system.
  Variable size_of : nat -> int.  (* a bound of the states of each component *)
  Variable g : automorphism.
  Let n := length (start Y).

  Definition pull_at (j : nat) : pull := pull_in (pulls g) j.
  Definition changes_of (s : list int) : list change :=
    map (fun x : nat * pull => (fst x, send (snd x) (nth (source (snd x)) s 0))) (pulls g).
  Definition turn (s : list int) : list int := apply s (changes_of s).

  (* How the events of participant i are renamed, and the inverse. *)
  Definition names_at (m : mapping) (to_ : list participant) (i : nat) : (ev -> ev) * (ev -> ev) :=
    match nth_error to_ (new_place m i) with
    | Some (Slot j) => (rename (pull_at j), restore (pull_at j))
    | _ => (new_name (deeper m i), old_name (deeper m i))
    end.
  Definition name_at m to_ i := fst (names_at m to_ i).
  Definition old_name_at m to_ i := snd (names_at m to_ i).
  Definition image_of (m : mapping) (to_ : list participant) (a : nat * ev) : nat * ev :=
    (new_place m (fst a), name_at m to_ (fst a) (snd a)).

  Definition same_level (k l : option int) : bool :=
    match k, l with Some k, Some l => k =? l | None, None => true | _, _ => false end.
  (* The rule q' does with the image what q does. Its participants may be in another order. *)
  Definition corresponds (m : mapping) (parts to_ : list participant) (q q' : rule) : bool :=
    same_level (level q) (level q') && (does q' =? new_name m (does q)) && (does q =? old_name m (does q')) &&
    no_repetition (map fst (asks q')) && Nat.leb (length (asks q)) (length (asks q')) &&
    forallb (fun a : nat * ev => Nat.ltb (fst a) (length parts) &&
                                 (old_name_at m to_ (fst a) (name_at m to_ (fst a) (snd a)) =? snd a)) (asks q) &&
    let images := map (image_of m to_) (asks q) in
    forallb (fun b : nat * ev => existsb (fun c => if Nat.eqb (fst c) (fst b) then snd c =? snd b else false) images) (asks q').
  Definition rules_correspond (m : mapping) (parts to_ : list participant) (rules rules' : list rule) : bool :=
    let rule_at := element rules in
    let rule_at' := element rules' in
    all_numbered (fun i q => match rule_at' (rule_to m i) with Some q' => corresponds m parts to_ q q' | None => false end) 0 rules &&
    all_numbered (fun i q' => match rule_at (rule_from m i) with Some q => corresponds m parts to_ q q' | None => false end) 0 rules'.
  Fixpoint maps (r : region) (m : mapping) (r' : region) : bool :=
    match r, r' with
    | Region parts rules, Region to_ rules' =>
        all_true (number (fun i f => f i) 0 (map (fun p =>
          match p with
          | Slot k => fun i => match nth_error to_ (new_place m i) with
                               | Some (Slot j) => Nat.ltb j n && Nat.eqb (source (pull_at j)) k
                               | _ => false
                               end
          | Inner q => fun i => match nth_error to_ (new_place m i) with
                                | Some (Inner q') => maps q (deeper m i) q'
                                | _ => false
                                end
          end) parts)) && rules_correspond m parts to_ rules rules'
    end.

  Definition rename_edges (p : pull) (l : list (ev * int)) : list (ev * int) :=
    map (fun x => (rename p (fst x), send p (snd x))) l.
  Definition pull_ok (x : nat * pull) : bool :=
    let (j, p) := x in
    Nat.ltb j n && Nat.ltb (source p) n && existsb (Nat.eqb (source p)) (map fst (pulls g)) &&
    all_below (fun v =>
      let w := send p v in
      let l := edges Y (source p) v in
      (w <? size_of j) && forallb (fun e : ev * int => restore p (rename p (fst e)) =? fst e) l &&
      equal_edges (rename_edges p l) (edges Y j w)) (size_of (source p)).
  Definition same_test (a b x : ev) : bool := if a =? x then b =? x else negb (b =? x).
  Definition names_ok (q : rule) : bool :=
    let a := does q in
    let b := new_name (tree g) a in
    same_test a b tau && same_test a b tick.
  Definition automorphism_ok : bool :=
    no_repetition (map fst (pulls g)) && no_repetition (map (fun x => source (snd x)) (pulls g)) &&
    forallb pull_ok (pulls g) && maps (whole Y) (tree g) (whole Y) &&
    match whole Y with Region _ rules => forallb names_ok rules end.

  (** Proofs. *)
  Definition send_at (j : nat) := send (pull_at j).
  Definition source_at (j : nat) := source (pull_at j).
  (* The changes ch' do to the image what ch do. *)
  Definition linked (ch ch' : list change) : Prop :=
    forall j d, (j < n)%nat -> final ch' j (send_at j d) = send_at j (final ch (source_at j) d).

  Lemma final_app : forall c d k x, final (c ++ d) k x = final d k (final c k x).
  Proof. induction c as [| [j y] c IH]; intros d k x; [ reflexivity |]. cbn. apply IH. Qed.
  Lemma linked_app : forall c c' d d', linked c c' -> linked d d' -> linked (c ++ d) (c' ++ d').
  Proof. intros c c' d d' H K j x Hj. rewrite !final_app, H, K by exact Hj. reflexivity. Qed.
  Lemma linked_nil : linked [] [].
  Proof. intros j d _. reflexivity. Qed.
  Lemma linked_final : forall c c' d', linked c c' -> (forall k x, final c' k x = final d' k x) -> linked c d'.
  Proof. intros c c' d' H K j x Hj. rewrite <- K. apply H, Hj. Qed.

  (* Which components a move changes. *)
  Definition part_slots (p : participant) : list nat := match p with Slot k => [k] | Inner r => slots_of r end.
  Lemma slots_of_region : forall parts rules, slots_of (Region parts rules) = flat_map part_slots parts.
  Proof. reflexivity. Qed.
  Lemma combine_slots : forall s parts, (forall i m c, In m (nth i (part_moves Y s parts) []) -> In c (snd m) ->
      exists p, nth_error parts i = Some p /\ In (fst c) (part_slots p)) ->
    forall wanted ch c, In ch (combine (part_moves Y s parts) wanted) -> In c ch ->
      exists i e p, In (i, e) wanted /\ nth_error parts i = Some p /\ In (fst c) (part_slots p).
  Proof.
    intros s parts H. induction wanted as [| [i e] rest IH]; intros ch c Hch Hc.
    - cbn in Hch. destruct Hch as [E | []]. subst. destruct Hc.
    - apply combine_in in Hch. destruct Hch as (m & c' & Hm & _ & Hc' & E). subst. apply in_app_or in Hc.
      destruct Hc as [Hc | Hc].
      + destruct (H i m c Hm Hc) as (p & Hp & K). exists i, e, p. split; [ left; reflexivity | auto ].
      + destruct (IH c' c Hc' Hc) as (j & d & p & Hj & K). exists j, d, p. split; [ right; exact Hj | exact K ].
  Qed.
  Lemma moves_slots : forall s r, silent r = true -> forall m c, In m (moves Y s r) -> In c (snd m) -> In (fst c) (slots_of r).
  Proof.
    intros s. induction r as [parts rules IH] using region_rect'. intros Q m c Hm Hc. cbn in Q. apply andb_true_iff in Q.
    destruct Q as [Q1 Q2]. rewrite forallb_forall in Q1, Q2. cbn [moves] in Hm. apply in_flat_map in Hm.
    destruct Hm as (q & Hq & Hm). destruct (prevented _ _ _); [ destruct Hm |]. apply in_map_iff in Hm.
    destruct Hm as (ch & E & Hch). subst m. cbn [snd] in Hc. specialize (Q1 q Hq). unfold sets_nothing in Q1.
    destruct (puts q) as [|]; [| discriminate ]. rewrite app_nil_r in Hc.
    change (In ch (combine (part_moves Y s parts) (asks q))) in Hch.
    destruct (combine_slots s parts) with (wanted := asks q) (ch := ch) (c := c) as (i & e & p & _ & Hp & K); auto.
    - intros i m c0 Hm Hc0. unfold part_moves in Hm. rewrite nth_by_error, nth_error_map in Hm.
      destruct (nth_error parts i) as [p |] eqn:Hp; [| destruct Hm ]. exists p. split; [ reflexivity |]. cbn in Hm.
      pose proof (nth_error_In _ _ Hp) as Ip. destruct p as [k | r']; cbn.
      + apply in_map_iff in Hm. destruct Hm as (x & E & _). subst m. destruct Hc0 as [E | []]. subst. left. reflexivity.
      + exact (IH r' Ip (Q2 _ Ip) m c0 Hm Hc0).
    - rewrite slots_of_region. apply in_flat_map. exists p. split; [ exact (nth_error_In _ _ Hp) | exact K ].
  Qed.

  Lemma untouched : forall ch k x, (forall c, In c ch -> fst c <> k) -> final ch k x = x.
  Proof.
    induction ch as [| [j y] ch IH]; intros k x H; [ reflexivity |]. cbn [final]. rewrite IH by (intros c Hc; apply H; right; exact Hc).
    destruct (Nat.eqb j k) eqn:E; [| reflexivity ]. apply Nat.eqb_eq in E. exfalso. exact (H (j, y) (or_introl eq_refl) E).
  Qed.
  Lemma final_swap : forall c d k x, (forall a b, In a c -> In b d -> fst a <> fst b) ->
    final d k (final c k x) = final c k (final d k x).
  Proof.
    intros c d k x H. destruct (existsb (fun a => Nat.eqb (fst a) k) c) eqn:E.
    - apply existsb_exists in E. destruct E as (a & Ha & E). apply Nat.eqb_eq in E.
      rewrite !(untouched d); auto; intros b Hb K; apply (H a b Ha Hb); congruence.
    - assert (U : forall y, final c k y = y).
      { intros y. apply untouched. intros a Ha K. rewrite <- not_true_iff_false in E. apply E. apply existsb_exists.
        exists a. split; [ exact Ha | apply Nat.eqb_eq, K ]. }
      rewrite !U. reflexivity.
  Qed.
  Lemma combine_permuted : forall ms wanted wanted',
    (forall i j m m' a b, i <> j -> In m (nth i ms []) -> In m' (nth j ms []) -> In a (snd m) -> In b (snd m') -> fst a <> fst b) ->
    Permutation wanted wanted' -> NoDup (map fst wanted) -> forall ch, In ch (combine ms wanted) ->
    exists ch', In ch' (combine ms wanted') /\ forall k x, final ch k x = final ch' k x.
  Proof.
    intros ms wanted wanted' D P. induction P as [| [i e] l l' P IH | [i e] [j d] l | l l' l'' P1 IH1 P2 IH2]; intros N ch H.
    - exists ch. auto.
    - inversion N as [| ? ? _ N']. apply combine_in in H. destruct H as (m & c & Hm & E & Hc & Ec).
      destruct (IH N' c Hc) as (c' & Hc' & F). exists (snd m ++ c'). split; [ apply combine_in; eauto 6 |].
      intros k y. subst. rewrite !final_app. apply F.
    - inversion N as [| ? ? N1 _]. apply combine_in in H. destruct H as (m & c & Hm & E & Hc & Ec).
      apply combine_in in Hc. destruct Hc as (m' & c' & Hm' & E' & Hc' & Ec').
      exists (snd m' ++ snd m ++ c'). split.
      { apply combine_in. exists m', (snd m ++ c'). split; [ exact Hm' | split; [ exact E' | split; [| reflexivity ]]].
        apply combine_in. exists m, c'. auto. }
      intros k y. subst. rewrite !final_app. f_equal. apply final_swap. intros a b Ha Hb.
      apply (D j i m m' a b); auto. intros K. apply N1. rewrite K. left. reflexivity.
    - destruct (IH1 N ch H) as (c & Hc & F). apply (Permutation_map fst) in P1.
      destruct (IH2 (Permutation_NoDup P1 N) c Hc) as (c' & Hc' & F'). exists c'. split; [ exact Hc' |].
      intros k y. rewrite F. apply F'.
  Qed.

  (* Moves and moves of the image that correspond. *)
  Definition matched (new old : ev -> ev) (x y : move) : Prop :=
    fst y = new (fst x) /\ fst x = old (fst y) /\ linked (snd x) (snd y).
  Definition agree (new old : ev -> ev) (l l' : list move) : Prop :=
    (forall x, In x l -> exists y, In y l' /\ matched new old x y) /\
    (forall y, In y l' -> exists x, In x l /\ matched new old x y).

  Section Rules.
    Variable m : mapping.
    Variable parts to_ : list participant.
    Variable ms ms' : list (list move).
    Hypothesis parts_agree : forall i, (i < length parts)%nat ->
      agree (name_at m to_ i) (old_name_at m to_ i) (nth i ms []) (nth (new_place m i) ms' []).
    Hypothesis apart : forall i j x y a b, i <> j -> In x (nth i ms' []) -> In y (nth j ms' []) -> In a (snd x) -> In b (snd y) ->
      fst a <> fst b.

    Lemma wanted_forward : forall wanted, (forall a, In a wanted -> (fst a < length parts)%nat) ->
      forall ch, In ch (combine ms wanted) -> exists ch', In ch' (combine ms' (map (image_of m to_) wanted)) /\ linked ch ch'.
    Proof.
      induction wanted as [| [i e] rest IH]; intros B ch H.
      - cbn in *. destruct H as [E | []]. subst. exists []. split; [ left; reflexivity | exact linked_nil ].
      - apply combine_in in H. destruct H as (x & c & Hx & E & Hc & Ec).
        destruct (parts_agree i (B _ (or_introl eq_refl))) as [F _]. destruct (F x Hx) as (y & Hy & N & _ & L).
        destruct (IH (fun a Ha => B a (or_intror Ha)) c Hc) as (c' & Hc' & L'). exists (snd y ++ c'). split.
        + apply combine_in. exists y, c'. rewrite N, E. auto.
        + subst. apply linked_app; assumption.
    Qed.
    Lemma wanted_back : forall wanted, (forall a, In a wanted -> (fst a < length parts)%nat /\
        old_name_at m to_ (fst a) (name_at m to_ (fst a) (snd a)) = snd a) ->
      forall ch', In ch' (combine ms' (map (image_of m to_) wanted)) -> exists ch, In ch (combine ms wanted) /\ linked ch ch'.
    Proof.
      induction wanted as [| [i e] rest IH]; intros B ch' H.
      - cbn in *. destruct H as [E | []]. subst. exists []. split; [ left; reflexivity | exact linked_nil ].
      - cbn [map] in H. apply combine_in in H. destruct H as (y & c' & Hy & E & Hc' & Ec). cbn [image_of fst snd] in *.
        destruct (B _ (or_introl eq_refl)) as [Bi R]. cbn [fst snd] in Bi, R.
        destruct (parts_agree i Bi) as [_ F]. destruct (F y Hy) as (x & Hx & _ & O & L).
        destruct (IH (fun a Ha => B a (or_intror Ha)) c' Hc') as (c & Hc & L'). exists (snd x ++ c). split.
        + apply combine_in. exists x, c. rewrite O, E. auto.
        + subst. apply linked_app; assumption.
    Qed.
    Lemma corresponds_facts : forall q q', corresponds m parts to_ q q' = true ->
      level q = level q' /\ does q' = new_name m (does q) /\ does q = old_name m (does q') /\
      (forall ch, In ch (combine ms (asks q)) -> exists ch', In ch' (combine ms' (asks q')) /\ linked ch ch') /\
      (forall ch', In ch' (combine ms' (asks q')) -> exists ch, In ch (combine ms (asks q)) /\ linked ch ch').
    Proof.
      intros q q' H. unfold corresponds in H. rewrite !andb_true_iff in H. destruct H as [[[[[[H1 H2] H3] H4] H5] H6] H7].
      apply eqb_true in H2, H3. apply no_repetition_ok in H4. apply Nat.leb_le in H5. rewrite forallb_forall in H6, H7.
      assert (B : forall a, In a (asks q) -> (fst a < length parts)%nat /\
                old_name_at m to_ (fst a) (name_at m to_ (fst a) (snd a)) = snd a).
      { intros a Ha. specialize (H6 a Ha). apply andb_true_iff in H6. destruct H6 as [K1 K2]. apply Nat.ltb_lt in K1.
        apply eqb_true in K2. auto. }
      assert (P : Permutation (asks q') (map (image_of m to_) (asks q))).
      { apply NoDup_Permutation_bis; [ exact (NoDup_map_inv _ _ H4) | rewrite map_length; exact H5 |].
        intros [i e] Hb. specialize (H7 _ Hb). apply existsb_exists in H7. destruct H7 as ([j d] & Hc & E). cbn [fst snd] in E.
        destruct (Nat.eqb j i) eqn:Ej; [| discriminate ]. apply Nat.eqb_eq in Ej. apply eqb_true in E. subst. exact Hc. }
      split; [| split; [ exact H2 | split; [ exact H3 | split ]]].
      - destruct (level q) as [k |], (level q') as [l |]; cbn in H1; try discriminate; [| reflexivity ].
        apply eqb_true in H1. subst. reflexivity.
      - intros ch Hch. destruct (wanted_forward _ (fun a Ha => proj1 (B a Ha)) ch Hch) as (c & Hc & L).
        pose proof (Permutation_map fst P) as PF.
        destruct (combine_permuted ms' _ _ apart (Permutation_sym P) (Permutation_NoDup PF H4) c Hc) as (c' & Hc' & F).
        exists c'. split; [ exact Hc' | exact (linked_final _ _ _ L F) ].
      - intros ch' Hch. destruct (combine_permuted ms' _ _ apart P H4 ch' Hch) as (c & Hc & F).
        destruct (wanted_back _ B c Hc) as (ch & Hc' & L). exists ch. split; [ exact Hc' |].
        apply (linked_final _ _ _ L). intros k x. symmetry. apply F.
    Qed.

    Variable rules rules' : list rule.
    Hypothesis correspond : rules_correspond m parts to_ rules rules' = true.
    Hypothesis quiet : forall q, In q rules -> puts q = [].
    Hypothesis quiet' : forall q, In q rules' -> puts q = [].
    Lemma rule_images : (forall q, In q rules -> exists q', In q' rules' /\ corresponds m parts to_ q q' = true) /\
      (forall q', In q' rules' -> exists q, In q rules /\ corresponds m parts to_ q q' = true).
    Proof.
      unfold rules_correspond in correspond. cbn zeta in correspond. apply andb_true_iff in correspond. destruct correspond as [F G].
      split.
      - intros q Hq. destruct (all_numbered_in _ _ _ _ F q Hq) as (i & K).
        destruct (element rules' (rule_to m i)) as [q' |] eqn:E; [| discriminate ]. exists q'. split; [ exact (element_in _ _ _ _ E) | exact K ].
      - intros q' Hq. destruct (all_numbered_in _ _ _ _ G q' Hq) as (i & K).
        destruct (element rules (rule_from m i)) as [q |] eqn:E; [| discriminate ]. exists q. split; [ exact (element_in _ _ _ _ E) | exact K ].
    Qed.
    Lemma can_same : forall q q', corresponds m parts to_ q q' = true ->
      nonempty (combine ms (asks q)) = nonempty (combine ms' (asks q')).
    Proof.
      intros q q' H. apply corresponds_facts in H. destruct H as (_ & _ & _ & F & G). apply bool_same. rewrite !nonempty_in. split.
      - intros (c & Hc). destruct (F c Hc) as (c' & K & _). eauto.
      - intros (c & Hc). destruct (G c Hc) as (c' & K & _). eauto.
    Qed.
    Lemma prevented_same : forall q q', corresponds m parts to_ q q' = true ->
      prevented ms rules q = prevented ms' rules' q'.
    Proof.
      intros q q' H. apply corresponds_facts in H. destruct H as (L & _). unfold prevented. rewrite <- L.
      destruct (level q) as [l |]; [| reflexivity ]. apply bool_same. rewrite !existsb_exists. destruct rule_images as [RF RB]. split.
      - intros (o & Ho & K). destruct (RF o Ho) as (o' & Ho' & C). exists o'. split; [ exact Ho' |].
        rewrite <- (can_same o o' C). apply corresponds_facts in C. destruct C as (Lo & _). unfold before in *. rewrite <- Lo. exact K.
      - intros (o' & Ho' & K). destruct (RB o' Ho') as (o & Ho & C). exists o. split; [ exact Ho |].
        rewrite (can_same o o' C). apply corresponds_facts in C. destruct C as (Lo & _). unfold before in *. rewrite Lo. exact K.
    Qed.
    Lemma fire_agree : agree (new_name m) (old_name m) (fire ms rules) (fire ms' rules').
    Proof.
      destruct rule_images as [RF RB]. split.
      - intros x Hx. apply in_flat_map in Hx. destruct Hx as (q & Hq & Hx). destruct (RF q Hq) as (q' & Hq' & C).
        destruct (prevented ms rules q) eqn:P; [ destruct Hx |]. apply in_map_iff in Hx. destruct Hx as (ch & E & Hch).
        rewrite (prevented_same q q' C) in P. destruct (corresponds_facts q q' C) as (_ & D1 & D2 & F & _).
        destruct (F ch Hch) as (ch' & Hch' & L). exists (does q', ch' ++ puts q'). split.
        + apply in_flat_map. exists q'. split; [ exact Hq' |]. rewrite P. apply in_map_iff. eauto.
        + subst x. rewrite (quiet q Hq), (quiet' q' Hq'), !app_nil_r. split; [ exact D1 | split; [ exact D2 | exact L ]].
      - intros y Hy. apply in_flat_map in Hy. destruct Hy as (q' & Hq' & Hy). destruct (RB q' Hq') as (q & Hq & C).
        destruct (prevented ms' rules' q') eqn:P; [ destruct Hy |]. apply in_map_iff in Hy. destruct Hy as (ch' & E & Hch').
        rewrite <- (prevented_same q q' C) in P. destruct (corresponds_facts q q' C) as (_ & D1 & D2 & _ & G).
        destruct (G ch' Hch') as (ch & Hch & L). exists (does q, ch ++ puts q). split.
        + apply in_flat_map. exists q. split; [ exact Hq |]. rewrite P. apply in_map_iff. eauto.
        + subst y. rewrite (quiet q Hq), (quiet' q' Hq'), !app_nil_r. split; [ exact D1 | split; [ exact D2 | exact L ]].
    Qed.
  End Rules.

  (** States, components and regions. *)
  Definition in_sizes (s : list int) : Prop := length s = n /\ forall k, (k < n)%nat -> (nth k s 0 <? size_of k) = true.
  Hypothesis checked : automorphism_ok = true.
  Hypothesis ok : plain Y = true.

  Lemma checks_hold : NoDup (map fst (pulls g)) /\ NoDup (map (fun x => source (snd x)) (pulls g)) /\
    (forall x, In x (pulls g) -> pull_ok x = true) /\ maps (whole Y) (tree g) (whole Y) = true /\
    match whole Y with Region _ rules => forallb names_ok rules end = true.
  Proof.
    unfold automorphism_ok in checked. rewrite !andb_true_iff in checked. destruct checked as [[[[H1 H2] H3] H4] H5].
    rewrite forallb_forall in H3. split; [ exact (no_repetition_ok _ H1) | split; [ exact (no_repetition_ok _ H2) | auto ]].
  Qed.
  Lemma pull_in_cases : forall l j, In (j, pull_in l j) l \/ (pull_in l j = stay j /\ ~ In j (map fst l)).
  Proof.
    induction l as [| [i p] l IH]; intros j; cbn; [ right; auto |]. destruct (Nat.eqb i j) eqn:E.
    - apply Nat.eqb_eq in E. subst. left. left. reflexivity.
    - apply Nat.eqb_neq in E. destruct (IH j) as [K | [K1 K2]]; [ left; right; exact K | right ].
      split; [ exact K1 |]. intros [F | F]; [ contradiction | exact (K2 F) ].
  Qed.
  Lemma pull_facts : forall j, In (j, pull_at j) (pulls g) ->
    (j < n)%nat /\ (source_at j < n)%nat /\ In (source_at j) (map fst (pulls g)) /\
    forall v, (v <? size_of (source_at j)) = true -> (send_at j v <? size_of j) = true /\
      (forall e, In e (edges Y (source_at j) v) -> restore (pull_at j) (rename (pull_at j) (fst e)) = fst e) /\
      same (rename_edges (pull_at j) (edges Y (source_at j) v)) (edges Y j (send_at j v)).
  Proof.
    intros j H. destruct checks_hold as (_ & _ & C & _). specialize (C _ H). unfold pull_ok in C. rewrite !andb_true_iff in C.
    destruct C as [[[C1 C2] C3] C4]. apply Nat.ltb_lt in C1, C2. split; [ exact C1 | split; [ exact C2 | split ]].
    - apply existsb_exists in C3. destruct C3 as (k & Hk & E). apply Nat.eqb_eq in E. unfold source_at. rewrite E. exact Hk.
    - intros v Hv. assert (K := all_below_spec _ _ C4 v Hv). cbn beta zeta in K. rewrite !andb_true_iff in K.
      destruct K as [[K1 K2] K3]. rewrite forallb_forall in K2. split; [ exact K1 | split ].
      + intros e He. apply eqb_true. exact (K2 e He).
      + apply equal_edges_same. exact K3.
  Qed.
  Lemma from_bound : forall j, (j < n)%nat -> (source_at j < n)%nat.
  Proof.
    intros j H. destruct (pull_in_cases (pulls g) j) as [K | [K _]]; [ apply pull_facts, K |].
    unfold source_at, pull_at. rewrite K. exact H.
  Qed.
  Lemma unique_image : forall A B (f : A -> B) l x y, NoDup (map f l) -> In x l -> In y l -> f x = f y -> x = y.
  Proof.
    induction l as [| z l IH]; intros x y N Hx Hy E; [ destruct Hx |]. cbn in N. inversion N as [| ? ? N1 N2]. subst.
    destruct Hx as [Hx | Hx], Hy as [Hy | Hy]; subst; auto.
    - exfalso. apply N1. rewrite E. apply in_map. exact Hy.
    - exfalso. apply N1. rewrite <- E. apply in_map. exact Hx.
  Qed.
  Lemma from_injective : forall i j, source_at i = source_at j -> i = j.
  Proof.
    intros i j E. destruct checks_hold as (_ & N & _).
    destruct (pull_in_cases (pulls g) i) as [Ki | [Ki Ni]], (pull_in_cases (pulls g) j) as [Kj | [Kj Nj]].
    - assert (K := unique_image _ _ (fun x : nat * pull => source (snd x)) _ _ _ N Ki Kj E). inversion K. auto.
    - exfalso. apply Nj. unfold source_at at 2 in E. unfold pull_at in E. rewrite Kj in E. cbn in E. rewrite <- E.
      apply (pull_facts i Ki).
    - exfalso. apply Ni. unfold source_at at 1 in E. unfold pull_at in E. rewrite Ki in E. cbn in E. rewrite E.
      apply (pull_facts j Kj).
    - unfold source_at, pull_at in E. rewrite Ki, Kj in E. exact E.
  Qed.
  Lemma turn_length : forall s, length (turn s) = length s.
  Proof. intros s. apply apply_same_length. Qed.
  Lemma changes_final_at : forall s l j, NoDup (map fst l) ->
    final (map (fun x : nat * pull => (fst x, send (snd x) (nth (source (snd x)) s 0))) l) j (nth j s 0) =
    send (pull_in l j) (nth (source (pull_in l j)) s 0).
  Proof.
    intros s. induction l as [| [i p] l IH]; intros j N; [ reflexivity |]. cbn [map fst snd final pull_in].
    inversion N as [| ? ? N1 N2]. subst. destruct (Nat.eqb i j) eqn:E; [| exact (IH j N2) ].
    apply Nat.eqb_eq in E. subst. apply untouched. intros c Hc K. apply in_map_iff in Hc. destruct Hc as (x & Ex & Hx).
    subst c. cbn in K. apply N1. rewrite <- K. apply in_map. exact Hx.
  Qed.
  Lemma turn_nth : forall s j, (j < length s)%nat -> nth j (turn s) 0 = send_at j (nth (source_at j) s 0).
  Proof.
    intros s j H. unfold turn. rewrite (apply_nth Y) by exact H. apply changes_final_at. apply checks_hold.
  Qed.

  Lemma slot_agree : forall s j, in_sizes s -> (j < n)%nat ->
    agree (rename (pull_at j)) (restore (pull_at j)) (slot_moves Y (source_at j) (nth (source_at j) s 0)) (slot_moves Y j (nth j (turn s) 0)).
  Proof.
    intros s j [L B] Hj. rewrite turn_nth by (rewrite L; exact Hj). set (v := nth (source_at j) s 0).
    assert (K : (forall e, In e (edges Y (source_at j) v) -> restore (pull_at j) (rename (pull_at j) (fst e)) = fst e) /\
                same (rename_edges (pull_at j) (edges Y (source_at j) v)) (edges Y j (send_at j v))).
    { destruct (pull_in_cases (pulls g) j) as [K | [K _]].
      - destruct (pull_facts j K) as (_ & F & _ & C). exact (proj2 (C v (B (source_at j) F))).
      - unfold source_at, send_at, rename_edges, pull_at. rewrite K. cbn. split; [ auto |]. intros [a x]. rewrite in_map_iff. split.
        + intros ([b y] & E & I). cbn in E. inversion E. subst. exact I.
        + intros I. exists (a, x). auto. }
    destruct K as [R S].
    assert (LK : forall x, linked [(source_at j, x)] [(j, send_at j x)]).
    { intros x i d Hi. cbn [final]. destruct (Nat.eqb j i) eqn:E.
      - apply Nat.eqb_eq in E. subst. rewrite Nat.eqb_refl. reflexivity.
      - destruct (Nat.eqb (source_at j) (source_at i)) eqn:F; [| reflexivity ]. apply Nat.eqb_eq in F. apply from_injective in F. subst.
        rewrite Nat.eqb_refl in E. discriminate. }
    split.
    - intros m Hm. apply in_map_iff in Hm. destruct Hm as ([a x] & E & I). subst m. cbn [fst snd].
      exists (rename (pull_at j) a, [(j, send_at j x)]). split.
      + apply in_map_iff. exists (rename (pull_at j) a, send_at j x). split; [ reflexivity |]. apply S. apply in_map_iff. exists (a, x). auto.
      + split; [ reflexivity | split; [ symmetry; exact (R _ I) | apply LK ]].
    - intros m Hm. apply in_map_iff in Hm. destruct Hm as ([b y] & E & I). subst m. cbn [fst snd]. apply S in I.
      apply in_map_iff in I. destruct I as ([a x] & E & I). cbn [fst snd] in E. inversion E. subst b y.
      exists (a, [(source_at j, x)]). split; [ apply in_map_iff; exists (a, x); auto |].
      split; [ reflexivity | split; [ symmetry; exact (R _ I) | apply LK ]].
  Qed.

  Lemma no_dup_flat : forall A B (f : A -> list B) l, NoDup (flat_map f l) ->
    (forall x, In x l -> NoDup (f x)) /\
    forall i j x y k, nth_error l i = Some x -> nth_error l j = Some y -> i <> j -> In k (f x) -> In k (f y) -> False.
  Proof.
    induction l as [| z l IH]; intros N; cbn in N.
    - split; [ intros x [] |]. intros [| i] j x y k H; discriminate.
    - assert (P : NoDup (f z) /\ NoDup (flat_map f l) /\ forall k, In k (f z) -> In k (flat_map f l) -> False).
      { clear IH. induction (f z) as [| u r IHr]; cbn in N; [ split; [ constructor | split; [ exact N | intros k [] ]] |].
        inversion N as [| ? ? N1 N2]. subst. destruct (IHr N2) as (P1 & P2 & P3). split; [| split; [ exact P2 |]].
        - constructor; [| exact P1 ]. intros K. apply N1, in_or_app. left. exact K.
        - intros k [E | Hk] Kl; [ subst; apply N1, in_or_app; right; exact Kl | exact (P3 k Hk Kl) ]. }
      destruct P as (P1 & P2 & P3). destruct (IH P2) as [Q1 Q2]. split.
      + intros x [E | Hx]; [ subst; exact P1 | exact (Q1 x Hx) ].
      + intros [| i] [| j] x y k Hi Hj D Kx Ky; cbn in Hi, Hj.
        * apply D. reflexivity.
        * inversion Hi. subst. apply (P3 k Kx). apply in_flat_map. exists y. split; [ exact (nth_error_In _ _ Hj) | exact Ky ].
        * inversion Hj. subst. apply (P3 k Ky). apply in_flat_map. exists x. split; [ exact (nth_error_In _ _ Hi) | exact Kx ].
        * apply (Q2 i j x y k Hi Hj); auto.
  Qed.
  Lemma all_true_nth : forall l i b, all_true l = true -> nth_error l i = Some b -> b = true.
  Proof. unfold all_true. intros l i b H K. rewrite forallb_forall in H. exact (H b (nth_error_In _ _ K)). Qed.

  Lemma region_agree : forall s, in_sizes s -> forall r m r', maps r m r' = true -> silent r = true -> silent r' = true ->
    NoDup (slots_of r') -> agree (new_name m) (old_name m) (moves Y s r) (moves Y (turn s) r').
  Proof.
    intros s Hs. induction r as [parts rules IH] using region_rect'. intros m [to_ rules'] H Q Q' N.
    cbn [maps] in H. apply andb_true_iff in H. destruct H as [HP HR].
    cbn in Q, Q'. rewrite andb_true_iff, !forallb_forall in Q, Q'. destruct Q as [Q1 Q2], Q' as [Q1' Q2'].
    rewrite slots_of_region in N. apply no_dup_flat in N. destruct N as [N1 N2].
    assert (QP : forall l q, (forall q, In q l -> sets_nothing q = true) -> In q l -> puts q = []).
    { intros l q K Hq. specialize (K q Hq). unfold sets_nothing in K. destruct (puts q); [ reflexivity | discriminate ]. }
    assert (MS : forall x parts i, nth i (part_moves Y x parts) [] = match nth_error parts i with
              | Some (Slot k) => slot_moves Y k (nth k x 0) | Some (Inner r0) => moves Y x r0 | None => [] end).
    { intros x l i. unfold part_moves. rewrite nth_by_error, nth_error_map. destruct (nth_error l i) as [[k | r0] |]; reflexivity. }
    cbn [moves]. change (agree (new_name m) (old_name m) (fire (part_moves Y s parts) rules) (fire (part_moves Y (turn s) to_) rules')).
    apply (fire_agree m parts to_); [| | exact HR | exact (fun q => QP rules q Q1) | exact (fun q => QP rules' q Q1') ].
    - intros i Hi. rewrite !MS. destruct (nth_error parts i) as [p |] eqn:Hp.
      2: { apply nth_error_None in Hp. lia. }
      pose proof (nth_error_In _ _ Hp) as Ip.
      assert (K := fun b => all_true_nth _ i b HP).
      rewrite number_error, nth_error_map, Hp in K. cbn [option_map Nat.add] in K. specialize (K _ eq_refl).
      unfold name_at, old_name_at, names_at. destruct p as [k | q].
      + destruct (nth_error to_ (new_place m i)) as [[j | q'] |]; try discriminate. apply andb_true_iff in K.
        destruct K as [K1 K2]. apply Nat.ltb_lt in K1. apply Nat.eqb_eq in K2. subst k. exact (slot_agree s j Hs K1).
      + destruct (nth_error to_ (new_place m i)) as [[j | q'] |] eqn:Ht; try discriminate.
        pose proof (nth_error_In _ _ Ht) as It.
        exact (IH q Ip (deeper m i) q' K (Q2 _ Ip) (Q2' _ It) (N1 _ It)).
    - intros i j x y a b D Hx Hy Ha Hb E. rewrite MS in Hx, Hy.
      assert (KEY : forall i x c, In x match nth_error to_ i with
              | Some (Slot k) => slot_moves Y k (nth k (turn s) 0) | Some (Inner r0) => moves Y (turn s) r0 | None => [] end ->
              In c (snd x) -> exists p, nth_error to_ i = Some p /\ In (fst c) (part_slots p)).
      { intros i0 x0 c Hx0 Hc. destruct (nth_error to_ i0) as [[k | q] |] eqn:Hi; [| | destruct Hx0 ].
        - exists (Slot k). split; [ reflexivity |]. apply in_map_iff in Hx0. destruct Hx0 as (z & Ez & _). subst x0.
          destruct Hc as [Ec | []]. subst. left. reflexivity.
        - exists (Inner q). split; [ reflexivity |]. exact (moves_slots _ q (Q2' _ (nth_error_In _ _ Hi)) x0 c Hx0 Hc). }
      destruct (KEY i x a Hx Ha) as (p & Hp & Kp). destruct (KEY j y b Hy Hb) as (q & Hq & Kq).
      rewrite E in Kp. exact (N2 i j p q (fst b) Hp Hq D Kp Kq).
  Qed.
  Lemma whole_agree : forall s, in_sizes s ->
    agree (new_name (tree g)) (old_name (tree g)) (moves Y s (whole Y)) (moves Y (turn s) (whole Y)).
  Proof.
    intros s Hs. unfold plain in ok. apply andb_true_iff in ok. destruct ok as [Q N].
    destruct checks_hold as (_ & _ & _ & M & _). exact (region_agree s Hs (whole Y) (tree g) (whole Y) M Q Q (no_repetition_ok _ N)).
  Qed.

  (* The image of a state answers its transitions, and has no others. *)
  Definition old_event : ev -> ev := old_name (tree g).
  Lemma turned_target : forall s ch ch', length s = n -> linked ch ch' -> apply (turn s) ch' = turn (apply s ch).
  Proof.
    intros s ch ch' L K. apply same_states; [ rewrite turn_length, !apply_same_length, turn_length; reflexivity |].
    intros j Hj. rewrite apply_same_length, turn_length, L in Hj. rewrite (apply_nth Y) by (rewrite turn_length, L; exact Hj).
    rewrite !turn_nth by (rewrite ?apply_same_length, L; exact Hj). rewrite (apply_nth Y) by (rewrite L; exact (from_bound j Hj)).
    exact (K j _ Hj).
  Qed.
  Lemma same_test_ok : forall a b x, same_test a b x = true -> (a = x <-> b = x).
  Proof.
    unfold same_test. intros a b x H. destruct (a =? x) eqn:E.
    - apply eqb_true in E, H. subst. tauto.
    - apply negb_true_iff in H. split; intros K; subst; [ rewrite eqb_refl in E | rewrite eqb_refl in H ]; discriminate.
  Qed.
  Lemma move_keeps : forall s a ch, In (a, ch) (moves Y s (whole Y)) -> keeps a (new_name (tree g) a).
  Proof.
    intros s a ch H. destruct checks_hold as (_ & _ & _ & _ & C). destruct (whole Y) as [parts rules]. cbn [moves] in H.
    apply in_flat_map in H. destruct H as (q & Hq & H). destruct (prevented _ _ _); [ destruct H |]. apply in_map_iff in H.
    destruct H as (c & E & _). inversion E. subst. rewrite forallb_forall in C. specialize (C q Hq). unfold names_ok in C.
    apply andb_true_iff in C. destruct C as [C1 C2]. split; apply same_test_ok; assumption.
  Qed.
  Theorem turn_step : forall s a u, in_sizes s -> step (system_lts Y) s a u ->
    exists b, a = old_event b /\ keeps a b /\ step (system_lts Y) (turn s) b (turn u).
  Proof.
    intros s a u Hs St. apply in_map_iff in St. destruct St as ([a' ch] & E & H). cbn [fst snd] in E. inversion E. subst.
    destruct (whole_agree s Hs) as [F _]. destruct (F _ H) as ([b ch'] & H' & Eb & Ea & L). cbn [fst snd] in *. exists b.
    split; [ exact Ea | split; [ subst b; exact (move_keeps s a ch H) |]]. apply in_map_iff. exists (b, ch'). split; [| exact H' ].
    cbn [fst snd]. rewrite (turned_target s ch ch' (proj1 Hs) L). reflexivity.
  Qed.
  Theorem turn_can : forall s b, in_sizes s -> can (system_lts Y) (turn s) b ->
    keeps (old_event b) b /\ can (system_lts Y) s (old_event b).
  Proof.
    intros s b Hs (w & St). apply in_map_iff in St. destruct St as ([b' ch'] & E & H). cbn [fst snd] in E. inversion E. subst.
    destruct (whole_agree s Hs) as [_ F]. destruct (F _ H) as ([a ch] & H' & Eb & Ea & _). cbn [fst snd] in *.
    unfold old_event. rewrite <- Ea. split; [ subst b; exact (move_keeps s a ch H') |]. exists (apply s ch). apply in_map_iff.
    exists (a, ch). auto.
  Qed.
  Lemma changes_bounded : forall s c, in_sizes s -> In c (changes_of s) -> (snd c <? size_of (fst c)) = true.
  Proof.
    intros s c [L B] H. apply in_map_iff in H. destruct H as ([j p] & E & H). subst c. cbn [fst snd].
    destruct checks_hold as (N & _). assert (P : pull_at j = p).
    { destruct (pull_in_cases (pulls g) j) as [K | [_ K]].
      - assert (F := unique_image _ _ fst _ _ _ N K H eq_refl). inversion F. reflexivity.
      - exfalso. apply K. apply (in_map fst) in H. exact H. }
    subst p. destruct (pull_facts j H) as (_ & F & _ & C). exact (proj1 (C _ (B (source_at j) F))).
  Qed.
End Automorphism.
