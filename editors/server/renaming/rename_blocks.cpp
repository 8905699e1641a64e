// SPDX-License-Identifier: Apache-2.0
#include "editors/server/renaming/rename_blocks.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "checker/cspm/syntax/lexer.hpp"
#include "csp_emit/blocks/check_blocks.hpp"
#include "frontend/project/project.hpp"

namespace robochart::lsp {

namespace {

/// Prefixes and suffixes that the script adds to the name of an element.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> forms = {
    {{"", ""}, {"", "Call"}, {"set_", ""}, {"set_EXT_", ""}, {"get_", ""}}};

std::string in_form(const std::pair<std::string_view, std::string_view>& form, const std::string& name) {
    return std::string(form.first) + name + std::string(form.second);
}

std::vector<Edit> candidate_edits(Project& project, const std::string& old_name, const std::string& new_name) {
    std::vector<Edit> result;
    for (const auto& file : project.current_model().files)
        for (const frontend::CspBlock& block : file->csp_blocks) {
            const Span place = block.text_span;
            const std::string_view text =
                project.sources().source_text(place.source).substr(place.begin, place.end - place.begin);
            diagnostics::Diagnostics ignored;
            const std::vector<cspm::Token> tokens = cspm::lex(text, place.source, ignored);
            for (std::size_t i = 0; i < tokens.size(); ++i) {
                if (tokens[i].kind != cspm::Tok::identifier) continue;
                const bool qualified =
                    (i > 0 && tokens[i - 1].text == "::") || (i + 1 < tokens.size() && tokens[i + 1].text == "::");
                if (!qualified) continue;
                for (const auto& form : forms)
                    if (tokens[i].text == in_form(form, old_name))
                        result.push_back(
                            {{place.source, place.begin + tokens[i].span.begin, place.begin + tokens[i].span.end},
                             in_form(form, new_name)});
            }
        }
    return result;
}

/// Returns the number of errors in the project's texts, including blocks, after these edits.
std::size_t errors_after(Project& project, std::vector<Edit> edits, diagnostics::Budget* budget) {
    std::ranges::stable_sort(edits, {}, [](const Edit& edit) { return edit.span.begin; });
    SourceManager sources;
    std::vector<SourceId> texts;
    for (const auto& [path, document] : project.documents()) {
        std::string text(project.sources().source_text(document->source));
        for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit)
            if (edit->span.source == document->source)
                text.replace(edit->span.begin, edit->span.end - edit->span.begin, edit->text);
        texts.push_back(sources.add(path, std::move(text)));
    }
    diagnostics::Diagnostics found;
    found.set_budget(budget);
    const auto model = frontend::load_texts(sources, texts, found);
    csp_emit::check_blocks(*model, sources, found);
    return found.error_count();
}

}  // namespace

std::optional<std::vector<Edit>> edits_of_blocks(Project& project, const std::string& old_name,
                                                 const std::string& new_name, const std::vector<Edit>& edits_of_model,
                                                 diagnostics::Budget* budget) {
    std::vector<Edit> edits = candidate_edits(project, old_name, new_name);
    if (edits.empty()) return edits;
    std::vector<Edit> all = edits_of_model;
    all.insert(all.end(), edits.begin(), edits.end());
    if (errors_after(project, all, budget) > errors_after(project, {}, budget)) return std::nullopt;
    return edits;
}

}  // namespace robochart::lsp
