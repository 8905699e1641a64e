// SPDX-License-Identifier: Apache-2.0
// Builds expressions for the tests of this component.
#pragma once

#include "semantics/ir/ir.hpp"
#include "tests/semantics/sample_systems/sample_systems.hpp"

namespace robochart::ir::samples {

inline constexpr CoreTypes types{};

[[nodiscard]] ExprPtr nat(std::int64_t value);
[[nodiscard]] ExprPtr integer(std::int64_t value);
[[nodiscard]] ExprPtr decimal(std::int64_t unscaled, std::uint32_t decimals);
[[nodiscard]] ExprPtr truth(bool value);
[[nodiscard]] ExprPtr variable(std::uint32_t index, TypeId type);
[[nodiscard]] ExprPtr constant(std::uint32_t index, TypeId type);
[[nodiscard]] ExprPtr since(std::uint32_t clock);
[[nodiscard]] ExprPtr make(ExprKind kind, TypeId type, std::vector<ExprPtr> args);
/// Returns a system that contains only the core types.
[[nodiscard]] System core_system();

}  // namespace robochart::ir::samples
