// SPDX-License-Identifier: Apache-2.0
// Runs random models through the generator: generates code, compiles it in batches, explores it over all inputs,
// compares it with the semantics, and shrinks models that differ.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/conformance/batches/batch.hpp"
#include "tests/random_models/models/project.hpp"
#include "tests/random_models/models/shape.hpp"

namespace robochart::conformance::test {

/// A model whose code differs from its semantics or does not compile.
struct Disagreement {
    std::uint64_t seed = 0;
    std::string what;  ///< the difference, or the compiler's first error
};

/// Counts of the results.
struct Tally {
    std::map<std::string, std::size_t> outcomes;
    std::map<std::string, std::size_t> constructs;  ///< constructs in models that conform
    std::size_t models = 0, conforming = 0, cycles = 0;
    std::vector<Disagreement> disagreements;
};

class Campaign {
public:
    using ShapeOf = std::function<random_models::Shape(std::uint64_t seed)>;

    Campaign(ShapeOf shape_of, bool all_choices) : shape_of_(std::move(shape_of)), all_choices_(all_choices) {}

    void add_model(std::uint64_t seed);
    /// Judges the models that were added since the last batch.
    void judge_remaining();
    [[nodiscard]] const Tally& tally() const { return tally_; }
    /// Shrinks the model while it still shows a disagreement of the same kind. Returns the smallest model found, with
    /// its disagreement.
    [[nodiscard]] std::string shrink_disagreement(const Disagreement& found, std::size_t budget) const;

private:
    /// A model in the current batch.
    struct Prepared {
        std::unique_ptr<Candidate> candidate;  ///< null if the generator rejected it
        std::string refusal;
    };

    [[nodiscard]] Options options() const;
    [[nodiscard]] Prepared prepare_candidate(const random_models::Project& project) const;
    /// Describes the disagreement of one model, or returns "" if there is none.
    [[nodiscard]] std::string find_disagreement(const random_models::Project& project) const;
    void judge_batch(std::vector<std::uint64_t> seeds, std::vector<std::unique_ptr<Candidate>> candidates);
    void count_result(std::uint64_t seed, const Candidate& candidate, const Result& result);

    ShapeOf shape_of_;
    bool all_choices_ = false;
    std::vector<std::unique_ptr<Candidate>> candidates_;
    std::vector<std::uint64_t> seeds_;
    Tally tally_;
};

}  // namespace robochart::conformance::test
