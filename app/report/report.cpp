// SPDX-License-Identifier: Apache-2.0
#include "app/report/report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "app/base/numbers.hpp"
#include "app/command/output.hpp"
#include "app/report/probability_report.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/paint.hpp"
#include "conformance/model/rules.hpp"
#include "counterexample/text.hpp"
#include "driver/claims/certificates.hpp"

namespace robochart::app {
namespace {

std::string_view outcome_word(conformance::Outcome outcome) {
    constexpr std::array<std::string_view, 7> words{"conforms",      "DIFFERS", "ROUNDS",      "NOT SCHEDULABLE",
                                                    "not generated", "error",   "inconclusive"};
    return words[static_cast<std::size_t>(outcome)];
}

using diagnostics::Paint;

/// Returns a verdict for the beginning of a line, padded to the width of the longest verdict.
std::string padded_verdict(std::string_view word, Paint paint, bool color) {
    constexpr std::size_t widest = 12;
    return fmt::format("  {}{:<{}} ", diagnostics::paint_text(word, paint, color), "",
                       widest - std::min(widest, word.size()));
}

Paint paint_of(driver::Answer answer) {
    if (answer == driver::Answer::holds || answer == driver::Answer::computed) return Paint::success;
    return answer == driver::Answer::fails || answer == driver::Answer::error ? Paint::error : Paint::warning;
}

Paint paint_of(conformance::Outcome outcome) {
    if (outcome == conformance::Outcome::conforms) return Paint::success;
    return outcome == conformance::Outcome::inconclusive ? Paint::warning : Paint::error;
}

std::string duration_text(double seconds) {
    return seconds < 1 ? fmt::format("{:.0f} ms", seconds * 1000) : fmt::format("{:.1f} s", seconds);
}

/// False for answers from random paths, which explore no states.
bool has_statistics(const driver::AssertionReport& a) {
    if (a.probability && a.statistics.states == 0) return false;
    return a.answer == driver::Answer::holds || a.answer == driver::Answer::fails || a.statistics.states > 0;
}

/// Describes the effect of the symmetry reduction; "" if no components are equal.
std::string symmetry_text(const refine::Statistics& size) {
    if (size.distinguished > 0)
        return fmt::format(
            "               {} components are equal, but the assertion distinguishes some of them: states "
            "that differ in these are all searched\n",
            size.distinguished);
    return size.replicas > 0 ? fmt::format(
                                   "               {} components are equal: of states that differ in which of them "
                                   "does what, one is searched\n",
                                   size.replicas)
                             : "";
}

std::string proof_text(const refine::Statistics& size) {
    const std::string_view reason = proof_reason(size.decided_by);
    if (size.decided_by == refine::DecidedBy::diagrams)
        return fmt::format("               decided by {}\n", diagrams_text(size));
    return reason.empty() ? "" : fmt::format("               {}\n", reason);
}

/// A run that several components share: where it is printed, and the other components.
struct SharedRun {
    std::string shown_at;             ///< "module P::M"; "" if it is printed with this assertion
    std::vector<std::string> others;  ///< components with the same run
};

/// Returns the run of the model, with its raw events if the options request them.
std::string run_lines(const driver::AssertionReport& a, const Options& options) {
    if (!a.run) return a.counterexample;
    std::string out = runs::text_of(*a.run, indent_of_runs);
    const std::vector<std::string> raw(a.run->raw.begin(),
                                       a.run->raw.end() - static_cast<std::ptrdiff_t>(a.run->raw_loop));
    if (options.output.show_internal && !raw.empty())
        out += fmt::format("                 events <{}>\n", fmt::join(raw, ", "));
    return out;
}

/// The number of entries of a basis that are shown per kind. JSON, SARIF and the page list all.
constexpr std::size_t listed_grounds = 8;

/// Returns the text after the verdict. A core property has no title, because it is listed under its component.
std::string assertion_rest(const driver::AssertionReport& a, const std::string& subject, std::size_t width,
                           const Options& options, const SharedRun& shared) {
    const std::size_t padded = has_statistics(a) ? width : 0;
    std::string out = fmt::format("{:<{}}", a.core && width > 0 ? a.core->property : a.title, padded);
    if (has_statistics(a))
        out += fmt::format("  {:>9} states {:>8}", with_commas(a.statistics.states),
                           a.searched ? duration_text(a.statistics.seconds) : "known");
    out += '\n';
    out += proof_text(a.statistics);
    out += symmetry_text(a.statistics);
    if (!a.reason.empty()) out += fmt::format("               {}\n", a.reason);
    for (const std::string& line : basis_lines(a.basis, listed_grounds))
        out += fmt::format("               {}\n", line);
    if (a.certificate) out += fmt::format("               {}\n", driver::certificate_text(*a.certificate));
    if (a.probability) out += probability_text(*a.probability, "               ");
    if (!a.run && a.counterexample.empty()) return out;
    if (!shared.shown_at.empty()) return out + fmt::format("               by the run of {} above\n", shared.shown_at);
    std::string claimed;
    if (!a.place.empty())
        claimed = fmt::format("{} at {}; ", a.core ? "declared" : "claimed", diagnostics::escape_for_display(a.place));
    out += fmt::format("               {}the {} does:\n{}", claimed, subject, run_lines(a, options));
    if (!shared.others.empty())
        out += fmt::format("               the same run is one of {}\n", fmt::join(shared.others, " and of "));
    return out;
}

std::string assertion_block(const driver::AssertionReport& a, const std::string& subject, std::size_t width,
                            const Options& options, bool color, const SharedRun& shared = {}) {
    return padded_verdict(answer_word(a.answer), paint_of(a.answer), color) +
           diagnostics::shown_lines(assertion_rest(a, subject, width, options, shared));
}

/// Writes the cycles to which the verdicts apply, if these are not all cycles of the model.
void write_cycles(std::string& out, const std::vector<conformance::Cycle>& cycles) {
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        const conformance::Cycle& cycle = cycles[i];
        out +=
            fmt::format("                 cycle {:<3} in {{{}}}  out <{}>{}{}\n", i + 1, fmt::join(cycle.inputs, ", "),
                        fmt::join(cycle.outputs, ", "), cycle.state.empty() ? "" : "  ", cycle.state);
    }
}

std::string code_of(const diagnostics::Rule* rule) {
    return rule == nullptr ? "" : fmt::format(" [{}]", rule->code);
}

/// Writes the reason why a model cannot be run in cycles, in terms of the model.
void write_explanation(std::string& out, const conformance::Explanation& explanation) {
    if (explanation.rule == nullptr) return;
    for (const std::string& place : explanation.where)
        out += fmt::format("                 {}\n", diagnostics::escape_for_display(place));
    if (!explanation.remedy.empty())
        out += fmt::format("               to make it schedulable: {}\n", explanation.remedy);
    out += fmt::format("               see `robochart-verify explain {}`\n", explanation.rule->code);
}

void write_meaning(std::string& out, const conformance::Aside& aside) {
    if (aside.rule != nullptr) out += fmt::format("                 {}\n", conformance::meaning_of(aside));
}

std::string in_cycles(const std::optional<std::uint64_t>& cycles) {
    if (!cycles) return "any number of cycles";
    return *cycles == 1 ? "1 cycle" : fmt::format("{} cycles", with_commas(*cycles));
}

/// Lists the first of some places: "enters A, B, C and 2 more".
std::string first_of(const std::vector<std::string>& places) {
    constexpr std::size_t most = 3;
    const auto shown = places.begin() + static_cast<std::ptrdiff_t>(std::min(places.size(), most));
    std::string text = fmt::format("{}", fmt::join(places.begin(), shown, ", "));
    if (places.size() > most) text += fmt::format(" and {} more", places.size() - most);
    return text;
}

/// Describes the reason for the loss of an event, and the states in which it is lost.
std::string reason_text(const conformance::MissedEvent::Reason& reason) {
    const bool busy = reason.why == conformance::MissedWhile::busy;
    return fmt::format("{} while {}: {}", in_cycles(reason.cycles), busy ? "the machine is busy" : "no condition holds",
                       first_of(reason.places));
}

/// Writes the largest number of consecutive cycles in which an event is lost. If there are two reasons, writes the
/// number for each reason.
void write_missed(std::string& out, const std::vector<conformance::MissedEvent>& missed) {
    for (const conformance::MissedEvent& missed_event : missed) {
        out += fmt::format("               event {} can be missed for ", missed_event.event);
        if (missed_event.reasons.size() > 1) out += fmt::format("{} in a row, ", in_cycles(missed_event.cycles));
        std::vector<std::string> reasons;
        for (const conformance::MissedEvent::Reason& reason : missed_event.reasons)
            reasons.push_back(reason_text(reason));
        out += fmt::format("{} [{}]\n", fmt::join(reasons, ", "), conformance::rules::event_missed.code);
    }
}

void write_overtaken(std::string& out, const std::vector<conformance::OvertakenEvent>& overtaken) {
    for (const conformance::OvertakenEvent& found : overtaken) {
        std::vector<std::string> first = found.by;
        if (found.due) first.emplace_back("what is due without an event");
        out += fmt::format("               event {} comes second in a cycle: after {}, in {} [{}]\n", found.event,
                           fmt::join(first, ", "), first_of(found.places), conformance::rules::event_overtaken.code);
    }
}

/// Writes one answer to a claim about cycles, either for the model in cycles or for this code.
void write_cycle_answer(std::string& out, const conformance::CycleAnswers& claim, std::string_view subject,
                        const conformance::CycleAnswer& answer) {
    std::string_view verdict = "not decided";
    if (answer.outcome == conformance::Outcome::conforms) verdict = "holds";
    if (answer.outcome == conformance::Outcome::differs) verdict = "FAILS";
    out += fmt::format("               {:<11}  {} [{}]: {}\n", verdict, claim.claim, subject, claim.wording);
    if (!answer.reason.empty()) out += fmt::format("                            {}\n", answer.reason);
    write_cycles(out, answer.cycles);
}

void write_cycle_claims(std::string& out, const conformance::Result& r) {
    for (const conformance::CycleAnswers& claim : r.claims) {
        write_cycle_answer(out, claim, model_in_cycles, claim.model);
        write_cycle_answer(out, claim, this_code, claim.code);
        if (claim.in_carriers) out += "                            for the values of the carriers only\n";
        if (!claim.asked) out += "                            never asked: no cycle of the code is in its scope\n";
    }
}

/// Writes further properties of the model, which do not affect the verdict.
void write_asides(std::string& out, const conformance::Result& r) {
    if (r.register_cycles) {
        const conformance::Aside& once = *r.register_cycles;
        out += fmt::format("               runs in register cycles: {}{}\n",
                           once.holds ? "yes" : fmt::format("no, {}", once.reason), code_of(once.rule));
        write_cycles(out, once.cycles);
        write_meaning(out, once);
    }
    if (!r.register_cycles && r.outcome == conformance::Outcome::conforms)
        out += "               runs in register cycles: not decided\n";
    write_missed(out, r.missed);
    write_overtaken(out, r.overtaken);
    if (!r.deadlines || r.deadlines->holds) return;
    out +=
        fmt::format("               may miss a deadline: yes, {}{}\n", r.deadlines->reason, code_of(r.deadlines->rule));
    write_cycles(out, r.deadlines->cycles);
    write_meaning(out, *r.deadlines);
}

void write_behaviour(std::string& out, std::string_view name, const conformance::Behaviour& behaviour) {
    out += fmt::format("                   {:<8} out <{}>  {}  {}\n", name, fmt::join(behaviour.outputs, ", "),
                       behaviour.ends, behaviour.state);
}

void write_api_difference(std::string& out, const conformance::Result& r) {
    if (!r.api_difference) return;
    out += fmt::format("                 then {}:\n",
                       r.api_difference->event.empty() ? "without an event" : r.api_difference->event);
    write_behaviour(out, "step", r.api_difference->cycle);
    write_behaviour(out, "dispatch", r.api_difference->dispatched);
}

/// Describes replaced data: "scan, ranges: 15 classes by 3 conditions (all values)".
std::string data_text(const ir::ReplacedData& data) {
    const std::string names = fmt::format("{}", fmt::join(data.places, ", "));
    if (!data.all_values) return fmt::format("{}: {} (all that occur)", names, count_text(data.classes, "value"));
    if (data.nothing_tested) return fmt::format("{}: any value (nothing depends on it)", names);
    std::string conditions = count_text(data.conditions, "condition");
    if (!data.term.empty()) conditions += " on " + data.term;
    return fmt::format("{}: {} {} by {} (all values)", names, data.classes, data.classes == 1 ? "class" : "classes",
                       conditions);
}

/// Writes the result of the test with the number types of the robot. A difference in this test is a separate outcome of
/// the conformance check, unless the options allow it.
void write_robot(std::string& out, const conformance::Result& r) {
    const conformance::RobotNumbers& robot = *r.robot;
    std::string answer = "the code acts as the model does";
    if (!robot.limit.empty()) answer = "no difference was found, but not all cycles were run: " + robot.limit;
    if (!robot.difference.empty()) answer = "rounding makes a difference: " + robot.difference;
    if (r.outcome == conformance::Outcome::conforms && robot.numbers > 0)
        out += fmt::format("               numbers on the robot: with {} in {}, {}\n",
                           count_text(robot.numbers, "value"), count_text(robot.regions, "region"), answer);
    for (const conformance::RobotNumbers::Special& special : robot.special) {
        std::string_view effect = "an effect that no number of the model has";
        if (special.limit) effect = "another effect than in the model, because it is a limit of its type";
        for (const std::string& input : special.unlike)
            out += fmt::format("               {} = {} has {}\n", input, special.value, effect);
    }
}

/// Returns lines that state for which values the result holds; "" if no search for all values was possible.
std::string conformance_values(const conformance::Result& r) {
    std::string out;
    for (const ir::ReplacedData& data : r.all_values) out += fmt::format("               values {}\n", data_text(data));
    if (r.robot) write_robot(out, r);
    if (r.not_for_all.empty()) return out;
    const bool conforms = r.outcome == conformance::Outcome::conforms;
    std::string_view what = "not decided for all values";
    if (conforms) what = "for the values of the carriers only";
    return out + fmt::format("               {}: {}\n", what, r.not_for_all);
}

/// Returns the text after the verdict about a component's code.
std::string conformance_rest(const ConformanceReport& c, const Options& options) {
    const conformance::Result& r = c.result;
    std::string out =
        fmt::format("{}: {} states, {} cycles of the code explored; {} states, {} transitions checked; {}\n",
                    c.component, with_commas(r.code_states), with_commas(r.code_cycles), with_commas(r.product.states),
                    with_commas(r.product.transitions), duration_text(c.seconds));
    if (r.dispatched > 0)
        out += fmt::format("               events dispatched one at a time: {} compared with a cycle\n",
                           with_commas(r.dispatched));
    if (!c.order.empty()) out += fmt::format("               order of events in a cycle: {}\n", c.order);
    out += conformance_values(r);
    const bool for_all = r.outcome == conformance::Outcome::conforms;
    for (const conformance::FewValues& represented : r.represented)
        out +=
            fmt::format("               values {}: {}{} explored\n", represented.type,
                        for_all ? "any value (nothing depends on it), " : "", count_text(represented.values, "value"));
    if (!r.reason.empty()) out += fmt::format("               {}{}\n", r.reason, code_of(r.explanation.rule));
    for (const std::string& warning : r.warnings) out += fmt::format("               warning: {}\n", warning);
    if (c.certificate) out += fmt::format("               {}\n", driver::certificate_text(*c.certificate, "conforms"));
    if (const std::string trusted = still_trusted(c); !trusted.empty())
        out += fmt::format("               {}\n", trusted);
    write_cycles(out, r.cycles);
    write_explanation(out, r.explanation);
    if (!r.expected.empty()) out += fmt::format("                 the model: {}\n", r.expected);
    write_api_difference(out, r);
    write_cycle_claims(out, r);
    write_asides(out, r);
    if (options.output.show_internal && !r.raw.empty())
        out += fmt::format("                 events <{}>\n", fmt::join(r.raw, ", "));
    return out;
}

std::string conformance_block(const ConformanceReport& c, const Options& options, bool color) {
    return padded_verdict(outcome_word(c.result.outcome), paint_of(c.result.outcome), color) +
           diagnostics::shown_lines(conformance_rest(c, options));
}

void write_files(std::string& out, std::string_view title, const std::vector<FileReport>& files) {
    if (files.empty()) return;
    out += fmt::format("\n{}\n", title);
    for (const FileReport& file : files)
        out +=
            fmt::format("  {:<70} {:>9} bytes\n", diagnostics::escape_for_display(file.path), with_commas(file.bytes));
}

std::string size_text(const driver::SizeReport::Size& size) {
    if (!size.whole) return fmt::format("{:>10} states and more      ", with_commas(size.states));
    return fmt::format("{:>10} states {:>11} transitions", with_commas(size.states), with_commas(size.transitions));
}

void write_sizes(std::string& out, const std::vector<driver::SizeReport>& sizes) {
    if (sizes.empty()) return;
    out += "\nsizes of the components, as they are and compressed\n";
    for (const driver::SizeReport& size : sizes)
        out += fmt::format("  {:<7} {:<45} {} {}\n", size.time, size.component, size_text(size.process),
                           size_text(size.compressed));
}

/// The number of claims about cycles, and how many of them hold.
struct CycleCounts {
    std::size_t good = 0, all = 0;
};

CycleCounts count_cycle_claims(const Report& report) {
    CycleCounts result;
    for (const ConformanceReport& c : report.conformance)
        for (const conformance::CycleAnswers& claim : c.result.claims) {
            ++result.all;
            if (claim.holds()) ++result.good;
        }
    return result;
}

std::string closing_line(const Report& report) {
    const auto count = [&](driver::Answer answer) { return report.count_answers(answer); };
    std::vector<std::string> parts;
    if (!report.assertions.empty()) {
        const auto decisive = std::ranges::count_if(report.assertions, [](const auto& a) {
            return a.answer != driver::Answer::no_check && a.answer != driver::Answer::computed &&
                   !(a.core && a.core->information);
        });
        if (decisive > 0 || count(driver::Answer::computed) == 0)
            parts.push_back(fmt::format("{} of {} checks hold", count(driver::Answer::holds), decisive));
        if (count(driver::Answer::computed) > 0)
            parts.push_back(fmt::format("{} value{} computed", count(driver::Answer::computed),
                                        count(driver::Answer::computed) == 1 ? "" : "s"));
        if (count(driver::Answer::fails) > 0) parts.push_back(fmt::format("{} fail", count(driver::Answer::fails)));
        if (count(driver::Answer::inconclusive) > 0)
            parts.push_back(fmt::format("{} inconclusive", count(driver::Answer::inconclusive)));
        if (count(driver::Answer::error) > 0)
            parts.push_back(fmt::format("{} cannot be evaluated", count(driver::Answer::error)));
        if (count(driver::Answer::unchecked) > 0)
            parts.push_back(fmt::format("{} not checked", count(driver::Answer::unchecked)));
        if (count(driver::Answer::no_check) > 0)
            parts.push_back(fmt::format("{} without a check", count(driver::Answer::no_check)));
    }
    if (!report.conformance.empty()) {
        const auto good = std::ranges::count_if(
            report.conformance, [](const auto& c) { return c.result.outcome == conformance::Outcome::conforms; });
        parts.push_back(fmt::format("{} of {} controllers conform", good, report.conformance.size()));
        if (const CycleCounts claims = count_cycle_claims(report); claims.all > 0)
            parts.push_back(fmt::format("{} of {} about cycles hold", claims.good, count_text(claims.all, "claim")));
    }
    if (!report.refused.empty()) {
        std::vector<std::string> names;
        for (const RefusedReport& refused : report.refused)
            if (std::string name = diagnostics::escape_for_display(refused.model);
                std::ranges::find(names, name) == names.end())
                names.push_back(std::move(name));
        parts.push_back(fmt::format("refused, with errors: {}", fmt::join(names, ", ")));
    }
    if (!report.unclaimed.empty()) parts.push_back(report.unclaimed);
    if (!report.limit.empty())
        parts.push_back((report.limit.starts_with("the run was interrupted") ? "" : "inconclusive: ") + report.limit);
    return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string still_trusted(const ConformanceReport& c) {
    if (!c.certificate || c.certificate->folders.empty()) return "";
    const bool few = !c.result.all_values.empty() || !c.result.represented.empty();
    return fmt::format(
        "still trusted: that the code does what the table of the certificate states, which robochart-replay checks, "
        "that the specification in the certificate is the model in cycles{}, and the certifier",
        few ? ", that the check is right about values outside the table" : "");
}

std::string_view name_of(conformance::Outcome outcome) {
    constexpr std::array<std::string_view, 7> names{"conforms",      "differs", "rounds",      "not schedulable",
                                                    "not generated", "error",   "inconclusive"};
    return names[static_cast<std::size_t>(outcome)];
}

std::string_view proof_name(refine::DecidedBy decided_by) {
    switch (decided_by) {
        case refine::DecidedBy::search:
            return "search";
        case refine::DecidedBy::tau_acyclic:
            return "no tau cycle";
        case refine::DecidedBy::choice_free:
            return "no choice";
        case refine::DecidedBy::compressed_parts:
            return "compressed parts";
        case refine::DecidedBy::diagrams:
            return "decision diagrams";
    }
    return "";
}

std::string diagrams_text(const refine::Statistics& size) {
    constexpr double exact = 15;  // decimal digits of a number that a double represents exactly
    const double digits = size.log10_states;
    std::string states = fmt::format("{}", std::llround(std::pow(10.0, digits)));
    if (digits >= exact)
        states = fmt::format("{:.2f}e{}", std::pow(10.0, digits - std::floor(digits)), std::floor(digits));
    return fmt::format("decision diagrams: {} states in {} nodes", states, size.diagram_nodes);
}

std::string_view proof_reason(refine::DecidedBy decided_by) {
    switch (decided_by) {
        case refine::DecidedBy::search:
            return "";
        case refine::DecidedBy::tau_acyclic:
            return "no search was necessary: no cycle of hidden events is possible";
        case refine::DecidedBy::choice_free:
            return "no search was necessary: no event is hidden, and each event has only one way to happen";
        case refine::DecidedBy::compressed_parts:
            return "the parts of the process were compressed before the search";
        case refine::DecidedBy::diagrams:
            return "";
    }
    return "";
}

const std::string_view indent_of_runs = "                 ";

std::size_t Report::count_answers(driver::Answer answer) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        assertions, [&](const auto& a) { return a.answer == answer && !(a.core && a.core->information); }));
}

