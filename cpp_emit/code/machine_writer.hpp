// The parts of a machine's code, in the order in which they are generated. Private to machine_code.
#pragma once

#include "cpp_emit/code/machine_code.hpp"
#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/cpp_expr.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// A state's during action as a thread of its own.
struct DuringThread {
    ir::NodeId state;
    std::string suffix;  ///< of its members and functions: during_SUFFIX, cut_SUFFIX
    NameScope labels;
    Thread thread;
};

/// The deadline of a transition: once its source is entered and while its guard holds, the source must be left in
/// time (semantics 3.10).
struct Watch {
    ir::TransitionId transition;
    ir::NodeId state;
    std::string field;  ///< of the frame: time left plus one, 0 when the state is not active
};

class MachineWriter {
public:
    MachineWriter(const Generation&, const Unit&, const Layouts& done, NameScope& type_names);
    MachineWriter(const MachineWriter&) = delete;
    MachineWriter& operator=(const MachineWriter&) = delete;

    [[nodiscard]] MachineCode write(const std::vector<Field>& more);

private:
    // machine_control.cpp: the programs of the control thread and of the during actions
    void control_places();
    void choice(ir::NodeId);
    bool ways(ir::NodeId, CodeWriter&, const char* end);
    bool pick_way(ir::NodeId, CodeWriter&, const char* end);
    void draw_place(ir::NodeId);
    void enter_place(ir::NodeId);
    void settle(ir::NodeId, CodeWriter&, const char* end);
    void begin(ir::NodeId initial, CodeWriter&);
    void exits(ir::NodeId);
    void exit_place(ir::NodeId);
    void take(ir::TransitionId);
    void take_place(ir::TransitionId);
    [[nodiscard]] ir::NodeId shown_while_taking(ir::TransitionId) const;
    void during_places();
    void note_entry(ir::NodeId, CodeWriter&);
    void mark_entered(ir::NodeId, CodeWriter&);

    // machine_straight.cpp: the programs that never wait
    [[nodiscard]] bool straight(ir::NodeId);
    [[nodiscard]] bool has_place(const ir::Transition&);
    [[nodiscard]] bool runs_on_entry(ir::NodeId) const;
    [[nodiscard]] std::string straight_program(const ir::StmtPtr&, std::size_t depth);
    void straight_function(const std::string& name, const diagnostics::ForeignText& comment);
    void enter_function(ir::NodeId);
    void exit_function(ir::NodeId);
    void leave_function(ir::NodeId);
    void take_function(ir::TransitionId);
    bool pass_function(ir::NodeId);
    [[nodiscard]] std::string leave(ir::NodeId) const;
    [[nodiscard]] std::string arrive(ir::NodeId);
    [[nodiscard]] const std::string& proceed(const ir::Transition&);

    // machine_control.cpp: seeded faults of order
    [[nodiscard]] bool enters_child_first(ir::NodeId);
    [[nodiscard]] ir::NodeId sole_first_child(ir::NodeId) const;
    void enter_child_first(ProgramWriter&, ir::NodeId);
    [[nodiscard]] bool exits_first(ir::NodeId);
    void exit_outer_before(ProgramWriter&, ir::NodeId);
    [[nodiscard]] bool acts_first(const ir::Transition&);
    void act_before(ProgramWriter&, ir::NodeId);
    [[nodiscard]] bool acts_late(const ir::Transition&);
    void act_late(ProgramWriter&, const ir::Transition&, const std::string& label);

