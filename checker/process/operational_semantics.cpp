// SPDX-License-Identifier: Apache-2.0
// Computes and caches the transitions of terms. An explicit stack contains the terms whose transitions are needed
// first. So deep terms do not exhaust the call stack, and recursion without an event is detected.
#include "checker/process/operational_semantics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <unordered_map>
#include <utility>

#include "checker/process/firing_rules.hpp"

namespace robochart::process {
namespace {

/// Deeper nesting is assumed to be infinite. This limits nested operators, and definitions that unfold each other
/// without an event.
constexpr std::size_t deepest_nesting = 1'000'000;

enum class Progress : std::uint8_t { unknown, pending, known };

}  // namespace

struct OperationalSemantics::Impl final : KnownTransitions {
    Impl(TermStore& store, Compressor* with) : terms(store), rules(store, *this), compressor(with) {}

    TermStore& terms;
    FiringRules rules;
    Compressor* compressor;
    diagnostics::Pollable* budget = &diagnostics::unlimited;
    std::uint32_t machine_states = 0;
    std::size_t states_explored = 0;
    int compressions_under_way = 0;
    std::set<TermId> left_out;
    std::vector<Progress> progress;
    std::deque<std::vector<Transition>> transitions;

    [[nodiscard]] std::span<const Transition> list_transitions(TermId term) const override {
        return transitions[static_cast<std::uint32_t>(term)];
    }
    [[nodiscard]] bool is_known(TermId term) const override {
        const auto index = static_cast<std::uint32_t>(term);
        return index < progress.size() && progress[index] == Progress::known;
    }

    void reserve() {
        progress.resize(terms.size(), Progress::unknown);
        transitions.resize(terms.size());
    }

