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

val nth_error : 'a1 list -> int -> 'a1 option

val concat : 'a1 list list -> 'a1 list

val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list

val flat_map : ('a1 -> 'a2 list) -> 'a1 list -> 'a2 list

val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1

val existsb : ('a1 -> bool) -> 'a1 list -> bool

val forallb : ('a1 -> bool) -> 'a1 list -> bool

val filter : ('a1 -> bool) -> 'a1 list -> 'a1 list

val find : ('a1 -> bool) -> 'a1 list -> 'a1 option

val skipn : int -> 'a1 list -> 'a1 list

val seq : int -> int -> int list

val repeat : 'a1 -> int -> 'a1 list

module Z :
 sig
  val double : z -> z

  val succ_double : z -> z

  val pred_double : z -> z

  val pos_sub : positive -> positive -> z

  val add : z -> z -> z

  val mul : z -> z -> z

  val pow_pos : z -> positive -> z

  val pow : z -> z -> z

  val compare : z -> z -> comparison

  val leb : z -> z -> bool

  val ltb : z -> z -> bool

  val to_nat : z -> int

  val of_nat : int -> z
 end

val lsl0 : Uint63.t -> Uint63.t -> Uint63.t

val lsr0 : Uint63.t -> Uint63.t -> Uint63.t

val land0 : Uint63.t -> Uint63.t -> Uint63.t

val lor0 : Uint63.t -> Uint63.t -> Uint63.t

val add0 : Uint63.t -> Uint63.t -> Uint63.t

val sub : Uint63.t -> Uint63.t -> Uint63.t

val eqb : Uint63.t -> Uint63.t -> bool

val ltb0 : Uint63.t -> Uint63.t -> bool

val leb0 : Uint63.t -> Uint63.t -> bool

val size : int

val is_zero : Uint63.t -> bool

val is_even : Uint63.t -> bool

val opp : Uint63.t -> Uint63.t

val to_Z_rec : int -> Uint63.t -> z

val to_Z : Uint63.t -> z

val of_pos_rec : int -> positive -> Uint63.t

val of_pos : positive -> Uint63.t

val of_Z : z -> Uint63.t

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

val nonempty : 'a1 list -> bool

val before : rule -> Uint63.t -> bool

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

type action =
| Open of Uint63.t
| Visit
| Stop

type 's pairs = { state_of : (Uint63.t -> 's);
                  node_of : (Uint63.t -> Uint63.t);
                  place_of : (Uint63.t -> Uint63.t);
                  pair_at : (Uint63.t -> Uint63.t);
                  locate : ('s -> Uint63.t -> Uint63.t);
                  choose : (Uint63.t -> (ev * 's) list -> Uint63.t);
                  deed : (Uint63.t -> (Uint63.t * (ev * 's) list) list ->
                         action) }

type need =
| Forbidden
| Irrelevant
| Leads of Uint63.t * bool

val cover :
  ('a1 -> 'a1 -> bool) -> 'a1 pairs -> 'a1 -> Uint63.t -> Uint63.t option ->
  Uint63.t -> Uint63.t option

val check_moves :
  ('a1 -> 'a1 -> bool) -> 'a1 pairs -> (Uint63.t -> ev -> need) -> Uint63.t
  -> Uint63.t -> (ev * 'a1) list -> Uint63.t -> Uint63.t option

val check_pair :
  ('a1 -> 'a1 -> bool) -> 'a1 pairs -> (Uint63.t -> ev -> need) -> (Uint63.t
  -> (ev * 'a1) list -> bool) -> Uint63.t -> Uint63.t -> (ev * 'a1) list ->
  Uint63.t -> Uint63.t option

type 's progress = { time : Uint63.t;
                     opened : (Uint63.t * (ev * 's) list) list;
                     visited : Uint63.t; high : Uint63.t }

type 's outcome =
| More of 's progress
| Over of 's progress option

val proceed :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 pairs -> (Uint63.t -> ev -> need) ->
  (Uint63.t -> (ev * 'a1) list -> bool) -> 'a1 progress -> 'a1 outcome

val proceed_often :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 pairs -> (Uint63.t -> ev -> need) ->
  (Uint63.t -> (ev * 'a1) list -> bool) -> Uint63.t list -> 'a1 progress ->
  'a1 outcome

val all_visited : 'a1 pairs -> 'a1 progress -> bool

val walk :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 pairs -> (Uint63.t -> ev -> need) ->
  (Uint63.t -> (ev * 'a1) list -> bool) -> Uint63.t -> bool

val stop : normal_form -> model -> Uint63.t -> bool

val ranked : model -> bool

val refusals_ok :
  normal_form -> 'a1 pairs -> Uint63.t -> (ev * 'a1) list -> bool

val refusals :
  normal_form -> model -> 'a1 pairs -> Uint63.t -> (ev * 'a1) list -> bool

val event_needs : normal_form -> model -> Uint63.t -> ev -> need

val check_implementation :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> model -> 'a1 pairs -> bool

val no_deadlock : property -> bool

val no_divergence : property -> bool

val enabled : property -> Uint63.t -> (ev * 'a1) list -> bool

val any_event : property -> Uint63.t -> ev -> need

val check_property :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> property -> 'a1 pairs -> bool

val no_repetition : int list -> bool

val set_all : (int -> Uint63.t -> 'a1) -> change list -> 'a1 list

type 'packed_change fmove = ev * 'packed_change list

type ('packed_state, 'packed_change) ask =
| AskSlot of ('packed_state -> Uint63.t)
   * (Uint63.t -> 'packed_change list list)
| AskInner of int * ev

type ('packed_state, 'packed_change) frule = { f_does : ev;
                                               f_level : Uint63.t option;
                                               f_asks : ('packed_state,
                                                        'packed_change) ask
                                                        list;
                                               f_puts : 'packed_change list }

type ('packed_state, 'packed_change) lead =
  ('packed_state, 'packed_change) frule * 'packed_change list

type ('packed_state, 'packed_change) fregion =
| FRegion of bool * ('packed_state, 'packed_change) fparticipant list
and ('packed_state, 'packed_change) fparticipant =
| FSlot of ('packed_state -> Uint63.t)
   * (Uint63.t -> ('packed_state, 'packed_change) lead list)
| FInner of int * ('packed_state, 'packed_change) fregion
   * (ev -> ('packed_state, 'packed_change) frule list)

val led_by : int -> rule -> bool

val begins : ev -> rule -> bool

val slot_ways :
  system -> (int -> Uint63.t -> 'a1) -> int -> ev -> Uint63.t -> 'a1 list list

val asked : Uint63.t -> int -> rule list -> bool array

val asker :
  system -> Uint63.t -> (int -> Uint63.t) -> (int -> 'a1 -> Uint63.t) -> (int
  -> Uint63.t -> 'a2) -> rule list -> int -> participant -> ev -> ('a1, 'a2)
  ask

val number : (int -> 'a1 -> 'a2) -> int -> 'a1 list -> 'a2 list

val ask_of : (ev -> ('a1, 'a2) ask) list -> (int * ev) -> ('a1, 'a2) ask

val frule_of :
  (int -> Uint63.t -> 'a2) -> (ev -> ('a1, 'a2) ask) list -> rule -> ('a1,
  'a2) frule

val rules_of :
  Uint63.t -> int -> (rule * ('a1, 'a2) frule) list -> ev -> ('a1, 'a2) frule
  list

val slot_leads :
  system -> (int -> Uint63.t -> 'a2) -> (ev -> ('a1, 'a2) frule list) -> int
  -> Uint63.t -> ('a1, 'a2) lead list

val has_level : rule -> bool

val prepare :
  system -> Uint63.t -> (int -> Uint63.t) -> (int -> 'a1 -> Uint63.t) -> (int
  -> Uint63.t -> 'a2) -> region -> ('a1, 'a2) fregion

type 'packed_change inner_list = (int * 'packed_change fmove list) list

val inner_moves : int -> 'a1 inner_list -> 'a1 fmove list

val fulfil : 'a1 -> 'a2 inner_list -> ('a1, 'a2) ask -> 'a2 list list

val others : 'a1 -> 'a2 inner_list -> ('a1, 'a2) ask list -> 'a2 list list

val fold_leads :
  ('a3 -> ('a1, 'a2) lead -> 'a3) -> 'a1 -> 'a2 inner_list -> ('a1, 'a2)
  fparticipant -> 'a3 -> 'a3

val extend : 'a1 list -> 'a1 list -> 'a1 list

val add_moves :
  ('a1, 'a2) lead -> 'a2 list list -> 'a2 fmove list -> 'a2 fmove list

val fire_all :
  'a1 -> 'a2 inner_list -> ('a1, 'a2) fparticipant list -> 'a2 fmove list

type ('packed_state, 'packed_change) candidate =
  ('packed_state, 'packed_change) lead * 'packed_change list list

val add_candidate :
  'a1 -> 'a2 inner_list -> ('a1, 'a2) lead -> ('a1, 'a2) candidate list ->
  ('a1, 'a2) candidate list

val candidates :
  'a1 -> 'a2 inner_list -> ('a1, 'a2) fparticipant list -> ('a1, 'a2)
  candidate list

val lesser : Uint63.t option -> ('a1, 'a2) candidate -> Uint63.t option

val least : ('a1, 'a2) candidate list -> Uint63.t option

val ready : Uint63.t option -> ('a1, 'a2) frule -> bool

val fire_ready : ('a1, 'a2) candidate list -> 'a2 fmove list

val fast_moves : 'a1 -> ('a1, 'a2) fregion -> 'a2 fmove list

val asking : region -> bool

val encode : Uint63.t list -> Uint63.t list -> Uint63.t

val fits : Uint63.t list -> Uint63.t list -> bool

val total : Uint63.t list -> z

val narrow : Uint63.t list -> bool

val pack : Uint63.t list list -> Uint63.t list -> Uint63.t list

type field = { word : int; shift : Uint63.t; mask : Uint63.t }

val fields_of : int -> Uint63.t -> Uint63.t list -> field list

val fields : int -> Uint63.t list list -> field list

val cut : field -> Uint63.t -> Uint63.t

val changed : field -> Uint63.t -> Uint63.t -> Uint63.t

val replace_word :
  Uint63.t list -> int -> (Uint63.t -> Uint63.t) -> Uint63.t list

val read_field : field -> Uint63.t list -> Uint63.t

val write_field : Uint63.t list -> (field * Uint63.t) -> Uint63.t list

val eq_words : Uint63.t list -> Uint63.t list -> bool

type layout = { groups : Uint63.t list list; event_count : Uint63.t }

val size_of : layout -> int -> Uint63.t

val inside_bounds : layout -> change -> bool

val bounded : layout -> region -> bool

val edges_bounded : layout -> system -> bool

val system_ok : layout -> system -> bool

val no_field : field

val read_local : layout -> int -> Uint63.t list -> Uint63.t

val write_local : layout -> int -> Uint63.t -> field * Uint63.t

val prepared : layout -> system -> (Uint63.t list, field * Uint63.t) fregion

val packed : layout -> system -> Uint63.t list lts

type merging = { merged_states : (int -> Uint63.t);
                 representative : (int -> Uint63.t -> Uint63.t) }

val merge : merging -> int -> Uint63.t -> Uint63.t

val merge_edges :
  merging -> int -> (ev * Uint63.t) list -> (ev * Uint63.t) list

val merge_changes : merging -> change list -> change list

val merge_state : merging -> int -> Uint63.t list -> Uint63.t list

val merge_rule : merging -> rule -> rule

val merge_region : merging -> region -> region

val merged : merging -> system -> system

val has_edge : (ev * Uint63.t) list -> (ev * Uint63.t) -> bool

val equal_edges : (ev * Uint63.t) list -> (ev * Uint63.t) list -> bool

val slots_below : int -> region -> bool

val merging_ok : merging -> system -> bool

type item =
| Performs of int * ev
| Sets of int * Uint63.t

val item_slot : item -> int

type passage = { place : int list; inside : participant list;
                 rivals : rule list; own : rule; around : int list;
                 prior : bool }

type whole_rule = { performed : ev; items : item list; passages : passage list }

type way = item list * passage list

val slots_of : region -> int list

val can_be_prevented : rule list -> rule -> bool

type source =
| Of_slot of int
| Of_region of whole_rule list

val ways : source -> ev -> way list

val pick : source list -> (int * ev) list -> way list

val put_items : change list -> item list

val whole_of :
  int list -> participant list -> rule list -> int list -> source list ->
  rule -> whole_rule list

val whole_rules : region -> int list -> whole_rule list

type cube = (int * Uint63.t) list

val local_in : cube -> int -> Uint63.t option

val put_in : cube -> int -> Uint63.t -> cube

type confluent_steps = { entries : Uint63.t;
                         follows : (Uint63.t -> Uint63.t);
                         states_of : (Uint63.t -> cube);
                         entry_after : (Uint63.t -> cube -> Uint63.t);
                         hint : (Uint63.t list -> Uint63.t list) }

val same_item : item -> item -> bool

val same_items : item list -> item list -> bool

val same_path : int list -> int list -> bool

val load : 'a1 list -> Uint63.t -> 'a1 array -> 'a1 array

val element : 'a1 list -> Uint63.t -> 'a1 option

val rules_of_whole : system -> whole_rule list

val goal :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> int -> ev -> Uint63.t ->
  Uint63.t

val has_event :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> int -> ev -> Uint63.t ->
  bool

val determined :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> int -> ev -> Uint63.t ->
  bool

val has_target :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> int -> ev -> Uint63.t ->
  Uint63.t -> bool

val does_item :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> int -> Uint63.t -> item
  -> Uint63.t -> Uint63.t

val effect :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> item list -> int ->
  Uint63.t -> Uint63.t

val touches : item list -> int -> bool

val change_of :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> (int -> Uint63.t) ->
  item -> change

val sure :
  system -> (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> cube -> item
  -> bool

val impossible :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> cube -> item -> bool

val overrules : passage -> passage -> bool

val cannot_fire :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> whole_rule -> cube ->
  whole_rule -> bool

val own_items : item list -> int -> item list

val commutes :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> item list -> cube ->
  item -> bool

val leaves :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> item list -> cube -> int
  -> bool

val undisturbed :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> item list -> cube ->
  passage -> bool

val outcomes :
  (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> cube -> item list ->
  cube -> cube list

val implies_cube : cube -> cube -> bool

val continues : confluent_steps -> Uint63.t -> cube -> bool

val spared :
  confluent_steps -> (int -> ev -> Uint63.t -> (ev * Uint63.t) list) ->
  Uint63.t -> whole_rule -> cube -> whole_rule -> bool

val touching : whole_rule list -> int -> whole_rule list

val guarding : whole_rule list -> int -> whole_rule list

val by_slot : system -> (int -> whole_rule list) -> int -> whole_rule list

val entry_ok :
  system -> confluent_steps -> bool -> (int -> ev -> Uint63.t ->
  (ev * Uint63.t) list) -> (Uint63.t -> whole_rule option) -> (int ->
  whole_rule list) -> (int -> whole_rule list) -> Uint63.t -> bool

val confluent_ok :
  system -> confluent_steps -> bool -> (int -> ev -> Uint63.t ->
  (ev * Uint63.t) list) -> bool

val led : ('a1 -> 'a1) -> 'a1 lts -> 'a1 lts

val hidden : 'a1 lts -> 'a1 lts

type pull = { source0 : int; send : (Uint63.t -> Uint63.t);
              rename : (ev -> ev); restore : (ev -> ev) }

type mapping = { new_place : (int -> int); new_name : (ev -> ev);
                 old_name : (ev -> ev); rule_to : (Uint63.t -> Uint63.t);
                 rule_from : (Uint63.t -> Uint63.t); deeper : (int -> mapping) }

type automorphism = { pulls : (int * pull) list; tree : mapping;
                      instead : (Uint63.t -> Uint63.t -> Uint63.t) }

val all_numbered : (Uint63.t -> 'a1 -> bool) -> Uint63.t -> 'a1 list -> bool

val all_true : bool list -> bool

val stay : int -> pull

val pull_in : (int * pull) list -> int -> pull

val sets_nothing : rule -> bool

val silent : region -> bool

val plain : system -> bool

val pull_at : automorphism -> int -> pull

val names_at :
  automorphism -> mapping -> participant list -> int -> (ev -> ev) * (ev ->
  ev)

val name_at : automorphism -> mapping -> participant list -> int -> ev -> ev

val old_name_at :
  automorphism -> mapping -> participant list -> int -> ev -> ev

val image_of :
  automorphism -> mapping -> participant list -> (int * ev) -> int * ev

val same_level : Uint63.t option -> Uint63.t option -> bool

val corresponds :
  automorphism -> mapping -> participant list -> participant list -> rule ->
  rule -> bool

val rules_correspond :
  automorphism -> mapping -> participant list -> participant list -> rule
  list -> rule list -> bool

val maps : system -> automorphism -> region -> mapping -> region -> bool

val rename_edges : pull -> (ev * Uint63.t) list -> (ev * Uint63.t) list

val pull_ok :
  system -> (int -> Uint63.t) -> automorphism -> (int * pull) -> bool

val same_test : ev -> ev -> ev -> bool

val names_ok : automorphism -> rule -> bool

val automorphism_ok : system -> (int -> Uint63.t) -> automorphism -> bool

val old_event : automorphism -> ev -> ev

type reduction = { confluent : confluent_steps option;
                   symmetric : automorphism list;
                   turns : (Uint63.t list -> Uint63.t list) }

val last_bits : ev -> Uint63.t

val rows_by_event :
  layout -> system -> int -> ev -> Uint63.t -> (ev * Uint63.t) list

val cube_state : cube -> int -> Uint63.t

val tests_of : layout -> cube -> ((Uint63.t list -> Uint63.t) * Uint63.t) list

val writes_of :
  layout -> (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> whole_rule
  option -> cube -> (field * Uint63.t) list

val passes :
  ((Uint63.t list -> Uint63.t) * Uint63.t) list -> Uint63.t list -> bool

val follow_on :
  layout -> system -> confluent_steps -> Uint63.t list -> Uint63.t list

val fields_of_pull :
  layout -> (int * pull) -> ((Uint63.t list -> Uint63.t) * (Uint63.t ->
  Uint63.t)) * field

val turned :
  (((Uint63.t list -> Uint63.t) * (Uint63.t -> Uint63.t)) * field) list ->
  Uint63.t list -> Uint63.t list

val turn_on : layout -> reduction -> Uint63.t list -> Uint63.t list

val lead_on : layout -> system -> reduction -> Uint63.t list -> Uint63.t list

val unreduced : layout -> system -> bool -> Uint63.t list lts

val reduced : layout -> system -> reduction -> bool -> Uint63.t list lts

val reduction_holds : layout -> system -> reduction -> bool -> bool

val among : ev list -> (ev -> ev) -> ev -> bool

val indifferent_node : normal_form -> automorphism -> Uint63.t -> bool

val indifferent_to : normal_form -> automorphism -> bool

val indifferent_ok : reduction -> normal_form -> bool

val only_deadlocks : property -> bool

type choiceless = { choiceless_size : Uint63.t; choiceless_start : Uint63.t;
                    choiceless_arcs : (Uint63.t -> (ev * Uint63.t) list);
                    choiceless_events : ev list }

val choiceless_system : choiceless -> system

val ascending : ev -> (ev * Uint63.t) list -> bool

val choiceless_ok : choiceless -> bool

type 's numbering = { state_count : Uint63.t;
                      state_number : ('s -> Uint63.t);
                      numbered_state : (Uint63.t -> 's);
                      distance : (Uint63.t -> Uint63.t) }

val known_number :
  ('a1 -> 'a1 -> bool) -> 'a1 numbering -> 'a1 -> Uint63.t option

val nearer :
  ('a1 -> 'a1 -> bool) -> ev list -> 'a1 numbering -> Uint63.t -> (ev * 'a1)
  list -> bool -> bool

val check_state :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> ev list -> 'a1 numbering -> Uint63.t ->
  bool

val check_possible :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> ev list -> 'a1 numbering -> bool

type 's run = (ev * 's) list

val is_run : 'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 -> 'a1 run -> bool

val run_end : 'a1 -> 'a1 run -> 'a1

val visible : 'a1 run -> ev list

val is_loop : 'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 -> 'a1 run -> bool

val same_events : ev list -> ev list -> bool

val check_trace :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> ev list -> 'a1 run -> bool

val refused : 'a1 run -> ev -> bool

val can_refuse : 'a1 run -> bool

val diverging : 'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 run -> 'a1 run -> bool

type fault =
| Performs0
| Refuses of (ev -> bool)
| Diverges_after

val plain_event_at : ev list -> Uint63.t -> ev option

val event_at : ev list -> Uint63.t -> ev option

val performs : fault -> bool

val absence_needs :
  model -> fault -> (Uint63.t -> ev option) -> Uint63.t -> ev -> need

val absence_fine :
  fault -> (Uint63.t -> ev option) -> Uint63.t -> (ev * 'a1) list -> bool

val check_absence :
  'a1 lts -> ('a1 -> 'a1 -> bool) -> model -> ev list -> fault -> 'a1 pairs
  -> bool

type 's refutation =
| By_event of (ev * 's) list
| By_refusal of (ev * 's) list
| By_divergence of (ev * 's) list * (ev * 's) list

val check_refutation :
  'a1 lts -> 'a2 lts -> ('a1 -> 'a1 -> bool) -> ('a2 -> 'a2 -> bool) -> model
  -> 'a2 refutation -> 'a1 pairs -> bool

type shape = { merges : merging; packs : layout }

val compact : shape -> system -> Uint63.t list lts

val shape_ok : shape -> system -> bool

val searched :
  bool -> shape -> reduction option -> system -> Uint63.t list lts

val reduction_ok : bool -> shape -> reduction option -> system -> bool

val certify_refinement :
  model -> shape -> system -> shape -> system -> reduction option ->
  normal_form -> Uint63.t list evidence -> Uint63.t list pairs -> bool

val certify_property :
  property -> shape -> system -> reduction option -> Uint63.t list pairs ->
  bool

val certify_determinism :
  model -> shape -> choiceless -> shape -> system -> reduction option ->
  normal_form -> Uint63.t list evidence -> Uint63.t list pairs -> bool

val certify_possible :
  ev list -> shape -> system -> Uint63.t list numbering -> bool

val certify_trace :
  ev list -> shape -> system -> (ev * Uint63.t list) list -> bool

val certify_refutation :
  model -> shape -> system -> shape -> system -> Uint63.t list refutation ->
  Uint63.t list pairs -> bool

type term =
| Offer of (ev * term) list
| Call of Uint63.t
| Choice of Uint63.t * term * term
| Sliding of term * term
| Sequence of term * term
| Interrupt of Uint63.t * term * term
| Throw of Uint63.t * term * term
| Parallel of Uint63.t * Uint63.t * Uint63.t * term * term
| Hide of Uint63.t * term
| Rename of Uint63.t * term
| Prioritise of Uint63.t * term

type definitions = { body : (Uint63.t -> term);
                     has : (Uint63.t -> ev -> bool);
                     names : (Uint63.t -> ev -> ev list);
                     priority : (Uint63.t -> ev -> Uint63.t option) }

type moves_to = (ev * term) list

val invisible : ev -> bool

val within : definitions -> Uint63.t -> ev -> bool

val new_names : definitions -> Uint63.t -> ev -> ev list

val hidden0 : definitions -> Uint63.t -> ev -> ev

val rank : definitions -> Uint63.t -> ev -> Uint63.t option

val beats : definitions -> Uint63.t -> ev -> ev -> bool

val alone : definitions -> Uint63.t -> ev -> bool

val together : definitions -> Uint63.t -> ev -> bool

val keep : (ev -> bool) -> (term -> term) -> moves_to -> moves_to

val outside : definitions -> Uint63.t -> moves_to -> moves_to

val joint :
  (ev -> bool) -> (term -> term -> term) -> moves_to -> moves_to -> moves_to

val on_one : moves_to option -> (moves_to -> moves_to) -> moves_to option

val on_both :
  moves_to option -> moves_to option -> (moves_to -> moves_to -> moves_to) ->
  moves_to option

val moves_of : definitions -> int -> term -> moves_to option

type script = { defines : definitions; main : term }

val eq_term : term -> term -> bool

val distinct : Uint63.t -> ev list -> ev list

type tree0 =
| Leaf of int
| Beside of Uint63.t * Uint63.t * Uint63.t * tree0 * tree0
| Hidden of Uint63.t * tree0
| Renamed of Uint63.t * tree0
| Prioritised of Uint63.t * tree0

type split = { whole_tree : tree0; slots : int; states : (int -> Uint63.t);
               meaning : (int -> Uint63.t -> term);
               number_of : (int -> term -> Uint63.t);
               alphabet : (int -> ev list); enough : int;
               event_bound : Uint63.t }

type vector = { gives : ev; rank_of : Uint63.t option; wants : (int * ev) list }

val rule_of : vector -> rule

type compiled = participant list * vector list

val region_of : compiled -> region

val each : ev list -> vector list

val free : vector list -> bool

val boxed : Uint63.t -> compiled -> compiled

val relabel : (ev -> ev list) -> compiled -> compiled

val ranked_by : (ev -> Uint63.t option) -> compiled -> compiled

val shift0 : int -> (int * ev) list -> (int * ev) list

val shifted : int -> vector -> vector

val beside :
  Uint63.t -> (ev -> bool) -> (ev -> bool) -> (ev -> bool) -> compiled ->
  compiled -> compiled

val compile : definitions -> split -> tree0 -> compiled

val term_of : split -> Uint63.t list -> tree0 -> term

val leaves0 : tree0 -> int list

val row : definitions -> split -> int -> Uint63.t -> (ev * Uint63.t) list

val split_system : definitions -> split -> system

val known : split -> int -> term -> bool

val component_ok : definitions -> split -> int -> bool

val split_ok : definitions -> split -> term -> bool

val certify_script : script -> split -> (system -> bool) -> bool

val certify_scripts :
  script -> split -> script -> split -> (system -> system -> bool) -> bool
