// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/compiler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "base/diagnostics/containers.hpp"
#include "checker/lts/bisimulation.hpp"
#include "checker/lts/state_store.hpp"
#include "checker/machine/explicit_machine.hpp"
#include "checker/machine/not_compiled.hpp"
#include "checker/machine/unminimised_system.hpp"
#include "checker/process/operators.hpp"
#include "checker/process/refusal.hpp"

namespace robochart::machine {
namespace {

/// Explores the reachable states of a term in breadth-first order.
class Exploration {
public:
    /// Stores the number of states found so far in `states`.
    Exploration(process::OperationalSemantics& semantics, std::size_t most_states, std::size_t& states)
        : semantics_(semantics), most_states_(most_states), states_(states) {}

    void run(TermId initial, diagnostics::Pollable& budget) {
        number_term(initial);
        for (std::size_t state = 0; state < found.meaning.size(); ++state) {
            states_ = found.meaning.size();
            budget.poll();
            auto& row = found.rows.emplace_back();
            for (const process::Transition& step : semantics_.successors(found.meaning[state]))
                row.push_back({step.event, step.revealed, number_term(step.target)});
        }
    }

    ExplicitMachine found;

private:
    Local number_term(TermId term) {
        const auto [entry, fresh] = numbers_.emplace(static_cast<std::uint32_t>(term), found.meaning.size());
        if (fresh) found.meaning.push_back(term);
        if (found.meaning.size() > most_states_) throw NotCompiled("a component has too many states");
        return entry->second;
    }

    process::OperationalSemantics& semantics_;
    std::size_t most_states_;
    std::size_t& states_;
    std::unordered_map<std::uint32_t, Local> numbers_;
};

/// Collects the states of a compiled process in breadth-first order. Keeps the names of hidden events.
class RowCollector final : private lts::SuccessorSink {
public:
    RowCollector(lts::TransitionSystem& system, TermId meaning, std::size_t most_states)
        : system_(system), meaning_(meaning), most_states_(most_states), states_(system.width()) {}

    ExplicitMachine run(diagnostics::Pollable& budget) {
        std::vector<lts::Word> initial(system_.width());
        system_.initial(initial);
        states_.insert(initial);
        for (lts::StateIndex state = 0; state < states_.size(); ++state) {
            budget.poll();
            if (states_.size() > most_states_)
                throw process::TooManyStates(fmt::format("more than {} states", most_states_));
            found_.meaning.push_back(meaning_);
            auto& row = found_.rows.emplace_back();
            system_.successors(states_[state], *this);
            std::ranges::stable_sort(row, [](const auto& a, const auto& b) { return a.event < b.event; });
        }
        return std::move(found_);
    }

private:
    void add(Event event, lts::StateView target, Event revealed) override {
        found_.rows.back().push_back({event, revealed, static_cast<Local>(states_.insert(target).index)});
    }

