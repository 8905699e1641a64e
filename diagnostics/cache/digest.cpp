#include "diagnostics/cache/digest.hpp"

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

void Hasher::bytes(const void* first, std::size_t size) {
    crypto_generichash_update(&state_->hash, static_cast<const unsigned char*>(first), size);
}

void Hasher::add(std::string_view text) {
    add(text.size());
    bytes(text.data(), text.size());
}

void Hasher::add(std::uint64_t number) {
    bytes(&number, sizeof number);
}

void Hasher::add(std::span<const std::uint32_t> numbers) {
    add(numbers.size());
    bytes(numbers.data(), numbers.size_bytes());
}

void Hasher::add(const Digest& digest) {
    bytes(digest.data(), digest.size());
}

Digest Hasher::finish() {
    Digest digest;
    crypto_generichash_final(&state_->hash, digest.data(), digest.size());
    return digest;
}

}  // namespace robochart::diagnostics
