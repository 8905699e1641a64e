// SPDX-License-Identifier: Apache-2.0
// Moves the declarations of the new tree into the nodes of the old tree, so that references from other files stay
// valid.
#include "frontend/project/tree_patch.hpp"

#include <algorithm>
#include <utility>

#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

// ---------------------------------------------------------------- the parts that other files see

/// Removes the bodies of machines from a tree. The destructor restores them.
class Emptied {
public:
    explicit Emptied(File& file) {
        for (auto& declaration : file.declarations) take_contents(*declaration);
    }
    ~Emptied() {
        for (auto& [machine, body] : bodies_) static_cast<NodeContainer&>(*machine) = std::move(body);
    }
    Emptied(const Emptied&) = delete;
    Emptied& operator=(const Emptied&) = delete;

private:
    void take_contents(Declaration& declaration) {
        if (auto* machine = dynamic_cast<Machine*>(&declaration))
            bodies_.emplace_back(machine, std::exchange(static_cast<NodeContainer&>(*machine), {}));
        auto* component = dynamic_cast<Component*>(&declaration);
        if (component == nullptr) return;
        for (auto& part : component->controllers) take_contents(*part);
        for (auto& part : component->machines) take_contents(*part);
        for (auto& part : component->operations) take_contents(*part);
    }

    std::vector<std::pair<Machine*, NodeContainer>> bodies_;
};

/// Marks operations that have a body, because the printed text does not show it.
void add_flags(const Declaration& declaration, std::string& out) {
    if (const auto* machine = dynamic_cast<const Machine*>(&declaration)) out += machine->has_body ? 'b' : '-';
    const auto* component = dynamic_cast<const Component*>(&declaration);
    if (component == nullptr) return;
    for (const auto& part : component->controllers) add_flags(*part, out);
    for (const auto& part : component->machines) add_flags(*part, out);
    for (const auto& part : component->operations) add_flags(*part, out);
}

// ---------------------------------------------------------------- the same declarations

bool same_head(const Declaration& a, const Declaration& b) {
    return a.kind == b.kind && a.name == b.name;
}

bool same_structure(const Variable& a, const Variable& b) {
    return same_head(a, b);
}
bool same_structure(const Event& a, const Event& b) {
    return same_head(a, b);
}
bool same_structure(const Clock& a, const Clock& b) {
    return same_head(a, b);
}
bool same_structure(const EnumLiteral& a, const EnumLiteral& b) {
    return same_head(a, b);
}
bool same_structure(const Reference& a, const Reference& b) {
    return same_head(a, b);
}
bool same_structure(const OperationSignature& a, const OperationSignature& b);
bool same_structure(const Declaration& a, const Declaration& b);

template <class Items>
bool all_same(const Items& a, const Items& b) {
    return std::ranges::equal(a, b, [](const auto& left, const auto& right) { return same_structure(*left, *right); });
}

bool same_structure(const OperationSignature& a, const OperationSignature& b) {
    return same_head(a, b) && all_same(a.parameters, b.parameters);
}

bool same_members(const Context& a, const Context& b);

bool same_contexts(const std::unique_ptr<Context>& a, const std::unique_ptr<Context>& b) {
    return (a == nullptr) == (b == nullptr) && (a == nullptr || same_members(*a, *b));
}

bool same_members(const Context& a, const Context& b) {
    return same_contexts(a.input, b.input) && same_contexts(a.output, b.output) && all_same(a.variables, b.variables) &&
           all_same(a.events, b.events) && all_same(a.clocks, b.clocks) && all_same(a.signatures, b.signatures);
}

bool same_parts(const Component& a, const Component& b) {
    const auto same_place = [](const Declaration* left, const Declaration* right) { return same_head(*left, *right); };
    return all_same(a.platforms, b.platforms) && all_same(a.controllers, b.controllers) &&
           all_same(a.machines, b.machines) && all_same(a.operations, b.operations) &&
           all_same(a.references, b.references) && std::ranges::equal(a.order, b.order, same_place);
}

/// Casts both declarations to this class. A pointer is null if its declaration has another class.
template <class Kind>
std::pair<const Kind*, const Kind*> cast_both(const Declaration& a, const Declaration& b) {
    return {dynamic_cast<const Kind*>(&a), dynamic_cast<const Kind*>(&b)};
}

bool same_structure(const Declaration& a, const Declaration& b) {
    if (!same_head(a, b)) return false;
    const auto [type, other_type] = cast_both<TypeDeclaration>(a, b);
    if (type != nullptr && other_type != nullptr)
        return all_same(type->fields, other_type->fields) && all_same(type->literals, other_type->literals);
    const auto [function, other_function] = cast_both<Function>(a, b);
    if (function != nullptr && other_function != nullptr)
        return all_same(function->parameters, other_function->parameters);
    const auto [context, other_context] = cast_both<Context>(a, b);
    if (context == nullptr || other_context == nullptr || !same_members(*context, *other_context)) return false;
    const auto [machine, other_machine] = cast_both<Machine>(a, b);
    if ((machine == nullptr) != (other_machine == nullptr)) return false;
    if (machine != nullptr) return all_same(machine->parameters, other_machine->parameters);
    const auto [component, other_component] = cast_both<Component>(a, b);
    if ((component == nullptr) != (other_component == nullptr)) return false;
    return component == nullptr || same_parts(*component, *other_component);
}

