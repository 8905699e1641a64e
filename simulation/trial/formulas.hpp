// Formulas along a trial: evaluated at each instant as it comes, so that a trial can end when its answer is known. The
// three values of bounded temporal logic on a run that goes on (Bauer, Leucker, Schallhart, "Runtime verification for
// LTL and TLTL", TOSEM 20, 2011): true, false, not yet known.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

/// What a measure is now; asked only where it matters.
using MeasureNow = std::function<double(std::size_t measure)>;

/// A formula of an instant.
class Condition {
public:
    /// Keeps a reference to the formula.
    Condition(const Formula&, double control_step);

    /// Does it hold after this many steps? To be asked at each, in order.
    [[nodiscard]] bool holds(std::uint64_t step, const MeasureNow&);

private:
    [[nodiscard]] bool holds(const Formula&, std::uint64_t step, const MeasureNow&, std::size_t& stay);

    static constexpr std::uint64_t never = ~std::uint64_t{0};
    const Formula& formula_;
    double control_step_;
    std::vector<std::uint64_t>
        since_;  ///< of each `stays`, in the order of the text: the step since which its part holds
};

/// When and how a formula of a trial was decided.
struct Answer {
    std::optional<bool> holds;
    std::uint64_t step = 0;  ///< after how many it was known
    bool taken = false;      ///< it was not: the trial was stopped, and it is taken for this

    friend bool operator==(const Answer&, const Answer&) = default;
};

/// A formula of a trial.
class Property {
public:
    /// Keeps a reference to the formula. `end`: the steps of the trial.
    Property(const Formula&, double control_step, std::uint64_t end);

    /// Does the instant after this many steps matter?
    [[nodiscard]] bool due(std::uint64_t step) const;
    void look(std::uint64_t step, const MeasureNow&);
    [[nodiscard]] const Answer& answer() const { return answer_; }
    /// The trial ended after so many steps; what is not known by then is taken for this.
    void end(std::uint64_t step, bool holds);

private:
    /// `at`, `within`, `until` or `always`.
    struct Timed {
        const Formula* formula = nullptr;
        std::uint64_t last = 0;  ///< the step by which it is known
        std::vector<Condition> parts;
        std::optional<bool> holds;
    };
    void collect(const Formula&, double control_step, std::uint64_t end);
    static void look(Timed&, std::uint64_t step, const MeasureNow&);
    [[nodiscard]] std::optional<bool> value(const Formula&, std::size_t& timed) const;

    const Formula& formula_;
    std::vector<Timed> timed_;  ///< in the order of the text
    Answer answer_;
};

}  // namespace robochart::simulation
