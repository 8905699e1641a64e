(* SPDX-License-Identifier: Apache-2.0 *)
(* Writes a certificate as a file for Coq: the definitions, the proofs, the evidence, and a theorem that Coq's virtual
   machine decides. Checking this file needs neither this program nor OCaml. *)
open Verified

type 'a array = 'a Array.t

let number x = string_of_int x
let pair a b = Printf.sprintf "(%s, %s)" a b

(* Writes a list. The notation with brackets is not used, because it would hide that of primitive arrays. *)
let list f l = "(" ^ String.concat " :: " (List.map f l @ [ "nil" ]) ^ ")"
let nat x = Printf.sprintf "%d%%nat" x

(* Writes a primitive array. Its last entry is the value for indices outside of its bounds. *)
let array ~default f values =
  Printf.sprintf "[| %s | %s |]%%array" (String.concat "; " (Array.to_list (Array.map f values))) default

let define out name kind text = Printf.bprintf out "Definition %s : %s :=\n  %s.\n" name kind text
let words = list number

let rec region (Region (inside, rules)) =
  let participant = function Slot k -> "Slot " ^ nat k | Inner r -> Printf.sprintf "Inner (%s)" (region r) in
  let rule r =
    Printf.sprintf "{| does := %d; level := %s; asks := %s; puts := %s |}" r.does
      (match r.level with None -> "None" | Some l -> Printf.sprintf "Some %d" l)
      (list (fun (i, e) -> pair (nat i) (number e)) r.asks)
      (list (fun (k, x) -> pair (nat k) (number x)) r.puts)
  in
  Printf.sprintf "Region %s\n    %s" (list participant inside) (list rule rules)

let shape_of out name component_edges shape =
  let representatives k rows = array ~default:"0" number (Array.init (Array.length rows) (shape.merges.representative k)) in
  define out (name ^ "_merges") "array (array int)"
    (array ~default:"make 0 0" Fun.id (Array.mapi representatives component_edges));
  define out (name ^ "_shape") "shape"
    (Printf.sprintf
       "{| merges := {| merged_states := fun k => length (get %s_merges (of_Z (Z.of_nat k)));\n\
       \                  representative := fun k v => get (get %s_merges (of_Z (Z.of_nat k))) v |};\n\
       \   packs := {| groups := %s; event_count := %d |} |}"
       name name (list words shape.packs.groups) shape.packs.event_count)

let system out name (process : Formats.process) =
  let row edges = list (fun (e, target) -> pair (number e) (number target)) edges in
  let component rows = array ~default:"nil" row rows in
  define out (name ^ "_rows") "array (array (list (ev * int)))"
    (array ~default:"make 0 nil" component process.component_edges);
  define out name "system"
    (Printf.sprintf
       "{| edges := fun k v => get (get %s_rows (of_Z (Z.of_nat k))) v;\n   start := %s;\n   whole := %s |}" name
       (words process.system.start) (region process.system.whole))

let rec term = function
  | Offer l -> Printf.sprintf "(Offer %s)" (list (fun (e, p) -> pair (number e) (term p)) l)
  | Call k -> Printf.sprintf "(Call %d)" k
  | Choice (a, p, q) -> Printf.sprintf "(Choice %d %s %s)" a (term p) (term q)
  | Sliding (p, q) -> Printf.sprintf "(Sliding %s %s)" (term p) (term q)
  | Sequence (p, q) -> Printf.sprintf "(Sequence %s %s)" (term p) (term q)
  | Interrupt (a, p, q) -> Printf.sprintf "(Interrupt %d %s %s)" a (term p) (term q)
  | Throw (a, p, q) -> Printf.sprintf "(Throw %d %s %s)" a (term p) (term q)
  | Parallel (a, b, c, p, q) -> Printf.sprintf "(Parallel %d %d %d %s %s)" a b c (term p) (term q)
  | Hide (a, p) -> Printf.sprintf "(Hide %d %s)" a (term p)
  | Rename (r, p) -> Printf.sprintf "(Rename %d %s)" r (term p)
  | Prioritise (o, p) -> Printf.sprintf "(Prioritise %d %s)" o (term p)

