// SPDX-License-Identifier: Apache-2.0
// Writes certificates of assertions that hold (docs/certificates.md). A certificate contains a claim and the compiled,
// unreduced processes of that claim. A separate program, which is proved correct in Coq, searches them for a proof and
// accepts or rejects the certificate (checker/certify/certifier). Errors in this code cannot make it accept a false
// claim.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/diagnostics/budget.hpp"
#include "checker/cspm/session.hpp"

namespace robochart::certify {

/// The contents of the files of a certificate.
struct Certificate {
    std::string claim;           ///< claim.txt
    std::string specification;   ///< specification.txt; "" for a property of one process
    std::string implementation;  ///< implementation.txt
};

/// A certificate, or the reason why there is no certificate.
struct CertificateResult {
    std::optional<Certificate> certificate;
    std::string reason;  ///< "" if there is a certificate
};

/// Compiles the processes of an assertion again, without minimisation, and returns a certificate. Does not check that
/// the assertion holds. The certificate quotes `source`, which names the claim and its place. Throws evaluation errors.
[[nodiscard]] CertificateResult make_certificate(cspm::Session& session, const cspm::Decl& assertion,
                                                 const std::string& source, const refine::Limits& limits);

/// Writes a certificate to a folder below `root`. The claim contains the digests of the other files and is written
/// last. So if a run is stopped, its incomplete folder cannot pass as a certificate. Returns "" on success, and the
/// cause of the failure otherwise.
[[nodiscard]] std::string write_certificate(const std::string& root, const std::string& folder,
                                            const Certificate& certificate, diagnostics::Budget* budget);

/// Returns the name for the folder of a certificate: the number, and the letters and digits of the title.
[[nodiscard]] std::string folder_name(const std::string& number, const std::string& title);

}  // namespace robochart::certify
