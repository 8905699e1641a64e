// What tuning chooses from: constants of a model, each with the values that it may take.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/world/random.hpp"

namespace robochart::simulation {

/// A constant and the values to try: those of a range in steps of a power of ten, or those of a list.
struct Parameter {
    std::string name;                 ///< "farRadius", "Keep::patience"
    std::string text;                 ///< as it was asked for: "0.05..0.5"
    std::vector<std::string> listed;  ///< not empty: these, without an order
    std::int64_t low = 0;             ///< of a range, in steps
    std::uint64_t count = 0;          ///< values of the range, at most 1,000,000
    int decimals = 0;                 ///< a step is 10^-decimals

    [[nodiscard]] bool ordered() const { return listed.empty(); }
    [[nodiscard]] std::uint64_t size() const { return ordered() ? count : listed.size(); }
    /// Of a value by its number: "0.187".
    [[nodiscard]] std::string value(std::uint64_t number) const;
};

/// What kind of values a constant has.
enum class ParameterKind { whole, real, other };

/// Whether `VALUE` of `NAME=VALUE` asks for more than one value: `LOW..HIGH`, or a list with commas.
[[nodiscard]] bool is_varied(std::string_view value);

/// Reads `LOW..HIGH` or `A,B,C`. A range of whole numbers has all of them; one of reals the values with so many
/// decimals as its bounds are written with, and as many more as it takes for at least a hundred steps. Nothing where it
/// cannot be read, and `error` says why.
[[nodiscard]] std::optional<Parameter> read_parameter(const std::string& name, const std::string& text, ParameterKind,
                                                      std::string& error);

/// A value of each parameter, by its number.
using Candidate = std::vector<std::uint64_t>;

/// "farRadius=0.187", parameter by parameter: as `--const` takes them.
[[nodiscard]] std::vector<std::string> constants_of(const std::vector<Parameter>&, const Candidate&);
/// The same behind one another.
[[nodiscard]] std::string candidate_text(const std::vector<Parameter>&, const Candidate&);

/// How values near those of a good candidate are drawn (López-Ibáñez, Dubois-Lacoste, Pérez Cáceres, Birattari,
/// Stützle, "The irace package: iterated racing for automatic algorithm configuration", Operations Research
/// Perspectives 3, 2016, section 3.2): of an order from a normal distribution around the candidate's, cut off at the
/// ends of the range; of a list from probabilities of its own.
struct Neighbourhood {
    std::vector<double> deviations;                  ///< of each parameter with an order, in steps
    std::vector<std::vector<double>> probabilities;  ///< of each list, value by value
};
/// That of the beginning: half a range, and equal probabilities.
[[nodiscard]] Neighbourhood whole_space(const std::vector<Parameter>&);
/// After an iteration with so many new candidates: deviations shrink by (1 / fresh)^(1 / parameters), and probabilities
/// go to the candidate's values, by `progress` of the way (0 at the beginning, 1 at the end).
void narrow(Neighbourhood&, const std::vector<Parameter>&, const Candidate&, std::uint64_t fresh, double progress);
/// Deviations twice as large again, at most those of the beginning, and probabilities half-way to equal ones.
void widen(Neighbourhood&, const std::vector<Parameter>&);

/// Any candidate, and one near another.
[[nodiscard]] Candidate drawn(const std::vector<Parameter>&, Random&);
[[nodiscard]] Candidate drawn_near(const std::vector<Parameter>&, const Candidate&, const Neighbourhood&, Random&);

}  // namespace robochart::simulation
