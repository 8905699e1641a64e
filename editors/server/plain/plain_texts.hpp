// SPDX-License-Identifier: Apache-2.0
// Scenarios, mappings to ROS 2 and swarms that an editor has open. Each file is checked separately. `simulate`, `emit
// cpp` and `check` report names that the model does not declare.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "editors/server/workspace/open_text.hpp"

namespace robochart::lsp {

/// True if a document contains a scenario, a mapping or a swarm, according to its name or to the language identifier
/// from the editor.
[[nodiscard]] bool is_plain(std::string_view uri, std::string_view language = {});

struct PlainText : OpenText {
    std::string language;  ///< "scenario", "ros2" or "swarm"
    std::optional<diagnostics::Diagnostics> findings;
};

class PlainTexts {
public:
    /// Reading polls the budget, if one is given. If the budget ends the reading, the next request repeats it.
    explicit PlainTexts(diagnostics::Budget* budget = nullptr) : budget_(budget) {}

    [[nodiscard]] PlainText* find(std::string_view uri);
    PlainText& open_document(const std::string& uri, std::string_view language, std::string text);
    void change(PlainText& document, std::string text);
    void close(const std::string& uri);
    [[nodiscard]] const diagnostics::Diagnostics& findings_in(PlainText& document);
    /// The words that the parser would accept at an offset, found by parsing the text before the offset.
    [[nodiscard]] std::vector<std::string> words_at(const PlainText& document, std::uint32_t offset) const;
    [[nodiscard]] const std::map<std::string, std::unique_ptr<PlainText>, std::less<>>& all_documents() const {
        return documents_;
    }

    /// True if something changed since it was last settled.
    [[nodiscard]] bool has_news() const { return news_; }
    void settle_news() { news_ = false; }

    Published published;

private:
    diagnostics::Budget* budget_;
    std::map<std::string, std::unique_ptr<PlainText>, std::less<>> documents_;  ///< keyed by URI
    bool news_ = false;
};

}  // namespace robochart::lsp
