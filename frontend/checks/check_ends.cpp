// SPDX-License-Identifier: Apache-2.0
// Checks Cn10 (language reference 2): the component at each end of a connection has the connected event. If an
// interface clause is missing, all events of the interface are missing. This is reported once, even if several
// connections use the events.
#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/diagnostics/spelling.hpp"
#include "frontend/checks/checks.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

namespace {

class EndCheck {
public:
    EndCheck(const Names& names, Diagnostics& out) : names_(names), out_(out) {}

    void check_ends_in(const Component& component) {
        out_.poll();
        for (const auto& connection : component.connections) {
            end(connection->from);
            end(connection->to);
        }
        for (const auto& controller : component.controllers) this->check_ends_in(*controller);
    }

private:
    void end(const Connection::End& end) {
        if (end.node_target == nullptr || end.event_target != nullptr) return;
        const auto* behind = follow_to<Context>(end.node_target);
        if (behind == nullptr || behind->broken || names_.is_lost(end.event) || has_unknown_interface(*behind)) return;
        const std::string event = end.event.text();
        const Context* const interface = names_.interface_with(event, DeclKind::event);
        if (is_reported(*behind, event, interface)) return;
        auto& finding = out_.report(rules::cn10, end.event.span, {end.node.text(), event});
        if (out_.error_count() > Diagnostics::max_kept) return;
        std::vector<std::string> events;
        for (const auto& [name, declared] : scope_of(*behind).events) events.emplace_back(name);
        const std::string meant = diagnostics::nearest_spelling(event, events);
        if (!meant.empty())
            finding.fixes.push_back(
                {end.event.span, meant, diagnostics::suggestion_verb(diagnostics::is_certain(event, meant, events))});
        if (interface != nullptr)
            finding.notes.push_back(
                {interface->name_span,
                 fmt::format("interface `{}` declares `{}`; `uses {}` in `{}` makes its declarations visible",
                             interface->name, event, names_.full_name(interface), behind->name)});
    }

    /// True if the missing event has been reported already: at its use in the machine, or with another event of the
    /// interface.
    bool is_reported(const Context& behind, const std::string& event, const Context* interface) {
        const std::set<std::string>& used = unknown_events(behind);
        if (used.contains(event)) return true;
        if (interface == nullptr) return false;
        for (const std::string& other : used)
            if (names_.interface_with(other, DeclKind::event) == interface) return true;
        return !reported_.emplace(&behind, interface).second;
    }

    /// Returns the events that the machine uses but that are declared nowhere.
    const std::set<std::string>& unknown_events(const Context& component) {
        const auto entry = unknown_.try_emplace(&component);
        std::set<std::string>& found = entry.first->second;
        const auto* machine = dynamic_cast<const Machine*>(&component);
        if (!entry.second || machine == nullptr) return found;
        const auto add = [&](const Communication& communication) {
            if (communication.event_target == nullptr) found.insert(communication.event.parts.back());
        };
        walk_tree(*machine, [&](const NodeContainer& container) {
            for (const auto& transition : container.transitions)
                if (transition->trigger) add(*transition->trigger);
        });
        for_actions(*machine, [&](const Stmt& action) {
            walk_tree(action, [&](const Stmt& statement) {
                if (statement.kind == StmtKind::communication) add(*statement.communication);
            });
        });
        return found;
    }

    const Names& names_;
    Diagnostics& out_;
    std::map<const Context*, std::set<std::string>> unknown_;  ///< for lookup only; the order of pointers is never used
    std::set<std::pair<const Context*, const Context*>> reported_;  ///< for lookup only; the order is never used
};

}  // namespace

void check_ends(const Model& model, const Names& names, Diagnostics& out) {
    EndCheck check(names, out);
    for (const auto& file : model.files)
        for (const auto& declaration : file->declarations)
            if (const auto* component = dynamic_cast<const Component*>(declaration.get()))
                check.check_ends_in(*component);
}

}  // namespace robochart::frontend
