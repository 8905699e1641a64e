// SPDX-License-Identifier: Apache-2.0
// Compiled processes, whole or reduced, as bytes, so that another program can search them. Events keep their numbers;
// the terms of states are not included.
#pragma once

#include <memory>

#include "checker/lts/bytes.hpp"
#include "checker/lts/transition_system.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

void write(const Supercombinator& process, lts::ByteWriter& out);
/// Reads a process with the same transitions and packed states. `meaning`: a term that is used as the meaning of its
/// states. Throws BadBytes for malformed bytes. For all inputs, a process that is returned can be searched.
[[nodiscard]] Supercombinator read_supercombinator(lts::ByteReader& in, TermId meaning);

/// Writes a compiled process, its reduced form, or one of these with symmetry. Returns false for other systems; the
/// output is then invalid.
[[nodiscard]] bool write(const lts::TransitionSystem& system, lts::ByteWriter& out);
/// Reads the same system, with the same words as states. It cannot describe states. `terms` must outlive it. Throws
/// BadBytes.
[[nodiscard]] std::unique_ptr<lts::TransitionSystem> read_system(lts::ByteReader& in, process::TermStore& terms);

}  // namespace robochart::machine
