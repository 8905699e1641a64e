(* SPDX-License-Identifier: Apache-2.0 *)
(* Checks runs: that a process has a trace, and that a claim fails. A run shows what a process does. A walk through the
   states of the specification shows that the specification does not do it. *)
From Coq Require Import List Bool ZArith Lia Uint63.
From Certify Require Import Claims Loops Certificate Determinism.
Import ListNotations.
Open Scope uint63_scope.

(** 1. Runs of a process. *)
Section Run.
  Context {S : Type}.
  Variable P : lts S.
  Variable eqs : S -> S -> bool.
  Hypothesis eqs_ok : forall x y, eqs x y = true -> x = y.

  Definition run := list (ev * S).
  Fixpoint is_run (s : S) (r : run) : bool :=
    match r with [] => true | (a, u) :: rest => if steps_to P eqs s a u then is_run u rest else false end.
  Fixpoint run_end (s : S) (r : run) : S := match r with [] => s | (_, u) :: rest => run_end u rest end.
  Fixpoint visible (r : run) : list ev :=
    match r with [] => [] | (a, _) :: rest => if a =? tau then visible rest else a :: visible rest end.
  Lemma run_reaches : forall r s, is_run s r = true -> reach P s (visible r) (run_end s r).
  Proof.
    induction r as [| [a u] r IH]; intros s H; cbn in *; [ constructor |].
    destruct (steps_to P eqs s a u) eqn:St; [| discriminate]. apply (steps_to_step P eqs eqs_ok) in St.
    destruct (a =? tau) eqn:E.
    - apply eqb_true in E. subst. exact (reach_tau P s u _ _ St (IH u H)).
    - apply eqb_false_neq in E. exact (reach_vis P s a u _ _ E St (IH u H)).
  Qed.

  (* A run of taus that ends where it begins. *)
  Definition is_loop (s : S) (r : run) : bool :=
    match r with
    | [] => false
    | _ => if is_run s r then if forallb (fun m => fst m =? tau) r then eqs (run_end s r) s else false else false
    end.
  Lemma loop_goes_on : forall s r, is_loop s r = true -> forall rest u,
    is_run u rest = true -> forallb (fun m => fst m =? tau) rest = true -> run_end u rest = s -> diverges P u.
  Proof.
    intros s r H. destruct r as [| [a w] r]; [ discriminate |]. unfold is_loop in H.
    destruct (is_run s ((a, w) :: r)) eqn:R; [| discriminate]. destruct (forallb _ _) eqn:T; [| discriminate].
    apply eqs_ok in H. cbn [is_run forallb run_end fst] in *. destruct (steps_to P eqs s a w) eqn:St; [| discriminate].
    apply (steps_to_step P eqs eqs_ok) in St. apply andb_true_iff in T. destruct T as [Ta T]. apply eqb_true in Ta. subst a.
    cofix self. intros rest u Ru Tu Eu. destruct rest as [| [b x] rest]; cbn [is_run forallb run_end fst] in *.
    - subst u. exact (diverges_step P s w St (self r w R T H)).
    - destruct (steps_to P eqs u b x) eqn:Sx; [| discriminate]. apply (steps_to_step P eqs eqs_ok) in Sx.
      apply andb_true_iff in Tu. destruct Tu as [Tb Tu]. apply eqb_true in Tb. subst b.
      exact (diverges_step P u x Sx (self rest x Ru Tu Eu)).
  Qed.
  Lemma loop_is_divergence : forall s r, is_loop s r = true -> diverges P s.
  Proof. intros s r H. exact (loop_goes_on s r H [] s eq_refl eq_refl eq_refl). Qed.

  Fixpoint same_events (l k : list ev) : bool :=
    match l, k with [], [] => true | a :: l', b :: k' => if a =? b then same_events l' k' else false | _, _ => false end.
  Lemma same_events_ok : forall l k, same_events l k = true -> l = k.
  Proof.
    induction l as [| a l IH]; intros [| b k] H; cbn in H; try discriminate; [ reflexivity |].
    destruct (a =? b) eqn:E; [| discriminate]. apply eqb_true in E. subst. f_equal. auto.
  Qed.

  (* The process has the trace. *)
  Definition check_trace (t : list ev) (r : run) : bool :=
    if is_run (init P) r then same_events (visible r) t else false.
  Theorem check_trace_sound : forall t r, check_trace t r = true -> traces P t.
  Proof.
    unfold check_trace. intros t r H. destruct (is_run (init P) r) eqn:R; [| discriminate]. apply same_events_ok in H.
    subst. exists (run_end (init P) r). apply run_reaches. exact R.
  Qed.

  (* The moves refuse the event. *)
  Definition refused (moves : run) (a : ev) : bool :=
    if offers moves tick then negb (a =? tick) else negb (offers moves a).
  Definition can_refuse (moves : run) : bool := if offers moves tick then true else negb (offers moves tau).
  Lemma refused_refuses : forall s, can_refuse (succ P s) = true -> refuses P s (fun a => refused (succ P s) a = true).
  Proof.
    unfold can_refuse, refused. intros s H. destruct (offers (succ P s) tick) eqn:O.
    - left. split; [ apply offers_can; exact O | rewrite eqb_refl; discriminate ].
    - right. split; [| split ]; [ intros C; apply offers_can in C; rewrite C in H; discriminate | |].
      + intros C. apply offers_can in C. congruence.
      + intros a N C. apply offers_can in C. rewrite C in N. discriminate.
  Qed.

  (* The run ends in a state from which the loop goes on for ever. *)
  Definition diverging (r loop : run) : bool := if is_run (init P) r then is_loop (run_end (init P) r) loop else false.
  Lemma diverging_diverges : forall r loop, diverging r loop = true -> divergences P (visible r).
  Proof.
    unfold diverging. intros r loop H. destruct (is_run (init P) r) eqn:R; [| discriminate].
    exists (visible r), [], (run_end (init P) r). rewrite app_nil_r.
    split; [ reflexivity | split; [ exact (run_reaches _ _ R) | exact (loop_is_divergence _ _ H) ]].
  Qed.
