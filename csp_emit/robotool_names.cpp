// Generators of 2021 and 2022 had an event `moveRet` where a call of `move` ends, and `enteredV.SID_s` where a state is
// entered; today's, whose names the script has, are read off scripts of 2024 and 2026 (docs/semantics.md).
#include "csp_emit/robotool_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include "csp_emit/base/rules.hpp"
#include "csp_emit/passes/liveness.hpp"

namespace robochart::csp_emit {
namespace {

/// Channels by which RoboTool's processes of states and transitions run together.
constexpr std::array<std::string_view, 9> inner = {"MachineBody", "Memory",  "enter",      "exit",    "exited",
                                                   "interrupt",   "share__", "internal__", "entered_"};

class NameCheck {
public:
    NameCheck(const Project& project, const std::map<std::string, ComponentEmission>& components)
        : project_(project), components_(components) {}

    void decls(const std::vector<cspm::DeclPtr>& all) {
        for (const cspm::DeclPtr& decl : all) {
            if (decl->body) expr(*decl->body);
            decls(decl->decls);
        }
    }

private:
    void expr(const cspm::Expr& each) {
        if (each.kind == cspm::ExprKind::name) name(each);
        for (const cspm::DeclPtr& decl : each.decls)
            if (decl->body) expr(*decl->body);
        for (const cspm::Link& link : each.links)
            for (const cspm::ExprPtr& end : {link.from, link.to})
                if (end) expr(*end);
        for_each_part(each, [&](const cspm::Expr& part) { expr(part); });
    }

    /// `COMPONENT::LAST`, or `COMPONENT::STATE::LAST`.
    void name(const cspm::Expr& each) {
        const std::size_t end = each.text.rfind("::");
        if (end == std::string::npos) return;
        const std::string last = each.text.substr(end + 2);
        std::string path = each.text.substr(0, end);
        auto component = components_.find(path);
        const bool direct = component != components_.end();
        while (component == components_.end()) {
            const std::size_t above = path.rfind("::");
            if (above == std::string::npos) return;
            path.resize(above);
            component = components_.find(path);
        }
        if (has(component->second, last)) return;
        const std::string instead = direct ? of_component(component->second, path, last) : "";
        if (!instead.empty()) return report(each, instead);
        if (std::find(inner.begin(), inner.end(), last) != inner.end())
            report(each,
                   "is inside a machine there; here each machine is one sequential process, of which its events, "
                   "calls, writes and the states entered can be seen");
    }

    static bool has(const ComponentEmission& component, const std::string& channel) {
        const std::vector<std::string>& visible = component.visible;
        return std::find(visible.begin(), visible.end(), channel) != visible.end();
    }

    static std::string of_component(const ComponentEmission& component, const std::string& path,
                                    const std::string& last) {
        if (last == "enteredV")
            return fmt::format(
                "is of an older generator; today each state has an event of its own, {}::STATE::entered, "
                "which the processes VS__ and VS_O__ show",
                path);
        constexpr std::string_view returned = "Ret";
        if (last.ends_with(returned) && has(component, last.substr(0, last.size() - returned.size()) + "Call"))
            return "is of an older generator; today a call is one event, and nothing is seen of its return: leave it "
                   "out";
        return "";
    }

    void report(const cspm::Expr& each, const std::string& what) {
        if (std::find(reported_.begin(), reported_.end(), each.text) != reported_.end()) return;
        reported_.push_back(each.text);
        project_.diagnostics.report(rules::name_of_robotool, each.span, {each.text, what});
    }

    const Project& project_;
    const std::map<std::string, ComponentEmission>& components_;
    std::vector<std::string> reported_;
};

}  // namespace

void check_robotool_names(const Project& project, const std::map<std::string, ComponentEmission>& components,
                          const std::vector<cspm::DeclPtr>& decls) {
    NameCheck(project, components).decls(decls);
}

}  // namespace robochart::csp_emit
