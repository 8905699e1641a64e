// SPDX-License-Identifier: Apache-2.0
// Sorts rows by the first word, then the second, and so on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace robochart::storage {

/// Sorts rows of `width` words. The size of `rows` must be a multiple of `width`. The sort needs the memory of `rows` a
/// second time.
void sort_rows(std::vector<std::uint32_t>& rows, std::size_t width);

}  // namespace robochart::storage
