// SPDX-License-Identifier: Apache-2.0
// Encodes compiled processes, whole or reduced, as bytes, so that another program can search them. Events keep their
// numbers. The terms of states are not included.
#pragma once

#include <memory>

#include "checker/lts/bytes.hpp"
#include "checker/lts/transition_system.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

void write(const Supercombinator& process, lts::ByteWriter& out);
/// Reads a process that has the same transitions and packed states as the written one. `meaning`: a term that all its
/// states then represent. Throws BadBytes for malformed bytes. The function checks the bytes, so every process that it
/// returns can be searched safely, even if the bytes were changed.
[[nodiscard]] Supercombinator read_supercombinator(lts::ByteReader& in, TermId meaning);

/// Writes a compiled process, its reduced form, or one of these with symmetry. Returns false for other systems; the
/// output is then invalid.
[[nodiscard]] bool write(const lts::TransitionSystem& system, lts::ByteWriter& out);
/// Reads a system that `write` has written. It has the same packed states, but cannot describe them. `terms` must
/// outlive the system. Throws BadBytes.
[[nodiscard]] std::unique_ptr<lts::TransitionSystem> read_system(lts::ByteReader& in, process::TermStore& terms);

}  // namespace robochart::machine
