// SPDX-License-Identifier: Apache-2.0
#include "conformance/code/code_images.hpp"

#include <algorithm>
#include <array>

namespace robochart::conformance {

namespace {

/// Initial bytes of the state passed to `initial`. Two patterns reveal bytes that `initial` does not write.
constexpr std::array<unsigned char, 2> fills{0x00, 0xA5};

}  // namespace

std::string state_text(void (*print)(const void*, char*, std::size_t), const void* state) {
    std::string text;
    for (std::size_t size = 4096; size <= longest_state_text; size *= 4) {
        text.assign(size, '\0');
        print(state, text.data(), text.size());
        text.back() = '\0';
        text.resize(text.find('\0'));
        if (text.size() + 1 < size) break;
    }
    return text;
}

CodeImages::CodeImages(const rc_interface& code) : code_(&code) {
    const Bytes first = fresh_state(fills[0]);
    reset_writes_all_ = first == fresh_state(fills[1]);
    reset_ = intern(first);
}

CodeImages::Bytes CodeImages::fresh_state(unsigned char fill) const {
    Bytes state(code_->state_size, fill);
    code_->initial(state.data());
    return state;
}

std::uint32_t CodeImages::intern(const Bytes& state) {
    key_.assign(state.begin(), state.end());
    if (const auto known = ids_.find(key_); known != ids_.end()) return known->second;
    const auto image = static_cast<std::uint32_t>(count_++);
    ids_.emplace(key_, image);
    images_.insert(images_.end(), state.begin(), state.end());
    if (code_->tracking != nullptr) return image;  // a known number and an input print alike
    const std::string text = print(image);
    if (text.size() + 1 < longest_state_text) alias_found_ |= !printed_.emplace(text, image).second;
    return image;
}

CodeImages::Bytes CodeImages::bytes(std::uint32_t image) const {
    const unsigned char* const begin = images_.data() + std::size_t{image} * code_->state_size;
    return {begin, begin + code_->state_size};
}

bool CodeImages::has_bytes(std::uint32_t image, const Bytes& state) const {
    return std::equal(state.begin(), state.end(), images_.data() + std::size_t{image} * code_->state_size);
}

std::string CodeImages::print(std::uint32_t image) const {
    return state_text(code_->print, bytes(image).data());
}

}  // namespace robochart::conformance
