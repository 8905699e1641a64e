// SPDX-License-Identifier: Apache-2.0
// Tests CSPM scripts in an editor: findings while typing, also in included files, and types and declarations of names.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/editors/server/client.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* script_uri = "file:///p/a.csp";

/// A temporary folder whose files an editor names.
class Folder : public tests::TemporaryFolder {
public:
    void remove(const std::string& name) const { std::filesystem::remove(in(name)); }
    [[nodiscard]] std::string uri(const std::string& name) const { return uri_of_path(in(name)); }
};

Json document_of(const std::string& uri) {
    return Json::object({{"textDocument", Json::object({{"uri", uri}})}});
}

Json place(const std::string& uri, std::int64_t line, std::int64_t character) {
    Json params = document_of(uri);
    params["position"] = Json::object({{"line", line}, {"character", character}});
    return params;
}

std::string hovered(Client& client, const std::string& uri, std::int64_t line, std::int64_t character) {
    return client.request("textDocument/hover", place(uri, line, character))["contents"]["value"].text();
}

std::string start_of(const Answer& locations) {
    const Answer at = locations[0]["range"]["start"];
    return locations[0]["uri"].text() + ":" + std::to_string(at["line"].number()) + ":" +
           std::to_string(at["character"].number());
}

TEST(Scripts, AreCheckedWhileTyping) {
    Client client;
    client.open(script_uri, "P = STOP\n");
    EXPECT_TRUE(client.diagnostics(script_uri).is_null()) << "nothing to say, nothing said";
    client.change(script_uri, "P = Q\n");
    EXPECT_EQ(client.codes(script_uri), "CSPM-T01@1");
    client.change(script_uri, "channel a : {0..1}\nP = a!true -> STOP\n");
    EXPECT_EQ(client.codes(script_uri), "CSPM-T08@2");
    client.change(script_uri, "P = ->\n");
    EXPECT_EQ(client.codes(script_uri), "CSPM-P01@1");
    client.change(script_uri, "P = STOP\n");
    EXPECT_EQ(client.diagnostics(script_uri), Json::array());
}

TEST(Scripts, ChangesMayBeOfARange) {
    Client client;
    client.open(script_uri, "-- \xC3\xA9\nP = Q\n");
    ASSERT_EQ(client.codes(script_uri), "CSPM-T01@2");
    const Json range = Json::object({{"start", Json::object({{"line", 1}, {"character", 4}})},
                                     {"end", Json::object({{"line", 1}, {"character", 5}})}});
    client.changes(script_uri, Json::array({Json::object({{"range", range}, {"text", "SKIP"}})}));
    EXPECT_EQ(client.codes(script_uri), "");
    EXPECT_EQ(client.messages.back()["params"]["version"].number(), 2);
}

TEST(Scripts, AreKnownByNameOrLanguage) {
    for (const char* uri : {"file:///p/a.csp", "file:///p/a.cspm", "file:///p/a.fdr3"}) {
        Client client;
        client.open(uri, "P = Q\n");
        EXPECT_EQ(client.codes(uri), "CSPM-T01@1");
    }
    Client client;
    client.notify("textDocument/didOpen",
                  Json::object({{"textDocument", Json::object({{"uri", "untitled:Untitled-1"},
                                                               {"languageId", "cspm"},
                                                               {"version", 1},
                                                               {"text", "include \"b.csp\"\nP = STOP\n"}})}}));
    EXPECT_EQ(client.codes("untitled:Untitled-1"), "CSPM-P15@1") << "a text that lies nowhere has nothing beside it";
    client.close("untitled:Untitled-1");
    EXPECT_EQ(client.diagnostics("untitled:Untitled-1"), Json::array());
}

TEST(Scripts, FindingsOfIncludedFilesAreShownThere) {
    const Folder folder;
    folder.write("parts/b.csp", "Q = R\n");
    Client client;
    client.open(folder.uri("a.csp"), "include \"parts/b.csp\"\nP = Q\n");
    EXPECT_EQ(client.codes(folder.uri("parts/b.csp")), "CSPM-T01@1");
    EXPECT_EQ(client.codes(folder.uri("a.csp")), "");
    client.close(folder.uri("a.csp"));
    EXPECT_EQ(client.diagnostics(folder.uri("parts/b.csp")), Json::array()) << "nobody asks about it any more";
}

