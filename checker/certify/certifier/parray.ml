(* SPDX-License-Identifier: Apache-2.0 *)
(* Implements Coq's primitive arrays, whose values never change. The newest version of an array is a native array. An
   older version is stored as a difference from a newer one. This file must be trusted. *)
type 'a t = 'a version ref
and 'a version = Newest of 'a array * 'a | Older of int * 'a * 'a t

let max_length = Sys.max_array_length
let make n default = ref (Newest (Array.make (if n >= 0 && n <= max_length then n else max_length) default, default))

let rec content t = match !t with Newest (values, default) -> (values, default) | Older (_, _, newer) -> content newer
let[@inline] length t = match !t with Newest (values, _) -> Array.length values | Older _ -> Array.length (fst (content t))

let rec get_older t i =
  match !t with
  | Newest (values, default) -> if i >= 0 && i < Array.length values then Array.unsafe_get values i else default
  | Older (j, value, newer) -> if i = j then value else get_older newer i

let[@inline] get t i =
  match !t with
  | Newest (values, default) -> if i >= 0 && i < Array.length values then Array.unsafe_get values i else default
  | Older _ -> get_older t i

let copy t =
  let _, default = content t in
  ref (Newest (Array.init (length t) (get t), default))

let rec set t i x =
  match !t with
  | Older _ -> set (copy t) i x
  | Newest (values, default) ->
      if i < 0 || i >= Array.length values then t
      else begin
        let newest = ref (Newest (values, default)) in
        t := Older (i, values.(i), newest);
        values.(i) <- x;
        newest
      end
