// SPDX-License-Identifier: Apache-2.0
// Lowers state machines and operations, and the declarations of every kind of context. Private to semantics/lower*.
#pragma once

#include "semantics/lower/expressions.hpp"

namespace robochart::ir {

/// The declarations of a context in order: first its own, then those of each interface.
struct Declarations {
    std::vector<Variable> variables;
    std::vector<Constant> constants;
    std::vector<Event> events;
    std::vector<Clock> clocks;
    std::vector<OperationSignature> operations;
    std::vector<std::string> interfaces;
    Names names;
};
[[nodiscard]] Declarations lower_declarations(Lowering&, const frontend::Context&, const std::string& path,
                                              const std::vector<frontend::VariablePtr>* parameters = nullptr);

/// Fills a machine that is already registered (its name, package and path are set).
void lower_machine(Lowering&, const frontend::Machine&, MachineId);

}  // namespace robochart::ir