    // machine_dispatch.cpp: one event at a time
    [[nodiscard]] bool direct() const;
    [[nodiscard]] bool urgent(const ir::Transition&) const;
    [[nodiscard]] bool asks_for(const ir::Transition&, const EventPort&) const;
    [[nodiscard]] bool goes_on(ir::NodeId rest) const;
    [[nodiscard]] bool look_after(ir::NodeId target) const;
    [[nodiscard]] std::string rest_result() const;
    [[nodiscard]] std::string incoming(const ir::Transition&) const;
    void case_effect(const ir::Transition&, const EventPort*, CodeWriter&);
    [[nodiscard]] std::vector<const ir::Transition*> candidates(ir::NodeId leaf, const EventPort*) const;
    [[nodiscard]] CppExpr case_condition(const ir::Transition&) const;
    void place_body(ir::NodeId, CodeWriter&);
    [[nodiscard]] const EventPort* taken_for(ir::NodeId row, const EventPort&,
                                             const std::vector<const EventPort*>& columns);
    [[nodiscard]] std::string case_body(ir::NodeId leaf, const EventPort*, std::size_t depth);
    void dispatch_function();
    void begin_machine(CodeWriter&);
    void begin_function(const std::vector<const EventPort*>& columns);
    void pass_function_of_time(const std::vector<const EventPort*>& columns);
    void dispatch_switch(const std::vector<ir::NodeId>& rows, const std::vector<const EventPort*>& columns);
    void dispatch_table(const std::vector<ir::NodeId>& rows, const std::vector<const EventPort*>& columns);

    // machine_transitions.cpp: which transition is taken
    void transition_functions();
    void from_function(ir::NodeId);
    /// True if nothing behind the transition can be reached.
    bool try_transition(const ir::Transition&);
    void reset_too_soon(const ir::Transition&);
    bool try_trigger(const ir::Transition&, ir::TransitionId);
    void begin_transition(const ir::Transition&, ir::TransitionId);
    [[nodiscard]] CppExpr guard(const ir::Transition&, const std::string& incoming) const;
    /// The call of the trace hook.
    [[nodiscard]] std::string tell_taken(ir::TransitionId) const;
    void depart(ir::NodeId source, ir::TransitionId);
    void pick_function();
    [[nodiscard]] CppExpr in_turn(const CppExpr& guard) const;
    [[nodiscard]] std::vector<std::string> attempts(ir::NodeId leaf) const;

    // machine_code.cpp: functions around them, the struct
    void thread_function(const Thread&, const std::string& name, const diagnostics::ForeignText& comment, bool control);
    void during_functions();
    void run_function();
    void run_alone(const std::string& parts, bool watches);
    void begin_exits_function();
    void advance_function();
    void advance_thread(const Thread&);
    void advance_clock(const std::string& clock, std::int64_t saturation);
    void watch_function();
    void advance_watch(const Watch&);
    /// The guard of a transition with a deadline; there is no incoming value, so it reads the variable
    /// (semantics 3.10).
    [[nodiscard]] std::string holds(const ir::Transition&) const;
    [[nodiscard]] std::string start_of(const Watch&) const;
    [[nodiscard]] FrameLayout layout(const std::vector<Field>& more);
    [[nodiscard]] std::vector<Field> variable_fields() const;
    [[nodiscard]] std::vector<Field> thread_fields() const;
    void thread_field(std::vector<Field>&, const Thread&, const std::string& wait) const;
    [[nodiscard]] Enumeration points() const;
    [[nodiscard]] std::vector<Enumeration> enumerations() const;
    [[nodiscard]] std::string frame_type() const { return unit_.frame + "<Types>"; }
    [[nodiscard]] std::string signature(const std::string& name) const;
    /// `name(f)`, with the states that the unit's functions take.
    [[nodiscard]] std::string call(const std::string& name) const;
    [[nodiscard]] bool timed() const;
    [[nodiscard]] std::string finished(const std::string& frame) const;

    const Generation& generation_;
    const Unit& unit_;
    const Layouts& done_;
    MachinePlan plan_;
    NameScope fields_;
    Thread control_;
    std::vector<DuringThread> during_;
    std::vector<Watch> watches_;
    std::string leaving_;                ///< enumeration of transitions in progress
    std::vector<ir::NodeId> histories_;  ///< Fault::composite_resumed
    std::vector<std::string> proceeds_;  ///< by transition: what follows its exits, once asked for
    CodeWriter out_{1};
};

}  // namespace robochart::cpp_emit
