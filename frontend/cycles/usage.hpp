// SPDX-License-Identifier: Apache-2.0
// Computes what a RoboChart state machine and the operations that it calls read and write. The RoboSim machine that
// runs it in cycles needs registers for these.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// A construct that has no equal in RoboSim.
class NoCyclicForm : public std::runtime_error {
public:
    NoCyclicForm(Span span, const std::string& construct, const std::string& reason)
        : std::runtime_error(reason), span_(span), construct_(construct) {}
    [[nodiscard]] Span span() const { return span_; }
    [[nodiscard]] const std::string& construct() const { return construct_; }

private:
    Span span_;
    std::string construct_;
};

/// Where the value of a variable or constant is stored.
enum class VariableRole {
    own,       ///< in the machine or operation itself
    callers,   ///< in the machine that calls the operation
    shared,    ///< outside: a register
    constant,  ///< a constant that the component around the machine gives
};

/// A state machine and the definitions of the operations that it may call.
class Callers {
public:
    Callers(const Machine& root, std::vector<const Machine*> definitions)
        : root_(&root), definitions_(std::move(definitions)) {}

    [[nodiscard]] const Machine& root() const { return *root_; }
    /// Returns the definition of an operation, or null if the platform implements the operation.
    [[nodiscard]] const Machine* definition(std::string_view operation) const;
    /// Returns the role of a variable or constant in the machine or in an operation that it calls.
    [[nodiscard]] VariableRole role(const Machine& where, const Variable& variable) const;
    /// Returns the variable with this name that the calling machine itself has. `name` is the name of a variable that
    /// an operation requires.
    [[nodiscard]] const Variable* variable_of_root(std::string_view name) const;

private:
    const Machine* root_;
    std::vector<const Machine*> definitions_;
};

/// The registers and constants that a machine uses: names in alphabetical order, with their declarations.
struct Usage {
    std::map<std::string, const Event*> inputs, outputs;
    std::map<std::string, const Variable*> read, written;  ///< registers
    std::map<std::string, const Variable*> constants;      ///< VariableRole::constant
    std::map<std::string, const OperationSignature*> platform, software;
};
/// Returns the usage of a machine or operation, including the operations that it calls.
[[nodiscard]] Usage usage_of(const Machine&, const Callers&);

/// True if the communication receives: `e?x` in a statement or trigger, or `e` or `e.v` in a trigger.
[[nodiscard]] bool is_input(const Communication& communication, bool trigger);

/// Returns the variable on the left side of an assignment, or null if it was not found.
[[nodiscard]] const Variable* assigned_variable(const Stmt& assignment);

}  // namespace robochart::frontend
