// SPDX-License-Identifier: Apache-2.0
// Reads the CSPM scripts that an editor has open. A script is read together with the files that it includes. Open texts
// override files on disk. If another open file includes an open file, the included file is read as part of the other,
// which may declare its names.
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
#include "editors/server/documents/open_texts.hpp"

namespace robochart::lsp {

/// A script with all files that it includes, and the analysis so far.
struct ScriptReading {
    SourceManager sources;
    cspm::Script script;
    diagnostics::Diagnostics findings;
    cspm::NameTable names;               ///< empty until types are computed
    std::map<std::string, SourceId> at;  ///< the text of each file; the first one if a file is included several times
    std::map<SourceId, std::string> in;  ///< the file of every text
    std::set<std::string> searched;      ///< files that were searched for, whether they exist or not
    bool typed = false;                  ///< true if types were checked, or if reading failed
};

/// An open script.
struct ScriptDocument : TextDocument {
    ScriptDocument(SourceManager& in, const std::string& at);

    std::string file;                        ///< the file of the document, with links resolved
    std::unique_ptr<ScriptReading> reading;  ///< the document read with its includes; null after a change
};

/// Reading and checking poll the budget of the session. If the budget ends this work, the next request repeats it.
class Scripts : public OpenTexts<ScriptDocument> {
public:
    using OpenTexts::OpenTexts;

    [[nodiscard]] bool accepts(std::string_view uri, std::string_view language_id) const override;
    void refresh_file(const std::string& uri) override;

    [[nodiscard]] Json definition(const Request&) override;
    [[nodiscard]] Json document_symbols(const Request&) override;
    [[nodiscard]] Json hover(const Request&) override;

protected:
    void drop_results(ScriptDocument& document) override { forget_readings(document.file); }
    [[nodiscard]] std::map<std::string, Json> all_findings() override;
    [[nodiscard]] Json findings_in(TextDocument& document) override;

private:
    /// Returns the scripts that contain the open documents, with types.
    [[nodiscard]] std::vector<const ScriptReading*> current_readings();
    /// Returns the first of these scripts that contains the document.
    [[nodiscard]] const ScriptReading& reading_of(const ScriptDocument& document);
    /// Returns the URI that the editor uses for a file.
    [[nodiscard]] std::string uri_of(const ScriptReading& reading, SourceId source) const;
    /// Returns `{uri, range}` of a span of a script; null if the span is unknown.
    [[nodiscard]] Json script_location(const ScriptReading& reading, Span span) const;

    void forget_readings(const std::string& file);
    void read(ScriptDocument& document);
    [[nodiscard]] std::optional<SourceId> load_text(ScriptReading& reading, const std::string& path,
                                                    std::string& error);
    [[nodiscard]] std::string file_of(const std::string& path) const;
    [[nodiscard]] const ScriptDocument* find_open(const std::string& file) const;
    [[nodiscard]] bool is_part_of_another(const ScriptDocument& document) const;
};

}  // namespace robochart::lsp
