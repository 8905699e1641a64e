// SPDX-License-Identifier: Apache-2.0
// Recursive-descent parser of both SLEEC dialects at once. Constructs of only one dialect are recorded and decide the
// dialect of the file. `and` and `or` have the same precedence, are left-associative, and bind less tightly than `not`,
// comparisons, sums and products.
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/words/cursor.hpp"
#include "claims/sleec/syntax/lexer.hpp"
#include "claims/sleec/syntax/syntax.hpp"

namespace robochart::sleec {

/// Returns the advice for syntax errors about common wrong forms (all rows, for tests).
[[nodiscard]] std::span<const diagnostics::Advice> syntax_advice();

/// Parses tokens. After a mistake, it reports one finding and continues at the next rule or definition.
class Parser : private words::Cursor {
public:
    /// The deepest recursion while parsing.
    static constexpr unsigned max_depth = 400;

    Parser(std::vector<Token> tokens, diagnostics::Diagnostics& diagnostics);

    [[nodiscard]] RuleFile parse_file();

private:
    /// A construct of only one dialect.
    struct Feature {
        Dialect dialect;
        Span span;
        std::string what;
    };
    // tokens
    [[nodiscard]] words::WordUse use_of(std::string_view word) const override;
    [[noreturn]] void refuse_construct(std::string_view what, Span span);
    void only_in(Dialect dialect, Span span, std::string_view what) {
        features_.push_back({dialect, span, std::string(what)});
    }
    void report_extension(Span span, std::string_view what);
    void report_first_extension(Span span, const std::string& what);
    template <class Piece>
    bool parse_guarded(const Piece& piece);
    [[nodiscard]] bool at_item() const;
    template <class Item>
    void parse_block(std::string_view end, const Item& item);

    // definitions
    void parse_definition(RuleFile& file);
    Measure parse_measure();
    Constant parse_constant();
    Mapping parse_mapping();

    // rules
    Rule parse_rule();
    Rule when_rule(Rule rule);
    Rule after_rule(Rule rule);
    Rule at_least_rule(Rule rule);
    Property parse_property(bool concern);
    Trigger parse_trigger();
    EventName parse_event();
    ExprPtr parse_argument();
    ResponsePtr parse_response();        ///< parses the defeaters, too
    ResponsePtr parse_inner_response();  ///< parses no defeaters, unless the response is in braces
    Response parse_action();
    void parse_alternative(Response& response);
    Limit parse_limit();
    Limit parse_duration(Span from);
    Unit parse_unit();
    ExprPtr parse_time();

    // conditions
    ExprPtr parse_condition();
    ExprPtr parse_term();
    ExprPtr parse_relation();
    ExprPtr parse_sum();
    ExprPtr parse_product();
    ExprPtr parse_primary();
    ExprPtr parse_word();
    ExprPtr make_node(Op op, Span from, std::vector<ExprPtr> parts);
    void warn_mixed(const ExprPtr& whole);

    void decide_dialect(RuleFile& file);

    std::set<std::string, std::less<>> events_, measures_;
    std::set<std::string> reported_;  ///< extensions of which only the first is reported
    std::vector<Feature> features_;
};

}  // namespace robochart::sleec
