// SPDX-License-Identifier: Apache-2.0
// Compiles generated monitors and compares them with RuleMonitor. (rule_monitor_test.cpp compares RuleMonitor with the
// checker.) The comparison covers every history of twelve steps for some rules, and long random histories for random
// rule sets.
#include "claims/sleec/emit/monitor_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <tuple>

#include "claims/sleec/monitor/rule_monitor.hpp"
#include "claims/sleec/obligations/samples.hpp"
#include "cpp_emit/load/shared_library.hpp"
#include "tests/claims/sleec/random/naive_rules.hpp"
#include "tests/claims/sleec/support.hpp"
#include "tests/rounds.hpp"

namespace robochart::sleec {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::Read;
using testing::with_definitions;

/// Violations, as the generated monitor and `RuleMonitor` both report them. Each has the rule, the time in seconds, and
/// the event that violated the rule (`no_event` if the second ended without the demanded event).
using Found = std::set<std::tuple<std::size_t, std::int64_t, std::uint32_t>>;

/// The functions in the shared object for one file of rules. `driver` contains their definitions.
struct Functions {
    std::size_t (*size)();
    void (*start)(void*);
    void (*step)(void*, std::uint32_t event, const std::int64_t* values,
                 void (*sink)(void*, std::uint32_t, std::int64_t, std::uint32_t), void* found);
    void (*forget)(void*);
    std::uint64_t (*lost)(const void*);
};

std::string driver(std::size_t files, const std::vector<std::size_t>& measures) {
    std::string text = "#include <new>\n";
    for (std::size_t i = 0; i < files; ++i) text += "#include \"f" + std::to_string(i) + "_rules.hpp\"\n";
    text +=
        "#pragma GCC visibility push(default)\n"
        "struct Any { std::int64_t value; template <class T> operator T() const { return static_cast<T>(value); } };\n"
        "using Sink = void (*)(void*, std::uint32_t, std::int64_t, std::uint32_t);\n";
    for (std::size_t i = 0; i < files; ++i) {
        const std::string n = std::to_string(i);
        std::string values;
        for (std::size_t m = 0; m < measures[i]; ++m) values += "Any{values[" + std::to_string(m) + "]}, ";
        text += "extern \"C\" std::size_t size_" + n + "() { return sizeof(f" + n + "_rules::Monitor); }\n";
        text += "extern \"C\" void start_" + n + "(void* at) { new (at) f" + n + "_rules::Monitor; }\n";
        text +=
            "extern \"C\" void forget_" + n + "(void* at) { static_cast<f" + n + "_rules::Monitor*>(at)->forget(); }\n";
        text += "extern \"C\" std::uint64_t lost_" + n + "(const void* at) { return static_cast<const f" + n +
                "_rules::Monitor*>(at)->lost(); }\n";
        text +=
            "extern \"C\" void step_" + n +
            "(void* at, std::uint32_t event, [[maybe_unused]] const std::int64_t* values, Sink sink, void* found) {\n"
            "    const auto report = [&](const robochart::RuleViolation& each) { sink(found, each.rule, each.second, "
            "each.event); };\n"
            "    auto& monitor = *static_cast<f" +
            n +
            "_rules::Monitor*>(at);\n"
            "    if (event == robochart::rule_no_event) return monitor.second(report);\n"
            "    monitor.event(static_cast<f" +
            n + "_rules::Event>(event), {" + values + "}, report);\n}\n";
    }
    return text;
}

/// Several files of rules, as monitors in one shared object.
class Compiled {
public:
    explicit Compiled(const std::vector<const CheckedRules*>& all, const std::vector<const Read*>& read) {
        std::vector<cpp_emit::OutputFile> files;
        std::vector<std::size_t> measures;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto made =
                monitor_files(*all[i], "f" + std::to_string(i) + ".sleec", read[i]->sources, WithoutLimit::eventually);
            files.push_back(made.front());
            if (i == 0) files.push_back(made.back());
            measures.push_back(all[i]->measures.size());
        }
        files.push_back({"driver.cpp", driver(all.size(), measures)});
        cpp_emit::BuildOptions options;
        options.compiler = "g++";
        options.flags = "-std=c++20 -O1 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror";
        std::string error;
        library_ = cpp_emit::SharedLibrary::build(files, {"driver.cpp"}, options, error);
        EXPECT_NE(library_, nullptr) << error;
    }
    [[nodiscard]] explicit operator bool() const { return library_ != nullptr; }
    [[nodiscard]] Functions functions(std::size_t file) const {
        const auto symbol = [&](const std::string& name) {
            return library_->find_symbol((name + std::to_string(file)).c_str());
        };
        Functions result{};
        result.size = reinterpret_cast<decltype(result.size)>(symbol("size_"));
        result.start = reinterpret_cast<decltype(result.start)>(symbol("start_"));
        result.step = reinterpret_cast<decltype(result.step)>(symbol("step_"));
        result.forget = reinterpret_cast<decltype(result.forget)>(symbol("forget_"));
        result.lost = reinterpret_cast<decltype(result.lost)>(symbol("lost_"));
        return result;
    }

private:
    std::unique_ptr<cpp_emit::SharedLibrary> library_;
};

