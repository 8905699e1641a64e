// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/random/random_shapes.hpp"

#include "tests/random_models/models/random.hpp"

namespace robochart::conformance::test {

using random_models::Shape;

Shape core_shape(std::uint64_t seed) {
    const bool deep = seed % 9 == 2;
    Shape shape = seed % 6 == 0 ? Shape::untimed_core() : Shape::timed_core();
    shape.paced = shape.time && seed % 6 != 1;
    shape.assertions = false;
    shape.inputs_in_actions = shape.else_conditions = shape.buffers = true;
    shape.probabilistic = seed % 5 == 0;
    shape.events = {1, 2};
    shape.variables = {0, 1};
    shape.controllers = {1, seed % 3 == 0 ? 2U : 1U};
    shape.machines = {1, seed % 3 == 1 ? 2U : 1U};
    shape.states = {1, seed % 3 == 2 && !deep ? 2U : 1U};
    shape.transitions = {deep ? 1U : 0U, deep ? 1U : 2U};
    shape.platform_operations = {0, 1};
    shape.statements = {1, 2};
    shape.depth = deep ? 4 : 1;
    shape.composites = deep ? 75 : 25;
    return shape;
}

Shape widened_shape(std::uint64_t seed) {
    random_models::Random choice(seed ^ 0x57A9E5U);
    Shape shape = core_shape(seed);
    const auto some = [&](bool& part, unsigned percent) { part = choice.chance(percent) || part; };
    if (choice.chance(60)) {
        shape.nested_operations = true;
        shape.defined_operations = {1, choice.chance(30) ? 3U : 2U};
        shape.machines = {1, 1};
        shape.states = {1, 1};
        shape.actions = 70;
        shape.calls = 45;
    }
    if (shape.nested_operations && choice.chance(50)) return shape;
    some(shape.repeated_names, 50);
    some(shape.operation_events, 20);
    some(shape.bodiless_operations, 20);
    some(shape.predicates, 40);
    some(shape.varied_times, 30);
    some(shape.varied_junctions, 40);
    some(shape.varied_places, 30);
    some(shape.instances, 20);
    some(shape.open_constants, 20);
    if (choice.chance(20)) shape.files = {2, 3};
    some(shape.qualified_names, 30);
    shape.probabilistic = choice.chance(20);
    some(shape.chance_expressions, 50);
    random_models::Data& data = shape.data;
    some(data.integers, 15);
    some(data.strings, 10);
    some(data.given, 10);
    some(data.records, 25);
    some(data.products, 15);
    some(data.sequences, 15);
    some(data.sets, 15);
    some(data.vectors, 5);
    some(data.constructors, 15);
    some(data.functions, 15);
    some(data.binders, 15);
    return shape;
}

Shape toolkits_shape(std::uint64_t seed) {
    Shape shape = widened_shape(seed);
    shape.data.functions = shape.data.toolkits = true;
    (seed % 2 == 0 ? shape.data.sets : shape.data.sequences) = true;
    return shape;
}

Shape hostile_shape(std::uint64_t seed) {
    Shape shape = widened_shape(seed);
    shape.hostile = shape.escaped_names = shape.data.strings = true;
    return shape;
}

}  // namespace robochart::conformance::test
