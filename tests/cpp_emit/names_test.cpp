// SPDX-License-Identifier: Apache-2.0
// Tests the names of model elements in generated code. Nowhere is such a name a keyword, a macro of an available
// header, or a name that generated code uses itself. Code with such elements compiles.
#include "cpp_emit/plan/names.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <sstream>

#include "cpp_emit/plan/reserved.hpp"
#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"
#include "tests/source_folder.hpp"

namespace robochart::cpp_emit::names_test {
namespace {

using testing::Folder;

std::string contents(const std::string& path) {
    std::ifstream in(tests::source_folder().string() + "/" + path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Returns the headers of C, C++ and POSIX that scripts/reserved_names.sh includes.
std::string all_headers() {
    std::istringstream lines(contents("scripts/reserved_names.sh"));
    std::string headers;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("#include <")) headers += line + "\n";
    return headers;
}

TEST(Names, NoMacroOfTheHeadersIsAName) {
    const Folder folder;
    std::ofstream(folder.path() + "/all.hpp") << all_headers();
    for (const char* compiler : {"g++", "clang++"}) {
        std::string macros;
        const std::string command = std::string(compiler) + " -std=gnu++17 -dM -E -x c++ all.hpp";
        if (folder.status(command, macros) != 0) continue;  // the compiler is not installed
        std::istringstream lines(macros);
        std::size_t checked = 0;
        for (std::string define, name; lines >> define >> name; std::getline(lines, define)) {
            name.erase(std::min(name.find('('), name.size()));
            if (!std::isalpha(static_cast<unsigned char>(name.front()))) continue;
            ++checked;
            EXPECT_TRUE(reserved_in_cpp(name)) << name << " of " << compiler << " (see scripts/reserved_names.sh)";
        }
        EXPECT_GT(checked, 1000U) << compiler;
    }
}

TEST(Names, ReservedOnesGetAnUnderscoreThenANumber) {
    NameScope scope(std::set<std::string>{"step", "union_"});
    EXPECT_EQ(scope.unique_name("speed"), "speed");
    EXPECT_EQ(scope.unique_name("BUFSIZ"), "BUFSIZ_");
    EXPECT_EQ(scope.unique_name("union"), "union_2");
    EXPECT_EQ(scope.unique_name("step"), "step_2");
    EXPECT_EQ(scope.unique_name("ROBOCHART_TRACE"), "model_ROBOCHART_TRACE");
    NameScope outside(reserved_at_global_scope);
    EXPECT_EQ(outside.unique_name("time"), "time_");
    EXPECT_EQ(outside.unique_name("abort"), "abort_");
    EXPECT_EQ(outside.unique_name("swarm_taxis"), "swarm_taxis");
}

TEST(Names, BoundVariablesStayApart) {
    const char* names[] = {"x", "a_b", "a__b", "_a_b", "a_b_", "0a_b"};
    std::set<std::string> all;
    for (const char* name : names) EXPECT_TRUE(all.insert(bound_identifier(name)).second) << name;
    EXPECT_EQ(bound_identifier("x"), "bound_x");
}

// ---- names that generated code introduces

/// Returns the unqualified identifiers of C++ text outside comments, literals and directives: not after "::", "." or
/// "->".
std::set<std::string> own_identifiers(const std::string& text) {
    std::set<std::string> found;
    std::string before;
    for (std::size_t i = 0; i < text.size();) {
        const auto is_word = [&](std::size_t at) {
            return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
        };
        const bool line_start = i == 0 || text.find_last_not_of(' ', i - 1) == std::string::npos ||
                                text[text.find_last_not_of(' ', i - 1)] == '\n';
        if (text.compare(i, 2, "//") == 0 || (text[i] == '#' && line_start)) {
            i = std::min(text.find('\n', i), text.size());
        } else if (text[i] == '"' || (text[i] == '\'' && !(i > 0 && is_word(i - 1)))) {
            const char quote = text[i++];
            while (i < text.size() && text[i] != quote) i += text[i] == '\\' ? 2U : 1U;
            ++i;
            before = "literal";
        } else if (is_word(i)) {
            std::size_t end = i;
            while (is_word(end)) ++end;
            const std::string word = text.substr(i, end - i);
            const bool behind = before.ends_with("::") || before.ends_with(".") || before.ends_with("->");
            if (!behind && std::isdigit(static_cast<unsigned char>(word.front())) == 0) found.insert(word);
            before = word;
            i = end;
        } else {
            if (std::isspace(static_cast<unsigned char>(text[i])) == 0) before += text[i];
            ++i;
        }
    }
    return found;
}

/// Returns whether the word contains the letters that the names of all elements of the marked models contain.
bool of_the_model(std::string word) {
    std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::tolower(c); });
    return word.find("zq") != std::string::npos;
}

bool is_numbered(const std::string& word, const std::string& stem) {
    return word.starts_with(stem) && std::all_of(word.begin() + static_cast<std::ptrdiff_t>(stem.size()), word.end(),
                                                 [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Functions outside classes do not see members, so their local names cannot hide a member.
const std::set<std::string> apart = {
    "left", "i",     "open",      "line",         "lines", "number", "seconds", "argc",     "argv",           "message",
    "next", "main",  "nodiscard", "maybe_unused", "help",  "helped", "out",     "Base",     "Type",           "from",
    "to",   "given", "make",      "parts",        "path",  "python", "py",      "pybind11", "PYBIND11_MODULE"};

void expect_listed(const Emission& emission) {
    const std::set<std::string> types = own_type_names();
    const std::set<std::string> members = own_member_names();
    for (const OutputFile& file : emission.files) {
        const bool code = file.path.ends_with(".hpp") || file.path.ends_with(".cpp");
        const bool shipped = file.path.find("robochart/") != std::string::npos;
        // In projects for simulators, only robot.hpp sees members of the generated class. In a package of ROS 2, the
        // node sees them, too, but its own names do not occur in the class (tests/cpp_emit/ros2/node_test.cpp).
        const bool node =
            file.path.starts_with("src/") || file.path.starts_with("include/") || file.path.starts_with("test/");
        // python_values.hpp has its own namespace.
        const bool project = file.path == "body.hpp" || file.path == "python_values.hpp" || node ||
                             file.path == "controller.cpp" ||
                             (file.path == "main.cpp" && file.text.find("Enki") != std::string::npos);
        if (!code || shipped || project) continue;
        const bool core = file.path.ends_with("_core.hpp") || file.path.ends_with("_trace.hpp") ||
                          file.path.ends_with("_layout.hpp") || file.path.ends_with("_explore.cpp");
        for (const std::string& word : own_identifiers(file.text)) {
            if (of_the_model(word) || apart.count(word) != 0 || reserved_in_cpp(word)) continue;
            if (is_numbered(word, "all_values_") || is_numbered(word, "deadline_") || is_numbered(word, "step_") ||
                is_numbered(word, "stuck_") || is_numbered(word, "ValueOf"))
                continue;
            EXPECT_TRUE((core ? types : members).count(word) != 0) << word << " in " << file.path;
        }
    }
}

TEST(Names, IdentifiersOfGeneratedCodeAreReserved) {
    for (const char* name : {"marked", "marked_messages"}) {
        const ir::System system = testing::load_model(contents(std::string("tests/cpp_emit/models/") + name + ".rct"));
        for (const Target target : {Target::sources, Target::library, Target::main, Target::ros2, Target::enki,
                                    Target::argos, Target::python})
            for (const bool choices : {false, true})
                for (const char* component : {"ZqM", "ZqAlone"}) {
                    if (target == Target::ros2 && std::string(name) == "marked") continue;  // it has no messages
                    Options options;
                    options.target = target;
                    options.choices = choices;
                    expect_listed(testing::emit_ok(system, testing::component_named(system, component), options));
                }
    }
}

// ---- models with such names in every position

std::string list_names(const std::vector<std::string>& names, const std::string& before, const std::string& after) {
    std::string text;
    for (const std::string& name : names) text += before + "^" + name + after;
    return text;
}

/// Returns the text of a project that uses each of the names for a package, a type, a literal, a field, an interface, a
/// variable, a clock, an event, an operation, a parameter, a function, a state, a transition and a machine. A keyword
/// of RoboChart gets the `^` that makes it a name.
std::string project_with_names(const std::string& package, const std::vector<std::string>& names) {
    std::string literals = list_names(names, " ", "");
    std::string types, shown, states, uses;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string n = "^" + names[i];
        const std::string number = std::to_string(i);
        types += "enumeration " + n + " { one two }\n";
        shown += " var v" + number + " : " + n + " event c" + number + " : " + n + "\n";
        uses += " transition u" + number + " { from A to A trigger c" + number + "?v" + number + " condition v" +
                number + " == " + n + "::one }\n";
        states += " state " + n + " { entry e }\n transition " + n + " { from A to " + n +
                  " trigger e }\n transition back" + number + " { from " + n + " to A }\n";
    }
    std::string calls, gotten, assigned;
    for (const std::string& name : names) {
        calls += "^" + name + "(1); ";
        gotten += " transition ^" + name + " { from A to A trigger ^" + name + "?x action ^" + name + "!x }\n";
        assigned += "^" + name + " = ^" + name + " + 1; ";
    }
    const std::string begin = " initial ii state A { } transition tt { from ii to A }\n";
    std::string text = "package ^" + package + "\n" + types + "enumeration Literals {" + literals + " }\n";
    text += "datatype Fields {" + list_names(names, " ", " : nat") + " }\n";
    text += "interface Calls {" + list_names(names, " ", "(^" + names.front() + " : nat)") + " }\n";
    text += "interface Changes {" + list_names(names, " var ", " : nat") + " }\n";
    text += list_names(names, "interface ", " { event e }\n");
    text += "stm Types {\n" + shown + begin + uses + "}\n";
    text += "stm OfLiterals { var l : Literals event l1 : Literals event l2" + begin +
            " transition t { from A to A trigger l1?l condition l == Literals::^" + names.front() +
            " }\n transition t2 { from A to A trigger l2 action l = Literals::^" + names.back() + " } }\n";
    text += "stm OfFields { var r : Fields event r1 : Fields event n1" + begin +
            " transition t { from A to A trigger r1?r condition r.^" + names.front() +
            " > 0 }\n transition t2 { from A to A trigger n1 action r.^" + names.back() + " = 1 } }\n";
    text += "stm Caller { requires Calls event e" + begin + " transition t { from A to A trigger e action " + calls +
            "skip } }\n";
    text += "stm Holder { event e requires Changes" + begin + " transition t { from A to A trigger e action " +
            assigned + "skip } }\n";
    text += "stm Own { event e event f : nat" + list_names(names, " var ", " : nat") + begin +
            " transition t { from A to A trigger e action " + assigned + "f!^" + names.front() + " } }\n";
    text += "stm Clocks { event e" + list_names(names, " clock ", "") + begin;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += " transition c" + std::to_string(i) + " { from A to A trigger e condition since(^" + names[i] +
                ") > 1 action #^" + names[i] + " }\n";
    text += "}\nstm Events { var x : nat" + list_names(names, " event ", " : nat") + begin + gotten + "}\n";
    text += "stm States { event e initial ii state A { } transition tt { from ii to A }\n" + states + "}\n";
    return text;
}

void compile_all(const std::string& text, const std::string& compiler) {
    const Folder folder;
    const ir::System system = testing::load_model(text);
    std::string sources;
    for (const ir::Machine& machine : system.machines) {
        if (machine.kind != ir::MachineKind::state_machine) continue;
        Options options;
        if (machine.name == "OfFields") options.target = Target::main;  // too many values to be explored
        options.explored = options.target == Target::sources;
        const Emission emission = testing::emit_ok(system, testing::component_named(system, machine.name), options);
        Emission placed = emission;
        for (OutputFile& file : placed.files) file.path = machine.name + "_dir/" + file.path;
        folder.write(placed);
        for (const OutputFile& file : placed.files)
            if (file.path.ends_with(".cpp"))
                sources += compiler + " -std=c++17 -fsyntax-only -Wall -Wextra -Werror -I " + machine.name +
                           "_dir -I " + machine.name + "_dir/controller " + file.path + " && ";
    }
    std::string output;
    EXPECT_EQ(folder.status(sources + "true", output), 0) << compiler << "\n" << output.substr(0, 4000);
}

std::vector<std::string> sample_names(std::span<const std::string_view> names, std::size_t step, std::size_t first) {
    std::vector<std::string> result;
    for (std::size_t i = first; i < names.size(); i += step) result.emplace_back(names[i]);
    return result;
}

/// Each of the two compilers takes half of the sampled names.
class NamesEverywhere : public ::testing::TestWithParam<const char*> {
protected:
    [[nodiscard]] static bool is_gcc() { return std::string(GetParam()) == "g++"; }
};

TEST_P(NamesEverywhere, OfGeneratedCode) {
    const std::size_t first = is_gcc() ? 0 : 2;
    std::vector<std::string> names = sample_names(reserved_own_types(), 4, first);
    for (const std::string& name : sample_names(reserved_own_members(), 4, first))
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    for (const char* name : {"Int", "Nat", "Real", "Types", "inputs", "value", "step", "Robot", "Body"})
        if (std::ranges::find(names, name) == names.end()) names.emplace_back(name);
    compile_all(project_with_names("read", names), GetParam());
}

TEST_P(NamesEverywhere, OfTheLanguageAndItsHeaders) {
    std::vector<std::string> names = {
        "alignas", "class",    "co_await",        "delete",     "final",    "import", "double", "namespace",
        "new",     "operator", "override",        "requires",   "template", "this",   "union",  "while",
        "xor",     "std",      "robochart",       "assert",     "errno",    "BUFSIZ", "EOF",    "EXIT_SUCCESS",
        "NULL",    "SEEK_SET", "ROBOCHART_TRACE", "RC_REQUIRE", "stdin",    "time",   "abort"};
    for (const std::string& name : sample_names(reserved_macros(), 120, is_gcc() ? 0 : 60))
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    compile_all(project_with_names("time", names), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Compilers, NamesEverywhere, ::testing::Values("g++", "clang++"),
                         [](const auto& tested) { return std::string(tested.param) == "g++" ? "gcc" : "clang"; });

TEST(NamesOfPackages, AreTheirComponentsToo) {
    for (const char* package : {"S", "S_core", "main", "signal", "core", "robochart::S", "std", "Body"})
        compile_all("package " + std::string(package) +
                        "\nenumeration Side { left right }\nstm S { event e : Side var x : Side initial i state A { }\n"
                        "transition t0 { from i to A } transition t { from A to A trigger e?x } }\n",
                    "g++");
}

}  // namespace
}  // namespace robochart::cpp_emit::names_test
