// SPDX-License-Identifier: Apache-2.0
// What a state machine of RoboChart, with the operations that it calls, reads and writes: the registers of the RoboSim
// machine that runs it in cycles.
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
    /// The definition of an operation; null if the platform implements the operation.
    [[nodiscard]] const Machine* definition(std::string_view operation) const;
    /// The role of a variable or constant in the machine or in an operation that it calls.
    [[nodiscard]] VariableRole role(const Machine& where, const Variable& variable) const;
    /// The variable with this name that the calling machine itself has. `name` is the name of a variable that an
    /// operation requires.
    [[nodiscard]] const Variable* variable_of_root(std::string_view name) const;

private:
    const Machine* root_;
    std::vector<const Machine*> definitions_;
};

/// Names, in alphabetical order, with their declarations.
struct Usage {
    std::map<std::string, const Event*> inputs, outputs;
    std::map<std::string, const Variable*> read, written;  ///< registers
    std::map<std::string, const Variable*> constants;      ///< VariableRole::constant
    std::map<std::string, const OperationSignature*> platform, software;
};
/// Usage of a machine or operation, with the operations that it calls.
[[nodiscard]] Usage usage_of(const Machine&, const Callers&);

/// True for `e?x` as a statement or trigger, and for `e` and `e.v` as a trigger.
[[nodiscard]] bool is_input(const Communication& communication, bool trigger);

/// The variable on the left side of an assignment; null if it was not found.
[[nodiscard]] const Variable* assigned_variable(const Stmt& assignment);

}  // namespace robochart::frontend