TEST(Scripts, UnsavedTextsOfIncludedFilesCount) {
    const Folder folder;
    folder.write("b.csp", "Q = STOP\n");
    Client client;
    client.open(folder.uri("a.csp"), "include \"b.csp\"\nP = Q\nR = STOP\n");
    EXPECT_EQ(client.codes(folder.uri("a.csp")), "");
    client.open(folder.uri("b.csp"), "Q2 = STOP\n");
    EXPECT_EQ(client.codes(folder.uri("a.csp")), "CSPM-T01@2");
    client.change(folder.uri("b.csp"), "Q = R\n");
    EXPECT_EQ(client.codes(folder.uri("a.csp")), "");
    EXPECT_EQ(client.codes(folder.uri("b.csp")), "") << "read with what includes it, R is known";
    client.close(folder.uri("a.csp"));
    EXPECT_EQ(client.codes(folder.uri("b.csp")), "CSPM-T01@1") << "read alone it is not";
    client.open(folder.uri("a.csp"), "include \"b.csp\"\nP = Q\n");
    client.close(folder.uri("b.csp"));
    EXPECT_EQ(client.codes(folder.uri("a.csp")) + client.codes(folder.uri("b.csp")), "") << "as on disk again";
}

TEST(Scripts, FilesOnDiskMayChange) {
    const Folder folder;
    Client client;
    client.open(folder.uri("a.csp"), "include \"b.csp\"\nP = Q\n");
    EXPECT_EQ(client.codes(folder.uri("a.csp")), "CSPM-P15@1");
    const auto touched = [&](const char* name) {
        client.notify(
            "workspace/didChangeWatchedFiles",
            Json::object({{"changes", Json::array({Json::object({{"uri", folder.uri(name)}, {"type", 1}})})}}));
    };
    folder.write("b.csp", "Q = STOP\n");
    touched("b.csp");
    EXPECT_EQ(client.codes(folder.uri("a.csp")), "");
    folder.remove("b.csp");
    folder.write("c.csp", "Q = STOP\n");
    touched("b.csp");
    touched("c.csp");
    EXPECT_EQ(client.codes(folder.uri("a.csp")), "CSPM-P15@1") << "the file has another name now";
}

/// All symbolic links to a file denote the same file, even if the links change.
TEST(Scripts, MayBeReachedByLinks) {
    const Folder folder;
    folder.write("parts/b.csp", "Q = STOP\n");
    std::filesystem::create_directory_symlink(folder.in("parts"), folder.in("link"));
    Client client;
    client.open(folder.uri("a.csp"), "include \"parts/b.csp\"\nP = Q\n");
    client.open(folder.uri("link/b.csp"), "Q = Lost\n");
    EXPECT_EQ(client.codes(folder.uri("link/b.csp")), "CSPM-T01@1") << "under the name that the editor knows";
    folder.remove("link");
    client.change(folder.uri("link/b.csp"), "Q = Gone\n\n");
    EXPECT_EQ(client.codes(folder.uri("link/b.csp")), "CSPM-T01@1");
    EXPECT_EQ(hovered(client, folder.uri("link/b.csp"), 0, 5).substr(0, 13), "**CSPM-T01** ");
    client.close(folder.uri("link/b.csp"));
    EXPECT_EQ(client.codes(folder.uri("link/b.csp")) + client.codes(folder.uri("a.csp")), "");
}

