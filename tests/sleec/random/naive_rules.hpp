// Conflicts of small rule sets by going through every history, from the definitions of docs/rules-language.md alone: no
// limit on occurrences, no duty left out because another decides, nothing shared with sleec/ but the text of the rules.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace robochart::sleec::testing {

/// `near`, `not near`, `safe`, `not safe`.
struct NaiveCondition {
    int measure = 0;  ///< 0: near, 1: safe
    bool positive = true;

    [[nodiscard]] bool holds(unsigned values) const { return ((values >> measure & 1U) != 0) == positive; }
    [[nodiscard]] std::string text() const;
};

/// `[not] EVENT [within [from, to] seconds]`.
struct NaiveAction {
    bool negated = false;
    int event = 0;
    int from = 0;
    std::optional<int> to;  ///< nothing: no limit
};

/// Actions with `otherwise` between them, and defeaters.
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

/// The events of random rules: A, B, C, ...
[[nodiscard]] std::string event_text(int event);
/// A file with these rules, called R0, R1, ...
[[nodiscard]] std::string text_of(const std::vector<NaiveRule>& rules);
/// Rules over few events with short limits, so that windows meet.
[[nodiscard]] std::vector<NaiveRule> random_rules(std::mt19937_64& random);

enum class NaiveAnswer {
    none,
    /// A history that keeps all of these rules so far leads to an instant at which a duty has to be fulfilled at last,
    /// and every event that could fulfil it is forbidden by a duty of these rules.
    forbidden,
    /// Not that, but a history leads to an instant from which none that keeps the rules leads to the next second.
    endless,
};
/// Whether all of these can be kept. Nothing: too many states.
[[nodiscard]] std::optional<NaiveAnswer> in_conflict(const std::vector<NaiveRule>& rules);
/// The smallest subsets with a duty that is forbidden, by number. Nothing: too many states.
[[nodiscard]] std::optional<std::set<std::vector<std::size_t>>> smallest_conflicts(const std::vector<NaiveRule>& rules);

}  // namespace robochart::sleec::testing
