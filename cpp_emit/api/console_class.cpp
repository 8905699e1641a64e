// SPDX-License-Identifier: Apache-2.0
// Writes the class `Console` of main.cpp. It raises inputs by name, prints outputs, and asks for choices.
#include "cpp_emit/api/console_class.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

using diagnostics::cpp_string;

namespace {

class ReadingWriter {
public:
    ReadingWriter(const Generation& generation, const Core& core, CodeWriter& out)
        : generation_(generation), core_(core), out_(out) {}

    /// Writes functions that read values of the declared types, by their names in the model. A literal may also be
    /// entered by its number.
    void write() {
        const std::vector<ir::TypeId>& declared = generation_.component.enumerations;
        if (declared.empty()) return;
        out_.line(fmt::format("namespace {} {{", core_.name_space));
        Spelling spelling;
        spelling.types = "robochart::Deployment";
        spelling.core = "::" + core_.name_space + "::";  // a type may have the name of a parameter
        for (const ir::TypeId id : declared) {
            const ir::Type& type = generation_.system.type(id);
            const std::string name = cpp_type(generation_.system, id, spelling);
            out_.gap();
            out_.open(fmt::format("[[maybe_unused]] static bool read_part(robochart::Words& in, {}& value) {{", name));
            if (type.kind == ir::TypeKind::given) {
                write_given(name);
            } else if (type.kind == ir::TypeKind::enumeration) {
                write_literals(type, name);
            } else {
                out_.line("return " + parts_read(type_members(type), type_members(type).size() > 1) + ";");
            }
            out_.close();
        }
        out_.gap();
        out_.line(fmt::format("}}  // namespace {}", core_.name_space));
        out_.gap();
    }

private:
    void write_given(const std::string& name) {
        out_.line("int number = 0;");
        out_.line("if (!robochart::read_part(in, number) || number < 0 || number > 255) return false;");
        out_.line(fmt::format("value = static_cast<{}>(number);", name));
        out_.line("return true;");
    }

    void write_literals(const ir::Type& type, const std::string& name) {
        const std::vector<TypeMember> all = type_members(type);
        out_.line("const std::string_view word = in.word();");
        for (std::size_t literal = 0; literal < type.labels.size(); ++literal) {
            std::vector<TypeMember> given;
            std::ranges::copy_if(all, std::back_inserter(given),
                                 [&](const TypeMember& member) { return member.literal == literal; });
            out_.open(fmt::format("if (word == {} || word == \"{}\") {{", cpp_string(type.labels[literal]), literal));
            out_.line(is_struct(type) ? fmt::format("value.kind = {}::Kind::{};", name, literal_name(type, literal))
                                      : fmt::format("value = {}::{};", name, literal_name(type, literal)));
            out_.line("return " + (given.empty() ? "true" : parts_read(given, true)) + ";");
            out_.close();
        }
        out_.line("return false;");
    }

    static std::string parts_read(const std::vector<TypeMember>& parts, bool brackets) {
        std::string text;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (i > 0 || brackets) text += i == 0 ? "in.take('(') && " : " && in.take(',') && ";
            text += fmt::format("read_part(in, value.{})", parts[i].name);
        }
        return text + (brackets ? " && in.take(')')" : "");
    }

    const Generation& generation_;
    const Core& core_;
    CodeWriter& out_;
};

class ConsoleClassWriter {
public:
    ConsoleClassWriter(const Generation& generation, const Core& core, const ClassApi& api, CodeWriter& out)
        : generation_(generation), core_(core), api_(api), out_(out), asks_(console_asks(generation)) {}

    void write() {
        out_.open(fmt::format("class Console final : public ::{}::{} {{", api_.name_space, api_.cpp_name));
        out_.write_label("public:");
        each_class(api_, [&](const ApiClass& part) {
            for (const ApiOperation& operation : part.operations)
                if (!operation.modelled) print_call(operation);
        });
        if (asks_) pick_functions();
        raise_function();
        print_function();
        if (asks_) {
            out_.gap();
            out_.line(fmt::format("robochart::ConsoleChoices console_choices{{\"{}\", \"{}\"}};", api_.cpp_name,
                                  pick_word(api_)));
        }
        out_.close("};");
    }

private:
    void pick_functions() {
        if (generation_.options.choices)
            out_.line("std::size_t pick(std::size_t count) noexcept override { return console_choices.pick(count); }");
        if (generation_.component.probabilistic) {
            out_.open("std::size_t choose(const double* chances, std::size_t count) noexcept override {");
            out_.line("return console_choices.choose(chances, count);");
            out_.close();
        }
        out_.gap();
    }

    void print_call(const ApiOperation& operation) {
        std::string parameters, shown;
        for (std::size_t i = 0; i < operation.signature->parameters.size(); ++i) {
            parameters +=
                fmt::format("{}{} a{}", i == 0 ? "" : ", ",
                            deployed_type(generation_, "::" + core_.name_space, operation.signature->parameters[i]), i);
            shown += fmt::format("{} << robochart::show_value(a{})", i == 0 ? "" : " << \", \"", i);
        }
        out_.open(fmt::format("void {}({}) override {{", operation.method, parameters));
        out_.line(fmt::format("std::cout << \"  {}(\"{} << \")\\n\";", operation.signature->name, shown));
        out_.close();
        out_.gap();
    }