let rec tree = function
  | Leaf k -> Printf.sprintf "(Leaf %s)" (nat k)
  | Beside (a, b, c, t, u) -> Printf.sprintf "(Beside %d %d %d %s %s)" a b c (tree t) (tree u)
  | Hidden (a, t) -> Printf.sprintf "(Hidden %d %s)" a (tree t)
  | Renamed (r, t) -> Printf.sprintf "(Renamed %d %s)" r (tree t)
  | Prioritised (o, t) -> Printf.sprintf "(Prioritised %d %s)" o (tree t)

(* Writes a term with its definitions, and how it is split. *)
let script out name (text : Formats.script_text) (split : split) =
  let { defines; main } = text.script in
  let events = Array.init split.event_bound Fun.id in
  let by_event part kind ~default count f =
    define out (name ^ "_" ^ part) ("array (array (" ^ kind ^ "))")
      (array ~default:("make 0 " ^ default) (fun k -> array ~default (f k) events) (Array.init count Fun.id))
  in
  by_event "sets" "bool" ~default:"false" text.sets (fun a e -> string_of_bool (defines.has a e));
  by_event "renamings" "list ev" ~default:"nil" text.renamings (fun r e -> words (defines.names r e));
  by_event "orders" "option int" ~default:"None" text.orders (fun o e ->
      match defines.priority o e with None -> "None" | Some l -> Printf.sprintf "Some %d" l);
  define out (name ^ "_bodies") "array term"
    (array ~default:"(Offer nil)" term (Array.init (Array.length text.texts) defines.body));
  define out name "script"
    (Printf.sprintf
       "{| defines := {| body := get %s_bodies; has := fun a e => get (get %s_sets a) e;\n\
       \                 names := fun r e => get (get %s_renamings r) e;\n\
       \                 priority := fun o e => get (get %s_orders o) e |};\n\
       \   main := %s |}" name name name name (term main));
  let components = Array.init split.slots Fun.id in
  define out (name ^ "_states") "array (array term)"
    (array ~default:"make 0 (Offer nil)"
       (fun k -> array ~default:"(Offer nil)" term (Array.init (split.states k) (split.meaning k)))
       components);
  define out (name ^ "_alphabets") "array (list ev)" (array ~default:"nil" (fun k -> words (split.alphabet k)) components);
  define out (name ^ "_split") "split"
    (Printf.sprintf
       "let states_of := fun k => get %s_states (of_Z (Z.of_nat k)) in\n\
       \  {| whole_tree := %s; slots := %s; states := fun k => length (states_of k);\n\
       \     meaning := fun k v => get (states_of k) v; number_of := fun k p => first_place (eq_term p) (states_of k);\n\
       \     alphabet := fun k => get %s_alphabets (of_Z (Z.of_nat k)); enough := Z.to_nat %d; event_bound := %d |}"
       name (tree split.whole_tree) (nat split.slots) name split.enough split.event_bound)

(* Writes one side of the claim. *)
let side out name given (side : Certificate_check.side) =
  (match (given, side.subject) with
  | Formats.Term text, Split_term (_, split) -> script out name text split
  | _ -> system out name side.process);
  shape_of out name side.process.component_edges side.shape

(* Writes the graph without choices that a deterministic process refines. *)
let graph out (graph : choiceless) shape =
  let rows = Array.init graph.choiceless_size graph.choiceless_arcs in
  define out "graph_rows" "array (list (ev * int))"
    (array ~default:"nil" (list (fun (a, v) -> pair (number a) (number v))) rows);
  define out "graph" "choiceless"
    (Printf.sprintf
       "{| choiceless_size := length graph_rows; choiceless_start := %d; choiceless_arcs := get graph_rows;\n\
       \   choiceless_events := %s |}"
       graph.choiceless_start (words graph.choiceless_events));
  shape_of out "graph" [| rows |] shape

let origin o = Printf.sprintf "{| by_event := %b; from := %d; depth := %d |}" o.by_event o.from o.depth
let no_origin = "{| by_event := true; from := 0; depth := 0 |}"

