// SPDX-License-Identifier: Apache-2.0
// See formulas.hpp.
#include "prism/automata/formulas.hpp"

#include <utility>

namespace robochart::prism::automata {

Formulas::Formulas() {
    formulas_.push_back({Form::no});
    formulas_.push_back({Form::yes});
}

FormulaId Formulas::add(Formula formula) {
    const auto key = std::tuple(formula.form, formula.atom, formula.a, formula.b, formula.steps);
    const auto [found, fresh] = known_.emplace(key, static_cast<FormulaId>(formulas_.size()));
    if (fresh) formulas_.push_back(formula);
    return found->second;
}

FormulaId Formulas::atom(std::uint32_t number, bool positive) {
    return add({positive ? Form::atom : Form::not_atom, number});
}

FormulaId Formulas::make_conjunction(FormulaId a, FormulaId b) {
    if (a > b) std::swap(a, b);
    if (a == no || a == b) return a;
    if (a == yes) return b;
    const Formula& left = formulas_[a];
    const Formula& right = formulas_[b];
    return add(
        {Form::both, 0, a, b, {}, left.co_safe && right.co_safe, left.safe && right.safe, left.tail && right.tail});
}

FormulaId Formulas::make_disjunction(FormulaId a, FormulaId b) {
    if (a > b) std::swap(a, b);
    if (a == yes || a == b) return a;
    if (a == no) return b == yes ? yes : b;
    const Formula& left = formulas_[a];
    const Formula& right = formulas_[b];
    return add(
        {Form::either, 0, a, b, {}, left.co_safe && right.co_safe, left.safe && right.safe, left.tail && right.tail});
}

FormulaId Formulas::make_next(FormulaId a) {
    if (a == no || a == yes || formulas_[a].tail) return a;
    return add({Form::next, 0, a, 0, {}, formulas_[a].co_safe, formulas_[a].safe, false});
}

FormulaId Formulas::make_until(FormulaId a, FormulaId b, Steps steps) {
    if (b == no || (b == yes && steps.from == 0)) return b;
    const Formula& left = formulas_[a];
    const Formula& right = formulas_[b];
    if (a == yes && steps.is_unbounded() && right.form == Form::until && right.a == yes && right.steps.is_unbounded())
        return b;
    // The right operand is F G x, for some x.
    const bool persists = a == yes && right.form == Form::release && right.a == no && right.steps.is_unbounded();
    const bool tail = steps.is_unbounded() && (persists || (a == yes && right.tail));
    return add({Form::until, 0, a, b, steps, left.co_safe && right.co_safe,
                steps.to.has_value() && left.safe && right.safe, tail});
}

FormulaId Formulas::make_release(FormulaId a, FormulaId b, Steps steps) {
    if (b == yes || (b == no && steps.from == 0)) return b;
    const Formula& left = formulas_[a];
    const Formula& right = formulas_[b];
    if (a == no && steps.is_unbounded() && right.form == Form::release && right.a == no && right.steps.is_unbounded())
        return b;
    const bool recurs = a == no && right.form == Form::until && right.a == yes && right.steps.is_unbounded();
    const bool tail = steps.is_unbounded() && (recurs || (a == no && right.tail));
    return add({Form::release, 0, a, b, steps, steps.to.has_value() && left.co_safe && right.co_safe,
                left.safe && right.safe, tail});
}

FormulaId Formulas::make_negation(FormulaId id) {
    if (const auto known = negated_.find(id); known != negated_.end()) return known->second;
    const Formula formula = formulas_[id];
    FormulaId result = id == no ? yes : no;
    switch (formula.form) {
        case Form::no:
        case Form::yes:
            break;
        case Form::atom:
        case Form::not_atom:
            result = atom(formula.atom, formula.form == Form::not_atom);
            break;
        case Form::both:
            result = make_disjunction(make_negation(formula.a), make_negation(formula.b));
            break;
        case Form::either:
            result = make_conjunction(make_negation(formula.a), make_negation(formula.b));
            break;
        case Form::next:
            result = make_next(make_negation(formula.a));
            break;
        case Form::until:
            result = make_release(make_negation(formula.a), make_negation(formula.b), formula.steps);
            break;
        case Form::release:
            result = make_until(make_negation(formula.a), make_negation(formula.b), formula.steps);
            break;
    }
    negated_.emplace(id, result);
    return result;
}

}  // namespace robochart::prism::automata
