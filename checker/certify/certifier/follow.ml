(* SPDX-License-Identifier: Apache-2.0 *)
(* Finds steps that are strongly confluent, so that the search may follow them (docs/search.md, "Confluent taus"). This
   file need not be trusted: the verified check tests all conditions on these steps again. *)
open Verified

type 'a array = 'a Array.t

(* Larger processes are not reduced. *)
let most_rules = 100_000

(* A process with more states of components, times its events, is not reduced. *)
let most_able = 100_000_000

(* Learning ends when proofs have examined so many rules, or when the check would have to examine so many. *)
let most_work = 40_000_000

(* A proof tracks at most this many components in addition to the components of its rule. *)
let most_beside = 4

(* A proof that needs more joint states fails. *)
let most_together = 500

(* After so many joint states without a proof, no further proof with these rule and components is tried. *)
let most_in_vain = 3_000

module Keys = Hashtbl.Make (struct
  type t = int list

  let rec equal (a : t) (b : t) = match (a, b) with x :: a, y :: b -> x = y && equal a b | [], [] -> true | _ -> false
  let hash key = List.fold_left Search.mix 0 key land max_int
end)

type answer = No | Entry of int | Larger of int

module Numbers = Hashtbl.Make (struct
  type t = int

  let equal (a : t) b = a = b
  let hash key = Search.mix 0 key land max_int
end)

(* Proofs for one rule that track the same components, and their answers by the states of these components. *)
type query = {
  rule : int;
  slots : int array;
  weights : int array;
  answers : answer Numbers.t;
  mutable looked : int;
  mutable proved : int;
}

(* The joint states of tracked components are numbered up to this number. *)
let most_joint = 1 lsl 60

type t = {
  process : system;
  row : int -> int -> int -> (int * int) list;  (** by component, event and state: the transitions *)
  edges : (int * int) list array array;  (** by component and state *)
  events : int list array array;  (** by component and state: the events that it can perform, ascending *)
  alphabets : int array array;  (** by component and event: the number of the event in this component, or -1 *)
  able : Bytes.t array array;  (** by component, state and number of the event: 'y' if the event is possible *)
  overruled : Bytes.t array;  (** by followed rule, by rule: '?' not known, 'y' prevented by the followed rule, 'n' not *)
  rules : whole_rule array;
  parts : int list array;  (** by rule: its components, ascending *)
  asking : int list array array;  (** by component, by event: the rules that require the event *)
  setting : int list array;  (** by component: the rules that assign its state *)
  guarding : int list array;  (** by component: the rules that may be prevented in a region around it *)
  leading : int list array array;  (** by component, by event: the rules whose steps may be followed *)
  leaders : int list option array array;  (** by component, by state: the rules of all its events *)
  first : int array;  (** by rule: its first query, or -1 *)
  mutable queries : query array;
  mutable query_count : int;
  query_numbers : int Keys.t;
  entry_numbers : int Keys.t;  (** by rule, and components with their states *)
  mutable entries : (int * cube) array;
  mutable entry_count : int;
  mutable learning : bool;
  mutable work : int;  (** how many rules the proofs have examined *)
  mutable check_work : int;  (** how many rules the check must examine for the entries *)
  touching : int array;  (** by component: the number of rules that require an event or assign a state *)
  stamps : int array;  (** by rule: the last joint state in which it was examined *)
  mutable stamp : int;
  performs : (int * int) list array;  (** by rule: the components and events that it requires *)
  known : int list Keys.t;  (** by packed state: the entries to its representative *)
  words : int;  (** of a packed state *)
  fields : (int * int * int) array;  (** by component: word, shift, bits *)
  mutable led : int;  (** how many states were led to another state *)
}

(* Returns the number of rules of the whole process, or a larger number than `most_rules`. *)
let count_rules (process : system) =
  let rec count (Region (inside, rules)) =
    let counts = List.map (function Slot _ -> None | Inner r -> Some (count r)) inside in
    let result = Hashtbl.create 16 in
    List.iter
      (fun r ->
        let ways (i, e) =
          match List.nth_opt counts i with
          | None -> 0
          | Some None -> 1
          | Some (Some t) -> Option.value ~default:0 (Hashtbl.find_opt t e)
        in
        let product = List.fold_left (fun n ask -> min (most_rules + 1) (n * ways ask)) 1 r.asks in
        let before = Option.value ~default:0 (Hashtbl.find_opt result r.does) in
        Hashtbl.replace result r.does (min (most_rules + 1) (before + product)))
      rules;
    result
  in
  Hashtbl.fold (fun _ n sum -> n + sum) (count process.whole) 0

