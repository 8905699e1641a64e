// SPDX-License-Identifier: Apache-2.0
// Writes NAME_trace.hpp: the transitions of a controller by number, and its cycles in the form of a log
// (docs/traces.md). The design follows the trace hook of etcd's raft: the metadata and the hook are compiled only on
// request.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <iterator>

#include "cpp_emit/code/transition_numbers.hpp"
#include "cpp_emit/files/files.hpp"
#include "cpp_emit/files/open_constants.hpp"
#include "cpp_emit/files/trace_names.hpp"
#include "cpp_emit/plan/exploration_ports.hpp"
#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

using diagnostics::cpp_string;

namespace {

template <class Port>
std::vector<std::string> port_words(const std::vector<Port>& ports) {
    std::vector<std::string> names;
    for (const Port& port : ports) names.push_back(port.name);
    return trace_names(names);
}

class TraceHeaderWriter {
public:
    TraceHeaderWriter(const Generation& generation, const Core& core)
        : generation_(generation),
          core_(core),
          registers_(exploration_registers(generation.component)),
          outputs_(exploration_outputs(generation.component)),
          inputs_(port_words(registers_)),
          outputs_named_(port_words(outputs_)) {}

    std::string write() {
        file_comment(generation_, out_, "Trace hook");
        out_.line("#pragma once");
        out_.gap();
        out_.line(fmt::format("#include \"{}\"", core_.header));
        out_.line("#include \"robochart/trace.hpp\"");
        out_.gap();
        out_.line(fmt::format("namespace {} {{", core_.name_space));
        out_.gap();
        transition_table();
        run_header();
        declared_values();
        platform_class();
        traced_step();
        outside_writes();
        out_.gap();
        out_.line(fmt::format("}}  // namespace {}", core_.name_space));
        return out_.text();
    }

private:
    void transition_table() {
        assert(inputs_.size() == registers_.size() && outputs_named_.size() == outputs_.size());
        const std::vector<TransitionName> names = transition_names(generation_);
        transitions_ = names.size();
        out_.doc("The transitions by number, the argument of the platform's method `taken`.");
        if (names.empty()) return out_.line("inline constexpr const robochart::TransitionName* transitions = nullptr;");
        out_.open("inline constexpr robochart::TransitionName transitions[] = {");
        for (const TransitionName& name : names)
            out_.line(fmt::format("{{{}, {}}},", cpp_string(name.element), cpp_string(name.place)));
        out_.close("};");
    }

    void run_header() {
        const Component& component = generation_.component;
        const std::string& package = component.package;
        out_.gap();
        out_.doc("What its logs begin with.");
        out_.line(fmt::format(
            "inline constexpr robochart::RunHeader run_header = {{{}, {}, {}, cycle_length, transitions, {}}};",
            cpp_string(package.empty() ? component.ref.path : package + "::" + component.ref.path),
            cpp_string(diagnostics::escape_for_display(generation_.file_text(component.origin.span))),
            cpp_string(constant_lines()), transitions_));
    }

    /// Returns lines for the constants whose values the code contains. A log is therefore a log of the model with these
    /// values.
    [[nodiscard]] std::string constant_lines() const {
        std::string lines;
        for (const OpenConstant& constant : open_constants(generation_))
            lines += fmt::format("const {}={}\n", constant.path, constant.literal);
        return lines;
    }

    /// Writes functions that print values of the declared types with the names of the model.
    void declared_values() {
        for (const ir::TypeId id : generation_.component.enumerations) {
            const ir::Type& type = generation_.system.type(id);
            out_.gap();
            if (is_struct(type)) out_.line("template <class Types>");
            out_.open(fmt::format("[[maybe_unused]] {}void log_value(robochart::Tracer& tracer, {} value) noexcept {{",
                                  is_struct(type) ? "" : "inline ", parameter_type(id)));
            if (type.kind == ir::TypeKind::given) {
                out_.line("robochart::log_value(tracer, static_cast<std::int64_t>(value));");
            } else if (type.kind == ir::TypeKind::enumeration) {
                write_literals(id);
            } else {
                member_values(type_members(type));
            }
            out_.close();
        }
    }

    [[nodiscard]] std::string parameter_type(ir::TypeId id) const {
        const std::string name = cpp_type(generation_.system, id);
        return is_struct(generation_.system.type(id)) ? fmt::format("const {}&", name) : name;
    }

