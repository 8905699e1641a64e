// SPDX-License-Identifier: Apache-2.0
// Reads the scenarios, mappings to ROS 2 and swarms that an editor has open. Each file is checked separately. Names
// that the model does not declare are reported only by `simulate`, `emit cpp` and `check`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "editors/server/documents/open_texts.hpp"

namespace robochart::lsp {

struct PlainText : TextDocument {
    using TextDocument::TextDocument;
    std::optional<diagnostics::Diagnostics> findings;  ///< no value after a change
};

/// Reading polls the budget of the session. If the budget ends the reading, the next request repeats it.
class PlainTexts : public OpenTexts<PlainText> {
public:
    using OpenTexts::OpenTexts;

    [[nodiscard]] bool accepts(std::string_view uri, std::string_view language_id) const override;

    [[nodiscard]] Json completion(const Request&) override;
    [[nodiscard]] Json hover(const Request&) override;

protected:
    void drop_results(PlainText& document) override { document.findings.reset(); }
    [[nodiscard]] Json findings_in(TextDocument& document) override;

private:
    [[nodiscard]] const diagnostics::Diagnostics& diagnostics_of(TextDocument& document);
    /// Returns the words that the parser would accept at an offset, found by parsing the text before the offset.
    [[nodiscard]] std::vector<std::string> words_at(const TextDocument& document, std::uint32_t offset) const;
};

}  // namespace robochart::lsp
