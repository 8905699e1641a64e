// SPDX-License-Identifier: Apache-2.0
// Finds the claims and blocks that an error may affect. Claims are independent of each other: an error in one does not
// affect the others if the text around them could be parsed. A claim depends on the CSP blocks whose processes it
// names, and a block depends on the blocks whose names it uses. A block may also replace the instantiation, on which
// everything depends. Excluded items are replaced by blanks in the text, so that the rest is read as if they did not
// exist.
//
// An error in an operation, machine, controller or module does not affect the claims about other components: all
// declarations that contain the name of an excluded one are excluded, too. So no name in the rest refers to an excluded
// declaration, and the rest is a separate project, with the same meaning of all names. It is read and checked again.
#include "driver/model/broken_claims.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "checker/cspm/syntax/lexer.hpp"
#include "driver/model/project_claims.hpp"

namespace robochart::driver {
namespace {

using frontend::Assertion;
using frontend::AssertionTime;
using frontend::CspBlock;
using frontend::Declaration;
using frontend::DeclKind;
using frontend::File;

/// A claim, a block, or a definition for probabilistic claims, including the keyword for its semantics.
struct Item {
    std::size_t begin = 0;
    std::size_t end = 0;
    const Assertion* claim = nullptr;
    const CspBlock* block = nullptr;
};

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

void blank_range(std::string& text, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < std::min(end, text.size()); ++i)
        if (text[i] != '\n') text[i] = ' ';
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> result;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && cspm::continues_name(text[end])) ++end;
        if (end > at) result.emplace_back(text.substr(at, end - at));
        at = std::max(end, at + 1);
    }
    return result;
}

/// Adds the names that a block may declare: the first word of each line, unless it is a component before `::`, and all
/// words of a line that begins with a declaring keyword.
void add_declared(const CspBlock& block, std::set<std::string>& names) {
    static const std::set<std::string_view> declaring = {"channel", "datatype",    "subtype",  "nametype",
                                                         "module",  "transparent", "external", "instance"};
    for (std::size_t at = 0; at < block.text.size();) {
        const std::size_t end = std::min(block.text.find('\n', at), block.text.size());
        const std::string_view line = std::string_view(block.text).substr(at, end - at);
        at = end + 1;
        const std::vector<std::string> words = words_of(line);
        if (words.empty()) continue;
        const std::size_t behind = line.find(words.front()) + words.front().size();
        if (declaring.contains(words.front()))
            names.insert(words.begin(), words.end());
        else if (line.substr(behind, 2) != "::")
            names.insert(words.front());
    }
}

/// The items of an assertion file.
class ItemList {
public:
    ItemList(const File& file, std::string_view text) : text_(text) {
        for (const diagnostics::Span& comment : file.comments) blank_range(text_, comment.begin, comment.end);
        for (const frontend::Import& import : file.imports) blank_range(text_, import.span.begin, import.span.end);
        for (const Assertion& assertion : file.assertions)
            items_.push_back(
                {with_time(assertion.span.begin, assertion.time), assertion.span.end, &assertion, nullptr});
        for (const CspBlock& block : file.csp_blocks)
            items_.push_back({with_time(block.span.begin, block.time), block.span.end, nullptr, &block});
        for (const auto& assertion : file.probabilistic_assertions)
            items_.push_back({assertion.span.begin, assertion.span.end});
        for (const auto& definition : file.probabilistic_definitions)
            items_.push_back({definition.span.begin, definition.span.end});
        for (const auto& simulation : file.simulations)
            items_.push_back({simulation->span.begin, simulation->span.end});
        for (const auto& part : file.kept) items_.push_back({part.whole.begin, part.whole.end});
        std::ranges::sort(items_, [](const Item& a, const Item& b) { return a.begin < b.begin; });
    }

    [[nodiscard]] const std::vector<Item>& all_items() const { return items_; }

