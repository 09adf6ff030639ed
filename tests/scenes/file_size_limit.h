#pragma once
#include <sys/resource.h>

namespace talus {

/// While one of these lives, this process writes no file beyond so many bytes: what a full disk looks like.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{bytes, before_.rlim_max};
        is_set_ = ::setrlimit(RLIMIT_FSIZE, &small) == 0;
    }
    ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

    bool is_set() const { return is_set_; }

  private:
    rlimit before_{};
    bool is_set_ = false;
};

}  // namespace talus
