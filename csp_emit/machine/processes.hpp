// SPDX-License-Identifier: Apache-2.0
// Converts configurations to functions, starting at the initial one. Each configuration that waits for an event gets a
// function. Its body is the external choice of the branches that the rules give.
//
// A step without an event is executed at once, by changing arguments. A step with an event is a branch. If something
// else could happen between a step and its neighbours, the step gets a hidden event. This can be a write of another
// component to a required variable, a step of another thread, or a transition that interrupts a during action.
#pragma once

#include <optional>
#include <vector>

#include "csp_emit/machine/rules/next.hpp"
#include "csp_emit/machine/tables/machine_tables.hpp"

namespace robochart::csp_emit {

/// The only state of the object is the depth of the current recursion.
class Processes {
public:
    explicit Processes(MachineTables&);

    /// Returns the machine's process at its start.
    [[nodiscard]] cspm::ExprPtr initial_process();
    /// Returns the functions of all points that are reachable from the initial point, in order. After them come the
    /// functions that continue after shared calls. While a body is made, further points and return points may be added.
    /// Calls between the functions are sparse (liveness.hpp).
    [[nodiscard]] std::vector<Function> make_functions();

private:
    cspm::ExprPtr process_at(const Activation& config, const Values& values);
    cspm::ExprPtr call_point(const Activation& config, const Values& values);
    cspm::ExprPtr to_process(const Next&);
    cspm::ExprPtr to_process(const Branch&);
    void add_branches(const std::vector<Branch>& branches, std::vector<cspm::ExprPtr>& out);
    cspm::ExprPtr body_of(const Activation& config);
    cspm::ExprPtr body_after_call(const Continuation&);
    std::vector<cspm::ExprPtr> make_branches(const Activation& config);
    cspm::ExprPtr choice_of_branches(const Activation& config);
    cspm::ExprPtr show_facts(const Activation& config, const std::vector<cspm::ExprPtr>& branches);
    MachineNames names_of_machine() const;
    std::vector<cspm::ExprPtr> reading_branches(const Activation& config, const View& now, CellId clock);
    bool returns_to_caller(const Activation& config) const;

    MachineTables& tables_;
    std::size_t run_ = 0;           ///< number of statements executed since the last function began
    std::size_t branching_ = 0;     ///< number of enclosing conditionals
    bool after_tock_ = false;       ///< the current branch is that of a tock
    std::optional<CellId> passed_;  ///< for MachineContext::offered and shown: 1 after the point has performed the
                                    ///< event that shows its facts
    bool passing_ = false;          ///< the call after that event of the point is being emitted
};

}  // namespace robochart::csp_emit
