// SPDX-License-Identifier: Apache-2.0
#include "editors/server/sleec/rule_texts.hpp"

#include <filesystem>
#include <map>

#include "base/diagnostics/files.hpp"
#include "claims/sleec/checks/check.hpp"
#include "claims/sleec/syntax/reader.hpp"

namespace robochart::lsp {

namespace fs = std::filesystem;

bool RuleTexts::accepts(std::string_view uri, std::string_view language_id) const {
    return language_id == "sleec" || uri.ends_with(".sleec");
}

const RuleReading& RuleTexts::reading_of(TextDocument& document) {
    std::unique_ptr<RuleReading>& known = text_of(document).reading;
    if (known) return *known;
    auto reading = std::make_unique<RuleReading>();
    reading->findings.set_budget(session_.budget);
    reading->file = sleec::read(document.sources, document.source, reading->findings);
    if (reading->findings.ok()) (void)sleec::check_rules(reading->file, reading->findings);
    known = std::move(reading);
    return *known;
}

std::vector<std::pair<std::string, std::string>> RuleTexts::names_in(const std::string& folder) {
    std::map<std::string, std::vector<std::string>> names;  // keyed by file name
    const auto add = [&](const std::string& path, const sleec::RuleFile& file) {
        std::vector<std::string>& of = names[fs::path(path).filename().string()];
        for (const sleec::Rule& rule : file.rules) of.push_back(rule.name.text);
    };
    for (const auto& [uri, document] : documents())
        if (fs::path(document->path).parent_path() == fs::path(folder)) add(document->path, reading_of(*document).file);
    if (folder.starts_with('/'))
        for (const std::string& path : diagnostics::files_below(folder, false).files) {
            if (!accepts(path, {}) || names.contains(fs::path(path).filename().string())) continue;
            SourceManager sources;
            std::string error;
            diagnostics::Diagnostics ignored;
            ignored.set_budget(session_.budget);
            if (const auto source = sources.load_file(path, error)) add(path, sleec::read(sources, *source, ignored));
        }
    std::vector<std::pair<std::string, std::string>> result;
    for (const auto& [file, rules] : names)
        for (const std::string& rule : rules) result.emplace_back(rule, file);
    return result;
}

}  // namespace robochart::lsp
