// SPDX-License-Identifier: Apache-2.0
// Makes names for random models (private to the component). They are unique in a project, pronounceable, and sometimes
// reserved words.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "tests/random_models/models/random.hpp"
#include "tests/random_models/models/shape.hpp"

namespace robochart::random_models {

/// Generates names. All are different, except that components may repeat local names if the shape allows it.
class Names {
public:
    Names(Random& random, const Shape& shape) : random_(random), shape_(shape) {}

    /// Returns a name that starts with `stem`, such as `speed3`, or rarely an escaped reserved word.
    std::string unused_name(std::string_view stem);
    /// Returns a name that is local to the current component. Other components may use the same name if the shape
    /// repeats names.
    std::string local_name(std::string_view stem);
    /// Returns a name for the package of a file, with qualifiers if names are hostile.
    std::string package_for_file(std::size_t file);
    /// Starts another component, in which names that are local to other components may be reused.
    void begin_component() { used_here_.clear(); }

private:
    using Counts = std::map<std::string, std::size_t, std::less<>>;
    static std::string next(Counts& counts, std::string_view stem);

    Random& random_;
    const Shape& shape_;
    /// Returns an unused word of another language, or "" if there is none left.
    std::string hostile_name();

    std::size_t used_words_ = 0;
    Counts used_, used_here_;
    std::set<std::string, std::less<>> used_hostile_;
};

}  // namespace robochart::random_models
