// SPDX-License-Identifier: Apache-2.0
// Code for models with lists: folds over windows of a sequence visit the items and build no set, lists that no later
// cycle reads are no part of the state, no type is enumerated, and lists beyond their capacity end a cycle. One program
// runs the code of four machines; the expected answers are computed by hand from the meaning of the functions.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit {
namespace {

using testing::component_named;
using testing::Folder;

const char* const machines = R"(package lists
import sequence_toolkit::* import set_toolkit::* import relation_toolkit::*
enumeration Side { ahead portside starboard }
stm Detector {
    event scan : Seq(real) event seen : Side
    const near : real = 0.5
    var ranges : Seq(real)
    initial i state Waiting { } junction which
    transition t0 { from i to Waiting }
    transition t1 { from Waiting to which trigger scan ? ranges }
    transition t2 { from which to Waiting
        condition min(ran(extract(union([1, 30], [331, 360]), ranges))) < near action seen ! Side::ahead }
    transition t3 { from which to Waiting
        condition min(ran(extract([31, 90], ranges))) < near action seen ! Side::portside }
    transition t4 { from which to Waiting
        condition min(ran(extract([271, 330], ranges))) < near action seen ! Side::starboard } }
stm Folds {
    event list : Seq(nat) event answer : nat
    var s : Seq(nat)
    initial i state A { }
    transition t0 { from i to A }
    transition t1 { from A to A trigger list ? s action
        answer ! size(s) ; answer ! size(ran(s)) ; answer ! size(extract([2, 4], s)) ;
        answer ! max(union(ran(s), {7, 11})) ;
        if 9 in ran(extract([1, 2], s)) then answer ! 1 else answer ! 0 end ;
        if exists x : nat | x in ran(s) @ x > 8 then answer ! 1 else answer ! 0 end ;
        if forall x : nat | x in ran(s) @ x > 2 then answer ! 1 else answer ! 0 end ;
        answer ! size({x : nat | x in ran(s) /\ x > 2 @ x % 3}) ;
        answer ! size(diff(ran(s), [0, 4])) ; answer ! size(inter(ran(s), [2, 5])) ;
        if filter(s, {2}) == < > then answer ! 1 else answer ! 0 end ;
        if subseteq(ran(s), [2, 9]) then answer ! 1 else answer ! 0 end ;
        if notin(4, ran(s)) then answer ! 1 else answer ! 0 end ;
        answer ! min(ran(extract([3, 8], s))) ; answer ! 42 } }
stm Blocks {
    event list : Seq(nat) event done : boolean
    var s : Seq(nat)
    initial i state A { } junction which
    transition t0 { from i to A }
    transition t1 { from A to which trigger list ? s }
    transition t2 { from which to A condition size(s) > 2 action done ! true }
    transition t3 { from which to A condition size(s) == 0 action done ! false } }
stm Grows {
    event item : nat event answer : nat
    var x : nat var all : Seq(nat)
    initial i state A { }
    transition t0 { from i to A }
    transition t1 { from A to A trigger item ? x action all = all ^ <x> ; answer ! size(all ^ <x>) } }
)";

const char* const program = R"(#include <cstdio>
#include "Blocks_core.hpp"
#include "Detector_core.hpp"
#include "Folds_core.hpp"
#include "Grows_core.hpp"
using Types = robochart::Deployment;
using robochart::StepResult;
struct Platform {
    void send_seen(lists::Detector_core::Side side) noexcept { std::printf(" %d", static_cast<int>(side)); }
    void send_answer(std::int64_t number) noexcept { std::printf(" %d", static_cast<int>(number)); }
    void send_done(bool value) noexcept { std::printf(" %d", value ? 1 : 0); }
};
using Scan = robochart::Sequence<double, 360>;
using List = robochart::Sequence<std::int64_t, 64>;
static_assert(sizeof(lists::Detector_core::State<Types>) == 1 && sizeof(lists::Folds_core::State<Types>) == 1 &&
              sizeof(lists::Blocks_core::State<Types>) == 1, "no list is part of a state");

