// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/derived_values.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "semantics/data/places.hpp"
#include "semantics/data/sampling.hpp"
#include "semantics/data/uses.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

bool reads_state(const Expr& root) {
    bool reads = false;
    visit_operands(root, [&](const Expr& expr) {
        reads = reads || expr.kind == ExprKind::variable || expr.kind == ExprKind::trigger_value;
    });
    return reads || mentions_clock(root);
}

/// Returns true if the expression only copies values, selects their parts, and composes values. Recursion depth: the
/// depth of the expression.
bool is_copy(const Expr& expr) {
    constexpr std::array kinds{ExprKind::variable, ExprKind::trigger_value, ExprKind::enum_literal,
                               ExprKind::member,   ExprKind::record,        ExprKind::tuple,
                               ExprKind::sequence, ExprKind::set,           ExprKind::concat};
    if (!reads_state(expr)) return true;
    return std::ranges::find(kinds, expr.kind) != kinds.end() &&
           std::ranges::all_of(expr.args, [](const ExprPtr& part) { return !part || is_copy(*part); });
}

class Derivation {
public:
    Derivation(const Places& places, const std::map<PlaceId, Uses>& uses) : places_(places), uses_(uses) {
        for (PlaceId place = 0; place < places.size(); ++place) {
            const PlaceId flow = places.class_of(place);
            if (places[place].type != places[flow].type) mixed_.insert(flow);
        }
    }

    /// Finds the least sets that the rules of `follow` do not extend further.
    void close() {
        for (PlaceId place = 0; place < places_.size(); ++place) {
            const PlaceId flow = places_.class_of(place);
            if (!places_[place].input && !places_[place].shared) continue;
            outside_.insert(flow);
            if (mixed_.contains(flow)) derived_.insert(flow);
        }
        while (follow()) {
        }
    }
    [[nodiscard]] ValueSource source_of(PlaceId place) const {
        const PlaceId flow = places_.class_of(place);
        if (derived_.contains(flow)) return ValueSource::derived;
        return outside_.contains(flow) ? ValueSource::outside : ValueSource::inside;
    }

private:
    [[nodiscard]] bool reads(const Written& written, const std::set<PlaceId>& flows) const {
        return std::ranges::any_of(written.reads,
                                   [&](PlaceId place) { return flows.contains(places_.class_of(place)); });
    }

    /// Adds the flow classes to which values of known flow classes are written. Returns false if none was added.
    bool follow() {
        bool more = false;
        for (const auto& [flow, uses] : uses_)
            for (const Written& written : uses.writes) {
                if (written.closed || written.expr == nullptr) continue;
                const bool clock = mentions_clock(*written.expr);
                const bool from_outside = clock || reads(written, outside_);
                const bool computed = clock || mixed_.contains(flow) || !is_copy(*written.expr);
                if (from_outside) more = outside_.insert(flow).second || more;
                if ((from_outside && computed) || reads(written, derived_)) more = derived_.insert(flow).second || more;
            }
        return more;
    }

    const Places& places_;
    const std::map<PlaceId, Uses>& uses_;
    std::set<PlaceId> mixed_;    ///< flow classes with places of several types
    std::set<PlaceId> outside_;  ///< flow classes with some values from outside
    std::set<PlaceId> derived_;
};

}  // namespace

DerivedValues::DerivedValues(const System& system, const Instantiation& instantiation) {
    const Sampling sampling(system, instantiation);
    Places places(system);
    const auto uses = collect_uses(system, sampling, places, Computed::freely);
    Derivation derivation(places, uses);
    derivation.close();
    const auto note = [&](std::map<Key, ValueSource>& sources, const Key& key, PlaceId place) {
        const ValueSource source = derivation.source_of(place);
        if (source != ValueSource::inside) sources.emplace(key, source);
    };
    for (std::uint32_t m = 0; m < system.machines.size(); ++m) {
        const Machine& machine = system.machines[m];
        for (std::uint32_t v = 0; v < machine.variables.size(); ++v)
            note(variables_, {m, v}, places.variable(MachineId{m}, VariableId{v}));
        for (std::uint32_t e = 0; e < machine.events.size(); ++e)
            if (const PlaceId place = places.event(MachineId{m}, EventId{e}); place != no_id)
                note(events_, {m, e}, place);
    }
}

}  // namespace robochart::ir
