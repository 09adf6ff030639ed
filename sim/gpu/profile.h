#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace talus::gpu {

/// Time of one program's calls since the last take_pass_times(): on the CPU and on the device. With an
/// asynchronous device the CPU time is only the cost of submitting the calls.
struct PassTime {
    std::string name;  ///< path of the shader below shaders/
    int calls = 0;
    double cpu_ms = 0;
    double device_ms = 0;
};

/// Whether every dispatch and draw is timed from now on. Costs two queries each; off unless asked for.
void profile_passes(bool on);

/// The passes whose device times have come since this was last called, in the order of their first call. Does
/// not wait.
std::vector<PassTime> take_pass_times();

/// Times from its beginning to its end as a call of the program, while passes are timed.
class PassSpan {
  public:
    explicit PassSpan(std::string_view name);
    ~PassSpan();
    PassSpan(const PassSpan&) = delete;
    PassSpan& operator=(const PassSpan&) = delete;

  private:
    int span_ = -1;
};

}  // namespace talus::gpu
