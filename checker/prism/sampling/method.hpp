// How many paths are sampled, and what is concluded from them: PRISM's four methods, with its parameters.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "diagnostics/budget.hpp"

namespace robochart::prism {

/// No method, or one with other parameters.
class BadMethod : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Of `width`, `confidence` and `samples` two are given and the third follows; what is missing of two has its default.
struct Method {
    enum class Kind : std::uint8_t {
        ci,    ///< confidence interval: mean +- `width`, by Student's distribution
        aci,   ///< asymptotic confidence interval: by the normal distribution
        apmc,  ///< approximate probabilistic model checking: by Hoeffding's bound
        sprt   ///< sequential probability ratio test: decides a bound on a probability
    };
    Kind kind = Kind::ci;
    std::optional<std::uint64_t> samples;  ///< 1,000 unless the others are given; sprt takes what it needs
    std::optional<double>
        width;  ///< half of the interval; epsilon of apmc; of sprt the indifference, 0.05 unless given
    std::optional<double> confidence;  ///< the probability that it is wrong: alpha, delta of apmc; 0.01 unless given
    std::uint64_t path = 10'000;       ///< steps of a path at most
};

/// Reads "ci", "apmc,width=0.01,confidence=0.05", "sprt,width=0.01", "aci,samples=5000,path=100000". Throws BadMethod.
[[nodiscard]] Method read_method(const std::string& text);
/// "ci".
[[nodiscard]] const char* method_name(Method::Kind kind);

struct SamplingOptions {
    Method method;
    std::uint64_t seed = 0;
    unsigned threads = 0;  ///< 0: one a core. The samples are the same for any number
    diagnostics::Budget* budget = nullptr;
};

}  // namespace robochart::prism
