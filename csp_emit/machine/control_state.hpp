// Where a machine stands, without its data: which nodes are active, what the control thread and the during threads
// still have to do, which operations are being called. This is the state of the distilled operational semantics
// (semantics 3.14); data live in parameters (cells). Each reachable configuration becomes one CSPM function.
#pragma once

#include <functional>
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
    std::string label;  ///< where it stands, for names and reports: "entry action of S1"
};

/// A program: a list that shares its tails.
struct Link;
using Program = std::shared_ptr<const Link>;
struct Link {
    Item head;
    Program tail;
};
[[nodiscard]] Program push(Item head, Program tail);

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

/// Equal keys mean equal configurations.
[[nodiscard]] std::string key(const Activation&);

/// A thread with something to do, and the whole configuration with another thread in its place.
struct Place {
    const Thread* thread = nullptr;
    const Activation* owner = nullptr;
    bool during = false;  ///< in a during action, or in an operation called from one
    std::function<Activation(Thread)> put;
    [[nodiscard]] const Item& head() const { return thread->rest->head; }
};
/// A running machine, and the whole configuration with another in its place.
struct Spot {
    const Activation* activation = nullptr;
    std::function<Activation(Activation)> put;
};
/// All threads (those that call an operation are represented by the operation's own) and all running machines.
struct View {
    std::vector<Place> places;
    std::vector<Spot> spots;
    std::vector<Place> calls;  ///< threads that wait for an operation
};
/// `config` must outlive the view.
[[nodiscard]] View view(const Activation& config);

}  // namespace robochart::csp_emit
