// SPDX-License-Identifier: Apache-2.0
// Collects registers and outputs from the plan of the component (cpp_emit), without emitting code.
#include "conformance/model/model_interface.hpp"

#include <cassert>
#include <cmath>

#include "base/diagnostics/containers.hpp"
#include "conformance/model/component.hpp"
#include "cpp_emit/plan/component.hpp"
#include "cpp_emit/plan/resolve_component.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::conformance {

namespace {

/// Collects how the component uses numbers, and the constants with which it compares them.
class NumberCollector {
public:
    NumberCollector(const ir::System& system, const ir::Instantiation& instantiation,
                    const cpp_emit::Component& component)
        : system_(system), instantiation_(instantiation), component_(component) {}

    TestedNumbers collect() const {
        TestedNumbers found;
        std::vector<ir::MachineId> machines;
        for (const cpp_emit::Unit& unit : component_.units) machines.push_back(unit.id);
        found.sequences = tested_sequences(system_, instantiation_, component_);
        found.uses = data_independence(system_, machines, found.sequences.comparisons);
        for (const cpp_emit::Unit& unit : component_.units)
            ir::visit_expressions(*unit.machine, [&](const ir::Expr& root, ir::ExprRole) {
                ir::visit_operands(root, [&](const ir::Expr& expr) { collect_constant(unit, expr, found); });
            });
        for (auto& [kind, constants] : found.constants) {
            diagnostics::sort_unique(constants.ordered);
            diagnostics::sort_unique(constants.all);
        }
        diagnostics::sort_unique(found.literals);
        return found;
    }

private:
    /// Returns the number of a literal or a constant or of its negation, in a unit. Returns no value for other
    /// expressions.
    [[nodiscard]] std::optional<double> number_of(const cpp_emit::Unit& unit, const ir::Expr& expr) const {
        if (expr.kind == ir::ExprKind::integer) return static_cast<double>(expr.number);
        if (expr.kind == ir::ExprKind::real)
            return static_cast<double>(expr.decimal.unscaled) / std::pow(10.0, expr.decimal.decimals);
        if (expr.kind == ir::ExprKind::negate) {
            const auto number = number_of(unit, *expr.args[0]);
            return number ? std::optional(-*number) : std::nullopt;
        }
        if (expr.kind != ir::ExprKind::constant) return std::nullopt;
        const std::size_t index = expr.constant.index;
        const ir::TypeKind kind = system_.type(unit.machine->constants[index].type).kind;
        const auto number = static_cast<double>(unit.constants[index].number);
        if (kind == ir::TypeKind::real) return number / static_cast<double>(instantiation_.scale);
        return kind == ir::TypeKind::nat || kind == ir::TypeKind::integer ? std::optional(number) : std::nullopt;
    }

    void collect_constant(const cpp_emit::Unit& unit, const ir::Expr& expr, TestedNumbers& found) const {
        if (const auto number = number_of(unit, expr)) found.literals.push_back(*number);
        if (const auto sums = sum_comparison(system_, expr))
            found.sums.push_back({sums->kind, sums->relation, read_sum(unit, sums->left), read_sum(unit, sums->right)});
        const auto comparison = constant_comparison(system_, expr);
        if (!comparison) return;
        const auto number = number_of(unit, *comparison->constant);
        assert(number);  // an unknown constant would make replacements wrong
        found.constants[comparison->kind].all.push_back(*number);
        if (comparison->ordered) found.constants[comparison->kind].ordered.push_back(*number);
    }

    [[nodiscard]] std::vector<TestedSummand> read_sum(const cpp_emit::Unit& unit,
                                                      const std::vector<Summand>& sum) const {
        std::vector<TestedSummand> result;
        for (const Summand& summand : sum) {
            const auto constant = summand.held ? std::nullopt : number_of(unit, *summand.expr);
            assert(summand.held || constant);
            result.push_back({constant, summand.subtracted});
        }
        return result;
    }

