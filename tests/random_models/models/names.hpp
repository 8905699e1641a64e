// Names for random models (private to the component): unique in a project, pronounceable, sometimes reserved words.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "tests/random_models/models/random.hpp"
#include "tests/random_models/models/shape.hpp"

namespace robochart::random_models {

/// Hands out names; none twice, but those that are local to a component where components may repeat them.
class Names {
public:
    Names(Random& random, const Shape& shape) : random_(random), shape_(shape) {}

    /// A name that begins with `stem`, such as `speed3`; or, rarely, an escaped reserved word.
    std::string fresh(std::string_view stem);
    /// A name that only the component at hand uses. Others may have the same where the shape repeats names.
    std::string local(std::string_view stem);
    /// A name for the package of a file, with qualifiers where names are hostile.
    std::string package(std::size_t file);
    /// Another component begins: names that are local to others may come again.
    void begin_component() { used_here_.clear(); }

private:
    using Counts = std::map<std::string, std::size_t, std::less<>>;
    static std::string next(Counts& counts, std::string_view stem);

    Random& random_;
    const Shape& shape_;
    /// A word of another language that is not used yet; "" if there is none.
    std::string hostile();

    std::size_t used_words_ = 0;
    Counts used_, used_here_;
    std::set<std::string, std::less<>> used_hostile_;
};

}  // namespace robochart::random_models
