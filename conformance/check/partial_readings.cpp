// SPDX-License-Identifier: Apache-2.0
// See partial_readings.hpp. A position is the beginning of a cycle: an image of the code and a node of NF_c(M). A
// register is unread until the results of the code or the model depend on it. Then the cycle is tried with each of its
// readings.
#include "conformance/check/partial_readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "conformance/check/dispatch_equivalence.hpp"
#include "conformance/check/follower.hpp"
#include "conformance/check/lost_events.hpp"
#include "conformance/check/standstill.hpp"
#include "conformance/code/code_system.hpp"

namespace robochart::conformance {

namespace {

using Node = Follower::Node;

constexpr std::uint32_t not_read = 0xffffffffU;
using Readings = std::vector<std::uint32_t>;  ///< for each register, its reading in one cycle, or not_read

Frame frame_with_unread() {
    Frame frame;
    frame.unread = true;
    return frame;
}

class PartialSearch {
public:
    PartialSearch(ModelGraph& model, const Alphabet& alphabet, CodeSystem& code, std::uint32_t cycle_length,
                  const refine::Limits& limits)
        : alphabet_(alphabet),
          code_(code),
          follower_(model, alphabet, cycle_length, limits, frame_with_unread()),
          budget_(limits),
          cycle_length_(std::max(1U, cycle_length)),
          inputs_(alphabet.interface().inputs.size()) {
        code_.set_budget(budget_);
    }
    ~PartialSearch() { code_.set_budget(diagnostics::unlimited); }
    PartialSearch(const PartialSearch&) = delete;
    PartialSearch& operator=(const PartialSearch&) = delete;

    Result run() {
        add_position(code_.reset_image(), follower_.initial_node(), 0, {}, nullptr);
        for (at_ = 0; at_ < positions_.size() && !found_; ++at_) {
            Readings readings(inputs_, not_read);
            const std::uint32_t image = positions_[at_].image;
            visit_tree(code_.reading_tree(image), 0, readings);
        }
        Result result;
        result.outcome = Outcome::conforms;
        if (found_) report_mismatch(result);
        if (!code_.unsound_reason().empty()) {
            result.outcome = Outcome::differs;
            result.reason = code_.unsound_reason();
        }
        result.product.states = positions_.size();
        result.product.transitions = cycles_;
        result.product.spec_nodes = follower_.node_count();
        if (missed_)
            result.deadlines = {false,   "the code reports a missed deadline", cycles_to(missed_way_),
                                nullptr, trace_as_run(trace_to(missed_way_)),  {}};
        return result;
    }

private:
    struct Position {
        std::uint32_t image = 0;
        Node node = 0;
        std::size_t from = 0;
        Readings readings;  ///< readings of the cycle that led to this position
        const CycleResult* result = nullptr;
    };
    /// The last cycle of a path, in which code and model may differ.
    struct Last {
        std::size_t from = 0;
        Readings readings;
        const CycleResult* result = nullptr;
        std::size_t writes = 0;  ///< number of its writes
        std::size_t agreed = 0;  ///< number of its reads and writes before the difference
    };

    void add_position(std::uint32_t image, Node node, std::size_t from, const Readings& readings,
                      const CycleResult* result) {
        if (!known_.emplace(std::pair{image, node}, true).second) return;
        positions_.push_back({image, node, from, readings, result});
        budget_.states(positions_.size());
    }

    /// Tries the readings of a register. If all readings lead to the same tree, the register makes no difference to the
    /// code. Recursion depth: the number of registers.
    void visit_tree(std::uint32_t node, std::size_t level, Readings& readings) {
        if (found_) return;
        if (level == inputs_) {
            const CycleResult& result = code_.cycle_result(node);
            if (result.ways.empty()) return try_cycle(result, readings);
            for (const std::uint32_t way : result.ways) try_cycle(code_.cycle_result(way), readings);
            return;
        }
        const std::vector<std::uint32_t> below = code_.child_nodes(node);
        const bool same = std::ranges::all_of(below, [&](std::uint32_t child) { return child == below[0]; });
        if (same) return visit_tree(below.front(), level + 1, readings);
        for (std::uint32_t reading = 0; reading < below.size(); ++reading) {
            readings[level] = reading;
            visit_tree(below[reading], level + 1, readings);
        }
        readings[level] = not_read;
    }

    /// Tries every reading of a register on which the model depends. Recursion depth: the number of registers.
    void try_cycle(const CycleResult& result, Readings& readings) {
        if (found_) return;
        const std::optional<std::uint32_t> register_index = check_cycle(result, readings);
        if (!register_index) return;
        const std::uint32_t all = alphabet_.interface().inputs[*register_index].reading_count();
        for (std::uint32_t reading = 0; reading < all; ++reading) {
            readings[*register_index] = reading;
            try_cycle(result, readings);
        }
        readings[*register_index] = not_read;
    }

