// SPDX-License-Identifier: Apache-2.0
// Explores NF_c(M) cycle by cycle over all valuations, and minimises the automaton (Moore 1956).
#include "conformance/testgen/cycle_automaton.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/normal_form.hpp"

namespace robochart::conformance {

namespace {

using Node = refine::NormalForm::Node;
constexpr std::size_t most_symbols = 1U << 12U;
constexpr std::size_t most_steps = 1U << 22U;

std::vector<std::vector<std::uint32_t>> all_valuations(const Interface& interface) {
    std::vector<std::vector<std::uint32_t>> all{{}};
    for (const Register& input : interface.inputs) {
        std::vector<std::vector<std::uint32_t>> more;
        for (const auto& before : all)
            for (std::uint32_t r = 0; r < input.reading_count(); ++r) {
                more.push_back(before);
                more.back().push_back(r);
            }
        if (more.size() > most_symbols)
            throw std::length_error(fmt::format("the inputs have more than {} valuations together", most_symbols));
        all = std::move(more);
    }
    return all;
}

class Builder {
public:
    Builder(CyclicModel& model, const refine::Limits& limits)
        : model_(model), budget_(limits), form_(model.normal_form(), budget_) {}

    ChoiceAutomaton build() {
        ChoiceAutomaton machine;
        machine.inputs = all_valuations(model_.interface());
        node_number(form_.initial());
        for (std::size_t at = 0; at < nodes_.size(); ++at) {
            if ((at + 1) * machine.inputs.size() > most_steps)
                throw std::length_error(fmt::format("it has more than {} transitions", most_steps));
            machine.branches.emplace_back();
            for (const auto& readings : machine.inputs)
                machine.branches.back().push_back(cycle_steps(nodes_[at], readings));
        }
        return minimise_states(machine);
    }

private:
    std::uint32_t node_number(Node node) {
        const auto [place, fresh] = numbers_.emplace(node, static_cast<std::uint32_t>(nodes_.size()));
        if (fresh) nodes_.push_back(node);
        return place->second;
    }

    std::vector<CycleStep> cycle_steps(Node node, const std::vector<std::uint32_t>& readings) {
        for (std::uint32_t i = 0; i < readings.size(); ++i) {
            const auto next = form_.node_after(node, model_.alphabet().read_event(i, readings[i]));
            if (!next) throw std::length_error("the model cannot be run in cycles: it is not schedulable");
            node = *next;
        }
        std::vector<CycleStep> branches;
        follow_paths(node, branches);
        return branches;
    }

    /// A node on a path through a cycle.
    struct Place {
        Node node;
        std::uint32_t tocks;
        process::EventSet events;
        bool written = false;  ///< true: the event that led to the node is the last of the writes
        std::size_t next = 0;
    };

    /// Follows every path to the end of the cycle. Throws if a path returns to a node before time passes, because it
    /// has no end.
    void follow_paths(Node from, std::vector<CycleStep>& branches) {
        std::vector<Place> way;
        std::vector<process::Event> writes;
        std::set<std::pair<Node, std::uint32_t>> open;  // the nodes on the current path
        const auto enter = [&](Node node, std::uint32_t tocks) {
            budget_.charge();
            if (tocks == model_.cycle_length()) {
                add_branch({writes, node_number(node)}, branches);
                return false;
            }
            if (!open.emplace(node, tocks).second)
                throw std::length_error(
                    "the model cannot be run in cycles: it takes infinitely many steps without time passing");
            way.push_back({node, tocks, form_.initials(node)});
            if (way.back().events.empty())
                throw std::length_error("the model cannot be run in cycles: it is not schedulable");
            return true;
        };
        enter(from, 0);
        while (!way.empty()) {
            Place& at = way.back();
            if (at.next == at.events.size()) {
                if (at.written) writes.pop_back();
                open.erase({at.node, at.tocks});
                way.pop_back();
                continue;
            }
            const process::Event event = at.events[at.next++];
            if (event == process::tick) {
                add_branch({writes, CycleAutomaton::over}, branches);
            } else if (event == model_.alphabet().tock()) {
                enter(*form_.node_after(at.node, event), at.tocks + 1);
            } else {
                writes.push_back(event);
                if (enter(*form_.node_after(at.node, event), at.tocks)) way.back().written = true;
            }
        }
    }