    lts::TransitionSystem& system_;
    TermId meaning_;
    std::size_t most_states_;
    lts::StateStore states_;
    ExplicitMachine found_;
};

/// Up to this number of prefixes, the compiler splits them without a test whether this saves states.
constexpr std::size_t few_prefixes = 16;
/// If a process needs many components but has at most this many states, it becomes one component.
constexpr std::size_t few_states = 1000;

/// Returns the machine without the names of hidden events. Compressions do not depend on them.
process::Machine without_names(const ExplicitMachine& explicit_machine) {
    process::Machine machine{{}, explicit_machine.meaning};
    for (const auto& row : explicit_machine.rows) {
        auto& edges = machine.edges.emplace_back();
        for (const Component::RawEdge& edge : row) edges.push_back({edge.event, edge.target});
        const auto key = [](const auto& edge) { return std::pair(edge.event, edge.target); };
        std::ranges::sort(edges, [&](const auto& a, const auto& b) { return key(a) < key(b); });
    }
    return machine;
}

/// Returns, for each component, which of its events occur in a rule.
std::vector<std::vector<bool>> used_events(const Supercombinator& combined) {
    std::vector<std::vector<bool>> used;
    for (const ComponentPtr& component : combined.components) used.emplace_back(component->alphabet().size(), false);
    for (const Region& region : combined.regions) {
        const auto use = [&](const Participant& who, std::uint32_t event) {
            if (!who.is_region) used[who.index][event] = true;
        };
        for (const Requirement& requirement : region.requirements)
            use(region.participants[requirement.participant], requirement.event);
        for (std::size_t who = 0; who < region.participants.size(); ++who)
            for (std::uint32_t event = 0; event < region.alphabets[who].size(); ++event)
                if (region.first_rule[who][event] < region.first_rule[who][event + 1U])
                    use(region.participants[who], event);
    }
    return used;
}

/// Counts the active calls of a recursive function.
class DepthGuard {
public:
    explicit DepthGuard(std::size_t& depth) : depth_(depth) { ++depth_; }
    DepthGuard(const DepthGuard&) = delete;
    DepthGuard& operator=(const DepthGuard&) = delete;
    ~DepthGuard() { --depth_; }

private:
    std::size_t& depth_;
};

/// Returns the events on which operands synchronise, with tau and tick. Returns no value if the skeleton has operators
/// other than parallel, or operands that are compressed themselves.
std::optional<EventSet> synchronised_events(const process::TermStore& terms, const Skeleton& skeleton) {
    EventSet joint{process::tau, process::tick};
    for (const Node& node : skeleton.nodes) {
        if (node.kind == Node::Kind::leaf && node.op != Op::compress) continue;
        if (node.kind != Node::Kind::operation || node.op != Op::parallel) return std::nullopt;
        const EventSet& set = terms[process::SetId{terms[node.term].payload}];
        joint.insert(joint.end(), set.begin(), set.end());
    }
    return joint;
}

/// Adds the events that occur in several components to the synchronised events.
EventSet shared_events(const std::vector<ComponentPtr>& components, const EventSet& joint) {
    EventSet all;
    for (const ComponentPtr& component : components)
        all.insert(all.end(), component->alphabet().begin(), component->alphabet().end());
    std::ranges::sort(all);
    EventSet shared = joint;
    for (auto next = std::ranges::adjacent_find(all); next != all.end(); next = std::adjacent_find(next + 1, all.end()))
        shared.push_back(*next);
    diagnostics::sort_unique(shared);
    return shared;
}

/// Returns true if the component has no tau, and if no two of the states that private events reach are bisimilar with
/// respect to private events. At most `most_others` states are not reached by private events.
bool private_events_distinguish(const Component& component, const EventSet& shared, diagnostics::Pollable& budget) {
    constexpr std::size_t most_others = 4;
    if (component.alphabet().empty() || component.alphabet().front() == process::tau) return false;
    lts::Graph graph;
    for (Local state = 0; state < component.size(); ++state) {
        for (const Component::Edge& edge : component.edges(state)) {
            const Event event = component.alphabet()[edge.event];
            if (!std::ranges::binary_search(shared, event)) graph.add_edge({event, edge.target});
        }
        graph.finish_state();
    }
    const lts::Quotient quotient = lts::minimise(graph, lts::Equivalence::strong, budget);
    const auto reached = static_cast<std::size_t>(
        std::ranges::count_if(quotient.state_of, [](lts::StateIndex state) { return state != lts::no_state; }));
    return quotient.graph.size() == reached && component.size() - reached <= most_others;
}

ComponentPtr component_of(process::Machine machine) {
    std::vector<std::vector<Component::RawEdge>> rows;
    for (const auto& edges : machine.edges) {
        auto& row = rows.emplace_back();
        for (const process::Machine::Edge& edge : edges) row.push_back({edge.event, edge.event, edge.target});
    }
    return std::make_shared<const Component>(rows, std::move(machine.meaning));
}

/// Returns the operands of parallel operators that hide events somewhere inside. Of nested ones, returns the outermost.
std::vector<TermId> hiding_operands(const Skeleton& skeleton) {
    std::vector<bool> hides(skeleton.nodes.size());
    for (std::size_t id = skeleton.nodes.size(); id-- > 0;) {  // children come after their parents
        const Node& node = skeleton.nodes[id];
        hides[id] = node.kind == Node::Kind::operation &&
                    (node.op == Op::hide || std::ranges::any_of(node.children, [&](NodeId i) { return hides[i]; }));
    }
    std::vector<TermId> result;
    std::vector<NodeId> open{0};
    while (!open.empty()) {
        const Node& node = skeleton.nodes[open.back()];
        open.pop_back();
        const bool parallel = process::properties_of(node.op).group == process::OpGroup::parallel;
        for (const NodeId child : node.children) {
            if (!hides[child]) continue;
            if (parallel)
                result.push_back(skeleton.nodes[child].term);
            else
                open.push_back(child);
        }
    }
    return result;
}

}  // namespace

Compiler::Compiler(process::OperationalSemantics& semantics, const Bounds& bounds)
    : semantics_(semantics), bounds_(bounds) {}

/// Explores a term and minimises the result. The machine of a compression needs no minimisation: no two of its states
/// are branching bisimilar, so no two of them are strongly bisimilar.
ComponentPtr Compiler::explore_component(TermId term, diagnostics::Pollable& budget) {
    Exploration exploration(semantics_, bounds_.component_states, stage_.states);
    stage_.component = term;
    const std::optional<TermId> first = semantics_.first_machine_state(term);
    exploration.run(first.value_or(term), budget);
    if (!first) return minimise_component(std::move(exploration.found), budget);
    return std::make_shared<const Component>(exploration.found.rows, std::move(exploration.found.meaning));
}

ComponentPtr Compiler::minimise_component(ExplicitMachine machine, diagnostics::Pollable& budget) const {
    if (machine.rows.size() <= bounds_.minimised_states) minimise(machine, budget);
    return std::make_shared<const Component>(machine.rows, std::move(machine.meaning));
}

/// Removes edges of components that no rule uses. Returns true if a component has become smaller.
bool Compiler::prune_unused_edges(const Supercombinator& combined, std::vector<ComponentPtr>& components,
                                  diagnostics::Pollable& budget) const {
    const std::vector<std::vector<bool>> used = used_events(combined);
    bool smaller = false;
    for (std::size_t slot = 0; slot < components.size(); ++slot) {
        if (std::ranges::find(used[slot], false) == used[slot].end()) continue;
        components[slot] = minimise_component(without_unused(*components[slot], used[slot]), budget);
        smaller = true;
    }
    return smaller;
}

ComponentPtr Compiler::component(TermId term, diagnostics::Pollable& budget) {
    const auto known = components_.find(term);
    if (known != components_.end()) return known->second;
    return components_[term] = explore_component(term, budget);
}

/// Returns true if the term reaches few states. Its transitions are then cached, so this work is not lost.
bool Compiler::is_small(TermId term, diagnostics::Pollable& budget) {
    std::size_t states = 0;
    try {
        Exploration(semantics_, few_states, states).run(term, budget);
        return true;
    } catch (const NotCompiled&) {
        return false;
    }
}

/// Returns the gate of an operator (see combine.cpp). It has one state, and a loop for each event with which the
/// operator can start.
ComponentPtr Compiler::make_gate(const Node& node) const {
    process::TermStore& terms = semantics_.terms();
    std::vector<Component::RawEdge> row;
    if (node.op == Op::prefix) {
        const std::uint32_t payload = terms[node.term].payload;
        for (const process::Branch& branch : terms.branches(payload)) row.push_back({branch.event, branch.event, 0});
        const auto less = [](const auto& a, const auto& b) { return a.event < b.event; };
        const auto same = [](const auto& a, const auto& b) { return a.event == b.event; };
        std::ranges::sort(row, less);
        diagnostics::erase_repeated(row, same);
    } else {
        row.push_back({process::tau, process::tau, 0});
    }
    return std::make_shared<const Component>(std::vector<std::vector<Component::RawEdge>>{row},
                                             std::vector<TermId>{node.term});
}

std::vector<ComponentPtr> Compiler::components(const Skeleton& skeleton, diagnostics::Pollable& budget) {
    std::vector<ComponentPtr> result;
    for (NodeId id : skeleton.slots) {
        const Node& node = skeleton.nodes[id];
        stage_ = {node.term, result.size() + 1, skeleton.slots.size(), 0};
        result.push_back(node.kind == Node::Kind::gate ? make_gate(node) : component(node.term, budget));
    }
    return result;
}

/// Builds the skeleton. Compressions whose operands are too large are left out. To find them, compresses each candidate
/// before it becomes a component.
std::optional<Skeleton> Compiler::skeleton(TermId term, const std::set<TermId>& leaves, diagnostics::Pollable& budget) {
    constexpr int deepest_call = 100;
    process::TermStore& terms = semantics_.terms();
    for (;;) {
        std::set<TermId> omitted = semantics_.left_out();
        if (operands_ > 0) omitted.insert(kept_apart_.begin(), kept_apart_.end());
        std::optional<Skeleton> result = skeleton_of(terms, term, leaves, omitted, budget);
        const std::size_t before = semantics_.left_out().size() + kept_apart_.size();
        const auto attempt = [&](TermId candidate) {
            if (terms[candidate].op != Op::compress) return;
            if (operands_ > 0 && judged_.insert(candidate).second && has_independent_parts(candidate, budget))
                kept_apart_.insert(candidate);
            else
                semantics_.successors(candidate);
        };
        if (result) {
            for (NodeId id : result->slots) attempt(result->nodes[id].term);
        } else {
            attempt(terms.unfold_calls(term, deepest_call));
        }
        if (semantics_.left_out().size() + kept_apart_.size() == before) return result;
    }
}

/// Returns true if the machine of a compressed term would have as many states as the vectors of states of the operand's
/// components, up to states after a joint event. The components are then kept apart in an operand of an enclosing
/// compression: together they have fewer transitions, and each of them is pruned separately. The quotient of the
/// enclosing compression is the same.
///
/// This is the case if parallel operators alone combine the components, no component has a tau, and in each component
/// the private events distinguish the states that they lead to. *Proof.* A private event occurs in one component and in
/// no synchronisation set, so a vector can perform it exactly if its component can, and it changes only this component.
/// If two vectors are bisimilar, then for each component, their states are bisimilar in the component restricted to its
/// private events. So these states are equal. Without taus, branching bisimilarity is strong bisimilarity.
bool Compiler::has_independent_parts(TermId compressed, diagnostics::Pollable& budget) {
    using process::Compression;
    const process::Term& term = semantics_.terms()[compressed];
    const Compression kind{term.payload};
    if (kind == Compression::deter || kind == Compression::trace_watchdog || kind == Compression::failure_watchdog)
        return false;  // the semantics does not support them
    const TermId operand = term.children.front();
    return process::unless_refused([&] {
        const std::optional<Skeleton> skeleton =
            skeleton_of(semantics_.terms(), operand, {}, semantics_.left_out(), budget);
        if (!skeleton) return false;
        const std::optional<EventSet> joint = synchronised_events(semantics_.terms(), *skeleton);
        if (!joint) return false;
        const std::vector<ComponentPtr> parts = components(*skeleton, budget);
        double states = 1;
        for (const ComponentPtr& part : parts) states *= static_cast<double>(part->size());
        const EventSet shared = shared_events(parts, *joint);
        return states >= static_cast<double>(few_states) && std::ranges::all_of(parts, [&](const ComponentPtr& part) {
                   return private_events_distinguish(*part, shared, budget);
               });
    });
}

/// Returns the terms of prioritise inside the process whose components together have few states, outermost first.
std::set<TermId> Compiler::small_regions(const Skeleton& skeleton, const std::vector<ComponentPtr>& components) const {
    std::set<TermId> result;
    for (const Node& node : skeleton.nodes) {
        const bool inside = &node != &skeleton.nodes.front() && node.term != skeleton.nodes.front().term;
        if (!inside || node.kind != Node::Kind::operation || node.op != Op::prioritise) continue;
        double states = 1;
        for (std::uint32_t slot = node.first_slot; slot < node.end_slot; ++slot)
            states *= static_cast<double>(components[slot]->size() + 1);
        if (states <= static_cast<double>(bounds_.region_states)) result.insert(node.term);
    }
    return result;
}

/// Explores a whole compiled process and returns it as one component.
ComponentPtr Compiler::region(TermId term, diagnostics::Pollable& budget) {
    if (const auto known = components_.find(term); known != components_.end()) return known->second;
    const auto system = compile(term, budget);
    if (!system) return component(term, budget);
    regions_.insert(term);
    return components_[term] =
               minimise_component(RowCollector(*system, term, bounds_.compressed_states).run(budget), budget);
}

/// Adds the largest parts of the process that can be compressed. A part is an operand of a parallel operator, and hides
/// events. If an operand has too many states, searches it for smaller parts.
void Compiler::find_parts(TermId term, std::set<TermId>& parts, diagnostics::Pollable& budget) {
    constexpr std::size_t deepest_part = 50;
    const DepthGuard guard(depth_of_parts_);
    if (depth_of_parts_ > deepest_part) return;
    const std::optional<Skeleton> skeleton = this->skeleton(term, parts, budget);
    if (!skeleton) return;
    for (const TermId operand : hiding_operands(*skeleton)) {
        if (compress_part(operand, budget))
            parts.insert(operand);
        else
            find_parts(operand, parts, budget);
    }
}

void Compiler::compress_parts(TermId term, diagnostics::Pollable& budget) {
    process::unless_refused([&] {
        std::set<TermId> parts;
        find_parts(term, parts, budget);
        return true;
    });
}

/// Replaces the part by one component: its quotient under branching bisimilarity with explicit divergence. This
/// equivalence is a congruence for all operators above the part (bisimulation.hpp). Returns false if the part has too
/// many states, if all parts so far together have too many, or if the part already is one component.
bool Compiler::compress_part(TermId term, diagnostics::Pollable& budget) {
    if (const auto known = parts_.find(term); known != parts_.end()) return known->second;
    if (states_of_parts_ > bounds_.part_states || components_.contains(term)) return false;
    parts_[term] = false;
    try {
        const auto explored = explore(term, lts::Equivalence::branching_with_divergence, budget);
        if (!explored) return false;
        states_of_parts_ += explored->meaning.size();
        components_[term] =
            component_of(process::BisimulationCompressor().compress(*explored, process::Compression::dbisim, budget));
        shrinkage_ *= static_cast<double>(explored->meaning.size()) / static_cast<double>(components_[term]->size());
    } catch (const process::TooManyStates&) {
        states_of_parts_ += bounds_.compressed_states;
        return false;
    }
    return parts_[term] = true;
}

void Compiler::add_components_of(const Compiler& other) {
    for (const auto& [term, component] : other.components_)
        if (!other.regions_.contains(term)) components_.emplace(term, component);
}

bool Compiler::has_compressed_parts() const {
    return std::ranges::any_of(parts_, [](const auto& part) { return part.second; });
}

/// Returns the component before it was minimised. The components inside a region are not minimised either.
ComponentPtr Compiler::unminimised_component(const Node& node, diagnostics::Pollable& budget) {
    if (node.kind == Node::Kind::gate) return make_gate(node);
    ExplicitMachine machine;
    const auto compiled = regions_.contains(node.term) ? compile(node.term, budget) : nullptr;
    if (compiled) {
        const auto finer = compiled->make_finer_system(budget);
        lts::TransitionSystem& explored = finer ? static_cast<lts::TransitionSystem&>(*finer) : *compiled;
        machine = RowCollector(explored, node.term, bounds_.compressed_states).run(budget);
    } else {
        std::size_t states = 0;
        Exploration exploration(semantics_, bounds_.component_states, states);
        exploration.run(node.term, budget);
        machine = std::move(exploration.found);
    }
    return std::make_shared<const Component>(machine.rows, std::move(machine.meaning));
}

std::unique_ptr<lts::FinerSystem> Compiler::finer_system(const Skeleton& skeleton,
                                                         const std::shared_ptr<const Supercombinator>& minimised,
                                                         diagnostics::Pollable& budget) {
    std::vector<ComponentPtr> components;
    std::vector<StateMap> maps;
    for (std::size_t slot = 0; slot < skeleton.slots.size(); ++slot) {
        components.push_back(unminimised_component(skeleton.nodes[skeleton.slots[slot]], budget));
        std::optional<StateMap> map = StateMap::make(*components.back(), *minimised->components[slot], budget);
        if (!map) return nullptr;
        maps.push_back(std::move(*map));
    }
    Supercombinator combined = combine(semantics_.terms(), skeleton, std::move(components), bounds_.rules, budget);
    list_leading(combined, budget);
    return std::make_unique<UnminimisedSystem>(std::make_shared<const Supercombinator>(std::move(combined)), minimised,
                                               std::move(maps), semantics_.terms());
}

std::unique_ptr<SupercombinatorSystem> Compiler::compile(TermId term, diagnostics::Pollable& budget) {
    stage_ = {};
    return process::unless_refused([&]() -> std::unique_ptr<SupercombinatorSystem> {
        std::set<TermId> leaves;
        if (bounds_.compress_parts) find_parts(term, leaves, budget);
        std::optional<Skeleton> skeleton = this->skeleton(term, leaves, budget);
        if (!skeleton || (skeleton->prefixes > few_prefixes && is_small(term, budget))) return nullptr;
        std::vector<ComponentPtr> components = this->components(*skeleton, budget);
        const std::set<TermId> regions = small_regions(*skeleton, components);
        for (const TermId prioritised : regions) region(prioritised, budget);
        leaves.insert(regions.begin(), regions.end());
        if (auto simpler = this->skeleton(term, leaves, budget)) {
            skeleton = std::move(simpler);
            components = this->components(*skeleton, budget);
        }
        return combine_components(std::move(*skeleton), std::move(components), budget);
    });
}

std::unique_ptr<SupercombinatorSystem> Compiler::combine_components(Skeleton skeleton,
                                                                    std::vector<ComponentPtr> components,
                                                                    diagnostics::Pollable& budget) {
    process::TermStore& terms = semantics_.terms();
    Supercombinator combined = combine(terms, skeleton, components, bounds_.rules, budget);
    while (prune_unused_edges(combined, components, budget))
        combined = combine(terms, skeleton, components, bounds_.rules, budget);
    list_leading(combined, budget);
    const auto minimised = std::make_shared<const Supercombinator>(std::move(combined));
    auto system = std::make_unique<SupercombinatorSystem>(minimised, terms);
    if (bounds_.minimised_states == 0 || bounds_.compress_parts) return system;
    const auto operators = std::make_shared<const Skeleton>(std::move(skeleton));
    system->set_finer_system([this, operators, minimised](diagnostics::Pollable& polled) {
        return process::unless_refused([&] { return finer_system(*operators, minimised, polled); });
    });
    return system;
}

std::optional<process::Machine> Compiler::explore(TermId term, lts::Equivalence up_to, diagnostics::Pollable& budget) {
    const auto system = compile(term, budget);
    if (!system) return std::nullopt;
    const auto reduced =
        up_to == lts::Equivalence::strong ? nullptr : system->make_reduced_system(lts::Followed::taus, budget);
    lts::TransitionSystem& explored = reduced ? static_cast<lts::TransitionSystem&>(*reduced) : *system;
    return without_names(RowCollector(explored, term, bounds_.compressed_states).run(budget));
}

std::optional<process::Machine> Compiler::explore_operand(TermId term, lts::Equivalence up_to,
                                                          diagnostics::Pollable& budget) {
    const DepthGuard guard(operands_);
    return explore(term, up_to, budget);
}

std::optional<process::Machine> MachineCompressor::explore(TermId operand, process::Compression kind,
                                                           diagnostics::Pollable& budget) {
    return compiler_ == nullptr ? std::nullopt
                                : compiler_->explore_operand(operand, process::equivalence_of(kind), budget);
}

}  // namespace robochart::machine
