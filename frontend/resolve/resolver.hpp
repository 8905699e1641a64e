// SPDX-License-Identifier: Apache-2.0
// Fills in the declaration of every name and every type (private to the front end).
#pragma once

#include "frontend/types/typer.hpp"

namespace robochart::frontend {

class Resolver {
public:
    Resolver(Model& model, Finder& finder) : model_(model), finder_(finder), typer_(finder) {}
    void run();

    // Resolves headers and bodies. The caller resolves first the headers of all files, then the bodies, then the
    // assertions.
    void resolve_headers(File& file) { visit_declarations(file, &Resolver::resolve_header); }
    void resolve_bodies(File& file) { visit_declarations(file, &Resolver::resolve_body); }
    void resolve_all_assertions();

private:
    // Declarations (resolver.cpp)
    void visit_declarations(File& file, void (Resolver::*visit)(File&, Declaration&));
    void each_part(File& file, Declaration& declaration, void (Resolver::*visit)(File&, Declaration&));
    void resolve_header(File& file, Declaration& declaration);
    void resolve_body(File& file, Declaration& declaration);
    void type_header(File& file, TypeDeclaration& type);
    void function_header(File& file, Function& function);
    void context_header(File& file, Context& context);
    void variable_type(Variable& variable, Surroundings& around);
    void parameter_types(std::vector<VariablePtr>& parameters, Surroundings& around);
    void resolve_references(File& file, Component& component);

    // Bodies (resolver_bodies.cpp)
    void function_body(File& file, Function& function);
    void context_body(File& file, Context& context);
    void machine_body(Machine& machine, Surroundings& around);
    void resolve_container(NodeContainer& container, const Machine& machine, Surroundings& around);
    /// The nodes of a container by name. If a name is declared twice, the map contains the first node.
    using NodeNames = std::map<std::string_view, const State*>;
    void resolve_transition(Transition& transition, const NodeNames& names, const Machine& machine,
                            Surroundings& around);
    const State* find_node(const QualifiedName& name, const Transition& transition, std::string_view role,
                           const NodeNames& names, const Machine& machine);
    void resolve_connections(Component& component);
    /// The components of a module or controller by name, and the scopes computed so far. The order of pointers is never
    /// used.
    struct Ends {
        const Component& component;
        std::map<std::string_view, const Declaration*> parts;
        std::map<const Context*, Scope> scopes;
    };
    void connection_end(Connection::End& end, Ends& ends);
    void connection_event(Connection::End& end, Ends& ends);
    void wrong_node(Connection::End& end, const Ends& ends);

    Model& model_;
    Finder& finder_;
    Typer typer_;
};

/// Resolves assertions and csp blocks: components along paths, states, clocks, constants (resolver_assertions.cpp).
/// Called after the declarations of all files are resolved.
void resolve_assertions(Model& model, Finder& finder, Typer& typer);
/// Resolves probabilistic assertions and the definitions that they use (resolver_probability.cpp). Called after the
/// declarations of all files are resolved.
void resolve_probabilistic(Model& model, Finder& finder, Typer& typer);

}  // namespace robochart::frontend
