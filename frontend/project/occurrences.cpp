// SPDX-License-Identifier: Apache-2.0
// See occurrences.hpp. Resolution stores the target of the last part of each name in the tree. The targets of the other
// parts are the declarations around that target. If the path leads through references, the targets follow from the path
// (language reference 1.3).
#include "frontend/project/occurrences.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "frontend/names/names.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/syntax/file_visitor.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/types.hpp"

namespace robochart::frontend {

namespace {

const Kinds anything = {DeclKind::primitive_type, DeclKind::record_type, DeclKind::enumeration, DeclKind::enum_literal,
                        DeclKind::function,       DeclKind::interface,   DeclKind::platform,    DeclKind::operation,
                        DeclKind::state_machine,  DeclKind::controller,  DeclKind::module,      DeclKind::reference,
                        DeclKind::simulation};

template <class Items>
void add_all(std::vector<const Declaration*>& list, const Items& items) {
    for (const auto& item : items) list.push_back(&*item);
}

void add_context(std::vector<const Declaration*>& list, const Context& context) {
    add_all(list, context.variables);
    add_all(list, context.events);
    add_all(list, context.clocks);
    add_all(list, context.signatures);
}

/// A part of a path and the declaration that it refers to.
struct Part {
    const Declaration* target = nullptr;
    std::string package;
};

/// Finds the declarations to which the parts of a qualified name refer.
class Paths {
public:
    explicit Paths(const Names& names) : names_(names) {}

    [[nodiscard]] std::vector<Part> parts_of(const Place& place, const QualifiedName& name) const {
        std::vector<Part> best;
        for (const std::size_t packages : package_lengths(name)) {
            std::vector<Part> found = targets_along(place, name, packages);
            if (count_known(found) > count_known(best) || best.empty()) best = std::move(found);
        }
        return best;
    }

    /// Returns the declaration of each part, if the target of the last part is known.
    [[nodiscard]] std::vector<Part> parts_of(const Place& place, const QualifiedName& name,
                                             const Declaration& target) const {
        std::vector<Part> result(name.parts.size());
        const Declaration* at = &target;
        std::size_t left = name.parts.size();
        while (left > 0 && at != nullptr && at->name == name.parts[left - 1]) {
            result[--left].target = at;
            at = at->parent;
        }
        if (left > 0 && (at != nullptr || !is_package(prefix_of(name, left)))) {
            result = parts_of(place, name);
            result.back() = {&target, {}};
            return result;
        }
        for (std::size_t i = 0; i < left; ++i) result[i].package = prefix_of(name, i + 1);
        return result;
    }

    [[nodiscard]] bool is_package(const std::string& text) const { return text == "core" || names_.has_package(text); }

    [[nodiscard]] static std::string prefix_of(const QualifiedName& name, std::size_t length) {
        std::string text;
        for (std::size_t i = 0; i < length; ++i) text += (i > 0 ? "::" : "") + name.parts[i];
        return text;
    }

private:
    static std::size_t count_known(const std::vector<Part>& parts) {
        return static_cast<std::size_t>(
            std::ranges::count_if(parts, [](const Part& p) { return p.target || !p.package.empty(); }));
    }

    /// Returns the possible numbers of leading parts that name a package. The first number is 0.
    [[nodiscard]] std::vector<std::size_t> package_lengths(const QualifiedName& name) const {
        std::vector<std::size_t> result{0};
        for (std::size_t i = 1; i <= name.parts.size(); ++i)
            if (is_package(prefix_of(name, i))) result.push_back(i);
        return result;
    }

    [[nodiscard]] std::vector<Part> targets_along(const Place& place, const QualifiedName& name,
                                                  std::size_t packages) const {
        std::vector<Part> result(name.parts.size());
        for (std::size_t i = 0; i < packages; ++i) result[i].package = prefix_of(name, i + 1);
        if (packages == name.parts.size()) return result;
        QualifiedName first;
        first.parts.assign(name.parts.begin(), name.parts.begin() + static_cast<std::ptrdiff_t>(packages) + 1);
        const Declaration* at = names_.find(place, first, anything);
        for (std::size_t i = packages; i < name.parts.size() && at != nullptr; ++i) {
            if (i > packages) at = member_of(*at, name.parts[i]);
            result[i].target = at;
        }
        return result;
    }

    const Names& names_;
};

class Collector {
public:
    Collector(const Names& names, std::vector<Occurrence>& out) : paths_(names), out_(out) {}

    void add_file(const File& file) {
        place_ = {&file, nullptr};
        add_package(file.package, true);
        Traversal traversal(*this);
        traversal.visit_file(file);
        add_probabilistic(file);
    }

    // Declarations

