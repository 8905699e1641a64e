// The layout of assertion files: an assertion a line; CSP blocks and PRISM parts as they are written (private to the
// formatter).
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "frontend/format/format_expressions.hpp"

namespace robochart::frontend {

/// Knows which PRISM parts follow.
class AssertionLayout final : public ExpressionLayout {
public:
    /// `verbatim`: lengths of the PRISM parts, in order.
    AssertionLayout(std::string_view text, const TokenStream& stream, std::vector<std::size_t> verbatim)
        : ExpressionLayout(text, stream, true), verbatim_(std::move(verbatim)) {}

private:
    Doc member(Gap gap) override;
    Doc assertion(Gap gap);
    Doc assertion_body();
    Doc property();
    Doc hyphenated();
    Doc parameters();
    Doc parameter(Gap gap);
    Doc csp_block(Gap gap);
    Doc verbatim(Gap gap);

    std::vector<std::size_t> verbatim_;
    std::size_t verbatim_at_ = 0;  ///< the next PRISM part
};

}  // namespace robochart::frontend
