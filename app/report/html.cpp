// See html.hpp. What others wrote is escaped where it is put into the page; ids come from counters.
#include "app/report/html.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

#include "app/command/run.hpp"
#include "diagnostics/cache/digest.hpp"
#include "diagnostics/escape.hpp"
#include "diagrams/layout/arrange.hpp"
#include "diagrams/notation/subjects.hpp"
#include "diagrams/svg/svg.hpp"

namespace robochart::app {
namespace {

using diagnostics::xml_text;

/// Steps that are shown of one run; the first and the last of longer ones.
constexpr std::size_t most_steps = 2000;

/// The diagrams of all parts, and which element of them a place or a name of the model is.
class Diagrams {
public:
    Diagrams(const std::vector<Part>& parts, diagnostics::Budget& budget) : budget_(budget) {
        std::size_t next = 1;
        for (const Part& part : parts) {
            if (!part.project->model || part.again) continue;
            elements_.push_back(std::make_unique<diagrams::Elements>(*part.project->model, next));
            next += elements_.back()->all().size();
            for (const diagrams::Element& each : elements_.back()->all()) {
                note(part.project->sources, each.span, each.id);
                note(part.project->sources, each.name_span, each.id);
            }
            name_elements(*part.project);
            for (diagrams::Subject& subject : diagrams::subjects(*part.project->model, part.project->sources))
                subjects_.push_back({elements_.back().get(), std::move(subject)});
        }
    }

    /// Of what begins at a place; "" if nothing does.
    [[nodiscard]] std::string at(const runs::Place& place) const {
        const auto found = by_place_.find({place.file, place.line, place.column});
        return found == by_place_.end() ? "" : found->second;
    }
    /// Of a state or transition by its name in the resolved model.
    [[nodiscard]] std::string named(const std::string& element) const {
        const auto found = by_name_.find(element);
        return found == by_name_.end() ? "" : found->second;
    }

    /// The SVG of a component by its qualified name, "" if it has none.
    [[nodiscard]] std::string of(const std::string& component, const std::string& prefix) const {
        for (const Drawn& each : subjects_)
            if (each.subject.component != nullptr && each.subject.name == component) return svg(each, prefix);
        return "";
    }
    /// All, with their names.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> all(const std::string& prefix) const {
        std::vector<std::pair<std::string, std::string>> result;
        for (std::size_t i = 0; i < subjects_.size(); ++i)
            result.emplace_back(subjects_[i].subject.name, svg(subjects_[i], fmt::format("{}{}-", prefix, i)));
        return result;
    }

private:
    struct Drawn {
        const diagrams::Elements* elements = nullptr;
        diagrams::Subject subject;
    };
    using Position = std::tuple<std::string, std::uint32_t, std::uint32_t>;

    [[nodiscard]] static std::optional<Position> position(const diagnostics::SourceManager& sources,
                                                          diagnostics::Span span) {
        if (!span.known()) return std::nullopt;
        const diagnostics::Position begin = sources.position(span.source, span.begin);
        return Position{sources.path(span.source), begin.line, begin.column};
    }
    void note(const diagnostics::SourceManager& sources, diagnostics::Span span, const std::string& id) {
        if (const auto where = position(sources, span)) by_place_.try_emplace(*where, id);
    }
    void name_elements(const Project& project) {
        const auto name = [&](const ir::Origin& origin) {
            const auto where = position(project.sources, origin.span);
            const auto found = where ? by_place_.find(*where) : by_place_.end();
            if (found != by_place_.end()) by_name_.try_emplace(origin.element, found->second);
        };
        for (const ir::Machine& machine : project.system.machines) {
            for (const ir::Node& node : machine.nodes) name(node.origin);
            for (const ir::Transition& transition : machine.transitions) name(transition.origin);
        }
    }
    [[nodiscard]] std::string svg(const Drawn& drawn, const std::string& prefix) const {
        try {
            const diagrams::Picture picture = diagrams::draw(drawn.subject, {*drawn.elements, nullptr, &budget_});
            return diagrams::svg(picture, *drawn.elements, {diagrams::Theme::automatic, prefix});
        } catch (const diagrams::layout::TooLarge& large) {
            return fmt::format("<p>{}</p>", xml_text(std::string(large.what())));
        }
    }

    diagnostics::Budget& budget_;
    std::vector<std::unique_ptr<diagrams::Elements>> elements_;
    std::vector<Drawn> subjects_;
    std::map<Position, std::string> by_place_;
    std::map<std::string, std::string> by_name_;
};

const char* word(Answer answer) {
    switch (answer) {
        case Answer::holds:
            return "holds";
        case Answer::fails:
            return "FAILS";
        case Answer::inconclusive:
            return "inconclusive";
        case Answer::no_check:
            return "no check";
        case Answer::error:
            return "error";
        case Answer::unchecked:
            return "not checked";
    }
    return "";
}

const char* look(Answer answer) {
    return answer == Answer::holds ? "holds" : answer == Answer::fails ? "fails" : "other";
}

/// One page.
class Page {
public:
    Page(const Report& report, const std::vector<Part>& parts, const Options& options)
        : report_(report), diagrams_(parts, options.run->budget()) {}

