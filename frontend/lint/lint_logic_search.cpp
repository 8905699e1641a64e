// SPDX-License-Identifier: Apache-2.0
// Searches for values that make a formula true. The comparisons of one linear form divide the number line into points
// and open intervals. The search assigns to each key a point or interval, a literal or a truth value. It evaluates the
// formula over the keys assigned so far in Kleene's three-valued logic. If linear forms share terms, Fourier-Motzkin
// elimination decides whether the chosen intervals are consistent.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/diagnostics/containers.hpp"
#include "frontend/lint/lint_logic.hpp"

namespace robochart::frontend::logic {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double tolerance = 1e-9;
constexpr std::size_t max_steps = 4'000;
constexpr std::size_t max_constraints = 64;
constexpr std::size_t max_eliminations = 32;  ///< limit on the checks of whole systems of constraints

enum class Truth { no, yes, open };

Truth negate_truth(Truth truth) {
    if (truth == Truth::open) return truth;
    return truth == Truth::yes ? Truth::no : Truth::yes;
}

double value_inside(double low, double high, bool integer) {
    if (low == -infinity && high == infinity) return 0;
    if (low == -infinity) return std::ceil(high) - 1;
    const double next = std::floor(low) + 1;
    if (high == infinity || next < high) return next;
    return integer ? high : (low + high) / 2;  // no integer is strictly between `low` and `high`
}

/// The constraint that a sum of coefficient * term is < or <= `bound`.
struct Constraint {
    std::map<std::string, double> terms;
    double bound = 0;
    bool strict = false;
};

}  // namespace

/// Searches for values of the keys of one formula. Keys get values in order.
class Search {
public:
    Search(const Reasoner& reasoner, const Formula& formula) : reasoner_(reasoner), formula_(formula) {
        values_.resize(reasoner.keys_.size());
        collect_keys(formula);
    }

    Finding run() {
        Finding result;
        const Truth found = search_from(0);
        switch (found) {
            case Truth::yes:
                result.answer = Answer::possible;
                describe_solution(result);
                break;
            case Truth::no:
                result.answer = Answer::impossible;
                break;
            case Truth::open:
                result.answer = Answer::unknown;
                break;
        }
        return result;
    }

private:
    /// A point or an open interval of the number line, with a value inside.
    struct Region {
        double low = -infinity, high = infinity;
        bool point = false;
        double sample = 0;
    };

    struct Value {
        bool chosen = false;
        std::size_t index = 0;  ///< boolean: 1 is true; enumeration: literal
        Region region;
    };

    /// Collects the keys of the formula, in the order in which it mentions them.
    void collect_keys(const Formula& formula) {
        if (formula.form == Formula::Form::atom) {
            const std::size_t key = reasoner_.atoms_[formula.atom].key;
            if (std::ranges::find(order_, key) == order_.end()) order_.push_back(key);
        }
        for (const Formula& part : formula.parts) collect_keys(part);
    }

    Truth search_from(std::size_t depth) {
        if (++steps_ > max_steps || eliminations_ > max_eliminations) return Truth::open;
        const Truth truth = evaluate_formula(formula_);
        if (truth == Truth::no) return Truth::no;
        if (truth == Truth::yes) return fits_together();
        bool gave_up = false;
        const std::size_t key = order_[depth];
        for (const Value& value : choices_for(reasoner_.keys_[key])) {
            values_[key] = value;
            const Truth below = search_from(depth + 1);
            if (below == Truth::yes) return below;
            gave_up = gave_up || below == Truth::open;
        }
        values_[key] = {};
        return gave_up ? Truth::open : Truth::no;
    }

    // ------------------------------------------------------------ choices

    static std::vector<Value> index_values(std::size_t count) {
        std::vector<Value> result;
        for (std::size_t i = 0; i < count; ++i) result.push_back({true, i, {}});
        return result;
    }

    [[nodiscard]] std::vector<Value> choices_for(const Reasoner::Key& key) const {
        if (key.kind == Reasoner::KeyKind::boolean) return index_values(2);
        if (key.kind == Reasoner::KeyKind::enumeration) return index_values(key.literals.size());
        double least = -infinity;
        if (key.form.size() == 1) least = reasoner_.terms_.at(key.form.begin()->first).least.value_or(-infinity);
        std::set<double> bounds(key.bounds.begin(), key.bounds.end());
        if (least != -infinity) bounds.insert(least);
        std::vector<Value> result;
        double low = -infinity;
        const auto add = [&](Region region) {
            const bool empty = region.point ? region.low < least
                                            : region.high <= least || (key.integer && region.sample >= region.high);
            const bool off_grid = key.integer && region.point && std::floor(region.low) != region.low;
            if (!empty && !off_grid) result.push_back({true, 0, region});
        };
        for (const double bound : bounds) {
            add({low, bound, false, value_inside(low, bound, key.integer)});
            add({bound, bound, true, bound});
            low = bound;
        }
        add({low, infinity, false, value_inside(low, infinity, key.integer)});
        // Values near zero come first, because examples with them are easier to read.
        std::ranges::stable_sort(result, [](const Value& a, const Value& b) {
            return std::abs(a.region.sample) < std::abs(b.region.sample);
        });
        return result;
    }

