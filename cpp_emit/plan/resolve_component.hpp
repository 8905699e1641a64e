// From a reference to a component of the IR to what is generated for it.
#pragma once

#include <optional>

#include "cpp_emit/plan/component.hpp"
#include "diagnostics/diagnostic.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Follows the reference and collects the above. Reports what can't be generated; nothing on errors.
[[nodiscard]] std::optional<Component> resolve(const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
                                               diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
