// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::testing {
namespace {

std::string trace_text(const refine::Verdict& verdict, cspm::Session& session) {
    if (!verdict.counterexample) return verdict.reason;
    std::string result;
    for (const refine::Step& step : verdict.counterexample->steps) {
        const bool tau = step.event == process::tau;
        const process::Event shown = tau ? step.revealed : step.event;
        const std::string name = session.event_table().name(shown);
        result += result.empty() ? "" : ", ";
        result += tau ? "(" + name + ")" : name;
    }
    result += " | offers";
    for (const process::Event event : verdict.counterexample->offered)
        result += " " + session.event_table().name(event);
    return result + " | kind " + std::to_string(static_cast<int>(verdict.counterexample->kind));
}

std::string verdict_word(const cspm::AssertionResult& result, cspm::Session& session) {
    switch (result.verdict.outcome) {
        case refine::Outcome::holds:
            return "holds";
        case refine::Outcome::fails:
            return "fails: " + trace_text(result.verdict, session);
        case refine::Outcome::inconclusive:
            break;
    }
    return "inconclusive: " + result.verdict.reason;
}

const char* outcome_word(refine::Outcome outcome) {
    switch (outcome) {
        case refine::Outcome::holds:
            return "holds";
        case refine::Outcome::fails:
            return "fails";
        case refine::Outcome::inconclusive:
            break;
    }
    return "?";
}

}  // namespace

std::vector<std::string> decide_with(Model& model, Time time, const std::string& text) {
    Emission emission = model.emit(time);
    const auto source = model.sources.add("specification.csp", text);
    const cspm::Script more = cspm::read(model.sources, source, model.diagnostics);
    if (!model.diagnostics.ok()) return {model.messages()};
    emission.script.decls.insert(emission.script.decls.end(), more.decls.begin(), more.decls.end());
    return decide_script(emission.script);
}

std::vector<std::string> decide_script(const cspm::Script& script) {
    cspm::Session session(script);
    std::vector<std::string> result;
    for (const auto& assertion : session.assertions()) {
        try {
            result.push_back(verdict_word(session.check(*assertion, {}), session));
        } catch (const cspm::EvaluationError& error) {
            result.push_back(std::string("error: ") + error.what());
        }
    }
    return result;
}

std::vector<std::string> decide_obligations(Model& model, Time time) {
    const Emission emission = model.emit(time);
    if (!model.diagnostics.ok()) return {model.messages()};
    cspm::Session session(emission.script);
    std::vector<std::string> result;
    for (const Obligation& obligation : emission.obligations) {
        std::string answer = obligation.assertions.empty() ? "no check: " + obligation.reason : "holds";
        for (const auto& assertion : obligation.assertions) {
            answer = outcome_word(session.check(*assertion, {}).verdict.outcome);
            if ((answer == "holds") == obligation.one_suffices) break;
        }
        result.push_back(answer);
    }
    return result;
}

std::vector<ReportedStep> reported_steps(Model& model, Time time, const std::string& process,
                                         const std::string& specification) {
    Emission emission = model.emit(time);
    const auto source = model.sources.add("reported_steps.csp", "assert " + specification + " [T= " + process + "\n");
    const cspm::Script more = cspm::read(model.sources, source, model.diagnostics);
    emission.script.decls.insert(emission.script.decls.end(), more.decls.begin(), more.decls.end());
    cspm::Session session(emission.script);
    const auto result = session.check(*session.assertions().back(), {});
    std::vector<ReportedStep> reported;
    if (!result.verdict.counterexample) return reported;
    for (const refine::Step& step : result.verdict.counterexample->steps)
        reported.push_back(
            {session.event_table().name(step.event == process::tau ? step.revealed : step.event), step.state});
    return reported;
}

std::string check_equivalence(Model& model, Time time, const std::string& process, const std::string& specification,
                              const std::string& definitions) {
    const auto results = decide_with(model, time,
                                     definitions + "\nassert " + specification + " [FD= " + process + "\nassert " +
                                         process + " [FD= " + specification + "\n");
    if (results.size() != 2) return results.empty() ? "no verdict" : results[0];
    if (results[0] != "holds") return "more than specified: " + results[0];
    if (results[1] != "holds") return "less than specified: " + results[1];
    return "holds";
}

}  // namespace robochart::csp_emit::testing
