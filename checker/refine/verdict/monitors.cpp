// SPDX-License-Identifier: Apache-2.0
// Defines refinement in each model by the faults of single runs: UCS 10 (T), 11 (F), 12 (FD).
#include "checker/refine/verdict/monitors.hpp"

#include <algorithm>

namespace robochart::refine {

using process::Event;
using process::EventSet;

/// In T, every trace must be a trace of the specification. In FD, if the specification diverges, any later behaviour is
/// allowed.
Monitor::Advance RefinementMonitor::advance(Node node, Event event) {
    const std::scoped_lock lock(*turn_);
    const std::optional<NormalForm::Node> next = specification_.node_after(node, event);
    if (!next) return {Effect::violation};
    if (model_ == Model::failures_divergences && specification_.diverges(*next)) return {Effect::ignore};
    return {Effect::follow, *next};
}

/// In F, the acceptance of a stable state must include one of the specification's acceptances after the same trace.
/// This is equivalent to the inclusion of refusals, because refusals are the subsets of an acceptance's complement.
std::optional<ViolationKind> refusal(const std::vector<EventSet>& acceptances, const Offer& offer) {
    if (offer.tau && !offer.can_tick()) return std::nullopt;
    const auto first = offer.events.begin();
    const auto last = offer.can_tick() ? first + 1 : offer.events.end();
    const bool allowed = std::ranges::any_of(acceptances, [&](const EventSet& required) {
        return std::includes(first, last, required.begin(), required.end());
    });
    return allowed ? std::nullopt : std::optional(ViolationKind::refusal);
}

std::optional<ViolationKind> RefinementMonitor::examine(Node node, const Offer& offer) {
    if (model_ == Model::traces || (offer.tau && !offer.can_tick())) return std::nullopt;
    return refusal(acceptances(node), offer);
}

/// Returns the acceptances of a node. The reference stays valid when this function is called again.
const std::vector<EventSet>& RefinementMonitor::acceptances(Node node) {
    if (node >= acceptances_.size()) acceptances_.resize(std::max<std::size_t>(node + 1U, 2 * acceptances_.size()));
    if (acceptances_[node] == nullptr) {
        const std::scoped_lock lock(*turn_);
        acceptances_[node] = &specification_.acceptances(node);
    }
    return *acceptances_[node];
}

std::optional<ViolationKind> StateMonitor::examine(Node /*node*/, const Offer& offer) {
    return forbid_deadlock_ && offer.is_empty() ? std::optional(ViolationKind::deadlock) : std::nullopt;
}

std::optional<ViolationKind> ChoiceMonitor::examine(Node /*node*/, const Offer& offer) {
    const bool open = offer.tau || offer.branches || (offer.can_tick() && offer.events.size() > 1);
    return open ? std::optional(ViolationKind::nondeterminism) : std::nullopt;
}

Monitor::Advance TraceMonitor::advance(Node node, Event event) {
    if (node >= goal_ || trace_[node] != event) return {Effect::ignore};
    furthest_ = std::max(furthest_, node + std::size_t{1});
    return {Effect::follow, node + 1};
}

std::optional<ViolationKind> TraceMonitor::examine(Node node, const Offer& offer) {
    if (node != goal_) return std::nullopt;
    if (!refused_) return ViolationKind::no_trace;
    const std::optional<EventSet> accepted = acceptance(offer);
    const bool refuses = accepted && !std::ranges::binary_search(*accepted, *refused_);
    return refuses ? std::optional(ViolationKind::nondeterminism) : std::nullopt;
}

}  // namespace robochart::refine
