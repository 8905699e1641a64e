// SPDX-License-Identifier: Apache-2.0
// Writes module.cpp and robot.py of `--target python`. projects/python/python_values.hpp converts most values. This
// file writes the conversions for types that the model declares.
#include "cpp_emit/api/python_module.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

namespace {

using diagnostics::cpp_string;

/// The keywords of Python 3, which cannot be names of attributes (The Python Language Reference, 2.3.1).
constexpr std::array python_keywords{
    "False",  "None",     "True", "and",    "as",   "assert",  "async",  "await",  "break", "class",  "continue", "def",
    "del",    "elif",     "else", "except", "for",  "finally", "from",   "global", "if",    "import", "in",       "is",
    "lambda", "nonlocal", "not",  "or",     "pass", "raise",   "return", "try",    "while", "with",   "yield"};

bool is_keyword(const std::string& name) {
    return std::ranges::find(python_keywords, name) != python_keywords.end();
}

/// Returns the name for Python. Adds underscores to a keyword until the name is not in `taken`.
std::string python_name(std::string name, const std::set<std::string>& taken) {
    if (!is_keyword(name)) return name;
    do name += '_';
    while (taken.contains(name));
    return name;
}

std::string class_in_module(const ClassApi& api) {
    return python_name(api.cpp_name, {"StepResult"});
}

/// The Python names of the members of a controller.
class MemberNames {
public:
    explicit MemberNames(const ClassApi& api) {
        each_class(api, [&](const ApiClass& part) {
            for (const ApiVariable& variable : part.variables) members_.insert(variable.member);
            for (const ApiEvent& event : part.events) members_.insert({event.flag, event.value, event.method});
            for (const ApiOperation& operation : part.operations) members_.insert(operation.method);
        });
        for (const ApiTimer& timer : api.timers) members_.insert(timer.member);
        for (const ApiMachine& machine : api.machines) members_.insert({machine.method, machine.enumeration});
        for (const ApiFunction& function : api.functions) members_.insert(function.method);
    }

    [[nodiscard]] std::string name(const std::string& member) const { return python_name(member, members_); }
    /// The name as a C++ string.
    [[nodiscard]] std::string quoted(const std::string& member) const { return cpp_string(name(member)); }

private:
    std::set<std::string> members_;
};

/// The names of the literals of an enumeration in Python. `name` and `value` are attributes of every literal.
std::vector<std::string> literal_names(const std::vector<std::string>& labels) {
    const std::set<std::string> taken(labels.begin(), labels.end());
    std::vector<std::string> names;
    for (const std::string& label : labels) {
        std::string name = label == "name" || label == "value" ? label + "_" : python_name(label, taken);
        while (name != label && taken.contains(name)) name += '_';
        names.push_back(name);
    }
    return names;
}

class ModuleWriter {
public:
    ModuleWriter(const Generation& generation, const Core& core, const ClassApi& api)
        : generation_(generation),
          core_(core),
          api_(api),
          base_(fmt::format("::{}::{}", api.name_space, api.cpp_name)),
          members_(api) {
        taken_ = {class_in_module(api), "StepResult"};
    }

    std::string write() {
        file_comment(generation_, out_, "Module of Python with the controller");
        out_.line("#include <pybind11/stl.h>");
        out_.gap();
        out_.line("#include <memory>");
        out_.line("#include <string>");
        out_.gap();
        out_.line(fmt::format("#include \"{}.hpp\"", api_.cpp_name));
        out_.line("#include \"python_values.hpp\"");
        out_.line("#if ROBOCHART_TRACE");
        out_.line("#include \"robochart/trace_file.hpp\"");
        out_.line("#endif");
        out_.gap();
        out_.line("namespace {");
        out_.gap();
        out_.line("namespace py = pybind11;");
        out_.gap();
        for (const ir::TypeId id : generation_.component.enumerations) write_converter(id);
        write_controller();
        out_.line("}  // namespace");
        out_.gap();
        write_registration();
        return out_.text();
    }

private:
    [[nodiscard]] const ir::Type& type(ir::TypeId id) const { return generation_.system.type(id); }
    [[nodiscard]] std::string cpp_name(ir::TypeId id) const {
        return deployed_type(generation_, "::" + core_.name_space, id);
    }

