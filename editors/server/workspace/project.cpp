// SPDX-License-Identifier: Apache-2.0
// Keeps the texts, trees and the resolved model of one project up to date.
#include <algorithm>
#include <filesystem>

#include "csp_emit/blocks/check_blocks.hpp"
#include "editors/server/protocol/uri.hpp"
#include "editors/server/workspace/workspace.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::lsp {

namespace fs = std::filesystem;

namespace {

std::string read_contents(const std::string& path, std::string& error) {
    SourceManager reader;
    const auto id = reader.load_file(path, error);
    return id ? std::string(reader.source_text(*id)) : std::string();
}

}  // namespace

Document* Project::find(const std::string& path) {
    const auto found = documents_.find(path);
    return found != documents_.end() ? found->second.get() : nullptr;
}

Document* Project::find(SourceId source) {
    for (const auto& [path, document] : documents_)
        if (document->source == source) return document.get();
    return nullptr;
}

bool Project::has_open() const {
    return std::ranges::any_of(documents_, [](const auto& entry) { return entry.second->open; });
}

Document& Project::add(const std::string& path) {
    auto document = std::make_unique<Document>(sources_, uri_of_path(path));
    document->path = path;
    document->open = false;
    document->is_assertions = frontend::is_assertion_path(path);
    const auto known = ids_.find(path);
    document->source = known != ids_.end() ? known->second : sources_.add(path, {});
    ids_[path] = document->source;
    return *(documents_[path] = std::move(document));
}

Document& Project::open_document(const std::string& path, std::string uri, std::string text) {
    Document* document = find(path);
    if (document == nullptr) document = &add(path);
    document->uri = std::move(uri);
    document->open = true;
    document->pulled.clear();
    news_ = true;
    change(*document, std::move(text));
    return *document;
}

void Project::change(Document& document, std::string text) {
    if (!document.stale && sources_.source_text(document.source) == text) return;
    current_ = false;
    occurrences_.reset();
    block_findings_.reset();
    sources_.replace(document.source, std::move(text));
    document.stale = true;
}

void Project::close(Document& document) {
    document.open = false;
    document.version.reset();
    news_ = true;
    refresh_file(document.path);
}

void Project::refresh_file(const std::string& path) {
    Document* document = find(path);
    if (document != nullptr && document->open) return;
    std::error_code code;
    if (folder_.empty() || !fs::is_regular_file(path, code)) {
        if (document != nullptr) drop_results(*document);
        return;
    }
    std::string error;
    std::string text = read_contents(path, error);
    if (document == nullptr) document = &add(path);
    change(*document, std::move(text));
    if (error.empty()) return;
    document->stale = true;
    parse(*document);
    document->findings.report(frontend::syntax::unreadable, {document->source, 0, 0}, {path, error});
}

void Project::drop_results(Document& document) {
    current_ = false;
    occurrences_.reset();
    block_findings_.reset();
    resolution_.forget_results();
    std::erase_if(model_.files, [&](const auto& file) { return file.get() == document.tree; });
    sources_.replace(document.source, {});
    documents_.erase(std::string(document.path));
}

/// Parses a document and replaces its old tree. Files stay sorted by path, as when a project is loaded.
void Project::parse(Document& document) {
    document.findings = {};
    document.findings.set_budget(budget_);
    auto tree = frontend::parse(sources_, document.source, document.is_assertions, document.findings);
    frontend::File* made = tree.get();
    const auto old = std::ranges::find_if(model_.files, [&](const auto& file) { return file.get() == document.tree; });
    if (old != model_.files.end()) {
        resolution_.replace(*old, std::move(tree));
        made = old->get();
    } else {
        resolution_.forget_results();
        const auto behind = std::ranges::find_if(model_.files, [&](const auto& file) {
            return file->is_library || fs::path(sources_.path(file->source)) > fs::path(document.path);
        });
        model_.files.insert(behind, std::move(tree));
    }
    document.tree = made;
    document.stale = false;
}

void Project::update() {
    if (current_) return;
    for (const auto& [path, document] : documents_)
        if (document->stale) parse(*document);
    findings_ = {};
    findings_.set_budget(budget_);
    frontend::update_toolkits(sources_, model_, findings_);
    try {
        resolution_.resolve(model_, findings_);
    } catch (const diagnostics::LimitReached&) {
        resolution_.forget_results();
        throw;
    }
    current_ = true;
    news_ = true;
}

bool Project::take_news() {
    (void)block_findings();
    return std::exchange(news_, false);
}

const frontend::Model& Project::current_model() {
    update();
    return model_;
}

const diagnostics::Diagnostics& Project::current_findings() {
    update();
    return findings_;
}

const diagnostics::Diagnostics& Project::block_findings() {
    update();
    if (!block_findings_) {
        diagnostics::Diagnostics found;
        found.set_budget(budget_);
        csp_emit::check_blocks(model_, sources_, found);
        block_findings_ = std::move(found);
    }
    return *block_findings_;
}

const std::vector<frontend::Occurrence>& Project::current_occurrences() {
    update();
    if (!occurrences_) occurrences_ = frontend::find_occurrences(model_);
    return *occurrences_;
}

const frontend::Occurrence* Project::occurrence_at(SourceId source, std::uint32_t offset) {
    const auto& all = current_occurrences();
    const auto after = std::partition_point(all.begin(), all.end(), [&](const frontend::Occurrence& o) {
        return o.span.source < source || (o.span.source == source && o.span.begin <= offset);
    });
    if (after == all.begin()) return nullptr;
    const frontend::Occurrence& found = *(after - 1);
    return found.span.source == source && offset <= found.span.end ? &found : nullptr;
}

const frontend::File& Project::tree_of(const Document& document) {
    update();
    return *document.tree;
}

}  // namespace robochart::lsp
