// SPDX-License-Identifier: Apache-2.0
// Decodes and encodes file URIs (percent encoding).
#include "editors/server/protocol/uri.hpp"

#include <filesystem>

#include "base/diagnostics/escape.hpp"

namespace robochart::lsp {

namespace {

constexpr std::string_view scheme = "file://";

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string decode_percent(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escape =
            text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 && hex_digit(text[i + 2]) >= 0;
        out += escape ? static_cast<char>(hex_digit(text[i + 1]) * 16 + hex_digit(text[i + 2])) : text[i];
        if (escape) i += 2;
    }
    return out;
}

}  // namespace

std::string path_of_uri(std::string_view uri) {
    if (uri.substr(0, scheme.size()) != scheme) return std::string(uri);
    uri.remove_prefix(scheme.size());
    const std::size_t slash = uri.find('/');  // an authority, if any, is assumed to be this machine
    const std::string path = decode_percent(slash == std::string_view::npos ? uri : uri.substr(slash));
    return std::filesystem::path(path).lexically_normal().string();
}

std::string uri_of_path(std::string_view path) {
    return path.starts_with('/') ? diagnostics::uri_of_path(path) : std::string(path);
}

}  // namespace robochart::lsp
