(* SPDX-License-Identifier: Apache-2.0 *)
(* Extracted by Coq from ../coq (check.sh --write). *)

(** val negb : bool -> bool **)

let negb = function
| true -> false
| false -> true

(** val fst : ('a1 * 'a2) -> 'a1 **)

let fst = function
| (x, _) -> x

(** val snd : ('a1 * 'a2) -> 'a2 **)

let snd = function
| (_, y) -> y

(** val length : 'a1 list -> int **)

let rec length = function
| [] -> 0
| _ :: l' -> Stdlib.Int.succ (length l')

(** val app : 'a1 list -> 'a1 list -> 'a1 list **)

let rec app l m =
  match l with
  | [] -> m
  | a :: l1 -> a :: (app l1 m)

type comparison =
| Eq
| Lt
| Gt

(** val compOpp : comparison -> comparison **)

let compOpp = function
| Eq -> Eq
| Lt -> Gt
| Gt -> Lt

module Coq__1 = struct
 (** val add : int -> int -> int **)let rec add = (+)
end
include Coq__1

module Nat =
 struct
  (** val ltb : int -> int -> bool **)

  let ltb n m =
    (<=) (Stdlib.Int.succ n) m
 end

type positive =
| XI of positive
| XO of positive
| XH

type z =
| Z0
| Zpos of positive
| Zneg of positive

module Pos =
 struct
  (** val succ : positive -> positive **)

  let rec succ = function
  | XI p -> XO (succ p)
  | XO p -> XI p
  | XH -> XO XH

  (** val add : positive -> positive -> positive **)

  let rec add x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> XO (add_carry p q)
       | XO q -> XI (add p q)
       | XH -> XO (succ p))
    | XO p ->
      (match y with
       | XI q -> XI (add p q)
       | XO q -> XO (add p q)
       | XH -> XI p)
    | XH -> (match y with
             | XI q -> XO (succ q)
             | XO q -> XI q
             | XH -> XO XH)

  (** val add_carry : positive -> positive -> positive **)

  and add_carry x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> XI (add_carry p q)
       | XO q -> XO (add_carry p q)
       | XH -> XI (succ p))
    | XO p ->
      (match y with
       | XI q -> XO (add_carry p q)
       | XO q -> XI (add p q)
       | XH -> XO (succ p))
    | XH ->
      (match y with
       | XI q -> XI (succ q)
       | XO q -> XO (succ q)
       | XH -> XI XH)

  (** val pred_double : positive -> positive **)

  let rec pred_double = function
  | XI p -> XI (XO p)
  | XO p -> XI (pred_double p)
  | XH -> XH

  (** val mul : positive -> positive -> positive **)

  let rec mul x y =
    match x with
    | XI p -> add y (XO (mul p y))
    | XO p -> XO (mul p y)
    | XH -> y

  (** val iter : ('a1 -> 'a1) -> 'a1 -> positive -> 'a1 **)

  let rec iter f x = function
  | XI n' -> f (iter f (iter f x n') n')
  | XO n' -> iter f (iter f x n') n'
  | XH -> f x

  (** val compare_cont : comparison -> positive -> positive -> comparison **)

  let rec compare_cont r x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> compare_cont r p q
       | XO q -> compare_cont Gt p q
       | XH -> Gt)
    | XO p ->
      (match y with
       | XI q -> compare_cont Lt p q
       | XO q -> compare_cont r p q
       | XH -> Gt)
    | XH -> (match y with
             | XH -> r
             | _ -> Lt)

  (** val compare : positive -> positive -> comparison **)

  let compare =
    compare_cont Eq

  (** val iter_op : ('a1 -> 'a1 -> 'a1) -> positive -> 'a1 -> 'a1 **)

  let rec iter_op op p a =
    match p with
    | XI p0 -> op a (iter_op op p0 (op a a))
    | XO p0 -> iter_op op p0 (op a a)
    | XH -> a

  (** val to_nat : positive -> int **)

  let to_nat x =
    iter_op Coq__1.add x (Stdlib.Int.succ 0)

  (** val of_succ_nat : int -> positive **)

  let rec of_succ_nat n =
    (fun fO fS n -> if n=0 then fO () else fS (n-1))
      (fun _ -> XH)
      (fun x -> succ (of_succ_nat x))
      n
 end

(** val tl : 'a1 list -> 'a1 list **)

let tl = function
| [] -> []
| _ :: m -> m

(** val nth : int -> 'a1 list -> 'a1 -> 'a1 **)

let rec nth n l default =
  (fun fO fS n -> if n=0 then fO () else fS (n-1))
    (fun _ -> match l with
              | [] -> default
              | x :: _ -> x)
    (fun m -> match l with
              | [] -> default
              | _ :: t -> nth m t default)
    n

(** val concat : 'a1 list list -> 'a1 list **)

let rec concat = function
| [] -> []
| x :: l0 -> app x (concat l0)

(** val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list **)

let rec map f = function
| [] -> []
| a :: t -> (f a) :: (map f t)

(** val flat_map : ('a1 -> 'a2 list) -> 'a1 list -> 'a2 list **)

let rec flat_map f = function
| [] -> []
| x :: t -> app (f x) (flat_map f t)

(** val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1 **)

let rec fold_left f l a0 =
  match l with
  | [] -> a0
  | b :: t -> fold_left f t (f a0 b)

(** val existsb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec existsb f = function
| [] -> false
| a :: l0 -> (||) (f a) (existsb f l0)

(** val forallb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec forallb f = function
| [] -> true
| a :: l0 -> (&&) (f a) (forallb f l0)

(** val filter : ('a1 -> bool) -> 'a1 list -> 'a1 list **)

let rec filter f = function
| [] -> []
| x :: l0 -> if f x then x :: (filter f l0) else filter f l0

(** val skipn : int -> 'a1 list -> 'a1 list **)

let rec skipn n l =
  (fun fO fS n -> if n=0 then fO () else fS (n-1))
    (fun _ -> l)
    (fun n0 -> match l with
               | [] -> []
               | _ :: l0 -> skipn n0 l0)
    n

(** val seq : int -> int -> int list **)

let rec seq start0 len =
  (fun fO fS n -> if n=0 then fO () else fS (n-1))
    (fun _ -> [])
    (fun len0 -> start0 :: (seq (Stdlib.Int.succ start0) len0))
    len

module Z =
 struct
  (** val double : z -> z **)

  let double = function
  | Z0 -> Z0
  | Zpos p -> Zpos (XO p)
  | Zneg p -> Zneg (XO p)

  (** val succ_double : z -> z **)

  let succ_double = function
  | Z0 -> Zpos XH
  | Zpos p -> Zpos (XI p)
  | Zneg p -> Zneg (Pos.pred_double p)

  (** val mul : z -> z -> z **)

  let mul x y =
    match x with
    | Z0 -> Z0
    | Zpos x' ->
      (match y with
       | Z0 -> Z0
       | Zpos y' -> Zpos (Pos.mul x' y')
       | Zneg y' -> Zneg (Pos.mul x' y'))
    | Zneg x' ->
      (match y with
       | Z0 -> Z0
       | Zpos y' -> Zneg (Pos.mul x' y')
       | Zneg y' -> Zpos (Pos.mul x' y'))

  (** val pow_pos : z -> positive -> z **)

  let pow_pos z0 =
    Pos.iter (mul z0) (Zpos XH)

  (** val pow : z -> z -> z **)

  let pow x = function
  | Z0 -> Zpos XH
  | Zpos p -> pow_pos x p
  | Zneg _ -> Z0

  (** val compare : z -> z -> comparison **)

  let compare x y =
    match x with
    | Z0 -> (match y with
             | Z0 -> Eq
             | Zpos _ -> Lt
             | Zneg _ -> Gt)
    | Zpos x' -> (match y with
                  | Zpos y' -> Pos.compare x' y'
                  | _ -> Gt)
    | Zneg x' ->
      (match y with
       | Zneg y' -> compOpp (Pos.compare x' y')
       | _ -> Lt)

  (** val ltb : z -> z -> bool **)

  let ltb x y =
    match compare x y with
    | Lt -> true
    | _ -> false

  (** val to_nat : z -> int **)

  let to_nat = function
  | Zpos p -> Pos.to_nat p
  | _ -> 0

  (** val of_nat : int -> z **)

  let of_nat n =
    (fun fO fS n -> if n=0 then fO () else fS (n-1))
      (fun _ -> Z0)
      (fun n0 -> Zpos (Pos.of_succ_nat n0))
      n
 end

(** val lsl0 : Uint63.t -> Uint63.t -> Uint63.t **)

let lsl0 = Uint63.l_sl

(** val lsr0 : Uint63.t -> Uint63.t -> Uint63.t **)

let lsr0 = Uint63.l_sr

(** val land0 : Uint63.t -> Uint63.t -> Uint63.t **)

let land0 = Uint63.l_and

(** val add0 : Uint63.t -> Uint63.t -> Uint63.t **)

let add0 = Uint63.add

(** val mul0 : Uint63.t -> Uint63.t -> Uint63.t **)

let mul0 = Uint63.mul

(** val div : Uint63.t -> Uint63.t -> Uint63.t **)

let div = Uint63.div

(** val mod0 : Uint63.t -> Uint63.t -> Uint63.t **)

let mod0 = Uint63.rem

(** val eqb : Uint63.t -> Uint63.t -> bool **)

let eqb = Uint63.equal

(** val ltb0 : Uint63.t -> Uint63.t -> bool **)

let ltb0 = Uint63.lt

(** val leb : Uint63.t -> Uint63.t -> bool **)

let leb = Uint63.le

(** val size : int **)

let size =
  Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    (Stdlib.Int.succ (Stdlib.Int.succ (Stdlib.Int.succ
    0))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))

(** val is_zero : Uint63.t -> bool **)

let is_zero i =
  eqb i (Uint63.of_int (0))

(** val is_even : Uint63.t -> bool **)

let is_even i =
  is_zero (land0 i (Uint63.of_int (1)))

(** val to_Z_rec : int -> Uint63.t -> z **)

let rec to_Z_rec n i =
  (fun fO fS n -> if n=0 then fO () else fS (n-1))
    (fun _ -> Z0)
    (fun n0 ->
    if is_even i
    then Z.double (to_Z_rec n0 (lsr0 i (Uint63.of_int (1))))
    else Z.succ_double (to_Z_rec n0 (lsr0 i (Uint63.of_int (1)))))
    n

(** val to_Z : Uint63.t -> z **)

let to_Z =
  to_Z_rec size

(** val wB : z **)

let wB =
  Z.pow (Zpos (XO XH)) (Z.of_nat size)

type 'a array = 'a Parray.t



type ev = Uint63.t

(** val tau : ev **)

let tau =
  (Uint63.of_int (0))

(** val tick : ev **)

let tick =
  (Uint63.of_int (1))

type 's lts = { init : 's; succ0 : ('s -> (ev * 's) list) }

type model =
| T
| F
| FD

type property =
| Deadlock_free
| Deadlock_and_divergence_free
| Divergence_free

type rule = { does : ev; level : Uint63.t option; asks : (int * ev) list;
              puts : (int * Uint63.t) list }

type region =
| Region of participant list * rule list
and participant =
| Slot of int
| Inner of region

type system = { edges : (int -> Uint63.t -> (ev * Uint63.t) list);
                start : Uint63.t list; whole : region }

type change = int * Uint63.t

type move = ev * change list

(** val combine : move list list -> (int * ev) list -> change list list **)

let rec combine ms = function
| [] -> [] :: []
| p :: rest ->
  let (i, e) = p in
  flat_map (fun m ->
    if eqb (fst m) e then map (app (snd m)) (combine ms rest) else [])
    (nth i ms [])

(** val nonempty : 'a1 list -> bool **)

let nonempty = function
| [] -> false
| _ :: _ -> true

(** val slot_moves : system -> int -> Uint63.t -> move list **)

let slot_moves y k v =
  map (fun e -> ((fst e), ((k, (snd e)) :: []))) (y.edges k v)

(** val update : Uint63.t list -> int -> Uint63.t -> Uint63.t list **)

let rec update s k x =
  match s with
  | [] -> []
  | v :: s' ->
    ((fun fO fS n -> if n=0 then fO () else fS (n-1))
       (fun _ -> x :: s')
       (fun k' -> v :: (update s' k' x))
       k)

(** val apply : Uint63.t list -> change list -> Uint63.t list **)

let apply s ch =
  fold_left (fun s0 c -> update s0 (fst c) (snd c)) ch s

(** val all_from :
    Uint63.t list -> (Uint63.t -> bool) -> Uint63.t -> Uint63.t -> bool **)

let rec all_from widths chk len lo =
  if leb len lo
  then true
  else (match widths with
        | [] -> chk lo
        | w :: rest ->
          if all_from rest chk len lo
          then all_from rest chk len (add0 lo w)
          else false)

(** val few_widths : Uint63.t list **)

let few_widths =
  (Uint63.of_int (32)) :: ((Uint63.of_int (16)) :: ((Uint63.of_int (8)) :: ((Uint63.of_int (4)) :: ((Uint63.of_int (2)) :: ((Uint63.of_int (1)) :: [])))))

(** val many_widths : Uint63.t list **)

let many_widths =
  (Uint63.of_int (140737488355328)) :: ((Uint63.of_int (70368744177664)) :: ((Uint63.of_int (35184372088832)) :: ((Uint63.of_int (17592186044416)) :: ((Uint63.of_int (8796093022208)) :: ((Uint63.of_int (4398046511104)) :: ((Uint63.of_int (2199023255552)) :: ((Uint63.of_int (1099511627776)) :: ((Uint63.of_int (549755813888)) :: ((Uint63.of_int (274877906944)) :: ((Uint63.of_int (137438953472)) :: ((Uint63.of_int (68719476736)) :: ((Uint63.of_int (34359738368)) :: ((Uint63.of_int (17179869184)) :: ((Uint63.of_int (8589934592)) :: ((Uint63.of_int (4294967296)) :: ((Uint63.of_int (2147483648)) :: ((Uint63.of_int (1073741824)) :: ((Uint63.of_int (536870912)) :: ((Uint63.of_int (268435456)) :: ((Uint63.of_int (134217728)) :: ((Uint63.of_int (67108864)) :: ((Uint63.of_int (33554432)) :: ((Uint63.of_int (16777216)) :: ((Uint63.of_int (8388608)) :: ((Uint63.of_int (4194304)) :: ((Uint63.of_int (2097152)) :: ((Uint63.of_int (1048576)) :: ((Uint63.of_int (524288)) :: ((Uint63.of_int (262144)) :: ((Uint63.of_int (131072)) :: ((Uint63.of_int (65536)) :: ((Uint63.of_int (32768)) :: ((Uint63.of_int (16384)) :: ((Uint63.of_int (8192)) :: ((Uint63.of_int (4096)) :: ((Uint63.of_int (2048)) :: ((Uint63.of_int (1024)) :: ((Uint63.of_int (512)) :: ((Uint63.of_int (256)) :: ((Uint63.of_int (128)) :: ((Uint63.of_int (64)) :: ((Uint63.of_int (32)) :: ((Uint63.of_int (16)) :: ((Uint63.of_int (8)) :: ((Uint63.of_int (4)) :: ((Uint63.of_int (2)) :: ((Uint63.of_int (1)) :: [])))))))))))))))))))))))))))))))))))))))))))))))

(** val all_below : (Uint63.t -> bool) -> Uint63.t -> bool **)

let all_below chk len =
  if ltb0 len (Uint63.of_int (64))
  then all_from few_widths chk len (Uint63.of_int (0))
  else if ltb0 len (lsl0 (Uint63.of_int (1)) (Uint63.of_int (48)))
       then all_from many_widths chk len (Uint63.of_int (0))
       else false

(** val fill :
    (Uint63.t -> 'a1) -> int -> Uint63.t -> 'a1 array -> 'a1 array **)

let rec fill f n i t =
  (fun fO fS n -> if n=0 then fO () else fS (n-1))
    (fun _ -> t)
    (fun n' -> fill f n' (add0 i (Uint63.of_int (1))) (Parray.set t i (f i)))
    n

(** val tabulate : Uint63.t -> (Uint63.t -> 'a1) -> 'a1 array **)

let tabulate n f =
  if leb n Parray.max_length
  then fill f (Z.to_nat (to_Z n)) (Uint63.of_int (0))
         (Parray.make n (f (Uint63.of_int (0))))
  else Parray.make (Uint63.of_int (0)) (f (Uint63.of_int (0)))

(** val lookup : 'a1 array -> (Uint63.t -> 'a1) -> Uint63.t -> 'a1 **)

let lookup t f v =
  if ltb0 v (Parray.length t) then Parray.get t v else f v

(** val table : Uint63.t -> (Uint63.t -> 'a1) -> Uint63.t -> 'a1 **)

let table n f =
  let t = tabulate n f in (fun v -> lookup t f v)

(** val memb : ev -> ev list -> bool **)

let memb a a0 =
  existsb (fun b -> eqb a b) a0

(** val offers : (ev * 'a1) list -> ev -> bool **)

let offers moves a =
  existsb (fun m -> eqb (fst m) a) moves

type normal_form = { nodes : Uint63.t; root : Uint63.t;
                     arc_count : (Uint63.t -> Uint63.t);
                     arc : (Uint63.t -> Uint63.t -> ev * Uint63.t);
                     where_is : (Uint63.t -> ev -> Uint63.t);
                     acceptance_count : (Uint63.t -> Uint63.t);
                     acceptance : (Uint63.t -> Uint63.t -> ev list);
                     divergent : (Uint63.t -> bool) }

(** val after : normal_form -> Uint63.t -> ev -> Uint63.t option **)

let after n n0 a =
  let i = n.where_is n0 a in
  if ltb0 i (n.arc_count n0)
  then let (b, k) = n.arc n0 i in if eqb b a then Some k else None
  else None

type origin = { by_event : bool; from : Uint63.t; depth : Uint63.t }

type 's evidence = { size0 : (Uint63.t -> Uint63.t);
                     member : (Uint63.t -> Uint63.t -> 's);
                     origin_in_root : (Uint63.t -> origin);
                     origin_after : (Uint63.t -> Uint63.t -> Uint63.t ->
                                    origin);
                     witness : (Uint63.t -> Uint63.t -> Uint63.t);
                     loop_size : Uint63.t; loop : (Uint63.t -> 's);
                     loop_next : (Uint63.t -> Uint63.t);
                     diverging_member : (Uint63.t -> Uint63.t);
                     loop_entry : (Uint63.t -> Uint63.t) }

(** val steps_to :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 -> ev -> 'a1 -> bool **)

let steps_to spec eqs s a u =
  existsb (fun m -> if eqb (fst m) a then eqs (snd m) u else false)
    (spec.succ0 s)

(** val derived :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 evidence -> (Uint63.t -> 'a1 ->
    bool) -> (Uint63.t -> origin) -> Uint63.t -> bool **)

let derived spec eqs e seed source k =
  all_below (fun j ->
    let o = source j in
    if o.by_event
    then seed o.from (e.member k j)
    else if ltb0 o.from (e.size0 k)
         then if ltb0 (source o.from).depth o.depth
              then steps_to spec eqs (e.member k o.from) tau (e.member k j)
              else false
         else false) (e.size0 k)

(** val accepts : 'a1 lts -> ev list -> 'a1 -> bool **)

let accepts spec a s =
  let moves = spec.succ0 s in
  if offers moves tick
  then memb tick a
  else (&&) (negb (offers moves tau))
         (forallb (fun m -> memb (fst m) a) moves)

(** val check_arc :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> 'a1 evidence ->
    Uint63.t -> Uint63.t -> bool **)

let check_arc spec eqs n e n0 i =
  let (a, k) = n.arc n0 i in
  if eqb a tau
  then false
  else if ltb0 k n.nodes
       then derived spec eqs e (fun f u ->
              if ltb0 f (e.size0 n0)
              then steps_to spec eqs (e.member n0 f) a u
              else false) (e.origin_after n0 i) k
       else false

(** val check_acceptance :
    'a1 lts -> normal_form -> 'a1 evidence -> Uint63.t -> Uint63.t -> bool **)

let check_acceptance spec n e n0 i =
  let j = e.witness n0 i in
  if ltb0 j (e.size0 n0)
  then accepts spec (n.acceptance n0 i) (e.member n0 j)
  else false

(** val check_divergence :
    ('a1 -> 'a1 -> bool) -> normal_form -> 'a1 evidence -> Uint63.t -> bool **)

let check_divergence eqs n e n0 =
  if n.divergent n0
  then if ltb0 (e.diverging_member n0) (e.size0 n0)
       then if ltb0 (e.loop_entry n0) e.loop_size
            then eqs (e.member n0 (e.diverging_member n0))
                   (e.loop (e.loop_entry n0))
            else false
       else false
  else true

(** val check_node :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> 'a1 evidence -> model
    -> Uint63.t -> bool **)

let check_node spec eqs n e m n0 =
  (&&)
    ((&&)
      ((&&) (ltb0 (Uint63.of_int (0)) (e.size0 n0))
        (all_below (check_arc spec eqs n e n0) (n.arc_count n0)))
      (match m with
       | T -> true
       | _ -> all_below (check_acceptance spec n e n0) (n.acceptance_count n0)))
    (match m with
     | FD -> check_divergence eqs n e n0
     | _ -> true)

(** val check_root :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> 'a1 evidence -> bool **)

let check_root spec eqs n e =
  (&&) (ltb0 n.root n.nodes)
    (derived spec eqs e (fun _ u -> eqs spec.init u) e.origin_in_root n.root)

(** val check_loop :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 evidence -> bool **)

let check_loop spec eqs e =
  all_below (fun j ->
    if ltb0 (e.loop_next j) e.loop_size
    then steps_to spec eqs (e.loop j) tau (e.loop (e.loop_next j))
    else false) e.loop_size

(** val check_specification :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> 'a1 evidence -> model
    -> bool **)

let check_specification spec eqs n e m =
  (&&) ((&&) (check_root spec eqs n e) (check_loop spec eqs e))
    (all_below (check_node spec eqs n e m) n.nodes)

type 's pairs = { count : Uint63.t; state_of : (Uint63.t -> 's);
                  node_of : (Uint63.t -> Uint63.t);
                  rank_of : (Uint63.t -> Uint63.t);
                  locate : ('s -> Uint63.t -> Uint63.t);
                  choose : (Uint63.t -> (ev * 's) list -> Uint63.t) }

(** val within : Uint63.t option -> Uint63.t -> bool **)

let within bound r =
  match bound with
  | Some b -> ltb0 r b
  | None -> true

(** val covered :
    ('a1 -> 'a1 -> bool) -> 'a1 pairs -> 'a1 -> Uint63.t -> Uint63.t option
    -> bool **)

let covered eqi p u k bound =
  let j = p.locate u k in
  if ltb0 j p.count
  then if eqb (p.node_of j) k
       then if eqi (p.state_of j) u then within bound (p.rank_of j) else false
       else false
  else false

(** val stop : normal_form -> model -> Uint63.t -> bool **)

let stop n m n0 =
  match m with
  | FD -> n.divergent n0
  | _ -> false

(** val ranked : model -> bool **)

let ranked = function
| FD -> true
| _ -> false

(** val refusals_ok :
    normal_form -> 'a1 pairs -> Uint63.t -> (ev * 'a1) list -> bool **)

let refusals_ok n p n0 moves =
  let fits0 = fun offered ->
    let i = p.choose n0 moves in
    if ltb0 i (n.acceptance_count n0)
    then forallb offered (n.acceptance n0 i)
    else false
  in
  if offers moves tick
  then fits0 (fun a -> eqb a tick)
  else if offers moves tau then true else fits0 (offers moves)

(** val check_move :
    ('a1 -> 'a1 -> bool) -> normal_form -> model -> 'a1 pairs -> Uint63.t ->
    Uint63.t -> (ev * 'a1) -> bool **)

let check_move eqi n m p n0 r = function
| (a, u) ->
  if eqb a tau
  then covered eqi p u n0 (if ranked m then Some r else None)
  else (match after n n0 a with
        | Some k -> if stop n m k then true else covered eqi p u k None
        | None -> false)

(** val check_pair :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> model -> 'a1 pairs ->
    Uint63.t -> bool **)

let check_pair impl eqi n m p i =
  let n0 = p.node_of i in
  if stop n m n0
  then true
  else let r = p.rank_of i in
       let moves = impl.succ0 (p.state_of i) in
       if forallb (check_move eqi n m p n0 r) moves
       then (match m with
             | T -> true
             | _ -> refusals_ok n p n0 moves)
       else false

(** val check_implementation :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> model -> 'a1 pairs ->
    bool **)

let check_implementation impl eqi n m p =
  if stop n m n.root
  then true
  else if covered eqi p impl.init n.root None
       then all_below (check_pair impl eqi n m p) p.count
       else false

(** val check :
    'a1 lts -> 'a2 lts -> ('a1 -> 'a1 -> bool) -> ('a2 -> 'a2 -> bool) ->
    model -> normal_form -> 'a1 evidence -> 'a2 pairs -> bool **)

let check spec impl eqs eqi m n e p =
  (&&) (check_specification spec eqs n e m)
    (check_implementation impl eqi n m p)

(** val no_deadlock : property -> bool **)

let no_deadlock = function
| Divergence_free -> false
| _ -> true

(** val no_divergence : property -> bool **)

let no_divergence = function
| Deadlock_free -> false
| _ -> true

(** val check_state :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> property -> 'a1 pairs -> Uint63.t ->
    bool **)

let check_state impl eqi p p0 i =
  let r = p0.rank_of i in
  let moves = impl.succ0 (p0.state_of i) in
  if no_deadlock p
  then (match moves with
        | [] -> false
        | _ :: _ ->
          forallb (fun mv ->
            covered eqi p0 (snd mv) (Uint63.of_int (0))
              (if no_divergence p
               then if eqb (fst mv) tau then Some r else None
               else None)) moves)
  else forallb (fun mv ->
         covered eqi p0 (snd mv) (Uint63.of_int (0))
           (if no_divergence p
            then if eqb (fst mv) tau then Some r else None
            else None)) moves

(** val check_property :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> property -> 'a1 pairs -> bool **)

let check_property impl eqi p p0 =
  if covered eqi p0 impl.init (Uint63.of_int (0)) None
  then all_below (fun i ->
         if eqb (p0.node_of i) (Uint63.of_int (0))
         then check_state impl eqi p p0 i
         else true) p0.count
  else false

type lead = rule * change list

(** val led_by : int -> rule -> bool **)

let led_by i r =
  match r.asks with
  | [] -> false
  | p :: _ -> let (j, _) = p in (=) i j

(** val begins : ev -> rule -> bool **)

let begins e r =
  match r.asks with
  | [] -> false
  | p :: _ -> let (_, d) = p in eqb e d

(** val rules_of : Uint63.t -> int -> rule list -> ev -> rule list **)

let rules_of events i rules =
  let mine = filter (led_by i) rules in
  table events (fun e -> filter (begins e) mine)

(** val leads_of : (ev -> rule list) -> move list -> lead list **)

let leads_of find ms =
  flat_map (fun m -> map (fun r -> (r, (snd m))) (find (fst m))) ms

type fregion =
| FRegion of fparticipant list
and fparticipant =
| FSlot of int * (Uint63.t -> move list) * (Uint63.t -> lead list)
| FInner of fregion * (ev -> rule list)

(** val number : (int -> 'a1 -> 'a2) -> int -> 'a1 list -> 'a2 list **)

let rec number g n = function
| [] -> []
| x :: l' -> (g n x) :: (number g (Stdlib.Int.succ n) l')

(** val prepare :
    system -> Uint63.t -> (int -> Uint63.t) -> region -> fregion **)

let rec prepare y events local_states = function
| Region (inside, rules) ->
  FRegion
    (number (fun i g -> g i) 0
      (map (fun p i ->
        let find = rules_of events i rules in
        (match p with
         | Slot k ->
           FSlot (k, (table (local_states k) (slot_moves y k)),
             (table (local_states k) (fun v ->
               leads_of find (slot_moves y k v))))
         | Inner r' -> FInner ((prepare y events local_states r'), find)))
        inside))

type offer = move list * lead list

type candidate = lead * change list list

(** val able : move list list -> offer list -> candidate list **)

let able ms both =
  flat_map (fun b ->
    flat_map (fun q ->
      match combine ms (tl (fst q).asks) with
      | [] -> []
      | l :: l0 -> (q, (l :: l0)) :: []) (snd b)) both

(** val lesser : Uint63.t option -> candidate -> Uint63.t option **)

let lesser b c =
  match (fst (fst c)).level with
  | Some l ->
    (match b with
     | Some k -> if ltb0 l k then Some l else b
     | None -> Some l)
  | None -> b

(** val least : candidate list -> Uint63.t option **)

let least cs =
  fold_left lesser cs None

(** val ready : Uint63.t option -> rule -> bool **)

let ready b r =
  match r.level with
  | Some l -> (match b with
               | Some k -> negb (ltb0 k l)
               | None -> true)
  | None -> true

(** val fast_fire : offer list -> move list **)

let fast_fire both =
  let cs = able (map fst both) both in
  let b = least cs in
  flat_map (fun c ->
    let (q, others) = c in
    let (r, first) = q in
    if ready b r
    then map (fun ch -> (r.does, (app (app first ch) r.puts))) others
    else []) cs

(** val fast_moves : Uint63.t list -> fregion -> move list **)

let rec fast_moves s = function
| FRegion inside ->
  fast_fire
    (map (fun p ->
      match p with
      | FSlot (k, own, leads) ->
        let v = nth k s (Uint63.of_int (0)) in ((own v), (leads v))
      | FInner (r', find) ->
        let ms = fast_moves s r' in (ms, (leads_of find ms))) inside)

(** val asking : region -> bool **)

let rec asking = function
| Region (inside, rules) ->
  (&&) (forallb (fun r0 -> nonempty r0.asks) rules)
    (forallb (fun p -> match p with
                       | Slot _ -> true
                       | Inner r' -> asking r') inside)

(** val encode : Uint63.t list -> Uint63.t list -> Uint63.t **)

let rec encode bs s =
  match bs with
  | [] -> (Uint63.of_int (0))
  | b :: bs' ->
    (match s with
     | [] -> (Uint63.of_int (0))
     | v :: s' -> add0 v (mul0 b (encode bs' s')))

(** val fits : Uint63.t list -> Uint63.t list -> bool **)

let rec fits bs s =
  match bs with
  | [] -> (match s with
           | [] -> true
           | _ :: _ -> false)
  | b :: bs' ->
    (match s with
     | [] -> false
     | v :: s' -> (&&) (ltb0 v b) (fits bs' s'))

(** val volume : Uint63.t list -> z **)

let rec volume = function
| [] -> Zpos XH
| b :: bs' -> Z.mul (to_Z b) (volume bs')

(** val decode_before :
    Uint63.t list -> Uint63.t -> Uint63.t list -> Uint63.t list **)

let rec decode_before bs c rest =
  match bs with
  | [] -> rest
  | b :: bs' -> (mod0 c b) :: (decode_before bs' (div c b) rest)

(** val pack : Uint63.t list list -> Uint63.t list -> Uint63.t list **)

let rec pack gs s =
  match gs with
  | [] -> []
  | g :: gs' ->
    (encode g s) :: (match gs' with
                     | [] -> []
                     | _ :: _ -> pack gs' (skipn (length g) s))

(** val unpack : Uint63.t list list -> Uint63.t list -> Uint63.t list **)

let rec unpack gs c =
  match gs with
  | [] -> []
  | g :: gs' ->
    (match c with
     | [] -> []
     | w :: c' -> decode_before g w (unpack gs' c'))

(** val narrow : Uint63.t list -> bool **)

let narrow g =
  (&&) (Z.ltb (volume g) wB) (Z.ltb Z0 (volume g))

(** val eq_words : Uint63.t list -> Uint63.t list -> bool **)

let rec eq_words c d =
  match c with
  | [] -> (match d with
           | [] -> true
           | _ :: _ -> false)
  | v :: c' ->
    (match d with
     | [] -> false
     | w :: d' -> if eqb v w then eq_words c' d' else false)

type layout = { groups : Uint63.t list list; event_count : Uint63.t }

(** val inside_bounds : layout -> change -> bool **)

let inside_bounds l =
  let bases = concat l.groups in
  (fun c -> ltb0 (snd c) (nth (fst c) bases (Uint63.of_int (0))))

(** val bounded : layout -> region -> bool **)

let bounded l =
  let bases = concat l.groups in
  let rec bounded0 = function
  | Region (inside, rules) ->
    (&&) (forallb (fun r0 -> forallb (inside_bounds l) r0.puts) rules)
      (forallb (fun p ->
        match p with
        | Slot k -> Nat.ltb k (length bases)
        | Inner r' -> bounded0 r') inside)
  in bounded0

(** val edges_bounded : layout -> system -> bool **)

let edges_bounded l y =
  let bases = concat l.groups in
  forallb (fun k ->
    let b = nth k bases (Uint63.of_int (0)) in
    all_below (fun v -> forallb (fun e -> ltb0 (snd e) b) (y.edges k v)) b)
    (seq 0 (length bases))

(** val system_ok : layout -> system -> bool **)

let system_ok l y =
  let bases = concat l.groups in
  (&&)
    ((&&)
      ((&&) ((&&) (forallb narrow l.groups) (fits bases y.start))
        (asking y.whole)) (bounded l y.whole)) (edges_bounded l y)

(** val packed : layout -> system -> Uint63.t list lts **)

let packed l y =
  let bases = concat l.groups in
  let prepared =
    prepare y l.event_count (fun k -> nth k bases (Uint63.of_int (0))) y.whole
  in
  let gs = l.groups in
  { init = (pack gs y.start); succ0 = (fun c ->
  let s = unpack gs c in
  map (fun m -> ((fst m), (pack gs (apply s (snd m)))))
    (fast_moves s prepared)) }

(** val certify_refinement :
    model -> layout -> system -> layout -> system -> normal_form -> Uint63.t
    list evidence -> Uint63.t list pairs -> bool **)

let certify_refinement m ls spec li impl n e p =
  (&&) ((&&) (system_ok ls spec) (system_ok li impl))
    (check (packed ls spec) (packed li impl) eq_words eq_words m n e p)

(** val certify_property :
    property -> layout -> system -> Uint63.t list pairs -> bool **)

let certify_property p li impl p0 =
  (&&) (system_ok li impl) (check_property (packed li impl) eq_words p p0)
