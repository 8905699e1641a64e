// SPDX-License-Identifier: Apache-2.0
// Fills the tables of declarations by name, file by file, and looks up names in them.
#include "frontend/names/names.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/diagnostics/fixes.hpp"

namespace robochart::frontend {

namespace {

std::string qualify_name(const std::string& prefix, std::string_view name) {
    return prefix.empty() ? std::string(name) : prefix + "::" + std::string(name);
}

std::size_t parts_of(std::string_view full_name) {
    std::size_t parts = 1;
    for (std::size_t at = full_name.find("::"); at != std::string_view::npos; at = full_name.find("::", at + 2))
        ++parts;
    return parts;
}

void adopt_context(Context& context) {
    for (auto& variable : context.variables) variable->parent = &context;
    for (auto& event : context.events) event->parent = &context;
    for (auto& clock : context.clocks) clock->parent = &context;
    for (auto& signature : context.signatures) {
        signature->parent = &context;
        for (auto& parameter : signature->parameters) parameter->parent = signature.get();
    }
    for (auto* registers : {&context.input, &context.output}) {
        if (!*registers) continue;
        (*registers)->parent = &context;
        adopt_context(**registers);
    }
}

/// True for a component of this dialect, and for declarations that both dialects share.
bool fits_dialect(const Declaration& declaration, Dialect dialect) {
    const auto* context = dynamic_cast<const Context*>(&declaration);
    return context == nullptr || context->dialect == dialect;
}

/// Sets the parents of nodes and transitions. The recursion is bounded, because the parser limits the depth of
/// composite states.
void adopt_nodes(NodeContainer& container, const Declaration& parent) {
    for (auto& node : container.nodes) {
        node->parent = &parent;
        adopt_nodes(*node, *node);
    }
    for (auto& transition : container.transitions) transition->parent = &parent;
}

}  // namespace

std::size_t file_nearness(const File& a, const File& b) {
    if (&a == &b) return std::numeric_limits<std::size_t>::max();
    if (a.is_library || b.is_library) return 0;
    const auto apart = std::ranges::mismatch(a.folder, b.folder);
    return 1 + static_cast<std::size_t>(std::count(a.folder.begin(), apart.in1, '/'));
}

Names::Names(const Model& model) {
    for (const auto& file : model.files) enter_file(*file);
    for (const auto& [full, declarations] : by_name_)
        for (const Declaration* declaration : declarations) by_simple_name_[declaration->name].push_back(declaration);
    std::ranges::sort(packages_);
    for (const auto& [full, declarations] : by_name_) most_parts_ = std::max(most_parts_, parts_of(full));
    for (const std::string& package : packages_) most_parts_ = std::max(most_parts_, parts_of(package));
    // A clause that could not be parsed may name an interface, so the members of this interface also count as lost.
    const auto lost = lost_;
    for (const std::string& name : lost)
        if (const auto* interface = dynamic_cast<const Context*>(find_anywhere(name, {DeclKind::interface})))
            mark_lost(*interface);
}

void Names::mark_lost(const Context& interface) {
    for (const auto& variable : interface.variables) lost_.insert(variable->name);
    for (const auto& event : interface.events) lost_.insert(event->name);
    for (const auto& clock : interface.clocks) lost_.insert(clock->name);
    for (const auto& signature : interface.signatures) lost_.insert(signature->name);
}

void Names::enter_file(File& file) {
    const std::string package = file.package.text();
    entering_ = &file;
    lost_.insert(file.lost_names.begin(), file.lost_names.end());
    lost_declarations_ = lost_declarations_ || file.lost_declarations;
    packages_.push_back(package);
    for (auto& declaration : file.declarations) enter_declaration(*declaration, nullptr, package);
    for (auto& simulation : file.simulations) enter_declaration(*simulation, nullptr, package);
}

void Names::enter_declaration(Declaration& declaration, const Declaration* parent, const std::string& prefix) {
    declaration.parent = parent;
    const std::string full = qualify_name(prefix, declaration.name);
    by_name_[full].push_back(&declaration);
    full_names_[&declaration] = full;
    files_[&declaration] = entering_;
    if (auto* type = dynamic_cast<TypeDeclaration*>(&declaration)) enter_type(*type, prefix);
    if (auto* function = dynamic_cast<Function*>(&declaration))
        for (auto& parameter : function->parameters) parameter->parent = function;
    if (auto* context = dynamic_cast<Context*>(&declaration)) adopt_context(*context);
    if (auto* machine = dynamic_cast<Machine*>(&declaration)) {
        for (auto& parameter : machine->parameters) parameter->parent = machine;
        adopt_nodes(*machine, *machine);
    }
    if (auto* component = dynamic_cast<Component*>(&declaration)) enter_component(*component, full);
}

/// Adds a type. A literal is added twice, as `E::L` and as `L`.
void Names::enter_type(TypeDeclaration& type, const std::string& prefix) {
    for (auto& field : type.fields) field->parent = &type;
    for (auto& literal : type.literals) {
        literal->parent = &type;
        by_name_[qualify_name(full_names_[&type], literal->name)].push_back(literal.get());
        by_name_[qualify_name(prefix, literal->name)].push_back(literal.get());
        full_names_[literal.get()] = qualify_name(full_names_[&type], literal->name);
    }
}

void Names::enter_component(Component& component, const std::string& full) {
    for (auto& part : component.platforms) enter_declaration(*part, &component, full);
    for (auto& part : component.controllers) enter_declaration(*part, &component, full);
    for (auto& part : component.machines) enter_declaration(*part, &component, full);
    for (auto& part : component.operations) enter_declaration(*part, &component, full);
    for (auto& part : component.references) enter_declaration(*part, &component, full);
    for (auto& connection : component.connections) connection->parent = &component;
}

const File* Names::file_of(const Declaration& declaration) const {
    const auto owner = files_.find(declaration.kind == DeclKind::enum_literal ? declaration.parent : &declaration);
    return owner != files_.end() ? owner->second : nullptr;
}

/// True if `declaration` is inside `around` at any depth, or if `around` is null.
bool stands_inside(const Declaration* declaration, const Declaration* around) {
    while (declaration != nullptr && declaration != around) declaration = declaration->parent;
    return declaration == around;
}

/// Returns the best declaration with this name: declarations of the dialect are preferred, then declarations in nearer
/// files, then earlier ones. If `inside` is not null, the result is inside it.
const Declaration* Names::find_nearest(const std::string& full, const Kinds& kinds, const Place& place,
                                       const Declaration* inside) const {
    const File* const file = place.file;
    const Dialect dialect = place.dialect.value_or(file != nullptr ? file->dialect : Dialect::robochart);
    const Declaration* best = nullptr;
    std::pair<bool, std::size_t> near;
    const std::vector<const Declaration*>& declared = declarations_of(full);
    for (const Declaration* declaration : declared) {
        if (!kinds.has(declaration->kind) || !stands_inside(declaration, inside)) continue;
        const File* const owner = declared.size() > 1 && file != nullptr ? file_of(*declaration) : nullptr;
        const std::pair how_near(fits_dialect(*declaration, dialect),
                                 owner != nullptr ? file_nearness(*file, *owner) : std::size_t{0});
        if (best == nullptr || how_near > near) {
            best = declaration;
            near = how_near;
        }
    }
    return best;
}

const std::vector<const Declaration*>& Names::declarations_of(const std::string& full_name) const {
    static const std::vector<const Declaration*> none;
    const auto found = by_name_.find(full_name);
    return found != by_name_.end() ? found->second : none;
}

const Declaration* Names::find(const Place& place, const QualifiedName& name, const Kinds& kinds) const {
    if (name.empty()) return nullptr;
    const std::string text = name.text();
    for (const Declaration* around = place.inside; around != nullptr; around = around->parent)
        if (const Declaration* found = find_nearest(qualify_name(full_name(around), text), kinds, place, around))
            return found;
    if (place.file != nullptr) {
        const Declaration* const own = find_nearest(qualify_name(place.file->package.text(), text), kinds, place);
        // A file without a package in another folder may belong to another project, so a nearer import is preferred.
        const Dialect dialect = place.dialect.value_or(place.file->dialect);
        const bool own_fits = own != nullptr && fits_dialect(*own, dialect);
        if (own_fits && !place.file->package.empty()) return own;
        const std::size_t near = own == nullptr ? 0 : file_nearness(*place.file, *file_of(*own));
        for (const Import& import : place.file->imports) {
            const bool names_it = !import.wildcard && import.name.parts.back() == name.parts.front();
            const std::string prefix = import.name.text();
            std::string full;
            if (import.wildcard)
                full = qualify_name(prefix, text);
            else if (names_it)
                full = prefix + text.substr(name.parts.front().size());
            if (full.empty()) continue;
            const Declaration* const found = find_nearest(full, kinds, place);
            if (found == nullptr) continue;
            const bool fits_better = !own_fits && fits_dialect(*found, dialect);
            if (own == nullptr || fits_better || file_nearness(*place.file, *file_of(*found)) > near) return found;
        }
        if (own != nullptr) return own;
    }
    return find_nearest(text, kinds, place);
}

std::vector<std::string> Names::names_of_kinds(const Kinds& kinds) const {
    std::vector<std::string> result;
    for (const auto& [simple, declarations] : by_simple_name_)
        if (std::ranges::any_of(declarations, [&](const Declaration* d) { return kinds.has(d->kind); }))
            result.push_back(simple);
    return result;
}

const Declaration* Names::find_anywhere(std::string_view simple_name, const Kinds& kinds) const {
    const auto found = by_simple_name_.find(simple_name);
    if (found == by_simple_name_.end()) return nullptr;
    for (const Declaration* declaration : found->second)
        if (kinds.has(declaration->kind)) return declaration;
    return nullptr;
}

const Context* Names::interface_with(std::string_view name, DeclKind kind) const {
    const auto among = [&](const auto& members) {
        return std::ranges::any_of(members, [&](const auto& member) { return member->name == name; });
    };
    const auto declares = [&](const Context& interface) {
        if (kind == DeclKind::event) return among(interface.events);
        if (kind == DeclKind::clock) return among(interface.clocks);
        if (kind == DeclKind::operation_signature) return among(interface.signatures);
        return among(interface.variables);
    };
    for (const auto& [full, declarations] : by_name_)
        for (const Declaration* declaration : declarations) {
            const auto* interface = dynamic_cast<const Context*>(declaration);
            if (interface != nullptr && interface->kind == DeclKind::interface && declares(*interface))
                return interface;
        }
    return nullptr;
}

std::string Names::type_name(const TypeDeclaration& type) const {
    const auto same = by_simple_name_.find(type.name);
    const bool shared =
        same != by_simple_name_.end() && std::ranges::any_of(same->second, [&](const Declaration* other) {
            return other != &type && dynamic_cast<const TypeDeclaration*>(other) != nullptr;
        });
    return shared ? full_name(&type) : type.name;
}

std::string Names::full_name(const Declaration* declaration) const {
    const auto found = full_names_.find(declaration);
    return found != full_names_.end() ? found->second : declaration->name;
}

bool Names::is_qualified_by(const QualifiedName& name, const Declaration& member) const {
    if (name.parts.size() < 2) return true;
    const std::string full = "::" + qualify_name(full_name(member.parent), member.name);
    return full.ends_with("::" + name.text());
}

bool Names::is_lost(const QualifiedName& name) const {
    asked_lost_ = true;
    if (lost_declarations_) return true;
    return std::ranges::any_of(name.parts,
                               [&](const std::string& part) { return part.starts_with('?') || lost_.contains(part); });
}

bool Names::has_package(const std::string& name) const {
    return std::ranges::binary_search(packages_, name);
}

bool Names::leads_to_package(const std::string& name) const {
    if (has_package(name)) return true;
    const auto inner = std::ranges::lower_bound(packages_, name + "::");
    return inner != packages_.end() && inner->starts_with(name + "::");
}

}  // namespace robochart::frontend
