// Seeded faults in expressions: the expression that a faulty generator would have written.
#pragma once

#include <optional>

#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// What is written in place of the expression; nothing where this run has no fault here.
[[nodiscard]] std::optional<ir::Expr> faulty(const Generation&, const Unit&, const ir::Expr&);

}  // namespace robochart::cpp_emit
