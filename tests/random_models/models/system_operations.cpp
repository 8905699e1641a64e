// SPDX-License-Identifier: Apache-2.0
// Builds the operations that controllers define: the operations that they call, and the variables and clocks that they
// access in their callers.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tests/random_models/models/system.hpp"

namespace robochart::random_models {

std::vector<Port> SystemBuilder::operation_ports() {
    std::vector<Port> ports;
    if (shape_.operation_events)
        while (random_.chance(30)) ports.push_back(make_port(names_.unused_name("oe")));
    return ports;
}

/// Declares variables, constants and clocks that only callers of operations provide.
SystemBuilder::Shared SystemBuilder::registers() {
    Shared shared;
    shared.interface = names_.unused_name("Registers");
    const bool clocks = shape_.time && random_.chance(40);
    for (std::size_t i = random_.between(clocks ? 0 : 1, 2); i > 0; --i) {
        const DataType* type = types_.existing_type();
        shared.variables.push_back({names_.unused_name("r"), type, shared.interface});
        shared.members.push_back(fmt::format("var {} : {}", shared.variables.back().name, type->written));
    }
    if (random_.chance(20)) {
        const DataType* type = types_.existing_type();
        shared.constants.push_back({names_.unused_name("k"), type, shared.interface});
        const std::string value = Expressions(random_, shape_, types_).literal(*type);
        shared.members.push_back(fmt::format("const {} : {} = {}", shared.constants[0].name, type->written, value));
    }
    if (clocks) {
        shared.clocks.push_back(names_.unused_name("TT"));
        shared.members.push_back("clock " + shared.clocks[0]);
    }
    define_interface(shared);
    return shared;
}

/// Returns the interfaces of variables and clocks that operations may require from their callers.
std::vector<SystemBuilder::Shared> SystemBuilder::sources(const Shared& variables) {
    std::vector<Shared> sources;
    if (!variables.interface.empty()) sources.push_back(variables);
    if (!shape_.nested_operations) return sources;
    if (!platform_variables_.interface.empty()) sources.push_back(platform_variables_);
    for (std::size_t i = random_.below(3); i > 0; --i) sources.push_back(registers());
    return sources;
}

std::vector<SystemBuilder::Shared> SystemBuilder::call_some(Lines& out, const Callable& callable,
                                                            Surroundings& around) {
    std::vector<Shared> needs;
    for (const Defined& defined : callable) {
        if (!random_.chance(70)) continue;
        require(out, defined.offer, around);
        for (const Port& port : defined.ports)
            if (std::ranges::none_of(around.ports, [&](const Port& known) { return known.name == port.name; }))
                around.ports.push_back(port);
        for (const Shared& need : defined.needs)
            if (std::ranges::none_of(needs, [&](const Shared& known) { return known.interface == need.interface; }))
                needs.push_back(need);
    }
    return needs;
}

/// Declares members of the interface in the caller, through the interface or directly.
void SystemBuilder::declare_own(Lines& out, const Shared& need, Surroundings& around) {
    if (random_.chance(40)) {
        out.line("uses " + need.interface);
    } else {
        Expressions values(random_, shape_, types_);
        for (const Named& variable : need.variables) {
            const std::string value = random_.chance(60) ? " = " + values.literal(*variable.type) : "";
            out.line(fmt::format("var {} : {}{}", variable.name, variable.type->written, value));
        }
        for (const Named& constant : need.constants)
            out.line(fmt::format("const {} : {} = {}", constant.name, constant.type->written,
                                 values.literal(*constant.type)));
        for (const std::string& clock : need.clocks) out.line("clock " + clock);
    }
    for (const Named& variable : need.variables) {
        around.readable.push_back({variable.name, variable.type});
        around.writable.push_back({variable.name, variable.type});
    }
    for (const Named& constant : need.constants) around.readable.push_back({constant.name, constant.type});
    around.clocks.insert(around.clocks.end(), need.clocks.begin(), need.clocks.end());
}

std::string SystemBuilder::operation(const Signature& signature, const std::string& parameters, Surroundings around,
                                     const Callable& callable, const std::vector<Shared>& sources, Defined& defined) {
    Lines text;
    text.open(fmt::format("operation {}({})", signature.name, parameters));
    const bool contract = shape_.contracts && random_.chance(40);
    around.ports = operation_ports();
    std::vector<Shared> needs = shape_.nested_operations ? call_some(text, callable, around) : std::vector<Shared>{};
    const auto is_needed = [&](const Shared& source) {
        return std::ranges::any_of(needs, [&](const Shared& need) { return need.interface == source.interface; });
    };
    const auto pass_on = [&](const Shared& need) {
        require(text, need, around);
        defined.needs.push_back(need);
    };
    for (const Shared& need : needs) {
        if (random_.chance(40))
            pass_on(need);
        else
            declare_own(text, need, around);
    }
    for (const Shared& source : sources)
        if (!is_needed(source) && random_.chance(50)) pass_on(source);
    if (random_.chance(50)) require(text, platform_operations_, around);
    defined.ports.insert(defined.ports.end(), around.ports.begin(), around.ports.end());
    declare_data(text, around);
    declare_places(text, around);
    if (!around.ports.empty()) declare_ports(text, around.ports);
    Behaviour behaviour(random_, shape_, names_, types_, around);
    if (contract) {
        text.line("terminates");
        text.line("precondition " + behaviour.expressions().expression_text(*types_.boolean()));
        text.line("postcondition " + behaviour.expressions().expression_text(*types_.boolean()));
    }
    behaviour.container(text, shape_.depth > 0 ? shape_.depth - 1 : 0, true);
    text.close();
    return text.text();
}

/// Defines operations in a controller. Its machines, and operations that are defined later, require them through
/// interfaces. There is one interface for all operations, or one for each if operations call others.
SystemBuilder::Callable SystemBuilder::controller_operations(Lines& out, const Shared& variables) {
    Callable callable;
    const std::size_t count = random_.between(shape_.defined_operations.low, shape_.defined_operations.high);
    if (count == 0) return callable;
    const std::vector<Shared> taken = sources(variables);
    for (std::size_t i = 0; i < count; ++i) {
        const bool apart = shape_.nested_operations || callable.empty();
        Defined defined = apart ? Defined{} : std::move(callable.back());
        if (apart)
            defined.offer.interface = names_.unused_name("Operations");
        else
            callable.pop_back();
        names_.begin_component();
        Signature signature{names_.unused_name("op"), {}, defined.offer.interface};
        Surroundings inside;
        const std::string written = parameters(signature, inside);
        const bool terminates = shape_.contracts && random_.chance(20);
        defined.offer.members.push_back(
            fmt::format("{}({}){}", signature.name, written, terminates ? " [ terminates ]" : ""));
        if (shape_.bodiless_operations && random_.chance(15))
            place(out, "opref", signature.name, fmt::format("operation {}({}) {{\n}}\n", signature.name, written));
        else
            place(out, "opref", signature.name, operation(signature, written, inside, callable, taken, defined));
        defined.offer.operations.push_back(std::move(signature));
        callable.push_back(std::move(defined));
    }
    for (const Defined& defined : callable) define_interface(defined.offer);
    return callable;
}

}  // namespace robochart::random_models
