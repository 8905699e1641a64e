// SPDX-License-Identifier: Apache-2.0
// Writes the exploration interface: the core over finite carriers or tracked numbers, called through the C functions of
// explore_abi.h. With tracked numbers, also writes the core over the types of deployment.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/code/dispatch.hpp"
#include "cpp_emit/files/explore_adapter_printers.hpp"
#include "cpp_emit/files/files.hpp"
#include "cpp_emit/plan/exploration_ports.hpp"
#include "cpp_emit/plan/functions.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::cpp_emit {

namespace {

class ShimWriter {
public:
    ShimWriter(const Generation& generation, const Core& core)
        : generation_(generation),
          core_(core),
          registers_(exploration_registers(generation.component)),
          outputs_(exploration_outputs(generation.component)),
          printers_(generation, core) {
        if (generation.options.tracked_scale > 0) {
            numbers_ = Numbers::tracked;
            tracked_ = tracked_types(generation.system, generation.component);
        }
    }

    std::string write() {
        write_head();
        write_carrier_types();
        input_tables();
        output_table();
        value_tables();
        log_class();
        printers_.write(out_, numbers_);
        write_functions();
        if (probed()) probe_function();
        event_functions();
        if (is_tracked()) write_deployed();
        interface_table();
        return out_.text();
    }

private:
    void write_head() {
        file_comment(generation_, out_, "Exploration interface");
        for (const char* header : {"<cstddef>", "<cstring>", "<new>", "<type_traits>"})
            out_.line(fmt::format("#include {}", header));
        out_.gap();
        out_.comment("A violated precondition is a result of step(), not an abort.");
        out_.line("#define RC_REQUIRE(condition) static_cast<void>(0)");
        out_.comment("Inputs notice when they are read.");
        out_.line("#define ROBOCHART_PROBES");
        out_.gap();
        out_.line(fmt::format("#include \"{}\"", core_.header));
        out_.line("#include \"robochart/explore.hpp\"");
        if (is_tracked()) {
            out_.line("#include \"robochart/tracked.hpp\"");
            out_.line("#include \"robochart/deployed.hpp\"");
        }
        if (tracks_sequences(generation_)) out_.line("#include \"robochart/tracked_sequences.hpp\"");
        if (printers_.words_of_logs()) {
            out_.line("#include \"robochart/explore_values.hpp\"");
            out_.line(fmt::format("#include \"{}\"", trace_header_name(generation_)));
        }
        out_.gap();
        out_.line("namespace {");
        out_.gap();
        // The name is not relative to the global scope, because batches wrap this code.
        out_.line(fmt::format("namespace core = {};", core_.name_space));
    }

    void carrier_struct(const char* name, const std::vector<std::int64_t>& values, std::int64_t scale) {
        out_.gap();
        const bool range =
            !values.empty() && (values.back() - values.front()) + 1 == static_cast<std::int64_t>(values.size());
        if (!range)
            out_.line(fmt::format("constexpr std::int64_t {}_values[] = {{{}}};", name, fmt::join(values, ", ")));
        out_.open(fmt::format("struct {}Carrier {{", name));
        out_.line(fmt::format("[[maybe_unused]] static constexpr std::int64_t scale = {};", scale));
        out_.open("static constexpr bool contains(std::int64_t value) noexcept {");
        out_.line(range ? fmt::format("return value >= {} && value <= {};", values.front(), values.back())
                        : fmt::format("return robochart::listed({}_values, value);", name));
        out_.close();
        out_.close("};");
    }

    void unbounded_struct(const char* name, bool natural, std::int64_t scale) {
        out_.gap();
        out_.open(fmt::format("struct {}Carrier {{", name));
        out_.line(fmt::format("[[maybe_unused]] static constexpr std::int64_t scale = {};", scale));
        out_.line(fmt::format("[[maybe_unused]] static constexpr bool natural = {};", natural));
        out_.close("};");
    }

