// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/relations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <memory>
#include <numeric>
#include <optional>
#include <tuple>

#include "semantics/data/inlining.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

/// Divides the variables of a machine into groups (union-find).
class Groups {
public:
    explicit Groups(std::size_t variables) : parents_(variables) { std::iota(parents_.begin(), parents_.end(), 0U); }

    [[nodiscard]] VariableId group_of(VariableId variable) const {
        while (parents_[variable.index] != variable.index) variable.index = parents_[variable.index];
        return variable;
    }
    void unite(VariableId a, VariableId b) {
        const auto [least, other] = std::minmax({group_of(a), group_of(b)});
        parents_[other.index] = least.index;
    }
    [[nodiscard]] std::vector<VariableId> members(VariableId group) const {
        std::vector<VariableId> result;
        for (std::uint32_t v = 0; v < parents_.size(); ++v)
            if (group_of(VariableId{v}) == group) result.push_back(VariableId{v});
        return result;
    }

private:
    std::vector<std::uint32_t> parents_;
};

/// Returns the variables that the condition reads. If it reads the value that a trigger receives, this counts as a read
/// of the variable that stores it.
std::set<VariableId> variables_read(const Expr& root, VariableId trigger) {
    std::set<VariableId> result;
    visit_operands(root, [&](const Expr& expr) {
        if (expr.kind == ExprKind::variable) result.insert(expr.variable);
        if (expr.kind == ExprKind::trigger_value && trigger.is_valid()) result.insert(trigger);
    });
    return result;
}

VariableId trigger_variable(const Transition& transition) {
    return transition.trigger ? transition.trigger->variable : VariableId{};
}

void unite_related(const ExprPtr& condition, VariableId trigger, Groups& groups) {
    if (!condition) return;
    if (is_connective(condition->kind)) {
        for (const ExprPtr& part : condition->args) unite_related(part, trigger, groups);
        return;
    }
    const std::set<VariableId> read = variables_read(*condition, trigger);
    for (const VariableId variable : read) groups.unite(*read.begin(), variable);
}

Groups related_variables(const System& system, const Machine& machine) {
    Groups groups(machine.variables.size());
    for (const Transition& transition : machine.transitions)
        unite_related(inline_calls(system, transition.guard), trigger_variable(transition), groups);
    visit_statements(
        machine, [&](const Stmt& stmt) { unite_related(inline_calls(system, stmt.condition), VariableId{}, groups); });
    return groups;
}

/// Returns true if no component runs two instances of the machine.
bool runs_once(const System& system, MachineId id) {
    const auto contains = [&](const Controller& controller) {
        return std::ranges::count(controller.machines, id, &MachineInstance::machine);
    };
    const auto controllers_with = [&](const Module& module) {
        return std::ranges::count_if(module.controllers, [&](const ControllerInstance& instance) {
            return contains(system.controller(instance.controller)) > 0;
        });
    };
    return std::ranges::all_of(system.controllers, [&](const auto& controller) { return contains(controller) <= 1; }) &&
           std::ranges::all_of(system.modules, [&](const Module& module) { return controllers_with(module) <= 1; });
}

std::string term_text(const Machine& machine, const LinearForm& term) {
    std::string result;
    for (const bool positive : {true, false})
        for (const auto& [variable, coefficient] : term.coefficients) {
            if ((coefficient > 0) != positive) continue;
            const std::int64_t factor = positive ? coefficient : -coefficient;
            if (!positive) result += result.empty() ? "-" : " - ";
            if (positive && !result.empty()) result += " + ";
            if (factor != 1) result += fmt::format("{} * ", factor);
            result += machine.variables[variable].name;
        }
    return result;
}

/// Replaces the groups of related variables in one machine.
class MachineRelations {
public:
    MachineRelations(const System& system, const Sampling& sampling, const Places& places, MachineId id,
                     const std::set<GroupId>& refused)
        : system_(system),
          sampling_(sampling),
          places_(places),
          id_(id),
          machine_(system.machine(id)),
          groups_(related_variables(system, machine_)) {
        for (std::uint32_t v = 0; v < machine_.variables.size(); ++v) {
            const VariableId group = groups_.group_of(VariableId{v});
            if (group.index != v || refused.contains({id, group}) || groups_.members(group).size() < 2) continue;
            if (is_admissible(group)) relations_[group].group = {id, group};
        }
    }

