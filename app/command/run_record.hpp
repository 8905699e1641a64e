// SPDX-License-Identifier: Apache-2.0
// The record of a run: what a reader needs to know to repeat it. Every report contains it (docs/cli.md). The run owns
// one recorder; the verbs tell it what they read and which values they use.
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

/// Who chose a value.
enum class ValueSource {
    model,        ///< the model, or a file of properties
    by_default,   ///< the command, because nobody else did
    option,       ///< --const, --range, or the search of `tune`
    preferences,  ///< the file of --prefs
    scenario,
    swarm,
    log,    ///< the header of a log
    block,  ///< a CSP block; it applies to the scripts only
};

/// A constant in force.
struct RecordedConstant {
    std::string model;  ///< name of the project
    std::string name;   ///< "P::S::c"
    std::string value;  ///< in the notation of the model
    ValueSource source = ValueSource::model;

    friend auto operator<=>(const RecordedConstant&, const RecordedConstant&) = default;
};

/// A carrier or a size in force, by its name in --range.
struct RecordedRange {
    std::string model;
    std::string type;
    double low = 0, high = 0;
    std::uint64_t values = 0;  ///< their number; a carrier of reals may contain decimals
    ValueSource source = ValueSource::by_default;

    friend auto operator<=>(const RecordedRange&, const RecordedRange&) = default;
};

struct RecordedInput {
    std::string path;    ///< as the command named it
    std::string sha256;  ///< of its bytes

    friend bool operator==(const RecordedInput&, const RecordedInput&) = default;
};

/// The record as data. A value is absent if the verb has no such option, or if the run did not use it.
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
    std::optional<std::uint64_t> peak_memory_bytes;  ///< so far, of the program without its child processes
};

/// Collects the record. Any thread may call it.
class RunRecorder {
public:
    /// Adds the files that options name. `memory_bytes`: the limit in force.
    RunRecorder(const Options&, std::uint64_t memory_bytes);

    void set_command(std::vector<std::string> command);
    /// Adds a text that the run has read. The first text of a path counts: later ones are parts of it.
    void add_input(const std::string& path, std::string_view text);
    /// The same for a file that is read elsewhere. Only a regular file that can be read is added.
    void add_input_file(const std::string& path);
    void add_constants(const std::vector<RecordedConstant>&);
    void add_ranges(const std::vector<RecordedRange>&);
    /// Removes the constant of this model and name, or the range of this model and type.
    void remove_constant(const std::string& model, const std::string& name);
    void remove_range(const std::string& model, const std::string& type);
    /// Removes all constants and ranges, because another instantiation follows.
    void forget_values();
    void set_seed(std::uint64_t seed);
    /// True if the command line has a --range for this type.
    [[nodiscard]] bool has_range_option(const std::string& type) const;

    /// The record so far.
    [[nodiscard]] RunRecord record() const;

private:
    [[nodiscard]] bool has_input(const std::string& path) const;
    void add_digest(const std::string& path, std::string digest);

    mutable std::mutex mutex_;
    RunRecord record_;
    const std::vector<std::string> range_options_;  ///< TYPE=LOW..HIGH
};

/// The record of the options' run.
[[nodiscard]] RunRecord record_of(const Options&);

/// The member `run` of a JSON report.
[[nodiscard]] diagnostics::Json run_json(const RunRecord&);
/// A JSON report with the record as its last member, `run`. `document`: an object that is not empty, in any layout.
[[nodiscard]] std::string with_run(std::string document, const RunRecord&);
/// The record as JSON on one line of printable ASCII, for a comment in a file that is written while the run goes on; so
/// the peak memory is null.
[[nodiscard]] std::string run_line(RunRecord);
/// The record for people, one fact a line. Foreign text is escaped.
[[nodiscard]] std::string run_text(const RunRecord&);
/// The record as the last part of a page.
[[nodiscard]] std::string run_html(const RunRecord&);

}  // namespace robochart::app
