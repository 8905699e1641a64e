// SPDX-License-Identifier: Apache-2.0
// Seeds faults in statements.
#pragma once

#include "cpp_emit/faults/expression_faults.hpp"
#include "cpp_emit/plan/component.hpp"

namespace robochart::cpp_emit {

/// Rewrites the programs and communications of one machine.
class StatementFaults {
public:
    StatementFaults(const ir::System& system, const ir::Instantiation& inst, const Component& component,
                    const Unit& unit, Mutation& mutation)
        : system_(system),
          inst_(inst),
          component_(component),
          unit_(unit),
          mutation_(mutation),
          expressions_(system, inst, mutation) {}

    /// Returns the statement with the fault, or null for null. Parts are rewritten before the whole.
    [[nodiscard]] ir::StmtPtr rewrite(const ir::StmtPtr&);
    /// Rewrites a trigger or the communication of an input statement.
    void rewrite_reception(ir::Communication&);
    /// Rewrites the deadline of a statement or transition. This function does not handle the fault that ignores a
    /// deadline.
    [[nodiscard]] ir::ExprPtr rewrite_bound(const ir::ExprPtr& bound);
    /// Returns a program that runs the given one a second time, one time unit after it has ended.
    [[nodiscard]] ir::StmtPtr run_again(const ir::StmtPtr&) const;
    [[nodiscard]] ExpressionFaults& expressions() { return expressions_; }
    /// Returns whether resetting the clock has any effect.
    [[nodiscard]] bool has_effect(ir::ClockId) const;

private:
    void rewrite_parts(ir::Stmt&);
    void rewrite_path(ir::Stmt&);
    [[nodiscard]] ir::StmtPtr apply_fault(const ir::Stmt&);
    [[nodiscard]] ir::StmtPtr rewrite_sequence(ir::Stmt);
    [[nodiscard]] ir::StmtPtr rewrite_branches(ir::Stmt);
    [[nodiscard]] ir::StmtPtr rewrite_assignment(ir::Stmt);
    [[nodiscard]] ir::StmtPtr rewrite_communication(ir::Stmt);
    [[nodiscard]] ir::StmtPtr rewrite_call(ir::Stmt);
    [[nodiscard]] ir::StmtPtr rewrite_wait(ir::Stmt);
    [[nodiscard]] ir::StmtPtr deadline_statement(ir::Stmt);
    [[nodiscard]] ir::StmtPtr repeat_if_faulty(ir::Stmt);
    void exchange_arguments(ir::Stmt&);
    [[nodiscard]] ir::EventId other_event(ir::EventId, bool received) const;
    [[nodiscard]] ir::OperationId other_operation(ir::OperationId) const;

    const ir::System& system_;
    const ir::Instantiation& inst_;
    const Component& component_;
    const Unit& unit_;
    Mutation& mutation_;
    ExpressionFaults expressions_;
};

}  // namespace robochart::cpp_emit
