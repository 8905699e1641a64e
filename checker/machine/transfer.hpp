// Compiled processes, whole or reduced, as bytes, so that another program can search them. Events keep their numbers;
// the terms that states stand for stay behind.
#pragma once

#include <memory>

#include "checker/lts/bytes.hpp"
#include "checker/lts/transition_system.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

void write(const Supercombinator& process, lts::ByteWriter& out);
/// A process with the same transitions and packed states. `meaning`: a term, which its states are said to stand for.
/// Throws BadBytes where the bytes are none; whatever they are, what is read can be searched.
[[nodiscard]] Supercombinator read_supercombinator(lts::ByteReader& in, TermId meaning);

/// A compiled process, its reduced form, or one of these without the images of states. False where it is neither: then
/// nothing of use has been written.
[[nodiscard]] bool write(const lts::TransitionSystem& system, lts::ByteWriter& out);
/// The same system, with the same words as states; it describes no state. `terms` outlive it. Throws BadBytes.
[[nodiscard]] std::unique_ptr<lts::TransitionSystem> read_system(lts::ByteReader& in, process::TermStore& terms);

}  // namespace robochart::machine
