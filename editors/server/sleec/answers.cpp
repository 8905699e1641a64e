// SPDX-License-Identifier: Apache-2.0
// Reports the findings about rule files, and answers requests.
#include "claims/sleec/syntax/format.hpp"
#include "editors/server/documents/text_difference.hpp"
#include "editors/server/sleec/rule_completion.hpp"
#include "editors/server/sleec/rule_names.hpp"

namespace robochart::lsp {

Json RuleTexts::findings_in(TextDocument& document) {
    return list_findings(document, reading_of(document).findings);
}

Json RuleTexts::hover(const Request& request) {
    const RuleReading& reading = reading_of(request.document);
    const std::optional<RuleName> name = rule_name_at(request.document, reading.file, request.offset);
    Hover hover;
    if (name) hover = {about_rule_name(reading.file, *name, session_.client.markdown), name->span};
    return hover_answer(request, std::move(hover), reading.findings.sorted_findings());
}

Json RuleTexts::definition(const Request& request) {
    const std::optional<RuleName> name =
        rule_name_at(request.document, reading_of(request.document).file, request.offset);
    if (!name || !name->declared.is_known()) return {};
    return Json::array({location_in(request.document, name->declared)});
}

Json RuleTexts::document_symbols(const Request& request) {
    return rule_outline(request.document, reading_of(request.document).file, session_.client);
}

Json RuleTexts::completion(const Request& request) {
    return rule_completion(request.document, reading_of(request.document).file,
                           models_.find(request.document.path, session_.budget), request.offset,
                           session_.client.encoding);
}

Json RuleTexts::formatting(const Request& request) {
    const TextDocument& document = request.document;
    diagnostics::Diagnostics ignored;
    return formatting_edits(document.sources, document.source,
                            sleec::format(document.sources, document.source, ignored), session_.client.encoding);
}

}  // namespace robochart::lsp
