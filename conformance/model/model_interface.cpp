// SPDX-License-Identifier: Apache-2.0
// Collects registers and outputs from the plan of the component (cpp_emit), without emitting code.
#include "conformance/model/model_interface.hpp"

#include "conformance/model/component.hpp"
#include "cpp_emit/plan/component.hpp"
#include "cpp_emit/plan/resolve_component.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::conformance {

namespace {

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
                add_input("set_EXT_" + variable.variable->name, variable.variable->type);
        for (const cpp_emit::PlatformCall& call : component_.calls)
            add_output(call.signature->name + "Call", call.signature->parameters);
        for (const cpp_emit::EventPort& event : component_.events)
            if (!event.output.empty())
                add_output(event.outside + ".out",
                           event.type ? std::vector<ir::TypeId>{*event.type} : std::vector<ir::TypeId>{});
        for (const cpp_emit::StoredVariable& variable : component_.variables)
            if (variable.visible && !variable.copy)
                add_output("set_" + variable.variable->name, {variable.variable->type});
        std::vector<ir::MachineId> machines;
        for (const cpp_emit::Unit& unit : component_.units) machines.push_back(unit.id);
        result_.passed_on = data_independence(system_, machines);
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

    /// Numbers values with parts in the order of their carrier, as the code's interface does.
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

std::optional<ModelInterface> model_interface(const ir::System& system, const ir::Instantiation& instantiation,
                                              const ir::ComponentRef& ref, const csp_emit::Provenance& provenance,
                                              diagnostics::Diagnostics& diagnostics) {
    const auto component = cpp_emit::resolve_component(system, instantiation, ref, diagnostics);
    if (!component) return std::nullopt;
    ModelInterface result = Collector(system, instantiation, *component).collect();
    complete_interface(result.interface, system, instantiation, ref, provenance);
    return result;
}

}  // namespace robochart::conformance
