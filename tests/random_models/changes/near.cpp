// SPDX-License-Identifier: Apache-2.0
#include "tests/random_models/changes/near.hpp"

#include <cctype>
#include <utility>

#include "tests/random_models/changes/shrink.hpp"
#include "tests/random_models/changes/violations.hpp"

namespace robochart::random_models {

namespace {

std::string piece(const Project& project, const Cut& cut) {
    return project[cut.file].text.substr(cut.begin, cut.end - cut.begin);
}

/// Returns the cuts of whole elements, without cuts that leave a part of one.
std::vector<Cut> elements(const Project& project) {
    std::vector<Cut> result;
    for (Cut& cut : find_cuts(project)) {
        const bool whole_file = cut.begin == 0 && cut.end == project[cut.file].text.size();
        if (cut.replacement.empty() && !whole_file) result.push_back(std::move(cut));
    }
    return result;
}

Project remove_element(const Project& project, Random& random) {
    const std::vector<Cut> possible = find_cuts(project);
    return possible.empty() ? project : apply_cut(project, random.pick(possible));
}

Project duplicate_element(Project project, Random& random) {
    const std::vector<Cut> possible = elements(project);
    if (possible.empty()) return project;
    const Cut& cut = random.pick(possible);
    const std::string text = piece(project, cut);
    project[cut.file].text.insert(cut.end, "\n" + text + "\n");
    return project;
}

/// Moves or copies an element to the start of another one.
Project move_element(Project project, Random& random) {
    const std::vector<Cut> possible = elements(project);
    if (possible.empty()) return project;
    const Cut& from = random.pick(possible);
    const Cut& to = random.pick(possible);
    const std::string text = "\n" + piece(project, from) + "\n";
    const bool keeps = random.chance(50) || from.file != to.file || (to.begin >= from.begin && to.begin < from.end);
    std::string& target = project[to.file].text;
    if (!keeps && to.begin >= from.end) {
        target.insert(to.begin, text);
        target.erase(from.begin, from.end - from.begin);
        return project;
    }
    if (!keeps) target.erase(from.begin, from.end - from.begin);
    target.insert(to.begin, text);
    return project;
}

bool is_part_of_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The start and end of a word in the text.
using Word = std::pair<std::size_t, std::size_t>;

std::vector<Word> words(const std::string& text) {
    std::vector<Word> result;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && is_part_of_word(text[end])) ++end;
        if (end > at) result.emplace_back(at, end);
        at = end + 1;
    }
    return result;
}

/// Replaces a word by another word of the project. The new word may mean something else at this place, or nothing.
Project replace_word(Project project, Random& random) {
    std::string& text = project[random.below(project.size())].text;
    const std::string& source = project[random.below(project.size())].text;
    const std::vector<Word> here = words(text);
    const std::vector<Word> there = words(source);
    if (here.empty() || there.empty()) return project;
    const Word to = random.pick(there);
    const std::string word = source.substr(to.first, to.second - to.first);
    const Word from = random.pick(here);
    text.replace(from.first, from.second - from.first, word);
    return project;
}

Project change_project(const Project& project, Random& random) {
    switch (random.below(6)) {
        case 0:
        case 1:
            return remove_element(project, random);
        case 2:
            return duplicate_element(project, random);
        case 3:
            return move_element(project, random);
        case 4:
            return replace_word(project, random);
        default:
            return violate(project, random.pick(violations()), random).value_or(project);
    }
}

}  // namespace

Project mutate_project(const Project& project, Random& random) {
    Project result = project;
    for (std::size_t i = random.between(1, 3); i > 0 && !result.empty(); --i) result = change_project(result, random);
    return result;
}

}  // namespace robochart::random_models