    /// Returns the machine with holders in place of the groups. Use the result only if failed() is empty.
    Machine rewrite();
    [[nodiscard]] const std::set<VariableId>& failed() const { return failed_; }
    [[nodiscard]] std::vector<Relation> relations() const {
        std::vector<Relation> result;
        for (const auto& [group, relation] : relations_) result.push_back(relation);
        return result;
    }

private:
    [[nodiscard]] bool is_admissible(VariableId group) const;
    [[nodiscard]] bool holds_only(VariableId group, PlaceId place) const;
    [[nodiscard]] bool is_replaced(VariableId variable) const {
        return variable.is_valid() && relations_.contains(groups_.group_of(variable));
    }
    [[nodiscard]] std::set<VariableId> groups_of(EventId event) const;
    [[nodiscard]] std::set<VariableId> groups_read(const Expr& expr) const;
    void fail(const std::set<VariableId>& groups) { failed_.insert(groups.begin(), groups.end()); }
    void refuse_reads(const ExprPtr& expr) {
        if (expr) fail(groups_read(*expr));
    }
    [[nodiscard]] TypeId type_of(VariableId group) const { return machine_.variables[group.index].type; }

    [[nodiscard]] LinearReader reader(VariableId group) const;
    [[nodiscard]] std::optional<LinearForm> in_terms_of_holder(VariableId group, const LinearForm& form);
    [[nodiscard]] ExprPtr holder(VariableId group, const Expr& origin) const;
    [[nodiscard]] ExprPtr number(std::int64_t units, TypeId type, const Expr& origin) const;
    [[nodiscard]] ExprPtr multiple(const LinearForm& form, VariableId group, TypeId type, const Expr& origin) const;

    [[nodiscard]] ExprPtr condition(const ExprPtr& expr, VariableId trigger);
    [[nodiscard]] ExprPtr substitute(const ExprPtr& expr);
    [[nodiscard]] ExprPtr substitute_comparison(const Expr& expr, VariableId group);
    [[nodiscard]] ExprPtr substitute_number(const Expr& expr, VariableId group);
    [[nodiscard]] ExprPtr copied(const ExprPtr& expr);
    void rewrite_communication(Communication& communication, bool trigger, const std::string& element);
    void rewrite_assignment(Stmt& stmt);
    [[nodiscard]] StmtPtr rewritten(const StmtPtr& stmt);
    void rewrite_transition(Transition& transition);
    void refuse_writes_during();
    void rewrite_initial_values(Machine& machine);
    void initialise(Machine& machine, Relation& relation);

    const System& system_;
    const Sampling& sampling_;
    const Places& places_;
    MachineId id_;
    const Machine& machine_;
    Groups groups_;
    std::map<VariableId, Relation> relations_;
    std::set<VariableId> failed_;
    std::map<std::pair<const Expr*, VariableId>, ExprPtr>
        conditions_;      ///< conditions that are replaced; for lookup only
    VariableId trigger_;  ///< stores the received value that the condition reads
};

/// Returns true if only the group uses the place: it is a variable of the group, an event whose values only these
/// variables store, or an output or call that sends copies of them.
bool MachineRelations::holds_only(VariableId group, PlaceId place) const {
    const Place& found = places_[place];
    if (found.machine == no_id) return !found.variable;
    if (found.machine != id_.index) return false;
    if (!found.variable) return true;  // rewrite_communication checks events
    return groups_.group_of(VariableId{place - places_.variable(id_, VariableId{0})}) == group;
}

