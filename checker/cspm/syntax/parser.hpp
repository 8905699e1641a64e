// SPDX-License-Identifier: Apache-2.0
// Recursive-descent parser for CSPM; operators by precedence climbing. The precedence table is that of FDR's own
// grammar (libcspm, Parser.ppy), lowest first; see parse_expr.cpp.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "checker/cspm/syntax/lexer.hpp"
#include "checker/cspm/syntax/syntax.hpp"
#include "base/diagnostics/diagnostic.hpp"

namespace robochart::cspm {

/// The kind of list that contains a declaration.
enum class Place { top, module, let, timed, timed_in_module };
/// The kind of list inside a timed section that is in a list of this kind.
[[nodiscard]] Place timed_inside(Place outer);
/// The place where a declaration of this kind is forbidden: "in a module"; "" if it is allowed.
[[nodiscard]] std::string misplaced(DeclKind kind, Place place);
void report_misplaced(const Decl& decl, Place place, diagnostics::Diagnostics& diagnostics);

class Parser {
public:
    /// Maximal depth of recursion, and maximal height of a tree (chains of operators also increase the height).
    static constexpr unsigned max_depth = 800;
    static constexpr unsigned max_height = 4000;

    Parser(const std::vector<Token>& tokens, diagnostics::Diagnostics& diagnostics)
        : tokens_(tokens), diagnostics_(diagnostics) {}

    [[nodiscard]] std::vector<DeclPtr> script();

private:
    struct SyntaxError {};

    // Nodes store their height during parsing, so that no tree becomes higher than max_height, and no pattern higher
    // than max_depth.
    struct ExprNode : Expr {
        unsigned height = 0;
    };
    struct DeclNode : Decl {
        unsigned height = 0;
    };
    struct PatternNode : Pattern {
        unsigned height = 0;
    };
    class Depth {
    public:
        explicit Depth(Parser& parser);
        ~Depth() { --parser_.depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;

    private:
        Parser& parser_;
    };
    // Inside brackets a `>` is an operator, even if they are inside a sequence.
    class Bracket {
    public:
        explicit Bracket(Parser& parser) : parser_(parser), open_(std::exchange(parser.open_sequences_, 0)) {}
        ~Bracket() { parser_.open_sequences_ = open_; }
        Bracket(const Bracket&) = delete;
        Bracket& operator=(const Bracket&) = delete;

    private:
        Parser& parser_;
        unsigned open_;
    };

    // tokens
    [[nodiscard]] const Token& peek(std::size_t ahead = 0) const;
    [[nodiscard]] bool at(Tok kind) const { return peek().kind == kind; }
    const Token& take();
    bool accept(Tok kind);
    const Token& expect(Tok kind);
    [[noreturn]] void fail(std::string_view expected);
    /// Returns the opening bracket that matches the expected closing bracket, or null if there is none.
    [[nodiscard]] const Token* open_bracket(std::string_view expected) const;
    /// The same with advice about the probable meaning. `about` is the part of the text that shows it.
    [[noreturn]] void fail(std::string_view expected, std::string_view advice, Span about);
    [[noreturn]] void fail(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments = {});
    [[nodiscard]] Span since(Span from) const;

    // nodes
    [[nodiscard]] static unsigned height(const ExprPtr& expr);
    [[nodiscard]] static unsigned height(const Decl& decl);
    ExprPtr finish(ExprNode node, Span from);
    ExprPtr node(ExprKind kind, Span from, std::vector<ExprPtr> args = {});
    DeclPtr finish(DeclNode decl, Span from);

    // expressions
    ExprPtr expression(int minimum = 0);
    ExprPtr operand();
    ExprPtr climb(ExprPtr left, int minimum);
    ExprPtr infix(ExprPtr left, ExprKind kind, int level, bool right_associative);
    ExprPtr bracketed_infix(ExprPtr left);
    ExprPtr square_infix(ExprPtr left);
    void half_refinement(const Expr& model, Span process);
    ExprPtr prefixed(ExprPtr event);
    ExprPtr postfix(ExprPtr left);
    ExprPtr rename(ExprPtr process);
    ExprPtr literal();
    ExprPtr name();
    std::string qualified();
    ExprPtr parenthesis();
    ExprPtr braces();
    ExprPtr angles();
    ExprPtr pipe_braces();
    ExprPtr map();
    ExprPtr collection(ExprNode node, Span from, Tok close, const ExprKind (&kinds)[4]);
    ExprPtr let();
    ExprPtr conditional();
    ExprPtr lambda();
    ExprPtr unary(ExprKind kind, int level);
    ExprPtr replicated(ExprKind kind);
    ExprPtr replicated_square();
    ExprPtr replicated_bracketed(ExprKind kind, Tok close);
    ExprPtr alphabetised_replication();
    std::vector<ExprPtr> expressions(Tok close);
    std::vector<Link> links(Tok arrow);
    std::vector<Clause> clauses();
    std::vector<Clause> optional_clauses();
    Clause clause();
    [[nodiscard]] bool generator_ahead() const;
    [[nodiscard]] bool closes_sequence() const { return open_sequences_ > 0; }
    Field field();

    // patterns
    PatternPtr pattern(int minimum = 0);
    PatternPtr pattern_operand();
    PatternPtr pattern_group(PatternKind kind, Tok close);
    std::vector<PatternPtr> patterns();
    PatternPtr finish(PatternNode pattern, Span from);

    // declarations
    std::vector<DeclPtr> declarations(Place place, bool (Parser::*done)() const);
    void recover(Span from, bool (Parser::*done)() const);
    DeclPtr declaration(Place place);
    DeclPtr definition();
    DeclPtr channel();
    DeclPtr datatype(DeclKind kind);
    DeclPtr nametype();
    DeclPtr module();
    DeclPtr instance();
    DeclPtr timed(Place place);
    DeclPtr named(DeclKind kind);
    DeclPtr annotation();
    DeclPtr print();
    DeclPtr include();
    DeclPtr assertion();
    [[noreturn]] void unknown_property(Span span, const std::string& words);
    void assertion_property(Assertion& assertion, const Token& property);
    void assertion_options(Assertion& assertion);
    ExprPtr trace();
    void check_annotations(const std::vector<DeclPtr>& decls);
    std::vector<std::string> names();
    std::string name_token();
    void newlines();
    [[nodiscard]] bool at_end() const { return at(Tok::end); }
    [[nodiscard]] bool at_exports() const { return at(Tok::kw_exports) || at(Tok::end); }
    [[nodiscard]] bool at_endmodule() const { return at(Tok::kw_endmodule) || at(Tok::end); }
    [[nodiscard]] bool at_within() const { return at(Tok::kw_within) || at(Tok::end); }
    [[nodiscard]] bool at_brace() const { return at(Tok::r_brace) || at(Tok::end); }
    [[nodiscard]] bool annotation_ahead() const;

    // types in annotations, stored as text in a canonical form
    std::string type();
    std::string type_operand(bool& grouped);
    std::string type_scheme();

    const std::vector<Token>& tokens_;
    diagnostics::Diagnostics& diagnostics_;
    std::size_t at_ = 0;
    unsigned depth_ = 0;
    unsigned open_sequences_ = 0;
};

/// Decodes the text between the quotes of a string token.
[[nodiscard]] std::string decode_string(std::string_view token);

}  // namespace robochart::cspm
