// SPDX-License-Identifier: Apache-2.0
// Tests verdicts about all values (docs/data.md). Compares them with answers that were derived by hand, and with the
// finite instantiation.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <thread>

#include "semantics/data/kept_data.hpp"
#include "tests/app/command.hpp"
#include "tests/contents.hpp"
#include "tests/rounds.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::app::data_test {
namespace {

using testing::run;
using Json = nlohmann::json;

/// The answers to the core properties by "component property", and the number of classes by the first place of the
/// data.
struct Answers {
    std::map<std::string, std::string> verdicts;
    std::map<std::string, std::uint64_t> states;
    std::map<std::string, std::size_t> classes;
    std::map<std::string, std::string> kept;  ///< why data keep their carriers, by their first place
    std::set<std::string> bounded;            ///< claims whose answer depends on bounds
    std::set<std::string> free;               ///< claims that are decided with free values of computed data
    std::string text;
};

Answers answers_for(const std::string& model, std::vector<std::string> options = {}, const char* seconds = "60") {
    options.insert(options.begin(), {"check", model, "--core", "--no-cache", "--timeout", seconds, "--format", "json"});
    const auto ran = run(options);
    Answers result;
    result.text = ran.out + ran.err;
    const Json json = Json::parse(ran.out, nullptr, false);
    if (json.is_discarded()) return result;
    for (const Json& one : json.at("assertions")) {
        if (!one.contains("core")) continue;
        const std::string name =
            one["core"].at("component").get<std::string>() + " " + one["core"].at("property").get<std::string>();
        result.verdicts[name] = one.at("answer");
        result.states[name] = one.at("statistics").at("states");
        if (one.contains("basis")) result.bounded.insert(name);
        if (one.value("reason", "").starts_with("for all values")) result.free.insert(name);
    }
    for (const Json& data : json.value("data", Json::array())) {
        if (data.contains("classes"))
            result.classes[data.at("places").at(0)] = data.at("classes");
        else
            result.kept[data.at("places").at(0)] = data.at("carrier");
    }
    return result;
}

// ---------------------------------------------------------------- the shared models

struct Expected {
    std::string component, property, answer;
};

/// Reads the rows of ../shared/suite/data/EXPECTED.tsv that are about claims.
class SharedData : public ::testing::Test {
protected:
    static void expect(const std::string& model, const std::vector<Expected>& expected,
                       const std::map<std::string, std::size_t>& classes, std::uint64_t most_states) {
        const auto folder = tests::shared_folder() / "suite/data" / model;
        if (!std::filesystem::exists(folder)) GTEST_SKIP() << "../shared/suite/data is not there";
        const Answers found = answers_for(folder.string());
        for (const Expected& row : expected) {
            const std::string name = "state machine " + model + "::" + row.component + " " + row.property;
            ASSERT_TRUE(found.verdicts.contains(name)) << name << "\n" << found.text;
            EXPECT_EQ(found.verdicts.at(name), row.answer) << name << "\n" << found.text;
            EXPECT_LE(found.states.at(name), most_states) << name;
            EXPECT_TRUE(classes.empty() || !found.bounded.contains(name)) << name;
        }
        for (const auto& [place, count] : classes) {
            ASSERT_TRUE(found.classes.contains(place)) << place << "\n" << found.text;
            EXPECT_EQ(found.classes.at(place), count) << place;
        }
    }
};

constexpr auto stuck = "state machine S deadlock-free";
constexpr auto deadlock = "deadlock-free", divergence = "divergence-free", timelock = "timelock-free";

TEST_F(SharedData, AThermostatHasThreeClasses) {
    expect("hysteresis",
           {{"Thermostat", deadlock, "holds"},
            {"Thermostat", divergence, "holds"},
            {"Thermostat", timelock, "holds"},
            {"Thermostat", "Cooling is reachable", "holds"},
            {"Thermostat", "Impossible is reachable", "fails"}},
           {{"degrees", 3}}, 40);
}

TEST_F(SharedData, AGuardThatReadsAValueLaterHasThreeClasses) {
    expect("later_guard",
           {{"Later", deadlock, "holds"},
            {"Later", timelock, "holds"},
            {"Later", "Done is reachable", "holds"},
            {"Later", "Stuck is reachable", "fails"}},
           {}, 40);
}

TEST_F(SharedData, TwoAnglesHaveThirteenClasses) {
    expect("two_reals",
           {{"Planner", deadlock, "fails"},
            {"Planner", divergence, "holds"},
            {"Planner", timelock, "holds"},
            {"Planner", "every transition fires", "holds"}},
           {{"a", 13}}, 60);
}

TEST_F(SharedData, AScanOfAnyLengthHasFifteenClasses) {
    expect("scan_windows",
           {{"Detector", deadlock, "fails"},
            {"Detector", divergence, "holds"},
            {"Detector", timelock, "holds"},
            {"Detector", "every transition fires", "holds"}},
           {{"ranges", 15}}, 60);
}

TEST_F(SharedData, AScanOfOneLengthHasEightClassesAndOneForOtherLengths) {
    expect("scan_windows_closed",
           {{"Detector", deadlock, "holds"},
            {"Detector", divergence, "holds"},
            {"Detector", timelock, "holds"},
            {"Detector", "every transition fires", "holds"}},
           {{"ranges", 9}}, 60);
}

TEST_F(SharedData, CommandsOfSixNumbersHaveTheValuesThatOccur) {
    expect("twist_constants",
           {{"Cruise", deadlock, "holds"},
            {"Cruise", divergence, "holds"},
            {"Cruise", timelock, "holds"},
            {"Cruise", "T is reset before it is read", "holds"}},
           {{"t", 4}}, 40);
}

TEST_F(SharedData, PassedOnCommandsHaveTwoValues) {
    expect("priority_relay",
           {{"Relay", deadlock, "holds"},
            {"Relay", divergence, "holds"},
            {"Relay", timelock, "holds"},
            {"Relay", "T is reset before it is read", "holds"}},
           {{"first", 2}}, 100);
}

TEST_F(SharedData, AStoreOfRecordsIsDecided) {
    expect("store_list",
           {{"Recorder", deadlock, "holds"},
            {"Recorder", divergence, "holds"},
            {"Recorder", timelock, "holds"},
            {"Planner", deadlock, "fails"},
            {"Planner", divergence, "holds"},
            {"Planner", timelock, "holds"}},
           {}, 100);
}

/// Returns the result of conform for the only component.
Json conformance_of(const std::string& model, const std::vector<std::string>& more, int exit = 0) {
    std::vector<std::string> options{"conform", model, "--no-cache", "--walks", "300", "--format", "json"};
    options.insert(options.end(), more.begin(), more.end());
    const auto ran = run(options);
    EXPECT_EQ(ran.exit, exit) << ran.out << ran.err;
    const Json json = Json::parse(ran.out, nullptr, false);
    return json.is_discarded() ? Json() : json.at("conformance").at(0);
}

void expect_end_of_carriers(const Json& result) {
    ASSERT_FALSE(result.is_null());
    EXPECT_EQ(result.at("outcome"), "inconclusive") << result;
    EXPECT_THAT(result.at("reason").get<std::string>(),
                ::testing::AllOf(::testing::HasSubstr("a value leaves its carrier: "),
                                 ::testing::HasSubstr("no difference in "),
                                 ::testing::HasSubstr("of these walks ended where")));
}

/// The list that the model sends is one item longer than the list that it has received.
TEST_F(SharedData, AStoreOfListsConforms) {
    const auto folder = tests::shared_folder() / "suite/data/store_list";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "../shared/suite/data is not there";
    const Json result = conformance_of(folder.string(), {"--component", "Recorder"});
    EXPECT_EQ(result.value("outcome", ""), "conforms") << result;
    EXPECT_LE(result.value("codeStates", 1'000U), 100U) << result;
}

TEST(Carriers, OfListsThatAreBuiltContainThem) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm Log { event e : boolean event old : Seq(boolean) event out_ : Seq(boolean)\n"
        "var x : boolean var all : Seq(boolean) initial i state A { } transition t0 { from i to A }\n"
        "transition t1 { from A to A trigger e ? x action old ? all ; out_ ! (all ^ <x>) } }\n");
    EXPECT_EQ(conformance_of(model.path(), {}).value("outcome", ""), "conforms");
}

TEST(Carriers, ConformDoesNotDecideAListThatGrowsInALoop) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm Log { event e : boolean event out_ : Seq(boolean) var x : boolean var all : Seq(boolean) initial i\n"
        "state A { } transition t0 { from i to A }\n"
        "transition t1 { from A to A trigger e ? x action all = all ^ <x> ; out_ ! all } }\n");
    expect_end_of_carriers(conformance_of(model.path(), {}, 3));
}

TEST_F(SharedData, ScansOfAnyLengthConform) {
    for (const auto& [name, classes] : {std::pair("scan_windows", 15), std::pair("scan_windows_closed", 9)}) {
        const auto folder = tests::shared_folder() / "suite/data" / name;
        if (!std::filesystem::exists(folder)) GTEST_SKIP() << "../shared/suite/data is not there";
        const Json result = conformance_of(folder.string(), {});
        EXPECT_EQ(result.value("outcome", ""), "conforms") << result;
        ASSERT_EQ(result.value("data", Json::array()).size(), 1U) << result;
        EXPECT_EQ(result.at("data").at(0).value("classes", 0), classes) << result;
        EXPECT_TRUE(result.at("data").at(0).value("allValues", false)) << result;
    }
}

/// The list has no value because the carriers are finite, not because the model has a fault.
TEST(Carriers, AListThatGrowsBeyondThemIsNoFaultOfTheModel) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm Log { event e : boolean event out_ : Seq(boolean) var x : boolean var all : Seq(boolean) initial i\n"
        "state A { } transition t0 { from i to A }\n"
        "transition t1 { from A to A trigger e ? x action all = all ^ <x> ; out_ ! all } }\n");
    const Answers carriers = answers_for(model.path(), {"--concrete", "--untimed"}, "20");
    EXPECT_EQ(carriers.verdicts.at("state machine Log divergence-free"), "inconclusive") << carriers.text;
    EXPECT_THAT(carriers.text, ::testing::HasSubstr("a value leaves its carrier: "));
    const Answers all = answers_for(model.path(), {"--untimed"}, "20");
    EXPECT_EQ(all.verdicts.at("state machine Log divergence-free"), "holds") << all.text;
}

