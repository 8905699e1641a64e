// SPDX-License-Identifier: Apache-2.0
#include "conformance/check/numbers_to_try.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "base/diagnostics/splitmix64.hpp"
#include "base/diagnostics/text.hpp"
#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/numbers.hpp"

namespace robochart::conformance {

namespace {

__extension__ using Wide = __int128;
__extension__ using WideUnsigned = unsigned __int128;

/// A sum of products of whole numbers and powers of two, exact from the least to the greatest double. It is a
/// fixed-point number that is wide enough for all of them (Kulisch, Computer Arithmetic and Validity, 2008, chapter 8).
class ExactSum {
public:
    /// Adds factor * number, in two halves that fit: the factor has less than 90 bits.
    void add_product(Wide factor, std::int64_t number, int exponent = 0) {
        constexpr unsigned half = 32;
        add(factor * (number >> half), exponent + static_cast<int>(half));
        add(factor * (number & ((std::int64_t{1} << half) - 1)), exponent);
    }
    void add_product(Wide factor, double number) {
        int exponent = 0;
        auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(number, &exponent), 53));
        exponent -= 53;
        for (; exponent < lowest; ++exponent) mantissa /= 2;  // exact: the last bits of a subnormal mantissa are 0
        add_product(factor, mantissa, exponent);
    }
    /// Adds factor * 2^exponent; exponent is at least that of the least double.
    void add(Wide factor, int exponent) {
        const bool negative = factor < 0;
        WideUnsigned rest = static_cast<WideUnsigned>(negative ? -factor : factor);
        const auto shift = static_cast<unsigned>(exponent - lowest);
        std::size_t limb = shift / limb_bits;
        for (unsigned bit = shift % limb_bits; rest != 0; bit = 0, ++limb) {
            const unsigned taken = limb_bits - bit;
            const auto digits = static_cast<std::int64_t>(rest & ((WideUnsigned{1} << taken) - 1)) << bit;
            limbs_.at(limb) += negative ? -digits : digits;
            rest >>= taken;
        }
    }
    [[nodiscard]] int sign() const {
        std::int64_t carry = 0;
        bool zero = true;
        for (const std::int64_t limb : limbs_) {
            const std::int64_t sum = limb + carry;
            carry = sum >> limb_bits;
            zero = zero && (sum & ((std::int64_t{1} << limb_bits) - 1)) == 0;
        }
        if (carry < 0) return -1;
        return zero && carry == 0 ? 0 : 1;
    }

private:
    static constexpr int lowest = -1074;
    static constexpr unsigned limb_bits = 32;
    std::array<std::int64_t, 74> limbs_{};  ///< 74 * 32 bits: exponents up to 1024, and factors of 128 bits
};

bool is_real(const ir::NumberPart& part) {
    return part.kind == ir::TypeKind::real;
}

double as_double(const TriedNumber& number) {
    return std::bit_cast<double>(number.bits);
}

/// Returns the number itself. Both zeros become the positive zero.
TriedNumber itself(double number) {
    return {std::bit_cast<std::int64_t>(number + 0.0), std::nullopt};
}

int sign_of_number(Wide number) {
    return number < 0 ? -1 : static_cast<int>(number > 0);
}

/// Returns the exact sign of a form of one number: coefficient * number + constant. The constant is in units if the
/// number is real. Computes with doubles first. Their error is below 2^-50 of the sum of the absolute summands.
int sign_of_item(const NumberSpace& space, const ir::Cut& cut, const TriedNumber& item) {
    const Wide coefficient = cut.coefficients.at(0);
    if (item.units || !is_real(space.part(0)))
        return sign_of_number(coefficient * item.units.value_or(item.bits) + cut.constant);
    const double product =
        static_cast<double>(cut.coefficients[0]) * static_cast<double>(space.scale) * as_double(item);
    const auto constant = static_cast<double>(cut.constant);
    const double error = std::ldexp(std::abs(product) + std::abs(constant), -50);
    if (std::abs(product + constant) > error) return product + constant < 0 ? -1 : 1;
    ExactSum sum;
    sum.add(Wide{cut.constant}, 0);
    sum.add_product(coefficient * space.scale, as_double(item));
    return sum.sign();
}

