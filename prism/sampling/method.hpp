// SPDX-License-Identifier: Apache-2.0
// Declares PRISM's four methods of statistical model checking, with their parameters, and reads them from a text.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "base/diagnostics/budget.hpp"

namespace robochart::prism {

/// Thrown for an unknown method or wrong parameters.
class BadMethod : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A method with its parameters. Two of `width`, `confidence` and `samples` determine the third. If fewer than two are
/// given, a default is used.
struct Method {
    enum class Kind : std::uint8_t {
        ci,    ///< confidence interval: mean +- `width`, by Student's distribution
        aci,   ///< asymptotic confidence interval: by the normal distribution
        apmc,  ///< approximate probabilistic model checking: by Hoeffding's bound
        sprt   ///< sequential probability ratio test: decides a bound on a probability
    };
    Kind kind = Kind::ci;
    std::optional<std::uint64_t> samples;  ///< 1,000 unless both others are given; sprt takes as many as it needs
    std::optional<double>
        width;  ///< half of the interval; epsilon for apmc; for sprt the indifference, 0.05 by default
    std::optional<double> confidence;  ///< the probability of an error: alpha, or delta for apmc; 0.01 by default
    std::uint64_t path = 10'000;       ///< maximal number of steps of a path
};

/// Reads a method such as "ci", "apmc,width=0.01,confidence=0.05", "sprt,width=0.01" or "aci,samples=5000,path=100000".
/// Throws BadMethod.
[[nodiscard]] Method read_method(const std::string& text);
/// Returns the name of a method, such as "ci".
[[nodiscard]] const char* method_name(Method::Kind kind);

struct SamplingOptions {
    Method method;
    std::uint64_t seed = 0;
    unsigned threads = 0;  ///< 0: one for each core. The samples do not depend on it
    diagnostics::Budget* budget = nullptr;
};

}  // namespace robochart::prism
