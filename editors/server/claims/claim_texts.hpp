// SPDX-License-Identifier: Apache-2.0
// Reads the claims files that an editor has open. Their names refer to the models on disk in the folder of the claims,
// or in the folder above.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/syntax/syntax.hpp"
#include "editors/server/claims/models_beside.hpp"
#include "editors/server/documents/open_texts.hpp"

namespace robochart::lsp {

/// A text after parsing and, if there is a model, resolution.
struct ClaimReading {
    std::shared_ptr<const claims::ClaimFile> file;
    diagnostics::Diagnostics findings;
    const ClaimedModels* models = nullptr;  ///< null if there are none
};

struct ClaimText : TextDocument {
    using TextDocument::TextDocument;
    std::unique_ptr<ClaimReading> reading;  ///< null after a change
};

/// Reading polls the budget of the session. If the budget ends the reading, the next request repeats it.
class ClaimTexts : public OpenTexts<ClaimText> {
public:
    using OpenTexts::OpenTexts;

    [[nodiscard]] bool accepts(std::string_view uri, std::string_view language_id) const override;
    void refresh_file(const std::string& uri) override;

    [[nodiscard]] Json code_actions(const Request&) override;
    [[nodiscard]] Json completion(const Request&) override;
    [[nodiscard]] Json definition(const Request&) override;
    [[nodiscard]] Json document_symbols(const Request&) override;
    [[nodiscard]] Json formatting(const Request&) override;
    [[nodiscard]] Json hover(const Request&) override;
    [[nodiscard]] Json prepare_rename(const Request&) override;
    [[nodiscard]] Json rename(const Request&) override;

protected:
    /// Drops the results of all texts, because the claims of one file depend on the time unit and the names of the
    /// others.
    void drop_results(ClaimText& document) override;
    [[nodiscard]] Json findings_in(TextDocument& document) override;

private:
    [[nodiscard]] const ClaimReading& reading_of(TextDocument& document);
    void resolve(const TextDocument& document, ClaimReading& reading);

    ModelsBeside models_;
};

/// The word at or directly before an offset. If there is no word, the span is empty.
struct ClaimWord {
    std::string text;
    Span span;
};
[[nodiscard]] ClaimWord claim_word_at(const TextDocument& document, std::uint32_t offset);

}  // namespace robochart::lsp
