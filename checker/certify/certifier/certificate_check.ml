(* SPDX-License-Identifier: Apache-2.0 *)
(* Certifies one certificate: an untrusted search finds what the verified check needs, and the check decides. *)
open Verified

type 'a array = 'a Array.t

type figures = { pairs : int; nodes : int; transitions : int; components : int; rules : int; reductions : string list }
type answer = Certified of figures | Refused of string | Undecided of string

(* A side of the claim: a compiled process, or a term and how it is split. *)
type subject = System of system | Split_term of script * split

(* The data to which the theorems are applied. *)
type proof =
  | Of_refinement of model * shape * subject * shape * subject * normal_form * int list evidence * int list pairs
  | Of_property of property * shape * subject * int list pairs
  | Of_determinism of model * shape * choiceless * shape * subject * normal_form * int list evidence * int list pairs
  | Of_possible of int list * shape * subject * int list numbering
  | Of_trace of int list * shape * subject * (int * int list) list
  | Of_refutation of model * shape * subject * shape * subject * int list refutation * int list pairs

(* Returns the layout of packed states: for each word, the numbers of bits of its components. *)
let layout_of sizes event_count =
  let rec bits size = if size <= 1 then 0 else 1 + bits ((size + 1) / 2) in
  let add (groups, group, used) size =
    let more = bits size in
    if used + more > 62 then (List.rev group :: groups, [ more ], more) else (groups, more :: group, used + more)
  in
  let groups, group, _ = List.fold_left add ([], [], 0) sizes in
  { groups = List.rev (List.rev group :: groups); event_count }

(* Finds how states of components are merged. States are merged if no transition distinguishes them. *)
let shape_of (process : Formats.process) event_count =
  let mergings = Array.map Search.equal_states process.component_edges in
  let merges =
    { merged_states = (fun k -> if k < Array.length mergings then Array.length mergings.(k) else 0);
      representative = (fun k v -> mergings.(k).(v)) }
  in
  { merges; packs = layout_of process.sizes event_count }

let width shape = List.length shape.packs.groups

(* Returns the text of a state: the state of each component. *)
let state_name (process : Formats.process) shape words =
  let locals = Array.to_list (Follow.unpack (Follow.fields_of shape.packs) words) in
  let name k local = Printf.sprintf "%s: %d" process.component_names.(k) local in
  Printf.sprintf "(%s)" (String.concat "; " (List.mapi name locals))

let set_text name events = Printf.sprintf "{%s}" (String.concat ", " (List.map name events))
let offered moves = List.sort_uniq compare (List.map fst moves)

let refinement_task (nodes : Search.node array) normal model choose name : Search.task =
  let stopped n = model = FD && nodes.(n).node_diverges in
  let refusal n moves =
    let events = offered moves in
    let tick = List.mem 1 events in
    if model = T || (List.mem 0 events && not tick) || choose n moves < Array.length nodes.(n).acceptances then None
    else
      let required = Array.to_list (Array.map (fun set -> set_text name (Array.to_list set)) nodes.(n).acceptances) in
      Some
        (Printf.sprintf "it can refuse everything outside %s; the specification requires %s"
           (set_text name (if tick then [ 1 ] else events))
           (if required = [] then "that it is not stable here" else "one of " ^ String.concat " " required))
  in
  { next = (fun n a -> after normal n a);
    stopped;
    state_fault = refusal;
    forbid_cycles = model = FD;
    event_fault =
      (fun n a ->
        Printf.sprintf "it can perform %s; the specification allows only %s" (name a)
          (set_text name (Array.to_list (Array.map fst nodes.(n).arcs)))) }

let property_task property : Search.task =
  { next = (fun _ _ -> Some 0);
    stopped = (fun _ -> false);
    state_fault = (fun _ moves -> if property <> Divergence_free && moves = [] then Some "it can do nothing" else None);
    forbid_cycles = property <> Deadlock_free;
    event_fault = (fun _ _ -> "") }