    void write_carrier_types() {
        const ir::Instantiation& inst = generation_.inst;
        const char* number = "Finite";
        if (is_tracked()) {
            number = "Tracked";
            unbounded_struct("Nat", true, 1);
            unbounded_struct("Int", false, 1);
            unbounded_struct("Real", false, generation_.options.tracked_scale);
        } else {
            carrier_struct("Nat", inst.nat, 1);
            carrier_struct("Int", inst.integer, 1);
            carrier_struct("Real", inst.real, inst.scale);
        }
        out_.open_declaration("The model's basic types over the carriers of its instantiation.", "struct Checking {");
        for (const char* name : {"Real", "Nat", "Int"})
            out_.line(fmt::format("using {0} = robochart::{1}<{0}Carrier>;", name, number));
        out_.line(fmt::format("[[maybe_unused]] static constexpr std::size_t longest = {};", longest(inst)));
        out_.line("[[maybe_unused]] static constexpr bool finite = true;");
        out_.close("};");
        type_names();
        out_.gap();
        out_.line("static_assert(std::is_trivially_copyable_v<State>);");
        out_.line("static_assert(std::has_unique_object_representations_v<State>, \"equal states have equal bytes\");");
    }

    void type_names() {
        for (const char* name : {"Real", "Nat", "Int"}) out_.line(fmt::format("using {0} = Checking::{0};", name));
        for (const char* name : {"State", "Inputs"}) out_.line(fmt::format("using {0} = core::{0}<Checking>;", name));
    }

    void input_tables() {
        out_.gap();
        for (const Register& input : registers_) {
            if (!input.type || is_tracked(*input.type)) continue;
            std::vector<std::int64_t> numbers;
            std::vector<std::string> texts;
            const bool whole = is_composed(generation_.system.type(*input.type));
            for (const ir::Value& value : ir::carrier_values(generation_.system, generation_.inst, *input.type)) {
                numbers.push_back(whole ? static_cast<std::int64_t>(numbers.size()) : value.number);
                texts.push_back(diagnostics::cpp_string(cspm_value(generation_.system, *input.type, value)));
            }
            out_.line(
                fmt::format("constexpr std::int64_t {}_values[] = {{{}}};", input.member, fmt::join(numbers, ", ")));
            out_.line(fmt::format("constexpr const char* {}_texts[] = {{{}}};", input.member, fmt::join(texts, ", ")));
        }
        if (registers_.empty()) return out_.line("constexpr const rc_input* inputs = nullptr;");
        out_.open("constexpr rc_input inputs[] = {");
        for (const Register& input : registers_) {
            const bool listed = input.type && !is_tracked(*input.type);
            out_.line(listed ? fmt::format("{{\"{0}\", {1}, {2}_values, {2}_texts}},", input.name,
                                           ir::carrier_values(generation_.system, generation_.inst, *input.type).size(),
                                           input.member)
                             : fmt::format("{{\"{}\", 0, nullptr, nullptr}},", input.name));
        }
        out_.close("};");
    }

    void output_table() {
        out_.gap();
        if (outputs_.empty()) return out_.line("constexpr const rc_output* outputs = nullptr;");
        out_.open("constexpr rc_output outputs[] = {");
        for (const Output& output : outputs_)
            out_.line(fmt::format("{{\"{}\", {}}},", output.name, output.types.size()));
        out_.close("};");
    }

    static Spelling spelling() { return {"Checking", "core::", "Real", "Nat", "Int"}; }

    std::string type_text(ir::TypeId id) const { return cpp_type(generation_.system, id, spelling()); }

    /// Returns the name of the table of all values of a composed type at the boundary. The numbers of the type are
    /// indices into it. A table is used because compilers limit the work for a constant expression.
    std::string table_name(ir::TypeId id) const { return fmt::format("all_values_{}", id.index); }

    void value_tables() {
        std::vector<ir::TypeId> types;
        for (const Register& input : registers_)
            if (input.type) types.push_back(*input.type);
        for (const Output& output : outputs_) types.insert(types.end(), output.types.begin(), output.types.end());
        std::vector<ir::TypeId> done;
        for (const ir::TypeId id : types) {
            if (!is_composed(generation_.system.type(id)) || is_tracked(id) ||
                std::ranges::find(done, id) != done.end())
                continue;
            done.push_back(id);
            out_.gap();
            out_.open(fmt::format("const {} {}[] = {{", type_text(id), table_name(id)));
            for (const ir::Value& value : ir::carrier_values(generation_.system, generation_.inst, id))
                out_.line(cpp_value(generation_.system, generation_.inst, id, value, spelling()) + ",");
            out_.close("};");
        }
    }

    [[nodiscard]] bool is_tracked() const { return numbers_ == Numbers::tracked; }
    [[nodiscard]] bool is_tracked(ir::TypeId id) const { return std::ranges::find(tracked_, id) != tracked_.end(); }
    [[nodiscard]] std::size_t tracked_number(ir::TypeId id) const {
        return static_cast<std::size_t>(std::ranges::find(tracked_, id) - tracked_.begin());
    }

