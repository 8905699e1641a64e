// The projects an editor has open: folders, their files on disk and the texts that override them.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "frontend/project/incremental.hpp"
#include "frontend/project/occurrences.hpp"
#include "frontend/syntax/ast.hpp"
#include "frontend/syntax/parse.hpp"
#include "lsp/protocol/positions.hpp"

namespace robochart::lsp {

/// One file of a project.
struct Document {
    std::string path;
    std::string uri;  ///< as the editor writes it
    SourceId source = SourceId::none;
    bool is_assertions = false;
    bool open = false;  ///< the editor owns the text
    std::optional<std::int64_t> version;
    bool stale = true;                  ///< the text changed since it was parsed
    frontend::File* tree = nullptr;     ///< in the project's model, once parsed
    diagnostics::Diagnostics findings;  ///< of reading alone
    std::string published;              ///< the diagnostics last sent
    std::string pulled;                 ///< the diagnostics last asked for, while it is open
};

/// Files that see each other (language reference 1.3: folder = project), with what is known about them. Asking for the
/// model brings it up to date: only changed files are read and parsed again, and what they
/// touch is resolved anew.
class Project {
public:
    /// An empty folder name stands for texts without a place on disk. What brings the model up to date polls the
    /// budget, if there is one; ended by it, it begins anew when it is asked again.
    explicit Project(std::string folder, diagnostics::Budget* budget = nullptr)
        : folder_(std::move(folder)), budget_(budget) {}

    [[nodiscard]] const std::string& folder() const { return folder_; }
    [[nodiscard]] Document* find(const std::string& path);
    [[nodiscard]] Document* find(SourceId source);
    [[nodiscard]] const std::map<std::string, std::unique_ptr<Document>>& documents() const { return documents_; }
    [[nodiscard]] bool has_open() const;
    [[nodiscard]] bool empty() const { return documents_.empty(); }

    /// The editor's text for a file; adds the file if it is new.
    Document& open(const std::string& path, std::string uri, std::string text);
    void change(Document& document, std::string text);
    /// The file on disk counts again; one that is not there leaves the project.
    void close(Document& document);
    /// Looks at the disk again for a file that is not open.
    void refresh(const std::string& path);

    [[nodiscard]] const SourceManager& sources() const { return sources_; }
    [[nodiscard]] const frontend::Model& model();
    /// Of names, types and rules; those of reading are with the documents.
    [[nodiscard]] const diagnostics::Diagnostics& findings();
    /// Of CSP blocks.
    [[nodiscard]] const diagnostics::Diagnostics& block_findings();
    /// All names by place.
    [[nodiscard]] const std::vector<frontend::Occurrence>& occurrences();
    /// The name at or directly before an offset; null if there is none.
    [[nodiscard]] const frontend::Occurrence* occurrence_at(SourceId source, std::uint32_t offset);
    /// A document's tree, up to date.
    [[nodiscard]] const frontend::File& tree(const Document& document);

    /// Did anything change since this was last asked?
    [[nodiscard]] bool take_news();

private:
    Document& add(const std::string& path);
    void drop(Document& document);
    void parse(Document& document);
    void update();

    std::string folder_;
    diagnostics::Budget* budget_;
    SourceManager sources_;
    std::map<std::string, std::unique_ptr<Document>> documents_;
    std::map<std::string, SourceId> ids_;  ///< of every path ever seen
    frontend::Model model_;
    frontend::Resolution resolution_;
    diagnostics::Diagnostics findings_;
    std::optional<std::vector<frontend::Occurrence>> occurrences_;
    std::optional<diagnostics::Diagnostics> block_findings_;
    bool current_ = false;  ///< model_ and findings_ are about the texts as they are
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
    Place open(const std::string& uri, std::string text);
    void close(const std::string& uri);
    void refresh(const std::string& uri);
    [[nodiscard]] const std::vector<std::unique_ptr<Project>>& projects() const { return projects_; }
    /// Documents that left a project and still show diagnostics in the editor, by URI.
    [[nodiscard]] std::vector<std::string> take_orphans() { return std::exchange(orphans_, {}); }

private:
    /// The workspace folder around a path, the innermost if several; "" if there is none.
    [[nodiscard]] std::string folder_around(const std::string& path) const;
    [[nodiscard]] std::string root_of(const std::string& path) const;
    Project& project_at(const std::string& root);
    void rebuild();
    void disown(const Project& project);

    diagnostics::Budget* budget_;
    std::vector<std::string> folders_;
    std::vector<std::unique_ptr<Project>> projects_;
    std::vector<std::string> orphans_;
};

}  // namespace robochart::lsp
