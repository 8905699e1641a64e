// What can't be generated is refused by name before any code is written.
#pragma once

#include "cpp_emit/component.hpp"

namespace robochart::cpp_emit {

/// Reports every construct of the component that has no C++ (rules.hpp); true if there is none.
[[nodiscard]] bool check_support(const ir::System&, const ir::Instantiation&, const Component&,
                                 diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
