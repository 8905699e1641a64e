// SPDX-License-Identifier: Apache-2.0
// Emits the interface for simulators; see simulator_api.hpp.
#include "cpp_emit/simulator_api.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>

#include "cpp_emit/faults/faulty_model.hpp"
#include "cpp_emit/files/files.hpp"
#include "cpp_emit/files/shipped_headers.hpp"
#include "cpp_emit/plan/resolve_component.hpp"
#include "cpp_emit/plan/rules.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/unsupported.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::cpp_emit {

namespace {

Carried carried_kind(ir::TypeKind kind) {
    switch (kind) {
        case ir::TypeKind::boolean:
            return Carried::boolean;
        case ir::TypeKind::nat:
        case ir::TypeKind::integer:
            return Carried::whole;
        case ir::TypeKind::real:
            return Carried::real;
        case ir::TypeKind::string:
        case ir::TypeKind::enumeration:
        case ir::TypeKind::given:
        case ir::TypeKind::sequence:
        case ir::TypeKind::set:
        case ir::TypeKind::product:
        case ir::TypeKind::record:
        case ir::TypeKind::function:
        case ir::TypeKind::relation:
        case ir::TypeKind::vector:
        case ir::TypeKind::matrix:
        case ir::TypeKind::unit:
            break;
    }
    return Carried::enumeration;
}

/// Returns the full name of a type: "nat", "Zone", "pack::Zone".
std::string full_name(const std::string& package, const std::string& name) {
    return package.empty() ? name : package + "::" + name;
}

/// Returns the encoding of a value in a port, for types without parts. A number is given in the model's units, a
/// boolean as 0 or 1, a literal by its index.
double carried_value(const ir::Instantiation& inst, Carried kind, const ir::Value& value) {
    const auto number = static_cast<double>(value.number);
    return kind == Carried::real ? number / static_cast<double>(inst.scale) : number;
}

/// A port, with the data for the emitted text.
struct Channel {
    Port port;
    std::string exported;  ///< name in the interface
    std::string member;    ///< member of Inputs, or method of the platform
    std::vector<ir::TypeId> types;
};

class DriveWriter {
public:
    DriveWriter(const Generation& generation, const Core& core) : generation_(generation), core_(core) {
        collect_inputs();
        collect_outputs();
        for (std::size_t part = 0; part < generation.component.parts.size(); ++part) collect_machine(part);
    }

    std::string write() {
        write_head();
        write_names("inputs", inputs_);
        write_names("outputs", outputs_);
        machine_tables();
        actions_class();
        state_function();
        place_function();
        step_function();
        write_table();
        return out_.text();
    }

    [[nodiscard]] static std::vector<Port> ports_of(const std::vector<Channel>& channels) {
        std::vector<Port> result;
        for (const Channel& channel : channels) result.push_back(channel.port);
        return result;
    }
    [[nodiscard]] std::vector<Port> inputs() const { return ports_of(inputs_); }
    [[nodiscard]] std::vector<Port> outputs() const { return ports_of(outputs_); }
    [[nodiscard]] const std::vector<DriveMachine>& machines() const { return machines_; }

private:
    Channel make_channel(Port::Kind kind, const std::string& name, std::string exported, std::string member,
                         std::vector<ir::TypeId> types) const {
        Channel result{{kind, name, {}}, std::move(exported), std::move(member), std::move(types)};
        result.port.exported = result.exported;
        for (const ir::TypeId id : result.types) {
            const ir::Type& type = generation_.system.type(id);
            result.port.arguments.push_back(carried_kind(type.kind));
            const bool named = type.kind == ir::TypeKind::enumeration;
            result.port.literals.push_back(named ? type.labels : std::vector<std::string>{});
            result.port.types.push_back(full_name(type.package, type.name));
        }
        return result;
    }

    static std::vector<ir::TypeId> to_list(const std::optional<ir::TypeId>& type) {
        return type ? std::vector<ir::TypeId>{*type} : std::vector<ir::TypeId>{};
    }

