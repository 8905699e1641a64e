// Variables held in memory processes of their own, beside the machine's process, as in RoboTool's semantics (semantics
// 3.6): for machines whose variables together have too many values to be parameters of one process. The machine asks
// `get_x?x` for what it is about to evaluate and keeps the value only while it does; what it writes goes to the memory
// by `set_x` where the variable is shared, and by the hidden `setL_x` where it is the machine's own.
//
// Why the meaning stays: a `get_x` is hidden, always possible and never offered beside anything else, and no other
// write comes between it and the use, since the machine takes part in all of them. It is an inert step.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "csp_emit/passes/liveness.hpp"

namespace robochart::csp_emit {

/// A variable that a memory process holds.
struct Remembered {
    std::string parameter;  ///< of the machine's functions
    std::string channel;    ///< the name behind `get_`, `setL_`
    std::string shared;     ///< of a shared variable: the name behind `set_` and `set_EXT_`; otherwise empty
    cspm::ExprPtr type;     ///< the set of its values
    cspm::ExprPtr initial;
    std::string memory;   ///< the name of its process
    std::string meaning;  ///< its name in the model
};

/// Which of some parameters each function evaluates, itself or in what it passes to another.
class Evaluations {
public:
    Evaluations(const std::vector<Function>& functions, const std::set<std::string>& parameters);
    /// For each function the remembered variables that it holds: the least sets, since what a call needs of a changed
    /// shared variable counts only if the called function holds it.
    [[nodiscard]] std::vector<std::set<std::string>> held(const std::vector<Remembered>& variables) const;

private:
    /// An argument in the place of a parameter of the called function, not the parameter itself.
    struct Changed {
        std::size_t target;
        std::string parameter;
        std::set<std::string> names;
    };
    struct Use {
        std::set<std::string> names;  ///< outside calls of the family
        std::vector<Changed> changed;
    };
    void survey(const cspm::Expr& expr, Use& use) const;
    void survey_call(const cspm::Expr& expr, std::size_t target, Use& use) const;
    void mention(const cspm::Expr& expr, std::set<std::string>& found) const;

    const std::vector<Function>& functions_;
    const std::set<std::string>& parameters_;
    FamilyIndex index_;
    std::vector<std::vector<bool>> asked_;  ///< by function, of each of its parameters: is it one of `parameters_`?
    std::vector<Use> uses_;
};

/// Takes the remembered variables out of the parameters of the functions, except where a function evaluates them.
/// Termination becomes `end__ -> SKIP`, which ends the memories too. Expects that no parameter is dead
/// (drop_dead_parameters), and that a shared variable changes by its events only.
void remember(std::vector<Function>& functions, cspm::ExprPtr& initial, const FamilyCalls& calls,
              const std::vector<Remembered>& variables);

/// The memories' definitions: `M_x(v) = get_x!v -> M_x(v) [] setL_x?v -> M_x(v) [] ... [] end__ -> SKIP`.
[[nodiscard]] std::vector<cspm::DeclPtr> memory_definitions(const std::vector<Remembered>& variables, bool timed);
/// `channel get_x, setL_x : T` of each, and `end__`.
[[nodiscard]] std::vector<cspm::DeclPtr> memory_channels(const std::vector<Remembered>& variables);
/// The machine's process beside its memories, which it alone talks to.
[[nodiscard]] cspm::ExprPtr with_memories(const cspm::ExprPtr& machine, const std::vector<Remembered>& variables,
                                          bool timed);

}  // namespace robochart::csp_emit
