// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/register_wiring.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "cpp_emit/plan/rules.hpp"

namespace robochart::cpp_emit {

namespace {

/// The registers of machines that one register of a controller or module represents.
using RegistersOfParts = std::vector<EventUse*>;

/// The registers of a controller.
struct RegisterBoundary {
    std::map<std::string, RegistersOfParts> inputs, outputs;
};

class RegisterWiring {
public:
    RegisterWiring(Component& component, const ir::Module* module, const std::vector<const ir::Controller*>& contexts,
                   diagnostics::Diagnostics& diagnostics)
        : component_(component), module_(module), contexts_(contexts), diagnostics_(diagnostics) {}

    void wire() {
        for (std::size_t part = 0; part < component_.parts.size(); ++part) collect_registers(part);
        if (contexts_.front() == nullptr) return wire_machine();
        std::vector<RegisterBoundary> boundaries;
        const std::size_t controllers = module_ == nullptr ? 1 : module_->controllers.size();
        for (std::size_t i = 0; i < controllers; ++i) boundaries.push_back(boundary_of(i));
        if (module_ == nullptr) return add_ports(boundaries.front());
        add_ports(boundary_of_module(boundaries));
    }

private:
    /// Collects the registers of the part: the events of its machine's contexts. The machine's operations use some of
    /// these.
    void collect_registers(std::size_t part) {
        const ir::Machine& machine = *component_.root_unit(part).machine;
        std::vector<EventUse>& uses = component_.parts[part].events;
        const auto use_of = [&](const std::string& name) -> EventUse& {
            const auto found = std::ranges::find(uses, name, &EventUse::name);
            if (found != uses.end()) return *found;
            uses.emplace_back();
            uses.back().name = name;
            return uses.back();
        };
        for (const ir::Input& input : machine.inputs) {
            if (!input.full.is_valid()) continue;
            EventUse& use = use_of(input.name);
            use.received = true;
            if (input.content.is_valid()) use.type = machine.variables[input.content.index].type;
        }
        for (const ir::Event& event : machine.events) {
            EventUse& use = use_of(event.name);
            use.sent = true;
            use.interface = event.interface;
            use.type = event.type;
            use.once = part_name(part) + "own_" + event.name;
        }
    }

    [[nodiscard]] std::string part_name(std::size_t part) const {
        return component_.is_composed() ? component_.parts[part].name + "_" : "";
    }

    void wire_machine() {
        RegisterBoundary own;
        for (EventUse& use : component_.parts.front().events) {
            if (use.received) own.inputs[use.name].push_back(&use);
            if (use.sent) own.outputs[use.name].push_back(&use);
        }
        add_ports(own);
    }

    [[nodiscard]] EventUse* find_use(std::size_t controller, std::size_t machine, const std::string& event) {
        for (Part& part : component_.parts)
            if (part.controller == controller && part.machine == machine)
                for (EventUse& use : part.events)
                    if (use.name == event) return &use;
        return nullptr;
    }

    static bool is_event(const std::vector<ir::Event>& events, const std::string& name) {
        return std::ranges::find(events, name, &ir::Event::name) != events.end();
    }

    /// Adds the buffer for a connection between two parts, which are given by their registers. The connection may have
    /// either direction.
    void join(const RegistersOfParts& from_outputs, const RegistersOfParts& from_inputs,
              const RegistersOfParts& to_outputs, const RegistersOfParts& to_inputs, std::size_t connection) {
        if (!from_outputs.empty() && !to_inputs.empty()) return add_buffer(from_outputs, to_inputs, connection);
        if (!to_outputs.empty() && !from_inputs.empty()) add_buffer(to_outputs, from_inputs, connection);
    }

    /// Adds a buffer that all readers share. Several outputs may fill it.
    void add_buffer(const RegistersOfParts& writers, const RegistersOfParts& readers, std::size_t connection) {
        auto& buffers = component_.buffers;
        const EventUse& reader = *readers.front();
        const std::size_t buffer = reader.emptied.empty() ? buffers.size() : reader.emptied.front();
        if (buffer == buffers.size()) buffers.push_back({connection, reader.name, reader.type, ""});
        for (EventUse* use : readers)
            if (use->emptied.empty()) use->emptied.push_back(buffer);
        for (EventUse* use : writers) use->filled.push_back(buffer);
    }

    RegisterBoundary boundary_of(std::size_t index) {
        const auto part = std::ranges::find(component_.parts, index, &Part::controller);
        RegisterBoundary result;
        if (part == component_.parts.end()) return result;
        const ir::Controller& controller = *contexts_[static_cast<std::size_t>(part - component_.parts.begin())];
        std::set<std::string> connected;
        for (const ir::Connection& connection : controller.connections) {
            EventUse* const from = use_at(index, connection.from);
            EventUse* const to = use_at(index, connection.to);
            const auto one = [](EventUse* use, bool has) {
                return use != nullptr && has ? RegistersOfParts{use} : RegistersOfParts{};
            };
            if (from != nullptr && to != nullptr) {
                join(one(from, from->sent), one(from, from->received), one(to, to->sent), one(to, to->received), 0);
                continue;
            }
            const bool outwards = connection.from.kind == ir::EndKind::part;
            EventUse* const use = outwards ? from : to;
            const std::string& own = outwards ? connection.to.event : connection.from.event;
            if (!is_event(controller.events, own)) continue;
            connected.insert(own);
            if (use == nullptr) continue;
            if (use->received && (!outwards || !use->sent))
                result.inputs[own].push_back(use);
            else if (use->sent)
                result.outputs[own].push_back(use);
        }
        for (const ir::Event& event : controller.events)
            if (!connected.contains(event.name) && is_input_somewhere(index, event.name)) result.inputs[event.name];
        const std::string name = module_ == nullptr ? "" : module_->controllers[index].name + "_";
        for (auto& [own, uses] : result.outputs)
            for (EventUse* use : uses) use->once = name + "by_" + own;
        return result;
    }