bool Report::all_decided() const {
    return limit.empty() && refused.empty() && !nothing_checked &&
           std::ranges::none_of(assertions, [](const driver::AssertionReport& assertion) {
               return assertion.answer == driver::Answer::inconclusive || assertion.answer == driver::Answer::error;
           });
}

std::string Report::limit_advice() const {
    const auto met = [&](std::string_view words) {
        return limit.find(words) != std::string::npos ||
               std::ranges::any_of(assertions, [&](const driver::AssertionReport& assertion) {
                   return assertion.answer == driver::Answer::inconclusive &&
                          assertion.reason.find(words) != std::string::npos;
               });
    };
    std::vector<std::string> helps;
    if (met("memory limit") || met("no more memory"))
        helps.emplace_back("--disk DIR keeps states that memory does not hold");
    if (met("--assertion-timeout"))
        helps.emplace_back("--assertion-timeout gives each assertion more time, --threads uses more cores");
    else if (met("time limit"))
        helps.emplace_back("--timeout gives more time, --threads uses more cores");
    if (met(" states was reached")) helps.emplace_back("--max-states allows more");
    if (helps.empty()) return "";
    if (subject == "model") helps.emplace_back("a smaller --range makes fewer states");
    return fmt::format("what may help: {}", fmt::join(helps, "; "));
}