TEST_F(SharedData, AComparisonOfTwoVariablesHasTwoClasses) {
    expect("distance_limit",
           {{"Explore", deadlock, "holds"},
            {"Explore", divergence, "holds"},
            {"Explore", timelock, "holds"},
            {"Explore", "every transition fires", "holds"}},
           {{"d", 2}}, 31);
}

TEST_F(SharedData, AHeadingAgainstAnEarlierOneHasTwoClasses) {
    expect("yaw_wrap",
           {{"Quarter", deadlock, "holds"},
            {"Quarter", divergence, "holds"},
            {"Quarter", timelock, "holds"},
            {"Quarter", "every transition fires", "holds"}},
           {{"from_", 2}}, 14);
}

TEST_F(SharedData, ASumOfInputsNeverDeniesWhatARobotCanReach) {
    expect("running_sum",
           {{"Sum", deadlock, "holds"},
            {"Sum", divergence, "holds"},
            {"Sum", timelock, "holds"},
            {"Sum", "every transition fires", "holds"}},
           {}, 1'000);
}

// ---------------------------------------------------------------- classes against carriers

using Random = std::mt19937_64;

int draw(Random& random, int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
}

/// Returns a random condition with small constants on the variable.
std::string any_condition(Random& random, const char* variable) {
    const char* const relations[] = {"<", "<=", ">", ">=", "==", "!="};
    const auto comparison = [&] {
        return fmt::format("{} {} {}", variable, relations[draw(random, 0, 5)], draw(random, 0, 4));
    };
    switch (draw(random, 0, 3)) {
        case 0:
            return comparison();
        case 1:
            return fmt::format("({} /\\ {})", comparison(), comparison());
        case 2:
            return fmt::format("({} \\/ {})", comparison(), comparison());
        default:
            return fmt::format("not ({})", comparison());
    }
}

/// Returns a random machine with two inputs. Conditions read them when they are received and later.
std::string any_machine(Random& random) {
    const auto condition = [&](const char* variable) { return any_condition(random, variable); };
    std::string text =
        "package p\nstm S {\n event e : nat\n event f : nat\n event out : nat\n event go\n var x : nat, y : nat\n"
        " initial i\n junction k\n state A { }\n state B { }\n state C { }\n transition t0 { from i to A }\n";
    text += fmt::format(" transition t1 {{ from A to k trigger e ? x condition {} }}\n", condition("x"));
    text += fmt::format(" transition t2 {{ from k to A condition {} action out ! x }}\n", condition("x"));
    text += fmt::format(" transition t3 {{ from k to B condition {} /\\ {} }}\n", condition("x"), condition("y"));
    text += fmt::format(" transition t4 {{ from B to C trigger f ? y condition {} }}\n", condition("y"));
    text += fmt::format(" transition t5 {{ from B to A trigger go condition {} action x = {} }}\n", condition("x"),
                        draw(random, 0, 4));
    text += fmt::format(" transition t6 {{ from C to A condition {} }}\n", condition("y"));
    text += fmt::format(" transition t7 {{ from C to B trigger go condition {} action y = x }}\n", condition("x"));
    return text + "}\n";
}

/// The carrier 0..5 has a number greater than every constant, so it has a number of every class.
TEST(Classes, GiveTheAnswersOfCarriersThatHaveAllClasses) {
    Random random(6);
    std::size_t replaced = 0, failing = 0;
    for (std::size_t round = 0; round < tests::rounds(50); ++round) {
        const std::string text = any_machine(random);
        const testing::TemporaryFile model("m.rct", text);
        const Answers classes = answers_for(model.path());
        const Answers carriers = answers_for(model.path(), {"--range", "nat=0..5"});
        replaced += classes.classes.empty() ? 0U : 1U;
        ASSERT_FALSE(classes.verdicts.empty()) << classes.text;
        EXPECT_EQ(classes.verdicts.size(), carriers.verdicts.size());
        for (const auto& [claim, answer] : carriers.verdicts) {
            failing += answer == "fails" ? 1U : 0U;
            const std::string& found = classes.verdicts.at(claim);
            const bool open = claim.ends_with("deterministic") && found == "inconclusive";
            EXPECT_TRUE(open || found == answer) << claim << ": " << found << ", " << answer << "\n" << text;
        }
    }
    EXPECT_EQ(replaced, tests::rounds(50));
    EXPECT_GT(failing, tests::rounds(50)) << "some claims fail";
}

// ---------------------------------------------------------------- registers of RoboSim

/// Returns a random RoboSim machine. Conditions read the values of registers, and variables that store them.
std::string any_machine_in_cycles(Random& random) {
    const auto condition = [&](const char* variable) { return any_condition(random, variable); };
    std::string text =
        "package p\ninterface V { var s : nat }\ninterface Op { put(n : nat) }\nstm S {\n cycleDef cycle == 1\n"
        " input context { event e : nat event f : nat requires V }\n"
        " output context { event out : nat requires V requires Op }\n var x : nat, y : nat\n"
        " initial i\n junction k\n state A { }\n state B { }\n state C { }\n transition t0 { from i to A }\n"
        " transition u { from A to A exec condition not $e }\n";
    text += fmt::format(" transition t1 {{ from A to k condition $e?x : ({}) }}\n", condition("x"));
    text += fmt::format(" transition t2 {{ from k to A condition {} action $out!x ; exec }}\n", condition("x"));
    text += fmt::format(" transition t3 {{ from k to B condition {} /\\ {} action exec }}\n", condition("x"),
                        condition("y"));
    text += fmt::format(" transition t4 {{ from B to C exec condition $f?y /\\ {} }}\n", condition("x"));
    text += fmt::format(" transition t5 {{ from B to A exec condition {} action x = {} ; $s = x }}\n", condition("x"),
                        draw(random, 0, 4));
    text += fmt::format(" transition t6 {{ from C to A exec condition {} action $put(y) }}\n", condition("$s"));
    text += fmt::format(" transition t7 {{ from C to B exec condition {} action y = x }}\n", condition("x"));
    return text + "}\n";
}

/// Returns a random controller of RoboSim whose machines only copy values. It may be nondeterministic only because two
/// values may be sent.
std::string any_copying_controller(Random& random) {
    const auto sent = [&] {
        const char* const values[] = {"x", "y", "1", "0"};
        return values[draw(random, 0, 3)];
    };
    const auto statement = [&]() -> std::string {
        switch (draw(random, 0, 3)) {
            case 0:
                return fmt::format("$out!{}", sent());
            case 1:
                return fmt::format("$link!{}", sent());
            case 2:
                return fmt::format("y = {}", sent());
            default:
                return "skip";
        }
    };
    std::string text =
        "package p\nstm S {\n cycleDef cycle == 1\n input context { event e : nat event f : nat }\n"
        " output context { event out : nat event link : nat }\n var x : nat, y : nat\n initial i\n state A { }\n"
        " transition t0 { from i to A }\n transition u { from A to A exec condition not $e }\n";
    text += fmt::format(" transition t1 {{ from A to A exec condition $e?x action {} }}\n", statement());
    text += fmt::format(" transition t2 {{ from A to A exec condition {} action {} }}\n",
                        draw(random, 0, 1) == 0 ? "$f?y" : "$e?x /\\ $f?y", statement());
    text +=
        "}\nstm T {\n cycleDef cycle == 1\n input context { event link : nat }\n output context { event back : nat }\n"
        " var z : nat\n initial i\n state A { }\n transition t0 { from i to A }\n"
        " transition t1 { from A to A exec condition $link?z action $back!z }\n"
        " transition t2 { from A to A exec condition not $link }\n}\n"
        "controller C {\n cycleDef cycle == 1\n event e : nat event f : nat event out : nat event back : nat\n"
        " sref s = S\n sref t = T\n connection C on e to s on e\n connection s on out to C on out\n"
        " connection s on link to t on link\n connection t on back to C on back\n";
    if (draw(random, 0, 1) == 0) text += " connection C on f to s on f\n";
    return text + "}\n";
}

/// Decides the core properties of models in RoboSim with classes and with these carriers, which have all classes. If
/// values are only copied, no answer may be open.
void compare_in_cycles(const std::function<std::string(Random&)>& any_model, const char* carrier, bool copies) {
    Random random(7);
    std::size_t failing = 0;
    for (std::size_t round = 0; round < tests::rounds(30); ++round) {
        const std::string text = any_model(random);
        const testing::TemporaryFile model("m.rst", text);
        const Answers classes = answers_for(model.path());
        const Answers carriers = answers_for(model.path(), {"--range", carrier});
        ASSERT_FALSE(classes.verdicts.empty()) << classes.text << text;
        EXPECT_FALSE(classes.classes.empty()) << text;
        EXPECT_EQ(classes.verdicts.size(), carriers.verdicts.size());
        for (const auto& [claim, answer] : carriers.verdicts) {
            failing += answer == "fails" ? 1U : 0U;
            const std::string& found = classes.verdicts.at(claim);
            const bool open = !copies && claim.ends_with("deterministic") && found == "inconclusive";
            EXPECT_TRUE(open || found == answer) << claim << ": " << found << ", " << answer << "\n" << text;
        }
    }
    EXPECT_GT(failing, 10U) << "some claims fail";
}

TEST(Registers, GiveTheAnswersOfCarriersThatHaveAllClasses) {
    compare_in_cycles(any_machine_in_cycles, "nat=0..5", false);
}

TEST(Registers, OfCopiedValuesGiveAllAnswersOfCarriers) {
    compare_in_cycles(any_copying_controller, "nat=0..2", true);
}

/// The answers to the claims of a model in RoboSim, by their names.
std::map<std::string, std::string> answers_in_cycles(const std::string& machine, const std::string& claims) {
    const testing::Folder folder({{"m.rst", machine}, {"m.rsa", claims}});
    const Json json = Json::parse(
        run({"check", folder.path(), "--no-cache", "--timeout", "60", "--format", "json"}).out, nullptr, false);
    std::map<std::string, std::string> result;
    if (json.is_discarded()) return result;
    for (const Json& one : json.at("assertions")) {
        const std::string title = one.at("title");
        result[title.substr(0, title.find(' '))] = one.at("answer");
    }
    return result;
}

/// A record of two real numbers has more than ten thousand values. A machine that passes records on is decided with two
/// of them, and both are necessary: one of the machines is nondeterministic only because it chooses between two inputs.
TEST(Registers, OfRecordsThatAreOnlyPassedOnHaveFewValues) {
    const auto machine = [](const std::string& second) {
        return "datatype Pair { a : real b : real }\ninterface Op { move(p : Pair) }\nstm S {\n"
               " cycleDef cycle == 1\n input context { event first : Pair event second : Pair }\n"
               " output context { requires Op event copy : Pair }\n var p : Pair, q : Pair\n initial i\n"
               " state A { entry $move(p) ; $copy!q }\n transition t0 { from i to A }\n"
               " transition t1 { from A to A exec condition $first?p /\\ $first?q }\n"
               " transition t2 { from A to A exec condition $second?p /\\ $second?q" +
               second + " }\n transition t3 { from A to A exec condition not $first /\\ not $second }\n}\n";
    };
    const std::string claims =
        "assertion D : S is deterministic\nassertion F : S is deadlock-free\nassertion G : S is divergence-free\n";
    using Found = std::map<std::string, std::string>;
    EXPECT_EQ(answers_in_cycles(machine(" /\\ not $first"), claims),
              (Found{{"D", "holds"}, {"F", "holds"}, {"G", "holds"}}));
    EXPECT_EQ(answers_in_cycles(machine(""), claims), (Found{{"D", "fails"}, {"F", "holds"}, {"G", "holds"}}));
}

/// The answers to all claims about a model by their titles, and the options that set the carriers of its numbers.
struct DecidedModel {
    std::map<std::string, std::string> answers;
    std::vector<std::string> carriers;
    bool has_classes = false, has_small_carriers = true;
};

/// Whether the answer says that sequences are too short for a window of the model, or that results are clipped.
bool rests_on_small_carriers(const Json& claim) {
    return std::ranges::any_of(claim.value("basis", Json::array()), [](const Json& ground) {
        const std::string text = ground.value("text", "");
        return text.starts_with("sequences hold at most") ||
               text.find("leaves its type and is taken as") != std::string::npos;
    });
}

DecidedModel decided_model(const std::string& model, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"check", model, "--core", "--no-cache", "--timeout", "20", "--format", "json"});
    const Json report = Json::parse(run(options).out, nullptr, false);
    DecidedModel result;
    if (report.is_discarded() || !report.contains("assertions")) return result;
    for (const Json& claim : report.at("assertions"))
        if ((claim.at("answer") == "holds" || claim.at("answer") == "fails") && !rests_on_small_carriers(claim))
            result.answers[claim.at("title")] = claim.at("answer");
    for (const Json& data : report.value("data", Json::array()))
        result.has_classes = result.has_classes || data.contains("classes");
    std::set<std::string> types;
    for (const Json& range : report.at("run").at("ranges")) {
        const std::string type = range.at("type");
        if (type != "nat" && type != "int" && type != "real") continue;
        if (!types.insert(type).second) result.has_small_carriers = false;  // models with different carriers
        result.has_small_carriers = result.has_small_carriers && range.at("values") <= 64;
        result.carriers.insert(result.carriers.end(),
                               {"--range", fmt::format("{}={}..{}", type, range.at("low").get<std::int64_t>(),
                                                       range.at("high").get<std::int64_t>())});
    }
    return result;
}

