// SPDX-License-Identifier: Apache-2.0
// Third-party scripts with known verdicts, read from the folder of shared scripts if it is present. Each verdict was
// derived from the system that the script describes; comments give the less obvious arguments.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "checker/cspm/session.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {
namespace {

struct RightScript {
    const char* file;
    const char* verdicts;  ///< h holds, f fails, in the order of the assertions
};

constexpr std::array right_scripts{
    // At most one mathematician eats. The even one reads the odd number indefinitely, so the hidden system diverges.
    RightScript{"csp_mathematicians.csp", "hhh"},
    // Four philosophers at a table can take one fork each, but not if there are three seats. With all events hidden
    // they eat forever.
    RightScript{"csp_philosophers_spy.csp", "hhhhf"},
    // Each assertion is stated so that it should hold; remainders are never negative, quotients are rounded down.
    RightScript{"csp_questions.csp", "hhhhhhhhhhhhhhhhh"},
    // The confirmation's specification offers both indications at once, which the protocol does not. Messages may be
    // lost, so the protocol is not deterministic, and it confirms more than C_OK.
    RightScript{"models/brp.csp", "hhhfff"},
    // With `leave` renamed no process leaves twice, which is safe. Time alone, when hidden, is a divergence.
    RightScript{"models/il.csp", "hhhhfh"},
    // After the election, every node names any leader: events other than leader.3 occur, but not first.
    RightScript{"models/leader.csp", "fhhhfh"},
    // Without priority the cabin passes a floor whose button is pressed. Between floors `idle` may go on forever. Every
    // lift refuses some event of a watch that offers all events.
    RightScript{"models/lift.csp", "fhhfhf"},
    // One operator for each assertion. After x and y the interrupting process still performs z. A process that diverges
    // or terminates refines CHAOS, so the negated claim fails.
    RightScript{"models/ops.csp", "hhhhfhhhhhhhhff"},
    // The gate may close late, because only hidden steps are urgent.
    RightScript{"models/rail.csp", "ffhhhh"},
    // High events are hidden and abstracted. The lock reveals them; copies do not. A process that hides all of them
    // without the abstraction is never stable.
    RightScript{"models/sec.csp", "fhffhf"},
};

std::string verdicts_of(const std::filesystem::path& file) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    const Script script = read_file(sources, file.string(), found);
    if (found.ok()) (void)check_types(script, found);
    if (!found.ok()) return diagnostics::render_text(sources, found);
    std::string verdicts;
    try {
        Session session(script);
        for (const DeclPtr& assertion : session.assertions()) {
            verdicts += outcome_letter(session.check(*assertion, {}).verdict.outcome);
        }
    } catch (const EvaluationError& error) {
        verdicts += fmt::format(" {}: {}", sources.path_and_line(error.span), error.what());
    }
    return verdicts;
}

TEST(RightScripts, AreAnsweredAsTheirQuestionsSay) {
    const auto shared = shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the folder of shared scripts is absent";
    for (const RightScript& script : right_scripts)
        EXPECT_EQ(verdicts_of(shared / "suite/findings3/right" / script.file), script.verdicts) << script.file;
}

}  // namespace
}  // namespace robochart::cspm::test
