// SPDX-License-Identifier: Apache-2.0
// Parses CSPM by recursive descent, and operators by precedence climbing (parse_expr.cpp). The precedences are those of
// FDR's own grammar (libcspm, Parser.ppy; levels.hpp).
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/syntax/lexer.hpp"
#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

/// The kind of a list of declarations.
enum class Place { top, module, let, timed, timed_in_module };
/// Returns the kind of the list inside a timed section that is in a list of this kind.
[[nodiscard]] Place timed_inside(Place outer);
/// Returns "in a module" or a similar text if a list of this kind must not contain such a declaration, and ""
/// otherwise.
[[nodiscard]] std::string forbidden_place(DeclKind kind, Place place);
void report_misplaced(const Decl& decl, Place place, diagnostics::Diagnostics& diagnostics);

class Parser {
public:
    /// Limits the recursion of the parser and the height of trees. Chains of operators also make a tree higher.
    static constexpr unsigned max_depth = 800;
    static constexpr unsigned max_height = 4000;

    Parser(const std::vector<Token>& tokens, diagnostics::Diagnostics& diagnostics)
        : tokens_(tokens), diagnostics_(diagnostics) {}

    [[nodiscard]] std::vector<DeclPtr> parse_script();

private:
    struct SyntaxError {};

    // A node with its height, which the parser needs so that no tree exceeds max_height and no pattern exceeds
    // max_depth.
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
    // While it exists, `>` is an operator again. Used for brackets inside a sequence.
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
    [[nodiscard]] bool at_token(Tok kind) const { return peek().kind == kind; }
    const Token& take_token();
    bool accept(Tok kind);
    const Token& expect(Tok kind);
    [[noreturn]] void fail(std::string_view expected);
    /// Returns the opening bracket that the expected closing bracket would close, or null if there is none.
    [[nodiscard]] const Token* open_bracket(std::string_view expected) const;
    /// Throws the error. Selects advice by what the user probably meant; the advice refers to the text at
    /// `about`.
    [[noreturn]] void fail(std::string_view expected, std::string_view advice, Span about);
    [[noreturn]] void fail(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments = {});
    [[nodiscard]] Span span_since(Span from) const;

    // nodes
    [[nodiscard]] static unsigned height_of(const ExprPtr& expr);
    [[nodiscard]] static unsigned height_of(const Decl& decl);
    ExprPtr finish_node(ExprNode node, Span from);
    ExprPtr make_node(ExprKind kind, Span from, std::vector<ExprPtr> args = {});
    DeclPtr finish_node(DeclNode decl, Span from);

    // expressions
    ExprPtr parse_expression(int minimum = 0);
    ExprPtr parse_operand();
    ExprPtr parse_operators(ExprPtr left, int minimum);
    ExprPtr parse_infix(ExprPtr left, ExprKind kind, int level, bool right_associative);
    ExprPtr parse_bracketed_infix(ExprPtr left);
    ExprPtr parse_square_infix(ExprPtr left);
    void half_refinement(const Expr& model, Span process);
    ExprPtr parse_prefix(ExprPtr event);
    ExprPtr parse_postfix(ExprPtr left);
    ExprPtr parse_renaming(ExprPtr process);
    ExprPtr parse_literal();
    ExprPtr parse_name();
    std::string parse_qualified_name();
    ExprPtr parse_parenthesis();
    ExprPtr parse_braces();
    ExprPtr parse_angle_brackets();
    ExprPtr parse_pipe_braces();
    ExprPtr parse_map();
    ExprPtr parse_collection(ExprNode node, Span from, Tok close, const ExprKind (&kinds)[4]);
    ExprPtr parse_let();
    ExprPtr parse_conditional();
    ExprPtr parse_lambda();
    ExprPtr parse_unary(ExprKind kind, int level);
    ExprPtr parse_replicated(ExprKind kind);
    ExprPtr parse_replicated_square();
    ExprPtr parse_replicated_bracketed(ExprKind kind, Tok close);
    ExprPtr parse_replicated_alphabetised();
    std::vector<ExprPtr> parse_expressions(Tok close);
    std::vector<Link> parse_links(Tok arrow);
    std::vector<Clause> parse_clauses();
    std::vector<Clause> parse_optional_clauses();
    Clause parse_clause();
    [[nodiscard]] bool generator_ahead() const;
    [[nodiscard]] bool closes_sequence() const { return open_sequences_ > 0; }
    Field parse_field();

    // patterns
    PatternPtr parse_pattern(int minimum = 0);
    PatternPtr parse_pattern_operand();
    PatternPtr parse_pattern_group(PatternKind kind, Tok close);
    std::vector<PatternPtr> parse_patterns();
    PatternPtr finish_node(PatternNode pattern, Span from);

    // declarations
    std::vector<DeclPtr> parse_declarations(Place place, bool (Parser::*done)() const);
    void skip_malformed_declaration(Span from, bool (Parser::*done)() const);
    DeclPtr parse_declaration(Place place);
    DeclPtr parse_definition();
    DeclPtr parse_channel();
    DeclPtr parse_datatype(DeclKind kind);
    DeclPtr parse_nametype();
    DeclPtr parse_module();
    DeclPtr parse_instance();
    DeclPtr parse_timed(Place place);
    DeclPtr parse_name_list(DeclKind kind);
    DeclPtr parse_annotation();
    DeclPtr parse_print();
    DeclPtr parse_include();
    DeclPtr parse_assertion();
    [[noreturn]] void unknown_property(Span span, const std::string& words);
    void parse_assertion_property(Assertion& assertion, const Token& property);
    void parse_assertion_options(Assertion& assertion);
    ExprPtr parse_trace();
    void check_annotations(const std::vector<DeclPtr>& decls);
    std::vector<std::string> parse_names();
    std::string name_token();
    void skip_newlines();
    [[nodiscard]] bool at_end() const { return at_token(Tok::end); }
    [[nodiscard]] bool at_exports() const { return at_token(Tok::kw_exports) || at_token(Tok::end); }
    [[nodiscard]] bool at_endmodule() const { return at_token(Tok::kw_endmodule) || at_token(Tok::end); }
    [[nodiscard]] bool at_within() const { return at_token(Tok::kw_within) || at_token(Tok::end); }
    [[nodiscard]] bool at_brace() const { return at_token(Tok::r_brace) || at_token(Tok::end); }
    [[nodiscard]] bool annotation_ahead() const;

    // The following functions parse types in annotations, which are stored as text in a canonical form.
    std::string parse_type();
    std::string parse_type_operand(bool& grouped);
    std::string parse_type_scheme();

    const std::vector<Token>& tokens_;
    diagnostics::Diagnostics& diagnostics_;
    std::size_t at_ = 0;
    unsigned depth_ = 0;
    unsigned open_sequences_ = 0;
};

/// Decodes the text between the quotes of a string token.
[[nodiscard]] std::string decode_string(std::string_view token);

}  // namespace robochart::cspm
