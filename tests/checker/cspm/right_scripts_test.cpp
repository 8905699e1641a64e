// Scripts from outside that were answered right, read from the folder of shared scripts where it is at hand. Each
// verdict was derived from what the script describes; where that is not plain the argument stands beside it.
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
    // At most one eats, and the odd number that the even one reads again and again makes the hidden system diverge.
    RightScript{"csp_mathematicians.csp", "hhh"},
    // Four round a table can each take one fork, but not with three seats; with all hidden they eat for ever.
    RightScript{"csp_philosophers_spy.csp", "hhhhf"},
    // Each assertion is worded as it should hold; remainders are never negative, quotients are rounded down.
    RightScript{"csp_questions.csp", "hhhhhhhhhhhhhhhhh"},
    // The specification of the confirmation offers both indications at once, which the protocol does not; messages are
    // lost or not, so that it is not deterministic, and it confirms more than C_OK.
    RightScript{"models/brp.csp", "hhhfff"},
    // With `leave` renamed nobody leaves twice, which is safe; time alone, hidden, is a divergence.
    RightScript{"models/il.csp", "hhhhfh"},
    // Once it is elected, every node names any leader: more than leader.3 comes, but not first.
    RightScript{"models/leader.csp", "fhhhfh"},
    // Without priority the cabin passes a floor whose button is pressed; between floors `idle` may go on for ever; a
    // watch that offers everything is refused something by any lift.
    RightScript{"models/lift.csp", "fhhfhf"},
    // One operator each. Behind x and y the interrupting process still does z; a process that diverges or ends is
    // within
    // CHAOS, so that the negated claim fails.
    RightScript{"models/ops.csp", "hhhhfhhhhhhhhff"},
    // The gate may close late, since only hidden steps are urgent.
    RightScript{"models/rail.csp", "ffhhhh"},
    // What is high is hidden and abstracted: the lock shows it, copies do not; what hides all of it without the
    // abstraction is never stable.
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
            const refine::Outcome outcome = session.check(*assertion, {}).verdict.outcome;
            verdicts += outcome == refine::Outcome::holds ? 'h' : outcome == refine::Outcome::fails ? 'f' : '?';
        }
    } catch (const EvaluationError& error) {
        verdicts += fmt::format(" {}: {}", sources.place(error.span), error.what());
    }
    return verdicts;
}

TEST(RightScripts, AreAnsweredAsTheirQuestionsSay) {
    const auto shared = shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the folder of shared scripts is absent";
    for (const RightScript& each : right_scripts)
        EXPECT_EQ(verdicts_of(shared / "suite/findings3/right" / each.file), each.verdicts) << each.file;
}

}  // namespace
}  // namespace robochart::cspm::test
