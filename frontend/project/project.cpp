// SPDX-License-Identifier: Apache-2.0
// Turns a path into a resolved model. A folder is a project. For a single file, the files in its folder that it needs
// are loaded as well.
#include "frontend/project/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/diagnostics/files.hpp"
#include "base/diagnostics/spelling.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/lexer.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/syntax/syntax_rules.hpp"
#include "frontend/toolkits/toolkits.hpp"

namespace robochart::frontend {

namespace {

namespace fs = std::filesystem;
using diagnostics::Diagnostics;
using diagnostics::SourceManager;

bool is_model(const fs::path& path) {
    return is_model_path(path.string());
}
bool is_assertions(const fs::path& path) {
    return is_assertion_path(path.string());
}
bool is_ours(const fs::path& path) {
    return is_model(path) || is_assertions(path);
}
bool same_dialect(const fs::path& a, const fs::path& b) {
    return dialect_of(a.string()) == dialect_of(b.string());
}

/// Returns the model and assertion files of a folder, sorted. An unreadable folder is an error, because it may contain
/// needed files.
std::vector<fs::path> files_of(const fs::path& folder, bool deep, Diagnostics& out) {
    const diagnostics::FilesBelow found = diagnostics::files_below(folder.string(), deep);
    for (const auto& [path, cause] : found.unreadable) out.report(syntax::unreadable, {}, {path, cause});
    std::vector<fs::path> result;
    for (const std::string& file : found.files)
        if (is_ours(file)) result.emplace_back(file);
    return result;
}

std::unique_ptr<File> read(SourceManager& sources, const fs::path& path, Diagnostics& out) {
    std::string error;
    const auto source = sources.load_file(path.string(), error);
    if (!source) {
        out.report(syntax::unreadable, {}, {path.string(), error});
        return nullptr;
    }
    return parse(sources, *source, is_assertions(path), out);
}

bool is_empty(const File& file) {
    return !file.has_syntax_errors && file.declarations.empty() && file.assertions.empty() && file.csp_blocks.empty() &&
           file.kept.empty() && file.simulations.empty() && file.probabilistic_definitions.empty() &&
           file.probabilistic_assertions.empty() && file.imports.empty() && file.package.empty();
}

/// A file in the folder of the named file, and the data that determine whether it is needed.
struct Neighbour {
    fs::path path;
    bool readable = false;
    bool simulates = false;  ///< the file contains claims that compare RoboSim with RoboChart
    std::string package;
    std::set<std::string> declares;
    std::set<std::string> mentions;
    std::set<std::string> imports;
};

Neighbour survey_file(const fs::path& path) {
    SourceManager sources;
    Diagnostics ignored;  // findings of the first reading; needed files are read again and then report their findings
    Neighbour result;
    result.path = path;
    const auto file = read(sources, path, ignored);
    if (!file) return result;
    result.readable = true;
    result.simulates = !file->simulations.empty();
    result.package = file->package.text();
    for (const auto& declaration : file->declarations) {
        result.declares.insert(declaration->name);
        if (const auto* type = dynamic_cast<const TypeDeclaration*>(declaration.get()))
            for (const auto& literal : type->literals) result.declares.insert(literal->name);
    }
    for (const Import& import : file->imports) {
        result.imports.insert(import.name.text());
        QualifiedName owner = import.name;
        owner.parts.pop_back();
        if (!import.wildcard && !owner.empty()) result.imports.insert(owner.text());
    }
    for (const Token& token : tokenize(sources, file->source, is_assertions(path), ignored).tokens)
        if (token.kind == TokenKind::identifier) result.mentions.emplace(token.text);
    return result;
}

bool sets_overlap(const std::set<std::string>& a, const std::set<std::string>& b) {
    return std::ranges::any_of(a, [&](const std::string& x) { return b.contains(x); });
}

/// The names that the chosen files declare, by dialect and package.
class Declared {
public:
    /// Collects the names that the chosen files declare. If the named file contains claims that compare RoboSim with
    /// RoboChart, a name may refer to a component of either dialect in any package. A candidate is then superfluous
    /// only because of files of the same dialect and package.
    explicit Declared(const Neighbour& named) : apart_(named.simulates) {}

    void add(const Neighbour& file) { names_[key_of(file)].insert(file.declares.begin(), file.declares.end()); }

