// SPDX-License-Identifier: Apache-2.0
// Builds standard families of processes for refinement checkers.
#pragma once

#include <string>
#include <vector>

#include "tests/checker/process/scripted.hpp"

namespace robochart::refine {

using process::Scripted;
using process::TermId;

/// Returns N philosophers and forks with eight events each. If not symmetric, the last philosopher picks up the right
/// fork first.
TermId dining_philosophers(Scripted& s, int count, bool symmetric);

/// Returns Milner's scheduler of N cyclers, whose control events c are visible. There are `count` events each of a, b
/// and c.
TermId milner_scheduler(Scripted& s, int count);
/// Returns a process that performs a.0, a.1, ..., a.(count-1) in turn, repeatedly.
TermId round_robin(Scripted& s, int count);

/// Returns a chain of one-place buffers over {0,1} from in to out with hidden inner channels. The next function returns
/// the buffer of the same capacity.
TermId buffer_chain(Scripted& s, int count);
TermId buffer(Scripted& s, int places);

/// Returns `count` independent processes of four events each.
TermId independent_cycles(Scripted& s, int count);

/// Hides all events "channel.…" of these channels.
TermId hide_channels(Scripted& s, TermId process, const std::vector<std::string>& channels, int count);

}  // namespace robochart::refine
