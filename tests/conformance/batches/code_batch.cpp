// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/batches/code_batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

#include "conformance/code/shared_object.hpp"
#include "cpp_emit/files/shipped_headers.hpp"

namespace robochart::conformance {

namespace {

const cpp_emit::OutputFile* file_ending(const cpp_emit::Emission& code, std::string_view end) {
    for (const cpp_emit::OutputFile& file : code.files)
        if (file.path.ends_with(end)) return &file;
    return nullptr;
}

/// Appends the text without the lines that must occur only once, at the top of a source. Adds the headers that it
/// includes to `includes`, except headers of the candidate itself.
void append_text(std::string& text, const std::string& source, std::set<std::string>& includes) {
    const std::string_view entry = "extern \"C\" const rc_interface* robochart_explore(void) {";
    for (std::size_t begin = 0; begin < source.size();) {
        const std::size_t end = std::min(source.find('\n', begin), source.size());
        const std::string_view line = std::string_view(source).substr(begin, end - begin);
        begin = end + 1;
        if (line.starts_with("#include <") || line.starts_with("#include \"robochart/")) includes.emplace(line);
        if (line.starts_with("#include") || line.starts_with("#pragma") || line.starts_with("#define")) continue;
        text += line == entry ? "const rc_interface* robochart_explore() {" : line;
        text += '\n';
    }
}

std::string batch_preamble(const std::set<std::string>& includes) {
    std::string text = "#define RC_REQUIRE(condition) static_cast<void>(0)\n#define ROBOCHART_PROBES\n\n";
    for (const std::string& include : includes) text += include + "\n";
    return text + "\n";
}

/// Returns the candidate's own headers that its exploration interface includes, in the order of inclusion, and then
/// this interface.
std::vector<const cpp_emit::OutputFile*> own_files(const cpp_emit::Emission& code) {
    const cpp_emit::OutputFile& shim = *file_ending(code, code.shim);
    std::vector<const cpp_emit::OutputFile*> files;
    for (const cpp_emit::OutputFile& file : code.files)
        if (const std::size_t place = shim.text.find("#include \"" + file.path + "\"");
            place != std::string::npos && !file.path.starts_with("robochart/"))
            files.push_back(&file);
    const auto place = [&](const cpp_emit::OutputFile* file) { return shim.text.find('"' + file->path + '"'); };
    std::ranges::sort(files, [&](const auto* a, const auto* b) { return place(a) < place(b); });
    files.push_back(&shim);
    return files;
}

constexpr std::string_view candidate_file = "candidate_";

}  // namespace

std::vector<cpp_emit::OutputFile> batch_files(const std::vector<const cpp_emit::Emission*>& all) {
    std::vector<cpp_emit::OutputFile> files = cpp_emit::shipped_headers();
    std::set<std::string> includes;
    std::string text;
    for (std::size_t i = 0; i < all.size(); ++i) {
        text += fmt::format("#line 1 \"{0}{1}.cpp\"\nnamespace candidate_{1} {{\n", candidate_file, i);
        for (const cpp_emit::OutputFile* file : own_files(*all[i])) append_text(text, file->text, includes);
        text += fmt::format("}}  // namespace candidate_{}\n\n", i);
        text += fmt::format(
            "extern \"C\" __attribute__((visibility(\"default\"))) const rc_interface* robochart_explore_{0}(void) {{\n"
            "    return candidate_{0}::robochart_explore();\n}}\n\n",
            i);
    }
    files.push_back({batch_source, batch_preamble(includes) + text});
    return files;
}

std::vector<std::string> errors_by_candidate(const std::string& words, std::size_t count) {
    std::vector<std::string> errors(count);
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = std::min(words.find('\n', begin), words.size());
        const std::string line = words.substr(begin, end - begin);
        begin = end + 1;
        const std::size_t file = line.find(candidate_file);
        const std::size_t error = line.find(" error: ");
        if (file == std::string::npos || error == std::string::npos || file > error) continue;
        std::size_t number = count;
        (void)std::from_chars(line.data() + file + candidate_file.size(), line.data() + line.size(), number);
        if (number < count && errors[number].empty()) errors[number] = line.substr(error + 1);
    }
    return errors;
}

std::unique_ptr<CodeBatch> CodeBatch::build(const std::vector<const cpp_emit::Emission*>& all,
                                            const cpp_emit::BuildOptions& options, std::string& error) {
    std::unique_ptr<CodeBatch> batch(new CodeBatch);
    batch->library_ = cpp_emit::SharedLibrary::build(batch_files(all), {batch_source}, options, error);
    return batch->library_ ? std::move(batch) : nullptr;
}

const rc_interface* CodeBatch::code_at(std::size_t index, std::string& fault) const {
    void* const symbol = library_->find_symbol(fmt::format("robochart_explore_{}", index).c_str());
    const rc_interface* const code =
        symbol == nullptr ? nullptr : reinterpret_cast<const rc_interface* (*)()>(symbol)();
    fault = code == nullptr ? "it has no entry" : interface_fault(*code);
    return fault.empty() ? code : nullptr;
}

}  // namespace robochart::conformance
