// SPDX-License-Identifier: Apache-2.0
// Tests `emit rst`. Every construct that RoboSim can express is written, read back and proved equal to the component in
// cycles. A fault in the text makes a claim fail. Other constructs are refused by name (docs/robosim.md).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "tests/app/command.hpp"
#include "tests/contents.hpp"
#include "tests/rounds.hpp"
#include "tests/shared_folder.hpp"
#include "tests/source_folder.hpp"

namespace robochart::app::testing::emit_rst_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Small models with a few constructs each. The component is `S`, `C` or `M`.
struct Example {
    const char* name;
    const char* component;
    const char* text;
    const char* cycle = "1";
    bool equal = true;
};

std::ostream& operator<<(std::ostream& out, const Example& example) {
    return out << example.name;
}

const Example examples[] = {
    {"ValuesAndGuards", "S",
     "stm S { event e : nat event o : nat var x : nat initial i state A { } state B { entry o!x ; wait(1) }\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to B trigger e?x condition x > 0 }\n"
     "transition t2 { from B to A } }\n"},
    {"BlockedAtAJunction", "S",
     "stm S { event e : nat event o : nat event p clock C var x : nat initial i state A { } junction j\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to j trigger e?x #C }\n"
     "transition t2 { from j to A condition x > 1 action o!x }\n"
     "transition t3 { from j to A condition x == 1 /\\ since(C) > 1 action p } }\n"},
    {"SameInputTwice", "S",
     "stm S { event e event o event p initial i state A { } state B { } state D { entry wait(1) }\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to B trigger e action o }\n"
     "transition t2 { from B to D trigger e action p }\n"
     "transition t3 { from D to A } }\n"},
    {"LongWaits", "S",
     "stm S { event o event p const d : nat = 5 initial i state A { entry o ; wait(d) ; p ; wait(1) }\n"
     "state B { entry wait([1, 2]) }\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to B action wait(4) ; o }\n"
     "transition t2 { from B to A action wait(2) } }\n"},
    {"InputInAnAction", "S",
     "stm S { event e : nat event o : nat var x : nat initial i state A { entry e?x ; o!x ; wait(1) }\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to A condition x > 0 }\n"
     "transition t2 { from A to A condition x == 0 action wait(1) } }\n"},
    {"ChoicesWithWaits", "S",
     "stm S { event e : boolean event o event p var b : boolean initial i state A { } state B { entry p }\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to B trigger e?b action if b then o ; wait(5) else wait(1) end }\n"
     "transition t2 { from B to A trigger e?b action wait(1) } }\n"},
    {"NestedStates", "S",
     "stm S { event e event f event o event p initial i\n"
     "state A { initial j state B { exit o } state D { } final F\n"
     "transition u0 { from j to B } transition u1 { from B to D trigger e } transition u2 { from D to F trigger e }\n"
     "exit p }\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to A trigger f action wait(1) } }\n"},
    {"DuringActions", "S",
     "stm S { event e event o event p initial i\n"
     "state A { during o } state B { entry p ; wait(1) }\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to B trigger e }\n"
     "transition t2 { from B to A } }\n",
     "1", false},
    {"ClocksAndEntries", "S",
     "stm S { event e event o event p clock T initial i state A { } state B { entry wait(1) }\n"
     "transition t0 { from i to A #T }\n"
     "transition t1 { from A to B trigger e #T condition since(T) > 1 action o }\n"
     "transition t2 { from A to B condition sinceEntry(A) >= 4 action p }\n"
     "transition t3 { from B to A } }\n"},
    {"JunctionsAndProbability", "S",
     "stm S { event e : nat event o event p var x : nat initial i state A { } junction j probabilistic k\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to j trigger e?x }\n"
     "transition t2 { from j to k condition x > 0 }\n"
     "transition t3 { from j to A condition x == 0 action wait(1) }\n"
     "transition t4 { from k to A probability 0.5 action o ; wait(1) }\n"
     "transition t5 { from k to A probability 0.5 action p ; wait(1) } }\n"},
    {"Termination", "S",
     "stm S { event e event o initial i state A { } final F\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to F trigger e action o } }\n"},
    {"DeadlinesThatAreMet", "S",
     "stm S { event e event o initial i state A { } state B { entry ( o <{ 0 } ; wait(2) ) <{ 2 } }\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to B trigger e }\n"
     "transition t2 { from B to A } }\n"},
    {"ReservedWords", "S",
     "stm S { event input : nat event output : nat event exec var cycle : nat initial i\n"
     "state context { } state B { entry output!cycle ; exec ; wait(1) }\n"
     "transition t0 { from i to context }\n"
     "transition cycleDef { from context to B trigger input?cycle condition cycle > 1 }\n"
     "transition t2 { from B to context } }\n"},
    {"LongerCycles", "S",
     "stm S { event e event o event p initial i state A { } state B { entry o ; wait(4) ; p }\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to B trigger e }\n"
     "transition t2 { from B to A action wait(2) } }\n",
     "2"},
    {"SharedVariables", "S",
     "interface V { var v : nat }\n"
     "stm S { requires V event e event o : nat initial i state A { } state B { entry o!v ; wait(1) }\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to B trigger e action v = 1 }\n"
     "transition t2 { from B to A } }\n",
     "1", false},
    {"Operations", "M",
     "interface Arm { lift(h : nat) var height : nat = 0 }\n"
     "interface Soft { twice(h : nat) }\n"
     "interface Local { var last : nat clock T }\n"
     "robotic platform R { provides Arm event e : nat event done }\n"
     "operation twice(h : nat) { requires Arm requires Local initial i final F\n"
     "state A { entry lift(h) ; height = last + h } state B { }\n"
     "transition t0 { from i to A } transition t1 { from A to B action wait(h) ; #T }\n"
     "transition t2 { from B to F condition since(T) >= 1 } }\n"
     "stm S { requires Arm requires Soft event e : nat event done clock T var last : nat = 1 initial i state A { }\n"
     "state B { entry twice(last) ; done }\n"
     "transition t0 { from i to A }\n"
     "transition t1 { from A to B trigger e?last condition height < 2 }\n"
     "transition t2 { from B to A action wait(1) } }\n"
     "controller C { requires Arm event e : nat event done opref t = twice sref s = S\n"
     "connection C on e to s on e connection s on done to C on done }\n"
     "module M { rref r = R cref c = C connection r on e to c on e (_async)\n"
     "connection c on done to r on done (_async) }\n"},
    {"IndependentMachines", "C",
     "stm S { event e event o initial i state A { } transition t0 { from i to A }\n"
     "transition t1 { from A to A trigger e action o ; wait(1) } }\n"
     "controller C { event e event o event f event p sref s = S sref t = S\n"
     "connection C on e to s on e connection s on o to C on o\n"
     "connection C on f to t on e connection t on o to C on p }\n"},
};

