// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/verdict/indifference.hpp"

#include <algorithm>

#include "checker/process/refusal.hpp"

namespace robochart::refine {
namespace {

using process::Event;
using process::EventSet;

constexpr NormalForm::Node most_nodes = 10'000;

EventSet image_of(const EventSet& events, const lts::EventPermutation& exchange) {
    EventSet result;
    for (const Event event : events) {
        const auto moved = std::ranges::lower_bound(exchange, std::pair(event, Event{0}));
        result.push_back(moved != exchange.end() && moved->first == event ? moved->second : event);
    }
    std::ranges::sort(result);
    return result;
}

}  // namespace

bool Indifference::holds_for(const lts::EventPermutation& exchange) {
    if (!normal_) {
        normal_.emplace(specification_, budget_);
        whole_ = visit_nodes();
    }
    for (NormalForm::Node node = 0; whole_ && node < normal_->size(); ++node)
        if (!holds_at(node, exchange)) return false;
    return whole_;
}

/// Visits all nodes. They are numbered in the order of their discovery.
bool Indifference::visit_nodes() {
    return process::unless_refused([this] {
        normal_->initial();
        for (NormalForm::Node node = 0; node < normal_->size(); ++node) {
            if (normal_->size() > most_nodes) return false;
            budget_.charge();
            for (const Event event : normal_->initials(node)) static_cast<void>(normal_->node_after(node, event));
            if (model_ != Model::traces) static_cast<void>(normal_->acceptances(node));
        }
        return true;
    });
}

bool Indifference::holds_at(NormalForm::Node node, const lts::EventPermutation& exchange) {
    for (const auto& [event, other] : exchange)
        if (normal_->node_after(node, event) != normal_->node_after(node, other)) return false;
    if (model_ == Model::traces) return true;
    const std::vector<EventSet>& acceptances = normal_->acceptances(node);
    return std::ranges::all_of(acceptances, [&](const EventSet& acceptance) {
        return std::ranges::find(acceptances, image_of(acceptance, exchange)) != acceptances.end();
    });
}

}  // namespace robochart::refine
