// SPDX-License-Identifier: Apache-2.0
// Lists the seeded faults of the generator: errors that a generator of robot code can make, each with a name. They test
// the conformance checker (mutation analysis; docs/conformance.md, "Mutants").
#pragma once

#include <span>

namespace robochart::cpp_emit {

/// The kind of a fault; `none` in production. all_faults() describes each kind.
enum class Fault {
    none,
    // which transitions are taken, and when
    guard_after_consume,
    guard_negated,
    guard_dropped,
    predicate_dropped,
    trigger_value_old,
    transitions_reversed,
    outer_first,
    order_ignored,
    junction_reversed,
    way_exchanged,
    wrong_target,
    single_transition_step,
    // states
    children_not_exited,
    composite_resumed,
    entry_dropped,
    exit_dropped,
    action_dropped,
    entry_inner_first,
    exit_outer_first,
    action_before_exit,
    action_after_entry,
    during_not_cut,
    during_again,
    during_never,
    // programs
    assignment_dropped,
    part_not_assigned,
    call_dropped,
    send_dropped,
    statements_exchanged,
    branches_exchanged,
    input_not_awaited,
    loop_never_ends,
    output_repeated,
    wrong_output,
    // events
    event_kept,
    event_not_consumed,
    wrong_input,
    value_not_stored,
    fields_lost,
    send_not_awaited,
    offer_kept,
    wrong_sender,
    buffer_kept,
    buffer_first,
    // operations
    argument_swapped,
    argument_dropped,
    operation_not_awaited,
    operation_kept,
    precondition_negated,
    function_precondition_dropped,
    // composition of machines
    ended_by_one,
    end_unnoticed,
    machines_reversed,
    write_not_relayed,
    outside_write_late,
    outside_write_lost,
    initial_lost,
    // time
    clock_not_reset,
    clock_off_by_one,
    clock_twice,
    clock_stopped,
    clock_saturated,
    reset_before_guard,
    wait_dropped,
    wait_late,
    wait_early,
    deadline_kept,
    deadline_ignored,
    deadline_late,
    deadline_early,
    deadline_not_restarted,
    // expressions
    arithmetic_wrong,
    comparison_wrong,
    logic_wrong,
    negation_dropped,
    operands_exchanged,
    conditional_exchanged,
    literal_wrong,
    index_off_by_one,
    member_wrong,
    field_dropped,
    quantifier_wrong,
    set_operation_wrong,
    // the event API
    dispatch_shifted,
    dispatch_guard_dropped,
    dispatch_guard_ends,
    dispatch_outer_first,
    dispatch_exits_dropped,
    dispatch_reset_dropped,
    dispatch_value_lost,
    dispatch_deadline_kept,
    dispatch_event_kept,
    dispatch_look_dropped,
    dispatch_not_begun,
    dispatch_clock_early,
    dispatch_other_value,
    dispatch_others_read,
    dispatch_end_unnoticed,
    pass_not_quiet,
    pass_timeless,
    // RoboSim
    cycle_output_again,
    cycle_exec_dropped,
    cycle_moves_on,
    cycle_effect_early,
    cycle_store_late,
    cycle_stop_hidden,
    cycle_time_unit,
    cycle_end_early,
    cycle_read_late,
    // code that does not compile
    name_collision,
    undeclared_member,
};

/// A kind of fault, with its description.
struct FaultKind {
    Fault fault;
    const char* name;
    const char* what;  ///< what generated code with the fault does wrong
};

/// Returns all kinds except `none`, in the order of the enumeration.
[[nodiscard]] std::span<const FaultKind> all_faults();

/// Returns whether the fault affects only the event API, not the cycle.
[[nodiscard]] constexpr bool in_event_api(Fault fault) {
    return fault >= Fault::dispatch_shifted && fault <= Fault::pass_timeless;
}

/// Returns whether the fault affects only code of RoboSim.
[[nodiscard]] constexpr bool in_robosim(Fault fault) {
    return fault >= Fault::cycle_output_again && fault <= Fault::cycle_read_late;
}

}  // namespace robochart::cpp_emit
