// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/rewriter.hpp"

#include <algorithm>
#include <cassert>
#include <memory>
#include <set>
#include <utility>

#include "semantics/data/value_text.hpp"
#include "semantics/ir/dump_expressions.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

/// Rewrites the machines of a system: places of replaced flow classes get the types of their classes.
class Rewriter {
public:
    Rewriter(const System& system, const Sampling& sampling, const Places& places,
             const std::map<PlaceId, ValueClasses>& classes, const std::map<PlaceId, std::string>& terms)
        : system_(system), sampling_(sampling), places_(places), classes_(classes), terms_(terms) {
        for (const auto& [flow, divided] : classes)
            for (const auto& [condition, answers] : divided.answers) tested_.emplace(condition, flow);
    }

    System rewrite() {
        System result = system_;
        for (const auto& [flow, classes] : classes_) add_types(result, flow, classes);
        PlaceId place = 0;
        Places::visit_types(result, [&](TypeId& type) {
            if (const auto found = types_.find(places_.class_of(place++)); found != types_.end())
                type = found->second.one;
        });
        for (std::uint32_t m = 0; m < result.machines.size(); ++m) rewrite_machine(MachineId{m}, result.machines[m]);
        return result;
    }

private:
    struct ClassTypes {
        TypeId one, set;
    };

    void add_types(System& result, PlaceId flow, const ValueClasses& classes);
    [[nodiscard]] std::string shown_text(PlaceId flow, const ValueClasses& classes, std::size_t number) const;
    void rewrite_machine(MachineId id, Machine& machine);
    void rewrite_transition(Transition& transition);
    void rewrite_communication(Communication& communication);
    [[nodiscard]] StmtPtr rewritten(const StmtPtr& stmt);
    [[nodiscard]] ExprPtr rewritten(const ExprPtr& expr) const;
    [[nodiscard]] ExprPtr written(PlaceId target, const ExprPtr& expr) const;
    [[nodiscard]] ExprPtr test(PlaceId flow, const Expr& condition) const;
    [[nodiscard]] ExprPtr literal(PlaceId flow, std::size_t number, diagnostics::Span span) const;
    [[nodiscard]] PlaceId place_of(const Expr& expr) const { return places_.read_by(machine_, trigger_, expr); }
    [[nodiscard]] const ValueClasses* classes_at(PlaceId place) const {
        const auto found = place == no_id ? classes_.end() : classes_.find(places_.class_of(place));
        return found == classes_.end() ? nullptr : &found->second;
    }

    const System& system_;
    const Sampling& sampling_;
    const Places& places_;
    const std::map<PlaceId, ValueClasses>& classes_;
    const std::map<PlaceId, std::string>& terms_;
    std::map<const Expr*, PlaceId> tested_;  ///< the flow class that a condition tests
    std::map<PlaceId, ClassTypes> types_;
    MachineId machine_;
    PlaceId trigger_ = no_id;  ///< the place of the received value that guards and predicates read
};

/// A name that no type has.
std::string unused_name(const System& system, std::string name) {
    const auto used = [&] { return std::ranges::find(system.types, name, &Type::name) != system.types.end(); };
    while (used()) name += "_";
    return name;
}

/// A value of the class. If nothing depends on the values, the last class stands for all that the model does not write.
std::string Rewriter::shown_text(PlaceId flow, const ValueClasses& classes, std::size_t number) const {
    if (classes.nothing_tested && classes.witnesses.size() == 1) return "any value";
    if (classes.nothing_tested && number + 1 == classes.witnesses.size()) return "any other value";
    const std::int64_t scale = sampling_.instantiation().scale;
    const TypeId type = places_[flow].type;
    const auto term = terms_.find(flow);
    if (term == terms_.end()) return value_text(system_, scale, type, classes.witnesses[number]);
    return term_value_text(system_, scale, term->second, type, classes.witnesses[number]);
}

void Rewriter::add_types(System& result, PlaceId flow, const ValueClasses& classes) {
    Type one;
    one.kind = TypeKind::enumeration;
    one.values_of = type_text(system_, places_[flow].type);
    one.name = unused_name(result, places_[flow].name + "_class");
    for (std::size_t i = 0; i < classes.witnesses.size(); ++i) {
        one.labels.push_back("c" + std::to_string(i + 1));
        one.shown.push_back(shown_text(flow, classes, i));
    }
    Type set;
    set.kind = TypeKind::set;
    set.name = "Set(" + one.name + ")";
    set.args = {TypeId{static_cast<std::uint32_t>(result.types.size())}};
    types_[flow] = {set.args[0], TypeId{static_cast<std::uint32_t>(result.types.size() + 1)}};
    result.types.push_back(std::move(one));
    result.types.push_back(std::move(set));
}

ExprPtr Rewriter::literal(PlaceId flow, std::size_t number, diagnostics::Span span) const {
    Expr expr;
    expr.kind = ExprKind::enum_literal;
    expr.type = types_.at(flow).one;
    expr.number = static_cast<std::int64_t>(number);
    expr.text = "c" + std::to_string(number + 1);
    expr.span = span;
    return std::make_shared<const Expr>(std::move(expr));
}

