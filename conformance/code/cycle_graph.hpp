// SPDX-License-Identifier: Apache-2.0
// Explores the cycles of compiled code as graphs. A register is tried with each of its readings only where the code
// reads it. Paths that reach the same point of a cycle share the rest of the cycle (docs/conformance.md, "Reading on
// demand").
#pragma once

#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "conformance/code/code_images.hpp"
#include "conformance/code/cycle_log.hpp"
#include "conformance/code/explored_code.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

/// Thrown if the code cannot be explored in this way; the message contains the reason. The exploration then gives no
/// information about the code.
class NotProbed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class CycleGraph : public ExploredCode {
public:
    /// How a segment of a cycle ends.
    enum class End : std::uint8_t {
        open,     ///< not explored yet
        reading,  ///< the code reads `input`; with reading r it continues in segment `next + r`
        round,    ///< the cycle continues in segment `next`, which may be shared by other segments
        leaf,     ///< the cycle ends; `next` is the number of the leaf
    };
    struct Segment {
        End end = End::open;
        std::uint32_t writes = 0;  ///< number of the sequence of outputs in the segment
        std::uint32_t input = 0;
        std::uint32_t next = 0;
    };
    struct Leaf {
        rc_result outcome = RC_QUIESCENT;
        std::uint32_t next = 0;    ///< number of the next image
        std::vector<bool> unread;  ///< for each register: true if the cycle has not read it
    };

    /// Throws NotProbed if the code does not offer the calls of rc_probe.
    CycleGraph(const rc_interface& code, const Alphabet& alphabet, std::uint32_t cycle_length);

    /// Returns the segment with which the cycles of this image begin. Throws NotProbed.
    [[nodiscard]] std::uint32_t root(std::uint32_t image);
    [[nodiscard]] const Segment& segment(std::uint32_t number) const { return segments_[number]; }
    [[nodiscard]] const std::vector<process::Event>& outputs(const Segment& segment) const {
        return sequences_[segment.writes];
    }
    [[nodiscard]] const Leaf& leaf(const Segment& segment) const { return leaves_[segment.next]; }

    [[nodiscard]] std::uint32_t cycle_length() const override { return cycle_length_; }
    [[nodiscard]] std::uint32_t reset_image() const override { return images_.reset(); }
    [[nodiscard]] std::uint32_t most_writes() const override { return most_writes_; }
    [[nodiscard]] std::vector<unsigned char> image_bytes(std::uint32_t image) const override {
        return images_.bytes(image);
    }
    [[nodiscard]] std::string print_image(std::uint32_t image) const override { return images_.print(image); }
    [[nodiscard]] const std::vector<std::uint32_t>& started_images() const override { return begun_; }
    [[nodiscard]] std::vector<PassedCycle> path_to_image(std::uint32_t image) const override;
    [[nodiscard]] std::uint32_t cycles_of(std::uint32_t image) const override { return roots_.at(image); }
    [[nodiscard]] std::vector<bool> without_effect(std::uint32_t image) const override;
    [[nodiscard]] std::vector<std::uint32_t> next_images(std::uint32_t image) const override;
    [[nodiscard]] std::vector<process::Event> writes(std::uint32_t image,
                                                     const std::vector<Raised>& raised) const override;

    [[nodiscard]] std::uint64_t image_count() const { return images_.size(); }
    [[nodiscard]] bool has_alias() const { return images_.alias_found(); }
    /// Returns the number of cycles that were run. Each cycle represents all readings of the registers that it does not
    /// read.
    [[nodiscard]] std::uint64_t cycle_count() const { return cycles_; }
    /// Sets the budget that is polled for every cycle; it must outlive its use.
    void set_budget(diagnostics::Pollable& budget) { budget_ = &budget; }

private:
    using Bytes = CodeImages::Bytes;
    struct Answer {
        std::uint32_t input = 0;
        std::uint32_t reading = 0;
    };

    // The following functions are called by the code (rc_probe), and do the work of these calls.
    static std::uint32_t on_read(void* graph, std::uint32_t input);
    static std::uint32_t on_value(void* graph, std::uint32_t input);
    static void on_assigned(void* graph, std::uint32_t input);
    static void on_round(void* graph, const void* step, std::uint32_t size, const void* state, std::uint32_t left);
    std::uint32_t read(std::uint32_t input);
    std::uint32_t take(std::uint32_t input);
    void round(const unsigned char* step, std::uint32_t size, const unsigned char* state, std::uint32_t left);

    void run(std::uint32_t image, std::uint32_t root);
    void begin_run(std::uint32_t root);
    [[nodiscard]] bool next_answers();
    void end_run(rc_result outcome, const Bytes& after);
    void run_again(const Bytes& from, rc_result outcome, const Bytes& after, bool unread_present);
    void check_shared_path(rc_result outcome, const Bytes& after);
    void close(End end, std::uint32_t input, std::uint32_t next);
    void close_endless();
    [[nodiscard]] bool same_outputs(const Segment&) const;
    void make_key(const unsigned char* step, std::uint32_t size, const unsigned char* state);
    [[nodiscard]] process::Event event_of(const rc_record&);
    [[nodiscard]] std::uint32_t add_segments(std::size_t count);
    [[nodiscard]] std::uint32_t intern_sequence(std::vector<process::Event>);
    [[nodiscard]] std::uint32_t intern_leaf(rc_result, std::uint32_t next);
    void fault(const char* reason);

    const rc_interface* code_;
    const Alphabet* alphabet_;
    std::uint32_t cycle_length_;
    std::size_t inputs_;
    CodeImages images_;
    std::vector<std::uint32_t> begun_;
    std::vector<Segment> segments_;
    std::vector<std::vector<process::Event>> sequences_;
    std::vector<Leaf> leaves_;
    // These maps are never iterated.
    std::unordered_map<std::uint32_t, std::uint32_t> roots_;       ///< image -> segment
    std::unordered_map<std::string, std::uint32_t> points_;        ///< key of a round -> segment
    std::unordered_map<std::string, std::uint32_t> sequence_ids_;  ///< events as bytes
    std::unordered_map<std::string, std::uint32_t> leaf_ids_;
    std::unordered_map<std::string, process::Event> events_;  ///< records as bytes
    std::uint64_t cycles_ = 0;
    std::uint32_t most_writes_ = 0;
    std::uint32_t most_steps_ = 0;  ///< the maximal number of steps in a run that ends
    bool endless_ = false;          ///< some call did not return
    std::string unsound_;
    std::string refused_;  ///< the reason why the code cannot be explored in this way
    diagnostics::Pollable* budget_ = &diagnostics::unlimited;
    mutable std::deque<CycleResult> shown_;  ///< results of path_to_image; a deque, so that references stay valid

    // The following members describe the run in progress.
    std::vector<Answer> answers_;  ///< answers to the reads on the run's path, in their order
    std::size_t answered_ = 0;
    std::uint32_t current_ = 0;  ///< number of the current segment
    std::uint32_t first_write_ = 0;
    bool shared_ = false;  ///< true after a point from which another run has continued: registers are then empty
    std::uint32_t shared_point_ = 0;
    std::uint32_t shared_write_ = 0;
    CycleLog log_, again_;
    std::vector<std::int64_t> known_;  ///< for each register: -1 unread, otherwise its reading
    std::vector<bool> spent_;          ///< by register: absent, or consumed
    std::vector<bool> sealed_;         ///< by register: spent when a round began; its value must not be read again
    std::vector<std::uint32_t> rounds_;
    std::uint32_t steps_at_start_ = 0;
    std::uint32_t steps_ = 0;
    std::string key_;
};

}  // namespace robochart::conformance
