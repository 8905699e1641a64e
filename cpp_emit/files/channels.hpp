// SPDX-License-Identifier: Apache-2.0
// Writes the code that connects several machines: rendezvous, buffers, the state around the machines' frames, and one
// cycle of all machines (semantics 3.9).
#pragma once

#include <vector>

#include "cpp_emit/files/files.hpp"

namespace robochart::cpp_emit {

/// Writes three functions for each channel C. `sites_C` contains the places at which the sender may wait, `offers_C`
/// returns whether the sender waits and with which value, and `accept_C` advances the sender.
void write_channels(const Generation&, const Core&, CodeWriter&);
/// Returns the members of State that do not belong to one machine: buffers, and variables that several machines share.
[[nodiscard]] std::vector<Field> common_fields(const Generation&);
/// Returns the layout of the State that contains the frames of several machines.
[[nodiscard]] FrameLayout composed_layout(const Generation&, const Core&, std::vector<Field> more);
/// Writes the functions run, finished and advance for all machines.
void write_composition(const Generation&, const Core&, CodeWriter&);

}  // namespace robochart::cpp_emit
