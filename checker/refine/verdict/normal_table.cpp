// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/verdict/normal_table.hpp"

#include <algorithm>
#include <cassert>

#include "checker/refine/verdict/monitors.hpp"

namespace robochart::refine {

using process::Event;

namespace {

/// Numbers nodes in the order of discovery.
class Numbering {
public:
    Monitor::Node number_of(NormalForm::Node node) {
        if (node >= numbers_.size()) numbers_.resize(std::max<std::size_t>(node + 1U, 2 * numbers_.size()), none);
        if (numbers_[node] == none) {
            numbers_[node] = static_cast<Monitor::Node>(met.size());
            met.push_back(node);
        }
        return numbers_[node];
    }
    std::vector<NormalForm::Node> met;

private:
    static constexpr Monitor::Node none = static_cast<Monitor::Node>(-1);
    std::vector<Monitor::Node> numbers_;
};

}  // namespace

std::optional<NormalTable> table_of(NormalForm& normal, Model model, std::size_t most_nodes) {
    NormalTable table;
    Numbering numbering;
    try {
        numbering.number_of(normal.initial());
        for (std::size_t at = 0; at < numbering.met.size(); ++at) {
            if (numbering.met.size() > most_nodes) return std::nullopt;
            const NormalForm::Node node = numbering.met[at];
            NormalTable::Node& row = table.nodes.emplace_back();
            row.diverges = model == Model::failures_divergences && normal.diverges(node);
            if (row.diverges) continue;
            for (const Event event : normal.initials(node))
                row.arcs.emplace_back(event, numbering.number_of(normal.node_after(node, event).value()));
            if (model != Model::traces) row.acceptances = normal.acceptances(node);
        }
    } catch (const SpecificationGrows&) {
        return std::nullopt;
    }
    return table;
}

Monitor::Advance TableMonitor::advance(Node node, Event event) {
    assert(node < table_->nodes.size());
    const auto& arcs = table_->nodes[node].arcs;
    const auto arc = std::ranges::lower_bound(arcs, event, {}, &std::pair<Event, Node>::first);
    if (arc == arcs.end() || arc->first != event) return {Effect::violation};
    if (table_->nodes[arc->second].diverges) return {Effect::ignore};
    return {Effect::follow, arc->second};
}

std::optional<ViolationKind> TableMonitor::examine(Node node, const Offer& offer) {
    if (model_ == Model::traces) return std::nullopt;
    return refusal(table_->nodes[node].acceptances, offer);
}

}  // namespace robochart::refine
