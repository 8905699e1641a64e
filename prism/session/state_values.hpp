// SPDX-License-Identifier: Apache-2.0
// Stores a value for every state: a boolean, which may be unknown, or a number. A state may also have no value.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "prism/explore/evaluation.hpp"
#include "prism/explore/real.hpp"
#include "prism/markov/model/model.hpp"
#include "prism/syntax/syntax.hpp"

namespace robochart::prism {

/// Known true, known false, unknown, or without a value.
enum class Truth : std::uint8_t { no, yes, unknown, undefined };

[[nodiscard]] Truth negation_of(Truth truth);
[[nodiscard]] Truth conjunction_of(Truth a, Truth b);

/// Why an expression has no value in a state, or, with `open`, why it is unknown whether the expression has a value.
struct Undefined {
    EvaluationError error;
    std::string open;  ///< "": the expression has no value for certain
};
using UndefinedPtr = std::shared_ptr<const Undefined>;

/// Thrown if the value of a state is used although it is missing.
class NoValue : public std::exception {
public:
    NoValue(std::size_t state, UndefinedPtr why) : state_(state), why_(std::move(why)) {}
    [[nodiscard]] std::size_t state() const { return state_; }
    [[nodiscard]] const Undefined& undefined_reason() const { return *why_; }

private:
    std::size_t state_;
    UndefinedPtr why_;
};

class StateVector {
public:
    Type type = Type::boolean;
    std::vector<Truth> truths;       ///< for booleans
    std::vector<Enclosure> numbers;  ///< for numbers that are not exact
    std::vector<Real> reals;         ///< for exact numbers, and infinity
    std::string reason;              ///< the reason why a value is unknown, or wider than requested
    /// The states without a value. Their truth is Truth::undefined.
    std::map<std::size_t, UndefinedPtr> undefined;

    [[nodiscard]] std::size_t size() const { return truths.size() + numbers.size() + reals.size(); }
    /// Throws NoValue.
    [[nodiscard]] Real number(std::size_t state) const {
        require_value(state);
        return reals.empty() ? Real(numbers[state]) : reals[state];
    }
    /// Throws NoValue if the state has no value.
    void require_value(std::size_t state) const {
        if (const UndefinedPtr why = undefined_in(state)) throw NoValue(state, why);
    }
    /// Returns null if the state has a value.
    [[nodiscard]] UndefinedPtr undefined_in(std::size_t state) const {
        if (undefined.empty()) return nullptr;
        const auto found = undefined.find(state);
        return found == undefined.end() ? nullptr : found->second;
    }
    /// Adds a state without a value.
    void add_undefined(UndefinedPtr why);
    static StateVector from_set(const markov::StateSet& set);
};

/// Applies a relation: `less` to `greater_equal`, `equal` or `unequal`. Returns `unknown` if enclosures overlap.
[[nodiscard]] Truth apply_relation(const Real& a, Op relation, const Real& b);

}  // namespace robochart::prism
