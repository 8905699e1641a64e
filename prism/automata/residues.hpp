// SPDX-License-Identifier: Apache-2.0
// Computes what remains of a formula after the first states of a path (its derivatives). A rest is a Boolean function
// of formulas that must hold from the next state on. The functions are binary decision diagrams, so equal rests have
// the same number, and a formula has only finitely many rests.
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "prism/automata/formulas.hpp"

namespace robochart::prism::automata {

/// The atoms that hold in a state, as bits.
using Letter = std::uint64_t;
inline constexpr std::size_t most_atoms = 64;

/// Thrown if a formula is not supported, or if its automaton becomes too large.
class NotDecided : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

using ResidueId = std::uint32_t;

class Residues {
public:
    static constexpr ResidueId no = 0;   ///< cannot hold any more
    static constexpr ResidueId yes = 1;  ///< holds for all continuations

    /// `formulas` must outlive the object.
    explicit Residues(Formulas& formulas);

    [[nodiscard]] ResidueId residue_of(FormulaId formula);
    /// Returns the rest of the formula after a state. Throws NotDecided.
    [[nodiscard]] ResidueId residue_after(ResidueId residue, Letter letter);
    [[nodiscard]] ResidueId conjunction_of(ResidueId a, ResidueId b) { return choice(a, b, no); }

private:
    struct Node {
        std::uint32_t variable = 0;
        ResidueId low = 0, high = 0;
    };
    struct Pair {
        std::uint64_t first = 0, second = 0;
        friend bool operator==(const Pair&, const Pair&) = default;
    };
    struct HashPair {
        std::size_t operator()(const Pair& pair) const;
    };

    ResidueId variable(FormulaId formula);
    ResidueId node(std::uint32_t variable, ResidueId low, ResidueId high);
    /// Returns the decision diagram "if `condition` then `then`, else `otherwise`".
    ResidueId choice(ResidueId condition, ResidueId then, ResidueId otherwise);
    ResidueId step(FormulaId formula, Letter letter);
    [[nodiscard]] std::uint32_t variable_of(ResidueId id) const;

    static constexpr std::size_t most_nodes = 1'000'000;
    Formulas& formulas_;
    std::vector<Node> nodes_;
    std::vector<FormulaId> variables_;  ///< formulas of the variables
    std::map<FormulaId, std::uint32_t> number_;
    std::unordered_map<Pair, ResidueId, HashPair> known_;
    std::map<std::tuple<ResidueId, ResidueId, ResidueId>, ResidueId> choices_;
    std::unordered_map<Pair, ResidueId, HashPair> after_;  ///< by residue and letter
};

}  // namespace robochart::prism::automata
