// SPDX-License-Identifier: Apache-2.0
// The project in which classes of values replace data, for claims that do not observe values (docs/data.md).
#pragma once

#include <memory>
#include <set>
#include <vector>

#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"
#include "semantics/data/class_model.hpp"

namespace robochart::driver {

struct ClassProject {
    std::unique_ptr<Project> project;
    std::vector<ir::ReplacedData> data;
    std::vector<ir::KeptData> kept;  ///< empty if the settings or a CSP block choose the carriers
    bool small_carriers = false;     ///< the replaced data have few values in the finite instantiation
};

/// True if the settings choose carriers of numbers.
[[nodiscard]] bool chooses_ranges(const Project& project);

/// True if all claims are decided in the finite instantiation: because the settings ask for it or choose ranges,
/// because a CSP block replaces the instantiation, or because a swarm is decided.
[[nodiscard]] bool keeps_carriers(const Project& project, const Settings& settings);

/// The project with classes of values, without the claims that observe values. Null if carriers are kept, or if no data
/// can be replaced. Also null if there are claims that observe values, and the values are few or all occur in the
/// model, because claims that observe values and other claims then share the compiled components.
[[nodiscard]] ClassProject class_project(const Project& project, const Settings& settings);

/// The project in which computed data are free (ir::free_model), without the claims that observe values.
struct FreeProject {
    std::unique_ptr<Project> project;  ///< null if carriers are kept, or if no data can be replaced
    std::size_t conditions = 0;        ///< conditions that may have either answer
    bool has_large_carriers = false;   ///< true if it replaces data with large carriers that `classes` does not replace
};
[[nodiscard]] FreeProject free_project(const Project& project, const Settings& settings, const ClassProject& classes);
/// Whether an answer of the free model is also true of the model, because the model refines it. This is the case if the
/// answer states that the behaviour of the free model is within that of a specification. Answers that state that a run
/// exists, or that steps are possible from all states, do not carry over.
[[nodiscard]] bool carries_over(const csp_emit::Obligation& obligation, Answer found);

/// Whether some claim may observe values of events: comparisons of components, rules, claims of claims files, and CSP
/// blocks.
[[nodiscard]] bool has_observers(const Project& project);
/// True if the answer with classes does not decide a claim of determinism. There are two cases: the claim holds with
/// classes, and outputs are replaced by names of classes; or conditions relate variables, whatever the answer is
/// (semantics/data/class_model.hpp).
[[nodiscard]] bool is_open_in_classes(const Project& classes, const csp_emit::Obligation& obligation, Answer found);
/// True if a claim of this system is decided in the finite instantiation, because it observes values or because its
/// answer with classes may not decide it.
[[nodiscard]] bool is_decided_in_carriers(const ClassProject& classes, const ir::System& system,
                                          const csp_emit::Obligation& obligation);

}  // namespace robochart::driver
