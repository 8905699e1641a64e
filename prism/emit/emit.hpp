// SPDX-License-Identifier: Apache-2.0
// Encodes a module in PRISM, rule by rule, as RoboTool does (translate2prism). docs/prism-encoding.md contains the
// rules R1 to R16, and the sources quote each rule where they implement it. In a dtmc every step takes part in a
// uniform choice, so the number and kind of steps affect all results. Therefore the encoding has the same steps as
// RoboTool's encoding. Names and order may differ.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/emit/emission.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::prism_emit {

/// Returns the ranges of numbers in a finite instantiation.
[[nodiscard]] Preferences preferences_of(const ir::Instantiation&);

/// Encodes the module in PRISM. Constants without a value stay open. Returns no value and reports findings if a
/// construct is not supported. `functions` take precedence over the model's definitions.
[[nodiscard]] std::optional<Emission> emit(const ir::System&, const ir::Module&, const Preferences&,
                                           diagnostics::Diagnostics&, const Functions& functions = {});

/// Returns the text of the file: first the model, with updates restricted to their ranges (ranges.hpp), then the names
/// as comments (R1).
[[nodiscard]] std::string file_text(const Emission&);
/// Returns whether the text was written by `file_text` or by RoboTool.
[[nodiscard]] bool is_of_robochart(std::string_view text);

}  // namespace robochart::prism_emit
