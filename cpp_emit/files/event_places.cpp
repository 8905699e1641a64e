// SPDX-License-Identifier: Apache-2.0
// Finds places where an event raised by the platform may be lost or taken late (docs/conformance.md, "Events that can
// be missed", "Events that come second").
#include <algorithm>
#include <cassert>
#include <set>

#include "cpp_emit/code/dispatch.hpp"
#include "cpp_emit/code/suspension.hpp"
#include "cpp_emit/files/files.hpp"

namespace robochart::cpp_emit {

namespace {

/// Returns the name of the member that shows the state of the part's machine.
std::string member_of(const Part& part) {
    return part.tag.empty() ? "state" : part.tag + ".state";
}

class PlaceFinder {
public:
    PlaceFinder(const Generation& generation, const Core& core)
        : generation_(generation), core_(core), events_(input_events(generation.component)) {}

    std::vector<EventPlace> find_places() {
        for (const Part& part : generation_.component.parts) find_in_machine(part, part.root);
        return std::move(places_);
    }

private:
    void find_in_machine(const Part& part, std::size_t root) {
        const ir::Machine& machine = *generation_.component.units[root].machine;
        if (!machine.initial.is_valid()) return;
        const std::string member = member_of(part);
        const std::vector<Enumerator>& values = core_.machines[root].enumerations.front().values;
        assert(!values.empty());
        std::string program;  // the program whose places are being visited
        for (std::size_t i = 0; i < values.size(); ++i) {
            const Enumerator& value = values[i];
            const std::string comment = diagnostics::escape_for_display(value.comment);
            if (comment != "waits") program = comment;
            if (i == 0) continue;  // before the first cycle
            EventPlace place{member, value.name, program, !value.rests};
            Awaited awaited(events_.size());
            add_awaited(part, machine, value.state, awaited);
            place.level.assign(events_.size(), EventPlace::no_level);
            if (value.rests) place.level = awaited.level;
            if (!value.rests) follow_junctions(part, machine, value.target, awaited);
            place.events = value.rests ? awaited.conditional_events() : awaited.all;
            const bool missed = std::ranges::find(place.events, true) != place.events.end();
            const bool outer = std::ranges::any_of(
                place.level, [](std::uint32_t level) { return level > 0 && level != EventPlace::no_level; });
            if (missed || outer) places_.push_back(std::move(place));
        }
    }

    /// Returns, for each event that the platform raises, whether it is connected to this event of the machine.
    [[nodiscard]] std::vector<bool> raised_events(const EventUse& use) const {
        std::vector<bool> result(events_.size());
        for (const std::size_t port : use.ports) {
            const auto found = std::ranges::find(events_, &generation_.component.events[port]);
            if (found != events_.end()) result[static_cast<std::size_t>(found - events_.begin())] = true;
        }
        return result;
    }

    /// The events that the transitions of a state and of its enclosing states await.
    struct Awaited {
        explicit Awaited(std::size_t events) : all(events), taken(events), level(events, EventPlace::no_level) {}
        std::vector<bool> all;    ///< some transition awaits the event
        std::vector<bool> taken;  ///< some transition awaits the event without a condition
        /// The number of levels between the state and the source of the innermost such transition.
        std::vector<std::uint32_t> level;
        [[nodiscard]] std::vector<bool> conditional_events() const {
            std::vector<bool> result = all;
            for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] && !taken[i];
            return result;
        }
    };

    static void add_flags(const std::vector<bool>& more, std::vector<bool>& to) {
        assert(more.size() == to.size());
        for (std::size_t i = 0; i < to.size(); ++i) to[i] = to[i] || more[i];
    }

    void add_awaited(const Part& part, const ir::Machine& machine, ir::NodeId state, Awaited& awaited) const {
        for (std::uint32_t level = 0; state.is_valid(); state = machine.nodes[state.index].parent, ++level)
            for (const ir::TransitionId id : machine.nodes[state.index].outgoing) {
                const ir::Transition& transition = machine.transitions[id.index];
                if (!transition.trigger) continue;
                const std::string& name = machine.events[transition.trigger->event.index].name;
                const auto use = std::ranges::find_if(
                    part.events, [&](const EventUse& candidate) { return candidate.name == name; });
                if (use == part.events.end()) continue;
                const std::vector<bool> events = raised_events(*use);
                for (std::size_t i = 0; i < events.size(); ++i)
                    if (events[i]) awaited.level[i] = std::min(awaited.level[i], level);
                add_flags(events, awaited.all);
                if (!transition.guard && !transition.trigger->predicate) add_flags(events, awaited.taken);
            }
    }

    /// Follows a transition through junctions, and adds the events that the junctions and the targets await.
    void follow_junctions(const Part& part, const ir::Machine& machine, ir::NodeId target, Awaited& awaited) const {
        std::vector<ir::NodeId> open;
        if (target.is_valid()) open.push_back(target);
        std::vector<bool> seen(machine.nodes.size());
        while (!open.empty()) {
            const ir::NodeId node = open.back();
            open.pop_back();
            if (seen[node.index]) continue;
            seen[node.index] = true;
            add_awaited(part, machine, node, awaited);
            const ir::NodeKind kind = machine.nodes[node.index].kind;
            if (kind == ir::NodeKind::state || kind == ir::NodeKind::final) continue;
            for (const ir::TransitionId id : machine.nodes[node.index].outgoing)
                open.push_back(machine.transitions[id.index].target);
        }
    }

    const Generation& generation_;
    const Core& core_;
    std::vector<const EventPort*> events_;
    std::vector<EventPlace> places_;
};

}  // namespace

std::vector<EventPlace> event_places(const Generation& generation, const Core& core) {
    return PlaceFinder(generation, core).find_places();
}

std::vector<bool> lost_in_actions(const Generation& generation, const Core& core) {
    std::set<std::string> slow;  // names of the members that contain the states of these machines
    for (const Part& part : generation.component.parts)
        if (actions_take_time(generation, generation.component.units[part.root])) slow.insert(member_of(part));
    std::vector<bool> result(input_events(generation.component).size());
    for (const EventPlace& place : event_places(generation, core))
        for (std::size_t i = 0; i < result.size(); ++i)
            if (place.busy && place.events[i] && slow.contains(place.member)) result[i] = true;
    return result;
}

}  // namespace robochart::cpp_emit
