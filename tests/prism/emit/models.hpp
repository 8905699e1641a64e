// SPDX-License-Identifier: Apache-2.0
// Loads RoboChart models and encodes them.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "prism/emit/emit.hpp"

namespace robochart::prism_emit::testing {

/// A model and the result of its encoding.
struct Encoded {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    std::optional<Emission> emission;

    /// Returns the distinct codes of the errors: "RC-E02 RC-E05".
    [[nodiscard]] std::string codes() const;
    [[nodiscard]] std::string report() const;
    /// Returns the lines of the model's declarations and commands, with every `prefix` removed.
    [[nodiscard]] std::set<std::string> lines(const std::string& prefix) const;
};

/// Returns ranges as in RoboTool's preferences: nat 0..2, int 0..2, real 0..2.
[[nodiscard]] Preferences small_ranges();

/// Encodes the only module of a text, or of the files of a folder by name.
[[nodiscard]] std::unique_ptr<Encoded> encode_model(const std::string& text,
                                                    const Preferences& ranges = small_ranges());
[[nodiscard]] std::unique_ptr<Encoded> encode_model(const std::map<std::string, std::string>& files,
                                                    const Preferences& ranges);

/// The number of states and transitions of the model, with values for its constants.
struct Size {
    std::size_t states = 0, transitions = 0;
    friend bool operator==(const Size&, const Size&) = default;
};
[[nodiscard]] Size size_of(const Encoded&, const std::map<std::string, std::string>& constants = {});
/// Returns the value of a property.
[[nodiscard]] double value_of(const Encoded&, const std::map<std::string, std::string>& constants,
                              const std::string& property);

}  // namespace robochart::prism_emit::testing