class EmitRst : public ::testing::TestWithParam<Example> {
protected:
    static Ran emit(const Folder& folder, const Example& example) {
        return run({"emit", "rst", folder / "m.rct", "-o", folder / "out", "--component", example.component, "--cycle",
                    example.cycle, "--range", "nat=0..2", "-q"});
    }
    static std::string rst(const Folder& folder, const Example& example) {
        return folder / ("out/rst/" + std::string(example.component) + "_sim.rst");
    }
    static std::string rsa(const Folder& folder, const Example& example) {
        return folder / ("out/rst/" + std::string(example.component) + "_sim.rsa");
    }
};

TEST_P(EmitRst, IsReadBackAndProved) {
    const Example& example = GetParam();
    const Folder folder{{{"m.rct", example.text}}};
    const Ran emitted = emit(folder, example);
    ASSERT_EQ(emitted.exit, 0) << emitted.out << emitted.err;
    const std::string text = tests::read_contents(rst(folder, example));
    EXPECT_EQ(run({"format", "--check", rst(folder, example), rsa(folder, example)}).exit, 0) << text;
    const Ran valid = run({"validate", folder / "m.rct", rst(folder, example), rsa(folder, example)});
    EXPECT_EQ(valid.exit, 0) << valid.err << text;
    const Ran checked = run({"check", folder / "m.rct", rst(folder, example), rsa(folder, example), "--range",
                             "nat=0..2", "--timeout", "100", "-q"});
    EXPECT_EQ(checked.exit, 0) << checked.out << checked.err << text;
    EXPECT_THAT(checked.out, HasSubstr(example.equal ? "3 of 3 checks hold" : "2 of 2 checks hold"));
}

