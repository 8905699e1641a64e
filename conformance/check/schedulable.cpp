// SPDX-License-Identifier: Apache-2.0
#include "conformance/check/schedulable.hpp"

#include "conformance/check/conformance_check.hpp"
#include "conformance/check/cycle_schedule.hpp"
#include "conformance/check/standstill.hpp"

namespace robochart::conformance {

Result run_in_cycles(CyclicModel& model, const diagnostics::SourceManager& sources, const refine::Limits& limits) {
    const auto decide = many_valuations(model.interface()) ? schedulable_on_demand : check_schedulability;
    Result result = decide(model.graph(), model.alphabet(), model.cycle_length(), limits);
    Options options;
    options.cycle_length = model.cycle_length();
    options.limits = limits;
    explain_result(result, model.session(), model.process(), model.alphabet(),
                   {model.provenance(), model.system(), model.instantiation(), sources}, options);
    return result;
}

}  // namespace robochart::conformance
