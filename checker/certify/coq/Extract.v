(* SPDX-License-Identifier: Apache-2.0 *)
(* Writes verified.ml, and prints the assumptions of the theorem. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOCamlInt63.
From Coq Require PArray.
From Certify Require Import Claims Processes Certificate Packing Merging Determinism Possible Runs Program.
Extraction Language OCaml.
Extract Constant PArray.array "'a" => "'a Parray.t".
Extract Inlined Constant PArray.make => "Parray.make".
Extract Inlined Constant PArray.get => "Parray.get".
Extract Inlined Constant PArray.set => "Parray.set".
Extract Inlined Constant PArray.length => "Parray.length".
Extract Inlined Constant PArray.max_length => "Parray.max_length".
Extraction "verified.ml" certify_refinement certify_property certify_determinism certify_possible certify_trace certify_refutation compact shape_ok merging_ok check_specification check_implementation check_property event_needs refusals enabled any_event after.
Print Assumptions program_sound.
