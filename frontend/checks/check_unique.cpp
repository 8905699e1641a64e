// SPDX-License-Identifier: Apache-2.0
// Reports declarations that share a name (published as RP3, I3, C5, STM5, O1). Each name gets one warning, at its
// second declaration, with notes at the others.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

#include "frontend/checks/checks.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

namespace {

/// The places at which one name is declared, in the order of the declarations.
using Places = std::vector<Span>;

void report(std::string_view name, const Places& places, Diagnostics& out) {
    constexpr std::size_t max_shown = 8;
    if (places.size() < 2) return;
    auto& finding = out.report(rules::not_unique, places[1], {std::string(name)});
    finding.notes.push_back({places[0], "first declared here"});
    for (std::size_t i = 2; i < std::min(places.size(), max_shown); ++i)
        finding.notes.push_back({places[i], "declared again here"});
    if (places.size() > max_shown)
        finding.notes.push_back(
            {places.back(), fmt::format("and at {} more places, the last one here", places.size() - max_shown)});
}

/// Collects names as they are declared. Each duplicate is reported once, in the order of names.
class Seen {
public:
    explicit Seen(Diagnostics& out) : out_(out) {}
    ~Seen() {
        for (const auto& [name, places] : places_) report(name, places, out_);
    }
    Seen(const Seen&) = delete;
    Seen& operator=(const Seen&) = delete;

    void add(std::string_view name, const Span& place) { places_[name].push_back(place); }
    void add(const Declaration& declaration) { add(declaration.name, declaration.name_span); }

private:
    Diagnostics& out_;
    std::map<std::string_view, Places> places_;
};

void check_unique_members(const Context& context, Diagnostics& out) {
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
    walk_tree(machine, [&](const NodeContainer& container) {
        Seen nodes(out);
        Seen transitions(out);
        for (const auto& node : container.nodes) nodes.add(*node);
        for (const auto& transition : container.transitions) transitions.add(*transition);
    });
}

bool is_type(DeclKind kind) {
    return kind == DeclKind::primitive_type || kind == DeclKind::record_type || kind == DeclKind::enumeration;
}

/// True if two declarations must not share a name because they have the same kind. Literals and functions may have the
/// names of components.
bool names_clash(const Declaration& a, const Declaration& b) {
    if (a.kind == DeclKind::enum_literal || b.kind == DeclKind::enum_literal)
        return a.kind == b.kind && a.parent == b.parent;
    return a.kind == b.kind || (is_type(a.kind) && is_type(b.kind));
}

}  // namespace

namespace {

/// Checks that the names of assertions are unique in a package and dialect, because the command line and reports use
/// them. Files of one package in different folders may be copies of a project, so each folder is checked separately.
void check_assertions(const Model& model, Diagnostics& out) {
    std::map<std::tuple<std::string_view, std::string, Dialect>, std::vector<const File*>> together;
    for (const auto& file : model.files)
        together[{file->folder, file->package.text(), file->dialect}].push_back(file.get());
    for (const auto& [where, files] : together) {
        Seen assertions(out);
        for (const File* file : files) {
            for (const Assertion& assertion : file->assertions) assertions.add(assertion.name, assertion.name_span);
            for (const ProbabilisticAssertion& assertion : file->probabilistic_assertions)
                assertions.add(assertion.name, assertion.name_span);
        }
    }
}

/// Checks the declarations of one full name. Each kind is reported separately.
void check_entry(const Names& names, const std::string& full, const std::vector<const Declaration*>& declarations,
                 Diagnostics& out) {
    std::vector<std::vector<const Declaration*>> groups;
    std::unordered_set<const Declaration*> entered;
    for (const Declaration* declaration : declarations) {
        // The table contains a literal of a named enumeration twice. Only the entry with the full name is checked.
        if (declaration->kind == DeclKind::enum_literal && full != names.full_name(declaration)) continue;
        if (!entered.insert(declaration).second) continue;
        const auto group =
            std::ranges::find_if(groups, [&](const auto& g) { return names_clash(*g.front(), *declaration); });
        if (group == groups.end())
            groups.push_back({declaration});
        else
            group->push_back(declaration);
    }
    for (const auto& group : groups) {
        Places places;
        for (const Declaration* declaration : group) places.push_back(declaration->name_span);
        report(group.front()->name, places, out);
    }
}

/// Checks the names of csp blocks. The blocks of a file belong to one script. A name may be used once for a timed and
/// once for an untimed process.
void check_blocks(const File& file, Diagnostics& out) {
    std::map<std::string_view, std::vector<const CspBlock*>> blocks;
    for (const CspBlock& block : file.csp_blocks) blocks[block.name].push_back(&block);
    const auto meet = [](const CspBlock& a, const CspBlock& b) {
        return a.time == b.time || a.time == AssertionTime::both || b.time == AssertionTime::both;
    };
    for (const auto& [name, all] : blocks) {
        Places places;
        for (const CspBlock* block : all)
            if (std::ranges::any_of(all, [&](const CspBlock* other) { return other != block && meet(*block, *other); }))
                places.push_back(block->name_span);
        report(name, places, out);
    }
}

}  // namespace

void check_unique(const Model& model, const Names& names, Diagnostics& out) {
    check_assertions(model, out);
    for (const auto& file : model.files) check_blocks(*file, out);
    for (const auto& [full, declarations] : names.entries()) {
        check_entry(names, full, declarations, out);
        for (const Declaration* declaration : declarations) {
            if (const auto* context = dynamic_cast<const Context*>(declaration)) check_unique_members(*context, out);
            if (const auto* machine = dynamic_cast<const Machine*>(declaration)) check_node_names(*machine, out);
        }
    }
}

}  // namespace robochart::frontend
