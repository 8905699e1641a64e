// SPDX-License-Identifier: Apache-2.0
// Writes NF_c(M) as CSPM: the model in parallel with the three simulation assumptions (docs/conformance.md). This is
// the normative definition, for FDR and for readers. The search runs the equivalent NormalFormSystem.
#pragma once

#include <cstdint>

#include "checker/cspm/syntax/syntax.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

enum class Reading {
    any_order,    ///< the definition: registers are read in any order
    fixed_order,  ///< in the order of the interface, as in L(G) ("One order of reading")
};

struct NormalFormScript {
    std::vector<cspm::DeclPtr> decls;  ///< to be appended to the script of the model
    cspm::ExprPtr process;             ///< NF_c(M)
};

/// Writes the normal form of `model`, a process in the scope of `script`. The process must have the events of the
/// alphabet's interface below its component name. Throws AlphabetError if the script lacks a channel of the interface,
/// or already uses a name that the normal form declares.
[[nodiscard]] NormalFormScript normal_form(const cspm::Script& script, const cspm::ExprPtr& model, const Alphabet&,
                                           std::uint32_t cycle_length, Reading);

/// Returns the declaration of the channel with this qualified name. Searches modules and timed sections. Returns null
/// if there is no such channel.
[[nodiscard]] cspm::DeclPtr find_channel(const cspm::Script& script, const std::string& qualified);

}  // namespace robochart::conformance
