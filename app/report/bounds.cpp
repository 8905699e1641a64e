// A bound is reported once for each expression, with the element that contains it.
#include "app/report/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "csp_emit/expressions/clipping.hpp"
#include "diagnostics/text.hpp"
#include "semantics/ir/element_at.hpp"

namespace robochart::app {
namespace {

/// The expression as written, on one line.
std::string written(const diagnostics::SourceManager& sources, diagnostics::Span span) {
    return diagnostics::on_one_line(sources.text(span.source).substr(span.begin, span.end - span.begin));
}

}  // namespace

BoundWatch::BoundWatch(const Project& project, const csp_emit::Emission& emission, csp_emit::Time time,
                       std::vector<BoundReport>& report)
    : project_(project),
      emission_(emission),
      time_(time == csp_emit::Time::timed ? "timed" : "untimed"),
      report_(report) {}

cspm::CallObserver BoundWatch::observer() {
    return {emission_.bounded, [this](const cspm::ObservedCall& call) { note(call); }};
}

void BoundWatch::note(const cspm::ObservedCall& call) {
    // Calls without a place, and those in CSP blocks, are no expressions of the model.
    if (!call.span.known() || project_.sources.path(call.span.source).ends_with(".assertions")) return;
    const auto text = csp_emit::reached_bound(emission_, project_.instantiation, call);
    if (!text) return;
    const std::uint64_t at = (static_cast<std::uint64_t>(call.span.source) << 32U) | call.span.begin;
    if (!known_.emplace(std::make_pair(call.function, at), true).second) return;
    const std::string element = ir::element_at(project_.system, call.span);
    BoundReport bound{project_.label + (element.empty() ? "model" : element), project_.sources.place(call.span),
                      fmt::format("in {}, {}", written(project_.sources, call.span), *text), time_};
    const auto same = std::find_if(report_.begin(), report_.end(), [&](const BoundReport& other) {
        return other.place == bound.place && other.element == bound.element && other.text == bound.text;
    });
    if (same == report_.end())
        report_.push_back(std::move(bound));
    else if (same->time != time_)
        same->time = "untimed, timed";
}

}  // namespace robochart::app
