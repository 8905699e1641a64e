// What the pictures and plots of a simulation share: colours for light and dark, ticks, legends.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "simulation/trial/controller.hpp"

namespace robochart::simulation {

/// The rules of style of all pictures, in the light and in the dark (prefers-color-scheme). Their classes begin with
/// "sim-".
[[nodiscard]] std::string picture_style();

/// Colours that colour-blind readers can tell apart (Okabe and Ito, Color universal design, 2008), again and again.
[[nodiscard]] const char* colour(std::size_t number);
/// Of a state; grey in between.
[[nodiscard]] const char* state_colour(std::size_t state, std::size_t states);

/// Round numbers (1, 2 or 5 times a power of ten apart) from `low` to `high`: at most `most`, at least the two that
/// fit if any do.
[[nodiscard]] std::vector<double> ticks(double low, double high, std::size_t most);

/// "12", "0.5"; never "-0".
[[nodiscard]] std::string number_text(double value);

/// An entry: a drawing around the origin, 12 units wide, and a name.
struct LegendEntry {
    std::string sign;
    std::string text;
};

/// Entries in rows.
class Legend {
public:
    /// At most as wide as this, in the units of the picture; `unit`: of a dot.
    Legend(std::vector<LegendEntry> entries, double width, double unit);
    [[nodiscard]] double height() const { return height_; }
    /// With its upper left corner here.
    [[nodiscard]] std::string svg(double left, double top) const;

private:
    double unit_;
    double height_ = 0;
    std::string text_;
};

/// The symbols of robots in each state, to be used by the id `PREFIX` and the state's number: a disk with the state's
/// colour and with a mark that points forward. `outline`: its width in radii.
[[nodiscard]] std::string robot_symbols(std::size_t states, double radius, double outline, const std::string& prefix);
/// An entry for each state, and one for in between, drawn with the symbols.
[[nodiscard]] std::vector<LegendEntry> state_entries(const MachineStates&, double radius, const std::string& prefix);

}  // namespace robochart::simulation
