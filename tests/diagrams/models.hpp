// Models to be drawn, each file read alone: many of their names mean nothing then, which diagrams have to stand.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "diagrams/notation/subjects.hpp"
#include "tests/random_models/models/project.hpp"

namespace robochart::diagrams {

/// A diagram with everything it was made of.
struct DrawnModel {
    const random_models::Loaded& model;
    const Elements& elements;
    const Subject& subject;
    const Picture& picture;
};

/// Draws everything of a project.
void draw_each(const random_models::Project& project, const std::function<void(const DrawnModel&)>& look);
/// The same for every model file below a folder, alone; returns how many there were.
std::size_t draw_below(const std::filesystem::path& folder, const std::function<void(const DrawnModel&)>& look);
/// The same for the corpus, the models of the tests, and those shown in the documentation.
std::size_t draw_own_models(const std::function<void(const DrawnModel&)>& look);

}  // namespace robochart::diagrams
