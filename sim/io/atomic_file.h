#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace talus::io {

/// A file that another library writes by its name: it is written beside its place, under a hidden name, and
/// moved there when it is whole (fsync, rename, fsync of the folder). Until then, and where it never is, its
/// place holds what was there. What a program that ended on the way has left of an earlier one goes.
class AtomicFile {
  public:
    /// Makes an empty file beside the path. Throws talus::Error naming the path and the reason.
    explicit AtomicFile(const std::filesystem::path& path);
    /// Removes what was not committed.
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::filesystem::path& temporary() const { return temporary_; }
    /// Moves what was written to its place; nothing may have the file open any more. Throws talus::Error.
    void commit();

  private:
    std::filesystem::path path_;    // as it was given
    std::filesystem::path target_;  // where it leads
    std::filesystem::path temporary_;
    int lock_ = -1;  // a descriptor whose lock says that somebody writes to it
};

/// Writes a whole file so that the path holds either what was there or all of the new content, also across a
/// crash: temporary file beside it, fsync, rename, fsync of the folder. Throws talus::Error naming the path
/// and the reason; nothing is left behind then.
void write_atomically(const std::filesystem::path& path, std::span<const std::byte> content);
void write_atomically(const std::filesystem::path& path, std::string_view content);

/// A whole file as text. Throws talus::Error when it cannot be read.
std::string read_text(const std::filesystem::path& path);

}  // namespace talus::io
