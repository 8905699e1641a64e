#include "conformance/batch.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>

#include "conformance/component.hpp"
#include "conformance/judge.hpp"
#include "conformance/safe_model.hpp"
#include "conformance/shared_object.hpp"

namespace robochart::conformance {

namespace {

const cpp_emit::OutputFile* file_ending(const cpp_emit::Emission& code, std::string_view end) {
    for (const cpp_emit::OutputFile& file : code.files)
        if (file.path.ends_with(end)) return &file;
    return nullptr;
}

/// The text without what stands once at the top: `includes` gets the headers, but those of the candidate itself.
void append_text(std::string& text, const std::string& source, std::set<std::string>& includes) {
    const std::string_view entry = "extern \"C\" const rc_interface* robochart_explore(void) {";
    for (std::size_t begin = 0; begin < source.size();) {
        const std::size_t end = std::min(source.find('\n', begin), source.size());
        const std::string_view line = std::string_view(source).substr(begin, end - begin);
        begin = end + 1;
        if (line.starts_with("#include <") || line.starts_with("#include \"robochart/")) includes.emplace(line);
        if (line.starts_with("#include") || line.starts_with("#pragma") || line.starts_with("#define")) continue;
        text += line == entry ? "const rc_interface* explore() {" : line;
        text += '\n';
    }
}

std::string preamble(const std::set<std::string>& includes) {
    std::string text = "#define RC_REQUIRE(condition) static_cast<void>(0)\n\n";
    for (const std::string& include : includes) text += include + "\n";
    return text + "\n";
}

}  // namespace

std::unique_ptr<Candidate> candidate(const ir::System& system, const ir::Instantiation& instantiation,
                                     const ir::ComponentRef& component, const Options& options,
                                     diagnostics::SourceManager& sources, diagnostics::Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    auto result = std::make_unique<Candidate>();
    SafeModel model = safe_model(system, instantiation, component, diagnostics);
    result->system = std::move(model.system);
    result->instantiation = std::move(model.instantiation);
    result->component = std::move(model.component);
    cpp_emit::Options generator = options.generator;
    generator.cycle_length = options.cycle_length;
    result->code = cpp_emit::emit(result->system, result->instantiation, result->component, generator, diagnostics);
    if (diagnostics.errors() != errors || result->code.shim.empty()) return nullptr;
    result->script =
        csp_emit::emit(result->system, result->instantiation, csp_emit::Time::timed, {}, sources, diagnostics);
    return diagnostics.errors() == errors ? std::move(result) : nullptr;
}

std::vector<cpp_emit::OutputFile> batch_files(const std::vector<std::unique_ptr<Candidate>>& candidates) {
    std::vector<cpp_emit::OutputFile> files = cpp_emit::shipped_headers();
    std::set<std::string> includes;
    std::string text;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const cpp_emit::Emission& code = candidates[i]->code;
        text += fmt::format("namespace candidate_{} {{\n", i);
        append_text(text, file_ending(code, "_core.hpp")->text, includes);
        append_text(text, file_ending(code, code.shim)->text, includes);
        text += fmt::format("}}  // namespace candidate_{}\n\n", i);
        text += fmt::format(
            "extern \"C\" __attribute__((visibility(\"default\"))) const rc_interface* robochart_explore_{0}(void) {{\n"
            "    return candidate_{0}::explore();\n}}\n\n",
            i);
    }
    files.push_back({batch_source, preamble(includes) + text});
    return files;
}

std::unique_ptr<Batch> Batch::build(std::vector<std::unique_ptr<Candidate>> candidates, const Options& options,
                                    std::string& error) {
    std::unique_ptr<Batch> batch(new Batch);
    batch->candidates_ = std::move(candidates);
    batch->options_ = options;
    batch->library_ = cpp_emit::SharedLibrary::build(batch_files(batch->candidates_), {batch_source},
                                                     {options.compiler, options.flags, options.work_dir}, error);
    return batch->library_ ? std::move(batch) : nullptr;
}

Result Batch::judge(std::size_t index, std::optional<std::chrono::steady_clock::time_point> deadline) const {
    const Candidate& candidate = *candidates_.at(index);
    Result result;
    void* const symbol = library_->symbol(fmt::format("robochart_explore_{}", index).c_str());
    const rc_interface* const code =
        symbol == nullptr ? nullptr : reinterpret_cast<const rc_interface* (*)()>(symbol)();
    const std::string fault = code == nullptr ? "it has no entry" : interface_fault(*code);
    if (!fault.empty()) {
        result.outcome = Outcome::differs;
        result.reason = "the exploration interface cannot be used: " + fault;
        return result;
    }
    Options options = options_;
    if (deadline) options.limits.deadline = deadline;
    return judge_code(candidate.script, candidate.system, candidate.instantiation, candidate.component, *code, options);
}

}  // namespace robochart::conformance