Exit Report::exit_code() const {
    const auto any = [&](driver::Answer answer) { return count_answers(answer) > 0; };
    const auto code = [&](conformance::Outcome outcome) {
        return std::ranges::any_of(conformance, [&](const auto& c) { return c.result.outcome == outcome; });
    };
    const auto claim = [&](conformance::Outcome outcome) {
        return std::ranges::any_of(conformance, [&](const auto& c) {
            return std::ranges::any_of(c.result.claims, [&](const conformance::CycleAnswers& answers) {
                return answers.code.outcome == outcome;
            });
        });
    };
    const auto unwritten_in = [](const auto& reports) {
        return std::ranges::any_of(reports, [](const auto& one) { return one.certificate && one.certificate->failed; });
    };
    const bool unwritten = unwritten_in(assertions) || unwritten_in(conformance);
    if (nothing_checked || !refused.empty() || unwritten || any(driver::Answer::error) ||
        code(conformance::Outcome::not_generated) || code(conformance::Outcome::error))
        return Exit::bad_input;
    if (any(driver::Answer::fails) || code(conformance::Outcome::differs) || code(conformance::Outcome::rounds) ||
        code(conformance::Outcome::not_schedulable) || claim(conformance::Outcome::differs))
        return Exit::failed;
    if (!limit.empty() || any(driver::Answer::inconclusive) || any(driver::Answer::unchecked) ||
        code(conformance::Outcome::inconclusive) || claim(conformance::Outcome::inconclusive))
        return Exit::inconclusive;
    return Exit::success;
}

