// One machine as one sequential process: mutually recursive functions, one for each reachable configuration,
// whose parameters are the machine's constants, variables, clocks and counters (semantics 3.3 to 3.8, 3.10, 3.11).
//
// How a configuration becomes a function: what needs no event is done at once by changing arguments (`go`); what
// does is a branch of an external choice (`branches`). A step is an event of its own, hidden, wherever something
// else could happen between it and its neighbours: external writes to required variables, other threads, and the
// transitions that may cut a during action.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "csp_emit/base/component.hpp"
#include "csp_emit/machine/control_state.hpp"
#include "csp_emit/expressions/expressions.hpp"
#include "csp_emit/passes/liveness.hpp"
#include "csp_emit/base/names.hpp"
#include "csp_emit/passes/variable_memory.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// A machine in the place where it runs.
struct MachineContext {
    const Project* project = nullptr;
    const ir::Machine* machine = nullptr;
    std::string name;                                  ///< of the CSPM module
    std::string path;                                  ///< qualified CSPM name, "P::C::stm_ref0"
    std::map<std::string, ir::MachineId> definitions;  ///< operations defined in this context
    NameManager names;                                 ///< everything that parameters and functions must not be called
    /// A clock whose first reset matters: the machine remembers whether it has been, and offers `unset__` where a guard
    /// reads it before that, `reset__` wherever it has been.
    std::string watched = {};
};

/// Emits the machine's CSPM module and adds to the provenance.
[[nodiscard]] ComponentEmission emit_machine(MachineContext, Emitted&);

enum class CellKind { variable, clock, deadline, waiting, frozen, monitor };

struct Cell {
    std::string name;  ///< the CSPM parameter
    CellKind kind = CellKind::variable;
    std::string meaning;  ///< RoboChart name, "since(T)"
    ir::TypeId type;
    bool shared = false;     ///< a required variable: others write it, writes are events set_x
    bool parameter = false;  ///< an operation's parameter: read-only
    std::string channel;     ///< variable: its name in set_x
    cspm::ExprPtr limit;     ///< clock: where it saturates
    ir::Origin deadline;     ///< deadline, monitor: what it counts down for
    std::string reading;     ///< clock of the caller of an operation on its own: the channel that tells it
};

/// A machine, or an operation called at one place of it.
struct Frame {
    const ir::Machine* machine = nullptr;
    std::uint32_t parent = 0;
    std::string prefix;                         ///< in front of its names: "Turn_"
    std::vector<CellId> variables;              ///< by VariableId; required ones are the caller's
    std::vector<std::optional<CellId>> clocks;  ///< by ClockId; those that nothing reads have none
    std::optional<ir::ClockId> watched;         ///< the clock MachineContext::watched
    std::vector<std::string> announced;         ///< by ClockId: CLID_C where a reset is an event; empty otherwise
    std::vector<cspm::ExprPtr> constants;       ///< by ConstantId
    std::vector<std::string> events;            ///< by EventId: the channel
    std::vector<CellId> own;                    ///< cells that live while the frame does
    std::map<std::uint32_t, CellId> monitors;   ///< by TransitionId: deadlines of transitions
    std::set<std::uint32_t> racing;             ///< by TransitionId: their store races with exit actions
};

/// What the cells hold when it is not what the parameter of the same name holds.
using Values = std::map<CellId, cspm::ExprPtr>;

class MachineEmitter {
public:
    MachineEmitter(MachineContext context, Emitted& emitted);
    ComponentEmission emit();

private:
    using ExprPtr = cspm::ExprPtr;
    struct Point {
        Activation config;
        std::string name;
        bool returns = false;  ///< an operation that calls share has come to its end
    };
    /// Where a call of a shared operation returns to.
    struct Continuation {
        std::uint32_t frame = 0;  ///< of the operation
        Activation config;        ///< once it has returned
        std::string name;
    };

