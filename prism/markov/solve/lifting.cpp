// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/lifting.hpp"

#include <numeric>

#include "prism/markov/solve/arithmetic.hpp"
#include "prism/markov/solve/reconstruction.hpp"
#include "prism/markov/solve/residue.hpp"

namespace robochart::markov {
namespace {

Integer common_multiple(const Integer& left, const Rational& right) {
    const Integer denominator_of_right = denominator(right);
    return left % denominator_of_right == 0 ? left : lcm(left, denominator_of_right);
}

Integer scale_rational(const Integer& multiplier, const Rational& value) {
    return multiplier / denominator(value) * numerator(value);
}

/// The equations with integers: multiplier(i) x(i) = constant(i) + sum of factor x(j). Here x is `scale` times the
/// solution.
class WholeRows {
public:
    WholeRows(const System<Rational>& system, const Policy& policy, diagnostics::Budget* budget) {
        for (const std::uint32_t choice : policy) scale_ = common_multiple(scale_, system.constant[choice]);
        for (const std::uint32_t choice : policy) {
            poll(budget);
            add(system, choice);
        }
    }

    [[nodiscard]] std::size_t size() const { return multiplier_.size(); }
    [[nodiscard]] const Integer& multiplier(std::size_t row) const { return multiplier_[row]; }
    [[nodiscard]] const Integer& constant(std::size_t row) const { return constant_[row]; }
    [[nodiscard]] const Integer& scale() const { return scale_; }
    [[nodiscard]] std::uint64_t entries() const { return unknown_.size(); }

    /// Computes multiplier * x(row) minus the sum of factor * x(j).
    template <class Numbers>
    [[nodiscard]] Integer left_side(std::size_t row, const Numbers& x) const {
        Integer result = multiplier_[row] * x[row];
        for (std::uint64_t entry = first_[row]; entry < first_[row + 1]; ++entry)
            result -= factor_[entry] * x[unknown_[entry]];
        return result;
    }

private:
    void add(const System<Rational>& system, std::uint32_t choice) {
        Integer multiplier = 1;
        for (std::uint64_t entry = system.first_entry[choice]; entry < system.first_entry[choice + 1]; ++entry)
            multiplier = common_multiple(multiplier, system.numbers[system.number[entry]]);
        for (std::uint64_t entry = system.first_entry[choice]; entry < system.first_entry[choice + 1]; ++entry) {
            unknown_.push_back(system.unknown[entry]);
            factor_.push_back(scale_rational(multiplier, system.numbers[system.number[entry]]));
        }
        first_.push_back(unknown_.size());
        constant_.push_back(scale_rational(scale_, system.constant[choice]) * multiplier);
        multiplier_.push_back(std::move(multiplier));
    }

    std::vector<std::uint64_t> first_{0};
    std::vector<std::uint32_t> unknown_;
    std::vector<Integer> factor_;
    std::vector<Integer> constant_;
    std::vector<Integer> multiplier_;
    Integer scale_ = 1;
};

template <std::uint32_t prime>
Residue<prime> residue(const Integer& value) {
    const auto rest = static_cast<std::int64_t>(value % prime);
    return Residue<prime>(static_cast<std::uint32_t>(rest < 0 ? rest + prime : rest));
}

/// The rows of a policy modulo a prime.
template <std::uint32_t prime>
class RowsModulo {
public:
    RowsModulo(const System<Rational>& system, const Policy& policy) {
        for (const std::uint32_t choice : policy) {
            rows_.outside.push_back(residue_of(system.outside[choice]));
            for (std::uint64_t entry = system.first_entry[choice]; entry < system.first_entry[choice + 1]; ++entry) {
                rows_.unknown.push_back(system.unknown[entry]);
                rows_.number.push_back(static_cast<std::uint32_t>(numbers_.size()));
                numbers_.push_back(residue_of(system.numbers[system.number[entry]]));
            }
            rows_.first_entry.push_back(rows_.unknown.size());
            rows_.first_choice.push_back(static_cast<std::uint32_t>(rows_.choices()));
        }
        rows_.numbers = numbers_;
    }

    /// Returns no value if the prime divides a denominator or a pivot, or if the limit is reached.
    [[nodiscard]] std::optional<Factors<Residue<prime>>> factorize_rows(const EliminationLimit& limit) const {
        if (!exist_) return std::nullopt;
        Policy all(rows_.size());
        std::iota(all.begin(), all.end(), 0U);
        return factorize(rows_, all, limit);
    }

private:
    Residue<prime> residue_of(const Rational& value) {
        const auto divisor = residue<prime>(denominator(value));
        exist_ = exist_ && positive(divisor);
        return residue<prime>(numerator(value)) / divisor;
    }