namespace {

std::string heading_text(const Report& report) {
    std::string out = report.summary.empty()
                          ? diagnostics::escape_for_display(report.model) + "\n"
                          : fmt::format("{}: {} ({})\n", diagnostics::escape_for_display(report.model), report.summary,
                                        duration_text(report.load_seconds));
    for (const std::string& note : report.notes) out += fmt::format("  {}\n", note);
    return out;
}

using Listed = std::vector<const driver::AssertionReport*>;

/// The assertions whose runs several components share.
using SharedRuns = std::map<const driver::AssertionReport*, SharedRun>;

/// Finds equal runs of core properties. A module, its controller and its machine often fail a property with the same
/// run, which is printed only once.
SharedRuns shared_runs(const Report& report, const Options& options) {
    // Maps each property and run to the assertion that prints the run.
    std::map<std::pair<std::string, std::string>, const driver::AssertionReport*> first;
    SharedRuns result;
    for (const driver::AssertionReport& a : report.assertions) {
        if (!a.core || a.core->information || (!a.run && a.counterexample.empty())) continue;
        const auto [known, added] = first.try_emplace({a.core->property, run_lines(a, options)}, &a);
        if (added) continue;
        result[&a].shown_at = known->second->core->component;
        result[known->second].others.push_back(a.core->component);
    }
    return result;
}

/// Returns the blocks of all assertions. The title column is as wide as the widest title, up to 80 characters.
std::string blocks_text(const Listed& listed, const std::string& subject, const Options& options, bool color,
                        const SharedRuns& shared) {
    std::size_t width = 0;
    for (const driver::AssertionReport* a : listed)
        width = std::max(width, std::min<std::size_t>((a->core ? a->core->property : a->title).size(), 80));
    std::string out;
    for (const driver::AssertionReport* a : listed)
        // Values and the basis of an answer are parts of the answer, so they are printed even with --quiet.
        if (!options.output.quiet || a->answer != driver::Answer::holds || !a->basis.empty()) {
            const auto elsewhere = shared.find(a);
            out += assertion_block(*a, subject, width, options, color,
                                   elsewhere == shared.end() ? SharedRun{} : elsewhere->second);
        }
    return out;
}

std::string assertions_text(const Report& report, const Options& options, bool color) {
    Listed listed;
    for (const driver::AssertionReport& a : report.assertions)
        if (!a.core) listed.push_back(&a);
    const std::string heading = listed.empty() || options.output.quiet ? "" : "\nassertions\n";
    return heading + blocks_text(listed, report.subject, options, color, {});
}

/// Adds to the words of a negative answer that it is limited to the values of the carriers, if a bound was reached.
std::string limited(const driver::AssertionReport& a, const std::string& words) {
    const bool bounded = std::ranges::find(a.basis, driver::GroundKind::bound, &driver::Ground::kind) != a.basis.end();
    return bounded ? words + " with the values of the carriers" : words;
}

/// Summarises the informative properties of a component in one sentence. Unreachable states are listed with their
/// places.
std::string information_text(const Listed& information) {
    std::vector<std::string> words;
    std::size_t reached = 0;
    for (const driver::AssertionReport* a : information) {
        const std::string& property = a->core->property;
        const bool state = property.ends_with(" is reachable");
        const std::string place = a->place.empty() ? "" : fmt::format(" ({})", a->place);
        if (a->answer == driver::Answer::holds && state)
            ++reached;
        else if (a->answer == driver::Answer::holds)
            words.push_back(property);
        else if (property == "every transition fires" && a->answer == driver::Answer::fails)
            words.push_back(limited(*a, a->reason));
        else if (a->answer != driver::Answer::fails)
            words.push_back(fmt::format("{}: not known", property));
        else if (state)
            words.push_back(
                limited(*a, fmt::format("{} is never reached{}", property.substr(0, property.find(" is")), place)));
        else
            words.push_back(property == "never terminates" ? "may terminate" : "not " + property);
    }
    if (reached > 0) words.push_back(fmt::format("{} state{} reached", reached, reached == 1 ? " is" : "s are"));
    return words.empty() ? "" : fmt::format("  {:<12} {}\n", "information", fmt::join(words, "; "));
}

/// Returns the text about the core properties, by component.
std::string core_text(const Report& report, const Options& options, bool color) {
    std::vector<std::string> components;
    std::map<std::string, std::pair<Listed, Listed>> parts;  // required properties, and informative ones
    for (const driver::AssertionReport& a : report.assertions) {
        if (!a.core) continue;
        const auto [part, added] = parts.try_emplace(a.core->component);
        if (added) components.push_back(a.core->component);
        (a.core->information ? part->second.second : part->second.first).push_back(&a);
    }
    const SharedRuns shared = shared_runs(report, options);
    std::string out;
    for (const std::string& component : components) {
        const std::string required = blocks_text(parts[component].first, report.subject, options, color, shared);
        if (!required.empty() || !options.output.quiet)
            out += fmt::format("  {}\n{}", diagnostics::escape_for_display(component), required);
        if (!options.output.quiet) out += diagnostics::shown_lines(information_text(parts[component].second));
    }
    if (out.empty()) return out;
    return "\ncore properties, where the platform takes every call and output at once\n" + out;
}

/// True if a verdict depends on the carriers, or may be missing because of them. It may be missing because a carrier is
/// too large, or because a value is outside its carrier.
bool depends_on_carriers(const Report& report) {
    const auto limits = [](const driver::Ground& ground) {
        return ground.kind == driver::GroundKind::bound || ground.kind == driver::GroundKind::carriers;
    };
    return std::ranges::any_of(report.assertions, [&](const driver::AssertionReport& assertion) {
        return assertion.answer == driver::Answer::inconclusive || std::ranges::any_of(assertion.basis, limits);
    });
}

/// Lists the data that classes replace in the claims above. If a verdict depends on carriers, also lists the data that
/// keep their carriers.
std::string data_lines(const Report& report) {
    std::string out;
    for (const ir::ReplacedData& data : report.data) out += fmt::format("  values       {}\n", data_text(data));
    if (!depends_on_carriers(report)) return out;
    for (const driver::KeptDataReport& data : report.kept_data) {
        out += fmt::format("  carrier      {}: {}", fmt::join(data.places, ", "), data.reason);
        out += data.place.empty() ? "\n" : fmt::format(" ({})\n", diagnostics::escape_for_display(data.place));
    }
    return out;
}

/// Explains the word `known`, which may replace a number of seconds; "" if the report does not contain it.
std::string legend_text(const Report& report, const Options& options) {
    const auto shown = [&](const driver::AssertionReport& a) {
        return !(a.core && a.core->information) &&
               (!options.output.quiet || a.answer != driver::Answer::holds || !a.basis.empty());
    };
    const bool known = std::ranges::any_of(report.assertions,
                                           [&](const auto& a) { return shown(a) && has_statistics(a) && !a.searched; });
    return known ? "\nknown: an earlier run has decided it; --no-cache decides it again\n" : "";
}

std::string files_text(const Report& report) {
    std::string out;
    write_files(out, "CSP semantics", report.csp_files);
    write_files(out, "C++", report.cpp_files);
    write_files(out, "PRISM", report.prism_files);
    write_files(out, "monitors", report.monitor_files);
    write_files(out, "tests", report.test_files);
    write_files(out, "RoboSim", report.rst_files);
    for (const std::string& remark : report.remarks) out += fmt::format("  {}\n", remark);
    return out;
}

}  // namespace

