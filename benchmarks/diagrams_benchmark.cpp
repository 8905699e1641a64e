// How long diagrams take: benchmark_diagrams MODEL... reads each file or folder alone and draws every component of it
// as SVG, ten times; the least of each counts. The bars: 95 % below 5 ms, all below 50 ms.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "benchmarks/cpu_time.hpp"
#include "diagrams/notation/subjects.hpp"
#include "diagrams/svg/svg.hpp"
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
        const diagrams::Picture picture = diagrams::draw(subject, {elements, nullptr, nullptr});
        const std::string text = diagrams::svg(picture, elements);
        result.milliseconds = std::min(result.milliseconds, 1000 * (thread_cpu_seconds() - begin));
        result.boxes = picture.boxes.size();
        result.lines = picture.lines.size();
    }
    return result;
}

void add_all(const std::string& path, std::vector<Measured>& all) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto model = frontend::load_project(sources, path, findings);
    const diagrams::Elements elements(*model);
    for (const diagrams::Subject& subject : diagrams::subjects(*model, sources))
        all.push_back(measure(subject, elements));
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<Measured> all;
    for (int i = 1; i < argc; ++i) add_all(argv[i], all);
    if (all.empty()) {
        fmt::print(stderr, "usage: benchmark_diagrams MODEL...\n");
        return 4;
    }
    std::sort(all.begin(), all.end(),
              [](const Measured& a, const Measured& b) { return a.milliseconds < b.milliseconds; });
    double sum = 0;
    for (const Measured& each : all) sum += each.milliseconds;
    fmt::print("{} diagrams, {:.1f} ms in all; median {:.2f} ms, 95 % below {:.2f} ms\n", all.size(), sum,
               all[all.size() / 2].milliseconds, all[all.size() * 95 / 100].milliseconds);
    for (std::size_t i = all.size() - std::min<std::size_t>(all.size(), 5); i < all.size(); ++i)
        fmt::print("  {:8.2f} ms  {} ({} boxes, {} lines)\n", all[i].milliseconds, all[i].name, all[i].boxes,
                   all[i].lines);
}
