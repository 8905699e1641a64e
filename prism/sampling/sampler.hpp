// SPDX-License-Identifier: Apache-2.0
// Computes the samples of a query with several threads, and returns them in order.
#pragma once

#include <memory>
#include <vector>

#include "prism/sampling/method.hpp"
#include "prism/sampling/path_question.hpp"

namespace robochart::prism {

/// Sample i is the result of path i, so it depends only on the seed and on i. Samples are computed in blocks before
/// they are used. The sizes of blocks do not depend on the number of threads.
class Sampler {
public:
    /// `question` must be supported by PathQuestion. `instance` must outlive the object. `constants` contains the
    /// values of the properties' constants. Computes at most `most` samples. Throws Unsampled, EvaluationError.
    Sampler(const Instance& instance, const Expr& question, const Values& constants, std::uint64_t most,
            const SamplingOptions& options);
    ~Sampler();
    Sampler(const Sampler&) = delete;
    Sampler& operator=(const Sampler&) = delete;

    /// Throws EvaluationError, LimitReached.
    [[nodiscard]] Sample next_sample();
    /// Reports each warning of the threads once.
    void report(diagnostics::Diagnostics& diagnostics) const;

private:
    struct Worker;
    void fill_block();

    const SamplingOptions& options_;
    const std::uint64_t most_;
    std::vector<std::unique_ptr<Worker>> workers_;
    std::vector<Sample> block_;
    std::size_t taken_ = 0;       ///< number of samples taken from the block
    std::uint64_t finished_ = 0;  ///< number of samples in previous blocks
};

}  // namespace robochart::prism
