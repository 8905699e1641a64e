// SPDX-License-Identifier: Apache-2.0
// Reads the files of editors/vscode as data for tests.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/contents.hpp"

namespace robochart::editors {

/// Returns the folder of the extension.
[[nodiscard]] std::filesystem::path extension_folder();
using tests::read_contents;
/// Reads a JSON file of the extension.
[[nodiscard]] nlohmann::json load_json(const std::string& name);

/// Returns the words in those patterns of a grammar whose scopes satisfy the predicate, without lookarounds.
[[nodiscard]] std::set<std::string> grammar_words(const nlohmann::json& grammar,
                                                  const std::function<bool(const std::string&)>& scope);

}  // namespace robochart::editors
