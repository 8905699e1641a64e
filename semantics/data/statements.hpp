// SPDX-License-Identifier: Apache-2.0
// Makes statements for a machine that the class model rewrites. Private to this component.
#pragma once

#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Makes statements of one machine and gives each of them a control point. Control points are numbered in the order of
/// creation.
class StatementMaker {
public:
    /// The machine must outlive the object.
    explicit StatementMaker(Machine& machine) : machine_(machine) {}

    /// Returns the statement with a new control point.
    [[nodiscard]] StmtPtr make(Stmt stmt);
    /// Returns the sequence of these statements. If there is only one statement, returns this statement itself.
    [[nodiscard]] StmtPtr sequence_of(std::vector<StmtPtr> statements, const Origin& origin);
    [[nodiscard]] StmtPtr skip(const Origin& origin);
    [[nodiscard]] StmtPtr assignment(VariableId variable, ExprPtr value, const Origin& origin);
    /// Returns an internal choice. Without alternatives, the thread blocks.
    [[nodiscard]] StmtPtr choice_of(std::vector<StmtPtr> alternatives, const Origin& origin);
    /// Returns an internal choice of the value that the variable gets.
    [[nodiscard]] StmtPtr choice_of_value(VariableId variable, const std::vector<ExprPtr>& values,
                                          const Origin& origin);
    [[nodiscard]] StmtPtr if_then_else(ExprPtr condition, StmtPtr then, StmtPtr otherwise, const Origin& origin);
    /// Adds a variable to the machine. Extends its name if another variable has this name.
    VariableId add_variable(std::string name, TypeId type, const Origin& origin);
    /// Returns an expression that reads the variable.
    [[nodiscard]] ExprPtr read(VariableId variable, diagnostics::Span span) const;

private:
    Machine& machine_;
};

}  // namespace robochart::ir
