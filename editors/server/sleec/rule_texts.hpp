// SPDX-License-Identifier: Apache-2.0
// Reads the SLEEC rule files that an editor has open. Each file is checked separately.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/sleec/syntax/syntax.hpp"
#include "editors/server/claims/models_beside.hpp"
#include "editors/server/documents/open_texts.hpp"

namespace robochart::lsp {

/// A text after parsing and checking.
struct RuleReading {
    sleec::RuleFile file;  ///< the parts that could be parsed
    diagnostics::Diagnostics findings;
};

/// An open rule file.
struct RuleText : TextDocument {
    using TextDocument::TextDocument;
    std::unique_ptr<RuleReading> reading;  ///< null after a change
};

/// Reading polls the budget of the session. If the budget ends the reading, the next request repeats it.
class RuleTexts : public OpenTexts<RuleText> {
public:
    using OpenTexts::OpenTexts;

    [[nodiscard]] bool accepts(std::string_view uri, std::string_view language_id) const override;
    /// Returns the rules of all files in a folder, each with the name of its file. Open texts override files on disk.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> names_in(const std::string& folder);

    [[nodiscard]] Json completion(const Request&) override;
    [[nodiscard]] Json definition(const Request&) override;
    [[nodiscard]] Json document_symbols(const Request&) override;
    [[nodiscard]] Json formatting(const Request&) override;
    [[nodiscard]] Json hover(const Request&) override;

protected:
    void drop_results(RuleText& document) override { document.reading.reset(); }
    [[nodiscard]] Json findings_in(TextDocument& document) override;

private:
    [[nodiscard]] const RuleReading& reading_of(TextDocument& document);

    ModelsBeside models_;
};

}  // namespace robochart::lsp
