// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/windows.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>

#include "base/diagnostics/containers.hpp"
#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

constexpr std::size_t most_candidates = 5'000;
/// With this limit, the numbers next to a threshold fit into 64 bits.
constexpr std::int64_t greatest_threshold = std::int64_t{1} << 56U;

bool is_toolkit(const Expr& expr, std::string_view function) {
    return expr.kind == ExprKind::toolkit && expr.text == function;
}

const Expr& without_casts(const Expr& expr) {
    const Expr* at = &expr;
    while (at->kind == ExprKind::cast) at = at->args.at(0).get();
    return *at;
}

bool is_place(const Expr& expr) {
    return expr.kind == ExprKind::variable || expr.kind == ExprKind::trigger_value;
}

SequenceWindow all_places(bool greatest) {
    SequenceWindow window{std::vector<std::int64_t>(static_cast<std::size_t>(last_place)), greatest};
    std::iota(window.places.begin(), window.places.end(), std::int64_t{1});
    return window;
}

}  // namespace

bool SequenceConditions::add(const Expr& condition, const ClosedValue& closed) {
    closed_ = closed;
    return add_condition(condition);
}

bool SequenceConditions::add_condition(const Expr& condition) {
    if (condition.kind == ExprKind::boolean) return true;
    if (is_connective(condition.kind))
        return std::ranges::all_of(condition.args, [&](const ExprPtr& part) { return part && add_condition(*part); });
    if (is_toolkit(condition, "sequence_toolkit_isNonEmpty") && is_place(without_casts(*condition.args.at(0)))) {
        sizes_.insert(0);
        return true;
    }
    if (!is_comparison(condition.kind) || condition.args.size() != 2) return false;
    return add_comparison(*condition.args[0], *condition.args[1]) ||
           add_comparison(*condition.args[1], *condition.args[0]);
}

bool SequenceConditions::add_comparison(const Expr& subject, const Expr& with) {
    const auto value = closed_(with);
    const Expr& plain = without_casts(subject);
    if (!value) return false;
    if (is_place(plain) && value->parts.empty() && with.kind == ExprKind::sequence) {
        sizes_.insert(0);
        return true;
    }
    if (is_toolkit(plain, "sequence_toolkit_size") && is_place(without_casts(*plain.args.at(0)))) {
        const bool real = system_.type(with.type).kind == TypeKind::real;
        const std::int64_t size = real ? *floor_divide(value->number, scale_) : value->number;
        return size < 0 || add_size(size);  // every size is greater than a negative number
    }
    if (&plain != &subject || !value->parts.empty()) return false;
    return add_window(plain, value->number);
}

/// Adds a comparison of `min(ran(extract(W, s)))` or of `min(ran(s))`, or of the same expression with `max`.
bool SequenceConditions::add_window(const Expr& extremum, std::int64_t threshold) {
    const bool greatest = is_toolkit(extremum, "sequence_toolkit_max");
    if (!greatest && !is_toolkit(extremum, "sequence_toolkit_min")) return false;
    const Expr& range = without_casts(*extremum.args.at(0));
    if (!is_toolkit(range, "relation_toolkit_ran")) return false;
    const Expr& extract = without_casts(*range.args.at(0));
    if (is_place(extract)) return add_threshold(all_places(greatest), threshold);
    if (!is_toolkit(extract, "sequence_toolkit_extract") || !is_place(*extract.args.at(1))) return false;
    const auto places = closed_(*extract.args.at(0));
    if (!places) return false;
    SequenceWindow window{{}, greatest};
    for (const Value& place : places->parts)
        if (place.number >= 1) window.places.push_back(place.number);
    diagnostics::sort_unique(window.places);
    if (!window.places.empty() && window.places.back() >= last_place) return false;
    return add_threshold(window, threshold);
}

bool SequenceConditions::add_threshold(const SequenceWindow& window, std::int64_t threshold) {
    if (threshold <= -greatest_threshold || threshold >= greatest_threshold) return false;
    const auto known = std::ranges::find(windows_, window);
    const auto number = static_cast<std::size_t>(known - windows_.begin());
    if (known == windows_.end()) {
        windows_.push_back(window);
        thresholds_.emplace_back();
    }
    thresholds_[number].insert(threshold);
    return true;
}

bool SequenceConditions::add_size(std::int64_t size) {
    sizes_.insert(size);
    return size < last_place;
}

std::vector<SequenceConditions::Comparison> SequenceConditions::comparisons() const {
    std::vector<Comparison> result;
    for (std::size_t w = 0; w < windows_.size(); ++w)
        for (const std::int64_t threshold : thresholds_[w]) result.push_back({windows_[w], threshold});
    for (const std::int64_t size : sizes_) result.push_back({std::nullopt, size});
    return result;
}

