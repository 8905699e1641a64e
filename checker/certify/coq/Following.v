(* SPDX-License-Identifier: Apache-2.0 *)
(* Defines the process that a reduced check searches: the targets of transitions are led on by confluent steps, and then
   replaced by their images under automorphisms (docs/search.md, "Confluent taus" and "Symmetry"). Proves that the check
   of this process is enough. *)
From Coq Require Import List Bool Arith ZArith Lia Uint63.
From Certify Require Import Claims Processes Certificate Loops Moves Packing WholeRules Reduction Confluence Symmetry.
Import ListNotations.
Open Scope uint63_scope.

(* Which steps are followed, and by which automorphisms states are replaced. `turns` returns the numbers of the
   automorphisms that lead a packed state to its representative. *)
Record reduction := { confluent : option confluent_steps; symmetric : list automorphism; turns : list int -> list int }.

(* Tables of the transitions of components: by component, by state, by the last bits of the event. *)
Definition last_bits (e : ev) : int := e land 15.
Definition rows_by_event (L : layout) (Y : system) : nat -> ev -> int -> list (ev * int) :=
  let tables := map (fun k => table (size_of L k) (fun v =>
    let l := edges Y k v in
    if (Z.of_nat (List.length l) <? 8)%Z then fun _ => l
    else let t := table 16 (fun b => filter (fun x : ev * int => last_bits (fst x) =? b) l) in fun e => t (last_bits e)))
    (seq 0 (List.length (concat (groups L)))) in
  fun k e v => match nth_error tables k with Some f => f v e | None => edges Y k v end.
Lemma rows_by_event_ok : forall L Y k e v x, In (e, x) (rows_by_event L Y k e v) <-> In (e, x) (edges Y k v).
Proof.
  intros L Y k e v x. unfold rows_by_event. cbn zeta. rewrite nth_error_map.
  destruct (nth_error (seq 0 (List.length (concat (groups L)))) k) as [i |] eqn:E; [| reflexivity ].
  cbn [option_map]. rewrite table_spec. apply nth_error_nth with (d := 0%nat) in E as E'.
  assert (B : (k < List.length (concat (groups L)))%nat)
    by (rewrite <- (seq_length (List.length (concat (groups L))) 0); apply nth_error_Some; congruence).
  rewrite seq_nth in E' by exact B. cbn in E'. subst i.
  destruct (Z.of_nat (List.length (edges Y k v)) <? 8)%Z; [ reflexivity |]. rewrite table_spec, filter_In.
  cbn [fst]. rewrite eqb_refl. intuition auto.
Qed.

