// SPDX-License-Identifier: Apache-2.0
// See block_claims.hpp. The analysis follows definitions by name, for all arguments. A set is assumed to contain all
// events that it may contain.
#include "csp_emit/block_claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "base/diagnostics/text.hpp"
#include "checker/cspm/syntax/lookup.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "csp_emit/base/rules.hpp"

namespace robochart::csp_emit {
namespace {

using cspm::DeclPtr;
using cspm::ExprKind;
using cspm::ExprPtr;

void each_part(const cspm::Expr& expr, const std::function<void(const ExprPtr&)>& visit) {
    for (const ExprPtr& argument : expr.args) visit(argument);
    for (const cspm::Field& field : expr.fields)
        if (field.value) visit(field.value);
    for (const cspm::Clause& clause : expr.clauses) visit(clause.value);
    for (const cspm::Link& link : expr.links) {
        visit(link.from);
        visit(link.to);
    }
    for (const DeclPtr& decl : expr.decls)
        if (decl->body) visit(decl->body);
}

/// The definitions in the blocks of a file, as far as they matter for claims about processes.
class Definitions {
public:
    Definitions(const std::vector<DeclPtr>& decls, const Provenance& provenance) : provenance_(provenance) {
        declare(decls);
    }

    [[nodiscard]] bool defines(const std::string& name) const { return declared_.contains(name); }
    /// Returns the inputs that the process hides, under the names that the process uses.
    [[nodiscard]] std::set<std::string> hidden_inputs(const std::string& process) {
        followed_.clear();
        hidden_.clear();
        follow_name(process);
        return std::move(hidden_);
    }

private:
    /// Adds declarations. Those in timed sections belong to the enclosing scope.
    void declare(const std::vector<DeclPtr>& decls) {
        for (const DeclPtr& decl : decls) {
            if (decl->kind == cspm::DeclKind::timed) declare(decl->decls);
            for (const std::string& name : cspm::declared_names(*decl)) declared_[name].push_back(decl);
        }
    }
    void follow_name(const std::string& name) {
        if (!followed_.insert(name).second) return;
        if (const auto found = declared_.find(name); found != declared_.end())
            for (const DeclPtr& decl : found->second)
                if (decl->body) follow_names(decl->body);
    }
    void follow_names(const ExprPtr& expr) {
        if (!expr) return;
        if (expr->kind == ExprKind::name) follow_name(expr->text);
        if (expr->kind == ExprKind::hide && expr->args.size() == 2) note_hidden(expr->args[1]);
        if (expr->kind == ExprKind::project && expr->args.size() == 2) note_projected(expr->args[0], expr->args[1]);
        each_part(*expr, [&](const ExprPtr& part) { follow_names(part); });
    }

    /// Collects the names in an expression and in the definitions of these names. An event `e.out` does not represent
    /// all events of `e`.
    void collect_names(const ExprPtr& expr, std::set<std::string>& result) const {
        if (!expr) return;
        if (expr->kind == ExprKind::dot && expr->args.size() > 1 && expr->args[0]->kind == ExprKind::name &&
            expr->args[1]->kind == ExprKind::name) {
            result.insert(expr->args[0]->text + "." + expr->args[1]->text);
            return;
        }
        if (expr->kind == ExprKind::name && result.insert(expr->text).second)
            if (const auto found = declared_.find(expr->text); found != declared_.end())
                for (const DeclPtr& decl : found->second) collect_names(decl->body, result);
        each_part(*expr, [&](const ExprPtr& part) { collect_names(part, result); });
    }

    /// True if the environment decides the event: inputs, and external writes to variables.
    [[nodiscard]] static bool decided_outside(MeaningKind kind) {
        return kind == MeaningKind::trigger || kind == MeaningKind::external_write;
    }
    [[nodiscard]] bool is_input(const std::string& event) const {
        const auto found = provenance_.events.find(event);
        return found != provenance_.events.end() && decided_outside(found->second.kind);
    }

