// SPDX-License-Identifier: Apache-2.0
// Parses probabilistic assertions (Assertions.xtext): properties, the definitions that they use, and the forms of
// expressions that only they allow.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/syntax/operators.hpp"
#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

namespace {

/// Sets a flag to true while the object exists.
class Raised {
public:
    explicit Raised(bool& flag) : flag_(flag) { flag_ = true; }
    ~Raised() { flag_ = false; }
    Raised(const Raised&) = delete;
    Raised& operator=(const Raised&) = delete;

private:
    bool& flag_;
};

/// The words that begin definitions, and the token that follows the name.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> definition_words = {{{"const", ":"},
                                                                                            {"constants", ":"},
                                                                                            {"label", "="},
                                                                                            {"formula", "="},
                                                                                            {"rewards", "="},
                                                                                            {"defs", ":"},
                                                                                            {"pmodules", ":"}}};
constexpr std::array<std::string_view, 4> relations = {"<=", ">=", "<", ">"};
constexpr std::array<std::string_view, 4> methods = {"CI", "ACI", "APMC", "SPRT"};

}  // namespace

// ---------------------------------------------------------------- members

/// True at `prob …` or at the first word of a definition, but not at `with constants` or `#label`.
bool Parser::at_probabilistic_part() const {
    if (at_word("prob")) return at_word("property", 1) || at_word("generate", 1);
    const auto* form = std::ranges::find_if(definition_words, [&](const auto& entry) { return at_word(entry.first); });
    if (form == definition_words.end() || peek(1).kind != TokenKind::identifier) return false;
    return peek(2).is_word(form->second) || peek().first_on_line;
}

void Parser::probabilistic_part(File& file) {
    const Raised inside(probabilistic_);
    if (at_word("prob"))
        probabilistic_assertion(file);
    else
        probabilistic_definition(file);
}

void Parser::definition_name(std::string& name, Span& span) {
    const QualifiedName read = simple_name("a name");
    name = read.parts.front();
    span = read.span;
}

/// Parses `prob property P : e`, `prob generate path P : using simulation …`, and their `with` clauses.
void Parser::probabilistic_assertion(File& file) {
    ProbabilisticAssertion& assertion = file.probabilistic_assertions.emplace_back();
    const std::size_t before = failures_;
    assertion.broken = true;
    const Span begin = peek().span;
    expect_word("prob");
    const bool path = accept_word("generate");
    expect_word(path ? "path" : "property");
    assertion.span = span_since(begin);
    definition_name(assertion.name, assertion.name_span);
    assertion.span = span_since(begin);
    expect_token(":");
    if (path)
        assertion.path = path_generation();
    else
        assertion.property = parse_expression();
    assertion.span = span_since(begin);
    probabilistic_clauses(assertion);
    assertion.span = span_since(begin);
    assertion.broken = failures_ != before;
}

PathGeneration Parser::path_generation() {
    PathGeneration path;
    for (const std::string_view word : {"using", "simulation", "for"}) expect_word(word);
    if (accept_word("deadlock")) {
        const bool clause = at_word("constant", 1) || at_word("constants", 1) || at_word("definitions", 1) ||
                            at_word("modules", 1) || at_word("cmdoptions", 1);
        if (at_word("with") && !clause) {
            advance_token();
            path.repeats = parse_operand(plus_level);
            expect_word("repeats");
        }
    } else {
        path.steps = parse_operand(plus_level);
        expect_word("steps");
    }
    if (!accept_word("up")) return path;
    expect_token("to");
    path.limit = parse_operand(plus_level);
    expect_word("steps");
    return path;
}

