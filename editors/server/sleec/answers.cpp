// SPDX-License-Identifier: Apache-2.0
#include "editors/server/sleec/answers.hpp"

#include <fmt/format.h>

#include "editors/server/protocol/findings.hpp"
#include "editors/server/sleec/rule_completion.hpp"
#include "editors/server/sleec/rule_names.hpp"
#include "editors/server/workspace/text_difference.hpp"
#include "sleec/syntax/format.hpp"

namespace robochart::lsp {

namespace {

/// The findings of all open files by URI.
std::map<std::string, Json> rule_findings(const Session& session, RuleTexts& rules) {
    std::map<std::string, Json> result;
    for (const auto& [uri, document] : rules.all_documents()) {
        const Locate locate = [&, &at = uri, &text = *document](Span span) -> Json {
            if (!span.is_known()) return {};
            return Json::object({{"uri", at}, {"range", lsp_range(text.texts, span, session.client.encoding)}});
        };
        Json& list = result[uri] = Json::array();
        for (const diagnostics::Diagnostic& finding : rules.reading_of(*document).findings.sorted_findings())
            if (finding.span.is_known())
                list.push_back(lsp_diagnostic(document->texts, finding, session.client.encoding, locate));
    }
    return result;
}

Json rule_hover(const Session& session, RuleTexts& rules, RuleText& document, std::uint32_t offset) {
    const RuleReading& reading = rules.reading_of(document);
    const bool markdown = session.client.markdown;
    const std::optional<RuleName> name = rule_name_at(document, reading.file, offset);
    std::string text = name ? about_rule_name(reading.file, *name, markdown) : "";
    const std::string why = explain_findings(reading.findings.sorted_findings(), offset, markdown);
    if (!text.empty() && !why.empty()) text += markdown ? "\n\n---\n" : "\n\n";
    text += why;
    return hover_answer(document.texts, std::move(text), name ? name->span : Span(), session.client.encoding, markdown);
}

Json rule_definition(const Session& session, RuleTexts& rules, RuleText& document, std::uint32_t offset) {
    const std::optional<RuleName> name = rule_name_at(document, rules.reading_of(document).file, offset);
    if (!name || !name->declared.is_known()) return {};
    return Json::array({Json::object(
        {{"uri", document.uri}, {"range", lsp_range(document.texts, name->declared, session.client.encoding)}})});
}

Json format_answer(const Session& session, const RuleText& document) {
    diagnostics::Diagnostics ignored;
    const auto text = sleec::format(document.texts, document.source, ignored);
    if (!text) throw Refusal(ErrorCode::request_failed, "not formatted: the text has syntax errors");
    return text_edits(document.texts, document.source, *text, session.client.encoding);
}

std::string_view uri_of(View params) {
    return params["textDocument"]["uri"].text();
}

}  // namespace

bool notify_rules(const Session& session, RuleTexts& rules, std::string_view method, View params) {
    const View given = params["textDocument"];
    const std::string& uri = given["uri"].text();
    if (method == "textDocument/didOpen") {
        if (uri.empty() || !is_rules(uri, given["languageId"].text())) return false;
        take_opened(params, [&](const std::string& at, std::string text) -> OpenText& {
            return rules.open_document(at, std::move(text));
        });
        return true;
    }
    RuleText* const known = rules.find(uri);
    if (known == nullptr) return false;
    if (method == "textDocument/didChange")
        take_changes(*known, params, session.client.encoding,
                     [&](std::string text) { rules.change(*known, std::move(text)); });
    if (method == "textDocument/didClose") rules.close(uri);
    return true;
}

bool asks_for_rules(RuleTexts& rules, View params) {
    return rules.find(uri_of(params)) != nullptr || is_rules(uri_of(params));
}

Json answer_for_rules(const Session& session, RuleTexts& rules, std::string_view method, View params) {
    RuleText* const document = rules.find(uri_of(params));
    if (document == nullptr)
        throw Refusal(ErrorCode::invalid_params, fmt::format("no such document: {}", uri_of(params)));
    const std::uint32_t offset =
        offset_of(document->texts, document->source, params["position"], session.client.encoding);
    if (method == "textDocument/diagnostic") return pulled_findings(*document, rule_findings(session, rules));
    if (method == "textDocument/documentSymbol")
        return rule_outline(*document, rules.reading_of(*document).file, session.client);
    if (method == "textDocument/hover") return rule_hover(session, rules, *document, offset);
    if (method == "textDocument/definition" || method == "textDocument/declaration")
        return rule_definition(session, rules, *document, offset);
    if (method == "textDocument/completion")
        return rule_completion(*document, rules.reading_of(*document).file, offset, session.client.encoding);
    if (method == "textDocument/formatting") return format_answer(session, *document);
    return nullptr;
}

void publish_rules(Session& session, RuleTexts& rules) {
    if (!rules.has_news()) return;
    rules.published.send_findings(session, rule_findings(session, rules),
                                  [&](const std::string& uri) { return rules.find(uri); });
    rules.settle_news();
}

}  // namespace robochart::lsp
