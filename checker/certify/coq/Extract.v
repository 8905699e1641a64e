(* SPDX-License-Identifier: Apache-2.0 *)
(* Writes verified.ml, and prints the assumptions of the theorems. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOCamlInt63.
From Coq Require PArray.
From Certify Require Import Claims Processes Certificate Packing Merging WholeRules Confluence Symmetry Following Determinism Possible Runs Program Terms Splitting Scripts.
Extraction Language OCaml.
Extract Constant PArray.array "'a" => "'a Parray.t".
Extract Inlined Constant PArray.make => "Parray.make".
Extract Inlined Constant PArray.get => "Parray.get".
Extract Inlined Constant PArray.set => "Parray.set".
Extract Inlined Constant PArray.length => "Parray.length".
Extract Inlined Constant PArray.max_length => "Parray.max_length".
Extraction "verified.ml" certify_refinement certify_property certify_determinism certify_possible certify_trace certify_refutation compact searched shape_ok reduction_ok merged automorphism_ok plain indifferent_to rules_of_whole rows_by_event has_event goal determined spared impossible cannot_fire sure commutes undisturbed outcomes merging_ok check_specification check_implementation check_property event_needs refusals enabled any_event after
  certify_scripts certify_script split_ok split_system moves_of.
Print Assumptions program_sound.
Print Assumptions script_sound.
