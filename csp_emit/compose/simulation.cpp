// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/compose/simulation.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/names.hpp"
#include "csp_emit/base/registers.hpp"
#include "csp_emit/base/variants.hpp"
#include "csp_emit/compose/controller.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::DeclPtr;
using cspm::ExprPtr;
using ir::VariableScope;

namespace {

/// An input or output of the component, with its own event.
struct Side {
    Register in_cycle;
    ExprPtr event;
    bool valued = false;
};

class SimulationEmitter {
public:
    SimulationEmitter(const Project& project, const ir::Simulation& simulation, Emitted& emitted)
        : project_(project),
          simulation_(simulation),
          emitted_(emitted),
          subject_(ir::qualified_name(simulation.subject)) {}

    ComponentEmission emit();

private:
    void find_sides();
    void of_events(const std::vector<ir::Event>& events);
    void of_calls(const std::vector<ir::OperationSignature>& calls);
    void of_variable(const ir::Variable& variable, bool input);
    void keep_named();
    ExprPtr own(const std::string& event) const { return b::name(subject_ + "::" + event); }
    b::Exprs events_of(const std::vector<Side>& sides) const;
    b::Exprs external() const;
    ExprPtr with(b::Exprs events, std::initializer_list<const char*> more) const;
    void define_inputs();
    void define_outputs();
    void define_turns();
    void define_assumptions();
    void define_processes(const ComponentEmission& component, const std::vector<std::string>& parameters);
    ExprPtr reads() const;

    const Project& project_;
    const ir::Simulation& simulation_;
    Emitted& emitted_;
    std::string subject_;
    std::vector<Side> inputs_, outputs_;
    std::vector<DeclPtr> decls_;
};

void SimulationEmitter::of_events(const std::vector<ir::Event>& events) {
    for (const ir::Event& event : events) {
        const bool valued = event.type.has_value();
        if (event.input)
            inputs_.push_back({input_event(event.name, event.type.value_or(ir::TypeId{}), event.origin),
                               b::dot({own(event.name), b::name("in")}), valued});
        if (event.output) outputs_.push_back({output_event(event), b::dot({own(event.name), b::name("out")}), valued});
    }
}

void SimulationEmitter::of_calls(const std::vector<ir::OperationSignature>& calls) {
    for (const ir::OperationSignature& call : calls)
        outputs_.push_back({output_call(call), own(call.name + "Call"), !call.parameters.empty()});
}

void SimulationEmitter::of_variable(const ir::Variable& variable, bool input) {
    if (variable.scope != VariableScope::required) return;
    if (input)
        inputs_.push_back(
            {input_variable(variable.name, variable.type, variable.origin), own("set_EXT_" + variable.name), true});
    outputs_.push_back(
        {output_variable(variable.name, variable.type, variable.origin), own("set_" + variable.name), true});
}

/// Finds the events that the component receives and sends, the operations that it calls, and the variables that it or
/// others write. For a machine, only inputs and outputs in the contexts of the simulation are used.
void SimulationEmitter::find_sides() {
    const ir::ComponentRef& subject = simulation_.subject;
    if (subject.kind == ir::ComponentKind::module) {
        const ir::Module& module = project_.system.modules.at(subject.definition);
        of_events(module.platform.events);
        std::vector<ir::OperationSignature> calls;
        for (const ir::ControllerInstance& part : module.controllers)
            for (auto& call : leaving_calls(project_.system, project_.system.controller(part.controller)))
                if (std::ranges::find(calls, call.name, &ir::OperationSignature::name) == calls.end())
                    calls.push_back(std::move(call));
        of_calls(calls);
        for (const ir::Variable& variable : module.platform.variables) of_variable(variable, false);
    } else if (subject.kind == ir::ComponentKind::controller) {
        const ir::Controller& controller = project_.system.controllers.at(subject.definition);
        of_events(controller.events);
        of_calls(leaving_calls(project_.system, controller));
        for (const ir::Variable& variable : controller.variables) of_variable(variable, true);
    } else {
        const ir::Machine& machine = project_.system.machines.at(subject.definition);
        const auto& defined = emitted_.components.at(subject_).definitions;
        of_events(machine.events);
        std::vector<ir::OperationSignature> calls = machine.operations;
        std::erase_if(calls, [&](const ir::OperationSignature& call) { return defined.contains(call.name); });
        of_calls(calls);
        for (const ir::Variable& variable : machine.variables) of_variable(variable, true);
        keep_named();
    }
}

/// Keeps, for a machine, only the inputs and outputs that the contexts name.
void SimulationEmitter::keep_named() {
    const auto keep = [](std::vector<Side>& sides, const std::vector<std::string>& names) {
        std::erase_if(sides,
                      [&](const Side& side) { return std::ranges::find(names, side.in_cycle.name) == names.end(); });
    };
    keep(inputs_, simulation_.inputs);
    keep(outputs_, simulation_.outputs);
}

b::Exprs SimulationEmitter::events_of(const std::vector<Side>& sides) const {
    b::Exprs result;
    for (const Side& side : sides) result.push_back(side.event);
    return result;
}

b::Exprs SimulationEmitter::external() const {
    b::Exprs result = events_of(inputs_);
    for (const ExprPtr& event : events_of(outputs_)) result.push_back(event);
    return result;
}

/// Returns the events of the component, and some of the module's.
ExprPtr SimulationEmitter::with(b::Exprs events, std::initializer_list<const char*> more) const {
    for (const std::string name : more) {
        if ((name == "registerRead" && inputs_.empty()) || (name == "registerWrite" && outputs_.empty())) continue;
        events.push_back(b::name(name));
    }
    return b::productions(events);
}

ExprPtr SimulationEmitter::reads() const {
    b::Exprs all;
    for (const Side& side : inputs_)
        all.push_back(b::prefix(register_read("i_" + side.in_cycle.name), {b::input("x__")}, b::skip()));
    return b::interleave(all);
}

/// Defines A1 for each input: `read?full?x -> if full then (M::e.in.x -> A1 [] A1) else A1`.
void SimulationEmitter::define_inputs() {
    b::Exprs all;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
        const Side& side = inputs_[i];
        const std::string name = "Input_" + std::to_string(i) + "__";
        const ExprPtr self = b::call(name);
        const ExprPtr happens =
            side.valued ? b::prefix(side.event, {b::output(b::name("x__"))}, self) : b::prefix(side.event, self);
        const ExprPtr may = b::choice({happens, self});
        std::vector<cspm::Field> fields;
        if (side.in_cycle.event) fields.push_back(b::input("full__"));
        if (side.valued) fields.push_back(b::input("x__"));
        const ExprPtr next = side.in_cycle.event ? b::if_(b::name("full__"), may, self) : may;
        decls_.push_back(b::function_decl(name, {}, b::prefix(register_read("i_" + side.in_cycle.name), fields, next)));
        all.push_back(self);
    }
    const ExprPtr end = b::prefix(b::name("end__"), b::skip());
    decls_.push_back(b::function_decl("Inputs__", {}, b::interrupt(all.empty() ? b::stop() : b::interleave(all), end)));
}

