// SPDX-License-Identifier: Apache-2.0
// Represents the compiled controller, L(G), as a transition system. A state consists of the byte image of the code's
// state and the progress of the cycle (docs/conformance.md, "The code").
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "conformance/code/code_images.hpp"
#include "conformance/code/cycle_log.hpp"
#include "conformance/code/explored_code.hpp"
#include "conformance/code/interface.hpp"
#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// Returns the interface, as the code describes it. Its carriers contain plain numbers until the caller replaces them.
[[nodiscard]] Interface interface_of(const rc_interface&);

class CodeSystem : public lts::TransitionSystem, public ExploredCode {
public:
    /// The maximal number of valuations of all inputs together.
    static constexpr std::uint64_t max_valuations = 1ULL << 24U;

    /// Throws std::length_error if all inputs together have more than `max_valuations`.
    CodeSystem(const rc_interface& code, const Alphabet& alphabet, std::uint32_t cycle_length);

    [[nodiscard]] std::size_t width() const override;
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] const process::EventTable& events() const override { return alphabet_->events(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override;
    void set_budget(diagnostics::Pollable& budget) override { budget_ = &budget; }

    /// The following functions are for reporting runs: the reset image, one step, and an image as text. In a step,
    /// `readings` has one entry for each register. If a step has several branches, the one that begins with the given
    /// writes is taken.
    [[nodiscard]] std::uint32_t reset_image() const override { return images_.reset(); }
    [[nodiscard]] const CycleResult& step(std::uint32_t image, const std::vector<std::uint32_t>& readings,
                                          const std::vector<process::Event>& writes);
    [[nodiscard]] std::string print_image(std::uint32_t image) const override { return images_.print(image); }

    /// Returns the root of an image's tree of readings. Each node lists the next node for every reading of its
    /// register, and the nodes after the last register are results. Equal trees are shared, so all children of a node
    /// are equal if its register has no effect.
    [[nodiscard]] std::uint32_t reading_tree(std::uint32_t image);
    [[nodiscard]] std::uint32_t cycles_of(std::uint32_t image) const override { return roots_.at(image); }
    [[nodiscard]] std::vector<std::uint32_t> child_nodes(std::uint32_t node) const { return nodes_[node]; }
    [[nodiscard]] const CycleResult& cycle_result(std::uint32_t number) const { return results_[number]; }

    [[nodiscard]] const std::vector<std::uint32_t>& started_images() const override { return begun_; }
    /// Sets the packed state in which a cycle begins with this image.
    void enter_cycle(std::span<lts::Word> state, std::uint32_t image);
    [[nodiscard]] std::vector<unsigned char> image_bytes(std::uint32_t image) const override {
        return images_.bytes(image);
    }
    [[nodiscard]] std::vector<PassedCycle> path_to_image(std::uint32_t image) const override;
    [[nodiscard]] std::vector<bool> without_effect(std::uint32_t image) const override;
    [[nodiscard]] std::vector<std::uint32_t> next_images(std::uint32_t image) const override;
    [[nodiscard]] std::vector<process::Event> writes(std::uint32_t image,
                                                     const std::vector<Raised>& raised) const override;

    [[nodiscard]] std::uint64_t image_count() const { return images_.size(); }
    [[nodiscard]] std::uint64_t cycle_count() const { return cycles_; }
    /// Returns an error of the code that refinement does not detect: `step` or `initial` is not a function of its
    /// arguments.
    [[nodiscard]] const std::string& unsound_reason() const { return unsound_; }
    /// Returns whether some call of `step` did not return and was stopped (watchdog.hpp).
    [[nodiscard]] bool endless() const { return endless_; }
    [[nodiscard]] std::uint32_t cycle_length() const override { return cycle_length_; }
    [[nodiscard]] std::uint32_t most_writes() const override { return most_writes_; }
    /// Returns whether two images with different bytes have the same text.
    [[nodiscard]] bool has_alias() const { return images_.alias_found(); }

private:
    using Bytes = std::vector<unsigned char>;
    /// A node of the tree of readings. For each reading of the next register it contains a node or, after the last
    /// register, a result.
    using Node = std::vector<std::uint32_t>;
    struct Found;
    void explore_cycles_from(std::uint32_t image, std::vector<std::uint32_t>& open, Found& found) const;
    const std::vector<bool>& without_effect_below(std::uint32_t node, std::size_t level) const;
    std::uint32_t build_tree(const Bytes& from, std::vector<rc_register>& registers, std::size_t read);
    void append_to_key(std::uint32_t number);
    std::uint32_t intern_node(std::size_t level, Node);
    [[nodiscard]] std::uint32_t run_all_choices(const Bytes& from, const std::vector<rc_register>& registers);
    std::uint32_t endless(const Bytes& from);
    std::uint32_t run_once(const Bytes& from, const std::vector<rc_register>& registers);
    [[nodiscard]] CycleResult result_of(rc_result, const rc_log&, const Bytes&);
    std::uint32_t intern_result(CycleResult);
    void add_reads(lts::StateView state, lts::SuccessorSink& sink);
    void add_writes(lts::StateView state, lts::SuccessorSink& sink);
    void add_end_of_cycle(lts::StateView state, const CycleResult& result, lts::SuccessorSink& sink);

    const rc_interface* code_;
    const Alphabet* alphabet_;
    std::uint32_t cycle_length_;
    CodeImages images_;
    std::unordered_map<std::uint32_t, std::uint32_t>
        roots_;                         ///< image -> its tree; never iterated, like the maps below
    std::vector<std::uint32_t> begun_;  ///< images in `roots_`
    std::unordered_map<std::string, std::uint32_t> node_ids_;
    std::unordered_map<std::string, std::uint32_t> result_ids_;
    /// Used by one cycle each; members, so that they are allocated once.
    std::string key_;
    CycleLog log_, again_;
    Bytes once_, twice_;
    std::vector<Node> nodes_;
    std::deque<CycleResult> results_;  ///< a deque, so that references stay valid
    std::uint64_t cycles_ = 0;
    std::uint32_t most_writes_ = 0;
    /// Polled while the inputs of one state are tried, because this may take long.
    diagnostics::Pollable* budget_ = &diagnostics::unlimited;
    std::string unsound_;
    bool endless_ = false;
    mutable std::vector<std::unordered_map<std::uint32_t, std::vector<bool>>> without_effect_;  ///< by register
};

}  // namespace robochart::conformance
