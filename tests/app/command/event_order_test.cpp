// SPDX-License-Identifier: Apache-2.0
// Tests declared orders of events in monitors, logs, claims along runs, the event API and several machines. Correct
// code is never reported, and code that ignores the order is found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::event_order_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* patrol = R"(package stop
interface Motion { goTo(w : nat) halt() reverse() brake() }
interface Sensors { event obstacle event clear event estop event reset }
stm Patrol {
	const patience : nat = 3 clock T requires Motion uses Sensors initial start
	state Ready { }
	state Operating {
		initial j
		state Driving { entry goTo(1) }
		state Held { entry halt() }
		state BackingOff { entry reverse() }
		transition begin { from j to Driving }
		transition met { from Driving to Held trigger obstacle #T }
		transition free { from Held to Driving trigger clear }
		transition giveWay { from Held to BackingOff condition since(T) >= patience }
	}
	state Emergency { entry brake() }
	transition begin { from start to Ready }
	transition go { from Ready to Operating trigger reset }
	transition stop0 { from Ready to Emergency trigger estop }
	transition stop { from Operating to Emergency trigger estop }
	transition resume { from Emergency to Operating trigger reset }
}
)";
constexpr const char* order = "import stop::*\norder Patrol : estop first, estop drops reset\n";

/// Claims that would be violated if a dropped reset were still expected to have its effect.
constexpr const char* claims =
    "claim Drives : after estop until goTo, reset leads to goTo within 0 units\n"
    "claim Stays : after estop until reset, never goTo or reverse\n"
    "claim Resumes : after each estop, goTo only after reset\n";

/// Runs 20,000 random cycles of the code. The exit code is 0 if all monitors allow them, or the number of the monitor
/// (1 to 4) that does not.
constexpr const char* program = R"(#include <random>
#include "Patrol_core.hpp"
#include "Drives_monitor.hpp"
#include "Patrol_monitor.hpp"
#include "Resumes_monitor.hpp"
#include "Stays_monitor.hpp"
namespace core = stop::Patrol_core;
using robochart::MonitorVerdict;
struct All {
    Patrol_monitor::Monitor model; Drives_monitor::Monitor drives; Stays_monitor::Monitor stays;
    Resumes_monitor::Monitor resumes;
};
struct Platform {
    All& m;
    void goTo(std::int64_t w) noexcept {
        m.model.wrote(Patrol_monitor::out_goTo, w); m.drives.wrote(Drives_monitor::out_goTo, w);
        m.stays.wrote(Stays_monitor::out_goTo, w); m.resumes.wrote(Resumes_monitor::out_goTo, w);
    }
    void halt() noexcept { m.model.wrote(Patrol_monitor::out_halt); }
    void reverse() noexcept { m.model.wrote(Patrol_monitor::out_reverse); m.stays.wrote(Stays_monitor::out_reverse); }
    void brake() noexcept { m.model.wrote(Patrol_monitor::out_brake); }
};
int main() {
    All m; Platform platform{m}; core::State<robochart::Deployment> state;
    std::mt19937 random(7);
    for (int i = 0; i < 20000; ++i) {
        core::Inputs<robochart::Deployment> in;
        const unsigned r = static_cast<unsigned>(random());
        in.obstacle.present = (r & 3U) == 0; in.clear.present = (r >> 2U & 7U) == 0;
        in.estop.present = (r >> 5U & 3U) == 0; in.reset.present = (r >> 7U & 1U) == 0;
        const auto look = [&](auto& signal, unsigned number) {
            if (signal.present) m.model.read(number); else m.model.absent(number);
        };
        look(in.obstacle, Patrol_monitor::in_obstacle); look(in.clear, Patrol_monitor::in_clear);
        look(in.estop, Patrol_monitor::in_estop); look(in.reset, Patrol_monitor::in_reset);
        if (in.reset.present) { m.drives.read(Drives_monitor::in_reset); m.stays.read(Stays_monitor::in_reset);
            m.resumes.read(Resumes_monitor::in_reset); }
        if (in.estop.present) { m.drives.read(Drives_monitor::in_estop); m.stays.read(Stays_monitor::in_estop);
            m.resumes.read(Resumes_monitor::in_estop); }
        core::step(state, in, platform);
        m.model.end_of_cycle(); m.drives.end_of_cycle(); m.stays.end_of_cycle(); m.resumes.end_of_cycle();
        if (m.model.verdict() != MonitorVerdict::allowed) return 1;
        if (m.drives.verdict() != MonitorVerdict::allowed) return 2;
        if (m.stays.verdict() != MonitorVerdict::allowed) return 3;
        if (m.resumes.verdict() != MonitorVerdict::allowed) return 4;
    }
    return 0;
}
)";

std::string includes(const Folder& folder, const std::string& code) {
    std::string result = " -I" + (folder / (code + "/cpp/Patrol"));
    for (const char* const name : {"Patrol", "Drives", "Stays", "Resumes"})
        result += " -I" + (folder / (std::string("monitors/monitor/") + name));
    return result;
}

