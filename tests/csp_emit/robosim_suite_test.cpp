// SPDX-License-Identifier: Apache-2.0
// Decides the published claims about RoboSim in ../shared/suite/robosim: every row of EXPECTED.tsv that holds as
// worded.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/lookup.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "frontend/project/project.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/csp_emit/fixture.hpp"
#include "tests/csp_emit/robotool_scripts.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::csp_emit::robosim_suite_test {
namespace {

namespace fs = std::filesystem;
namespace b = cspm::build;

struct Row {
    std::string file, claim, expected, seconds;
};

std::vector<Row> rows_of(const fs::path& table) {
    std::ifstream in(table);
    std::vector<Row> result;
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        Row row;
        std::string source;
        std::getline(fields, row.file, '\t');
        std::getline(fields, row.claim, '\t');
        std::getline(fields, row.expected, '\t');
        std::getline(fields, source, '\t');
        std::getline(fields, row.seconds, '\t');
        result.push_back(row);
    }
    return result;
}

/// Decides the claim as it is worded: a negated claim holds if the denied claim fails.
std::string decide(const Emission& emission, const ir::System& system, const std::string& file,
                   const std::string& claim) {
    cspm::Session session(emission.script);
    for (const Obligation& obligation : emission.obligations) {
        if (obligation.property == ir::no_id) continue;
        const ir::Property& property = system.properties[obligation.property];
        if (property.name != claim || !fs::path(property.file).lexically_normal().string().ends_with(file)) continue;
        if (obligation.assertions.empty()) return "no check: " + obligation.reason;
        std::string answer = "holds";
        for (const auto& assertion : obligation.assertions) {
            const auto verdict = session.check(*assertion, {}).verdict;
            answer = verdict.outcome == refine::Outcome::holds ? "holds" : "fails " + verdict.reason;
            if ((answer == "holds") == obligation.one_suffices) break;
        }
        return answer;
    }
    return "there is no such claim";
}

/// Decides the published claims that take a second or less.
TEST(RoboSimSuite, EveryQuickClaimHoldsAsWorded) {
    const fs::path folder = tests::shared_folder() / "suite/robosim";
    if (tests::shared_folder().empty() || !fs::exists(folder / "EXPECTED.tsv"))
        GTEST_SKIP() << "../shared/suite/robosim is not there";
    std::map<std::string, std::unique_ptr<testing::Model>> models;
    std::size_t decided = 0;
    for (const Row& row : rows_of(folder / "EXPECTED.tsv")) {
        if (row.expected != "holds as worded" || row.seconds == "> 60" || !row.file.ends_with(".rsa")) continue;
        // the file has errors in other machines (RC-Y05, RC-T08)
        if (row.file.find("AutonomousSegregation") != std::string::npos) continue;
        auto& model = models[row.file];
        if (!model) {
            model = testing::project((folder / row.file).string());
            // the expected verdicts assume constants of 1, because with the default 0, PI / av has no value
            if (row.file.ends_with("rc2rs.rsa"))
                model->instantiation = ir::instantiate_system(
                    model->system, {{{"PI", "1"}, {"av", "1"}, {"lv", "1"}}, {}}, model->diagnostics);
        }
        EXPECT_TRUE(model->diagnostics.ok()) << row.file << "\n" << model->messages();
        if (!model->diagnostics.ok()) continue;
        const Emission emission = model->emit(Time::timed);
        EXPECT_TRUE(model->diagnostics.ok()) << row.file << "\n" << model->messages();
        EXPECT_EQ(decide(emission, model->system, row.file, row.claim), "holds") << row.file << " " << row.claim;
        ++decided;
    }
    EXPECT_GE(decided, 59U);
}

/// Returns the constructors in a set such as RegisterInputs of this program's component.
std::vector<std::string> constructors_of(const Emission& ours, const std::string& name) {
    std::vector<std::string> result;
    if (const cspm::DeclPtr decl = cspm::declaration_of(ours.definitions, name); decl && decl->body)
        for (const cspm::ExprPtr& constructor : decl->body->args) result.push_back(constructor->text);
    return result;
}

/// Returns this program's process with RoboTool's names.
cspm::ExprPtr with_their_names(const Emission& ours, const std::string& path, const cspm::ExprPtr& process) {
    std::vector<cspm::Link> links;
    const auto event = [&](const std::string& prefix, const char* channel, const std::string& constructor) {
        return b::dot({b::name(prefix + path + "::" + channel), b::name(prefix + path + "::" + constructor)});
    };
    const auto add = [&](const char* channel, const std::vector<std::string>& constructors) {
        for (const std::string& one : constructors)
            links.push_back({event("ours__::", channel, one), event("", channel, one)});
    };
    add("registerRead", constructors_of(ours, path + "::RegisterInputs"));
    add("registerWrite", constructors_of(ours, path + "::RegisterOutputs"));
    if (path.find("::") != std::string::npos)  // a module and a simulation hide these events
        for (const char* channel : {"endexec", "terminate"})
            links.push_back({b::name("ours__::" + path + "::" + channel), b::name(path + "::" + channel)});
    return b::rename(process, links);
}

/// Compares with RoboTool's scripts of the ranger: its machine, its controller, its module, and the simulation of its
/// RoboChart model.
TEST(RoboSimSuite, ProcessesAreThoseOfRoboToolsScripts) {
    const fs::path folder = tests::shared_folder() / "suite/robosim/robotool-csp/SRangerRC2RS";
    if (tests::shared_folder().empty() || !fs::exists(folder)) GTEST_SKIP() << "../shared/suite/robosim is not there";
    const auto model = testing::project((folder / "checks.rsa").string());
    Options whole;
    whole.share_modules = false;  // because modules of this script become part of another script
    const Emission ours =
        emit(model->system, model->instantiation, Time::timed, whole, model->sources, model->diagnostics);
    const auto theirs = cspm::read_file(
        model->sources, (folder / "csp-gen/sim/checks_assertions_assertions.csp").string(), model->diagnostics);
    ASSERT_TRUE(model->diagnostics.ok()) << model->messages();
    for (const std::string path : {"SimCMovement", "SimCMovement::cm", "SimCMovement::cm::sm", "Sim"})
        for (const std::int64_t cycle : {1, 2}) {
            const auto process = [&](const std::string& prefix) {
                return b::call(prefix + path + "::D__",
                               {b::number(0), b::number(cycle), b::number(2), b::number(2), b::number(2)});
            };
            const auto hidden = [&](const cspm::ExprPtr& timed) {
                return b::call("prioritise", {timed, b::sequence({b::set({}), b::set({b::name("tock")})})});
            };
            const cspm::ExprPtr own = hidden(with_their_names(ours, path, process("ours__::")));
            const cspm::ExprPtr other = hidden(process(""));
            cspm::Script script = testing::join_scripts(theirs, ours);
            script.decls.push_back(b::assert_refines(own, cspm::Model::failures_divergences, other));
            script.decls.push_back(b::assert_refines(other, cspm::Model::failures_divergences, own));
            EXPECT_EQ(testing::decide_script(script), std::vector<std::string>(2, "holds")) << path << " " << cycle;
        }
}

}  // namespace
}  // namespace robochart::csp_emit::robosim_suite_test