/// One of the included files includes the first file again, so each of them sees all names.
TEST(Scripts, FilesMayIncludeThemselves) {
    const Folder folder;
    Client client;
    client.open(folder.uri("a.csp"), "include \"a.csp\"\nP = STOP\n");
    EXPECT_EQ(client.codes(folder.uri("a.csp")), "CSPM-P16@1");
    client.open(folder.uri("b.csp"), "include \"a.csp\"\nQ = P\n");
    client.change(folder.uri("a.csp"), "include \"b.csp\"\nP = STOP\n");
    EXPECT_EQ(client.codes(folder.uri("a.csp")), "");
    EXPECT_EQ(client.codes(folder.uri("b.csp")), "CSPM-P16@1");
    client.change(folder.uri("b.csp"), "Q = P\n");
    EXPECT_EQ(client.codes(folder.uri("a.csp")) + client.codes(folder.uri("b.csp")), "");
}

/// Each file includes the next one twice, so without a limit the last file would be read 2^40 times.
TEST(Scripts, IncludesAreBounded) {
    const Folder folder;
    constexpr int files = 40;
    for (int i = 0; i < files; ++i) {
        const std::string next = "include \"f" + std::to_string(i + 1) + ".csp\"\n";
        folder.write("f" + std::to_string(i) + ".csp", next + next);
    }
    folder.write("f40.csp", "P = STOP\n");
    Client client;
    client.open(folder.uri("f0.csp"), "include \"f1.csp\"\n");
    std::string codes;
    for (int i = 0; i < files; ++i) codes += client.codes(folder.uri("f" + std::to_string(i) + ".csp"));
    EXPECT_EQ(codes.substr(0, 9), "CSPM-P15@");
    EXPECT_EQ(codes.find("CSPM", 1), std::string::npos) << "it is said once: " << codes;
}

TEST(Scripts, AFileOfSeveralScriptsIsReportedOnce) {
    const Folder folder;
    folder.write("c.csp", "R = Lost\n");
    Client client;
    client.open(folder.uri("a.csp"), "include \"c.csp\"\n");
    client.open(folder.uri("b.csp"), "include \"c.csp\"\n");
    EXPECT_EQ(client.codes(folder.uri("c.csp")), "CSPM-T01@1");
    client.close(folder.uri("a.csp"));
    EXPECT_EQ(client.codes(folder.uri("c.csp")), "CSPM-T01@1");
}

TEST(Scripts, HoverShowsTypes) {
    Client client;
    client.open(script_uri,
                "channel a, b : {0..3}\n"                // 0
                "datatype T = Leaf | Node.Bool\n"        // 1
                "f(0) = <>\n"                            // 2
                "f(n) = <n> ^ f(n - 1)\n"                // 3
                "P(x) = a?y -> b!(x + y) -> P(x)\n"      // 4
                "module M\n  hidden = 1\nexports\n"      // 5..7
                "  shown = hidden == 2\nendmodule\n"     // 8, 9
                "Q = if M::shown then STOP else SKIP\n"  // 10
                "swap((u, v)) = (v, u)\n");              // 11
    ASSERT_EQ(client.codes(script_uri), "");
    const auto hover = [&](std::int64_t line, std::int64_t character) {
        return hovered(client, script_uri, line, character);
    };
    EXPECT_EQ(hover(0, 8), "```cspm\na :: Int => Event\n```");
    EXPECT_EQ(hover(0, 11), "```cspm\nb :: Int => Event\n```");
    EXPECT_EQ(hover(1, 9), "```cspm\nT :: {T}\n```");
    EXPECT_EQ(hover(1, 21), "```cspm\nNode :: Bool => T\n```");
    EXPECT_EQ(hover(2, 0), "```cspm\nf :: (Int) -> <Int>\n```");
    EXPECT_EQ(hover(3, 0), "```cspm\nf :: (Int) -> <Int>\n```") << "every equation begins with the name";
    EXPECT_EQ(hover(3, 14), "```cspm\nf :: (Int) -> <Int>\n```");
    EXPECT_EQ(hover(3, 2), "```cspm\nn :: Int\n```");
    EXPECT_EQ(hover(4, 7), "```cspm\na :: Int => Event\n```");
    EXPECT_EQ(hover(4, 9), "```cspm\ny :: Int\n```");
    EXPECT_EQ(hover(4, 18), "```cspm\nx :: Int\n```");
    EXPECT_EQ(hover(8, 3), "```cspm\nM::shown :: Bool\n```");
    EXPECT_EQ(hover(10, 11), "```cspm\nM::shown :: Bool\n```");
    EXPECT_EQ(hover(10, 22), "```cspm\nSTOP :: Proc\n```");
    EXPECT_EQ(hover(11, 7), "```cspm\nu :: a\n```");
    EXPECT_EQ(hover(4, 12), "") << "an arrow has no name";
}

