// The samples of a question, one after the other, made by several threads.
#pragma once

#include <memory>
#include <vector>

#include "checker/prism/sampling/method.hpp"
#include "checker/prism/sampling/path_question.hpp"

namespace robochart::prism {

/// Sample i is what path i answers: it depends on the seed and on i alone. They are made in blocks ahead of what is
/// asked for; the sizes of these do not depend on the number of threads either.
class Sampler {
public:
    /// `question` as for PathQuestion; `instance` outlives it. `constants` are those of the properties. At most `most`
    /// samples are made. Throws Unsampled, EvaluationError.
    Sampler(const Instance& instance, const Expr& question, const Values& constants, std::uint64_t most,
            const SamplingOptions& options);
    ~Sampler();
    Sampler(const Sampler&) = delete;
    Sampler& operator=(const Sampler&) = delete;

    /// Throws EvaluationError, LimitReached.
    [[nodiscard]] Sample next();
    /// Warnings of all threads, each once.
    void report(diagnostics::Diagnostics& diagnostics) const;

private:
    struct Worker;
    void fill();

    const SamplingOptions& options_;
    const std::uint64_t most_;
    std::vector<std::unique_ptr<Worker>> workers_;
    std::vector<Sample> block_;
    std::size_t taken_ = 0;       ///< of the block
    std::uint64_t finished_ = 0;  ///< samples of blocks before
};

}  // namespace robochart::prism
