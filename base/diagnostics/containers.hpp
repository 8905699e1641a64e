// SPDX-License-Identifier: Apache-2.0
// Sorts sequences and removes duplicates. (clang 14 lacks std::ranges::unique.)
#pragma once

#include <algorithm>
#include <functional>

namespace robochart::diagnostics {

/// Removes every item that is equal to its predecessor. `are_equal` compares two items.
template <class Items, class AreEqual = std::equal_to<>>
void erase_repeated(Items& items, AreEqual are_equal = {}) {
    items.erase(std::unique(items.begin(), items.end(), are_equal), items.end());
}

/// Sorts the items and removes duplicates.
template <class Items>
void sort_unique(Items& items) {
    std::ranges::sort(items);
    erase_repeated(items);
}

}  // namespace robochart::diagnostics
