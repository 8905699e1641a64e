// SPDX-License-Identifier: Apache-2.0
// Defines a language whose documents are the texts that the editor has open.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "editors/server/documents/language.hpp"

namespace robochart::lsp {

/// `Text` is a TextDocument with the results of its analysis.
template <class Text>
class OpenTexts : public Language {
public:
    using Language::Language;

    [[nodiscard]] Text* find(std::string_view uri) final {
        const auto found = documents_.find(uri);
        return found != documents_.end() ? found->second.get() : nullptr;
    }
    /// Sends the findings. If the budget ends an analysis, they are sent later.
    void publish() final {
        if (!news_) return;
        send_findings(all_findings());
        news_ = false;
    }

protected:
    using Documents = std::map<std::string, std::unique_ptr<Text>, std::less<>>;  ///< keyed by URI

    [[nodiscard]] const Documents& documents() const { return documents_; }
    [[nodiscard]] static Text& text_of(TextDocument& document) { return static_cast<Text&>(document); }

    /// Discards the results that depend on a document. Called after the document was opened, changed or closed.
    virtual void drop_results(Text& document) = 0;
    /// Returns the findings of all documents, by URI.
    [[nodiscard]] virtual std::map<std::string, Json> all_findings() {
        std::map<std::string, Json> result;
        for (const auto& [uri, document] : documents_) result.emplace(uri, findings_in(*document));
        return result;
    }
    /// Must be called when findings may have changed.
    void note_news() { news_ = true; }

    TextDocument& open_document(const std::string& uri, std::string text) final {
        close(uri);
        Text& document = *(documents_[uri] = std::make_unique<Text>(sources_, uri));
        document.source = sources_.add(document.path, std::move(text));
        note_change(document);
        return document;
    }
    void change(TextDocument& document, std::string text) final {
        if (sources_.source_text(document.source) == text) return;
        sources_.replace(document.source, std::move(text));
        note_change(text_of(document));
    }
    void close(const std::string& uri) final {
        const auto closed = documents_.extract(uri);
        if (closed.empty()) return;
        sources_.replace(closed.mapped()->source, {});
        note_change(*closed.mapped());
    }

private:
    void note_change(Text& document) {
        note_news();
        drop_results(document);
    }

    SourceManager sources_;
    Documents documents_;
    bool news_ = false;
};

}  // namespace robochart::lsp
