// Random models through the generator: emitted, compiled in batches, explored over all inputs, compared with their
// semantics; what differs is made small.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "conformance/check/batch.hpp"
#include "tests/random_models/models/project.hpp"
#include "tests/random_models/models/shape.hpp"

namespace robochart::conformance::test {

/// A model whose code does not do what its semantics says, or does not compile.
struct Disagreement {
    std::uint64_t seed = 0;
    std::string what;  ///< the difference, or the compiler's first error
};

/// What happened to the models.
struct Tally {
    std::map<std::string, std::size_t> outcomes;
    std::map<std::string, std::size_t> constructs;  ///< in models that conform
    std::size_t models = 0, conforming = 0, cycles = 0;
    std::vector<Disagreement> disagreements;
};

class Campaign {
public:
    using ShapeOf = std::function<random_models::Shape(std::uint64_t seed)>;

    Campaign(ShapeOf shape_of, bool all_choices) : shape_of_(std::move(shape_of)), all_choices_(all_choices) {}

    void add(std::uint64_t seed);
    /// Judges what was added since the last batch.
    void finish();
    [[nodiscard]] const Tally& tally() const { return tally_; }
    /// The model of the disagreement cut down for as long as it shows one of the same kind, with what it shows.
    [[nodiscard]] std::string shrunk(const Disagreement& found, std::size_t budget) const;

private:
    /// A model on its way.
    struct Prepared {
        std::unique_ptr<Candidate> candidate;  ///< null: refused
        std::string refusal;
    };

    [[nodiscard]] Options options() const;
    [[nodiscard]] Prepared prepare(const random_models::Project& project) const;
    /// The disagreement of one model; "" if there is none.
    [[nodiscard]] std::string disagreement(const random_models::Project& project) const;
    void judge(std::vector<std::uint64_t> seeds, std::vector<std::unique_ptr<Candidate>> candidates);
    void count(std::uint64_t seed, const Candidate& candidate, const Result& result);

    ShapeOf shape_of_;
    bool all_choices_ = false;
    std::vector<std::unique_ptr<Candidate>> candidates_;
    std::vector<std::uint64_t> seeds_;
    Tally tally_;
};

}  // namespace robochart::conformance::test
