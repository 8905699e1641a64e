// SPDX-License-Identifier: Apache-2.0
// Stores the numbers of a model without duplicates. Results of operations are cached, because a state space adds and
// multiplies the same few numbers many times.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "prism/explore/real.hpp"

namespace robochart::prism {

class NumberTable {
public:
    using Id = std::uint32_t;
    static constexpr Id zero = 0;
    static constexpr Id one = 1;

    NumberTable();

    Id id(const Real& number);
    [[nodiscard]] const Real& operator[](Id id) const { return numbers_[id]; }
    [[nodiscard]] std::size_t size() const { return numbers_.size(); }

    Id sum(Id a, Id b) {
        if (a == zero) return b;
        return b == zero ? a : combined(Operation::sum, a, b);
    }
    Id product(Id a, Id b) {
        if (a == one) return b;
        return b == one ? a : combined(Operation::product, a, b);
    }
    /// Divides a by b, which must not be 0.
    Id quotient(Id a, Id b) { return b == one ? a : combined(Operation::quotient, a, b); }

private:
    enum class Operation : std::uint8_t { sum, product, quotient };
    struct Remembered {
        std::uint64_t key = 0;
        Id result = 0;
        Operation operation = Operation::sum;
        bool used = false;
    };

    Id combined(Operation operation, Id a, Id b);

    std::vector<Real> numbers_;
    std::unordered_multimap<std::size_t, Id> found_;  ///< by hash
    std::vector<Remembered> remembered_;              ///< one for each hash; a newer one replaces an older one
};

}  // namespace robochart::prism
