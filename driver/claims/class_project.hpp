// SPDX-License-Identifier: Apache-2.0
// Makes projects in which classes of values replace data, for claims that do not observe values (docs/data.md).
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

/// Returns true if the settings give the carrier of a number type.
[[nodiscard]] bool chooses_ranges(const Project& project);

/// Returns true if all claims must be decided in the finite instantiation: the settings
/// require it or choose ranges, a CSP block replaces it, or the claims are claims of a
/// swarm.
[[nodiscard]] bool keeps_carriers(const Project& project, const Settings& settings);

/// Returns the project with classes of values, without the claims that observe values. `project` is null if
/// keeps_carriers() is true, or if no data can be replaced. `project` is also null if some claims observe values, and
/// there are few values or all values occur in the model. In this case, all claims share the compiled components.
[[nodiscard]] ClassProject class_project(const Project& project, const Settings& settings);

/// The project in which computed data are free (ir::free_model), without the claims that observe values.
struct FreeProject {
    std::unique_ptr<Project> project;  ///< null if carriers are kept, or if no data can be replaced
    std::size_t conditions = 0;        ///< number of conditions that may be true or false
    bool has_large_carriers = false;   ///< true if it replaces data with large carriers beyond those of `classes`
};
[[nodiscard]] FreeProject free_project(const Project& project, const Settings& settings, const ClassProject& classes);
/// Returns true if an answer for the free model also applies to the model, which refines the free model. An answer
/// applies if a specification allows all behaviour of the free model. An answer does not apply if it says that a run
/// exists, or that steps are possible from all states.
[[nodiscard]] bool carries_over(const csp_emit::Obligation& obligation, Answer found);

/// Returns true if a claim may observe values of events: comparisons of components, rules, claims of claims files, and
/// claims with CSP blocks.
[[nodiscard]] bool has_observers(const Project& project);
/// Returns true if the answer with classes does not decide a claim of determinism. An answer `holds` does not decide
/// the claim if names of classes replace outputs. If conditions relate variables, neither answer decides the claim
/// (semantics/data/class_model.hpp).
[[nodiscard]] bool is_open_in_classes(const Project& classes, const csp_emit::Obligation& obligation, Answer found);
/// Returns true if a claim of this system is decided in the finite instantiation, because it observes values or because
/// its answer with classes may not decide it.
[[nodiscard]] bool is_decided_in_carriers(const ClassProject& classes, const ir::System& system,
                                          const csp_emit::Obligation& obligation);

}  // namespace robochart::driver
