// One definition of an operation for all calls of it (semantics 3.8). While an operation runs that the control thread
// has called, its caller does nothing but wait: the configuration is the operation's alone, and where it returns to is
// a value, a sequence of numbers with the innermost call in front, as on a stack. An operation called where other
// things go on (beside during actions, under a deadline) runs in a configuration with its caller.
#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/machine.hpp"
#include "csp_emit/base/types.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

namespace {

/// The element of that name among those of a caller, as text; "-" if there is none.
template <class Element, class Meaning>
std::string bound_to(const std::vector<Element>& elements, const std::string& name, const Meaning& meaning) {
    const auto found = std::find_if(elements.begin(), elements.end(), [&](const Element& e) { return e.name == name; });
    return found == elements.end() ? "-" : meaning(static_cast<std::size_t>(found - elements.begin()));
}

const char* const front_place = "return_place__";
const char* const outer_places = "outer_places__";

ExprPtr pushed(std::int64_t number, const ExprPtr& outer) {
    if (outer->kind == cspm::ExprKind::sequence) return b::sequence({b::number(number)});
    return b::binary(cspm::ExprKind::concat, b::sequence({b::number(number)}), outer);
}

}  // namespace

/// Whether nothing goes on beside the call, so that its caller is described by where it returns to.
bool MachineEmitter::shares(const Place& place, const Activation& returned) const {
    if (!project().options.share_calls) return false;
    if (place.during || returned.frame != place.owner->frame) return false;
    if (!returned.durings.empty() || returned.control.callee) return false;
    for (const Link* link = returned.control.rest.get(); link != nullptr; link = link->tail.get())
        if (!link->head.cells.empty()) return false;
    return monitors(view(returned), {}).empty();
}

/// The frame of the operation for callers that mean the same by the names of variables and clocks that it requires.
std::uint32_t MachineEmitter::shared_frame(std::uint32_t caller, const ir::Machine& operation) {
    const Frame& outer = frames_[caller];
    std::string key = operation.package + "::" + operation.path + (outer.watched ? " watched" : "");
    for (const ir::Variable& variable : operation.variables)
        if (variable.scope == ir::VariableScope::required)
            key += " " + bound_to(outer.machine->variables, variable.name,
                                  [&](std::size_t i) { return std::to_string(outer.variables[i]); });
    for (const ir::Clock& clock : operation.clocks)
        if (clock.required && timed())
            key += " " + bound_to(outer.machine->clocks, clock.name, [&](std::size_t i) {
                       const std::string cell = outer.clocks[i] ? std::to_string(*outer.clocks[i]) : "unread";
                       return cell + outer.announced[i];
                   });
    if (const auto found = shared_frames_.find(key); found != shared_frames_.end()) return found->second;
    return shared_frames_[key] = open_frame(operation, caller, operation.name + "_");
}

/// The places to return to with this one in front; the form is settled once all places are known.
ExprPtr MachineEmitter::push_return(std::uint32_t frame, const Activation& returned, const Values& values) {
    if (!places_) {
        Cell cell;
        cell.name = "places__";
        cell.kind = CellKind::frozen;
        places_ = add_cell(cell);
    }
    Returns& known = returns_[frame];
    const auto [found, added] = known.number.try_emplace(key(returned), known.continuations.size());
    if (added) {
        known.continuations.push_back(continuations_.size());
        continuations_.push_back({frame, returned, "return " + std::to_string(continuations_.size())});
    }
    const bool first = returned.frame == 0;
    Pending pending{frame, std::make_shared<cspm::Expr>(), found->second,
                    first ? b::sequence({}) : value_of(*places_, values)};
    pending_.push_back(pending);
    return pending.value;
}

/// The place among the points where the operation's end is left for where it was called.
std::size_t MachineEmitter::return_point(std::uint32_t frame) {
    const auto [found, added] = point_of_.try_emplace("return " + std::to_string(frame), points_.size());
    if (added) {
        Activation end;
        end.frame = frame;
        const auto& nodes = frames_[frame].machine->nodes;
        const auto is_end = [](const ir::Node& n) { return n.kind == ir::NodeKind::final && !n.parent.valid(); };
        const auto final = std::find_if(nodes.begin(), nodes.end(), is_end);
        end.at = ir::NodeId{static_cast<std::uint32_t>(final - nodes.begin())};
        points_.push_back({end, context_.names.unique(frames_[frame].prefix + "return__"), true});
    }
    return found->second;
}

ExprPtr MachineEmitter::return_from(std::uint32_t frame, const Values& values) {
    const std::size_t index = return_point(frame);
    const ExprPtr call = call_with(points_[index].name, arguments(values), after_tock_);
    return returns_[frame].calls.emplace_back(std::make_shared<cspm::Expr>(*call));
}

/// What goes on behind a call.
ExprPtr MachineEmitter::continued(const Continuation& continuation) {
    run_ = 0;
    branching_ = 0;
    if (continuation.config.frame == 0) return go(continuation.config, {});
    Pending pending{continuation.frame, std::make_shared<cspm::Expr>(), std::nullopt, nullptr};
    pending_.push_back(pending);
    return go(continuation.config, {{*places_, pending.value}});
}

