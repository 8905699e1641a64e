// SPDX-License-Identifier: Apache-2.0
// See step_page.hpp. app/pages/parts/explorer.js reads the data. Foreign text is escaped for HTML when it is inserted
// into the page. In the data, its control characters are replaced by visible escapes.
#include "app/step/step_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "app/command/options.hpp"
#include "app/pages/page.hpp"
#include "app/pages/part_diagrams.hpp"
#include "base/diagnostics/budget.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/json_values.hpp"
#include "base/diagnostics/text.hpp"
#include "counterexample/text.hpp"

namespace robochart::app {
namespace {

using diagnostics::Json;
using diagnostics::json_array;
using diagnostics::xml_text;
using runs::Exploration;

std::string place_text(const std::optional<runs::Place>& place) {
    return place ? fmt::format("{}:{}", place->file, place->line) : "";
}

/// The texts of the data without duplicates. The first text is empty.
class Strings {
public:
    Strings() { (void)number_of(""); }

    std::size_t number_of(const std::string& text) {
        const auto [found, added] = numbers_.try_emplace(diagnostics::escape_for_display(text), list_.size());
        if (added) list_.push_back(found->first);
        return found->second;
    }
    [[nodiscard]] const Json& string_list() const { return list_; }

private:
    Json list_ = Json::array();
    std::map<std::string, std::size_t> numbers_;
};

/// A machine of the process, as an instance of a definition. The diagram shows the definition.
struct Instance {
    std::string component, machine;
};

std::vector<Instance> instances_of(const Exploration& space) {
    std::map<std::string, std::string> found;
    for (const runs::Machine& machine : space.machines) found.try_emplace(machine.component, machine.machine);
    std::vector<Instance> result;
    for (const auto& [component, machine] : found) result.push_back({component, machine});
    return result;
}

/// The data for explorer.js. It refers to texts, machines, labels, absences and states by index.
class Data {
public:
    Data(const Exploration& space, const Stepped& stepped, const std::vector<Instance>& instances,
         const PartDiagrams& diagrams)
        : space_(space), stepped_(stepped), instances_(instances), diagrams_(diagrams) {}

    Json write() {
        Json json{{"timed", stepped_.time == csp_emit::Time::timed},
                  {"log", stepped_.project == nullptr ? Json(nullptr) : Json(log_head(stepped_))},
                  {"limit", space_.limit},
                  {"instances",
                   json_array(instances_, [&](const Instance& instance) { return text_number(instance.component); })},
                  {"machines", json_array(space_.machines, [&](const auto& machine) { return machine_json(machine); })},
                  {"labels", json_array(space_.labels, [&](const auto& label) { return label_json(label); })},
                  {"absences", json_array(space_.absences, [&](const auto& absence) { return absence_json(absence); })},
                  {"parts", json_array(space_.parts, [&](const auto& part) { return part_json(part); })},
                  {"states", json_array(space_.states, [&](const auto& state) { return state_json(state); })},
                  {"structures", json_array(space_.states, [&](const auto& state) {
                       return state.structure ? Json(*state.structure) : Json(-1);
                   })}};
        json["texts"] = strings_.string_list();
        return json;
    }

private:
    std::size_t text_number(const std::string& text) { return strings_.number_of(text); }
    [[nodiscard]] std::size_t instance_number(const std::string& component) const {
        const auto found =
            std::ranges::find_if(instances_, [&](const Instance& instance) { return instance.component == component; });
        return static_cast<std::size_t>(found - instances_.begin());
    }

    /// Returns [instance, text, place, [active elements], [name, value or -1, ...]].
    Json machine_json(const runs::Machine& machine) {
        Json active = Json::array();
        for (const std::string& element : machine.active)
            if (const std::string id = diagrams_.id_of_name(element); !id.empty()) active.push_back(text_number(id));
        Json values = Json::array();
        for (const runs::Variable& variable : machine.variables) {
            if (variable.kind == runs::VariableKind::constant) continue;
            values.push_back(text_number(variable.name));
            values.push_back(variable.value ? Json(text_number(*variable.value)) : Json(-1));
        }
        return Json::array({instance_number(machine.component), text_number(machine.text),
                            text_number(place_text(machine.place)), std::move(active), std::move(values)});
    }

