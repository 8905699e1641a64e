// SPDX-License-Identifier: Apache-2.0
#include "tests/frontend/diagrams/models.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "tests/contents.hpp"
#include "tests/source_folder.hpp"

namespace robochart::diagrams {

namespace fs = std::filesystem;

void draw_each(const random_models::Project& project, const std::function<void(const DrawnModel&)>& look) {
    const auto loaded = random_models::load(project);
    const Elements elements(loaded->model);
    for (const Subject& subject : find_subjects(loaded->model, loaded->sources))
        look({*loaded, elements, subject, draw_subject(subject, {elements, nullptr, nullptr})});
}

std::size_t draw_below(const fs::path& folder, const std::function<void(const DrawnModel&)>& look) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (frontend::is_model_path(entry.path().string())) files.push_back(entry.path());
    std::ranges::sort(files);
    for (const fs::path& file : files) draw_each({{file.string(), tests::read_contents(file)}}, look);
    return files.size();
}

namespace {

/// Returns the models shown in a page, which are its `robochart` blocks.
std::vector<std::string> models_in(const std::string& page) {
    std::vector<std::string> models;
    std::istringstream lines(page);
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            inside = !inside && line.starts_with("```robochart");
            if (inside) models.emplace_back();
        } else if (inside) {
            models.back() += line + "\n";
        }
    }
    return models;
}

std::size_t draw_documents(const std::function<void(const DrawnModel&)>& look) {
    std::vector<fs::path> pages;
    for (const auto& entry : fs::recursive_directory_iterator(tests::source_folder() / "docs"))
        if (entry.path().extension() == ".md") pages.push_back(entry.path());
    std::ranges::sort(pages);
    std::size_t count = 0;
    for (const fs::path& page : pages)
        for (const std::string& model : models_in(tests::read_contents(page))) {
            draw_each({{page.string() + ".rct", model}}, look);
            ++count;
        }
    return count;
}

}  // namespace

std::size_t draw_own_models(const std::function<void(const DrawnModel&)>& look) {
    return draw_below(tests::source_folder() / "corpus", look) + draw_below(tests::source_folder() / "tests", look) +
           draw_documents(look);
}

}  // namespace robochart::diagrams
