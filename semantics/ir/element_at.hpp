// Which element of the model a place is in: for reports about expressions, which have no names of their own.
#pragma once

#include <string>

#include "diagnostics/source.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// The smallest element of a component, or the function, around a place, with its package: "P::S::t1"; "" where there
/// is none.
[[nodiscard]] std::string element_at(const System&, diagnostics::Span);

}  // namespace robochart::ir
