// SPDX-License-Identifier: Apache-2.0
// Caches results of whole cycles, for monitors of many controllers of one component. If a controller has performed the
// same cycle from the same state before, one look-up replaces the look-ups for all events of the cycle.
#pragma once

#include <cstdint>
#include <vector>

#include "cpp_emit/runtime/drive_abi.h"
#include "cpp_emit/runtime/monitor.hpp"
#include "cpp_emit/simulator_api.hpp"

namespace robochart::conformance {

/// A cache of cycles. It is exact: a result is used only for the same state, the same readings, and the same columns of
/// outputs in the same order. Outputs seldom differ for equal states and readings, so few outcomes are stored for each.
/// Not thread-safe.
class CycleCache {
public:
    /// `inputs` and `outputs` are as in the tables.
    CycleCache(const MonitorTables&, const std::vector<cpp_emit::Port>& inputs,
               const std::vector<cpp_emit::Port>& outputs);

    /// Passes a cycle's inputs and outputs to a monitor with these tables.
    void pass_cycle(Monitor&, const rc_signal* inputs, const rc_actions& outputs, rc_drive_result);

    /// Returns the number of cycles that were answered by one look-up.
    [[nodiscard]] std::uint64_t hit_count() const { return remembered_; }

private:
    /// The values of arguments of one type.
    struct Carrier {
        const MonitorValues* values = nullptr;
        bool real = false;
        std::uint64_t first = 0;
        std::uint64_t consecutive = 0;  ///< number of consecutive whole numbers; the index of each is its offset from
                                        ///< the first
        struct {
            std::uint64_t bits = 0;
            std::uint32_t place = Monitor::no_place;
        } known[8];  ///< real numbers seen before, by their bits
    };
    struct Channel {
        const std::uint16_t* column = nullptr;
        std::uint32_t count = 0;                ///< number of arguments
        std::uint16_t alone = Monitor::dead;    ///< the column if there are no arguments
        std::vector<std::uint32_t> carriers{};  ///< by argument
        std::uint32_t carrier = 0;              ///< index of the first argument's carrier
    };
    /// The state in which a cycle begins, and its readings.
    struct Key {
        std::uint64_t head = 0;    ///< the state, and the set of present inputs
        std::uint64_t values = 0;  ///< values of the inputs, `width_` bits each

        friend bool operator==(const Key&, const Key&) = default;
    };
    /// An output that occurred in a cycle.
    struct Done {
        std::uint64_t bits = 0;  ///< bits of its single argument
        std::uint64_t mask = 0;  ///< mask for these bits; 0 if there is no argument
        std::uint32_t output = 0;
        std::uint16_t column = 0;
        std::uint16_t many = 0;  ///< not 0: the output has several arguments
    };
    static constexpr std::uint32_t most_done = 6;
    struct alignas(64) Slot {
        Key key{~std::uint64_t{0}, 0};  ///< initially, matches no cycle
        std::uint32_t count = 0;
        std::uint16_t next = Monitor::dead;
        Done done[most_done];
    };

    [[nodiscard]] Channel make_channel(const MonitorChannel&, const cpp_emit::Port&);
    [[nodiscard]] std::uint32_t carrier_number(const MonitorValues&, bool real);
    [[nodiscard]] std::uint32_t carrier_place(std::uint32_t carrier, rc_value);
    [[nodiscard]] static std::uint32_t new_place(Carrier&, rc_value);
    [[nodiscard]] std::uint32_t output_column(const rc_action&);
    [[nodiscard]] std::uint32_t column_of_many(const rc_action&);
    [[nodiscard]] bool make_key(const rc_signal*, Key&);
    [[nodiscard]] Slot& slot_for_key(const Key&);
    [[nodiscard]] bool matches_recorded(const Done&, const rc_action&);
    [[nodiscard]] bool matches_recorded(const Slot&, const rc_actions&);
    void try_second_slot(Slot&, const Key&, Monitor&, const rc_signal*, const rc_actions&);
    void store_cycle(Slot&, const Key&, const rc_actions&, std::uint16_t next);
    void pass_events(Monitor&, const rc_signal*, const rc_actions&, rc_drive_result) const;

    std::vector<Carrier> carriers_;
    std::vector<Channel> inputs_, outputs_;
    std::vector<std::uint32_t> valued_;  ///< inputs that carry a value
    std::size_t input_count_ = 0;
    unsigned width_ = 1;     ///< number of bits of a value in a key
    bool has_keys_ = false;  ///< true if all inputs fit into one key
    std::vector<Slot> slots_;
    std::uint64_t remembered_ = 0;
};

}  // namespace robochart::conformance
