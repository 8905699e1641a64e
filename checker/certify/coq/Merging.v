(* SPDX-License-Identifier: Apache-2.0 *)
(* Proves that equal states of components may be merged. Any function may state which states are equal, because the
   check compares their transitions. The merged process does the same as the process (a functional bisimulation). *)
From Coq Require Import List Bool ZArith Lia Uint63.
From Certify Require Import Claims Processes Loops Moves Packing.
Import ListNotations.
Open Scope uint63_scope.

(* For each component, the number of states that may be merged, and for each of these states an equal state. *)
Record merging := { merged_states : nat -> int; representative : nat -> int -> int }.
Definition merge (M : merging) (k : nat) (v : int) : int :=
  if v <? merged_states M k then representative M k v else v.
Definition merge_edges (M : merging) (k : nat) (l : list (ev * int)) : list (ev * int) :=
  map (fun e => (fst e, merge M k (snd e))) l.
Definition merge_changes (M : merging) (l : list change) : list change :=
  map (fun c => (fst c, merge M (fst c) (snd c))) l.
Fixpoint merge_state (M : merging) (k : nat) (s : list int) : list int :=
  match s with [] => [] | v :: s' => merge M k v :: merge_state M (S k) s' end.
Definition merge_rule (M : merging) (r : rule) : rule :=
  {| does := does r; level := level r; asks := asks r; puts := merge_changes M (puts r) |}.
Fixpoint merge_region (M : merging) (r : region) : region :=
  match r with
  | Region inside rules =>
      Region (map (fun p => match p with Slot k => Slot k | Inner r' => Inner (merge_region M r') end) inside)
             (map (merge_rule M) rules)
  end.
Definition merged (M : merging) (Y : system) : system :=
  {| edges := fun k v => merge_edges M k (edges Y k v);
     start := merge_state M 0 (start Y);
     whole := merge_region M (whole Y) |}.

Definition has_edge (l : list (ev * int)) (e : ev * int) : bool :=
  existsb (fun d => if fst d =? fst e then snd d =? snd e else false) l.
Definition equal_edges (l k : list (ev * int)) : bool := if forallb (has_edge k) l then forallb (has_edge l) k else false.
Fixpoint slots_below (n : nat) (r : region) : bool :=
  match r with
  | Region inside _ =>
      forallb (fun p => match p with Slot k => Nat.ltb k n | Inner r' => slots_below n r' end) inside
  end.
Definition merging_ok (M : merging) (Y : system) : bool :=
  slots_below (length (start Y)) (whole Y) &&
  forallb (fun k => all_below (fun v =>
             let w := merge M k v in
             if w =? v then true else equal_edges (merge_edges M k (edges Y k v)) (merge_edges M k (edges Y k w)))
             (merged_states M k)) (seq 0 (length (start Y))).

Lemma has_edge_in : forall l e, has_edge l e = true -> In e l.
Proof.
  intros l [a u] H. apply existsb_exists in H. destruct H as ([b w] & H & E). cbn in E.
  destruct (b =? a) eqn:Eb; [| discriminate]. apply eqb_true in Eb, E. subst. exact H.
Qed.
Lemma equal_edges_same : forall l k, equal_edges l k = true -> same l k.
Proof.
  unfold equal_edges. intros l k H e. destruct (forallb (has_edge k) l) eqn:F; [| discriminate].
  rewrite forallb_forall in F, H. split; intros I; apply has_edge_in; auto.
Qed.

Lemma combine_same : forall ms ns, (forall i, same (nth i ms []) (nth i ns [])) ->
  forall wanted, same (combine ms wanted) (combine ns wanted).
Proof.
  intros ms ns H. induction wanted as [| [i e] rest IH]; intros ch; [ reflexivity |].
  rewrite !combine_in. split; intros (m & c & Hm & E & Hc & Ec); exists m, c;
    (split; [ apply H; exact Hm | split; [ exact E | split; [ apply IH; exact Hc | exact Ec ]]]).