/// Parses `with constants …`, `with definitions …`, `with modules …` and `with cmdoptions "…"`: each at most once, in
/// this order.
void Parser::probabilistic_clauses(ProbabilisticAssertion& assertion) {
    std::string last;
    int order = -1;
    while (at_word("with")) {
        advance_token();
        const Token word = peek();
        int clause = -1;
        if (at_word("constants") || at_word("constant")) clause = 0;
        if (at_word("definitions")) clause = 1;
        if (at_word("modules")) clause = 2;
        if (at_word("cmdoptions")) clause = 3;
        if (clause < 0) fail_expecting("`constants`, `definitions`, `modules` or `cmdoptions`");
        const std::string text(word.text);
        advance_token();
        if (clause <= order) {
            report(syntax::probabilistic_clause_order, word.span, {text, last});
            quiet_until_ = 0;
        }
        order = std::max(order, clause);
        last = text;
        constexpr std::array<ProbabilisticKind, 3> kinds = {ProbabilisticKind::constants,
                                                            ProbabilisticKind::definitions, ProbabilisticKind::modules};
        if (clause < 3) {
            assertion.clauses.push_back(probabilistic_clause(kinds.at(static_cast<std::size_t>(clause))));
            continue;
        }
        if (peek().kind != TokenKind::string) fail_expecting("the options in quotation marks");
        assertion.options = std::string(advance_token().text);
    }
}

/// Reads the name of a definition, or an inline definition.
ProbabilisticClause Parser::probabilistic_clause(ProbabilisticKind kind) {
    ProbabilisticClause clause;
    clause.definition.kind = kind;
    std::size_t behind = 1;
    while (peek(behind).is_word("::")) behind += 2;
    const bool written = at_word("pfunction") || at_word("poperation") || at_word("pmodule") ||
                         (kind == ProbabilisticKind::constants && (at_word("set", behind) || at_word("from", behind)));
    if (written)
        definition_body(clause.definition);
    else
        clause.name = qualified_name("a name");
    return clause;
}

void Parser::probabilistic_definition(File& file) {
    ProbabilisticDefinition& definition = file.probabilistic_definitions.emplace_back();
    const std::size_t before = failures_;
    definition.broken = true;
    const auto* form = std::ranges::find_if(definition_words, [&](const auto& entry) { return at_word(entry.first); });
    definition.kind = static_cast<ProbabilisticKind>(form - definition_words.begin());
    const Span begin = advance_token().span;
    definition.span = begin;
    definition_name(definition.name, definition.name_span);
    definition.span = span_since(begin);
    expect_token(form->second);
    definition_body(definition);
    definition.span = span_since(begin);
    definition.broken = failures_ != before;
}

void Parser::definition_body(ProbabilisticDefinition& definition) {
    switch (definition.kind) {
        case ProbabilisticKind::constant:
            definition.constant = std::make_unique<Variable>(DeclKind::constant);
            definition.constant->name = definition.name;
            definition.constant->name_span = definition.name_span;
            definition.constant->span = definition.span;
            definition.constant->type_expr = parse_type();
            return;
        case ProbabilisticKind::constants:
            definition.constants = constant_list();
            return;
        case ProbabilisticKind::label:
        case ProbabilisticKind::formula:
            definition.value = parse_expression();
            return;
        case ProbabilisticKind::rewards:
            definition.rewards = reward_items();
            return;
        case ProbabilisticKind::definitions:
            if (!at_word("pfunction") && !at_word("poperation")) fail_expecting("`pfunction` or `poperation`");
            while (at_word("pfunction") || at_word("poperation"))
                definition.functions.push_back(probabilistic_function());
            return;
        case ProbabilisticKind::modules:
            if (!at_word("pmodule")) fail_expecting("`pmodule`");
            while (at_word("pmodule")) definition.modules.push_back(probabilistic_module());
            return;
    }
}

// ---------------------------------------------------------------- definitions

/// Parses `q set to e, …, and t from set {…}`.
std::vector<ConstantValues> Parser::constant_list() {
    std::vector<ConstantValues> list;
    bool more = true;
    while (more) {
        list.push_back(constant_values());
        more = accept_token(",");
        more = accept_word("and") || more;
    }
    return list;
}

