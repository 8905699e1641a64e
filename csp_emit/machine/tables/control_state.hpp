// The control state of a machine, without its data: which nodes are active, what the control thread and the during
// threads still have to do, which operations are being called. Data live in parameters (cells). Each reachable
// configuration becomes one CSPM function.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// Index of a parameter of the machine's functions: a variable, clock, counter or frozen value.
using CellId = std::uint32_t;

enum class ItemKind {
    statement,     ///< a statement to run
    frozen,        ///< a statement whose expressions were read into cells and whose event is pending
    store,         ///< write the received value in `cells[0]` to a variable
    waiting,       ///< a wait with `cells[0]` units to go
    deadline_end,  ///< leaves the scope of a deadline; `cells[0]` counts it
    left,          ///< a node has been left: a hidden step, until which others may write shared variables
    enter,         ///< enter a node
    entered,       ///< a state has been entered
    join,          ///< waits until the store that runs beside the exits of `node`'s inner states is done
    stuck,         ///< a false precondition or an operation without behaviour: nothing more happens
};

/// One thing a thread has to do.
struct Item {
    ItemKind kind = ItemKind::statement;
    const ir::Stmt* stmt = nullptr;
    ir::NodeId node;
    ir::VariableId variable;
    std::vector<CellId> cells;
    std::string label;  ///< where it is in the model, for names and reports: "entry action of S1"
};

/// A program: a list that shares its tails.
struct Link;
using Program = std::shared_ptr<const Link>;
struct Link {
    Item head;
    Program tail;
};
[[nodiscard]] Program push(Item head, Program tail);
[[nodiscard]] Program program_of(const std::vector<Item>& items);

struct Activation;

/// A thread: a program, in front of it perhaps an operation that is being called.
struct Thread {
    Program rest;
    std::shared_ptr<const Activation> callee;
    [[nodiscard]] bool done() const { return !rest && !callee; }
};

struct During {
    ir::NodeId node;
    Thread thread;
};

/// A machine or operation that is running.
struct Activation {
    std::uint32_t frame = 0;
    ir::NodeId at;                    ///< innermost active node; invalid while a transition runs
    std::vector<ir::NodeId> entered;  ///< states that may be interrupted, outermost first
    Thread control;                   ///< the running transition; done: settled
    std::vector<During> durings;      ///< unfinished during actions, outermost first; then a store beside exits
    std::uint32_t clocks_read = 0;    ///< outermost, settled: how many clocks of the caller its guards know by now
};

/// Whether a running machine waits in a node: no transition runs.
[[nodiscard]] bool settled(const Activation&);
/// Equal keys mean equal configurations.
[[nodiscard]] std::string key(const Activation&);

/// A running machine or operation within a configuration: a path of calls leads to it.
struct RunningMachine {
    const Activation* activation = nullptr;
    std::shared_ptr<const RunningMachine> caller;  ///< null: the machine itself, the whole configuration
    std::size_t thread = 0;                        ///< of the caller: the one that called it
    /// The whole configuration with another activation in this one's place.
    [[nodiscard]] Activation replace(Activation) const;
};
/// A thread within a configuration.
struct RunningThread {
    std::shared_ptr<const RunningMachine> machine;  ///< that it belongs to
    std::size_t number = 0;                         ///< 0: the control thread; i + 1: that of the i-th during action
    bool during = false;                            ///< in a during action, or in an operation called from one
    [[nodiscard]] const Activation& owner() const { return *machine->activation; }
    [[nodiscard]] std::uint32_t frame() const { return owner().frame; }
    [[nodiscard]] const Thread& thread() const;
    [[nodiscard]] const Item& head() const { return thread().rest->head; }
    /// What the thread has to do behind its head.
    [[nodiscard]] const Program& tail() const { return thread().rest->tail; }
    /// The whole configuration with another thread in this one's place; a during action that is done is dropped.
    [[nodiscard]] Activation replace(Thread) const;
    [[nodiscard]] Activation replace(Program rest) const { return replace(Thread{std::move(rest), nullptr}); }
};
/// All threads (those that call an operation are represented by the operation's own) and all running machines.
struct View {
    std::vector<RunningThread> threads;
    std::vector<RunningMachine> machines;
    std::vector<RunningThread> calls;  ///< threads that wait for an operation
};
/// `config` must outlive the view.
[[nodiscard]] View view(const Activation& config);

/// The item at the head of the innermost control thread, which names and describes the configuration; null if none.
[[nodiscard]] const Item* running_item(const Activation&);
/// The machine or operation that the control thread is in.
[[nodiscard]] const Activation& innermost(const Activation&);

}  // namespace robochart::csp_emit
