(* SPDX-License-Identifier: Apache-2.0 *)
(* Finds what the verified checks need: the normal form of the specification, the pairs and their ranks. This file need
   not be trusted: if its results are wrong, the checks refuse them. *)
open Verified

type 'a array = 'a Array.t

exception Limit of string

(* Raised if there is a violation. The argument describes it. *)
exception Refuted of string

type words = int list

let mix a b =
  let h = (a lxor (b * 0x1E3779B97F4A7C15)) * 0x2545F4914F6CDD1D in
  let h = (h lxor (h lsr 31)) * 0x1B873593CC9E2D51 in
  h lxor (h lsr 29)

let hash_words words node =
  match words with [ w ] -> mix node w land max_int | _ -> List.fold_left mix node words land max_int

(* Large arrays of numbers, which the garbage collector does not scan. *)
type numbers = (int, Bigarray.int_elt, Bigarray.c_layout) Bigarray.Array1.t
type small_numbers = (int32, Bigarray.int32_elt, Bigarray.c_layout) Bigarray.Array1.t

let new_numbers size : numbers = Bigarray.Array1.create Bigarray.int Bigarray.c_layout size
let new_small_numbers size : small_numbers = Bigarray.Array1.create Bigarray.int32 Bigarray.c_layout size

(* Frees large arrays that are no longer used at once. *)
let drop_old bytes = if bytes > 1 lsl 24 then Gc.full_major ()

let longer (old : numbers) used : numbers =
  let result = new_numbers (2 * Bigarray.Array1.dim old) in
  Bigarray.Array1.blit (Bigarray.Array1.sub old 0 used) (Bigarray.Array1.sub result 0 used);
  result

let longer_small (old : small_numbers) used : small_numbers =
  let result = new_small_numbers (2 * Bigarray.Array1.dim old) in
  Bigarray.Array1.blit (Bigarray.Array1.sub old 0 used) (Bigarray.Array1.sub result 0 used);
  result

(* Stores pairs in arrays and finds them by a hash table. A row contains the words of a pair and its node. *)
type store = {
  width : int;
  mutable data : numbers;
  mutable capacity : int;  (** rows *)
  mutable filled : int;
  mutable slots : small_numbers;
  mutable mask : int;
}

let no_pairs size =
  let slots = new_small_numbers size in
  Bigarray.Array1.fill slots (-1l);
  slots

let new_store width =
  { width; data = new_numbers (1024 * (width + 1)); capacity = 1024; filled = 0; slots = no_pairs 4096; mask = 4095 }

let[@inline] row store j = j * (store.width + 1)
let node_at store j = store.data.{row store j + store.width}

let words_at store j =
  if store.width = 1 then [ store.data.{row store j} ]
  else
    let first = row store j in
    let rec from i rest = if i < first then rest else from (i - 1) (store.data.{i} :: rest) in
    from (first + store.width - 1) []

let rec same_words (data : numbers) i = function [] -> true | w :: rest -> data.{i} = w && same_words data (i + 1) rest

let rec probe store words node i =
  let j = Int32.to_int store.slots.{i} in
  if j < 0 then i
  else
    let first = row store j in
    if store.data.{first + store.width} = node && same_words store.data first words then i
    else probe store words node ((i + 1) land store.mask)

let slot_of store words node = probe store words node (hash_words words node land store.mask)

let grow_slots store =
  store.mask <- (2 * store.mask) + 1;
  store.slots <- no_pairs (store.mask + 1);
  drop_old (2 * store.mask);
  let rec empty i = if store.slots.{i} < 0l then i else empty ((i + 1) land store.mask) in
  for j = 0 to store.filled - 1 do
    store.slots.{empty (hash_words (words_at store j) (node_at store j) land store.mask)} <- Int32.of_int j
  done

let add_at store slot words node =
  let j = store.filled in
  if j = store.capacity then begin
    store.data <- longer store.data (row store j);
    store.capacity <- 2 * j;
    drop_old (8 * row store j)
  end;
  let first = row store j in
  List.iteri (fun i w -> store.data.{first + i} <- w) words;
  store.data.{first + store.width} <- node;
  store.filled <- j + 1;
  store.slots.{slot} <- Int32.of_int j;
  if 2 * store.filled > store.mask then grow_slots store;
  j