    /// Returns [text, place, hidden, role in a log, word in a log or -1, [instance, element, ...]].
    Json label_json(const Exploration::Label& label) {
        const runs::Event& event = label.happening.event;
        Json fired = Json::array();
        add_fired(event, fired);
        for (const runs::Event& other_event : label.happening.with) add_fired(other_event, fired);
        const LogRole role = stepped_.project == nullptr ? LogRole::none : log_role(event);
        const auto word = role == LogRole::input || role == LogRole::output ? log_word(event, label.name, stepped_)
                                                                            : std::optional<std::string>();
        return Json::array({text_number(runs::text_of(event, label.happening.with)),
                            text_number(place_text(event.place)), label.hidden ? 1 : 0, static_cast<int>(role),
                            word ? Json(text_number(*word)) : Json(-1), std::move(fired)});
    }
    void add_fired(const runs::Event& event, Json& fired) {
        const std::string id = diagrams_.id_of_event(event);
        const std::size_t where = instance_number(event.component);
        if (id.empty() || where == instances_.size()) return;
        fired.push_back(where);
        fired.push_back(text_number(id));
    }

    /// Returns [component, text, reason, place].
    Json absence_json(const runs::Absence& absence) {
        return Json::array({text_number(absence.component), text_number(absence.text), text_number(absence.reason),
                            text_number(place_text(absence.place))});
    }

    /// Returns [text, offers or 0, part, ...].
    Json part_json(const Exploration::Part& part) {
        Json json = Json::array({text_number(part.text), text_number(part.offers)});
        for (const std::size_t child : part.parts) json.push_back(child);
        return json;
    }

    /// Returns [[machines], [label, target or -1, ...], [absences], process, error].
    Json state_json(const Exploration::State& state) {
        Json offers = Json::array();
        for (const Exploration::Transition& transition : state.offers) {
            offers.push_back(transition.label);
            offers.push_back(transition.target ? Json(*transition.target) : Json(-1));
        }
        Json json = Json::array({state.machines, std::move(offers), state.absences});
        if (!state.process.empty() || !state.error.empty()) json.push_back(text_number(state.process));
        if (!state.error.empty()) json.push_back(text_number(state.error));
        return json;
    }

    const Exploration& space_;
    const Stepped& stepped_;
    const std::vector<Instance>& instances_;
    const PartDiagrams& diagrams_;
    Strings strings_;
};

/// Writes the contents that are visible without scripts, which show the first state. They are inserted into
/// app/pages/parts/explorer.html.
class Body {
public:
    Body(const Exploration& space, const Stepped& stepped) : space_(space), stepped_(stepped) {}

    std::string write(const std::string& figures) const {
        const bool timed = stepped_.time == csp_emit::Time::timed;
        const bool component = stepped_.project != nullptr;
        std::string semantics;
        if (component) semantics = timed ? ", timed semantics" : ", untimed semantics";
        return diagnostics::fill_template(
            page_part("explorer.html"),
            {{"NAME", xml_text(stepped_.name)},
             {"OF", fmt::format("{}{}", xml_text(stepped_.model), semantics)},
             {"COUNTS", xml_text(counts_text(space_))},
             {"VERSION", program_version},
             {"BUTTONS", std::string(timed ? "<button type=\"button\" id=\"tock\">one time unit</button>\n" : "") +
                             (timed && component ? "<button type=\"button\" id=\"log\">copy as log</button>" : "")},
             {"LAYOUT", figures.empty() ? "stepper plain" : "stepper"},
             {"OFFERS", offers_html()},
             {"ENDS", end_text()},
             {"ABSENCES", absences_html()},
             {"MACHINES-TITLE", component ? "Machines" : "Process"},
             {"MACHINES", machines_html()},
             {"TREE-OPEN", component ? "" : " open"},
             {"TREE", first_.structure ? tree_html(*first_.structure) : ""},
             {"FIGURES", figures.empty() ? "" : fmt::format("<div class=\"drawn\">\n{}</div>", figures)},
             {"KEYS", timed ? "<kbd>t</kbd> one time unit; " : ""}});
    }

private:
    [[nodiscard]] std::string offers_html() const {
        std::string text;
        for (const Exploration::Transition& transition : first_.offers) {
            const Exploration::Label& label = space_.labels[transition.label];
            text += fmt::format("<li>{}{} <small>{}</small></li>\n", label.hidden ? "(hidden) " : "",
                                xml_text(runs::text_of(label.happening.event, label.happening.with)),
                                xml_text(place_text(label.happening.event.place)));
        }
        return text;
    }
    [[nodiscard]] std::string end_text() const {
        if (space_.states.empty()) return "No state is embedded.";
        return first_.error.empty() ? "" : "What can happen cannot be evaluated: " + xml_text(first_.error);
    }
    [[nodiscard]] std::string absences_html() const {
        std::string text;
        for (const std::size_t number : first_.absences) {
            const runs::Absence& absence = space_.absences[number];
            text += fmt::format("<li>{}: {}: {}</li>\n", xml_text(absence.component), xml_text(absence.text),
                                xml_text(absence.reason));
        }
        return text.empty() ? "<li>nothing</li>\n" : text;
    }
    [[nodiscard]] std::string machines_html() const {
        std::string text;
        for (const std::size_t number : first_.machines)
            text += fmt::format("<li>{}: {}</li>\n", xml_text(space_.machines[number].component),
                                xml_text(runs::text_of(space_.machines[number])));
        if (!first_.process.empty()) text += fmt::format("<li>{}</li>\n", xml_text(first_.process));
        return text;
    }

