// SPDX-License-Identifier: Apache-2.0
// See monitor.hpp. The automaton is minimised by Moore's algorithm (1956). It is deterministic, and its missing arcs
// are violations.
#include "conformance/monitor/monitor.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <unordered_map>

#include "checker/lts/graph.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "conformance/model/provenance_text.hpp"
#include "cpp_emit/files/trace_names.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::conformance {

namespace {

using Node = refine::NormalForm::Node;
constexpr std::uint16_t dead = Monitor::dead;
constexpr std::size_t most_nodes = 1U << 20U;
constexpr std::size_t most_cells = 1U << 24U;

struct Arc {
    process::Event event;
    std::uint32_t target;
};

/// The deterministic automaton of NF_c(M), before minimisation.
struct Automaton {
    std::vector<std::vector<Arc>> arcs;              ///< by node, then by event
    std::vector<std::vector<std::string>> elements;  ///< by node, for nodes in which cycles begin

    [[nodiscard]] std::size_t size() const { return arcs.size(); }
};

std::vector<std::string> elements_of(CyclicModel& model, const refine::NormalForm& form, Node node,
                                     const diagnostics::SourceManager& sources) {
    std::vector<std::string> result;
    for (const lts::StateView state : form.states(node)) {
        if (lts::has_tau(model.normal_form(), state) || !model.normal_form().begins_cycle(state)) continue;
        const std::string text = model.normal_form().describe_model(state);
        for (std::string& element : elements_of_state(text, model.provenance(), sources))
            if (std::ranges::find(result, element) == result.end() && result.size() < 4)
                result.push_back(std::move(element));
    }
    return result;
}

Automaton explore_model(CyclicModel& model, refine::Budget& budget, const diagnostics::SourceManager& sources) {
    refine::NormalForm form(model.normal_form(), budget);
    Automaton result;
    std::unordered_map<Node, std::uint32_t> numbers;
    std::vector<Node> nodes;
    const auto number = [&](Node node) {
        const auto [place, fresh] = numbers.emplace(node, static_cast<std::uint32_t>(nodes.size()));
        if (fresh) nodes.push_back(node);
        return place->second;
    };
    number(form.initial());
    for (std::size_t at = 0; at < nodes.size(); ++at) {
        if (nodes.size() > most_nodes)
            throw std::length_error(fmt::format("the normal form has more than {} states", most_nodes));
        const Node node = nodes[at];
        std::vector<Arc>& arcs = result.arcs.emplace_back();
        for (const process::Event event : form.initials(node))
            arcs.push_back({event, number(*form.node_after(node, event))});
        result.elements.push_back(elements_of(model, form, node, sources));
    }
    return result;
}

/// Returns the class of each node. Two nodes in the same class allow the same runs.
std::vector<std::uint32_t> minimise_automaton(const Automaton& automaton, refine::Budget& budget) {
    std::vector<std::uint32_t> classes(automaton.size(), 0);
    for (std::size_t count = 0;;) {
        std::map<std::vector<Arc>, std::uint32_t, bool (*)(const std::vector<Arc>&, const std::vector<Arc>&)> known(
            [](const std::vector<Arc>& a, const std::vector<Arc>& b) {
                return std::lexicographical_compare(
                    a.begin(), a.end(), b.begin(), b.end(), [](const Arc& x, const Arc& y) {
                        return x.event != y.event ? x.event < y.event : x.target < y.target;
                    });
            });
        std::vector<std::uint32_t> next(automaton.size());
        for (std::size_t node = 0; node < automaton.size(); ++node) {
            budget.charge();
            std::vector<Arc> signature = automaton.arcs[node];
            for (Arc& arc : signature) arc.target = classes[arc.target];
            next[node] = known.emplace(std::move(signature), static_cast<std::uint32_t>(known.size())).first->second;
        }
        if (known.size() == count) return classes;
        count = known.size();
        classes = std::move(next);
    }
}

}  // namespace

