// SPDX-License-Identifier: Apache-2.0
// Threads of a program as ranks, alone or together with those of other programs.
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

/// Calls `work` in this many threads, the caller's being the first, and returns when all have ended. Each rank of
/// `programs` is a program, and calls this function with the same number of threads; the threads of program p are the
/// ranks p * threads, p * threads + 1, ... of the exchange passed to `work`. Messages between threads of one program
/// stay in its memory; all messages to another program are combined into one. Only the caller's thread calls
/// `programs`.
///
/// Throws the exception of the first of the program's threads that has failed itself; otherwise of the first that has
/// learned of another's failure (RankFailed); otherwise of the first that has lost another one. `programs` have left
/// together if all these threads have. Throws LimitReached if a thread cannot be started; then all programs have left
/// together.
void as_ranks(Exchange& programs, unsigned threads, const std::function<void(Exchange&)>& work);
/// The same for a single program.
void as_ranks(unsigned ranks, const std::function<void(Exchange&)>& work);

}  // namespace robochart::refine
