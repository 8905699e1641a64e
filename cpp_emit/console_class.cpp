// See console_class.hpp.
#include "cpp_emit/console_class.hpp"

#include <fmt/format.h>

namespace robochart::cpp_emit {

namespace {

class ConsoleClassWriter {
public:
    ConsoleClassWriter(const Generation& generation, const Core& core, const Face& face, CodeWriter& out)
        : generation_(generation), core_(core), face_(face), out_(out), asks_(console_asks(generation)) {}

    void write() {
        show_functions();
        console_class();
    }

private:
    void show_functions() {
        out_.doc("A value as text; declared types by number.");
        out_.line("template <class T>");
        out_.open("std::string show_value(T value) {");
        out_.line("std::ostringstream text;");
        out_.open("if constexpr (std::is_enum_v<T>) {");
        out_.line("text << static_cast<int>(value);");
        out_.reopen("} else if constexpr (std::is_arithmetic_v<T>) {");
        out_.line("text << std::boolalpha << value;");
        out_.reopen("} else {");
        out_.line("static_cast<void>(value);");
        out_.line("text << \"(...)\";");
        out_.close();
        out_.line("return text.str();");
        out_.close();
        out_.gap();
        out_.doc("Reads a value; false if the text is none.");
        out_.line("template <class T>");
        out_.open("[[maybe_unused]] bool read_value(const std::string& text, T& value) {");
        out_.line("std::istringstream input(text);");
        out_.open("if constexpr (std::is_enum_v<T>) {");
        out_.line("int number = 0;");
        out_.line("if (!(input >> number) || !(input >> std::ws).eof()) return false;");
        out_.line("value = static_cast<T>(number);");
        out_.line("return true;");
        out_.reopen("} else if constexpr (std::is_arithmetic_v<T>) {");
        out_.line("T read{};");
        out_.line("if (!(input >> std::boolalpha >> read) || !(input >> std::ws).eof()) return false;");
        out_.line("value = read;");
        out_.line("return true;");
        out_.reopen("} else {");
        out_.line("value = T{};");
        out_.line("return false;");
        out_.close();
        out_.close();
    }

    void console_class() {
        out_.gap();
        out_.open(fmt::format("class Console final : public {}::{} {{", face_.name_space, face_.cpp_name));
        out_.label("public:");
        each_class(face_, [&](const FaceClass& part) {
            for (const FaceOperation& operation : part.operations)
                if (!operation.modelled) print_call(operation);
        });
        if (asks_) pick_functions();
        raise_function();
        print_function();
        if (asks_) {
            out_.gap();
            out_.line(fmt::format("robochart::ConsoleChoices console_choices{{\"{}\", \"{}\"}};", face_.cpp_name,
                                  pick_word(face_)));
        }
        out_.close("};");
    }

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

    void print_call(const FaceOperation& operation) {
        std::string parameters, shown;
        for (std::size_t i = 0; i < operation.signature->parameters.size(); ++i) {
            parameters +=
                fmt::format("{}{} a{}", i == 0 ? "" : ", ",
                            deployed_type(generation_, core_.name_space, operation.signature->parameters[i]), i);
            shown += fmt::format("{} << show_value(a{})", i == 0 ? "" : " << \", \"", i);
        }
        out_.open(fmt::format("void {}({}) override {{", operation.method, parameters));
        out_.line(fmt::format("std::cout << \"  {}(\"{} << \")\\n\";", operation.signature->name, shown));
        out_.close();
        out_.gap();
    }

    void raise_function() {
        out_.doc("Raises an event; false if there is none of that name, or the value is wrong.");
        out_.open("bool raise([[maybe_unused]] const std::string& event, [[maybe_unused]] const std::string& value) {");
        each_class(face_, [&](const FaceClass& part) {
            for (const FaceEvent& event : part.events) {
                if (event.sent) continue;
                out_.open(fmt::format("if (event == \"{}\") {{", event.port->model_name));
                out_.line(event.port->type ? fmt::format("if (!read_value(value, {})) return false;", event.value)
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
        for (const FaceMachine& machine : face_.machines)
            out_.line(fmt::format("std::cout << \"  {} \" << name({}());", machine.method, machine.method));
        each_class(face_, [&](const FaceClass& part) {
            for (const FaceVariable& variable : part.variables)
                out_.line(fmt::format("std::cout << \" {} = \" << show_value({});", variable.stored->variable->name,
                                      variable.member));
            for (const FaceEvent& event : part.events)
                if (event.sent)
                    out_.line(fmt::format("if ({}) std::cout << \" {}\"{};", event.flag, event.port->model_name,
                                          event.port->type ? " << '!' << show_value(" + event.value + ")" : ""));
        });
        for (const FaceTimer& timer : face_.timers)
            out_.line(fmt::format("std::cout << \" since({}) = \" << {}.counter;", timer.clock->name, timer.member));
        out_.line("std::cout << '\\n';");
        out_.close();
    }

    const Generation& generation_;
    const Core& core_;
    const Face& face_;
    CodeWriter& out_;
    bool asks_;
};

}  // namespace

bool console_asks(const Generation& generation) {
    return generation.options.choices || generation.component.probabilistic;
}

std::string pick_word(const Face& face) {
    std::string word = "pick";
    const auto taken = [&] {
        bool found = false;
        each_class(face, [&](const FaceClass& part) {
            for (const FaceEvent& event : part.events) found = found || (!event.sent && event.port->model_name == word);
        });
        return found;
    };
    while (taken()) word += '_';
    return word;
}

void console_class(const Generation& generation, const Core& core, const Face& face, CodeWriter& out) {
    ConsoleClassWriter(generation, core, face, out).write();
}

}  // namespace robochart::cpp_emit
