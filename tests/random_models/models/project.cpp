// SPDX-License-Identifier: Apache-2.0
#include "tests/random_models/models/project.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "base/diagnostics/render.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/toolkits/toolkits.hpp"

namespace robochart::random_models {

bool Text::is_assertions() const {
    return path.ends_with(".assertions");
}

std::size_t lines(const Project& project) {
    std::size_t sum = 0;
    for (const Text& file : project) {
        std::istringstream text(file.text);
        for (std::string line; std::getline(text, line);)
            if (line.find_first_not_of(' ') != std::string::npos) ++sum;
    }
    return sum;
}

std::string listing(const Project& project) {
    std::string out;
    for (const Text& file : project) out += "---- " + file.path + "\n" + file.text;
    return out;
}

std::string write(const Project& project, const std::string& folder) {
    namespace fs = std::filesystem;
    for (const Text& file : project) {
        const fs::path path = fs::path(folder) / file.path;
        std::error_code failure;
        fs::create_directories(path.parent_path(), failure);
        if (failure) return path.parent_path().string() + ": " + failure.message();
        std::ofstream out(path, std::ios::binary);
        out << file.text;
        if (!out.flush()) return "cannot write " + path.string();
    }
    return {};
}

std::string Loaded::error_codes() const {
    std::set<std::string> codes;
    for (const diagnostics::Diagnostic& finding : findings.sorted_findings())
        if (finding.rule->severity == diagnostics::Severity::error) codes.emplace(finding.rule->code);
    std::string out;
    for (const std::string& code : codes) out += (out.empty() ? "" : " ") + code;
    return out;
}

std::string Loaded::report() const {
    return diagnostics::render_text(sources, findings);
}

std::unique_ptr<Loaded> parse(const Project& project) {
    auto loaded = std::make_unique<Loaded>();
    for (const Text& file : project) {
        const auto id = loaded->sources.add(file.path, file.text);
        loaded->model.files.push_back(frontend::parse(loaded->sources, id, file.is_assertions(), loaded->findings));
    }
    return loaded;
}

std::unique_ptr<Loaded> load(const Project& project) {
    std::unique_ptr<Loaded> loaded = parse(project);
    frontend::add_toolkits(loaded->sources, loaded->model, loaded->findings);
    frontend::resolve(loaded->model, loaded->findings);
    return loaded;
}

}  // namespace robochart::random_models