std::string name_of(const ::testing::TestParamInfo<Example>& info) {
    return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(, EmitRst, ::testing::ValuesIn(examples), name_of);

// ---------------------------------------------------------------- faults

/// A fault in the text of an example: the first occurrence of `good` becomes `bad`.
struct Fault {
    const char* example;
    const char* good;
    const char* bad;
};

const Fault faults[] = {
    {"ValuesAndGuards", "(x > 0)", "(x >= 0)"},
    {"ValuesAndGuards", "$o!x; exec", "$o!x"},
    {"ValuesAndGuards", "$o!x; exec", "$o!x; exec; exec"},
    {"ValuesAndGuards", "condition $e?x : (x > 0)", "condition $e"},
    {"ValuesAndGuards", "$o!x;", ""},
    {"SameInputTwice", "e_free = false", "e_free = true"},
    {"LongWaits", "< d", "<= d"},
    {"LongWaits", ">= d", "> d"},
    {"LongWaits", "< 2", "< 1"},
    {"LongWaits", "#waited", "skip"},
    {"InputInAnAction", "condition not $e", "condition true"},
    {"InputInAnAction", "$e?x", "$e"},
    {"ChoicesWithWaits", "not (b)", "b"},
    {"NestedStates", "exit $o", "exit skip"},
    {"NestedStates", " /\\ not $f", ""},
    {"NestedStates", "(not $e \\/ not e_free) /\\ ", ""},
    {"DuringActions", "not A_busy /\\ ", ""},
    {"DuringActions", "A_busy = false", "skip"},
    {"DuringActions", "A_busy = true", "skip"},
    {"ClocksAndEntries", "#A_since", "skip"},
    {"ClocksAndEntries", "since(T) > 1", "since(T) >= 1"},
    {"JunctionsAndProbability", "condition x > 0", "condition x > 1"},
    {"Termination", "final F", "state F {}"},
    {"Termination", "exec", ""},
    {"LongerCycles", "exec; exec", "exec"},
    {"SharedVariables", "$v = 1", "skip"},
    {"SharedVariables", "$o!$v", "$o!0"},
    {"Operations", "since(waited) < h", "since(waited) <= h"},
    {"Operations", "$height < 2", "true"},
};

/// Every fault makes a claim fail.
TEST(EmitRstFaults, AreNoticed) {
    for (const Fault& fault : faults) {
        const auto example = std::ranges::find(examples, std::string_view(fault.example),
                                               [](const Example& one) { return std::string_view(one.name); });
        ASSERT_NE(example, std::end(examples));
        SCOPED_TRACE(std::string(fault.example) + ": " + fault.good + " -> " + fault.bad);
        const Folder folder{{{"m.rct", example->text}}};
        ASSERT_EQ(run({"emit", "rst", folder / "m.rct", "-o", folder / "out", "--component", example->component,
                       "--cycle", example->cycle, "--range", "nat=0..2", "-q"})
                      .exit,
                  0);
        const std::string base = folder / ("out/rst/" + std::string(example->component) + "_sim");
        std::string text = tests::read_contents(base + ".rst");
        const std::size_t at = text.find(fault.good);
        ASSERT_NE(at, std::string::npos) << text;
        text.replace(at, std::string_view(fault.good).size(), fault.bad);
        std::ofstream(base + ".rst") << text;
        const Ran checked = run(
            {"check", folder / "m.rct", base + ".rst", base + ".rsa", "--range", "nat=0..2", "--timeout", "100", "-q"});
        EXPECT_NE(checked.exit, 0) << text << checked.out;
        EXPECT_THAT(checked.out, HasSubstr("FAILS")) << checked.err;
    }
}

// ---------------------------------------------------------------- case studies

/// The files of every module of the corpus are valid and in the standard layout. The claims of the small modules hold.
/// The commands in the documents prove those of aggregation.
TEST(EmitRstCorpus, IsReadBackAndProved) {
    const std::string corpus = (tests::source_folder() / "corpus").string();
    for (const auto& [model, module] : std::vector<std::pair<std::string, std::string>>{{"aggregation", "Aggregation"},
                                                                                        {"alpha", "Robot"},
                                                                                        {"best_of_n", "Robot"},
                                                                                        {"foraging", "Robot"},
                                                                                        {"moving_beacon", "Beacon"}}) {
        SCOPED_TRACE(model);
        const Folder out;
        const std::string text = corpus + "/" + model + "/" + model + ".rct";
        ASSERT_EQ(run({"emit", "rst", text, "-o", out / "out", "-q"}).exit, 0);
        const std::string base = out / ("out/rst/" + module + "_sim");
        EXPECT_EQ(run({"format", "--check", base + ".rst", base + ".rsa"}).exit, 0);
        EXPECT_EQ(run({"validate", text, base + ".rst", base + ".rsa"}).exit, 0);
        if (model != "moving_beacon" && model != "best_of_n") continue;
        const Ran checked = run({"check", text, base + ".rst", base + ".rsa", "--assertion", module + "_*", "-q"});
        EXPECT_THAT(checked.out, HasSubstr("3 of 3 checks hold")) << checked.err;
    }
}

/// A module, controller or state machine of a folder with a model.
struct Component {
    std::string folder, name;
};

/// The components in the corpus and, if they are there, in the suites beside the repository.
std::vector<Component> components_of_suites() {
    namespace fs = std::filesystem;
    std::vector<Component> result;
    std::set<std::pair<std::string, std::string>> found;
    const std::regex declared(R"((?:module|controller|stm)\s+(\w+)\s*\{)");
    const fs::path suites = tests::shared_folder() / "suite";
    for (const fs::path& root :
         {tests::source_folder() / "corpus", suites / "robotool/accept", suites / "claims", suites / "data"}) {
        if (!fs::exists(root)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root)) {
            if (entry.path().extension() != ".rct") continue;
            const std::string text = tests::read_contents(entry.path().string());
            for (auto at = std::sregex_iterator(text.begin(), text.end(), declared); at != std::sregex_iterator(); ++at)
                found.emplace(entry.path().parent_path().string(), (*at)[1]);
        }
    }
    for (const auto& [folder, name] : found) result.push_back({folder, name});
    return result;
}

