// SPDX-License-Identifier: Apache-2.0
// Provides the built-in files of a new project (app/templates), for the verb `init`.
#pragma once

#include <string>
#include <string_view>

namespace robochart::app {

/// Returns the text of app/templates/`path`. In this text, `@NAME@` is the placeholder for the project's name.
[[nodiscard]] std::string template_text(std::string_view path);

}  // namespace robochart::app