End Run.

(** 2. A walk through the states of the specification after the prefixes of a trace. The node of a state is the number
    of events before it. *)
Inductive fault := Performs | Refuses (moves : ev -> bool) | Diverges_after.
Section Absence.
  Context {S : Type}.
  Variable spec : lts S.
  Variable eqs : S -> S -> bool.
  Hypothesis eqs_ok : forall x y, eqs x y = true -> x = y.
  Variable m : model.
  Variable t : list ev.
  Variable x : fault.  (* what the specification must not do after the trace, where X is the set that it refuses *)
  Variable P : pairs S.

  Definition plain_event_at (n : int) : option ev := nth_error t (Z.to_nat (to_Z n)).
  Definition event_at : int -> option ev := table (of_Z (Z.of_nat (length t))) plain_event_at.
  Definition performs : bool := match x with Performs => true | _ => false end.
  Definition absence_needs (next : int -> option ev) (n : int) (a : ev) : need :=
    if a =? tau then Leads n (match m with FD => true | _ => false end)
    else match next n with
         | Some b =>
             if a =? b then
               if n <? n + 1 then
                 if (if performs then match next (n + 1) with None => true | _ => false end else false) then Forbidden
                 else Leads (n + 1) false
               else Forbidden
             else Irrelevant
         | None => Irrelevant
         end.
  Definition absence_fine (next : int -> option ev) (n : int) (moves : list (ev * S)) : bool :=
    match x with
    | Refuses X =>
        match next n with
        | Some _ => true
        | None =>
            if offers moves tick then X tick
            else if offers moves tau then true else existsb (fun mv => X (fst mv)) moves
        end
    | _ => true
    end.
  Definition check_absence : bool :=
    let next := event_at in
    if (if performs then match next 0 with None => true | _ => false end else false) then false
    else walk spec eqs P (absence_needs next) (absence_fine next) 0.

  Hypothesis checked : check_absence = true.

  Definition covering_prefixes (Q : S -> int -> int -> Prop) : Prop :=
    (exists r, Q (init spec) 0 r) /\
    forall s n r, Q s n r -> absence_fine event_at n (succ spec s) = true /\
      forall a u, step spec s a u ->
        match absence_needs event_at n a with
        | Forbidden => False
        | Irrelevant => True
        | Leads k earlier => exists q, Q u k q /\ (earlier = true -> (q <? r) = true)
        end.
  Lemma event_at_plain : forall n, event_at n = plain_event_at n.
  Proof. intros n. apply table_spec. Qed.
  Lemma absence_covers : (performs = true -> t <> []) /\ exists Q, covering_prefixes Q.
  Proof.
    unfold check_absence in checked. cbn zeta in checked.
    destruct (if performs then match event_at 0 with None => true | _ => false end else false) eqn:E; [ discriminate |].
    split; [| exact (walk_sound spec eqs eqs_ok P _ _ 0 checked) ].
    intros K. rewrite K, event_at_plain in E. intros E0. unfold plain_event_at in E. rewrite E0 in E. discriminate.
  Qed.

  Variable Q : S -> int -> int -> Prop.
  Hypothesis covers : covering_prefixes Q.

  (* The state is a pair, after `done` of the trace, with `rest` still to come. *)
  Definition within (s : S) (rest : list ev) : Prop :=
    exists n r, Q s n r /\ skipn (Z.to_nat (to_Z n)) t = rest /\ (performs = true -> rest <> []).

  Lemma nth_error_skipn : forall (l : list ev) k, nth_error l k = match skipn k l with a :: _ => Some a | [] => None end.
  Proof. induction l as [| a l IH]; intros [| k]; cbn; auto. Qed.
  Lemma skipn_next : forall (l : list ev) k a rest, skipn k l = a :: rest -> skipn (Datatypes.S k) l = rest.
  Proof.
    induction l as [| b l IH]; intros [| k] a rest H; cbn in *; try discriminate; [ inversion H; reflexivity |].
    destruct l as [| c l]; [ destruct k; discriminate H |]. exact (IH k a rest H).
  Qed.
  Lemma next_number : forall n, (n <? n + 1) = true -> to_Z (n + 1) = (to_Z n + 1)%Z.
  Proof.
    intros n O. apply ltb_spec in O. rewrite add_spec in *. change (to_Z 1) with 1%Z in *. pose proof (to_Z_bounded n).
    destruct (Z_lt_dec (to_Z n + 1) wB); [ apply Z.mod_small; lia |].
    exfalso. replace (to_Z n + 1)%Z with wB in O by lia. rewrite Z_mod_same_full in O. lia.
  Qed.

  Lemma within_reach : forall s w u, reach spec s w u -> forall rest, within s (w ++ rest) ->
    (performs = true -> rest = [] -> w <> [] -> False) /\
    ((performs = true -> rest <> []) -> within u rest).
  Proof.
    induction 1 as [s | s u w v St R IH | s a u w v Ha St R IH]; intros rest W; cbn [app] in W.
    - split; [ intros _ _ K; apply K; reflexivity | intros _; exact W ].
    - apply IH. destruct W as (n & r & Hq & E & N). destruct covers as [_ C]. destruct (C s n r Hq) as [_ M].
      specialize (M tau u St). unfold absence_needs in M. cbn in M. destruct M as (q & Hu & _). exists n, q. auto.
    - destruct W as (n & r & Hq & E & N). destruct covers as [_ C]. destruct (C s n r Hq) as [_ M]. specialize (M a u St).
      unfold absence_needs in M. assert (Ea : (a =? tau) = false).
      { destruct (a =? tau) eqn:X; [ apply eqb_true in X; congruence | reflexivity ]. }
      rewrite Ea in M. rewrite !event_at_plain in M. unfold plain_event_at in M. rewrite nth_error_skipn, E in M.
      rewrite eqb_refl in M. destruct (n <? n + 1) eqn:O; [| destruct M ]. apply next_number in O.
      assert (K : skipn (Z.to_nat (to_Z (n + 1))) t = w ++ rest).
      { rewrite O. pose proof (to_Z_bounded n). replace (Z.to_nat (to_Z n + 1)) with (Datatypes.S (Z.to_nat (to_Z n))) by lia.
        exact (skipn_next _ _ _ _ E). }
      rewrite nth_error_skipn, K in M. destruct (w ++ rest) as [| b l] eqn:L.
      + destruct performs eqn:PF; [ destruct M |]. apply app_eq_nil in L. destruct L as [L1 L2]. subst.
        destruct M as (q & Hu & _). assert (W : within u ([] ++ [])) by (exists (n + 1), q; split; [ exact Hu | split; [ exact K | congruence ]]).
        split; [ congruence |]. intros _. apply (IH [] W). congruence.
      + assert (M' : exists q, Q u (n + 1) q) by (destruct performs; destruct M as (q & Hu & _); eauto).
        destruct M' as (q & Hu). assert (W : within u (w ++ rest)).
        { exists (n + 1), q. split; [ exact Hu | rewrite L; split; [ exact K | discriminate ]]. }
        destruct (IH rest W) as [I1 I2]. split; [| exact I2 ]. intros PF ER _. apply (I1 PF ER). intros E0. subst. discriminate L.
  Qed.
  Lemma within_init : (performs = true -> t <> []) -> within (init spec) t.
  Proof. intros N. destruct covers as [(r & H) _]. exists 0, r. split; [ exact H | split; [ reflexivity | exact N ]]. Qed.

  Lemma prefix_no_divergence : m = FD -> forall z s n r, (Z.to_nat (to_Z r) < z)%nat -> Q s n r -> ~ diverges spec s.
  Proof.
    intros Em. induction z as [| z IH]; intros s n r Hz Hq D; [ lia |].
    destruct D as [s u St D]. destruct covers as [_ C]. destruct (C s n r Hq) as [_ M].
    specialize (M tau u St). unfold absence_needs in M. rewrite Em in M. cbn in M. destruct M as (q & Hu & L).
    specialize (L eq_refl). apply ltb_spec in L. pose proof (to_Z_bounded q). apply (IH u n q); auto. lia.
  Qed.
End Absence.

(** 3. What the specification does not do. *)
Section Absent.
  Context {S : Type}.
  Variable spec : lts S.
  Variable eqs : S -> S -> bool.
  Hypothesis eqs_ok : forall x y, eqs x y = true -> x = y.

  Lemma absent_trace : forall m t P, check_absence spec eqs m t Performs P = true -> ~ traces spec t.
  Proof.
    intros m t P H (u & R). destruct (absence_covers spec eqs eqs_ok m t Performs P H) as [N (Q & C)]. specialize (N eq_refl).
    rewrite <- (app_nil_r t) in R. destruct (within_reach spec m t Performs Q C _ _ _ R []) as [K _].
    - rewrite !app_nil_r. exact (within_init spec m t Performs Q C (fun _ => N)).
    - apply K; [ reflexivity | reflexivity | rewrite app_nil_r; exact N ].
  Qed.
  Lemma absent_failure : forall m t X P, check_absence spec eqs m t (Refuses X) P = true ->
    ~ failures spec t (fun a => X a = true).
  Proof.
    intros m t X P H (u & R & F). destruct (absence_covers spec eqs eqs_ok m t (Refuses X) P H) as [_ (Q & C)].
    destruct (within_reach spec m t (Refuses X) Q C _ _ _ R []) as [_ K].
    { rewrite app_nil_r. exact (within_init spec m t (Refuses X) Q C ltac:(discriminate)). }
    destruct (K ltac:(discriminate)) as (n & r & Hq & E & _). destruct C as [_ C]. destruct (C u n r Hq) as [A _].
    unfold absence_fine in A. rewrite event_at_plain in A. unfold plain_event_at in A.
    rewrite nth_error_skipn, E in A. destruct (offers (succ spec u) tick) eqn:Ot.
    - destruct F as [[_ F] | (_ & F & _)]; [ exact (F A) | apply F, offers_can, Ot ].
    - destruct F as [[F _] | (F1 & _ & F3)]; [ apply offers_can in F; congruence |].
      destruct (offers (succ spec u) tau) eqn:Ou; [ apply F1, offers_can, Ou |].
      apply existsb_exists in A. destruct A as ([a w] & I & Xa). apply (F3 a Xa). exists w. exact I.
  Qed.
  Lemma absent_divergence : forall t x P, check_absence spec eqs FD t x P = true -> ~ divergences spec t.
  Proof.
    intros t x P H (t1 & t2 & u & E & R & D). destruct (absence_covers spec eqs eqs_ok FD t x P H) as [N (Q & C)].
    destruct (within_reach spec FD t x Q C _ _ _ R t2) as [K1 K2].
    { rewrite <- E. exact (within_init spec FD t x Q C N). }
    assert (W : within t x Q u t2).
    { apply K2. intros PF T2. subst t2. rewrite app_nil_r in E. subst t1. exact (K1 PF eq_refl (N PF)). }
    destruct W as (n & r & Hq & _).
    exact (prefix_no_divergence spec FD t x Q C eq_refl (Datatypes.S (Z.to_nat (to_Z r))) u n r ltac:(lia) Hq D).
  Qed.
End Absent.

(** 4. A refinement fails: a run of the implementation, and the absence of what it shows. *)
Inductive refutation (S : Type) :=
  By_event (r : list (ev * S)) | By_refusal (r : list (ev * S)) | By_divergence (r loop : list (ev * S)).
Arguments By_event {S}. Arguments By_refusal {S}. Arguments By_divergence {S}.
Section Fails.
  Context {A B : Type}.
  Variable spec : lts A.
  Variable impl : lts B.
  Variable eqs : A -> A -> bool.
  Hypothesis eqs_ok : forall x y, eqs x y = true -> x = y.
  Variable eqi : B -> B -> bool.
  Hypothesis eqi_ok : forall x y, eqi x y = true -> x = y.

  Definition check_refutation (m : model) (v : refutation B) (P : pairs A) : bool :=
    match v with
    | By_event r => if is_run impl eqi (init impl) r then check_absence spec eqs m (visible r) Performs P else false
    | By_refusal r =>
        match m with
        | T => false
        | _ =>
            if is_run impl eqi (init impl) r then
              let moves := succ impl (run_end (init impl) r) in
              if can_refuse moves then check_absence spec eqs m (visible r) (Refuses (refused moves)) P else false
            else false
        end
    | By_divergence r loop =>
        match m with
        | FD => if diverging impl eqi r loop then check_absence spec eqs FD (visible r) Diverges_after P else false
        | _ => false
        end
    end.
  Theorem check_refutation_sound : forall m v P, check_refutation m v P = true -> ~ refines m spec impl.
  Proof.
    intros m [r | r | r loop] P H K; cbn [check_refutation] in H.
    - destruct (is_run impl eqi (init impl) r) eqn:R; [| discriminate]. apply (run_reaches impl eqi eqi_ok) in R.
      assert (NT := absent_trace spec eqs eqs_ok _ _ _ H). destruct m; cbn in K.
      + apply NT, K. eexists. exact R.
      + apply NT, K. eexists. exact R.
      + destruct K as [KD KF]. assert (ND := absent_divergence spec eqs eqs_ok _ _ _ H).
        apply (settles impl _ _ R).
        * intros D. apply ND, KD. exists (visible r), [], (run_end (init impl) r). rewrite app_nil_r. auto.
        * intros F. destruct (KF _ _ (or_introl F)) as [(u & Ru & _) | D]; [| exact (ND D) ]. apply NT. exists u. exact Ru.
    - assert (Hm : m <> T) by (intros E; subst; discriminate).
      assert (H' : (if is_run impl eqi (init impl) r then
              let moves := succ impl (run_end (init impl) r) in
              if can_refuse moves then check_absence spec eqs m (visible r) (Refuses (refused moves)) P else false
            else false) = true) by (destruct m; [ congruence | exact H | exact H ]).
      clear H. destruct (is_run impl eqi (init impl) r) eqn:R; [| discriminate]. cbn zeta in H'.
      destruct (can_refuse _) eqn:C; [| discriminate]. apply (run_reaches impl eqi eqi_ok) in R.
      assert (F : failures impl (visible r) (fun a => refused (succ impl (run_end (init impl) r)) a = true)).
      { exists (run_end (init impl) r). split; [ exact R | apply refused_refuses; exact C ]. }
      assert (NF := absent_failure spec eqs eqs_ok _ _ _ _ H'). destruct m; cbn in K; [ congruence | |].
      + apply NF, K, F.
      + destruct K as [KD KF]. destruct (KF _ _ (or_introl F)) as [G | D]; [ exact (NF G) |].
        exact (absent_divergence spec eqs eqs_ok _ _ _ H' D).
    - destruct m; try discriminate. destruct (diverging impl eqi r loop) eqn:D; [| discriminate].
      apply (diverging_diverges impl eqi eqi_ok) in D. exact (absent_divergence spec eqs eqs_ok _ _ _ H (proj1 K _ D)).
  Qed.
End Fails.
