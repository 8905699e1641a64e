// SPDX-License-Identifier: Apache-2.0
// See component_reader.hpp. A node, component or event in RoboTool's file denotes the declaration to which its
// reference leads, if that declaration has the displayed name. Otherwise declarations have probably been added or
// moved, and the shape denotes the declaration with the displayed name in the same container.
#include "frontend/diagrams/stored/component_reader.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "frontend/diagrams/notation/labels.hpp"
#include "frontend/diagrams/notation/painter.hpp"
#include "frontend/diagrams/notation/subjects.hpp"

namespace robochart::diagrams {

using namespace frontend;
using layout::Point;

namespace {

constexpr double shape_inset = 5;    ///< the distance of shapes from the border of their area
constexpr double title_height = 28;  ///< the height of a displayed title

/// Returns the name in a displayed text: "S" for "ref S = T", "e" for "e: nat", "op" for "op(x: nat)".
std::string_view identifier_of(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const auto trim = [&] { text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size())); };
    trim();
    if (text.starts_with("ref ")) text.remove_prefix(4);
    trim();
    return text.substr(0, text.find_first_of(" \t\r\n=:(["));
}

bool is_called(const Declaration& declaration, std::string_view shown) {
    const std::string_view name = identifier_of(shown);
    if (name == declaration.name) return true;
    const auto* reference = dynamic_cast<const Reference*>(&declaration);
    return reference != nullptr && (name == reference->target_name.text() ||
                                    (!reference->target_name.empty() && name == reference->target_name.parts.back()));
}

/// True for areas that contain nodes or components as shapes.
bool is_inside(std::string_view mapping) {
    return mapping == "NodesID" || mapping == "MachinesID" || mapping == "ModuleNodes";
}
/// True for areas with rows.
bool is_rows(std::string_view mapping) {
    return mapping == "ContextID" || mapping == "OpContextID" || mapping == "ActionsID";
}

/// True for mappings of nodes, components and events, which may be missing in the model.
bool is_placed(std::string_view mapping) {
    constexpr std::string_view placed[] = {"StateID",
                                           "InitialID",
                                           "JunctionID",
                                           "FinallID",
                                           "FinalID",
                                           "ProbabilisticID",
                                           "BorderedEventID",
                                           "ModuleID",
                                           "ControllerDefID",
                                           "ANNControllerDefID",
                                           "StateMachineID",
                                           "OperationDefID",
                                           "RoboticPlatformDefID",
                                           "ControllerRefID",
                                           "StateMachineRefID",
                                           "OperationRefID",
                                           "RoboticPlatformRefID"};
    return std::ranges::find(placed, mapping) != std::end(placed);
}

/// Returns the events that may be on the border of a component.
std::vector<const Event*> events_on(const Declaration* owner) {
    if (const auto* reference = dynamic_cast<const Reference*>(owner)) owner = reference->target;
    const auto* context = dynamic_cast<const Context*>(owner);
    return context == nullptr ? std::vector<const Event*>() : events_of(*context);
}

std::string without_blanks(std::string_view text) {
    std::string result;
    for (const char c : text)
        if (c != ' ' && c != '\n' && c != '\t' && c != '\r') result += c;
    return result;
}

std::string label_text(const Transition& transition) {
    std::string result;
    for (const std::string& piece : label_of(transition)) result += without_blanks(piece);
    return result;
}

/// An end of a line: a node, or an event on the border of a component.
struct LineEnd {
    const Declaration* node = nullptr;
    const Declaration* event = nullptr;
};

/// The children of the shapes of a diagram, and the lines at them.
struct DiagramIndex {
    explicit DiagramIndex(const AirdDiagram& diagram) : children(diagram.shapes.size()) {
        for (std::size_t s = 0; s < diagram.shapes.size(); ++s)
            if (diagram.shapes[s].parent != no_shape) children[diagram.shapes[s].parent].push_back(s);
        for (std::size_t l = 0; l < diagram.lines.size(); ++l)
            if (const auto at = diagram.elements.find(diagram.lines[l].element); at != diagram.elements.end())
                lines[at->second.source].push_back(l);
    }

    std::vector<std::vector<std::size_t>> children;                      ///< the children of each shape
    std::map<std::string, std::vector<std::size_t>, std::less<>> lines;  ///< keyed by the id of their source
};

