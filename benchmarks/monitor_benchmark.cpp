// SPDX-License-Identifier: Apache-2.0
// Measures the cost that a monitor for every controller adds to a step: benchmark_monitor ROUNDS SCENARIO... The same
// trial runs twice in one thread, with and without monitors, in alternating blocks of steps, measured by the thread's
// CPU clock. The tables are built once beforehand. The median is that of the ratios of all pairs of blocks. The minimum
// is the sum over all blocks of the minimum of all rounds.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <numeric>
#include <vector>

#include "app/command/findings.hpp"
#include "app/command/run.hpp"
#include "app/verbs/monitor.hpp"
#include "benchmarks/cpu_time.hpp"
#include "benchmarks/scaled.hpp"

namespace {

using namespace robochart;

struct Study {
    std::unique_ptr<app::Simulation> loaded;
    std::unique_ptr<simulation::Controller> controller;
    std::unique_ptr<simulation::Guard> guard;
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// One trial, with or without monitors, in blocks of steps.
class Side {
public:
    Side(const Study& study, const simulation::Scenario& scenario, bool watched)
        : plan_(simulation::bind_scenario(scenario, study.loaded->emission, diagnostics_)),
          stage_(simulation::embedded_stage(scenario, 0, diagnostics_)),
          trace_(watched ? study.guard->make_observer({})(0) : nullptr) {
        if (stage_ == nullptr) return;
        options_.record = false;
        options_.trace = trace_.get();
        trial_ = std::make_unique<simulation::Trial>(plan_, study.controller->drive(), *stage_, options_);
    }

    [[nodiscard]] bool ready() const { return trial_ != nullptr; }
    /// Returns CPU seconds.
    double run(std::uint64_t steps) {
        const double begin = thread_cpu_seconds();
        trial_->run(steps);
        return thread_cpu_seconds() - begin;
    }
    [[nodiscard]] bool complete() { return std::move(*trial_).result().complete; }

private:
    diagnostics::Diagnostics diagnostics_;
    simulation::Plan plan_;
    std::unique_ptr<simulation::Stage> stage_;
    std::unique_ptr<simulation::Trace> trace_;
    simulation::TrialOptions options_;
    std::unique_ptr<simulation::Trial> trial_;
};

/// Seconds of each block of steps, the minimum of all rounds, and the ratios of all pairs of blocks.
struct Measured {
    std::vector<double> plain, watched, ratios;
};

bool run_round(const Study& study, const simulation::Scenario& scenario, std::uint64_t block, bool first,
               Measured& measured) {
    Side plain(study, scenario, false);
    Side watched(study, scenario, true);
    if (!plain.ready() || !watched.ready()) return false;
    const std::size_t blocks = (scenario.step_count() + block - 1) / block;
    measured.plain.resize(blocks, 1e300);
    measured.watched.resize(blocks, 1e300);
    for (std::size_t b = 0; b < blocks; ++b) {
        // Both sides do the same work. Their order alternates from block to block and from round to round.
        const bool order = first == (b % 2 == 0);
        const double once = (order ? plain : watched).run(block);
        const double again = (order ? watched : plain).run(block);
        const double without = order ? once : again;
        const double with = order ? again : once;
        measured.plain[b] = std::min(measured.plain[b], without);
        measured.watched[b] = std::min(measured.watched[b], with);
        measured.ratios.push_back(with / without);
    }
    return plain.complete() && watched.complete();
}

bool compare(const Study& study, std::uint32_t robots, int rounds) {
    const simulation::Scenario& own = study.loaded->scenario;
    const auto scenario = scaled(own, robots, own.duration * own.robots / robots);
    const std::uint64_t block = 2000 / robots;  // a millisecond or two
    Measured measured;
    for (int round = 0; round < rounds; ++round)
        if (!run_round(study, scenario, block, round % 2 == 0, measured)) return false;
    const double steps = static_cast<double>(scenario.step_count()) * robots;
    const double plain = std::accumulate(measured.plain.begin(), measured.plain.end(), 0.0);
    const double watched = std::accumulate(measured.watched.begin(), measured.watched.end(), 0.0);
    fmt::print(
        "{}, {} robots: monitor: {:.1f} % (median of {}), {:.1f} % (minimum: {:.0f} on {:.0f} ns a robot-step)\n",
        own.name.text, robots, (median(measured.ratios) - 1) * 100, measured.ratios.size(), (watched / plain - 1) * 100,
        (watched - plain) / steps * 1e9, plain / steps * 1e9);
    return true;
}

bool load(const char* path, Study& study) {
    app::Options options;
    app::set_verb(options, app::Verb::simulate);
    options.load.inputs = {path};
    options.output.quiet = true;
    options.simulate.monitor = true;
    app::Run run(options);
    options.run = &run;
    study.loaded = app::load_simulation(options);
    std::string error;
    if (study.loaded->project->diagnostics.ok())
        study.controller = simulation::Controller::build(study.loaded->emission, "", error);
    const double begin = thread_cpu_seconds();
    if (study.controller != nullptr) study.guard = app::make_guard(*study.loaded, options);
    if (study.guard == nullptr) {
        app::show_diagnostics(*study.loaded->project, options);
        fmt::print(stderr, "{}: {}\n", path, error);
        return false;
    }
    fmt::print("{}: tables made once in {:.0f} ms\n", study.loaded->scenario.name.text,
               (thread_cpu_seconds() - begin) * 1e3);
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    int rounds = 0;
    if (argc > 2) std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), rounds);
    if (rounds < 1) {
        fmt::print(stderr, "usage: benchmark_monitor ROUNDS SCENARIO...\n");
        return 4;
    }
    for (int i = 2; i < argc; ++i) {
        Study study;
        if (!load(argv[i], study)) return 2;
        if (!compare(study, 20, rounds) || !compare(study, 100, rounds)) return 2;
    }
    return 0;
}
