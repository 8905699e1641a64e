// SPDX-License-Identifier: Apache-2.0
// See residues.hpp.
#include "prism/automata/residues.hpp"

#include <algorithm>
#include <limits>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::prism::automata {

std::size_t Residues::HashPair::operator()(const Pair& pair) const {
    return diagnostics::splitmix64_mixed(diagnostics::splitmix64_mixed(pair.first) + pair.second);
}

Residues::Residues(Formulas& formulas) : formulas_(formulas), nodes_(2) {}

std::uint32_t Residues::variable_of(ResidueId id) const {
    return id <= yes ? std::numeric_limits<std::uint32_t>::max() : nodes_[id].variable;
}

ResidueId Residues::node(std::uint32_t variable, ResidueId low, ResidueId high) {
    if (low == high) return low;
    const auto [found, fresh] =
        known_.emplace(Pair{variable, std::uint64_t{low} << 32U | high}, static_cast<ResidueId>(nodes_.size()));
    if (!fresh) return found->second;
    if (nodes_.size() >= most_nodes) throw NotDecided("the automaton of the formula is too large");
    nodes_.push_back({variable, low, high});
    return found->second;
}

ResidueId Residues::variable(FormulaId formula) {
    const auto [found, fresh] = number_.emplace(formula, static_cast<std::uint32_t>(variables_.size()));
    if (fresh) variables_.push_back(formula);
    return node(found->second, no, yes);
}

ResidueId Residues::choice(ResidueId condition, ResidueId then, ResidueId otherwise) {
    if (condition == yes) return then;
    if (condition == no) return otherwise;
    if (then == otherwise) return then;
    if (then == yes && otherwise == no) return condition;
    const auto key = std::tuple(condition, then, otherwise);
    if (const auto known = choices_.find(key); known != choices_.end()) return known->second;
    const std::uint32_t top = std::min({variable_of(condition), variable_of(then), variable_of(otherwise)});
    const auto side = [&](ResidueId id, bool high) {
        if (variable_of(id) != top) return id;
        return high ? nodes_[id].high : nodes_[id].low;
    };
    const ResidueId low = choice(side(condition, false), side(then, false), side(otherwise, false));
    const ResidueId high = choice(side(condition, true), side(then, true), side(otherwise, true));
    const ResidueId result = node(top, low, high);
    choices_.emplace(key, result);
    return result;
}

ResidueId Residues::residue_of(FormulaId id) {
    const Formula formula = formulas_[id];
    switch (formula.form) {
        case Form::no:
            return no;
        case Form::yes:
            return yes;
        case Form::both:
            return conjunction_of(residue_of(formula.a), residue_of(formula.b));
        case Form::either:
            return choice(residue_of(formula.a), yes, residue_of(formula.b));
        case Form::not_atom:
            return choice(variable(formulas_.atom(formula.atom)), no, yes);
        case Form::atom:
        case Form::next:
        case Form::until:
        case Form::release:
            break;
    }
    return variable(id);
}

ResidueId Residues::residue_after(ResidueId residue, Letter letter) {
    if (residue <= yes) return residue;
    const Pair key{residue, letter};
    if (const auto known = after_.find(key); known != after_.end()) return known->second;
    const Node top = nodes_[residue];
    const ResidueId condition = step(variables_[top.variable], letter);
    const ResidueId high = residue_after(top.high, letter);
    const ResidueId result = choice(condition, high, residue_after(top.low, letter));
    after_.emplace(key, result);
    return result;
}

/// Expands a formula by one step: a U b is b | (a & X (a U b)), and a R b is b & (a | X (a R b)).
ResidueId Residues::step(FormulaId id, Letter letter) {
    const Formula formula = formulas_[id];
    if (formula.form == Form::atom) return (letter >> formula.atom & 1U) != 0 ? yes : no;
    if (formula.form == Form::next) return residue_of(formula.a);
    const bool until = formula.form == Form::until;
    const ResidueId left = residue_after(residue_of(formula.a), letter);
    ResidueId right = until ? no : yes;
    if (formula.steps.from == 0) right = residue_after(residue_of(formula.b), letter);
    ResidueId later = until ? no : yes;
    if (formula.steps.to != 0U)
        later = residue_of(until ? formulas_.make_until(formula.a, formula.b, formula.steps.after_one())
                                 : formulas_.make_release(formula.a, formula.b, formula.steps.after_one()));
    return until ? choice(right, yes, conjunction_of(left, later)) : conjunction_of(right, choice(left, yes, later));
}

}  // namespace robochart::prism::automata