    void raise_function() {
        out_.doc("Raises an event; false if there is none of that name, or the value is wrong.");
        out_.open("bool raise([[maybe_unused]] const std::string& event, [[maybe_unused]] const std::string& value) {");
        each_class(api_, [&](const ApiClass& part) {
            for (const ApiEvent& event : part.events) {
                if (event.sent) continue;
                out_.open(fmt::format("if (event == \"{}\") {{", event.port->model_name));
                out_.line(event.port->type
                              ? fmt::format("if (!robochart::read_value(value, {})) return false;", event.value)
                              : "if (!value.empty()) return false;");
                out_.line(fmt::format("{} = true;", event.flag));
                out_.line("return true;");
                out_.close();
            }
        });
        out_.line("return false;");
        out_.close();
        out_.gap();
    }

    void print_function() {
        out_.doc("What can be seen from outside after a cycle.");
        out_.open("void print() const {");
        for (const ApiMachine& machine : api_.machines)
            out_.line(fmt::format("std::cout << \"  {} \" << name({}());", machine.method, machine.method));
        each_class(api_, [&](const ApiClass& part) {
            for (const ApiVariable& variable : part.variables)
                out_.line(fmt::format("std::cout << \" {} = \" << robochart::show_value({});", variable.stored->name(),
                                      variable.member));
            for (const ApiEvent& event : part.events)
                if (event.sent)
                    out_.line(
                        fmt::format("if ({}) std::cout << \" {}\"{};", event.flag, event.port->model_name,
                                    event.port->type ? " << '!' << robochart::show_value(" + event.value + ")" : ""));
        });
        for (const ApiTimer& timer : api_.timers)
            out_.line(fmt::format("std::cout << \" since({}) = \" << {}.counter;", timer.clock->name, timer.member));
        out_.line("std::cout << '\\n';");
        out_.close();
    }

    const Generation& generation_;
    const Core& core_;
    const ClassApi& api_;
    CodeWriter& out_;
    bool asks_;
};

}  // namespace

bool console_asks(const Generation& generation) {
    return generation.options.choices || generation.component.probabilistic;
}

std::string pick_word(const ClassApi& api) {
    std::string word = "pick";
    const auto taken = [&] {
        bool found = false;
        each_class(api, [&](const ApiClass& part) {
            for (const ApiEvent& event : part.events) found = found || (!event.sent && event.port->model_name == word);
        });
        return found;
    };
    while (taken()) word += '_';
    return word;
}

void console_reading(const Generation& generation, const Core& core, CodeWriter& out) {
    ReadingWriter(generation, core, out).write();
}

namespace {

/// Describes what the user may enter for a value of the type.
std::string describe_input(const ir::Type& type) {
    switch (type.kind) {
        case ir::TypeKind::boolean:
            return "true or false";
        case ir::TypeKind::nat:
            return "a natural number";
        case ir::TypeKind::integer:
            return "a whole number";
        case ir::TypeKind::real:
            return "a real number";
        case ir::TypeKind::given:
            return fmt::format("a value of {}: its number, from 0", type.name);
        case ir::TypeKind::enumeration:
            break;
        case ir::TypeKind::string:
        case ir::TypeKind::sequence:
        case ir::TypeKind::set:
        case ir::TypeKind::product:
        case ir::TypeKind::record:
        case ir::TypeKind::function:
        case ir::TypeKind::relation:
        case ir::TypeKind::vector:
        case ir::TypeKind::matrix:
        case ir::TypeKind::unit:
            return fmt::format("a value of {}, as in logs", type.name);
    }
    constexpr std::size_t most = 16;
    const bool plain = std::ranges::all_of(type.literal_args, [](const auto& arguments) { return arguments.empty(); });
    if (!plain || type.labels.size() > most) return fmt::format("a literal of {}, as in logs", type.name);
    return fmt::format("one of {}", fmt::join(type.labels, ", "));
}

}  // namespace

std::vector<std::string> console_inputs(const Generation& generation, const ClassApi& api) {
    std::vector<std::pair<std::string, std::string>> rows;
    std::size_t width = 0;
    each_class(api, [&](const ApiClass& part) {
        for (const ApiEvent& event : part.events) {
            if (event.sent) continue;
            const auto& type = event.port->type;
            rows.emplace_back(event.port->model_name + (type ? "=VALUE" : ""),
                              type ? describe_input(generation.system.type(*type)) : "");
            width = std::max(width, rows.back().first.size());
        }
    });
    std::vector<std::string> lines;
    for (const auto& [name, value] : rows)
        lines.push_back(value.empty() ? name : fmt::format("{:<{}}  {}", name, width, value));
    return lines;
}

void console_class(const Generation& generation, const Core& core, const ClassApi& api, CodeWriter& out) {
    ConsoleClassWriter(generation, core, api, out).write();
}

}  // namespace robochart::cpp_emit
