// SPDX-License-Identifier: Apache-2.0
// See automaton.hpp.
#include "prism/automata/automaton.hpp"

#include <algorithm>

namespace robochart::prism::automata {

Automaton::Automaton(Residues& residues, std::vector<Part> parts) : residues_(residues), parts_(std::move(parts)) {
    std::vector<OfPart> first;
    for (const Part& part : parts_) {
        OfPart& begins = first.emplace_back();
        if (!part.always) begins.now = residues_.residue_of(part.formula);
    }
    (void)add(std::move(first));
}

Automaton::State Automaton::add(std::vector<OfPart> state) {
    const auto [found, fresh] = known_.emplace(std::move(state), static_cast<State>(states_.size()));
    if (!fresh) return found->second;
    if (states_.size() >= most_states) throw NotDecided("the automaton of the formula has more than 20000 states");
    states_.push_back(found->first);
    return found->second;
}

Automaton::State Automaton::successor_of(State state, Letter letter) {
    if (const auto known = after_.find({state, letter}); known != after_.end()) return known->second;
    std::vector<OfPart> next;
    for (std::size_t i = 0; i < parts_.size(); ++i) next.push_back(successor_of(states_[state][i], parts_[i], letter));
    const State result = add(std::move(next));
    after_.emplace(std::pair(state, letter), result);
    return result;
}

Automaton::OfPart Automaton::successor_of(const OfPart& before, const Part& part, Letter letter) {
    OfPart result;
    result.now = residues_.residue_after(before.now, letter);
    if (!part.always) return result;
    result.later =
        residues_.residue_after(residues_.conjunction_of(before.later, residues_.residue_of(part.formula)), letter);
    if (result.now == Residues::no || result.later == Residues::no) return {Residues::no, Residues::no, false};
    if (result.now != Residues::yes) return result;
    return {result.later, Residues::yes, true};
}

namespace {

constexpr const char* beyond =
    "this LTL formula is not supported: it must combine, with !, & and |, safe and co-safe formulas, G of co-safe "
    "formulas and F of safe formulas";

/// Converts formulas to conditions, applying laws of LTL until only parts remain.
class Splitter {
public:
    explicit Splitter(Formulas& formulas) : formulas_(formulas) {}

    std::vector<Conjunction> operator()(FormulaId id) {
        const Depth depth(depth_);
        const Formula formula = formulas_[id];
        if (formula.co_safe) return literal_case({id, false}, true);
        if (formula.safe) return literal_case({formulas_.make_negation(id), false}, false);
        switch (formula.form) {
            case Form::both:
                return combine_all((*this)(formula.a), (*this)(formula.b));
            case Form::either:
                return combine_any((*this)(formula.a), (*this)(formula.b));
            case Form::next:
                return (*this)(move_next_inwards(formula.a));
            case Form::until:
                return split_until(formula);
            case Form::release:
                return split_release(formula);
            case Form::no:
            case Form::yes:
            case Form::atom:
            case Form::not_atom:
                break;
        }
        throw NotDecided(beyond);
    }

    std::vector<Part> parts;

private:
    struct Depth {
        explicit Depth(unsigned& depth) : depth_(depth) {
            constexpr unsigned most = 2000;
            if (++depth_ > most) throw NotDecided(beyond);
        }
        ~Depth() { --depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;
        unsigned& depth_;
    };

    std::vector<Conjunction> literal_case(Part part, bool holds) {
        const auto found = std::ranges::find(parts, part);
        const auto index = static_cast<std::size_t>(found - parts.begin());
        if (found == parts.end()) parts.push_back(part);
        return {{{index, holds}}};
    }

    static std::vector<Conjunction> combine_any(std::vector<Conjunction> a, const std::vector<Conjunction>& b) {
        a.insert(a.end(), b.begin(), b.end());
        return a;
    }

    static std::vector<Conjunction> combine_all(const std::vector<Conjunction>& a, const std::vector<Conjunction>& b) {
        constexpr std::size_t most = 1000;
        if (a.size() * b.size() > most) throw NotDecided("the formula has too many cases");
        std::vector<Conjunction> result;
        for (const Conjunction& left : a)
            for (const Conjunction& right : b) {
                Conjunction both = left;
                both.insert(both.end(), right.begin(), right.end());
                result.push_back(std::move(both));
            }
        return result;
    }

    /// Returns X of a formula, with the X moved inside the formula's outermost operator.
    FormulaId move_next_inwards(FormulaId id) {
        const Formula formula = formulas_[id];
        switch (formula.form) {
            case Form::both:
                return formulas_.make_conjunction(formulas_.make_next(formula.a), formulas_.make_next(formula.b));
            case Form::either:
                return formulas_.make_disjunction(formulas_.make_next(formula.a), formulas_.make_next(formula.b));
            case Form::next:
                return move_next_inwards(move_next_inwards(formula.a));
            case Form::until:
                return formulas_.make_until(formulas_.make_next(formula.a), formulas_.make_next(formula.b),
                                            formula.steps);
            case Form::release:
                return formulas_.make_release(formulas_.make_next(formula.a), formulas_.make_next(formula.b),
                                              formula.steps);
            case Form::no:
            case Form::yes:
            case Form::atom:
            case Form::not_atom:
                break;
        }
        throw NotDecided(beyond);
    }

    /// Collects the operands of nested `form` (both or either). Tails and other operands are collected separately.
    void operands(FormulaId id, Form form, std::vector<FormulaId>& tails, std::vector<FormulaId>& others) const {
        const Formula& formula = formulas_[id];
        if (formula.form != form) return (formula.tail ? tails : others).push_back(id);
        operands(formula.a, form, tails, others);
        operands(formula.b, form, tails, others);
    }
    FormulaId join_formulas(const std::vector<FormulaId>& ids, Form form) {
        FormulaId result = form == Form::both ? Formulas::yes : Formulas::no;
        for (const FormulaId id : ids)
            result =
                form == Form::both ? formulas_.make_conjunction(result, id) : formulas_.make_disjunction(result, id);
        return result;
    }

