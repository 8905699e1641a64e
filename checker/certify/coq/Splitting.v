(* SPDX-License-Identifier: Apache-2.0 *)
(* Splits a term into components and rules, and proves that they do what the firing rules say of the term (a functional
   bisimulation). Unverified code chooses the components and numbers their states. *)
From Coq Require Import List Bool ZArith Lia Uint63 PArray.
From Certify Require Import Claims Terms Processes Loops Certificate Moves Packing Merging.
Import ListNotations.
Open Scope uint63_scope.

(** Comparison of terms. *)
Fixpoint eq_term (p q : term) : bool :=
  match p, q with
  | Offer l, Offer k =>
      (fix same l k := match l, k with
        | [], [] => true
        | (a, p) :: l, (b, q) :: k => if a =? b then if eq_term p q then same l k else false else false
        | _, _ => false
        end) l k
  | Call k, Call l => k =? l
  | Choice a p q, Choice b p' q' | Interrupt a p q, Interrupt b p' q' | Throw a p q, Throw b p' q' =>
      if a =? b then if eq_term p p' then eq_term q q' else false else false
  | Sliding p q, Sliding p' q' | Sequence p q, Sequence p' q' => if eq_term p p' then eq_term q q' else false
  | Parallel a b c p q, Parallel a' b' c' p' q' =>
      if a =? a' then if b =? b' then if c =? c' then if eq_term p p' then eq_term q q' else false
      else false else false else false
  | Hide a p, Hide b q | Rename a p, Rename b q | Prioritise a p, Prioritise b q => if a =? b then eq_term p q else false
  | _, _ => false
  end.

Lemma term_rect' : forall P : term -> Prop,
  (forall l, (forall a p, In (a, p) l -> P p) -> P (Offer l)) -> (forall k, P (Call k)) ->
  (forall a p q, P p -> P q -> P (Choice a p q)) -> (forall p q, P p -> P q -> P (Sliding p q)) ->
  (forall p q, P p -> P q -> P (Sequence p q)) -> (forall a p q, P p -> P q -> P (Interrupt a p q)) ->
  (forall a p q, P p -> P q -> P (Throw a p q)) -> (forall a b c p q, P p -> P q -> P (Parallel a b c p q)) ->
  (forall a p, P p -> P (Hide a p)) -> (forall r p, P p -> P (Rename r p)) ->
  (forall o p, P p -> P (Prioritise o p)) -> forall p, P p.
Proof.
  intros P H0 H1 H2 H3 H4 H5 H6 H7 H8 H9 H10. fix self 1.
  intros [l | k | a p q | p q | p q | a p q | a p q | a b c p q | a p | r p | o p];
    [ apply H0 | apply H1 | apply H2; apply self | apply H3; apply self | apply H4; apply self | apply H5; apply self
    | apply H6; apply self | apply H7; apply self | apply H8; apply self | apply H9; apply self | apply H10; apply self ].
  assert (K : Forall (fun m : ev * term => P (snd m)) l).
  { induction l as [| [b q] l IH]; constructor; [ exact (self q) | exact IH ]. }
  intros a p M. exact (proj1 (Forall_forall _ _) K (a, p) M).
Qed.
Lemma eq_term_ok : forall p q, eq_term p q = true -> p = q.
Proof.
  induction p using term_rect'; intros [] E; cbn in E; try discriminate;
    repeat match goal with
    | E : (if ?c then _ else false) = true |- _ => destruct c eqn:?; [| discriminate]
    | E : (_ =? _) = true |- _ => apply eqb_true in E
    end; subst; try (f_equal; auto; fail).
  f_equal. revert branches E. induction l as [| [a p] l IH]; intros [| [b q] k] E; try discriminate; [ reflexivity |].
  destruct (a =? b) eqn:Ea; [| discriminate]. destruct (eq_term p q) eqn:Ep; [| discriminate].
  apply eqb_true in Ea. apply (H a) in Ep; [| left; reflexivity ]. subst. f_equal. apply IH; [| exact E ].
  intros c r I. apply (H c). right. exact I.
Qed.

(** A larger bound gives the same moves. *)
Lemma moves_of_more : forall D n p l, moves_of D n p = Some l -> forall m, (n <= m)%nat -> moves_of D m p = Some l.
Proof.
  induction n as [| n IH]; intros p l H m Hm; [ discriminate |]. destruct m as [| m]; [ lia |].
  assert (G : forall p l, moves_of D n p = Some l -> moves_of D m p = Some l) by (intros; apply (IH p0); [ assumption | lia ]).
  destruct p; cbn [moves_of] in *; auto;
    unfold on_one, on_both in *;
    repeat match goal with
    | H : match moves_of D n ?p with _ => _ end = _ |- _ =>
        let E := fresh in destruct (moves_of D n p) eqn:E; [ rewrite (G _ _ E) | discriminate ]
    end; assumption.
Qed.

(** The distinct events of a list. The number of events is the length of the table. *)
Definition distinct (events : int) (l : list ev) : list ev :=
  snd (fold_left (fun (x : array bool * list ev) e => let (t, found) := x in
         if t.[e] then x else (t.[e <- true], e :: found)) l (make events false, [])).
Lemma get_set : forall (t : array bool) d e, t.[d <- true].[e] = true -> e = d \/ t.[e] = true.
Proof.
  intros t d e H. destruct (Uint63.eqs d e) as [E | E]; [ auto |]. rewrite get_set_other in H by exact E. auto.
Qed.
Lemma get_made : forall n e, (make n false).[e] = false.
Proof. intros. apply get_make. Qed.
Lemma distinct_in : forall n l e, In e (distinct n l) <-> In e l.
Proof.
  intros n l e. unfold distinct.
  assert (G : forall l t found, (forall d, t.[d] = true -> In d found) ->
    (In e (snd (fold_left (fun (x : array bool * list ev) e => let (t, found) := x in
         if t.[e] then x else (t.[e <- true], e :: found)) l (t, found))) <-> In e l \/ In e found)).
  { clear. induction l as [| d l IH]; intros t found H; cbn [fold_left]; [ cbn; tauto |].
    destruct t.[d] eqn:Td.
    - rewrite IH by exact H. cbn. split; [ tauto |]. intros [[E | K] | K]; auto. subst. auto.
    - rewrite IH. { cbn. intuition auto. }
      intros b K. apply get_set in K. destruct K as [K | K]; [ left; auto | right; auto ]. }
  rewrite G; [ cbn; tauto |]. intros d K. rewrite get_made in K. discriminate.
Qed.

(* How a term is split: the leaves are components. *)
Inductive tree :=
| Leaf (k : nat)
| Beside (only_p only_q both : int) (t u : tree)
| Hidden (a : int) (t : tree)
| Renamed (r : int) (t : tree)
| Prioritised (o : int) (t : tree).
Record split := {
  whole_tree : tree;
  slots : nat;                   (* the number of components *)
  states : nat -> int;           (* the number of states of each component *)
  meaning : nat -> int -> term;  (* the term of each state *)
  number_of : nat -> term -> int;
  alphabet : nat -> list ev;
  enough : nat;                  (* the bound for the moves of components *)
  event_bound : int }.           (* the length of tables of events *)

(** Rules without assignments, which are called vectors. *)
Record vector := { gives : ev; rank_of : option int; wants : list (nat * ev) }.
Definition rule_of (v : vector) : rule := {| does := gives v; level := rank_of v; asks := wants v; puts := [] |}.
Definition compiled := (list participant * list vector)%type.
Definition region_of (c : compiled) : region := Region (fst c) (map rule_of (snd c)).
Definition each (l : list ev) : list vector :=
  map (fun e => {| gives := e; rank_of := None; wants := [(0%nat, e)] |}) l.
Definition free (vs : list vector) : bool :=
  forallb (fun v => match rank_of v with None => true | Some _ => false end) vs.
