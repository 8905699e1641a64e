// Results of the operators over intervals as enclosures.
#pragma once

#include <functional>

#include "checker/markov/operators/operators.hpp"

namespace robochart::markov {

/// Rounds upward while the operator runs. Asks it again, for more, while the values of components lose too much of
/// their precision on their way through others.
[[nodiscard]] Solution answer(const Precision& precision,
                              const std::function<Result<Interval>(const Precision& precision)>& operation);

}  // namespace robochart::markov