ConstantValues Parser::constant_values() {
    ConstantValues values;
    if (peek().kind != TokenKind::identifier) fail_expecting("the name of a constant");
    values.constant = parse_named();
    values.from_set = accept_token("from");
    if (values.from_set) {
        expect_word("set");
        if (!at_token("{")) fail_expecting("`{`");
        values.value = parse_set();
        return values;
    }
    if (!accept_word("set")) fail_expecting("`set to` or `from set`");
    expect_token("to");
    values.value = parse_expression();
    return values;
}

/// Parses `[event] g : v; … endrewards`.
std::vector<RewardItem> Parser::reward_items() {
    std::vector<RewardItem> items;
    while (!at_word("endrewards")) {
        RewardItem item;
        item.of_step = at_token("[");
        if (item.of_step) item.event = action_label();
        item.guard = parse_expression();
        expect_token(":");
        item.value = parse_expression();
        expect_token(";");
        items.push_back(std::move(item));
    }
    advance_token();
    return items;
}

/// Parses `[event]` or `[]`.
ExprPtr Parser::action_label() {
    expect_token("[");
    ExprPtr event = at_token("]") ? nullptr : parse_named();
    expect_token("]");
    return event;
}

/// Parses `pfunction f(x, y) = { return e }` or `poperation o(x) = { u & v }`.
ProbabilisticFunction Parser::probabilistic_function() {
    ProbabilisticFunction function;
    const bool returns = advance_token().text == "pfunction";
    definition_name(function.name, function.name_span);
    expect_token("(");
    if (!at_token(")")) do {
            auto parameter = std::make_unique<Variable>(DeclKind::parameter);
            name(*parameter);
            parameter->span = parameter->name_span;
            function.parameters.push_back(std::move(parameter));
        } while (accept_token(","));
    expect_token(")");
    expect_token("=");
    expect_token("{");
    if (returns) {
        expect_word("return");
        function.result = parse_expression();
    } else {
        function.updates = parse_updates();
    }
    expect_token("}");
    return function;
}

/// Parses `pmodule N { x : T init e; … [event] g -> u & v; … }`.
ProbabilisticModule Parser::probabilistic_module() {
    ProbabilisticModule module;
    expect_word("pmodule");
    definition_name(module.name, module.name_span);
    expect_token("{");
    while (!at_token("}") && !at_end()) {
        if (at_token("["))
            module.commands.push_back(parse_command());
        else
            module.variables.push_back(module_variable());
        expect_token(";");
    }
    expect_token("}");
    return module;
}

/// Parses `x : [a to b] init e` or `x : bool`.
ModuleVariable Parser::module_variable() {
    ModuleVariable result;
    result.variable = std::make_unique<Variable>(DeclKind::variable);
    const Span begin = peek().span;
    name(*result.variable);
    expect_token(":");
    if (!accept_word("bool")) {
        if (!at_token("[")) fail_expecting("`bool` or `[a to b]`");
        advance_token();
        result.low = parse_expression();
        expect_token("to");
        result.high = parse_expression();
        expect_token("]");
    }
    if (accept_word("init")) result.variable->initial = parse_expression();
    result.variable->span = span_since(begin);
    return result;
}

/// Parses `[event] g -> u & v` or `[] g -> skip`.
Command Parser::parse_command() {
    Command result;
    result.event = action_label();
    result.guard = parse_expression();
    expect_token("->");
    if (!accept_word("skip")) result.updates = parse_updates();
    return result;
}

std::vector<Update> Parser::parse_updates() {
    std::vector<Update> list;
    do list.push_back(parse_update());
    while (accept_token("&"));
    return list;
}

/// Parses `(@x = e)` or `(p : @x = e)`.
Update Parser::parse_update() {
    Update result;
    expect_token("(");
    std::size_t behind = at_token("@") ? 2 : 1;
    while (peek(behind).is_word("::")) behind += 2;
    if (!peek(behind).is_word("=")) {
        result.probability = parse_expression();
        expect_token(":");
    }
    if (!at_token("@") && peek().kind != TokenKind::identifier) fail_expecting("`@` and a variable");
    result.variable = at_token("@") ? parse_marked() : parse_named();
    expect_token("=");
    result.value = parse_expression();
    expect_token(")");
    return result;
}

