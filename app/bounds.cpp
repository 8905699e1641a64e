// The element that a bound belongs to is the smallest one around its expression.
#include "app/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "csp_emit/bounds.hpp"
#include "diagnostics/one_line.hpp"

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

/// The expression as written, on one line.
std::string written(const diagnostics::SourceManager& sources, diagnostics::Span span) {
    return diagnostics::on_one_line(sources.text(span.source).substr(span.begin, span.end - span.begin));
}

}  // namespace

BoundWatch::BoundWatch(const Project& project, const csp_emit::Emission& emission, csp_emit::Time time, std::vector<BoundReport>& report)
    : project_(project), emission_(emission), time_(time == csp_emit::Time::timed ? "timed" : "untimed"), report_(report) {}

cspm::CallObserver BoundWatch::observer() {
    return {emission_.bounded, [this](const cspm::ObservedCall& call) { note(call); }};
}

std::string BoundWatch::element_at(diagnostics::Span span) const {
    Smallest smallest(span);
    for (const ir::Machine& machine : project_.system.machines) {
        smallest.offer(machine.origin);
        for (const ir::Node& node : machine.nodes) smallest.offer(node.origin);
        for (const ir::Transition& transition : machine.transitions) smallest.offer(transition.origin);
        for (const ir::Variable& variable : machine.variables) smallest.offer(variable.origin);
        for (const ir::Constant& constant : machine.constants) smallest.offer(constant.origin);
    }
    return smallest.best().empty() ? "model" : smallest.best();
}

void BoundWatch::note(const cspm::ObservedCall& call) {
    // Calls without a place, and those in CSP blocks, are no expressions of the model.
    if (!call.span.known() || project_.sources.path(call.span.source).ends_with(".assertions")) return;
    const auto text = csp_emit::reached_bound(emission_, project_.instantiation, call);
    if (!text) return;
    const std::uint64_t at = (static_cast<std::uint64_t>(call.span.source) << 32U) | call.span.begin;
    if (!known_.emplace(std::make_pair(call.function, at), true).second) return;
    BoundReport bound{element_at(call.span), project_.sources.place(call.span),
                      fmt::format("in {}, {}", written(project_.sources, call.span), *text), time_};
    const auto same = std::find_if(report_.begin(), report_.end(), [&](const BoundReport& other) {
        return other.place == bound.place && other.element == bound.element && other.text == bound.text;
    });
    if (same == report_.end()) report_.push_back(std::move(bound));
    else if (same->time != time_) same->time = "untimed, timed";
}

}  // namespace robochart::app
