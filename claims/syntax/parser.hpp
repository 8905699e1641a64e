// SPDX-License-Identifier: Apache-2.0
// Recursive-descent parser of claims (docs/claims.md, "The language"). A word is a keyword only where the grammar
// expects this keyword, so events may have the names of keywords. `^NAME` is always a name.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/words/cursor.hpp"
#include "claims/syntax/lexer.hpp"
#include "claims/syntax/syntax.hpp"

namespace robochart::claims {

/// Returns the advice for syntax errors about common wrong forms (all rows, for tests).
[[nodiscard]] std::span<const diagnostics::Advice> syntax_advice();

/// Parses tokens. After a mistake, it reports one finding and continues at the next claim.
class Parser : private words::Cursor {
public:
    /// The deepest recursion while parsing.
    static constexpr unsigned max_depth = 200;

    Parser(std::vector<Token> tokens, diagnostics::Diagnostics& diagnostics);

    [[nodiscard]] ClaimFile parse_file();

private:
    // tokens
    [[nodiscard]] words::WordUse use_of(std::string_view word) const override;
    [[nodiscard]] bool at_words(std::initializer_list<std::string_view> words) const;
    void skip_to_item();
    [[nodiscard]] bool at_item() const;

    // items
    void parse_item(ClaimFile& file);
    Import parse_import();
    Claim parse_claim();
    std::vector<SetConstant> parse_constants();
    SetConstant parse_constant();
    [[nodiscard]] bool at_constants() const;
    [[nodiscard]] bool at_time(std::size_t ahead) const;
    Order parse_order();
    [[nodiscard]] bool at_duration_of_stay() const;
    [[nodiscard]] bool at_condition() const;
    Body parse_stay(Body body);
    Body parse_possible(Body body);
    Body parse_readiness(Body body);
    Scope parse_scope();
    Body parse_body();
    Body parse_count(Body body);
    Body parse_only(Body body);
    Body parse_leads(Body body);
    Body parse_at_least(Body body);
    void parse_exceptions(Body& body);
    Duration parse_duration();

    // events
    EventSet parse_events();
    Pattern parse_pattern();
    Pattern parse_any(Pattern pattern);
    Pattern parse_change(Pattern pattern);
    [[nodiscard]] bool at_direction() const;

    // conditions
    ExprPtr parse_disjunction();
    ExprPtr parse_conjunction();
    ExprPtr parse_relation();
    ExprPtr parse_sum();
    ExprPtr parse_product();
    ExprPtr parse_operand();
    ExprPtr make_node(Op op, Span from, std::string text, std::vector<ExprPtr> parts) const;
};

}  // namespace robochart::claims