/// What `emit rst` does with a component, and what the claims are found to be.
enum class Answer { proved, one_way, limit, refused, not_alone, wrong };

/// The component has no form in RoboSim (RC-Y17), or cannot be run in cycles (RC-Y18).
bool is_refusal(const Ran& emitted) {
    const std::string& text = emitted.err;
    return emitted.exit == 2 && (text.find("RC-Y17") != std::string::npos || text.find("RC-Y18") != std::string::npos);
}

/// The written files without their extension; "" if there are none.
std::string written_files(const Folder& out) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(out.path()))
        if (entry.path().extension() == ".rsa") return entry.path().parent_path() / entry.path().stem();
    return "";
}

Answer answer_of(const Component& component, const std::string& most_states) {
    const Folder out;
    const Ran emitted = run({"emit", "rst", component.folder, "-o", out.path(), "--component", component.name});
    if (emitted.exit == 4) return Answer::not_alone;  // it is declared inside another component
    if (is_refusal(emitted)) return Answer::refused;
    const std::string base = written_files(out);
    EXPECT_EQ(emitted.exit, 0) << emitted.out << emitted.err;
    if (emitted.exit != 0 || base.empty()) return Answer::wrong;
    const bool one_way = emitted.out.find("but not the reverse: ") != std::string::npos;
    std::string claims = std::filesystem::path(base).stem().string();
    claims.resize(claims.size() - 4);  // without "_sim"
    std::vector<std::string> arguments{
        "check",       component.folder,        base + ".rst", base + ".rsa",      "-q", "--max-states", most_states,
        "--assertion", claims + "_schedulable", "--assertion", claims + "_refines"};
    if (!one_way) arguments.insert(arguments.end(), {"--assertion", claims + "_is_refined"});
    const Ran checked = run(arguments);
    if (checked.exit == 3) return Answer::limit;
    const char* const all = one_way ? "2 of 2 checks hold" : "3 of 3 checks hold";
    EXPECT_EQ(checked.exit, 0) << checked.out << checked.err;
    EXPECT_THAT(checked.out, HasSubstr(all));
    if (checked.exit != 0) return Answer::wrong;
    return one_way ? Answer::one_way : Answer::proved;
}

