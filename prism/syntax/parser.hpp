// SPDX-License-Identifier: Apache-2.0
// Parses PRISM by recursive descent. The operators, lowest precedence first, are: U W R; ? : and => (both
// right-associative); <=>; |; &; !; = !=; < <= > >=; + -; * /; ^ (right-associative); unary minus.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/syntax/lexer.hpp"
#include "prism/syntax/syntax.hpp"

namespace robochart::prism {

/// Parses tokens. After an error, the parser reports one finding and continues after the erroneous text.
class Parser {
public:
    /// Maximal depth of recursion.
    static constexpr unsigned max_depth = 800;

    Parser(std::vector<Token> tokens, diagnostics::Diagnostics& diagnostics)
        : tokens_(std::move(tokens)), diagnostics_(diagnostics) {}

    [[nodiscard]] ModelFile model();
    [[nodiscard]] PropertyFile properties();
    /// Parses the whole text as one expression. Returns null and reports findings if this fails.
    [[nodiscard]] ExprPtr lone_expression();

private:
    struct SyntaxError {};
    /// Counts the levels of recursion during its lifetime.
    class Depth {
    public:
        explicit Depth(Parser& parser) : parser_(parser) { parser.enter_recursion(); }
        ~Depth() { --parser_.depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;

    private:
        Parser& parser_;
    };
    void enter_recursion();

    // tokens
    [[nodiscard]] const Token& peek(std::size_t ahead = 0) const;
    [[nodiscard]] bool at_text(std::string_view text, std::size_t ahead = 0) const;  ///< a word or symbol
    [[nodiscard]] bool at_end() const { return peek().kind == Tok::end; }
    const Token& take_token();
    bool accept(std::string_view text);
    Span expect(std::string_view text);
    Name parse_identifier(std::string_view what);
    /// Letters such as R begin queries in expressions. They are allowed as names of modules and actions, which cannot
    /// occur in expressions.
    Name parse_letter_or_identifier(std::string_view what);
    Name parse_quoted(std::string_view what);
    [[nodiscard]] Span span_since(Span from) const;
    [[noreturn]] void fail(std::string_view expected);
    [[noreturn]] void fail(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments);
    [[noreturn]] void fail_unsupported(std::string_view what, Span span);
    /// Runs a part of the parser. After an error, the parser continues after the next `;` or at a word that begins an
    /// item.
    template <class Piece>
    void parse_with_recovery(const Piece& piece, std::initializer_list<std::string_view> stops);
    void skip_to(std::initializer_list<std::string_view> stops);

    // models
    void parse_item(ModelFile& file);
    void parse_kind_of_model(ModelFile& file);
    void parse_constant(std::vector<Constant>& constants);
    Definition parse_formula();
    Definition parse_label();
    Variable parse_variable();
    void parse_module(ModelFile& file);
    void parse_module_body(Module& module);
    std::vector<Renaming> parse_renamings(std::string_view between, std::string_view end);
    Command parse_command();
    Branch parse_branch();
    Branch parse_update(ExprPtr probability);
    Assignment parse_assignment();
    void parse_rewards(ModelFile& file);
    RewardItem parse_reward_item();
    void parse_initial_states(ModelFile& file);
    void parse_composition(ModelFile& file);
    CompositionPtr parse_parallel();
    CompositionPtr parse_composed();
    CompositionPtr parse_composed_operand();
    static CompositionPtr make_composition(Composition composition);

    // expressions
    ExprPtr parse_expression();  ///< including path operators
    ExprPtr parse_temporal();
    ExprPtr parse_temporal_operand();
    [[nodiscard]] bool at_prefix_operator() const { return at_text("X") || at_text("F") || at_text("G"); }
    [[nodiscard]] bool at_infix_operator() const;
    ExprPtr parse_conditional();
    ExprPtr parse_implication();
    ExprPtr parse_binary(int level);
    ExprPtr make_infix(Op op, ExprPtr left, ExprPtr right);
    ExprPtr parse_negation();
    ExprPtr parse_power();
    ExprPtr parse_prefix();
    ExprPtr parse_primary();
    ExprPtr take_literal(Op op);
    ExprPtr parse_word();
    ExprPtr parse_call(std::string function, Span from);
    ExprPtr parse_filter(Span from);
    ExprPtr make_node(Op op, Span from, std::vector<ExprPtr> parts, std::string text = {});
    ExprPtr make_checked_node(Expr expr, Span from);

    // queries
    [[nodiscard]] bool at_query() const;
    ExprPtr parse_query();
    void parse_reward_index(Query& query);
    void parse_optimum(Query& query);
    void parse_relation(Query& query);
    ExprPtr parse_reward_body();
    ExprPtr parse_old_filter(ExprPtr question, Span from);
    ExprPtr parse_for_paths(Op op);
    std::shared_ptr<const StepBound> parse_steps();

    /// The context in which the parser reads an expression.
    struct Surroundings {
        bool enclosed = false;  ///< in brackets, where `R` is the path operator and does not begin the next query
        bool operand = false;   ///< in the operand of a path operator, outside inner brackets
        bool joined = false;    ///< the operand contains a connective
    };
    static constexpr Surroundings in_brackets{true, false, false};
    /// Sets the context during its lifetime.
    class Within {
    public:
        Within(Parser& parser, Surroundings inside) : parser_(parser), outside_(parser.surroundings_) {
            parser.surroundings_ = inside;
        }
        ~Within() { parser_.surroundings_ = outside_; }
        Within(const Within&) = delete;
        Within& operator=(const Within&) = delete;

    private:
        Parser& parser_;
        Surroundings outside_;
    };
    void record_connective() { surroundings_.joined = surroundings_.operand; }

    std::vector<Token> tokens_;
    diagnostics::Diagnostics& diagnostics_;
    std::size_t at_ = 0;
    unsigned depth_ = 0;
    Surroundings surroundings_;
};

}  // namespace robochart::prism