    void collect_inputs() {
        for (const EventPort& event : generation_.component.events)
            if (event.received)
                inputs_.push_back(make_channel(Port::Kind::event, event.outside, event.outside + ".in", event.input,
                                               to_list(event.type)));
        for (const StoredVariable& variable : generation_.component.variables)
            if (!variable.input.empty() && !variable.copy)
                inputs_.push_back(make_channel(Port::Kind::variable, variable.name(), "set_EXT_" + variable.name(),
                                               variable.input, {variable.variable->type}));
    }

    void collect_machine(std::size_t part) {
        assert(part == machines_.size());
        const Unit& root = generation_.component.root_unit(part);
        DriveMachine added{generation_.component.parts[part].name, root.id, {}};
        for (std::uint32_t node = 0; node < root.machine->nodes.size(); ++node) {
            const ir::NodeKind kind = root.machine->nodes[node].kind;
            if (kind == ir::NodeKind::state || kind == ir::NodeKind::final) added.states.push_back(ir::NodeId{node});
        }
        machines_.push_back(std::move(added));
    }

    void collect_outputs() {
        for (const PlatformCall& call : generation_.component.calls)
            outputs_.push_back(make_channel(Port::Kind::call, call.signature->name, call.signature->name + "Call",
                                            call.method, call.signature->parameters));
        for (const EventPort& event : generation_.component.events)
            if (!event.output.empty())
                outputs_.push_back(make_channel(Port::Kind::event, event.outside, event.outside + ".out", event.output,
                                                to_list(event.type)));
        for (const StoredVariable& variable : generation_.component.variables) {
            if (!variable.visible || variable.copy) continue;
            outputs_.push_back(make_channel(Port::Kind::variable, variable.name(), "set_" + variable.name(),
                                            variable.output, {variable.variable->type}));
            outputs_.back().port.initial = initial_number(variable);
        }
    }

    [[nodiscard]] double initial_number(const StoredVariable& variable) const {
        const Carried kind = carried_kind(generation_.system.type(variable.variable->type).kind);
        const bool number = kind == Carried::real || kind == Carried::whole;
        return number ? carried_value(generation_.inst, kind, variable.initial) : 0;
    }

    void write_head() {
        file_comment(generation_, out_, "Interface for simulators");
        for (const char* header : {"<new>", "<type_traits>"}) out_.line(fmt::format("#include {}", header));
        out_.gap();
        out_.comment("A violated precondition is a result of step(), not an abort.");
        out_.line("#define RC_REQUIRE(condition) static_cast<void>(0)");
        out_.gap();
        out_.line(fmt::format("#include \"{}\"", core_.header));
        out_.line("#include \"robochart/drive_abi.h\"");
        out_.gap();
        out_.line("namespace {");
        out_.gap();
        out_.line(fmt::format("namespace core = ::{};", core_.name_space));
        out_.line("using Types = robochart::Deployment;");
        out_.line("using Real = Types::Real;");
        out_.line("using Nat = Types::Nat;");
        out_.line("using Int = Types::Int;");
        out_.line("using State = core::State<Types>;");
        out_.line("using Inputs = core::Inputs<Types>;");
        out_.gap();
        out_.gap();
        out_.doc("The value that a simulator keeps for each robot.");
        out_.open("struct Controller {");
        out_.line("State state{};");
        if (generation_.component.probabilistic) out_.line("robochart::Draws draws;");
        out_.close("};");
        out_.line("static_assert(std::is_trivially_copyable_v<Controller>);");
    }

    void write_names(const char* table, const std::vector<Channel>& channels) {
        std::vector<std::string> quoted;
        for (const Channel& channel : channels) quoted.push_back('"' + channel.exported + '"');
        string_table(table, quoted);
    }

    void machine_tables() {
        std::vector<std::string> rows;
        for (std::size_t part = 0; part < machines_.size(); ++part) {
            std::vector<std::string> quoted;
            for (const ir::NodeId id : machines_[part].states)
                quoted.push_back('"' + generation_.component.root_unit(part).machine->nodes[id.index].path + '"');
            const std::string table = fmt::format("states_{}", part);
            string_table(table, quoted);
            rows.push_back(fmt::format("{{\"{}\", {}, {}}}", machines_[part].name, quoted.size(), table));
        }
        out_.gap();
        out_.line(fmt::format("constexpr rc_machine machines[] = {{{}}};", fmt::join(rows, ", ")));
    }