(* A side of a claim: its process, how the process is represented, and what the theorem is about. *)
type side = { process : Formats.process; shape : shape; subject : subject }

let side_of ?forge given ~event_count ~most =
  let process, subject =
    match given with
    | Formats.Compiled process -> (process, System process.system)
    | Formats.Term text ->
        let split, process = Splitter.split ?forge text ~event_count ~most in
        (process, Split_term (text.script, split))
  in
  { process; shape = shape_of process event_count; subject }

let lts_of side = compact side.shape side.process.system

(* What the search needs to check the implementation, from the claim and its specification. *)
type plan = {
  process : Formats.process;  (** the implementation *)
  shape : shape;
  name : int -> string;
  task : Search.task;
  choose : int -> (int * Search.words) list -> int;
  nodes : Search.node array;
  normal : normal_form option;  (** of the specification, if there is one *)
  completed : Search.words pairs -> proof;
}

(* A graph without choices as a process. *)
let choiceless_process events_to (rows : (int * int) list array) : choiceless * Formats.process =
  let graph =
    { choiceless_size = Array.length rows; choiceless_start = 0; choiceless_arcs = (fun v -> rows.(v));
      choiceless_events = List.init (events_to - 1) (fun i -> i + 1) }
  in
  ( graph,
    { system = choiceless_system graph; sizes = [ Array.length rows ]; component_names = [| "the graph" |];
      component_edges = [| rows |]; rule_count = events_to - 1 } )

(* Describes violations of determinism: the nodes of the graph are states of the process. *)
let determinism_task (nodes : Search.node array) (task : Search.task) name : Search.task =
  let state_fault n moves =
    match task.state_fault n moves with
    | None -> None
    | Some _ ->
        let offered a = if List.mem_assoc 1 moves then a = 1 else List.mem_assoc a moves in
        let missing = List.filter (fun (a, _) -> not (offered a)) (Array.to_list nodes.(n).arcs) in
        let event = match missing with (a, _) :: _ -> name a | [] -> "an event" in
        Some (Printf.sprintf "it can refuse %s, which is possible in another state after the same events" event)
  in
  { task with state_fault;
    event_fault = (fun _ a -> Printf.sprintf "it can perform %s, which another state after the same events can refuse" (name a)) }

(* What the search and the check need of the specification of a refinement. *)
type normalised = {
  members : Search.node array;
  normal : normal_form;
  fitting : int -> (int * Search.words) list -> int;
  evidence : Search.words evidence;
  refinement : Search.task;
}

let normalised (claim : Formats.claim) model spec ~forge ~most =
  let lts = lts_of spec in
  let graph = Search.new_graph lts.succ0 in
  let members = forge (Search.normalise graph lts.init model ~most) in
  let normal = Search.normal_form_of members in
  let fitting = Search.chooser members claim.event_count in
  { members; normal; fitting; evidence = Search.evidence_of graph lts.init members;
    refinement = refinement_task members normal model fitting claim.event_name }

let plan_of ?(forge = Fun.id) ?split_forge ?(forge_graph = Fun.id) (claim : Formats.claim) ~most =
  let side_of given = side_of ?forge:split_forge given ~event_count:claim.event_count ~most in
  let impl = side_of claim.implementation in
  let plan task choose nodes normal completed =
    { process = impl.process; shape = impl.shape; name = claim.event_name; task; choose; nodes; normal; completed } in
  match (claim.question, claim.specification) with
  | Refinement model, Some given ->
      let spec = side_of given in
      let n = normalised claim model spec ~forge ~most in
      plan n.refinement n.fitting n.members (Some n.normal) (fun pairs ->
          Of_refinement (model, spec.shape, spec.subject, impl.shape, impl.subject, n.normal, n.evidence, pairs))
  | Property property, None ->
      plan (property_task property) (fun _ _ -> 0) [||] None (fun pairs -> Of_property (property, impl.shape, impl.subject, pairs))
  | Determinism model, None ->
      let lts = lts_of impl in
      let rows = forge_graph (Search.without_choices (Search.new_graph lts.succ0) lts.init ~most) in
      let graph, process = choiceless_process claim.event_count rows in
      let spec = side_of (Formats.Compiled process) in
      let n = normalised claim model spec ~forge ~most in
      plan (determinism_task n.members n.refinement claim.event_name) n.fitting n.members (Some n.normal) (fun pairs ->
          Of_determinism (model, spec.shape, graph, impl.shape, impl.subject, n.normal, n.evidence, pairs))
  | _ -> raise (Formats.Unreadable "a specification belongs to a refinement, and to nothing else")