/// Returns true if a holder may replace the group, provided that its conditions share one term. All variables must have
/// the type int or real. All places with their values must belong to the group, or connect it with the platform.
bool MachineRelations::is_admissible(VariableId group) const {
    const TypeKind kind = system_.type(type_of(group)).kind;
    if (kind != TypeKind::integer && kind != TypeKind::real) return false;
    if (machine_.kind != MachineKind::state_machine || !runs_once(system_, id_)) return false;
    std::set<PlaceId> flows;
    for (const VariableId variable : groups_.members(group)) {
        const PlaceId flow = places_.class_of(places_.variable(id_, variable));
        const Place& all = places_[flow];
        if (type_of(variable) != type_of(group) || all.opaque || all.shared || all.internal) return false;
        flows.insert(flow);
    }
    for (PlaceId place = 0; place < places_.size(); ++place)
        if (flows.contains(places_.class_of(place)) && !holds_only(group, place)) return false;
    return true;
}

/// Returns the groups that store a value of the event, or send one.
std::set<VariableId> MachineRelations::groups_of(EventId event) const {
    std::set<VariableId> result;
    const PlaceId place = places_.event(id_, event);
    if (place == no_id) return result;
    for (const auto& [group, relation] : relations_)
        for (const VariableId variable : groups_.members(group))
            if (places_.class_of(places_.variable(id_, variable)) == places_.class_of(place)) result.insert(group);
    return result;
}

std::set<VariableId> MachineRelations::groups_read(const Expr& expr) const {
    std::set<VariableId> result;
    for (const VariableId variable : variables_read(expr, trigger_))
        if (is_replaced(variable)) result.insert(groups_.group_of(variable));
    return result;
}

LinearReader MachineRelations::reader(VariableId group) const {
    const auto closed = [this](const Expr& expr) { return sampling_.closed_value(id_, expr); };
    const auto read_variable = [this, group](const Expr& expr) -> LinearReader::Forms {
        VariableId variable = expr.variable;
        if (expr.kind == ExprKind::trigger_value) variable = trigger_;
        const bool is_name = expr.kind == ExprKind::variable || expr.kind == ExprKind::trigger_value;
        if (!is_name || !variable.is_valid() || groups_.group_of(variable) != group) return std::nullopt;
        return std::set{LinearForm{{{variable.index, 1}}, 0}};
    };
    return {system_, sampling_.instantiation().scale, closed, read_variable};
}

/// Returns the expression as k * holder + c, where component 0 is the holder. The first form of a group becomes its
/// term.
std::optional<LinearForm> MachineRelations::in_terms_of_holder(VariableId group, const LinearForm& form) {
    LinearForm& term = relations_.at(group).term;
    if (term.coefficients.empty()) {
        std::int64_t divisor = 0;
        for (const auto& [variable, coefficient] : form.coefficients) divisor = std::gcd(divisor, coefficient);
        for (const auto& [variable, coefficient] : form.coefficients)
            term.coefficients[variable] = coefficient / divisor;
    }
    if (form.coefficients.empty()) return form;
    const auto first = term.coefficients.find(form.coefficients.begin()->first);
    if (first == term.coefficients.end()) return std::nullopt;
    const std::int64_t factor = form.coefficients.begin()->second / first->second;
    const auto rest = add_multiple(form, term, -factor);
    if (!rest || !rest->coefficients.empty()) return std::nullopt;
    return LinearForm{{{0, factor}}, form.constant};
}

/// Returns the holder. If the expression reads the value that a trigger receives, returns the new value of the holder.
ExprPtr MachineRelations::holder(VariableId group, const Expr& origin) const {
    Expr result;
    result.kind = ExprKind::variable;
    visit_operands(origin, [&](const Expr& expr) {
        if (expr.kind == ExprKind::trigger_value) result.kind = ExprKind::trigger_value;
    });
    if (result.kind == ExprKind::variable) result.variable = group;
    result.type = type_of(group);
    result.span = origin.span;
    return std::make_shared<const Expr>(std::move(result));
}

ExprPtr MachineRelations::number(std::int64_t units, TypeId type, const Expr& origin) const {
    const std::int64_t scale = sampling_.instantiation().scale;
    Expr result;
    result.type = type;
    result.span = origin.span;
    if (system_.type(type).kind == TypeKind::real) {
        result.kind = ExprKind::real;
        result.decimal.unscaled = units;
        for (std::int64_t one = scale; one > 1; one /= 10) ++result.decimal.decimals;
    } else {
        assert(units % scale == 0);
        result.kind = ExprKind::integer;
        result.number = units / scale;
    }
    return std::make_shared<const Expr>(std::move(result));
}

