// What a simulation leaves behind: a table of positions for each trial, pictures of the first; PNG, GIF and MP4 where the
// programs that make them are on PATH.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "app/rules.hpp"
#include "app/simulate.hpp"
#include "cpp_emit/shared_library.hpp"
#include "simulation/pictures.hpp"

namespace robochart::app {
namespace fs = std::filesystem;
namespace {

/// How much faster than the world an animation runs: about half a minute for a trial.
double animation_speed(double duration) { return std::max(1.0, std::round(duration / 30)); }

bool on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::error_code ignored;
        const auto status = fs::status(fs::path(folder) / program, ignored);
        if (fs::is_regular_file(status) && (status.permissions() & fs::perms::others_exec) != fs::perms::none) return true;
    }
    return false;
}

class Files {
public:
    Files(Simulation& simulation, const simulation::RunResult& result, const rc_drive& drive, const Options& options)
        : scenario_(simulation.scenario), project_(*simulation.project), result_(result),
          folder_(options.out + "/simulation/" + simulation.scenario.name.text) {
        for (std::uint32_t s = 0; s < drive.states; ++s) states_.emplace_back(drive.state[s]);
    }

    std::vector<std::string> write(std::string& notes) {
        if (!tables()) return std::move(written_);
        const auto& frames = result_.trials.front().frames;
        if (frames.empty()) {
            notes += "  no tables and pictures: too many positions to keep (`record` less often)\n";
            return std::move(written_);
        }
        if (add("snapshots.svg", simulation::snapshots_svg(scenario_, frames)) &&
            add("trajectories.svg", simulation::trajectories_svg(scenario_, frames)) &&
            add("animation.svg", simulation::animation_svg(scenario_, frames, states_, animation_speed(frames.back().time)))) {
            images(notes);
            video(frames, notes);
        }
        return std::move(written_);
    }

private:
    bool add(const std::string& name, const std::string& text) {
        const std::string path = folder_ + "/" + name;
        const std::string error = write_file(path, text);
        if (!error.empty()) project_.diagnostics.report(rules::unwritable, {}, {error});
        else written_.push_back(path);
        return error.empty();
    }

    bool tables() {
        for (std::size_t trial = 0; trial < result_.trials.size() && !result_.trials[trial].frames.empty(); ++trial)
            if (!add(fmt::format("trial-{:02}.csv", trial + 1), simulation::positions_csv(result_.trials[trial].frames, states_))) return false;
        return true;
    }

    bool run(std::vector<std::string> command, const std::string& made, std::string& notes) {
        std::string error;
        const std::string log = folder_ + "/" + command.front() + ".log";
        const int status = cpp_emit::run_program(command, log, error);
        std::error_code ignored;
        if (status == 0) {
            fs::remove(log, ignored);
            written_.push_back(made);
            return true;
        }
        notes += fmt::format("  {} did not make {}: {}\n", command.front(), made, error.empty() ? "see " + log : error);
        return false;
    }

    void images(std::string& notes) {
        if (!on_path("rsvg-convert")) {
            notes += "  no PNG: rsvg-convert is not on PATH (Debian: librsvg2-bin)\n";
            return;
        }
        for (const char* name : {"snapshots", "trajectories"}) {
            const std::string made = fmt::format("{}/{}.png", folder_, name);
            run({"rsvg-convert", "--background-color=white", fmt::format("{}/{}.svg", folder_, name), "--output", made}, made, notes);
        }
    }

    /// Frames as raw video in a file, which ffmpeg turns into MP4 and GIF.
    void video(const std::vector<simulation::Frame>& frames, std::string& notes) {
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
            raster = simulation::rasterise(scenario_, frames[f], 480);
            dots.append(raster.dots.begin(), raster.dots.end());
        }
        const std::string raw = folder_ + "/frames.raw";
        const std::string error = write_file(raw, dots);
        if (!error.empty()) {
            notes += fmt::format("  no MP4 and GIF: {}\n", error);
            return;
        }
        const double rate = static_cast<double>(count) * animation_speed(frames.back().time) / std::max(frames.back().time, 1.0);
        const std::vector<std::string> input = {"ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pixel_format", "rgb24",
                                                "-video_size", fmt::format("{}x{}", raster.width, raster.height),
                                                "-framerate", fmt::format("{:.3f}", rate), "-i", raw};
        const auto make = [&](const std::string& name, const std::vector<std::string>& more) {
            std::vector<std::string> command = input;
            command.insert(command.end(), more.begin(), more.end());
            command.push_back(folder_ + "/" + name);
            return run(command, folder_ + "/" + name, notes);
        };
        if (make("animation.mp4", {"-pix_fmt", "yuv420p"})) make("animation.gif", {"-vf", "scale=320:-1"});
        std::error_code ignored;
        fs::remove(raw, ignored);
    }

    const simulation::Scenario& scenario_;
    Project& project_;
    const simulation::RunResult& result_;
    std::string folder_;
    std::vector<std::string> states_;
    std::vector<std::string> written_;
};

}  // namespace

std::vector<std::string> write_simulation_files(Simulation& simulation, const simulation::RunResult& result, const rc_drive& drive,
                                                const Options& options, std::string& notes) {
    return Files(simulation, result, drive, options).write(notes);
}

}  // namespace robochart::app