/// One component of a diagram.
class ComponentReader {
public:
    ComponentReader(const AirdDiagram& diagram, const DiagramIndex& index, const Fragments& fragments,
                    diagnostics::Budget* budget)
        : diagram_(diagram), index_(index), children_(index.children), fragments_(fragments), budget_(budget) {}

    StoredDiagram read(std::size_t shape, const Declaration& component) {
        read_box(shape, component);
        for (const std::size_t child : children_[shape]) visit(child, component);
        read_lines();
        count_boxes(component);
        return std::move(result_);
    }

private:
    [[nodiscard]] const AirdElement* element_of(std::size_t shape) const {
        const auto at = diagram_.elements.find(diagram_.shapes[shape].element);
        return at == diagram_.elements.end() ? nullptr : &at->second;
    }

    void visit(std::size_t shape, const Declaration& owner) {
        if (budget_ != nullptr) budget_->poll();
        const AirdElement* element = element_of(shape);
        if (element == nullptr || is_inside(element->mapping) || is_rows(element->mapping)) {
            if (element == nullptr || diagram_.shapes[shape].visible)
                for (const std::size_t child : children_[shape]) visit(child, owner);
            return;
        }
        if (!is_placed(element->mapping)) return;
        ids_.insert(diagram_.shapes[shape].element);
        if (!diagram_.shapes[shape].visible) return;
        ++result_.elements;
        if (element->mapping == "BorderedEventID")
            read_square(shape, *element, owner);
        else
            read_node(shape, *element, owner);
    }

    void read_node(std::size_t shape, const AirdElement& element, const Declaration& owner) {
        const Declaration* node = node_of(element, owner);
        if (node == nullptr || !result_.layout.boxes.try_emplace(node).second) return;
        ++result_.found;
        ends_[diagram_.shapes[shape].element] = {node, nullptr};
        read_box(shape, *node);
        const AirdShape& it = diagram_.shapes[shape];
        ++places_[{it.parent, it.x.value_or(0), it.y.value_or(0)}];
        for (const std::size_t child : children_[shape]) visit(child, *node);
    }

    /// Finds the node in the owner by the reference or, if that fails, by its name.
    [[nodiscard]] const Declaration* node_of(const AirdElement& element, const Declaration& owner) const {
        const Declaration* meant = fragments_.find(element.href);
        const Declaration* called = nullptr;
        const auto see = [&](const Declaration& candidate) {
            if (!is_called(candidate, element.name)) return;
            if (called == nullptr || &candidate == meant) called = &candidate;
        };
        if (const auto* container = dynamic_cast<const NodeContainer*>(&owner))
            for (const auto& node : container->nodes) see(*node);
        if (const auto* component = dynamic_cast<const Component*>(&owner))
            for (const Declaration* part : component->order) see(*part);
        return called;
    }

    void read_square(std::size_t shape, const AirdElement& element, const Declaration& owner) {
        const Declaration* meant = fragments_.find(element.href);
        const Declaration* called = nullptr;
        for (const Event* event : events_on(&owner))
            if (is_called(*event, element.name) && (called == nullptr || event == meant)) called = event;
        if (called == nullptr) return;
        ++result_.found;
        ends_[diagram_.shapes[shape].element] = {&owner, called};
        constexpr double usual = 30;
        const AirdShape& it = diagram_.shapes[shape];
        result_.layout.squares[&owner].try_emplace(called,
                                                   layout::DrawnPort{{it.x.value_or(0) + it.width.value_or(usual) / 2,
                                                                      it.y.value_or(0) + it.height.value_or(usual) / 2},
                                                                     label_side(shape)});
    }

    /// Returns the side of a square of 30 pixels on which the corner of its label is.
    [[nodiscard]] layout::Side label_side(std::size_t shape) const {
        constexpr double beyond = 28;
        for (const std::size_t child : children_[shape]) {
            const AirdShape& label = diagram_.shapes[child];
            if (label.type != 5001 && label.type != 5010) continue;
            const double x = label.x.value_or(0);
            const double y = label.y.value_or(0);
            if (x >= beyond) return layout::Side::right;
            if (y >= beyond) return layout::Side::bottom;
            if (y < -10) return layout::Side::top;
            if (x < -10) return layout::Side::left;
        }
        return layout::Side::right;
    }

