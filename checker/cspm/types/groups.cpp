// SPDX-License-Identifier: Apache-2.0
// Finds strongly connected components with Boost.Graph, which uses Tarjan's algorithm (1972) without recursion, because
// scripts may chain any number of declarations. A component gets its number when it is complete, after the components
// that it uses.
#include "checker/cspm/types/groups.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

namespace robochart::cspm::types {

namespace {

/// A graph with an edge from each declaration to every declaration of the list that it uses.
using UseGraph = boost::adjacency_list<boost::setS, boost::vecS, boost::directedS>;

UseGraph uses_of(const DeclarationList& list) {
    UseGraph graph(list.items.size());
    for (const Declaration& declaration : list.items)
        for (const Symbol* used : declaration.uses)
            if (used->owner != nullptr && used->owner->list == &list)
                boost::add_edge(declaration.index, used->owner->index, graph);
    return graph;
}

}  // namespace

std::vector<std::vector<Declaration*>> dependency_groups(DeclarationList& list) {
    std::vector<std::size_t> component(list.items.size());
    const auto count = boost::strong_components(
        uses_of(list), boost::make_iterator_property_map(component.begin(), boost::identity_property_map()));
    std::vector<std::vector<Declaration*>> result(count);
    for (std::size_t index = 0; index < component.size(); ++index)
        result[component[index]].push_back(&list.items[index]);
    return result;
}

}  // namespace robochart::cspm::types
