// Shared parts of lowering.
#include "semantics/lower/lowering.hpp"

#include "semantics/rules.hpp"

namespace robochart::ir {

std::string Lowering::package_of(const frontend::Declaration& declaration) const {
    const frontend::Declaration* top = &declaration;
    while (top->parent != nullptr && home.count(top) == 0) top = top->parent;
    const auto file = home.find(top);
    return file == home.end() ? "" : file->second->package.text();
}

void Lowering::unsupported(const std::string& what, diagnostics::Span where) const {
    diagnostics.report(rules::unsupported_construct, where, {what});
}

void Lowering::unresolved(const std::string& what, diagnostics::Span where) const {
    diagnostics.report(rules::unresolved, where, {what});
}

Origin origin_of(const std::string& element, diagnostics::Span span) {
    return {element, span};
}

}  // namespace robochart::ir
