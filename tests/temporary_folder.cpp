// SPDX-License-Identifier: Apache-2.0
#include "tests/temporary_folder.hpp"

#include <stdlib.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace robochart::tests {

namespace fs = std::filesystem;

namespace {

std::string make_folder() {
    const std::string pattern = (fs::temp_directory_path() / "robochart-test-XXXXXX").string();
    std::string path = pattern;
    if (mkdtemp(path.data()) == nullptr)
        throw std::runtime_error("cannot make the folder " + pattern + ": " + std::generic_category().message(errno));
    return path;
}

}  // namespace

TemporaryFolder::TemporaryFolder() : path_(make_folder()) {}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string TemporaryFolder::in(const std::string& name) const {
    return path_ + "/" + name;
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
    std::string file = in(name);
    fs::create_directories(fs::path(file).parent_path());
    std::ofstream out(file, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error("cannot write " + file);
    return file;
}

}  // namespace robochart::tests
