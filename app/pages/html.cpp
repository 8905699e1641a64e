// SPDX-License-Identifier: Apache-2.0
// See html.hpp. Foreign text is escaped when it is inserted into the page; ids are numbers from counters.
#include "app/pages/html.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "app/pages/page.hpp"
#include "app/pages/part_diagrams.hpp"
#include "app/report/probability_report.hpp"
#include "app/report/value_plot.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/json.hpp"
#include "counterexample/cycles.hpp"
#include "counterexample/text.hpp"
#include "driver/claims/certificates.hpp"

namespace robochart::app {
namespace {

using diagnostics::xml_text;

/// The maximal number of steps shown for one run. Of a longer run, only the first and the last steps are shown.
constexpr std::size_t most_steps = 2000;

const char* answer_class(driver::Answer answer) {
    if (answer == driver::Answer::holds || answer == driver::Answer::computed) return "holds";
    return answer == driver::Answer::fails ? "fails" : "other";
}

std::string title_of(const driver::AssertionReport& assertion) {
    return assertion.core ? assertion.core->component + ": " + assertion.core->property : assertion.title;
}

/// Returns a block of text. Lines that are wider than the page can be scrolled, also by keyboard.
std::string preformatted_block(const std::string& text) {
    return fmt::format("<pre tabindex=\"0\">{}</pre>", diagnostics::xml_lines(text));
}

/// Returns the file's name, with its full path as a tooltip.
std::string place_text(const std::string& place) {
    return fmt::format("<span class=\"place\" title=\"{}\">{}</span>", xml_text(place),
                       xml_text(place.substr(place.rfind('/') + 1)));
}

std::string place_text(const runs::Place& place) {
    return place_text(fmt::format("{}:{}", place.file, place.line));
}

/// Returns the basis of a verdict as a list; "" if it is empty.
std::string basis_list(const driver::Basis& basis) {
    std::string items;
    std::set<std::string> remedies;
    for (const driver::Ground& ground : basis) {
        items += fmt::format("<li>{}{}</li>", xml_text(ground.text),
                             ground.place.empty() ? "" : " " + place_text(ground.place));
        if (!ground.remedy.empty()) remedies.insert(ground.remedy);
    }
    for (const std::string& remedy : remedies) items += fmt::format("<li>{}</li>", xml_text(remedy));
    return items.empty() ? "" : fmt::format("<div class=\"basis\">rests on:<ul>{}</ul></div>", items);
}

/// Returns the values of a probabilistic assertion as a table with one row for each combination of the varying
/// constants, and a plot. `title` is the title of the assertion.
std::string values_table(const std::string& title, const driver::ProbabilityReport& report) {
    if (report.rows.empty()) return "";
    std::string head;
    for (const auto& [name, value] : varying_constants(report, report.rows.front()))
        head += fmt::format("<th scope=\"col\">{}</th>", xml_text(name));
    std::string body;
    for (const probability::Row& row : report.rows) {
        body += "<tr>";
        for (const auto& [name, value] : varying_constants(report, row))
            body += fmt::format("<td class=\"number\">{}</td>", xml_text(value));
        const std::string path = path_text(row, "");
        body += fmt::format("<td>{}{}</td></tr>", xml_text(row_text(row)),
                            path.empty() ? "" : fmt::format("<pre>{}</pre>", xml_text(path)));
    }
    return fmt::format("<br>{}<table><thead><tr>{}<th scope=\"col\">value</th></tr></thead><tbody>{}</tbody></table>{}",
                       xml_text(reading_of(report)), head, body, value_plot(title, report));
}

/// Elements of diagrams, each given by the number of its machine and its id in the machine's diagram.
using Marks = std::vector<std::pair<std::size_t, std::string>>;

/// Returns the marks as text: "0:e5 1:e9".
std::string text_of(const Marks& marks) {
    std::vector<std::string> texts;
    for (const auto& [machine, element] : marks) texts.push_back(fmt::format("{}:{}", machine, element));
    return fmt::format("{}", fmt::join(texts, " "));
}

/// Returns the input as given on the command line; for `.` and `..` the name of the folder.
std::string name_of(const Report& report, const std::vector<driver::Part>& parts) {
    const bool says_nothing = report.model.find_first_not_of("./ ") == std::string::npos;
    return says_nothing && !parts.empty() ? parts.front().project->name : report.model;
}

/// Writes one page.
class ReportPage {
public:
    ReportPage(const Report& report, const std::vector<driver::Part>& parts, const RunRecord& run,
               diagnostics::Budget& budget)
        : report_(report), run_(run), name_(name_of(report, parts)), diagrams_(parts, budget) {}

