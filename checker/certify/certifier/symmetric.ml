(* SPDX-License-Identifier: Apache-2.0 *)
(* Finds components that can be exchanged (docs/search.md, "Symmetry"), so that the search visits one of the states that
   differ only by such exchanges. This file need not be trusted: the verified check tests all conditions on the exchanges.
   Components are compared by colours (colour refinement): equal parts of the process have equal colours. *)
open Verified

type 'a array = 'a Array.t

let mix = Search.mix

(* Processes with more requirements in all rules are searched without symmetry. *)
let most_requirements = 200_000

(* Components with more transitions are not exchanged. *)
let most_transitions = 50_000

(* The search for exchanges ends when it and the check have examined so many requirements, or so many for exchanges that
   turned out to be wrong. *)
let most_work = 50_000_000
let most_in_vain = 2_000_000

(* Components that are farther from each other than this, in rules, have no influence on each other's colours. *)
let most_rounds = 20

(* A region: its participants and rules, and the components below it. *)
type node = {
  parts : participant array;
  rules : rule array;
  below : int list;
  inner : node option array;  (** by participant *)
}

let rec node_of (Region (parts, rules)) =
  let parts = Array.of_list parts in
  let inner = Array.map (function Slot _ -> None | Inner r -> Some (node_of r)) parts in
  let slots i = function Slot k -> [ k ] | Inner _ -> (Option.get inner.(i)).below in
  let below = List.sort Int.compare (List.concat (Array.to_list (Array.mapi slots parts))) in
  { parts; rules = Array.of_list rules; below; inner }

let rec requirements node =
  let own = Array.fold_left (fun n r -> n + 1 + List.length r.asks) 0 node.rules in
  Array.fold_left (fun n -> function None -> n | Some r -> n + requirements r) own node.inner

let look table ~default key = Option.value ~default (Hashtbl.find_opt table key)
let count_up table key x = Hashtbl.replace table key (x + look table ~default:0 key)
let kind e = if e < 2 then e else 2
let level_of r = match r.level with None -> -1 | Some l -> l

(** Components. *)

(* The states and events of a component in an order that depends only on their colours, and a number that is equal for
   equal components. States that are merged into another state have its number. *)
type shape = { hash : int; state_number : int array; state_at : int array; event_number : (int, int) Hashtbl.t; event_at : int array }

let distinct colours = Hashtbl.length (let t = Hashtbl.create 64 in Array.iter (fun c -> Hashtbl.replace t c ()) colours; t)

(* Refines the colours of states and events until their number does not grow. *)
let rec refine transitions states events =
  let new_states = Array.copy states and new_events = Array.copy events in
  let add colours i x = colours.(i) <- colours.(i) + x in
  List.iter
    (fun (v, e, u) ->
      let colour = mix (mix states.(v) events.(e)) states.(u) in
      add new_states v (mix colour 1);
      add new_states u (mix colour 2);
      add new_events e (mix colour 3))
    transitions;
  let mixed old = Array.mapi (fun i c -> mix old.(i) c) in
  let new_states = mixed states new_states and new_events = mixed events new_events in
  if distinct new_states = distinct states && distinct new_events = distinct events then (states, events)
  else refine transitions new_states new_events

(* Returns the first element that has the same colour as another one, of the least such colour. *)
let tied colours =
  let seen = Hashtbl.create 64 and best = ref None in
  Array.iteri
    (fun i c ->
      match Hashtbl.find_opt seen c with
      | None -> Hashtbl.add seen c i
      | Some first -> ( match !best with Some (d, _) when d <= c -> () | _ -> best := Some (c, first)))
    colours;
  Option.map snd !best

(* Gives each state and each event its own colour: where colours do not distinguish some, their order decides. *)
let rec separate transitions states events =
  let states, events = refine transitions states events in
  let changed colours i = Array.mapi (fun j c -> if i = j then mix c 5 else c) colours in
  match (tied events, tied states) with
  | Some e, _ -> separate transitions states (changed events e)
  | None, Some v -> separate transitions (changed states v) events
  | None, None -> (states, events)

(* Returns the elements in the order of their colours. *)
let in_order colours elements =
  let order = Array.init (Array.length elements) Fun.id in
  Array.stable_sort (fun i j -> Int.compare colours.(i) colours.(j)) order;
  Array.map (fun i -> elements.(i)) order

let shape_of rows start representative roles =
  let kept = Array.of_list (List.filter (fun v -> representative v = v) (List.init (Array.length rows) Fun.id)) in
  let place = Hashtbl.create 64 and event_place = Hashtbl.create 64 in
  Array.iteri (fun i v -> Hashtbl.replace place v i) kept;
  let events = Array.of_list (List.sort Int.compare (Hashtbl.fold (fun e _ l -> e :: l) roles [])) in
  Array.iteri (fun i e -> Hashtbl.replace event_place e i) events;
  let transitions =
    List.concat_map
      (fun v -> List.map (fun (e, u) -> (Hashtbl.find place v, Hashtbl.find event_place e, Hashtbl.find place u)) (List.sort_uniq compare rows.(v)))
      (Array.to_list kept)
  in
  let first_colour v = if v = start then 1 else 0 in
  let states, colours = separate transitions (Array.map first_colour kept) (Array.map (Hashtbl.find roles) events) in
  let state_at = in_order states kept and event_at = in_order colours events in
  let state_number = Array.make (Array.length rows) 0 and event_number = Hashtbl.create 64 in
  Array.iteri (fun n v -> state_number.(v) <- n) state_at;
  Array.iteri (fun v _ -> state_number.(v) <- state_number.(representative v)) rows;
  Array.iteri (fun n e -> Hashtbl.replace event_number e n) event_at;
  let edge_hash (v, e, u) =
    mix (mix state_number.(kept.(v)) (Hashtbl.find event_number events.(e))) state_number.(kept.(u))
  in
  let edges = List.fold_left (fun sum edge -> sum + edge_hash edge) 0 transitions in
  let roles_hash = Array.fold_left (fun h e -> mix h (Hashtbl.find roles e)) 0 event_at in
  let hash = List.fold_left mix edges [ roles_hash; state_number.(start); Array.length state_at; Array.length event_at ] in
  { hash; state_number; state_at; event_number; event_at }

(* The shape of a component that is not exchanged. *)
let unlike k = { hash = mix k 13; state_number = [||]; state_at = [||]; event_number = Hashtbl.create 1; event_at = [||] }

(* By component: its events, each with a number that exchanges keep. It depends on the rules that require the event. *)
let roles_of whole rows =
  let roles = Array.map (fun _ -> Hashtbl.create 16) rows in
  let add k e x = Hashtbl.replace roles.(k) e (x + look roles.(k) ~default:(kind e) e) in
  Array.iteri (fun k -> Array.iter (List.iter (fun (e, _) -> add k e 0))) rows;
  let rec visit node =
    Array.iter
      (fun r ->
        let what = mix (mix (level_of r) (List.length r.asks)) (kind r.does) in
        List.iter (fun (i, e) -> match node.parts.(i) with Slot k -> add k e what | Inner _ -> ()) r.asks)
      node.rules;
    Array.iter (Option.iter visit) node.inner
  in
  visit whole;
  roles

(** The whole process. *)
type t = { whole : node; shapes : shape array; mutable work : int; mutable in_vain : int }

(* The colours of the events and rules of a region, and of its inner regions by participant. *)
type colours = { events : (int, int) Hashtbl.t; of_rules : int array; of_inner : colours option array }

(* Returns a colour for each component, from the colours of the components that it has rules with. *)
let refine_slots t colours =
  let result = Array.copy colours in
  let event_number k e = look t.shapes.(k).event_number ~default:e e in
  let rec upward node =
    let of_inner = Array.map (Option.map upward) node.inner in
    let ask (i, e) =
      t.work <- t.work + 1;
      match (node.parts.(i), of_inner.(i)) with
      | Slot k, _ -> mix colours.(k) (event_number k e)
      | Inner _, Some inner -> look inner.events ~default:0 e
      | Inner _, None -> 0
    in
    let own r =
      mix (mix (kind r.does) (level_of r)) (List.fold_left (fun sum a -> sum + mix 7 (ask a)) 0 r.asks)
    in
    let of_rules = Array.map own node.rules in
    let events = Hashtbl.create 64 in
    Array.iteri (fun n r -> count_up events r.does of_rules.(n)) node.rules;
    { events; of_rules; of_inner }
  in
  (* `outer`: the colours of events by the rules of the region outside that require them. *)
  let rec downward node own outer =
    let below = Array.map (fun _ -> Hashtbl.create 64) node.parts in
    let visit n r =
      let colour = mix own.of_rules.(n) (look outer ~default:0 r.does) in
      let ask (i, e) =
        match node.parts.(i) with
        | Slot k -> result.(k) <- result.(k) + mix colour (event_number k e)
        | Inner _ -> count_up below.(i) e (mix colour 9)
      in
      List.iter ask r.asks
    in
    Array.iteri visit node.rules;
    Array.iteri (fun i -> Option.iter (fun r -> downward r (Option.get own.of_inner.(i)) below.(i))) node.inner
  in
  downward t.whole (upward t.whole) (Hashtbl.create 1);
  Array.mapi (fun k c -> mix colours.(k) c) result

(* Refines colourings by the same number of rounds, until the number of colours of the first one does not grow. *)
let rec refine_all ?(rounds = most_rounds) t colourings =
  let refined = refine_slots t (List.hd colourings) in
  if rounds = 0 || distinct refined = distinct (List.hd colourings) then colourings
  else refine_all ~rounds:(rounds - 1) t (refined :: List.map (refine_slots t) (List.tl colourings))

(* Returns the image of each component if i takes the place of j: the components near i take the places of those near j,
   and components that both colourings treat alike do not move. *)
let exchange t classes i j =
  let marked k = Array.mapi (fun n c -> if n = k then mix c 11 else c) classes in
  let refined = refine_all t [ marked i; marked j ] in
  let colours = List.hd refined and others = List.nth refined 1 in
  let waiting = Hashtbl.create 64 in
  for k = Array.length others - 1 downto 0 do if colours.(k) <> others.(k) then Hashtbl.add waiting others.(k) k done;
  let image k c =
    if others.(k) = c then Some k
    else
      let found = Hashtbl.find_opt waiting c in
      Hashtbl.remove waiting c;
      found
  in
  let images = Array.mapi image colours in
  if Array.exists (fun x -> x = None) images then None else Some (Array.map Option.get images)

exception Not_found_here

let table_of pairs =
  let table = Hashtbl.create 16 in
  List.iter (fun (a, b) -> Hashtbl.replace table a b) pairs;
  fun e -> look table ~default:e e

(* Returns how component `target` gets the state of component `source`. *)
let pull_of t source target =
  let from = t.shapes.(source) and to_ = t.shapes.(target) in
  let states = Array.map (fun n -> to_.state_at.(n)) from.state_number in
  let pairs = Array.to_list (Array.mapi (fun n e -> (e, to_.event_at.(n))) from.event_at) in
  let rename = table_of pairs and restore = table_of (List.map (fun (a, b) -> (b, a)) pairs) in
  { source0 = source; send = (fun v -> if v < Array.length states then states.(v) else v); rename; restore }

let place_of test parts =
  let rec from i = if i = Array.length parts then raise Not_found_here else if test parts.(i) then i else from (i + 1) in
  from 0

(* Returns how a region is mapped to its image. Raises `Not_found_here` if it has none. *)
let rec mapping_of t images pulls node target =
  if Array.length node.parts <> Array.length target.parts || Array.length node.rules <> Array.length target.rules then raise Not_found_here;
  let inner_image i =
    let below = List.sort Int.compare (List.map (fun k -> images.(k)) (Option.get node.inner.(i)).below) in
    let same = function Some r -> r.below = below | None -> false in
    if same target.inner.(i) then i else place_of same target.inner
  in
  let slot_places = Hashtbl.create 64 in
  Array.iteri (fun i -> function Slot k -> Hashtbl.replace slot_places k i | Inner _ -> ()) target.parts;
  let place i = function
    | Slot k -> ( match Hashtbl.find_opt slot_places images.(k) with Some j -> j | None -> raise Not_found_here)
    | Inner _ -> inner_image i
  in
  let places = Array.mapi place node.parts in
  let deeper =
    Array.mapi (fun i -> function
      | None -> None | Some r -> Some (mapping_of t images pulls r (Option.get target.inner.(places.(i))))) node.inner
  in
  let name i e =
    match (node.parts.(i), deeper.(i)) with
    | Slot k, _ -> ( match pulls images.(k) with Some p -> p.rename e | None -> e)
    | Inner _, Some m -> m.new_name e
    | Inner _, None -> e
  in
  let key r asks = (r.level, kind r.does, List.sort compare asks) in
  let bodies = Hashtbl.create 64 in
  let add n r = t.work <- t.work + List.length r.asks; Hashtbl.add bodies (key r r.asks) n in
  for n = Array.length target.rules - 1 downto 0 do add n target.rules.(n) done;
  let to_ = Array.make (Array.length node.rules) (-1) and from = Array.make (Array.length node.rules) (-1) in
  let names = Hashtbl.create 64 and old_names = Hashtbl.create 64 in
  let fits a b =
    match (Hashtbl.find_opt names a, Hashtbl.find_opt old_names b) with
    | None, None -> true
    | Some c, Some d -> b = c && a = d
    | _ -> false
  in
  let join n m =
    let a = node.rules.(n).does and b = target.rules.(m).does in
    if not (fits a b) then raise Not_found_here;
    Hashtbl.replace names a b;
    Hashtbl.replace old_names b a;
    to_.(n) <- m;
    from.(m) <- n
  in
  let candidates n =
    let r = node.rules.(n) in
    List.filter (fun m -> from.(m) < 0) (Hashtbl.find_all bodies (key r (List.map (fun (i, e) -> (places.(i), name i e)) r.asks)))
  in
  let choose ~only_one n =
    match candidates n with
    | [] -> raise Not_found_here
    | [ m ] -> join n m
    | _ when only_one -> ()
    | several -> (
        let a = node.rules.(n).does in
        let fitting = List.filter (fun m -> fits a target.rules.(m).does) several in
        match (List.find_opt (fun m -> target.rules.(m).does = a) fitting, fitting) with
        | Some m, _ | None, m :: _ -> join n m
        | None, [] -> raise Not_found_here)
  in
  for n = 0 to Array.length node.rules - 1 do choose ~only_one:true n done;
  for n = 0 to Array.length node.rules - 1 do if to_.(n) < 0 then choose ~only_one:false n done;
  let named table e = look table ~default:e e in
  { new_place = (fun i -> if i < Array.length places then places.(i) else i); new_name = named names; old_name = named old_names;
    rule_to = Array.get to_; rule_from = Array.get from; deeper = (fun i -> Option.get deeper.(i)) }

(* Returns the automorphism that exchanges components by these images, if there is one. *)
let automorphism_of t instead images =
  let moved = List.filter (fun k -> images.(k) <> k) (List.init (Array.length images) Fun.id) in
  let equal k =
    let a = t.shapes.(k) and b = t.shapes.(images.(k)) in
    a.hash = b.hash && Array.length a.state_at = Array.length b.state_at && Array.length a.event_at = Array.length b.event_at
  in
  if not (List.for_all equal moved) then None
  else
    let pulls = List.map (fun k -> (images.(k), pull_of t k images.(k))) moved in
    match mapping_of t images (fun k -> List.assoc_opt k pulls) t.whole t.whole with
    | tree -> Some { pulls; tree; instead = instead tree.old_name }
    | exception Not_found_here -> None

(* Components that can be exchanged together: replica i and replica i + 1 by the automorphism `first + i`. *)
type replicas = { first : int; members : int array array }

(* Finds sets of replicas. Each component is in at most one set. *)
let find_replicas t instead accepts =
  let count = Array.length t.shapes in
  let classes = List.hd (refine_all t [ Array.map (fun s -> s.hash) t.shapes ]) in
  let taken = Array.make count false and found = ref [] and sets = ref [] in
  let alike k = List.filter (fun j -> classes.(j) = classes.(k) && not taken.(j)) (List.init (count - k) (fun i -> k + i)) in
  let next_to i j =
    if t.work > most_work || t.in_vain > most_in_vain then None
    else
      let before = t.work in
      let with_images images = Option.map (fun g -> (images, g)) (automorphism_of t instead images) in
      match Option.bind (exchange t classes i j) with_images with
      | Some (images, g) when accepts g -> Some (images, g)
      | _ ->
          t.in_vain <- t.in_vain + t.work - before;
          None
  in
  (* Extends a chain of replicas by the components that can take the place of the last one. *)
  let rec chain members generators = function
    | [] -> (List.rev members, List.rev generators)
    | j :: rest -> (
        let last = List.hd members in
        let used k = taken.(k) || List.exists (Array.mem k) members in
        match if used j then None else next_to last.(0) j with
        | Some (images, g) when Array.for_all (fun k -> not (used images.(k))) last ->
            chain (Array.map (fun k -> images.(k)) last :: members) (g :: generators) rest
        | _ -> chain members generators rest)
  in
  let collect k others =
    match List.find_map (fun j -> Option.map (fun (images, g) -> (j, images, g)) (next_to k j)) others with
    | None -> ()
    | Some (j, images, g) ->
        (* Of two components that are exchanged, the first one belongs to this replica. *)
        let own = Array.of_list (k :: List.filter (fun i -> i <> k && i < images.(i)) (List.init count Fun.id)) in
        let members, generators = chain [ Array.map (fun i -> images.(i)) own; own ] [ g ] (List.filter (fun i -> i < j) others) in
        List.iter (Array.iter (fun i -> taken.(i) <- true)) members;
        sets := { first = List.length !found; members = Array.of_list members } :: !sets;
        found := !found @ generators
  in
  (* The last components are tried first: they belong to large replicas. *)
  for k = 0 to count - 1 do
    if (not taken.(k)) && Array.length t.shapes.(k).state_at > 1 then collect k (List.rev (List.tl (alike k)))
  done;
  (!found, List.rev !sets)

(* Returns the exchanges of neighbours that sort the replicas of each set by their states. *)
let turns_of t sets (fields : (int * int * int) array) words =
  let words = Array.of_list words in
  let local k =
    let v = Follow.read words fields.(k) in
    let numbers = t.shapes.(k).state_number in
    if v < Array.length numbers then numbers.(v) else v
  in
  let sort turns set =
    let key members = Array.fold_left (fun key k -> (key * Array.length t.shapes.(k).state_at) + local k) 0 members in
    let keys = Array.map key set.members in
    let turns = ref turns in
    for i = 1 to Array.length keys - 1 do
      let j = ref i in
      while !j > 0 && keys.(!j - 1) > keys.(!j) do
        let key = keys.(!j) in
        keys.(!j) <- keys.(!j - 1);
        keys.(!j - 1) <- key;
        turns := (set.first + !j - 1) :: !turns;
        decr j
      done
    done;
    !turns
  in
  List.rev (List.fold_left sort [] sets)

(* Returns, by node and acceptance, an acceptance that contains only events whose images are in that acceptance. *)
let instead_in (nodes : Search.node array) old_name =
  let known = Hashtbl.create 64 in
  let find n i =
    let events = Array.map old_name nodes.(n).acceptances.(i) in
    let fits a = Array.for_all (fun e -> Array.mem e events) a in
    let rec from j = if j = Array.length nodes.(n).acceptances || fits nodes.(n).acceptances.(j) then j else from (j + 1) in
    if fits nodes.(n).acceptances.(i) then i else from 0
  in
  fun n i ->
    match Hashtbl.find_opt known (n, i) with
    | Some j -> j
    | None ->
        let j = find n i in
        Hashtbl.add known (n, i) j;
        j

(* Returns exchanges of replicas, if there are some. `indifferent` tests the specification, if there is one. *)
let exchanges_of (process : system) sizes merges (layout : layout) nodes indifferent =
  let whole = node_of process.whole in
  if requirements whole > most_requirements then None
  else
    let start = Array.of_list process.start in
    let sizes = Array.of_list sizes in
    let count k = List.fold_left (fun n v -> n + List.length (process.edges k v)) 0 (List.init sizes.(k) Fun.id) in
    let transitions = Array.mapi (fun k _ -> lazy (count k)) sizes in
    let twins k j = j <> k && sizes.(j) = sizes.(k) && Lazy.force transitions.(j) = Lazy.force transitions.(k) in
    let may_be_exchanged k =
      sizes.(k) <= most_transitions && List.exists (twins k) (List.init (Array.length sizes) Fun.id)
      && Lazy.force transitions.(k) <= most_transitions
    in
    let rows = Array.mapi (fun k size -> if may_be_exchanged k then Array.init size (process.edges k) else [||]) sizes in
    let roles = roles_of whole rows in
    let shapes = Array.mapi (fun k rows -> if rows = [||] then unlike k else shape_of rows start.(k) (merge merges k) roles.(k)) rows in
    let t = { whole; shapes; work = 0; in_vain = 0 } in
    let size = size_of layout and arcs = Array.fold_left (fun n node -> n + Array.length node.Search.arcs) 0 nodes in
    let accepts g =
      t.work <- t.work + requirements whole + arcs;
      automorphism_ok process size g && indifferent g
    in
    match find_replicas t (instead_in nodes) accepts with
    | [], _ -> None
    | generators, sets -> Some (generators, turns_of t sets (Follow.fields_of layout))