    const ir::System& system_;
    const ir::Instantiation& instantiation_;
    const cpp_emit::Component& component_;
};

class Collector {
public:
    Collector(const ir::System& system, const ir::Instantiation& instantiation, const cpp_emit::Component& component)
        : system_(system), instantiation_(instantiation), component_(component) {}

    ModelInterface collect() {
        result_.interface.scale = instantiation_.scale;
        for (const cpp_emit::EventPort& event : component_.events)
            if (event.received) add_input(event.outside + ".in", event.type);
        for (const cpp_emit::StoredVariable& variable : component_.variables)
            if (!variable.input.empty() && !variable.copy)
                add_input("set_EXT_" + variable.name(), variable.variable->type);
        for (const cpp_emit::PlatformCall& call : component_.calls)
            add_output(call.signature->name + "Call", call.signature->parameters);
        for (const cpp_emit::EventPort& event : component_.events)
            if (!event.output.empty())
                add_output(event.outside + ".out",
                           event.type ? std::vector<ir::TypeId>{*event.type} : std::vector<ir::TypeId>{});
        for (const cpp_emit::StoredVariable& variable : component_.variables)
            if (variable.visible && !variable.copy) add_output("set_" + variable.name(), {variable.variable->type});
        return std::move(result_);
    }

private:
    void add_input(std::string name, std::optional<ir::TypeId> type) {
        Register shown;
        shown.name = std::move(name);
        if (type) add_values(shown, *type);
        result_.interface.inputs.push_back(std::move(shown));
        result_.input_types.push_back(type);
    }

    /// Adds the values of a type. Values with parts are numbered in the order of their carrier, as in the code's
    /// interface.
    void add_values(Register& shown, ir::TypeId type) const {
        const bool whole = cpp_emit::is_composed(system_.type(type));
        for (const ir::Value& value : ir::carrier_values(system_, instantiation_, type)) {
            shown.values.push_back(whole ? static_cast<std::int64_t>(shown.values.size()) : value.number);
            shown.texts.push_back(cpp_emit::cspm_value(system_, type, value));
        }
    }

    void add_output(std::string name, std::vector<ir::TypeId> types) {
        result_.interface.outputs.push_back({std::move(name), std::vector<Carrier>(types.size())});
        result_.output_types.push_back(std::move(types));
    }

    const ir::System& system_;
    const ir::Instantiation& instantiation_;
    const cpp_emit::Component& component_;
    ModelInterface result_;
};

}  // namespace

std::optional<TestedNumbers> tested_numbers(const ir::System& system, const ir::Instantiation& instantiation,
                                            const ir::ComponentRef& ref) {
    diagnostics::Diagnostics quiet;
    const auto component = cpp_emit::resolve_component(system, instantiation, ref, quiet);
    if (!component) return std::nullopt;
    return NumberCollector(system, instantiation, *component).collect();
}

std::optional<ModelInterface> model_interface(const ir::System& system, const ir::Instantiation& instantiation,
                                              const ir::ComponentRef& ref, const csp_emit::Provenance& provenance,
                                              diagnostics::Diagnostics& diagnostics) {
    const auto component = cpp_emit::resolve_component(system, instantiation, ref, diagnostics);
    if (!component) return std::nullopt;
    ModelInterface result = Collector(system, instantiation, *component).collect();
    result.numbers = NumberCollector(system, instantiation, *component).collect();
    complete_interface(result.interface, system, instantiation, ref, provenance);
    return result;
}

std::optional<Interface> component_interface(const ir::System& system, const ir::Instantiation& instantiation,
                                             const ir::ComponentRef& ref, const csp_emit::Provenance& provenance,
                                             diagnostics::Diagnostics& diagnostics) {
    const auto component = cpp_emit::resolve_component(system, instantiation, ref, diagnostics);
    if (!component) return std::nullopt;
    Interface result = Collector(system, instantiation, *component).collect().interface;
    complete_interface(result, system, instantiation, ref, provenance);
    return result;
}

}  // namespace robochart::conformance
