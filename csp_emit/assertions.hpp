// SPDX-License-Identifier: Apache-2.0
// Writes assertions of the model as CSPM assertions (docs/semantics.md, "Assertions").
#pragma once

#include <set>
#include <string>
#include <vector>

#include "csp_emit/base/component.hpp"
#include "csp_emit/base/names.hpp"

namespace robochart::csp_emit {

/// Returns an obligation for each property that is decided in this semantics. An obligation may need new declarations,
/// which get unique names. Their meanings are added to the provenance.
[[nodiscard]] std::vector<Obligation> make_obligations(const Project&, NameManager&, Emitted&);
/// RoboSim: the names of cycles without a length.
[[nodiscard]] std::set<std::string> open_cycles(const ir::System&);
/// RoboSim: the parameters of the component's process that are cycles without a length.
[[nodiscard]] std::vector<const ConstantParameter*> open_parameters(const ComponentEmission&,
                                                                    const std::set<std::string>& open_cycles);
/// RoboSim: the reason why a component with such a parameter has no process.
[[nodiscard]] std::string missing_cycle(const std::string& component);
/// Returns the component's process of this variant ("D__") with defaults for its parameters.
[[nodiscard]] cspm::ExprPtr default_process(const Project&, const std::string& path, const ComponentEmission&,
                                            const std::string& variant);
/// Returns the default arguments of the component's process. The first is the argument for `id__`.
[[nodiscard]] std::vector<cspm::ExprPtr> default_arguments(const Project&, const ComponentEmission&);

}  // namespace robochart::csp_emit
