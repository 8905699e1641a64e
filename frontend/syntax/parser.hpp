// SPDX-License-Identifier: Apache-2.0
// Parses the tokens of one file by recursive descent (private to the front end). The productions are those of the
// public RoboChart.xtext and Assertions.xtext, and of RoboSim.xtext in files of that dialect. The name of a method is
// the construct that the method parses. A construct of the other dialect is reported and parsed (parser_robosim.cpp).
//
// Recovery: a missing token is assumed to be present, and a superfluous token is skipped, once per mistake. If this
// does not repair the text, the parser throws a SyntaxError. The nearest member list catches the exception and skips to
// the next member. Elements are added to their owner before their body is parsed, so that the tree contains the part
// before an error. Names in text that could not be parsed are recorded, so that they are not reported as unknown.
#pragma once

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/syntax/ast.hpp"
#include "frontend/syntax/foreign_words.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// The deepest accepted nesting of brackets, statements, types and composite states.
inline constexpr std::size_t max_depth = 256;
/// The greatest accepted height of expression trees, including chains of operators.
inline constexpr std::uint32_t max_height = 1000;
/// Parsing stops after this number of mistakes in a file.
inline constexpr std::size_t max_mistakes = 100;

class Parser {
public:
    Parser(const diagnostics::SourceManager& sources, diagnostics::SourceId source, bool is_assertions,
           diagnostics::Diagnostics& out);
    std::unique_ptr<File> parse_file();

private:
    struct SyntaxError {};
    struct GiveUp {};
    /// Counts one level of nesting while the object exists.
    struct Nesting {
        explicit Nesting(Parser& parser);
        ~Nesting() { --parser_.depth_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;

    private:
        Parser& parser_;
    };
    /// The kinds of members that a body may contain.
    enum Members : unsigned {
        context_members = 1,     ///< uses, requires, provides, var, const, event, clock, op()
        node_members = 2,        ///< nodes and transitions
        action_members = 4,      ///< entry, during, exit
        controller_members = 8,  ///< operation, opref, stm, sref, connection
        module_members = 16,     ///< platforms, controllers, machines, connection
        contract_members = 32,   ///< terminates, precondition, postcondition
        register_members = 64,   ///< RoboSim: uses, requires, event
    };

    // Tokens (parser.cpp)
    [[nodiscard]] Token peek(std::size_t ahead = 0) const { return tokens_.token_at(at_ + ahead); }
    [[nodiscard]] Token previous_token() const { return tokens_[at_ > 0 ? at_ - 1 : 0]; }
    [[nodiscard]] bool at_token(std::string_view word) const { return peek().is_word(word); }
    /// True if the next token is this word, reserved or not. (Assertions reserve more words than models.)
    [[nodiscard]] bool at_word(std::string_view word, std::size_t ahead = 0) const;
    [[nodiscard]] bool at_end() const { return peek().kind == TokenKind::end; }
    Token advance_token();
    bool accept_token(std::string_view word);
    bool accept_word(std::string_view word);
    /// Consumes the word and returns its place. If the word is missing, reports this.
    Span expect_token(std::string_view word);
    void expect_word(std::string_view word);
    void name(Declaration& declaration);
    QualifiedName simple_name(std::string_view what);
    /// Parses a simple name at a place where authors tend to write `A::B`.
    QualifiedName plain_name(std::string_view what);
    QualifiedName qualified_name(std::string_view what);
    void add_part(QualifiedName& name, std::string_view what);
    [[nodiscard]] Span span_since(const Span& begin) const {
        return diagnostics::join_spans(begin, previous_token().span);
    }
    [[nodiscard]] std::string describe_token() const;
    [[nodiscard]] bool at_follower() const;

