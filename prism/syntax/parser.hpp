// SPDX-License-Identifier: Apache-2.0
// Recursive-descent parser for PRISM. Operators from the lowest precedence: U W R, then ? : and => (both
// right-associative), <=>, |, &, !, = !=, < <= > >=, + -, * /, ^ (right-associative), unary minus.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "prism/syntax/lexer.hpp"
#include "prism/syntax/syntax.hpp"
#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism {

/// Parses tokens. After an error it reports one finding and continues after the erroneous part.
class Parser {
public:
    /// Maximal depth of recursion.
    static constexpr unsigned max_depth = 800;

    Parser(std::vector<Token> tokens, diagnostics::Diagnostics& diagnostics)
        : tokens_(std::move(tokens)), diagnostics_(diagnostics) {}

    [[nodiscard]] ModelFile model();
    [[nodiscard]] PropertyFile properties();
    /// Returns the expression if the whole text is one. Otherwise returns null and reports findings.
    [[nodiscard]] ExprPtr lone_expression();

private:
    struct SyntaxError {};
    /// Counts the levels of recursion during its lifetime.
    class Depth {
    public:
        explicit Depth(Parser& parser) : parser_(parser) { parser.deeper(); }
        ~Depth() { --parser_.depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;

    private:
        Parser& parser_;
    };
    void deeper();

    // tokens
    [[nodiscard]] const Token& peek(std::size_t ahead = 0) const;
    [[nodiscard]] bool at(std::string_view text, std::size_t ahead = 0) const;  ///< a word or symbol
    [[nodiscard]] bool at_end() const { return peek().kind == Tok::end; }
    const Token& take();
    bool accept(std::string_view text);
    Span expect(std::string_view text);
    Name identifier(std::string_view what);
    /// Names of modules and actions cannot occur in expressions, so letters such as R, which begin queries there, are
    /// allowed as names.
    Name letter_or_identifier(std::string_view what);
    Name quoted(std::string_view what);
    [[nodiscard]] Span since(Span from) const;
    [[noreturn]] void fail(std::string_view expected);
    [[noreturn]] void fail(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments);
    [[noreturn]] void refuse(std::string_view what, Span span);
    /// Runs a part of the parser; after an error it continues after the next `;` or at a word that begins an item.
    template <class Piece>
    void guarded(const Piece& piece, std::initializer_list<std::string_view> stops);
    void skip(std::initializer_list<std::string_view> stops);

    // models
    void item(ModelFile& file);
    void kind_of_model(ModelFile& file);
    void constant(std::vector<Constant>& constants);
    Definition formula();
    Definition label();
    Variable variable();
    void module(ModelFile& file);
    void module_body(Module& module);
    std::vector<Renaming> renamings(std::string_view between, std::string_view end);
    Command command();
    Branch branch();
    Branch update(ExprPtr probability);
    Assignment assignment();
    void rewards(ModelFile& file);
    RewardItem reward_item();
    void initial_states(ModelFile& file);
    void composition(ModelFile& file);
    CompositionPtr parallel();
    CompositionPtr composed();
    CompositionPtr composed_operand();
    static CompositionPtr make(Composition composition);

    // expressions
    ExprPtr expression();  ///< including path operators
    ExprPtr temporal();
    ExprPtr temporal_operand();
    [[nodiscard]] bool at_prefix_operator() const { return at("X") || at("F") || at("G"); }
    [[nodiscard]] bool at_infix_operator() const;
    ExprPtr conditional();
    ExprPtr implication();
    ExprPtr binary(int level);
    ExprPtr infix(Op op, ExprPtr left, ExprPtr right);
    ExprPtr negation();
    ExprPtr power();
    ExprPtr prefix();
    ExprPtr primary();
    ExprPtr word();
    ExprPtr call(std::string function, Span from);
    ExprPtr filter(Span from);
    ExprPtr node(Op op, Span from, std::vector<ExprPtr> parts, std::string text = {});
    ExprPtr checked(Expr expr, Span from);

    // queries
    [[nodiscard]] bool at_query() const;
    ExprPtr query();
    void reward_index(Query& query);
    void optimum(Query& query);
    void relation(Query& query);
    ExprPtr reward_body();
    ExprPtr old_filter(ExprPtr question, Span from);
    ExprPtr for_paths(Op op);
    std::shared_ptr<const StepBound> steps();

    /// The context in which the parser reads an expression.
    struct Surroundings {
        bool enclosed = false;  ///< in brackets, where `R` is the path operator and not the next query
        bool operand = false;   ///< in the operand of a path operator, outside inner brackets
        bool joined = false;    ///< that operand contains a connective
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
    void join() { surroundings_.joined = surroundings_.operand; }

    std::vector<Token> tokens_;
    diagnostics::Diagnostics& diagnostics_;
    std::size_t at_ = 0;
    unsigned depth_ = 0;
    Surroundings surroundings_;
};

}  // namespace robochart::prism
