// SPDX-License-Identifier: Apache-2.0
// Runs a function on a stack that is large enough for deep recursion in scripts. Calls may be nested; only the
// outermost call changes the stack. Passes exceptions on to the caller.
#pragma once

#include <cstddef>
#include <functional>

namespace robochart::cspm {

/// The size in bytes of the stack that `on_deep_stack` provides. AddressSanitizer supports exceptions only on stacks up
/// to this size.
inline constexpr std::size_t deep_stack_bytes = std::size_t{1} << 26U;

void on_deep_stack(const std::function<void()>& work);

}  // namespace robochart::cspm