    std::string write() {
        write_head();
        write_errors();
        write_verdicts();
        for (std::size_t i = 0; i < report_.assertions.size(); ++i)
            if (report_.assertions[i].run) write_claim(i, report_.assertions[i]);
        write_conformance();
        write_diagrams();
        return page_text({name_, "script.js", std::move(out_), run_});
    }

private:
    void write_head();
    void write_errors();
    void write_verdicts();
    void write_verdict(std::size_t number, const driver::AssertionReport& assertion);
    void write_claim(std::size_t number, const driver::AssertionReport& assertion);
    void model_runs(std::size_t number, const ConformanceReport& report);
    void model_run(const std::string& id, const std::string& title, const std::string& more, const runs::Run& run);
    void write_replay(const std::string& id, const runs::Run& run);
    void write_steps(const std::string& id, const runs::Run& run);
    void write_row(std::size_t number, const runs::Step* step, const std::vector<runs::Machine>& before,
                   const std::vector<runs::Machine>& after);
    void write_scope_legend(const runs::Run& run);
    void write_cycles(const runs::Run& run);
    [[nodiscard]] std::vector<std::set<std::string>> marked_elements(const runs::Run& run) const;
    void write_figures(const std::string& id, const runs::Run& run);
    void write_figure(const std::string& attributes, const std::string& caption, const std::string& svg);
    void write_conformance();
    void write_diagrams();
    [[nodiscard]] std::set<std::string> unexercised_elements() const;
    [[nodiscard]] Marks active_marks(const std::vector<runs::Machine>& machines) const;
    [[nodiscard]] Marks fired_marks(const runs::Step& step) const;
    [[nodiscard]] std::string lane_name(const std::string& component) const;
    [[nodiscard]] std::string values_json(const std::vector<runs::Machine>& before,
                                          const std::vector<runs::Machine>& after) const;

