// SPDX-License-Identifier: Apache-2.0
// Defines the shapes of random models whose generated code is compared with the semantics.
#pragma once

#include <cstdint>

#include "tests/random_models/models/shape.hpp"

namespace robochart::conformance::test {

/// Returns a shape of small systems of several kinds: deep systems, systems with several machines or controllers,
/// untimed systems. Most actions in them take time, because otherwise few models are schedulable.
[[nodiscard]] random_models::Shape core_shape(std::uint64_t seed);
/// Returns the core shape with a few other language constructs at a time: operations that call operations and access
/// variables and clocks of their callers, repeated names, values of all types, junctions with overlapping alternatives,
/// instances.
[[nodiscard]] random_models::Shape widened_shape(std::uint64_t seed);
/// Returns the core shape with functions of the model and of the toolkits. Many of them have preconditions that can be
/// false.
[[nodiscard]] random_models::Shape toolkits_shape(std::uint64_t seed);
/// Returns the widened shape with names and strings that have a meaning in CSPM, C++ and other languages.
[[nodiscard]] random_models::Shape hostile_shape(std::uint64_t seed);

}  // namespace robochart::conformance::test