/// Returns the folders with models in the repository and, if they are present, in the suites next to it.
std::vector<std::string> folders_of_models() {
    std::set<std::string> folders;
    const std::filesystem::path suites = tests::shared_folder() / "suite";
    for (const std::filesystem::path& root : {std::filesystem::path(testing::repository("corpus")),
                                              std::filesystem::path(testing::repository("tests/app")), suites}) {
        if (!std::filesystem::exists(root)) continue;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
            if (entry.path().extension() == ".rct") folders.insert(entry.path().parent_path().string());
    }
    return {folders.begin(), folders.end()};
}

/// The models of a folder without their claims. Claims that observe values would turn classes off.
testing::Folder models_alone(const std::filesystem::path& folder) {
    std::vector<std::pair<std::string, std::string>> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".rct")
            files.emplace_back(entry.path().filename().string(), tests::read_contents(entry.path()));
    return testing::Folder(files);
}

/// Decides the claims with classes and with carriers, if the carriers are small. Adds the components whose answers are
/// compared: "K::S" of "core [timed] K::S: deadlock-free".
void compare_with_carriers(const std::string& model, const std::string& folder, std::set<std::string>& components) {
    const DecidedModel classes = decided_model(model);
    if (!classes.has_classes || !classes.has_small_carriers) return;
    const DecidedModel carriers = decided_model(model, classes.carriers);
    for (const auto& [claim, answer] : carriers.answers) {
        const auto found = classes.answers.find(claim);
        if (found == classes.answers.end()) continue;  // not known
        EXPECT_EQ(found->second, answer) << folder << ": " << claim;
        const std::size_t begin = claim.find("] "), end = claim.find(": ");
        if (!claim.starts_with("core ") || begin == std::string::npos || end == std::string::npos) continue;
        components.insert(folder + " " + claim.substr(begin + 2, end - begin - 2));
    }
}

/// Claims that are decided with classes have the answers of the carriers that the program would choose, if these are
/// small, sequences are long enough, and no result is clipped. The core properties of all components are compared, with
/// the claims of the model and without them. All models with ROBOCHART_ALL_ROUNDS, a few otherwise.
TEST(Classes, GiveTheAnswersOfCarriersInTheSuites) {
    const std::vector<std::string> folders = folders_of_models();
    const bool all = tests::rounds(3) == 3;
    std::set<std::string> components;
    for (std::size_t f = 0; f < folders.size(); f += all ? 1 : 12) {
        compare_with_carriers(folders[f], folders[f], components);
        compare_with_carriers(models_alone(folders[f]).path(), folders[f], components);
    }
    std::cout << components.size() << " components agree\n";
    const bool has_suites = std::filesystem::exists(tests::shared_folder() / "suite");
    EXPECT_GE(components.size(), all && has_suites ? 200U : 2U);
}

/// Data with classes need no carrier, so a carrier of millions of numbers is no obstacle. Data that keep their carrier
/// have the numbers of the model and the neighbours of these numbers: 4,999,999 and 5,000,001 lead to different states.
TEST(Classes, NumbersOfMillionsAreDecided) {
    const testing::TemporaryFile classes(
        "m.rct",
        "stm S { event e : nat var u : nat var x : nat initial i state A { } state B { } transition t0 { from i to A } "
        "transition t1 { from A to B trigger e ? x condition x < 5000000 } }");
    const Answers found = answers_for(classes.path());
    EXPECT_EQ(found.verdicts.at("state machine S deadlock-free"), "fails") << found.text;
    EXPECT_EQ(found.verdicts.at("state machine S every transition fires"), "holds") << found.text;
    EXPECT_TRUE(found.classes.contains("e")) << found.text;
    const testing::TemporaryFile carriers(
        "m.rct",
        "stm S { event e : nat event f : nat var x : nat var y : nat initial i state A { } state B { } state C { } "
        "transition t0 { from i to A } transition t1 { from A to A trigger e ? x } "
        "transition t2 { from A to B trigger f ? y condition x < y /\\ y < 5000000 } "
        "transition t3 { from A to C trigger f ? y condition x < y /\\ y > 5000000 } }");
    const Answers kept = answers_for(carriers.path());
    EXPECT_EQ(kept.verdicts.at("state machine S every transition fires"), "holds") << kept.text;
    EXPECT_THAT(kept.text, ::testing::HasSubstr("nat 6 values in 0..5000001"));
}

/// A predicate of an input in an action reads the received value.
TEST(Classes, OfPredicatesInActionsAreThoseOfTheReceivedValue) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm S { event e : nat event f : nat var x : nat var y : nat initial i state A { entry e [| x > 3 |] ? x } "
        "state B { } state C { } transition t0 { from i to A } "
        "transition t1 { from A to B trigger f ? y condition x > 5 /\\ y > 7 action e [| x < 9 |] ? x } "
        "transition t2 { from A to C condition x <= 3 } }");
    const Answers found = answers_for(model.path());
    EXPECT_EQ(found.verdicts.at("state machine S B is reachable"), "holds") << found.text;
    EXPECT_EQ(found.verdicts.at("state machine S C is reachable"), "fails") << found.text;
    EXPECT_EQ(found.classes.at("e"), 4U) << "0..3, 4..5, 6..8, and more";
}

/// A class represents many values, so it has no probability. With equally likely inputs, the probability of a value
/// above 3 is one of seven with the carrier, but one of two with classes.
TEST(Shortcuts, ClassesHaveNoProbabilities) {
    const testing::Folder folder(
        {{"m.rct",
          "stm S { event e : int var x : int = 0 initial i state A { } state B { } transition t0 { from i to A } "
          "transition t1 { from A to A trigger e ? x } transition t2 { from A to B condition x > 3 } "
          "transition t3 { from B to B trigger e ? x } }"},
         {"m.assertions", "label there = S is in S::B\nprob property P : Prob=? of [Finally <=2 #there]\n"}});
    const auto value = [&](const std::vector<std::string>& range) {
        std::vector<std::string> options{"check", folder.path(), "--scheduler", "uniform", "--format", "json"};
        options.insert(options.end(), range.begin(), range.end());
        const auto ran = run(options);
        const Json json = Json::parse(ran.out, nullptr, false);
        if (json.is_discarded()) return -1.0;
        return json.at("assertions").at(0).at("probability").at("rows").at(0).value("value", -1.0);
    };
    const double found = value({});
    EXPECT_GT(found, 0.0);
    EXPECT_EQ(found, value({"--range", "int=-2..4"}));
    EXPECT_GT(value({"--range", "int=-2..7"}), found) << "as many values above 3 as below: like two classes";
}

