// From configurations to functions: the rules are followed from the initial configuration, and each configuration that
// does not go on at once gets a function, whose body is the external choice of its branches.
//
// What needs no event is done at once by changing arguments (`at`); what does is a branch (`branches`). A step is an
// event of its own, hidden, wherever something else could happen between it and its neighbours: external writes to
// required variables, other threads, and the transitions that may cut a during action.
#pragma once

#include <optional>
#include <vector>

#include "csp_emit/machine/rules/next.hpp"
#include "csp_emit/machine/tables/machine_tables.hpp"

namespace robochart::csp_emit {

/// Owns only the depth of the present recursion.
class Processes {
public:
    explicit Processes(MachineTables&);

    /// The machine's process at its start.
    [[nodiscard]] cspm::ExprPtr initial();
    /// The functions of all points reachable from the initial one, in their order, then those behind shared calls:
    /// points and places to return to are found while bodies are made. Calls between them are sparse (liveness.hpp).
    [[nodiscard]] std::vector<Function> all();

private:
    cspm::ExprPtr at(const Activation& config, const Values& values);
    cspm::ExprPtr point(const Activation& config, const Values& values);
    cspm::ExprPtr of(const Next&);
    cspm::ExprPtr of(const Branch&);
    void add(const std::vector<Branch>& branches, std::vector<cspm::ExprPtr>& out);
    cspm::ExprPtr body(const Activation& config);
    cspm::ExprPtr behind(const Continuation&);
    std::vector<cspm::ExprPtr> branches(const Activation& config);
    cspm::ExprPtr choice(const Activation& config);
    std::vector<cspm::ExprPtr> reading_branches(const Activation& config, const View& now, CellId clock);
    bool returns(const Activation& config) const;

    MachineTables& tables_;
    std::size_t run_ = 0;           ///< statements done at once so far
    std::size_t branching_ = 0;     ///< conditionals around the present one
    bool after_tock_ = false;       ///< the branch of a tock is being made
    std::optional<CellId> passed_;  ///< MachineContext::offered: 1 where the point has said whether it is within
    bool passing_ = false;          ///< the call is being made that says so
};

}  // namespace robochart::csp_emit
