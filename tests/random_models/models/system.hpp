// SPDX-License-Identifier: Apache-2.0
// Builds one module and all its components (private to the component). Decides which component provides, requires and
// connects what, by the rules for components and connections (language reference 2).
#pragma once

#include <string>
#include <vector>

#include "tests/random_models/models/behaviour.hpp"

namespace robochart::random_models {

/// A top-level definition, with the number of its file within the system.
struct Definition {
    std::string text;
    std::size_t file = 0;
};

/// The definitions of one module.
struct System {
    std::string module;
    std::vector<Definition> definitions;
    std::vector<std::string> components;  ///< paths of components, from the module down, that assertions may name
};

/// Builds one system.
class SystemBuilder {
public:
    SystemBuilder(Random& random, const Shape& shape, Names& names, std::size_t files)
        : random_(random), shape_(shape), names_(names), files_(files), types_(random, shape, names) {}
    System build();

private:
    /// The variables, clocks or operations that an interface declares. If the name is empty, there is no interface.
    struct Shared {
        std::string interface = {};
        std::vector<Named> variables = {};
        std::vector<Named> constants = {};
        std::vector<std::string> clocks = {};
        std::vector<std::string> members = {};  ///< texts of the declarations
        std::vector<Signature> operations = {};
    };
    /// The operations of one interface, with the requirements on their callers (STM8 to STM10).
    struct Defined {
        Shared offer;
        std::vector<Port> ports = {};
        std::vector<Shared> needs = {};
    };
    using Callable = std::vector<Defined>;
    /// A component from the point of view of the component that contains it.
    struct Part {
        std::string name;
        std::string definition;  ///< the component's name where it is defined in place
        std::vector<Port> ports;
    };
    struct Link {
        std::string from, from_event, to, to_event;
        bool async = false;
        bool both_ways = false;
    };

    // Platform and module (system.cpp).
    void define(const std::string& text);
    std::string place(Lines& out, const std::string& word, const std::string& name, const std::string& text);
    void platform_interfaces();
    /// Writes `provides I` or `uses I`, or the declarations of I.
    void offer(Lines& out, const std::string& word, const Shared& shared);
    void define_interface(const Shared& shared);
    void declare_in_interface(Lines& out, const std::string& stem, const std::vector<std::string>& members);
    std::string platform(const std::string& name, const std::vector<Port>& ports);
    void declare_ports(Lines& out, const std::vector<Port>& ports);
    std::vector<Port> connect(std::vector<Part> parts, const std::string& outer, std::vector<Link>& links);
    void write(Lines& out, const std::vector<Link>& links, bool asynchronous, const std::string& outer);

    // Controllers and machines (system_controllers.cpp).
    Part controller(Lines& module);
    Shared controller_variables(Lines& out);
    void add_instance(Lines& out, const std::string& word, std::vector<Part>& parts);
    void declare_places(Lines& out, Surroundings& around);
    Port make_port(const std::string& name);
    Part machine(Lines& out, const Shared& variables, const Callable& operations);
    std::vector<Port> make_ports();
    void declare_data(Lines& out, Surroundings& around);
    void require(Lines& out, const Shared& shared, Surroundings& around);
    std::string parameters(Signature& signature, Surroundings& around);

    // Operations (system_operations.cpp).
    Callable controller_operations(Lines& out, const Shared& variables);
    std::vector<Shared> sources(const Shared& variables);
    Shared registers();
    std::string operation(const Signature& signature, const std::string& parameters, Surroundings around,
                          const Callable& callable, const std::vector<Shared>& sources, Defined& defined);
    /// Requires some of the operations, and declares their events in the caller. Returns the requirements on the
    /// caller.
    std::vector<Shared> call_some(Lines& out, const Callable& callable, Surroundings& around);
    void declare_own(Lines& out, const Shared& need, Surroundings& around);
    std::vector<Port> operation_ports();

    Random& random_;
    const Shape& shape_;
    Names& names_;
    std::size_t files_;
    Types types_;
    std::vector<Definition> definitions_;
    std::vector<std::string> components_;
    Shared platform_variables_;
    Shared platform_operations_;
};

}  // namespace robochart::random_models
