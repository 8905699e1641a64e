// SPDX-License-Identifier: Apache-2.0
// Draws models for tests of diagrams. Each file is loaded alone, so many of its names are unresolved, which diagrams
// must handle.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "frontend/diagrams/notation/subjects.hpp"
#include "tests/random_models/models/project.hpp"

namespace robochart::diagrams {

/// A diagram and the objects that it refers to.
struct DrawnModel {
    const random_models::Loaded& model;
    const Elements& elements;
    const Subject& subject;
    const Picture& picture;
};

/// Draws all components of a project.
void draw_each(const random_models::Project& project, const std::function<void(const DrawnModel&)>& look);
/// Draws every model file below a folder, each alone. Returns their number.
std::size_t draw_below(const std::filesystem::path& folder, const std::function<void(const DrawnModel&)>& look);
/// Draws the corpus, the models of the tests, and the models shown in the documentation. Returns their number.
std::size_t draw_own_models(const std::function<void(const DrawnModel&)>& look);

}  // namespace robochart::diagrams