    std::string write() {
        head();
        verdicts();
        for (std::size_t i = 0; i < report_.assertions.size(); ++i)
            if (report_.assertions[i].run) claim(i, report_.assertions[i]);
        code();
        pictures();
        out_ += fmt::format("</main>\n<script>{}</script>\n</body>\n</html>\n", script_);
        return std::move(out_);
    }

private:
    void head();
    void verdicts();
    void verdict(std::size_t number, const AssertionReport& assertion);
    void claim(std::size_t number, const AssertionReport& assertion);
    void steps(std::size_t number, const runs::Run& run);
    void row(std::size_t number, const runs::Step* step, const std::vector<runs::Machine>& before,
             const std::vector<runs::Machine>& after);
    void figures(std::size_t number);
    void code();
    void pictures();
    [[nodiscard]] std::string active(const std::vector<runs::Machine>& machines) const;
    [[nodiscard]] std::string fired(const runs::Step& step) const;

    const Report& report_;
    Diagrams diagrams_;
    std::string style_ = page_part("style.css"), script_ = page_part("script.js");
    std::vector<std::pair<std::string, std::string>> machines_;  ///< of the claim: instance, definition
    std::string out_;
};

/// The styles of the diagrams are a part of the page's: a hash for each.
void Page::head() {
    std::set<std::string> styles{style_};
    for (const auto& [name, text] : diagrams_.all("d")) {
        const std::size_t begin = text.find("<style>");
        const std::size_t end = text.find("</style>");
        if (begin != std::string::npos && end != std::string::npos)
            styles.insert(text.substr(begin + 7, end - begin - 7));
    }
    std::vector<std::string> hashes;
    for (const std::string& each : styles) hashes.push_back("'" + diagnostics::policy_hash(each) + "'");
    out_ += fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src {}; script-src '{}'; "
        "base-uri 'none'; form-action 'none'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{} - robochart-verify</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n",
        fmt::join(hashes, " "), diagnostics::policy_hash(script_), xml_text(report_.model), style_);
    out_ += fmt::format("<h1>{}</h1>\n<p>{}", xml_text(report_.model), xml_text(report_.summary));
    for (const std::string& note : report_.notes) out_ += fmt::format("<br>{}", xml_text(note));
    out_ += fmt::format("</p>\n<p>robochart-verify {}: {} hold, {} fail{}</p>\n", program_version,
                        report_.count(Answer::holds), report_.count(Answer::fails),
                        report_.limit.empty() ? "" : "; ended early: " + xml_text(report_.limit));
}

void Page::verdicts() {
    if (report_.assertions.empty()) return;
    out_ +=
        "<section id=\"verdicts\">\n<h2>Verdicts</h2>\n"
        "<p class=\"controls\"><label><input type=\"checkbox\" id=\"only\"> only what does not hold</label></p>\n"
        "<table><thead><tr><th scope=\"col\">answer</th><th scope=\"col\">claim</th><th scope=\"col\">place</th>"
        "<th scope=\"col\">states</th></tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < report_.assertions.size(); ++i) verdict(i, report_.assertions[i]);
    out_ += "</tbody></table>\n";
    for (const BoundReport& each : report_.bounds)
        out_ += fmt::format("<p>a bound of the finite instantiation was reached: {}: {} [{}] {}</p>\n",
                            xml_text(each.element), xml_text(each.text), each.time, xml_text(each.place));
    out_ += "</section>\n";
}

void Page::verdict(std::size_t number, const AssertionReport& assertion) {
    const std::string title =
        assertion.core ? assertion.core->component + ": " + assertion.core->property : assertion.title;
    std::string shown = xml_text(title);
    if (assertion.run) shown = fmt::format("<a href=\"#a{}\">{}</a>", number, shown);
    if (!assertion.reason.empty()) shown += fmt::format("<br>{}", xml_text(assertion.reason));
    const bool information = assertion.core && assertion.core->information;
    out_ += fmt::format(
        "<tr class=\"{}\"><td class=\"answer {}\">{}</td><td>{}</td><td>{}</td><td class=\"number\">{}</td></tr>\n",
        assertion.answer == Answer::holds || information ? "good" : "bad", information ? "" : look(assertion.answer),
        information ? (assertion.answer == Answer::holds ? "yes" : "no") : word(assertion.answer), shown,
        xml_text(assertion.place), assertion.statistics.states);
}