    // ------------------------------------------------------------ evaluation

    [[nodiscard]] bool atom_holds(const Reasoner::Atom& atom) const {
        const Reasoner::Key& key = reasoner_.keys_[atom.key];
        const Value& value = values_[atom.key];
        if (key.kind == Reasoner::KeyKind::boolean) return value.index == 1;
        if (key.kind == Reasoner::KeyKind::enumeration) return value.index == atom.literal;
        const double left = atom.reversed ? atom.bound : value.region.sample;
        const double right = atom.reversed ? value.region.sample : atom.bound;
        if (atom.relation == Relation::equal) return left == right;
        return atom.relation == Relation::less ? left < right : left <= right;
    }

    /// Evaluates the parts until one has the value `decisive`, which is `no` for conjunctions and `yes` for
    /// disjunctions.
    [[nodiscard]] Truth evaluate_parts(const Formula& formula, Truth decisive) const {
        Truth result = negate_truth(decisive);
        for (const Formula& part : formula.parts) {
            const Truth truth = evaluate_formula(part);
            if (truth == decisive) return decisive;
            if (truth == Truth::open) result = Truth::open;
        }
        return result;
    }

    [[nodiscard]] Truth evaluate_formula(const Formula& formula) const {
        switch (formula.form) {
            case Formula::Form::constant:
                return formula.value ? Truth::yes : Truth::no;
            case Formula::Form::atom: {
                const Reasoner::Atom& atom = reasoner_.atoms_[formula.atom];
                if (!values_[atom.key].chosen) return Truth::open;
                return atom_holds(atom) ? Truth::yes : Truth::no;
            }
            case Formula::Form::negation:
                return negate_truth(evaluate_formula(formula.parts[0]));
            case Formula::Form::conjunction:
                return evaluate_parts(formula, Truth::no);
            case Formula::Form::disjunction:
                return evaluate_parts(formula, Truth::yes);
            case Formula::Form::equivalence: {
                const Truth left = evaluate_formula(formula.parts[0]);
                const Truth right = evaluate_formula(formula.parts[1]);
                if (left == Truth::open || right == Truth::open) return Truth::open;
                return left == right ? Truth::yes : Truth::no;
            }
            case Formula::Form::choice:
                break;
        }
        const Truth condition = evaluate_formula(formula.parts[0]);
        if (condition == Truth::open) return Truth::open;
        return evaluate_formula(formula.parts[condition == Truth::yes ? 1 : 2]);
    }

    // ------------------------------------------------------------ forms that share terms

    [[nodiscard]] bool number_chosen(std::size_t key) const {
        return values_[key].chosen && reasoner_.keys_[key].kind == Reasoner::KeyKind::number;
    }

    /// Returns the terms that occur in a linear form together with other terms.
    [[nodiscard]] std::set<std::string> shared_terms() const {
        std::set<std::string> result;
        for (std::size_t i = 0; i < values_.size(); ++i)
            if (number_chosen(i) && reasoner_.keys_[i].form.size() > 1)
                for (const auto& term : reasoner_.keys_[i].form) result.insert(term.first);
        return result;
    }

    static void add_constraint(std::vector<Constraint>& all, const std::map<std::string, double>& form, double factor,
                               double bound, bool strict) {
        if (std::isinf(bound)) return;
        Constraint made;
        for (const auto& [term, coefficient] : form) made.terms[term] = factor * coefficient;
        made.bound = factor * bound;
        made.strict = strict;
        all.push_back(std::move(made));
    }

