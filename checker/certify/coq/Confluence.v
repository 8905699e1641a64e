(* SPDX-License-Identifier: Apache-2.0 *)
(* Checks that steps of a compiled process are strongly confluent (docs/search.md, "Confluent taus", conditions 1 to 4),
   and proves that they are. Any function may state which steps are followed. *)
From Coq Require Import List Bool Arith ZArith Lia Uint63 PArray.
From Certify Require Import Claims Processes Loops Moves Packing WholeRules.
Import ListNotations.
Open Scope uint63_scope.

(* Some components and their states. *)
Definition cube := list (nat * int).
Fixpoint local_in (c : cube) (k : nat) : option int :=
  match c with [] => None | (j, v) :: c' => if Nat.eqb j k then Some v else local_in c' k end.
Fixpoint put_in (c : cube) (k : nat) (x : int) : cube :=
  match c with [] => [] | (j, v) :: c' => (j, if Nat.eqb j k then x else v) :: put_in c' k x end.

(* The steps that are followed. Entry j says: in each state in which the components of `states_of j` have these states, the
   step by rule `follows j` is followed. After another step, the entry `entry_after` applies. `hint` returns the entries
   by which a packed state is led on. *)
Record confluent_steps := {
  entries : int;
  follows : int -> int;
  states_of : int -> cube;
  entry_after : int -> cube -> int;
  hint : list int -> list int }.

Definition same_item (x y : item) : bool :=
  match x, y with
  | Performs k e, Performs j d => if Nat.eqb k j then e =? d else false
  | Sets k v, Sets j w => if Nat.eqb k j then v =? w else false
  | _, _ => false
  end.
Fixpoint same_items (l m : list item) : bool :=
  match l, m with
  | [], [] => true
  | x :: l', y :: m' => if same_item x y then same_items l' m' else false
  | _, _ => false
  end.
Lemma same_items_equal : forall l m, same_items l m = true -> l = m.
Proof.
  induction l as [| x l IH]; intros [| y m] H; cbn in H; try discriminate; [ reflexivity |].
  destruct (same_item x y) eqn:E; [| discriminate]. f_equal; [| exact (IH m H) ].
  destruct x as [k e | k e], y as [j d | j d]; cbn in E; try discriminate;
    (destruct (Nat.eqb k j) eqn:K; [| discriminate ]; apply Nat.eqb_eq in K; apply eqb_true in E; subst; reflexivity).
Qed.
Fixpoint same_path (p q : list nat) : bool :=
  match p, q with
  | [], [] => true
  | i :: p', j :: q' => if Nat.eqb i j then same_path p' q' else false
  | _, _ => false
  end.
Lemma same_path_equal : forall p q, same_path p q = true -> p = q.
Proof.
  induction p as [| i p IH]; intros [| j q] H; cbn in H; try discriminate; [ reflexivity |].
  destruct (Nat.eqb i j) eqn:E; [| discriminate]. apply Nat.eqb_eq in E. subst. f_equal. auto.
Qed.

(* The elements of a list by their indices. *)
Fixpoint load {A} (l : list A) (i : int) (t : array A) : array A :=
  match l with [] => t | x :: l' => load l' (i + 1) t.[i <- x] end.
Definition element {A} (l : list A) : int -> option A :=
  match l with
  | [] => fun _ => None
  | x :: _ =>
      let count := of_Z (Z.of_nat (List.length l)) in
      if count <=? max_length then
        if (Z.of_nat (List.length l) <? 2 ^ 60)%Z then
          let t := load l 0 (make count x) in fun i => if i <? count then Some t.[i] else None
        else fun _ => None
      else fun _ => None
  end.
Lemma load_in : forall A (L : list A) l i t, incl l L -> (to_Z i + Z.of_nat (List.length l) <= to_Z (length t))%Z ->
  (forall j, (to_Z j < to_Z i)%Z -> In t.[j] L) ->
  forall j, (to_Z j < to_Z i + Z.of_nat (List.length l))%Z -> In (load l i t).[j] L.
Proof.
  intros A L. induction l as [| x l IH]; intros i t HL Hl H j Hj; cbn [load List.length] in *; [ apply H; lia |].
  pose proof (to_Z_bounded (length t)). pose proof (to_Z_bounded i).
  assert (E : to_Z (i + 1) = (to_Z i + 1)%Z).
  { rewrite add_spec. apply Z.mod_small. change (to_Z 1) with 1%Z. lia. }
  apply IH; rewrite ?length_set, ?E; [ intros y Hy; apply HL; right; exact Hy | lia | | lia ].
  intros k Hk. destruct (Z.eq_dec (to_Z k) (to_Z i)) as [K | K].
  - apply to_Z_inj in K. subst. rewrite get_set_same by (apply ltb_spec; lia). apply HL. left. reflexivity.
  - rewrite get_set_other by congruence. apply H. lia.
Qed.
Lemma some_equal : forall A (x y : A), Some x = Some y -> x = y.
Proof. intros A x y H. congruence. Qed.
Lemma element_in : forall A (l : list A) i x, element l i = Some x -> In x l.
Proof.
  intros A l i x H. unfold element in H. destruct l as [| y l]; [ discriminate |]. set (L := y :: l) in *. cbn zeta in H.
  set (count := of_Z (Z.of_nat (List.length L))) in *. destruct (count <=? max_length) eqn:M; [| discriminate ].
  destruct (Z.of_nat (List.length L) <? 2 ^ 60)%Z eqn:B; [| discriminate ]. apply Z.ltb_lt in B.
  destruct (i <? count) eqn:I; [| discriminate]. apply ltb_spec in I. apply some_equal in H. rewrite <- H. clear H.
  assert (V : to_Z count = Z.of_nat (List.length L)).
  { unfold count. rewrite of_Z_spec. apply Z.mod_small. split; [ lia |]. change wB with (2 ^ 63)%Z.
    assert (2 ^ 60 < 2 ^ 63)%Z by reflexivity. lia. }
  apply (load_in A L L 0); [ apply incl_refl | | | change (to_Z 0) with 0%Z; lia ].
  - rewrite length_make, M. change (to_Z 0) with 0%Z. lia.
  - intros j Hj. change (to_Z 0) with 0%Z in Hj. pose proof (to_Z_bounded j). lia.
