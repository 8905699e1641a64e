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
  | Of_determinism of model * shape * choiceless * shape * system * normal_form * int list evidence * int list pairs
  | Of_possible of int list * shape * system * int list numbering
  | Of_trace of int list * shape * system * (int * int list) list
  | Of_refutation of model * shape * system * shape * system * int list refutation * int list pairs

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
  let locals =
    List.concat
      (List.map2 (fun group word -> snd (List.fold_left (fun (word, locals) bits -> (word lsr bits, locals @ [ word land ((1 lsl bits) - 1) ])) (word, []) group))
         shape.packs.groups words)
  in
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

(* Returns the process of a side, and what the theorem is about. *)
let process_of ?forge side ~event_count ~most : Formats.process * subject =
  match side with
  | Formats.Compiled process -> (process, System process.system)
  | Formats.Term text ->
      let split, process = Splitter.split ?forge text ~event_count ~most in
      (process, Split_term (text.script, split))

(* What the search needs to check the implementation, from the claim and its specification. *)
type plan = {
  process : Formats.process;  (** the implementation *)
  shape : shape;
  name : int -> string;
  task : Search.task;
  choose : int -> (int * Search.words) list -> int;
  nodes : Search.node array;
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

(* Returns the process of a claim that has no certificates at the term level. *)
let compiled = function
  | Formats.Compiled process -> process
  | Formats.Term _ -> raise (Formats.Unreadable "a certificate of this kind of claim contains compiled processes")

let rec plan_of ?(forge = Fun.id) ?split_forge ?(forge_graph = Fun.id) (claim : Formats.claim) ~most =
  let name = claim.event_name in
  let process_of side = process_of ?forge:split_forge side ~event_count:claim.event_count ~most in
  let process, impl = process_of claim.implementation in
  let shape = shape_of process claim.event_count in
  match (claim.question, claim.specification) with
  | Refinement model, Some side ->
      let spec, subject = process_of side in
      let spec_shape = shape_of spec claim.event_count in
      let spec_lts = compact spec_shape spec.system in
      let graph = Search.new_graph spec_lts.succ0 in
      let nodes = forge (Search.normalise graph spec_lts.init model ~most) in
      let normal = Search.normal_form_of nodes in
      let choose = Search.chooser nodes claim.event_count in
      let evidence = Search.evidence_of graph spec_lts.init nodes in
      { process; shape; name; task = refinement_task nodes normal model choose name; choose; nodes;
        completed = (fun pairs -> Of_refinement (model, spec_shape, subject, shape, impl, normal, evidence, pairs)) }
  | Property property, None ->
      { process; shape; name; task = property_task property; choose = (fun _ _ -> 0); nodes = [||];
        completed = (fun pairs -> Of_property (property, shape, impl, pairs)) }
  | Determinism model, None ->
      let system = (compiled claim.implementation).system in
      let lts = compact shape system in
      let rows = forge_graph (Search.without_choices (Search.new_graph lts.succ0) lts.init ~most) in
      let graph, own = choiceless_process claim.event_count rows in
      let refinement = { claim with question = Refinement model; specification = Some (Formats.Compiled own) } in
      let plan = plan_of ~forge refinement ~most in
      let completed pairs =
        match plan.completed pairs with
        | Of_refinement (m, graph_shape, _, shape, _, normal, evidence, pairs) ->
            Of_determinism (m, graph_shape, graph, shape, system, normal, evidence, pairs)
        | other -> other
      in
      { plan with task = determinism_task plan.nodes plan.task name; completed }
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

(* Runs the verified check. The theorems `program_sound` and `script_sound` state what its answer `true` means. Only this
   answer certifies a claim. *)
let accepted ?reduction = function
  | Of_refinement (model, spec_shape, System spec, shape, System impl, normal, evidence, pairs) ->
      certify_refinement model spec_shape spec shape impl reduction normal evidence pairs
  | Of_refinement (model, spec_shape, Split_term (spec, xs), shape, Split_term (impl, xi), normal, evidence, pairs) ->
      certify_scripts model spec xs spec_shape impl xi shape reduction normal evidence pairs
  | Of_refinement _ -> false
  | Of_property (property, shape, System impl, pairs) -> certify_property property shape impl reduction pairs
  | Of_property (property, shape, Split_term (impl, x), pairs) -> certify_script property impl x shape reduction pairs
  | Of_determinism (model, graph_shape, graph, shape, impl, normal, evidence, pairs) ->
      certify_determinism model graph_shape graph shape impl reduction normal evidence pairs
  | Of_possible (goal, shape, impl, numbering) -> certify_possible goal shape impl numbering
  | Of_trace (events, shape, impl, run) -> certify_trace events shape impl run
  | Of_refutation (model, spec_shape, spec, shape, impl, refutation, pairs) ->
      certify_refutation model spec_shape spec shape impl refutation pairs

(* Returns which part of the check refuses. *)
let first_refused proof =
  let system = function System system -> system | Split_term (script, split) -> split_system script.defines split in
  let split = function System _ -> true | Split_term (script, split) -> split_ok script.defines split script.main in
  match proof with
  | Of_refinement (model, spec_shape, spec, shape, impl, normal, evidence, _) ->
      if not (split spec && split impl) then "the check refuses the components of a term"
      else if not (shape_ok spec_shape (system spec)) then "the specification is not a well-formed process"
      else if not (shape_ok shape (system impl)) then "the implementation is not a well-formed process"
      else if not (check_specification (compact spec_shape (system spec)) eq_words normal evidence model) then
        "the check refuses the normal form of the specification"
      else "the check refuses the pairs"
  | Of_property (_, shape, impl, _) ->
      if not (split impl) then "the check refuses the components of a term"
      else if not (shape_ok shape (system impl)) then "the process is not well-formed"
      else "the check refuses the pairs"
  | Of_determinism (_, _, _, shape, impl, _, _, _) | Of_possible (_, shape, impl, _) | Of_trace (_, shape, impl, _)
  | Of_refutation (_, _, _, shape, impl, _, _) ->
      if not (shape_ok shape impl) then "the process is not well-formed" else "the check refuses the evidence"

let guarded f =
  try f () with
  | Formats.Unreadable why -> Refused why
  | Search.Refuted why -> Refused why
  | Search.Limit why -> Undecided why
  | Stack_overflow -> Undecided "the stack is too small"
  | Out_of_memory -> Undecided "there is no more memory"
  | Invalid_argument _ | Not_found | Failure _ | Division_by_zero -> Refused "the evidence is malformed"

(* Returns the reductions that make the search smaller, with their names. *)
let reduction_for (claim : Formats.claim) plan =
  let process = plan.process and layout = plan.shape.packs in
  if not (shape_ok plan.shape process.system) then None
  else
    let system = merged plan.shape.merges process.system in
    let any = claim.question = Formats.Property Deadlock_free in
    let representative k v = if v < plan.shape.merges.merged_states k then plan.shape.merges.representative k v else v in
    let normal = if Array.length plan.nodes = 0 then None else Some (Search.normal_form_of plan.nodes) in
    let only g = { confluent = None; symmetric = [ g ]; turns = (fun _ -> []) } in
    let indifferent g = match normal with None -> true | Some normal -> indifferent_ok (only g) normal in
    let confluent = Follow.steps_of system process.sizes layout (compact plan.shape process.system) ~any in
    let exchanges = Symmetric.exchanges_of system process.sizes representative layout (Follow.fields_of layout) plan.nodes indifferent in
    match (confluent, exchanges) with
    | None, None -> None
    | Some _, None -> Some ({ confluent; symmetric = []; turns = (fun _ -> []) }, [ "confluent taus" ])
    | _, Some (symmetric, turns) ->
        Some ({ confluent; symmetric; turns }, (if confluent = None then [] else [ "confluent taus" ]) @ [ "symmetry" ])

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
let violation_of lts width (plan : plan) ~most =
  let found = Search.new_found width true in
  match
    Search.explore lts plan.task found ~most ~lenient:false;
    if plan.task.forbid_cycles then Search.set_ranks found ~lenient:false
  with
  | () -> None
  | exception Search.Violation_at (j, _) ->
      let run = Search.moves_to found j and state = Search.words_at found.store j in
      let node = Search.node_at found.store j and moves = lts.succ0 state in
      let forbidden (a, _) = a <> 0 && plan.task.next node a = None in
      if plan.task.state_fault node moves <> None then Some (shown_by run false (By_refusal run))
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

let refutation_of ?(lenient = false) (claim : Formats.claim) model (spec : Formats.process) shown ~most =
  let impl = compiled claim.implementation in
  let shape = shape_of impl claim.event_count and spec_shape = shape_of spec claim.event_count in
  let absent =
    Search.pairs_for ~lenient (compact spec_shape spec.system) (width spec_shape) (prefixes_task model shown) ~most
      ~name:claim.event_name ~state_name:(state_name spec spec_shape)
  in
  (Of_refutation (model, spec_shape, spec.system, shape, impl.system, shown.refutation,
                  Search.pairs_record absent (fun _ _ -> 0)), absent)

(* Finds the evidence for a claim that a run or the distances of states show. Returns it with the number of pairs. *)
let show (claim : Formats.claim) ~most =
  let impl = compiled claim.implementation in
  let shape = shape_of impl claim.event_count in
  let lts = compact shape impl.system and name = claim.event_name in
  match (claim.question, claim.specification) with
  | Formats.Stays_possible, _ -> (
      match Search.distances lts (width shape) claim.events ~most ~name ~state_name:(state_name impl shape) with
      | _, _, Some fault -> raise (Search.Refuted fault)
      | found, distance, None ->
          (Of_possible (claim.events, shape, impl.system, Search.numbering_of found distance), found.store.filled))
  | Has_trace, _ -> (
      match Search.run_with lts (width shape) claim.events ~most with
      | Some run -> (Of_trace (claim.events, shape, impl.system, run), List.length run + 1)
      | None -> raise (Search.Refuted "it cannot perform these events in this order"))
  | No_refinement model, Some spec -> (
      let plan = plan_of { claim with question = Refinement model } ~most in
      match violation_of lts (width shape) plan ~most with
      | None -> raise (Search.Refuted "the refinement holds")
      | Some shown ->
          let proof, absent = refutation_of claim model (compiled spec) shown ~most in
          (proof, absent.store.filled))
  | _ -> raise (Formats.Unreadable "the parts of the certificate do not belong to its claim")

let certify ?(reduce = true) (claim : Formats.claim) ~most =
  guarded (fun () ->
      match claim.question with
      | Refinement _ | Property _ | Determinism _ -> certify_on_the_way ~reduce claim ~most
      | Stays_possible | Has_trace | No_refinement _ ->
          let proof, pairs = show claim ~most in
          if accepted proof then
            let impl = compiled claim.implementation in
            Certified
              { pairs; nodes = 0; transitions = 0; components = Array.length impl.component_names; rules = impl.rule_count;
                reductions = [] }
          else Refused (first_refused proof))
