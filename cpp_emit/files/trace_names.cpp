// SPDX-License-Identifier: Apache-2.0
// Gives each input and output its short name (`e` for `e.in`), unless two of them would share the name.
#include "cpp_emit/files/trace_names.hpp"

#include <algorithm>
#include <string_view>

namespace robochart::cpp_emit {

namespace {

std::string short_name(std::string_view name) {
    for (const std::string_view ending : {".in", ".out", "Call"})
        if (name.size() > ending.size() && name.ends_with(ending))
            return std::string(name.substr(0, name.size() - ending.size()));
    for (const std::string_view prefix : {"set_EXT_", "set_"})
        if (name.size() > prefix.size() && name.starts_with(prefix)) return std::string(name.substr(prefix.size()));
    return std::string(name);
}

}  // namespace

std::vector<std::string> trace_names(const std::vector<std::string>& interface_names) {
    std::vector<std::string> all;
    for (const std::string& name : interface_names) all.push_back(short_name(name));
    std::vector<std::string> result;
    for (std::size_t i = 0; i < all.size(); ++i)
        result.push_back(std::ranges::count(all, all[i]) == 1 ? all[i] : interface_names[i]);
    return result;
}

}  // namespace robochart::cpp_emit