    /// Returns the numbers of a value of a tracked type, as arguments. Recursion depth: the depth of types.
    std::string number_arguments(ir::TypeId id, const std::string& value) const {
        const ir::Type& type = generation_.system.type(id);
        if (is_numeric(type.kind)) return ", " + value;
        std::string text;
        for (const TypeMember& member : type_members(type))
            text += number_arguments(member.type, fmt::format("{}.{}", value, member.name));
        return text;
    }

    /// Returns the value at `place` of a tracked type, from its part number `part` on. Recursion depth: the depth of
    /// types.
    std::string tracked_value(ir::TypeId id, std::size_t table, const std::string& place, std::size_t& part) const {
        const ir::Type& type = generation_.system.type(id);
        if (type.kind == ir::TypeKind::sequence)
            return is_tracked()
                       ? fmt::format("{}::input({}, {})", type_text(id), table, place)
                       : fmt::format("robochart::set_values.sequence<{}>({}, {})", type_text(id), table, place);
        if (is_numeric(type.kind)) {
            const std::string function =
                is_tracked() ? type_text(id) + "::part" : fmt::format("robochart::set_values.part<{}>", type_text(id));
            return fmt::format("{}({}, {}, {})", function, table, place, part++);
        }
        std::string parts;
        for (const TypeMember& member : type_members(type))
            parts += (parts.empty() ? "" : ", ") + tracked_value(member.type, table, place, part);
        return fmt::format("{}::make({})", type_text(id), parts);
    }

    /// Returns the value of an input whose register contains `place`.
    std::string input_value(const Register& input, const std::string& place) const {
        std::size_t part = 0;
        if (is_tracked(*input.type)) return tracked_value(*input.type, tracked_number(*input.type), place, part);
        if (is_composed(generation_.system.type(*input.type)))
            return fmt::format("{}[{}]", table_name(*input.type), place);
        return fmt::format("robochart::from_raw<{}>({}_values[{}])", type_text(*input.type), input.member, place);
    }

    std::string as_number(ir::TypeId id, const std::string& value) const {
        if (is_tracked(id))
            return fmt::format("robochart::{}({}{})", is_tracked() ? "place_of_value" : "set_values.place",
                               tracked_number(id), number_arguments(id, value));
        return is_composed(generation_.system.type(id))
                   ? fmt::format("robochart::place_in({}, {})", table_name(id), value)
                   : fmt::format("robochart::to_raw({})", value);
    }

    /// Writes the functions of the model. They may have any value that the semantics allows; the default value is one
    /// of these (semantics 3.13).
    void functions_of_the_model() {
        for (const FunctionHook& hook : generation_.component.functions) {
            const ir::Function& function = generation_.system.functions[hook.id.index];
            std::string parameters;
            for (std::size_t i = 0; i < function.parameters.size(); ++i)
                parameters +=
                    fmt::format("{}[[maybe_unused]] {} a{}", i == 0 ? "" : ", ", type_text(function.parameters[i]), i);
            const auto text = [&](ir::TypeId id, const ir::Value& value) {
                return cpp_value(generation_.system, generation_.inst, id, value, spelling());
            };
            out_.open(fmt::format("{} {}({}) const noexcept {{", type_text(function.result), hook.method, parameters));
            ir::Value otherwise = ir::default_value(generation_.system, generation_.inst, function.result);
            for (const FunctionValue& row : values_of(generation_.system, generation_.inst, hook.id)) {
                if (row.arguments.empty()) {  // there is only one value
                    otherwise = row.result;
                    break;
                }
                std::vector<std::string> equal;
                for (std::size_t i = 0; i < row.arguments.size(); ++i)
                    equal.push_back(fmt::format("a{} == {}", i, text(function.parameters[i], row.arguments[i])));
                out_.line(
                    fmt::format("if ({}) return {};", fmt::join(equal, " && "), text(function.result, row.result)));
            }
            out_.line(fmt::format("return {};", text(function.result, otherwise)));
            out_.close();
        }
    }

