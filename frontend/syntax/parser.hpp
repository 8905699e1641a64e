// Recursive descent over the words of one file (private to the front end). The productions are those of the public
// RoboChart.xtext and Assertions.xtext; each method is named after what it reads.
//
// Recovery: a missing word is assumed to be there, a superfluous word is skipped, once per mistake.
// Where that does not help the mistake is thrown as SyntaxError to the nearest member list, which skips to the next
// member. Elements enter their owner before their body is read, so that what was read is kept. Names in text that was
// not understood are remembered: they are not reported as unknown.
#pragma once

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "frontend/syntax/ast.hpp"
#include "frontend/syntax/foreign_words.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// Nesting that the reader accepts: of brackets, statements, types and composite states.
inline constexpr std::size_t max_depth = 256;
/// Height of expression trees, chains of operators included.
inline constexpr std::uint32_t max_height = 1000;
/// Mistakes reported in one file before reading stops.
inline constexpr std::size_t max_mistakes = 100;

class Parser {
public:
    Parser(const diagnostics::SourceManager& sources, diagnostics::SourceId source, bool is_assertions,
           diagnostics::Diagnostics& out);
    std::unique_ptr<File> file();

private:
    struct SyntaxError {};
    struct GiveUp {};
    /// One level of nesting for the life of the object.
    struct Nesting {
        explicit Nesting(Parser& parser);
        ~Nesting() { --parser_.depth_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;

    private:
        Parser& parser_;
    };
    /// What a body may hold.
    enum Members : unsigned {
        context_members = 1,     ///< uses, requires, provides, var, const, event, clock, op()
        node_members = 2,        ///< nodes and transitions
        action_members = 4,      ///< entry, during, exit
        controller_members = 8,  ///< operation, opref, stm, sref, connection
        module_members = 16,     ///< platforms, controllers, machines, connection
        contract_members = 32,   ///< terminates, precondition, postcondition
    };

    // Words (parser.cpp)
    [[nodiscard]] Token peek(std::size_t ahead = 0) const { return tokens_.at(at_ + ahead); }
    [[nodiscard]] Token previous() const { return tokens_[at_ > 0 ? at_ - 1 : 0]; }
    [[nodiscard]] bool at(std::string_view word) const { return peek().is(word); }
    /// The word as such, reserved or not: assertions reserve more words than models.
    [[nodiscard]] bool at_word(std::string_view word, std::size_t ahead = 0) const;
    [[nodiscard]] bool at_end() const { return peek().kind == TokenKind::end; }
    Token advance();
    bool accept(std::string_view word);
    bool accept_word(std::string_view word);
    /// The word, or a place for it where it is missing.
    Span expect(std::string_view word);
    void expect_word(std::string_view word);
    void name(Declaration& declaration);
    QualifiedName simple_name(std::string_view what);
    /// A simple name where people are tempted to write `A::B`.
    QualifiedName plain_name(std::string_view what);
    QualifiedName qualified_name(std::string_view what);
    void add_part(QualifiedName& name, std::string_view what);
    [[nodiscard]] Span since(const Span& begin) const { return diagnostics::join(begin, previous().span); }
    [[nodiscard]] std::string found() const;
    [[nodiscard]] bool at_follower() const;

    // Mistakes and recovery (parser.cpp)
    /// Null if the mistake follows from one already reported.
    diagnostics::Diagnostic* report(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments = {});
    [[noreturn]] void fail(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments = {});
    [[noreturn]] void too_deep(std::size_t limit);
    [[noreturn]] void expected(std::string_view what);
    /// The same, but reading continues as if it were there; the second failure in a row is thrown.
    diagnostics::Diagnostic* missing(std::string_view what);
    [[nodiscard]] Span missing_place() const;
    void needs_parentheses(std::string_view what, Span span);
    [[nodiscard]] bool behind_strange_characters() const;
    void forget(std::size_t begin, std::size_t end);
    bool neural_construct();
    [[nodiscard]] std::size_t indentation(std::size_t token) const;
    /// Where a closing bracket was expected: a note at the opening one, if that is on another line.
    void point_to_open(std::string_view what, diagnostics::Diagnostic& finding) const;
    /// What foreign_forms() says of the words here; "" where no row fits.
    [[nodiscard]] std::string_view form_meant(std::string_view expected) const;
    [[nodiscard]] std::optional<std::size_t> unclosed_brace(bool& by_indentation) const;
    [[nodiscard]] bool stray_brace(std::size_t open) const;
    void pass_stray_brace();
    /// A misspelt one of these words, which are all reserved, is reported and read as what was meant.
    bool correct_word(std::initializer_list<std::string_view> keywords);
    /// Something else than a member: a misspelt word is corrected in place, so that the member is read after all.
    [[noreturn]] void wrong_word(std::string_view what, std::initializer_list<ForeignPlace> places);
    /// A word of another notation: reported with what RoboChart has instead, which is put in its place or, where that
    /// is not one word, thrown. False: it is none.
    bool replace_foreign(ForeignPlace place);
    /// A word that nothing stands for in RoboChart: reported, with a fix that leaves it out, and passed.
    void pass_superfluous(std::string_view reason);
    /// `:` or `=` behind the word that begins a clause or an action.
    void pass_sign_behind_word();
    /// The same for words that stand side by side.
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
    [[nodiscard]] bool percentage(Expr& number);
    [[nodiscard]] bool body_left_out();
    [[nodiscard]] std::string_view meant_word();
    [[nodiscard]] bool corrected();
    template <class Body>
    bool guarded(Body body);
    template <class Read>
    auto watched(Read read);
    void skip_balanced();
    void skip_to_member();
    [[nodiscard]] bool at_top_level_word() const;
    [[nodiscard]] bool at_member_word() const;
    [[nodiscard]] bool closes_missing_brace(unsigned members) const;

