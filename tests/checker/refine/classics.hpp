// The families every refinement checker is shown, built by hand.
#pragma once

#include <string>
#include <vector>

#include "tests/checker/process/scripted.hpp"

namespace robochart::refine {

using process::Scripted;
using process::TermId;

/// N philosophers and forks; eight events each. Asymmetric: the last one picks up his right fork first.
TermId dining_philosophers(Scripted& s, int count, bool symmetric);

/// Milner's scheduler of N cyclers with the control events c visible; `count` events each of a, b and c.
TermId milner_scheduler(Scripted& s, int count);
/// a.0, a.1, ..., a.(count-1) in turn for ever.
TermId round_robin(Scripted& s, int count);

/// A chain of one-place buffers over {0,1} from in to out with its middle hidden; and the buffer of as many places.
TermId buffer_chain(Scripted& s, int count);
TermId buffer(Scripted& s, int places);

/// `count` independent processes of four events each.
TermId independent_cycles(Scripted& s, int count);

/// The term without these events: hides all "channel.…".
TermId hide_channels(Scripted& s, TermId process, const std::vector<std::string>& channels, int count);

}  // namespace robochart::refine