(* Writes the normal form, and why its members are reached. *)
let normal_form out (nodes : Search.node array) (evidence : int list evidence) =
  let count = Array.length nodes in
  let by_node name kind ~default f = define out name ("array (" ^ kind ^ ")") (array ~default f (Array.init count Fun.id)) in
  let size n = evidence.size0 n in
  let origins source members = array ~default:no_origin origin (Array.init members source) in
  by_node "node_arcs" "array (ev * int)" ~default:"make 0 (0, 0)" (fun n ->
      array ~default:"(0, 0)" (fun (a, k) -> pair (number a) (number k)) nodes.(n).arcs);
  by_node "node_acceptances" "array (list ev)" ~default:"make 0 nil" (fun n ->
      array ~default:"nil" (fun set -> words (Array.to_list set)) nodes.(n).acceptances);
  by_node "node_diverges" "bool" ~default:"false" (fun n -> string_of_bool nodes.(n).node_diverges);
  by_node "node_members" "array (list int)" ~default:"make 0 nil" (fun n ->
      array ~default:"nil" words (Array.init (size n) (evidence.member n)));
  define out "root_origins" "array origin" (origins evidence.origin_in_root (size 0));
  by_node "arc_origins" "array (array origin)" ~default:("make 0 (make 0 " ^ no_origin ^ ")") (fun n ->
      array
        ~default:("make 0 " ^ no_origin)
        (fun i -> origins (evidence.origin_after n i) (size (snd nodes.(n).arcs.(i))))
        (Array.init (Array.length nodes.(n).arcs) Fun.id));
  by_node "node_witnesses" "array int" ~default:"make 0 0" (fun n -> array ~default:"0" number nodes.(n).witnesses);
  by_node "node_loops" "int * int" ~default:"(0, 0)" (fun n ->
      if nodes.(n).node_diverges then pair (number (evidence.diverging_member n)) (number (evidence.loop_entry n))
      else "(0, 0)");
  let loop f = Array.init evidence.loop_size f in
  define out "loop_states" "array (list int)" (array ~default:"nil" words (loop evidence.loop));
  define out "loop_nexts" "array int" (array ~default:"0" number (loop evidence.loop_next));
  define out "normal" "normal_form"
    (Printf.sprintf
       "{| nodes := %d; root := 0;\n\
       \   arc_count := fun n => length (get node_arcs n);\n\
       \   arc := fun n i => get (get node_arcs n) i;\n\
       \   where_is := fun n a => first_place (fun arc => fst arc =? a) (get node_arcs n);\n\
       \   acceptance_count := fun n => length (get node_acceptances n);\n\
       \   acceptance := fun n i => get (get node_acceptances n) i;\n\
       \   divergent := get node_diverges |}"
       count);
  define out "reasons" "evidence (list int)"
    "{| size := fun n => length (get node_members n);\n\
    \   member := fun n i => get (get node_members n) i;\n\
    \   origin_in_root := get root_origins;\n\
    \   origin_after := fun n i j => get (get (get arc_origins n) i) j;\n\
    \   witness := fun n i => get (get node_witnesses n) i;\n\
    \   loop_size := length loop_states; loop := get loop_states; loop_next := get loop_nexts;\n\
    \   diverging_member := fun n => fst (get node_loops n); loop_entry := fun n => snd (get node_loops n) |}"

(* Writes the pairs in ascending order of nodes and words, so that a binary search finds a pair. Returns their order. *)
let stored_pairs out (found : Search.found) =
  let store = found.store in
  let order = Array.init store.filled Fun.id in
  let key j = (Search.node_at store j, Search.words_at store j) in
  Array.stable_sort (fun i j -> compare (key i) (key j)) order;
  let flat = Array.concat (List.map (fun j -> Array.of_list (Search.words_at store j)) (Array.to_list order)) in
  define out "pair_words" "array int" (array ~default:"0" number flat);
  define out "pair_state" "int -> list int"
    (if store.width = 1 then "fun j => get pair_words j :: nil"
     else Printf.sprintf "fun j => words_from pair_words %s (j * %d)" (nat store.width) store.width);
  define out "pair_nodes" "array int" (array ~default:"0" (fun j -> number (Search.node_at store j)) order);
  define out "located" "list int -> int -> int"
    (Printf.sprintf "fun s n => seek pair_state pair_nodes 64 s n 0 %d" store.filled);
  order