    /// Returns the name of a declared type in the module.
    const std::string& name_in_module(ir::TypeId id) {
        std::string& name = names_[id.index];
        if (name.empty()) {
            name = python_name(declared_name(type(id)), taken_);
            while (!taken_.insert(name).second) name += '_';
        }
        return name;
    }

    /// Returns the struct that converts values of the type.
    [[nodiscard]] std::string converter(ir::TypeId id) const {
        const ir::Type& of = type(id);
        const std::string name = cpp_name(id);
        switch (of.kind) {
            case ir::TypeKind::boolean:
                return "::robochart::python::Bool";
            case ir::TypeKind::nat:
                return "::robochart::python::Nat";
            case ir::TypeKind::integer:
                return "::robochart::python::Int";
            case ir::TypeKind::real:
                return "::robochart::python::Real";
            case ir::TypeKind::string:
                return fmt::format("::robochart::python::Text<{}, {}>", name, longest_string);
            case ir::TypeKind::given:
                return fmt::format("::robochart::python::Given<{}>", name);
            case ir::TypeKind::enumeration:
                if (!is_struct(of)) return fmt::format("::robochart::python::Literal<{}>", name);
                break;
            case ir::TypeKind::sequence:
                return fmt::format("::robochart::python::Sequence<{}, {}>", converter(of.args.at(0)), name);
            case ir::TypeKind::set:
                return fmt::format("::robochart::python::Set<{}, {}>", converter(of.args.at(0)), name);
            case ir::TypeKind::function:
            case ir::TypeKind::relation:
                return fmt::format(
                    "::robochart::python::Set<::robochart::python::PairOf<{}, {}, typename {}::value_type>, {}>",
                    converter(of.args.at(0)), converter(of.args.at(1)), name, name);
            case ir::TypeKind::vector:
                return fmt::format("::robochart::python::Column<{}, {}>", converter(of.args.at(0)), name);
            case ir::TypeKind::matrix:
                return fmt::format("::robochart::python::Rows<{}, {}>", converter(of.args.at(0)), name);
            case ir::TypeKind::product:
            case ir::TypeKind::record:
            case ir::TypeKind::unit:
                break;
        }
        return fmt::format("::ValueOf{}", id.index);
    }

    void write_converter(ir::TypeId id) {
        const ir::Type& of = type(id);
        if (!is_struct(of)) return;
        out_.doc(fmt::format("Values of the type {}.", of.name));
        out_.open(fmt::format("struct ValueOf{} {{", id.index));
        out_.line(fmt::format("using Type = {};", cpp_name(id)));
        if (of.kind == ir::TypeKind::enumeration) {
            write_literals(of);
        } else {
            write_record(id, of);
        }
        out_.close("};");
        out_.gap();
    }

    /// Writes literals. Python represents a literal with arguments as a tuple of its name and its arguments.
    void write_literals(const ir::Type& of) {
        const std::vector<TypeMember> all = type_members(of);
        out_.open("static Type from(py::handle given) {");
        out_.line(fmt::format(
            "if (!py::isinstance<py::tuple>(given) || py::len(given) == 0) ::robochart::python::refuse({}, given);",
            cpp_string("a literal of " + of.name + " as a tuple")));
        out_.line("const auto parts = py::reinterpret_borrow<py::tuple>(given);");
        out_.line("const std::string name = py::str(parts[0]);");
        out_.line("Type value{};");
        for (std::size_t literal = 0; literal < of.labels.size(); ++literal) {
            out_.open(fmt::format("if (name == {}) {{", cpp_string(of.labels[literal])));
            out_.line(fmt::format("::robochart::python::parts_of(given, {}, {});", of.literal_args[literal].size() + 1,
                                  cpp_string("the literal " + of.labels[literal] + " with its arguments")));
            out_.line(fmt::format("value.kind = Type::Kind::{};", literal_name(of, literal)));
            std::size_t place = 1;
            for (const TypeMember& member : all)
                if (member.literal == literal)
                    out_.line(
                        fmt::format("value.{} = {}::from(parts[{}]);", member.name, converter(member.type), place++));
            out_.line("return value;");
            out_.close();
        }
        out_.line(fmt::format("::robochart::python::refuse({}, given);", cpp_string("a literal of " + of.name)));
        out_.close();
        out_.open("static py::object to(const Type& value) {");
        for (std::size_t literal = 0; literal < of.labels.size(); ++literal) {
            std::string parts;
            for (const TypeMember& member : all)
                if (member.literal == literal)
                    parts += fmt::format(", {}::to(value.{})", converter(member.type), member.name);
            out_.line(fmt::format("if (value.kind == Type::Kind::{}) return py::make_tuple({}{});",
                                  literal_name(of, literal), cpp_string(of.labels[literal]), parts));
        }
        out_.line("return py::none();");
        out_.close();
    }