// ---------------------------------------------------------------- expressions

/// Parses a form of expressions that only probabilistic assertions allow. Returns null if none begins here. A member on
/// the next line is not an expression.
ExprPtr Parser::probabilistic_atom() {
    if (peek().first_on_line && at_assertion_member()) return missing_expression();
    prism_query();
    if (at_token("$") || at_token("#") || at_token("@") || at_token("&")) return parse_marked();
    if (at_path_prefix()) return path_prefix();
    if (at_word("Prob")) return parse_quantitative(ExprKind::probability);
    if (at_word("Reward")) return parse_quantitative(ExprKind::reward);
    if (at_word("Forall")) return path_quantifier(ExprKind::all_paths);
    return at_word("Exists") ? path_quantifier(ExprKind::some_path) : nullptr;
}

bool Parser::at_path_prefix() const {
    return at_word("Finally") || at_word("Globally") || at_word("Next") || at_word("Release") ||
           (at_word("Weak") && at_word("Until", 1));
}

/// Parses `Finally <=10 φ` or `Globally [1, 3] φ`. φ extends as far to the right as possible.
ExprPtr Parser::path_prefix() {
    const Nesting nesting(*this);
    ExprPtr result = make_expression(ExprKind::path);
    const Span begin = result->span;
    result->path = PathOp::release;
    if (at_word("Finally")) result->path = PathOp::eventually;
    if (at_word("Globally")) result->path = PathOp::globally;
    if (at_word("Next")) result->path = PathOp::next;
    if (at_word("Weak")) result->path = PathOp::weak_until;
    if (advance_token().text == "Weak") advance_token();
    step_bound(*result);
    result->args.push_back(parse_expression());
    return finish_node(std::move(result), begin);
}

/// Parses `φ Until <=10 ψ`.
ExprPtr Parser::parse_until(ExprPtr left) {
    ExprPtr result = make_expression(ExprKind::path);
    const Span begin = left->span;
    result->path = PathOp::until;
    expect_word("Until");
    step_bound(*result);
    result->args.push_back(std::move(left));
    result->args.push_back(parse_operand(compare_level));
    return finish_node(std::move(result), begin);
}

/// Parses the bound on the number of steps, if there is one. The bound is an atom, because the formula follows
/// directly.
void Parser::step_bound(Expr& path) {
    path.args.emplace_back();
    if (at_token("[")) {
        path.args.back() = closed_range();
    } else if (std::ranges::any_of(relations, [&](std::string_view word) { return at_token(word); })) {
        path.text = std::string(advance_token().text);
        path.args.back() = parse_atom();
    }
}

/// Parses `Prob>=0.5 of [φ]` or `Reward {r} max=? of [ρ] using sim …`.
ExprPtr Parser::parse_quantitative(ExprKind kind) {
    ExprPtr result = make_expression(kind);
    const Span begin = advance_token().span;
    if (kind == ExprKind::reward && accept_token("{")) {
        result->name = simple_name("the name of a reward structure");
        expect_token("}");
    }
    ExprPtr bound;
    if (std::ranges::any_of(relations, [&](std::string_view word) { return at_token(word); })) {
        result->text = std::string(advance_token().text);
        bound = parse_operand(plus_level);
    } else {
        if (at_word("min") || at_word("max")) result->text = std::string(advance_token().text);
        if (!at_token("=")) fail_expecting("`=?`, `min=?`, `max=?` or a comparison");
        advance_token();
        expect_token("?");
        result->text += "=?";
    }
    expect_word("of");
    expect_token("[");
    result->args.push_back(kind == ExprKind::reward ? reward_path() : parse_expression());
    expect_token("]");
    result->args.push_back(std::move(bound));
    result->args.push_back(at_word("using") ? parse_simulation() : nullptr);
    return finish_node(std::move(result), begin);
}