/// The condition as a test of the class.
ExprPtr Rewriter::test(PlaceId flow, const Expr& condition) const {
    const std::vector<bool>& answers = classes_.at(flow).answers.at(&condition);
    assert(answers.size() == classes_.at(flow).witnesses.size());
    const Expr* place = nullptr;
    visit_operands(condition, [&](const Expr& expr) {
        if (place == nullptr && place_of(expr) != no_id) place = &expr;
    });
    Expr result;
    result.type = condition.type;
    result.span = condition.span;
    const auto count = static_cast<std::size_t>(std::ranges::count(answers, true));
    if (count == 0 || count == answers.size()) {
        result.kind = ExprKind::boolean;
        result.number = count == 0 ? 0 : 1;
        return std::make_shared<const Expr>(std::move(result));
    }
    Expr set;
    set.kind = ExprKind::set;
    set.type = types_.at(flow).set;
    set.span = condition.span;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (answers[i]) set.args.push_back(literal(flow, i, condition.span));
    Expr at = *place;
    at.type = types_.at(flow).one;
    result.kind = ExprKind::is_in;
    result.args = {std::make_shared<const Expr>(std::move(at)), std::make_shared<const Expr>(std::move(set))};
    return std::make_shared<const Expr>(std::move(result));
}

ExprPtr Rewriter::rewritten(const ExprPtr& expr) const {
    if (!expr) return expr;
    if (const auto tested = tested_.find(expr.get()); tested != tested_.end()) return test(tested->second, *expr);
    if (const PlaceId place = place_of(*expr); place != no_id && classes_at(place) != nullptr) {
        Expr result = *expr;
        result.type = types_.at(places_.class_of(place)).one;
        return std::make_shared<const Expr>(std::move(result));
    }
    Expr result = *expr;
    bool changed = false;
    for (ExprPtr& part : result.args) {
        ExprPtr other = rewritten(part);
        changed = changed || other != part;
        part = std::move(other);
    }
    return changed ? std::make_shared<const Expr>(std::move(result)) : expr;
}

/// A value that is stored or sent.
ExprPtr Rewriter::written(PlaceId target, const ExprPtr& expr) const {
    const ValueClasses* classes = expr ? classes_at(target) : nullptr;
    if (classes == nullptr || place_of(*expr) != no_id) return rewritten(expr);
    const auto value = sampling_.closed_value(machine_, *expr);
    return literal(places_.class_of(target), value ? classes->of_value.at(*value) : 0, expr->span);
}

void Rewriter::rewrite_communication(Communication& communication) {
    const PlaceId carried = places_.event(machine_, communication.event);
    trigger_ = carried;
    communication.predicate = rewritten(communication.predicate);
    trigger_ = no_id;
    communication.value = written(carried, communication.value);
}

StmtPtr Rewriter::rewritten(const StmtPtr& stmt) {
    if (!stmt) return stmt;
    Stmt result = *stmt;
    for (StmtPtr& part : result.body) part = rewritten(part);
    result.condition = rewritten(stmt->condition);
    const bool whole = stmt->kind == StmtKind::assign && stmt->path.empty();
    result.value = whole ? written(places_.variable(machine_, stmt->variable), stmt->value) : rewritten(stmt->value);
    if (stmt->kind == StmtKind::communicate) rewrite_communication(result.communication);
    for (std::size_t i = 0; i < result.args.size(); ++i)
        result.args[i] = written(places_.parameter(machine_, stmt->operation, i), stmt->args[i]);
    return std::make_shared<const Stmt>(std::move(result));
}

void Rewriter::rewrite_transition(Transition& transition) {
    if (transition.trigger) rewrite_communication(*transition.trigger);
    trigger_ = places_.trigger(machine_, transition);
    transition.guard = rewritten(transition.guard);
    trigger_ = no_id;
    transition.action = rewritten(transition.action);
}

void Rewriter::rewrite_machine(MachineId id, Machine& machine) {
    machine_ = id;
    for (std::uint32_t v = 0; v < machine.variables.size(); ++v)
        machine.variables[v].initial = written(places_.variable(id, VariableId{v}), machine.variables[v].initial);
    for (Node& node : machine.nodes)
        for (StmtPtr* action : {&node.entry, &node.during, &node.exit}) *action = rewritten(*action);
    for (Transition& transition : machine.transitions) rewrite_transition(transition);
}

}  // namespace

System with_classes(const System& system, const Sampling& sampling, const Places& places,
                    const std::map<PlaceId, ValueClasses>& classes, const std::map<PlaceId, std::string>& terms) {
    return Rewriter(system, sampling, places, classes, terms).rewrite();
}

std::string term_value_text(const System& system, std::int64_t scale, const std::string& term, TypeId type,
                            const Value& witness) {
    return term + " = " + value_text(system, scale, type, witness);
}

std::vector<std::string> names_in(const Places& places, PlaceId flow) {
    std::set<std::string> names;
    for (PlaceId place = 0; place < places.size(); ++place)
        if (places.class_of(place) == flow) names.insert(places[place].name);
    return {names.begin(), names.end()};
}

}  // namespace robochart::ir