    // Mistakes and recovery (parser.cpp)
    // Reports a mistake. Returns the finding, or null if the mistake follows from one that was reported already.
    diagnostics::Diagnostic* report(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments = {});
    [[noreturn]] void report_and_throw(const diagnostics::Rule& rule, Span span,
                                       std::vector<std::string> arguments = {});
    [[noreturn]] void too_deep(std::size_t limit);
    [[noreturn]] void fail_expecting(std::string_view what);
    /// Reports a missing token. Parsing continues as if the token were present, but a second failure in a row is
    /// thrown.
    diagnostics::Diagnostic* report_missing(std::string_view what);
    [[nodiscard]] Span missing_place() const;
    void needs_parentheses(std::string_view what, Span span);
    [[nodiscard]] bool behind_strange_characters() const;
    void mark_lost_names(std::size_t begin, std::size_t end);
    bool neural_construct();
    [[nodiscard]] std::size_t indentation_of(std::size_t token) const;
    /// If a closing bracket was expected, adds a note at the opening bracket if it is on another line.
    void point_to_open(std::string_view what, diagnostics::Diagnostic& finding) const;
    /// Returns the advice of foreign_forms() about the tokens here, or "" if there is none.
    [[nodiscard]] std::string_view form_meant(std::string_view expected) const;
    [[nodiscard]] std::optional<std::size_t> unclosed_brace(bool& by_indentation) const;
    [[nodiscard]] bool stray_brace(std::size_t open) const;
    void pass_stray_brace();
    /// If the next token is a misspelling of one of these reserved words, reports this and reads it as the intended
    /// word.
    bool correct_word(std::initializer_list<std::string_view> keywords);
    /// Reports a word that begins no member, and throws. A misspelt word is corrected in place, so that the member list
    /// can parse the member.
    [[noreturn]] void wrong_word(std::string_view what, std::initializer_list<ForeignPlace> places);
    /// Reports a word of another notation with RoboChart's equivalent. If the equivalent is a single word, it replaces
    /// the word. Otherwise the mistake is thrown. Returns false if the word belongs to no other notation.
    bool replace_foreign(ForeignPlace place);
    /// Reports a word that RoboChart does not need, with a fix that removes it, and skips the word.
    void pass_superfluous(std::string_view reason);
    /// Skips `:` or `=` after the word that begins a clause or an action.
    void pass_sign_behind_word();
    /// Reports two consecutive words of another notation, and interprets them as `instead`.
    void replace_two_words(std::string_view instead, std::string_view reason);
    [[nodiscard]] bool state_machine_words();
    [[nodiscard]] bool typed_like_c();
    [[nodiscard]] bool pseudo_state(DeclKind kind);
    [[nodiscard]] bool foreign_operator();
    void bracketed_guard(Transition& transition);
    [[nodiscard]] int forgotten_trigger(Transition& transition);
    bool called_reset(Transition& transition);
    void ends_by_arrow(Transition& transition);
    [[nodiscard]] bool at_foreign_statement() const;
    StmtPtr updating_statement();
    StmtPtr clock_set_to_zero();
    [[nodiscard]] bool names_clock(std::string_view word) const;
    StmtPtr braced_if(StmtPtr begun);
    StmtPtr braced_statement();
    void bracketed_event(Event& event);
    void clock_with_value();
    [[nodiscard]] bool bare_async();
    [[nodiscard]] bool parse_percentage(Expr& number);
    [[nodiscard]] bool body_left_out();
    [[nodiscard]] std::string_view meant_word();
    [[nodiscard]] bool take_correction();
    template <class Body>
    bool catch_syntax_error(Body body);
    template <class Read>
    auto note_failures(Read read);
    void skip_balanced();
    void skip_to_member();
    [[nodiscard]] bool at_top_level_word() const;
    [[nodiscard]] bool at_member_word() const;
    [[nodiscard]] std::vector<std::string> known_member_words() const;
    [[nodiscard]] bool closes_missing_brace(unsigned members) const;

    // Declarations (parser_declarations.cpp)
    void package_clause(File& file);
    void parse_import(File& file);
    void parse_diagram(File& file);
    void top_level(File& file);
    std::unique_ptr<Declaration> parse_declaration();
    std::unique_ptr<Declaration> type_declaration();
    std::unique_ptr<Declaration> record_type();
    std::unique_ptr<Declaration> parse_enumeration();
    void pass_separator(std::string_view reason);
    std::unique_ptr<Declaration> parse_function();
    std::unique_ptr<Declaration> parse_interface();
    std::unique_ptr<Context> parse_platform();
    void parse_variable(std::vector<VariablePtr>& list, DeclKind kind);
    void type_before_name(Variable& variable);
    [[nodiscard]] static bool names_core_type(std::string_view word);
    std::vector<VariablePtr> parse_parameters();
    template <class Member>
    void parse_braces(Member member, unsigned members);

