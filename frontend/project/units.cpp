// SPDX-License-Identifier: Apache-2.0
// See units.hpp. Union-find with path halving (Tarjan, van Leeuwen 1984).
#include "frontend/project/units.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "base/diagnostics/scanner.hpp"
#include "frontend/names/names.hpp"
#include "frontend/project/occurrences.hpp"

namespace robochart::frontend {

namespace {

class Groups {
public:
    explicit Groups(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0U); }

    std::size_t group_of(std::size_t file) {
        while (parents_[file] != file) file = parents_[file] = parents_[parents_[file]];
        return file;
    }
    void join_groups(std::size_t a, std::size_t b) {
        const std::size_t first = group_of(a), second = group_of(b);
        parents_[std::max(first, second)] = std::min(first, second);
    }

private:
    std::vector<std::size_t> parents_;
};

/// Returns the words that begin a name and are followed by `::`.
std::set<std::string> first_parts(const std::string& text) {
    std::set<std::string> result;
    for (std::size_t at = text.find("::"); at != std::string::npos; at = text.find("::", at + 2)) {
        std::size_t begin = at;
        while (begin > 0 && diagnostics::continues_name(text[begin - 1])) --begin;
        const bool inside = begin >= 2 && text.compare(begin - 2, 2, "::") == 0;
        if (begin < at && !inside) result.insert(text.substr(begin, at - begin));
    }
    return result;
}

std::string flatten_qualifiers(std::string text) {
    for (std::size_t at = text.find("::"); at != std::string::npos; at = text.find("::")) text.replace(at, 2, "_");
    return text;
}

class Units {
public:
    explicit Units(const Model& model) : model_(model), groups_(model.files.size()) {
        for (std::size_t i = 0; i < model.files.size(); ++i) {
            const File& file = *model.files[i];
            if (file.is_library) continue;
            files_[file.source] = i;
            if (!file.package.empty()) packages_[file.package.text()].push_back(i);
            for (const auto& declaration : file.declarations) {
                named_[declaration->name].push_back(i);
                declared_[key_of(file, *declaration)].push_back(i);
            }
        }
    }

    std::vector<std::vector<std::size_t>> find() {
        for (const auto& [name, files] : packages_) same_package(files);
        tie_references();
        for (const auto& [source, i] : files_) {
            tie_imports(i);
            tie_blocks(i);
            tie_broken_file(i);
        }
        loose_assertions();
        std::map<std::size_t, std::vector<std::size_t>> result;
        for (std::size_t i = 0; i < model_.files.size(); ++i)
            if (!model_.files[i]->is_library) result[groups_.group_of(i)].push_back(i);
        std::vector<std::vector<std::size_t>> groups;
        for (auto& [first, files] : result) groups.push_back(std::move(files));
        return groups;
    }

private:
    /// The key of a declaration in a package. Declarations of different kinds may have the same name.
    using Key = std::tuple<std::string, std::string, DeclKind>;
    static Key key_of(const File& file, const Declaration& declaration) {
        return {file.package.text(), std::string(declaration.name), declaration.kind};
    }

    /// Ties the file to the nearest of the other files. If several are equally near, the reference is ambiguous, and
    /// the file is tied to all of them.
    void tie_nearest(std::size_t file, const std::vector<std::size_t>& others) {
        std::size_t near = 0;
        for (const std::size_t other : others)
            near = std::max(near, file_nearness(*model_.files[file], *model_.files[other]));
        for (const std::size_t other : others)
            if (file_nearness(*model_.files[file], *model_.files[other]) == near) tie_files(file, other);
    }

    void tie_files(std::size_t a, std::size_t b) {
        if (a == b) return;
        groups_.join_groups(a, b);
        tied_.insert(a);
        tied_.insert(b);
    }

    /// Ties files of the same package if they are in one folder, or if the folder of one contains the folder of the
    /// other.
    void same_package(const std::vector<std::size_t>& files) {
        std::map<std::string, std::size_t, std::less<>> first;  // the first file of each folder
        for (const std::size_t file : files) first.emplace(model_.files[file]->folder, file);
        for (const std::size_t file : files) {
            const std::string_view folder = model_.files[file]->folder;
            for (std::size_t end = folder.find('/'); end != std::string_view::npos; end = folder.find('/', end + 1))
                if (const auto above = first.find(folder.substr(0, end + 1)); above != first.end())
                    tie_files(file, above->second);
        }
    }

