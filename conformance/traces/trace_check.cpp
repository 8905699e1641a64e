// SPDX-License-Identifier: Apache-2.0
// See trace_check.hpp. A run is followed in the normal form of NF_c(M) with unobserved events hidden. A node of this
// normal form is the set of states in which the model may be after the logged events (Roscoe UCS 10.4.2, normalisation;
// computed on demand).
#include "conformance/traces/trace_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "conformance/model/provenance_text.hpp"
#include "conformance/model/rules.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "cpp_emit/files/trace_names.hpp"

namespace robochart::conformance {

struct TraceChecker::Form {
    Observation observation;
    bool late = false;
    ObservedSystem system;
    refine::NormalForm normal_form;

    Form(CyclicModel& model, Observation observed, std::vector<std::vector<lts::Word>> starts, bool anywhere,
         refine::Budget& budget)
        : observation(observed),
          late(anywhere),
          system(model.normal_form(), model.alphabet(), std::move(observed), std::move(starts)),
          normal_form(system, budget) {}
};

TraceChecker::TraceChecker(CyclicModel& model, std::vector<std::string> component, const refine::Limits& limits,
                           const diagnostics::SourceManager& sources, durations::Unit unit)
    : TraceChecker(model, std::move(component), limits, sources, unit, ExactNumbers{}) {}

TraceChecker::TraceChecker(CyclicModel& model, std::vector<std::string> component, const refine::Limits& limits,
                           const diagnostics::SourceManager& sources, durations::Unit unit, const ExactNumbers& exact)
    : model_(&model),
      component_(std::move(component)),
      limits_(limits),
      unit_(unit),
      sources_(&sources),
      budget_(limits),
      alphabet_(model, exact.codes),
      rounding_(exact.rounding) {}

TraceChecker::~TraceChecker() = default;

TraceChecker::Form* TraceChecker::form_for(const Observation& observation, bool late) {
    for (const auto& known : forms_)
        if (known->late == late && known->observation == observation) return known.get();
    if (late && !starts_) starts_ = find_starts();
    if (late && starts_->empty()) return nullptr;
    forms_.push_back(std::make_unique<Form>(*model_, observation,
                                            late ? *starts_ : std::vector<std::vector<lts::Word>>{}, late, budget_));
    return forms_.back().get();
}

/// If results are not clipped, there may be infinitely many states, and some may have values outside the carriers.
std::vector<std::vector<lts::Word>> TraceChecker::find_starts() {
    constexpr std::size_t most_unclipped = 100'000;
    const bool unclipped = model_->instantiation().unbounded;
    try {
        return cycle_starts(model_->normal_form(), limits_,
                            unclipped ? most_unclipped : std::numeric_limits<std::size_t>::max());
    } catch (const cspm::EvaluationError& failed) {
        if (!runs::leaves_carriers(failed.what())) throw;
        return {};
    }
}

/// Reads and checks one log.
class TraceChecker::LogRun {
public:
    LogRun(TraceChecker& checker, std::istream& in, const std::vector<std::string>& constants,
           const std::function<void(const RunReport&)>& tell)
        : checker_(checker),
          model_(*checker.model_),
          constants_(constants),
          tell_(tell),
          lines_(in),
          reads_(model_.interface().inputs.size()) {
        observation_.inputs.assign(model_.interface().inputs.size(), true);
        observation_.outputs.assign(model_.interface().outputs.size(), true);
    }

    LogReport check_log() {
        try {
            read_header();
            while (more_) {
                check_line();
                next_line();
            }
            end_run();
        } catch (const TraceFault& fault) {
            report_.fault = LogFault{fault, lines_.line_number(), std::string(lines_.line_text())};
        }
        return std::move(report_);
    }

private:
    /// What happens after a word: the run continues, or its remaining words are skipped.
    enum class Next { go_on, stop };

    void next_line() { more_ = lines_.read_line(); }

    // ------------------------------------------------------------ header

    void read_header() {
        next_line();
        while (more_ && line_is_blank()) next_line();
        expect_version();
        for (next_line(); more_; next_line()) {
            if (line_is_blank()) continue;
            if (tokens_.front().text == "run") break;
            if (!read_header_line(tokens_, report_.header, lines_.line_number()))
                fault_here("`run NAME` or a line of the header");
            if (tokens_.front().text == "unobserved") read_unobserved();
        }
        check_header();
    }

    [[nodiscard]] bool line_is_blank() {
        split_line(lines_.line_text(), tokens_);
        return tokens_.empty();
    }

    void expect_version() {
        if (!more_) throw TraceFault{&rules::log_syntax, {"`robochart-trace 1`", "an empty log"}};
        const std::string version = fmt::format("{}", cpp_emit::trace_version);
        if (tokens_.size() == 2 && tokens_[0].text == "robochart-trace" && tokens_[1].text == version) return;
        fault_here("`robochart-trace 1` in the first line");
    }

