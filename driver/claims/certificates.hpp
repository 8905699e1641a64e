// SPDX-License-Identifier: Apache-2.0
// Writes the certificates of claims that hold (docs/certificates.md).
#pragma once

#include <string>
#include <vector>

#include "checker/cspm/session.hpp"
#include "driver/results/results.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// A claim for which certificates are written.
struct CertifiedClaim {
    std::string number;  ///< the number of the claim, which the names of folders contain
    std::string title;
    std::string place;
    std::vector<const cspm::Decl*> assertions;  ///< all of them hold, and together they are the claim
};

/// Writes a certificate for each assertion of a claim that holds, into the folder that the settings name. Writes none
/// if one assertion has no certificate. Then checks them with robochart-certify, if this program is in the folder of
/// the current one or in PATH.
[[nodiscard]] CertificateReport write_certificates(cspm::Session&, const CertifiedClaim&, const SearchContext&);

/// Returns an error message if the folder contains files, and "" if it is empty or does not exist. Without this check,
/// certificates of earlier runs could be mistaken for those of this run.
[[nodiscard]] std::string why_not_empty(const std::string& folder);

/// Returns one line about the certificates. The line contains "certified" and the level only if robochart-certify has
/// accepted all certificates.
[[nodiscard]] std::string certificate_text(const CertificateReport&);

}  // namespace robochart::driver
