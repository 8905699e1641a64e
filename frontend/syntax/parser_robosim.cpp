// SPDX-License-Identifier: Apache-2.0
// Parses the constructs of RoboSim (RoboSim.xtext): registers, cycles, contexts, simulations. In a file of RoboChart
// they are reported and parsed. Likewise, constructs that only RoboChart has are reported and parsed in a file of
// RoboSim.
#include <fmt/format.h>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

// ---------------------------------------------------------------- the other dialect

/// Reports a construct that the dialect of the file does not have. Parsing continues as if it were allowed.
void Parser::refuse_dialect(Span span, std::string_view written, std::string_view instead) {
    report(syntax::other_dialect, span, {std::string(written), std::string(to_text(dialect_)), std::string(instead)});
    quiet_until_ = 0;
}

/// Reports a construct of RoboChart in a file of RoboSim.
void Parser::refuse_robochart(Span span, std::string_view written, std::string_view instead) {
    if (is_robosim()) refuse_dialect(span, written, instead);
}

/// Reports an event that is sent or received without `$`. In RoboSim, no machine waits for an event.
void Parser::check_plain_communication(const Stmt& statement) {
    if (!is_robosim()) return;
    const Communication& communication = *statement.communication;
    const std::string event = written_name(communication.event);
    if (communication.kind == CommKind::input)
        return refuse_dialect(statement.span, event + "?", fmt::format("a condition reads an input: `${}?x`", event));
    const std::string written = statement.send_keyword ? "send " + event : event;
    diagnostics::Diagnostic* const finding =
        report(syntax::other_dialect, statement.span,
               {written, "RoboSim", fmt::format("an output is written by `${}`", event)});
    if (finding != nullptr)
        finding->fixes.push_back({{source_, statement.span.begin, communication.event.span.begin}, "$", "insert"});
    quiet_until_ = 0;
}

// ---------------------------------------------------------------- members

/// Parses `cycleDef e`, `input context {…}` or `output context {…}`. Returns false at other texts. RoboChart does not
/// reserve these words.
bool Parser::robosim_member(Context& context) {
    const bool cycle = is_robosim() ? at_token("cycleDef") : at_word("cycleDef");
    const bool registers = (at_word("input") || at_word("output")) && at_word("context", 1);
    if (!cycle && !registers && !(is_robosim() && (at_token("input") || at_token("output")))) return false;
    if (!is_robosim())
        refuse_dialect(peek().span, cycle ? "cycleDef" : std::string(peek().text) + " context",
                       "only components of RoboSim (`.rst`) run in cycles");
    if (cycle)
        cycle_definition(context);
    else
        register_context(context);
    return true;
}

void Parser::cycle_definition(Context& context) {
    const Span word = advance_token().span;
    pass_sign_behind_word();
    ExprPtr value = parse_expression();
    if (context.cycle)
        report(syntax::robosim_twice, word, {std::string(to_text(context.kind)), context.name, "cycleDef"});
    else
        context.cycle = std::move(value);
}

/// Parses `input context { … }` or `output context { … }`. A second context of a kind is reported, and its members are
/// added to the first.
void Parser::register_context(Context& context) {
    const bool input = at_word("input");
    const Span begin = advance_token().span;
    expect_word("context");
    std::unique_ptr<Context>& place = input ? context.input : context.output;
    if (place) {
        report(syntax::robosim_twice, span_since(begin),
               {std::string(to_text(context.kind)), context.name, input ? "input context" : "output context"});
        quiet_until_ = 0;
    } else {
        place = std::make_unique<Context>(input ? DeclKind::input_context : DeclKind::output_context);
        place->dialect = dialect_;
        place->name = input ? "input context" : "output context";
        place->name_span = place->span = span_since(begin);
    }
    Context& registers = *place;
    catch_syntax_error([&] { parse_braces([&] { register_member(registers); }, register_members); });
    registers.span = span_since(registers.span);
}

/// Parses `uses I`, `requires I` or `event e : T`.
void Parser::register_member(Context& registers) {
    if (at_token("uses") || at_token("requires")) return interface_clause(registers);
    if (at_token("event") || at_token("_broadcast")) return parse_event(registers);
    const bool declares = at_token("var") || at_token("const") || at_token("clock") ||
                          (peek().kind == TokenKind::identifier && peek(1).is_word("("));
    if (declares)
        report(syntax::robosim_context_member, peek().span, {registers.name});
    else
        fail_expecting("`uses`, `requires`, `event` or the `}` of the context");
    throw SyntaxError{};
}

/// Parses `exec` after the source and the target of a transition.
bool Parser::exec_clause(Transition& transition) {
    const bool here = is_robosim() ? at_token("exec") : at_word("exec") && peek(1).kind == TokenKind::keyword;
    if (!here) return false;
    if (!is_robosim()) refuse_dialect(peek().span, "exec", "transitions of RoboSim (`.rst`) end a cycle");
    transition.exec = true;
    advance_token();
    return true;
}

// ---------------------------------------------------------------- statements

StmtPtr Parser::exec_statement() {
    auto statement = std::make_unique<Stmt>();
    statement->kind = StmtKind::exec;
    statement->span = advance_token().span;
    return statement;
}

