// SPDX-License-Identifier: Apache-2.0
// Compiles all code that is generated for the corpus. It must compile without warnings on both compilers, and the
// controller also without exceptions and RTTI. A scripted run must be clean under AddressSanitizer and UBSan.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::cpp_emit::compile_test {
namespace {

using testing::Folder;

struct Case {
    const char* model;
    const char* component;
    const char* machine;  ///< name of the class
    const char* script;   ///< lines for the console driver
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.component;
}

class Compiles : public ::testing::TestWithParam<Case> {
protected:
    void SetUp() override {
        const ir::System system = testing::load_corpus(GetParam().model);
        folder_.write(testing::emit_ok(system, testing::component_named(system, GetParam().component)));
    }

    void expect_clean(const std::string& compiler) const {
        std::string ignored;
        if (folder_.status(compiler + " --version", ignored) != 0) GTEST_SKIP() << compiler << " is not installed";
        const std::string strict =
            compiler + " -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I. -c ";
        folder_.run(strict + "-fno-exceptions -fno-rtti *_explore.cpp " + GetParam().machine + ".cpp");
        folder_.run(strict + "main.cpp");
    }

    Folder folder_;
};

TEST_P(Compiles, WithGcc) {
    expect_clean("g++");
}
TEST_P(Compiles, WithClang) {
    expect_clean("clang++");
}

TEST_P(Compiles, AndRunsCleanUnderSanitizers) {
    folder_.run(std::string("c++ -std=c++17 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -I. main.cpp ") +
                GetParam().machine + ".cpp -o console");
    const std::string output = folder_.run(std::string("printf '") + GetParam().script + "' | ./console");
    EXPECT_EQ(output.find("not an input"), std::string::npos) << output;
    EXPECT_NE(output.find("cycle 4"), std::string::npos) << output;
}

const char* const aggregation_script = "\\nseeRobot\\nseeRobot seeWall\\n\\nseeWall\\n";
const char* const taxis_script =
    "\\nillumination=true\\nrobotDetected\\nheading=0.2\\n\\nturned\\nillumination=false\\n";
// The machine alone does not use `turned`, because the operation Turn then belongs to the platform.
const char* const machine_script = "\\nillumination=true\\nrobotDetected\\nheading=0.2\\n\\n";

INSTANTIATE_TEST_SUITE_P(Corpus, Compiles,
                         ::testing::Values(Case{"aggregation", "AggregationFSM", "AggregationFSM", aggregation_script},
                                           Case{"aggregation", "Aggregation", "AggregationFSM", aggregation_script},
                                           Case{"swarm_taxis", "SwarmTaxisFSM", "SwarmTaxisFSM", machine_script},
                                           Case{"swarm_taxis", "SwarmTaxis", "SwarmTaxisFSM", taxis_script}),
                         [](const auto& test) { return test.param.component; });

/// Combines all constructs that leave an item of the code unused or empty: no inputs, an inner final node below a
/// during action, operations without body, declared types, names of C++.
const char* const odd = R"(package new::p
type Token
enumeration Light { Red default }
interface I { var shown : Light op(class : Token) idle() }
operation op(class : Token) { terminates }
operation idle() { requires J initial i state S { during wait(1) } final F
    transition t0 { from i to S } transition t1 { from S to F condition sinceEntry(S) > 1 } }
interface J { var count : int }
stm M { requires I requires J event out : Light var token : Token initial i
    state O { initial i final f transition t0 { from i to f } during out!shown ; shown = Light::default exit count = count + 1 }
    state P { entry op(token) ; idle() }
    transition t0 { from i to O } transition t1 { from O to P condition sinceEntry(O) >= 1 } transition t2 { from P to O } }
controller C { requires I requires J event out : Light sref m = M opref o = op opref d = idle connection m on out to C on out }
)";

TEST(Compile, OddMachines) {
    const ir::System system = testing::load_model(odd);
    for (const char* name : {"M", "C"}) {
        Folder folder;
        folder.write(testing::emit_ok(system, testing::component_named(system, name)));
        for (const char* compiler : {"g++", "clang++"}) {
            std::string ignored;
            if (folder.status(std::string(compiler) + " --version", ignored) != 0) continue;
            folder.run(
                compiler +
                std::string(
                    " -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I. -fsyntax-only *.cpp"));
        }
    }
}

