// SPDX-License-Identifier: Apache-2.0
// Performs the whole resolution: names, then types, then rules. Rules do not check a declaration with a syntax error,
// because a part that seems absent may be in the text that could not be parsed. While some file has syntax errors,
// rules about several declarations are not checked at all.
#include <algorithm>
#include <array>
#include <string_view>

#include "frontend/checks/checks.hpp"
#include "frontend/lint/lints.hpp"
#include "frontend/project/clear_resolution.hpp"
#include "frontend/project/project.hpp"
#include "frontend/resolve/resolver.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

/// Checks the rules that consider a single declaration.
void check_inside(const Declaration& declaration, Diagnostics& out) {
    if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declaration)) check_type(*type, out);
    if (const auto* machine = dynamic_cast<const Machine*>(&declaration)) {
        check_nodes(*machine, out);
        check_time(*machine, out);
    }
}

/// Checks a declaration. `whole` is true if all files were parsed without errors.
void check(const Declaration& declaration, bool whole, Diagnostics& out) {
    out.poll();
    if (!declaration.broken) check_inside(declaration, out);
    const auto* context = dynamic_cast<const Context*>(&declaration);
    const bool robosim = context != nullptr && context->dialect == Dialect::robosim;
    if (context != nullptr && whole) check_component(*context, out);
    if (robosim && !declaration.broken) check_robosim(*context, out);
    const auto* component = dynamic_cast<const Component*>(&declaration);
    if (component == nullptr) return;
    for (const auto& part : component->platforms) check(*part, whole, out);
    for (const auto& part : component->controllers) check(*part, whole, out);
    for (const auto& part : component->machines) check(*part, whole, out);
    for (const auto& part : component->operations) check(*part, whole, out);
    if (!whole) return;
    check_connections(*component, out);
    if (robosim) return;
    check_provision(*component, out);
    check_directions(*component, out);
}

}  // namespace

/// The words that begin parts of claims files. The parser has already reported these parts.
constexpr std::array<std::string_view, 4> words_of_claims = {"claim", "assume", "order", "unit"};

void check_probabilistic(const File& file, Diagnostics& out) {
    for (const ProbabilisticAssertion& assertion : file.probabilistic_assertions)
        if (assertion.property && !assertion.broken) check_property(*assertion.property, out);
    for (const KeptPart& part : file.kept)
        if (!part.claims && std::ranges::find(words_of_claims, part.form) == words_of_claims.end())
            out.report(rules::part_passed_over, part.span, {part.form + (part.name.empty() ? "" : " " + part.name)});
}

void check(const Model& model, const Names& names, Diagnostics& out) {
    check_unique(model, names, out);
    check_imports(model, names, out);
    check_ends(model, names, out);
    const bool whole = std::ranges::none_of(model.files, [](const auto& file) { return file->has_syntax_errors; });
    for (const auto& file : model.files) {
        check_probabilistic(*file, out);
        for (const auto& simulation : file->simulations) check_simulation(*simulation, out);
        if (file->dialect == Dialect::robosim)
            for (const Assertion& assertion : file->assertions) check_claim(assertion, out);
        for (const auto& declaration : file->declarations) check(*declaration, whole, out);
    }
}

void resolve(Model& model, diagnostics::Diagnostics& out) {
    reset(model);
    const Names names(model);
    Finder finder(names, out);
    Resolver(model, finder).run();
    check(model, names, out);
    lint_model(model, names, out);
}

}  // namespace robochart::frontend