    [[noreturn]] void fault_here(const char* expected) const {
        const TraceToken& at = tokens_.front();
        throw TraceFault{&rules::log_syntax,
                         {expected, fmt::format("`{}`", at.text)},
                         at.column,
                         static_cast<std::uint32_t>(at.text.size())};
    }

    void read_unobserved() {
        for (std::size_t i = 1; i < tokens_.size(); ++i) {
            const LoggedEvent kind = checker_.alphabet_.parse_kind(tokens_[i]);
            if (kind.kind == LoggedEvent::Kind::read)
                observation_.inputs[kind.index] = false;
            else
                observation_.outputs[kind.index] = false;
        }
    }

    void check_header() const {
        const TraceHeader& header = report_.header;
        const auto& names = checker_.component_;
        if (header.component.empty()) throw TraceFault{&rules::log_syntax, {"`component NAME` in the header", "none"}};
        if (std::ranges::find(names, header.component) == names.end())
            throw TraceFault{&rules::log_of_other, {header.component, names.front()}};
        if (header.cycle != model_.cycle_length())
            throw TraceFault{&rules::log_of_other,
                             {fmt::format("cycles of {} time units", header.cycle),
                              fmt::format("cycles of {}", model_.cycle_length())}};
        compare_units(header, checker_.unit_);
        if (header.constants != constants_)
            throw TraceFault{&rules::log_of_other, {with_constants(header.constants), with_constants(constants_)}};
    }

    [[nodiscard]] static std::string with_constants(const std::vector<std::string>& constants) {
        return constants.empty() ? "a model without chosen constants"
                                 : fmt::format("a model with {}", fmt::join(constants, ", "));
    }

    // ------------------------------------------------------------ runs

    void check_line() {
        if (line_is_blank()) return;
        const std::string_view first = tokens_.front().text;
        if (first == "run") return begin_run();
        if (!run_) fault_here("`run NAME`");
        if (first == "late" || first == "lost") return forget_state(first);
        check_words();
    }

    void begin_run() {
        end_run();
        run_.emplace();
        run_->line = lines_.line_number();
        if (tokens_.size() > 1) {
            const char* const end = tokens_.back().text.data() + tokens_.back().text.size();
            run_->name.assign(tokens_[1].text.data(), end);
        }
        ++report_.runs;
        form_ = checker_.form_for(observation_, false);
        before_.clear();
        done_ = ended_ = false;
        begin_cycle();
        find_first_node("run");
    }

    void find_first_node(std::string_view word) {
        unless_a_value_leaves(word, [&] { node_ = cycle_node_ = form_->normal_form.initial(); });
    }

    /// Forgets the state of the run, because the log starts late or cycles were lost.
    void forget_state(std::string_view word) {
        if (tokens_.size() > 1 || (word == "late" && run_->cycles > 0))
            fault_here("`late` alone before the first cycle, or `lost`");
        if (!clean_) fault_here("the end of the cycle, `tock`");
        if (done_) return;
        form_ = checker_.form_for(observation_, true);
        if (form_ == nullptr) return lose_state(word);
        find_first_node(word);
    }

    void lose_state(std::string_view word) {
        leave_undecided(
            word, "the log does not show the state of the model here, and the model has too many states to try all");
    }

    void leave_undecided(std::string_view word, std::string reason) {
        record_place();
        run_->verdict = RunVerdict::inconclusive;
        run_->what = word;
        run_->reason = std::move(reason);
        done_ = true;
    }

    /// Performs a step of the model. If it fails because a value leaves its carrier, the run is undecided.
    template <class Step>
    void unless_a_value_leaves(std::string_view word, const Step& step) {
        try {
            step();
        } catch (const cspm::EvaluationError& failed) {
            if (!runs::leaves_carriers(failed.what())) throw;
            leave_undecided(word, runs::placed_failure(failed, model_.system(), *checker_.sources_));
        }
    }

    void end_run() {
        if (!run_) return;
        if (run_->verdict == RunVerdict::accepted) ++report_.accepted;
        if (run_->verdict == RunVerdict::rejected) ++report_.rejected;
        if (run_->verdict == RunVerdict::inconclusive) ++report_.inconclusive;
        report_.cycles += run_->cycles;
        report_.replaced += run_->replaced;
        if (run_->verdict != RunVerdict::accepted) tell_(*run_);
        run_.reset();
    }

    void begin_cycle() {
        std::ranges::fill(reads_, process::tau);
        cycle_node_ = node_;
        clean_ = true;
        acted_ = false;
        tocks_ = 0;
        so_far_.clear();
    }

