(* SPDX-License-Identifier: Apache-2.0 *)
(* Certifies one certificate: an untrusted search finds what the verified check needs, and the check decides. *)
open Verified

type 'a array = 'a Array.t

type figures = { pairs : int; nodes : int; transitions : int; components : int; rules : int }
type answer = Certified of figures | Refused of string

(* Everything that the theorem is applied to. *)
type proof =
  | Of_refinement of model * layout * system * layout * system * normal_form * int list evidence * int list pairs
  | Of_property of property * layout * system * int list pairs

(* The groups of components whose states fit into one word. *)
let layout_of (process : Formats.process) event_count =
  let limit = 1 lsl 61 in
  let add (groups, group, volume) size =
    if size > 0 && volume > limit / size then (List.rev group :: groups, [ size ], size)
    else (groups, size :: group, volume * max 1 size)
  in
  let groups, group, _ = List.fold_left add ([], [], 1) process.sizes in
  { groups = List.rev (List.rev group :: groups); event_count }

let width layout = List.length layout.groups

(* The state of each component, in words. *)
let state_name (process : Formats.process) layout words =
  let locals =
    List.concat
      (List.map2 (fun group word -> snd (List.fold_left (fun (word, locals) size -> (word / size, locals @ [ word mod size ])) (word, []) group))
         layout.groups words)
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

(* Finds the evidence. `lenient` overlooks violations: for tests, which must be refused then. *)
let prove ?(lenient = false) ?(forge = Fun.id) (claim : Formats.claim) ~most =
  let name = claim.event_name in
  let impl = claim.implementation in
  let layout = layout_of impl claim.event_count in
  let lts = packed layout impl.system in
  let find task = Search.pairs_for ~lenient lts (width layout) task ~most ~name ~state_name:(state_name impl layout) in
  let figures (found : Search.found) nodes =
    { pairs = found.store.filled; nodes; transitions = found.transitions;
      components = Array.length impl.component_names; rules = impl.rule_count }
  in
  match (claim.question, claim.specification) with
  | Refinement model, Some spec ->
      let spec_layout = layout_of spec claim.event_count in
      let spec_lts = packed spec_layout spec.system in
      let graph = Search.new_graph spec_lts.succ0 in
      let nodes = forge (Search.normalise graph spec_lts.init model ~most) in
      let normal = Search.normal_form_of nodes in
      let choose = Search.chooser nodes claim.event_count in
      let found = find (refinement_task nodes normal model choose name) in
      let evidence = Search.evidence_of graph spec_lts.init nodes in
      let pairs = Search.pairs_record found choose in
      ( Of_refinement (model, spec_layout, spec.system, layout, impl.system, normal, evidence, pairs),
        figures found (Array.length nodes), nodes, found )
  | Property property, None ->
      let found = find (property_task property) in
      let pairs = Search.pairs_record found (fun _ _ -> 0) in
      (Of_property (property, layout, impl.system, pairs), figures found 0, [||], found)
  | _ -> raise (Formats.Unreadable "a specification belongs to a refinement, and to nothing else")

(* The theorem `program_sound` says what `true` means here. Nothing else certifies. *)
let accepted = function
  | Of_refinement (model, spec_layout, spec, layout, impl, normal, evidence, pairs) ->
      certify_refinement model spec_layout spec layout impl normal evidence pairs
  | Of_property (property, layout, impl, pairs) -> certify_property property layout impl pairs

(* Which condition of the check breaks. *)
let first_refused (claim : Formats.claim) proof =
  let rec first chk count i = if i >= count then None else if chk i then first chk count (i + 1) else Some i in
  let pair chk layout (pairs : int list pairs) =
    match first chk pairs.count 0 with
    | Some i ->
        Printf.sprintf "the check refuses pair %d: %s with node %d" i
          (state_name claim.implementation layout (pairs.state_of i))
          (pairs.node_of i)
    | None -> "the check refuses the initial pair"
  in
  match proof with
  | Of_refinement (model, spec_layout, spec, layout, impl, normal, evidence, pairs) ->
      if not (system_ok spec_layout spec) then "the specification is not a well-formed process"
      else if not (system_ok layout impl) then "the implementation is not a well-formed process"
      else if not (check_specification (packed spec_layout spec) eq_words normal evidence model) then
        "the check refuses the normal form of the specification"
      else pair (check_pair (packed layout impl) eq_words normal model pairs) layout pairs
  | Of_property (property, layout, impl, pairs) ->
      if not (system_ok layout impl) then "the process is not well-formed"
      else pair (check_state (packed layout impl) eq_words property pairs) layout pairs

let guarded f =
  try f () with
  | Formats.Unreadable why -> Refused why
  | Search.Refuted why -> Refused why
  | Search.Limit why -> Refused ("not decided: " ^ why)
  | Stack_overflow -> Refused "not decided: the stack is too small"
  | Out_of_memory -> Refused "not decided: there is no more memory"
  | Invalid_argument _ | Not_found | Failure _ | Division_by_zero -> Refused "the evidence is malformed"

let certify claim ~most =
  guarded (fun () ->
      let proof, figures, _, _ = prove claim ~most in
      if accepted proof then Certified figures else Refused (first_refused claim proof))
