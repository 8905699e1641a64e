// SPDX-License-Identifier: Apache-2.0
#include "tests/checker/processes/verdict_text.hpp"

namespace robochart::refine {

std::string complete_text(const Verdict& verdict) {
    const Statistics& size = verdict.statistics;
    std::string text = std::to_string(static_cast<int>(verdict.outcome)) + verdict.reason;
    for (const std::uint64_t figure :
         {size.states, size.transitions, size.depth, size.chased, size.spec_nodes, size.replicas})
        text += " " + std::to_string(figure);
    if (!verdict.counterexample) return text;
    text += " kind " + std::to_string(static_cast<int>(verdict.counterexample->kind));
    for (const auto* steps : {&verdict.counterexample->steps, &verdict.counterexample->loop}) {
        text += "\n  run:";
        for (const Step& step : *steps)
            text += " " + std::to_string(step.event) + "/" + std::to_string(step.revealed) + ">" + step.state;
    }
    return text;
}

}  // namespace robochart::refine
