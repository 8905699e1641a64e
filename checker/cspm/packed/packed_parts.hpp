// SPDX-License-Identifier: Apache-2.0
// Assigns numbers to the sets of events, the renamings and the priority orders in packed terms. Packed terms contain
// these numbers. They stay valid for the whole search, but a term store that is created later numbers the same sets
// differently (packed_processes.hpp).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "checker/process/term.hpp"

namespace robochart::cspm {

/// Owns the sets, renamings and orders that have numbers.
class PackedParts {
public:
    /// Sets the term store that the following calls use. Events must have the same numbers in all stores.
    void set_terms(process::TermStore& terms);
    /// After this call, nothing gets a new number: a set, renaming or order without a number causes NotPacked. So the
    /// rows of a search are the same in every run.
    void fix_numbers() { fixed_ = true; }

    [[nodiscard]] std::uint32_t number_of(process::SetId set);
    [[nodiscard]] std::uint32_t number_of(process::RenamingId renaming);
    [[nodiscard]] std::uint32_t number_of(process::OrderId order);
    [[nodiscard]] process::SetId set(std::uint32_t number);
    [[nodiscard]] process::RenamingId renaming(std::uint32_t number);
    [[nodiscard]] process::OrderId order(std::uint32_t number);

private:
    using Content = std::vector<process::EventSet>;  // one set; for a renaming, the list of its pairs
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
