// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/shared_work.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <new>
#include <stdexcept>

#include "base/diagnostics/budget.hpp"
#include "checker/storage/storage_error.hpp"

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

Words pack_text(const std::string& text) {
    Words words((text.size() + sizeof(lts::Word)) / sizeof(lts::Word), 0);  // terminated by a null byte
    std::memcpy(words.data(), text.data(), text.size());
    return words;
}

std::string unpack_text(const Words& words) {
    std::string text(words.size() * sizeof(lts::Word), '\0');
    std::memcpy(text.data(), words.data(), text.size());
    text.resize(std::min(text.find('\0'), text.size()));
    return text;
}

}  // namespace

void SharedWork::execute_part(const std::function<void()>& part) {
    if (failure_) return;
    try {
        part();
    } catch (const diagnostics::LimitReached&) {
        record_failure(Kind::limit);
    } catch (const std::bad_alloc&) {
        record_failure(Kind::limit);
    } catch (const storage::BadFile&) {
        record_failure(Kind::bad_file);
    } catch (...) {
        record_failure(Kind::error);
    }
}

void SharedWork::record_failure(Kind kind) {
    assert(!failure_ && kind != Kind::none);
    failure_ = std::current_exception();
    kind_ = kind;
}

void SharedWork::sum(std::span<std::uint64_t> values) {
    values_.assign(values.begin(), values.end());
    constexpr std::array kinds{Kind::error, Kind::bad_file, Kind::limit};
    for (const Kind kind : kinds) values_.push_back(kind_ == kind ? 1 : 0);
    exchange_.sum(values_);
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (values_[values.size() + i] > 0) leave_with_failure(kinds[i]);
    std::copy_n(values_.begin(), values.size(), values.begin());
}

void SharedWork::leave_with_failure(Kind worst) {
    assert(kind_ >= worst);
    const bool shown = kind_ == worst;
    const std::vector<Words> texts = exchange_.gather(shown ? pack_text(words_of(failure_)) : Words{});
    exchange_.leave_together();
    if (shown) std::rethrow_exception(failure_);
    const auto first = std::ranges::find_if(texts, [](const Words& text) { return !text.empty(); });
    const std::string why = first == texts.end() ? "another rank has ended" : unpack_text(*first);
    if (worst == Kind::limit) throw diagnostics::LimitReached(why);
    if (worst == Kind::bad_file) throw storage::BadFile(why);
    throw RankFailed("rank " + std::to_string(first - texts.begin()) + ": " + why);
}

void run_together(Exchange& exchange, const std::function<void()>& part) {
    SharedWork work(exchange);
    work.execute_part(part);
    work.sum({});
}

}  // namespace robochart::refine
