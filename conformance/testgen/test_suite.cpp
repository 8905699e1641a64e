// SPDX-License-Identifier: Apache-2.0
// Implements the HSI method with a state cover, all words of M + 1 symbols from each state, and harmonised identifiers.
#include "conformance/testgen/test_suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <stdexcept>

#include "cpp_emit/files/trace_names.hpp"

namespace robochart::conformance {

namespace {

constexpr std::uint32_t over = CycleAutomaton::over;
constexpr std::uint32_t none = 0xfffffffeU;

class Suite {
public:
    Suite(const CycleAutomaton& machine, std::size_t most_cycles) : machine_(machine), most_(most_cycles) {}

    std::vector<TestWord> make_tests(std::uint32_t extra_states) {
        find_cover();
        find_identifiers();
        for (std::uint32_t state = 0; state < machine_.state_count(); ++state)
            add_extensions(cover_[state], state, extra_states + 1);
        return without_beginnings();
    }

private:
    /// Finds a shortest word to every state (all states are reachable).
    void find_cover() {
        cover_.resize(machine_.state_count());
        std::vector<bool> seen(machine_.state_count());
        std::deque<std::uint32_t> open{0};
        seen[0] = true;
        for (; !open.empty(); open.pop_front())
            for (std::uint32_t symbol = 0; symbol < machine_.inputs.size(); ++symbol) {
                const std::uint32_t target = machine_.steps[open.front()][symbol].target;
                if (target == over || seen[target]) continue;
                seen[target] = true;
                cover_[target] = cover_[open.front()];
                cover_[target].push_back(symbol);
                open.push_back(target);
            }
    }

    [[nodiscard]] bool outputs_differ(std::uint32_t a, std::uint32_t b, std::uint32_t symbol) const {
        const CycleStep& x = machine_.steps[a][symbol];
        const CycleStep& y = machine_.steps[b][symbol];
        return x.writes != y.writes || (x.target == over) != (y.target == over);
    }

    /// Finds for each pair of states the first symbol of a shortest word that distinguishes them. The identifiers are
    /// harmonised, because both states use the same word.
    void find_identifiers() {
        const std::size_t n = machine_.state_count();
        if (n * n > (1U << 24U)) throw std::length_error("it has too many states for a test suite");
        first_.assign(n * n, none);
        for (bool changed = true; changed;) {
            changed = false;
            const std::vector<std::uint32_t> before = first_;
            for (std::uint32_t a = 0; a < n; ++a)
                for (std::uint32_t b = a + 1; b < n; ++b)
                    if (first_[a * n + b] == none) changed |= distinguish_states(a, b, before);
        }
        identifiers_.resize(n);
        for (std::uint32_t a = 0; a < n; ++a)
            for (std::uint32_t b = a + 1; b < n; ++b) {
                const TestWord word = separating_word(a, b);
                identifiers_[a].insert(word);
                identifiers_[b].insert(word);
            }
    }

    bool distinguish_states(std::uint32_t a, std::uint32_t b, const std::vector<std::uint32_t>& before) {
        const std::size_t n = machine_.state_count();
        for (std::uint32_t symbol = 0; symbol < machine_.inputs.size(); ++symbol) {
            bool found = outputs_differ(a, b, symbol);
            if (!found && machine_.steps[a][symbol].target != over) {
                const auto [x, y] = std::minmax(machine_.steps[a][symbol].target, machine_.steps[b][symbol].target);
                found = x != y && before[x * n + y] != none;
            }
            if (!found) continue;
            first_[a * n + b] = symbol;
            return true;
        }
        return false;
    }

    [[nodiscard]] TestWord separating_word(std::uint32_t a, std::uint32_t b) const {
        TestWord word;
        while (true) {
            if (a > b) std::swap(a, b);
            const std::uint32_t symbol = first_[a * machine_.state_count() + b];
            if (symbol == none) throw std::length_error("two of its states are the same");
            word.push_back(symbol);
            if (outputs_differ(a, b, symbol)) return word;
            a = machine_.steps[a][symbol].target;
            b = machine_.steps[b][symbol].target;
        }
    }

    /// Adds all words that extend `word` by at most `more` symbols. Each is followed by the identifiers of the state to
    /// which it leads.
    void add_extensions(const TestWord& word, std::uint32_t state, std::uint32_t more) {
        if (state == over || identifiers_[state].empty()) add_test(word);
        if (state == over) return;
        for (const TestWord& identifier : identifiers_[state]) {
            TestWord test = word;
            test.insert(test.end(), identifier.begin(), identifier.end());
            add_test(std::move(test));
        }
        if (more == 0) return;
        for (std::uint32_t symbol = 0; symbol < machine_.inputs.size(); ++symbol) {
            TestWord longer = word;
            longer.push_back(symbol);
            add_extensions(longer, machine_.steps[state][symbol].target, more - 1);
        }
    }

    void add_test(TestWord word) {
        const std::size_t cycles = word.size();
        if (!tests_.insert(std::move(word)).second) return;
        cycles_ += cycles;
        if (cycles_ > most_) throw std::length_error(fmt::format("a complete suite has more than {} cycles", most_));
    }

    /// Returns the words that are not a prefix of another word. In lexicographic order, a word is followed by the words
    /// that begin with it.
    [[nodiscard]] std::vector<TestWord> without_beginnings() const {
        std::vector<TestWord> result;
        for (auto at = tests_.begin(); at != tests_.end(); ++at) {
            const auto next = std::next(at);
            const bool begins =
                next != tests_.end() && at->size() < next->size() && std::equal(at->begin(), at->end(), next->begin());
            if (!begins && !at->empty()) result.push_back(*at);
        }
        return result;
    }

    const CycleAutomaton& machine_;
    std::size_t most_;
    std::vector<TestWord> cover_;
    std::vector<std::uint32_t> first_;
    std::vector<std::set<TestWord>> identifiers_;
    std::set<TestWord> tests_;
    std::size_t cycles_ = 0;
};

}  // namespace

std::vector<TestWord> complete_suite(const CycleAutomaton& machine, std::uint32_t extra_states,
                                     std::size_t most_cycles) {
    return Suite(machine, most_cycles).make_tests(extra_states);
}

}  // namespace robochart::conformance
