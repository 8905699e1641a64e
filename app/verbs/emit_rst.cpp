// SPDX-License-Identifier: Apache-2.0
// Implements `emit rst`, which writes RoboChart components as RoboSim models, with claims (docs/robosim.md, "From
// RoboChart").
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/numbers.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/verbs/verbs.hpp"
#include "app/verbs/write_files.hpp"
#include "conformance/check/schedulable.hpp"
#include "conformance/model/rules.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "driver/model/places.hpp"
#include "frontend/cycles/robosim.hpp"
#include "frontend/project/project.hpp"
#include "frontend/rules/rules.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::app {
namespace {

/// Returns a sentence that explains why a component cannot be run in cycles, with the code of the cause; "" if it can
/// be.
std::string cause_text(const conformance::Result& result) {
    using conformance::Outcome;
    if (result.outcome == Outcome::inconclusive) return "this was not decided: " + result.reason;
    std::string text = result.reason;
    const diagnostics::Rule* rule = result.explanation.rule;
    std::vector<std::string> where = result.explanation.where;
    if (result.outcome == Outcome::conforms) {
        const auto broken = [](const std::optional<conformance::Aside>& aside) { return aside && !aside->holds; };
        const bool twice = broken(result.register_cycles);
        if (!twice && !broken(result.deadlines)) return "";
        const conformance::Aside& aside = twice ? *result.register_cycles : *result.deadlines;
        text = twice ? "some cycle makes an output twice" : "a deadline passes while the model waits for an input";
        rule = aside.rule;
        where.clear();
    }
    if (!where.empty()) text = fmt::format("{}", fmt::join(where, "; "));
    return rule == nullptr ? text : fmt::format("{} [{}]", text, rule->code);
}

/// Returns the reason why the component is refused; "" if it can be run in register cycles.
std::string refusal(driver::Project& project, const Options& options, const ir::ComponentRef& component) {
    const refine::Limits bounds = limits(options, "cycles of " + component.path);
    try {
        std::string error;
        const auto model =
            conformance::CyclicModel::load(project.system, project.instantiation, component, options.code.cycle, bounds,
                                           project.sources, project.diagnostics, error);
        if (model == nullptr) return error;
        return cause_text(conformance::run_in_cycles(*model, project.sources, bounds));
    } catch (const std::length_error& large) {
        return large.what();
    } catch (const conformance::AlphabetError& mismatch) {
        return mismatch.what();
    } catch (const cspm::EvaluationError& failed) {
        return runs::failure_text(failed, project.system);
    }
}

/// Reads the texts together with the texts of the model. Returns the first error; "" if they are valid.
std::string error_in(const frontend::RoboSimFiles& written, const driver::Project& project) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    std::vector<diagnostics::SourceId> texts;
    std::string folder;
    for (const auto& file : project.model->files) {
        if (file->is_library || file->is_assertions) continue;
        const std::string path = project.sources.path(file->source);
        folder = path.substr(0, path.rfind('/') + 1);
        texts.push_back(sources.add(path, std::string(project.sources.source_text(file->source))));
    }
    texts.push_back(sources.add(folder + "emitted.rst", written.model));
    texts.push_back(sources.add(folder + "emitted.rsa", written.claims));
    (void)frontend::load_texts(sources, texts, findings);
    return findings.first_error();
}

}  // namespace

bool write_robosim(driver::Project& project, const Options& options, Report& report) {
    const auto components = driver::code_components(project.system, options.load.component);
    if (components.empty())
        project.diagnostics.report(rules::no_component, model_place(project),
                                   {options.load.component.empty() ? "the model" : options.load.component});
    for (const ir::ComponentRef& component : components) {
        const std::string name = ir::qualified_name(component);
        const diagnostics::Budget::Phase phase(options.run->budget(), "writing " + name + " in RoboSim");
        if (const std::string cause = refusal(project, options, component); !cause.empty()) {
            project.diagnostics.report(frontend::rules::not_schedulable, driver::declared_at(project.system, component),
                                       {name, count_text(options.code.cycle, "time unit"), cause});
            continue;
        }
        const auto written = frontend::write_robosim(*project.model, name, options.code.cycle, project.diagnostics);
        if (!written) continue;
        if (const std::string error = error_in(*written, project); !error.empty()) {
            project.diagnostics.report(frontend::rules::no_cyclic_form, driver::declared_at(project.system, component),
                                       {"a construct", name, "the text would be wrong: " + error});
            continue;
        }
        const std::string file = file_name(project, component) + "_sim";
        const std::vector<csp_emit::OutputFile> files{{file + ".rst", written->model},
                                                      {file + ".rsa", written->claims}};
        if (!write_all("rst/" + project.folder, files, report.rst_files, options, project)) return false;
        const auto edit = options.run->edit();
        report.remarks.push_back(
            project.label + name +
            (written->one_way.empty()
                 ? ": the claims say that it and the RoboSim model refine each other"
                 : ": the claims say that the RoboSim model refines it, but not the reverse: " + written->one_way));
    }
    return project.diagnostics.ok();
}

}  // namespace robochart::app
