// The scripts in CSPM that an editor has open. A script is read with the files that it includes, whose open texts
// override those on disk. An open file that another open one includes is read as a part of that, since its names may
// need what stands around it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "checker/cspm/types/type_check.hpp"
#include "diagnostics/diagnostic.hpp"
#include "lsp/protocol/positions.hpp"
#include "lsp/workspace/open_text.hpp"

namespace robochart::lsp {

/// Does a document contain CSPM? Its name says so, or the editor, which may call it anything.
[[nodiscard]] bool is_script(std::string_view uri, std::string_view language = {});

/// A script with all that it includes, as far as it has been looked at.
struct ScriptReading {
    SourceManager sources;
    cspm::Script script;
    diagnostics::Diagnostics findings;
    cspm::NameTable names;               ///< empty until the types are known
    std::map<std::string, SourceId> at;  ///< texts by file; of one included several times the first
    std::map<SourceId, std::string> in;  ///< the file of every text
    std::set<std::string> asked;         ///< files looked for, whether they are there or not
    bool typed = false;                  ///< types have been checked, or cannot be as reading has failed
};

/// An open script.
struct ScriptDocument : OpenText {
    std::string file;                        ///< the file that is meant, whichever links lead to it
    std::unique_ptr<ScriptReading> reading;  ///< of the document with what it includes; null after a change
};

class Scripts {
public:
    /// What reads and checks polls the budget, if there is one; ended by it, it begins anew when it is asked again.
    explicit Scripts(diagnostics::Budget* budget = nullptr) : budget_(budget) {}

    [[nodiscard]] ScriptDocument* find(std::string_view uri);
    ScriptDocument& open(const std::string& uri, std::string text);
    void change(ScriptDocument& document, std::string text);
    void close(const std::string& uri);
    /// A file has changed on disk.
    void refresh(const std::string& uri);

    /// The scripts that the open documents are parts of, with their types.
    [[nodiscard]] std::vector<const ScriptReading*> readings();
    /// The first of these that contains the document.
    [[nodiscard]] const ScriptReading& reading_of(const ScriptDocument& document);
    /// What the editor calls a file.
    [[nodiscard]] std::string uri_of(const ScriptReading& reading, SourceId source) const;

    /// Did anything change since this was last settled?
    [[nodiscard]] bool has_news() const { return news_; }
    void settle_news() { news_ = false; }

    Published published;

private:
    void forget(const std::string& file);
    void read(ScriptDocument& document);
    [[nodiscard]] std::optional<SourceId> load(ScriptReading& reading, const std::string& path, std::string& error);
    [[nodiscard]] std::string file_of(const std::string& path) const;
    [[nodiscard]] const ScriptDocument* opened(const std::string& file) const;
    [[nodiscard]] bool is_part_of_another(const ScriptDocument& document) const;

    diagnostics::Budget* budget_;
    std::map<std::string, std::unique_ptr<ScriptDocument>, std::less<>> documents_;  ///< by URI
    bool news_ = false;
};

}  // namespace robochart::lsp