    /// Writes a record as a named tuple, or a product as a tuple.
    void write_record(ir::TypeId id, const ir::Type& of) {
        const std::vector<TypeMember> members = type_members(of);
        out_.open("static Type from(py::handle given) {");
        out_.line(fmt::format("[[maybe_unused]] const py::tuple parts = ::robochart::python::parts_of(given, {}, {});",
                              members.size(), cpp_string(fmt::format("{} with {} parts", of.name, members.size()))));
        out_.line("Type value{};");
        for (std::size_t i = 0; i < members.size(); ++i)
            out_.line(fmt::format("value.{} = {}::from(parts[{}]);", members[i].name, converter(members[i].type), i));
        out_.line("return value;");
        out_.close();
        std::vector<std::string> parts;
        for (const TypeMember& member : members)
            parts.push_back(fmt::format("{}::to(value.{})", converter(member.type), member.name));
        out_.open("static py::object to([[maybe_unused]] const Type& value) {");
        if (of.kind == ir::TypeKind::record) {
            out_.line(fmt::format("const py::object make = py::module_::import({}).attr({});",
                                  cpp_string(python_module_name(api_)), cpp_string(name_in_module(id))));
            out_.line(fmt::format("return make({});", fmt::join(parts, ", ")));
        } else {
            out_.line(fmt::format("return py::make_tuple({});", fmt::join(parts, ", ")));
        }
        out_.close();
    }

    void write_controller() {
        out_.doc("The controller with methods that Python overrides.");
        out_.open(fmt::format("class PythonController final : public {} {{", base_));
        out_.write_label("public:");
        write_override("void", "CheckInEvent", {}, "");
        each_class(api_, [&](const ApiClass& part) {
            for (const ApiOperation& operation : part.operations)
                write_override(operation.modelled ? "bool" : "void", operation.method, operation.signature->parameters,
                               operation.modelled ? "::robochart::python::Bool" : "", !operation.modelled);
            for (const ApiEvent& event : part.events) {
                if (!event.sent) continue;
                std::vector<ir::TypeId> parameters;
                if (event.port->type) parameters.push_back(*event.port->type);
                write_override("void", event.method, parameters, "");
            }
        });
        for (const ApiFunction& function : api_.functions) {
            const ir::Function& declared = generation_.system.functions[function.hook->id.index];
            write_override(cpp_name(declared.result), function.method, declared.parameters, converter(declared.result));
        }
        if (generation_.component.probabilistic) write_choose();
        if (generation_.options.choices) write_pick();
        out_.gap();
        out_.line("::robochart::python::Calls python_calls;");
        out_.line("#if ROBOCHART_TRACE");
        out_.line("std::unique_ptr<robochart::TraceFile> python_log;");
        out_.line("#endif");
        out_.close("};");
        out_.gap();
    }

