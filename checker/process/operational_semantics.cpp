// Memoised transitions of terms. Dependencies are computed with a stack of our own, so that deep terms cost heap,
// not machine stack, and recursion without an event is found instead of followed.
#include "checker/process/operational_semantics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

#include "checker/process/firing_rules.hpp"

namespace robochart::process {
namespace {

/// Definitions that unfold each other this often without an event, or operators nested this deep, are taken for
/// endless.
constexpr std::size_t deepest_nesting = 1'000'000;

enum class Progress : std::uint8_t { unknown, pending, known };

}  // namespace

struct OperationalSemantics::Impl final : KnownTransitions {
    explicit Impl(TermStore& store) : terms(store), rules(store, *this) {}

    TermStore& terms;
    FiringRules rules;
    std::vector<Progress> progress;
    std::deque<std::vector<Transition>> transitions;

    std::span<const Transition> of(TermId term) const override { return transitions[static_cast<std::uint32_t>(term)]; }
    bool knows(TermId term) const override {
        const auto index = static_cast<std::uint32_t>(term);
        return index < progress.size() && progress[index] == Progress::known;
    }

    void reserve() {
        progress.resize(terms.size(), Progress::unknown);
        transitions.resize(terms.size());
    }

    void begin(TermId term, std::vector<TermId>& stack);
    void finish(TermId term);
    void compute(TermId root);
    void compute_on(std::vector<TermId>& stack);
};

void OperationalSemantics::Impl::begin(TermId term, std::vector<TermId>& stack) {
    reserve();
    Progress& state = progress[static_cast<std::uint32_t>(term)];
    if (state == Progress::pending)
        throw SemanticsError(
            fmt::format("the process {} is defined by itself before any event", describe(terms, term)));
    if (stack.size() >= deepest_nesting)
        throw SemanticsError(fmt::format("more than {} processes inside each other before any event", deepest_nesting));
    state = Progress::pending;
    stack.push_back(term);
}

void OperationalSemantics::Impl::finish(TermId term) {
    std::vector<Transition> result = rules.transitions(term);
    reserve();
    const auto index = static_cast<std::uint32_t>(term);
    transitions[index] = std::move(result);
    progress[index] = Progress::known;
}

void OperationalSemantics::Impl::compute_on(std::vector<TermId>& stack) {
    while (!stack.empty()) {
        const TermId top = stack.back();
        if (const std::optional<TermId> missing = rules.missing_operand(top)) {
            begin(*missing, stack);
        } else {
            finish(top);
            stack.pop_back();
        }
    }
}

void OperationalSemantics::Impl::compute(TermId root) {
    std::vector<TermId> stack;
    try {
        begin(root, stack);
        compute_on(stack);
    } catch (...) {
        for (TermId term : stack) progress[static_cast<std::uint32_t>(term)] = Progress::unknown;
        throw;
    }
}

OperationalSemantics::OperationalSemantics(TermStore& terms) : impl_(std::make_unique<Impl>(terms)) {}
OperationalSemantics::~OperationalSemantics() = default;

std::span<const Transition> OperationalSemantics::successors(TermId term) {
    if (!impl_->knows(term)) impl_->compute(term);
    return impl_->of(term);
}

TermStore& OperationalSemantics::terms() const {
    return impl_->terms;
}

}  // namespace robochart::process
