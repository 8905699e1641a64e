// Assertions of the model as CSPM assertions (assertions.md, section 4: the table).
#pragma once

#include "csp_emit/component.hpp"

namespace robochart::csp_emit {

/// One obligation for each property that is decided in this time, then the generated core assertions if asked for.
[[nodiscard]] std::vector<Obligation> obligations(const Project&, const Emitted&);

}  // namespace robochart::csp_emit
