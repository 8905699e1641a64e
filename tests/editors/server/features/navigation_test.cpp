// SPDX-License-Identifier: Apache-2.0
// Tests navigation between names and declarations, across files and in text with errors.
#include <gtest/gtest.h>

#include <fstream>

#include "editors/server/protocol/uri.hpp"
#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* navigated = R"(package p
enumeration /*^E*/E { /*^red*/red green }
interface /*^I*/I { var /*^x*/x : nat  /*^go*/go() }
interface J { event /*^e*/e : nat }
function /*^f*/f(/*^a*/a : nat) : nat { postcondition result == /*^a-use*/a }
operation /*^op*/go() { initial i final g transition t { from i to g } }
stm /*^S*/S {
  requires /*^I-use*/I
  uses J
  var /*^c*/c : /*^E-type*/E
  clock /*^C*/C
  initial /*^i*/i
  state /*^A*/A { entry /*^x-write*/x = f(/*^x-read*/x) ; c = /*^E-literal*/E::/*^red-use*/red ; $go() }
  transition /*^t*/t { from /*^i-use*/i to /*^A-use*/A }
  transition u { from A to A trigger /*^e-use*/e?x #/*^C-reset*/C condition since(/*^C-since*/C) > /*^f-use*/f(1) }
}
)";

std::string text() {
    std::string out = navigated;
    out.replace(out.find("$go"), 3, "/*^call*/go");
    return out;
}

class Navigation : public ::testing::Test {
protected:
    Navigation() { client.open("file:///p/a.rct", text()); }

    std::string definition(const std::string& mark) {
        return client.marks(client.request("textDocument/definition", client.at(mark)));
    }
    std::string references(const std::string& mark, bool declaration = true) {
        Json params = client.at(mark);
        params["context"] = Json::object({{"includeDeclaration", declaration}});
        return client.marks(client.request("textDocument/references", params));
    }

    Client client;
};

TEST_F(Navigation, TheFixtureIsSound) {
    EXPECT_EQ(client.codes(), "");
}

TEST_F(Navigation, DefinitionsOfEveryKindOfName) {
    EXPECT_EQ(definition("x-write"), "x");
    EXPECT_EQ(definition("x-read"), "x");
    EXPECT_EQ(definition("I-use"), "I");
    EXPECT_EQ(definition("E-type"), "E");
    EXPECT_EQ(definition("E-literal"), "E");
    EXPECT_EQ(definition("red-use"), "red");
    EXPECT_EQ(definition("f-use"), "f");
    EXPECT_EQ(definition("a-use"), "a");
    EXPECT_EQ(definition("i-use"), "i");
    EXPECT_EQ(definition("A-use"), "A");
    EXPECT_EQ(definition("e-use"), "e");
    EXPECT_EQ(definition("C-reset"), "C");
    EXPECT_EQ(definition("C-since"), "C");
    EXPECT_EQ(definition("x"), "x") << "a declaration is its own definition";
}

TEST_F(Navigation, ACallLeadsToTheSignatureAndTheOperation) {
    EXPECT_EQ(definition("call"), "go op");
}

TEST_F(Navigation, ThereIsNothingBehindWordsAndBlanks) {
    Json params = client.at("x");
    params = Json::object(
        {{"textDocument", params["textDocument"]}, {"position", Json::object({{"line", 6}, {"character", 1}})}});
    EXPECT_TRUE(client.request("textDocument/definition", params).is_null());
    params["position"]["character"] = 0;
    params["position"]["line"] = 7;
    EXPECT_TRUE(client.request("textDocument/hover", params).is_null());
    EXPECT_EQ(client.request("textDocument/references", params), Json::array());
}

TEST_F(Navigation, References) {
    EXPECT_EQ(references("x"), "x x-write x-read ?");
    EXPECT_EQ(references("x-read", false), "x-write x-read ?");
    EXPECT_EQ(references("C-since"), "C C-reset C-since");
    EXPECT_EQ(references("t"), "t");
    EXPECT_EQ(references("E-type"), "E E-type E-literal");
}

