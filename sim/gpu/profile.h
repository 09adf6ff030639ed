#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace talus::gpu {

/// What the calls of one program took since they were last told: on the processor, which is what handing them
/// over costs where a device works behind our back, and on the device.
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
