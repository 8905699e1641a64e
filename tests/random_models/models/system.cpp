// SPDX-License-Identifier: Apache-2.0
// Builds platforms, modules and their connections.
#include "tests/random_models/models/system.hpp"

#include <fmt/format.h>

namespace robochart::random_models {

void SystemBuilder::define(const std::string& text) {
    definitions_.push_back({text, random_.below(files_)});
}

/// Defines a component in place, or elsewhere with a reference. Returns its name in the component that contains it.
std::string SystemBuilder::place(Lines& out, const std::string& word, const std::string& name,
                                 const std::string& text) {
    if (!shape_.references || random_.chance(50)) {
        out.embed(text);
        return name;
    }
    define(text);
    const std::string reference = names_.unused_name("ref");
    out.line(fmt::format("{} {} = {}", word, reference, name));
    return reference;
}

void SystemBuilder::define_interface(const Shared& shared) {
    Lines out;
    out.open("interface " + shared.interface);
    for (const std::string& member : shared.members) out.line(member);
    out.close();
    define(out.text());
}

void SystemBuilder::declare_in_interface(Lines& out, const std::string& stem, const std::vector<std::string>& members) {
    Shared shared;
    shared.interface = names_.unused_name(stem);
    shared.members = members;
    define_interface(shared);
    out.line("uses " + shared.interface);
}

void SystemBuilder::offer(Lines& out, const std::string& word, const Shared& shared) {
    if (shared.interface.empty()) return;
    if (!shape_.varied_places || random_.chance(70)) return out.line(word + shared.interface);
    for (const std::string& member : shared.members) out.line(member);
}

void SystemBuilder::platform_interfaces() {
    if (shape_.shared_variables && random_.chance(40)) {
        Shared& shared = platform_variables_;
        shared.interface = names_.unused_name("PlatformData");
        for (std::size_t i = random_.between(1, 2); i > 0; --i) {
            const DataType* type = types_.existing_type();
            shared.variables.push_back({names_.unused_name("shared"), type, shared.interface});
            shared.members.push_back(fmt::format("var {} : {}", shared.variables.back().name, type->written));
        }
        if (shape_.varied_places && random_.chance(40)) {
            const DataType* type = types_.existing_type();
            shared.constants.push_back({names_.unused_name("fixed"), type, shared.interface});
            const std::string value = Expressions(random_, shape_, types_).literal(*type);
            shared.members.push_back(fmt::format("const {} : {} = {}", shared.constants[0].name, type->written, value));
        }
        define_interface(shared);
    }
    const std::size_t count = random_.between(shape_.platform_operations.low, shape_.platform_operations.high);
    if (count == 0) return;
    platform_operations_.interface = names_.unused_name("Services");
    for (std::size_t i = 0; i < count; ++i) {
        Signature signature{names_.unused_name("move"), {}, platform_operations_.interface};
        Surroundings inside;
        platform_operations_.members.push_back(signature.name + "(" + parameters(signature, inside) + ")");
        platform_operations_.operations.push_back(std::move(signature));
    }
    define_interface(platform_operations_);
}

/// Declares events in the component itself or in an interface that it uses.
void SystemBuilder::declare_ports(Lines& out, const std::vector<Port>& ports) {
    const bool in_interface = !ports.empty() && random_.chance(30);
    const std::string interface = in_interface ? names_.unused_name("Events") : "";
    Lines declared;
    if (in_interface) declared.open("interface " + interface);
    Lines& lines = in_interface ? declared : out;
    for (const Port& port : ports)
        lines.line((port.broadcast ? "_broadcast event " : "event ") + port.name +
                   (port.type != nullptr ? " : " + port.type->written : ""));
    if (!in_interface) return;
    declared.close();
    define(declared.text());
    out.line("uses " + interface);
}

std::string SystemBuilder::platform(const std::string& name, const std::vector<Port>& ports) {
    Lines out;
    out.open("robotic platform " + name);
    offer(out, "provides ", platform_variables_);
    offer(out, "provides ", platform_operations_);
    declare_ports(out, ports);
    out.close();
    return out.text();
}

/// Connects ports of the parts with each other or with the enclosing component. Returns the ports of the enclosing
/// component. Each port has at most one connection (C6, M3). Broadcasts are passed on from level to level (Cn4).
std::vector<Port> SystemBuilder::connect(std::vector<Part> parts, const std::string& outer, std::vector<Link>& links) {
    std::vector<Port> ports;
    const bool closed = shape_.varied_places && random_.chance(10);  // if true, no event leaves the component
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (Port& port : parts[i].ports) {
            if (port.name.empty()) continue;  // connected already
            Port* partner = nullptr;
            std::size_t owner = i + 1;
            for (; owner < parts.size() && partner == nullptr && !port.both_ways && !port.broadcast; ++owner)
                for (Port& other : parts[owner].ports)
                    if (!other.name.empty() && !other.both_ways && !other.broadcast && other.type == port.type &&
                        other.receives != port.receives)
                        partner = &other;
            if (partner != nullptr && random_.chance(60)) {
                const Part& there = parts[owner - 1];
                if (port.receives)
                    links.push_back({there.name, partner->name, parts[i].name, port.name, false, false});
                else
                    links.push_back({parts[i].name, port.name, there.name, partner->name, false, false});
                partner->name.clear();
                continue;
            }
            if (closed || (shape_.unconnected_events && random_.chance(8))) continue;
            ports.push_back({names_.local_name("e"), port.type, port.receives, port.both_ways, port.broadcast});
            const std::string& above = ports.back().name;
            if (port.receives)
                links.push_back({outer, above, parts[i].name, port.name, false, port.both_ways});
            else
                links.push_back({parts[i].name, port.name, outer, above, false, port.both_ways});
        }
    return ports;
}

void SystemBuilder::write(Lines& out, const std::vector<Link>& links, bool asynchronous, const std::string& outer) {
    for (const Link& link : links) {
        const bool with_platform = asynchronous && (link.from == outer || link.to == outer);
        const bool buffered = asynchronous && shape_.buffers && !with_platform && random_.chance(50);
        out.line(fmt::format("connection {} on {} to {} on {}{}{}", link.from, link.from_event, link.to, link.to_event,
                             with_platform || buffered ? " ( _async )" : "", link.both_ways ? " [ mult ]" : ""));
    }
}

System SystemBuilder::build() {
    for (std::size_t i = random_.below(6); i > 0; --i) types_.any_type();
    if (shape_.data.functions)
        for (std::size_t i = random_.below(3); i > 0; --i) types_.declare_function();
    types_.declare_generics();
    platform_interfaces();
    System system;
    system.module = names_.unused_name("Module");
    Lines parts;
    std::vector<Part> controllers;
    for (std::size_t i = random_.between(shape_.controllers.low, shape_.controllers.high); i > 0; --i)
        controllers.push_back(controller(parts));
    add_instance(parts, "cref", controllers);
    for (const Part& part : controllers) components_.insert(components_.begin(), part.name);
    const std::string platform_name = names_.unused_name("Robot");
    std::vector<Link> links;
    const std::string marker = "the platform";  // replaced by the platform's name once it is known
    names_.begin_component();
    const std::vector<Port> ports = connect(controllers, marker, links);
    Lines module;
    module.open("module " + system.module);
    const std::string outer = place(module, "rref", platform_name, platform(platform_name, ports));
    for (Link& link : links) {
        if (link.from == marker) link.from = outer;
        if (link.to == marker) link.to = outer;
    }
    module.embed(parts.text());
    write(module, links, true, outer);
    module.close();
    define(module.text());
    for (const std::string& text : types_.declarations()) define(text);
    system.definitions = std::move(definitions_);
    system.components = std::move(components_);
    return system;
}

}  // namespace robochart::random_models