    void add_branch(CycleStep step, std::vector<CycleStep>& branches) {
        if (++steps_ > most_steps) throw std::length_error(fmt::format("it has more than {} transitions", most_steps));
        branches.push_back(std::move(step));
    }

    /// Minimises the machine (Moore 1956): words of increasing length distinguish states. States are numbered in the
    /// order of the search.
    ChoiceAutomaton minimise_states(const ChoiceAutomaton& machine) {
        std::vector<std::uint32_t> classes(machine.state_count(), 0);
        for (std::size_t count = 0;;) {
            std::map<std::vector<std::uint64_t>, std::uint32_t> known;
            std::vector<std::uint32_t> next;
            for (const auto& symbols : machine.branches) {
                std::vector<std::uint64_t> signature;
                for (const std::vector<CycleStep>& branches : symbols) {
                    budget_.charge();
                    signature.push_back(branches.size());
                    for (const CycleStep& step : branches) {
                        signature.push_back(step.target == CycleAutomaton::over ? step.target : classes[step.target]);
                        signature.push_back(step.writes.size());
                        signature.insert(signature.end(), step.writes.begin(), step.writes.end());
                    }
                }
                next.push_back(
                    known.emplace(std::move(signature), static_cast<std::uint32_t>(known.size())).first->second);
            }
            classes = std::move(next);
            if (known.size() == count) break;
            count = known.size();
        }
        ChoiceAutomaton result;
        result.inputs = machine.inputs;
        for (std::size_t state = 0; state < machine.state_count(); ++state) {
            if (classes[state] != result.state_count()) continue;
            result.branches.push_back(machine.branches[state]);
            for (auto& branches : result.branches.back())
                for (CycleStep& step : branches)
                    if (step.target != CycleAutomaton::over) step.target = classes[step.target];
        }
        return result;
    }

    CyclicModel& model_;
    refine::Budget budget_;
    refine::NormalForm form_;
    std::unordered_map<Node, std::uint32_t> numbers_;
    std::vector<Node> nodes_;
    std::size_t steps_ = 0;
};

/// Describes the first difference between two paths through a cycle.
std::string describe_first_difference(const CyclicModel& model, const CycleStep& a, const CycleStep& b) {
    const auto text_of = [&](const CycleStep& step, std::size_t at) -> std::string {
        if (at < step.writes.size()) return model.alphabet().describe_event(step.writes[at]);
        return step.target == CycleAutomaton::over ? "termination" : "end of cycle";
    };
    std::size_t at = 0;
    while (at < a.writes.size() && at < b.writes.size() && a.writes[at] == b.writes[at]) ++at;
    return fmt::format("{} and {}", text_of(a, at), text_of(b, at));
}

}  // namespace

bool ChoiceAutomaton::is_deterministic() const {
    for (const auto& symbols : branches)
        for (const auto& alternatives : symbols)
            if (alternatives.size() > 1) return false;
    return true;
}

ChoiceAutomaton choice_automaton(CyclicModel& model, const refine::Limits& limits) {
    return Builder(model, limits).build();
}

CycleAutomaton cycle_automaton(CyclicModel& model, const refine::Limits& limits) {
    ChoiceAutomaton choices = choice_automaton(model, limits);
    CycleAutomaton machine;
    machine.inputs = std::move(choices.inputs);
    for (auto& symbols : choices.branches) {
        std::vector<CycleStep>& steps = machine.steps.emplace_back();
        for (auto& alternatives : symbols) {
            if (alternatives.size() > 1)
                throw std::length_error(
                    fmt::format("the model leaves a choice, between {}",
                                describe_first_difference(model, alternatives[0], alternatives[1])));
            steps.push_back(std::move(alternatives.front()));
        }
    }
    return machine;
}

}  // namespace robochart::conformance