    const Report& report_;
    const RunRecord& run_;
    std::string name_;  ///< name of the page's subject
    PartDiagrams diagrams_;
    std::vector<std::pair<std::string, std::string>> machines_;  ///< instances and definitions of the current run
    durations::Unit unit_;                                       ///< time unit of the current run
    bool timed_ = false;                                         ///< true if the current run is timed
    std::string out_;
};

void ReportPage::write_head() {
    out_ += fmt::format("<h1>{}</h1>\n<p>{}", xml_text(name_), xml_text(report_.summary));
    for (const std::string& note : report_.notes) out_ += fmt::format("<br>{}", xml_text(note));
    std::vector<std::string> counts;
    if (!report_.assertions.empty())
        counts.push_back(fmt::format("{} hold, {} fail", report_.count_answers(driver::Answer::holds),
                                     report_.count_answers(driver::Answer::fails)));
    if (const auto& code = report_.conformance; !code.empty())
        counts.push_back(fmt::format("{} of {} components conform",
                                     std::ranges::count_if(code,
                                                           [](const ConformanceReport& component_report) {
                                                               return component_report.result.outcome ==
                                                                      conformance::Outcome::conforms;
                                                           }),
                                     code.size()));
    if (!report_.refused.empty()) counts.emplace_back("refused, with errors");
    if (!report_.limit.empty())
        counts.push_back(fmt::format("ended early: {}{}", xml_text(report_.limit),
                                     diagrams_.subjects().empty() ? "; the diagrams are left out" : ""));
    if (const std::string advice = report_.limit_advice(); !advice.empty()) counts.push_back(xml_text(advice));
    out_ += fmt::format("</p>\n<p>robochart-verify {}: {}</p>\n", program_version, fmt::join(counts, "; "));
}

/// Writes the errors of rejected models, as they are printed.
void ReportPage::write_errors() {
    if (report_.refused.empty()) return;
    out_ += "<section id=\"errors\">\n<h2>Errors</h2>\n";
    for (const RefusedReport& refused : report_.refused)
        out_ += fmt::format("<h3>{}</h3>\n{}\n", xml_text(refused.model), preformatted_block(refused.text));
    out_ += "</section>\n";
}

void ReportPage::write_verdicts() {
    if (report_.assertions.empty()) return;
    out_ +=
        "<section id=\"verdicts\">\n<h2>Verdicts</h2>\n"
        "<p class=\"controls\"><label><input type=\"checkbox\" id=\"only\"> only what does not hold</label></p>\n"
        "<table class=\"sortable\"><thead><tr><th scope=\"col\">answer</th><th scope=\"col\">claim</th><th "
        "scope=\"col\">place</th>"
        "<th scope=\"col\">states</th></tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < report_.assertions.size(); ++i) write_verdict(i, report_.assertions[i]);
    out_ += "</tbody></table>\n";
    out_ += "</section>\n";
}

void ReportPage::write_verdict(std::size_t number, const driver::AssertionReport& assertion) {
    std::string shown = xml_text(title_of(assertion));
    if (assertion.run) shown = fmt::format("<a href=\"#a{}\">{}</a>", number, shown);
    if (!assertion.reason.empty()) shown += fmt::format("<br>{}", xml_text(assertion.reason));
    if (const std::string_view reason = proof_reason(assertion.statistics.decided_by); !reason.empty())
        shown += fmt::format("<br>{}", xml_text(std::string(reason)));
    if (assertion.statistics.decided_by == refine::DecidedBy::diagrams)
        shown += fmt::format("<br>decided by {}", xml_text(diagrams_text(assertion.statistics)));
    shown += basis_list(assertion.basis);
    if (assertion.certificate)
        shown += fmt::format("<br>{}", xml_text(driver::certificate_text(*assertion.certificate)));
    if (assertion.probability) shown += values_table(title_of(assertion), *assertion.probability);
    const bool information = assertion.core && assertion.core->information;
    const bool holds = assertion.answer == driver::Answer::holds;
    const bool good = holds || assertion.answer == driver::Answer::computed || information;
    std::string_view word = answer_word(assertion.answer);
    if (information) word = holds ? "yes" : "no";
    out_ += fmt::format(
        "<tr class=\"{}\"><td class=\"answer {}\">{}</td><td>{}</td><td>{}</td><td class=\"number\">{}</td></tr>\n",
        good ? "good" : "bad", information ? "" : answer_class(assertion.answer), word, shown,
        place_text(assertion.place), assertion.statistics.states);
}

/// Returns the elements of the active states of each machine in the current run.
Marks ReportPage::active_marks(const std::vector<runs::Machine>& machines) const {
    Marks marks;
    for (const runs::Machine& machine : machines)
        for (std::size_t i = 0; i < machines_.size(); ++i)
            for (const std::string& state : machine.active)
                if (const std::string id = diagrams_.id_of_name(state);
                    machines_[i].first == machine.component && !id.empty())
                    marks.emplace_back(i, id);
    return marks;
}

/// Returns the elements that perform the step, in all machines that take part.
Marks ReportPage::fired_marks(const runs::Step& step) const {
    Marks marks;
    const auto add = [&](const runs::Event& event) {
        const std::string id = diagrams_.id_of_event(event);
        for (std::size_t i = 0; i < machines_.size(); ++i)
            if (!id.empty() && machines_[i].first == event.component) marks.emplace_back(i, id);
    };
    add(step.event);
    for (const runs::Event& event : step.with) add(event);
    return marks;
}

/// Returns "x = 2"; "" if the text of the event already contains the change.
std::string change_text(const runs::Step& step, const runs::Change& change) {
    std::string text = fmt::format("{} = {}", change.name, change.after);
    return step.event.text.ends_with(text) ? "" : text;
}

std::string step_with_changes(const runs::Step& step) {
    std::string text = runs::text_of(step.event, step.with);
    for (const runs::Change& change : step.changes)
        if (const std::string news = change_text(step, change); !news.empty()) text += "; " + news;
    return text;
}

/// Returns the alternatives to a step, preceded by their number.
std::string also_possible(const runs::Step& step) {
    if (step.offered.empty()) return "";
    std::vector<std::string> offered;
    for (const runs::Event& event : step.offered) offered.push_back(xml_text(event.text));
    if (step.more_offered > 0) offered.push_back(fmt::format("and {} more", step.more_offered));
    return fmt::format("<details><summary>{}</summary>{}</details>", step.offered.size() + step.more_offered,
                       fmt::join(offered, "<br>"));
}

/// Returns "<dt>the specification allows</dt><dd>…</dd>"; "" if there are no events.
std::string end_entry(const char* title, const std::vector<runs::Event>& events) {
    std::vector<std::string> texts;
    for (const runs::Event& event : events) texts.push_back(xml_text(event.text));
    return texts.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>\n", title, fmt::join(texts, "<br>"));
}

/// Returns the events that are possible at the end of a run, and the events that the specification allows or requires
/// there.
std::string end_text(const runs::End& end) {
    std::string text = end_entry("possible", end.offered) + end_entry("the specification allows", end.allowed) +
                       end_entry("it refuses, against the specification", end.refused);
    std::size_t number = 0;
    for (const std::vector<runs::Event>& required : end.required)
        text += end_entry(++number == 1 ? "the specification requires" : "or", required);
    for (const runs::Cause& cause : end.causes)
        text += fmt::format("<dt>{}</dt><dd>{}{}</dd>\n", xml_text(cause.component), xml_text(cause.text),
                            cause.place ? " " + place_text(*cause.place) : "");
    return text.empty()
               ? ""
               : fmt::format("<details class=\"ends\"><summary>where it ends</summary><dl>\n{}</dl></details>\n", text);
}

/// Returns the action of a component in a step, and the changes of its variables.
std::string component_step_text(const runs::Step& step, const std::string& component) {
    std::vector<std::string> parts;
    if (step.event.component == component) parts.push_back(runs::text_of(step.event));
    for (const runs::Event& event : step.with)
        if (event.component == component) parts.push_back(runs::text_of(event));
    for (const runs::Change& change : step.changes)
        if (const std::string news = change_text(step, change); change.component == component && !news.empty())
            parts.push_back(news);
    return fmt::format("{}", fmt::join(parts, "; "));
}

const runs::Machine* find(const std::vector<runs::Machine>& machines, const std::string& component) {
    const auto found =
        std::ranges::find_if(machines, [&](const runs::Machine& machine) { return machine.component == component; });
    return found == machines.end() ? nullptr : &*found;
}

/// Returns the last part of the name if it is unique, otherwise all parts but the first.
std::string ReportPage::lane_name(const std::string& component) const {
    const auto last = [](const std::string& name) { return name.substr(name.rfind(':') + 1); };
    const auto alike =
        std::ranges::count_if(machines_, [&](const auto& machine) { return last(machine.first) == last(component); });
    if (alike == 1) return last(component);
    const std::size_t whole = component.find("::");
    return component.substr(whole == std::string::npos ? 0 : whole + 2);
}

/// Returns the variables of all machines in which a variable changed, by the machine's number. Each entry contains the
/// name, the value and whether the value changed.
std::string ReportPage::values_json(const std::vector<runs::Machine>& before,
                                    const std::vector<runs::Machine>& after) const {
    diagnostics::Json all = diagnostics::Json::object();
    for (std::size_t i = 0; i < machines_.size(); ++i) {
        const runs::Machine* const was = find(before, machines_[i].first);
        const runs::Machine* const is = find(after, machines_[i].first);
        if (is == nullptr || (was != nullptr && runs::values_text(*was) == runs::values_text(*is))) continue;
        diagnostics::Json list = diagnostics::Json::array();
        for (const runs::Variable& variable : is->variables) {
            if (variable.kind == runs::VariableKind::constant || !variable.value) continue;
            const bool same = was != nullptr && std::ranges::any_of(was->variables, [&](const runs::Variable& other) {
                                  return other.name == variable.name && other.value == variable.value;
                              });
            list.push_back({variable.name, *variable.value, was != nullptr && !same});
        }
        all[fmt::format("{}", i)] = std::move(list);
    }
    return diagnostics::json_text(all);
}

/// Writes the row of a step with one lane per machine: its action and, below that, its new state if it changed. `step`
/// is null for the initial state.
void ReportPage::write_row(std::size_t number, const runs::Step* step, const std::vector<runs::Machine>& before,
                           const std::vector<runs::Machine>& after) {
    const std::string what = step == nullptr ? "the beginning" : step_with_changes(*step);
    out_ += fmt::format(
        "<tr class=\"step{}{}\" data-on=\"{}\" data-fired=\"{}\" data-values=\"{}\" data-text=\"{}\"><td "
        "class=\"number\">{}</td>",
        step != nullptr && step->in_scope ? " scope" : "", step != nullptr && step->owed ? " owed" : "",
        text_of(active_marks(after)), step == nullptr ? "" : text_of(fired_marks(*step)),
        xml_text(values_json(before, after)), xml_text(what), number);
    if (timed_)
        out_ += fmt::format("<td class=\"number\">{}</td>",
                            step != nullptr && step->time ? durations::time_text(*step->time, unit_).substr(2) : "");
    bool any_done = false;
    for (const auto& [component, definition] : machines_) {
        const std::string done = step == nullptr ? "" : component_step_text(*step, component);
        const runs::Machine* const was = find(before, component);
        const runs::Machine* const is = find(after, component);
        std::string then;
        if (is != nullptr)
            then = is->text;
        else if (was != nullptr)
            then = "ended";
        const bool news = step == nullptr || was == nullptr || is == nullptr || was->text != then;
        any_done = any_done || !done.empty();
        out_ += fmt::format("<td class=\"lane\">{}{}</td>", xml_text(done),
                            news && !then.empty() ? fmt::format("<div class=\"then\">{}</div>", xml_text(then)) : "");
    }
    out_ += fmt::format("<td>{}</td>", step == nullptr || any_done ? "" : xml_text(what));
    const bool placed = step != nullptr && step->event.place;
    out_ += fmt::format("<td>{}</td><td>{}</td></tr>\n", placed ? place_text(*step->event.place) : "",
                        step == nullptr ? "" : also_possible(*step));
}

/// Returns a style with the widths of the columns. On screen, each row has its own layout with fixed columns, so that
/// browsers can skip rows outside the view.
std::string column_style(const std::string& id, std::size_t lanes, bool timed, bool seconds) {
    const int time = seconds ? 9 : 4;
    return fmt::format(
        "<style>@media screen {{ #{0} .steps tr {{ grid-template-columns: {1} repeat({2}, minmax(8em, 4fr)) "
        "minmax(7.5em, 1fr) minmax(11.5em, 1fr) minmax(4em, 1fr); }} "
        "#{0} .steps table {{ min-width: {3}em; }} }}</style>\n",
        id, timed ? fmt::format("5em {}em", time) : "5em", lanes,
        8 * lanes + 28 + static_cast<std::size_t>(timed ? time : 0));
}

void ReportPage::write_steps(const std::string& id, const runs::Run& run) {
    out_ += column_style(id, machines_.size(), timed_, unit_.has_value());
    out_ += fmt::format(
        "<div class=\"steps\" tabindex=\"0\" role=\"region\" aria-label=\"steps of {}\">\n<table><thead><tr>"
        "<th scope=\"col\">step</th>{}",
        id, timed_ ? "<th scope=\"col\">time</th>" : "");
    for (const auto& [component, definition] : machines_)
        out_ +=
            fmt::format("<th scope=\"col\" title=\"{}\">{}</th>", xml_text(component), xml_text(lane_name(component)));
    out_ +=
        "<th scope=\"col\">elsewhere</th><th scope=\"col\">place</th><th scope=\"col\" title=\"what else "
        "was possible\">also</th></tr></thead>\n"
        "<tbody>\n";
    const std::size_t columns = machines_.size() + (timed_ ? 5 : 4);
    write_row(0, nullptr, {}, run.initial);
    const std::size_t count = run.steps.size();
    const std::vector<runs::Machine>* shown = &run.initial;
    for (std::size_t i = 0; i < count; ++i) {
        if (i == most_steps / 2 && count > most_steps) {
            i = count - most_steps / 2;
            out_ +=
                fmt::format("<tr><td colspan=\"{}\">{} steps are left out</td></tr>\n", columns, count - most_steps);
        }
        if (run.loop_start == i) out_ += fmt::format("<tr><td colspan=\"{}\">then for ever:</td></tr>\n", columns);
        write_row(i + 1, &run.steps[i], *shown, run.steps[i].machines);
        shown = &run.steps[i].machines;
    }
    if (run.end.kind == runs::EndKind::no_trace && !run.end.why.empty())
        out_ += fmt::format("<tr><td colspan=\"{}\">here: {}</td></tr>\n", columns, xml_text(run.end.why));
    out_ += "</tbody></table>\n";
    write_scope_legend(run);
    out_ += "</div>\n";
    write_cycles(run);
}

/// Writes the cycles of a run of a RoboSim component.
void ReportPage::write_cycles(const runs::Run& run) {
    const std::vector<runs::RunCycle> cycles = runs::cycles_of(run);
    if (cycles.empty()) return;
    out_ +=
        "<div class=\"cycles\">\n<table><thead><tr><th scope=\"col\">cycle</th><th scope=\"col\">time</th>"
        "<th scope=\"col\">inputs</th><th scope=\"col\">outputs</th><th scope=\"col\">states at its end</th></tr>"
        "</thead>\n<tbody>\n";
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        if (i == most_steps / 2 && cycles.size() > most_steps) {
            i = cycles.size() - most_steps / 2;
            out_ += fmt::format("<tr><td colspan=\"5\">{} cycles are left out</td></tr>\n", cycles.size() - most_steps);
        }
        const runs::RunCycle& cycle = cycles[i];
        out_ += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", i + 1,
                            xml_text(durations::time_text(cycle.time, unit_)),
                            xml_text(fmt::format("{}", fmt::join(cycle.inputs, ", "))),
                            xml_text(fmt::format("{}", fmt::join(cycle.outputs, ", "))),
                            xml_text(fmt::format("{}", fmt::join(cycle.states, "; "))));
    }
    out_ += "</tbody></table>\n</div>\n";
}

