// SPDX-License-Identifier: Apache-2.0
// Assigns files to projects. Each folder of the workspace is a project, and so is each subfolder with a `.project` file
// (as written by Eclipse and RoboTool). A file outside the workspace forms a project with the files in its folder.
#include "editors/server/workspace/workspace.hpp"

#include <algorithm>
#include <filesystem>

#include "editors/server/protocol/uri.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/dialect.hpp"

namespace robochart::lsp {

namespace fs = std::filesystem;

namespace {

bool is_below(const std::string& path, const std::string& folder) {
    if (folder == "/") return path.starts_with("/");
    return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

std::string plain_folder(const std::string& path) {
    std::string folder = fs::path(path).lexically_normal().string();
    while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
    return folder;
}

}  // namespace

void Workspace::add_folder(const std::string& path) {
    const std::string folder = plain_folder(path);
    if (std::ranges::find(folders_, folder) != folders_.end()) return;
    folders_.push_back(folder);
    rebuild_projects();
}

void Workspace::remove_folder(const std::string& path) {
    if (std::erase(folders_, plain_folder(path)) > 0) rebuild_projects();
}

/// Assigns all files again, without losing open texts.
void Workspace::rebuild_projects() {
    const std::vector<std::unique_ptr<Project>> before = std::exchange(projects_, {});
    for (const std::string& folder : folders_)
        for (const std::string& path : frontend::project_files(folder, true))
            project_at(root_of(path)).refresh_file(path);
    for (const auto& project : before)
        for (const auto& [path, document] : project->documents())
            if (document->open)
                open_document(document->uri, std::string(project->sources().source_text(document->source)))
                    .document->version = document->version;
}

Workspace::Place Workspace::find(std::string_view uri) {
    const std::string path = path_of_uri(uri);
    for (const auto& project : projects_)
        if (Document* document = project->find(path)) return {project.get(), document};
    return {};
}

std::string Workspace::folder_around(const std::string& path) const {
    std::string best;
    for (const std::string& folder : folders_)
        if (is_below(path, folder) && folder.size() >= best.size()) best = folder;
    return best;
}

std::string Workspace::root_of(const std::string& path) const {
    if (!path.starts_with("/")) return {};
    const std::string folder = folder_around(path);
    const std::string own = plain_folder(fs::path(path).parent_path().string());
    if (folder.empty()) return own;
    std::error_code code;
    for (fs::path at = own; at.string().size() > folder.size(); at = at.parent_path())
        if (fs::exists(at / ".project", code)) return at.string();
    return folder;
}

Project& Workspace::project_at(const std::string& root) {
    for (const auto& project : projects_)
        if (project->folder() == root && !root.empty()) return *project;
    projects_.push_back(std::make_unique<Project>(root, budget_));
    return *projects_.back();
}

Workspace::Place Workspace::open_document(const std::string& uri, std::string text) {
    const std::string path = path_of_uri(uri);
    const Place known = find(uri);
    if (known) return {known.project, &known.project->open_document(path, uri, std::move(text))};
    const std::string root = root_of(path);
    Project& project = project_at(root);
    if (project.empty() && !root.empty() && folder_around(path).empty())
        for (const std::string& beside : frontend::project_files(root, false)) project.refresh_file(beside);
    return {&project, &project.open_document(path, uri, std::move(text))};
}

void Workspace::close(const std::string& uri) {
    const Place place = find(uri);
    if (!place) return;
    place.project->close(*place.document);
    // A project outside the workspace exists only for its open files.
    const bool listed = !folder_around(place.project->folder() + "/.").empty();
    if (listed || place.project->has_open()) return;
    std::erase_if(projects_, [&](const auto& project) { return project.get() == place.project; });
}

void Workspace::refresh_file(const std::string& uri) {
    const std::string path = path_of_uri(uri);
    if (const Place known = find(uri)) return known.project->refresh_file(path);
    if (!frontend::is_model_path(path) && !frontend::is_assertion_path(path)) return;
    const std::string root = root_of(path);
    const bool belongs = !folder_around(path).empty() || std::ranges::any_of(projects_, [&](const auto& project) {
        return project->folder() == root && !root.empty();
    });
    if (belongs) project_at(root).refresh_file(path);
}

}  // namespace robochart::lsp
