// SPDX-License-Identifier: Apache-2.0
// Tests code for models with lists. Folds over windows of a sequence visit the items and build no set. Lists that no
// later cycle reads are not part of the state. No type is enumerated. Lists beyond their capacity end a cycle. The
// programs run the code of small machines. The expected answers are computed by hand from the meaning of the functions.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit::lists_test {
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

/// The outputs are ahead = 0, portside = 1, starboard = 2. A scan without a near reading stops the machine, so no later
/// scan has an effect. A reading of exactly 0.5 (place 30) is not near. A window beyond the end of a scan has no
/// minimum.
const char* const expected =
    " 0 0\n 0 0\n 0 0\n 0 0\n 1 0\n 2 0\n"
    " 0 0\n"  // ahead is tested before portside
    " 0 0\n 1 0\n\n\n\n"
    // For the list <5, 2, 9, 2>, twice: 4 items, 3 different ones, 3 at the places 2 to 4; ..., 9 % 3 and 5 % 3; {5,
    // 9}; {2, 5}; ...; the least of <9, 2>.
    " 4 3 3 11 0 1 0 2 2 2 0 1 1 2 42 4 3 3 11 0 1 0 2 2 2 0 1 1 2 42\n"
    // <4, 5> has no item at the places 3 to 8, so the action never continues.
    " 2 2 1 11 0 0 1 2 1 2 1 1 0\n"
    "\n 0 1\n 1 1\n"
    // The list has at most 2 items. The code never builds its concatenation with another list.
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

/// MOST stands for the items of a long list.
const char* const full_machines = R"(package full
import sequence_toolkit::* import set_toolkit::*
datatype Point { x : nat y : nat }
stm Junction {
    event item : nat event high : nat event low : nat
    var x : nat = 0 var all : Seq(nat) = < >
    initial i state A { } junction j
    transition t0 { from i to A }
    transition t1 { from A to j trigger item ? x }
    transition t2 { from j to A condition last(all ^ <x>) > 3 action all = all ^ <x> ; high ! size(all) }
    transition t3 { from j to A condition last(all ^ <x>) <= 3 action all = all ^ <x> ; low ! size(all) } }
stm Trigger {
    event item : nat event high : nat event low : nat
    var x : nat = 0 var all : Seq(nat) = < >
    initial i state A { }
    transition t0 { from i to A }
    transition t1 { from A to A trigger item ? x condition last(all ^ <x>) > 3 action high ! x }
    transition t2 { from A to A trigger item ? x condition last(all ^ <x>) <= 3
        action all = all ^ <x> ; low ! size(all) } }
stm Action {
    event item : nat event high : nat event low : nat
    var x : nat = 0 var y : nat = 0 var all : Seq(nat) = < >
    initial i state A { }
    transition t0 { from i to A }
    transition t1 { from A to A trigger item ? x action y = last(all ^ <x>) ; high ! y ;
        if y != x then low ! 1 end ; all = all ^ <x> } }
stm Points {
    event item : nat event high : nat event low : nat
    var x : nat = 0 var all : Set(Point) = { }
    initial i state A { }
    transition t0 { from i to A }
    transition t1 { from A to A trigger item ? x action
        all = union(all, {Point (| x = x, y = 1 |)}) ; high ! size(all) } }
stm Nested {
    event item : nat event high : nat event low : nat
    var x : nat = 0 var all : Seq(nat) = < >
    initial i state A { }
    transition t0 { from i to A }
    transition t1 { from A to A trigger item ? x action
        high ! size(head(< (all ^ <x>) >)) ; all = tail(<x> ^ <x>) ^ all } }
stm Constant {
    event item : nat event high : nat event low : nat
    const most : Seq(nat) = < MOST >
    var x : nat = 0 var all : Seq(nat) = < >
    initial i state A { }
    transition t0 { from i to A }
    transition t1 { from A to A trigger item ? x action all = tail(most) ; high ! size(all) } }
stm Sender {
    event item : nat event list : Seq(nat) var x : nat = 0 var all : Seq(nat) = < >
    initial i state A { }
    transition t0 { from i to A }
    transition t1 { from A to A trigger item ? x action all = all ^ <x> ; list ! (all ^ <0>) } }
stm Receiver {
    event list : Seq(nat) event high : nat event low : nat var received : Seq(nat) = < >
    initial i state A { }
    transition t0 { from i to A }
    transition t1 { from A to A trigger list ? received condition last(received) < 1
        action high ! size(received) } }
controller Pair {
    event item : nat event high : nat event low : nat
    sref sender = Sender
    sref receiver = Receiver
    connection Pair on item to sender on item
    connection sender on list to receiver on list
    connection receiver on high to Pair on high }
)";

