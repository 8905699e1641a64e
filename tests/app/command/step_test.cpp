// SPDX-License-Identifier: Apache-2.0
// Tests `step` with commands on standard input. tests/counterexample/stepper_test.cpp checks that its offers agree with
// the semantics. Another test runs the commands of docs/step.md.
#include <gmock/gmock.h>

#include <string>

#include "tests/app/command.hpp"

namespace robochart::app::testing::step_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string model = R"(package p
interface O { go(x : nat, y : real) }
stm S { requires O event e : nat event o : boolean initial i var x : nat
state A { } state B { entry go(x, 0.5); send o!true }
transition t0 { from i to A } transition t1 { from A to B trigger e?x condition x > 0 } transition t2 { from B to A } }
stm Other { initial i state A { } transition t0 { from i to A } }
)";

Ran step(const std::string& commands, const std::string& more) {
    const std::string text = "cat > m.rct <<'EOT'\n" + model + "EOT\n";
    return run_shell(text + "printf '" + commands + "' | \"$verify\" step m.rct  " + more);
}

TEST(Step, AsksWhichComponentIsMeant) {
    const Ran none = step("", "2>&1");
    EXPECT_EQ(none.exit, 4);
    EXPECT_THAT(none.out, HasSubstr("which component? p::S, p::Other"));
    const Ran wrong = step("", "Othr 2>&1");
    EXPECT_EQ(wrong.exit, 4);
    EXPECT_THAT(wrong.out, HasSubstr("no component 'Othr'; did you mean"));
}

TEST(Step, ALogOfAWayIsAccepted) {
    const Ran ran = step("tock\\n1\\n1\\n1\\ntock\\n2\\n1\\n1\\ntock\\nsave way.trace\\n",
                         "S && cat way.trace && \"$verify\" conform m.rct --component S --traces way.trace "
                         "");
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("1 accepted, 0 rejected, 0 inconclusive"));
    EXPECT_THAT(ran.out, ::testing::ContainsRegex("e\\?[1-9] go![1-9]!0.5 o!true"));
}

/// The log is written as an MCAP file, which `step` and `conform` read again.
TEST(Step, ALogMayBeAnMcapFile) {
    const Ran ran = step(
        "tock\\n1\\n1\\n1\\ntock\\n2\\n1\\n1\\ntock\\nsave way.trace\\nsave way.mcap\\nload way.mcap\\nsave "
        "again.trace\\n",
        "S && grep -v run: way.trace > a && grep -v run: again.trace > b && diff a b && \"$verify\" conform m.rct "
        "--component S --traces way.mcap");
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("1 accepted, 0 rejected, 0 inconclusive"));
}

TEST(Step, FollowsALogOfARobot) {
    const std::string log =
        "robochart-trace 1\\ncomponent p::S\\ncycle 1\\nrun a\\ntock\\ne?2 go!2!0.5 o!true tock\\ntock\\n";
    const Ran ran = step("load log.trace\\nway\\n", "S");
    EXPECT_THAT(ran.err, HasSubstr("log.trace: cannot be read"));
    EXPECT_EQ(ran.exit, 1);
    const Ran good = run_shell("cat > m.rct <<'EOT'\n" + model + "EOT\nprintf '" + log +
                               "' > log.trace; printf 'load log.trace\\nway\\n' | \"$verify\" step m.rct S ");
    EXPECT_EQ(good.exit, 0) << good.err;
    EXPECT_THAT(good.out, HasSubstr("p::S, t=3"));
    EXPECT_THAT(good.out, HasSubstr("t=1    call go(2, 0.5)"));
    const Ran bad =
        run_shell("cat > m.rct <<'EOT'\n" + model + "EOT\nprintf '" + log +
                  "e?1 go!2!0.5 tock\\n' > log.trace; printf 'load log.trace\\n' | \"$verify\" step m.rct S "
                  "");
    EXPECT_EQ(bad.exit, 1);
    EXPECT_THAT(bad.err, HasSubstr("log.trace:8: cycle 4 cannot be followed from here"));
    EXPECT_THAT(bad.out, HasSubstr("p::S, t=3")) << "it stays where the log could be followed";
    const Ran other = run_shell("cat > m.rct <<'EOT'\n" + model +
                                "EOT\nprintf 'robochart-trace 1\\ncomponent p::S\\nconst pace=3\\nrun a\\ntock\\n' > "
                                "log.trace; printf 'load log.trace\\n' | \"$verify\" step m.rct S ");
    EXPECT_EQ(other.exit, 1);
    EXPECT_THAT(other.err, HasSubstr("log.trace: is a log of the model with pace=3 (--const pace=3)"));
}

