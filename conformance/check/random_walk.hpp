// Where the whole is too large: random walks of the compiled code along the model's normal form, guided by what they
// have not met before (coverage-guided, after AFL's queue: walks go on from cycles that led to something new). They
// find differences and never show that there are none.
#pragma once

#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"
#include "conformance/model/model_graph.hpp"

namespace robochart::conformance {

/// One `Result`: `differs` or `not_schedulable` with a witness that is made smaller, else `inconclusive` with what was
/// walked. `limits.deadline` is not looked at, `walks.seconds` is.
[[nodiscard]] Result walk(ModelGraph&, const Alphabet&, const rc_interface& code, std::uint32_t cycle_length,
                          const refine::Limits&, const WalkOptions&);

}  // namespace robochart::conformance
