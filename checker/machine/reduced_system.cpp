#include "checker/machine/reduced_system.hpp"

#include <algorithm>

#include "checker/lts/sink_in_use.hpp"

namespace robochart::machine {

namespace {

/// Whichever state a row of followed taus is left at, it stands for those before it: so a row may be of any length.
constexpr std::size_t most_steps = 1000;

}  // namespace

std::unique_ptr<lts::ReducedSystem> SupercombinatorSystem::reduced(const std::function<void()>& poll) const {
    std::optional<WholeRules> rules = whole_rules(*combined_, poll);
    // A rule that is not of the first level of its regions, or no tau, is never followed.
    const auto may_be_followed = [](const WholeRule& rule) {
        return rule.event == process::tau && rule.prevented.empty();
    };
    if (!rules || std::none_of(rules->rules.begin(), rules->rules.end(), may_be_followed)) return nullptr;
    return std::make_unique<ReducedSystem>(another(), combined_, std::make_shared<const WholeRules>(std::move(*rules)));
}

ReducedSystem::ReducedSystem(std::unique_ptr<lts::TransitionSystem> whole,
                             std::shared_ptr<const Supercombinator> combined, std::shared_ptr<const WholeRules> rules)
    : whole_(std::move(whole)),
      combined_(std::move(combined)),
      rules_(std::move(rules)),
      confluence_(combined_, rules_),
      locals_(combined_->components.size()),
      target_(combined_->words) {}

void ReducedSystem::watch(const std::function<void()>& poll) {
    poll_ = poll;
    whole_->watch(poll);
}

void ReducedSystem::unpack(lts::StateView state) {
    for (std::size_t slot = 0; slot < locals_.size(); ++slot) locals_[slot] = combined_->fields[slot].get(state);
}

void ReducedSystem::pack(std::span<lts::Word> state) const {
    std::fill(state.begin(), state.end(), 0);
    for (std::size_t slot = 0; slot < locals_.size(); ++slot) combined_->fields[slot].put(state, locals_[slot]);
}

void ReducedSystem::initial(std::span<lts::Word> state) {
    whole_->initial(state);
    unpack(state);
    chased_ += run();
    pack(state);
}

void ReducedSystem::successors(lts::StateView state, lts::SuccessorSink& sink) {
    // As in SupercombinatorSystem: the sink may ask for successors while it is given some.
    if (sink_ != nullptr) {
        const auto other = another();
        other->watch(poll_);
        return other->successors(state, sink);
    }
    const lts::SinkInUse in_use(sink_, sink);
    whole_->successors(state, *this);
}

void ReducedSystem::add(Event event, lts::StateView target, Event revealed) {
    unpack(target);
    const std::size_t steps = run();
    if (steps == 0) return sink_->add(event, target, revealed);
    chased_ += steps;
    pack(target_);
    sink_->add(event, target_, revealed);
}

bool ReducedSystem::follow() {
    return confluence_.follow(locals_);
}

/// Follows confluent taus to the end, or to the least state of the cycle that they run into. The number of steps.
/// (Cycles are found as in Brent, BIT 20, 1980.)
std::size_t ReducedSystem::run() {
    if (poll_) poll_();
    begin_ = seen_ = locals_;
    std::size_t length = 0;  // of the cycle, if there is one
    std::size_t next_look = 1;
    for (std::size_t steps = 0; steps < most_steps; ++steps) {
        if (!follow()) return steps;
        ++length;
        if (locals_ == seen_) return enter_cycle(length);
        if (length != next_look) continue;
        seen_ = locals_;
        next_look *= 2;
        length = 0;
    }
    return most_steps;
}

/// From where the run began to the first meeting with the least state of the cycle, one of whose states is the present.
std::size_t ReducedSystem::enter_cycle(std::size_t length) {
    least_ = locals_;
    for (std::size_t i = 0; i < length; ++i) {
        follow();
        least_ = std::min(least_, locals_);
    }
    locals_ = begin_;
    std::size_t steps = 0;
    for (; locals_ != least_; ++steps) follow();
    return steps;
}

std::vector<std::vector<lts::Word>> ReducedSystem::chase(lts::StateView state) {
    unpack(state);
    const std::size_t steps = run();
    std::vector<std::vector<lts::Word>> row;
    unpack(state);
    for (std::size_t i = 0; i < steps; ++i) {
        follow();
        pack(row.emplace_back(width()));
    }
    return row;
}

}  // namespace robochart::machine
