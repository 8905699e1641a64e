// SPDX-License-Identifier: Apache-2.0
// Writes resumable programs. Each of them is one switch. A case runs until the program may have to wait (for time, for
// an input, for an operation). It then stores the next place and returns.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/generation.hpp"
#include "cpp_emit/plan/names.hpp"
#include "cpp_emit/plan/violation_place.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// A place in a program.
struct Place {
    std::string label;
    diagnostics::ForeignText comment;
    ir::NodeId state;  ///< the state that the machine shows at this place
    CodeWriter code{5};
};

/// The frame of an operation that a thread calls, which is a member of the caller's frame.
struct CallFrame {
    std::string field;
    std::size_t operation = 0;      ///< the operation's Unit::number
    std::vector<std::string> live;  ///< labels of the thread at which it waits for the operation
};

/// A place where a thread waits for another machine to receive the event that it sends.
struct SendSite {
    std::string channel;
    std::string thread;  ///< "f.at"
    std::string at;      ///< "At::S1_1"
    std::string next;    ///< "At::S1_2"
    std::string value;   ///< "" if the event carries no value
};

/// A step that a thread performs before other machines write: a call of the platform at which the thread resumes, or
/// the arrival at a communication with a deadline.
struct PromptStep {
    std::string there;               ///< the condition that the thread is before the step: "f.at == At::S1_1 && f.wait
                                     ///< == 0"
    std::vector<std::string> lines;  ///< the code of the step, and the assignment of the thread's place after it
};

/// One thread of a machine. It runs transitions and entries, or the during action of a state.
struct Thread {
    std::string variable;     ///< the member that stores the thread's place: "f.at"
    std::string enumeration;  ///< "At"
    std::string wait;         ///< the member that counts its waiting time: "f.wait"
    std::string prefix;       ///< prefix of the frames of operations that it calls
    NameScope* labels = nullptr;
    NameScope* fields = nullptr;  ///< names in the frame, for frames of operations
    std::vector<Place> places;    ///< in textual order
    std::vector<CallFrame> calls;
    std::vector<SendSite> sites;
    std::vector<ViolationPlace> violations;  ///< places at which it stays after a false precondition of an operation
    std::vector<PromptStep> prompt_steps;
    std::vector<std::string> holding;            ///< labels of places where it awaits communications with deadlines
    std::vector<std::string> held_up;            ///< labels of places at which it must write before time passes
    std::vector<std::string> deadlines;          ///< members of the frame: the remaining time plus one; 0: no deadline
                                                 ///< runs
    CodeWriter helpers{1};                       ///< functions that the code of its places calls
    std::map<std::uint32_t, std::string> stuck;  ///< by the shown state: the place after a false precondition
    bool waits = false;

    [[nodiscard]] std::string qualified_label(const std::string& label) const { return enumeration + "::" + label; }
    [[nodiscard]] std::string go_statement(const std::string& label) const {
        return variable + " = " + qualified_label(label) + ";";
    }
};

/// Writes programs as places of a thread.
class ProgramWriter {
public:
    /// `state` is the state that the machine shows while the program runs.
    ProgramWriter(const Generation&, const Unit&, Thread&, ir::NodeId state);

    /// Starts a place. The code that is written until the next place starts belongs to it.
    void begin_place(const std::string& label, const diagnostics::ForeignText& comment);
    /// Ends the current place. Control continues at another place.
    void write_jump(const std::string& label);
    /// Makes the thread stop before the current place. It resumes there without another event.
    void goes_on_from_here(const std::string& condition = "");
    /// Ends the current place with code written by the caller.
    [[nodiscard]] CodeWriter& current_code();
    /// Writes a statement. Places inside it are called `stem`_1, `stem`_2, ...
    void write_statement(const ir::StmtPtr&, const std::string& stem);
    /// Writes a line of the current place; writes nothing for "".
    void write_line(const std::string&);

private:
    void resume_at(const std::string& label, const diagnostics::ForeignText& comment);
    std::string resume_here(const std::string& stem, const diagnostics::ForeignText& comment);
    [[nodiscard]] std::string fresh_label(const std::string& stem);
    void return_if(const std::string& condition);
    void test_preconditions(const ir::Stmt&);
    [[nodiscard]] const std::string& stuck_place();
    void await_cycle(const ir::Stmt&, const std::string& stem);
    void end_cycle(const std::string& stem);
    void write_sequence(const std::vector<ir::StmtPtr>& parts, const std::string& stem);
    void if_statement(const ir::Stmt&, const std::string& stem);
    void suspending_if(const ir::Stmt&, const std::string& stem);
    [[nodiscard]] std::string look_at_deadlines() const;
    void await_propagation(const ir::Stmt& assignment, const std::string& stem);
    void begin_to_hold(std::vector<std::string>& lines) const;
    void write_assignment(const ir::Stmt&, const std::string& stem);
    void assign_part(const ir::Stmt&, ir::TypeId whole);
    void write_communication(const ir::Stmt&, const std::string& stem);
    void await_input(const ir::Stmt&, const std::string& stem);
    void await_any(const ir::Stmt&, const EventUse&, const std::string& stem);
    void write_send(const ir::Stmt&, const std::string& stem);
    void write_registers(const EventUse&, const std::string& value);
    void fill_buffers(const EventUse&, const std::string& value);
    void send_out(const EventUse&, const std::string& value);
    void write_offer(const EventUse&, const std::string& value, const std::string& at, const std::string& next);
    void write_call(const ir::Stmt&, const std::string& stem);
    void call_platform(const ir::Stmt&, const std::vector<std::string>& arguments, const std::string& stem);
    void call_operation(const ir::Stmt&, const std::vector<std::string>& arguments, const std::string& stem);
    void offer_to_platform(const Unit& operation, const std::string& frame);
    void require_preconditions(const ir::Stmt& call, const Unit& operation, const std::string& frame);
    [[nodiscard]] std::string outside_place(const ir::Stmt& call, const Unit& operation, const ir::Expr& condition);
    [[nodiscard]] std::vector<std::string> write_arguments(const ir::Stmt&);
    void write_wait(const ir::Stmt&, const std::string& stem);
    void write_deadline(const ir::Stmt&, const std::string& stem);
    CallFrame& call_frame(const Unit& operation);

    const Generation& generation_;
    const Unit& unit_;
    Thread& thread_;
    ir::NodeId state_;
    std::string waiting_;                ///< label of the place at which the last communication waits; "" if none
    std::optional<PromptStep> resumed_;  ///< the place where the thread resumes contains only these lines
};

}  // namespace robochart::cpp_emit
