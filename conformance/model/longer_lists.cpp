// SPDX-License-Identifier: Apache-2.0
#include "conformance/model/longer_lists.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "semantics/data/places.hpp"
#include "semantics/data/uses.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::conformance {

namespace {

/// The greatest length that is computed. A type with longer lists would have too large a carrier in any case.
constexpr std::int64_t greatest_length = 1'000'000;

/// Finds the lengths of lists by the statements that write them.
class ListLengths {
public:
    ListLengths(const ir::System& system, const ir::Instantiation& instantiation)
        : received_(instantiation.sequence_bound),
          sampling_(system, instantiation),
          places_(system),
          uses_(ir::collect_uses(system, sampling_, places_)) {}

    [[nodiscard]] const ir::Places& places() const { return places_; }

    /// Returns the length of the longest list in the flow class. Returns no value if there is no bound, or if the bound
    /// exceeds greatest_length. Recursion depth: the number of flow classes.
    [[nodiscard]] std::optional<std::int64_t> longest_in(ir::PlaceId flow) {
        const auto known = known_.find(flow);
        if (known != known_.end()) return known->second;
        // A flow class that is reached again while it is open is on a cycle. So are all classes that have been opened
        // since then. They have no bound, whichever of them comes first.
        if (!open_.insert(flow).second) return std::nullopt;
        const auto result = longest_written(flow);
        open_.erase(flow);
        known_.emplace(flow, result);
        return result;
    }

private:
    [[nodiscard]] std::optional<std::int64_t> longest_written(ir::PlaceId flow) {
        const ir::Place& place = places_[flow];
        if (place.opaque) return std::nullopt;
        std::optional<std::int64_t> result = place.input || place.shared ? received_ : 0;
        const auto uses = uses_.find(flow);
        if (uses != uses_.end()) {
            for (const ir::Written& written : uses->second.writes) {
                if (!result || written.expr == nullptr) continue;
                const auto length = longest_of(written.machine, *written.expr);
                result = length ? std::optional(std::max(*result, *length)) : std::nullopt;
            }
        }
        return result;
    }

    /// Returns the length of the longest list of an expression. Recursion depth: the depth of the expression, times the
    /// number of flow classes.
    [[nodiscard]] std::optional<std::int64_t> longest_of(ir::MachineId machine, const ir::Expr& expr) {
        if (expr.kind == ir::ExprKind::variable)
            return longest_in(places_.class_of(places_.variable(machine, expr.variable)));
        if (expr.kind == ir::ExprKind::sequence) return static_cast<std::int64_t>(expr.args.size());
        if (expr.kind != ir::ExprKind::concat) return std::nullopt;
        const auto left = longest_of(machine, *expr.args.at(0));
        const auto right = left ? longest_of(machine, *expr.args.at(1)) : std::nullopt;
        return right && *left + *right <= greatest_length ? std::optional(*left + *right) : std::nullopt;
    }

    std::int64_t received_;
    ir::Sampling sampling_;
    ir::Places places_;
    std::map<ir::PlaceId, ir::Uses> uses_;
    std::map<ir::PlaceId, std::optional<std::int64_t>> known_;
    std::set<ir::PlaceId> open_;  ///< flow classes whose length is being computed
};

/// Returns all lists of these elements up to the length, or no value if there are more than `most`.
std::optional<std::vector<ir::Value>> lists_up_to(const std::vector<ir::Value>& elements, std::int64_t length,
                                                  std::size_t most) {
    std::vector<ir::Value> result{ir::Value{}};
    std::size_t shorter = 0;
    for (std::int64_t i = 0; i < length; ++i) {
        const std::size_t end = result.size();
        if (end + (end - shorter) * elements.size() > most) return std::nullopt;
        for (; shorter < end; ++shorter) {
            for (const ir::Value& element : elements) {
                ir::Value longer = result[shorter];
                longer.parts.push_back(element);
                result.push_back(std::move(longer));
            }
        }
    }
    std::ranges::sort(result);
    return result;
}

}  // namespace

ListBounds separate_longer_lists(ir::System& system, const ir::Instantiation& instantiation) {
    ListLengths lengths(system, instantiation);
    ListBounds bounds;
    std::map<ir::PlaceId, ir::TypeId> types;
    const ir::Places& places = lengths.places();
    for (ir::PlaceId place = 0; place < places.size(); ++place) {
        if (places.class_of(place) != place || system.type(places[place].type).kind != ir::TypeKind::sequence) continue;
        const auto longest = lengths.longest_in(place);
        if (!longest || *longest <= instantiation.sequence_bound) continue;
        types.emplace(place, ir::TypeId{static_cast<std::uint32_t>(system.types.size() + types.size())});
        bounds.emplace(types.at(place).index, *longest);
    }
    for (const auto& [place, type] : types) system.types.push_back(ir::Type(system.type(places[place].type)));
    ir::PlaceId place = 0;
    ir::Places::visit_types(system, [&](ir::TypeId& type) {
        if (const auto found = types.find(places.class_of(place++)); found != types.end()) type = found->second;
    });
    return bounds;
}

void extend_carriers(ir::Instantiation& instantiation, const ir::System& system, const ListBounds& bounds,
                     std::size_t most) {
    for (const auto& [type, longest] : bounds) {
        try {
            const ir::TypeId element = system.types.at(type).args.at(0);
            auto lists = lists_up_to(ir::carrier_values(system, instantiation, element, most), longest, most);
            if (lists) instantiation.representatives[type] = std::move(*lists);
        } catch (const std::length_error&) {
            continue;  // the elements are too many
        }
    }
}

}  // namespace robochart::conformance
