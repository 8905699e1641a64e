// SPDX-License-Identifier: Apache-2.0
// See reading_on_demand.hpp. A node consists of a segment of the code's cycles (cycle_graph.hpp) and a set of states in
// which the model may be (uniform_runs.hpp). Before a difference is reported, code and model are run from the first
// cycle on with all registers given.
#include "conformance/check/reading_on_demand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "checker/refine/search/budget.hpp"
#include "conformance/check/dispatch_equivalence.hpp"
#include "conformance/check/lost_events.hpp"
#include "conformance/check/random_walk.hpp"
#include "conformance/code/cycle_graph.hpp"
#include "conformance/model/uniform_runs.hpp"

namespace robochart::conformance {

namespace {

using Set = UniformRuns::Set;
using CycleReadings = std::vector<std::uint32_t>;  ///< for each register, its reading in one cycle

class OnDemandSearch {
public:
    OnDemandSearch(ModelGraph& model, const Alphabet& alphabet, CycleGraph& code, std::uint32_t cycle_length,
                   const refine::Limits& limits)
        : alphabet_(alphabet), code_(code), graph_(model), model_(model, alphabet, cycle_length), budget_(limits) {
        code_.set_budget(budget_);
        graph_.set_budget(budget_);
    }
    ~OnDemandSearch() {
        code_.set_budget(diagnostics::unlimited);
        graph_.set_budget(diagnostics::unlimited);
    }
    OnDemandSearch(const OnDemandSearch&) = delete;
    OnDemandSearch& operator=(const OnDemandSearch&) = delete;

    /// Returns the readings of the cycles that lead to a difference; empty if there is none.
    std::vector<CycleReadings> run() {
        begin_cycle(code_.reset_image(), model_.start(), no_node, {});
        for (done_ = 0; done_ < starts_.size(); ++done_) {
            open_.assign(1, starts_[done_].node);
            while (!open_.empty()) {
                const std::uint32_t at = open_.back();
                open_.pop_back();
                if (!expand(at)) return way_to(at);
            }
        }
        return {};
    }

    [[nodiscard]] std::string searched() const {
        return fmt::format(
            "no difference in {} of {} positions (states of the code and of the model in which a cycle begins) that "
            "the "
            "search has met, each tried with all readings of the registers",
            done_, starts_.size());
    }

    void count(Result& result) const {
        result.product.states = nodes_.size();
        result.product.transitions = steps_;
        result.product.spec_nodes = model_.sets();
    }

private:
    static constexpr std::uint32_t no_node = 0xffffffffU;
    enum class Step : std::uint8_t { cycle, round, reading };

    struct Node {
        std::uint32_t segment = 0;
        Set model = 0;
        std::uint32_t from = no_node;
        std::uint32_t input = 0;    ///< for reading: the register that the code has read
        std::uint32_t reading = 0;  ///< for reading: the register's content; for cycle: index in `starts_`
        Step step = Step::cycle;
    };
    struct Start {
        std::uint32_t node = 0;
        /// The readings assumed for registers that the code did not read in the previous cycle.
        std::vector<std::pair<std::uint32_t, std::uint32_t>> before;
    };

    bool add(const Node& node) {
        ++steps_;
        if (!known_.insert((std::uint64_t{node.segment} << 32U) | node.model).second) return false;
        nodes_.push_back(node);
        budget_.charge();
        budget_.states(nodes_.size());
        return true;
    }

    void begin_cycle(std::uint32_t image, Set states, std::uint32_t from,
                     std::vector<std::pair<std::uint32_t, std::uint32_t>> before) {
        const std::uint32_t segment = code_.root(image);
        if (!add({segment, states, from, 0, static_cast<std::uint32_t>(starts_.size()), Step::cycle})) return;
        starts_.push_back({static_cast<std::uint32_t>(nodes_.size() - 1), std::move(before)});
    }

    void go_on(const Node& node) {
        if (add(node)) open_.push_back(static_cast<std::uint32_t>(nodes_.size() - 1));
    }

