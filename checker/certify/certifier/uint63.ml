(* SPDX-License-Identifier: Apache-2.0 *)
(* Implements Coq's primitive unsigned 63-bit integers by OCaml's native integers. This file must be trusted. *)
type t = int

let[@inline] of_int (x : int) = x
let[@inline] flip x = x lxor min_int
let[@inline] lt (x : int) (y : int) = flip x < flip y
let[@inline] le (x : int) (y : int) = flip x <= flip y
let[@inline] equal (x : int) (y : int) = x = y
let compare x y = Stdlib.compare (flip x : int) (flip y)
let[@inline] add (x : int) (y : int) = x + y
let[@inline] sub (x : int) (y : int) = x - y
let[@inline] mul (x : int) (y : int) = x * y
let[@inline] l_and (x : int) (y : int) = x land y
let[@inline] l_or (x : int) (y : int) = x lor y
let[@inline] l_xor (x : int) (y : int) = x lxor y
let[@inline] l_sl (x : int) (y : int) = if lt y 63 then x lsl y else 0
let[@inline] l_sr (x : int) (y : int) = if lt y 63 then x lsr y else 0

(* Divides half the dividend first. The resulting quotient is at most one too small. *)
let large_div (x : int) (y : int) =
  if y = 0 then 0
  else if lt x y then 0
  else if y < 0 then 1
  else
    let q = ((x lsr 1) / y) lsl 1 in
    if le y (x - (q * y)) then q + 1 else q

let[@inline] div (x : int) (y : int) = if x >= 0 && y > 0 then x / y else large_div x y
let[@inline] rem (x : int) (y : int) =
  if x >= 0 && y > 0 then x mod y else if y = 0 then x else x - (large_div x y * y)
