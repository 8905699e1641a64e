// SPDX-License-Identifier: Apache-2.0
// Deterministic automata for formulas of LTL. A condition is a disjunction of conjunctions of parts or their negations.
// A part is a co-safe formula, or G of a co-safe formula. The negation of a safe formula, or of F of a safe formula, is
// such a part. Co-safe: Kupferman and Vardi, Model Checking of Safety Properties, 2001. G of a co-safe formula holds if
// the copies of the formula that begin in each state are all fulfilled eventually. The copies are tracked in batches,
// and the automaton is marked when a batch is fulfilled and the next one begins (Esparza, Kretinsky and Sickert, A
// Unified Translation of Linear Temporal Logic to omega-Automata, 2020).
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

/// A part, and whether it must hold.
using Literal = std::pair<std::size_t, bool>;
using Conjunction = std::vector<Literal>;

struct Condition {
    std::vector<Part> parts;
    std::vector<Conjunction> any;
};

/// Throws NotDecided if the formula is not equivalent to such a condition.
[[nodiscard]] Condition condition(Formulas& formulas, FormulaId formula);

class Automaton {
public:
    using State = std::uint32_t;

    /// `residues` must outlive the object.
    Automaton(Residues& residues, std::vector<Part> parts);

    [[nodiscard]] State start() const { return 0; }
    /// Throws NotDecided.
    [[nodiscard]] State successor_of(State state, Letter letter);
    /// Whether the formula of a part that is not `always` holds.
    [[nodiscard]] bool is_done(State state, std::size_t part) const {
        return states_[state][part].now == Residues::yes;
    }
    /// Whether a batch of a part that is `always` is fulfilled.
    [[nodiscard]] bool is_marked(State state, std::size_t part) const { return states_[state][part].marked; }
    [[nodiscard]] std::size_t states() const { return states_.size(); }

private:
    struct OfPart {
        ResidueId now = Residues::yes;    ///< for `always`: of the current batch
        ResidueId later = Residues::yes;  ///< for `always`: of the copies that have begun since
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
