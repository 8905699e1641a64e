// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/core_properties.hpp"

#include <fmt/format.h>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/assertion_forms.hpp"
#include "csp_emit/assertions.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::PropertyKind;

namespace {

/// Writes the properties of one component.
class CoreProperties {
public:
    CoreProperties(const Project& project, NameManager& names, Emitted& emitted, std::string path, std::string title)
        : project_(project),
          names_(names),
          emitted_(emitted),
          path_(std::move(path)),
          title_(std::move(title)),
          component_(emitted.components.at(path_)),
          process_(default_process(project, path_, component_, "D__")) {}

    std::vector<Obligation> make_obligations() {
        const auto plain = cspm::Model::none;
        if (!open_parameters(component_, open_cycles(project_.system)).empty()) {
            Obligation& open = add_required(PropertyKind::timelock_free, "timelock-free", nullptr);
            open.assertions.clear();
            open.reason = missing_cycle(path_);
            return std::move(obligations_);
        }
        add_required(PropertyKind::deadlock_free, "deadlock-free",
                     deadlock_free(running_on(process_, "r__"), project_.is_timed(), plain));
        add_required(PropertyKind::divergence_free, "divergence-free",
                     b::assert_property(process_, cspm::AssertionKind::divergence_free, plain));
        if (project_.is_timed()) {
            add_required(PropertyKind::timelock_free, "timelock-free", time_goes_on());
            add_clocks();
        }
        add_information(PropertyKind::deterministic, "deterministic",
                        b::assert_property(process_, cspm::AssertionKind::deterministic, plain));
        add_information(PropertyKind::terminates, "never terminates", never_terminates(process_)).negated = true;
        add_states();
        // The end of a cycle does not show which transition ended it.
        if (!runs_in_cycles()) add_transitions();
        return std::move(obligations_);
    }

private:
    [[nodiscard]] bool runs_in_cycles() const { return !cycle_events_of(emitted_.provenance, path_).empty(); }

    /// Time can pass, or what the environment takes before time passes is on offer. In RoboSim, this is every event: a
    /// component that offers an event reads or writes a register, or ends its execution.
    [[nodiscard]] cspm::DeclPtr time_goes_on() const {
        const ExprPtr going_on = running_on(process_, "tock");
        if (runs_in_cycles())
            return b::assert_property(going_on, cspm::AssertionKind::deadlock_free, cspm::Model::failures);
        return timelock_free(b::hide(going_on, b::productions(outputs_of(emitted_.provenance, path_))));
    }

    Obligation& add_required(PropertyKind kind, const std::string& what, cspm::DeclPtr assertion) {
        Obligation& obligation = obligations_.emplace_back();
        obligation.kind = kind;
        obligation.component = title_;
        obligation.property_text = what;
        obligation.title = fmt::format("core [{}] {}: {}", project_.is_timed() ? "timed" : "untimed", path_, what);
        obligation.time = project_.time;
        obligation.assertions.push_back(std::move(assertion));
        return obligation;
    }
    Obligation& add_information(PropertyKind kind, const std::string& what, cspm::DeclPtr assertion) {
        Obligation& obligation = add_required(kind, what, std::move(assertion));
        obligation.information = true;
        return obligation;
    }

    /// Adds the clock properties of a machine. Each clock is checked in an instrumented copy of the machine.
    void add_clocks() {
        // In RoboSim, every clock begins at 0.
        if (component_.machine == nullptr || component_.machine->robosim) return;
        for (const ir::Clock& clock : component_.machine->clocks) {
            if (clock.entry_of.is_valid()) continue;  // the entry of a state resets the clock
            const WatchedCopy watch =
                clock_watch(project_, names_, emitted_, path_, clock.name, flatten_name(path_ + "_" + clock.name));
            if (watch.reads == 0) continue;
            const ExprPtr read_unset = watch.only_event("unset__", default_arguments(project_, component_));
            Obligation& obligation =
                add_required(PropertyKind::clock_initialised, fmt::format("{} is reset before it is read", clock.name),
                             never_performs(read_unset, false));
            obligation.origin = clock.origin;
            obligation.preparation.push_back(watch.module);
        }
    }

    void each_machine_inside(const auto& visit) {
        for (const auto& [path, inner] : emitted_.components) {
            const bool inside = path == path_ || path.starts_with(path_ + "::");
            if (inside && inner.machine != nullptr && inner.machine->kind == ir::MachineKind::state_machine)
                visit(path, *inner.machine);
        }
    }

    /// Adds the reachability of the states of all machines in the component. The machines run in the context of the
    /// component.
    void add_states() {
        const ExprPtr visible = default_process(project_, path_, component_, "VS__");
        each_machine_inside([&](const std::string& path, const ir::Machine& machine) {
            for (const ir::Node& node : machine.nodes)
                if (node.kind == ir::NodeKind::state) add_state(path, node, visible);
        });
    }
    /// Adds the question which transitions can fire. It uses VS__, in which no part is compressed, so that a state of
    /// the process determines the states of the machines.
    void add_transitions() {
        FiringQuestion question{default_process(project_, path_, component_, "VS__"), {}};
        each_machine_inside([&](const std::string& path, const ir::Machine& machine) {
            const std::string owner = path == path_ ? "" : path.substr(path_.size() + 2) + ": ";
            for (const ir::Transition& transition : machine.transitions)
                question.transitions.push_back({path, owner + ir::text_of(machine, transition), transition.origin});
        });
        if (question.transitions.empty()) return;
        Obligation& obligation = add_information(PropertyKind::reachable, "every transition fires", nullptr);
        obligation.assertions.clear();
        obligation.firing = std::move(question);
    }
    void add_state(const std::string& machine, const ir::Node& node, const ExprPtr& visible) {
        const std::string name = machine + "::" + node.path;
        const ExprPtr entered = b::project(visible, b::productions({b::name(name + "::entered")}));
        const std::string shown = name.substr(path_.size() + 2);
        add_information(PropertyKind::reachable, shown + " is reachable", never_performs(entered, true)).origin =
            node.origin;
    }

    const Project& project_;
    NameManager& names_;
    Emitted& emitted_;
    std::string path_;
    std::string title_;
    const ComponentEmission& component_;
    ExprPtr process_;
    std::vector<Obligation> obligations_;
};

}  // namespace

std::vector<Obligation> core_properties(const Project& project, NameManager& names, Emitted& emitted) {
    std::vector<Obligation> result;
    const auto ask = [&](const std::string& package, const std::string& path, const char* kind) {
        const std::string name = qualified_name(package, path);
        if (!emitted.components.contains(name)) return;
        for (Obligation& obligation :
             CoreProperties(project, names, emitted, name, fmt::format("{} {}", kind, name)).make_obligations())
            result.push_back(std::move(obligation));
    };
    for (const ir::Module& module : project.system.modules) ask(module.package, module.name, "module");
    for (const ir::Controller& controller : project.system.controllers)
        ask(controller.package, controller.path, "controller");
    for (const ir::Machine& machine : project.system.machines)
        if (machine.kind == ir::MachineKind::state_machine) ask(machine.package, machine.path, "state machine");
    return result;
}

}  // namespace robochart::csp_emit