Qed.

Section Merged.
  Variable M : merging.
  Variable Y : system.
  Hypothesis ok : merging_ok M Y = true.
  Let n := length (start Y).
  Definition merge_move (m : move) : move := (fst m, merge_changes M (snd m)).

  Lemma merge_state_length : forall s k, length (merge_state M k s) = length s.
  Proof. induction s as [| v s IH]; intros k; cbn; auto. Qed.
  Lemma merge_state_nth : forall s k j, (j < length s)%nat -> nth j (merge_state M k s) 0 = merge M (k + j) (nth j s 0).
  Proof.
    induction s as [| v s IH]; intros k [| j] H; cbn in *; try lia.
    - rewrite Nat.add_0_r. reflexivity.
    - rewrite IH by lia. replace (S k + j)%nat with (k + S j)%nat by lia. reflexivity.
  Qed.
  Lemma merge_state_update : forall s k j x,
    update (merge_state M k s) j (merge M (k + j) x) = merge_state M k (update s j x).
  Proof.
    induction s as [| v s IH]; intros k [| j] x; cbn; try reflexivity.
    - rewrite Nat.add_0_r. reflexivity.
    - f_equal. rewrite <- IH. replace (S k + j)%nat with (k + S j)%nat by lia. reflexivity.
  Qed.
  Lemma merge_apply : forall ch s, apply (merge_state M 0 s) (merge_changes M ch) = merge_state M 0 (apply s ch).
  Proof.
    induction ch as [| [k x] ch IH]; intros s; [ reflexivity |]. cbn.
    pose proof (merge_state_update s 0 k x) as U. cbn [Nat.add] in U. rewrite U. apply IH.
  Qed.
  Lemma merge_changes_app : forall x y, merge_changes M (x ++ y) = merge_changes M x ++ merge_changes M y.
  Proof. intros. apply map_app. Qed.

  Lemma merged_combine : forall ms wanted ch,
    In ch (combine (map (map merge_move) ms) wanted) <-> exists c, In c (combine ms wanted) /\ ch = merge_changes M c.
  Proof.
    intros ms. induction wanted as [| [i e] rest IH]; intros ch.
    - cbn. split; [ intros [E | []]; subst; exists []; auto | intros (c & [E | []] & H); subst; auto ].
    - rewrite combine_in. change (@nil move) with (map merge_move []). split.
      + intros (m & c & Hm & E & Hc & Ech). rewrite map_nth in Hm. apply in_map_iff in Hm.
        destruct Hm as (m' & Em & Hm). apply IH in Hc. destruct Hc as (c' & Hc & Ec). exists (snd m' ++ c').
        split; [ apply combine_in; exists m', c'; subst; auto |]. subst. symmetry. apply merge_changes_app.
      + intros (c & H & Ech). apply combine_in in H. destruct H as (m & c' & Hm & E & Hc & Ec).
        exists (merge_move m), (merge_changes M c'). rewrite map_nth. split; [ apply in_map; exact Hm |].
        split; [ exact E |]. split; [ apply IH; eauto |]. subst. apply merge_changes_app.
  Qed.

  (* If two lists of moves have the same sets up to merging, they fire the same moves up to merging. *)
  Lemma merged_fire : forall ms ns rules, (forall i, same (nth i ns []) (nth i (map (map merge_move) ms) [])) ->
    forall m, In m (fire ns (map (merge_rule M) rules)) <-> exists c, In c (fire ms rules) /\ m = merge_move c.
  Proof.
    intros ms ns rules H.
    assert (C : forall wanted ch, In ch (combine ns wanted) <-> exists c, In c (combine ms wanted) /\ ch = merge_changes M c).
    { intros wanted ch. rewrite (combine_same _ _ H wanted ch). apply merged_combine. }
    assert (NE : forall wanted, nonempty (combine ns wanted) = nonempty (combine ms wanted)).
    { intros wanted. apply bool_same. rewrite !nonempty_in. split.
      - intros (ch & K). apply C in K. destruct K as (c & K & _). eauto.
      - intros (c & K). exists (merge_changes M c). apply C. eauto. }
    assert (PV : forall r, prevented ns (map (merge_rule M) rules) (merge_rule M r) = prevented ms rules r).
    { intros r. unfold prevented. cbn [merge_rule level]. destruct (level r) as [l |]; [| reflexivity ].
      apply bool_same. rewrite !existsb_exists. split.
      - intros (q & Hq & K). apply in_map_iff in Hq. destruct Hq as (q' & E & Hq). subst q. exists q'.
        split; [ exact Hq |]. unfold before in *. cbn [merge_rule level asks] in K. rewrite <- NE. exact K.
      - intros (q & Hq & K). exists (merge_rule M q). split; [ apply in_map; exact Hq |].
        unfold before in *. cbn [merge_rule level asks]. rewrite NE. exact K. }
    intros m. unfold fire. rewrite in_flat_map. split.
    - intros (r & Hr & K). apply in_map_iff in Hr. destruct Hr as (r' & E & Hr). subst r. rewrite PV in K.
      destruct (prevented ms rules r') eqn:P; [ destruct K |]. apply in_map_iff in K. destruct K as (ch & E & K).
      apply C in K. destruct K as (c & K & Ec). exists (does r', c ++ puts r'). split.
      + apply in_flat_map. exists r'. split; [ exact Hr |]. rewrite P. apply in_map_iff. eauto.
      + subst. unfold merge_move. cbn [fst snd merge_rule puts does]. rewrite merge_changes_app. reflexivity.
    - intros (c & K & E). apply in_flat_map in K. destruct K as (r & Hr & K).
      destruct (prevented ms rules r) eqn:P; [ destruct K |]. apply in_map_iff in K. destruct K as (ch & Ec & K).
      exists (merge_rule M r). split; [ apply in_map; exact Hr |]. rewrite PV, P. apply in_map_iff.
      exists (merge_changes M ch). subst. split; [| apply C; eauto ]. unfold merge_move. cbn [fst snd merge_rule puts does].
      rewrite merge_changes_app. reflexivity.
  Qed.

  Lemma merged_slot : forall k v, (k < n)%nat ->
    same (slot_moves (merged M Y) k (merge M k v)) (map merge_move (slot_moves Y k v)).
  Proof.
    intros k v Hk m.
    assert (E : same (merge_edges M k (edges Y k (merge M k v))) (merge_edges M k (edges Y k v))).
    { destruct (v <? merged_states M k) eqn:V.
      2: { assert (W : merge M k v = v) by (unfold merge; rewrite V; reflexivity). rewrite W. apply same_refl. }
      unfold merging_ok in ok. apply andb_true_iff in ok. destruct ok as [_ K]. rewrite forallb_forall in K.
      assert (A := all_below_spec _ _ (K k ltac:(apply in_seq; fold n; lia)) v V). cbn beta zeta in A.
      destruct (merge M k v =? v) eqn:W; [ apply eqb_true in W; rewrite W; apply same_refl |].
      apply equal_edges_same in A. intros e. symmetry. apply A. }
    unfold slot_moves. rewrite map_map, !in_map_iff. cbn [merged edges]. split.
    - intros (e & Em & He). apply E in He. apply in_map_iff in He. destruct He as (d & Ed & Hd). exists d. subst. auto.
    - intros (d & Em & Hd). exists (fst d, merge M k (snd d)). split; [ exact Em |]. apply E. apply in_map_iff. eauto.
  Qed.

  Lemma merged_moves : forall s, length s = n -> forall r, slots_below n r = true -> forall m,
    In m (moves (merged M Y) (merge_state M 0 s) (merge_region M r)) <->
    exists c, In c (moves Y s r) /\ m = merge_move c.
  Proof.
    intros s Hs. induction r as [inside rules IH] using region_rect'. intros B. cbn in B. rewrite forallb_forall in B.
    cbn [merge_region moves]. apply merged_fire. intros i.
    rewrite !nth_by_error, !nth_error_map. destruct (nth_error inside i) as [p |] eqn:Hp; cbn; [| apply same_refl ].
    pose proof (B p (nth_error_In _ _ Hp)) as Bp. destruct p as [k | r'].
    - apply Nat.ltb_lt in Bp. rewrite merge_state_nth by lia. cbn [Nat.add]. apply merged_slot. exact Bp.
    - intros m. rewrite (IH r' (nth_error_In _ _ Hp) Bp m), in_map_iff.
      split; intros (c & K1 & K2); exists c; auto.
  Qed.

  Lemma merged_bisimulation : forall s, length s = n -> forall a w,
    step (system_lts (merged M Y)) (merge_state M 0 s) a w <->
    exists u, w = merge_state M 0 u /\ step (system_lts Y) s a u.
  Proof.
    intros s Hs a w. unfold step. cbn [system_lts succ merged whole]. rewrite in_map_iff.
    assert (B : slots_below n (whole Y) = true).
    { unfold merging_ok in ok. apply andb_true_iff in ok. apply ok. }
    split.
    - intros (m & E & K). apply (merged_moves s Hs _ B) in K. destruct K as ([b ch] & K & Em). subst m.
      cbn [merge_move fst snd] in E. rewrite merge_apply in E. inversion E. subst. exists (apply s ch).
      split; [ reflexivity |]. apply in_map_iff. exists (a, ch). auto.
    - intros (u & E & K). apply in_map_iff in K. destruct K as ([b ch] & Eu & K). cbn [fst snd] in Eu. inversion Eu.
      subst. exists (merge_move (a, ch)). cbn [merge_move fst snd]. rewrite merge_apply. split; [ reflexivity |].
      apply (merged_moves s Hs _ B). eauto.
  Qed.
  Lemma apply_length : forall ch s, length (apply s ch) = length s.
  Proof. induction ch as [| [k x] ch IH]; intros s; [ reflexivity |].
    change (length (apply (update s k x) ch) = length s). rewrite IH. apply update_length.
  Qed.
  Lemma merged_length : forall s a u, length s = n -> step (system_lts Y) s a u -> length u = n.
  Proof.
    intros s a u Hs St. unfold step in St. cbn in St. apply in_map_iff in St. destruct St as ([b ch] & E & _).
    cbn [fst snd] in E. inversion E. subst. rewrite <- Hs. exact (apply_length ch s).
  Qed.

  Theorem merged_implementation : forall A m (spec : lts A),
    refines m spec (system_lts (merged M Y)) -> refines m spec (system_lts Y).
  Proof.
    intros A m spec. exact (morphism_refines (system_lts Y) (system_lts (merged M Y)) (merge_state M 0)
      (fun s => length s = n) eq_refl merged_length eq_refl merged_bisimulation A m spec).
  Qed.
  Theorem merged_specification : forall A m (impl : lts A),
    refines m (system_lts (merged M Y)) impl -> refines m (system_lts Y) impl.
  Proof.
    intros A m impl. exact (back_refines (system_lts Y) (system_lts (merged M Y)) (merge_state M 0)
      (fun s => length s = n) eq_refl merged_length eq_refl merged_bisimulation A m impl).
  Qed.
  Theorem merged_property : forall p, satisfies p (system_lts (merged M Y)) -> satisfies p (system_lts Y).
  Proof.
    exact (morphism_satisfies (system_lts Y) (system_lts (merged M Y)) (merge_state M 0)
      (fun s => length s = n) eq_refl merged_length eq_refl merged_bisimulation).
  Qed.
End Merged.
