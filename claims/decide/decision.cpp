// SPDX-License-Identifier: Apache-2.0
// See decision.hpp.
#include "claims/decide/decision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
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

Tree state_name(std::size_t number, const std::string& variant, std::size_t state) {
    return build::name(fmt::format("claims__{}{}_{}", number, variant, state));
}

/// Returns the events of a state of the automaton that lead to states of the variant.
template <class InVariant>
Exprs moves_of(const AutomatonState& state, const std::vector<Letter>& letters, std::size_t number,
               const std::string& variant, const InVariant& in_variant) {
    Exprs result;
    std::map<std::size_t, Exprs> events;  // key: the successor
    for (std::size_t i = 0; i < letters.size(); ++i)
        if (state.by_letter[i] && in_variant(*state.by_letter[i]))
            std::ranges::copy(letters[i].prefixes, std::back_inserter(events[*state.by_letter[i]]));
    for (auto& [next, prefixes] : events)
        result.push_back(build::replicated(cspm::ExprKind::replicated_external,
                                           {build::generator("e__", build::productions(std::move(prefixes)))},
                                           build::prefix(build::name("e__"), state_name(number, variant, next))));
    if (state.by_tock && in_variant(*state.by_tock))
        result.push_back(build::prefix(tock(), state_name(number, variant, *state.by_tock)));
    return result;
}

/// Returns the set of all events of the letters, and tock.
Tree seen_by(const std::vector<Letter>& letters) {
    Exprs items;
    for (const Letter& letter : letters) std::ranges::copy(letter.prefixes, std::back_inserter(items));
    items.push_back(tock());
    return build::productions(std::move(items));
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
        return state_name(number_, variant, state);
    }

    struct Variant {
        std::string name;
        bool free_time = false;  ///< states without a pending demand have `claims__free`
    };
    /// Adds one definition for each state. Leaves out transitions to states that are not in the variant.
    template <class InVariant>
    void add_processes(std::vector<DeclPtr>& declarations, const Variant& variant, const InVariant& in_variant) const {
        for (std::size_t at = 0; at < automaton_.size(); ++at) {
            if (!in_variant(at)) continue;
            const AutomatonState& state = automaton_[at];
            Exprs branches = moves_of(state, letters_, number_, variant.name, in_variant);
            if (state.may_end) branches.push_back(build::skip());
            if (variant.free_time && !state.owes)
                branches.push_back(build::prefix(build::name(free_time), process_name(variant.name, at)));
            declarations.push_back(
                build::value(process_name(variant.name, at)->text, build::choice(std::move(branches))));
        }
    }

    /// Adds the processes for `leads to` without a limit. The process "w" follows the monitor until, in a state in
    /// which a response is pending, it selects this response. From then on, the process "c" makes the passing time
    /// units visible, and refuses the response and the end of its scope. A response stays pending forever iff some run
    /// contains infinitely many of these visible time units.
    void add_followed_debt(std::vector<DeclPtr>& declarations) const {
        for (std::size_t at = 0; at < automaton_.size(); ++at) {
            const AutomatonState& state = automaton_[at];
            Exprs free, committed;
            for (std::size_t i = 0; i < letters_.size(); ++i) {
                if (!state.by_letter[i]) continue;
                const std::size_t next = *state.by_letter[i];
                const Tree events = build::productions(letters_[i].prefixes);
                const auto branch = [&](const char* variant) {
                    return build::replicated(cspm::ExprKind::replicated_external, {build::generator("e__", events)},
                                             build::prefix(build::name("e__"), process_name(variant, next)));
                };
                free.push_back(branch("w"));
                if (automaton_[next].owes && !state.serves[i]) committed.push_back(branch("c"));
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

    [[nodiscard]] Tree seen() const { return seen_by(letters_); }
    [[nodiscard]] Tree visible() const { return build::project(process_, seen()); }

    /// Returns the assertion that some run contains an event that the claim restricts. Ignores conditions on last
    /// values.
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
            if (letter.facts.empty() && channels.contains(letter.occurrence.channel))
                events.push_back(letter.prefixes[0]);
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

namespace {

/// Returns the letters of the responses that the assumption demands, each with its second name.
std::map<std::size_t, Assumed::Due> due_letters(const CheckedClaim& claim, const std::vector<Letter>& letters,
                                                const Automaton& automaton, std::size_t number) {
    std::map<std::size_t, Assumed::Due> result;
    for (const AutomatonState& state : automaton) {
        if (state.by_tock) continue;
        for (std::size_t i = 0; i < letters.size(); ++i) {
            const bool answers = claim.body.kind == BodyKind::every
                                     ? Monitor::matches(claim.body.events, letters[i].occurrence, {})
                                     : static_cast<bool>(state.serves[i]);
            if (!answers || !state.by_letter[i] || result.contains(i)) continue;
            if (!claim.component.channels[letters[i].occurrence.channel].types.empty())
                throw NotDecided(fmt::format("the assumption {} demands an event with values", claim.name));
            result[i] = {letters[i].events[0], letters[i].prefixes[0], fmt::format("claims__due_{}_{}", number, i)};
        }
    }
    return result;
}

}  // namespace

Assumed assume_by_processes(const CheckedClaim& claim, const std::vector<Letter>& letters, const Automaton& automaton,
                            std::size_t number, Tree component) {
    Assumed result;
    const std::string variant = "a";
    const auto all = [](std::size_t) { return true; };
    const std::map<std::size_t, Assumed::Due> due = due_letters(claim, letters, automaton, number);
    for (std::size_t at = 0; at < automaton.size(); ++at) {
        std::vector<Letter> own = letters;
        for (const auto& [letter, other] : due)
            if (!automaton[at].by_tock) own[letter].prefixes[0] = build::name(other.due);
        Exprs branches = moves_of(automaton[at], own, number, variant, all);
        branches.push_back(build::skip());
        result.declarations.push_back(
            build::value(state_name(number, variant, at)->text, build::choice(std::move(branches))));
    }
    Tree seen = seen_by(letters);
    std::vector<cspm::Link> links;
    std::vector<std::string> names;
    Exprs others;
    for (const auto& [letter, other] : due) {
        links.push_back({other.prefix, other.prefix});
        links.push_back({other.prefix, build::name(other.due)});
        names.push_back(other.due);
        others.push_back(build::name(other.due));
        result.due.push_back(other);
    }
    if (!names.empty()) {
        result.declarations.insert(result.declarations.begin(), build::channel(names));
        component = build::rename(component, links);
        seen = build::call("union", {seen, build::set(others)});
    }
    result.process = build::parallel(std::move(component), seen, state_name(number, variant, 0));
    return result;
}

DeclPtr shared_channels() {
    return build::channel({free_time, Decision::waiting_event});
}

}  // namespace robochart::claims
