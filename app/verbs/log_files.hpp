// SPDX-License-Identifier: Apache-2.0
// Reads the logs that `--traces` names, for comparisons with rules and with claims (docs/traces.md).
#pragma once

#include <cstdint>
#include <functional>
#include <istream>
#include <string>
#include <vector>

#include "app/command/answer.hpp"
#include "app/command/options.hpp"
#include "base/diagnostics/json_values.hpp"
#include "conformance/traces/trace_text.hpp"

namespace robochart::app {

/// Returns the files, and the logs in the folders, in order. Adds an error if there are no logs.
[[nodiscard]] std::vector<std::string> log_files(const Options& options, std::vector<std::string>& errors);

/// Opens the log, records it as an input, counts it in `logs` and passes it to `read`. Adds an error if the file cannot
/// be read, or if `read` throws conformance::TraceFault.
void read_log(const std::string& path, const Options& options, std::vector<std::string>& errors, std::uint64_t& logs,
              const std::function<void(std::istream&)>& read);

/// A run that breaks a rule or a claim, or a run for which the answer is unknown.
struct LoggedRun {
    std::string log, run;
    std::string claim;  ///< "" if the run was compared with all rules of a file
    std::uint64_t line = 0;
    bool broken = false;
    std::vector<std::string> lines;
};

/// The results of all logs. `kept`, `broken` and `open` count runs, or claims of runs.
struct LogReport {
    std::uint64_t logs = 0, runs = 0, units = 0, kept = 0, broken = 0, open = 0;
    std::vector<LoggedRun> reported;  ///< the first runs that are not kept
    std::vector<std::string> errors;

    /// Adds an entry, unless the list is long enough.
    void add(LoggedRun entry);
};

/// Prints the runs in the list, then the errors.
void print_reported(const LogReport& report);
/// Returns the members that the documents about rules and claims share. `kept` and `units` are the names of two
/// members: the number of runs or claims that are kept, and the number of time units.
[[nodiscard]] diagnostics::Json log_report_json(const LogReport& report, const char* schema, const char* units,
                                                const char* kept, Exit exit);

/// Reads a log, and passes its runs to the functions below.
class RunReader {
public:
    RunReader(std::string path, LogReport& report, const Options& options)
        : path_(std::move(path)), report_(report), options_(options) {}
    virtual ~RunReader() = default;
    RunReader(const RunReader&) = delete;
    RunReader& operator=(const RunReader&) = delete;

    /// Throws conformance::TraceFault.
    void read(std::istream& in);

protected:
    virtual void begin_run(const conformance::TraceHeader& header) = 0;
    virtual void follow(const std::vector<conformance::TraceToken>& tokens, std::uint64_t line) = 0;
    virtual void end_run() = 0;

    /// Returns an entry for the current run.
    [[nodiscard]] LoggedRun entry(bool broken, std::uint64_t line) const {
        return {path_, name_, "", line, broken, {}};
    }
    [[nodiscard]] std::uint64_t first_line() const { return begun_; }
    [[nodiscard]] const Options& options() const { return options_; }

private:
    std::string path_;
    LogReport& report_;
    const Options& options_;
    std::string name_;         ///< name of the current run
    std::uint64_t begun_ = 0;  ///< line where the current run begins
};

}  // namespace robochart::app
