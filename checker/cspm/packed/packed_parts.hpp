// SPDX-License-Identifier: Apache-2.0
// The sets of events, renamings and orders that packed terms name by number. Evaluation numbers these anew whenever it
// begins again (packed_processes.hpp); here they keep the numbers of the search.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "checker/process/term.hpp"

namespace robochart::cspm {

/// Owns the contents of the parts.
class PackedParts {
public:
    /// From now on terms are those of this store, whose events are those of the store before.
    void use(process::TermStore& terms);
    /// From now on a part without a number is refused with NotPacked: all rows have the same numbers in every run.
    void fix() { fixed_ = true; }

    [[nodiscard]] std::uint32_t number(process::SetId set);
    [[nodiscard]] std::uint32_t number(process::RenamingId renaming);
    [[nodiscard]] std::uint32_t number(process::OrderId order);
    [[nodiscard]] process::SetId set(std::uint32_t number);
    [[nodiscard]] process::RenamingId renaming(std::uint32_t number);
    [[nodiscard]] process::OrderId order(std::uint32_t number);

private:
    using Content = std::vector<process::EventSet>;  // of a renaming, pair after pair in one list
    using Numbers = std::vector<std::optional<std::uint32_t>>;

    std::uint32_t keep(Content content);

    process::TermStore* terms_ = nullptr;
    bool fixed_ = false;
    std::map<Content, std::uint32_t> numbers_;
    std::vector<const Content*> contents_;
    Numbers sets_, renamings_, orders_;                       // by the store's numbers, those of the search
    Numbers inside_sets_, inside_renamings_, inside_orders_;  // by the numbers of the search, the store's
};

}  // namespace robochart::cspm