/// Explains the bars beside the steps, if the run has such bars.
void ReportPage::write_scope_legend(const runs::Run& run) {
    const bool scope = std::ranges::any_of(run.steps, &runs::Step::in_scope);
    const bool owed = std::ranges::any_of(run.steps, &runs::Step::owed);
    if (scope || owed)
        out_ += fmt::format("<p class=\"legend\">{}{}{}</p>\n",
                            scope ? "<span class=\"scope\">bar</span>: the scope of the claim lasts" : "",
                            scope && owed ? "; " : "",
                            owed ? "<span class=\"owed\">double bar</span>: the claim waits for something" : "");
}

/// Returns, for each machine, the elements that some step of the run marks.
std::vector<std::set<std::string>> ReportPage::marked_elements(const runs::Run& run) const {
    std::vector<std::set<std::string>> result(machines_.size());
    const auto add = [&](const Marks& marks) {
        for (const auto& [machine, element] : marks) result[machine].insert(element);
    };
    for (const runs::Step& step : run.steps) {
        add(active_marks(step.machines));
        add(fired_marks(step));
    }
    return result;
}

/// Writes the diagram of each machine after the last step, so that the page is readable without scripts, and the
/// diagrams of the operations that the machine calls.
void ReportPage::write_figures(const std::string& id, const runs::Run& run) {
    const std::vector<runs::Machine>& last = run.steps.empty() ? run.initial : run.steps.back().machines;
    std::vector<PartDiagrams::Classes> classes(machines_.size());
    for (const auto& [machine, element] : active_marks(last)) classes[machine][element] = "on";
    if (!run.steps.empty())
        for (const auto& [machine, element] : fired_marks(run.steps.back())) classes[machine][element] += " fired";
    const std::vector<std::set<std::string>> marks = marked_elements(run);
    out_ += "<div class=\"drawn\">\n";
    for (std::size_t i = 0; i < machines_.size(); ++i) {
        const std::string svg = diagrams_.draw_diagram(machines_[i].second, fmt::format("{}-{}-", id, i), classes[i]);
        const runs::Machine* const machine = find(last, machines_[i].first);
        const std::string values = machine == nullptr ? "" : runs::values_text(*machine);
        if (!svg.empty())
            write_figure(fmt::format(" data-machine=\"{}\"", i), machines_[i].first,
                         fmt::format("<p class=\"values\">{}</p>\n{}", xml_text(values), svg));
        for (const auto& [name, drawn] : diagrams_.draw_operations(marks[i], fmt::format("{}-{}-", id, i), classes[i]))
            write_figure(fmt::format(" data-machine=\"{}\"", i),
                         fmt::format("{}: operation {}", machines_[i].first, name), drawn);
    }
    out_ += "</div>\n";
}

