// SPDX-License-Identifier: Apache-2.0
#include "editors/server/features/csp_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "checker/cspm/syntax/lexer.hpp"
#include "csp_emit/blocks/check_blocks.hpp"
#include "csp_emit/blocks/script_names.hpp"

namespace robochart::lsp {

namespace {

using csp_emit::ScriptName;
using csp_emit::ScriptNames;

const frontend::CspBlock* block_at(const Target& target) {
    for (const frontend::CspBlock& block : target.project.tree_of(target.document).csp_blocks)
        if (block.text_span.begin <= target.offset && target.offset <= block.text_span.end) return &block;
    return nullptr;
}

std::optional<csp_emit::Emission> emission_for(const Session& session, const Target& target,
                                               const frontend::CspBlock& block) {
    const auto time = block.time == frontend::AssertionTime::untimed ? csp_emit::Time::untimed : csp_emit::Time::timed;
    return csp_emit::emission_without_blocks(target.project.current_model(), target.project.sources(),
                                             target.document.source, time, session.budget);
}

/// Returns the beginning of the qualified name (identifiers joined by `::`) that ends at an offset.
std::uint32_t begin_of_name(std::string_view text, std::uint32_t end) {
    std::uint32_t at = end;
    while (at > 0 && (cspm::continues_name(text[at - 1]) || text[at - 1] == ':')) --at;
    while (at < end && text[at] == ':') ++at;
    return at;
}

int item_kind(const ScriptName& name) {
    switch (name.kind) {  // CompletionItemKind (LSP 3.17)
        case cspm::DeclKind::module:
            return 9;
        case cspm::DeclKind::channel:
            return 23;
        case cspm::DeclKind::function:
        case cspm::DeclKind::value:
            return 3;
        case cspm::DeclKind::datatype:
        case cspm::DeclKind::subtype:
        case cspm::DeclKind::nametype:
        case cspm::DeclKind::instance:
        case cspm::DeclKind::timed:
        case cspm::DeclKind::transparent:
        case cspm::DeclKind::external:
        case cspm::DeclKind::annotation:
        case cspm::DeclKind::print:
        case cspm::DeclKind::assertion:
        case cspm::DeclKind::include:
            break;
    }
    return 13;
}

/// True for internal names, which are definitions of control states and numbers of transitions. `D__`, `VS_O__` and
/// similar names in capitals are not internal, because blocks use them.
bool is_inner(const std::string& name) {
    const bool small = std::ranges::any_of(name, [](char c) { return c >= 'a' && c <= 'z'; });
    return name.starts_with("TID") || (small && name.ends_with("__"));
}

std::string_view kind_text(cspm::DeclKind kind) {
    switch (kind) {
        case cspm::DeclKind::module:
            return "module";
        case cspm::DeclKind::channel:
            return "channel";
        case cspm::DeclKind::function:
        case cspm::DeclKind::value:
            return "definition";
        case cspm::DeclKind::datatype:
        case cspm::DeclKind::subtype:
        case cspm::DeclKind::nametype:
        case cspm::DeclKind::instance:
        case cspm::DeclKind::timed:
        case cspm::DeclKind::transparent:
        case cspm::DeclKind::external:
        case cspm::DeclKind::annotation:
        case cspm::DeclKind::print:
        case cspm::DeclKind::assertion:
        case cspm::DeclKind::include:
            break;
    }
    return "type";
}

}  // namespace

std::optional<Json> completion_in_block(const Session& session, const Target& target) {
    const frontend::CspBlock* const block = block_at(target);
    if (block == nullptr) return std::nullopt;
    const std::string_view text = target.project.sources().source_text(target.document.source);
    const std::uint32_t begin = begin_of_name(text, target.offset);
    const std::string_view written = text.substr(begin, target.offset - begin);
    const std::size_t cut = written.rfind("::");
    const std::string qualifier(cut == std::string_view::npos ? "" : written.substr(0, cut));
    const auto prefix = static_cast<std::uint32_t>(begin + (cut == std::string_view::npos ? 0 : cut + 2));
    const Json edited =
        lsp_range(target.project.sources(), {target.document.source, prefix, target.offset}, session.client.encoding);
    Json items = Json::array();
    std::set<std::string> seen;
    const auto add = [&](const std::string& label, int kind, const std::string& detail) {
        if (!seen.insert(label).second) return;
        items.push_back(Json::object({{"label", label},
                                      {"kind", kind},
                                      {"detail", detail},
                                      {"textEdit", Json::object({{"range", edited}, {"newText", label}})}}));
    };
    if (const auto emission = emission_for(session, target, *block)) {
        const ScriptNames names(emission->definitions);
        const bool field = qualifier.empty() && begin > 0 && text[begin - 1] == '.';
        if (field) {
            const std::uint32_t channel = begin_of_name(text, begin - 1);
            const std::string_view full = text.substr(channel, begin - 1 - channel);
            for (const ScriptName& name : names.all()) {
                const std::string own = name.qualifier.empty() ? name.name : name.qualifier + "::" + name.name;
                if (name.directed && own == full)
                    for (const char* direction : {"in", "out"}) add(direction, 20, "direction of an event");
            }
        } else {
            for (const ScriptName* name : names.names_after(qualifier))
                if (!is_inner(name->name)) add(name->name, item_kind(*name), std::string(kind_text(name->kind)));
        }
    }
    return Json::object({{"isIncomplete", false}, {"items", std::move(items)}});
}

std::optional<Hover> hover_in_block(const Session& session, const Target& target) {
    const frontend::CspBlock* const block = block_at(target);
    if (block == nullptr) return std::nullopt;
    const std::string_view text = target.project.sources().source_text(target.document.source);
    std::uint32_t end = target.offset;
    while (end < text.size() && (cspm::continues_name(text[end]) || (text[end] == ':' && end + 1 < text.size() &&
                                                                     (text[end + 1] == ':' || text[end - 1] == ':'))))
        ++end;
    const std::uint32_t begin = begin_of_name(text, end);
    const std::string full(text.substr(begin, end - begin));
    const bool markdown = session.client.markdown;
    std::string out;
    if (const auto emission = full.empty() ? std::nullopt : emission_for(session, target, *block)) {
        const ScriptNames names(emission->definitions);
        for (const ScriptName& name : names.all()) {
            const std::string own = name.qualifier.empty() ? name.name : name.qualifier + "::" + name.name;
            if (own != full || !out.empty()) continue;
            out = fmt::format(fmt::runtime(markdown ? "```cspm\n{} {}\n```" : "{} {}"), kind_text(name.kind), own);
        }
        for (const char* direction : {"", ".in", ".out"})
            if (const auto meaning = emission->provenance.events.find(full + direction);
                meaning != emission->provenance.events.end() && !meaning->second.text.empty())
                out += fmt::format("\n\n{}{}: {}", full, direction, meaning->second.text);
    }
    return Hover{std::move(out), {target.document.source, begin, end}};
}

}  // namespace robochart::lsp
