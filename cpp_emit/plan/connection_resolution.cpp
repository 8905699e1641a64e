// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/connection_resolution.hpp"

#include <algorithm>
#include <cassert>

#include "cpp_emit/plan/rules.hpp"
#include "cpp_emit/plan/walk.hpp"

namespace robochart::cpp_emit {

namespace {

using diagnostics::Diagnostics;
using ir::ConnectionEnd;
using ir::EndKind;

bool is_part(const ConnectionEnd& end, std::size_t part, const std::string& event) {
    return end.kind == EndKind::part && end.part == part && end.event == event;
}

/// Visits every connection from both ends. A connection is written with a direction, but its events may have either
/// direction.
template <class Visit>
void each_end(const std::vector<ir::Connection>& connections, const Visit& visit) {
    for (std::size_t index = 0; index < connections.size(); ++index) {
        visit(connections[index].from, connections[index].to, index);
        visit(connections[index].to, connections[index].from, index);
    }
}

class Wiring {
public:
    Wiring(Component& component, const ir::System& system, const ir::Module* module,
           const std::vector<const ir::Controller*>& contexts, Diagnostics& diagnostics)
        : component_(component), system_(system), module_(module), contexts_(contexts), diagnostics_(diagnostics) {}

    void wire_parts() {
        assert(contexts_.size() == component_.parts.size());
        for (std::size_t part = 0; part < component_.parts.size(); ++part) collect_events(part);
        for (std::size_t part = 0; part < component_.parts.size(); ++part)
            for (EventUse& use : component_.parts[part].events) follow_connections(part, use);
        for (std::size_t part = 0; part < component_.parts.size(); ++part)
            for (const EventUse& use : component_.parts[part].events) check_connections(part, use);
    }

private:
    /// Collects the part's events, in the order in which its machine declares them.
    void collect_events(std::size_t part) {
        std::vector<EventUse>& uses = component_.parts[part].events;
        const auto use_of = [&](const ir::Event& event) -> EventUse& {
            for (EventUse& use : uses)
                if (use.name == event.name) return use;
            EventUse& use = uses.emplace_back();
            use.name = event.name;
            use.interface = event.interface;
            use.type = event.type;
            return use;
        };
        for (auto unit = component_.units.rbegin(); unit != component_.units.rend(); ++unit) {
            if (unit->part != part) continue;
            visit_communications(*unit->machine, [&](const ir::Communication& communication, bool trigger) {
                EventUse& use = use_of(unit->machine->events[communication.event.index]);
                const bool receives = trigger || communication.kind == ir::CommKind::input;
                (receives ? use.received : use.sent) = true;
            });
        }
        const auto& declared = component_.root_unit(part).machine->events;
        const auto place = [&](const EventUse& use) {
            return std::ranges::find_if(declared, [&](const ir::Event& event) { return event.name == use.name; });
        };
        std::ranges::stable_sort(uses, [&](const EventUse& a, const EventUse& b) { return place(a) < place(b); });
    }

    void follow_connections(std::size_t part, EventUse& use) {
        const ir::Controller* const controller = contexts_[part];
        if (controller == nullptr) return add_port(use, use.name);
        each_end(controller->connections, [&](const ConnectionEnd& here, const ConnectionEnd& there, std::size_t) {
            if (!is_part(here, component_.parts[part].machine, use.name)) return;
            if (there.kind == EndKind::self) return leave_controller(part, use, there.event);
            // Asynchronous connections between machines are treated as synchronous (semantics 3.9).
            add_peer(use, {part_of(component_.parts[part].controller, there.part), there.event});
        });
    }

    [[nodiscard]] std::size_t part_of(std::size_t controller, std::size_t machine) const {
        const auto found = std::ranges::find_if(component_.parts, [&](const Part& part) {
            return part.controller == controller && part.machine == machine;
        });
        assert(found != component_.parts.end());
        return static_cast<std::size_t>(found - component_.parts.begin());
    }

    void leave_controller(std::size_t part, EventUse& use, const std::string& event) {
        if (module_ == nullptr) return add_port(use, event);
        const std::size_t controller = component_.parts[part].controller;
        each_end(module_->connections,
                 [&](const ConnectionEnd& here, const ConnectionEnd& there, std::size_t connection) {
                     if (!is_part(here, controller, event)) return;
                     if (there.kind == EndKind::self) return add_port(use, there.event);
                     if (module_->connections[connection].async) return add_buffer(use, here, connection);
                     enter_controller(use, there.part, there.event);
                 });
    }

