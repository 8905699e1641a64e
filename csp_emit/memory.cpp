// The machine's side of shared variables (semantics 3.7): it keeps its own copy of every required variable, and
// others may write the copy at any moment by set_EXT_x, except while a platform operation is being called, a
// single event stands under a deadline, or a precondition has failed: RoboTool's processes for these
// (`opCall -> SKIP`, `EDeadline`, `false & ...`) do not offer share__.
#include "checker/cspm/build.hpp"
#include "csp_emit/machine.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

bool MachineEmitter::refuses_writes(const Place& place) const {
    const Item& item = place.head();
    if (item.kind == ItemKind::stuck) return true;
    if (item.stmt == nullptr || (item.kind != ItemKind::statement && item.kind != ItemKind::frozen)) return false;
    if (item.stmt->kind == ir::StmtKind::call) return !defined(place, *item.stmt);
    if (item.stmt->kind != ir::StmtKind::communicate) return false;
    const Link* next = place.thread->rest->tail.get();
    return next != nullptr && next->head.kind == ItemKind::deadline_end &&
           next->head.stmt->body.at(0).get() == item.stmt;
}

void MachineEmitter::external_writes(const Activation& config, const View& view, std::vector<ExprPtr>& out) {
    for (const Place& place : view.places)
        if (refuses_writes(place)) return;
    for (const CellId cell : frames_[0].variables) {
        if (!cells_[cell].shared) continue;
        const ExprPtr next = go(config, {{cell, b::name("in__")}});
        out.push_back(b::prefix(b::name("set_EXT_" + cells_[cell].channel), {b::input("in__")}, next));
    }
}

}  // namespace robochart::csp_emit
