// SPDX-License-Identifier: Apache-2.0
// Prints probabilistic assertions. See print.hpp.
#include <fmt/format.h>

#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

std::string text_or_empty(const ExprPtr& expr) {
    return expr ? to_text(*expr) : std::string();
}

template <class Items, class Write>
std::string join_with(const Items& items, std::string_view separator, Write write) {
    std::string out;
    for (const auto& item : items) out += (out.empty() ? "" : std::string(separator)) + write(item);
    return out;
}

/// Prints `Finally <=10 φ` or `φ Until ψ`.
std::string path_text(const Expr& expr) {
    const PathOp op = expr.path.value_or(PathOp::total);
    std::string out(to_text(op));
    if (expr.args[0]) out += " " + expr.text + text_or_empty(expr.args[0]);
    if (expr.args.size() > 1) out += " " + text_or_empty(expr.args.back());
    return expr.args.size() > 2 ? text_or_empty(expr.args[1]) + " " + out : out;
}

/// Prints `Prob=? of [φ] using sim with CI at …`.
std::string quantitative_text(const Expr& expr) {
    std::string out = expr.kind == ExprKind::reward ? "Reward" : "Prob";
    if (!expr.name.empty()) out += " {" + written_name(expr.name) + "}";
    if (!expr.name.empty() || expr.text.starts_with("m")) out += " ";
    out += fmt::format("{}{} of [{}]", expr.text, text_or_empty(expr.args[1]), text_or_empty(expr.args[0]));
    return expr.args[2] ? out + " " + text_or_empty(expr.args[2]) : out;
}

std::string simulation_text(const Expr& expr) {
    return fmt::format("using sim with {} at {}", expr.text, join_with(expr.bindings, ", ", [](const Binding& binding) {
                           return written_name(binding.variable->name) + " = " + text_or_empty(binding.value);
                       }));
}

std::string label_text(const ExprPtr& event) {
    return "[" + text_or_empty(event) + "] ";
}

std::string updates_text(const std::vector<Update>& list) {
    return join_with(list, " & ", [](const Update& update) {
        const std::string probability = update.probability ? text_or_empty(update.probability) + " : " : "";
        return fmt::format("({}{} = {})", probability, text_or_empty(update.variable), text_or_empty(update.value));
    });
}

std::string constants_text(const std::vector<ConstantValues>& list) {
    return join_with(list, ", ", [](const ConstantValues& setting) {
        return fmt::format("{} {} {}", text_or_empty(setting.constant), setting.from_set ? "from set" : "set to",
                           text_or_empty(setting.value));
    });
}

std::string rewards_text(const std::vector<RewardItem>& items) {
    std::string out;
    for (const RewardItem& reward : items)
        out += fmt::format("{}{} : {}; ", reward.of_step ? label_text(reward.event) : "", text_or_empty(reward.guard),
                           text_or_empty(reward.value));
    return out + "endrewards";
}

std::string function_text(const ProbabilisticFunction& function) {
    const std::string parameters = join_with(
        function.parameters, ", ", [](const VariablePtr& parameter) { return written_name(parameter->name); });
    const std::string body =
        function.result ? "return " + text_or_empty(function.result) : updates_text(function.updates);
    return fmt::format("{} {}({}) = {{ {} }}", function.result ? "pfunction" : "poperation",
                       written_name(function.name), parameters, body);
}

std::string module_variable_text(const ModuleVariable& declared) {
    const std::string type =
        declared.low ? fmt::format("[{} to {}]", text_or_empty(declared.low), text_or_empty(declared.high)) : "bool";
    const std::string initial = declared.variable->initial ? " init " + text_or_empty(declared.variable->initial) : "";
    return fmt::format("{} : {}{}; ", written_name(declared.variable->name), type, initial);
}

std::string module_text(const ProbabilisticModule& module) {
    std::string out = fmt::format("pmodule {} {{ ", written_name(module.name));
    for (const ModuleVariable& declared : module.variables) out += module_variable_text(declared);
    for (const Command& command : module.commands)
        out += fmt::format("{}{} -> {}; ", label_text(command.event), text_or_empty(command.guard),
                           command.updates.empty() ? "skip" : updates_text(command.updates));
    return out + "}";
}

