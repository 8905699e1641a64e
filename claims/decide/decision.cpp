// SPDX-License-Identifier: Apache-2.0
// See decision.hpp.
#include "claims/decide/decision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/assertion_forms.hpp"

namespace robochart::claims {
namespace {

namespace build = cspm::build;
using build::Exprs;
using cspm::DeclPtr;
using Tree = cspm::ExprPtr;

constexpr const char* free_time = "claims__free";

Tree tock() {
    return build::name("tock");
}

class ProcessMaker {
public:
    ProcessMaker(const CheckedClaim& claim, const std::vector<Letter>& letters, const Automaton& automaton,
                 std::size_t number, Tree process)
        : claim_(claim), letters_(letters), automaton_(automaton), number_(number), process_(std::move(process)) {}

    Decision make(const std::vector<Tree>& outputs) {
        Decision result;
        const bool possible = claim_.body.kind == BodyKind::possible;
        const auto all = [](std::size_t) { return true; };
        add_processes(result.declarations, Variant{"", false}, all);
        result.holds = build::assert_refines(process_name("", 0), cspm::Model::traces, visible(), possible);
        if (possible) return result;
        if (!automaton_[0].asks()) {
            add_processes(result.declarations, Variant{"v", false},
                          [&](std::size_t state) { return !automaton_[state].asks(); });
            result.asked = build::assert_refines(process_name("v", 0), cspm::Model::traces, visible(), true);
        }
        result.happens = happens();
        const bool owes = std::ranges::any_of(automaton_, [](const AutomatonState& state) { return state.owes; });
        if (!owes) return result;
        add_processes(result.declarations, Variant{"t", true}, all);
        result.standstill = standstill(outputs);
        if (claim_.body.kind != BodyKind::leads) return result;
        add_followed_debt(result.declarations);
        result.waiting = waiting();
        return result;
    }

private:
    [[nodiscard]] Tree process_name(const std::string& variant, std::size_t state) const {
        return build::name(fmt::format("claims__{}{}_{}", number_, variant, state));
    }

    struct Variant {
        std::string name;
        bool free_time = false;  ///< states that owe nothing have `claims__free`
    };
    /// One definition for each state. Transitions to states that are not in the variant are left out.
    template <class InVariant>
    void add_processes(std::vector<DeclPtr>& declarations, const Variant& variant, const InVariant& in_variant) const {
        for (std::size_t at = 0; at < automaton_.size(); ++at) {
            if (!in_variant(at)) continue;
            const AutomatonState& state = automaton_[at];
            Exprs branches;
            std::map<std::size_t, Exprs> events;  // by successor
            for (std::size_t i = 0; i < letters_.size(); ++i)
                if (state.by_letter[i] && in_variant(*state.by_letter[i]))
                    events[*state.by_letter[i]].push_back(letters_[i].prefix);
            for (auto& [next, prefixes] : events)
                branches.push_back(
                    build::replicated(cspm::ExprKind::replicated_external,
                                      {build::generator("e__", build::productions(std::move(prefixes)))},
                                      build::prefix(build::name("e__"), process_name(variant.name, next))));
            if (state.by_tock && in_variant(*state.by_tock))
                branches.push_back(build::prefix(tock(), process_name(variant.name, *state.by_tock)));
            if (state.may_end) branches.push_back(build::skip());
            if (variant.free_time && !state.owes)
                branches.push_back(build::prefix(build::name(free_time), process_name(variant.name, at)));
            declarations.push_back(
                build::value(process_name(variant.name, at)->text, build::choice(std::move(branches))));
        }
    }

