// SPDX-License-Identifier: Apache-2.0
// NF_c(M) as CSPM: the model in parallel with the three simulation assumptions (docs/conformance.md). This is the
// normative definition, for FDR and for readers; the search runs the equivalent NormalFormSystem.
#pragma once

#include <cstdint>

#include "checker/cspm/syntax/syntax.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

enum class Reading {
    any_order,    ///< the definition: registers are read in any order
    fixed_order,  ///< in the order of the interface, as in L(G) here ("One order of reading")
};

struct NormalFormScript {
    std::vector<cspm::DeclPtr> decls;  ///< appended to the script of the model
    cspm::ExprPtr process;             ///< NF_c(M)
};

/// Writes the normal form. `model` is the process to be run in cycles, in the scope of `script`. It has the events of
/// the alphabet's interface below its component name. Throws AlphabetError if the script lacks a channel of the
/// interface, or already uses a name that the normal form declares.
[[nodiscard]] NormalFormScript normal_form(const cspm::Script& script, const cspm::ExprPtr& model, const Alphabet&,
                                           std::uint32_t cycle_length, Reading);

/// The declaration of a channel by its qualified name, searched in modules and timed sections; null if there is none.
[[nodiscard]] cspm::DeclPtr find_channel(const cspm::Script& script, const std::string& qualified);

}  // namespace robochart::conformance