(* Returns the number of the query, or -1 if its components have too many joint states. *)
let query_of t rule slots =
  let key = rule :: slots in
  match Keys.find_opt t.query_numbers key with
  | Some q -> q
  | None ->
      let slots = Array.of_list slots in
      let size = ref 1 in
      let weight k =
        let weight = !size and states = max 1 (Array.length t.edges.(k)) in
        size := if weight > most_joint / states then most_joint else weight * states;
        weight
      in
      let weights = Array.map weight slots in
      let q = if !size >= most_joint then -1 else t.query_count in
      if q >= 0 then begin
        let query = { rule; slots; weights; answers = Numbers.create 16; looked = 0; proved = 0 } in
        if q = Array.length t.queries then t.queries <- Array.append t.queries (Array.make (q + 16) query);
        t.queries.(q) <- query;
        t.query_count <- q + 1
      end;
      Keys.add t.query_numbers key q;
      q

(* By component: the word that contains its state, and the bits in this word. *)
let fields_of (layout : layout) =
  let field word (shift, found) bits = (shift + bits, (word, shift, bits) :: found) in
  Array.of_list
    (List.concat (List.mapi (fun word group -> List.rev (snd (List.fold_left (field word) (0, []) group))) layout.groups))

(* `any`: steps with any event may be followed. *)
let prepare (process : system) sizes (layout : layout) event_count ~any =
  let edges = Array.of_list (List.mapi (fun k size -> Array.init size (process.edges k)) sizes) in
  let count = Array.length edges in
  let process = { process with edges = (fun k v -> if k < count && v < Array.length edges.(k) then edges.(k).(v) else []) } in
  let rules = Array.of_list (rules_of_whole process) in
  let events_of row = List.sort_uniq Int.compare (List.map fst row) in
  let alphabet rows =
    let numbers = Array.make event_count (-1) in
    let next = ref 0 in
    let add (e, _) = if numbers.(e) < 0 then begin numbers.(e) <- !next; incr next end in
    Array.iter (List.iter add) rows;
    (numbers, !next)
  in
  let able rows =
    let numbers, width = alphabet rows in
    let possible row = let b = Bytes.make width 'n' in List.iter (fun (e, _) -> Bytes.set b numbers.(e) 'y') row; b in
    Array.map possible rows
  in
  let performs w = List.filter_map (function Performs (k, e) -> Some (k, e) | Sets _ -> None) w.items in
  let slots_of_rule w = List.sort_uniq Int.compare (List.map item_slot w.items) in
  let new_tables () = Array.init count (fun _ -> Array.make event_count []) in
  let asking = new_tables () and leading = new_tables () in
  let setting = Array.make count [] and guarding = Array.make count [] in
  let share = Array.map (fun rows ->
      let counts = Hashtbl.create 16 in
      Array.iter (fun row -> List.iter (fun e -> Hashtbl.replace counts e (1 + Option.value ~default:0 (Hashtbl.find_opt counts e)))
                     (List.sort_uniq Int.compare (List.map fst row))) rows;
      fun e -> float_of_int (Option.value ~default:0 (Hashtbl.find_opt counts e)) /. float_of_int (max 1 (Array.length rows))) edges in
  let t =
    { process; row = rows_by_event layout process; edges; events = Array.map (Array.map events_of) edges; alphabets = Array.map (fun rows -> fst (alphabet rows)) edges; able = Array.map able edges; performs = Array.map performs rules; overruled = Array.make (Array.length rules) Bytes.empty; rules; parts = Array.map slots_of_rule rules; asking; setting; guarding; leading;
      leaders = Array.map (fun rows -> Array.make (Array.length rows) None) edges;
      first = Array.make (Array.length rules) (-1); queries = [||]; query_count = 0; query_numbers = Keys.create 1000;
      entry_numbers = Keys.create 1000; entries = [||]; entry_count = 0; learning = true;
      work = 0; check_work = 0; touching = Array.make count 0;
      stamps = Array.make (Array.length rules) 0; stamp = 0; known = Keys.create 1000; words = List.length layout.groups; fields = fields_of layout; led = 0 }
  in
  for n = Array.length rules - 1 downto 0 do
    let w = rules.(n) in
    List.iter
      (function Performs (k, e) -> if not (List.mem n asking.(k).(e)) then asking.(k).(e) <- n :: asking.(k).(e)
        | Sets (k, _) -> if k < count then setting.(k) <- n :: setting.(k))
      w.items;
    let around = List.sort_uniq Int.compare (List.concat_map (fun g -> if g.prior then g.around else []) w.passages) in
    List.iter (fun k -> guarding.(k) <- n :: guarding.(k)) around;
    List.iter (fun k -> if k < count then t.touching.(k) <- t.touching.(k) + 1) t.parts.(n);
    let candidate = (any || w.performed = 0) && not (List.exists (fun g -> g.prior) w.passages)
                    && List.for_all (fun k -> k < count) t.parts.(n) in
    if candidate then begin
      let rarer best = function
        | Performs (k, e) -> (
            match best with Some (j, d) when share.(j) d <= share.(k) e -> best | _ -> Some (k, e))
        | Sets _ -> best
      in
      match List.fold_left rarer None w.items with
      | Some (k, e) ->
          t.first.(n) <- query_of t n t.parts.(n);
          if t.first.(n) >= 0 then leading.(k).(e) <- n :: leading.(k).(e)
      | None -> ()
    end
  done;
  t

