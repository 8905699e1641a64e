// SPDX-License-Identifier: Apache-2.0
// Moves variables to separate memory processes in parallel with the machine's process, as in RoboTool's semantics
// (semantics 3.6). This is done for machines whose variables have too many combinations of values to be parameters of
// one process. The machine reads a variable with `get_x?x` before it evaluates the variable, and keeps the value only
// as long as it needs the value. It writes to the memory with `set_x` if the variable is shared, and with the hidden
// `setL_x` if it belongs to the machine.
//
// This preserves the meaning, because `get_x` is an inert step: it is hidden, always possible and never offered
// together with another event. No other write happens between `get_x` and the use of the value, since the machine takes
// part in all writes.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "csp_emit/passes/liveness.hpp"

namespace robochart::csp_emit {

/// A variable that a memory process holds.
struct Remembered {
    std::string parameter;  ///< name of the parameter of the machine's functions
    std::string channel;    ///< the name after `get_` and `setL_`
    std::string shared;     ///< for a shared variable: the name after `set_` and `set_EXT_`; otherwise empty
    cspm::ExprPtr type;     ///< the set of its values
    cspm::ExprPtr initial;
    std::string memory;   ///< the name of its process
    std::string meaning;  ///< its name in the model
};

/// Determines which functions evaluate the given parameters, directly or in arguments that they pass.
class Evaluations {
public:
    Evaluations(const std::vector<Function>& functions, const std::set<std::string>& parameters);
    /// Returns, for each function, the remembered variables that it holds. The sets are as small as possible: a call
    /// that changes a shared variable needs further variables only if the called function holds the shared variable.
    [[nodiscard]] std::vector<std::set<std::string>> held_variables(const std::vector<Remembered>& variables) const;

private:
    /// An argument of a call that changes the value of the parameter.
    struct Changed {
        std::size_t target;
        std::string parameter;
        std::set<std::string> names;
    };
    struct Use {
        std::set<std::string> names;  ///< names that occur outside calls of the family
        std::vector<Changed> changed;
    };
    void survey_expression(const cspm::Expr& expr, Use& use) const;
    void survey_call(const cspm::Expr& expr, std::size_t target, Use& use) const;
    void collect_mentions(const cspm::Expr& expr, std::set<std::string>& found) const;

    const std::vector<Function>& functions_;
    const std::set<std::string>& parameters_;
    FamilyIndex index_;
    /// For each function and parameter: true if the parameter is in `parameters_`.
    std::vector<std::vector<bool>> selected_;
    std::vector<Use> uses_;
};

/// Removes the remembered variables from the parameters of the functions, except for functions that evaluate them.
/// Termination becomes `end__ -> SKIP`, which also ends the memories. Precondition: every parameter is live
/// (find_parameters), and a shared variable changes only by its events.
void move_to_memories(std::vector<Function>& functions, cspm::ExprPtr& initial, const FamilyCalls& calls,
                      const std::vector<Remembered>& variables);

/// Returns the definitions of the memories: `M_x(v) = get_x!v -> M_x(v) [] setL_x?v -> M_x(v) [] ... [] end__ -> SKIP`.
[[nodiscard]] std::vector<cspm::DeclPtr> memory_definitions(const std::vector<Remembered>& variables, bool timed);
/// Returns the declarations `channel get_x, setL_x : T` for each variable, and that of `end__`.
[[nodiscard]] std::vector<cspm::DeclPtr> memory_channels(const std::vector<Remembered>& variables);
/// Returns the machine's process in parallel with its memories. Only the machine uses the memories' events.
[[nodiscard]] cspm::ExprPtr with_memories(const cspm::ExprPtr& machine, const std::vector<Remembered>& variables,
                                          bool timed);

}  // namespace robochart::csp_emit