/// Writes a figure that can be scrolled, also by keyboard, if it is wider than its column.
void ReportPage::write_figure(const std::string& attributes, const std::string& caption, const std::string& svg) {
    out_ += fmt::format(
        "<figure{} tabindex=\"0\" aria-label=\"diagram of "
        "{}\"><figcaption>{}</figcaption>\n{}</figure>\n",
        attributes, xml_text(caption), xml_text(caption), svg);
}

/// Writes the steps of a run next to the diagrams of its machines.
void ReportPage::write_replay(const std::string& id, const runs::Run& run) {
    machines_.clear();
    timed_ = run.timed;
    unit_ = run.unit;
    const auto add = [&](const std::vector<runs::Machine>& machines) {
        for (const runs::Machine& machine : machines) {
            const auto known =
                std::ranges::any_of(machines_, [&](const auto& pair) { return pair.first == machine.component; });
            if (!known) machines_.emplace_back(machine.component, machine.machine);
        }
    };
    add(run.initial);
    for (const runs::Step& step : run.steps) add(step.machines);
    out_ +=
        "<p class=\"controls\"><button type=\"button\" data-to=\"first\">first</button>"
        "<button type=\"button\" data-to=\"back\">back</button><button type=\"button\" data-to=\"next\">next</button>"
        "<button type=\"button\" data-to=\"last\">last</button>"
        "<button type=\"button\" class=\"play\">play</button>"
        "<label>speed <select class=\"speed\"><option value=\"3000\">slow</option>"
        "<option value=\"1000\" selected>a step a second</option><option value=\"250\">fast</option>"
        "</select></label>"
        "<button type=\"button\" class=\"link\">copy link</button>"
        "<button type=\"button\" class=\"size\" aria-pressed=\"false\">diagrams in full size</button> "
        "<span class=\"status\" aria-live=\"polite\"></span></p>\n"
        "<p class=\"address\" hidden><label>link to this step <input type=\"text\" readonly></label></p>\n"
        "<div class=\"replay\">\n";
    write_steps(id, run);
    write_figures(id, run);
    out_ += "</div>\n" + end_text(run.end);
    out_ += fmt::format("<details class=\"script\"><summary>events of the script</summary>{}</details>\n",
                        preformatted_block(fmt::format("{}", fmt::join(run.raw, "\n"))));
}

