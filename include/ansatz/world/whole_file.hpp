// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Writes a file whole or not at all, so that a disk that is full does not take the last good state with it. save.hpp
/// writes worlds with it; it is no interface of its own. Not provided: that the file outlives a power cut, which only
/// the operating system can promise.

// not in the umbrella: it is a part of save.hpp, which includes it

#include <ansatz/core/error.hpp>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace ansatz::detail {

/// "save: <path> <what>: <the system's reason>"
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse_file(const std::filesystem::path& path, const char* what,
                                                               const std::error_code& why) {
    std::string sentence("save: ");
    sentence.append(path.string()).append(" ").append(what);
    if (why) sentence.append(": ").append(why.message());
    refuse(Refusal::invalid_argument, sentence);
}

/// Writes into a file that may be lost, and says whether it is there to its last byte.
inline std::error_code write_file(const std::filesystem::path& path, const std::string& text, const char*& what) {
    const auto reason = [] { return std::error_code(errno == 0 ? EIO : errno, std::generic_category()); };
    errno = 0;
    what = "cannot be opened for writing";
    std::ofstream out(path, std::ios::binary);
    if (!out) return reason();
    what = "could not be written to the end";
    out.write(text.data(), std::streamsize(text.size()));
    if (!out) return reason();
    out.close(); // what the stream still holds is written now, or not at all
    return out ? std::error_code() : reason();
}

/// The text is written beside the file, which it replaces when it is complete. What a link names is replaced, not the
/// link, and what is no file on a disk, /dev/stdout for one, is written to as it is.
/// \throws std::invalid_argument with the path and the system's reason; what was there is there as before
inline void write_whole_file(const std::string& path, const std::string& text) {
    namespace fs = std::filesystem;
    std::error_code why;
    const char* what = nullptr;
    fs::path target = path;
    if (const auto there = fs::status(target, why); fs::exists(there)) {
        if (!fs::is_regular_file(there)) {
            if ((why = write_file(target, text, what))) refuse_file(target, what, why);
            return;
        }
        target = fs::canonical(target, why);
        if (why) refuse_file(path, "cannot be opened for writing", why);
    }
    fs::path beside = target;
    beside += ".part";
    why = write_file(beside, text, what);
    if (!why) {
        what = "could not be replaced";
        std::error_code no_matter;
        if (const auto before = fs::status(target, no_matter); fs::exists(before))
            fs::permissions(beside, before.permissions(), no_matter);
        fs::rename(beside, target, why);
    }
    if (!why) return;
    std::error_code no_matter;
    fs::remove(beside, no_matter);
    refuse_file(path, what, why);
}

} // namespace ansatz::detail
