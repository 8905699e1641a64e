// SPDX-License-Identifier: Apache-2.0
// Implements `conform MODEL.claims --traces LOG`, which checks logs of runs against claims (docs/traces.md, "Logs and
// claims").
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "app/base/numbers.hpp"
#include "app/claims/event_order.hpp"
#include "app/command/answer.hpp"
#include "app/command/findings.hpp"
#include "app/command/output.hpp"
#include "app/command/recording.hpp"
#include "app/command/run.hpp"
#include "app/verbs/log_files.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/json_values.hpp"
#include "conformance/traces/trace_text.hpp"
#include "driver/claims/followed_claim.hpp"
#include "driver/model/instantiated_claims.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/model/project_claims.hpp"

namespace robochart::app {
namespace {

using claims::CheckedClaim;
using conformance::TraceToken;
using driver::FollowedClaim;

/// One log and the claims of one project.
class ClaimLog final : public RunReader {
public:
    ClaimLog(const driver::Project& project, std::string path, LogReport& report, const Options& options)
        : RunReader(std::move(path), report, options), project_(project), report_(report) {}

private:
    /// Begins a run. Only claims about the component of the log are followed.
    void begin_run(const conformance::TraceHeader& header) override {
        conformance::compare_units(header, project_.unit);
        followed_.clear();
        const driver::ProjectClaims& of = *project_.claims;
        for (const CheckedClaim& claim : of.checked.claims) {
            const std::string& path = claim.component.path;
            if (path != header.component && !path.ends_with("::" + header.component)) continue;
            followed_.emplace_back(claim, project_.system, project_.unit, drops_of(path));
            if (const std::string why = why_not_followed(claim, header); !why.empty()) followed_.back().give_up(why);
            for (const std::string& word : header.unobserved) hide(followed_.back(), word);
        }
    }
    [[nodiscard]] std::string why_not_followed(const CheckedClaim& claim,
                                               const conformance::TraceHeader& header) const {
        const std::string why = claims::why_not_followed(claim);
        return why.empty() ? driver::why_other_constants(project_, claim, header.constants) : why;
    }
    const FollowedClaim::Drops& drops_of(const std::string& component) {
        const auto [known, fresh] = drops_.try_emplace(component);
        if (fresh) known->second = dropped_events(project_, component);
        return known->second;
    }
    static void hide(FollowedClaim& followed, const std::string& word) {
        const std::string name = word.substr(0, word.find_first_of("?!"));
        const auto& channels = followed.claim().component.channels;
        if (std::ranges::any_of(channels, [&](const claims::Channel& channel) { return channel.name == name; }))
            followed.give_up(fmt::format("the log does not show {}", word));
    }

    void follow(const std::vector<TraceToken>& tokens, std::uint64_t line) override {
        if (tokens.size() == 1 && (tokens[0].text == "late" || tokens[0].text == "lost")) {
            for (FollowedClaim& followed : followed_)
                followed.give_up(fmt::format("the log has gaps (`{}` in line {})", tokens[0].text, line));
            return;
        }
        for (const TraceToken& token : tokens) follow_word(std::string(token.text), line);
    }

    void follow_word(const std::string& word, std::uint64_t line) {
        if (word == "tock") ++report_.units;
        const std::size_t mark = word.find_first_of("?!");
        std::vector<std::string> values;
        if (mark != std::string::npos) values = split(word.substr(mark + 1));
        for (FollowedClaim& followed : followed_) {
            if (word == "tock")
                followed.tock(line);
            else if (word == "terminate")
                followed.end(line);
            else if (mark != std::string::npos)
                followed.observe(word.substr(0, mark), word[mark] == '?', values, line);
        }
    }
    /// Splits the values of an output, such as "a!b".
    static std::vector<std::string> split(const std::string& text) {
        std::vector<std::string> result;
        std::size_t from = 0;
        while (!text.empty()) {
            const std::size_t end = text.find('!', from);
            result.push_back(text.substr(from, end - from));
            if (end == std::string::npos) break;
            from = end + 1;
        }
        return result;
    }

    void end_run() override {
        for (FollowedClaim& followed : followed_) {
            followed.finish();
            const bool open = !followed.is_broken() && !followed.unknown().empty();
            if (followed.is_broken())
                ++report_.broken;
            else
                ++(open ? report_.open : report_.kept);
            if (!followed.is_broken() && !open) continue;
            LoggedRun logged = entry(!open, open ? first_line() : followed.line());
            logged.claim = followed.claim().name;
            logged.lines = open ? std::vector<std::string>{followed.unknown()} : followed.reasons();
            report_.add(std::move(logged));
        }
    }

    const driver::Project& project_;
    LogReport& report_;
    std::vector<FollowedClaim> followed_;
    std::map<std::string, FollowedClaim::Drops> drops_;  ///< key: the component
};

/// Returns the exit code. The result is inconclusive if no log has a claim about its component.
Exit exit_of(const LogReport& report) {
    if (!report.errors.empty()) return Exit::bad_input;
    if (report.broken > 0) return Exit::failed;
    return report.open > 0 || report.kept == 0 ? Exit::inconclusive : Exit::success;
}

void print_logs(const LogReport& report) {
    print_reported(report);
    print("an input counts as an event of a claim when it is raised, also if the controller misses it\n");
    if (report.kept + report.broken + report.open == 0) print("no claim is about the component of a log\n");
    print("{} in {}, {}: of the claims, {} are kept, {} are broken, {} inconclusive\n", count_text(report.runs, "run"),
          count_text(report.logs, "log"), count_text(report.units, "time unit"), with_commas(report.kept),
          with_commas(report.broken), with_commas(report.open));
}

std::string logs_json(const LogReport& report) {
    return diagnostics::json_text(
               log_report_json(report, "robochart-verify/claim-traces/1", "timeUnits", "kept", exit_of(report))) +
           "\n";
}

}  // namespace

Exit conform_claims(const Options& options) {
    driver::Settings settings = options;
    settings.load.claims = driver::ClaimUse::decide;
    const std::vector<driver::Part> parts = driver::load_parts(settings, options.run->budget());
    record_projects(parts, settings, options);
    for (const driver::Part& part : parts)
        if (!part.project->diagnostics.ok()) {
            (void)show_diagnostics(*part.project, options);
            return refusal_code(*part.project);
        }
    LogReport report;
    for (const std::string& log : log_files(options, report.errors))
        for (const driver::Part& part : parts)
            if (!part.project->claims->checked.claims.empty())
                read_log(log, options, report.errors, report.logs,
                         [&](std::istream& in) { ClaimLog(*part.project, log, report, options).read(in); });
    options.run->finish();
    output_document(options, [&](Format) { return logs_json(report); });
    if (options.output.format == Format::text) print_logs(report);
    return exit_of(report);
}

}  // namespace robochart::app
