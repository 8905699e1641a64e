// SPDX-License-Identifier: Apache-2.0
// Lists the properties of operators that algorithms on terms need, in one table. The firing rules define the meaning of
// the operators (firing_rules.cpp and composition_rules.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "checker/process/term.hpp"

namespace robochart::process {

/// Groups of operators that an algorithm treats alike.
enum class OpGroup : std::uint8_t {
    leaf,             ///< has no operands that move: a basic process, a name, a state of a machine
    prefix,           ///< performs its own events, then becomes the continuation
    internal_choice,  ///< performs its own taus, then becomes an operand
    parallel,         ///< all operands stay while they move
    unary,            ///< the operand stays; its steps get another name, or are prevented
    resolving,        ///< one operand can replace the operator
    synchronising,    ///< as `resolving`, but the operands can also move together and keep the operator
    compression       ///< performs the steps of a machine that is computed from the operand
};

/// Which operands can move from the start: their transitions determine those of the operator.
enum class Running : std::uint8_t { none, first, all };

/// The table to whose entries the payload of a term refers. `none` if there is no payload, or if it is of another
/// kind.
enum class Payload : std::uint8_t { none, set, renaming, order };

/// The properties of an operator.
struct OpProperties {
    OpGroup group;
    Running running;
    std::optional<std::size_t> operands;  ///< no value if their number varies
    Payload payload;
};

/// Returns the properties of the operator.
[[nodiscard]] constexpr OpProperties properties_of(Op op) {
    constexpr std::nullopt_t varies = std::nullopt;
    switch (op) {
        case Op::stop:
        case Op::skip:
        case Op::div:
        case Op::omega:
            return {OpGroup::leaf, Running::none, 0, Payload::none};
        case Op::run:
        case Op::chaos:
        case Op::chaos_offer:
            return {OpGroup::leaf, Running::none, 0, Payload::set};
        case Op::call:
        case Op::machine:
            return {OpGroup::leaf, Running::none, varies, Payload::none};
        case Op::prefix:
            return {OpGroup::prefix, Running::none, varies, Payload::none};
        case Op::internal_choice:
            return {OpGroup::internal_choice, Running::none, varies, Payload::none};
        case Op::external_choice:
            return {OpGroup::resolving, Running::all, varies, Payload::none};
        case Op::interrupt:
            return {OpGroup::resolving, Running::all, 2, Payload::none};
        case Op::sequential:
        case Op::sliding:
            return {OpGroup::resolving, Running::first, 2, Payload::none};
        case Op::exception:
            return {OpGroup::resolving, Running::first, 2, Payload::set};
        case Op::sync_choice:
            return {OpGroup::synchronising, Running::all, varies, Payload::set};
        case Op::sync_interrupt:
            return {OpGroup::synchronising, Running::all, 2, Payload::set};
        case Op::parallel:
            return {OpGroup::parallel, Running::all, varies, Payload::set};
        case Op::alphabetised:
            return {OpGroup::parallel, Running::all, varies, Payload::none};
        case Op::hide:
            return {OpGroup::unary, Running::all, 1, Payload::set};
        case Op::rename:
        case Op::prioritise_order:
            return {OpGroup::unary, Running::all, 1, Payload::renaming};
        case Op::prioritise:
            return {OpGroup::unary, Running::all, 1, Payload::order};
        case Op::chase:
            return {OpGroup::compression, Running::all, 1, Payload::none};
        case Op::compress:
            return {OpGroup::compression, Running::all, varies, Payload::none};
    }
    return {OpGroup::leaf, Running::none, varies, Payload::none};
}

/// Returns how many of the operands run from the start. Any other operand starts when a running operand ends and is
/// replaced by it.
[[nodiscard]] constexpr std::size_t running_operands(Op op, std::size_t operands) {
    switch (properties_of(op).running) {
        case Running::none:
            return 0;
        case Running::first:
            return 1;
        case Running::all:
            return operands;
    }
    return 0;
}

}  // namespace robochart::process