Definition boxed (events : int) (c : compiled) : compiled :=
  if free (snd c) then c else ([Inner (region_of c)], each (distinct events (map gives (snd c)))).
Definition relabel (f : ev -> list ev) (c : compiled) : compiled :=
  (fst c, flat_map (fun v => map (fun e => {| gives := e; rank_of := rank_of v; wants := wants v |}) (f (gives v))) (snd c)).
Definition ranked_by (f : ev -> option int) (c : compiled) : compiled :=
  (fst c, map (fun v => {| gives := gives v; rank_of := f (gives v); wants := wants v |}) (snd c)).
Definition shift (n : nat) (l : list (nat * ev)) : list (nat * ev) := map (fun x => ((n + fst x)%nat, snd x)) l.
Definition shifted (n : nat) (v : vector) : vector :=
  {| gives := gives v; rank_of := None; wants := shift n (wants v) |}.
Definition beside (events : int) (on_p on_q on_both : ev -> bool) (c d : compiled) : compiled :=
  let n := List.length (fst c) in
  let others := table events (fun e => if on_both e then filter (fun v => gives v =? e) (snd d) else []) in
  (fst c ++ fst d,
   filter (fun v => on_p (gives v)) (snd c) ++ map (shifted n) (filter (fun v => on_q (gives v)) (snd d)) ++
   flat_map (fun v => if on_both (gives v) then
                        map (fun w => {| gives := gives v; rank_of := None; wants := wants v ++ shift n (wants w) |})
                            (others (gives v))
                      else []) (snd c)).

(** What vectors do. *)
Lemma prevented_in : forall ms vs v, prevented ms (map rule_of vs) (rule_of v) = true <->
  exists l w k, rank_of v = Some l /\ In w vs /\ rank_of w = Some k /\ (k <? l) = true /\ exists ch, In ch (combine ms (wants w)).