    /// Writes a method that calls the method of the Python class. If this class does not define it, the C++ base class
    /// does. `result` converts the value that Python returns.
    void write_override(const std::string& returned, const std::string& method,
                        const std::vector<ir::TypeId>& parameters, const std::string& result, bool needed = false) {
        std::string list, converted, passed;
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const char* const comma = i == 0 ? "" : ", ";
            list += fmt::format("{}{} a{}", comma, cpp_name(parameters[i]), i);
            converted += fmt::format("{}{}::to(a{})", comma, converter(parameters[i]), i);
            passed += fmt::format("{}a{}", comma, i);
        }
        out_.open(fmt::format("{} {}({}) override {{", returned, method, list));
        const std::string usual = needed ? "" : fmt::format("{}::{}({})", base_, method, passed);
        if (!result.empty()) out_.line(fmt::format("auto python_result = {};", usual));
        out_.open("python_calls.call([&] {");
        write_search(method);
        const std::string call = fmt::format("python_method({})", converted);
        if (!result.empty()) {
            out_.line(fmt::format("if (python_method) python_result = {}::from({});", result, call));
        } else if (needed) {
            out_.line(
                fmt::format("if (!python_method) ::robochart::python::refuse_call({});", members_.quoted(method)));
            out_.line(call + ";");
        } else {
            out_.line(fmt::format("if (python_method) {};", call));
        }
        out_.close("});");
        if (!result.empty()) out_.line("return python_result;");
        out_.close();
    }

    void write_search(const std::string& method) {
        out_.line(fmt::format(
            "const ::pybind11::function python_method = ::pybind11::get_override(static_cast<const {}*>(this), {});",
            base_, members_.quoted(method)));
    }

    void write_choose() {
        out_.open("std::size_t choose(const double* chances, std::size_t count) noexcept override {");
        out_.line(fmt::format("std::size_t python_way = {}::choose(chances, count);", base_));
        out_.open("python_calls.call([&] {");
        write_search("choose");
        out_.line("if (!python_method) return;");
        out_.line("::pybind11::tuple python_given(count);");
        out_.line("for (std::size_t i = 0; i < count; ++i) python_given[i] = ::pybind11::float_(chances[i]);");
        out_.line("const std::size_t python_found = ::robochart::python::chosen(python_method(python_given), count);");
        out_.line(
            "if (!(chances[python_found] > 0)) throw ::pybind11::value_error(\"this way has the probability 0\");");
        out_.line("python_way = python_found;");
        out_.close("});");
        out_.line("return python_way;");
        out_.close();
    }

    void write_pick() {
        out_.open("std::size_t pick(std::size_t count) noexcept override {");
        out_.line("std::size_t python_way = 0;");
        out_.open("python_calls.call([&] {");
        write_search("pick");
        out_.line("if (python_method) python_way = ::robochart::python::chosen(python_method(count), count);");
        out_.close("});");
        out_.line("return python_way;");
        out_.close();
    }

    void write_registration() {
        out_.open(fmt::format("PYBIND11_MODULE({}, module) {{", python_module_name(api_)));
        write_types();
        write_results();
        out_.line(fmt::format("using Base = {};", base_));
        out_.line(fmt::format("py::class_<Base, PythonController> controller(module, {}, py::module_local());",
                              cpp_string(class_in_module(api_))));
        for (const ApiMachine& machine : api_.machines) write_states(machine);
        out_.line("controller.def(py::init_alias<>());");
        write_cycle_methods();
        each_class(api_, [&](const ApiClass& part) { write_members(part); });
        for (const ApiTimer& timer : api_.timers)
            out_.line(
                fmt::format("controller.def_property_readonly({}, [](const Base& robot) {{ return "
                            "robot.{}.counter; }});",
                            members_.quoted(timer.member), timer.member));
        write_log();
        out_.close();
    }

    void write_types() {
        for (const ir::TypeId id : generation_.component.enumerations) {
            const ir::Type& of = type(id);
            if (of.kind == ir::TypeKind::record) {
                const std::set<std::string> labels(of.labels.begin(), of.labels.end());
                std::vector<std::string> names;
                for (const std::string& label : of.labels) names.push_back(cpp_string(python_name(label, labels)));
                out_.line(
                    fmt::format("module.attr({0}) = py::module_::import(\"collections\").attr(\"namedtuple\")({0}, "
                                "std::vector<std::string>{{{1}}}, py::arg(\"rename\") = true);",
                                cpp_string(name_in_module(id)), fmt::join(names, ", ")));
                continue;
            }
            if (of.kind != ir::TypeKind::enumeration || is_struct(of)) continue;
            std::vector<std::pair<std::string, std::string>> values;
            for (std::size_t i = 0; i < of.labels.size(); ++i) values.emplace_back(of.labels[i], literal_name(of, i));
            write_enumeration("module", cpp_name(id), name_in_module(id), values);
        }
    }

