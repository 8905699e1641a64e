// SPDX-License-Identifier: Apache-2.0
// Builds controllers and machines.
#include <fmt/format.h>

#include <set>

#include "tests/random_models/models/system.hpp"

namespace robochart::random_models {

std::string SystemBuilder::parameters(Signature& signature, Surroundings& around) {
    std::string text;
    for (std::size_t i = random_.below(3); i > 0; --i) {
        const DataType* type = types_.existing_type();
        signature.parameters.push_back(type);
        around.readable.push_back({names_.local_name("p"), type});
        text += fmt::format("{}{} : {}", text.empty() ? "" : ", ", around.readable.back().name, type->written);
    }
    return text;
}

void SystemBuilder::require(Lines& out, const Shared& shared, Surroundings& around) {
    if (shared.interface.empty()) return;
    out.line("requires " + shared.interface);
    for (const Named& variable : shared.variables) {
        around.readable.push_back(variable);
        around.writable.push_back(variable);
    }
    around.readable.insert(around.readable.end(), shared.constants.begin(), shared.constants.end());
    around.clocks.insert(around.clocks.end(), shared.clocks.begin(), shared.clocks.end());
    around.operations.insert(around.operations.end(), shared.operations.begin(), shared.operations.end());
}

/// Declares constants, variables and clocks of a machine or operation.
void SystemBuilder::declare_data(Lines& out, Surroundings& around) {
    Expressions values(random_, shape_, types_);
    for (std::size_t i = random_.between(shape_.constants.low, shape_.constants.high); i > 0; --i) {
        const DataType* type = types_.existing_type();
        const std::string name = names_.local_name("c");
        const bool open = shape_.open_constants && random_.chance(30);
        const std::string written =
            fmt::format("const {} : {}{}", name, type->written, open ? "" : " = " + values.literal(*type));
        if (shape_.varied_places && random_.chance(20))
            declare_in_interface(out, "Constants", {written});
        else
            out.line(written);
        around.readable.push_back({name, type});
    }
    for (std::size_t i = random_.between(shape_.variables.low, shape_.variables.high); i > 0; --i) {
        const DataType* type = types_.existing_type();
        const std::string name = names_.local_name("v");
        const bool initialised = random_.chance(50);
        out.line(fmt::format("var {} : {}{}", name, type->written, initialised ? " = " + values.literal(*type) : ""));
        around.readable.push_back({name, type});
        around.writable.push_back({name, type});
    }
    if (shape_.probabilistic && shape_.chance_expressions && random_.chance(50)) {
        around.chance = names_.local_name("q");
        out.line(fmt::format("const {} : real = 0.25", around.chance));
    }
    if (!shape_.time) return;
    for (std::size_t i = random_.between(shape_.clocks.low, shape_.clocks.high); i > 0; --i) {
        around.clocks.push_back(names_.local_name("T"));
        if (shape_.varied_places && random_.chance(20))
            declare_in_interface(out, "Clocks", {"clock " + around.clocks.back()});
        else
            out.line("clock " + around.clocks.back());
    }
}

std::vector<Port> SystemBuilder::make_ports() {
    std::vector<Port> ports;
    for (std::size_t i = random_.between(shape_.events.low, shape_.events.high); i > 0; --i)
        ports.push_back(make_port(names_.local_name("e")));
    return ports;
}

Port SystemBuilder::make_port(const std::string& name) {
    const bool typed = shape_.typed_events && random_.chance(40);
    const DataType* type = typed ? types_.existing_type() : nullptr;
    const bool receives = random_.chance(55);
    const bool both_ways = shape_.bidirectional && random_.chance(5);
    const bool broadcast = shape_.broadcast && random_.chance(10);
    return {name, type, receives, both_ways, broadcast};
}

/// Declares variables for received values, which typed triggers need.
void SystemBuilder::declare_places(Lines& out, Surroundings& around) {
    for (const Port& port : around.ports)
        if (port.type != nullptr) {
            const std::string place = names_.local_name("x");
            out.line(fmt::format("var {} : {}", place, port.type->written));
            around.readable.push_back({place, port.type});
            around.writable.push_back({place, port.type});
        }
}

SystemBuilder::Part SystemBuilder::machine(Lines& out, const Shared& variables, const Callable& operations) {
    const std::string name = names_.unused_name("Machine");
    names_.begin_component();
    Surroundings around;
    Lines text;
    text.open("stm " + name);
    std::set<std::string> supplied;
    for (const Shared& need : call_some(text, operations, around)) {
        supplied.insert(need.interface);
        const bool offered = need.interface == variables.interface || need.interface == platform_variables_.interface;
        if (offered && random_.chance(70))
            require(text, need, around);
        else
            declare_own(text, need, around);
    }
    if (!supplied.contains(variables.interface) && random_.chance(50)) require(text, variables, around);
    if (random_.chance(60)) require(text, platform_operations_, around);
    if (!supplied.contains(platform_variables_.interface) && random_.chance(50))
        require(text, platform_variables_, around);
    declare_data(text, around);
    for (const Port& port : make_ports()) around.ports.push_back(port);
    declare_places(text, around);
    declare_ports(text, around.ports);
    Behaviour(random_, shape_, names_, types_, around).container(text, shape_.depth, false);
    text.close();
    const std::string known = place(out, "sref", name, text.text());
    return {known, name, around.ports};
}

/// Declares variables of a controller that its machines can require.
SystemBuilder::Shared SystemBuilder::controller_variables(Lines& out) {
    Shared shared;
    if (!shape_.shared_variables || random_.chance(60)) return shared;
    shared.interface = names_.unused_name("Data");
    for (std::size_t i = random_.between(1, 2); i > 0; --i) {
        const DataType* type = types_.existing_type();
        shared.variables.push_back({names_.unused_name("d"), type, shared.interface});
        shared.members.push_back(fmt::format("var {} : {}", shared.variables.back().name, type->written));
    }
    define_interface(shared);
    offer(out, "uses ", shared);
    return shared;
}

/// Adds a second reference to a component that is already referenced here.
void SystemBuilder::add_instance(Lines& out, const std::string& word, std::vector<Part>& parts) {
    if (!shape_.instances || !random_.chance(30)) return;
    for (const Part& part : parts) {
        if (part.definition == part.name) continue;
        Part again = part;
        again.name = names_.unused_name("ref");
        out.line(fmt::format("{} {} = {}", word, again.name, again.definition));
        parts.push_back(std::move(again));
        return;
    }
}

SystemBuilder::Part SystemBuilder::controller(Lines& module) {
    const std::string name = names_.unused_name("Controller");
    Lines text;
    text.open("controller " + name);
    if (!platform_variables_.interface.empty()) text.line("requires " + platform_variables_.interface);
    if (!platform_operations_.interface.empty()) text.line("requires " + platform_operations_.interface);
    const Shared variables = controller_variables(text);
    Lines inside;
    const Callable operations = controller_operations(inside, variables);
    std::vector<Part> machines;
    for (std::size_t i = random_.between(std::max<std::size_t>(1, shape_.machines.low), shape_.machines.high); i > 0;
         --i)
        machines.push_back(machine(inside, variables, operations));
    std::vector<Link> links;
    add_instance(inside, "sref", machines);
    names_.begin_component();
    const std::vector<Port> ports = connect(machines, name, links);
    declare_ports(text, ports);
    text.embed(inside.text());
    write(text, links, false, name);
    text.close();
    const std::string known = place(module, "cref", name, text.text());
    for (const Part& part : machines) components_.push_back(known + "::" + part.name);
    return {known, name, ports};
}

}  // namespace robochart::random_models
