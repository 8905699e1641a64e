// See models.hpp.
#include "tests/diagrams/models.hpp"

#include <algorithm>
#include <vector>

#include "tests/contents.hpp"
#include "tests/source_folder.hpp"

namespace robochart::diagrams {

namespace fs = std::filesystem;

void draw_each(const random_models::Project& project, const std::function<void(const DrawnModel&)>& look) {
    const auto loaded = random_models::load(project);
    const Elements elements(loaded->model);
    for (const Subject& subject : subjects(loaded->model, loaded->sources))
        look({*loaded, elements, subject, draw(subject, {elements, nullptr, nullptr})});
}

std::size_t draw_below(const fs::path& folder, const std::function<void(const DrawnModel&)>& look) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".rct") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) draw_each({{file.string(), tests::contents(file)}}, look);
    return files.size();
}

std::size_t draw_own_models(const std::function<void(const DrawnModel&)>& look) {
    return draw_below(tests::source_folder() / "corpus", look) + draw_below(tests::source_folder() / "tests", look);
}

}  // namespace robochart::diagrams
