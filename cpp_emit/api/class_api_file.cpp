// SPDX-License-Identifier: Apache-2.0
// Writes the text of interface and machine classes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/api/class_api.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::cpp_emit {

namespace {

std::string typed_parameters(const Generation& generation, const Core& core, const std::vector<ir::TypeId>& types,
                             const std::vector<std::string>& names) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < types.size(); ++i)
        texts.push_back(fmt::format("{} {}", deployed_type(generation, core.relative, types[i]), names.at(i)));
    return fmt::format("{}", fmt::join(texts, ", "));
}

/// Returns names for parameters that the definition does not use. Such names may be equal to names of members.
std::vector<std::string> unused_names(const std::vector<std::string>& model_names) {
    std::vector<std::string> names = parameter_identifiers(model_names);
    for (std::string& name : names) name = "/*" + name + "*/";
    return names;
}

/// Returns names for parameters that the definition passes on. No member has such a name.
std::vector<std::string> passed_names(std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) names.push_back(fmt::format("a{}", i));
    return names;
}

void write_operation(const Generation& generation, const Core& core, CodeWriter& out, const ApiOperation& operation) {
    out.gap();
    const ir::OperationSignature& signature = *operation.signature;
    const diagnostics::ForeignText place = generation.place_text(signature.origin);
    const auto list = [&](const std::vector<std::string>& names) {
        return typed_parameters(generation, core, signature.parameters, names);
    };
    if (operation.modelled) {
        out.doc(place + ", as the model defines it. Override it and return true to do it differently.");
        out.line(fmt::format("virtual bool {}({}) {{ return false; }}", operation.method,
                             list(unused_names(signature.parameter_names))));
    } else {
        out.doc(place + ", done by the platform: override it.");
        out.line(fmt::format("virtual void {}({}) = 0;", operation.method,
                             list(parameter_identifiers(signature.parameter_names))));
    }
}

void write_functions(const Generation& generation, const Core& core, const ClassApi& api, CodeWriter& out) {
    for (const ApiFunction& api_function : api.functions) {
        const ir::Function& function = generation.system.functions[api_function.hook->id.index];
        const ir::Value value = ir::default_value(generation.system, generation.inst, function.result);
        out.gap();
        out.doc(fmt::format("Function {}: the model has only its contract.", function.name));
        out.line(
            fmt::format("[[nodiscard]] virtual {} {}({}) {{ return {}; }}",
                        deployed_type(generation, core.relative, function.result), api_function.method,
                        typed_parameters(generation, core, function.parameters, unused_names(function.parameter_names)),
                        deployed_value(generation, core, function.result, value)));
    }
}

void write_function_hooks(const Generation& generation, const Core& core, const ClassApi& api, CodeWriter& out) {
    for (const ApiFunction& api_function : api.functions) {
        const ir::Function& function = generation.system.functions[api_function.hook->id.index];
        const std::vector<std::string> arguments = passed_names(function.parameters.size());
        out.gap();
        out.open(fmt::format("{} {}({}) const noexcept {{", deployed_type(generation, core.relative, function.result),
                             api_function.hook->method,
                             typed_parameters(generation, core, function.parameters, arguments)));
        out.line(fmt::format("return machine.{}({});", api_function.method, fmt::join(arguments, ", ")));
        out.close();
    }
}

/// Writes the method of an event. `raise_e(value)` raises a received event. Users override `on_e(value)` of a sent one.
void write_event_method(const Generation& generation, const Core& core, CodeWriter& out, const ApiEvent& event) {
    const std::string type = event.port->type ? deployed_type(generation, core.relative, *event.port->type) : "";
    out.gap();
    if (event.sent) {
        out.doc("Event " + event.port->model_name + " is sent.");
        out.line(fmt::format("virtual void {}({}) {{}}", event.method,
                             type.empty() ? "" : fmt::format("[[maybe_unused]] {} new_value", type)));
        return;
    }
    out.doc("Raises the event for the next cycle; of several values the last counts.");
    out.open(fmt::format("void {}({}) noexcept {{", event.method, type.empty() ? "" : type + " new_value"));
    out.line(event.flag + " = true;");
    if (!type.empty()) out.line(event.value + " = new_value;");
    out.close();
}

