// Chains of operation calls inside a controller must end: RoboTool bounds recursion (semantics 3.8), here it is
// refused.
#include <algorithm>
#include <set>

#include "semantics/lower/components.hpp"
#include "semantics/query.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

/// Depth-first search over "calls" between the definitions of one controller.
class CallSearch {
public:
    CallSearch(Lowering& lowering, const Controller& controller) : lowering_(lowering), controller_(controller) {}

    void run() {
        for (const auto id : controller_.definitions) visit(id);
    }

private:
    void visit(MachineId id) {
        const auto at = std::find(chain_.begin(), chain_.end(), id);
        if (at != chain_.end()) return report(at);
        if (!done_.insert(id).second) return;
        chain_.push_back(id);
        const Machine& machine = lowering_.system.machine(id);
        for (const auto operation : called_operations(machine)) {
            const MachineId callee = definition_in(lowering_.system, controller_, machine.operations[operation.index]);
            if (callee.valid()) visit(callee);
        }
        chain_.pop_back();
    }

    void report(std::vector<MachineId>::const_iterator from) {
        const Machine& first = lowering_.system.machine(*from);
        std::string chain;
        for (auto it = from; it != chain_.end(); ++it) chain += lowering_.system.machine(*it).name + " calls ";
        chain += first.name;
        lowering_.diagnostics.report(rules::recursive_operation, first.origin.span, {first.name, chain});
    }

    Lowering& lowering_;
    const Controller& controller_;
    std::vector<MachineId> chain_;
    std::set<MachineId> done_;
};

}  // namespace

namespace {

void check_constants(Lowering& lowering, const Controller& controller, std::size_t definition) {
    const Machine& machine = lowering.system.machine(controller.definitions[definition]);
    const std::string& part = controller.definition_names[definition];
    for (std::uint32_t i = 0; i < machine.constants.size(); ++i) {
        const auto sources = constant_sources(lowering.system, nullptr, controller, part, machine, ConstantId{i});
        if (sources.size() < 2) continue;
        std::string names;
        for (const auto& source : sources) names += (names.empty() ? "" : ", ") + source.name;
        lowering.diagnostics.report(rules::ambiguous_constant, machine.origin.span,
                                    {machine.name, machine.constants[i].name, controller.name, names});
    }
}

}  // namespace

void check_calls(Lowering& lowering) {
    for (const auto& controller : lowering.system.controllers) {
        CallSearch(lowering, controller).run();
        for (std::size_t i = 0; i < controller.definitions.size(); ++i) check_constants(lowering, controller, i);
    }
}

}  // namespace robochart::ir
