// SPDX-License-Identifier: Apache-2.0
// Writes robot.hpp of the projects for simulators. A model does not define where its events come from and what its
// operations do, so the author completes this file. As generated, it raises no events and prints the controller's
// outputs.
#include <fmt/format.h>

#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/project.hpp"

namespace robochart::cpp_emit {

namespace {

class RobotWriter {
public:
    RobotWriter(const Generation& generation, const Core& core, const ClassApi& api, std::string act)
        : generation_(generation), core_(core), api_(api), act_(std::move(act)) {}

    std::string write() {
        out_.comment(fmt::format("A robot with the controller of the RoboChart {} ", generation_.component.kind) +
                     generation_.place_text(generation_.component.origin) +
                     ": which sensors raise its events, what its operations and variables do.");
        out_.comment("This file is yours: robochart-verify made it and leaves it alone where it is there.");
        out_.line("#pragma once");
        out_.gap();
        out_.line("#include <iostream>");
        out_.line("#include <type_traits>");
        out_.gap();
        out_.line("#include \"body.hpp\"");
        out_.line(fmt::format("#include \"{}.hpp\"", api_.cpp_name));
        out_.gap();
        tell_function();
        out_.gap();
        robot_class();
        return out_.text();
    }

private:
    void tell_function() {
        out_.doc("Writes what a robot does, with the values that have a text.");
        out_.line("template <class... Values>");
        out_.open("void tell(const Body& body, const char* what, const Values&... values) {");
        out_.line("std::cout << \"robot \" << body.number() << \": \" << what;");
        out_.line("[[maybe_unused]] const auto one = [](const auto& value) {");
        out_.line("    using Value = std::decay_t<decltype(value)>;");
        out_.line("    if constexpr (std::is_arithmetic_v<Value>) std::cout << ' ' << value;");
        out_.line("    if constexpr (std::is_enum_v<Value>) std::cout << ' ' << static_cast<int>(value);");
        out_.line("};");
        out_.line("(one(values), ...);");
        out_.line("std::cout << '\\n';");
        out_.close();
    }

    void robot_class() {
        out_.open(fmt::format("class Robot final : public ::{}::{} {{", api_.name_space, api_.cpp_name));
        out_.write_label("public:");
        out_.line("explicit Robot(Body& body) : robot_body_(body) {}");
        out_.gap();
        write_events();
        write_variables();
        each_class(api_, [&](const ApiClass& part) {
            for (const ApiOperation& operation : part.operations)
                if (!operation.modelled) write_call(operation);
        });
        out_.gap();
        out_.write_label("private:");
        out_.line("Body& robot_body_;");
        out_.close("};");
    }

    void write_events() {
        out_.doc("Before a control cycle: raise the events that the sensors report. It lowers them again.");
        out_.open("void CheckInEvent() override {");
        each_class(api_, [&](const ApiClass& part) {
            for (const ApiEvent& event : part.events) {
                if (event.sent) continue;
                const std::string value =
                    event.port->type ? fmt::format(" {} = ...; (a {})", event.value, type_text(*event.port->type)) : "";
                out_.comment(fmt::format("event {}: {} = ...;{}", event.port->model_name, event.flag, value));
            }
        });
        out_.close();
        out_.gap();
    }

    void write_variables() {
        out_.doc(
            "After a control cycle: what the controller has made of the variables that it shares, and what it sent.");
        out_.open(fmt::format("void {}() {{", act_));
        each_class(api_, [&](const ApiClass& part) {
            for (const ApiVariable& variable : part.variables)
                if (variable.stored->visible)
                    out_.comment("variable " + generation_.place_text(variable.stored->variable->origin) + ": " +
                                 variable.member);
            for (const ApiEvent& event : part.events) {
                if (!event.sent) continue;
                out_.line(fmt::format("if ({}) tell(robot_body_, \"{}\"{});", event.flag, event.port->model_name,
                                      event.port->type ? ", " + event.value : ""));
            }
        });
        out_.close();
    }

    void write_call(const ApiOperation& operation) {
        std::string parameters, values;
        const auto& signature = *operation.signature;
        const std::vector<std::string> names = parameter_identifiers(signature.parameter_names);
        for (std::size_t i = 0; i < signature.parameters.size(); ++i) {
            const std::string name = free_member(api_, names.at(i));
            parameters += fmt::format("{}{} {}", i == 0 ? "" : ", ", type_text(signature.parameters[i]), name);
            values += ", " + name;
        }
        out_.gap();
        out_.doc(generation_.place_text(signature.origin));
        out_.line(fmt::format("void {}({}) override {{ tell(robot_body_, \"{}\"{}); }}", operation.method, parameters,
                              signature.name, values));
    }

    [[nodiscard]] std::string type_text(ir::TypeId id) const {
        return deployed_type(generation_, "::" + core_.name_space, id);
    }

    const Generation& generation_;
    const Core& core_;
    const ClassApi& api_;
    std::string act_;
    CodeWriter out_;
};

}  // namespace

OutputFile robot_file(const Generation& generation, const Core& core, const ClassApi& api, const std::string& act) {
    return {"robot.hpp", RobotWriter(generation, core, api, act).write(), true};
}

}  // namespace robochart::cpp_emit
