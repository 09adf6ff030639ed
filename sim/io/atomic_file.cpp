#include "sim/io/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "sim/error.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;

std::string reason(int code) {
    return std::generic_category().message(code);
}

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return number_; }
    int close() {
        const int number = number_;
        number_ = -1;
        return ::close(number);
    }

  private:
    int number_;
};

// The permissions of the old file or, if there is none, those that the umask gives a new one.
mode_t mode_for(const fs::path& path) {
    struct stat existing {};
    if (::stat(path.c_str(), &existing) == 0) return existing.st_mode & 0777U;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666U & ~mask;
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

bool write_all(int file, std::span<const std::byte> content) {
    while (!content.empty()) {
        const ssize_t written = ::write(file, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        content = content.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

// Of a file while it is written, but for six letters at the end. Nobody else names files so.
std::string hidden_name(const fs::path& target) {
    return "." + target.filename().string() + ".talus-";
}

// Removes hidden files that nobody writes to any more.
void remove_leftovers(const fs::path& target) {
    const std::string begin = hidden_name(target);
    std::error_code ignored;
    for (const fs::directory_entry& one : fs::directory_iterator(folder_of(target), ignored)) {
        const std::string name = one.path().filename().string();
        if (!name.starts_with(begin) || name.size() != begin.size() + 6) continue;
        const Descriptor file(::open(one.path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
        if (file.get() >= 0 && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(one.path().c_str());
    }
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : path_(path) {
    // Past a size limit the signal would end the program; the write's own error says it better.
    std::signal(SIGXFSZ, SIG_IGN);
    std::error_code ignored;
    target_ = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
    if (fs::is_directory(target_, ignored))
        throw Error(fmt::format("cannot write '{}': it is a folder, give a file's name", path.string()));
    if (fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored))
        throw Error(fmt::format("cannot write '{}': it is no file", path.string()));
    if (fs::exists(target_, ignored) && ::access(target_.c_str(), W_OK) != 0)
        throw Error(fmt::format("cannot write '{}': {}", path.string(), reason(errno)));
    remove_leftovers(target_);
    std::string temporary = (folder_of(target_) / (hidden_name(target_) + "XXXXXX")).string();
    lock_ = ::mkostemp(temporary.data(), O_CLOEXEC);
    if (lock_ < 0) throw Error(fmt::format("cannot write '{}': {}", path.string(), reason(errno)));
    ::flock(lock_, LOCK_EX | LOCK_NB);
    temporary_ = temporary;
}

AtomicFile::~AtomicFile() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    if (lock_ >= 0) ::close(lock_);
}

void AtomicFile::commit() {
    Descriptor file(::open(temporary_.c_str(), O_RDWR | O_CLOEXEC));
    if (file.get() < 0 || ::fchmod(file.get(), mode_for(target_)) != 0 || ::fsync(file.get()) != 0 ||
        file.close() != 0 || ::rename(temporary_.c_str(), target_.c_str()) != 0)
        throw Error(fmt::format("cannot write '{}': {}", path_.string(), reason(errno)));
    temporary_.clear();
    const Descriptor directory(::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY));
    if (directory.get() >= 0) ::fsync(directory.get());
}

void write_atomically(const fs::path& path, std::span<const std::byte> content) {
    std::error_code ignored;
    // A pipe or a device is no file to be replaced: it takes the bytes as they come.
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored) &&
        !fs::is_directory(path, ignored)) {
        const Descriptor sink(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
        if (sink.get() < 0 || !write_all(sink.get(), content))
            throw Error(fmt::format("cannot write '{}': {}", path.string(), reason(errno)));
        return;
    }
    AtomicFile file(path);
    Descriptor written(::open(file.temporary().c_str(), O_WRONLY | O_CLOEXEC));
    if (written.get() < 0 || !write_all(written.get(), content) || written.close() != 0)
        throw Error(fmt::format("cannot write '{}': {}", path.string(), reason(errno)));
    file.commit();
}

void write_atomically(const fs::path& path, std::string_view content) {
    write_atomically(path, std::as_bytes(std::span(content)));
}

std::string read_text(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        throw Error(fmt::format("'{}' is a folder, a file is needed", path.string()));
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error(fmt::format("'{}' cannot be read: {}", path.string(), reason(errno)));
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace talus::io