    void log_class() {
        out_.open_declaration("The platform of the exploration: writes down what the controller does.", "class Log {");
        out_.write_label("public:");
        out_.line("explicit Log(::rc_log& log) noexcept : log_(log) {}");
        out_.gap();
        for (std::size_t index = 0; index < outputs_.size(); ++index) {
            std::string parameters, arguments;
            for (std::size_t i = 0; i < outputs_[index].types.size(); ++i) {
                parameters += fmt::format("{}{} a{}", i == 0 ? "" : ", ", type_text(outputs_[index].types[i]), i);
                arguments += ", " + as_number(outputs_[index].types[i], fmt::format("a{}", i));
            }
            out_.line(fmt::format("void {}({}) noexcept {{ robochart::write_record(log_, {}{}); }}",
                                  outputs_[index].method, parameters, index, arguments));
        }
        functions_of_the_model();
        if (generation_.component.probabilistic)
            out_.line(
                "std::size_t choose(const double*, std::size_t count) noexcept { return "
                "robochart::recorded_way(log_, count); }");
        if (generation_.options.choices)
            out_.line("std::size_t pick(std::size_t count) noexcept { return robochart::recorded_way(log_, count); }");
        for (const ModelledCall& call : generation_.component.modelled) {
            std::string parameters;
            for (const ir::TypeId parameter : call.signature->parameters)
                parameters += (parameters.empty() ? "" : ", ") + type_text(parameter);
            out_.line(fmt::format("bool {}({}) noexcept {{ return false; }}", call.method, parameters));
        }
        out_.gap();
        out_.write_label("private:");
        out_.line("[[maybe_unused]] ::rc_log& log_;");
        out_.close("};");
    }

    void write_functions() {
        out_.gap();
        out_.open("void write_initial(void* state) noexcept {");
        out_.line("const State initial{};");
        out_.line("std::memcpy(state, &initial, sizeof initial);");
        out_.close();
        out_.gap();
        out_.open("Inputs read_inputs([[maybe_unused]] const rc_register* registers) noexcept {");
        out_.line("Inputs read;");
        for (std::size_t index = 0; index < registers_.size(); ++index) {
            const Register& input = registers_[index];
            out_.line(fmt::format("read.{}.present = registers[{}].present != 0;", input.member, index));
            if (input.type)
                out_.line(fmt::format("read.{}.value = {};", input.member,
                                      input_value(input, fmt::format("registers[{}].value", index))));
        }
        out_.line("return read;");
        out_.close();
        out_.gap();
        out_.open("rc_result step_once(void* state, const rc_register* registers, rc_log* log) noexcept {");
        out_.line("State current;");
        out_.line("robochart::probing = nullptr;  // a call that did not return has left it");
        out_.line("std::memcpy(&current, state, sizeof current);");
        out_.line("robochart::clear(*log);");
        out_.line("Log platform(*log);");
        out_.line("const robochart::StepResult result = core::step(current, read_inputs(registers), platform);");
        out_.line("std::memcpy(state, &current, sizeof current);");
        out_.line("return robochart::to_abi(result);");
        out_.close();
        print_function();
    }

    void print_function() {
        out_.gap();
        out_.open("void print_state(const void* state, char* buffer, std::size_t size) noexcept {");
        out_.line("State current;");
        out_.line("std::memcpy(&current, state, sizeof current);");
        out_.line("robochart::Text text(buffer, size);");
        if (is_tracked()) out_.line("robochart::tracking.paused = true;");
        out_.line("print(text, \"\", current);");
        if (is_tracked()) out_.line("robochart::tracking.paused = false;");
        out_.close();
    }

