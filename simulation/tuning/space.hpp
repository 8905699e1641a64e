// SPDX-License-Identifier: Apache-2.0
// Declares the search space of tuning: constants of a model, each with its possible values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/world/random.hpp"

namespace robochart::simulation {

/// A constant and the values to try: a range in steps of a power of ten, or a list.
struct Parameter {
    std::string name;                 ///< "farRadius", "Keep::patience"
    std::string text;                 ///< as written: "0.05..0.5"
    std::vector<std::string> listed;  ///< the values of a list, unordered; empty for a range
    std::int64_t low = 0;             ///< the lower bound of the range, in steps
    std::uint64_t count = 0;          ///< number of values of the range, at most 1,000,000
    int decimals = 0;                 ///< a step is 10^-decimals

    [[nodiscard]] bool is_ordered() const { return listed.empty(); }
    [[nodiscard]] std::uint64_t size() const { return is_ordered() ? count : listed.size(); }
    /// Returns the text of the value with this index, such as "0.187".
    [[nodiscard]] std::string value_text(std::uint64_t number) const;
};

/// The type of a constant.
enum class ParameterKind { whole, real, other };

/// True if `VALUE` of `NAME=VALUE` contains several values: `LOW..HIGH`, or a list separated by commas.
[[nodiscard]] bool is_varied(std::string_view value);

/// Parses `LOW..HIGH` or `A,B,C`. A range of whole numbers contains all of them. A range of reals has as many decimals
/// as its bounds, or more if a hundred steps need more. If the text is wrong, returns no value, and `error` contains
/// the reason.
[[nodiscard]] std::optional<Parameter> read_parameter(const std::string& name, const std::string& text, ParameterKind,
                                                      std::string& error);

/// A candidate: for each parameter, the index of a value.
using Candidate = std::vector<std::uint64_t>;

/// Returns one text per parameter, such as "farRadius=0.187", as for `--const`.
[[nodiscard]] std::vector<std::string> constants_of(const std::vector<Parameter>&, const Candidate&);
/// Returns all values of a candidate in one text.
[[nodiscard]] std::string candidate_text(const std::vector<Parameter>&, const Candidate&);

/// The distribution for drawing near a good candidate (López-Ibáñez, Dubois-Lacoste, Pérez Cáceres, Birattari, Stützle,
/// "The irace package: iterated racing for automatic algorithm configuration", Operations Research Perspectives 3,
/// 2016, section 3.2). For ordered parameters it is a normal distribution around the candidate's value, truncated at
/// the ends of the range. For lists it is a discrete distribution.
struct Neighbourhood {
    std::vector<double> deviations;                  ///< standard deviations of the ordered parameters, in steps
    std::vector<std::vector<double>> probabilities;  ///< the probabilities of the values of each list
};
/// Returns the initial neighbourhood: deviations of half a range, and equal probabilities.
[[nodiscard]] Neighbourhood whole_space(const std::vector<Parameter>&);
/// Narrows the neighbourhood after an iteration with `fresh` new candidates. Deviations shrink by (1 / fresh)^(1 /
/// parameters). Probabilities move towards the candidate's values in proportion to `progress` (0 at the beginning, 1 at
/// the end).
void narrow_neighbourhood(Neighbourhood&, const std::vector<Parameter>&, const Candidate&, std::uint64_t fresh,
                          double progress);
/// Doubles the deviations, up to the initial ones, and moves probabilities half-way towards equal ones.
void widen_neighbourhood(Neighbourhood&, const std::vector<Parameter>&);

/// Draws a candidate from the whole space, or near another candidate.
[[nodiscard]] Candidate draw_candidate(const std::vector<Parameter>&, Random&);
[[nodiscard]] Candidate drawn_near(const std::vector<Parameter>&, const Candidate&, const Neighbourhood&, Random&);

}  // namespace robochart::simulation
