// SPDX-License-Identifier: Apache-2.0
// Builds probabilistic assertions.
#include "frontend/syntax/operators.hpp"
#include "frontend/syntax/print.hpp"
#include "tests/random_models/syntax/syntax_builder.hpp"

namespace robochart::random_models {

using namespace frontend;

namespace {

ExprPtr expr_of(ExprKind kind) {
    auto expr = std::make_unique<Expr>();
    expr->kind = kind;
    return expr;
}

}  // namespace

ExprPtr SyntaxBuilder::named() {
    ExprPtr expr = expr_of(ExprKind::name);
    expr->name = qualified();
    return expr;
}

ExprPtr SyntaxBuilder::marked(const char* sign) {
    ExprPtr expr = expr_of(ExprKind::marked);
    expr->text = sign;
    expr->name = qualified();
    return expr;
}

/// Returns a bound on the steps of a path: an interval, or a comparison with an atom.
ExprPtr SyntaxBuilder::step_bound(std::string& relation) {
    static const std::vector<std::string> relations = {"<=", ">=", "<", ">"};
    if (random_.chance(50)) return nullptr;
    if (random_.chance(30)) {
        ExprPtr range = expr_of(ExprKind::range);
        add_list(range->args, 2, 2, 0);
        return range;
    }
    relation = random_.pick(relations);
    if (random_.chance(50)) return literal();
    ExprPtr group = expr_of(ExprKind::parenthesised);
    group->args.push_back(expression(1));
    return group;
}

ExprPtr SyntaxBuilder::path(std::size_t depth) {
    constexpr std::size_t operators = 6;
    ExprPtr expr = expr_of(ExprKind::path);
    expr->path = static_cast<PathOp>(random_.below(operators));
    expr->args.push_back(step_bound(expr->text));
    if (expr->path == PathOp::until) {
        expr->args.push_back(at(compare_level, depth));
        expr->args.push_back(at(compare_level, depth));
    } else {
        ExprPtr body = expression(depth);
        const char first = to_text(*body).front();
        if (first == '[' || first == '<') {  // it would be parsed as a bound on steps
            ExprPtr group = expr_of(ExprKind::parenthesised);
            group->args.push_back(std::move(body));
            body = std::move(group);
        }
        expr->args.push_back(std::move(body));
    }
    return expr;
}

ExprPtr SyntaxBuilder::simulation() {
    static const std::vector<std::string> methods = {"CI", "ACI", "APMC", "SPRT"};
    ExprPtr expr = expr_of(ExprKind::simulation);
    expr->text = random_.pick(methods);
    for (const char* parameter : {"alpha", "n"}) {
        Binding binding;
        binding.variable = std::make_unique<Variable>(DeclKind::parameter);
        binding.variable->name = parameter;
        binding.value = at(plus_level, 0);
        expr->bindings.push_back(std::move(binding));
        if (random_.chance(50)) break;
    }
    return expr;
}

ExprPtr SyntaxBuilder::quantitative(std::size_t depth) {
    static const std::vector<std::string> forms = {"=?", "min=?", "max=?", ">", ">=", "<", "<="};
    const bool reward = random_.chance(40);
    ExprPtr expr = expr_of(reward ? ExprKind::reward : ExprKind::probability);
    expr->text = random_.pick(forms);
    if (reward && random_.chance(60)) expr->name = simple();
    if (reward) {
        ExprPtr counted = expr_of(ExprKind::path);
        constexpr PathOp ops[] = {PathOp::reachable, PathOp::linear_time, PathOp::cumulative, PathOp::total};
        counted->path = ops[random_.below(4)];
        counted->args.emplace_back();
        if (counted->path != PathOp::total) counted->args.push_back(expression(depth));
        expr->args.push_back(std::move(counted));
    } else {
        expr->args.push_back(path(depth));
        if (expr->args.back()->path == PathOp::until && random_.chance(30)) expr->args.back() = expression(depth);
    }
    const bool query = expr->text.back() == '?';
    expr->args.push_back(query ? nullptr : at(plus_level, 0));
    expr->args.emplace_back();
    return expr;
}

/// Returns a form that occurs only in probabilistic assertions.
SyntaxBuilder::Leveled SyntaxBuilder::probabilistic(std::size_t depth) {
    static const std::vector<std::string> events = {"in", "out", "in.val", "out.val"};
    static const std::vector<const char*> signs = {"$", "$$", "#", "@", "&"};
    constexpr int tightest = 100;
    const std::size_t below = depth > 0 ? depth - 1 : 0;
    switch (depth == 0 ? random_.below(3) : random_.below(6)) {
        case 0: {
            ExprPtr expr = named();
            expr->kind = ExprKind::event;
            expr->text = random_.pick(events);
            return {std::move(expr), tightest};
        }
        case 1: {
            ExprPtr expr = named();
            expr->kind = ExprKind::in_state;
            expr->args.push_back(named());
            return {std::move(expr), not_level};
        }
        case 2:
            return {marked(random_.pick(signs)), tightest};
        case 3: {
            ExprPtr expr = path(below);
            const bool until = expr->path == PathOp::until;
            return {std::move(expr), until ? not_level : -1};
        }
        case 4: {
            ExprPtr expr = expr_of(random_.chance(50) ? ExprKind::all_paths : ExprKind::some_path);
            expr->args.push_back(expression(below));
            return {std::move(expr), not_level};
        }
        default:
            return {quantitative(below), not_level};
    }
}

Update SyntaxBuilder::update() {
    Update result;
    if (random_.chance(40)) result.probability = at(plus_level, 0);
    result.variable = random_.chance(80) ? marked("@") : named();
    result.value = expression(1);
    return result;
}

ProbabilisticFunction SyntaxBuilder::function_of_properties() {
    ProbabilisticFunction function;
    function.name = name();
    for (std::size_t i = random_.below(3); i > 0; --i) {
        auto parameter = std::make_unique<Variable>(DeclKind::parameter);
        parameter->name = name();
        function.parameters.push_back(std::move(parameter));
    }
    if (random_.chance(60))
        function.result = expression(2);
    else
        for (std::size_t i = random_.between(1, 2); i > 0; --i) function.updates.push_back(update());
    return function;
}

ProbabilisticModule SyntaxBuilder::module_of_properties() {
    ProbabilisticModule module;
    module.name = name();
    for (std::size_t i = random_.below(3); i > 0; --i) {
        ModuleVariable declared;
        declared.variable = std::make_unique<Variable>(DeclKind::variable);
        declared.variable->name = name();
        if (random_.chance(50)) {
            declared.low = expression(0);
            declared.high = expression(0);
        }
        if (random_.chance(50)) declared.variable->initial = expression(1);
        module.variables.push_back(std::move(declared));
    }
    for (std::size_t i = random_.below(3); i > 0; --i) {
        Command command;
        if (random_.chance(70)) {
            command.event = named();
            command.event->kind = ExprKind::event;
            command.event->text = "in";
        }
        command.guard = expr_of(ExprKind::parenthesised);
        command.guard->args.push_back(expression(1));
        for (std::size_t count = random_.below(3); count > 0; --count) command.updates.push_back(update());
        module.commands.push_back(std::move(command));
    }
    return module;
}

void SyntaxBuilder::define(ProbabilisticDefinition& definition) {
    const std::size_t count = random_.between(1, 2);
    switch (definition.kind) {
        case ProbabilisticKind::constant:
            definition.constant = std::make_unique<Variable>(DeclKind::constant);
            definition.constant->name = definition.name;
            definition.constant->type_expr = type(0);
            return;
        case ProbabilisticKind::label:
        case ProbabilisticKind::formula:
            definition.value = expression(2);
            return;
        case ProbabilisticKind::constants:
        case ProbabilisticKind::rewards:
        case ProbabilisticKind::definitions:
        case ProbabilisticKind::modules:
            break;
    }
    for (std::size_t i = count; i > 0; --i) {
        if (definition.kind == ProbabilisticKind::definitions) definition.functions.push_back(function_of_properties());
        if (definition.kind == ProbabilisticKind::modules) definition.modules.push_back(module_of_properties());
        if (definition.kind == ProbabilisticKind::rewards) {
            RewardItem item;
            item.of_step = random_.chance(50);
            if (item.of_step && random_.chance(50)) item.event = named();
            item.guard = at(plus_level, 1);
            item.value = at(plus_level, 1);
            definition.rewards.push_back(std::move(item));
        }
        if (definition.kind != ProbabilisticKind::constants) continue;
        ConstantValues values;
        values.constant = named();
        values.from_set = random_.chance(40);
        values.value = values.from_set ? expr_of(ExprKind::set_range) : at(plus_level, 1);
        if (values.from_set) add_list(values.value->args, 2, 3, 0);
        definition.constants.push_back(std::move(values));
    }
}

ProbabilisticDefinition SyntaxBuilder::probabilistic_definition() {
    constexpr std::size_t kinds = 7;
    probabilistic_ = true;
    ProbabilisticDefinition definition;
    definition.kind = static_cast<ProbabilisticKind>(random_.below(kinds));
    definition.name = name();
    define(definition);
    probabilistic_ = false;
    return definition;
}

ProbabilisticAssertion SyntaxBuilder::probabilistic_assertion() {
    probabilistic_ = true;
    ProbabilisticAssertion assertion;
    assertion.name = name();
    if (random_.chance(70)) {
        assertion.property = random_.chance(40) ? quantitative(2) : expression(3);
        if (assertion.property->args.size() == 3 && assertion.property->kind == ExprKind::probability)
            assertion.property->args.back() = simulation();
    } else {
        if (random_.chance(50)) assertion.path.steps = at(plus_level, 0);
        if (!assertion.path.steps && random_.chance(50)) assertion.path.repeats = at(plus_level, 0);
        if (random_.chance(50)) assertion.path.limit = at(plus_level, 0);
    }
    for (const ProbabilisticKind kind :
         {ProbabilisticKind::constants, ProbabilisticKind::definitions, ProbabilisticKind::modules}) {
        if (random_.chance(60)) continue;
        ProbabilisticClause clause;
        clause.definition.kind = kind;
        if (random_.chance(60))
            clause.name = qualified();
        else
            define(clause.definition);
        assertion.clauses.push_back(std::move(clause));
    }
    if (random_.chance(30)) assertion.options = "\"-hybrid -x 'y'\"";
    probabilistic_ = false;
    return assertion;
}

}  // namespace robochart::random_models
