// SPDX-License-Identifier: Apache-2.0
// The values that represent a data independent type (Lazić 1999; Roscoe UCS 17.2).
#include "conformance/model/representatives.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <set>

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

/// Makes values that differ in every part: each leaf gets the next value of its carrier. `shift` is the offset of the
/// first value.
class Sample {
public:
    Sample(const ir::System& system, const ir::Instantiation& instantiation, std::size_t shift)
        : system_(system), instantiation_(instantiation), next_(shift) {}

    /// A value of the type; no value for functions and relations, whose values have no fixed shape. Recursion depth:
    /// the depth of types.
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
        return values[next_++ % values.size()];
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
};

class Chooser {
public:
    Chooser(const ir::System& system, const ir::Instantiation& instantiation, const cpp_emit::Component& component)
        : system_(system), component_(component), result_{instantiation, {}} {
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
        return std::move(result_);
    }

private:
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
        const std::size_t all = values.size() + 2;
        for (std::size_t shift = 0; shift < attempts && values.size() < all; ++shift) {
            std::optional<ir::Value> value = Sample(system_, result_.instantiation, shift).sample_value(id);
            if (!value) return false;
            values.insert(std::move(*value));
        }
        if (values.size() < all) return false;
        const std::vector<ir::Value> chosen(values.begin(), values.end());
        for (std::uint32_t other = 0; other < system_.types.size(); ++other)
            if (same_type(system_, id, ir::TypeId{other})) result_.instantiation.representatives[other] = chosen;
        result_.types.push_back({id, ir::type_text(system_, id), chosen.size()});
        return true;
    }

    /// The initial values of variables and constants of the type.
    [[nodiscard]] std::set<ir::Value> fixed_values(ir::TypeId id) const {
        std::set<ir::Value> values{ir::default_value(system_, result_.instantiation, id)};
        for_each_fixed([&](ir::TypeId type, const ir::Value& value) {
            if (same_type(system_, id, type)) values.insert(value);
        });
        return values;
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

    /// Represents a kind of numbers at the boundary by the initial and written numbers of the component and two further
    /// numbers.
    void represent_numbers(ir::TypeKind kind, std::vector<std::int64_t>& carrier) {
        const bool used =
            std::ranges::any_of(seen_, [&](std::uint32_t index) { return system_.types[index].kind == kind; });
        if (!used || !independent_.is_independent(kind)) return;
        std::set<std::int64_t> component_numbers{0};
        for_each_fixed([&](ir::TypeId type, const ir::Value& value) {
            collect_numbers(system_.type(type), value, kind, component_numbers);
        });
        for (const cpp_emit::Unit& unit : component_.units) collect_literals(*unit.machine, component_numbers);
        std::vector<std::int64_t> chosen;
        std::size_t more = 2;
        for (const std::int64_t number : carrier)
            if (component_numbers.count(number) > 0 || (more > 0 && more-- > 0)) chosen.push_back(number);
        if (more > 0 || chosen.size() == carrier.size()) return;
        carrier = std::move(chosen);
        for (std::uint32_t index = 0; index < system_.types.size(); ++index) {
            if (system_.types[index].kind != kind) continue;
            result_.types.push_back({ir::TypeId{index}, ir::type_text(system_, ir::TypeId{index}), carrier.size()});
            break;
        }
    }

    /// The numbers of a kind in a value. Recursion depth: the depth of types.
    void collect_numbers(const ir::Type& type, const ir::Value& value, ir::TypeKind kind,
                         std::set<std::int64_t>& found) const {
        if (type.kind == kind) found.insert(value.number);
        for (std::size_t i = 0; i < value.parts.size(); ++i) {
            const bool literal = type.kind == ir::TypeKind::enumeration;
            const std::vector<ir::TypeId>& args =
                literal ? type.literal_args.at(static_cast<std::size_t>(value.number)) : type.args;
            const bool row = args.empty();  // the row of a matrix, visited with the type of its elements
            const std::size_t place = args.size() > 1 ? i : 0;
            collect_numbers(row ? type : system_.type(args[place]), value.parts[i], kind, found);
        }
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

Representatives choose_representatives(const ir::System& system, const ir::Instantiation& instantiation,
                                       const cpp_emit::Component& component) {
    return Chooser(system, instantiation, component).choose();
}

}  // namespace robochart::conformance
