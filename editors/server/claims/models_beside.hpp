// SPDX-License-Identifier: Apache-2.0
// Reads the models on disk in the folder of a text, or in the folder above. Claims and rules refer to names of these
// models.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/checks/components.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::lsp {

/// The models of a folder, as far as claims and rules need them.
struct ClaimedModels {
    std::string signature;  ///< the paths, sizes and times of the files
    diagnostics::SourceManager sources;
    ir::System system;
    std::vector<std::string> packages;
    std::vector<claims::Component> components;
    bool good = false;  ///< true if the models have no errors
};

/// A place in a text at which the last part of a name is written: `in Operating::` has the qualifier "Operating::" and
/// the word "in".
struct NamePlace {
    std::string qualifier;  ///< "" or ends with "::"
    std::string word;       ///< the word before the name
};
[[nodiscard]] NamePlace name_place(std::string_view text_before);

/// Returns the states of the machines, as they are written after the qualifier, sorted.
[[nodiscard]] std::vector<std::string> states_after(const std::string& qualifier, const ClaimedModels&);

/// Reads the models of a folder again if a file has changed.
class ModelsBeside {
public:
    /// Returns the models for the text with this path. Returns null if there are no models, or if they have errors.
    [[nodiscard]] const ClaimedModels* find(const std::string& path, diagnostics::Budget* budget);

private:
    std::map<std::string, std::unique_ptr<ClaimedModels>> models_;  ///< key: the folder
};

/// Returns the files in a folder whose names have this ending.
[[nodiscard]] std::vector<std::string> files_in(const std::string& folder, std::string_view ending);

}  // namespace robochart::lsp
