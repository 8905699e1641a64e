// SPDX-License-Identifier: Apache-2.0
// Functions that the pictures and plots of a simulation share: colours for the light and dark theme, ticks, legends.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "simulation/trial/controller.hpp"

namespace robochart::simulation {

/// The style rules of all pictures, for the light and dark theme (prefers-color-scheme). Their classes begin with
/// "sim-".
[[nodiscard]] std::string picture_style();

/// Colours that colour-blind readers can distinguish (Okabe and Ito, Color universal design, 2008), repeated
/// cyclically.
[[nodiscard]] const char* series_colour(std::size_t number);
/// The colour of a state; grey between states.
[[nodiscard]] const char* state_colour(std::size_t state, std::size_t states);

/// Round numbers (with a distance of 1, 2 or 5 times a power of ten) from `low` to `high`: at most `most`, and at least
/// two if possible.
[[nodiscard]] std::vector<double> axis_ticks(double low, double high, std::size_t most);

/// "12", "0.5"; never "-0".
[[nodiscard]] std::string number_text(double value);

/// An entry: a drawing centred at the origin, 12 units wide, and a name.
struct LegendEntry {
    std::string sign;
    std::string text;
};

/// Legend entries in rows.
class Legend {
public:
    /// Makes a legend that is at most `width` wide, in the units of the picture. `unit` is the size of a dot.
    Legend(std::vector<LegendEntry> entries, double width, double unit);
    [[nodiscard]] double height() const { return height_; }
    /// The legend with its upper left corner at this point.
    [[nodiscard]] std::string svg(double left, double top) const;

private:
    double unit_;
    double height_ = 0;
    std::string text_;
};

/// The symbols of robots in each state: a disk in the state's colour with a mark that points forward. The id is
/// `prefix` followed by the number of the state. `outline` is the width of the outline in radii.
[[nodiscard]] std::string robot_symbols(std::size_t states, double radius, double outline, const std::string& prefix);
/// One entry per state, and one for the time between states, drawn with the symbols.
[[nodiscard]] std::vector<LegendEntry> state_entries(const MachineStates&, double radius, const std::string& prefix);

}  // namespace robochart::simulation
