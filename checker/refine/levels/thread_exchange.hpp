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

/// Calls `work` in this many threads and returns when all threads have ended. The caller's thread is the first of these
/// threads. Each rank of `programs` is a program. All programs call this function with the same number of threads. The
/// threads of program p are the ranks p * threads, p * threads + 1, ... of the exchange that is passed to `work`.
/// Messages between threads of one program stay in its memory. All messages to another program are combined into one.
/// Only the caller's thread calls `programs`.
///
/// If threads of the program have failed, throws the exception of one of them. Exceptions of threads that failed
/// themselves come first, then exceptions of threads that learned of another rank's failure (RankFailed), and then
/// exceptions of threads that lost another rank (RankLost). If all threads of this program have left the work together,
/// all `programs` have left it together too. If a thread cannot be started, throws LimitReached; all programs have then
/// left the work together.
void as_ranks(Exchange& programs, unsigned threads, const std::function<void(Exchange&)>& work);
/// Runs the threads of a single program as ranks.
void as_ranks(unsigned ranks, const std::function<void(Exchange&)>& work);

}  // namespace robochart::refine
