// SPDX-License-Identifier: Apache-2.0
// Reads claims files, together with the models in their folders. See claim_texts.hpp.
#include "editors/server/claims/claim_texts.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "claims/checks/check.hpp"
#include "claims/syntax/lexer.hpp"
#include "claims/syntax/reader.hpp"

namespace robochart::lsp {
namespace fs = std::filesystem;

bool ClaimTexts::accepts(std::string_view uri, std::string_view language_id) const {
    return language_id == "robochart-claims" || uri.ends_with(".claims");
}

void ClaimTexts::drop_results(ClaimText& /*document*/) {
    for (const auto& [uri, document] : documents()) document->reading.reset();
}

void ClaimTexts::refresh_file(const std::string& /*uri*/) {
    for (const auto& [uri, document] : documents()) document->reading.reset();
    note_news();
}

const ClaimReading& ClaimTexts::reading_of(TextDocument& document) {
    std::unique_ptr<ClaimReading>& known = text_of(document).reading;
    if (known) return *known;
    auto reading = std::make_unique<ClaimReading>();
    reading->findings.set_budget(session_.budget);
    reading->file =
        std::make_shared<const claims::ClaimFile>(claims::read(document.sources, document.source, reading->findings));
    reading->models = models_.find(document.path, session_.budget);
    if (reading->models != nullptr && reading->findings.ok()) resolve(document, *reading);
    known = std::move(reading);
    return *known;
}

/// Resolves the text together with the other claims files of its folder. Open texts override files on disk. Only
/// findings about this text are reported.
void ClaimTexts::resolve(const TextDocument& document, ClaimReading& reading) {
    SourceManager& sources = document.sources;
    std::vector<std::shared_ptr<const claims::ClaimFile>> files{reading.file};
    diagnostics::Diagnostics ignored;
    ignored.set_budget(session_.budget);
    SourceManager texts;
    const SourceId own = texts.add(document.path, std::string(sources.source_text(document.source)));
    files.front() = std::make_shared<const claims::ClaimFile>(claims::read(texts, own, ignored));
    for (const std::string& path : files_in(fs::path(document.path).parent_path().string(), ".claims")) {
        if (path == document.path) continue;
        const TextDocument* const other = find(uri_of_path(path));
        std::string error;
        const auto source = other != nullptr
                                ? std::optional(texts.add(path, std::string(sources.source_text(other->source))))
                                : texts.load_file(path, error);
        if (source) files.push_back(std::make_shared<const claims::ClaimFile>(claims::read(texts, *source, ignored)));
    }
    diagnostics::Diagnostics findings;
    findings.set_budget(session_.budget);
    const claims::ClaimedModel model{reading.models->system, reading.models->packages, {}};
    (void)claims::check_claims(files, model, texts, findings);
    const auto here = [&](Span span) { return Span{document.source, span.begin, span.end}; };
    for (const diagnostics::Diagnostic& finding : findings.sorted_findings()) {
        if (finding.span.source != own) continue;
        diagnostics::Diagnostic& reported =
            reading.findings.report(*finding.rule, here(finding.span), finding.arguments);
        for (const diagnostics::FixIt& fix : finding.fixes)
            reported.fixes.push_back({here(fix.span), fix.replacement, fix.title});
    }
}

ClaimWord claim_word_at(const TextDocument& document, std::uint32_t offset) {
    diagnostics::Diagnostics ignored;
    for (const claims::Token& token :
         claims::lex(document.sources.source_text(document.source), document.source, ignored))
        if (token.kind == claims::Tok::word && token.span.begin <= offset && offset <= token.span.end)
            return {std::string(token.text), token.span};
    return {"", {document.source, offset, offset}};
}

}  // namespace robochart::lsp
