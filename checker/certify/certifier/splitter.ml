(* SPDX-License-Identifier: Apache-2.0 *)
(* Splits terms into components: explores the operands of the operators that stay. This file need not be trusted: if its
   results are wrong, the check `split_ok` refuses them. *)
open Verified

type 'a array = 'a Array.t

let mix = Search.mix

let rec hash_term = function
  | Offer l -> List.fold_left (fun h (a, p) -> mix (mix h a) (hash_term p)) 1 l
  | Call k -> mix 2 k
  | Choice (a, p, q) -> mix (mix (mix 3 a) (hash_term p)) (hash_term q)
  | Sliding (p, q) -> mix (mix 4 (hash_term p)) (hash_term q)
  | Sequence (p, q) -> mix (mix 5 (hash_term p)) (hash_term q)
  | Interrupt (a, p, q) -> mix (mix (mix 6 a) (hash_term p)) (hash_term q)
  | Throw (a, p, q) -> mix (mix (mix 7 a) (hash_term p)) (hash_term q)
  | Parallel (a, b, c, p, q) -> mix (mix (mix (mix (mix 8 a) b) c) (hash_term p)) (hash_term q)
  | Hide (a, p) -> mix (mix 9 a) (hash_term p)
  | Rename (r, p) -> mix (mix 10 r) (hash_term p)
  | Prioritise (o, p) -> mix (mix 11 o) (hash_term p)

module Terms = Hashtbl.Make (struct
  type t = term

  let equal p q = p == q || eq_term p q
  let hash p = hash_term p land max_int
end)

(* The bound for the moves of components: how deep terms and unfolded calls may be. *)
let depth_bound = 10_000

(* A component with its states, which are numbered in the order of a breadth-first search. *)
type component = { terms : term array; numbers : int Terms.t; rows : (int * int) list array }

(* Refuses definitions whose recursion reaches no event, because their moves cannot be computed. *)
let require_events (text : Formats.script_text) =
  let finished = Hashtbl.create 100 and open_calls = Hashtbl.create 100 in
  let rec visit = function
    | Offer _ -> ()
    | Call k when Hashtbl.mem finished k -> ()
    | Call k when Hashtbl.mem open_calls k -> raise (Search.Refuted "a term has a recursion that reaches no event")
    | Call k ->
        Hashtbl.add open_calls k ();
        visit (text.script.defines.body k);
        Hashtbl.replace finished k ()
    | Choice (_, p, q) | Interrupt (_, p, q) | Parallel (_, _, _, p, q) -> visit p; visit q
    | Sliding (p, _) | Sequence (p, _) | Throw (_, p, _) | Hide (_, p) | Rename (_, p) | Prioritise (_, p) -> visit p
  in
  Array.iteri (fun k _ -> visit (Call k)) text.texts

let explore definitions first ~most =
  let numbers = Terms.create 100 in
  let queue = Queue.create () in
  let number p =
    match Terms.find_opt numbers p with
    | Some v -> v
    | None ->
        let v = Terms.length numbers in
        if v >= most then raise (Search.Limit (Printf.sprintf "a component has more than %d states" most));
        Terms.add numbers p v;
        Queue.add p queue;
        v
  in
  ignore (number first);
  let rows = ref [] and terms = ref [] in
  while not (Queue.is_empty queue) do
    let p = Queue.pop queue in
    match moves_of definitions depth_bound p with
    | None -> raise (Search.Refuted "a term is nested too deeply")
    | Some moves ->
        terms := p :: !terms;
        rows := List.map (fun (a, q) -> (a, number q)) moves :: !rows
  done;
  { terms = Array.of_list (List.rev !terms); numbers; rows = Array.of_list (List.rev !rows) }

(* Returns the tree of the operators that stay, and the operands that are components, in order. *)
let tree_of term =
  let leaves = ref [] in
  let rec tree = function
    | Parallel (a, b, c, p, q) -> let t = tree p in Beside (a, b, c, t, tree q)
    | Hide (a, p) -> Hidden (a, tree p)
    | Rename (r, p) -> Renamed (r, tree p)
    | Prioritise (o, p) -> Prioritised (o, tree p)
    | leaf ->
        leaves := leaf :: !leaves;
        Leaf (List.length !leaves - 1)
  in
  let whole = tree term in
  (whole, List.rev !leaves)

let events_of rows =
  let seen = Hashtbl.create 20 in
  Array.iter (List.iter (fun (a, _) -> Hashtbl.replace seen a ())) rows;
  List.sort compare (Hashtbl.fold (fun a () l -> a :: l) seen [])

let rec count_rules (Region (inside, rules)) =
  List.fold_left (fun n -> function Slot _ -> n | Inner r -> n + count_rules r) (List.length rules) inside

(* Splits a term, and returns the system that the verified code makes of it. Tests change the split by `forge`. *)
let split ?(forge = Fun.id) (text : Formats.script_text) ~event_count ~most : split * Formats.process =
  require_events text;
  let definitions = text.script.defines in
  let whole_tree, leaves = tree_of text.script.main in
  (* Equal operands have one table. *)
  let explored = Terms.create 20 in
  let component leaf =
    match Terms.find_opt explored leaf with
    | Some found -> found
    | None ->
        let found = explore definitions leaf ~most in
        Terms.add explored leaf found;
        found
  in
  let components = Array.of_list (List.map component leaves) in
  let alphabets = Array.map (fun c -> events_of c.rows) components in
  let split =
    forge
      { whole_tree; slots = Array.length components; states = (fun k -> Array.length components.(k).terms);
        meaning = (fun k v -> if v < Array.length components.(k).terms then components.(k).terms.(v) else Offer []);
        number_of = (fun k p -> Option.value ~default:0 (Terms.find_opt components.(k).numbers p));
        alphabet = Array.get alphabets; enough = depth_bound; event_bound = event_count }
  in
  let name k = function
    | Call d when text.texts.(d) <> "" -> text.texts.(d)
    | _ -> Printf.sprintf "component %d" k
  in
  let system = split_system definitions split in
  ( split,
    { system; sizes = List.map (fun c -> Array.length c.rows) (Array.to_list components); component_names = Array.of_list (List.mapi name leaves);
      component_edges = Array.mapi (fun k c -> Array.init (Array.length c.rows) (system.edges k)) components;
      rule_count = count_rules system.whole } )
