// SPDX-License-Identifier: Apache-2.0
#include "editors/server/plain/plain_texts.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "cpp_emit/ros2/read_mapping.hpp"
#include "csp_emit/swarm/read_swarm.hpp"
#include "simulation/scenario/read_scenario.hpp"

namespace robochart::lsp {

namespace {

constexpr std::array<std::string_view, 3> languages = {"scenario", "ros2", "swarm"};

/// Returns the language of a document; "" if it is not one of these languages.
std::string_view language_of(std::string_view uri, std::string_view language) {
    for (const std::string_view known : languages)
        if (language == known || (uri.ends_with(known) && uri.substr(0, uri.size() - known.size()).ends_with('.')))
            return known;
    return {};
}

/// Returns the findings about a text in the language of a document.
diagnostics::Diagnostics read(const TextDocument& document, const SourceManager& sources, SourceId source,
                              diagnostics::Budget* budget) {
    const std::string_view language = language_of(document.uri, document.language_id);
    diagnostics::Diagnostics found;
    found.set_budget(budget);
    if (language == "scenario") (void)simulation::read_scenario(sources, source, found);
    if (language == "ros2") (void)cpp_emit::ros2::read_mapping(sources, source, found);
    if (language == "swarm") (void)csp_emit::read_swarm(sources, source, found);
    return found;
}

/// Returns the quoted words of a message such as "'a', 'b' or 'c'".
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

bool PlainTexts::accepts(std::string_view uri, std::string_view language_id) const {
    return !language_of(uri, language_id).empty();
}

const diagnostics::Diagnostics& PlainTexts::diagnostics_of(TextDocument& document) {
    std::optional<diagnostics::Diagnostics>& known = text_of(document).findings;
    if (!known) known = read(document, document.sources, document.source, session_.budget);
    return *known;
}

std::vector<std::string> PlainTexts::words_at(const TextDocument& document, std::uint32_t offset) const {
    SourceManager texts;
    const std::string_view before = document.sources.source_text(document.source).substr(0, offset);
    const SourceId source = texts.add(document.path, std::string(before));
    const diagnostics::Diagnostics found = read(document, texts, source, session_.budget);
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