    void tie_references() {
        for (const Occurrence& occurrence : find_occurrences(model_)) {
            if (occurrence.target == nullptr || occurrence.declares) continue;
            const auto from = files_.find(occurrence.span.source);
            const auto to = files_.find(occurrence.target->span.source);
            if (from == files_.end() || to == files_.end() || from == to) continue;
            const Declaration* outermost = occurrence.target;
            while (outermost->parent != nullptr) outermost = outermost->parent;
            const auto declared = declared_.find(key_of(*model_.files[to->second], *outermost));
            tie_files(from->second, to->second);
            if (declared != declared_.end() && declared->second.size() > 1) tie_nearest(from->second, declared->second);
        }
    }

    void tie_imports(std::size_t file) {
        for (const Import& import : model_.files[file]->imports) {
            QualifiedName package = import.name;
            for (; !package.empty(); package.parts.pop_back())
                if (const auto found = packages_.find(package.text()); found != packages_.end()) {
                    tie_nearest(file, found->second);
                    break;
                }
        }
    }

    /// Ties a file to the files to which its csp blocks refer. Names in a block are not resolved, so these are the
    /// nearest files that declare the names.
    void tie_blocks(std::size_t file) {
        for (const CspBlock& block : model_.files[file]->csp_blocks)
            for (const std::string& name : first_parts(block.text)) {
                if (const auto found = named_.find(name); found != named_.end()) tie_nearest(file, found->second);
                for (const auto& [package, files] : packages_)
                    if (flatten_qualifiers(package) == name) tie_nearest(file, files);
            }
    }

    /// Ties a file with syntax errors to its neighbours, because the text that could not be parsed may contain
    /// declarations that they need.
    void tie_broken_file(std::size_t file) {
        if (!model_.files[file]->has_syntax_errors) return;
        std::vector<std::size_t> others;
        for (const auto& [source, i] : files_)
            if (i != file) others.push_back(i);
        tie_nearest(file, others);
    }

    void loose_assertions() {
        for (const auto& [source, i] : files_)
            if (model_.files[i]->is_assertions && !tied_.contains(i)) tie_loose(i);
    }

    void tie_loose(std::size_t file) {
        std::vector<std::size_t> models;
        for (const auto& [source, i] : files_)
            if (!model_.files[i]->is_assertions) models.push_back(i);
        tie_nearest(file, models);
    }

    const Model& model_;
    Groups groups_;
    std::map<diagnostics::SourceId, std::size_t> files_;
    std::map<std::string, std::vector<std::size_t>> packages_, named_;
    std::map<Key, std::vector<std::size_t>> declared_;
    std::set<std::size_t> tied_;
};

}  // namespace

namespace {

/// Returns the instantiations of an assertion file as text, or "" if it has none.
std::string instantiation_text(const File& file) {
    std::string result;
    for (const CspBlock& block : file.csp_blocks)
        if (replaces_instantiations(block))
            result += std::to_string(static_cast<int>(block.time)) + " " + block.text + "\n";
    return result;
}

/// Makes one unit of a group for each of its instantiations.
void split_group(const Model& model, const std::vector<std::size_t>& group, std::vector<Unit>& result) {
    std::map<std::string, std::vector<std::size_t>> by_text;
    std::vector<std::string> order;
    std::vector<std::size_t> models;
    for (const std::size_t file : group) {
        if (!model.files[file]->is_assertions) {
            models.push_back(file);
            continue;
        }
        std::string text = instantiation_text(*model.files[file]);
        if (!by_text.contains(text)) order.push_back(text);
        by_text[text].push_back(file);
    }
    if (by_text.size() < 2 || (by_text.size() == 2 && by_text.contains(""))) {
        result.push_back({group, false});
        return;
    }
    for (const std::string& text : order) {
        Unit unit{models, text != order.front()};
        unit.files.insert(unit.files.end(), by_text.at(text).begin(), by_text.at(text).end());
        std::ranges::sort(unit.files);
        result.push_back(std::move(unit));
    }
}

}  // namespace

std::vector<std::vector<std::size_t>> group_files(const Model& model) {
    return Units(model).find();
}

std::vector<Unit> split_into_units(const Model& model) {
    std::vector<Unit> result;
    for (const std::vector<std::size_t>& group : group_files(model)) split_group(model, group, result);
    return result;
}

bool replaces_instantiations(const CspBlock& block) {
    return block.name == "Instantiations" || block.name == "instantiations";
}

}  // namespace robochart::frontend