TEST(Scripts, HoverExplainsFindings) {
    Client client;
    client.open(script_uri, "P = Lost\n");
    EXPECT_EQ(hovered(client, script_uri, 0, 5).substr(0, 13), "**CSPM-T01** ");
}

TEST(Scripts, DefinitionsLieInIncludedFilesToo) {
    const Folder folder;
    folder.write("b.csp", "channel c\n\nQ(0) = STOP\nQ(n) = c -> Q(n - 1)\n");
    Client client;
    client.open(folder.uri("a.csp"), "include \"b.csp\"\nP = let x = 3 within Q(x)\nR = c -> P\n");
    const auto leads = [&](std::int64_t line, std::int64_t character) {
        return start_of(client.request("textDocument/definition", place(folder.uri("a.csp"), line, character)));
    };
    EXPECT_EQ(leads(1, 21), folder.uri("b.csp") + ":2:0");
    EXPECT_EQ(leads(1, 23), folder.uri("a.csp") + ":1:8");
    EXPECT_EQ(leads(2, 4), folder.uri("b.csp") + ":0:8");
    EXPECT_EQ(leads(2, 9), folder.uri("a.csp") + ":1:0");
    EXPECT_TRUE(client.request("textDocument/definition", place(folder.uri("a.csp"), 0, 2)).is_null());
    client.open(folder.uri("b.csp"), "\n\nchannel c\nQ(n) = c -> STOP\n");
    EXPECT_EQ(leads(1, 21), folder.uri("b.csp") + ":3:0");
}

std::string outlined(const Answer& symbols) {
    std::string out;
    for (const Answer& symbol : symbols.items()) {
        out += (out.empty() ? "" : " ") + symbol["name"].text() + ":" + std::to_string(symbol["kind"].number());
        if (symbol.has("children")) out += "(" + outlined(symbol["children"]) + ")";
    }
    return out;
}

TEST(Scripts, HaveAnOutline) {
    Client client;
    client.open(script_uri,
                "channel a, b\ndatatype T = A | B\nf(0) = 1\nf(n) = n\n(x, y) = (1, 2)\nnametype N = {0..1}\n"
                "module M\nexports\n  Z = STOP\nendmodule\nassert STOP [T= STOP\n");
    const Answer symbols = client.request("textDocument/documentSymbol", document_of(script_uri));
    EXPECT_EQ(outlined(symbols), "a:24 b:24 T:10(A:22 B:22) f:12 x:13 y:13 N:5 M:2(Z:13) assert STOP [T= STOP:17");
    EXPECT_EQ(symbols[3]["detail"].text(), "(Int) -> Int");
    EXPECT_EQ(symbols[3]["range"].write(), R"({"start":{"line":2,"character":0},"end":{"line":3,"character":8}})");
    EXPECT_EQ(symbols[4]["selectionRange"]["start"].write(), R"({"line":4,"character":1})");
    client.change(script_uri, "channel a, b\nP = )\nR = STOP\n");
    EXPECT_EQ(outlined(client.request("textDocument/documentSymbol", document_of(script_uri))), "a:24 b:24 R:13")
        << "broken texts have one too";
    Json flat = testing::usual_capabilities();
    flat["textDocument"]["documentSymbol"]["hierarchicalDocumentSymbolSupport"] = false;
    Client plain(flat);
    plain.open(script_uri, "datatype T = A\n");
    const Answer list = plain.request("textDocument/documentSymbol", document_of(script_uri));
    ASSERT_EQ(list.items().size(), 2U);
    EXPECT_EQ(list[1]["containerName"].text(), "T");
    EXPECT_EQ(list[1]["location"]["uri"].text(), script_uri);
}