    // Declarations (parser_declarations.cpp)
    void package_clause(File& file);
    void import(File& file);
    void diagram(File& file);
    void top_level(File& file);
    std::unique_ptr<Declaration> declaration();
    std::unique_ptr<Declaration> type_declaration();
    std::unique_ptr<Declaration> record_type();
    std::unique_ptr<Declaration> enumeration();
    void pass_separator(std::string_view reason);
    std::unique_ptr<Declaration> function();
    std::unique_ptr<Declaration> interface();
    std::unique_ptr<Context> platform();
    void variable(std::vector<VariablePtr>& list, DeclKind kind);
    void type_before_name(Variable& variable);
    [[nodiscard]] static bool names_core_type(std::string_view word);
    std::vector<VariablePtr> parameters();
    template <class Member>
    void braces(Member member, unsigned members);

    // Contexts, components, machines (parser_components.cpp)
    bool context_member(Context& context);
    void interface_clause(Context& context);
    void old_list(Span comma, std::string_view word);
    void variable_list(Context& context);
    void event(Context& context);
    void clock(Context& context);
    void operation_signature(Context& context);
    std::unique_ptr<Machine> machine();
    std::unique_ptr<Machine> operation();
    std::unique_ptr<Component> controller();
    std::unique_ptr<Component> module();
    void controller_member(Component& component);
    void module_member(Component& component);
    std::unique_ptr<Reference> reference();
    std::unique_ptr<Connection> connection();
    void connection_end(Connection::End& end);
    bool machine_part(Component& component);
    bool contract_member(Machine& machine);
    bool node_member(NodeContainer& container);
    void node(NodeContainer& container, DeclKind kind);
    void state_body(State& state);
    void action(State& state);
    void transition(NodeContainer& container);
    void transition_body(Transition& transition, bool braced = true);
    void unbraced_transition(Transition& transition);
    int transition_clause(Transition& transition);
    [[nodiscard]] diagnostics::FixIt moved_before(std::size_t clause, const std::array<std::size_t, 6>& begins,
                                                  int kind) const;
    void trigger(Transition& transition);
    void reset(Transition& transition);

    // Types (parser_types.cpp)
    TypeExprPtr type();
    TypeExprPtr function_type();
    TypeExprPtr product_type();
    TypeExprPtr vector_type();
    TypeExprPtr atomic_type();
    TypeExprPtr spaced_set();
    TypeExprPtr wrap(TypeKind kind, TypeExprPtr first, Span begin);

    // Statements (parser_statements.cpp)
    StmtPtr statement();
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
    StmtPtr assignment();
    [[nodiscard]] bool looks_like_assignment() const;
    [[nodiscard]] std::optional<std::size_t> behind_brackets(std::size_t ahead) const;
    std::unique_ptr<Communication> communication();
    [[nodiscard]] bool repair_assignment();
    void communication_predicate(Communication& communication);
    ExprPtr communicated_value();

    // Operators (parser_expressions.cpp)
    ExprPtr expression();
    ExprPtr quantified();
    ExprPtr operand(int level);
    ExprPtr prefix(int level);
    ExprPtr logical_not(int level);
    ExprPtr description(int level);
    ExprPtr let(int level);
    ExprPtr conditional(int level);
    ExprPtr negation();
    ExprPtr postfix();
    ExprPtr steps(ExprPtr left, bool assigned);
    ExprPtr call();
    ExprPtr infix(ExprPtr left, BinaryOp op, int level);
    ExprPtr cast(ExprPtr left);
    [[nodiscard]] std::optional<std::pair<BinaryOp, int>> operator_here() const;
    [[nodiscard]] bool at_quantifier() const;
    [[nodiscard]] bool at_member_step() const;
    [[nodiscard]] bool repair_equality(int level);
    void check_weak_prefix(const Token& word, const Expr& read, int level, int own_level);
    void report_c_operator(std::string_view meant);
    bool missing_comma();
    ExprPtr missing_expression();
    void bindings(Expr& expr);
    void such_that(Expr& expr);
    void expression_list(std::vector<ExprPtr>& list, std::string_view close);
    ExprPtr make(ExprKind kind);
    ExprPtr finish(ExprPtr expr, Span begin);

