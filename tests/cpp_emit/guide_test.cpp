// SPDX-License-Identifier: Apache-2.0
// Tests docs/cpp.md. Extracts its programs, compiles them with the generated code as C++17 and C++20, and compares
// their output with the page. Also compares the layout table with states of every kind.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"
#include "tests/source_folder.hpp"

namespace robochart::cpp_emit::guide_test {
namespace {

using testing::Folder;

/// Returns the next block of a language after a position of the page.
std::string next_block(const std::string& page, const std::string& language, std::size_t& from) {
    const std::string fence = "```" + language + "\n";
    const std::size_t begin = page.find(fence, from);
    EXPECT_NE(begin, std::string::npos);
    if (begin == std::string::npos) return {};
    const std::size_t end = page.find("```\n", begin + fence.size());
    from = end;
    return page.substr(begin + fence.size(), end - begin - fence.size());
}

void run_guide_program(const std::string& program, const std::string& model, const std::string& component,
                       const std::string& sources) {
    std::ostringstream page;
    page << std::ifstream(tests::source_folder().string() + "/docs/cpp.md").rdbuf();
    std::size_t at = page.str().find("// program: " + program);
    ASSERT_NE(at, std::string::npos) << "docs/cpp.md has no program " << program;
    at = page.str().rfind("```cpp", at);
    const std::string text = next_block(page.str(), "cpp", at);
    const std::string expected = next_block(page.str(), "text", at);
    const ir::System system = testing::load_corpus(model);
    Folder folder;
    folder.write(testing::emit_ok(system, testing::component_named(system, component)));
    std::ofstream(folder.path() + "/program.cpp") << text;
    for (const char* standard : {"17", "20"}) {
        folder.run(std::string("c++ -O0 -Wall -Wextra -Wpedantic -Werror -std=c++") + standard + " -I. program.cpp " +
                   sources + " -o program");
        EXPECT_EQ(folder.run("./program"), expected) << "C++" << standard;
    }
}

TEST(Guide, TheClassApi) {
    run_guide_program("paper", "swarm_taxis", "SwarmTaxis", "SwarmTaxisFSM.cpp");
}

TEST(Guide, TheCoreApi) {
    run_guide_program("lean", "aggregation", "Aggregation", "");
}

TEST(Guide, OneEventAtATime) {
    run_guide_program("events", "aggregation", "AggregationFSM", "");
}

TEST(Guide, TheTraceHook) {
    run_guide_program("traced", "aggregation", "Aggregation", "AggregationFSM.cpp -DROBOCHART_TRACE=1");
}

/// In C++20 the compiler names each method that a platform lacks or that may throw.
TEST(Guide, ThePlatformIsAConcept) {
    const ir::System system = testing::load_corpus("aggregation");
    Folder folder;
    folder.write(testing::emit_ok(system, testing::component_named(system, "Aggregation")));
    std::ofstream(folder.path() + "/user.cpp") << R"(#include "Aggregation_core.hpp"
namespace core = aggregation::Aggregation_core;
using Types = robochart::Deployment;
struct Good {
    bool replaces_MoveClockwise(double, double) noexcept { return false; }
    bool replaces_RotateClockwise(double) noexcept { return false; }
    void set_linearSpeed(double) noexcept {}
    void set_angularSpeed(double) noexcept {}
};
struct Throwing : Good { void set_linearSpeed(double) {} };
struct Lacking {};
static_assert(core::PlatformOf<Good, Types>);
static_assert(!core::PlatformOf<Throwing, Types>);
static_assert(!core::PlatformOf<Lacking, Types>);
#ifdef LACKING
int main() { auto state = core::init<Types>(); core::Inputs<Types> inputs; Lacking platform; core::step(state, inputs, platform); }
#endif
)";
    folder.run("c++ -std=c++20 -I. -fsyntax-only user.cpp");
    std::string output;
    EXPECT_NE(folder.status("c++ -std=c++20 -DLACKING -I. -fsyntax-only user.cpp", output), 0);
    EXPECT_NE(output.find("the platform lacks a method"), std::string::npos) << output;
}

/// The states have records, sequences, several machines and buffers. For both kinds of types, every byte belongs to
/// exactly one row of the table.
TEST(Guide, TheLayoutCoversEveryState) {
    const ir::System system = testing::load_model(R"(package p
enumeration Light { Red Green Blue }
datatype Point { x : int  y : int }
interface I { var shown : Light }
interface E { event go : Point event back }
stm A { requires I uses E var p : Point var all : Seq(nat) clock C initial i state S { }
    transition t0 { from i to S } transition t1 { from S to S trigger go?p #C condition since(C) < 3 action all = <1> ^ all ; shown = Light::Blue } }
stm B { event back event out : nat var n : nat initial i state S { entry wait(2) }
    transition t0 { from i to S } transition t1 { from S to S trigger back action n = n + 1 ; out!n } }
controller C { requires I uses E event out : nat sref a = A sref b = B
    connection C on go to a on go connection C on back to b on back connection b on out to C on out }
)");
    for (const char* name : {"A", "B", "C"}) {
        Folder folder;
        folder.write(testing::emit_ok(system, testing::component_named(system, name)));
        const std::string core = std::string("p::") + name + "_core";
        std::ofstream(folder.path() + "/user.cpp")
            << "#include \"" << name << "_layout.hpp\"\n#include \"robochart/finite.hpp\"\n"
            << "struct Small { using Real = float; using Nat = std::int16_t; using Int = std::int8_t; "
               "static constexpr std::size_t longest = 3; };\n"
            << "static_assert(sizeof(" << core << "::State<Small>) <= sizeof(" << core
            << "::State<robochart::Deployment>));\n"
            << "int main() {\n    int places = 0;\n    for (const auto& row : " << core
            << "::layout<robochart::Deployment>)\n"
               "        if (row.kind == robochart::FieldKind::enumeration && row.high > 0) ++places;\n"
               "    return places > 0 ? 0 : 1;\n}\n";
        folder.run("c++ -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Werror -I. user.cpp -o user && ./user");
    }
}

}  // namespace
}  // namespace robochart::cpp_emit::guide_test
