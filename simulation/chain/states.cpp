// SPDX-License-Identifier: Apache-2.0
#include "simulation/chain/states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/diagnostics/containers.hpp"

namespace robochart::simulation {

namespace {

double robot_share(std::uint32_t count, std::uint32_t robots) {
    return static_cast<double>(count) / static_cast<double>(robots);
}

}  // namespace

std::vector<std::uint32_t> robot_classes(const Scenario& scenario) {
    std::set<std::uint16_t> numbers;
    std::vector<const Measure*> measures;
    for (const Distinction& distinction : scenario.abstraction->distinctions) {
        const Measure& measure = scenario.measures[distinction.measure];
        if (measure.kind != MeasureKind::in_state) continue;
        measures.push_back(&measure);
        numbers.insert(measure.states.begin(), measure.states.end());
    }
    std::set<std::uint32_t> classes{0};
    for (const std::uint16_t number : numbers) {
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < measures.size(); ++i)
            if (std::ranges::find(measures[i]->states, number) != measures[i]->states.end())
                bits |= std::uint32_t{1} << i;
        classes.insert(bits);
    }
    return {classes.begin(), classes.end()};
}

ChainStates::ChainStates(const Scenario& scenario, std::optional<RobotSteps> steps)
    : scenario_(scenario), steps_(std::move(steps)) {
    for (const Distinction& distinction : scenario.abstraction->distinctions) find_classes(distinction);
    find_distributions(steps_ ? steps_->classes : robot_classes(scenario));
    Tuple so_far;
    find_states(0, so_far);
}

bool ChainStates::is_in_state(std::size_t distinction) const {
    return scenario_.measures[scenario_.abstraction->distinctions[distinction].measure].kind == MeasureKind::in_state;
}

void ChainStates::find_classes(const Distinction& distinction) {
    std::vector<MeasureClass>& found = classes_.emplace_back();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    if (dimension_of(scenario_.measures[distinction.measure].kind) != Dimension::share) {
        double low = -infinite;
        for (const double level : distinction.levels) {
            found.push_back({false, 0, 0, low, level});
            low = level;
        }
        found.push_back({false, 0, 0, low, infinite});
        return;
    }
    const std::uint32_t robots = scenario_.robots;
    if (robots >= most_states) throw TooManyStates(fmt::format("{} robots", robots));
    const auto level_of = [&](std::uint32_t count) {
        const auto& levels = distinction.levels;
        return std::ranges::lower_bound(levels, robot_share(count, robots)) - levels.begin();
    };
    for (std::uint32_t count = 0; count <= robots; ++count) {
        const bool same = count > 0 && !distinction.levels.empty() && level_of(count) == level_of(count - 1);
        if (!same) found.push_back({true, count, count, robot_share(count, robots), 0});
        found.back().most = count;
        found.back().high = robot_share(count, robots);
    }
}

void ChainStates::find_distributions(const std::vector<std::uint32_t>& classes) {
    constexpr std::size_t most_classes = 12;
    if (classes.size() > most_classes)
        throw TooManyStates(fmt::format("{} classes of states of a robot", classes.size()));
    Distribution so_far(classes.size());
    add_distributions(so_far, 0, scenario_.robots);
    for (const Distribution& distribution : distributions_)
        distributed_.push_back(project_distribution(distribution, classes));
    admitted_ = distributed_;
    diagnostics::sort_unique(admitted_);
}

void ChainStates::add_distributions(Distribution& so_far, std::size_t at, std::uint32_t left) {
    if (at + 1 == so_far.size()) {
        so_far[at] = left;
        if (distributions_.size() == most_distributions)
            throw TooManyStates(fmt::format("more than {} ways to distribute {} robots over {} classes",
                                            most_distributions, scenario_.robots, so_far.size()));
        distributions_.push_back(so_far);
        return;
    }
    for (std::uint32_t here = 0; here <= left; ++here) {
        so_far[at] = here;
        add_distributions(so_far, at + 1, left - here);
    }
}