/// Returns k * holder + c as a number of this type.
ExprPtr MachineRelations::multiple(const LinearForm& form, VariableId group, TypeId type, const Expr& origin) const {
    if (form.coefficients.empty()) return number(form.constant, type, origin);
    const auto operation = [&](ExprKind kind, std::vector<ExprPtr> args) {
        Expr result;
        result.kind = kind;
        result.type = type;
        result.span = origin.span;
        result.args = std::move(args);
        return std::make_shared<const Expr>(std::move(result));
    };
    ExprPtr result = holder(group, origin);
    if (result->type != type) result = operation(ExprKind::cast, {result});
    const std::int64_t factor = form.coefficients.at(0);
    const std::int64_t scale = sampling_.instantiation().scale;
    if (factor != 1) result = operation(ExprKind::times, {number(factor * scale, type, origin), result});
    if (form.constant != 0) result = operation(ExprKind::plus, {result, number(form.constant, type, origin)});
    return result;
}

/// Returns true if a form contains both the value that the trigger receives and the variable that stores it. This is
/// not allowed, because the received value represents the new value of that variable.
bool mixes_old_and_new(const Expr& root, VariableId trigger) {
    bool reads_new = false, reads_old = false;
    visit_operands(root, [&](const Expr& expr) {
        reads_new = reads_new || expr.kind == ExprKind::trigger_value;
        reads_old = reads_old || (expr.kind == ExprKind::variable && expr.variable == trigger);
    });
    return reads_new && reads_old;
}

ExprPtr MachineRelations::substitute_comparison(const Expr& expr, VariableId group) {
    const Expr& left = *expr.args.at(0);
    const Expr& right = *expr.args.at(1);
    const auto a = reader(group).read(left), b = reader(group).read(right);
    const auto difference = a && b ? add_multiple(*a->begin(), *b->begin(), -1) : std::nullopt;
    const auto form = difference ? in_terms_of_holder(group, *difference) : std::nullopt;
    if (!form || mixes_old_and_new(expr, trigger_)) return nullptr;
    TypeId type = type_of(group);
    for (const Expr* side : {&left, &right})
        if (system_.type(side->type).kind == TypeKind::real) type = side->type;
    Expr result = expr;
    result.args = {multiple(*form, group, type, expr), number(0, type, expr)};
    return std::make_shared<const Expr>(std::move(result));
}

ExprPtr MachineRelations::substitute_number(const Expr& expr, VariableId group) {
    const TypeKind kind = system_.type(expr.type).kind;
    const bool same = kind == system_.type(type_of(group)).kind || kind == TypeKind::real;
    const auto forms = same ? reader(group).read(expr) : std::nullopt;
    const auto form = forms ? in_terms_of_holder(group, *forms->begin()) : std::nullopt;
    if (!form || mixes_old_and_new(expr, trigger_)) return nullptr;
    return multiple(*form, group, expr.type, expr);
}

bool may_contain_terms(ExprKind kind) {
    return is_connective(kind) || is_comparison(kind) || kind == ExprKind::plus || kind == ExprKind::minus ||
           kind == ExprKind::negate || kind == ExprKind::times || kind == ExprKind::modulus ||
           kind == ExprKind::if_then_else || kind == ExprKind::is_in;
}

/// Replaces parts of the expression that are linear in the variables of the group, each as large as possible. Recursion
/// depth: the depth of the expression.
ExprPtr MachineRelations::substitute(const ExprPtr& expr) {
    if (!expr) return expr;
    const std::set<VariableId> read = groups_read(*expr);
    if (read.empty()) return expr;
    if (read.size() == 1) {
        ExprPtr whole;
        if (is_comparison(expr->kind))
            whole = substitute_comparison(*expr, *read.begin());
        else
            whole = substitute_number(*expr, *read.begin());
        if (whole) return whole;
    }
    const bool real_of_real = expr->kind == ExprKind::cast && system_.type(expr->type).kind == TypeKind::real;
    if (!may_contain_terms(expr->kind) && !real_of_real) {
        fail(read);
        return expr;
    }
    Expr result = *expr;
    for (ExprPtr& part : result.args) part = substitute(part);
    return std::make_shared<const Expr>(std::move(result));
}

