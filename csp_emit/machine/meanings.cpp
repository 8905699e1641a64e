// SPDX-License-Identifier: Apache-2.0
// Describes a configuration in terms of the model.
#include "csp_emit/machine/meanings.hpp"

#include <algorithm>

#include "base/diagnostics/containers.hpp"
#include "csp_emit/machine/rules/transitions.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

using ir::StmtKind;

namespace {

ParameterKind kind_of(CellKind kind) {
    switch (kind) {
        case CellKind::clock:
            return ParameterKind::clock;
        case CellKind::deadline:
        case CellKind::waiting:
        case CellKind::monitor:
            return ParameterKind::countdown;
        case CellKind::frozen:
            return ParameterKind::temporary;
        case CellKind::variable:
            break;
    }
    return ParameterKind::variable;
}

}  // namespace

DefinitionMeaning DefinitionMeanings::meaning_of(const Point& point, const Function& function) {
    DefinitionMeaning meaning;
    meaning.text = describe_activation(point.config);
    meaning.component = tables_.context.path;
    meaning.machine = qualified_name(tables_.machine().package, tables_.machine().path);
    add_parameters(function, meaning);
    const View now = view_of(point.config);
    meaning.active = active_states(now);
    meaning.ahead = nodes_ahead(now);
    meaning.offers = offers_of(now);
    const Activation& inner = innermost_activation(point.config);
    const Item* item = running_item(point.config);
    if (item != nullptr && item->stmt != nullptr)
        meaning.origin = item->stmt->origin;
    else if (inner.at.is_valid())
        meaning.origin = tables_.frames[inner.frame].machine->nodes[inner.at.index].origin;
    return meaning;
}

void DefinitionMeanings::add_parameters(const Function& function, DefinitionMeaning& meaning) const {
    const std::vector<ConstantParameter>& constants = tables_.calls.constants();
    for (const std::string& parameter : function.parameters) {
        const std::optional<CellId> id = tables_.cells.find_cell(parameter);
        const Cell* cell = id ? &tables_.cells[*id] : nullptr;
        const auto constant =
            std::ranges::find_if(constants, [&](const ConstantParameter& c) { return c.inside == parameter; });
        std::string name;
        ir::TypeId type;
        ParameterKind kind = ParameterKind::temporary;
        if (cell != nullptr) {
            name = cell->meaning;
            type = cell->type;
            if (tables_.watch.reset_cell() != id) kind = kind_of(cell->kind);
        } else if (constant != constants.end()) {
            name = constant->constant;
            type = constant->type;
            kind = ParameterKind::constant;
        }
        meaning.parameters.push_back(std::move(name));
        meaning.types.push_back(type);
        meaning.deadlines.push_back(cell != nullptr ? cell->deadline : ir::Origin{});
        meaning.kinds.push_back(kind);
    }
}

/// Returns the active states: states that have been entered and not left yet, and their parents. The states of a caller
/// come before those of the called operation.
std::vector<ir::Origin> DefinitionMeanings::active_states(const View& now) const {
    std::vector<ir::Origin> result;
    for (const RunningMachine& running : now.machines) {
        const Activation& activation = *running.activation;
        const auto& nodes = tables_.frames[activation.frame].machine->nodes;
        std::vector<ir::NodeId> active = activation.entered;
        for (ir::NodeId at = activation.at; at.is_valid(); at = nodes[at.index].parent) active.push_back(at);
        std::vector<ir::NodeId> around;
        for (const ir::NodeId node : active)
            for (ir::NodeId at = node; at.is_valid(); at = nodes[at.index].parent)
                if (nodes[at.index].kind == ir::NodeKind::state || nodes[at.index].kind == ir::NodeKind::final)
                    around.push_back(at);
        const auto depth = [&](ir::NodeId node) {
            std::size_t levels = 0;
            for (ir::NodeId at = node; at.is_valid(); at = nodes[at.index].parent) ++levels;
            return levels;
        };
        std::ranges::sort(around, [&](ir::NodeId one, ir::NodeId other) {
            return std::pair(depth(one), one.index) < std::pair(depth(other), other.index);
        });
        diagnostics::erase_repeated(around);
        for (const ir::NodeId node : around) result.push_back(nodes[node.index].origin);
    }
    return result;
}

