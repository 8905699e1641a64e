// SPDX-License-Identifier: Apache-2.0
// The members that are visible in a component: its own and those of its interfaces (language reference 1.3).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// The members visible in a context. If a name is declared twice, the first declaration hides the second; own members
/// come first.
struct Scope {
    std::map<std::string_view, const Variable*> variables;  ///< constants and parameters too
    std::map<std::string_view, const Event*> events;
    std::map<std::string_view, const Clock*> clocks;
    std::map<std::string_view, const OperationSignature*> operations;
};

/// Members of a context whose interface clauses are resolved. The events of a RoboSim machine include those that its
/// contexts declare and use, because connections end at them.
[[nodiscard]] Scope scope_of(const Context& context);

/// The registers of a RoboSim machine, operation or simulation, which `$` names.
struct Registers {
    Scope inputs;   ///< events that the input context declares or uses; variables that it requires or uses
    Scope outputs;  ///< events, variables and operations of the output context
};
[[nodiscard]] Registers registers_of(const Context& owner);

/// The interface of a clause; null if it was not found.
[[nodiscard]] const Context* interface_of(const InterfaceClause& clause);
/// True if a clause of the context names an interface that was not found. The context may then have unknown members.
[[nodiscard]] bool has_unknown_interface(const Context& context);
/// The definition that a reference refers to, or null if it was not found. Other declarations are returned unchanged.
[[nodiscard]] const Declaration* follow_reference(const Declaration* declaration);
/// The definition that a reference refers to, if it has the requested kind; otherwise null.
template <class Kind>
[[nodiscard]] const Kind* follow_to(const Declaration* declaration) {
    return dynamic_cast<const Kind*>(follow_reference(declaration));
}
/// The machine, operation, function or interface that contains a declaration, or the declaration itself if it is one.
[[nodiscard]] const Declaration* component_around(const Declaration* declaration);

/// Own variables and those of used and required interfaces, in textual order.
[[nodiscard]] std::vector<const Variable*> visible_variables(const Context& context);
/// All variables of a platform: own ones and those of used and provided interfaces.
[[nodiscard]] std::vector<const Variable*> offered_variables(const Context& platform);
/// Variables and constants of required interfaces.
[[nodiscard]] std::vector<const Variable*> required_variables(const Context& context);
/// Operations of required interfaces.
[[nodiscard]] std::vector<const OperationSignature*> required_operations(const Context& context);
/// Operations of provided interfaces and own signatures.
[[nodiscard]] std::vector<const OperationSignature*> provided_operations(const Context& context);
/// Own events, those of its interfaces, and those that its contexts declare and use.
[[nodiscard]] std::vector<const Event*> visible_events(const Context& context);

/// The definitions of operations in a controller: inline ones and those that `opref` refers to.
[[nodiscard]] std::vector<const Machine*> defined_operations(const Component& controller);

}  // namespace robochart::frontend
