// A CSP block can be named by the claims of other files, its names by their blocks, and a block can replace the
// instantiation. So beside a broken file with blocks only claims in files without any are left, and of those no file
// that names one of its processes.
#include "app/command/broken_claims.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace robochart::app {
namespace {

using frontend::File;

class Split {
public:
    explicit Split(const Project& project) : project_(project) {}

    std::optional<BrokenClaims> find() {
        if (!find_wrong() || !can_be_left_out()) return std::nullopt;
        BrokenClaims result;
        const auto& files = project_.model->files;
        for (std::size_t i = 0; i < files.size(); ++i) {
            if (files[i]->is_library) continue;
            const bool claims = files[i]->is_assertions;
            if (!claims || is_sound(*files[i])) result.sound.files.push_back(i);
            if (!claims || !is_sound(*files[i])) result.broken.files.push_back(i);
            some_ = some_ || (claims && is_sound(*files[i]) && !files[i]->assertions.empty());
        }
        if (!some_) return std::nullopt;
        result.broken.again = true;
        return result;
    }

private:
    /// The assertion files with errors; false where there are none, or errors elsewhere.
    bool find_wrong() {
        for (const diagnostics::Diagnostic& finding : project_.diagnostics.sorted()) {
            if (finding.rule->severity != diagnostics::Severity::error) continue;
            const File* const file = finding.span.known() ? file_of(finding.span.source) : nullptr;
            if (file == nullptr || !file->is_assertions) return false;
            wrong_.insert(file);
        }
        return !wrong_.empty() && project_.diagnostics.dropped() == 0;
    }

    /// Texts of blocks are sources of their own, under the path of their file.
    [[nodiscard]] const File* file_of(diagnostics::SourceId source) const {
        const std::string& path = project_.sources.path(source);
        for (const auto& file : project_.model->files)
            if (file->source == source || project_.sources.path(file->source) == path) return file.get();
        return nullptr;
    }

    [[nodiscard]] bool has_blocks(const File& file) const {
        return !file.csp_blocks.empty() ||
               project_.sources.text(file.source).find("csp-begin") != std::string_view::npos;
    }

    /// Nothing is known of the blocks of a text that was not understood, and all depends on an instantiation.
    [[nodiscard]] bool can_be_left_out() {
        return std::all_of(wrong_.begin(), wrong_.end(), [&](const File* file) {
            blocks_ = blocks_ || has_blocks(*file);
            const bool all_known = !has_blocks(*file) || !file->has_syntax_errors;
            return all_known && file->declarations.empty() &&
                   std::none_of(file->csp_blocks.begin(), file->csp_blocks.end(), frontend::replaces_instantiations);
        });
    }

    [[nodiscard]] bool is_sound(const File& file) const {
        if (wrong_.contains(&file)) return false;
        if (!blocks_) return true;
        return !has_blocks(file) && std::none_of(file.assertions.begin(), file.assertions.end(), [&](const auto& each) {
            return names_a_block(each.subject.text()) || names_a_block(each.other.text());
        });
    }

    [[nodiscard]] bool names_a_block(const std::string& name) const {
        const auto has = [&](const auto& file) {
            return std::any_of(file->csp_blocks.begin(), file->csp_blocks.end(),
                               [&](const frontend::CspBlock& block) { return block.name == name; });
        };
        return std::any_of(project_.model->files.begin(), project_.model->files.end(), has);
    }

    const Project& project_;
    std::set<const File*> wrong_;  ///< never iterated in an order that matters
    bool blocks_ = false;          ///< some of them have blocks
    bool some_ = false;            ///< something is left to decide
};

}  // namespace

std::optional<BrokenClaims> broken_claims(const Project& project) {
    return Split(project).find();
}

}  // namespace robochart::app