let cube_of slots values = List.combine (Array.to_list slots) values

let entry_key rule cube = List.fold_left (fun key (k, v) -> k :: v :: key) [ rule ] cube

let add_entry t rule cube =
  let key = entry_key rule cube in
  match Keys.find_opt t.entry_numbers key with
  | Some j -> j
  | None ->
      let j = t.entry_count in
      if j = Array.length t.entries then t.entries <- Array.append t.entries (Array.make (j + 16) (rule, cube));
      t.entries.(j) <- (rule, cube);
      t.entry_count <- j + 1;
      Keys.add t.entry_numbers key j;
      t.check_work <- List.fold_left (fun sum (k, _) -> sum + t.touching.(k)) t.check_work cube;
      j

exception Disturbed of int option

let[@inline] can t k v e =
  v < Array.length t.edges.(k)
  &&
  let number = t.alphabets.(k).(e) in
  number >= 0 && Bytes.get t.able.(k).(v) number = 'y'

(* Returns whether the followed rule prevents the other rule by a priority. *)
let is_overruled t rule n =
  if Bytes.length t.overruled.(rule) = 0 then t.overruled.(rule) <- Bytes.make (Array.length t.rules) '?';
  let known = t.overruled.(rule) in
  if Bytes.get known n = '?' then
    Bytes.set known n (if cannot_fire t.row t.rules.(rule) [] t.rules.(n) then 'y' else 'n');
  Bytes.get known n = 'y'

(* Examines the other rules in one joint state. Returns the joint states to which they lead, each with the rule. Raises
   `Disturbed` with the first rule for which a condition fails. *)
let examine t rule slots values =
  let r = t.rules.(rule) and cube = cube_of slots values in
  let in_range (k, v) = v < Array.length t.edges.(k) in
  if not (List.for_all in_range cube && List.for_all (sure t.process t.row cube) r.items) then raise (Disturbed None);
  t.stamp <- t.stamp + 1;
  let found = ref [] in
  let impossible = function
    | Performs (k, e) -> ( match local_in cube k with Some v -> not (can t k v e) | None -> false)
    | Sets _ -> false
  in
  let consider n =
    t.work <- t.work + 1;
    if t.stamps.(n) <> t.stamp then begin
      t.stamps.(n) <- t.stamp;
      let w = t.rules.(n) in
      if not (n = rule || List.exists impossible w.items || is_overruled t rule n || (w.performed = r.performed && same_items w.items r.items)) then
        if List.for_all (commutes t.row r.items cube) w.items && List.for_all (undisturbed t.row r.items cube) w.passages
        then List.iter (fun o -> found := (n, List.map snd o) :: !found) (outcomes t.row cube w.items cube)
        else raise (Disturbed (Some n))
    end
  in
  List.iter
    (fun (k, v) ->
      List.iter (fun e -> List.iter consider t.asking.(k).(e)) t.events.(k).(v);
      List.iter consider t.setting.(k))
    cube;
  List.iter (fun k -> List.iter consider t.guarding.(k)) t.parts.(rule);
  List.rev !found

