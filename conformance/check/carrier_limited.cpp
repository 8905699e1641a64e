// SPDX-License-Identifier: Apache-2.0
#include "conformance/check/carrier_limited.hpp"

#include <vector>

#include "checker/cspm/session.hpp"
#include "counterexample/evaluation_failure.hpp"

namespace robochart::conformance {
namespace {

/// Collects the successors until all of them are known.
class Successors final : public lts::SuccessorSink {
public:
    void add(lts::Event event, lts::StateView target, lts::Event revealed) override {
        steps_.push_back({event, revealed, {target.begin(), target.end()}});
    }
    void pass_to(lts::SuccessorSink& sink) const {
        for (const Step& step : steps_) sink.add(step.event, step.target, step.revealed);
    }

private:
    struct Step {
        lts::Event event, revealed;
        std::vector<lts::Word> target;
    };
    std::vector<Step> steps_;
};

}  // namespace

void CarrierLimited::successors(lts::StateView state, lts::SuccessorSink& sink) {
    try {
        Successors all;
        model_.successors(state, all);
        all.pass_to(sink);
    } catch (const cspm::EvaluationError& error) {
        if (!runs::leaves_carriers(error.what())) throw;
        unknown_.insert(key_of(state));
        sink.add(tock_, state, tock_);
    }
}

}  // namespace robochart::conformance
