// SPDX-License-Identifier: Apache-2.0
// Chooses a number of the carrier, the code, for each number of a log. Statement: if all comparisons that the component
// makes have the same answers for the codes as for the logged numbers, then renaming logged numbers to codes is an
// isomorphism between the runs of the model with these inputs, because the component otherwise only passes numbers on
// (Lazić 1999, data independence with tests; the order is one of the tests).
//
// Reals are decimals. If all of them have few digits, the code of a number is the number itself in a fine enough unit,
// and all answers agree. Otherwise codes are rounded, but keep their order, and the answers of comparisons of sums are
// compared for all numbers of the log.
#include "conformance/traces/logged_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "conformance/traces/more_numbers.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/ir/comparison.hpp"
#include "semantics/ir/dump.hpp"

namespace robochart::conformance {

namespace {

using ir::TypeKind;

/// Codes stay exact in double, and sums of a few codes stay in 64 bits.
constexpr double greatest_code = 9e15;
/// The most combinations of numbers for which the answers of a comparison are examined.
constexpr double most_combinations = 4e6;
/// The most values of a type with parts.
constexpr std::size_t most_values = 1U << 14U;

struct CodedNumber {
    double value = 0;
    std::int64_t code = 0;
};

/// Whether a code stands for exactly this decimal number.
bool is_exact(const CodedNumber& number, std::int64_t scale) {
    return static_cast<double>(number.code) / static_cast<double>(scale) == number.value;
}

/// The value of a sum, from left to right. Held numbers are taken from `held`, which is advanced.
template <class Number, class Constant>
Number add_up(const std::vector<TestedSummand>& sum, std::span<const Number>& held, const Constant& constant) {
    Number result{};
    bool first = true;
    for (const TestedSummand& summand : sum) {
        Number number{};
        if (summand.constant) {
            number = constant(*summand.constant);
        } else {
            number = held.front();
            held = held.subspan(1);
        }
        if (summand.subtracted)
            result -= number;
        else
            result = first ? number : result + number;
        first = false;
    }
    return result;
}

std::size_t count_held(const ComparedSums& comparison) {
    const auto held = [](const TestedSummand& summand) { return !summand.constant; };
    return static_cast<std::size_t>(std::ranges::count_if(comparison.left, held) +
                                    std::ranges::count_if(comparison.right, held));
}

/// Compares the answers of one comparison for logged numbers, codes and numbers of type double.
class AnswerCheck {
public:
    AnswerCheck(const ComparedSums& comparison, std::int64_t scale) : comparison_(comparison), scale_(scale) {}

    /// Whether the codes have the answer of the logged numbers.
    bool agree(const std::vector<const CodedNumber*>& numbers) {
        codes_.clear();
        values_.clear();
        for (const CodedNumber* number : numbers) {
            codes_.push_back(number->code);
            values_.push_back(number->value);
        }
        std::span<const std::int64_t> codes(codes_);
        const auto unit = static_cast<double>(scale_);
        const auto code_of = [&](double constant) { return std::int64_t{std::llround(constant * unit)}; };
        const std::int64_t left = add_up(comparison_.left, codes, code_of);
        const std::int64_t right = add_up(comparison_.right, codes, code_of);
        answer_ = ir::comparison_answer(comparison_.relation, left <=> right);
        const auto exact = [&](const CodedNumber* number) { return is_exact(*number, scale_); };
        return std::ranges::all_of(numbers, exact) || has_sign(left < right ? -1 : static_cast<int>(right < left));
    }

    /// After `agree`: the comparison, if code with numbers of type double answers it differently.
    [[nodiscard]] std::string rounding() const {
        std::span<const double> values(values_);
        const auto same = [](double constant) { return constant; };
        const double left = add_up(comparison_.left, values, same);
        const double right = add_up(comparison_.right, values, same);
        if (ir::comparison_answer(comparison_.relation, left <=> right) == answer_) return "";
        std::span<const double> shown(values_);
        const std::string left_text = text_of(comparison_.left, shown);
        return fmt::format("{} {} {}", left_text, ir::operator_text(comparison_.relation),
                           text_of(comparison_.right, shown));
    }

private:
    /// Whether the difference of the sums of logged numbers has this sign for every rounding error of their
    /// decimals.
    [[nodiscard]] bool has_sign(int sign) const {
        std::vector<long double> wide(values_.begin(), values_.end());
        std::span<const long double> values(wide);
        const auto same = [](double constant) { return static_cast<long double>(constant); };
        const long double left = add_up(comparison_.left, values, same);
        const long double difference = left - add_up(comparison_.right, values, same);
        long double size = 0;
        for (const double value : values_) size += std::abs(value);
        for (const std::vector<TestedSummand>* side : {&comparison_.left, &comparison_.right})
            for (const TestedSummand& summand : *side) size += std::abs(summand.constant.value_or(0));
        if (difference == 0) return sign == 0;
        if (std::abs(difference) <= 1e-15L * size) return false;
        return sign == (difference < 0 ? -1 : 1);
    }

