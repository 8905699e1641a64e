// Variables. Which of them are parameters of the machine's process and which have a memory of their own (semantics
// 3.6), and the machine's side of shared ones (semantics 3.7): it keeps its own copy of every required variable, and
// others may write the copy at any moment by set_EXT_x, except while a platform operation is being called, a
// single event stands under a deadline, or a precondition has failed: RoboTool's processes for these
// (`opCall -> SKIP`, `EDeadline`, `false & ...`) do not offer share__. What comes before them does: reading their
// variables, and leaving the nodes that a transition leaves (`share__choice(exit -> SKIP)`, `share__choice(exited ->
// SKIP)`).
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/machine.hpp"
#include "csp_emit/base/types.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

bool MachineEmitter::others_write() const {
    const auto& variables = frames_[0].variables;
    return std::any_of(variables.begin(), variables.end(), [&](CellId cell) { return cells_[cell].shared; });
}

/// Whether the call reads variables in a step of its own, until which others may write (`share__choice(get_v?v ->
/// ...)`) though not while the operation is being called.
bool MachineEmitter::reads_in_turn(const Place& place, const ir::Stmt& stmt) const {
    const auto variable = [](const ir::Expr& part) { return part.kind == ir::ExprKind::variable; };
    return stmt.kind == ir::StmtKind::call && !defined(place, stmt) && others_write() &&
           std::any_of(stmt.args.begin(), stmt.args.end(), [&](const auto& arg) { return mentions(*arg, variable); });
}

/// Whether a part of the statement may be one during which nobody writes.
bool MachineEmitter::may_refuse_writes(const ir::Stmt& stmt) const {
    const auto function = [](const ir::Expr& part) { return part.kind == ir::ExprKind::call; };
    const auto expressions = reads(stmt);
    return stmt.kind == ir::StmtKind::call || (timed() && stmt.kind == ir::StmtKind::deadline) ||
           std::any_of(expressions.begin(), expressions.end(),
                       [&](const ir::Expr* expr) { return mentions(*expr, function); }) ||
           std::any_of(stmt.body.begin(), stmt.body.end(), [&](const auto& part) { return may_refuse_writes(*part); });
}

/// Adds the step that leaves `node`, where it can be told from none.
void MachineEmitter::left_before(const ir::StmtPtr& next, ir::NodeId node, const ir::Transition& transition,
                                 std::vector<Item>& items) const {
    if (!next || !others_write() || !may_refuse_writes(*next)) return;
    Item left;
    left.kind = ItemKind::left;
    left.node = node;
    left.label = "transition " + transition.name;
    items.push_back(left);
}

/// The steps `exit` and `exited` of a node that is left wait for nobody, but until they are taken others may write.
void MachineEmitter::left_branch(const Place& place, std::vector<ExprPtr>& out) {
    const Item& item = place.head();
    const ir::Node& node = frames_[place.owner->frame].machine->nodes[item.node.index];
    EventMeaning meaning;
    meaning.kind = MeaningKind::exited;
    meaning.text = "leave " + node.path;
    meaning.origin = node.origin;
    const std::string step = "left " + std::to_string(place.owner->frame) + ":" + std::to_string(item.node.index);
    out.push_back(b::prefix(step_event(step, meaning), go(place.put({place.thread->rest->tail, nullptr}), {})));
}

bool MachineEmitter::refuses_writes(const Place& place, bool alone) const {
    const Item& item = place.head();
    if (item.kind == ItemKind::stuck) return true;
    if (item.stmt == nullptr || (item.kind != ItemKind::statement && item.kind != ItemKind::frozen)) return false;
    const bool to_read = item.kind == ItemKind::statement &&
                         (!stable(place.owner->frame, *item.stmt, alone) || reads_in_turn(place, *item.stmt));
    if (to_read) return false;
    if (item.stmt->kind == ir::StmtKind::call) return !defined(place, *item.stmt);
    if (item.stmt->kind != ir::StmtKind::communicate) return false;
    const Link* next = place.thread->rest->tail.get();
    return next != nullptr && next->head.kind == ItemKind::deadline_end &&
           next->head.stmt->body.at(0).get() == item.stmt;
}

/// `set_EXT_x` of every shared variable.
std::vector<ExprPtr> MachineEmitter::external_write_events() const {
    std::vector<ExprPtr> result;
    for (const CellId cell : frames_[0].variables)
        if (cells_[cell].shared) result.push_back(b::name("set_EXT_" + cells_[cell].channel));
    return result;
}

void MachineEmitter::external_writes(const Activation& config, const View& view, std::vector<ExprPtr>& out) {
    for (const Place& place : view.places)
        if (refuses_writes(place, view.places.size() == 1)) return;
    for (const CellId cell : frames_[0].variables) {
        if (!cells_[cell].shared) continue;
        const ExprPtr next = go(config, {{cell, b::name("in__")}});
        out.push_back(b::prefix(b::name("set_EXT_" + cells_[cell].channel), {b::input("in__")}, next));
    }
}

