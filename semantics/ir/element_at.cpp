// SPDX-License-Identifier: Apache-2.0
// Finds the innermost element that contains a place. The spans of a machine's elements are nested, so it is the
// smallest one.
#include "semantics/ir/element_at.hpp"

namespace robochart::ir {
namespace {

bool lies_inside(diagnostics::Span inner, diagnostics::Span outer) {
    return outer.is_known() && inner.source == outer.source && outer.begin <= inner.begin && inner.end <= outer.end;
}

/// Finds the smallest element that contains a place.
class Smallest {
public:
    explicit Smallest(diagnostics::Span place) : place_(place) {}
    void offer_origin(const std::string& package, const Origin& origin) {
        const bool smaller = best_.empty() || origin.span.end - origin.span.begin < size_;
        if (!lies_inside(place_, origin.span) || !smaller) return;
        best_ = package.empty() ? origin.element : package + "::" + origin.element;
        size_ = origin.span.end - origin.span.begin;
    }
    [[nodiscard]] const std::string& best_element() const { return best_; }

private:
    diagnostics::Span place_;
    std::string best_;
    std::uint32_t size_ = 0;
};

}  // namespace

std::string element_at(const System& system, diagnostics::Span span) {
    Smallest smallest(span);
    const auto offer_all = [&](const std::string& package, const auto& elements) {
        for (const auto& element : elements) smallest.offer_origin(package, element.origin);
    };
    for (const Function& function : system.functions) smallest.offer_origin(function.package, function.origin);
    for (const Module& module : system.modules) {
        smallest.offer_origin(module.package, module.origin);
        offer_all(module.package, module.platform.variables);
        offer_all(module.package, module.platform.constants);
    }
    for (const Controller& controller : system.controllers) {
        smallest.offer_origin(controller.package, controller.origin);
        offer_all(controller.package, controller.variables);
        offer_all(controller.package, controller.constants);
    }
    for (const Machine& machine : system.machines) {
        smallest.offer_origin(machine.package, machine.origin);
        offer_all(machine.package, machine.nodes);
        offer_all(machine.package, machine.transitions);
        offer_all(machine.package, machine.variables);
        offer_all(machine.package, machine.constants);
    }
    return smallest.best_element();
}

}  // namespace robochart::ir
