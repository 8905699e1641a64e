// SPDX-License-Identifier: Apache-2.0
// Maps old names in CSP blocks to current names, which are those of RoboTool's scripts of 2024 and 2026
// (docs/semantics.md). Generators of 2021 and 2022 had no modules. For `P::S::e`, `P::S::O__` and `P::S::moveCall` they
// wrote `S_e`, `S_O` and `S_moveCall`; They also had an event `moveRet` at the end of a call of `move`, and an event
// `enteredV.SID_s` for the entry of a state. A later generation had modules for components, but none for packages.
#include "csp_emit/robotool_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string_view>

#include "checker/cspm/syntax/rename.hpp"
#include "csp_emit/base/names.hpp"
#include "csp_emit/base/rules.hpp"
#include "csp_emit/base/user_names.hpp"
#include "csp_emit/passes/liveness.hpp"

namespace robochart::csp_emit {
namespace {

/// The channels on which RoboTool's processes of states and transitions synchronise.
constexpr std::array<std::string_view, 9> inner = {"MachineBody", "Memory",  "enter",      "exit",    "exited",
                                                   "interrupt",   "share__", "internal__", "entered_"};

constexpr std::string_view separator = "::";

std::string last_of(const std::string& path) {
    const std::size_t end = path.rfind(separator);
    return end == std::string::npos ? path : path.substr(end + separator.size());
}

std::string first_of(const std::string& path) {
    return path.substr(0, path.find(separator));
}

bool is_any(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

/// The current name for a name of an older generator, or the reason why there is none.
struct OldName {
    std::string now;
    std::string instead;
    bool left_out = false;  ///< an event that no longer exists
};

const char* const no_return =
    "belongs to an older generator; a call is now one event, and its return is not visible: remove it";

/// Returns the current name for `COMPONENT_LAST` or `COMPONENT::LAST`.
std::optional<OldName> of_component(const ComponentEmission& component, const std::string& path,
                                    const std::string& last) {
    constexpr std::string_view returned = "Ret";
    if (last == "enteredV")
        return OldName{{},
                       fmt::format("is of an older generator; today each state has an event of its own, "
                                   "{}::STATE::entered, which the processes VS__ and VS_O__ show",
                                   path)};
    if (last.ends_with(returned) && is_any(component.visible, last.substr(0, last.size() - returned.size()) + "Call"))
        return OldName{{}, no_return, true};
    return std::nullopt;
}

class NameCheck {
public:
    NameCheck(const Project& project, const std::map<std::string, ComponentEmission>& components,
              std::set<std::string> declared)
        : project_(project), components_(components), declared_(std::move(declared)) {
        for (const auto& [path, component] : components_) declared_.insert(first_of(path));
    }

    void check_declarations(const std::vector<cspm::DeclPtr>& all) {
        for (const cspm::DeclPtr& decl : all) {
            if (decl->body) check_expression(*decl->body);
            check_declarations(decl->decls);
            check_declarations(decl->exports);
        }
    }

private:
    void check_expression(const cspm::Expr& expr) {
        if (expr.kind == cspm::ExprKind::name) check_name(expr);
        if (expr.kind == cspm::ExprKind::prefix && left_out(expr)) return check_expression(*expr.args.at(1));
        for (const cspm::DeclPtr& decl : expr.decls)
            if (decl->body) check_expression(*decl->body);
        for (const cspm::Link& link : expr.links)
            for (const cspm::ExprPtr& end : {link.from, link.to})
                if (end) check_expression(*end);
        for_each_part(expr, [&](const cspm::Expr& part) { check_expression(part); });
    }

    /// True if the prefix has the form `S::moveRet -> P`, which current scripts write as P.
    bool left_out(const cspm::Expr& prefix) {
        const cspm::Expr& event = *prefix.args.at(0);
        if (event.kind != cspm::ExprKind::name || !prefix.fields.empty()) return false;
        const std::optional<OldName> old = old_name(event.text);
        if (!old || !old->left_out) return false;
        const diagnostics::Span rest = prefix.args.at(1)->span;
        diagnostics::Diagnostic& finding = report_name(event, old->instead);
        finding.fixes.push_back({{event.span.source, event.span.begin, rest.begin}, "", "leave out"});
        return true;
    }

    void check_name(const cspm::Expr& name) {
        if (const std::optional<OldName> old = old_name(name.text)) {
            if (old->now.empty()) {
                report_name(name, old->instead);
                return;
            }
            report_name(name, fmt::format("belongs to an older generator; its name is now {}", old->now))
                .fixes.push_back({name.span, old->now, "today's name"});
            return;
        }
        const auto component = component_around(name.text);
        if (component == components_.end()) return;
        const std::string last = last_of(name.text);
        if (!is_any(component->second.visible, last) && std::ranges::find(inner, last) != inner.end())
            report_name(name,
                        "is inside a machine there; in this script each machine is one sequential process, which shows "
                        "only its events, calls, writes and entered states");
    }

    using Component = std::map<std::string, ComponentEmission>::const_iterator;

    /// Returns the innermost component that contains a qualified name.
    [[nodiscard]] Component component_around(const std::string& name) const {
        for (std::size_t end = name.rfind(separator); end != std::string::npos && end > 0;
             end = name.rfind(separator, end - 1))
            if (const auto found = components_.find(name.substr(0, end)); found != components_.end()) return found;
        return components_.end();
    }

    [[nodiscard]] std::optional<OldName> old_name(const std::string& name) const {
        const std::size_t end = name.rfind(separator);
        if (end == std::string::npos) return declared_.contains(name) ? std::nullopt : find_flattened(name);
        const auto component = components_.find(name.substr(0, end));
        if (component != components_.end())
            return is_any(component->second.visible, last_of(name))
                       ? std::nullopt
                       : of_component(component->second, component->first, last_of(name));
        return declared_.contains(first_of(name)) ? std::nullopt : without_package(name);
    }

    /// Maps `S_e` to `P::S::e`. If the name may belong to several components, takes the outermost one, provided that it
    /// is unique.
    [[nodiscard]] std::optional<OldName> find_flattened(const std::string& name) const {
        std::optional<OldName> found;
        std::size_t depth = 0;
        bool several = false;
        for (const auto& [path, component] : components_) {
            const std::optional<OldName> old = find_flattened(name, path, component);
            if (!old) continue;
            const std::size_t deep = depth_of(path);
            several = found && deep == depth;
            if (found && deep >= depth) continue;
            found = old;
            depth = deep;
        }
        return several ? std::nullopt : found;
    }
    static std::optional<OldName> find_flattened(const std::string& name, const std::string& path,
                                                 const ComponentEmission& component) {
        for (const std::string& prefix : {flatten_name(path), last_of(path)}) {
            if (!name.starts_with(prefix + "_")) continue;
            const std::string last = name.substr(prefix.size() + 1);
            const std::string now = path + std::string(separator);
            if (is_any(component.visible, last)) return OldName{now + last, {}};
            if (auto old = of_component(component, path, last)) return old;
            const std::string process = last.ends_with("__") ? last : last + "__";
            if (user_names(component.module->exports).all.contains(process)) return OldName{now + process, {}};
        }
        return std::nullopt;
    }
    /// Maps `S::e` to `P::S::e`.
    [[nodiscard]] std::optional<OldName> without_package(const std::string& name) const {
        std::set<std::string> found;
        for (const auto& [path, component] : components_) {
            const std::size_t package = path.find(separator);
            if (package == std::string::npos) continue;
            const std::string inside = path.substr(package + separator.size());
            if (inside.find(separator) == std::string::npos && first_of(name) == inside)
                found.insert(path.substr(0, package));
        }
        if (found.size() != 1) return std::nullopt;
        return OldName{*found.begin() + std::string(separator) + name, {}};
    }

    static std::size_t depth_of(const std::string& path) {
        std::size_t depth = 0;
        for (std::size_t at = path.find(separator); at != std::string::npos; at = path.find(separator, at + 2)) ++depth;
        return depth;
    }

    diagnostics::Diagnostic& report_name(const cspm::Expr& name, const std::string& what) {
        return project_.diagnostics.report(rules::name_of_robotool, name.span, {name.text, what});
    }

    const Project& project_;
    const std::map<std::string, ComponentEmission>& components_;
    std::set<std::string> declared_;  ///< names declared in the script, and the packages
};

}  // namespace

void check_robotool_names(const Project& project, const std::map<std::string, ComponentEmission>& components,
                          const std::vector<cspm::DeclPtr>& definitions, const std::vector<cspm::DeclPtr>& decls) {
    std::set<std::string> declared = user_names(definitions).all;
    declared.merge(user_names(decls).all);
    declared.merge(cspm::bound_names(decls));
    NameCheck(project, components, std::move(declared)).check_declarations(decls);
}

std::string name_of_carrier(const std::string& name) {
    constexpr std::array<std::string_view, 5> carriers{"nat", "int", "real", "boolean", "string"};
    return std::ranges::find(carriers, name) == carriers.end() ? "" : "core_" + name;
}

}  // namespace robochart::csp_emit
