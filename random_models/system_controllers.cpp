// Controllers, operations and machines. See system.hpp.
#include <fmt/format.h>

#include "random_models/system.hpp"

namespace robochart::random_models {

std::string SystemBuilder::parameters(Signature& signature, Surroundings& around) {
    std::string text;
    for (std::size_t i = random_.below(3); i > 0; --i) {
        const DataType* type = types_.existing();
        signature.parameters.push_back(type);
        around.readable.push_back({names_.fresh("p"), type});
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
    around.operations.insert(around.operations.end(), shared.operations.begin(), shared.operations.end());
}

/// Constants, variables and clocks of a machine or operation.
void SystemBuilder::declare_data(Lines& out, Surroundings& around) {
    Expressions values(random_, shape_, types_);
    for (std::size_t i = random_.between(shape_.constants.low, shape_.constants.high); i > 0; --i) {
        const DataType* type = types_.existing();
        const std::string name = names_.fresh("c");
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
        const DataType* type = types_.existing();
        const std::string name = names_.fresh("v");
        const bool initialised = random_.chance(50);
        out.line(fmt::format("var {} : {}{}", name, type->written, initialised ? " = " + values.literal(*type) : ""));
        around.readable.push_back({name, type});
        around.writable.push_back({name, type});
    }
    if (!shape_.time) return;
    for (std::size_t i = random_.between(shape_.clocks.low, shape_.clocks.high); i > 0; --i) {
        around.clocks.push_back(names_.fresh("T"));
        if (shape_.varied_places && random_.chance(20))
            declare_in_interface(out, "Clocks", {"clock " + around.clocks.back()});
        else
            out.line("clock " + around.clocks.back());
    }
}

std::vector<Port> SystemBuilder::make_ports() {
    std::vector<Port> ports;
    for (std::size_t i = random_.between(shape_.events.low, shape_.events.high); i > 0; --i)
        ports.push_back(make_port());
    return ports;
}

Port SystemBuilder::make_port() {
    const bool typed = shape_.typed_events && random_.chance(40);
    const DataType* type = typed ? types_.existing() : nullptr;
    const bool receives = random_.chance(55);
    const bool both_ways = shape_.bidirectional && random_.chance(5);
    const bool broadcast = shape_.broadcast && random_.chance(10);
    return {names_.fresh("e"), type, receives, both_ways, broadcast};
}

std::vector<Port> SystemBuilder::operation_ports() {
    std::vector<Port> ports;
    if (shape_.operation_events)
        while (random_.chance(30)) ports.push_back(make_port());
    return ports;
}

/// What a typed trigger receives needs a place.
void SystemBuilder::declare_places(Lines& out, Surroundings& around) {
    for (const Port& port : around.ports)
        if (port.type != nullptr) {
            const std::string place = names_.fresh("x");
            out.line(fmt::format("var {} : {}", place, port.type->written));
            around.readable.push_back({place, port.type});
            around.writable.push_back({place, port.type});
        }
}

SystemBuilder::Part SystemBuilder::machine(Lines& out, const Shared& variables, const Shared& operations) {
    const std::string name = names_.fresh("Machine");
    Surroundings around;
    Lines text;
    text.open("stm " + name);
    // An operation may need the controller's variables from its caller (STM8).
    const bool calls = random_.chance(70);
    if (calls) require(text, operations, around);
    if (calls || random_.chance(50)) require(text, variables, around);
    if (random_.chance(60)) require(text, platform_operations_, around);
    if (random_.chance(50)) require(text, platform_variables_, around);
    declare_data(text, around);
    around.ports = make_ports();
    // An operation communicates on the events of its caller (STM9).
    if (calls) around.ports.insert(around.ports.end(), operations.ports.begin(), operations.ports.end());
    declare_places(text, around);
    declare_ports(text, around.ports);
    Behaviour(random_, shape_, names_, types_, around).container(text, shape_.depth, false);
    text.close();
    return {place(out, "sref", name, text.text()), around.ports};
}

std::string SystemBuilder::operation(const Signature& signature, const std::string& parameters, Surroundings around,
                                     const Shared& variables) {
    Lines text;
    text.open(fmt::format("operation {}({})", signature.name, parameters));
    const bool contract = shape_.contracts && random_.chance(40);
    if (random_.chance(50)) require(text, variables, around);
    if (random_.chance(50)) require(text, platform_operations_, around);
    declare_data(text, around);
    declare_places(text, around);
    if (!around.ports.empty()) declare_ports(text, around.ports);
    Behaviour behaviour(random_, shape_, names_, types_, around);
    if (contract) {
        text.line("terminates");
        text.line("precondition " + behaviour.expressions().of(*types_.boolean()));
        text.line("postcondition " + behaviour.expressions().of(*types_.boolean()));
    }
    behaviour.container(text, shape_.depth > 0 ? shape_.depth - 1 : 0, true);
    text.close();
    return text.text();
}

/// Variables that a controller uses, for its machines to require.
SystemBuilder::Shared SystemBuilder::controller_variables(Lines& out) {
    Shared shared;
    if (!shape_.shared_variables || random_.chance(60)) return shared;
    shared.interface = names_.fresh("Data");
    for (std::size_t i = random_.between(1, 2); i > 0; --i) {
        const DataType* type = types_.existing();
        shared.variables.push_back({names_.fresh("d"), type, shared.interface});
        shared.members.push_back(fmt::format("var {} : {}", shared.variables.back().name, type->written));
    }
    define_interface(shared);
    offer(out, "uses ", shared);
    return shared;
}

/// Operations defined in a controller, with the interface through which its machines require them.
SystemBuilder::Shared SystemBuilder::controller_operations(Lines& out, const Shared& variables) {
    Shared shared;
    const std::size_t count = random_.between(shape_.defined_operations.low, shape_.defined_operations.high);
    if (count == 0) return shared;
    shared.interface = names_.fresh("Operations");
    Lines text;
    text.open("interface " + shared.interface);
    for (std::size_t i = 0; i < count; ++i) {
        Signature signature{names_.fresh("op"), {}, shared.interface};
        Surroundings inside;
        const std::string written = parameters(signature, inside);
        const bool terminates = shape_.contracts && random_.chance(20);
        text.line(fmt::format("{}({}){}", signature.name, written, terminates ? " [ terminates ]" : ""));
        if (shape_.bodiless_operations && random_.chance(15)) {
            place(out, "opref", signature.name, fmt::format("operation {}({}) {{\n}}\n", signature.name, written));
        } else {
            inside.ports = operation_ports();
            shared.ports.insert(shared.ports.end(), inside.ports.begin(), inside.ports.end());
            place(out, "opref", signature.name, operation(signature, written, inside, variables));
        }
        shared.operations.push_back(std::move(signature));
    }
    text.close();
    define(text.text());
    return shared;
}

SystemBuilder::Part SystemBuilder::controller(Lines& module) {
    const std::string name = names_.fresh("Controller");
    Lines text;
    text.open("controller " + name);
    if (!platform_variables_.interface.empty()) text.line("requires " + platform_variables_.interface);
    if (!platform_operations_.interface.empty()) text.line("requires " + platform_operations_.interface);
    const Shared variables = controller_variables(text);
    Lines inside;
    const Shared operations = controller_operations(inside, variables);
    std::vector<Part> machines;
    for (std::size_t i = random_.between(std::max<std::size_t>(1, shape_.machines.low), shape_.machines.high); i > 0;
         --i)
        machines.push_back(machine(inside, variables, operations));
    std::vector<Link> links;
    const std::vector<Port> ports = connect(machines, name, links);
    declare_ports(text, ports);
    text.embed(inside.text());
    write(text, links, false, name);
    text.close();
    const std::string known = place(module, "cref", name, text.text());
    for (const Part& part : machines) components_.push_back(known + "::" + part.name);
    return {known, ports};
}

}  // namespace robochart::random_models
