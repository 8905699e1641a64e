// SPDX-License-Identifier: Apache-2.0
// Standard families for refinement checkers, built by hand.
#pragma once

#include <string>
#include <vector>

#include "tests/checker/process/scripted.hpp"

namespace robochart::refine {

using process::Scripted;
using process::TermId;

/// N philosophers and forks with eight events each. Asymmetric: the last philosopher picks up the right fork first.
TermId dining_philosophers(Scripted& s, int count, bool symmetric);

/// Milner's scheduler of N cyclers; its control events c are visible. There are `count` events each of a, b and c.
TermId milner_scheduler(Scripted& s, int count);
/// a.0, a.1, ..., a.(count-1) in turn, repeatedly.
TermId round_robin(Scripted& s, int count);

/// A chain of one-place buffers over {0,1} from in to out with hidden inner channels, and the buffer of the same
/// capacity.
TermId buffer_chain(Scripted& s, int count);
TermId buffer(Scripted& s, int places);

/// `count` independent processes of four events each.
TermId independent_cycles(Scripted& s, int count);

/// Hides all events "channel.…" of these channels.
TermId hide_channels(Scripted& s, TermId process, const std::vector<std::string>& channels, int count);

}  // namespace robochart::refine
