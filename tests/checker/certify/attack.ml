(* SPDX-License-Identifier: Apache-2.0 *)
(* Attacks on the certifier. Random processes, an oracle that is independent of the certifier, and certificates of claims
   that fail: made by a search that overlooks violations, with forged normal forms and reductions, with functions that lie, with damaged
   files. None of them may be accepted; every true claim must be. attack SEED TRIALS, or attack SEED TRIALS reductions
   for the attacks with forged reductions alone. *)
open Verified

type 'a array = 'a Array.t

let pick l = List.nth l (Random.int (List.length l))
let times n f = List.init n (fun _ -> f ())

(** Random processes, as data of their own. *)
type participant = S of int | R of part
and part = { inside : participant list; rules : (int * int option * (int * int) list * (int * int) list) list }
type random = { components : (int * int) list array array; initial : int list; whole : part }

(* Events: 0 tau, 1 tick, 2 to 4 of components, 5 and 6 of the whole. *)
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
  add "robochart-verify process 1\nevents 5\na\nb\nc\nx\ny\ncomponents %d\n" (Array.length process.components);
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

let refinement_holds model spec impl =
  let ss = memo (successors spec) and si = memo (successors impl) in
  let close l = reachable ss l (fun e -> e = 0) in
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
                     let next = close (List.concat_map (fun v -> List.filter_map (fun (e', w) -> if e = e' then Some w else None) (ss v)) set) in
                     next <> [] && check u next)
                 (si s)
       end
  in
  check impl.initial (close [ spec.initial ])

let property_holds property impl =
  let si = memo (successors impl) in
  let all = reachable si [ impl.initial ] (fun _ -> true) in
  (property = Divergence_free || List.for_all (fun s -> si s <> []) all)
  && (property = Deadlock_free || not (List.exists (diverges si) all))

