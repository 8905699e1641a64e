(* SPDX-License-Identifier: Apache-2.0 *)
(* Defines what a compiled process is and does: components, and the rules by which their events become events of the
   whole process (checker/machine/supercombinator.hpp). A reader must trust this file. *)
From Coq Require Import List Bool Uint63.
From Certify Require Import Claims.
Import ListNotations.
Open Scope uint63_scope.

(* A rule says: if these participants perform these events, the region performs this event. Then `puts` sets states of
   components. A rule with a level is prevented if a rule of the same region with a smaller level can fire. *)
Record rule := { does : ev; level : option int; asks : list (nat * ev); puts : list (nat * int) }.
Inductive region := Region (inside : list participant) (rules : list rule)
with participant := Slot (k : nat) | Inner (r : region).
(* `edges k v` are the transitions of component k in its state v. A state of the process contains one state for each
   component. *)
Record system := { edges : nat -> int -> list (ev * int); start : list int; whole : region }.

Definition change := (nat * int)%type.
Definition move := (ev * list change)%type.

(* The changes by which the participants perform the wanted events. *)
Fixpoint combine (ms : list (list move)) (wanted : list (nat * ev)) : list (list change) :=
  match wanted with
  | [] => [[]]
  | (i, e) :: rest =>
      flat_map (fun m : move => if fst m =? e then map (app (snd m)) (combine ms rest) else []) (nth i ms [])
  end.
Definition nonempty {A} (l : list A) : bool := match l with [] => false | _ => true end.
Definition before (q : rule) (l : int) : bool := match level q with Some k => k <? l | None => false end.
Definition prevented (ms : list (list move)) (rules : list rule) (r : rule) : bool :=
  match level r with
  | None => false
  | Some l => existsb (fun q => before q l && nonempty (combine ms (asks q))) rules
  end.
Definition fire (ms : list (list move)) (rules : list rule) : list move :=
  flat_map (fun r => if prevented ms rules r then []
                     else map (fun ch => (does r, ch ++ puts r)) (combine ms (asks r))) rules.
Definition slot_moves (Y : system) (k : nat) (v : int) : list move :=
  map (fun e : ev * int => (fst e, [(k, snd e)])) (edges Y k v).
Fixpoint moves (Y : system) (s : list int) (r : region) : list move :=
  match r with
  | Region inside rules =>
      fire (map (fun p => match p with Slot k => slot_moves Y k (nth k s 0) | Inner r' => moves Y s r' end) inside) rules
  end.

Fixpoint update (s : list int) (k : nat) (x : int) : list int :=
  match s, k with
  | [], _ => []
  | _ :: s', O => x :: s'
  | v :: s', S k' => v :: update s' k' x
  end.
Definition apply (s : list int) (ch : list change) : list int :=
  fold_left (fun s (c : change) => update s (fst c) (snd c)) ch s.
Definition system_lts (Y : system) : lts (list int) :=
  {| init := start Y; succ := fun s => map (fun m : move => (fst m, apply s (snd m))) (moves Y s (whole Y)) |}.
