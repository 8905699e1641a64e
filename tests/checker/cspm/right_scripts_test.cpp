// SPDX-License-Identifier: Apache-2.0
// Decides third-party scripts with known verdicts, which are in the folder of shared scripts if it is present. Each
// verdict was derived from the system that the script describes. Comments give the less obvious arguments.
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
    // At most one mathematician eats. The one who eats at even numbers reads the odd number indefinitely, so the hidden
    // system diverges.
    RightScript{"csp_mathematicians.csp", "hhh"},
    // Four philosophers at a table can take one fork each, but not if there are three seats. With all events hidden
    // they eat forever.
    RightScript{"csp_philosophers_spy.csp", "hhhhf"},
    // The author wrote each assertion so that it should hold. Remainders are never negative, and quotients are rounded
    // down.
    RightScript{"csp_questions.csp", "hhhhhhhhhhhhhhhhh"},
    // The specification of the confirmation offers both indications at once, but the protocol does not. Messages may be
    // lost, so the protocol is not deterministic, and it confirms more than C_OK.
    RightScript{"models/brp.csp", "hhhfff"},
    // If `leave` is renamed, no process leaves twice, so the system is safe. A process in which only time passes
    // diverges if time is hidden.
    RightScript{"models/il.csp", "hhhhfh"},
    // The specification allows every node to name any leader after the election. So events other than leader.3 occur,
    // but not as the first event.
    RightScript{"models/leader.csp", "fhhhfh"},
    // Without priority, the cabin passes a floor whose button is pressed. Between floors, `idle` may go on forever. The
    // watch offers all events, and every lift refuses some of them.
    RightScript{"models/lift.csp", "fhhfhf"},
    // Each assertion tests one operator. After x and y, the interrupting process still performs z. A process that
    // diverges or terminates refines CHAOS, so the negated claim fails.
    RightScript{"models/ops.csp", "hhhhfhhhhhhhhff"},
    // The gate may close late, because only hidden steps are urgent.
    RightScript{"models/rail.csp", "ffhhhh"},
    // The high events are hidden and abstracted. The lock reveals them, but copies do not. If all of them are hidden
    // without the abstraction, the process is never stable.
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