    /// Writes a cycle that reads its registers on demand. The code clears the bytes of the object first, because the
    /// explorer compares them.
    void probe_function() {
        out_.gap();
        out_.open("Inputs unread_inputs() noexcept {");
        out_.line("Inputs read;");
        for (std::size_t index = 0; index < registers_.size(); ++index) {
            const Register& input = registers_[index];
            out_.line(fmt::format("read.{}.present = robochart::Presence::in_register({});", input.member, index));
            if (!input.type) continue;
            out_.line(fmt::format("read.{0}.value = robochart::Content<{1}>::in_register({2},", input.member,
                                  type_text(*input.type), index));
            out_.line(fmt::format("    [](std::uint32_t place) noexcept -> {} {{ return {}; }});",
                                  type_text(*input.type), input_value(input, "place")));
        }
        out_.line("return read;");
        out_.close();
        out_.gap();
        out_.open("rc_result probe_once(void* state, const rc_probe* probe, rc_log* log) noexcept {");
        out_.line("using Step = core::Step<Checking, Log>;");
        out_.line("robochart::clear(*log);");
        out_.comment(
            "At the same address in each call, because the step contains references to the state and platform.");
        out_.line("alignas(State) static thread_local unsigned char place_of_state[sizeof(State)];");
        out_.line("alignas(Log) static thread_local unsigned char place_of_platform[sizeof(Log)];");
        out_.line("alignas(Step) static thread_local unsigned char place_of_step[sizeof(Step)];");
        out_.line("std::memset(place_of_step, 0, sizeof place_of_step);");
        out_.line("auto* const current = new (place_of_state) State;");
        out_.line("std::memcpy(current, state, sizeof *current);");
        out_.line("auto* const platform = new (place_of_platform) Log(*log);");
        out_.line("const Inputs read = unread_inputs();");
        out_.line("auto* const step = new (place_of_step) Step(*current, read, *platform);");
        out_.line("const robochart::Probing probing{probe, step, sizeof(Step), current};");
        out_.line("robochart::probing = &probing;");
        out_.line("const robochart::StepResult result = step->cycle();");
        out_.line("robochart::probing = nullptr;");
        out_.line("std::memcpy(state, current, sizeof *current);");
        out_.line("return robochart::to_abi(result);");
        out_.close();
    }

    /// Writes the functions for the event API, if the component has one.
    void event_functions() {
        const std::size_t events = input_events(generation_.component).size();
        if (events == 0) return;
        out_.gap();
        out_.open(
            "rc_result dispatch_once(void* state, std::uint32_t event, const rc_register* registers, rc_log* log) "
            "noexcept {");
        out_.line("robochart::probing = nullptr;");
        out_.line("State current;");
        out_.line("std::memcpy(&current, state, sizeof current);");
        out_.line("robochart::clear(*log);");
        out_.line("Log platform(*log);");
        out_.line(
            fmt::format("const robochart::StepResult result = event == {} ? core::begin(current, platform)", events));
        out_.line(
            fmt::format("    : core::dispatch(current, static_cast<core::{}>(event), read_inputs(registers), "
                        "platform);",
                        event_type(generation_)));
        out_.line("std::memcpy(state, &current, sizeof current);");
        out_.line("return robochart::to_abi(result);");
        out_.close();
        out_.gap();
        out_.open("rc_result pass_once(void* state, rc_log* log) noexcept {");
        out_.line("robochart::probing = nullptr;");
        out_.line("State current;");
        out_.line("std::memcpy(&current, state, sizeof current);");
        out_.line("Log platform(*log);");
        out_.line("const robochart::StepResult result = core::pass(current, platform);");
        out_.line("std::memcpy(state, &current, sizeof current);");
        out_.line("return robochart::to_abi(result);");
        out_.close();
    }

    /// Writes the types of numbers at the boundary, and the functions that report what the code did with their values.
    void tracking_table() {
        std::vector<std::size_t> parts;
        for (const ir::TypeId type : tracked_) parts.push_back(ir::number_parts(generation_.system, type).size());
        std::vector<std::int64_t> inputs;
        for (const Register& input : registers_) {
            const bool tracked = input.type && is_tracked(*input.type);
            inputs.push_back(tracked ? static_cast<std::int64_t>(tracked_number(*input.type)) : -1);
        }
        out_.gap();
        out_.line(fmt::format("constexpr std::uint32_t tracked_parts[] = {{{}}};", fmt::join(parts, ", ")));
        out_.line(fmt::format("constexpr std::int32_t tracked_inputs[] = {{{}}};",
                              inputs.empty() ? "-1" : fmt::format("{}", fmt::join(inputs, ", "))));
        deployed_table();
        out_.gap();
        out_.open("constexpr rc_tracking tracked = {");
        out_.line(fmt::format("{}, tracked_parts, tracked_inputs,", tracked_.size()));
        out_.line("[](std::uint32_t type, std::uint32_t count, const std::int64_t* numbers) -> std::uint32_t {");
        if (tracks_sequences(generation_))
            out_.line(
                "    if (tracked_parts[type] == 0) return robochart::tracking.set_sequences(type, count, numbers) ? 1 "
                ": 0;");
        out_.line("    return robochart::tracking.set_values(type, tracked_parts[type], count, numbers) ? 1 : 0;");
        out_.line("},");
        out_.line("[](const rc_comparison** list) -> std::uint32_t { return robochart::tracking.comparisons(list); },");
        out_.line("[]() -> std::uint32_t { return robochart::tracking.losses(); },");
        out_.line("[](const rc_window** list) -> std::uint32_t { return robochart::tracking.windows(list); },");
        out_.line("&deployed_code,");
        out_.close("};");
    }