    void string_table(const std::string& table, const std::vector<std::string>& quoted) {
        out_.gap();
        if (quoted.empty()) return out_.line(fmt::format("constexpr const char* const* {} = nullptr;", table));
        out_.line(fmt::format("constexpr const char* {}[] = {{{}}};", table, fmt::join(quoted, ", ")));
    }

    static Spelling spelling() { return {"Types", "core::", "Real", "Nat", "Int"}; }

    [[nodiscard]] std::string type_text(ir::TypeId id) const { return cpp_type(generation_.system, id, spelling()); }

    /// Converts an rc_value to the type.
    [[nodiscard]] std::string from_value(ir::TypeId id, const std::string& value) const {
        switch (carried_kind(generation_.system.type(id).kind)) {
            case Carried::real:
                return value + ".real";
            case Carried::whole:
                return value + ".whole";
            case Carried::boolean:
                return value + ".whole != 0";
            case Carried::enumeration:
                break;
        }
        return fmt::format("static_cast<{}>({}.whole)", type_text(id), value);
    }

    [[nodiscard]] std::string to_value(ir::TypeId id, std::size_t argument) const {
        const bool real = generation_.system.type(id).kind == ir::TypeKind::real;
        return real ? fmt::format("action->argument[{0}].real = a{0};", argument)
                    : fmt::format("action->argument[{0}].whole = static_cast<std::int64_t>(a{0});", argument);
    }

    void action_method(const Channel& output, std::size_t index) {
        std::string parameters;
        for (std::size_t i = 0; i < output.types.size(); ++i)
            parameters += fmt::format("{}{} a{}", i == 0 ? "" : ", ", type_text(output.types[i]), i);
        out_.open(fmt::format("void {}({}) noexcept {{", output.member, parameters));
        if (output.types.empty()) {
            out_.line(fmt::format("(void)add({}, 0);", index));
        } else {
            out_.line(fmt::format("::rc_action* const action = add({}, {});", index, output.types.size()));
            out_.line("if (action == nullptr) return;");
            for (std::size_t i = 0; i < output.types.size(); ++i) out_.line(to_value(output.types[i], i));
        }
        out_.close();
    }

    void modelled_method(const ModelledCall& call) {
        std::string parameters;
        for (const ir::TypeId parameter : call.signature->parameters)
            parameters += (parameters.empty() ? "" : ", ") + type_text(parameter);
        out_.line(fmt::format("bool {}({}) noexcept {{ return false; }}", call.method, parameters));
    }

    /// Writes the method for a function. Functions without a definition return the default of their type (semantics
    /// 3.13).
    void function_method(const FunctionHook& hook) {
        const ir::Function& function = generation_.system.functions[hook.id.index];
        std::vector<std::string> parameters;
        for (const ir::TypeId parameter : function.parameters) parameters.push_back(type_text(parameter));
        const ir::Value value = ir::default_value(generation_.system, generation_.inst, function.result);
        out_.line(fmt::format("{} {}({}) const noexcept {{ return {}; }}", type_text(function.result), hook.method,
                              fmt::join(parameters, ", "),
                              cpp_value(generation_.system, generation_.inst, function.result, value, spelling())));
    }

    void actions_class() {
        out_.gap();
        out_.doc("The platform: writes down what the controller does.");
        out_.open("class Actions {");
        out_.write_label("public:");
        const bool draws = generation_.component.probabilistic;
        if (draws)
            out_.line(
                "Actions(::rc_actions& actions, robochart::Draws& draws) noexcept : actions_(actions), draws_(draws) "
                "{}");
        else
            out_.line("explicit Actions(::rc_actions& actions) noexcept : actions_(actions) {}");
        out_.gap();
        if (draws)
            out_.line(
                "std::size_t choose(const double* chances, std::size_t count) noexcept { return draws_.way(chances, "
                "count); }");
        for (std::size_t index = 0; index < outputs_.size(); ++index) action_method(outputs_[index], index);
        for (const ModelledCall& call : generation_.component.modelled) modelled_method(call);
        for (const FunctionHook& hook : generation_.component.functions) function_method(hook);
        out_.gap();
        out_.write_label("private:");
        out_.open("[[maybe_unused]] ::rc_action* add(std::uint32_t output, std::uint32_t count) noexcept {");
        out_.open("if (actions_.count == ROBOCHART_DRIVE_MAX_ACTIONS) {");
        out_.line("actions_.overflow = 1;");
        out_.line("return nullptr;");
        out_.close();
        out_.line("::rc_action* const action = &actions_.action[actions_.count++];");
        out_.line("action->output = output;");
        out_.line("action->count = count;");
        out_.line("return action;");
        out_.close();
        out_.gap();
        out_.line("::rc_actions& actions_;");
        if (generation_.component.probabilistic) out_.line("robochart::Draws& draws_;");
        out_.close("};");
    }