/// Returns true if an action may take time while the machine should wait for the event, so that it may be lost.
bool may_be_lost(const Generation& generation, const Core& core, const ApiEvent& event) {
    std::size_t place = 0;  // index among the received events
    for (const EventPort& port : generation.component.events) {
        if (&port == event.port) break;
        if (port.received) ++place;
    }
    return lost_in_actions(generation, core)[place];
}

/// Returns the comment on the member that stores whether the event is raised.
const char* describe_flag(const Generation& generation, const Core& core, const ApiEvent& event) {
    if (event.sent) return "sent in the last cycle";
    if (generation.component.robosim) return "raise it before a cycle, whose register it fills";
    if (may_be_lost(generation, core, event))
        return "raise it before a cycle, which lowers it again; lost in a cycle spent in an action";
    return "raise it before a cycle, which lowers it again";
}

void write_members(const Generation& generation, const Core& core, CodeWriter& out, const ApiClass& api) {
    for (const ApiVariable& variable : api.variables) {
        const ir::Variable& declared = *variable.stored->variable;
        out.line_with_doc(
            fmt::format("{} {} = {};", deployed_type(generation, core.relative, declared.type), variable.member,
                        deployed_value(generation, core, declared.type, variable.stored->initial)),
            generation.place_text(declared.origin));
    }
    for (const ApiEvent& event : api.events) {
        const char* use = describe_flag(generation, core, event);
        out.line(fmt::format("bool {} = false;  ///< event {}: {}", event.flag, event.port->model_name, use));
        if (event.port->type)
            out.line(
                fmt::format("{} {}{{}};", deployed_type(generation, core.relative, *event.port->type), event.value));
    }
    for (const ApiEvent& event : api.events) write_event_method(generation, core, out, event);
    for (const ApiOperation& operation : api.operations) write_operation(generation, core, out, operation);
}

std::string base_list(const ClassApi& api) {
    std::vector<std::string> bases;
    for (const ApiClass& base : api.bases) bases.push_back("public " + base.cpp_name);
    return bases.empty() ? "" : fmt::format(" : {}", fmt::join(bases, ", "));
}

void write_states(const ClassApi& api, CodeWriter& out) {
    for (const ApiMachine& machine : api.machines) {
        out.doc("The states; none before the first cycle and at the end.");
        std::vector<std::string> names = {"none"};
        for (const std::string& state : machine.states)
            if (!state.empty()) names.push_back(state);
        out.line(fmt::format("enum class {} : {} {{ {} }};", machine.enumeration,
                             names.size() <= 256 ? "std::uint8_t" : "std::uint16_t", fmt::join(names, ", ")));
    }
}

void write_platform(const Generation& generation, const Core& core, const ClassApi& api, CodeWriter& out) {
    out.doc("What the core asks of its platform, done by the object's methods and members.");
    out.open(fmt::format("struct {}::Platform {{", api.cpp_name));
    out.line(fmt::format("{}& machine;", api.cpp_name));
    write_function_hooks(generation, core, api, out);
    if (generation.component.probabilistic) {
        out.gap();
        out.open("std::size_t choose(const double* chances, std::size_t count) const noexcept {");
        out.line("return machine.choose(chances, count);");
        out.close();
    }
    if (generation.options.choices) {
        out.gap();
        out.line("std::size_t pick(std::size_t count) const noexcept { return machine.pick(count); }");
    }
    each_class(api, [&](const ApiClass& part) {
        for (const ApiOperation& operation : part.operations) {
            const auto& signature = *operation.signature;
            const std::vector<std::string> arguments = passed_names(signature.parameters.size());
            out.gap();
            out.open(fmt::format("{} {}({}) const noexcept {{", operation.modelled ? "bool" : "void",
                                 operation.core_method,
                                 typed_parameters(generation, core, signature.parameters, arguments)));
            out.line(fmt::format("{}machine.{}({});", operation.modelled ? "return " : "", operation.method,
                                 fmt::join(arguments, ", ")));
            out.close();
        }
        for (const ApiEvent& event : part.events) {
            if (!event.sent) continue;
            out.gap();
            const bool valued = event.port->type.has_value();
            const std::string list =
                valued ? deployed_type(generation, core.relative, *event.port->type) + " value" : "";
            out.open(fmt::format("void {}({}) const noexcept {{", event.port->output, list));
            out.line(fmt::format("machine.{} = true;", event.flag));
            if (valued) out.line(fmt::format("machine.{} = value;", event.value));
            out.line(fmt::format("machine.{}({});", event.method, valued ? "value" : ""));
            out.close();
        }
        for (const ApiVariable& variable : part.variables) {
            if (!variable.stored->visible) continue;
            out.gap();
            const std::string type = deployed_type(generation, core.relative, variable.stored->variable->type);
            out.line(fmt::format("void {}({} value) const noexcept {{ machine.{} = value; }}", variable.stored->output,
                                 type, variable.member));
        }
    });
    out.close("};");
}

