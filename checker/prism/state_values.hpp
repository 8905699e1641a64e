// A value for every state: truth values of which some may be unknown, or numbers.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "checker/markov/model/model.hpp"
#include "checker/prism/explore/real.hpp"
#include "checker/prism/syntax/syntax.hpp"

namespace robochart::prism {

/// Known true, known false, or neither.
enum class Truth : std::uint8_t { no, yes, unknown };

[[nodiscard]] Truth negated(Truth truth);
[[nodiscard]] Truth both(Truth a, Truth b);

class StateVector {
public:
    Type type = Type::boolean;
    std::vector<Truth> truths;       ///< of booleans
    std::vector<Enclosure> numbers;  ///< unless they are exact
    std::vector<Real> reals;         ///< exact numbers, and infinity
    std::string reason;              ///< why something is unknown, or wider than asked for

    [[nodiscard]] std::size_t size() const { return truths.size() + numbers.size() + reals.size(); }
    [[nodiscard]] Real number(std::size_t state) const { return reals.empty() ? Real(numbers[state]) : reals[state]; }
    static StateVector of(const markov::StateSet& set);
};

/// Applies a relation, `less` to `greater_equal`, `equal` or `unequal`; unknown where enclosures overlap.
[[nodiscard]] Truth related(const Real& a, Op relation, const Real& b);

}  // namespace robochart::prism
