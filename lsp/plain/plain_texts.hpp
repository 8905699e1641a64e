// Scenarios, mappings to ROS 2 and swarms that an editor has open. Each file is read alone: whether the model has what
// it names, `simulate`, `emit cpp` and `check` say.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "lsp/workspace/open_text.hpp"

namespace robochart::lsp {

/// Does a document contain one of these? Its name says so, or the editor, which may call it anything.
[[nodiscard]] bool is_plain(std::string_view uri, std::string_view language = {});

struct PlainText : OpenText {
    std::string language;  ///< "scenario", "ros2" or "swarm"
    std::optional<diagnostics::Diagnostics> findings;
};

class PlainTexts {
public:
    /// Reading polls the budget, if there is one; ended by it, it begins anew when it is asked again.
    explicit PlainTexts(diagnostics::Budget* budget = nullptr) : budget_(budget) {}

    [[nodiscard]] PlainText* find(std::string_view uri);
    PlainText& open(const std::string& uri, std::string_view language, std::string text);
    void change(PlainText& document, std::string text);
    void close(const std::string& uri);
    [[nodiscard]] const diagnostics::Diagnostics& findings_in(PlainText& document);
    /// The words that the reader would take at an offset: it is asked about the text in front of it.
    [[nodiscard]] std::vector<std::string> words_at(const PlainText& document, std::uint32_t offset) const;
    [[nodiscard]] const std::map<std::string, std::unique_ptr<PlainText>, std::less<>>& all() const {
        return documents_;
    }

    /// Did anything change since this was last settled?
    [[nodiscard]] bool has_news() const { return news_; }
    void settle_news() { news_ = false; }

    Published published;

private:
    diagnostics::Budget* budget_;
    std::map<std::string, std::unique_ptr<PlainText>, std::less<>> documents_;  ///< by URI
    bool news_ = false;
};

}  // namespace robochart::lsp
