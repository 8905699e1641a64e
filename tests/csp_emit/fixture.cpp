#include "tests/csp_emit/fixture.hpp"

#include "checker/cspm/reader.hpp"
#include "checker/cspm/session.hpp"
#include "diagnostics/render.hpp"
#include "frontend/project.hpp"
#include "semantics/lower.hpp"

namespace robochart::csp_emit::testing {
namespace {

void finish(Model& model, frontend::Model& parsed) {
    if (model.diagnostics.ok()) model.system = ir::lower(parsed, model.sources, model.diagnostics);
    if (model.diagnostics.ok()) model.instantiation = ir::instantiate(model.system, {}, model.diagnostics);
}

std::string trace(const refine::Verdict& verdict, cspm::Session& session) {
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
    for (const process::Event event : verdict.counterexample->offered) result += " " + session.event_table().name(event);
    return result + " | kind " + std::to_string(static_cast<int>(verdict.counterexample->kind));
}

std::string word(const cspm::AssertionResult& result, cspm::Session& session) {
    switch (result.verdict.outcome) {
        case refine::Outcome::holds: return "holds";
        case refine::Outcome::fails: return "fails: " + trace(result.verdict, session);
        default: return "inconclusive: " + result.verdict.reason;
    }
}

}  // namespace

std::string Model::messages() const {
    return diagnostics::render_text(sources, diagnostics);
}

std::vector<std::string> Model::codes() const {
    std::vector<std::string> result;
    for (const auto& diagnostic : diagnostics.sorted()) result.emplace_back(diagnostic.rule->code);
    return result;
}

Emission Model::emit(Time time, bool core) {
    return csp_emit::emit(system, instantiation, time, {core}, sources, diagnostics);
}

std::unique_ptr<Model> model(const std::string& rct, const std::string& assertions) {
    auto result = std::make_unique<Model>();
    frontend::Model parsed;
    parsed.files.push_back(frontend::parse(result->sources, result->sources.add("model.rct", rct), false, result->diagnostics));
    if (!assertions.empty())
        parsed.files.push_back(frontend::parse(result->sources, result->sources.add("model.assertions", assertions), true,
                                               result->diagnostics));
    frontend::resolve(parsed, result->diagnostics);
    finish(*result, parsed);
    return result;
}

std::unique_ptr<Model> project(const std::string& path) {
    auto result = std::make_unique<Model>();
    const auto parsed = frontend::load_project(result->sources, path, result->diagnostics);
    finish(*result, *parsed);
    return result;
}

std::vector<std::string> verdicts(Model& model, Time time, const std::string& text) {
    Emission emission = model.emit(time);
    const auto source = model.sources.add("specification.csp", text);
    const cspm::Script more = cspm::read(model.sources, source, model.diagnostics);
    if (!model.diagnostics.ok()) return {model.messages()};
    emission.script.decls.insert(emission.script.decls.end(), more.decls.begin(), more.decls.end());
    cspm::Session session(emission.script);
    std::vector<std::string> result;
    for (const auto& assertion : session.assertions()) {
        try {
            result.push_back(word(session.check(*assertion, {}), session));
        } catch (const cspm::EvaluationError& error) {
            result.push_back(std::string("error: ") + error.what());
        }
    }
    return result;
}

std::string equal(Model& model, Time time, const std::string& process, const std::string& specification,
                  const std::string& definitions) {
    const auto results = verdicts(model, time,
                                  definitions + "\nassert " + specification + " [FD= " + process + "\nassert " + process +
                                      " [FD= " + specification + "\n");
    if (results.size() != 2) return results.empty() ? "no verdict" : results[0];
    if (results[0] != "holds") return "more than specified: " + results[0];
    if (results[1] != "holds") return "less than specified: " + results[1];
    return "holds";
}

}  // namespace robochart::csp_emit::testing