const char* const full_program = R"(#include <cstdio>
#include "Action_core.hpp"
#include "Constant_core.hpp"
#include "Junction_core.hpp"
#include "Nested_core.hpp"
#include "Pair_core.hpp"
#include "Points_core.hpp"
#include "Trigger_core.hpp"
struct Types : robochart::Deployment {
    static constexpr std::size_t longest = 2;
};
struct Platform {
    void send_high(std::int64_t number) noexcept { std::printf(" high%d", static_cast<int>(number)); }
    void send_low(std::int64_t number) noexcept { std::printf(" low%d", static_cast<int>(number)); }
};
const char* text_of(robochart::StepResult result) {
    if (result == robochart::StepResult::capacity) return " full";
    return result == robochart::StepResult::quiescent ? " ok" : " bad";
}
/// Drives a machine with one item in each cycle, then by its event API.
#define DRIVE(machine, ...)                                                                      \
    for (const bool by_events : {false, true}) {                                                 \
        namespace core = full::machine##_core;                                                   \
        Platform platform;                                                                       \
        auto state = core::init<Types>();                                                        \
        if (by_events) core::begin(state, platform);                                             \
        for (const int item : {__VA_ARGS__}) {                                                   \
            core::Inputs<Types> inputs;                                                          \
            inputs.item.present = true;                                                          \
            inputs.item.value = item;                                                            \
            std::printf("%s", text_of(by_events ? core::dispatch(state, core::Event::item, inputs, platform) \
                                                : core::step(state, inputs, platform)));         \
        }                                                                                        \
        std::puts("");                                                                           \
    }
int main() {
    DRIVE(Junction, 5, 9, 1)
    DRIVE(Trigger, 1, 2, 7)
    DRIVE(Action, 5, 6, 7)
    DRIVE(Points, 1, 2, 2, 3)
    DRIVE(Nested, 1, 2, 3)
    DRIVE(Constant, 1)
    DRIVE(Pair, 0, 0)
}
)";

/// All lists have at most two items, except 70 in Constant. A guard that needs a longer list is false. An action is
/// completed with the items that fit. In the third cycle of Action, the last item that fits is 6.
const char* const full_expected[] = {
    " high1 ok high2 ok full\n",
    " low1 ok low2 ok full\n",
    " high5 ok high6 ok high6 low1 full\n",
    " high1 ok high2 ok high2 ok high2 full\n",
    " high1 ok high2 ok high2 full\n",
    " high69 ok\n",
    " high2 ok full\n",
};

/// A list that does not fit ends the cycle wherever it is built: in a guard, in a value that is computed from it, in a
/// set of records, inside another list, or in a value that is sent to another machine. Both APIs report it.
TEST(Lists, NoListIsCutWithoutTheResultCapacity) {
    std::string model = full_machines;
    std::string items = "1";
    for (int item = 2; item <= 70; ++item) items += ", " + std::to_string(item);
    model.replace(model.find("MOST"), std::string("MOST").size(), items);
    const ir::System system = testing::load_model(model);
    const Folder folder;
    Options options;
    options.explored = false;
    for (const char* name : {"Junction", "Trigger", "Action", "Points", "Nested", "Constant", "Pair"})
        folder.write(testing::emit_ok(system, component_named(system, name), options));
    folder.write("program.cpp", full_program);
    folder.run("${CXX:-c++} -std=c++17 -O0 -Wall -Wextra -Wconversion -Wshadow -Werror -I. program.cpp -o program");
    std::string lines;
    for (const char* const line : full_expected) lines += std::string(line) + line;
    EXPECT_EQ(folder.run("./program"), lines);
}

/// A user's own types may make lists shorter, but not shorter than a list that the model contains.
TEST(Lists, OwnTypesHoldTheListsOfTheModel) {
    const ir::System system = testing::load_model(
        "package p stm M { event a : Seq(nat) initial i transition t0 { from i to A } state A { }\n"
        "transition t1 { from A to A action a!<1, 2, 3> } }");
    Options options;
    options.explored = false;
    const Emission emission = testing::emit_ok(system, component_named(system, "M"), options);
    const auto core = std::ranges::find(emission.files, "M_core.hpp", &OutputFile::path);
    ASSERT_NE(core, emission.files.end());
    EXPECT_NE(core->text.find("Types::longest >= 3, \"a list of the model has 3 items\""), std::string::npos);
}

/// A test of membership in a literal needs no toolkit function. But it uses the header of views, which includes the
/// header of the toolkits.
TEST(Lists, ViewsComeWithTheHeadersThatTheyInclude) {
    const ir::System system = testing::load_model(
        "package p stm M { event a : nat var v : nat initial i transition t0 { from i to A } state A { }\n"
        "transition t1 { from A to A trigger a?v condition v in {1, 2} } }");
    const Emission emission = testing::emit_ok(system, component_named(system, "M"));
    for (const char* header : {"robochart/views.hpp", "robochart/toolkit.hpp", "robochart/matrix.hpp"})
        EXPECT_EQ(std::ranges::count(emission.files, header, &OutputFile::path), 1) << header;
}

/// Returns whether the variable `s` of a machine is stored in the state.
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
/// beginning, or in a junction whose conditions may change while the machine waits there.
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
}  // namespace robochart::cpp_emit::lists_test
