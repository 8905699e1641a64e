// SPDX-License-Identifier: Apache-2.0
// Tests names and signatures of RoboTool's scripts that CSP blocks may use (semantics 3.2, 3.12, 3.13). All of them
// must exist and have RoboTool's meaning.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/builtins.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::names_test {
namespace {

// A machine with every kind of named element: a constant, a shared and a private variable, a clock, calls, a parameter.
const char* const rct = R"(
package P
interface Events {
    event e : nat
    event f
}
interface Shared {
    var y : nat
}
interface Calls {
    go(n : nat)
    rest(n : nat)
}
interface Watch {
    clock C
}
operation rest(n : nat) {
    requires Watch
    const extra : nat = 0
    initial i
    state Resting {
    }
    final f
    transition t0 {
        from i
        to Resting
    }
    transition t1 {
        from Resting
        to f
        #C
        condition since(C) >= n
    }
}
stm S {
    uses Events
    requires Shared
    requires Calls
    const k : nat = 2
    var x : nat
    clock C
    initial i
    state A {
    }
    state B {
    }
    final over
    transition t0 {
        from i
        to A
    }
    transition t1 {
        from A
        to B
        trigger e ? x
        #C
        action go(x) ; y = k
    }
    transition t2 {
        from B
        to over
        trigger f
        condition since(C) < 3
    }
}
controller Ctrl {
    uses Events
    requires Shared
    requires Calls
    opref r = rest
    sref s = S
    connection Ctrl on e to s on e
    connection Ctrl on f to s on f
}
robotic platform R {
    uses Events
    provides Shared
    provides Calls
}
module M {
    rref r = R
    cref c = Ctrl
    connection r on e to c on e ( _async )
    connection r on f to c on f ( _async )
}
)";

struct Use {
    const char* name;
    Time time;
    const char* text;  ///< a CSP block; all of its assertions must hold
};

void PrintTo(const Use& use, std::ostream* out) {
    *out << use.name;
}

class Names : public ::testing::TestWithParam<Use> {};

TEST_P(Names, AreThereForBlocks) {
    const Use& use = GetParam();
    const std::string block = std::string(use.time == Time::timed ? "timed" : "untimed") + " csp Names csp-begin\n" +
                              use.text + "\ncsp-end\n";
    const auto m = testing::load_model(rct, block);
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const Emission emission = m->emit(use.time);
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const auto verdicts = testing::decide_script(emission.script);
    EXPECT_FALSE(verdicts.empty());
    EXPECT_THAT(verdicts, ::testing::Each("holds"));
}

