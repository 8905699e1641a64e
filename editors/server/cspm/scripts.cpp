// SPDX-License-Identifier: Apache-2.0
#include "editors/server/cspm/scripts.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "checker/cspm/syntax/reader.hpp"
#include "editors/server/protocol/uri.hpp"

namespace robochart::lsp {

namespace fs = std::filesystem;

namespace {

/// Returns a unique name for a file, with links resolved. A path that does not exist on disk is returned unchanged.
std::string file_at(const std::string& path) {
    if (!path.starts_with('/')) return path;
    std::error_code code;
    const fs::path file = fs::weakly_canonical(path, code);
    return code || file.empty() ? fs::path(path).lexically_normal().string() : file.string();
}

}  // namespace

ScriptDocument::ScriptDocument(SourceManager& in, const std::string& at) : TextDocument(in, at), file(file_at(path)) {}

bool Scripts::accepts(std::string_view uri, std::string_view language_id) const {
    constexpr std::array<std::string_view, 3> suffixes = {".csp", ".cspm", ".fdr3"};
    return language_id == "cspm" ||
           std::ranges::any_of(suffixes, [&](std::string_view suffix) { return uri.ends_with(suffix); });
}

void Scripts::refresh_file(const std::string& uri) {
    if (!accepts(uri, {})) return;
    const std::string file = file_of(path_of_uri(uri));
    if (find_open(file) == nullptr) forget_readings(file);
}

/// Discards readings that used this file.
void Scripts::forget_readings(const std::string& file) {
    note_news();
    for (const auto& [uri, document] : documents())
        if (document->file == file || (document->reading && document->reading->searched.contains(file)))
            document->reading.reset();
}

const ScriptDocument* Scripts::find_open(const std::string& file) const {
    for (const auto& [uri, document] : documents())
        if (document->file == file) return document.get();
    return nullptr;
}

/// Returns the file recorded for an open document with this path. Links may have changed since then, but the document
/// keeps its file.
std::string Scripts::file_of(const std::string& path) const {
    for (const auto& [uri, document] : documents())
        if (document->path == path) return document->file;
    return file_at(path);
}

std::optional<SourceId> Scripts::load_text(ScriptReading& reading, const std::string& path, std::string& error) {
    const std::string file = file_of(path);
    reading.searched.insert(file);
    const ScriptDocument* document = find_open(file);
    std::optional<SourceId> source;
    if (document != nullptr)
        source = reading.sources.add(path, std::string(document->sources.source_text(document->source)));
    else if (path.starts_with('/'))
        source = reading.sources.load_file(path, error);
    else
        error = "the text that includes it lies in no folder";
    if (!source) return std::nullopt;
    reading.at.emplace(file, *source);
    reading.in.emplace(*source, file);
    return source;
}

void Scripts::read(ScriptDocument& document) {
    auto reading = std::make_unique<ScriptReading>();
    reading->findings.set_budget(session_.budget);
    reading->script =
        cspm::read_file(reading->sources, document.path, reading->findings,
                        [&](const std::string& path, std::string& error) { return load_text(*reading, path, error); });
    document.reading = std::move(reading);
}

/// True if another open script includes the document. If open files include each other, the first file is the main file
/// of the script.
bool Scripts::is_part_of_another(const ScriptDocument& document) const {
    return std::ranges::any_of(documents(), [&](const auto& entry) {
        const ScriptDocument& other = *entry.second;
        if (&other == &document || !other.reading->at.contains(document.file)) return false;
        return !document.reading->at.contains(other.file) || other.uri < document.uri;
    });
}

std::vector<const ScriptReading*> Scripts::current_readings() {
    for (const auto& [uri, document] : documents())
        if (!document->reading) read(*document);
    std::vector<const ScriptReading*> result;
    for (const auto& [uri, document] : documents()) {
        if (is_part_of_another(*document)) continue;
        ScriptReading& reading = *document->reading;
        if (!reading.typed && reading.findings.ok()) {
            diagnostics::Diagnostics of_types;
            of_types.set_budget(session_.budget);
            (void)cspm::check_types(reading.script, of_types, &reading.names);
            reading.findings.add(of_types);
        }
        reading.typed = true;
        result.push_back(&reading);
    }
    return result;
}

const ScriptReading& Scripts::reading_of(const ScriptDocument& document) {
    for (const ScriptReading* reading : current_readings())
        if (reading->at.contains(document.file)) return *reading;
    return *document.reading;
}

std::string Scripts::uri_of(const ScriptReading& reading, SourceId source) const {
    const auto file = reading.in.find(source);
    if (file == reading.in.end()) return {};
    const ScriptDocument* document = find_open(file->second);
    const std::string& path = reading.sources.path(source);
    return document != nullptr ? document->uri : uri_of_path(fs::path(path).lexically_normal().string());
}

}  // namespace robochart::lsp
