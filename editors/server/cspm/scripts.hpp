// SPDX-License-Identifier: Apache-2.0
// The CSPM scripts that an editor has open. A script is read together with the files that it includes. Open texts
// override files on disk. An open file that another open file includes is read as part of that file, because its names
// may be declared there.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "editors/server/protocol/positions.hpp"
#include "editors/server/workspace/open_text.hpp"

namespace robochart::lsp {

/// True if a document contains CSPM, according to its name or to the language identifier from the editor.
[[nodiscard]] bool is_script(std::string_view uri, std::string_view language = {});

/// A script with all files that it includes, and the analysis so far.
struct ScriptReading {
    SourceManager sources;
    cspm::Script script;
    diagnostics::Diagnostics findings;
    cspm::NameTable names;               ///< empty until types are computed
    std::map<std::string, SourceId> at;  ///< the text of each file; the first one if a file is included several times
    std::map<SourceId, std::string> in;  ///< the file of every text
    std::set<std::string> searched;      ///< files that were searched for, whether they exist or not
    bool typed = false;                  ///< types were checked, or cannot be because reading failed
};

/// An open script.
struct ScriptDocument : OpenText {
    std::string file;                        ///< the file of the document, with links resolved
    std::unique_ptr<ScriptReading> reading;  ///< the document read with its includes; null after a change
};

class Scripts {
public:
    /// Reading and checking poll the budget, if one is given. If the budget ends this work, the next request repeats
    /// it.
    explicit Scripts(diagnostics::Budget* budget = nullptr) : budget_(budget) {}

    [[nodiscard]] ScriptDocument* find(std::string_view uri);
    ScriptDocument& open_document(const std::string& uri, std::string text);
    void change(ScriptDocument& document, std::string text);
    void close(const std::string& uri);
    /// Must be called when a file has changed on disk.
    void refresh_file(const std::string& uri);

    /// The scripts that contain the open documents, with types.
    [[nodiscard]] std::vector<const ScriptReading*> current_readings();
    /// The first of these scripts that contains the document.
    [[nodiscard]] const ScriptReading& reading_of(const ScriptDocument& document);
    /// The URI that the editor uses for a file.
    [[nodiscard]] std::string uri_of(const ScriptReading& reading, SourceId source) const;

    /// True if something changed since it was last settled.
    [[nodiscard]] bool has_news() const { return news_; }
    void settle_news() { news_ = false; }

    Published published;

private:
    void forget_readings(const std::string& file);
    void read(ScriptDocument& document);
    [[nodiscard]] std::optional<SourceId> load_text(ScriptReading& reading, const std::string& path,
                                                    std::string& error);
    [[nodiscard]] std::string file_of(const std::string& path) const;
    [[nodiscard]] const ScriptDocument* find_open(const std::string& file) const;
    [[nodiscard]] bool is_part_of_another(const ScriptDocument& document) const;

    diagnostics::Budget* budget_;
    std::map<std::string, std::unique_ptr<ScriptDocument>, std::less<>> documents_;  ///< keyed by URI
    bool news_ = false;
};

}  // namespace robochart::lsp