(* Returns the number of the pair, and adds the pair if it is new. A new pair gets the number of pairs before the
   call. *)
let insert store words node =
  let slot = slot_of store words node in
  let j = Int32.to_int store.slots.{slot} in
  if j >= 0 then j else add_at store slot words node

let find store words node =
  let j = Int32.to_int store.slots.{slot_of store words node} in
  if j < 0 then store.filled else j

module Signatures = Hashtbl.Make (struct
  type t = int list

  let rec equal (a : t) (b : t) =
    match (a, b) with x :: a, y :: b -> x = y && equal a b | [], [] -> true | _ -> false

  let hash numbers = List.fold_left mix 0 numbers land max_int
end)

(* Returns, by state of a component, the first state that no transition distinguishes from it. Classes are refined until
   their states have the same transitions to classes. If that takes too long, every state has its own class. *)
let equal_states (edges : (int * int) list array) =
  let count = Array.length edges in
  let transitions = Array.fold_left (fun sum row -> sum + 1 + List.length row) 0 edges in
  let rec refine classes number rounds =
    let signatures = Signatures.create (2 * count) in
    let class_of key =
      match Signatures.find_opt signatures key with
      | Some c -> c
      | None ->
          let c = Signatures.length signatures in
          Signatures.add signatures key c;
          c
    in
    let signature v = classes.(v) :: List.sort_uniq Int.compare (List.map (fun (e, u) -> (e * count) + classes.(u)) edges.(v)) in
    let refined = Array.init count (fun v -> class_of (signature v)) in
    let refined_number = Signatures.length signatures in
    if refined_number = number then refined
    else if rounds * transitions > 20_000_000 then Array.init count Fun.id
    else refine refined refined_number (rounds + 1)
  in
  let classes = refine (Array.make count 0) (min count 1) 1 in
  let first = Array.make count (-1) in
  Array.iteri (fun v c -> if first.(c) < 0 then first.(c) <- v) classes;
  Array.map (fun c -> first.(c)) classes

(* A growing array of numbers. *)
type row = { mutable values : numbers; mutable used : int }

let new_row () = { values = new_numbers 1024; used = 0 }

let push row x =
  if row.used = Bigarray.Array1.dim row.values then row.values <- longer row.values row.used;
  row.values.{row.used} <- x;
  row.used <- row.used + 1

(* The specification as an explicit graph, explored on demand. *)
type graph = {
  succ : words -> (int * words) list;
  ids : (words, int) Hashtbl.t;
  mutable states : words array;
  mutable edges : (int * int) list option array;
  mutable colour : Bytes.t;  (** divergence: '0' unknown, '1' on the stack, 'n' no, 'y' yes *)
  mutable marks : int array;
  mutable mark : int;
}

let id_of graph words =
  match Hashtbl.find_opt graph.ids words with
  | Some id -> id
  | None ->
      let id = Hashtbl.length graph.ids in
      Hashtbl.add graph.ids words id;
      let size = Array.length graph.states in
      if id = size then begin
        let larger a filler = Array.append a (Array.make size filler) in
        graph.states <- larger graph.states [];
        graph.edges <- larger graph.edges None;
        graph.marks <- larger graph.marks 0;
        graph.colour <- Bytes.cat graph.colour (Bytes.make size '0')
      end;
      graph.states.(id) <- words;
      id

let new_graph succ =
  { succ; ids = Hashtbl.create 1000; states = Array.make 64 []; edges = Array.make 64 None; colour = Bytes.make 64 '0';
    marks = Array.make 64 0; mark = 0 }

let edges_of graph id =
  match graph.edges.(id) with
  | Some edges -> edges
  | None ->
      let edges = List.map (fun (a, u) -> (a, id_of graph u)) (graph.succ graph.states.(id)) in
      let edges = List.sort_uniq compare edges in
      graph.edges.(id) <- Some edges;
      edges

