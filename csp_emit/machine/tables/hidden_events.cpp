// SPDX-License-Identifier: Apache-2.0
// Chooses the names of hidden events, in the order of their use.
#include "csp_emit/machine/tables/hidden_events.hpp"

#include "checker/cspm/syntax/build.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

ExprPtr HiddenEvents::step_event(const std::string& key, const EventMeaning& meaning) {
    const auto [found, added] = steps_.try_emplace(key, steps_.size());
    if (added) mean(provenance_, context_.path, "step__." + std::to_string(found->second), meaning);
    return b::dot({b::name("step__"), b::number(static_cast<std::int64_t>(found->second))});
}

ExprPtr HiddenEvents::transition_event(std::uint32_t frame, ir::TransitionId id) {
    const auto [found, added] = transitions_.try_emplace({frame, id.index});
    const ir::Machine& owner = *frames_[frame].machine;
    const ir::Transition& transition = owner.transitions[id.index];
    if (added) {
        found->second = context_.names.unique_name("TID_" + frames_[frame].prefix + flatten_name(transition.name));
        EventMeaning meaning;
        meaning.kind = MeaningKind::transition;
        meaning.text = ir::text_of(owner, transition);
        meaning.origin = transition.origin;
        if (owner.nodes[transition.source.index].kind == ir::NodeKind::probabilistic)
            meaning.draw = make_draw(frame, id);
        // constructors are printed with the module that contains them
        mean(provenance_, context_.path, "internal__." + context_.path + "::" + found->second, meaning);
    }
    return b::dot({b::name("internal__"), b::name(found->second)});
}

std::shared_ptr<const Draw> HiddenEvents::make_draw(std::uint32_t frame, ir::TransitionId id) const {
    const ir::Machine& owner = *frames_[frame].machine;
    auto result = std::make_shared<Draw>();
    result->junction = frames_[frame].prefix + owner.nodes[owner.transitions[id.index].source.index].path;
    // An element has the same number in the renamed copy of the system (safe_names.hpp), which exists only during the
    // emission.
    const auto number = static_cast<std::size_t>(&owner - context_.project->system.machines.data());
    result->machine = ir::MachineId{static_cast<std::uint32_t>(number)};
    result->transition = id;
    for (const CellId cell : frames_[frame].variables) result->variables.push_back(cells_[cell].meaning);
    return result;
}

void HiddenEvents::declare_channels(std::vector<cspm::DeclPtr>& decls) const {
    if (!transitions_.empty()) {
        std::vector<cspm::Constructor> constructors;
        for (const auto& [key, name] : transitions_) constructors.push_back(b::constructor(name));
        decls.push_back(b::datatype("TIDS", constructors, "transitions without trigger"));
        decls.push_back(b::channel({"internal__"}, b::name("TIDS")));
    }
    if (!steps_.empty()) {
        const auto last = static_cast<std::int64_t>(steps_.size()) - 1;
        decls.push_back(b::channel({"step__"}, b::set_range(b::number(0), b::number(last)), "steps of actions"));
    }
}

std::vector<ExprPtr> HiddenEvents::declared_channels() const {
    std::vector<ExprPtr> result;
    if (!transitions_.empty()) result.push_back(b::name("internal__"));
    if (!steps_.empty()) result.push_back(b::name("step__"));
    return result;
}

}  // namespace robochart::csp_emit