let pairs_of out (found : Search.found) ~choose =
  let store = found.store in
  let order = stored_pairs out found in
  let visits = Array.init store.filled Fun.id in
  Array.stable_sort (fun i j -> compare (Search.rank_of found order.(i)) (Search.rank_of found order.(j))) visits;
  let places = Array.make store.filled 0 in
  Array.iteri (fun place i -> places.(i) <- place) visits;
  let numbered = Array.for_all (fun i -> visits.(i) = i) (Array.init store.filled Fun.id) in
  if not numbered then begin
    define out "pair_places" "array int" (array ~default:"0" number places);
    define out "pair_visits" "array int" (array ~default:"0" number visits)
  end;
  define out "place_of_pair" "int -> int" (if numbered then "fun i => i" else "get pair_places");
  define out "pair_at_place" "int -> int" (if numbered then "fun i => i" else "get pair_visits");
  define out "found" "pairs (list int)"
    (Printf.sprintf
       "{| state_of := pair_state; node_of := get pair_nodes; place_of := place_of_pair; pair_at := pair_at_place;\n\
       \   locate := located; choose := %s;\n\
       \   deed := fun t _ => if t <? %d then if t land 1 =? 0 then Open (pair_at_place (t >> 1)) else Visit else Stop |}"
       choose (2 * store.filled))

(* Writes the states, and how far each of them is from an event of the goal. *)
let numbering_of out (found : Search.found) (numbering : Search.words numbering) =
  let order = stored_pairs out found in
  define out "distances" "array int" (array ~default:"0" (fun j -> number (numbering.distance j)) order);
  define out "numbered" "numbering (list int)"
    (Printf.sprintf
       "{| state_count := %d; state_number := fun s => located s 0; numbered_state := pair_state; distance := get distances |}"
       numbering.state_count)

let run = list (fun (a, state) -> pair (number a) (words state))

let refutation = function
  | By_event r -> "By_event " ^ run r
  | By_refusal r -> "By_refusal " ^ run r
  | By_divergence (r, loop) -> Printf.sprintf "By_divergence %s %s" (run r) (run loop)

let preamble =
  "(* How the evidence is found; nothing here has to be believed. *)\n\
   Fixpoint first_from {A} (chk : A -> bool) (fuel : nat) (t : array A) (i : int) : int :=\n\
  \  match fuel with O => i | S f => if i <? length t then if chk (get t i) then i else first_from chk f t (i + 1) else i end.\n\
   Definition first_place {A} (chk : A -> bool) (t : array A) : int :=\n\
  \  first_from chk (Z.to_nat (to_Z (length t))) t 0.\n\
   Fixpoint less (c d : list int) : bool :=\n\
  \  match c, d with v :: c', w :: d' => if v <? w then true else if v =? w then less c' d' else false | _, _ => false end.\n\
   Fixpoint words_from (t : array int) (n : nat) (i : int) : list int :=\n\
  \  match n with O => nil | S n' => get t i :: words_from t n' (i + 1) end.\n\
   Fixpoint seek (states : int -> list int) (node_numbers : array int) (fuel : nat) (s : list int) (n lo hi : int) : int :=\n\
  \  match fuel with\n\
  \  | O => lo\n\
  \  | S f =>\n\
  \      if hi - lo <=? 1 then lo\n\
  \      else\n\
  \        let mid := (lo + hi) >> 1 in\n\
  \        let m := get node_numbers mid in\n\
  \        if (n <? m) || ((n =? m) && less s (states mid)) then seek states node_numbers f s n lo mid\n\
  \        else seek states node_numbers f s n mid hi\n\
  \  end.\n\
   Definition fitting (sets : array (list ev)) (moves : list (ev * list int)) : int :=\n\
  \  first_place (fun A => if offers moves tick then forallb (fun a => a =? tick) A else forallb (offers moves) A) sets.\n\n"

(* Changes a text for a comment, so that it neither ends the comment nor begins a string or another comment. *)
let comment text =
  String.mapi (fun i c -> if c = '"' || (c = '*' && i > 0 && text.[i - 1] = '(') || (c = ')' && i > 0 && text.[i - 1] = '*') then '_' else c) text

let model_name = function T -> "T" | F -> "F" | FD -> "FD"

let property_name = function
  | Deadlock_free -> "Deadlock_free"
  | Deadlock_and_divergence_free -> "Deadlock_and_divergence_free"
  | Divergence_free -> "Divergence_free"

let prove out statement lemma =
  Printf.bprintf out "\nTheorem holds : %s.\nProof. apply (%s). vm_cast_no_check (eq_refl true). Qed.\nPrint Assumptions holds.\n"
    statement lemma

(* Lists the names of events for readers. *)
let event_list (claim : Formats.claim) =
  String.concat "" (List.init (claim.event_count - 2) (fun i -> Printf.sprintf "   %d: %s\n" (i + 2) (comment (claim.event_name (i + 2)))))

