// SPDX-License-Identifier: Apache-2.0
// Collects the record of a run.
#include "app/command/run_record.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "app/command/option_table.hpp"
#include "app/command/run.hpp"
#include "base/cache/sha256.hpp"
#include "base/diagnostics/containers.hpp"
#include "base/threads/threads.hpp"

namespace robochart::app {
namespace {

bool has_option(Verb verb, std::string_view name) {
    return std::ranges::any_of(options_of(verb_bit(verb)),
                               [&](const OptionRow* row) { return long_name(*row) == name; });
}

/// Returns the peak main memory of this program so far; no value if the system does not report it. getrusage is not
/// used, because its value includes the memory of the program that started this one.
std::optional<std::uint64_t> peak_memory() {
    constexpr std::string_view label = "VmHWM:";
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (!line.starts_with(label)) continue;
        const std::size_t digits = line.find_first_of("0123456789");
        std::uint64_t kibibytes = 0;
        if (digits == std::string::npos) return std::nullopt;
        if (std::from_chars(line.data() + digits, line.data() + line.size(), kibibytes).ec != std::errc())
            return std::nullopt;
        return kibibytes << 10U;
    }
    return std::nullopt;
}

/// Adds the elements that are missing, and sorts the list.
template <typename Element>
void merge(std::vector<Element>& all, const std::vector<Element>& more) {
    all.insert(all.end(), more.begin(), more.end());
    diagnostics::sort_unique(all);
}

}  // namespace

RunRecorder::RunRecorder(const Options& options, std::uint64_t memory_bytes)
    : range_options_(options.instantiation.ranges) {
    record_.version = program_version;
    record_.commit = built_commit();
    record_.command = {"robochart-verify"};
    record_.memory_bytes = memory_bytes;
    record_.seed = options.given_seed;
    if (options.limits.timeout_seconds > 0) record_.seconds = options.limits.timeout_seconds;
    if (options.limits.assertion_seconds > 0) record_.assertion_seconds = options.limits.assertion_seconds;
    if (has_option(options.verb, "--max-states")) record_.states = options.limits.max_states;
    if (has_option(options.verb, "--no-reduction")) record_.reduction = options.limits.reduction;
    if (has_option(options.verb, "--threads")) record_.threads = diagnostics::threads_wanted(options.limits.threads);
    for (const std::string& file : {options.swarm.file, options.code.mapping, options.probability.preferences,
                                    options.tune.certificate, options.simulate.compare})
        if (!file.empty()) add_input_file(file);
}

void RunRecorder::set_command(std::vector<std::string> command) {
    const std::lock_guard lock(mutex_);
    record_.command = std::move(command);
}

bool RunRecorder::has_input(const std::string& path) const {
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(record_.inputs, [&](const RecordedInput& input) { return input.path == path; });
}

void RunRecorder::add_digest(const std::string& path, std::string digest) {
    const std::lock_guard lock(mutex_);
    record_.inputs.push_back({path, std::move(digest)});
}

void RunRecorder::add_input(const std::string& path, std::string_view text) {
    if (!has_input(path)) add_digest(path, diagnostics::sha256(text));
}

void RunRecorder::add_input_file(const std::string& path) {
    std::error_code code;
    if (has_input(path) || !std::filesystem::is_regular_file(path, code)) return;
    std::ifstream file(path, std::ios::binary);
    diagnostics::Sha256 hash;
    std::array<char, 1U << 16U> piece{};
    while (file) {
        file.read(piece.data(), piece.size());
        hash.add({piece.data(), static_cast<std::size_t>(file.gcount())});
    }
    if (file.eof()) add_digest(path, hash.finish());
}

void RunRecorder::add_constants(const std::vector<RecordedConstant>& constants) {
    const std::lock_guard lock(mutex_);
    merge(record_.constants, constants);
}

void RunRecorder::add_ranges(const std::vector<RecordedRange>& ranges) {
    const std::lock_guard lock(mutex_);
    merge(record_.ranges, ranges);
}

void RunRecorder::remove_constant(const std::string& model, const std::string& name) {
    const std::lock_guard lock(mutex_);
    std::erase_if(record_.constants, [&](const auto& old) { return old.model == model && old.name == name; });
}

void RunRecorder::remove_range(const std::string& model, const std::string& type) {
    const std::lock_guard lock(mutex_);
    std::erase_if(record_.ranges, [&](const auto& old) { return old.model == model && old.type == type; });
}

void RunRecorder::forget_values() {
    const std::lock_guard lock(mutex_);
    record_.constants.clear();
    record_.ranges.clear();
}

void RunRecorder::set_seed(std::uint64_t seed) {
    const std::lock_guard lock(mutex_);
    record_.seed = seed;
}

bool RunRecorder::has_range_option(const std::string& type) const {
    return std::ranges::any_of(range_options_,
                               [&](const std::string& option) { return option.starts_with(type + "="); });
}

RunRecord RunRecorder::record() const {
    const std::lock_guard lock(mutex_);
    RunRecord record = record_;
    record.peak_memory_bytes = peak_memory();
    return record;
}

RunRecord record_of(const Options& options) {
    return options.run->recorder().record();
}

}  // namespace robochart::app
