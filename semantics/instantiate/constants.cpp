// SPDX-License-Identifier: Apache-2.0
// Determines the values of constants (semantics 3.13: a constant without a value is 0, or the first literal).
#include "semantics/instantiate/constants.hpp"

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>
#include <vector>

#include "base/diagnostics/spelling.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/evaluate/evaluate.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/numbers.hpp"
#include "semantics/ir/own_constants.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

using diagnostics::Diagnostics;

/// True if an option's name refers to this constant: it is the path or the end of the path after a "::".
bool refers_to(const std::string& option, const std::string& path) {
    if (option.size() > path.size()) return false;
    const std::size_t start = path.size() - option.size();
    return path.compare(start, option.size(), option) == 0 &&
           (start == 0 || (start >= 2 && path.compare(start - 2, 2, "::") == 0));
}

ExprPtr make_expression(Expr expr, TypeId type) {
    expr.type = type;
    return std::make_shared<const Expr>(std::move(expr));
}

ExprPtr whole_number(const std::string& text, TypeId type, bool natural) {
    const auto number = parse_integer(text);
    if (!number || (natural && *number < 0)) return nullptr;
    Expr expr;
    expr.number = *number;
    return make_expression(expr, type);
}

ExprPtr decimal_number(const std::string& text, TypeId type) {
    const auto decimal = parse_decimal(text);
    if (!decimal) return nullptr;
    Expr expr;
    expr.kind = ExprKind::real;
    expr.decimal = *decimal;
    return make_expression(expr, type);
}

ExprPtr truth_value(const std::string& text, TypeId type) {
    if (text != "true" && text != "false") return nullptr;
    Expr expr;
    expr.kind = ExprKind::boolean;
    expr.number = text == "true" ? 1 : 0;
    return make_expression(expr, type);
}

ExprPtr literal_of(const Type& declaration, const std::string& text, TypeId type) {
    for (std::size_t i = 0; i < declaration.labels.size(); ++i) {
        const std::string& label = declaration.labels[i];
        const bool plain = i >= declaration.literal_args.size() || declaration.literal_args[i].empty();
        if (!plain || !refers_to(text, declaration.package + "::" + declaration.name + "::" + label)) continue;
        Expr expr;
        expr.kind = ExprKind::enum_literal;
        expr.number = static_cast<std::int64_t>(i);
        expr.text = label;
        return make_expression(expr, type);
    }
    return nullptr;
}

}  // namespace

ExprPtr parse_literal(const System& system, TypeId id, const std::string& text) {
    const Type& type = system.type(id);
    switch (type.kind) {
        case TypeKind::boolean:
            return truth_value(text, id);
        case TypeKind::nat:
            return whole_number(text, id, true);
        case TypeKind::integer:
            return whole_number(text, id, false);
        case TypeKind::real:
            return decimal_number(text, id);
        case TypeKind::enumeration:
            return literal_of(type, text, id);
        case TypeKind::string:
        case TypeKind::given:
        case TypeKind::sequence:
        case TypeKind::set:
        case TypeKind::product:
        case TypeKind::record:
        case TypeKind::function:
        case TypeKind::relation:
        case TypeKind::vector:
        case TypeKind::matrix:
        case TypeKind::unit:
            break;
    }
    return nullptr;
}

namespace {

std::string suggestion_text(const std::string& name, const std::vector<NamedConstant>& constants) {
    std::vector<std::string> candidates;
    candidates.reserve(constants.size());
    for (const auto& constant : constants) candidates.push_back(constant.path.substr(constant.path.rfind(':') + 1));
    const std::string meant = diagnostics::nearest_spelling(name, candidates);
    return meant.empty() ? "" : "; did you mean '" + meant + "'?";
}

}  // namespace

bool names_constant(const System& system, const std::string& option) {
    const auto constants = named_constants(system);
    return std::ranges::any_of(constants,
                               [&](const NamedConstant& constant) { return refers_to(option, constant.path); });
}

GivenConstants not_overridden(const System& system, const GivenConstants& weaker, const GivenConstants& stronger) {
    const auto constants = named_constants(system);
    const auto named = [&](const std::string& path) {
        return std::ranges::any_of(stronger, [&](const auto& option) { return refers_to(option.first, path); });
    };
    // An option that sets the machine's own constant also sets it in all controllers that run the machine.
    const auto own = own_constants(system);
    std::set<std::string> set_by_machine;
    for (const NamedConstant& constant : constants)
        if (named(constant.path)) set_by_machine.insert(constant.name);
    const auto overridden = [&](const NamedConstant& constant) {
        const auto machines = own.find(constant.name);
        return named(constant.path) || (machines != own.end() && set_by_machine.contains(machines->second));
    };
    GivenConstants result;
    for (const auto& [option, text] : weaker) {
        bool known = false, left = false;
        for (const NamedConstant& constant : constants) {
            if (!refers_to(option, constant.path)) continue;
            known = true;
            left = left || !overridden(constant);
        }
        if (left || !known) result.emplace(option, text);
    }
    return result;
}

namespace {

/// Adds the values that options give to constants, and reports wrong options.
void choose_by_options(const System& system, const GivenConstants& options, ChosenConstants& chosen,
                       Diagnostics& diagnostics) {
    std::map<std::string, std::string> chosen_by;  // the option that names a constant, by the constant's path
    std::set<std::pair<std::string, std::string>> refused;
    const auto constants = named_constants(system);
    for (const auto& [option, text] : options) {
        bool known = false;
        for (const auto& constant : constants) {
            if (!refers_to(option, constant.path)) continue;
            known = true;
            const auto [by, first] = chosen_by.emplace(constant.path, option);
            if (!first && refused.emplace(by->second, option).second)
                diagnostics.report(rules::constant_named_twice, {}, {by->second, option, constant.path});
            if (!first) continue;
            const ExprPtr value = parse_literal(system, constant.type, text);
            if (!value) {
                diagnostics.report(rules::bad_constant_value, {}, {option, text, system.type(constant.type).name});
                break;
            }
            chosen[constant.name] = value;
        }
        if (!known)
            diagnostics.report(rules::unknown_constant_option, {}, {option, suggestion_text(option, constants)});
    }
}

}  // namespace