let taus_of graph id = List.filter_map (fun (a, u) -> if a = 0 then Some u else None) (edges_of graph id)

(* Decides whether the state can perform taus forever. All states on the stack of the depth-first search reach the top
   of the stack. *)
let diverges graph id =
  let stack = ref [ (id, ref (taus_of graph id)) ] in
  let colour s = Bytes.get graph.colour s in
  let all_diverge () =
    List.iter (fun (s, _) -> Bytes.set graph.colour s 'y') !stack;
    stack := []
  in
  if colour id = '0' then begin
    Bytes.set graph.colour id '1';
    while !stack <> [] do
      let s, rest = List.hd !stack in
      match !rest with
      | [] ->
          Bytes.set graph.colour s 'n';
          stack := List.tl !stack
      | u :: later -> (
          rest := later;
          match colour u with
          | 'n' -> ()
          | '0' ->
              Bytes.set graph.colour u '1';
              stack := (u, ref (taus_of graph u)) :: !stack
          | _ -> all_diverge ())
    done
  end;
  colour id = 'y'

(* Returns the seeds and the states that taus reach from them, sorted. *)
let close graph seeds =
  graph.mark <- graph.mark + 1;
  let found = ref [] in
  let rec add = function
    | [] -> ()
    | s :: rest ->
        if graph.marks.(s) = graph.mark then add rest
        else begin
          let taus = taus_of graph s in
          graph.marks.(s) <- graph.mark;
          found := s :: !found;
          add (List.rev_append taus rest)
        end
  in
  add seeds;
  let members = Array.of_list !found in
  Array.sort compare members;
  members

type node = {
  members : int array;
  arcs : (int * int) array;
  acceptances : int array array;
  witnesses : int array;  (** by acceptance: the place of a member *)
  node_diverges : bool;
}

module Sets = Hashtbl.Make (struct
  type t = int array

  let equal (a : t) b = a = b
  let hash a = Array.fold_left mix 0 a land max_int
end)

let includes large small = Array.for_all (fun x -> Array.exists (fun y -> y = x) large) small

(* Returns the minimal acceptances of the members, each with a witness. *)
let acceptances_of graph members =
  let distinct = Hashtbl.create 16 in
  Array.iteri
    (fun place s ->
      let events = List.sort_uniq compare (List.map fst (edges_of graph s)) in
      let add set = if not (Hashtbl.mem distinct set) then Hashtbl.add distinct set place in
      if List.mem 1 events then add [| 1 |] else if not (List.mem 0 events) then add (Array.of_list events))
    members;
  let all = Hashtbl.fold (fun set place l -> (set, place) :: l) distinct [] in
  let all = List.sort (fun (a, _) (b, _) -> compare (Array.length a, a) (Array.length b, b)) all in
  let minimal =
    List.fold_left (fun kept (set, place) -> if List.exists (fun (k, _) -> includes set k) kept then kept else (set, place) :: kept) [] all
  in
  let minimal = List.rev minimal in
  (Array.of_list (List.map fst minimal), Array.of_list (List.map snd minimal))

let normalise graph start model ~most =
  let ids = Sets.create 1000 and waiting = Queue.create () and nodes = ref [] in
  let node_of members =
    match Sets.find_opt ids members with
    | Some n -> n
    | None ->
        let n = Sets.length ids in
        if n >= most then raise (Limit "the normal form of the specification has too many nodes");
        Sets.add ids members n;
        Queue.add members waiting;
        n
  in
  ignore (node_of (close graph [ id_of graph start ]));
  while not (Queue.is_empty waiting) do
    let members = Queue.pop waiting in
    let node_diverges = model = FD && Array.exists (diverges graph) members in
    if node_diverges then nodes := { members; arcs = [||]; acceptances = [||]; witnesses = [||]; node_diverges } :: !nodes
    else begin
      let after = Hashtbl.create 16 in
      Array.iter
        (fun s ->
          List.iter
            (fun (a, u) -> if a <> 0 then Hashtbl.replace after a (u :: Option.value ~default:[] (Hashtbl.find_opt after a)))
            (edges_of graph s))
        members;
      let events = List.sort compare (Hashtbl.fold (fun a _ l -> a :: l) after []) in
      let arcs = Array.of_list (List.map (fun a -> (a, node_of (close graph (Hashtbl.find after a)))) events) in
      let acceptances, witnesses = if model = T then ([||], [||]) else acceptances_of graph members in
      nodes := { members; arcs; acceptances; witnesses; node_diverges } :: !nodes
    end
  done;
  Array.of_list (List.rev !nodes)