/// Reports do not mention classes if only probabilities are computed. If other claims have classes, the probability
/// depends on the values of the carriers.
TEST(Shortcuts, ProbabilitiesAreNotAboutAllValues) {
    const std::string model =
        "stm S { event e : int var x : int = 0 initial i state A { } state B { } transition t0 { from i to A } "
        "transition t1 { from A to A trigger e ? x } transition t2 { from A to B condition x > 3 } "
        "transition t3 { from B to B trigger e ? x } }";
    const std::string probability = "label there = S is in S::B\nprob property P : Prob=? of [Finally <=2 #there]\n";
    const auto report_on = [&](const std::string& more) {
        const testing::Folder folder({{"m.rct", model}, {"m.assertions", probability + more}});
        const auto ran = run({"check", folder.path(), "--no-cache", "--format", "json"});
        return Json::parse(ran.out, nullptr, false);
    };
    const Json alone = report_on("");
    ASSERT_TRUE(alone.contains("assertions")) << alone;
    EXPECT_TRUE(alone.value("data", Json::array()).empty()) << alone;
    const Json both = report_on("untimed assertion Free : S is deadlock-free\n");
    ASSERT_TRUE(both.contains("assertions")) << both;
    EXPECT_EQ(both.at("data").at(0).at("classes"), 2U) << both;
    for (const Json& claim : both.at("assertions"))
        EXPECT_EQ(claim.contains("basis"), claim.contains("probability")) << claim;
}

// ---------------------------------------------------------------- computed data

/// The queue grows without a bound, so no finite list is long enough. No verdict depends on its length.
TEST(ComputedData, AListWithoutABoundIsDecidedForAllLengths) {
    const testing::TemporaryFile model(
        "m.rct",
        "import sequence_toolkit::* stm S { event put : nat event get event out : nat var x : nat "
        "var q : Seq(nat) = <> initial i state A { } state Lost { } transition t0 { from i to A } "
        "transition t1 { from A to A trigger put ? x action q = q ^ <x> } "
        "transition t2 { from A to A trigger get condition size(q) > 0 action out ! head(q) ; q = tail(q) } "
        "transition t3 { from A to Lost trigger get condition size(q) < 0 } }");
    const Answers found = answers_for(model.path(), {}, "2");
    for (const char* const claim : {"deadlock-free", "divergence-free", "timelock-free"}) {
        const std::string name = std::string("state machine S ") + claim;
        EXPECT_EQ(found.verdicts.at(name), "holds") << found.text;
        EXPECT_FALSE(found.bounded.contains(name)) << found.text;
        EXPECT_TRUE(found.free.contains(name)) << found.text;
    }
}

/// The states are infinitely many. A timelock, or a deadlock in which only time passes, is a cycle, and the search
/// looks for cycles only at its end. Therefore it also looks for them among the first states. Here `get` without `put`
/// reads the head of the empty list.
TEST(ComputedData, ADeadlockAmongTheFirstOfEndlessStatesIsFound) {
    const testing::TemporaryFile model(
        "m.rct",
        "import sequence_toolkit::* stm S { event put : nat event get event out : nat var x : nat "
        "var q : Seq(nat) = <> initial i state A { } transition t0 { from i to A } "
        "transition t1 { from A to A trigger put ? x action q = q ^ <x> } "
        "transition t2 { from A to A trigger get action out ! head(q) ; q = tail(q) } }");
    const Answers found = answers_for(model.path(), {}, "2");
    EXPECT_EQ(found.verdicts.at(stuck), "fails") << found.text;
    EXPECT_THAT(found.text, ::testing::HasSubstr("may not be a shortest one"));
}

/// A sum reaches every number, so no answer may say that the alarm is never raised. It also reaches numbers beyond the
/// end of the carriers.
TEST(ComputedData, WhatMayFailIsNotDecidedByAbstraction) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm S { event reading : real var v : real var s : real = 0.0 initial i state A { } state High { } "
        "state Both { } transition t0 { from i to A } transition t1 { from A to A trigger reading ? v action s = s + v "
        "} "
        "transition t2 { from A to High condition s > 100.0 } "
        "transition t3 { from A to Both condition s > 100.0 /\\ s < 99.0 } }");
    const Answers found = answers_for(model.path(), {}, "2");
    EXPECT_NE(found.verdicts.at("state machine S High is reachable"), "fails") << found.text;
    EXPECT_EQ(found.verdicts.at("state machine S Both is reachable"), "fails") << found.text;
    EXPECT_FALSE(found.bounded.contains("state machine S Both is reachable")) << found.text;
    EXPECT_EQ(found.verdicts.at("state machine S deadlock-free"), "fails") << found.text;
}

/// The condition x * y is not linear, so either guard may be true. Together the guards cover all products, so a
/// transition is always possible.
TEST(ComputedData, ConditionsThatAreNotLinearMayHaveEitherAnswer) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm S { event e : real event f : real var x : real var y : real initial i state A { } state B { } junction k "
        "transition t0 { from i to A } transition t1 { from A to B trigger e ? x } "
        "transition t2 { from B to k trigger f ? y } transition t3 { from k to A condition x * y > 12345.5 } "
        "transition t4 { from k to B condition x * y <= 12345.5 } }");
    const Answers found = answers_for(model.path(), {}, "8");
    EXPECT_EQ(found.verdicts.at(stuck), "holds") << found.text;
    EXPECT_FALSE(found.bounded.contains(stuck)) << found.text;
}

/// B is left only if a product is small. A branch that may be possible, offered in addition to what is certain, would
/// hide the deadlock. The failure with free values need not be a run of the model, so its numbers are only an example.
TEST(ComputedData, ABranchThatMayBePossibleIsNotOfferedForCertain) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm S { event e : real event f : real var x : real = 0.0 var y : real = 0.0 initial i state A { } state B { } "
        "transition t0 { from i to A } transition t1 { from A to A trigger e ? x } "
        "transition t2 { from A to B trigger f ? y } transition t3 { from B to A condition x * y <= 12345.5 } }");
    const Answers found = answers_for(model.path(), {"--untimed"}, "4");
    EXPECT_EQ(found.verdicts.at(stuck), "inconclusive") << found.text;
    EXPECT_THAT(found.text, ::testing::HasSubstr("with free values of computed data it fails"));
    EXPECT_THAT(found.text, ::testing::HasSubstr(", which may not be a run of the model"));
    EXPECT_THAT(found.text, ::testing::Not(::testing::HasSubstr("\"counterexample\"")));
    EXPECT_EQ(found.verdicts.at("state machine S divergence-free"), "holds") << found.text;
}

// ---------------------------------------------------------------- relations of variables

/// Returns a machine with two inputs of one type, which its conditions compare, and three states.
std::string comparing(const std::string& type, const std::string& more) {
    return fmt::format(
        "stm S {{ event e : {0} event f : {0} event go var x : {0} var y : {0} initial i state A {{ }} state B {{ }} "
        "state Wrong {{ }} transition t0 {{ from i to A }} {1} }}",
        type, more);
}

constexpr auto wrong = "state machine S Wrong is reachable";

/// If the type has no bounds, an input `e` below y exists for every y. The carrier is bounded, so the deadlock at its
/// lowest value must be found: an abstraction in which each input chooses the answer freely would miss it.
TEST(Relations, OfBoundedTypesAreNotFree) {
    const auto waiting_below = [](const std::string& type) {
        return comparing(type,
                         "transition t1 { from A to B trigger f ? y } "
                         "transition t2 { from B to A trigger e ? x condition x < y }");
    };
    const testing::TemporaryFile nat("m.rct", waiting_below("nat"));
    EXPECT_EQ(answers_for(nat.path()).verdicts.at(stuck), "fails") << "no x is below y = 0";
    const testing::TemporaryFile whole("m.rct", waiting_below("int"));
    EXPECT_EQ(answers_for(whole.path()).verdicts.at(stuck), "holds");
    EXPECT_EQ(answers_for(whole.path()).classes.at("e"), 2U);
    const Answers bounded = answers_for(whole.path(), {"--range", "int=-3..3"});
    EXPECT_EQ(bounded.verdicts.at(stuck), "fails") << "no x is below y = -3";
    EXPECT_TRUE(bounded.classes.empty());
}

/// Wrong becomes reachable if the class of x > y stays the same although an assignment changes x or y.
TEST(Relations, AreNotStaleAfterAssignments) {
    const auto after = [](const std::string& action) {
        return comparing("int",
                         "junction k transition t1 { from A to A trigger f ? y } "
                         "transition t2 { from A to B trigger e ? x condition x > y } "
                         "transition t3 { from B to k trigger go action " +
                             action +
                             " } transition t4 { from k to Wrong condition x > y } "
                             "transition t5 { from k to A condition x <= y }");
    };
    for (const char* const action : {"x = y", "x = 0 ; y = 0", "y = x ; x = y - 1", "y = 5 ; x = 4"}) {
        const testing::TemporaryFile model("m.rct", after(action));
        EXPECT_EQ(answers_for(model.path()).verdicts.at(wrong), "fails") << action;
    }
    const testing::TemporaryFile model("m.rct", after("x = y + 1"));
    EXPECT_EQ(answers_for(model.path()).verdicts.at(wrong), "holds");
}

/// Returns a random machine whose guards compare two inputs without arithmetic. If `guarded`, guards of inputs also
/// restrict the new value.
std::string any_relating_machine(Random& random, bool guarded) {
    const char* const relations[] = {"<", "<=", ">", ">=", "==", "!="};
    const auto condition = [&] { return fmt::format("x {} y", relations[draw(random, 0, 5)]); };
    const auto guard = [&] { return guarded && draw(random, 0, 1) == 0 ? "condition " + condition() : std::string(); };
    const char* const copies[] = {"", "action x = y", "action y = x"};
    std::string text =
        "stm S { event e : int event f : int event go var x : int var y : int initial i junction k state A { } "
        "state B { } state Wrong { } transition t0 { from i to A } ";
    text += fmt::format("transition t1 {{ from A to k trigger e ? x {} }} ", guard());
    text += fmt::format("transition t2 {{ from A to B trigger f ? y {} }} ", guard());
    text += fmt::format("transition t3 {{ from k to A condition {} }} ", condition());
    text += fmt::format("transition t4 {{ from k to B condition {} }} ", condition());
    text += fmt::format("transition t5 {{ from B to A trigger go condition {} {} }} ", condition(),
                        copies[draw(random, 0, 2)]);
    text += fmt::format("transition t6 {{ from B to B trigger e ? x {} }} ", guard());
    text += fmt::format("transition t7 {{ from B to Wrong condition {} /\\ not {} }} ", condition(), condition());
    text += fmt::format("transition t8 {{ from Wrong to A condition {} }} ", condition());
    return text + "}";
}

