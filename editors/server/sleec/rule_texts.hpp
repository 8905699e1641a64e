// SPDX-License-Identifier: Apache-2.0
// The SLEEC rule files that an editor has open. Each file is checked separately.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "editors/server/workspace/open_text.hpp"
#include "sleec/syntax/syntax.hpp"

namespace robochart::lsp {

/// True if a document contains rules, according to its name or to the language identifier from the editor.
[[nodiscard]] bool is_rules(std::string_view uri, std::string_view language = {});

/// A text after parsing and checking.
struct RuleReading {
    sleec::RuleFile file;  ///< the parts that could be parsed
    diagnostics::Diagnostics findings;
};

/// An open rule file.
struct RuleText : OpenText {
    std::unique_ptr<RuleReading> reading;  ///< null after a change
};

class RuleTexts {
public:
    /// Reading polls the budget, if one is given. If the budget ends the reading, the next request repeats it.
    explicit RuleTexts(diagnostics::Budget* budget = nullptr) : budget_(budget) {}

    [[nodiscard]] RuleText* find(std::string_view uri);
    RuleText& open_document(const std::string& uri, std::string text);
    void change(RuleText& document, std::string text);
    void close(const std::string& uri);
    [[nodiscard]] const RuleReading& reading_of(RuleText& document);
    [[nodiscard]] const std::map<std::string, std::unique_ptr<RuleText>, std::less<>>& all_documents() const {
        return documents_;
    }

    /// The rules of all files in a folder, each with the name of its file. Open texts override those on disk.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> names_in(const std::string& folder);

    /// True if something changed since it was last settled.
    [[nodiscard]] bool has_news() const { return news_; }
    void settle_news() { news_ = false; }

    Published published;

private:
    diagnostics::Budget* budget_;
    std::map<std::string, std::unique_ptr<RuleText>, std::less<>> documents_;  ///< keyed by URI
    bool news_ = false;
};

}  // namespace robochart::lsp
