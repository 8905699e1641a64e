(* SPDX-License-Identifier: Apache-2.0 *)
(* Reads the files of a certificate (docs/certificates.md). This file must be trusted, because it determines what the
   files mean. *)
open Verified

type 'a array = 'a Array.t

exception Unreadable of string

let unreadable format = Printf.ksprintf (fun text -> raise (Unreadable text)) format

let read_file path =
  match open_in_bin path with
  | exception Sys_error why -> unreadable "%s" why
  | channel ->
      Fun.protect
        ~finally:(fun () -> close_in_noerr channel)
        (fun () ->
          try really_input_string channel (in_channel_length channel)
          with End_of_file | Sys_error _ | Invalid_argument _ -> unreadable "%s: cannot be read" path)

(* The lines of a text, which are read one after the other. Each line ends with a line feed. *)
type lines = { text : string; mutable at : int; mutable number : int; file : string }

let lines_of file text = { text; at = 0; number = 0; file }
let fail lines why = unreadable "%s, line %d: %s" lines.file lines.number why

let next_line lines =
  lines.number <- lines.number + 1;
  match String.index_from_opt lines.text lines.at '\n' with
  | None -> fail lines "the file ends too early"
  | Some stop ->
      let line = String.sub lines.text lines.at (stop - lines.at) in
      lines.at <- stop + 1;
      line

let words line = String.split_on_char ' ' line

let number lines word =
  let digits = String.length word in
  if digits = 0 || digits > 10 then fail lines "a number was expected";
  String.fold_left
    (fun value c -> match c with '0' .. '9' -> (10 * value) + Char.code c - 48 | _ -> fail lines "a number was expected")
    0 word

let numbers lines line = if line = "" then [] else List.map (number lines) (words line)

let rec pairs_of lines = function
  | [] -> []
  | a :: b :: rest -> (a, b) :: pairs_of lines rest
  | [ _ ] -> fail lines "numbers come in pairs"

(* Reads the rest of a line after a keyword. *)
let keyword lines word =
  let line = next_line lines in
  let length = String.length word in
  if line = word then ""
  else if String.length line > length && String.sub line 0 (length + 1) = word ^ " " then
    String.sub line (length + 1) (String.length line - length - 1)
  else fail lines ("`" ^ word ^ "` was expected")

let count lines word =
  let n = number lines (keyword lines word) in
  if n > String.length lines.text then fail lines "there are fewer lines than this";
  n

(* Does the same as `List.init`, but always in ascending order. *)
let times n f =
  let rec from i found = if i = n then List.rev found else from (i + 1) (f () :: found) in
  from 0 []

(* The numbers of events, which are used for both systems: equal names have equal numbers. *)
type names = { numbers : (string, int) Hashtbl.t; mutable texts : string list; mutable next : int }

let no_names () = { numbers = Hashtbl.create 100; texts = []; next = 2 }

let number_of names name =
  match Hashtbl.find_opt names.numbers name with
  | Some n -> n
  | None ->
      let n = names.next in
      names.next <- n + 1;
      names.texts <- name :: names.texts;
      Hashtbl.add names.numbers name n;
      n

let name_of names =
  let texts = Array.of_list (List.rev names.texts) in
  fun event -> if event = 0 then "\xcf\x84" else if event = 1 then "\xe2\x9c\x93" else texts.(event - 2)

type process = {
  system : system;
  sizes : int list;  (** by component: the number of its states *)
  component_names : string array;
  component_edges : (int * int) list array array;
  rule_count : int;
}

let read_events names lines =
  let distinct = Hashtbl.create 100 in
  let events =
    times (count lines "events") (fun () ->
        let name = next_line lines in
        if Hashtbl.mem distinct name then fail lines "an event is listed twice";
        Hashtbl.add distinct name ();
        number_of names name)
  in
  let events = Array.of_list (0 :: 1 :: events) in
  fun event -> if event < Array.length events then events.(event) else fail lines "there is no such event"

let read_component event lines =
  let head = keyword lines "component" in
  match words head with
  | size :: start :: name ->
      let size = number lines size and start = number lines start in
      if size > String.length lines.text then fail lines "there are fewer lines than this";
      let edges _ = List.map (fun (e, target) -> (event e, target)) (pairs_of lines (numbers lines (next_line lines))) in
      (Array.init size edges, start, String.concat " " name)
  | _ -> fail lines "a component has a size and an initial state"

(* Reads a rule: its event, its level or `-`, the number of requirements, the requirements, and the assignments. *)
let read_rule event lines =
  match words (keyword lines "rule") with
  | does :: level :: asked :: rest ->
      let level = if level = "-" then None else Some (number lines level) in
      let asked = number lines asked in
      let rest = pairs_of lines (List.map (number lines) rest) in
      if List.length rest < asked then fail lines "a rule has fewer requirements than it says";
      let asks = List.filteri (fun i _ -> i < asked) rest and puts = List.filteri (fun i _ -> i >= asked) rest in
      { does = event (number lines does); level; asks = List.map (fun (i, e) -> (i, event e)) asks; puts }
  | _ -> fail lines "a rule has an event, a level and requirements"