/// The carriers -7..7 give comparable answers for the following reason. Consider a control state and one of the three
/// answers to the comparison of x with y. If both are reachable together, they are reached after at most 6 inputs,
/// because inputs are taken in A and B. For each answer, there is an input next to the value of the other variable, so
/// no value exceeds 6. Conversely, the carriers are a part of the integers. So the reachable pairs of a control state
/// and an answer are equal, and so are all claims about them. With guarded inputs, a value at the end of a carrier may
/// exclude every input of the carrier, but not every integer. So a deadlock with carriers need not be a deadlock with
/// integers.
TEST(Relations, GiveTheAnswersOfWideCarriers) {
    Random random(9);
    std::size_t failing = 0;
    for (std::size_t round = 0; round < tests::rounds(6); ++round) {
        const bool guarded = round % 2 == 1;
        const std::string text = any_relating_machine(random, guarded);
        const testing::TemporaryFile model("m.rct", text);
        const Answers classes = answers_for(model.path());
        const Answers carriers = answers_for(model.path(), {"--range", "int=-7..7"});
        ASSERT_TRUE(classes.classes.contains("e")) << classes.text;
        for (const auto& [claim, answer] : carriers.verdicts) {
            failing += answer == "fails" ? 1U : 0U;
            const std::string& found = classes.verdicts.at(claim);
            const bool may_end = guarded && (claim == stuck || claim.ends_with("timelock-free")) && answer == "fails";
            const bool comparable = !claim.ends_with("deterministic") && !may_end;
            EXPECT_TRUE(!comparable || found == answer) << claim << ": " << found << ", " << answer << "\n" << text;
        }
    }
    EXPECT_GT(failing, tests::rounds(6)) << "some claims fail";
}

/// Returns the numbers that the inputs of the counterexample to the claim receive, in order.
std::vector<double> inputs_of_run(const std::string& model, const std::string& property) {
    const auto ran = run({"check", model, "--core", "--no-cache", "--format", "json"});
    const Json report = Json::parse(ran.out);
    std::vector<double> result;
    for (const Json& one : report.at("assertions")) {
        if (!one.contains("core") || one["core"].at("property") != property || !one.contains("counterexample"))
            continue;
        for (const Json& step : one["counterexample"].at("steps"))
            if (step.at("kind") == "input" && step.contains("values"))
                result.push_back(std::stod(step["values"].at(0).at("value").get<std::string>()));
    }
    return result;
}

TEST(Relations, OfCounterexamplesAreShownAsValuesThatReplay) {
    const testing::TemporaryFile greater(
        "m.rct", comparing("int",
                           "junction k transition t1 { from A to B trigger f ? y condition y < x } "
                           "transition t2 { from B to k trigger e ? x condition x > y } "
                           "transition t3 { from k to A condition x <= y }"));
    const std::vector<double> numbers = inputs_of_run(greater.path(), "deadlock-free");
    ASSERT_EQ(numbers.size(), 2U);
    EXPECT_LT(numbers[0], 0) << "y < x, and x is 0";
    EXPECT_GT(numbers[1], numbers[0]);
    const testing::TemporaryFile turned(
        "m.rct", comparing("real",
                           "junction k transition t1 { from A to B trigger f ? y } "
                           "transition t2 { from B to k trigger e ? x } "
                           "transition t3 { from k to A condition (y - x + 180) % 360 - 180 < 90 }"));
    const std::vector<double> headings = inputs_of_run(turned.path(), "deadlock-free");
    ASSERT_EQ(headings.size(), 2U);
    const double turn = std::fmod(headings[0] - headings[1] + 720 + 180, 360) - 180;
    EXPECT_GE(turn, 90);
}

TEST(Classes, AreTurnedOffByAnOptionAndByRanges) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm S { event e : nat var x : nat initial i state A { } transition t0 { from i to A } "
        "transition t1 { from A to A trigger e ? x } }");
    EXPECT_EQ(answers_for(model.path()).classes.at("e"), 2U);
    EXPECT_TRUE(answers_for(model.path(), {"--concrete"}).classes.empty());
    EXPECT_TRUE(answers_for(model.path(), {"--range", "nat=0..9"}).classes.empty());
}

// ---------------------------------------------------------------- shortcuts that would be unsound

Answers answers_for_text(const std::string& text) {
    const testing::TemporaryFile model("m.rct", text);
    return answers_for(model.path());
}

/// Two conditions on one value depend on each other: no value is above 10 and at most 5. If each condition had an
/// independent truth value, `Stuck` would be reachable.
TEST(Shortcuts, ConditionsOnOneValueDependOnEachOther) {
    const Answers found = answers_for_text(
        "stm S { event e : real event go var v : real initial i state A { } state High { } state Stuck { } "
        "transition t0 { from i to A } transition t1 { from A to A trigger e ? v } "
        "transition t2 { from A to High trigger go condition v > 10.5 } "
        "transition t3 { from High to Stuck trigger go condition v <= 5.25 } "
        "transition t4 { from High to A trigger go condition v > 5.25 } }");
    EXPECT_EQ(found.verdicts.at("state machine S High is reachable"), "holds") << found.text;
    EXPECT_EQ(found.verdicts.at("state machine S Stuck is reachable"), "fails") << found.text;
}

/// The least element of an empty window is undefined, so neither the condition nor its negation is true. If undefined
/// meant false, the negation would be true, and the junction would always have an enabled transition.
TEST(Shortcuts, UndefinedIsNotFalse) {
    const Answers found = answers_for_text(
        "import sequence_toolkit::* import set_toolkit::* import relation_toolkit::* "
        "stm S { event e : Seq(real) var s : Seq(real) initial i state A { } junction k transition t0 { from i to A } "
        "transition t1 { from A to k trigger e ? s } "
        "transition t2 { from k to A condition min(ran(extract([1, 3], s))) < 0.5 } "
        "transition t3 { from k to A condition not (min(ran(extract([1, 3], s))) < 0.5) } }");
    EXPECT_EQ(found.classes.at("e"), 3U) << found.text;
    EXPECT_EQ(found.verdicts.at("state machine S deadlock-free"), "fails") << found.text;
}

/// One machine only passes a value on, and another machine tests it behind an asynchronous connection.
TEST(Shortcuts, AReaderBehindABufferDistinguishesValues) {
    const std::vector<std::pair<std::string, std::string>> files{
        {"m/m.rct",
         "interface I { event e : real } interface O { event back } "
         "interface W { event e : real event go } "
         "stm First { uses I event out_ : real var x : real initial i state A { } "
         "transition t0 { from i to A } transition t1 { from A to A trigger e ? x action "
         "out_ ! x } } "
         "stm Second { event in_ : real var y : real initial i state A { } state Far { } "
         "transition t0 { from i to A } "
         "transition t1 { from A to Far trigger in_ ? y condition y > 7.5 } "
         "transition t2 { from A to A trigger in_ ? y condition y <= 7.5 } } "
         "controller C { uses I sref a = First sref b = Second "
         "connection C on e to a on e connection a on out_ to b on in_ ( _async ) }"}};
    const testing::Folder folder(files);
    const auto ran = run({"check", folder / "m", "--core", "--no-cache", "--format", "json"});
    const Json json = Json::parse(ran.out, nullptr, false);
    ASSERT_FALSE(json.is_discarded()) << ran.out << ran.err;
    std::map<std::string, std::size_t> classes;
    for (const Json& data : json.value("data", Json::array()))
        for (const Json& place : data.at("places")) classes[place.get<std::string>()] = data.value("classes", 0U);
    EXPECT_EQ(classes["x"], 2U) << ran.out << ran.err;
    EXPECT_EQ(classes["y"], 2U);
}

/// A loop keeps the numbers of its bound, although the bound is an input: no line says that the verdict is about all
/// values.
TEST(Shortcuts, ALoopBoundIsNoClass) {
    const Answers found = answers_for_text(
        "stm S { event e : nat event done var n : nat var i : nat initial j state A { } state Loop { } "
        "transition t0 { from j to A } transition t1 { from A to Loop trigger e ? n action i = 0 } "
        "transition t2 { from Loop to Loop condition i < n action i = i + 1 } "
        "transition t3 { from Loop to A condition i >= n action done } }");
    EXPECT_FALSE(found.classes.contains("n")) << found.text;
    EXPECT_FALSE(found.classes.contains("e")) << found.text;
    EXPECT_EQ(found.verdicts.at("state machine S divergence-free"), "holds") << found.text;
}

/// A during action changes l between the event of a trigger and the storing of its value in d. After d = 1 with l = 2,
/// `l = d` sets l to the old value of d, which is 0, so Y is reached.
TEST(Shortcuts, RelationsThatADuringActionChangesKeepTheirCarriers) {
    const Answers found = answers_for_text(
        "stm S { event a : int event go var d : int = 0 , l : int = 2 initial i "
        "state C { during l = d initial j state X { } state Y { } transition u0 { from j to X } "
        "transition u1 { from X to X trigger a ? d condition d <= l } "
        "transition u2 { from X to Y trigger go condition d > l } } transition t0 { from i to C } }");
    EXPECT_FALSE(found.classes.contains("a")) << found.text;
    EXPECT_EQ(found.verdicts.at("state machine S every transition fires"), "holds") << found.text;
}

/// A quantifier ranges over a carrier, so its condition needs the values: there are reals above 1.5.
TEST(Shortcuts, QuantifiersNeedTheValues) {
    const Answers found = answers_for_text(
        "stm S { event go var x : real = 1.5 initial i state A { } state B { } transition t0 { from i to A } "
        "transition t1 { from A to A trigger go condition forall y : real @ y <= x } "
        "transition t2 { from A to B trigger go condition exists y : real @ y > x } }");
    EXPECT_EQ(found.verdicts.at("state machine S B is reachable"), "holds") << found.text;
}