(* The next query after a failed proof: the first of these rules that has some components that are not tracked. *)
let larger t query rules =
  let most = List.length t.parts.(query.rule) + most_beside in
  let extend n =
    let slots = List.sort_uniq Int.compare (List.map fst t.performs.(n) @ Array.to_list query.slots) in
    let count = List.length slots in
    if count > Array.length query.slots && count <= most then Some (query_of t query.rule slots) else None
  in
  match List.find_map extend rules with Some q when q >= 0 -> Larger q | _ -> No

let joint_state query values =
  let rec sum i key = function [] -> key | v :: rest -> sum (i + 1) (key + (query.weights.(i) * v)) rest in
  sum 0 0 values

(* Collects the joint states that other rules can reach before the rule fires. *)
let prove t q values =
  let query = t.queries.(q) in
  let seen = Keys.create 16 and order = Queue.create () in
  let add values path =
    if not (Keys.mem seen values) then begin
      Keys.add seen values ();
      Queue.add (values, path) order
    end
  in
  add values [];
  let proved = ref [] in
  let rec go () =
    match Queue.take_opt order with
    | None ->
        let enter values =
          let j = add_entry t query.rule (cube_of query.slots values) in
          Numbers.replace query.answers (joint_state query values) (Entry j)
        in
        List.iter enter (List.rev !proved);
        query.proved <- query.proved + 1;
        Numbers.find query.answers (joint_state query values)
    | Some (here, path) ->
        query.looked <- query.looked + 1;
        if Keys.length seen > most_together then No
        else begin
          match examine t query.rule query.slots here with
          | next ->
              proved := here :: !proved;
              List.iter (fun (n, values) -> add values (n :: path)) next;
              go ()
          | exception Disturbed None -> No
          | exception Disturbed (Some n) -> larger t query (n :: path)
        end
  in
  go ()

let rec answer t (locals : int array) q =
  let query = t.queries.(q) in
  let key = ref 0 in
  for i = 0 to Array.length query.slots - 1 do
    key := !key + (query.weights.(i) * locals.(query.slots.(i)))
  done;
  match Numbers.find_opt query.answers !key with
  | Some (Entry j) -> Some j
  | Some No -> None
  | Some (Larger q) -> answer t locals q
  | None ->
      if (not t.learning) || t.work > most_work || t.check_work > most_work || (query.proved = 0 && query.looked > most_in_vain) then None
      else begin
        let found = prove t q (Array.to_list (Array.map (fun k -> locals.(k)) query.slots)) in
        Numbers.replace query.answers !key found;
        match found with Entry j -> Some j | No -> None | Larger q -> answer t locals q
      end

(* Returns the rules whose steps may be followed, and that require an event of this component in this state. *)
let leaders_at t k v =
  match t.leaders.(k).(v) with
  | Some rules -> rules
  | None ->
      let rules = List.concat_map (fun e -> t.leading.(k).(e)) t.events.(k).(v) in
      t.leaders.(k).(v) <- Some rules;
      rules

(* Returns the entry of the first step that may be followed. *)
let first_entry t (locals : int array) =
  let rec enabled = function [] -> true | (k, e) :: rest -> can t k locals.(k) e && enabled rest in
  let followed n = if enabled t.performs.(n) then answer t locals t.first.(n) else None in
  let rec at_slot k =
    if k = Array.length locals then None
    else if locals.(k) >= Array.length t.edges.(k) then at_slot (k + 1)
    else match List.find_map followed (leaders_at t k locals.(k)) with None -> at_slot (k + 1) | found -> found
  in
  at_slot 0

let perform t locals j =
  let rule, cube = t.entries.(j) in
  let result = Array.copy locals in
  List.iter
    (function
      | Performs (k, e) -> result.(k) <- goal t.row k e (Option.get (local_in cube k))
      | Sets (k, x) -> result.(k) <- x)
    t.rules.(rule).items;
  result

let[@inline] read (words : int array) (word, shift, bits) = (words.(word) lsr shift) land ((1 lsl bits) - 1)

(* Returns the states of the components. *)
let unpack fields words = Array.map (read (Array.of_list words)) fields

let pack t locals =
  let result = Array.make t.words 0 in
  Array.iteri (fun k (word, shift, _) -> result.(word) <- result.(word) lor (locals.(k) lsl shift)) t.fields;
  Array.to_list result