    void visit(const Context& context) {
        place_.inside = &context;
        const bool named = context.kind != DeclKind::input_context && context.kind != DeclKind::output_context;
        if (named) add_declaration(context);
    }
    void visit(const Simulation& simulation) {
        place_.inside = &simulation;
        add_declaration(simulation);
        const Declaration* const subject =
            simulation.subject_path.steps.empty() ? nullptr : simulation.subject_path.steps.back();
        add_path(simulation.subject, subject);
    }
    void visit(const TypeDeclaration& type) {
        place_.inside = &type;
        add_declaration(type);
    }
    void visit(const Function& function) {
        place_.inside = &function;
        add_declaration(function);
    }
    void visit(const EnumLiteral& literal) { add_declaration(literal); }
    void visit(const OperationSignature& signature) { add_declaration(signature); }
    void visit(const Clock& clock) { add_declaration(clock); }
    void visit(const Event& event) { add_declaration(event); }
    void visit(const State& state) { add_declaration(state); }
    void visit(const Variable& variable) { add_declaration(variable, variable.initial ? Access::write : Access::none); }
    void visit(const Reference& reference) {
        add_declaration(reference);
        add_path(reference.target_name, reference.target);
    }
    void visit(const Transition& transition) {
        add_declaration(transition);
        add_path(transition.from, transition.source);
        add_path(transition.to, transition.target);
        trigger_ = transition.trigger.get();
        for (const Transition::Reset& reset : transition.resets) add_path(reset.name, reset.clock, Access::write);
    }
    void visit(const Connection& connection) {
        for (const Connection::End* end : {&connection.from, &connection.to}) {
            add_path(end->node, end->node_target);
            add_path(end->event, end->event_target);
        }
    }

    // Uses

    void visit(const Import& import) {
        place_.inside = nullptr;
        const std::vector<Part> parts = paths_.parts_of(place_, import.name);
        const bool declared = !parts.empty() && parts.back().target != nullptr;
        // The declaration may not exist.
        if (declared)
            add_path(import.name, parts.back().target);
        else
            add_package(import.name, false);
    }
    void visit(const InterfaceClause& clause) { add_path(clause.name, clause.target); }
    void visit(const TypeExpr& type) {
        if (type.kind == TypeKind::variable) return add({type.name.span, NameKind::type_variable});
        if (type.kind != TypeKind::name || type.name.empty()) return;
        const bool is_core = type.type && type.type->declaration == nullptr;
        if (!is_core) return add_path(type.name, type.target);
        if (type.name.parts.size() > 1) add({type.name.spans.front(), NameKind::package, nullptr, "core"});
        add({type.name.spans.back(), NameKind::core_type, type.target});
    }
    void visit(const Expr& expr) {
        if (expr.name.empty()) return;
        if (const auto kind = defined_by(expr))
            return add_definition(expr.name.spans.back(), *kind, expr.name.parts.back());
        if (expr.kind == ExprKind::register_ && !expr.args.empty()) stored_ = expr.args[0].get();
        const bool writes = &expr == written_ || &expr == stored_;
        const bool absent = place_.file->is_assertions && expr.target == nullptr;
        if (absent && paths_.parts_of(place_, expr.name).back().target == nullptr) return;
        add_path(expr.name, expr.target, writes ? Access::write : Access::read);
        if (expr.kind == ExprKind::record) add_fields(expr);
    }
    void visit(const Communication& communication) {
        const bool receives = communication.kind == CommKind::input || &communication == trigger_;
        add_path(communication.event, communication.event_target, receives ? Access::read : Access::write);
        add_path(communication.variable, communication.variable_target, Access::write);
        add_path(communication.from_variable, communication.from_target, Access::write);
    }
    void visit(const Stmt& statement) {
        if (statement.kind == StmtKind::assignment) written_ = root_of(statement.target.get());
        add_path(statement.name, statement.declaration,
                 statement.kind == StmtKind::clock_reset ? Access::write : Access::none);
    }

    // Assertions

    void visit(const Assertion& assertion) {
        place_.inside = nullptr;
        add({assertion.name_span, NameKind::assertion, nullptr, assertion.name, true});
        add_path(assertion.subject, nullptr);
        if (assertion.kind != AssertionKind::conforms) add_path(assertion.other, nullptr);
        add_path(assertion.event, assertion.missed);
    }
    void visit(const AssertionParameter& parameter) {
        add_path(parameter.context, nullptr);
        if (parameter.kind == ParameterKind::cycle) return;
        const std::vector<Part> around = paths_.parts_of(place_, parameter.context);
        const Declaration* owner = around.empty() ? nullptr : around.back().target;
        const Declaration* target = parameter.target;
        if (target == nullptr && owner != nullptr && !parameter.name.empty())
            target = member_of(*owner, parameter.name.parts.back());
        add_path(parameter.name, target);
    }
    void visit(const CspBlock& block) {
        add({block.name_span, NameKind::process, nullptr, block.name, true});
        for (const QualifiedName& name : block.associated) add_path(name, nullptr);
    }

private:
    /// Returns the kind of definition of an assertion file that an expression refers to.
    static std::optional<ProbabilisticKind> defined_by(const Expr& expr) {
        if (expr.kind == ExprKind::reward) return ProbabilisticKind::rewards;
        if (expr.kind != ExprKind::marked) return std::nullopt;
        if (expr.text == "#") return ProbabilisticKind::label;
        return expr.text == "$" ? std::optional(ProbabilisticKind::formula) : std::nullopt;
    }

