// SPDX-License-Identifier: Apache-2.0
// The built-in files of a new project (app/templates), for the verb `init`.
#pragma once

#include <string>
#include <string_view>

namespace robochart::app {

/// The text of app/templates/`path`; in it, `@NAME@` is the placeholder for the project's name.
[[nodiscard]] std::string template_text(std::string_view path);

}  // namespace robochart::app
