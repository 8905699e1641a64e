// Rows put in order: by the first word, then the second, and so on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace robochart::storage {

/// `rows`: a multiple of `width` words. Takes as much memory again while it works.
void sort_rows(std::vector<std::uint32_t>& rows, std::size_t width);

}  // namespace robochart::storage
