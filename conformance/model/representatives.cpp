// SPDX-License-Identifier: Apache-2.0
// Computes the values that represent a data independent type (Lazić 1999; Roscoe UCS 17.2).
#include "conformance/model/representatives.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "conformance/code/code_system.hpp"
#include "conformance/model/data_independence.hpp"
#include "cpp_emit/plan/exploration_ports.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/unsupported.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/dump_expressions.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::conformance {

namespace {

/// The maximal number of attempts to find an unused value.
constexpr std::size_t attempts = 64;
/// The number of attempts after which the distance between the leaves of a value grows.
constexpr std::size_t attempts_with_distance = 16;

/// Makes a value whose parts differ: in the order of the carrier, the value of each leaf is `distance` positions after
/// the value of the previous leaf. Two values with the same distance and different offsets differ in every part if the
/// carriers are large enough.
class Sample {
public:
    Sample(const ir::System& system, const ir::Instantiation& instantiation, std::size_t attempt)
        : system_(system),
          instantiation_(instantiation),
          next_(attempt % attempts_with_distance),
          distance_(1 + attempt / attempts_with_distance) {}

    /// Returns a value of the type. Returns no value for functions and relations, whose values have no fixed shape.
    /// Recursion depth: the depth of types.
    std::optional<ir::Value> sample_value(ir::TypeId id) {
        const ir::Type& type = system_.type(id);
        switch (type.kind) {
            case ir::TypeKind::function:
            case ir::TypeKind::relation:
                return std::nullopt;
            case ir::TypeKind::sequence:
                return sample_parts(
                    std::vector<ir::TypeId>(static_cast<std::size_t>(instantiation_.sequence_bound), type.args[0]));
            case ir::TypeKind::set:
                return sample_parts({type.args[0]});
            case ir::TypeKind::vector:
                return sample_parts(std::vector<ir::TypeId>(static_cast<std::size_t>(type.sizes[0]), type.args[0]));
            case ir::TypeKind::matrix:
                return sample_matrix(type);
            case ir::TypeKind::product:
            case ir::TypeKind::record:
                return sample_parts(type.args);
            case ir::TypeKind::boolean:
            case ir::TypeKind::nat:
            case ir::TypeKind::integer:
            case ir::TypeKind::real:
            case ir::TypeKind::string:
            case ir::TypeKind::enumeration:
            case ir::TypeKind::given:
            case ir::TypeKind::unit:
                break;
        }
        const std::vector<ir::Value> values = ir::carrier_values(system_, instantiation_, id);
        if (values.empty()) return std::nullopt;
        const std::size_t at = std::exchange(next_, next_ + distance_);
        return values[at % values.size()];
    }

private:
    std::optional<ir::Value> sample_parts(const std::vector<ir::TypeId>& types) {
        ir::Value value;
        for (const ir::TypeId type : types) {
            std::optional<ir::Value> part = sample_value(type);
            if (!part) return std::nullopt;
            value.parts.push_back(std::move(*part));
        }
        return value;
    }

    std::optional<ir::Value> sample_matrix(const ir::Type& type) {
        ir::Value value;
        for (std::int64_t row = 0; row < type.sizes[0]; ++row) {
            std::optional<ir::Value> row_value =
                sample_parts(std::vector<ir::TypeId>(static_cast<std::size_t>(type.sizes[1]), type.args[0]));
            if (!row_value) return std::nullopt;
            value.parts.push_back(std::move(*row_value));
        }
        return value;
    }