    void add_definition(Span span, ProbabilisticKind kind, const std::string& name, bool declares = false) {
        add({span, NameKind::definition, nullptr, std::string(to_text(kind)) + " " + name, declares});
    }

    /// Collects the names of probabilistic assertions and of the definitions that they use.
    void add_probabilistic(const File& file) {
        for (const ProbabilisticDefinition& definition : file.probabilistic_definitions)
            if (definition.kind != ProbabilisticKind::constant)
                add_definition(definition.name_span, definition.kind, definition.name, true);
        for (const ProbabilisticAssertion& assertion : file.probabilistic_assertions) {
            add({assertion.name_span, NameKind::assertion, nullptr, assertion.name, true});
            for (const ProbabilisticClause& clause : assertion.clauses)
                if (!clause.name.empty())
                    add_definition(clause.name.spans.back(), clause.definition.kind, clause.name.parts.back());
        }
    }

    void add(Occurrence occurrence) {
        if (occurrence.span.is_known()) out_.push_back(std::move(occurrence));
    }

    void add_declaration(const Declaration& declaration, Access access = Access::none) {
        add({declaration.name_span, NameKind::declaration, &declaration, {}, true, access});
    }

    void add_package(const QualifiedName& name, bool declares) {
        for (std::size_t i = 0; i < name.spans.size(); ++i)
            add({name.spans[i], NameKind::package, nullptr, Paths::prefix_of(name, i + 1), declares});
    }

    void add_path(const QualifiedName& name, const Declaration* target, Access access = Access::none) {
        if (name.empty()) return;
        const std::vector<Part> parts =
            target != nullptr ? paths_.parts_of(place_, name, *target) : paths_.parts_of(place_, name);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const bool last = i + 1 == parts.size();
            const Part& part = parts[i];
            if (part.target != nullptr)
                add({name.spans[i], NameKind::declaration, part.target, {}, false, last ? access : Access::none});
            else if (!part.package.empty())
                add({name.spans[i], NameKind::package, nullptr, part.package});
            else
                add({name.spans[i], place_.file->is_assertions ? NameKind::process : NameKind::unknown, nullptr,
                     name.parts[i]});
        }
    }

    void add_fields(const Expr& literal) {
        for (const Binding& binding : literal.bindings) {
            const Declaration* field =
                literal.target != nullptr ? member_of(*literal.target, binding.variable->name) : nullptr;
            add({binding.variable->name_span, field != nullptr ? NameKind::declaration : NameKind::unknown, field});
        }
    }

    static const Expr* root_of(const Expr* expr) {
        while (expr != nullptr && (expr->kind == ExprKind::member || expr->kind == ExprKind::index))
            expr = expr->args[0].get();
        return expr;
    }

    Paths paths_;
    std::vector<Occurrence>& out_;
    Place place_;
    const Communication* trigger_ = nullptr;
    const Expr* written_ = nullptr;
    const Expr* stored_ = nullptr;  ///< the variable of the last `$e?v`
};

}  // namespace

std::vector<const Declaration*> members_of(const Declaration& declaration) {
    std::vector<const Declaration*> list;
    const Declaration* behind = follow_reference(&declaration);
    if (const auto* type = dynamic_cast<const TypeDeclaration*>(behind)) {
        add_all(list, type->fields);
        add_all(list, type->literals);
    }
    if (const auto* component = dynamic_cast<const Component*>(behind))
        list.insert(list.end(), component->order.begin(), component->order.end());
    if (const auto* machine = dynamic_cast<const Machine*>(behind)) add_all(list, machine->parameters);
    if (const auto* container = dynamic_cast<const NodeContainer*>(behind)) {
        add_all(list, container->nodes);
        add_all(list, container->transitions);
    }
    if (const auto* context = dynamic_cast<const Context*>(behind)) {
        add_context(list, *context);
        for (const Context* registers : {context->input.get(), context->output.get()}) {
            if (registers == nullptr) continue;
            add_context(list, *registers);
            for (const InterfaceClause& clause : registers->interfaces)
                if (const Context* interface = interface_of(clause)) add_context(list, *interface);
        }
        for (const InterfaceClause& clause : context->interfaces)
            if (const Context* interface = interface_of(clause)) add_context(list, *interface);
    }
    return list;
}

const Declaration* member_of(const Declaration& declaration, std::string_view name) {
    for (const Declaration* member : members_of(declaration))
        if (member->name == name) return member;
    return nullptr;
}

std::vector<Occurrence> find_occurrences(const Model& model) {
    const Names names(model);
    std::vector<Occurrence> result;
    Collector collector(names, result);
    for (const auto& file : model.files)
        if (!file->is_library) collector.add_file(*file);
    const auto place = [](const Occurrence& o) { return std::make_tuple(o.span.source, o.span.begin, o.span.end); };
    std::ranges::stable_sort(result, [&](const Occurrence& a, const Occurrence& b) { return place(a) < place(b); });
    return result;
}

}  // namespace robochart::frontend