const Use uses[] = {
    {"D", Time::untimed,
     "assert not STOP [T= P::S::D__(0,2) |\\ {P::S::e.in.2}\nassert SKIP [T= P::S::D__(0,2) |\\ {P::S::e.out.2}"},
    {"O", Time::untimed, "assert P::S::O__(0,2) [FD= P::S::D__(0,2)\nassert P::S::D__(0,2) [FD= P::S::O__(0,2)"},
    {"VS", Time::untimed, "assert not STOP [T= P::S::VS__(0,2) |\\ {|P::S::B::entered|}"},
    {"VS_O", Time::untimed, "assert not STOP [T= P::M::VS_O__(0,2) |\\ {|P::M::c::s::B::entered|}"},
    {"FVS", Time::untimed,
     "assert not STOP [T= P::S::FVS__(0,2) |\\ {|P::S::A::entered|}\n"
     "assert not STOP [T= P::Ctrl::FVS__(0,2) |\\ {|P::Ctrl::s::A::entered|}"},
    {"FVS_C", Time::timed,
     "assert not STOP [T= P::S::FVS_C__(0,2) |\\ {|P::S::clockReset.P::S::CLID_C|}\n"
     "Hidden = prioritise(P::S::FVS_C__(0,2) \\ {|P::S::clockReset|}, <{},{tock}>)\n"
     "assert Hidden [FD= P::S::FVS__(0,2)\nassert P::S::FVS__(0,2) [FD= Hidden"},
    {"HEXT", Time::untimed,
     "assert not STOP [T= P::S::D__(0,2) |\\ {|P::S::set_EXT_y|}\n"
     "assert SKIP [T= P::S::HEXT__(0,2) |\\ {|P::S::set_EXT_y|}\n"
     "assert SKIP [T= P::Ctrl::HEXT__(0,2) |\\ {|P::Ctrl::set_EXT_y|}"},
    {"HUP", Time::untimed,
     "assert P::S::HUP__(0,2) [FD= P::S::O__(0,2)\nassert P::Ctrl::HUP__(0,2) [FD= P::Ctrl::O__(0,2)"},
    {"AS_O", Time::untimed, "assert not STOP [T= P::M::AS_O__(0,2) |\\ {|P::M::set_y|}"},
    {"sem_events", Time::untimed,
     "assert SKIP [T= P::S::D__(0,2) \\ P::S::sem__events\nassert SKIP [T= P::Ctrl::D__(0,2) \\ P::Ctrl::sem__events\n"
     "assert SKIP [T= P::M::D__(0,2) \\ P::M::sem__events\n"
     "assert not STOP [T= ([] v : P::S::sem__events @ v -> STOP) |\\ {|P::S::terminate|}"},
    {"get", Time::untimed,
     "assert P::S::D__(0,2) [FD= P::S::D__(0,2) \\ {|P::S::get_x, P::S::set_x, P::S::setL_x, P::S::setR_x|}"},
    {"set", Time::untimed,
     "assert not STOP [T= P::S::D__(0,2) |\\ {P::S::set_y.2}\nassert SKIP [T= P::S::D__(0,2) |\\ {P::S::set_y.1}"},
    {"call", Time::untimed, "assert not STOP [T= P::S::D__(0,2) |\\ {P::S::goCall.1}"},
    {"const", Time::untimed,
     "assert not STOP [T= P::S::D__(0,const_P_S_k) |\\ {P::S::set_y.const_P_S_k}\n"
     "assert not STOP [T= P::M::D__(0,const_P_Ctrl_s_k) |\\ {P::M::set_y.2}"},
    {"carriers", Time::untimed,
     "channel yes\nassert not STOP [T= (if core_nat == {0..2} and core_int == {0-2..2} and core_boolean == Bool and "
     "core_clock_type == {0..10} then yes -> STOP else STOP)"},
    {"arithmetic", Time::untimed,
     "channel yes\nassert not STOP [T= (if Plus(1,1,core_nat) == 2 and Plus(2,1,core_nat) == 2 and "
     "Mult(1,2,core_nat) == 2 and Minus(2,1,core_nat) == 1 and Neg(1,core_int) == -1 and Div(2,2,core_nat) == 1 and "
     "Modulus(2,2,core_nat) == 0 then yes -> STOP else STOP)"},
    {"waits", Time::timed,
     "channel go\n"
     "Timed(OneStep) {\n  A = timed_priority(WAIT(2) ; go -> STOP)\n  B = timed_priority(SHARE_WAIT(2) ; go -> STOP)\n"
     "  C = timed_priority(WAIT_INTERVAL({2}) ; go -> STOP)\n}\n"
     "D = tock -> tock -> E\nE = go -> F [] tock -> E\nF = tock -> F\n"
     "assert A [FD= B\nassert A [FD= C\nassert A [FD= D\nassert D [FD= A"},
    {"deadlines", Time::timed,
     "channel go\n"
     "Timed(OneStep) {\n  A = EDeadline(go,1) ; USTOP\n  B = StartBy(go -> SKIP,1) ; USTOP\n"
     "  C = Deadline(go -> SKIP,1) ; USTOP\n}\n"
     "Spec = go -> STOP [] tock -> go -> STOP\n"
     "assert Spec [FD= prioritise(A,<{},{tock}>)\nassert prioritise(A,<{},{tock}>) [FD= Spec\n"
     "assert Spec [FD= prioritise(B,<{},{tock}>)\nassert prioritise(B,<{},{tock}>) [FD= Spec\n"
     "assert Spec [FD= prioritise(C,<{},{tock}>)\nassert prioritise(C,<{},{tock}>) [FD= Spec\nassert STOP [FD= USTOP"},
    {"operation", Time::timed,
     "Clock(x__) = P::Ctrl::OP_rest::get_CLID_C!x__ -> Clock(x__)\n"
     "  [] P::Ctrl::OP_rest::clockReset.P::Ctrl::OP_rest::CLID_C -> Clock(0)\n"
     "  [] tock -> Clock(Plus(x__,1,P::Ctrl::OP_rest::CLID_C_clock_type(0,0)))\n"
     "Rest = prioritise((Clock(0) [| {|P::Ctrl::OP_rest::get_CLID_C, P::Ctrl::OP_rest::clockReset, tock|} |]\n"
     "  (P::Ctrl::OP_rest::D__(0,2,0) ; Idle)) \\ {|P::Ctrl::OP_rest::get_CLID_C|}, <{},{tock}>)\n"
     "Idle = tock -> Idle\n"
     "Spec = tock -> tock -> Reset\n"
     "Reset = P::Ctrl::OP_rest::clockReset.P::Ctrl::OP_rest::CLID_C -> Idle [] tock -> Reset\n"
     "assert Spec [FD= Rest\nassert Rest [FD= Spec"},
    {"operation_alone", Time::untimed,
     "assert SKIP [FD= P::OP_rest::D__(0,2,0)\nassert SKIP [FD= P::OP_rest::O__(0,0,0)"},
    {"clock_types", Time::timed,
     "channel yes\nassert not STOP [T= (if P::S::CLID_C_clock_type(0,2) == {0..4} then yes -> STOP else STOP)\n"
     "assert P::S::D__(0,2) [FD= P::S::D__(0,2) \\ {|P::S::get_CLID_C|}"},
};

