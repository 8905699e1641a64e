// SPDX-License-Identifier: Apache-2.0
// Writes logs of a trial in the format of docs/traces.md, one file per robot, for `conform --traces`. A log contains
// the inputs and outputs of the robot's controller in every cycle.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/files.hpp"
#include "cpp_emit/runtime/mcap_writer.hpp"
#include "cpp_emit/simulator_api.hpp"
#include "simulation/trial/log_format.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

struct TraceLogOptions {
    std::string folder;  ///< FOLDER/trial-01/robot-00.trace, or robot-00.mcap
    LogFormat format = LogFormat::text;
    std::string component;  ///< the name in the log's header
    std::string model;
    std::vector<std::string> constants;  ///< NAME=VALUE for the constants of the model in this run
    std::string scenario;
    std::string run;        ///< the record of the run on one line, as a comment for readers; "" if none
    std::size_t first = 0;  ///< index of the first robot; robots before it are of another kind
    diagnostics::Budget* budget = nullptr;
    std::function<void(const std::string&)>
        failed;  ///< called once, by the trial's thread, with the reason if a log could not be written
};

class TraceLog final : public Trace {
public:
    /// Stores references to the emission and the scenario.
    TraceLog(TraceLogOptions, const Scenario&, const cpp_emit::DriveEmission&, std::uint32_t trial);
    ~TraceLog() override;
    void observe_cycle(std::size_t robot, std::uint64_t step, const rc_signal* inputs, const rc_actions& outputs,
                       rc_drive_result result) override;

private:
    struct Robot {
        std::string text;
        bool ended = false;
        std::unique_ptr<diagnostics::GrowingFile> file;
        std::unique_ptr<robochart::McapWriter> mcap;  ///< null for a text
        std::uint64_t cycles = 0;
    };
    void begin(std::size_t robot);
    void add_value(std::string& text, const cpp_emit::Port& port, std::size_t argument, rc_value value) const;
    void add_inputs(std::string& text, const rc_signal* inputs) const;
    void add_action(std::string& text, const rc_action& action) const;
    void flush(std::size_t robot);
    void open_file(std::size_t robot);
    void finish_file(std::size_t robot);
    [[nodiscard]] std::uint64_t nanoseconds(const Robot&) const;
    [[nodiscard]] std::string log_path(std::size_t robot) const;

    TraceLogOptions options_;
    const Scenario& scenario_;
    const cpp_emit::DriveEmission& emission_;
    std::uint32_t trial_;
    std::vector<std::string> inputs_, outputs_;
    std::vector<Robot> robots_;
    std::string error_;
};

}  // namespace robochart::simulation