(** Attacks. *)
let claim_of question specification implementation : Formats.claim =
  let names = Formats.no_names () in
  let read text = Formats.read_process names "process" text in
  let specification = Option.map read specification in
  let implementation = read implementation in
  { question; question_text = ""; assertion = ""; source = ""; specification; implementation;
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
      let lts = compact ls s in
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
      let lts = compact ls s in
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
      let lts = compact ls s in
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
  match Certificate_check.guarded (fun () -> if attempt () then Certified { pairs = 0; nodes = 0; transitions = 0; components = 0; rules = 0; reduced = false } else Refused "") with
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

(* The random process that a text says, as the oracle reads it: with the reader's data, but its own semantics. *)
let process_of (p : Formats.process) =
  let rec part (Region (inside, rules)) =
    { inside = List.map (function Slot k -> S k | Inner r -> R (part r)) inside;
      rules = List.map (fun r -> (r.does, r.level, r.asks, r.puts)) rules } in
  { components = p.component_edges; initial = p.system.start; whole = part p.system.whole }

(** Reductions that follow steps which are not confluent. *)

(* One condition that a forged reduction does not keep. *)
type overlooked =
  | Nothing | Visible_event | Later_level | Several_results | Not_enabled | Conflict | Disturbed_region | Left_cube | Other_event
  | Other_place | Equal_level | Other_rule | Any_cube | Untracked | Beside | Unread

let all_overlooked =
  [ Nothing; Visible_event; Later_level; Several_results; Not_enabled; Conflict; Disturbed_region; Left_cube; Other_event; Other_place;
    Equal_level; Other_rule; Any_cube; Untracked; Beside; Unread ]

(* Returns a reduction whose entries keep all conditions but one: the largest such set for some rules and tracked
   components. It follows each step for which it has an entry. *)
let forged_reduction overlooked (claim : Formats.claim) (plan : Certificate_check.plan) =
  let system = merged plan.shape.merges claim.implementation.system in
  let row = rows_by_event plan.shape.packs system in
  let any = claim.question = Formats.Property Deadlock_free in
  let rules = Array.of_list (rules_of_whole system) in
  let sizes = Array.of_list claim.implementation.sizes in
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
      let cubes = List.filter (fun c -> List.for_all (certain c) r.items) (joint (parts @ beside)) in
      List.map (fun c -> (n, c)) (largest r cubes)
    end in
  let chosen = List.filter (fun _ -> Random.int 3 > 0) (List.init (min 30 (Array.length rules)) Fun.id) in
  let entries = Array.of_list (List.concat_map entries_of chosen) in
  let total = Array.length entries in
  let index f = let rec from i = if i = total || f i then i else from (i + 1) in from 0 in
  let fields = Follow.fields_of plan.shape.packs in
  let unpack words = Array.map (fun (w, shift, bits) -> (List.nth words w lsr shift) land ((1 lsl bits) - 1)) fields in
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
    hint = (fun words -> path (unpack words) longest) }

(* A reduction that lies in some places. *)
let lying_reduction (r : reduction) =
  let salt = Random.bits () and rate = 1 + Random.int 6 in
  let lie kind key honest other = if Hashtbl.hash (salt, kind, key) mod rate = 0 then other (abs (Hashtbl.hash (salt, key, kind, 1))) else honest in
  let any n = n mod max 1 r.entries in
  { r with follows = (fun j -> lie 1 j (r.follows j) (fun n -> n mod (r.follows j + 2)));
    states_of = (fun j -> lie 2 j (r.states_of j) (fun n -> match r.states_of (any n) with _ :: rest when n mod 3 = 0 -> rest | c -> c));
    entry_after = (fun j c -> lie 3 (j, c) (r.entry_after j c) any);
    hint = (fun w -> lie 4 w (r.hint w) (fun n -> any n :: r.hint w)) }

let reductions = ref 0 and forged_accepted = ref 0

let attack_question ~all seed trial question spec impl truth =
  let spec_text = Option.map text spec in
  let claim = claim_of question spec_text (text impl) in
  (match Certificate_check.certify claim ~most with
  | Certified figures -> if figures.reduced then incr reductions; if truth then incr held else report_wrong "an honest search" seed trial
  | Refused why | Undecided why -> if truth then (incr lost; Printf.printf "REFUSED THOUGH IT HOLDS: seed %d, trial %d: %s\n%!" seed trial why) else incr failed);
  let attempt forge tell () =
    let proof, _, _ = Certificate_check.prove ~lenient:true ~forge claim ~most in
    Certificate_check.accepted (tell proof) in
  let on_the_way forge tell () =
    let plan = Certificate_check.plan_of ~forge claim ~most in
    let walk = Search.new_walk (Certificate_check.width plan.shape) in
    let pairs = Search.pairs_on_the_way walk plan.choose ~ordered:plan.task.forbid_cycles ~most in
    try Certificate_check.accepted (tell (plan.completed pairs)) with Search.Loop_of_taus -> false in
  let reduced reduction () =
    let plan = Certificate_check.plan_of claim ~most in
    let _, _, accepts = Certificate_check.check_on_the_way ~reduction plan ~most in
    accepts in
  let plan = Certificate_check.plan_of claim ~most in
  List.iter (fun overlooked ->
    let reduction = forged_reduction overlooked claim plan in
    let judge what reduction = if accepted_attack (reduced reduction) then if truth then incr forged_accepted else report_wrong what seed trial in
    if reduction.entries > 0 then begin
      judge "a forged reduction" reduction;
      judge "a lying reduction" (lying_reduction reduction)
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
  for _ = 1 to if all then 4 else 0 do
    let spec_text = Option.map (fun t -> if Random.bool () then damaged t else t) spec_text in
    let impl_text = damaged (text impl) in
    match claim_of question spec_text impl_text with
    | exception Formats.Unreadable _ -> incr attacks; incr unreadable
    | claim ->
        if accepted_attack (fun () -> match Certificate_check.certify claim ~most:2_000 with Certified _ -> true | Refused _ | Undecided _ -> false) then begin
          incr files_accepted;
          let impl = process_of claim.implementation in
          let holds = match (question, claim.specification) with
            | Formats.Refinement m, Some s -> refinement_holds m (process_of s) impl
            | Formats.Property p, _ -> property_holds p impl
            | _ -> false in
          if not holds then report_wrong "a damaged file" seed trial
        end
  done

let () =
  let seed = int_of_string Sys.argv.(1) and trials = int_of_string Sys.argv.(2) in
  let all = Array.length Sys.argv < 4 in
  for trial = 1 to trials do
    Random.init ((1_000_003 * seed) + trial);
    let spec = random_process ~busy:(not all) in
    let impl = if Random.int 7 = 0 then random_process ~busy:(not all) else if all || Random.bool () then mutated spec else extended spec in
    List.iter (fun m -> attack_question ~all seed trial (Formats.Refinement m) (Some spec) impl (refinement_holds m spec impl)) [ T; F; FD ];
    List.iter (fun p -> attack_question ~all seed trial (Formats.Property p) None impl (property_holds p impl))
      [ Deadlock_free; Deadlock_and_divergence_free; Divergence_free ]
  done;
  Printf.printf "%d trials: %d claims hold, %d fail; %d attacks (%d could not be read, %d lies and %d damaged files that still hold, %d forged reductions of claims that hold); %d certificates reduced; %d wrongly accepted, %d wrongly refused\n"
    trials !held !failed !attacks !unreadable !lies_accepted !files_accepted !forged_accepted !reductions !wrong !lost;
  exit (if !wrong = 0 && !lost = 0 && !held > 0 && !failed > 0 && !reductions > 0 then 0 else 1)