    const ir::System& system_;
    const ir::Instantiation& instantiation_;
    std::size_t next_;
    std::size_t distance_;
};

using TakePart = std::function<void(ir::TypeId, const ir::Value&)>;

void for_each_element(ir::TypeId type, const ir::Value& value, const TakePart& take) {
    for (const ir::Value& part : value.parts) take(type, part);
}

void for_each_field(const std::vector<ir::TypeId>& types, const ir::Value& value, const TakePart& take) {
    for (std::size_t i = 0; i < types.size() && i < value.parts.size(); ++i) take(types[i], value.parts[i]);
}

/// Visits the parts of a value with their types.
void for_each_part(const ir::Type& type, const ir::Value& value, const TakePart& take) {
    switch (type.kind) {
        case ir::TypeKind::boolean:
        case ir::TypeKind::nat:
        case ir::TypeKind::integer:
        case ir::TypeKind::real:
        case ir::TypeKind::string:
        case ir::TypeKind::given:
        case ir::TypeKind::unit:
            return;
        case ir::TypeKind::enumeration:
            if (const auto literal = static_cast<std::size_t>(value.number); literal < type.literal_args.size())
                for_each_field(type.literal_args[literal], value, take);
            return;
        case ir::TypeKind::sequence:
        case ir::TypeKind::set:
        case ir::TypeKind::vector:
            return for_each_element(type.args.at(0), value, take);
        case ir::TypeKind::matrix:
            for (const ir::Value& row : value.parts) for_each_element(type.args.at(0), row, take);
            return;
        case ir::TypeKind::product:
        case ir::TypeKind::record:
            return for_each_field(type.args, value, take);
        case ir::TypeKind::function:
        case ir::TypeKind::relation:
            for (const ir::Value& pair : value.parts) for_each_field(type.args, pair, take);
            return;
    }
}

class RepresentativeChooser {
public:
    RepresentativeChooser(const ir::System& system, const ir::Instantiation& instantiation,
                          const cpp_emit::Component& component, std::size_t names)
        : system_(system), component_(component), names_(names), result_{instantiation, {}} {
        std::vector<ir::MachineId> machines;
        for (const cpp_emit::Unit& unit : component.units) machines.push_back(unit.id);
        independent_ = data_independence(system, machines);
    }

    Representatives choose() {
        if (!too_many()) return std::move(result_);
        for (const ir::TypeId type : boundary_types()) parts_first(type);
        if (too_many()) {
            represent_numbers(ir::TypeKind::nat, result_.instantiation.nat);
            represent_numbers(ir::TypeKind::integer, result_.instantiation.integer);
            represent_numbers(ir::TypeKind::real, result_.instantiation.real);
        }
        result_.lists_of_any_length = !result_.types.empty() && lists_are_passed_on();
        return std::move(result_);
    }

private:
    /// Returns whether no operator depends on a list, and the values in all lists are represented.
    [[nodiscard]] bool lists_are_passed_on() const {
        return !independent_.inspects_lists && std::ranges::all_of(boundary_types(), [&](ir::TypeId type) {
            return !contains_lists(type) || is_represented(system_, result_, type);
        });
    }
    /// Returns whether the type contains lists. Recursion depth: the depth of types.
    [[nodiscard]] bool contains_lists(ir::TypeId id) const {
        const ir::Type& type = system_.type(id);
        const auto inside = [&](ir::TypeId part) { return contains_lists(part); };
        return type.kind == ir::TypeKind::sequence || std::ranges::any_of(type.args, inside) ||
               std::ranges::any_of(type.literal_args,
                                   [&](const auto& arguments) { return std::ranges::any_of(arguments, inside); });
    }

    [[nodiscard]] bool too_many() const {
        if (!cpp_emit::beyond_exploration(system_, result_.instantiation, component_).empty()) return true;
        double valuations = 1;
        for (const cpp_emit::Register& input : cpp_emit::exploration_registers(component_)) {
            const double values = input.type
                                      ? static_cast<double>(ir::carrier_values(system_, result_.instantiation,
                                                                               *input.type, cpp_emit::max_input_values)
                                                                .size())
                                      : 1;
            valuations *= 1 + values;
        }
        return valuations > static_cast<double>(CodeSystem::max_valuations);
    }

    [[nodiscard]] std::vector<ir::TypeId> boundary_types() const {
        std::vector<ir::TypeId> types;
        for (const cpp_emit::Register& input : cpp_emit::exploration_registers(component_))
            if (input.type) types.push_back(*input.type);
        for (const cpp_emit::Output& output : cpp_emit::exploration_outputs(component_))
            types.insert(types.end(), output.types.begin(), output.types.end());
        return types;
    }

