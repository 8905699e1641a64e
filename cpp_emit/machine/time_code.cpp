// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/time_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/code/suspension.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "semantics/instantiate/instantiate.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

bool TimeCode::is_timed() const {
    const auto& read = unit_.clock_read;
    const auto timed_calls = [&](const Thread& thread) {
        return thread.waits || !thread.deadlines.empty() || !thread.held_up.empty() ||
               std::ranges::any_of(thread.calls,
                                   [&](const CallFrame& call) { return context_.done.at(call.operation).timed; });
    };
    return std::ranges::find(read, true) != read.end() || !watches_.empty() || timed_calls(control_) ||
           std::ranges::any_of(during_, [&](const DuringThread& during) { return timed_calls(during.thread); });
}

void TimeCode::advance_function() {
    if (!is_timed()) return;
    out_.open_declaration("Time passes: clocks, waits and deadlines.", function_head("void advance"));
    for (const Watch& watch : watches_) advance_watch(watch);
    for (std::uint32_t index = 0; index < unit_.clock_fields.size(); ++index) {
        if (!unit_.clock_read[index]) continue;
        const std::int64_t saturation =
            std::min(generation_.inst.clock_bound,
                     ir::clock_saturation(generation_.system, generation_.inst, *unit_.machine, ir::ClockId{index}));
        advance_clock(unit_.clock_fields[index], saturation);
    }
    advance_thread(control_);
    for (const DuringThread& during : during_) advance_thread(during.thread);
    if (guards_deadlines(*unit_.machine)) out_.line(function_call("watch") + ";");
    out_.close();
}

void TimeCode::advance_clock(const std::string& clock, std::int64_t saturation) {
    const bool counts_cycles = generation_.component.robosim && generation_.mutation.hits(Fault::cycle_time_unit);
    out_.line(fmt::format("advance_clock(f.{}, {}, {});", clock, counts_cycles ? "1" : "cycle_length", saturation));
}

void TimeCode::advance_thread(const Thread& thread) {
    if (thread.waits) out_.line(fmt::format("advance_wait({}, cycle_length);", thread.wait));
    for (const std::string& deadline : thread.deadlines)
        out_.line(fmt::format("advance_deadline(f.{}, cycle_length);", deadline));
    for (const std::string& label : thread.held_up)
        out_.line(fmt::format("if ({} == {}) stop_time();", thread.variable, thread.qualified_label(label)));
    for (const CallFrame& call : thread.calls)
        if (context_.done.at(call.operation).timed)
            out_.line(fmt::format("if ({}) {};", MachineContext::in_call(thread, call),
                                  context_.call_inside(call, "advance")));
}

std::string TimeCode::guard_text(const ir::Transition& transition) const {
    ExpressionWriter expressions(generation_, unit_);
    const bool stores = transition.trigger && transition.trigger->variable.is_valid();
    if (stores) expressions.set_incoming(expressions.variable_member(transition.trigger->variable));
    return expressions.expression_asked(*transition.guard).whole_text();
}

/// Writes the function that restarts deadlines. The guard is evaluated wherever an observer could see the model wait:
/// after each step, before effects that others can observe, and after clocks have advanced.
void TimeCode::watch_function() {
    if (!guards_deadlines(*unit_.machine)) return;
    out_.open_declaration("A deadline begins anew while its guard does not hold.", function_head("void watch"));
    for (const Watch& watch : watches_) {
        const ir::Transition& transition = plan_.machine().transitions[watch.transition.index];
        if (!transition.guard) continue;
        const std::string anew = steps_.start_of(watch);
        out_.line(fmt::format("if (f.{} > 0 && !({})) {}", watch.field, guard_text(transition), anew));
    }
    out_.close();
}

void TimeCode::advance_watch(const Watch& watch) {
    const ir::Transition& transition = plan_.machine().transitions[watch.transition.index];
    const std::string advance = fmt::format("advance_deadline(f.{}, cycle_length);", watch.field);
    out_.line(transition.guard ? fmt::format("if ({}) {}", guard_text(transition), advance) : advance);
}

}  // namespace robochart::cpp_emit