    void state_function() {
        out_.gap();
        out_.open("std::uint32_t state_of(const void* controller, [[maybe_unused]] std::uint32_t machine) noexcept {");
        for (std::size_t part = 0; part < machines_.size(); ++part) {
            if (part + 1 < machines_.size()) out_.open(fmt::format("if (machine == {}) {{", part));
            state_switch(part);
            if (part + 1 < machines_.size()) out_.close();
        }
        out_.close();
    }

    void state_switch(std::size_t part) {
        out_.open(
            fmt::format("switch (static_cast<const Controller*>(controller)->state.{}at) {{", member_prefix(part)));
        const Enumeration& places = root_places(part);
        const std::vector<ir::NodeId>& states = machines_[part].states;
        for (const Enumerator& value : places.values) {
            const auto found = std::ranges::find(states, value.state);
            if (found != states.end())
                out_.line(
                    fmt::format("case core::{}::{}: return {};", places.name, value.name, found - states.begin()));
        }
        out_.line(fmt::format("default: return {};", states.size()));
        out_.close();
    }

    void place_function() {
        out_.gap();
        out_.open("const char* place_of(const void* controller) noexcept {");
        out_.open(fmt::format("switch (static_cast<const Controller*>(controller)->state.{}at) {{", member_prefix(0)));
        const Enumeration& places = root_places(0);
        for (const Enumerator& value : places.values)
            out_.line(fmt::format(
                "case core::{}::{}: return {};", places.name, value.name,
                diagnostics::cpp_string(value.comment.empty() ? diagnostics::ForeignText(value.name) : value.comment)));
        out_.close();
        out_.line("return \"?\";");
        out_.close();
    }

    /// Returns the prefix of the members of a part's machine: "", "stm0.".
    [[nodiscard]] std::string member_prefix(std::size_t part) const {
        const std::string& tag = generation_.component.parts[part].tag;
        return tag.empty() ? "" : tag + ".";
    }

    [[nodiscard]] const Enumeration& root_places(std::size_t part) const {
        const MachineCode& machine = core_.machines[generation_.component.parts[part].root];
        assert(!machine.enumerations.empty());
        const std::string& points = generation_.component.root_unit(part).points;
        for (const Enumeration& enumeration : machine.enumerations)
            if (enumeration.name == points) return enumeration;
        return machine.enumerations.front();
    }

    void step_function() {
        out_.gap();
        out_.open("void initial(void* controller, [[maybe_unused]] std::uint64_t seed) noexcept {");
        out_.line(generation_.component.probabilistic ? "::new (controller) Controller{{}, robochart::Draws(seed)};"
                                                      : "::new (controller) Controller{};");
        out_.close();
        out_.gap();
        out_.open(
            "rc_drive_result step(void* controller, [[maybe_unused]] const rc_signal* signals, rc_actions* actions) "
            "noexcept {");
        out_.line("Inputs read;");
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            const Channel& input = inputs_[i];
            out_.line(fmt::format("read.{}.present = signals[{}].present != 0;", input.member, i));
            if (!input.types.empty())
                out_.line(fmt::format("read.{}.value = {};", input.member,
                                      from_value(input.types.front(), fmt::format("signals[{}].value", i))));
        }
        out_.line("actions->count = 0;");
        out_.line("actions->overflow = 0;");
        out_.line("Controller& own = *static_cast<Controller*>(controller);");
        out_.line(generation_.component.probabilistic ? "Actions platform(*actions, own.draws);"
                                                      : "Actions platform(*actions);");
        out_.line("return static_cast<rc_drive_result>(core::step<Types>(own.state, read, platform));");
        out_.close();
    }

