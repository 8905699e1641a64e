// SPDX-License-Identifier: Apache-2.0
// The layout of assertion files: one assertion a line. CSP blocks and parts of other tools are kept unchanged (private
// to the formatter).
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "frontend/format/format_expressions.hpp"

namespace robochart::frontend {

/// Holds the spans of the parts of other tools that have not been written yet.
class AssertionLayout final : public ExpressionLayout {
public:
    /// `kept`: the spans of the parts of other tools, in textual order.
    AssertionLayout(std::string_view text, const TokenStream& stream, std::vector<diagnostics::Span> kept)
        : ExpressionLayout(text, stream, true), kept_(std::move(kept)) {}

private:
    Doc member(Gap gap) override;
    Doc assertion(Gap gap);
    Doc assertion_body();
    Doc property();
    Doc hyphenated();
    Doc parameters();
    Doc parameter(Gap gap);
    Doc csp_block(Gap gap);
    Doc kept(Gap gap);

    // Probabilistic assertions (format_probability.cpp)
    [[nodiscard]] bool at_probabilistic_part() const;
    Doc probabilistic_part(Gap gap);
    Doc probabilistic_assertion(Gap gap);
    Doc definition(Gap gap);
    Doc generation();
    Doc clauses();
    Doc written_clause();
    Doc constants(Gap first);
    Doc constant_values(Gap gap);
    Doc rewards();
    Doc functions();
    Doc modules();
    Doc reward_item(Gap gap);
    Doc function(Gap gap);
    Doc module(Gap gap);
    Doc module_member(Gap gap);
    Doc updates(Gap gap);

    std::vector<diagnostics::Span> kept_;
    std::size_t kept_at_ = 0;  ///< the next part of another tool
};

}  // namespace robochart::frontend
