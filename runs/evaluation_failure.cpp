#include "runs/evaluation_failure.hpp"

#include "diagnostics/escape.hpp"
#include "semantics/ir/element_at.hpp"

namespace robochart::runs {

std::string failure(const cspm::EvaluationError& error, const ir::System& system) {
    const std::string element = ir::element_at(system, error.span);
    return element.empty() ? error.what() : error.what() + (", in " + element);
}

std::string placed_failure(const cspm::EvaluationError& error, const ir::System& system,
                           const diagnostics::SourceManager& sources) {
    const std::string place = sources.place(error.span);
    return (place.empty() ? "" : diagnostics::shown(place) + ": ") + failure(error, system);
}

}  // namespace robochart::runs