    /// Finds the items that an error may affect. For an error in a text between two items, `add_stray_neighbours` finds
    /// them. Returns false if the error is before all items and not in a claim that could not be parsed. `head` is set
    /// to the beginning of the first claim that could not be parsed.
    bool touched_by(diagnostics::Span error, std::vector<Item>& found, std::size_t& head) const {
        if (items_.empty()) return false;
        if (error.begin < items_.front().begin) {
            const std::size_t line = error.begin == 0 ? 0 : text_.rfind('\n', error.begin - 1) + 1;
            head = std::min(head, line);
            return begins_claim(line);
        }
        for (std::size_t i = 0; i < items_.size(); ++i) {
            const bool inside = items_[i].begin <= error.end && error.begin <= items_[i].end;
            const bool behind =
                items_[i].end <= error.begin && error.begin <= next(i) && !is_stray(items_[i].end, next(i));
            if (inside || behind) found.push_back(items_[i]);
        }
        return true;
    }
    /// Finds the items next to a text that belongs to no item. A claim that could not be parsed does not affect the
    /// item before it, and it does not affect the item after it if that item begins a line.
    void add_stray_neighbours(std::size_t head, std::vector<Item>& found) const {
        if (head < items_.front().begin && !begins_line(items_.front().begin)) found.push_back(items_.front());
        for (std::size_t i = 0; i < items_.size(); ++i) {
            if (!is_stray(items_[i].end, next(i))) continue;
            if (!begins_claim(items_[i].end)) found.push_back(items_[i]);
            if (i + 1 < items_.size() && !begins_line(next(i))) found.push_back(items_[i + 1]);
        }
    }
    void blank_strays(std::size_t head, std::string& text) const {
        if (head < items_.front().begin) blank_range(text, head, items_.front().begin);
        for (std::size_t i = 0; i < items_.size(); ++i)
            if (is_stray(items_[i].end, next(i))) blank_range(text, items_[i].end, next(i));
    }

private:
    /// Returns the offset at which the next item begins.
    [[nodiscard]] std::size_t next(std::size_t item) const {
        return item + 1 < items_.size() ? items_[item + 1].begin : text_.size();
    }

    /// Returns the offset of the keyword `timed` or `untimed` before an item.
    [[nodiscard]] std::size_t with_time(std::size_t begin, AssertionTime time) const {
        if (time == AssertionTime::both) return begin;
        const std::string_view word = time == AssertionTime::timed ? "timed" : "untimed";
        std::size_t end = begin;
        while (end > 0 && is_space(text_[end - 1])) --end;
        const bool there = end >= word.size() && text_.compare(end - word.size(), word.size(), word) == 0;
        return there ? end - word.size() : begin;
    }

    /// True if `assertion`, `timed assertion` or `untimed assertion` is here, possibly after blanks.
    [[nodiscard]] bool begins_claim(std::size_t at) const {
        for (const std::string_view word : {"timed", "untimed", "assertion"}) {
            while (at < text_.size() && is_space(text_[at])) ++at;
            if (text_.compare(at, word.size(), word) != 0 ||
                cspm::continues_name(text_[std::min(at + word.size(), text_.size() - 1)]))
                continue;
            if (word == "assertion") return true;
            at += word.size();
        }
        return false;
    }

    [[nodiscard]] bool begins_line(std::size_t at) const {
        while (at > 0 && text_[at - 1] != '\n' && is_space(text_[at - 1])) --at;
        return at == 0 || text_[at - 1] == '\n';
    }

    [[nodiscard]] bool is_stray(std::size_t begin, std::size_t end) const {
        return begin < end && !std::all_of(text_.begin() + static_cast<std::ptrdiff_t>(begin),
                                           text_.begin() + static_cast<std::ptrdiff_t>(end), is_space);
    }

    std::string text_;
    std::vector<Item> items_;
};

/// Returns the index of a source in Model::files. The text of a block is a separate source with the path and the
/// offsets of its file.
std::optional<std::size_t> file_of(const Project& project, diagnostics::SourceId source) {
    const std::string& path = project.sources.path(source);
    const auto& files = project.model->files;
    for (std::size_t i = 0; i < files.size(); ++i)
        if (files[i]->source == source || project.sources.path(files[i]->source) == path) return i;
    return std::nullopt;
}

/// Returns the places of the errors in each assertion file; empty if other files have errors.
std::map<std::size_t, std::vector<diagnostics::Span>> errors_in_claims(const Project& project) {
    std::map<std::size_t, std::vector<diagnostics::Span>> result;
    if (project.diagnostics.dropped_count() > 0) return {};
    for (const diagnostics::Diagnostic& finding : project.diagnostics.sorted_findings()) {
        if (finding.rule->severity != diagnostics::Severity::error) continue;
        if (!finding.span.is_known()) return {};
        const std::optional<std::size_t> file = file_of(project, finding.span.source);
        if (!file || !project.model->files[*file]->is_assertions) return {};
        result[*file].push_back(finding.span);
    }
    return result;
}

bool is_definition(const Declaration& declaration) {
    return declaration.kind == DeclKind::operation || declaration.kind == DeclKind::state_machine ||
           declaration.kind == DeclKind::controller || declaration.kind == DeclKind::module;
}

bool contains_word(std::string_view text, const std::set<std::string>& names) {
    const std::vector<std::string> words = words_of(text);
    return std::ranges::any_of(words, [&](const std::string& word) { return names.contains(word); });
}

/// The definitions of a project that have errors, and all declarations that may refer to them.
class WrongDefinitions {
public:
    explicit WrongDefinitions(const Project& project) : project_(project) {}

