// What the definitions of a machine mean to the reader of the model: the active states, what each parameter holds, and
// which transition or statement each event comes from that the configuration offers.
#include <algorithm>

#include "csp_emit/machine/machine.hpp"

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

/// The innermost thing that goes on: what names and describes the configuration.
const Item* running_item(const Activation& activation) {
    if (activation.control.callee) return running_item(*activation.control.callee);
    return activation.control.rest ? &activation.control.rest->head : nullptr;
}

std::uint32_t running_frame(const Activation& activation) {
    return activation.control.callee ? running_frame(*activation.control.callee) : activation.frame;
}

const Activation& innermost(const Activation& activation) {
    return activation.control.callee ? innermost(*activation.control.callee) : activation;
}

}  // namespace

DefinitionMeaning MachineEmitter::meaning_of(const Point& point, const Function& function) {
    DefinitionMeaning meaning;
    meaning.text = describe(point.config);
    meaning.component = context_.path;
    meaning.machine = qualified(machine().package, machine().path);
    add_parameters(function, meaning);
    const View now = view(point.config);
    meaning.active = active_states(now);
    meaning.offers = offers(now);
    const Activation& inner = innermost(point.config);
    const Item* item = running_item(point.config);
    if (item != nullptr && item->stmt != nullptr)
        meaning.origin = item->stmt->origin;
    else if (inner.at.valid())
        meaning.origin = frames_[inner.frame].machine->nodes[inner.at.index].origin;
    return meaning;
}

void MachineEmitter::add_parameters(const Function& function, DefinitionMeaning& meaning) const {
    for (const std::string& parameter : function.parameters) {
        const auto found = cell_named_.find(parameter);
        const Cell* cell = found == cell_named_.end() ? nullptr : &cells_[found->second];
        const auto constant = std::find_if(constants_.begin(), constants_.end(),
                                           [&](const ConstantParameter& c) { return c.inside == parameter; });
        const bool known = cell == nullptr && constant != constants_.end();
        const bool watching = watch_ && found != cell_named_.end() && found->second == *watch_;
        meaning.parameters.push_back(cell != nullptr ? cell->meaning : known ? constant->constant : "");
        meaning.types.push_back(cell != nullptr ? cell->type : known ? constant->type : ir::TypeId{});
        meaning.deadlines.push_back(cell != nullptr ? cell->deadline : ir::Origin{});
        meaning.kinds.push_back(watching          ? ParameterKind::temporary
                                : cell != nullptr ? kind_of(cell->kind)
                                : known           ? ParameterKind::constant
                                                  : ParameterKind::temporary);
    }
}

/// States that have been entered and not left yet, in the order of the calls; a state around an active one is active.
std::vector<ir::Origin> MachineEmitter::active_states(const View& now) const {
    std::vector<ir::Origin> result;
    for (const Spot& spot : now.spots) {
        const Activation& activation = *spot.activation;
        const auto& nodes = frames_[activation.frame].machine->nodes;
        std::vector<ir::NodeId> active = activation.entered;
        for (ir::NodeId at = activation.at; at.valid(); at = nodes[at.index].parent) active.push_back(at);
        std::vector<ir::NodeId> around;
        for (const ir::NodeId node : active)
            for (ir::NodeId at = node; at.valid(); at = nodes[at.index].parent)
                if (nodes[at.index].kind == ir::NodeKind::state || nodes[at.index].kind == ir::NodeKind::final)
                    around.push_back(at);
        const auto depth = [&](ir::NodeId node) {
            std::size_t levels = 0;
            for (ir::NodeId at = node; at.valid(); at = nodes[at.index].parent) ++levels;
            return levels;
        };
        std::sort(around.begin(), around.end(), [&](ir::NodeId one, ir::NodeId other) {
            return std::pair(depth(one), one.index) < std::pair(depth(other), other.index);
        });
        around.erase(std::unique(around.begin(), around.end()), around.end());
        for (const ir::NodeId node : around) result.push_back(nodes[node.index].origin);
    }
    return result;
}

