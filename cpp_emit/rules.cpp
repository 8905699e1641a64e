#include "cpp_emit/rules.hpp"

#include <array>

namespace robochart::cpp_emit::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule no_component{"RC-G01", Severity::error, "no C++ for '{}': {}",
                        "C++ is generated for state machines, controllers and modules of the model. Operations become "
                        "part of the machine that calls them."};
const Rule several_machines{"RC-G02", Severity::error, "no C++ for '{}': it has {} {}, one is supported",
                            "The generated controller runs one state machine. A controller with several machines, or a "
                            "module with several controllers, needs a composition whose order of steps is not defined "
                            "yet. Generate the machines one by one."};
const Rule no_body{"RC-G03", Severity::error, "no C++ for '{}': the state machine has no initial node",
                   "A state machine starts at its initial node; without one it does nothing, which is hardly "
                   "worth generating. Give it an initial node with a transition."};
const Rule unsupported_type{
    "RC-G04", Severity::error, "no C++ for '{}': its type {} is not generated",
    "Generated types: boolean, nat, int, real, enumerations without arguments and given types."};
const Rule unsupported_expr{"RC-G05", Severity::error, "no C++ for {} in '{}'",
                            "Generated expressions: literals, variables, constants, clocks, arithmetic, comparison, "
                            "logic and if-then-else over generated types."};
const Rule unsupported_stmt{"RC-G06", Severity::error, "no C++ for {} in '{}'",
                            "Generated statements: assignment to whole variables, events, calls, waits, clock resets, "
                            "if, sequence and skip."};
const Rule unsupported_node{"RC-G07", Severity::error, "no C++ for {} '{}'",
                            "A probabilistic junction needs a random source, which the generated core does not have; "
                            "states, initial nodes, junctions and final nodes are generated."};
const Rule unsupported_trigger{"RC-G08", Severity::error, "no C++ for the trigger of '{}': {}",
                               "A trigger receives: `e` or `e?x`. Transitions out of initial nodes and "
                               "junctions have none."};
const Rule deadline{"RC-G09", Severity::error, "no C++ for the deadline of '{}'",
                    "A deadline that can be missed stops time in the model, which no code can do. Check the model "
                    "without it, or take the deadline out for the generated component."};
const Rule recursion{"RC-G10", Severity::error, "no C++ for operation '{}': it calls itself",
                     "Each operation in progress has a fixed place in the controller's state, so calls may nest but "
                     "not recur."};
const Rule unconnected{"RC-G11", Severity::error, "no C++ for '{}': its event '{}' is received but {}",
                       "The semantics lets an unconnected trigger happen on its own at any time. That is hardly meant, "
                       "and code can't do it in bounded time. Connect the event or take the trigger out."};
const Rule crossing{"RC-G12", Severity::error, "no C++ for transition '{}': it leaves its composite state",
                    "Source and target of a transition lie in the same composite state, or both at the machine's "
                    "top: the order of exits and entries is defined for these only."};
const Rule too_large{"RC-G13", Severity::error, "no C++ for '{}': {}",
                     "A limit of the generated code or of its exploration interface (runtime/explore_abi.h)."};

std::span<const Rule* const> all() {
    static constexpr std::array table = {
        &no_component,     &several_machines,    &no_body,  &unsupported_type, &unsupported_expr, &unsupported_stmt,
        &unsupported_node, &unsupported_trigger, &deadline, &recursion,        &unconnected,      &crossing,
        &too_large,
    };
    return table;
}

}  // namespace robochart::cpp_emit::rules