let longest_sequence = 1_000
let most_known = 100_000

let remember t words path =
  if Keys.length t.known >= most_known then Keys.reset t.known;
  Keys.replace t.known words path

(* Returns the entries from the first of these states to the least state, in the order of the steps. *)
let path_into_cycle states entries cycle =
  let least = List.fold_left min (List.hd cycle) cycle in
  let rec until states entries =
    match (states, entries) with
    | s :: _, _ when s = least -> []
    | _ :: states, j :: entries -> j :: until states entries
    | _ -> []
  in
  until states entries

(* Returns the entries that lead from a state to its representative. If the followed steps form a cycle, this is the least
   state of the cycle. `before` and `entries`: the states before this state, and the entries that lead from each of them to
   the next, the last ones first. *)
let rec path_from t locals before entries length =
  let words = pack t locals in
  let finish path =
    (* The path of each state before is one entry longer. *)
    let note path (words, j) = let path = j :: path in remember t words path; path in
    List.fold_left note path (List.combine (List.map (pack t) before) entries)
  in
  match Keys.find_opt t.known words with
  | Some path -> finish path
  | None -> (
      match if length >= longest_sequence then None else first_entry t locals with
      | None ->
          remember t words [];
          finish []
      | Some j ->
          let next = perform t locals j in
          let before = locals :: before and entries = j :: entries in
          let rec cycle = function
            | [] -> None
            | s :: rest -> if s = next then Some [ s ] else Option.map (fun c -> s :: c) (cycle rest)
          in
          match cycle before with
          | None -> path_from t next before entries (length + 1)
          | Some states ->
              let states_in_order = List.rev before and entries_in_order = List.rev entries in
              let path = path_into_cycle states_in_order entries_in_order states in
              remember t (pack t (List.hd states_in_order)) path;
              path)

let hint t words =
  match Keys.find_opt t.known words with Some path -> path | None -> path_from t (unpack t.fields words) [] [] 0

let collected t : confluent_steps =
  let count = t.entry_count in
  { entries = count;
    follows = (fun j -> fst t.entries.(j));
    states_of = (fun j -> snd t.entries.(j));
    entry_after =
      (fun j cube -> Option.value ~default:count (Keys.find_opt t.entry_numbers (entry_key (fst t.entries.(j)) cube)));
    hint = hint t }

(* Learning ends after so many states. Then only the steps that were learned are followed. So a state that is explored
   twice costs little, and learning ends soon for a process that cannot be reduced. *)
let sample_size = 20_000

(* Explores a part of the reduced system, and learns which steps may be followed. Returns false if this does not make the
   system noticeably smaller. *)
let learn t (lts : Search.words lts) =
  let store = Search.new_store (List.length lts.init) in
  let frontier = Search.new_row () and expanded = ref 0 in
  let targets = ref 0 in
  let add words =
    incr targets;
    let path = hint t words in
    let words =
      if path = [] then words
      else begin
        t.led <- t.led + 1;
        pack t (List.fold_left (perform t) (unpack t.fields words) path)
      end
    in
    let before = store.Search.filled in
    if Search.insert store words 0 = before then Search.push frontier before
  in
  add lts.init;
  (* Removes a state of the frontier. The order looks random, so that early states come from all parts of the system. *)
  let take () =
    let i = Search.mix 0 !expanded land max_int mod frontier.used in
    let j = frontier.values.{i} in
    frontier.used <- frontier.used - 1;
    frontier.values.{i} <- frontier.values.{frontier.used};
    incr expanded;
    Search.words_at store j
  in
  let worthwhile () = 10 * t.led >= !targets in
  let rec go () =
    if frontier.used = 0 then t.led > 0
    else if store.Search.filled > sample_size then worthwhile ()
    else begin
      List.iter (fun (_, u) -> add u) (lts.succ0 (take ()));
      go ()
    end
  in
  let useful = go () in
  t.learning <- false;
  useful

(* Returns the steps of the process that may be followed, if this helps. *)
let steps_of (process : system) sizes (layout : layout) (lts : Search.words lts) ~any =
  if count_rules process > most_rules || List.fold_left ( + ) 0 sizes > most_able / layout.event_count then None
  else
    let t = prepare process sizes layout layout.event_count ~any in
    if Array.for_all (fun q -> q < 0) t.first then None
    else if learn t lts then Some (collected t)
    else None
