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

#include "base/advice/advice.hpp"
#include "base/diagnostics/diagnostic.hpp"
#include "claims/sleec/syntax/lexer.hpp"
#include "claims/sleec/syntax/syntax.hpp"

namespace robochart::sleec {

/// The advice for syntax errors about common wrong forms: all rows, for tests.
[[nodiscard]] std::span<const diagnostics::Advice> syntax_advice();

/// Parses tokens. After a mistake, it reports one finding and continues at the next rule or definition.
class Parser {
public:
    /// The deepest recursion while parsing.
    static constexpr unsigned max_depth = 400;

    Parser(std::vector<Token> tokens, diagnostics::Diagnostics& diagnostics)
        : tokens_(std::move(tokens)), diagnostics_(diagnostics) {}

    [[nodiscard]] RuleFile parse_file();

private:
    struct SyntaxError {};
    using Words = std::vector<std::string>;
    /// Counts the levels of recursion while it exists.
    class Depth {
    public:
        explicit Depth(Parser& parser) : parser_(parser) { parser.enter_level(); }
        ~Depth() { --parser_.depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;

    private:
        Parser& parser_;
    };
    /// A construct of only one dialect.
    struct Feature {
        Dialect dialect;
        Span span;
        std::string what;
    };
    void enter_level();

    // tokens
    [[nodiscard]] const Token& peek(std::size_t ahead = 0) const;
    [[nodiscard]] bool is_at(std::string_view text, std::size_t ahead = 0) const;
    [[nodiscard]] bool at_name(std::size_t ahead = 0) const;
    [[nodiscard]] bool at_end() const { return peek().kind == Tok::end; }
    const Token& take_token();
    bool accept(std::string_view text);
    Span expect(std::string_view text);
    Name name(std::string_view what);
    Name qualified_name(std::string_view what);
    [[nodiscard]] Span span_since(Span from) const;
    /// `words`: the words that are allowed here; the nearest is suggested.
    [[nodiscard]] diagnostics::AdviceWord advice_word(std::ptrdiff_t ahead) const;
    [[noreturn]] void fail(std::string_view expected, const Words& words = {});
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
    ResponsePtr parse_response();        ///< including its defeaters
    ResponsePtr parse_inner_response();  ///< without defeaters, unless it is in braces
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

    std::vector<Token> tokens_;
    diagnostics::Diagnostics& diagnostics_;
    std::set<std::string, std::less<>> events_, measures_;
    std::set<std::string> reported_;  ///< extensions of which only the first is reported
    std::vector<Feature> features_;
    std::size_t at_ = 0;
    unsigned depth_ = 0;
};

}  // namespace robochart::sleec
