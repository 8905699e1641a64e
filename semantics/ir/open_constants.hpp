// Constants that the model leaves open, where a value was needed.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/source.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// The constants without a value in the model that divisors inside this place of the model are made of, by their names,
/// each once: such a constant is 0 unless somebody gives it a value. A block Instantiations that names one may do so:
/// it is left out.
[[nodiscard]] std::vector<std::string> open_divisors(const System&, diagnostics::Span place);

}  // namespace robochart::ir