    /// Expands a node. Returns false if the model cannot follow from here when the registers that the code has not read
    /// contain the readings in `assumed_`, or are empty.
    bool expand(std::uint32_t at) {
        const Node node = nodes_[at];
        const CycleGraph::Segment segment = code_.segment(node.segment);
        Set states = node.model;
        assumed_.readings.clear();
        for (const process::Event write : code_.outputs(segment)) {
            const auto next = model_.after(states, write);
            if (!next) return false;
            states = *next;
        }
        switch (segment.end) {
            case CycleGraph::End::open:
                throw NotProbed("a cycle was not explored");
            case CycleGraph::End::round:
                go_on({segment.next, states, at, 0, 0, Step::round});
                return true;
            case CycleGraph::End::reading:
                for (std::uint32_t r = alphabet_.interface().inputs[segment.input].reading_count(); r-- > 0;) {
                    const Set read = r == 0 ? states : model_.with(states, segment.input, r);
                    go_on({segment.next + r, read, at, segment.input, r, Step::reading});
                }
                return true;
            case CycleGraph::End::leaf:
                break;
        }
        const CycleGraph::Leaf leaf = code_.leaf(segment);
        std::vector<UniformRuns::Completion> completions;
        if (!model_.finish(states, leaf.unread, leaf.outcome, completions, assumed_)) return false;
        if (leaf.outcome != RC_QUIESCENT) return true;
        for (UniformRuns::Completion& completion : completions)
            begin_cycle(leaf.next, completion.states, at, std::move(completion.readings));
        return true;
    }

    /// Returns the readings of the cycles to a node. Registers without an assumed reading are empty.
    [[nodiscard]] std::vector<CycleReadings> way_to(std::uint32_t node) const {
        const CycleReadings empty(alphabet_.interface().inputs.size(), 0);
        std::vector<CycleReadings> way{empty};
        for (const auto& [input, reading] : assumed_.readings) way.back()[input] = reading;
        for (std::uint32_t at = node; at != no_node; at = nodes_[at].from) {
            const Node& here = nodes_[at];
            if (here.step == Step::reading) way.back()[here.input] = here.reading;
            if (here.step != Step::cycle || here.from == no_node) continue;
            way.push_back(empty);
            for (const auto& [input, reading] : starts_[here.reading].before) way.back()[input] = reading;
        }
        std::ranges::reverse(way);
        return way;
    }

    const Alphabet& alphabet_;
    CycleGraph& code_;
    ModelGraph& graph_;
    UniformRuns model_;
    refine::Budget budget_;
    std::vector<Node> nodes_;
    std::unordered_set<std::uint64_t> known_;  ///< never iterated
    std::vector<Start> starts_;
    std::size_t done_ = 0;
    std::vector<std::uint32_t> open_;  ///< nodes of the current cycle
    UniformRuns::Completion assumed_;
    std::uint64_t steps_ = 0;
};

}  // namespace

Result refined_on_demand(ModelGraph& model, const Alphabet& alphabet, const rc_interface& compiled,
                         std::uint32_t cycle_length, const refine::Limits& limits, const EventPlaces& places) {
    Result result;
    CycleGraph code(compiled, alphabet, cycle_length);
    OnDemandSearch search(model, alphabet, code, cycle_length, limits);
    try {
        const std::vector<CycleReadings> way = search.run();
        if (!way.empty()) {
            auto found = difference_on(model, alphabet, compiled, cycle_length, limits, way);
            if (!found) throw NotProbed("the model may follow the code only with knowledge of all registers");
            result = std::move(*found);
        } else {
            result.outcome = Outcome::conforms;
        }
        compare_event_api(result, compiled, code, alphabet, limits);
        add_lost_events(result, code, alphabet, places);
    } catch (const process::Interrupted& limit) {
        result.outcome = Outcome::inconclusive;
        result.reason = fmt::format("{}; {}", limit.what(), search.searched());
    }
    search.count(result);
    result.model_states = model.size();
    result.code_states = code.image_count();
    result.code_cycles = code.cycle_count();
    if (code.has_alias())
        result.warnings.emplace_back("the code's state is not canonical: different bytes print alike");
    return result;
}

}  // namespace robochart::conformance
