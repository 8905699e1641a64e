// SPDX-License-Identifier: Apache-2.0
#include "conformance/check/window_thresholds.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/text.hpp"
#include "conformance/check/compared_numbers.hpp"
#include "conformance/check/numbers_to_try.hpp"
#include "conformance/model/rules.hpp"
#include "semantics/evaluate/evaluate.hpp"
#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/comparison.hpp"
#include "semantics/ir/number_parts.hpp"
#include "semantics/ir/numbers.hpp"

namespace robochart::conformance {

namespace {

using ir::ExprKind;

/// An operand without variables, in units; no value if it has other operations than sums, differences and multiples.
/// Recursion depth: the depth of the expression.
std::optional<std::int64_t> units_of(const ir::System& system, const ir::ModelComparison& comparison,
                                     const ir::Expr& expr, std::int64_t scale) {
    const bool real = system.type(expr.type).kind == ir::TypeKind::real;
    const auto units = [&](std::size_t i) { return units_of(system, comparison, *expr.args.at(i), scale); };
    if (const auto found = comparison.constants.find(&expr); found != comparison.constants.end())
        return real ? found->second : ir::checked_multiply(found->second, scale);
    if (expr.kind == ExprKind::real) return ir::scale_decimal(expr.decimal, scale);
    if (expr.kind == ExprKind::integer) return ir::checked_multiply(expr.number, scale);
    if (expr.kind == ExprKind::cast) return units(0);
    if (expr.kind == ExprKind::negate) {
        const auto negated = units(0);
        return negated ? ir::checked_subtract(0, *negated) : std::nullopt;
    }
    if (expr.kind != ExprKind::plus && expr.kind != ExprKind::minus && expr.kind != ExprKind::times)
        return std::nullopt;
    const auto a = units(0), b = units(1);
    if (!a || !b) return std::nullopt;
    if (expr.kind == ExprKind::plus) return ir::checked_add(*a, *b);
    if (expr.kind == ExprKind::minus) return ir::checked_subtract(*a, *b);
    const auto product = ir::checked_multiply(*a, *b);
    return product && *product % scale == 0 ? std::optional(*product / scale) : std::nullopt;
}

/// The same comparison with the operands exchanged.
ExprKind exchanged(ExprKind kind) {
    if (kind == ExprKind::less) return ExprKind::greater;
    if (kind == ExprKind::less_equal) return ExprKind::greater_equal;
    if (kind == ExprKind::greater) return ExprKind::less;
    if (kind == ExprKind::greater_equal) return ExprKind::less_equal;
    return kind;
}

/// A comparison of the number in a window with a threshold.
struct Threshold {
    ExprKind kind = ExprKind::less;  ///< the window is the left operand
    std::int64_t units = 0;
    double computed = 0;  ///< by the code
};

class ThresholdTest {
public:
    ThresholdTest(const ir::System& system, const ir::ValueModel& values, const diagnostics::SourceManager& sources)
        : system_(system), values_(values), sources_(sources) {}

    void run(Result& result, bool rounding_allowed) const {
        std::string inherent;
        for (const ir::ModelComparison& comparison : values_.comparisons) {
            const auto threshold = threshold_of(comparison);
            if (!threshold) continue;
            const double nearest = nearest_double(ir::decimal_text(threshold->units, values_.scale));
            constexpr double infinity = std::numeric_limits<double>::infinity();
            const std::array numbers{std::nextafter(nearest, -infinity), nearest, std::nextafter(nearest, infinity)};
            for (const int side : {0, -1, 1}) {
                const double number = numbers[static_cast<std::size_t>(side + 1)];
                const bool meant = ir::comparison_answer(threshold->kind, side <=> 0);
                const bool found = ir::comparison_answer(threshold->kind, number <=> threshold->computed);
                if (meant == found) continue;
                const std::string text =
                    side == 0 ? ir::decimal_text(threshold->units, values_.scale) : fmt::format("{}", number);
                const std::string difference = fmt::format(
                    "`{}` is {} for a window with the number {}, but {} in the code, which compares {} with {}",
                    text_of(*comparison.expr), meant, text, found, number, threshold->computed);
                if (side == 0) return report(result, *comparison.expr, difference, rounding_allowed);
                if (inherent.empty()) inherent = difference;
            }
        }
        if (!inherent.empty()) set_difference(result, inherent);
    }

private:
    /// No value if the comparison does not compare a window of a sequence with a real number that the code computes.
    [[nodiscard]] std::optional<Threshold> threshold_of(const ir::ModelComparison& comparison) const {
        if (!ir::is_number_sequence(system_, comparison.type)) return std::nullopt;
        for (const std::size_t side : {0U, 1U}) {
            const ir::Expr& expr = *comparison.expr->args.at(side);
            if (system_.type(expr.type).kind != ir::TypeKind::real) return std::nullopt;
            const auto units = units_of(system_, comparison, expr, values_.scale);
            if (!units) continue;
            const auto computed = constant_on_robot(system_, comparison, values_.scale, expr);
            if (!computed) continue;
            const ExprKind kind = comparison.expr->kind;
            return Threshold{side == 1 ? kind : exchanged(kind), *units, *computed};
        }
        return std::nullopt;
    }

    [[nodiscard]] std::string text_of(const ir::Expr& expr) const {
        if (!expr.span.is_known()) return "a condition";
        const std::string_view source = sources_.source_text(expr.span.source);
        return diagnostics::escape_for_display(
            diagnostics::on_one_line(source.substr(expr.span.begin, expr.span.end - expr.span.begin)));
    }

    static void set_difference(Result& result, const std::string& difference) {
        RobotNumbers& robot = result.robot.emplace();
        robot.numbers = 3;
        robot.regions = 3;
        robot.difference = difference;
    }

    void report(Result& result, const ir::Expr& expr, const std::string& difference, bool rounding_allowed) const {
        set_difference(result, difference);
        if (rounding_allowed) return;
        result.outcome = Outcome::rounds;
        result.reason = difference;
        result.explanation.rule = &rules::rounded;
        if (expr.span.is_known())
            result.explanation.where.push_back(
                fmt::format("`{}` ({})", text_of(expr), sources_.path_and_line(expr.span)));
    }

    const ir::System& system_;
    const ir::ValueModel& values_;
    const diagnostics::SourceManager& sources_;
};

}  // namespace

void test_window_thresholds(Result& result, const ir::System& system, const ir::ValueModel& values,
                            const diagnostics::SourceManager& sources, bool rounding_allowed) {
    ThresholdTest(system, values, sources).run(result, rounding_allowed);
}

}  // namespace robochart::conformance