INSTANTIATE_TEST_SUITE_P(RoboTool, Names, ::testing::ValuesIn(uses),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(Constants, CountWhereAnAssertionSetsThem) {
    const char* const project = R"(
        package P
        interface K { const c : nat = 1 }
        interface E { event a : nat }
        stm S {
            requires K
            uses E
            const d : nat = 2
            initial i
            state A { entry a ! c ; a ! d }
            transition t { from i to A }
        }
        controller C {
            uses E
            requires K
            sref s = S
            connection s on a to C on a
        }
        robotic platform R { provides K event a : nat }
        module M {
            rref r = R
            cref c = C
            connection c on a to r on a ( _async )
        }
    )";
    // In the module, c is the platform's constant. In the controller, it is the controller's constant. In the machine
    // alone, it is the machine's own. A value that is set for a machine applies to all uses of the machine, unless an
    // enclosing component provides the required constant.
    const std::map<std::string, std::set<std::string>> counts{{"S", {"S"}},
                                                              {"C", {"C", "C::s"}},
                                                              {"C::s", {"C", "C::s", "S"}},
                                                              {"M", {"M", "M::c", "M::c::s"}},
                                                              {"M::c", {"M", "M::c", "M::c::s", "C", "C::s"}},
                                                              {"M::c::s", {"M", "M::c", "M::c::s", "S"}}};
    for (const auto& [path, places] : counts)
        for (const auto& [place, unused] : counts) {
            const bool counted = places.contains(place);
            const std::string event = "P::" + path + "::a.out.";
            const auto m =
                testing::load_model(project, "csp Set csp-begin\nSet = " + event + (counted ? "0" : "1") + " -> " +
                                                 event + "2 -> STOP\ncsp-end\nuntimed assertion A : P::" + path +
                                                 " equals Set with constant c of P::" + place + " set to 0\n");
            ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
            EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ::testing::ElementsAre("holds"))
                << path << " " << place;
            EXPECT_EQ(m->codes(), counted ? std::vector<std::string>{} : std::vector<std::string>{"RC-C08"})
                << path << " " << place;
        }
}

// A machine with every construct that introduces generated parameters and bound names into the script.
const char* const variety = R"(
    interface Ops { walk(n : nat) look() }
    function twice(n : nat) : nat { precondition n < 2 postcondition result == n }
    operation walk(n : nat) {
        var k : nat
        clock T
        initial i
        final f
        state W { entry k = n }
        transition t0 { from i to W }
        transition t1 { from W to f condition since(T) >= 1 }
    }
    controller K {
        event a : nat
        event b
        event o : nat
        event p
        requires Ops
        opref w = walk
        stm S {
            event a : nat
            event b
            event o : nat
            event p
            requires Ops
            var v : nat
            var q : Seq(nat)
            clock C
            initial i
            state A { entry o ! twice(v) ; q = <v, 1> ; walk(v) during wait([0, 1]) ; p <{2} exit #C }
            state B { entry q[1] = v ; look() }
            junction k0
            transition t0 { from i to A }
            transition t1 { from A to B trigger a ? v condition since(C) < 3 }
            transition t2 { from B to k0 condition forall z : nat | z > 1 @ z > v }
            transition t3 { from k0 to A condition v > 0 }
            transition t4 { from k0 to B condition not (v > 0) action walk(1) }
            transition t5 { from B to A trigger b <{3} }
        }
        connection K on a to S on a
        connection K on b to S on b
        connection S on o to K on o
        connection S on p to K on p
    })";

