// Resolution as a whole: names, then types, then rules. Rules about absent things stay silent about files that could
// not be read completely: what seems absent may just not have been understood.
#include "frontend/checks.hpp"
#include "frontend/lints.hpp"
#include "frontend/project.hpp"
#include "frontend/reset.hpp"
#include "frontend/resolver.hpp"

namespace robochart::frontend {

namespace {

void check(const Declaration& declaration, Diagnostics& out) {
    if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declaration)) check_type(*type, out);
    if (const auto* machine = dynamic_cast<const Machine*>(&declaration)) {
        check_nodes(*machine, out);
        check_time(*machine, out);
    }
    if (const auto* context = dynamic_cast<const Context*>(&declaration)) check_component(*context, out);
    if (const auto* component = dynamic_cast<const Component*>(&declaration)) {
        for (const auto& part : component->platforms) check(*part, out);
        for (const auto& part : component->controllers) check(*part, out);
        for (const auto& part : component->machines) check(*part, out);
        for (const auto& part : component->operations) check(*part, out);
        check_provision(*component, out);
        check_connections(*component, out);
        check_directions(*component, out);
    }
}

}  // namespace

void resolve(Model& model, diagnostics::Diagnostics& out) {
    reset(model);
    const Names names(model);
    Finder finder(names, out);
    Resolver(model, finder).run();
    check_unique(names, out);
    for (const auto& file : model.files) {
        check_unique(*file, out);
        if (file->has_syntax_errors) continue;
        for (const auto& declaration : file->declarations) check(*declaration, out);
    }
    lint(model, names, out);
}

}  // namespace robochart::frontend
