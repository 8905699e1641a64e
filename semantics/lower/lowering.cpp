// SPDX-License-Identifier: Apache-2.0
// Implements helpers that the steps of lowering share.
#include "semantics/lower/lowering.hpp"

#include "semantics/rules.hpp"

namespace robochart::ir {

std::string Lowering::package_of(const frontend::Declaration& declaration) const {
    const frontend::Declaration* top = &declaration;
    while (top->parent != nullptr && home.count(top) == 0) top = top->parent;
    const auto file = home.find(top);
    return file == home.end() ? "" : file->second->package.text();
}

void Lowering::report_unsupported(const std::string& what, diagnostics::Span where) const {
    diagnostics.report(rules::unsupported_construct, where, {what});
}

void Lowering::report_unresolved(const std::string& what, diagnostics::Span where) const {
    diagnostics.report(rules::unresolved, where, {what});
}

void Lowering::check_unique(const std::vector<const frontend::Declaration*>& declarations, const std::string& owner,
                            const std::string& kind) const {
    std::map<std::string, diagnostics::Span> named;
    for (const frontend::Declaration* declaration : declarations) {
        const auto [first, added] = named.try_emplace(declaration->name, declaration->name_span);
        if (!added)
            diagnostics.report(rules::declared_twice, declaration->name_span, {owner, kind, declaration->name})
                .notes.push_back({first->second, "the first one"});
    }
}

Origin origin_of(const std::string& element, diagnostics::Span span) {
    return {element, span};
}

}  // namespace robochart::ir