    // Contexts, components, machines (parser_components.cpp)
    bool context_member(Context& context);
    void interface_clause(Context& context);
    void old_list(Span comma, std::string_view word);
    void variable_list(Context& context);
    void parse_event(Context& context);
    void parse_clock(Context& context);
    void operation_signature(Context& context);
    std::unique_ptr<Machine> parse_machine();
    std::unique_ptr<Machine> parse_operation();
    std::unique_ptr<Component> parse_controller();
    std::unique_ptr<Component> parse_module();
    void controller_member(Component& component);
    void module_member(Component& component);
    std::unique_ptr<Reference> parse_reference();
    std::unique_ptr<Connection> parse_connection();
    void connection_end(Connection::End& end);
    bool machine_part(Component& component);
    bool contract_member(Machine& machine);
    bool node_member(NodeContainer& container);
    void parse_node(NodeContainer& container, DeclKind kind);
    void state_body(State& state);
    void parse_action(State& state);
    void parse_transition(NodeContainer& container);
    void transition_body(Transition& transition, bool braced = true);
    void unbraced_transition(Transition& transition);
    int transition_clause(Transition& transition);
    [[nodiscard]] diagnostics::FixIt moved_before(std::size_t clause, const std::array<std::size_t, 6>& begins,
                                                  int kind) const;
    void parse_trigger(Transition& transition);
    void reset(Transition& transition);

    // RoboSim (parser_robosim.cpp)
    [[nodiscard]] bool is_robosim() const { return dialect_ == Dialect::robosim; }
    void refuse_dialect(Span span, std::string_view written, std::string_view instead);
    void refuse_robochart(Span span, std::string_view written, std::string_view instead);
    bool robosim_member(Context& context);
    void cycle_definition(Context& context);
    void register_context(Context& context);
    void register_member(Context& registers);
    bool exec_clause(Transition& transition);
    StmtPtr exec_statement();
    StmtPtr register_statement();
    void check_plain_communication(const Stmt& statement);
    ExprPtr parse_register();
    void register_store(Expr& read);
    ExprPtr parse_cycle();
    [[nodiscard]] bool at_simulation() const;
    void parse_simulation(File& file);
    void simulation_member(Simulation& simulation);
    bool schedulable_property(Assertion& assertion);
    bool cycle_parameter(AssertionParameter& parameter);
    void refuse_untimed(AssertionTime time, Span word);

    // Types (parser_types.cpp)
    TypeExprPtr parse_type();
    TypeExprPtr function_type();
    TypeExprPtr product_type();
    TypeExprPtr vector_type();
    TypeExprPtr atomic_type();
    TypeExprPtr spaced_set();
    TypeExprPtr wrap_type(TypeKind kind, TypeExprPtr first, Span begin);

    // Statements (parser_statements.cpp)
    StmtPtr parse_statement();
    [[nodiscard]] bool at_statement() const;
    bool missing_semicolon();
    [[nodiscard]] bool at_body_end() const;
    StmtPtr timed_statement();
    StmtPtr basic_statement();
    StmtPtr if_statement();
    void if_without_end(Span word);
    StmtPtr wait_statement();
    StmtPtr name_statement();
    StmtPtr communication_statement();
    StmtPtr parse_assignment();
    [[nodiscard]] bool looks_like_assignment(std::size_t behind_name = 1) const;
    [[nodiscard]] std::optional<std::size_t> behind_brackets(std::size_t ahead) const;
    std::unique_ptr<Communication> parse_communication();
    [[nodiscard]] bool repair_assignment();
    void communication_predicate(Communication& communication);
    ExprPtr communicated_value();

