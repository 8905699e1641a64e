// SPDX-License-Identifier: Apache-2.0
// Computes capacities of sets. The capacity of a set in generated code is the number of values of its elements' type,
// so that no element is lost. This number is both written as a C++ expression over the Types policy and computed for
// the carriers of the instantiation. If a type has more values on the robot than in its carrier, sets of this type have
// the usual capacity of a list on the robot.
#include <fmt/format.h>

#include <algorithm>

#include "cpp_emit/plan/types.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::cpp_emit {

using ir::TypeKind;

namespace {

std::size_t bound_count(std::size_t count) {
    return std::min(count, largest_set + 1);
}

std::size_t times(std::size_t a, std::size_t b) {
    return bound_count(bound_count(a) * bound_count(b));
}

std::size_t power(std::size_t base, std::size_t exponent) {
    std::size_t result = 1;
    for (std::size_t i = 0; i < exponent; ++i) result = times(result, base);
    return result;
}

/// Counts values. `Count` is a number or a text.
template <class Count, class Rules>
Count count(const ir::System& system, ir::TypeId id, const Rules& rules) {
    const ir::Type& type = system.type(id);
    const auto all = [&](const std::vector<ir::TypeId>& parts) {
        Count result = rules.number(1);
        for (const ir::TypeId part : parts) result = rules.times(result, count<Count>(system, part, rules));
        return result;
    };
    switch (type.kind) {
        case TypeKind::boolean:
            return rules.number(2);
        case TypeKind::enumeration: {
            Count result = rules.number(0);
            for (std::size_t i = 0; i < type.labels.size(); ++i)
                result = rules.plus(result, i < type.literal_args.size() ? all(type.literal_args[i]) : rules.number(1));
            return result;
        }
        case TypeKind::product:
        case TypeKind::record:
            return all(type.args);
        case TypeKind::vector:
        case TypeKind::matrix: {
            std::size_t entries = 1;
            for (const std::int64_t size : type.sizes) entries *= static_cast<std::size_t>(size);
            return rules.power(count<Count>(system, type.args.at(0), rules), rules.number(entries));
        }
        case TypeKind::sequence:
            return rules.sequences(count<Count>(system, type.args.at(0), rules));
        case TypeKind::set:
        case TypeKind::relation:
            return rules.power(rules.number(2), all(type.args));
        case TypeKind::function:
            return rules.power(count<Count>(system, type.args.at(1), rules),
                               count<Count>(system, type.args.at(0), rules));
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::real:
        case TypeKind::string:
        case TypeKind::given:
        case TypeKind::unit:
            break;
    }
    return rules.longest();
}

struct Numbers {
    std::size_t most;
    [[nodiscard]] static std::size_t number(std::size_t n) { return n; }
    [[nodiscard]] static std::size_t times(std::size_t a, std::size_t b) { return cpp_emit::times(a, b); }
    [[nodiscard]] static std::size_t plus(std::size_t a, std::size_t b) { return bound_count(a + b); }
    [[nodiscard]] static std::size_t power(std::size_t a, std::size_t b) { return cpp_emit::power(a, bound_count(b)); }
    [[nodiscard]] std::size_t sequences(std::size_t items) const {
        std::size_t result = 1;
        for (std::size_t i = 0; i < most; ++i) result = bound_count(1 + times(items, result));
        return result;
    }
    [[nodiscard]] std::size_t longest() const { return most; }
};

struct Texts {
    std::string policy;
    [[nodiscard]] static std::string number(std::size_t n) { return fmt::format("{}", n); }
    [[nodiscard]] static std::string times(const std::string& a, const std::string& b) {
        if (a == "1") return b;
        return b == "1" ? a : fmt::format("{} * {}", a, b);
    }
    [[nodiscard]] static std::string plus(const std::string& a, const std::string& b) {
        const bool numbers = a.find_first_not_of("0123456789") == std::string::npos && b == "1";
        if (numbers) return fmt::format("{}", std::stoul(a) + 1);
        return a == "0" ? b : fmt::format("({} + {})", a, b);
    }
    [[nodiscard]] static std::string power(const std::string& a, const std::string& b) {
        return fmt::format("robochart::power({}, {})", a, b);
    }
    [[nodiscard]] std::string sequences(const std::string& items) const {
        return fmt::format("robochart::sequences({}, {})", items, longest());
    }
    [[nodiscard]] std::string longest() const { return policy + "::longest"; }
};

template <class Count, class Rules>
Count members_of(const ir::System& system, const ir::Type& type, const Rules& rules) {
    Count result = rules.number(1);
    for (const ir::TypeId part : type.args) result = rules.times(result, count<Count>(system, part, rules));
    return result;
}

}  // namespace

std::string set_capacity(const ir::System& system, const ir::Type& type, const Spelling& spelling) {
    const auto text = members_of<std::string>(system, type, Texts{spelling.types});
    const std::size_t given = given_capacity(type);
    if (text.find_first_of("*(+") == std::string::npos)
        return given == 0 ? text : fmt::format("robochart::capacity<{}>({})", spelling.types, given);
    const auto deployed = [&](const std::string& capacity) {
        return fmt::format("robochart::set_places<{}>({}, {})", spelling.types, text, capacity);
    };
    if (given != 0) return deployed(fmt::format("{}", given));
    if (type.kind != TypeKind::set || !ir::has_numbers(system, type.args.at(0)))
        return fmt::format("robochart::places({})", text);
    if (!has_lists(system, type.args[0])) return deployed(spelling.types + "::longest");
    return deployed(fmt::format("robochart::outer_capacity<{}>()", spelling.types));
}

std::size_t set_capacity(const ir::System& system, const ir::Instantiation& inst, const ir::Type& type) {
    return members_of<std::size_t>(system, type, Numbers{longest(inst)});
}

std::size_t deployed_capacity(const ir::System& system, const ir::Type& type) {
    if (const std::size_t given = given_capacity(type); given != 0) return given;
    const auto has_numbers = [&](ir::TypeId part) { return ir::has_numbers(system, part); };
    if (has_pairs(type) || std::ranges::none_of(type.args, has_numbers))
        return std::min(members_of<std::size_t>(system, type, Numbers{usual_capacity}), largest_set);
    return has_lists(system, type.args.at(0)) ? usual_outer_capacity : usual_capacity;
}

}  // namespace robochart::cpp_emit