let rec read_region event lines header rules_read =
  match pairs_of lines (numbers lines header) with
  | [ (participants, rules) ] ->
      if participants + rules > String.length lines.text then fail lines "there are fewer lines than this";
      let inside =
        times participants (fun () ->
            let line = next_line lines in
            match words line with
            | [ "slot"; k ] -> Slot (number lines k)
            | [ "region"; p; r ] -> Inner (read_region event lines (p ^ " " ^ r) rules_read)
            | _ -> fail lines "a slot or a region was expected")
      in
      rules_read := !rules_read + rules;
      Region (inside, times rules (fun () -> read_rule event lines))
  | _ -> fail lines "a region has numbers of participants and rules"

let read_process names file text =
  let lines = lines_of file text in
  if next_line lines <> "robochart-verify process 1" then fail lines "this is not a process of version 1";
  let event = read_events names lines in
  let components = times (count lines "components") (fun () -> read_component event lines) in
  let rule_count = ref 0 in
  let whole = read_region event lines (keyword lines "region") rule_count in
  if next_line lines <> "end" then fail lines "`end` was expected";
  if lines.at <> String.length text then fail lines "the file goes on after its end";
  let component_edges = Array.of_list (List.map (fun (edges, _, _) -> edges) components) in
  let edges k v =
    if k < 0 || k >= Array.length component_edges then []
    else
      let rows = component_edges.(k) in
      if v < 0 || v >= Array.length rows then [] else rows.(v)
  in
  { system = { edges; start = List.map (fun (_, start, _) -> start) components; whole };
    sizes = List.map (fun (rows, _, _) -> Array.length rows) components;
    component_names = Array.of_list (List.map (fun (_, _, name) -> name) components);
    component_edges; rule_count = !rule_count }

(* Reads a list of events, in order. An event may occur more than once. *)
let read_event_list names file text =
  let lines = lines_of file text in
  if next_line lines <> "robochart-verify events 1" then fail lines "this is not a list of events of version 1";
  let events = times (count lines "events") (fun () -> number_of names (next_line lines)) in
  if next_line lines <> "end" then fail lines "`end` was expected";
  if lines.at <> String.length text then fail lines "the file goes on after its end";
  events

(* The kind of the claim. *)
type question =
  | Refinement of model
  | Property of property
  | Determinism of model
  | Stays_possible
  | Has_trace
  | No_refinement of model

let questions =
  [ ("refinement in the traces model", Refinement T);
    ("refinement in the failures model", Refinement F);
    ("refinement in the failures-divergences model", Refinement FD);
    ("deadlock freedom", Property Deadlock_free);
    ("deadlock and divergence freedom", Property Deadlock_and_divergence_free);
    ("divergence freedom", Property Divergence_free);
    ("determinism in the failures model", Determinism F);
    ("determinism in the failures-divergences model", Determinism FD);
    ("one of the events stays possible", Stays_possible);
    ("the events are a trace", Has_trace);
    ("no refinement in the traces model", No_refinement T);
    ("no refinement in the failures model", No_refinement F);
    ("no refinement in the failures-divergences model", No_refinement FD) ]

type claim = {
  question : question;
  question_text : string;
  assertion : string;
  source : string;
  specification : process option;  (** only for a refinement, and for one that fails *)
  events : int list;  (** the events that stay possible, or the trace *)
  implementation : process;
  event_name : int -> string;
  event_count : int;
}

(* Reads a file that the claim names, and compares its digest with the claim. *)
let read_part folder file digest =
  let text = read_file (Filename.concat folder file) in
  if Sha256.hex text <> digest then unreadable "%s: its digest is not that in claim.txt" file;
  text

let read_claim folder =
  let file = "claim.txt" in
  let text = read_file (Filename.concat folder file) in
  let lines = lines_of file text in
  if next_line lines <> "robochart-verify certificate 1" then fail lines "this is not a certificate of version 1";
  let question_text = keyword lines "claim:" in
  let assertion = keyword lines "assertion:" in
  let source = keyword lines "source:" in
  let _source_digest = keyword lines "source-sha256:" in
  if keyword lines "level:" <> "product, unreduced" then fail lines "this certificate is of another level";
  let specification = keyword lines "specification-sha256:" in
  let implementation = keyword lines "implementation-sha256:" in
  let covered = String.sub text 0 lines.at in
  if keyword lines "end-sha256:" <> Sha256.hex covered then fail lines "the digest of the lines above is another one";
  if lines.at <> String.length text then fail lines "the file goes on after its end";
  let question =
    match List.assoc_opt question_text questions with
    | Some question -> question
    | None -> unreadable "%s: the claim `%s` is not known" file question_text
  in
  let names = no_names () in
  let read file digest = read_process names file (read_part folder file digest) in
  let specification, events =
    match question with
    | Refinement _ | No_refinement _ -> (Some (read "specification.txt" specification), [])
    | Stays_possible | Has_trace ->
        let part = "specification.txt" in
        (None, read_event_list names part (read_part folder part specification))
    | Property _ | Determinism _ ->
        if specification = "-" then (None, []) else unreadable "%s: a property has no specification" file
  in
  let implementation = read "implementation.txt" implementation in
  { question; question_text; assertion; source; specification; events; implementation; event_name = name_of names;
    event_count = names.next }
