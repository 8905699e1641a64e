// Ways of `step` in files: logs that `conform --traces` reads (docs/traces.md), and assertions that a way stays
// possible.
#pragma once

#include <optional>
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
    bool any_constants = false;  ///< are logs of the model with other constants followed too?
};

/// What an event is in a log.
enum class LogRole { none, input, output, tock, termination };
[[nodiscard]] LogRole log_role(const runs::Event&);
/// An input or output as a log has it: "e?3", "move!1!2". `name`: as in runs::Offer. None for values with parts, which
/// logs written by hand do not have.
[[nodiscard]] std::optional<std::string> log_word(const runs::Event&, std::string name, const Stepped&);
/// The first lines of a log.
[[nodiscard]] std::string log_head(const Stepped&);

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
