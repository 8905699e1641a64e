// SPDX-License-Identifier: Apache-2.0
#include "tests/sanity/source_tree.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>

#include "checker/lts/strong_components.hpp"
#include "tests/source_folder.hpp"

namespace robochart::sanity {

namespace fs = std::filesystem;

const fs::path& root() {
    static const fs::path path = tests::source_folder();
    return path;
}

std::vector<fs::path> files(const fs::path& folder, const std::set<std::string>& extensions) {
    const std::set<std::string> left_out = {"build", "out", ".git", "node_modules"};
    std::vector<fs::path> found;
    for (auto it = fs::recursive_directory_iterator(folder); it != fs::recursive_directory_iterator(); ++it) {
        if (it->is_directory() && left_out.contains(it->path().filename().string()))
            it.disable_recursion_pending();
        else if (it->is_regular_file() && extensions.contains(it->path().extension().string()))
            found.push_back(it->path());
    }
    std::ranges::sort(found);
    return found;
}

std::vector<std::string> components() {
    return {"app",      "base",   "checker", "claims",   "conformance", "counterexample", "cpp_emit",
            "csp_emit", "driver", "editors", "frontend", "prism",       "semantics",      "simulation"};
}

std::vector<std::string> program_files() {
    std::vector<std::string> found;
    for (const std::string& component : components())
        for (const fs::path& path : files(root() / component, {".cpp", ".hpp"})) {
            const std::string name = fs::relative(path, root()).string();
            if (!name.starts_with("cpp_emit/projects/")) found.push_back(name);
        }
    return found;
}

std::vector<std::string> included(const std::string& file) {
    std::vector<std::string> result;
    std::istringstream lines(read_contents(root() / file));
    const std::string start = "#include \"";
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(start)) continue;
        const std::string name = line.substr(start.size(), line.find('"', start.size()) - start.size());
        if (fs::exists(root() / name)) result.push_back(name);
    }
    return result;
}

std::string folder_of(const std::string& file) {
    return file.substr(0, file.rfind('/'));
}

namespace {

/// Returns the texts between backquotes.
std::vector<std::string> quoted_names(const std::string& text) {
    std::vector<std::string> result;
    for (std::size_t at = text.find('`'); at != std::string::npos; at = text.find('`', at + 1)) {
        const std::size_t end = text.find('`', at + 1);
        if (end == std::string::npos) break;
        result.push_back(text.substr(at + 1, end - at - 1));
        at = end;
    }
    return result;
}

bool is_below(const std::string& folder, const std::string& above) {
    return folder.starts_with(above + "/");
}

}  // namespace

std::map<std::string, FolderRow> folder_table() {
    std::map<std::string, FolderRow> table;
    std::istringstream lines(read_contents(root() / "docs/architecture.md"));
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("| folder |"))
            inside = true;
        else if (!line.starts_with("|"))
            inside = false;
        if (!inside || !line.starts_with("| `")) continue;
        const std::size_t second = line.find(" | "), third = line.rfind(" | ", line.size() - 3);
        FolderRow row;
        std::string allowed = line.substr(third + 3);
        row.everything = allowed.find("everything") != std::string::npos;
        const std::size_t but = allowed.find(" but ");
        if (but != std::string::npos) {
            for (const std::string& name : quoted_names(allowed.substr(but))) row.excluded.insert(name);
            allowed.resize(but);
        }
        for (const std::string& name : quoted_names(allowed)) row.allowed.insert(name);
        for (const std::string& folder : quoted_names(line.substr(0, second))) table[folder] = row;
    }
    return table;
}

bool may_include(const FolderRow& row, const std::string& folder) {
    if (row.excluded.contains(folder)) return false;
    const bool listed = std::ranges::any_of(row.allowed, [&](const std::string& name) {
        return name == folder || (name.ends_with("/*") && is_below(folder, name.substr(0, name.size() - 2)));
    });
    if (listed) return true;
    // "everything but `app`" also excludes the folders below app.
    return row.everything &&
           std::ranges::none_of(row.excluded, [&](const std::string& name) { return is_below(folder, name); });
}

std::vector<std::vector<std::string>> cycles(const std::map<std::string, std::set<std::string>>& edges) {
    std::vector<std::string> names;
    std::map<std::string, lts::StateIndex> number;
    const auto take = [&](const std::string& name) {
        const auto [place, fresh] = number.emplace(name, static_cast<lts::StateIndex>(names.size()));
        if (fresh) names.push_back(name);
        return place->second;
    };
    for (const auto& [node, targets] : edges) {
        take(node);
        for (const std::string& target : targets) take(target);
    }
    const lts::GraphView graph{names.size(), [&](lts::StateIndex node, std::vector<lts::StateIndex>& targets) {
                                   const auto found = edges.find(names[node]);
                                   if (found == edges.end()) return;
                                   for (const std::string& target : found->second) targets.push_back(number.at(target));
                               }};
    std::vector<lts::StateIndex> roots(names.size());
    std::iota(roots.begin(), roots.end(), lts::StateIndex{0});
    std::vector<std::vector<std::string>> result;
    lts::strong_components(graph, roots, [&](std::span<const lts::StateIndex> members, bool) {
        if (members.size() < 2) return;
        std::vector<std::string>& group = result.emplace_back();
        for (const lts::StateIndex member : members) group.push_back(names[member]);
        std::ranges::sort(group);
    });
    return result;
}

}  // namespace robochart::sanity
