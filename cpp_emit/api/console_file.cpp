// SPDX-License-Identifier: Apache-2.0
// Writes a console driver and the build file of the generated library.
#include <fmt/format.h>

#include "base/diagnostics/escape.hpp"
#include "cpp_emit/api/console_class.hpp"

namespace robochart::cpp_emit {

namespace {

class ConsoleWriter {
public:
    ConsoleWriter(const Generation& generation, const Core& core, const ClassApi& api)
        : generation_(generation), core_(core), api_(api), asks_(console_asks(generation)) {}

    std::string write() {
        file_comment(generation_, out_, "Console driver");
        usage_comment();
        for (const char* header :
             {"<chrono>", "<cstdint>", "<cstdlib>", "<iostream>", "<sstream>", "<string>", "<string_view>"})
            out_.line(fmt::format("#include {}", header));
        out_.line("#include <poll.h>");
        out_.line("#include <unistd.h>");
        out_.gap();
        out_.line(fmt::format("#include \"{}.hpp\"", api_.cpp_name));
        if (asks_) out_.line("#include \"robochart/console_choices.hpp\"");
        out_.line(fmt::format("#include \"{}_trace.hpp\"", generation_.component.cpp_name));
        out_.line("#include \"robochart/console_values.hpp\"");
        out_.line("#if ROBOCHART_TRACE");
        out_.line("#include \"robochart/trace_file.hpp\"");
        out_.line("#endif");
        out_.gap();
        console_reading(generation_, core_, out_);
        out_.line("namespace {");
        out_.gap();
        console_class(generation_, core_, api_, out_);
        out_.gap();
        cycle_functions();
        out_.gap();
        options_function();
        out_.gap();
        out_.line("}  // namespace");
        out_.gap();
        main_function();
        return out_.text();
    }

private:
    void usage_comment() {
        out_.comment(
            "Each line of input is one control cycle: the events raised in it, `seeRobot` or `heading=0.5`. With a "
            "number of milliseconds as its argument a cycle comes that often, with what was typed until then. --log "
            "FILE "
            "writes a log for `robochart-verify conform --traces`, --coverage prints which transitions were taken, "
            "--help what can be raised.");
        if (asks_)
            out_.comment(fmt::format(
                "Where the model leaves a choice, `{}=2` in the line of the cycle takes the third; on a terminal, or "
                "with --ask, you are asked for the others, else it is the first. --record FILE writes what was raised "
                "and picked, --replay FILE repeats it.",
                pick_word(api_)));
    }

    void help_functions() {
        out_.doc("How the program is called, and what can be raised.");
        out_.open("void print_help(std::ostream& out) {");
        out_.line(fmt::format("out << \"usage: {}_console [MILLISECONDS] [--log FILE] [--coverage]{}\\n\"",
                              api_.cpp_name, asks_ ? " [--ask] [--record FILE] [--replay FILE]" : ""));
        const std::vector<std::string> inputs = console_inputs(generation_, api_);
        out_.line(inputs.empty() ? "       \"There are no inputs: each line is a cycle.\\n\";"
                                 : "       \"Each line is a cycle with the inputs that come in it:\\n\"");
        for (std::size_t i = 0; i < inputs.size(); ++i)
            out_.line("       " + diagnostics::cpp_string("  " + inputs[i] + "\n") +
                      (i + 1 == inputs.size() ? ";" : ""));
        out_.close();
        out_.gap();
        out_.doc("A word that raises nothing; after the first one stands what would.");
        out_.open("void refuse([[maybe_unused]] Console& controller, const std::string& word) {");
        out_.line("static bool helped = false;");
        if (asks_) {
            out_.line("controller.console_choices.refuse(\"not an input: \" + word);");
            out_.line("if (!helped && controller.console_choices.fault().empty()) print_help(std::cerr);");
        } else {
            out_.line("std::cerr << \"not an input: \" << word << '\\n';");
            out_.line("if (!helped) print_help(std::cerr);");
        }
        out_.line("helped = true;");
        out_.close();
        out_.gap();
    }

