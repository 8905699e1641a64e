// SPDX-License-Identifier: Apache-2.0
#include "conformance/check/follower.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "conformance/check/standstill.hpp"
#include "conformance/check/violated_precondition.hpp"
#include "conformance/model/rules.hpp"

namespace robochart::conformance {

namespace {

constexpr const char* endless_model = "the model takes infinitely many steps without time passing";

}  // namespace

Follower::Follower(ModelGraph& model, const Alphabet& alphabet, std::uint32_t cycle_length,
                   const refine::Limits& limits, Frame frame)
    : model_(model),
      alphabet_(alphabet),
      cycle_length_(std::max(1U, cycle_length)),
      unread_(frame.unread),
      system_(model, alphabet, cycle_length, frame),
      budget_(limits),
      form_(system_, budget_) {}

std::optional<std::uint32_t> Follower::asked_register(Node node) {
    if (!unread_) return std::nullopt;
    const process::EventSet possible = form_.initials(node);
    for (std::uint32_t input = 0; input < alphabet_.interface().inputs.size(); ++input)
        if (std::ranges::binary_search(possible, system_.ask_event(input))) return input;
    return std::nullopt;
}

std::optional<Mismatch> Follower::finish_cycle(Node& node, rc_result outcome, bool cut) {
    if (auto stops = model_stops(node)) return stops;
    over_ = cut || outcome != RC_QUIESCENT;
    if (cut) return std::nullopt;
    switch (outcome) {
        case RC_PRECONDITION:
            return make_mismatch(node, std::string(outside_precondition));
        case RC_DEADLINE:
            if (may_refuse(node, std::nullopt)) return std::nullopt;
            return make_mismatch(node, "the code misses a deadline");
        case RC_STEP_BOUND:
            if (has_endless_run(node))
                return Mismatch{Outcome::not_schedulable, endless_model, "", &rules::endless_outputs};
            return Mismatch{Outcome::differs, "the code's cycle does not end: its step bound is reached",
                            "an end of the cycle", nullptr};
        case RC_TERMINATED:
            return follow_event(node, process::tick, false);
        case RC_QUIESCENT:
            break;
    }
    for (std::uint32_t t = 0; t < cycle_length_; ++t)
        if (auto mismatch = follow_event(node, alphabet_.tock(), false)) return mismatch;
    return std::nullopt;
}

Mismatch Follower::make_mismatch(Node node, std::string reason) {
    return {Outcome::differs, std::move(reason), describe_allowed(node), nullptr};
}

/// Returns true if some stable state of the node offers nothing, or only `but`. The minimal acceptances of the node
/// decide this.
bool Follower::may_refuse(Node node, std::optional<process::Event> but) {
    const auto& acceptances = form_.acceptances(node);
    const auto fits = [&](const process::EventSet& acceptance) {
        return acceptance.empty() || (but && acceptance.size() == 1 && acceptance.front() == *but);
    };
    return std::ranges::any_of(acceptances, fits);
}

std::optional<Mismatch> Follower::follow_event(Node& node, process::Event event, bool read) {
    if (auto stops = model_stops(node)) return stops;
    const auto next = form_.node_after(node, event);
    const bool insists = !read && !form_.acceptances(node).empty() && !may_refuse(node, event);
    if (!next || insists)
        return Mismatch{Outcome::differs,
                        event == alphabet_.tock() ? "the code ends its cycle where the model goes on"
                                                  : fmt::format("the code does {}, which the model does not allow here",
                                                                alphabet_.describe_event(event)),
                        describe_allowed(node), nullptr};
    node = *next;
    return std::nullopt;
}

bool Follower::is_unknown(Node node) const {
    return unknown_ && std::ranges::any_of(form_.states(node), [this](lts::StateView state) {
               const std::optional<ModelState> at = system_.model_state_of(state);
               return at && unknown_(model_.packed_state(*at));
           });
}

/// Ends the check when there is a sign that the model cannot be run in cycles. What the code does after that is not an
/// error of the code.
std::optional<Mismatch> Follower::model_stops(Node node) {
    if (is_unknown(node)) return Mismatch{Outcome::inconclusive, "the steps of the model are unknown", "", nullptr};
    if (form_.diverges(node)) return Mismatch{Outcome::not_schedulable, endless_model, "", &rules::endless_steps};
    const auto& acceptances = form_.acceptances(node);
    const bool stuck = std::ranges::any_of(acceptances, [](const auto& a) { return a.empty(); });
    if (!stuck) return std::nullopt;
    for (const lts::StateView state : form_.states(node))
        if (const diagnostics::Rule* const rule = rule_of(system_.standstill_kind(state)))
            return Mismatch{Outcome::not_schedulable, "the model can neither go on nor let time pass", "", rule};
    return std::nullopt;
}

/// Returns true if an infinite sequence of outputs is possible before time passes.
bool Follower::has_endless_run(Node from) {
    std::unordered_map<Node, bool> open;  // whether the node is on the path; never iterated
    struct Place {
        Node node;
        process::EventSet events;
        std::size_t next = 0;
    };
    std::vector<Place> path{{from, form_.initials(from)}};
    open[from] = true;
    while (!path.empty()) {
        Place& at = path.back();
        if (at.next == at.events.size()) {
            open[at.node] = false;
            path.pop_back();
            continue;
        }
        const process::Event event = at.events[at.next++];
        if (alphabet_.cycle_role(event).kind != CycleRole::Kind::write) continue;
        const auto next = form_.node_after(at.node, event);
        if (!next) continue;
        const auto [place, fresh] = open.emplace(*next, true);
        if (!fresh && place->second) return true;
        if (fresh) path.push_back({*next, form_.initials(*next)});
    }
    return false;
}

std::string Follower::describe_allowed(Node node) {
    std::string text;
    std::size_t count = 0;
    for (const process::Event event : form_.initials(node))
        if (count++ < 6) text += (text.empty() ? "" : " or ") + alphabet_.describe_event(event);
    if (count > 6) text += fmt::format(" or {} others", count - 6);
    return text.empty() ? "nothing" : text;
}

}  // namespace robochart::conformance