void ReportPage::write_claim(std::size_t number, const driver::AssertionReport& assertion) {
    const std::string id = fmt::format("a{}", number);
    out_ += fmt::format(
        "<section class=\"claim\" id=\"{}\">\n<h2><span class=\"{}\">{}</span> {}</h2>\n<p>{}</p>\n<p>{}</p>\n", id,
        answer_class(assertion.answer), answer_word(assertion.answer), xml_text(title_of(assertion)),
        xml_text(assertion.place), xml_text(assertion.run->end.why));
    out_ += basis_list(assertion.basis);
    write_replay(id, *assertion.run);
    out_ += "</section>\n";
}

/// Writes a run of the model that explains a result about a component and its code. `more` is a second sentence, or "".
void ReportPage::model_run(const std::string& id, const std::string& title, const std::string& more,
                           const runs::Run& run) {
    out_ += fmt::format("<section class=\"claim\" id=\"{}\">\n<h3>{}</h3>\n<p>{}</p>\n", id, xml_text(title),
                        xml_text(run.end.why));
    if (!more.empty()) out_ += fmt::format("<p>{}</p>\n", xml_text(more));
    write_replay(id, run);
    out_ += "</section>\n";
}

/// Writes the runs that explain the result. They show why the model cannot run in cycles, which steps lead to a
/// difference between code and model, or where an output is repeated or a deadline is missed.
void ReportPage::model_runs(std::size_t number, const ConformanceReport& report) {
    const conformance::Result& result = report.result;
    const auto coded = [&](std::string title, const diagnostics::Rule* rule) {
        return rule == nullptr ? title : fmt::format("{} [{}]", title, rule->code);
    };
    if (const conformance::Explanation& explanation = result.explanation; explanation.run) {
        const bool differs = result.outcome == conformance::Outcome::differs;
        const std::string title = report.component + (differs ? ": the code differs from the model; what both do before"
                                                              : " is not schedulable");
        const std::string expected = result.expected.empty() ? "" : "the model: " + result.expected;
        model_run(fmt::format("c{}", number), coded(title, explanation.rule), differs ? expected : explanation.remedy,
                  *explanation.run);
    }
    const auto add_aside = [&](const char* id, const char* title, const std::optional<conformance::Aside>& aside) {
        if (!aside || !aside->run) return;
        model_run(fmt::format("{}{}", id, number), coded(report.component + title, aside->rule),
                  std::string(conformance::meaning_of(*aside)), *aside->run);
    };
    add_aside("o", " does not run in register cycles", result.register_cycles);
    add_aside("t", " may miss a deadline", result.deadlines);
}

