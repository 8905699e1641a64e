// SPDX-License-Identifier: Apache-2.0
// Writes the certificates of claims that hold (docs/certificates.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "checker/certify/certificate.hpp"
#include "checker/cspm/session.hpp"
#include "driver/results/results.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// A claim for which certificates are written.
struct CertifiedClaim {
    std::string number;  ///< the number of the claim, which the names of folders contain
    std::string title;
    std::string place;
    std::vector<const cspm::Decl*> assertions;     ///< all of them hold
    std::vector<certify::StaysPossible> possible;  ///< all of them hold; the rest of the claim
};

/// Writes a certificate for each part of a claim that holds, into the folder that the settings name. Writes no
/// certificate if one part has none. Then checks the certificates with robochart-certify, if this program is in the
/// folder of the current program or in PATH.
[[nodiscard]] CertificateReport write_certificates(cspm::Session&, const CertifiedClaim&, const SearchContext&);

/// Writes a certificate to its folder below `root`. If the program robochart-certify is found, this program then checks
/// the certificate.
[[nodiscard]] CertificateReport write_certificate(const std::string& root, const std::string& folder,
                                                  const certify::Certificate&, diagnostics::Budget&);

/// Returns an error message if the folder contains files. Returns "" if the folder is empty or does not exist. This
/// check prevents certificates of earlier runs from being taken for certificates of this run.
[[nodiscard]] std::string why_not_empty(const std::string& folder);

/// Returns one line about the certificates of a claim. The line contains the verdict, "certified" and the level only if
/// robochart-certify has accepted all certificates.
[[nodiscard]] std::string certificate_text(const CertificateReport&, std::string_view verdict = "holds");

}  // namespace robochart::driver
