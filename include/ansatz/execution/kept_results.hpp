// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The file in which an ensemble keeps its results as they come, and a result as bytes.
// not in the umbrella: it is a part of ensemble.hpp
///
/// One line of text that says whose results they are, then a record for each result: its index, how many bytes it has,
/// the bytes, and a checksum. A record is appended and flushed when its run has ended, so that what ends the program
/// ends at most the last record; a torn one is cut off when the file is read again, and its run is done anew. The bytes
/// are those of this machine's numbers: a file is for programs of one compiler and kind of machine, which its line
/// says.

#include <ansatz/core/error.hpp>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view> // and with it std::ranges::enable_borrowed_range
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz::detail {

/// Whether a value is where others are, and not those themselves: its bytes mean nothing to another program.
template <class T>
inline constexpr bool points_elsewhere =
    std::is_pointer_v<T> || std::is_member_pointer_v<T> || std::ranges::enable_borrowed_range<T>; // a view of a text

/// A result as bytes and back: trivially copyable values, vectors of them, and text. `known` is false for others.
template <class T> struct BytesOf {
    static constexpr bool known =
        std::is_trivially_copyable_v<T> && std::is_default_constructible_v<T> && !points_elsewhere<T>;
    static std::string write(const T& value) {
        std::string bytes(sizeof(T), '\0');
        std::memcpy(bytes.data(), &value, sizeof(T));
        return bytes;
    }
    static T read(const std::string& bytes) {
        if (bytes.size() != sizeof(T))
            refuse_value("ensemble", "the size of a result", std::to_string(bytes.size()) + " bytes",
                         joined({"a result has ", std::to_string(sizeof(T)), "; the run gave back another type once"}));
        T value{};
        std::memcpy(static_cast<void*>(&value), bytes.data(), sizeof(T));
        return value;
    }
};
template <> struct BytesOf<std::string> {
    static constexpr bool known = true;
    static const std::string& write(const std::string& text) { return text; }
    static const std::string& read(const std::string& bytes) { return bytes; }
};
template <class T>
    requires(BytesOf<T>::known && std::is_trivially_copyable_v<T> && !std::is_same_v<T, bool>)
struct BytesOf<std::vector<T>> {
    static constexpr bool known = true;
    static std::string write(const std::vector<T>& values) {
        std::string bytes(values.size() * sizeof(T), '\0');
        if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
        return bytes;
    }
    static std::vector<T> read(const std::string& bytes) {
        if (bytes.size() % sizeof(T) != 0)
            refuse_value(
                "ensemble", "the size of a result", std::to_string(bytes.size()) + " bytes",
                joined({"it is a multiple of ", std::to_string(sizeof(T)), "; the run gave back another type once"}));
        std::vector<T> values(bytes.size() / sizeof(T));
        if (!values.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
        return values;
    }
};

/// FNV-1a, 64 bit: http://www.isthe.com/chongo/tech/comp/fnv/
class Fnv {
public:
    void add(const void* data, std::size_t size) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t i = 0; i < size; ++i) hash_ = (hash_ ^ bytes[i]) * 0x100000001b3ULL;
    }
    std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};
/// Adds what tells a number from others. A long double may have bytes that are no part of the number.
template <class Number> void add_number(Fnv& fnv, Number number) {
    if constexpr (std::is_same_v<Number, long double>)
        for (int part = 0; part < 3; ++part) {
            const auto digits = double(number);
            fnv.add(&digits, sizeof digits);
            number -= digits;
        }
    else fnv.add(&number, sizeof number);
}
/// What tells parameters apart that are numbers; 0 for others.
template <class Parameter> std::uint64_t fingerprint(const std::vector<Parameter>& parameters) {
    Fnv fnv;
    if constexpr (std::is_arithmetic_v<Parameter>) {
        for (const Parameter parameter : parameters) add_number(fnv, parameter);
        return fnv.value();
    } else return 0;
}

