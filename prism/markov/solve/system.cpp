// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/system.hpp"

#include <algorithm>

#include "prism/markov/solve/arithmetic.hpp"

namespace robochart::markov {
namespace {

constexpr std::uint32_t no_choice = 0xFFFFFFFF;

/// Searches breadth-first from outside, against the direction of the entries. It follows all choices, or only those of
/// one policy.
template <class Value>
class LeavingPolicy {
public:
    LeavingPolicy(const System<Value>& system, const Policy* only)
        : system_(system),
          only_(only),
          policy_(system.size(), no_choice),
          first_(system.size() + 1, 0),
          owner_(system.choices()) {
        index_sources();
    }

    Policy find() {
        for (std::uint32_t unknown = 0; unknown < system_.size(); ++unknown)
            for (std::uint32_t choice = system_.first_choice[unknown]; choice < system_.first_choice[unknown + 1];
                 ++choice)
                if (!is_zero(system_.outside[choice])) take_choice(unknown, choice);
        for (std::size_t next = 0; next < queue_.size(); ++next)
            for (std::uint64_t at = first_[queue_[next]]; at < first_[queue_[next] + 1]; ++at)
                take_choice(owner_[incoming_[at]], incoming_[at]);
        return std::move(policy_);
    }

private:
    void index_sources() {
        for (std::uint32_t unknown = 0; unknown < system_.size(); ++unknown)
            for (std::uint32_t choice = system_.first_choice[unknown]; choice < system_.first_choice[unknown + 1];
                 ++choice)
                owner_[choice] = unknown;
        for (const std::uint32_t unknown : system_.unknown) ++first_[unknown + 1];
        for (std::size_t unknown = 0; unknown < system_.size(); ++unknown) first_[unknown + 1] += first_[unknown];
        incoming_.resize(system_.unknown.size());
        std::vector<std::uint64_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t choice = 0; choice < system_.choices(); ++choice)
            for (std::uint64_t entry = system_.first_entry[choice]; entry < system_.first_entry[choice + 1]; ++entry)
                incoming_[next[system_.unknown[entry]]++] = choice;
    }

    void take_choice(std::uint32_t unknown, std::uint32_t choice) {
        if (policy_[unknown] != no_choice || (only_ != nullptr && (*only_)[unknown] != choice)) return;
        policy_[unknown] = choice;
        queue_.push_back(unknown);
    }

    const System<Value>& system_;
    const Policy* const only_;
    Policy policy_;
    std::vector<std::uint64_t> first_;
    std::vector<std::uint32_t> incoming_;  // choices
    std::vector<std::uint32_t> owner_;     // by choice
    std::vector<std::uint32_t> queue_;
};

}  // namespace

template <class Value>
Policy leaving_policy(const System<Value>& system) {
    return LeavingPolicy<Value>(system, nullptr).find();
}

template <class Value>
bool always_leaves(const System<Value>& system, const Policy& policy) {
    return LeavingPolicy<Value>(system, &policy).find() == policy;
}

template Policy leaving_policy(const System<Interval>&);
template Policy leaving_policy(const System<Rational>&);
template bool always_leaves(const System<Rational>&, const Policy&);

}  // namespace robochart::markov