void ReportPage::write_conformance() {
    if (report_.conformance.empty()) return;
    out_ += "<section id=\"conformance\">\n<h2>Conformance of the generated C++</h2>\n";
    for (std::size_t i = 0; i < report_.conformance.size(); ++i) {
        const ConformanceReport& component_report = report_.conformance[i];
        out_ += preformatted_block(conformance_text(component_report)) + "\n";
        model_runs(i, component_report);
    }
    out_ += "</section>\n";
}

/// Returns the elements that no run exercises, if a claim asks whether they are exercised.
std::set<std::string> ReportPage::unexercised_elements() const {
    std::set<std::string> result, exercised;
    for (const driver::AssertionReport& assertion : report_.assertions) {
        if (!assertion.core || (assertion.answer != driver::Answer::holds && assertion.answer != driver::Answer::fails))
            continue;
        const std::vector<std::string>& never = assertion.core->unexercised;
        result.insert(never.begin(), never.end());
        for (const std::string& element : assertion.core->elements)
            if (std::ranges::find(never, element) == never.end()) exercised.insert(element);
    }
    for (const std::string& element : exercised) result.erase(element);
    return result;
}

void ReportPage::write_diagrams() {
    const std::vector<PartSubject>& subjects = diagrams_.subjects();
    if (subjects.empty()) return;
    out_ += "<section id=\"diagrams\">\n<h2>Diagrams</h2>\n";
    PartDiagrams::Classes classes;
    for (const std::string& element : unexercised_elements())
        if (const std::string id = diagrams_.id_of_name(element); !id.empty()) classes[id] = "unexercised";
    if (!classes.empty())
        out_ += fmt::format("<p>{} {} dashed: no run exercises {}.</p>\n", classes.size(),
                            classes.size() == 1 ? "element is" : "elements are", classes.size() == 1 ? "it" : "them");
    for (std::size_t i = 0; i < subjects.size(); ++i)
        write_figure("", subjects[i].subject.name,
                     diagrams_.draw_diagram(subjects[i], fmt::format("d{}-", i), classes));
    out_ += "</section>\n";
}

}  // namespace

std::string render_html(const Report& report, const std::vector<driver::Part>& parts, const RunRecord& run,
                        diagnostics::Budget& budget) {
    return ReportPage(report, parts, run, budget).write();
}

std::string last_page(const std::vector<driver::Part>& parts, bool may_draw,
                      const std::function<std::string(const std::vector<driver::Part>&, diagnostics::Budget&)>& page) {
    constexpr std::chrono::milliseconds moment{200};
    diagnostics::Limits limits;
    limits.memory_bytes = std::numeric_limits<std::uint64_t>::max();
    if (may_draw) {
        limits.deadline = std::chrono::steady_clock::now() + moment;
        diagnostics::Budget budget(limits);
        try {
            return page(parts, budget);
        } catch (const diagnostics::LimitReached&) {
            limits.deadline.reset();
        }
    }
    diagnostics::Budget budget(limits);
    return page({}, budget);
}

}  // namespace robochart::app
