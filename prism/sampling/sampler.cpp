// SPDX-License-Identifier: Apache-2.0
// See sampler.hpp.
#include "prism/sampling/sampler.hpp"

#include <algorithm>
#include <atomic>

#include "base/threads/threads.hpp"

namespace robochart::prism {
namespace {

constexpr std::uint64_t first_block = 64;
constexpr std::uint64_t greatest_block = 8192;

}  // namespace

/// The data of one thread.
struct Sampler::Worker {
    Worker(const Instance& instance, const Expr& sampled, const Values& constants, diagnostics::Budget* budget)
        : code(instance.code(constants)),
          walk(instance, code, sampled_from(instance, code, budget), diagnostics),
          question(sampled, instance, code, walk) {}

    diagnostics::Diagnostics diagnostics;
    Code code;
    Walk walk;
    PathQuestion question;
};

Sampler::Sampler(const Instance& instance, const Expr& question, const Values& constants, std::uint64_t most,
                 const SamplingOptions& options)
    : options_(options), most_(most) {
    const std::uint64_t threads = std::min<std::uint64_t>(diagnostics::threads_wanted(options.threads), most);
    for (std::uint64_t i = 0; i < threads; ++i)
        workers_.push_back(std::make_unique<Worker>(instance, question, constants, options.budget));
}

Sampler::~Sampler() = default;

Sample Sampler::next_sample() {
    if (taken_ == block_.size()) fill_block();
    return block_[taken_++];
}

/// Computes the next block of samples. Blocks grow over time, so that few of the computed samples stay unused.
void Sampler::fill_block() {
    finished_ += block_.size();
    taken_ = 0;
    const std::uint64_t size = std::clamp<std::uint64_t>(finished_, first_block, greatest_block);
    block_.assign(std::min(size, most_ - finished_), {});
    // Samples after an undecided one are not used.
    std::atomic<std::size_t> open = block_.size();
    diagnostics::in_parallel(
        block_.size(), static_cast<unsigned>(workers_.size()), [&](std::size_t number, unsigned thread) {
            if (number > open) return;
            const Draws draws(options_.seed, finished_ + number);
            block_[number] = workers_[thread]->question.follow_path(draws, options_.method.path, options_.budget);
            if (block_[number].decided) return;
            for (std::size_t least = open; number < least && !open.compare_exchange_weak(least, number);) {
            }
        });
}

void Sampler::report(diagnostics::Diagnostics& diagnostics) const {
    std::vector<diagnostics::Span> seen;
    for (const auto& worker : workers_)
        for (const diagnostics::Diagnostic& finding : worker->diagnostics.sorted_findings()) {
            if (std::ranges::find(seen, finding.span) != seen.end()) continue;
            seen.push_back(finding.span);
            diagnostics.report(*finding.rule, finding.span, finding.arguments);
        }
}

}  // namespace robochart::prism
