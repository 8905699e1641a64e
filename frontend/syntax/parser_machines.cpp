// SPDX-License-Identifier: Apache-2.0
// Parses state machines, operations, nodes, actions and transitions (RoboChart.xtext: StateMachineDef to Action).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

std::unique_ptr<Machine> Parser::parse_machine() {
    auto machine = std::make_unique<Machine>(DeclKind::state_machine);
    machine->dialect = dialect_;
    machine->span = expect_token("stm");
    name(*machine);
    const auto member = [&] {
        if (!context_member(*machine) && !node_member(*machine))
            wrong_word("a member of a state machine", {ForeignPlace::member});
    };
    catch_syntax_error([&] { parse_braces(member, context_members | node_members); });
    machine->span = span_since(machine->span);
    return machine;
}

std::unique_ptr<Machine> Parser::parse_operation() {
    auto operation = std::make_unique<Machine>(DeclKind::operation);
    operation->dialect = dialect_;
    operation->span = expect_token("operation");
    name(*operation);
    const auto member = [&] {
        if (!context_member(*operation) && !node_member(*operation) && !contract_member(*operation))
            wrong_word("a member of an operation", {ForeignPlace::member});
    };
    catch_syntax_error([&] {
        operation->parameters = parse_parameters();
        parse_braces(member, context_members | node_members | contract_members);
    });
    operation->has_body = !operation->nodes.empty();
    operation->span = span_since(operation->span);
    return operation;
}

bool Parser::contract_member(Machine& machine) {
    if (accept_token("terminates")) {
        machine.terminates = true;
        return true;
    }
    const bool before = at_token("precondition");
    if (!before && !at_token("postcondition")) return false;
    advance_token();
    (before ? machine.preconditions : machine.postconditions).push_back(parse_expression());
    return true;
}

bool Parser::node_member(NodeContainer& container) {
    if (at_token("transition")) {
        parse_transition(container);
        return true;
    }
    constexpr std::array<std::pair<std::string_view, DeclKind>, 5> kinds = {
        {{"state", DeclKind::state},
         {"initial", DeclKind::initial},
         {"final", DeclKind::final},
         {"junction", DeclKind::junction},
         {"probabilistic", DeclKind::probabilistic}}};
    for (const auto& [word, kind] : kinds) {
        if (!at_token(word)) continue;
        parse_node(container, kind);
        return true;
    }
    return false;
}

/// Parses a node. A final node with a body is parsed too, so that FS2 and FS3 can report it.
void Parser::parse_node(NodeContainer& container, DeclKind kind) {
    auto owned = std::make_unique<State>(kind);
    State& state = *owned;
    state.span = advance_token().span;
    if (pseudo_state(kind)) return parse_node(container, DeclKind::state);
    name(state);
    container.nodes.push_back(std::move(owned));
    if (at_token(":") && peek(1).is_word("{")) pass_superfluous("the parts of a node are in braces after its name");
    if (kind == DeclKind::state && body_left_out()) return;
    if (kind == DeclKind::state || (kind == DeclKind::final && at_token("{")))
        catch_syntax_error([&] { state_body(state); });
    state.span = span_since(state.span);
}

void Parser::state_body(State& state) {
    const auto member = [&] {
        if (at_token("entry") || at_token("during") || at_token("exit")) return parse_action(state);
        if (!node_member(state))
            wrong_word("a node, transition or action of the state", {ForeignPlace::state_part, ForeignPlace::member});
    };
    parse_braces(member, node_members | action_members);
}

void Parser::parse_action(State& state) {
    Action action;
    action.kind = ActionKind::exit;
    if (at_token("entry")) action.kind = ActionKind::entry;
    if (at_token("during")) action.kind = ActionKind::during;
    action.span = advance_token().span;
    if (at_token("/")) pass_superfluous("an action directly follows its keyword: `entry skip`");
    pass_sign_behind_word();
    action.statement = parse_statement();
    action.span = span_since(action.span);
    state.actions.push_back(std::move(action));
}

// ---------------------------------------------------------------- transitions

void Parser::parse_transition(NodeContainer& container) {
    auto owned = std::make_unique<Transition>();
    Transition& transition = *owned;
    transition.span = expect_token("transition");
    name(transition);
    container.transitions.push_back(std::move(owned));
    if (at_token(":") && peek(1).is_word("{"))
        pass_superfluous("the clauses of a transition are in braces after its name");
    if (at_token("from") || at_word("source")) {
        catch_syntax_error([&] { unbraced_transition(transition); });
        transition.span = span_since(transition.span);
        return;
    }
    catch_syntax_error([&] {
        expect_token("{");
        if (!catch_syntax_error([&] { transition_body(transition); })) {
            while (!at_end() && !at_token("}") && !at_member_word() && !at_top_level_word())
                if (at_token("{") || at_token("<{"))
                    skip_balanced();
                else
                    advance_token();
            if (at_token("}")) advance_token();
            return;
        }
        expect_token("}");
    });
    transition.span = span_since(transition.span);
}

/// Reports and parses `transition t from A to B` without its braces, or without its opening brace.
void Parser::unbraced_transition(Transition& transition) {
    const std::size_t failures = failures_;
    const Span begin = peek().span;
    diagnostics::Diagnostic* const finding = report(syntax::unexpected, missing_place(), {"`{`", describe_token()});
    quiet_until_ = 0;
    transition_body(transition, false);
    const bool closed = surplus_ < 0 && at_token("}");
    if (finding != nullptr && failures_ == failures + 1) {
        const Span span = span_since(begin);
        const std::string_view text = sources_.source_text(source_).substr(span.begin, span.end - span.begin);
        finding->fixes.push_back({span, fmt::format("{{ {}{}", text, closed ? "" : " }"), "write"});
    }
    if (!closed) return;
    ++surplus_;
    advance_token();
}

