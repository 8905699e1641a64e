// The questions that the random checks ask of a pair of processes, M0 and M1, with the answers by definition.
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
    int left = 0;  ///< refinement: the specification's number; else the process's
    int right = 0;
};

/// Every question, in a fixed order.
[[nodiscard]] const std::vector<Question>& questions();

/// A script with two mains, and the trace that is asked for.
struct Case {
    naive::Script script;
    std::vector<naive::Letter> trace;
};

/// "[T=", "deadlock free" and so on: what kind of question it is.
[[nodiscard]] std::string topic(const Question& question);
/// The question as an assertion about M0 and M1.
[[nodiscard]] std::string assertion(const Question& question, const std::vector<naive::Letter>& trace);
/// The case with all its assertions, in the order of questions(): a script to load.
[[nodiscard]] std::string cspm(const Case& asked);

/// The two graphs of a case; none if they are larger than a test wants.
struct Graphs {
    naive::Graph graphs[2];
};
[[nodiscard]] std::optional<Graphs> explore(const Case& asked, std::size_t largest);
/// The answer by definition.
[[nodiscard]] bool expected(const Question& question, const Graphs& graphs, const std::vector<naive::Letter>& trace);

/// Smaller and smaller cases that still fail: processes are replaced by their parts and by STOP, sets lose members.
template <class Fails>
[[nodiscard]] Case shrink(Case failing, const Fails& fails);

/// All cases one step smaller, the smallest first.
[[nodiscard]] std::vector<Case> smaller(const Case& asked);

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