    /// Follows the cycle in the model. Returns the register on which the model depends, or no value if the cycle is
    /// complete.
    std::optional<std::uint32_t> check_cycle(const CycleResult& result, const Readings& readings) {
        budget_.charge();
        ++cycles_;
        Node node = positions_[at_].node;
        for (std::uint32_t i = 0; i < inputs_; ++i) {
            const bool unread = readings[i] == not_read;
            const process::Event event =
                unread ? follower_.system().unread_event(i) : alphabet_.read_event(i, readings[i]);
            if (record_mismatch(follower_.follow_event(node, event, true), {at_, readings, &result, 0, i}))
                return std::nullopt;
        }
        for (std::size_t w = 0; w < result.writes.size(); ++w) {
            if (const auto register_index = follower_.asked_register(node)) return register_index;
            if (record_mismatch(follower_.follow_event(node, result.writes[w], false),
                                {at_, readings, &result, w + 1, inputs_ + w}))
                return std::nullopt;
        }
        if (const auto register_index = follower_.asked_register(node)) return register_index;
        const std::size_t writes = result.writes.size();
        const Last whole{at_, readings, &result, writes, inputs_ + writes};
        if (record_mismatch(follower_.finish_cycle(node, result.outcome, false), whole)) return std::nullopt;
        if (result.outcome == RC_DEADLINE && !missed_) {
            missed_ = true;
            missed_way_ = whole;
        }
        if (!follower_.has_terminated()) add_position(result.next, node, at_, readings, &result);
        return std::nullopt;
    }

    bool record_mismatch(std::optional<Mismatch> mismatch, const Last& here) {
        if (!mismatch) return false;
        found_ = std::move(mismatch);
        found_way_ = here;
        return true;
    }

    Cycle cycle_of(const Readings& readings, const CycleResult& result, std::size_t writes) const {
        Cycle cycle;
        for (std::uint32_t i = 0; i < inputs_; ++i)
            if (readings[i] != not_read && readings[i] != 0)
                cycle.inputs.push_back(alphabet_.describe_event(alphabet_.read_event(i, readings[i])));
        for (std::size_t w = 0; w < writes; ++w) cycle.outputs.push_back(alphabet_.describe_event(result.writes[w]));
        cycle.state = code_.print_image(result.next);
        return cycle;
    }

    std::vector<Cycle> cycles_to(const Last& last) const {
        std::vector<Cycle> cycles{cycle_of(last.readings, *last.result, last.writes)};
        for (std::size_t at = last.from; at != 0; at = positions_[at].from) {
            const Position& position = positions_[at];
            cycles.push_back(cycle_of(position.readings, *position.result, position.result->writes.size()));
        }
        std::ranges::reverse(cycles);
        return cycles;
    }

    void report_mismatch(Result& result) const {
        result.outcome = found_->outcome;
        result.reason = found_->reason;
        result.expected = found_->expected;
        result.cycles = cycles_to(found_way_);
        set_model_run(result, found_->rule, trace_to(found_way_));
    }

    /// Returns the reads and writes of a cycle.
    [[nodiscard]] std::vector<process::Event> cycle_events(const Readings& readings, const CycleResult& result) const {
        std::vector<process::Event> events;
        for (std::uint32_t i = 0; i < inputs_; ++i)
            events.push_back(alphabet_.read_event(i, readings[i] == not_read ? 0 : readings[i]));
        events.insert(events.end(), result.writes.begin(), result.writes.end());
        return events;
    }

    /// Returns the trace of code and model up to their difference. A register is treated as empty if neither the code
    /// nor the model depends on it.
    std::vector<process::Event> trace_to(const Last& last) const {
        std::vector<std::size_t> way;
        for (std::size_t at = last.from; at != 0; at = positions_[at].from) way.push_back(at);
        std::vector<process::Event> trace;
        for (auto at = way.rbegin(); at != way.rend(); ++at) {
            const Position& position = positions_[*at];
            const std::vector<process::Event> cycle = cycle_events(position.readings, *position.result);
            trace.insert(trace.end(), cycle.begin(), cycle.end());
            trace.insert(trace.end(), cycle_length_, alphabet_.tock());
        }
        const std::vector<process::Event> cycle = cycle_events(last.readings, *last.result);
        trace.insert(trace.end(), cycle.begin(), cycle.begin() + static_cast<std::ptrdiff_t>(last.agreed));
        return trace;
    }

    const Alphabet& alphabet_;
    CodeSystem& code_;
    Follower follower_;
    refine::Budget budget_;
    std::uint32_t cycle_length_;
    std::size_t inputs_;
    std::map<std::pair<std::uint32_t, Node>, bool> known_;
    std::vector<Position> positions_;
    std::size_t at_ = 0;
    std::uint64_t cycles_ = 0;
    std::optional<Mismatch> found_;
    Last found_way_;
    bool missed_ = false;
    Last missed_way_;
};

}  // namespace

Result judge_partially(ModelGraph& model, const Alphabet& alphabet, const rc_interface& compiled,
                       std::uint32_t cycle_length, const refine::Limits& limits, const EventPlaces& places) {
    Result result;
    try {
        CodeSystem code(compiled, alphabet, cycle_length);
        result = PartialSearch(model, alphabet, code, cycle_length, limits).run();
        compare_event_api(result, compiled, code, alphabet, limits);
        add_lost_events(result, code, alphabet, places);
        result.code_states = code.image_count();
        result.code_cycles = code.cycle_count();
    } catch (const process::Interrupted& limit) {
        result.reason = limit.what();
    } catch (const std::length_error& limit) {
        result.reason = limit.what();
    }
    result.model_states = model.size();
    return result;
}

}  // namespace robochart::conformance