/// Defines A2: `A2(s, c) = M::o?x -> registerWrite.o.x -> A2(s - {o}, c), o in s [] end [] tock^c -> A2(all, c)`.
void SimulationEmitter::define_outputs() {
    const auto number = [](std::size_t i) { return b::number(static_cast<std::int64_t>(i)); };
    const auto call = [](const ExprPtr& left) { return b::call("Outputs__", {left, b::name("cycle__")}); };
    b::Exprs ways, all;
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
        const Side& side = outputs_[i];
        const ExprPtr rest = call(b::call("diff", {b::name("s__"), b::set({number(i)})}));
        const ExprPtr own = register_write("o_" + side.in_cycle.name);
        const ExprPtr written = side.valued ? b::prefix(own, {b::output(b::name("x__"))}, rest) : b::prefix(own, rest);
        const ExprPtr way =
            side.valued ? b::prefix(side.event, {b::input("x__")}, written) : b::prefix(side.event, written);
        ways.push_back(b::guard(b::call("member", {number(i), b::name("s__")}), way));
        all.push_back(number(i));
    }
    decls_.push_back(b::value("all__", b::set(all)));
    ways.push_back(b::prefix(b::name("end__"), b::skip()));
    ways.push_back(b::sequential({b::call("wait", {b::name("cycle__")}), call(b::name("all__"))}));
    decls_.push_back(b::function_decl("Outputs__", b::variables({"s__", "cycle__"}), b::choice(ways)));
}

/// Defines A3: `A3(c) = all reads ; (RUN(events of M) /\ (end [] tock^c -> A3(c)))`.
void SimulationEmitter::define_turns() {
    const ExprPtr later =
        b::sequential({b::call("wait", {b::name("cycle__")}), b::call("Turns__", {b::name("cycle__")})});
    const ExprPtr end = b::choice({b::prefix(b::name("end__"), b::skip()), later});
    decls_.push_back(
        b::function_decl("Turns__", b::variables({"cycle__"}),
                         b::sequential({reads(), b::interrupt(b::call("RUN", {b::productions(external())}), end)})));
}