    /// Writes the same functions over the types of deployment. They have their own types, because the inputs of other
    /// sources do not record when they are read.
    void write_deployed() {
        numbers_ = Numbers::deployed;
        out_.gap();
        out_.line("namespace deployed {");
        out_.gap();
        out_.line(
            fmt::format("struct Checking : robochart::Deployment {{ [[maybe_unused]] static constexpr std::size_t "
                        "longest = {}; }};",
                        std::max(usual_capacity, generation_.options.tracked_length)));
        type_names();
        out_.gap();
        out_.line("static_assert(std::is_trivially_copyable_v<State>);");
        value_tables();
        out_.gap();
        log_class();
        printers_.write(out_, numbers_);
        write_functions();
        out_.gap();
        out_.open("std::uint32_t states_equal(const void* state, const void* other) noexcept {");
        out_.line("State a, b;");
        out_.line("std::memcpy(&a, state, sizeof a);");
        out_.line("std::memcpy(&b, other, sizeof b);");
        out_.line("return std::memcmp(state, other, sizeof(State)) == 0 || a == b ? 1 : 0;");
        out_.close();
        out_.gap();
        std::vector<std::string> capacities;
        for (const ir::TypeId type : tracked_)
            capacities.push_back(ir::is_number_sequence(generation_.system, type) ? type_text(type) + "::most" : "0");
        out_.line(fmt::format("constexpr std::uint32_t capacities[] = {{{}}};", fmt::join(capacities, ", ")));
        out_.gap();
        out_.line("}  // namespace deployed");
        numbers_ = Numbers::tracked;
    }

    /// Writes the table of these functions.
    void deployed_table() {
        out_.gap();
        out_.open("constexpr rc_deployed deployed_code = {");
        out_.line("sizeof(deployed::State), deployed::capacities,");
        out_.line("[](std::uint32_t type, std::uint32_t count, const std::int64_t* numbers) {");
        out_.line("    robochart::set_values.set(type, tracked_parts[type], count, numbers);");
        out_.line("},");
        out_.line("deployed::write_initial, deployed::step_once, deployed::states_equal, deployed::print_state,");
        out_.close("};");
    }

    void interface_table() {
        if (is_tracked()) tracking_table();
        out_.gap();
        out_.open("constexpr rc_interface interface = {");
        out_.line("ROBOCHART_ABI_VERSION,");
        out_.line(fmt::format("\"{}\",", generation_.component.name));
        out_.line("sizeof(State),");
        out_.line(fmt::format("{}, inputs,", registers_.size()));
        out_.line(fmt::format("{}, outputs,", outputs_.size()));
        out_.line(fmt::format("{},", generation_.inst.scale));
        out_.line("write_initial,");
        out_.line("step_once,");
        out_.line("print_state,");
        const std::size_t events = input_events(generation_.component).size();
        out_.line(events == 0 ? "0, nullptr, nullptr," : fmt::format("{}, dispatch_once, pass_once,", events));
        out_.line(probed() ? "probe_once," : "nullptr,");
        out_.line(is_tracked() ? "&tracked," : "nullptr,");
        out_.close("};");
        out_.gap();
        out_.line("}  // namespace");
        out_.gap();
        out_.open("extern \"C\" const rc_interface* robochart_explore(void) {");
        out_.line("return &interface;");
        out_.close();
    }

    /// Returns whether registers can be read on demand. Registers are numbered with 16 bits there.
    [[nodiscard]] bool probed() const { return !registers_.empty() && registers_.size() <= UINT16_MAX; }

    const Generation& generation_;
    const Core& core_;
    std::vector<Register> registers_;
    std::vector<Output> outputs_;
    Numbers numbers_ = Numbers::finite;
    std::vector<ir::TypeId> tracked_;  ///< empty: numbers have carriers
    StatePrinters printers_;
    CodeWriter out_;
};

}  // namespace

bool tracks_sequences(const Generation& generation) {
    if (generation.options.tracked_scale == 0) return false;
    return std::ranges::any_of(tracked_types(generation.system, generation.component),
                               [&](ir::TypeId type) { return ir::is_number_sequence(generation.system, type); });
}

std::string shim_source(const Generation& generation, const Core& core) {
    return ShimWriter(generation, core).write();
}

}  // namespace robochart::cpp_emit