    /// Adds the machines of another controller to which the event leads.
    void enter_controller(EventUse& use, std::size_t index, const std::string& event) {
        assert(module_ != nullptr && index < module_->controllers.size());
        const ir::Controller& controller = system_.controller(module_->controllers[index].controller);
        each_end(controller.connections, [&](const ConnectionEnd& here, const ConnectionEnd& there, std::size_t) {
            if (here.kind == EndKind::self && here.event == event && there.kind == EndKind::part)
                add_peer(use, {part_of(index, there.part), there.event});
        });
    }

    static void add_peer(EventUse& use, Peer peer) {
        if (std::ranges::find(use.peers, peer) == use.peers.end()) use.peers.push_back(std::move(peer));
    }

    void add_port(EventUse& use, const std::string& outside) {
        assert(use.received || use.sent);
        auto& ports = component_.events;
        auto found = std::ranges::find_if(ports, [&](const EventPort& port) { return port.outside == outside; });
        if (found == ports.end()) {
            EventPort port;
            port.outside = outside;
            port.model_name = component_.is_composed() ? outside : use.name;
            port.interface = use.interface;
            port.type = use.type;
            found = ports.insert(ports.end(), std::move(port));
        }
        found->received = found->received || use.received;
        found->sent = found->sent || use.sent;
        use.ports.push_back(static_cast<std::size_t>(found - ports.begin()));
    }

    /// Adds a buffer. At the writer's end of the connection, the event fills the buffer; at the reader's end, it
    /// empties the buffer.
    void add_buffer(EventUse& use, const ConnectionEnd& here, std::size_t connection) {
        assert(module_ != nullptr && connection < module_->connections.size());
        auto& buffers = component_.buffers;
        const auto same = [&](const Buffer& buffer) { return buffer.connection == connection; };
        auto found = std::ranges::find_if(buffers, same);
        if (found == buffers.end()) {
            const std::string& name = module_->connections[connection].from.event;
            found = buffers.insert(buffers.end(), {connection, name, use.type, ""});
        }
        const auto index = static_cast<std::size_t>(found - buffers.begin());
        (&here == &module_->connections[connection].from ? use.filled : use.emptied).push_back(index);
    }

    void report_unconnected(const Part& part, const EventUse& use, const char* why) {
        const std::string& where = part.name.empty() ? component_.name : part.name;
        diagnostics_.report(rules::unconnected, component_.origin.span, {where, use.name, why});
    }

    void check_connections(std::size_t index, const EventUse& use) {
        const Part& part = component_.parts[index];
        for (const Peer& peer : use.peers) {
            if (peer.part == index) report_unconnected(part, use, "connected to its own machine");
            const EventUse* const other = component_.find_event(peer);
            if (other != nullptr && other->type != use.type)
                report_unconnected(part, use, "connected to an event of another type");
        }
        if (use.received && use.is_spontaneous() && reads_value(index, use))
            report_unconnected(part, use, "not connected, and a condition reads its value");
    }

    /// Returns whether some condition depends on the value of the event.
    bool reads_value(std::size_t part, const EventUse& use) const {
        bool reads = false;
        const auto look = [&](const ir::ExprPtr& condition) {
            visit(condition, [&](const ir::Expr& expr) { reads |= expr.kind == ir::ExprKind::trigger_value; });
        };
        for (const Unit& unit : component_.units) {
            if (unit.part != part) continue;
            const auto is = [&](const ir::Communication& communication) {
                return unit.machine->events[communication.event.index].name == use.name;
            };
            for (const ir::Transition& transition : unit.machine->transitions)
                if (transition.trigger && is(*transition.trigger)) look(transition.guard);
            visit_communications(*unit.machine, [&](const ir::Communication& communication, bool) {
                if (is(communication) && communication.predicate) reads = true;
            });
        }
        return reads;
    }

    Component& component_;
    const ir::System& system_;
    const ir::Module* module_;
    const std::vector<const ir::Controller*>& contexts_;
    Diagnostics& diagnostics_;
};

}  // namespace

void wire_component(Component& component, const ir::System& system, const ir::Module* module,
                    const std::vector<const ir::Controller*>& contexts, Diagnostics& diagnostics) {
    Wiring(component, system, module, contexts, diagnostics).wire_parts();
}

}  // namespace robochart::cpp_emit
