// SPDX-License-Identifier: Apache-2.0
// Computes the orders of prioritise and prioritisepo (FDR manual; Roscoe, UCS 20.2).
#pragma once

#include <variant>

#include "checker/process/term.hpp"

namespace robochart::process {

/// The level of an event that prevents no other event and that no other event prevents.
inline constexpr std::uint32_t no_level = 0xffffffffU;

/// Returns the level of each event in the order of a prioritise. Events after the end of the vector have no level
/// (no_level).
[[nodiscard]] std::vector<std::uint32_t> levels_of(const PriorityOrder& order);

/// The reason why prioritisepo does not accept the events and pairs as an order.
struct OrderFault {
    enum class Kind {
        missing,      ///< the event is in a pair or maximal, but not among the prioritised events
        cyclic,       ///< the order is cyclic: an event is above itself
        not_maximal,  ///< the event is declared maximal but is below another event
    };
    Kind kind;
    Event event;
};

/// Returns all pairs (higher, lower) of the order, ascending: the transitive closure of the given pairs, with tau and
/// tick above every prioritised event that is not maximal. The sets must be ascending.
[[nodiscard]] std::variant<Renaming, OrderFault> priority_order(const EventSet& prioritised,
                                                                const std::vector<EventPair>& pairs,
                                                                const EventSet& maximal);

}  // namespace robochart::process