/// "0:e5 1:e9": the active states of each machine of the claim.
std::string Page::active(const std::vector<runs::Machine>& machines) const {
    std::vector<std::string> marks;
    for (const runs::Machine& machine : machines)
        for (std::size_t i = 0; i < machines_.size(); ++i)
            for (const std::string& state : machine.active)
                if (const std::string id = diagrams_.named(state);
                    machines_[i].first == machine.component && !id.empty())
                    marks.push_back(fmt::format("{}:{}", i, id));
    return fmt::format("{}", fmt::join(marks, " "));
}

/// What the step does, in the machines that do it.
std::string Page::fired(const runs::Step& step) const {
    std::vector<std::string> marks;
    const auto add = [&](const runs::Event& event) {
        std::string id = diagrams_.named(event.element);
        if (id.empty() && event.place) id = diagrams_.at(*event.place);
        for (std::size_t i = 0; i < machines_.size(); ++i)
            if (!id.empty() && machines_[i].first == event.component) marks.push_back(fmt::format("{}:{}", i, id));
    };
    add(step.event);
    for (const runs::Event& each : step.with) add(each);
    return fmt::format("{}", fmt::join(marks, " "));
}

/// Where a machine is, with its variables.
std::string machine_text(const runs::Machine& machine) {
    std::vector<std::string> values;
    for (const runs::Variable& each : machine.variables)
        if (each.kind != runs::VariableKind::constant && each.value)
            values.push_back(fmt::format("{} = {}", each.name, *each.value));
    return fmt::format("{}{}{}", machine.text, values.empty() ? "" : ", ", fmt::join(values, ", "));
}

std::string event_text(const runs::Event& event) {
    return event.via.empty() ? event.text : fmt::format("{} ({})", event.text, event.via);
}

std::string step_text(const runs::Step& step) {
    std::string text = event_text(step.event);
    for (const runs::Event& other : step.with) text += fmt::format("; {}: {}", other.component, other.text);
    for (const runs::Change& change : step.changes) text += fmt::format("; {} = {}", change.name, change.after);
    return text;
}

/// What a component does in a step, and what it changes.
std::string does(const runs::Step& step, const std::string& component) {
    std::vector<std::string> parts;
    if (step.event.component == component) parts.push_back(event_text(step.event));
    for (const runs::Event& each : step.with)
        if (each.component == component) parts.push_back(event_text(each));
    for (const runs::Change& change : step.changes)
        if (change.component == component) parts.push_back(fmt::format("{} = {}", change.name, change.after));
    return fmt::format("{}", fmt::join(parts, "; "));
}

const runs::Machine* find(const std::vector<runs::Machine>& machines, const std::string& component) {
    const auto found = std::find_if(machines.begin(), machines.end(),
                                    [&](const runs::Machine& each) { return each.component == component; });
    return found == machines.end() ? nullptr : &*found;
}

/// A lane for each machine: what it does, and below it where it is then, if that is new. `step`: null for the
/// beginning.
void Page::row(std::size_t number, const runs::Step* step, const std::vector<runs::Machine>& before,
               const std::vector<runs::Machine>& after) {
    const std::string what = step == nullptr ? "the beginning" : step_text(*step);
    out_ +=
        fmt::format("<tr class=\"step\" data-on=\"{}\" data-fired=\"{}\" data-text=\"{}\"><td class=\"number\">{}</td>",
                    active(after), step == nullptr ? "" : fired(*step), xml_text(what), number);
    out_ += fmt::format("<td class=\"number\">{}</td>",
                        step != nullptr && step->time ? fmt::format("{}", *step->time) : "");
    bool said = false;
    for (const auto& [component, definition] : machines_) {
        const std::string done = step == nullptr ? "" : does(*step, component);
        const runs::Machine* const was = find(before, component);
        const runs::Machine* const is = find(after, component);
        const std::string then = is == nullptr ? (was == nullptr ? "" : "ended") : machine_text(*is);
        const bool news = step == nullptr || was == nullptr || is == nullptr || machine_text(*was) != then;
        said = said || !done.empty();
        out_ += fmt::format("<td>{}{}</td>", xml_text(done),
                            news && !then.empty() ? fmt::format("<div class=\"then\">{}</div>", xml_text(then)) : "");
    }
    out_ += fmt::format("<td>{}</td>", step == nullptr || said ? "" : xml_text(what));
    std::vector<std::string> offered;
    if (step != nullptr)
        for (const runs::Event& each : step->offered) offered.push_back(xml_text(each.text));
    const bool placed = step != nullptr && step->event.place;
    out_ += fmt::format("<td>{}</td><td>{}</td></tr>\n",
                        placed ? fmt::format("{}:{}", xml_text(step->event.place->file), step->event.place->line) : "",
                        offered.empty() ? ""
                                        : fmt::format("<details><summary>{}</summary>{}</details>", offered.size(),
                                                      fmt::join(offered, "<br>")));
}

