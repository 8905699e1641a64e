// SPDX-License-Identifier: Apache-2.0
// Loads a component for monitors, test suites and logs: emits its timed script, compiles D__ and builds its normal
// form.
#include "conformance/model/cyclic_model.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "conformance/model/component.hpp"
#include "conformance/model/component_in_cycles.hpp"
#include "conformance/model/renamed_model.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::conformance {

namespace {

/// Whether the states of the model are evaluated only when they are visited. Compilation evaluates all states of a
/// component. Their number is a power of the number of values. If results are not clipped, some states have results
/// outside the carriers.
bool is_evaluated_lazily(const ir::Instantiation& instantiation) {
    constexpr std::size_t most_compiled = 64;
    if (instantiation.unbounded) return true;
    return std::max({instantiation.nat.size(), instantiation.integer.size(), instantiation.real.size()}) >
           most_compiled;
}

}  // namespace

std::unique_ptr<CyclicModel> CyclicModel::load(const ir::System& system, const ir::Instantiation& instantiation,
                                               const ir::ComponentRef& ref, std::uint32_t cycle_length,
                                               const refine::Limits& limits, diagnostics::SourceManager& sources,
                                               diagnostics::Diagnostics& diagnostics, std::string& error,
                                               const cpp_emit::EventOrder& order) {
    const std::size_t errors = diagnostics.error_count();
    std::unique_ptr<CyclicModel> loaded(new CyclicModel);
    loaded->system_ = &system;
    loaded->instantiation_ = &instantiation;
    ir::Instantiation with_cycle = instantiation;
    if (ir::is_robosim(system, ref))
        with_cycle.constants[ir::constant_name(ref.package, ref.path, ir::cycle_length)] = {cycle_length, {}};
    // CSP blocks are removed, because a block that replaces the instantiation would give the model other values than
    // the code.
    const RenamedModel safe = renamed_model(system, with_cycle, ref, diagnostics);
    loaded->cycle_length_ = cycle_length;
    loaded->script_ = csp_emit::emit(safe.system, safe.instantiation, csp_emit::Time::timed, {}, sources, diagnostics);
    const cspm::ExprPtr process = component_process(loaded->script_.definitions, safe.component);
    if (diagnostics.error_count() != errors || !process) {
        error = fmt::format("{} has no timed CSP semantics here", ref.path);
        return nullptr;
    }
    auto shown = conformance::model_interface(safe.system, safe.instantiation, safe.component,
                                              loaded->script_.provenance, diagnostics);
    auto outside =
        conformance::component_interface(system, instantiation, ref, loaded->script_.provenance, diagnostics);
    if (!shown || !outside || diagnostics.error_count() != errors) {
        error = fmt::format("{} has no inputs and outputs of a controller", ref.path);
        return nullptr;
    }
    loaded->boundary_ = std::move(*shown);
    loaded->outside_ = std::move(*outside);
    loaded->boundary_.interface.drops = dropped_inputs(loaded->outside_, order);
    loaded->session_ = std::make_unique<cspm::Session>(loaded->script_.definitions);
    loaded->process_ = process;
    loaded->model_ = is_evaluated_lazily(instantiation) ? loaded->session_->system(process)
                                                        : loaded->session_->system(process, limits);
    loaded->alphabet_ = std::make_unique<Alphabet>(loaded->boundary_.interface, loaded->session_->event_table());
    loaded->graph_ = std::make_unique<ModelGraph>(*loaded->model_, *loaded->alphabet_);
    loaded->normal_form_ = component_in_cycles(*loaded->graph_, *loaded->alphabet_, cycle_length);
    return loaded;
}

}  // namespace robochart::conformance