    /// Returns the names that the candidate declares but no chosen file declares.
    [[nodiscard]] std::set<std::string> only_in(const Neighbour& candidate) const {
        std::set<std::string> result = candidate.declares;
        for (const auto& [key, names] : names_)
            if (!apart_ || key == key_of(candidate))
                for (const std::string& name : names) result.erase(name);
        return result;
    }

private:
    using Key = std::pair<Dialect, std::string>;
    static Key key_of(const Neighbour& file) { return {dialect_of(file.path.string()), file.package}; }

    bool apart_;
    std::map<Key, std::set<std::string>> names_;
};

/// True if a chosen file needs the candidate: it imports its package, has the same package, or mentions a name that
/// only the candidate declares.
bool needs_candidate(const Neighbour& chosen, const Neighbour& candidate, const Declared& declared) {
    if (is_assertions(candidate.path)) return false;
    if (!candidate.package.empty() && chosen.package == candidate.package) return true;
    if (chosen.imports.contains(candidate.package)) return true;
    const std::string first_part = candidate.package.substr(0, candidate.package.find("::"));
    if (!first_part.empty() && !chosen.mentions.contains(first_part)) return false;
    return sets_overlap(declared.only_in(candidate), chosen.mentions);
}

/// Returns the models of the folders in this folder. RoboTool writes a translation as `x.rsa`, `robochart/` and
/// `robosim/`.
std::vector<fs::path> models_below(const fs::path& folder) {
    std::vector<fs::path> folders, result;
    std::error_code code;
    fs::directory_iterator at(folder, code);
    for (const fs::directory_iterator end; !code && at != end; at.increment(code))
        if (std::error_code ignored; at->is_directory(ignored) && !at->path().filename().string().starts_with("."))
            folders.push_back(at->path());
    std::ranges::sort(folders);
    Diagnostics ignored;  // these folders are not inputs, so they are not checked
    for (const fs::path& inner : folders)
        for (const fs::path& path : files_of(inner, false, ignored))
            if (!is_assertions(path)) result.push_back(path);
    return result;
}

/// Returns the files that the named file may need: those of its folder. If the only input is an assertion file in a
/// folder without models, its assertions refer to the models of the parent folder. Those of a `.rsa` file also refer to
/// the models of the folders in its folder.
std::vector<fs::path> candidate_files(const fs::path& named, bool alone, Diagnostics& out) {
    const fs::path folder = named.has_parent_path() ? named.parent_path() : fs::path(".");
    std::vector<fs::path> found = files_of(folder, false, out);
    if (alone && is_assertions(named) && std::ranges::none_of(found, is_model)) {
        Diagnostics ignored;  // that folder is not an input, so it is not checked
        found = files_of((folder / "..").lexically_normal(), false, ignored);
        if (dialect_of(named.string()) == Dialect::robosim)
            for (fs::path& path : models_below(folder)) found.push_back(std::move(path));
    } else {
        std::erase_if(found, [&](const fs::path& path) { return path.filename() == named.filename(); });
    }
    for (fs::path& path : found) path = path.lexically_normal();  // without "./"
    return found;
}

/// Returns the named file and all files that it needs, transitively. If the named file is a model, the assertion files
/// of its dialect in the folder are included. If it is an assertion file, no other assertion files are included.
std::vector<fs::path> needed_files(const fs::path& named, bool alone, Diagnostics& out) {
    std::vector<Neighbour> open;
    for (const fs::path& path : candidate_files(named, alone, out)) open.push_back(survey_file(path));
    std::vector<Neighbour> chosen{survey_file(named)};
    std::stable_partition(open.begin(), open.end(),
                          [&](const Neighbour& file) { return same_dialect(file.path, named); });
    Declared declared(chosen.front());
    declared.add(chosen.front());
    for (std::size_t i = 0; i < chosen.size(); ++i)
        for (std::size_t k = 0; k < open.size();) {
            if (!needs_candidate(chosen[i], open[k], declared)) {
                ++k;
                continue;
            }
            declared.add(open[k]);
            chosen.push_back(std::move(open[k]));
            open.erase(open.begin() + static_cast<std::ptrdiff_t>(k));
            k = 0;
        }
    std::vector<fs::path> result;
    for (const Neighbour& file : chosen) result.push_back(file.path);
    if (!is_assertions(named))
        for (const Neighbour& other : open)
            if (is_assertions(other.path) && same_dialect(other.path, named) &&
                (!other.readable || sets_overlap(other.mentions, chosen.front().declares)))
                result.push_back(other.path);
    std::ranges::sort(result);
    return result;
}

/// Returns the file or folder in the same folder whose name is most similar to the path's name.
std::string similar_path(const fs::path& path) {
    std::error_code code;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::vector<std::string> names;
    constexpr std::size_t most = 1000;
    for (fs::directory_iterator at(folder, code), end; !code && at != end && names.size() < most; at.increment(code))
        names.push_back(at->path().filename().string());
    std::ranges::sort(names);
    const std::string meant = diagnostics::nearest_spelling(path.filename().string(), names);
    if (meant.empty()) return "";
    return path.has_parent_path() ? (path.parent_path() / meant).string() : meant;
}

/// Returns the files of one input, and reports a missing file.
std::vector<fs::path> files_of_input(const std::string& path, bool alone, Diagnostics& out) {
    std::error_code code;
    const bool is_folder = fs::is_directory(path, code);
    if (!is_folder && !fs::exists(path, code)) {
        const std::string meant = similar_path(path);
        const std::string instead = meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant);
        out.report(syntax::unreadable, {}, {path, "no such file or folder" + instead});
        return {};
    }
    if (!is_folder && fs::path(path).extension() == ".csp") {
        out.report(
            syntax::unreadable, {},
            {path, fmt::format("this is a CSPM script, not a model; check it with `robochart-verify cspm {}`", path)});
        return {};
    }
    const std::size_t errors = out.error_count();
    std::vector<fs::path> result = is_folder ? files_of(path, true, out) : needed_files(path, alone, out);
    if (result.empty() && out.error_count() == errors) out.report(syntax::no_files, {}, {path});
    return result;
}

/// Returns the files of all inputs. A file that is named twice is included once.
std::vector<fs::path> files_of_inputs(const std::vector<std::string>& inputs, Diagnostics& out) {
    std::vector<fs::path> result;
    std::set<fs::path> seen;
    for (const std::string& input : inputs)
        for (fs::path& path : files_of_input(input, inputs.size() == 1, out)) {
            std::error_code code;
            const fs::path canonical = fs::weakly_canonical(path, code);
            if (seen.insert(code ? path : canonical).second) result.push_back(std::move(path));
        }
    return result;
}

void report_empty(const File& file, const SourceManager& sources, Diagnostics& out) {
    if (is_empty(file)) out.report(syntax::empty_file, {file.source, 0, 0}, {sources.path(file.source)});
}

}  // namespace