    std::vector<Residue<prime>> numbers_;
    System<Residue<prime>> rows_;
    bool exist_ = true;
};

template <std::uint32_t prime>
class Lifting {
public:
    Lifting(const WholeRows& rows, const Factors<Residue<prime>>& factors, const EliminationLimit& limit)
        : rows_(rows), factors_(factors), limit_(limit), digits_(rows.size()) {
        for (std::size_t row = 0; row < rows.size(); ++row) {
            left_.push_back(rows.constant(row));
            inverse_.push_back(Residue<prime>(1) / residue<prime>(rows.multiplier(row)));
        }
    }

    std::optional<std::vector<Rational>> run() {
        const std::uint64_t cost = factors_.entries() + rows_.entries() + rows_.size();
        std::uint64_t operations = 0;
        for (std::uint64_t next_attempt = 4;; next_attempt += next_attempt / 2) {
            for (; modulus_digits_ < next_attempt; ++modulus_digits_) {
                operations += cost;
                if (operations > limit_.operations) return std::nullopt;
                find_digits();
            }
            if (auto found = try_reconstruction()) return found;
        }
    }

private:
    void find_digits() {
        std::vector<Residue<prime>> side;
        for (std::size_t row = 0; row < rows_.size(); ++row) side.push_back(residue<prime>(left_[row]) * inverse_[row]);
        factors_.solve(side);
        std::vector<std::uint32_t> digit;
        for (const Residue<prime> entry : side) digit.push_back(entry.value());
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            poll(limit_.budget);
            left_[row] -= rows_.left_side(row, digit);
            left_[row] /= prime;
            digits_[row].push_back(digit[row]);
        }
    }

    std::optional<std::vector<Rational>> try_reconstruction() {
        const Integer modulus = pow(Integer(prime), static_cast<unsigned>(modulus_digits_));
        const CommonFractions found = common_fractions(rows_.size(), doubtful_, modulus, [&](std::size_t row) {
            poll(limit_.budget);
            return from_digits(digits_[row], prime);
        });
        if (found.without) {
            doubtful_ = *found.without;
            return std::nullopt;
        }
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            poll(limit_.budget);
            if (rows_.left_side(row, found.numerators) != rows_.constant(row) * found.denominator) return std::nullopt;
        }
        std::vector<Rational> values;
        const Integer denominator = found.denominator * rows_.scale();
        for (const Integer& numerator : found.numerators) {
            poll(limit_.budget);
            values.emplace_back(numerator, denominator);
        }
        return values;
    }

    const WholeRows& rows_;
    const Factors<Residue<prime>>& factors_;
    const EliminationLimit& limit_;
    std::vector<Integer> left_;
    std::vector<Residue<prime>> inverse_;  // inverses of the multipliers
    std::vector<std::vector<std::uint32_t>> digits_;
    std::uint64_t modulus_digits_ = 0;
    std::size_t doubtful_ = 0;  // index of a value for which no fraction was found
};

template <std::uint32_t prime>
std::optional<std::vector<Rational>> lift_with(const WholeRows& rows, const System<Rational>& system,
                                               const Policy& policy, const EliminationLimit& limit) {
    const auto factors = RowsModulo<prime>(system, policy).factorize_rows(limit);
    if (!factors) return std::nullopt;
    return Lifting<prime>(rows, *factors, limit).run();
}

}  // namespace

std::optional<std::vector<Rational>> lift_solution(const System<Rational>& system, const Policy& policy,
                                                   const EliminationLimit& limit) {
    if (!always_leaves(system, policy)) return std::nullopt;
    const WholeRows rows(system, policy, limit.budget);
    if (auto found = lift_with<first_prime>(rows, system, policy, limit)) return found;
    if (auto found = lift_with<second_prime>(rows, system, policy, limit)) return found;
    if (auto found = lift_with<third_prime>(rows, system, policy, limit)) return found;
    // No prime is suitable. With a limit there is no fallback, because the cost of an elimination with fractions is
    // unpredictable.
    if (limit.operations != EliminationLimit{}.operations) return std::nullopt;
    std::vector<Rational> side;
    for (const std::uint32_t choice : policy) side.push_back(system.constant[choice]);
    auto solved = eliminate(system, policy, {std::move(side)}, limit);
    if (!solved) return std::nullopt;
    return std::move(solved->front());
}

}  // namespace robochart::markov