    void write_table() {
        out_.gap();
        out_.open("constexpr rc_drive drive = {");
        out_.line("ROBOCHART_DRIVE_ABI_VERSION,");
        out_.line(fmt::format("\"{}\",", generation_.component.name));
        out_.line("sizeof(Controller),");
        out_.line("alignof(Controller),");
        out_.line(fmt::format("{}, inputs,", inputs_.size()));
        out_.line(fmt::format("{}, outputs,", outputs_.size()));
        out_.line(fmt::format("{}, machines,", machines_.size()));
        out_.line("initial, step, state_of, place_of,");
        out_.close("};");
        out_.gap();
        out_.line("}  // namespace");
        out_.gap();
        out_.open("extern \"C\" const rc_drive* robochart_drive(void) {");
        out_.line("return &drive;");
        out_.close();
    }

    const Generation& generation_;
    const Core& core_;
    std::vector<Channel> inputs_;
    std::vector<Channel> outputs_;
    std::vector<DriveMachine> machines_;
    CodeWriter out_;
};

std::vector<DriveConstant> constants_of(const Component& component, const ir::System& system,
                                        const ir::Instantiation& inst) {
    std::vector<DriveConstant> result;
    for (const Unit& unit : component.units)
        for (std::size_t i = 0; i < unit.machine->constants.size(); ++i) {
            const ir::Constant& constant = unit.machine->constants[i];
            const ir::Type& type = system.type(constant.type);
            const Carried kind = carried_kind(type.kind);
            const bool literal = type.kind == ir::TypeKind::enumeration && !is_composed(type);
            if (kind == Carried::enumeration && !literal) continue;
            result.push_back({constant.name, full_name(unit.machine->package, unit.machine->name),
                              full_name(type.package, type.name), kind, carried_value(inst, kind, unit.constants[i])});
        }
    return result;
}

/// Reports values that a port cannot carry, because an rc_value can contain only numbers. Returns true if there are
/// none.
bool carries_numbers(const Component& component, const ir::System& system, diagnostics::Diagnostics& diagnostics) {
    const std::size_t before = diagnostics.error_count();
    const auto check = [&](ir::TypeId id, const std::string& name) {
        const ir::Type& type = system.type(id);
        if (is_composed(type)) diagnostics.report(rules::unsupported_type, component.origin.span, {name, type.name});
    };
    for (const EventPort& event : component.events)
        if (event.type) check(*event.type, event.model_name);
    for (const PlatformCall& call : component.calls)
        for (const ir::TypeId type : call.signature->parameters) check(type, call.signature->name);
    for (const StoredVariable& variable : component.variables)
        if (variable.visible || !variable.input.empty()) check(variable.variable->type, variable.name());
    return diagnostics.error_count() == before;
}

}  // namespace

DriveEmission emit_drive(const ir::System& system, const ir::Instantiation& inst, const ir::ComponentRef& ref,
                         const Options& options, diagnostics::Diagnostics& diagnostics) {
    DriveEmission emission;
    const std::optional<Component> component = resolve_component(system, inst, ref, diagnostics);
    if (!component || !check_support(system, inst, *component, diagnostics)) return emission;
    if (!carries_numbers(*component, system, diagnostics)) return emission;
    Mutation mutation(options.fault, options.fault_site);
    const FaultyModel model(system, inst, *component, mutation);
    const Generation generation{model.system(), inst, options, model.component(), mutation};
    const Core core = make_core(generation);
    DriveWriter writer(generation, core);
    emission.sources = {component->cpp_name + "_drive.cpp"};
    emission.files = {{core.header, core_header(generation, core)},
                      {emission.sources.front(), writer.write()},
                      {"robochart/runtime.hpp", runtime_header()},
                      {"robochart/drive_abi.h", drive_header()}};
    const std::vector<OutputFile> values = value_headers(*component);
    emission.files.insert(emission.files.end(), values.begin(), values.end());
    emission.inputs = writer.inputs();
    emission.outputs = writer.outputs();
    emission.machines = writer.machines();
    emission.constants = constants_of(*component, system, inst);
    emission.fault_sites = mutation.site_count();
    return emission;
}

}  // namespace robochart::cpp_emit
