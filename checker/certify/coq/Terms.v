(* SPDX-License-Identifier: Apache-2.0 *)
(* Defines what a process term does: the firing rules of CSP's operators (Roscoe, "Understanding Concurrent Systems",
   chapter 9 and sections 7.2 and 20.2; the manual of FDR 4.2). At the term level, a reader must trust this file and
   Claims.v; Processes.v need not be trusted. *)
From Coq Require Import List Bool Uint63.
From Certify Require Import Claims.
Import ListNotations.
Open Scope uint63_scope.

(* The numbers of sets, renamings, orders and definitions refer to the tables below. Some operators of CSP are cases of
   these. STOP is an offer without branches, SKIP is an offer of tick and then STOP, and P |~| Q is an offer of two taus.
   P [] Q and P /\ Q have an empty set. P [|A|] Q is a parallel whose operands perform alone what is outside A, and
   together what is in A. In P [A||B] Q, they perform alone what is in A \ B or in B \ A, and together what is in both. *)
Inductive term :=
| Offer (branches : list (ev * term))                 (* each branch is an event and what follows it *)
| Call (name : int)                                   (* a definition *)
| Choice (a : int) (p q : term)                       (* P [+ A +] Q: external choice, with joint events in A *)
| Sliding (p q : term)                                (* P [> Q *)
| Sequence (p q : term)                               (* P ; Q *)
| Interrupt (a : int) (p q : term)                    (* P /+ A +\ Q: interrupt, with joint events in A *)
| Throw (a : int) (p q : term)                        (* P [| A |> Q *)
| Parallel (only_p only_q both : int) (p q : term)       (* events of P alone, of Q alone, of both *)
| Hide (a : int) (p : term)                           (* P \ A *)
| Rename (r : int) (p : term)                         (* P[[R]] *)
| Prioritise (o : int) (p : term).                    (* prioritise(P, O) *)

(* `names r e` are the new names of an event; an event without new names keeps its name. `priority o e` is the level of
   an event, and 0 is the highest level. An event without a level prevents no event, and no event prevents it. *)
Record definitions := {
  body : int -> term;
  has : int -> ev -> bool;
  names : int -> ev -> list ev;
  priority : int -> ev -> option int }.

Definition moves_to := list (ev * term).
Definition invisible (e : ev) : bool := (e =? tau) || (e =? tick).

Section Rules.
  Variable D : definitions.

  (* No set contains tau or tick, no renaming changes them, and in every order they have the highest level. *)
  Definition within (a : int) (e : ev) : bool := if invisible e then false else has D a e.
  Definition new_names (r : int) (e : ev) : list ev :=
    if invisible e then [e] else match names D r e with [] => [e] | l => l end.
  Definition hidden (a : int) (e : ev) : ev := if within a e then tau else e.
  Definition rank (o : int) (e : ev) : option int := if invisible e then Some 0 else priority D o e.
  Definition beats (o : int) (d e : ev) : bool :=
    match rank o d, rank o e with Some k, Some l => k <? l | _, _ => false end.
  Definition alone (a : int) (e : ev) : bool := (e =? tau) || within a e.
  Definition together (a : int) (e : ev) : bool := (e =? tick) || within a e.

  (* Each move with an event that is chosen by `on` changes an operand; another move discards the operator. *)
  Definition keep (on : ev -> bool) (f : term -> term) (l : moves_to) : moves_to :=
    map (fun m => (fst m, if on (fst m) then f (snd m) else snd m)) l.
  Definition outside (a : int) (l : moves_to) : moves_to := filter (fun m => negb (within a (fst m))) l.
  (* The moves in which both operands perform an event that is chosen by `on`. *)
  Definition joint (on : ev -> bool) (f : term -> term -> term) (l k : moves_to) : moves_to :=
    flat_map (fun m => if on (fst m) then
                         map (fun m' => (fst m, f (snd m) (snd m'))) (filter (fun m' => fst m' =? fst m) k)
                       else []) l.

  Definition on_one (l : option moves_to) (f : moves_to -> moves_to) : option moves_to :=
    match l with Some l => Some (f l) | None => None end.
  Definition on_both (l k : option moves_to) (f : moves_to -> moves_to -> moves_to) : option moves_to :=
    match l, k with Some l, Some k => Some (f l k) | _, _ => None end.

  (* The moves of a term. The bound limits the depth of the term with its unfolded calls. There is no result if it is
     too small. A call unfolds without a tau. FDR's rule for termination holds: if a term performs tick, then it performs
     nothing after it. Both operands of a parallel terminate together. *)
  Fixpoint moves_of (bound : nat) (p : term) : option moves_to :=
    match bound with
    | O => None
    | S n =>
        let go := moves_of n in
        match p with
        | Offer branches => Some branches
        | Call k => go (body D k)
        | Choice a p q => on_both (go p) (go q) (fun l k =>
            keep (fun e => e =? tau) (fun u => Choice a u q) (outside a l) ++
            keep (fun e => e =? tau) (fun u => Choice a p u) (outside a k) ++ joint (within a) (Choice a) l k)
        | Sliding p q => on_one (go p) (fun l => keep (fun e => e =? tau) (fun u => Sliding u q) l ++ [(tau, q)])
        | Sequence p q => on_one (go p) (map (fun m =>
            if fst m =? tick then (tau, q) else (fst m, Sequence (snd m) q)))
        | Interrupt a p q => on_both (go p) (go q) (fun l k =>
            keep (fun e => negb (e =? tick)) (fun u => Interrupt a u q) (outside a l) ++
            keep (fun e => e =? tau) (fun u => Interrupt a p u) (outside a k) ++ joint (within a) (Interrupt a) l k)
        | Throw a p q => on_one (go p) (map (fun m =>
            (fst m, if within a (fst m) then q else if fst m =? tick then snd m else Throw a (snd m) q)))
        | Parallel only_p only_q both p q => on_both (go p) (go q) (fun l k =>
            map (fun m => (fst m, Parallel only_p only_q both (snd m) q)) (filter (fun m => alone only_p (fst m)) l) ++
            map (fun m => (fst m, Parallel only_p only_q both p (snd m))) (filter (fun m => alone only_q (fst m)) k) ++
            joint (together both) (Parallel only_p only_q both) l k)
        | Hide a p => on_one (go p) (map (fun m => (hidden a (fst m), Hide a (snd m))))
        | Rename r p => on_one (go p)
            (flat_map (fun m => map (fun e => (e, Rename r (snd m))) (new_names r (fst m))))
        | Prioritise o p => on_one (go p) (fun l => map (fun m => (fst m, Prioritise o (snd m)))
            (filter (fun m => negb (existsb (fun m' => beats o (fst m') (fst m)) l)) l))
        end
    end.
End Rules.

(* A script is a term with its definitions. *)
Record script := { defines : definitions; main : term }.
Definition term_lts (bound : nat) (Z : script) : lts term :=
  {| init := main Z; succ := fun p => match moves_of (defines Z) bound p with Some l => l | None => [] end |}.

(* A claim about scripts is true if it holds for every bound that is large enough. *)
Definition eventually (claim : nat -> Prop) : Prop := exists enough, forall bound, (enough <= bound)%nat -> claim bound.