    // Operators (parser_expressions.cpp)
    ExprPtr parse_expression();
    ExprPtr parse_quantified();
    ExprPtr parse_operand(int level);
    ExprPtr parse_prefix(int level);
    ExprPtr logical_not(int level);
    ExprPtr parse_description(int level);
    ExprPtr parse_let(int level);
    ExprPtr parse_conditional(int level);
    ExprPtr parse_negation();
    ExprPtr parse_postfix();
    ExprPtr parse_steps(ExprPtr left, bool assigned);
    ExprPtr parse_call();
    ExprPtr parse_infix(ExprPtr left, BinaryOp op, int level);
    ExprPtr parse_cast(ExprPtr left);
    [[nodiscard]] std::optional<std::pair<BinaryOp, int>> operator_here() const;
    [[nodiscard]] bool at_quantifier() const;
    [[nodiscard]] bool at_member_step() const;
    [[nodiscard]] bool repair_equality(int level);
    void check_weak_prefix(const Token& word, const Expr& read, int level, int own_level);
    void report_c_operator(std::string_view meant);
    bool missing_comma();
    ExprPtr missing_expression();
    void parse_bindings(Expr& expr);
    void such_that(Expr& expr);
    void expression_list(std::vector<ExprPtr>& list, std::string_view close);
    ExprPtr make_expression(ExprKind kind);
    ExprPtr finish_node(ExprPtr expr, Span begin);

    // Atoms (parser_atoms.cpp)
    ExprPtr parse_atom();
    ExprPtr parse_literal(ExprKind kind);
    void pass_suffix();
    ExprPtr parse_named();
    ExprPtr parse_record(QualifiedName name);
    ExprPtr parse_bracketed();
    ExprPtr parenthesised_or_range();
    ExprPtr closed_range();
    ExprPtr parse_tuple();
    ExprPtr parse_sequence();
    ExprPtr sequence_element();
    ExprPtr parse_set();
    ExprPtr parse_comprehension(Span begin);
    ExprPtr parse_matrix();
    ExprPtr keyword_atom();
    void range_end(Expr& range);

    // Assertions (parser_assertions.cpp)
    void assertion_member(File& file);
    void parse_assertion(File& file, AssertionTime time);
    void assertion_name(Assertion& assertion);
    void rule_assertion(File& file);
    void assertion_body(Assertion& assertion, Span time_word);
    void refuse_time(AssertionTime time, Span word);
    void assertion_event(Assertion& assertion);
    [[noreturn]] void unknown_property();
    void pass_model_hyphen();
    void assertion_is(Assertion& assertion);
    void assertion_does(Assertion& assertion);
    void assertion_model(Assertion& assertion);
    void assertion_parameters(Assertion& assertion);
    AssertionParameter assertion_parameter();
    void csp_block(File& file, AssertionTime time);
    void keep_as_text(File& file);
    void hyphenated_word(std::string_view first, std::string_view second);
    [[nodiscard]] bool at_foreign_assertion() const;
    void foreign_assertion(File& file);
    [[nodiscard]] KeptPart kept_part() const;
    [[nodiscard]] bool at_assertion_member() const;
    [[nodiscard]] bool at_kept_part() const;
    [[nodiscard]] bool at_claim() const;

    // Probabilistic assertions (parser_probability.cpp)
    [[nodiscard]] bool at_probabilistic_part() const;
    void probabilistic_part(File& file);
    void probabilistic_assertion(File& file);
    void probabilistic_definition(File& file);
    void definition_body(ProbabilisticDefinition& definition);
    void definition_name(std::string& name, Span& span);
    PathGeneration path_generation();
    void probabilistic_clauses(ProbabilisticAssertion& assertion);
    ProbabilisticClause probabilistic_clause(ProbabilisticKind kind);
    ConstantValues constant_values();
    std::vector<ConstantValues> constant_list();
    std::vector<RewardItem> reward_items();
    ProbabilisticFunction probabilistic_function();
    ProbabilisticModule probabilistic_module();
    ModuleVariable module_variable();
    Command parse_command();
    Update parse_update();
    std::vector<Update> parse_updates();
    ExprPtr action_label();
    void prism_query();
    [[nodiscard]] std::string prism_path(std::size_t begin, std::size_t end) const;
    ExprPtr probabilistic_atom();
    [[nodiscard]] bool at_path_prefix() const;
    ExprPtr path_prefix();
    ExprPtr parse_until(ExprPtr left);
    void step_bound(Expr& path);
    ExprPtr parse_quantitative(ExprKind kind);
    ExprPtr reward_path();
    ExprPtr parse_simulation();
    ExprPtr path_quantifier(ExprKind kind);
    ExprPtr parse_marked();
    ExprPtr behind_name(ExprPtr name);