    void check_words() {
        const std::string_view whole = lines_.line_text();
        for (const TraceToken& token : tokens_) {
            if (token.text == "run" || token.text == "late" || token.text == "lost")
                fault_here("one event after the other");
            // Words after a verdict are still parsed, because syntax errors are always reported.
            unless_a_value_leaves(token.text, [&] { done_ = check_word(token) == Next::stop || done_; });
        }
        if (before_.size() == 3) before_.erase(before_.begin());
        before_.emplace_back(whole);
    }

    Next check_word(const TraceToken& token) {
        if (token.text == "tock") return done_ ? Next::go_on : check_tock();
        if (token.text == "terminate") return done_ ? Next::go_on : check_termination();
        const LoggedEvent& event = checker_.alphabet_.read_event(token);
        for (const LoggedValue& value : event.values) collect_numbers(value.whole);
        const bool read = event.kind == LoggedEvent::Kind::read;
        const bool observed = read ? observation_.inputs[event.index] : observation_.outputs[event.index];
        if (!observed)
            throw TraceFault{
                &rules::log_syntax,
                {"only events that the header does not declare as unobserved", fmt::format("`{}`", token.text)},
                token.column,
                static_cast<std::uint32_t>(token.text.size())};
        if (done_) return Next::go_on;
        if (ended_) return reject_event(std::string(token.text));
        clean_ = false;
        const auto meant = in_carrier(event, token);
        if (!meant) return Next::stop;
        const Next next = read ? take_read(event.index, *meant, token) : take_write(*meant, event.rounded, token);
        so_far_.emplace_back(token.text);
        return next;
    }

    /// Adds the numbers that the component compares with each other to the report.
    void collect_numbers(const LoggedPart& part) {
        const bool sequence = part.kind == ir::TypeKind::sequence;
        if (sequence && !model_.boundary().numbers.sequences.types.empty()) return;  // they have classes
        for (const LoggedPart& inner : part.parts) collect_numbers(inner);
        if (model_.boundary().numbers.uses.use_of(part.kind) != NumberUse::related) return;
        std::set<double>& numbers = report_.numbers[part.kind];
        if (numbers.size() > most_logged_numbers) return;
        const double unit = part.kind == ir::TypeKind::real ? static_cast<double>(model_.interface().scale) : 1;
        numbers.insert(part.outside.empty() ? static_cast<double>(part.number) / unit : part.value);
    }

    /// Returns the event of NF_c(M) for a logged event. If the component only passes on a value outside the finite
    /// instantiation, a value inside replaces it. If any other value is outside, the run is undecided.
    std::optional<process::Event> in_carrier(const LoggedEvent& event, const TraceToken& token) {
        if (event.event != process::tau) return event.event;
        for (const LoggedValue& value : event.values) {
            if (value.number) continue;
            if (!value.replaceable && event.rounded != process::tau) return event.rounded;
            if (!value.replaceable) {
                report_undecided(token, value);
                return std::nullopt;
            }
            ++run_->replaced;
        }
        return checker_.alphabet_.replacement_event(event, report_.runs);
    }

    void report_undecided(const TraceToken& token, const LoggedValue& value) {
        run_->related_numbers = has_related(value.whole) && are_related(value.whole);
        report_.related_numbers = report_.related_numbers || run_->related_numbers;
        leave_undecided(token.text,
                        fmt::format("{} is outside the finite instantiation of the model, which {}", value.text,
                                    run_->related_numbers ? "compares such values with each other"
                                                          : "calculates with such values"));
    }

    /// Whether the component compares some number of the value that is outside the carriers with other numbers.
    [[nodiscard]] bool has_related(const LoggedPart& part) const {
        return (!part.outside.empty() && model_.boundary().numbers.uses.use_of(part.kind) == NumberUse::related) ||
               std::ranges::any_of(part.parts, [this](const LoggedPart& inner) { return has_related(inner); });
    }

    /// Whether the component compares all numbers of the value that are outside the carriers with each other, or only
    /// passes them on.
    [[nodiscard]] bool are_related(const LoggedPart& part) const {
        const NumberUse use = model_.boundary().numbers.uses.use_of(part.kind);
        return (part.outside.empty() || use != NumberUse::computed) &&
               std::ranges::all_of(part.parts, [this](const LoggedPart& inner) { return are_related(inner); });
    }

    Next take_read(std::uint32_t index, process::Event event, const TraceToken& token) {
        if (acted_ || tocks_ > 0 || reads_[index] != process::tau) return reject_event(std::string(token.text));
        reads_[index] = event;
        return Next::go_on;
    }

    Next take_write(process::Event event, process::Event rounded, const TraceToken& token) {
        if (!finish_reads()) return Next::stop;
        const bool can = step_model(event) || (rounded != process::tau && step_model(rounded));
        return can ? Next::go_on : reject_event(std::string(token.text));
    }

