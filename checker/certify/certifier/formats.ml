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

let finish lines =
  if next_line lines <> "end" then fail lines "`end` was expected";
  if lines.at <> String.length lines.text then fail lines "the file goes on after its end"

(* Reads a compiled process after its first line. *)
let read_compiled names lines =
  let event = read_events names lines in
  let components = times (count lines "components") (fun () -> read_component event lines) in
  let rule_count = ref 0 in
  let whole = read_region event lines (keyword lines "region") rule_count in
  finish lines;
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

(* A term with its definitions, and the lengths of its tables. The texts of definitions are for readers only. *)
type script_text = { script : script; sets : int; renamings : int; orders : int; texts : string array }

(* Reads a set: `+` and its events, or `-` and the events outside of it. *)
let read_set event lines =
  let listed = Hashtbl.create 10 in
  let add words = List.iter (fun word -> Hashtbl.replace listed (event (number lines word)) ()) words in
  match words (next_line lines) with
  | "+" :: events -> add events; fun e -> Hashtbl.mem listed e
  | "-" :: events -> add events; fun e -> not (Hashtbl.mem listed e)
  | _ -> fail lines "a set was expected"

(* Reads pairs of an event and a number. Returns, by event, the numbers in order. *)
let read_relation event lines value =
  let found = Hashtbl.create 10 in
  let add (e, x) = Hashtbl.replace found (event e) (value x :: Option.value ~default:[] (Hashtbl.find_opt found (event e))) in
  List.iter add (List.rev (pairs_of lines (numbers lines (next_line lines))));
  fun e -> Option.value ~default:[] (Hashtbl.find_opt found e)

(* A table whose entries are found by number. *)
let read_table lines word read =
  let entries = Array.of_list (times (count lines word) read) in
  let check k = if k < Array.length entries then k else fail lines ("there are fewer " ^ word) in
  (Array.length entries, check, Array.get entries)

(* Reads an expression. A number denotes a call. *)
let read_term lines event definition set renaming order text =
  let left = ref (words text) in
  let word () = match !left with [] -> fail lines "a term ends too early" | word :: rest -> left := rest; word in
  let index check = check (number lines (word ())) in
  let rec term () =
    match word () with
    | "offer" ->
        let branches = number lines (word ()) in
        if branches > String.length text then fail lines "there are fewer branches than this";
        Offer (times branches (fun () -> let e = event (number lines (word ())) in (e, term ())))
    | "choice" -> let a = index set in let p = term () in Choice (a, p, term ())
    | "sliding" -> let p = term () in Sliding (p, term ())
    | "sequence" -> let p = term () in Sequence (p, term ())
    | "interrupt" -> let a = index set in let p = term () in Interrupt (a, p, term ())
    | "throw" -> let a = index set in let p = term () in Throw (a, p, term ())
    | "parallel" ->
        let a = index set in let b = index set in let c = index set in
        let p = term () in Parallel (a, b, c, p, term ())
    | "hide" -> let a = index set in Hide (a, term ())
    | "rename" -> let r = index renaming in Rename (r, term ())
    | "prioritise" -> let o = index order in Prioritise (o, term ())
    | name -> Call (definition (number lines name))
  in
  let result = term () in
  if !left <> [] then fail lines "a term goes on after its end";
  result

(* Reads a term with its definitions, after the first line. *)
let read_script names lines =
  let event = read_events names lines in
  let sets, set, has = read_table lines "sets" (fun () -> read_set event lines) in
  let renamings, renaming, names = read_table lines "renamings" (fun () -> read_relation event lines event) in
  let orders, order, levels = read_table lines "orders" (fun () -> read_relation event lines Fun.id) in
  let number_of_definitions = count lines "definitions" in
  let definition k = if k < number_of_definitions then k else fail lines "there are fewer definitions" in
  let term = read_term lines event definition set renaming order in
  let definitions =
    Array.of_list
      (times number_of_definitions (fun () ->
           let line = next_line lines in
           match String.index_opt line '#' with
           | Some at when at > 0 -> (term (String.sub line 0 (at - 1)), String.sub line (at + 1) (String.length line - at - 1))
           | _ -> (term line, "")))
  in
  let main = term (keyword lines "main") in
  finish lines;
  let priority o e = match levels o e with level :: _ -> Some level | [] -> None in
  { script = { defines = { body = (fun k -> fst definitions.(k)); has; names; priority }; main };
    sets; renamings; orders; texts = Array.map snd definitions }

type side = Compiled of process | Term of script_text

let level_of = function Compiled _ -> "product" | Term _ -> "term"

let read_side names file text =
  let lines = lines_of file text in
  match next_line lines with
  | "robochart-verify process 1" -> Compiled (read_compiled names lines)
  | "robochart-verify term 1" -> Term (read_script names lines)
  | _ -> fail lines "this is neither a process nor a term of version 1"

(* Reads a list of events, in order. An event may occur more than once. *)
let read_event_list names file text =
  let lines = lines_of file text in
  if next_line lines <> "robochart-verify events 1" then fail lines "this is not a list of events of version 1";
  let events = times (count lines "events") (fun () -> number_of names (next_line lines)) in
  finish lines;
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

(* Removes the suffix, which states how the processes of the certificate were made from those of the assertion. *)
let without_suffix text suffix =
  let length = String.length text - String.length suffix in
  if length >= 0 && String.sub text length (String.length suffix) = suffix then String.sub text 0 length else text

type claim = {
  question : question;
  question_text : string;
  assertion : string;
  source : string;
  specification : side option;  (** only for a refinement, and for one that fails *)
  events : int list;  (** the events that stay possible, or the trace *)
  implementation : side;
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
  let level = keyword lines "level:" in
  let specification = keyword lines "specification-sha256:" in
  let implementation = keyword lines "implementation-sha256:" in
  let covered = String.sub text 0 lines.at in
  if keyword lines "end-sha256:" <> Sha256.hex covered then fail lines "the digest of the lines above is another one";
  if lines.at <> String.length text then fail lines "the file goes on after its end";
  let question =
    match List.assoc_opt (without_suffix question_text " under tau priority") questions with
    | Some question -> question
    | None -> unreadable "%s: the claim `%s` is not known" file question_text
  in
  let names = no_names () in
  let read file digest =
    let side = read_side names file (read_part folder file digest) in
    if level <> level_of side ^ ", unreduced" then unreadable "%s: the level in claim.txt is another one" file;
    side
  in
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