/// Returns the text after the name of a definition and its `:` or `=`.
std::string definition_text(const ProbabilisticDefinition& definition) {
    switch (definition.kind) {
        case ProbabilisticKind::constant:
            return definition.constant && definition.constant->type_expr ? to_text(*definition.constant->type_expr)
                                                                         : std::string();
        case ProbabilisticKind::constants:
            return constants_text(definition.constants);
        case ProbabilisticKind::label:
        case ProbabilisticKind::formula:
            return text_or_empty(definition.value);
        case ProbabilisticKind::rewards:
            return rewards_text(definition.rewards);
        case ProbabilisticKind::definitions:
            return join_with(definition.functions, " ", function_text);
        case ProbabilisticKind::modules:
            return join_with(definition.modules, " ", module_text);
    }
    return {};
}

std::string clause_text(const ProbabilisticClause& clause) {
    std::string_view word = "modules";
    if (clause.definition.kind == ProbabilisticKind::constants) word = "constants";
    if (clause.definition.kind == ProbabilisticKind::definitions) word = "definitions";
    return fmt::format(" with {} {}", word,
                       clause.name.empty() ? definition_text(clause.definition) : written_name(clause.name));
}

std::string generation_text(const PathGeneration& path) {
    std::string out = "using simulation for ";
    out += path.steps ? text_or_empty(path.steps) + " steps" : "deadlock";
    if (path.repeats) out += fmt::format(" with {} repeats", text_or_empty(path.repeats));
    return path.limit ? fmt::format("{} up to {} steps", out, text_or_empty(path.limit)) : out;
}

}  // namespace

std::string_view to_text(PathOp op) {
    switch (op) {
        case PathOp::eventually:
            return "Finally";
        case PathOp::globally:
            return "Globally";
        case PathOp::next:
            return "Next";
        case PathOp::until:
            return "Until";
        case PathOp::weak_until:
            return "Weak Until";
        case PathOp::release:
            return "Release";
        case PathOp::reachable:
            return "Reachable";
        case PathOp::linear_time:
            return "LTL";
        case PathOp::cumulative:
            return "Cumul";
        case PathOp::total:
            break;
    }
    return "Total";
}

std::string_view to_text(ProbabilisticKind kind) {
    switch (kind) {
        case ProbabilisticKind::constant:
            return "const";
        case ProbabilisticKind::constants:
            return "constants";
        case ProbabilisticKind::label:
            return "label";
        case ProbabilisticKind::formula:
            return "formula";
        case ProbabilisticKind::rewards:
            return "rewards";
        case ProbabilisticKind::definitions:
            return "defs";
        case ProbabilisticKind::modules:
            break;
    }
    return "pmodules";
}

std::string probabilistic_text(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::path:
            return path_text(expr);
        case ExprKind::probability:
        case ExprKind::reward:
            return quantitative_text(expr);
        case ExprKind::all_paths:
            return "Forall [" + text_or_empty(expr.args[0]) + "]";
        case ExprKind::some_path:
            return "Exists [" + text_or_empty(expr.args[0]) + "]";
        case ExprKind::in_state:
            return fmt::format("{} is in {}", written_name(expr.name), text_or_empty(expr.args[0]));
        case ExprKind::event:
            return written_name(expr.name) + "." + expr.text;
        case ExprKind::marked:
            return expr.text + written_name(expr.name);
        case ExprKind::simulation:
            return simulation_text(expr);
        default:
            return "<error>";
    }
}

std::string to_text(const ProbabilisticDefinition& definition) {
    const bool equals = definition.kind == ProbabilisticKind::label || definition.kind == ProbabilisticKind::formula ||
                        definition.kind == ProbabilisticKind::rewards;
    return fmt::format("{} {} {} {}\n", to_text(definition.kind), written_name(definition.name), equals ? "=" : ":",
                       definition_text(definition));
}

std::string to_text(const ProbabilisticAssertion& assertion) {
    return fmt::format("prob {} {} : {}\n", assertion.property ? "property" : "generate path",
                       written_name(assertion.name), claim_text(assertion));
}

std::string claim_text(const ProbabilisticAssertion& assertion) {
    std::string out = assertion.property ? text_or_empty(assertion.property) : generation_text(assertion.path);
    for (const ProbabilisticClause& clause : assertion.clauses) out += clause_text(clause);
    return assertion.options.empty() ? out : out + " with cmdoptions " + assertion.options;
}

}  // namespace robochart::frontend
