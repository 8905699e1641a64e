// SPDX-License-Identifier: Apache-2.0
// Writes the files of a simulation: a table of positions for each trial, and pictures of the first trial. Also makes
// PNG, GIF and MP4 files if the programs for these formats are in PATH.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

#include "app/command/rules.hpp"
#include "app/verbs/simulate.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/programs.hpp"
#include "simulation/report/pictures.hpp"
#include "simulation/report/plot.hpp"
#include "simulation/report/raster.hpp"

namespace robochart::app {
namespace fs = std::filesystem;
namespace {

/// Returns the factor by which an animation is faster than real time. With this factor, a trial takes about half a
/// minute.
double animation_speed(double duration) {
    return std::max(1.0, std::round(duration / 30));
}

bool on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::error_code ignored;
        const auto status = fs::status(fs::path(folder) / program, ignored);
        if (fs::is_regular_file(status) && (status.permissions() & fs::perms::others_exec) != fs::perms::none)
            return true;
    }
    return false;
}

class Files {
public:
    Files(Simulation& simulation, const simulation::RunResult& result, const simulation::Machines& machines,
          const Options& options)
        : scenario_(simulation.scenario),
          project_(*simulation.project),
          result_(result),
          out_(options.output.folder),
          below_("simulation/" + simulation.scenario.name.text + "/"),
          machines_(machines) {}

    std::vector<std::string> write(std::string& notes) {
        if (!write_tables()) return std::move(written_);
        const auto& frames = result_.trials.front().frames;
        if (frames.empty()) {
            notes += "  no tables and pictures: too many positions to keep (`record` less often)\n";
            return std::move(written_);
        }
        if (add("snapshots.svg", simulation::snapshots_svg(scenario_, frames, machines_)) &&
            add("trajectories.svg", simulation::trajectories_svg(scenario_, frames)) &&
            add("animation.svg",
                simulation::animation_svg(scenario_, frames, machines_, animation_speed(frames.back().time))) &&
            add("plots.svg",
                simulation::plots_svg(scenario_, simulation::charts_of(scenario_, result_.trials, machines_)))) {
            std::string error;
            work_ = std::make_unique<diagnostics::TemporaryFolder>("", error, project_.diagnostics.budget());
            if (!error.empty())
                notes += fmt::format("  no images: {}\n", error);
            else
                images_and_films(frames, notes);
        }
        return std::move(written_);
    }

private:
    bool add(const std::string& name, const std::string& text) {
        const std::string error = diagnostics::write_below(out_, below_ + name, text, project_.diagnostics.budget());
        if (!error.empty())
            project_.diagnostics.report(rules::unwritable, {}, {error});
        else
            written_.push_back(out_ + "/" + below_ + name);
        return error.empty();
    }

    bool write_tables() {
        for (std::size_t trial = 0; trial < result_.trials.size() && !result_.trials[trial].frames.empty(); ++trial)
            if (!add(fmt::format("trial-{:02}.csv", trial + 1),
                     simulation::positions_csv(result_.trials[trial].frames, machines_)))
                return false;
        return true;
    }

    /// Runs a program that creates a file with this name in the work folder, and moves the file to the output folder.
    bool make_file(const std::string& name, const std::vector<std::string>& command, std::string& notes) {
        std::string error;
        const std::string log = work_->path() + "/log";
        const int status = diagnostics::run_program(command, log, error, project_.diagnostics.budget());
        if (status == 0) return add(name, read_contents(work_->path() + "/" + name));
        if (error.empty()) error = fmt::format("status {}, {}", status, read_contents(log).substr(0, 500));
        notes += fmt::format("  {} did not make {}: {}\n", command.front(), name, error);
        return false;
    }

    static std::string read_contents(const std::string& path) {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    /// Converts the drawings to images and films. The drawings have already been written, so they exist even if a limit
    /// ends the conversions.
    void images_and_films(const std::vector<simulation::Frame>& frames, std::string& notes) try {
        make_images(notes);
        make_videos(frames, notes);
    } catch (const diagnostics::LimitReached& limit) {
        notes += fmt::format("  no more images: {}\n", limit.what());
    }

    void make_images(std::string& notes) {
        if (!on_path("rsvg-convert")) {
            notes += "  no PNG: rsvg-convert is not on PATH (Debian: librsvg2-bin)\n";
            return;
        }
        for (const std::string name : {"snapshots", "trajectories", "plots"}) {
            const std::string drawing = fmt::format("{}/{}{}.svg", out_, below_, name);
            const std::string made = fmt::format("{}/{}.png", work_->path(), name);
            make_file(name + ".png", {"rsvg-convert", "--background-color=white", drawing, "--output", made}, notes);
        }
    }

    /// Writes the frames as raw video to a file, which ffmpeg converts to MP4 and GIF.
    void make_videos(const std::vector<simulation::Frame>& frames, std::string& notes) {
        if (!on_path("ffmpeg")) {
            notes += "  no MP4 and GIF: ffmpeg is not on PATH (Debian: ffmpeg)\n";
            return;
        }
        std::string dots;
        simulation::Raster raster;
        constexpr std::size_t most = 600;
        const std::size_t every = (frames.size() + most - 1) / most;
        std::size_t count = 0;
        for (std::size_t f = 0; f < frames.size(); f += every, ++count) {
            raster = simulation::rasterise_frame(scenario_, frames[f], machines_.front().states.size(), 480);
            dots.append(raster.dots.begin(), raster.dots.end());
        }
        if (const std::string error = diagnostics::write_below(work_->path(), "frames.raw", dots); !error.empty()) {
            notes += fmt::format("  no MP4 and GIF: {}\n", error);
            return;
        }
        const double rate =
            static_cast<double>(count) * animation_speed(frames.back().time) / std::max(frames.back().time, 1.0);
        const auto film = [&](const std::string& name, const std::vector<std::string>& more) {
            std::vector<std::string> command = {"ffmpeg",
                                                "-y",
                                                "-loglevel",
                                                "error",
                                                "-f",
                                                "rawvideo",
                                                "-pixel_format",
                                                "rgb24",
                                                "-video_size",
                                                fmt::format("{}x{}", raster.width, raster.height),
                                                "-framerate",
                                                fmt::format("{:.3f}", rate),
                                                "-i",
                                                work_->path() + "/frames.raw"};
            command.insert(command.end(), more.begin(), more.end());
            command.push_back(work_->path() + "/" + name);
            return make_file(name, command, notes);
        };
        if (film("animation.mp4", {"-pix_fmt", "yuv420p"})) film("animation.gif", {"-vf", "scale=320:-1"});
    }

    const simulation::Scenario& scenario_;
    driver::Project& project_;
    const simulation::RunResult& result_;
    std::string out_, below_;
    std::unique_ptr<diagnostics::TemporaryFolder> work_;
    simulation::Machines machines_;
    std::vector<std::string> written_;
};

}  // namespace

std::vector<std::string> write_simulation_files(Simulation& simulation, const simulation::RunResult& result,
                                                const simulation::Machines& machines, const Options& options,
                                                std::string& notes) {
    return Files(simulation, result, machines, options).write(notes);
}

}  // namespace robochart::app
