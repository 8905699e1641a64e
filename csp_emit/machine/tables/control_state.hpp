// SPDX-License-Identifier: Apache-2.0
// Represents the control state of a machine, without its data: the active nodes, the remaining items of the control
// thread and the during threads, and the running operations. The data are in parameters (cells). Each reachable
// configuration becomes one CSPM function.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// The index of a parameter of the machine's functions: a variable, clock, counter or frozen value.
using CellId = std::uint32_t;

enum class ItemKind {
    statement,     ///< a statement to run
    frozen,        ///< a statement whose expressions have been read into cells and whose event is pending
    store,         ///< write the received value in `cells[0]` to a variable
    waiting,       ///< a wait with `cells[0]` remaining units
    deadline_end,  ///< leaves the scope of a deadline that `cells[0]` counts
    left,          ///< leaves a node: a hidden step, before which other components may write shared variables
    shown,         ///< leaves a state, if the machine shows that the state is left (shown.hpp): a hidden step
    enter,         ///< enter a node
    entered,       ///< a state has been entered
    join,          ///< waits for the end of the store that runs in parallel with the exits of `node`'s inner states
    resume,        ///< RoboSim: the thread has ended the cycle and waits for the next one
    stuck,         ///< a failed precondition or an operation without behaviour: the thread is blocked
};

/// One item of a thread's program.
struct Item {
    ItemKind kind = ItemKind::statement;
    const ir::Stmt* stmt = nullptr;
    ir::NodeId node;
    ir::VariableId variable;
    std::vector<CellId> cells;
    std::string label;  ///< its place in the model, for names and reports: "entry action of S1"
};

/// A program. It is a linked list, and several programs may share the same tail.
struct Link;
using Program = std::shared_ptr<const Link>;
struct Link {
    Item head;
    Program tail;
};
[[nodiscard]] Program push_item(Item head, Program tail);
[[nodiscard]] Program program_of(const std::vector<Item>& items);

struct Activation;

/// A thread: a program, preceded by the operation that is being called, if any.
struct Thread {
    Program rest;
    std::shared_ptr<const Activation> callee;
    [[nodiscard]] bool is_done() const { return !rest && !callee; }
};

struct During {
    ir::NodeId node;
    Thread thread;
};

/// A machine or operation that is running.
struct Activation {
    std::uint32_t frame = 0;
    ir::NodeId at;                    ///< innermost active node; invalid while a transition runs
    std::vector<ir::NodeId> entered;  ///< active states that transitions may interrupt, outermost first
    Thread control;                   ///< the running transition; empty if the machine is settled
    std::vector<During> durings;      ///< unfinished during actions, outermost first; then a store that runs in
                                      ///< parallel with exits
    std::uint32_t clocks_read = 0;    ///< outermost activation, settled: how many clocks of the caller have been read
                                      ///< for its guards
};

/// True if a running machine is in a node and runs no transition.
[[nodiscard]] bool is_settled(const Activation&);
/// Returns a key for the configuration. Equal keys mean equal configurations.
[[nodiscard]] std::string activation_key(const Activation&);

/// A running machine or operation within a configuration, reached by a path of calls.
struct RunningMachine {
    const Activation* activation = nullptr;
    std::shared_ptr<const RunningMachine> caller;  ///< null for the machine itself, which is the whole configuration
    std::size_t thread = 0;                        ///< index of the caller's thread that called it
    /// Returns the whole configuration in which another activation replaces this one.
    [[nodiscard]] Activation replace(Activation) const;
};
/// A thread within a configuration.
struct RunningThread {
    std::shared_ptr<const RunningMachine> machine;  ///< the running machine to which it belongs
    std::size_t number = 0;                         ///< 0: the control thread; i + 1: the thread of the i-th during
                                                    ///< action
    bool during = false;                            ///< in a during action, or in an operation called from one
    [[nodiscard]] const Activation& owner() const { return *machine->activation; }
    [[nodiscard]] std::uint32_t frame() const { return owner().frame; }
    [[nodiscard]] const Thread& thread() const;
    [[nodiscard]] const Item& head() const { return thread().rest->head; }
    /// Returns the rest of the thread's program after its first item.
    [[nodiscard]] const Program& tail() const { return thread().rest->tail; }
    /// Returns the whole configuration in which another thread replaces this one. A finished during action is dropped.
    [[nodiscard]] Activation replace(Thread) const;
    [[nodiscard]] Activation replace(Program rest) const { return replace(Thread{std::move(rest), nullptr}); }
};
/// All threads and all running machines. An operation's own thread represents the thread that calls it.
struct View {
    std::vector<RunningThread> threads;
    std::vector<RunningMachine> machines;
    std::vector<RunningThread> calls;  ///< threads that wait for an operation
};
/// Finds the threads and running machines of a configuration. `config` must outlive the view.
[[nodiscard]] View view_of(const Activation& config);

/// Returns the first item of the innermost control thread, or null if there is none. It determines the name and the
/// description of the configuration.
[[nodiscard]] const Item* running_item(const Activation&);
/// Returns the machine or operation in which the control thread is.
[[nodiscard]] const Activation& innermost_activation(const Activation&);

}  // namespace robochart::csp_emit
