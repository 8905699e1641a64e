// SPDX-License-Identifier: Apache-2.0
// Runs the lints.
#include <algorithm>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/lint/lints.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

WrittenBy variables_written_by_operations(const Model& model) {
    WrittenBy result;
    const auto add = [&](const Machine& operation) {
        Effects effects;
        for_actions(operation, [&](const Stmt& action) { add_effects(action, effects); });
        std::unordered_set<std::string>& names = result[operation.name];
        for (const Declaration* written : effects.writes)
            if (written != nullptr) names.insert(written->name);
    };
    for (const auto& file : model.files)
        for (const auto& declaration : file->declarations) {
            if (declaration->kind == DeclKind::operation) add(static_cast<const Machine&>(*declaration));
            const auto* component = dynamic_cast<const Component*>(declaration.get());
            if (component == nullptr) continue;
            for (const auto& operation : component->operations) add(*operation);
            for (const auto& controller : component->controllers)
                for (const auto& operation : controller->operations) add(*operation);
        }
    return result;
}

namespace {

/// Reports the warnings that need only one component of a file.
class Linter {
public:
    Linter(const File& file, const Names& names, const WrittenBy& written_by, Diagnostics& out)
        : file_(file), names_(names), written_by_(written_by), out_(out) {}

    void lint_declaration(const Declaration& declaration) {
        out_.poll();
        if (const auto* machine = dynamic_cast<const Machine*>(&declaration)) this->lint_machine(*machine);
        const auto* context = dynamic_cast<const Context*>(&declaration);
        if (context == nullptr) return;
        lint_shadowing(file_, *context, names_, out_);
        if (const auto* component = dynamic_cast<const Component*>(context)) lint_parts(*component);
    }

private:
    void lint_machine(const Machine& machine) {
        Never never;
        if (machine.dialect == Dialect::robosim) {
            // The other warnings depend on triggers and on the order of steps, which are different in models with
            // registers.
            lint_reachability(machine, never, out_);
            lint_statements(machine, out_);
            lint_cycles(machine, out_);
            return;
        }
        lint_guards(machine, never, out_);
        lint_reachability(machine, never, out_);
        lint_flow(machine, written_by_, out_);
        lint_loops(machine, never, out_);
        lint_arithmetic(machine, out_);
        lint_growth(machine, written_by_, out_);
        lint_statements(machine, out_);
        lint_missed(machine, out_);
        lint_termination(machine, out_);
    }

    void lint_parts(const Component& component) {
        for (const auto& part : component.platforms) lint_declaration(*part);
        for (const auto& part : component.controllers) lint_declaration(*part);
        for (const auto& part : component.machines) lint_declaration(*part);
        for (const auto& part : component.operations) lint_declaration(*part);
    }

    const File& file_;
    const Names& names_;
    const WrittenBy& written_by_;
    Diagnostics& out_;
};

/// Reports the warnings that need a component and the declarations that it refers to.
void lint_component(const Component& component, ReportedCalls& reported, Diagnostics& out) {
    for (const auto& part : component.controllers) lint_component(*part, reported, out);
    lint_events(component, out);
    if (component.kind == DeclKind::controller) lint_operations(component, reported, out);
}

}  // namespace

bool may_lint(const File& file, const Diagnostics& out) {
    return !file.is_library && !file.has_syntax_errors && !out.has_errors_in(file.source);
}

bool may_lint_project(const Model& model, const Diagnostics& out) {
    return out.ok() && std::ranges::none_of(model.files, [](const auto& file) { return file->has_syntax_errors; });
}

void lint_file(const File& file, const Names& names, const WrittenBy& written_by, Diagnostics& out) {
    Linter linter(file, names, written_by, out);
    for (const auto& declaration : file.declarations) linter.lint_declaration(*declaration);
}

void lint_project(const Model& model, Diagnostics& out) {
    ReportedCalls reported;
    for (const auto& file : model.files)
        for (const auto& declaration : file->declarations)
            if (const auto* component = dynamic_cast<const Component*>(declaration.get());
                !file->is_library && component != nullptr)
                lint_component(*component, reported, out);
    lint_unused(model, out);
}

void lint_model(const Model& model, const Names& names, Diagnostics& out) {
    const bool whole = may_lint_project(model, out);
    const WrittenBy written_by = variables_written_by_operations(model);
    for (const auto& file : model.files)
        if (may_lint(*file, out)) lint_file(*file, names, written_by, out);
    if (whole) lint_project(model, out);
}

}  // namespace robochart::frontend
