// SPDX-License-Identifier: Apache-2.0
// The sets of events, renamings and priority orders that packed terms name by number. These numbers stay valid for the
// whole search, although a term store that is created later numbers the same sets anew (packed_processes.hpp).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "checker/process/term.hpp"

namespace robochart::cspm {

/// Owns the contents of these parts.
class PackedParts {
public:
    /// Sets the term store of the following calls. Events must have the same numbers in all stores.
    void set_terms(process::TermStore& terms);
    /// After this call a part without a number causes NotPacked. This makes the rows of a search the same in every run.
    void fix_numbers() { fixed_ = true; }

    [[nodiscard]] std::uint32_t number_of(process::SetId set);
    [[nodiscard]] std::uint32_t number_of(process::RenamingId renaming);
    [[nodiscard]] std::uint32_t number_of(process::OrderId order);
    [[nodiscard]] process::SetId set(std::uint32_t number);
    [[nodiscard]] process::RenamingId renaming(std::uint32_t number);
    [[nodiscard]] process::OrderId order(std::uint32_t number);

private:
    using Content = std::vector<process::EventSet>;  // one set; a renaming is one list of its pairs
    using Numbers = std::vector<std::optional<std::uint32_t>>;

    std::uint32_t number_content(Content content);

    process::TermStore* terms_ = nullptr;
    bool fixed_ = false;
    std::map<Content, std::uint32_t> numbers_;
    std::vector<const Content*> contents_;
    Numbers sets_, renamings_, orders_;                       // number in the store -> number in the search
    Numbers inside_sets_, inside_renamings_, inside_orders_;  // number in the search -> number in the store
};

}  // namespace robochart::cspm
