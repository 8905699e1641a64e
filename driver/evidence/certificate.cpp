// SPDX-License-Identifier: Apache-2.0
// See certificate.hpp. Reads certificates as untrusted input, because anybody may have changed them.
#include "driver/evidence/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>
#include <stdexcept>

#include "base/cache/digest.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/json_values.hpp"

namespace robochart::driver {

using diagnostics::Json;
using diagnostics::json_array;

std::string content_digest(std::string_view text) {
    diagnostics::Hasher hasher;
    hasher.add(text);
    std::string hex;
    for (const std::uint8_t byte : hasher.finish()) hex += fmt::format("{:02x}", byte);
    return hex;
}

namespace {

constexpr const char* schema = "robochart-verify/certificate/1";
constexpr std::size_t most_bytes = 16U << 20U;

using Pairs = std::vector<std::pair<std::string, std::string>>;

Json pairs_json(const Pairs& pairs, const char* first, const char* second) {
    return json_array(pairs, [&](const auto& pair) -> Json { return {{first, pair.first}, {second, pair.second}}; });
}

Json item_json(const DecidedItem& item) {
    return {{"subject", item.subject}, {"answer", item.answer}};
}

Json claim_json(const DecidedClaim& claim) {
    return {{"claim", claim.claim},         {"answer", claim.answer}, {"trials", claim.trials},
            {"successes", claim.successes}, {"low", claim.low},       {"high", claim.high}};
}

Json certificate_json(const Certificate& certificate) {
    const SearchRecord& search = certificate.search;
    const Evidence& evidence = certificate.evidence;
    return {{"schema", schema},
            {"program", certificate.program},
            {"build", certificate.build},
            {"run", Json::parse(certificate.run)},
            {"scenario", evidence.scenario},
            {"scenarioDigest", evidence.scenario_digest},
            {"model", pairs_json(evidence.model, "file", "digest")},
            {"constants", pairs_json(certificate.constants, "name", "value")},
            {"ranges", certificate.ranges},
            {"search",
             {{"parameters", pairs_json(search.parameters, "name", "values")},
              {"budget", search.budget},
              {"seed", search.seed},
              {"test", search.test},
              {"trials", search.trials},
              {"candidates", search.candidates},
              {"firstSeed", search.first_seed},
              {"seeds", search.seeds},
              {"cost", search.cost}}},
            {"assertions", json_array(evidence.assertions, item_json)},
            {"conformance", json_array(evidence.conformance, item_json)},
            {"seed", evidence.seed},
            {"claims", json_array(evidence.claims, claim_json)}};
}

/// Thrown if a certificate is malformed.
class Malformed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A JSON object all of whose fields must be read exactly once. A field that is not read is an error.
class Fields {
public:
    Fields(const Json& value, std::string where) : value_(value), where_(std::move(where)) {
        if (!value.is_object()) throw Malformed(fmt::format("{} is no object", where_));
    }

    const Json& operator[](const char* name) {
        const auto found = value_.find(name);
        if (found == value_.end()) throw Malformed(fmt::format("{} has no {}", where_, name));
        asked_.insert(name);
        return *found;
    }

    std::string read_text(const char* name) {
        return check_field(name, (*this)[name].is_string(), "text").get<std::string>();
    }
    std::uint64_t read_whole(const char* name) {
        return check_field(name, (*this)[name].is_number_unsigned(), "whole number").get<std::uint64_t>();
    }
    double read_number(const char* name) {
        return check_field(name, (*this)[name].is_number(), "number").get<double>();
    }

    /// Applies `read` to each value of a list.
    template <typename Read>
    auto read_list(const char* name, Read read) {
        const Json& values = check_field(name, (*this)[name].is_array(), "list");
        std::vector<decltype(read(values))> result;
        for (const Json& value : values) result.push_back(read(value));
        return result;
    }

