// Ways of `step` in files: logs that `conform --traces` reads (docs/traces.md), and assertions that a way stays
// possible.
#pragma once

#include <string>

#include "app/command/pipeline.hpp"
#include "app/command/run.hpp"
#include "runs/stepper.hpp"

namespace robochart::app {

/// What is animated.
struct Stepped {
    std::string name;                  ///< of the component, "P::M"; of a script, the process as it was given
    std::string model;                 ///< the file or folder
    const Project* project = nullptr;  ///< null: a process of a script
    csp_emit::Time time = csp_emit::Time::timed;
};

/// Writes the way: to NAME.trace as a log, to NAME.assertions as an assertion. Returns why it cannot, "" if it could.
[[nodiscard]] std::string save_way(const runs::Stepper&, const Stepped&, const std::string& path, Run&);

/// How far a log could be followed.
struct Followed {
    std::string error;  ///< "" : to its end
};
/// Goes the way of the first run of a log, from the beginning, as far as the model can: in each cycle its outputs in
/// their order, its inputs where they are taken, and its time units, with hidden steps in between. Which inputs are
/// taken when is searched for, breadth first.
[[nodiscard]] Followed follow_log(runs::Stepper&, const Stepped&, const std::string& path, Run&);

}  // namespace robochart::app
