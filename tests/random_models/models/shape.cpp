// SPDX-License-Identifier: Apache-2.0
#include "tests/random_models/models/shape.hpp"

namespace robochart::random_models {

Shape Shape::untimed_core() {
    return {};
}

Shape Shape::timed_core() {
    Shape shape;
    shape.time = true;
    return shape;
}

Shape Shape::whole_language() {
    Shape shape;
    shape.files = {1, 4};
    shape.controllers = {1, 3};
    shape.machines = {1, 3};
    shape.states = {1, 4};
    shape.transitions = {0, 5};
    shape.variables = {0, 4};
    shape.constants = {0, 3};
    shape.events = {1, 5};
    shape.platform_operations = {0, 3};
    shape.defined_operations = {0, 2};
    shape.depth = 3;
    Data& data = shape.data;
    data.integers = data.reals = data.strings = data.given = data.records = data.products = true;
    data.sequences = data.sets = data.vectors = data.functions = data.binders = true;
    data.relations = data.constructors = data.toolkits = data.type_tests = true;
    data.largest = 20;
    data.expression_depth = 3;
    shape.inputs_in_actions = shape.time = shape.open_constants = shape.else_conditions = true;
    shape.bodiless_operations = shape.operation_events = shape.broadcast = true;
    shape.nested_operations = shape.repeated_names = shape.predicates = shape.varied_times = true;
    shape.varied_junctions = shape.chance_expressions = shape.instances = true;
    shape.qualified_names = shape.varied_places = true;
    shape.probabilistic = shape.bidirectional = shape.contracts = shape.escaped_names = shape.comments = true;
    return shape;
}

Shape Shape::with_hostile_words() {
    Shape shape = timed_core();
    shape.hostile = shape.escaped_names = true;
    shape.files = {1, 3};
    shape.defined_operations = {0, 2};
    shape.probabilistic = shape.chance_expressions = shape.qualified_names = shape.nested_operations = true;
    shape.constants = {0, 2};
    Data& data = shape.data;
    data.strings = data.given = data.records = data.products = data.sequences = data.sets = true;
    data.constructors = data.functions = data.binders = true;
    return shape;
}

}  // namespace robochart::random_models
