// Threads of a program as ranks, alone or beside those of other programs.
#pragma once

#include <functional>
#include <stdexcept>

#include "checker/refine/levels/exchange.hpp"

namespace robochart::refine {

/// Another rank has left a search in which it is needed.
class RankLost : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Calls `work` in so many threads at once, the caller's among them as the first, and returns when all have ended. Each
/// rank of `programs` is a program, and calls this with the same number of threads; the threads of program p are the
/// ranks p * threads, p * threads + 1, ... of the exchange that `work` gets. What threads of one program send each
/// other stays in its memory; all that they send to another program is one message. Only the caller's thread calls
/// `programs`.
///
/// Throws what the first of the program's threads has thrown that met an error itself, or else has heard of another's
/// (RankFailed), or else has lost another one. `programs` have left together if all these threads have. Throws
/// LimitReached where a thread cannot be started; then all programs have left together.
void as_ranks(Exchange& programs, unsigned threads, const std::function<void(Exchange&)>& work);
/// The same for one program alone.
void as_ranks(unsigned ranks, const std::function<void(Exchange&)>& work);

}  // namespace robochart::refine