    void cycle_functions() {
        help_functions();
        out_.doc("Raises the events of a line.");
        out_.open("void raise_all(Console& controller, const std::string& line) {");
        out_.line("std::istringstream words(line);");
        out_.line("std::string word;");
        out_.open("while (words >> word) {");
        if (asks_) out_.line("if (controller.console_choices.take(word)) continue;");
        out_.line("const std::size_t equals = word.find('=');");
        out_.line("const std::string value = equals == std::string::npos ? \"\" : word.substr(equals + 1);");
        if (asks_) {
            out_.line("if (controller.raise(word.substr(0, equals), value)) controller.console_choices.raised(word);");
            out_.line("else refuse(controller, word);");
        } else {
            out_.line("if (!controller.raise(word.substr(0, equals), value)) refuse(controller, word);");
        }
        out_.close();
        out_.close();
        out_.gap();
        out_.doc("One cycle; whether there is a next one.");
        out_.open("robochart::StepResult cycle(Console& controller, int number) {");
        out_.line("std::cout << \"cycle \" << number << '\\n';");
        out_.line("const robochart::StepResult result = controller.step();");
        if (asks_) out_.line("controller.console_choices.end();");
        out_.line("controller.print();");
        out_.line("std::cout.flush();");
        out_.line("return result;");
        out_.close();
        out_.gap();
        out_.doc("Adds to `typed` what is typed until then; false at the end of the input.");
        out_.open("bool listen(std::string& typed, std::chrono::steady_clock::time_point until) {");
        out_.open("while (true) {");
        out_.line("const auto left = until - std::chrono::steady_clock::now();");
        out_.line("const auto wait = std::chrono::duration_cast<std::chrono::milliseconds>(left).count();");
        out_.line("if (wait <= 0) return true;");
        out_.line("pollfd input{STDIN_FILENO, POLLIN, 0};");
        out_.line("if (poll(&input, 1, static_cast<int>(wait)) <= 0) continue;");
        out_.line("char bytes[256];");
        out_.line("const auto got = read(STDIN_FILENO, bytes, sizeof bytes);");
        out_.line("if (got <= 0) return false;");
        out_.line("typed.append(bytes, static_cast<std::size_t>(got));");
        out_.close();
        out_.close();
        out_.gap();
        out_.doc("A cycle every so often, until the input or the controller ends.");
        out_.open("robochart::StepResult run_timed(Console& controller, std::chrono::milliseconds period) {");
        out_.line("std::string typed;");
        out_.line("auto result = robochart::StepResult::quiescent;");
        out_.line("auto next = std::chrono::steady_clock::now();");
        out_.line("bool open = true;");
        out_.open("for (int number = 1; open && result == robochart::StepResult::quiescent; ++number) {");
        out_.line("next += period;");
        out_.line("open = listen(typed, next);");
        out_.line("const std::size_t lines = open ? typed.rfind('\\n') + 1 : typed.size();");
        out_.line("raise_all(controller, typed.substr(0, lines));");
        out_.line("typed.erase(0, lines);");
        out_.line("result = cycle(controller, number);");
        out_.close();
        out_.line("return result;");
        out_.close();
        out_.gap();
        lines_function();
        if (asks_) replay_function();
    }

    void lines_function() {
        out_.doc("A cycle for every line.");
        out_.open("robochart::StepResult run_by_lines(Console& controller) {");
        out_.line("std::string line;");
        out_.line("auto result = robochart::StepResult::quiescent;");
        out_.open(
            "for (int number = 1; result == robochart::StepResult::quiescent && std::getline(std::cin, line); "
            "++number) {");
        out_.line("raise_all(controller, line);");
        out_.line("result = cycle(controller, number);");
        out_.close();
        out_.line("return result;");
        out_.close();
    }

