// SPDX-License-Identifier: Apache-2.0
// Finds foldable ranges: braces over several lines, comments, and consecutive imports.
#include "editors/server/features/models.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::lsp {

namespace {

using frontend::Token;

class Folds {
public:
    Folds(const SourceManager& sources, SourceId source) : positions_(sources, source, Encoding::utf8) {}

    /// Adds a range. If `keep_last` is true, the last line stays visible, because it contains the closing brace.
    void add(std::uint32_t begin, std::uint32_t end, const char* kind, bool keep_last) {
        const std::uint32_t first = line_at(begin);
        const std::uint32_t end_line = line_at(end);
        if (end_line <= first) return;
        const std::uint32_t last = end_line - (keep_last ? 1 : 0);
        if (last <= first) return;
        Json fold = Json::object({{"startLine", first}, {"endLine", last}});
        if (*kind != '\0') fold["kind"] = kind;
        result_.push_back(std::move(fold));
    }
    void fold_braces(const frontend::TokenStream& stream) {
        std::vector<std::uint32_t> open;
        for (const Token& token : stream.tokens) {
            if (token.is_word("{") || token.is_word("<{")) open.push_back(token.span.begin);
            if (token.is_word("}") && !open.empty()) {
                add(open.back(), token.span.begin, "", true);
                open.pop_back();
            }
            if (token.kind == frontend::TokenKind::csp_code) add(token.span.begin, token.span.end, "", true);
        }
    }
    /// Folds comments; comments on consecutive lines are folded together.
    void fold_comments(const std::vector<Span>& list) {
        for (std::size_t i = 0; i < list.size();) {
            std::size_t last = i;
            while (last + 1 < list.size() && line_at(list[last + 1].begin) == line_at(list[last].end) + 1) ++last;
            add(list[i].begin, list[last].end, "comment", false);
            i = last + 1;
        }
    }
    void fold_imports(const frontend::File& file) {
        if (!file.imports.empty()) add(file.imports.front().span.begin, file.imports.back().span.end, "imports", false);
    }
    [[nodiscard]] Json take_folds() { return std::move(result_); }

private:
    [[nodiscard]] std::uint32_t line_at(std::uint32_t offset) const { return positions_.line(offset); }

    PositionTable positions_;
    Json result_ = Json::array();
};

}  // namespace

Json Models::folding_ranges(const Request& request) {
    const Target target = target_of(request);
    const SourceManager& sources = target.project.sources();
    diagnostics::Diagnostics ignored;
    const frontend::TokenStream stream =
        frontend::tokenize(sources, target.document.source, target.document.is_assertions, ignored);
    Folds folds(sources, target.document.source);
    folds.fold_braces(stream);
    folds.fold_comments(stream.comments);
    folds.fold_imports(target.project.tree_of(target.document));
    return folds.take_folds();
}

}  // namespace robochart::lsp
