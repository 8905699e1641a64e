// SPDX-License-Identifier: Apache-2.0
// Implements printer.hpp. Parentheses are printed only if the tree requires them.
#include "prism/syntax/printer.hpp"

#include <fmt/format.h>

#include <string_view>

namespace robochart::prism {
namespace {

struct Spelling {
    std::string_view symbol;
    int level;  ///< precedence; greater is tighter
    bool right = false;
};

constexpr int temporal_level = 0;
constexpr int conditional_level = 1;
constexpr int not_level = 6;
constexpr int sum_level = 9;
constexpr int minus_level = 12;
constexpr int tightest = 13;

Spelling spelling(Op op) {
    switch (op) {
        case Op::until:
            return {" U", temporal_level};
        case Op::weak_until:
            return {" W", temporal_level};
        case Op::release:
            return {" R", temporal_level};
        case Op::implies:
            return {" => ", 2, true};
        case Op::iff:
            return {" <=> ", 3};
        case Op::disjunction:
            return {" | ", 4};
        case Op::conjunction:
            return {" & ", 5};
        case Op::equal:
            return {" = ", 7};
        case Op::unequal:
            return {" != ", 7};
        case Op::less:
            return {" < ", 8};
        case Op::less_equal:
            return {" <= ", 8};
        case Op::greater:
            return {" > ", 8};
        case Op::greater_equal:
            return {" >= ", 8};
        case Op::add:
            return {" + ", sum_level};
        case Op::subtract:
            return {" - ", sum_level};
        case Op::multiply:
            return {" * ", 10};
        case Op::divide:
            return {" / ", 10};
        case Op::power:
            return {" ^ ", 11, true};
        // clang-format off
        case Op::boolean: case Op::integer: case Op::real: case Op::name: case Op::label: case Op::conditional:
        case Op::negation: case Op::minus: case Op::call: case Op::probability: case Op::steady: case Op::reward:
        case Op::forall_paths: case Op::exists_path: case Op::filter: case Op::next: case Op::eventually:
        case Op::globally: case Op::cumulative: case Op::total: case Op::instantaneous: case Op::long_run:
            break;
    }
    // clang-format on
    return {"", tightest};
}

std::string text_of(const ExprPtr& expr, int level);

std::string list_text(const std::vector<ExprPtr>& parts) {
    std::string text;
    for (const ExprPtr& part : parts) text += (text.empty() ? "" : ", ") + text_of(part, temporal_level);
    return text;
}

std::string steps_text(const StepBound* steps) {
    if (steps == nullptr) return "";
    const auto side = [](const ExprPtr& expr) { return text_of(expr, tightest); };
    if (steps->single) return "=" + side(steps->low);
    if (steps->low && steps->high)
        return fmt::format("[{},{}]", text_of(steps->low, temporal_level), text_of(steps->high, temporal_level));
    if (steps->high) return (steps->high_strict ? "<" : "<=") + side(steps->high);
    return (steps->low_strict ? ">" : ">=") + side(steps->low);
}

std::string query_text(const Expr& expr) {
    const Query& query = *expr.query;
    std::string text = "R";
    if (expr.op == Op::probability) text = "P";
    if (expr.op == Op::steady) text = "S";
    if (!query.reward.text.empty()) text += fmt::format("{{\"{}\"}}", query.reward.text);
    if (query.reward_index) text += fmt::format("{{{}}}", text_of(query.reward_index, temporal_level));
    if (query.optimum == Optimum::minimum) text += "min";
    if (query.optimum == Optimum::maximum) text += "max";
    std::string relation(spelling(query.relation).symbol);
    std::erase(relation, ' ');
    text += relation + (query.bound ? text_of(query.bound, sum_level) : "?");
    return text + " [ " + text_of(expr.parts[0], temporal_level) + " ]";
}

std::string unary(std::string_view symbol, const Expr& expr) {
    const std::string steps = steps_text(expr.steps.get());
    const int level = temporal_level + 1;
    const Op inner = expr.parts[0]->op;
    const bool bare = inner == Op::next || inner == Op::eventually || inner == Op::globally;
    return fmt::format("{}{} {}", symbol, steps, text_of(expr.parts[0], bare ? temporal_level : level));
}

/// Returns the text and its precedence.
std::pair<std::string, int> text_and_level(const Expr& expr) {
    switch (expr.op) {
        case Op::boolean:
        case Op::integer:
        case Op::real:
        case Op::name:
            return {expr.text, tightest};
        case Op::label:
            return {fmt::format("\"{}\"", expr.text), tightest};
        case Op::call:
            return {fmt::format("{}({})", expr.text, list_text(expr.parts)), tightest};
        case Op::filter:
            return {fmt::format("filter({}, {})", expr.text, list_text(expr.parts)), tightest};
        case Op::probability:
        case Op::steady:
        case Op::reward:
            return {query_text(expr), tightest};
        case Op::forall_paths:
            return {fmt::format("A [ {} ]", list_text(expr.parts)), tightest};
        case Op::exists_path:
            return {fmt::format("E [ {} ]", list_text(expr.parts)), tightest};
        case Op::cumulative:
            return {"C<=" + text_of(expr.parts[0], temporal_level), temporal_level};
        case Op::total:
            return {"C", temporal_level};
        case Op::instantaneous:
            return {"I=" + text_of(expr.parts[0], temporal_level), temporal_level};
        case Op::long_run:
            return {"S", temporal_level};
        case Op::next:
            return {unary("X", expr), temporal_level};
        case Op::eventually:
            return {unary("F", expr), temporal_level};
        case Op::globally:
            return {unary("G", expr), temporal_level};
        case Op::negation:
            return {"!" + text_of(expr.parts[0], not_level), not_level};
        case Op::minus:
            return {"-" + text_of(expr.parts[0], minus_level), minus_level};
        case Op::conditional:
            return {fmt::format("{} ? {} : {}", text_of(expr.parts[0], conditional_level + 1),
                                text_of(expr.parts[1], conditional_level), text_of(expr.parts[2], conditional_level)),
                    conditional_level};
        // clang-format off
        case Op::implies: case Op::iff: case Op::disjunction: case Op::conjunction: case Op::equal: case Op::unequal:
        case Op::less: case Op::less_equal: case Op::greater: case Op::greater_equal: case Op::add: case Op::subtract:
        case Op::multiply: case Op::divide: case Op::power: case Op::until: case Op::weak_until: case Op::release:
            break;
    }
    // clang-format on
    const Spelling how = spelling(expr.op);
    const bool path = how.level == temporal_level;
    const std::string steps = path ? steps_text(expr.steps.get()) + " " : "";
    const std::string left = text_of(expr.parts[0], how.level + (how.right || path ? 1 : 0));
    const std::string right = text_of(expr.parts[1], how.level + (how.right ? 0 : 1));
    return {fmt::format("{}{}{}{}", left, how.symbol, steps, right), how.level};
}

/// Returns the text for a position that requires at least the precedence `level`, with parentheses if necessary.
std::string text_of(const ExprPtr& expr, int level) {
    auto [text, own] = text_and_level(*expr);
    return own < level ? "(" + text + ")" : text;
}

std::string constant_text(const Constant& constant) {
    const std::string value = constant.value ? " = " + print(constant.value) : "";
    return fmt::format("const {} {}{};\n", type_name(constant.type), constant.name.text, value);
}

std::string variable_text(const Variable& variable) {
    std::string type = variable.type == Type::boolean ? "bool" : "int";
    if (variable.low) type = fmt::format("[{}..{}]", print(variable.low), print(variable.high));
    const std::string initial = variable.initial ? " init " + print(variable.initial) : "";
    return fmt::format("{} : {}{};\n", variable.name.text, type, initial);
}

std::string branch_text(const Branch& branch) {
    std::string text = branch.probability ? text_of(branch.probability, temporal_level) + " : " : "";
    if (branch.assignments.empty()) return text + "true";
    bool first = true;
    for (const Assignment& assignment : branch.assignments) {
        text += fmt::format("{}({}' = {})", first ? "" : " & ", assignment.variable.text, print(assignment.value));
        first = false;
    }
    return text;
}

std::string command_text(const Command& command) {
    std::string text = fmt::format("  [{}] {} -> ", command.action.text, print(command.guard));
    for (std::size_t i = 0; i < command.branches.size(); ++i)
        text += (i == 0 ? "" : " + ") + branch_text(command.branches[i]);
    return text + ";\n";
}

std::string renamings_text(const std::vector<Renaming>& renamings, std::string_view between) {
    std::string text;
    for (const Renaming& renaming : renamings)
        text += fmt::format("{}{}{}{}", text.empty() ? "" : ", ", renaming.from.text, between, renaming.to.text);
    return text;
}

std::string module_text(const Module& module) {
    if (!module.base.text.empty())
        return fmt::format("module {} = {} [ {} ] endmodule\n", module.name.text, module.base.text,
                           renamings_text(module.renamings, " = "));
    std::string text = fmt::format("module {}\n", module.name.text);
    for (const Variable& variable : module.variables) text += "  " + variable_text(variable);
    for (const Command& command : module.commands) text += command_text(command);
    return text + "endmodule\n";
}

std::string rewards_text(const RewardStructure& rewards) {
    std::string text = "rewards";
    if (!rewards.name.text.empty()) text += fmt::format(" \"{}\"", rewards.name.text);
    text += "\n";
    for (const RewardItem& item : rewards.items) {
        const std::string action = item.transition ? fmt::format("[{}] ", item.action.text) : "";
        text += fmt::format("  {}{} : {};\n", action, print(item.guard), print(item.value));
    }
    return text + "endrewards\n";
}

std::string actions_text(const std::vector<Name>& actions) {
    std::string text;
    for (const Name& action : actions) text += (text.empty() ? "" : ", ") + action.text;
    return text;
}

std::string composition_text(const Composition& system) {
    using Kind = Composition::Kind;
    const auto part = [&](std::size_t i) {
        const std::string text = composition_text(*system.parts[i]);
        return system.parts[i]->kind == Kind::module ? text : "(" + text + ")";
    };
    switch (system.kind) {
        case Kind::module:
            return system.module.text;
        case Kind::common:
            return part(0) + " || " + part(1);
        case Kind::interleaved:
            return part(0) + " ||| " + part(1);
        case Kind::on_actions:
            return fmt::format("{} |[{}]| {}", part(0), actions_text(system.actions), part(1));
        case Kind::hide:
            return fmt::format("{} / {{{}}}", part(0), actions_text(system.actions));
        case Kind::rename:
            return fmt::format("{} {{{}}}", part(0), renamings_text(system.renamings, " <- "));
    }
    return "";
}

std::string labels_text(const std::vector<Definition>& labels) {
    std::string text;
    for (const Definition& label : labels)
        text += fmt::format("label \"{}\" = {};\n", label.name.text, print(label.body));
    return text;
}

}  // namespace

std::string print(const ExprPtr& expr) {
    return text_of(expr, temporal_level);
}

std::string print(const ModelFile& file) {
    std::string text = file.kind == ModelKind::dtmc ? "dtmc\n" : "mdp\n";
    for (const Constant& constant : file.constants) text += constant_text(constant);
    for (const Definition& formula : file.formulas)
        text += fmt::format("formula {} = {};\n", formula.name.text, print(formula.body));
    for (const Variable& variable : file.globals) text += "global " + variable_text(variable);
    for (const Module& module : file.modules) text += module_text(module);
    if (file.initial) text += fmt::format("init\n  {}\nendinit\n", print(file.initial));
    if (file.system) text += fmt::format("system\n  {}\nendsystem\n", composition_text(*file.system));
    for (const RewardStructure& structure : file.rewards) text += rewards_text(structure);
    return text + labels_text(file.labels);
}

std::string print(const PropertyFile& file) {
    std::string text;
    for (const Constant& constant : file.constants) text += constant_text(constant);
    text += labels_text(file.labels);
    for (const Property& property : file.properties) {
        if (!property.name.text.empty()) text += fmt::format("\"{}\": ", property.name.text);
        text += print(property.expression) + ";\n";
    }
    return text;
}

}  // namespace robochart::prism
