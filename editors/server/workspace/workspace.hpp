// SPDX-License-Identifier: Apache-2.0
// Manages the projects that an editor has open: folders, their files on disk, and the open texts that override these
// files.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "editors/server/documents/language.hpp"
#include "frontend/project/incremental.hpp"
#include "frontend/project/occurrences.hpp"
#include "frontend/syntax/ast.hpp"
#include "frontend/syntax/parse.hpp"

namespace robochart::lsp {

/// One file of a project.
struct Document : TextDocument {
    using TextDocument::TextDocument;
    bool is_assertions = false;
    bool stale = true;                  ///< true if the text changed since it was parsed
    frontend::File* tree = nullptr;     ///< the tree in the project's model, after parsing
    diagnostics::Diagnostics findings;  ///< the findings of the parser
};

/// The files of one project (language reference 1.3: folder = project), with the analysis results. Access to the model
/// updates it: only changed files are read and parsed again, and only affected parts are resolved again.
class Project {
public:
    /// If the folder name is empty, the texts are not on disk. Updates of the model poll the budget, if given. If the
    /// budget ends an update, the next access repeats it.
    explicit Project(std::string folder, diagnostics::Budget* budget = nullptr)
        : folder_(std::move(folder)), budget_(budget) {}

    [[nodiscard]] const std::string& folder() const { return folder_; }
    [[nodiscard]] Document* find(const std::string& path);
    [[nodiscard]] Document* find(SourceId source);
    [[nodiscard]] const std::map<std::string, std::unique_ptr<Document>>& documents() const { return documents_; }
    [[nodiscard]] bool has_open() const;
    [[nodiscard]] bool empty() const { return documents_.empty(); }

    /// Sets the editor's text of a file; adds the file if it is new.
    Document& open_document(const std::string& path, std::string uri, std::string text);
    void change(Document& document, std::string text);
    /// Uses the text on disk again. A file that is not on disk is removed from the project.
    void close(Document& document);
    /// Reads a file that is not open from disk again.
    void refresh_file(const std::string& path);

    [[nodiscard]] const SourceManager& sources() const { return sources_; }
    [[nodiscard]] const frontend::Model& current_model();
    /// Returns the findings about names, types and rules. Parse errors are stored in the documents.
    [[nodiscard]] const diagnostics::Diagnostics& current_findings();
    /// Returns the findings about CSP blocks.
    [[nodiscard]] const diagnostics::Diagnostics& block_findings();
    /// Returns all occurrences of names, sorted by place.
    [[nodiscard]] const std::vector<frontend::Occurrence>& current_occurrences();
    /// Returns the name at or directly before an offset; null if there is none.
    [[nodiscard]] const frontend::Occurrence* occurrence_at(SourceId source, std::uint32_t offset);
    /// Returns the current tree of a document.
    [[nodiscard]] const frontend::File& tree_of(const Document& document);

    /// True if something changed since the last call.
    [[nodiscard]] bool take_news();

private:
    Document& add(const std::string& path);
    void drop_results(Document& document);
    void parse(Document& document);
    void update();

    std::string folder_;
    diagnostics::Budget* budget_;
    SourceManager sources_;
    std::map<std::string, std::unique_ptr<Document>> documents_;
    std::map<std::string, SourceId> ids_;  ///< the id of every path seen so far
    frontend::Model model_;
    frontend::Resolution resolution_;
    diagnostics::Diagnostics findings_;
    std::optional<std::vector<frontend::Occurrence>> occurrences_;
    std::optional<diagnostics::Diagnostics> block_findings_;
    bool current_ = false;  ///< true if model_ and findings_ belong to the current texts
    bool news_ = false;
};

/// All projects.
class Workspace {
public:
    explicit Workspace(diagnostics::Budget* budget = nullptr) : budget_(budget) {}

    void add_folder(const std::string& path);
    void remove_folder(const std::string& path);

    struct Place {
        Project* project = nullptr;
        Document* document = nullptr;
        explicit operator bool() const { return document != nullptr; }
    };
    [[nodiscard]] Place find(std::string_view uri);
    Place open_document(const std::string& uri, std::string text);
    void close(const std::string& uri);
    void refresh_file(const std::string& uri);
    [[nodiscard]] const std::vector<std::unique_ptr<Project>>& projects() const { return projects_; }

private:
    /// Returns the workspace folder that contains a path, or the innermost if there are several; "" if there is none.
    [[nodiscard]] std::string folder_around(const std::string& path) const;
    [[nodiscard]] std::string root_of(const std::string& path) const;
    Project& project_at(const std::string& root);
    void rebuild_projects();

    diagnostics::Budget* budget_;
    std::vector<std::string> folders_;
    std::vector<std::unique_ptr<Project>> projects_;
};

}  // namespace robochart::lsp
