// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/rewriter.hpp"

#include <algorithm>
#include <cassert>
#include <memory>
#include <set>
#include <utility>

#include "semantics/data/images.hpp"
#include "semantics/data/statements.hpp"
#include "semantics/data/value_text.hpp"
#include "semantics/ir/dump_expressions.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

/// Rewrites the machines of a system. Places of replaced flow classes hold classes afterwards.
class Rewriter {
public:
    Rewriter(const System& system, const Sampling& sampling, const Places& places, const std::map<PlaceId, Uses>& uses,
             const std::map<PlaceId, ValueClasses>& classes, const std::map<PlaceId, std::string>& terms)
        : system_(system), sampling_(sampling), places_(places), uses_(uses), classes_(classes), terms_(terms) {
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
    [[nodiscard]] bool is_chosen(PlaceId target, const ExprPtr& expr) const;
    [[nodiscard]] StmtPtr chosen_class(PlaceId target, VariableId variable, const std::set<std::size_t>& numbers,
                                       const Origin& origin);
    [[nodiscard]] StmtPtr chosen_class(PlaceId target, VariableId variable, const ExprPtr& value, const Origin& origin);
    [[nodiscard]] ExprPtr is_one_of(PlaceId flow, const Expr& place, const std::set<std::size_t>& numbers,
                                    diagnostics::Span span) const;
    [[nodiscard]] ExprPtr chosen_before(PlaceId target, const ExprPtr& expr, std::vector<StmtPtr>& choices,
                                        const Origin& origin);
    [[nodiscard]] StmtPtr rewritten_assignment(const Stmt& stmt);
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
    const std::map<PlaceId, Uses>& uses_;
    const std::map<PlaceId, ValueClasses>& classes_;
    const std::map<PlaceId, std::string>& terms_;
    std::map<const Expr*, PlaceId> tested_;  ///< the flow class that a condition tests
    std::map<PlaceId, ClassTypes> types_;
    MachineId machine_;
    Machine* result_ = nullptr;  ///< the machine that is rewritten
    PlaceId trigger_ = no_id;    ///< the place whose received value guards and predicates read
};

/// Returns a name that no type has.
std::string unused_name(const System& system, std::string name) {
    const auto used = [&] { return std::ranges::find(system.types, name, &Type::name) != system.types.end(); };
    while (used()) name += "_";
    return name;
}

/// Returns the text for a value of the class. If no condition reads the values, the last class represents every value
/// that the model does not write.
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

/// Returns a test of the class. It replaces the condition.
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
    std::set<std::size_t> numbers;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (answers[i]) numbers.insert(i);
    return is_one_of(flow, *place, numbers, condition.span);
}