exception Unresolved

(* Resolves the choices of a process (Lazic; UCS 10.5): each state leads on by its first tau while it has one and cannot
   terminate, and each event leads to its first target. Returns the arcs by node. A loop of taus cannot be resolved. *)
let resolve graph start ~most =
  let settled = Hashtbl.create 1000 in
  let rec settle on_the_way id =
    let edges = edges_of graph id in
    let tau = List.assoc_opt 0 edges in
    let ends =
      match Hashtbl.find_opt settled id with
      | Some known -> known
      | None -> (
          match tau with
          | Some next when not (List.mem_assoc 1 edges) ->
              Hashtbl.add settled id (-1);
              settle (id :: on_the_way) next
          | _ -> id)
    in
    if ends < 0 then raise Unresolved;
    List.iter (fun s -> Hashtbl.replace settled s ends) on_the_way;
    ends
  in
  let ids = Hashtbl.create 1000 and waiting = Queue.create () and rows = ref [] in
  let node_of state =
    let state = settle [] state in
    match Hashtbl.find_opt ids state with
    | Some n -> n
    | None ->
        let n = Hashtbl.length ids in
        if n >= most then raise (Limit "the process has too many states without taus");
        Hashtbl.add ids state n;
        Queue.add state waiting;
        n
  in
  ignore (node_of (id_of graph start));
  while not (Queue.is_empty waiting) do
    let edges = edges_of graph (Queue.pop waiting) in
    let edges = if List.mem_assoc 1 edges then List.filter (fun (a, _) -> a = 1) edges else edges in
    let rec first_targets = function
      | (a, u) :: ((b, _) :: _ as rest) when a = b -> first_targets ((a, u) :: List.tl rest)
      | (a, u) :: rest ->
          let n = node_of u in
          (a, n) :: first_targets rest
      | [] -> []
    in
    rows := first_targets edges :: !rows
  done;
  Array.of_list (List.rev !rows)

(* Returns the arcs of a graph that the process refines if it is deterministic. *)
let without_choices graph start ~most =
  try resolve graph start ~most
  with Unresolved ->
    let nodes = normalise graph start F ~most in
    let arcs node =
      let arcs = Array.to_list node.arcs in
      if List.mem_assoc 1 arcs then List.filter (fun (a, _) -> a = 1) arcs else arcs
    in
    Array.map arcs nodes

