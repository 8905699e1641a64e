// SPDX-License-Identifier: Apache-2.0
// See stored_diagrams.hpp.
#include "frontend/diagrams/stored/stored_diagrams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "frontend/diagrams/stored/component_reader.hpp"
#include "frontend/diagrams/stored/rules.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::diagrams {

using namespace frontend;
namespace fs = std::filesystem;

namespace {

/// Returns the folder of a path: "" or ending with "/".
std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

/// Returns the innermost folder that contains both.
std::string common_folder(const std::string& a, const std::string& b) {
    const auto [end, other] = std::ranges::mismatch(a, b);
    return folder_of(std::string(a.begin(), end));
}

/// Returns the folders that may contain diagrams, sorted by name.
std::set<std::string> folders_of(const Model& model, const diagnostics::SourceManager& sources) {
    std::set<std::string> folders;
    std::optional<std::string> common;
    for (const auto& file : model.files) {
        if (file->is_library || file->is_assertions) continue;
        const std::string folder = folder_of(sources.path(file->source));
        common = common ? common_folder(*common, folder) : folder;
        folders.insert(folder);
    }
    if (common) folders.insert(*common);
    return folders;
}

/// The names of the missing parts of a diagram, as many as fit into a sentence.
class Missing {
public:
    explicit Missing(const StoredLayout& layout) : layout_(layout) {}

    std::string describe_missing(const Declaration& component) {
        if (const auto* machine = dynamic_cast<const Machine*>(&component)) add_inside(*machine);
        if (const auto* parts = dynamic_cast<const Component*>(&component)) {
            for (const Declaration* part : parts->order)
                if (!layout_.boxes.contains(part)) add(*part);
            for (const auto& connection : parts->connections)
                if (!layout_.lines.contains(connection.get())) ++connections_;
        }
        if (connections_ > 0) name(fmt::format("{} connection{}", connections_, connections_ == 1 ? "" : "s"));
        constexpr std::size_t most = 4;
        if (count_ > most) names_ += fmt::format(" and {} more", count_ - most);
        return names_;
    }

private:
    void name(const std::string& what) {
        constexpr std::size_t most = 4;
        if (++count_ <= most) names_ += (names_.empty() ? "" : ", ") + what;
    }
    void add(const Declaration& it) {
        name(fmt::format("{} {}", to_text(it.kind), diagnostics::escape_for_display(it.name)));
    }
    void add_inside(const NodeContainer& container) {
        for (const auto& node : container.nodes) {
            if (!layout_.boxes.contains(node.get())) add(*node);
            add_inside(*node);
        }
        for (const auto& transition : container.transitions)
            if (!layout_.lines.contains(transition.get())) add(*transition);
    }

    const StoredLayout& layout_;
    std::string names_;
    std::size_t count_ = 0;
    std::size_t connections_ = 0;
};

/// Returns the contents of the file, which are empty if it does not exist or cannot be read. An unreadable file is
/// reported.
Aird read_file(const std::string& path, diagnostics::SourceManager& sources, diagnostics::Diagnostics& out) {
    std::error_code error;
    if (!fs::exists(fs::symlink_status(path, error))) return {};
    const auto refuse = [&](diagnostics::Span span, const std::string& why) {
        out.report(rules::unreadable_diagrams, span,
                   {diagnostics::escape_for_display(path), diagnostics::escape_for_display(why)});
        return Aird();
    };
    if (const auto size = fs::file_size(path, error); !error && size > longest_aird)
        return refuse({}, fmt::format("it is longer than {} MiB", longest_aird >> 20U));
    std::string why;
    const auto source = sources.load_file(path, why);
    if (!source) return refuse({}, why);
    Aird aird = read_aird(sources.source_text(*source), out.budget());
    return aird.error.empty() ? aird : refuse({*source, aird.offset, aird.offset}, aird.error);
}

}  // namespace

void StoredDiagrams::read(const Model& model, diagnostics::SourceManager& sources, diagnostics::Diagnostics& out) {
    for (const std::string& folder : folders_of(model, sources)) {
        const std::string path = folder + std::string(aird_file);
        const auto [at, fresh] = files_.try_emplace(path);
        if (fresh) at->second = read_file(path, sources, out);
        add(at->second, path, model, sources, out.budget());
    }
}

StoredDiagrams::StoredDiagrams(const Model& model, const diagnostics::SourceManager& sources, AirdFiles& files,
                               diagnostics::Budget* budget) {
    for (const std::string& folder : folders_of(model, sources)) {
        const std::string path = folder + std::string(aird_file);
        if (const Aird* aird = files.read(path, budget)) add(*aird, path, model, sources, budget);
    }
}

void StoredDiagrams::add(const Aird& aird, const std::string& path, const Model& model,
                         const diagnostics::SourceManager& sources, diagnostics::Budget* budget) {
    const Fragments fragments(model, sources, folder_of(path));
    for (const AirdDiagram& diagram : aird.diagrams)
        for (auto& [component, read] : read_components(diagram, fragments, budget)) {
            read.file = path;
            const auto [at, fresh] = diagrams_.try_emplace(component, read);
            StoredDiagram& known = at->second;
            if (!fresh && read.found * known.elements > known.found * read.elements) known = std::move(read);
        }
}

const StoredDiagram* StoredDiagrams::diagram_of(const Declaration* component) const {
    const auto at = diagrams_.find(component);
    return at == diagrams_.end() ? nullptr : &at->second;
}

const StoredLayout* StoredDiagrams::find(const Declaration* component) const {
    const StoredDiagram* found = diagram_of(component);
    return found != nullptr && found->fits_model() ? &found->layout : nullptr;
}

void StoredDiagrams::explain_mismatch(const Declaration* component, diagnostics::Diagnostics& out) const {
    const StoredDiagram* found = diagram_of(component);
    if (found == nullptr || !found->is_drawn()) return;
    const std::string name =
        fmt::format("{} {}", to_text(component->kind), diagnostics::escape_for_display(component->name));
    const std::string file = diagnostics::escape_for_display(found->file);
    if (!found->fits_model())
        out.report(rules::other_diagram, component->name_span,
                   {name, file, std::to_string(found->elements), std::to_string(found->found)});
    else if (const std::string missing = Missing(found->layout).describe_missing(*component); !missing.empty())
        out.report(rules::incomplete_diagram, component->name_span, {name, file, missing});
}

}  // namespace robochart::diagrams
