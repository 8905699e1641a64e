// SPDX-License-Identifier: Apache-2.0
// Defines the context for deciding a claim: the settings, the services of the run, and the claim's turn.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "checker/refine/search/limits.hpp"
#include "driver/settings/services.hpp"
#include "driver/settings/settings.hpp"

namespace robochart::driver {

/// The turn of a claim (turns.hpp).
struct Turn {
    std::optional<std::chrono::steady_clock::time_point> ends = {};  ///< no value if the turn ends with the run
    /// Also receives the progress of searches during the turn; may be empty.
    std::function<void(const refine::Progress&)> on_progress = {};

    [[nodiscard]] bool is_over() const { return ends && std::chrono::steady_clock::now() >= *ends; }
};

/// The context stores references to the settings and the services.
struct SearchContext {
    const Settings& settings;
    Services& services;
    Turn turn = {};
};

/// Combines the limits of the run, of the turn and of one check. Progress is reported under the name `subject`.
[[nodiscard]] refine::Limits limits_of_check(const SearchContext&, const std::string& subject = "");

}  // namespace robochart::driver
