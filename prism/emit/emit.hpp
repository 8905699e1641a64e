// SPDX-License-Identifier: Apache-2.0
// RoboTool's encoding of a module in PRISM (translate2prism), rule by rule. docs/prism-encoding.md contains the rules
// R1 to R16, and the sources quote each rule where they implement it. In a dtmc every step takes part in a uniform
// choice, so the number and kind of steps affect all results. So the encoding has the same steps as RoboTool's; names
// and order may differ.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/emit/emission.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::prism_emit {

/// The ranges of numbers in a finite instantiation.
[[nodiscard]] Preferences preferences_of(const ir::Instantiation&);

/// Encodes the module in PRISM. Constants without a value stay open. Returns no value, with findings, if the encoding
/// does not support some construct. `functions` take precedence over the model's definitions.
[[nodiscard]] std::optional<Emission> emit(const ir::System&, const ir::Module&, const Preferences&,
                                           diagnostics::Diagnostics&, const Functions& functions = {});

/// The text of the file: the model with updates restricted to their ranges (ranges.hpp), then the names as comments
/// (R1).
[[nodiscard]] std::string file_text(const Emission&);
/// Whether the text was written by `file_text` or by RoboTool.
[[nodiscard]] bool is_of_robochart(std::string_view text);

}  // namespace robochart::prism_emit