/// The form is monotonic in its number. So its sign for the least (or greatest) number in a window is the least or the
/// greatest sign for an item.
int sign_of_sequence(const NumberSpace& space, const ir::Cut& cut, const TriedValue& sequence) {
    if (!cut.window)
        return sign_of_number(Wide{cut.coefficients.at(0)} * static_cast<std::int64_t>(sequence.size()) + cut.constant);
    const bool greatest = (cut.coefficients.at(0) > 0) == cut.window->greatest;
    const auto sign = ir::extremum_in(*cut.window, greatest, sequence.size(),
                                      [&](std::size_t i) { return sign_of_item(space, cut, sequence[i]); });
    return sign.value_or(2);
}

class NumberChooser {
public:
    NumberChooser(const NumberSpace& space, const ir::ExploredValues& explored, std::size_t random,
                  diagnostics::Pollable& budget)
        : space_(space), explored_(explored), random_(random), budget_(budget) {}

    std::vector<TriedRegion> choose() {
        add_points();
        add_all_neighbours();  // neighbours of simple numbers come first
        for (TriedRegion& region : regions_)
            if (region.boundary) add_random(region);
        if (!space_.sequences) add_all_neighbours();  // a sequence has many neighbours
        for (TriedRegion& region : regions_)
            if (!region.boundary) add_random(region);
        return std::move(regions_);
    }

private:
    using Numbers = std::vector<std::int64_t>;

    [[nodiscard]] std::vector<int> signs_at(const TriedValue& value) const {
        std::vector<int> signs;
        for (const ir::Cut& cut : space_.cuts) signs.push_back(sign_of(space_, cut, value));
        return signs;
    }

    void add_points() {
        for (std::size_t v = 0; v < explored_.values.size(); ++v) {
            TriedValue value = nearest_value(space_, explored_.values[v]);
            const std::vector<int> signs = signs_at(value);
            const auto [found, fresh] = by_signs_.emplace(signs, regions_.size());
            if (fresh) regions_.emplace_back().boundary = is_boundary(signs);
            known_.insert(bits_of(value));
            regions_[found->second].places.push_back(v);
            regions_[found->second].values.push_back(std::move(value));
        }
    }

    /// Whether the form of some condition on numbers is 0. The size of a sequence has no neighbours.
    [[nodiscard]] bool is_boundary(const std::vector<int>& signs) const {
        for (std::size_t c = 0; c < signs.size(); ++c)
            if (signs[c] == 0 && (!space_.sequences || space_.cuts[c].window)) return true;
        return false;
    }

    /// Adds a value to its region, unless the code's number is already in use. Each number of the code represents only
    /// one number of the model.
    void add(TriedValue value) {
        budget_.poll();
        for (std::size_t p = 0; p < value.size(); ++p) {
            if (is_real(space_.part(p)) && !std::isfinite(as_double(value[p]))) return;
            if (space_.part(p).kind == ir::TypeKind::nat && value[p].bits < 0) return;
        }
        const auto region = by_signs_.find(signs_at(value));
        if (region == by_signs_.end()) return;
        if (known_.insert(bits_of(value)).second) regions_[region->second].values.push_back(std::move(value));
    }

    void add_all_neighbours() {
        for (const TriedRegion& region : regions_) {
            if (!region.boundary) continue;
            const std::vector<TriedValue> points = region.values;  // `add` changes the values of regions
            if (space_.sequences)
                add_neighbours_of_sequences(points);
            else
                add_neighbours(points);
        }
    }

    /// Adds the adjacent numbers on both sides of each number that lies on the boundary of a condition.
    void add_neighbours(const std::vector<TriedValue>& points) {
        for (const TriedValue& point : points) {
            for (std::size_t p = 0; p < point.size(); ++p) {
                const bool boundary = std::ranges::any_of(space_.cuts, [&](const ir::Cut& cut) {
                    return cut.coefficients[p] != 0 && sign_of(space_, cut, point) == 0;
                });
                for (const int side : {-1, 1}) {
                    TriedValue neighbour = point;
                    if (boundary && step(neighbour[p], space_.parts[p], side)) add(std::move(neighbour));
                }
            }
        }
    }

    /// The same for each window whose number lies on the boundary: replaces the first of the items that are equal to
    /// this number, the last one, and all of them.
    void add_neighbours_of_sequences(const std::vector<TriedValue>& points) {
        for (const TriedValue& point : points) {
            for (const ir::Cut& cut : space_.cuts) {
                if (!cut.window || sign_of(space_, cut, point) != 0) continue;
                const std::vector<std::size_t> equal = items_at_boundary(cut, point);
                for (const int side : {-1, 1}) {
                    add_with_steps(point, {equal.front()}, side);
                    add_with_steps(point, {equal.back()}, side);
                    add_with_steps(point, equal, side);
                }
            }
        }
    }