TEST_F(Navigation, HighlightsTellReadsFromWrites) {
    const Answer found = client.request("textDocument/documentHighlight", client.at("x"));
    std::string kinds;
    for (const Answer& highlight : found.items()) kinds += std::to_string(highlight["kind"].number());
    EXPECT_EQ(kinds, "1323");
}

TEST_F(Navigation, AnotherFileOfThePackage) {
    client.open("file:///p/b.rct",
                "package p\nstm T { requires /*^I2*/I initial i state A { entry /*^x2*/x = 1 } "
                "transition t { from i to A } }\n");
    const Answer found = client.request("textDocument/definition", client.at("x2", "file:///p/b.rct"));
    EXPECT_EQ(client.marks(found), "x");
    EXPECT_EQ(found[0]["uri"].text(), "file:///p/a.rct");
    EXPECT_EQ(references("x", false), "x-write x-read ? x2");
    client.close("file:///p/b.rct");
    EXPECT_EQ(references("x", false), "x-write x-read ?") << "it is not on disk either";
}

TEST_F(Navigation, AssertionsLeadThroughReferences) {
    client.open("file:///p/b.rct",
                "import p::*\n"
                "robotic platform R { provides p::I event e : nat }\n"
                "controller Ctl { requires p::I event e : nat sref /*^ref*/s = p::S opref o = p::go\n"
                "  connection Ctl on e to /*^end*/s on e }\n"
                "module M { rref r = R cref /*^cref*/k = Ctl connection r on e to k on e (_async) }\n");
    client.open("file:///p/c.assertions",
                "import p::*\n"
                "assertion A1 : M::/*^k*/k::/*^s*/s::/*^state*/A is reachable in /*^m*/M\n"
                "csp /*^spec*/Spec csp-begin Spec = STOP csp-end\n"
                "assertion A2 : M refines /*^spec-use*/Spec in the traces model\n");
    const auto from = [&](const std::string& mark) {
        return client.marks(client.request("textDocument/definition", client.at(mark, "file:///p/c.assertions")));
    };
    EXPECT_EQ(from("k"), "cref");
    EXPECT_EQ(from("s"), "ref");
    EXPECT_EQ(from("state"), "A");
    EXPECT_EQ(from("spec-use"), "spec");
    EXPECT_EQ(client.marks(client.request("textDocument/definition", client.at("end", "file:///p/b.rct"))), "ref");
    EXPECT_EQ(references("A"), "A A-use ? ? state");
}

TEST_F(Navigation, ProbabilisticAssertionsLeadToTheModelAndTheirDefinitions) {
    client.open(
        "file:///p/c.assertions",
        "import p::*\n"
        "label /*^label*/up = p::S is in p::S::/*^state*/A\n"
        "const /*^k*/k : core::nat\n"
        "constants /*^set*/Few : k set to 1\n"
        "prob property P : Prob=? of [Finally #/*^label-use*/up /\\ p::S::/*^x2*/x == /*^k-use*/k] with constants "
        "/*^set-use*/Few\n");
    const auto from = [&](const std::string& mark) {
        return client.marks(client.request("textDocument/definition", client.at(mark, "file:///p/c.assertions")));
    };
    EXPECT_EQ(from("state"), "A");
    EXPECT_EQ(from("x2"), "x");
    EXPECT_EQ(from("k-use"), "k");
    EXPECT_EQ(from("label-use"), "label");
    EXPECT_EQ(from("set-use"), "set");
}

TEST_F(Navigation, WorksInBrokenText) {
    std::string broken = text();
    broken.insert(broken.find("  transition u"), "  transition { from\n");
    client.change("file:///p/a.rct", broken);
    EXPECT_NE(client.codes(), "");
    EXPECT_EQ(definition("x-read"), "x");
    EXPECT_EQ(definition("A-use"), "A");
}