ChosenConstants chosen_constants(const System& system, const GivenConstants& options, const SetConstants& by_claim,
                                 Literals& literals, Diagnostics& diagnostics) {
    ChosenConstants chosen;
    choose_by_options(system, options, chosen, diagnostics);
    const ChosenConstants set(by_claim.begin(), by_claim.end());
    for (const auto& [name, value] : set) chosen.insert_or_assign(name, ExprPtr(value));
    for (const NamedConstant& constant : named_constants(system))
        if (const auto value = chosen.find(constant.name); value != chosen.end()) {
            const std::string name = constant.path.substr(constant.path.rfind(':') + 1);
            add_literals(system, *value->second, literals.durations.contains(name), literals);
        }
    // A machine's own constant has its value in all controllers that run the machine. A value that a claim sets for the
    // machine also overrides those that options give to its parts.
    for (const auto& [part, own] : own_constants(system)) {
        if (const auto value = set.find(own); value != set.end() && !set.contains(part))
            chosen.insert_or_assign(part, ExprPtr(value->second));
        else if (const auto option = chosen.find(own); option != chosen.end())
            chosen.emplace(part, ExprPtr(option->second));
    }
    return chosen;
}

void check_shared_constants(const System& system, const Instantiation& instantiation, Diagnostics& diagnostics) {
    const auto value_of = [&](const ConstantSource& source) -> const Value* {
        const auto found = instantiation.constants.find(source.name);
        return found == instantiation.constants.end() ? nullptr : &found->second;
    };
    for (const SharedConstant& shared : shared_constants(system)) {
        const Value* first = value_of(shared.sources.front());
        const bool same = std::ranges::all_of(shared.sources, [&](const ConstantSource& source) {
            const Value* value = value_of(source);
            return (value == nullptr) == (first == nullptr) && (value == nullptr || *value == *first);
        });
        if (!same)
            diagnostics.report(
                rules::ambiguous_constant, shared.operation->origin.span,
                {shared.operation->name, shared.constant, shared.controller->name, shared.source_names()});
    }
}

void set_constants(const System& system, const ChosenConstants& chosen, Instantiation& instantiation) {
    for (const auto& constant : named_constants(system)) {
        const auto it = chosen.find(constant.name);
        if (it != chosen.end()) {
            if (const auto value = evaluate_constant(system, instantiation, nullptr, *it->second))
                instantiation.constants[constant.name] = *value;
        } else if (!constant.has_value) {
            instantiation.constants[constant.name] = default_value(system, instantiation, constant.type);
        }
    }
}

namespace {

/// Returns the value from a source. A constant expression may use other constants of the machine, up to a limit on
/// nesting.
std::optional<Value> source_value(const System& system, const Instantiation& instantiation,
                                  const ConstantSource& source, const std::vector<Value>& before) {
    const auto it = instantiation.constants.find(source.name);
    if (it != instantiation.constants.end()) return it->second;
    if (source.constant == nullptr || !source.constant->value) return std::nullopt;
    try {
        return evaluate_expression(system, instantiation, nullptr, {{}, before, {}, {}}, *source.constant->value);
    } catch (const EvaluationFault&) {
        return std::nullopt;
    } catch (const std::length_error&) {
        return std::nullopt;
    }
}

}  // namespace

std::vector<Value> constant_values(const System& system, const Instantiation& instantiation, const Module* module,
                                   const Controller* controller, const std::string& part, const Machine& machine) {
    std::vector<Value> values;
    for (std::uint32_t i = 0; i < machine.constants.size(); ++i) {
        const auto source = constant_source(system, module, controller, part, machine, ConstantId{i});
        const auto value = source_value(system, instantiation, source, values);
        values.push_back(value ? *value : default_value(system, instantiation, machine.constants[i].type));
    }
    return values;
}

std::int64_t cycle_of(const System& system, const Instantiation& instantiation, const ComponentRef& ref) {
    const std::vector<Constant>* constants = nullptr;
    if (ref.kind == ComponentKind::machine) constants = &system.machines.at(ref.definition).constants;
    if (ref.kind == ComponentKind::controller) constants = &system.controllers.at(ref.definition).constants;
    if (ref.kind == ComponentKind::module) constants = &system.modules.at(ref.definition).platform.constants;
    assert(constants != nullptr);
    const auto found = std::ranges::find(*constants, cycle_length, &Constant::name);
    assert(found != constants->end());
    const ConstantSource source{constant_name(ref.package, ref.path, cycle_length), &*found};
    const auto value = source_value(system, instantiation, source, {});
    return value ? value->number : 1;
}

std::optional<Value> evaluate_constant(const System& system, const Instantiation& instantiation, const Machine* machine,
                                       const Expr& expr) {
    Environment environment;
    try {
        if (machine != nullptr)
            environment.constants = constant_values(system, instantiation, nullptr, nullptr, "", *machine);
        return evaluate_expression(system, instantiation, machine, environment, expr);
    } catch (const EvaluationFault&) {
        return std::nullopt;
    } catch (const std::length_error&) {
        return std::nullopt;
    }
}

}  // namespace robochart::ir
