// SPDX-License-Identifier: Apache-2.0
#include "counterexample/failing_run.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

#include "counterexample/evaluation_failure.hpp"
#include "counterexample/interpreter.hpp"

namespace robochart::runs {
namespace {

using process::TermId;

/// Searches breadth first and remembers, for each state, the step by which it was found.
class FailureSearch {
public:
    FailureSearch(const Context& context, csp_emit::Time time) : context_(context), time_(time) {}

    std::optional<FailingRun> run(TermId process, std::uint64_t most, diagnostics::Pollable& budget) {
        found_.emplace(process, Found{process, {}});
        waiting_.push_back(process);
        for (std::uint64_t states = 0; !waiting_.empty() && states < most; ++states) {
            budget.poll();
            const TermId term = waiting_.front();
            waiting_.pop_front();
            try {
                for (const process::Transition& step : context_.session.transitions(term))
                    if (found_.emplace(step.target, Found{term, step}).second) waiting_.push_back(step.target);
            } catch (const cspm::EvaluationError& error) {
                return failing_run(process, term, placed_failure(error, context_.system, context_.sources));
            }
        }
        return std::nullopt;
    }

private:
    struct Found {
        TermId from;
        process::Transition step;
    };

    [[nodiscard]] FailingRun failing_run(TermId process, TermId last, const std::string& failure) const {
        refine::Counterexample shown;
        shown.kind = refine::ViolationKind::no_trace;
        for (TermId term = last; term != process; term = found_.at(term).from) {
            const process::Transition& step = found_.at(term).step;
            shown.steps.push_back({step.event, step.revealed, process::describe(context_.session.terms(), term)});
            shown.terms.push_back(term);
        }
        shown.terms.push_back(process);
        std::ranges::reverse(shown.steps);
        std::ranges::reverse(shown.terms);
        shown.initial = process::describe(context_.session.terms(), process);
        csp_emit::Obligation obligation;
        obligation.kind = ir::PropertyKind::refines;
        obligation.time = time_;
        FailingRun result{interpret_counterexample(context_, obligation, shown), failure};
        result.run.end = {};
        result.run.end.kind = EndKind::undefined;
        result.run.end.why = "the next step is not known: " + failure;
        return result;
    }

    const Context& context_;
    csp_emit::Time time_;
    std::map<TermId, Found> found_;
    std::deque<TermId> waiting_;
};

}  // namespace

std::optional<FailingRun> find_failing_run(const Context& context, csp_emit::Time time, TermId process,
                                           std::uint64_t most, diagnostics::Pollable& budget) {
    return FailureSearch(context, time).run(process, most, budget);
}

}  // namespace robochart::runs
