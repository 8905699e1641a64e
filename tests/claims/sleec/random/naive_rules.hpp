// SPDX-License-Identifier: Apache-2.0
// Finds conflicts of small rule sets by enumerating every history, directly from the definitions of
// docs/rules-language.md. The number of occurrences is not limited, and no duty is omitted because another one decides.
// The code shares only the text of the rules with claims/sleec/.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace robochart::sleec::testing {

/// A condition: `near`, `not near`, `safe` or `not safe`.
struct NaiveCondition {
    int measure = 0;  ///< 0: near, 1: safe
    bool positive = true;

    [[nodiscard]] bool holds(unsigned values) const { return ((values >> measure & 1U) != 0) == positive; }
    [[nodiscard]] std::string text() const;
};

/// An action: `[not] EVENT [within [from, to] seconds]`.
struct NaiveAction {
    bool negated = false;
    int event = 0;
    int from = 0;
    std::optional<int> to;  ///< nullopt if there is no limit
};

/// A response: actions separated by `otherwise`, and defeaters.
struct NaiveResponse {
    struct Defeater;
    std::vector<NaiveAction> chain;
    std::vector<Defeater> defeaters;

    [[nodiscard]] std::string text() const;
};
struct NaiveResponse::Defeater {
    NaiveCondition condition;
    std::optional<NaiveResponse> response;
};

struct NaiveRule {
    int trigger = 0;
    std::optional<NaiveCondition> condition;
    NaiveResponse response;
};

/// Returns the name of an event of random rules: A, B, C, ...
[[nodiscard]] std::string event_text(int event);
/// Returns a file with these rules, called R0, R1, ...
[[nodiscard]] std::string text_of(const std::vector<NaiveRule>& rules);
/// Returns rules over few events with short limits, so that their windows overlap.
[[nodiscard]] std::vector<NaiveRule> random_rules(std::mt19937_64& random);

enum class NaiveAnswer {
    none,
    /// Some history satisfies all these rules so far, and reaches an instant at which a duty must be fulfilled. But
    /// duties of these rules forbid every event that could fulfil it.
    forbidden,
    /// No duty is forbidden. But after some history that satisfies the rules, none of its continuations to the next
    /// second satisfies them.
    endless,
};
/// Returns whether all these rules can be satisfied, or nullopt if there are too many states.
[[nodiscard]] std::optional<NaiveAnswer> in_conflict(const std::vector<NaiveRule>& rules);
/// Returns the minimal subsets with a forbidden duty, as numbers of rules, or nullopt if there are too many states.
[[nodiscard]] std::optional<std::set<std::vector<std::size_t>>> smallest_conflicts(const std::vector<NaiveRule>& rules);

}  // namespace robochart::sleec::testing
