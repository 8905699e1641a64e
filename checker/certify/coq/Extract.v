(* SPDX-License-Identifier: Apache-2.0 *)
(* Writes verified.ml, and prints the assumptions of the theorem. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOCamlInt63.
From Coq Require PArray.
From Certify Require Import Claims Processes Certificate Packing Program.
Extraction Language OCaml.
Extract Constant PArray.array "'a" => "'a Parray.t".
Extract Inlined Constant PArray.make => "Parray.make".
Extract Inlined Constant PArray.get => "Parray.get".
Extract Inlined Constant PArray.set => "Parray.set".
Extract Inlined Constant PArray.length => "Parray.length".
Extract Inlined Constant PArray.max_length => "Parray.max_length".
Extraction "verified.ml" certify_refinement certify_property packed system_ok check_specification check_pair check_state check_implementation check_property check_move after refusals_ok.
Print Assumptions program_sound.