let search_pairs ?(lenient = false) plan ~most =
  let lts = compact plan.shape plan.process.system in
  Search.pairs_for ~lenient lts (width plan.shape) plan.task ~most ~name:plan.name
    ~state_name:(state_name plan.process plan.shape)

(* Finds the evidence before the check. With `lenient`, for tests, it overlooks violations; the check must then refuse
   the evidence. *)
let prove ?(lenient = false) ?forge ?split_forge (claim : Formats.claim) ~most =
  let plan = plan_of ?forge ?split_forge claim ~most in
  let found = search_pairs ~lenient plan ~most in
  (plan.completed (Search.pairs_record found plan.choose), plan.nodes, found)

(* Applies a check of systems at the level of the claim. Both sides of a claim have the same level. *)
let on_one subject check =
  match subject with System system -> check system | Split_term (script, split) -> certify_script script split check

let on_both spec impl check =
  match (spec, impl) with
  | System spec, System impl -> check spec impl
  | Split_term (spec, xs), Split_term (impl, xi) -> certify_scripts spec xs impl xi check
  | _ -> false

(* Runs the verified check. The theorems `program_sound` and `script_sound` state what its answer `true` means. Only this
   answer certifies a claim. *)
let accepted ?reduction = function
  | Of_refinement (model, spec_shape, spec, shape, impl, normal, evidence, pairs) ->
      on_both spec impl (fun spec impl -> certify_refinement model spec_shape spec shape impl reduction normal evidence pairs)
  | Of_property (property, shape, impl, pairs) -> on_one impl (fun impl -> certify_property property shape impl reduction pairs)
  | Of_determinism (model, graph_shape, graph, shape, impl, normal, evidence, pairs) ->
      on_one impl (fun impl -> certify_determinism model graph_shape graph shape impl reduction normal evidence pairs)
  | Of_possible (goal, shape, impl, numbering) -> on_one impl (fun impl -> certify_possible goal shape impl numbering)
  | Of_trace (events, shape, impl, run) -> on_one impl (fun impl -> certify_trace events shape impl run)
  | Of_refutation (model, spec_shape, spec, shape, impl, refutation, pairs) ->
      on_both spec impl (fun spec impl -> certify_refutation model spec_shape spec shape impl refutation pairs)

(* Returns which part of the check refuses. *)
let first_refused proof =
  let system = function System system -> system | Split_term (script, split) -> split_system script.defines split in
  let split = function System _ -> true | Split_term (script, split) -> split_ok script.defines split script.main in
  let refused (name, shape, subject) =
    if not (split subject) then Some "the check refuses the components of a term"
    else if not (shape_ok shape (system subject)) then Some (name ^ " is not a well-formed process")
    else None
  in
  let first sides otherwise = Option.value ~default:otherwise (List.find_map refused sides) in
  match proof with
  | Of_refinement (model, spec_shape, spec, shape, impl, normal, evidence, _) -> (
      match List.find_map refused [ ("the specification", spec_shape, spec); ("the implementation", shape, impl) ] with
      | Some why -> why
      | None when check_specification (compact spec_shape (system spec)) eq_words normal evidence model -> "the check refuses the pairs"
      | None -> "the check refuses the normal form of the specification")
  | Of_property (_, shape, impl, _) -> first [ ("the implementation", shape, impl) ] "the check refuses the pairs"
  | Of_determinism (_, _, _, shape, impl, _, _, _) | Of_possible (_, shape, impl, _) | Of_trace (_, shape, impl, _) ->
      first [ ("the implementation", shape, impl) ] "the check refuses the evidence"
  | Of_refutation (_, spec_shape, spec, shape, impl, _, _) ->
      first [ ("the specification", spec_shape, spec); ("the implementation", shape, impl) ] "the check refuses the evidence"