    // machine.cpp: points and the whole
    ExprPtr go(const Activation& config, const Values& values);
    ExprPtr call_point(const Activation& config, const Values& values);
    std::size_t point(const Activation& config);
    void too_large(const std::string& what);
    ExprPtr body(const Point& point);
    std::vector<Function> explore();
    [[nodiscard]] cspm::ExprPtr without_body() const;
    void check_initial(const std::vector<std::string>& needed) const;
    Candidates candidates() const;
    Arguments arguments(const Values& values) const;
    std::vector<cspm::DeclPtr> point_definitions(ExprPtr& initial);
    cspm::DeclPtr definition(const Point& point, const Function& function);
    std::vector<ExprPtr> branches(const Activation& config);
    std::vector<ExprPtr> reading_branches(const Activation& config, CellId clock);
    std::vector<CellId> clocks_needed(const Activation& config) const;
    Activation start() const;
    Values initial_values() const;
    ExprPtr initial_value(std::uint32_t frame, const ir::Variable& variable) const;
    ExprPtr default_of(ir::TypeId type) const;
    std::string describe(const Activation& config) const;
    DefinitionMeaning meaning_of(const Point& point, const Function& function);
    void add_parameters(const Function& function, DefinitionMeaning& meaning) const;
    std::vector<ir::Origin> active_states(const View& now) const;
    std::vector<std::shared_ptr<const OfferMeaning>> offers(const View& now);
    std::shared_ptr<const OfferMeaning> offer(const Spot& spot, ir::TransitionId id);
    std::shared_ptr<const OfferMeaning> offer(const Place& place);
    std::string point_name(const Activation& config);

    // declarations.cpp: the module
    cspm::DeclPtr module(std::vector<cspm::DeclPtr> points, const ExprPtr& initial);
    void declare_channels(std::vector<cspm::DeclPtr>& decls);
    void declare_calls(std::vector<cspm::DeclPtr>& decls);
    void declare_mentioned(std::vector<cspm::DeclPtr>& decls);
    void declare_clocks(std::vector<cspm::DeclPtr>& decls);
    bool is_callers(const ir::Clock& clock) const;
    void declare_states(std::vector<cspm::DeclPtr>& decls);
    void declare_sets(std::vector<cspm::DeclPtr>& decls);
    void declare_variants(std::vector<cspm::DeclPtr>& decls, const ExprPtr& initial);
    cspm::DeclPtr state_module(ir::NodeId node);
    std::vector<std::string> parameters_with(const std::vector<std::string>& constants) const;
    std::vector<std::string> constants_inside() const;
    static ExprPtr call_of(const std::string& name, const std::vector<std::string>& parameters);
    std::vector<ir::NodeId> states() const;
    void mean(const std::string& event, EventMeaning meaning);

    // activation_records.cpp: machines, operations and their cells
    std::uint32_t open_frame(const ir::Machine& machine, std::uint32_t parent, const std::string& prefix);
    std::uint32_t callee_frame(std::uint32_t caller, const ir::Stmt& call, const ir::Machine& machine);
    CellId add_cell(Cell cell);
    void add_variables(Frame& frame, bool root);
    void add_clocks(Frame& frame, bool root);
    void add_constants(Frame& frame);
    void collect_constants(const ir::Machine& owner);
    void add_events(Frame& frame, bool root);
    void add_monitors(Frame& frame);
    const ir::Machine* definition_of(const Frame& frame, ir::OperationId operation) const;
    std::vector<const ir::Machine*> callable() const;
    Scope scope(std::uint32_t frame, const Values& values, ExprPtr trigger_value = nullptr) const;
    ExprPtr value_of(CellId cell, const Values& values) const;
    CellId cell_for(std::uint32_t frame, const ir::Stmt& stmt, std::size_t index, CellKind kind,
                    const std::string& name);

    // clock_initialisation.cpp: the first reset of a clock
    void add_watch(Frame& frame, bool root);
    void note_reset(const Frame& frame, ir::ClockId clock, Values& values) const;
    void watch_branches(const View& view, std::vector<ExprPtr>& out);
    ExprPtr was_reset(const ExprPtr& process) const;
    void declare_watch(std::vector<cspm::DeclPtr>& decls) const;

    // actions.cpp: statements (semantics 3.5)
    std::optional<ExprPtr> silent(const Activation& config, const Values& values);
    std::optional<ExprPtr> silent_item(const Place& place, const Activation& config, const Values& values, bool alone);
    std::optional<ExprPtr> silent_statement(const Place& place, const Activation& config, const Values& values,
                                            bool alone);
    ExprPtr perform(const Place& place, const Values& values);
    ExprPtr perform_statement(const Place& place, const ir::Stmt& stmt, const Program& rest, const Values& values);
    ExprPtr perform_assignment(const Place& place, const ir::Stmt& stmt, const Program& rest, const Values& values);
    std::vector<const ir::Expr*> reads(const ir::Stmt& stmt) const;
    bool visible(const Place& place, const ir::Stmt& stmt) const;
    bool stable(std::uint32_t frame, const ir::Stmt& stmt, bool alone) const;
    bool light(std::uint32_t frame, const ir::Stmt& stmt, const Values& values) const;
    void item_branches(const Place& place, bool alone, std::vector<ExprPtr>& out);
    void statement_branches(const Place& place, bool alone, std::vector<ExprPtr>& out);
    ExprPtr freeze(const Place& place, const ir::Stmt& stmt);
    ExprPtr communication(const Place& place, const ir::Stmt& stmt, const ExprPtr& value);
    ExprPtr reception(const Place& place, const ir::Stmt& stmt);
    ExprPtr write(const Place& place, CellId cell, const ExprPtr& value, const ir::Stmt* stmt);
    ExprPtr assigned(std::uint32_t frame, const ir::Stmt& stmt, const Values& values) const;
    ExprPtr guarded(std::uint32_t frame, const ir::Stmt& stmt, const ExprPtr& process) const;
    std::vector<ExprPtr> asked(std::uint32_t frame, const ir::Stmt& stmt, const Values& values) const;
    static Activation stuck(const Place& place);
    ExprPtr step(std::uint32_t frame, const ir::Stmt& stmt, const std::string& what, const ExprPtr& then);
    ExprPtr step_event(const std::string& key, const EventMeaning& meaning);

