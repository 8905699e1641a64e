// SPDX-License-Identifier: Apache-2.0
// Renders the report for continuous integration servers. An unknown answer is an error, because servers accept a
// skipped case.
#include <fmt/format.h>

#include "app/base/junit.hpp"
#include "app/report/report.hpp"

namespace robochart::app {
namespace {

using CaseKind = JunitCase::Kind;

CaseKind kind_of(driver::Answer answer) {
    switch (answer) {
        case driver::Answer::holds:
        case driver::Answer::computed:
            return CaseKind::passed;
        case driver::Answer::fails:
            return CaseKind::failed;
        case driver::Answer::no_check:
        case driver::Answer::unchecked:
            return CaseKind::skipped;
        case driver::Answer::inconclusive:
        case driver::Answer::error:
            return CaseKind::error;
    }
    return CaseKind::error;
}

std::string reason_of(const driver::AssertionReport& a) {
    if (!a.reason.empty()) return a.reason;
    return a.run ? a.run->end.why : "it does not hold";
}

JunitCase case_of(const driver::AssertionReport& a, const std::string& subject) {
    JunitCase made;
    made.group = a.place.empty() ? "assertions" : a.place.substr(0, a.place.rfind(':'));
    made.name = a.title;
    made.kind = kind_of(a.answer);
    made.seconds = a.statistics.seconds;
    if (made.kind == CaseKind::passed) {
        if (!a.basis.empty()) made.text = assertion_text(a, subject);
        return made;
    }
    made.message = reason_of(a);
    made.text = assertion_text(a, subject);
    return made;
}

JunitCase case_of(const ConformanceReport& c) {
    using conformance::Outcome;
    JunitCase made;
    made.group = "conformance";
    made.name = c.component;
    made.seconds = c.seconds;
    if (c.result.outcome == Outcome::conforms) return made;
    const bool unknown = c.result.outcome == Outcome::inconclusive || c.result.outcome == Outcome::not_generated ||
                         c.result.outcome == Outcome::error;
    made.kind = unknown ? CaseKind::error : CaseKind::failed;
    made.message = c.result.reason.empty() ? "the code does not conform" : c.result.reason;
    made.text = conformance_text(c);
    return made;
}

/// Makes the case of a claim about control cycles, for the model in cycles or for the generated code. If the claim
/// holds for the code, the answer for the model is only information.
JunitCase case_of(const conformance::CycleAnswers& claim, const conformance::CycleAnswer& answer,
                  std::string_view subject, const std::string& component) {
    using conformance::Outcome;
    JunitCase made;
    made.group = component;
    made.name = fmt::format("{} [{}]: {}", claim.claim, subject, claim.wording);
    if (answer.outcome == Outcome::conforms) {
        if (!claim.asked) made.text = "never asked: no cycle of the code is in its scope";
        return made;
    }
    made.kind = answer.outcome == Outcome::differs ? CaseKind::failed : CaseKind::error;
    if (claim.holds()) made.kind = CaseKind::skipped;
    made.message = answer.reason;
    made.text = cycle_answer_text(claim, subject, answer);
    return made;
}

/// Makes a case about the whole run instead of one claim.
JunitCase about_run(const std::string& name, const std::string& message, const std::string& text) {
    return {"run", name, CaseKind::error, message, text, 0};
}

}  // namespace

std::string render_junit(const Report& report) {
    std::vector<JunitCase> cases;
    for (const driver::AssertionReport& assertion : report.assertions)
        if (!assertion.core || !assertion.core->information) cases.push_back(case_of(assertion, report.subject));
    for (const ConformanceReport& component_report : report.conformance) {
        cases.push_back(case_of(component_report));
        for (const conformance::CycleAnswers& claim : component_report.result.claims) {
            cases.push_back(case_of(claim, claim.model, model_in_cycles, component_report.component));
            cases.push_back(case_of(claim, claim.code, this_code, component_report.component));
        }
    }
    for (const RefusedReport& refused : report.refused)
        cases.push_back(about_run(refused.model, "refused, with errors", refused.text));
    const bool nothing = report.assertions.empty() && report.conformance.empty() && !report.unclaimed.empty();
    if (report.nothing_checked || nothing) cases.push_back(about_run("assertions", report.unclaimed, report.unclaimed));
    if (!report.limit.empty()) cases.push_back(about_run("limit", report.limit, report.limit));
    return junit_document(report.model, cases);
}

}  // namespace robochart::app
