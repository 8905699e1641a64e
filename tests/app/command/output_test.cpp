// SPDX-License-Identifier: Apache-2.0
// Tests that every verb reports output that it cannot write as an error of the run, and writes files to the requested
// place. The shell commands close, fill and break standard output as users' pipelines do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/command.hpp"

namespace robochart::app::testing::output_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* machine =
    "stm S {\n event e\n initial i\n state A { }\n transition t0 { from i to A }\n transition t1 { from A to A trigger "
    "e }\n}\n";
constexpr const char* claim = "assertion A1 : S is deadlock-free\n";

/// Returns shell commands that write models, an assertion and a script, and then do `commands`.
std::string with_files(const std::string& commands) {
    return std::string("cat > m.rct <<'EOF'\n") + machine + "EOF\ncat > m.assertions <<'EOF'\n" + claim +
           "EOF\nprintf 'channel a\\nP = a -> P\\nassert P :[deadlock free [F]]\\n' > s.csp\n" +
           "printf 'stm   S{initial i state A{} transition t{from i to A}}' > f.rct\n" + commands;
}

class EveryVerb : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryVerb, SaysThatStandardOutputIsFull) {
    const Ran ran = run_shell(with_files(std::string("\"$verify\" ") + GetParam() + " > /dev/full"));
    EXPECT_EQ(ran.exit, 2) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("cannot write to standard output: No space left on device"));
}

TEST_P(EveryVerb, SaysThatStandardOutputIsClosed) {
    const Ran ran = run_shell(with_files(std::string("\"$verify\" ") + GetParam() + " >&-"));
    EXPECT_EQ(ran.exit, 2) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("cannot write to standard output: Bad file descriptor"));
}

TEST_P(EveryVerb, EndsQuietlyWhenItsReaderHasGone) {
    // `true` reads no input, and the pause lets it exit first. The exit code is 2 because the answer could not be
    // delivered.
    const Ran ran =
        run_shell(with_files(std::string("{ sleep 0.2; \"$verify\" ") + GetParam() + "; echo $? >&2; } | true"));
    EXPECT_THAT(ran.err, HasSubstr("2\n"));
    EXPECT_THAT(ran.err, AllOf(Not(HasSubstr("standard output")), Not(HasSubstr("internal"))));
}

TEST_P(EveryVerb, DoesNotMindThatStandardErrorIsClosed) {
    const Ran ran = run_shell(with_files(std::string("\"$verify\" ") + GetParam() + " 2>&-"));
    EXPECT_LT(ran.exit, 2) << ran.out;
    EXPECT_THAT(ran.out, Not(IsEmpty()));
}

INSTANTIATE_TEST_SUITE_P(
    Output, EveryVerb,
    ::testing::Values("--help", "--version", "check m.rct", "check --format json m.rct", "m.rct", "emit csp m.rct",
                      "emit cpp m.rct", "emit monitor m.rct", "emit tests m.rct", "conform m.rct", "cspm s.csp",
                      "cspm --format json s.csp", "cspm --format plain s.csp", "cspm --format framed_json s.csp",
                      "cspm --types s.csp", "cspm --typecheck s.csp", "cspm --export aut P s.csp", "validate m.rct",
                      "validate --format json m.rct", "validate --format sarif m.rct", "format --check f.rct",
                      "format --diff f.rct", "format - < f.rct", "explain RC-A01", "explain", "check --print ast m.rct",
                      "check --print ir m.rct", "check --print script m.rct"),
    [](const auto& instance) {
        std::string name;
        for (const char c : std::string(instance.param))
            name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
        return name;
    });

TEST(Output, OfFilesStaysInItsFolder) {
    // An attacker predicts the names of temporary files, and puts symbolic links in place of a file and of a folder.
    const Ran ran = run_shell(with_files(R"(
mkdir -p out/csp-gen/timed out/cpp away; echo mine > precious
ln -s "$PWD/precious" out/csp-gen/timed/m.csp
ln -s "$PWD/precious" out/csp-gen/timed/m.csp.part
ln -s "$PWD/away" out/cpp/S
"$verify" emit csp m.rct > /dev/null || echo "csp $?"
"$verify" emit cpp m.rct > /dev/null; echo "cpp $?"
cat precious; ls away; test -L out/csp-gen/timed/m.csp; echo "link $?")"));
    EXPECT_EQ(ran.out, "cpp 2\nmine\nlink 1\n") << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("symbolic link"));
}

TEST(Output, OfRunsAtTheSameTimeIsWhole) {
    const Ran ran = run_shell(with_files(R"(
"$verify" emit csp m.rct --out one > /dev/null
for i in 1 2 3 4 5 6; do "$verify" emit csp m.rct --out both > /dev/null & done; wait
diff -r one both && find both -name '.*' -type f)"));
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, IsEmpty());
}

TEST(Output, ThatDoesNotFitOnTheDiskLeavesNothingHalfWritten) {
    const Ran ran = run_shell(with_files(R"(
(ulimit -f 8; "$verify" emit cpp m.rct > /dev/null; echo "exit $?")
find . -name '.robochart-*')"));
    EXPECT_EQ(ran.out, "exit 2\n");
    EXPECT_THAT(ran.err, AllOf(HasSubstr("RC-A03"), HasSubstr("File too large")));
}

TEST(Output, OfFormatKeepsTheOldTextWhereTheNewOneDoesNotFit) {
    const Ran ran = run_shell(R"(
{ echo "stm S {"; i=0; while [ $i -lt 400 ]; do echo "event   e$i"; i=$((i+1)); done; echo "initial i state A {} transition t { from i to A } }"; } > big.rct
cp big.rct before; chmod 640 big.rct
(ulimit -f 2; "$verify" format big.rct; echo "exit $?")
cmp big.rct before && ls -A | wc -l
"$verify" format -q big.rct; cmp -s big.rct before || stat -c %a big.rct)");
    EXPECT_EQ(ran.out, "exit 2\n5\n640\n") << ran.err;  // big.rct, before, and the files of the three standard streams
}

// The deepest path is longer than the system accepts, so opening it fails even for root.
TEST(Input, AFolderThatCannotBeReadIsNotPassedOver) {
    for (const char* verb : {"validate m", "check m", "format --check m", "conform --traces m m.rct"}) {
        const Ran ran =
            run_shell(with_files("mkdir m; cp m.rct m; name=$(printf 'd%.0s' $(seq 200))\n"
                                 "(cd m; for i in $(seq 22); do mkdir $name; cd $name; done)\n\"$verify\" " +
                                 std::string(verb) + "; code=$?; rm -rf m; exit $code"));
        EXPECT_EQ(ran.exit, 2) << verb << ran.out;
        EXPECT_THAT(ran.err, AllOf(HasSubstr("error[RC-F01]"), HasSubstr("File name too long"))) << verb;
    }
}

TEST(Input, StandardInputThatCannotBeReadIsNoEmptyText) {
    for (const char* verb : {"format -", "cspm -", "cspm --typecheck -"}) {
        const Ran ran = run_shell("\"$verify\" " + std::string(verb) + " < .");
        EXPECT_EQ(ran.exit, 2) << verb << ran.out;
        EXPECT_THAT(ran.err, HasSubstr("cannot read")) << verb;
    }
}

}  // namespace
}  // namespace robochart::app::testing::output_test
