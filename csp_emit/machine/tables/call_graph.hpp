// SPDX-License-Identifier: Apache-2.0
// Finds the operations that the machine calls, directly or indirectly, and that are defined in its context.
#pragma once

#include <string>
#include <vector>

#include "csp_emit/base/component.hpp"
#include "csp_emit/machine/tables/machine_context.hpp"

namespace robochart::csp_emit {

/// Owns the list of operations reached by calls, and the constants of the machine and of these operations (semantics
/// 3.12).
class CallGraph {
public:
    /// Reserves names for the constants in the context.
    explicit CallGraph(MachineContext&);

    /// Returns the definition of an operation that a machine calls, or null if the context has none, in which case the
    /// call is an event.
    [[nodiscard]] const ir::Machine* find_definition(const ir::Machine& caller, ir::OperationId) const;
    /// Returns the operations that the machine calls, directly or indirectly.
    [[nodiscard]] std::vector<const ir::Machine*> callable_operations() const;
    /// Returns a cycle of calls that contains both operations, such as `o -> p -> o`, or "" if the called operation
    /// cannot call its caller.
    [[nodiscard]] std::string describe_recursion(const ir::Machine& caller, const ir::Machine& operation) const;

    /// Returns the machine's constants in order of declaration, then those of the operations that it calls.
    [[nodiscard]] const std::vector<ConstantParameter>& constants() const { return constants_; }
    /// Returns the names of these constants as parameters of the machine's functions.
    [[nodiscard]] std::vector<std::string> constants_inside() const;

private:
    void collect_calls(const ir::Machine& owner, NameManager& names);

    const MachineContext& context_;
    std::vector<const ir::Machine*> reached_;
    std::vector<ConstantParameter> constants_;
    bool recursive_ = false;  ///< some operation may call itself
};

}  // namespace robochart::csp_emit