ChainStates::Tuple ChainStates::project_distribution(const Distribution& robots,
                                                     const std::vector<std::uint32_t>& classes) const {
    Tuple result(classes_.size());
    std::uint32_t bit = 1;
    for (std::size_t d = 0; d < classes_.size(); ++d) {
        if (!is_in_state(d)) continue;
        std::uint32_t count = 0;
        for (std::size_t c = 0; c < classes.size(); ++c)
            if ((classes[c] & bit) != 0) count += robots[c];
        const auto found = std::ranges::find_if(classes_[d], [&](const MeasureClass& candidate) {
            return candidate.least <= count && count <= candidate.most;
        });
        result[d] = static_cast<std::size_t>(found - classes_[d].begin());
        bit <<= 1U;
    }
    return result;
}

ChainStates::Tuple ChainStates::robots_in(const Tuple& state) const {
    Tuple result = state;
    for (std::size_t d = 0; d < state.size(); ++d)
        if (!is_in_state(d)) result[d] = 0;
    return result;
}

bool ChainStates::is_admitted(const Tuple& state) const {
    return std::ranges::binary_search(admitted_, robots_in(state));
}

void ChainStates::find_states(std::size_t at, Tuple& so_far) {
    if (at == classes_.size()) {
        if (!is_admitted(so_far)) return;
        if (states_.size() == most_states) throw TooManyStates(fmt::format("more than {} states", most_states));
        states_.push_back(so_far);
        return;
    }
    so_far.push_back(0);
    for (std::size_t class_index = 0; class_index < classes_[at].size(); ++class_index) {
        so_far[at] = class_index;
        find_states(at + 1, so_far);
    }
    so_far.pop_back();
}

std::size_t ChainStates::find_state(const std::vector<double>& sample) const {
    Tuple tuple;
    for (std::size_t d = 0; d < classes_.size(); ++d) {
        const auto& classes = classes_[d];
        const auto found =
            std::ranges::find_if(classes, [&](const MeasureClass& candidate) { return sample[d] <= candidate.high; });
        if (found == classes.end()) return none;
        tuple.push_back(static_cast<std::size_t>(found - classes.begin()));
    }
    const auto found = std::ranges::lower_bound(states_, tuple);
    return found == states_.end() || *found != tuple ? none : static_cast<std::size_t>(found - states_.begin()) + 1;
}

namespace {

std::string class_text(const MeasureClass& values, std::uint32_t robots, std::string_view unit) {
    if (values.share) {
        if (values.least == values.most) return fmt::format("{} of {}", values.least, robots);
        return fmt::format("{} to {} of {}", values.least, values.most, robots);
    }
    if (std::isinf(values.low)) return fmt::format("up to {:g}{}", values.high, unit);
    if (std::isinf(values.high)) return fmt::format("above {:g}{}", values.low, unit);
    return fmt::format("{:g} to {:g}{}", values.low, values.high, unit);
}

}  // namespace

std::string ChainStates::state_text(std::size_t state) const {
    if (state == start) return "start";
    std::string result;
    for (std::size_t d = 0; d < classes_.size(); ++d) {
        const Measure& measure = scenario_.measures[scenario_.abstraction->distinctions[d].measure];
        const MeasureClass& here = classes_[d][states_[state - 1][d]];
        const std::string_view unit = printed_unit(dimension_of(measure.kind));
        result += fmt::format("{}{} {}", result.empty() ? "" : ", ", measure.name.text,
                              class_text(here, scenario_.robots, unit));
    }
    return result;
}

std::optional<MeasureClass> ChainStates::class_of_measure(std::size_t state, std::size_t measure) const {
    const auto& distinctions = scenario_.abstraction->distinctions;
    for (std::size_t d = 0; d < distinctions.size() && state != start; ++d)
        if (distinctions[d].measure == measure) return classes_[d][states_[state - 1][d]];
    return std::nullopt;
}

namespace {

/// Returns true if all values of a class are in the band, false if none is, and otherwise no value.
std::optional<bool> is_class_within(const MeasureClass& values, double low, double high, std::uint32_t robots) {
    if (!values.share) {
        if (low <= values.low && values.high <= high) return true;
        if (values.high < low || high <= values.low) return false;
        return std::nullopt;
    }
    std::uint32_t inside = 0;
    for (std::uint32_t count = values.least; count <= values.most; ++count)
        if (low <= robot_share(count, robots) && robot_share(count, robots) <= high) ++inside;
    if (inside == 0) return false;
    return inside == values.most - values.least + 1 ? std::optional(true) : std::nullopt;
}

}  // namespace