Section Following.
  Variable L : layout.
  Variable Y : system.
  Variable R : reduction.
  Variable any : bool.
  Let bits := concat (groups L).
  Let n := List.length (start Y).
  Let rows := rows_by_event L Y.
  Let rows_ok := rows_by_event_ok L Y.

  Definition cube_state (c : cube) (k : nat) : int := match local_in c k with Some v => v | None => 0 end.
  Definition tests_of (c : cube) : list ((list int -> int) * int) := map (fun kv => (read_local L (fst kv), snd kv)) c.
  Definition writes_of (T : nat -> ev -> int -> list (ev * int)) (R : option whole_rule) (c : cube) : list (field * int) :=
    match R with
    | Some R => set_all (field * int) (write_local L) (map (change_of T (cube_state c)) (items R))
    | None => []
    end.
  Definition passes (tests : list ((list int -> int) * int)) (x : list int) : bool := forallb (fun t => fst t x =? snd t) tests.
  Definition follow_on (C : confluent_steps) : list int -> list int :=
    let T := rows_by_event L Y in
    let rule_at := element (rules_of_whole Y) in
    let rows := table (entries C) (fun j => (tests_of (states_of C j), writes_of T (rule_at (follows C j)) (states_of C j))) in
    fun x => fold_left (fun x j =>
      if j <? entries C then
        let row := rows j in if passes (fst row) x then fold_left write_field (snd row) x else x
      else x) (hint C x) x.
  (* Each pull writes to a field what it reads from another. *)
  Definition fields_of_pull (x : nat * pull) : (list int -> int) * (int -> int) * field :=
    (read_local L (source (snd x)), send (snd x), fst (write_local L (fst x) 0)).
  Definition turned (l : list ((list int -> int) * (int -> int) * field)) (x : list int) : list int :=
    fold_left write_field (map (fun p => (snd p, snd (fst p) (fst (fst p) x))) l) x.
  Definition turn_on : list int -> list int :=
    let turn_at := element (map (fun g => map fields_of_pull (pulls g)) (symmetric R)) in
    fun x => fold_left (fun x i => match turn_at i with Some l => turned l x | None => x end) (turns R x) x.
  Definition lead_on : list int -> list int :=
    let turn := turn_on in
    match confluent R with None => turn | Some C => let follow := follow_on C in fun x => turn (follow x) end.
  Definition unreduced : lts (list int) := if any then hidden (packed L Y) else packed L Y.
  Definition reduced : lts (list int) := let f := lead_on in led f unreduced.

  Definition reduction_holds : bool :=
    match confluent R with None => true | Some C => confluent_ok Y C any (rows_by_event L Y) end &&
    match symmetric R with [] => true | l => plain Y && forallb (fun g => automorphism_ok Y (size_of L) g) l end.

  Hypothesis fine : system_ok L Y = true.
  Hypothesis checked : reduction_holds = true.
  Definition packs (s x : list int) : Prop := fits bits s = true /\ x = pack (groups L) s.
  Definition good (x : list int) : Prop := exists s, packs s x.
  Definition goes (x y : list int) : Prop :=
    exists C s t, confluent R = Some C /\ packs s x /\ packs t y /\ followed Y C rows s t.
  Definition event_map (g : automorphism) : ev -> ev := if any then fun e => e else old_event g.
  Definition image (f : ev -> ev) (x y : list int) : Prop :=
    exists g s, In g (symmetric R) /\ f = event_map g /\ packs s x /\ packs (turn g s) y.
  Definition named (f : ev -> ev) : Prop := exists g, In g (symmetric R) /\ f = event_map g.

  Lemma confluent_checked : forall C, confluent R = Some C -> confluent_ok Y C any rows = true.
  Proof.
    intros C E. unfold reduction_holds in checked. apply andb_true_iff in checked. destruct checked as [H _]. rewrite E in H. exact H.
  Qed.
  Lemma symmetric_checked : forall g, In g (symmetric R) -> plain Y = true /\ automorphism_ok Y (size_of L) g = true.
  Proof.
    intros g Hg. unfold reduction_holds in checked. apply andb_true_iff in checked. destruct checked as [_ H].
    destruct (symmetric R) as [| g0 l]; [ destruct Hg |]. apply andb_true_iff in H. destruct H as [P H].
    rewrite forallb_forall in H. split; [ exact P | exact (H g Hg) ].
  Qed.

  Lemma fits_n : forall s, fits bits s = true -> List.length s = n.
  Proof.
    intros s H. destruct (packed_bisimulation L Y fine) as (H1 & _). unfold n.
    rewrite (fits_length _ _ H), (fits_length _ _ H1). reflexivity.
  Qed.
  Lemma unreduced_step : forall x b y, step unreduced x b y <->
    exists a, (if any then b = tau else a = b) /\ step (packed L Y) x a y.
  Proof.
    intros x b y. unfold unreduced. destruct any.
    - rewrite hidden_step. split; [ intros (E & a & H) | intros (a & E & H) ]; eauto.
    - split; [ intros H; exists b; auto | intros (a & E & H); subst; exact H ].
  Qed.
  Lemma packed_step : forall s x a y, packs s x -> (step (packed L Y) x a y <-> exists u, packs u y /\ step (system_lts Y) s a u).
  Proof.
    intros s x a y [F E]. subst x. destruct (packed_bisimulation L Y fine) as (_ & H2 & H3). rewrite (H3 s F a y). split.
    - intros (u & E & St). exists u. split; [ split; [ exact (H2 s a u F St) | exact E ] | exact St ].
    - intros (u & [_ E] & St). eauto.
  Qed.

  Lemma good_start : good (init unreduced).
  Proof.
    destruct (packed_bisimulation L Y fine) as (H1 & _). exists (start Y). split; [ exact H1 |].
    unfold unreduced. destruct any; reflexivity.
  Qed.
  Lemma good_next : forall x b y, good x -> step unreduced x b y -> good y.
  Proof.
    intros x b y (s & G) St. apply unreduced_step in St. destruct St as (a & _ & St).
    apply (packed_step s x a y G) in St. destruct St as (u & U & _). exists u. exact U.
  Qed.
  Lemma goes_tau : forall x y, good x -> goes x y -> step unreduced x tau y.
  Proof.
    intros x y _ (C & s & t & EC & Gs & Gt & F).
    destruct (followed_step Y C any rows rows_ok (confluent_checked C EC) s t F) as (a & A & St).
    apply unreduced_step. exists a. split.
    - destruct any; [ reflexivity |]. destruct A as [A | A]; [ discriminate | exact A ].
    - apply (packed_step s x a y Gs). eauto.
  Qed.
  Lemma goes_confluent : forall x y b z, good x -> goes x y -> step unreduced x b z ->
    (b = tau /\ z = y) \/ exists v, step unreduced y b v /\ goes z v.
  Proof.
    intros x y b z _ (C & s & t & EC & Gs & Gt & F) St. apply unreduced_step in St. destruct St as (a & A & St).
    apply (packed_step s x a z Gs) in St. destruct St as (u & Gu & St).
    destruct (square Y C any rows rows_ok (confluent_checked C EC) s t a u F St) as [[K E] | (v & Sv & Fv)].
    - left. subst u. split.
      + destruct any; [ exact A | destruct K as [K | K]; [ discriminate | congruence ]].
      + destruct Gu as [_ Eu]. destruct Gt as [_ Et]. congruence.
    - right. assert (Sp : exists w, packs v w /\ step (packed L Y) y a w).
      { exists (pack (groups L) v). destruct (packed_bisimulation L Y fine) as (_ & H2 & _).
        assert (Gv : packs v (pack (groups L) v)) by (split; [ exact (H2 t a v (proj1 Gt) Sv) | reflexivity ]).
        split; [ exact Gv |]. apply (packed_step t y a _ Gt). eauto. }
      destruct Sp as (w & Gw & Sw). exists w. split; [ apply unreduced_step; exists a; auto |]. exists C, u, v. auto.
  Qed.

  Lemma cube_changes : forall s c its, in_cube s c -> forallb (sure Y rows c) its = true ->
    map (change_of rows (cube_state c)) its = changes_at rows s its.
  Proof.
    intros s c its G H. rewrite forallb_forall in H. apply map_ext_in. intros it Hit. specialize (H it Hit).
    unfold sure in H. destruct (Nat.ltb _ _); [| discriminate ]. destruct it as [k e | k x]; [| reflexivity ].
    cbn [change_of]. unfold cube_state. destruct (local_in c k) as [v |] eqn:E; [| discriminate ]. rewrite (G k v E). reflexivity.
  Qed.
  Lemma follow_rows : forall C, confluent R = Some C -> forall x, good x -> exists k, row goes image k x (follow_on C x).
  Proof.
    intros C EC x. unfold follow_on. cbn zeta.
    assert (K : forall l x, good x -> exists k, row goes image k x (fold_left (fun x j =>
      if j <? entries C then
        if passes (fst (table (entries C) (fun j => (tests_of (states_of C j), writes_of rows (element (rules_of_whole Y) (follows C j)) (states_of C j))) j)) x
        then fold_left write_field (snd (table (entries C) (fun j => (tests_of (states_of C j), writes_of rows (element (rules_of_whole Y) (follows C j)) (states_of C j))) j)) x else x
      else x) l x)); [| intros G; exact (K (hint C x) x G) ].
    clear x. induction l as [| j l IH]; intros x G; [ exists 0%nat; constructor |]. cbn [fold_left].
    destruct (j <? entries C) eqn:Hj; [| exact (IH x G) ]. rewrite table_spec. cbn [fst snd].
    destruct (passes (tests_of (states_of C j)) x) eqn:PS; [| exact (IH x G) ].
    destruct G as (s & G). destruct (entries_hold Y C any rows (confluent_checked C EC) j Hj) as (W & ER & HE). rewrite ER. cbn [writes_of].
    pose proof fine as FN. unfold system_ok in FN. rewrite !andb_true_iff in FN. destruct FN as [[[[HN _] _] HB] HEB].
    assert (IC : in_cube s (states_of C j)).
    { intros k v E. apply local_in_list in E. unfold passes in PS. rewrite forallb_forall in PS.
      specialize (PS (read_local L k, v) (in_map (fun kv => (read_local L (fst kv), snd kv)) _ _ E)). cbn [fst snd] in PS.
      apply eqb_true in PS. destruct G as [F Ex]. subst x. rewrite (read_packed L HN s F k) in PS. exact PS. }
    pose proof HE as (HR & HA & HP & HS & _). rewrite (cube_changes s _ _ IC HS).
    assert (F : followed Y C rows s (apply s (changes_at rows s (items W)))).
    { split; [ exact (fits_n s (proj1 G)) |]. exists j, W. auto. }
    destruct (followed_step Y C any rows rows_ok (confluent_checked C EC) _ _ F) as (a & _ & St).
    destruct (packed_bisimulation L Y fine) as (_ & H2 & _).
    assert (Gt : packs (apply s (changes_at rows s (items W))) (pack (groups L) (apply s (changes_at rows s (items W)))))
      by (split; [ exact (H2 _ _ _ (proj1 G) St) | reflexivity ]).
    destruct G as [Fs Ex]. subst x.
    rewrite (write_packed L HN (changes_at rows s (items W)) s Fs).
    - destruct (IH _ (ex_intro (fun v => packs v _) _ Gt)) as (k & Q). exists (S k). apply (row_more goes image k _ (pack (groups L) (apply s (changes_at rows s (items W))))).
      + exists C, s, (apply s (changes_at rows s (items W))). split; [ exact EC | split; [ split; [ exact Fs | reflexivity ] | auto ]].
      + exact Q.
    - intros c Hc. apply (moves_bounded L Y HEB s Fs (whole Y) HB (performed W, changes_at rows s (items W)) c); [| exact Hc ].
      apply (whole_moves Y s (whole Y) []). exists W. split; [ exact HR | split; [ reflexivity |]].
      exact (entry_enabled Y C any rows rows_ok s j W IC HE).
  Qed.

  (* Automorphisms. *)
  Lemma sizes_fit : forall s, fits bits s = true -> in_sizes Y (size_of L) s.
  Proof.
    intros s F. pose proof (fits_n s F) as E. split; [ exact E |]. intros k Hk. unfold size_of. fold bits.
    destruct (nth_error bits k) as [b |] eqn:Hb; [ exact (fits_nth bits s k b F Hb) |].
    apply nth_error_None in Hb. rewrite <- (fits_length bits s F) in Hb. unfold n in E. lia.
  Qed.
  Lemma turn_packed : forall g s, In g (symmetric R) -> fits bits s = true ->
    fits bits (turn g s) = true /\ turned (map fields_of_pull (pulls g)) (pack (groups L) s) = pack (groups L) (turn g s).
  Proof.
    intros g s Hg F. destruct (symmetric_checked g Hg) as [P A].
    pose proof fine as FN. unfold system_ok in FN. rewrite !andb_true_iff in FN. destruct FN as [[[[HN _] _] _] _].
    assert (B : forall c, In c (changes_of g s) -> inside_bounds L c = true)
      by (intros c Hc; exact (changes_bounded Y (size_of L) g A s c (sizes_fit s F) Hc)).
    split; [ exact (apply_fits L (changes_of g s) s F B) |].
    unfold turned, turn. rewrite map_map. rewrite <- (write_packed L HN (changes_of g s) s F B). f_equal. unfold set_all, changes_of.
    rewrite map_map. apply map_ext. intros x. unfold fields_of_pull. cbn [fst snd]. rewrite (read_packed L HN s F). reflexivity.
  Qed.
  Lemma image_named : forall f x y, image f x y -> named f.
  Proof. intros f x y (g & s & Hg & Ef & _). exists g. auto. Qed.
  Lemma image_good : forall f x y, good x -> image f x y -> good y.
  Proof. intros f x y _ (g & s & _ & _ & _ & G). exists (turn g s). exact G. Qed.
  Lemma image_step : forall f x y a z, good x -> image f x y -> step unreduced x a z ->
    exists b w, a = f b /\ keeps a b /\ step unreduced y b w /\ image f z w.
  Proof.
    intros f x y a z _ (g & s & Hg & Ef & Gs & Gt) St. apply unreduced_step in St. destruct St as (a0 & A & St).
    apply (packed_step s x a0 z Gs) in St. destruct St as (u & Gu & St). destruct (symmetric_checked g Hg) as [P K].
    destruct (turn_step Y (size_of L) g K P s a0 u (sizes_fit s (proj1 Gs)) St) as (b & Ea & KE & St').
    assert (Gw : packs (turn g u) (pack (groups L) (turn g u))) by (split; [ apply (turn_packed g u Hg (proj1 Gu)) | reflexivity ]).
    assert (Sp : step (packed L Y) y b (pack (groups L) (turn g u))) by (apply (packed_step _ y b _ Gt); exists (turn g u); auto).
    exists (if any then tau else b), (pack (groups L) (turn g u)).
    assert (I : image f z (pack (groups L) (turn g u))) by (exists g, u; auto).
    assert (Un : step unreduced y (if any then tau else b) (pack (groups L) (turn g u)))
      by (apply unreduced_step; exists b; split; [ destruct any; reflexivity | exact Sp ]).
    rewrite Ef in I |- *. unfold event_map in I |- *. destruct any.
    - subst a. split; [ reflexivity | split; [ unfold keeps; tauto | auto ]].
    - subst a0. auto.
  Qed.
  Lemma image_can : forall f x y b, good x -> image f x y -> can unreduced y b -> keeps (f b) b /\ can unreduced x (f b).
  Proof.
    intros f x y b _ (g & s & Hg & Ef & Gs & Gt) (w & St). apply unreduced_step in St. destruct St as (b0 & B & St).
    apply (packed_step _ y b0 w Gt) in St. destruct St as (v & _ & St). destruct (symmetric_checked g Hg) as [P K].
    destruct (turn_can Y (size_of L) g K P s b0 (sizes_fit s (proj1 Gs)) (ex_intro _ v St)) as (KE & u & Su).
    assert (Sp : step (packed L Y) x (old_event g b0) (pack (groups L) u)).
    { apply (packed_step s x _ _ Gs). exists u. split; [| exact Su ]. destruct (packed_bisimulation L Y fine) as (_ & H2 & _).
      split; [ exact (H2 s _ u (proj1 Gs) Su) | reflexivity ]. }
    assert (Un : step unreduced x (if any then tau else old_event g b0) (pack (groups L) u))
      by (apply unreduced_step; exists (old_event g b0); split; [ destruct any; reflexivity | exact Sp ]).
    rewrite Ef. unfold event_map, can. destruct any.
    - subst b. split; [ unfold keeps; tauto | eauto ].
    - subst b0. split; [ exact KE | eauto ].
  Qed.
  Lemma turn_rows : forall x, good x -> row goes image 0 x (turn_on x).
  Proof.
    intros x. unfold turn_on. cbn zeta. generalize (turns R x). intros l. revert x.
    induction l as [| i l IH]; intros x G; [ constructor |]. cbn [fold_left].
    destruct (element _ i) as [p |] eqn:E; [| exact (IH x G) ]. apply element_in, in_map_iff in E. destruct E as (g & E & Hg).
    subst p. destruct G as (s & F & Ex). subst x. destruct (turn_packed g s Hg F) as [F' T]. rewrite T.
    apply (row_image goes image (event_map g) 0 _ (pack (groups L) (turn g s))).
    - exists g, s. split; [ exact Hg | split; [ reflexivity | split; split; auto ]].
    - apply IH. exists (turn g s). split; auto.
  Qed.
  Lemma lead_rows : forall x, good x -> exists k, row goes image k x (lead_on x).
  Proof.
    intros x G. unfold lead_on. cbn zeta. destruct (confluent R) as [C |] eqn:EC; [| exists 0%nat; exact (turn_rows x G) ].
    destruct (follow_rows C EC x G) as (k & W). exists (k + 0)%nat. apply (row_join goes image k x _ W), turn_rows.
    exact (row_good unreduced good good_next goes goes_tau image image_good k x _ W G).
  Qed.

  Theorem reduced_property_unreduced : forall p, satisfies p reduced -> satisfies p unreduced.
  Proof.
    exact (led_property unreduced good good_start good_next named goes goes_tau goes_confluent image image_named image_good
      image_step image_can lead_on lead_rows).
  Qed.

  (* The normal form is indifferent to the events that the automorphism exchanges. *)
  Variable N : normal_form.
  Definition among (A : list ev) (f : ev -> ev) (a : ev) : bool := existsb (fun b => f b =? a) A.
  Definition indifferent_node (g : automorphism) (n : int) : bool :=
    let f := old_event g in
    all_below (fun i => let (b, k) := arc N n i in
                        match after N n (f b) with Some j => j =? k | None => false end) (arc_count N n) &&
    all_below (fun i => let j := instead g n i in
                        if j <? acceptance_count N n then forallb (among (acceptance N n i) f) (acceptance N n j) else false)
      (acceptance_count N n).
  Definition indifferent_to (g : automorphism) : bool := all_below (indifferent_node g) (nodes N).
  Definition indifferent_ok : bool := forallb indifferent_to (symmetric R).
  Lemma indifferent_sound : any = false -> indifferent_ok = true -> forall f, named f ->
    indifferent N (fun n => (n <? nodes N) = true) f.
  Proof.
    intros EA H f (g & Hg & Ef) node Hn. unfold indifferent_ok in H. rewrite forallb_forall in H.
    assert (C := all_below_spec _ _ (H g Hg) node Hn). cbn beta in C. unfold indifferent_node in C. cbn zeta in C.
    apply andb_true_iff in C. destruct C as [C1 C2]. unfold event_map in Ef. rewrite EA in Ef. subst f. split.
    - intros b k Hk. destruct (after_arc N node b k Hk) as (i & Hi & E). assert (K := all_below_spec _ _ C1 i Hi). cbn beta in K.
      rewrite E in K. destruct (after N node (old_event g b)) as [j |]; [| discriminate ]. apply eqb_true in K. subst. reflexivity.
    - intros i Hi. assert (K := all_below_spec _ _ C2 i Hi). cbn beta zeta in K. exists (instead g node i).
      destruct (instead g node i <? acceptance_count N node); [| discriminate ]. split; [ reflexivity |].
      rewrite forallb_forall in K. intros a Ha. specialize (K a Ha). apply existsb_exists in K. destruct K as (b & Hb & E).
      apply eqb_true in E. exists b. auto.
  Qed.
  Theorem reduced_within_unreduced : any = false -> indifferent_ok = true -> (root N <? nodes N) = true ->
    (forall n a k, (n <? nodes N) = true -> after N n a = Some k -> (k <? nodes N) = true) ->
    forall m, within m N reduced -> within m N unreduced.
  Proof.
    intros EA I NR NA. exact (led_within unreduced good good_start good_next named goes goes_tau goes_confluent image image_named
      image_good image_step image_can lead_on lead_rows N (fun n => (n <? nodes N) = true) NR NA (indifferent_sound EA I)).
  Qed.
End Following.

(* If only deadlocks matter, steps with any event may be followed. *)
Definition only_deadlocks (p : property) : bool := match p with Deadlock_free => true | _ => false end.
Theorem reduced_within : forall L Y R N m, system_ok L Y = true -> reduction_holds L Y R false = true ->
  indifferent_ok R N = true -> (root N <? nodes N) = true ->
  (forall n a k, (n <? nodes N) = true -> after N n a = Some k -> (k <? nodes N) = true) ->
  within m N (reduced L Y R false) -> within m N (packed L Y).
Proof. intros L Y R N m H1 H2 I NR NA. exact (reduced_within_unreduced L Y R false H1 H2 N eq_refl I NR NA m). Qed.
Theorem reduced_property : forall L Y R p, system_ok L Y = true -> reduction_holds L Y R (only_deadlocks p) = true ->
  satisfies p (reduced L Y R (only_deadlocks p)) -> satisfies p (packed L Y).
Proof.
  intros L Y R p H1 H2 H. apply (reduced_property_unreduced _ _ _ _ H1 H2) in H.
  destruct p; [ exact (hidden_deadlock_free _ _ H) | exact H | exact H ].
Qed.
