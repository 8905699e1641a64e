// SPDX-License-Identifier: Apache-2.0
// See following.hpp.
#include "prism/assertions/process/following.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/diagnostics/containers.hpp"
#include "prism/assertions/experiments/encoding.hpp"
#include "prism/assertions/process/seats.hpp"

namespace robochart::probability {
namespace {

using csp_emit::MeaningKind;

/// Recognises the event by which time passes.
class Ticks {
public:
    Ticks(const lts::EventTable& events, const csp_emit::Provenance& provenance)
        : events_(events), provenance_(provenance) {}

    bool operator()(lts::Event event) {
        if (event == lts::tau || event == lts::tick) return false;
        const auto [known, added] = known_.try_emplace(event, false);
        if (added) {
            const auto found = provenance_.events.find(events_.name(event));
            known->second = found != provenance_.events.end() && found->second.kind == MeaningKind::tock;
        }
        return known->second;
    }

private:
    const lts::EventTable& events_;
    const csp_emit::Provenance& provenance_;
    std::map<lts::Event, bool> known_;
};

class Follower {
public:
    Follower(const ExploredProcess& process, diagnostics::Pollable& budget)
        : process_(process), budget_(budget), ticks_(process.session->event_table(), process.emission.provenance) {}

    /// `leaves` contains the states of the machine that contain no other state.
    Following operator()(const std::string& machine, const std::vector<std::string>& elements,
                         const std::set<std::string>& leaves, std::uint64_t units) {
        check_time(machine, leaves);
        read_classes(machine, elements);
        const std::size_t count = result_.classes.size();
        result_.first.assign(count, false);
        result_.after.assign(count, std::vector<bool>(count));
        std::vector<bool> initial(process_.exploration->size());
        initial[0] = true;
        result_.first[class_index(bits_[0])] = true;
        find_classes_after(class_index(bits_[0]), initial, units);
        for (std::size_t from = 0; from < count; ++from) find_classes_after(from, states_after_time(from), units);
        return std::move(result_);
    }

private:
    /// Rejects models for which the code may differ from the process. Generated code continues after the model has
    /// terminated or time has stopped. While time passes in a transition, the code reports the source state. The
    /// process does not describe this behaviour.
    void check_time(const std::string& machine, const std::set<std::string>& leaves) {
        const Exploration& explored = *process_.exploration;
        for (lts::StateIndex state = 0; state < explored.size(); ++state) {
            budget_.poll();
            if (explored.steps_from(state).empty()) throw Wrong("time may stop in it");
            bool passes = false;
            for (const Step& step : explored.steps_from(state)) {
                if (step.event == lts::tick) throw Wrong("it may terminate");
                passes = passes || ticks_(step.event);
            }
            if (passes && !is_in_leaf(state, machine, leaves))
                throw Wrong("time may pass while a transition is taken, or in a final state");
        }
    }

    [[nodiscard]] bool is_in_leaf(lts::StateIndex state, const std::string& machine,
                                  const std::set<std::string>& leaves) const {
        for (const std::size_t number : process_.reader->parts_of_state(process_.exploration->state(state)))
            for (const runs::Call& call : process_.reader->part(number).calls)
                if (call.definition->component == machine)
                    for (const ir::Origin& active : call.definition->active)
                        if (leaves.contains(active.element)) return true;
        return false;
    }

    void read_classes(const std::string& machine, const std::vector<std::string>& elements) {
        const Exploration& explored = *process_.exploration;
        std::vector<std::uint32_t> found;
        for (lts::StateIndex state = 0; state < explored.size(); ++state) {
            budget_.poll();
            std::uint32_t bits = 0;
            for (const std::size_t number : process_.reader->parts_of_state(explored.state(state)))
                for (std::size_t i = 0; i < elements.size(); ++i)
                    if (process_.reader->part(number).in_state(machine, elements[i])) bits |= std::uint32_t{1} << i;
            bits_.push_back(bits);
        }
        found.push_back(bits_[0]);
        for (lts::StateIndex state = 0; state < explored.size(); ++state)
            for (const Step& step : explored.steps_from(state))
                if (ticks_(step.event)) {
                    found.push_back(bits_[state]);
                    found.push_back(bits_[step.target]);
                }
        if (found.size() == 1) throw Wrong("no time can pass in it");
        diagnostics::sort_unique(found);
        result_.classes = std::move(found);
    }

    [[nodiscard]] std::size_t class_index(std::uint32_t bits) const {
        return static_cast<std::size_t>(std::ranges::lower_bound(result_.classes, bits) - result_.classes.begin());
    }