    void write_enumeration(const char* scope, const std::string& cpp, const std::string& name,
                           const std::vector<std::pair<std::string, std::string>>& values) {
        out_.line(fmt::format("py::enum_<{}>({}, {}, py::module_local())", cpp, scope, cpp_string(name)));
        std::vector<std::string> labels;
        for (const auto& [label, literal] : values) labels.push_back(label);
        const std::vector<std::string> shown = literal_names(labels);
        for (std::size_t i = 0; i < values.size(); ++i)
            out_.line(fmt::format("    .value({}, {}::{})", cpp_string(shown[i]), cpp, values[i].second));
        out_.line("    ;");
    }

    void write_results() {
        std::vector<std::pair<std::string, std::string>> values;
        for (const char* name : {"quiescent", "terminated", "step_bound", "precondition", "deadline", "capacity"})
            values.emplace_back(name, name);
        write_enumeration("module", "robochart::StepResult", "StepResult", values);
    }

    void write_states(const ApiMachine& machine) {
        std::vector<std::pair<std::string, std::string>> values{{"none", "none"}};
        for (const std::string& state : machine.states)
            if (!state.empty()) values.emplace_back(state, state);
        write_enumeration("controller", "Base::" + machine.enumeration, members_.name(machine.enumeration), values);
        out_.line(fmt::format("controller.def({}, [](const Base& robot) {{ return robot.{}(); }});",
                              members_.quoted(machine.method), machine.method));
    }

    void write_cycle_methods() {
        out_.line(
            "const auto python = [](Base& robot) -> PythonController& { return static_cast<PythonController&>(robot); "
            "};");
        out_.open("controller.def(\"step\", [python](Base& robot) {");
        out_.line("const auto result = python(robot).python_calls.run_cycle([&] { return robot.step(); });");
        out_.line("#if ROBOCHART_TRACE");
        out_.line("const auto& log = python(robot).python_log;");
        out_.line("if (log && !log->good()) throw std::runtime_error(\"the log cannot be written\");");
        out_.line("#endif");
        out_.line("return result;");
        out_.close(
            "}, \"One control cycle: reads the raised events, and takes all transitions that they and time "
            "enable.\");");
        out_.open("controller.def(\"reset\", [python](Base& robot) {");
        out_.line("python(robot).python_calls.reset();");
        out_.line("robot.reset();");
        out_.close("}, \"Back to the initial state.\");");
        out_.line("controller.def(\"isFinal\", [](const Base& robot) { return robot.isFinal(); });");
        if (generation_.component.probabilistic)
            out_.line("controller.def(\"SetSeed\", [](Base& robot, std::uint64_t seed) { robot.SetSeed(seed); });");
    }

    void write_members(const ApiClass& part) {
        for (const ApiVariable& variable : part.variables) {
            const std::string values = converter(variable.stored->variable->type);
            out_.line(
                fmt::format("controller.def_property({}, [](const Base& robot) {{ return {}::to(robot.{}); }}, "
                            "[](Base& robot, py::object value) {{ robot.{} = {}::from(value); }});",
                            members_.quoted(variable.member), values, variable.member, variable.member, values));
        }
        for (const ApiEvent& event : part.events) {
            out_.line(fmt::format("controller.def_property_readonly({}, [](const Base& robot) {{ return robot.{}; }});",
                                  members_.quoted(event.flag), event.flag));
            if (event.port->type) write_value(event, converter(*event.port->type));
            if (event.sent) continue;
            out_.line(event.port->type
                          ? fmt::format("controller.def({}, [](Base& robot, py::object value) {{ robot.{}({}::from("
                                        "value)); }});",
                                        members_.quoted(event.method), event.method, converter(*event.port->type))
                          : fmt::format("controller.def({}, [](Base& robot) {{ robot.{}(); }});",
                                        members_.quoted(event.method), event.method));
        }
    }

    void write_value(const ApiEvent& event, const std::string& values) {
        out_.line(
            fmt::format("controller.def_property_readonly({}, [](const Base& robot) {{ return {}::to(robot.{}); }});",
                        members_.quoted(event.value), values, event.value));
    }

