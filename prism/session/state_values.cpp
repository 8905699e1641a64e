// SPDX-License-Identifier: Apache-2.0
// See state_values.hpp.
#include "prism/session/state_values.hpp"

namespace robochart::prism {

Truth negation_of(Truth truth) {
    if (truth == Truth::unknown || truth == Truth::undefined) return truth;
    return truth == Truth::yes ? Truth::no : Truth::yes;
}

Truth conjunction_of(Truth a, Truth b) {
    if (a == Truth::no || b == Truth::no) return Truth::no;
    if (a == Truth::unknown || b == Truth::unknown) return Truth::unknown;
    return a == Truth::undefined || b == Truth::undefined ? Truth::undefined : Truth::yes;
}

void StateVector::add_undefined(UndefinedPtr why) {
    undefined.emplace(size(), std::move(why));
    if (type == Type::boolean)
        truths.push_back(Truth::undefined);
    else
        reals.emplace_back();
}

StateVector StateVector::from_set(const markov::StateSet& set) {
    StateVector result;
    result.truths.reserve(set.size());
    for (const bool inside : set) result.truths.push_back(inside ? Truth::yes : Truth::no);
    return result;
}

Truth apply_relation(const Real& a, Op relation, const Real& b) {
    const auto truth = [](bool value) { return value ? Truth::yes : Truth::no; };
    if (const std::optional<int> order = a.compare(b)) switch (relation) {
            case Op::less:
                return truth(*order < 0);
            case Op::less_equal:
                return truth(*order <= 0);
            case Op::greater:
                return truth(*order > 0);
            case Op::greater_equal:
                return truth(*order >= 0);
            case Op::unequal:
                return truth(*order != 0);
            default:
                return truth(*order == 0);
        }
    // Enclosures with a common bound decide some relations: [0.4, 0.5] <= 0.5.
    const Enclosure left = a.bounds();
    const Enclosure right = b.bounds();
    const bool at_most = left.high <= right.low;
    const bool at_least = left.low >= right.high;
    if ((relation == Op::less_equal && at_most) || (relation == Op::greater_equal && at_least)) return Truth::yes;
    if ((relation == Op::greater && at_most) || (relation == Op::less && at_least)) return Truth::no;
    return Truth::unknown;
}

}  // namespace robochart::prism
