// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/probability_basis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "base/diagnostics/budget.hpp"
#include "counterexample/values.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::driver {

WatchedProcess::WatchedProcess(const Project& project, const SearchContext& search, const csp_emit::Emission& emission,
                               const ir::Instantiation& instantiation, cspm::Session& session)
    : emission_(emission),
      instantiation_(instantiation),
      watch_(project, emission, instantiation),
      reached_(project, emission, instantiation, search) {
    session.set_observer(watch_.observer());
}

const Basis& WatchedProcess::reached_bounds(const std::string& component) {
    if (!bounds_) bounds_ = watch_.met_bounds().empty() ? Basis() : find_bounds(component);
    return *bounds_;
}

Basis WatchedProcess::find_bounds(const std::string& component) {
    const auto process = std::ranges::find(emission_.components, component, &csp_emit::ComponentProcesses::path);
    try {
        if (process != emission_.components.end())
            return reached_.basis_of_process(process->process, watch_.met_bounds());
    } catch (const diagnostics::LimitReached&) {
        // The answer is already known, so the limit affects only the basis.
    }
    Basis result;
    for (Ground ground : watch_.met_bounds()) {
        ground.text += " (it is not known whether a run reaches it)";
        add(result, std::move(ground));
    }
    return result;
}

void RowBasis::add_row(const probability::Row& row, const Basis& basis) {
    ++rows_;
    std::vector<std::string> constants;
    for (const auto& [name, value] : row.constants) constants.push_back(name + "=" + value);
    for (const Ground& ground : basis) {
        auto entry = std::ranges::find(entries_, ground, &Entry::ground);
        if (entry == entries_.end()) entry = entries_.insert(entry, {ground, {}});
        entry->rows.push_back(fmt::format("{}", fmt::join(constants, ", ")));
    }
}

Basis RowBasis::basis() const {
    constexpr std::size_t listed = 3;
    Basis result;
    for (const Entry& entry : entries_) {
        Ground ground = entry.ground;
        if (entry.rows.size() < rows_) {
            const std::size_t shown = std::min(listed, entry.rows.size());
            const std::vector<std::string> first(entry.rows.begin(),
                                                 entry.rows.begin() + static_cast<std::ptrdiff_t>(shown));
            ground.text += fmt::format(" (with {}", fmt::join(first, "; "));
            if (shown < entry.rows.size()) ground.text += fmt::format("; and {} more", entry.rows.size() - shown);
            ground.text += ")";
        }
        add(result, std::move(ground));
    }
    return result;
}

namespace {

/// Returns a scalar value as text; "" for other values.
std::string scalar_text(const ir::System& system, const ir::Instantiation& instantiation, ir::TypeId id,
                        const ir::Value& value) {
    const ir::Type& type = system.type(id);
    switch (type.kind) {
        case ir::TypeKind::boolean:
            return value.number != 0 ? "true" : "false";
        case ir::TypeKind::nat:
        case ir::TypeKind::integer:
        case ir::TypeKind::real:
            return runs::value_text(system, instantiation, id, std::to_string(value.number));
        case ir::TypeKind::enumeration:
            if (const auto label = static_cast<std::size_t>(value.number); label < type.labels.size())
                return type.labels[label];
            return "";
        case ir::TypeKind::string:
        case ir::TypeKind::given:
        case ir::TypeKind::sequence:
        case ir::TypeKind::set:
        case ir::TypeKind::product:
        case ir::TypeKind::record:
        case ir::TypeKind::function:
        case ir::TypeKind::relation:
        case ir::TypeKind::vector:
        case ir::TypeKind::matrix:
        case ir::TypeKind::unit:
            break;
    }
    return "";
}

Ground chosen_constant(const Project& project, const ir::NamedConstant& constant, const std::string& value) {
    Ground ground;
    ground.kind = GroundKind::constant;
    ground.element = project.label + constant.path;
    ground.text = fmt::format("nothing gives the constant {} a value; {}", constant.path,
                              value.empty() ? "the program has chosen one" : "the program has chosen " + value);
    ground.remedy = "--const NAME=VALUE and `with constants` give constants values";
    return ground;
}

}  // namespace

Basis chosen_constants(const Project& project, const ir::Instantiation& instantiation, const std::string& component,
                       const probability::Row& row) {
    Basis result;
    for (const ir::NamedConstant& constant : ir::named_constants(project.system)) {
        const auto value = instantiation.constants.find(constant.name);
        const bool has_path = constant.path.starts_with(component + "::");
        if (constant.has_value || !has_path || value == instantiation.constants.end()) continue;
        const auto names_it = [&](const auto& given) {
            return ir::is_named_by(constant.path, given.first) || ir::is_named_by(given.first, constant.path);
        };
        if (std::ranges::any_of(row.constants, names_it) || std::ranges::any_of(project.asked.constants, names_it))
            continue;
        const std::string text = scalar_text(project.system, instantiation, constant.type, value->second);
        add(result, chosen_constant(project, constant, text));
    }
    return result;
}

Basis sampling_basis(const probability::Row& row, std::uint64_t seed) {
    const bool sampled = !row.results.empty() && row.results.front().estimate;
    if (!sampled && !row.path) return {};
    Ground ground;
    ground.kind = GroundKind::sampling;
    ground.text = fmt::format("random paths instead of all paths, with seed {}", seed);
    if (sampled) ground.remedy = "without `using sim`, the check explores the whole chain";
    return {ground};
}

}  // namespace robochart::driver