// ---------------------------------------------------------------- moving

void move_head(Declaration& old, const Declaration& fresh) {
    old.name_span = fresh.name_span;
    old.span = fresh.span;
    old.broken = fresh.broken;
}

void move_into(Clock& old, Clock& fresh) {
    move_head(old, fresh);
}

void move_into(Variable& old, Variable& fresh) {
    move_head(old, fresh);
    old.type_expr = std::move(fresh.type_expr);
    old.initial = std::move(fresh.initial);
}

void move_into(Event& old, Event& fresh) {
    move_head(old, fresh);
    old.broadcast = fresh.broadcast;
    old.type_expr = std::move(fresh.type_expr);
}

void move_into(EnumLiteral& old, EnumLiteral& fresh) {
    move_head(old, fresh);
    old.arguments = std::move(fresh.arguments);
}

void move_into(Reference& old, Reference& fresh) {
    move_head(old, fresh);
    old.refers_to = fresh.refers_to;
    old.target_name = std::move(fresh.target_name);
}

void move_into(OperationSignature& old, OperationSignature& fresh);
void move_into(Context& old, Context& fresh);
void move_into(Machine& old, Machine& fresh);
void move_into(Component& old, Component& fresh);

template <class Items>
void move_all(Items& old, Items& fresh) {
    for (std::size_t i = 0; i < old.size(); ++i) move_into(*old[i], *fresh[i]);
}

void move_into(OperationSignature& old, OperationSignature& fresh) {
    move_head(old, fresh);
    move_all(old.parameters, fresh.parameters);
    old.terminates = fresh.terminates;
}

void move_into(TypeDeclaration& old, TypeDeclaration& fresh) {
    move_head(old, fresh);
    move_all(old.fields, fresh.fields);
    move_all(old.literals, fresh.literals);
    old.record_keyword = fresh.record_keyword;
}

void move_into(Function& old, Function& fresh) {
    move_head(old, fresh);
    move_all(old.parameters, fresh.parameters);
    old.result_expr = std::move(fresh.result_expr);
    old.preconditions = std::move(fresh.preconditions);
    old.postconditions = std::move(fresh.postconditions);
}

void move_into(Context& old, Context& fresh) {
    move_head(old, fresh);
    old.interfaces = std::move(fresh.interfaces);
    move_all(old.variables, fresh.variables);
    move_all(old.events, fresh.events);
    move_all(old.clocks, fresh.clocks);
    move_all(old.signatures, fresh.signatures);
    old.cycle = std::move(fresh.cycle);
    if (old.input) move_into(*old.input, *fresh.input);
    if (old.output) move_into(*old.output, *fresh.output);
}

void move_into(Machine& old, Machine& fresh) {
    move_into(static_cast<Context&>(old), fresh);
    static_cast<NodeContainer&>(old) = std::move(static_cast<NodeContainer&>(fresh));
    move_all(old.parameters, fresh.parameters);
    old.has_body = fresh.has_body;
    old.terminates = fresh.terminates;
    old.preconditions = std::move(fresh.preconditions);
    old.postconditions = std::move(fresh.postconditions);
}

void move_into(Component& old, Component& fresh) {
    move_into(static_cast<Context&>(old), fresh);
    move_all(old.platforms, fresh.platforms);
    move_all(old.controllers, fresh.controllers);
    move_all(old.machines, fresh.machines);
    move_all(old.operations, fresh.operations);
    move_all(old.references, fresh.references);
    old.connections = std::move(fresh.connections);
}

template <class Kind>
bool moved_as(Declaration& old, Declaration& fresh) {
    auto* to = dynamic_cast<Kind*>(&old);
    auto* from = dynamic_cast<Kind*>(&fresh);
    if (to == nullptr || from == nullptr) return false;
    move_into(*to, *from);
    return true;
}

void move_declaration(Declaration& old, Declaration& fresh) {
    // The most derived class is tried before its base classes.
    if (moved_as<TypeDeclaration>(old, fresh) || moved_as<Function>(old, fresh) || moved_as<Machine>(old, fresh) ||
        moved_as<Component>(old, fresh))
        return;
    moved_as<Context>(old, fresh);
}

}  // namespace

std::string outside_of(File& file) {
    std::string out;
    for (const auto& declaration : file.declarations) add_flags(*declaration, out);
    if (!file.is_assertions) {
        const Emptied emptied(file);
        return out + "\n" + to_text(file);
    }
    // Only assertions refer to the contents of an assertion file, and assertions are resolved again after every change.
    for (const Import& import : file.imports) out += import.name.text() + (import.wildcard ? "::* " : " ");
    for (const auto& declaration : file.declarations) out += to_text(*declaration);
    for (const auto& simulation : file.simulations) out += simulation->name + " ";
    return out + "\n" + file.package.text();
}

bool same_declarations(const File& old, const File& fresh) {
    return old.source == fresh.source && old.is_assertions == fresh.is_assertions &&
           old.is_library == fresh.is_library && all_same(old.declarations, fresh.declarations);
}

void patch_file(File& old, File&& fresh) {
    for (std::size_t i = 0; i < old.declarations.size(); ++i)
        move_declaration(*old.declarations[i], *fresh.declarations[i]);
    std::swap(old.declarations, fresh.declarations);
    old = std::move(fresh);
}

}  // namespace robochart::frontend
