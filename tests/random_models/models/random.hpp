// SPDX-License-Identifier: Apache-2.0
// Draws random numbers that are the same on every platform: SplitMix64 (Steele, Lea, Flood: Fast splittable
// pseudorandom number generators, OOPSLA 2014). Distributions of the standard library are not used, because their
// results differ between libraries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace robochart::random_models {

/// A stream of random numbers. Draw only one per expression, because the compiler chooses the order in which arguments
/// are evaluated.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    /// Returns the next 64 bits.
    std::uint64_t next();
    /// Returns a number below `bound`, which must be positive.
    std::size_t below(std::size_t bound);
    /// Returns a number from `low` to `high`, both included.
    std::size_t between(std::size_t low, std::size_t high) { return low + below(high - low + 1); }
    /// Returns true in `percent` of 100 cases.
    bool chance(unsigned percent) { return below(100) < percent; }
    /// Returns one of the items. `items` must not be empty.
    template <class Item>
    const Item& pick(const std::vector<Item>& items) {
        return items[below(items.size())];
    }

private:
    std::uint64_t state_;
};

}  // namespace robochart::random_models
