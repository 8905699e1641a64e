// SPDX-License-Identifier: Apache-2.0
// Collects the record of a run, which contains the data that a reader needs to repeat the run. Every report contains
// the record (docs/cli.md). The run owns one recorder, and the verbs add the files that they read and the values that
// they use.
#pragma once

#include <compare>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/built_commit.hpp"
#include "app/command/options.hpp"
#include "base/diagnostics/json.hpp"

namespace robochart::app {

/// The source of a value.
enum class ValueSource {
    model,        ///< the model, or a file of properties
    by_default,   ///< the default of the command
    option,       ///< --const, --range, or the search of `tune`
    preferences,  ///< the file of --prefs
    scenario,
    swarm,
    log,    ///< the header of a log
    block,  ///< a CSP block; the value applies only to the scripts
};

/// A constant with the value that the run uses.
struct RecordedConstant {
    std::string model;  ///< the project's name
    std::string name;   ///< "P::S::c"
    std::string value;  ///< in the notation of the model
    ValueSource source = ValueSource::model;

    friend auto operator<=>(const RecordedConstant&, const RecordedConstant&) = default;
};

/// A carrier or a size that the run uses, by its name in --range.
struct RecordedRange {
    std::string model;
    std::string type;
    double low = 0, high = 0;
    std::uint64_t values = 0;  ///< number of values; a carrier of reals may contain decimals
    ValueSource source = ValueSource::by_default;

    friend auto operator<=>(const RecordedRange&, const RecordedRange&) = default;
};

struct RecordedInput {
    std::string path;    ///< as given on the command line
    std::string sha256;  ///< hash of the bytes of the text

    friend bool operator==(const RecordedInput&, const RecordedInput&) = default;
};

/// The record as data. A value is absent if the verb does not have the option, or if the run did not use it.
struct RunRecord {
    std::string version;
    Commit commit;
    std::vector<std::string> command;         ///< the program's name and its arguments
    std::vector<RecordedInput> inputs;        ///< in the order in which they were read
    std::vector<RecordedConstant> constants;  ///< ascending
    std::vector<RecordedRange> ranges;        ///< ascending
    std::optional<std::uint64_t> seed;
    std::uint64_t memory_bytes = 0;
    std::optional<double> seconds, assertion_seconds;
    std::optional<std::uint64_t> states;
    std::optional<bool> reduction;
    std::optional<unsigned> threads;
    std::optional<std::uint64_t> peak_memory_bytes;  ///< peak so far, without child processes
};

/// Collects the record. Any thread may call it.
class RunRecorder {
public:
    /// Adds the files that the options name. `memory_bytes` is the memory limit of the run.
    RunRecorder(const Options&, std::uint64_t memory_bytes);

    void set_command(std::vector<std::string> command);
    /// Adds a text that the run has read. If several texts have the same path, only the first is stored, because later
    /// ones are parts of the first.
    void add_input(const std::string& path, std::string_view text);
    /// Adds a file that other code of the run reads. Does nothing if the path is not a readable regular file.
    void add_input_file(const std::string& path);
    void add_constants(const std::vector<RecordedConstant>&);
    void add_ranges(const std::vector<RecordedRange>&);
    /// Remove one constant, or the range of one type, of this model.
    void remove_constant(const std::string& model, const std::string& name);
    void remove_range(const std::string& model, const std::string& type);
    /// Removes all constants and ranges. Called before another instantiation is recorded.
    void forget_values();
    void set_seed(std::uint64_t seed);
    /// True if the command line has a --range for this type.
    [[nodiscard]] bool has_range_option(const std::string& type) const;

    /// Returns the record so far.
    [[nodiscard]] RunRecord record() const;

private:
    [[nodiscard]] bool has_input(const std::string& path) const;
    void add_digest(const std::string& path, std::string digest);

    mutable std::mutex mutex_;
    RunRecord record_;
    const std::vector<std::string> range_options_;  ///< the ranges TYPE=LOW..HIGH of the command line
};

/// Returns the record of the run with these options.
[[nodiscard]] RunRecord record_of(const Options&);

/// Returns the member `run` of a JSON report.
[[nodiscard]] diagnostics::Json run_json(const RunRecord&);
/// Returns the JSON report `document` with the record as its last member, `run`. `document` is an object that is not
/// empty, in any layout.
[[nodiscard]] std::string with_run(std::string document, const RunRecord&);
/// Returns the record as JSON on one line of printable ASCII, for a comment in a file. The file is written before the
/// run ends, so the peak memory is null.
[[nodiscard]] std::string run_line(RunRecord);
/// Returns the record for people, one value per line. Foreign text is escaped.
[[nodiscard]] std::string run_text(const RunRecord&);
/// Returns the record as the last part of a page.
[[nodiscard]] std::string run_html(const RunRecord&);

}  // namespace robochart::app