    // operations.cpp: calls (semantics 3.8)
    ExprPtr perform_call(const Place& place, const ir::Stmt& stmt, const Program& rest, const Values& values);
    ExprPtr call_event(const Place& place, const ir::Stmt& stmt, const std::vector<ExprPtr>& arguments);
    bool defined(const Place& place, const ir::Stmt& stmt) const;
    Values called_values(const Place& place, const ir::Stmt& stmt, std::uint32_t callee, const Values& values) const;
    std::string recursion(const ir::Machine& caller, const ir::Machine& operation);

    // call_sharing.cpp: one definition of an operation for all calls of it
    bool shares(const Place& place, const Activation& returned) const;
    std::uint32_t shared_frame(std::uint32_t caller, const ir::Machine& operation);
    ExprPtr push_return(std::uint32_t frame, const Activation& returned, const Values& values);
    std::size_t return_point(std::uint32_t frame);
    ExprPtr return_from(std::uint32_t frame, const Values& values);
    ExprPtr continued(const Continuation& continuation);
    ExprPtr dispatch(std::uint32_t frame) const;
    void settle_returns();
    void skip_returns(std::vector<Function>& functions, const std::vector<Function>& behind);
    bool returns_to_several() const;
    static void inline_continuations(std::vector<Function>& functions, std::size_t first);
    static void add_places(std::vector<cspm::DeclPtr>& decls);
    std::map<std::string, ExprPtr> values_of_no_interest() const;

    // states.cpp, transitions.cpp (semantics 3.3, 3.4)
    ExprPtr perform_enter(const Place& place, const Item& item, const Values& values);
    ExprPtr perform_entered(const Place& place, const Item& item, const Values& values);
    void entered_branch(const Place& place, std::vector<ExprPtr>& out);
    bool settled(const Activation& activation) const;
    bool is_final(const Activation& activation) const;
    void transition_branches(const Spot& spot, std::vector<ExprPtr>& out);
    std::vector<ir::TransitionId> candidates(const Activation& activation) const;
    bool has_urgent_transition(const Activation& activation) const;
    ExprPtr fire(const Spot& spot, ir::TransitionId id);
    ExprPtr fire_trigger(const Spot& spot, ir::TransitionId id);
    ExprPtr transition_event(std::uint32_t frame, ir::TransitionId id);
    CellId trigger_cell(std::uint32_t frame, ir::TransitionId id);
    Activation leave(const Activation& activation, ir::TransitionId id, Program first);
    const ir::Stmt* reset_statement(std::uint32_t frame, ir::TransitionId id, ir::ClockId clock);
    ExprPtr guard_of(std::uint32_t frame, const ir::Transition& transition, const Values& values,
                     ExprPtr trigger_value) const;
    Values reset_clocks(const Frame& frame, const ir::Transition& transition) const;
    bool races(const Frame& frame, ir::VariableId variable, const ir::Stmt& exit) const;
    void find_races(Frame& frame);

    // shared_variables.cpp (semantics 3.6, 3.7)
    void choose_memories(const std::vector<Function>& functions);
    std::vector<CellId> by_size() const;
    double values_of(const Cell& cell) const;
    double estimate(const std::vector<Function>& functions, const Evaluations& evaluations,
                    const std::map<std::string, double>& sizes, const std::vector<Remembered>& remembered) const;
    Remembered memory_of(CellId cell);
    void external_writes(const Activation& config, const View& view, std::vector<ExprPtr>& out);
    std::vector<ExprPtr> external_write_events() const;
    bool refuses_writes(const Place& place, bool alone) const;
    bool others_write() const;
    bool reads_in_turn(const Place& place, const ir::Stmt& stmt) const;
    bool may_refuse_writes(const ir::Stmt& stmt) const;
    void left_before(const ir::StmtPtr& next, ir::NodeId node, const ir::Transition& transition,
                     std::vector<Item>& items) const;
    void left_branch(const Place& place, std::vector<ExprPtr>& out);

