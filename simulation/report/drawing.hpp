// SPDX-License-Identifier: Apache-2.0
// Draws what the pictures and plots of a simulation share: colours for the light and dark theme, ticks, legends.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "simulation/trial/controller.hpp"

namespace robochart::simulation {

/// Returns the style rules of all pictures, for the light and dark theme (prefers-color-scheme). Their classes begin
/// with "sim-".
[[nodiscard]] std::string picture_style();

/// Returns one of the colours that colour-blind readers can distinguish (Okabe and Ito, Color universal design, 2008).
/// The colours repeat.
[[nodiscard]] const char* series_colour(std::size_t number);
/// Returns the colour of a state; grey if the machine is between states.
[[nodiscard]] const char* state_colour(std::size_t state, std::size_t states);

/// Returns round numbers from `low` to `high`, with a distance of 1, 2 or 5 times a power of ten. There are at most
/// `most` of them, and at least two if possible.
[[nodiscard]] std::vector<double> axis_ticks(double low, double high, std::size_t most);

/// Returns a text such as "12" or "0.5"; never "-0".
[[nodiscard]] std::string number_text(double value);

/// A legend entry: a name, and a drawing that is centred at the origin and 12 units wide.
struct LegendEntry {
    std::string sign;
    std::string text;
};

/// A legend, whose entries are arranged in rows.
class Legend {
public:
    /// Makes a legend that is at most `width` wide, in the units of the picture. `unit` is the size of a dot.
    Legend(std::vector<LegendEntry> entries, double width, double unit);
    [[nodiscard]] double height() const { return height_; }
    /// Draws the legend with its upper left corner at this point.
    [[nodiscard]] std::string svg(double left, double top) const;

private:
    double unit_;
    double height_ = 0;
    std::string text_;
};

/// Draws the symbols of robots, one for each state: a disk in the state's colour with a mark that points forward. The
/// id of a symbol is `prefix` followed by the number of the state. `outline` is the width of the outline in radii.
[[nodiscard]] std::string robot_symbols(std::size_t states, double radius, double outline, const std::string& prefix);
/// Returns one entry per state, and one for the time between states. The entries use the symbols.
[[nodiscard]] std::vector<LegendEntry> state_entries(const MachineStates&, double radius, const std::string& prefix);

}  // namespace robochart::simulation
