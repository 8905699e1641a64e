// A normal form in whole, as data: what ranks are given instead of the specification.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "checker/refine/search/monitor.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Nodes are numbered breadth first, events ascending; node 0 is the initial one.
struct NormalTable {
    struct Node {
        std::vector<std::pair<process::Event, Monitor::Node>> arcs;  ///< ascending by event
        std::vector<process::EventSet> acceptances;  ///< NormalForm::acceptances; not in the traces model
        bool diverges = false;  ///< only in the failures-divergences model; nothing is known of what follows then
    };
    std::vector<Node> nodes;
};

/// The most nodes that a table has: each rank keeps all.
inline constexpr std::size_t most_table_nodes = 1'000'000;

/// What the model's refinement looks at of the whole normal form; none where it has more nodes than a table, or (see
/// SpecificationGrows) more than are worth having. Throws what the specification throws, and LimitReached.
[[nodiscard]] std::optional<NormalTable> table_of(NormalForm& normal, Model model);

/// RefinementMonitor with the same answers, by a table.
class TableMonitor final : public Monitor {
public:
    TableMonitor(std::shared_ptr<const NormalTable> table, Model model) : table_(std::move(table)), model_(model) {}
    Node start() override { return 0; }
    Advance advance(Node node, process::Event event) override;
    std::optional<ViolationKind> examine(Node node, const Offer& offer) override;
    [[nodiscard]] std::unique_ptr<Monitor> another() override { return std::make_unique<TableMonitor>(table_, model_); }

private:
    std::shared_ptr<const NormalTable> table_;
    Model model_;
};

}  // namespace robochart::refine
