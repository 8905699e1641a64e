// SPDX-License-Identifier: Apache-2.0
#include "simulation/chain/chain_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics/json_values.hpp"
#include "simulation/report/line_plot.hpp"
#include "simulation/report/percent.hpp"

namespace robochart::simulation {

using diagnostics::Json;
using diagnostics::json_array;
using diagnostics::json_number;

bool ChainResult::is_refuted() const {
    return order || std::ranges::any_of(answers, [](const ChainAnswer& answer) { return answer.is_refuted(); });
}

bool ChainResult::has_failed() const {
    return is_refuted() || std::ranges::any_of(answers, [](const ChainAnswer& answer) {
               return answer.claim_verdict() == ClaimVerdict::fails;
           });
}

bool ChainResult::is_complete() const {
    return !interrupted && answers.size() == questions && std::ranges::none_of(answers, [](const ChainAnswer& answer) {
        return answer.claim_verdict() == ClaimVerdict::open;
    });
}

std::string answer_word(const ChainAnswer& answer) {
    if (answer.is_refuted()) return "REFUTED";
    const ClaimVerdict verdict = answer.claim_verdict();
    if (verdict == ClaimVerdict::fails) return "FAILS";
    return verdict == ClaimVerdict::estimated ? "estimate" : verdict_word(verdict);
}

namespace {

/// These functions write probabilities, rounded down and up.
std::string lower_bound_text(const ChainAnswer& answer) {
    if (answer.asked.kind != ChainAsked::Kind::time) return percent_below(answer.low);
    return fmt::format("{:.1f} s", std::floor(answer.low * 10) / 10);
}

std::string upper_bound_text(const ChainAnswer& answer) {
    if (answer.asked.kind != ChainAsked::Kind::time) return percent_above(answer.high);
    return fmt::format("{:.1f} s", std::ceil(answer.high * 10) / 10);
}

std::string bounds_text(const ChainAnswer& answer) {
    if (std::isinf(answer.high)) return fmt::format("at least {}; no upper bound was found", lower_bound_text(answer));
    return fmt::format("between {} and {}", lower_bound_text(answer), upper_bound_text(answer));
}

std::string interval_text(const statistics::Interval& interval) {
    return fmt::format("between {} and {}", percent_below(interval.low), percent_above(interval.high));
}

/// Describes the first check that contradicts the prediction.
std::string contradiction_text(const ChainAnswer& answer) {
    const auto found = std::ranges::find_if(answer.checks, [](const ChainCheck& check) { return check.contradicts; });
    const auto all = std::ranges::count_if(answer.checks, [](const ChainCheck& check) { return check.contradicts; });
    if (all == 0) return "the chain is no abstraction here: its order is refuted";
    return fmt::format("the chain is no abstraction here: at {:g} s it says {}, fresh trials {}; so at {} of {} times",
                       found->time, interval_text(found->predicted), interval_text(found->by_trials), all,
                       answer.checks.size());
}

std::string trials_of(std::uint32_t first, std::uint32_t count, std::uint64_t seed) {
    return fmt::format("{} trials from seed {} on", count, seed + first);
}

}  // namespace

std::string answers_text(const ChainResult& result) {
    std::string out;
    for (const ChainAnswer& answer : result.answers)
        out += fmt::format("  {:<8} {}\n           {}\n", answer_word(answer), answer.asked.text,
                           answer.is_refuted() ? contradiction_text(answer)
                                               : fmt::format("{}; fresh trials do not contradict the chain at {} times",
                                                             bounds_text(answer), answer.checks.size()));
    return out;
}

std::string study_text(const Scenario& scenario, const ChainStates& states, const ChainResult& result) {
    return fmt::format(
               "chain of {}: {} states, {:g} s apart; controller {}\n"
               "estimated from {}, checked on {}; {:.1f} CPU seconds\n"
               "{} transitions, {} of them seen, {} excluded: {}\n",
               scenario.name.text, states.size() - 1, scenario.abstraction->every, scenario.component.text,
               trials_of(0, result.trials, scenario.seed), trials_of(result.trials, result.trials, scenario.seed),
               result.cpu_seconds, result.transitions, result.seen, result.excluded, result.proof) +
           order_text(states, result);
}

std::string order_text(const ChainStates& states, const ChainResult& result) {
    if (!result.order_asked) return "not asked: whether what follows a state depends on the one before it\n";
    if (!result.order) return "nothing shows that what follows a state depends on the one before it\n";
    const statistics::OrderContradiction& found = result.order->found;
    const auto after = [&](std::size_t before, const statistics::Interval& interval) {
        return fmt::format("after \"{}\" {}", states.state_text(before), interval_text(interval));
    };
    return fmt::format(
        "REFUTED with confidence {}: what follows a state depends on the one before it; on \"{}\" follows \"{}\" {}, "
        "{}\n",
        percent_text(result.order->confidence), states.state_text(found.state), states.state_text(found.next),
        after(found.less, found.after_less), after(found.more, found.after_more));
}

std::string chain_summary(const ChainResult& result) {
    const auto refuted =
        std::ranges::count_if(result.answers, [](const ChainAnswer& answer) { return answer.is_refuted(); });
    const auto fails = std::ranges::count_if(result.answers, [](const ChainAnswer& answer) {
        return !answer.is_refuted() && answer.claim_verdict() == ClaimVerdict::fails;
    });
    const auto open = std::ranges::count_if(result.answers, [](const ChainAnswer& answer) {
        return !answer.is_refuted() && answer.claim_verdict() == ClaimVerdict::open;
    });
    std::string out;
    if (result.order)
        out = "refuted: the chain is no abstraction here (what follows a state depends on the one before it)";
    else if (refuted > 0)
        out = fmt::format("refuted: the chain is no abstraction here ({} of {} answers)", refuted, result.questions);
    const auto add = [&](std::ptrdiff_t count, const char* what) {
        if (count > 0) out += fmt::format("{}{} of {} {}", out.empty() ? "" : ", ", count, result.questions, what);
    };
    add(fails, "fail");
    add(open + static_cast<std::ptrdiff_t>(result.questions - result.answers.size()), "open");
    if (out.empty()) out = fmt::format("{} of {} answered, none refuted", result.answers.size(), result.questions);
    return out;
}

std::string transitions_csv(const ChainStates& states, const statistics::Permitted& permitted,
                            const statistics::TransitionCounts& counts, double error) {
    const auto intervals = statistics::transition_intervals(counts, permitted, error);
    std::string out = "from,to,count,visits,low,high\n";
    for (std::size_t from = 0; from < states.size(); ++from) {
        const std::uint64_t visits = counts.visit_count(from);
        for (std::size_t to = 0; to < states.size() && visits > 0; ++to)
            if (permitted[from][to])
                out +=
                    fmt::format("\"{}\",\"{}\",{},{},{:.6f},{:.6f}\n", states.state_text(from), states.state_text(to),
                                counts.count(from, to), visits, intervals[from][to].low, intervals[from][to].high);
    }
    return out;
}

std::string checks_csv(const ChainResult& result) {
    std::string out = "question,time,chain_low,chain_high,fresh,fresh_low,fresh_high,contradicts\n";
    for (std::size_t q = 0; q < result.answers.size(); ++q)
        for (const ChainCheck& check : result.answers[q].checks)
            out += fmt::format("{},{:g},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{}\n", q + 1, check.time,
                               check.predicted.low, check.predicted.high, check.seen, check.by_trials.low,
                               check.by_trials.high, check.contradicts);
    return out;
}

std::string answer_svg(const ChainAnswer& answer) {
    std::vector<PlotLine> lines{{"the chain, at most", {}}, {"the chain, at least", {}}, {"fresh trials", {}}};
    for (const ChainCheck& check : answer.checks) {
        lines[0].points.push_back({check.time, check.predicted.high, check.predicted.high, check.predicted.high});
        lines[1].points.push_back({check.time, check.predicted.low, check.predicted.low, check.predicted.low});
        lines[2].points.push_back({check.time, check.seen, check.by_trials.low, check.by_trials.high});
    }
    return line_plot_svg(answer.asked.text, "time [s]", lines);
}

namespace {

Json check_json(const ChainCheck& check) {
    return {{"time", json_number(check.time)},
            {"chain", {json_number(check.predicted.low), json_number(check.predicted.high)}},
            {"fresh", json_number(check.seen)},
            {"interval", {json_number(check.by_trials.low), json_number(check.by_trials.high)}},
            {"contradicts", check.contradicts}};
}

const char* kind_word(ChainAsked::Kind kind) {
    if (kind == ChainAsked::Kind::within) return "probability";
    return kind == ChainAsked::Kind::time ? "time" : "average";
}

Json answer_json(const ChainAnswer& answer) {
    const char* const kind = kind_word(answer.asked.kind);
    std::string verdict = answer.is_refuted() ? "refuted" : verdict_word(answer.claim_verdict());
    return Json{{"question", answer.asked.text},
                {"kind", kind},
                {"verdict", std::move(verdict)},
                {"confidence", json_number(answer.asked.confidence)},
                {"low", json_number(answer.low)},
                {"high", json_number(answer.high)},
                {"checks", json_array(answer.checks, check_json)}};
}

/// Returns the result of the test of the order, or null if there is no contradiction.
Json order_json(const ChainStates& states, const ChainResult& result) {
    if (!result.order) return nullptr;
    const statistics::OrderContradiction& found = result.order->found;
    const auto after = [&](std::size_t before, const statistics::Interval& interval) {
        return Json{{"before", states.state_text(before)}, {"low", interval.low}, {"high", interval.high}};
    };
    return {{"confidence", result.order->confidence},
            {"state", states.state_text(found.state)},
            {"next", states.state_text(found.next)},
            {"less", after(found.less, found.after_less)},
            {"more", after(found.more, found.after_more)}};
}

}  // namespace

std::string chain_json(const Scenario& scenario, const ChainStates& states, const ChainResult& result,
                       const std::vector<std::string>& files, int exit) {
    const Json json{{"schema", "robochart-verify/chain/1"},
                    {"scenario", scenario.name.text},
                    {"component", scenario.component.text},
                    {"robots", scenario.robots},
                    {"seed", scenario.seed},
                    {"trials", result.trials},
                    {"every", json_number(scenario.abstraction->every)},
                    {"states", states.size() - 1},
                    {"transitions", result.transitions},
                    {"seen", result.seen},
                    {"excluded", result.excluded},
                    {"proof", result.proof},
                    {"orderAsked", result.order_asked},
                    {"order", order_json(states, result)},
                    {"interrupted", result.interrupted},
                    {"cpuSeconds", diagnostics::round_to_places(result.cpu_seconds, 3)},
                    {"answers", json_array(result.answers, answer_json)},
                    {"world", world_lines(scenario)},
                    {"files", files},
                    {"exit", exit}};
    return diagnostics::json_text(json) + "\n";
}

}  // namespace robochart::simulation