TEST_F(Navigation, HoverShowsTheDeclarationWithItsTypeAndComment) {
    client.change("file:///p/a.rct",
                  "interface I {\n"
                  "  // far above\n"
                  "\n"
                  "  // How far it may go,\n"
                  "  // in metres.\n"
                  "  const /*^limit*/limit : real = 1.5\n"
                  "  var plain : nat  // counts\n"
                  "}\n"
                  "/* What a\n * robot does. */\n"
                  "stm S { requires I var y : real initial i state A { entry y = /*^use*/limit; y = /*^n*/plain }\n"
                  "  transition t { from i to A condition forall /*^k*/k : nat | k > 0 @ /*^k-use*/k > 1 } }\n"
                  "controller C { sref s = /*^S*/S }\n");
    const auto hover = [&](const std::string& mark) {
        return client.request("textDocument/hover", client.at(mark))["contents"]["value"].text();
    };
    EXPECT_EQ(hover("use"),
              "```robochart\nconst limit : real = 1.5\n```\nin interface `I`\n\nHow far it may go,\nin metres.");
    EXPECT_EQ(hover("n"), "```robochart\nvar plain : nat\n```\nin interface `I`\n\ncounts");
    EXPECT_EQ(hover("S"), "```robochart\nstm S\n```\n\nWhat a\nrobot does.");
    EXPECT_EQ(hover("k-use"), "```robochart\nk : nat\n```");
}

TEST_F(Navigation, HoverExplainsWhatARuleObjectsTo) {
    client.change("file:///p/a.rct", "interface I { var x : /*^lost*/Lost }\n");
    const std::string text = client.request("textDocument/hover", client.at("lost"))["contents"]["value"].text();
    EXPECT_NE(text.find("**RC-N01**"), std::string::npos) << text;
}

TEST_F(Navigation, HoverOnWhatTheToolBringsAlong) {
    client.change("file:///p/a.rct",
                  "import set_toolkit::*\n"
                  "interface I { const c : boolean = /*^subset*/subset({1}, {2}) const d : /*^nat*/nat = 1 }\n");
    ASSERT_EQ(client.codes(), "");
    const auto hover = [&](const std::string& mark) {
        return client.request("textDocument/hover", client.at(mark))["contents"]["value"].text();
    };
    EXPECT_NE(hover("subset").find("function subset("), std::string::npos) << hover("subset");
    EXPECT_NE(hover("nat").find("core"), std::string::npos);
}

/// Libraries are files next to the program. A definition is at the position of the name in its file.
TEST_F(Navigation, DefinitionsOfLibrariesAreInTheirFiles) {
    client.change("file:///p/a.rct",
                  "import set_toolkit::*\n"
                  "interface I { const c : boolean = /*^subset*/subset({1}, {2}) const d : /*^nat*/nat = 1 }\n");
    for (const std::string name : {"subset", "nat"}) {
        const Answer found = client.request("textDocument/definition", client.at(name));
        ASSERT_EQ(found.items().size(), 1U) << found.write();
        const std::string path = path_of_uri(found.items()[0]["uri"].text());
        EXPECT_TRUE(path.ends_with(name == "nat" ? "/core.rct" : "/set_toolkit.rct")) << path;
        std::ifstream file(path);
        std::string line;
        const Answer& begin = found.items()[0]["range"]["start"];
        for (std::int64_t i = 0; i <= begin["line"].number(); ++i) ASSERT_TRUE(std::getline(file, line)) << path;
        EXPECT_EQ(line.substr(static_cast<std::size_t>(begin["character"].number()), name.size()), name);
    }
}

TEST_F(Navigation, SignatureHelpFollowsTheArguments) {
    client.change("file:///p/a.rct",
                  "function max(a : nat, b : nat) : nat { }\n"
                  "interface I { turn(by : int) }\n"
                  "stm S { requires I var x : nat initial i\n"
                  "  state A { entry x = max(/*^one*/ 1, /*^two*/ ); turn(/*^three*/ }\n"
                  "  transition t { from i to A } }\n");
    const auto help = [&](const std::string& mark) {
        const Answer found = client.request("textDocument/signatureHelp", client.at(mark));
        return found["signatures"][0]["label"].text() + " " + std::to_string(found["activeParameter"].number(-1));
    };
    EXPECT_EQ(help("one"), "function max(a : nat, b : nat) : nat 0");
    EXPECT_EQ(help("two"), "function max(a : nat, b : nat) : nat 1");
    EXPECT_EQ(help("three"), "turn(by : int) 0");
}

}  // namespace
}  // namespace robochart::lsp
