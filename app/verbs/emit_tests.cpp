// SPDX-License-Identifier: Apache-2.0
// Implements `emit tests`, which writes finite complete test suites as logs and as GoogleTest (docs/conformance.md,
// "Test suites").
#include <fmt/format.h>

#include <stdexcept>

#include "app/base/numbers.hpp"
#include "app/claims/event_order.hpp"
#include "app/command/output.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/verbs/verbs.hpp"
#include "app/verbs/write_files.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "conformance/testgen/test_suite.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "driver/model/places.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::app {
namespace {

struct Made {
    std::vector<cpp_emit::OutputFile> files;
    std::size_t states = 0, tests = 0, cycles = 0;
    bool adaptive = false;  ///< true if the model has choices; the tests then adapt to the implementation
};

std::string suite_summary(const Made& made, const Options& options, const ir::ComponentRef& component) {
    if (made.adaptive)
        return fmt::format(
            "{}: {} states over control cycles, with choices; the tests follow what the implementation does",
            component.path, made.states);
    return fmt::format("{}: {} states over control cycles, {} more allowed; {} runs, {} cycles", component.path,
                       made.states, options.conform.extra_states, with_commas(made.tests), with_commas(made.cycles));
}

/// Makes the test suite of a component. Throws std::length_error with the reason if there is none.
Made make_suite(driver::Project& project, const Options& options, const ir::ComponentRef& component,
                const refine::Limits& bounds) {
    std::string error;
    const cpp_emit::EventOrder order = event_order(project, component);
    if (!project.diagnostics.ok()) throw std::length_error("its order of events is wrong");
    const auto model = conformance::CyclicModel::load(project.system, project.instantiation, component,
                                                      control_cycle(project, component, options), bounds,
                                                      project.sources, project.diagnostics, error, order);
    if (model == nullptr) throw std::length_error(error);
    const auto choices = conformance::choice_automaton(*model, bounds);
    const std::string name = file_name(project, component);
    const std::string qualified = ir::qualified_name(component);
    if (!choices.is_deterministic()) {
        Made made{conformance::adaptive_sources(name), choices.state_count(), 0, 0, true};
        made.files.push_back(
            {name + ".graph", conformance::choice_graph(choices, *model, qualified, options.conform.extra_states)});
        return made;
    }
    const auto machine = conformance::cycle_automaton(*model, bounds);
    const auto tests = conformance::complete_suite(machine, options.conform.extra_states);
    Made made{conformance::suite_sources(name), machine.state_count(), tests.size(), 0};
    for (const auto& test : tests) made.cycles += test.size();
    made.files.push_back(
        {name + ".trace", conformance::suite_log(machine, tests, *model, qualified, options.conform.extra_states)});
    return made;
}

}  // namespace

bool write_tests(driver::Project& project, const Options& options, Report& report) {
    const auto components = driver::code_components(project.system, options.load.component, options.load.robosim);
    if (components.empty())
        project.diagnostics.report(rules::no_component, model_place(project),
                                   {options.load.component.empty() ? "the model" : options.load.component});
    for (const ir::ComponentRef& component : components) {
        const refine::Limits bounds = limits(options, "tests of " + component.path);
        std::string refused;
        diagnostics::Span place;
        try {
            const Made made = make_suite(project, options, component, bounds);
            const std::string below = fmt::format("tests/{}{}/", project.folder, file_name(project, component));
            if (!write_all(below, made.files, report.test_files, options, project)) return false;
            const auto edit = options.run->edit();
            report.remarks.push_back(project.label + suite_summary(made, options, component));
        } catch (const std::length_error& large) {
            refused = large.what();
        } catch (const cspm::EvaluationError& failed) {
            refused = runs::failure_text(failed, project.system);
            place = failed.span;
        } catch (const conformance::AlphabetError& mismatch) {
            refused = mismatch.what();
        }
        if (!refused.empty())
            project.diagnostics.report(rules::no_monitor,
                                       place.is_known() ? place : driver::declared_at(project.system, component),
                                       {component.path, refused});
    }
    return project.diagnostics.ok();
}

}  // namespace robochart::app