constexpr std::uint32_t no_event = 0xffffffffU;

void note(void* found, std::uint32_t rule, std::int64_t second, std::uint32_t event) {
    static_cast<Found*>(found)->insert({rule, second, event});
}

/// Both monitors of one file, in the same state.
class Both {
public:
    Both(const CheckedRules& rules, Functions functions)
        : functions_(functions), reference_(rules, WithoutLimit::eventually), state_((functions.size() + 15) / 16) {
        functions_.start(state_.data());
    }

    /// Takes a step in both monitors, and returns true if a rule was violated. A difference between the monitors fails
    /// the test.
    bool step(std::uint32_t event, const std::vector<std::int64_t>& values) {
        Found generated, expected;
        functions_.step(state_.data(), event, values.data(), note, &generated);
        if (event == no_event)
            reference_.end_second();
        else
            reference_.observe_event(event, {values.begin(), values.end()});
        for (const Violation& violation : reference_.take_violations())
            expected.insert({violation.rule, violation.second,
                             violation.event ? static_cast<std::uint32_t>(*violation.event) : no_event});
        EXPECT_EQ(generated, expected);
        return !expected.empty();
    }
    void forget() {
        functions_.forget(state_.data());
        reference_.drop_obligations();
    }
    [[nodiscard]] std::uint64_t lost() const { return functions_.lost(state_.data()); }

private:
    struct alignas(16) Piece {
        std::array<unsigned char, 16> bytes;
    };
    Functions functions_;
    RuleMonitor reference_;
    std::vector<Piece> state_;
};

/// Visits all histories of this many steps. A history ends at its first violation: if one duty represents several, the
/// violations of the others are reported later.
void all_histories(const Both& at, int steps, std::uint64_t& looked_at) {
    ++looked_at;
    if (steps == 0 || ::testing::Test::HasFailure()) return;
    for (const std::uint32_t event : {std::uint32_t{0}, std::uint32_t{1}, no_event}) {
        Both next = at;
        if (!next.step(event, {0, 0, 0, 0})) all_histories(next, steps - 1, looked_at);
    }
}

TEST(MonitorFile, AgreesOnAllHistoriesOfTwelveSteps) {
    const std::vector<std::string> rules{
        "when Go then Stop within 2 seconds",
        "when Go then not Stop within 2 seconds",
        "when Go then Stop within [1, 2] seconds",
        "when Go then Stop within 1 seconds otherwise not Stop within 2 seconds",
        "when Go then not Stop within 1 seconds otherwise Stop within 2 seconds",
        "when Go then Go within 3 seconds",
        "when Go then not Stop",
        "when Go then Stop within 0 seconds otherwise Go within 1 seconds",
        "when Go then Stop within 2 seconds unless Go",
        "when Go(1) then Go(_) within 2 seconds",
        "when Go(_) then not Go(1) within 2 seconds otherwise Go(_) within 1 seconds",
    };
    std::vector<std::unique_ptr<Read>> read;
    std::vector<const CheckedRules*> checked;
    std::vector<const Read*> all;
    for (const std::string& rule : rules) {
        read.push_back(std::make_unique<Read>(with_definitions("R " + rule)));
        ASSERT_TRUE(read.back()->checked_too().checked) << read.back()->report();
        checked.push_back(&*read.back()->checked);
        all.push_back(read.back().get());
    }
    const Compiled compiled(checked, all);
    ASSERT_TRUE(compiled);
    for (std::size_t i = 0; i < rules.size(); ++i) {
        SCOPED_TRACE(rules[i]);
        std::uint64_t looked_at = 0;
        all_histories(Both(*checked[i], compiled.functions(i)), 12, looked_at);
        EXPECT_GT(looked_at, 4096U) << "two of three steps break nothing";
        std::printf("%s: %llu histories\n", rules[i].c_str(), static_cast<unsigned long long>(looked_at));
    }
}