class EventOrder : public ::testing::Test {
protected:
    /// Compiles the program with the code in a folder, and runs it.
    [[nodiscard]] int run_with(const std::string& code) const {
        const std::string binary = folder_ / (code + ".exe");
        const Ran compiled =
            run_shell("c++ -std=c++17 -O1" + includes(folder_, code) + " " + (folder_ / "main.cpp") + " -o " + binary);
        EXPECT_EQ(compiled.exit, 0) << compiled.err;
        return run_shell(binary).exit;
    }

    Folder folder_{{{"m/patrol.rct", patrol},
                    {"m/order.claims", order},
                    {"m/claims.claims", std::string("import stop::*\n") + claims},
                    {"plain/patrol.rct", patrol},
                    {"main.cpp", program}}};
};

TEST_F(EventOrder, MonitorsAllowRightCodeAndFindCodeThatIgnoresIt) {
    ASSERT_EQ(run({"emit", "monitor", folder_ / "m/patrol.rct", "-o", folder_ / "monitors"}).exit, 0);
    ASSERT_EQ(run({"emit", "monitor", folder_ / "m/claims.claims", "-o", folder_ / "monitors"}).exit, 0);
    ASSERT_EQ(run({"emit", "cpp", folder_ / "m/patrol.rct", "-o", folder_ / "right"}).exit, 0);
    ASSERT_EQ(run({"emit", "cpp", folder_ / "plain/patrol.rct", "-o", folder_ / "wrong"}).exit, 0);
    EXPECT_EQ(run_with("right"), 0);
    EXPECT_EQ(run_with("wrong"), 1) << "the monitor of the model";
}

/// In the state Emergency, estop and reset come in the same cycle. With the order, the robot stays there. Without the
/// order, it drives.
TEST_F(EventOrder, IsKnownWhenLogsAreCompared) {
    const std::string head = "robochart-trace 1\ncomponent Patrol\n";
    const Folder logs({{"right.trace", head + "run a\nestop? brake! tock\nestop? reset? tock\nreset? goTo!1 tock\n"},
                       {"wrong.trace", head + "run a\nestop? brake! tock\nestop? reset? goTo!1 brake! tock\n"}});
    EXPECT_EQ(run({"conform", folder_ / "m", "--traces", logs / "right.trace"}).exit, 0);
    const Ran wrong = run({"conform", folder_ / "m", "--traces", logs / "wrong.trace"});
    EXPECT_EQ(wrong.exit, 1) << wrong.err;
    EXPECT_THAT(wrong.out, HasSubstr("rejected"));
    EXPECT_EQ(run({"conform", folder_ / "plain", "--traces", logs / "right.trace"}).exit, 1);
    EXPECT_EQ(run({"conform", folder_ / "plain", "--traces", logs / "wrong.trace"}).exit, 0);
}

/// A dropped reset does not require a goTo. Inputs of a cycle are simultaneous, in any order in the log.
TEST_F(EventOrder, CountsForClaimsAlongLogs) {
    const std::string head = "robochart-trace 1\ncomponent Patrol\n";
    const Folder logs({{"a.trace", head + "run a\nestop? brake! tock\nestop? reset? tock\n"},
                       {"b.trace", head + "run a\nestop? brake! tock\nreset? estop? tock\n"},
                       {"c.trace", head + "run a\nestop? brake! tock\nreset? tock\n"}});
    const auto exit_of = [&](const char* log) {
        return run({"conform", folder_ / "m/claims.claims", "--traces", logs / log}).exit;
    };
    EXPECT_EQ(exit_of("a.trace"), 0);
    EXPECT_EQ(exit_of("b.trace"), 0);
    EXPECT_EQ(exit_of("c.trace"), 1) << "reset alone owes goTo";
}

/// The graph of an adaptive suite is computed from the model under the filter, which drops events.
TEST_F(EventOrder, IsObeyedByTestSuites) {
    for (const char* const model : {"m", "plain"}) {
        const Ran suite = run({"emit", "tests", folder_ / (std::string(model) + "/patrol.rct"), "-o", folder_ / model});
        EXPECT_EQ(suite.exit, 0) << suite.err;
    }
    const std::string ordered = tests::read_contents(folder_ / "m/tests/Patrol/Patrol.graph");
    const std::string plain = tests::read_contents(folder_ / "plain/tests/Patrol/Patrol.graph");
    EXPECT_FALSE(ordered.empty());
    EXPECT_NE(ordered, plain);
}