/// Returns the names in the script that are not qualified with `::`.
std::set<std::string> plain_names(const std::string& text) {
    std::set<std::string> result;
    const auto part = [&](std::size_t at) {
        return std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_' || text[at] == '\'';
    };
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && part(end)) ++end;
        const bool word = end > at && std::isdigit(static_cast<unsigned char>(text[at])) == 0;
        const bool inner = at > 0 && (text[at - 1] == ':' || text.compare(end, 2, "::") == 0);
        if (word && !inner) result.insert(text.substr(at, end - at));
        at = std::max(end, at + 1);
    }
    return result;
}

// Events have names that have a meaning in CSPM or are names of generated parameters.
TEST(Names, OfEventsMayBeThoseOfParameters) {
    for (const std::string name : {"out", "x", "x__", "in__", "e__", "id__", "v_v", "tock", "tock_", "step__", "r__"}) {
        const auto m = testing::load_model("stm S { event " + name + " : nat var v : nat initial i state A { } " +
                                           "transition t0 { from i to A } transition t1 { from A to A trigger " + name +
                                           " ? v condition v > 0 action v = 1 } }");
        ASSERT_TRUE(m->diagnostics.ok()) << name << m->messages();
        for (const Time time : {Time::untimed, Time::timed}) {
            Emission emission = m->emit(time, true);
            cspm::check_types(emission.script, m->diagnostics);
            ASSERT_TRUE(m->diagnostics.ok()) << name << m->messages();
        }
        // The events of t0 and t1 alternate. Two events are received, so the process differs from STOP.
        const std::string question =
            "RECEIVED = (|~| e : diff(S::sem__events, {S::terminate}) @ e -> RECEIVED)\n"
            "assert RECEIVED [F= S::D__(0) \\ {S::terminate}\nassert STOP [T= S::D__(0)";
        const auto reported = testing::decide_with(*m, Time::untimed, question);
        ASSERT_EQ(reported.size(), 2U) << name;
        EXPECT_EQ(reported[0], "holds") << name;
        EXPECT_NE(reported[1], "holds") << name;
    }
}

// A channel, constructor or function that a block declares does not affect the generated part. If a block declares a
// name of RoboTool's scripts again at the top level, the error has its place in the block. All other blocks type check
// and keep the meaning of the script.
TEST(Names, OfBlocksAreApartFromGeneratedOnes) {
    const auto plain = testing::load_model(variety);
    ASSERT_TRUE(plain->diagnostics.ok()) << plain->messages();
    const std::string text = cspm::print(plain->emit(Time::timed).script);
    ASSERT_TRUE(plain->diagnostics.ok()) << plain->messages();
    const std::string question = "assert K::D__(0) :[deadlock free]\nassert STOP [T= K::D__(0) \\ {| K::a, K::o |}";
    const auto expected = testing::decide_with(*plain, Time::timed, question);
    std::set<std::string> twice;
    std::size_t apart = 0;
    for (const std::string& name : plain_names(text)) {
        for (const std::string& declared : {"channel " + name, name + "(one) = one"}) {
            const auto m = testing::load_model(variety, "csp Block csp-begin\n" + declared + "\ncsp-end\n");
            ASSERT_TRUE(m->diagnostics.ok()) << declared << m->messages();
            const Emission emission = m->emit(Time::timed);
            if (!m->diagnostics.ok()) continue;  // a keyword
            const cspm::Script script = emission.script;
            cspm::check_types(script, m->diagnostics);
            if (!m->diagnostics.ok()) {
                EXPECT_THAT(m->messages(), ::testing::HasSubstr("model.assertions:2")) << declared;
                twice.insert(name);
                continue;
            }
            ++apart;
            if (apart % 25 == 0) {
                EXPECT_EQ(testing::decide_with(*m, Time::timed, question), expected) << declared;
            }
        }
    }
    const std::set<std::string> known{"InOut",
                                      "in",
                                      "out",
                                      "tock",
                                      "tock'",
                                      "core_boolean",
                                      "core_int",
                                      "core_nat",
                                      "core_real",
                                      "core_string",
                                      "core_clock_type",
                                      "real_scale",
                                      "Plus",
                                      "Minus",
                                      "Mult",
                                      "Div",
                                      "Modulus",
                                      "Neg",
                                      "sbisim",
                                      "dbisim",
                                      "diamond",
                                      "prioritise",
                                      "K",
                                      "OP_walk",
                                      "twice",
                                      "pre_twice"};
    for (const std::string& name : twice) EXPECT_TRUE(known.contains(name)) << name;
    EXPECT_GT(apart, 5 * twice.size());
}

}  // namespace
}  // namespace robochart::csp_emit::names_test