/// The file of one ensemble.
class KeptResults {
public:
    /// Opens the file, or begins it.
    /// \throws std::invalid_argument if it is another ensemble's, or cannot be read or written
    KeptResults(std::filesystem::path path, const std::string& name, std::size_t count, std::uint64_t parameters)
        : path_(std::move(path)), count_(count) {
        std::ostringstream line;
        line << "ansatz-ensemble 1 " << (std::endian::native == std::endian::little ? "little" : "big") << ' ' << count
             << " runs, parameters " << std::hex << parameters << ", ";
        for (const char c : name) line << (c == '\n' || c == '\r' ? ' ' : c);
        line << '\n';
        header_ = line.str();
        if (begun_line() == header_) return;
        std::ofstream begun(path_, std::ios::binary | std::ios::trunc);
        begun << header_ << std::flush;
        if (!begun) cannot("written");
    }

    /// Calls `have(index, bytes)` for each result that is there, and cuts off what was torn.
    void read(const auto& have) {
        std::ifstream in(path_, std::ios::binary);
        in.seekg(std::streamoff(header_.size()));
        if (!in) cannot("read");
        auto whole = std::uintmax_t(header_.size());
        std::error_code failed;
        const std::uintmax_t size = std::filesystem::file_size(path_, failed);
        if (failed) cannot("read", failed); // it is no file, but a device
        std::string bytes;
        std::uint64_t head[2]{}, sum = 0;
        while (in.read(reinterpret_cast<char*>(head), sizeof head)) {
            if (head[1] > size - whole) break;
            bytes.resize(std::size_t(head[1]));
            if (!in.read(bytes.data(), std::streamsize(bytes.size())) ||
                !in.read(reinterpret_cast<char*>(&sum), sizeof sum))
                break;
            if (head[0] >= count_ || sum != checksum(head, bytes)) break;
            have(std::size_t(head[0]), bytes);
            whole += sizeof head + bytes.size() + sizeof sum;
        }
        in.close();
        if (whole < size) std::filesystem::resize_file(path_, whole, failed);
        if (failed) cannot("written", failed);
        out_.open(path_, std::ios::binary | std::ios::app);
        if (!out_) cannot("written");
    }

    /// Adds a result; it is on its way to the disk when this returns.
    void append(std::size_t index, const std::string& bytes) {
        const std::uint64_t head[2]{index, bytes.size()}, sum = checksum(head, bytes);
        out_.write(reinterpret_cast<const char*>(head), sizeof head);
        out_.write(bytes.data(), std::streamsize(bytes.size()));
        out_.write(reinterpret_cast<const char*>(&sum), sizeof sum);
        if (!out_.flush()) cannot("written");
    }

private:
    /// The first line of the file, as this ensemble writes it; empty where the file has still to be begun: it is not
    /// there, or what ended the program tore its first line.
    std::string begun_line() const {
        std::ifstream in(path_, std::ios::binary);
        std::string line(header_.size(), '\0');
        in.read(line.data(), std::streamsize(line.size()));
        line.resize(std::size_t(in.gcount()));
        if (line == header_) return line;
        std::error_code unknown; // whatever it is, the file cannot be written then
        if (std::filesystem::is_directory(path_, unknown))
            cannot("written", std::make_error_code(std::errc::is_a_directory));
        if (header_.compare(0, line.size(), line) == 0) return {};
        // Up to what no terminal shows: a sentence ends at a zero.
        other({line.begin(), std::find_if(line.begin(), line.end(), [](char c) { return c >= 0 && c < ' '; })});
    }
    static std::uint64_t checksum(const std::uint64_t (&head)[2], const std::string& bytes) {
        Fnv fnv;
        fnv.add(head, sizeof head);
        fnv.add(bytes.data(), bytes.size());
        return fnv.value();
    }
    [[noreturn]] void cannot(const char* what, const std::error_code& why = {errno, std::generic_category()}) const {
        refuse(Refusal::invalid_argument,
               joined({"ensemble: ", path_.string(), " cannot be ", what, ": ", why.message()}));
    }
    [[noreturn]] void other(const std::string& line) const {
        const bool ours = line.rfind("ansatz-ensemble ", 0) == 0;
        refuse(Refusal::invalid_argument,
               joined({"ensemble: ", path_.string(),
                       ours ? " keeps the results of another ensemble, '" : " is no file of results; it begins '",
                       line.substr(0, 100), "'; this one is '", header_.substr(0, header_.size() - 1),
                       "'; name another file, or remove it"}));
    }

    std::filesystem::path path_;
    std::size_t count_;
    std::string header_;
    std::ofstream out_;
};

} // namespace ansatz::detail
