// SPDX-License-Identifier: Apache-2.0
// Probabilistic assertions (Assertions.xtext): properties, the definitions that they use, and expression forms that
// only they allow.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/syntax/operators.hpp"
#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

namespace {

/// Sets a flag while the object exists.
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
    const auto* form = std::ranges::find_if(definition_words, [&](const auto& each) { return at_word(each.first); });
    if (form == definition_words.end() || peek(1).kind != TokenKind::identifier) return false;
    return peek(2).is(form->second) || peek().first_on_line;
}

void Parser::probabilistic_part(File& file) {
    const Raised inside(probabilistic_);
    at_word("prob") ? probabilistic_assertion(file) : probabilistic_definition(file);
}

void Parser::definition_name(std::string& name, Span& span) {
    const QualifiedName read = simple_name("a name");
    name = read.parts.front();
    span = read.span;
}

/// `prob property P : e`, `prob generate path P : using simulation …`, and their `with` clauses.
void Parser::probabilistic_assertion(File& file) {
    ProbabilisticAssertion& assertion = file.probabilistic_assertions.emplace_back();
    const std::size_t before = failures_;
    assertion.broken = true;
    const Span begin = peek().span;
    expect_word("prob");
    const bool path = accept_word("generate");
    expect_word(path ? "path" : "property");
    assertion.span = since(begin);
    definition_name(assertion.name, assertion.name_span);
    assertion.span = since(begin);
    expect(":");
    if (path)
        assertion.path = path_generation();
    else
        assertion.property = expression();
    assertion.span = since(begin);
    probabilistic_clauses(assertion);
    assertion.span = since(begin);
    assertion.broken = failures_ != before;
}

PathGeneration Parser::path_generation() {
    PathGeneration path;
    for (const std::string_view word : {"using", "simulation", "for"}) expect_word(word);
    if (accept_word("deadlock")) {
        const bool clause = at_word("constant", 1) || at_word("constants", 1) || at_word("definitions", 1) ||
                            at_word("modules", 1) || at_word("cmdoptions", 1);
        if (at_word("with") && !clause) {
            advance();
            path.repeats = operand(plus_level);
            expect_word("repeats");
        }
    } else {
        path.steps = operand(plus_level);
        expect_word("steps");
    }
    if (!accept_word("up")) return path;
    expect("to");
    path.limit = operand(plus_level);
    expect_word("steps");
    return path;
}

/// `with constants …`, `with definitions …`, `with modules …`, `with cmdoptions "…"`: each at most once, in this order.
void Parser::probabilistic_clauses(ProbabilisticAssertion& assertion) {
    std::string last;
    int order = -1;
    while (at_word("with")) {
        advance();
        const Token word = peek();
        const int clause = at_word("constants") || at_word("constant") ? 0
                           : at_word("definitions")                    ? 1
                           : at_word("modules")                        ? 2
                           : at_word("cmdoptions")                     ? 3
                                                                       : -1;
        if (clause < 0) expected("`constants`, `definitions`, `modules` or `cmdoptions`");
        const std::string text(word.text);
        advance();
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
        if (peek().kind != TokenKind::string) expected("the options in quotation marks");
        assertion.options = std::string(advance().text);
    }
}

/// The name of a definition, or an inline definition.
ProbabilisticClause Parser::probabilistic_clause(ProbabilisticKind kind) {
    ProbabilisticClause clause;
    clause.definition.kind = kind;
    std::size_t behind = 1;
    while (peek(behind).is("::")) behind += 2;
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
    const auto* form = std::ranges::find_if(definition_words, [&](const auto& each) { return at_word(each.first); });
    definition.kind = static_cast<ProbabilisticKind>(form - definition_words.begin());
    const Span begin = advance().span;
    definition.span = begin;
    definition_name(definition.name, definition.name_span);
    definition.span = since(begin);
    expect(form->second);
    definition_body(definition);
    definition.span = since(begin);
    definition.broken = failures_ != before;
}