    /// Finds the definition with this error. Returns false if the error is in no definition.
    bool add_error(const File& file, const diagnostics::Diagnostic& error) {
        if (file.has_syntax_errors || file.is_library) return false;
        for (const auto& declaration : file.declarations) {
            const bool inside = declaration->span.begin <= error.span.begin && error.span.begin < declaration->span.end;
            if (!inside || !is_definition(*declaration) || declaration->name.empty()) continue;
            add(*declaration, "it has errors");
            return true;
        }
        return false;
    }
    void add_dependent() {
        for (std::size_t before = 0; before != found_.size();) {
            before = found_.size();
            for (const auto& file : project_.model->files)
                for (const auto& declaration : file->declarations)
                    if (!file->is_library && !wrong_.contains(declaration.get()) && mentions(*file, *declaration))
                        add(*declaration, "it refers to a definition that is set aside");
        }
    }
    [[nodiscard]] const std::set<std::string>& names() const { return names_; }
    [[nodiscard]] const std::vector<BrokenClaims::SetAside>& found() const { return found_; }
    /// Removes the definitions from the text of their file. Returns whether there are any.
    bool blank_in(const File& file, std::string& text) const {
        bool some = false;
        for (const auto& declaration : file.declarations) {
            if (!wrong_.contains(declaration.get())) continue;
            blank_range(text, declaration->span.begin, declaration->span.end);
            some = true;
        }
        return some;
    }

private:
    void add(const Declaration& declaration, std::string cause) {
        if (!wrong_.insert(&declaration).second) return;
        names_.insert(declaration.name);
        found_.push_back({declaration.name, declaration.name_span, std::move(cause)});
    }
    [[nodiscard]] bool mentions(const File& file, const Declaration& declaration) const {
        const diagnostics::Span span = declaration.span;
        return contains_word(project_.sources.source_text(file.source).substr(span.begin, span.end - span.begin),
                             names_);
    }

    const Project& project_;
    std::vector<BrokenClaims::SetAside> found_;
    std::set<const Declaration*> wrong_;  ///< the order is never used
    std::set<std::string> names_;
};

class Split {
public:
    explicit Split(const Project& project) : project_(project), definitions_(project) {}

    std::optional<BrokenClaims> find() {
        if (!find_errors() || claims_files_contain(definitions_.names())) return std::nullopt;
        leave_out_claims_about(definitions_.names());
        if (!leave_out_wrong()) return std::nullopt;
        leave_out_dependent();
        BrokenClaims result;
        result.set_aside = definitions_.found();
        const auto& files = project_.model->files;
        for (std::size_t i = 0; i < files.size(); ++i)
            if (!files[i]->is_library) divide_file(i, *files[i], result);
        result.some = some_;
        result.broken.unit.again = true;
        return result;
    }

private:
    [[nodiscard]] std::string_view text_of(const File& file) const { return project_.sources.source_text(file.source); }

    /// Returns false if there are no errors, or if an error may affect everything.
    bool find_errors() {
        if (project_.diagnostics.dropped_count() > 0) return false;
        for (const diagnostics::Diagnostic& finding : project_.diagnostics.sorted_findings()) {
            if (finding.rule->severity != diagnostics::Severity::error) continue;
            const auto file = finding.span.is_known() ? file_of(project_, finding.span.source) : std::nullopt;
            if (!file) return false;
            const File& text = *project_.model->files[*file];
            if (text.is_assertions)
                errors_[*file].push_back(finding.span);
            else if (!definitions_.add_error(text, finding))
                return false;
        }
        definitions_.add_dependent();
        return !errors_.empty() || !definitions_.found().empty();
    }

    [[nodiscard]] bool claims_files_contain(const std::set<std::string>& names) const {
        return std::ranges::any_of(project_.claims->files, [&](const auto& file) {
            return contains_word(project_.sources.source_text(file->source), names);
        });
    }

    /// Leaves out the claims and blocks that contain one of these names. If another item of a file contains one, leaves
    /// out the whole file.
    void leave_out_claims_about(const std::set<std::string>& names) {
        for (std::size_t i = 0; i < project_.model->files.size(); ++i) {
            const File& file = *project_.model->files[i];
            if (!file.is_assertions || names.empty()) continue;
            const ItemList items(file, text_of(file));
            for (const Item& item : items.all_items()) {
                if (!contains_word(text_of(file).substr(item.begin, item.end - item.begin), names)) continue;
                leave_out(item);
                if (item.claim == nullptr && item.block == nullptr) whole_.insert(i);
            }
            if (!whole_.contains(i)) continue;
            for (const Item& item : items.all_items()) leave_out(item);
        }
    }