    /// Returns the states after each time unit whose class, before or after the step, is the class `from`.
    [[nodiscard]] std::vector<bool> states_after_time(std::size_t from) {
        const Exploration& explored = *process_.exploration;
        std::vector<bool> result(explored.size());
        const std::uint32_t bits = result_.classes[from];
        for (lts::StateIndex state = 0; state < explored.size(); ++state)
            for (const Step& step : explored.steps_from(state))
                if (ticks_(step.event) && (bits_[state] == bits || bits_[step.target] == bits))
                    result[step.target] = true;
        return result;
    }

    /// Adds the states that are reachable without the passing of time.
    void add_untimed_successors(std::vector<bool>& states) {
        std::vector<lts::StateIndex> open;
        for (lts::StateIndex state = 0; state < states.size(); ++state)
            if (states[state]) open.push_back(state);
        while (!open.empty()) {
            budget_.poll();
            const lts::StateIndex state = open.back();
            open.pop_back();
            for (const Step& step : process_.exploration->steps_from(state))
                if (!ticks_(step.event) && !states[step.target]) {
                    states[step.target] = true;
                    open.push_back(step.target);
                }
        }
    }

    /// Advances by one time unit, to the states directly after the unit. Marks the classes before and after it.
    template <class Mark>
    std::vector<bool> mark_next_unit(std::vector<bool> states, const Mark& seen) {
        add_untimed_successors(states);
        std::vector<bool> next(states.size());
        for (lts::StateIndex state = 0; state < states.size(); ++state) {
            if (!states[state]) continue;
            for (const Step& step : process_.exploration->steps_from(state))
                if (ticks_(step.event)) {
                    next[step.target] = true;
                    seen(class_index(bits_[state]));
                    seen(class_index(bits_[step.target]));
                }
        }
        return next;
    }

    void find_classes_after(std::size_t from, std::vector<bool> states, std::uint64_t units) {
        std::vector<bool> found;
        for (std::uint64_t unit = 0; unit < units; ++unit) {
            found.assign(result_.classes.size(), false);
            std::vector<bool> next =
                mark_next_unit(states, [&](std::size_t class_number) { found[class_number] = true; });
            const bool same = next == states;
            states = std::move(next);
            if (same) break;  // a fixed point, so the classes do not change
        }
        for (std::size_t to = 0; to < found.size(); ++to)
            if (found[to]) result_.after[from][to] = true;
    }

    const ExploredProcess& process_;
    diagnostics::Pollable& budget_;
    Ticks ticks_;
    std::vector<std::uint32_t> bits_;  ///< the class of each state
    Following result_;
};

bool is_whole(const ir::System& system, ir::TypeId id) {
    const ir::Type& type = system.type(id);
    if (type.kind == ir::TypeKind::enumeration)
        return std::ranges::all_of(type.literal_args, [](const auto& arguments) { return arguments.empty(); });
    return type.kind == ir::TypeKind::boolean || type.kind == ir::TypeKind::unit;
}

/// Checks that the values are finite. A finite instantiation contains all truth values and literals, but not all
/// numbers, strings or sequences. For other values, code may behave differently from the process.
void check_values(const ir::System& system, const ir::Machine& machine) {
    constexpr const char* why = "the proof would cover only the values of {} in the finite instantiation";
    for (const ir::Variable& variable : machine.variables)
        if (!is_whole(system, variable.type)) throw Wrong(fmt::format(why, variable.name));
    for (const ir::Event& event : machine.events)
        if (event.type && !is_whole(system, *event.type)) throw Wrong(fmt::format(why, event.name));
}

std::set<std::string> leaves_of(const ir::Machine& machine) {
    std::set<std::string> leaves;
    for (const ir::Node& node : machine.nodes)
        if (node.kind == ir::NodeKind::state && !node.is_composite()) leaves.insert(node.origin.element);
    return leaves;
}

}  // namespace

void check_finite(const ir::System& system, const ir::ComponentRef& subject) {
    for (const Seat& seat : seats_in(system, subject)) check_values(system, *seat.machine);
    for (const ir::Machine& machine : system.machines)
        if (machine.kind == ir::MachineKind::operation) check_values(system, machine);
}

Following find_following(const ExploredProcess& process, const ir::System& system, const ir::ComponentRef& subject,
                         const std::vector<std::string>& states, std::uint64_t units, diagnostics::Pollable& budget) {
    const std::vector<Seat> seats = seats_in(system, subject);
    if (seats.empty()) throw Wrong("the component has no machine");
    std::vector<std::string> elements;
    for (const std::string& state : states) {
        const auto& nodes = seats.front().machine->nodes;
        const auto found = std::ranges::find_if(nodes, [&](const auto& node) { return node.path == state; });
        if (found == nodes.end()) throw Wrong(fmt::format("the machine has no state {}", state));
        elements.push_back(found->origin.element);
    }
    check_finite(system, subject);
    return Follower(process, budget)(seats.front().component, elements, leaves_of(*seats.front().machine), units);
}

}  // namespace robochart::probability
