// SPDX-License-Identifier: Apache-2.0
// See number_table.hpp.
#include "prism/explore/number_table.hpp"

#include <bit>
#include <boost/functional/hash.hpp>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::prism {
namespace {

constexpr std::size_t places = std::size_t{1} << 14U;

std::size_t hash_of(const Real& number) {
    if (number.is_exact()) return hash_value(number.value());
    const Enclosure bounds = number.bounds();
    return diagnostics::splitmix64_mixed(std::bit_cast<std::uint64_t>(bounds.low) ^
                                         std::rotl(std::bit_cast<std::uint64_t>(bounds.high), 21));
}

bool same_number(const Real& a, const Real& b) {
    if (a.is_exact() != b.is_exact()) return false;
    return a.is_exact() ? a.value() == b.value() : a.bounds() == b.bounds();
}

}  // namespace

NumberTable::NumberTable() : remembered_(places) {
    (void)id(Real(std::int64_t{0}));
    (void)id(Real(std::int64_t{1}));
}

NumberTable::Id NumberTable::id(const Real& number) {
    const std::size_t hash = hash_of(number);
    const auto [first, last] = found_.equal_range(hash);
    for (auto at = first; at != last; ++at)
        if (same_number(numbers_[at->second], number)) return at->second;
    const auto id = static_cast<Id>(numbers_.size());
    numbers_.push_back(number);
    found_.emplace(hash, id);
    return id;
}

NumberTable::Id NumberTable::combined(Operation operation, Id a, Id b) {
    if (operation != Operation::quotient && a > b) std::swap(a, b);
    const std::uint64_t key = std::uint64_t{a} << 32U | b;
    const std::uint64_t mixed = diagnostics::splitmix64_mixed(key + static_cast<std::uint64_t>(operation));
    if (const Remembered& known = remembered_[mixed % places];
        known.used && known.key == key && known.operation == operation)
        return known.result;
    Id result = 0;
    if (operation == Operation::sum) result = id(numbers_[a] + numbers_[b]);
    if (operation == Operation::product) result = id(numbers_[a] * numbers_[b]);
    if (operation == Operation::quotient) result = id(numbers_[a] / numbers_[b]);
    remembered_[mixed % places] = {key, result, operation, true};
    return result;
}

}  // namespace robochart::prism
