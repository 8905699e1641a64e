(* SPDX-License-Identifier: Apache-2.0 *)
(* Certifies one certificate: an untrusted search finds what the verified check needs, and the check decides. *)
open Verified

type 'a array = 'a Array.t

type figures = { pairs : int; nodes : int; transitions : int; components : int; rules : int; reduced : bool }
type answer = Certified of figures | Refused of string | Undecided of string

(* A side of the claim: a compiled process, or a term and how it is split. *)
type subject = System of system | Split_term of script * split

(* The data to which the theorems are applied. *)
type proof =
  | Of_refinement of model * shape * subject * shape * subject * normal_form * int list evidence * int list pairs
  | Of_property of property * shape * subject * int list pairs

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

let plan_of ?(forge = Fun.id) ?split_forge (claim : Formats.claim) ~most =
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

let guarded f =
  try f () with
  | Formats.Unreadable why -> Refused why
  | Search.Refuted why -> Refused why
  | Search.Limit why -> Undecided why
  | Stack_overflow -> Undecided "the stack is too small"
  | Out_of_memory -> Undecided "there is no more memory"
  | Invalid_argument _ | Not_found | Failure _ | Division_by_zero -> Refused "the evidence is malformed"

(* Returns which steps of the implementation are followed, if that makes the search smaller. *)
let reduction_for (claim : Formats.claim) plan =
  let process = plan.process in
  let any = claim.question = Formats.Property Deadlock_free in
  if not (shape_ok plan.shape process.system) then None
  else
    Follow.reduction_of (merged plan.shape.merges process.system) process.sizes plan.shape.packs
      (compact plan.shape process.system) ~any

(* Finds the pairs while the check visits them. Returns the search, and whether the check accepts. *)
let check_on_the_way ?reduction plan ~most =
  let walk = Search.new_walk (width plan.shape) in
  let ordered = plan.task.forbid_cycles in
  let proof = plan.completed (Search.pairs_on_the_way walk plan.choose ~ordered ~most) in
  (walk, proof, try accepted ?reduction proof with Search.Loop_of_taus -> false)

(* If the check refuses, another search without a reduction finds the run to the violation. *)
let certify ?(reduce = true) (claim : Formats.claim) ~most =
  guarded (fun () ->
      let plan = plan_of claim ~most in
      let reduction = if reduce then reduction_for claim plan else None in
      let certified (walk : Search.walk) ~reduced =
        Certified
          { pairs = walk.pairs.filled; nodes = Array.length plan.nodes; transitions = walk.moves_seen;
            components = Array.length plan.process.component_names; rules = plan.process.rule_count; reduced }
      in
      let walk, proof, accepts = check_on_the_way ?reduction plan ~most in
      if accepts then certified walk ~reduced:(reduction <> None)
      else begin
        ignore (search_pairs plan ~most);
        if reduction = None then Refused (first_refused proof)
        else
          let walk, proof, accepts = check_on_the_way plan ~most in
          if accepts then certified walk ~reduced:false else Refused (first_refused proof)
      end)