(* Returns the index of a number in a sorted array, or the length of the array if it does not contain the number. *)
let place_of key_of (sorted : 'a array) (key : int) =
  let rec between low high =
    if low >= high then Array.length sorted
    else
      let middle = (low + high) / 2 in
      let found = key_of sorted.(middle) in
      if found = key then middle else if found < key then between (middle + 1) high else between low middle
  in
  between 0 (Array.length sorted)

let normal_form_of nodes =
  let at n = nodes.(n) in
  { nodes = Array.length nodes;
    root = 0;
    arc_count = (fun n -> Array.length (at n).arcs);
    arc = (fun n i -> (at n).arcs.(i));
    where_is = (fun n a -> place_of fst (at n).arcs a);
    acceptance_count = (fun n -> Array.length (at n).acceptances);
    acceptance = (fun n i -> Array.to_list (at n).acceptances.(i));
    divergent = (fun n -> (at n).node_diverges) }

(* Returns why the members of a node are reached. Each seed comes with a place from which an event has led to it. *)
let origins graph seeds members =
  let found = Array.make (Array.length members) { by_event = true; from = 0; depth = 0 } in
  let known = Array.make (Array.length members) false in
  let waiting = Queue.create () in
  let add origin s =
    let place = place_of Fun.id members s in
    if place < Array.length members && not known.(place) then begin
      known.(place) <- true;
      found.(place) <- origin;
      Queue.add place waiting
    end
  in
  List.iter (fun (from, s) -> add { by_event = true; from; depth = 0 } s) seeds;
  while not (Queue.is_empty waiting) do
    let place = Queue.pop waiting in
    let depth = found.(place).depth + 1 in
    List.iter (add { by_event = false; from = place; depth }) (taus_of graph members.(place))
  done;
  found

let evidence_of graph start nodes =
  let members n = nodes.(n).members in
  let in_root = lazy (origins graph [ (0, id_of graph start) ] (members 0)) in
  let last = ref (-1, -1, [||]) in
  let after n i =
    let n', i', known = !last in
    if n = n' && i = i' then known
    else begin
      let a, k = nodes.(n).arcs.(i) in
      let seeds = ref [] in
      Array.iteri (fun f s -> List.iter (fun (b, u) -> if b = a then seeds := (f, u) :: !seeds) (edges_of graph s)) (members n);
      let known = origins graph !seeds (members k) in
      last := (n, i, known);
      known
    end
  in
  let loop = ref [] in
  Hashtbl.iter (fun _ id -> if Bytes.get graph.colour id = 'y' then loop := id :: !loop) graph.ids;
  let loop = Array.of_list (List.sort compare !loop) in
  let in_loop id = place_of Fun.id loop id in
  let first_diverging n =
    let rec from i = if i >= Array.length (members n) || in_loop (members n).(i) < Array.length loop then i else from (i + 1) in
    from 0
  in
  { size0 = (fun n -> Array.length (members n));
    member = (fun n j -> graph.states.((members n).(j)));
    origin_in_root = (fun j -> (Lazy.force in_root).(j));
    origin_after = (fun n i j -> (after n i).(j));
    witness = (fun n i -> nodes.(n).witnesses.(i));
    loop_size = Array.length loop;
    loop = (fun j -> graph.states.(loop.(j)));
    loop_next =
      (fun j ->
        match List.find_opt (fun u -> in_loop u < Array.length loop) (taus_of graph loop.(j)) with
        | Some u -> in_loop u
        | None -> Array.length loop);
    diverging_member = first_diverging;
    loop_entry = (fun n -> in_loop (members n).(first_diverging n)) }

(* Returns a function that finds the first acceptance of a node that the moves offer. *)
let chooser nodes event_count =
  let stamps = Array.make (event_count + 2) 0 and stamp = ref 0 in
  fun n moves ->
    incr stamp;
    List.iter (fun (a, _) -> stamps.(a) <- !stamp) moves;
    let tick = stamps.(1) = !stamp in
    let offered a = if tick then a = 1 else stamps.(a) = !stamp in
    let acceptances = nodes.(n).acceptances in
    let rec first i = if i >= Array.length acceptances || Array.for_all offered acceptances.(i) then i else first (i + 1) in
    first 0

(* What the search checks in each pair, and how it describes violations. *)
type task = {
  next : int -> int -> int option;  (** node, event: the node after it *)
  stopped : int -> bool;  (** after the specification diverges, anything is allowed *)
  state_fault : int -> (int * words) list -> string option;
  forbid_cycles : bool;
  event_fault : int -> int -> string;
}

type found = {
  store : store;
  tau_first : row;  (** by pair: its first tau in `tau_targets` *)
  tau_targets : row;
  mutable ranks : int array;  (** by pair, if cycles of taus are forbidden *)
  parents : row option;  (** by pair: the pair before it, and the event *)
  mutable transitions : int;
}

let run_to name found j =
  match found.parents with
  | None -> ""
  | Some parents ->
      let rec back j events =
        if j = 0 then events
        else
          let event = parents.values.{(2 * j) + 1} in
          back parents.values.{2 * j} (if event = 0 then events else name event :: events)
      in
      Printf.sprintf "after <%s>" (String.concat ", " (back j []))

exception Violation_at of int * string

let new_found width with_parents =
  { store = new_store width; tau_first = new_row (); tau_targets = new_row (); ranks = [||];
    parents = (if with_parents then Some (new_row ()) else None); transitions = 0 }

let explore (impl : words lts) task found ~most ~lenient =
  let store = found.store in
  let note_parent j a = Option.iter (fun parents -> push parents j; push parents a) found.parents in
  ignore (insert store impl.init 0);
  note_parent 0 0;
  let add i a words node =
    let before = store.filled in
    let j = insert store words node in
    if j = before then begin
      note_parent i a;
      if store.filled > most then raise (Limit (Printf.sprintf "there are more than %d pairs" most))
    end;
    j
  in
  let i = ref 0 in
  while !i < store.filled do
    let node = node_at store !i in
    push found.tau_first found.tau_targets.used;
    if not (task.stopped node) then begin
      let moves = impl.succ0 (words_at store !i) in
      let report fault = if not lenient then raise (Violation_at (!i, fault)) in
      Option.iter report (task.state_fault node moves);
      List.iter
        (fun (a, u) ->
          found.transitions <- found.transitions + 1;
          if a = 0 then push found.tau_targets (add !i a u node)
          else
            match task.next node a with
            | None -> report (task.event_fault node a)
            | Some k -> if not (task.stopped k) then ignore (add !i a u k))
        moves
    end;
    incr i
  done;
  push found.tau_first found.tau_targets.used

(* Computes the rank of each pair, which is the length of the longest sequence of taus from it. *)
let set_ranks found ~lenient =
  let store = found.store in
  let colour = Bytes.make store.filled '0' in
  let ranks = Array.make store.filled 0 in
  found.ranks <- ranks;
  let first = found.tau_first.values and targets = found.tau_targets.values in
  let finish j =
    let rank = ref 0 in
    for t = first.{j} to first.{j + 1} - 1 do
      rank := max !rank (ranks.(targets.{t}) + 1)
    done;
    ranks.(j) <- !rank;
    Bytes.set colour j 'n'
  in
  for start = 0 to store.filled - 1 do
    let stack = ref (if Bytes.get colour start = '0' then [ start ] else []) in
    while !stack <> [] do
      let j = List.hd !stack in
      if Bytes.get colour j <> '0' then begin
        stack := List.tl !stack;
        if Bytes.get colour j = '1' then finish j
      end
      else begin
        Bytes.set colour j '1';
        for t = first.{j} to first.{j + 1} - 1 do
          let u = targets.{t} in
          match Bytes.get colour u with
          | '0' -> stack := u :: !stack
          | '1' -> if not lenient then raise (Violation_at (u, "it can perform taus for ever"))
          | _ -> ()
        done
      end
    done
  done

(* Finds the pairs. If there is a violation, searches again to find the run to it. *)
let pairs_for ?(lenient = false) impl width task ~most ~name ~state_name =
  let attempt with_parents =
    let found = new_found width with_parents in
    try
      explore impl task found ~most ~lenient;
      if task.forbid_cycles then set_ranks found ~lenient;
      Ok found
    with Violation_at (j, fault) -> Error (found, j, fault)
  in
  match attempt false with
  | Ok found -> found
  | Error _ -> (
      match attempt true with
      | Ok found -> found
      | Error (found, j, fault) ->
          let state = state_name (words_at found.store j) in
          raise (Refuted (Printf.sprintf "%s, in the state %s, %s" (run_to name found j) state fault)))

let rank_of found j = if j < Array.length found.ranks then found.ranks.(j) else 0

(* Returns the run to a pair: its events and states. *)
let moves_to found j =
  let parents = (Option.get found.parents).values in
  let rec back j run = if j = 0 then run else back parents.{2 * j} ((parents.{(2 * j) + 1}, words_at found.store j) :: run) in
  back j []

let visible run = List.filter_map (fun (a, _) -> if a = 0 then None else Some a) run

(* A run from the initial state to a state. The nodes are numbers of events, so one search serves all prefixes. *)
let run_with (lts : words lts) width events ~most =
  let events = Array.of_list events in
  let found = new_found width true in
  let next n a = if n < Array.length events && events.(n) = a then Some (n + 1) else Some (-1) in
  let task =
    { next; stopped = (fun n -> n < 0); forbid_cycles = false; event_fault = (fun _ _ -> "");
      state_fault = (fun n _ -> if n = Array.length events then Some "" else None) }
  in
  match explore lts task found ~most ~lenient:false with
  | () -> None
  | exception Violation_at (j, _) -> Some (moves_to found j)

(* Returns a run of taus from a state back to itself, or nothing if there is none. *)
let tau_loop (lts : words lts) width state ~most =
  let found = new_found width true in
  let taus s = List.filter (fun (a, _) -> a = 0) (lts.succ0 s) in
  let task =
    { next = (fun _ _ -> None); stopped = (fun _ -> false); forbid_cycles = false; event_fault = (fun _ _ -> "");
      state_fault = (fun _ moves -> if List.exists (fun (_, u) -> u = state) moves then Some "" else None) }
  in
  match explore { init = state; succ0 = taus } task found ~most ~lenient:false with
  | () -> []
  | exception Violation_at (j, _) -> moves_to found j @ [ (0, state) ]

(* Finds all states, and for each its distance to an event of the goal. *)
let distances (lts : words lts) width goal ~most ~name ~state_name =
  let found = new_found width true in
  let before = ref [] and near = ref [] in
  let seen = ref (-1) in
  let task =
    { next = (fun _ _ -> Some 0); stopped = (fun _ -> false); forbid_cycles = false; event_fault = (fun _ _ -> "");
      state_fault =
        (fun _ moves ->
          incr seen;
          if List.exists (fun (a, _) -> List.mem a goal) moves then near := !seen :: !near;
          before := (!seen, moves) :: !before;
          None) }
  in
  explore lts task found ~most ~lenient:false;
  let count = found.store.filled in
  let sources = Array.make count [] in
  List.iter (fun (j, moves) -> List.iter (fun (_, u) -> let k = find found.store u 0 in sources.(k) <- j :: sources.(k)) moves) !before;
  let distance = Array.make count (-1) in
  let waiting = Queue.create () in
  let reach d j = if distance.(j) < 0 then (distance.(j) <- d; Queue.add j waiting) in
  List.iter (reach 0) !near;
  while not (Queue.is_empty waiting) do
    let j = Queue.pop waiting in
    List.iter (reach (distance.(j) + 1)) sources.(j)
  done;
  let far = ref 0 in
  while !far < count && distance.(!far) >= 0 do incr far done;
  (found, Array.map (fun d -> if d < 0 then count else d) distance,
   if !far = count then None
   else
     Some
       (Printf.sprintf "%s, in the state %s, none of the events is possible any more" (run_to name found !far)
          (state_name (words_at found.store !far))))

let numbering_of found distance =
  { state_count = found.store.filled;
    state_number = (fun u -> find found.store u 0);
    numbered_state = words_at found.store;
    distance = (fun j -> distance.(j)) }

(* Returns the pairs that were found, in the order of their ranks. *)
let pairs_record found choose =
  let store = found.store in
  let count = store.filled in
  let order = Array.init count Fun.id in
  Array.stable_sort (fun i j -> compare (rank_of found i) (rank_of found j)) order;
  let places = Array.make count 0 in
  Array.iteri (fun place j -> places.(j) <- place) order;
  { state_of = words_at store;
    node_of = node_at store;
    place_of = (fun j -> places.(j));
    pair_at = (fun place -> order.(place));
    locate = find store;
    choose;
    deed = (fun time _ -> if time >= 2 * count then Stop else if time land 1 = 0 then Open order.(time / 2) else Visit) }

(* Finds pairs while the verified check visits them. If taus must end, a pair is visited after all pairs to which its
   taus lead. *)
type walk = {
  pairs : store;
  mutable places : small_numbers;  (** by pair: -1 before it is opened, -2 while it is open *)
  mutable order : small_numbers;
  mutable visits : int;
  mutable cursor : int;  (** the pairs before it are open or visited *)
  mutable frames : frame list;  (** the open pairs *)
  mutable located : (words * int) list;  (** where the taus of the pair that is visited lead *)
  mutable moves_seen : int;
}

and frame = { pair : int; mutable pending : (int * words) list; mutable reached : (words * int) list }

exception Loop_of_taus

let new_walk width =
  { pairs = new_store width; places = new_small_numbers 0; order = new_small_numbers 0; visits = 0; cursor = 0;
    frames = []; located = []; moves_seen = 0 }

let prepare_places walk =
  let used = Bigarray.Array1.dim walk.places and size = walk.pairs.capacity in
  if used < size then begin
    let larger old =
      let result = new_small_numbers size in
      Bigarray.Array1.fill result (-1l);
      Bigarray.Array1.blit old (Bigarray.Array1.sub result 0 used);
      result
    in
    walk.places <- larger walk.places;
    walk.order <- larger walk.order;
    drop_old (4 * used)
  end

let open_pair walk j =
  prepare_places walk;
  walk.places.{j} <- -2l;
  walk.frames <- { pair = j; pending = []; reached = [] } :: walk.frames;
  Open j

(* Opens the next new pair to which a tau leads. If there is none, the pair of the frame is visited. *)
let rec follow_taus walk frame = function
  | [] -> (
      walk.places.{frame.pair} <- Int32.of_int walk.visits;
      walk.order.{walk.visits} <- Int32.of_int frame.pair;
      walk.visits <- walk.visits + 1;
      walk.frames <- List.tl walk.frames;
      walk.located <- List.rev frame.reached;
      Visit)
  | (a, u) :: rest when a = 0 ->
      let j = insert walk.pairs u (node_at walk.pairs frame.pair) in
      prepare_places walk;
      frame.reached <- (u, j) :: frame.reached;
      let place = walk.places.{j} in
      if place >= 0l then follow_taus walk frame rest
      else if place = -2l then raise Loop_of_taus
      else begin
        frame.pending <- rest;
        open_pair walk j
      end
  | _ :: rest -> follow_taus walk frame rest

let rec next_unopened walk =
  if walk.cursor = walk.pairs.filled then None
  else if walk.cursor < Bigarray.Array1.dim walk.places && walk.places.{walk.cursor} <> -1l then begin
    walk.cursor <- walk.cursor + 1;
    next_unopened walk
  end
  else Some walk.cursor

let pairs_on_the_way walk choose ~ordered ~most =
  let store = walk.pairs in
  let note_moves moves = walk.moves_seen <- walk.moves_seen + List.length moves in
  let ordered_deed _ opened =
    match (opened, walk.frames) with
    | (_, moves) :: _, frame :: _ ->
        let fresh = frame.pending = [] && frame.reached = [] in
        if fresh then note_moves moves;
        follow_taus walk frame (if fresh then moves else frame.pending)
    | _ -> ( match next_unopened walk with Some j -> open_pair walk j | None -> Stop)
  in
  let plain_deed _ = function
    | (_, moves) :: _ ->
        note_moves moves;
        Visit
    | [] ->
        let j = walk.cursor in
        walk.cursor <- j + 1;
        if j < store.filled then Open j else Stop
  in
  let locate words node =
    match walk.located with
    | (known, j) :: rest when known == words ->
        walk.located <- rest;
        j
    | _ ->
        let j = insert store words node in
        if j >= most then raise (Limit (Printf.sprintf "there are more than %d pairs" most));
        j
  in
  { state_of = words_at store;
    node_of = node_at store;
    place_of = (if ordered then fun j -> Int32.to_int walk.places.{j} else Fun.id);
    pair_at = (if ordered then fun place -> Int32.to_int walk.order.{place} else Fun.id);
    locate;
    choose;
    deed = (if ordered then ordered_deed else plain_deed) }