void Parser::definition_body(ProbabilisticDefinition& definition) {
    switch (definition.kind) {
        case ProbabilisticKind::constant:
            definition.constant = std::make_unique<Variable>(DeclKind::constant);
            definition.constant->name = definition.name;
            definition.constant->name_span = definition.name_span;
            definition.constant->span = definition.span;
            definition.constant->type_expr = type();
            return;
        case ProbabilisticKind::constants:
            definition.constants = constant_list();
            return;
        case ProbabilisticKind::label:
        case ProbabilisticKind::formula:
            definition.value = expression();
            return;
        case ProbabilisticKind::rewards:
            definition.rewards = reward_items();
            return;
        case ProbabilisticKind::definitions:
            if (!at_word("pfunction") && !at_word("poperation")) expected("`pfunction` or `poperation`");
            while (at_word("pfunction") || at_word("poperation"))
                definition.functions.push_back(probabilistic_function());
            return;
        case ProbabilisticKind::modules:
            if (!at_word("pmodule")) expected("`pmodule`");
            while (at_word("pmodule")) definition.modules.push_back(probabilistic_module());
            return;
    }
}

// ---------------------------------------------------------------- definitions

/// `q set to e, …, and t from set {…}`
std::vector<ConstantValues> Parser::constant_list() {
    std::vector<ConstantValues> list;
    bool more = true;
    while (more) {
        list.push_back(constant_values());
        more = accept(",");
        more = accept_word("and") || more;
    }
    return list;
}

ConstantValues Parser::constant_values() {
    ConstantValues values;
    if (peek().kind != TokenKind::identifier) expected("the name of a constant");
    values.constant = named();
    values.from_set = accept("from");
    if (values.from_set) {
        expect_word("set");
        if (!at("{")) expected("`{`");
        values.value = set();
        return values;
    }
    if (!accept_word("set")) expected("`set to` or `from set`");
    expect("to");
    values.value = expression();
    return values;
}

/// `[event] g : v; … endrewards`
std::vector<RewardItem> Parser::reward_items() {
    std::vector<RewardItem> items;
    while (!at_word("endrewards")) {
        RewardItem item;
        item.of_step = at("[");
        if (item.of_step) item.event = action_label();
        item.guard = expression();
        expect(":");
        item.value = expression();
        expect(";");
        items.push_back(std::move(item));
    }
    advance();
    return items;
}

/// `[event]`, `[]`
ExprPtr Parser::action_label() {
    expect("[");
    ExprPtr event = at("]") ? nullptr : named();
    expect("]");
    return event;
}

/// `pfunction f(x, y) = { return e }`, `poperation o(x) = { u & v }`
ProbabilisticFunction Parser::probabilistic_function() {
    ProbabilisticFunction function;
    const bool returns = advance().text == "pfunction";
    definition_name(function.name, function.name_span);
    expect("(");
    if (!at(")")) do {
            auto parameter = std::make_unique<Variable>(DeclKind::parameter);
            name(*parameter);
            parameter->span = parameter->name_span;
            function.parameters.push_back(std::move(parameter));
        } while (accept(","));
    expect(")");
    expect("=");
    expect("{");
    if (returns) {
        expect_word("return");
        function.result = expression();
    } else {
        function.updates = updates();
    }
    expect("}");
    return function;
}

/// `pmodule N { x : T init e; … [event] g -> u & v; … }`
ProbabilisticModule Parser::probabilistic_module() {
    ProbabilisticModule module;
    expect_word("pmodule");
    definition_name(module.name, module.name_span);
    expect("{");
    while (!at("}") && !at_end()) {
        if (at("["))
            module.commands.push_back(command());
        else
            module.variables.push_back(module_variable());
        expect(";");
    }
    expect("}");
    return module;
}

/// `x : [a to b] init e`, `x : bool`
ModuleVariable Parser::module_variable() {
    ModuleVariable result;
    result.variable = std::make_unique<Variable>(DeclKind::variable);
    const Span begin = peek().span;
    name(*result.variable);
    expect(":");
    if (!accept_word("bool")) {
        if (!at("[")) expected("`bool` or `[a to b]`");
        advance();
        result.low = expression();
        expect("to");
        result.high = expression();
        expect("]");
    }
    if (accept_word("init")) result.variable->initial = expression();
    result.variable->span = since(begin);
    return result;
}

