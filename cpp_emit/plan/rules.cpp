// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/rules.hpp"

#include <array>

namespace robochart::cpp_emit::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule no_component{"RC-G01", Severity::error, "no C++ is generated for '{}': {}",
                        "C++ is generated for state machines, controllers and modules of the model. Operations become "
                        "part of the machine that calls them."};
const Rule no_body{"RC-G03", Severity::error, "no C++ is generated for '{}': the state machine has no initial node",
                   "A state machine starts at its initial node. Without an initial node it does nothing, so no code is "
                   "generated. Add an initial node with a transition."};
const Rule unsupported_type{"RC-G04", Severity::error, "no C++ is generated for '{}': its type {} is not supported",
                            "Supported types are boolean, nat, int, real, string, enumerations with at most 256 "
                            "literals, given types, and records, products, sequences, sets, relations, functions, "
                            "vectors and matrices of these types, nested at most 16 deep."};
const Rule unsupported_expr{"RC-G05", Severity::error, "no C++ is generated for {} in '{}'",
                            "Every variable must start with a value. Arithmetic is supported for numbers, vectors and "
                            "matrices. `is` is supported if a number is tested for a type of numbers."};
const Rule unsupported_node{"RC-G07", Severity::error, "no C++ is generated for {} '{}'",
                            "Code is generated for states, initial nodes, junctions, probabilistic junctions and final "
                            "nodes. A composite state is entered through its initial node."};
const Rule unsupported_trigger{
    "RC-G08", Severity::error, "no C++ is generated for the trigger of '{}': {}",
    "A trigger receives an event: `e` or `e?x`. Transitions from initial nodes and junctions have no trigger."};
const Rule recursion{"RC-G10", Severity::error, "no C++ is generated for operation '{}': it calls itself",
                     "Each active operation has a fixed place in the state of the controller. So calls may be nested, "
                     "but not recursive."};
const Rule unconnected{"RC-G11", Severity::error, "no C++ is generated for '{}': its event '{}' is received but {}",
                       "An event without a connection can occur at any time, with any value. The generated code raises "
                       "it with one fixed value, so it is rejected if a condition depends on the value. The two ends "
                       "of a connection must have the same type and belong to two machines."};
const Rule crossing{"RC-G12", Severity::error, "no C++ is generated for transition '{}': it leaves its composite state",
                    "The source and the target of a transition must be in the same composite state, or both at the top "
                    "of the machine. The order of exits and entries is defined only for these transitions."};
const Rule too_large{
    "RC-G13", Severity::error, "no C++ is generated for '{}': {}",
    "The component exceeds a limit of the generated code or of its exploration interface (runtime/explore_abi.h)."};
const Rule no_project{"RC-G14", Severity::error, "no {} project is generated for '{}': {}",
                      "A target may support less than the language. Messages of std_msgs carry truth values, numbers, "
                      "enumerations without arguments, and several numbers as the arguments of an operation. A mapping "
                      "assigns records to messages of the robot."};
const Rule not_explored{
    "RC-G15", Severity::note, "the code of '{}' has no exploration interface, because {} exceeds a limit: {}",
    "The generated controller is complete. Only `conform` rejects it (RC-G13), because `conform` tries all values of "
    "inputs, functions and outputs, and there are too many. Values that the component only passes on do not count."};

std::span<const Rule* const> all() {
    static constexpr std::array table = {
        &no_component, &no_body,     &unsupported_type, &unsupported_expr, &unsupported_node, &unsupported_trigger,
        &recursion,    &unconnected, &crossing,         &too_large,        &no_project,       &not_explored,
    };
    return table;
}

}  // namespace robochart::cpp_emit::rules