/// Writes to the log what others have written. In the classes, variables that others write are members. The log
/// contains each such member whose value has changed.
void write_outside_writes(const Core& core, const ClassApi& api, CodeWriter& out) {
    std::vector<const ApiVariable*> written;
    each_class(api, [&](const ApiClass& part) {
        for (const ApiVariable& variable : part.variables)
            if (!variable.stored->input.empty()) written.push_back(&variable);
    });
    if (written.empty()) return;
    out.line("#if ROBOCHART_TRACE");
    out.line("if (tracer_ != nullptr) {");
    for (const ApiVariable* variable : written)
        out.line(fmt::format("    {}::log_write_of_{}(*tracer_, core_, {});", core.relative, variable->stored->input,
                             variable->member));
    out.line("}");
    out.line("#endif");
}

void write_cycle(const Core& core, const ClassApi& api, CodeWriter& out) {
    out.open(fmt::format("robochart::StepResult {}::MakeTransition() noexcept {{", api.cpp_name));
    out.line("CheckInEvent();");
    out.line(fmt::format("{}::Inputs<robochart::Deployment> inputs;", core.relative));
    std::vector<std::string> before, after;
    each_class(api, [&](const ApiClass& part) {
        for (const ApiEvent& event : part.events) {
            const std::string lower = event.flag + " = false;";
            if (event.sent) {
                before.push_back(lower);
                continue;
            }
            before.push_back(fmt::format("inputs.{}.present = {};", event.port->input, event.flag));
            if (event.port->type)
                before.push_back(fmt::format("inputs.{}.value = {};", event.port->input, event.value));
            after.push_back(lower);
        }
        for (const ApiVariable& variable : part.variables) {
            for (const std::string& copy : variable.copies)
                before.push_back(fmt::format("core_.{} = {};", copy, variable.member));
            if (!variable.stored->has_member()) continue;
            before.push_back(fmt::format("core_.{} = {};", variable.stored->path, variable.member));
            if (variable.copies.empty())
                after.push_back(fmt::format("{} = core_.{};", variable.member, variable.stored->path));
        }
    });
    for (const ApiTimer& timer : api.timers) {
        before.push_back(fmt::format("core_.{} = {}.counter;", timer.field, timer.member));
        after.push_back(fmt::format("{}.counter = core_.{};", timer.member, timer.field));
    }
    write_outside_writes(core, api, out);
    for (const std::string& line : before) out.line(line);
    out.line("Platform platform{*this};");
    out.line("#if ROBOCHART_TRACE");
    out.line(fmt::format("const robochart::StepResult result = tracer_ == nullptr ? {0}::step(core_, inputs, platform)",
                         core.relative));
    out.line(
        fmt::format("                                                        : "
                    "{}::traced_step(core_, inputs, platform, *tracer_);",
                    core.relative));
    out.line("#else");
    out.line(fmt::format("const robochart::StepResult result = {}::step(core_, inputs, platform);", core.relative));
    out.line("#endif");
    out.line("terminated_ = result == robochart::StepResult::terminated;");
    for (const std::string& line : after) out.line(line);
    out.line("return result;");
    out.close();
}

void write_reset(const Generation& generation, const Core& core, const ClassApi& api, CodeWriter& out) {
    out.open(fmt::format("void {}::reset() noexcept {{", api.cpp_name));
    out.line("core_ = {};");
    out.line("terminated_ = false;");
    each_class(api, [&](const ApiClass& part) {
        for (const ApiVariable& variable : part.variables)
            out.line(fmt::format(
                "{} = {};", variable.member,
                deployed_value(generation, core, variable.stored->variable->type, variable.stored->initial)));
        for (const ApiEvent& event : part.events) out.line(event.flag + " = false;");
    });
    for (const ApiTimer& timer : api.timers) out.line(timer.member + ".ResetTimer();");
    out.line("#if ROBOCHART_TRACE");
    out.line("if (tracer_ != nullptr) tracer_->begin();");
    out.line("#endif");
    out.close();
}