TEST(Step, AnAssertionOfAWayHoldsUntilTheModelChanges) {
    const std::string common =
        "cat > m.rct <<'EOT'\n" + model +
        "EOT\nprintf 'until t2\\nsave way.assertions\\n' | \"$verify\" step m.rct S  > out.txt; ";
    const Ran same = run_shell(common + "\"$verify\" check .  --no-cache");
    EXPECT_EQ(same.exit, 0) << same.out << same.err;
    EXPECT_THAT(same.out, HasSubstr("holds        Goes_Way_way [timed]"));
    const Ran changed =
        run_shell(common +
                  "sed -i 's/entry go(x, 0.5); /entry wait(1); go(x, 0.5); /' m.rct; \"$verify\" check . "
                  " --no-cache");
    EXPECT_EQ(changed.exit, 1) << changed.out << changed.err;
}

TEST(Step, AnOutputThatWaitsIsNoCycleOfALog) {
    const Ran ran = step("1\\n1\\ntock\\nsave way.trace\\n", "S");
    EXPECT_THAT(ran.err, HasSubstr("time passes where output o with true is on offer; in cycles it is done at once"));
}

// The way is longer than the maximal length of a definition.
TEST(Step, ALongWayIsAnAssertionToo) {
    const Ran ran = step("random 3000\\nsave way.assertions\\n", "S && \"$verify\" check . --no-cache -q");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("1 of 1 checks hold"));
}

TEST(Step, ReportsWrongCommands) {
    const Ran ran = step(
        "17\\nundo\\nundo 99\\ntock -1\\nuntil\\nrandm 2\\nsave way.txt\\nsave /proc/way.trace\\nsave "
        "m.assertions\\nsave m.assertions\\n",
        "S");
    EXPECT_EQ(ran.exit, 1);
    for (const std::string text :
         {"there is no offer 17", "there is no choice to go back from", "the way has only ",
          "-1: expected a whole number", "until what?", "no command 'randm'; did you mean 'random'?",
          "way.txt: what is saved is a log, FILE.trace or FILE.mcap, or an assertion, FILE.assertions",
          "/proc/way.trace", "m.assertions is there already, and stays as it is"})
        EXPECT_THAT(ran.err, HasSubstr(text));
}

TEST(Step, ARepeatedInputIsNoCycleOfALog) {
    const Ran ran = step("1\\n1\\n1\\n1\\nsave way.trace\\n", "S; ls way.trace");
    EXPECT_THAT(ran.err, HasSubstr("happens twice within one time unit; a cycle reads each input once"));
    EXPECT_THAT(ran.err, HasSubstr("way.trace")) << "nothing was written";
}

TEST(Step, WatchesAClockByItsName) {
    const Ran ran = run_shell(
        "printf 'stm S { clock T event e initial i state A { } transition t0 { from i to A #T } transition t1 { from A "
        "to "
        "A trigger e condition since(T) >= 3 } }' > m.rct; printf 'watch T\\ntock 2\\n' | \"$verify\" step m.rct");
    EXPECT_THAT(ran.out, HasSubstr("S: since(T) = 2")) << ran.err;
}

TEST(Step, TakesUntimedSemanticsToo) {
    const Ran ran = step("save way.trace\\n", "S --untimed");
    EXPECT_THAT(ran.err, HasSubstr("logs have time; the untimed semantics has none"));
    EXPECT_THAT(ran.out, Not(HasSubstr("t=0")));
}

TEST(Step, OfAScriptReportsWhatIsWrong) {
    const std::string script = "printf 'channel a : {0..1}\\nP = a?x -> Q(x)\\nQ(1) = STOP\\n' > s.csp; ";
    const Ran unknown = run_shell(script + "\"$verify\" step s.csp R < /dev/null");
    EXPECT_EQ(unknown.exit, 2);
    EXPECT_THAT(unknown.err, HasSubstr("'R' is not in scope"));
    const Ran partial = run_shell(script + "printf '1\\n' | \"$verify\" step s.csp P");
    EXPECT_EQ(partial.exit, 2) << partial.out << partial.err;
    EXPECT_EQ(run_shell(script + "\"$verify\" step s.csp < /dev/null").exit, 4);
}

}  // namespace
}  // namespace robochart::app::testing::step_test