    // ---------------------------------------------------------------- boxes

    /// Collects the areas in a shape, without those of the shapes inside it.
    void areas_in(std::size_t shape, std::vector<std::size_t>& areas) const {
        for (const std::size_t child : children_[shape]) {
            const AirdElement* element = element_of(child);
            if (element == nullptr)
                areas_in(child, areas);
            else if (is_inside(element->mapping) || is_rows(element->mapping))
                areas.push_back(child);
        }
    }

    [[nodiscard]] double title_of(std::size_t shape) const {
        for (const std::size_t child : children_[shape]) {
            const AirdShape& label = diagram_.shapes[child];
            if (label.type >= 5002 && label.type <= 5007) return label.visible ? title_height : 0;
        }
        return title_height;
    }

    /// Reads the box of a shape. A shape with areas is as large as the areas need.
    void read_box(std::size_t shape, const Declaration& it) {
        const AirdShape& own = diagram_.shapes[shape];
        layout::DrawnBox box{{own.x.value_or(0) + shape_inset, own.y.value_or(0) + shape_inset}, own.width, own.height};
        StoredArea area;
        std::vector<std::size_t> areas;
        areas_in(shape, areas);
        bool has_rows = false;
        for (const std::size_t inner : areas) has_rows = has_rows || is_rows(element_of(inner)->mapping);
        const double title = title_of(shape);
        for (const std::size_t inner : areas) {
            const AirdShape& stacked = diagram_.shapes[inner];
            area.size.width = std::max(area.size.width, stacked.width.value_or(0));
            if (!is_inside(element_of(inner)->mapping)) continue;
            area.size.height = stacked.height.value_or(0);
            if (stacked.y || !has_rows) area.above = title + stacked.y.value_or(0);
        }
        if (area.size.width > 0 && !box.width) box.width = area.size.width;
        if (area.size.height > 0 && area.above && !box.height) box.height = *area.above + area.size.height;
        result_.layout.boxes[&it] = box;
        if (!areas.empty()) result_.layout.areas[&it] = area;
    }

    /// Counts the boxes and those at the place of another box. RoboTool stacks shapes in one corner until somebody
    /// moves them, and creates nodes and components when they are first shown.
    void count_boxes(const Declaration& component) {
        for (const auto& [place, count] : places_) {
            result_.boxes += count;
            if (count > 1) result_.stacked += count;
        }
        const auto* container = dynamic_cast<const NodeContainer*>(&component);
        const auto* parts = dynamic_cast<const Component*>(&component);
        const bool has_boxes =
            (container != nullptr && !container->nodes.empty()) || (parts != nullptr && !parts->order.empty());
        if (has_boxes && result_.boxes == 0) result_.stacked = 1;
    }

    // ---------------------------------------------------------------- lines

    /// Reads the lines between shapes of the component. Lines whose references can be resolved come first, then lines
    /// with the same ends as a declaration.
    void read_lines() {
        std::vector<std::pair<const AirdLine*, const AirdElement*>> rest;
        for (const std::size_t l : lines_inside()) {
            if (budget_ != nullptr) budget_->poll();
            const AirdLine& line = diagram_.lines[l];
            const AirdElement& element = diagram_.elements.find(line.element)->second;
            ++result_.elements;
            const Declaration* meant = fragments_.find(element.href);
            if (meant == nullptr || !has_ends_of(*meant, element) || !add_route(*meant, line))
                rest.emplace_back(&line, &element);
        }
        for (const auto& [line, element] : rest) {
            if (budget_ != nullptr) budget_->poll();
            find_line(*line, *element);
        }
    }

    /// Returns the lines between shapes of the component or own events, in the order of the file. A shape may be
    /// missing in the model.
    [[nodiscard]] std::vector<std::size_t> lines_inside() const {
        std::vector<std::size_t> result;
        for (const std::string& id : ids_) {
            const auto at = index_.lines.find(id);
            if (at == index_.lines.end()) continue;
            for (const std::size_t line : at->second) {
                const AirdElement& element = diagram_.elements.find(diagram_.lines[line].element)->second;
                const bool drawn = element.mapping == "TransitionID" || element.mapping == "ConnectionID";
                if (drawn && diagram_.lines[line].visible && ids_.contains(element.target)) result.push_back(line);
            }
        }
        std::ranges::sort(result);
        return result;
    }

