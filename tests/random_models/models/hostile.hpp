// Names and strings that mean something elsewhere (private to the component): in CSPM, in C++ and its headers, in what
// is generated, in CMake, shells and XML.
#pragma once

#include <string_view>
#include <vector>

namespace robochart::random_models {

/// Names without those of the core types and without reserved words of RoboChart, which are written with a `^`.
[[nodiscard]] const std::vector<std::string_view>& hostile_names();
/// String literals as they are written in RoboChart.
[[nodiscard]] const std::vector<std::string_view>& hostile_strings();

}  // namespace robochart::random_models