    static std::string text_of(const std::vector<TestedSummand>& sum, std::span<const double>& values) {
        std::string text;
        for (const TestedSummand& summand : sum) {
            const double number = summand.constant ? *summand.constant : values.front();
            if (!summand.constant) values = values.subspan(1);
            text += fmt::format("{}{}", text.empty() ? "" : summand.subtracted ? " - " : " + ", number);
        }
        return text;
    }

    const ComparedSums& comparison_;
    std::int64_t scale_;
    std::vector<std::int64_t> codes_;
    std::vector<double> values_;
    bool answer_ = false;
};

/// The carriers and codes for one log.
class LogCarriers {
public:
    LogCarriers(const ir::System& system, const ir::Instantiation& instantiation, const TestedNumbers& tested,
                const LoggedNumbers& logged, std::string& cause)
        : system_(system), base_(instantiation), tested_(tested), logged_(logged), cause_(cause) {}

    std::optional<ExactNumbers> choose() {
        for (const auto& [kind, numbers] : logged_)
            if (numbers.size() > most_logged_numbers) {
                cause_ = fmt::format("the log has more than {} different numbers of this type", most_logged_numbers);
                return std::nullopt;
            }
        const auto reals = logged_.find(TypeKind::real);
        const std::int64_t factor = reals == logged_.end() ? 1 : fine_unit(reals->second);
        result_.instantiation = in_finer_units(system_, base_, factor);
        for (const auto& [kind, numbers] : logged_)
            if (!add_codes(kind, numbers)) {
                cause_ = "the log has numbers that are too large, or too close to each other";
                return std::nullopt;
            }
        for (const ComparedSums& comparison : tested_.sums)
            if (!compare_answers(comparison)) return std::nullopt;
        return std::move(result_);
    }

private:
    /// The factor of the coarsest unit in which all numbers are whole, or of the finest possible unit.
    [[nodiscard]] std::int64_t fine_unit(const std::set<double>& numbers) const {
        double size = 1;
        for (const double number : numbers) size = std::max(size, std::abs(number));
        for (const double constant : compared_constants(TypeKind::real)) size = std::max(size, std::abs(constant));
        for (const std::int64_t number : base_.real)
            size = std::max(size, std::abs(static_cast<double>(number)) / static_cast<double>(base_.scale));
        std::int64_t factor = 1;
        const auto scale = [&] { return base_.scale * factor; };
        const auto whole = [&](double number) {
            return is_exact({number, std::llround(number * static_cast<double>(scale()))}, scale());
        };
        while (size * static_cast<double>(scale()) * 10 < greatest_code && !std::ranges::all_of(numbers, whole))
            factor *= 10;
        return factor;
    }

    /// The constants with which single reals are compared. Whole numbers are their own codes, so they have the right
    /// order with all constants.
    [[nodiscard]] std::vector<double> compared_constants(TypeKind kind) const {
        const auto found = tested_.constants.find(kind);
        if (kind != TypeKind::real || found == tested_.constants.end()) return {};
        return found->second.all;
    }

    std::vector<std::int64_t>& carrier(TypeKind kind) {
        ir::Instantiation& instantiation = result_.instantiation;
        if (kind == TypeKind::nat) return instantiation.nat;
        return kind == TypeKind::integer ? instantiation.integer : instantiation.real;
    }
    [[nodiscard]] std::int64_t scale(TypeKind kind) const {
        return kind == TypeKind::real ? result_.instantiation.scale : 1;
    }