std::vector<int> SequenceConditions::signs_at(const Value& sequence) const {
    const auto length = static_cast<std::int64_t>(sequence.parts.size());
    const auto sign = [](std::int64_t number, std::int64_t threshold) {
        return static_cast<int>(number > threshold) - static_cast<int>(number < threshold);
    };
    std::vector<int> result;
    for (const Comparison& comparison : comparisons()) {
        if (!comparison.window) {
            result.push_back(sign(length, comparison.threshold));
            continue;
        }
        const auto extremum = extremum_in(*comparison.window, comparison.window->greatest, sequence.parts.size(),
                                          [&](std::size_t i) { return sequence.parts[i].number; });
        result.push_back(extremum ? sign(*extremum, comparison.threshold) : 2);
    }
    return result;
}

/// Returns the cells. A cell contains the places that are in exactly the same windows. Its key lists the numbers of
/// these windows, and its places are ascending.
std::map<std::vector<std::size_t>, std::vector<std::int64_t>> SequenceConditions::cells() const {
    std::map<std::int64_t, std::vector<std::size_t>> of_place;
    for (std::size_t w = 0; w < windows_.size(); ++w)
        for (const std::int64_t place : windows_[w].places) of_place[place].push_back(w);
    std::map<std::vector<std::size_t>, std::vector<std::int64_t>> result;
    for (const auto& [place, windows] : of_place) result[windows].push_back(place);
    return result;
}

/// Returns the lengths at which a cell begins or the answer of a comparison with the size changes, in descending order.
std::vector<std::int64_t> SequenceConditions::lengths() const {
    std::set<std::int64_t> found{0};
    for (const auto& [windows, places] : cells()) {
        found.insert(places.front());
        found.insert(places.front() - 1);
        if (places.back() < last_place) found.insert(places.back());
    }
    for (const std::int64_t size : sizes_)
        for (const std::int64_t length : {size - 1, size, size + 1})
            if (length >= 0) found.insert(length);
    return {found.rbegin(), found.rend()};
}

std::int64_t SequenceConditions::unit_of(TypeKind kind) const {
    return kind == TypeKind::real ? scale_ : 1;
}

/// Returns the thresholds of these windows, one number between any two neighbouring thresholds, and one number beyond
/// each end.
std::vector<std::int64_t> SequenceConditions::numbers_beside(const std::vector<std::size_t>& windows,
                                                             TypeKind kind) const {
    std::set<std::int64_t> thresholds;
    for (const std::size_t window : windows) thresholds.insert(thresholds_[window].begin(), thresholds_[window].end());
    const std::int64_t unit = unit_of(kind);
    std::set<std::int64_t> result{*thresholds.begin() - unit, *thresholds.rbegin() + unit};
    for (auto at = thresholds.begin(); at != thresholds.end(); ++at) {
        result.insert(*at);
        if (at != thresholds.begin()) result.insert(*std::prev(at) + (*at - *std::prev(at)) / 2);
    }
    if (kind == TypeKind::nat) {
        std::erase_if(result, [](std::int64_t number) { return number < 0; });
        result.insert(0);
    }
    return {result.begin(), result.end()};
}

bool SequenceConditions::has_both_extremes() const {
    const auto greatest = std::ranges::count_if(windows_, &SequenceWindow::greatest);
    return greatest != 0 && greatest != static_cast<std::ptrdiff_t>(windows_.size());
}

std::optional<std::vector<Value>> SequenceConditions::values(TypeId element, const Value& other) const {
    const TypeKind kind = system_.type(element).kind;
    const bool number = kind == TypeKind::real || kind == TypeKind::integer || kind == TypeKind::nat;
    if (has_both_extremes() || (!windows_.empty() && !number)) return std::nullopt;
    const auto all_cells = cells();
    std::vector<Value> result;
    for (const std::int64_t length : lengths()) {
        std::vector<std::pair<const std::vector<std::int64_t>*, std::vector<std::int64_t>>> present;
        std::size_t combinations = 1;
        for (const auto& [windows, places] : all_cells) {
            if (places.front() > length) continue;
            present.emplace_back(&places, numbers_beside(windows, kind));
            combinations *= present.back().second.size();
            if (result.size() + combinations > most_candidates) return std::nullopt;
        }
        for (std::size_t combination = 0; combination < combinations; ++combination) {
            Value value{0, std::vector<Value>(static_cast<std::size_t>(length), other)};
            std::size_t rest = combination;
            for (const auto& [places, numbers] : present) {
                for (const std::int64_t place : *places)
                    if (place <= length)
                        value.parts[static_cast<std::size_t>(place - 1)].number = numbers[rest % numbers.size()];
                rest /= numbers.size();
            }
            result.push_back(std::move(value));
        }
    }
    return result;
}

}  // namespace robochart::ir
