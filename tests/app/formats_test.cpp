// SPDX-License-Identifier: Apache-2.0
// Tests that a run that reaches a limit or is interrupted still answers in the requested format. The answer is one
// complete document, which says that the answer is unknown and why, and the exit code is 3. The test covers every verb
// and every machine-readable format.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/command.hpp"

namespace robochart::app::testing::formats_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* machine =
    "stm S { event e event o : nat var x : nat initial i state A { entry o ! x } transition t0 { from i to A }\n"
    " transition t { from A to A trigger e condition x < 1 action x = x + 1 } }\n";

struct Form {
    const char* name;
    const char* command;  ///< run in a folder with the files of `inputs`
    const char* schema;   ///< schema of the document; "sarif" for SARIF
};

void PrintTo(const Form& form, std::ostream* out) {
    *out << form.name;
}

/// Returns the document's statement about the limit, or "" if it contains none.
std::string limit_of(const json& document, const std::string& schema) {
    if (schema == "sarif") {
        const json& invocation = document.at("runs").at(0).at("invocations").at(0);
        if (invocation.at("executionSuccessful").get<bool>()) return "";
        return invocation.at("toolExecutionNotifications").at(0).at("message").at("text");
    }
    if (schema == "robochart-verify/refines/1")
        return document.at("errors").empty() ? "" : document.at("errors").at(0).get<std::string>();
    return document.value("limit", "");
}

void expect_whole(const Ran& ran, const Form& form, const std::string& why) {
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    const json document = json::parse(ran.out, nullptr, false);
    ASSERT_FALSE(document.is_discarded()) << "not one document: " << ran.out << ran.err;
    const std::string schema = form.schema;
    EXPECT_EQ(document.value("schema", "sarif"), schema);
    EXPECT_THAT(limit_of(document, schema), HasSubstr(why)) << ran.out;
    EXPECT_EQ(document.value("exit", 3), 3);
}

/// Returns a shell command that runs `form` in a folder with its inputs.
std::string with_inputs(const Form& form, const std::string& more) {
    return "corpus='" + repository("corpus") + "'\ncat > m.rct <<'END'\n" + std::string(machine) +
           "END\ncat > m.assertions <<'END'\nassertion A : S is deadlock-free\nEND\n"
           "cat > s.csp <<'END'\nchannel a : {0..3}\nP(n) = a!n -> P((n + 1) % 4)\nprint 1 + 1\nassert P(0) :[deadlock "
           "free]\nEND\n"
           "ln -s \"$corpus\" corpus\n"
           "printf 'robochart-trace 1\\ncomponent S\\n\\nrun a\\ntock\\n' > run.trace\n"
           "timeout -s KILL 60 \"$verify\" " +
           form.command + " " + more;
}

const Form forms[] = {
    {"verify", "verify --format json m.rct", "robochart-verify/report/1"},
    {"check", "check --format json m.rct", "robochart-verify/report/1"},
    {"checkSarif", "check --core --format sarif m.rct", "sarif"},
    {"checkCore", "check --core --sizes --format json m.rct", "robochart-verify/report/1"},
    {"emitCsp", "emit csp --format json m.rct", "robochart-verify/report/1"},
    {"emitCpp", "emit cpp --format json m.rct", "robochart-verify/report/1"},
    {"emitMonitor", "emit monitor --format json m.rct", "robochart-verify/report/1"},
    {"emitTests", "emit tests --format json m.rct", "robochart-verify/report/1"},
    {"emitRst", "emit rst --format json m.rct", "robochart-verify/report/1"},
    {"conform", "conform --format json m.rct", "robochart-verify/report/1"},
    {"conformTraces", "conform --traces run.trace --format json m.rct", ""},
    {"cspm", "cspm --format json s.csp", "robochart-verify/refines/1"},
    {"cspmTypecheck", "cspm --typecheck --format json s.csp", "robochart-verify/types/1"},
    {"cspmTypes", "cspm --types --format json s.csp", "robochart-verify/types/1"},
    {"simulate", "simulate --format json corpus/aggregation/aggregation.scenario", "robochart-verify/simulation/1"},
    {"validateJson", "validate --format json m.rct", "robochart-verify/diagnostics/1"},
    {"validateSarif", "validate --format sarif m.rct", "sarif"},
};

