// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/certificates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/programs.hpp"

namespace robochart::driver {
namespace {

/// Returns a certificate for each part of the claim. If a part has no certificate, the report gets the reason.
std::vector<certify::Certificate> make_certificates(cspm::Session& session, const CertifiedClaim& claim,
                                                    const SearchContext& search, CertificateReport& report) {
    const std::string source = claim.place.empty() ? claim.title : fmt::format("{} ({})", claim.title, claim.place);
    std::vector<certify::Certificate> result;
    const auto add = [&](const auto& part) {
        certify::CertificateResult one =
            certify::make_certificate(session, part, source, limits_of_check(search, claim.title));
        report.reason = one.reason;
        if (!one.certificate) return false;
        if (report.why_product.empty()) report.why_product = one.certificate->why_product;
        result.push_back(std::move(*one.certificate));
        return true;
    };
    const bool complete =
        std::ranges::all_of(claim.assertions, [&](const cspm::Decl* const assertion) { return add(*assertion); }) &&
        std::ranges::all_of(claim.possible, add);
    if (!complete) result.clear();
    report.level = certify::level_name(report.why_product.empty() ? certify::Level::term : certify::Level::product);
    return result;
}

/// Returns the path of the program that checks certificates if it is in the folder of this program. Otherwise, returns
/// its name, which is looked up in PATH.
std::string certifier_path() {
    const std::string name = "robochart-certify";
    std::error_code code;
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", code);
    const std::filesystem::path beside = own.parent_path() / name;
    return !code && std::filesystem::is_regular_file(beside, code) ? beside.string() : name;
}

/// Parses the answer of `robochart-certify --answer`. It is a word, and then a reason, or numbers and the reduction (if
/// the search was reduced). Adds the answer to the report.
void add_answer(const std::string& answer, CertificateReport& report) {
    std::istringstream words(answer);
    std::string word;
    std::uint64_t pairs = 0;
    std::uint64_t components = 0;
    words >> word;
    if (word == "certified" && words >> pairs >> components) {
        report.pairs += pairs;
        report.components += components;
        std::string reduction;
        std::getline(words >> std::ws, reduction);
        if (report.reduction.empty()) report.reduction = reduction;
        return;
    }
    std::string reason;
    std::getline(words >> std::ws, reason);
    report.certification = word == "refused" ? Certification::refused : Certification::unchecked;
    report.reason = reason.empty() ? "robochart-certify did not answer" : reason;
}

/// Runs robochart-certify on a certificate, within the limits of the run.
void check_certificate(const std::string& folder, diagnostics::Budget& budget, CertificateReport& report) {
    std::string error;
    const diagnostics::TemporaryFolder work("", error, &budget);
    const std::string log = work.path() + "/log";
    int status = -1;
    try {
        if (error.empty())
            status = diagnostics::run_program({certifier_path(), "--answer", folder}, log, error, &budget);
    } catch (const diagnostics::LimitReached& limit) {
        error = limit.what();
    }
    if (status < 0) {
        report.certification = Certification::unchecked;
        report.reason = error;
        return;
    }
    std::string answer;
    std::ifstream file(log, std::ios::binary);
    std::getline(file, answer);
    add_answer(answer, report);
}

/// Writes a certificate to its folder below `root`, and adds the folder to the report. Returns "" on success, and the
/// cause of the failure otherwise.
std::string store(const std::string& root, const std::string& folder, const certify::Certificate& certificate,
                  diagnostics::Budget& budget, CertificateReport& report) {
    std::string error = certify::write_certificate(root, folder, certificate, &budget);
    if (error.empty()) report.folders.push_back((std::filesystem::path(root) / folder).string());
    return error;
}

/// Runs robochart-certify on all certificates of the report, until one is not certified.
void check_certificates(diagnostics::Budget& budget, CertificateReport& report) {
    report.certification = Certification::certified;
    for (const std::string& folder : report.folders) {
        check_certificate(folder, budget, report);
        if (report.certification != Certification::certified) break;
    }
    report.failed = report.certification == Certification::refused;
}

}  // namespace

CertificateReport write_certificates(cspm::Session& session, const CertifiedClaim& claim, const SearchContext& search) {
    CertificateReport report;
    std::vector<certify::Certificate> certificates;
    // The search may have used up the claim's turn. Only the limits of the run apply here.
    const SearchContext of_run{search.settings, search.services};
    try {
        certificates = make_certificates(session, claim, of_run, report);
    } catch (const cspm::EvaluationError& error) {
        report.reason = error.what();
    } catch (const std::bad_alloc&) {
        report.reason = "out of memory";
    }
    const std::string& root = search.settings.claims.certificates;
    for (std::size_t i = 0; i < certificates.size(); ++i) {
        const std::string number = certificates.size() == 1 ? claim.number : fmt::format("{}.{}", claim.number, i + 1);
        const std::string folder = certify::folder_name(number, claim.title);
        const std::string error = store(root, folder, certificates[i], search.services.budget(), report);
        if (!error.empty()) return {{}, error, true};
    }
    if (!report.folders.empty()) check_certificates(search.services.budget(), report);
    return report;
}

CertificateReport write_certificate(const std::string& root, const std::string& folder,
                                    const certify::Certificate& certificate, diagnostics::Budget& budget) {
    CertificateReport report;
    report.level = certify::level_name(certificate.level);
    const std::string error = store(root, folder, certificate, budget, report);
    if (!error.empty()) return {{}, error, true};
    check_certificates(budget, report);
    return report;
}

std::string why_not_empty(const std::string& folder) {
    std::error_code code;
    const std::filesystem::directory_iterator entries(folder, code);
    if (code == std::errc::no_such_file_or_directory) return "";
    if (code) return fmt::format("{}: {}", diagnostics::escape_for_display(folder), code.message());
    if (entries == std::filesystem::directory_iterator()) return "";
    return fmt::format("{} is not empty; certificates of earlier runs must not be taken for those of this run",
                       diagnostics::escape_for_display(folder));
}

namespace {

/// Formats a number and its unit, with a comma after each group of three digits: "1,200 pairs".
std::string counted(std::uint64_t number, const std::string& noun) {
    std::string digits = std::to_string(number);
    for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
    return fmt::format("{} {}{}", digits, noun, number == 1 ? "" : "s");
}

std::string pairs_text(const CertificateReport& report) {
    const std::string pairs = counted(report.pairs, "pair");
    if (report.reduction.empty()) return "unreduced, " + pairs;
    return fmt::format("{}, reduced by {}", pairs, diagnostics::escape_for_display(report.reduction));
}

}  // namespace

std::string certificate_text(const CertificateReport& report, std::string_view verdict) {
    if (report.folders.empty())
        return fmt::format("no certificate: {}", diagnostics::escape_for_display(report.reason));
    std::string folders;
    for (const std::string& folder : report.folders)
        folders += (folders.empty() ? "" : ", ") + diagnostics::escape_for_display(folder);
    switch (report.certification) {
        case Certification::unchecked:
            return fmt::format("certificate {}, not checked: {}", folders,
                               diagnostics::escape_for_display(report.reason));
        case Certification::certified:
            return fmt::format("{} (certified: {} level, {}, {}{}); certificate {}", verdict, report.level,
                               pairs_text(report), counted(report.components, "component"),
                               report.why_product.empty()
                                   ? ""
                                   : fmt::format("; not at the term level, because {}",
                                                 diagnostics::escape_for_display(report.why_product)),
                               folders);
        case Certification::refused:
            return fmt::format("certificate {}, REFUSED by robochart-certify: {}", folders,
                               diagnostics::escape_for_display(report.reason));
    }
    assert(false);
    return "";
}

}  // namespace robochart::driver