    void write_log() {
        out_.line("#if ROBOCHART_TRACE");
        out_.open(fmt::format("controller.def({}, [python](Base& robot, const std::string& path) {{",
                              members_.quoted(free_member(api_, "log_to"))));
        out_.line("python(robot).python_calls.require_start();");
        out_.line("auto log = std::make_unique<robochart::TraceFile>(Base::RunHeader());");
        out_.line("if (!log->open(path)) ::robochart::python::refuse_file(path);");
        out_.line("robot.SetTracer(log.get());");
        out_.line("python(robot).python_log = std::move(log);");
        out_.close("}, \"Writes a log of all cycles for `robochart-verify conform --traces`.\");");
        out_.line("#endif");
    }

    const Generation& generation_;
    const Core& core_;
    const ClassApi& api_;
    std::string base_;  ///< the controller's class
    MemberNames members_;
    std::map<std::uint32_t, std::string> names_;
    std::set<std::string> taken_;  ///< names of the module
    CodeWriter out_;
};

class PythonRobotWriter {
public:
    PythonRobotWriter(const Generation& generation, const ClassApi& api)
        : generation_(generation), api_(api), members_(api) {}

    std::string write() {
        comment(fmt::format("A robot with the controller of the RoboChart {} ", generation_.component.kind) +
                generation_.place_text(generation_.component.origin) +
                ": which sensors raise its events, what its operations do.");
        comment("This file is yours: robochart-verify does not overwrite it.");
        line("import sys\n");
        line(fmt::format("import {} as controller\n\n", python_module_name(api_)));
        line(fmt::format("class Robot(controller.{}):", class_in_module(api_)));
        line("    def CheckInEvent(self):");
        line("        \"\"\"Is called before each cycle: raise the events that the sensors report.\"\"\"");
        each_class(api_, [&](const ApiClass& part) {
            for (const ApiEvent& event : part.events)
                if (!event.sent)
                    line(fmt::format("        # self.{}({})", members_.name(event.method),
                                     event.port->type ? "value" : ""));
        });
        each_class(api_, [&](const ApiClass& part) { write_calls(part); });
        line("\n\ndef main(cycles):");
        line("    robot = Robot()");
        line("    for number in range(1, cycles + 1):");
        line("        result = robot.step()");
        std::vector<std::string> states;
        for (const ApiMachine& machine : api_.machines)
            states.push_back(fmt::format("robot.{}().name", members_.name(machine.method)));
        line(fmt::format("        print(f\"cycle {{number}}:\", {})", fmt::join(states, ", ")));
        line("        if result != controller.StepResult.quiescent:");
        line("            print(result.name)");
        line("            break\n\n");
        line("if __name__ == \"__main__\":");
        line("    main(int(sys.argv[1]) if len(sys.argv) > 1 else 10)");
        return text_;
    }

private:
    void line(const std::string& text) { text_ += text + '\n'; }
    void comment(const diagnostics::ForeignText& text) { line("# " + diagnostics::comment_text(text)); }

    void write_calls(const ApiClass& part) {
        for (const ApiOperation& operation : part.operations)
            if (!operation.modelled) write_method(operation.method, operation.signature->parameter_names.size());
        for (const ApiEvent& event : part.events)
            if (event.sent) write_method(event.method, event.port->type ? 1 : 0);
    }

    void write_method(const std::string& method, std::size_t parameters) {
        std::string list, values;
        for (std::size_t i = 0; i < parameters; ++i) {
            list += fmt::format(", a{}", i);
            values += fmt::format(", a{}", i);
        }
        line("");
        line(fmt::format("    def {}(self{}):", members_.name(method), list));
        line(fmt::format("        print(\"  {}\"{})", members_.name(method), values));
    }

    const Generation& generation_;
    const ClassApi& api_;
    MemberNames members_;
    std::string text_;
};

}  // namespace

std::string python_module_name(const ClassApi& api) {
    return api.cpp_name + "_controller";
}

std::string python_module(const Generation& generation, const Core& core, const ClassApi& api) {
    return ModuleWriter(generation, core, api).write();
}

std::string python_robot(const Generation& generation, const ClassApi& api) {
    return PythonRobotWriter(generation, api).write();
}

}  // namespace robochart::cpp_emit
