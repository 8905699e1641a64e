(* SPDX-License-Identifier: Apache-2.0 *)
(* Attacks on the certifier. Random processes, an oracle that is independent of the certifier, and certificates of claims
   that fail: made by a search that overlooks violations, with forged normal forms and reductions, with functions that lie, with damaged
   files. None of them may be accepted; every true claim must be. attack SEED TRIALS, or attack SEED TRIALS reductions
   for the attacks with forged steps alone, or attack SEED TRIALS symmetry for the attacks with forged automorphisms alone. *)
open Verified

type 'a array = 'a Array.t

let pick l = List.nth l (Random.int (List.length l))
let times n f = List.init n (fun _ -> f ())

(** Random processes, as data of their own. *)
type participant = S of int | R of part
and part = { inside : participant list; rules : (int * int option * (int * int) list * (int * int) list) list }
type random = { components : (int * int) list array array; initial : int list; whole : part }

(* Events: 0 tau, 1 tick, 2 to 4 of components, 5 to 7 of the whole. *)
let inner = [ 0; 2; 3; 4 ]
let outer = [ 0; 1; 5; 6 ]

(* With `busy`, more rules have levels, assign states, and perform tau. *)
let random_process ~busy =
  let size () = 1 + Random.int 3 in
  let component () =
    let states = size () in
    Array.init states (fun _ -> times (Random.int 4) (fun () -> (pick inner, Random.int states)))
  in
  let components = Array.init (1 + Random.int 3) (fun _ -> component ()) in
  let rec region slots depth =
    let split = depth > 0 && List.length slots > 1 && Random.bool () in
    let nested, direct = if split then List.partition (fun _ -> Random.bool ()) slots else ([], slots) in
    let inside = (if nested = [] then [] else [ R (region nested (depth - 1)) ]) @ List.map (fun k -> S k) direct in
    let count = List.length inside in
    let rule () =
      let first = Random.int count in
      let second = Random.int count in
      let who = if second <> first && Random.bool () then [ first; second ] else [ first ] in
      let slot = pick slots in
      let puts = if Random.int (if busy then 3 else 7) = 0 then [ (slot, Random.int (Array.length components.(slot))) ] else [] in
      let level = if Random.int (if busy then 3 else 2) = 0 then None else Some (Random.int (if busy then 2 else 3)) in
      (pick (if depth = 1 then if busy then 0 :: 0 :: outer else outer else inner), level, List.map (fun i -> (i, pick inner)) who, puts)
    in
    { inside; rules = times (2 + Random.int (if busy then 7 else 5)) rule }
  in
  let whole = region (List.init (Array.length components) Fun.id) 1 in
  { components; initial = Array.to_list (Array.map (fun c -> Random.int (Array.length c)) components); whole }

let mutated process =
  let components = Array.map Array.copy process.components in
  let rec part p = { p with inside = List.map (function R r when Random.int 3 = 0 -> R (part r) | other -> other) p.inside;
                     rules = (let at = Random.int (List.length p.rules) in
                       List.mapi (fun i ((d, l, a, pu) as rule) -> if i <> at then rule else
                         match Random.int 4 with 0 -> ((if List.mem d [ 1; 5; 6 ] then pick outer else d), l, a, pu) | 1 -> (d, (if Random.bool () then None else Some (Random.int 3)), a, pu)
                           | 2 -> (d, l, [ List.hd a ], pu) | _ -> (d, l, a, [])) p.rules) } in
  if Random.bool () then begin
    let k = Random.int (Array.length components) in
    let rows = components.(k) in
    let s = Random.int (Array.length rows) in
    rows.(s) <- (match rows.(s) with _ :: rest when Random.bool () -> rest | row -> (pick inner, Random.int (Array.length rows)) :: row);
    { process with components }
  end
  else { process with whole = part process.whole }

(* Adds a rule with a visible event. A reduction that loses its moves changes the answer. *)
let extended process =
  let part = process.whole in
  let _, level, asks, puts = pick part.rules in
  { process with whole = { part with rules = part.rules @ [ (6, (if Random.bool () then level else Some 1), (if Random.bool () then asks else [ List.hd asks ]), puts) ] } }

(** The text of a process. *)
let text process =
  let b = Buffer.create 1000 in
  let add format = Printf.bprintf b format in
  add "robochart-verify process 1\nevents 6\na\nb\nc\nx\ny\nz\ncomponents %d\n" (Array.length process.components);
  let row l = String.concat " " (List.map (fun (x, y) -> Printf.sprintf "%d %d" x y) l) in
  Array.iteri
    (fun k c ->
      add "component %d %d C%d\n" (Array.length c) (List.nth process.initial k) k;
      Array.iter (fun edges -> add "%s\n" (row edges)) c)
    process.components;
  let rec part p =
    add "region %d %d\n" (List.length p.inside) (List.length p.rules);
    List.iter (function S k -> add "slot %d\n" k | R r -> part r) p.inside;
    List.iter
      (fun (d, l, a, pu) ->
        add "rule %d %s %d%s\n" d (match l with None -> "-" | Some l -> string_of_int l) (List.length a)
          (match row (a @ pu) with "" -> "" | r -> " " ^ r))
      p.rules
  in
  part process.whole;
  add "end\n";
  Buffer.contents b