/// Evaluates a condition in three-valued logic (Kleene).
std::optional<bool> ChainStates::holds_in(const Formula& formula, std::size_t state) const {
    switch (formula.kind) {
        case Formula::Kind::compare: {
            const auto values = class_of_measure(state, formula.measure);
            return values ? is_class_within(*values, formula.low, formula.high, scenario_.robots) : std::nullopt;
        }
        case Formula::Kind::negation: {
            const auto part = holds_in(formula.parts.front(), state);
            return part ? std::optional(!*part) : std::nullopt;
        }
        case Formula::Kind::both:
        case Formula::Kind::either: {
            const bool decisive = formula.kind == Formula::Kind::either;
            std::optional<bool> result = !decisive;
            for (const Formula& operand : formula.parts) {
                const auto part = holds_in(operand, state);
                if (part == decisive) return decisive;
                if (!part) result = std::nullopt;
            }
            return result;
        }
        case Formula::Kind::stays:
        case Formula::Kind::at:
        case Formula::Kind::within:
        case Formula::Kind::until:
        case Formula::Kind::always:
            break;
    }
    return std::nullopt;  // the formula refers to the past
}

std::optional<std::vector<bool>> ChainStates::states_satisfying(const Formula& condition) const {
    std::vector<bool> result{false};
    for (std::size_t state = 1; state < size(); ++state) {
        const auto here = holds_in(condition, state);
        if (!here) return std::nullopt;
        result.push_back(*here);
    }
    return result;
}

bool ChainStates::admits_step(const Distribution& before, const Distribution& behind) const {
    const std::size_t count = before.size();
    for (std::uint32_t set = 1; set < std::uint32_t{1} << count; ++set) {
        std::uint32_t inside = 0;
        std::uint32_t behind_them = 0;
        for (std::size_t to = 0; to < count; ++to) {
            bool follows = false;
            for (std::size_t from = 0; from < count; ++from)
                follows = follows || ((set >> from & 1U) != 0 && steps_->after[from][to]);
            if (follows) behind_them += behind[to];
            if ((set >> to & 1U) != 0) inside += before[to];
        }
        if (inside > behind_them) return false;
    }
    return true;
}

statistics::Permitted ChainStates::permitted_transitions(diagnostics::Budget* budget) const {
    statistics::Permitted result = statistics::all_permitted(size());
    const auto number = [&](const Tuple& robots) {
        return static_cast<std::size_t>(std::ranges::lower_bound(admitted_, robots) - admitted_.begin());
    };
    std::vector<bool> first(admitted_.size(), !steps_);
    statistics::Permitted follows(admitted_.size(), std::vector<bool>(admitted_.size(), !steps_));
    for (std::size_t from = 0; from < distributions_.size() && steps_; ++from) {
        if (budget != nullptr) budget->poll();
        bool begins = true;
        for (std::size_t c = 0; c < steps_->classes.size(); ++c)
            begins = begins && (distributions_[from][c] == 0 || steps_->first[c]);
        const std::size_t source = number(distributed_[from]);
        if (begins) first[source] = true;
        for (std::size_t to = 0; to < distributions_.size(); ++to) {
            const std::size_t target = number(distributed_[to]);
            if (!follows[source][target])
                follows[source][target] = admits_step(distributions_[from], distributions_[to]);
        }
    }
    for (std::vector<bool>& row : follows)
        if (std::ranges::find(row, true) == row.end()) row.assign(row.size(), true);
    for (std::size_t to = 0; to < size(); ++to) {
        const std::size_t target = to == start ? 0 : number(robots_in(states_[to - 1]));
        for (std::size_t from = 0; from < size(); ++from)
            result[from][to] =
                to != start && (from == start ? first[target] : follows[number(robots_in(states_[from - 1]))][target]);
    }
    return result;
}

}  // namespace robochart::simulation