    bool add_route(const Declaration& declaration, const AirdLine& line) {
        if (!result_.layout.lines.try_emplace(&declaration, line.route).second) return false;
        ++result_.found;
        return true;
    }

    [[nodiscard]] LineEnd end_of(const std::string& id) const {
        const auto at = ends_.find(id);
        return at == ends_.end() ? LineEnd() : at->second;
    }

    /// True if the declaration has the same ends as the line.
    [[nodiscard]] bool has_ends_of(const Declaration& declaration, const AirdElement& line) const {
        const LineEnd source = end_of(line.source);
        const LineEnd target = end_of(line.target);
        if (source.node == nullptr || target.node == nullptr) return false;
        if (const auto* transition = dynamic_cast<const Transition*>(&declaration))
            return transition->source == source.node && transition->target == target.node;
        const auto is = [](const Connection::End& end, const LineEnd& drawn) {
            return end.node_target == drawn.node && end.event_target == drawn.event;
        };
        const auto* connection = dynamic_cast<const Connection*>(&declaration);
        return connection != nullptr && is(connection->from, source) && is(connection->to, target);
    }

    /// Finds a declaration for the line in the container of the line's source. Declarations that already have a line
    /// are skipped. If several fit, a declaration with the line's label is preferred.
    void find_line(const AirdLine& line, const AirdElement& element) {
        const Declaration* source = end_of(element.source).node;
        const Declaration* best = nullptr;
        const std::string label = without_blanks(element.name);
        const auto see = [&](const auto& candidate, bool same_label) {
            if (result_.layout.lines.contains(candidate.get()) || !has_ends_of(*candidate, element)) return;
            if (best == nullptr || same_label) best = candidate.get();
        };
        for (const Declaration* at = source; at != nullptr && best == nullptr; at = at->parent) {
            if (const auto* container = dynamic_cast<const NodeContainer*>(at))
                for (const auto& transition : container->transitions) see(transition, label_text(*transition) == label);
            if (const auto* component = dynamic_cast<const Component*>(at))
                for (const auto& connection : component->connections) see(connection, false);
        }
        if (best != nullptr) add_route(*best, line);
    }

    const AirdDiagram& diagram_;
    const DiagramIndex& index_;
    const std::vector<std::vector<std::size_t>>& children_;
    const Fragments& fragments_;
    diagnostics::Budget* budget_;
    StoredDiagram result_;
    std::set<std::string, std::less<>> ids_;                                 ///< ids of the elements of the component
    std::map<std::string, LineEnd, std::less<>> ends_;                       ///< the ends that were found in the model
    std::map<std::tuple<std::size_t, double, double>, std::size_t> places_;  ///< number of shapes at each place
};

/// Finds the component by the reference or, if that fails, by its name.
const Declaration* component_of(const AirdElement& element, const Fragments& fragments) {
    const auto is_meant = [&](const Declaration* candidate) {
        return candidate != nullptr && has_diagram(*candidate) && is_called(*candidate, element.name);
    };
    const Declaration* meant = fragments.find(element.href);
    if (is_meant(meant)) return meant;
    for (const Declaration* sibling : fragments.siblings(element.href))
        if (is_meant(sibling)) return sibling;
    return nullptr;
}

}  // namespace

std::vector<std::pair<const Declaration*, StoredDiagram>> read_components(const AirdDiagram& diagram,
                                                                          const Fragments& fragments,
                                                                          diagnostics::Budget* budget) {
    const DiagramIndex index(diagram);
    std::vector<std::pair<const Declaration*, StoredDiagram>> result;
    for (std::size_t s = 0; s < diagram.shapes.size(); ++s) {
        if (budget != nullptr) budget->poll();
        const auto element = diagram.elements.find(diagram.shapes[s].element);
        if (element == diagram.elements.end() || !diagram.shapes[s].visible || !is_placed(element->second.mapping))
            continue;
        const Declaration* component = component_of(element->second, fragments);
        if (component == nullptr) continue;
        result.emplace_back(component, ComponentReader(diagram, index, fragments, budget).read(s, *component));
    }
    return result;
}

}  // namespace robochart::diagrams
