// SPDX-License-Identifier: Apache-2.0
// Lists CSPM's predefined names (FDR manual, chapter CSPM, Built-In Definitions).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace robochart::cspm {

enum class Builtin : std::uint8_t {
    // clang-format off
    true_, false_, bool_, int_, char_, proc, events, empty_map,
    union_, inter, diff, union_all, inter_all, member, card, empty, set, powerset, sequences, seq,
    length, null, head, tail, concat, elem,
    map_from_list, map_lookup, map_member, map_to_list, map_update, map_update_multiple, map_delete, map_type,
    extensions, productions, error, show,
    stop, skip, div, chaos, run, wait, timed_priority, buffer, weak_buffer, signal_buffer,
    // must be declared transparent or external before use
    chase, chase_nocache, deter, failure_watchdog, loop, prioritise, prioritise_nocache, prioritisepo, trace_watchdog,
    mtransclose, relational_image, relational_inverse_image, transpose,
    explicate, lazyenumerate, diamond, normal, lazynorm, sbisim, tau_loop_factor, model_compress, wbisim, dbisim,
    // clang-format on
};

enum class Visibility : std::uint8_t { always, timed_sections, transparent, external, transparent_or_external };

struct BuiltinName {
    std::string_view name;
    Builtin builtin;
    int arguments;  ///< number of arguments; -1 for a value
    Visibility visibility = Visibility::always;
};

[[nodiscard]] std::span<const BuiltinName> builtin_names();
/// Returns the built-in with this name, or null if there is none.
[[nodiscard]] const BuiltinName* find_builtin(std::string_view name);
[[nodiscard]] const BuiltinName& builtin_name(Builtin builtin);

/// Returns true if the built-in evaluates its arguments only as far as it needs them.
[[nodiscard]] inline bool takes_by_need(Builtin which) {
    return (which >= Builtin::length && which <= Builtin::elem) ||
           (which >= Builtin::map_from_list && which <= Builtin::map_delete);
}

}  // namespace robochart::cspm
