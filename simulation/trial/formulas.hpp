// SPDX-License-Identifier: Apache-2.0
// Evaluates formulas on a trial at each instant during the trial, so that the trial can end when its answer is known.
// The semantics is that of bounded temporal logic on a run that continues (Bauer, Leucker, Schallhart, "Runtime
// verification for LTL and TLTL", TOSEM 20, 2011), with three values: true, false, not yet known.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

/// Returns the current value of a measure; called only if it is needed.
using MeasureNow = std::function<double(std::size_t measure)>;

/// Evaluates a formula on an instant.
class Condition {
public:
    /// Stores a reference to the formula.
    Condition(const Formula&, double control_step);

    /// Returns true if the formula is true after this number of steps. Must be called for each step, in order.
    [[nodiscard]] bool holds_after(std::uint64_t step, const MeasureNow&);

private:
    [[nodiscard]] bool holds_after(const Formula&, std::uint64_t step, const MeasureNow&, std::size_t& stay);

    static constexpr std::uint64_t never = ~std::uint64_t{0};
    const Formula& formula_;
    double control_step_;
    std::vector<std::uint64_t>
        since_;  ///< for each `stays`, in the order of the text: the step since which its part has been true
};

/// When and how a formula on a trial was decided.
struct Answer {
    std::optional<bool> holds;
    std::uint64_t step = 0;  ///< the number of steps after which the value was known
    bool taken = false;      ///< the trial stopped before the value was known; this value is assumed

    friend bool operator==(const Answer&, const Answer&) = default;
};

/// Evaluates a formula on a trial.
class Property {
public:
    /// Stores a reference to the formula. `end`: the number of steps of the trial.
    Property(const Formula&, double control_step, std::uint64_t end);

    /// True if the instant after this number of steps must be evaluated.
    [[nodiscard]] bool is_due(std::uint64_t step) const;
    void evaluate_at(std::uint64_t step, const MeasureNow&);
    [[nodiscard]] const Answer& answer() const { return answer_; }
    /// Must be called when the trial ends, with the number of its steps. If the formula is not decided, `holds` becomes
    /// its value.
    void end(std::uint64_t step, bool holds);

private:
    /// `at`, `within`, `until` or `always`.
    struct Timed {
        const Formula* formula = nullptr;
        std::uint64_t last = 0;  ///< the step at which the value is known at the latest
        std::vector<Condition> parts;
        std::optional<bool> holds;
    };
    void collect_timed(const Formula&, double control_step, std::uint64_t end);
    static void evaluate_at(Timed&, std::uint64_t step, const MeasureNow&);
    [[nodiscard]] std::optional<bool> known_value(const Formula&, std::size_t& timed) const;

    const Formula& formula_;
    std::vector<Timed> timed_;  ///< in textual order
    Answer answer_;
};

}  // namespace robochart::simulation
