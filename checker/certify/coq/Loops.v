(* SPDX-License-Identifier: Apache-2.0 *)
(* Defines checks of all numbers below a bound, and tables of functions. *)
From Coq Require Import List Bool ZArith Lia Uint63 PArray.
Import ListNotations.
Open Scope uint63_scope.

Arguments to_Z : simpl never.

Lemma eqb_true : forall a b : int, (a =? b) = true -> a = b.
Proof. intros a b. apply eqb_correct. Qed.

Lemma eqb_false_neq : forall a b : int, (a =? b) = false -> a <> b.
Proof. intros a b H E. subst. rewrite eqb_refl in H. discriminate. Qed.

(* Checks all numbers from lo that are below len. It divides the range into halves, so that it needs no unary
   numbers. *)
Fixpoint all_from (widths : list int) (chk : int -> bool) (len lo : int) : bool :=
  if len <=? lo then true
  else match widths with
       | [] => chk lo
       | w :: rest => if all_from rest chk len lo then all_from rest chk len (lo + w) else false
       end.
Definition few_widths : list int := [32; 16; 8; 4; 2; 1].
Definition many_widths : list int := Eval compute in map (fun k => 1 << of_Z (47 - Z.of_nat k)) (seq 0 48).
Definition all_below (chk : int -> bool) (len : int) : bool :=
  if len <? 64 then all_from few_widths chk len 0
  else if len <? (1 << 48) then all_from many_widths chk len 0 else false.

Fixpoint width (ws : list int) : Z := match ws with [] => 1%Z | w :: rest => (to_Z w + width rest)%Z end.
Fixpoint tight (ws : list int) : Prop :=
  match ws with [] => True | w :: rest => (to_Z w <= width rest)%Z /\ tight rest end.

Lemma width_pos : forall ws, (0 < width ws)%Z.
Proof. induction ws as [| w ws IH]; cbn; [ lia |]. pose proof (to_Z_bounded w). lia. Qed.

Lemma all_from_spec : forall ws chk len lo, tight ws -> (to_Z lo + width ws < 2 ^ 60)%Z ->
  all_from ws chk len lo = true ->
  forall i, (to_Z lo <= to_Z i < to_Z lo + width ws)%Z -> (to_Z i < to_Z len)%Z -> chk i = true.
Proof.
  induction ws as [| w ws IH]; intros chk len lo Ht Hb H i Hi Hlen; cbn in H.
  - destruct (len <=? lo) eqn:L; [ apply leb_spec in L; lia |].
    replace i with lo; [ exact H |]. apply to_Z_inj. cbn in Hi. lia.
  - destruct (len <=? lo) eqn:L; [ apply leb_spec in L; lia |].
    destruct (all_from ws chk len lo) eqn:A; [| discriminate].
    cbn in Hb, Hi, Ht. destruct Ht as [Hw Ht].
    pose proof (to_Z_bounded lo). pose proof (to_Z_bounded w). pose proof (width_pos ws).
    assert (E : to_Z (lo + w) = (to_Z lo + to_Z w)%Z).
    { rewrite add_spec. apply Z.mod_small. split; [ lia |].
      unfold wB. change (2 ^ Z.of_nat size)%Z with (2 ^ 63)%Z. assert (2 ^ 60 < 2 ^ 63)%Z by reflexivity. lia. }
    destruct (Z_lt_dec (to_Z i) (to_Z lo + width ws)).
    + apply (IH chk len lo); try assumption; lia.
    + apply (IH chk len (lo + w)); try assumption; try lia; rewrite E; lia.
Qed.

Lemma few_widths_value : width few_widths = 64%Z. Proof. vm_compute. reflexivity. Qed.
Lemma few_widths_tight : tight few_widths.
Proof. unfold few_widths. cbn [tight]. repeat split; vm_compute; discriminate. Qed.
Lemma many_widths_value : width many_widths = (2 ^ 48)%Z. Proof. vm_compute. reflexivity. Qed.
Lemma many_widths_tight : tight many_widths.
Proof. unfold many_widths. cbn [tight]. repeat split; vm_compute; discriminate. Qed.