    void replay_function() {
        out_.gap();
        out_.doc("A cycle for every line of the record, until one is not what happened.");
        out_.open("robochart::StepResult run_replayed(Console& controller) {");
        out_.line("std::string line;");
        out_.line("auto result = robochart::StepResult::quiescent;");
        out_.open(
            "for (int number = 1; result == robochart::StepResult::quiescent && "
            "controller.console_choices.next(line); ++number) {");
        out_.line("raise_all(controller, line);");
        out_.line("if (controller.console_choices.fault().empty()) result = cycle(controller, number);");
        out_.close();
        out_.line("controller.console_choices.finish();");
        out_.line("return result;");
        out_.close();
    }

    void options_function() {
        out_.doc("What was asked for; `wrong` if it was not understood.");
        out_.open("struct Asked {");
        out_.line("long period = 0;  ///< milliseconds; 0: a cycle a line");
        out_.line("std::string log;");
        if (asks_) out_.line("std::string record, replay;");
        if (asks_) out_.line("bool ask = false;");
        out_.line("bool coverage = false;");
        out_.line("bool help = false;");
        out_.line("bool wrong = false;");
        out_.close("};");
        out_.gap();
        out_.open("Asked asked(int argc, char** argv) {");
        out_.line("Asked result;");
        out_.open("for (int i = 1; i < argc; ++i) {");
        out_.line("const std::string_view word = argv[i];");
        out_.open("if (word == \"--coverage\") {");
        out_.line("result.coverage = true;");
        out_.reopen_block("} else if (word == \"--help\" || word == \"-h\") {");
        out_.line("result.help = true;");
        out_.reopen_block("} else if (word == \"--log\" && i + 1 < argc) {");
        out_.line("result.log = argv[++i];");
        if (asks_) {
            for (const char* option : {"record", "replay"}) {
                out_.reopen_block(fmt::format("}} else if (word == \"--{}\" && i + 1 < argc) {{", option));
                out_.line(fmt::format("result.{} = argv[++i];", option));
            }
            out_.reopen_block("} else if (word == \"--ask\") {");
            out_.line("result.ask = true;");
        }
        out_.reopen_block("} else {");
        out_.line("result.period = std::strtol(argv[i], nullptr, 10);");
        out_.line("result.wrong = result.wrong || result.period < 1;");
        out_.close();
        out_.close();
        if (asks_) {
            out_.comment("Nobody is asked while time passes, nor where a record answers.");
            out_.line("const bool alone = result.period > 0 || !result.replay.empty();");
            out_.line("result.wrong = result.wrong || (result.ask && alone);");
            out_.line(
                "if (!result.replay.empty()) result.wrong = result.wrong || result.period > 0 || result.record == "
                "result.replay;");
            out_.line("result.ask = result.ask || (!alone && isatty(STDIN_FILENO) != 0);");
        }
        out_.line("return result;");
        out_.close();
        out_.gap();
        out_.doc("Tells what a cycle could not do.");
        out_.open("void tell(robochart::StepResult result) {");
        out_.line(
            "if (result == robochart::StepResult::step_bound) std::cerr << \"a cycle did not end within its bound of "
            "steps\\n\";");
        out_.line(
            "if (result == robochart::StepResult::precondition) std::cerr << \"an operation was called outside its "
            "precondition\\n\";");
        out_.line("if (result == robochart::StepResult::deadline) std::cerr << \"a deadline was missed\\n\";");
        if (generation_.component.lists)
            out_.line(
                "if (result == robochart::StepResult::capacity) std::cerr << \"a list has more items than its "
                "capacity\\n\";");
        out_.close();
    }

    void open_log() {
        out_.line("#if ROBOCHART_TRACE");
        out_.line("robochart::TraceFile log(Console::RunHeader());");
        out_.open("if (!wanted.log.empty() && !log.open(wanted.log)) {");
        out_.line("std::cerr << \"cannot write \" << wanted.log << '\\n';");
        out_.line("return EXIT_FAILURE;");
        out_.close();
        out_.line("controller.SetTracer(&log);");
        out_.line("#else");
        out_.open("if (!wanted.log.empty() || wanted.coverage) {");
        out_.line("std::cerr << \"--log and --coverage need a build with -DROBOCHART_TRACE=ON\\n\";");
        out_.line("return EXIT_FAILURE;");
        out_.close();
        out_.line("#endif");
    }

