// SPDX-License-Identifier: Apache-2.0
#include "editors/server/plain/plain_texts.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "cpp_emit/ros2/read_mapping.hpp"
#include "csp_emit/swarm/read_swarm.hpp"
#include "editors/server/protocol/uri.hpp"
#include "simulation/scenario/read_scenario.hpp"

namespace robochart::lsp {

namespace {

constexpr std::array<std::string_view, 3> languages = {"scenario", "ros2", "swarm"};

void read(std::string_view language, const SourceManager& sources, SourceId source, diagnostics::Diagnostics& out) {
    if (language == "scenario") (void)simulation::read_scenario(sources, source, out);
    if (language == "ros2") (void)cpp_emit::ros2::read_mapping(sources, source, out);
    if (language == "swarm") (void)csp_emit::read_swarm(sources, source, out);
}

/// The language of a document; "" if it is not one of these languages.
std::string_view language_of(std::string_view uri, std::string_view language) {
    for (const std::string_view known : languages)
        if (language == known || (uri.ends_with(known) && uri.substr(0, uri.size() - known.size()).ends_with('.')))
            return known;
    return {};
}

/// The quoted words of a message: 'a', 'b' or 'c'.
std::vector<std::string> quoted_words(std::string_view text) {
    std::vector<std::string> result;
    for (std::size_t at = text.find('\''); at != std::string_view::npos; at = text.find('\'', at)) {
        const std::size_t end = text.find('\'', at + 1);
        if (end == std::string_view::npos) break;
        result.emplace_back(text.substr(at + 1, end - at - 1));
        at = end + 1;
    }
    return result;
}

}  // namespace

bool is_plain(std::string_view uri, std::string_view language) {
    return !language_of(uri, language).empty();
}

PlainText* PlainTexts::find(std::string_view uri) {
    const auto found = documents_.find(uri);
    return found != documents_.end() ? found->second.get() : nullptr;
}

PlainText& PlainTexts::open_document(const std::string& uri, std::string_view language, std::string text) {
    std::unique_ptr<PlainText>& document = documents_[uri];
    document = std::make_unique<PlainText>();
    document->uri = uri;
    document->path = path_of_uri(uri);
    document->language = language_of(uri, language);
    document->source = document->texts.add(document->path, std::move(text));
    news_ = true;
    return *document;
}

void PlainTexts::change(PlainText& document, std::string text) {
    if (document.texts.source_text(document.source) == text) return;
    document.texts.replace(document.source, std::move(text));
    document.findings.reset();
    news_ = true;
}

void PlainTexts::close(const std::string& uri) {
    news_ = documents_.erase(uri) > 0 || news_;
}

const diagnostics::Diagnostics& PlainTexts::findings_in(PlainText& document) {
    if (!document.findings) {
        diagnostics::Diagnostics found;
        found.set_budget(budget_);
        read(document.language, document.texts, document.source, found);
        document.findings = std::move(found);
    }
    return *document.findings;
}

std::vector<std::string> PlainTexts::words_at(const PlainText& document, std::uint32_t offset) const {
    SourceManager texts;
    const std::string_view before = document.texts.source_text(document.source).substr(0, offset);
    const SourceId source = texts.add(document.path, std::string(before));
    diagnostics::Diagnostics found;
    found.set_budget(budget_);
    read(document.language, texts, source, found);
    std::vector<std::string> result;
    for (const diagnostics::Diagnostic& finding : found.sorted_findings())
        if (!finding.arguments.empty() && finding.span.is_known() && finding.span.begin >= before.size())
            for (std::string& word : quoted_words(finding.arguments.front())) result.push_back(std::move(word));
    std::erase_if(result, [](const std::string& word) {
        return word.empty() ||
               !((word.front() >= 'a' && word.front() <= 'z') || (word.front() >= 'A' && word.front() <= 'Z'));
    });
    return result;
}

}  // namespace robochart::lsp