/// `[event] g -> u & v`, `[] g -> skip`
Command Parser::command() {
    Command result;
    result.event = action_label();
    result.guard = expression();
    expect("->");
    if (!accept_word("skip")) result.updates = updates();
    return result;
}

std::vector<Update> Parser::updates() {
    std::vector<Update> list;
    do list.push_back(update());
    while (accept("&"));
    return list;
}

/// `(@x = e)`, `(p : @x = e)`
Update Parser::update() {
    Update result;
    expect("(");
    std::size_t behind = at("@") ? 2 : 1;
    while (peek(behind).is("::")) behind += 2;
    if (!peek(behind).is("=")) {
        result.probability = expression();
        expect(":");
    }
    if (!at("@") && peek().kind != TokenKind::identifier) expected("`@` and a variable");
    result.variable = at("@") ? marked() : named();
    expect("=");
    result.value = expression();
    expect(")");
    return result;
}

// ---------------------------------------------------------------- expressions

/// Null if no form of probabilistic assertions begins here. A member on the next line is not an expression.
ExprPtr Parser::probabilistic_atom() {
    if (peek().first_on_line && at_assertion_member()) return missing_expression();
    prism_query();
    if (at("$") || at("#") || at("@") || at("&")) return marked();
    if (at_path_prefix()) return path_prefix();
    if (at_word("Prob")) return quantitative(ExprKind::probability);
    if (at_word("Reward")) return quantitative(ExprKind::reward);
    if (at_word("Forall")) return path_quantifier(ExprKind::all_paths);
    return at_word("Exists") ? path_quantifier(ExprKind::some_path) : nullptr;
}

bool Parser::at_path_prefix() const {
    return at_word("Finally") || at_word("Globally") || at_word("Next") || at_word("Release") ||
           (at_word("Weak") && at_word("Until", 1));
}

/// `Finally <=10 φ`, `Globally [1, 3] φ`; φ extends as far to the right as possible.
ExprPtr Parser::path_prefix() {
    const Nesting nesting(*this);
    ExprPtr result = make(ExprKind::path);
    const Span begin = result->span;
    result->path = at_word("Finally")    ? PathOp::eventually
                   : at_word("Globally") ? PathOp::globally
                   : at_word("Next")     ? PathOp::next
                   : at_word("Weak")     ? PathOp::weak_until
                                         : PathOp::release;
    if (advance().text == "Weak") advance();
    step_bound(*result);
    result->args.push_back(expression());
    return finish(std::move(result), begin);
}

/// `φ Until <=10 ψ`
ExprPtr Parser::until(ExprPtr left) {
    ExprPtr result = make(ExprKind::path);
    const Span begin = left->span;
    result->path = PathOp::until;
    expect_word("Until");
    step_bound(*result);
    result->args.push_back(std::move(left));
    result->args.push_back(operand(compare_level));
    return finish(std::move(result), begin);
}

/// Parses the bound on the number of steps, if there is one. Its value is an atom, because the formula follows
/// directly.
void Parser::step_bound(Expr& path) {
    path.args.emplace_back();
    if (at("[")) {
        path.args.back() = closed_range();
    } else if (std::ranges::any_of(relations, [&](std::string_view word) { return at(word); })) {
        path.text = std::string(advance().text);
        path.args.back() = atom();
    }
}

/// `Prob>=0.5 of [φ]`, `Reward {r} max=? of [ρ] using sim …`
ExprPtr Parser::quantitative(ExprKind kind) {
    ExprPtr result = make(kind);
    const Span begin = advance().span;
    if (kind == ExprKind::reward && accept("{")) {
        result->name = simple_name("the name of a reward structure");
        expect("}");
    }
    ExprPtr bound;
    if (std::ranges::any_of(relations, [&](std::string_view word) { return at(word); })) {
        result->text = std::string(advance().text);
        bound = operand(plus_level);
    } else {
        if (at_word("min") || at_word("max")) result->text = std::string(advance().text);
        if (!at("=")) expected("`=?`, `min=?`, `max=?` or a comparison");
        advance();
        expect("?");
        result->text += "=?";
    }
    expect_word("of");
    expect("[");
    result->args.push_back(kind == ExprKind::reward ? reward_path() : expression());
    expect("]");
    result->args.push_back(std::move(bound));
    result->args.push_back(at_word("using") ? simulation() : nullptr);
    return finish(std::move(result), begin);
}

