// Declarations that share a name (published as RP3, I3, C5, STM5, O1): a warning at each but the first.
#include <map>

#include "frontend/checks.hpp"
#include "frontend/rules.hpp"
#include "frontend/walk.hpp"

namespace robochart::frontend {

namespace {

class Seen {
public:
    explicit Seen(Diagnostics& out) : out_(out) {}

    void add(const Declaration& declaration) {
        const auto [first, fresh] = first_.emplace(declaration.name, &declaration);
        if (fresh) return;
        out_.report(rules::not_unique, declaration.name_span, {declaration.name})
            .notes.push_back({first->second->name_span, "first declared here"});
    }

private:
    Diagnostics& out_;
    std::map<std::string_view, const Declaration*> first_;
};

void check_members(const Context& context, Diagnostics& out) {
    Seen variables(out);
    Seen events(out);
    Seen clocks(out);
    if (const auto* machine = dynamic_cast<const Machine*>(&context))
        for (const auto& parameter : machine->parameters) variables.add(*parameter);
    for (const auto& variable : context.variables) variables.add(*variable);
    for (const auto& event : context.events) events.add(*event);
    for (const auto& clock : context.clocks) clocks.add(*clock);
}

void check_node_names(const NodeContainer& machine, Diagnostics& out) {
    walk(machine, [&](const NodeContainer& container) {
        Seen nodes(out);
        Seen transitions(out);
        for (const auto& node : container.nodes) nodes.add(*node);
        for (const auto& transition : container.transitions) transitions.add(*transition);
    });
}

bool is_type(DeclKind kind) {
    return kind == DeclKind::primitive_type || kind == DeclKind::record_type || kind == DeclKind::enumeration;
}

/// Literals and functions may share names with components; things of one kind may not.
bool clash(const Declaration& a, const Declaration& b) {
    if (a.kind == DeclKind::enum_literal || b.kind == DeclKind::enum_literal)
        return a.kind == b.kind && a.parent == b.parent;
    return a.kind == b.kind || (is_type(a.kind) && is_type(b.kind));
}

}  // namespace

void check_unique(const File& file, Diagnostics& out) {
    std::map<std::string_view, const Assertion*> seen;
    for (const Assertion& assertion : file.assertions) {
        const auto [first, fresh] = seen.emplace(assertion.name, &assertion);
        if (fresh) continue;
        out.report(rules::not_unique, assertion.name_span, {assertion.name})
            .notes.push_back({first->second->name_span, "first declared here"});
    }
}

void check_unique(const Names& names, Diagnostics& out) {
    for (const auto& [full, declarations] : names.entries()) {
        for (std::size_t i = 1; i < declarations.size(); ++i) {
            // A literal is entered twice when its enumeration has its own name.
            if (declarations[i] == declarations[0] || !clash(*declarations[0], *declarations[i])) continue;
            if (declarations[i]->kind == DeclKind::enum_literal && full != names.full_name(declarations[i])) continue;
            out.report(rules::not_unique, declarations[i]->name_span, {declarations[i]->name})
                .notes.push_back({declarations[0]->name_span, "first declared here"});
        }
        for (const Declaration* declaration : declarations) {
            if (const auto* context = dynamic_cast<const Context*>(declaration)) check_members(*context, out);
            if (const auto* machine = dynamic_cast<const Machine*>(declaration)) check_node_names(*machine, out);
        }
    }
}

}  // namespace robochart::frontend
