// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/class_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include "semantics/data/classes.hpp"
#include "semantics/data/relations.hpp"
#include "semantics/data/value_text.hpp"
#include "semantics/evaluate/carrier.hpp"
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

/// A class of values of a term: "d - l = 1".
std::string term_value_text(const System& system, std::int64_t scale, const std::string& term, TypeId type,
                            const Value& witness) {
    return term + " = " + value_text(system, scale, type, witness);
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

bool have_small_carriers(const System& system, const Instantiation& instantiation, const Places& places,
                         const std::map<PlaceId, ValueClasses>& classes) {
    constexpr std::size_t most_values = 64;
    try {
        for (const auto& [flow, divided] : classes)
            (void)carrier_values(system, instantiation, places[flow].type, most_values);
    } catch (const std::length_error&) {
        return false;
    }
    return true;
}

std::string name_of(const Machine& machine) {
    return machine.package.empty() ? machine.path : machine.package + "::" + machine.path;
}

std::set<std::string> outputs_replaced(const System& system, const Places& places,
                                       const std::map<PlaceId, ValueClasses>& classes) {
    std::set<std::string> result;
    for (std::uint32_t m = 0; m < system.machines.size(); ++m) {
        const Machine& machine = system.machines[m];
        const auto note = [&](PlaceId place) {
            const auto found = classes.find(places.class_of(place));
            if (found != classes.end() && !found->second.exact_outputs) result.insert(name_of(machine));
        };
        for (std::uint32_t e = 0; e < machine.events.size(); ++e)
            if (machine.events[e].output && machine.events[e].type) note(places.event(MachineId{m}, EventId{e}));
        for (std::uint32_t o = 0; o < machine.operations.size(); ++o)
            for (std::size_t p = 0; p < machine.operations[o].parameters.size(); ++p)
                note(places.parameter(MachineId{m}, OperationId{o}, p));
        for (std::uint32_t v = 0; v < machine.variables.size(); ++v)
            if (machine.variables[v].scope == VariableScope::required)
                note(places.variable(MachineId{m}, VariableId{v}));
    }
    return result;
}

std::vector<std::string> names_in(const Places& places, PlaceId flow) {
    std::set<std::string> names;
    for (PlaceId place = 0; place < places.size(); ++place)
        if (places.class_of(place) == flow) names.insert(places[place].name);
    return {names.begin(), names.end()};
}

/// Classes for the system in which holders replace all groups of related variables but those that are refused.
class Attempt {
public:
    Attempt(const System& original, const Instantiation& instantiation, const std::set<GroupId>& refused)
        : instantiation_(instantiation),
          related_(relate(original, instantiation, refused)),
          sampling_(related_.system, instantiation),
          places_(related_.system) {
        for (const Relation& relation : related_.relations)
            for (const auto& [variable, coefficient] : relation.term.coefficients)
                places_.unite(holder_of(relation),
                              places_.variable(relation.group.first, VariableId{static_cast<std::uint32_t>(variable)}));
        uses_ = collect_uses(related_.system, sampling_, places_);
        classes_ = divide_values(related_.system, sampling_, places_, uses_);
        for (const Relation& relation : related_.relations)
            terms_[places_.class_of(holder_of(relation))] = relation.text;
    }

    /// A relation whose holder has no classes.
    [[nodiscard]] std::optional<GroupId> relation_without_classes() const {
        for (const Relation& relation : related_.relations)
            if (!classes_.contains(places_.class_of(holder_of(relation)))) return relation.group;
        return std::nullopt;
    }
    /// No value if no data are replaced.
    [[nodiscard]] std::optional<ClassModel> result() const;

private:
    static RelatedSystem relate(const System& system, const Instantiation& instantiation,
                                const std::set<GroupId>& refused) {
        const Sampling sampling(system, instantiation);
        Places places(system);
        (void)collect_uses(system, sampling, places);  // unites the places that values are copied between
        return relate_variables(system, sampling, places, refused);
    }
    [[nodiscard]] RelatedVariables described(const Relation& relation) const;
    [[nodiscard]] PlaceId holder_of(const Relation& relation) const {
        return places_.variable(relation.group.first, relation.group.second);
    }

    const Instantiation& instantiation_;
    RelatedSystem related_;
    Sampling sampling_;
    Places places_;
    std::map<PlaceId, Uses> uses_;
    std::map<PlaceId, ValueClasses> classes_;
    std::map<PlaceId, std::string> terms_;  ///< of flow classes of holders
};

RelatedVariables Attempt::described(const Relation& relation) const {
    const Machine& machine = related_.system.machine(relation.group.first);
    const auto name = [&](std::size_t variable) { return machine.variables.at(variable).name; };
    const TypeId type = machine.variables.at(relation.group.second.index).type;
    RelatedVariables result;
    result.machine = name_of(machine);
    result.holder = name(relation.group.second.index);
    result.scale = sampling_.instantiation().scale;
    result.whole = related_.system.type(type).kind == TypeKind::integer;
    result.assigned = relation.assigned;
    for (const auto& [variable, coefficient] : relation.term.coefficients)
        result.variables.push_back(
            {name(variable), coefficient, relation.initial.at(VariableId{static_cast<std::uint32_t>(variable)})});
    for (const auto& [element, variable] : relation.stored_by) result.stored_by[element] = name(variable.index);
    for (const Value& witness : classes_.at(places_.class_of(holder_of(relation))).witnesses) {
        std::int64_t units = witness.number;
        if (result.whole) units *= result.scale;
        result.term_values[term_value_text(related_.system, result.scale, relation.text, type, witness)] = units;
    }
    return result;
}

std::optional<ClassModel> Attempt::result() const {
    if (classes_.empty()) return std::nullopt;
    const System& system = related_.system;
    ClassModel result{Rewriter(system, sampling_, places_, classes_, terms_).rewrite(),
                      instantiation_,
                      {},
                      have_small_carriers(system, instantiation_, places_, classes_),
                      outputs_replaced(system, places_, classes_),
                      {}};
    for (const auto& [flow, divided] : classes_) {
        const auto term = terms_.find(flow);
        std::string term_text;
        if (term != terms_.end()) term_text = term->second;
        result.data.push_back({names_in(places_, flow), std::move(term_text), divided.witnesses.size(),
                               uses_.at(flow).conditions.size(), divided.all_values, divided.nothing_tested});
    }
    for (const Relation& relation : related_.relations) result.related.push_back(described(relation));
    return result;
}

}  // namespace

std::optional<ClassModel> class_model(const System& system, const Instantiation& instantiation) {
    std::set<GroupId> refused;
    for (;;) {
        Attempt attempt(system, instantiation, refused);
        const auto kept = attempt.relation_without_classes();
        if (!kept) return attempt.result();
        refused.insert(*kept);
    }
}

std::vector<std::string> describe_classes(const System& class_model) {
    std::vector<std::string> lines;
    for (const Type& type : class_model.types) {
        if (type.shown.empty()) continue;
        lines.push_back(fmt::format("{}: classes of values of {}", type.name, type.values_of));
        for (std::size_t i = 0; i < type.shown.size(); ++i)
            lines.push_back(fmt::format("  {}, for example {}", type.labels[i], type.shown[i]));
    }
    return lines;
}

}  // namespace robochart::ir