TEST(Scripts, WhatIsKnownOfModelsAloneIsNotAnswered) {
    Client client;
    client.open(script_uri, "P = STOP\n");
    for (const char* method :
         {"textDocument/codeAction", "textDocument/codeLens", "textDocument/completion",
          "textDocument/documentHighlight", "textDocument/foldingRange", "textDocument/formatting",
          "textDocument/inlayHint", "textDocument/prepareCallHierarchy", "textDocument/prepareRename",
          "textDocument/references", "textDocument/rename", "textDocument/selectionRange",
          "textDocument/semanticTokens/full", "textDocument/signatureHelp"}) {
        Json params = place(script_uri, 0, 0);
        params["newName"] = "Q";
        EXPECT_TRUE(client.request(method, params).is_null()) << method;
    }
    const Json item = Json::object({{"item", Json::object({{"uri", script_uri}})}});
    EXPECT_TRUE(client.request("callHierarchy/incomingCalls", item).is_null());
    EXPECT_TRUE(client.request("callHierarchy/outgoingCalls", item).is_null());
    EXPECT_EQ(client.request("workspace/symbol", Json::object({{"query", "P"}})), Json::array());
    EXPECT_EQ(client.ask("textDocument/hover", place("file:///p/other.csp", 0, 0))["error"]["code"].number(), -32602);
}

TEST(Scripts, DoNotTouchModels) {
    Client client;
    client.open("file:///p/a.rct", "interface I { var x : Lost }\n");
    client.open(script_uri, "P = Q\n");
    EXPECT_EQ(client.codes("file:///p/a.rct"), "RC-N01@1");
    const std::size_t before = client.messages.size();
    client.change(script_uri, "P = STOP\n");
    EXPECT_EQ(client.messages.size(), before + 1) << "only the script's findings have changed";
    EXPECT_EQ(client.codes("file:///p/a.rct"), "RC-N01@1");
}

TEST(Scripts, DiagnosticsMayBeAskedFor) {
    Json capabilities = testing::usual_capabilities();
    capabilities["textDocument"]["diagnostic"] = Json::object({{"dynamicRegistration", false}});
    capabilities["workspace"]["diagnostics"] = Json::object({{"refreshSupport", true}});
    const Folder folder;
    folder.write("c.csp", "Z = Lost\n");
    Client client(capabilities);
    const std::string a = folder.uri("a.csp");
    const std::string b = folder.uri("b.csp");
    client.open(a, "include \"b.csp\"\ninclude \"c.csp\"\nP = Q\n");
    client.open(b, "R = STOP\n");
    EXPECT_EQ(client.codes(a), "") << "they would be shown twice";
    EXPECT_EQ(client.codes(folder.uri("c.csp")), "CSPM-T01@1") << "nobody can ask for those of a file that is not open";
    const Answer report = client.request("textDocument/diagnostic", document_of(a));
    EXPECT_EQ(report["kind"].text(), "full");
    ASSERT_EQ(report["items"].items().size(), 1U);
    EXPECT_EQ(report["items"][0]["code"].text(), "CSPM-T01");
    const std::size_t before = client.messages.size();
    client.change(b, "Q = STOP\n");
    ASSERT_EQ(client.messages.size(), before + 1);
    EXPECT_EQ(client.messages.back()["method"].text(), "workspace/diagnostic/refresh");
    EXPECT_EQ(client.request("textDocument/diagnostic", document_of(a))["items"], Json::array());
}