std::vector<std::string> DefinitionMeanings::nodes_ahead(const View& now) const {
    std::vector<std::string> result;
    for (const RunningMachine& running : now.machines) {
        const Activation& activation = *running.activation;
        const auto& nodes = tables_.frames[activation.frame].machine->nodes;
        if (activation.at.is_valid()) result.push_back(nodes[activation.at.index].origin.element);
        for (const Link* link = activation.control.rest.get(); link != nullptr; link = link->tail.get())
            if (link->head.kind == ItemKind::enter) result.push_back(nodes[link->head.node.index].origin.element);
    }
    return result;
}

std::vector<DefinitionMeanings::Offer> DefinitionMeanings::offers_of(const View& now) {
    std::vector<Offer> result;
    const auto add = [&](Offer one) {
        if (one) result.push_back(std::move(one));
    };
    for (const RunningMachine& running : now.machines)
        for (const ir::TransitionId id : outgoing_transitions(tables_, *running.activation))
            add(make_offer(running, id));
    for (const RunningThread& running : now.threads) add(make_offer(running));
    return result;
}

/// Returns the offer of a transition with a trigger, which is an input.
DefinitionMeanings::Offer DefinitionMeanings::make_offer(const RunningMachine& running, ir::TransitionId id) {
    const std::uint32_t frame = running.activation->frame;
    const ir::Machine& owner = *tables_.frames[frame].machine;
    const ir::Transition& transition = owner.transitions[id.index];
    if (!transition.trigger) return nullptr;
    auto& known = offers_[{frame, "transition " + std::to_string(id.index)}];
    if (!known)
        known = std::make_shared<const OfferMeaning>(OfferMeaning{
            tables_.frames[frame].events.at(transition.trigger->event.index) + ".in", ir::text_of(owner, transition),
            transition.origin, transition.name, owner.nodes[transition.target.index].origin.element});
    return known;
}

/// Returns the offer of a statement: a communication, a call that leaves the machine, or a write.
DefinitionMeanings::Offer DefinitionMeanings::make_offer(const RunningThread& running) {
    const Item& item = running.head();
    const Frame& frame = tables_.frames[running.frame()];
    if (item.stmt == nullptr) return nullptr;
    const ir::Stmt& stmt = *item.stmt;
    const bool store = item.kind == ItemKind::store;
    std::string event;
    if (store)
        event = "set_" + tables_.cells[frame.variables.at(item.variable.index)].channel;
    else if (stmt.kind == StmtKind::communicate)
        event = frame.events.at(stmt.communication.event.index) +
                (stmt.communication.kind == ir::CommKind::input ? ".in" : ".out");
    else if (stmt.kind == StmtKind::call)
        event = frame.machine->operations.at(stmt.operation.index).name + "Call";
    else if (stmt.kind == StmtKind::assign)
        event = "set_" + tables_.cells[frame.variables.at(stmt.variable.index)].channel;
    if (event.empty()) return nullptr;
    auto& known = offers_[{running.frame(), (store ? "store " : "statement ") + std::to_string(stmt.point)}];
    if (!known) known = std::make_shared<const OfferMeaning>(OfferMeaning{event, item.label, stmt.origin});
    return known;
}

std::string DefinitionMeanings::describe_activation(const Activation& config) const {
    const std::uint32_t frame = innermost_activation(config).frame;
    std::string result;
    if (frame != 0) result = "operation " + tables_.frames[frame].machine->name + ": ";
    const Activation& inner = innermost_activation(config);
    if (const Item* item = running_item(config)) {
        result += item->label;
        if (item->kind == ItemKind::waiting) result += ", waiting";
        if (item->kind == ItemKind::stuck) result += ", blocked";
        if (item->kind == ItemKind::resume) result += ", when the next cycle begins";
        const bool statement = item->kind == ItemKind::statement || item->kind == ItemKind::frozen;
        const std::string text =
            statement && item->stmt != nullptr ? tables_.project().model_text(item->stmt->origin.span) : "";
        if (!text.empty()) result += ", at " + text;
    } else if (inner.at.is_valid()) {
        const ir::Node& node = tables_.frames[inner.frame].machine->nodes[inner.at.index];
        const char* kinds[] = {"in ", "at initial node ", "at junction ", "at probabilistic junction ",
                               "at final state "};
        result += kinds[static_cast<std::size_t>(node.kind)] + node.path;
    } else {
        result += "no behaviour";
    }
    for (const During& during : config.durings)
        if (!during.thread.callee && during.thread.rest && during.thread.rest->head.kind == ItemKind::store &&
            during.thread.rest->head.stmt == nullptr)
            result += ", the received value not yet stored";
        else
            result += ", during action of " + tables_.frames[config.frame].machine->nodes[during.node.index].path +
                      " goes on";
    return result;
}

}  // namespace robochart::csp_emit
