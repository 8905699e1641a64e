// SPDX-License-Identifier: Apache-2.0
#include "tests/random_models/models/names.hpp"

#include "frontend/syntax/lexer.hpp"
#include "tests/random_models/models/hostile.hpp"

namespace robochart::random_models {

std::string Names::next(Counts& counts, std::string_view stem) {
    const auto found = counts.try_emplace(std::string(stem), 0).first;
    return std::string(stem) + std::to_string(found->second++);
}

std::string Names::unused_name(std::string_view stem) {
    if (shape_.hostile && random_.chance(50))
        if (std::string word = hostile_name(); !word.empty()) return word;
    const std::vector<std::string_view>& reserved = frontend::reserved_words();
    if (shape_.escaped_names && used_words_ < reserved.size() && random_.chance(2)) {
        const std::string_view word = reserved[used_words_++];
        if (word.front() != '_') return "^" + std::string(word);
    }
    return next(used_, stem);
}

std::string Names::hostile_name() {
    constexpr int attempts = 4;
    for (int i = 0; i < attempts; ++i) {
        const std::string word(random_.pick(hostile_names()));
        if (used_hostile_.insert(word).second) return word;
    }
    return {};
}

std::string Names::package_for_file(std::size_t file) {
    std::string plain = "Part" + std::to_string(file);
    if (!shape_.hostile) return plain;
    const std::string word = hostile_name();
    if (word.empty()) return plain;
    return random_.chance(30) ? plain + "::" + word : word;
}

std::string Names::local_name(std::string_view stem) {
    return shape_.repeated_names ? next(used_here_, stem) : unused_name(stem);
}

}  // namespace robochart::random_models
