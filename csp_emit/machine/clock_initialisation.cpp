// Whether a clock is initialised (assertions.md 4: RoboTool has no check for it). A clock starts with its machine, but
// a guard that reads it before any reset reads a time that nobody has set. The machine remembers in one more parameter
// whether the clock has been reset in its life, and says where it is read before.
#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/machine.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

void MachineEmitter::add_watch(Frame& frame, bool root) {
    if (context_.watched.empty()) return;
    const auto& clocks = frame.machine->clocks;
    for (std::uint32_t i = 0; i < clocks.size(); ++i) {
        const bool callers = clocks[i].required && !root && frames_[frame.parent].watched;
        if (clocks[i].name == context_.watched && !clocks[i].entry_of.valid() && (root || callers))
            frame.watched = ir::ClockId{i};
    }
    if (!root) return;
    Cell cell;
    cell.name = "set__";
    cell.meaning = context_.watched + " has been reset";
    watch_ = add_cell(cell);
    frame.own.push_back(*watch_);
    mean("reset__", {MeaningKind::transition, context_.watched + " has been reset", {}, {}});
}

void MachineEmitter::note_reset(const Frame& frame, ir::ClockId clock, Values& values) const {
    if (frame.watched == clock) values[*watch_] = b::boolean(true);
}

/// Offers `reset__` besides the process once the clock has been reset.
ExprPtr MachineEmitter::was_reset(const ExprPtr& process) const {
    if (!watch_) return process;
    const ExprPtr told = b::guard(b::name(cells_[*watch_].name), b::prefix(b::name("reset__"), b::stop()));
    return b::choice({process, told});
}

/// Guards are read where the machine is settled, of all transitions that could fire (semantics 3.4).
void MachineEmitter::watch_branches(const View& view, std::vector<ExprPtr>& out) {
    if (!watch_) return;
    const ExprPtr before = b::logical_not(b::name(cells_[*watch_].name));
    for (const Spot& spot : view.spots) {
        const std::uint32_t index = spot.activation->frame;
        const Frame& frame = frames_[index];
        const auto reads = [&](const ir::Expr& part) {
            return part.kind == ir::ExprKind::since && frame.watched == part.clock;
        };
        for (const ir::TransitionId id : candidates(*spot.activation)) {
            const ir::Transition& transition = frame.machine->transitions[id.index];
            if (!transition.guard || !mentions(*transition.guard, reads)) continue;
            const auto [found, added] = reads_of_watched_.try_emplace({index, id.index}, reads_of_watched_.size());
            const std::string number = std::to_string(found->second);
            if (added)
                mean("unset__." + number, {MeaningKind::transition,
                                           "the condition of " + transition.name + " reads " + context_.watched +
                                               ", which nothing has reset",
                                           {},
                                           transition.origin});
            const ExprPtr event = b::dot({b::name("unset__"), b::number(static_cast<std::int64_t>(found->second))});
            out.push_back(b::guard(before, b::prefix(event, b::stop())));
        }
    }
}

void MachineEmitter::declare_watch(std::vector<cspm::DeclPtr>& decls) const {
    if (!watch_) return;
    decls.push_back(b::channel({"reset__"}));
    const auto last = static_cast<std::int64_t>(reads_of_watched_.size()) - 1;
    if (last >= 0) decls.push_back(b::channel({"unset__"}, b::set_range(b::number(0), b::number(last))));
}

}  // namespace robochart::csp_emit