    // Atoms (parser_atoms.cpp)
    ExprPtr atom();
    ExprPtr literal(ExprKind kind);
    void pass_suffix();
    ExprPtr named();
    ExprPtr record(QualifiedName name);
    ExprPtr bracketed();
    ExprPtr parenthesised_or_range();
    ExprPtr closed_range();
    ExprPtr tuple();
    ExprPtr sequence();
    ExprPtr sequence_element();
    ExprPtr set();
    ExprPtr comprehension(Span begin);
    ExprPtr matrix();
    ExprPtr keyword_atom();
    void range_end(Expr& range);

    // Assertions (parser_assertions.cpp)
    void assertion_member(File& file);
    void assertion(File& file, AssertionTime time);
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
    void keep(File& file);
    void hyphenated_word(std::string_view first, std::string_view second);
    [[nodiscard]] bool at_foreign_assertion() const;
    void foreign_assertion(File& file);
    [[nodiscard]] KeptPart kept_part() const;
    [[nodiscard]] bool at_assertion_member() const;
    [[nodiscard]] bool at_kept_part() const;

    // Probabilistic assertions (parser_probability.cpp)
    [[nodiscard]] bool at_probabilistic_part() const;
    void probabilistic_part(File& file);
    void probabilistic_assertion(File& file);
    void probabilistic_definition(File& file);
    ProbabilisticDefinition named_definition();
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
    Command command();
    Update update();
    std::vector<Update> updates();
    ExprPtr action_label();
    void prism_query();
    [[nodiscard]] std::string prism_path(std::size_t begin, std::size_t end) const;
    ExprPtr probabilistic_atom();
    [[nodiscard]] bool at_path_prefix() const;
    ExprPtr path_prefix();
    ExprPtr until(ExprPtr left);
    void step_bound(Expr& path);
    ExprPtr quantitative(ExprKind kind);
    ExprPtr reward_path();
    ExprPtr simulation();
    ExprPtr path_quantifier(ExprKind kind);
    ExprPtr marked();
    ExprPtr behind_name(ExprPtr name);

    const diagnostics::SourceManager& sources_;
    diagnostics::SourceId source_;
    bool is_assertions_;
    bool probabilistic_ = false;  ///< inside a probabilistic assertion, whose expressions have more forms
    diagnostics::Diagnostics& out_;
    TokenList tokens_;
    std::vector<Span> comments_;
    std::size_t at_ = 0;
    std::size_t depth_ = 0;
    std::size_t mistakes_ = 0;
    std::size_t failures_ = 0;     ///< mistakes and what followed from them
    std::size_t quiet_until_ = 0;  ///< mistakes before this word follow from one already reported
    std::size_t spelling_checks_ = 0;
    std::size_t forgotten_ = 0;  ///< mistakes whose surroundings are among the lost names
    std::vector<std::string> lost_names_;
    bool lost_declarations_ = false;
    bool orphans_ = false;  ///< the last member of the file belonged into a body
    long surplus_ = 0;      ///< opening braces without a closing one; negative: closing ones too many
    diagnostics::Diagnostic* inserted_ = nullptr;  ///< the mistake that was corrected by inserting a word
    bool lexical_errors_ = false;
    std::vector<std::uint32_t> strange_;  ///< places of characters that belong to no word
    bool corrected_ = false;              ///< the word here was misspelt and is now right
};

/// Runs one member; a mistake in it ends it. True if it was read to its end.
template <class Body>
bool Parser::guarded(Body body) {
    try {
        body();
        return true;
    } catch (const SyntaxError&) {
        return false;
    }
}

/// Reads a declaration and marks it if it was not understood in full.
template <class Read>
auto Parser::watched(Read read) {
    const std::size_t before = failures_;
    auto declared = read();
    if (declared && failures_ != before) declared->broken = true;
    return declared;
}

/// `{ member* }`; each member recovers on its own. A closing brace that is missing shows where a member stands no
/// deeper than the body's owner.
template <class Member>
void Parser::braces(Member member, unsigned members) {
    const std::size_t open = at_;
    expect("{");
    const Nesting nesting(*this);
    const std::size_t own = indentation(open);
    bool deeper = false;
    for (;;) {
        if (at("}")) {
            if (!stray_brace(open)) break;
            pass_stray_brace();
            continue;
        }
        const bool outside = surplus_ > 0 && deeper && peek().first_on_line && indentation(at_) <= own;
        if (outside || closes_missing_brace(members)) {
            guarded([&] { missing("`}`"); });
            if (surplus_ > 0) --surplus_;
            return;
        }
        deeper = deeper || (peek().first_on_line && indentation(at_) > own);
        const std::size_t start = at_;
        // Where all its words were missing a member is read without taking one: that is none.
        const bool taken = guarded(member) && at_ != start;
        const bool read = taken || corrected();
        if (!read) {
            if (at_ == start && !at("{") && !at("<{")) advance();
            skip_to_member();
        }
        forget(start, at_);
        if (read && peek().first_on_line) quiet_until_ = 0;  // whole again
    }
    advance();
}

}  // namespace robochart::frontend
