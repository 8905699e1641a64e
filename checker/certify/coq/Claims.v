(* SPDX-License-Identifier: Apache-2.0 *)
(* Defines what a certificate claims: transition systems, and refinement in the models T, F and FD of CSP (Roscoe,
   "Understanding Concurrent Systems", chapters 10 to 12). A reader must trust this file, Processes.v and the statements
   of the theorems in Program.v. Everything else is proved. *)
From Coq Require Import List Uint63.
Import ListNotations.
Open Scope uint63_scope.

(* Events are numbers. The certifier gives equal numbers to equal names, in both systems. *)
Definition ev := int.
Definition tau : ev := 0.
Definition tick : ev := 1.

Record lts (S : Type) := { init : S; succ : S -> list (ev * S) }.
Arguments init {S}.
Arguments succ {S}.

Definition step {S} (P : lts S) (s : S) (a : ev) (u : S) : Prop := In (a, u) (succ P s).

(* There is a run from s to u whose visible events are t. *)
Inductive reach {S} (P : lts S) : S -> list ev -> S -> Prop :=
| reach_nil : forall s, reach P s [] s
| reach_tau : forall s u t v, step P s tau u -> reach P u t v -> reach P s t v
| reach_vis : forall s a u t v, a <> tau -> step P s a u -> reach P u t v -> reach P s (a :: t) v.

(* There is an infinite run of taus from s. *)
CoInductive diverges {S} (P : lts S) : S -> Prop :=
| diverges_step : forall s u, step P s tau u -> diverges P u -> diverges P s.

Definition can {S} (P : lts S) (s : S) (a : ev) : Prop := exists u, step P s a u.

(* As in FDR, a state that can terminate can refuse everything else. Another state refuses X if it is stable and can
   perform no event of X. *)
Definition refuses {S} (P : lts S) (s : S) (X : ev -> Prop) : Prop :=
  (can P s tick /\ ~ X tick) \/ (~ can P s tau /\ ~ can P s tick /\ forall a, X a -> ~ can P s a).

Definition traces {S} (P : lts S) (t : list ev) : Prop := exists s, reach P (init P) t s.
Definition failures {S} (P : lts S) (t : list ev) (X : ev -> Prop) : Prop :=
  exists s, reach P (init P) t s /\ refuses P s X.
Definition divergences {S} (P : lts S) (t : list ev) : Prop :=
  exists t1 t2 s, t = t1 ++ t2 /\ reach P (init P) t1 s /\ diverges P s.
Definition failures_bot {S} (P : lts S) (t : list ev) (X : ev -> Prop) : Prop := failures P t X \/ divergences P t.

Inductive model := T | F | FD.

(* spec [m= impl *)
Definition refines {A B} (m : model) (spec : lts A) (impl : lts B) : Prop :=
  match m with
  | T => forall t, traces impl t -> traces spec t
  | F => (forall t, traces impl t -> traces spec t) /\ (forall t X, failures impl t X -> failures spec t X)
  | FD => (forall t, divergences impl t -> divergences spec t) /\
          (forall t X, failures_bot impl t X -> failures_bot spec t X)
  end.

(* As in FDR, a terminated process is deadlocked. *)
Definition deadlock_free {S} (P : lts S) : Prop := forall t s, reach P (init P) t s -> exists a, can P s a.
Definition divergence_free {S} (P : lts S) : Prop := forall t s, reach P (init P) t s -> ~ diverges P s.

(* The claims about one process. In FD, deadlock freedom also excludes divergence. *)
Inductive property := Deadlock_free | Deadlock_and_divergence_free | Divergence_free.
Definition satisfies {S} (p : property) (P : lts S) : Prop :=
  match p with
  | Deadlock_free => deadlock_free P
  | Deadlock_and_divergence_free => deadlock_free P /\ divergence_free P
  | Divergence_free => divergence_free P
  end.

(* After no trace can the process both perform and refuse the same event. In FD, it also does not diverge. *)
Definition deterministic {S} (m : model) (P : lts S) : Prop :=
  (forall t a, traces P (t ++ [a]) -> ~ failures P t (fun b => b = a)) /\
  match m with FD => divergence_free P | _ => True end.

(* After each trace, an event of G can still happen. *)
Definition stays_possible {S} (G : ev -> Prop) (P : lts S) : Prop :=
  forall t s, reach P (init P) t s -> exists t2 u a, reach P s t2 u /\ G a /\ can P u a.
