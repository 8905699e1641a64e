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

(** val nth_error : 'a1 list -> int -> 'a1 option **)

let rec nth_error l n =
  (fun fO fS n -> if n=0 then fO () else fS (n-1))
    (fun _ -> match l with
              | [] -> None
              | x :: _ -> Some x)
    (fun n0 -> match l with
               | [] -> None
               | _ :: l0 -> nth_error l0 n0)
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

(** val find : ('a1 -> bool) -> 'a1 list -> 'a1 option **)

let rec find f = function
| [] -> None
| x :: tl0 -> if f x then Some x else find f tl0

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

(** val repeat : 'a1 -> int -> 'a1 list **)

let rec repeat x n =
  (fun fO fS n -> if n=0 then fO () else fS (n-1))
    (fun _ -> [])
    (fun k -> x :: (repeat x k))
    n

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

  (** val pred_double : z -> z **)

  let pred_double = function
  | Z0 -> Zneg XH
  | Zpos p -> Zpos (Pos.pred_double p)
  | Zneg p -> Zneg (XI p)

  (** val pos_sub : positive -> positive -> z **)

  let rec pos_sub x y =
    match x with
    | XI p ->
      (match y with
       | XI q -> double (pos_sub p q)
       | XO q -> succ_double (pos_sub p q)
       | XH -> Zpos (XO p))
    | XO p ->
      (match y with
       | XI q -> pred_double (pos_sub p q)
       | XO q -> double (pos_sub p q)
       | XH -> Zpos (Pos.pred_double p))
    | XH ->
      (match y with
       | XI q -> Zneg (XO q)
       | XO q -> Zneg (Pos.pred_double q)
       | XH -> Z0)

  (** val add : z -> z -> z **)

  let add x y =
    match x with
    | Z0 -> y
    | Zpos x' ->
      (match y with
       | Z0 -> x
       | Zpos y' -> Zpos (Pos.add x' y')
       | Zneg y' -> pos_sub x' y')
    | Zneg x' ->
      (match y with
       | Z0 -> x
       | Zpos y' -> pos_sub y' x'
       | Zneg y' -> Zneg (Pos.add x' y'))

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

  (** val leb : z -> z -> bool **)

  let leb x y =
    match compare x y with
    | Gt -> false
    | _ -> true

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

(** val lor0 : Uint63.t -> Uint63.t -> Uint63.t **)

let lor0 = Uint63.l_or

(** val add0 : Uint63.t -> Uint63.t -> Uint63.t **)

let add0 = Uint63.add

(** val sub : Uint63.t -> Uint63.t -> Uint63.t **)

let sub = Uint63.sub

(** val eqb : Uint63.t -> Uint63.t -> bool **)

let eqb = Uint63.equal

(** val ltb0 : Uint63.t -> Uint63.t -> bool **)

let ltb0 = Uint63.lt

(** val leb0 : Uint63.t -> Uint63.t -> bool **)

let leb0 = Uint63.le

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

(** val opp : Uint63.t -> Uint63.t **)

let opp i =
  sub (Uint63.of_int (0)) i

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

(** val of_pos_rec : int -> positive -> Uint63.t **)

let rec of_pos_rec n p =
  (fun fO fS n -> if n=0 then fO () else fS (n-1))
    (fun _ -> (Uint63.of_int (0)))
    (fun n0 ->
    match p with
    | XI p0 ->
      lor0 (lsl0 (of_pos_rec n0 p0) (Uint63.of_int (1))) (Uint63.of_int (1))
    | XO p0 -> lsl0 (of_pos_rec n0 p0) (Uint63.of_int (1))
    | XH -> (Uint63.of_int (1)))
    n

(** val of_pos : positive -> Uint63.t **)

let of_pos =
  of_pos_rec size

(** val of_Z : z -> Uint63.t **)

let of_Z = function
| Z0 -> (Uint63.of_int (0))
| Zpos p -> of_pos p
| Zneg p -> opp (of_pos p)

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

(** val nonempty : 'a1 list -> bool **)

let nonempty = function
| [] -> false
| _ :: _ -> true

(** val before : rule -> Uint63.t -> bool **)

let before q l =
  match q.level with
  | Some k -> ltb0 k l
  | None -> false

(** val all_from :
    Uint63.t list -> (Uint63.t -> bool) -> Uint63.t -> Uint63.t -> bool **)

let rec all_from widths chk len lo =
  if leb0 len lo
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
  if leb0 n Parray.max_length
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

let derived spec eqs e seed source1 k =
  all_below (fun j ->
    let o = source1 j in
    if o.by_event
    then seed o.from (e.member k j)
    else if ltb0 o.from (e.size0 k)
         then if ltb0 (source1 o.from).depth o.depth
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

type action =
| Open of Uint63.t
| Visit
| Stop

type 's pairs = { state_of : (Uint63.t -> 's);
                  node_of : (Uint63.t -> Uint63.t);
                  place_of : (Uint63.t -> Uint63.t);
                  pair_at : (Uint63.t -> Uint63.t);
                  locate : ('s -> Uint63.t -> Uint63.t);
                  choose : (Uint63.t -> (ev * 's) list -> Uint63.t);
                  deed : (Uint63.t -> (Uint63.t * (ev * 's) list) list ->
                         action) }

type need =
| Forbidden
| Irrelevant
| Leads of Uint63.t * bool

(** val cover :
    ('a1 -> 'a1 -> bool) -> 'a1 pairs -> 'a1 -> Uint63.t -> Uint63.t option
    -> Uint63.t -> Uint63.t option **)

let cover eqi p u k bound high0 =
  let j = p.locate u k in
  if eqb (p.node_of j) k
  then if eqi (p.state_of j) u
       then if match bound with
               | Some b -> ltb0 (p.place_of j) b
               | None -> true
            then if ltb0 j high0
                 then Some high0
                 else if ltb0 j (add0 j (Uint63.of_int (1)))
                      then Some (add0 j (Uint63.of_int (1)))
                      else None
            else None
       else None
  else None

(** val check_moves :
    ('a1 -> 'a1 -> bool) -> 'a1 pairs -> (Uint63.t -> ev -> need) -> Uint63.t
    -> Uint63.t -> (ev * 'a1) list -> Uint63.t -> Uint63.t option **)

let rec check_moves eqi p needs n p0 moves high0 =
  match moves with
  | [] -> Some high0
  | p1 :: rest ->
    let (a, u) = p1 in
    (match needs n a with
     | Forbidden -> None
     | Irrelevant -> check_moves eqi p needs n p0 rest high0
     | Leads (k, earlier) ->
       (match cover eqi p u k (if earlier then Some p0 else None) high0 with
        | Some h -> check_moves eqi p needs n p0 rest h
        | None -> None))

(** val check_pair :
    ('a1 -> 'a1 -> bool) -> 'a1 pairs -> (Uint63.t -> ev -> need) ->
    (Uint63.t -> (ev * 'a1) list -> bool) -> Uint63.t -> Uint63.t ->
    (ev * 'a1) list -> Uint63.t -> Uint63.t option **)

let check_pair eqi p needs fine j p0 moves high0 =
  if eqb (p.place_of j) p0
  then if eqb (p.pair_at p0) j
       then if fine (p.node_of j) moves
            then check_moves eqi p needs (p.node_of j) p0 moves high0
            else None
       else None
  else None

type 's progress = { time : Uint63.t;
                     opened : (Uint63.t * (ev * 's) list) list;
                     visited : Uint63.t; high : Uint63.t }

type 's outcome =
| More of 's progress
| Over of 's progress option

(** val proceed :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 pairs -> (Uint63.t -> ev -> need)
    -> (Uint63.t -> (ev * 'a1) list -> bool) -> 'a1 progress -> 'a1 outcome **)

let proceed impl eqi p needs fine x =
  match p.deed x.time x.opened with
  | Open j ->
    More { time = (add0 x.time (Uint63.of_int (1))); opened = ((j,
      (impl.succ0 (p.state_of j))) :: x.opened); visited = x.visited; high =
      x.high }
  | Visit ->
    (match x.opened with
     | [] -> Over None
     | p0 :: rest ->
       let (j, moves) = p0 in
       (match check_pair eqi p needs fine j x.visited moves x.high with
        | Some h ->
          if ltb0 x.visited (add0 x.visited (Uint63.of_int (1)))
          then More { time = (add0 x.time (Uint63.of_int (1))); opened =
                 rest; visited = (add0 x.visited (Uint63.of_int (1))); high =
                 h }
          else Over None
        | None -> Over None))
  | Stop -> Over (Some x)

(** val proceed_often :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 pairs -> (Uint63.t -> ev -> need)
    -> (Uint63.t -> (ev * 'a1) list -> bool) -> Uint63.t list -> 'a1 progress
    -> 'a1 outcome **)

let rec proceed_often impl eqi p needs fine fuel x =
  match fuel with
  | [] -> proceed impl eqi p needs fine x
  | _ :: rest ->
    (match proceed_often impl eqi p needs fine rest x with
     | More y -> proceed_often impl eqi p needs fine rest y
     | Over r -> Over r)

(** val all_visited : 'a1 pairs -> 'a1 progress -> bool **)

let all_visited p x =
  all_below (fun j ->
    if ltb0 (p.place_of j) x.visited
    then eqb (p.pair_at (p.place_of j)) j
    else false) x.high

(** val walk :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 pairs -> (Uint63.t -> ev -> need)
    -> (Uint63.t -> (ev * 'a1) list -> bool) -> Uint63.t -> bool **)

let walk impl eqi p needs fine first_node =
  match cover eqi p impl.init first_node None (Uint63.of_int (0)) with
  | Some h ->
    (match proceed_often impl eqi p needs fine many_widths { time =
             (Uint63.of_int (0)); opened = []; visited = (Uint63.of_int (0));
             high = h } with
     | More _ -> false
     | Over x0 -> (match x0 with
                   | Some x -> all_visited p x
                   | None -> false))
  | None -> false

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

(** val refusals :
    normal_form -> model -> 'a1 pairs -> Uint63.t -> (ev * 'a1) list -> bool **)

let refusals n m p n0 moves =
  match m with
  | T -> true
  | _ -> refusals_ok n p n0 moves

(** val event_needs : normal_form -> model -> Uint63.t -> ev -> need **)

let event_needs n m n0 a =
  if eqb a tau
  then Leads (n0, (ranked m))
  else (match after n n0 a with
        | Some k -> if stop n m k then Irrelevant else Leads (k, false)
        | None -> Forbidden)

(** val check_implementation :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> normal_form -> model -> 'a1 pairs ->
    bool **)

let check_implementation impl eqi n m p =
  if stop n m n.root
  then true
  else walk impl eqi p (event_needs n m) (refusals n m p) n.root

(** val no_deadlock : property -> bool **)

let no_deadlock = function
| Divergence_free -> false
| _ -> true

(** val no_divergence : property -> bool **)

let no_divergence = function
| Deadlock_free -> false
| _ -> true

(** val enabled : property -> Uint63.t -> (ev * 'a1) list -> bool **)

let enabled p _ moves =
  if no_deadlock p
  then (match moves with
        | [] -> false
        | _ :: _ -> true)
  else true

(** val any_event : property -> Uint63.t -> ev -> need **)

let any_event p _ a =
  Leads ((Uint63.of_int (0)), (if no_divergence p then eqb a tau else false))

(** val check_property :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> property -> 'a1 pairs -> bool **)

let check_property impl eqi p p0 =
  walk impl eqi p0 (any_event p) (enabled p) (Uint63.of_int (0))

(** val no_repetition : int list -> bool **)

let rec no_repetition = function
| [] -> true
| x :: l0 -> (&&) (negb (existsb ((=) x) l0)) (no_repetition l0)

(** val set_all : (int -> Uint63.t -> 'a1) -> change list -> 'a1 list **)

let set_all set_local ch =
  map (fun c -> set_local (fst c) (snd c)) ch

type 'packed_change fmove = ev * 'packed_change list

type ('packed_state, 'packed_change) ask =
| AskSlot of ('packed_state -> Uint63.t)
   * (Uint63.t -> 'packed_change list list)
| AskInner of int * ev

type ('packed_state, 'packed_change) frule = { f_does : ev;
                                               f_level : Uint63.t option;
                                               f_asks : ('packed_state,
                                                        'packed_change) ask
                                                        list;
                                               f_puts : 'packed_change list }

type ('packed_state, 'packed_change) lead =
  ('packed_state, 'packed_change) frule * 'packed_change list

type ('packed_state, 'packed_change) fregion =
| FRegion of bool * ('packed_state, 'packed_change) fparticipant list
and ('packed_state, 'packed_change) fparticipant =
| FSlot of ('packed_state -> Uint63.t)
   * (Uint63.t -> ('packed_state, 'packed_change) lead list)
| FInner of int * ('packed_state, 'packed_change) fregion
   * (ev -> ('packed_state, 'packed_change) frule list)

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

(** val slot_ways :
    system -> (int -> Uint63.t -> 'a1) -> int -> ev -> Uint63.t -> 'a1 list
    list **)

let slot_ways y set_local k e v =
  flat_map (fun x ->
    if eqb (fst x) e then ((set_local k (snd x)) :: []) :: [] else [])
    (y.edges k v)

(** val asked : Uint63.t -> int -> rule list -> bool array **)

let asked events i rules =
  fold_left (fun t r ->
    fold_left (fun t0 a ->
      if (=) (fst a) i then Parray.set t0 (snd a) true else t0) (tl r.asks) t)
    rules (Parray.make events false)

(** val asker :
    system -> Uint63.t -> (int -> Uint63.t) -> (int -> 'a1 -> Uint63.t) ->
    (int -> Uint63.t -> 'a2) -> rule list -> int -> participant -> ev ->
    ('a1, 'a2) ask **)

let asker y events local_states local set_local rules i = function
| Slot k ->
  let wanted = asked events i rules in
  let ways0 =
    table events (fun e ->
      if Parray.get wanted e
      then table (local_states k) (slot_ways y set_local k e)
      else slot_ways y set_local k e)
  in
  let get = local k in (fun e -> AskSlot (get, (ways0 e)))
| Inner _ -> (fun x -> AskInner (i, x))

(** val number : (int -> 'a1 -> 'a2) -> int -> 'a1 list -> 'a2 list **)

let rec number g n = function
| [] -> []
| x :: l' -> (g n x) :: (number g (Stdlib.Int.succ n) l')

(** val ask_of :
    (ev -> ('a1, 'a2) ask) list -> (int * ev) -> ('a1, 'a2) ask **)

let ask_of askers a =
  match nth_error askers (fst a) with
  | Some f -> f (snd a)
  | None -> AskInner ((fst a), (snd a))

(** val frule_of :
    (int -> Uint63.t -> 'a2) -> (ev -> ('a1, 'a2) ask) list -> rule -> ('a1,
    'a2) frule **)

let frule_of set_local askers r =
  { f_does = r.does; f_level = r.level; f_asks =
    (map (ask_of askers) (tl r.asks)); f_puts = (set_all set_local r.puts) }

(** val rules_of :
    Uint63.t -> int -> (rule * ('a1, 'a2) frule) list -> ev -> ('a1, 'a2)
    frule list **)

let rules_of events i rules =
  let mine = filter (fun r -> led_by i (fst r)) rules in
  table events (fun e -> map snd (filter (fun r -> begins e (fst r)) mine))

(** val slot_leads :
    system -> (int -> Uint63.t -> 'a2) -> (ev -> ('a1, 'a2) frule list) ->
    int -> Uint63.t -> ('a1, 'a2) lead list **)

let slot_leads y set_local find0 k v =
  flat_map (fun x ->
    map (fun r -> (r, ((set_local k (snd x)) :: []))) (find0 (fst x)))
    (y.edges k v)

(** val has_level : rule -> bool **)

let has_level r =
  match r.level with
  | Some _ -> true
  | None -> false

(** val prepare :
    system -> Uint63.t -> (int -> Uint63.t) -> (int -> 'a1 -> Uint63.t) ->
    (int -> Uint63.t -> 'a2) -> region -> ('a1, 'a2) fregion **)

let rec prepare y events local_states local set_local = function
| Region (inside0, rules) ->
  let askers =
    number (asker y events local_states local set_local rules) 0 inside0
  in
  let both = map (fun r0 -> (r0, (frule_of set_local askers r0))) rules in
  FRegion ((existsb has_level rules),
  (number (fun i g -> g i) 0
    (map (fun p i ->
      let find0 = rules_of events i both in
      (match p with
       | Slot k ->
         FSlot ((local k),
           (table (local_states k) (slot_leads y set_local find0 k)))
       | Inner r' ->
         FInner (i, (prepare y events local_states local set_local r'), find0)))
      inside0)))

type 'packed_change inner_list = (int * 'packed_change fmove list) list

(** val inner_moves : int -> 'a1 inner_list -> 'a1 fmove list **)

let rec inner_moves i = function
| [] -> []
| p :: rest ->
  let (j, moves) = p in if (=) i j then moves else inner_moves i rest

(** val fulfil : 'a1 -> 'a2 inner_list -> ('a1, 'a2) ask -> 'a2 list list **)

let fulfil c l = function
| AskSlot (get, ways0) -> ways0 (get c)
| AskInner (i, e) ->
  flat_map (fun m -> if eqb (fst m) e then (snd m) :: [] else [])
    (inner_moves i l)

(** val others :
    'a1 -> 'a2 inner_list -> ('a1, 'a2) ask list -> 'a2 list list **)

let rec others c l = function
| [] -> [] :: []
| a :: rest ->
  (match fulfil c l a with
   | [] -> []
   | l0 :: l1 ->
     let ways0 = l0 :: l1 in
     (match rest with
      | [] -> ways0
      | _ :: _ -> flat_map (fun x -> map (app x) (others c l rest)) ways0))

(** val fold_leads :
    ('a3 -> ('a1, 'a2) lead -> 'a3) -> 'a1 -> 'a2 inner_list -> ('a1, 'a2)
    fparticipant -> 'a3 -> 'a3 **)

let fold_leads f c l p acc =
  match p with
  | FSlot (get, leads) -> fold_left f (leads (get c)) acc
  | FInner (i, _, find0) ->
    fold_left (fun acc0 m ->
      let (e, first) = m in
      fold_left (fun acc1 r -> f acc1 (r, first)) (find0 e) acc0)
      (inner_moves i l) acc

(** val extend : 'a1 list -> 'a1 list -> 'a1 list **)

let extend first way0 = match way0 with
| [] -> first
| _ :: _ -> app first way0

(** val add_moves :
    ('a1, 'a2) lead -> 'a2 list list -> 'a2 fmove list -> 'a2 fmove list **)

let add_moves q ways0 acc =
  let (r, first) = q in
  fold_left (fun acc0 way0 -> (r.f_does,
    (match r.f_puts with
     | [] -> extend first way0
     | p0 :: l -> app first (app way0 (p0 :: l)))) :: acc0) ways0 acc

(** val fire_all :
    'a1 -> 'a2 inner_list -> ('a1, 'a2) fparticipant list -> 'a2 fmove list **)

let fire_all c l inside0 =
  fold_left (fun acc p ->
    fold_leads (fun acc0 q -> add_moves q (others c l (fst q).f_asks) acc0) c
      l p acc) inside0 []

type ('packed_state, 'packed_change) candidate =
  ('packed_state, 'packed_change) lead * 'packed_change list list

(** val add_candidate :
    'a1 -> 'a2 inner_list -> ('a1, 'a2) lead -> ('a1, 'a2) candidate list ->
    ('a1, 'a2) candidate list **)

let add_candidate c l q acc =
  match others c l (fst q).f_asks with
  | [] -> acc
  | l0 :: l1 -> (q, (l0 :: l1)) :: acc

(** val candidates :
    'a1 -> 'a2 inner_list -> ('a1, 'a2) fparticipant list -> ('a1, 'a2)
    candidate list **)

let candidates c l inside0 =
  fold_left (fun acc p ->
    fold_leads (fun acc0 q -> add_candidate c l q acc0) c l p acc) inside0 []

(** val lesser :
    Uint63.t option -> ('a1, 'a2) candidate -> Uint63.t option **)

let lesser b c =
  match (fst (fst c)).f_level with
  | Some l ->
    (match b with
     | Some k -> if ltb0 l k then Some l else b
     | None -> Some l)
  | None -> b

(** val least : ('a1, 'a2) candidate list -> Uint63.t option **)

let least cs =
  fold_left lesser cs None

(** val ready : Uint63.t option -> ('a1, 'a2) frule -> bool **)

let ready b r =
  match r.f_level with
  | Some l -> (match b with
               | Some k -> negb (ltb0 k l)
               | None -> true)
  | None -> true

(** val fire_ready : ('a1, 'a2) candidate list -> 'a2 fmove list **)

let fire_ready cs =
  let b = least cs in
  fold_left (fun acc c ->
    if ready b (fst (fst c)) then add_moves (fst c) (snd c) acc else acc) cs
    []

(** val fast_moves : 'a1 -> ('a1, 'a2) fregion -> 'a2 fmove list **)

let rec fast_moves c = function
| FRegion (prioritised, inside0) ->
  let l =
    flat_map (fun p ->
      match p with
      | FSlot (_, _) -> []
      | FInner (i, r', _) -> (i, (fast_moves c r')) :: []) inside0
  in
  if prioritised
  then fire_ready (candidates c l inside0)
  else fire_all c l inside0

(** val asking : region -> bool **)

let rec asking = function
| Region (inside0, rules) ->
  (&&) (forallb (fun r0 -> nonempty r0.asks) rules)
    (forallb (fun p -> match p with
                       | Slot _ -> true
                       | Inner r' -> asking r') inside0)

(** val encode : Uint63.t list -> Uint63.t list -> Uint63.t **)

let rec encode bs s =
  match bs with
  | [] -> (Uint63.of_int (0))
  | b :: bs' ->
    (match s with
     | [] -> (Uint63.of_int (0))
     | v :: s' -> add0 v (lsl0 (encode bs' s') b))

(** val fits : Uint63.t list -> Uint63.t list -> bool **)

let rec fits bs s =
  match bs with
  | [] -> (match s with
           | [] -> true
           | _ :: _ -> false)
  | b :: bs' ->
    (match s with
     | [] -> false
     | v :: s' -> (&&) (ltb0 v (lsl0 (Uint63.of_int (1)) b)) (fits bs' s'))

(** val total : Uint63.t list -> z **)

let rec total = function
| [] -> Z0
| b :: bs' -> Z.add (to_Z b) (total bs')

(** val narrow : Uint63.t list -> bool **)

let narrow g =
  Z.leb (total g) (Zpos (XO (XI (XI (XI (XI XH))))))

(** val pack : Uint63.t list list -> Uint63.t list -> Uint63.t list **)

let rec pack gs s =
  match gs with
  | [] -> []
  | g :: gs' ->
    (encode g s) :: (match gs' with
                     | [] -> []
                     | _ :: _ -> pack gs' (skipn (length g) s))

type field = { word : int; shift : Uint63.t; mask : Uint63.t }

(** val fields_of : int -> Uint63.t -> Uint63.t list -> field list **)

let rec fields_of w from0 = function
| [] -> []
| b :: bs' ->
  { word = w; shift = from0; mask =
    (sub (lsl0 (Uint63.of_int (1)) b) (Uint63.of_int (1))) } :: (fields_of w
                                                                  (add0 from0
                                                                    b) bs')

(** val fields : int -> Uint63.t list list -> field list **)

let rec fields w = function
| [] -> []
| g :: gs' ->
  app (fields_of w (Uint63.of_int (0)) g) (fields (Stdlib.Int.succ w) gs')

(** val cut : field -> Uint63.t -> Uint63.t **)

let cut f w =
  land0 (lsr0 w f.shift) f.mask

(** val changed : field -> Uint63.t -> Uint63.t -> Uint63.t **)

let changed f x w =
  add0 w (lsl0 (sub x (cut f w)) f.shift)

(** val replace_word :
    Uint63.t list -> int -> (Uint63.t -> Uint63.t) -> Uint63.t list **)

let rec replace_word c n g =
  match c with
  | [] -> []
  | w :: c' ->
    ((fun fO fS n -> if n=0 then fO () else fS (n-1))
       (fun _ -> (g w) :: c')
       (fun n' -> w :: (replace_word c' n' g))
       n)

(** val read_field : field -> Uint63.t list -> Uint63.t **)

let read_field f c =
  (fun fO fS n -> if n=0 then fO () else fS (n-1))
    (fun _ ->
    match c with
    | [] -> cut f (Uint63.of_int (0))
    | w :: _ -> cut f w)
    (fun n0 -> cut f (nth (Stdlib.Int.succ n0) c (Uint63.of_int (0))))
    f.word

(** val write_field : Uint63.t list -> (field * Uint63.t) -> Uint63.t list **)

let write_field c = function
| (f, x) ->
  ((fun fO fS n -> if n=0 then fO () else fS (n-1))
     (fun _ ->
     match c with
     | [] -> replace_word c 0 (changed f x)
     | w :: c' -> (changed f x w) :: c')
     (fun n0 -> replace_word c (Stdlib.Int.succ n0) (changed f x))
     f.word)

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

(** val size_of : layout -> int -> Uint63.t **)

let size_of l =
  let bits = concat l.groups in
  (fun k ->
  match nth_error bits k with
  | Some b -> lsl0 (Uint63.of_int (1)) b
  | None -> (Uint63.of_int (0)))

(** val inside_bounds : layout -> change -> bool **)

let inside_bounds l c =
  ltb0 (snd c) (size_of l (fst c))

(** val bounded : layout -> region -> bool **)

let bounded l =
  let bits = concat l.groups in
  let rec bounded0 = function
  | Region (inside0, rules) ->
    (&&) (forallb (fun r0 -> forallb (inside_bounds l) r0.puts) rules)
      (forallb (fun p ->
        match p with
        | Slot k -> Nat.ltb k (length bits)
        | Inner r' -> bounded0 r') inside0)
  in bounded0

(** val edges_bounded : layout -> system -> bool **)

let edges_bounded l y =
  let bits = concat l.groups in
  forallb (fun k ->
    let b = size_of l k in
    all_below (fun v -> forallb (fun e -> ltb0 (snd e) b) (y.edges k v)) b)
    (seq 0 (length bits))

(** val system_ok : layout -> system -> bool **)

let system_ok l y =
  let bits = concat l.groups in
  (&&)
    ((&&)
      ((&&) ((&&) (forallb narrow l.groups) (fits bits y.start))
        (asking y.whole)) (bounded l y.whole)) (edges_bounded l y)

(** val no_field : field **)

let no_field =
  { word = 0; shift = (Uint63.of_int (0)); mask = (Uint63.of_int (0)) }

(** val read_local : layout -> int -> Uint63.t list -> Uint63.t **)

let read_local l =
  let all_fields = fields 0 l.groups in
  (fun k ->
  match nth_error all_fields k with
  | Some f -> read_field f
  | None -> (fun _ -> (Uint63.of_int (0))))

(** val write_local : layout -> int -> Uint63.t -> field * Uint63.t **)

let write_local l =
  let all_fields = fields 0 l.groups in
  (fun k x ->
  ((match nth_error all_fields k with
    | Some f -> f
    | None -> no_field), x))

(** val prepared :
    layout -> system -> (Uint63.t list, field * Uint63.t) fregion **)

let prepared l y =
  prepare y l.event_count (size_of l) (read_local l) (write_local l) y.whole

(** val packed : layout -> system -> Uint63.t list lts **)

let packed l y =
  let region0 = prepared l y in
  { init = (pack l.groups y.start); succ0 = (fun c ->
  map (fun m -> ((fst m), (fold_left write_field (snd m) c)))
    (fast_moves c region0)) }

type merging = { merged_states : (int -> Uint63.t);
                 representative : (int -> Uint63.t -> Uint63.t) }

(** val merge : merging -> int -> Uint63.t -> Uint63.t **)

let merge m k v =
  if ltb0 v (m.merged_states k) then m.representative k v else v

(** val merge_edges :
    merging -> int -> (ev * Uint63.t) list -> (ev * Uint63.t) list **)

let merge_edges m k l =
  map (fun e -> ((fst e), (merge m k (snd e)))) l

(** val merge_changes : merging -> change list -> change list **)

let merge_changes m l =
  map (fun c -> ((fst c), (merge m (fst c) (snd c)))) l

(** val merge_state : merging -> int -> Uint63.t list -> Uint63.t list **)

let rec merge_state m k = function
| [] -> []
| v :: s' -> (merge m k v) :: (merge_state m (Stdlib.Int.succ k) s')

(** val merge_rule : merging -> rule -> rule **)

let merge_rule m r =
  { does = r.does; level = r.level; asks = r.asks; puts =
    (merge_changes m r.puts) }

(** val merge_region : merging -> region -> region **)

let rec merge_region m = function
| Region (inside0, rules) ->
  Region
    ((map (fun p ->
       match p with
       | Slot k -> Slot k
       | Inner r' -> Inner (merge_region m r')) inside0),
    (map (merge_rule m) rules))

(** val merged : merging -> system -> system **)

let merged m y =
  { edges = (fun k v -> merge_edges m k (y.edges k v)); start =
    (merge_state m 0 y.start); whole = (merge_region m y.whole) }

(** val has_edge : (ev * Uint63.t) list -> (ev * Uint63.t) -> bool **)

let has_edge l e =
  existsb (fun d ->
    if eqb (fst d) (fst e) then eqb (snd d) (snd e) else false) l

(** val equal_edges : (ev * Uint63.t) list -> (ev * Uint63.t) list -> bool **)

let equal_edges l k =
  if forallb (has_edge k) l then forallb (has_edge l) k else false

(** val slots_below : int -> region -> bool **)

let rec slots_below n = function
| Region (inside0, _) ->
  forallb (fun p ->
    match p with
    | Slot k -> Nat.ltb k n
    | Inner r' -> slots_below n r') inside0

(** val merging_ok : merging -> system -> bool **)

let merging_ok m y =
  (&&) (slots_below (length y.start) y.whole)
    (forallb (fun k ->
      all_below (fun v ->
        let w = merge m k v in
        if eqb w v
        then true
        else equal_edges (merge_edges m k (y.edges k v))
               (merge_edges m k (y.edges k w))) (m.merged_states k))
      (seq 0 (length y.start)))

type item =
| Performs of int * ev
| Sets of int * Uint63.t

(** val item_slot : item -> int **)

let item_slot = function
| Performs (k, _) -> k
| Sets (k, _) -> k

type passage = { place : int list; inside : participant list;
                 rivals : rule list; own : rule; around : int list;
                 prior : bool }

type whole_rule = { performed : ev; items : item list; passages : passage list }

type way = item list * passage list

(** val slots_of : region -> int list **)

let rec slots_of = function
| Region (inside0, _) ->
  flat_map (fun p ->
    match p with
    | Slot k -> k :: []
    | Inner r' -> slots_of r') inside0

(** val can_be_prevented : rule list -> rule -> bool **)

let can_be_prevented rules q =
  match q.level with
  | Some l -> existsb (fun o -> before o l) rules
  | None -> false

type source =
| Of_slot of int
| Of_region of whole_rule list

(** val ways : source -> ev -> way list **)

let ways src e =
  match src with
  | Of_slot k -> (((Performs (k, e)) :: []), []) :: []
  | Of_region rules ->
    flat_map (fun w ->
      if eqb w.performed e then (w.items, w.passages) :: [] else []) rules

(** val pick : source list -> (int * ev) list -> way list **)

let rec pick sources = function
| [] -> ([], []) :: []
| p :: rest ->
  let (i, e) = p in
  let later = pick sources rest in
  flat_map (fun a ->
    map (fun b -> ((app (fst a) (fst b)), (app (snd a) (snd b)))) later)
    (ways (nth i sources (Of_region [])) e)

(** val put_items : change list -> item list **)

let put_items l =
  map (fun c -> Sets ((fst c), (snd c))) l

(** val whole_of :
    int list -> participant list -> rule list -> int list -> source list ->
    rule -> whole_rule list **)

let whole_of at_ parts rules slots0 sources q =
  let passed = { place = at_; inside = parts; rivals = rules; own = q;
    around = slots0; prior = (can_be_prevented rules q) }
  in
  let sets = put_items q.puts in
  map (fun w -> { performed = q.does; items = (app (fst w) sets); passages =
    (passed :: (snd w)) }) (pick sources q.asks)

(** val whole_rules : region -> int list -> whole_rule list **)

let rec whole_rules r at_ =
  let Region (parts, rules) = r in
  let sources =
    number (fun i g -> g i) 0
      (map (fun p x ->
        match p with
        | Slot k -> Of_slot k
        | Inner r' -> Of_region (whole_rules r' (x :: at_))) parts)
  in
  let slots0 = slots_of r in
  flat_map (whole_of at_ parts rules slots0 sources) rules

type cube = (int * Uint63.t) list

(** val local_in : cube -> int -> Uint63.t option **)

let rec local_in c k =
  match c with
  | [] -> None
  | p :: c' -> let (j, v) = p in if (=) j k then Some v else local_in c' k

(** val put_in : cube -> int -> Uint63.t -> cube **)

let rec put_in c k x =
  match c with
  | [] -> []
  | p :: c' ->
    let (j, v) = p in (j, (if (=) j k then x else v)) :: (put_in c' k x)

type confluent_steps = { entries : Uint63.t;
                         follows : (Uint63.t -> Uint63.t);
                         states_of : (Uint63.t -> cube);
                         entry_after : (Uint63.t -> cube -> Uint63.t);
                         hint : (Uint63.t list -> Uint63.t list) }

(** val same_item : item -> item -> bool **)

let same_item x y =
  match x with
  | Performs (k, e) ->
    (match y with
     | Performs (j, d) -> if (=) k j then eqb e d else false
     | Sets (_, _) -> false)
  | Sets (k, v) ->
    (match y with
     | Performs (_, _) -> false
     | Sets (j, w) -> if (=) k j then eqb v w else false)

(** val same_items : item list -> item list -> bool **)

let rec same_items l m =
  match l with
  | [] -> (match m with
           | [] -> true
           | _ :: _ -> false)
  | x :: l' ->
    (match m with
     | [] -> false
     | y :: m' -> if same_item x y then same_items l' m' else false)

(** val same_path : int list -> int list -> bool **)

let rec same_path p q =
  match p with
  | [] -> (match q with
           | [] -> true
           | _ :: _ -> false)
  | i :: p' ->
    (match q with
     | [] -> false
     | j :: q' -> if (=) i j then same_path p' q' else false)

(** val load : 'a1 list -> Uint63.t -> 'a1 array -> 'a1 array **)

let rec load l i t =
  match l with
  | [] -> t
  | x :: l' -> load l' (add0 i (Uint63.of_int (1))) (Parray.set t i x)

(** val element : 'a1 list -> Uint63.t -> 'a1 option **)

let element l = match l with
| [] -> (fun _ -> None)
| x :: _ ->
  let count = of_Z (Z.of_nat (length l)) in
  if leb0 count Parray.max_length
  then if Z.ltb (Z.of_nat (length l))
            (Z.pow (Zpos (XO XH)) (Zpos (XO (XO (XI (XI (XI XH)))))))
       then let t = load l (Uint63.of_int (0)) (Parray.make count x) in
            (fun i -> if ltb0 i count then Some (Parray.get t i) else None)
       else (fun _ -> None)
  else (fun _ -> None)

(** val rules_of_whole : system -> whole_rule list **)

let rules_of_whole y =
  whole_rules y.whole []

(** val goal :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> int -> ev -> Uint63.t
    -> Uint63.t **)

let goal row_of k e v =
  match find (fun x -> eqb (fst x) e) (row_of k e v) with
  | Some x -> snd x
  | None -> v

(** val has_event :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> int -> ev -> Uint63.t
    -> bool **)

let has_event row_of k e v =
  existsb (fun x -> eqb (fst x) e) (row_of k e v)

(** val determined :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> int -> ev -> Uint63.t
    -> bool **)

let determined row_of k e v =
  if has_event row_of k e v
  then let g = goal row_of k e v in
       forallb (fun x -> if eqb (fst x) e then eqb (snd x) g else true)
         (row_of k e v)
  else false

(** val has_target :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> int -> ev -> Uint63.t
    -> Uint63.t -> bool **)

let has_target row_of k e v x =
  existsb (fun y -> if eqb (fst y) e then eqb (snd y) x else false)
    (row_of k e v)

(** val does_item :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> int -> Uint63.t ->
    item -> Uint63.t -> Uint63.t **)

let does_item row_of k v it x =
  match it with
  | Performs (j, e) -> if (=) j k then goal row_of k e v else x
  | Sets (j, y) -> if (=) j k then y else x

(** val effect :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> item list -> int ->
    Uint63.t -> Uint63.t **)

let effect row_of its k v =
  fold_left (fun x it -> does_item row_of k v it x) its v

(** val touches : item list -> int -> bool **)

let touches its k =
  existsb (fun it -> (=) (item_slot it) k) its

(** val change_of :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> (int -> Uint63.t) ->
    item -> change **)

let change_of row_of local = function
| Performs (k, e) -> (k, (goal row_of k e (local k)))
| Sets (k, x) -> (k, x)

(** val sure :
    system -> (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> cube -> item
    -> bool **)

let sure y row_of =
  let n = length y.start in
  (fun c it ->
  if Nat.ltb (item_slot it) n
  then (match it with
        | Performs (k, e) ->
          (match local_in c k with
           | Some v -> determined row_of k e v
           | None -> false)
        | Sets (_, _) -> true)
  else false)

(** val impossible :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> cube -> item -> bool **)

let impossible row_of c = function
| Performs (k, e) ->
  (match local_in c k with
   | Some v -> negb (has_event row_of k e v)
   | None -> false)
| Sets (_, _) -> false

(** val overrules : passage -> passage -> bool **)

let overrules g h =
  match g.own.level with
  | Some l ->
    (match h.own.level with
     | Some m -> if ltb0 l m then same_path g.place h.place else false
     | None -> false)
  | None -> false

(** val cannot_fire :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> whole_rule -> cube ->
    whole_rule -> bool **)

let cannot_fire row_of r c w =
  if existsb (impossible row_of c) w.items
  then true
  else existsb (fun h -> existsb (fun g -> overrules g h) r.passages)
         w.passages

(** val own_items : item list -> int -> item list **)

let own_items its k =
  filter (fun it -> (=) (item_slot it) k) its

(** val commutes :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> item list -> cube ->
    item -> bool **)

let commutes row_of r c it =
  let k = item_slot it in
  (match own_items r k with
   | [] -> true
   | i :: l ->
     (match i with
      | Performs (_, e) ->
        (match l with
         | [] ->
           (match it with
            | Performs (_, d) ->
              (match local_in c k with
               | Some v ->
                 let u = goal row_of k e v in
                 forallb (fun x ->
                   if eqb (fst x) d
                   then has_target row_of k d u (goal row_of k e (snd x))
                   else true) (row_of k d v)
               | None -> false)
            | Sets (_, _) -> false)
         | _ :: _ -> false)
      | Sets (_, _) -> false))

(** val leaves :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> item list -> cube ->
    int -> bool **)

let leaves row_of r c k =
  match local_in c k with
  | Some v -> eqb (effect row_of r k v) v
  | None -> false

(** val undisturbed :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> item list -> cube ->
    passage -> bool **)

let undisturbed row_of r c g =
  if g.prior
  then forallb (fun it ->
         let k = item_slot it in
         if existsb ((=) k) g.around then leaves row_of r c k else true) r
  else true

(** val outcomes :
    (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> cube -> item list ->
    cube -> cube list **)

let rec outcomes row_of c its d =
  match its with
  | [] -> d :: []
  | i :: rest ->
    (match i with
     | Performs (k, e) ->
       (match local_in c k with
        | Some v ->
          flat_map (fun x ->
            if eqb (fst x) e
            then outcomes row_of c rest (put_in d k (snd x))
            else []) (row_of k e v)
        | None -> outcomes row_of c rest d)
     | Sets (k, x) -> outcomes row_of c rest (put_in d k x))

(** val implies_cube : cube -> cube -> bool **)

let implies_cube c d =
  forallb (fun kv ->
    match local_in c (fst kv) with
    | Some v -> eqb v (snd kv)
    | None -> false) d

(** val continues : confluent_steps -> Uint63.t -> cube -> bool **)

let continues c j c0 =
  let i = c.entry_after j c0 in
  if ltb0 i c.entries
  then if eqb (c.follows i) (c.follows j)
       then implies_cube c0 (c.states_of i)
       else false
  else false

(** val spared :
    confluent_steps -> (int -> ev -> Uint63.t -> (ev * Uint63.t) list) ->
    Uint63.t -> whole_rule -> cube -> whole_rule -> bool **)

let spared c row_of j r c0 w =
  if cannot_fire row_of r c0 w
  then true
  else if if eqb w.performed r.performed
          then same_items w.items r.items
          else false
       then true
       else if forallb (commutes row_of r.items c0) w.items
            then if forallb (undisturbed row_of r.items c0) w.passages
                 then forallb (continues c j) (outcomes row_of c0 w.items c0)
                 else false
            else false

(** val touching : whole_rule list -> int -> whole_rule list **)

let touching rules k =
  filter (fun w -> touches w.items k) rules

(** val guarding : whole_rule list -> int -> whole_rule list **)

let guarding rules k =
  filter (fun w ->
    existsb (fun g -> if g.prior then existsb ((=) k) g.around else false)
      w.passages) rules

(** val by_slot :
    system -> (int -> whole_rule list) -> int -> whole_rule list **)

let by_slot y =
  let n = length y.start in
  (fun f ->
  let rows = map f (seq 0 n) in
  (fun k -> match nth_error rows k with
            | Some l -> l
            | None -> f k))

(** val entry_ok :
    system -> confluent_steps -> bool -> (int -> ev -> Uint63.t ->
    (ev * Uint63.t) list) -> (Uint63.t -> whole_rule option) -> (int ->
    whole_rule list) -> (int -> whole_rule list) -> Uint63.t -> bool **)

let entry_ok y c any row_of =
  let n = length y.start in
  (fun rule_at near around_of j ->
  match rule_at (c.follows j) with
  | Some r ->
    let c0 = c.states_of j in
    if if any then true else eqb r.performed tau
    then if forallb (fun g -> negb g.prior) r.passages
         then if forallb (sure y row_of c0) r.items
              then if forallb (fun kv ->
                        if Nat.ltb (fst kv) n
                        then forallb (spared c row_of j r c0) (near (fst kv))
                        else false) c0
                   then forallb (fun it ->
                          if forallb (spared c row_of j r c0)
                               (near (item_slot it))
                          then forallb (spared c row_of j r c0)
                                 (around_of (item_slot it))
                          else false) r.items
                   else false
              else false
         else false
    else false
  | None -> false)

(** val confluent_ok :
    system -> confluent_steps -> bool -> (int -> ev -> Uint63.t ->
    (ev * Uint63.t) list) -> bool **)

let confluent_ok y c any row_of =
  let rules = rules_of_whole y in
  let rule_at = element rules in
  let near = by_slot y (touching rules) in
  let around_of = by_slot y (guarding rules) in
  all_below (entry_ok y c any row_of rule_at near around_of) c.entries

(** val led : ('a1 -> 'a1) -> 'a1 lts -> 'a1 lts **)

let led lead0 p =
  { init = (lead0 p.init); succ0 = (fun s ->
    map (fun m -> ((fst m), (lead0 (snd m)))) (p.succ0 s)) }

(** val hidden : 'a1 lts -> 'a1 lts **)

let hidden p =
  { init = p.init; succ0 = (fun s ->
    map (fun m -> (tau, (snd m))) (p.succ0 s)) }

type pull = { source0 : int; send : (Uint63.t -> Uint63.t);
              rename : (ev -> ev); restore : (ev -> ev) }

type mapping = { new_place : (int -> int); new_name : (ev -> ev);
                 old_name : (ev -> ev); rule_to : (Uint63.t -> Uint63.t);
                 rule_from : (Uint63.t -> Uint63.t); deeper : (int -> mapping) }

type automorphism = { pulls : (int * pull) list; tree : mapping;
                      instead : (Uint63.t -> Uint63.t -> Uint63.t) }

(** val all_numbered :
    (Uint63.t -> 'a1 -> bool) -> Uint63.t -> 'a1 list -> bool **)

let rec all_numbered f i = function
| [] -> true
| x :: l' ->
  if f i x then all_numbered f (add0 i (Uint63.of_int (1))) l' else false

(** val all_true : bool list -> bool **)

let all_true l =
  forallb (fun b -> b) l

(** val stay : int -> pull **)

let stay k =
  { source0 = k; send = (fun v -> v); rename = (fun e -> e); restore =
    (fun e -> e) }

(** val pull_in : (int * pull) list -> int -> pull **)

let rec pull_in l j =
  match l with
  | [] -> stay j
  | p0 :: l' -> let (i, p) = p0 in if (=) i j then p else pull_in l' j

(** val sets_nothing : rule -> bool **)

let sets_nothing q =
  match q.puts with
  | [] -> true
  | _ :: _ -> false

(** val silent : region -> bool **)

let rec silent = function
| Region (parts, rules) ->
  (&&) (forallb sets_nothing rules)
    (forallb (fun p -> match p with
                       | Slot _ -> true
                       | Inner r' -> silent r') parts)

(** val plain : system -> bool **)

let plain y =
  (&&) (silent y.whole) (no_repetition (slots_of y.whole))

(** val pull_at : automorphism -> int -> pull **)

let pull_at g j =
  pull_in g.pulls j

(** val names_at :
    automorphism -> mapping -> participant list -> int -> (ev -> ev) * (ev ->
    ev) **)

let names_at g m to_ i =
  match nth_error to_ (m.new_place i) with
  | Some p ->
    (match p with
     | Slot j -> ((pull_at g j).rename, (pull_at g j).restore)
     | Inner _ -> ((m.deeper i).new_name, (m.deeper i).old_name))
  | None -> ((m.deeper i).new_name, (m.deeper i).old_name)

(** val name_at :
    automorphism -> mapping -> participant list -> int -> ev -> ev **)

let name_at g m to_ i =
  fst (names_at g m to_ i)

(** val old_name_at :
    automorphism -> mapping -> participant list -> int -> ev -> ev **)

let old_name_at g m to_ i =
  snd (names_at g m to_ i)

(** val image_of :
    automorphism -> mapping -> participant list -> (int * ev) -> int * ev **)

let image_of g m to_ a =
  ((m.new_place (fst a)), (name_at g m to_ (fst a) (snd a)))

(** val same_level : Uint63.t option -> Uint63.t option -> bool **)

let same_level k l =
  match k with
  | Some k0 -> (match l with
                | Some l0 -> eqb k0 l0
                | None -> false)
  | None -> (match l with
             | Some _ -> false
             | None -> true)

(** val corresponds :
    automorphism -> mapping -> participant list -> participant list -> rule
    -> rule -> bool **)

let corresponds g m parts to_ q q' =
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&) (same_level q.level q'.level)
              (eqb q'.does (m.new_name q.does)))
            (eqb q.does (m.old_name q'.does)))
          (no_repetition (map fst q'.asks)))
        ((<=) (length q.asks) (length q'.asks)))
      (forallb (fun a ->
        (&&) (Nat.ltb (fst a) (length parts))
          (eqb
            (old_name_at g m to_ (fst a) (name_at g m to_ (fst a) (snd a)))
            (snd a))) q.asks))
    (let images = map (image_of g m to_) q.asks in
     forallb (fun b ->
       existsb (fun c ->
         if (=) (fst c) (fst b) then eqb (snd c) (snd b) else false) images)
       q'.asks)

(** val rules_correspond :
    automorphism -> mapping -> participant list -> participant list -> rule
    list -> rule list -> bool **)

let rules_correspond g m parts to_ rules rules' =
  let rule_at = element rules in
  let rule_at' = element rules' in
  (&&)
    (all_numbered (fun i q ->
      match rule_at' (m.rule_to i) with
      | Some q' -> corresponds g m parts to_ q q'
      | None -> false) (Uint63.of_int (0)) rules)
    (all_numbered (fun i q' ->
      match rule_at (m.rule_from i) with
      | Some q -> corresponds g m parts to_ q q'
      | None -> false) (Uint63.of_int (0)) rules')

(** val maps :
    system -> automorphism -> region -> mapping -> region -> bool **)

let maps y g =
  let n = length y.start in
  let rec maps0 r m r' =
    let Region (parts, rules) = r in
    let Region (to_, rules') = r' in
    (&&)
      (all_true
        (number (fun i f -> f i) 0
          (map (fun p i ->
            match p with
            | Slot k ->
              (match nth_error to_ (m.new_place i) with
               | Some p0 ->
                 (match p0 with
                  | Slot j -> (&&) (Nat.ltb j n) ((=) (pull_at g j).source0 k)
                  | Inner _ -> false)
               | None -> false)
            | Inner q ->
              (match nth_error to_ (m.new_place i) with
               | Some p0 ->
                 (match p0 with
                  | Slot _ -> false
                  | Inner q' -> maps0 q (m.deeper i) q')
               | None -> false)) parts)))
      (rules_correspond g m parts to_ rules rules')
  in maps0

(** val rename_edges :
    pull -> (ev * Uint63.t) list -> (ev * Uint63.t) list **)

let rename_edges p l =
  map (fun x -> ((p.rename (fst x)), (p.send (snd x)))) l

(** val pull_ok :
    system -> (int -> Uint63.t) -> automorphism -> (int * pull) -> bool **)

let pull_ok y size_of0 g =
  let n = length y.start in
  (fun x ->
  let (j, p) = x in
  (&&)
    ((&&) ((&&) (Nat.ltb j n) (Nat.ltb p.source0 n))
      (existsb ((=) p.source0) (map fst g.pulls)))
    (all_below (fun v ->
      let w = p.send v in
      let l = y.edges p.source0 v in
      (&&)
        ((&&) (ltb0 w (size_of0 j))
          (forallb (fun e -> eqb (p.restore (p.rename (fst e))) (fst e)) l))
        (equal_edges (rename_edges p l) (y.edges j w))) (size_of0 p.source0)))

(** val same_test : ev -> ev -> ev -> bool **)

let same_test a b x =
  if eqb a x then eqb b x else negb (eqb b x)

(** val names_ok : automorphism -> rule -> bool **)

let names_ok g q =
  let a = q.does in
  let b = g.tree.new_name a in (&&) (same_test a b tau) (same_test a b tick)

(** val automorphism_ok :
    system -> (int -> Uint63.t) -> automorphism -> bool **)

let automorphism_ok y size_of0 g =
  (&&)
    ((&&)
      ((&&)
        ((&&) (no_repetition (map fst g.pulls))
          (no_repetition (map (fun x -> (snd x).source0) g.pulls)))
        (forallb (pull_ok y size_of0 g) g.pulls))
      (maps y g y.whole g.tree y.whole))
    (let Region (_, rules) = y.whole in forallb (names_ok g) rules)

(** val old_event : automorphism -> ev -> ev **)

let old_event g =
  g.tree.old_name

type reduction = { confluent : confluent_steps option;
                   symmetric : automorphism list;
                   turns : (Uint63.t list -> Uint63.t list) }

(** val last_bits : ev -> Uint63.t **)

let last_bits e =
  land0 e (Uint63.of_int (15))

(** val rows_by_event :
    layout -> system -> int -> ev -> Uint63.t -> (ev * Uint63.t) list **)

let rows_by_event l y =
  let tables =
    map (fun k ->
      table (size_of l k) (fun v ->
        let l0 = y.edges k v in
        if Z.ltb (Z.of_nat (length l0)) (Zpos (XO (XO (XO XH))))
        then (fun _ -> l0)
        else let t =
               table (Uint63.of_int (16)) (fun b ->
                 filter (fun x -> eqb (last_bits (fst x)) b) l0)
             in
             (fun e -> t (last_bits e)))) (seq 0 (length (concat l.groups)))
  in
  (fun k e v ->
  match nth_error tables k with
  | Some f -> f v e
  | None -> y.edges k v)

(** val cube_state : cube -> int -> Uint63.t **)

let cube_state c k =
  match local_in c k with
  | Some v -> v
  | None -> (Uint63.of_int (0))

(** val tests_of :
    layout -> cube -> ((Uint63.t list -> Uint63.t) * Uint63.t) list **)

let tests_of l c =
  map (fun kv -> ((read_local l (fst kv)), (snd kv))) c

(** val writes_of :
    layout -> (int -> ev -> Uint63.t -> (ev * Uint63.t) list) -> whole_rule
    option -> cube -> (field * Uint63.t) list **)

let writes_of l t r c =
  match r with
  | Some r0 ->
    set_all (write_local l) (map (change_of t (cube_state c)) r0.items)
  | None -> []

(** val passes :
    ((Uint63.t list -> Uint63.t) * Uint63.t) list -> Uint63.t list -> bool **)

let passes tests x =
  forallb (fun t -> eqb (fst t x) (snd t)) tests

(** val follow_on :
    layout -> system -> confluent_steps -> Uint63.t list -> Uint63.t list **)

let follow_on l y c =
  let t = rows_by_event l y in
  let rule_at = element (rules_of_whole y) in
  let rows =
    table c.entries (fun j -> ((tests_of l (c.states_of j)),
      (writes_of l t (rule_at (c.follows j)) (c.states_of j))))
  in
  (fun x ->
  fold_left (fun x0 j ->
    if ltb0 j c.entries
    then let row0 = rows j in
         if passes (fst row0) x0
         then fold_left write_field (snd row0) x0
         else x0
    else x0) (c.hint x) x)

(** val fields_of_pull :
    layout -> (int * pull) -> ((Uint63.t list -> Uint63.t) * (Uint63.t ->
    Uint63.t)) * field **)

let fields_of_pull l x =
  (((read_local l (snd x).source0), (snd x).send),
    (fst (write_local l (fst x) (Uint63.of_int (0)))))

(** val turned :
    (((Uint63.t list -> Uint63.t) * (Uint63.t -> Uint63.t)) * field) list ->
    Uint63.t list -> Uint63.t list **)

let turned l x =
  fold_left write_field
    (map (fun p -> ((snd p), (snd (fst p) (fst (fst p) x)))) l) x

(** val turn_on : layout -> reduction -> Uint63.t list -> Uint63.t list **)

let turn_on l r =
  let turn_at =
    element (map (fun g -> map (fields_of_pull l) g.pulls) r.symmetric)
  in
  (fun x ->
  fold_left (fun x0 i ->
    match turn_at i with
    | Some l0 -> turned l0 x0
    | None -> x0) (r.turns x) x)

(** val lead_on :
    layout -> system -> reduction -> Uint63.t list -> Uint63.t list **)

let lead_on l y r =
  let turn = turn_on l r in
  (match r.confluent with
   | Some c -> let follow = follow_on l y c in (fun x -> turn (follow x))
   | None -> turn)

(** val unreduced : layout -> system -> bool -> Uint63.t list lts **)

let unreduced l y = function
| true -> hidden (packed l y)
| false -> packed l y

(** val reduced :
    layout -> system -> reduction -> bool -> Uint63.t list lts **)

let reduced l y r any =
  let f = lead_on l y r in led f (unreduced l y any)

(** val reduction_holds : layout -> system -> reduction -> bool -> bool **)

let reduction_holds l y r any =
  (&&)
    (match r.confluent with
     | Some c -> confluent_ok y c any (rows_by_event l y)
     | None -> true)
    (match r.symmetric with
     | [] -> true
     | a :: l0 ->
       (&&) (plain y)
         (forallb (fun g -> automorphism_ok y (size_of l) g) (a :: l0)))

(** val among : ev list -> (ev -> ev) -> ev -> bool **)

let among a f a0 =
  existsb (fun b -> eqb (f b) a0) a

(** val indifferent_node : normal_form -> automorphism -> Uint63.t -> bool **)

let indifferent_node n g n0 =
  let f = old_event g in
  (&&)
    (all_below (fun i ->
      let (b, k) = n.arc n0 i in
      (match after n n0 (f b) with
       | Some j -> eqb j k
       | None -> false)) (n.arc_count n0))
    (all_below (fun i ->
      let j = g.instead n0 i in
      if ltb0 j (n.acceptance_count n0)
      then forallb (among (n.acceptance n0 i) f) (n.acceptance n0 j)
      else false) (n.acceptance_count n0))

(** val indifferent_to : normal_form -> automorphism -> bool **)

let indifferent_to n g =
  all_below (indifferent_node n g) n.nodes

(** val indifferent_ok : reduction -> normal_form -> bool **)

let indifferent_ok r n =
  forallb (indifferent_to n) r.symmetric

(** val only_deadlocks : property -> bool **)

let only_deadlocks = function
| Deadlock_free -> true
| _ -> false

type choiceless = { choiceless_size : Uint63.t; choiceless_start : Uint63.t;
                    choiceless_arcs : (Uint63.t -> (ev * Uint63.t) list);
                    choiceless_events : ev list }

(** val choiceless_system : choiceless -> system **)

let choiceless_system g =
  { edges = (fun _ v ->
    if ltb0 v g.choiceless_size then g.choiceless_arcs v else []); start =
    (g.choiceless_start :: []); whole = (Region (((Slot 0) :: []),
    (map (fun a -> { does = a; level = None; asks = ((0, a) :: []); puts =
      [] }) g.choiceless_events))) }

(** val ascending : ev -> (ev * Uint63.t) list -> bool **)

let rec ascending last = function
| [] -> true
| e :: rest ->
  if eqb last tick
  then false
  else if ltb0 last (fst e) then ascending (fst e) rest else false

(** val choiceless_ok : choiceless -> bool **)

let choiceless_ok g =
  all_below (fun v -> ascending tau (g.choiceless_arcs v)) g.choiceless_size

type 's numbering = { state_count : Uint63.t;
                      state_number : ('s -> Uint63.t);
                      numbered_state : (Uint63.t -> 's);
                      distance : (Uint63.t -> Uint63.t) }

(** val known_number :
    ('a1 -> 'a1 -> bool) -> 'a1 numbering -> 'a1 -> Uint63.t option **)

let known_number eqi h u =
  let j = h.state_number u in
  if ltb0 j h.state_count
  then if eqi (h.numbered_state j) u then Some j else None
  else None

(** val nearer :
    ('a1 -> 'a1 -> bool) -> ev list -> 'a1 numbering -> Uint63.t ->
    (ev * 'a1) list -> bool -> bool **)

let rec nearer eqi goal0 h d moves found =
  match moves with
  | [] -> found
  | p :: rest ->
    let (a, u) = p in
    (match known_number eqi h u with
     | Some k ->
       nearer eqi goal0 h d rest
         (if found
          then true
          else if memb a goal0 then true else ltb0 (h.distance k) d)
     | None -> false)

(** val check_state :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> ev list -> 'a1 numbering -> Uint63.t
    -> bool **)

let check_state p eqi goal0 h j =
  nearer eqi goal0 h (h.distance j) (p.succ0 (h.numbered_state j)) false

(** val check_possible :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> ev list -> 'a1 numbering -> bool **)

let check_possible p eqi goal0 h =
  match known_number eqi h p.init with
  | Some _ -> all_below (check_state p eqi goal0 h) h.state_count
  | None -> false

type 's run = (ev * 's) list

(** val is_run : 'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 -> 'a1 run -> bool **)

let rec is_run p eqs s = function
| [] -> true
| p0 :: rest ->
  let (a, u) = p0 in
  if steps_to p eqs s a u then is_run p eqs u rest else false

(** val run_end : 'a1 -> 'a1 run -> 'a1 **)

let rec run_end s = function
| [] -> s
| p :: rest -> let (_, u) = p in run_end u rest

(** val visible : 'a1 run -> ev list **)

let rec visible = function
| [] -> []
| p :: rest ->
  let (a, _) = p in if eqb a tau then visible rest else a :: (visible rest)

(** val is_loop :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 -> 'a1 run -> bool **)

let is_loop p eqs s r = match r with
| [] -> false
| _ :: _ ->
  if is_run p eqs s r
  then if forallb (fun m -> eqb (fst m) tau) r
       then eqs (run_end s r) s
       else false
  else false

(** val same_events : ev list -> ev list -> bool **)

let rec same_events l k =
  match l with
  | [] -> (match k with
           | [] -> true
           | _ :: _ -> false)
  | a :: l' ->
    (match k with
     | [] -> false
     | b :: k' -> if eqb a b then same_events l' k' else false)

(** val check_trace :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> ev list -> 'a1 run -> bool **)

let check_trace p eqs t r =
  if is_run p eqs p.init r then same_events (visible r) t else false

(** val refused : 'a1 run -> ev -> bool **)

let refused moves a =
  if offers moves tick then negb (eqb a tick) else negb (offers moves a)

(** val can_refuse : 'a1 run -> bool **)

let can_refuse moves =
  if offers moves tick then true else negb (offers moves tau)

(** val diverging :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> 'a1 run -> 'a1 run -> bool **)

let diverging p eqs r loop0 =
  if is_run p eqs p.init r
  then is_loop p eqs (run_end p.init r) loop0
  else false

type fault =
| Performs0
| Refuses of (ev -> bool)
| Diverges_after

(** val plain_event_at : ev list -> Uint63.t -> ev option **)

let plain_event_at t n =
  nth_error t (Z.to_nat (to_Z n))

(** val event_at : ev list -> Uint63.t -> ev option **)

let event_at t =
  table (of_Z (Z.of_nat (length t))) (plain_event_at t)

(** val performs : fault -> bool **)

let performs = function
| Performs0 -> true
| _ -> false

(** val absence_needs :
    model -> fault -> (Uint63.t -> ev option) -> Uint63.t -> ev -> need **)

let absence_needs m x next n a =
  if eqb a tau
  then Leads (n, (match m with
                  | FD -> true
                  | _ -> false))
  else (match next n with
        | Some b ->
          if eqb a b
          then if ltb0 n (add0 n (Uint63.of_int (1)))
               then if performs x
                    then (match next (add0 n (Uint63.of_int (1))) with
                          | Some _ ->
                            Leads ((add0 n (Uint63.of_int (1))), false)
                          | None -> Forbidden)
                    else Leads ((add0 n (Uint63.of_int (1))), false)
               else Forbidden
          else Irrelevant
        | None -> Irrelevant)

(** val absence_fine :
    fault -> (Uint63.t -> ev option) -> Uint63.t -> (ev * 'a1) list -> bool **)

let absence_fine x next n moves =
  match x with
  | Refuses x0 ->
    (match next n with
     | Some _ -> true
     | None ->
       if offers moves tick
       then x0 tick
       else if offers moves tau
            then true
            else existsb (fun mv -> x0 (fst mv)) moves)
  | _ -> true

(** val check_absence :
    'a1 lts -> ('a1 -> 'a1 -> bool) -> model -> ev list -> fault -> 'a1 pairs
    -> bool **)

let check_absence spec eqs m t x p =
  let next = event_at t in
  if performs x
  then (match next (Uint63.of_int (0)) with
        | Some _ ->
          walk spec eqs p (absence_needs m x next) (absence_fine x next)
            (Uint63.of_int (0))
        | None -> false)
  else walk spec eqs p (absence_needs m x next) (absence_fine x next)
         (Uint63.of_int (0))

type 's refutation =
| By_event of (ev * 's) list
| By_refusal of (ev * 's) list
| By_divergence of (ev * 's) list * (ev * 's) list

(** val check_refutation :
    'a1 lts -> 'a2 lts -> ('a1 -> 'a1 -> bool) -> ('a2 -> 'a2 -> bool) ->
    model -> 'a2 refutation -> 'a1 pairs -> bool **)

let check_refutation spec impl eqs eqi m v p =
  match v with
  | By_event r ->
    if is_run impl eqi impl.init r
    then check_absence spec eqs m (visible r) Performs0 p
    else false
  | By_refusal r ->
    (match m with
     | T -> false
     | _ ->
       if is_run impl eqi impl.init r
       then let moves = impl.succ0 (run_end impl.init r) in
            if can_refuse moves
            then check_absence spec eqs m (visible r) (Refuses
                   (refused moves)) p
            else false
       else false)
  | By_divergence (r, loop0) ->
    (match m with
     | FD ->
       if diverging impl eqi r loop0
       then check_absence spec eqs FD (visible r) Diverges_after p
       else false
     | _ -> false)

type shape = { merges : merging; packs : layout }

(** val compact : shape -> system -> Uint63.t list lts **)

let compact h y =
  packed h.packs (merged h.merges y)

(** val shape_ok : shape -> system -> bool **)

let shape_ok h y =
  (&&) (merging_ok h.merges y) (system_ok h.packs (merged h.merges y))

(** val searched :
    bool -> shape -> reduction option -> system -> Uint63.t list lts **)

let searched any h r y =
  match r with
  | Some r0 -> reduced h.packs (merged h.merges y) r0 any
  | None -> compact h y

(** val reduction_ok : bool -> shape -> reduction option -> system -> bool **)

let reduction_ok any h r y =
  match r with
  | Some r0 -> reduction_holds h.packs (merged h.merges y) r0 any
  | None -> true

(** val certify_refinement :
    model -> shape -> system -> shape -> system -> reduction option ->
    normal_form -> Uint63.t list evidence -> Uint63.t list pairs -> bool **)

let certify_refinement m hs spec hi impl r n e p =
  (&&)
    ((&&)
      ((&&)
        ((&&) ((&&) (shape_ok hs spec) (shape_ok hi impl))
          (reduction_ok false hi r impl))
        (match r with
         | Some r0 -> indifferent_ok r0 n
         | None -> true))
      (check_specification (compact hs spec) eq_words n e m))
    (check_implementation (searched false hi r impl) eq_words n m p)

(** val certify_property :
    property -> shape -> system -> reduction option -> Uint63.t list pairs ->
    bool **)

let certify_property p hi impl r p0 =
  (&&) ((&&) (shape_ok hi impl) (reduction_ok (only_deadlocks p) hi r impl))
    (check_property (searched (only_deadlocks p) hi r impl) eq_words p p0)

(** val certify_determinism :
    model -> shape -> choiceless -> shape -> system -> reduction option ->
    normal_form -> Uint63.t list evidence -> Uint63.t list pairs -> bool **)

let certify_determinism m hg g hi impl r n e p =
  match m with
  | T -> false
  | _ ->
    (&&) (choiceless_ok g)
      (certify_refinement m hg (choiceless_system g) hi impl r n e p)

(** val certify_possible :
    ev list -> shape -> system -> Uint63.t list numbering -> bool **)

let certify_possible goal0 hi impl h =
  (&&) (shape_ok hi impl) (check_possible (compact hi impl) eq_words goal0 h)

(** val certify_trace :
    ev list -> shape -> system -> (ev * Uint63.t list) list -> bool **)

let certify_trace t hi impl r =
  (&&) (shape_ok hi impl) (check_trace (compact hi impl) eq_words t r)

(** val certify_refutation :
    model -> shape -> system -> shape -> system -> Uint63.t list refutation
    -> Uint63.t list pairs -> bool **)

let certify_refutation m hs spec hi impl v p =
  (&&) ((&&) (shape_ok hs spec) (shape_ok hi impl))
    (check_refutation (compact hs spec) (compact hi impl) eq_words eq_words m
      v p)

type term =
| Offer of (ev * term) list
| Call of Uint63.t
| Choice of Uint63.t * term * term
| Sliding of term * term
| Sequence of term * term
| Interrupt of Uint63.t * term * term
| Throw of Uint63.t * term * term
| Parallel of Uint63.t * Uint63.t * Uint63.t * term * term
| Hide of Uint63.t * term
| Rename of Uint63.t * term
| Prioritise of Uint63.t * term

type definitions = { body : (Uint63.t -> term);
                     has : (Uint63.t -> ev -> bool);
                     names : (Uint63.t -> ev -> ev list);
                     priority : (Uint63.t -> ev -> Uint63.t option) }

type moves_to = (ev * term) list

(** val invisible : ev -> bool **)

let invisible e =
  (||) (eqb e tau) (eqb e tick)

(** val within : definitions -> Uint63.t -> ev -> bool **)

let within d a e =
  if invisible e then false else d.has a e

(** val new_names : definitions -> Uint63.t -> ev -> ev list **)

let new_names d r e =
  if invisible e
  then e :: []
  else (match d.names r e with
        | [] -> e :: []
        | e0 :: l0 -> e0 :: l0)

(** val hidden0 : definitions -> Uint63.t -> ev -> ev **)

let hidden0 d a e =
  if within d a e then tau else e

(** val rank : definitions -> Uint63.t -> ev -> Uint63.t option **)

let rank d o e =
  if invisible e then Some (Uint63.of_int (0)) else d.priority o e

(** val beats : definitions -> Uint63.t -> ev -> ev -> bool **)

let beats d o d0 e =
  match rank d o d0 with
  | Some k -> (match rank d o e with
               | Some l -> ltb0 k l
               | None -> false)
  | None -> false

(** val alone : definitions -> Uint63.t -> ev -> bool **)

let alone d a e =
  (||) (eqb e tau) (within d a e)

(** val together : definitions -> Uint63.t -> ev -> bool **)

let together d a e =
  (||) (eqb e tick) (within d a e)

(** val keep : (ev -> bool) -> (term -> term) -> moves_to -> moves_to **)

let keep on f l =
  map (fun m -> ((fst m), (if on (fst m) then f (snd m) else snd m))) l

(** val outside : definitions -> Uint63.t -> moves_to -> moves_to **)

let outside d a l =
  filter (fun m -> negb (within d a (fst m))) l

(** val joint :
    (ev -> bool) -> (term -> term -> term) -> moves_to -> moves_to -> moves_to **)

let joint on f l k =
  flat_map (fun m ->
    if on (fst m)
    then map (fun m' -> ((fst m), (f (snd m) (snd m'))))
           (filter (fun m' -> eqb (fst m') (fst m)) k)
    else []) l

(** val on_one :
    moves_to option -> (moves_to -> moves_to) -> moves_to option **)

let on_one l f =
  match l with
  | Some l0 -> Some (f l0)
  | None -> None

(** val on_both :
    moves_to option -> moves_to option -> (moves_to -> moves_to -> moves_to)
    -> moves_to option **)

let on_both l k f =
  match l with
  | Some l0 -> (match k with
                | Some k0 -> Some (f l0 k0)
                | None -> None)
  | None -> None

(** val moves_of : definitions -> int -> term -> moves_to option **)

let rec moves_of d bound p =
  (fun fO fS n -> if n=0 then fO () else fS (n-1))
    (fun _ -> None)
    (fun n ->
    let go = moves_of d n in
    (match p with
     | Offer branches -> Some branches
     | Call k -> go (d.body k)
     | Choice (a, p0, q) ->
       on_both (go p0) (go q) (fun l k ->
         app
           (keep (fun e -> eqb e tau) (fun u -> Choice (a, u, q))
             (outside d a l))
           (app
             (keep (fun e -> eqb e tau) (fun u -> Choice (a, p0, u))
               (outside d a k))
             (joint (within d a) (fun x x0 -> Choice (a, x, x0)) l k)))
     | Sliding (p0, q) ->
       on_one (go p0) (fun l ->
         app (keep (fun e -> eqb e tau) (fun u -> Sliding (u, q)) l) ((tau,
           q) :: []))
     | Sequence (p0, q) ->
       on_one (go p0)
         (map (fun m ->
           if eqb (fst m) tick
           then (tau, q)
           else ((fst m), (Sequence ((snd m), q)))))
     | Interrupt (a, p0, q) ->
       on_both (go p0) (go q) (fun l k ->
         app
           (keep (fun e -> negb (eqb e tick)) (fun u -> Interrupt (a, u, q))
             (outside d a l))
           (app
             (keep (fun e -> eqb e tau) (fun u -> Interrupt (a, p0, u))
               (outside d a k))
             (joint (within d a) (fun x x0 -> Interrupt (a, x, x0)) l k)))
     | Throw (a, p0, q) ->
       on_one (go p0)
         (map (fun m -> ((fst m),
           (if within d a (fst m)
            then q
            else if eqb (fst m) tick then snd m else Throw (a, (snd m), q)))))
     | Parallel (only_p, only_q, both, p0, q) ->
       on_both (go p0) (go q) (fun l k ->
         app
           (map (fun m -> ((fst m), (Parallel (only_p, only_q, both, 
             (snd m), q)))) (filter (fun m -> alone d only_p (fst m)) l))
           (app
             (map (fun m -> ((fst m), (Parallel (only_p, only_q, both, p0,
               (snd m))))) (filter (fun m -> alone d only_q (fst m)) k))
             (joint (together d both) (fun x x0 -> Parallel (only_p, only_q,
               both, x, x0)) l k)))
     | Hide (a, p0) ->
       on_one (go p0)
         (map (fun m -> ((hidden0 d a (fst m)), (Hide (a, (snd m))))))
     | Rename (r, p0) ->
       on_one (go p0)
         (flat_map (fun m ->
           map (fun e -> (e, (Rename (r, (snd m))))) (new_names d r (fst m))))
     | Prioritise (o, p0) ->
       on_one (go p0) (fun l ->
         map (fun m -> ((fst m), (Prioritise (o, (snd m)))))
           (filter (fun m ->
             negb (existsb (fun m' -> beats d o (fst m') (fst m)) l)) l))))
    bound

type script = { defines : definitions; main : term }

(** val eq_term : term -> term -> bool **)

let rec eq_term p q =
  match p with
  | Offer l ->
    (match q with
     | Offer k ->
       let rec same l0 k0 =
         match l0 with
         | [] -> (match k0 with
                  | [] -> true
                  | _ :: _ -> false)
         | y :: l1 ->
           let (a, p0) = y in
           (match k0 with
            | [] -> false
            | y0 :: k1 ->
              let (b, q0) = y0 in
              if eqb a b
              then if eq_term p0 q0 then same l1 k1 else false
              else false)
       in same l k
     | _ -> false)
  | Call k -> (match q with
               | Call l -> eqb k l
               | _ -> false)
  | Choice (a, p0, q0) ->
    (match q with
     | Choice (b, p', q') ->
       if eqb a b
       then if eq_term p0 p' then eq_term q0 q' else false
       else false
     | _ -> false)
  | Sliding (p0, q0) ->
    (match q with
     | Sliding (p', q') -> if eq_term p0 p' then eq_term q0 q' else false
     | _ -> false)
  | Sequence (p0, q0) ->
    (match q with
     | Sequence (p', q') -> if eq_term p0 p' then eq_term q0 q' else false
     | _ -> false)
  | Interrupt (a, p0, q0) ->
    (match q with
     | Interrupt (b, p', q') ->
       if eqb a b
       then if eq_term p0 p' then eq_term q0 q' else false
       else false
     | _ -> false)
  | Throw (a, p0, q0) ->
    (match q with
     | Throw (b, p', q') ->
       if eqb a b
       then if eq_term p0 p' then eq_term q0 q' else false
       else false
     | _ -> false)
  | Parallel (a, b, c, p0, q0) ->
    (match q with
     | Parallel (a', b', c', p', q') ->
       if eqb a a'
       then if eqb b b'
            then if eqb c c'
                 then if eq_term p0 p' then eq_term q0 q' else false
                 else false
            else false
       else false
     | _ -> false)
  | Hide (a, p0) ->
    (match q with
     | Hide (b, q0) -> if eqb a b then eq_term p0 q0 else false
     | _ -> false)
  | Rename (a, p0) ->
    (match q with
     | Rename (b, q0) -> if eqb a b then eq_term p0 q0 else false
     | _ -> false)
  | Prioritise (a, p0) ->
    (match q with
     | Prioritise (b, q0) -> if eqb a b then eq_term p0 q0 else false
     | _ -> false)

(** val distinct : Uint63.t -> ev list -> ev list **)

let distinct events l =
  snd
    (fold_left (fun x e ->
      let (t, found) = x in
      if Parray.get t e then x else ((Parray.set t e true), (e :: found))) l
      ((Parray.make events false), []))

type tree0 =
| Leaf of int
| Beside of Uint63.t * Uint63.t * Uint63.t * tree0 * tree0
| Hidden of Uint63.t * tree0
| Renamed of Uint63.t * tree0
| Prioritised of Uint63.t * tree0

type split = { whole_tree : tree0; slots : int; states : (int -> Uint63.t);
               meaning : (int -> Uint63.t -> term);
               number_of : (int -> term -> Uint63.t);
               alphabet : (int -> ev list); enough : int;
               event_bound : Uint63.t }

type vector = { gives : ev; rank_of : Uint63.t option; wants : (int * ev) list }

(** val rule_of : vector -> rule **)

let rule_of v =
  { does = v.gives; level = v.rank_of; asks = v.wants; puts = [] }

type compiled = participant list * vector list

(** val region_of : compiled -> region **)

let region_of c =
  Region ((fst c), (map rule_of (snd c)))

(** val each : ev list -> vector list **)

let each l =
  map (fun e -> { gives = e; rank_of = None; wants = ((0, e) :: []) }) l

(** val free : vector list -> bool **)

let free vs =
  forallb (fun v -> match v.rank_of with
                    | Some _ -> false
                    | None -> true) vs

(** val boxed : Uint63.t -> compiled -> compiled **)

let boxed events c =
  if free (snd c)
  then c
  else (((Inner (region_of c)) :: []),
         (each (distinct events (map (fun v -> v.gives) (snd c)))))

(** val relabel : (ev -> ev list) -> compiled -> compiled **)

let relabel f c =
  ((fst c),
    (flat_map (fun v ->
      map (fun e -> { gives = e; rank_of = v.rank_of; wants = v.wants })
        (f v.gives)) (snd c)))

(** val ranked_by : (ev -> Uint63.t option) -> compiled -> compiled **)

let ranked_by f c =
  ((fst c),
    (map (fun v -> { gives = v.gives; rank_of = (f v.gives); wants =
      v.wants }) (snd c)))

(** val shift0 : int -> (int * ev) list -> (int * ev) list **)

let shift0 n l =
  map (fun x -> ((add n (fst x)), (snd x))) l

(** val shifted : int -> vector -> vector **)

let shifted n v =
  { gives = v.gives; rank_of = None; wants = (shift0 n v.wants) }

(** val beside :
    Uint63.t -> (ev -> bool) -> (ev -> bool) -> (ev -> bool) -> compiled ->
    compiled -> compiled **)

let beside events on_p on_q on_both0 c d =
  let n = length (fst c) in
  let others0 =
    table events (fun e ->
      if on_both0 e then filter (fun v -> eqb v.gives e) (snd d) else [])
  in
  ((app (fst c) (fst d)),
  (app (filter (fun v -> on_p v.gives) (snd c))
    (app (map (shifted n) (filter (fun v -> on_q v.gives) (snd d)))
      (flat_map (fun v ->
        if on_both0 v.gives
        then map (fun w -> { gives = v.gives; rank_of = None; wants =
               (app v.wants (shift0 n w.wants)) }) (others0 v.gives)
        else []) (snd c)))))

(** val compile : definitions -> split -> tree0 -> compiled **)

let compile d x =
  let events = x.event_bound in
  let rec compile0 = function
  | Leaf k -> (((Slot k) :: []), (each (x.alphabet k)))
  | Beside (only_p, only_q, both, t0, u) ->
    beside events (alone d only_p) (alone d only_q) (together d both)
      (boxed events (compile0 t0)) (boxed events (compile0 u))
  | Hidden (a, t0) -> relabel (fun e -> (hidden0 d a e) :: []) (compile0 t0)
  | Renamed (r, t0) -> relabel (new_names d r) (compile0 t0)
  | Prioritised (o, t0) -> ranked_by (rank d o) (boxed events (compile0 t0))
  in compile0

(** val term_of : split -> Uint63.t list -> tree0 -> term **)

let rec term_of x s = function
| Leaf k -> x.meaning k (nth k s (Uint63.of_int (0)))
| Beside (a, b, c, t0, u) ->
  Parallel (a, b, c, (term_of x s t0), (term_of x s u))
| Hidden (a, t0) -> Hide (a, (term_of x s t0))
| Renamed (r, t0) -> Rename (r, (term_of x s t0))
| Prioritised (o, t0) -> Prioritise (o, (term_of x s t0))

(** val leaves0 : tree0 -> int list **)

let rec leaves0 = function
| Leaf k -> k :: []
| Beside (_, _, _, t0, u) -> app (leaves0 t0) (leaves0 u)
| Hidden (_, t0) -> leaves0 t0
| Renamed (_, t0) -> leaves0 t0
| Prioritised (_, t0) -> leaves0 t0

(** val row :
    definitions -> split -> int -> Uint63.t -> (ev * Uint63.t) list **)

let row d x k v =
  match moves_of d x.enough (x.meaning k v) with
  | Some l -> map (fun m -> ((fst m), (x.number_of k (snd m)))) l
  | None -> []

(** val split_system : definitions -> split -> system **)

let split_system d x =
  let rows = map (fun k -> table (x.states k) (row d x k)) (seq 0 x.slots) in
  { edges = (fun k -> nth k rows (fun _ -> [])); start =
  (repeat (Uint63.of_int (0)) x.slots); whole =
  (region_of (compile d x x.whole_tree)) }

(** val known : split -> int -> term -> bool **)

let known x k p =
  let v = x.number_of k p in
  if ltb0 v (x.states k) then eq_term (x.meaning k v) p else false

(** val component_ok : definitions -> split -> int -> bool **)

let component_ok d x =
  let events = x.event_bound in
  (fun k ->
  let listed =
    fold_left (fun t e -> Parray.set t e true) (x.alphabet k)
      (Parray.make events false)
  in
  (&&) (ltb0 (Uint63.of_int (0)) (x.states k))
    (all_below (fun v ->
      match moves_of d x.enough (x.meaning k v) with
      | Some l ->
        forallb (fun m ->
          if Parray.get listed (fst m) then known x k (snd m) else false) l
      | None -> false) (x.states k)))

(** val split_ok : definitions -> split -> term -> bool **)

let split_ok d x p =
  (&&)
    ((&&)
      ((&&)
        (eq_term
          (term_of x (repeat (Uint63.of_int (0)) x.slots) x.whole_tree) p)
        (forallb (fun k -> Nat.ltb k x.slots) (leaves0 x.whole_tree)))
      (no_repetition (leaves0 x.whole_tree)))
    (forallb (component_ok d x) (seq 0 x.slots))

(** val certify_script : script -> split -> (system -> bool) -> bool **)

let certify_script z0 x check =
  (&&) (split_ok z0.defines x z0.main) (check (split_system z0.defines x))

(** val certify_scripts :
    script -> split -> script -> split -> (system -> system -> bool) -> bool **)

let certify_scripts spec xs impl xi check =
  certify_script spec xs (fun s -> certify_script impl xi (check s))