(* Finds the evidence: the proof, the nodes of the normal form, and the pairs. *)
let evidence_for (claim : Formats.claim) ~most =
  match claim.question with
  | Refinement _ | Property _ | Determinism _ ->
      let proof, nodes, found = Certificate_check.prove claim ~most in
      (proof, nodes, Some found)
  | Stays_possible | Has_trace | No_refinement _ ->
      let shown = Certificate_check.show claim ~most in
      (shown.proof, [||], shown.visited)

let theorem (claim : Formats.claim) ~most =
  let out = Buffer.create 1_000_000 in
  let proof, nodes, found = evidence_for claim ~most in
  let terms = Formats.level_of claim.implementation = "term" in
  Printf.bprintf out "(* %s\n   %s\n   Claim: %s.\n   %s\n\n   Events: 0: tau, 1: tick\n%s*)\n"
    (comment claim.assertion) (comment claim.source) claim.question_text
    (if terms then "Term level, unreduced: the theorem is about the terms below."
    else "Product level, unreduced: the theorem is about the compiled processes below.")
    (event_list claim);
  Buffer.add_string out Proofs.text;
  Buffer.add_string out preamble;
  let write name given = side out name given (Certificate_check.side_of given ~event_count:claim.event_count ~most) in
  let write_both () =
    write "specification" (Option.get claim.specification);
    write "implementation" claim.implementation
  in
  let pairs choose = pairs_of out (Option.get found) ~choose in
  let lts name = if terms then Printf.sprintf "(term_lts bound %s)" name else Printf.sprintf "(system_lts %s)" name in
  let impl_lts = lts "implementation" in
  let data name = if terms then Printf.sprintf "%s %s_split %s_shape" name name name else Printf.sprintf "%s_shape %s" name name in
  let impl = data "implementation" and both = data "specification" ^ " " ^ data "implementation" in
  let prove statement theorem data =
    prove out
      (if terms then Printf.sprintf "eventually (fun bound => %s)" statement else statement)
      (Printf.sprintf "%s%s %s" (if terms then "script_" else "") theorem data)
  in
  let chosen = "fun n moves => fitting (get node_acceptances n) moves" and unused = "fun _ _ => 0" in
  (match proof with
  | Certificate_check.Of_refinement (model, _, _, _, _, _, evidence, _) ->
      write_both ();
      normal_form out nodes evidence;
      pairs chosen;
      let m = model_name model in
      prove
        (Printf.sprintf "refines %s %s %s" m (lts "specification") impl_lts)
        "refinement_sound" (Printf.sprintf "%s %s None normal reasons found" m both)
  | Of_property (property, _, _, _) ->
      write "implementation" claim.implementation;
      pairs unused;
      let p = property_name property in
      prove (Printf.sprintf "satisfies %s %s" p impl_lts) "property_sound" (Printf.sprintf "%s %s None found" p impl)
  | Of_determinism (model, graph_shape, given, _, _, _, evidence, _) ->
      write "implementation" claim.implementation;
      graph out given graph_shape;
      normal_form out nodes evidence;
      pairs chosen;
      let m = model_name model in
      prove
        (Printf.sprintf "deterministic %s %s" m impl_lts)
        "determinism_sound" (Printf.sprintf "%s graph_shape graph %s None normal reasons found" m impl)
  | Of_possible (goal, _, _, numbering) ->
      write "implementation" claim.implementation;
      numbering_of out (Option.get found) numbering;
      prove
        (Printf.sprintf "stays_possible (fun a => In a %s) %s" (words goal) impl_lts)
        "possible_sound" (Printf.sprintf "%s %s numbered" (words goal) impl)
  | Of_trace (events, _, _, shown) ->
      write "implementation" claim.implementation;
      define out "shown" "list (ev * list int)" (run shown);
      prove (Printf.sprintf "traces %s %s" impl_lts (words events)) "trace_sound" (Printf.sprintf "%s %s shown" (words events) impl)
  | Of_refutation (model, _, _, _, _, shown, _) ->
      write_both ();
      define out "shown" "refutation (list int)" (refutation shown);
      pairs unused;
      let m = model_name model in
      prove
        (Printf.sprintf "~ refines %s %s %s" m (lts "specification") impl_lts)
        "refutation_sound" (Printf.sprintf "%s %s shown found" m both));
  Buffer.contents out
