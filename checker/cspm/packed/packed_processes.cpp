// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/packed/packed_processes.hpp"

#include <algorithm>

#include "checker/cspm/packed/not_packed.hpp"
#include "checker/cspm/syntax/lookup.hpp"
#include "checker/process/term_system.hpp"

namespace robochart::cspm {

namespace {

/// Returns the object of the assertion that belongs to the script. The script finds the scope of an assertion by the
/// address of this object.
DeclPtr kept_assertion(const Script& script, const Decl& assertion) {
    for (const DeclPtr& decl : assertions_in(script.decls))
        if (decl.get() == &assertion) return decl;
    return std::make_shared<const Decl>(assertion);
}

}  // namespace

/// Rejects compressions: each state of a compressed operand would require another exploration of the operand.
class PackedProcesses::NoCompressor final : public process::Compressor {
public:
    std::optional<process::Machine> explore(process::TermId /*operand*/, process::Compression /*kind*/,
                                            diagnostics::Pollable& /*budget*/) override {
        throw NotPacked{"a compression is a part of the process"};
    }
    process::Machine compress(const process::Machine& /*explored*/, process::Compression /*kind*/,
                              diagnostics::Pollable& /*budget*/) override {
        throw NotPacked{"a compression is a part of the process"};
    }
};

/// Keeps the event table of the search equal to that of the script. New events are copied to the script by the
/// constructor and to the search by the destructor.
class PackedProcesses::SameEvents {
public:
    SameEvents(process::EventTable& search, process::EventTable& script) : search_(search), script_(script) {
        copy(search_, script_);
    }
    ~SameEvents() { copy(script_, search_); }
    SameEvents(const SameEvents&) = delete;
    SameEvents& operator=(const SameEvents&) = delete;

private:
    static void copy(const process::EventTable& from, process::EventTable& to) {
        for (std::size_t event = to.size(); event < from.size(); ++event)
            to.intern(from.name(static_cast<process::Event>(event)));
    }

    process::EventTable& search_;
    process::EventTable& script_;
};

PackedProcesses::PackedProcesses(Script script, process::EventTable& events, const Settings& settings)
    : script_(std::move(script)),
      events_(events),
      settings_(settings),
      no_compressor_(std::make_unique<NoCompressor>()) {
    load_script();
}

PackedProcesses::~PackedProcesses() = default;

std::size_t PackedProcesses::add(const ExprPtr& expr, const Decl& assertion) {
    load_if_needed();
    asked_.push_back({expr, kept_assertion(script_, assertion)});
    sides_.push_back(loaded_->compile_side(expr, assertion));
    make_codec();
    return asked_.size() - 1;
}

// Loads the script and compiles the sides in the order of `asked_`, so that definitions always have the same numbers.
void PackedProcesses::load_script() {
    direct_.reset();
    codec_.reset();
    loaded_ = std::make_unique<LoadedScript>(script_, no_compressor_.get(), nullptr, settings_.whole_states);
    set_budget(*budget_);
    sides_.clear();
    for (const Asked& side : asked_) sides_.push_back(loaded_->compile_side(side.expr, *side.assertion));
    parts_.set_terms(loaded_->terms);
    make_codec();
    kept_at_start_ = 0;
    ++loads_;
}

/// Creates the codec. It contains only the definitions that exist at this time. So this function must be called after
/// each compilation.
void PackedProcesses::make_codec() {
    const Evaluator::Parts parts = loaded_->evaluator.parts();
    codec_ = std::make_unique<TermCodec>(parts.program, parts.store, parts.terms, parts.processes, parts_);
    direct_ = std::make_unique<DirectSteps>(loaded_->evaluator, *codec_, parts_);
}

std::size_t PackedProcesses::kept_object_count() const {
    return loaded_->store.size() + loaded_->terms.size();
}

/// Drops all evaluated data if they are much more than the data after the first state. The latter are mainly the
/// constants of the script, and every reload evaluates these again.
void PackedProcesses::forget_if_large() {
    const std::size_t now = kept_object_count();
    if (kept_at_start_ == 0) kept_at_start_ = now;
    if (now < 2 * kept_at_start_ + settings_.most_kept && !settings_.forget_each_state) return;
    direct_.reset();
    codec_.reset();
    loaded_.reset();
}

/// Loads the script if it was dropped (forget_if_large), or if a limit stopped the previous attempt.
void PackedProcesses::load_if_needed() {
    if (direct_ == nullptr) load_script();
}

Bytes PackedProcesses::initial(std::size_t side) {
    load_if_needed();
    const SameEvents same(events_, loaded_->events);
    Bytes bytes;
    codec_->write(loaded_->term_of(sides_.at(side)), bytes);
    refuse_sets_of_processes();
    return bytes;
}

// Examines the first states in breadth-first order, as a search does. Returns true if their steps can be computed
// without terms.
bool PackedProcesses::is_direct(std::size_t side) {
    constexpr std::size_t enough = 64;
    std::vector<Bytes> rows{initial(side)};
    const SameEvents same(events_, loaded_->events);
    PackedSteps found;
    for (std::size_t i = 0; i < rows.size() && i < enough; ++i) {
        if (!direct_->find(rows[i], found)) return false;
        for (const PackedSteps::Step& step : found.steps) {
            const auto target = found.target(step);
            rows.emplace_back(target.begin(), target.end());
            if (std::find(rows.begin(), rows.end() - 1, rows.back()) != rows.end() - 1) rows.pop_back();
            if (rows.size() > enough) break;
        }
    }
    return true;
}

void PackedProcesses::steps(std::span<const std::uint8_t> state, Span span, PackedSteps& out) {
    if (direct_ != nullptr) forget_if_large();
    load_if_needed();
    const SameEvents same(events_, loaded_->events);
    if (!settings_.terms_alone && direct_->find(state, out))
        ++direct_answers_;
    else
        loaded_->evaluated_at(span, [&] { steps_of_term(state, out); });
    refuse_sets_of_processes();
}

void PackedProcesses::refuse_sets_of_processes() const {
    if (loaded_->store.orders_processes()) throw NotPacked{"a set has processes as elements"};
}

void PackedProcesses::steps_of_term(std::span<const std::uint8_t> state, PackedSteps& out) {
    out.clear();
    ByteReader in(state);
    for (const process::Transition& step : loaded_->semantics.successors(codec_->read(in))) {
        const std::size_t begin = out.bytes.size();
        codec_->write(step.target, out.bytes);
        out.add(step.event, step.revealed, begin);
    }
}

std::vector<Bytes> PackedProcesses::choice_operands(std::span<const std::uint8_t> state, Span span) {
    load_if_needed();
    const SameEvents same(events_, loaded_->events);
    ByteReader in(state);
    std::vector<Bytes> operands;
    loaded_->evaluated_at(span, [&] {
        for (const process::TermId operand : process::choice_operands(loaded_->terms, codec_->read(in)))
            codec_->write(operand, operands.emplace_back());
    });
    refuse_sets_of_processes();
    return operands;
}

std::string PackedProcesses::describe(std::span<const std::uint8_t> state) {
    load_if_needed();
    const SameEvents same(events_, loaded_->events);
    ByteReader in(state);
    return process::describe(loaded_->terms, codec_->read(in));
}

void PackedProcesses::set_budget(diagnostics::Pollable& budget) {
    budget_ = &budget;
    if (loaded_ == nullptr) return;
    loaded_->evaluator.set_budget(budget);
    loaded_->semantics.set_budget(budget);
}

}  // namespace robochart::cspm
