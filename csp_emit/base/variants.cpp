// SPDX-License-Identifier: Apache-2.0
// Applies priority and compression as RoboTool does.
#include "csp_emit/base/variants.hpp"

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

ExprPtr maximal_progress(const Project& project, const ExprPtr& process, const ExprPtr& urgent) {
    if (!project.is_timed()) return process;
    const ExprPtr first = urgent ? urgent : b::set({});
    return b::call("prioritise", {process, b::sequence({first, b::set({b::name("tock")})})});
}

ExprPtr compress_process(const Project& project, const ExprPtr& process, bool large) {
    if (large) return process;
    return project.is_timed() ? b::call("dbisim", {process}) : b::call("sbisim", {b::call("diamond", {process})});
}

}  // namespace robochart::csp_emit
