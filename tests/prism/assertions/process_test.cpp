// SPDX-License-Identifier: Apache-2.0
// Tests probabilistic assertions that are decided on the timed CSP semantics. The models are so small that their values
// can be computed by hand. Comments show how.
#include <gtest/gtest.h>

#include "tests/prism/assertions/models.hpp"

namespace robochart::probability {
namespace {

using testing::load;
using testing::process_rows;
using testing::rows_text;

std::string decided(const std::string& model, const std::string& assertions, Scheduler scheduler = Scheduler::any) {
    const auto loaded = load({{"m.rct", model}, {"m.assertions", assertions}});
    std::uint64_t compared = 0;
    const auto rows = process_rows(*loaded, "P", scheduler, &compared);
    // Every model here is small enough for the comparison with the process that is checked for refinement.
    const bool answered = !rows.empty() && rows.front().error.empty();
    EXPECT_TRUE(!answered || compared > 0);
    return rows_text(rows);
}

std::string property(const std::string& of) {
    return "prob property P : " + of;
}

/// Returns a machine that leaves Ready for a junction. `leaving` is the trigger of this transition, and `ways` are the
/// transitions from the junction p.
std::string thrower(const std::string& leaving, const std::string& ways, const std::string& declarations = "",
                    const std::string& states = "") {
    return "stm S { event go " + declarations + " initial i state Ready { } state A { } state B { } " + states +
           "probabilistic p transition t0 { from i to Ready } transition t1 { from Ready to p " + leaving + " } " +
           ways + " }";
}

const char* const coin_ways =
    "transition a { from p to A probability 0.25 } transition b { from p to B probability 0.75 }";

TEST(Process, ACoinThatIsThrownAtOnce) {
    const std::string coin = thrower("", coin_ways);
    for (const Scheduler scheduler : {Scheduler::any, Scheduler::urgent})
        EXPECT_EQ(decided(coin, property("Prob=? of [Finally S is in S::A]"), scheduler), "0.25 to 0.25");
    EXPECT_EQ(decided(coin, property("Prob=? of [Finally S is in S::A]"), Scheduler::uniform), "0.25");
    EXPECT_EQ(decided(coin, property("Prob max=? of [Finally S is in S::B]")), "0.75");
    EXPECT_EQ(decided(coin, property("Prob>=0.25 of [Finally S is in S::A]")), "true");
    EXPECT_EQ(decided(coin, property("Prob>0.25 of [Finally S is in S::A]")), "false");
    EXPECT_EQ(decided(coin, property("Forall [Finally S is in S::A \\/ S is in S::B]")), "true");
    EXPECT_EQ(decided(coin, property("Prob=? of [Finally deadlock]")), "1 to 1") << "nothing leaves A and B";
}

/// The platform may never press the button, which gives the minimum. If all steps are equally likely, the platform
/// eventually presses it.
TEST(Process, AnInputNeedNotCome) {
    const std::string coin = thrower("trigger go", coin_ways);
    const std::string reaches_a = property("Prob=? of [Finally S is in S::A]");
    EXPECT_EQ(decided(coin, reaches_a), "0 to 0.25");
    EXPECT_EQ(decided(coin, reaches_a, Scheduler::urgent), "0 to 0.25") << "time and inputs wait for nothing here";
    EXPECT_EQ(decided(coin, reaches_a, Scheduler::uniform), "0.25");
}

/// The junction leads to A with probability p, to B with probability q, and otherwise back to Ready. So A is reached
/// with probability p / (p + q).
TEST(Process, ALoopThatTriesAgain) {
    const std::string loop = thrower("",
                                     "transition a { from p to A probability 0.2 } "
                                     "transition b { from p to B probability 0.3 } "
                                     "transition c { from p to Ready probability 0.5 }");
    EXPECT_EQ(decided(loop, property("Prob=? of [Finally S is in S::A]")), "0.4 to 0.4");
    EXPECT_EQ(decided(loop, property("Prob=? of [Globally not S is in S::B]")), "0.4 to 0.4");
}

/// The first throw is immediate, and one throw follows in each time unit. The machine is done after n units with
/// probability 1 - 0.5^(n+1), and after one unit on average.
TEST(Process, TimeIsCountedInTocks) {
    const std::string geometric = thrower("",
                                          "transition a { from p to A probability 0.5 } "
                                          "transition c { from p to W probability 0.5 } "
                                          "transition r { from W to Ready }",
                                          "", "state W { entry wait(1) } ");
    const auto within = [&](const std::string& bound) {
        return decided(geometric, property("Prob=? of [Finally " + bound + " S is in S::A]"));
    };
    EXPECT_EQ(within("<=0"), "0.5 to 0.5");
    EXPECT_EQ(within("<=1"), "0.75 to 0.75");
    EXPECT_EQ(within("<3"), "0.875 to 0.875");
    EXPECT_EQ(within(">=2"), "1 to 1") << "it stays there";
    EXPECT_EQ(decided(geometric, property("Prob=? of [S is in S::W Until [2, 3] S is in S::A]")), "0 to 0");
    EXPECT_EQ(decided(geometric, property("Prob=? of [(not S is in S::A) Until [2, 3] S is in S::A]")),
              "0.1875 to 0.1875")
        << "done after 2 or 3 units: 0.125 + 0.0625";
    const std::string time = "rewards time = true : 1; endrewards ";
    EXPECT_EQ(decided(geometric, time + property("Reward {time} =? of [Reachable S is in S::A]")), "1 to 1");
    EXPECT_EQ(decided(geometric, time + property("Reward {time} =? of [Cumul 3]")), "3 to 3");
    EXPECT_EQ(decided(geometric,
                      "rewards waiting = S is in S::W : 1; endrewards " + property("Reward {waiting} =? of [Cumul 2]")),
              "0.75 to 0.75")
        << "in W during the first unit with 0.5, during the second with 0.25";
    EXPECT_EQ(decided(geometric, property("Prob max=? of [Next S is in S::A]")),
              "not decided: X is about one step, but this model does not count steps");
}

/// A coin is thrown in each time unit. The event never occurs with probability 1/8, and a bound of 10^9 units changes
/// no result.
TEST(Process, LongTimesNeedNotBeCounted) {
    const auto decide = [](const std::string& of) {
        const auto loaded =
            load({{"m.rct", thrower("",
                                    "transition a { from p to A probability 0.125 } "
                                    "transition b { from p to B probability 0.125 } "
                                    "transition c { from p to W probability 0.75 } transition r { from W to Ready }",
                                    "", "state W { entry wait(1) } ")},
                  {"m.assertions", property(of)}});
        return process_rows(*loaded, "P", Scheduler::any, nullptr, 100'000, false);
    };
    const auto rows = decide("Prob=? of [Finally <=1000000000 S is in S::A]");
    ASSERT_EQ(rows.size(), 1u);
    for (const prism::Result& result : rows.front().results) {
        ASSERT_EQ(result.kind, prism::Result::Kind::number);
        EXPECT_LE(result.low.bounds().low, 0.5);
        EXPECT_GE(result.high.bounds().high, 0.5);
        EXPECT_LT(result.high.bounds().high - result.low.bounds().low, 1e-6);
        EXPECT_EQ(result.reason, "");
    }
    EXPECT_EQ(rows_text(decide("Prob>=0.4 of [Finally <=1000000000 S is in S::A]")), "true");
    EXPECT_EQ(rows_text(decide("Prob>=0.6 of [Finally <=1000000000 S is in S::A]")), "false");
    EXPECT_EQ(rows_text(decide("Prob<=0.5 of [Globally <=1000000000 not S is in S::A]")).substr(0, 11), "not decided")
        << "it is above 0.5 by less than an interval shows";
}

/// Two machines throw a coin at the same time. The property is the probability that the first is done and the second is
/// not. It depends on the order: 0.5 if the first throws first, otherwise 0.5 * 0.5.
TEST(Process, ARaceIsOpen) {
    const std::string race =
        "stm S { initial i state Ready { entry wait(1) } state A { } state B { } probabilistic p "
        "transition t0 { from i to Ready } transition t1 { from Ready to p } "
        "transition a { from p to A probability 0.5 } transition b { from p to B probability 0.5 } } "
        "controller C { sref one = S sref two = S }";
    const std::string only_one = property("Prob=? of [Finally C::one is in S::A /\\ not C::two is in S::A]");
    EXPECT_EQ(decided(race, only_one), "0.25 to 0.5");
    EXPECT_EQ(decided(race, only_one, Scheduler::uniform), "0.375");
    EXPECT_EQ(decided(race, property("Prob=? of [Finally C::one is in S::A /\\ C::two is in S::A]")), "0.25 to 0.25");
}

/// Only probabilities read x, so the processes that are checked for refinement do not store it.
TEST(Process, ProbabilitiesReadVariables) {
    const std::string learning = thrower("",
                                         "transition a { from p to A probability if x == 0 then 0.5 else 1 - 0 end } "
                                         "transition c { from p to W probability if x == 0 then 0.5 else 0 end "
                                         "action x = x + 1 } transition r { from W to Ready }",
                                         "var x : nat = 0", "state W { entry wait(1) } ");
    EXPECT_EQ(decided(learning, property("Prob=? of [Finally <=0 S is in S::A]")), "0.5 to 0.5");
    EXPECT_EQ(decided(learning, property("Prob=? of [Finally <=1 S is in S::A]")), "1 to 1");
    EXPECT_EQ(decided(learning, property("Prob=? of [Finally S is in S::A /\\ S::x == 1]")), "0.5 to 0.5");
    EXPECT_EQ(decided(learning, property("Prob=? of [Finally S::x > 1]")), "0 to 0");
}

/// Only probabilities read the parameters and variables of the operation and the variables of its caller.
TEST(Process, ProbabilitiesInOperationsReadVariables) {
    const std::string model =
        "interface I { toss(q : real, n : nat) } interface V { var k : nat = 1 } "
        "operation toss(q : real, n : nat) { requires V terminates var m : nat = 0 initial i probabilistic p "
        "state A { } state B { } final f transition t0 { from i to p action m = n } "
        "transition a { from p to A probability if m == k then q else 0.5 * q end } "
        "transition b { from p to B probability if m == k then 1 - q else 1 - 0.5 * q end } "
        "transition ta { from A to f } transition tb { from B to f action k = 0 } } "
        "stm S { requires I var k : nat = 1 initial i state Ready { } state Heads { } state Tails { } state Again { "
        "entry toss(0.4, "
        "0) } "
        "transition t0 { from i to Ready } transition t1 { from Ready to Again action toss(0.5, 1) } "
        "transition t2 { from Again to Heads condition k == 1 } transition t3 { from Again to Tails condition k == 0 } "
        "} "
        "controller C { opref toss = toss sref s = S }";
    // In the first throw, m = 1 = k, so it leads to A with probability 0.5. A leaves k = 1, and B sets k = 0. Then m =
    // 0. After A, m differs from k, so the second throw leads to A with probability 0.2. After B, m equals k, so it
    // leads to A with probability 0.4, but k stays 0.
    EXPECT_EQ(decided(model, property("Prob=? of [Finally C::s is in S::Heads]")), "0.1 to 0.1");
    EXPECT_EQ(decided(model, property("Prob=? of [Finally C::s is in S::Tails]")), "0.9 to 0.9");
}

TEST(Process, WaysToOnePlaceAddUp) {
    EXPECT_EQ(decided(thrower("",
                              "transition a { from p to A probability 0.3 } transition b { from p to B probability 0.5 "
                              "} transition c { from p to A probability 0.2 }"),
                      property("Prob=? of [Finally S is in S::A]")),
              "0.5 to 0.5");
}

TEST(Process, ConstantsAreTriedForEveryValue) {
    const std::string coin = thrower("",
                                     "transition a { from p to A probability q } "
                                     "transition b { from p to B probability 1 - q }",
                                     "const q : real");
    EXPECT_EQ(decided(coin, property("Prob=? of [Finally S is in S::A] with constants S::q from set {0.1 to 0.3 by "
                                     "step 0.1}")),
              "S::q=0.1: 0.1 to 0.1\nS::q=0.2: 0.2 to 0.2\nS::q=0.3: 0.3 to 0.3");
    EXPECT_EQ(decided(coin, property("Prob>=S::q of [Finally S is in S::A] with constants S::q set to 0.7")),
              "S::q=0.7: true");
    EXPECT_EQ(decided(coin, property("Prob=? of [Finally S is in S::A] with constants S::q set to 2")),
              "S::q=2: the probability of a: p -> A is 2");
    EXPECT_EQ(decided(coin, property("Prob=? of [Finally S is in S::A] with constants S::q set to 1/3")),
              "S::q=1/3: the value 1/3 of q is not a decimal number");
}

TEST(Process, ProbabilitiesSumToOne) {
    EXPECT_EQ(decided(thrower("",
                              "transition a { from p to A probability 0.3 } "
                              "transition b { from p to B probability 0.6 }"),
                      property("Prob=? of [Finally S is in S::A]")),
              "the probabilities at p sum to 9/10");
}

const char* const module_text = R"(
	interface Moves { left() right() }
	stm Walker {
		requires Moves
		event go
		var steps : nat = 0
		initial i
		state Ready { }
		state Left { entry left() }
		state Right { entry right() }
		probabilistic p
		transition t0 { from i to Ready }
		transition t1 { from Ready to p trigger go action steps = steps + 1 }
		transition l { from p to Left probability 0.3 }
		transition r { from p to Right probability 0.7 }
	}
	robotic platform Robot { provides Moves event go }
	controller Mind { requires Moves event go sref walker = Walker connection Mind on go to walker on go }
	module World { rref robot = Robot cref mind = Mind connection robot on go to mind on go ( _async ) }
)";

TEST(Process, OfAModule) {
    const auto decide = [](const std::string& of, Scheduler scheduler = Scheduler::any) {
        return decided(module_text, property(of), scheduler);
    };
    EXPECT_EQ(decide("Prob=? of [Finally World::mind::walker is in Walker::Left]"), "0 to 0.3");
    EXPECT_EQ(decide("Prob max=? of [Finally <=0 World::mind::walker is in Walker::Right /\\ "
                     "World::mind::walker::steps == 1]"),
              "0.7");
    EXPECT_EQ(decide("Prob=? of [Finally World::mind::walker::steps > 1]"), "0 to 0");
}

/// The first throw is immediate, and one throw follows in each time unit. Each throw is announced. The machine needs 1
/// / 0.5 throws on average until A, and the event contains the result of the last throw.
const char* const announced = R"(
	stm S {
		event said : nat
		event done
		var n : nat = 0
		initial i
		state Ready { }
		state W { entry wait(1) }
		state A { }
		probabilistic p
		transition t0 { from i to Ready }
		transition t1 { from Ready to p action n = (if n < 2 then n + 1 else n end) ; said!n }
		transition a { from p to A probability 0.5 action done }
		transition c { from p to W probability 0.5 }
		transition r { from W to Ready }
	}
)";

TEST(Process, EventsAreRewarded) {
    const auto earned = [](const std::string& items, const std::string& what) {
        return decided(announced, "rewards r = " + items + " endrewards " + property("Reward {r} =? of [" + what + "]"),
                       Scheduler::urgent);
    };
    EXPECT_EQ(earned("[S::said.out] true : 1;", "Reachable S is in S::A"), "2 to 2");
    EXPECT_EQ(earned("[S::said.out] true : 1; [S::done.out] true : 10;", "Total"), "12 to 12");
    EXPECT_EQ(earned("[S::said.out] S::n == 2 : 1;", "Total"), "1 to 1")
        << "the second throw and those after it: 0.5 + 0.25 + ...";
    EXPECT_EQ(earned("[S::said.out] true : 1; true : 100;", "Cumul 2"), "201.5 to 201.5")
        << "two units, and a throw at the beginning of each: 1 + 0.5";
}

TEST(Process, ValuesOfEventsAreAskedFor) {
    EXPECT_EQ(
        decided(announced, property("Prob=? of [Finally S is in S::A /\\ S::said.out.val == 1]"), Scheduler::urgent),
        "0.5 to 0.5");
    EXPECT_EQ(
        decided(announced, property("Prob=? of [Finally S is in S::A /\\ S::said.out.val == 2]"), Scheduler::urgent),
        "0.5 to 0.5");
    EXPECT_EQ(decided(announced, property("Prob=? of [S::said.out.val == 0 Until S is in S::A]")), "0 to 0")
        << "0 only before the first";
}

/// One of two machines throws when the platform requests it. Rewards distinguish events of the platform from events of
/// a machine, although the process has one event for both. An internal event occurs at both of its ends at the same
/// time.
const char* const pair_text = R"(
	robotic platform Table { event go }
	stm Thrower {
		event go
		event heads
		initial i
		state Ready { }
		state Heads { }
		probabilistic toss
		transition t0 { from i to Ready }
		transition t1 { from Ready to toss trigger go }
		transition t2 { from toss to Heads probability 0.5 action heads }
		transition t3 { from toss to Ready probability 0.5 }
	}
	stm Listener {
		event heads
		initial i
		state Waiting { }
		state Heard { }
		transition t0 { from i to Waiting }
		transition t1 { from Waiting to Heard trigger heads }
	}
	controller Hands {
		event go
		sref one = Thrower
		sref ear = Listener
		connection Hands on go to one on go
		connection one on heads to ear on heads
	}
	module Game { rref table = Table cref hands = Hands connection table on go to hands on go ( _async ) }
)";