/// Fills a MonitorBuild.
class MonitorBuilder {
public:
    MonitorBuilder(CyclicModel& model, const refine::Limits& limits, const diagnostics::SourceManager& sources)
        : model_(model), budget_(limits), sources_(sources), build_(new MonitorBuild) {}

    std::unique_ptr<MonitorBuild> make() {
        automaton_ = explore_model(model_, budget_, sources_);
        classes_ = minimise_automaton(automaton_, budget_);
        build_->nodes_ = static_cast<std::uint32_t>(automaton_.size());
        number_states();
        fill_table();
        add_channels();
        build_->component_ = model_.outside_interface().component;
        MonitorTables& tables = build_->tables_;
        tables.component = build_->component_.c_str();
        tables.cycle_length = model_.cycle_length();
        tables.next = build_->next_.data();
        tables.tock = column_of(model_.alphabet().tock());
        tables.tick = column_of(process::tick);
        tables.where = build_->where_.data();
        return std::move(build_);
    }

private:
    /// Numbers states in the order in which the search reached them, so that the first is the initial state.
    void number_states() {
        std::unordered_map<std::uint32_t, std::uint16_t> numbers;
        for (std::size_t node = 0; node < automaton_.size(); ++node) {
            const auto fresh = numbers.emplace(classes_[node], static_cast<std::uint16_t>(numbers.size()));
            if (numbers.size() >= dead) throw std::length_error("the monitor has more than 65,534 states");
            if (!fresh.second) continue;
            representatives_.push_back(static_cast<std::uint32_t>(node));
            add_place_text(node);
        }
        state_of_.resize(automaton_.size());
        for (std::size_t node = 0; node < automaton_.size(); ++node) state_of_[node] = numbers.at(classes_[node]);
    }

    void add_place_text(std::size_t node) {
        if (automaton_.elements[node].empty()) return build_->where_.push_back(nullptr);
        build_->texts_.push_back(fmt::format("{}", fmt::join(automaton_.elements[node], ", ")));
        build_->where_.push_back(build_->texts_.back().c_str());
    }

    /// Fills the columns. Events that lead from every state to the same state share a column.
    void fill_table() {
        std::map<process::Event, std::vector<std::uint16_t>> whole;
        for (std::uint16_t state = 0; state < representatives_.size(); ++state)
            for (const Arc& arc : automaton_.arcs[representatives_[state]]) {
                std::vector<std::uint16_t>& rows = whole[arc.event];
                if (rows.empty()) rows.assign(representatives_.size(), dead);
                rows[state] = state_of_[arc.target];
                if (whole.size() * representatives_.size() > most_cells)
                    throw std::length_error(fmt::format("the monitor's table has more than {} cells", most_cells));
            }
        std::map<std::vector<std::uint16_t>, std::uint16_t> distinct;
        for (const auto& [event, rows] : whole)
            columns_[event] = distinct.emplace(rows, static_cast<std::uint16_t>(distinct.size())).first->second;
        build_->tables_.states = static_cast<std::uint32_t>(representatives_.size());
        build_->tables_.columns = static_cast<std::uint32_t>(distinct.size());
        build_->next_.assign(representatives_.size() * distinct.size(), dead);
        for (const auto& [rows, number] : distinct)
            for (std::size_t state = 0; state < rows.size(); ++state)
                build_->next_[state * distinct.size() + number] = rows[state];
    }

    [[nodiscard]] std::uint16_t column_of(process::Event event) const {
        const auto found = columns_.find(event);
        return found == columns_.end() ? dead : found->second;
    }

    // ------------------------------------------------------------ channels

