// SPDX-License-Identifier: Apache-2.0
// Computes fingerprints of syntax trees, which are hashes of their contents: trees that compare equal (syntax.hpp) have
// equal fingerprints. With fingerprints, equal trees are found among many without a comparison of every pair.
#pragma once

#include <cstdint>
#include <map>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

struct Fingerprint {
    std::uint64_t hash = 0;
    std::size_t size = 0;  ///< approximate number of characters of the text without white space
};

/// Computes fingerprints. Those of modules are cached, so that nested modules are visited only once.
class Fingerprints {
public:
    /// Returns the fingerprint of a module's exports, which does not depend on the module's name.
    [[nodiscard]] Fingerprint of_exports(const DeclPtr& module);

private:
    class Digest;
    std::map<DeclPtr, Fingerprint> exports_;  ///< looked up, but never iterated
};

}  // namespace robochart::cspm
