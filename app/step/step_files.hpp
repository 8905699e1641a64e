// SPDX-License-Identifier: Apache-2.0
// Saves the steps of `step` in files: as logs for `conform --traces` (docs/traces.md), and as assertions that the model
// has these steps.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/command/run.hpp"
#include "counterexample/stepper.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::app {

/// The component or process that is stepped through.
struct Stepped {
    std::string name;                          ///< the component, "P::M"; for a script, the process as given
    std::string model;                         ///< the file or folder
    const driver::Project* project = nullptr;  ///< null for a process of a script
    csp_emit::Time time = csp_emit::Time::timed;
    std::optional<std::uint32_t> cycle = {};  ///< RoboSim: the time units of a cycle
    bool any_constants = false;               ///< true if logs made with other constants are also followed
};

/// The role of an event in a log.
enum class LogRole { none, input, output, tock, termination };
[[nodiscard]] LogRole log_role(const runs::Event&);
/// Returns an input or output in the notation of logs: "e?3", "move!1!2". `name` is the name in runs::Offer. Returns no
/// value if the event has a composed value, which logs cannot contain.
[[nodiscard]] std::optional<std::string> log_word(const runs::Event&, std::string name, const Stepped&);
/// RoboSim: the result of reading a register.
struct ReadRegister {
    std::string name;    ///< name of the event or variable
    std::string value;   ///< the value in a full register; "" if the register is empty or has no value
    bool event = false;  ///< true for the register of an event, false for that of a variable
};
/// Returns the read of a register that the offer performs; no value if it is not a read.
[[nodiscard]] std::optional<ReadRegister> read_register(const runs::Offer&);
/// RoboSim: the values of the variables whose registers a component reads, before a cycle. A variable has the value
/// that was last read or written; before the first cycle, it has the default of its type.
class KeptValues {
public:
    /// The values after these steps.
    KeptValues(const std::vector<runs::Taken>&, const Stepped&);
    /// Whether the read of a variable finds this value.
    [[nodiscard]] bool is_kept(const runs::Offer& read) const;

private:
    [[nodiscard]] bool is_default(const runs::Offer& read) const;

    const Stepped& stepped_;
    std::map<std::string, std::string> values_;  ///< by the name of the variable
};
/// Returns the first lines of a log.
[[nodiscard]] std::string log_head(const Stepped&);

/// Writes the steps so far. A path NAME.trace receives a log, NAME.assertions an assertion. Returns the reason on
/// failure, "" on success.
[[nodiscard]] std::string save_way(const runs::Stepper&, const Stepped&, const std::string& path, Run&);

/// The length of the part of a log that the model could follow, and the reason for its end.
struct Followed {
    std::string error;  ///< "" if the log was followed to its end
};
/// Follows the first run of a log from the beginning as far as the model allows. The steps of a cycle are its outputs
/// in order, its inputs, its time units, and hidden steps in between. A breadth-first search finds the steps at which
/// the inputs are taken.
[[nodiscard]] Followed follow_log(runs::Stepper&, const Stepped&, const std::string& path, Run&);

}  // namespace robochart::app
