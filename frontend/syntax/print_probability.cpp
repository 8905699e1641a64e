// SPDX-License-Identifier: Apache-2.0
// Prints probabilistic assertions. See print.hpp.
#include <fmt/format.h>

#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

std::string written(const ExprPtr& expr) {
    return expr ? to_text(*expr) : std::string();
}

template <class Items, class Write>
std::string separated(const Items& items, std::string_view separator, Write write) {
    std::string out;
    for (const auto& item : items) out += (out.empty() ? "" : std::string(separator)) + write(item);
    return out;
}

/// `Finally <=10 φ`, `φ Until ψ`
std::string path(const Expr& expr) {
    const PathOp op = expr.path.value_or(PathOp::total);
    std::string out(to_text(op));
    if (expr.args[0]) out += " " + expr.text + written(expr.args[0]);
    if (expr.args.size() > 1) out += " " + written(expr.args.back());
    return expr.args.size() > 2 ? written(expr.args[1]) + " " + out : out;
}

/// `Prob=? of [φ] using sim with CI at …`
std::string quantitative(const Expr& expr) {
    std::string out = expr.kind == ExprKind::reward ? "Reward" : "Prob";
    if (!expr.name.empty()) out += " {" + written_name(expr.name) + "}";
    if (!expr.name.empty() || expr.text.starts_with("m")) out += " ";
    out += fmt::format("{}{} of [{}]", expr.text, written(expr.args[1]), written(expr.args[0]));
    return expr.args[2] ? out + " " + written(expr.args[2]) : out;
}

std::string simulation(const Expr& expr) {
    return fmt::format("using sim with {} at {}", expr.text, separated(expr.bindings, ", ", [](const Binding& each) {
                           return written_name(each.variable->name) + " = " + written(each.value);
                       }));
}

std::string label(const ExprPtr& event) {
    return "[" + written(event) + "] ";
}

std::string updates(const std::vector<Update>& list) {
    return separated(list, " & ", [](const Update& each) {
        const std::string probability = each.probability ? written(each.probability) + " : " : "";
        return fmt::format("({}{} = {})", probability, written(each.variable), written(each.value));
    });
}

std::string constants(const std::vector<ConstantValues>& list) {
    return separated(list, ", ", [](const ConstantValues& each) {
        return fmt::format("{} {} {}", written(each.constant), each.from_set ? "from set" : "set to",
                           written(each.value));
    });
}

std::string rewards(const std::vector<RewardItem>& items) {
    std::string out;
    for (const RewardItem& each : items)
        out +=
            fmt::format("{}{} : {}; ", each.of_step ? label(each.event) : "", written(each.guard), written(each.value));
    return out + "endrewards";
}

std::string function(const ProbabilisticFunction& each) {
    const std::string parameters =
        separated(each.parameters, ", ", [](const VariablePtr& parameter) { return written_name(parameter->name); });
    const std::string body = each.result ? "return " + written(each.result) : updates(each.updates);
    return fmt::format("{} {}({}) = {{ {} }}", each.result ? "pfunction" : "poperation", written_name(each.name),
                       parameters, body);
}

std::string variable(const ModuleVariable& each) {
    const std::string type = each.low ? fmt::format("[{} to {}]", written(each.low), written(each.high)) : "bool";
    const std::string initial = each.variable->initial ? " init " + written(each.variable->initial) : "";
    return fmt::format("{} : {}{}; ", written_name(each.variable->name), type, initial);
}

std::string module(const ProbabilisticModule& each) {
    std::string out = fmt::format("pmodule {} {{ ", written_name(each.name));
    for (const ModuleVariable& declared : each.variables) out += variable(declared);
    for (const Command& command : each.commands)
        out += fmt::format("{}{} -> {}; ", label(command.event), written(command.guard),
                           command.updates.empty() ? "skip" : updates(command.updates));
    return out + "}";
}

/// The text after the name of a definition and its `:` or `=`.
std::string body(const ProbabilisticDefinition& definition) {
    switch (definition.kind) {
        case ProbabilisticKind::constant:
            return definition.constant && definition.constant->type_expr ? to_text(*definition.constant->type_expr)
                                                                         : std::string();
        case ProbabilisticKind::constants:
            return constants(definition.constants);
        case ProbabilisticKind::label:
        case ProbabilisticKind::formula:
            return written(definition.value);
        case ProbabilisticKind::rewards:
            return rewards(definition.rewards);
        case ProbabilisticKind::definitions:
            return separated(definition.functions, " ", function);
        case ProbabilisticKind::modules:
            return separated(definition.modules, " ", module);
    }
    return {};
}

std::string clause(const ProbabilisticClause& clause) {
    const std::string_view word = clause.definition.kind == ProbabilisticKind::constants     ? "constants"
                                  : clause.definition.kind == ProbabilisticKind::definitions ? "definitions"
                                                                                             : "modules";
    return fmt::format(" with {} {}", word, clause.name.empty() ? body(clause.definition) : written_name(clause.name));
}

std::string generation(const PathGeneration& path) {
    std::string out = "using simulation for ";
    out += path.steps ? written(path.steps) + " steps" : "deadlock";
    if (path.repeats) out += fmt::format(" with {} repeats", written(path.repeats));
    return path.limit ? fmt::format("{} up to {} steps", out, written(path.limit)) : out;
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
            return path(expr);
        case ExprKind::probability:
        case ExprKind::reward:
            return quantitative(expr);
        case ExprKind::all_paths:
            return "Forall [" + written(expr.args[0]) + "]";
        case ExprKind::some_path:
            return "Exists [" + written(expr.args[0]) + "]";
        case ExprKind::in_state:
            return fmt::format("{} is in {}", written_name(expr.name), written(expr.args[0]));
        case ExprKind::event:
            return written_name(expr.name) + "." + expr.text;
        case ExprKind::marked:
            return expr.text + written_name(expr.name);
        case ExprKind::simulation:
            return simulation(expr);
        default:
            return "<error>";
    }
}

std::string to_text(const ProbabilisticDefinition& definition) {
    const bool equals = definition.kind == ProbabilisticKind::label || definition.kind == ProbabilisticKind::formula ||
                        definition.kind == ProbabilisticKind::rewards;
    return fmt::format("{} {} {} {}\n", to_text(definition.kind), written_name(definition.name), equals ? "=" : ":",
                       body(definition));
}

std::string to_text(const ProbabilisticAssertion& assertion) {
    return fmt::format("prob {} {} : {}\n", assertion.property ? "property" : "generate path",
                       written_name(assertion.name), claim(assertion));
}

std::string claim(const ProbabilisticAssertion& assertion) {
    std::string out = assertion.property ? written(assertion.property) : generation(assertion.path);
    for (const ProbabilisticClause& each : assertion.clauses) out += clause(each);
    return assertion.options.empty() ? out : out + " with cmdoptions " + assertion.options;
}

}  // namespace robochart::frontend