void Parser::transition_body(Transition& transition, bool braced) {
    if (peek().kind == TokenKind::identifier && peek(1).is_word("->")) {
        ends_by_arrow(transition);
    } else {
        if (at_word("source")) (void)replace_foreign(ForeignPlace::clause);
        expect_token("from");
        transition.from = plain_name("the transition's source");
        if (peek(1).is_word("to")) pass_separator("the clauses of a transition need no separator");
        if (at_word("target")) (void)replace_foreign(ForeignPlace::clause);
        expect_token("to");
        transition.to = plain_name("the transition's target");
    }
    constexpr std::array<std::string_view, 6> names = {"", "trigger", "#", "<{", "condition", "action"};
    int last = 0;
    std::array<std::size_t, 6> begins{};  // the first token of each kind of clause
    while (!at_token("}") && !at_end() && (braced || !(at_member_word() || at_top_level_word()))) {
        const Token next = peek(1);
        const bool clause_follows = next.is_word("trigger") || next.is_word("probability") || next.is_word("#") ||
                                    next.is_word("<{") || next.is_word("condition") || next.is_word("action") ||
                                    next.is_word("exec") || next.is_word("}");
        if (clause_follows) pass_separator("the clauses of a transition need no separator");
        if (at_token("}")) break;
        const std::size_t begin = at_;
        const int clause = transition_clause(transition);
        std::size_t& first = begins.at(static_cast<std::size_t>(clause));
        if (first == 0) first = begin;
        if (clause < last || (clause == last && clause != 2)) {
            const Token token = tokens_[begin];
            if (clause == last)
                report(syntax::clause_twice, token.span, {std::string(token.text)});
            else if (diagnostics::Diagnostic* const finding =
                         report(syntax::clause_order, token.span,
                                {std::string(token.text), std::string(names.at(static_cast<std::size_t>(last)))}))
                finding->fixes.push_back(moved_before(begin, begins, clause));
        }
        last = std::max(last, clause);
    }
}

/// Returns a fix that moves the clause at this token, which ends at the last token read, before the first clause of a
/// later kind.
diagnostics::FixIt Parser::moved_before(std::size_t clause, const std::array<std::size_t, 6>& begins, int kind) const {
    std::size_t later = clause;
    for (std::size_t i = static_cast<std::size_t>(kind) + 1; i < begins.size(); ++i)
        if (begins.at(i) != 0) later = std::min(later, begins.at(i));
    const std::uint32_t from = tokens_[later].span.begin;
    const std::uint32_t own = tokens_[clause].span.begin;
    const std::uint32_t end = previous_token().span.end;
    const std::string_view text = sources_.source_text(source_);
    std::string between(text.substr(from, own - from));
    const std::size_t last = between.find_last_not_of(" \t\r\n");
    const std::string gap = between.substr(last + 1);
    between.resize(last + 1);
    return {{source_, from, end}, std::string(text.substr(own, end - own)) + gap + between, "write"};
}

/// Parses a clause and returns its position in the order of clauses.
int Parser::transition_clause(Transition& transition) {
    if (at_token("trigger")) {
        refuse_robochart(peek().span, "trigger", "a condition reads an input: `condition $e` or `condition $e?x`");
        parse_trigger(transition);
        return 1;
    }
    if (exec_clause(transition)) return 1;
    if (accept_token("probability")) {
        pass_sign_behind_word();
        transition.probability = parse_expression();
        return 1;
    }
    if (at_token("#")) {
        reset(transition);
        return 2;
    }
    if (at_token("<{")) {
        refuse_robochart(peek().span, "<{", "compare a clock in the condition: `condition since(C) <= n`");
        advance_token();
        transition.deadline = parse_expression();
        expect_token("}");
        return 3;
    }
    if (accept_token("condition")) {
        pass_sign_behind_word();
        transition.otherwise = accept_token("else");
        if (!transition.otherwise) transition.condition = parse_expression();
        return 4;
    }
    if (accept_token("action")) {
        pass_sign_behind_word();
        transition.action = parse_statement();
        return 5;
    }
    if (at_token("[")) {
        bracketed_guard(transition);
        return 4;
    }
    if (called_reset(transition)) return 2;
    if (replace_foreign(ForeignPlace::clause)) return transition_clause(transition);
    if (const int clause = forgotten_trigger(transition); clause > 0) return clause;
    if (correct_word({"trigger", "probability", "condition", "action"})) return transition_clause(transition);
    fail_expecting(is_robosim()
                       ? "`exec`, `probability`, `#`, `condition`, `action` or the `}` of the transition"
                       : "`trigger`, `probability`, `#`, `<{`, `condition`, `action` or the `}` of the transition");
}

/// Parses `trigger e…`. The old forms `trigger` and `trigger #C` wait for no event.
void Parser::parse_trigger(Transition& transition) {
    const Span word = expect_token("trigger");
    pass_sign_behind_word();
    if (peek().kind == TokenKind::identifier) {
        transition.trigger = parse_communication();
        return;
    }
    if (!at_token("#") && !at_token("condition") && !at_token("action") && !at_token("<{") && !at_token("}"))
        fail_expecting("the name of an event");
    transition.legacy_trigger = true;
    inserted_ = nullptr;
    out_.report(syntax::legacy_trigger, word).fixes.push_back({word, "", "leave out `trigger`"});
}

void Parser::reset(Transition& transition) {
    expect_token("#");
    transition.resets.push_back({plain_name("the name of a clock"), nullptr});
}

}  // namespace robochart::frontend
