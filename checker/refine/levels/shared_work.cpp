#include "checker/refine/levels/shared_work.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>

#include "diagnostics/budget.hpp"

namespace robochart::refine {
namespace {

std::string words_of(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        return "there is no more memory";
    } catch (const std::exception& known) {
        return known.what();
    } catch (...) {
        return "an unknown error";
    }
}

Words packed(const std::string& text) {
    Words words((text.size() + sizeof(lts::Word)) / sizeof(lts::Word), 0);  // ends with a null byte
    std::memcpy(words.data(), text.data(), text.size());
    return words;
}

std::string unpacked(const Words& words) {
    std::string text(words.size() * sizeof(lts::Word), '\0');
    std::memcpy(text.data(), words.data(), text.size());
    text.resize(std::min(text.find('\0'), text.size()));
    return text;
}

}  // namespace

void SharedWork::attempt(const std::function<void()>& part) {
    if (failure_) return;
    try {
        part();
    } catch (const diagnostics::LimitReached&) {
        failure_ = std::current_exception();
        limit_ = true;
    } catch (const std::bad_alloc&) {
        failure_ = std::current_exception();
        limit_ = true;
    } catch (...) {
        failure_ = std::current_exception();
    }
}

void SharedWork::sum(std::span<std::uint64_t> values) {
    values_.assign(values.begin(), values.end());
    values_.push_back(failure_ && limit_ ? 1 : 0);
    values_.push_back(failure_ && !limit_ ? 1 : 0);
    exchange_.sum(values_);
    const std::uint64_t errors = values_.back();
    const std::uint64_t limits = values_[values_.size() - 2];
    if (errors > 0 || limits > 0) leave(errors == 0);
    std::copy_n(values_.begin(), values.size(), values.begin());
}

void SharedWork::leave(bool by_limit) {
    const bool shown = failure_ && limit_ == by_limit;
    const std::vector<Words> texts = exchange_.gather(shown ? packed(words_of(failure_)) : Words{});
    exchange_.leave_together();
    if (shown) std::rethrow_exception(failure_);
    const auto first = std::find_if(texts.begin(), texts.end(), [](const Words& text) { return !text.empty(); });
    const std::string why = first == texts.end() ? "another rank has ended" : unpacked(*first);
    if (by_limit) throw diagnostics::LimitReached(why);
    throw RankFailed("rank " + std::to_string(first - texts.begin()) + ": " + why);
}

}  // namespace robochart::refine
