// SPDX-License-Identifier: Apache-2.0
// Determines the members that are visible in a component: its own members and those of its interfaces (language
// reference 1.3).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// The members that are visible in a context. A context's own members come before those of interfaces. If two
/// declarations have the same name, the first hides the second.
struct Scope {
    std::map<std::string_view, const Variable*> variables;  ///< constants and parameters too
    std::map<std::string_view, const Event*> events;
    std::map<std::string_view, const Clock*> clocks;
    std::map<std::string_view, const OperationSignature*> operations;
};

/// Returns the members of a context whose interface clauses are resolved. For a RoboSim machine, the result includes
/// the events that its contexts declare and use, because connections end at them.
[[nodiscard]] Scope scope_of(const Context& context);

/// The registers of a RoboSim machine, operation or simulation. Names after `$` refer to them.
struct Registers {
    Scope inputs;   ///< events that the input context declares or uses; variables that it requires or uses
    Scope outputs;  ///< events, variables and operations of the output context
};
[[nodiscard]] Registers registers_of(const Context& owner);

/// Returns the interface of a clause, or null if it was not found.
[[nodiscard]] const Context* interface_of(const InterfaceClause& clause);
/// True if a clause of the context names an interface that was not found. The context may then have unknown members.
[[nodiscard]] bool has_unknown_interface(const Context& context);
/// Returns the definition that a reference refers to, or null if it was not found. Other declarations are returned
/// unchanged.
[[nodiscard]] const Declaration* follow_reference(const Declaration* declaration);
/// Returns the definition that a reference refers to, if it has the requested kind, or null otherwise.
template <class Kind>
[[nodiscard]] const Kind* follow_to(const Declaration* declaration) {
    return dynamic_cast<const Kind*>(follow_reference(declaration));
}
/// Returns the machine, operation, function or interface that contains a declaration, or the declaration itself if it
/// is one.
[[nodiscard]] const Declaration* component_around(const Declaration* declaration);

/// Returns the variables of the context and of its used and required interfaces, in textual order.
[[nodiscard]] std::vector<const Variable*> visible_variables(const Context& context);
/// Returns all variables of a platform, including those of used and provided interfaces.
[[nodiscard]] std::vector<const Variable*> offered_variables(const Context& platform);
/// Returns the variables and constants of required interfaces.
[[nodiscard]] std::vector<const Variable*> required_variables(const Context& context);
/// Returns the operations of required interfaces.
[[nodiscard]] std::vector<const OperationSignature*> required_operations(const Context& context);
/// Returns the operations of provided interfaces, and the signatures that the context itself declares.
[[nodiscard]] std::vector<const OperationSignature*> provided_operations(const Context& context);
/// Returns the events of the context, of its interfaces, and of its input and output contexts.
[[nodiscard]] std::vector<const Event*> visible_events(const Context& context);

/// Returns the definitions of operations in a controller: inline definitions and those to which `opref` refers.
[[nodiscard]] std::vector<const Machine*> defined_operations(const Component& controller);

}  // namespace robochart::frontend