/// Returns an expression that is true if the variable or received value `place` holds one of these classes. Its span is
/// that of the condition that it replaces.
ExprPtr Rewriter::is_one_of(PlaceId flow, const Expr& place, const std::set<std::size_t>& numbers,
                            diagnostics::Span span) const {
    Expr set;
    set.kind = ExprKind::set;
    set.type = types_.at(flow).set;
    set.span = span;
    for (const std::size_t number : numbers) set.args.push_back(literal(flow, number, span));
    Expr at = place;
    at.type = types_.at(flow).one;
    Expr result;
    result.kind = ExprKind::is_in;
    result.type = boolean_type;
    result.span = span;
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

/// Rewrites a value that is stored or sent.
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

/// Returns true if the machine must choose the class: the value is computed, and a condition reads it.
bool Rewriter::is_chosen(PlaceId target, const ExprPtr& expr) const {
    const ValueClasses* classes = expr ? classes_at(target) : nullptr;
    return classes != nullptr && !classes->nothing_tested && place_of(*expr) == no_id &&
           !sampling_.closed_value(machine_, *expr);
}

/// Assigns one of these classes of the target's values to the variable.
StmtPtr Rewriter::chosen_class(PlaceId target, VariableId variable, const std::set<std::size_t>& numbers,
                               const Origin& origin) {
    std::vector<ExprPtr> values;
    for (const std::size_t i : numbers) values.push_back(literal(places_.class_of(target), i, origin.span));
    return StatementMaker(*result_).choice_of_value(variable, values, origin);
}

/// Returns the variable that the expression reads. Returns null if it reads more than one, a received value or a
/// clock.
const Expr* only_variable(const Expr& root) {
    const Expr* result = nullptr;
    bool others = false;
    visit_operands(root, [&](const Expr& expr) {
        others = others || expr.kind == ExprKind::trigger_value || is_clock(expr.kind);
        if (expr.kind != ExprKind::variable) return;
        others = others || (result != nullptr && result->variable != expr.variable);
        result = &expr;
    });
    return others ? nullptr : result;
}

/// Assigns a class that the value can have. The class of the variable from which the value is computed may restrict the
/// choice; a test of this class then comes first. The test and the choice are two steps, and no other thread may write
/// the variable between them. None does: there is no during action, and the variable is not shared.
StmtPtr Rewriter::chosen_class(PlaceId target, VariableId variable, const ExprPtr& value, const Origin& origin) {
    std::set<std::size_t> all;
    for (std::size_t i = 0; i < classes_at(target)->witnesses.size(); ++i) all.insert(i);
    const Expr* const read = value ? only_variable(*value) : nullptr;
    const PlaceId source = read != nullptr ? places_.variable(machine_, read->variable) : no_id;
    const bool alone = std::ranges::all_of(result_->nodes, [](const Node& node) { return node.during == nullptr; });
    const ValueClasses* classes = classes_at(source);
    if (classes == nullptr || !alone || places_[places_.class_of(source)].shared)
        return chosen_class(target, variable, all, origin);
    const auto flow = [&](PlaceId place) {
        const PlaceId least = places_.class_of(place);
        return DividedFlow{places_[least].type, &uses_.at(least), &classes_.at(least)};
    };
    const auto images = images_of(system_, sampling_, machine_, flow(source), flow(target), value);
    if (!images) return chosen_class(target, variable, all, origin);
    std::map<std::set<std::size_t>, std::set<std::size_t>> sources;  // the classes of the source, by their images
    for (std::size_t i = 0; i < images->size(); ++i) sources[(*images)[i].empty() ? all : (*images)[i]].insert(i);
    StmtPtr result = chosen_class(target, variable, sources.begin()->first, origin);
    for (auto image = std::next(sources.begin()); image != sources.end(); ++image) {
        const ExprPtr condition = is_one_of(places_.class_of(source), *read, image->second, value->span);
        result = StatementMaker(*result_).if_then_else(condition, chosen_class(target, variable, image->first, origin),
                                                       result, origin);
    }
    return result;
}

/// Returns the value that is sent. If the machine chooses its class, a new variable stores the choice.
ExprPtr Rewriter::chosen_before(PlaceId target, const ExprPtr& expr, std::vector<StmtPtr>& choices,
                                const Origin& origin) {
    if (!is_chosen(target, expr)) return written(target, expr);
    StatementMaker maker(*result_);
    const VariableId variable = maker.add_variable("chosen", types_.at(places_.class_of(target)).one, origin);
    choices.push_back(chosen_class(target, variable, expr, origin));
    return maker.read(variable, origin.span);
}

StmtPtr Rewriter::rewritten_assignment(const Stmt& stmt) {
    const PlaceId target = places_.variable(machine_, stmt.variable);
    const ValueClasses* classes = classes_at(target);
    Stmt result = stmt;
    if (classes == nullptr && !stmt.path.empty()) {
        for (ExprPtr& step : result.path) step = rewritten(step);
        result.value = rewritten(stmt.value);
    } else if (classes != nullptr && !classes->nothing_tested &&
               (!stmt.path.empty() || is_chosen(target, stmt.value))) {
        return chosen_class(target, stmt.variable, stmt.path.empty() ? stmt.value : nullptr, stmt.origin);
    } else if (!stmt.path.empty()) {
        result.path.clear();
        result.value = literal(places_.class_of(target), 0, stmt.value->span);
    } else {
        result.value = written(target, stmt.value);
    }
    return std::make_shared<const Stmt>(std::move(result));
}

StmtPtr Rewriter::rewritten(const StmtPtr& stmt) {
    if (!stmt) return stmt;
    if (stmt->kind == StmtKind::assign) return rewritten_assignment(*stmt);
    Stmt result = *stmt;
    std::vector<StmtPtr> parts;
    for (StmtPtr& part : result.body) part = rewritten(part);
    result.condition = rewritten(stmt->condition);
    result.value = rewritten(stmt->value);
    if (stmt->kind == StmtKind::communicate) {
        rewrite_communication(result.communication);
        result.communication.value = chosen_before(places_.event(machine_, stmt->communication.event),
                                                   stmt->communication.value, parts, stmt->origin);
    }
    for (std::size_t i = 0; i < result.args.size(); ++i)
        result.args[i] =
            chosen_before(places_.parameter(machine_, stmt->operation, i), stmt->args[i], parts, stmt->origin);
    parts.push_back(std::make_shared<const Stmt>(std::move(result)));
    return StatementMaker(*result_).sequence_of(std::move(parts), stmt->origin);
}

void Rewriter::rewrite_transition(Transition& transition) {
    if (transition.trigger) rewrite_communication(*transition.trigger);
    trigger_ = places_.trigger(machine_, transition);
    transition.guard = rewritten(transition.guard);
    trigger_ = no_id;
    for (StmtPtr& store : transition.stores) store = rewritten(store);
    transition.action = rewritten(transition.action);
}

void Rewriter::rewrite_machine(MachineId id, Machine& machine) {
    machine_ = id;
    result_ = &machine;
    for (std::uint32_t v = 0; v < machine.variables.size(); ++v)
        machine.variables[v].initial = written(places_.variable(id, VariableId{v}), machine.variables[v].initial);
    for (Node& node : machine.nodes)
        for (StmtPtr* action : {&node.entry, &node.during, &node.exit}) *action = rewritten(*action);
    for (Transition& transition : machine.transitions) rewrite_transition(transition);
}

}  // namespace

System with_classes(const System& system, const Sampling& sampling, const Places& places,
                    const std::map<PlaceId, Uses>& uses, const std::map<PlaceId, ValueClasses>& classes,
                    const std::map<PlaceId, std::string>& terms) {
    return Rewriter(system, sampling, places, uses, classes, terms).rewrite();
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
