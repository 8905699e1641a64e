#include "checker/cspm/syntax/reader.hpp"

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
    const std::vector<Token> tokens = lex(sources.text(source), source, diagnostics);
    return {Parser(tokens, diagnostics).script()};
}

namespace {

// Puts the declarations of included files in place of the `include` lines.
class Includer {
public:
    Includer(SourceManager& sources, Diagnostics& diagnostics) : sources_(sources), diagnostics_(diagnostics) {}

    std::vector<DeclPtr> file(const std::filesystem::path& path, Span from) {
        const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, ignored_);
        if (std::ranges::find(open_, canonical) != open_.end()) {
            diagnostics_.report(rules::include_cycle, from, {path.string()});
            return {};
        }
        std::string cause;
        const auto source = sources_.load(path.string(), cause);
        if (!source) {
            diagnostics_.report(rules::include_failed, from, {path.string(), cause});
            return {};
        }
        open_.push_back(canonical);
        std::vector<DeclPtr> result = expand(read(sources_, *source, diagnostics_).decls, path.parent_path());
        open_.pop_back();
        return result;
    }

private:
    std::vector<DeclPtr> expand(const std::vector<DeclPtr>& decls, const std::filesystem::path& folder) {
        std::vector<DeclPtr> result;
        for (const DeclPtr& decl : decls) {
            if (decl->kind == DeclKind::include) {
                std::vector<DeclPtr> included = file(folder / decl->names.at(0), decl->span);
                result.insert(result.end(), included.begin(), included.end());
            } else if (decl->kind == DeclKind::module || decl->kind == DeclKind::timed) {
                Decl inside = *decl;
                inside.decls = expand(decl->decls, folder);
                inside.exports = expand(decl->exports, folder);
                result.push_back(std::make_shared<const Decl>(std::move(inside)));
            } else {
                result.push_back(decl);
            }
        }
        return result;
    }

    SourceManager& sources_;
    Diagnostics& diagnostics_;
    std::vector<std::filesystem::path> open_;
    std::error_code ignored_;
};

}  // namespace

Script read_file(SourceManager& sources, const std::string& path, Diagnostics& diagnostics) {
    return {Includer(sources, diagnostics).file(path, {})};
}

}  // namespace robochart::cspm