let guarded f =
  try f () with
  | Formats.Unreadable why -> Refused why
  | Search.Refuted why -> Refused why
  | Search.Limit why -> Undecided why
  | Stack_overflow -> Undecided "the stack is too small"
  | Out_of_memory -> Undecided "there is no more memory"
  | Invalid_argument _ | Not_found | Failure _ | Division_by_zero -> Refused "the evidence is malformed"

(* Returns exchanges of equal parts of the implementation. *)
let exchanges_of plan ~indifferent =
  let { merges; packs } = plan.shape in
  Symmetric.exchanges_of (merged merges plan.process.system) plan.process.sizes merges packs plan.nodes indifferent

(* Returns the reductions that make the search smaller, with their names. *)
let reduction_for (claim : Formats.claim) plan =
  let process = plan.process in
  if not (shape_ok plan.shape process.system) then None
  else
    let system = merged plan.shape.merges process.system in
    let any = claim.question = Formats.Property Deadlock_free in
    let indifferent g = match plan.normal with None -> true | Some normal -> indifferent_to normal g in
    let confluent = Follow.steps_of system process.sizes plan.shape.packs (compact plan.shape process.system) ~any in
    let exchanges = if plain system then exchanges_of plan ~indifferent else None in
    let symmetric, turns = Option.value ~default:([], fun _ -> []) exchanges in
    match (if Option.is_some confluent then [ "confluent taus" ] else []) @ if symmetric = [] then [] else [ "symmetry" ] with
    | [] -> None
    | names -> Some ({ confluent; symmetric; turns }, names)

(* Finds the pairs while the check visits them. Returns the search, and whether the check accepts. *)
let check_on_the_way ?reduction plan ~most =
  let walk = Search.new_walk (width plan.shape) in
  let ordered = plan.task.forbid_cycles in
  let proof = plan.completed (Search.pairs_on_the_way walk plan.choose ~ordered ~most) in
  (walk, proof, try accepted ?reduction proof with Search.Loop_of_taus -> false)

(* If the check refuses, another search without a reduction finds the run to the violation. *)
let certify_on_the_way ~reduce (claim : Formats.claim) ~most =
  let plan = plan_of claim ~most in
  let found = if reduce then reduction_for claim plan else None in
  let reduction = Option.map fst found in
  let certified (walk : Search.walk) reductions =
    Certified
      { pairs = walk.pairs.filled; nodes = Array.length plan.nodes; transitions = walk.moves_seen;
        components = Array.length plan.process.component_names; rules = plan.process.rule_count; reductions }
  in
  let walk, proof, accepts = check_on_the_way ?reduction plan ~most in
  if accepts then certified walk (match found with None -> [] | Some (_, names) -> names)
  else begin
    ignore (search_pairs plan ~most);
    if reduction = None then Refused (first_refused proof)
    else
      let walk, proof, accepts = check_on_the_way plan ~most in
      if accepts then certified walk [] else Refused (first_refused proof)
  end

(* The steps of a search for a violation, which shows that a refinement fails. *)
type shown = { refutation : int list refutation; trace : int list; performs : bool }

let shown_by run performs refutation = { refutation; trace = Search.visible run; performs }