/// By the place in front: what goes on behind that call.
ExprPtr MachineEmitter::dispatch(std::uint32_t frame) const {
    const std::vector<std::size_t>& all = returns_.at(frame).continuations;
    const ExprPtr front = b::call(front_place, {b::name(cells_[*places_].name)});
    ExprPtr result = call_with(continuations_[all.back()].name, {});
    for (std::size_t i = all.size() - 1; i-- > 0;)
        result = b::if_(b::binary(cspm::ExprKind::equal, front, b::number(static_cast<std::int64_t>(i))),
                        call_with(continuations_[all[i]].name, {}), result);
    return result;
}

/// Operations that return to one place only need no number for it.
void MachineEmitter::settle_returns() {
    for (const Pending& pending : pending_) {
        const bool one = returns_.at(pending.frame).continuations.size() == 1;
        const ExprPtr places = b::name(cells_[*places_].name);
        ExprPtr value;
        if (!pending.pushed)
            value = one ? places : b::call(outer_places, {places});
        else if (one)
            value = pending.outer;
        else
            value = pushed(static_cast<std::int64_t>(*pending.pushed), pending.outer);
        *pending.value = *value;
    }
}

/// Where an operation returns to one place only and nothing is to be done there, its end is that place.
void MachineEmitter::skip_returns(std::vector<Function>& functions, const std::vector<Function>& behind) {
    std::map<std::string, std::string> skipped;
    for (const auto& [frame, returns] : returns_)
        if (returns.continuations.size() == 1 && !returns.calls.empty())
            if (const std::string* next = only_calls(*behind[returns.continuations[0]].body))
                skipped[points_[return_point(frame)].name] = *next;
    for (const auto& [frame, returns] : returns_)
        for (const auto& call : returns.calls) {
            auto next = skipped.find(call->args[0]->text);
            for (; next != skipped.end(); next = skipped.find(call->args[0]->text))
                call->args[0] = b::name(next->second);
        }
    std::erase_if(functions, [&](const Function& function) { return skipped.count(function.name) != 0; });
    std::erase_if(points_, [&](const Point& point) { return skipped.count(point.name) != 0; });
}

bool MachineEmitter::returns_to_several() const {
    return std::any_of(returns_.begin(), returns_.end(),
                       [](const auto& returns) { return returns.second.continuations.size() > 1; });
}

/// Puts what goes on behind calls, the functions from `first` on, in the place of the calls of it.
void MachineEmitter::inline_continuations(std::vector<Function>& functions, std::size_t first) {
    std::map<std::string, ExprPtr> bodies;
    for (std::size_t i = first; i < functions.size(); ++i) bodies[functions[i].name] = functions[i].body;
    const std::function<ExprPtr(const ExprPtr&)> put = [&](const ExprPtr& expr) -> ExprPtr {
        const bool applied = expr->kind == cspm::ExprKind::apply;
        const ExprPtr& name = applied ? expr->args[0] : expr;
        if (name->kind == cspm::ExprKind::name)
            if (const auto found = bodies.find(name->text); found != bodies.end()) return found->second;
        if (expr->kind != cspm::ExprKind::if_then_else) return expr;
        auto result = std::make_shared<cspm::Expr>(*expr);
        for (std::size_t i = 1; i < result->args.size(); ++i) result->args[i] = put(result->args[i]);
        return result;
    };
    functions.resize(first);
    for (Function& function : functions) function.body = put(function.body);
}

/// The functions on the places that calls return to.
void MachineEmitter::add_places(std::vector<cspm::DeclPtr>& decls) {
    using cspm::PatternKind;
    const auto pattern = [](PatternKind kind, const std::string& text, std::vector<cspm::PatternPtr> parts) {
        cspm::Pattern result;
        result.kind = kind;
        result.text = text;
        result.args = std::move(parts);
        return std::make_shared<const cspm::Pattern>(std::move(result));
    };
    const auto add = [&](const char* name, const std::string& front, const std::string& rest,
                         const std::string& value) {
        const auto variable = [&](const std::string& text) {
            return pattern(text.empty() ? PatternKind::wildcard : PatternKind::name, text, {});
        };
        const auto one = pattern(PatternKind::sequence, "", {variable(front)});
        decls.push_back(
            b::function_decl(name, {pattern(PatternKind::concat, "", {one, variable(rest)})}, b::name(value)));
    };
    add(front_place, "x__", "", "x__");
    add(outer_places, "", "y__", "y__");
}

/// For arguments that nothing reads: the value that makes the fewest states.
std::map<std::string, ExprPtr> MachineEmitter::values_of_no_interest() const {
    std::map<std::string, ExprPtr> result;
    for (const ConstantParameter& constant : constants_)
        result[constant.inside] = default_literal(project(), constant.type);
    for (const Cell& cell : cells_) {
        if (cell.kind == CellKind::clock)  // at its limit a clock stands still; one of constants may not be known there
            result[cell.name] = cell.limit->kind == cspm::ExprKind::integer ? cell.limit : b::number(0);
        else if (cell.kind == CellKind::variable && cell.type.valid())
            result[cell.name] = default_of(cell.type);
        else
            result[cell.name] = watch_ && cell.name == cells_[*watch_].name ? b::boolean(false) : b::number(0);
    }
    return result;
}

}  // namespace robochart::csp_emit