TEST(MonitorFile, AgreesOnRandomHistoriesOfRandomRules) {
    const std::size_t sets = tests::rounds(20);
    std::vector<std::unique_ptr<Read>> read;
    std::vector<const CheckedRules*> checked;
    std::vector<const Read*> all;
    for (std::size_t i = 0; i < sets; ++i) {
        std::mt19937_64 random(i + 1);
        read.push_back(std::make_unique<Read>(testing::text_of(testing::random_rules(random))));
        ASSERT_TRUE(read.back()->checked_too().checked) << read.back()->report();
        checked.push_back(&*read.back()->checked);
        all.push_back(read.back().get());
    }
    const Compiled compiled(checked, all);
    ASSERT_TRUE(compiled);
    std::uint64_t broken = 0;
    for (std::size_t i = 0; i < sets; ++i) {
        SCOPED_TRACE(testing::text_of([&] {
            std::mt19937_64 random(i + 1);
            return testing::random_rules(random);
        }()));
        Both both(*checked[i], compiled.functions(i));
        std::mt19937_64 random(i + 1000);
        const auto events = static_cast<std::uint32_t>(checked[i]->events.size());
        const std::size_t measures = checked[i]->measures.size();
        for (int step = 0; step < 3000 && !HasFailure(); ++step) {
            const auto drawn = static_cast<std::uint32_t>(random() % (2 * events));
            std::vector<std::int64_t> values(measures);
            for (std::int64_t& value : values) value = static_cast<std::int64_t>(random() % 2);
            if (!both.step(drawn < events ? drawn : no_event, values)) continue;
            ++broken;
            both.forget();
        }
        EXPECT_EQ(both.lost(), 0U);
    }
    EXPECT_GT(broken, sets);
}

std::string header_of(const std::string& text, const std::string& path = "rules.sleec") {
    Read read(text, path);
    EXPECT_TRUE(read.checked_too().checked) << read.report();
    return read.checked ? monitor_files(*read.checked, path, read.sources, WithoutLimit::eventually).front().text : "";
}

/// The rules have conditions of every kind, names that C++ reserves, defeaters in braces, and an assumption. There are
/// 300 more rules.
TEST(MonitorFile, CompilesWhateverTheRulesAreCalled) {
    std::string many;
    for (int i = 0; i < 300; ++i) many += "N" + std::to_string(i) + " when class then int within 5 seconds\n";
    const std::string text =
        "def_start event class event int event Monitor event now event std event event_ measure bool : boolean\n"
        "measure template : scale(union, struct, Event) measure template_scale : numeric measure rules : boolean\n"
        "measure Measures : numeric constant double = 3 def_end rule_start\n"
        "A when class and (bool and rules or not template >= struct) and template_scale < Measures then int within "
        "double "
        "seconds otherwise {Monitor within 2 minutes unless bool then {not now within 3 days unless rules}}\n"
        "B when int and (template_scale < template_scale or 3 > 2 or union = template) then std\n"
        "C when int then not std within 3 seconds unless Monitor unless not bool then int within 1 hours\n"
        "assume D when int then now within 2 seconds\n" +
        many + "rule_end\n";
    Read read(text);
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    const Compiled compiled({&*read.checked}, {&read});
    ASSERT_TRUE(compiled);
    Both both(*read.checked, compiled.functions(0));
    std::mt19937_64 random(7);
    for (int step = 0; step < 400 && !HasFailure(); ++step) {
        const auto drawn = static_cast<std::uint32_t>(random() % 12);
        const std::vector<std::int64_t> values{
            static_cast<std::int64_t>(random() % 2), static_cast<std::int64_t>(random() % 3),
            static_cast<std::int64_t>(random() % 5), static_cast<std::int64_t>(random() % 2),
            static_cast<std::int64_t>(random() % 5)};
        if (both.step(drawn < 6 ? drawn : no_event, values)) both.forget();
    }
}

