// SPDX-License-Identifier: Apache-2.0
// Measures the time to draw diagrams. benchmark_diagrams MODEL... loads each file or folder separately and draws every
// component as SVG ten times; the minimum is the result. The targets are 95 % below 5 ms and all below 50 ms. If the
// first argument is --pictures, it prints the diagrams as JSON for compare_layouts.mjs, one per line: boxes and lines
// with their places.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "benchmarks/cpu_time.hpp"
#include "frontend/diagrams/notation/subjects.hpp"
#include "frontend/diagrams/svg/svg.hpp"
#include "frontend/project/project.hpp"

namespace {

using namespace robochart;

struct Measured {
    double milliseconds = 0;
    std::string name;
    std::size_t boxes = 0, lines = 0;
};

Measured measure(const diagrams::Subject& subject, const diagrams::Elements& elements) {
    Measured result{std::numeric_limits<double>::infinity(), subject.name, 0, 0};
    for (int round = 0; round < 10; ++round) {
        const double begin = thread_cpu_seconds();
        const diagrams::Picture picture = diagrams::draw_subject(subject, {elements, nullptr, nullptr});
        const std::string text = diagrams::render_svg(picture, elements);
        result.milliseconds = std::min(result.milliseconds, 1000 * (thread_cpu_seconds() - begin));
        result.boxes = picture.boxes.size();
        result.lines = picture.lines.size();
    }
    return result;
}

void draw_all(const std::string& path,
              const std::function<void(const diagrams::Subject&, const diagrams::Elements&)>& look) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto model = frontend::load_project(sources, path, findings);
    const diagrams::Elements elements(*model);
    for (const diagrams::Subject& subject : diagrams::find_subjects(*model, sources)) look(subject, elements);
}

/// Returns the number of a box; -1 if there is no box.
nlohmann::json box_number(std::size_t box) {
    return box == diagrams::none ? nlohmann::json(-1) : nlohmann::json(box);
}

nlohmann::json picture_json(const diagrams::Picture& picture) {
    nlohmann::json json{
        {"name", picture.title}, {"boxes", nlohmann::json::array()}, {"lines", nlohmann::json::array()}};
    for (const diagrams::PictureBox& box : picture.boxes)
        json["boxes"].push_back({{"width", box.place.width},
                                 {"height", box.place.height},
                                 {"parent", box_number(box.parent)},
                                 {"eventOf", box_number(box.event_of)}});
    for (const diagrams::PictureLine& line : picture.lines) {
        nlohmann::json points = nlohmann::json::array();
        for (const diagrams::layout::Point& point : line.points) points.push_back({{"x", point.x}, {"y", point.y}});
        json["lines"].push_back({{"from", line.from},
                                 {"to", line.to},
                                 {"points", std::move(points)},
                                 {"label", {{"width", line.label.width}, {"height", line.label.height}}}});
    }
    return json;
}

void print_pictures(const std::string& path) {
    draw_all(path, [&](const diagrams::Subject& subject, const diagrams::Elements& elements) {
        nlohmann::json json = picture_json(diagrams::draw_subject(subject, {elements, nullptr, nullptr}));
        json["file"] = path;
        fmt::print("{}\n", json.dump());
    });
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> models(argv + 1, argv + argc);
    if (!models.empty() && models.front() == "--pictures") {
        std::for_each(models.begin() + 1, models.end(), print_pictures);
        return 0;
    }
    std::vector<Measured> all;
    for (const std::string& model : models)
        draw_all(model, [&](const diagrams::Subject& subject, const diagrams::Elements& elements) {
            all.push_back(measure(subject, elements));
        });
    if (all.empty()) {
        fmt::print(stderr, "usage: benchmark_diagrams [--pictures] MODEL...\n");
        return 4;
    }
    std::ranges::sort(all, [](const Measured& a, const Measured& b) { return a.milliseconds < b.milliseconds; });
    double sum = 0;
    for (const Measured& measured : all) sum += measured.milliseconds;
    fmt::print("{} diagrams, {:.1f} ms in all; median {:.2f} ms, 95 % below {:.2f} ms\n", all.size(), sum,
               all[all.size() / 2].milliseconds, all[all.size() * 95 / 100].milliseconds);
    for (std::size_t i = all.size() - std::min<std::size_t>(all.size(), 5); i < all.size(); ++i)
        fmt::print("  {:8.2f} ms  {} ({} boxes, {} lines)\n", all[i].milliseconds, all[i].name, all[i].boxes,
                   all[i].lines);
}
