// SVG of trials; see pictures.hpp. A picture's unit is a centimetre of the world, its y axis points down.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "simulation/report/pictures.hpp"

namespace robochart::simulation {

namespace {

/// Colours of the controller's states, distinguishable with colour blindness too (Okabe, Ito).
constexpr std::array<const char*, 8> palette = {"#009e73", "#0072b2", "#d55e00", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#f0e442", "#999999"};

const char* colour(std::size_t state) {
    return palette.at(state % palette.size());
}

/// What is seen: the arena, or all the robots' paths where it has no walls.
struct View {
    double left, top, width, height;
};

View view_of(const Scenario& scenario, const std::vector<Frame>& frames) {
    const Arena& arena = scenario.world.arena;
    View view{-arena.width / 2, -arena.height / 2, arena.width, arena.height};
    if (arena.walled) return view;
    double across = arena.width / 2;
    double along = arena.height / 2;
    for (const Frame& frame : frames)
        for (const Pose& pose : frame.poses) {
            across = std::max(across, std::abs(pose.at.x) + 5);
            along = std::max(along, std::abs(pose.at.y) + 5);
        }
    return {-across, -along, 2 * across, 2 * along};
}

std::string head(const Scenario& scenario, const View& view, double margin, double scale) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:g} {:g} {:g} {:g}\" width=\"{:g}\" height=\"{:g}\" "
        "font-family=\"sans-serif\">\n<title>{}</title>\n",
        view.left - margin, view.top - margin, view.width + 2 * margin, view.height + 2 * margin,
        (view.width + 2 * margin) * scale, (view.height + 2 * margin) * scale,
        diagnostics::xml_text(scenario.name.text));
}

std::string arena(const Scenario& scenario, const View& view) {
    std::string out = fmt::format(
        "<rect x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" fill=\"#ffffff\" stroke=\"#444444\"{}/>\n",
        view.left, view.top, view.width, view.height, scenario.world.arena.walled ? "" : " stroke-dasharray=\"4\"");
    for (const Segment& wall : scenario.world.arena.walls)
        out += fmt::format(
            "<line x1=\"{:g}\" y1=\"{:g}\" x2=\"{:g}\" y2=\"{:g}\" stroke=\"#444444\" stroke-width=\"2\"/>\n",
            wall.from.x, -wall.from.y, wall.to.x, -wall.to.y);
    for (const Light& light : scenario.lights)
        out += fmt::format("<circle cx=\"{:g}\" cy=\"{:g}\" r=\"6\" fill=\"#f5c400\" stroke=\"#8a6d00\"/>\n",
                           light.at.x, -light.at.y);
    return out;
}

std::string robot(const Scenario& scenario, const Pose& pose, std::size_t state) {
    const double radius = scenario.world.body.radius;
    return fmt::format(
        "<g transform=\"translate({:.1f} {:.1f}) rotate({:.0f})\"><circle r=\"{:g}\" fill=\"{}\"/>"
        "<line x2=\"{:g}\" stroke=\"#ffffff\"/></g>\n",
        pose.at.x, -pose.at.y, -pose.heading * 180 / std::numbers::pi, radius, colour(state), radius);
}

std::string join(const std::vector<std::string>& values, const char* separator) {
    std::string out;
    for (const std::string& value : values) out += (out.empty() ? "" : separator) + value;
    return out;
}

/// Attributes change only now and then; equal neighbours are left out of key frames of colours.
std::string colour_changes(const std::vector<const Frame*>& frames, std::size_t robot, double seconds, double end) {
    std::vector<std::string> values, times;
    std::size_t last = ~std::size_t{0};
    for (const Frame* frame : frames) {
        const std::size_t state = frame->states[robot];
        if (state == last) continue;
        values.emplace_back(colour(state));
        times.push_back(fmt::format("{:.4f}", frame->time / end));
        last = state;
    }
    if (values.size() < 2) return "";
    return fmt::format(
        "<animate attributeName=\"fill\" calcMode=\"discrete\" dur=\"{:g}s\" repeatCount=\"indefinite\" "
        "keyTimes=\"{}\" values=\"{}\"/>",
        seconds, join(times, ";"), join(values, ";"));
}

}  // namespace

const Frame& frame_at(const std::vector<Frame>& frames, double time) {
    return *std::min_element(frames.begin(), frames.end(), [&](const Frame& a, const Frame& b) {
        return std::abs(a.time - time) < std::abs(b.time - time);
    });
}

std::string snapshots_svg(const Scenario& scenario, const std::vector<Frame>& frames) {
    std::vector<double> times = scenario.pictures;
    if (times.empty()) times = {0, scenario.duration};
    std::vector<Frame> shown;
    for (const double time : times) shown.push_back(frame_at(frames, time));
    const View view = view_of(scenario, shown);
    const double gap = view.width / 20;
    const double caption = view.height / 8;
    const auto count = static_cast<double>(shown.size());
    const View all{0, 0, count * view.width + (count - 1) * gap, view.height + caption};
    std::string out = head(scenario, all, gap, 250 / view.width);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        out += fmt::format("<g transform=\"translate({:g} {:g})\">\n",
                           static_cast<double>(i) * (view.width + gap) - view.left, -view.top);
        out += arena(scenario, view);
        for (std::size_t r = 0; r < shown[i].poses.size(); ++r)
            out += robot(scenario, shown[i].poses[r], shown[i].states[r]);
        out += fmt::format(
            "<text x=\"{:g}\" y=\"{:g}\" font-size=\"{:g}\" text-anchor=\"middle\">{:g} s</text>\n</g>\n",
            view.left + view.width / 2, view.top + view.height + 0.75 * caption, 0.6 * caption, shown[i].time);
    }
    return out + "</svg>\n";
}

