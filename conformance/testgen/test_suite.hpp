// SPDX-License-Identifier: Apache-2.0
// Computes a finite complete test suite for a machine over cycles by the HSI method, a W-method with harmonised state
// identifiers (Petrenko, Yevtushenko, Lebedev, Das, "Nondeterministic state machines in protocol conformance testing",
// 1993; Luo, Petrenko, v. Bochmann 1994). The suite is complete: a deterministic implementation over the same inputs
// with at most m more states than the machine passes all tests if and only if it is equivalent to the machine.
#pragma once

#include <string>
#include <vector>

#include "conformance/testgen/cycle_automaton.hpp"
#include "cpp_emit/emit.hpp"

namespace robochart::conformance {

/// A sequence of input symbols, one for each cycle, from the initial state.
using TestWord = std::vector<std::uint32_t>;

/// Returns the words of the suite, sorted. No word is a prefix of another. Throws std::length_error if all words
/// together are longer than `most_cycles`.
[[nodiscard]] std::vector<TestWord> complete_suite(const CycleAutomaton&, std::uint32_t extra_states,
                                                   std::size_t most_cycles = 2'000'000);

/// Returns the suite as a log of runs (docs/traces.md). An implementation must produce the outputs of the model.
[[nodiscard]] std::string suite_log(const CycleAutomaton&, const std::vector<TestWord>&, const CyclicModel&,
                                    const std::string& component, std::uint32_t extra_states);
/// For a model with choices: return the machine, and a GoogleTest program whose tests adapt to the implementation
/// (cpp_emit/runtime/adaptive.hpp).
[[nodiscard]] std::string choice_graph(const ChoiceAutomaton&, const CyclicModel&, const std::string& component,
                                       std::uint32_t extra_states);
[[nodiscard]] std::vector<cpp_emit::OutputFile> adaptive_sources(const std::string& name);
/// Returns a GoogleTest program that reads the log of a suite and replays it with the user's implementation
/// (docs/conformance.md).
[[nodiscard]] std::vector<cpp_emit::OutputFile> suite_sources(const std::string& name);

}  // namespace robochart::conformance