    /// Reads all registers, in the order of the interface, before anything else happens (A3).
    bool finish_reads() {
        if (acted_) return true;
        acted_ = true;
        for (std::uint32_t i = 0; i < reads_.size(); ++i) {
            if (!observation_.inputs[i]) continue;
            const process::Event event = reads_[i] == process::tau ? model_.alphabet().read_event(i, 0) : reads_[i];
            if (step_model(event)) continue;
            reject_event("a further cycle");
            return false;
        }
        return true;
    }

    bool step_model(process::Event event) {
        const auto next = form_->normal_form.node_after(node_, event);
        if (next) node_ = *next;
        return next.has_value();
    }

    Next check_tock() {
        if (ended_) return reject_event("a further cycle");
        if (!finish_reads()) return Next::stop;
        if (!step_model(model_.alphabet().tock())) return reject_event("the end of the cycle");
        if (++tocks_ < model_.cycle_length()) return Next::go_on;
        ++run_->cycles;
        begin_cycle();
        return Next::go_on;
    }

    Next check_termination() {
        if (!finish_reads()) return Next::stop;
        if (!step_model(process::tick)) return reject_event("termination");
        ended_ = true;
        return Next::go_on;
    }

    // ------------------------------------------------------------ reports

    void record_place() {
        run_->at_line = lines_.line_number();
        run_->cycle = run_->cycles + 1;
        run_->cycle_so_far = so_far_;
        run_->before = before_;
    }

    Next reject_event(std::string what) {
        record_place();
        run_->what = std::move(what);
        if (!checker_.rounding_.empty()) {
            run_->verdict = RunVerdict::inconclusive;
            run_->reason = fmt::format("the model excludes this, but code with rounded numbers may decide {} otherwise",
                                       checker_.rounding_);
            return Next::stop;
        }
        run_->verdict = RunVerdict::rejected;
        const Alphabet& alphabet = model_.alphabet();
        const std::size_t mark = run_->what.find_first_of("?!");
        const bool read_again = mark != std::string::npos && run_->what[mark] == '?' && !ended_;
        if (read_again) run_->allowed.emplace_back("every input is read once, before anything is written");
        for (const process::Event event : form_->normal_form.initials(node_)) {
            if (read_again) break;
            const CycleRole role = alphabet.cycle_role(event);
            if (role.kind == CycleRole::Kind::read) continue;
            run_->allowed.push_back(describe_with_place(event, alphabet, model_.provenance(), *checker_.sources_));
        }
        if (ended_) run_->allowed.emplace_back("nothing: it has terminated");
        tell_elements();
        return Next::stop;
    }

    /// Reports the elements of the model at the cycle's beginning. They belong to the stable states, or to all states
    /// if none is stable.
    void tell_elements() {
        const std::vector<lts::StateView> states = form_->normal_form.states(cycle_node_);
        for (const bool still : {true, false}) {
            for (const lts::StateView state : states)
                if (!still || form_->system.is_stable(state)) add_elements(form_->system.describe_model(state));
            if (!run_->elements.empty()) return;
        }
    }

    void add_elements(const std::string& state) {
        constexpr std::size_t most = 8;
        for (std::string& element : elements_of_state(state, model_.provenance(), *checker_.sources_)) {
            std::vector<std::string>& all = run_->elements;
            const bool known = std::ranges::find(all, element) != all.end();
            if (!known && all.size() < most) all.push_back(std::move(element));
        }
    }

    TraceChecker& checker_;
    CyclicModel& model_;
    const std::vector<std::string>& constants_;
    const std::function<void(const RunReport&)>& tell_;
    LineReader lines_;
    std::vector<TraceToken> tokens_;
    LogReport report_;
    Observation observation_;
    bool more_ = true;

    std::optional<RunReport> run_;
    Form* form_ = nullptr;
    refine::NormalForm::Node node_ = 0;
    refine::NormalForm::Node cycle_node_ = 0;  ///< node at the cycle's beginning
    std::vector<process::Event> reads_;        ///< readings of this cycle; tau: absent
    std::vector<std::string> so_far_;          ///< words of this cycle
    std::vector<std::string> before_;          ///< the preceding lines
    bool clean_ = true;                        ///< true if no word of this cycle has been read
    bool acted_ = false;                       ///< true if the reads are done
    std::uint32_t tocks_ = 0;
    bool ended_ = false;  ///< true if the run has terminated
    bool done_ = false;   ///< true if the verdict is known; the rest of the run is only parsed
};

LogReport TraceChecker::check_log(std::istream& in, const std::vector<std::string>& constants,
                                  const std::function<void(const RunReport&)>& tell) {
    return LogRun(*this, in, constants, tell).check_log();
}

}  // namespace robochart::conformance
