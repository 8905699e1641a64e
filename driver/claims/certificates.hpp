// SPDX-License-Identifier: Apache-2.0
// Writes the certificates of claims that hold (docs/certificates.md).
#pragma once

#include <string>
#include <vector>

#include "checker/cspm/session.hpp"
#include "driver/results/results.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// A claim that certificates are written for.
struct CertifiedClaim {
    std::string number;  ///< the number of the claim, which the names of folders contain
    std::string title;
    std::string place;
    std::vector<const cspm::Decl*> assertions;  ///< all of them hold, and together they are the claim
};

/// Writes a certificate for each assertion of a claim that holds, to the folder that the settings name. If one of them
/// has no certificate, none is written. The program robochart-certify then checks them, if it is in the folder of this
/// program or in PATH.
[[nodiscard]] CertificateReport write_certificates(cspm::Session&, const CertifiedClaim&, const SearchContext&);

/// Returns an error message if the folder contains files, "" if it is empty or does not exist. This prevents
/// certificates of earlier runs from being taken for certificates of this run.
[[nodiscard]] std::string why_not_empty(const std::string& folder);

/// Returns one line about the certificates. It contains "certified" and the level only if robochart-certify has
/// accepted all of them.
[[nodiscard]] std::string certificate_text(const CertificateReport&);

}  // namespace robochart::driver
