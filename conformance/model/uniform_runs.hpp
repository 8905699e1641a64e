// SPDX-License-Identifier: Apache-2.0
// Follows code that has read only some registers with uniform runs of NF_c(M): runs that are possible for all contents
// of the other registers (docs/conformance.md, "Reading on demand").
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "conformance/code/explored_code.hpp"
#include "conformance/model/model_graph.hpp"

namespace robochart::conformance {

/// A state of M in a cycle. `held` is the number of the set of readings that M may still receive.
struct HeldState {
    ModelState model = 0;
    std::uint32_t held = 0;

    friend auto operator<=>(const HeldState&, const HeldState&) = default;
};

class UniformRuns {
public:
    /// The number of a set of states in which M may be before it acts further.
    using Set = std::uint32_t;
    /// The readings that are assumed for registers that the code has not read at a leaf of its cycle.
    struct Completion {
        Set states = 0;  ///< the states at the beginning of the next cycle, if there is a next cycle
        std::vector<std::pair<std::uint32_t, std::uint32_t>> readings;  ///< registers and readings
    };

    UniformRuns(ModelGraph& model, const Alphabet& alphabet, std::uint32_t cycle_length);

    [[nodiscard]] Set start();
    /// Returns the set of states after the code has read a register that is present.
    [[nodiscard]] Set with(Set states, std::uint32_t input, std::uint32_t reading);
    /// Returns the set of states after M has made this output. Returns no value if M cannot make the output while all
    /// registers that the code has not read are empty.
    [[nodiscard]] std::optional<Set> after(Set states, process::Event write);
    /// Follows the end of the code's cycle. Adds completions that together cover all readings of the unread registers.
    /// Returns false if NF_c(M) cannot end its cycle for some of these readings. `refused` then contains these
    /// readings; all other registers are empty.
    [[nodiscard]] bool finish(Set states, const std::vector<bool>& unread, rc_result outcome,
                              std::vector<Completion>& completions, Completion& refused);

    [[nodiscard]] std::size_t sets() const { return sets_.size(); }

private:
    using Reading = std::pair<std::uint32_t, std::uint32_t>;  ///< register and reading
    using States = std::vector<HeldState>;
    /// The parts of both kinds of lists are pairs of numbers.
    struct Hash {
        std::size_t operator()(const States& states) const;
        std::size_t operator()(const std::vector<Reading>& readings) const;
    };
    /// The steps of M that are possible from a set, without input or with the readings that M may still receive.
    struct Closure {
        bool known = false;
        bool terminated = false;
        States all;
        std::map<process::Event, Set> writes;
    };

    [[nodiscard]] Set intern(States);
    [[nodiscard]] std::uint32_t intern_held(std::vector<Reading>);
    [[nodiscard]] HeldState narrowed(ModelState model, std::uint32_t held);
    [[nodiscard]] const Closure& closure(Set);
    [[nodiscard]] bool holds(std::uint32_t held, std::uint32_t input, std::uint32_t reading) const;
    /// Returns whether M cannot do anything in this state before time passes.
    [[nodiscard]] bool stable(const HeldState&);
    [[nodiscard]] bool lets_time_pass(ModelState);
    /// Returns a register that the code has not read and for whose input M waits in a stable state. Returns no value if
    /// there is no such register.
    [[nodiscard]] std::optional<std::uint32_t> awaits(ModelState, const std::vector<bool>& unread);
    [[nodiscard]] std::optional<Set> after_time(const States& stable);
    [[nodiscard]] States settled_between_tocks(States);

    ModelGraph* model_;
    const Alphabet* alphabet_;
    std::uint32_t cycle_length_;
    std::deque<Closure> closures_;  ///< by set; a deque, so that references stay valid
    /// Sets and lists by their numbers. The keys of the maps, which never move, are the only copies. No map is
    /// iterated.
    std::vector<const States*> sets_;
    std::unordered_map<States, Set, Hash> set_ids_;
    std::vector<const std::vector<Reading>*> held_;
    std::unordered_map<std::vector<Reading>, std::uint32_t, Hash> held_ids_;
    std::unordered_map<std::uint64_t, Set> with_;
};

}  // namespace robochart::conformance