/// Returns what replaces a condition. If guards share a condition, as `condition else` does, they also share what
/// replaces it.
ExprPtr MachineRelations::condition(const ExprPtr& expr, VariableId trigger) {
    if (!expr) return expr;
    if (const auto known = conditions_.find({expr.get(), trigger}); known != conditions_.end()) return known->second;
    ExprPtr result = expr;
    if (is_connective(expr->kind)) {
        Expr changed = *expr;
        for (ExprPtr& part : changed.args) part = condition(part, trigger);
        if (changed.args != expr->args) result = std::make_shared<const Expr>(std::move(changed));
    } else {
        trigger_ = trigger;
        const ExprPtr body = inline_calls(system_, expr);
        if (!groups_read(*body).empty()) result = substitute(body);
        trigger_ = {};
    }
    conditions_[{expr.get(), trigger}] = result;
    return result;
}

/// Rewrites a value that is sent. A variable of a group becomes its holder.
ExprPtr MachineRelations::copied(const ExprPtr& expr) {
    if (!expr || expr->kind != ExprKind::variable || !is_replaced(expr->variable)) {
        refuse_reads(expr);
        return expr;
    }
    return holder(groups_.group_of(expr->variable), *expr);
}

/// Rewrites a communication. An event with values of a group is either an output, or an input that the group stores.
void MachineRelations::rewrite_communication(Communication& communication, bool trigger, const std::string& element) {
    const std::set<VariableId> groups = groups_of(communication.event);
    const Event& event = machine_.events[communication.event.index];
    const bool receives = trigger || communication.kind == CommKind::input;
    const bool stores =
        !communication.value && (!communication.variable.is_valid() || is_replaced(communication.variable));
    if ((event.input && event.output) || (receives && !stores)) fail(groups);
    if (!trigger) communication.predicate = condition(communication.predicate, communication.variable);
    communication.value = copied(communication.value);
    if (!is_replaced(communication.variable)) return;
    const VariableId group = groups_.group_of(communication.variable);
    relations_.at(group).stored_by[element] = communication.variable;
    communication.variable = group;
}

/// Rewrites `x := e`. If t is the value of the term before the assignment, its value after the assignment must be k * t
/// + c.
void MachineRelations::rewrite_assignment(Stmt& stmt) {
    const VariableId group = groups_.group_of(stmt.variable);
    const LinearForm term = relations_.at(group).term;
    const ExprPtr body = inline_calls(system_, stmt.value);
    const auto forms = reader(group).read(*body);
    const auto coefficient = term.coefficients.find(stmt.variable.index);
    if (!forms || !stmt.path.empty() || coefficient == term.coefficients.end()) return fail({group});
    LinearForm others = term;
    others.coefficients.erase(stmt.variable.index);
    const auto after = add_multiple(others, *forms->begin(), coefficient->second);
    const auto form = after ? in_terms_of_holder(group, *after) : std::nullopt;
    if (!form) return fail({group});
    relations_.at(group).assigned = true;
    stmt.variable = group;
    stmt.value = multiple(*form, group, type_of(group), *stmt.value);
}

StmtPtr MachineRelations::rewritten(const StmtPtr& stmt) {
    if (!stmt) return stmt;
    Stmt result = *stmt;
    for (StmtPtr& part : result.body) part = rewritten(part);
    result.condition = condition(stmt->condition, VariableId{});
    for (const ExprPtr& step : stmt->path) refuse_reads(step);
    refuse_reads(stmt->upper);
    if (stmt->kind == StmtKind::assign && is_replaced(stmt->variable))
        rewrite_assignment(result);
    else
        refuse_reads(stmt->value);
    if (stmt->kind == StmtKind::communicate) rewrite_communication(result.communication, false, stmt->origin.element);
    for (ExprPtr& argument : result.args) argument = copied(argument);
    return std::make_shared<const Stmt>(std::move(result));
}