void write_state(const Core& core, const ClassApi& api, const ApiMachine& machine, CodeWriter& out) {
    const Enumeration& places = core.machines[machine.unit].enumerations.front();
    const std::string& type = machine.enumeration;
    out.open(fmt::format("{0}::{1} {0}::{2}() const noexcept {{", api.cpp_name, type, machine.method));
    out.open(fmt::format("switch (core_.{}) {{", machine.place));
    for (const Enumerator& place : places.values) {
        const std::string state = place.state.is_valid() ? machine.states[place.state.index] : "none";
        out.line(fmt::format("case {}::{}::{}: return {}::{};", core.relative, places.name, place.name, type, state));
    }
    out.close();
    out.line(fmt::format("return {}::none;", type));
    out.close();
    out.gap();
    out.open(fmt::format("const char* {}::name({} state) noexcept {{", api.cpp_name, type));
    out.open("switch (state) {");
    out.line(fmt::format("case {}::none: return \"none\";", type));
    for (const std::string& state : machine.states)
        if (!state.empty()) out.line(fmt::format("case {0}::{1}: return \"{1}\";", type, state));
    out.close();
    out.line("return \"none\";");
    out.close();
}

}  // namespace

std::string deployed_value(const Generation& generation, const Core& core, ir::TypeId id, const ir::Value& value) {
    const std::string text = cpp_value(generation.system, generation.inst, id, value, deployed_spelling(core.relative));
    if (!is_numeric(generation.system.type(id).kind)) return text;
    return text.substr(text.find('(') + 1, text.rfind(')') - text.find('(') - 1);
}

std::string interface_header(const Generation& generation, const Core& core, const ClassApi& api,
                             const ApiClass& base) {
    CodeWriter out;
    out.comment(fmt::format("Interface {} as {} uses it.", base.interface, api.cpp_name));
    out.comment("Generated by robochart-verify; change the model, not this file.");
    out.line("#pragma once");
    out.gap();
    out.line("#include <cstdint>");
    out.gap();
    if (!generation.component.enumerations.empty()) out.line(fmt::format("#include \"{}\"", core.header));
    out.gap();
    out.line(fmt::format("namespace {} {{", api.name_space));
    out.gap();
    out.open(fmt::format("class {} {{", base.cpp_name));
    out.write_label("public:");
    out.line(fmt::format("virtual ~{}() = default;", base.cpp_name));
    out.gap();
    write_members(generation, core, out, base);
    out.close("};");
    out.gap();
    out.line(fmt::format("}}  // namespace {}", api.name_space));
    return out.text();
}

