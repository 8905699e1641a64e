// SPDX-License-Identifier: Apache-2.0
// Tests claims about random timed models. The verdict must be that of the process that was written by hand in CSP for
// the claim. ROBOCHART_SEEDS=N checks N models (tests/long.sh claims).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "claims/decide/automaton.hpp"
#include "claims/decide/decision.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/claims/decide/library.hpp"
#include "tests/random_models/models/well_formed.hpp"

namespace robochart::claims {
namespace {

namespace build = cspm::build;
using testing::draw_claim;
using testing::Draws;

struct Counts {
    std::size_t models = 0, hold = 0, fail = 0, undecided = 0;
};

class RandomModel {
public:
    explicit RandomModel(std::uint64_t seed)
        : loaded_(random_models::load(random_models::well_formed(seed, random_models::Shape::timed_core()))),
          system_(ir::lower(loaded_->model, loaded_->sources, findings_)),
          instantiation_(ir::instantiate_system(system_, {}, findings_)),
          emission_(csp_emit::emit(system_, instantiation_, csp_emit::Time::timed, {}, loaded_->sources, findings_)) {}

    /// Compares this many claims about the largest component.
    void compare(std::uint32_t seed, int claims, Counts& counts) {
        if (!findings_.ok()) return;
        const std::vector<Component> components = components_of(system_);
        const auto component =
            std::ranges::find_if(components, [](const Component& one) { return !one.channels.empty(); });
        if (component == components.end()) return;
        const auto process =
            std::ranges::find(emission_.components, component->path, &csp_emit::ComponentProcesses::path);
        if (process == emission_.components.end()) return;
        const std::vector<testing::NamedChannel> channels = channels_of(*component);
        Draws draws(seed, channels);
        cspm::Script script = emission_.definitions;
        add(script, testing::library);
        script.decls.push_back(shared_channels());
        std::vector<std::pair<cspm::DeclPtr, cspm::DeclPtr>> both;
        std::vector<std::string> texts;
        for (int number = 0; number < claims; ++number) {
            CheckedClaim claim;
            claim.component = *component;
            const std::string text = draw_claim(draws, claim);
            const std::vector<Letter> letters = letters_of(claim, system_, instantiation_, {});
            const Decision decision = decide_by_processes(claim, letters, make_automaton(claim, letters, nullptr),
                                                          static_cast<std::size_t>(number), process->process, {});
            script.decls.insert(script.decls.end(), decision.declarations.begin(), decision.declarations.end());
            const std::string name = "handwritten__" + std::to_string(number);
            add(script, name + " = " + text + "\nseen" + name + " = " + draws.all() + "\n");
            const cspm::DeclPtr other = build::assert_refines(
                build::name(name), cspm::Model::traces, build::project(process->process, build::name("seen" + name)));
            both.emplace_back(decision.holds, other);
            texts.push_back(text);
            script.decls.push_back(decision.holds);
            script.decls.push_back(other);
        }
        ++counts.models;
        cspm::Session session(script);
        for (std::size_t i = 0; i < both.size(); ++i) judge(session, both[i].first, both[i].second, texts[i], counts);
    }

private:
    /// Returns at most three channels whose events have few values.
    [[nodiscard]] std::vector<testing::NamedChannel> channels_of(const Component& component) const {
        constexpr std::size_t most = 3;
        std::vector<testing::NamedChannel> result;
        for (std::size_t i = 0; i < component.channels.size() && result.size() < most; ++i) {
            const Channel& channel = component.channels[i];
            std::string text = component.path + "::" + channel.name;
            if (channel.kind == ChannelKind::call) text += "Call";
            if (channel.kind == ChannelKind::input) text += ".in";
            if (channel.kind == ChannelKind::output) text += ".out";
            result.push_back({i, text});
        }
        return result;
    }
    void add(cspm::Script& script, const std::string& text) {
        diagnostics::Diagnostics found;
        const cspm::Script read = cspm::read(sources_, sources_.add("text.csp", text), found);
        ASSERT_TRUE(found.ok()) << text;
        script.decls.insert(script.decls.end(), read.decls.begin(), read.decls.end());
    }
    static void judge(cspm::Session& session, const cspm::DeclPtr& ours, const cspm::DeclPtr& other,
                      const std::string& text, Counts& counts) {
        refine::Limits limits;
        limits.max_states = 20'000;
        const refine::Outcome one = session.check(*ours, limits).verdict.outcome;
        const refine::Outcome two = session.check(*other, limits).verdict.outcome;
        if (one == refine::Outcome::inconclusive || two == refine::Outcome::inconclusive) {
            ++counts.undecided;
            return;
        }
        EXPECT_EQ(one, two) << text;
        ++(one == refine::Outcome::holds ? counts.hold : counts.fail);
    }

    diagnostics::Diagnostics findings_;
    std::unique_ptr<random_models::Loaded> loaded_;
    ir::System system_;
    ir::Instantiation instantiation_;
    csp_emit::Emission emission_;
    diagnostics::SourceManager sources_;
};

TEST(ClaimProcesses, DecideRandomModelsAsTheLibrary) {
    const char* const setting = std::getenv("ROBOCHART_SEEDS");
    const std::uint64_t models = setting != nullptr ? std::stoull(setting) : 25;
    constexpr int claims = 5;
    Counts counts;
    for (std::uint64_t seed = 0; seed < models; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        RandomModel(seed).compare(static_cast<std::uint32_t>(seed), claims, counts);
    }
    std::printf("%zu models, %zu claims hold, %zu fail, %zu undecided\n", counts.models, counts.hold, counts.fail,
                counts.undecided);
    EXPECT_GE(counts.models, models / 2);
    EXPECT_GE(counts.hold, models / 2);
    EXPECT_GE(counts.fail, models / 2);
    EXPECT_LE(counts.undecided, counts.models);
}

}  // namespace
}  // namespace robochart::claims
