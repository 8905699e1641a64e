// SPDX-License-Identifier: Apache-2.0
// Computes live variables (Aho, Sethi, Ullman 1986, 10.6) on the graph of NF_c(M); names take the place of variables.
// Reading a register defines the names in it. A write uses the names in it.
#include "conformance/check/live_names.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <string>

#include "checker/lts/graph.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/search/poll_guard.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::conformance {

namespace {

/// Finds the names in the events of NF_c(M).
class EventNames {
public:
    struct Names {
        RepresentedParts read;
        NameSet written = 0;
    };

    EventNames(const CyclicModel& model, const Representatives& few) : model_(model), few_(few) {
        for (const NameSet names : names_by_type(few)) all_ |= names;
    }

    const Names& names_of(process::Event event) {
        const auto [place, fresh] = known_.try_emplace(event);
        if (fresh) place->second = find_names(event);
        return place->second;
    }

private:
    using ByText = std::map<std::string, RepresentedParts>;

    Names find_names(process::Event event) {
        const CycleRole role = model_.alphabet().cycle_role(event);
        switch (role.kind) {
            case CycleRole::Kind::read:
                return {parts_of_reading(role), 0};
            case CycleRole::Kind::write:
                return {nothing(), names_of_write(event, role.index)};
            case CycleRole::Kind::tock:
            case CycleRole::Kind::tick:
            case CycleRole::Kind::other:
                break;
        }
        return {nothing(), 0};
    }

    [[nodiscard]] RepresentedParts nothing() const { return {0, std::vector<std::size_t>(few_.types.size(), 0)}; }

    RepresentedParts parts_of_reading(const CycleRole& role) {
        const std::optional<ir::TypeId>& type = model_.boundary().input_types[role.index];
        if (role.reading == 0 || !type || !is_represented(model_.system(), few_, *type)) return nothing();
        return values_of(*type).at(model_.interface().inputs[role.index].texts[role.reading - 1]);
    }

    /// Returns the names in a write. If a text is no value of its type, returns all names. The final result may then be
    /// too large, which is sound, but never too small.
    NameSet names_of_write(process::Event event, std::uint32_t output) {
        const std::vector<std::string> arguments = model_.alphabet().written_arguments(event);
        const std::vector<ir::TypeId>& types = model_.boundary().output_types[output];
        if (arguments.size() != types.size()) return all_;
        NameSet names = 0;
        for (std::size_t i = 0; i < types.size(); ++i) {
            if (!is_represented(model_.system(), few_, types[i])) continue;
            const ByText& values = values_of(types[i]);
            const auto found = values.find(arguments[i]);
            if (found == values.end()) return all_;
            names |= found->second.names;
        }
        return names;
    }

    /// Returns the values of the type by their texts in events.
    const ByText& values_of(ir::TypeId type) {
        const auto [place, fresh] = by_type_.try_emplace(type.index);
        if (!fresh) return place->second;
        for (const ir::Value& value : ir::carrier_values(model_.system(), few_.instantiation, type))
            place->second.emplace(cpp_emit::cspm_value(model_.system(), type, value),
                                  represented_parts(model_.system(), few_, type, value));
        return place->second;
    }

    const CyclicModel& model_;
    const Representatives& few_;
    NameSet all_ = 0;
    std::map<std::uint32_t, ByText> by_type_;
    std::map<process::Event, Names> known_;
};

/// Returns which names are live in each state. This is the least solution of the equations of the analysis.
std::vector<NameSet> live_names(const lts::Graph& graph, EventNames& events, refine::Budget& budget) {
    std::vector<NameSet> live(graph.size(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t state = graph.size(); state-- > 0;) {
            budget.charge();
            NameSet names = 0;
            for (const lts::Edge& edge : graph.edges(static_cast<lts::StateIndex>(state))) {
                const EventNames::Names& event = events.names_of(edge.event);
                names |= event.written | (live[edge.target] & ~event.read.names);
            }
            changed = changed || names != live[state];
            live[state] = names;
        }
    }
    return live;
}

/// Follows the traces of the normal form that read only names which are not live.
class DistinctTraces {
public:
    DistinctTraces(const lts::Graph& graph, const std::vector<NameSet>& live, EventNames& events,
                   const Representatives& few, const process::EventTable& table, refine::Budget& budget)
        : live_(live),
          events_(events),
          types_(names_by_type(few)),
          system_(graph, table),
          nodes_(system_, budget),
          budget_(budget),
          most_(types_.size(), 0) {}

    std::vector<std::size_t> most_live() {
        add(nodes_.initial());
        for (std::size_t at = 0; at < open_.size(); ++at) visit(open_[at]);
        return most_;
    }

private:
    void add(refine::NormalForm::Node node) {
        seen_.resize(nodes_.size(), false);
        if (seen_[node]) return;
        seen_[node] = true;
        open_.push_back(node);
        budget_.states(live_.size() + open_.size());
    }

    void visit(refine::NormalForm::Node node) {
        NameSet names = 0;
        for (const lts::StateView state : nodes_.states(node)) names |= live_[state[0]];
        for (std::size_t type = 0; type < types_.size(); ++type)
            most_[type] = std::max(most_[type], count(names & types_[type]));
        for (const process::Event event : nodes_.initials(node))
            if (reads_only_new_names(events_.names_of(event).read, names)) add(*nodes_.node_after(node, event));
    }

    bool reads_only_new_names(const RepresentedParts& read, NameSet live) {
        std::size_t parts = 0;
        for (std::size_t type = 0; type < types_.size(); ++type) {
            parts += read.counts[type];
            if (read.counts[type] > 0)
                most_[type] = std::max(most_[type], count(live & types_[type]) + read.counts[type]);
        }
        return count(read.names) == parts && (read.names & live) == 0;
    }

    static std::size_t count(NameSet names) { return static_cast<std::size_t>(std::popcount(names)); }

    const std::vector<NameSet>& live_;
    EventNames& events_;
    std::vector<NameSet> types_;
    lts::GraphSystem system_;
    refine::NormalForm nodes_;
    refine::Budget& budget_;
    std::vector<std::size_t> most_;
    std::vector<refine::NormalForm::Node> open_;
    std::vector<bool> seen_;
};

}  // namespace

std::vector<std::size_t> most_live_names(CyclicModel& model, const Representatives& few, const refine::Limits& limits) {
    refine::Budget budget(limits);
    const refine::PollGuard guard({&model.normal_form()}, budget);
    const lts::Exploration all = lts::explore(model.normal_form(), [&](std::size_t states) {
        budget.charge();
        budget.states(states);
    });
    EventNames events(model, few);
    const std::vector<NameSet> live = live_names(all.graph, events, budget);
    return DistinctTraces(all.graph, live, events, few, model.alphabet().events(), budget).most_live();
}

}  // namespace robochart::conformance
