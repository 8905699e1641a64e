// Names for random models (private to the room): unique in a project, pronounceable, sometimes reserved words.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "random_models/random.hpp"

namespace robochart::random_models {

/// Hands out names; none twice.
class Names {
public:
    Names(Random& random, bool escaped) : random_(random), escaped_(escaped) {}

    /// A name that begins with `stem`, such as `speed3`; or, rarely, an escaped reserved word.
    std::string fresh(std::string_view stem);

private:
    Random& random_;
    bool escaped_;
    std::size_t used_words_ = 0;
    std::map<std::string, std::size_t, std::less<>> used_;
};

}  // namespace robochart::random_models
