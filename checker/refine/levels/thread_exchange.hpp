// SPDX-License-Identifier: Apache-2.0
// Uses the threads of a program as ranks, alone or together with the threads of other programs.
#pragma once

#include <functional>
#include <stdexcept>

#include "checker/refine/levels/exchange.hpp"

namespace robochart::refine {

/// Thrown if another rank has left a search that needs it.
class RankLost : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Calls `work` in this many threads and returns when all have ended. The caller's thread is the first of them. Each
/// rank of `programs` is a program, and calls this function with the same number of threads. The threads of program p
/// are the ranks p * threads, p * threads + 1, ... of the exchange that is passed to `work`. Messages between threads
/// of one program stay in its memory. All messages to another program are combined into one. Only the caller's thread
/// calls `programs`.
///
/// If threads of the program have failed, throws an exception of the first of these kinds: that of a thread that failed
/// itself, that of a thread that learned of another rank's failure (RankFailed), or that of a thread that lost another
/// rank (RankLost). `programs` have left the work together if all these threads have. Throws LimitReached if a thread
/// cannot be started; then all programs have left together.
void as_ranks(Exchange& programs, unsigned threads, const std::function<void(Exchange&)>& work);
/// Runs the threads of a single program as ranks.
void as_ranks(unsigned ranks, const std::function<void(Exchange&)>& work);

}  // namespace robochart::refine