/// 3 - 4 is not a natural number, so the output has no value after the input 3. If the output were abstracted because
/// nothing depends on it, the error would be hidden.
TEST(Shortcuts, AConversionMayHaveNoValue) {
    const Answers found = answers_for_text(
        "stm S { event e : nat event out_ : nat var x : nat = 0 initial i state A { } transition t0 { from i to A } "
        "transition t1 { from A to A trigger e ? x condition x > 2 action out_ ! ( ( x - 4 ) as nat ) } }");
    EXPECT_NE(found.verdicts.at("state machine S deadlock-free"), "holds") << found.text;
}

/// The report quotes the expression in the reason as written, and names its place if a verdict depends on carriers.
TEST(Carriers, TheReportSaysWhyDataKeepThem) {
    const testing::TemporaryFile model(
        "m.rct",
        "import sequence_toolkit::*\n"
        "stm S { event e : nat event f : nat event list : Seq(nat) event go event out_ : nat clock C\n"
        "var sum : nat, x : nat, y : nat, z : nat, t : nat, q : nat, s : Seq(nat), h : nat initial i state A { }\n"
        "transition t0 { from i to A }\n"
        "transition t1 { from A to A trigger e ? x action sum = sum + x }\n"
        "transition t2 { from A to A trigger go condition sum > 5 }\n"
        "transition t3 { from A to A trigger f ? y }\n"
        "transition t4 { from A to A trigger go condition y * z > 3 }\n"
        "transition t5 { from A to A trigger f ? t action wait(t) }\n"
        "transition t6 { from A to A trigger go condition q * q > 3 }\n"
        "transition t7 { from A to A trigger list ? s action h = head(s) ; out_ ! h }\n"
        "}\n");
    const Answers found = answers_for(model.path(), {"--untimed"});
    EXPECT_EQ(found.kept.at("sum"), "`sum + x` computes a value, and a condition reads it") << found.text;
    EXPECT_EQ(found.kept.at("e"), "`sum + x` computes a value of data that keep their carriers") << found.text;
    EXPECT_EQ(found.kept.at("f"), "`y * z > 3` also reads other data") << found.text;
    EXPECT_EQ(found.kept.at("z"), "`y * z > 3` also reads other data") << found.text;
    EXPECT_EQ(found.kept.at("h"), "`head(s)` may be undefined") << found.text;
    EXPECT_TRUE(found.classes.contains("q") || found.kept.contains("q")) << found.text;
    const auto ran = run({"check", model.path(), "--core", "--no-cache", "--untimed"});
    EXPECT_THAT(ran.out,
                ::testing::HasSubstr("carrier      sum: `sum + x` computes a value, and a condition reads it ("))
        << ran.out;
    EXPECT_THAT(ran.out, ::testing::HasSubstr("m.rct:5)")) << ran.out;
}

/// Returns the reason in the report for a machine with these conditions on the input x.
std::string reason_for(const std::string& type, const std::vector<std::string>& conditions) {
    std::string text = fmt::format(
        "import sequence_toolkit::* import set_toolkit::* import relation_toolkit::* "
        "stm S {{ event e : {0} event go var x : {0} initial i state A {{ }} state B {{ }} transition t0 {{ from i to "
        "A }} "
        "transition t {{ from A to B trigger e ? x }} ",
        type);
    for (std::size_t c = 0; c < conditions.size(); ++c)
        text += fmt::format("transition c{} {{ from B to A trigger go condition {} }} ", c, conditions[c]);
    const testing::TemporaryFile model("m.rct", text + "}");
    return answers_for(model.path(), {"--untimed"}, "1").kept["e"];
}

TEST(Carriers, TheReportSaysWhichLimitKeepsThem) {
    std::vector<std::string> seventy, windows, numbers, thirds;
    for (int i = 0; i < 70; ++i) seventy.push_back(fmt::format("x == {}.5", i));
    for (int i = 0; i < 13; ++i)
        windows.push_back(fmt::format("min(ran(extract([{}, {}], x))) < 0.5", 10 * i + 1, 10 * i + 10));
    for (int i = 0; i < 13; ++i) numbers.push_back(fmt::format("x[{}] > 0.5", i + 1));
    std::string tuple = "real";
    for (int i = 1; i < 13; ++i) tuple += " * real";
    EXPECT_EQ(reason_for("real", seventy), "there are more than 64 conditions");
    EXPECT_EQ(reason_for("Seq(real)", windows), "there are more than 256 classes") << "2 answers in each of 13 windows";
    EXPECT_EQ(reason_for(tuple, numbers), "the conditions read more than 8 numbers of one value");
    EXPECT_EQ(reason_for("Seq(real)", {"min(ran(extract([1, 2], x))) < 0.5", "max(ran(extract([3, 4], x))) > 0.5"}),
              "conditions read least numbers of windows, and also greatest ones");
    EXPECT_EQ(reason_for("real", {"3 * x == 1"}), "for some combination of answers, no decimal numbers are found");
    EXPECT_THAT(reason_for("Seq(real)", {"min(ran(extract([1000000, 1000001], x))) < 0.5"}),
                ::testing::HasSubstr("neither linear nor about windows of the first 4095 places"));
}

/// If a claim is inconclusive because carriers are too large, the text says why data keep their carriers.
TEST(Carriers, TheReportSaysWhyTheyAreTooLarge) {
    std::string text =
        "stm S { event e : T event go var x : T initial i state A { } state B { } "
        "transition t0 { from i to A } transition t { from A to B trigger e ? x } ";
    std::string fields;
    for (int i = 0; i < 200; ++i) {
        fields += fmt::format(" f{} : real\n", i);
        text += fmt::format("transition c{0} {{ from B to A trigger go condition x.f{0} < {0}.5 }} ", i);
    }
    const testing::TemporaryFile model("m.rct", "datatype T {\n" + fields + "}\n" + text + "}");
    const auto ran = run({"check", model.path(), "--core", "--untimed", "--no-cache", "--timeout", "2"});
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, ::testing::HasSubstr("carrier      e, x: there are more than 64 conditions\n"));
}

/// No place of a sequence is in these windows, so their least number is undefined, and t2 and t4 are never taken.
TEST(Classes, OfReversedAndEmptyWindowsHaveNoNumbers) {
    for (const char* const window : {"[5, 3]", "[0, 0]", "[-3, -1]", "{}"}) {
        const testing::TemporaryFile model(
            "m.rct",
            fmt::format(
                "import sequence_toolkit::* import set_toolkit::* import relation_toolkit::* "
                "stm S {{ event e : Seq(real) var x : Seq(real) initial i state A {{ }} state B {{ }} junction k "
                "transition t0 {{ from i to A }} transition t1 {{ from A to k trigger e ? x }} "
                "transition t2 {{ from k to B condition min(ran(extract({0}, x))) < 0.5 }} "
                "transition t3 {{ from k to A condition size(x) == 5 }} "
                "transition t4 {{ from k to A condition not (min(ran(extract({0}, x))) < 0.5) }} }}",
                window));
        const Answers found = answers_for(model.path());
        EXPECT_EQ(found.verdicts.at(stuck), "fails") << window << found.text;
        EXPECT_EQ(found.verdicts.at("state machine S B is reachable"), "fails") << window << found.text;
        EXPECT_EQ(found.classes.at("e"), 2U) << window << found.text;
    }
}

/// The types have five million numbers, but no condition and no output needs their values.
TEST(Carriers, OfUnusedTypesAreNotListed) {
    const char* const machines[] = {
        "stm S { event e : nat event q : nat * nat var u : nat var big : nat * nat = (| 5000001, 0 |) initial i "
        "state A { } transition t0 { from i to A } transition t1 { from A to A trigger e ? u } }",
        "datatype D { a : nat b : nat c : nat } stm S { event e event d : D var u : D const N : nat = 5000001 initial "
        "i "
        "state A { } transition t0 { from i to A } transition t1 { from A to A trigger e } }",
        "stm S { event e event s : Set(nat) var u : Set(nat) var z : nat = 5000000 initial i state A { } "
        "transition t0 { from i to A } transition t1 { from A to A trigger e condition z > 3 } }"};
    for (const char* const text : machines) {
        const Answers found = answers_for_text(text);
        EXPECT_EQ(found.verdicts.at(stuck), "holds") << found.text;
        const testing::TemporaryFile model("m.rct", text);
        EXPECT_EQ(conformance_of(model.path(), {}).value("outcome", ""), "conforms") << text;
    }
}

/// A function that calls itself without end has no value. The message names the place.
TEST(Carriers, ARecursionWithoutEndIsAnError) {
    const testing::TemporaryFile model(
        "m.rct",
        "function f(n : int) : int { postcondition result == f(n) }\n"
        "stm S { event e : int var x : int initial i state A { } state B { } transition t0 { from i to A }\n"
        "transition t1 { from A to B trigger e ? x condition f(x) > 5 } transition t2 { from B to A } }\n");
    const auto ran = run({"check", model.path(), "--core", "--untimed", "--no-cache", "--timeout", "60"});
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    EXPECT_THAT(ran.out, ::testing::HasSubstr("m.rct:1: evaluation nests too deeply: runaway recursion?, in f"));
}

/// A function that calls itself and names its result is computed, not searched for among the values of its type: a
/// search for sum(10) would compute sum(9) once for each of these values.
TEST(Carriers, ARecursionThatEndsIsComputed) {
    const testing::TemporaryFile model(
        "m.rct",
        "function sum(n : int) : int { postcondition result == if n == 0 then 0 else n + sum(n - 1) end }\n"
        "stm S { var x : int = 55 initial i state A { } state B { } state C { } transition t0 { from i to A }\n"
        "transition t1 { from A to B condition sum(10) == x } transition t2 { from A to C condition sum(10) != x } "
        "}\n");
    const Answers found = answers_for(model.path());
    EXPECT_EQ(found.verdicts.at("state machine S B is reachable"), "holds") << found.text;
    EXPECT_EQ(found.verdicts.at("state machine S C is reachable"), "fails") << found.text;
}

/// f(60) ends, but only after 2^60 calls. The message names the function and its place.
TEST(Carriers, ARecursionThatTakesTooLongIsNamed) {
    const testing::TemporaryFile model(
        "m.rct",
        "function f(n : int) : int { postcondition result == if n == 0 then 0 else f(n - 1) + f(n - 1) end }\n"
        "stm S { var x : int initial i state A { } transition t0 { from i to A action x = f(60) }\n"
        "transition t1 { from A to A condition x > 5 } }\n");
    const auto ran = run({"check", model.path(), "--core", "--untimed", "--no-cache", "--timeout", "8"});
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, ::testing::HasSubstr("m.rct:1: the evaluation had not ended, in f"));
}

