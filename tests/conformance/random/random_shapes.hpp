// Which random models the code of the generator is compared with.
#pragma once

#include <cstdint>

#include "tests/random_models/models/shape.hpp"

namespace robochart::conformance::test {

/// Small systems of several kinds: deep ones, ones of several machines or controllers, ones without time. In most of
/// them actions take time, without which few models can be run in cycles.
[[nodiscard]] random_models::Shape core_shape(std::uint64_t seed);
/// The same with other parts of the language, a few at a time: operations that call operations and take variables and
/// clocks from their callers, names that are repeated, values of all types, ways of junctions that overlap, instances.
[[nodiscard]] random_models::Shape widened_shape(std::uint64_t seed);
/// The same with functions of the model and of the toolkits, many of which have preconditions that can be false.
[[nodiscard]] random_models::Shape toolkits_shape(std::uint64_t seed);
/// Widened ones with names and strings that mean something in CSPM, C++ and elsewhere.
[[nodiscard]] random_models::Shape hostile_shape(std::uint64_t seed);

}  // namespace robochart::conformance::test
