// SPDX-License-Identifier: Apache-2.0
// Makes a script with the blocks and a script without them, and compares the texts of their definitions.
#include "driver/model/block_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "checker/cspm/syntax/reader.hpp"
#include "counterexample/values.hpp"
#include "csp_emit/emit.hpp"
#include "csp_emit/expressions/expressions.hpp"
#include "semantics/ir/own_constants.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::driver {
namespace {

/// The top-level definitions of a script, as text.
class Definitions {
public:
    explicit Definitions(const cspm::Script& script) {
        for (const cspm::DeclPtr& decl : script.decls) {
            if (decl->kind == cspm::DeclKind::value &&
                decl->patterns.front().front()->kind == cspm::PatternKind::name) {
                const std::string& name = decl->patterns.front().front()->text;
                values_.emplace(name, decl->body);
                if (decl->span.is_known()) written_.insert(name);
            }
            if (decl->kind == cspm::DeclKind::function) functions_[decl->names.front()] += cspm::print(*decl) + "\n";
        }
    }

    /// Returns the value of a constant; "" if it is not defined. If it is defined as another constant, returns the
    /// value of the other constant.
    [[nodiscard]] std::string constant_value(std::string name) const {
        std::set<std::string> followed;
        for (auto at = values_.find(name); at != values_.end(); at = values_.find(name)) {
            const bool again = !followed.insert(name).second;
            if (again || at->second->kind != cspm::ExprKind::name || !values_.contains(at->second->text))
                return cspm::print(at->second);
            name = at->second->text;
        }
        return "";
    }
    /// True if the user wrote the definition. Generated definitions have no place.
    [[nodiscard]] bool is_written(const std::string& name) const { return written_.contains(name); }
    [[nodiscard]] std::string function_value(const std::string& name) const {
        const auto at = functions_.find(name);
        return at == functions_.end() ? "" : at->second;
    }

private:
    std::map<std::string, cspm::ExprPtr> values_;
    std::set<std::string> written_;
    std::map<std::string, std::string> functions_;
};

/// Lists the constants with different values. If all constants with the same last part of the name have the same
/// values, this last part represents them. Otherwise, the path of each constant is shown.
std::vector<std::string> constants_unlike(const Project& project, const Definitions& here, const Definitions& there) {
    const auto own = ir::own_constants(project.system);
    std::vector<std::pair<std::string, std::string>> unlike;  // path of a constant, and a text with both values
    std::map<std::string, std::set<std::string>> of_name;  // for each name, the values of the constants with this name
    const auto last = [](const std::string& path) { return path.substr(path.rfind(':') + 1); };
    for (const ir::NamedConstant& constant : ir::named_constants(project.system)) {
        const auto shown = [&](const std::string& text) {
            return runs::value_text(project.system, project.instantiation, constant.type, text);
        };
        // If a block defines the machine's own constant, that value applies in controllers that run the machine.
        const auto machines = own.find(constant.name);
        const bool of_machine = machines != own.end() && there.is_written(machines->second);
        const std::string& deciding = of_machine ? machines->second : constant.name;
        const std::string ours = here.constant_value(constant.name), theirs = there.constant_value(deciding);
        const bool same = ours == theirs || ours.empty() || theirs.empty();
        std::string both = same ? "" : fmt::format("{} (there {})", shown(ours), shown(theirs));
        of_name[last(constant.path)].insert(both);
        if (!same) unlike.emplace_back(constant.path, std::move(both));
    }
    std::vector<std::string> result;
    for (const auto& [path, both] : unlike) {
        const std::string name = last(path);
        std::string text = fmt::format("{} = {}", of_name[name].size() == 1 ? name : path, both);
        if (std::ranges::find(result, text) == result.end()) result.push_back(std::move(text));
    }
    return result;
}

}  // namespace

std::string values_unlike_blocks(const Project& project, const cspm::Script& without_blocks) {
    const auto replaces = [](const ir::CspBlock& block) { return block.timed && ir::is_instantiations(block); };
    const auto& blocks = project.system.csp_blocks;
    if (std::ranges::none_of(blocks, replaces)) return "";
    diagnostics::Diagnostics unread;  // findings in blocks are reported when assertions are decided
    const csp_emit::Emission with_blocks =
        csp_emit::emit(project.system, project.instantiation, csp_emit::Time::timed, {}, project.sources, unread);
    const Definitions here(without_blocks), there(with_blocks.definitions);
    std::vector<std::string> unlike = constants_unlike(project, here, there);
    for (const ir::Function& function : project.system.functions) {
        const std::string name = csp_emit::function_name(function);
        const std::string ours = here.function_value(name), theirs = there.function_value(name);
        if (!ours.empty() && !theirs.empty() && ours != theirs) unlike.push_back(fmt::format("{}(...)", function.name));
    }
    return fmt::format("{}", fmt::join(unlike, ", "));
}

}  // namespace robochart::driver