    void end() const {
        for (const auto& [name, value] : value_.items())
            if (!asked_.contains(name)) throw Malformed(fmt::format("{} has '{}', which is unknown", where_, name));
    }

private:
    const Json& check_field(const char* name, bool good, const char* kind) {
        if (!good) throw Malformed(fmt::format("{} of {} is no {}", name, where_, kind));
        return (*this)[name];
    }

    const Json& value_;
    std::string where_;
    std::set<std::string> asked_;
};

Pairs read_pairs(Fields& from, const char* name, const char* first, const char* second) {
    return from.read_list(name, [&](const Json& value) {
        Fields fields(value, name);
        std::pair<std::string, std::string> result{fields.read_text(first), fields.read_text(second)};
        fields.end();
        return result;
    });
}

std::vector<DecidedItem> read_items(Fields& from, const char* name) {
    return from.read_list(name, [&](const Json& value) {
        Fields fields(value, name);
        DecidedItem result{fields.read_text("subject"), fields.read_text("answer")};
        fields.end();
        return result;
    });
}

DecidedClaim read_claim(const Json& value) {
    Fields fields(value, "claims");
    DecidedClaim result{fields.read_text("claim"),      fields.read_text("answer"), fields.read_whole("trials"),
                        fields.read_whole("successes"), fields.read_number("low"),  fields.read_number("high")};
    fields.end();
    return result;
}

SearchRecord read_search(const Json& value) {
    Fields fields(value, "search");
    SearchRecord result;
    result.parameters = read_pairs(fields, "parameters", "name", "values");
    result.budget = fields.read_whole("budget");
    result.seed = fields.read_whole("seed");
    result.test = fields.read_text("test");
    result.trials = fields.read_whole("trials");
    result.candidates = fields.read_whole("candidates");
    result.first_seed = fields.read_whole("firstSeed");
    result.seeds = fields.read_whole("seeds");
    result.cost = fields.read_number("cost");
    fields.end();
    return result;
}

Certificate read_fields(const Json& json) {
    Fields fields(json, "the certificate");
    if (fields.read_text("schema") != schema) throw Malformed(fmt::format("its schema is not {}", schema));
    Certificate result;
    result.program = fields.read_text("program");
    result.build = fields.read_text("build");
    const Json& run = fields["run"];
    if (!run.is_object()) throw Malformed("run of the certificate is no object");
    result.run = diagnostics::json_text(run);
    result.evidence.scenario = fields.read_text("scenario");
    result.evidence.scenario_digest = fields.read_text("scenarioDigest");
    result.evidence.model = read_pairs(fields, "model", "file", "digest");
    result.constants = read_pairs(fields, "constants", "name", "value");
    result.ranges = fields.read_list("ranges", [](const Json& value) {
        if (!value.is_string()) throw Malformed("a range is no text");
        return value.get<std::string>();
    });
    result.search = read_search(fields["search"]);
    result.evidence.assertions = read_items(fields, "assertions");
    result.evidence.conformance = read_items(fields, "conformance");
    result.evidence.seed = fields.read_whole("seed");
    result.evidence.claims = fields.read_list("claims", read_claim);
    const std::string digest = fields.read_text("digest");
    fields.end();
    if (digest != content_digest(diagnostics::json_text(certificate_json(result))))
        throw Malformed("its digest is not that of its contents: it was changed");
    return result;
}

void add_item_differences(const char* what, const std::vector<DecidedItem>& certified,
                          const std::vector<DecidedItem>& found, std::vector<std::string>& lines) {
    const auto without = [&](const DecidedItem& one, const std::vector<DecidedItem>& all) {
        return std::ranges::none_of(all, [&](const DecidedItem& other) { return other.subject == one.subject; });
    };
    for (const DecidedItem& one : certified) {
        if (without(one, found)) lines.push_back(fmt::format("{}: {} is not there", what, one.subject));
        for (const DecidedItem& other : found)
            if (other.subject == one.subject && other.answer != one.answer)
                lines.push_back(fmt::format("{}: {}: {}, certified: {}", what, one.subject, other.answer, one.answer));
    }
    for (const DecidedItem& other : found)
        if (without(other, certified)) lines.push_back(fmt::format("{}: {} is not certified", what, other.subject));
    if (certified.size() != found.size())
        lines.push_back(fmt::format("{}: {} of them, certified: {}", what, found.size(), certified.size()));
}

std::string claim_text(const DecidedClaim& claim) {
    return fmt::format("{} {} ({} of {} trials, between {} and {})", claim.claim, claim.answer, claim.successes,
                       claim.trials, claim.low, claim.high);
}

}  // namespace

std::string certificate_text(const Certificate& certificate) {
    Json json = certificate_json(certificate);
    json["digest"] = content_digest(diagnostics::json_text(json));
    return diagnostics::json_text(json, 2) + "\n";
}

namespace {

/// Rejects duplicate keys, because different readers would use different values.
Json parse_once(std::string_view text, std::string& twice) {
    std::vector<std::set<std::string>> open;
    const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::object_start) open.emplace_back();
        if (event == Json::parse_event_t::object_end) open.pop_back();
        if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second)
            twice = parsed.get<std::string>();
        return true;
    };
    return Json::parse(text, watch, false);
}

}  // namespace