/// How many values a cell may have; what is not known counts as a small type.
double MachineEmitter::values_of(const Cell& cell) const {
    constexpr std::size_t many = 1'000;
    constexpr double unknown = 4;
    const auto bound = static_cast<double>(project().instantiation.clock_bound);
    if (cell.kind == CellKind::clock && cell.limit && cell.limit->kind == cspm::ExprKind::integer)
        return static_cast<double>(cell.limit->number) + 1;
    if (cell.kind != CellKind::variable) return cell.kind == CellKind::frozen ? unknown : bound;
    if (!cell.type.valid()) return unknown;
    if (project().system.type(cell.type).kind == ir::TypeKind::given && project().instantiations_replaced())
        return many;
    try {
        return static_cast<double>(ir::carrier(project().system, project().instantiation, cell.type, many).size());
    } catch (const std::length_error&) {
        return many;
    }
}

/// An upper bound of the states of the machine's process with these variables in memories, by the sizes of the carriers.
double MachineEmitter::estimate(const std::vector<Function>& functions, const Evaluations& evaluations,
                                const std::map<std::string, double>& sizes, const std::vector<Remembered>& remembered) const {
    const auto held = evaluations.held(remembered);
    std::set<std::string> outside;
    for (const Remembered& variable : remembered) outside.insert(variable.parameter);
    double sum = 0;
    for (std::size_t i = 0; i < functions.size(); ++i) {
        double product = 1;
        for (const std::string& parameter : functions[i].parameters) {
            const auto found = sizes.find(parameter);
            const bool counts = outside.count(parameter) == 0 || held[i].count(parameter) != 0;
            if (found != sizes.end() && counts) product *= found->second;
        }
        sum += product;
    }
    return sum;
}

/// The machine's own and shared variables, the largest types first.
std::vector<CellId> MachineEmitter::by_size() const {
    std::vector<CellId> result;
    for (const CellId cell : frames_[0].variables)
        if (!cells_[cell].parameter) result.push_back(cell);
    std::stable_sort(result.begin(), result.end(),
                     [&](CellId a, CellId c) { return values_of(cells_[a]) > values_of(cells_[c]); });
    return result;
}

Remembered MachineEmitter::memory_of(CellId id) {
    const Cell& cell = cells_[id];
    const auto& variables = frames_[0].variables;
    const auto place = static_cast<std::size_t>(std::find(variables.begin(), variables.end(), id) - variables.begin());
    Remembered result;
    result.parameter = cell.name;
    result.channel = cell.channel;
    if (cell.shared) result.shared = cell.channel;
    result.type = type_set(project(), cell.type);
    result.initial = initial_value(0, machine().variables.at(place));
    result.memory = context_.names.unique("Memory_" + cell.channel);
    mean("get_" + cell.channel, {MeaningKind::step, "read " + cell.meaning, {cell.type}, machine().origin});
    mean("setL_" + cell.channel, {MeaningKind::step, "store " + cell.meaning, {cell.type}, machine().origin});
    mean("end__", {MeaningKind::step, "the memories of " + machine().name + " end", {}, machine().origin});
    DefinitionMeaning meaning{"the memory of " + cell.meaning, {cell.meaning}, {cell.type}, machine().origin};
    meaning.kinds = {ParameterKind::variable};
    meaning.component = context_.path;
    meaning.memory = true;
    emitted_.provenance.definitions[context_.path + "::" + result.memory] = std::move(meaning);
    return result;
}

/// Largest variables first, as few as make the rest small enough to be parameters. One variable more never makes the
/// estimate larger: it counts no longer, or where a function holds it as before, and what is held because of it shrinks.
void MachineEmitter::choose_memories(const std::vector<Function>& functions) {
    const std::vector<CellId> candidates = by_size();
    std::map<std::string, double> sizes;
    for (const Cell& cell : cells_) sizes[cell.name] = values_of(cell);
    std::set<std::string> names;
    for (const CellId cell : candidates) names.insert(cells_[cell].name);
    const Evaluations evaluations(functions, names);
    const auto small_with = [&](std::size_t count) {
        std::vector<Remembered> first(count);
        for (std::size_t i = 0; i < count; ++i) {
            const Cell& cell = cells_[candidates[i]];
            first[i].parameter = cell.name;
            if (cell.shared) first[i].shared = cell.channel;
        }
        return estimate(functions, evaluations, sizes, first) <= project().options.states_of_a_process;
    };
    std::size_t least = 0;
    std::size_t most = candidates.size();
    while (least < most) {
        const std::size_t middle = (least + most) / 2;
        if (small_with(middle)) most = middle;
        else least = middle + 1;
    }
    for (std::size_t i = 0; i < least; ++i) remembered_.push_back(memory_of(candidates[i]));
}

}  // namespace robochart::csp_emit
