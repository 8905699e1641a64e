// SPDX-License-Identifier: Apache-2.0
#include "editors/server/cspm/symbols.hpp"

#include <map>

#include "checker/cspm/syntax/reader.hpp"
#include "editors/server/cspm/places.hpp"

namespace robochart::lsp {

namespace {

using cspm::Decl;
using cspm::DeclPtr;

/// An entry of the outline with its inner entries.
struct Entry {
    std::string name;
    std::string detail;
    int kind = 0;
    Span whole;
    Span place;
    std::vector<Entry> inside;
};

namespace kinds {  // SymbolKind (LSP 3.17)
constexpr int module = 2;
constexpr int type = 5;
constexpr int enumeration = 10;
constexpr int function = 12;
constexpr int variable = 13;
constexpr int boolean = 17;
constexpr int member = 22;
constexpr int event = 24;
}  // namespace kinds

/// Makes the entries of one text.
class Outline {
public:
    Outline(const ScriptReading& reading, SourceId source) : reading_(reading), source_(source) {
        for (const cspm::KnownName& known_name : reading.names.names)
            if (known_name.span.source == source)
                types_.emplace(std::pair(known_name.span.begin, known_name.name), &known_name.type);
    }

    std::vector<Entry> list_entries(const std::vector<DeclPtr>& decls, const std::string& prefix) {
        std::vector<Entry> result;
        for (const DeclPtr& decl : decls)
            if (decl->span.source == source_) add(*decl, prefix, result);
        return result;
    }

private:
    Entry make_entry(const std::string& name, const std::string& prefix, int kind, Span whole,
                     std::string detail = {}) {
        Entry made{name, std::move(detail), kind, whole, name_place(reading_.sources, whole, name), {}};
        const auto type = types_.find({whole.begin, prefix + name});
        if (type != types_.end() && !type->second->empty()) made.detail = *type->second;
        return made;
    }

    void add(const Decl& decl, const std::string& prefix, std::vector<Entry>& out) {
        switch (decl.kind) {
            case cspm::DeclKind::function:
                if (!out.empty() && out.back().kind == kinds::function && out.back().name == decl.names.at(0))
                    out.back().whole = diagnostics::join_spans(out.back().whole, decl.span);
                else
                    out.push_back(make_entry(decl.names.at(0), prefix, kinds::function, decl.span));
                break;
            case cspm::DeclKind::value:
                add_pattern(*decl.patterns.at(0).at(0), decl.span, prefix, out);
                break;
            case cspm::DeclKind::channel:
                for (const std::string& name : decl.names)
                    out.push_back(make_entry(name, prefix, kinds::event, decl.span, "channel"));
                break;
            case cspm::DeclKind::datatype:
            case cspm::DeclKind::subtype:
                add_datatype(decl, prefix, out);
                break;
            case cspm::DeclKind::nametype:
                out.push_back(make_entry(decl.names.at(0), prefix, kinds::type, decl.span));
                break;
            case cspm::DeclKind::module:
                add_module(decl, prefix, out);
                break;
            case cspm::DeclKind::instance:
                out.push_back(
                    make_entry(decl.names.at(0), prefix, kinds::module, decl.span, "instance of " + decl.text));
                break;
            case cspm::DeclKind::timed:
                for (Entry& entry : list_entries(decl.decls, prefix)) out.push_back(std::move(entry));
                break;
            case cspm::DeclKind::assertion:
                add_assertion(decl, out);
                break;
            case cspm::DeclKind::transparent:
            case cspm::DeclKind::external:
            case cspm::DeclKind::annotation:
            case cspm::DeclKind::print:
            case cspm::DeclKind::include:
                break;
        }
    }

    void add_pattern(const cspm::Pattern& pattern, Span whole, const std::string& prefix, std::vector<Entry>& out) {
        if (pattern.kind == cspm::PatternKind::name) {
            Entry made{pattern.text, {}, kinds::variable, whole, pattern.span, {}};
            const auto type = types_.find({pattern.span.begin, prefix + pattern.text});
            if (type != types_.end()) made.detail = *type->second;
            out.push_back(std::move(made));
        }
        for (const cspm::PatternPtr& argument : pattern.args) this->add_pattern(*argument, whole, prefix, out);
    }

    void add_datatype(const Decl& decl, const std::string& prefix, std::vector<Entry>& out) {
        Entry made = make_entry(decl.names.at(0), prefix, kinds::enumeration, decl.span);
        for (const cspm::Constructor& constructor : decl.constructors)
            made.inside.push_back(make_entry(constructor.name, prefix, kinds::member, constructor.span));
        out.push_back(std::move(made));
    }

    void add_module(const Decl& decl, const std::string& prefix, std::vector<Entry>& out) {
        Entry made = make_entry(decl.names.at(0), prefix, kinds::module, decl.span, "module");
        const std::string inside = prefix + decl.names.at(0) + "::";
        made.inside = list_entries(decl.decls, inside);
        for (Entry& entry : list_entries(decl.exports, inside)) made.inside.push_back(std::move(entry));
        out.push_back(std::move(made));
    }

    void add_assertion(const Decl& decl, std::vector<Entry>& out) {
        constexpr std::size_t longest = 120;
        const std::string_view text = reading_.sources.source_text(source_);
        std::string name(text.substr(decl.span.begin, decl.span.end - decl.span.begin));
        name = name.substr(0, name.find('\n'));
        if (name.size() > longest) name = name.substr(0, longest);
        out.push_back({name, "assertion", kinds::boolean, decl.span, decl.span, {}});
    }

    const ScriptReading& reading_;
    SourceId source_;
    std::map<std::pair<std::uint32_t, std::string>, const std::string*> types_;
};

Json symbol_of_entry(const PositionTable& positions, const Entry& entry) {
    Json result = Json::object({{"name", entry.name},
                                {"detail", entry.detail},
                                {"kind", entry.kind},
                                {"range", positions.lsp_range(entry.whole)},
                                {"selectionRange", positions.lsp_range(entry.place)}});
    Json children = Json::array();
    for (const Entry& child : entry.inside) children.push_back(symbol_of_entry(positions, child));
    if (!children.empty()) result["children"] = std::move(children);
    return result;
}

/// Adds an entry and its inner entries to a flat list.
void add_flat(const PositionTable& positions, const Entry& entry, const std::string& container, const std::string& uri,
              Json& out) {
    out.push_back(Json::object({{"name", entry.name},
                                {"kind", entry.kind},
                                {"location", Json::object({{"uri", uri}, {"range", positions.lsp_range(entry.place)}})},
                                {"containerName", container}}));
    for (const Entry& child : entry.inside) add_flat(positions, child, entry.name, uri, out);
}

}  // namespace

Json script_symbols(const ScriptReading& reading, SourceId source, const std::string& uri, Encoding encoding,
                    bool hierarchical) {
    Json result = Json::array();
    const PositionTable positions(reading.sources, source, encoding);
    for (const Entry& entry : Outline(reading, source).list_entries(reading.script.decls, {})) {
        if (hierarchical)
            result.push_back(symbol_of_entry(positions, entry));
        else
            add_flat(positions, entry, {}, uri, result);
    }
    return result;
}

}  // namespace robochart::lsp