std::vector<std::shared_ptr<const OfferMeaning>> MachineEmitter::offers(const View& now) {
    std::vector<std::shared_ptr<const OfferMeaning>> result;
    const auto add = [&](std::shared_ptr<const OfferMeaning> one) {
        if (one) result.push_back(std::move(one));
    };
    for (const Spot& spot : now.spots)
        for (const ir::TransitionId id : candidates(*spot.activation)) add(offer(spot, id));
    for (const Place& place : now.places) add(offer(place));
    return result;
}

/// Of a transition with a trigger: its input.
std::shared_ptr<const OfferMeaning> MachineEmitter::offer(const Spot& spot, ir::TransitionId id) {
    const std::uint32_t frame = spot.activation->frame;
    const ir::Machine& owner = *frames_[frame].machine;
    const ir::Transition& transition = owner.transitions[id.index];
    if (!transition.trigger) return nullptr;
    auto& known = offers_[{frame, "transition " + std::to_string(id.index)}];
    if (!known)
        known = std::make_shared<const OfferMeaning>(
            OfferMeaning{frames_[frame].events.at(transition.trigger->event.index) + ".in",
                         transition.name + ": " + owner.nodes[transition.source.index].path + " -> " +
                             owner.nodes[transition.target.index].path,
                         transition.origin, transition.name, owner.nodes[transition.target.index].origin.element});
    return known;
}

/// Of a statement that is an event of its own: a communication, a call that leaves the machine, a write.
std::shared_ptr<const OfferMeaning> MachineEmitter::offer(const Place& place) {
    const Item& item = place.head();
    const Frame& frame = frames_[place.owner->frame];
    if (item.stmt == nullptr) return nullptr;
    const ir::Stmt& stmt = *item.stmt;
    const bool store = item.kind == ItemKind::store;
    std::string event;
    if (store)
        event = "set_" + cells_[frame.variables.at(item.variable.index)].channel;
    else if (stmt.kind == StmtKind::communicate)
        event = frame.events.at(stmt.communication.event.index) +
                (stmt.communication.kind == ir::CommKind::input ? ".in" : ".out");
    else if (stmt.kind == StmtKind::call)
        event = frame.machine->operations.at(stmt.operation.index).name + "Call";
    else if (stmt.kind == StmtKind::assign)
        event = "set_" + cells_[frame.variables.at(stmt.variable.index)].channel;
    if (event.empty()) return nullptr;
    auto& known = offers_[{place.owner->frame, (store ? "store " : "statement ") + std::to_string(stmt.point)}];
    if (!known) known = std::make_shared<const OfferMeaning>(OfferMeaning{event, item.label, stmt.origin});
    return known;
}

std::string MachineEmitter::describe(const Activation& config) const {
    const std::uint32_t frame = running_frame(config);
    std::string result;
    if (frame != 0) result = "operation " + frames_[frame].machine->name + ": ";
    const Activation& inner = innermost(config);
    if (const Item* item = running_item(config)) {
        result += item->label;
        if (item->kind == ItemKind::waiting) result += ", waiting";
        if (item->kind == ItemKind::stuck) result += ", blocked";
        const bool statement = item->kind == ItemKind::statement || item->kind == ItemKind::frozen;
        const std::string text = statement && item->stmt != nullptr ? project().text(item->stmt->origin.span) : "";
        if (!text.empty()) result += ", at " + text;
    } else if (inner.at.valid()) {
        const ir::Node& node = frames_[inner.frame].machine->nodes[inner.at.index];
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
            result += ", during action of " + frames_[config.frame].machine->nodes[during.node.index].path + " goes on";
    return result;
}

std::string MachineEmitter::point_name(const Activation& config) {
    const Activation& inner = innermost(config);
    std::string base = frames_[running_frame(config)].prefix;
    if (const Item* item = running_item(config))
        base += flatten(item->label);
    else if (inner.at.valid())
        base += flatten(frames_[inner.frame].machine->nodes[inner.at.index].path);
    if (!config.durings.empty()) base += "_during";
    return context_.names.unique(base + "__");
}

}  // namespace robochart::csp_emit
