// SPDX-License-Identifier: Apache-2.0
#include "tests/prism/assertions/models.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/diagnostics/render.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/toolkits/toolkits.hpp"
#include "semantics/lower/lower.hpp"

namespace robochart::probability::testing {

std::string Loaded::report() const {
    return diagnostics::render_text(sources, diagnostics);
}

std::unique_ptr<Loaded> load(const std::map<std::string, std::string>& files) {
    auto result = std::make_unique<Loaded>();
    for (const auto& [path, text] : files)
        result->model.files.push_back(frontend::parse(result->sources, result->sources.add(path, text),
                                                      path.ends_with(".assertions"), result->diagnostics));
    frontend::add_toolkits(result->sources, result->model, result->diagnostics);
    frontend::resolve(result->model, result->diagnostics);
    if (!result->diagnostics.ok()) throw std::runtime_error(result->report());
    result->system = ir::lower(result->model, result->sources, result->diagnostics);
    if (!result->diagnostics.ok()) throw std::runtime_error(result->report());
    return result;
}

Claim find_claim(const Loaded& loaded, const std::string& name) {
    for (const auto& file : loaded.model.files)
        for (const frontend::ProbabilisticAssertion& assertion : file->probabilistic_assertions)
            if (assertion.name == name) return {file.get(), &assertion};
    throw std::runtime_error("no assertion " + name);
}

RoboToolOptions small_ranges() {
    RoboToolOptions options;
    options.preferences = {{0, 2}, {0, 2}, {0, 2}, prism::ModelKind::dtmc};
    return options;
}

std::vector<Row> robotool_rows(const Loaded& loaded, const std::string& assertion, const RoboToolOptions& options,
                               const Deciding& how) {
    std::vector<Row> rows;
    const Assertions all(loaded.model);
    const Claim claim = find_claim(loaded, assertion);
    diagnostics::Budget budget;
    try {
        RoboToolEncoding encoding(loaded.system, loaded.system.modules.front(), options,
                                  functions_of(all, *claim.file, *claim.assertion));
        const Question question = translate_assertion(all, *claim.file, *claim.assertion, encoding.elements());
        decide_question(encoding, question, how, budget, [&](Row row) { rows.push_back(std::move(row)); });
    } catch (const std::runtime_error& why) {
        rows.emplace_back().error = why.what();
    }
    return rows;
}

ir::ComponentRef whole_component(const ir::System& system) {
    ir::ComponentRef result;
    result.definition = 0;
    if (!system.modules.empty()) {
        result.kind = ir::ComponentKind::module;
        result.path = system.modules[0].name;
        result.package = system.modules[0].package;
    } else if (!system.controllers.empty()) {
        result.kind = ir::ComponentKind::controller;
        result.path = system.controllers[0].path;
        result.package = system.controllers[0].package;
    } else {
        result.kind = ir::ComponentKind::machine;
        while (system.machines[result.definition].kind != ir::MachineKind::state_machine) ++result.definition;
        result.path = system.machines[result.definition].path;
        result.package = system.machines[result.definition].package;
    }
    return result;
}

std::vector<Row> process_rows(Loaded& loaded, const std::string& assertion, Scheduler scheduler,
                              std::uint64_t* compared, std::uint64_t most_states, bool exact) {
    std::vector<Row> rows;
    const Assertions all(loaded.model);
    const Claim claim = find_claim(loaded, assertion);
    diagnostics::Budget budget;
    ProcessOptions options;
    options.scheduler = scheduler;
    options.exact = exact;
    options.max_states = most_states;
    options.budget = &budget;
    const ir::ComponentRef subject = whole_component(loaded.system);
    try {
        ProcessEncoding encoding(loaded.system, subject, loaded.sources, options);
        const Question question = translate_assertion(all, *claim.file, *claim.assertion, encoding.elements());
        decide_question(encoding, question, {1e-6, exact}, budget, [&](Row row) { rows.push_back(std::move(row)); });
        if (compared != nullptr) *compared = encoding.compared_state_count();
    } catch (const std::runtime_error& why) {
        rows.emplace_back().error = why.what();
    }
    return rows;
}

namespace {

std::string result_text(const prism::Result& result) {
    if (result.kind == prism::Result::Kind::truth) return result.truth ? "true" : "false";
    if (result.kind == prism::Result::Kind::unknown) return "not decided: " + result.reason;
    return result.low.text();
}

}  // namespace

std::string rows_text(const Row& row) {
    std::string result;
    for (const auto& [name, value] : row.constants)
        result += fmt::format("{}{}={}", result.empty() ? "" : ", ", name, value);
    if (!result.empty()) result += ": ";
    if (!row.error.empty()) return result + row.error;
    std::string values;
    for (const prism::Result& part : row.results) values += (values.empty() ? "" : " to ") + result_text(part);
    return result + values;
}

std::string rows_text(const std::vector<Row>& rows) {
    std::string result;
    for (const Row& row : rows) result += (result.empty() ? "" : "\n") + rows_text(row);
    return result;
}

}  // namespace robochart::probability::testing