/// The least number in a window is one of the numbers of the scan. The code compares it with a threshold that it
/// computes: 0.3 - 0.1 is the double below 0.2.
TEST(Doubles, ThresholdsOfWindowsThatTheCodeComputesAreTried) {
    const auto answer = [](const std::string& operation, const std::string& threshold, int exit) {
        const std::string condition = fmt::format("min(ran(extract([1, 3], x))) {} {}", operation, threshold);
        const testing::TemporaryFile model(
            "m.rct", fmt::format("import sequence_toolkit::*\nimport set_toolkit::*\nimport relation_toolkit::*\n"
                                 "stm S {{ event scan : Seq(real) event near var x : Seq(real) initial i state A {{ }} "
                                 "junction k transition t0 {{ from i to A }} "
                                 "transition t1 {{ from A to k trigger scan ? x }} "
                                 "transition t2 {{ from k to A condition {0} action near }} "
                                 "transition t3 {{ from k to A condition not {0} }} }}",
                                 condition));
        return conformance_of(model.path(), {}, exit);
    };
    const Json rounds = answer("<=", "0.3 - 0.1", 1);
    EXPECT_EQ(rounds.value("outcome", ""), "rounds") << rounds;
    EXPECT_THAT(rounds.value("reason", ""),
                ::testing::HasSubstr("is true for a window with the number 0.2, but false"));
    const Json inherent = answer("<", "0.3 - 0.1", 0);  // only for the double below 0.2, as in all code with doubles
    EXPECT_EQ(inherent.value("outcome", ""), "conforms") << inherent;
    ASSERT_TRUE(inherent.contains("robot")) << inherent;
    EXPECT_THAT(inherent.at("robot").value("roundingDifference", ""), ::testing::HasSubstr("0.19999999999999998"));
    for (const char* const exact : {"0.2", "0.5 - 0.25", "2 * 0.1"}) {
        const Json found = answer("<=", exact, 0);
        EXPECT_EQ(found.value("outcome", ""), "conforms") << found;
        ASSERT_TRUE(found.contains("robot")) << found;
        EXPECT_FALSE(found.at("robot").contains("roundingDifference")) << found;
    }
}

/// Z3 works for seconds on these conditions. A signal ends the command before it has finished.
TEST(Classes, ASignalEndsTheSolver) {
    if (!ir::has_solver()) GTEST_SKIP() << "built without Z3";
    const testing::TemporaryFile model(
        "m.rct",
        "stm S { event e : int * int * int var x : int * int * int initial i state A { } state B { } "
        "transition t0 { from i to A } "
        "transition t1 { from A to B trigger e ? x condition x[1]*x[1]*x[1] + x[2]*x[2]*x[2] + x[3]*x[3]*x[3] == 33 } "
        "transition t2 { from B to A condition x[1]*x[1]*x[1] - x[2]*x[2]*x[2] + 5*x[3]*x[3]*x[3] == 1234567 } "
        "transition t3 { from B to A condition x[1]*x[2]*x[3] == 777771 /\\ x[1] > 2 /\\ x[2] > 2 } }");
    const auto a_while = [](const std::function<bool()>&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(400));
    };
    const auto ran = testing::run_and_signal({"check", model.path(), "--core", "--no-cache"}, SIGINT, a_while);
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out + ran.err, ::testing::HasSubstr("interrupted"));
}

/// The machine declares a variable `a` with the name of the shared variable. If the carriers are large, memories with
/// channels store both variables.
TEST(Carriers, LargeOnesOfVariablesWithOneNameHaveDifferentChannels) {
    const std::string text =
        "interface I { var a : nat }\n"
        "stm S { requires I var a : nat, b : nat event e : nat event f : nat event out_ : nat initial i state A { }\n"
        "transition t0 { from i to A } transition t1 { from A to A trigger e ? a action out_ ! a }\n"
        "transition t2 { from A to A trigger f ? b action out_ ! (a + b) }\n"
        "transition t3 { from A to A trigger f ? b condition a > b } }\n";
    const testing::Folder folder({{"m.rct", text}});
    const auto ran = run({"emit", "csp", folder / "m.rct", "--range", "nat=0..300", "--out", folder.path("out")});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    const std::string script = tests::read_contents(folder.path("out") + "/csp-gen/m.csp");
    EXPECT_THAT(script, ::testing::HasSubstr("channel set_a, set_EXT_a : core_nat"));
    EXPECT_EQ(run({"check", folder / "m.rct", "--core", "--concrete"}).exit, 0);
}

/// If a block names a channel of the shared variable, it means the shared variable and not the machine's own one.
TEST(Carriers, AChannelOfVariablesWithOneNameIsThatOfTheSharedOne) {
    const testing::Folder folder(
        {{"m/m.rct",
          "interface I { var a : nat }\n"
          "stm S { requires I var a : boolean event e : boolean initial i state A { }\n"
          "transition t0 { from i to A } transition t1 { from A to A trigger e ? a } }\n"},
         {"m/m.assertions",
          "untimed csp Other csp-begin Other = S::set_EXT_a?x -> Other [] S::set_a?x -> Other [] S::e.in?v -> Other "
          "csp-end "
          "untimed assertion Free : S refines Other in the traces model "}});
    const auto ran = run({"check", folder / "m", "--no-cache"});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
}

/// Carriers that the user has chosen need no reason.
TEST(Carriers, ThatTheUserChoosesHaveNoReason) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm S { event e : nat var x : nat, y : nat initial i state A { } transition t0 { from i to A } "
        "transition t1 { from A to A trigger e ? x condition x > y } }");
    EXPECT_FALSE(answers_for(model.path()).kept.empty());
    EXPECT_TRUE(answers_for(model.path(), {"--concrete"}).kept.empty());
    EXPECT_TRUE(answers_for(model.path(), {"--range", "nat=0..3"}).kept.empty());
}

/// Literals of an enumeration may carry numbers, whose carriers omit values. So an answer either states that it depends
/// on these carriers, or is about all values.
TEST(Carriers, OfNumbersInLiteralsArePartOfTheBasis) {
    const testing::TemporaryFile model(
        "m.rct",
        "enumeration Goal { none distance(nat) }\n"
        "stm S { event e : Goal event f : Goal var x : Goal, y : Goal initial i state A { } state B { } "
        "transition t0 { from i to A } transition t1 { from A to A trigger e ? x } "
        "transition t2 { from A to A trigger f ? y } transition t3 { from A to B condition x == y } "
        "transition t4 { from B to A trigger e ? x } }");
    const Answers found = answers_for(model.path(), {"--untimed"});
    const std::string claim = "state machine S divergence-free";
    EXPECT_TRUE(found.bounded.contains(claim) || found.free.contains(claim)) << found.text;
}

/// A function may have no value although it has no precondition: here first(<>) has none.
TEST(Shortcuts, AFunctionMayHaveNoValue) {
    for (const char* const body : {"result == head(s)", "result in ran(s)"}) {
        const testing::TemporaryFile model(
            "m.rct",
            fmt::format(
                "import sequence_toolkit::* import relation_toolkit::* "
                "function first(s : Seq(real)) : real {{ postcondition {} }} "
                "stm S {{ event e : Seq(real) event o : real var s : Seq(real) var x : real initial i state A {{ }} "
                "transition t0 {{ from i to A }} "
                "transition t1 {{ from A to A trigger e ? s action x = first(s) + 1 ; o ! x }} }}",
                body));
        const Answers found = answers_for(model.path(), {}, "5");
        EXPECT_NE(found.verdicts.at(stuck), "holds") << found.text;
    }
}

/// If a condition compares numbers with each other, it may need more values than the literals and their neighbours: x >
/// y > z > 0 needs three numbers above 0.
TEST(Carriers, AConditionOnSeveralValuesIsPartOfTheBasis) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm S { event e : nat event f : nat event g : nat var x : nat var y : nat var z : nat initial i state A { } "
        "state B { } state C { } state Wrong { } junction k transition t0 { from i to A } "
        "transition t1 { from A to B trigger e ? x } transition t2 { from B to C trigger f ? y } "
        "transition t3 { from C to k trigger g ? z } transition t4 { from k to Wrong condition x > y /\\ y > z /\\ z > "
        "0 } "
        "transition t5 { from k to A condition not (x > y /\\ y > z /\\ z > 0) } }");
    const Answers found = answers_for(model.path());
    EXPECT_TRUE(found.verdicts.at(stuck) != "holds" || found.bounded.contains(stuck)) << found.text;
    EXPECT_TRUE(found.bounded.contains(wrong)) << found.text;
}

/// Returns a machine that stores a value computed from an input. It is stuck in B if the condition is false.
std::string storing(const std::string& variables, const std::string& action, const std::string& condition) {
    return fmt::format(
        "stm S {{ {} initial i state A {{ }} state B {{ }} transition t0 {{ from i to A }} "
        "transition t1 {{ from A to B trigger e ? x action {} }} transition t2 {{ from B to A condition {} }} }}",
        variables, action, condition);
}

/// The carrier of an input has a number beyond 7, but not beyond 14 or 49, so it does not cover a half or a root that
/// is compared with 7. Each of these machines is stuck after the input 1000.
TEST(Shortcuts, CarriersOfInputsDoNotCoverWhatIsComputedFromThem) {
    const std::string whole = "event e : int var x : int = 0 var q : int = 0";
    const std::string real = "event e : real var x : real = 0.0 var q : real = 0.0";
    const std::string truth = "event e : nat var x : nat = 0 var y : nat = 1 var z : nat = 0 var b : boolean = true";
    const std::vector<std::string> machines{
        storing(whole, "q = (x / 2) as int", "q <= 7"),
        storing(real, "q = x / 2", "q <= 7"),
        storing(whole, "x = (x / 4) as int", "x <= 7"),
        storing(whole + " var r : int = 0", "q = (x / 2) as int ; r = q", "r <= 7"),
        storing("event e : int var x : int = 0 var q : int * int", "q = (| (x / 2) as int, 0 |)", "q[1] <= 7"),
        storing(truth + " event f : nat", "b = (x > y /\\ y > z /\\ z > 0) ; z = y ; y = x", "not b")};
    for (const std::string& text : machines) {
        const Answers found = answers_for_text(text);
        EXPECT_TRUE(found.verdicts.at(stuck) != "holds" || found.bounded.contains(stuck)) << text << found.text;
    }
}