/// `Reachable φ`, `LTL φ`, `Cumul e`, `Total`
ExprPtr Parser::reward_path() {
    ExprPtr result = make(ExprKind::path);
    const Span begin = result->span;
    result->args.emplace_back();
    if (accept_word("Total")) {
        result->path = PathOp::total;
        return finish(std::move(result), begin);
    }
    const bool reachable = at_word("Reachable");
    const bool linear_time = at_word("LTL");
    if (!reachable && !linear_time && !at_word("Cumul")) expected("`Reachable`, `LTL`, `Cumul` or `Total`");
    advance();
    result->path = reachable ? PathOp::reachable : linear_time ? PathOp::linear_time : PathOp::cumulative;
    result->args.push_back(expression());
    return finish(std::move(result), begin);
}

/// `using sim with CI at alpha=0.05, n=1000, and pathlen=10000`
ExprPtr Parser::simulation() {
    ExprPtr result = make(ExprKind::simulation);
    const Span begin = result->span;
    for (const std::string_view word : {"using", "sim", "with"}) expect_word(word);
    const auto method = std::ranges::find_if(methods, [&](std::string_view word) { return at_word(word); });
    if (method == methods.end()) expected("`CI`, `ACI`, `APMC` or `SPRT`");
    result->text = std::string(advance().text);
    expect_word("at");
    bool more = true;
    while (more) {
        Binding binding;
        binding.variable = std::make_unique<Variable>(DeclKind::parameter);
        binding.variable->span = peek().span;
        name(*binding.variable);
        expect("=");
        binding.value = operand(plus_level);
        result->bindings.push_back(std::move(binding));
        const std::size_t name_at = at(",") ? 1 : 0;
        more = at_word("and", name_at) || (name_at == 1 && peek(2).is("="));  // otherwise the comma belongs to an
                                                                              // enclosing list
        if (more) accept(",");
        accept_word("and");
    }
    return finish(std::move(result), begin);
}

/// `Forall [φ]`, `Exists [φ]`
ExprPtr Parser::path_quantifier(ExprKind kind) {
    ExprPtr result = make(kind);
    const Span begin = advance().span;
    expect("[");
    result->args.push_back(expression());
    expect("]");
    return finish(std::move(result), begin);
}

/// `$formula`, `$$parameter`, `#label`, `&function`, `@M::N::variable`
ExprPtr Parser::marked() {
    ExprPtr result = make(ExprKind::marked);
    const Span begin = result->span;
    result->text = std::string(advance().text);
    if (result->text == "$" && accept("$")) result->text = "$$";
    result->name = qualified_name("a name");
    return finish(std::move(result), begin);
}

/// The forms that may follow a name: `is in S`, `.in`, `.out`, `.in.val`, `.out.val`.
ExprPtr Parser::behind_name(ExprPtr name) {
    const Span begin = name->span;
    if (at("is") && peek(1).is("in")) {
        name->kind = ExprKind::in_state;
        advance();
        advance();
        ExprPtr state = make(ExprKind::name);
        state->name = qualified_name("the name of a state");
        state->span = state->name.span;
        name->args.push_back(std::move(state));
        return finish(std::move(name), begin);
    }
    if (!at(".") || !(at_word("in", 1) || at_word("out", 1))) return name;
    name->kind = ExprKind::event;
    advance();
    name->text = std::string(advance().text);
    if (at(".") && at_word("val", 1)) {
        advance();
        advance();
        name->text += ".val";
    }
    return finish(std::move(name), begin);
}

}  // namespace robochart::frontend