/// Parses `$e`, `$e!E`, `$e.E`, `$op(E, …)` or `$x.f[i] = E`.
StmtPtr Parser::register_statement() {
    if (!is_robosim()) {
        const Span sign = peek().span;
        refuse_dialect(sign, "$", "an event is sent by `e`, a variable is assigned by `x = e`");
        advance_token();
        return basic_statement();
    }
    std::size_t ahead = 2;
    while (peek(ahead).is_word("::")) ahead += 2;
    const bool assigns = looks_like_assignment(ahead);
    const Span begin = peek().span;
    if (assigns) return parse_assignment();
    advance_token();
    auto statement = std::make_unique<Stmt>();
    statement->through_register = true;
    if (peek(ahead - 1).is_word("(")) {
        statement->kind = StmtKind::call;
        statement->name = qualified_name("the name of an operation");
        expect_token("(");
        expression_list(statement->args, ")");
    } else {
        statement->kind = StmtKind::communication;
        statement->communication = parse_communication();
        statement->communication->through_register = true;
        statement->communication->span = span_since(begin);
        if (statement->communication->kind == CommKind::input)
            refuse_dialect(statement->communication->span, "?", "a condition reads an input: `condition $e?x`");
    }
    statement->span = span_since(begin);
    return statement;
}

// ---------------------------------------------------------------- expressions

/// Parses `$n`, `$e?v`, `$e?$x` or `$e?v : p`. The predicate p is an atom, a call or an expression in parentheses.
ExprPtr Parser::parse_register() {
    if (!is_robosim()) {
        refuse_dialect(peek().span, "$", "a trigger receives an event, and a variable is read by its name");
        advance_token();
        return parse_atom();
    }
    ExprPtr read = make_expression(ExprKind::register_);
    const Span begin = expect_token("$");
    read->name = qualified_name("the name of an event or variable");
    if (at_token("?")) register_store(*read);
    return finish_node(std::move(read), begin);
}

void Parser::register_store(Expr& read) {
    expect_token("?");
    ExprPtr stored;
    if (at_token("$")) {
        stored = make_expression(ExprKind::register_);
        advance_token();
    } else {
        stored = make_expression(ExprKind::name);
    }
    stored->name = simple_name("the variable that receives the value");
    stored->span = span_since(stored->span);
    read.args.push_back(std::move(stored));
    read.args.push_back(accept_token(":") ? parse_call() : nullptr);
}

ExprPtr Parser::parse_cycle() {
    ExprPtr length = make_expression(ExprKind::cycle);
    advance_token();
    return length;
}

// ---------------------------------------------------------------- assertions

bool Parser::at_simulation() const {
    return at_word("simulation") && peek(1).kind == TokenKind::identifier && at_word("of", 2);
}

/// Parses `simulation N of M { cycleDef e … }`.
void Parser::parse_simulation(File& file) {
    if (!is_robosim())
        refuse_dialect(peek().span, "simulation", "claims about cycles belong into a file of RoboSim (`.rsa`)");
    auto owned = std::make_unique<Simulation>();
    Simulation& simulation = *owned;
    simulation.dialect = dialect_;
    simulation.span = advance_token().span;
    name(simulation);
    expect_word("of");
    simulation.subject = qualified_name("the name of a component");
    file.simulations.push_back(std::move(owned));
    const std::size_t before = failures_;
    catch_syntax_error([&] { parse_braces([&] { simulation_member(simulation); }, context_members); });
    simulation.broken = failures_ != before;
    simulation.span = span_since(simulation.span);
}

void Parser::simulation_member(Simulation& simulation) {
    if (!robosim_member(simulation))
        fail_expecting("`cycleDef`, `input context`, `output context` or the `}` of the simulation");
}

/// Parses `schedulable` after `X is`.
bool Parser::schedulable_property(Assertion& assertion) {
    if (!at_word("schedulable")) return false;
    if (!is_robosim())
        refuse_dialect(peek().span, "schedulable", "claims about simulations belong into a file of RoboSim (`.rsa`)");
    advance_token();
    assertion.kind = AssertionKind::schedulable;
    return true;
}

/// Parses `cycleDef of X`, up to the name of the component.
bool Parser::cycle_parameter(AssertionParameter& parameter) {
    if (!at_word("cycleDef")) return false;
    if (!is_robosim())
        refuse_dialect(peek().span, "cycleDef", "claims about cycles belong into a file of RoboSim (`.rsa`)");
    parameter.kind = ParameterKind::cycle;
    parameter.name.parts.emplace_back(peek().text);
    parameter.name.spans.push_back(peek().span);
    parameter.name.span = peek().span;
    advance_token();
    return true;
}

/// Reports `untimed` in a file of RoboSim, which has only a timed semantics.
void Parser::refuse_untimed(AssertionTime time, Span word) {
    if (!is_robosim() || time != AssertionTime::untimed) return;
    diagnostics::Diagnostic* const finding =
        report(syntax::other_dialect, word, {"untimed", "RoboSim", "every claim is about time: leave out `untimed`"});
    if (finding != nullptr) finding->fixes.push_back({word, "", "leave it out"});
    quiet_until_ = 0;
}

}  // namespace robochart::frontend
