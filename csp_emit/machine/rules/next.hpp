// SPDX-License-Identifier: Apache-2.0
// Defines the results of rules: the next configurations, and the events that lead to them. Only processes.hpp converts
// results to processes.
#pragma once

#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "csp_emit/machine/tables/control_state.hpp"
#include "csp_emit/machine/tables/parameters.hpp"

namespace robochart::csp_emit {

/// The continuation: a configuration, or a choice between several configurations that needs no event.
struct Next {
    enum class Kind {
        configuration,  ///< a configuration: continues at once with steps that need no event
        point,          ///< a configuration: calls its function
        conditional,    ///< two parts, selected by a condition on the values
        branching,      ///< a choice that depends on a condition in a statement; a second conditional after it gets a
                        ///< separate function
        wait_over,      ///< a choice that depends on whether a wait is over; the points of the second part are numbered
                        ///< first
        internal,       ///< the process chooses between the parts
        interval,       ///< the process chooses a value of `d__` from a set, which may be empty
        process,        ///< not a configuration of the machine but the process `expr`
    };
    Kind kind = Kind::configuration;
    Activation config = {};
    Values values = {};
    cspm::ExprPtr expr = {};  ///< the condition, the set or the process
    std::vector<Next> parts = {};
    cspm::Span span = {};  ///< for a choice from a set: the place at which an empty set is reported
};

[[nodiscard]] inline Next next_configuration(Activation config, Values values) {
    return {Next::Kind::configuration, std::move(config), std::move(values)};
}
[[nodiscard]] inline Next at_point(Activation config, Values values) {
    return {Next::Kind::point, std::move(config), std::move(values)};
}
[[nodiscard]] inline Next next_if(cspm::ExprPtr condition, Next then, Next otherwise) {
    return {Next::Kind::conditional, {}, {}, std::move(condition), {std::move(then), std::move(otherwise)}};
}
[[nodiscard]] inline Next next_process(cspm::ExprPtr process) {
    return {Next::Kind::process, {}, {}, std::move(process)};
}

/// A branch of an external choice: `guard & event fields -> next`.
struct Branch {
    cspm::ExprPtr guard = {};  ///< null: always enabled
    cspm::ExprPtr event = {};
    std::vector<cspm::Field> fields = {};
    Next next = {};
    bool tock = false;  ///< the branch is a tock; clocks that `next` does not set advance by one unit
};

}  // namespace robochart::csp_emit