    /// Represents a type as a whole if the component passes on its values as a whole; otherwise represents its parts.
    /// Recursion depth: the depth of types.
    void parts_first(ir::TypeId id) {
        if (!seen_.insert(id.index).second) return;
        if (independent_.is_independent(system_, id) && represent_type(id)) return;
        const ir::Type& type = system_.type(id);
        for (const ir::TypeId part : type.args) parts_first(part);
        for (const auto& arguments : type.literal_args)
            for (const ir::TypeId part : arguments) parts_first(part);
    }

    bool represent_type(ir::TypeId id) {
        std::set<ir::Value> values = fixed_values(id);
        std::vector<ir::Value> names;
        for (std::size_t attempt = 0; attempt < attempts && names.size() < names_; ++attempt) {
            std::optional<ir::Value> value = Sample(system_, result_.instantiation, attempt).sample_value(id);
            if (!value) return false;
            if (values.insert(*value).second) names.push_back(std::move(*value));
        }
        if (names.size() < names_) return false;
        const std::vector<ir::Value> chosen(values.begin(), values.end());
        for (std::uint32_t other = 0; other < system_.types.size(); ++other)
            if (same_type(system_, id, ir::TypeId{other})) result_.instantiation.representatives[other] = chosen;
        result_.types.push_back({id, ir::type_text(system_, id), chosen.size(), std::move(names)});
        return true;
    }

    /// Returns the initial values of variables and constants of the type.
    [[nodiscard]] std::set<ir::Value> fixed_values(ir::TypeId id) const {
        std::set<ir::Value> values{ir::default_value(system_, result_.instantiation, id)};
        for_each_fixed([&](ir::TypeId type, const ir::Value& value) { collect_values(type, value, id, values); });
        return values;
    }

    /// Collects the values of a type in a value. Recursion depth: the depth of types.
    void collect_values(ir::TypeId id, const ir::Value& value, ir::TypeId wanted, std::set<ir::Value>& found) const {
        if (same_type(system_, wanted, id)) found.insert(value);
        for_each_part(system_.type(id), value, [&](ir::TypeId part_type, const ir::Value& part) {
            collect_values(part_type, part, wanted, found);
        });
    }

    template <class Take>
    void for_each_fixed(const Take& take) const {
        for (const cpp_emit::Unit& unit : component_.units) {
            for (std::size_t i = 0; i < unit.constants.size(); ++i)
                take(unit.machine->constants[i].type, unit.constants[i]);
            for (std::size_t i = 0; i < unit.initials.size(); ++i)
                take(unit.machine->variables[i].type, unit.initials[i]);
        }
        for (const cpp_emit::StoredVariable& stored : component_.variables) take(stored.variable->type, stored.initial);
    }

    /// Represents the numbers of a type by the initial numbers and the numbers that the component writes, and by
    /// further numbers as names.
    void represent_numbers(ir::TypeKind kind, std::vector<std::int64_t>& carrier) {
        const bool used =
            std::ranges::any_of(seen_, [&](std::uint32_t index) { return system_.types[index].kind == kind; });
        if (!used || !independent_.is_independent(kind)) return;
        std::set<std::int64_t> component_numbers{0};
        for_each_fixed(
            [&](ir::TypeId type, const ir::Value& value) { collect_numbers(type, value, kind, component_numbers); });
        for (const cpp_emit::Unit& unit : component_.units) collect_literals(*unit.machine, component_numbers);
        std::vector<std::int64_t> chosen;
        std::vector<ir::Value> names;
        for (const std::int64_t number : carrier) {
            const bool fixed = component_numbers.contains(number);
            if (!fixed && names.size() == names_) continue;
            chosen.push_back(number);
            if (!fixed) names.push_back({number, {}});
        }
        if (names.size() < names_ || chosen.size() == carrier.size()) return;
        carrier = std::move(chosen);
        for (std::uint32_t index = 0; index < system_.types.size(); ++index) {
            if (system_.types[index].kind != kind) continue;
            result_.types.push_back(
                {ir::TypeId{index}, ir::type_text(system_, ir::TypeId{index}), carrier.size(), std::move(names)});
            break;
        }
    }