    /// The items of the window for which the cut's form is 0.
    [[nodiscard]] std::vector<std::size_t> items_at_boundary(const ir::Cut& cut, const TriedValue& sequence) const {
        std::vector<std::size_t> result;
        ir::visit_items(*cut.window, sequence.size(), [&](std::size_t item) {
            if (sign_of_item(space_, cut, sequence[item]) == 0) result.push_back(item);
        });
        return result;
    }

    void add_with_steps(TriedValue sequence, const std::vector<std::size_t>& items, int side) {
        for (const std::size_t item : items)
            if (!step(sequence[item], space_.part(item), side)) return;
        add(std::move(sequence));
    }

    /// Replaces a number by the next one of the code.
    [[nodiscard]] static bool step(TriedNumber& number, const ir::NumberPart& part, int side) {
        if (is_real(part)) {
            number = itself(std::nextafter(as_double(number), side * std::numeric_limits<double>::infinity()));
            return true;
        }
        const auto next = ir::checked_add(number.bits, side);
        if (next) number = {*next, std::nullopt};
        return next.has_value();
    }

    /// Adds random numbers. Numbers between two explored values of the region are in the region, because it is convex.
    /// Numbers far from them may be in another region, and are then not used.
    void add_random(TriedRegion& region) {
        const std::vector<std::size_t> places = region.places;
        const std::size_t most = region.values.size() + random_;
        const std::vector<int> signs = signs_at(region.values.front());
        for (std::size_t trial = 0; trial < 8 * random_ && region.values.size() < most; ++trial) {
            const std::size_t chosen = draw() % places.size();
            const Numbers& from = explored_.values[places[chosen]];
            const Numbers& to = explored_.values[places[draw() % places.size()]];
            TriedValue value = space_.sequences ? random_sequence(trial, region.values[chosen], from, to)
                                                : random_value(trial, from, to);
            if (signs_at(value) == signs) add(std::move(value));
        }
    }

    [[nodiscard]] TriedValue random_value(std::size_t trial, const Numbers& from, const Numbers& to) {
        if (trial % 3 == 0) return distant(from);
        return trial % 3 == 1 ? decimal_between(from, to) : double_between(from, to);
    }

    /// Returns a sequence with another length, with one other item, with items between those of two sequences, or with
    /// items that are greater by different amounts (less, if windows read greatest numbers). `value` consists of the
    /// numbers `from`.
    [[nodiscard]] TriedValue random_sequence(std::size_t trial, TriedValue value, const Numbers& from,
                                             const Numbers& to) {
        if (trial % 4 == 0) {
            const TriedNumber last = value.empty() ? nearest_number(space_, space_.part(0), 0) : value.back();
            value.resize(draw() % (space_.most_items + 1), last);
            return value;
        }
        if (trial % 4 == 1 && from.size() == to.size()) return double_between(from, to);
        const bool greatest =
            std::ranges::any_of(space_.cuts, [](const ir::Cut& cut) { return cut.window && cut.window->greatest; });
        const std::size_t only = from.empty() ? 0 : draw() % from.size();
        for (std::size_t i = 0; i < from.size(); ++i) {
            const double distance = std::exp2(60 * uniform() - 30) * (greatest ? -1 : 1);
            const bool changed = trial % 4 == 2 ? i == only : uniform() < 0.5;
            const bool back = trial % 8 == 2;
            if (changed) value[i] = rounded(i, number_at(from, i) + (back ? -distance : distance));
        }
        return value;
    }

    /// Returns a value on the line between two values, with parts that are whole numbers of units.
    [[nodiscard]] TriedValue decimal_between(const Numbers& from, const Numbers& to) {
        std::int64_t steps = 0;
        for (std::size_t p = 0; p < from.size(); ++p) steps = std::gcd(steps, to[p] - from[p]);
        const auto step = static_cast<std::int64_t>(draw() % (static_cast<std::uint64_t>(steps) + 1));
        Numbers between = from;
        for (std::size_t p = 0; p < from.size() && steps != 0; ++p) between[p] += step * ((to[p] - from[p]) / steps);
        return nearest_value(space_, between);
    }

    [[nodiscard]] TriedValue double_between(const Numbers& from, const Numbers& to) {
        const double share = uniform();
        TriedValue value;
        for (std::size_t p = 0; p < from.size(); ++p) {
            const double a = number_at(from, p), b = number_at(to, p);
            value.push_back(rounded(p, a + share * (b - a)));
        }
        return value;
    }