std::optional<Certificate> read_certificate(std::string_view text, std::string& error) {
    if (text.size() > most_bytes) {
        error = "it is longer than 16 MiB";
        return std::nullopt;
    }
    std::string twice;
    const Json json = parse_once(text, twice);
    if (json.is_discarded()) {
        error = "it is no JSON";
        return std::nullopt;
    }
    if (!twice.empty()) {
        error =
            fmt::format("it has the key `{}` twice", diagnostics::escape_for_display(diagnostics::ForeignText(twice)));
        return std::nullopt;
    }
    try {
        return read_fields(json);
    } catch (const Malformed& wrong) {
        error = wrong.what();
        return std::nullopt;
    }
}

std::vector<std::string> evidence_differences(const Evidence& certified, const Evidence& found) {
    std::vector<std::string> lines;
    if (certified.scenario != found.scenario)
        lines.push_back(fmt::format("scenario: {}, certified: {}", found.scenario, certified.scenario));
    if (certified.scenario_digest != found.scenario_digest)
        lines.emplace_back("scenario: its text is not the one that is certified");
    const auto in = [](const Evidence::Files& files, const std::string& name) {
        return std::ranges::any_of(files, [&](const auto& file) { return file.first == name; });
    };
    for (const auto& file : certified.model)
        if (std::ranges::find(found.model, file) == found.model.end())
            lines.push_back(
                fmt::format("model: {} {}", file.first,
                            in(found.model, file.first) ? "is not the one that is certified" : "is not there"));
    for (const auto& file : found.model)
        if (!in(certified.model, file.first)) lines.push_back(fmt::format("model: {} is not certified", file.first));
    if (certified.model.size() != found.model.size() && lines.empty())
        lines.emplace_back("model: it has another number of files");
    add_item_differences("assertion", certified.assertions, found.assertions, lines);
    add_item_differences("conformance", certified.conformance, found.conformance, lines);
    if (certified.seed != found.seed)
        lines.push_back(fmt::format("claims: seed {}, certified: {}", found.seed, certified.seed));
    if (certified.claims.size() != found.claims.size())
        lines.push_back(fmt::format("claims: {} of them, certified: {}", found.claims.size(), certified.claims.size()));
    for (std::size_t c = 0; c < std::min(certified.claims.size(), found.claims.size()); ++c)
        if (certified.claims[c] != found.claims[c])
            lines.push_back(
                fmt::format("claim: {}, certified: {}", claim_text(found.claims[c]), claim_text(certified.claims[c])));
    return lines;
}

}  // namespace robochart::driver
