// SPDX-License-Identifier: Apache-2.0
// Lists the questions that the random tests ask about a pair of processes, M0 and M1, with the answers by definition.
#pragma once

#include <string>
#include <vector>

#include "checker/refine/verdict/check.hpp"
#include "naive.hpp"

namespace robochart::refine {

struct Question {
    enum class Kind { refinement, deadlock_free, divergence_free, deterministic, has_trace };
    Kind kind = Kind::refinement;
    naive::Semantics semantics = naive::Semantics::T;
    int left = 0;  ///< refinement: the number of the specification; otherwise of the process
    int right = 0;
};

/// Returns all questions, in a fixed order.
[[nodiscard]] const std::vector<Question>& questions();

/// A script with two main processes, and the trace for the trace questions.
struct Case {
    naive::Script script;
    std::vector<naive::Letter> trace;
};

/// Returns the kind of the question: "[T=", "deadlock free" and so on.
[[nodiscard]] std::string assertion_kind(const Question& question);
/// Returns the question as an assertion about M0 and M1.
[[nodiscard]] std::string assertion(const Question& question, const std::vector<naive::Letter>& trace);
/// Returns the case as a script with all its assertions, in the order of questions().
[[nodiscard]] std::string script_with_assertions(const Case& test_case);

/// The two graphs of a case. `graphs_of` returns nullopt if they are larger than a test can use.
struct Graphs {
    naive::Graph graphs[2];
};
[[nodiscard]] std::optional<Graphs> explore(const Case& test_case, std::size_t largest);
/// Returns the answer by definition.
[[nodiscard]] bool expected(const Question& question, const Graphs& graphs, const std::vector<naive::Letter>& trace);

/// Shrinks a case as long as it still fails: replaces processes by their operands or by STOP, and removes elements from
/// sets.
template <class Fails>
[[nodiscard]] Case shrink(Case failing, const Fails& fails);

/// Returns all cases that are one step smaller, the smallest first.
[[nodiscard]] std::vector<Case> smaller(const Case& test_case);

template <class Fails>
Case shrink(Case failing, const Fails& fails) {
    for (bool found = true; found;) {
        found = false;
        for (Case& next : smaller(failing)) {
            if (!fails(next)) continue;
            failing = std::move(next);
            found = true;
            break;
        }
    }
    return failing;
}

}  // namespace robochart::refine