TEST(Process, EventsInsideAModuleAreRewarded) {
    const auto earned = [](const std::string& items) {
        return decided(pair_text,
                       "rewards r = " + items + " endrewards " +
                           property("Reward {r} min=? of [Reachable Game::hands::ear is in Listener::Heard]"),
                       Scheduler::uniform);
    };
    EXPECT_EQ(earned("[Game::table::go.out] true : 1;"), "2");
    EXPECT_EQ(earned("[Game::hands::one::go.in] true : 1;"), "2");
    EXPECT_EQ(earned("[Game::hands::one::go.in] true : 1; [Game::table::go.out] true : 3;"), "8")
        << "one step is both, and earns both";
    EXPECT_EQ(earned("[Game::hands::one::heads.out] true : 1; [Game::hands::ear::heads.in] true : 3;"), "4");
}

/// The observer terminates together with the module. Events whose names are CSPM keywords have other names in the
/// script.
TEST(Process, EventsOfAMachineThatEndsAreRewarded) {
    const char* const ending = R"(
		robotic platform Table { event channel : nat event STOP }
		stm Thrower {
			event channel : nat
			event STOP
			var v : nat = 0
			initial i
			state Ready { }
			final f
			probabilistic p
			transition t0 { from i to Ready }
			transition t1 { from Ready to p trigger channel?v }
			transition t2 { from p to f probability 0.25 action STOP }
			transition t3 { from p to Ready probability 0.75 }
		}
		controller Hand {
			event channel : nat
			event STOP
			sref one = Thrower
			connection Hand on channel to one on channel
			connection one on STOP to Hand on STOP
		}
		module Game {
			rref table = Table
			cref hand = Hand
			connection table on channel to hand on channel ( _async )
			connection hand on STOP to table on STOP ( _async )
		}
	)";
    const auto earned = [&](const std::string& items) {
        return decided(ending, "rewards r = " + items + " endrewards " + property("Reward {r} =? of [Total]"),
                       Scheduler::uniform);
    };
    EXPECT_EQ(earned("[Game::table::channel.out] true : 1;"), "4") << "1 / 0.25 throws";
    EXPECT_EQ(earned("[Game::hand::one::channel.in] true : 1; [Game::table::STOP.in] true : 10;"), "14");
    EXPECT_EQ(decided(ending, property("Prob max=? of [Finally Game::table::channel.out.val == 2]")), "1");
    EXPECT_EQ(decided(ending, property("Prob max=? of [Finally Game::table::channel.out.val == 2 /\\ "
                                       "Game::hand::one::channel.in.val == 1]")),
              "0")
        << "it is one event";
}

TEST(Process, WhatHasNoCounterpartIsRefusedByName) {
    const std::string coin = thrower("", coin_ways);
    EXPECT_EQ(decided(thrower("trigger go", coin_ways), property("Prob=? of [Finally S::go.in.val == 0]")),
              "the value of `S::go`, which has none");
    EXPECT_EQ(decided(coin, "rewards r = [S::go.out] true : 1; endrewards " + property("Reward {r} =? of [Total]")),
              "the process has no event `S::go.out`");
    EXPECT_EQ(
        decided(coin, "pmodules M: pmodule N { x : bool; } " + property("Prob=? of [Finally @M::N::x] with modules M")),
        "`with modules`: the modules of assertions run beside models of PRISM, in RoboTool's encoding");
}

}  // namespace
}  // namespace robochart::probability
