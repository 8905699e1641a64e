// SPDX-License-Identifier: Apache-2.0
// Computes the value at which a clock may saturate (semantics 3.10 stops clocks at the greatest value of their type).
#include <algorithm>
#include <set>

#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

const std::vector<std::int64_t>& carrier_of(const Instantiation& instantiation, TypeKind kind) {
    if (kind == TypeKind::real) return instantiation.real;
    return kind == TypeKind::integer ? instantiation.integer : instantiation.nat;
}

/// Returns a whole number that is at least as large as every value of the expression, in time units.
std::int64_t upper_bound(const System& system, const Instantiation& instantiation, const Machine& machine,
                         const Expr& expr) {
    const TypeKind kind = expr.type.is_valid() ? system.type(expr.type).kind : TypeKind::nat;
    const auto& carrier = carrier_of(instantiation, kind);
    std::int64_t bound = carrier.empty() ? 0 : carrier.back();
    // A constant may have different values in different contexts (controllers). So the bound is exact only without
    // constants.
    bool exact = true;
    visit_operands(expr, [&](const Expr& part) { exact = exact && part.kind != ExprKind::constant; });
    if (const auto value = evaluate_constant(system, instantiation, &machine, expr))
        bound = exact ? value->number : std::max(bound, value->number);
    if (kind != TypeKind::real) return bound;
    const std::int64_t down = *floor_divide(bound, instantiation.scale);
    return down + (*floor_modulus(bound, instantiation.scale) != 0 ? 1 : 0);
}

class Saturation {
public:
    Saturation(const System& system, const Instantiation& instantiation)
        : system_(system), instantiation_(instantiation) {}

    void read_machine(const Machine& machine, ClockId clock);
    [[nodiscard]] std::int64_t largest() const { return largest_; }

private:
    void read_comparison(const Machine& machine, ClockId clock, const Expr& expr);

    const System& system_;
    const Instantiation& instantiation_;
    std::set<std::string> seen_;
    std::int64_t largest_ = 0;
};

void Saturation::read_comparison(const Machine& machine, ClockId clock, const Expr& expr) {
    if (!is_comparison(expr.kind) || expr.args.size() != 2) return;
    for (std::size_t side = 0; side < 2; ++side) {
        const Expr& other = *expr.args[1 - side];
        if (clock_of(machine, *expr.args[side]) == clock && !reads_clock(other))
            largest_ = std::max(largest_, upper_bound(system_, instantiation_, machine, other));
    }
}

/// Reads the machine's own comparisons, and then those of called operations that share the machine's clock.
void Saturation::read_machine(const Machine& machine, ClockId clock) {
    if (!seen_.insert(machine.package + "::" + machine.path).second) return;
    visit_expressions(machine, [&](const Expr& root, ExprRole) {
        visit_operands(root, [&](const Expr& expr) { read_comparison(machine, clock, expr); });
    });
    const std::string& name = machine.clocks.at(clock.index).name;
    for (const auto operation : called_operations(machine))
        for (const auto& callee : system_.machines) {
            if (callee.kind != MachineKind::operation || callee.name != machine.operations[operation.index].name)
                continue;
            for (std::uint32_t i = 0; i < callee.clocks.size(); ++i)
                if (callee.clocks[i].required && callee.clocks[i].name == name) this->read_machine(callee, ClockId{i});
        }
}

}  // namespace

std::int64_t clock_saturation(const System& system, const Instantiation& instantiation, const Machine& machine,
                              ClockId clock) {
    Saturation saturation(system, instantiation);
    saturation.read_machine(machine, clock);
    return number_after(saturation.largest());
}

}  // namespace robochart::ir
