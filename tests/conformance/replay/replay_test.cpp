// SPDX-License-Identifier: Apache-2.0
// Tests certificates of conformance and robochart-replay: right code, mutants of the code, tables with wrong rows,
// damaged files, and objects that crash or do not fit. For mutants, the explorer of `conform` is the oracle.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include "base/cache/sha256.hpp"
#include "base/diagnostics/files.hpp"
#include "checker/certify/certificate.hpp"
#include "conformance/check/conform.hpp"
#include "cpp_emit/load/shared_library.hpp"
#include "tests/conformance/batches/code_equality.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/contents.hpp"

namespace robochart::conformance {
namespace {

using cpp_emit::Fault;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using tests::read_contents;

struct Ran {
    int exit = -1;  ///< 128 + n if killed by signal n
    std::string out;
};

Ran run_command(const std::string& command) {
    Ran ran;
    FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    std::array<char, 4096> buffer{};
    for (std::size_t size = 0; (size = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        ran.out.append(buffer.data(), size);
    const int status = pclose(pipe);
    ran.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ran;
}

Ran replay(const std::string& certificate, const std::string& object = "", const std::string& more = "") {
    return run_command(
        fmt::format("{} {} {} {}", ROBOCHART_REPLAY, more, object.empty() ? "" : "--object " + object, certificate));
}

Options certifying_options() {
    Options options;
    options.flags = "-std=c++17 -O0 -w";
    options.certified = "the code conforms";
    return options;
}

/// A certificate in a temporary folder.
class Certified {
public:
    Certified(test::Model& model, const ir::ComponentRef& component, const Options& options = certifying_options())
        : result_(conform(model.system, model.instantiation, component, options, model.sources, model.diagnostics)) {
        EXPECT_EQ(result_.outcome, Outcome::conforms) << result_.reason;
        EXPECT_NE(result_.certificate, nullptr) << result_.certificate_failure;
        if (result_.certificate == nullptr) return;
        EXPECT_EQ(certify::write_certificate(folder_.path(), "c", *result_.certificate, nullptr), "");
    }
    [[nodiscard]] std::string path(const std::string& file = "") const {
        return folder_.in(file.empty() ? "c" : "c/" + file);
    }
    [[nodiscard]] const Result& result() const { return result_; }
    [[nodiscard]] std::string text(const std::string& file) const { return read_contents(path(file)); }
    /// Replaces a file, without changing the digests.
    void damage(const std::string& file, const std::string& text) const {
        std::ofstream(path(file), std::ios::binary) << text;
    }
    /// Replaces the table, with the right digests.
    void forge_table(const std::string& table) const {
        const std::string old_digest = diagnostics::sha256(text("implementation.txt"));
        const std::string digest = diagnostics::sha256(table);
        damage("implementation.txt", table);
        for (const char* file : {"code.txt", "claim.txt"}) {
            std::string lines = text(file);
            lines.replace(lines.find(old_digest), digest.size(), digest);
            forge(file, lines);
        }
    }
    /// Replaces code.txt or claim.txt, with the right digest at its end.
    void forge(const std::string& file, std::string lines) const {
        const std::size_t end = lines.rfind("end-sha256: ");
        if (end != std::string::npos) lines.resize(end);
        damage(file, lines + fmt::format("end-sha256: {}\n", diagnostics::sha256(lines)));
    }

private:
    tests::TemporaryFolder folder_;
    Result result_;
};

/// Compiles sources into an object and returns its path.
std::string compile(const tests::TemporaryFolder& folder, const std::vector<cpp_emit::OutputFile>& files,
                    const std::string& words, const std::string& name) {
    for (const cpp_emit::OutputFile& file : files) folder.write(file.path, file.text);
    std::string object = folder.in(name);
    const Ran ran = run_command(
        fmt::format("cd {} && c++ -std=c++17 -O0 -w -shared -fPIC -I . -o {} {}", folder.path(), object, words));
    EXPECT_EQ(ran.exit, 0) << ran.out;
    return object;
}

std::string sources_of(const cpp_emit::Emission& code) {
    std::string words = code.shim;
    for (const std::string& source : code.sources) words += " " + source;
    return words;
}

/// Code with a fault, compiled.
std::string compile_mutant(const tests::TemporaryFolder& folder, test::Model& model, const ir::ComponentRef& component,
                           Fault fault, std::uint32_t site) {
    cpp_emit::Options options;
    options.fault = fault;
    options.fault_site = site;
    const cpp_emit::Emission code =
        cpp_emit::emit(model.system, model.instantiation, component, options, model.diagnostics);
    return compile(folder, code.files, sources_of(code), "mutant.so");
}

void expect_certified(const Certified& certified) {
    if (std::string(ROBOCHART_CERTIFY).empty()) return;
    const Ran ran = run_command(fmt::format("{} --answer {}", ROBOCHART_CERTIFY, certified.path()));
    EXPECT_EQ(ran.exit, 0) << ran.out;
    EXPECT_THAT(ran.out, StartsWith("certified "));
}

/// docs/conformance.md, "Measurements": the module has 5 states and 20 cycles. The build command is in the certificate.
TEST(Replay, RunsEachRowOfTheTableOnce) {
    test::Model model("corpus/aggregation");
    const Certified certified(model, model.first_module());
    expect_certified(certified);
    const Ran ran = replay(certified.path());
    EXPECT_EQ(ran.exit, 0) << ran.out;
    EXPECT_EQ(ran.out, "REPLAYED 20 rows: the code of Aggregation does what the table states\n");
}

TEST(Replay, ConformingModelsAreReplayed) {
    const std::string models = "tests/conformance/models/";
    for (const char* const module : {"nested", "team", "wires"}) {
        test::Model model(models + module);
        const Certified certified(model, model.first_module());
        expect_certified(certified);
        const Ran ran = replay(certified.path());
        EXPECT_EQ(ran.exit, 0) << ran.out;
        EXPECT_THAT(ran.out, StartsWith(fmt::format("REPLAYED {} rows", certified.result().code_cycles))) << module;
    }
}

/// The code of a probabilistic junction asks its platform for a choice. The table then has a choice between results.
TEST(Replay, ChoicesHaveAllResults) {
    test::Model model("tests/conformance/models/choices");
    const ir::ComponentRef machine = model.machine_named("Choices");
    const Certified certified(model, machine);
    expect_certified(certified);
    const Ran ran = replay(certified.path());
    EXPECT_EQ(ran.exit, 0) << ran.out;
    EXPECT_THAT(certified.text("implementation.txt"), HasSubstr("\n0 ")) << "the table has no choice";
    const tests::TemporaryFolder folder;
    const Ran other = replay(certified.path(), compile_mutant(folder, model, machine, Fault::wrong_output, 0));
    EXPECT_THAT(other.out, StartsWith("DIFFERS row "));
}

constexpr const char* lamp = R"(package Lamp
interface Button { event pressed }
interface Light { lit(bright : boolean) }
stm Switch {
	cycleDef cycle == 1
	clock since_press
	input context { uses Button }
	output context { requires Light }
	initial i
	state Off { entry $lit(false) }
	state On { entry $lit(true) }
	transition t0 { from i to Off }
	transition t1 { from Off to On exec condition $pressed action #since_press }
	transition t2 { from Off to Off exec condition not $pressed }
	transition t3 { from On to Off exec condition since(since_press) >= 3 * cycle }
	transition t4 { from On to On exec condition since(since_press) < 3 * cycle }
}
)";

TEST(Replay, RoboSimIsReplayed) {
    tests::TemporaryFolder folder;
    folder.write("lamp.rst", lamp);
    test::Model model(folder.path());
    const ir::ComponentRef machine = model.machine_named("Switch");
    const Certified certified(model, machine);
    expect_certified(certified);
    const Ran ran = replay(certified.path());
    EXPECT_EQ(ran.exit, 0) << ran.out;
    const Ran other = replay(certified.path(), compile_mutant(folder, model, machine, Fault::comparison_wrong, 0));
    EXPECT_EQ(other.exit, 1) << other.out;
    EXPECT_THAT(other.out, StartsWith("DIFFERS row "));
}

/// Values of the type boolean and of enumerations have names in events.
TEST(Replay, NamedValuesAreReplayed) {
    test::Model model("tests/conformance/models/parcels");
    const Certified certified(model, model.first_module());
    expect_certified(certified);
    const Ran ran = replay(certified.path());
    EXPECT_EQ(ran.exit, 0) << ran.out;
}

/// The mutants of one model, by the answer of robochart-replay.
struct MutantAnswers {
    std::set<Fault> refused;    ///< with the row
    std::size_t elsewhere = 0;  ///< refused without a row: the first state has other members
    std::size_t accepted = 0;
};

/// Replays the certificate of the right code against mutants. A mutant that is not strongly bisimilar to the right code
/// must be refused. The explorer of `conform` decides which mutants are.
MutantAnswers replay_mutants(test::Model& model, const ir::ComponentRef& component, const std::vector<Fault>& faults) {
    const Certified certified(model, component);
    test::Bench bench(model, component);
    const auto right = bench.compile_fault(Fault::none, 0);
    const Alphabet alphabet(bench.interface(), bench.session().event_table());
    const tests::TemporaryFolder folder;
    MutantAnswers answers;
    for (const Fault fault : faults) {
        if (cpp_emit::in_event_api(fault) || bench.site_count(fault) == 0) continue;
        const auto mutant = bench.compile_fault(fault, 0);
        const bool same = compare_code(right->interface(), mutant->interface(), alphabet, 1, {}).same;
        const Ran ran = replay(certified.path(), compile_mutant(folder, model, component, fault, 0), "--row-timeout 2");
        EXPECT_LE(ran.exit, 1) << static_cast<int>(fault) << ran.out;
        EXPECT_TRUE(same || ran.exit == 1) << static_cast<int>(fault) << ran.out;
        if (ran.exit == 0) ++answers.accepted;
        if (ran.out.starts_with("DIFFERS row ")) answers.refused.insert(fault);
        if (ran.out.starts_with("DIFFERS the code begins")) ++answers.elsewhere;
    }
    return answers;
}

/// Returns these faults, or all that compile if ROBOCHART_MUTANTS=all.
std::vector<Fault> chosen_faults(std::vector<Fault> faults) {
    const char* const setting = std::getenv("ROBOCHART_MUTANTS");
    if (setting == nullptr || std::string(setting) != "all") return faults;
    faults.clear();
    for (const cpp_emit::FaultKind& kind : cpp_emit::all_faults())
        if (kind.fault < Fault::name_collision) faults.push_back(kind.fault);
    return faults;
}

TEST(Replay, MutantsAreRefusedWithTheRow) {
    const auto expect_refused = [](const std::string& folder, bool module, const std::vector<Fault>& faults) {
        test::Model model(folder);
        const std::string machine = folder.ends_with("choices") ? "Choices" : "Timing";
        const MutantAnswers answers =
            replay_mutants(model, module ? model.first_module() : model.machine_named(machine), chosen_faults(faults));
        EXPECT_GE(answers.refused.size(), 3U) << folder;
        fmt::print("{}: {} kinds of mutants refused with the row, {} without, {} do what the table states\n", folder,
                   answers.refused.size(), answers.elsewhere, answers.accepted);
    };
    expect_refused("corpus/aggregation", true,
                   {Fault::action_dropped, Fault::argument_swapped, Fault::call_dropped, Fault::wrong_target,
                    Fault::wait_dropped, Fault::wrong_input, Fault::transitions_reversed});
    expect_refused("tests/conformance/models/timing", false,
                   {Fault::clock_not_reset, Fault::clock_off_by_one, Fault::deadline_late, Fault::comparison_wrong,
                    Fault::guard_negated});
    expect_refused("tests/conformance/models/choices", false,
                   {Fault::way_exchanged, Fault::wrong_output, Fault::wrong_target, Fault::junction_reversed});
}

/// A line of the table, split into numbers.
std::vector<unsigned> numbers_in(const std::string& line) {
    std::istringstream in(line);
    std::vector<unsigned> numbers;
    for (unsigned number = 0; in >> number;) numbers.push_back(number);
    return numbers;
}

std::vector<std::string> lines_in(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

/// Each state with one transition gets another target or another event, one at a time. No such table is the code's:
/// states in which cycles begin have other texts, and each event has another name.
TEST(Replay, WrongRowsAreFound) {
    test::Model model("corpus/aggregation");
    const Certified certified(model, model.first_module());
    const tests::TemporaryFolder work;
    Ran ran = run_command(fmt::format("cd {}/code && c++ -std=c++17 -O0 -w -shared -fPIC -I . -o {} *.cpp",
                                      certified.path(), work.in("right.so")));
    ASSERT_EQ(ran.exit, 0) << ran.out;
    ASSERT_EQ(replay(certified.path(), work.in("right.so")).exit, 0);
    const std::vector<std::string> table = lines_in(certified.text("implementation.txt"));
    std::set<unsigned> starts;
    for (const std::string& line : lines_in(certified.text("code.txt")))
        if (line.starts_with("state ")) starts.insert(numbers_in(line.substr(6)).front());
    ASSERT_EQ(starts.size(), 3U);
    const auto events = static_cast<unsigned>(std::stoul(table[1].substr(7)));
    const std::size_t first = 2 + events + 2;  // the line of state 0
    std::size_t tables = 0;
    for (std::size_t line = first; !table[line].starts_with("region"); ++line) {
        const std::vector<unsigned> edge = numbers_in(table[line]);
        if (edge.size() != 2) continue;
        std::vector<std::string> forged{fmt::format("{} {}", edge[0] + 1 < events + 2 ? edge[0] + 1 : 2, edge[1])};
        forged.emplace_back("");
        for (const unsigned start : starts)
            if (starts.contains(edge[1]) && start != edge[1]) forged.push_back(fmt::format("{} {}", edge[0], start));
        for (const std::string& row : forged) {
            std::vector<std::string> lines = table;
            lines[line] = row;
            certified.forge_table(joined(lines));
            ran = replay(certified.path(), work.in("right.so"));
            EXPECT_EQ(ran.exit, 1) << "line " << line << ": " << row << "\n" << ran.out;
            EXPECT_THAT(ran.out, StartsWith("DIFFERS "));
            ++tables;
        }
    }
    EXPECT_GE(tables, 20U);
}

TEST(Replay, DamagedFilesAreUnusable) {
    test::Model model("corpus/aggregation");
    const Certified certified(model, model.first_module());
    const auto expect_unusable = [&](const std::string& why) {
        const Ran ran = replay(certified.path());
        EXPECT_EQ(ran.exit, 2) << ran.out;
        EXPECT_THAT(ran.out, StartsWith("UNUSABLE "));
        EXPECT_THAT(ran.out, HasSubstr(why));
        EXPECT_EQ(std::ranges::count(ran.out, '\n'), 1);
    };
    const std::string code = certified.text("code.txt");
    const std::string table = certified.text("implementation.txt");
    certified.damage("implementation.txt", table + " ");
    expect_unusable("implementation.txt: its digest is not that in code.txt");
    certified.damage("implementation.txt", table);
    for (std::size_t end = code.find('\n'); end + 1 < code.size(); end = code.find('\n', end + 1)) {
        certified.damage("code.txt", code.substr(0, end + 1));
        expect_unusable("code.txt, line ");
    }
    std::string other = code;
    other.replace(other.find("cycle: 1"), 8, "cycle: 2");
    certified.damage("code.txt", other);
    expect_unusable("the digest of the lines above is another one");
    certified.damage("code.txt", code);
    const std::string source = "code/AggregationFSM.cpp";
    const std::string text = certified.text(source);
    certified.damage(source, text + "\n");
    expect_unusable("AggregationFSM.cpp: its digest is not that in code.txt");
    certified.damage(source, text);
    const std::string claim = certified.text("claim.txt");
    certified.damage("claim.txt", lines_in(claim).front());
    expect_unusable("claim.txt: it is about another process");
    certified.damage("claim.txt", claim);
    EXPECT_EQ(replay(certified.path()).exit, 0);
}

/// Files with one changed byte and right digests: any answer but a crash, and `REPLAYED` only for a part that does not
/// concern the code.
TEST(Replay, ChangedBytesDoNotCrash) {
    test::Model model("corpus/aggregation");
    const Certified certified(model, model.first_module());
    const tests::TemporaryFolder work;
    const Ran built = run_command(fmt::format("cd {}/code && c++ -std=c++17 -O0 -w -shared -fPIC -I . -o {} *.cpp",
                                              certified.path(), work.in("right.so")));
    ASSERT_EQ(built.exit, 0) << built.out;
    const std::string table = certified.text("implementation.txt");
    const std::string code = certified.text("code.txt");
    std::mt19937 random(7);
    const auto changed = [&](std::string text) {
        constexpr std::string_view bytes = "0179 \n-x";
        text[random() % text.size()] = bytes[random() % bytes.size()];
        return text;
    };
    for (int trial = 0; trial < 150; ++trial) {
        const std::string forged = changed(table);
        certified.damage("implementation.txt", table);
        certified.damage("code.txt", code);
        certified.forge("claim.txt", fmt::format("\nimplementation-sha256: {}\n", diagnostics::sha256(table)));
        certified.forge_table(forged);
        const Ran ran = replay(certified.path(), work.in("right.so"));
        EXPECT_LE(ran.exit, 3) << ran.out;
    }
    certified.forge_table(table);
    for (int trial = 0; trial < 150; ++trial) {
        certified.forge("code.txt", changed(code));
        EXPECT_LE(replay(certified.path(), work.in("right.so")).exit, 3);
    }
}

/// Replaces a function of the right code.
class Wrapped {
public:
    Wrapped() : model_("corpus/aggregation"), certified_(model_, model_.first_module()) {}

    Ran replay_with(const std::string& body, const std::string& more = "") {
        const std::string wrapper = R"(
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "robochart/explore_abi.h"
extern "C" const rc_interface* right_code(void);
static rc_interface code;
static int calls = 0;
)" + body;
        std::vector<cpp_emit::OutputFile> files;
        for (const certify::FurtherFile& file : certified_.result().certificate->further)
            if (file.path.starts_with("code/")) files.push_back({file.path.substr(5), file.text});
        for (cpp_emit::OutputFile& file : files) {
            if (!file.path.ends_with("_explore.cpp")) continue;
            file.text = "#define robochart_explore right_code\n" + file.text;
        }
        files.push_back({"wrapper/wrapper.cpp", wrapper});
        return replay(certified_.path(), compile(folder_, files, "*_explore.cpp wrapper/wrapper.cpp", "wrapped.so"),
                      more);
    }
    [[nodiscard]] const Certified& certified() const { return certified_; }
    [[nodiscard]] const tests::TemporaryFolder& folder() const { return folder_; }

private:
    test::Model model_;
    Certified certified_;
    tests::TemporaryFolder folder_;
};

/// An interface with this `step`; `go` is the step of the right code.
std::string with_step(const std::string& statements) {
    return "static rc_result go(void* s, const rc_register* r, rc_log* l) { return right_code()->step(s, r, l); }\n"
           "static rc_result step(void* s, const rc_register* r, rc_log* l) { ++calls; " +
           statements +
           " return go(s, r, l); }\nextern \"C\" const rc_interface* robochart_explore(void) { code = *right_code(); "
           "code.step = step; return &code; }\n";
}

TEST(Replay, CodeThatCrashesIsRefusedWithTheRow) {
    Wrapped wrapped;
    EXPECT_EQ(wrapped.replay_with(with_step("puts(\"chatter\");")).out,
              "REPLAYED 20 rows: the code of Aggregation does what the table states\n");
    const Ran crash = wrapped.replay_with(with_step("if (calls == 3) raise(SIGSEGV);"));
    EXPECT_EQ(crash.exit, 1);
    EXPECT_THAT(crash.out, StartsWith("DIFFERS row 3, in "));
    EXPECT_THAT(crash.out, HasSubstr("the code crashes with signal 11"));
    const Ran end = wrapped.replay_with(with_step("if (calls == 2) _exit(0);"));
    EXPECT_EQ(end.exit, 1);
    EXPECT_THAT(end.out, HasSubstr("row 2"));
    EXPECT_THAT(end.out, HasSubstr("the code ends the process"));
    const Ran endless = wrapped.replay_with(with_step("for (; calls == 4;) sleep(1);"), "--row-timeout 1");
    EXPECT_EQ(endless.exit, 1);
    EXPECT_THAT(endless.out, HasSubstr("row 4"));
    EXPECT_THAT(endless.out, HasSubstr("the code does not return"));
    const Ran other = wrapped.replay_with(with_step("if (calls == 5) { go(s, r, l); return RC_TERMINATED; }"));
    EXPECT_THAT(other.out, StartsWith("DIFFERS row 5, in "));
    EXPECT_THAT(other.out, HasSubstr("then termination"));
}

TEST(Replay, ObjectsThatDoNotFitAreUnusable) {
    Wrapped wrapped;
    const auto expect_unusable = [](const Ran& ran, const std::string& why) {
        EXPECT_EQ(ran.exit, 2) << ran.out;
        EXPECT_THAT(ran.out, StartsWith("UNUSABLE "));
        EXPECT_THAT(ran.out, HasSubstr(why));
    };
    expect_unusable(wrapped.replay_with("int robochart_other;"), "does not have the symbol robochart_explore");
    expect_unusable(wrapped.replay_with("extern \"C\" const rc_interface* robochart_explore(void) { return 0; }"),
                    "the object has no interface");
    const auto with = [](const std::string& change) {
        return "extern \"C\" const rc_interface* robochart_explore(void) { code = *right_code(); " + change +
               " return &code; }";
    };
    expect_unusable(wrapped.replay_with(with("code.abi_version = 1;")), "version 1 of the interface");
    expect_unusable(wrapped.replay_with(with("code.component = \"Other\";")),
                    "the object is the code of Other, but the table is of Aggregation");
    expect_unusable(wrapped.replay_with(with("code.step = 0;")), "a function of the object is missing");
    expect_unusable(wrapped.replay_with(with("abort();")), "before the first row, the code crashes with signal 6");
    const Ran inputs = wrapped.replay_with(with("code.inputs = 1;"));
    EXPECT_EQ(inputs.exit, 1);
    EXPECT_THAT(inputs.out, HasSubstr("DIFFERS the code has other inputs or outputs than the table"));
    const std::string text = wrapped.folder().write("text.so", "this is no object\n");
    expect_unusable(replay(wrapped.certified().path(), text), "the object cannot be loaded");
    expect_unusable(replay(wrapped.certified().path(), "/nowhere/x.so"), "there is no object /nowhere/x.so");
    expect_unusable(replay("/nowhere"), "claim.txt cannot be read");
}

TEST(Replay, CodeThatIsNotBuiltIsNotDecided) {
    test::Model model("corpus/aggregation");
    const Certified certified(model, model.first_module());
    const std::string code = certified.text("code.txt");
    std::string other = code;
    other.replace(other.find("build: c++"), 10, "build: no-such-compiler");
    certified.forge("code.txt", other);
    const Ran none = replay(certified.path());
    EXPECT_EQ(none.exit, 3) << none.out;
    EXPECT_THAT(none.out, StartsWith("NOT RUN the code could not be built: cannot run no-such-compiler"));
    other = code;
    other.replace(other.find("build: c++"), 10, "build: false");
    certified.forge("code.txt", other);
    EXPECT_EQ(replay(certified.path()).exit, 3);
}

TEST(Replay, WrongUseIsExplained) {
    for (const char* words : {"", "--quiet x", "x y", "--object", "''", "--row-timeout 0 x"}) {
        const Ran ran = run_command(fmt::format("{} {}", ROBOCHART_REPLAY, words));
        EXPECT_EQ(ran.exit, 4) << words << ran.out;
        EXPECT_THAT(ran.out, HasSubstr("usage: robochart-replay"));
    }
    EXPECT_EQ(run_command(fmt::format("{} --help", ROBOCHART_REPLAY)).exit, 0);
}

TEST(Certificates, OnlyCodeThatConformsHasOne) {
    test::Model model("corpus/aggregation");
    Options options = certifying_options();
    options.generator.fault = Fault::call_dropped;
    Result result =
        conform(model.system, model.instantiation, model.first_module(), options, model.sources, model.diagnostics);
    EXPECT_EQ(result.outcome, Outcome::differs);
    EXPECT_EQ(result.certificate, nullptr);
    options = certifying_options();
    options.relation = Relation::tick_tock;
    result =
        conform(model.system, model.instantiation, model.first_module(), options, model.sources, model.diagnostics);
    EXPECT_EQ(result.certificate, nullptr);
    EXPECT_EQ(result.certificate_failure, "there are no certificates for tick-tock");
}

/// The check for all values uses other code, so the code for the carriers is compiled for the certificate.
TEST(Certificates, CodeForAllValuesIsCertifiedInCarriers) {
    const test::ModelFolder folder(
        "stm Later { event level : nat event high initial i var v : nat\n state A { } junction k\n"
        " transition t0 { from i to A } transition t1 { from A to k trigger level ? v }\n"
        " transition t2 { from k to A condition v > 1 action high } transition t3 { from k to A condition v <= 1 } "
        "}\n");
    test::Model model(folder.path());
    Options options = certifying_options();
    options.numbers = Numbers::all;
    const Certified certified(model, model.machine_named("Later"), options);
    EXPECT_FALSE(certified.result().all_values.empty()) << certified.result().not_for_all;
    expect_certified(certified);
    const Ran ran = replay(certified.path());
    EXPECT_EQ(ran.exit, 0) << ran.out;
    EXPECT_THAT(certified.text("code.txt"), HasSubstr("\ninput 3 level.in\n0\n1\n2\n"));
}

}  // namespace
}  // namespace robochart::conformance