    /// Adds the numbers to the carrier. Codes are ascending, and numbers of the carrier are their own codes.
    bool add_codes(TypeKind kind, const std::set<double>& numbers) {
        const auto unit = static_cast<double>(scale(kind));
        std::map<double, std::optional<std::int64_t>> all;
        for (const double number : numbers) all[number];
        for (const double constant : compared_constants(kind)) all[constant] = std::llround(constant * unit);
        for (const std::int64_t number : carrier(kind)) all[static_cast<double>(number) / unit] = number;
        std::vector<CodedNumber>& coded = coded_[kind];
        for (const auto& [number, fixed] : all) {
            if (std::abs(number * unit) > greatest_code) return false;
            std::int64_t code = fixed.value_or(std::llround(number * unit));
            if (!coded.empty() && code <= coded.back().code) {
                code = coded.back().code + 1;
                if (fixed) return false;
            }
            coded.push_back({number, code});
            if (numbers.contains(number)) result_.codes.emplace(std::pair{kind, number}, code);
        }
        carrier(kind).clear();
        for (const CodedNumber& number : coded) carrier(kind).push_back(number.code);
        return true;
    }

    /// Compares the answers for all combinations of numbers.
    bool compare_answers(const ComparedSums& comparison) {
        const auto found = coded_.find(comparison.kind);
        const bool sums = comparison.left.size() > 1 || comparison.right.size() > 1;
        // codes have the order of the numbers; whole numbers are their own codes
        if (found == coded_.end() || !sums || comparison.kind != TypeKind::real) return true;
        const std::vector<CodedNumber>& numbers = found->second;
        const std::size_t held = count_held(comparison);
        if (std::pow(static_cast<double>(numbers.size()), static_cast<double>(held)) > most_combinations) {
            cause_ = "the log has too many different numbers for the sums that the model compares";
            return false;
        }
        AnswerCheck check(comparison, result_.instantiation.scale);
        std::vector<std::size_t> places(held, 0);
        std::vector<const CodedNumber*> chosen(held, &numbers.front());
        for (bool more = true; more; more = advance(places, chosen, numbers)) {
            base_.poll();
            if (!check.agree(chosen)) {
                cause_ = "a sum of numbers of the log is too close to a boundary of a condition";
                return false;
            }
            if (result_.rounding.empty()) result_.rounding = check.rounding();
        }
        return true;
    }

    /// The next combination; false after the last one.
    static bool advance(std::vector<std::size_t>& places, std::vector<const CodedNumber*>& chosen,
                        const std::vector<CodedNumber>& numbers) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            places[i] = (places[i] + 1) % numbers.size();
            chosen[i] = &numbers[places[i]];
            if (places[i] != 0) return true;
        }
        return false;
    }

    const ir::System& system_;
    const ir::Instantiation& base_;
    const TestedNumbers& tested_;
    const LoggedNumbers& logged_;
    std::string& cause_;
    std::map<TypeKind, std::vector<CodedNumber>> coded_;
    ExactNumbers result_;
};

/// Whether the types of inputs and outputs have few enough values.
bool are_few_values(const ir::System& system, const ir::Instantiation& instantiation, const ModelInterface& boundary) {
    const auto fits = [&](ir::TypeId type) {
        if (!cpp_emit::is_composed(system.type(type))) return true;
        try {
            (void)ir::carrier_values(system, instantiation, type, most_values);
            return true;
        } catch (const std::length_error&) {
            return false;
        }
    };
    const bool inputs = std::ranges::all_of(
        boundary.input_types, [&](const std::optional<ir::TypeId>& type) { return !type || fits(*type); });
    return inputs && std::ranges::all_of(boundary.output_types, [&](const std::vector<ir::TypeId>& types) {
               return std::ranges::all_of(types, fits);
           });
}

}  // namespace

std::optional<ExactNumbers> with_logged_numbers(const ir::System& system, const ir::Instantiation& instantiation,
                                                const ModelInterface& boundary, const LoggedNumbers& logged,
                                                std::string& cause) {
    auto result = LogCarriers(system, instantiation, boundary.numbers, logged, cause).choose();
    if (!result) return std::nullopt;
    if (are_few_values(system, result->instantiation, boundary)) return result;
    cause = "the types with parts have too many values with the numbers of the log";
    return std::nullopt;
}

}  // namespace robochart::conformance
