// See names.hpp.
#include "random_models/names.hpp"

#include <algorithm>

#include "frontend/lexer.hpp"

namespace robochart::random_models {

std::string Names::next(Counts& counts, std::string_view stem) {
    const auto found = counts.try_emplace(std::string(stem), 0).first;
    return std::string(stem) + std::to_string(found->second++);
}

std::string Names::fresh(std::string_view stem) {
    const std::vector<std::string_view>& reserved = frontend::reserved_words();
    if (shape_.escaped_names && used_words_ < reserved.size() && random_.chance(2)) {
        const std::string_view word = reserved[used_words_++];
        if (word.front() != '_') return "^" + std::string(word);
    }
    return next(used_, stem);
}

std::string Names::local(std::string_view stem) {
    return shape_.repeated_names ? next(used_here_, stem) : fresh(stem);
}

}  // namespace robochart::random_models
