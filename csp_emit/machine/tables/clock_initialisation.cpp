// SPDX-License-Identifier: Apache-2.0
// Adds a parameter for the watched clock, and an event for each guard that reads the clock.
#include "csp_emit/machine/tables/clock_initialisation.hpp"

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

ClockWatch::ClockWatch(const MachineContext& context, const ActivationRecords& frames, ParameterTable& cells,
                       Provenance& provenance)
    : context_(context), frames_(frames), cells_(cells), provenance_(provenance) {
    if (context.watched.empty()) return;
    Cell cell;
    cell.name = "set__";
    cell.meaning = context.watched + " has been reset";
    mean(provenance, context.path, "reset__", {MeaningKind::transition, cell.meaning, {}, {}});
    cell_ = cells.add_cell(std::move(cell));
}

void ClockWatch::note_reset(const Frame& frame, ir::ClockId clock, Values& values) const {
    if (frame.watched == clock) values[*cell_] = b::boolean(true);
}

ExprPtr ClockWatch::with_reset(const ExprPtr& process) const {
    if (!cell_) return process;
    return b::choice({process, b::guard(cells_.parameter_name(*cell_), b::prefix(b::name("reset__"), b::stop()))});
}

ExprPtr ClockWatch::read_unset(std::uint32_t index, ir::TransitionId id) {
    if (!cell_) return nullptr;
    const Frame& frame = frames_[index];
    const ir::Transition& transition = frame.machine->transitions[id.index];
    const auto reads = [&](const ir::Expr& part) {
        return part.kind == ir::ExprKind::since && frame.watched == part.clock;
    };
    if (!transition.guard || !has_part(*transition.guard, reads)) return nullptr;
    const auto [found, added] = reads_.try_emplace({index, id.index}, reads_.size());
    const std::string text =
        "the condition of " + transition.name + " reads " + context_.watched + ", which nothing has reset";
    if (added)
        mean(provenance_, context_.path, "unset__." + std::to_string(found->second),
             {MeaningKind::transition, text, {}, transition.origin});
    const ExprPtr event = b::dot({b::name("unset__"), b::number(static_cast<std::int64_t>(found->second))});
    return b::guard(b::logical_not(cells_.parameter_name(*cell_)), b::prefix(event, b::stop()));
}

void ClockWatch::declare(std::vector<cspm::DeclPtr>& decls) const {
    if (!cell_) return;
    decls.push_back(b::channel({"reset__"}));
    const auto last = static_cast<std::int64_t>(reads_.size()) - 1;
    if (last >= 0) decls.push_back(b::channel({"unset__"}, b::set_range(b::number(0), b::number(last))));
}

}  // namespace robochart::csp_emit
