#include "cpp_emit/uses.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/code_writer.hpp"
#include "cpp_emit/files.hpp"
#include "cpp_emit/generation.hpp"
#include "cpp_emit/types.hpp"
#include "cpp_emit/walk.hpp"
#include "semantics/toolkit.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;
using ir::TypeKind;

namespace {

/// The types whose values an expression visits.
std::vector<ir::TypeId> visited(const ir::System& system, const ir::Expr& expr) {
    switch (expr.kind) {
        case ExprKind::forall:
        case ExprKind::exists:
        case ExprKind::exists_unique:
        case ExprKind::lambda:
        case ExprKind::the:
        case ExprKind::set_comprehension:
            return expr.bound_types;
        case ExprKind::function_value:
            return {system.type(expr.type).args.at(0)};
        case ExprKind::range: {
            const ir::TypeId member = system.type(expr.type).args.at(0);
            return system.type(member).kind == TypeKind::real ? std::vector<ir::TypeId>{member}
                                                              : std::vector<ir::TypeId>{};
        }
        case ExprKind::toolkit: {
            std::vector<ir::TypeId> result;
            for (const std::size_t place : ir::toolkit_carriers(expr.text))
                result.push_back(expr.bound_types.at(place));
            return result;
        }
        default:
            return {};
    }
}

class Uses {
public:
    Uses(Component& component, const ir::System& system) : component_(component), system_(system) {}

    void collect() {
        for (const Part& part : component_.parts)
            for (const EventUse& event : part.events)
                if (event.type) type(*event.type);
        for (const FunctionHook& hook : component_.functions) signature(system_.functions[hook.id.index]);
        for (const PlatformCall& call : component_.calls)
            for (const ir::TypeId parameter : call.signature->parameters) type(parameter);
        for (const Unit& unit : component_.units) {
            for (const ir::Node& node : unit.machine->nodes)
                component_.probabilistic = component_.probabilistic || node.kind == ir::NodeKind::probabilistic;
            for (const ir::Variable& variable : unit.machine->variables) type(variable.type);
            visit_expressions(*unit.machine, [&](const ir::Expr& expr) { expression(expr); });
        }
        visit_asked(component_, system_, [&](const ir::Expr& expr) { expression(expr); });
        component_.matrices = component_.matrices || component_.toolkit;
    }

private:
    void signature(const ir::Function& function) {
        for (const ir::TypeId parameter : function.parameters) type(parameter);
        type(function.result);
    }

    void expression(const ir::Expr& expr) {
        if (expr.type.valid()) type(expr.type);
        const bool converts = expr.kind == ExprKind::toolkit || expr.kind == ExprKind::cast ||
                              expr.kind == ExprKind::apply || expr.kind == ExprKind::function_value ||
                              expr.kind == ExprKind::set_range || expr.kind == ExprKind::range ||
                              expr.kind == ExprKind::is_type;
        const bool with_parts = expr.type.valid() && composed(system_.type(expr.type));
        component_.toolkit = component_.toolkit || (converts && (with_parts || expr.kind != ExprKind::cast));
        for (const ir::ExprPtr& part : expr.args)
            if (part && part->type.valid() && with_parts && mixed(part->type)) component_.toolkit = true;
        for (const ir::TypeId each : visited(system_, expr)) carrier(each);
    }

    /// Values with parts may be converted where they are used as others.
    [[nodiscard]] bool mixed(ir::TypeId id) const { return composed(system_.type(id)); }

    void carrier(ir::TypeId id) {
        const auto same = [&](const CarrierUse& use) { return use.type == id; };
        if (std::any_of(component_.carriers.begin(), component_.carriers.end(), same)) return;
        component_.carriers.push_back({id, scope_.unique("any_" + system_.type(id).name)});
    }

    // Types may contain themselves.
    void type(ir::TypeId id) {
        if (std::find(seen_.begin(), seen_.end(), id) != seen_.end()) return;
        seen_.push_back(id);
        const ir::Type& found = system_.type(id);
        component_.matrices = component_.matrices || block(found);
        component_.strings = component_.strings || found.kind == TypeKind::string;
        const bool of_parts = found.kind == TypeKind::set && composed(system_.type(found.args.at(0)));
        component_.toolkit = component_.toolkit || of_pairs(found) || of_parts;
        component_.ordered = component_.ordered || of_pairs(found) || of_parts;
        for (const ir::TypeId part : found.args) type(part);
        for (const auto& arguments : found.literal_args)
            for (const ir::TypeId part : arguments) type(part);
    }

    Component& component_;
    const ir::System& system_;
    NameScope scope_;
    std::vector<ir::TypeId> seen_;
};

}  // namespace

void collect_uses(Component& component, const ir::System& system) {
    Uses(component, system).collect();
}

std::vector<OutputFile> shipped_headers() {
    return {{"robochart/composed.hpp", composed_header()},
            {"robochart/drive_abi.h", drive_header()},
            {"robochart/eigen.hpp", eigen_header()},
            {"robochart/explore.hpp", explore_helpers()},
            {"robochart/explore_values.hpp", explore_values()},
            {"robochart/explore_abi.h", explore_header()},
            {"robochart/finite.hpp", finite_header()},
            {"robochart/layout.hpp", layout_helpers()},
            {"robochart/matrix.hpp", matrix_header()},
            {"robochart/runtime.hpp", runtime_header()},
            {"robochart/text.hpp", text_header()},
            {"robochart/timer.hpp", timer_header()},
            {"robochart/toolkit.hpp", toolkit_header()},
            {"robochart/trace.hpp", trace_helpers()}};
}

std::vector<OutputFile> value_headers(const Component& component) {
    std::vector<OutputFile> result = {{"robochart/composed.hpp", composed_header()}};
    if (component.matrices) result.push_back({"robochart/matrix.hpp", matrix_header()});
    if (component.matrices) result.push_back({"robochart/eigen.hpp", eigen_header()});
    if (component.toolkit) result.push_back({"robochart/toolkit.hpp", toolkit_header()});
    if (component.strings) result.push_back({"robochart/text.hpp", text_header()});
    return result;
}

void write_carriers(const Generation& generation, CodeWriter& out) {
    for (const CarrierUse& use : generation.component.carriers) {
        std::vector<std::string> values;
        for (const ir::Value& value : ir::carrier(generation.system, generation.inst, use.type))
            values.push_back(cpp_value(generation.system, generation.inst, use.type, value));
        const std::string type = cpp_type(generation.system, use.type);
        out.gap();
        out.doc(fmt::format("Visits the values of {}, as the model was made finite, until one is accepted.",
                            generation.system.type(use.type).name));
        out.line("template <class Visit>");
        out.open(fmt::format("static bool {}(Visit visit) noexcept {{", use.method));
        out.open(fmt::format("const {} values[] = {{", type));
        for (const std::string& value : values) out.line(value + ",");
        out.close("};");
        out.line(fmt::format("for (const {}& value : values)", type));
        out.line("    if (visit(value)) return true;");
        out.line("return false;");
        out.close();
    }
}

}  // namespace robochart::cpp_emit
