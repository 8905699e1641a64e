// SPDX-License-Identifier: Apache-2.0
// Describes random well-formed models: their sizes, and the language constructs that they use.
#pragma once

#include <cstddef>

namespace robochart::random_models {

/// An inclusive range of numbers.
struct Count {
    std::size_t low = 0;
    std::size_t high = 0;
};

/// The types and expressions of variables, events and parameters.
struct Data {
    bool naturals = true;
    bool integers = false;
    bool reals = false;
    bool strings = false;
    bool given = false;  ///< `type X`, with a function that yields one of its values
    bool enumerations = true;
    bool records = false;
    bool products = false;
    bool sequences = false;
    bool sets = false;
    bool vectors = false;       ///< and matrices
    bool relations = false;     ///< `A -> B` and `A <-> B`
    bool constructors = false;  ///< enumeration literals with parameters
    bool toolkits = false;      ///< functions of the four toolkits, and generic ones (`?X`)
    bool type_tests = false;    ///< `is`
    bool functions = false;     ///< function declarations with contracts, and lambda
    bool binders = false;       ///< quantifiers, let, the, comprehensions
    bool arithmetic = true;     ///< + and * (and - / % where their types are allowed)
    std::size_t largest = 3;    ///< of literals
    std::size_t expression_depth = 2;
};

/// The parameters of well-formed models. Every combination gives models without errors.
struct Shape {
    // Sizes.
    Count files{1, 1};  ///< over which the definitions of one system are distributed
    Count controllers{1, 2};
    Count machines{1, 2};     ///< of a controller
    Count states{1, 3};       ///< of a machine or composite state, without junctions and final states
    Count transitions{0, 3};  ///< of a container, in addition to those that the rules and reachability need
    Count variables{0, 2};    ///< of a machine
    Count constants{0, 1};    ///< of a machine
    Count events{1, 3};       ///< of a machine
    Count clocks{1, 2};       ///< of a machine, with `time`
    Count platform_operations{0, 2};
    Count defined_operations{0, 1};  ///< of a controller
    Count statements{1, 3};          ///< of an action
    unsigned actions = 35;           ///< percent of the transitions
    unsigned calls = 25;             ///< percent of the simple statements, if there are operations
    std::size_t depth = 1;           ///< of nested composite states
    unsigned composites = 25;        ///< percent of the states, down to that depth

    // Parts of the language.
    Data data;
    bool typed_events = true;
    bool composite_states = true;
    bool junctions = true;
    bool final_states = true;
    bool during_actions = true;
    bool exit_actions = true;
    bool conditionals = true;        ///< `if` statements
    bool inputs_in_actions = false;  ///< `e?x` as a statement
    bool time = false;               ///< clocks, since, sinceEntry, wait, deadlines
    bool paced = false;              ///< with `time`: actions take a time unit, and so do entry actions of states
    bool shared_variables = true;    ///< of the platform and of controllers
    bool open_constants = false;     ///< constants without a value
    bool varied_places = false;      ///< members of interfaces may be declared in components, and the reverse
    bool references = true;          ///< rref, cref, sref, opref in addition to definitions in place
    bool buffers = false;            ///< half of the connections between controllers are asynchronous
    bool unconnected_events = true;
    bool else_conditions = false;  ///< `condition else`
    bool probabilistic = false;
    bool bidirectional = false;       ///< [mult]
    bool contracts = false;           ///< conditions of operations
    bool predicates = false;          ///< conditions of inputs: `e[| p |]?x`
    bool varied_times = false;        ///< durations that depend on variables: `wait(v)`, `since(C) < v`
    bool varied_junctions = false;    ///< junctions after initial nodes and junctions, with overlapping or false guards
    bool chance_expressions = false;  ///< probabilities such as `1 / 4` and `1 - q`
    bool instances = false;           ///< two references to one machine or controller
    bool bodiless_operations = false;
    bool operation_events = false;   ///< operations communicate on events of their callers
    bool nested_operations = false;  ///< operations call others, and access variables and clocks of their callers
    bool repeated_names = false;     ///< components use the same names for their members
    bool broadcast = false;          ///< `_broadcast` events, and conditions of their communications
    bool packages = true;            ///< named packages and imports
    bool qualified_names = false;    ///< `P::X` although `X` is enough
    bool escaped_names = false;      ///< `^end` and other reserved words as names
    bool hostile = false;            ///< names and strings with a meaning in CSPM or C++
    bool assertions = true;          ///< an assertion file for each module
    bool comments = false;           ///< and `diagram`

    /// Returns the shape of one or a few machines with booleans, small numbers and enumerations, without time. Their
    /// state spaces are small.
    [[nodiscard]] static Shape untimed_core();
    /// Returns the untimed core with clocks, waits and deadlines.
    [[nodiscard]] static Shape timed_core();
    /// Returns a shape with every construct that a model without errors may contain.
    [[nodiscard]] static Shape whole_language();
    /// Returns a shape of small models with names and strings from the languages to which they are translated.
    [[nodiscard]] static Shape with_hostile_words();
};

}  // namespace robochart::random_models