void MachineRelations::rewrite_transition(Transition& transition) {
    transition.guard = condition(transition.guard, trigger_variable(transition));
    if (transition.trigger) rewrite_communication(*transition.trigger, true, transition.origin.element);
    refuse_reads(transition.probability);
    refuse_reads(transition.deadline);
}

/// Checks the term, and computes its initial value.
void MachineRelations::initialise(Machine& machine, Relation& relation) {
    const VariableId group = relation.group.second;
    const bool whole = system_.type(type_of(group)).kind == TypeKind::integer;
    const bool onto = std::ranges::all_of(
        relation.term.coefficients, [&](const auto& part) { return !whole || part.second == 1 || part.second == -1; });
    if (!onto || relation.term.coefficients.size() != groups_.members(group).size()) return fail({group});
    relation.text = term_text(machine_, relation.term);
    LinearForm sum;
    for (const VariableId variable : groups_.members(group)) {
        const ExprPtr& initial = machine_.variables[variable.index].initial;
        LinearForm value;
        if (initial) {
            const auto closed = reader(group).read_closed(*initial);
            if (!closed) return fail({group});
            value = *closed;
        }
        const auto total = add_multiple(sum, value, relation.term.coefficients.at(variable.index));
        if (!total) return fail({group});
        sum = *total;
        relation.initial[variable] = value.constant;
    }
    Expr origin;
    origin.span = machine_.variables[group.index].origin.span;
    const ExprPtr initial = number(sum.constant, type_of(group), origin);
    for (const VariableId variable : groups_.members(group)) machine.variables[variable.index].initial = initial;
}

void MachineRelations::rewrite_initial_values(Machine& machine) {
    for (std::uint32_t v = 0; v < machine.variables.size(); ++v)
        if (!is_replaced(VariableId{v})) refuse_reads(machine.variables[v].initial);
    for (auto& [group, relation] : relations_) initialise(machine, relation);
}

/// Rejects during actions that change a variable of the group. Such an action could run after the event of a trigger
/// and before the received value is stored. Then the class of the received value would no longer be that of the term.
void MachineRelations::refuse_writes_during() {
    for (const Node& node : machine_.nodes) {
        if (!node.during) continue;
        visit_statements(*node.during, [&](const Stmt& stmt) {
            for (const VariableId variable : {stmt.variable, stmt.communication.variable})
                if (is_replaced(variable)) fail({groups_.group_of(variable)});
        });
    }
}

/// See the declaration. Conditions come first, because they determine the terms.
Machine MachineRelations::rewrite() {
    Machine result = machine_;
    for (Transition& transition : result.transitions) rewrite_transition(transition);
    visit_statements(machine_, [&](const Stmt& stmt) { (void)condition(stmt.condition, VariableId{}); });
    refuse_writes_during();
    for (Node& node : result.nodes)
        for (StmtPtr* action : {&node.entry, &node.during, &node.exit}) *action = rewritten(*action);
    for (Transition& transition : result.transitions) transition.action = rewritten(transition.action);
    rewrite_initial_values(result);
    return result;
}

}  // namespace

RelatedSystem relate_variables(const System& system, const Sampling& sampling, const Places& places,
                               std::set<GroupId> refused) {
    RelatedSystem result{system, {}};
    for (std::uint32_t m = 0; m < system.machines.size(); ++m) {
        const MachineId id{m};
        for (bool found = false; !found;) {
            sampling.instantiation().poll();
            MachineRelations relations(system, sampling, places, id, refused);
            Machine machine = relations.rewrite();
            found = relations.failed().empty();
            for (const VariableId group : relations.failed()) refused.insert({id, group});
            if (!found) continue;
            const std::vector<Relation> more = relations.relations();
            if (!more.empty()) result.system.machines[m] = std::move(machine);
            result.relations.insert(result.relations.end(), more.begin(), more.end());
        }
    }
    return result;
}

}  // namespace robochart::ir