Scan scan_of(int length, int near_1 = 0, int near_2 = 0) {
    Scan scan;
    for (int place = 1; place <= length; ++place)
        scan.append(place == near_1 || place == near_2 ? 0.25 : place == 30 ? 0.5 : 5.0);
    return scan;
}
/// The answers to a scan, and to a scan with an obstacle ahead in the next cycle.
void detect(const Scan& scan) {
    namespace core = lists::Detector_core;
    Platform platform;
    auto state = core::init<Types>();
    for (const Scan& input : {scan, scan_of(360, 1)}) {
        core::Inputs<Types> inputs;
        inputs.scan.present = true;
        inputs.scan.value = input;
        if (core::step(state, inputs, platform) != robochart::StepResult::quiescent) std::printf(" bad");
    }
    std::puts("");
}
void fold(const List& list) {
    namespace core = lists::Folds_core;
    Platform platform;
    auto state = core::init<Types>();
    core::Inputs<Types> inputs;
    inputs.list.present = true;
    inputs.list.value = list;
    for (int cycle = 0; cycle < 2; ++cycle) core::step(state, inputs, platform);
    std::puts("");
}
void block(const List& list) {
    namespace core = lists::Blocks_core;
    Platform platform;
    auto state = core::init<Types>();
    for (const List& input : {list, List::of(1, 2, 3)}) {
        core::Inputs<Types> inputs;
        inputs.list.present = true;
        inputs.list.value = input;
        core::step(state, inputs, platform);
        core::step(state, {}, platform);
    }
    std::puts("");
}
/// Lists with one item too many: an input, and one that the third cycle computes.
void overflow() {
    namespace core = lists::Grows_core;
    Scan scan = scan_of(361, 1);
    lists::Detector_core::Inputs<Types> scans;
    scans.scan.present = true;
    scans.scan.value = scan;
    Platform platform;
    auto detector = lists::Detector_core::init<Types>();
    const bool refused = lists::Detector_core::step(detector, scans, platform) == StepResult::capacity &&
                         detector == lists::Detector_core::init<Types>();
    std::printf(" %d", refused ? 1 : 0);
    auto state = core::init<Types>();
    for (int item = 1; item <= 4; ++item) {
        core::Inputs<Types> inputs;
        inputs.item.present = true;
        inputs.item.value = item;
        const StepResult result = core::step(state, inputs, platform);
        std::printf(result == StepResult::capacity ? " full" : result == StepResult::quiescent ? " ok" : " bad");
    }
    std::printf(" %d\n", static_cast<int>(state.all.size()));
}
int main() {
    for (const int near : {1, 15, 360, 331, 60, 300}) detect(scan_of(360, near));
    detect(scan_of(360, 60, 340));
    detect(scan_of(10, 3));
    detect(scan_of(50, 40));
    detect(scan_of(360));
    detect(scan_of(20));
    detect(scan_of(0));
    fold(List::of(5, 2, 9, 2));
    fold(List::of(4, 5));
    block(List::of(1, 2));
    block(List::of());
    block(List::of(7, 8, 9));
    overflow();
}
)";

/// ahead = 0, portside = 1, starboard = 2. A scan without a near reading stops the machine: no later scan has
/// an effect. A reading of exactly 0.5 (place 30) is not near. A window beyond the end of a scan has no minimum.
const char* const expected =
    " 0 0\n 0 0\n 0 0\n 0 0\n 1 0\n 2 0\n"
    " 0 0\n"  // ahead is tested before portside
    " 0 0\n 1 0\n\n\n\n"
    // <5, 2, 9, 2>, twice: 4 items, 3 different ones, 3 at the places 2 to 4; ..., 9 % 3 and
    // 5 % 3; {5, 9}; {2, 5}; ...; the least of <9, 2>
    " 4 3 3 11 0 1 0 2 2 2 0 1 1 2 42 4 3 3 11 0 1 0 2 2 2 0 1 1 2 42\n"
    // <4, 5> has no item at the places 3 to 8: the action never continues
    " 2 2 1 11 0 0 1 2 1 2 1 1 0\n"
    "\n 0 1\n 1 1\n"
    // the list has at most 2 items; its concatenation with another one is never built
    " 1 2 ok 3 ok 3 full 3 full 2\n";

