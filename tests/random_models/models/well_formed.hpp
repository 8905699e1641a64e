// SPDX-License-Identifier: Apache-2.0
// Makes random models that are well-formed by construction. For every seed and shape they load without an error, but
// warnings are possible (a variable that is never read, an unconnected event).
#pragma once

#include <cstdint>

#include "tests/random_models/models/project.hpp"
#include "tests/random_models/models/shape.hpp"

namespace robochart::random_models {

/// Returns one module with its platform, controllers, machines, operations, interfaces and types. The same seed and
/// shape give the same texts on every platform.
[[nodiscard]] Project well_formed(std::uint64_t seed, const Shape& shape = Shape::whole_language());

/// Returns independent modules with about `lines` lines in total, distributed over `files` files, for benchmarks. A
/// module may span several files.
[[nodiscard]] Project sized(std::uint64_t seed, std::size_t lines, std::size_t files,
                            const Shape& shape = Shape::whole_language());

}  // namespace robochart::random_models