    // time.cpp (semantics 3.10)
    bool urgent(const View& view) const;
    void tock_branch(const Activation& config, const View& view, std::vector<ExprPtr>& out);
    const std::string* announced(std::uint32_t frame, ir::ClockId clock) const;
    ExprPtr after_tock(const Activation& config, const Values& values);
    ExprPtr start_wait(const Place& place, const ir::Stmt& stmt, const Program& rest, const Values& values);
    ExprPtr wait_for(const Place& place, const ir::Stmt& stmt, const ExprPtr& units, const Program& rest,
                     const Values& values);
    bool stops_time(const Place& place, bool alone) const;
    std::vector<ExprPtr> asked_by_call(const Place& place, bool alone) const;
    std::vector<ExprPtr> time_conditions(const View& view) const;
    std::vector<std::pair<CellId, ExprPtr>> monitors(const View& view, const Values& values) const;
    ExprPtr monitor_bound(CellId cell, const Values& values) const;
    ExprPtr clock_limit(const ir::Machine& opened, const std::string& clock, ir::NodeId entry_of);
    ExprPtr clock_bound(const ir::Machine& checked, const ir::Expr& bound, std::vector<cspm::Clause>& variables) const;

    const ir::Machine& machine() const { return *context_.machine; }
    const Project& project() const { return *context_.project; }
    bool timed() const { return project().timed(); }

    MachineContext context_;
    Emitted& emitted_;
    std::vector<Cell> cells_;
    std::map<std::string, CellId> cell_named_;
    std::vector<Frame> frames_;
    std::vector<const ir::Machine*> reached_;  ///< the machine and the operations it calls, itself or through others
    std::vector<ConstantParameter> constants_;  ///< theirs
    std::map<std::pair<std::uint32_t, const ir::Stmt*>, std::uint32_t> callees_;
    std::map<std::tuple<std::uint32_t, const ir::Stmt*, std::size_t>, CellId> statement_cells_;
    std::optional<bool> recursive_;  ///< whether some operation may call itself
    std::map<std::string, std::uint32_t> shared_frames_;
    /// Where the calls of a shared operation return to: places in `continuations_`, and by key the place in that list.
    struct Returns {
        std::map<std::string, std::size_t> number;
        std::vector<std::size_t> continuations;
        std::vector<std::shared_ptr<cspm::Expr>> calls;  ///< at its end
    };
    std::map<std::uint32_t, Returns> returns_;  ///< by frame
    std::vector<Continuation> continuations_;
    std::optional<CellId> places_;  ///< the places that the calls under way return to
    /// Values of `places_` whose form depends on whether calls of a frame return to one place only.
    struct Pending {
        std::uint32_t frame;
        std::shared_ptr<cspm::Expr> value;
        std::optional<std::size_t> pushed;  ///< the number of the place; none: it is taken away
        ExprPtr outer;
    };
    std::vector<Pending> pending_;
    bool after_tock_ = false;  ///< the branch of a tock is being made
    std::map<std::string, std::size_t> point_of_;
    std::vector<Point> points_;
    std::size_t run_ = 0;                                ///< statements done at once so far
    std::size_t branching_ = 0;                          ///< conditionals around the present one
    mutable std::map<std::uint32_t, ExprPtr> defaults_;  ///< by TypeId: made once, large ones named
    mutable std::vector<cspm::DeclPtr> large_defaults_;
    std::size_t written_ = 0;  ///< arguments of all calls of points
    bool overflow_ = false;
    std::map<std::string, std::size_t> step_of_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> transition_of_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, CellId> trigger_cells_;
    std::map<std::pair<std::uint32_t, std::string>, std::shared_ptr<const OfferMeaning>> offers_;  ///< by frame
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, ir::Stmt> reset_statements_;
    std::vector<std::string> calls_;     ///< operations that remain events
    std::vector<std::string> visible_;   ///< channels of sem__events
    std::vector<ExprPtr> clock_events_;  ///< of sem__events: readings and resets of the caller's clocks
    std::optional<CellId> watch_;        ///< whether the watched clock has been reset
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> reads_of_watched_;  ///< (frame, transition)
    bool local_resets_ = false;  ///< resets of own clocks are events: a CSP block speaks of them
    std::vector<cspm::DeclPtr> clock_limits_;
    std::vector<Remembered> remembered_;  ///< variables in memory processes of their own
};

}  // namespace robochart::csp_emit