std::vector<std::string> project_files(const std::string& folder, bool deep) {
    std::vector<std::string> result;
    Diagnostics ignored;  // an editor continues with the readable files
    for (const fs::path& path : files_of(folder, deep, ignored)) result.push_back(path.string());
    return result;
}

void update_toolkits(SourceManager& sources, Model& model, Diagnostics& out) {
    add_toolkits(sources, model, out);
}

std::unique_ptr<Model> load_texts(SourceManager& sources, const std::vector<diagnostics::SourceId>& texts,
                                  Diagnostics& out) {
    auto model = std::make_unique<Model>();
    for (const diagnostics::SourceId text : texts) {
        model->files.push_back(parse(sources, text, is_assertions(sources.path(text)), out));
        report_empty(*model->files.back(), sources, out);
    }
    add_toolkits(sources, *model, out);
    resolve(*model, out);
    return model;
}

std::unique_ptr<Model> load_project(SourceManager& sources, const std::vector<std::string>& inputs, Diagnostics& out) {
    auto model = std::make_unique<Model>();
    const std::vector<fs::path> paths = files_of_inputs(inputs, out);
    if (paths.empty()) return model;
    for (const fs::path& path : paths)
        if (auto file = read(sources, path, out)) model->files.push_back(std::move(file));
    const bool nothing = std::ranges::all_of(
        model->files, [](const auto& file) { return file->declarations.empty() && !file->has_syntax_errors; });
    if (nothing && !model->files.empty())
        out.report(syntax::empty_input, {model->files.front()->source, 0, 0}, {inputs.front()});
    if (!nothing)
        for (const auto& file : model->files) report_empty(*file, sources, out);
    add_toolkits(sources, *model, out);
    resolve(*model, out);
    return model;
}

std::unique_ptr<Model> load_project(SourceManager& sources, const std::string& path, Diagnostics& out) {
    return load_project(sources, std::vector<std::string>{path}, out);
}

}  // namespace robochart::frontend