(** The oracle. *)
let successors process =
  let rec product = function
    | [] -> [ [] ]
    | options :: rest -> List.concat_map (fun tail -> List.map (fun o -> o @ tail) options) (product rest)
  in
  let rec moves state p =
    let by = List.map (function
      | S k -> List.map (fun (e, t) -> (e, [ (k, t) ])) (let rows = if k < Array.length process.components then process.components.(k) else [||] in match List.nth_opt state k with Some s when s < Array.length rows -> rows.(s) | _ -> [])
      | R r -> moves state r) p.inside in
    let ways (_, _, asks, _) =
      product (List.map (fun (i, e) -> List.filter_map (fun (e', change) -> if e = e' then Some change else None) (Option.value ~default:[] (List.nth_opt by i))) asks) in
    let able = List.filter (fun (_, w) -> w <> []) (List.map (fun rule -> (rule, ways rule)) p.rules) in
    let levels = List.filter_map (fun ((_, l, _, _), _) -> l) able in
    let best = List.fold_left min max_int levels in
    List.concat_map (fun ((d, l, _, puts), w) ->
      match l with Some l when l > best -> [] | _ -> List.map (fun change -> (d, change @ puts)) w) able
  in
  fun state ->
    List.sort_uniq compare
      (List.map
         (fun (e, changes) -> (e, List.fold_left (fun s (k, v) -> List.mapi (fun i x -> if i = k then v else x) s) state changes))
         (moves state process.whole))

let memo f = let t = Hashtbl.create 50 in fun x -> match Hashtbl.find_opt t x with Some y -> y | None -> let y = f x in Hashtbl.add t x y; y

let reachable succ start edges =
  let seen = Hashtbl.create 50 in
  let rec go s = if not (Hashtbl.mem seen s) then (Hashtbl.add seen s (); List.iter (fun (e, u) -> if edges e then go u) (succ s)) in
  List.iter go start;
  List.sort compare (Hashtbl.fold (fun s () l -> s :: l) seen [])

(* A state diverges if some state reached by taus is reached again from itself by at least one tau. *)
let diverges succ s =
  let taus u = List.filter_map (fun (e, v) -> if e = 0 then Some v else None) (succ u) in
  List.exists (fun u -> List.mem u (reachable succ (taus u) (fun e -> e = 0))) (reachable succ [ s ] (fun e -> e = 0))

let stable_offer succ s =
  let events = List.sort_uniq compare (List.map fst (succ s)) in
  if List.mem 1 events then Some [ 1 ] else if List.mem 0 events then None else Some events

let subset a b = List.for_all (fun x -> List.mem x b) a

(* The states that taus lead to, and those that an event leads to. *)
let close succ l = reachable succ l (fun e -> e = 0)
let after succ set e = close succ (List.concat_map (fun s -> List.filter_map (fun (e', u) -> if e = e' then Some u else None) (succ s)) set)

let refinement_holds model (spec_start, spec_steps) (impl_start, impl_steps) =
  let ss = memo spec_steps and si = memo impl_steps in
  let divergent_spec = memo (List.exists (diverges ss)) and divergent_impl = memo (diverges si) in
  let seen = Hashtbl.create 50 in
  let rec check s set =
    Hashtbl.mem seen (s, set)
    || begin
         Hashtbl.add seen (s, set) ();
         (model = FD && divergent_spec set)
         || (not (model = FD && divergent_impl s))
            && (model = T
               || (match stable_offer si s with
                  | None -> true
                  | Some offer -> List.exists (fun u -> match stable_offer ss u with Some o -> subset o offer | None -> false) set))
            && List.for_all
                 (fun (e, u) ->
                   if e = 0 then check u set
                   else
                     let next = after ss set e in
                     next <> [] && check u next)
                 (si s)
       end
  in
  check impl_start (close ss [ spec_start ])

(* No trace t and event e exist such that t followed by e is a trace, and e can be refused after t. *)
let is_deterministic model (start, steps) =
  let si = memo steps in
  let refuses s e =
    let offered = List.map fst (si s) in
    if List.mem 1 offered then e <> 1 else not (List.mem 0 offered || List.mem e offered) in
  let seen = Hashtbl.create 50 in
  let rec check set =
    Hashtbl.mem seen set
    || begin
         Hashtbl.add seen set ();
         let events = List.sort_uniq compare (List.filter (fun e -> e <> 0) (List.concat_map (fun s -> List.map fst (si s)) set)) in
         (model <> FD || not (List.exists (diverges si) set))
         && List.for_all (fun e -> not (List.exists (fun s -> refuses s e) set) && check (after si set e)) events
       end
  in
  check (close si [ start ])

let stays_possible events (start, steps) =
  let si = memo steps in
  let near s = List.exists (fun (e, _) -> List.mem e events) (si s) in
  List.for_all (fun s -> List.exists near (reachable si [ s ] (fun _ -> true))) (reachable si [ start ] (fun _ -> true))

let has_trace events (start, steps) =
  let si = memo steps in
  List.fold_left (after si) (close si [ start ]) events <> []

let property_holds property (impl_start, impl_steps) =
  let si = memo impl_steps in
  let all = reachable si [ impl_start ] (fun _ -> true) in
  (property = Divergence_free || List.for_all (fun s -> si s <> []) all)
  && (property = Deadlock_free || not (List.exists (diverges si) all))

(** Random terms, as data of their own. Events: 0 tau, 1 tick, 2 to 6. *)
type random_term =
  | Do of (int * random_term) list
  | Name of int
  | Ext of int list * random_term * random_term
  | Slide of random_term * random_term
  | Seq of random_term * random_term
  | Inter of int list * random_term * random_term
  | Exc of int list * random_term * random_term
  | Par of int list * int list * int list * random_term * random_term
  | Hid of int list * random_term
  | Ren of (int * int) list * random_term
  | Pri of (int * int) list * random_term
type random_script = { bodies : random_term array; root : random_term }

let visible = [ 2; 3; 4; 5; 6 ]
let some_events () = List.filter (fun _ -> Random.int 3 = 0) visible
let simple = 4  (* the first definitions are simple: they only perform events *)

(* The operands that stay inside of operators are simple, so the number of states is finite. *)
let random_offer most =
  Do (times (Random.int 4) (fun () ->
    match Random.int 8 with 0 -> (0, Name (Random.int most)) | 1 -> (1, Do []) | _ -> (pick visible, Name (Random.int most))))
let random_parallel p q =
  let a = some_events () in
  let others = List.filter (fun e -> not (List.mem e a)) visible in
  match Random.int 3 with
  | 0 -> Par (others, others, a, p, q)
  | 1 -> let b = some_events () in let minus x y = List.filter (fun e -> not (List.mem e y)) x in
      Par (minus a b, minus b a, List.filter (fun e -> List.mem e b) a, p, q)
  | _ -> Par (some_events (), some_events (), some_events (), p, q)
let random_unary p =
  match Random.int 3 with
  | 0 -> Hid (some_events (), p)
  | 1 -> Ren (times (Random.int 3) (fun () -> (pick visible, pick visible)), p)
  | _ -> Pri (List.map (fun e -> (e, Random.int 3)) (some_events ()), p)
let random_body k =
  if k < simple then random_offer simple
  else
    let low () = Name (Random.int simple) and any () = Name (Random.int k) in
    match Random.int 9 with
    | 0 -> Ext ((if Random.bool () then [] else some_events ()), low (), low ())
    | 1 -> Slide (low (), any ())
    | 2 | 3 -> Seq (low (), any ())
    | 4 -> Inter ((if Random.bool () then [] else some_events ()), low (), low ())
    | 5 -> Exc (some_events (), low (), any ())
    | 6 -> random_parallel (low ()) (low ())
    | 7 -> random_unary (low ())
    | _ -> random_offer k
let definitions_count = 7
let rec random_root depth =
  if depth = 0 || Random.int 5 = 0 then Name (Random.int definitions_count)
  else if Random.int 4 = 0 then let p = random_root (depth - 1) in random_parallel p p
  else if Random.bool () then random_parallel (random_root (depth - 1)) (random_root (depth - 1))
  else random_unary (random_root (depth - 1))
let random_script () = { bodies = Array.init definitions_count random_body; root = random_root 3 }
let rec mutated_root = function
  | Par (a, b, c, p, q) when Random.int 3 > 0 -> if Random.bool () then Par (a, b, c, mutated_root p, q) else Par (a, b, c, p, mutated_root q)
  | Hid (a, p) when Random.int 3 > 0 -> Hid (a, mutated_root p)
  | Ren (r, p) when Random.int 3 > 0 -> Ren (r, mutated_root p)
  | Pri (o, p) when Random.int 3 > 0 -> Pri (o, mutated_root p)
  | Par (_, _, _, p, q) -> random_parallel p q
  | Hid (_, p) | Ren (_, p) | Pri (_, p) -> if Random.bool () then p else random_unary p
  | other -> if Random.bool () then random_parallel other other else other
let mutated_script t =
  if Random.bool () then { t with root = mutated_root t.root }
  else begin
    let bodies = Array.copy t.bodies in
    let k = Random.int definitions_count in
    bodies.(k) <- random_body k;
    { t with bodies }
  end

(** The text of a term. *)
let script_text t =
  let sets = ref [] and renamings = ref [] and orders = ref [] in
  let number table line = table := !table @ [ line ]; string_of_int (List.length !table - 1) in
  let set s =
    let outside = Random.int 3 = 0 in
    let listed = if outside then List.filter (fun e -> not (List.mem e s)) visible else s in
    number sets (String.concat " " ((if outside then "-" else "+") :: List.map string_of_int listed)) in
  let pairs l = String.concat " " (List.map (fun (a, b) -> Printf.sprintf "%d %d" a b) l) in
  let rec words = function
    | Do l -> String.concat " " ("offer" :: string_of_int (List.length l) :: List.map (fun (e, p) -> Printf.sprintf "%d %s" e (words p)) l)
    | Name k -> string_of_int k
    | Ext (a, p, q) -> Printf.sprintf "choice %s %s %s" (set a) (words p) (words q)
    | Slide (p, q) -> Printf.sprintf "sliding %s %s" (words p) (words q)
    | Seq (p, q) -> Printf.sprintf "sequence %s %s" (words p) (words q)
    | Inter (a, p, q) -> Printf.sprintf "interrupt %s %s %s" (set a) (words p) (words q)
    | Exc (a, p, q) -> Printf.sprintf "throw %s %s %s" (set a) (words p) (words q)
    | Par (a, b, c, p, q) -> Printf.sprintf "parallel %s %s %s %s %s" (set a) (set b) (set c) (words p) (words q)
    | Hid (a, p) -> Printf.sprintf "hide %s %s" (set a) (words p)
    | Ren (r, p) -> Printf.sprintf "rename %s %s" (number renamings (pairs r)) (words p)
    | Pri (o, p) -> Printf.sprintf "prioritise %s %s" (number orders (pairs o)) (words p) in
  let bodies = List.mapi (fun k b -> Printf.sprintf "%s #P%d" (words b) k) (Array.to_list t.bodies) in
  let root = words t.root in
  let table name lines = String.concat "\n" (Printf.sprintf "%s %d" name (List.length lines) :: lines) in
  String.concat "\n"
    [ "robochart-verify term 1\nevents 5\na\nb\nc\nx\ny"; table "sets" !sets; table "renamings" !renamings; table "orders" !orders;
      table "definitions" bodies; "main " ^ root; "end\n" ]

(** The oracle for terms: the terms to which an event leads, by event. *)
let term_steps bodies =
  let names r e = match List.filter_map (fun (a, b) -> if a = e then Some b else None) r with [] -> [ e ] | l -> l in
  let level o e = if e < 2 then Some 0 else List.assoc_opt e o in
  let rec to_ p e =
    match p with
    | Do l -> List.filter_map (fun (a, q) -> if a = e then Some q else None) l
    | Name k -> to_ (bodies k) e
    | Ext (a, p, q) when e = 0 -> List.map (fun u -> Ext (a, u, q)) (to_ p 0) @ List.map (fun u -> Ext (a, p, u)) (to_ q 0)
    | Ext (a, p, q) when e > 1 && List.mem e a -> both (to_ p e) (to_ q e) (fun u v -> Ext (a, u, v))
    | Ext (_, p, q) -> to_ p e @ to_ q e
    | Slide (p, q) -> if e = 0 then q :: List.map (fun u -> Slide (u, q)) (to_ p 0) else to_ p e
    | Seq (p, q) ->
        if e = 1 then []
        else List.map (fun u -> Seq (u, q)) (to_ p e) @ if e = 0 then List.map (fun _ -> q) (to_ p 1) else []
    | Inter (a, p, q) when e > 1 && List.mem e a -> both (to_ p e) (to_ q e) (fun u v -> Inter (a, u, v))
    | Inter (a, p, q) ->
        List.map (fun u -> if e = 1 then Do [] else Inter (a, u, q)) (to_ p e)
        @ List.map (fun u -> if e = 0 then Inter (a, p, u) else u) (to_ q e)
    | Exc (a, p, q) ->
        List.map (fun u -> if e > 1 && List.mem e a then q else if e = 1 then Do [] else Exc (a, u, q)) (to_ p e)
    | Par (a, b, c, p, q) ->
        let par u v = Par (a, b, c, u, v) in
        (if e = 0 || (e > 1 && List.mem e a) then List.map (fun u -> par u q) (to_ p e) else [])
        @ (if e = 0 || (e > 1 && List.mem e b) then List.map (fun u -> par p u) (to_ q e) else [])
        @ if e = 1 || (e > 1 && List.mem e c) then both (to_ p e) (to_ q e) par else []
    | Hid (a, p) ->
        let hidden = List.filter (fun d -> d > 1) a in
        let all = if e = 0 then 0 :: hidden else if List.mem e hidden then [] else [ e ] in
        List.map (fun u -> Hid (a, u)) (List.concat_map (to_ p) all)
    | Ren (r, p) ->
        let before = if e < 2 then [ e ] else List.filter (fun d -> List.mem e (names r d)) visible in
        List.map (fun u -> Ren (r, u)) (List.concat_map (to_ p) before)
    | Pri (o, p) ->
        let stronger d = match (level o d, level o e) with Some k, Some l -> k < l | _ -> false in
        if List.exists (fun d -> stronger d && to_ p d <> []) (0 :: 1 :: visible) then []
        else List.map (fun u -> Pri (o, u)) (to_ p e)
  and both l k f = List.concat_map (fun u -> List.map (f u) k) l in
  fun p -> List.sort_uniq compare (List.concat_map (fun e -> List.map (fun u -> (e, u)) (to_ p e)) (0 :: 1 :: visible))

(* Whether a term has few states, so that the oracle is fast. *)
let is_small t =
  let steps = term_steps (Array.get t.bodies) and seen = Hashtbl.create 50 in
  let rec go p =
    Hashtbl.mem seen p
    || Hashtbl.length seen < 30
       && begin
            Hashtbl.add seen p ();
            List.for_all (fun (_, q) -> go q) (steps p)
          end
  in
  go t.root
let rec small make =
  let t = make () in
  if is_small t then t else small make

(** Attacks. *)
let claim_of ?(events = []) question specification implementation : Formats.claim =
  let names = Formats.no_names () in
  let read text = Formats.read_side names "process" text in
  let specification = Option.map read specification in
  let implementation = read implementation in
  { question; question_text = ""; assertion = ""; source = ""; specification; events; implementation;
    event_name = Formats.name_of names; event_count = names.next }

let most = 100_000

(* Normal forms that allow too much. *)
let forge_arcs (nodes : Search.node array) =
  Array.mapi (fun n (node : Search.node) ->
    let more = List.filter_map (fun a -> if Array.exists (fun (b, _) -> a = b) node.arcs then None else Some (a, Random.int (n + 1))) [ 1; 2; 3; 4; 5; 6 ] in
    { node with arcs = (let a = Array.append node.arcs (Array.of_list more) in Array.sort compare a; a) }) nodes
let forge_acceptances = Array.map (fun (node : Search.node) -> { node with acceptances = [| [||] |]; witnesses = [| 0 |] })
let forge_divergence = Array.map (fun (node : Search.node) -> { node with node_diverges = true })
let forge_empty (nodes : Search.node array) =
  let extra = Array.length nodes in
  let all = Array.of_list (List.map (fun a -> (a, extra)) [ 1; 2; 3; 4; 5; 6 ]) in
  Array.append (Array.map (fun (node : Search.node) -> { node with arcs = all }) nodes)
    [| { Search.members = [||]; arcs = all; acceptances = [| [||] |]; witnesses = [| 0 |]; node_diverges = false } |]
let forge_targets (nodes : Search.node array) =
  Array.map (fun (node : Search.node) -> { node with arcs = Array.map (fun (a, _) -> (a, Random.int (Array.length nodes))) node.arcs }) nodes
let forge_root (nodes : Search.node array) =
  let at = Random.int (Array.length nodes) in
  let other k = if k = 0 then at else if k = at then 0 else k in
  Array.init (Array.length nodes) (fun i ->
      let node = nodes.(other i) in
      { node with arcs = Array.map (fun (a, k) -> (a, other k)) node.arcs })

(* Every node has all states, arcs and acceptances that some node has. *)
let forge_members (nodes : Search.node array) =
  let all f = List.sort_uniq compare (List.concat_map (fun node -> Array.to_list (f node)) (Array.to_list nodes)) in
  let members = Array.of_list (all (fun (node : Search.node) -> node.members)) in
  let arcs = Array.of_list (all (fun (node : Search.node) -> node.arcs)) in
  let acceptances = Array.of_list (all (fun (node : Search.node) -> node.acceptances)) in
  let witnesses = Array.map (fun _ -> Random.int (Array.length members)) acceptances in
  Array.map (fun (node : Search.node) -> { node with members; arcs; acceptances; witnesses }) nodes

(* As before, but the root keeps its members. *)
let forge_later_members nodes =
  let forged = forge_members nodes in
  Array.mapi (fun n (node : Search.node) -> if n = 0 then { nodes.(0) with arcs = node.arcs } else node) forged

let forges = [ forge_members; forge_later_members; Fun.id; forge_arcs; forge_acceptances; forge_divergence; forge_empty; forge_targets; forge_root ]

(* The system of a subject. *)
let system_of = function
  | Certificate_check.System system -> system
  | Split_term (script, split) -> split_system script.defines split

(* Functions that lie in some places, always in the same way. *)
let lying proof =
  let salt = Random.bits () and rate = 1 + Random.int 6 in
  let lie kind key honest other =
    if Hashtbl.hash (salt, kind) mod 3 = 0 && Hashtbl.hash (salt, kind, key) mod rate = 0 then other (abs (Hashtbl.hash (salt, key, kind, 1))) else honest in
  let pairs (p : int list pairs) =
    { state_of = (fun j -> lie 1 j (p.state_of j) (fun r -> p.state_of (r mod (j + 1))));
      node_of = (fun j -> lie 2 j (p.node_of j) (fun r -> r mod 4));
      place_of = (fun j -> lie 3 j (p.place_of j) (fun r -> r mod 5));
      pair_at = (fun j -> lie 15 j (p.pair_at j) (fun r -> r mod (j + 1)));
      locate = (fun s n -> lie 4 (s, n) (p.locate s n) (fun r -> r mod (p.locate s n + 2)));
      choose = (fun n moves -> lie 5 (n, List.map fst moves) (p.choose n moves) (fun r -> r mod 4));
      deed = (fun t opened ->
        lie 16 t (p.deed t opened) (fun r -> match r mod 4 with 0 -> Visit | 1 -> Stop | _ -> Open (r mod ((t / 2) + 1)))) }
  in
  let shape h =
    { h with merges = { h.merges with representative = (fun k v -> lie 17 (k, v) (h.merges.representative k v) (fun r -> r mod (v + 1))) } } in
  match proof with
  | Certificate_check.Of_property (q, h, s, p) -> Certificate_check.Of_property (q, shape h, s, pairs p)
  | Of_refinement (m, ls, s, li, i, n, e, p) ->
      let normal = { n with where_is = (fun k a -> lie 6 (k, a) (n.where_is k a) (fun r -> r mod 4));
                     divergent = (fun k -> lie 7 k (n.divergent k) (fun r -> r mod 2 = 0)) } in
      let source kind o = { by_event = lie kind (o, 0) o.by_event (fun r -> r mod 2 = 0); from = lie kind (o, 1) o.from (fun r -> r mod 4); depth = lie kind (o, 2) o.depth (fun r -> r mod 4) } in
      let evidence =
        { e with member = (fun k j -> lie 8 (k, j) (e.member k j) (fun r -> e.member (r mod max 1 n.nodes) 0));
          origin_in_root = (fun j -> source 9 (e.origin_in_root j));
          origin_after = (fun k i j -> source 10 (e.origin_after k i j));
          witness = (fun k i -> lie 11 (k, i) (e.witness k i) (fun r -> r mod 4));
          loop_next = (fun j -> lie 12 j (e.loop_next j) (fun r -> r mod 4));
          diverging_member = (fun k -> lie 13 k (e.diverging_member k) (fun r -> r mod 4));
          loop_entry = (fun k -> lie 14 k (e.loop_entry k) (fun r -> r mod 4)) } in
      Of_refinement (m, shape ls, s, shape li, i, normal, evidence, pairs p)

(* Members are derived from each other in circles, wherever there is a tau between them. *)
let circular = function
  | Certificate_check.Of_refinement (m, ls, s, li, i, n, e, p) ->
      let lts = compact ls (system_of s) in
      let source k j honest =
        let taus_to f = List.exists (fun (a, u) -> a = 0 && u = e.member k j) (lts.succ0 (e.member k f)) in
        match List.find_opt taus_to (List.init (e.size0 k) Fun.id) with
        | Some from -> { by_event = false; from; depth = Random.int 2 }
        | None -> honest in
      let evidence =
        { e with origin_in_root = (fun j -> source n.root j (e.origin_in_root j));
          origin_after = (fun k a j -> source (snd (n.arc k a)) j (e.origin_after k a j)) } in
      Certificate_check.Of_refinement (m, ls, s, li, i, n, evidence, p)
  | other -> other

(* Any member with the arc's event is given as the origin, and any member as the witness, whatever they lead to. *)
let loose = function
  | Certificate_check.Of_refinement (m, ls, s, li, i, n, e, p) ->
      let lts = compact ls (system_of s) in
      let first k chk = Option.value ~default:0 (List.find_opt chk (List.init (e.size0 k) Fun.id)) in
      let from k a = first k (fun f -> List.exists (fun (b, _) -> a = b) (lts.succ0 (e.member k f))) in
      let fitting k set =
        first k (fun f -> let moves = lts.succ0 (e.member k f) in
          not (List.mem_assoc 0 moves) && List.for_all (fun (a, _) -> List.mem a set) moves) in
      let evidence =
        { e with origin_after = (fun k a _ -> { by_event = true; from = from k (fst (n.arc k a)); depth = 0 });
          origin_in_root = (fun _ -> { by_event = true; from = 0; depth = 0 });
          witness = (fun k a -> fitting k (n.acceptance k a));
          diverging_member = (fun _ -> 0);
          loop_entry = (fun _ -> 0) } in
      let included k moves =
        let set_fits c = List.for_all (fun a -> List.mem_assoc a moves) (n.acceptance k c) in
        Option.value ~default:0 (List.find_opt set_fits (List.init (n.acceptance_count k) Fun.id)) in
      Certificate_check.Of_refinement (m, ls, s, li, i, n, evidence, { p with choose = included })
  | other -> other

(* One member is reached as it says, and all others by taus from it. *)
let chained = function
  | Certificate_check.Of_refinement (m, ls, s, li, i, n, e, p) ->
      let lts = compact ls (system_of s) in
      let first k chk = Option.value ~default:0 (List.find_opt chk (List.init (e.size0 k) Fun.id)) in
      let chain reached from j = if j = reached then { by_event = true; from; depth = 0 } else { by_event = false; from = reached; depth = 1 } in
      let step k a u f = List.mem (a, e.member u f) (List.concat_map (fun g -> lts.succ0 (e.member k g)) (List.init (e.size0 k) Fun.id)) in
      let evidence =
        { e with origin_in_root = (fun j -> chain (first n.root (fun f -> e.member n.root f = lts.init)) 0 j);
          origin_after =
            (fun k c j ->
              let a, u = n.arc k c in
              let reached = first u (step k a u) in
              let from = first k (fun g -> List.mem (a, e.member u reached) (lts.succ0 (e.member k g))) in
              chain reached from j) } in
      Certificate_check.Of_refinement (m, ls, s, li, i, n, evidence, p)
  | other -> other

(* Every node has a loop of its own: a tau from its first member to the member itself. *)
let looping = function
  | Certificate_check.Of_refinement (m, ls, s, li, i, n, e, p) ->
      let evidence =
        { e with loop_size = n.nodes; loop = (fun k -> e.member k 0); loop_next = Fun.id;
          diverging_member = (fun _ -> 0); loop_entry = Fun.id } in
      Certificate_check.Of_refinement (m, ls, s, li, i, n, evidence, p)
  | other -> other

(* One pair for each state, with the node with which it was found first. *)
let one_node = function
  | Certificate_check.Of_refinement (m, ls, s, li, i, n, e, p) ->
      let known = Hashtbl.create 50 in
      let locate u k = match Hashtbl.find_opt known u with
        | Some j -> j
        | None -> let j = p.locate u k in Hashtbl.add known u j; j in
      Certificate_check.Of_refinement (m, ls, s, li, i, n, e, { p with locate })
  | other -> other

(* In the place of one pair, another pair is visited, which has a large number. *)
let impostor proof =
  let far = 1 lsl 30 in
  let replace (p : int list pairs) victim =
    let far_of j = if j = victim then far else j in
    { p with
      state_of = (fun j -> p.state_of (if j = far then 0 else j));
      node_of = (fun j -> p.node_of (if j = far then 0 else j));
      place_of = (fun j -> p.place_of (if j = far then victim else j));
      deed = (fun t opened -> match p.deed t opened with Open j -> Open (far_of j) | other -> other) } in
  match proof with
  | Certificate_check.Of_refinement (m, ls, s, li, i, n, e, p) ->
      Certificate_check.Of_refinement (m, ls, s, li, i, n, e, replace p (Random.int 6))
  | Of_property (q, h, s, p) -> Of_property (q, h, s, replace p (Random.int 6))

let attacks = ref 0 and wrong = ref 0 and lost = ref 0 and held = ref 0 and failed = ref 0 and unreadable = ref 0
let lies_accepted = ref 0 and files_accepted = ref 0

let accepted_attack attempt =
  incr attacks;
  match Certificate_check.guarded (fun () -> if attempt () then Certified { pairs = 0; nodes = 0; transitions = 0; components = 0; rules = 0; reductions = [] } else Refused "") with
  | Certificate_check.Certified _ -> true
  | Refused "" -> false
  | Refused _ | Undecided _ -> incr unreadable; false

let report_wrong what seed trial =
  incr wrong;
  Printf.printf "WRONGLY ACCEPTED: %s, seed %d, trial %d\n%!" what seed trial

(* A damaged text: what it says decides, if it can be read. *)
let damaged text =
  let b = Bytes.of_string text in
  for _ = 0 to Random.int 3 do
    let at = Random.int (Bytes.length b) in
    Bytes.set b at (match Random.int 3 with 0 -> Char.chr (Char.code (Bytes.get b at) lxor (1 lsl Random.int 7)) | 1 -> Char.chr (48 + Random.int 10) | _ -> Char.chr (Random.int 128))
  done;
  let text = Bytes.to_string b in
  if Random.int 8 = 0 then String.sub text 0 (Random.int (String.length text)) else text

(* The process of a file, as the oracle reads it: with the reader's data, but its own semantics. *)
let process_of (p : Formats.process) =
  let rec part (Region (inside, rules)) =
    { inside = List.map (function Slot k -> S k | Inner r -> R (part r)) inside;
      rules = List.map (fun r -> (r.does, r.level, r.asks, r.puts)) rules } in
  { components = p.component_edges; initial = p.system.start; whole = part p.system.whole }
let term_of_file (t : Formats.script_text) =
  let { defines; main } = t.script in
  let set a = List.filter (defines.has a) visible in
  let renaming r = List.concat_map (fun e -> List.map (fun d -> (e, d)) (defines.names r e)) visible in
  let order o = List.filter_map (fun e -> Option.map (fun l -> (e, l)) (defines.priority o e)) visible in
  let rec term = function
    | Offer l -> Do (List.map (fun (e, p) -> (e, term p)) l)
    | Call k -> Name k
    | Choice (a, p, q) -> Ext (set a, term p, term q)
    | Sliding (p, q) -> Slide (term p, term q)
    | Sequence (p, q) -> Seq (term p, term q)
    | Interrupt (a, p, q) -> Inter (set a, term p, term q)
    | Throw (a, p, q) -> Exc (set a, term p, term q)
    | Parallel (a, b, c, p, q) -> Par (set a, set b, set c, term p, term q)
    | Hide (a, p) -> Hid (set a, term p)
    | Rename (r, p) -> Ren (renaming r, term p)
    | Prioritise (o, p) -> Pri (order o, term p) in
  (term main, term_steps (memo (fun k -> term (defines.body k))))

(* A process as the oracles see it: its initial state, and the transitions of its states. *)
type behaviour = Behaviour : 'state * ('state -> (int * 'state) list) -> behaviour
let of_process p = Behaviour (p.initial, successors p)
let of_term t = Behaviour (t.root, term_steps (Array.get t.bodies))
let of_file = function
  | Formats.Compiled p -> of_process (process_of p)
  | Formats.Term t -> let main, steps = term_of_file t in Behaviour (main, steps)
let truth ?(events = []) question spec (Behaviour (start, steps)) =
  let impl = (start, steps) in
  match (question, spec) with
  | Formats.Refinement m, Some (Behaviour (s, next)) -> refinement_holds m (s, next) impl
  | No_refinement m, Some (Behaviour (s, next)) -> not (refinement_holds m (s, next) impl)
  | Property p, None -> property_holds p impl
  | Determinism m, None -> is_deterministic m impl
  | Stays_possible, None -> stays_possible events impl
  | Has_trace, None -> has_trace events impl
  | _ -> false

let truth_in_files question (claim : Formats.claim) =
  truth question (Option.map of_file claim.specification) (of_file claim.implementation)

(* Splits that forget or confuse what a term does. The search then works with the components that they give. *)
let split_forges : (split -> split) list =
  let hash salt key = Hashtbl.hash (salt, key) in
  let salted f = let salt = Random.bits () in fun x -> f salt x in
  let confused = salted (fun salt x -> { x with number_of = (fun k p -> let v = x.number_of k p in if hash salt (k, v) mod 3 = 0 then hash salt (k, v, 1) mod max 1 (x.states k) else v) }) in
  let smaller = salted (fun salt x -> { x with states = (fun k -> max 1 (x.states k - (hash salt k mod 3))); number_of = (fun k p -> min (x.number_of k p) (max 0 (x.states k - 1 - (hash salt k mod 3)))) }) in
  let other_meaning = salted (fun salt x -> { x with meaning = (fun k v -> if hash salt (k, v) mod 4 = 0 then x.meaning k (hash salt (k, v, 1) mod max 1 (x.states k)) else x.meaning k v) }) in
  let stopped = salted (fun salt x -> { x with meaning = (fun k v -> if v > 0 && hash salt (k, v) mod 3 = 0 then Offer [] else x.meaning k v) }) in
  let deaf = salted (fun salt x -> { x with alphabet = (fun k -> List.filter (fun e -> hash salt (k, e) mod 4 > 0) (x.alphabet k)) }) in
  let rec leaves = function Leaf k -> [ k ] | Beside (_, _, _, t, u) -> leaves t @ leaves u | Hidden (_, t) | Renamed (_, t) | Prioritised (_, t) -> leaves t in
  let rec tree change = function
    | Beside (a, b, c, t, u) -> change (Beside (a, b, c, tree change t, tree change u))
    | Hidden (a, t) -> change (Hidden (a, tree change t))
    | Renamed (r, t) -> change (Renamed (r, tree change t))
    | Prioritised (o, t) -> change (Prioritised (o, tree change t))
    | leaf -> change leaf in
  let changed change x = { x with whole_tree = tree change x.whole_tree } in
  let without = changed (function (Hidden (_, t) | Renamed (_, t) | Prioritised (_, t)) when Random.bool () -> t | t -> t) in
  let one_side = changed (function Beside (_, _, _, t, u) when Random.int 3 = 0 -> if Random.bool () then t else u | t -> t) in
  let other_sets = changed (function Beside (a, b, c, t, u) when Random.bool () -> (match Random.int 3 with 0 -> Beside (c, b, c, t, u) | 1 -> Beside (a, c, c, t, u) | _ -> Beside (a, b, a, t, u)) | Hidden (a, t) when a > 0 -> Hidden (a - 1, t) | t -> t) in
  let swapped = changed (function Beside (a, b, c, t, u) when Random.bool () -> Beside (a, b, c, u, t) | t -> t) in
  let twice x =
    let first k = List.find (fun j -> x.meaning j 0 = x.meaning k 0) (leaves x.whole_tree) in
    changed (function Leaf k when Random.int 3 > 0 -> Leaf (first k) | t -> t) x in
  (* Terms with the same operator are one state. *)
  let operator = function
    | Offer l -> (0, List.map fst l) | Call k -> (1, [ k ]) | Choice (a, _, _) -> (2, [ a ]) | Sliding _ -> (3, []) | Sequence _ -> (4, [])
    | Interrupt (a, _, _) -> (5, [ a ]) | Throw (a, _, _) -> (6, [ a ]) | Parallel (a, b, c, _, _) -> (7, [ a; b; c ])
    | Hide (a, _) -> (8, [ a ]) | Rename (r, _) -> (9, [ r ]) | Prioritise (o, _) -> (10, [ o ]) in
  let alike x =
    { x with number_of = (fun k p ->
        let same v = operator (x.meaning k v) = operator p in
        Option.value ~default:(x.number_of k p) (List.find_opt same (List.init (x.states k) Fun.id))) } in
  let first = salted (fun salt x -> { x with number_of = (fun k p -> if x.number_of k p = 0 then 0 else if hash salt k mod 2 = 0 then 0 else x.number_of k p) }) in
  let started x = { x with meaning = (fun k v -> if x.states k > 1 && v = 0 then x.meaning k 1 else x.meaning k v) } in
  (* Only the first state is checked; the others confuse their targets. *)
  let outside x = { x with states = (fun k -> min 1 (x.states k)); number_of = (fun k p -> let v = x.number_of k p in if v > 1 then 0 else v) } in
  (* Nothing is checked. *)
  let emptied = salted (fun salt x -> { (confused x) with states = (fun k -> if hash salt k mod 2 = 0 then 0 else x.states k) }) in
  let short x = { x with enough = Random.int 4 } in
  let fewer x = { x with slots = max 0 (x.slots - 1) } in
  [ confused; alike; smaller; other_meaning; stopped; deaf; without; one_side; other_sets; swapped; twice; first; started; emptied; outside; short; fewer ]

(** Reductions that follow steps which are not confluent. *)

(* One condition that a forged reduction does not keep. *)
type overlooked =
  | Nothing | Visible_event | Later_level | Several_results | Not_enabled | Conflict | Disturbed_region | Left_cube | Other_event
  | Other_place | Equal_level | Other_rule | Any_cube | Untracked | Beside | Unread

let all_overlooked =
  [ Nothing; Visible_event; Later_level; Several_results; Not_enabled; Conflict; Disturbed_region; Left_cube; Other_event; Other_place;
    Equal_level; Other_rule; Any_cube; Untracked; Beside; Unread ]

(* Returns steps whose entries keep all conditions but one: the largest such set for some rules and tracked
   components. It follows each step for which it has an entry. *)
let forged_steps overlooked (claim : Formats.claim) (plan : Certificate_check.plan) =
  let system = merged plan.shape.merges plan.process.system in
  let row = rows_by_event plan.shape.packs system in
  let any = claim.question = Formats.Property Deadlock_free in
  let rules = Array.of_list (rules_of_whole system) in
  let sizes = Array.of_list plan.process.sizes in
  let count = Array.length sizes in
  let rec joint = function [] -> [ [] ] | k :: rest -> List.concat_map (fun c -> List.init sizes.(k) (fun v -> (k, v) :: c)) (joint rest) in
  let has k e v = List.exists (fun (d, _) -> d = e) (row k e v) in
  let ready cube = function
    | Performs (k, e) -> ( match List.assoc_opt k cube with Some v -> has k e v | None -> overlooked = Unread)
    | Sets _ -> true in
  let certain cube it =
    if overlooked = Several_results then ready cube it
    else match it with
      | Performs (k, _) when overlooked = Not_enabled || (overlooked = Unread && not (List.mem_assoc k cube)) -> k < count
      | _ -> sure system row cube it in
  let candidate r =
    List.for_all (fun it -> item_slot it < count) r.items
    && (any || r.performed = 0 || overlooked = Visible_event)
    && (overlooked = Later_level || not (List.exists (fun g -> g.prior) r.passages)) in
  let overrule g h = match (g.own.level, h.own.level) with
    | Some l, Some m -> (l < m || overlooked = Equal_level) && (g.place = h.place || overlooked = Other_place)
    | _ -> false in
  let impossible cube = function Performs (k, e) -> (match List.assoc_opt k cube with Some v -> not (has k e v) | None -> false) | Sets _ -> false in
  let stays r cube present w =
    List.exists (impossible cube) w.items
    || List.exists (fun h -> List.exists (fun g -> overrule g h) r.passages) w.passages
    || (w.items = r.items && (w.performed = r.performed || overlooked = Other_event))
    || (overlooked = Untracked && not (List.exists (fun it -> List.mem_assoc (item_slot it) cube) w.items))
    || (overlooked = Beside && not (List.exists (fun it -> List.mem (item_slot it) (List.map item_slot r.items)) w.items)
        && List.for_all (undisturbed row r.items cube) w.passages)
    || (overlooked = Conflict || List.for_all (commutes row r.items cube) w.items)
       && (overlooked = Disturbed_region || List.for_all (undisturbed row r.items cube) w.passages)
       && (List.mem overlooked [ Left_cube; Any_cube ] || List.for_all (fun o -> List.mem o present) (outcomes row cube w.items cube)) in
  let rec largest r present =
    let next = List.filter (fun cube -> Array.for_all (stays r cube present) rules) present in
    if List.length next = List.length present then present else largest r next in
  let entries_of n =
    let r = rules.(n) in
    let parts = List.sort_uniq compare (List.map item_slot r.items) in
    if not (candidate r) || List.length parts > 3 then []
    else begin
      let performing k = List.exists (function Performs (j, _) -> j = k | Sets _ -> false) r.items in
      let parts = match overlooked with
        | Unread -> List.filter (fun _ -> Random.bool ()) parts
        | Untracked -> List.filter performing parts
        | _ -> parts in
      let beside = List.filter (fun k -> not (List.mem k parts) && Random.bool ()) (List.init count Fun.id) in
      (* The time is quadratic in the number of joint states. *)
      let few parts = List.fold_left (fun n k -> n * sizes.(k)) 1 parts <= 500 in
      let tracked = List.find_opt few [ parts @ beside; parts ] in
      let cubes = List.filter (fun c -> List.for_all (certain c) r.items) (Option.fold ~none:[] ~some:joint tracked) in
      List.map (fun c -> (n, c)) (largest r cubes)
    end in
  let chosen = List.filter (fun _ -> Random.int 3 > 0) (List.init (min 30 (Array.length rules)) Fun.id) in
  let entries = Array.of_list (List.concat_map entries_of chosen) in
  let total = Array.length entries in
  let index f = let rec from i = if i = total || f i then i else from (i + 1) in from 0 in
  let fields = Follow.fields_of plan.shape.packs in
  let perform locals j =
    let n, _ = entries.(j) in
    let after = Array.copy locals in
    List.iter (function Performs (k, e) -> after.(k) <- goal row k e locals.(k) | Sets (k, x) -> after.(k) <- x) rules.(n).items;
    after in
  let rec path locals left =
    if left = 0 then []
    else
      let j = index (fun i -> List.for_all (fun (k, v) -> locals.(k) = v) (snd entries.(i))) in
      if j = total then [] else j :: path (perform locals j) (left - 1) in
  let longest = 1 + Random.int 6 in
  { entries = total; follows = (fun j -> fst entries.(j)); states_of = (fun j -> snd entries.(j));
    entry_after = (fun j cube ->
      let fits i = List.for_all (fun (k, v) -> List.assoc_opt k cube = Some v) (snd entries.(i)) in
      let same i = fst entries.(i) = fst entries.(j) in
      index (fun i -> match overlooked with Other_rule -> fits i | Any_cube -> same i | _ -> fits i && same i));
    hint = (fun words -> path (Follow.unpack fields words) longest) }

(* Steps that lie in some places. *)
let lying_steps (r : confluent_steps) =
  let salt = Random.bits () and rate = 1 + Random.int 6 in
  let lie kind key honest other = if Hashtbl.hash (salt, kind, key) mod rate = 0 then other (abs (Hashtbl.hash (salt, key, kind, 1))) else honest in
  let any n = n mod max 1 r.entries in
  { r with follows = (fun j -> lie 1 j (r.follows j) (fun n -> n mod (r.follows j + 2)));
    states_of = (fun j -> lie 2 j (r.states_of j) (fun n -> match r.states_of (any n) with _ :: rest when n mod 3 = 0 -> rest | c -> c));
    entry_after = (fun j c -> lie 3 (j, c) (r.entry_after j c) any);
    hint = (fun w -> lie 4 w (r.hint w) (fun n -> any n :: r.hint w)) }

let reductions = ref 0 and symmetric = ref 0 and forged_accepted = ref 0

let judge_honest seed trial claim truth =
  match Certificate_check.certify claim ~most with
  | Certified figures ->
      if figures.reductions <> [] then incr reductions;
      if List.mem "symmetry" figures.reductions then incr symmetric;
      if truth then incr held else report_wrong "an honest search" seed trial
  | Refused why | Undecided why ->
      if truth then (incr lost; Printf.printf "REFUSED THOUGH IT HOLDS: seed %d, trial %d: %s\n%!" seed trial why) else incr failed

let reduced claim reduction () =
  let plan = Certificate_check.plan_of claim ~most in
  let _, _, accepts = Certificate_check.check_on_the_way ~reduction plan ~most in
  accepts

let attack_question ~all seed trial question spec_text impl_text truth =
  let claim = claim_of question spec_text impl_text in
  judge_honest seed trial claim truth;
  let attempt forge tell () =
    let proof, _, _ = Certificate_check.prove ~lenient:true ~forge claim ~most in
    Certificate_check.accepted (tell proof) in
  let on_the_way forge tell () =
    let plan = Certificate_check.plan_of ~forge claim ~most in
    let walk = Search.new_walk (Certificate_check.width plan.shape) in
    let pairs = Search.pairs_on_the_way walk plan.choose ~ordered:plan.task.forbid_cycles ~most in
    try Certificate_check.accepted (tell (plan.completed pairs)) with Search.Loop_of_taus -> false in
  let plan = Certificate_check.plan_of claim ~most in
  List.iter (fun overlooked ->
    let steps = forged_steps overlooked claim plan in
    let judge what steps = if accepted_attack (reduced claim { confluent = Some steps; symmetric = []; turns = (fun _ -> []) }) then if truth then incr forged_accepted else report_wrong what seed trial in
    if steps.entries > 0 then begin
      judge "forged steps" steps;
      judge "lying steps" (lying_steps steps)
    end) all_overlooked;
  List.iter (fun forge ->
    if accepted_attack (attempt forge Fun.id) && not truth then report_wrong "a forged normal form" seed trial;
    if accepted_attack (on_the_way forge Fun.id) && not truth then report_wrong "a walk" seed trial;
    if accepted_attack (on_the_way forge lying) && not truth then report_wrong "a lie on the way" seed trial;
    if accepted_attack (attempt forge loose) && not truth then report_wrong "loose evidence" seed trial;
    if accepted_attack (on_the_way forge one_node) && not truth then report_wrong "one node for each state" seed trial;
    if accepted_attack (attempt forge impostor) && not truth then report_wrong "an impostor" seed trial;
    if accepted_attack (attempt forge looping) && not truth then report_wrong "a loop" seed trial;
    if accepted_attack (attempt forge chained) && not truth then report_wrong "a chain" seed trial;
    if accepted_attack (attempt forge circular) && not truth then report_wrong "a circle" seed trial;
    for _ = 1 to 3 do
      if accepted_attack (attempt forge lying) then (if truth then incr lies_accepted else report_wrong "a lie" seed trial)
    done) (if all then forges else []);
  (match claim.implementation with
  | Formats.Compiled _ -> ()
  | Formats.Term _ ->
      List.iter (fun split_forge ->
        let attempt () =
          let proof, _, _ = Certificate_check.prove ~lenient:true ~split_forge claim ~most in
          Certificate_check.accepted proof in
        if accepted_attack attempt then (if truth then incr lies_accepted else report_wrong "a forged split" seed trial)) (if all then split_forges else []));
  for _ = 1 to if all then 4 else 0 do
    let spec_text = Option.map (fun t -> if Random.bool () then damaged t else t) spec_text in
    let impl_text = damaged impl_text in
    match claim_of question spec_text impl_text with
    | exception Formats.Unreadable _ -> incr attacks; incr unreadable
    | claim ->
        if accepted_attack (fun () -> match Certificate_check.certify claim ~most:2_000 with Certified _ -> true | Refused _ | Undecided _ -> false) then begin
          incr files_accepted;
          let holds = truth_in_files question claim in
          if not holds then report_wrong "a damaged file" seed trial
        end
  done

(** Processes with equal components, and automorphisms of other processes. *)

let shuffled l = List.map snd (List.sort compare (List.map (fun x -> (Random.bits (), x)) l))

(* A process of two or three copies of some components. The copies may have other numbers of states and other events than
   the first, and each may be a region. With `twice`, a component beside them occurs twice. *)
let copied ~twice =
  let copies = 2 + Random.int 2 in
  let parts = if copies = 2 && Random.int 3 = 0 then 2 else 1 in
  let size = 2 + Random.int 2 in
  (* A component with random transitions, or a cycle. *)
  let cyclic = Random.int 3 = 0 in
  let row v = if cyclic then [ (pick inner, (v + 1) mod size) ] else times (Random.int 4) (fun () -> (pick inner, Random.int size)) in
  let template = Array.init parts (fun _ -> Array.init size row) in
  let first = Array.init parts (fun _ -> Random.int size) in
  let copy () =
    Array.map2
      (fun rows start ->
        let number = Array.of_list (if Random.bool () then List.init size Fun.id else shuffled (List.init size Fun.id)) in
        let result = Array.make size [] in
        Array.iteri (fun v row -> result.(number.(v)) <- shuffled (List.map (fun (e, u) -> (e, number.(u))) row)) rows;
        (result, number.(start)))
      template first
  in
  let made = Array.concat (List.init copies (fun _ -> copy ())) in
  let beside = twice || Random.int 3 = 0 in
  let other = Array.init 2 (fun _ -> times (if twice then 3 else Random.int 3) (fun () -> (pick inner, Random.int 2))) in
  let components = Array.append (Array.map fst made) (if beside then [| other |] else [||]) in
  let initial = Array.to_list (Array.map snd made) @ if beside then [ Random.int 2 ] else [] in
  let slot c p = (c * parts) + p in
  let level () = if Random.bool () then None else Some (Random.int 2) in
  let nested = Random.bool () in
  let inner_rules = times 4 (fun () -> (pick inner, level (), Random.int parts, pick inner)) in
  let region c =
    { inside = List.init parts (fun p -> S (slot c p));
      rules = List.map (fun (does, level, p, e) -> (does, level, [ (p, e) ], [])) inner_rules }
  in
  let inside = (if nested then List.init copies (fun c -> R (region c)) else List.init (copies * parts) (fun k -> S k)) @ (if beside then [ S (copies * parts) ] else []) @ if twice then [ S (copies * parts) ] else [] in
  let place c p = if nested then c else slot c p in
  let env = List.length inside - 1 in
  (* A rule for each copy, each pair of copies, or all copies together. *)
  let rules () =
    let level = level () and e = pick inner and d = pick inner and p = Random.int parts in
    let name = if Random.bool () then fun c -> 5 + c else let name = pick [ 0; 0; 1; 5; 6 ] in fun _ -> name in
    let all = List.init copies Fun.id in
    match Random.int 5 with
    | (0 | 1) when twice -> List.map (fun c -> (name c, level, shuffled [ (place c p, e); (env, d); (env - 1, pick [ d; e ]) ], [])) all
    | 0 when beside -> List.map (fun c -> (name c, level, [ (place c p, e); (env, d) ], [])) all
    | 1 -> List.concat_map (fun c -> List.filter_map (fun b -> if b = c then None else Some (name c, level, [ (place c p, e); (place b p, d) ], [])) all) all
    | 2 -> [ ((if Random.bool () then 0 else 5), level, shuffled (List.map (fun c -> (place c p, e)) all), []) ]
    | _ -> List.map (fun c -> (name c, level, [ (place c p, e) ], [])) all
  in
  let rules = shuffled (List.concat (times (2 + Random.int 3) rules)) in
  { components; initial; whole = { inside; rules } }

(* A process that treats the visible events alike, and tick like them or not. *)
let indifferent process =
  let alike = if Random.int 3 = 0 then [ 1; 5; 6; 7 ] else [ 5; 6; 7 ] in
  let copies ((d, l, a, pu) as rule) = if not (List.mem d alike) then [ rule ] else List.map (fun d -> (d, l, a, pu)) alike in
  { process with whole = { process.whole with rules = List.concat_map copies process.whole.rules } }

let with_rule process change =
  let at = Random.int (List.length process.whole.rules) in
  { process with whole = { process.whole with rules = List.mapi (fun i rule -> if i = at then change rule else rule) process.whole.rules } }

(* A rule sets the state of a component. *)
let assigning process =
  let k = Random.int (Array.length process.components) in
  let v = Random.int (Array.length process.components.(k)) in
  with_rule process (fun (d, l, a, _) -> (d, l, a, [ (k, v) ]))

(* A component occurs twice. *)
let doubled process =
  let k = Random.int (Array.length process.components) in
  let process = { process with whole = { process.whole with inside = process.whole.inside @ [ S k ] } } in
  let last = List.length process.whole.inside - 1 in
  with_rule process (fun (d, l, a, pu) -> (d, l, (if Random.bool () then a @ [ (last, pick inner) ] else [ (last, pick inner) ]), pu))

(* Two participants together perform an event that their images cannot perform. *)
let skewed process =
  let count = List.length process.whole.inside in
  let i = Random.int count in
  let j = (i + 1 + Random.int (max 1 (count - 1))) mod count in
  let rule = (pick [ 0; 1; 5; 6; 7 ], (if Random.bool () then None else Some 0), (if i = j then [ (i, pick inner) ] else [ (i, pick inner); (j, pick inner) ]), []) in
  { process with whole = { process.whole with rules = process.whole.rules @ [ rule ] } }

(* A rule requires an event that no component performs. *)
let without_a_rule process = with_rule process (fun (d, l, a, pu) -> (d, l, (fst (List.hd a), 1) :: List.tl a, pu))

(* The automorphism, with additional rules that correspond to themselves. *)
let for_more_rules g =
  let more f i = try f i with Invalid_argument _ -> i in
  let rec tree m = { m with rule_to = more m.rule_to; rule_from = more m.rule_from; deeper = (fun i -> tree (m.deeper i)) } in
  { g with tree = tree g.tree }

(* An automorphism that lies in some places. *)
let lying_automorphism g =
  let salt = Random.bits () and rate = 2 + Random.int 8 in
  let lie kind key honest other = if Hashtbl.hash (salt, kind, key) mod rate = 0 then other (abs (Hashtbl.hash (salt, key, kind, 1))) else honest in
  let on kind f x = lie kind x (f x) (fun n -> if n mod 2 = 0 then x else n mod 8) in
  let pull (k, p) =
    ( lie 1 k k (fun n -> n mod 8),
      { source0 = lie 2 k p.source0 (fun n -> n mod 8); send = (fun v -> lie 3 (k, v) (p.send v) (fun n -> n mod 3));
        rename = (fun e -> lie 4 (k, e) (p.rename e) (fun n -> n mod 5)); restore = (fun e -> lie 5 (k, e) (p.restore e) (fun n -> n mod 5)) } )
  in
  let rec mapping depth m =
    { new_place = on (10 + depth) m.new_place; new_name = on (20 + depth) m.new_name; old_name = on (30 + depth) m.old_name;
      rule_to = on (40 + depth) m.rule_to; rule_from = on (50 + depth) m.rule_from; deeper = (fun i -> mapping (depth + 1) (m.deeper i)) }
  in
  let pulls = match Random.int 6 with 0 -> List.tl g.pulls | 1 -> g.pulls @ [ List.hd g.pulls ] | 2 -> List.map pull g.pulls | _ -> g.pulls in
  { pulls; tree = (if Random.bool () then g.tree else mapping 0 g.tree); instead = (if Random.bool () then g.instead else fun n i -> lie 60 (n, i) (g.instead n i) (fun n -> n mod 3)) }

(* The exchanges that are found in a process, and words of them that lead each state to the least one that is found. *)
let exchanges_in (claim : Formats.claim) =
  let plan = Certificate_check.plan_of claim ~most in
  if not (shape_ok plan.shape plan.process.system) then None
  else Certificate_check.exchanges_of plan ~indifferent:(fun _ -> true)

(* Leads each state to one of its images, which depends on a number. So other states are visited for another number. *)
let random_turns (layout : layout) symmetric =
  let salt = Random.bits () in
  let generators = List.map (fun g -> List.map (fields_of_pull layout) g.pulls) symmetric in
  let turns words =
    let paths = Hashtbl.create 16 in
    let rec visit path words =
      if Hashtbl.length paths < 24 && not (Hashtbl.mem paths words) then begin
        Hashtbl.add paths words (List.rev path);
        List.iteri (fun i g -> visit (i :: path) (turned g words)) generators
      end
    in
    visit [] words;
    let choose words path best =
      let key = Hashtbl.hash (salt, words) in
      match best with Some (k, _) when k <= key -> best | _ -> Some (key, path)
    in
    match Hashtbl.fold choose paths None with Some (_, path) -> path | None -> []
  in
  memo turns

(* Exchanges an event of the whole process with tau or tick, in the process and in the automorphism. *)
let exchanged_event event other process =
  let exchange e = if e = event then other else if e = other then event else e in
  let renamed f e = exchange (f (exchange e)) in
  let tree m = { m with new_name = renamed m.new_name; old_name = renamed m.old_name } in
  ( { process with whole = { process.whole with rules = List.map (fun (d, l, a, pu) -> (exchange d, l, a, pu)) process.whole.rules } },
    fun g -> { g with tree = tree g.tree } )

let attack_symmetric seed trial =
  let process = copied ~twice:(Random.int 3 = 0) in
  let spec = match Random.int 4 with 0 -> process | 1 -> mutated process | 2 -> indifferent process | _ -> indifferent (random_process ~busy:false) in
  let other () = match Random.int 8 with 0 -> assigning process | 1 -> doubled process | 2 | 3 -> without_a_rule process | 4 | 5 -> skewed process | _ -> mutated process in
  let attack question spec_of =
    let claim_about p = claim_of question (Option.map text spec_of) (text p) in
    let truth p = truth question (Option.map of_process spec_of) (of_process p) in
    judge_honest seed trial (claim_about process) (truth process);
    match exchanges_in (claim_about process) with
    | None -> ()
    | Some (symmetric, turns) ->
        (* Processes that differ a little from one that satisfies the claim. *)
        let others = if truth process then List.filter (fun p -> not (truth p)) (times 12 other) else [ other () ] in
        let others = process :: List.filteri (fun i _ -> i < 4) others in
        List.iter (fun p -> judge_honest seed trial (claim_about p) (truth p)) (List.tl others);
        let exchanged = [ exchanged_event 0 (pick [ 5; 6 ]) process; exchanged_event 1 (pick [ 5; 6 ]) process ] in
        List.iter
          (fun (p, change) ->
            let symmetric = List.map change symmetric and claim = claim_about p in
            let holds = lazy (truth p) in
            let judge what reduction =
              if accepted_attack (reduced claim reduction) then
                if Lazy.force holds then incr forged_accepted else report_wrong what seed trial
            in
            judge "automorphisms of another process" { confluent = None; symmetric; turns };
            let layout = (Certificate_check.plan_of claim ~most).shape.packs in
            for _ = 1 to 4 do
              judge "automorphisms at random" { confluent = None; symmetric; turns = random_turns layout symmetric };
              let symmetric = List.map lying_automorphism symmetric in
              judge "lying automorphisms" { confluent = None; symmetric; turns = (if Random.bool () then turns else random_turns layout symmetric) }
            done)
          (List.map (fun p -> (p, for_more_rules)) others @ exchanged)
  in
  List.iter (fun m -> attack (Formats.Refinement m) (Some spec)) [ T; F; FD ];
  List.iter (fun p -> attack (Formats.Property p) None) [ Deadlock_free; Deadlock_and_divergence_free; Divergence_free ]

(** Determinism, events that stay possible, traces, and refinements that fail. *)

let random_run ?from (lts : Search.words lts) =
  let rec go s left = match lts.succ0 s with
    | [] -> []
    | moves -> if left = 0 then [] else let a, u = pick moves in (a, u) :: go u (left - 1) in
  go (Option.value ~default:lts.init from) (Random.int 5)

(* A run from a state, which ends when it is back in this state. *)
let random_loop lts state =
  let rec until_back = function
    | [] -> []
    | (a, u) :: rest -> (a, u) :: if u = state then [] else until_back rest in
  until_back (random_run ~from:state lts)

(* A run in which one move leads elsewhere. *)
let broken_run run =
  let at = Random.int (max 1 (List.length run)) in
  List.mapi (fun i (a, u) -> if i <> at then (a, u) else match Random.int 3 with
    | 0 -> (Random.int 7, u)
    | 1 -> (a, List.map (fun w -> w lxor (1 lsl Random.int 4)) u)
    | _ -> (a, snd (pick run))) run

let forged_numbering (n : int list numbering) =
  let salt = Random.bits () and kind = Random.int 4 in
  let lie key honest other = if Hashtbl.hash (salt, key) mod 3 = 0 then other (abs (Hashtbl.hash (salt, key, 1))) else honest in
  match kind with
  | 0 -> { n with distance = (fun j -> Hashtbl.hash (salt, j) mod 9) }
  | 1 -> { n with state_number = (fun s -> lie s (n.state_number s) (fun r -> r mod max 1 n.state_count)) }
  | 2 -> { n with state_count = Random.int (n.state_count + 1); state_number = (fun s -> min (n.state_number s) (Random.int (n.state_count + 1))) }
  | _ -> { n with numbered_state = (fun j -> lie j (n.numbered_state j) (fun r -> n.numbered_state (r mod (j + 1)))); distance = (fun j -> lie (-j) (n.distance j) (fun r -> r mod 5)) }

(* Evidence for a claim of this kind, right or wrong, also for a term that is split wrongly. *)
let forged_evidence (claim : Formats.claim) () =
  let split_forge = if Random.bool () then Fun.id else pick split_forges in
  let side_of given = Certificate_check.side_of ~forge:split_forge given ~event_count:claim.event_count ~most in
  let impl = side_of claim.implementation in
  let lts = Certificate_check.lts_of impl in
  let name = string_of_int and width = Certificate_check.width impl.shape in
  let proof : Certificate_check.proof = match (claim.question, claim.specification) with
    | Formats.Stays_possible, _ ->
        let found, distance, _ = Search.distances lts width claim.events ~most ~name ~state_name:(fun _ -> "") in
        Of_possible (claim.events, impl.shape, impl.subject, forged_numbering (Search.numbering_of found distance))
    | Has_trace, _ -> Of_trace (claim.events, impl.shape, impl.subject, let run = random_run lts in if Random.bool () then broken_run run else run)
    | No_refinement model, Some spec ->
        let run = random_run lts in
        let run = if Random.int 3 = 0 then broken_run run else run in
        let loop = random_loop lts (List.fold_left (fun _ (_, u) -> u) lts.init run) in
        let loop = if Random.bool () then List.filter (fun (a, _) -> a = 0) loop else loop in
        let performs, refutation = pick [ (true, By_event run); (false, By_refusal run); (false, By_divergence (run, loop)) ] in
        let proof, _ =
          Certificate_check.refutation_of ~lenient:true claim model (side_of spec) impl
            (Certificate_check.shown_by run performs refutation) ~most in
        if Random.bool () then proof
        else (match proof with
          | Of_refutation (m, hs, s, hi, i, r, p) ->
              (match lying (Certificate_check.Of_property (Deadlock_free, hi, i, p)) with
              | Of_property (_, _, _, p) -> Of_refutation (m, hs, s, hi, i, r, p)
              | other -> other)
          | other -> other)
    | Determinism _, _ ->
        let forge_graph rows =
          let count = Array.length rows in
          let change row = List.filter_map (fun (a, j) -> match Random.int 4 with 0 -> None | 1 -> Some (a, Random.int count) | _ -> Some (a, j)) row in
          let more row = if Random.bool () then row else (1 + Random.int 6, Random.int count) :: row in
          (* Other events follow tick. *)
          let unfinished row = if List.mem_assoc 1 row then row @ [ (2 + Random.int 5, Random.int count) ] else row in
          if Random.int 3 = 0 then Array.map unfinished rows else Array.map (fun row -> more (change row)) rows in
        let plan = Certificate_check.plan_of ~forge:(pick forges) ~split_forge ~forge_graph claim ~most in
        plan.completed (Search.pairs_record (Certificate_check.search_pairs ~lenient:true plan ~most) plan.choose)
    | _ -> raise Not_found in
  Certificate_check.accepted proof

let attack_shown seed trial question ?events spec_text impl_text truth =
  let claim = claim_of ?events question spec_text impl_text in
  judge_honest seed trial claim truth;
  let judge what attempt = if accepted_attack attempt then if truth then incr lies_accepted else report_wrong what seed trial in
  for _ = 1 to 12 do judge "forged evidence" (forged_evidence claim) done;
  let honest split_forge () =
    let proof = match question with
      | Formats.Determinism _ -> let proof, _, _ = Certificate_check.prove ~lenient:true ~split_forge claim ~most in proof
      | _ -> (Certificate_check.show ~split_forge claim ~most).proof in
    Certificate_check.accepted proof in
  if Formats.level_of claim.implementation = "term" then
    List.iter (fun split_forge -> judge "a forged split" (honest split_forge)) split_forges

let attack_all_shown seed trial (spec_text, spec) (impl_text, impl) =
  let some_events = List.filter (fun _ -> Random.int 3 = 0) [ 1; 2; 3; 4; 5; 6 ] in
  let trace = times (Random.int 4) (fun () -> 1 + Random.int 6) in
  let about_one ?events question = attack_shown seed trial question ?events None impl_text (truth ?events question None impl) in
  about_one (Determinism F);
  about_one (Determinism FD);
  about_one Stays_possible ~events:some_events;
  about_one Has_trace ~events:trace;
  List.iter (fun m ->
    let question = Formats.No_refinement m in
    attack_shown seed trial question (Some spec_text) impl_text (truth question (Some spec) impl)) [ T; F; FD ]

let attack_trial seed trial ~all =
  let attack_both (spec_text, spec_truth) (impl_text, impl_truth) =
    List.iter (fun m ->
      let question = Formats.Refinement m in
      attack_question ~all seed trial question (Some spec_text) impl_text (truth question (Some spec_truth) impl_truth)) [ T; F; FD ];
    List.iter (fun p ->
      let question = Formats.Property p in
      attack_question ~all seed trial question None impl_text (truth question None impl_truth))
      [ Deadlock_free; Deadlock_and_divergence_free; Divergence_free ] in
  let spec = random_process ~busy:(not all) in
  let impl = if Random.int 7 = 0 then random_process ~busy:(not all) else if all || Random.bool () then mutated spec else extended spec in
  let compiled p = (text p, of_process p) in
  attack_both (compiled spec) (compiled impl);
  if all then begin
    attack_all_shown seed trial (compiled spec) (compiled impl);
    let spec = small random_script in
    let impl = small (fun () -> if Random.int 7 = 0 then random_script () else mutated_script spec) in
    let term t = (script_text t, of_term t) in
    attack_both (term spec) (term impl);
    attack_all_shown seed trial (term spec) (term impl)
  end

let () =
  let seed = int_of_string Sys.argv.(1) and trials = int_of_string Sys.argv.(2) in
  let kind = if Array.length Sys.argv < 4 then "all" else Sys.argv.(3) in
  for trial = 1 to trials do
    Random.init ((1_000_003 * seed) + trial);
    if kind <> "symmetry" then attack_trial seed trial ~all:(kind = "all");
    if kind <> "reductions" then attack_symmetric seed trial
  done;
  Printf.printf "%d trials: %d claims hold, %d fail; %d attacks (%d could not be read, %d lies and %d damaged files that still hold, %d forged reductions of claims that hold); %d certificates reduced, %d by symmetry; %d wrongly accepted, %d wrongly refused\n"
    trials !held !failed !attacks !unreadable !lies_accepted !files_accepted !forged_accepted !reductions !symmetric !wrong !lost;
  let missing = !held = 0 || !failed = 0 || !reductions = 0 || (kind <> "reductions" && !symmetric = 0) in
  exit (if !wrong = 0 && !lost = 0 && not missing then 0 else 1)