    void write_literals(ir::TypeId id) {
        const ir::Type& type = generation_.system.type(id);
        const bool parts = is_struct(type);
        const std::string scope = cpp_type(generation_.system, id) + (parts ? "::Kind" : "");
        const std::vector<TypeMember> all = type_members(type);
        out_.open(parts ? "switch (value.kind) {" : "switch (value) {");
        for (std::size_t literal = 0; literal < type.labels.size(); ++literal) {
            std::vector<TypeMember> given;
            std::ranges::copy_if(all, std::back_inserter(given),
                                 [&](const TypeMember& member) { return member.literal == literal; });
            const std::string label = fmt::format("case {}::{}:", scope, literal_name(type, literal));
            const std::string word = cpp_string(type.labels[literal]);
            if (given.empty()) {
                out_.line(fmt::format("{} return tracer.text({});", label, word));
                continue;
            }
            out_.open(label + " {");
            out_.line(fmt::format("tracer.text({});", word));
            member_values(given, true);
            out_.line("return;");
            out_.close();
        }
        out_.close();
    }

    /// Writes code that prints a value's members as "(1,2)". A single member has no parentheses unless it belongs to a
    /// literal.
    void member_values(const std::vector<TypeMember>& parts, bool of_literal = false) {
        const bool brackets = of_literal || parts.size() > 1;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (i > 0 || brackets) out_.line(fmt::format("tracer.text(\"{}\");", i == 0 ? "(" : ","));
            say_value("tracer", parts[i].type, "value." + parts[i].name);
        }
        if (brackets) out_.line("tracer.text(\")\");");
    }

    void say_value(const std::string& tracer, ir::TypeId id, const std::string& value) {
        const bool own = is_declared(generation_.system.type(id));
        out_.line(fmt::format("{}log_value({}, {});", own ? "" : "robochart::", tracer, value));
    }

    void say_output(const Output& output, const std::string& word) {
        if (output.types.empty()) return out_.line(fmt::format("tracer_.text({});", cpp_string(word + "! ")));
        for (std::size_t i = 0; i < output.types.size(); ++i) {
            out_.line(fmt::format("tracer_.text({});", cpp_string(i == 0 ? word + "!" : "!")));
            say_value("tracer_", output.types[i], fmt::format("a{}", i));
        }
        out_.line("tracer_.text(\" \");");
    }

    static std::string join_parts(const std::vector<std::string>& parts) {
        return fmt::format("{}", fmt::join(parts, ", "));
    }

    [[nodiscard]] std::string typed_parameters(const std::vector<ir::TypeId>& types) const {
        std::vector<std::string> parts;
        for (std::size_t i = 0; i < types.size(); ++i)
            parts.push_back(fmt::format("{} a{}", cpp_type(generation_.system, types[i]), i));
        return join_parts(parts);
    }
    static std::string argument_list(std::size_t count) {
        std::vector<std::string> parts;
        for (std::size_t i = 0; i < count; ++i) parts.push_back(fmt::format("a{}", i));
        return join_parts(parts);
    }

    /// Writes a method that forwards its call to the platform.
    void write_forwarder(const std::string& result, const std::string& method, const std::vector<ir::TypeId>& types) {
        out_.line(fmt::format("{} {}({}) noexcept {{ return platform_.{}({}); }}", result, method,
                              typed_parameters(types), method, argument_list(types.size())));
    }

