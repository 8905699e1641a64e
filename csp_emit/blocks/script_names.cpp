// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/blocks/script_names.hpp"

#include <algorithm>

#include "base/diagnostics/spelling.hpp"

namespace robochart::csp_emit {

namespace {

std::string qualify_name(const std::string& qualifier, const std::string& name) {
    return qualifier.empty() ? name : qualifier + "::" + name;
}

/// True if the channel has a direction: `channel e : InOut...`.
bool is_directed(const cspm::Decl& channel) {
    const cspm::Expr* type = channel.body.get();
    if (type != nullptr && type->kind == cspm::ExprKind::dot && !type->args.empty()) type = type->args.front().get();
    return type != nullptr && type->kind == cspm::ExprKind::name && type->text == "InOut";
}

}  // namespace

ScriptNames::ScriptNames(const cspm::Script& script) {
    for (const cspm::DeclPtr& decl : script.decls)
        if (decl->kind == cspm::DeclKind::module) modules_.emplace(decl->names.front(), decl.get());
    add(script.decls, "");
}

/// Adds the names that blocks can use: the exported names of a module, or all names of a module without exports.
void ScriptNames::add(const std::vector<cspm::DeclPtr>& decls, const std::string& qualifier) {
    for (const cspm::DeclPtr& decl : decls) {
        switch (decl->kind) {
            case cspm::DeclKind::timed:
                add(decl->decls, qualifier);
                break;
            case cspm::DeclKind::value:
                for (const auto& group : decl->patterns)
                    for (const cspm::PatternPtr& pattern : group)
                        if (pattern->kind == cspm::PatternKind::name)
                            names_.push_back({qualifier, pattern->text, decl->kind, false});
                break;
            case cspm::DeclKind::module: {
                const std::string& name = decl->names.front();
                names_.push_back({qualifier, name, decl->kind, false});
                modules_.emplace(qualify_name(qualifier, name), decl.get());
                const bool exports = !decl->exports.empty();
                add(exports ? decl->exports : decl->decls, qualify_name(qualifier, name));
                break;
            }
            case cspm::DeclKind::instance: {
                const std::string& name = decl->names.front();
                names_.push_back({qualifier, name, cspm::DeclKind::module, false});
                auto module = modules_.find(qualify_name(qualifier, decl->text));
                if (module == modules_.end()) module = modules_.find(decl->text);
                if (module == modules_.end()) break;
                const bool exports = !module->second->exports.empty();
                add(exports ? module->second->exports : module->second->decls, qualify_name(qualifier, name));
                break;
            }
            case cspm::DeclKind::function:
                if (names_.empty() || names_.back().name != decl->names.front() || names_.back().qualifier != qualifier)
                    names_.push_back({qualifier, decl->names.front(), decl->kind, false});
                break;
            case cspm::DeclKind::channel:
            case cspm::DeclKind::datatype:
            case cspm::DeclKind::subtype:
            case cspm::DeclKind::nametype:
                for (const std::string& name : decl->names)
                    names_.push_back(
                        {qualifier, name, decl->kind, decl->kind == cspm::DeclKind::channel && is_directed(*decl)});
                for (const cspm::Constructor& constructor : decl->constructors)
                    names_.push_back({qualifier, constructor.name, decl->kind, false});
                break;
            case cspm::DeclKind::transparent:
            case cspm::DeclKind::external:
            case cspm::DeclKind::annotation:
            case cspm::DeclKind::print:
            case cspm::DeclKind::assertion:
            case cspm::DeclKind::include:
                break;
        }
    }
}

std::vector<const ScriptName*> ScriptNames::names_after(std::string_view qualifier) const {
    std::vector<const ScriptName*> result;
    for (const ScriptName& name : names_)
        if (name.qualifier == qualifier) result.push_back(&name);
    return result;
}

std::vector<std::string> ScriptNames::suggest_names(std::string_view written) const {
    constexpr std::size_t most = 3;
    const std::size_t cut = written.rfind("::");
    const std::string qualifier(cut == std::string_view::npos ? "" : written.substr(0, cut));
    const std::string last(cut == std::string_view::npos ? written : written.substr(cut + 2));
    std::vector<std::string> result;
    const auto take = [&](const ScriptName& name) {
        const std::string text = qualify_name(name.qualifier, name.name) + (name.directed ? ".in" : "");
        if (result.size() < most && std::ranges::find(result, text) == result.end()) result.push_back(text);
    };
    // Entries with the same name in other modules. Modules of the model, which are outermost in a script, come first.
    std::vector<const ScriptName*> same;
    for (const ScriptName& name : names_)
        if (name.name == last && name.qualifier != qualifier && name.qualifier.find("__") == std::string::npos)
            same.push_back(&name);
    std::ranges::stable_sort(same, {}, [](const ScriptName* name) { return std::ranges::count(name->qualifier, ':'); });
    std::ranges::reverse(same);
    std::ranges::stable_sort(same, {}, [](const ScriptName* name) { return std::ranges::count(name->qualifier, ':'); });
    if (qualifier.empty())
        for (const ScriptName* name : same) take(*name);
    // Names with similar spelling in the same module or, if there are none, in any module.
    std::vector<std::string> near;
    for (const ScriptName* name : names_after(qualifier)) near.push_back(name->name);
    const std::string meant = diagnostics::nearest_spelling(last, near);
    for (const ScriptName* name : names_after(qualifier))
        if (!meant.empty() && name->name == meant) take(*name);
    if (!qualifier.empty() && result.empty())
        for (const ScriptName* name : same) take(*name);
    if (!result.empty() || !qualifier.empty()) return result;
    near.clear();
    for (const ScriptName& name : names_) near.push_back(name.name);
    const std::string anywhere = diagnostics::nearest_spelling(last, near);
    for (const ScriptName& name : names_)
        if (!anywhere.empty() && name.name == anywhere) take(name);
    return result;
}

}  // namespace robochart::csp_emit
