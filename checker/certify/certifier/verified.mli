(* SPDX-License-Identifier: Apache-2.0 *)
(* Extracted by Coq from ../coq (check.sh --write). *)

val negb : bool -> bool

val fst : ('a1 * 'a2) -> 'a1

val snd : ('a1 * 'a2) -> 'a2

val length : 'a1 list -> int

val app : 'a1 list -> 'a1 list -> 'a1 list

type comparison =
| Eq
| Lt
| Gt

val compOpp : comparison -> comparison

val add : int -> int -> int

module Nat :
 sig
  val ltb : int -> int -> bool
 end

type positive =
| XI of positive
| XO of positive
| XH

type z =
| Z0
| Zpos of positive
| Zneg of positive

module Pos :
 sig
  val succ : positive -> positive

  val add : positive -> positive -> positive

  val add_carry : positive -> positive -> positive

  val pred_double : positive -> positive

  val mul : positive -> positive -> positive

  val iter : ('a1 -> 'a1) -> 'a1 -> positive -> 'a1

  val compare_cont : comparison -> positive -> positive -> comparison

  val compare : positive -> positive -> comparison

  val iter_op : ('a1 -> 'a1 -> 'a1) -> positive -> 'a1 -> 'a1

  val to_nat : positive -> int

  val of_succ_nat : int -> positive
 end

val tl : 'a1 list -> 'a1 list

val nth : int -> 'a1 list -> 'a1 -> 'a1

val concat : 'a1 list list -> 'a1 list

val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list

val flat_map : ('a1 -> 'a2 list) -> 'a1 list -> 'a2 list

val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1

val existsb : ('a1 -> bool) -> 'a1 list -> bool

val forallb : ('a1 -> bool) -> 'a1 list -> bool

val filter : ('a1 -> bool) -> 'a1 list -> 'a1 list

val skipn : int -> 'a1 list -> 'a1 list

val seq : int -> int -> int list

module Z :
 sig
  val double : z -> z

  val succ_double : z -> z

  val mul : z -> z -> z

  val pow_pos : z -> positive -> z

  val pow : z -> z -> z

  val compare : z -> z -> comparison

  val ltb : z -> z -> bool

  val to_nat : z -> int

  val of_nat : int -> z
 end

val lsl0 : Uint63.t -> Uint63.t -> Uint63.t

val lsr0 : Uint63.t -> Uint63.t -> Uint63.t

val land0 : Uint63.t -> Uint63.t -> Uint63.t

val add0 : Uint63.t -> Uint63.t -> Uint63.t

val mul0 : Uint63.t -> Uint63.t -> Uint63.t

val div : Uint63.t -> Uint63.t -> Uint63.t

val mod0 : Uint63.t -> Uint63.t -> Uint63.t

val eqb : Uint63.t -> Uint63.t -> bool

val ltb0 : Uint63.t -> Uint63.t -> bool

val leb : Uint63.t -> Uint63.t -> bool

val size : int

val is_zero : Uint63.t -> bool

val is_even : Uint63.t -> bool

val to_Z_rec : int -> Uint63.t -> z

val to_Z : Uint63.t -> z

val wB : z

type 'a array = 'a Parray.t



type ev = Uint63.t

val tau : ev

val tick : ev

type 's lts = { init : 's; succ0 : ('s -> (ev * 's) list) }

type model =
| T
| F
| FD

type property =
| Deadlock_free
| Deadlock_and_divergence_free
| Divergence_free

type rule = { does : ev; level : Uint63.t option; asks : (int * ev) list;
              puts : (int * Uint63.t) list }

type region =
| Region of participant list * rule list
and participant =
| Slot of int
| Inner of region

type system = { edges : (int -> Uint63.t -> (ev * Uint63.t) list);
                start : Uint63.t list; whole : region }

type change = int * Uint63.t

type move = ev * change list

val combine : move list list -> (int * ev) list -> change list list

val nonempty : 'a1 list -> bool

val slot_moves : system -> int -> Uint63.t -> move list

val update : Uint63.t list -> int -> Uint63.t -> Uint63.t list

val apply : Uint63.t list -> change list -> Uint63.t list

val all_from :
  Uint63.t list -> (Uint63.t -> bool) -> Uint63.t -> Uint63.t -> bool

val few_widths : Uint63.t list

val many_widths : Uint63.t list

val all_below : (Uint63.t -> bool) -> Uint63.t -> bool

val fill : (Uint63.t -> 'a1) -> int -> Uint63.t -> 'a1 array -> 'a1 array

val tabulate : Uint63.t -> (Uint63.t -> 'a1) -> 'a1 array

val lookup : 'a1 array -> (Uint63.t -> 'a1) -> Uint63.t -> 'a1

val table : Uint63.t -> (Uint63.t -> 'a1) -> Uint63.t -> 'a1

val memb : ev -> ev list -> bool

val offers : (ev * 'a1) list -> ev -> bool

type normal_form = { nodes : Uint63.t; root : Uint63.t;
                     arc_count : (Uint63.t -> Uint63.t);
                     arc : (Uint63.t -> Uint63.t -> ev * Uint63.t);
                     where_is : (Uint63.t -> ev -> Uint63.t);
                     acceptance_count : (Uint63.t -> Uint63.t);
                     acceptance : (Uint63.t -> Uint63.t -> ev list);
                     divergent : (Uint63.t -> bool) }

val after : normal_form -> Uint63.t -> ev -> Uint63.t option

type origin = { by_event : bool; from : Uint63.t; depth : Uint63.t }

type 's evidence = { size0 : (Uint63.t -> Uint63.t);
                     member : (Uint63.t -> Uint63.t -> 's);
                     origin_in_root : (Uint63.t -> origin);
                     origin_after : (Uint63.t -> Uint63.t -> Uint63.t ->
                                    origin);
                     witness : (Uint63.t -> Uint63.t -> Uint63.t);
                     loop_size : Uint63.t; loop : (Uint63.t -> 's);
                     loop_next : (Uint63.t -> Uint63.t);
                     diverging_member : (Uint63.t -> Uint63.t);
                     loop_entry : (Uint63.t -> Uint63.t) }

val steps_to : 'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 -> ev -> 'a1 -> bool

val derived :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 evidence -> (Uint63.t -> 'a1 ->
  bool) -> (Uint63.t -> origin) -> Uint63.t -> bool

val accepts : 'a1 lts -> ev list -> 'a1 -> bool

val check_arc :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> 'a1 evidence -> Uint63.t
  -> Uint63.t -> bool

val check_acceptance :
  'a1 lts -> normal_form -> 'a1 evidence -> Uint63.t -> Uint63.t -> bool

val check_divergence :
  ('a1 -> 'a1 -> bool) -> normal_form -> 'a1 evidence -> Uint63.t -> bool

val check_node :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> 'a1 evidence -> model ->
  Uint63.t -> bool

val check_root :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> 'a1 evidence -> bool

val check_loop : 'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 evidence -> bool

val check_specification :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> 'a1 evidence -> model ->
  bool

type 's pairs = { count : Uint63.t; state_of : (Uint63.t -> 's);
                  node_of : (Uint63.t -> Uint63.t);
                  rank_of : (Uint63.t -> Uint63.t);
                  locate : ('s -> Uint63.t -> Uint63.t);
                  choose : (Uint63.t -> (ev * 's) list -> Uint63.t) }

val within : Uint63.t option -> Uint63.t -> bool

val covered :
  ('a1 -> 'a1 -> bool) -> 'a1 pairs -> 'a1 -> Uint63.t -> Uint63.t option ->
  bool

val stop : normal_form -> model -> Uint63.t -> bool

val ranked : model -> bool

val refusals_ok :
  normal_form -> 'a1 pairs -> Uint63.t -> (ev * 'a1) list -> bool

val check_move :
  ('a1 -> 'a1 -> bool) -> normal_form -> model -> 'a1 pairs -> Uint63.t ->
  Uint63.t -> (ev * 'a1) -> bool

val check_pair :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> model -> 'a1 pairs ->
  Uint63.t -> bool

val check_implementation :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> model -> 'a1 pairs -> bool

val check :
  'a1 lts -> 'a2 lts -> ('a1 -> 'a1 -> bool) -> ('a2 -> 'a2 -> bool) -> model
  -> normal_form -> 'a1 evidence -> 'a2 pairs -> bool

val no_deadlock : property -> bool

val no_divergence : property -> bool

val check_state :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> property -> 'a1 pairs -> Uint63.t -> bool

val check_property :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> property -> 'a1 pairs -> bool

type lead = rule * change list

val led_by : int -> rule -> bool

val begins : ev -> rule -> bool

val rules_of : Uint63.t -> int -> rule list -> ev -> rule list

val leads_of : (ev -> rule list) -> move list -> lead list

type fregion =
| FRegion of fparticipant list
and fparticipant =
| FSlot of int * (Uint63.t -> move list) * (Uint63.t -> lead list)
| FInner of fregion * (ev -> rule list)

val number : (int -> 'a1 -> 'a2) -> int -> 'a1 list -> 'a2 list

val prepare : system -> Uint63.t -> (int -> Uint63.t) -> region -> fregion

type offer = move list * lead list

type candidate = lead * change list list

val able : move list list -> offer list -> candidate list

val lesser : Uint63.t option -> candidate -> Uint63.t option

val least : candidate list -> Uint63.t option

val ready : Uint63.t option -> rule -> bool

val fast_fire : offer list -> move list

val fast_moves : Uint63.t list -> fregion -> move list

val asking : region -> bool

val encode : Uint63.t list -> Uint63.t list -> Uint63.t

val fits : Uint63.t list -> Uint63.t list -> bool

val volume : Uint63.t list -> z

val decode_before :
  Uint63.t list -> Uint63.t -> Uint63.t list -> Uint63.t list

val pack : Uint63.t list list -> Uint63.t list -> Uint63.t list

val unpack : Uint63.t list list -> Uint63.t list -> Uint63.t list

val narrow : Uint63.t list -> bool

val eq_words : Uint63.t list -> Uint63.t list -> bool

type layout = { groups : Uint63.t list list; event_count : Uint63.t }

val inside_bounds : layout -> change -> bool

val bounded : layout -> region -> bool

val edges_bounded : layout -> system -> bool

val system_ok : layout -> system -> bool

val packed : layout -> system -> Uint63.t list lts

val certify_refinement :
  model -> layout -> system -> layout -> system -> normal_form -> Uint63.t
  list evidence -> Uint63.t list pairs -> bool

val certify_property :
  property -> layout -> system -> Uint63.t list pairs -> bool