TEST(MonitorFile, ComputesLikeTheRules) {
    const std::string text =
        "def_start event Go event Stop measure a : numeric measure b : numeric def_end rule_start\n"
        "A when Go and (({a} * {a}) > ({b} - 3)) then Stop within 0 seconds\n"
        "B when Go and (({a} + {b}) = 0) then not Stop within 0 seconds rule_end\n";
    Read read(text);
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    const Compiled compiled({&*read.checked}, {&read});
    ASSERT_TRUE(compiled);
    const std::int64_t large = std::numeric_limits<std::int64_t>::max();
    for (const std::int64_t a : {std::int64_t{0}, std::int64_t{-2}, large, -large})
        for (const std::int64_t b : {std::int64_t{0}, std::int64_t{2}, std::int64_t{7}, large, -large}) {
            SCOPED_TRACE(std::to_string(a) + " " + std::to_string(b));
            for (const bool stops : {false, true}) {
                Both both(*read.checked, compiled.functions(0));
                both.step(0, {a, b});
                if (stops) both.step(1, {a, b});
                both.step(no_event, {a, b});
            }
        }
}

// A constant may be a number that belongs to no literal of the scale.
TEST(MonitorFile, ComparesScalesWithNumbersBeyondTheirLiterals) {
    Read read(
        with_definitions("A when Go and ({load} > MAX) then Stop within 2 seconds\n"
                         "B when Go and ({load} < MAX) then Stop within 2 seconds\n"
                         "C when Go and (MAX = {load}) then not Stop within 2 seconds"));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    const Compiled compiled({&*read.checked}, {&read});
    ASSERT_TRUE(compiled);
    for (const std::int64_t load : {0, 1, 2}) {
        Both both(*read.checked, compiled.functions(0));
        both.step(0, {0, 0, 0, load});
        for (int second = 0; second < 4; ++second) both.step(no_event, {0, 0, 0, load});
    }
}

/// Duties beyond the capacity are counted, but not followed.
TEST(MonitorFile, CountsWhatItCannotFollow) {
    Read read(with_definitions("R when Go then Stop within [600, 700] seconds"));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    const Compiled compiled({&*read.checked}, {&read});
    ASSERT_TRUE(compiled);
    Both both(*read.checked, compiled.functions(0));
    for (int second = 0; second < 300; ++second) {
        both.step(0, {0, 0, 0, 0});
        both.step(no_event, {0, 0, 0, 0});
    }
    EXPECT_EQ(both.lost(), 300U - most_open);
}

TEST(MonitorFile, TextOfFilesIsEscaped) {
    const std::string text =
        header_of(with_definitions("R when Go then Stop within 2 seconds"), "a/\"\\\n#error.sleec");
    EXPECT_THAT(text, Not(HasSubstr("\n#error")));
    EXPECT_THAT(text, HasSubstr("namespace error_rules"));
    EXPECT_THAT(text, HasSubstr("\"when Go then Stop within 2 seconds\""));
    EXPECT_EQ(monitor_name("rules/care.sleec"), "care");
}

TEST(MonitorFile, RefusesChainsThatItCannotCount) {
    std::string rule = "R when Go then Stop within 1 seconds";
    for (std::size_t i = 0; i < most_demands; ++i) rule += " otherwise Stop within 1 seconds";
    Read read(with_definitions(rule));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    EXPECT_THROW((void)monitor_files(*read.checked, "r.sleec", read.sources, WithoutLimit::eventually), NotDecided);
}

}  // namespace
}  // namespace robochart::sleec