    void open_choices() {
        out_.open("if (!wanted.record.empty() && !controller.console_choices.record(wanted.record)) {");
        out_.line("std::cerr << \"cannot write \" << wanted.record << '\\n';");
        out_.line("return EXIT_FAILURE;");
        out_.close();
        out_.line("if (!wanted.replay.empty()) controller.console_choices.replay(wanted.replay);");
        out_.line("if (wanted.ask) controller.console_choices.ask();");
    }

    void close_choices() {
        out_.open("if (!controller.console_choices.fault().empty()) {");
        out_.line("std::cerr << controller.console_choices.fault() << '\\n';");
        out_.line("return EXIT_FAILURE;");
        out_.close();
        out_.open("if (!controller.console_choices.recorded()) {");
        out_.line("std::cerr << \"cannot write \" << wanted.record << '\\n';");
        out_.line("return EXIT_FAILURE;");
        out_.close();
    }

    void main_function() {
        out_.open("int main(int argc, char** argv) {");
        out_.line("const Asked wanted = asked(argc, argv);");
        out_.open("if (wanted.help) {");
        out_.line("print_help(std::cout);");
        out_.line("return EXIT_SUCCESS;");
        out_.close();
        out_.open("if (wanted.wrong) {");
        out_.line("print_help(std::cerr);");
        out_.line("return EXIT_FAILURE;");
        out_.close();
        out_.line("Console controller;");
        open_log();
        if (asks_) open_choices();
        const char* const timed = "run_timed(controller, std::chrono::milliseconds(wanted.period))";
        out_.line(fmt::format("const robochart::StepResult result = wanted.period > 0 ? {}", timed));
        if (asks_)
            out_.line("                                        : !wanted.replay.empty() ? run_replayed(controller)");
        out_.line("                                                       : run_by_lines(controller);");
        out_.line("tell(result);");
        out_.line("#if ROBOCHART_TRACE");
        out_.line("if (wanted.coverage) std::cout << log.coverage();");
        out_.line("if (!log.good()) std::cerr << \"cannot write \" << wanted.log << '\\n';");
        out_.line("#endif");
        if (asks_) close_choices();
        out_.line(
            "const bool good = result == robochart::StepResult::quiescent || result == "
            "robochart::StepResult::terminated;");
        out_.line("return good ? EXIT_SUCCESS : EXIT_FAILURE;");
        out_.close();
    }

    const Generation& generation_;
    const Core& core_;
    const ClassApi& api_;
    bool asks_;
    CodeWriter out_;
};

}  // namespace

std::string console_source(const Generation& generation, const Core& core, const ClassApi& api) {
    return ConsoleWriter(generation, core, api).write();
}

std::string build_file(const ClassApi& api) {
    CodeWriter out;
    out.line("# Generated by robochart-verify: the controller as a library, and a console program to try it.");
    out.line("cmake_minimum_required(VERSION 3.16)");
    out.line(fmt::format("project({} LANGUAGES CXX)", api.cpp_name));
    out.gap();
    out.line(fmt::format("add_library({0} STATIC {0}.cpp)", api.cpp_name));
    out.line(fmt::format("target_include_directories({} PUBLIC ${{CMAKE_CURRENT_SOURCE_DIR}})", api.cpp_name));
    out.line(fmt::format("target_compile_features({} PUBLIC cxx_std_17)", api.cpp_name));
    out.line("option(ROBOCHART_TRACE \"The controller can tell a tracer what it does: --log, --coverage\" OFF)");
    out.line(fmt::format("target_compile_definitions({} PUBLIC ROBOCHART_TRACE=$<BOOL:${{ROBOCHART_TRACE}}>)",
                         api.cpp_name));
    out.gap();
    out.line(fmt::format("add_executable({}_console main.cpp)", api.cpp_name));
    out.line(fmt::format("target_link_libraries({0}_console PRIVATE {0})", api.cpp_name));
    return out.text();
}

}  // namespace robochart::cpp_emit