void Page::steps(std::size_t number, const runs::Run& run) {
    out_ += fmt::format(
        "<div class=\"steps\">\n<p class=\"controls\"><button type=\"button\" data-to=\"first\">first</button>"
        "<button type=\"button\" data-to=\"back\">back</button><button type=\"button\" data-to=\"next\">next</button>"
        "<button type=\"button\" data-to=\"last\">last</button> <span class=\"status\" "
        "aria-live=\"polite\"></span></p>\n"
        "<table aria-label=\"steps of a{}\"><thead><tr><th scope=\"col\">step</th><th scope=\"col\">{}</th>",
        number, run.timed ? "time" : "");
    for (const auto& [component, definition] : machines_)
        out_ += fmt::format("<th scope=\"col\" title=\"{}\">{}</th>", xml_text(component),
                            xml_text(component.substr(component.rfind(':') + 1)));
    out_ +=
        "<th scope=\"col\">elsewhere</th><th scope=\"col\">place</th><th scope=\"col\">also "
        "possible</th></tr></thead>\n"
        "<tbody>\n";
    const std::size_t columns = machines_.size() + 5;
    row(0, nullptr, {}, run.initial);
    const std::size_t count = run.steps.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (i == most_steps / 2 && count > most_steps) {
            i = count - most_steps / 2;
            out_ +=
                fmt::format("<tr><td colspan=\"{}\">{} steps are left out</td></tr>\n", columns, count - most_steps);
        }
        if (run.loop_start == i) out_ += fmt::format("<tr><td colspan=\"{}\">then for ever:</td></tr>\n", columns);
        const runs::Step& step = run.steps[i];
        row(i + 1, &step, i == 0 ? run.initial : run.steps[i - 1].machines, step.machines);
    }
    out_ += "</tbody></table>\n</div>\n";
}

void Page::figures(std::size_t number) {
    out_ += "<div class=\"drawn\">\n";
    for (std::size_t i = 0; i < machines_.size(); ++i) {
        const std::string svg = diagrams_.of(machines_[i].second, fmt::format("a{}-{}-", number, i));
        if (svg.empty()) continue;
        out_ += fmt::format("<figure data-machine=\"{}\"><figcaption>{}</figcaption>\n{}</figure>\n", i,
                            xml_text(machines_[i].first), svg);
    }
    out_ += "</div>\n";
}

void Page::claim(std::size_t number, const AssertionReport& assertion) {
    const runs::Run& run = *assertion.run;
    machines_.clear();
    const auto add = [&](const std::vector<runs::Machine>& machines) {
        for (const runs::Machine& each : machines) {
            const auto known = std::any_of(machines_.begin(), machines_.end(),
                                           [&](const auto& pair) { return pair.first == each.component; });
            if (!known) machines_.emplace_back(each.component, each.machine);
        }
    };
    add(run.initial);
    for (const runs::Step& step : run.steps) add(step.machines);
    const std::string title =
        assertion.core ? assertion.core->component + ": " + assertion.core->property : assertion.title;
    out_ += fmt::format(
        "<section class=\"claim\" id=\"a{}\">\n<h2><span class=\"{}\">{}</span> {}</h2>\n<p>{}</p>\n<p>{}</p>\n",
        number, look(assertion.answer), word(assertion.answer), xml_text(title), xml_text(assertion.place),
        xml_text(run.end.why));
    out_ += "<div class=\"replay\">\n";
    steps(number, run);
    figures(number);
    out_ += fmt::format("</div>\n<details><summary>events of the script</summary><pre>{}</pre></details>\n</section>\n",
                        xml_text(fmt::format("{}", fmt::join(run.raw, "\n"))));
}

void Page::code() {
    if (report_.conformance.empty()) return;
    out_ += "<section id=\"conformance\">\n<h2>Conformance of the generated C++</h2>\n";
    for (const ConformanceReport& each : report_.conformance)
        out_ += fmt::format("<pre>{}</pre>\n", xml_text(conformance_text(each)));
    out_ += "</section>\n";
}

void Page::pictures() {
    const auto all = diagrams_.all("d");
    if (all.empty()) return;
    out_ += "<section id=\"diagrams\">\n<h2>Diagrams</h2>\n";
    for (const auto& [name, svg] : all)
        out_ += fmt::format("<figure><figcaption>{}</figcaption>\n{}</figure>\n", xml_text(name), svg);
    out_ += "</section>\n";
}

}  // namespace

std::string render_html(const Report& report, const std::vector<Part>& parts, const Options& options) {
    return Page(report, parts, options).write();
}

}  // namespace robochart::app
