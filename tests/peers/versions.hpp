// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The versions of the libraries that a contest is played with: each says its own where its headers are included.
///
///     static const peers::Version version("FCL", FCL_VERSION);

#include <map>
#include <string>
#include <utility>

namespace peers {

/// By the libraries' names.
inline std::map<std::string, std::string>& versions() {
    static std::map<std::string, std::string> all;
    return all;
}
/// Tells one, before main begins.
struct Version {
    Version(const std::string& library, std::string version) { versions()[library] = std::move(version); }
};

} // namespace peers