    [[nodiscard]] std::string tree_html(std::size_t number) const {
        const Exploration::Part& part = space_.parts[number];
        std::string text = fmt::format("<li>{}", xml_text(part.text));
        if (!part.offers.empty()) text += fmt::format(" <small>{}</small>", xml_text(part.offers));
        if (!part.parts.empty()) {
            text += "\n<ul>\n";
            for (const std::size_t child : part.parts) text += tree_html(child);
            text += "</ul>";
        }
        return text + "</li>\n";
    }

    const Exploration& space_;
    const Stepped& stepped_;
    const Exploration::State first_ = space_.states.empty() ? Exploration::State() : space_.states.front();
};

std::string figure_html(std::size_t machine, const std::string& caption, const std::string& drawn) {
    return fmt::format(
        "<figure data-machine=\"{}\" tabindex=\"0\" aria-label=\"diagram of {}\"><figcaption>{}</figcaption>\n"
        "{}</figure>\n",
        machine, xml_text(caption), xml_text(caption), drawn);
}

/// Returns the diagrams of the machines, each followed by the diagrams of the operations that the machine can call.
std::string figures_of(const Exploration& space, const std::vector<Instance>& instances, const PartDiagrams& diagrams) {
    std::string text;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const std::string& component = instances[i].component;
        const std::string prefix = fmt::format("m{}-", i);
        if (const std::string drawn = diagrams.draw_diagram(instances[i].machine, prefix); !drawn.empty())
            text += figure_html(i, component, drawn);
        std::set<std::string> active;
        for (const runs::Machine& machine : space.machines)
            if (machine.component == component)
                for (const std::string& state : machine.active) active.insert(diagrams.id_of_name(state));
        for (const auto& [name, drawn] : diagrams.draw_operations(active, prefix))
            text += figure_html(i, fmt::format("{}: operation {}", component, name), drawn);
    }
    return text;
}

}  // namespace

std::string counts_text(const Exploration& space) {
    const std::size_t count = space.states.size();
    const std::string states = fmt::format("{} state{}", count, count == 1 ? "" : "s");
    return space.limit.empty() ? states + ", all that can be reached"
                               : fmt::format("{}; {}; found and left out: {}", states, space.limit, space.left_out);
}

std::string step_page(const Exploration& space, const Stepped& stepped, const std::vector<driver::Part>& parts,
                      const RunRecord& run) {
    diagnostics::Budget drawing;  // a separate budget, so that the page is drawn even if a limit ended the exploration
    const PartDiagrams diagrams(parts, drawing);
    const std::vector<Instance> instances = instances_of(space);
    const Json data = Data(space, stepped, instances, diagrams).write();
    return page_text({stepped.name, "explorer.js",
                      fmt::format("<style>{}</style>\n{}{}", page_part("explorer.css"),
                                  Body(space, stepped).write(figures_of(space, instances, diagrams)),
                                  page_data("space", diagnostics::json_text(data))),
                      run});
}

}  // namespace robochart::app
