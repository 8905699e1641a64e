// SPDX-License-Identifier: Apache-2.0
#include "app/command/rules.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include "checker/cspm/syntax/rules.hpp"
#include "checker/cspm/types/rules.hpp"
#include "claims/checks/rules.hpp"
#include "claims/sleec/checks/rules.hpp"
#include "claims/sleec/syntax/rules.hpp"
#include "claims/syntax/rules.hpp"
#include "conformance/model/rules.hpp"
#include "cpp_emit/plan/rules.hpp"
#include "cpp_emit/ros2/rules.hpp"
#include "csp_emit/base/rules.hpp"
#include "csp_emit/swarm/rules.hpp"
#include "driver/settings/rules.hpp"
#include "frontend/diagrams/stored/rules.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/syntax_rules.hpp"
#include "prism/checks/rules.hpp"
#include "prism/emit/rules.hpp"
#include "prism/explore/rules.hpp"
#include "prism/syntax/rules.hpp"
#include "semantics/rules.hpp"
#include "simulation/scenario/rules.hpp"

namespace robochart::app {
namespace {

std::string to_upper(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return result;
}

}  // namespace

std::vector<const diagnostics::Rule*> all_rules() {
    std::vector<const diagnostics::Rule*> all;
    const auto add = [&all](const auto& table) { all.insert(all.end(), std::begin(table), std::end(table)); };
    add(frontend::syntax::rule_list);
    add(frontend::rules::all);
    add(diagrams::rules::all);
    add(ir::rules::all);
    add(csp_emit::rules::all);
    add(csp_emit::swarm_rules::all);
    add(cpp_emit::rules::all);
    add(cpp_emit::ros2::rules::all);
    add(cspm::rules::all);
    add(cspm::types::rules::all);
    add(prism::rules::syntax);
    add(prism::rules::checks);
    add(prism::rules::explore);
    add(prism_emit::rules::all);
    add(claims::rules::syntax);
    add(claims::rules::checks);
    add(sleec::rules::syntax);
    add(sleec::rules::checks);
    add(simulation::rules::all);
    add(conformance::rules::all);
    add(driver::rules::all);
    add(rules::all);
    return all;
}

std::vector<std::string> codes_meant(std::string_view word) {
    const auto plain = [](std::string_view text) {
        std::string letters = to_upper(text);
        std::erase_if(letters, [](unsigned char c) { return std::isalnum(c) == 0; });
        return letters;
    };
    std::set<std::string> same, ending;
    for (const diagnostics::Rule* rule : all_rules()) {
        const std::string_view code = rule->code;
        if (to_upper(code) == to_upper(word)) return {std::string(code)};
        if (plain(code) == plain(word)) same.emplace(code);
        const std::size_t hyphen = code.rfind('-');
        if (hyphen != std::string_view::npos && plain(code.substr(hyphen)) == plain(word)) ending.emplace(code);
    }
    const std::set<std::string>& meant = same.empty() ? ending : same;
    return {meant.begin(), meant.end()};
}

std::vector<const diagnostics::Rule*> find_rules(std::string_view code) {
    std::vector<const diagnostics::Rule*> found;
    for (const diagnostics::Rule* rule : all_rules())
        if (to_upper(rule->code) == to_upper(code)) found.push_back(rule);
    return found;
}

}  // namespace robochart::app
