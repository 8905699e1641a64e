// SPDX-License-Identifier: Apache-2.0
// See large_types.hpp.
#include "semantics/instantiate/large_types.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "base/diagnostics/text.hpp"
#include "semantics/ir/literals.hpp"

namespace robochart::ir {
namespace {

class Sizes {
public:
    Sizes(const System& system, const Instantiation& instantiation) : system_(system), instantiation_(instantiation) {}

    /// Returns the number of values of the type.
    [[nodiscard]] double size_of_type(TypeId id) const;
    /// Collects the number types that the type consists of.
    void collect_number_types(TypeId id, std::set<TypeKind>& found) const {
        const Type& type = system_.type(id);
        if (type.kind == TypeKind::nat || type.kind == TypeKind::integer || type.kind == TypeKind::real)
            found.insert(type.kind);
        for (const TypeId part : type.args) collect_number_types(part, found);
        for (const auto& arguments : type.literal_args)
            for (const TypeId part : arguments) collect_number_types(part, found);
    }

private:
    [[nodiscard]] double product_of_sizes(const std::vector<TypeId>& parts) const {
        double result = 1;
        for (const TypeId part : parts) result *= size_of_type(part);
        return result;
    }

    const System& system_;
    const Instantiation& instantiation_;
};

double Sizes::size_of_type(TypeId id) const {
    const Type& type = system_.type(id);
    switch (type.kind) {
        case TypeKind::boolean:
            return 2;
        case TypeKind::nat:
            return static_cast<double>(instantiation_.nat.size());
        case TypeKind::integer:
            return static_cast<double>(instantiation_.integer.size());
        case TypeKind::real:
            return static_cast<double>(instantiation_.real.size());
        case TypeKind::string:
            return static_cast<double>(instantiation_.strings.size());
        case TypeKind::given:
            return static_cast<double>(instantiation_.given_size);
        case TypeKind::enumeration: {
            double result = 0;
            for (std::size_t i = 0; i < type.labels.size(); ++i)
                result += i < type.literal_args.size() ? product_of_sizes(type.literal_args[i]) : 1;
            return result;
        }
        case TypeKind::sequence: {
            double result = 0;
            for (std::int64_t length = 0; length <= instantiation_.sequence_bound; ++length)
                result += std::pow(size_of_type(type.args.at(0)), static_cast<double>(length));
            return result;
        }
        case TypeKind::set:
            return std::pow(2, size_of_type(type.args.at(0)));
        case TypeKind::product:
        case TypeKind::record:
            return product_of_sizes(type.args);
        case TypeKind::relation:
            return std::pow(2, product_of_sizes(type.args));
        case TypeKind::function:
            return std::pow(size_of_type(type.args.at(1)), size_of_type(type.args.at(0)));
        case TypeKind::vector:
        case TypeKind::matrix: {
            double result = 1;
            for (const std::int64_t size : type.sizes) result *= static_cast<double>(size);
            return std::pow(size_of_type(type.args.at(0)), result);
        }
        case TypeKind::unit:
            return 1;
    }
    return 1;
}

/// Returns the types whose values are communicated. Each of these values is enumerated.
std::vector<TypeId> communicated_types(const System& system) {
    std::vector<TypeId> result;
    const auto add = [&](const auto& component) {
        for (const Event& event : component.events)
            if (event.type) result.push_back(*event.type);
        for (const OperationSignature& operation : component.operations)
            result.insert(result.end(), operation.parameters.begin(), operation.parameters.end());
    };
    for (const Machine& machine : system.machines) add(machine);
    for (const Controller& controller : system.controllers) add(controller);
    for (const Module& module : system.modules) add(module.platform);
    return result;
}

/// Returns the number in the model that widens one of these carriers and is farthest from 0, with its place.
std::string widest_number(const System& system, const std::set<TypeKind>& kinds,
                          const diagnostics::SourceManager& sources) {
    const Literals literals = literals_of(system);
    std::int64_t widest = 0;
    const auto look_at = [&](std::int64_t number) {
        if (number != INT64_MIN && std::abs(number) > std::abs(widest)) widest = number;
    };
    for (const std::int64_t number : literals.nat) look_at(number);
    if (!kinds.contains(TypeKind::nat) || kinds.size() > 1)
        for (const std::int64_t number : literals.integer) look_at(number);
    if (kinds.contains(TypeKind::real))
        for (const Decimal& number : literals.real)
            if (number.decimals == 0) look_at(number.unscaled);
    const auto place = literals.places.find(widest);
    if (place == literals.places.end()) return "";
    return fmt::format(", since the model has the number {} ({})", widest, sources.path_and_line(place->second));
}

}  // namespace

std::string large_type(const System& system, const Instantiation& instantiation, double most,
                       const diagnostics::SourceManager& sources) {
    const Sizes sizes(system, instantiation);
    for (const TypeId id : communicated_types(system)) {
        std::set<TypeKind> kinds;
        sizes.collect_number_types(id, kinds);
        const double size = sizes.size_of_type(id);
        if (size <= most || kinds.empty()) continue;
        // The option must give several ranges, because each carrier contains the one before it.
        const char* name = "nat";
        const char* ranges = "--range nat=0..2";
        std::size_t values = instantiation.nat.size();
        if (kinds.contains(TypeKind::real)) {
            name = "real";
            ranges = "--range nat=0..2 --range int=-2..2 --range real=-2..2";
            values = instantiation.real.size();
        } else if (kinds.contains(TypeKind::integer)) {
            name = "int";
            ranges = "--range nat=0..2 --range int=-2..2";
            values = instantiation.integer.size();
        }
        return fmt::format("type {} has about {:.2g} values: {} has {}{}; {} narrows it", system.type(id).name, size,
                           name, values, widest_number(system, kinds, sources), ranges);
    }
    return "";
}

}  // namespace robochart::ir
