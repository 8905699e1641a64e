// SPDX-License-Identifier: Apache-2.0
// Encodes compiled processes, whole or reduced, as bytes for another program that searches them. The numbers of events
// stay the same. The terms of states are not transferred.
#pragma once

#include <memory>

#include "checker/lts/bytes.hpp"
#include "checker/lts/transition_system.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

void write(const Supercombinator& process, lts::ByteWriter& out);
/// Reads a process with the same transitions and packed states as the written process. All states represent the term
/// `meaning`. Checks the bytes and throws BadBytes if they are malformed. So even if the bytes were changed, searching
/// the result is safe.
[[nodiscard]] Supercombinator read_supercombinator(lts::ByteReader& in, TermId meaning);

/// Writes a compiled process or its reduced form, with or without symmetry. For all other systems, returns false, and
/// the output is invalid.
[[nodiscard]] bool write(const lts::TransitionSystem& system, lts::ByteWriter& out);
/// Reads a system from the output of `write`. The system has the same packed states, but cannot describe them. `terms`
/// must outlive the system. Throws BadBytes.
[[nodiscard]] std::unique_ptr<lts::TransitionSystem> read_system(lts::ByteReader& in, process::TermStore& terms);

}  // namespace robochart::machine
