// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/certificates.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "checker/certify/certificate.hpp"

namespace robochart::driver {
namespace {

/// The certificates of all assertions. Sets the reason in the report if there is not one for each of them.
std::vector<certify::Certificate> make_certificates(cspm::Session& session, const CertifiedClaim& claim,
                                                    const SearchContext& search, CertificateReport& report) {
    const std::string source = claim.place.empty() ? claim.title : fmt::format("{} ({})", claim.title, claim.place);
    std::vector<certify::Certificate> result;
    for (const cspm::Decl* const assertion : claim.assertions) {
        certify::CertificateResult one =
            certify::make_certificate(session, *assertion, source, limits_of_check(search, claim.title));
        if (!one.certificate) {
            report.reason = one.reason;
            return {};
        }
        result.push_back(std::move(*one.certificate));
    }
    return result;
}

}  // namespace

CertificateReport write_certificates(cspm::Session& session, const CertifiedClaim& claim, const SearchContext& search) {
    CertificateReport report;
    std::vector<certify::Certificate> certificates;
    try {
        certificates = make_certificates(session, claim, search, report);
    } catch (const cspm::EvaluationError& error) {
        report.reason = error.what();
    } catch (const std::bad_alloc&) {
        report.reason = "out of memory";
    }
    const std::string& root = search.settings.claims.certificates;
    for (std::size_t i = 0; i < certificates.size(); ++i) {
        const std::string number = certificates.size() == 1 ? claim.number : fmt::format("{}.{}", claim.number, i + 1);
        const std::string folder = certify::folder_name(number, claim.title);
        const std::string error = certify::write_certificate(root, folder, certificates[i], &search.services.budget());
        if (!error.empty()) return {{}, error, true};
        report.folders.push_back((std::filesystem::path(root) / folder).string());
    }
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

std::string certificate_text(const CertificateReport& report) {
    if (report.folders.empty())
        return fmt::format("no certificate: {}", diagnostics::escape_for_display(report.reason));
    std::string folders;
    for (const std::string& folder : report.folders)
        folders += (folders.empty() ? "" : ", ") + diagnostics::escape_for_display(folder);
    return fmt::format("certificate {} (product level, unreduced; robochart-certify accepts or refuses it)", folders);
}

}  // namespace robochart::driver