(* Finds a violation of the refinement. *)
let violation_of lts width (task : Search.task) ~most =
  let found = Search.new_found width true in
  match
    Search.explore lts task found ~most ~lenient:false;
    if task.forbid_cycles then Search.set_ranks found ~lenient:false
  with
  | () -> None
  | exception Search.Violation_at (j, _) ->
      let run = Search.moves_to found j and state = Search.words_at found.store j in
      let node = Search.node_at found.store j and moves = lts.succ0 state in
      let forbidden (a, _) = a <> 0 && task.next node a = None in
      if task.state_fault node moves <> None then Some (shown_by run false (By_refusal run))
      else (
        match List.find_opt forbidden moves with
        | Some move -> Some (shown_by (run @ [ move ]) true (By_event (run @ [ move ])))
        | None -> Some (shown_by run false (By_divergence (run, Search.tau_loop lts width state ~most))))

(* The states of the specification after the prefixes of the trace. *)
let prefixes_task model shown : Search.task =
  let trace = Array.of_list shown.trace in
  let length = Array.length trace in
  { next = (fun n a -> if n < length && trace.(n) = a then Some (n + 1) else Some (-1));
    stopped = (fun n -> n < 0);
    state_fault = (fun n _ -> if shown.performs && n = length then Some "it performs these events, too" else None);
    forbid_cycles = model = FD;
    event_fault = (fun _ _ -> "") }

let refutation_of ?(lenient = false) (claim : Formats.claim) model (spec : side) (impl : side) shown ~most =
  let absent =
    Search.pairs_for ~lenient (lts_of spec) (width spec.shape) (prefixes_task model shown) ~most ~name:claim.event_name
      ~state_name:(state_name spec.process spec.shape)
  in
  (Of_refutation (model, spec.shape, spec.subject, impl.shape, impl.subject, shown.refutation,
                  Search.pairs_record absent (fun _ _ -> 0)), absent)

(* The evidence for a claim that a run or the distances of states show. *)
type shown_claim = {
  proof : proof;
  implementation : Formats.process;
  visited : Search.found option;  (** the states with distances, or the pairs that show the absence of a run *)
  pair_count : int;
}

(* Finds the evidence for such a claim. *)
let show ?split_forge (claim : Formats.claim) ~most =
  let side_of given = side_of ?forge:split_forge given ~event_count:claim.event_count ~most in
  let impl = side_of claim.implementation in
  let lts = lts_of impl and name = claim.event_name in
  let visited proof (found : Search.found) =
    { proof; implementation = impl.process; visited = Some found; pair_count = found.store.filled } in
  match (claim.question, claim.specification) with
  | Formats.Stays_possible, None -> (
      match Search.distances lts (width impl.shape) claim.events ~most ~name ~state_name:(state_name impl.process impl.shape) with
      | _, _, Some fault -> raise (Search.Refuted fault)
      | found, distance, None ->
          visited (Of_possible (claim.events, impl.shape, impl.subject, Search.numbering_of found distance)) found)
  | Has_trace, None -> (
      match Search.run_with lts (width impl.shape) claim.events ~most with
      | None -> raise (Search.Refuted "it cannot perform these events in this order")
      | Some run ->
          { proof = Of_trace (claim.events, impl.shape, impl.subject, run); implementation = impl.process; visited = None;
            pair_count = List.length run + 1 })
  | No_refinement model, Some given -> (
      let spec = side_of given in
      let n = normalised claim model spec ~forge:Fun.id ~most in
      match violation_of lts (width impl.shape) n.refinement ~most with
      | None -> raise (Search.Refuted "the refinement holds")
      | Some shown ->
          let proof, absent = refutation_of claim model spec impl shown ~most in
          visited proof absent)
  | _ -> raise (Formats.Unreadable "the parts of the certificate do not belong to its claim")

let certify ?(reduce = true) (claim : Formats.claim) ~most =
  guarded (fun () ->
      match claim.question with
      | Refinement _ | Property _ | Determinism _ -> certify_on_the_way ~reduce claim ~most
      | Stays_possible | Has_trace | No_refinement _ ->
          let shown = show claim ~most in
          if accepted shown.proof then
            Certified
              { pairs = shown.pair_count; nodes = 0; transitions = 0; components = Array.length shown.implementation.component_names;
                rules = shown.implementation.rule_count; reductions = [] }
          else Refused (first_refused shown.proof))
