#include "checker/machine/compiler.hpp"

#include <algorithm>
#include <new>
#include <unordered_map>

#include "checker/lts/bisimulation.hpp"
#include "checker/machine/not_compiled.hpp"

namespace robochart::machine {
namespace {

using Rows = std::vector<std::vector<Component::RawEdge>>;

/// The states that a term reaches, breadth first.
class Exploration {
public:
    Exploration(process::OperationalSemantics& semantics, std::size_t most_states)
        : semantics_(semantics), most_states_(most_states) {}

    void run(TermId initial, const std::function<void()>& poll) {
        number(initial);
        for (std::size_t state = 0; state < meaning.size(); ++state) {
            if (poll) poll();
            auto& row = rows.emplace_back();
            for (const process::Transition& step : semantics_.successors(meaning[state]))
                row.push_back({step.event, step.revealed, number(step.target)});
        }
    }

    Rows rows;
    std::vector<TermId> meaning;

private:
    Local number(TermId term) {
        const auto [entry, fresh] = numbers_.emplace(static_cast<std::uint32_t>(term), meaning.size());
        if (fresh) meaning.push_back(term);
        if (meaning.size() > most_states_) throw NotCompiled("a component has too many states");
        return entry->second;
    }

    process::OperationalSemantics& semantics_;
    std::size_t most_states_;
    std::unordered_map<std::uint32_t, Local> numbers_;
};

/// The quotient by strong bisimilarity, with the hidden names of the states that stand for the others.
void minimise(Exploration& explored) {
    lts::Graph graph;
    for (const auto& row : explored.rows) {
        for (const Component::RawEdge& edge : row) graph.add_edge({edge.event, edge.target});
        graph.finish_state();
    }
    const lts::Quotient quotient = lts::minimise(graph, lts::Equivalence::strong);
    if (quotient.graph.size() == explored.rows.size()) return;
    Rows rows;
    std::vector<TermId> meaning;
    for (const lts::StateIndex state : quotient.representative) {
        meaning.push_back(explored.meaning[state]);
        std::vector<Component::RawEdge> row = explored.rows[state];
        for (Component::RawEdge& edge : row) edge.target = quotient.state_of[edge.target];
        const auto key = [](const Component::RawEdge& edge) { return std::pair(edge.event, edge.target); };
        std::stable_sort(row.begin(), row.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
        const auto same = [&](const auto& a, const auto& b) { return key(a) == key(b); };
        row.erase(std::unique(row.begin(), row.end(), same), row.end());
        rows.push_back(std::move(row));
    }
    explored.rows = std::move(rows);
    explored.meaning = std::move(meaning);
}

}  // namespace

Compiler::Compiler(process::OperationalSemantics& semantics, const Bounds& bounds)
    : semantics_(semantics), bounds_(bounds) {}

ComponentPtr Compiler::explored(TermId term, const std::function<void()>& poll) {
    Exploration exploration(semantics_, bounds_.component_states);
    stage_.component = term;
    exploration.run(term, [&] {
        stage_.states = exploration.meaning.size();
        if (poll) poll();
    });
    if (exploration.rows.size() <= bounds_.minimised_states) minimise(exploration);
    return std::make_shared<const Component>(exploration.rows, std::move(exploration.meaning));
}

ComponentPtr Compiler::component(TermId term, const std::function<void()>& poll) {
    const auto known = components_.find(term);
    if (known != components_.end()) return known->second;
    return components_[term] = explored(term, poll);
}

/// One state with a loop for every first event of the operator (see combine.cpp, gated).
ComponentPtr Compiler::gate(const Node& node) const {
    process::TermStore& terms = semantics_.terms();
    std::vector<Component::RawEdge> row;
    if (node.op == Op::prefix) {
        const std::uint32_t payload = terms[node.term].payload;
        for (const process::Branch& branch : terms.branches(payload)) row.push_back({branch.event, branch.event, 0});
        const auto less = [](const auto& a, const auto& b) { return a.event < b.event; };
        const auto same = [](const auto& a, const auto& b) { return a.event == b.event; };
        std::sort(row.begin(), row.end(), less);
        row.erase(std::unique(row.begin(), row.end(), same), row.end());
    } else {
        row.push_back({process::tau, process::tau, 0});
    }
    return std::make_shared<const Component>(Rows{row}, std::vector<TermId>{node.term});
}

std::unique_ptr<SupercombinatorSystem> Compiler::compile(TermId term, const std::function<void()>& poll) {
    process::TermStore& terms = semantics_.terms();
    try {
        const std::optional<Skeleton> skeleton = skeleton_of(terms, term);
        if (!skeleton) return nullptr;
        std::vector<ComponentPtr> components;
        for (NodeId id : skeleton->slots) {
            const Node& node = skeleton->nodes[id];
            stage_ = {node.term, components.size() + 1, skeleton->slots.size(), 0};
            components.push_back(node.kind == Node::Kind::gate ? gate(node) : component(node.term, poll));
        }
        auto combined =
            std::make_shared<const Supercombinator>(combine(terms, *skeleton, std::move(components), bounds_.rules));
        return std::make_unique<SupercombinatorSystem>(std::move(combined), terms);
    } catch (const process::Interrupted&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::logic_error&) {
        throw;  // a fault of ours
    } catch (const std::exception&) {
        return nullptr;
    }
}

std::optional<process::Machine> Compiler::explore(TermId term, const std::function<void()>& poll) {
    const auto system = compile(term, poll);
    if (!system) return std::nullopt;
    const lts::Exploration explored = lts::explore(*system, [&](std::size_t) {
        if (poll) poll();
    });
    process::Machine machine;
    for (lts::StateIndex state = 0; state < explored.graph.size(); ++state) {
        machine.meaning.push_back(term);
        auto& edges = machine.edges.emplace_back();
        for (const lts::Edge& edge : explored.graph.edges(state)) edges.push_back({edge.event, edge.target});
        std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) {
            return std::pair(a.event, a.target) < std::pair(b.event, b.target);
        });
    }
    return machine;
}

std::optional<process::Machine> MachineCompressor::explore(TermId operand, const std::function<void()>& poll) {
    return compiler_ == nullptr ? std::nullopt : compiler_->explore(operand, poll);
}

}  // namespace robochart::machine