TEST(Scripts, HostileTextsAreHarmless) {
    Client client;
    std::string deep(100000, '(');
    std::string chain = "P = STOP";
    for (int i = 0; i < 20000; ++i) chain += " [] STOP";
    const std::vector<std::string> texts = {"P = " + deep,
                                            chain + "\n",
                                            "include \"" + std::string(100000, 'x') + "\"\n",
                                            "include \"/dev/zero\"\n",
                                            "include \"/proc/self/mem\"\n",
                                            std::string("P = \0 STOP\n", 11),
                                            "\xEF\xBB\xBFP = STOP\r\n",
                                            "P = \xF0\x9F\x98\x80 STOP\n",
                                            "{-",
                                            "\"",
                                            "include",
                                            "include \"\"\n",
                                            "include \".\"\n",
                                            "P = ```\x1B[31m -> STOP\nprint x",
                                            "module M\nmodule N\nexports\n",
                                            "f = \\ x @ " + std::string(5000, '-') + "1"};
    for (const std::string& text : texts) {
        client.open(script_uri, text);
        for (const char* method : {"textDocument/hover", "textDocument/definition", "textDocument/documentSymbol",
                                   "textDocument/diagnostic", "textDocument/completion"})
            for (const std::int64_t character : {0, 4, 1000000})
                client.request(method, place(script_uri, 0, character));
        client.close(script_uri);
        EXPECT_EQ(client.codes(script_uri), "");
    }
    for (const Answer& message : client.messages)
        EXPECT_NE(message["method"].text(), "window/logMessage") << message.write();
}

/// Included files may contain any bytes, but the message with a finding about them must be valid.
TEST(Scripts, IncludedFilesMayBeNoText) {
    const Folder folder;
    folder.write("b.csp", "Q = \xFF\xFE -> \"\xC0\"\n");
    Client client;
    client.open(folder.uri("a.csp"), "include \"b.csp\"\n");
    EXPECT_NE(client.codes(folder.uri("b.csp")), "");
    folder.write("b.csp", "Q = STOP\n");
    client.change(folder.uri("a.csp"), "include \"\\xff.csp\"\n");
    EXPECT_EQ(client.codes(folder.uri("a.csp")), "CSPM-P15@1");
}

/// The analysis ends when the text changes, and restarts for the new text.
TEST(Scripts, AnAnalysisEndsWhenTheTextChanges) {
    Client client;
    std::string large;
    for (int i = 0; i < 20000; ++i) large += "P" + std::to_string(i) + " = STOP\n";
    client.open(script_uri, "Q = STOP\n");
    const Json document = Json::object({{"uri", script_uri}, {"version", 7}});
    const Json change =
        Json::object({{"jsonrpc", "2.0"},
                      {"method", "textDocument/didChange"},
                      {"params", Json::object({{"textDocument", document}, {"contentChanges", Json::array()}})}});
    client.change(script_uri, large + "Q = Lost\n");
    ASSERT_EQ(client.codes(script_uri), "CSPM-T01@20001");
    client.server().receive_message(json_text(Json::object(
        {{"jsonrpc", "2.0"},
         {"method", "textDocument/didChange"},
         {"params",
          Json::object({{"textDocument", document},
                        {"contentChanges", Json::array({Json::object({{"text", large + "Q = Gone\n\n"}})})}})}})));
    client.server().handle_next();
    client.server().interruption().note_arrival(change);  // received, not yet handled
    const std::size_t before = client.messages.size();
    client.server().use_idle_time();
    EXPECT_EQ(client.messages.size(), before) << "an old text is not diagnosed";
    client.raw(json_text(change));
    EXPECT_NE(client.diagnostics(script_uri)[0]["message"].text().find("Gone"), std::string::npos);
}

TEST(Scripts, OfTenMegabytes) {
    Client client;
    const std::string comment = "-- " + std::string(1000, 'x') + "\n";
    std::string text = "channel c : {0..9}\n";
    for (int i = 0; text.size() < 10U << 20U; ++i)
        text += "P" + std::to_string(i) + "(x) = c!x -> (P" + std::to_string(i) + "(x) [] STOP)\n" + comment;
    text += "Q = Lost\n";
    client.open(script_uri, text);
    EXPECT_EQ(client.codes(script_uri).substr(0, 9), "CSPM-T01@");
    EXPECT_NE(hovered(client, script_uri, 1, 0), "");
}

}  // namespace
}  // namespace robochart::lsp
