// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/guess.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "prism/markov/solve/arithmetic.hpp"

namespace robochart::markov {
namespace {

/// The numbers e >= 0 with excess + e * growth <= 0, as an interval from `least` to `most`; empty if least > most.
struct Scales {
    double least = 0;
    double most = infinity;
};

/// Returns the scales for arguments that have been rounded up. The results are also rounded to the safe side.
Scales scales_for(double excess, double growth) {
    if (growth < 0) return {excess > 0 ? excess / -growth : 0, infinity};
    if (excess > 0) return {infinity, 0};
    return {0, growth > 0 ? -(excess / growth) : infinity};
}

class Proof {
public:
    Proof(const System<Interval>& system, Direction direction, const Guesses& guesses)
        : system_(system), direction_(direction), guesses_(guesses) {}

    /// Returns a scale for which the proof succeeds. No value if there is none.
    std::optional<double> find_scale() {
        for (std::uint32_t unknown = 0; unknown < system_.size(); ++unknown) {
            Scales one{infinity, 0};  // for the bound for which one choice suffices
            for (std::uint32_t choice = system_.first_choice[unknown]; choice < system_.first_choice[unknown + 1];
                 ++choice) {
                const auto [above, below] = choice_bounds(unknown, choice);
                const bool greatest = direction_ == Direction::maximum;
                require_scales(greatest ? above : below);
                const Scales& enough = greatest ? below : above;
                if (enough.least < one.least) one = enough;
            }
            require_scales(one);
            if (!(all_.least <= all_.most)) return std::nullopt;
        }
        if (!(all_.least < infinity)) return std::nullopt;
        return all_.least;
    }

private:
    struct Bounds {
        Scales above;
        Scales below;
    };

    Bounds choice_bounds(std::uint32_t unknown, std::uint32_t choice) const {
        double high = system_.constant[choice].high;
        double negated_low = system_.constant[choice].negated_low;
        double weight = 0;
        for (std::uint64_t entry = system_.first_entry[choice]; entry < system_.first_entry[choice + 1]; ++entry) {
            const Interval& factor = system_.numbers[system_.number[entry]];
            const Guess& guess = guesses_[system_.unknown[entry]];
            high += factor.high * guess.high;
            negated_low += factor.negated_low * guess.low;  // -(p * x) rounded up, because guesses are not negative
            weight += factor.high * guess.weight;
        }
        const Guess& own = guesses_[unknown];
        const double growth = weight - own.weight;
        return {scales_for(high - own.high, growth), scales_for(negated_low + own.low, growth)};
    }

    void require_scales(const Scales& scales) {
        all_.least = std::max(all_.least, scales.least);
        all_.most = std::min(all_.most, scales.most);
    }

    const System<Interval>& system_;
    const Direction direction_;
    const Guesses& guesses_;
    Scales all_;
};

}  // namespace

std::optional<std::vector<Interval>> prove(const System<Interval>& system, Direction direction, const Guesses& guesses,
                                           double most) {
    const auto usable = [](const Guess& guess) {
        return guess.low >= 0 && guess.high >= 0 && guess.weight >= 0 && guess.low < infinity &&
               guess.high < infinity && guess.weight < infinity;
    };
    if (!std::ranges::all_of(guesses, usable)) return std::nullopt;
    const std::optional<double> scale = Proof(system, direction, guesses).find_scale();
    if (!scale) return std::nullopt;
    std::vector<Interval> values(guesses.size());
    for (std::size_t unknown = 0; unknown < values.size(); ++unknown) {
        const Guess& guess = guesses[unknown];
        values[unknown].negated_low = std::min(*scale * guess.weight - guess.low, 0.0);
        values[unknown].high = std::min(*scale * guess.weight + guess.high, most);
    }
    return values;
}

double relative_width(const std::vector<Interval>& values) {
    double width = 0;
    for (const Interval& value : values)
        if (!(value.high == -value.negated_low))
            width = std::max(width, value.high == infinity ? infinity : (value.high + value.negated_low) / value.high);
    return width;
}

GuessIteration::GuessIteration(const System<Interval>& system, Direction direction)
    : system_(system), direction_(direction), guesses_(system.size()) {
    numbers_.reserve(system.numbers.size());
    for (const Interval& number : system.numbers) numbers_.push_back(number.middle());
}

GuessIteration::Worth GuessIteration::choice_worth(std::uint32_t unknown, std::uint32_t choice) const {
    Worth sum{system_.constant[choice].low(), system_.constant[choice].high, 0, system_.outside[choice].middle()};
    for (std::uint64_t entry = system_.first_entry[choice]; entry < system_.first_entry[choice + 1]; ++entry) {
        const std::uint32_t to = system_.unknown[entry];
        if (to == unknown) continue;
        const double factor = numbers_[system_.number[entry]];
        sum.low += factor * guesses_[to].low;
        sum.high += factor * guesses_[to].high;
        sum.weight += factor * guesses_[to].weight;
        sum.leaving += factor;
    }
    sum.low /= sum.leaving;
    sum.high /= sum.leaving;
    return sum;
}

Guess GuessIteration::improve_guess(std::uint32_t unknown) {
    offers_.clear();
    for (std::uint32_t choice = system_.first_choice[unknown]; choice < system_.first_choice[unknown + 1]; ++choice)
        offers_.push_back(choice_worth(unknown, choice));
    Guess result{offers_.front().low, offers_.front().high, 0};
    for (const Worth& offer : offers_) {
        result.low = best_of(result.low, offer.low, direction_);
        result.high = best_of(result.high, offer.high, direction_);
    }
    for (const Worth& offer : offers_)
        if (std::abs(offer.high - result.high) <= tie_ * result.high)
            result.weight = std::max(result.weight, (result.high + offer.weight) / offer.leaving);
    return result;
}

double GuessIteration::sweep() {
    double change = 0;
    for (std::uint32_t unknown = static_cast<std::uint32_t>(system_.size()); unknown-- > 0;) {
        const Guess now = improve_guess(unknown);
        Guess& before = guesses_[unknown];
        if (now.high != before.high) change = std::max(change, std::abs(now.high - before.high) / now.high);
        if (now.weight != before.weight) change = std::max(change, std::abs(now.weight - before.weight) / now.weight);
        before = now;
    }
    return change;
}

Policy GuessIteration::policy() const {
    Policy policy(system_.size());
    for (std::uint32_t unknown = 0; unknown < system_.size(); ++unknown) {
        policy[unknown] = system_.first_choice[unknown];
        double value = choice_worth(unknown, policy[unknown]).high;
        for (std::uint32_t choice = policy[unknown] + 1; choice < system_.first_choice[unknown + 1]; ++choice) {
            const double offered = choice_worth(unknown, choice).high;
            if (!is_better(offered, value, direction_)) continue;
            value = offered;
            policy[unknown] = choice;
        }
    }
    return policy;
}

}  // namespace robochart::markov