    std::vector<Conjunction> split_until(const Formula& formula) {
        if (!formula.steps.is_unbounded()) throw NotDecided(beyond);
        const Formula right = formulas_[formula.b];
        // If prefixes do not matter for b, a U b holds if and only if b holds now.
        if (right.tail) return (*this)(formula.b);
        if (right.form == Form::either)
            return combine_any((*this)(formulas_.make_until(formula.a, right.a)),
                               (*this)(formulas_.make_until(formula.a, right.b)));
        if (right.form == Form::both) {
            std::vector<FormulaId> tails, others;
            operands(formula.b, Form::both, tails, others);
            if (!tails.empty())
                return combine_all((*this)(join_formulas(tails, Form::both)),
                                   (*this)(formulas_.make_until(formula.a, join_formulas(others, Form::both))));
        }
        return formula.a == Formulas::yes ? split_finally(formula.b) : guarded_until(formula);
    }

    /// Splits F of a formula that is neither a tail nor a disjunction.
    std::vector<Conjunction> split_finally(FormulaId id) {
        const Formula formula = formulas_[id];
        if (formula.safe) return literal_case({formulas_.make_negation(id), true}, false);
        if (formula.form == Form::next) return (*this)(formulas_.make_finally(move_next_inwards(formula.a)));
        if (formula.steps.is_unbounded() && formula.form == Form::until)
            return (*this)(formulas_.make_finally(formula.b));
        if (formula.steps.is_unbounded() && formula.form == Form::release && formula.a != Formulas::no)
            return combine_any((*this)(formulas_.make_finally(formulas_.make_conjunction(formula.a, formula.b))),
                               (*this)(formulas_.make_finally(formulas_.make_always(formula.b))));
        throw NotDecided(beyond);
    }

    /// Splits a U b where a is not true.
    std::vector<Conjunction> guarded_until(const Formula& formula) {
        const Formula left = formulas_[formula.a];
        const FormulaId at_last = formulas_.make_finally(formula.b);
        if (left.tail) return combine_any((*this)(formula.b), combine_all((*this)(formula.a), (*this)(at_last)));
        if (left.form == Form::both)
            return combine_all((*this)(formulas_.make_until(left.a, formula.b)),
                               (*this)(formulas_.make_until(left.b, formula.b)));
        std::vector<FormulaId> tails, others;
        operands(formula.a, Form::either, tails, others);
        if (tails.empty()) throw NotDecided(beyond);
        return combine_any((*this)(formulas_.make_until(join_formulas(others, Form::either), formula.b)),
                           combine_all((*this)(join_formulas(tails, Form::either)), (*this)(at_last)));
    }

    std::vector<Conjunction> split_release(const Formula& formula) {
        if (!formula.steps.is_unbounded()) throw NotDecided(beyond);
        const Formula right = formulas_[formula.b];
        if (right.tail) return (*this)(formula.b);
        if (right.form == Form::both)
            return combine_all((*this)(formulas_.make_release(formula.a, right.a)),
                               (*this)(formulas_.make_release(formula.a, right.b)));
        if (right.form == Form::either) {
            std::vector<FormulaId> tails, others;
            operands(formula.b, Form::either, tails, others);
            if (!tails.empty())
                return combine_any((*this)(join_formulas(tails, Form::either)),
                                   (*this)(formulas_.make_release(formula.a, join_formulas(others, Form::either))));
        }
        return formula.a == Formulas::no ? split_always(formula.b) : guarded_release(formula);
    }

    /// Splits G of a formula that is neither a tail nor a conjunction.
    std::vector<Conjunction> split_always(FormulaId id) {
        const Formula formula = formulas_[id];
        if (formula.co_safe) return literal_case({id, true}, true);
        if (formula.form == Form::next) return (*this)(formulas_.make_always(move_next_inwards(formula.a)));
        if (formula.steps.is_unbounded() && formula.form == Form::release)
            return (*this)(formulas_.make_always(formula.b));
        if (formula.steps.is_unbounded() && formula.form == Form::until && formula.a != Formulas::yes)
            return combine_all((*this)(formulas_.make_always(formulas_.make_disjunction(formula.a, formula.b))),
                               (*this)(formulas_.make_always(formulas_.make_finally(formula.b))));
        throw NotDecided(beyond);
    }

    /// Splits a R b where a is not false.
    std::vector<Conjunction> guarded_release(const Formula& formula) {
        const Formula left = formulas_[formula.a];
        const FormulaId for_ever = formulas_.make_always(formula.b);
        if (left.tail) return combine_all((*this)(formula.b), combine_any((*this)(formula.a), (*this)(for_ever)));
        if (left.form == Form::either)
            return combine_any((*this)(formulas_.make_release(left.a, formula.b)),
                               (*this)(formulas_.make_release(left.b, formula.b)));
        std::vector<FormulaId> tails, others;
        operands(formula.a, Form::both, tails, others);
        if (tails.empty()) throw NotDecided(beyond);
        return combine_all((*this)(formulas_.make_release(join_formulas(others, Form::both), formula.b)),
                           combine_any((*this)(join_formulas(tails, Form::both)), (*this)(for_ever)));
    }

    Formulas& formulas_;
    unsigned depth_ = 0;
};

}  // namespace

Condition condition(Formulas& formulas, FormulaId formula) {
    Splitter split(formulas);
    std::vector<Conjunction> any = split(formula);
    return {std::move(split.parts), std::move(any)};
}

}  // namespace robochart::prism::automata