    void platform_class() {
        out_.gap();
        out_.doc("A platform that tells a tracer what the controller does, and has another do it.");
        out_.line("template <class Types, class Platform>");
        out_.open("class Traced {");
        out_.write_label("public:");
        for (const char* name : {"Real", "Nat", "Int"})
            out_.line(fmt::format("using {0} = typename Types::{0};", name));
        out_.gap();
        out_.line(
            "Traced(Platform& platform, robochart::Tracer& tracer) noexcept "
            ": platform_(platform), tracer_(tracer) {}");
        out_.gap();
        for (std::size_t o = 0; o < outputs_.size(); ++o) {
            const Output& output = outputs_[o];
            out_.open(fmt::format("void {}({}) noexcept {{", output.method, typed_parameters(output.types)));
            say_output(output, outputs_named_[o]);
            out_.line(fmt::format("platform_.{}({});", output.method, argument_list(output.types.size())));
            out_.close();
        }
        const Component& component = generation_.component;
        for (const ModelledCall& call : component.modelled)
            write_forwarder("bool", call.method, call.signature->parameters);
        for (const FunctionHook& hook : component.functions) {
            const ir::Function& function = generation_.system.functions[hook.id.index];
            write_forwarder(cpp_type(generation_.system, function.result), hook.method, function.parameters);
        }
        if (component.probabilistic) {
            out_.open("std::size_t choose(const double* chances, std::size_t count) noexcept {");
            out_.line("return robochart::passed_choice(platform_, chances, count);");
            out_.close();
        }
        if (generation_.options.choices)
            out_.line(
                "std::size_t pick(std::size_t count) noexcept { return robochart::passed_pick(platform_, count); }");
        out_.open("void taken(std::uint32_t transition) noexcept {");
        out_.line("tracer_.taken(transition);");
        out_.line("if constexpr (robochart::Listens<Platform>::value) platform_.taken(transition);");
        out_.close();
        out_.gap();
        out_.write_label("private:");
        out_.line("[[maybe_unused]] Platform& platform_;");
        out_.line("robochart::Tracer& tracer_;");
        out_.close("};");
    }

    void traced_step() {
        out_.gap();
        out_.doc("One control cycle reported to a tracer: what is read, what is done, how it ends.");
        out_.line("template <class Types, class Platform>");
        out_.line(
            "robochart::StepResult traced_step(State<Types>& state, const Inputs<Types>& inputs, "
            "Platform& platform,");
        out_.open("                                  robochart::Tracer& tracer) noexcept {");
        for (std::size_t i = 0; i < registers_.size(); ++i) {
            const Register& input = registers_[i];
            if (!input.type) {
                out_.line(fmt::format("if (inputs.{}.present) tracer.text({});", input.member,
                                      cpp_string(inputs_[i] + "? ")));
                continue;
            }
            out_.open(fmt::format("if (inputs.{}.present) {{", input.member));
            out_.line(fmt::format("tracer.text({});", cpp_string(inputs_[i] + "?")));
            say_value("tracer", *input.type, fmt::format("inputs.{}.value", input.member));
            out_.line("tracer.text(\" \");");
            out_.close();
        }
        out_.line("Traced<Types, Platform> traced(platform, tracer);");
        out_.line("const robochart::StepResult result = step<Types>(state, inputs, traced);");
        out_.line("robochart::log_end(tracer, result, cycle_length);");
        out_.line("return result;");
        out_.close();
    }

    /// Writes the outside writes. In the classes, variables that others write are members, not inputs.
    void outside_writes() {
        for (const StoredVariable& variable : generation_.component.variables) {
            if (variable.input.empty() || variable.copy) continue;
            out_.gap();
            out_.doc(fmt::format("Others have written {} since the last cycle, if it is not what the controller knows.",
                                 variable.name()));
            out_.line("template <class Types, class Value>");
            out_.open(
                fmt::format("void log_write_of_{}([[maybe_unused]] robochart::Tracer& tracer, "
                            "[[maybe_unused]] const State<Types>& state,",
                            variable.input));
            out_.line("    [[maybe_unused]] const Value& value) noexcept {");
            outside_write(variable);
            out_.close();
        }
    }

    void outside_write(const StoredVariable& variable) {
        std::vector<std::string> known;
        for (const StoredVariable& stored : generation_.component.variables)
            if (stored.input == variable.input && stored.has_member())
                known.push_back("state." + stored.path + " == value");
        if (!known.empty()) out_.line(fmt::format("if ({}) return;", fmt::join(known, " && ")));
        for (std::size_t i = 0; i < registers_.size(); ++i)
            if (registers_[i].member == variable.input)
                out_.line(fmt::format("tracer.text({});", cpp_string(inputs_[i] + "?")));
        say_value("tracer", variable.variable->type, "value");
        out_.line("tracer.text(\" \");");
    }

    const Generation& generation_;
    const Core& core_;
    std::vector<Register> registers_;
    std::vector<Output> outputs_;
    std::vector<std::string> inputs_, outputs_named_;
    std::size_t transitions_ = 0;
    CodeWriter out_;
};

}  // namespace

std::string trace_header(const Generation& generation, const Core& core) {
    return TraceHeaderWriter(generation, core).write();
}

std::string trace_header_name(const Generation& generation) {
    return generation.component.cpp_name + "_trace.hpp";
}

}  // namespace robochart::cpp_emit