std::string machine_header(const Generation& generation, const Core& core, const ClassApi& api) {
    CodeWriter out;
    file_comment(generation, out, "Controller");
    out.line("#pragma once");
    out.gap();
    out.line("#include <cstdint>");
    out.gap();
    for (const ApiClass& base : api.bases) out.line(fmt::format("#include \"{}.hpp\"", base.cpp_name));
    out.line(fmt::format("#include \"{}\"", core.header));
    if (!api.timers.empty()) out.line("#include \"robochart/timer.hpp\"");
    out.line("#if ROBOCHART_TRACE");
    out.line("#include \"robochart/trace.hpp\"");
    out.line("#endif");
    out.gap();
    out.line(fmt::format("namespace {} {{", api.name_space));
    out.gap();
    const Component& component = generation.component;
    out.doc(component.is_composed() ? "The machines of " + generation.place_text(component.origin) + ", side by side"
                                    : "State machine " + generation.place_text(component.root_unit().machine->origin));
    out.open(fmt::format("class {}{} {{", api.cpp_name, base_list(api)));
    out.write_label("public:");
    write_states(api, out);
    out.gap();
    if (api.bases.empty()) out.line(fmt::format("virtual ~{}() = default;", api.cpp_name));
    out.gap();
    out.doc(
        "One control cycle: reads the events raised, makes every transition that they and time enable, lowers the "
        "events.");
    out.line("robochart::StepResult MakeTransition() noexcept;");
    out.line("robochart::StepResult step() noexcept { return MakeTransition(); }");
    out.doc("Called first in each cycle: override it to raise events from sensors.");
    out.line("virtual void CheckInEvent() {}");
    out.doc("Back to the beginning.");
    out.line("void reset() noexcept;");
    for (const ApiMachine& machine : api.machines) {
        out.doc("The innermost active state, or the one whose action is running.");
        out.line(fmt::format("[[nodiscard]] {} {}() const noexcept;", machine.enumeration, machine.method));
        out.line(fmt::format("[[nodiscard]] static const char* name({} state) noexcept;", machine.enumeration));
    }
    out.line("[[nodiscard]] bool isFinal() const noexcept { return terminated_; }");
    out.line("#if ROBOCHART_TRACE");
    out.doc("Whom it tells what it does from now on (robochart/trace_file.hpp writes logs); null: nobody.");
    out.line("void SetTracer(robochart::Tracer* tracer) noexcept { tracer_ = tracer; }");
    out.doc("What its logs begin with, and its transitions.");
    out.line("[[nodiscard]] static const robochart::RunHeader& RunHeader() noexcept;");
    out.line("#endif");
    out.gap();
    for (const ApiTimer& timer : api.timers)
        out.line_with_doc(fmt::format("robochart::Timer {};", timer.member),
                          "clock " + generation.place_text(timer.clock->origin));
    out.gap();
    write_members(generation, core, out, api.own);
    write_functions(generation, core, api, out);
    if (generation.component.probabilistic) {
        out.gap();
        out.doc(
            "What the ways of probabilistic junctions are drawn from: the same seed, the same ways. Give each robot "
            "its own.");
        out.line("void SetSeed(std::uint64_t seed) noexcept { draws_ = robochart::Draws(seed); }");
        out.doc(
            "Which way a probabilistic junction takes, drawn by the chances of its ways; override it for another "
            "source.");
        out.line("virtual std::size_t choose(const double* chances, std::size_t count) noexcept {");
        out.line("    return draws_.way(chances, count);");
        out.line("}");
    }
    if (generation.options.choices) {
        out.gap();
        out.doc("Which of several choices of the model is taken, from 0; override it to take others than the first.");
        out.line("virtual std::size_t pick([[maybe_unused]] std::size_t count) noexcept { return 0; }");
    }
    out.gap();
    out.write_label("private:");
    out.line("struct Platform;");
    out.gap();
    out.line(fmt::format("{}::State<robochart::Deployment> core_{{}};", core.relative));
    out.line("bool terminated_ = false;");
    if (generation.component.probabilistic) out.line("robochart::Draws draws_;");
    out.line("#if ROBOCHART_TRACE");
    out.line("robochart::Tracer* tracer_ = nullptr;");
    out.line("#endif");
    out.close("};");
    out.gap();
    out.line(fmt::format("}}  // namespace {}", api.name_space));
    return out.text();
}

std::string machine_source(const Generation& generation, const Core& core, const ClassApi& api) {
    CodeWriter out;
    file_comment(generation, out, "Controller");
    out.line(fmt::format("#include \"{}.hpp\"", api.cpp_name));
    out.line("#if ROBOCHART_TRACE");
    out.line(fmt::format("#include \"{}_trace.hpp\"", generation.component.cpp_name));
    out.line("#endif");
    out.gap();
    out.line(fmt::format("namespace {} {{", api.name_space));
    out.gap();
    write_platform(generation, core, api, out);
    out.gap();
    write_cycle(core, api, out);
    out.gap();
    write_reset(generation, core, api, out);
    out.gap();
    for (const ApiMachine& machine : api.machines) {
        write_state(core, api, machine, out);
        out.gap();
    }
    out.line("#if ROBOCHART_TRACE");
    out.line(fmt::format("const robochart::RunHeader& {}::RunHeader() noexcept {{ return {}::run_header; }}",
                         api.cpp_name, core.relative));
    out.line("#endif");
    out.gap();
    out.line(fmt::format("}}  // namespace {}", api.name_space));
    return out.text();
}

}  // namespace robochart::cpp_emit
