// SPDX-License-Identifier: Apache-2.0
// Compares the targets of occurrences.
#include "editors/server/workspace/names.hpp"

namespace robochart::lsp {

namespace {

using frontend::NameKind;
using frontend::Occurrence;

bool same_target(const Occurrence& a, const Occurrence& b) {
    if (a.kind != b.kind) return false;
    switch (a.kind) {
        case NameKind::declaration:
            return a.target == b.target;
        case NameKind::package:
        case NameKind::process:
        case NameKind::definition:
            return a.text == b.text;
        case NameKind::assertion:
            return a.text == b.text && a.span.source == b.span.source;
        case NameKind::core_type:
        case NameKind::type_variable:
        case NameKind::unknown:
            break;
    }
    return &a == &b;
}

}  // namespace

std::vector<const Occurrence*> same_name(Project& project, const Occurrence& name) {
    std::vector<const Occurrence*> result;
    for (const Occurrence& occurrence : project.current_occurrences())
        if (same_target(occurrence, name)) result.push_back(&occurrence);
    return result;
}

}  // namespace robochart::lsp
