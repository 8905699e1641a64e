// SPDX-License-Identifier: Apache-2.0
// Measures the front end on generated projects of 5,000 to 50,000 lines: loading, parsing, and resolution with all
// rules. Prints lines per second, bytes of memory per line, and whether time grows linearly.
//
//   benchmark_frontend [--seed N] [--runs N]
//
// Exits with 1 if ten times the lines take more than fifteen times the time.
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "tests/random_models/models/well_formed.hpp"

namespace {

namespace fs = std::filesystem;
using namespace robochart;

/// Returns the CPU time, on which other programs on the machine have little effect.
double seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Returns the number of bytes that are currently allocated.
double allocated() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

struct Reading {
    double parse = 0;
    double resolve = 0;
    double load = 0;  ///< time of the whole front end, from files
    double memory = 0;
};

/// Measures parsing, and then resolution.
void measure_phases(const random_models::Project& project, Reading& reading) {
    const double before = allocated();
    const double begin = seconds();
    const auto parsed = random_models::parse(project);
    const double read = seconds();
    frontend::resolve(parsed->model, parsed->findings);
    reading.resolve = seconds() - read;
    reading.parse = read - begin;
    reading.memory = allocated() - before;
}

/// Measures the whole front end as the command uses it: from a folder to a model.
void measure_load(const std::string& folder, Reading& reading) {
    const double begin = seconds();
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto model = frontend::load_project(sources, folder, findings);
    reading.load = seconds() - begin;
    if (findings.error_count() == 0 && !model->files.empty()) return;
    std::fprintf(stderr, "the generated project has errors\n");
    std::exit(70);
}

/// Returns the minimum of several runs, because disturbances only make a run longer.
Reading measure(const random_models::Project& project, std::size_t runs) {
    const fs::path folder = fs::temp_directory_path() / ("robochart_benchmark_" + std::to_string(std::time(nullptr)));
    if (!random_models::write(project, folder.string()).empty()) std::exit(70);
    Reading best;
    for (std::size_t i = 0; i < runs; ++i) {
        Reading reading;
        measure_phases(project, reading);
        measure_load(folder.string(), reading);
        if (i == 0) best = reading;
        best.parse = std::min(best.parse, reading.parse);
        best.resolve = std::min(best.resolve, reading.resolve);
        best.load = std::min(best.load, reading.load);
    }
    fs::remove_all(folder);
    return best;
}

/// Measures one series of sizes with one or many files each. Returns the time per line of the last size, divided by
/// that of the first size.
double series(std::uint64_t seed, std::size_t runs, bool many_files) {
    double first = 0;
    double last = 0;
    for (const std::size_t size : {5'000U, 10'000U, 20'000U, 50'000U}) {
        const std::size_t files = many_files ? size / 500 : 1;
        const random_models::Project project = random_models::sized(seed, size, files);
        const auto lines = static_cast<double>(random_models::lines(project));
        std::size_t bytes = 0;
        for (const random_models::Text& file : project) bytes += file.text.size();
        const Reading reading = measure(project, runs);
        last = reading.load / lines;
        if (first == 0) first = last;
        std::printf("| %zu | %.0f | %.0f | %.1f | %.1f | %.1f | %.0f | %.0f |\n", project.size(), lines,
                    static_cast<double>(bytes) / lines, 1e3 * reading.parse, 1e3 * reading.resolve, 1e3 * reading.load,
                    lines / reading.load, reading.memory / lines);
    }
    std::printf("\ntime a line, largest project against smallest: %.2f\n\n", last / first);
    return last / first;
}

}  // namespace

int main(int count, char** words) {
    std::uint64_t seed = 1;
    std::size_t runs = 5;
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string option = words[i];
        if (option == "--seed") seed = std::stoull(words[i + 1]);
        if (option == "--runs") runs = std::max<std::size_t>(1, std::stoull(words[i + 1]));
    }
    bool linear = true;
    for (const bool many_files : {false, true}) {
        std::printf(
            "| files | lines | bytes of text a line | parse ms | resolve ms | load ms | lines/s | memory bytes a line "
            "|\n");
        std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
        linear = series(seed, runs, many_files) <= 1.5 && linear;
    }
    return linear ? 0 : 1;
}