Proof.
  intros ms vs v. unfold prevented. cbn [rule_of level]. destruct (rank_of v) as [l |].
  2: { split; [ discriminate | intros (l & w & k & E & _); discriminate ]. }
  rewrite existsb_exists. split.
  - intros (r & Hr & H). apply in_map_iff in Hr. destruct Hr as (w & E & Hw). subst r. apply andb_true_iff in H.
    destruct H as [B N]. unfold before in B. cbn [rule_of level asks] in B, N. destruct (rank_of w) as [k |] eqn:K; [| discriminate ].
    apply nonempty_in in N. exists l, w, k. auto.
  - intros (l' & w & k & E & Hw & K & B & N). inversion E. subst l'. exists (rule_of w).
    split; [ apply in_map; exact Hw |]. unfold before. cbn [rule_of level asks]. rewrite K, B. apply nonempty_in. exact N.
Qed.
Lemma fire_in : forall ms vs a ch, In (a, ch) (fire ms (map rule_of vs)) <->
  exists v, In v vs /\ prevented ms (map rule_of vs) (rule_of v) = false /\ a = gives v /\ In ch (combine ms (wants v)).
Proof.
  intros ms vs a ch. unfold fire. rewrite in_flat_map. split.
  - intros (r & Hr & H). apply in_map_iff in Hr. destruct Hr as (v & E & Hv). subst r.
    destruct (prevented ms (map rule_of vs) (rule_of v)) eqn:P; [ destruct H |]. apply in_map_iff in H.
    destruct H as (c & E & Hc). cbn [rule_of does puts asks] in E, Hc. rewrite app_nil_r in E. inversion E. subst. eauto.
  - intros (v & Hv & P & E & Hc). exists (rule_of v). split; [ apply in_map; exact Hv |]. rewrite P.
    apply in_map_iff. exists ch. split; [| exact Hc ]. cbn [rule_of does puts]. rewrite app_nil_r. subst. reflexivity.
Qed.
Lemma free_none : forall vs v, free vs = true -> In v vs -> rank_of v = None.
Proof.
  unfold free. intros vs v F Hv. rewrite forallb_forall in F. specialize (F v Hv). destruct (rank_of v); [ discriminate | reflexivity ].
Qed.
Lemma free_fire : forall ms vs a ch, free vs = true -> (In (a, ch) (fire ms (map rule_of vs)) <->
  exists v, In v vs /\ a = gives v /\ In ch (combine ms (wants v))).
Proof.
  intros ms vs a ch F. rewrite fire_in. split; [ intros (v & Hv & _ & H); eauto |]. intros (v & Hv & H). exists v.
  split; [ exact Hv |]. split; [| exact H ]. apply not_true_iff_false. intros K. apply prevented_in in K.
  destruct K as (l & _ & _ & K & _). rewrite (free_none vs v F Hv) in K. discriminate.
Qed.
Lemma each_free : forall l, free (each l) = true.
Proof. intros l. apply forallb_forall. intros v H. apply in_map_iff in H. destruct H as (e & E & _). subst. reflexivity. Qed.
Lemma each_fire : forall ms l a ch,
  In (a, ch) (fire [ms] (map rule_of (each l))) <-> In a l /\ In (a, ch) ms.
Proof.
  intros ms l a ch. rewrite free_fire by apply each_free. split.
  - intros (v & Hv & E & Hc). apply in_map_iff in Hv. destruct Hv as (e & Ev & He). subst v. cbn [gives wants] in E, Hc. subst a.
    apply combine_in in Hc. destruct Hc as ([b x] & c & Hm & Em & Hc & Ech). cbn in Hm, Em, Hc. destruct Hc as [Hc | []].
    subst. cbn [snd]. rewrite app_nil_r. auto.
  - intros [Ha Hm]. exists {| gives := a; rank_of := None; wants := [(0%nat, a)] |}.
    split; [ apply in_map_iff; eauto |]. split; [ reflexivity |]. apply combine_in. exists (a, ch), []. cbn.
    rewrite app_nil_r. auto.
Qed.

Lemma relabel_fire : forall ms f vs a ch ps, (forall e, f e <> []) ->
  (In (a, ch) (fire ms (map rule_of (snd (relabel f (ps, vs))))) <->
   exists e, In a (f e) /\ In (e, ch) (fire ms (map rule_of vs))).
Proof.
  intros ms f vs a ch ps NE. cbn [relabel snd].
  assert (M : forall v, In v (flat_map (fun v => map (fun e => {| gives := e; rank_of := rank_of v; wants := wants v |}) (f (gives v))) vs) <->
            exists u e, In u vs /\ In e (f (gives u)) /\ v = {| gives := e; rank_of := rank_of u; wants := wants u |}).
  { intros v. rewrite in_flat_map. split.
    - intros (u & Hu & H). apply in_map_iff in H. destruct H as (e & E & He). exists u, e. auto.
    - intros (u & e & Hu & He & E). exists u. split; [ exact Hu |]. apply in_map_iff. exists e. auto. }
  set (vs' := flat_map _ vs) in *.
  assert (P : forall u e, prevented ms (map rule_of vs') (rule_of {| gives := e; rank_of := rank_of u; wants := wants u |}) =
              prevented ms (map rule_of vs) (rule_of u)).
  { intros u e. apply bool_same. rewrite !prevented_in. cbn [rank_of]. split.
    - intros (l & w & k & E & Hw & K & B & N). apply M in Hw. destruct Hw as (w' & d & Hw & _ & Ew). subst w.
      cbn [rank_of wants] in K, N. exists l, w', k. auto.
    - intros (l & w & k & E & Hw & K & B & N). destruct (f (gives w)) as [| d rest] eqn:Fw; [ destruct (NE _ Fw) |].
      exists l, {| gives := d; rank_of := rank_of w; wants := wants w |}, k. repeat split; auto. apply M. exists w, d.
      rewrite Fw. cbn. auto. }
  rewrite fire_in. split.
  - intros (v & Hv & Q & E & Hc). apply M in Hv. destruct Hv as (u & e & Hu & He & Ev). subst v. cbn [gives wants] in *. subst a.
    exists (gives u). split; [ exact He |]. apply fire_in. exists u. rewrite P in Q. auto.
  - intros (e & He & H). apply fire_in in H. destruct H as (u & Hu & Q & E & Hc). subst e.
    exists {| gives := a; rank_of := rank_of u; wants := wants u |}. rewrite P. cbn [gives wants]. split; [ apply M; eauto | auto ].
Qed.

Definition lower (x y : option int) : bool := match x, y with Some k, Some l => k <? l | _, _ => false end.
Lemma ranked_fire : forall ms f vs a ch ps, free vs = true ->
  (In (a, ch) (fire ms (map rule_of (snd (ranked_by f (ps, vs))))) <->
   In (a, ch) (fire ms (map rule_of vs)) /\
   ~ exists d c, In (d, c) (fire ms (map rule_of vs)) /\ lower (f d) (f a) = true).
Proof.
  intros ms f vs a ch ps F. cbn [ranked_by snd]. set (g := fun v => _).
  assert (P : forall v, prevented ms (map rule_of (map g vs)) (rule_of (g v)) = true <->
            exists d c, In (d, c) (fire ms (map rule_of vs)) /\ lower (f d) (f (gives v)) = true).
  { intros v. rewrite prevented_in. unfold g at 1. cbn [rank_of]. split.
    - intros (l & w & k & E & Hw & K & B & (c & N)). apply in_map_iff in Hw. destruct Hw as (u & Ew & Hu). subst w.
      cbn [g rank_of wants] in K, N. exists (gives u), c. split; [ apply free_fire; eauto |]. rewrite K, E. exact B.
    - intros (d & c & H & L). apply free_fire in H; [| exact F ]. destruct H as (u & Hu & E & N). subst d.
      unfold lower in L. destruct (f (gives u)) as [k |] eqn:K; [| discriminate ].
      destruct (f (gives v)) as [l |] eqn:EL; [| discriminate ]. exists l, (g u), k.
      split; [ reflexivity |]. split; [ apply in_map; exact Hu |]. split; [ exact K |]. split; [ exact L |]. exists c. exact N. }
  rewrite fire_in. split.
  - intros (v & Hv & Q & E & Hc). apply in_map_iff in Hv. destruct Hv as (u & Ev & Hu). subst v. cbn [g gives wants] in E, Hc.
    subst a. split; [ apply free_fire; eauto |]. intros K. apply P in K. congruence.
  - intros [H N]. apply free_fire in H; [| exact F ]. destruct H as (u & Hu & E & Hc). exists (g u).
    split; [ apply in_map; exact Hu |]. split; [| split; [ exact E | exact Hc ] ].
    apply not_true_iff_false. intros K. apply P in K. apply N. subst a. exact K.
Qed.

Lemma combine_left : forall ms ns w, (forall i e, In (i, e) w -> (i < List.length ms)%nat) ->
  combine (ms ++ ns) w = combine ms w.
Proof.
  induction w as [| [i e] w IH]; intros H; [ reflexivity |]. cbn [combine]. rewrite app_nth1 by (apply (H i e); left; reflexivity).
  rewrite IH; [ reflexivity |]. intros j d K. apply (H j d). right. exact K.
Qed.
Lemma combine_right : forall ms ns w, combine (ms ++ ns) (shift (List.length ms) w) = combine ns w.
Proof.
  induction w as [| [i e] w IH]; [ reflexivity |]. cbn [shift map combine fst snd]. fold (shift (List.length ms) w). rewrite IH.
  rewrite app_nth2 by lia. replace (List.length ms + i - List.length ms)%nat with i by lia. reflexivity.
Qed.
Lemma combine_app : forall ms x y ch, In ch (combine ms (x ++ y)) <->
  exists c1 c2, In c1 (combine ms x) /\ In c2 (combine ms y) /\ ch = c1 ++ c2.
Proof.
  induction x as [| [i e] x IH]; intros y ch.
  - cbn. split; [ intros H; exists [], ch; auto |]. intros (c1 & c2 & [E | []] & H & Ec). subst. exact H.
  - cbn [app]. rewrite combine_in. split.
    + intros (m & c & Hm & Em & Hc & E). apply IH in Hc. destruct Hc as (c1 & c2 & H1 & H2 & Ec). exists (snd m ++ c1), c2.
      subst. split; [ apply combine_in; exists m, c1; auto | split; [ exact H2 | apply app_assoc ] ].
    + intros (c1 & c2 & H1 & H2 & E). apply combine_in in H1. destruct H1 as (m & c & Hm & Em & Hc & Ec).
      exists m, (c ++ c2). subst. rewrite app_assoc. repeat split; auto. apply IH. eauto.
Qed.

(* Rules refer only to participants that exist. *)
Definition tidy (c : compiled) : Prop :=
  forall v i e, In v (snd c) -> In (i, e) (wants v) -> (i < List.length (fst c))%nat.
Lemma each_tidy : forall p l, tidy ([p], each l).
Proof.
  intros p l v i e Hv Hi. cbn in Hv. apply in_map_iff in Hv. destruct Hv as (d & E & _). subst. destruct Hi as [E | []].
  inversion E. cbn. lia.
Qed.
Lemma boxed_tidy : forall n c, tidy c -> tidy (boxed n c).
Proof. intros n c T. unfold boxed. destruct (free (snd c)); [ exact T | apply each_tidy ]. Qed.
Lemma boxed_free : forall n c, free (snd (boxed n c)) = true.
Proof. intros n c. unfold boxed. destruct (free (snd c)) eqn:F; [ exact F | apply each_free ]. Qed.
Lemma shift_in : forall n w i e, In (i, e) (shift n w) -> exists j, In (j, e) w /\ i = (n + j)%nat.
Proof. intros n w i e H. apply in_map_iff in H. destruct H as ([j d] & E & H). inversion E. subst. eauto. Qed.
Lemma beside_in : forall n f g h c d v, In v (snd (beside n f g h c d)) <->
  (In v (snd c) /\ f (gives v) = true) \/
  (exists u, In u (snd d) /\ g (gives u) = true /\ v = shifted (List.length (fst c)) u) \/
  (exists u w, In u (snd c) /\ In w (snd d) /\ h (gives u) = true /\ gives w = gives u /\
     v = {| gives := gives u; rank_of := None; wants := wants u ++ shift (List.length (fst c)) (wants w) |}).
Proof.
  intros n f g h c d v. unfold beside. cbn zeta. cbn [snd]. rewrite !in_app_iff, filter_In, in_map_iff, in_flat_map.
  assert (A : (exists u, shifted (List.length (fst c)) u = v /\ In u (filter (fun v => g (gives v)) (snd d))) <->
              exists u, In u (snd d) /\ g (gives u) = true /\ v = shifted (List.length (fst c)) u).
  { split.
    - intros (u & E & H). apply filter_In in H. destruct H. exists u. auto.
    - intros (u & H & K & E). exists u. split; [ auto |]. apply filter_In. auto. }
  rewrite A. clear A. split; (intros [H | [H | H]]; [ auto | auto | right; right ]).
  - destruct H as (u & Hu & H). destruct (h (gives u)) eqn:Hh; [| destruct H ]. rewrite table_spec, Hh in H.
    apply in_map_iff in H. destruct H as (w & E & Hw). apply filter_In in Hw. destruct Hw as [Hw Ew]. apply eqb_true in Ew.
    exists u, w. auto.
  - destruct H as (u & w & Hu & Hw & Hh & Ew & E). exists u. split; [ exact Hu |]. rewrite Hh, table_spec, Hh.
    apply in_map_iff. exists w. split; [ auto |]. apply filter_In. rewrite Ew. split; [ exact Hw | apply eqb_refl ].
Qed.
Lemma beside_tidy : forall n f g h c d, tidy c -> tidy d -> tidy (beside n f g h c d).
Proof.
  intros n f g h c d T U v i e Hv Hi.
  assert (L : List.length (fst (beside n f g h c d)) = (List.length (fst c) + List.length (fst d))%nat) by apply app_length.
  rewrite L. apply beside_in in Hv. destruct Hv as [[Hv _] | [(u & Hu & _ & E) | (u & w & Hu & Hw & _ & _ & E)]].
  - specialize (T v i e Hv Hi). lia.
  - subst v. cbn in Hi. apply shift_in in Hi. destruct Hi as (j & Hj & E). specialize (U u j e Hu Hj). lia.
  - subst v. cbn in Hi. apply in_app_or in Hi. destruct Hi as [Hi | Hi]; [ specialize (T u i e Hu Hi); lia |].
    apply shift_in in Hi. destruct Hi as (j & Hj & E). specialize (U w j e Hw Hj). lia.
Qed.
Lemma beside_free : forall n f g h c d, free (snd c) = true -> free (snd (beside n f g h c d)) = true.
Proof.
  intros n f g h c d F. apply forallb_forall. intros v Hv. apply beside_in in Hv.
  destruct Hv as [[Hv _] | [(u & _ & _ & E) | (u & w & _ & _ & _ & _ & E)]].
  - rewrite (free_none _ v F Hv). reflexivity.
  - subst. reflexivity.
  - subst. reflexivity.
Qed.
Lemma beside_fire : forall ms ns n f g h c d a ch, List.length ms = List.length (fst c) -> tidy c ->
  free (snd c) = true -> free (snd d) = true ->
  (In (a, ch) (fire (ms ++ ns) (map rule_of (snd (beside n f g h c d)))) <->
   (f a = true /\ In (a, ch) (fire ms (map rule_of (snd c)))) \/
   (g a = true /\ In (a, ch) (fire ns (map rule_of (snd d)))) \/
   (h a = true /\ exists x y, In (a, x) (fire ms (map rule_of (snd c))) /\ In (a, y) (fire ns (map rule_of (snd d))) /\ ch = x ++ y)).
Proof.
  intros ms ns n f g h c d a ch L T F G. rewrite free_fire by (apply beside_free; exact F).
  assert (LEFT : forall v, In v (snd c) -> combine (ms ++ ns) (wants v) = combine ms (wants v)).
  { intros v Hv. apply combine_left. intros i e Hi. rewrite L. exact (T v i e Hv Hi). }
  split.
  - intros (v & Hv & E & Hc). apply beside_in in Hv.
    destruct Hv as [[Hv K] | [(u & Hu & K & Ev) | (u & w & Hu & Hw & K & Ew & Ev)]].
    + left. subst a. split; [ exact K |]. rewrite (LEFT v Hv) in Hc. apply free_fire; eauto.
    + right. left. subst v. cbn [shifted gives wants] in E, Hc. subst a. split; [ exact K |].
      rewrite <- L, combine_right in Hc. apply free_fire; eauto.
    + right. right. subst v. cbn [gives wants] in E, Hc. subst a. split; [ exact K |]. apply combine_app in Hc.
      destruct Hc as (x & y & Hx & Hy & Ech). rewrite (LEFT u Hu) in Hx. rewrite <- L, combine_right in Hy. exists x, y.
      split; [ apply free_fire; eauto |]. split; [ apply free_fire; [ exact G |]; exists w; auto | exact Ech ].
  - intros [[K H] | [[K H] | (K & x & y & Hx & Hy & E)]].
    + apply free_fire in H; [| exact F ]. destruct H as (v & Hv & E & Hc). exists v. subst a. split; [ apply beside_in; auto |].
      split; [ reflexivity |]. rewrite (LEFT v Hv). exact Hc.
    + apply free_fire in H; [| exact G ]. destruct H as (v & Hv & E & Hc). exists (shifted (List.length (fst c)) v). subst a.
      split; [ apply beside_in; right; left; exists v; auto |]. split; [ reflexivity |]. cbn [shifted wants].
      rewrite <- L, combine_right. exact Hc.
    + apply free_fire in Hx; [| exact F ]. apply free_fire in Hy; [| exact G ]. destruct Hx as (u & Hu & Eu & Hx).
      destruct Hy as (w & Hw & Ew & Hy).
      exists {| gives := gives u; rank_of := None; wants := wants u ++ shift (List.length (fst c)) (wants w) |}.
      split; [ apply beside_in; right; right; exists u, w; subst a; auto |]. split; [ exact Eu |]. cbn [wants].
      apply combine_app. exists x, y. rewrite (LEFT u Hu), <- L, combine_right. auto.
Qed.

Lemma NoDup_app_l : forall l k : list nat, NoDup (l ++ k) -> NoDup l.
Proof.
  induction l as [| x l IH]; intros k H; [ constructor |]. inversion H. subst. constructor; [| exact (IH k H3) ].
  intros K. apply H2, in_or_app. auto.
Qed.
Lemma NoDup_app_r : forall l k : list nat, NoDup (l ++ k) -> NoDup k.
Proof. induction l as [| x l IH]; intros k H; [ exact H |]. inversion H. auto. Qed.
Lemma NoDup_app_disjoint : forall l k : list nat, NoDup (l ++ k) -> forall j, In j l -> In j k -> False.
Proof.
  induction l as [| x l IH]; intros k H j J K; [ destruct J |]. inversion H. subst. destruct J as [E | J]; [| exact (IH k H3 j J K) ].
  subst. apply H2, in_or_app. auto.
Qed.
Lemma apply_length : forall ch s, List.length (apply s ch) = List.length s.
Proof.
  induction ch as [| [k x] ch IH]; intros s; [ reflexivity |].
  change (List.length (apply (update s k x) ch) = List.length s). rewrite IH. apply update_length.
Qed.

Section Split.
  Variable D : definitions.
  Variable X : split.
  Let events := event_bound X.

  Fixpoint compile (t : tree) : compiled :=
    match t with
    | Leaf k => ([Slot k], each (alphabet X k))
    | Beside only_p only_q both t u =>
        beside events (alone D only_p) (alone D only_q) (together D both) (boxed events (compile t)) (boxed events (compile u))
    | Hidden a t => relabel (fun e => [hidden D a e]) (compile t)
    | Renamed r t => relabel (new_names D r) (compile t)
    | Prioritised o t => ranked_by (rank D o) (boxed events (compile t))
    end.
  Fixpoint term_of (s : list int) (t : tree) : term :=
    match t with
    | Leaf k => meaning X k (nth k s 0)
    | Beside a b c t u => Parallel a b c (term_of s t) (term_of s u)
    | Hidden a t => Hide a (term_of s t)
    | Renamed r t => Rename r (term_of s t)
    | Prioritised o t => Prioritise o (term_of s t)
    end.
  Fixpoint leaves (t : tree) : list nat :=
    match t with
    | Leaf k => [k]
    | Beside _ _ _ t u => leaves t ++ leaves u
    | Hidden _ t | Renamed _ t | Prioritised _ t => leaves t
    end.
  Fixpoint height (t : tree) : nat :=
    match t with
    | Leaf _ => 0
    | Beside _ _ _ t u => S (Nat.max (height t) (height u))
    | Hidden _ t | Renamed _ t | Prioritised _ t => S (height t)
    end.

  Definition row (k : nat) (v : int) : list (ev * int) :=
    match moves_of D (enough X) (meaning X k v) with
    | Some l => map (fun m => (fst m, number_of X k (snd m))) l
    | None => []
    end.

  Definition split_system : system :=
    let rows := map (fun k => table (states X k) (row k)) (seq 0 (slots X)) in
    {| edges := fun k => nth k rows (fun _ => []);
       start := repeat 0 (slots X);
       whole := region_of (compile (whole_tree X)) |}.

  (* The check of a component: the terms of its states perform only known events, and lead to terms of its states. *)
  Definition known (k : nat) (p : term) : bool :=
    let v := number_of X k p in if v <? states X k then eq_term (meaning X k v) p else false.
  Definition component_ok (k : nat) : bool :=
    let listed := fold_left (fun t e => t.[e <- true]) (alphabet X k) (make events false) in
    (0 <? states X k) &&
    all_below (fun v => match moves_of D (enough X) (meaning X k v) with
                        | None => false
                        | Some l => forallb (fun m => if listed.[fst m] then known k (snd m) else false) l
                        end) (states X k).
  Definition split_ok (p : term) : bool :=
    eq_term (term_of (repeat 0 (slots X)) (whole_tree X)) p &&
    forallb (fun k => Nat.ltb k (slots X)) (leaves (whole_tree X)) && no_repetition (leaves (whole_tree X)) &&
    forallb component_ok (seq 0 (slots X)).

  (** The moves of the rules are those of the term. *)
  Let Y := split_system.
  Definition members_moves (s : list int) (p : participant) : list move :=
    match p with Slot k => slot_moves Y k (nth k s 0) | Inner r => moves Y s r end.
  Definition moves_in (s : list int) (c : compiled) : list move :=
    fire (map (members_moves s) (fst c)) (map rule_of (snd c)).
  Lemma moves_in_region : forall s c, moves Y s (region_of c) = moves_in s c.
  Proof. reflexivity. Qed.

  Lemma boxed_moves : forall s n c m, In m (moves_in s (boxed n c)) <-> In m (moves_in s c).
  Proof.
    intros s n c [a ch]. unfold boxed. destruct (free (snd c)); [ reflexivity |]. unfold moves_in at 1. cbn [fst snd map].
    rewrite each_fire. cbn [members_moves]. rewrite moves_in_region. split; [ tauto |]. intros H. split; [| exact H ].
    apply distinct_in. unfold moves_in in H. apply fire_in in H. destruct H as (v & Hv & _ & E & _). subst a.
    apply in_map. exact Hv.
  Qed.
  Lemma compile_tidy : forall t, tidy (compile t).
  Proof.
    induction t as [k | a b c t IHt u IHu | a t IH | r t IH | o t IH]; cbn [compile].
    - apply each_tidy.
    - apply beside_tidy; apply boxed_tidy; assumption.
    - intros v i e Hv Hi. cbn in Hv. apply in_flat_map in Hv. destruct Hv as (u & Hu & [E | []]). subst. exact (IH u i e Hu Hi).
    - intros v i e Hv Hi. cbn in Hv. apply in_flat_map in Hv. destruct Hv as (u & Hu & Hv). apply in_map_iff in Hv.
      destruct Hv as (d & E & _). subst. exact (IH u i e Hu Hi).
    - intros v i e Hv Hi. cbn in Hv. apply in_map_iff in Hv. destruct Hv as (u & E & Hu). subst.
      exact (boxed_tidy events _ IH u i e Hu Hi).
  Qed.

  Lemma apply_other : forall ch s k, (forall c, In c ch -> fst c <> k) -> nth k (apply s ch) 0 = nth k s 0.
  Proof.
    induction ch as [| [j x] ch IH]; intros s k H; [ reflexivity |].
    change (nth k (apply (update s j x) ch) 0 = nth k s 0). rewrite IH by (intros c Hc; apply H; right; exact Hc).
    assert (N : j <> k) by (apply (H (j, x)); left; reflexivity). clear - N. revert j k N.
    induction s as [| v s IH]; intros [| j] [| k] N; cbn; auto; congruence.
  Qed.
  Lemma update_same : forall (s s' : list int) j k x, List.length s = List.length s' -> nth k s 0 = nth k s' 0 ->
    nth k (update s j x) 0 = nth k (update s' j x) 0.
  Proof.
    induction s as [| v s IH]; intros [| w s'] [| j] [| k] x L E; cbn in *; try discriminate; auto.
  Qed.
  Lemma apply_same : forall ch s s' k, List.length s = List.length s' -> nth k s 0 = nth k s' 0 ->
    nth k (apply s ch) 0 = nth k (apply s' ch) 0.
  Proof.
    induction ch as [| [j x] ch IH]; intros s s' k L E; [ exact E |].
    change (nth k (apply (update s j x) ch) 0 = nth k (apply (update s' j x) ch) 0).
    apply IH; [ rewrite !update_length; exact L | apply update_same; assumption ].
  Qed.
  Lemma term_local : forall s s' t, (forall k, In k (leaves t) -> nth k s 0 = nth k s' 0) -> term_of s t = term_of s' t.
  Proof.
    induction t as [k | a b c t IHt u IHu | a t IH | r t IH | o t IH]; intros H; cbn [term_of leaves] in *;
      try (rewrite IH by exact H; reflexivity).
    - rewrite H by (left; reflexivity). reflexivity.
    - rewrite IHt, IHu; [ reflexivity | |]; intros k K; apply H, in_or_app; auto.
  Qed.

  (* States of components are below their numbers. *)
  Definition in_range (s : list int) : Prop :=
    List.length s = slots X /\ forall k, (k < slots X)%nat -> (nth k s 0 <? states X k) = true.
  Definition changes_in (t : tree) (ch : list change) : Prop :=
    forall c, In c ch -> In (fst c) (leaves t) /\ (snd c <? states X (fst c)) = true.
  Definition agrees (s : list int) (t : tree) (l : moves_to) : Prop :=
    (forall m, In m (moves_in s (compile t)) -> changes_in t (snd m)) /\
    forall a w, In (a, w) l <-> exists ch, In (a, ch) (moves_in s (compile t)) /\ w = term_of (apply s ch) t.

  Lemma edges_row : forall k v, (k < slots X)%nat -> edges Y k v = row k v.
  Proof.
    intros k v Hk. unfold Y, split_system. cbn zeta. cbn [edges].
    replace (nth k (map (fun k => table (states X k) (row k)) (seq 0 (slots X))) (fun _ => []))
      with (table (states X k) (row k)); [ apply table_spec |].
    rewrite nth_by_error, nth_error_map.
    replace (nth_error (seq 0 (slots X)) k) with (Some k); [ reflexivity |]. symmetry.
    rewrite (nth_error_nth' _ 0%nat) by (rewrite seq_length; exact Hk). rewrite seq_nth by exact Hk. reflexivity.
  Qed.
  Lemma listed_in : forall l (t : array bool) e, (fold_left (fun t e => t.[e <- true]) l t).[e] = true -> In e l \/ t.[e] = true.
  Proof.
    induction l as [| d l IH]; intros t e H; cbn [fold_left] in H; [ auto |]. apply IH in H. destruct H as [H | H]; [ left; right; exact H |].
    apply get_set in H. destruct H; [ left; left; auto | auto ].
  Qed.
  Lemma component_row : forall k v, component_ok k = true -> (v <? states X k) = true ->
    exists l, moves_of D (enough X) (meaning X k v) = Some l /\
      (forall a w, In (a, w) l -> In a (alphabet X k) /\ (number_of X k w <? states X k) = true /\ meaning X k (number_of X k w) = w).
  Proof.
    intros k v C V. apply andb_true_iff in C. destruct C as [_ C].
    pose proof (all_below_spec _ _ C v V) as R. cbn beta in R.
    destruct (moves_of D (enough X) (meaning X k v)) as [l |]; [| discriminate ]. exists l. split; [ reflexivity |].
    intros a w H. rewrite forallb_forall in R. specialize (R (a, w) H). cbn [fst snd] in R.
    destruct (_.[a]) eqn:A in R; [| discriminate ]. apply listed_in in A. rewrite get_made in A.
    destruct A as [A | A]; [| discriminate ]. split; [ exact A |]. unfold known in R. cbn zeta in R.
    destruct (number_of X k w <? states X k); [| discriminate ]. apply eq_term_ok in R. auto.
  Qed.

  Hypothesis components : forall k, (k < slots X)%nat -> component_ok k = true.

  Lemma leaf_agrees : forall s k, in_range s -> (k < slots X)%nat ->
    exists l, moves_of D (enough X) (term_of s (Leaf k)) = Some l /\ agrees s (Leaf k) l.
  Proof.
    intros s k [L R] Hk. destruct (component_row k _ (components k Hk) (R k Hk)) as (l & E & C).
    exists l. split; [ exact E |].
    assert (M : forall a ch, In (a, ch) (moves_in s (compile (Leaf k))) <->
              exists w, In (a, w) l /\ ch = [(k, number_of X k w)]).
    { intros a ch. unfold moves_in. cbn [compile fst snd map]. rewrite each_fire. cbn [members_moves]. unfold slot_moves.
      rewrite edges_row by exact Hk. unfold row. rewrite E, map_map, in_map_iff. cbn [fst snd]. split.
      - intros [_ ([b w] & E' & H)]. inversion E'. subst. eauto.
      - intros (w & H & Ech). subst. split; [ exact (proj1 (C a w H)) |]. exists (a, w). auto. }
    split.
    - intros [a ch] H. apply M in H. destruct H as (w & H & Ech). subst. cbn [snd]. intros c [Ec | []]. subst. cbn.
      split; [ auto | exact (proj1 (proj2 (C a w H))) ].
    - assert (U : forall x, nth k (apply s [(k, x)]) 0 = x).
      { intros x. cbn. clear - Hk L. rewrite <- L in Hk. clear L. revert k Hk. induction s as [| y s IH]; intros [| k] H; cbn in *; try lia; auto.
        apply IH; lia. }
      intros a w. split.
      + intros H. exists [(k, number_of X k w)]. split; [ apply M; eauto |]. cbn [term_of]. rewrite U. symmetry. apply C with a. exact H.
      + intros (ch & H & Ew). apply M in H. destruct H as (w' & H & Ech). subst ch. cbn [term_of] in Ew. rewrite U in Ew.
        destruct (C a w' H) as (_ & _ & Em). rewrite Em in Ew. subst. exact H.
  Qed.

  Lemma hidden_moves : forall s a t m ch, In (m, ch) (moves_in s (compile (Hidden a t))) <->
    exists e, m = hidden D a e /\ In (e, ch) (moves_in s (compile t)).
  Proof.
    intros. unfold moves_in. cbn [compile]. destruct (compile t) as [ps vs]. rewrite relabel_fire by discriminate.
    cbn [relabel fst snd]. split; intros (e & E & H); exists e; (split; [| exact H ]).
    - destruct E as [E | []]. auto.
    - left. auto.
  Qed.
  Lemma new_names_some : forall r e, new_names D r e <> [].
  Proof. intros r e. unfold new_names. destruct (invisible e); [ discriminate |]. destruct (names D r e); discriminate. Qed.
  Lemma renamed_moves : forall s r t m ch, In (m, ch) (moves_in s (compile (Renamed r t))) <->
    exists e, In m (new_names D r e) /\ In (e, ch) (moves_in s (compile t)).
  Proof.
    intros. unfold moves_in. cbn [compile]. destruct (compile t) as [ps vs]. rewrite relabel_fire by apply new_names_some.
    reflexivity.
  Qed.
  Lemma prioritised_moves : forall s o t m ch, In (m, ch) (moves_in s (compile (Prioritised o t))) <->
    In (m, ch) (moves_in s (compile t)) /\
    ~ exists d c, In (d, c) (moves_in s (compile t)) /\ beats D o d m = true.
  Proof.
    intros s o t m ch. cbn [compile]. rewrite <- (boxed_moves s events (compile t) (m, ch)).
    assert (B : (exists d c, In (d, c) (moves_in s (compile t)) /\ beats D o d m = true) <->
                exists d c, In (d, c) (moves_in s (boxed events (compile t))) /\ lower (rank D o d) (rank D o m) = true).
    { split; intros (d & c & H & K); exists d, c; (split; [ apply (boxed_moves s events (compile t)); exact H | exact K ]). }
    rewrite B. pose proof (boxed_free events (compile t)) as F. unfold moves_in.
    destruct (boxed events (compile t)) as [ps vs]. cbn [fst snd ranked_by] in *.
    exact (ranked_fire (map (members_moves s) ps) (rank D o) vs m ch ps F).
  Qed.
  Lemma beside_moves : forall s a b c t u m ch, In (m, ch) (moves_in s (compile (Beside a b c t u))) <->
    (alone D a m = true /\ In (m, ch) (moves_in s (compile t))) \/
    (alone D b m = true /\ In (m, ch) (moves_in s (compile u))) \/
    (together D c m = true /\ exists x y, In (m, x) (moves_in s (compile t)) /\ In (m, y) (moves_in s (compile u)) /\ ch = x ++ y).
  Proof.
    intros s a b c t u m ch. cbn [compile]. unfold moves_in at 1.
    change (fst (beside events (alone D a) (alone D b) (together D c) (boxed events (compile t)) (boxed events (compile u))))
      with (fst (boxed events (compile t)) ++ fst (boxed events (compile u))). rewrite map_app.
    rewrite beside_fire; try apply boxed_free; [| apply map_length | apply boxed_tidy, compile_tidy ].
    fold (moves_in s (boxed events (compile t))). fold (moves_in s (boxed events (compile u))).
    rewrite !boxed_moves.
    assert (J : (exists x y, In (m, x) (moves_in s (boxed events (compile t))) /\ In (m, y) (moves_in s (boxed events (compile u))) /\ ch = x ++ y) <->
                exists x y, In (m, x) (moves_in s (compile t)) /\ In (m, y) (moves_in s (compile u)) /\ ch = x ++ y).
    { split; intros (x & y & H & K & E); exists x, y; (split; [ apply (boxed_moves s events (compile t)); exact H |]; split; [ apply (boxed_moves s events (compile u)); exact K | exact E ]). }
    rewrite J. reflexivity.
  Qed.
  Lemma filter_map_in : forall (f : ev -> bool) (g : term -> term) (l : moves_to) a w,
    In (a, w) (map (fun m => (fst m, g (snd m))) (filter (fun m => f (fst m)) l)) <->
    exists p, In (a, p) l /\ f a = true /\ w = g p.
  Proof.
    intros f g l a w. rewrite in_map_iff. split.
    - intros ([b p] & E & H). apply filter_In in H. destruct H. cbn [fst snd] in *. inversion E. subst. eauto.
    - intros (p & H & K & E). exists (a, p). subst. split; [ reflexivity |]. apply filter_In. auto.
  Qed.
  Lemma joint_in : forall (f : ev -> bool) (g : term -> term -> term) l k a w,
    In (a, w) (joint f g l k) <-> exists p q, In (a, p) l /\ In (a, q) k /\ f a = true /\ w = g p q.
  Proof.
    intros f g l k a w. unfold joint. rewrite in_flat_map. split.
    - intros ([b p] & H & K). cbn [fst snd] in K. destruct (f b) eqn:F; [| destruct K ]. apply in_map_iff in K.
      destruct K as ([d q] & E & K). apply filter_In in K. destruct K as [K B]. cbn [fst snd] in *. apply eqb_true in B.
      inversion E. subst. eauto 7.
    - intros (p & q & H & K & F & E). exists (a, p). split; [ exact H |]. cbn [fst snd]. rewrite F. apply in_map_iff.
      exists (a, q). subst. split; [ reflexivity |]. apply filter_In. split; [ exact K | apply eqb_refl ].
  Qed.

  Theorem term_agrees : forall s, in_range s -> forall t n, (enough X + height t <= n)%nat ->
    (forall k, In k (leaves t) -> (k < slots X)%nat) -> NoDup (leaves t) ->
    exists l, moves_of D n (term_of s t) = Some l /\ agrees s t l.
  Proof.
    intros s R. induction t as [k | a b c t IHt u IHu | a t IH | r t IH | o t IH]; intros n Hn HK ND.
    - destruct (leaf_agrees s k R (HK k (or_introl eq_refl))) as (l & E & A). exists l. split; [| exact A ].
      apply (moves_of_more _ _ _ _ E). cbn in Hn. lia.
    - cbn [height leaves] in *. destruct n as [| n]; [ lia |].
      destruct (IHt n ltac:(lia) (fun k H => HK k (in_or_app _ _ _ (or_introl H))) (NoDup_app_l _ _ ND)) as (l & El & C1 & A1).
      destruct (IHu n ltac:(lia) (fun k H => HK k (in_or_app _ _ _ (or_intror H))) (NoDup_app_r _ _ ND)) as (k & Ek & C2 & A2).
      cbn [term_of moves_of]. rewrite El, Ek. cbn [on_both]. eexists. split; [ reflexivity |].
      assert (DIS : forall j, In j (leaves t) -> In j (leaves u) -> False) by exact (NoDup_app_disjoint _ _ ND).
      (* Moves of one operand do not change the other. *)
      assert (KT : forall ch, changes_in u ch -> forall s', List.length s' = List.length s -> term_of (apply s' ch) t = term_of s' t).
      { intros ch H s' _. apply term_local. intros j Hj. apply apply_other. intros x Hx E. subst j.
        exact (DIS _ Hj (proj1 (H x Hx))). }
      assert (KU : forall ch, changes_in t ch -> term_of (apply s ch) u = term_of s u).
      { intros ch H. apply term_local. intros j Hj. apply apply_other. intros x Hx E. subst j.
        exact (DIS _ (proj1 (H x Hx)) Hj). }
      assert (KB : forall x y, changes_in t x -> term_of (apply s (x ++ y)) u = term_of (apply s y) u).
      { intros x y H. unfold apply. rewrite fold_left_app. fold (apply s x). fold (apply (apply s x) y). fold (apply s y).
        apply term_local. intros j Hj. apply apply_same; [ apply apply_length |]. apply apply_other. intros z Hz E. subst j.
        exact (DIS _ (proj1 (H z Hz)) Hj). }
      assert (KA : forall x y, changes_in u y -> term_of (apply s (x ++ y)) t = term_of (apply s x) t).
      { intros x y H. unfold apply. rewrite fold_left_app. fold (apply s x). fold (apply (apply s x) y).
        apply KT; [ exact H | apply apply_length ]. }
      split.
      + intros [m ch] H. apply beside_moves in H. cbn [snd].
        assert (L : changes_in t ch -> changes_in (Beside a b c t u) ch).
        { intros G x Hx. destruct (G x Hx). split; [ apply in_or_app; auto | assumption ]. }
        assert (RR : changes_in u ch -> changes_in (Beside a b c t u) ch).
        { intros G x Hx. destruct (G x Hx). split; [ apply in_or_app; auto | assumption ]. }
        destruct H as [[_ H] | [[_ H] | (_ & x & y & H & K & E)]]; [ apply L, (C1 _ H) | apply RR, (C2 _ H) |].
        intros z Hz. subst ch. apply in_app_or in Hz. cbn [leaves].
        destruct Hz as [Hz | Hz]; [ destruct (C1 _ H z Hz) | destruct (C2 _ K z Hz) ]; (split; [ apply in_or_app; auto | assumption ]).
      + intros m w. rewrite !in_app_iff, (filter_map_in (alone D a) (fun p => Parallel a b c p (term_of s u))),
          (filter_map_in (alone D b) (fun q => Parallel a b c (term_of s t) q)), joint_in. split.
        * intros [(p & H & F & E) | [(q & H & F & E) | (p & q & H & K & F & E)]].
          -- apply A1 in H. destruct H as (ch & H & Ep). exists ch. split; [ apply beside_moves; auto |]. subst.
             cbn [term_of]. rewrite (KU ch (C1 _ H)). reflexivity.
          -- apply A2 in H. destruct H as (ch & H & Ep). exists ch. split; [ apply beside_moves; auto |]. subst.
             cbn [term_of]. rewrite (KT ch (C2 _ H) s eq_refl). reflexivity.
          -- apply A1 in H. destruct H as (x & H & Ep). apply A2 in K. destruct K as (y & K & Eq). exists (x ++ y).
             split; [ apply beside_moves; right; right; split; [ exact F | exists x, y; auto ] |]. subst. cbn [term_of].
             rewrite (KA x y (C2 _ K)), (KB x y (C1 _ H)). reflexivity.
        * intros (ch & H & E). apply beside_moves in H. cbn [term_of] in E.
          destruct H as [[F H] | [[F H] | (F & x & y & H & K & Ec)]].
          -- left. exists (term_of (apply s ch) t). rewrite (KU ch (C1 _ H)) in E. split; [ apply A1; eauto | auto ].
          -- right. left. exists (term_of (apply s ch) u). rewrite (KT ch (C2 _ H) s eq_refl) in E. split; [ apply A2; eauto | auto ].
          -- right. right. subst ch. rewrite (KA x y (C2 _ K)), (KB x y (C1 _ H)) in E.
             exists (term_of (apply s x) t), (term_of (apply s y) u). split; [ apply A1; eauto |]. split; [ apply A2; eauto | auto ].
    - cbn [height leaves] in *. destruct n as [| n]; [ lia |]. destruct (IH n ltac:(lia) HK ND) as (l & El & C & A).
      cbn [term_of moves_of]. rewrite El. cbn [on_one]. eexists. split; [ reflexivity |]. split.
      + intros [m ch] H. apply hidden_moves in H. destruct H as (e & _ & H). exact (C (e, ch) H).
      + intros m w. rewrite in_map_iff. split.
        * intros ([e p] & E & H). cbn [fst snd] in E. inversion E. subst. apply A in H. destruct H as (ch & H & Ep). exists ch.
          split; [ apply hidden_moves; eauto |]. cbn [term_of]. subst. reflexivity.
        * intros (ch & H & E). apply hidden_moves in H. destruct H as (e & Em & H). exists (e, term_of (apply s ch) t).
          cbn [fst snd]. subst. split; [ reflexivity | apply A; eauto ].
    - cbn [height leaves] in *. destruct n as [| n]; [ lia |]. destruct (IH n ltac:(lia) HK ND) as (l & El & C & A).
      cbn [term_of moves_of]. rewrite El. cbn [on_one]. eexists. split; [ reflexivity |]. split.
      + intros [m ch] H. apply renamed_moves in H. destruct H as (e & _ & H). exact (C (e, ch) H).
      + intros m w. rewrite in_flat_map. split.
        * intros ([e p] & H & K). apply in_map_iff in K. destruct K as (d & E & K). cbn [fst snd] in E, K. inversion E. subst.
          apply A in H. destruct H as (ch & H & Ep). exists ch. split; [ apply renamed_moves; eauto |]. cbn [term_of]. subst. reflexivity.
        * intros (ch & H & E). apply renamed_moves in H. destruct H as (e & Em & H). exists (e, term_of (apply s ch) t).
          split; [ apply A; eauto |]. apply in_map_iff. exists m. cbn [fst snd]. subst. auto.
    - cbn [height leaves] in *. destruct n as [| n]; [ lia |]. destruct (IH n ltac:(lia) HK ND) as (l & El & C & A).
      cbn [term_of moves_of]. rewrite El. cbn [on_one]. eexists. split; [ reflexivity |]. split.
      + intros [m ch] H. apply prioritised_moves in H. destruct H as [H _]. exact (C (m, ch) H).
      + assert (P : forall m, existsb (fun m' => beats D o (fst m') m) l = true <->
                  exists d c, In (d, c) (moves_in s (compile t)) /\ beats D o d m = true).
        { intros m. rewrite existsb_exists. split.
          - intros ([d p] & H & B). apply A in H. destruct H as (ch & H & _). eauto.
          - intros (d & ch & H & B). exists (d, term_of (apply s ch) t). split; [ apply A; eauto | exact B ]. }
        intros m w. rewrite in_map_iff. split.
        * intros ([e p] & E & H). apply filter_In in H. destruct H as [H B]. cbn [fst snd] in *. inversion E. subst.
          apply negb_true_iff in B. apply A in H. destruct H as (ch & H & Ep). exists ch. cbn [term_of]. subst p.
          split; [| reflexivity ]. apply prioritised_moves. split; [ exact H |]. intros K. apply P in K. congruence.
        * intros (ch & H & E). apply prioritised_moves in H. destruct H as [H N]. exists (m, term_of (apply s ch) t).
          cbn [fst snd]. subst. split; [ reflexivity |]. apply filter_In. split; [ apply A; eauto |]. cbn [fst].
          apply negb_true_iff, not_true_iff_false. intros K. apply N, P. exact K.
  Qed.
End Split.

Lemma update_either : forall (s : list int) j k x,
  nth k (update s j x) 0 = nth k s 0 \/ (k = j /\ nth k (update s j x) 0 = x).
Proof.
  induction s as [| y s IH]; intros [| j] [| k] x; cbn; auto. destruct (IH j k x) as [E | [E F]]; auto.
Qed.

Section Both_ways.
  Variable Z : script.
  Variable X : split.
  Hypothesis ok : split_ok (defines Z) X (main Z) = true.
  Variable bound : nat.
  Hypothesis large : (enough X + height (whole_tree X) <= bound)%nat.
  Let D := defines Z.
  Let Y := split_system D X.
  Let f (s : list int) : term := term_of X s (whole_tree X).

  Lemma split_facts :
    (forall k, (k < slots X)%nat -> component_ok D X k = true) /\
    (forall k, In k (leaves (whole_tree X)) -> (k < slots X)%nat) /\ NoDup (leaves (whole_tree X)) /\ f (start Y) = main Z.
  Proof.
    unfold split_ok in ok. rewrite !andb_true_iff, !forallb_forall in ok. destruct ok as [[[E L] N] C].
    split; [ intros k Hk; apply C, in_seq; lia |]. split; [ intros k Hk; apply Nat.ltb_lt, L, Hk |].
    split; [ exact (no_repetition_ok _ N) | exact (eq_term_ok _ _ E) ].
  Qed.
  Lemma start_in_range : in_range X (start Y).
  Proof.
    destruct split_facts as (C & _). unfold Y, split_system. cbn zeta. cbn [start].
    split; [ apply repeat_length |]. intros k Hk. rewrite nth_repeat.
    specialize (C k Hk). apply andb_true_iff in C. apply C.
  Qed.
  Lemma split_agrees : forall s, in_range X s ->
    exists l, moves_of D bound (f s) = Some l /\ agrees D X s (whole_tree X) l.
  Proof.
    intros s R. destruct split_facts as (C & L & N & _).
    exact (term_agrees D X C s R (whole_tree X) bound large L N).
  Qed.
  Lemma system_step : forall s a u, step (system_lts Y) s a u <->
    exists ch, In (a, ch) (moves_in D X s (compile D X (whole_tree X))) /\ u = apply s ch.
  Proof.
    intros s a u. unfold step. cbn [system_lts succ]. unfold Y, split_system. cbn zeta. cbn [whole].
    rewrite in_map_iff. fold Y. split.
    - intros ([b ch] & E & H). cbn [fst snd] in E. inversion E. subst. exists ch. auto.
    - intros (ch & H & E). subst. exists (a, ch). auto.
  Qed.
  Lemma stays_in_range : forall s a u, in_range X s -> step (system_lts Y) s a u -> in_range X u.
  Proof.
    intros s a u R H. apply system_step in H. destruct H as (ch & H & E). subst u.
    destruct (split_agrees s R) as (l & _ & C & _). specialize (C (a, ch) H). cbn [snd] in C. clear H l.
    revert s R. induction ch as [| [j x] ch IH]; intros s R; [ exact R |].
    change (in_range X (apply (update s j x) ch)). apply IH; [ intros c Hc; apply C; right; exact Hc |].
    destruct R as [L R]. split; [ rewrite update_length; exact L |]. intros k Hk. specialize (R k Hk).
    destruct (C (j, x) (or_introl eq_refl)) as [_ B]. cbn [fst snd] in B.
    destruct (update_either s j k x) as [E | [E F]]; [ rewrite E; exact R | subst; rewrite F; exact B ].
  Qed.
  Lemma split_step : forall s, in_range X s -> forall a w,
    step (term_lts bound Z) (f s) a w <-> exists u, w = f u /\ step (system_lts Y) s a u.
  Proof.
    intros s R a w. destruct (split_agrees s R) as (l & E & _ & A). unfold step at 1. cbn [term_lts succ]. fold D. rewrite E, A.
    split.
    - intros (ch & H & Ew). exists (apply s ch). split; [ exact Ew | apply system_step; eauto ].
    - intros (u & Ew & H). apply system_step in H. destruct H as (ch & H & Eu). subst. eauto.
  Qed.
  Lemma split_init : init (term_lts bound Z) = f (init (system_lts Y)).
  Proof. symmetry. apply split_facts. Qed.

  Lemma split_refines : forall m, refines m (system_lts Y) (term_lts bound Z) /\ refines m (term_lts bound Z) (system_lts Y).
  Proof.
    intros m. split.
    - apply (back_refines (system_lts Y) (term_lts bound Z) f (in_range X) start_in_range stays_in_range split_init split_step). apply refines_refl.
    - apply (morphism_refines (system_lts Y) (term_lts bound Z) f (in_range X) start_in_range stays_in_range split_init split_step). apply refines_refl.
  Qed.
  Lemma split_satisfies : forall p, satisfies p (system_lts Y) -> satisfies p (term_lts bound Z).
  Proof.
    assert (B : forall t w, reach (term_lts bound Z) (init (term_lts bound Z)) t w ->
      exists u, w = f u /\ in_range X u /\ reach (system_lts Y) (init (system_lts Y)) t u).
    { intros t w H. exact (back_reach (system_lts Y) (term_lts bound Z) f (in_range X) stays_in_range split_step _ _ _ H _ split_init start_in_range). }
    assert (HL : deadlock_free (system_lts Y) -> deadlock_free (term_lts bound Z)).
    { intros H t w R. destruct (B t w R) as (u & E & G & R'). destruct (H t u R') as (a & K). exists a. subst w.
      apply (morphism_can (system_lts Y) (term_lts bound Z) f (in_range X) split_step); assumption. }
    assert (HD : divergence_free (system_lts Y) -> divergence_free (term_lts bound Z)).
    { intros H t w R V. destruct (B t w R) as (u & E & G & R'). subst w. apply (H t u R').
      exact (back_diverges (system_lts Y) (term_lts bound Z) f (in_range X) stays_in_range split_step u G V). }
    intros []; cbn; tauto.
  Qed.
  Lemma split_possible : forall G, stays_possible G (system_lts Y) -> stays_possible G (term_lts bound Z).
  Proof.
    exact (back_possible (system_lts Y) (term_lts bound Z) f (in_range X) start_in_range stays_in_range split_init split_step).
  Qed.
End Both_ways.

(* For bounds that are large enough, all claims about the system are true for the term. *)
Definition alike {S S'} (P : lts S) (Q : lts S') : Prop :=
  (forall m, refines m P Q /\ refines m Q P) /\ (forall p, satisfies p P -> satisfies p Q) /\
  (forall G, stays_possible G P -> stays_possible G Q).
Theorem split_alike : forall Z X, split_ok (defines Z) X (main Z) = true ->
  eventually (fun bound => alike (system_lts (split_system (defines Z) X)) (term_lts bound Z)).
Proof.
  intros Z X ok. exists (enough X + height (whole_tree X))%nat. intros bound L.
  exact (conj (split_refines Z X ok bound L) (conj (split_satisfies Z X ok bound L) (split_possible Z X ok bound L))).
Qed.
