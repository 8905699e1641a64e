// SPDX-License-Identifier: Apache-2.0
// Formats assertion files, with one assertion per line. CSP blocks and parts for other tools are copied unchanged.
// Private to the formatter.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "frontend/format/format_expressions.hpp"

namespace robochart::frontend {

/// Formats an assertion file. The object stores the spans of the parts for other tools that it has not written yet.
class AssertionLayout final : public ExpressionLayout {
public:
    /// `foreign_spans` contains the spans of the parts for other tools, in textual order.
    AssertionLayout(std::string_view text, const TokenStream& stream, std::vector<diagnostics::Span> foreign_spans)
        : ExpressionLayout(text, stream, true), kept_(std::move(foreign_spans)) {}

private:
    Doc format_member(Gap gap) override;
    Doc format_assertion(Gap gap);
    Doc assertion_body();
    Doc format_property();
    Doc format_hyphenated();
    Doc format_parameters();
    Doc format_parameter(Gap gap);
    Doc csp_block(Gap gap);
    Doc format_simulation(Gap gap);
    Doc format_kept_part(Gap gap);

    // Probabilistic assertions (format_probability.cpp)
    [[nodiscard]] bool at_probabilistic_part() const;
    Doc probabilistic_part(Gap gap);
    Doc probabilistic_assertion(Gap gap);
    Doc format_definition(Gap gap);
    Doc format_generation();
    Doc format_clauses();
    Doc written_clause();
    Doc format_constants(Gap first);
    Doc constant_values(Gap gap);
    Doc format_rewards();
    Doc format_functions();
    Doc format_modules();
    Doc reward_item(Gap gap);
    Doc format_function(Gap gap);
    Doc format_module(Gap gap);
    Doc module_member(Gap gap);
    Doc format_updates(Gap gap);

    std::vector<diagnostics::Span> kept_;
    std::size_t kept_at_ = 0;  ///< index of the next part for another tool
};

}  // namespace robochart::frontend
