// SPDX-License-Identifier: Apache-2.0
// Sorts rows by the first word, then the second, and so on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace robochart::storage {

/// The size of `rows` is a multiple of `width` words. The sort needs the same amount of memory again.
void sort_rows(std::vector<std::uint32_t>& rows, std::size_t width);

}  // namespace robochart::storage
