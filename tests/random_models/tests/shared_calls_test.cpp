// SPDX-License-Identifier: Apache-2.0
// Tests machines of random models with shared definitions of operations. They are compared with the same machines with
// every call inlined: both refine each other in the failures-divergences model (semantics 3.8).
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/tests/seeds.hpp"

namespace robochart::random_models {
namespace {

namespace b = cspm::build;
using cspm::Decl;
using cspm::DeclKind;

/// A machine of the script that runs in a controller.
struct Machine {
    std::string path;
    std::vector<std::string> parameters;  ///< parameters of its processes
    std::vector<std::string> channels;    ///< visible channels, and those of the enclosing modules
};

bool inner(const std::string& channel) {
    const auto starts = [&](const char* prefix) { return channel.rfind(prefix, 0) == 0; };
    return channel == "internal__" || channel == "step__" || channel == "end__" || channel == "clockReset" ||
           starts("get_") || starts("setL_");
}

/// Collects the machines. `outer` contains the qualified channels of the enclosing modules.
void collect(const std::vector<cspm::DeclPtr>& decls, const std::string& path, std::vector<std::string> outer,
             std::vector<Machine>& machines) {
    const std::string prefix = path.empty() ? "" : path + "::";
    for (const cspm::DeclPtr& decl : decls)
        if (decl->kind == DeclKind::channel && !path.empty())
            for (const std::string& name : decl->names)
                if (!inner(name)) outer.push_back(prefix + name);
    for (const cspm::DeclPtr& decl : decls) {
        if (decl->kind == DeclKind::module) collect(decl->exports, prefix + decl->names.at(0), outer, machines);
        if (decl->kind != DeclKind::function || decl->names.at(0) != "D__") continue;
        Machine& machine = machines.emplace_back(Machine{path, {}, outer});
        for (const auto& pattern : decl->patterns.at(0)) machine.parameters.push_back(pattern->text);
    }
}

std::set<std::string> values_at_top(const cspm::Script& script) {
    std::set<std::string> result;
    for (const cspm::DeclPtr& decl : script.decls)
        if (decl->kind == DeclKind::value) result.insert(decl->patterns.front().front()->text);
    return result;
}

/// Returns refinements in both directions between `D__` of the machine and its copy in the module `inline__`.
std::vector<cspm::DeclPtr> claims(const Machine& machine) {
    b::Exprs arguments{b::number(0)};
    for (std::size_t i = 1; i < machine.parameters.size(); ++i) arguments.push_back(b::name(machine.parameters[i]));
    std::vector<cspm::Link> links;
    for (const std::string& channel : machine.channels)
        links.push_back({b::name("inline__::" + channel), b::name(channel)});
    const auto shared = b::call(machine.path + "::D__", arguments);
    const auto twin = b::rename(b::call("inline__::" + machine.path + "::D__", arguments), links);
    return {b::assert_refines(shared, cspm::Model::failures_divergences, twin),
            b::assert_refines(twin, cspm::Model::failures_divergences, shared)};
}

struct CallTally {
    std::size_t held = 0, undecided = 0, sharing = 0;
};

std::string counterexample(const refine::Verdict& verdict, cspm::Session& session) {
    std::string result = verdict.reason;
    if (!verdict.counterexample) return result;
    for (const refine::Step& step : verdict.counterexample->steps) {
        const bool tau = step.event == process::tau;
        result += (tau ? " tau:" : " ") + session.event_table().name(tau ? step.revealed : step.event) + " -> " +
                  step.state + "\n";
    }
    return result;
}

void compare(std::uint64_t seed, const Shape& shape, csp_emit::Time time, CallTally& tally) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto loaded = load(well_formed(seed, shape));
    diagnostics::Diagnostics findings;
    const ir::System system = ir::lower(loaded->model, loaded->sources, findings);
    const ir::Instantiation instantiation = ir::instantiate_system(system, {}, findings);
    csp_emit::Options together;
    together.share_modules = false;
    csp_emit::Options apart = together;
    apart.share_calls = false;
    const auto inlined = csp_emit::emit(system, instantiation, time, apart, loaded->sources, findings);
    cspm::Script script = csp_emit::emit(system, instantiation, time, together, loaded->sources, findings).definitions;
    if (!findings.ok() || equal(script, inlined.definitions)) return;
    std::vector<cspm::DeclPtr> modules;
    for (const cspm::DeclPtr& decl : inlined.definitions.decls)
        if (decl->kind == DeclKind::module) modules.push_back(decl);
    std::vector<Machine> machines;
    collect(script.decls, "", {}, machines);
    const std::set<std::string> known = values_at_top(script);
    script.decls.push_back(b::module_("inline__", {}, {}, modules));
    for (const Machine& machine : machines) {
        const bool closed = std::all_of(machine.parameters.begin() + 1, machine.parameters.end(),
                                        [&](const std::string& name) { return known.contains(name); });
        if (!closed || machine.path.find("OP_") != std::string::npos) continue;
        for (const cspm::DeclPtr& claim : claims(machine)) script.decls.push_back(claim);
    }
    ++tally.sharing;
    cspm::Session session(script);
    refine::Limits limits;
    limits.max_states = 50'000;
    for (const auto& assertion : session.assertions()) {
        const auto result = session.check(*assertion, limits);
        EXPECT_NE(result.verdict.outcome, refine::Outcome::fails) << counterexample(result.verdict, session);
        ++(result.verdict.outcome == refine::Outcome::holds ? tally.held : tally.undecided);
    }
}

Shape with_calls(Shape shape) {
    shape.controllers = {1, 1};
    shape.machines = {1, 1};
    shape.variables = {1, 2};
    shape.states = {1, 2};
    shape.defined_operations = {2, 3};
    shape.statements = {2, 4};
    shape.platform_operations = {0, 1};
    shape.operation_events = true;
    return shape;
}

TEST(SharedCalls, MeanWhatCallsInTheirPlacesMean) {
    CallTally tally;
    for (const std::uint64_t seed : seeds(16))
        compare(seed, with_calls(Shape::untimed_core()), csp_emit::Time::untimed, tally);
    for (const std::uint64_t seed : seeds(8))
        compare(seed, with_calls(Shape::timed_core()), csp_emit::Time::timed, tally);
    std::printf("%zu models with shared calls, %zu refinements hold, %zu undecided\n", tally.sharing, tally.held,
                tally.undecided);
    EXPECT_GE(tally.sharing, 1U);
    EXPECT_GE(tally.held, tally.sharing);
    EXPECT_GE(tally.held, tally.undecided);
}

}  // namespace
}  // namespace robochart::random_models
