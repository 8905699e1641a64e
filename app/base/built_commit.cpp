// SPDX-License-Identifier: Apache-2.0
#include "app/base/built_commit.hpp"

#include <nlohmann/json.hpp>

namespace robochart::app {

std::string commit_text(const Commit& commit) {
    constexpr std::size_t enough_digits = 12;
    if (commit.id.empty()) return "unknown commit";
    return "commit " + commit.id.substr(0, enough_digits) + (commit.modified ? " with local changes" : "");
}

diagnostics::Json program_json(const std::string& version, const Commit& commit) {
    diagnostics::Json json{
        {"name", "robochart-verify"}, {"version", version}, {"commit", nullptr}, {"modified", nullptr}};
    if (commit.id.empty()) return json;
    json["commit"] = commit.id;
    json["modified"] = commit.modified;
    return json;
}

}  // namespace robochart::app
