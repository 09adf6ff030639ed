#pragma once
#include <sys/types.h>
#include <optional>
#include <string>
#include <vector>

namespace talus::app {

/// What the desktop's dialog is to ask for.
struct FileQuestion {
    std::string title;
    std::string near;                  ///< a file's path, or a folder's with a slash: where it begins
    bool saves = false;                ///< the file need not be there
    std::vector<std::string> endings;  ///< ".tif" and so on, of the files that it lists; empty: all
};

/// The desktop's own dialog for files, by a program that shows one: zenity or kdialog.
class DesktopDialog {
  public:
    /// The program's name; empty: none of them is installed.
    static const std::string& program();

    /// Opens it. Throws talus::Error where that fails.
    explicit DesktopDialog(const FileQuestion& question);
    /// Closes it.
    ~DesktopDialog();
    DesktopDialog(const DesktopDialog&) = delete;
    DesktopDialog& operator=(const DesktopDialog&) = delete;

    /// Whether there is something for answer() to hear.
    bool is_heard() const;
    /// The path that was chosen, empty where none was; nothing while the dialog is open. Does not wait.
    std::optional<std::string> answer();

  private:
    int pipe_ = -1;  // what the program says
    pid_t process_ = -1;
    std::string said_;
};

}  // namespace talus::app
