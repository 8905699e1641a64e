// What belongs to several machines at once: rendezvous, buffers, the state around the machines' frames, one cycle of
// all of them (semantics 3.9).
#pragma once

#include <vector>

#include "cpp_emit/files/files.hpp"

namespace robochart::cpp_emit {

/// `sites_C`, `offers_C`, `accept_C` for each channel C: where its sender may wait, whether it does and with which
/// value, and moving it on.
void write_channels(const Generation&, const Core&, CodeWriter&);
/// Members of State that belong to no machine: buffers, shared variables of several machines.
[[nodiscard]] std::vector<Field> common_fields(const Generation&);
/// The layout of State around the frames of several machines.
[[nodiscard]] FrameLayout composed_layout(const Generation&, const Core&, std::vector<Field> more);
/// run, finished and advance of all machines.
void write_composition(const Generation&, const Core&, CodeWriter&);

}  // namespace robochart::cpp_emit
