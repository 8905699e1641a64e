// SPDX-License-Identifier: Apache-2.0
#include "counterexample/copies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace robochart::runs {

std::optional<std::uint32_t> Copies::of_event(const std::string& name) const {
    if (!meaning_) return std::nullopt;
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos || !meaning_->channels.contains(name.substr(0, dot))) return std::nullopt;
    std::uint32_t copy = 0;
    const char* const end = name.data() + name.size();
    const auto [rest, code] = std::from_chars(name.data() + dot + 1, end, copy);
    const bool whole = code == std::errc() && (rest == end || *rest == '.');
    return whole && copy < meaning_->count ? std::optional(copy) : std::nullopt;
}

std::optional<std::string> Copies::words_for(const std::string& name) const {
    if (!of_event(name)) return std::nullopt;
    return meaning_->channels.at(name.substr(0, name.find('.')));
}

void Copies::number_leaves(const std::vector<bool>& of_model) {
    leaves_.clear();
    const auto all = static_cast<std::size_t>(std::ranges::count(of_model, true));
    if (!meaning_ || all == 0 || all % meaning_->count != 0) return;
    const std::size_t leaves_per_copy = all / meaning_->count;
    std::size_t before = 0;
    for (const bool one : of_model) {
        leaves_.push_back(one ? std::optional(static_cast<std::uint32_t>(before / leaves_per_copy)) : std::nullopt);
        before += one ? 1 : 0;
    }
}

std::optional<std::uint32_t> Copies::of_leaf(Leaf leaf) const {
    return leaf < leaves_.size() ? leaves_[leaf] : std::nullopt;
}

std::string Copies::name_with_copy(const std::string& component, std::optional<std::uint32_t> copy) const {
    if (!meaning_ || !copy) return component;
    const std::string one = fmt::format("{} {}", meaning_->word, *copy);
    return component.empty() ? one : fmt::format("{} of {}", component, one);
}

}  // namespace robochart::runs