    /// False if the file contains a block that could not be parsed. Such a block may replace the instantiation, on
    /// which everything depends.
    [[nodiscard]] bool all_known(const File& file) const {
        std::size_t blocks = 0;
        const std::string_view text = text_of(file);
        constexpr std::string_view word = "csp-begin";
        for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + word.size()))
            ++blocks;
        return file.declarations.empty() && (!file.has_syntax_errors || blocks == file.csp_blocks.size());
    }

    bool leave_out_wrong() {
        for (const auto& [index, spans] : errors_) {
            const File& file = *project_.model->files[index];
            if (!all_known(file)) return false;
            const ItemList items(file, text_of(file));
            std::vector<Item> found;
            std::size_t& head = heads_.try_emplace(index, std::string::npos).first->second;
            bool apart = true;
            for (const diagnostics::Span span : spans) apart = items.touched_by(span, found, head) && apart;
            if (!items.all_items().empty()) items.add_stray_neighbours(head, found);
            // An error before all items, or in a definition that several claims use, affects the whole file.
            apart = apart && std::ranges::all_of(found, [](const Item& item) {
                        return item.claim != nullptr || item.block != nullptr;
                    });
            if (!apart) whole_.insert(index);
            for (const Item& item : apart ? found : items.all_items()) leave_out(item);
        }
        return std::ranges::none_of(blocks_,
                                    [](const CspBlock* block) { return frontend::replaces_instantiations(*block); });
    }

    void leave_out(const Item& item) {
        if (item.claim != nullptr) claims_.insert(item.claim);
        if (item.block != nullptr && blocks_.insert(item.block).second) add_declared(*item.block, declared_);
    }

    /// Excludes all blocks that directly or indirectly use a name that an excluded block may declare. Then excludes the
    /// claims about excluded blocks.
    void leave_out_dependent() {
        for (bool more = true; more;) {
            more = false;
            for (const auto& file : project_.model->files)
                for (const CspBlock& block : file->csp_blocks) {
                    if (blocks_.contains(&block) || !uses_declared(block)) continue;
                    blocks_.insert(&block);
                    add_declared(block, declared_);
                    more = true;
                }
        }
        for (const auto& file : project_.model->files)
            for (const Assertion& claim : file->assertions)
                if (blocks_.contains(claim.subject_path.process) || blocks_.contains(claim.other_path.process))
                    claims_.insert(&claim);
    }

    [[nodiscard]] bool uses_declared(const CspBlock& block) const { return contains_word(block.text, declared_); }

    /// Adds the file to the broken claims, to the other claims, or in parts to both.
    void divide_file(std::size_t index, const File& file, BrokenClaims& result) {
        if (!file.is_assertions) {
            result.sound.unit.files.push_back(index);
            result.broken.unit.files.push_back(index);
            std::string rest(text_of(file));
            if (definitions_.blank_in(file, rest)) result.sound.texts[index] = std::move(rest);
            return;
        }
        const ItemList items(file, text_of(file));
        std::string sound(text_of(file));
        std::string broken = sound;
        std::size_t left = 0;
        for (const Item& item : items.all_items()) {
            const bool out = claims_.contains(item.claim) || blocks_.contains(item.block);
            left += out ? 1 : 0;
            some_ = some_ || (!out && item.claim != nullptr);
            if (out) blank_range(sound, item.begin, item.end);
            if (!out && item.claim != nullptr) blank_range(broken, item.begin, item.end);
        }
        if (const auto head = heads_.find(index); head != heads_.end() && !items.all_items().empty())
            items.blank_strays(head->second, sound);
        const bool whole = whole_.contains(index) || (left == items.all_items().size() && errors_.contains(index));
        if (!whole) result.sound.unit.files.push_back(index);
        if (left == 0 && !errors_.contains(index)) return;
        result.broken.unit.files.push_back(index);
        if (whole) return;
        result.sound.texts[index] = std::move(sound);
        result.broken.texts[index] = std::move(broken);
    }

    const Project& project_;
    WrongDefinitions definitions_;
    std::map<std::size_t, std::vector<diagnostics::Span>> errors_;  ///< by index in Model::files
    std::map<std::size_t, std::size_t> heads_;                      ///< for files with errors: see ItemList::touched_by
    std::set<std::size_t> whole_;                                   ///< files that cannot be used even in parts
    std::set<const Assertion*> claims_;                             ///< excluded claims; the order is never used
    std::set<const CspBlock*> blocks_;                              ///< excluded blocks; the order is never used
    std::set<std::string> declared_;                                ///< names that these blocks may declare
    bool some_ = false;                                             ///< true if some claim can still be decided
};

}  // namespace

std::optional<BrokenClaims> broken_claims(const Project& project) {
    return Split(project).find();
}

bool only_claims_broken(const Project& project) {
    return !errors_in_claims(project).empty();
}

}  // namespace robochart::driver
