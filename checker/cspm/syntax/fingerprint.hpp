// What a syntax tree says, as a number: trees that compare equal (syntax.hpp) have equal fingerprints. Whoever looks
// for equal trees among many need not print them, nor compare each with each.
#pragma once

#include <cstdint>
#include <map>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

struct Fingerprint {
    std::uint64_t hash = 0;
    std::size_t size = 0;  ///< about as many as the characters of its text, without white space
};

/// Takes fingerprints; those of modules are kept, so that a module inside others is looked at once.
class Fingerprints {
public:
    /// Of what a module exports, whatever its own name is.
    [[nodiscard]] Fingerprint of_exports(const DeclPtr& module);

private:
    class Digest;
    std::map<DeclPtr, Fingerprint> exports_;  ///< looked up only
};

}  // namespace robochart::cspm
