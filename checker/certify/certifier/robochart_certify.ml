(* SPDX-License-Identifier: Apache-2.0 *)
(* robochart-certify: accepts or refuses certificates (docs/certificates.md). *)
let usage =
  "usage: robochart-certify [--quiet] [--max-pairs N] [--no-reduction] FOLDER...\n\
  \       robochart-certify --answer [--max-pairs N] [--no-reduction] CERTIFICATE\n\
  \       robochart-certify --coq CERTIFICATE > File.v\n\
   Checks the certificates in the folders. Exit code 0: all are certified; 1: some are refused; 2: wrong use.\n"

(* What must be trusted, by the levels of the accepted certificates. *)
let trusted levels =
  let at level text = if List.mem level levels then text else "" in
  "Trusted: "
  ^ at "term" "at the term level, that robochart-verify read and evaluated the script to the terms in the certificates; "
  ^ at "product" "at the product level, that robochart-verify also compiled these terms to the processes in the certificates; "
  ^ "Coq and its extraction, OCaml, and this program's reader of files."

let wrong_use why =
  prerr_string ("robochart-certify: " ^ why ^ "\n" ^ usage);
  exit 2

(* Replaces control characters, so that none of them reaches a terminal. *)
let printable text = String.map (fun c -> if c < ' ' || c = '\127' then '?' else c) text

let is_certificate folder = Sys.file_exists (Filename.concat folder "claim.txt")

(* Lists the certificates in a folder. Folders whose names begin with a dot are unfinished certificates and are
   skipped. *)
let certificates_in path =
  if is_certificate path then [ path ]
  else
    let entries = try Sys.readdir path with Sys_error why -> wrong_use why in
    let folders = List.filter (fun e -> e.[0] <> '.') (Array.to_list entries) in
    let folders = List.map (Filename.concat path) folders in
    let folders = List.filter Sys.is_directory folders in
    let key folder = (try Scanf.sscanf (Filename.basename folder) "%d" Fun.id with _ -> max_int), folder in
    List.sort (fun a b -> compare (key a) (key b)) folders

let grouped n =
  let digits = string_of_int n in
  let length = String.length digits in
  String.concat "" (List.init length (fun i -> (if i > 0 && (length - i) mod 3 = 0 then "," else "") ^ String.make 1 digits.[i]))

let plural n word = Printf.sprintf "%s %s%s" (grouped n) word (if n = 1 then "" else "s")

let pairs_text (figures : Certificate_check.figures) =
  match figures.reductions with
  | [] -> "unreduced, " ^ plural figures.pairs "pair"
  | names -> Printf.sprintf "%s, reduced by %s" (plural figures.pairs "pair") (String.concat " and " names)

let decide ~most ~reduce folder =
  match Formats.read_claim folder with
  | exception Formats.Unreadable why -> ("", "", Certificate_check.Refused why)
  | claim -> (claim.source, Formats.level_of claim.implementation, Certificate_check.certify claim ~reduce ~most)

(* Prints the answer. Returns the level of an accepted certificate. *)
let show ~most ~reduce ~quiet folder =
  let source, level, answer = decide ~most ~reduce folder in
  let refuse why =
    Printf.printf "REFUSED    %s: %s%s\n%!" (printable folder)
      (if source = "" then "" else printable source ^ ": ")
      (printable why);
    None
  in
  match answer with
  | Certificate_check.Certified figures ->
      if not quiet then
        Printf.printf "CERTIFIED  %s: %s: %s level, %s, %s\n%!" (printable folder) (printable source) level
          (pairs_text figures) (plural figures.components "component");
      Some level
  | Refused why -> refuse why
  | Undecided why -> refuse ("not decided: " ^ why)

(* Prints one line for programs: a word, and figures or the reason. *)
let print_answer folder ~most ~reduce =
  let line, code =
    match decide ~most ~reduce folder with
    | _, _, Certificate_check.Certified figures ->
        let reductions = String.concat " and " figures.reductions in
        let reductions = if reductions = "" then "" else " " ^ reductions in
        (Printf.sprintf "certified %d %d%s" figures.pairs figures.components reductions, 0)
    | _, _, Refused why -> ("refused " ^ printable why, 1)
    | _, _, Undecided why -> ("undecided " ^ printable why, 1)
  in
  print_endline line;
  exit code

let check_all paths ~most ~reduce ~quiet =
  let folders = List.concat_map certificates_in paths in
  if folders = [] then wrong_use "there are no certificates";
  let levels = List.filter_map (show ~most ~reduce ~quiet) folders in
  let refused = List.length folders - List.length levels in
  Printf.printf "%s certified, %d refused\n" (grouped (List.length folders - refused)) refused;
  if not quiet then print_endline (trusted levels);
  exit (if refused = 0 then 0 else 1)

let print_theorem folder ~most =
  match
    let claim = Formats.read_claim folder in
    Coq_form.theorem claim ~most
  with
  | text -> print_string text
  | exception Formats.Unreadable why | exception Search.Refuted why | exception Search.Limit why ->
      prerr_endline ("robochart-certify: " ^ printable why);
      exit 1
  | exception Stack_overflow ->
      prerr_endline "robochart-certify: the certificate is too large for the Coq form";
      exit 1

let () = Gc.set { (Gc.get ()) with space_overhead = 50 }

type action = Check | Answer | Coq

type options = { action : action; quiet : bool; most : int; reduce : bool }

let () =
  let rec read paths options = function
    | [] -> (List.rev paths, options)
    | "--coq" :: rest -> read paths { options with action = Coq } rest
    | "--answer" :: rest -> read paths { options with action = Answer } rest
    | "--quiet" :: rest -> read paths { options with quiet = true } rest
    | "--no-reduction" :: rest -> read paths { options with reduce = false } rest
    | "--max-pairs" :: n :: rest -> (
        match int_of_string_opt n with
        | Some n when n > 0 -> read paths { options with most = n } rest
        | _ -> wrong_use "--max-pairs needs a number")
    | "--help" :: _ ->
        print_string usage;
        exit 0
    | word :: _ when word <> "" && word.[0] = '-' -> wrong_use (word ^ " is not an option")
    | "" :: _ -> wrong_use "a folder has a name"
    | path :: rest -> read (path :: paths) options rest
  in
  let options = { action = Check; quiet = false; most = 20_000_000; reduce = true } in
  let paths, { action; quiet; most; reduce } = read [] options (List.tl (Array.to_list Sys.argv)) in
  match (paths, action) with
  | [], _ -> wrong_use "which certificates?"
  | [ folder ], Coq -> print_theorem folder ~most
  | [ folder ], Answer -> print_answer folder ~most ~reduce
  | _, (Coq | Answer) -> wrong_use "--coq and --answer take one certificate"
  | _, Check -> check_all paths ~most ~reduce ~quiet
