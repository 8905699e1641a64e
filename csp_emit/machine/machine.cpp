// From configurations to functions: the work list, the names, the arguments.
#include "csp_emit/machine/machine.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/lookup.hpp"
#include "csp_emit/passes/choice_factoring.hpp"
#include "csp_emit/base/rules.hpp"
#include "csp_emit/base/types.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::NodeKind;

namespace {

constexpr std::size_t max_points = 20'000;
/// Arguments of all calls between them: each is a small tree of its own, so these are about two gigabytes.
constexpr std::size_t max_written = 4'000'000;
/// Statements done at once before a function of their own follows: bounds recursion and the size of expressions.
constexpr std::size_t max_run = 100;

/// Nodes of a value that is written where it is used.
constexpr std::size_t largest_inline = 40;

/// Whether the expression has more nodes than that; the number counts down.
bool larger_than(const cspm::Expr& expr, std::size_t& nodes) {
    if (nodes == 0) return true;
    --nodes;
    return std::any_of(expr.args.begin(), expr.args.end(),
                       [&](const ExprPtr& part) { return part && larger_than(*part, nodes); });
}

}  // namespace

MachineEmitter::MachineEmitter(MachineContext context, Emitted& emitted)
    : context_(std::move(context)), emitted_(emitted) {}

/// An operation without a body: `SKIP |~| STOP`, with `terminates` `SKIP`. In time it may end at any time.
ExprPtr MachineEmitter::without_body() const {
    const ExprPtr skip = timed() ? b::name("SKIP_ANYTIME") : b::skip();
    const ExprPtr stop = timed() ? b::call("RUN", {b::set({b::name("tock")})}) : b::stop();
    return machine().terminates ? skip : b::internal_choice({skip, stop});
}

ComponentEmission MachineEmitter::emit() {
    collect_constants(machine());
    open_frame(machine(), 0, "");
    const bool bodiless = machine().kind == ir::MachineKind::operation && !machine().initial.valid();
    ExprPtr initial = bodiless ? without_body() : go(start(), initial_values());
    std::vector<cspm::DeclPtr> definitions = point_definitions(initial);
    ComponentEmission result;
    definitions.insert(definitions.begin(), clock_limits_.begin(), clock_limits_.end());
    definitions.insert(definitions.begin(), large_defaults_.begin(), large_defaults_.end());
    result.module = module(std::move(definitions), initial);
    result.constants = constants_;
    for (const ir::Variable& variable : machine().variables) {
        if (variable.scope != ir::VariableScope::parameter) continue;
        // Assertions name it like a constant, with another prefix (ir::Property::constants).
        const std::string name = ir::constant_name(machine().package, machine().path, variable.name);
        result.arguments.push_back({"param_" + name.substr(std::string("const_").size()), variable.type});
    }
    result.visible = visible_;
    result.machine = &machine();
    result.definitions = context_.definitions;
    result.reads_of_watched = reads_of_watched_.size();
    result.large = !remembered_.empty();
    emitted_.components[context_.path] = result;
    return result;
}

