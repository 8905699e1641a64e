// SPDX-License-Identifier: Apache-2.0
// Writes the core header. The deployed controller and the explorer use the same translation of the machine.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "cpp_emit/code/carriers.hpp"
#include "cpp_emit/code/cycles.hpp"
#include "cpp_emit/code/dispatch.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/faults/code_faults.hpp"
#include "cpp_emit/files/channels.hpp"
#include "cpp_emit/files/files.hpp"
#include "cpp_emit/files/shipped_headers.hpp"
#include "cpp_emit/plan/feature_analysis.hpp"
#include "cpp_emit/plan/list_capacities.hpp"
#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

namespace {

void numeric_aliases(CodeWriter& out) {
    for (const char* name : {"Real", "Nat", "Int"}) out.line(fmt::format("using {0} = typename Types::{0};", name));
}

std::string bound_text(const Core& core) {
    // The bound on the steps of a cycle is larger if there are more places, because a loop over a variable may visit
    // each of its places many times in one cycle. A model that needs more steps without the passing of time is assumed
    // to diverge.
    std::size_t places = 0;
    for (const MachineCode& machine : core.machines)
        for (const Enumeration& enumeration : machine.enumerations) places += enumeration.values.size();
    return fmt::format("{}", 100'000 + 16 * places);
}

void write_enumeration(CodeWriter& out, const Enumeration& enumeration) {
    out.gap();
    out.doc(enumeration.comment);
    const char* base = enumeration.values.size() <= 256 ? "std::uint8_t" : "std::uint16_t";
    out.open(fmt::format("enum class {} : {} {{", enumeration.name, base));
    for (const Enumerator& value : enumeration.values) {
        if (value.comment.empty())
            out.line(value.name + ",");
        else
            out.line_with_doc(value.name + ",", value.comment);
    }
    out.close("};");
}

/// Writes the comparison `lhs.x == rhs.x && ...`, for language standards without defaulted comparison.
void write_comparison(CodeWriter& out, const std::string& name, const std::vector<std::string>& fields) {
    std::vector<std::string> equal;
    for (const std::string& field : fields) equal.push_back(fmt::format("lhs.{0} == rhs.{0}", field));
    const char* const unused = fields.empty() ? "[[maybe_unused]] " : "";
    out.open(fmt::format("friend constexpr bool operator==({1}const {0}& lhs, {1}const {0}& rhs) noexcept {{", name,
                         unused));
    out.line(fmt::format("return {};", equal.empty() ? "true" : fmt::format("{}", fmt::join(equal, " && "))));
    out.close();
    out.line(fmt::format(
        "friend constexpr bool operator!=(const {0}& lhs, const {0}& rhs) noexcept {{ return !(lhs == rhs); }}", name));
}

/// Writes the order in which sets sort their elements: the first member that differs decides.
void write_order(CodeWriter& out, const std::string& name, const std::vector<std::string>& fields) {
    out.open(fmt::format("friend constexpr bool operator<(const {0}& lhs, const {0}& rhs) noexcept {{", name));
    for (const std::string& field : fields)
        out.line(fmt::format("if (!(lhs.{0} == rhs.{0})) return lhs.{0} < rhs.{0};", field));
    out.line("return false;");
    out.close();
}

/// Writes a static function that makes a value from its members.
void write_maker(const Generation& generation, CodeWriter& out, const std::string& type, const std::string& maker,
                 const std::vector<TypeMember>& given, const std::string& also) {
    std::vector<std::string> parameters;
    for (const TypeMember& member : given)
        parameters.push_back(fmt::format("{} a_{}", cpp_type(generation.system, member.type), member.name));
    out.open(
        fmt::format("[[nodiscard]] static constexpr {} {}({}) noexcept {{", type, maker, fmt::join(parameters, ", ")));
    out.line(fmt::format("{} value{{}};", type));
    if (!also.empty()) out.line(also);
    for (const TypeMember& member : given) out.line(fmt::format("value.{0} = a_{0};", member.name));
    out.line("return value;");
    out.close();
}

/// Writes the maker functions of a type. A record or product has one; an enumeration whose literals have arguments has
/// one for each literal.
void write_makers(const Generation& generation, CodeWriter& out, const ir::Type& type) {
    const std::string name = declared_name(type);
    const std::vector<TypeMember> all = type_members(type);
    if (type.kind != ir::TypeKind::enumeration) return write_maker(generation, out, name, "make", all, "");
    for (std::size_t literal = 0; literal < type.labels.size(); ++literal) {
        std::vector<TypeMember> given;
        std::ranges::copy_if(all, std::back_inserter(given),
                             [&](const TypeMember& member) { return member.literal == literal; });
        const std::string label = literal_name(type, literal);
        write_maker(generation, out, name, label, given, fmt::format("value.kind = Kind::{};", label));
    }
}

/// Writes the members with which a struct that contains lists tells whether a list has overflowed.
void write_overflow(const Generation& generation, CodeWriter& out, const ir::Type& type) {
    std::vector<std::string> tests, drops;
    for (const TypeMember& member : type_members(type)) {
        if (!has_lists(generation.system, member.type)) continue;
        tests.push_back(fmt::format("robochart::overflowed({})", member.name));
        drops.push_back(fmt::format("dropped = robochart::drop_overflow({}) || dropped;", member.name));
    }
    if (tests.empty()) return;
    out.open("[[nodiscard]] constexpr bool overflowed() const noexcept {");
    out.line(fmt::format("return {};", fmt::join(tests, " || ")));
    out.close();
    out.open("constexpr bool drop_overflow() noexcept {");
    out.line("bool dropped = false;");
    for (const std::string& line : drops) out.line(line);
    out.line("return dropped;");
    out.close();
}

void write_value_struct(const Generation& generation, CodeWriter& out, const ir::Type& type) {
    std::vector<Field> fields;
    for (const TypeMember& member : type_members(type)) {
        const Extent extent = cpp_extent(generation.system, generation.inst, member.type);
        fields.push_back({cpp_type(generation.system, member.type), member.name, "", "", extent.size, extent.alignment,
                          extent.varies});
    }
    const bool tagged = type.kind == ir::TypeKind::enumeration;
    if (tagged) fields.push_back({"Kind", "kind", "Kind::" + literal_name(type, 0), "", 1, 1});
    const FrameLayout layout = arrange_fields(std::move(fields), false);
    out.gap();
    out.doc(generation.place_text(type.origin.element.empty() ? type.name : type.origin.element, type.origin.span));
    out.line("template <class Types>");
    out.open(fmt::format("struct {} {{", declared_name(type)));
    numeric_aliases(out);
    if (tagged) {
        std::vector<std::string> labels;
        for (std::size_t i = 0; i < type.labels.size(); ++i) labels.push_back(literal_name(type, i));
        out.line(fmt::format("enum class Kind : std::uint8_t {{ {} }};", fmt::join(labels, ", ")));
    }
    out.gap();
    std::vector<std::string> compared;
    for (const Field& field : layout.fields) {
        out.line(fmt::format("{} {}{};", field.type, field.name, field.initial.empty() ? "{}" : " = " + field.initial));
        if (!field.name.starts_with("filler[")) compared.push_back(field.name);
    }
    out.gap();
    write_makers(generation, out, type);
    write_comparison(out, declared_name(type), compared);
    if (generation.component.ordered) write_order(out, declared_name(type), compared);
    write_overflow(generation, out, type);
    out.close("};");
}

void write_declared_types(const Generation& generation, CodeWriter& out) {
    for (const ir::TypeId id : generation.component.enumerations) {
        const ir::Type& type = generation.system.type(id);
        if (is_struct(type)) {
            write_value_struct(generation, out, type);
            continue;
        }
        if (type.kind == ir::TypeKind::given) {
            out.gap();
            out.doc("Given type " + generation.place_text(type.origin) + ": its elements are numbered.");
            out.line(fmt::format("enum class {} : std::uint8_t {{}};", cpp_type(generation.system, id)));
            continue;
        }
        Enumeration enumeration{cpp_type(generation.system, id), generation.place_text(type.origin), {}};
        for (std::size_t index = 0; index < type.labels.size(); ++index)
            enumeration.values.push_back({literal_name(type, index), "", {}});
        write_enumeration(out, enumeration);
    }
}

void write_struct(const Generation& generation, CodeWriter& out, const std::string& name, const FrameLayout& layout) {
    out.line("template <class Types>");
    out.open(fmt::format("struct {} {{", name));
    numeric_aliases(out);
    out.gap();
    for (const Field& field : layout.fields) {
        const std::string initial = field.initial.empty() ? "{}" : " = " + field.initial;
        if (generation.mutation.hits(Fault::undeclared_member)) continue;
        const std::string member = fmt::format("{} {}{};", field.type, field.name, initial);
        if (field.comment.empty())
            out.line(member);
        else
            out.line_with_doc(member, field.comment);
    }
    out.gap();
    std::vector<std::string> compared;
    for (const Field& field : layout.fields)
        if (!field.name.starts_with("filler[")) compared.push_back(field.name);
    write_comparison(out, name, compared);
    out.close("};");
}

void write_frame(const Generation& generation, CodeWriter& out, const Unit& unit, const FrameLayout& layout) {
    out.gap();
    const bool whole = unit.root && !generation.component.is_composed();
    if (whole)
        out.doc(fmt::format("The whole state of {}: a value without padding, equal states have equal bytes.",
                            unit.machine->name));
    else if (unit.root)
        out.doc(fmt::format("Machine {}.", generation.component.part_of(unit).name));
    else
        out.doc(fmt::format("Operation {} in progress; as constructed when it is not.", unit.machine->name));
    write_struct(generation, out, unit.frame, layout);
}

/// Writes the State that contains the frames of several machines.
void write_state(const Generation& generation, CodeWriter& out, const FrameLayout& layout) {
    out.gap();
    out.doc(fmt::format("The whole state of {}: a value without padding, equal states have equal bytes.",
                        generation.component.name));
    write_struct(generation, out, "State", layout);
}

/// Writes the test whether a list in the inputs has more items than its capacity.
void write_input_overflow(const Generation& generation, CodeWriter& out) {
    const std::vector<std::string> lists = list_inputs(generation);
    if (lists.empty()) return;
    std::string test;
    for (const std::string& input : lists)
        test += fmt::format("{}(inputs.{}.present && robochart::overflowed(inputs.{}.value))",
                            test.empty() ? "" : " || ", input, input);
    out.gap();
    out.doc("Whether a list has more items than its capacity: such inputs are refused.");
    out.line("template <class Types>");
    out.open("[[nodiscard]] constexpr bool overflowed(const Inputs<Types>& inputs) noexcept {");
    out.open("if constexpr (!robochart::HasCarriers<Types>::value) {");
    out.line(fmt::format("return {};", test));
    out.reopen_block("} else {");
    out.line("return false;");
    out.close();
    out.close();
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
        if (!variable.input.empty() && !variable.copy)
            out.line(fmt::format("robochart::Message<{}> {};", cpp_type(generation.system, variable.variable->type),
                                 variable.input));
    out.close("};");
    write_input_overflow(generation, out);
}

std::string parameter_list(const Generation& generation, const ir::OperationSignature& signature) {
    std::string parameters;
    for (std::size_t i = 0; i < signature.parameters.size(); ++i)
        parameters += fmt::format("{}{} {}", i == 0 ? "" : ", ", cpp_type(generation.system, signature.parameters[i]),
                                  signature.parameter_names[i]);
    return parameters;
}

void write_platform_comment(const Generation& generation, CodeWriter& out) {
    std::vector<std::string> calls;
    const auto method = [&](const char* result, const std::string& name, const std::string& parameters,
                            const std::vector<ir::TypeId>& types) {
        out.comment(fmt::format("    {} {}({});", result, name, parameters));
        std::vector<std::string> values;
        for (const ir::TypeId type : types)
            values.push_back(fmt::format("std::declval<{}>()", cpp_type(generation.system, type)));
        calls.push_back(fmt::format("{}({})", name, fmt::join(values, ", ")));
    };
    const Component& component = generation.component;
    out.gap();
    out.comment(
        "The platform that Step drives has these methods, all noexcept; replaces_X answers true when it has done X "
        "itself:");
    for (const FunctionHook& hook : component.functions) {
        const ir::Function& function = generation.system.functions[hook.id.index];
        std::vector<std::string> parameters;
        for (const ir::TypeId type : function.parameters) parameters.push_back(cpp_type(generation.system, type));
        method(cpp_type(generation.system, function.result).c_str(), hook.method,
               fmt::format("{}", fmt::join(parameters, ", ")), function.parameters);
    }
    for (const PlatformCall& call : component.calls)
        method("void", call.method, parameter_list(generation, *call.signature), call.signature->parameters);
    for (const ModelledCall& call : component.modelled)
        method("bool", call.method, parameter_list(generation, *call.signature), call.signature->parameters);
    for (const EventPort& event : component.events)
        if (!event.output.empty())
            method("void", event.output, event.type ? cpp_type(generation.system, *event.type) + " value" : "",
                   event.type ? std::vector{*event.type} : std::vector<ir::TypeId>{});
    for (const StoredVariable& variable : component.variables)
        if (variable.visible && !variable.copy)
            method("void", variable.output, cpp_type(generation.system, variable.variable->type) + " value",
                   {variable.variable->type});
    write_platform_concept(calls, out);
}

/// Writes the function that writes a variable which others see. For RoboSim, the register of the composition and the
/// machine's copy change.
void write_variable(const Generation& generation, const StoredVariable& variable, CodeWriter& out) {
    std::vector<std::string> lines;
    if (variable.has_member())
        lines.push_back(variable.local ? variable.field + ".write(value);"
                                       : fmt::format("state_.{} = value;", variable.path));
    const StoredVariable* const memory = generation.component.memory_of(variable);
    if (memory != nullptr && memory->has_member() && !generation.mutation.hits(Fault::write_not_relayed))
        lines.push_back(fmt::format("state_.{} = value;", memory->path));
    if (!variable.output.empty()) lines.push_back(fmt::format("platform_.{}(value);", variable.output));
    out.open_declaration(
        "Shared variable " + generation.place_text(variable.variable->origin),
        fmt::format("void {}({}{} value) noexcept {{", variable.writer, lines.empty() ? "[[maybe_unused]] " : "",
                    cpp_type(generation.system, variable.variable->type)));
    for (const std::string& line : lines) out.line(line);
    out.close();
}

void write_variables(const Generation& generation, CodeWriter& out) {
    for (const StoredVariable& variable : generation.component.variables)
        if (!variable.writer.empty()) write_variable(generation, variable, out);
}

/// Writes the propagation. The memories that propagate writes to the machines accept one write at a time. If a machine
/// holds up a write, it holds up the later writes too (semantics 3.7).
void write_propagation(const Generation& generation, CodeWriter& out) {
    const Component& component = generation.component;
    for (const StoredVariable& variable : component.variables) {
        if (variable.holders.empty()) continue;
        out.open_declaration(
            fmt::format("Earlier writes of {} are not propagated yet: the next has to wait.", variable.variable->name),
            fmt::format("[[nodiscard]] bool {}() const noexcept {{", variable.held_up));
        for (const PropagationHolder& holder : variable.holders)
            out.line(fmt::format("if (holds_up({}) && state_.{} >= {}) return true;",
                                 component.parts[holder.part].frame_expression(), holder.field, variable.memories));
        out.line("return false;");
        out.close();
        out.open_declaration(fmt::format("A write of {} is on its way to the machines.", variable.variable->name),
                             fmt::format("void {}() noexcept {{", variable.propagate));
        for (const PropagationHolder& holder : variable.holders)
            out.line(fmt::format("if (holds_up({})) ++state_.{};", component.parts[holder.part].frame_expression(),
                                 holder.field));
        out.close();
    }
}

void take_kept(CodeWriter& out, const EventPort& event) {
    out.open(fmt::format("if (state_.kept_{0} && !inputs_.{0}.present) {{", event.input));
    out.line(fmt::format("inputs_.{}.present = true;", event.input));
    if (event.type) out.line(fmt::format("inputs_.{0}.value = state_.kept_value_{0};", event.input));
    out.close();
}

void keep_input(CodeWriter& out, const EventPort& event) {
    out.line(fmt::format("state_.kept_{0} = inputs_.{0}.present;", event.input));
    if (!event.type) return;
    out.line(fmt::format("state_.kept_value_{0} = {{}};", event.input));
    out.line(fmt::format("if (inputs_.{0}.present) state_.kept_value_{0} = inputs_.{0}.get();", event.input));
}

/// Writes the effect of external writes, which is immediate. With Fault::outside_write_late, the writes are added to
/// `late` and take effect after the cycle.
void write_outside(const Generation& generation, const StoredVariable& variable, CodeWriter& out,
                   std::vector<std::string>& late) {
    const std::string line =
        fmt::format("if (inputs_.{0}.present) state_.{1} = inputs_.{0}.get();", variable.input, variable.path);
    if (generation.mutation.hits(Fault::outside_write_late))
        late.push_back(line);
    else
        out.line(line);
}

/// For RoboSim: writes the end of a cycle. If a component can neither continue nor end its cycle, time stops.
void write_end_of_cycle(const Generation& generation, CodeWriter& out) {
    if (generation.mutation.hits(Fault::cycle_stop_hidden)) return;
    std::string ended;
    for (const Part& part : generation.component.parts) {
        const std::string one = ended_member(generation.component, generation.component.units[part.root]);
        const bool others = generation.component.is_composed();
        ended += (ended.empty() ? "" : " && ") +
                 (others ? fmt::format("({} || finished({}))", one, part.frame_expression()) : one);
    }
    out.open(fmt::format("if (result == robochart::StepResult::quiescent && !({})) {{", ended));
    out.line("return robochart::StepResult::deadline;");
    out.close();
}

void write_cycle(const Generation& generation, const Core& core, CodeWriter& out) {
    out.doc("One control cycle: inputs, everything that they and time make possible, then time passes.");
    out.open("robochart::StepResult cycle() noexcept {");
    std::vector<std::string> late;
    for (const StoredVariable& variable : generation.component.variables)
        if (!variable.input.empty() && variable.has_member()) write_outside(generation, variable, out, late);
    read_registers_between_machines(generation, out);
    for (const EventPort* event : core.kept_inputs) take_kept(out, *event);
    write_drops(generation, out);
    const char* const state = generation.component.is_composed() ? "" : "state_";
    out.line(fmt::format("run({});", state));
    forget_raised(generation, out);
    for (const EventPort* event : core.kept_inputs) keep_input(out, *event);
    for (const std::string& line : late) out.line(line);
    out.line(fmt::format("const robochart::StepResult result = this->result(finished({}));", state));
    if (generation.component.robosim) write_end_of_cycle(generation, out);
    if (core.layout.timed) out.line(fmt::format("if (result == robochart::StepResult::quiescent) advance({});", state));
    out.line("return late() ? robochart::StepResult::deadline : result;");
    out.close();
}

/// Writes the trace hook. It produces no code if the platform does not use it.
void write_hook(const Generation& generation, CodeWriter& out) {
    out.open_declaration(
        fmt::format("Tells a platform that has a method `taken` of a transition; {}_trace.hpp names them.",
                    generation.component.cpp_name),
        "void taken([[maybe_unused]] std::uint32_t transition) noexcept {");
    out.line("if constexpr (robochart::Listens<Platform>::value) platform_.taken(transition);");
    out.close();
    if (!generation.options.choices) return;
    out.open_declaration(
        "Whether an enabled transition is the one to take, while a platform that has a method `pick` is asked.",
        "bool in_turn() noexcept {");
    out.open("if constexpr (robochart::Picks<Platform>::value) {");
    out.line("return turn_.come();");
    out.reopen_block("} else {");
    out.line("return true;");
    out.close();
    out.close();
}

/// Writes the variables that no later cycle reads.
void write_local_variables(const Generation& generation, CodeWriter& out) {
    for (const StoredVariable& variable : generation.component.variables)
        if (variable.local)
            out.line_with_doc(fmt::format("robochart::Local<{}> {};",
                                          cpp_type(generation.system, variable.variable->type), variable.field),
                              generation.place_text(variable.variable->origin) + ": no later cycle reads it");
}

void write_step_class(const Generation& generation, const Core& core, CodeWriter& out) {
    out.gap();
    out.line("ROBOCHART_MODEL_BEGIN");
    out.doc("The behaviour. It lives for one cycle.");
    out.line("template <class Types, class Platform>");
    out.open("class Step : private robochart::Cycle {");
    out.write_label("public:");
    numeric_aliases(out);
    if (const std::size_t least = least_longest(generation.system, generation.component); least > 1)
        out.line(
            fmt::format("static_assert(robochart::HasCarriers<Types>::value || Types::longest >= {0}, \"a list "
                        "of the model has {0} items\");",
                        least));
    out.gap();
    out.line("Step(State<Types>& state, const Inputs<Types>& inputs, Platform& platform) noexcept");
    out.line("    : Cycle(step_bound), state_(state), inputs_(inputs), platform_(platform) {}");
    out.gap();
    write_cycle(generation, core, out);
    write_dispatch(generation, generation.component.is_composed() ? "" : core.machines.back().dispatch, out);
    out.gap();
    out.write_label("private:");
    write_variables(generation, out);
    write_propagation(generation, out);
    write_hook(generation, out);
    for (const MachineCode& machine : core.machines) {
        out.gap();
        out.write_raw(machine.methods);
    }
    write_preconditions(generation, out);
    write_carriers(generation, out);
    write_channels(generation, core, out);
    if (generation.component.is_composed()) write_composition(generation, core, out);
    out.gap();
    out.line("State<Types>& state_;");
    out.line("Inputs<Types> inputs_;");
    out.line("Platform& platform_;");
    if (generation.options.choices) out.line("[[maybe_unused]] robochart::Turn turn_;");
    write_local_variables(generation, out);
    write_cycle_members(generation, out);
    out.close("};");
    out.line("ROBOCHART_MODEL_END");
}

}  // namespace

namespace {

/// Returns the members of the state for inputs that outlive their cycle.
std::vector<Field> kept_fields(const Generation& generation, const Core& core) {
    std::vector<Field> fields;
    for (const EventPort* event : core.kept_inputs) {
        fields.push_back({"bool", "kept_" + event->input, "false", "", 1, 1});
        if (!event->type) continue;
        const Extent extent = cpp_extent(generation.system, generation.inst, *event->type);
        fields.push_back({cpp_type(generation.system, *event->type), "kept_value_" + event->input, "", "", extent.size,
                          extent.alignment, extent.varies});
    }
    return fields;
}

}  // namespace

std::string package_namespace(const std::string& package) {
    std::string result;
    std::size_t begin = 0;
    while (begin <= package.size() && !package.empty()) {
        const std::size_t end = std::min(package.find("::", begin), package.size());
        NameScope scope(result.empty() ? reserved_at_global_scope : reserved_below_global_scope);
        result += (result.empty() ? "" : "::") + scope.unique_name(package.substr(begin, end - begin));
        begin = end + 2;
    }
    return result.empty() ? "robot" : result;
}

void file_comment(const Generation& generation, CodeWriter& out, const std::string& what) {
    const Component& component = generation.component;
    out.comment(fmt::format("{} of the {} {} ", what, component.robosim ? "RoboSim" : "RoboChart", component.kind) +
                generation.place_text(component.origin) + ".");
    out.comment("Generated by robochart-verify; change the model, not this file.");
}

Core make_core(const Generation& generation) {
    Core core;
    const Component& component = generation.component;
    core.relative = component.cpp_name + "_core";
    core.name_space = package_namespace(component.package) + "::" + core.relative;
    core.header = component.cpp_name + "_core.hpp";
    NameScope type_names = core_type_scope(component);
    for (const ir::TypeId id : component.enumerations)
        (void)type_names.unique_name(declared_name(generation.system.type(id)));
    for (const Unit& unit : component.units) {
        (void)type_names.unique_name(unit.frame);
        (void)type_names.unique_name(unit.points);
    }
    for (const EventPort& event : component.events)
        if (event.received && generation.mutation.hits(Fault::event_kept)) core.kept_inputs.push_back(&event);
    if (!input_events(component).empty()) (void)type_names.unique_name(event_type(generation));
    std::vector<Field> more = kept_fields(generation, core);
    for (const EventPort* event : dropping_events(generation))
        more.push_back({"bool", event->raised, "false", "an event before it in this cycle, for dispatch()", 1, 1});
    const std::vector<Field> common = common_fields(generation);
    more.insert(more.end(), common.begin(), common.end());
    Layouts layouts;
    const bool composed = component.is_composed();
    for (const Unit& unit : component.units) {
        core.machines.push_back(generate_machine(generation, unit, layouts, type_names,
                                                 unit.root && !composed ? more : std::vector<Field>{}));
        layouts[unit.number] = core.machines.back().layout;
    }
    core.layout = composed ? composed_layout(generation, core, std::move(more)) : core.machines.back().layout;
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
    std::vector<std::string> headers = {"robochart/runtime.hpp"};
    for (const OutputFile& header : value_headers(generation.component))
        if (header.path != "robochart/eigen.hpp") headers.push_back(header.path);
    std::ranges::sort(headers);
    for (const std::string& header : headers) out.line(fmt::format("#include \"{}\"", header));
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
    out.line("using robochart::divide, robochart::minus, robochart::modulus, robochart::negative, robochart::plus;");
    out.line("using robochart::place_of, robochart::rounded_down, robochart::times;");
    write_declared_types(generation, out);
    for (std::size_t index = 0; index < core.machines.size(); ++index) {
        for (const Enumeration& enumeration : core.machines[index].enumerations) write_enumeration(out, enumeration);
        write_frame(generation, out, generation.component.units[index], core.machines[index].layout);
    }
    if (generation.component.is_composed()) write_state(generation, out, core.layout);
    write_inputs(generation, out);
    write_event_type(generation, out);
    write_platform_comment(generation, out);
    write_step_class(generation, core, out);
    out.gap();
    out.doc("The state before the first cycle, which runs the initial transition.");
    out.line("template <class Types>");
    out.open("[[nodiscard]] constexpr State<Types> init() noexcept {");
    out.line("return {};");
    out.close();
    out.gap();
    out.doc("One control cycle of the controller.");
    out.line("template <class Types, class Platform>");
    out.open(
        "robochart::StepResult step(State<Types>& state, const Inputs<Types>& inputs, Platform& platform) noexcept {");
    out.line("#if defined(__cpp_concepts) && __cpp_concepts >= 201907L");
    out.line("static_assert(PlatformOf<Platform, Types>, \"the platform lacks a method, or one may throw\");");
    out.line("#endif");
    if (!list_inputs(generation).empty()) out.line("if (overflowed(inputs)) return robochart::StepResult::capacity;");
    out.line("return Step<Types, Platform>(state, inputs, platform).cycle();");
    out.close();
    write_dispatch_functions(generation, out);
    out.gap();
    out.line(fmt::format("}}  // namespace {}", core.name_space));
    return faulty_code(out.text(), generation.mutation);
}

}  // namespace robochart::cpp_emit
