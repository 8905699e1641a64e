// SPDX-License-Identifier: Apache-2.0
// Stores a complete normal form as data. Ranks receive this table instead of the specification.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "checker/refine/search/monitor.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Nodes are numbered breadth first, in ascending order of events. Node 0 is the initial node.
struct NormalTable {
    struct Node {
        std::vector<std::pair<process::Event, Monitor::Node>> arcs;  ///< ascending by event
        std::vector<process::EventSet> acceptances;  ///< NormalForm::acceptances; empty in the traces model
        bool diverges = false;  ///< only in the failures-divergences model; later behaviour is not stored
    };
    std::vector<Node> nodes;
};

/// The maximal number of nodes in a table, because each rank stores all of them.
inline constexpr std::size_t most_table_nodes = 1'000'000;

/// Returns the parts of the whole normal form that refinement in the model uses. Returns no value if there are more
/// than `most_nodes` nodes, or too many to be useful (see SpecificationGrows). Throws the exceptions of the
/// specification, and LimitReached.
[[nodiscard]] std::optional<NormalTable> table_of(NormalForm& normal, Model model,
                                                  std::size_t most_nodes = most_table_nodes);

/// Reads the answers of a RefinementMonitor from a table.
class TableMonitor final : public Monitor {
public:
    TableMonitor(std::shared_ptr<const NormalTable> table, Model model) : table_(std::move(table)), model_(model) {}
    Node start() override { return 0; }
    Advance advance(Node node, process::Event event) override;
    std::optional<ViolationKind> examine(Node node, const Offer& offer) override;
    [[nodiscard]] std::unique_ptr<Monitor> clone_for_thread() override {
        return std::make_unique<TableMonitor>(table_, model_);
    }

private:
    std::shared_ptr<const NormalTable> table_;
    Model model_;
};

}  // namespace robochart::refine
