// SPDX-License-Identifier: Apache-2.0
// See simulation_html.hpp. Foreign text is escaped when it is inserted into the page; ids are numbers from counters.
#include "app/pages/simulation_html.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/command/run.hpp"
#include "app/pages/page.hpp"
#include "app/pages/part_diagrams.hpp"
#include "app/pages/trial_data.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/json.hpp"
#include "base/diagnostics/text.hpp"
#include "simulation/report/plot.hpp"
#include "simulation/report/report.hpp"
#include "simulation/report/series.hpp"

namespace robochart::app {
namespace {

using diagnostics::Json;
using diagnostics::xml_text;

/// The largest number of rows in the table of trials, and in the table of robots at the end.
constexpr std::size_t most_rows = 200;
/// The largest number of points in time in plots.
constexpr std::size_t most_times = 140;
/// Single trials are drawn as lines only if there are at most this many series and trials.
constexpr std::size_t most_line_series = 2;
constexpr std::size_t most_line_trials = 20;
/// Links between robots are drawn for at most this many robots.
constexpr std::size_t most_linked = 300;

/// Returns "1 trial", "3 trials".
std::string counted(std::size_t count, const char* noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

class SimulationPage {
public:
    SimulationPage(const SimulationRun& run, const Options& options)
        : run_(run),
          options_(options),
          scenario_(run.scenario),
          result_(run.result),
          machines_(run.machines),
          shown_(shown_trials(run.scenario, run.result, machines_.size())),
          charts_(simulation::charts_of(run.scenario, run.result.trials, machines_, most_times)),
          diagrams_(projects_of(run), options.run->budget()) {}

    std::string write() {
        out_ = fmt::format("<style>{}</style>\n<style>{}</style>\n", simulation::picture_style(),
                           page_part("simulation.css"));
        write_head();
        write_bands();
        write_claims();
        if (!shown_.trials.empty()) write_world();
        write_plots();
        write_trials();
        write_diagrams();
        write_notes();
        return page_text({scenario_.name.text, "simulation.js", std::move(out_), record_of(options_)});
    }

private:
    static std::vector<driver::Project*> projects_of(const SimulationRun& run) {
        std::vector<driver::Project*> projects;
        for (const KindModel& kind : run.kinds) projects.push_back(kind.project);
        return projects;
    }
    static const ir::Machine& machine_of(const KindModel& kind, const cpp_emit::DriveMachine& machine) {
        return kind.project->system.machines[machine.machine.index];
    }
    [[nodiscard]] bool has_several_kinds() const { return run_.kinds.size() > 1; }
    /// Returns "state of rig::go", with a number if each kind has its own machines.
    [[nodiscard]] std::string title_of(std::size_t number) const {
        const std::string& name = machines_[number].name;
        if (has_several_kinds())
            return machines_.size() == 1 ? "state" : fmt::format("state of machine {}", number + 1);
        return name.empty() ? "state" : "state of " + xml_text(name);
    }

    void write_head();
    [[nodiscard]] std::string verdict_html() const;
    void write_bands();
    void write_claims();
    [[nodiscard]] std::string strip_svg(std::size_t band) const;
    void write_world();
    void write_controls();
    void write_legend();
    void write_robot();
    void robots_at_the_end(const simulation::TrialResult& trial);
    [[nodiscard]] Json data_json() const;
    [[nodiscard]] Json element_ids(std::size_t machine) const;
    [[nodiscard]] Json element_ids(const KindModel&, const cpp_emit::DriveMachine&) const;
    void write_diagram(std::size_t kind, std::size_t number);
    [[nodiscard]] simulation::View common_view() const;
    void write_plots();
    void write_trials();
    void write_trial(std::size_t number);
    void write_diagrams();
    void write_notes();
    [[nodiscard]] std::vector<std::string> omitted_notes() const;

    const SimulationRun& run_;
    const Options& options_;
    const simulation::Scenario& scenario_;
    const simulation::RunResult& result_;
    simulation::Machines machines_;
    ShownTrials shown_;
    simulation::Charts charts_;
    PartDiagrams diagrams_;
    std::string out_;
};

void SimulationPage::write_head() {
    out_ += fmt::format("<h1>{}</h1>\n", xml_text(scenario_.name.text));
    out_ += fmt::format("<p>{}, {} of {:g} s, seed {}; controller {}{}</p>\n", counted(scenario_.all_robots(), "robot"),
                        counted(scenario_.trials, "trial"), scenario_.duration, scenario_.seed,
                        xml_text(scenario_.component.text),
                        run_.simulator.empty() ? "" : "; in " + xml_text(run_.simulator));
    out_ += verdict_html();
    out_ += fmt::format("<p class=\"sim-small\">robochart-verify {}; {}</p>\n", program_version,
                        xml_text(diagnostics::on_one_line(simulation::run_text(scenario_, result_))));
}

const char* answer_class(const simulation::RunResult& result) {
    if (result.all_hold()) return "holds";
    return result.has_failed() ? "fails" : "other";
}

std::string SimulationPage::verdict_html() const {
    std::size_t stopped = 0;
    for (const auto& trial : result_.trials) stopped += trial.stop ? 1U : 0U;
    std::string text;
    if (stopped > 0 && result_.stops_are_errors)
        text = fmt::format("<p class=\"answer fails\">a controller stopped in {}</p>\n", counted(stopped, "trial"));
    else if (!result_.bands.empty() || !result_.claims.empty())
        text = fmt::format("<p class=\"answer {}\">{}</p>\n", answer_class(result_), simulation::summary_text(result_));
    if (run_.monitors.empty()) return text + "<p>No monitor compared the controllers with the model (--monitor).</p>\n";
    return text + fmt::format("<p>{}{}</p>\n", xml_text(diagnostics::on_one_line(run_.monitors)),
                              stopped == 0 ? "; none did what its model does not allow" : "");
}

void SimulationPage::write_bands() {
    if (result_.bands.empty()) return;
    out_ +=
        "<section id=\"bands\">\n<h2>Bands</h2>\n<div class=\"sim-wide\"><table class=\"sortable\"><thead><tr><th "
        "scope=\"col\">number</th><th scope=\"col\">answer</th>"
        "<th scope=\"col\">band</th><th scope=\"col\">value</th><th scope=\"col\">trials, beside what is "
        "accepted</th></tr></thead>\n<tbody>\n";
    for (std::size_t b = 0; b < result_.bands.size(); ++b) {
        const simulation::Band& band = scenario_.bands[b];
        const simulation::BandResult& found = result_.bands[b];
        const std::string value = simulation::value_text(scenario_, band, found.value);
        const std::string outside =
            found.trials_outside == 0 ? "" : fmt::format(", {} outside", counted(found.trials_outside, "trial"));
        out_ += fmt::format(
            "<tr><td class=\"number\">{}</td><td class=\"answer {}\">{}</td><td>{}</td><td>{} "
            "{}{}</td><td>{}</td></tr>\n",
            b + 1, found.holds ? "holds" : "fails", found.holds ? "holds" : "FAILS", xml_text(band.text),
            band.each ? "worst" : "mean", value, outside, strip_svg(b));
    }
    out_ += "</tbody></table></div>\n</section>\n";
}

void SimulationPage::write_claims() {
    if (result_.claims.empty()) return;
    out_ +=
        "<section id=\"claims\">\n<h2>Claims</h2>\n<div class=\"sim-wide\"><table class=\"sortable\"><thead><tr><th "
        "scope=\"col\">answer</th><th scope=\"col\">claim</th><th scope=\"col\">rests on</th></tr></thead>\n<tbody>\n";
    for (std::size_t c = 0; c < result_.claims.size(); ++c) {
        const simulation::ClaimResult& found = result_.claims[c];
        const std::string word = simulation::verdict_word(found.verdict);
        out_ += fmt::format("<tr><td class=\"answer {}\">{}</td><td>{}</td><td>{}</td></tr>\n",
                            word == "open" ? "other" : word, word, xml_text(scenario_.claims[c].text),
                            xml_text(simulation::evidence_text(scenario_.claims[c], found)));
    }
    out_ += "</tbody></table></div>\n<p>In this world:</p>\n<ul>\n";
    for (const std::string& line : simulation::world_lines(scenario_))
        out_ += fmt::format("<li>{}</li>\n", xml_text(line));
    out_ += "</ul>\n</section>\n";
}

/// Draws the values of the trials as ticks next to the accepted interval.
std::string SimulationPage::strip_svg(std::size_t band) const {
    const simulation::Band& accepted = scenario_.bands[band];
    double low = INFINITY, high = -INFINITY;
    const auto take = [&](double value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    };
    take(accepted.low);
    take(accepted.high);
    for (const auto& trial : result_.trials) take(trial.statistics.at(band));
    if (!(low <= high)) return "";
    const double edge = high > low ? 0.08 * (high - low) : 1;
    low -= edge;
    high += edge;
    const auto x = [&](double value) { return 160 * (std::clamp(value, low, high) - low) / (high - low); };
    std::string marks;
    std::size_t never = 0;
    for (const auto& trial : result_.trials) {
        const double value = trial.statistics.at(band);
        if (std::isnan(value))
            ++never;
        else
            marks += fmt::format("M{:.1f} 3v12", x(value));
    }
    const double value = result_.bands[band].value;
    const bool mean = !accepted.each && std::isfinite(value);
    const std::string dot =
        mean ? fmt::format("<circle class=\"sim-mark\" cx=\"{:.1f}\" cy=\"9\" r=\"4\"/>", x(value)) : "";
    return fmt::format(
        "<svg class=\"sim-strip\" viewBox=\"0 0 160 18\" role=\"img\"><title>accepted: {}; a line for each "
        "trial{}{}</title>"
        "<rect class=\"sim-accepted\" x=\"{:.1f}\" width=\"{:.1f}\" height=\"18\" rx=\"2\"/><path class=\"sim-target\" "
        "stroke-width=\"1.4\" d=\"{}\"/>{}</svg>",
        xml_text(accepted.text), mean ? ", a dot for the mean" : "",
        never == 0 ? "" : fmt::format(", but {} never", counted(never, "trial")), x(accepted.low),
        x(accepted.high) - x(accepted.low), marks, dot);
}

simulation::View SimulationPage::common_view() const {
    simulation::View all = simulation::view_of(scenario_, {});
    for (const std::size_t t : shown_.trials) {
        const simulation::View view = simulation::view_of(scenario_, result_.trials[t].frames);
        if (view.width > all.width) all.left = view.left, all.width = view.width;
        if (view.height > all.height) all.top = view.top, all.height = view.height;
    }
    return all;
}

void SimulationPage::write_world() {
    const simulation::TrialResult& first = result_.trials[shown_.trials.front()];
    simulation::Frame last = first.frames.back();
    const std::size_t columns = last.states.size() / last.poses.size();
    last.poses.resize(shown_.robots);
    last.states.resize(shown_.robots * columns);
    out_ += "<section id=\"world\">\n<h2>The world</h2>\n<div class=\"sim-columns\">\n<div class=\"sim-scene\">\n";
    write_controls();
    write_legend();
    out_ += simulation::world_svg(scenario_, common_view(), last, machines_, "w");
    out_ += fmt::format(
        "<noscript><p>The picture shows trial {} after {:g} s. With script, the page plays the "
        "trials.</p></noscript>\n",
        shown_.trials.front() + 1, last.time);
    out_ += "</div>\n";
    write_robot();
    out_ += "</div>\n";
    robots_at_the_end(first);
    out_ += page_data("data", diagnostics::json_text(data_json())) + "</section>\n";
}

void SimulationPage::write_controls() {
    out_ +=
        "<p class=\"controls sim-controls\"><button type=\"button\" id=\"play\" "
        "aria-keyshortcuts=\"Space\">play</button>"
        "<button type=\"button\" data-move=\"first\" aria-label=\"to the start\">|◀</button>"
        "<button type=\"button\" data-move=\"back\" aria-label=\"back\">◀</button>"
        "<button type=\"button\" data-move=\"next\" aria-label=\"next\">▶</button>"
        "<button type=\"button\" data-move=\"last\" aria-label=\"to the end\">▶|</button>"
        "<input type=\"range\" id=\"time\" min=\"0\" step=\"1\" aria-label=\"time\"><output "
        "id=\"clock\"></output></p>\n";
    out_ += "<p class=\"controls sim-controls\"><label>trial <select id=\"trial\">";
    for (std::size_t i = 0; i < shown_.trials.size(); ++i) {
        const auto& trial = result_.trials[shown_.trials[i]];
        out_ +=
            fmt::format("<option value=\"{}\">{}{}</option>", i, shown_.trials[i] + 1, trial.stop ? ", stopped" : "");
    }
    out_ += "</select></label><label>speed <select id=\"speed\">";
    for (const int speed : {1, 2, 5, 10, 20, 50, 100})
        out_ += fmt::format("<option value=\"{0}\">{0} ×</option>", speed);
    out_ += "</select></label>";
    if (scenario_.all_robots() <= most_linked && scenario_.all_robots() > 1)
        out_ += fmt::format("<label><input type=\"checkbox\" id=\"links\"> links of at most {:g} cm</label>",
                            simulation::link_of(scenario_));
    out_ +=
        "<label><input type=\"checkbox\" id=\"trail\" checked> path of the robot</label></p>\n"
        "<p class=\"sim-status\" id=\"status\" role=\"status\"></p>\n";
}

/// Writes the states of the first machine, with the number of robots in each state.
void SimulationPage::write_legend() {
    out_ += "<ul class=\"sim-legend\">";
    const auto entries = simulation::state_entries(
        machines_.front(), simulation::page_world(scenario_, common_view(), "w").drawn_radius(), "w");
    for (std::size_t s = 0; s < entries.size(); ++s)
        out_ += fmt::format(
            "<li><svg viewBox=\"-8 -8 16 16\" aria-hidden=\"true\">{}</svg>{} <span class=\"sim-count\" "
            "data-state=\"{}\"></span></li>",
            entries[s].sign, xml_text(entries[s].text), s);
    for (const simulation::Light& light : scenario_.lights)
        out_ += fmt::format(
            "<li><svg viewBox=\"-8 -8 16 16\" aria-hidden=\"true\"><circle r=\"6\" fill=\"#f5c400\" "
            "stroke=\"#8a6d00\"/></svg>light {}</li>",
            xml_text(light.name.text));
    out_ += "</ul>\n";
}

/// Writes the position and the machines of the selected robot.
void SimulationPage::write_robot() {
    out_ +=
        "<div class=\"sim-chosen-robot\">\n<p class=\"controls\"><label for=\"robot\">Robot</label> <select "
        "id=\"robot\">";
    for (std::size_t r = 0; r < shown_.robots; ++r) out_ += fmt::format("<option value=\"{0}\">{0}</option>", r);
    out_ +=
        "</select></p>\n<table id=\"pose\" hidden><tbody><tr><th scope=\"row\">x</th><td></td></tr>"
        "<tr><th scope=\"row\">y</th><td></td></tr><tr><th scope=\"row\">heading</th><td></td></tr>";
    for (std::size_t m = 0; m < machines_.size(); ++m)
        out_ += fmt::format("<tr><th scope=\"row\">{}</th><td></td></tr>", title_of(m));
    out_ += "</tbody></table>\n";
    for (std::size_t kind = 0; kind < run_.kinds.size(); ++kind)
        for (std::size_t m = 0; m < run_.kinds[kind].emission->machines.size(); ++m) write_diagram(kind, m);
    out_ += "</div>\n";
}

/// Writes the diagram of a machine of one kind of robots. It is shown while a robot of that kind is selected.
void SimulationPage::write_diagram(std::size_t kind, std::size_t number) {
    const cpp_emit::DriveMachine& drive = run_.kinds[kind].emission->machines[number];
    const ir::Machine& definition = machine_of(run_.kinds[kind], drive);
    const std::string name = definition.package.empty() ? definition.path : definition.package + "::" + definition.path;
    const diagnostics::SourceManager& sources = run_.kinds[kind].project->sources;
    // Two models may have components with the same name.
    const auto is_of = [&](const PartSubject& part_subject) {
        return part_subject.subject.component != nullptr && part_subject.subject.name == name &&
               !definition.nodes.empty() &&
               part_subject.project->sources.path(part_subject.subject.component->span.source) ==
                   sources.path(definition.nodes.front().origin.span.source);
    };
    const auto subject = std::ranges::find_if(diagrams_.subjects(), is_of);
    if (subject == diagrams_.subjects().end()) return;
    const std::string svg = diagrams_.draw_diagram(
        *subject, has_several_kinds() ? fmt::format("k{}m{}-", kind, number) : fmt::format("m{}-", number));
    const std::string called = has_several_kinds() ? scenario_.controller_name(kind) : machines_[number].name;
    out_ += fmt::format("<figure data-machine=\"{}\" data-kind=\"{}\"><figcaption>{}</figcaption>\n{}</figure>\n",
                        number, kind, xml_text(called.empty() ? name : called + ": " + name), svg);
}

void SimulationPage::robots_at_the_end(const simulation::TrialResult& trial) {
    const simulation::Frame& last = trial.frames.back();
    out_ += fmt::format(
        "<details><summary>robots of trial {} after {:g} s</summary>\n<table><thead><tr><th "
        "scope=\"col\">robot</th><th scope=\"col\">x [cm]</th><th scope=\"col\">y [cm]</th><th "
        "scope=\"col\">heading [°]</th>",
        shown_.trials.front() + 1, last.time);
    for (std::size_t m = 0; m < machines_.size(); ++m)
        out_ +=
            fmt::format("<th scope=\"col\">{}</th>",
                        has_several_kinds() || machines_[m].name.empty() ? title_of(m) : xml_text(machines_[m].name));
    out_ += "</tr></thead>\n<tbody>\n";
    for (std::size_t r = 0; r < std::min(last.poses.size(), most_rows); ++r) {
        const simulation::Pose& pose = last.poses[r];
        out_ += fmt::format(
            "<tr><td>{}</td><td class=\"number\">{:.1f}</td><td class=\"number\">{:.1f}</td><td "
            "class=\"number\">{:.0f}</td>",
            r, pose.at.x, pose.at.y, pose.heading * 180 / std::numbers::pi);
        for (std::size_t m = 0; m < machines_.size(); ++m)
            out_ += fmt::format("<td>{}</td>", xml_text(machines_[m].state_name(last.robot_state(r, m))));
        out_ += "</tr>\n";
    }
    out_ += "</tbody></table></details>\n";
}

/// Returns the active elements of the diagram for each state of a machine, by kind of robots. They are the state and
/// the states that contain it.
Json SimulationPage::element_ids(std::size_t number) const {
    Json states = Json::array();
    for (const KindModel& kind : run_.kinds)
        if (number < kind.emission->machines.size())
            for (Json& state : element_ids(kind, kind.emission->machines[number])) states.push_back(std::move(state));
    return states;
}

Json SimulationPage::element_ids(const KindModel& kind, const cpp_emit::DriveMachine& drive) const {
    const ir::Machine& definition = machine_of(kind, drive);
    Json states = Json::array();
    for (const ir::NodeId state : drive.states) {
        Json ids = Json::array();
        for (ir::NodeId node = state; node.is_valid(); node = definition.nodes[node.index].parent)
            if (std::string id = diagrams_.id_at(kind.project->sources, definition.nodes[node.index].origin.span);
                !id.empty())
                ids.push_back(std::move(id));
        states.push_back(std::move(ids));
    }
    return states;
}

Json SimulationPage::data_json() const {
    Json json = trials_json(common_view(), result_, shown_, machines_.size());
    json["link"] = scenario_.all_robots() <= most_linked ? simulation::link_of(scenario_) : 0;
    json["kinds"] = Json::array();  // index of the first robot of each kind
    for (std::size_t kind = 0; kind < scenario_.kind_count(); ++kind)
        json["kinds"].push_back(scenario_.first_robot(kind));
    json["states"] = Json::array();
    for (std::size_t m = 0; m < machines_.size(); ++m)
        json["states"].push_back({{"names", machines_[m].states}, {"elements", element_ids(m)}});
    for (std::size_t i = 0; i < shown_.trials.size(); ++i)
        if (const auto& stop = result_.trials[shown_.trials[i]].stop)
            json["trials"][i]["stop"] = {{"robot", stop->environment ? Json() : Json(stop->robot)},
                                         {"time", diagnostics::round_to_places(stop->time, 3)},
                                         {"why", fmt::format("{} ({})", stop->cause, stop->place)}};
    return json;
}

void SimulationPage::write_plots() {
    if (charts_.charts.empty()) return;
    out_ += "<section id=\"plots\">\n<h2>Over time</h2>\n<div class=\"sim-plots\">\n";
    for (const simulation::Chart& chart : charts_.charts) {
        const bool lines = !shown_.trials.empty() && chart.series.size() <= most_line_series &&
                           chart.series.front().trials.size() <= most_line_trials;
        simulation::ChartFrame plot = simulation::draw_plot(chart, charts_.times, lines);
        const simulation::PlotArea& area = plot.area();
        if (!shown_.trials.empty())
            plot.add(fmt::format("<line class=\"sim-now\" x1=\"{0:g}\" x2=\"{0:g}\" y1=\"{1:g}\" y2=\"{2:g}\"/>\n",
                                 area.left + area.width, area.top, area.top + area.height));
        out_ += fmt::format(
            "<figure><svg class=\"sim-plot\" viewBox=\"0 0 {:g} {:g}\" role=\"img\" font-size=\"12\" "
            "data-left=\"{:g}\" "
            "data-width=\"{:g}\" data-end=\"{:g}\" font-family=\"DejaVu Sans, Verdana, "
            "sans-serif\"><title>{}</title>\n{}"
            "</svg>\n<figcaption>{}</figcaption></figure>\n",
            plot.width(), plot.height(), area.left, area.width, charts_.times.back(), xml_text(chart.title),
            plot.content(), xml_text(chart.definition));
    }
    out_ += "</div>\n</section>\n";
}

void SimulationPage::write_trials() {
    out_ +=
        "<section id=\"trials\">\n<h2>Trials</h2>\n<div class=\"sim-wide\"><table class=\"sortable\"><thead><tr><th "
        "scope=\"col\">trial</th><th "
        "scope=\"col\">seed</th><th scope=\"col\">outcome</th>";
    for (std::size_t b = 0; b < scenario_.bands.size(); ++b)
        out_ += fmt::format("<th scope=\"col\" title=\"{}\">band {}</th>", xml_text(scenario_.bands[b].text), b + 1);
    out_ += "</tr></thead>\n<tbody>\n";
    for (std::size_t t = 0; t < std::min(result_.trials.size(), most_rows); ++t) write_trial(t);
    out_ += "</tbody></table></div>\n</section>\n";
}

void SimulationPage::write_trial(std::size_t number) {
    const simulation::TrialResult& trial = result_.trials[number];
    const auto found = std::ranges::find(shown_.trials, number);
    const std::string name = fmt::format("{}", number + 1);
    out_ += fmt::format("<tr><td>{}</td><td class=\"number\">{}</td>",
                        found == shown_.trials.end() ? name : fmt::format("<a href=\"#trial/{0}\">{0}</a>", name),
                        scenario_.seed + number);
    if (trial.stop)
        out_ += fmt::format("<td class=\"fails\">stopped at {:g} s: {}: {} ({})</td>", trial.stop->time,
                            trial.stop->owner_text(), xml_text(trial.stop->cause), xml_text(trial.stop->place));
    else
        out_ += fmt::format("<td>{}</td>", trial.complete ? "complete" : "not complete");
    for (std::size_t b = 0; b < scenario_.bands.size(); ++b) {
        const simulation::Band& band = scenario_.bands[b];
        const double value = trial.statistics.at(b);
        const bool outside = band.each && !(band.low <= value && value <= band.high);
        out_ += fmt::format("<td class=\"number{}\">{}{}</td>", outside ? " fails" : "",
                            simulation::value_text(scenario_, band, value), outside ? ", outside" : "");
    }
    out_ += "</tr>\n";
}

void SimulationPage::write_diagrams() {
    const std::vector<PartSubject>& subjects = diagrams_.subjects();
    if (subjects.empty()) return;
    out_ += "<section id=\"diagrams\">\n<h2>Diagrams</h2>\n";
    for (std::size_t i = 0; i < subjects.size(); ++i)
        out_ += fmt::format("<figure><figcaption>{}</figcaption>\n{}</figure>\n", xml_text(subjects[i].subject.name),
                            diagrams_.draw_diagram(subjects[i], fmt::format("d{}-", i)));
    out_ += "</section>\n";
}

/// Lists data that the page omits or thins out to stay small and clear.
std::vector<std::string> SimulationPage::omitted_notes() const {
    std::vector<std::string> list;
    const std::size_t recorded = simulation::recorded_trials(scenario_);
    if (shown_.trials.empty())
        list.push_back("no trial can be played: no positions were kept (record less often)");
    else if (shown_.trials.size() < result_.trials.size())
        list.push_back(
            fmt::format("{} of {} can be played", shown_.trials.size(), counted(result_.trials.size(), "trial")));
    if (shown_.every > 1)
        list.push_back(
            fmt::format("of the recorded positions one in {} is here, every {:g} s, and the last of each trial",
                        shown_.every, static_cast<double>(shown_.every) * scenario_.record));
    if (shown_.robots < scenario_.all_robots())
        list.push_back(fmt::format("the first {} of {} robots are drawn; the plots are of all", shown_.robots,
                                   scenario_.all_robots()));
    if (scenario_.environment)
        list.push_back("the states of the environment were not recorded; lights and obstacles are as at the end");
    if (simulation::page_world(scenario_, common_view(), "w").drawn_radius() > scenario_.world.body.radius)
        list.push_back("robots are drawn larger than they are, so that they can be seen");
    if (charts_.every > 1) list.push_back(fmt::format("the plots have one in {} of the recorded times", charts_.every));
    if (!charts_.charts.empty() && recorded < result_.trials.size())
        list.push_back(fmt::format("the plots are of the first {} trials", recorded));
    if (!charts_.distances) list.push_back("mean distances between robots: too many pairs of robots");
    if (result_.trials.size() > most_rows) list.push_back(fmt::format("the table has the first {} trials", most_rows));
    return list;
}

void SimulationPage::write_notes() {
    out_ += "<section id=\"notes\">\n<h2>About this page</h2>\n";
    out_ +=
        "<p>Positions are rounded to 1/4095 of the width and height of the world; between two recorded times the "
        "animation moves the robots evenly. The active state is that of the recorded time: the innermost one, or the "
        "one whose action is running. Keys: space plays, left and right (or k and j) go from time to time, Home and "
        "End to the ends, [ and ] from robot to robot.</p>\n";
    const std::vector<std::string> missing = omitted_notes();
    if (!missing.empty()) out_ += "<p>What the page leaves out or changes:</p>\n<ul>";
    for (const std::string& note : missing) out_ += fmt::format("<li>{}</li>", note);
    if (!missing.empty()) out_ += "</ul>\n";
    if (!run_.files.empty()) {
        out_ += "<p>Files of this run:</p>\n<ul>";
        for (const std::string& file : run_.files) out_ += fmt::format("<li>{}</li>", xml_text(file));
        out_ += "</ul>\n";
    }
    if (!run_.notes.empty()) out_ += fmt::format("<pre>{}</pre>\n", xml_text(run_.notes));
    out_ += "</section>\n";
}

}  // namespace

std::string render_simulation_html(const SimulationRun& run, const Options& options) {
    return SimulationPage(run, options).write();
}

}  // namespace robochart::app
