// SPDX-License-Identifier: Apache-2.0
// Computes the normal form as a finite state machine over control cycles. In a state of the machine a cycle may begin.
// An input symbol is one reading of every register, and an output symbol is the sequence of writes in the cycle. The
// machine is complete and minimal. It is deterministic unless the model has choices. With choices, an input may have
// several steps, which differ in their writes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "conformance/model/cyclic_model.hpp"

namespace robochart::conformance {

struct CycleStep {
    std::vector<process::Event> writes;
    std::uint32_t target = 0;  ///< `over` after termination
    friend bool operator==(const CycleStep&, const CycleStep&) = default;
};

struct CycleAutomaton {
    static constexpr std::uint32_t over = 0xffffffffU;

    std::vector<std::vector<std::uint32_t>> inputs;  ///< by symbol: a reading of each register
    std::vector<std::vector<CycleStep>> steps;       ///< [state][symbol]; state 0 is the initial state

    [[nodiscard]] std::size_t state_count() const { return steps.size(); }
};

struct ChoiceAutomaton {
    std::vector<std::vector<std::uint32_t>> inputs;             ///< as in CycleAutomaton
    std::vector<std::vector<std::vector<CycleStep>>> branches;  ///< [state][symbol], at least one

    [[nodiscard]] std::size_t state_count() const { return branches.size(); }
    /// Returns whether every input has a single branch.
    [[nodiscard]] bool is_deterministic() const;
};

/// Explores the machine. Throws std::length_error if it is too large, process::Interrupted at a limit.
[[nodiscard]] ChoiceAutomaton choice_automaton(CyclicModel&, const refine::Limits&);
/// Explores a deterministic machine. Throws std::length_error if it is too large or the model has choices, and
/// process::Interrupted at a limit.
[[nodiscard]] CycleAutomaton cycle_automaton(CyclicModel&, const refine::Limits&);

}  // namespace robochart::conformance