/// A dispatched estop drops the resets after it, until time passes.
TEST_F(EventOrder, IsObeyedByDispatch) {
    const Folder folder({{"unused.txt", ""}, {"main.cpp", R"(#include <string>
#include "Patrol_core.hpp"
namespace core = stop::Patrol_core;
struct Platform {
    std::string said;
    void goTo(std::int64_t) noexcept { said += "g"; }
    void halt() noexcept { said += "h"; }
    void reverse() noexcept { said += "r"; }
    void brake() noexcept { said += "b"; }
};
int main() {
    using core::Event;
    Platform p; core::State<robochart::Deployment> s;
    core::begin(s, p);
    core::dispatch(s, Event::reset, p); core::pass(s, p);
    core::dispatch(s, Event::estop, p); core::dispatch(s, Event::reset, p); core::pass(s, p);
    if (p.said != "gb") return 1;
    core::dispatch(s, Event::estop, p); core::dispatch(s, Event::obstacle, p); core::dispatch(s, Event::reset, p);
    core::Inputs<robochart::Deployment> in; in.reset.present = true;
    core::step(s, in, p);  // the cycle to which the dispatched estop belongs
    if (p.said != "gb") return 2;
    core::dispatch(s, Event::reset, p);
    return p.said == "gbg" ? 0 : 3;
}
)"}});
    ASSERT_EQ(run({"emit", "cpp", folder_ / "m/patrol.rct", "-o", folder / "out"}).exit, 0);
    const Ran ran = run_shell("c++ -std=c++17 -Wall -Wextra -Werror -I" + (folder / "out/cpp/Patrol") + " " +
                              (folder / "main.cpp") + " -o a.out && ./a.out");
    EXPECT_EQ(ran.exit, 0) << ran.err;
}

/// The order declares a first event of the second machine. The module has another name for this event.
constexpr const char* two_machines = R"(package duo
interface Motion { halt() brake() }
interface Sensors { event obstacle event estop event reset }
interface Buttons { event obstacle event stopButton event resetButton }
module Robot {
	robotic platform Base { provides Motion uses Buttons }
	controller Brain {
		requires Motion uses Sensors
		stm Watch { requires Motion event obstacle initial i state A { } state B { entry halt() }
			transition t0 { from i to A } transition t1 { from A to B trigger obstacle } transition t2 { from B to A trigger obstacle } }
		stm Guard { requires Motion event estop event reset initial i state A { } state B { entry brake() }
			transition t0 { from i to A } transition t1 { from A to B trigger estop } transition t2 { from B to A trigger reset }
			transition t3 { from B to B trigger estop } }
		connection Brain on obstacle to Watch on obstacle
		connection Brain on estop to Guard on estop
		connection Brain on reset to Guard on reset
	}
	connection Base on obstacle to Brain on obstacle ( _async )
	connection Base on stopButton to Brain on estop ( _async )
	connection Base on resetButton to Brain on reset ( _async )
}
)";

std::string answers_of(const std::string& orders) {
    const Folder folder(
        {{"m/duo.rct", two_machines},
         {"m/duo.claims", "import duo::*\n" + orders +
                              "claim First of Robot : in a cycle with stopButton, any call but brake only after brake\n"
                              "claim Second of Robot : in a cycle with resetButton, never brake\n"}});
    const Ran ran = run({"conform", folder / "m", "--component", "Robot"});
    EXPECT_THAT(ran.out, HasSubstr("conforms")) << ran.err;
    return ran.out;
}

/// A machine that can take its first event moves before the other machines. The events that the order of a machine
/// drops are events of the module.
TEST(EventOrders, OfSeveralMachines) {
    const std::string neither = answers_of("");
    EXPECT_THAT(neither, HasSubstr("FAILS        First [this code]"));
    EXPECT_THAT(neither, HasSubstr("FAILS        Second [this code]"));
    const std::string both = answers_of("order Guard : estop first, estop drops reset\n");
    EXPECT_THAT(both, HasSubstr("FAILS        First [the model in cycles]"));
    EXPECT_THAT(both, Not(HasSubstr("FAILS        First [this code]")));
    EXPECT_THAT(both, Not(HasSubstr("FAILS        Second")));
    EXPECT_THAT(both, HasSubstr("resetButton dropped where stopButton is raised"));
    const Folder folder({{"m/duo.rct", two_machines}, {"m/duo.claims", "import duo::*\norder Guard : estop first\n"}});
    const Ran all = run({"conform", folder / "m", "--component", "Robot", "--all-choices"});
    EXPECT_EQ(all.exit, 0) << all.out << all.err;
}

TEST(EventOrders, OfEventsThatThePlatformDoesNotRaiseAreRefused) {
    std::string model = two_machines;
    const std::string connected = "	connection Base on resetButton to Brain on reset ( _async )\n";
    model.replace(model.find(connected), connected.size(), "");
    const Folder folder({{"m/duo.rct", model}, {"m/duo.claims", "import duo::*\norder Guard : estop drops reset\n"}});
    const Ran ran = run({"emit", "cpp", folder / "m", "--component", "Robot", "-o", folder / "out"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("does not raise both `estop` and `reset` of duo::Robot::Brain::Guard"));
}

}  // namespace
}  // namespace robochart::app::testing::event_order_test