    /// For `leads to` without a limit. The process "w" follows the monitor until it selects, in a state that owes
    /// something, the debt that stays open. The process "c" then shows the time units that pass, and refuses what
    /// serves the debt and what ends its scope. A debt stays open for ever iff some run has infinitely many of them.
    void add_followed_debt(std::vector<DeclPtr>& declarations) const {
        if (!claim_.remembered.empty()) throw NotDecided("a response without a limit reads the last value of an event");
        for (std::size_t at = 0; at < automaton_.size(); ++at) {
            const AutomatonState& state = automaton_[at];
            Exprs free, committed;
            for (std::size_t i = 0; i < letters_.size(); ++i) {
                if (!state.by_letter[i]) continue;
                const std::size_t next = *state.by_letter[i];
                const Tree events = build::productions({letters_[i].prefix});
                const auto branch = [&](const char* variant) {
                    return build::replicated(cspm::ExprKind::replicated_external, {build::generator("e__", events)},
                                             build::prefix(build::name("e__"), process_name(variant, next)));
                };
                free.push_back(branch("w"));
                if (automaton_[next].owes && !serves(letters_[i])) committed.push_back(branch("c"));
            }
            if (state.by_tock) free.push_back(build::prefix(tock(), process_name("w", *state.by_tock)));
            if (state.may_end) free.push_back(build::skip());
            Tree process = build::choice(std::move(free));
            if (state.owes) process = build::internal_choice({process, process_name("c", at)});
            declarations.push_back(build::value(process_name("w", at)->text, process));
            if (!state.owes) continue;
            if (state.by_tock && automaton_[*state.by_tock].owes)
                committed.push_back(
                    build::prefix(build::name(Decision::waiting_event), process_name("c", *state.by_tock)));
            declarations.push_back(build::value(process_name("c", at)->text, build::choice(std::move(committed))));
        }
    }
    [[nodiscard]] bool serves(const Letter& letter) const {
        return Monitor::matches(claim_.body.others, letter.occurrence, {}) ||
               Monitor::matches(claim_.body.exceptions, letter.occurrence, {});
    }

    /// All events of the claim's channels, and tock.
    [[nodiscard]] Tree seen() const {
        Exprs items;
        for (const Letter& letter : letters_) items.push_back(letter.prefix);
        items.push_back(tock());
        return build::productions(std::move(items));
    }
    [[nodiscard]] Tree visible() const { return build::project(process_, seen()); }

    /// Whether an event that the claim restricts occurs at all. Conditions on last values are not judged.
    [[nodiscard]] DeclPtr happens() const {
        const BodyKind kind = claim_.body.kind;
        const bool restricts = kind == BodyKind::never || kind == BodyKind::only_after ||
                               kind == BodyKind::only_within || kind == BodyKind::at_least || kind == BodyKind::at_most;
        if (!restricts || claim_.body.events.terminate) return nullptr;
        std::set<std::size_t> channels;
        for (const EventMatch& match : claim_.body.events.any)
            channels.insert(match.channels.begin(), match.channels.end());
        Exprs events;
        for (const Letter& letter : letters_)
            if (channels.contains(letter.occurrence.channel)) events.push_back(letter.prefix);
        if (events.empty()) return nullptr;
        return csp_emit::never_performs(build::project(process_, build::productions(std::move(events))), true);
    }

    [[nodiscard]] DeclPtr standstill(const std::vector<Tree>& outputs) const {
        const Tree both = build::parallel(process_, seen(), process_name("t", 0));
        const Tree renamed = build::rename(both, {{build::name(free_time), tock()}});
        Tree running = csp_emit::running_on(renamed, "tock");
        if (!outputs.empty()) running = build::hide(running, build::productions(outputs));
        return csp_emit::timelock_free(running);
    }

    [[nodiscard]] Tree waiting() const {
        const Tree wait = build::name(Decision::waiting_event);
        const Tree renamed = build::rename(process_, {{tock(), tock()}, {tock(), wait}});
        const Tree both =
            build::parallel(renamed, build::call("union", {seen(), build::set({wait})}), process_name("w", 0));
        return build::hide(both, build::call("diff", {build::name("Events"), build::set({wait})}));
    }

    const CheckedClaim& claim_;
    const std::vector<Letter>& letters_;
    const Automaton& automaton_;
    std::size_t number_;
    Tree process_;
};

}  // namespace

Decision decide_by_processes(const CheckedClaim& claim, const std::vector<Letter>& letters, const Automaton& automaton,
                             std::size_t number, const cspm::ExprPtr& process,
                             const std::vector<cspm::ExprPtr>& outputs) {
    return ProcessMaker(claim, letters, automaton, number, process).make(outputs);
}

DeclPtr shared_channels() {
    return build::channel({free_time, Decision::waiting_event});
}

}  // namespace robochart::claims
