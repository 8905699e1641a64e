// Which lints run on what.
#include "diagnostics/diagnostic.hpp"
#include "frontend/lints.hpp"
#include "frontend/scopes.hpp"
#include "frontend/walk.hpp"

namespace robochart::frontend {

namespace {

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

class Linter {
public:
    Linter(const Model& model, const Names& names, Diagnostics& out)
        : written_by_(variables_written_by_operations(model)), names_(names), out_(out), whole_(out.ok()) {}

    void file(const File& file) {
        for (const auto& declaration : file.declarations) this->declaration(file, *declaration);
    }

private:
    void declaration(const File& file, const Declaration& declaration) {
        if (const auto* machine = dynamic_cast<const Machine*>(&declaration)) this->machine(*machine);
        const auto* context = dynamic_cast<const Context*>(&declaration);
        if (context == nullptr) return;
        lint_shadowing(file, *context, names_, out_);
        if (const auto* component = dynamic_cast<const Component*>(context)) this->component(file, *component);
    }

    void machine(const Machine& machine) {
        Never never;
        lint_guards(machine, never, out_);
        lint_reachability(machine, never, out_);
        lint_flow(machine, written_by_, out_);
        lint_loops(machine, never, out_);
        lint_arithmetic(machine, out_);
        lint_statements(machine, out_);
    }

    void component(const File& file, const Component& component) {
        for (const auto& part : component.platforms) declaration(file, *part);
        for (const auto& part : component.controllers) declaration(file, *part);
        for (const auto& part : component.machines) declaration(file, *part);
        for (const auto& part : component.operations) declaration(file, *part);
        if (!whole_) return;
        lint_events(component, out_);
        if (component.kind == DeclKind::controller) lint_operations(component, told_, out_);
    }

    WrittenBy written_by_;
    const Names& names_;
    Diagnostics& out_;
    Told told_;
    bool whole_;  ///< no file has errors
};

}  // namespace

void lint(const Model& model, const Names& names, Diagnostics& out) {
    const bool whole = out.ok();
    Linter linter(model, names, out);
    for (const auto& file : model.files)
        if (!file->is_library && !out.has_errors_in(file->source)) linter.file(*file);
    if (whole) lint_unused(model, out);
}

}  // namespace robochart::frontend
