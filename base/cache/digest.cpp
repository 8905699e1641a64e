// SPDX-License-Identifier: Apache-2.0
#include "base/cache/digest.hpp"

#include <sodium.h>

#include <stdexcept>

namespace robochart::diagnostics {

struct Hasher::State {
    crypto_generichash_state hash;
};

Hasher::Hasher() : state_(std::make_unique<State>()) {
    if (sodium_init() < 0) throw std::runtime_error("libsodium cannot be used");
    crypto_generichash_init(&state_->hash, nullptr, 0, Digest().size());
}

Hasher::~Hasher() = default;

void Hasher::add_bytes(const void* first, std::size_t size) {
    crypto_generichash_update(&state_->hash, static_cast<const unsigned char*>(first), size);
}

void Hasher::add(std::string_view text) {
    add(text.size());
    add_bytes(text.data(), text.size());
}

void Hasher::add(std::uint64_t number) {
    add_bytes(&number, sizeof number);
}

void Hasher::add(std::span<const std::uint32_t> numbers) {
    add(numbers.size());
    add_bytes(numbers.data(), numbers.size_bytes());
}

void Hasher::add(const Digest& digest) {
    add_bytes(digest.data(), digest.size());
}

Digest Hasher::finish() {
    Digest digest;
    crypto_generichash_final(&state_->hash, digest.data(), digest.size());
    return digest;
}

std::string policy_hash(std::string_view text) {
    std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
    const std::string bytes(text);
    crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    std::string encoded(sodium_base64_ENCODED_LEN(hash.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
    sodium_bin2base64(encoded.data(), encoded.size(), hash.data(), hash.size(), sodium_base64_VARIANT_ORIGINAL);
    encoded.resize(encoded.find('\0'));
    return "sha256-" + encoded;
}

}  // namespace robochart::diagnostics
