// SPDX-License-Identifier: Apache-2.0
// Serves RoboChart models and their assertions. Each feature has its own source file.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "editors/server/documents/language.hpp"
#include "editors/server/workspace/target.hpp"

namespace robochart::lsp {

class KeptDiagrams;

/// The language of models. Each document is a file of a project, whether it is open or not.
class Models : public Language {
public:
    explicit Models(Session& session);
    ~Models() override;

    /// True for any document, so documents of other languages must be recognised first.
    [[nodiscard]] bool accepts(std::string_view uri, std::string_view language_id) const override;
    [[nodiscard]] TextDocument* find(std::string_view uri) override { return workspace_.find(uri).document; }
    void refresh_file(const std::string& uri) override { workspace_.refresh_file(uri); }
    void publish() override;

    void add_folder(const std::string& path) { workspace_.add_folder(path); }
    void remove_folder(const std::string& path);

    // code_actions.cpp
    [[nodiscard]] Json code_actions(const Request&) override;

    // navigation.cpp
    [[nodiscard]] Json definition(const Request&) override;
    [[nodiscard]] Json references(const Request&) override;
    [[nodiscard]] Json highlights(const Request&) override;

    // call_hierarchy.cpp
    [[nodiscard]] Json prepare_call_hierarchy(const Request&) override;
    [[nodiscard]] Json incoming_calls(const Request&) override;
    [[nodiscard]] Json outgoing_calls(const Request&) override;

    // rename.cpp
    [[nodiscard]] Json prepare_rename(const Request&) override;
    [[nodiscard]] Json rename(const Request&) override;

    // hover.cpp
    [[nodiscard]] Json hover(const Request&) override;

    // symbols.cpp
    [[nodiscard]] Json document_symbols(const Request&) override;
    /// Returns the declarations of all projects whose names match a query, as SymbolInformation.
    [[nodiscard]] Json workspace_symbols(const std::string& query);

    // completion.cpp
    [[nodiscard]] Json completion(const Request&) override;

    // signature_help.cpp
    [[nodiscard]] Json signature_help(const Request&) override;

    // formatting.cpp
    [[nodiscard]] Json formatting(const Request&) override;

    // inlay_hints.cpp
    [[nodiscard]] Json inlay_hints(const Request&) override;

    // code_lens.cpp
    [[nodiscard]] Json code_lenses(const Request&) override;

    // diagram.cpp
    /// Returns `{version, component, svg, elements, stale}`, or null if there is no component to draw.
    [[nodiscard]] Json diagram(const Request&) override;

    // folding.cpp
    [[nodiscard]] Json folding_ranges(const Request&) override;

    // selection_ranges.cpp
    [[nodiscard]] Json selection_ranges(const Request&) override;

    // semantic_tokens.cpp
    [[nodiscard]] Json semantic_tokens(const Request&) override;

protected:
    TextDocument& open_document(const std::string& uri, std::string text) override;
    void change(TextDocument& document, std::string text) override;
    void close(const std::string& uri) override;
    [[nodiscard]] Json findings_in(TextDocument& document) override;

private:
    [[nodiscard]] Target target_of(const Request&);
    /// Returns the findings of a project by URI, with a list for every document.
    [[nodiscard]] std::map<std::string, Json> findings_of(Project& project) const;
    /// Notifies the editor that diagrams of documents of the project may have changed, if it has requested any.
    void announce_diagrams(const Project& project);

    Workspace workspace_;
    std::unique_ptr<KeptDiagrams> diagrams_;
    bool documents_left_ = false;  ///< true if documents may have been removed with their project
};

/// Returns the names of semantic token types and modifiers, in the order of their numbers.
[[nodiscard]] Json semantic_legend();

}  // namespace robochart::lsp
