// SPDX-License-Identifier: Apache-2.0
// A fingerprint is a hash of the content of a syntax tree: trees that compare equal (syntax.hpp) have equal
// fingerprints. It finds equal trees among many without comparing every pair.
#pragma once

#include <cstdint>
#include <map>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

struct Fingerprint {
    std::uint64_t hash = 0;
    std::size_t size = 0;  ///< approximately the number of characters of its text without white space
};

/// Computes fingerprints; those of modules are cached, so that nested modules are visited once.
class Fingerprints {
public:
    /// The fingerprint of a module's exports, independent of its name.
    [[nodiscard]] Fingerprint of_exports(const DeclPtr& module);

private:
    class Digest;
    std::map<DeclPtr, Fingerprint> exports_;  ///< never iterated
};

}  // namespace robochart::cspm