std::string render_text(const Report& report, const Options& options) {
    using diagnostics::shown_lines;
    const bool color = color_wanted(options.output.color, STDOUT_FILENO);
    std::string out = options.output.quiet ? "" : shown_lines(heading_text(report));
    out += assertions_text(report, options, color) + core_text(report, options, color) + legend_text(report, options);
    if (!options.output.quiet) out += shown_lines(data_lines(report));
    std::string found;
    write_sizes(found, report.sizes);
    out += shown_lines(found);
    if (!report.conformance.empty() && !options.output.quiet) out += "\nconformance of the generated C++\n";
    for (const ConformanceReport& c : report.conformance)
        if (!options.output.quiet || c.result.outcome != conformance::Outcome::conforms ||
            !std::ranges::all_of(c.result.claims, &conformance::CycleAnswers::holds))
            out += conformance_block(c, options, color);
    if (!options.output.quiet) out += shown_lines(files_text(report));
    if (const std::string advice = report.limit_advice(); !advice.empty())
        out += fmt::format("{}{}\n", options.output.quiet ? "" : "\n", advice);
    if (const std::string last = closing_line(report); !last.empty())
        out += shown_lines(fmt::format("{}{}\n", options.output.quiet ? "" : "\n", last));
    return out;
}

std::string assertion_text(const driver::AssertionReport& assertion, const std::string& subject) {
    return assertion_block(assertion, subject, 0, {}, false);
}

std::string cycle_answer_text(const conformance::CycleAnswers& claim, std::string_view subject,
                              const conformance::CycleAnswer& answer) {
    std::string text;
    write_cycle_answer(text, claim, subject, answer);
    return text;
}

std::string conformance_text(const ConformanceReport& component) {
    return conformance_block(component, {}, false);
}

}  // namespace robochart::app
