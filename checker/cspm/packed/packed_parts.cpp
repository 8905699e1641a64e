// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/packed/packed_parts.hpp"

#include "checker/cspm/packed/not_packed.hpp"

namespace robochart::cspm {

using process::EventSet;

namespace {

std::optional<std::uint32_t>& entry_at(std::vector<std::optional<std::uint32_t>>& list, std::uint32_t at) {
    if (at >= list.size()) list.resize(at + std::size_t{1});
    return list[at];
}

}  // namespace

void PackedParts::set_terms(process::TermStore& terms) {
    terms_ = &terms;
    for (Numbers* const list : {&sets_, &renamings_, &orders_, &inside_sets_, &inside_renamings_, &inside_orders_})
        list->clear();
}

std::uint32_t PackedParts::number_content(Content content) {
    const auto known = numbers_.find(content);
    if (known != numbers_.end()) return known->second;
    if (fixed_) throw NotPacked{"a set of events or a renaming is not that of the process at its start"};
    const auto number = static_cast<std::uint32_t>(contents_.size());
    const auto entry = numbers_.emplace(std::move(content), number).first;
    contents_.push_back(&entry->first);
    return number;
}

std::uint32_t PackedParts::number_of(process::SetId set) {
    std::optional<std::uint32_t>& known = entry_at(sets_, static_cast<std::uint32_t>(set));
    if (!known) known = number_content({(*terms_)[set]});
    return *known;
}

std::uint32_t PackedParts::number_of(process::RenamingId renaming) {
    std::optional<std::uint32_t>& known = entry_at(renamings_, static_cast<std::uint32_t>(renaming));
    if (known) return *known;
    EventSet list;
    for (const auto& [from, to] : (*terms_)[renaming]) list.insert(list.end(), {from, to});
    known = number_content({std::move(list)});
    return *known;
}

std::uint32_t PackedParts::number_of(process::OrderId order) {
    std::optional<std::uint32_t>& known = entry_at(orders_, static_cast<std::uint32_t>(order));
    if (!known) known = number_content((*terms_)[order]);
    return *known;
}

process::SetId PackedParts::set(std::uint32_t number) {
    std::optional<std::uint32_t>& known = entry_at(inside_sets_, number);
    if (!known) known = static_cast<std::uint32_t>(terms_->intern_set(contents_.at(number)->front()));
    return process::SetId{*known};
}

process::RenamingId PackedParts::renaming(std::uint32_t number) {
    std::optional<std::uint32_t>& known = entry_at(inside_renamings_, number);
    if (!known) {
        const EventSet& list = contents_.at(number)->front();
        process::Renaming pairs;
        for (std::size_t i = 0; i + 1 < list.size(); i += 2) pairs.emplace_back(list[i], list[i + 1]);
        known = static_cast<std::uint32_t>(terms_->intern_renaming(std::move(pairs)));
    }
    return process::RenamingId{*known};
}

process::OrderId PackedParts::order(std::uint32_t number) {
    std::optional<std::uint32_t>& known = entry_at(inside_orders_, number);
    if (!known) known = static_cast<std::uint32_t>(terms_->intern_order(*contents_.at(number)));
    return process::OrderId{*known};
}

}  // namespace robochart::cspm
