// SPDX-License-Identifier: Apache-2.0
// Plans the classes that users of the generated code see, after Li et al. 2017, "Simulation and deployment". An
// interface becomes a class with variables as members, events as flags, and operations as methods to override. A
// machine becomes a class that inherits these, with states as an enumeration, a timer for each clock, and
// MakeTransition. All behaviour is in the core.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/files/files.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// A method of an interface class.
struct ApiOperation {
    const ir::OperationSignature* signature = nullptr;
    std::string method;       ///< name in the class
    std::string core_method;  ///< name in the core's platform
    bool modelled = false;    ///< the model defines the operation, so users need not override it
};

/// A received or sent event: a flag, and a value if the event carries one.
struct ApiEvent {
    const EventPort* port = nullptr;
    std::string flag;
    std::string value;
    bool sent = false;
    /// For a received event: the method that raises it. For a sent event: the method that the controller calls.
    std::string method;
};

struct ApiVariable {
    const StoredVariable* stored = nullptr;
    std::string member;
    std::vector<std::string> copies;  ///< members of State in which other machines store the variable; the class also
                                      ///< writes them
};

/// A class made from an interface. If `interface` is "", the machine's own members.
struct ApiClass {
    std::string interface;
    std::string cpp_name;
    std::vector<ApiVariable> variables;
    std::vector<ApiEvent> events;
    std::vector<ApiOperation> operations;
};

struct ApiTimer {
    std::string member;
    std::string field;  ///< member of the core's state
    const ir::Clock* clock = nullptr;
};

/// The members of the class that show the state of one machine of the component.
struct ApiMachine {
    std::string method;               ///< "state"; for several machines "state_stm0"
    std::string enumeration;          ///< "States"
    std::string place;                ///< member of the core's state: "at", "stm0.at"
    std::size_t unit = 0;             ///< index into Component::units
    std::vector<std::string> states;  ///< enumerators by node; "" for nodes that are not states
};

/// A function that the model specifies only by a contract.
struct ApiFunction {
    const FunctionHook* hook = nullptr;
    std::string method;
};

struct ClassApi {
    std::string name_space;
    std::string cpp_name;         ///< name in the machine's class
    std::vector<ApiClass> bases;  ///< interfaces, in textual order
    ApiClass own;
    std::vector<ApiTimer> timers;
    std::vector<ApiMachine> machines;
    std::vector<ApiFunction> functions;
};

/// Calls `visit` for the public parts of each interface of the class, and then for the class's own parts.
template <class Visit>
void each_class(const ClassApi& api, const Visit& visit) {
    for (const ApiClass& base : api.bases) visit(base);
    visit(api.own);
}

[[nodiscard]] ClassApi make_class_api(const Generation&);
[[nodiscard]] std::string interface_header(const Generation&, const Core&, const ClassApi&, const ApiClass&);
[[nodiscard]] std::string machine_header(const Generation&, const Core&, const ClassApi&);
[[nodiscard]] std::string machine_source(const Generation&, const Core&, const ClassApi&);
/// Returns a program that reads the inputs of each cycle from a line of text and prints the controller's outputs.
[[nodiscard]] std::string console_source(const Generation&, const Core&, const ClassApi&);
[[nodiscard]] std::string build_file(const ClassApi&);

/// Returns how types are written in the deployed code: double, std::int64_t, bool, or the name of a type in the core.
/// `core` is how the user's namespace refers to the core's namespace.
[[nodiscard]] Spelling deployed_spelling(const std::string& core);
[[nodiscard]] std::string deployed_type(const Generation&, const std::string& core, ir::TypeId);
/// Returns the C++ text of a value in the deployed types: `-0.75`, `3`, `true`, `core::Light::Red`.
[[nodiscard]] std::string deployed_value(const Generation&, const Core&, ir::TypeId, const ir::Value&);

/// Returns the name, with a suffix if the class already has a member with this name.
[[nodiscard]] std::string free_member(const ClassApi&, std::string name);

}  // namespace robochart::cpp_emit
