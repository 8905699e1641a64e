// Runs a function on a stack of its own, large enough for deep recursion in scripts. Calls may nest; only
// the outermost changes stacks. Exceptions pass through.
#pragma once

#include <cstddef>
#include <functional>

namespace robochart::cspm {

/// Bytes of stack that code run by `on_deep_stack` may use. AddressSanitizer follows exceptions on stacks up to
/// this size only.
inline constexpr std::size_t deep_stack_bytes = std::size_t{1} << 26U;

void on_deep_stack(const std::function<void()>& work);

}  // namespace robochart::cspm