    void add_channels() {
        const Interface& interface = model_.interface();
        const auto inputs = cpp_emit::trace_names_of(model_.outside_interface().inputs);
        const auto outputs = cpp_emit::trace_names_of(model_.outside_interface().outputs);
        for (std::uint32_t i = 0; i < interface.inputs.size(); ++i) {
            MonitorBuild::Channel& channel = begin_channel(interface.inputs[i].name, inputs[i]);
            if (model_.boundary().input_types[i]) add_values(channel, *model_.boundary().input_types[i]);
            for (std::uint32_t r = 0; r < interface.inputs[i].reading_count(); ++r)
                channel.columns.push_back(column_of(model_.alphabet().read_event(i, r)));
            build_->inputs_.push_back(finish_channel(channel));
        }
        for (std::uint32_t o = 0; o < interface.outputs.size(); ++o) {
            MonitorBuild::Channel& channel = begin_channel(interface.outputs[o].name, outputs[o]);
            for (const ir::TypeId type : model_.boundary().output_types[o]) add_values(channel, type);
            std::vector<std::int64_t> arguments;
            add_columns(channel, o, arguments);
            build_->outputs_.push_back(finish_channel(channel));
        }
        build_->tables_.inputs = static_cast<std::uint32_t>(build_->inputs_.size());
        build_->tables_.outputs = static_cast<std::uint32_t>(build_->outputs_.size());
        build_->tables_.input = build_->inputs_.data();
        build_->tables_.output = build_->outputs_.data();
    }

    MonitorBuild::Channel& begin_channel(const std::string& name, const std::string& shown) {
        MonitorBuild::Channel& channel = build_->channels_.emplace_back();
        channel.name = shown;
        const auto found = model_.provenance().events.find(model_.interface().component + "::" + name);
        if (found != model_.provenance().events.end()) {
            const std::string place = sources_.path_and_line(found->second.origin.span);
            channel.element = place.empty() ? shown : fmt::format("{} ({})", shown, place);
        }
        return channel;
    }

    void add_values(MonitorBuild::Channel& channel, ir::TypeId type) const {
        const ir::TypeKind kind = model_.system().type(type).kind;
        std::vector<std::int64_t>& numbers = channel.numbers.emplace_back();
        for (const ir::Value& value : ir::carrier_values(model_.system(), model_.instantiation(), type)) {
            if (!value.parts.empty()) throw std::length_error("monitors take no values with parts");
            numbers.push_back(value.number);
        }
        const bool real = kind == ir::TypeKind::real;
        bool consecutive = !numbers.empty();
        for (std::size_t i = 0; i < numbers.size(); ++i)
            consecutive = consecutive && numbers[i] == numbers[0] + static_cast<std::int64_t>(i);
        channel.values.push_back({numbers.data(), static_cast<std::uint32_t>(numbers.size()),
                                  real ? model_.interface().scale : 1, consecutive,
                                  model_.boundary().numbers.uses.is_independent(kind)});
    }

    /// Adds a column for each combination of arguments. Recursion depth: the number of an output's arguments.
    void add_columns(MonitorBuild::Channel& channel, std::uint32_t output, std::vector<std::int64_t>& arguments) const {
        constexpr std::size_t most = 1U << 16U;
        if (channel.columns.size() > most) throw std::length_error(channel.name + " has too many values together");
        if (arguments.size() == channel.values.size()) {
            channel.columns.push_back(column_of(model_.alphabet().write_event(output, arguments)));
            return;
        }
        for (const std::int64_t number : channel.numbers[arguments.size()]) {
            arguments.push_back(number);
            add_columns(channel, output, arguments);
            arguments.pop_back();
        }
    }

    static MonitorChannel finish_channel(const MonitorBuild::Channel& channel) {
        return {channel.name.c_str(), channel.element.c_str(), channel.values.data(),
                static_cast<std::uint32_t>(channel.values.size()), channel.columns.data()};
    }

    CyclicModel& model_;
    refine::Budget budget_;
    const diagnostics::SourceManager& sources_;
    std::unique_ptr<MonitorBuild> build_;
    Automaton automaton_;
    std::vector<std::uint32_t> classes_;
    std::vector<std::uint32_t> representatives_;  ///< by state: a node
    std::vector<std::uint16_t> state_of_;         ///< by node
    std::map<process::Event, std::uint16_t> columns_;
};

std::unique_ptr<MonitorBuild> MonitorBuild::make(CyclicModel& model, const refine::Limits& limits,
                                                 const diagnostics::SourceManager& sources) {
    return MonitorBuilder(model, limits, sources).make();
}

}  // namespace robochart::conformance