    const diagnostics::SourceManager& sources_;
    diagnostics::SourceId source_;
    bool is_assertions_;
    Dialect dialect_;
    bool probabilistic_ = false;  ///< inside a probabilistic assertion, where expressions have more forms
    diagnostics::Diagnostics& out_;
    TokenList tokens_;
    std::vector<Span> comments_;
    /// The beginnings of lines. They are stored because a backward search from every brace would take too long on a
    /// long line.
    std::vector<std::size_t> line_begins_{0};
    std::size_t at_ = 0;
    std::size_t depth_ = 0;
    std::size_t mistakes_ = 0;
    std::size_t failures_ = 0;     ///< all mistakes, including those that follow from others
    std::size_t quiet_until_ = 0;  ///< mistakes before this token follow from a reported one
    std::size_t spelling_checks_ = 0;
    std::size_t forgotten_ = 0;  ///< value of `failures_` when lost names were last recorded
    std::vector<std::string> lost_names_;
    bool lost_declarations_ = false;
    bool orphans_ = false;                         ///< the last member of the file belongs in a body
    long surplus_ = 0;                             ///< opening braces minus closing braces of the file
    diagnostics::Diagnostic* inserted_ = nullptr;  ///< the mistake that was corrected by inserting a token
    bool lexical_errors_ = false;
    std::vector<std::uint32_t> strange_;  ///< offsets of characters that belong to no token
    bool corrected_ = false;              ///< the next token was misspelt and has been corrected
};

/// Parses one member and catches a mistake in it. Returns true if the member was parsed to its end.
template <class Body>
bool Parser::catch_syntax_error(Body body) {
    try {
        body();
        return true;
    } catch (const SyntaxError&) {
        return false;
    }
}

/// Parses a declaration and marks it as broken if it contains a mistake.
template <class Read>
auto Parser::note_failures(Read read) {
    const std::size_t before = failures_;
    auto declared = read();
    if (declared && failures_ != before) declared->broken = true;
    return declared;
}

/// Parses `{ member* }`. The parser recovers from a mistake in a member at the next member. A closing brace is assumed
/// to be missing if a member is not indented more than the owner of the body.
template <class Member>
void Parser::parse_braces(Member member, unsigned members) {
    const std::size_t open = at_;
    expect_token("{");
    const Nesting nesting(*this);
    const std::size_t own = indentation_of(open);
    bool deeper = false;
    for (;;) {
        if (at_token("}")) {
            if (!stray_brace(open)) break;
            pass_stray_brace();
            continue;
        }
        const bool outside = surplus_ > 0 && deeper && peek().first_on_line && indentation_of(at_) <= own;
        if (outside || closes_missing_brace(members)) {
            catch_syntax_error([&] { report_missing("`}`"); });
            if (surplus_ > 0) --surplus_;
            return;
        }
        deeper = deeper || (peek().first_on_line && indentation_of(at_) > own);
        const std::size_t start = at_;
        // A member whose tokens are all missing is parsed without consuming a token. It does not count as a member.
        const bool taken = catch_syntax_error(member) && at_ != start;
        const bool read = taken || take_correction();
        if (!read) {
            if (at_ == start && !at_token("{") && !at_token("<{")) advance_token();
            skip_to_member();
        }
        mark_lost_names(start, at_);
        if (read && peek().first_on_line) quiet_until_ = 0;  // parsing has recovered
    }
    advance_token();
}

}  // namespace robochart::frontend
