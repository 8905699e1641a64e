// SPDX-License-Identifier: Apache-2.0
// Writes a state machine of RoboChart, or an operation that it calls, as a RoboSim machine. The RoboSim machine behaves
// like the RoboChart machine when the latter is run in cycles (docs/robosim.md, "From RoboChart"). The text is not
// formatted.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/cycles/usage.hpp"

namespace robochart::frontend {

/// The names of the interfaces that a component's machines and operations share. An empty interface is not written.
struct SharedInterfaces {
    std::string read;       ///< registers that are only read
    std::string written;    ///< registers that are only written
    std::string both;       ///< registers that are read and written
    std::string constants;  ///< constants that are given from outside
    std::string platform;   ///< operations of the platform
    std::string software;   ///< operations with a definition
    std::string callers;    ///< variables and clocks of the machine that its operations use
};

/// The data that the texts of a component and of its machines share.
struct CyclicComponent {
    std::uint32_t cycle = 1;
    SharedInterfaces interfaces;
    Usage usage;         ///< the usage of all machines
    bool alone = false;  ///< the component is a machine; its contexts then contain all these registers
};

/// Returns the name of the interface that contains the register with this name: `read`, `written` or `both`.
[[nodiscard]] const std::string& interface_of_register(const CyclicComponent&, const std::string& name);

class MachineWriter {
public:
    MachineWriter(const CyclicComponent& component, const Callers& callers, const Machine& machine,
                  const std::set<std::string>& reusable, Usage usage)
        : component_(component), callers_(callers), machine_(machine), reusable_(reusable), usage_(std::move(usage)) {}

    /// Returns the text of the machine, which gets this name. Its contexts contain the registers in the constructor's
    /// `usage`. Throws NoCyclicForm.
    [[nodiscard]] std::string write(const std::string& name);
    /// Returns the declarations of the members of the interface `callers` that the operation needs, by name. Only valid
    /// after `write`.
    [[nodiscard]] const std::map<std::string, std::string>& needed_of_caller() const { return needed_; }

private:
    /// A path from one node to another, which may consist of several transitions with junctions between them.
    struct Way {
        std::string from, name;
        std::string begin;      ///< probability and resets of the first transition
        std::string condition;  ///< "": none
        std::vector<std::string> actions;
    };
    /// The context of the nodes in a container.
    struct Surroundings {
        const State* state = nullptr;             ///< null: the machine itself
        std::vector<const Transition*> outgoing;  ///< the outgoing transitions of all enclosing states
        std::vector<std::string> busy;            ///< variables that are true while a during action runs
        std::vector<const Stmt*> first;           ///< actions to execute before control leaves the inner initial node
        std::string entry_clock;                  ///< for sinceEntry of the state; "": none
    };

    // machine_writer.cpp: declarations, nodes, transitions
    std::string head(const std::string& name) const;
    std::string declarations();
    std::string contexts() const;
    void write_container(const NodeContainer&, const Surroundings&);
    void write_node(const NodeContainer&, const State&, const Surroundings&);
    void write_state(const NodeContainer&, const State&, const Surroundings&);
    void write_rest(const Surroundings& inside);
    void write_blocked(const NodeContainer&, const State& junction, const Surroundings&);
    void write_transition(const Transition&, const Surroundings&);
    void check_times(const Transition&) const;
    [[nodiscard]] bool tests_value(const Transition&) const;
    std::string tested_value(const Transition&, const std::string& by);
    void check_trigger(const Communication&) const;
    std::string taken_condition(const Transition&);
    std::string rest_condition(const Transition&);
    std::string idle_condition(const Surroundings& inside);
    std::string during_text(const State&, const std::string& busy);
    void add_entry_clocks();
    void begin_names(const NodeContainer&);
    std::string new_name(const std::string& stem);
    std::string new_variable(const std::string& stem);
    void line(const std::string& text) { out_ += text + "\n"; }

    // machine_actions.cpp: statements and expressions
    void add_statement(Way&, const Stmt&);
    void add_communication(Way&, const Stmt&);
    void add_wait(Way&, const Expr& least, const Expr& most);
    void add_choice(Way&, const Stmt&);
    std::string next_junction(Way&, const std::string& stem);
    void finish(const Way&, const std::string& to);
    std::string simple_text(const Stmt&);
    std::string communication_text(const Communication&);
    std::string wait_text(const Stmt&);
    std::string call_text(const Stmt&);
    std::string assignment_text(const Stmt&);
    void check_deadline(const Stmt&) const;
    [[nodiscard]] std::optional<std::int64_t> longest_time(const Stmt&) const;
    [[nodiscard]] std::optional<std::int64_t> cycles_of(const Expr& time) const;
    [[nodiscard]] bool is_simple(const Stmt&, std::int64_t most_cycles) const;
    void require_simple(const Stmt&, const char* where) const;
    std::string expression(const Expr&, const Variable* replaced = nullptr, const std::string& by = {});
    std::string store_text(const Communication&);
    std::string reset_text();
    std::string cycle_end_text();
    std::string flag(const std::string& event);
    std::string received(const Event&);
    void need(const Variable&);
    void need_clock(const Declaration& clock);
    void check_time(const Expr& time) const;

    const CyclicComponent& component_;
    const Callers& callers_;
    const Machine& machine_;
    const std::set<std::string>& reusable_;
    Usage usage_;
    std::string out_;
    std::set<std::string> node_names_;              ///< the names of the nodes of the current container
    std::set<std::string> variable_names_;          ///< the variables of the machine, including new ones
    std::map<std::string, std::string> new_lines_;  ///< declarations of new variables and clocks, by name
    std::map<std::string, std::string> received_;   ///< by event: the variable for values that conditions test
    std::map<std::string, std::string> needed_;
    std::map<const Declaration*, std::string> entry_clocks_;  ///< the clocks that replace sinceEntry, by state
    std::string clock_;                                       ///< for waits; "": none yet
};

/// Returns the name of the variable that is true while an input can still be taken in the cycle.
[[nodiscard]] std::string flag_name(const Callers& callers, const std::string& event);

}  // namespace robochart::frontend
