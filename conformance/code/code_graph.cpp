// SPDX-License-Identifier: Apache-2.0
#include "conformance/code/code_graph.hpp"

#include "checker/refine/search/budget.hpp"

namespace robochart::conformance {

lts::Graph explore_code(CodeSystem& system, const refine::Limits& limits) {
    refine::Budget budget(limits);
    return lts::explore(system,
                        [&](std::size_t states) {
                            budget.states(states);
                            budget.charge();
                        })
        .graph;
}

}  // namespace robochart::conformance