TEST(Lists, FoldsVisitTheItemsAndTheStateHasNoLists) {
    const ir::System system = testing::load_model(machines);
    const Folder folder;
    Options options;
    options.explored = false;
    options.capacities = {{"scan", 360}, {"all", 2}};
    for (const char* name : {"Detector", "Folds", "Blocks", "Grows"}) {
        const Emission emission = testing::emit_ok(system, component_named(system, name), options);
        folder.write(emission);
        const auto core = std::ranges::find_if(emission.files,
                                               [](const OutputFile& file) { return file.path.ends_with("_core.hpp"); });
        ASSERT_NE(core, emission.files.end());
        EXPECT_EQ(core->text.find("any_"), std::string::npos) << "the values of a type are listed";
        EXPECT_EQ(core->text.find("robochart::Set<"), std::string::npos) << "a set is built";
    }
    folder.write("program.cpp", program);
    folder.run(
        "${CXX:-c++} -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fno-exceptions -fno-rtti "
        "-fsanitize=undefined -fno-sanitize-recover=all -I. program.cpp -o program");
    EXPECT_EQ(folder.run("./program"), expected);
}

/// A test of membership in a literal needs no toolkit function, but the header of views includes that of the toolkits.
TEST(Lists, ViewsComeWithTheHeadersThatTheyInclude) {
    const ir::System system = testing::load_model(
        "package p stm M { event a : nat var v : nat initial i transition t0 { from i to A } state A { }\n"
        "transition t1 { from A to A trigger a?v condition v in {1, 2} } }");
    const Emission emission = testing::emit_ok(system, component_named(system, "M"));
    for (const char* header : {"robochart/views.hpp", "robochart/toolkit.hpp", "robochart/matrix.hpp"})
        EXPECT_EQ(std::ranges::count(emission.files, header, &OutputFile::path), 1) << header;
}

/// Whether the variable `s` of a machine is a member of the state.
bool is_stored(const std::string& body) {
    const ir::System system = testing::load_model(
        "package p import sequence_toolkit::*\nstm M { event list : Seq(nat) event go event out_ : nat clock T\n"
        "var s : Seq(nat) initial i state A { } transition t0 { from i to A }\n" +
        body + " }");
    Options options;
    options.explored = false;
    for (const OutputFile& file : testing::emit_ok(system, component_named(system, "M"), options).files) {
        if (!file.path.ends_with("_core.hpp")) continue;
        const bool local = file.text.find("robochart::Local<") != std::string::npos;
        EXPECT_NE(local, file.text.find("lhs.s == rhs.s") != std::string::npos) << "exactly one place stores it";
        return !local;
    }
    ADD_FAILURE() << "no core";
    return false;
}

/// A list is part of the state if a later cycle may read it: in a state, after a wait, in a during action, at the
/// beginning, or in a junction whose conditions may change while control is there.
TEST(Lists, ThatLaterCyclesReadArePartOfTheState) {
    const std::string receives = "state B { } transition t1 { from A to B trigger list?s ";
    EXPECT_FALSE(is_stored(receives + "action out_!(size(s)) } transition t2 { from B to A trigger go }"));
    EXPECT_TRUE(is_stored(receives + "} transition t2 { from B to A trigger go action out_!(size(s)) }"));
    EXPECT_TRUE(is_stored(receives + "action wait(1) ; out_!(size(s)) } transition t2 { from B to A trigger go }"));
    EXPECT_FALSE(is_stored(receives + "action wait(1) ; s = <1> ; out_!(size(s)) }"));
    EXPECT_TRUE(is_stored(receives + "} state C { during out_!(size(s)) } transition t2 { from B to C trigger go }"));
    EXPECT_TRUE(is_stored("state C { entry out_!(size(s)) } transition t1 { from A to C trigger go }"));
    EXPECT_FALSE(is_stored("transition t1 { from A to A trigger go action list?s ; out_!(size(s)) }"));
    const std::string chooses =
        "state B { } junction j transition t1 { from A to j trigger list?s } transition t2 { from j to B condition ";
    EXPECT_FALSE(is_stored(chooses + "size(s) > 1 }"));
    EXPECT_TRUE(is_stored(chooses + "size(s) > 1 /\\ since(T) > 2 }"));
    EXPECT_FALSE(is_stored(chooses + "since(T) > 2 } transition t3 { from j to A action out_!(size(s)) }"));
}

}  // namespace
}  // namespace robochart::cpp_emit