Lemma all_below_spec : forall chk len, all_below chk len = true -> forall i, (i <? len) = true -> chk i = true.
Proof.
  unfold all_below. intros chk len H i Hi. apply ltb_spec in Hi. pose proof (to_Z_bounded i).
  destruct (len <? 64) eqn:L.
  - apply ltb_spec in L. change (to_Z 64) with 64%Z in L.
    apply (all_from_spec few_widths chk len 0); try assumption; try apply few_widths_tight;
      rewrite ?few_widths_value; change (to_Z 0) with 0%Z; [ reflexivity | lia ].
  - clear L. destruct (len <? (1 << 48)) eqn:L; [| discriminate].
    apply ltb_spec in L. change (to_Z (1 << 48)) with (2 ^ 48)%Z in L.
    apply (all_from_spec many_widths chk len 0); try assumption; try apply many_widths_tight;
      rewrite ?many_widths_value; change (to_Z 0) with 0%Z; [ reflexivity | lia ].
Qed.

(* Stores the values of f for numbers below n in an array. If n is larger than the largest array, there is no table; the
   result is then correct but slow. *)
Fixpoint fill {A} (f : int -> A) (n : nat) (i : int) (t : array A) : array A :=
  match n with O => t | S n' => fill f n' (i + 1) t.[i <- f i] end.
Definition tabulate {A} (n : int) (f : int -> A) : array A :=
  if n <=? max_length then fill f (Z.to_nat (to_Z n)) 0 (make n (f 0)) else make 0 (f 0).
Definition lookup {A} (t : array A) (f : int -> A) (v : int) : A := if v <? length t then t.[v] else f v.
Definition table {A} (n : int) (f : int -> A) : int -> A := let t := tabulate n f in fun v => lookup t f v.

Lemma fill_spec : forall A (f : int -> A) n i t,
  (to_Z i + Z.of_nat n = to_Z (length t))%Z ->
  (forall j, (to_Z j < to_Z i)%Z -> t.[j] = f j) ->
  forall j, (to_Z j < to_Z (length t))%Z -> (fill f n i t).[j] = f j.
Proof.
  intros A f. induction n as [| n IH]; intros i t Hl H j Hj; cbn [fill]; [ apply H; lia |].
  assert (L : length t.[i <- f i] = length t) by apply length_set.
  pose proof (to_Z_bounded (length t)). pose proof (to_Z_bounded i).
  assert (E : to_Z (i + 1) = (to_Z i + 1)%Z).
  { rewrite add_spec. apply Z.mod_small. change (to_Z 1) with 1%Z. lia. }
  apply IH; rewrite ?L; [ rewrite E; lia | | exact Hj ].
  intros k Hk. rewrite E in Hk. destruct (Z.eq_dec (to_Z k) (to_Z i)) as [K | K].
  - apply to_Z_inj in K. subst. apply get_set_same. apply ltb_spec. lia.
  - rewrite get_set_other by congruence. apply H. lia.
Qed.
Lemma fill_length : forall A (f : int -> A) n i t, length (fill f n i t) = length t.
Proof. intros A f. induction n as [| n IH]; intros i t; cbn [fill]; [ reflexivity |]. rewrite IH. apply length_set. Qed.

Lemma table_spec : forall A n (f : int -> A) v, table n f v = f v.
Proof.
  intros A n f v. unfold table, lookup, tabulate. destruct (n <=? max_length) eqn:B.
  - rewrite fill_length, length_make, B. destruct (v <? n) eqn:V; [| reflexivity ]. apply ltb_spec in V.
    pose proof (to_Z_bounded n).
    apply fill_spec; rewrite ?length_make, ?B; [| | exact V ].
    + rewrite Z2Nat.id by lia. change (to_Z 0) with 0%Z. lia.
    + intros j Hj. change (to_Z 0) with 0%Z in Hj. pose proof (to_Z_bounded j). lia.
  - rewrite length_make. change (0 <=? max_length) with true. cbn match.
    destruct (v <? 0) eqn:V; [| reflexivity ]. apply ltb_spec in V. change (to_Z 0) with 0%Z in V.
    pose proof (to_Z_bounded v). lia.
Qed.