/// A wait for an input x is short for x in 0..2. With x = 7, the machine misses the deadline of 5, and since(C) < 5 is
/// false.
TEST(Shortcuts, CarriersOfInputsDoNotCoverTimes) {
    const std::string input = "event e : nat clock C var x : nat = 0";
    const auto is_open = [](const std::string& text, const std::string& claim) {
        const Answers found = answers_for_text(text);
        const std::string name = "state machine S " + claim;
        return found.verdicts.at(name) != "holds" || found.bounded.contains(name);
    };
    EXPECT_TRUE(is_open(storing(input, "(wait(x)) <{ 5 }", "true"), "timelock-free"));
    EXPECT_TRUE(is_open(storing(input, "#C ; wait(x)", "since(C) < 5"), "deadlock-free"));
    EXPECT_TRUE(is_open(storing(input, "#C ; wait(1)", "since(C) < 5 /\\ since(C) >= x"), "deadlock-free"));
    EXPECT_FALSE(
        is_open(storing(input + " var y : nat = 2", "#C ; wait(y)", "since(C) < 5 /\\ since(C) >= y"), "deadlock-free"))
        << "y is always 2";
}

/// With x = 1000, the parameter p is 500, and the operation stays in D.
TEST(Shortcuts, CarriersOfInputsDoNotCoverArguments) {
    const Answers found = answers_for_text(
        "interface O { op(p : int) } interface E { event e : int } operation op(p : int) { initial i state D { } final "
        "f "
        "transition u0 { from i to D } transition u1 { from D to f condition p <= 7 } } "
        "stm S { uses E requires O var x : int = 0 initial i state A { } state B { } transition t0 { from i to A } "
        "transition t1 { from A to B trigger e ? x action op((x / 2) as int) } transition t2 { from B to A } } "
        "controller C { uses E opref o = op sref s = S connection C on e to s on e }");
    const std::string claim = "controller C deadlock-free";
    ASSERT_TRUE(found.verdicts.contains(claim)) << found.text;
    EXPECT_TRUE(found.verdicts.at(claim) != "holds" || found.bounded.contains(claim)) << found.text;
}

/// A value that is converted to a wider type is compared with numbers of the wider type, so its carrier must contain
/// numbers around them.
TEST(Carriers, ContainTheNumbersThatConvertedValuesAreComparedWith) {
    const std::vector<std::string> machines{
        storing("event e : nat var x : nat = 0 var q : int = 0", "q = x", "q <= 7"),
        storing("event e : int var x : int = 0 var q : real = 0.0", "q = x", "q <= 2.5"),
        storing("event e : int var x : int = 0 var q : real * real", "q = (| x, x |)", "q[1] <= 7.5")};
    for (const std::string& text : machines)
        EXPECT_EQ(answers_for_text(text).verdicts.at(stuck), "fails") << text << answers_for_text(text).text;
    for (const std::string& text :
         {std::string("stm S { event e : nat var q : int = 0 initial i state A { } state B { } "
                      "transition t0 { from i to A } transition t1 { from A to B trigger e ? q } "
                      "transition t2 { from B to A condition q <= 7 } }"),
          "function twice(y : int) : real { postcondition result == y } " +
              storing("event e : int var x : int = 0 var q : real = 0.0", "q = twice(x)", "q <= 7.5")}) {
        const Answers found = answers_for_text(text);
        EXPECT_TRUE(found.verdicts.at(stuck) != "holds" || found.bounded.contains(stuck)) << text << found.text;
    }
}

/// A counter takes only the numbers that the machine computes, and inputs do not change these numbers.
TEST(Carriers, ACounterDoesNotRestOnThem) {
    const Answers found = answers_for_text(
        "stm S { event e var n : nat = 0 initial i state A { } state B { } transition t0 { from i to A } "
        "transition t1 { from A to B trigger e action n = n + 1 } transition t2 { from B to A condition n < 5 } "
        "transition t3 { from B to A condition n >= 5 action n = 0 } }");
    EXPECT_EQ(found.verdicts.at(stuck), "holds") << found.text;
    EXPECT_FALSE(found.bounded.contains(stuck)) << found.text;
}

/// The bounds of a window are indices of a sequence. The elements of the sequence are compared with 0.5 only.
TEST(Carriers, DoNotContainTheNumbersOfWindows) {
    const testing::TemporaryFile model(
        "m.rct",
        "import sequence_toolkit::* import set_toolkit::* import relation_toolkit::* "
        "stm S { event e : Seq(real) var s : Seq(real) var x : real = 0.0 initial i state A { } state B { } "
        "transition t0 { from i to A } transition t1 { from A to B trigger e ? s } "
        "transition t2 { from B to A condition min(ran(extract([31, 90], s))) < 0.5 } "
        "transition t3 { from B to A condition min(ran(extract({7, 900}, s))) < 0.5 } }");
    const auto ran = run({"check", model.path(), "--core", "--no-cache"});
    EXPECT_THAT(ran.out, ::testing::HasSubstr("nat 0..2, int -2..2, real 6 values")) << ran.out << ran.err;
    const auto concrete =
        run({"check", model.path(), "--core", "--no-cache", "--concrete", "--untimed", "--timeout", "1"});
    EXPECT_THAT(concrete.out, ::testing::HasSubstr("int -2..900")) << concrete.out << concrete.err;
}

/// A claim that compares values is decided with values: the block sends what it has received, and the machine sends 1.
/// The other claim of the model is decided with classes. The report keeps the order of the claims.
TEST(Shortcuts, ClaimsThatObserveValuesHaveNoClasses) {
    const testing::Folder folder(
        {{"m/m.rct",
          "stm S { event e : nat event out_ : nat var x : nat initial i state A { } state B { } "
          "transition t0 { from i to A } transition t1 { from A to B trigger e ? x condition x < 70 } "
          "transition t2 { from B to A action out_ ! 1 } }"},
         {"m/m.assertions",
          "untimed csp Spec csp-begin Spec = S::e.in?v -> S::out_.out!v -> Spec csp-end "
          "untimed assertion First : S refines Spec in the traces model "
          "untimed assertion Second : S is deadlock-free "}});
    const auto ran = run({"check", folder / "m", "--no-cache", "--format", "json"});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    const Json json = Json::parse(ran.out, nullptr, false);
    ASSERT_FALSE(json.is_discarded()) << ran.out << ran.err;
    const Json& claims = json.at("assertions");
    ASSERT_EQ(claims.size(), 2U);
    EXPECT_EQ(claims[0].at("answer"), "fails");
    EXPECT_EQ(claims[0].at("basis").at(0).at("kind"), "carriers");
    EXPECT_EQ(claims[1].at("answer"), "holds");
    EXPECT_FALSE(claims[1].contains("basis")) << ran.out;
    EXPECT_EQ(json.at("data").size(), 2U) << ran.out;
}

/// RoboTool's carriers end at the greatest literal, so nothing is above it.
TEST(Carriers, OfRoboToolAreThoseOfTheOptionAndOfExportedScripts) {
    const std::string text =
        "stm S { event e : nat var x : nat initial i state A { } state High { } transition t0 { from i to A } "
        "transition t1 { from A to A trigger e ? x } transition t2 { from A to High condition x > 7 } }";
    const testing::Folder folder({std::pair<std::string, std::string>("m.rct", text)});
    const std::string claim = "state machine S every transition fires";
    EXPECT_EQ(answers_for(folder / "m.rct").verdicts.at(claim), "holds");
    EXPECT_EQ(answers_for(folder / "m.rct", {"--concrete"}).verdicts.at(claim), "fails");
    ASSERT_EQ(run({"emit", "csp", folder / "m.rct", "--out", folder.path("out")}).exit, 0);
    EXPECT_THAT(tests::read_contents(folder.path("out") + "/csp-gen/m.csp"),
                ::testing::HasSubstr("nametype core_nat = {0..7}\n"));
}

/// `emit csp` writes a second script, in which classes of values replace the carriers. Its assertions have the answers
/// that `check` gives to the claims. The assertions of the first script have other answers: its carriers are
/// RoboTool's, and 21.25 is their greatest number.
TEST(Carriers, AScriptWithClassesHasTheAnswersOfTheModel) {
    const std::string model =
        "stm S { event e : real event stop var x : real initial i state A { } state High { } state Both { } junction k "
        "transition t0 { from i to A } transition t1 { from A to k trigger e ? x } "
        "transition t2 { from k to High condition x > 21.25 } transition t3 { from High to A trigger stop } "
        "transition t4 { from k to A condition not (x > 21.25) } "
        "transition t5 { from A to Both trigger stop condition x < 19.5 /\\ x > 21.25 } }";
    const std::string claims =
        "assertion A : S is deadlock-free\nassertion B : S::High is reachable in S\n"
        "assertion C : S::Both is not reachable in S\n";
    const testing::Folder folder({{"m/m.rct", model}, {"m/m.assertions", claims}});
    EXPECT_EQ(run({"check", folder / "m", "--no-cache"}).exit, 0);
    ASSERT_EQ(run({"emit", "csp", folder / "m", "--out", folder.path("out")}).exit, 0);
    const auto outcome = [&](const std::string& name) {
        return run({"cspm", folder.path("out") + "/csp-gen/" + name, "--no-cache"});
    };
    const auto concrete = outcome("m_assertions.csp");
    EXPECT_EQ(concrete.exit, 1) << concrete.out;
    const auto classes = outcome("m_classes_assertions.csp");
    EXPECT_EQ(classes.exit, 0) << classes.out << classes.err;
    EXPECT_THAT(tests::read_contents(folder.path("out") + "/csp-gen/m_classes.csp"),
                ::testing::HasSubstr("\n-- x_class: classes of values of real\n--   c1, for example 0\n"));
}

}  // namespace
}  // namespace robochart::app::data_test