/// Sets have a greater capacity in deployed code than in code for `conform`. In both, the code asserts that the state
/// has no padding.
TEST(Compile, StatesWhoseSizeDependsOnTheTypesHaveNoPadding) {
    const ir::System system = testing::load_model(R"(
type ID
record Seen { ids : Set(ID) far : real }
interface I { event hear : ID event tell : Seen }
stm M { uses I clock C var n : nat, near : Set(ID), last : ID, seen : Seen, some : Seq(ID)
    initial i state S { entry #C }
    transition t0 { from i to S }
    transition t1 { from S to S trigger hear?last condition since(C) > 2 action near = {last}; n = n + 1 }
    transition t2 { from S to S trigger tell?seen action some = <last>; near = seen.ids } }
controller K { uses I sref m = M connection K on hear to m on hear connection K on tell to m on tell }
)");
    for (const char* name : {"M", "K"}) {
        Folder folder;
        folder.write(testing::emit_ok(system, testing::component_named(system, name)));
        folder.run(
            "for f in *_layout.hpp *_explore.cpp; do echo \"#include \\\"$f\\\"\" |"
            " c++ -std=c++17 -Wall -Wextra -Werror -I. -fsyntax-only -x c++ - || exit 1; done");
    }
}

/// Some parameters of operations and functions have the name of a variable of the class.
TEST(Compile, ParametersMayBeCalledAsVariables) {
    const ir::System system = testing::load_model(
        "function far(speed : real) : boolean { }\n"
        "interface I { var speed : real go(speed : real) }\ninterface J { turn(speed : real) }\n"
        "operation turn(speed : real) { initial i final f transition t { from i to f } }\n"
        "stm M { requires I requires J event e initial i state A { entry go(1); turn(2) }\n"
        " transition t { from i to A } transition u { from A to A trigger e condition far(speed) } }\n"
        "controller C { requires I uses E sref m = M opref o = turn connection C on e to m on e }\n"
        "interface E { event e }\n");
    Folder folder;
    folder.write(testing::emit_ok(system, testing::component_named(system, "C")));
    for (const char* compiler : {"g++", "clang++"}) {
        std::string ignored;
        if (folder.status(std::string(compiler) + " --version", ignored) != 0) continue;
        folder.run(compiler +
                   std::string(" -std=c++17 -Wall -Wextra -Wpedantic -Wshadow -Werror -I. -fsyntax-only *.cpp"));
    }
}

/// These comparisons are always true or always false: of literals, of constants, of a value with itself, and of
/// mutually exclusive values. A model may contain them, and they must compile without warnings.
constexpr const char* settled[] = {"n == n",
                                   "n != n",
                                   "n < n",
                                   "n <= n",
                                   "n < 0",
                                   "n >= 0",
                                   "0 > n",
                                   "n == 1 /\\ n == 2",
                                   "n != 1 \\/ n != 2",
                                   "n > 2 /\\ n < 1",
                                   "n < 2 \\/ n > 1",
                                   "n - n == 0",
                                   "n * 0 == 0",
                                   "n / n == 1",
                                   "n % n == 0",
                                   "n + 1 > n",
                                   "-z == z",
                                   "z < 0 /\\ z > 0",
                                   "n == z /\\ z == n",
                                   "Mode::L0 == md /\\ Mode::L1 == md",
                                   "md != Mode::L0 \\/ md != Mode::L1",
                                   "md == md",
                                   "Mode::L0 == Mode::L0",
                                   "Mode::L0 == Mode::L1",
                                   "r < r \\/ r >= r",
                                   "r == r",
                                   "r > 1.5 /\\ r < 0.5",
                                   "b /\\ not b",
                                   "b \\/ not b",
                                   "b iff b",
                                   "b => b",
                                   "b == b",
                                   "b == (not b)",
                                   "b == true",
                                   "b != false",
                                   "b == (b == true)",
                                   "b \\/ b \\/ b",
                                   "b /\\ (b \\/ c) /\\ b",
                                   "(n == 1) == (n == 2)",
                                   "(n < 1) == (n < 1)",
                                   "true",
                                   "false",
                                   "not true",
                                   "true == false",
                                   "1 == 1",
                                   "2 < 1",
                                   "k == 3",
                                   "k < k",
                                   "true /\\ (b \\/ true)",
                                   "if true then b else c end",
                                   "if b then true else true end",
                                   "(if b then n else n end) == (if b then n else n end)",
                                   "item == item /\\ item.a == item.a",
                                   "q == q",
                                   "q[1] == q[1]",
                                   "s == s",
                                   "v == v",
                                   "v[1] != v[1]",
                                   "p == p /\\ p[1] < p[1]",
                                   "b /\\ n == 1 /\\ n == 2",
                                   "b /\\ n + 1 == 1 /\\ n + 1 == -z /\\ n + 1 == 2",
                                   "b \\/ n != 1 \\/ n != 2",
                                   "b \\/ not (n == 1) \\/ not (2 == n)",
                                   "(b /\\ n == 1) => n != 2",
                                   "not ((b /\\ n == 1) => n != 2)",
                                   "b /\\ md == Mode::L0 /\\ md == Mode::L1 /\\ Mode::L0 == md",
                                   "b /\\ z == -1 /\\ z == 1",
                                   "b /\\ (n == 1 /\\ n == 2) /\\ n == 3",
                                   "b /\\ n == k /\\ n == 2",
                                   "b /\\ item.a == 1 /\\ item.a == 2",
                                   "since(T) >= 0",
                                   "since(T) < 0",
                                   "since(T) == since(T)",
                                   "n in {0 to n}",
                                   "n in {}",
                                   "n in {n}",
                                   "n in [n, n)",
                                   "exists x : nat @ (x == x \\/ x != x \\/ x < 0)",
                                   "let x == n @ (x == x /\\ x == n)",
                                   "f(n) == f(n)"};

TEST(Compile, ComparisonsThatAreSettled) {
    std::string text =
        "enumeration Mode { L0 L1 } record Item { a : nat b : boolean } function f(x : nat) : boolean { }\n"
        "stm S { const k : nat = 3 event e : nat clock T var n : nat var z : int var r : real var b : boolean\n"
        "var c : boolean var md : Mode var item : Item var q : Seq(nat) var s : Set(nat) var v : vector(nat, 2)\n"
        "var p : nat * boolean initial i state A { }\n"
        "state B { entry n = n; z = z; r = r; b = b; md = md; item = item; item.a = item.a; q = q; s = s; v[1] = "
        "v[1];\n"
        "p = p; z = k - k; b = (b == b) } transition t0 { from i to A }\n";
    int number = 0;
    for (const std::string condition : settled) {
        text += fmt::format("transition a{} {{ from A to B trigger e?n condition {} }}\n", ++number, condition);
        text +=
            fmt::format("transition c{} {{ from A to B trigger e[| n == 3 |]?n condition {} }}\n", number, condition);
        text += fmt::format("transition b{} {{ from B to A condition {}\n", number, condition);
        if (condition.starts_with("since")) {  // since is allowed only in guards
            text += "}\n";
        } else {
            text += fmt::format("action c = ({}); if {} then c = b end }}\n", condition, condition);
        }
    }
    const ir::System system = testing::load_model(text + "}");
    Folder folder;
    folder.write(testing::emit_ok(system, testing::component_named(system, "S")));
    for (const char* compiler : {"g++", "clang++"}) {
        std::string ignored;
        if (folder.status(std::string(compiler) + " --version", ignored) != 0) continue;
        for (const char* level : {"-O0", "-O2"})
            folder.run(fmt::format(
                "for f in *.cpp; do {} -std=c++17 {} -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I. "
                "-c -o object.o $f || exit 1; done",
                compiler, level));
    }
}

/// Compiles RoboTool's own models, if they are present.
TEST(Compile, RoboToolsModels) {
    namespace fs = std::filesystem;
    const fs::path suite = robochart::tests::shared_folder() / "suite/robotool/accept";
    if (!fs::is_directory(suite)) GTEST_SKIP() << "the shared models are absent";
    std::set<fs::path> projects(fs::directory_iterator(suite), fs::directory_iterator{});
    std::size_t generated = 0;
    Folder folder;
    for (const fs::path& project : projects) generated += testing::emit_all(project.string(), folder);
    EXPECT_GE(generated, 45U);
    folder.run(
        "for d in */; do (cd $d && c++ -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Werror -fno-exceptions "
        "-fno-rtti"
        " -I.. -I. -fsyntax-only *_explore.cpp) || exit 1; done");
}

}  // namespace
}  // namespace robochart::cpp_emit::compile_test
