// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "checker/cspm/syntax/lexer.hpp"
#include "checker/cspm/syntax/parser.hpp"
#include "checker/cspm/syntax/rules.hpp"

namespace robochart::cspm {

using diagnostics::Diagnostics;
using diagnostics::SourceId;
using diagnostics::SourceManager;

Script read(const SourceManager& sources, SourceId source, Diagnostics& diagnostics) {
    const std::vector<Token> tokens = lex(sources.source_text(source), source, diagnostics);
    return {Parser(tokens, diagnostics).parse_script()};
}

namespace {

// Replaces `include` lines by the declarations of the included files.
class Includer {
public:
    // The maximal depth of nested includes. The size has another limit: if every file includes another one several
    // times, a script grows exponentially.
    static constexpr std::size_t max_open = 200;
    static constexpr std::size_t max_files = 10000;

    Includer(const SourceManager& sources, Diagnostics& diagnostics, const Loader& load)
        : sources_(sources), diagnostics_(diagnostics), load_(load) {}

    std::vector<DeclPtr> file(const std::filesystem::path& path, Span from, Place place = Place::top) {
        diagnostics_.poll();
        const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, ignored_);
        if (std::ranges::find(open_, canonical) != open_.end()) {
            diagnostics_.report(rules::include_cycle, from, {path.string()});
            return {};
        }
        std::string cause;
        const auto source = text_of(path.string(), cause);
        if (!source) {
            if (!full_) diagnostics_.report(rules::include_failed, from, {path.string(), cause});
            full_ = files_ > max_files || bytes_ > SourceManager::max_bytes;
            return {};
        }
        open_.push_back(canonical);
        std::vector<DeclPtr> result =
            expand(read(sources_, *source, diagnostics_).decls, path.parent_path(), Place::top, place);
        open_.pop_back();
        return result;
    }

private:
    std::optional<SourceId> text_of(const std::string& path, std::string& cause) {
        if (open_.size() >= max_open) cause = fmt::format("files include one another {} deep", max_open);
        if (++files_ > max_files) cause = fmt::format("the script includes more than {} files", max_files);
        if (!cause.empty()) return std::nullopt;
        const auto source = load_(path, cause);
        if (!source) return std::nullopt;
        bytes_ += sources_.source_text(*source).size();
        if (bytes_ <= SourceManager::max_bytes) return source;
        cause =
            fmt::format("the script with all that it includes is longer than {} MB", SourceManager::max_bytes >> 20U);
        return std::nullopt;
    }

    /// Replaces includes by the declarations of their files. `read_at` is the kind of list that the parser assumed when
    /// it checked the declarations. `place` is the kind of list that contains them in the script.
    std::vector<DeclPtr> expand(const std::vector<DeclPtr>& decls, const std::filesystem::path& folder, Place read_at,
                                Place place) {
        std::vector<DeclPtr> result;
        for (const DeclPtr& decl : decls) {
            if (forbidden_place(decl->kind, read_at).empty()) report_misplaced(*decl, place, diagnostics_);
            if (decl->kind == DeclKind::include) {
                std::vector<DeclPtr> included = file(folder / decl->names.at(0), decl->span, place);
                result.insert(result.end(), included.begin(), included.end());
            } else if (decl->kind == DeclKind::module || decl->kind == DeclKind::timed) {
                const auto inside = [&](Place outer) {
                    return decl->kind == DeclKind::module ? Place::module : timed_inside(outer);
                };
                Decl whole = *decl;
                whole.decls = expand(decl->decls, folder, inside(read_at), inside(place));
                whole.exports = expand(decl->exports, folder, inside(read_at), inside(place));
                result.push_back(std::make_shared<const Decl>(std::move(whole)));
            } else {
                result.push_back(decl);
            }
        }
        return result;
    }

    const SourceManager& sources_;
    Diagnostics& diagnostics_;
    const Loader& load_;
    std::size_t files_ = 0;
    std::size_t bytes_ = 0;
    bool full_ = false;  // whether the excessive size has been reported
    std::vector<std::filesystem::path> open_;
    std::error_code ignored_;
};

}  // namespace

Script read_file(SourceManager& sources, const std::string& path, Diagnostics& diagnostics, const Loader& load) {
    return {Includer(sources, diagnostics, load).file(path, {})};
}

Script read_file(SourceManager& sources, const std::string& path, Diagnostics& diagnostics) {
    return read_file(sources, path, diagnostics, [&sources](const std::string& name, std::string& error) {
        return sources.load_file(name, error);
    });
}

}  // namespace robochart::cspm