    void begin(TermId term, std::vector<TermId>& stack);
    void set_transitions_of(TermId term);
    void compute(TermId root);
    void compute_on(std::vector<TermId>& stack);
    [[nodiscard]] bool is_compression(TermId term) const {
        return compressor != nullptr && terms[term].op == Op::compress;
    }
    std::optional<Machine> compress_operand(TermId term);
    std::vector<Transition> compressed_transitions(TermId term);
    Machine explore_operand(TermId operand);
    void set(TermId term, std::vector<Transition> result);
};

void OperationalSemantics::Impl::begin(TermId term, std::vector<TermId>& stack) {
    reserve();
    Progress& state = progress[static_cast<std::uint32_t>(term)];
    if (state == Progress::pending)
        throw SemanticsError(
            fmt::format("the process {} is defined by itself before any event, or inside a compression of itself",
                        describe(terms, term)),
            term);
    if (stack.size() >= deepest_nesting)
        throw SemanticsError(fmt::format("more than {} processes inside each other before any event", deepest_nesting),
                             term);
    state = Progress::pending;
    stack.push_back(term);
}

void OperationalSemantics::Impl::set_transitions_of(TermId term) {
    set(term, is_compression(term) ? compressed_transitions(term) : rules.transitions(term));
}

void OperationalSemantics::Impl::set(TermId term, std::vector<Transition> result) {
    reserve();
    const auto index = static_cast<std::uint32_t>(term);
    transitions[index] = std::move(result);
    progress[index] = Progress::known;
}

void OperationalSemantics::Impl::compute_on(std::vector<TermId>& stack) {
    while (!stack.empty()) {
        budget->poll();
        const TermId top = stack.back();
        const std::optional<TermId> missing = is_compression(top) ? std::nullopt : rules.missing_operand(top);
        if (missing) {
            begin(*missing, stack);
        } else {
            set_transitions_of(top);
            stack.pop_back();
        }
    }
}

void OperationalSemantics::Impl::compute(TermId root) {
    std::vector<TermId> stack;
    try {
        begin(root, stack);
        compute_on(stack);
    } catch (...) {
        for (TermId term : stack) progress[static_cast<std::uint32_t>(term)] = Progress::unknown;
        throw;
    }
}

/// Explores all reachable states of the operand in breadth-first order.
Machine OperationalSemantics::Impl::explore_operand(TermId operand) {
    Machine machine;
    std::unordered_map<std::uint32_t, std::uint32_t> numbers;
    const auto number = [&](TermId state) {
        const auto next = static_cast<std::uint32_t>(machine.meaning.size());
        const auto [entry, fresh] = numbers.emplace(static_cast<std::uint32_t>(state), next);
        if (fresh) machine.meaning.push_back(state);
        return entry->second;
    };
    number(operand);
    for (std::size_t state = 0; state < machine.meaning.size(); ++state) {
        states_explored = machine.meaning.size();
        budget->poll();
        const TermId term = machine.meaning[state];
        if (!is_known(term)) compute(term);
        std::vector<Machine::Edge>& edges = machine.edges.emplace_back();
        for (const Transition& step : list_transitions(term)) edges.push_back({step.event, number(step.target)});
    }
    return machine;
}

/// Compresses the operand of a term. Returns no value if the operand has too many states.
std::optional<Machine> OperationalSemantics::Impl::compress_operand(TermId term) {
    constexpr int deepest = 200;
    refuse_unsupported(terms[term]);
    if (compressions_under_way >= deepest)
        throw SemanticsError(fmt::format("more than {} compressions inside each other", deepest), term);
    ++compressions_under_way;
    std::optional<Machine> result;
    try {
        const TermId operand = terms[term].children.front();
        const Compression kind{terms[term].payload};
        const std::optional<Machine> fast = compressor->explore(operand, kind, *budget);
        result = compressor->compress(fast ? *fast : explore_operand(operand), kind, *budget);
    } catch (const TooManyStates&) {
    } catch (...) {
        --compressions_under_way;
        states_explored = 0;
        throw;
    }
    --compressions_under_way;
    states_explored = 0;
    return result;
}

/// Returns the transitions of the initial state of the compressed machine. Creates a term with known transitions for
/// each of its states. If the operand has too many states, returns the transitions of the operand itself.
std::vector<Transition> OperationalSemantics::Impl::compressed_transitions(TermId term) {
    const std::optional<Machine> made = compress_operand(term);
    if (!made) {
        const TermId operand = terms[term].children.front();
        left_out.insert(term);
        if (!is_known(operand)) compute(operand);
        const auto same = list_transitions(operand);
        return {same.begin(), same.end()};
    }
    const Machine& machine = *made;
    // A state of the machine has these children: a term that it represents, the compressed term, and the first state
    // (unless it is the first state itself).
    std::vector<TermId> states;
    for (TermId meaning : machine.meaning) {
        std::vector<TermId> operands{meaning, term};
        if (!states.empty()) operands.push_back(states.front());
        states.push_back(terms.intern_term(Term{Op::machine, machine_states++, std::move(operands), {}}));
    }
    const auto transitions_of = [&](std::size_t state) {
        std::vector<Transition> result;
        budget->poll();
        for (const Machine::Edge& edge : machine.edges[state])
            result.push_back({edge.event, edge.event, states[edge.target]});
        return result;
    };
    for (std::size_t state = 0; state < states.size(); ++state) set(states[state], transitions_of(state));
    return transitions_of(0);
}

OperationalSemantics::OperationalSemantics(TermStore& terms, Compressor* compressor)
    : impl_(std::make_unique<Impl>(terms, compressor)) {}
OperationalSemantics::~OperationalSemantics() = default;

std::span<const Transition> OperationalSemantics::successors(TermId term) {
    if (!impl_->is_known(term)) impl_->compute(term);
    return impl_->list_transitions(term);
}

std::optional<TermId> OperationalSemantics::first_machine_state(TermId term) {
    if (!impl_->is_compression(term)) return std::nullopt;
    const std::span<const Transition> steps = successors(term);
    if (steps.empty() || left_out().contains(term)) return std::nullopt;
    const TermId target = steps.front().target;
    const std::vector<TermId>& children = terms()[target].children;
    return children.size() > 2 ? children[2] : target;
}

TermStore& OperationalSemantics::terms() const {
    return impl_->terms;
}

const std::set<TermId>& OperationalSemantics::left_out() const {
    return impl_->left_out;
}

std::size_t OperationalSemantics::states_explored() const {
    return impl_->states_explored;
}

void OperationalSemantics::set_budget(diagnostics::Pollable& budget) {
    impl_->rules.set_budget(budget);
    impl_->budget = &budget;
}

}  // namespace robochart::process