/// Every component of the suites is written and proved, in both directions or in one with the reason; or it is refused
/// with a rule; or the claims need more states than the limit. No claim fails. All components with
/// ROBOCHART_ALL_ROUNDS, a few with few states otherwise.
TEST(EmitRstSuite, EveryComponentIsProvedOrRefused) {
    const std::vector<Component> components = components_of_suites();
    const bool all = tests::rounds(3) == 3;
    std::map<Answer, std::size_t> count;
    for (std::size_t i = 0; i < components.size(); i += all ? 1 : 12) {
        SCOPED_TRACE(components[i].folder + " " + components[i].name);
        ++count[answer_of(components[i], all ? "2000000" : "5000")];
    }
    EXPECT_EQ(count[Answer::wrong], 0U);
    EXPECT_GE(count[Answer::proved], 1U);
    if (all && !tests::shared_folder().empty()) {
        EXPECT_GE(count[Answer::proved], 25U);
    }
}

// ---------------------------------------------------------------- refusals

struct Refusal {
    const char* text;
    const char* message;
    const char* cycle = "1";
};

TEST(EmitRstRefusals, NameTheConstructAndTheCause) {
    const std::vector<Refusal> refusals = {
        {"stm S { event e initial i state A { } transition t0 { from i to A }\n"
         "transition t1 { from A to A trigger e } }\n"
         "stm T { event e initial i state A { } transition t0 { from i to A }\n"
         "transition t1 { from A to A action e ; wait(1) } }\n"
         "controller C { sref s = S sref t = T connection t on e to s on e }\n",
         "the connection of `t` with `s` of `C` cannot be written in RoboSim"},
        {"stm C { event e initial i state A { } transition t0 { from i to A }\n"
         "transition t1 { from A to A trigger e action wait(1) ; e ; wait(1) } }\n",
         "event `e` of `C` cannot be written in RoboSim"},
        {"stm C { event o initial i state A { during wait(1) ; o } transition t0 { from i to A } }\n",
         "the during action of state `A` of `C` cannot be written in RoboSim"},
        {"stm C { event e initial i state A { } transition t0 { from i to A }\n"
         "transition t1 { from A to A trigger e <{ 3 } action wait(1) } }\n",
         "[RC-K08]"},
        {"stm C { event o initial i state A { entry o ; wait(3) } transition t0 { from i to A }\n"
         "transition t1 { from A to A } }\n",
         "a wait of `3` of `C` cannot be written in RoboSim: it may end between two cycles", "2"},
        {"stm C { initial i state A { } transition t0 { from i to A } transition t1 { from A to A } }\n", "[RC-K01]"},
        {"stm C { event o initial i state A { entry o } transition t0 { from i to A } transition t1 { from A to A } "
         "}\n",
         "[RC-K02]"},
        {"stm C { event e event o initial i state A { } transition t0 { from i to A }\n"
         "transition t1 { from A to A trigger e action o ; o } }\n",
         "[RC-K07]"},
    };
    for (const Refusal& refusal : refusals) {
        const Folder folder{{{"m.rct", refusal.text}}};
        const Ran ran = run({"emit", "rst", folder / "m.rct", "-o", folder / "out", "--component", "C", "--cycle",
                             refusal.cycle, "-q"});
        EXPECT_EQ(ran.exit, 2) << refusal.text;
        EXPECT_THAT(ran.err, HasSubstr(refusal.message)) << refusal.text;
    }
}

}  // namespace
}  // namespace robochart::app::testing::emit_rst_test