    [[nodiscard]] EventUse* use_at(std::size_t controller, const ir::ConnectionEnd& end) {
        return end.kind == ir::EndKind::part ? find_use(controller, end.part, end.event) : nullptr;
    }

    /// Returns whether some part has an input with this name. If so, an event that no connection names is an input.
    [[nodiscard]] bool is_input_somewhere(std::size_t controller, const std::string& name) const {
        return std::ranges::any_of(component_.parts, [&](const Part& part) {
            return part.controller == controller && std::ranges::any_of(part.events, [&](const EventUse& use) {
                       return use.name == name && use.received;
                   });
        });
    }

    RegisterBoundary boundary_of_module(const std::vector<RegisterBoundary>& parts) {
        RegisterBoundary result;
        std::set<std::string> connected;
        const auto uses_of = [](const std::map<std::string, RegistersOfParts>& registers, const std::string& name) {
            const auto found = registers.find(name);
            return found == registers.end() ? RegistersOfParts() : found->second;
        };
        for (std::size_t index = 0; index < module_->connections.size(); ++index) {
            const ir::Connection& connection = module_->connections[index];
            const bool from = connection.from.kind == ir::EndKind::part, to = connection.to.kind == ir::EndKind::part;
            if (!from && !to) continue;
            if (from && to) {
                const RegisterBoundary &a = parts[connection.from.part], &b = parts[connection.to.part];
                join(uses_of(a.outputs, connection.from.event), uses_of(a.inputs, connection.from.event),
                     uses_of(b.outputs, connection.to.event), uses_of(b.inputs, connection.to.event), index);
                continue;
            }
            const RegisterBoundary& part = parts[from ? connection.from.part : connection.to.part];
            const std::string& event = from ? connection.from.event : connection.to.event;
            const std::string& own = from ? connection.to.event : connection.from.event;
            if (!is_event(module_->platform.events, own)) continue;
            connected.insert(own);
            const bool output = part.outputs.contains(event);
            if (part.inputs.contains(event) && (!from || !output))
                add_all(result.inputs[own], part.inputs.at(event));
            else if (output)
                add_all(result.outputs[own], part.outputs.at(event));
        }
        for (const ir::Event& event : module_->platform.events) {
            const auto reads = [&](const RegisterBoundary& part) { return part.inputs.contains(event.name); };
            if (!connected.contains(event.name) && std::ranges::any_of(parts, reads)) result.inputs[event.name];
        }
        return result;
    }

    static void add_all(RegistersOfParts& list, const RegistersOfParts& more) {
        list.insert(list.end(), more.begin(), more.end());
    }

    /// Returns the event of the component or of its platform with this name.
    [[nodiscard]] const ir::Event* declared_event(const std::string& name) const {
        if (contexts_.front() == nullptr) return nullptr;
        const std::vector<ir::Event>& events =
            module_ == nullptr ? contexts_.front()->events : module_->platform.events;
        const auto found = std::ranges::find(events, name, &ir::Event::name);
        return found == events.end() ? nullptr : &*found;
    }

    void add_ports(const RegisterBoundary& own) {
        for (const auto& [name, uses] : own.inputs) {
            const std::size_t port = port_of(name, uses);
            component_.events[port].received = true;
            for (EventUse* use : uses) use->ports.push_back(port);
        }
        for (const auto& [name, uses] : own.outputs) {
            const std::size_t port = port_of(name, uses);
            component_.events[port].sent = true;
            for (EventUse* use : uses) use->outlets.push_back(port);
        }
        for (const Part& part : component_.parts)
            std::ranges::for_each(part.events, [&](const EventUse& use) { check_use(part, use); });
    }

    std::size_t port_of(const std::string& name, const RegistersOfParts& uses) {
        auto& ports = component_.events;
        const auto known = std::ranges::find(ports, name, &EventPort::outside);
        if (known != ports.end()) return static_cast<std::size_t>(known - ports.begin());
        EventPort port;
        port.outside = port.model_name = name;
        if (const ir::Event* declared = declared_event(name)) {
            port.interface = declared->interface;
            port.type = declared->type;
        } else {
            port.interface = uses.front()->interface;
            port.type = uses.front()->type;
        }
        ports.push_back(std::move(port));
        return ports.size() - 1;
    }

    void check_use(const Part& part, const EventUse& use) {
        const auto refuse = [&](const char* why) {
            diagnostics_.report(rules::unconnected, component_.origin.span,
                                {part.name.empty() ? component_.name : part.name, use.name, why});
        };
        if (use.ports.size() + use.emptied.size() > 1) refuse("has two sources");
        if (use.outlets.size() > 1) refuse("leads to two outputs");
        const auto differs = [&](std::size_t port) { return component_.events[port].type != use.type; };
        const auto unlike = [&](std::size_t buffer) { return component_.buffers[buffer].type != use.type; };
        if (std::ranges::any_of(use.ports, differs) || std::ranges::any_of(use.outlets, differs) ||
            std::ranges::any_of(use.emptied, unlike) || std::ranges::any_of(use.filled, unlike))
            refuse("is connected to an event of another type");
    }

    Component& component_;
    const ir::Module* module_;
    const std::vector<const ir::Controller*>& contexts_;
    diagnostics::Diagnostics& diagnostics_;
};

}  // namespace

void wire_registers(Component& component, const ir::Module* module, const std::vector<const ir::Controller*>& contexts,
                    diagnostics::Diagnostics& diagnostics) {
    RegisterWiring(component, module, contexts, diagnostics).wire();
}

}  // namespace robochart::cpp_emit
