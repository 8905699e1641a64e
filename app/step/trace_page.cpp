// SPDX-License-Identifier: Apache-2.0
// See trace_page.hpp.
#include "app/step/trace_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <memory>
#include <utility>

#include "app/base/numbers.hpp"
#include "app/command/run.hpp"
#include "app/pages/html.hpp"
#include "app/step/step_files.hpp"
#include "app/step/stepped_component.hpp"

namespace robochart::app {
namespace {

/// The largest number of logs whose first run is shown.
constexpr std::size_t most_replayed = 20;

class Replays {
public:
    explicit Replays(const Options& options) : options_(options) {}

    /// Returns the first run of the log, as far as the component can follow it.
    runs::Run run_of_log(const ComparedLog& log) {
        runs::Stepper& stepper = stepper_of(log);
        // The constants need no check, because the log was compared with this model.
        const Stepped stepped{log.component, "", log.project, csp_emit::Time::timed, {}, true};
        const Followed followed = follow_log(stepper, stepped, log.path, *options_.run);
        runs::Run run = stepper.run(csp_emit::Time::timed);
        run.end.why = followed.error.empty() ? "the end of the run" : followed.error;
        return run;
    }

private:
    runs::Stepper& stepper_of(const ComparedLog& log) {
        auto& made = components_[{log.project, log.component}];
        if (made == nullptr)
            made = std::make_unique<SteppedComponent>(*log.project, log.component, csp_emit::Time::timed, options_);
        return made->stepper();
    }

    const Options& options_;
    std::map<std::pair<driver::Project*, std::string>, std::unique_ptr<SteppedComponent>> components_;
};

/// Returns a reason such as "logged turn!3 in cycle 2 of run by hand; allowed: ...".
std::string reason_of(const conformance::RunReport& wrong) {
    std::string text = fmt::format("run {}, cycle {}: {}", wrong.name.empty() ? "without a name" : wrong.name,
                                   wrong.cycle, wrong.what);
    if (wrong.verdict == conformance::RunVerdict::inconclusive) return text + ": " + wrong.reason;
    return text +
           "; allowed: " + (wrong.allowed.empty() ? "nothing" : fmt::format("{}", fmt::join(wrong.allowed, ", or ")));
}

driver::Answer answer_of(const conformance::LogReport& counts) {
    if (counts.rejected > 0) return driver::Answer::fails;
    return counts.inconclusive > 0 ? driver::Answer::inconclusive : driver::Answer::holds;
}

driver::AssertionReport report_of(const ComparedLog& log) {
    driver::AssertionReport one;
    one.title =
        fmt::format("the runs of {} ({}) are runs of {}", log.path, count_text(log.counts.runs, "run"), log.component);
    one.answer = answer_of(log.counts);
    if (log.wrong) {
        one.place = fmt::format("{}:{}", log.path, log.wrong->at_line);
        one.reason = reason_of(*log.wrong);
    }
    return one;
}

}  // namespace

std::string trace_page(const std::vector<ComparedLog>& logs, const std::vector<driver::Part>& parts,
                       const Options& options, const std::string& limit) {
    Report report;
    report.limit = limit;
    report.model = options.load.inputs.empty() ? "" : options.load.inputs.front();
    report.summary = fmt::format("{} compared with the model; the first run of each is stepped through",
                                 count_text(logs.size(), "log"));
    if (logs.size() > most_replayed) report.notes.push_back(fmt::format("of the first {} logs", most_replayed));
    Replays replays(options);
    for (std::size_t i = 0; i < logs.size(); ++i) {
        report.assertions.push_back(report_of(logs[i]));
        if (i < most_replayed && limit.empty()) report.assertions.back().run = replays.run_of_log(logs[i]);
    }
    if (limit.empty()) return render_html(report, parts, record_of(options), options.run->budget());
    return last_page(parts, true, [&](const std::vector<driver::Part>& drawn, diagnostics::Budget& budget) {
        return render_html(report, drawn, record_of(options), budget);
    });
}

}  // namespace robochart::app