Qed.

Section Confluence.
  Variable Y : system.
  Variable C : confluent_steps.
  Variable any : bool.  (* every event is taken for a tau *)
  (* The transitions of a component in a state, by event. The list may also contain transitions with other events. *)
  Variable row_of : nat -> ev -> int -> list (ev * int).
  Hypothesis row_of_ok : forall k e v x, In (e, x) (row_of k e v) <-> In (e, x) (edges Y k v).
  Let n := List.length (start Y).
  Definition rules_of_whole : list whole_rule := whole_rules (whole Y) [].

  (* The state to which the event e leads component k from state v. *)
  Definition goal (k : nat) (e : ev) (v : int) : int :=
    match find (fun x : ev * int => fst x =? e) (row_of k e v) with Some x => snd x | None => v end.
  Definition has_event (k : nat) (e : ev) (v : int) : bool := existsb (fun x : ev * int => fst x =? e) (row_of k e v).
  Definition determined (k : nat) (e : ev) (v : int) : bool :=
    if has_event k e v then
      let g := goal k e v in forallb (fun x : ev * int => if fst x =? e then snd x =? g else true) (row_of k e v)
    else false.
  Definition has_target (k : nat) (e : ev) (v x : int) : bool :=
    existsb (fun y : ev * int => if fst y =? e then snd y =? x else false) (row_of k e v).

  (* What the followed step changes. *)
  Definition does_item (k : nat) (v : int) (it : item) (x : int) : int :=
    match it with
    | Performs j e => if Nat.eqb j k then goal k e v else x
    | Sets j y => if Nat.eqb j k then y else x
    end.
  Definition effect (its : list item) (k : nat) (v : int) : int := fold_left (fun x it => does_item k v it x) its v.
  Definition touches (its : list item) (k : nat) : bool := existsb (fun it => Nat.eqb (item_slot it) k) its.
  Definition change_of (local : nat -> int) (it : item) : change :=
    match it with Performs k e => (k, goal k e (local k)) | Sets k x => (k, x) end.
  Definition changes_at (s : list int) (its : list item) : list change := map (change_of (fun k => nth k s 0)) its.
  Definition in_cube (s : list int) (c : cube) : Prop := forall k v, local_in c k = Some v -> nth k s 0 = v.

  (** The conditions on one entry: the rule R, the cube c, and other rules w. *)
  Definition sure (c : cube) (it : item) : bool :=
    if Nat.ltb (item_slot it) n then
      match it with
      | Performs k e => match local_in c k with Some v => determined k e v | None => false end
      | Sets _ _ => true
      end
    else false.
  Definition impossible (c : cube) (it : item) : bool :=
    match it with
    | Performs k e => match local_in c k with Some v => negb (has_event k e v) | None => false end
    | Sets _ _ => false
    end.
  Definition overrules (g h : passage) : bool :=
    match level (own g), level (own h) with
    | Some l, Some m => if l <? m then same_path (place g) (place h) else false
    | _, _ => false
    end.
  Definition cannot_fire (R : whole_rule) (c : cube) (w : whole_rule) : bool :=
    if existsb (impossible c) (items w) then true
    else existsb (fun h => existsb (fun g => overrules g h) (passages R)) (passages w).
  (* R and the item commute. *)
  Definition own_items (its : list item) (k : nat) : list item := filter (fun it => Nat.eqb (item_slot it) k) its.
  Definition commutes (R : list item) (c : cube) (it : item) : bool :=
    let k := item_slot it in
    match own_items R k with
    | [] => true
    | [Performs _ e] =>
        match it, local_in c k with
        | Performs _ d, Some v =>
            let u := goal k e v in
            forallb (fun x : ev * int => if fst x =? d then has_target k d u (goal k e (snd x)) else true) (row_of k d v)
        | _, _ => false
        end
    | _ => false
    end.
  Definition leaves (R : list item) (c : cube) (k : nat) : bool :=
    match local_in c k with Some v => effect R k v =? v | None => false end.
  Definition undisturbed (R : list item) (c : cube) (g : passage) : bool :=
    if prior g then forallb (fun it => let k := item_slot it in
                                       if existsb (Nat.eqb k) (around g) then leaves R c k else true) R
    else true.
  (* The cubes to which w leads from c. *)
  Fixpoint outcomes (c : cube) (its : list item) (d : cube) : list cube :=
    match its with
    | [] => [d]
    | Performs k e :: rest =>
        match local_in c k with
        | Some v => flat_map (fun x : ev * int => if fst x =? e then outcomes c rest (put_in d k (snd x)) else []) (row_of k e v)
        | None => outcomes c rest d
        end
    | Sets k x :: rest => outcomes c rest (put_in d k x)
    end.
  Definition implies_cube (c d : cube) : bool :=
    forallb (fun kv => match local_in c (fst kv) with Some v => v =? snd kv | None => false end) d.
  Definition continues (j : int) (c : cube) : bool :=
    let i := entry_after C j c in
    if i <? entries C then if follows C i =? follows C j then implies_cube c (states_of C i) else false else false.
  Definition spared (j : int) (R : whole_rule) (c : cube) (w : whole_rule) : bool :=
    if cannot_fire R c w then true
    else if (if performed w =? performed R then same_items (items w) (items R) else false) then true
    else if forallb (commutes (items R) c) (items w) then
      if forallb (undisturbed (items R) c) (passages w) then forallb (continues j) (outcomes c (items w) c) else false
    else false.

  (* All other rules are spared without a check. *)
  Definition touching (rules : list whole_rule) (k : nat) : list whole_rule := filter (fun w => touches (items w) k) rules.
  Definition guarding (rules : list whole_rule) (k : nat) : list whole_rule :=
    filter (fun w => existsb (fun g => if prior g then existsb (Nat.eqb k) (around g) else false) (passages w)) rules.
  Definition by_slot (f : nat -> list whole_rule) : nat -> list whole_rule :=
    let rows := map f (seq 0 n) in fun k => match nth_error rows k with Some l => l | None => f k end.
  Definition entry_ok (rule_at : int -> option whole_rule) (near around_of : nat -> list whole_rule) (j : int) : bool :=
    match rule_at (follows C j) with
    | None => false
    | Some R =>
        let c := states_of C j in
        if (if any then true else performed R =? tau) then
          if forallb (fun g => negb (prior g)) (passages R) then
            if forallb (sure c) (items R) then
              if forallb (fun kv => if Nat.ltb (fst kv) n then forallb (spared j R c) (near (fst kv)) else false) c then
                forallb (fun it => if forallb (spared j R c) (near (item_slot it)) then
                                     forallb (spared j R c) (around_of (item_slot it)) else false) (items R)
              else false
            else false
          else false
        else false
    end.
  Definition confluent_ok : bool :=
    let rules := rules_of_whole in
    let rule_at := element rules in
    let near := by_slot (touching rules) in
    let around_of := by_slot (guarding rules) in
    all_below (entry_ok rule_at near around_of) (entries C).

  (** Proofs. *)
  Fixpoint final (ch : list change) (k : nat) (d : int) : int :=
    match ch with [] => d | (j, x) :: ch' => final ch' k (if Nat.eqb j k then x else d) end.
  Lemma update_nth : forall s j x k, (k < List.length s)%nat -> nth k (update s j x) 0 = if Nat.eqb j k then x else nth k s 0.
  Proof.
    induction s as [| v s IH]; intros [| j] x [| k] H; cbn in *; try lia; try reflexivity. apply IH. lia.
  Qed.
  Lemma apply_nth : forall ch s k, (k < List.length s)%nat -> nth k (apply s ch) 0 = final ch k (nth k s 0).
  Proof.
    induction ch as [| [j x] ch IH]; intros s k H; [ reflexivity |].
    change (apply s ((j, x) :: ch)) with (apply (update s j x) ch). rewrite IH by (rewrite update_length; exact H).
    cbn [final]. rewrite update_nth by exact H. reflexivity.
  Qed.
  Lemma apply_same_length : forall ch s, List.length (apply s ch) = List.length s.
  Proof.
    induction ch as [| [j x] ch IH]; intros s; [ reflexivity |].
    change (apply s ((j, x) :: ch)) with (apply (update s j x) ch). rewrite IH. apply update_length.
  Qed.
  Lemma same_states : forall s t : list int, List.length s = List.length t ->
    (forall k, (k < List.length s)%nat -> nth k s 0 = nth k t 0) -> s = t.
  Proof. intros s t H K. exact (nth_ext s t 0 0 H K). Qed.

  Lemma changes_final : forall its s k d, final (changes_at s its) k d = fold_left (fun x it => does_item k (nth k s 0) it x) its d.
  Proof.
    induction its as [| it its IH]; intros s k d; [ reflexivity |]. cbn [changes_at map fold_left].
    destruct it as [j e | j x]; cbn [change_of final]; rewrite <- IH; unfold changes_at; f_equal; cbn [does_item];
      destruct (Nat.eqb j k) eqn:E; try reflexivity. apply Nat.eqb_eq in E. subst. reflexivity.
  Qed.
  Lemma changes_nth : forall its s k, (k < List.length s)%nat ->
    nth k (apply s (changes_at s its)) 0 = effect its k (nth k s 0).
  Proof. intros. rewrite apply_nth by assumption. apply changes_final. Qed.
  Lemma untouched_fold : forall its k v d, touches its k = false -> fold_left (fun x it => does_item k v it x) its d = d.
  Proof.
    induction its as [| it its IH]; intros k v d H; [ reflexivity |]. cbn in H. apply orb_false_iff in H. destruct H as [H1 H2].
    cbn [fold_left]. rewrite IH by exact H2. destruct it as [j e | j x]; cbn [does_item item_slot] in *; rewrite H1; reflexivity.
  Qed.
  Lemma own_touches : forall its k, own_items its k = [] -> touches its k = false.
  Proof.
    induction its as [| it its IH]; intros k H; [ reflexivity |]. cbn in *. destruct (Nat.eqb (item_slot it) k); [ discriminate |].
    apply IH, H.
  Qed.
  Lemma single_fold : forall its k it v d, own_items its k = [it] ->
    fold_left (fun x it => does_item k v it x) its d = does_item k v it d.
  Proof.
    induction its as [| i its IH]; intros k it v d H; [ discriminate |]. cbn in H. cbn [fold_left].
    destruct (Nat.eqb (item_slot i) k) eqn:E.
    - inversion H as [[Ei Er]]. subst i. rewrite untouched_fold; [ reflexivity | apply own_touches; exact Er ].
    - rewrite (IH k it v _ H). f_equal. destruct i as [j e | j x]; cbn [does_item item_slot] in *; rewrite E; reflexivity.
  Qed.

  Lemma goal_in : forall k e v, has_event k e v = true -> In (e, goal k e v) (edges Y k v).
  Proof.
    intros k e v H. unfold has_event in H. unfold goal. apply row_of_ok. apply existsb_exists in H. destruct H as (x & Hx & E).
    destruct (find _ _) as [[d y] |] eqn:F.
    - apply find_some in F. destruct F as [F1 F2]. cbn in F2. apply eqb_true in F2. subst. exact F1.
    - exfalso. assert (K := find_none _ _ F x Hx). cbn beta in K. congruence.
  Qed.
  Lemma determined_unique : forall k e v x, determined k e v = true -> In (e, x) (edges Y k v) -> x = goal k e v.
  Proof.
    unfold determined. intros k e v x H K. destruct (has_event k e v); [| discriminate ]. rewrite forallb_forall in H.
    apply row_of_ok in K. specialize (H (e, x) K). cbn [fst snd] in H. rewrite eqb_refl in H. apply eqb_true. exact H.
  Qed.
  Lemma sure_changes : forall s c its ch, in_cube s c -> forallb (sure c) its = true ->
    (Forall2 (takes Y s) its ch <-> ch = changes_at s its).
  Proof.
    intros s c its ch G. revert ch. induction its as [| it its IH]; intros ch H.
    - split; [ intros F; inversion F; reflexivity | intros E; subst; constructor ].
    - cbn in H. apply andb_true_iff in H. destruct H as [H1 H2]. specialize (fun ch => IH ch H2).
      assert (ONE : forall d, takes Y s it d <-> d = change_of (fun k => nth k s 0) it).
      { intros d. unfold sure in H1. destruct (Nat.ltb _ _); [| discriminate ]. destruct it as [k e | k x]; cbn [takes change_of].
        - destruct (local_in c k) as [v |] eqn:L; [| discriminate ]. rewrite (G k v L). split.
          + intros [E1 E2]. destruct d as [j x]. cbn in *. subst. f_equal. exact (determined_unique k e v x H1 E2).
          + intros E. subst d. split; [ reflexivity |]. cbn [snd]. apply goal_in. unfold determined in H1.
            destruct (has_event k e v); [ reflexivity | discriminate ].
        - reflexivity. }
      split.
      + intros F. inversion F as [| i d is ds T R]. subst. cbn. f_equal; [ apply ONE, T | apply IH, R ].
      + intros E. subst. cbn. constructor; [ apply ONE; reflexivity | apply IH; reflexivity ].
  Qed.

  (* What a check of the entry j has found. *)
  Definition entry_holds (j : int) (R : whole_rule) : Prop :=
    In R rules_of_whole /\ (any = true \/ performed R = tau) /\ forallb (fun g => negb (prior g)) (passages R) = true /\
    forallb (sure (states_of C j)) (items R) = true /\ (forall k v, In (k, v) (states_of C j) -> (k < n)%nat) /\
    forall w, In w rules_of_whole ->
      spared j R (states_of C j) w = true \/
      ((forall k, touches (items w) k = true -> local_in (states_of C j) k = None /\ touches (items R) k = false) /\
       forallb (undisturbed (items R) (states_of C j)) (passages w) = true).
  Lemma by_slot_plain : forall f k, by_slot f k = f k.
  Proof.
    intros f k. unfold by_slot. cbn zeta. rewrite nth_error_map. destruct (nth_error (seq 0 n) k) as [i |] eqn:E; [| reflexivity ].
    cbn. apply nth_error_nth with (d := 0%nat) in E as E'.
    assert (k < n)%nat by (rewrite <- (seq_length n 0); apply nth_error_Some; congruence).
    rewrite seq_nth in E' by assumption. cbn in E'. subst. reflexivity.
  Qed.
  Lemma touches_in : forall its k, touches its k = true -> exists it, In it its /\ item_slot it = k.
  Proof.
    intros its k H. apply existsb_exists in H. destruct H as (it & Hit & E). apply Nat.eqb_eq in E. eauto.
  Qed.
  Lemma local_in_list : forall c k v, local_in c k = Some v -> In (k, v) c.
  Proof.
    induction c as [| [j x] c IH]; intros k v H; cbn in H; [ discriminate |].
    destruct (Nat.eqb j k) eqn:E; [ apply Nat.eqb_eq in E; inversion H; subst; left; reflexivity | right; auto ].
  Qed.
  Lemma entry_checked : forall j, entry_ok (element rules_of_whole) (by_slot (touching rules_of_whole)) (by_slot (guarding rules_of_whole)) j = true ->
    exists R, element rules_of_whole (follows C j) = Some R /\ entry_holds j R.
  Proof.
    intros j H. unfold entry_ok in H. destruct (element rules_of_whole (follows C j)) as [R |] eqn:E; [| discriminate ].
    exists R. split; [ reflexivity |]. cbn zeta in H.
    destruct (if any then true else performed R =? tau) eqn:A; [| discriminate ].
    destruct (forallb (fun g => negb (prior g)) (passages R)) eqn:HP; [| discriminate ].
    destruct (forallb (sure (states_of C j)) (items R)) eqn:HS; [| discriminate ].
    destruct (forallb _ (states_of C j)) eqn:HC; [| discriminate ].
    split; [ exact (element_in _ _ _ _ E) |]. split.
    { destruct any; [ left; reflexivity | right; apply eqb_true; exact A ]. }
    rewrite forallb_forall in HC, H. split; [ exact HP | split; [ exact HS | split ]].
    { intros k v I. specialize (HC _ I). cbn beta iota in HC. cbn [fst] in HC.
      destruct (Nat.ltb k n) eqn:B; [| discriminate ]. apply Nat.ltb_lt. exact B. }
    intros w Hw.
    destruct (spared j R (states_of C j) w) eqn:SP; [ left; reflexivity | right ].
    assert (N1 : forall k v, In (k, v) (states_of C j) -> touches (items w) k = false).
    { intros k v I. apply not_true_iff_false. intros T. specialize (HC _ I). cbn [fst] in HC.
      destruct (Nat.ltb k n); [| discriminate ]. rewrite by_slot_plain in HC.
      rewrite forallb_forall in HC. rewrite HC in SP; [ discriminate |]. apply filter_In. auto. }
    assert (N2 : forall it, In it (items R) -> touches (items w) (item_slot it) = false /\
              existsb (fun g => if prior g then existsb (Nat.eqb (item_slot it)) (around g) else false) (passages w) = false).
    { intros it I. specialize (H _ I). cbn beta in H. rewrite !by_slot_plain in H.
      destruct (forallb (spared j R (states_of C j)) (touching rules_of_whole (item_slot it))) eqn:F; [| discriminate ].
      rewrite forallb_forall in F, H. split; apply not_true_iff_false; intros T.
      - rewrite F in SP; [ discriminate |]. apply filter_In. auto.
      - rewrite H in SP; [ discriminate |]. apply filter_In. auto. }
    split.
    - intros k T. split.
      + destruct (local_in (states_of C j) k) as [v |] eqn:L; [| reflexivity ]. apply local_in_list in L.
        rewrite (N1 k v L) in T. discriminate.
      + apply not_true_iff_false. intros U. apply touches_in in U. destruct U as (it & Hit & Es). subst.
        destruct (N2 it Hit) as [K _]. congruence.
    - apply forallb_forall. intros g Hg. unfold undisturbed. destruct (prior g) eqn:PG; [| reflexivity ].
      apply forallb_forall. intros it Hit. cbn zeta. destruct (existsb (Nat.eqb (item_slot it)) (around g)) eqn:AR; [| reflexivity ].
      exfalso. destruct (N2 it Hit) as [_ K]. rewrite <- not_true_iff_false in K. apply K. apply existsb_exists.
      exists g. rewrite PG. auto.
  Qed.

  Hypothesis checked : confluent_ok = true.
  Lemma entries_hold : forall j, (j <? entries C) = true ->
    exists R, element rules_of_whole (follows C j) = Some R /\ entry_holds j R.
  Proof. intros j H. apply entry_checked. exact (all_below_spec _ _ checked j H). Qed.

  Lemma put_in_local : forall d k x i, local_in (put_in d k x) i =
    match local_in d i with Some v => Some (if Nat.eqb i k then x else v) | None => None end.
  Proof.
    induction d as [| [j v] d IH]; intros k x i; [ reflexivity |]. cbn.
    destruct (Nat.eqb j i) eqn:E; [| apply IH ]. apply Nat.eqb_eq in E. subst. reflexivity.
  Qed.
  Lemma outcomes_cover : forall s c its ch, in_cube s c -> Forall2 (takes Y s) its ch ->
    forall d, (forall k, local_in c k = None -> local_in d k = None) ->
    exists o, In o (outcomes c its d) /\
      forall k, local_in o k = match local_in d k with Some v => Some (final ch k v) | None => None end.
  Proof.
    intros s c its ch G F. induction F as [| it x its ch T F IH]; intros d D.
    - exists d. split; [ left; reflexivity |]. intros k. cbn. destruct (local_in d k); reflexivity.
    - destruct x as [j y].
      assert (PUT : forall k z, forall i, local_in c i = None -> local_in (put_in d k z) i = None).
      { intros k z i H. rewrite put_in_local, (D i H). reflexivity. }
      destruct it as [k e | k z]; cbn [takes] in T.
      + destruct T as [E I]. cbn in E, I. subst j. cbn [outcomes final]. destruct (local_in c k) as [v |] eqn:L.
        * destruct (IH (put_in d k y) (PUT k y)) as (o & Ho & K). exists o. split.
          { apply in_flat_map. exists (e, y). rewrite (G k v L) in I. apply row_of_ok in I. split; [ exact I |]. cbn. rewrite eqb_refl. exact Ho. }
          intros i. rewrite K, put_in_local. destruct (local_in d i); [| reflexivity ]. rewrite (Nat.eqb_sym k i). reflexivity.
        * destruct (IH d D) as (o & Ho & K). exists o. split; [ exact Ho |]. intros i. rewrite K.
          destruct (Nat.eqb k i) eqn:E; [| reflexivity ]. apply Nat.eqb_eq in E. subst. rewrite (D i L). reflexivity.
      + inversion T. subst. cbn [outcomes final]. destruct (IH (put_in d k z) (PUT k z)) as (o & Ho & K). exists o.
        split; [ exact Ho |]. intros i. rewrite K, put_in_local. destruct (local_in d i); [| reflexivity ].
        rewrite (Nat.eqb_sym k i). reflexivity.
  Qed.
  Lemma untouched_final : forall s its ch k d, Forall2 (takes Y s) its ch -> touches its k = false -> final ch k d = d.
  Proof.
    intros s its ch k d F. revert d. induction F as [| it [j x] its ch T F IH]; intros d H; [ reflexivity |].
    cbn in H. apply orb_false_iff in H. destruct H as [H1 H2]. cbn [final]. rewrite IH by exact H2.
    destruct it as [i e | i y]; cbn [takes item_slot] in T, H1.
    - destruct T as [E _]. cbn in E. subst. rewrite H1. reflexivity.
    - inversion T. subst. rewrite H1. reflexivity.
  Qed.
  Lemma implies_cube_in : forall c d, implies_cube c d = true -> forall k v, local_in d k = Some v -> local_in c k = Some v.
  Proof.
    unfold implies_cube. intros c d H k v L. rewrite forallb_forall in H. specialize (H (k, v) (local_in_list _ _ _ L)).
    cbn [fst snd] in H. destruct (local_in c k) as [w |]; [| discriminate ]. apply eqb_true in H. subst. reflexivity.
  Qed.

  (* The followed steps. *)
  Definition followed (s t : list int) : Prop := List.length s = n /\ exists j R,
    (j <? entries C) = true /\ element rules_of_whole (follows C j) = Some R /\ in_cube s (states_of C j) /\
    t = apply s (changes_at s (items R)).

  Lemma whole_step : forall s a u, step (system_lts Y) s a u <->
    exists w ch, In w rules_of_whole /\ performed w = a /\ enabled_by Y s (items w, passages w) ch /\ u = apply s ch.
  Proof.
    intros s a u. unfold step. cbn. rewrite in_map_iff. split.
    - intros ([b ch] & E & K). cbn [fst snd] in E. inversion E. subst. apply (whole_moves Y s (whole Y) []) in K.
      destruct K as (w & Hw & Ew & En). exists w, ch. auto.
    - intros (w & ch & Hw & Ew & En & Eu). subst. exists (performed w, ch). split; [ reflexivity |].
      apply (whole_moves Y s (whole Y) []). eauto.
  Qed.
  Lemma entry_enabled : forall s j R, in_cube s (states_of C j) -> entry_holds j R ->
    enabled_by Y s (items R, passages R) (changes_at s (items R)).
  Proof.
    intros s j R G (HR & _ & HP & HS & _). split; cbn [fst snd].
    - apply (sure_changes s _ _ _ G HS). reflexivity.
    - pose proof (passages_placed (whole Y) [] R HR) as W. rewrite Forall_forall in *. rewrite forallb_forall in HP.
      intros g Hg. destruct (W g Hg) as (_ & PR & _). apply not_prior_free. specialize (HP g Hg).
      apply negb_true_iff in HP. rewrite <- PR. exact HP.
  Qed.

  Lemma cannot_fire_sound : forall s j R w ch, in_cube s (states_of C j) -> entry_holds j R -> In w rules_of_whole ->
    enabled_by Y s (items w, passages w) ch -> cannot_fire R (states_of C j) w = true -> False.
  Proof.
    intros s j R w ch G HE Hw [E1 E2] H. cbn [fst snd] in E1, E2. unfold cannot_fire in H.
    destruct (existsb (impossible (states_of C j)) (items w)) eqn:X.
    - apply existsb_exists in X. destruct X as (it & Hit & X). clear H.
      assert (T : exists c, takes Y s it c).
      { clear - E1 Hit. induction E1 as [| x c its ch T F IH]; [ destruct Hit |].
        destruct Hit as [E | Hit]; [ subst; eauto | auto ]. }
      destruct T as ([i x] & T). destruct it as [k e | k y]; cbn in X; [| discriminate ].
      destruct (local_in (states_of C j) k) as [v |] eqn:L; [| discriminate ]. destruct T as [_ I]. cbn in I.
      rewrite (G k v L) in I. apply negb_true_iff in X. rewrite <- not_true_iff_false in X. apply X.
      apply existsb_exists. exists (e, x). cbn. split; [ apply row_of_ok; exact I | apply eqb_refl ].
    - apply existsb_exists in H. destruct H as (h & Hh & H). apply existsb_exists in H. destruct H as (g & Hg & H).
      pose proof (entry_enabled s j R G HE) as EN. destruct HE as (HR & _).
      pose proof (passages_passable Y s (whole Y) [] R HR _ EN) as PA.
      pose proof (passages_placed (whole Y) [] R HR) as W1. pose proof (passages_placed (whole Y) [] w Hw) as W2.
      rewrite Forall_forall in PA, W1, W2, E2. destruct (PA g Hg) as [P1 P2]. specialize (E2 h Hh).
      unfold overrules in H. destruct (level (own g)) as [l |] eqn:Lg; [| discriminate ].
      destruct (level (own h)) as [m |] eqn:Lh; [| discriminate ]. destruct (l <? m) eqn:LM; [| discriminate ].
      apply same_path_equal in H. destruct (same_place (whole Y) g h (W1 g Hg) (W2 h Hh) H) as [S1 S2].
      unfold free, prevented in E2. rewrite Lh in E2. rewrite <- not_true_iff_false in E2. apply E2.
      apply existsb_exists. exists (own g). rewrite <- S2, <- S1. split; [ exact P1 |]. unfold before. rewrite Lg, LM. exact P2.
  Qed.

  Definition moved (its : list item) (c : change) : change := (fst c, effect its (fst c) (snd c)).
  Lemma moved_final : forall its ch k d, final (map (moved its) ch) k (effect its k d) = effect its k (final ch k d).
  Proof.
    intros its. induction ch as [| [j x] ch IH]; intros k d; [ reflexivity |]. cbn [map moved fst snd final].
    destruct (Nat.eqb j k) eqn:E; [| apply IH ]. apply Nat.eqb_eq in E. subst. apply IH.
  Qed.
  Lemma untouched_effect : forall its k v, touches its k = false -> effect its k v = v.
  Proof. intros. apply untouched_fold. assumption. Qed.

  Lemma sure_bound : forall c its k, forallb (sure c) its = true -> touches its k = true -> (k < n)%nat.
  Proof.
    intros c its k H T. apply touches_in in T. destruct T as (it & Hit & E). rewrite forallb_forall in H.
    specialize (H it Hit). unfold sure in H. destruct (Nat.ltb (item_slot it) n) eqn:L; [| discriminate ].
    apply Nat.ltb_lt in L. subst. exact L.
  Qed.
  Lemma commutes_takes : forall s j R it x, List.length s = n -> in_cube s (states_of C j) ->
    forallb (sure (states_of C j)) (items R) = true ->
    commutes (items R) (states_of C j) it = true -> takes Y s it x ->
    takes Y (apply s (changes_at s (items R))) it (moved (items R) x).
  Proof.
    intros s j R it x HL G HS H T. set (t := apply s (changes_at s (items R))).
    assert (NT : forall k, (k < n)%nat -> nth k t 0 = effect (items R) k (nth k s 0)).
    { intros k Hk. apply changes_nth. rewrite HL. exact Hk. }
    assert (NO : forall k, touches (items R) k = false -> nth k t 0 = nth k s 0).
    { intros k U. destruct (Nat.ltb k n) eqn:B.
      - apply Nat.ltb_lt in B. rewrite NT by exact B. apply untouched_effect, U.
      - apply Nat.ltb_ge in B. unfold t. rewrite !nth_overflow; [ reflexivity | lia | rewrite apply_same_length; lia ]. }
    unfold commutes in H. cbn zeta in H. destruct (own_items (items R) (item_slot it)) as [| o [| ? ?]] eqn:O;
      [| | destruct o; discriminate ].
    - apply own_touches in O. destruct x as [i y]. destruct it as [k d | k z]; cbn [takes item_slot moved fst snd] in *.
      + destruct T as [E I]. cbn in E, I. subst i. split; [ reflexivity |]. rewrite (NO k O), (untouched_effect _ _ _ O). exact I.
      + inversion T. subst. unfold moved. cbn [fst snd]. rewrite untouched_effect by exact O. reflexivity.
    - destruct o as [k0 e | ? ?]; [| discriminate ]. destruct it as [k d | k z]; cbn [item_slot] in *; [| discriminate ].
      destruct (local_in (states_of C j) k) as [v |] eqn:L; [| discriminate ]. destruct x as [i y]. cbn [takes fst snd moved] in *.
      destruct T as [E I]. subst i. split; [ reflexivity |].
      assert (K0 : k0 = k).
      { assert (F : In (Performs k0 e) (own_items (items R) k)) by (rewrite O; left; reflexivity).
        apply filter_In in F. destruct F as [_ F]. apply Nat.eqb_eq in F. exact F. }
      subst k0.
      assert (EF : forall u, effect (items R) k u = goal k e u).
      { intros u. unfold effect. rewrite (single_fold _ _ _ u u O). cbn [does_item]. rewrite Nat.eqb_refl. reflexivity. }
      assert (B : (k < n)%nat).
      { apply (sure_bound _ _ _ HS). apply existsb_exists. exists (Performs k e). split.
        - assert (F : In (Performs k e) (own_items (items R) k)) by (rewrite O; left; reflexivity). apply filter_In in F. apply F.
        - cbn. apply Nat.eqb_refl. }
      rewrite (NT k B), !EF, (G k v L). rewrite (G k v L) in I. rewrite forallb_forall in H. apply row_of_ok in I. specialize (H (d, y) I).
      cbn [fst snd] in H. rewrite eqb_refl in H. unfold has_target in H. apply existsb_exists in H.
      destruct H as ([b z] & Hz & H). cbn in H. destruct (b =? d) eqn:Eb; [| discriminate ].
      apply eqb_true in Eb, H. subst. apply row_of_ok. exact Hz.
  Qed.
  Lemma undisturbed_free : forall s j R g, List.length s = n -> in_cube s (states_of C j) ->
    well_placed (whole Y) [] g -> undisturbed (items R) (states_of C j) g = true -> free Y s g ->
    free Y (apply s (changes_at s (items R))) g.
  Proof.
    intros s j R g HL G (W1 & W2 & _) H F. unfold undisturbed in H. destruct (prior g) eqn:PG.
    - unfold free. rewrite <- (part_moves_local Y s _ (inside g) (rivals g)); [ exact F |].
      intros k Hk. rewrite <- W1 in Hk. destruct (Nat.ltb k n) eqn:B.
      + apply Nat.ltb_lt in B. rewrite changes_nth by (rewrite HL; exact B).
        destruct (touches (items R) k) eqn:T; [| symmetry; apply untouched_effect, T ].
        apply touches_in in T. destruct T as (it & Hit & Es). subst k. rewrite forallb_forall in H. specialize (H it Hit).
        cbn zeta in H. assert (X : existsb (Nat.eqb (item_slot it)) (around g) = true).
        { apply existsb_exists. exists (item_slot it). split; [ exact Hk | apply Nat.eqb_refl ]. }
        rewrite X in H. unfold leaves in H. destruct (local_in (states_of C j) (item_slot it)) as [v |] eqn:L; [| discriminate ].
        apply eqb_true in H. rewrite (G _ _ L). symmetry. exact H.
      + apply Nat.ltb_ge in B. rewrite !nth_overflow; [ reflexivity | rewrite apply_same_length; lia | lia ].
    - apply not_prior_free. rewrite <- W2. reflexivity.
  Qed.

  (* The condition of the statement in docs/search.md. *)
  Theorem square : forall s t a u, followed s t -> step (system_lts Y) s a u ->
    ((any = true \/ a = tau) /\ u = t) \/ exists v, step (system_lts Y) t a v /\ followed u v.
  Proof.
    intros s t a u (HL & j & R & Hj & ER & G & Et) St. apply whole_step in St.
    destruct St as (w & ch & Hw & Ew & En & Eu).
    destruct (entries_hold j Hj) as (R' & ER' & HE). rewrite ER in ER'. inversion ER'. subst R'. clear ER'.
    pose proof HE as (HR & HA & HP & HS & HB & HO).
    assert (MAIN : forallb (commutes (items R) (states_of C j)) (items w) = true ->
                   forallb (undisturbed (items R) (states_of C j)) (passages w) = true ->
                   (exists i, (i <? entries C) = true /\ element rules_of_whole (follows C i) = Some R /\ in_cube u (states_of C i)) ->
                   exists v, step (system_lts Y) t a v /\ followed u v).
    { intros H1 H2 (i & Hi & Ei & Gu). exists (apply u (changes_at u (items R))). split.
      - apply whole_step. exists w, (map (moved (items R)) ch). split; [ exact Hw | split; [ exact Ew |]].
        destruct En as [F1 F2]. cbn [fst snd] in F1, F2. split; [ split; cbn [fst snd] |].
        + subst t. rewrite forallb_forall in H1. clear - row_of_ok F1 H1 HL G HS.
          induction F1 as [| it x its ch T F IH]; cbn [map]; constructor.
          * apply (commutes_takes s j R it x HL G HS); [ apply H1; left; reflexivity | exact T ].
          * apply IH. intros y Hy. apply H1. right. exact Hy.
        + pose proof (passages_placed (whole Y) [] w Hw) as W. rewrite Forall_forall in F2, W |- *.
          rewrite forallb_forall in H2. intros g Hg. subst t.
          exact (undisturbed_free s j R g HL G (W g Hg) (H2 g Hg) (F2 g Hg)).
        + subst t u. apply same_states; [ rewrite !apply_same_length; reflexivity |].
          rewrite !apply_same_length. intros k Hk. rewrite changes_nth by (rewrite apply_same_length; exact Hk).
          rewrite (apply_nth ch s) by exact Hk. rewrite apply_nth by (rewrite apply_same_length; exact Hk).
          rewrite changes_nth by exact Hk. symmetry. apply moved_final.
      - split; [ subst u; rewrite apply_same_length; exact HL |]. exists i, R. auto. }
    destruct (HO w Hw) as [SP | [D1 D2]].
    - unfold spared in SP. destruct (cannot_fire R (states_of C j) w) eqn:CF.
      { exfalso. exact (cannot_fire_sound s j R w ch G HE Hw En CF). }
      clear CF. destruct (if performed w =? performed R then same_items (items w) (items R) else false) eqn:SAME.
      + left. destruct (performed w =? performed R) eqn:EP; [| discriminate ]. apply eqb_true in EP.
        apply same_items_equal in SAME. split.
        * destruct HA as [A | A]; [ left; exact A | right; congruence ].
        * destruct En as [F _]. cbn [fst] in F. rewrite SAME in F. apply (sure_changes s _ _ _ G HS) in F. subst. reflexivity.
      + right. destruct (forallb (commutes _ _) (items w)) eqn:H1; [| discriminate ].
        destruct (forallb (undisturbed _ _) (passages w)) eqn:H2; [| discriminate ]. apply MAIN; [ reflexivity | reflexivity |].
        rewrite forallb_forall in SP. destruct En as [F _]. cbn [fst] in F.
        destruct (outcomes_cover s _ _ _ G F (states_of C j) (fun k H => H)) as (o & Ho & K). specialize (SP o Ho).
        unfold continues in SP. cbn zeta in SP. set (i := entry_after C j o) in *.
        destruct (i <? entries C) eqn:Hi; [| discriminate ].
        destruct (follows C i =? follows C j) eqn:EF; [| discriminate ]. apply eqb_true in EF.
        exists i. split; [ exact Hi | split; [ rewrite EF; exact ER |]]. intros k v Lk.
        apply (implies_cube_in _ _ SP) in Lk. rewrite K in Lk.
        destruct (local_in (states_of C j) k) as [v0 |] eqn:L0; [| discriminate ]. inversion Lk. subst.
        destruct (Nat.ltb k n) eqn:B.
        * apply Nat.ltb_lt in B. rewrite apply_nth by (rewrite HL; exact B). rewrite (G k v0 L0). reflexivity.
        * exfalso. apply Nat.ltb_ge in B. pose proof (HB k v0 (local_in_list _ _ _ L0)). lia.
    - right. apply MAIN; [| exact D2 |].
      + apply forallb_forall. intros it Hit. unfold commutes. cbn zeta.
        assert (T : touches (items w) (item_slot it) = true).
        { apply existsb_exists. exists it. split; [ exact Hit | apply Nat.eqb_refl ]. }
        destruct (D1 _ T) as [_ U]. destruct (own_items (items R) (item_slot it)) as [| o l] eqn:O; [ reflexivity |].
        exfalso. assert (F : In o (own_items (items R) (item_slot it))) by (rewrite O; left; reflexivity).
        apply filter_In in F. rewrite <- not_true_iff_false in U. apply U. apply existsb_exists. exists o. exact F.
      + exists j. split; [ exact Hj | split; [ exact ER |]]. intros k v L. rewrite <- (G k v L).
        destruct (Nat.ltb k n) eqn:B.
        * apply Nat.ltb_lt in B. subst u. rewrite apply_nth by (rewrite HL; exact B). destruct En as [F _]. cbn [fst] in F.
          apply (untouched_final s (items w) ch); [ exact F |]. apply not_true_iff_false. intros T.
          destruct (D1 k T) as [N _]. congruence.
        * apply Nat.ltb_ge in B. subst u. rewrite !nth_overflow; [ reflexivity | lia | rewrite apply_same_length; lia ].
  Qed.
  Lemma followed_step : forall s t, followed s t -> exists a, (any = true \/ a = tau) /\ step (system_lts Y) s a t.
  Proof.
    intros s t (HL & j & R & Hj & ER & G & Et). destruct (entries_hold j Hj) as (R' & ER' & HE). rewrite ER in ER'.
    inversion ER'. subst R'. pose proof HE as (HR & HA & _). exists (performed R). split; [ exact HA |].
    apply whole_step. exists R, (changes_at s (items R)). split; [ exact HR | split; [ reflexivity | split; [| exact Et ]]].
    exact (entry_enabled s j R G HE).
  Qed.
End Confluence.
