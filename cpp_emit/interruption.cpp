#include "cpp_emit/interruption.hpp"

#include <algorithm>
#include <vector>

#include "cpp_emit/walk.hpp"

namespace robochart::cpp_emit {

namespace {

class Interruption {
public:
    explicit Interruption(Component& component) : component_(component) {}

    void mark() {
        for (const Unit& unit : component_.units)
            for (const ir::Node& node : unit.machine->nodes) statement(unit, node.during);
    }

private:
    void statement(const Unit& unit, const ir::StmtPtr& body) {
        visit(body, [&](const ir::Stmt& stmt) {
            if (stmt.kind == ir::StmtKind::assign) variable(unit, stmt.variable);
            if (stmt.kind == ir::StmtKind::communicate && stmt.communication.kind == ir::CommKind::input)
                variable(unit, stmt.communication.variable);
            if (stmt.kind == ir::StmtKind::call) call(unit, stmt.operation);
        });
    }

    void variable(const Unit& unit, ir::VariableId id) {
        if (!id.valid()) return;
        const StoredVariable* const stored = component_.stored(unit, id);
        if (stored == nullptr || !stored->visible) return;
        for (StoredVariable& entry : component_.variables)
            if (entry.visible && entry.variable->name == stored->variable->name) entry.interruptible = true;
    }

    void call(const Unit& unit, ir::OperationId id) {
        if (unit.definitions[id.index].valid()) return operation(component_.callee(unit, id));
        const std::string& name = component_.call(unit, id).signature->name;
        for (PlatformCall& each : component_.calls)
            if (each.signature->name == name) each.interruptible = true;
    }

    void operation(const Unit& unit) {
        if (std::find(done_.begin(), done_.end(), &unit) != done_.end()) return;
        done_.push_back(&unit);
        for (const ir::Node& node : unit.machine->nodes)
            for (const ir::StmtPtr& action : {node.entry, node.during, node.exit}) statement(unit, action);
        for (const ir::Transition& transition : unit.machine->transitions) {
            statement(unit, transition.action);
            if (transition.trigger) variable(unit, transition.trigger->variable);
        }
    }

    Component& component_;
    std::vector<const Unit*> done_;
};

}  // namespace

void mark_interruptible(Component& component) {
    Interruption(component).mark();
}

std::string done_flag(const PlatformCall& call) {
    return call.method + "_done_";
}

std::string done_flag(const StoredVariable& variable) {
    return variable.output + "_done_";
}

}  // namespace robochart::cpp_emit