std::string trajectories_svg(const Scenario& scenario, const std::vector<Frame>& frames) {
    const View view = view_of(scenario, frames);
    std::string out = head(scenario, view, view.width / 40, 600 / view.width) + arena(scenario, view);
    constexpr std::size_t pieces = 8;
    for (std::size_t r = 0; r < frames.front().poses.size(); ++r)
        for (std::size_t piece = 0; piece < pieces; ++piece) {
            const std::size_t begin = frames.size() * piece / pieces;
            const std::size_t end = std::min(frames.size() * (piece + 1) / pieces, frames.size() - 1);
            std::string points;
            for (std::size_t f = begin; f <= end; ++f)
                points += fmt::format("{:.1f},{:.1f} ", frames[f].poses[r].at.x, -frames[f].poses[r].at.y);
            out += fmt::format(
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.8\" opacity=\"{:.2f}\"/>\n",
                points, colour(r), 0.15 + 0.5 * static_cast<double>(piece) / pieces);
        }
    for (std::size_t r = 0; r < frames.back().poses.size(); ++r)
        out += robot(scenario, frames.back().poses[r], frames.back().states[r]);
    return out + "</svg>\n";
}

std::string animation_svg(const Scenario& scenario, const std::vector<Frame>& frames,
                          const std::vector<std::string>& states, double speed) {
    // About 240 key frames; a browser draws what lies in between.
    std::vector<const Frame*> keys;
    const std::size_t every = std::max<std::size_t>(1, frames.size() / 240);
    for (std::size_t f = 0; f < frames.size(); f += every) keys.push_back(&frames[f]);
    if (keys.back() != &frames.back()) keys.push_back(&frames.back());
    const double end = std::max(frames.back().time, 1e-9);
    const double seconds = end / speed;
    std::vector<std::string> times;
    for (const Frame* key : keys) times.push_back(fmt::format("{:.4f}", key->time / end));
    const View view = view_of(scenario, frames);
    std::string out = head(scenario, view, view.width / 20, 600 / view.width) + arena(scenario, view);
    for (std::size_t r = 0; r < frames.front().poses.size(); ++r) {
        std::vector<std::string> places;
        for (const Frame* key : keys)
            places.push_back(fmt::format("{:.1f} {:.1f}", key->poses[r].at.x, -key->poses[r].at.y));
        out += fmt::format(
            "<circle r=\"{:g}\" fill=\"{}\"><animateTransform attributeName=\"transform\" type=\"translate\" "
            "dur=\"{:g}s\" repeatCount=\"indefinite\" keyTimes=\"{}\" values=\"{}\"/>{}</circle>\n",
            scenario.world.body.radius, colour(frames.front().states[r]), seconds, join(times, ";"), join(places, ";"),
            colour_changes(keys, r, seconds, end));
    }
    const double line = view.height / 30;
    for (std::size_t s = 0; s < states.size(); ++s)
        out += fmt::format(
            "<circle cx=\"{0:g}\" cy=\"{1:g}\" r=\"{2:g}\" fill=\"{3}\"/><text x=\"{4:g}\" y=\"{5:g}\" "
            "font-size=\"{6:g}\">{7}</text>\n",
            view.left + line + static_cast<double>(s) * view.width / 4, view.top - 0.6 * line, 0.3 * line, colour(s),
            view.left + 1.6 * line + static_cast<double>(s) * view.width / 4, view.top - 0.3 * line, 0.9 * line,
            states[s]);
    return out + "</svg>\n";
}

std::string positions_csv(const std::vector<Frame>& frames, const std::vector<std::string>& states) {
    std::string out = "t,id,x,y,theta,state\n";
    for (const Frame& frame : frames)
        for (std::size_t r = 0; r < frame.poses.size(); ++r) {
            const Pose& pose = frame.poses[r];
            const std::size_t state = frame.states[r];
            out += fmt::format("{:.3f},{},{:.4f},{:.4f},{:.5f},{}\n", frame.time, r, pose.at.x, pose.at.y, pose.heading,
                               state < states.size() ? states[state] : "");
        }
    return out;
}

Raster rasterise(const Scenario& scenario, const Frame& frame, std::size_t width) {
    const View view = view_of(scenario, {frame});
    const double scale = static_cast<double>(width) / view.width;
    // Video codecs want even sizes.
    const auto height = std::max<std::size_t>(2, static_cast<std::size_t>(view.height * scale) / 2 * 2);
    Raster raster{width, height, std::vector<unsigned char>(3 * width * height, 255)};
    const auto disk = [&](Vector at, double radius, const char* hex) {
        const auto rgb = static_cast<std::uint32_t>(std::strtoul(hex + 1, nullptr, 16));
        const double x = (at.x - view.left) * scale;
        const double y = (-at.y - view.top) * scale;
        const double r = radius * scale;
        const auto row = [](double v, std::size_t most) {
            return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(most)));
        };
        for (std::size_t j = row(y - r, height); j < row(y + r + 1, height); ++j)
            for (std::size_t i = row(x - r, width); i < row(x + r + 1, width); ++i) {
                const double dx = static_cast<double>(i) + 0.5 - x;
                const double dy = static_cast<double>(j) + 0.5 - y;
                if (dx * dx + dy * dy > r * r) continue;
                for (std::size_t k = 0; k < 3; ++k)
                    raster.dots[3 * (j * width + i) + k] = static_cast<unsigned char>(rgb >> (16 - 8 * k) & 255U);
            }
    };
    for (const Light& light : scenario.lights) disk(light.at, 6, "#f5c400");
    for (std::size_t r = 0; r < frame.poses.size(); ++r)
        disk(frame.poses[r].at, scenario.world.body.radius, colour(frame.states[r]));
    return raster;
}

}  // namespace robochart::simulation
