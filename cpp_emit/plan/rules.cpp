// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/rules.hpp"

#include <array>

namespace robochart::cpp_emit::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule no_component{"RC-G01", Severity::error, "no C++ for '{}': {}",
                        "C++ is generated for state machines, controllers and modules of the model. Operations become "
                        "part of the machine that calls them."};
const Rule no_body{"RC-G03", Severity::error, "no C++ for '{}': the state machine has no initial node",
                   "A state machine starts at its initial node; without one it does nothing, which is hardly "
                   "worth generating. Give it an initial node with a transition."};
const Rule unsupported_type{
    "RC-G04", Severity::error, "no C++ for '{}': its type {} is not generated",
    "Generated types: boolean, nat, int, real, string, enumerations, given types, and records, products, sequences, "
    "sets, "
    "relations, functions, vectors and matrices of them, at most 16 deep; enumerations have at most 256 literals."};
const Rule unsupported_expr{"RC-G05", Severity::error, "no C++ for {} in '{}'",
                            "Variables start with a value, arithmetic is on numbers, vectors and matrices, and `is` "
                            "asks whether a number is of a "
                            "type of numbers."};
const Rule unsupported_node{
    "RC-G07", Severity::error, "no C++ for {} '{}'",
    "States, initial nodes, junctions, probabilistic junctions and final nodes are generated; a "
    "composite state is entered through its initial node."};
const Rule unsupported_trigger{"RC-G08", Severity::error, "no C++ for the trigger of '{}': {}",
                               "A trigger receives: `e` or `e?x`. Transitions out of initial nodes and "
                               "junctions have none."};
const Rule recursion{"RC-G10", Severity::error, "no C++ for operation '{}': it calls itself",
                     "Each operation in progress has a fixed place in the controller's state, so calls may nest but "
                     "not recur."};
const Rule unconnected{
    "RC-G11", Severity::error, "no C++ for '{}': its event '{}' is received but {}",
    "An event that is connected to nothing happens on its own, with any value. The generated code lets it happen with "
    "one value; where a condition asks which one, it does not know. Ends of a connection have one type and "
    "belong to two machines."};
const Rule crossing{"RC-G12", Severity::error, "no C++ for transition '{}': it leaves its composite state",
                    "Source and target of a transition lie in the same composite state, or both at the machine's "
                    "top: the order of exits and entries is defined for these only."};
const Rule too_large{"RC-G13", Severity::error, "no C++ for '{}': {}",
                     "A limit of the generated code or of its exploration interface (runtime/explore_abi.h)."};
const Rule no_project{"RC-G14", Severity::error, "no {} project for '{}': {}",
                      "A target may offer less than the language: messages of std_msgs carry truth values, numbers, "
                      "enumerations without arguments, and several numbers as the arguments of an operation; a mapping "
                      "gives records the messages of the robot."};
const Rule not_explored{
    "RC-G15", Severity::note, "the code of '{}' has no exploration interface: of {}, {}",
    "The controller is whole; only `conform`, which tries all values of its inputs, functions and outputs over the "
    "finite carriers, refuses it (RC-G13) until they are fewer, unless the component only passes them on."};

std::span<const Rule* const> all() {
    static constexpr std::array table = {
        &no_component, &no_body,     &unsupported_type, &unsupported_expr, &unsupported_node, &unsupported_trigger,
        &recursion,    &unconnected, &crossing,         &too_large,        &no_project,       &not_explored,
    };
    return table;
}

}  // namespace robochart::cpp_emit::rules
