// SPDX-License-Identifier: Apache-2.0
// Formulas of linear-time temporal logic. Equal formulas have the same number. Negation occurs only at atoms.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace robochart::prism::automata {

using FormulaId = std::uint32_t;

enum class Form : std::uint8_t { no, yes, atom, not_atom, both, either, next, until, release };

/// The steps after which the right side of `until` may hold.
struct Steps {
    std::uint64_t from = 0;
    std::optional<std::uint64_t> to;  ///< no value: unbounded
    [[nodiscard]] bool is_unbounded() const { return from == 0 && !to; }
    [[nodiscard]] Steps after_one() const { return {from > 0 ? from - 1 : 0, to ? std::optional(*to - 1) : to}; }
    friend auto operator<=>(const Steps&, const Steps&) = default;
};

struct Formula {
    Form form = Form::no;
    std::uint32_t atom = 0;
    FormulaId a = 0, b = 0;
    Steps steps = {};
    bool co_safe = true;  ///< every path that satisfies the formula has a prefix all of whose continuations satisfy it
    bool safe = true;     ///< every path that violates the formula has a prefix all of whose continuations violate it
    bool tail = false;    ///< adding or removing a prefix does not change whether a path satisfies the formula
};

class Formulas {
public:
    static constexpr FormulaId no = 0;
    static constexpr FormulaId yes = 1;

    Formulas();
    [[nodiscard]] const Formula& operator[](FormulaId id) const { return formulas_[id]; }

    FormulaId atom(std::uint32_t number, bool positive = true);
    FormulaId make_conjunction(FormulaId a, FormulaId b);
    FormulaId make_disjunction(FormulaId a, FormulaId b);
    FormulaId make_next(FormulaId a);
    FormulaId make_until(FormulaId a, FormulaId b, Steps steps = {});
    /// Makes the dual of `until`: the negation of the `until` of the negated operands.
    FormulaId make_release(FormulaId a, FormulaId b, Steps steps = {});
    FormulaId make_finally(FormulaId a) { return make_until(yes, a); }
    FormulaId make_always(FormulaId a) { return make_release(no, a); }
    FormulaId make_negation(FormulaId id);

private:
    FormulaId add(Formula formula);

    std::vector<Formula> formulas_;
    std::map<std::tuple<Form, std::uint32_t, FormulaId, FormulaId, Steps>, FormulaId> known_;
    std::map<FormulaId, FormulaId> negated_;
};

}  // namespace robochart::prism::automata
