// The core header: one translation of the machine, used by the deployed controller and by the explorer alike.
#include <fmt/format.h>

#include <algorithm>

#include "cpp_emit/files.hpp"
#include "cpp_emit/types.hpp"

namespace robochart::cpp_emit {

namespace {

void numeric_aliases(CodeWriter& out) {
    for (const char* name : {"Real", "Nat", "Int"}) out.line(fmt::format("using {0} = typename Types::{0};", name));
}

std::string bound_text(const Core& core) {
    // A cycle may pass each place a few times; a model that needs more without time passing is taken to diverge.
    std::size_t places = 0;
    for (const MachineCode& machine : core.machines)
        for (const Enumeration& enumeration : machine.enumerations) places += enumeration.values.size();
    return fmt::format("{}", 1000 + 16 * places);
}

void write_enumeration(CodeWriter& out, const Enumeration& enumeration) {
    out.gap();
    out.doc(enumeration.comment);
    const char* base = enumeration.values.size() <= 256 ? "std::uint8_t" : "std::uint16_t";
    out.open(fmt::format("enum class {} : {} {{", enumeration.name, base));
    for (const Enumerator& value : enumeration.values)
        out.line(value.comment.empty() ? value.name + "," : fmt::format("{},  ///< {}", value.name, value.comment));
    out.close("};");
}

void write_declared_types(const Generation& generation, CodeWriter& out) {
    for (const ir::TypeId id : generation.component.enumerations) {
        const ir::Type& type = generation.system.type(id);
        if (type.kind == ir::TypeKind::given) {
            out.gap();
            out.doc(fmt::format("Given type {}: its elements are numbered.", generation.place(type.origin)));
            out.line(fmt::format("enum class {} : std::uint8_t {{}};", cpp_type(generation.system, id)));
            continue;
        }
        Enumeration enumeration{cpp_type(generation.system, id), generation.place(type.origin), {}};
        for (std::size_t index = 0; index < type.labels.size(); ++index)
            enumeration.values.push_back({literal_name(type, index), "", {}});
        write_enumeration(out, enumeration);
    }
}

void write_frame(CodeWriter& out, const Unit& unit, const FrameLayout& layout) {
    out.gap();
    out.doc(unit.root ? fmt::format("The whole state of {}: a value without padding, equal states have equal bytes.",
                                    unit.machine->name)
                      : fmt::format("Operation {} in progress; as constructed when it is not.", unit.machine->name));
    out.line("template <class Types>");
    out.open(fmt::format("struct {} {{", unit.frame));
    numeric_aliases(out);
    out.gap();
    for (const Field& field : layout.fields) {
        const std::string initial = field.initial == "{}"   ? " = {}"
                                    : field.initial.empty() ? "{}"
                                                            : " = " + field.initial;
        const std::string comment = field.comment.empty() ? "" : "  ///< " + field.comment;
        out.line(fmt::format("{} {}{};{}", field.type, field.name, initial, comment));
    }
    out.gap();
    out.line(fmt::format("friend bool operator==(const {0}&, const {0}&) = default;", unit.frame));
    out.close("};");
}

void write_inputs(const Generation& generation, CodeWriter& out) {
    out.gap();
    out.doc("What the control cycle reads: events received, shared variables written from outside.");
    out.line("template <class Types>");
    out.open("struct Inputs {");
    numeric_aliases(out);
    out.gap();
    for (const EventPort& event : generation.component.events) {
        if (!event.received) continue;
        const std::string type = event.type
                                     ? fmt::format("robochart::Message<{}>", cpp_type(generation.system, *event.type))
                                     : "robochart::Signal";
        out.line(fmt::format("{} {};", type, event.input));
    }
    for (const StoredVariable& variable : generation.component.variables)
        if (!variable.input.empty())
            out.line(fmt::format("robochart::Message<{}> {};", cpp_type(generation.system, variable.variable->type),
                                 variable.input));
    out.close("};");
}

std::string parameter_list(const Generation& generation, const ir::OperationSignature& signature) {
    std::string parameters;
    for (std::size_t i = 0; i < signature.parameters.size(); ++i)
        parameters += fmt::format("{}{} {}", i == 0 ? "" : ", ", cpp_type(generation.system, signature.parameters[i]),
                                  signature.parameter_names[i]);
    return parameters;
}

void write_platform_comment(const Generation& generation, CodeWriter& out) {
    const auto method = [&](const char* result, const std::string& name, const std::string& parameters) {
        out.comment(fmt::format("    {} {}({});", result, name, parameters));
    };
    const Component& component = generation.component;
    out.gap();
    out.comment(
        "The platform that Step drives has these methods, all noexcept; replaces_X answers true when it has done X "
        "itself:");
    for (const PlatformCall& call : component.calls)
        method("void", call.method, parameter_list(generation, *call.signature));
    for (const ModelledCall& call : component.modelled)
        method("bool", call.method, parameter_list(generation, *call.signature));
    for (const EventPort& event : component.events)
        if (!event.output.empty())
            method("void", event.output, event.type ? cpp_type(generation.system, *event.type) + " value" : "");
    for (const StoredVariable& variable : component.variables)
        if (variable.visible)
            method("void", variable.output, cpp_type(generation.system, variable.variable->type) + " value");
}

void write_variables(const Generation& generation, CodeWriter& out) {
    for (const StoredVariable& variable : generation.component.variables) {
        if (!variable.visible) continue;
        out.gap();
        out.doc("Shared variable " + generation.place(variable.variable->origin));
        out.open(fmt::format("void write_{}({} value) noexcept {{", variable.variable->name,
                             cpp_type(generation.system, variable.variable->type)));
        if (variable.stored()) out.line(fmt::format("state_.{} = value;", variable.field));
        out.line(fmt::format("platform_.{}(value);", variable.output));
        out.close();
    }
}

void take_kept(CodeWriter& out, const EventPort& event) {
    out.open(fmt::format("if (state_.kept_{0} && !inputs_.{0}.present) {{", event.input));
    out.line(fmt::format("inputs_.{}.present = true;", event.input));
    if (event.type) out.line(fmt::format("inputs_.{0}.value = state_.kept_value_{0};", event.input));
    out.close();
}

void keep(CodeWriter& out, const EventPort& event) {
    out.line(fmt::format("state_.kept_{0} = inputs_.{0}.present;", event.input));
    if (!event.type) return;
    out.line(fmt::format("state_.kept_value_{0} = {{}};", event.input));
    out.line(fmt::format("if (inputs_.{0}.present) state_.kept_value_{0} = inputs_.{0}.value;", event.input));
}

void write_cycle(const Generation& generation, const Core& core, CodeWriter& out) {
    out.doc("One control cycle: inputs, everything that they and time make possible, then time passes.");
    out.open("robochart::StepResult cycle() noexcept {");
    for (const StoredVariable& variable : generation.component.variables)
        if (!variable.input.empty())
            out.line(fmt::format("if (inputs_.{0}.present) state_.{1} = inputs_.{0}.value;", variable.input,
                                 variable.field));
    for (const EventPort* event : core.kept) take_kept(out, *event);
    out.line("run(state_);");
    for (const EventPort* event : core.kept) keep(out, *event);
    out.line("const robochart::StepResult result = this->result(finished(state_));");
    if (core.machines.back().layout.timed) out.line("if (result == robochart::StepResult::quiescent) advance(state_);");
    out.line("return result;");
    out.close();
}

void write_step_class(const Generation& generation, const Core& core, CodeWriter& out) {
    out.gap();
    out.doc("The behaviour. It lives for one cycle.");
    out.line("template <class Types, class Platform>");
    out.open("class Step : private robochart::Cycle {");
    out.label("public:");
    numeric_aliases(out);
    out.gap();
    out.line("Step(State<Types>& state, const Inputs<Types>& inputs, Platform& platform) noexcept");
    out.line("    : Cycle(step_bound), state_(state), inputs_(inputs), platform_(platform) {}");
    out.gap();
    write_cycle(generation, core, out);
    out.gap();
    out.label("private:");
    write_variables(generation, out);
    for (const MachineCode& machine : core.machines) {
        out.gap();
        out.raw(machine.methods);
    }
    out.gap();
    out.line("State<Types>& state_;");
    out.line("Inputs<Types> inputs_;");
    out.line("Platform& platform_;");
    out.close("};");
}

}  // namespace

namespace {

/// Members of the state for inputs that outlive their cycle.
std::vector<Field> kept_fields(const Generation& generation, const Core& core) {
    std::vector<Field> fields;
    for (const EventPort* event : core.kept) {
        fields.push_back({"bool", "kept_" + event->input, "false", "", 1, 1});
        if (!event->type) continue;
        const std::size_t size = cpp_size(generation.system.type(*event->type));
        fields.push_back({cpp_type(generation.system, *event->type), "kept_value_" + event->input, "", "", size, size});
    }
    return fields;
}

}  // namespace

std::string package_namespace(const std::string& package) {
    std::string result;
    std::size_t begin = 0;
    while (begin <= package.size() && !package.empty()) {
        const std::size_t end = std::min(package.find("::", begin), package.size());
        NameScope scope;
        result += (result.empty() ? "" : "::") + scope.unique(package.substr(begin, end - begin));
        begin = end + 2;
    }
    return result.empty() ? "robot" : result;
}

void file_comment(const Generation& generation, CodeWriter& out, const std::string& what) {
    const Component& component = generation.component;
    out.comment(fmt::format("{} of the RoboChart {} {}.", what, component.kind, generation.place(component.origin)));
    out.comment("Generated by robochart-verify; change the model, not this file.");
}

Core make_core(const Generation& generation) {
    Core core;
    const Component& component = generation.component;
    core.relative = component.cpp_name + "_core";
    core.name_space = package_namespace(component.package) + "::" + core.relative;
    core.header = component.cpp_name + "_core.hpp";
    NameScope type_names(std::set<std::string>{"State", "Inputs", "Step", "Real", "Nat", "Int", "Types", "Platform",
                                               "step", "advance_clock", "advance_wait", "duration", "divide",
                                               "modulus"});
    for (const ir::TypeId id : component.enumerations) (void)type_names.unique(generation.system.type(id).name);
    for (const Unit& unit : component.units) {
        (void)type_names.unique(unit.frame);
        (void)type_names.unique(unit.points);
    }
    for (const EventPort& event : component.events)
        if (event.received && generation.mutation.hits(Fault::event_kept)) core.kept.push_back(&event);
    Layouts layouts;
    for (const Unit& unit : component.units) {
        core.machines.push_back(generate(generation, unit, layouts, type_names,
                                         unit.root ? kept_fields(generation, core) : std::vector<Field>{}));
        layouts[unit.id] = core.machines.back().layout;
    }
    return core;
}

std::string core_header(const Generation& generation, const Core& core) {
    CodeWriter out;
    file_comment(generation, out, "Core");
    out.comment("One call of step() is one control cycle; see robochart/runtime.hpp for its results.");
    out.line("#pragma once");
    out.gap();
    out.line("#include <cstdint>");
    out.gap();
    out.line("#include \"robochart/runtime.hpp\"");
    out.gap();
    out.line(fmt::format("namespace {} {{", core.name_space));
    out.gap();
    out.doc("Time units that pass between two cycles.");
    out.line(fmt::format("inline constexpr std::uint32_t cycle_length = {};",
                         std::max(1U, generation.options.cycle_length)));
    out.doc("Steps that one cycle may take before the model is taken to diverge.");
    out.line(fmt::format("inline constexpr std::uint32_t step_bound = {};", bound_text(core)));
    out.gap();
    out.line("using robochart::advance_clock, robochart::advance_wait, robochart::duration;");
    out.line("using robochart::divide, robochart::modulus;");
    write_declared_types(generation, out);
    for (std::size_t index = 0; index < core.machines.size(); ++index) {
        for (const Enumeration& enumeration : core.machines[index].enumerations) write_enumeration(out, enumeration);
        write_frame(out, generation.component.units[index], core.machines[index].layout);
    }
    write_inputs(generation, out);
    write_platform_comment(generation, out);
    write_step_class(generation, core, out);
    out.gap();
    out.doc("One control cycle of the controller.");
    out.line("template <class Types, class Platform>");
    out.open(
        "robochart::StepResult step(State<Types>& state, const Inputs<Types>& inputs, Platform& platform) noexcept {");
    out.line("return Step<Types, Platform>(state, inputs, platform).cycle();");
    out.close();
    out.gap();
    out.line(fmt::format("}}  // namespace {}", core.name_space));
    return out.text();
}

}  // namespace robochart::cpp_emit
