// SPDX-License-Identifier: Apache-2.0
// Tests exact solutions by p-adic lifting, and the arithmetic that it uses.
#include "prism/markov/solve/lifting.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <random>

#include "prism/markov/solve/reconstruction.hpp"
#include "prism/markov/solve/residue.hpp"
#include "tests/rounds.hpp"

namespace robochart::markov {
namespace {

bool is_prime(std::uint64_t number) {
    for (std::uint64_t divisor = 2; divisor * divisor <= number; ++divisor)
        if (number % divisor == 0) return false;
    return number > 1;
}

TEST(Residue, ModuliArePrimes) {
    for (const std::uint32_t modulus : {first_prime, second_prime, third_prime}) EXPECT_TRUE(is_prime(modulus));
    EXPECT_GT(first_prime, second_prime);
    EXPECT_GT(second_prime, third_prime);
}

TEST(Residue, IsAField) {
    using Seventh = Residue<7>;
    for (std::uint32_t left = 0; left < 7; ++left)
        for (std::uint32_t right = 0; right < 7; ++right) {
            Seventh sum(left);
            sum += Seventh(right);
            EXPECT_EQ(sum.value(), (left + right) % 7);
            EXPECT_EQ((Seventh(left) * Seventh(right)).value(), left * right % 7);
            if (right == 0) continue;
            EXPECT_EQ(Seventh(left) / Seventh(right) * Seventh(right), Seventh(left));
        }
    const Residue<first_prime> last(first_prime - 1);  // -1
    EXPECT_EQ((last * last).value(), 1U);
    EXPECT_EQ((Residue<first_prime>(1) / last), last);
}

TEST(Reconstruction, Digits) {
    const std::array<std::uint32_t, 5> digits{1, 2, 3, 4, 5};
    EXPECT_EQ(from_digits(digits, 10), 54'321);
    EXPECT_EQ(from_digits(std::span(digits).first(1), 10), 1);
    EXPECT_EQ(from_digits(std::span(digits).first(0), 10), 0);
    EXPECT_EQ(from_digits(std::span(digits).first(4), 10), 4'321);
}

/// Returns numerator / denominator modulo a power of a prime.
Integer quotient(const Integer& numerator, const Integer& denominator, const Integer& modulus, const Integer& prime) {
    const Integer order = modulus / prime * (prime - 1);  // Euler's theorem: every unit to this power is 1
    const Integer inverse = powm(denominator, Integer(order - 1), modulus);
    const Integer result = numerator * inverse % modulus;
    return result < 0 ? Integer(result + modulus) : result;
}

TEST(Reconstruction, Fractions) {
    const Integer prime = first_prime;
    const Integer modulus = prime * prime * prime * prime;
    std::mt19937_64 numbers(4);
    for (int round = 0; round < 200; ++round) {
        const Integer denominator = 1 + numbers() % (1ULL << 40U);
        Integer numerator = numbers() % (1ULL << 40U);
        if (round % 2 == 0) numerator = -numerator;
        const auto found = reconstruct_fraction(quotient(numerator, denominator, modulus, prime), modulus);
        ASSERT_TRUE(found);
        EXPECT_EQ(Rational(found->numerator, found->denominator), Rational(numerator, denominator));
    }
    // Fractions of 60 digits need a modulus of more than 124 digits. With a smaller modulus, no fraction is found,
    // rather than a wrong one.
    for (int round = 0; round < 200; ++round) {
        const Integer denominator = 1 + (numbers() >> 4U);
        const Integer numerator = numbers() >> 4U;
        const auto found = reconstruct_fraction(quotient(numerator, denominator, modulus, prime), modulus);
        EXPECT_TRUE(!found || Rational(found->numerator, found->denominator) == Rational(numerator, denominator));
    }
}

TEST(Reconstruction, OneDenominator) {
    const Integer prime = first_prime;
    const Integer modulus = prime * prime * prime;
    const std::vector<Rational> values{Rational(1, 6), Rational(3, 10), Rational(0), Rational(7, 2)};
    const auto read = [&](std::size_t at) {
        return quotient(numerator(values[at]), denominator(values[at]), modulus, prime);
    };
    for (std::size_t first = 0; first < values.size(); ++first) {
        const CommonFractions found = common_fractions(values.size(), first, modulus, read);
        ASSERT_FALSE(found.without);
        EXPECT_EQ(found.denominator, 30);
        for (std::size_t at = 0; at < values.size(); ++at)
            EXPECT_EQ(Rational(found.numerators[at], found.denominator), values[at]);
    }
}

/// Random equations with one choice for each unknown, and their coefficients.
struct Chain {
    std::vector<Rational> numbers;
    System<Rational> system;
    Policy policy;

    Chain() = default;
    Chain(const Chain&) = delete;
    Chain& operator=(const Chain&) = delete;
};

/// Fills the chain with random equations. Each unknown leads to lower unknowns with positive probability, and the
/// lowest one leads outside, so each unknown leads outside with positive probability. `unit` divides the denominators.
void fill(std::mt19937_64& random, std::uint32_t unknowns, const Integer& unit, Chain& chain) {
    for (std::uint32_t unknown = 0; unknown < unknowns; ++unknown) {
        std::vector<Integer> weights;
        for (std::size_t count = 2 + random() % 4; count > 0; --count) weights.emplace_back(1 + random() % 9);
        const Integer sum = std::accumulate(weights.begin(), weights.end(), Integer(0)) * unit;
        for (Integer& weight : weights) weight *= unit;
        if (unit > 1) {
            ++weights.front();
            --weights.back();
        }
        for (std::size_t at = 1; at < weights.size(); ++at) {
            chain.system.unknown.push_back(static_cast<std::uint32_t>(random() % unknowns));
            chain.system.number.push_back(static_cast<std::uint32_t>(chain.numbers.size()));
            chain.numbers.emplace_back(weights[at], sum);
        }
        const Rational first(weights.front(), sum);
        if (unknown > 0) {
            chain.system.unknown.push_back(unknown - 1);
            chain.system.number.push_back(static_cast<std::uint32_t>(chain.numbers.size()));
            chain.numbers.push_back(first);
        }
        chain.system.outside.push_back(unknown == 0 ? first : Rational(0));
        chain.system.constant.emplace_back(random() % 5, 1 + random() % 6);
        chain.system.first_entry.push_back(chain.system.unknown.size());
        chain.system.first_choice.push_back(static_cast<std::uint32_t>(chain.system.choices()));
        chain.policy.push_back(unknown);
    }
    chain.system.numbers = chain.numbers;
}

/// Solves the system by Gauss-Jordan elimination on the dense matrix 1 - A.
std::vector<Rational> dense_solution(const System<Rational>& system) {
    const std::size_t size = system.size();
    std::vector<std::vector<Rational>> matrix(size, std::vector<Rational>(size));
    std::vector<Rational> side = system.constant;
    for (std::size_t row = 0; row < size; ++row) {
        matrix[row][row] = 1;
        for (std::uint64_t entry = system.first_entry[row]; entry < system.first_entry[row + 1]; ++entry)
            matrix[row][system.unknown[entry]] -= system.numbers[system.number[entry]];
    }
    for (std::size_t pivot = 0; pivot < size; ++pivot) {
        std::size_t from = pivot;
        while (matrix[from][pivot] == 0) ++from;
        std::swap(matrix[from], matrix[pivot]);
        std::swap(side[from], side[pivot]);
        for (std::size_t row = 0; row < size; ++row) {
            if (row == pivot || matrix[row][pivot] == 0) continue;
            const Rational factor = matrix[row][pivot] / matrix[pivot][pivot];
            for (std::size_t column = pivot; column < size; ++column)
                matrix[row][column] -= factor * matrix[pivot][column];
            side[row] -= factor * side[pivot];
        }
    }
    for (std::size_t row = 0; row < size; ++row) side[row] /= matrix[row][row];
    return side;
}

void expect_as_by_elimination(std::uint32_t unknowns, const Integer& unit, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Chain chain;
    fill(random, unknowns, unit, chain);
    const auto lifted = lift_solution(chain.system, chain.policy, {});
    ASSERT_TRUE(lifted);
    EXPECT_EQ(*lifted, dense_solution(chain.system)) << unknowns << " unknowns, seed " << seed;
}

TEST(Lifting, AgreesWithElimination) {
    for (std::uint64_t seed = 0; seed < tests::rounds(120); ++seed)
        expect_as_by_elimination(static_cast<std::uint32_t>(1 + seed % 30), 1, seed);
}

TEST(Lifting, TriesOtherPrimesWhereOneDividesADenominator) {
    const Integer first = first_prime;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        expect_as_by_elimination(8, first, seed);
        expect_as_by_elimination(8, first * second_prime, seed);
        expect_as_by_elimination(8, first * second_prime * third_prime, seed);
    }
}

/// The equation is x0 = c + 1/2 x0. All digits of the constant are kept, including multiples of the prime.
TEST(Lifting, KeepsLongConstants) {
    const std::vector<Rational> numbers{Rational(1, 2)};
    System<Rational> system;
    system.unknown = {0};
    system.number = {0};
    system.first_entry = {0, 1};
    system.first_choice = {0, 1};
    system.outside = {Rational(1, 2)};
    system.numbers = numbers;
    for (const Rational& constant :
         {Rational(0), Rational(pow(Integer(10), 300) + 1), Rational(1, pow(Integer(first_prime), 9)),
          Rational(pow(Integer(first_prime), 9)), Rational(pow(Integer(7), 200), pow(Integer(3), 300))}) {
        system.constant = {constant};
        const auto solved = lift_solution(system, {0}, {});
        ASSERT_TRUE(solved);
        EXPECT_EQ(solved->front(), constant * 2);
    }
}

TEST(Lifting, HasNoAnswerWhereAPolicyStays) {
    const std::vector<Rational> numbers{Rational(1), Rational(1, 2)};
    System<Rational> system;  // 0 and 1 lead to each other, 1 may also leave
    system.unknown = {1, 0, 0};
    system.number = {0, 0, 1};
    system.first_entry = {0, 1, 2, 3};
    system.first_choice = {0, 1, 3};
    system.outside = {Rational(0), Rational(0), Rational(1, 2)};
    system.constant = {Rational(0), Rational(0), Rational(1, 2)};
    system.numbers = numbers;
    EXPECT_FALSE(lift_solution(system, {0, 1}, {}));
    const auto solved = lift_solution(system, {0, 2}, {});
    ASSERT_TRUE(solved);
    EXPECT_EQ(*solved, (std::vector<Rational>{1, 1}));
    EXPECT_FALSE(lift_solution(system, {0, 2}, {.operations = 1}));
}

}  // namespace
}  // namespace robochart::markov
