// SPDX-License-Identifier: Apache-2.0
// Compares the processes of claims with processes of the same meaning that were written by hand in CSP.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "claims/decide/automaton.hpp"
#include "claims/decide/decision.hpp"
#include "tests/claims/decide/library.hpp"

namespace robochart::claims {
namespace {

namespace build = cspm::build;
using testing::draw_claim;
using testing::Draws;
using testing::library;

TEST(ClaimProcesses, HaveTheTracesOfTheLibrary) {
    const std::vector<std::string> names{"a", "b", "c"};
    std::vector<Letter> letters;
    std::vector<testing::NamedChannel> channels;
    for (std::size_t i = 0; i < names.size(); ++i) channels.push_back({i, names[i]});
    for (std::size_t i = 0; i < names.size(); ++i)
        letters.push_back({{i, {}}, {}, {names[i]}, {build::name(names[i])}, names[i]});
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    cspm::Script script =
        cspm::read(sources, sources.add("library.csp", std::string("channel a, b, c, tock\n") + library), diagnostics);
    ASSERT_TRUE(diagnostics.ok());
    script.decls.push_back(shared_channels());
    Draws draws(7, channels);
    std::vector<std::pair<cspm::DeclPtr, std::string>> assertions;
    for (std::size_t number = 0; number < 400; ++number) {
        CheckedClaim claim;
        for (const std::string& name : names) claim.component.channels.push_back({name, ChannelKind::input, {}});
        const std::string text = draw_claim(draws, claim);
        const Automaton automaton = make_automaton(claim, letters, nullptr);
        const Decision decision = decide_by_processes(claim, letters, automaton, number, build::stop(), {});
        script.decls.insert(script.decls.end(), decision.declarations.begin(), decision.declarations.end());
        const std::string name = "L" + std::to_string(number);
        const cspm::Script one = cspm::read(sources, sources.add(name, name + " = " + text + "\n"), diagnostics);
        script.decls.push_back(one.decls.front());
        const cspm::ExprPtr monitor = decision.holds->assertion.specification;
        for (const cspm::DeclPtr& assertion :
             {build::assert_refines(monitor, cspm::Model::traces, build::name(name)),
              build::assert_refines(build::name(name), cspm::Model::traces, monitor)}) {
            script.decls.push_back(assertion);
            assertions.emplace_back(assertion, text);
        }
    }
    ASSERT_TRUE(diagnostics.ok());
    cspm::Session session(script);
    for (const auto& [assertion, text] : assertions)
        EXPECT_EQ(session.check(*assertion, {}).verdict.outcome, refine::Outcome::holds) << text;
}

}  // namespace
}  // namespace robochart::claims
