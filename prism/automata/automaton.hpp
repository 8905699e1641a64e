// SPDX-License-Identifier: Apache-2.0
// Builds deterministic automata for formulas of LTL. The formula is converted to a condition: a disjunction of
// conjunctions of parts or their negations. A part is a co-safe formula, or G of a co-safe formula. Safe formulas and F
// of safe formulas are the negations of such parts. Co-safe: Kupferman and Vardi, Model Checking of Safety Properties,
// 2001. G of a co-safe formula holds if the copies of the formula that begin in each state are all fulfilled
// eventually. The copies are tracked in batches, and the automaton is marked when a batch is fulfilled and the next
// batch begins (Esparza, Kretinsky and Sickert, A Unified Translation of Linear Temporal Logic to omega-Automata,
// 2020).
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "prism/automata/residues.hpp"

namespace robochart::prism::automata {

struct Part {
    FormulaId formula = 0;  ///< co-safe
    bool always = false;    ///< the part is G of the formula
    friend bool operator==(const Part&, const Part&) = default;
};

/// The index of a part, and whether the part must hold.
using Literal = std::pair<std::size_t, bool>;
using Conjunction = std::vector<Literal>;

struct Condition {
    std::vector<Part> parts;
    std::vector<Conjunction> any;
};

/// Converts a formula to a condition. Throws NotDecided if no condition is equivalent to the formula.
[[nodiscard]] Condition condition(Formulas& formulas, FormulaId formula);

class Automaton {
public:
    using State = std::uint32_t;

    /// `residues` must outlive the object.
    Automaton(Residues& residues, std::vector<Part> parts);

    [[nodiscard]] State start() const { return 0; }
    /// Throws NotDecided.
    [[nodiscard]] State successor_of(State state, Letter letter);
    /// Returns whether the formula of a part without `always` holds.
    [[nodiscard]] bool is_done(State state, std::size_t part) const {
        return states_[state][part].now == Residues::yes;
    }
    /// Returns whether a batch of an `always` part is fulfilled.
    [[nodiscard]] bool is_marked(State state, std::size_t part) const { return states_[state][part].marked; }
    [[nodiscard]] std::size_t states() const { return states_.size(); }

private:
    struct OfPart {
        ResidueId now = Residues::yes;    ///< what remains to be fulfilled; for `always`, of the current batch
        ResidueId later = Residues::yes;  ///< for `always`: the same for the copies that have begun since
        bool marked = false;
        friend auto operator<=>(const OfPart&, const OfPart&) = default;
    };

    [[nodiscard]] OfPart successor_of(const OfPart& before, const Part& part, Letter letter);
    State add(std::vector<OfPart> state);

    static constexpr std::size_t most_states = 20'000;
    Residues& residues_;
    std::vector<Part> parts_;
    std::vector<std::vector<OfPart>> states_;
    std::map<std::vector<OfPart>, State> known_;
    std::map<std::pair<State, Letter>, State> after_;
};

}  // namespace robochart::prism::automata
