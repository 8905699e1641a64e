// SPDX-License-Identifier: Apache-2.0
// Computes fingerprints of syntax trees. A fingerprint is a hash of the contents, so equal trees (syntax.hpp) have
// equal fingerprints. They find equal trees among many without comparing every pair.
#pragma once

#include <cstdint>
#include <map>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

struct Fingerprint {
    std::uint64_t hash = 0;
    std::size_t size = 0;  ///< approximate number of characters of the text without white space
};

/// Computes fingerprints. Caches those of modules, so that a nested module is visited only once.
class Fingerprints {
public:
    /// Returns the fingerprint of what a module exports. It does not depend on the module's name.
    [[nodiscard]] Fingerprint of_exports(const DeclPtr& module);

private:
    class Digest;
    std::map<DeclPtr, Fingerprint> exports_;  ///< searched by key but never iterated: its order has no effect
};

}  // namespace robochart::cspm