    /// Collects the numbers of a kind in a value. Recursion depth: the depth of types.
    void collect_numbers(ir::TypeId id, const ir::Value& value, ir::TypeKind kind,
                         std::set<std::int64_t>& found) const {
        const ir::Type& type = system_.type(id);
        if (type.kind == kind) found.insert(value.number);
        for_each_part(type, value, [&](ir::TypeId part_type, const ir::Value& part) {
            collect_numbers(part_type, part, kind, found);
        });
    }

    /// Collects literals. Each literal is taken as a number of every kind.
    void collect_literals(const ir::Machine& machine, std::set<std::int64_t>& found) const {
        ir::visit_expressions(machine, [&](const ir::Expr& root, ir::ExprRole) {
            ir::visit_operands(root, [&](const ir::Expr& expr) {
                const auto value = ir::evaluate_constant(system_, result_.instantiation, &machine, expr);
                if (!value || !value->parts.empty()) return;
                found.insert(value->number);
                const std::int64_t most = std::numeric_limits<std::int64_t>::max() / result_.instantiation.scale;
                if (std::abs(value->number) <= most) found.insert(value->number * result_.instantiation.scale);
            });
        });
    }

    const ir::System& system_;
    const cpp_emit::Component& component_;
    std::size_t names_;
    Representatives result_;
    DataIndependence independent_;
    std::set<std::uint32_t> seen_;
};

}  // namespace

bool is_represented(const ir::System& system, const Representatives& few, ir::TypeId id) {
    const ir::Type& type = system.type(id);
    const auto same = [&](const RepresentedType& represented) { return same_type(system, represented.type, id); };
    if (std::ranges::any_of(few.types, same)) return true;
    const auto inside = [&](ir::TypeId part) { return is_represented(system, few, part); };
    return std::ranges::any_of(type.args, inside) || std::ranges::any_of(type.literal_args, [&](const auto& arguments) {
               return std::ranges::any_of(arguments, inside);
           });
}

std::vector<NameSet> names_by_type(const Representatives& few) {
    std::vector<NameSet> sets;
    std::size_t bit = 0;
    for (const RepresentedType& represented : few.types) {
        NameSet names = 0;
        for (std::size_t i = 0; i < represented.names.size(); ++i) names |= NameSet{1} << bit++;
        assert(bit <= most_bits);
        sets.push_back(names);
    }
    return sets;
}

RepresentedParts represented_parts(const ir::System& system, const Representatives& few, ir::TypeId id,
                                   const ir::Value& value) {
    RepresentedParts parts{0, std::vector<std::size_t>(few.types.size(), 0)};
    std::size_t bit = 0;
    for (std::size_t type = 0; type < few.types.size(); ++type) {
        const std::vector<ir::Value>& names = few.types[type].names;
        if (same_type(system, few.types[type].type, id)) {
            const auto name = std::ranges::find(names, value);
            if (name != names.end()) parts.names = NameSet{1} << (bit + static_cast<std::size_t>(name - names.begin()));
            parts.counts[type] = 1;
            return parts;
        }
        bit += names.size();
    }
    for_each_part(system.type(id), value, [&](ir::TypeId part_type, const ir::Value& part) {
        const RepresentedParts inner = represented_parts(system, few, part_type, part);
        parts.names |= inner.names;
        for (std::size_t type = 0; type < parts.counts.size(); ++type) parts.counts[type] += inner.counts[type];
    });
    return parts;
}

Representatives choose_representatives(const ir::System& system, const ir::Instantiation& instantiation,
                                       const cpp_emit::Component& component, std::size_t names,
                                       const ListBounds& bounds) {
    Representatives result = RepresentativeChooser(system, instantiation, component, names).choose();
    extend_carriers(result.instantiation, system, bounds, cpp_emit::max_input_values);
    return result;
}

}  // namespace robochart::conformance
