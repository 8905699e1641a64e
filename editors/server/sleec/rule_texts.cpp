// SPDX-License-Identifier: Apache-2.0
#include "editors/server/sleec/rule_texts.hpp"

#include <filesystem>
#include <utility>

#include "base/diagnostics/files.hpp"
#include "editors/server/protocol/uri.hpp"
#include "sleec/checks/check.hpp"
#include "sleec/syntax/reader.hpp"

namespace robochart::lsp {

namespace fs = std::filesystem;

bool is_rules(std::string_view uri, std::string_view language) {
    return language == "sleec" || uri.ends_with(".sleec");
}

RuleText* RuleTexts::find(std::string_view uri) {
    const auto found = documents_.find(uri);
    return found != documents_.end() ? found->second.get() : nullptr;
}

RuleText& RuleTexts::open_document(const std::string& uri, std::string text) {
    std::unique_ptr<RuleText>& document = documents_[uri];
    document = std::make_unique<RuleText>();
    document->uri = uri;
    document->path = path_of_uri(uri);
    document->source = document->texts.add(document->path, std::move(text));
    news_ = true;
    return *document;
}

void RuleTexts::change(RuleText& document, std::string text) {
    if (document.texts.source_text(document.source) == text) return;
    document.texts.replace(document.source, std::move(text));
    document.reading.reset();
    news_ = true;
}

void RuleTexts::close(const std::string& uri) {
    news_ = documents_.erase(uri) > 0 || news_;
}

const RuleReading& RuleTexts::reading_of(RuleText& document) {
    if (document.reading) return *document.reading;
    auto reading = std::make_unique<RuleReading>();
    reading->findings.set_budget(budget_);
    reading->file = sleec::read(document.texts, document.source, reading->findings);
    if (reading->findings.ok()) (void)sleec::check_rules(reading->file, reading->findings);
    document.reading = std::move(reading);
    return *document.reading;
}

std::vector<std::pair<std::string, std::string>> RuleTexts::names_in(const std::string& folder) {
    std::map<std::string, std::vector<std::string>> names;  // keyed by file name
    const auto add = [&](const std::string& path, const sleec::RuleFile& file) {
        std::vector<std::string>& of = names[fs::path(path).filename().string()];
        for (const sleec::Rule& rule : file.rules) of.push_back(rule.name.text);
    };
    for (const auto& [uri, document] : documents_)
        if (fs::path(document->path).parent_path() == fs::path(folder)) add(document->path, reading_of(*document).file);
    if (folder.starts_with('/'))
        for (const std::string& path : diagnostics::files_below(folder, false).files) {
            if (!is_rules(path) || names.contains(fs::path(path).filename().string())) continue;
            SourceManager sources;
            std::string error;
            diagnostics::Diagnostics ignored;
            ignored.set_budget(budget_);
            if (const auto source = sources.load_file(path, error)) add(path, sleec::read(sources, *source, ignored));
        }
    std::vector<std::pair<std::string, std::string>> result;
    for (const auto& [file, rules] : names)
        for (const std::string& rule : rules) result.emplace_back(rule, file);
    return result;
}

}  // namespace robochart::lsp