    void note_hidden(const ExprPtr& set) {
        std::set<std::string> all;
        collect_names(set, all);
        for (const std::string& name : all)
            if (is_input(name) || is_input(name + ".in")) hidden_.insert(name);
    }
    /// Adds all inputs of the components in the process except those in the set.
    void note_projected(const ExprPtr& process, const ExprPtr& set) {
        std::set<std::string> visible, inside;
        collect_names(set, visible);
        collect_names(process, inside);
        for (const std::string& name : inside) {
            const std::size_t end = name.rfind("::");
            if (end == std::string::npos || !name.ends_with("__")) continue;
            const std::string prefix = name.substr(0, end + 2);
            const auto& events = provenance_.events;
            for (auto at = events.lower_bound(prefix); at != events.end() && at->first.starts_with(prefix); ++at) {
                const std::string& event = at->first;
                if (!decided_outside(at->second.kind) || event.find("::", prefix.size()) != std::string::npos) continue;
                if (!visible.contains(event) && !visible.contains(event.substr(0, event.find('.', prefix.size()))))
                    hidden_.insert(event);
            }
        }
    }

    const Provenance& provenance_;
    std::map<std::string, std::vector<DeclPtr>> declared_;
    std::set<std::string> followed_, hidden_;
};

bool with_refusals(const ir::Property& property) {
    const bool compared = property.kind == ir::PropertyKind::refines || property.kind == ir::PropertyKind::equals;
    return compared && property.model != ir::PropertyModel::traces;
}

ir::PropertyKind kind_of(cspm::AssertionKind kind) {
    switch (kind) {
        case cspm::AssertionKind::deadlock_free:
            return ir::PropertyKind::deadlock_free;
        case cspm::AssertionKind::divergence_free:
            return ir::PropertyKind::divergence_free;
        case cspm::AssertionKind::deterministic:
            return ir::PropertyKind::deterministic;
        case cspm::AssertionKind::refinement:
        case cspm::AssertionKind::has_trace:
            break;
    }
    return ir::PropertyKind::refines;
}

}  // namespace

std::vector<Obligation> block_obligations(const Project& project, const std::vector<DeclPtr>& decls) {
    std::vector<Obligation> result;
    for (const DeclPtr& decl : cspm::assertions_in(decls)) {
        Obligation one;
        one.kind = kind_of(decl->assertion.kind);
        one.negated = decl->assertion.negated;
        one.title = fmt::format("[{}] {}", project.is_timed() ? "timed" : "untimed",
                                diagnostics::on_one_line(cspm::print(*decl)));
        one.time = project.time;
        one.origin.span = decl->span;
        one.assertions = {decl};
        if (one.negated) one.reason = "what it denies holds";
        result.push_back(std::move(one));
    }
    return result;
}

void check_block_claims(const Project& project, const DeclsOfFiles& files, const Provenance& provenance) {
    std::set<std::string> reported;
    std::map<std::string, Definitions> definitions;  // by the path of the assertion file
    for (const ir::Property& property : project.system.properties) {
        const bool both = property.timed && property.untimed;
        if (project.is_timed() ? !property.timed : !property.untimed) continue;
        for (const ir::ComponentRef* const side : {&property.subject, &property.other}) {
            if (side->kind != ir::ComponentKind::process || side->definition >= project.system.csp_blocks.size())
                continue;
            const ir::CspBlock& block = project.system.csp_blocks[side->definition];
            if (!project.block_applies(block)) {
                if (reported.insert(property.name).second)
                    project.diagnostics
                        .report(rules::block_of_other_time, property.origin.span,
                                {property.name, block.timed ? "timed" : "untimed", block.name})
                        .notes.push_back({{}, fmt::format("write `{} assertion`", block.timed ? "timed" : "untimed")});
                continue;
            }
            const auto decls = files.find(block.file);
            // A claim of both semantics is checked only in the untimed run, so that a missing process is reported once.
            if (decls == files.end() || (project.is_timed() && both)) continue;
            Definitions& defined = definitions.try_emplace(block.file, decls->second, provenance).first->second;
            if (!defined.defines(block.name)) {
                if (reported.insert(block.name).second)
                    project.diagnostics.report(rules::block_without_process, property.origin.span,
                                               {property.name, block.name});
                continue;
            }
            if (side != &property.subject && property.kind != ir::PropertyKind::equals) continue;
            if (!with_refusals(property)) continue;
            const std::set<std::string> hidden = defined.hidden_inputs(block.name);
            if (!hidden.empty())
                project.diagnostics.report(rules::inputs_hidden, property.origin.span,
                                           {property.name, block.name, fmt::format("{}", fmt::join(hidden, ", "))});
        }
    }
}

}  // namespace robochart::csp_emit
