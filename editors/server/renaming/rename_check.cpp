// SPDX-License-Identifier: Apache-2.0
// See rename_check.hpp. Edits replace names by names, so the n-th name before the edits is the n-th name after them.
#include "editors/server/renaming/rename_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"

namespace robochart::lsp {

namespace {

using frontend::Model;
using frontend::Occurrence;

/// A copy of the project, parsed from edited texts.
struct Copy {
    SourceManager sources;
    Model model;
    diagnostics::Diagnostics findings;
};

std::string apply_edits(std::string_view text, SourceId source, std::vector<Edit> edits) {
    std::erase_if(edits, [&](const Edit& edit) { return edit.span.source != source; });
    std::ranges::sort(edits, [](const Edit& a, const Edit& b) { return a.span.begin < b.span.begin; });
    std::string out;
    std::size_t at = 0;
    for (const Edit& edit : edits) {
        out += std::string(text.substr(at, edit.span.begin - at)) + edit.text;
        at = edit.span.end;
    }
    return out + std::string(text.substr(at));
}

void read(Copy& copy, Project& project, const std::vector<Edit>& edits) {
    const SourceManager& sources = project.sources();
    for (const auto& file : project.current_model().files) {
        if (file->is_library) continue;
        const auto id = copy.sources.add(sources.path(file->source),
                                         apply_edits(sources.source_text(file->source), file->source, edits));
        copy.model.files.push_back(frontend::parse(copy.sources, id, file->is_assertions, copy.findings));
    }
    frontend::update_toolkits(copy.sources, copy.model, copy.findings);
    frontend::resolve(copy.model, copy.findings);
}

/// The meaning of a name in a form that does not depend on the copy: the number of the declaring name, or the text.
struct Meaning {
    frontend::NameKind kind;
    std::size_t declared_at;
    std::string library_name;

    friend bool operator==(const Meaning&, const Meaning&) = default;
};

/// All names of a project. The files, and so the names, have the same order in both projects.
struct Names {
    std::vector<const Occurrence*> list;
    std::vector<Meaning> meanings;
};

Names names_of(const Model& model, const std::vector<Occurrence>& all) {
    std::map<SourceId, std::vector<const Occurrence*>> by_source;
    for (const Occurrence& occurrence : all) by_source[occurrence.span.source].push_back(&occurrence);
    Names names;
    for (const auto& file : model.files)
        names.list.insert(names.list.end(), by_source[file->source].begin(), by_source[file->source].end());
    std::map<const frontend::Declaration*, std::size_t> declared;
    for (std::size_t i = 0; i < names.list.size(); ++i)
        if (names.list[i]->declares && names.list[i]->target != nullptr) declared.emplace(names.list[i]->target, i);
    for (const Occurrence* occurrence : names.list) {
        const auto found = declared.find(occurrence->target);
        const bool ours = found != declared.end();
        const std::string library = !ours && occurrence->target != nullptr ? occurrence->target->name : std::string();
        names.meanings.push_back({occurrence->kind, ours ? found->second : names.list.size(), library});
    }
    return names;
}

std::map<std::string_view, std::size_t> count_by_rule(const std::vector<const diagnostics::Diagnostics*>& lists) {
    std::map<std::string_view, std::size_t> result;
    for (const auto* findings : lists)
        for (const auto& finding : findings->sorted_findings()) ++result[finding.rule->code];
    return result;
}

/// Returns a finding that did not exist before; "" if there is none.
std::string new_finding(Project& project, const Copy& copy) {
    std::vector<const diagnostics::Diagnostics*> lists{&project.current_findings()};
    for (const auto& [path, document] : project.documents()) lists.push_back(&document->findings);
    const auto before = count_by_rule(lists);
    const auto after = count_by_rule({&copy.findings});
    if (before == after) return {};
    for (const auto& finding : copy.findings.sorted_findings()) {
        const auto had = before.find(finding.rule->code);
        if (had == before.end() || had->second < after.at(finding.rule->code))
            return fmt::format("{} ({}, {})", finding.message(), finding.rule->code,
                               copy.sources.path_and_line(finding.span));
    }
    return "a finding of the rules would vanish: the model would mean something else";
}

}  // namespace

std::string harm_of(Project& project, const std::vector<Edit>& edits) {
    Copy copy;
    read(copy, project, edits);
    if (std::string finding = new_finding(project, copy); !finding.empty()) return finding;
    const std::vector<Occurrence> after_all = frontend::find_occurrences(copy.model);
    const Names before = names_of(project.current_model(), project.current_occurrences());
    const Names after = names_of(copy.model, after_all);
    if (before.list.size() != after.list.size()) return "the text would be read differently";
    for (std::size_t i = 0; i < before.list.size(); ++i)
        if (before.meanings[i] != after.meanings[i])
            return fmt::format("the name at {} would stand for something else",
                               copy.sources.path_and_line(after.list[i]->span));
    return {};
}

}  // namespace robochart::lsp
