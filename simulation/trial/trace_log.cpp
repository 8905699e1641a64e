// SPDX-License-Identifier: Apache-2.0
// Writes one buffered log for each robot. Only the first failure is reported.
#include "simulation/trial/trace_log.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "base/diagnostics/escape.hpp"
#include "cpp_emit/files/trace_names.hpp"

namespace robochart::simulation {

namespace {

/// The maximal amount of text that is buffered for one robot.
constexpr std::size_t most_kept = 1U << 16U;

std::vector<std::string> exported_names(const std::vector<cpp_emit::Port>& ports) {
    std::vector<std::string> exported;
    for (const cpp_emit::Port& port : ports) exported.push_back(port.exported);
    return cpp_emit::trace_names(exported);
}

}  // namespace

TraceLog::TraceLog(TraceLogOptions options, const Scenario& scenario, const cpp_emit::DriveEmission& emission,
                   std::uint32_t trial)
    : options_(std::move(options)),
      scenario_(scenario),
      emission_(emission),
      trial_(trial),
      inputs_(exported_names(emission.inputs)),
      outputs_(exported_names(emission.outputs)) {}

TraceLog::~TraceLog() {
    for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
        flush(robot);
        finish_file(robot);
    }
    if (!error_.empty() && options_.failed) options_.failed(error_);
}

std::string TraceLog::log_path(std::size_t robot) const {
    return fmt::format("trial-{:02}/robot-{:02}.{}", trial_ + 1, options_.first + robot,
                       options_.format == LogFormat::mcap ? "mcap" : "trace");
}

void TraceLog::begin(std::size_t robot) {
    std::string& text = robots_[robot].text;
    text = fmt::format("robochart-trace {}\n", cpp_emit::trace_version);
    if (!options_.run.empty()) text += fmt::format("// run: {}\n", options_.run);
    if (!options_.model.empty()) text += fmt::format("model {}\n", diagnostics::escape_for_display(options_.model));
    for (const std::string& constant : options_.constants)
        text += fmt::format("const {}\n", diagnostics::escape_for_display(constant));
    text += fmt::format("component {}\ncycle {}\nunit {} s\nrobot {}\nscenario {} seed {} trial {}\n",
                        options_.component, scenario_.units_per_step, scenario_.time_unit, options_.first + robot,
                        diagnostics::escape_for_display(options_.scenario), scenario_.seed, trial_ + 1);
    text += fmt::format("run trial {} robot {}\n", trial_ + 1, options_.first + robot);
}

void TraceLog::add_value(std::string& text, const cpp_emit::Port& port, std::size_t argument, rc_value value) const {
    auto out = std::back_inserter(text);
    switch (port.arguments[argument]) {
        case cpp_emit::Carried::real:
            fmt::format_to(out, "{}", value.real);
            return;
        case cpp_emit::Carried::boolean:
            text += value.whole != 0 ? "true" : "false";
            return;
        case cpp_emit::Carried::whole:
            fmt::format_to(out, "{}", value.whole);
            return;
        case cpp_emit::Carried::enumeration:
            break;
    }
    const auto& literals = port.literals[argument];
    const bool named = value.whole >= 0 && static_cast<std::size_t>(value.whole) < literals.size();
    text += named ? literals[static_cast<std::size_t>(value.whole)] : fmt::format("{}", value.whole);
}

void TraceLog::add_inputs(std::string& text, const rc_signal* inputs) const {
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
        if (inputs[i].present == 0) continue;
        text += inputs_[i] + '?';
        if (!emission_.inputs[i].arguments.empty()) add_value(text, emission_.inputs[i], 0, inputs[i].value);
        text += ' ';
    }
}

void TraceLog::add_action(std::string& text, const rc_action& action) const {
    const cpp_emit::Port& port = emission_.outputs[action.output];
    text += outputs_[action.output];
    if (port.arguments.empty()) text += '!';
    for (std::size_t k = 0; k < port.arguments.size(); ++k) {
        text += '!';
        add_value(text, port, k, action.argument[k]);
    }
    text += ' ';
}

void TraceLog::observe_cycle(std::size_t robot, std::uint64_t /*step*/, const rc_signal* inputs,
                             const rc_actions& outputs, rc_drive_result result) {
    while (robots_.size() <= robot) {
        robots_.emplace_back();
        begin(robots_.size() - 1);
    }
    if (robots_[robot].ended) return;
    std::string& text = robots_[robot].text;
    add_inputs(text, inputs);
    for (std::uint32_t a = 0; a < outputs.count; ++a) add_action(text, outputs.action[a]);
    robots_[robot].ended = result != RC_DRIVE_QUIESCENT;
    if (result == RC_DRIVE_TERMINATED)
        text += "terminate";
    else if (result == RC_DRIVE_QUIESCENT)
        for (std::uint32_t t = 0; t < scenario_.units_per_step; ++t) text += t == 0 ? "tock" : " tock";
    else
        text += "// the controller stopped here";
    text += '\n';
    ++robots_[robot].cycles;
    if (text.size() > most_kept) flush(robot);
}

void TraceLog::flush(std::size_t robot) {
    Robot& log = robots_[robot];
    if (log.text.empty() || !error_.empty()) return;
    if (log.file == nullptr) open_file(robot);
    if (error_.empty()) error_ = log.file->append(log.mcap ? log.mcap->chunk(log.text, nanoseconds(log)) : log.text);
    log.text.clear();
}

void TraceLog::open_file(std::size_t robot) {
    Robot& log = robots_[robot];
    log.file = std::make_unique<diagnostics::GrowingFile>(options_.folder, log_path(robot), options_.budget);
    if (options_.format == LogFormat::text) return;
    log.mcap = std::make_unique<robochart::McapWriter>("/trace");
    error_ = log.file->append(log.mcap->begin());
}

void TraceLog::finish_file(std::size_t robot) {
    Robot& log = robots_[robot];
    if (!error_.empty() || log.file == nullptr) return;
    if (log.mcap) error_ = log.file->append(log.mcap->end());
    if (error_.empty()) error_ = log.file->finish();
}

/// The time of the trial at the end of the robot's last cycle.
std::uint64_t TraceLog::nanoseconds(const Robot& log) const {
    const double seconds = static_cast<double>(log.cycles * scenario_.units_per_step) * scenario_.time_unit;
    return static_cast<std::uint64_t>(std::llround(seconds * 1e9));
}

}  // namespace robochart::simulation