/// The functions of all points reachable from the initial one, in their order, then those behind shared calls: points
/// and places to return to are found while bodies are made.
std::vector<Function> MachineEmitter::explore() {
    std::vector<Function> behind;
    std::vector<Function> functions;
    while (functions.size() < points_.size() || behind.size() < continuations_.size()) {
        if (functions.size() < points_.size()) {
            const Point point = points_[functions.size()];
            const bool wanted = !point.returns && !overflow_;  // what has too many points is not written
            functions.push_back({point.name, {}, wanted ? body(point) : point.returns ? nullptr : b::stop()});
        } else {
            const Continuation continuation = continuations_[behind.size()];
            behind.push_back({continuation.name, {}, continued(continuation)});
        }
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
        if (points_[i].returns) functions[i].body = dispatch(points_[i].config.frame);
    settle_returns();
    skip_returns(functions, behind);
    functions.insert(functions.end(), behind.begin(), behind.end());
    return functions;
}

/// Everything that points may have as parameters: constants, then cells in the order in which they came up.
Candidates MachineEmitter::candidates() const {
    Candidates result;
    for (const ConstantParameter& constant : constants_) result.names.push_back(constant.inside);
    for (const Cell& cell : cells_) {
        result.names.push_back(cell.name);
        if (cell.kind == CellKind::clock && cell.reading.empty())
            result.ticking[cell.name] = b::call("clock_step", {b::name(cell.name), cell.limit});
    }
    if (places_) result.returns = cells_[*places_].name;
    for (const Pending& pending : pending_)
        if (pending.pushed)
            result.entries[pending.value.get()] = {
                continuations_[returns_.at(pending.frame).continuations[*pending.pushed]].name, pending.outer};
    return result;
}

/// The initial process has values for everything but constants and an operation's parameters.
void MachineEmitter::check_initial(const std::vector<std::string>& needed) const {
    const std::vector<std::string> known = parameters_with(constants_inside());
    for (const std::string& name : needed)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw std::logic_error("csp_emit: parameter " + name + " has no value");
}

std::vector<cspm::DeclPtr> MachineEmitter::point_definitions(ExprPtr& initial) {
    std::vector<Function> functions = explore();
    check_initial(find_parameters(functions, initial, candidates()));
    inline_continuations(functions, points_.size());
    choose_memories(functions);
    remember(functions, initial, remembered_);
    fill_unneeded(functions, values_of_no_interest());
    std::vector<cspm::DeclPtr> result = memory_definitions(remembered_, timed());
    if (returns_to_several()) add_places(result);
    std::vector<NamedSet> sets{{"shared_variable_events", b::productions(external_write_events())}};
    gather_alike_branches(functions, context_.names, sets);
    for (std::size_t i = 1; i < sets.size(); ++i)
        result.push_back(b::value(sets[i].name, sets[i].events, "events after which some point goes on alike"));
    for (std::size_t i = 0; i < points_.size(); ++i) result.push_back(definition(points_[i], functions[i]));
    return result;
}

Activation MachineEmitter::start() const {
    Activation result;
    result.at = machine().initial;
    return result;
}

/// Declared initial value of a private variable; required ones start at the type's default (semantics 3.6, 3.7).
ExprPtr MachineEmitter::initial_value(std::uint32_t frame, const ir::Variable& variable) const {
    const bool own = variable.scope == ir::VariableScope::local && variable.initial;
    return own ? expression_as(project(), scope(frame, {}), *variable.initial, variable.type)
               : default_of(variable.type);
}

/// A large matrix is written once and not wherever it is given.
ExprPtr MachineEmitter::default_of(ir::TypeId type) const {
    const auto [found, added] = defaults_.try_emplace(type.index);
    if (!added) return found->second;
    ExprPtr& value = found->second = default_literal(project(), type);
    std::size_t nodes = largest_inline;
    if (!larger_than(*value, nodes)) return value;
    large_defaults_.push_back(b::value("default_" + std::to_string(large_defaults_.size()) + "__", value));
    return value = b::name(cspm::declared_names(*large_defaults_.back()).front());
}

/// Parameters of a standalone operation keep the value that the caller gives.
Values MachineEmitter::initial_values() const {
    Values result;
    for (std::size_t i = 0; i < machine().variables.size(); ++i) {
        const CellId cell = frames_[0].variables[i];
        result[cell] = cells_[cell].parameter ? b::name(cells_[cell].name) : initial_value(0, machine().variables[i]);
    }
    for (const auto& clock : frames_[0].clocks)
        if (clock) result[*clock] = b::number(0);
    if (watch_) result[*watch_] = b::boolean(false);
    return result;
}

/// The process in this configuration with these values: does what needs no event, then names the rest.
ExprPtr MachineEmitter::go(const Activation& config, const Values& values) {
    if (overflow_) return b::stop();  // reported
    if (run_ >= max_run) return call_point(config, values);
    ++run_;
    auto moved = silent(config, values);
    --run_;
    return moved ? *moved : call_point(config, values);
}

ExprPtr MachineEmitter::call_point(const Activation& config, const Values& values) {
    const std::size_t index = point(config);
    if (index == points_.size()) return b::stop();  // too many, reported
    Values changed = values;
    for (const auto& [cell, guard] : monitors(view(config), values)) {
        // A transition's deadline starts anew whenever its guard is false (semantics 3.10).
        const bool known = guard->kind == cspm::ExprKind::boolean;
        if (known && guard->number != 0) continue;
        const ExprPtr anew = monitor_bound(cell, values);
        changed[cell] = known ? anew : b::if_(guard, value_of(cell, values), anew);
    }
    written_ += 1 + changed.size();
    if (written_ > max_written) too_large(std::to_string(max_written) + " values to pass between program points");
    return call_with(points_[index].name, arguments(changed), after_tock_);
}

Arguments MachineEmitter::arguments(const Values& values) const {
    Arguments result;
    for (const auto& [cell, value] : values) result.emplace_back(cells_[cell].name, value);
    return result;
}

std::size_t MachineEmitter::point(const Activation& config) {
    const auto [found, added] = point_of_.try_emplace(key(config), points_.size());
    if (!added) return found->second;
    if (points_.size() == max_points) {
        too_large(std::to_string(max_points) + " program points");
        point_of_.erase(found);
        return points_.size();
    }
    points_.push_back({config, point_name(config)});
    return points_.size() - 1;
}

/// Reported once; what is written from then on is short.
void MachineEmitter::too_large(const std::string& what) {
    if (!overflow_) project().diagnostics.report(rules::too_many_points, machine().origin.span, {machine().name, what});
    overflow_ = true;
}

ExprPtr MachineEmitter::body(const Point& point) {
    run_ = 0;
    branching_ = 0;
    if (auto moved = silent(point.config, {})) return *moved;
    if (is_final(point.config) && machine().kind == ir::MachineKind::operation) return was_reset(b::skip());
    return was_reset(b::choice(branches(point.config)));
}

/// The clocks of the caller that guards of the running machines ask for here, in order of declaration.
std::vector<CellId> MachineEmitter::clocks_needed(const Activation& config) const {
    std::vector<CellId> result;
    const View now = view(config);
    for (const Spot& spot : now.spots) {
        const Frame& frame = frames_[spot.activation->frame];
        const auto reads = [&](const ir::Expr& part) {
            if (part.kind != ir::ExprKind::since || !frame.clocks.at(part.clock.index)) return false;
            const CellId cell = *frame.clocks[part.clock.index];
            if (!cells_[cell].reading.empty()) result.push_back(cell);
            return false;
        };
        for (const ir::TransitionId id : candidates(*spot.activation))
            if (const auto& guard = frame.machine->transitions[id.index].guard) (void)mentions(*guard, reads);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

/// An operation on its own asks for its caller's clocks, one after the other, before its guards are evaluated, and
/// again when time has passed (semantics 3.10: `get_CLID_C?C -> TimeOut_1(choices, SKIP) ; Trans`).
std::vector<ExprPtr> MachineEmitter::reading_branches(const Activation& config, CellId clock) {
    std::vector<ExprPtr> result;
    const View now = view(config);
    Activation next = config;
    ++next.clocks_read;
    result.push_back(
        b::prefix(b::name(cells_[clock].reading), {b::input("in__")}, go(next, {{clock, b::name("in__")}})));
    for (const Place& place : now.places) item_branches(place, false, result);
    external_writes(config, now, result);
    const bool alone = now.places.size() == 1;
    if (std::none_of(now.places.begin(), now.places.end(), [&](const Place& p) { return stops_time(p, alone); }))
        tock_branch(config, now, result);
    return result;
}

std::vector<ExprPtr> MachineEmitter::branches(const Activation& settled) {
    const std::vector<CellId> clocks = timed() ? clocks_needed(settled) : std::vector<CellId>{};
    if (settled.clocks_read < clocks.size()) return reading_branches(settled, clocks[settled.clocks_read]);
    Activation config = settled;
    config.clocks_read = 0;
    std::vector<ExprPtr> result;
    const View now = view(config);
    // Visible termination, then ✓ (semantics 3.9).
    if (is_final(config)) result.push_back(b::prefix(b::name("terminate"), b::skip()));
    for (const Spot& spot : now.spots) transition_branches(spot, result);
    watch_branches(now, result);
    for (const Place& place : now.places) item_branches(place, now.places.size() == 1, result);
    external_writes(config, now, result);
    if (timed() && !urgent(now)) tock_branch(config, now, result);
    return result;
}

cspm::DeclPtr MachineEmitter::definition(const Point& point, const Function& function) {
    DefinitionMeaning& kept = emitted_.provenance.definitions[context_.path + "::" + point.name];
    kept = meaning_of(point, function);
    return b::function_decl(function.name, b::variables(function.parameters), function.body, kept.text);
}

}  // namespace robochart::csp_emit
