// The machines' elements nest by their places in the text, so the smallest one is the innermost.
#include "app/report/element_at.hpp"

namespace robochart::app {
namespace {

bool inside(diagnostics::Span inner, diagnostics::Span outer) {
    return outer.known() && inner.source == outer.source && outer.begin <= inner.begin && inner.end <= outer.end;
}

/// Keeps the smallest element around a place.
class Smallest {
public:
    explicit Smallest(diagnostics::Span place) : place_(place) {}
    void offer(const ir::Origin& origin) {
        const bool smaller = best_.empty() || origin.span.end - origin.span.begin < size_;
        if (!inside(place_, origin.span) || !smaller) return;
        best_ = origin.element;
        size_ = origin.span.end - origin.span.begin;
    }
    [[nodiscard]] const std::string& best() const { return best_; }

private:
    diagnostics::Span place_;
    std::string best_;
    std::uint32_t size_ = 0;
};

}  // namespace

std::string element_at(const ir::System& system, diagnostics::Span span) {
    Smallest smallest(span);
    for (const ir::Machine& machine : system.machines) {
        smallest.offer(machine.origin);
        for (const ir::Node& node : machine.nodes) smallest.offer(node.origin);
        for (const ir::Transition& transition : machine.transitions) smallest.offer(transition.origin);
        for (const ir::Variable& variable : machine.variables) smallest.offer(variable.origin);
        for (const ir::Constant& constant : machine.constants) smallest.offer(constant.origin);
    }
    return smallest.best();
}

}  // namespace robochart::app