    /// Returns a value at a distance of 2^-30 to 2^30 in each part.
    [[nodiscard]] TriedValue distant(const Numbers& from) {
        TriedValue value;
        for (std::size_t p = 0; p < from.size(); ++p) {
            const double distance = std::exp2(60 * uniform() - 30) * (uniform() < 0.5 ? -1 : 1);
            value.push_back(rounded(p, number_at(from, p) + distance));
        }
        return value;
    }

    [[nodiscard]] double number_at(const Numbers& numbers, std::size_t part) const {
        const auto number = static_cast<double>(numbers[part]);
        return is_real(space_.part(part)) ? number / static_cast<double>(space_.scale) : number;
    }
    [[nodiscard]] TriedNumber rounded(std::size_t part, double number) const {
        return is_real(space_.part(part)) ? itself(number) : TriedNumber{std::llround(number), std::nullopt};
    }
    [[nodiscard]] static Numbers bits_of(const TriedValue& value) {
        Numbers bits;
        for (const TriedNumber& number : value) bits.push_back(number.bits);
        return bits;
    }
    [[nodiscard]] std::uint64_t draw() { return diagnostics::splitmix64(seed_); }
    /// Draws a multiple of 2^-53 in [0, 1).
    [[nodiscard]] double uniform() { return std::ldexp(static_cast<double>(draw() >> 11U), -53); }

    const NumberSpace& space_;
    const ir::ExploredValues& explored_;
    std::size_t random_;
    diagnostics::Pollable& budget_;
    std::vector<TriedRegion> regions_;
    std::map<std::vector<int>, std::size_t> by_signs_;
    std::set<Numbers> known_;
    std::uint64_t seed_ = 1;
};

}  // namespace

NumberSpace number_space(const ir::System& system, const ir::ValueModel& model, std::size_t type) {
    const ir::TypeId id = model.types.at(type).type;
    NumberSpace space{ir::number_parts(system, id), {}, model.scale};
    space.sequences = ir::is_number_sequence(system, id);
    if (space.sequences) space.parts = ir::number_parts(system, system.type(id).args.at(0));
    std::ranges::copy_if(model.cuts, std::back_inserter(space.cuts),
                         [&](const ir::Cut& cut) { return cut.type == id; });
    return space;
}

int sign_of(const NumberSpace& space, const ir::Cut& cut, const TriedValue& value) {
    if (space.sequences) return sign_of_sequence(space, cut, value);
    ExactSum sum;
    sum.add(Wide{cut.constant}, 0);
    for (std::size_t p = 0; p < value.size(); ++p) {
        const Wide coefficient = cut.coefficients[p];
        if (value[p].units)
            sum.add_product(coefficient, *value[p].units);
        else if (is_real(space.parts[p]))
            sum.add_product(coefficient * space.scale, as_double(value[p]));
        else
            sum.add_product(coefficient * space.scale, value[p].bits);
    }
    return sum.sign();
}

double nearest_double(const std::string& decimal) {
    double nearest = 0;
    std::from_chars(decimal.data(), decimal.data() + decimal.size(), nearest);
    return nearest;
}

TriedNumber nearest_number(const NumberSpace& space, const ir::NumberPart& part, std::int64_t number) {
    if (!is_real(part)) return {number, std::nullopt};
    return {std::bit_cast<std::int64_t>(nearest_double(ir::decimal_text(number, space.scale))), number};
}

TriedValue nearest_value(const NumberSpace& space, const std::vector<std::int64_t>& numbers) {
    TriedValue value;
    for (std::size_t p = 0; p < numbers.size(); ++p) value.push_back(nearest_number(space, space.part(p), numbers[p]));
    return value;
}

std::string value_text(const NumberSpace& space, const TriedValue& value) {
    std::vector<std::string> texts;
    for (std::size_t p = 0; p < value.size(); ++p) {
        if (value[p].units)
            texts.push_back(ir::decimal_text(*value[p].units, space.scale));
        else if (is_real(space.part(p)))
            texts.push_back(fmt::format("{}", as_double(value[p])));
        else
            texts.push_back(fmt::format("{}", value[p].bits));
    }
    if (space.sequences) return fmt::format("<{}>", diagnostics::join_equal(texts));
    if (texts.size() == 1) return texts.front();
    return fmt::format("({})", fmt::join(texts, ", "));
}

std::vector<TriedRegion> numbers_to_try(const NumberSpace& space, const ir::ExploredValues& explored,
                                        std::size_t random, diagnostics::Pollable& budget) {
    return NumberChooser(space, explored, random, budget).choose();
}

}  // namespace robochart::conformance
