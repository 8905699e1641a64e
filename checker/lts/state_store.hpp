// The visited set: exact packed states of one width, numbered in the order of insertion. Open addressing over slots of
// (index, 32 hash bits) in independent segments, so that growth copies one segment at a time; a hit compares the state.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "checker/lts/transition_system.hpp"

namespace robochart::lts {

using StateIndex = std::uint32_t;
inline constexpr StateIndex no_state = std::numeric_limits<StateIndex>::max();

class StateStore {
public:
    explicit StateStore(std::size_t width);

    struct Insertion {
        StateIndex index;
        bool fresh;
    };
    Insertion insert(StateView state);
    [[nodiscard]] StateIndex find(StateView state) const;  ///< no_state if it is not there
    /// The view stays valid while states are added.
    [[nodiscard]] StateView operator[](StateIndex index) const;
    [[nodiscard]] std::size_t size() const { return size_; }

private:
    struct Slot {
        StateIndex index = no_state;
        std::uint32_t tag = 0;
    };
    struct Segment {
        std::vector<Slot> slots;
        std::size_t used = 0;
    };
    static constexpr std::size_t segment_bits = 6;
    static constexpr std::size_t states_per_chunk = 4096;

    [[nodiscard]] std::size_t find_slot(const Segment& segment, std::uint32_t tag, StateView state) const;
    static void grow(Segment& segment);
    StateIndex append(StateView state);

    std::size_t width_;
    std::size_t size_ = 0;
    std::array<Segment, std::size_t{1} << segment_bits> segments_;
    std::vector<std::unique_ptr<Word[]>> chunks_;
};

}  // namespace robochart::lts
