(* SPDX-License-Identifier: Apache-2.0 *)
(* Computes SHA-256 (FIPS 180-4), which binds the files of a certificate to its claim. *)
let primes count =
  let rec from n found =
    if List.length found = count then List.rev found
    else from (n + 1) (if List.exists (fun p -> n mod p = 0) found then found else n :: found)
  in
  from 2 []

let mask = 0xffffffff

(* Returns the first 32 bits of the fraction of the root: the largest r with r^k <= p 2^(32 k), without its integer
   part. Numbers are lists of digits of 24 bits, the least digit first. *)
let root_fraction k p =
  let rec add a b carry =
    match (a, b) with
    | [], [] -> if carry = 0 then [] else [ carry ]
    | x :: a', [] | [], x :: a' -> (((x + carry) land 0xffffff) :: add a' [] ((x + carry) lsr 24))
    | x :: a', y :: b' ->
        let s = x + y + carry in
        (s land 0xffffff) :: add a' b' (s lsr 24)
  in
  let scale a d =
    let rec go a carry =
      match a with
      | [] -> if carry = 0 then [] else [ carry land 0xffffff; carry lsr 24 ]
      | x :: a' ->
          let s = (x * d) + carry in
          (s land 0xffffff) :: go a' (s lsr 24)
    in
    go a 0
  in
  let rec multiply a = function [] -> [] | d :: b' -> add (scale a d) (0 :: multiply a b') 0 in
  let rec trim = function [] -> [] | x :: a' -> ( match trim a' with [] when x = 0 -> [] | t -> x :: t) in
  let compare_numbers a b =
    let a = trim a and b = trim b in
    let by_length = compare (List.length a) (List.length b) in
    if by_length <> 0 then by_length else compare (List.rev a) (List.rev b)
  in
  let number x = [ x land 0xffffff; (x lsr 24) land 0xffffff; x lsr 48 ] in
  let rec power a n = if n = 0 then [ 1 ] else multiply a (power a (n - 1)) in
  let limit = scale (power (number (1 lsl 32)) k) p in
  let rec search low high =
    if high - low = 1 then low
    else
      let middle = (low + high) / 2 in
      if compare_numbers (power (number middle) k) limit <= 0 then search middle high else search low middle
  in
  search 0 (1 lsl 38) land mask

let constants = lazy (Array.of_list (List.map (root_fraction 3) (primes 64)))
let initial = lazy (Array.of_list (List.map (root_fraction 2) (primes 8)))
let rotate x n = ((x lsr n) lor (x lsl (32 - n))) land mask

let compress state block =
  let constants = Lazy.force constants in
  let w = Array.make 64 0 in
  for i = 0 to 15 do
    w.(i) <- Int32.to_int (String.get_int32_be block (4 * i)) land mask
  done;
  for i = 16 to 63 do
    let x = w.(i - 15) and y = w.(i - 2) in
    let s0 = rotate x 7 lxor rotate x 18 lxor (x lsr 3) and s1 = rotate y 17 lxor rotate y 19 lxor (y lsr 10) in
    w.(i) <- (w.(i - 16) + s0 + w.(i - 7) + s1) land mask
  done;
  let v = Array.copy state in
  for i = 0 to 63 do
    let a = v.(0) and e = v.(4) in
    let s1 = rotate e 6 lxor rotate e 11 lxor rotate e 25 in
    let choice = e land v.(5) lxor (lnot e land v.(6)) in
    let t1 = (v.(7) + s1 + choice + constants.(i) + w.(i)) land mask in
    let s0 = rotate a 2 lxor rotate a 13 lxor rotate a 22 in
    let majority = a land v.(1) lxor (a land v.(2)) lxor (v.(1) land v.(2)) in
    Array.blit v 0 v 1 7;
    v.(4) <- (v.(4) + t1) land mask;
    v.(0) <- (t1 + s0 + majority) land mask
  done;
  Array.iteri (fun i x -> state.(i) <- (state.(i) + x) land mask) v

let hex text =
  let length = String.length text in
  let padding = ((119 - (length mod 64)) mod 64) + 1 in
  let tail = Bytes.make (padding + 8) '\000' in
  Bytes.set tail 0 '\128';
  Bytes.set_int64_be tail padding (Int64.of_int (8 * length));
  let all = text ^ Bytes.to_string tail in
  let state = Array.copy (Lazy.force initial) in
  for i = 0 to (String.length all / 64) - 1 do
    compress state (String.sub all (64 * i) 64)
  done;
  String.concat "" (List.map (Printf.sprintf "%08x") (Array.to_list state))
