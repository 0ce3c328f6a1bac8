// SPDX-License-Identifier: BSL-1.0
// Full disks and what else can go wrong with a file: the last good state is never lost (hard case V10).

#include <ansatz/world/whole_file.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"
#include "tests/scratch.hpp"
#include "tests/world/lives.hpp"

#include <ansatz/world/save.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <streambuf>
#include <string>

#if defined(__unix__)
#include <csignal>
#include <sys/resource.h>
#endif

using namespace ansatz;
using namespace ansatz::test;
namespace fs = std::filesystem;

namespace {

std::string text_in(const fs::path& path) {
    std::ostringstream out;
    out << std::ifstream(path).rdbuf();
    return out.str();
}

/// A folder of this process alone that goes with the test: others run beside it.
struct Folder {
    fs::path path = scratch_path("whole_file");
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    std::size_t files() const {
        return std::size_t(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
    }
};

/// A stream that takes so many bytes and no more.
struct Narrow : std::streambuf {
    std::size_t room;
    std::string taken;
    explicit Narrow(std::size_t n) : room(n) {}
    int_type overflow(int_type c) override {
        if (taken.size() == room) return traits_type::eof();
        taken += traits_type::to_char_type(c);
        return c;
    }
};

auto a_world(int steps) {
    auto world = eventful<Space<float, 2>, Verlet>();
    live(world, 0, steps);
    return world;
}

#if defined(__unix__)
/// No file of this process may grow beyond so many bytes: the next write fails as on a full disk.
class DiskOf {
public:
    explicit DiskOf(rlim_t bytes) {
        before_handler_ = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit now{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &now);
    }
    ~DiskOf() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, before_handler_);
    }
    DiskOf(const DiskOf&) = delete;

private:
    rlimit before_{};
    void (*before_handler_)(int) = SIG_DFL;
};
#endif

} // namespace

#if defined(__unix__)
TEST_CASE("a disk that is full after any number of bytes leaves the last saved state as it was", "[world][save][V10]") {
    const Folder folder;
    const auto path = folder.path / "game.json";
    const auto earlier = a_world(10), later = a_world(30);
    save(earlier, path.string());
    const auto good = text_in(path);
    std::ostringstream whole;
    save(later, whole);
    const auto size = whole.str().size();
    REQUIRE(size > 2000);
    for (std::size_t room = 0; room < size; room += room < 20 || room + 40 > size ? 1 : size / 60) {
        std::string sentence;
        {
            const DiskOf full(room);
            sentence = refusal([&] { save(later, path.string()); });
        }
        INFO(room << " of " << size << " bytes: " << sentence);
        CHECK(sentence.rfind("save: " + path.string() + " could not be written to the end: ", 0) == 0);
        CHECK(text_in(path) == good);
        CHECK(folder.files() == 1);
    }
    {
        const DiskOf just_enough(size);
        save(later, path.string());
    }
    CHECK(text_in(path) == whole.str());
    CHECK(folder.files() == 1);
}
#endif

TEST_CASE("a stream that takes any number of bytes but not all is told of", "[world][save][V10]") {
    const auto world = a_world(30);
    std::ostringstream whole;
    save(world, whole);
    const auto text = whole.str();
    for (std::size_t room = 0; room <= text.size(); room += room + 60 > text.size() ? 1 : text.size() / 50) {
        Narrow narrow(std::min(room, text.size()));
        std::ostream out(&narrow);
        const auto sentence = refusal([&] { save(world, out); });
        CHECK(sentence == (narrow.room < text.size() ? "save: the stream could not be written to the end" : "nothing"));
        CHECK(narrow.taken == text.substr(0, narrow.room));
    }
}

TEST_CASE("a file that takes the place of another keeps its rights, and a link stays a link", "[world][save][V10]") {
    const Folder folder;
    const auto file = folder.path / "game.json", link = folder.path / "latest.json";
    save(a_world(10), file.string());
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink(file, link);
    const auto later = a_world(30);
    save(later, link.string());
    CHECK(fs::is_symlink(link));
    CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
    auto loaded = a_world(0);
    load(loaded, file.string());
    CHECK(loaded.hash() == later.hash());
    CHECK(folder.files() == 2);
}

TEST_CASE("what cannot be written says which file and why", "[world][save][V10]") {
    const Folder folder;
    const auto world = a_world(3);
    auto said = [&](const fs::path& path) { return refusal([&] { save(world, path.string()); }); };
    const auto nowhere = folder.path / "no" / "such" / "folder.json";
    CHECK(said(nowhere) == "save: " + nowhere.string() + " cannot be opened for writing: No such file or directory");
    CHECK(said(folder.path) == "save: " + folder.path.string() + " cannot be opened for writing: Is a directory");
    CHECK(folder.files() == 0);
    if (fs::exists("/dev/full"))
        CHECK(said("/dev/full") == "save: /dev/full could not be written to the end: No space left on device");
}