void SimulationEmitter::define_assumptions() {
    define_inputs();
    define_outputs();
    define_turns();
    const ExprPtr both = b::alphabetised(b::call("Inputs__"), with(events_of(inputs_), {"registerRead", "end__"}),
                                         with(events_of(outputs_), {"registerWrite", "end__", "tock"}),
                                         b::call("Outputs__", {b::name("all__"), b::name("cycle__")}));
    decls_.push_back(
        b::function_decl("Assumptions__", b::variables({"cycle__"}),
                         b::alphabetised(both, with(external(), {"registerRead", "registerWrite", "end__", "tock"}),
                                         with(external(), {"registerRead", "tock", "end__"}),
                                         b::call("Turns__", {b::name("cycle__")}))));
}

void SimulationEmitter::define_processes(const ComponentEmission& component,
                                         const std::vector<std::string>& parameters) {
    b::Exprs arguments{b::name("id__")};
    for (const ConstantParameter& constant : component.constants) arguments.push_back(b::name(constant.parameter));
    // a module has no event terminate
    ExprPtr subject = b::call(subject_ + "::D__", arguments);
    if (simulation_.subject.kind != ir::ComponentKind::module)
        subject = b::hide(subject, b::productions({own("terminate")}));
    const ExprPtr assumptions = b::call("Assumptions__", {b::name(parameters.at(1))});
    const auto in_cycles = [&](const ExprPtr& process) {
        const ExprPtr ending = b::sequential({process, b::prefix(b::name("end__"), b::skip())});
        const ExprPtr together = b::parallel(ending, with(external(), {"tock", "end__"}), assumptions);
        const ExprPtr hidden =
            b::call("union", {b::name(subject_ + "::sem__events"), b::productions({b::name("end__")})});
        return maximal_progress(project_, b::hide(together, hidden));
    };
    const auto define = [&](const std::string& name, const ExprPtr& process) {
        decls_.push_back(b::function_decl(name, b::variables(parameters), process));
    };
    // M, or time forever if M offers neither an output nor time. The event for the missed deadline of an input has the
    // lowest priority
    const ExprPtr missed = b::prefix(b::name("missed__"), b::call("RUN", {b::set({b::name("tock")})}));
    const ExprPtr first = with(events_of(outputs_), {"tock"});
    const ExprPtr free = b::hide(b::call("prioritise", {b::interrupt(subject, missed),
                                                        b::sequence({first, b::productions({b::name("missed__")})})}),
                                 b::productions({b::name("missed__")}));
    define("TLF", b::sequential({in_cycles(free), b::call("RUN", {b::set({b::name("tock")})})}));
    define("D__", in_cycles(subject));
    define("O__", call_of("D__", parameters));
}

ComponentEmission SimulationEmitter::emit() {
    const ComponentEmission component = emitted_.components.at(subject_);
    find_sides();
    Registers registers;
    for (const Side& side : inputs_) add_register(registers.inputs, side.in_cycle);
    for (const Side& side : outputs_) add_register(registers.outputs, side.in_cycle);
    ComponentEmission result;
    const std::string cycle = ir::constant_name("", simulation_.name, ir::cycle_length);
    result.constants.push_back({cycle, ir::cycle_length, cycle, nullptr, {}, ir::nat_type, "", cycle});
    result.constants.insert(result.constants.end(), component.constants.begin(), component.constants.end());
    result.visible = visible_registers(registers);
    declare_registers(project_, simulation_.name, registers, {}, emitted_.provenance, decls_);
    b::Exprs events;
    if (!registers.inputs.empty()) events.push_back(b::name("registerRead"));
    if (!registers.outputs.empty()) events.push_back(b::name("registerWrite"));
    decls_.push_back(b::value("sem__events", b::productions(events)));
    decls_.push_back(b::channel({"end__", "missed__"}));
    mean(emitted_.provenance, simulation_.name, "end__",
         {MeaningKind::terminate, "the component has ended", {}, simulation_.origin});
    mean(emitted_.provenance, simulation_.name, "missed__",
         {MeaningKind::step, "an input has missed its deadline", {}, simulation_.origin});
    define_assumptions();
    std::vector<std::string> parameters{"id__"};
    for (const ConstantParameter& constant : result.constants) parameters.push_back(constant.parameter);
    define_processes(component, parameters);
    result.module = b::module_(simulation_.name, {}, {}, decls_, "simulation " + simulation_.name + " of " + subject_);
    return emitted_.components[simulation_.name] = result;
}

}  // namespace

ComponentEmission emit_simulation(const Project& project, const ir::Simulation& simulation, Emitted& emitted) {
    return SimulationEmitter(project, simulation, emitted).emit();
}

}  // namespace robochart::csp_emit
