// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/types/builtins.hpp"

#include <algorithm>
#include <array>

namespace robochart::cspm {

namespace {

using enum Visibility;

constexpr std::array names{
    BuiltinName{"true", Builtin::true_, -1},
    BuiltinName{"false", Builtin::false_, -1},
    BuiltinName{"True", Builtin::true_, -1},
    BuiltinName{"False", Builtin::false_, -1},
    BuiltinName{"Bool", Builtin::bool_, -1},
    BuiltinName{"Int", Builtin::int_, -1},
    BuiltinName{"Char", Builtin::char_, -1},
    BuiltinName{"Proc", Builtin::proc, -1},
    BuiltinName{"Events", Builtin::events, -1},
    BuiltinName{"emptyMap", Builtin::empty_map, -1},
    BuiltinName{"union", Builtin::union_, 2},
    BuiltinName{"inter", Builtin::inter, 2},
    BuiltinName{"diff", Builtin::diff, 2},
    BuiltinName{"Union", Builtin::union_all, 1},
    BuiltinName{"Inter", Builtin::inter_all, 1},
    BuiltinName{"member", Builtin::member, 2},
    BuiltinName{"card", Builtin::card, 1},
    BuiltinName{"empty", Builtin::empty, 1},
    BuiltinName{"set", Builtin::set, 1},
    BuiltinName{"Set", Builtin::powerset, 1},
    BuiltinName{"Seq", Builtin::sequences, 1},
    BuiltinName{"seq", Builtin::seq, 1},
    BuiltinName{"length", Builtin::length, 1},
    BuiltinName{"null", Builtin::null, 1},
    BuiltinName{"head", Builtin::head, 1},
    BuiltinName{"tail", Builtin::tail, 1},
    BuiltinName{"concat", Builtin::concat, 1},
    BuiltinName{"elem", Builtin::elem, 2},
    BuiltinName{"mapFromList", Builtin::map_from_list, 1},
    BuiltinName{"mapLookup", Builtin::map_lookup, 2},
    BuiltinName{"mapMember", Builtin::map_member, 2},
    BuiltinName{"mapToList", Builtin::map_to_list, 1},
    BuiltinName{"mapUpdate", Builtin::map_update, 3},
    BuiltinName{"mapUpdateMultiple", Builtin::map_update_multiple, 2},
    BuiltinName{"mapDelete", Builtin::map_delete, 2},
    BuiltinName{"Map", Builtin::map_type, 2},
    BuiltinName{"extensions", Builtin::extensions, 1},
    BuiltinName{"productions", Builtin::productions, 1},
    BuiltinName{"error", Builtin::error, 1},
    BuiltinName{"show", Builtin::show, 1},
    BuiltinName{"STOP", Builtin::stop, -1},
    BuiltinName{"SKIP", Builtin::skip, -1},
    BuiltinName{"DIV", Builtin::div, -1},
    BuiltinName{"CHAOS", Builtin::chaos, 1},
    BuiltinName{"RUN", Builtin::run, 1},
    BuiltinName{"WAIT", Builtin::wait, 1, timed_sections},
    BuiltinName{"timed_priority", Builtin::timed_priority, 1, timed_sections},
    BuiltinName{"BUFFER", Builtin::buffer, 2},
    BuiltinName{"WEAK_BUFFER", Builtin::weak_buffer, 3},
    BuiltinName{"SIGNAL_BUFFER", Builtin::signal_buffer, 4},
    BuiltinName{"chase", Builtin::chase, 1, transparent_or_external},
    BuiltinName{"chase_nocache", Builtin::chase_nocache, 1, transparent_or_external},
    BuiltinName{"deter", Builtin::deter, 1, external},
    BuiltinName{"failure_watchdog", Builtin::failure_watchdog, 3, external},
    BuiltinName{"loop", Builtin::loop, 1, external},
    BuiltinName{"prioritise", Builtin::prioritise, 2, external},
    BuiltinName{"prioritise_nocache", Builtin::prioritise_nocache, 2, external},
    BuiltinName{"prioritisepo", Builtin::prioritisepo, 4, external},
    BuiltinName{"trace_watchdog", Builtin::trace_watchdog, 3, external},
    BuiltinName{"mtransclose", Builtin::mtransclose, 2, external},
    BuiltinName{"relational_image", Builtin::relational_image, 1, external},
    BuiltinName{"relational_inverse_image", Builtin::relational_inverse_image, 1, external},
    BuiltinName{"transpose", Builtin::transpose, 1, external},
    BuiltinName{"explicate", Builtin::explicate, 1, transparent},
    BuiltinName{"lazyenumerate", Builtin::lazyenumerate, 1, transparent},
    BuiltinName{"diamond", Builtin::diamond, 1, transparent},
    BuiltinName{"normal", Builtin::normal, 1, transparent},
    BuiltinName{"lazynorm", Builtin::lazynorm, 1, transparent},
    BuiltinName{"sbisim", Builtin::sbisim, 1, transparent},
    BuiltinName{"tau_loop_factor", Builtin::tau_loop_factor, 1, transparent},
    BuiltinName{"model_compress", Builtin::model_compress, 1, transparent},
    BuiltinName{"wbisim", Builtin::wbisim, 1, transparent},
    BuiltinName{"dbisim", Builtin::dbisim, 1, transparent},
};

}  // namespace

std::span<const BuiltinName> builtin_names() {
    return names;
}

const BuiltinName* find_builtin(std::string_view name) {
    const auto* found = std::ranges::find(names, name, &BuiltinName::name);
    return found == names.end() ? nullptr : found;
}

const BuiltinName& builtin_name(Builtin builtin) {
    return *std::ranges::find(names, builtin, &BuiltinName::builtin);
}

}  // namespace robochart::cspm