class Formats : public ::testing::TestWithParam<Form> {};

/// Returns the form with the schema of its document. A verb that starts by reading the model may report in either of
/// two documents.
Form with_its_schema(Form form, const Ran& ran) {
    const json document = json::parse(ran.out, nullptr, false);
    static const std::string other = "robochart-verify/traces/1";
    if (std::string(form.schema).empty())
        form.schema = document.is_object() && document.value("schema", "") == other ? "robochart-verify/traces/1"
                                                                                    : "robochart-verify/report/1";
    return form;
}

TEST_P(Formats, AreWholeWhereTimeIsUp) {
    const Ran ran = run_shell(with_inputs(GetParam(), "--timeout 0.000001"));
    expect_whole(ran, with_its_schema(GetParam(), ran), "the time limit was reached");
}

TEST_P(Formats, AreWholeWhereMemoryIsUp) {
    const Ran ran = run_shell(with_inputs(GetParam(), "--memory 64K"));
    expect_whole(ran, with_its_schema(GetParam(), ran), "the memory limit of 64 KiB was reached");
}

INSTANTIATE_TEST_SUITE_P(Verbs, Formats, ::testing::ValuesIn(forms),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(FormatsAtALimitOfStates, AreWhole) {
    for (const Form& form : {Form{"", "check --core --format json m.rct", "robochart-verify/report/1"},
                             Form{"", "conform --walks 0 --format json m.rct", "robochart-verify/report/1"},
                             Form{"", "cspm --format json s.csp", "robochart-verify/refines/1"}}) {
        const Ran ran = run_shell(with_inputs(form, "--max-states 1"));
        EXPECT_EQ(ran.exit, 3) << form.command << ran.out << ran.err;
        const json document = json::parse(ran.out, nullptr, false);
        ASSERT_FALSE(document.is_discarded()) << ran.out << ran.err;
        EXPECT_EQ(document.value("schema", ""), form.schema);
        EXPECT_THAT(ran.out, HasSubstr("the limit of 1 states was reached"));
    }
}

/// Each frame is one complete document on one line.
TEST(FormatsInFrames, AreWholeEach) {
    const Ran ran = run_shell(with_inputs({"", "cspm --format framed_json s.csp", ""}, "--timeout 0.000001"));
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    std::istringstream lines(ran.out);
    std::string line;
    std::size_t frames = 0;
    for (; std::getline(lines, line); ++frames) EXPECT_TRUE(json::accept(line)) << line;
    EXPECT_GT(frames, 0U);
}

/// Returns shell commands that interrupt the command while it reads a model. The model has so many machines that
/// parsing takes a while.
std::string interrupted(const std::string& command) {
    return "awk 'BEGIN { for (i = 0; i < 60000; ++i) printf \"stm S%d { initial i state A { } state B { } transition t "
           "{ from i to A } "
           "transition u { from A to B } }\\n\", i }' > m.rct\n"
           "timeout -s KILL 100 \"$verify\" " +
           command + " m.rct & p=$!; sleep 0.4; kill -INT $p; wait $p; exit $?";
}

TEST(FormatsOfAnInterruptedRun, AreWhole) {
    for (const Form& form : {Form{"", "check --core --format json", "robochart-verify/report/1"},
                             Form{"", "validate --format json", "robochart-verify/diagnostics/1"},
                             Form{"", "validate --format sarif", "sarif"}})
        expect_whole(run_shell(interrupted(form.command)), form, "the run was interrupted");
}

TEST(FormatsForPeople, SayTheLimitOnStandardError) {
    const Ran ran = run_shell(with_inputs({"", "validate m.rct", ""}, "--timeout 0.000001"));
    EXPECT_EQ(ran.exit, 3);
    EXPECT_EQ(ran.out, "");
    EXPECT_THAT(ran.err, HasSubstr("inconclusive: the time limit was reached"));
}

}  // namespace
}  // namespace robochart::app::testing::formats_test
