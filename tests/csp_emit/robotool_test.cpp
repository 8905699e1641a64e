// SPDX-License-Identifier: Apache-2.0
// Compares this program's processes with RoboTool's own scripts for the same models. Each refines the other in the
// failures-divergences model under RoboTool's instantiations. The scripts are shared reference material.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/lookup.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "tests/csp_emit/fixture.hpp"
#include "tests/csp_emit/robotool_scripts.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::csp_emit::robotool_test {
namespace {

namespace b = cspm::build;
using cspm::DeclPtr;
using cspm::ExprPtr;
using testing::join_scripts;
using testing::names_of;

struct Component {
    std::string name;  ///< "C::stm0"
    ExprPtr process;   ///< C::stm0::D__(0, constants...)
};

/// Returns all components, taken from the assertions that are generated for them.
std::vector<Component> components_of(const Emission& ours) {
    std::vector<Component> result;
    for (const Obligation& obligation : ours.obligations)
        for (const DeclPtr& assertion : obligation.assertions) {
            const ExprPtr& process = assertion->assertion.specification;
            if (assertion->assertion.kind != cspm::AssertionKind::deterministic) continue;
            const std::string& name = process->args[0]->text;
            result.push_back({name.substr(0, name.size() - std::string("::D__").size()), process});
        }
    return result;
}

/// Returns the channels of the component's sem__events.
std::vector<std::string> alphabet_of(const cspm::Script& script, const std::string& path) {
    const DeclPtr events = cspm::declaration_of(script, path + "::sem__events");
    EXPECT_TRUE(events) << path;
    std::vector<std::string> result;
    if (events)
        for (const ExprPtr& channel : events->body->args) result.push_back(channel->text);
    return result;
}

ExprPtr call_process(const ExprPtr& process, const std::string& name) {
    auto result = std::make_shared<cspm::Expr>(*process);
    result->args[0] = b::name(name);
    return result;
}

/// Reduces the carriers of numbers to few values.
void narrow_carriers(cspm::Script& script) {
    for (DeclPtr& decl : script.decls) {
        const auto names = names_of({decl});
        if (names.contains("core_int")) decl = b::nametype("core_int", b::set_range(b::number(-1), b::number(1)));
        if (names.contains("core_real")) decl = b::nametype("core_real", b::set_range(b::number(0), b::number(1)));
    }
}

/// How this program's scripts represent variables: as parameters of the machine's process, or in separate memory
/// processes.
enum class Variables { parameters, memories };

using Case = std::tuple<std::string, Time, Variables>;

class RoboTool : public ::testing::TestWithParam<Case> {};

/// Checks both refinements for every component of the model. Some constants have other values than the default.
void compare_components(testing::Model& m, Time time, Variables variables, const std::string& script_path,
                        const std::map<std::string, std::int64_t>& constants = {}) {
    const Emission ours = variables == Variables::memories ? m.emit_with_memories(time, true) : m.emit(time, true);
    auto theirs = cspm::read_file(m.sources, script_path, m.diagnostics);
    ASSERT_TRUE(m.diagnostics.ok()) << m.messages();
    for (DeclPtr& decl : theirs.decls)
        for (const std::string& name : names_of({decl}))
            if (const auto found = constants.find(name); found != constants.end())
                decl = b::value(name, b::number(found->second));
    for (const Component& component : components_of(ours)) {
        std::vector<cspm::Link> links;
        for (const std::string& event : alphabet_of(ours.definitions, component.name))
            links.push_back(
                {b::name("ours__::" + component.name + "::" + event), b::name(component.name + "::" + event)});
        const ExprPtr own = b::rename(call_process(component.process, "ours__::" + component.name + "::D__"), links);
        const ExprPtr other = call_process(component.process, component.name + "::O__");
        cspm::Script script = join_scripts(theirs, ours);
        // If this machine is checked alone, the environment may set four of its variables to any value. RoboTool's
        // script takes seconds with few values and minutes with all of them.
        if (component.name == "ObsDetector::ObsDetect" && std::getenv("ROBOCHART_SLOW") == nullptr)
            narrow_carriers(script);
        script.decls.push_back(b::assert_refines(own, cspm::Model::failures_divergences, other));
        script.decls.push_back(b::assert_refines(other, cspm::Model::failures_divergences, own));
        EXPECT_EQ(testing::decide_script(script), std::vector<std::string>(2, "holds")) << component.name;
    }
}

TEST_P(RoboTool, AgreesBothWays) {
    const auto& [model, time, variables] = GetParam();
    const std::string root = robochart::tests::shared_folder().string() + "/suite/robotool-csp/";
    if (!std::filesystem::exists(root)) GTEST_SKIP() << "no shared scripts at " << root;
    const auto m = testing::model_file(root + "models/" + model + ".rct");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    // The script of a model in a package is named after the package.
    const std::string script = model == "example2" ? "ex2" : "file_" + model;
    compare_components(*m, time, variables, root + (time == Time::timed ? "timed/" : "untimed/") + script + ".csp");
}

class NewestRoboTool : public ::testing::TestWithParam<std::tuple<Time, Variables>> {};

TEST_P(NewestRoboTool, AgreesOnTheRangerModel) {
    const std::string root = robochart::tests::shared_folder().string() + "/suite/robotool-csp-2026/";
    if (!std::filesystem::exists(root)) GTEST_SKIP() << "no shared scripts at " << root;
    const auto m = testing::model_file(root + "SimFW.rct");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const auto& [time, variables] = GetParam();
    const std::string folder = time == Time::timed ? "timed/" : "untimed/";
    // With RoboTool's default constants the model divides by zero.
    const std::string prefix = "const_SimFW_SMovement_";
    compare_components(*m, time, variables, root + folder + "SimFW.csp",
                       {{prefix + "PI", 3}, {prefix + "av", 2}, {prefix + "lv", 1}});
}

INSTANTIATE_TEST_SUITE_P(SharedScripts, NewestRoboTool,
                         ::testing::Combine(::testing::Values(Time::untimed, Time::timed),
                                            ::testing::Values(Variables::parameters, Variables::memories)),
                         [](const auto& instance) {
                             const bool memories = std::get<1>(instance.param) == Variables::memories;
                             return std::string(std::get<0>(instance.param) == Time::timed ? "timed" : "untimed") +
                                    (memories ? "_memories" : "");
                         });

TEST(RangerAssertions, SimplifiedSpecificationsAreEqual) {
    const std::string root = robochart::tests::shared_folder().string() + "/suite/robotool-csp-2026";
    if (!std::filesystem::exists(root)) GTEST_SKIP() << "no shared models at " << root;
    const auto m = testing::project(root);
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const Emission emission = m->emit(Time::timed);
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_EQ(testing::decide_script(emission.script), std::vector<std::string>(8, "holds"));
}

const std::string models[] = {"example1_ddl",
                              "example1_ddlf_no_final",
                              "example1_ddlfree",
                              "example2",
                              "example3",
                              "example4",
                              "example5",
                              "example6",
                              "example7",
                              "example8",
                              "example9",
                              "example_interlock_evt_ddlk",
                              "example_interlock_evt_ddlk_to_fix",
                              "example_interlock_evt_within_stm_ddlk",
                              "example_interlock_var_ddlk",
                              "example_robot",
                              "example_robot2",
                              "example_robot_DDLK"};

// Tests that all models of the folder are compared, except example9_empty_stm, whose file is empty.
TEST(RoboToolScripts, EveryModelWithContentIsCompared) {
    const std::string root = robochart::tests::shared_folder().string() + "/suite/robotool-csp/models";
    if (!std::filesystem::exists(root)) GTEST_SKIP() << "no shared scripts at " << root;
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(root))
        if (entry.file_size() > 0) found.insert(entry.path().stem().string());
    EXPECT_EQ(found, std::set<std::string>(std::begin(models), std::end(models)));
}

INSTANTIATE_TEST_SUITE_P(SharedScripts, RoboTool,
                         ::testing::Combine(::testing::ValuesIn(std::begin(models), std::end(models)),
                                            ::testing::Values(Time::untimed, Time::timed),
                                            ::testing::Values(Variables::parameters, Variables::memories)),
                         [](const auto& instance) {
                             const bool memories = std::get<2>(instance.param) == Variables::memories;
                             return std::get<0>(instance.param) +
                                    (std::get<1>(instance.param) == Time::timed ? "_timed" : "_untimed") +
                                    (memories ? "_memories" : "");
                         });

}  // namespace
}  // namespace robochart::csp_emit::robotool_test