    [[nodiscard]] std::vector<Constraint> collect_constraints() const {
        std::vector<Constraint> result;
        for (std::size_t i = 0; i < values_.size(); ++i) {
            if (!number_chosen(i)) continue;
            const Reasoner::Key& key = reasoner_.keys_[i];
            const Region& region = values_[i].region;
            const bool tight = key.integer && !region.point;  // < c is <= ceil(c) - 1 on integers
            add_constraint(result, key.form, 1, tight ? std::ceil(region.high) - 1 : region.high,
                           !region.point && !tight);
            add_constraint(result, key.form, -1, tight ? std::floor(region.low) + 1 : region.low,
                           !region.point && !tight);
        }
        for (const std::string& term : shared_terms()) {
            const Reasoner::Term& known = reasoner_.terms_.at(term);
            if (known.least) add_constraint(result, {{term, 1.0}}, -1, *known.least, false);
        }
        return result;
    }

    /// Adds multiples of a and b, in which the term has opposite signs, so that the term disappears.
    static Constraint eliminate_term(const Constraint& a, const Constraint& b, const std::string& term) {
        const double up = 1 / a.terms.at(term);
        const double down = -1 / b.terms.at(term);
        Constraint result;
        result.strict = a.strict || b.strict;
        result.bound = a.bound * up + b.bound * down;
        for (const auto& [name, factor] : a.terms) result.terms[name] += factor * up;
        for (const auto& [name, factor] : b.terms) result.terms[name] += factor * down;
        result.terms.erase(term);
        std::erase_if(result.terms, [](const auto& entry) { return std::abs(entry.second) < tolerance; });
        return result;
    }

    Truth fits_together() {
        if (shared_terms().empty()) return Truth::yes;
        if (++eliminations_ > max_eliminations) return Truth::open;
        std::vector<Constraint> open = collect_constraints();
        while (true) {
            std::vector<Constraint> next;
            std::string term;
            for (const Constraint& constraint : open) {
                if (constraint.terms.empty()) {
                    if (constraint.strict ? constraint.bound <= tolerance : constraint.bound < -tolerance)
                        return Truth::no;
                } else if (term.empty()) {
                    term = constraint.terms.begin()->first;
                }
            }
            if (term.empty()) return Truth::yes;
            for (const Constraint& a : open) {
                if (next.size() > max_constraints) return Truth::open;
                if (!a.terms.contains(term)) next.push_back(a);
                if (!a.terms.contains(term) || a.terms.at(term) < 0) continue;
                for (const Constraint& b : open)
                    if (b.terms.contains(term) && b.terms.at(term) < 0) next.push_back(eliminate_term(a, b, term));
            }
            open = std::move(next);
        }
    }

    // ------------------------------------------------------------ the example in words

    static std::string format_number(double value) {
        std::string text = std::to_string(value);
        if (text.find('.') == std::string::npos) return text;
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
        return text;
    }

    void describe_key(std::size_t index, const std::set<std::string>& shared, std::vector<std::string>& parts) const {
        const Reasoner::Key& key = reasoner_.keys_[index];
        const Value& value = values_[index];
        const bool alone = key.form.size() == 1 && !shared.contains(key.form.begin()->first);
        if (key.kind == Reasoner::KeyKind::boolean)
            parts.push_back("`" + key.text + "` is " + (value.index == 1 ? "true" : "false"));
        else if (key.kind == Reasoner::KeyKind::enumeration)
            parts.push_back("`" + key.text + "` is " + key.literals[value.index]);
        else if (alone)
            parts.push_back("`" + key.form.begin()->first + "` is " + format_number(value.region.sample));
        if (key.kind != Reasoner::KeyKind::number || alone) return;
        for (const Reasoner::Atom& atom : reasoner_.atoms_)
            if (atom.key == index) parts.push_back("`" + atom.text + "` is " + (atom_holds(atom) ? "true" : "false"));
    }

    void describe_solution(Finding& finding) const {
        std::vector<std::string> parts;
        const std::set<std::string> shared = shared_terms();
        std::size_t relations = 0;
        for (const std::size_t i : order_) {
            if (!values_[i].chosen) continue;
            if (reasoner_.keys_[i].form.size() > 1 && ++relations > 1) finding.trusted = false;
            describe_key(i, shared, parts);
            if (reasoner_.keys_[i].opaque) finding.trusted = false;
        }
        diagnostics::erase_repeated(parts);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (i > 0) finding.example += i + 1 == parts.size() ? " and " : ", ";
            finding.example += parts[i];
        }
    }

    const Reasoner& reasoner_;
    const Formula& formula_;
    std::vector<std::size_t> order_;
    std::vector<Value> values_;
    std::size_t steps_ = 0;
    std::size_t eliminations_ = 0;
};

Finding Reasoner::decide(const Formula& formula) const {
    return Search(*this, formula).run();
}

}  // namespace robochart::frontend::logic
