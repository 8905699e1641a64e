// SPDX-License-Identifier: Apache-2.0
// Maps the keys of configurations to points. The name of a point describes the action or wait that takes place in it.
#include "csp_emit/machine/tables/point_table.hpp"

#include <algorithm>

#include "csp_emit/base/rules.hpp"

namespace robochart::csp_emit {
namespace {

constexpr std::size_t max_points = 20'000;
/// The limit on the arguments of all calls between points. Each argument is a small separate tree, so this number of
/// arguments needs about two gigabytes.
constexpr std::size_t max_passed = 4'000'000;

}  // namespace

const Point* PointTable::point_of(const Activation& config) {
    const auto [found, added] = number_.try_emplace(activation_key(config), points_.size());
    if (!added) return &points_[found->second];
    if (points_.size() == max_points) {
        too_large(std::to_string(max_points) + " program points");
        number_.erase(found);
        return nullptr;
    }
    points_.push_back({config, name_of(config)});
    return &points_.back();
}

const Point& PointTable::end_of(std::uint32_t frame) {
    const auto [found, added] = number_.try_emplace("return " + std::to_string(frame), points_.size());
    if (added) {
        Activation end;
        end.frame = frame;
        const auto& nodes = frames_[frame].machine->nodes;
        const auto is_end = [](const ir::Node& n) { return n.kind == ir::NodeKind::final && !n.parent.is_valid(); };
        const auto final = std::ranges::find_if(nodes, is_end);
        end.at = ir::NodeId{static_cast<std::uint32_t>(final - nodes.begin())};
        points_.push_back({end, context_.names.unique_name(frames_[frame].prefix + "return__"), true});
    }
    return points_[found->second];
}

std::string PointTable::name_of(const Activation& config) {
    const Activation& inner = innermost_activation(config);
    std::string base = frames_[inner.frame].prefix;
    if (const Item* item = running_item(config))
        base += flatten_name(item->label);
    else if (inner.at.is_valid())
        base += flatten_name(frames_[inner.frame].machine->nodes[inner.at.index].path);
    if (!config.durings.empty()) base += "_during";
    return context_.names.unique_name(base + "__");
}

void PointTable::count_call(std::size_t arguments) {
    passed_ += 1 + arguments;
    if (passed_ > max_passed) too_large(std::to_string(max_passed) + " values to pass between program points");
}

void PointTable::too_large(const std::string& what) {
    const ir::Machine& machine = *context_.machine;
    if (!overflow_)
        context_.project->diagnostics.report(rules::too_many_points, machine.origin.span, {machine.name, what});
    overflow_ = true;
}

void PointTable::erase_points(const std::function<bool(const std::string& name)>& unwanted) {
    std::erase_if(points_, [&](const Point& point) { return unwanted(point.name); });
}

}  // namespace robochart::csp_emit
