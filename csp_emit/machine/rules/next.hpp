// The results of rules: the configurations that follow, and the events that lead to them. Processes are made of them in
// processes.hpp only.
#pragma once

#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "csp_emit/machine/tables/control_state.hpp"
#include "csp_emit/machine/tables/parameters.hpp"

namespace robochart::csp_emit {

/// What follows: a configuration, or a choice between several that is made without an event.
struct Next {
    enum class Kind {
        configuration,  ///< goes on at once with what needs no event
        point,          ///< named as it is: a function of its own
        conditional,    ///< two parts, by a condition on the values
        branching,      ///< the same, for a statement: a second one after it gets a function of its own
        wait_over,      ///< the same, for a wait that may be over: the second part's points are numbered first
        internal,       ///< the process chooses between the parts
        interval,       ///< the process chooses a value of `d__` from a set, of which there may be none
        process,        ///< nothing of the machine: the process itself
    };
    Kind kind = Kind::configuration;
    Activation config = {};
    Values values = {};
    cspm::ExprPtr expr = {};  ///< the condition, the set, the process
    std::vector<Next> parts = {};
    cspm::Span span = {};  ///< of a choice from a set: where a report says that it is empty
};

[[nodiscard]] inline Next go(Activation config, Values values) {
    return {Next::Kind::configuration, std::move(config), std::move(values)};
}
[[nodiscard]] inline Next at_point(Activation config, Values values) {
    return {Next::Kind::point, std::move(config), std::move(values)};
}
[[nodiscard]] inline Next if_(cspm::ExprPtr condition, Next then, Next otherwise) {
    return {Next::Kind::conditional, {}, {}, std::move(condition), {std::move(then), std::move(otherwise)}};
}
[[nodiscard]] inline Next process(cspm::ExprPtr process) {
    return {Next::Kind::process, {}, {}, std::move(process)};
}

/// A branch of an external choice: `guard & event fields -> next`.
struct Branch {
    cspm::ExprPtr guard = {};  ///< null: always
    cspm::ExprPtr event = {};
    std::vector<cspm::Field> fields = {};
    Next next = {};
    bool tock = false;  ///< time passes: clocks that `next` does not speak of count on
};

}  // namespace robochart::csp_emit