/// Parses `Reachable φ`, `LTL φ`, `Cumul e` or `Total`.
ExprPtr Parser::reward_path() {
    ExprPtr result = make_expression(ExprKind::path);
    const Span begin = result->span;
    result->args.emplace_back();
    if (accept_word("Total")) {
        result->path = PathOp::total;
        return finish_node(std::move(result), begin);
    }
    const bool reachable = at_word("Reachable");
    const bool linear_time = at_word("LTL");
    if (!reachable && !linear_time && !at_word("Cumul")) fail_expecting("`Reachable`, `LTL`, `Cumul` or `Total`");
    advance_token();
    result->path = PathOp::cumulative;
    if (reachable) result->path = PathOp::reachable;
    if (linear_time) result->path = PathOp::linear_time;
    result->args.push_back(parse_expression());
    return finish_node(std::move(result), begin);
}

/// Parses `using sim with CI at alpha=0.05, n=1000, and pathlen=10000`.
ExprPtr Parser::parse_simulation() {
    ExprPtr result = make_expression(ExprKind::simulation);
    const Span begin = result->span;
    for (const std::string_view word : {"using", "sim", "with"}) expect_word(word);
    const auto method = std::ranges::find_if(methods, [&](std::string_view word) { return at_word(word); });
    if (method == methods.end()) fail_expecting("`CI`, `ACI`, `APMC` or `SPRT`");
    result->text = std::string(advance_token().text);
    expect_word("at");
    bool more = true;
    while (more) {
        Binding binding;
        binding.variable = std::make_unique<Variable>(DeclKind::parameter);
        binding.variable->span = peek().span;
        name(*binding.variable);
        expect_token("=");
        binding.value = parse_operand(plus_level);
        result->bindings.push_back(std::move(binding));
        const std::size_t name_at = at_token(",") ? 1 : 0;
        more = at_word("and", name_at) || (name_at == 1 && peek(2).is_word("="));  // otherwise the comma belongs to an
                                                                                   // enclosing list
        if (more) accept_token(",");
        accept_word("and");
    }
    return finish_node(std::move(result), begin);
}

/// Parses `Forall [φ]` or `Exists [φ]`.
ExprPtr Parser::path_quantifier(ExprKind kind) {
    ExprPtr result = make_expression(kind);
    const Span begin = advance_token().span;
    expect_token("[");
    result->args.push_back(parse_expression());
    expect_token("]");
    return finish_node(std::move(result), begin);
}

/// Parses `$formula`, `$$parameter`, `#label`, `&function` or `@M::N::variable`.
ExprPtr Parser::parse_marked() {
    ExprPtr result = make_expression(ExprKind::marked);
    const Span begin = result->span;
    result->text = std::string(advance_token().text);
    if (result->text == "$" && accept_token("$")) result->text = "$$";
    result->name = qualified_name("a name");
    return finish_node(std::move(result), begin);
}

/// Reads the forms that may follow a name: `is in S`, `.in`, `.out`, `.in.val`, `.out.val`.
ExprPtr Parser::behind_name(ExprPtr name) {
    const Span begin = name->span;
    if (at_token("is") && peek(1).is_word("in")) {
        name->kind = ExprKind::in_state;
        advance_token();
        advance_token();
        ExprPtr state = make_expression(ExprKind::name);
        state->name = qualified_name("the name of a state");
        state->span = state->name.span;
        name->args.push_back(std::move(state));
        return finish_node(std::move(name), begin);
    }
    if (!at_token(".") || !(at_word("in", 1) || at_word("out", 1))) return name;
    name->kind = ExprKind::event;
    advance_token();
    name->text = std::string(advance_token().text);
    if (at_token(".") && at_word("val", 1)) {
        advance_token();
        advance_token();
        name->text += ".val";
    }
    return finish_node(std::move(name), begin);
}

}  // namespace robochart::frontend
