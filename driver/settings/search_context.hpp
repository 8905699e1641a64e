// SPDX-License-Identifier: Apache-2.0
// What the decision of a claim needs besides the claim: the settings, the services of the run, and the claim's turn.
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
    std::optional<std::chrono::steady_clock::time_point> ends = {};  ///< no value: with the run
    std::function<void(const refine::Progress&)> on_progress = {};   ///< receives the progress, too; may be empty

    [[nodiscard]] bool is_over() const { return ends && std::chrono::steady_clock::now() >= *ends; }
};

/// Refers to the settings and the services.
struct SearchContext {
    const Settings& settings;
    Services& services;
    Turn turn = {};
};

/// The limits of one check: those of the run, of the turn, and its own. Progress is reported under the name `subject`.
[[nodiscard]] refine::Limits limits_of_check(const SearchContext&, const std::string& subject = "");

}  // namespace robochart::driver
